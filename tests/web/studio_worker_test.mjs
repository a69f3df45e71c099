// The worker of a page (apps/wasm/worker.js) whose engine fails, and the limit load that a page shows of an answer.
import assert from "node:assert/strict";
import fs from "node:fs";
import path from "node:path";
import { before, test } from "node:test";
import vm from "node:vm";
import { deflateRawSync } from "node:zlib";
import { root, viewerModule } from "./helpers.mjs";
import { standInForPage } from "./studio.mjs";

const script = fs.readFileSync(path.join(root, "apps/wasm/worker.js"), "utf8");
// What a worker throws that is given this engine.
function thrownWith(wytheEngine) {
  let threw;
  const thrown = new Promise((done) => (threw = done));
  class Module {}
  const context = vm.createContext({
    wytheEngine,
    setTimeout: (does) => setTimeout(() => { try { does(); } catch (error) { threw(error); } }),
    WebAssembly: { Module, instantiate: () => Promise.reject(new Error("no memory for it")) },
  });
  vm.runInContext(script, context);
  void context.onmessage({ data: { wasm: new Module() } });
  return thrown;
}

test("a worker loads its script while the page unpacks and compiles the code, once for all workers", async () => {
  const { WorkerEngine } = await viewerModule("studio/push/engine");
  const packed = deflateRawSync(Uint8Array.from([0, 97, 115, 109, 1, 0, 0, 0])).toString("base64"); // the smallest module
  globalThis.document = { ...globalThis.document, getElementById: (id) => ({ textContent: id === "wythe-worker" ? "/* answered here */" : packed }) };
  const made = [], had = [];
  globalThis.Worker = class {
    constructor() {
      made.push(this);
    }
    postMessage(question) {
      if ("wasm" in question) had.push(question.wasm);
      setTimeout(() => this.onmessage({ data: "wasm" in question ? { ready: true } : { id: question.id, code: 0 } }));
    }
  };
  const first = new WorkerEngine();
  first.warm();
  assert.deepEqual([made.length, had.length], [1, 0]);
  await Promise.all([first, new WorkerEngine()].map((engine) => engine.ask({ task: "check", texts: {} })));
  assert.equal(made.length, 2);
  assert.ok(had[0] instanceof WebAssembly.Module);
  assert.equal(had[0], had[1]);
});

test("an engine that cannot be made is an error of the worker, so that the page hears of it", async () => {
  const made = ({ instantiateWasm }) => new Promise((done) => instantiateWasm({}, done));
  assert.match(String(await thrownWith(made)), /no memory for it/);
});

// The engine's calls on a job whose text "svg" cannot be made, and that has no text "none".
function engineWithout(why) {
  const texts = [""], given = { counts: "{}", error: "" };
  const keep = (text) => texts.push(text) - 1;
  return {
    asked: [],
    _malloc: () => keep(""),
    _free() {},
    lengthBytesUTF8: (text) => text.length,
    stringToUTF8: (text, at) => void (texts[at] = text),
    UTF8ToString: (at) => texts[at],
    _wythe_new: () => 1,
    _wythe_free() {},
    _wythe_set_text() {},
    _wythe_do_here: () => 0,
    _wythe_text(_, name) {
      const asked = texts[name];
      if (asked !== "error") given.error = asked === "svg" ? why : "";
      this.asked.push(asked);
      return asked in given ? keep(given[asked]) : 0;
    },
  };
}

test("a text that cannot be made has the answer's code and its reason; one that there is not has none", async () => {
  const { doTask } = await import(path.join(root, "apps/wasm/job.mjs"));
  const answer = (why, ...names) => {
    const { code, texts } = doTask(engineWithout(why), "check", {}, { texts: names });
    return [code, texts.error, texts.counts];
  };
  assert.deepEqual(answer("there is not enough memory", "counts", "svg"), [5, "there is not enough memory", "{}"]);
  assert.deepEqual(answer("a defect of wythe: no", "svg", "counts"), [6, "a defect of wythe: no", "{}"]);
  assert.deepEqual(answer("", "none", "counts"), [0, "", "{}"]);
});

