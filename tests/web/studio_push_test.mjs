// A push in the studio: its curve while it runs, stop, cracks state by state, the report; numbers of the program.
import assert from "node:assert/strict";
import fs from "node:fs";
import path from "node:path";
import { after, before, test } from "node:test";
import { folder, run } from "./helpers.mjs";
import { kPatience, kWall, launch, openStudio, stonesOf, studioPage, textOf, write } from "./studio.mjs";

let browser, file, page;
before(async () => {
  file = studioPage();
  browser = await launch();
  page = await openStudio(browser, file, { impatient: true });
  await write(page, kWall);
});
after(async () => {
  assert.deepEqual(page.faults, []);
  await browser?.close();
});
// The program's own answer to a text: the folder of its results.
let runs = 0;
function program(text) {
  fs.mkdirSync(folder("studio"), { recursive: true });
  const model = path.join(folder("studio"), `push_${process.pid}_${++runs}.toml`);
  fs.writeFileSync(model, text);
  run("run", model, "--out", `${model}.out`);
  return `${model}.out`;
}
const push = async () => {
  await page.locator(".canvas").focus();
  await page.keyboard.press("p");
  await page.waitForSelector(".primary.running");
  await ended();
};
// The sentence at the head of the program's report, as a browser reads it.
const sentenceOf = (out) => page.evaluate((html) => new DOMParser().parseFromString(html, "text/html").querySelector("#headline .answer").textContent.replace(/\s+/g, " ").trim(), /<header id="headline"[^]*?<\/header>/.exec(fs.readFileSync(path.join(out, "report.html"), "utf8"))[0]);
const said = async () => (await page.locator(".result-words .answer").textContent()).replace(/\s+/g, " ");
const ended = () => page.waitForFunction(() => !document.querySelector(".primary.running"), null, { timeout: kPatience });

test("P pushes; the answer is the program's own", async () => {
  await push();
  const summary = JSON.parse(fs.readFileSync(path.join(program(kWall), "summary.json"), "utf8"));
  const words = await page.locator(".result-words").innerText();
  assert.ok(words.includes(`${Number(summary.peak_reaction_kN.toPrecision(3))}\u202fkN`), words);
  assert.ok(words.includes(summary.failure_mode.name), words);
  assert.equal(await page.locator(".curve .force").count(), 1);
  assert.equal(await page.locator(".curve .peak").count(), 1);
});

test("the slider shows the wall at each state; arrows go along; Escape goes back", async () => {
  const slider = page.getByLabel("State of the push");
  assert.ok(Number(await slider.getAttribute("max")) >= 15);
  const d = () => page.locator(".stones .stone0").getAttribute("d");
  await stonesOf(page);
  const end = await d();
  assert.ok((await page.locator(".stones .crack").count()) > 0);
  // cracks that look alike are one path; the one under the pointer says what it is
  const crack = page.locator(".stones .crack.open").first();
  const [x, y] = /^M([\d.]+) ([\d.]+)/.exec(await crack.getAttribute("d")).slice(1).map(Number);
  const at = await crack.evaluate((e, [x, y]) => {
    const p = new DOMPoint(x, y).matrixTransform(e.getScreenCTM());
    return { clientX: p.x, clientY: p.y };
  }, [x, y]);
  await crack.dispatchEvent("pointermove", at);
  assert.match(await crack.locator("title").textContent(), /: open [\d.]+ mm, slip [\d.]+ mm, damage 1$/);
  await slider.focus();
  await page.keyboard.press("Home");
  await stonesOf(page);
  assert.notEqual(await d(), end);
  assert.equal(await page.locator(".stones .crack").count(), 0);
  await page.locator(".canvas").focus();
  await page.keyboard.press("ArrowRight");
  assert.match(await slider.getAttribute("aria-valuetext"), /^0\.25 mm/);
  await page.keyboard.press("Escape");
  assert.equal(await page.locator(".canvas.cracked").count(), 0);
});

test("the report opens from the page with the same sentence, can be loaded again however late, and has its sheet", async () => {
  await page.evaluate(() => {
    const { setTimeout } = window;
    window.setTimeout = (does, ms, ...rest) => setTimeout(does, ms > 10_000 ? 0 : ms, ...rest); // what is put off for long is done at once
  });
  const [popup] = await Promise.all([page.context().waitForEvent("page"), page.getByRole("button", { name: "Open the report" }).click()]);
  await popup.waitForSelector("html[data-ready]", { timeout: kPatience });
  const answer = (await popup.locator("#headline .answer").innerText()).replace(/\s+/g, " ");
  assert.equal((await page.locator(".result-words .answer").innerText()).replace(/\s+/g, " "), answer);
  await popup.reload();
  await popup.waitForSelector("html[data-ready]", { timeout: kPatience });
  await popup.emulateMedia({ media: "print" }); // on paper it begins with the sheet of A4
  await popup.evaluate(() => window.dispatchEvent(new Event("beforeprint")));
  await popup.locator("#sheet .a4").waitFor();
  await popup.close();
});

