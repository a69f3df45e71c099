// The engine as WebAssembly (build/wasm/package): bits equal to the native program, and errors.
import assert from "node:assert/strict";
import { spawnSync } from "node:child_process";
import fs from "node:fs";
import path from "node:path";
import { test } from "node:test";
import { folder, root, run } from "./helpers.mjs";

const made = path.join(root, "build/wasm/package");
const skip = fs.existsSync(path.join(made, "wythe.wasm")) ? false : "build/wasm is not built: make wasm";
const inFolder = (name) => {
  fs.rmSync(folder(name), { recursive: true, force: true });
  fs.mkdirSync(folder(name), { recursive: true });
  return folder(name);
};
const command = (...words) =>
  spawnSync(process.execPath, [path.join(made, "wythe.mjs"), ...words], { encoding: "utf8" });

// One of each kind that builds otherwise: plane, lintels, cracks, scatter, fields, layers, space, arches, dry stone. Pushes end within seconds.
const WALLS = [
  ["tuff_wall", "stage.push.until=1 mm"],
  ["brick_pier", "stage.push.until=0.4 mm", "scatter.use=clay_brick"],
  ["random_field", "stage.push.until=0.2 mm"],
  ["strengthening/after", "stage.push.until=0.1 mm"],
  ["wall_with_returns", "stage.force.factor=0.01"],
  ["arch", "stage.push.until=0.1 mm"], // masonry cut to it
];

for (const [name, ...settings] of WALLS)
  test(`${name} ends in the state of the native program`, { skip }, () => {
    const where = path.join(root, "examples", name);
    const model = fs.existsSync(`${where}.toml`) ? `${where}.toml` : path.join(where, "model.toml");
    const set = settings.flatMap((s) => ["--set", s]);
    const out = inFolder(`engine_${name.replace("/", "_")}`);
    spawnSync(process.env.WYTHE ?? path.join(root, "build/release/wythe"), ["run", model, "--out", `${out}/native`, "--quiet", ...set]);
    const done = command("run", model, "--out", `${out}/wasm`, "--quiet", ...set);
    const [native, wasm] = ["native", "wasm"].map((kind) => JSON.parse(fs.readFileSync(`${out}/${kind}/summary.json`, "utf8")));
    assert.equal(wasm.state_hash, native.state_hash, done.stderr);
    assert.equal(wasm.steps, native.steps);
    assert.equal(
      fs.readFileSync(`${out}/wasm/force_displacement.csv`, "utf8"),
      fs.readFileSync(`${out}/native/force_displacement.csv`, "utf8"),
    );
  });

test("a run in pieces is the run in one go, and shows the wall on its way", { skip }, async () => {
  const { load } = await import(path.join(made, "index.mjs"));
  const wythe = await load();
  const texts = { model: fs.readFileSync(path.join(root, "examples/brick_pier/model.toml"), "utf8"), set: ["stage.push.until=0.1 mm", "output.states=['0.02 mm', '0.05 mm']"] };
  const whole = wythe.do("run", { texts, numbers: { frames: 10 } }, { texts: ["*"], tables: ["curve"] });
  const job = wythe.open("run", { texts, numbers: { frames: 10, goes_on: 1 } });
  const pictures = new Set();
  let heard = 0;
  // at every other news: a run tells of each stage when it begins, and of more than these only where the machine is slow
  while (job.do(() => ++heard % 2 === 0) === 3) pictures.add(job.answers({ texts: ["svg"] }).texts.svg);
  const pieces = job.answers({ texts: ["*"], tables: ["curve"] });
  job.free();
  assert.ok(pictures.size > 0 && [...pictures].every((p) => p.includes("<svg")), `${pictures.size} pictures`);
  assert.deepEqual(pieces.tables, whole.tables);
  const told = ({ summary, page, ...rest }) => ({ ...rest, summary: { ...JSON.parse(summary), wall_seconds: 0 } });
  assert.deepEqual(told(pieces.texts), told(whole.texts));
});

test("faults are those of the native program, with the path of the machine", { skip }, () => {
  const out = inFolder("engine_faults");
  const model = path.join(out, "model.toml");
  fs.writeFileSync(
    model,
    fs.readFileSync(path.join(root, "examples/brick_pier/model.toml"), "utf8").replace(/^thickness = .*$/m, 'thickness = "12 parsnips"'),
  );
  const native = spawnSync(path.join(root, "build/release/wythe"), ["check", model], { encoding: "utf8" });
  const wasm = command("check", model);
  assert.equal(wasm.status, 2);
  assert.ok(native.stderr.includes(wasm.stderr.trim().split("\n")[0]), `${wasm.stderr}\n${native.stderr}`);
  assert.ok(wasm.stderr.includes(model), wasm.stderr);
});