test("a first text that cannot be made ends the question", async () => {
  const posted = [];
  const context = vm.createContext({ performance, postMessage: (message) => posted.push(message), setTimeout, WebAssembly: { Module: class {}, instantiate() {} } });
  const job = fs.readFileSync(path.join(root, "apps/wasm/job.mjs"), "utf8").replace(/^export /gm, "");
  vm.runInContext(`${job}\n${script}`, context);
  vm.runInContext("globalThis.give = (made) => { engine = made; }", context);
  for (const [why, first, codes] of [["there is not enough memory", ["counts", "svg"], [5]], ["there is not enough memory", ["counts"], [undefined, 5]]]) {
    posted.length = 0;
    context.give(engineWithout(why));
    await context.onmessage({ data: { id: 3, task: "check", texts: {}, first, want: ["svg"] } });
    assert.deepEqual(posted.map(({ code }) => code), codes);
    assert.equal(posted.at(-1).texts.error, why);
  }
});

test("after a defect or without memory the next question has a worker of its own; no other answer ends one", async () => {
  const { WorkerEngine } = await viewerModule("studio/push/engine");
  const getElementById = (id) => ({ textContent: id === "wythe-worker" ? "/* answered here */" : "" });
  globalThis.document = { ...globalThis.document, getElementById };
  const made = [];
  globalThis.Worker = class {
    constructor() {
      made.push(this);
    }
    postMessage(question) {
      const data = "wasm" in question ? { ready: true } : { id: question.id, code: Number(question.texts.code) };
      setTimeout(() => this.onmessage({ data }));
    }
    terminate() {
      this.isEnded = true;
    }
  };
  const engine = new WorkerEngine();
  const codes = [];
  for (const code of ["0", "2", "6", "5", "0"]) codes.push((await engine.ask({ task: "check", texts: { code } })).code);
  assert.deepEqual(codes, [0, 2, 6, 5, 0]);
  assert.deepEqual(made.map((worker) => worker.isEnded === true), [true, true, false]);
});

test("a worker that still starts is kept for the newest question, so that quick edits leave no heap of starting ones", async () => {
  const { WorkerEngine } = await viewerModule("studio/push/engine");
  const getElementById = (id) => ({ textContent: id === "wythe-worker" ? "/* answered here */" : "" });
  globalThis.document = { ...globalThis.document, getElementById };
  const made = [], asked = [];
  let isMade, isAsked;
  const first = new Promise((done) => (isMade = done));
  globalThis.Worker = class {
    constructor() {
      made.push(this);
      isMade();
    }
    postMessage(question) {
      if ("wasm" in question) return;
      asked.push(question.texts.of);
      isAsked?.();
      if (question.texts.of === "third") queueMicrotask(() => this.onmessage({ data: { id: question.id, code: 0 } }));
    }
    terminate() {
      this.isEnded = true;
    }
  };
  const engine = new WorkerEngine();
  const answers = ["first", "second"].map((of) => engine.ask({ task: "check", texts: { of } }));
  engine.stop();
  answers.push(engine.ask({ task: "check", texts: { of: "third" } }));
  await first;
  made[0].onmessage({ data: { ready: true } });
  assert.deepEqual((await Promise.all(answers)).map(({ code }) => code), [3, 3, 0]);
  assert.deepEqual(asked, ["third"]);
  assert.equal(made.length, 1);
  const late = engine.ask({ task: "check", texts: { of: "fourth" } });
  await new Promise((done) => (isAsked = done));
  engine.stop(); // this one is at work
  assert.equal((await late).code, 3);
  assert.equal(made[0].isEnded, true);
});