test("an edit marks the result as that of the wall before", async () => {
  await page.getByLabel("Thickness").fill("0.5");
  await page.getByLabel("Thickness").press("Enter");
  assert.equal(await page.locator(".push.stale").count(), 1);
  assert.match(await page.locator(".result").innerText(), /The wall has changed since/);
  // the states are of the other outline: they are shown again when the wall is theirs again
  const slider = page.getByLabel("State of the push");
  assert.equal(await slider.isDisabled(), true);
  const { x, y, width, height } = await page.locator(".curve").boundingBox();
  await page.mouse.click(x + width / 2, y + height / 2);
  assert.equal(await page.locator(".canvas.cracked").count(), 0);
  assert.equal(await page.locator(".push.stale").count(), 1);
  await page.locator(".canvas").focus();
  await page.keyboard.press("Control+z");
  assert.equal(await page.locator(".push.stale").count(), 0);
  assert.equal(await textOf(page), kWall);
  assert.equal(await slider.isDisabled(), false);
  await page.mouse.click(x + width / 2, y + height / 2);
  await page.waitForSelector(".canvas.cracked");
  await page.locator(".canvas").focus();
  await page.keyboard.press("Escape");
});

test("a push is stopped at once, and the next one runs", async () => {
  await page.getByLabel("As far as").fill("400 mm");
  await page.getByLabel("As far as").press("Enter");
  await stonesOf(page);
  await page.getByRole("button", { name: "Push", exact: true }).click();
  await page.waitForFunction(() => /kN/.test(document.querySelector(".result-words .live")?.textContent ?? ""), null, { timeout: kPatience });
  await page.getByRole("button", { name: "Stop", exact: true }).click();
  assert.match(await page.locator(".result-words").innerText(), /Stopped/);
  await page.locator(".canvas").focus();
  await page.keyboard.press("Control+z");
  await stonesOf(page);
  await page.keyboard.press("p");
  await page.waitForSelector(".primary.running");
  await ended();
  assert.match(await page.locator(".result-words").innerText(), /kN/);
});

test("another language asks before a push that is not kept is lost; who stays has the language and the push as they were", async () => {
  const other = await openStudio(browser, file, { impatient: true });
  const languages = other.locator(".language"),
    keep = other.locator('[data-action="keep"]');
  const choose = async (language, does) => {
    const asked = does && new Promise((done) => other.once("dialog", (dialog) => (done(dialog.message()), dialog[does]())));
    await languages.selectOption(language);
    return asked;
  };
  await write(other, kWall);
  await other.getByRole("button", { name: "Push", exact: true }).click();
  await keep.waitFor();
  await other.waitForFunction(() => !document.querySelector(".primary.running"), null, { timeout: kPatience });
  assert.match(await choose("de", "dismiss"), /^Another language loads the page again\. This would be lost: what the pushes found/);
  assert.equal(await languages.inputValue(), "en");
  assert.match(await other.locator(".result-words").innerText(), /kN/);
  await other.reload();
  await other.waitForSelector('html[data-ready][lang="en"]');
  await other.getByRole("button", { name: "Push", exact: true }).click();
  await keep.waitFor();
  await other.waitForFunction(() => !document.querySelector(".primary.running"), null, { timeout: kPatience });
  await keep.click();
  await choose("de"); // without a question
  await other.waitForSelector('html[data-ready][lang="de"]');
  assert.equal(await keep.getAttribute("aria-pressed"), "true");
  await other.getByRole("button", { name: "Schieben", exact: true }).click();
  await other.locator(".compare").waitFor({ state: "attached" });
  await other.waitForFunction(() => !document.querySelector(".primary.running"), null, { timeout: kPatience });
  assert.match(await choose("fr", "accept"), /^Eine andere Sprache lädt die Seite neu/);
  await other.waitForSelector('html[data-ready][lang="fr"]');
  assert.deepEqual(other.faults, []);
  await other.end();
});