test("results of another model are refused, and a run leaves none of the run before", { skip }, () => {
  const out = path.join(inFolder("engine_replace"), "run");
  const pier = path.join(root, "examples/brick_pier/model.toml");
  const states = () => fs.readdirSync(out).filter((name) => /^state_blocks/.test(name)).length;
  const push = (model, ...more) => command("run", model, "--out", out, "--quiet", "--set", "stage.push.until=0.02 mm", ...more);
  assert.equal(push(pier, "--set", "output.states=['0.005 mm', '0.01 mm', '0.015 mm']").status, 0);
  const before = states();
  const other = push(path.join(root, "examples/tuff_wall/model.toml"));
  assert.equal(other.status, 2);
  assert.match(other.stderr, /holds results of another model/);
  assert.equal(states(), before);
  assert.equal(push(pier, "--set", "output.states=['0.01 mm']").status, 0);
  assert.ok(states() < before, `${states()} states, ${before} before`);
  assert.deepEqual(fs.readdirSync(path.dirname(out)), ["run"]);
});

test("a page is written again in another language, as the native program writes it", { skip }, () => {
  const out = path.join(inFolder("engine_report"), "run");
  assert.equal(command("run", path.join(root, "examples/brick_pier/model.toml"), "--out", out, "--quiet", "--set", "stage.push.until=0.02 mm").status, 0);
  const page = path.join(out, "report.html");
  const english = fs.readFileSync(page, "utf8");
  const told = command("report", out, "--lang", "it");
  assert.equal(told.status, 0, told.stderr);
  assert.ok(told.stdout.includes(page), told.stdout);
  const italian = fs.readFileSync(page, "utf8");
  assert.notEqual(italian, english);
  run("report", out, "--lang", "it");
  assert.equal(fs.readFileSync(page, "utf8"), italian);
  const nothing = command("report", path.dirname(out));
  assert.equal(nothing.status, 2);
  assert.match(nothing.stderr, /holds no data of a report/);
  assert.match(command("report", out, "--lang", "xx").stderr, /is no language of the report/);
  // of the native program: packed, not damaged
  const native = path.join(path.dirname(out), "native");
  run("run", path.join(root, "examples/brick_pier/model.toml"), "--out", native, "--quiet", "--set", "stage.push.until=0.02 mm");
  const packed = command("report", native);
  assert.equal(packed.status, 4);
  assert.match(packed.stderr, /report\.data: was packed by the native program; write the page by its own command "wythe report"/);
  assert.match(command("constructor").stderr, /^usage: wythe run/); // no name that each object has
});

test("texts of a long list are handed to the engine one at a time, and none is kept twice", async () => {
  const { openJob } = await import(path.join(root, "apps/wasm/job.mjs"));
  const sizes = new Map();
  let at = 0, live = 0, most = 0;
  const had = [];
  const engine = {
    HEAPF64: new Float64Array(100),
    lengthBytesUTF8: (text) => text.length,
    stringToUTF8: (text, to) => sizes.get(to).text = text,
    _malloc: (size) => (sizes.set(++at, { size }), (most = Math.max(most, (live += size))), at),
    _free: (place) => (live -= sizes.get(place).size),
    _wythe_new: () => 1,
    _wythe_free() {},
    _wythe_set_text: (job, name, place) => void had.push([sizes.get(name).text, sizes.get(place).text.length]),
  };
  let made = 0;
  const record = (function* () {
    for (; made < 100; ++made) {
      assert.equal(had.filter(([name]) => name === "record").length, made, "a text was made before the engine had the one before");
      yield "x".repeat(1e5);
    }
  })();
  const job = openJob(engine, "assess", { texts: { file: "wall.toml", record } });
  assert.deepEqual(had, [["file", 9], ...Array(100).fill(["record", 1e5])]);
  assert.ok(most < 2e5, `${most} bytes at once`);
  job.free();
  assert.equal(live, 0);
});

test("what the command cannot do it says", { skip }, () => {
  const nothing = command();
  assert.equal(nothing.status, 2);
  assert.match(nothing.stderr, /wythe run MODEL\.toml --out DIR/);
  assert.match(command("run", "model.toml").stderr, /--out: is missing/);
  assert.match(command("check", "model.toml", "--walls", "8").stderr, /--walls: is no option of wythe check/);
  const missing = command("check", path.join(folder("engine_faults"), "none.toml"));
  assert.equal(missing.status, 2);
  assert.match(missing.stderr, /none\.toml/);
});