test("a worker that cannot start is ended and its address let go, and the next question has another", async () => {
  const { WorkerEngine } = await viewerModule("studio/push/engine");
  const { createObjectURL, revokeObjectURL } = URL;
  const addresses = new Set();
  URL.createObjectURL = (blob) => {
    const url = createObjectURL(blob);
    addresses.add(url);
    return url;
  };
  URL.revokeObjectURL = (url) => (addresses.delete(url), revokeObjectURL(url));
  globalThis.document = { ...globalThis.document, getElementById: (id) => ({ textContent: id === "wythe-worker" ? "/* answered here */" : "" }) };
  const refuse = () => {
    throw new Error("no worker for you");
  };
  const failing = {
    "no worker is made": refuse,
    "its script fails": (worker) => setTimeout(() => worker.onerror({ message: "no worker for you", preventDefault() {} })),
    "it does not take the code": (worker) => (worker.postMessage = refuse),
  };
  try {
    for (const [how, fails] of Object.entries(failing)) {
      const made = [];
      globalThis.Worker = class {
        constructor() {
          if (made.push(this) === 1) fails(this);
        }
        postMessage({ wasm, id }) {
          if (made[0] !== this) setTimeout(() => this.onmessage({ data: wasm ? { ready: true } : { id, code: 0 } }));
        }
        terminate() {
          this.isEnded = true;
        }
      };
      const engine = new WorkerEngine();
      const { code, browser, texts } = await engine.ask({ task: "check", texts: {} });
      assert.deepEqual([code, browser, texts.error], [6, "start", "no worker for you"], how);
      assert.equal((await engine.ask({ task: "check", texts: {} })).code, 0, how);
      assert.deepEqual(made.map((worker) => worker.isEnded === true), [how !== "no worker is made", false], how);
      assert.deepEqual([...addresses], [], how);
    }
  } finally {
    Object.assign(URL, { createObjectURL, revokeObjectURL });
  }
});

test("a late error of a worker that was given up ends no other question", async () => {
  const { WorkerEngine } = await viewerModule("studio/push/engine");
  globalThis.document = { ...globalThis.document, getElementById: (id) => ({ textContent: id === "wythe-worker" ? "/* answered here */" : "" }) };
  const made = [];
  globalThis.Worker = class {
    constructor() {
      made.push(this);
    }
    postMessage(question) {
      if ("wasm" in question) setTimeout(() => this.onmessage({ data: { ready: true } }));
      else this.asked = question;
    }
    terminate() {}
  };
  const engine = new WorkerEngine();
  const ask = () => {
    let answer;
    const isAsked = new Promise((begun) => (answer = engine.ask({ task: "check", texts: {} }, undefined, begun)));
    return isAsked.then(() => [answer]);
  };
  const [first] = await ask();
  const [second] = await ask();
  assert.equal((await first).code, 3);
  made[0].onerror({ message: "too late", preventDefault() {} });
  made[1].onmessage({ data: { id: made[1].asked.id, code: 0 } });
  assert.equal((await second).code, 0);
});

test("a question that takes long is ended by a newer one, and only the newest of those is asked", async () => {
  const { Latest } = await viewerModule("studio/push/engine");
  const asked = [];
  let stop;
  const engine = { stop: () => stop(), ask: (question) => (asked.push(question), question === "long" ? new Promise((done) => (stop = () => done({ code: 3 }))) : Promise.resolve({ code: 0 })) };
  const latest = new Latest(engine, 0);
  const answered = await new Promise((done) => {
    for (const question of ["long", "overtaken", "newest"]) latest.ask(question, () => done(question));
  });
  assert.equal(answered, "newest");
  assert.deepEqual(asked, ["long", "newest"]);
  stop = () => assert.fail("nothing is under way");
  await new Promise((done) => latest.ask("short", done));
  await new Promise((done) => setTimeout(done));
});

let LiveLimit;
before(async () => {
  standInForPage();
  globalThis.DOMParser = class {
    parseFromString = () => ({ documentElement: { localName: "html" } }); // no picture
  };
  ({ LiveLimit } = await viewerModule("studio/push/limit"));
});
const shown = async (code, texts) => {
  const limit = new LiveLimit({ stop() {}, ask: async () => ({ code, texts, tables: {} }) });
  limit.ask("");
  await new Promise((done) => setTimeout(done));
  return limit.root.text;
};