test("no other language while a push runs; then one takes along the steps back and forth and the push that is kept", async () => {
  const other = await openStudio(browser, file, { impatient: true });
  const ended = () => other.waitForFunction(() => !document.querySelector(".primary.running"), null, { timeout: kPatience });
  const push = async () => {
    await other.getByRole("button", { name: "Push", exact: true }).click();
    await other.waitForSelector(".primary.running");
  };
  await write(other, kWall);
  await push();
  await ended();
  await other.locator('[data-action="keep"]').click();
  const far = kWall.replace('"4 mm"', '"400 mm"');
  await write(other, far);
  await write(other, `${far}# more\n`);
  await push();
  const languages = other.locator(".language");
  assert.equal(await languages.isDisabled(), true);
  assert.match(await languages.getAttribute("title"), /the push would be lost/);
  await other.getByRole("button", { name: "Stop", exact: true }).click();
  await ended();
  assert.equal(await languages.isDisabled(), false);
  assert.equal(await languages.getAttribute("title"), "");
  await other.locator(".canvas").focus();
  await other.keyboard.press("Control+z");
  await languages.selectOption("it");
  await other.waitForSelector('html[data-ready][lang="it"]');
  assert.equal(await textOf(other), far);
  assert.equal(await other.locator('[data-action="keep"]').getAttribute("aria-pressed"), "true");
  await other.locator(".canvas").focus();
  await other.keyboard.press("Control+y");
  assert.equal(await textOf(other), `${far}# more\n`);
  await other.keyboard.press("Control+z");
  await other.keyboard.press("Control+z");
  assert.equal(await textOf(other), kWall);
  await other.reload(); // steps are taken along once
  await other.waitForSelector("html[data-ready]");
  await other.locator(".canvas").focus();
  await other.keyboard.press("Control+y");
  assert.equal(await textOf(other), kWall);
  assert.deepEqual(other.faults, []);
  await other.end();
});

test("where the engine fails on a text, the stones look outdated and nothing is pushed, until it takes one", async () => {
  for (const code of [5, 6]) {
    await page.evaluate((code) => {
      const real = (window.realPost = Worker.prototype.postMessage);
      Worker.prototype.postMessage = function (question) {
        if (question.task !== "check") return real.call(this, question);
        queueMicrotask(() => this.onmessage({ data: { id: question.id, code, texts: { error: "no memory is left" } } }));
      };
    }, code);
    await write(page, `${kWall}# ${code}\n`);
    assert.match(await page.locator(".status").innerText(), /The engine ended: no memory is left/);
    assert.equal(await page.locator(".canvas.outdated").count(), 1, "the stones of the text before look like those of this one");
    assert.equal(await page.locator(".primary").isDisabled(), true);
    await page.locator(".canvas").focus();
    await page.keyboard.press("p");
    assert.equal(await page.locator(".primary.running").count(), 0);
    await page.evaluate(() => (Worker.prototype.postMessage = window.realPost));
    await write(page, kWall);
    assert.equal(await page.locator(".canvas.outdated").count(), 0);
    assert.equal(await page.locator(".primary").isDisabled(), false);
  }
});

test("the browser's own errors have a sentence of the page's language, with the browser's words after it", async () => {
  const other = await openStudio(browser, file, { impatient: true, limit: true, locale: "de-DE" });
  await other.addInitScript(() => {
    window.Worker = class {
      postMessage(question) {
        const say = (data) => this.onmessage({ data });
        const { when, error } = JSON.parse(sessionStorage.failing);
        if ("wasm" in question && when !== "start") return queueMicrotask(() => say({ ready: true }));
        if (when === "caught") return queueMicrotask(() => say({ id: question.id, code: 6, thrown: true, texts: { error } }));
        queueMicrotask(() => this.onerror({ message: error, preventDefault() {} }));
      }
      terminate() {}
    };
  });
  const sentences = {
    memory: "dieser Browser hat keinen Speicher mehr dafür: andere Seiten schließen oder weniger Steine zeichnen",
    start: "dieser Browser konnte es nicht starten: die Seite neu laden oder in einem anderen Browser öffnen",
    stop: "dieser Browser hielt es an: erneut versuchen oder die Seite neu laden",
  };
  for (const [when, error, sentence] of [
    ["caught", "RangeError: Array buffer allocation failed", "memory"],
    ["caught", "RuntimeError: memory access out of bounds", "stop"],
    ["work", "Uncaught RuntimeError: unreachable", "stop"],
    ["start", "Uncaught CompileError: no SIMD", "start"],
    ["start", "Uncaught RangeError: WebAssembly.instantiate(): Out of memory", "memory"],
    ["start", "", "start"],
  ]) {
    await other.evaluate((failing) => (sessionStorage.failing = JSON.stringify(failing)), { when, error });
    await other.reload();
    await other.waitForSelector("html[data-ready]");
    await stonesOf(other);
    const words = `${sentences[sentence]}${error && ` (${error})`}`;
    assert.equal(await other.locator(".status").innerText(), `Das Rechenprogramm brach ab: ${words}`);
    await other.waitForFunction(() => !document.documentElement.dataset.limiting);
    assert.equal(await other.locator(".limit-words").innerText(), `das Traglastverfahren hat für diese Wand keine Antwort: ${words}`);
  }
  await other.end();
});