test("the limit load is that of dry joints, and a refusal is shown with its reason", async () => {
  const loads = [{ name: "bonded", static_kN: 99 }, { name: "dry", static_kN: 12 }];
  assert.match(await shown(0, { mechanisms: JSON.stringify({ limit_loads: loads }) }), /12 kN/);
  const refused = { limit_loads: loads.slice(0, 1), refused: [{ what: "dry", why: "it cannot stand" }] };
  const words = await shown(0, { mechanisms: JSON.stringify(refused) });
  assert.match(words, /has no answer for this wall:\s+it cannot stand/);
  assert.doesNotMatch(words, /99/);
  assert.match(await shown(2, { faults: JSON.stringify([{ problem: "the load can grow without end" }]) }), /:\s+the load can grow without end/);
  assert.match(await shown(2, { faults: JSON.stringify([{ path: "wall.unit.length", value: "4 mn", problem: "the unit mn is not known" }]) }), /:\s+wall\.unit\.length = 4 mn\s+the unit mn is not known/);
  assert.match(await shown(0, { mechanisms: JSON.stringify({ refused: [{ what: "dry", why: "layer = west: detaches and breaks, and limit analysis knows no layers; leave it out" }] }) }), /:\s+layer = west\s+detaches and breaks, and limit analysis knows no layers\s*$/);
});

test("a limit load is told before its picture is made, and its time is over then", async () => {
  let tell, done;
  const limit = new LiveLimit({ stop() {}, ask: (question, progress) => ((tell = progress), assert.deepEqual(question.first, ["mechanisms"]), new Promise((end) => (done = end))) });
  const mechanisms = JSON.stringify({ limit_loads: [{ name: "dry", static_kN: 12 }] });
  limit.ask("first");
  const older = tell;
  limit.ask("");
  older({ texts: { mechanisms: mechanisms.replace("12", "99") } });
  assert.doesNotMatch(limit.root.text, /99/);
  tell({ texts: { mechanisms } });
  assert.match(limit.root.text, /12 kN/);
  assert.equal(document.documentElement.dataset.limiting, "yes");
  done({ code: 0, texts: { mechanisms }, tables: {} });
  await new Promise((end) => setTimeout(end));
  assert.match(limit.root.text, /12 kN/);
  assert.equal(document.documentElement.dataset.limiting, undefined);
});

test("a limit load that is known stays where its picture fails, and the page says why there is none", async () => {
  const mechanisms = JSON.stringify({ limit_loads: [{ name: "dry", static_kN: 12 }] });
  for (const [answer, why] of [
    [{ code: 6, texts: { error: "out of memory" }, browser: "memory" }, /12 kN.*picture of how the wall gives way is missing: this browser has no memory left/],
    [{ code: 4, texts: { error: "the disk is full" } }, /12 kN.*picture of how the wall gives way is missing: the disk is full/],
    [{ code: 0, texts: { mechanisms, "dry svg": "<svg" } }, /12 kN.*picture of how the wall gives way is missing\s*$/],
    [{ code: 0, texts: { mechanisms } }, /12 kN.*exact to 0\.01 %\s*$/],
  ]) {
    const limit = new LiveLimit({ stop() {}, ask: async (question, progress) => (progress({ texts: { mechanisms } }), { tables: {}, ...answer }) });
    limit.ask("");
    await new Promise((end) => setTimeout(end));
    assert.match(limit.root.text, why);
    assert.equal(document.documentElement.dataset.limiting, undefined);
  }
});

test("a limit load is told once: its weight and its picture, which come later, only add to it", async () => {
  const told = []; // what a screen reader says of a part of the page that changes
  const { replaceChildren, append } = Node.prototype;
  Node.prototype.replaceChildren = function (...all) {
    replaceChildren.apply(this, all);
    told.push(this.text);
  };
  Node.prototype.append = function (...all) {
    append.apply(this, all);
    if (all.length > 0) told.push(all.map((one) => one.text ?? one).join(" "));
  };
  try {
    const mechanisms = JSON.stringify({ limit_loads: [{ name: "dry", static_kN: 12 }] });
    let done;
    const limit = new LiveLimit({ stop() {}, ask: (question, progress) => (progress({ texts: { mechanisms } }), new Promise((end) => (done = end))) });
    limit.ask("");
    limit.weighs(48);
    done({ code: 0, texts: { mechanisms, "dry svg": "no picture" }, tables: {} });
    await new Promise((end) => setTimeout(end));
    assert.match(limit.root.text, /12 kN\s+= 25 % of its weight.*is missing/);
    assert.equal(told.filter((words) => /12 kN .*limit analysis/.test(words)).length, 1, told.join("\n"));
  } finally {
    Object.assign(Node.prototype, { replaceChildren, append });
  }
});