test("notes belong to the file as it is: a file that is refused, or on which the engine fails, has none", async () => {
  const notes = page.locator(".notes");
  for (const refused of ['[wall]\nlength = "3 m"\n', `${kWall}# 6\n`]) {
    await write(page, kWall);
    assert.ok(await notes.isVisible());
    await page.evaluate(() => {
      const real = (window.realPost = Worker.prototype.postMessage);
      Worker.prototype.postMessage = function (question) {
        if (!/# 6/.test(question.texts?.model)) return real.call(this, question);
        queueMicrotask(() => this.onmessage({ data: { id: question.id, code: 6, texts: { error: "a defect" } } }));
      };
    });
    await write(page, refused);
    assert.equal(await notes.isVisible(), false, refused);
    await page.evaluate(() => (Worker.prototype.postMessage = window.realPost));
  }
  await write(page, kWall);
});

test("a wall that cannot stand is pushed: the page tells it and why in the program's words, and draws no curve", async () => {
  const overloaded = kWall.replace('name = "floor"\npressure = "0.1 MPa"', 'name = "floor"\npressure = "40 MPa"');
  await write(page, overloaded);
  await push();
  const out = program(overloaded);
  assert.equal(await said(), await sentenceOf(out));
  const { reason } = JSON.parse(fs.readFileSync(path.join(out, "summary.json"), "utf8"));
  assert.match(reason, /^the wall can't carry its load: .*; lower the load/);
  assert.equal(await page.locator(".result-words .ended").innerText(), `T${reason.slice(1)}.`);
  assert.equal(await page.locator(".curve .peak").count(), 0);
  await write(page, kWall);
});

test("the verdict of the palazzina, pushed to 0.5 mm, is the program's sentence", async () => {
  await page.locator(".starters").selectOption("palazzina");
  const short = (await textOf(page)).replace('until = "30 mm"', 'until = "0.5 mm"');
  await write(page, short);
  await push();
  assert.equal(await said(), await sentenceOf(program(short)));
  assert.match(await said(), /the assessment has no answer: the force still rises where the push ends, at 0\.5 mm/);
});

test("the wall that was kept stands beside this one at the end of its push, at one scale; on a phone above it", async () => {
  const keep = page.locator('[data-action="keep"]');
  await write(page, kWall);
  await push();
  await keep.click();
  await write(page, kWall.replace('length = "2.4 m"', 'length = "4.8 m"'));
  await push();
  await page.locator(".pair figure").nth(1).waitFor();
  const shown = () =>
    page.locator(".pair figure").evaluateAll((figures) =>
      figures.map((figure) => {
        const boxes = [...figure.querySelectorAll(".stone0, .stone1, .stone2, .stone3")].map((e) => e.getBoundingClientRect());
        const left = Math.min(...boxes.map((b) => b.left)),
          bottom = Math.max(...boxes.map((b) => b.bottom));
        const frame = figure.getBoundingClientRect();
        return { wide: Math.max(...boxes.map((b) => b.right)) - left, left, bottom, top: frame.top, right: frame.right, end: frame.bottom };
      }),
    );
  const isOneScale = ([before, now]) => assert.ok(Math.abs(now.wide / before.wide - 2) < 0.02, `${before.wide} and ${now.wide} px of 2.4 m and 4.8 m`);
  const [before, now] = await shown();
  isOneScale([before, now]);
  assert.ok(Math.abs(before.bottom - now.bottom) < 1 && before.right <= now.left, "not side by side on one ground");
  assert.match((await page.locator(".pair figcaption").first().innerText()).replace(/\s/g, " "), /^before · 4 mm · [\d.]+ kN$/);
  for (const k of [0, 1]) assert.ok((await page.locator(".pair figure").nth(k).locator(".crack").count()) > 0, `picture ${k} has no cracks`);
  await page.setViewportSize({ width: 390, height: 844 });
  const [above, below] = await shown();
  isOneScale([above, below]);
  assert.ok(above.end <= below.top, "not one below the other");
  assert.ok(below.wide > 300, `4.8 m are ${below.wide} px wide on a phone of 390 px`);
  await page.setViewportSize({ width: 1440, height: 900 });
  await keep.click();
  assert.equal(await page.locator(".pair").count(), 0);
});