test("a limit load has its time from when the worker is ready, and one that was late is asked again after the next edit", async () => {
  const { kPatience } = await viewerModule("studio/push/limit");
  const { WorkerEngine } = await viewerModule("studio/push/engine");
  globalThis.document.getElementById = (id) => ({ textContent: id === "wythe-worker" ? "/* answered here */" : "" });
  const made = [],
    waiting = [], // for the next worker
    late = new Map(); // what is to be done when its time is over
  globalThis.Worker = class {
    asked = 0;
    constructor() {
      made.push(this);
      for (const hear of waiting.splice(0)) hear();
    }
    postMessage(question) {
      if (!("wasm" in question)) ++this.asked;
    }
    terminate() {}
  };
  const madeAnother = () => new Promise((done) => waiting.push(done));
  const settled = () => new Promise((done) => setImmediate(done));
  const { setTimeout: realSet, clearTimeout: realClear } = globalThis;
  let timers = 1e9;
  globalThis.setTimeout = (does, ms, ...rest) => (ms === kPatience ? (late.set(++timers, does), timers) : realSet(does, ms, ...rest));
  globalThis.clearTimeout = (timer) => late.delete(timer) || realClear(timer);
  try {
    const limit = new LiveLimit(new WorkerEngine());
    let started = madeAnother();
    limit.ask("first");
    await started;
    await settled();
    assert.equal(late.size, 0, "its time runs while the worker starts");
    made[0].onmessage({ data: { ready: true } });
    await settled();
    assert.equal(made[0].asked, 1);
    assert.equal(late.size, 1);
    for (const does of late.values()) does();
    assert.match(limit.root.text, /not within 3 s/);
    started = madeAnother();
    limit.ask("second");
    await started;
    made[1].onmessage({ data: { ready: true } });
    await settled();
    assert.equal(made[1].asked, 1);
    assert.equal(late.size, 1, "only the newest question has a time");
  } finally {
    Object.assign(globalThis, { setTimeout: realSet, clearTimeout: realClear });
  }
});

test("a picture of 5000 stones is read in slices of equal length, nothing of it is lost, and one that nobody wants is left", async () => {
  const { kSlice, readPicture } = await viewerModule("studio/board/picture");
  const stone = (k) => `M${k}.0 10.0L${k + 1}.0 10.0L${k + 1}.0 20.0L${k}.0 20.0Z`;
  const stones = Array.from({ length: 5000 }, (_, k) => stone(k)).join("");
  const cracks = Array.from({ length: 8000 }, (_, k) => `<line class="crack open" stroke-width="1.1" opacity="1.00" x1="${k}.0" y1="10.0" x2="${k}.0" y2="20.0"><title>bed: open 0.1 mm</title></line>\n`);
  const text = `<svg viewBox="0 0 732 452"><path class="stone0" d="${stones}"/>${cracks.join("")}<path class="rest" d="M46 406L46 46L686 46L686 406"/></svg>`;
  let drawn = "";
  const slices = [];
  Node.prototype.setAttribute = (name, value) => name === "d" && (drawn += value);
  const picture = await readPicture(text, 8, undefined, async () => {
    slices.push(drawn);
    drawn = "";
  });
  slices.push(drawn);
  Node.prototype.setAttribute = () => undefined;
  assert.ok(slices.length >= text.length / kSlice, `${slices.length} slices of ${text.length} characters`);
  assert.ok(slices.every((slice) => slice.length < 2 * kSlice), slices.map((slice) => slice.length).join());
  assert.equal(slices.join(""), stones + Array.from({ length: 8000 }, (_, k) => `M${k}.0 10.0L${k}.0 20.0`).join(""));
  assert.equal(picture.metre, 80);
  let pauses = 0;
  assert.equal(await readPicture(text, 8, () => false, async () => void ++pauses), null);
  assert.equal(pauses, 1);
});
