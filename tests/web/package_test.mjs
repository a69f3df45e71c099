// The package for Node (build/wasm/package) as npm packs and installs it in an empty folder: it answers, gives the verdict of the native
// program, and writes the page to draw walls on.
import assert from "node:assert/strict";
import { execFileSync, spawn, spawnSync } from "node:child_process";
import fs from "node:fs";
import os from "node:os";
import path from "node:path";
import { before, test } from "node:test";
import { folder, root, run } from "./helpers.mjs";

const made = path.join(root, "build/wasm/package");
const skip = fs.existsSync(path.join(made, "wythe.wasm")) ? false : "build/wasm is not built: make wasm";
const out = folder("package");
const pier = path.join(root, "examples/brick_pier/model.toml");
const command = (...words) => spawnSync(process.execPath, [path.join(out, "node_modules/wythe/wythe.mjs"), ...words], { cwd: out, encoding: "utf8" });
const npx = (...words) => spawnSync("npx", ["--offline", "wythe", ...words], { cwd: out, encoding: "utf8" });
const read = (...names) => fs.readFileSync(path.join(out, ...names), "utf8");
let packed;

before(() => {
  if (skip) return;
  fs.rmSync(out, { recursive: true, force: true });
  fs.mkdirSync(out, { recursive: true });
  [packed] = JSON.parse(execFileSync("npm", ["pack", made, "--json", "--pack-destination", out, "--foreground-scripts=false"], { encoding: "utf8", cwd: out, stdio: "pipe" }));
  fs.writeFileSync(path.join(out, "package.json"), "{}");
  execFileSync("npm", ["install", "--offline", "--no-audit", "--no-fund", path.join(out, packed.filename)], { cwd: out, stdio: "pipe" });
});

test("the package installs from its tarball and answers", { skip }, () => {
  assert.ok(packed.size < 4e6, `${packed.size} bytes`);
  assert.match(npx("--version").stdout, /^wythe \d+\.\d+\.\d+ /);
  const pushed = npx("run", pier, "--out", "pushed", "--set", "stage.push.until=0.02 mm").stdout;
  assert.match(pushed, /^pushed: .*, state [0-9a-f]{16}\nreport: /);
  assert.match(read("pushed/report.html"), /<header id="headline"/);
  fs.writeFileSync(
    path.join(out, "use.mjs"),
    `import { load } from "wythe";
import fs from "node:fs";
const wythe = await load();
const { code, texts } = wythe.do("check", { texts: { model: fs.readFileSync(process.argv[2], "utf8") } }, { texts: ["check"] });
console.log(code, JSON.parse(texts.check).blocks);
`,
  );
  const told = execFileSync(process.execPath, ["use.mjs", pier], { cwd: out, encoding: "utf8" });
  const blocks = Number(/blocks\D+(\d+)/.exec(run("check", pier))?.[1] ?? NaN);
  assert.equal(told.split(" ")[0], "0");
  if (!Number.isNaN(blocks)) assert.equal(Number(told.split(" ")[1]), blocks);
});

// Two floors, so four ways of pushing: both directions, and two patterns.
const WALL = `
[wall]
length = "0.8 m"
height = "0.8 m"
thickness = "0.2 m"
bond = "running"
[wall.unit]
length = "200 mm"
height = "100 mm"
split = "none"
density = "2000 kg/m^3"
[material.joint]
normal_stiffness = "20 GPa/m"
shear_stiffness = "8 GPa/m"
tensile_strength = "0.15 MPa"
cohesion = "0.15 MPa"
friction_angle = "30 deg"
residual_friction_angle = "30 deg"
residual_cohesion = "0 MPa"
mode_1_energy = "4.3 N/m"
mode_2_energy = "125 N/m"
compressive_strength = "4 MPa"
compressive_energy = "12800 N/m"
[[stage]]
name = "gravity"
[[stage]]
name = "push"
pattern = "mass_height"
levels = ["0.4 m", "0.8 m"]
control = { x = "0.1 m", y = "0.75 m" }
velocity = "2 mm/s"
until = "2 mm"
[scatter]
use = "clay_brick"
[assessment]
code = "circolare_2019"
confidence_factor = 1.2
added_mass = "3000 kg"
[assessment.spectrum]
kind = "ntc2018"
ground_acceleration = "1.5 m/s^2"
amplification = 2.5
corner_period = "0.30 s"
ground = "A"
`;

// What differs by right: the folders of campaigns, which the package does not keep, and the compiler that the page names.
function alike(name, made) {
  const verdict = JSON.parse(read(name, made, "assessment.json"));
  for (const way of verdict.ways) delete way.folder;
  const page = read(name, made, "report.html").replace(/<a href="[^"]*\/report\.html">([^<]*)<\/a>/g, "$1").replace(/wythe \d[^<]*\([^<]*\)/g, "wythe");
  return { verdict, walls: read(name, made, "walls.csv"), page };
}

// Equal but for the last bits of a number: libraries of mathematics round differently, which the checks of parts out of plane meet. Bits of
// the pushes stand in walls.csv.
function assertSame(a, b, at = "") {
  if (typeof a === "number" && typeof b === "number") {
    assert.ok(a === b || Math.abs(a - b) <= 1e-13 * Math.max(Math.abs(a), Math.abs(b)), `${at}: ${a}, ${b}`);
  } else if (a !== null && b !== null && typeof a === "object" && typeof b === "object") {
    assert.deepEqual(Object.keys(a), Object.keys(b), at);
    for (const key of Object.keys(a)) assertSame(a[key], b[key], `${at}.${key}`);
  } else {
    assert.equal(a, b, at);
  }
}

// Each way of pushing and drawing of the native command.
for (const [name, ...words] of [
  ["four ways", "--walls", "3"],
  ["means that scatter, another seed", "--walls", "2", "--seed", "7", "--between", "0.25"],
  ["walls added until the share is known", "--walls", "2", "--between", "0.25", "--until", "0.8", "--set", "stage.push.until=1 mm", "--set", "stage.push.pattern=uniform"],
  ["no answer", "--walls", "2", "--set", "stage.push.until=0.05 mm"],
  ["no factor", "--walls", "2", "--set", "stage.push.until=0.05 mm"],
])
  test(`the verdict is that of the native program: ${name}`, { skip }, () => {
    const place = name.replaceAll(/\W+/g, "_");
    fs.mkdirSync(path.join(out, place));
    fs.writeFileSync(path.join(out, place, "model.toml"), name === "no factor" ? WALL.replace(/^confidence_factor.*\n/m, "") : WALL);
    const native = spawnSync(process.env.WYTHE ?? path.join(root, "build/release/wythe"), ["assess", "model.toml", "--out", "native", "--quiet", ...words], {
      cwd: path.join(out, place),
      encoding: "utf8",
    });
    const wasm = command("assess", `${place}/model.toml`, "--out", `${place}/wasm`, "--quiet", ...words);
    assert.equal(wasm.status, native.status, wasm.stderr + native.stderr);
    assertSame(alike(place, "wasm"), alike(place, "native"));
    const said = (text) => text.split("\n").filter((line) => line && !/^(report|lost)/.test(line)); // they name folders
    assert.deepEqual(said(wasm.stdout), said(native.stdout));
    assert.match(wasm.stdout, name === "no factor" ? /^out of plane: wall: .*\n {2}doubtful: no confidence factor is stated/m : /^out of plane: wall: /m);
    assert.deepEqual(fs.readdirSync(path.join(out, place, "wasm")).sort(), [".wythe_model", ".wythe_walls", "assessment.json", "report.html", "walls.csv"]);
  });

test("an assessment does not depend on the threads, goes on after a kill, and does not go over other results", { skip }, async () => {
  const place = path.join(out, "threads");
  fs.mkdirSync(place);
  fs.writeFileSync(path.join(place, "model.toml"), WALL);
  fs.writeFileSync(path.join(place, "other.toml"), WALL.replace("0.15 MPa", "0.14 MPa"));
  const short = ["--walls", "2", "--set", "stage.push.until=0.3 mm"];
  const assess = (model, made, ...words) => command("assess", `threads/${model}`, "--out", `threads/${made}`, "--quiet", ...short, ...words);
  for (const jobs of ["1", "3"]) assert.equal(assess("model.toml", `by_${jobs}`, "--jobs", jobs).status, 0);
  assert.deepEqual(alike("threads", "by_1"), alike("threads", "by_3"));

  const first = path.join(place, "killed/.wythe_walls/way_0_wall_1.gz");
  const child = spawn(process.execPath, [path.join(out, "node_modules/wythe/wythe.mjs"), "assess", "model.toml", "--out", "killed", "--jobs", "1", ...short], { cwd: place, stdio: "ignore" });
  const ended = new Promise((done) => child.on("exit", done));
  while (!fs.existsSync(first) && child.exitCode === null && child.signalCode === null) await new Promise((done) => setTimeout(done, 5));
  child.kill("SIGSTOP");
  const second = assess("model.toml", "killed", "--resume");
  child.kill("SIGKILL");
  await ended;
  assert.equal(second.status, 4, second.stderr);
  assert.ok(second.stderr.startsWith(`threads/killed: another wythe writes its results there (process ${child.pid} on ${os.hostname()}); wait for it, or name another folder`), second.stderr);
  assert.equal(child.signalCode, "SIGKILL", "the kill came too late");
  assert.ok(fs.existsSync(first) && !fs.existsSync(path.join(place, "killed/assessment.json")));
  const kept = fs.statSync(first).mtimeMs;
  assert.equal(assess("model.toml", "killed", "--resume").status, 0);
  assert.equal(fs.statSync(first).mtimeMs, kept, "it was pushed again");
  assert.deepEqual(alike("threads", "killed"), alike("threads", "by_1"));

  const before = read("threads/by_1/walls.csv");
  for (const [model, words, said] of [
    ["model.toml", [], /holds walls of an assessment already; --resume goes on/],
    ["other.toml", ["--resume"], /holds walls of another model, setting, seed or version/],
    ["model.toml", ["--resume", "--seed", "2", "--walls", "4"], /holds walls of another model, setting, seed or version/],
    ["model.toml", ["--resume", "--replace"], /--resume: goes on with walls that --replace removes/],
    ["model.toml", ["--resume", "--walls", "3"], /--walls: 3 is one more than there are.*write 4/],
  ]) {
    const refused = assess(model, "by_1", ...words);
    assert.equal(refused.status, 2);
    assert.match(refused.stderr, said);
    assert.equal(read("threads/by_1/walls.csv"), before);
  }
  assert.equal(assess("other.toml", "by_1", "--replace").status, 0);
  assert.notEqual(read("threads/by_1/walls.csv"), before);
  run("assess", path.join(place, "model.toml"), "--out", path.join(place, "native"), "--quiet", ...short);
  const native = assess("model.toml", "native");
  assert.equal(native.status, 2);
  assert.match(native.stderr, /holds the campaigns of an assessment/);
});

test("one process at a time writes in a folder: of several that begin at once one holds it, and one that was killed holds nothing", { skip }, async () => {
  const script = `import { hold } from ${JSON.stringify(path.join(made, "hold.mjs"))};
let release;
try {
  release = hold("held/deep");
  console.log("held");
} catch (error) {
  console.log(error.code, error.message);
}
process.stdin.on("end", () => release?.()).resume();`;
  const begun = Array.from({ length: 4 }, () => spawn(process.execPath, ["--input-type=module", "-e", script], { cwd: out, stdio: ["pipe", "pipe", "inherit"] }));
  const said = await Promise.all(begun.map((child) => new Promise((done) => child.stdout.setEncoding("utf8").once("data", done))));
  const holder = begun[said.indexOf("held\n")];
  assert.equal(said.filter((words) => words === "held\n").length, 1, said.join(""));
  for (const words of said) if (words !== "held\n") assert.ok(words.startsWith(`4 held/deep: another wythe writes its results there (process ${holder.pid} on ${os.hostname()}); wait`), words);
  const ended = begun.map((child) => new Promise((done) => child.on("exit", done)));
  for (const child of begun) child.stdin.end();
  await Promise.all(ended);
  assert.ok(!fs.existsSync(path.join(out, "held/deep/.wythe_lock")));

  const lock = path.join(out, "holds/.wythe_lock");
  const tries = (name) => command(...(name === "report" ? [name, "holds"] : [name, pier, "--out", "holds", "--quiet", "--set", "stage.push.until=0.02 mm"]));
  fs.mkdirSync(path.dirname(lock));
  for (const holder of [`process ${process.pid} on ${os.hostname()}`, `process 1 on another-${os.hostname()}`])
    for (const name of ["run", "limit", "assess", "report"]) {
      fs.writeFileSync(lock, `process ${begun[0].pid} on ${os.hostname()}\nprocess 12\n${holder}\n`); // before it a killed one, and half a line
      const refused = tries(name);
      assert.equal(refused.status, 4, refused.stderr);
      assert.equal(
        refused.stderr,
        `holds: another wythe writes its results there (${holder}); wait for it, or name another folder; if that process is no wythe, or is gone, remove ${lock}\n`,
      );
      assert.deepEqual(fs.readdirSync(path.dirname(lock)), [".wythe_lock"]);
    }
  fs.writeFileSync(lock, `process ${begun[0].pid} on ${os.hostname()}\n`);
  for (const name of ["run", "report"]) {
    const done = tries(name);
    assert.equal(done.status, 0, done.stderr);
    assert.ok(!fs.existsSync(lock));
  }
});

test("a folder is held though the number of a killed process was given again, or the folder was removed just then", { skip }, async () => {
  const { hold } = await import(path.join(made, "hold.mjs"));
  const lock = path.join(out, "freed/deep/.wythe_lock");
  const append = fs.appendFileSync;
  const before = {
    "nothing": () => undefined,
    "the number of a process that began at another time": () => fs.writeFileSync(lock, `process ${process.pid} on ${os.hostname()}, begun 1\n`),
    "who held it removes it between": () => {
      fs.appendFileSync = (...words) => {
        fs.appendFileSync = append;
        fs.rmSync(path.join(out, "freed"), { recursive: true });
        append(...words);
      };
    },
  };
  if (process.platform !== "linux") delete before["the number of a process that began at another time"]; // told by /proc alone
  for (const [name, prepare] of Object.entries(before)) {
    try {
      if (name !== "nothing") fs.mkdirSync(path.dirname(lock), { recursive: true });
      prepare();
      const release = hold(path.dirname(lock));
      assert.ok(fs.existsSync(lock), name);
      release();
      assert.ok(!fs.existsSync(lock), name);
      assert.equal(fs.existsSync(path.join(out, "freed")), name !== "nothing" && !name.startsWith("who"), `${name}: what hold() made goes, what was there stays`);
    } finally {
      fs.appendFileSync = append;
      fs.rmSync(path.join(out, "freed"), { recursive: true, force: true });
    }
  }
});

test("a file or a folder that cannot be used is told in one line with its place and cure", { skip }, async () => {
  const place = path.join(out, "places");
  fs.mkdirSync(path.join(place, "folder"), { recursive: true });
  fs.writeFileSync(path.join(place, "file"), "");
  fs.writeFileSync(path.join(place, "model.toml"), WALL);
  const model = "places/model.toml";
  const noFolder = /a file stands where a folder must be; name another place$/;
  const cases = [
    [4, noFolder, "run", model, "--out", "places/file"],
    [4, noFolder, "limit", model, "--out", "places/file"],
    [4, noFolder, "assess", model, "--out", "places/file"],
    [4, noFolder, "assess", model, "--out", "places/file/deep"],
  ];
  for (const [name, ...words] of [["check"], ["run", "--out", "places/out"], ["limit", "--out", "places/out"], ["assess", "--out", "places/out"]]) {
    cases.push([2, /there is no such file; name a file/, name, "places/none.toml", ...words]);
    cases.push([2, /is a folder, not a file; name a file in it$/, name, "places/folder", ...words]);
  }
  cases.push([2, /holds no data of a report/, "report", "places/none"]);
  for (const [code, said, ...words] of cases) {
    const { status, stderr } = command(...words);
    assert.equal(status, code, `${words.join(" ")}\n${stderr}`);
    assert.match(stderr.trimEnd(), said, words.join(" "));
    assert.ok(stderr.includes("places/") && stderr.trimEnd().split("\n").length === 1, stderr);
  }
  assert.deepEqual(fs.readdirSync(place).sort(), ["file", "folder", "model.toml"]);
  const { refusalOf } = await import(path.join(made, "refused.mjs"));
  for (const [code, syscall, said] of [
    ["EACCES", "open", "wall.html: cannot be opened: there is no right to it; change its rights, or name another place"],
    ["EWEIRD", "link", "wall.html: cannot be used: the system says EWEIRD; name another place"],
  ])
    assert.equal(refusalOf(Object.assign(new Error("of the system"), { code, syscall, path: "wall.html" })).message, said);
  assert.equal(refusalOf(new TypeError("a defect")), undefined);
});

// What Node leaves the place out of: the system fails to write or to read what it has opened.
test("a full disk, and a folder that is read, are told in one line with place and cure", { skip: skip || (fs.existsSync("/dev/full") ? false : "/dev/full is missing") }, async () => {
  const place = path.join(out, "full");
  const full = (name) => fs.symlinkSync("/dev/full", path.join(place, name));
  fs.mkdirSync(path.join(place, "package"), { recursive: true });
  fs.writeFileSync(path.join(place, "model.toml"), WALL);
  fs.writeFileSync(path.join(place, "built.html"), "<!--wythe:worker--><!--wythe:wasm-->");
  for (const name of [".wythe_lock", "page.html", "package/studio_page.html"]) full(name);
  for (const name of ["wythe.wasm", "wythe.cjs", "worker.js", "job.mjs"]) fs.copyFileSync(path.join(made, name), path.join(place, "package", name));
  const engine = path.join(root, "build/wasm");
  const ofPage = (...words) => spawnSync(process.execPath, [path.join(made, "page.mjs"), ...words], { cwd: out, encoding: "utf8" });
  const noRoom = "cannot be written: its disk is full; make room, or name another place\n";
  const lock = path.join(place, ".wythe_lock");
  for (const [told, words] of [
    [command("run", "full/model.toml", "--out", "full"), `${lock}: ${noRoom}`],
    [command("report", "full"), `${lock}: ${noRoom}`],
    [ofPage("full/built.html", engine, "full/page.html"), `full/page.html: ${noRoom}`],
    [ofPage("full/built.html", engine, "full/whole.html", "full/package"), `full/package/studio_page.html: ${noRoom}`],
    [ofPage("full", engine, "full/whole.html"), "full: cannot be read: it is a folder; name a file\n"],
  ]) {
    assert.equal(told.stderr, words);
    assert.equal(told.status, 4);
  }
  assert.ok(fs.statSync("/dev/full").isCharacterDevice());
});

test("a file is written whole and alone: nothing beside it is lost, and a link stays one", { skip }, async () => {
  const { put } = await import(path.join(made, "refused.mjs"));
  const place = path.join(out, "put");
  fs.mkdirSync(path.join(place, "far"), { recursive: true });
  const at = (name) => path.join(place, name);
  const beside = ["wall.html.new", "wall.html~", ".wall.html", ".wall.html.new"];
  for (const name of [...beside, "far/wall.html"]) fs.writeFileSync(at(name), "mine");
  fs.symlinkSync("far/wall.html", at("link.html"));
  fs.symlinkSync("far/none.html", at("to_nothing.html"));
  for (const name of ["wall.html", "wall.html", "link.html", "to_nothing.html"]) put(at(name), `new ${name}`);
  const text = (name) => fs.readFileSync(at(name), "utf8");
  for (const name of beside) assert.equal(text(name), "mine", name);
  assert.equal(text("wall.html"), "new wall.html");
  assert.equal(text("far/wall.html"), "new link.html");
  assert.equal(text("far/none.html"), "new to_nothing.html");
  for (const name of ["link.html", "to_nothing.html"]) assert.ok(fs.lstatSync(at(name)).isSymbolicLink(), name);
  fs.mkdirSync(at("folder"));
  assert.throws(() => put(at("folder"), "new"), { code: "EISDIR", path: at("folder") });
  assert.deepEqual(fs.readdirSync(place).sort(), [...beside, "far", "folder", "link.html", "to_nothing.html", "wall.html"].sort());
  assert.deepEqual(fs.readdirSync(at("far")).sort(), ["none.html", "wall.html"]);
});

test("a drive is one whatever the case of its letter", { skip }, async () => {
  const { isOnDrive, isSamePlace } = await import(path.join(made, "host.mjs"));
  const { win32 } = path;
  assert.equal(isOnDrive("c:\\walls\\out", "C:\\", win32), true);
  assert.equal(isOnDrive("D:\\walls\\out", "C:\\", win32), false);
  assert.equal(isSamePlace("c:\\Walls\\wall.html", "C:\\walls\\WALL.html", win32), true);
  assert.equal(isOnDrive("/walls/out", "/", path.posix), true);
  assert.equal(isSamePlace("/Walls", "/walls", path.posix), false);
});

test("a page of another engine is neither used nor packed", { skip }, () => {
  const own = path.join(out, "own");
  fs.cpSync(made, own, { recursive: true });
  fs.writeFileSync(path.join(out, "built.html"), "<title>wythe studio</title><!--wythe:worker--><!--wythe:wasm--><!--wythe:model-->\n");
  const page = spawnSync(process.execPath, [path.join(own, "page.mjs"), "built.html", path.join(root, "build/wasm"), "whole.html", own], { cwd: out, encoding: "utf8" });
  assert.equal(page.status, 0, page.stderr);
  const studio = () => spawnSync(process.execPath, [path.join(own, "wythe.mjs"), "studio", "--out", "own.html"], { cwd: out, encoding: "utf8" });
  const pack = () => spawnSync("npm", ["pack", own, "--pack-destination", own], { cwd: own, encoding: "utf8" });
  assert.equal(studio().status, 0);
  assert.equal(read("own.html"), read("whole.html").replace("<!--wythe:model-->", ""));
  const tarballs = () => fs.readdirSync(own).filter((name) => name.endsWith(".tgz"));
  for (const [name, more] of [
    ["wythe.wasm", Buffer.from([0, 2, 1, 0x78])], // a section that says nothing
    ["wythe.cjs", "\n"],
    ["worker.js", "\n"],
    ["job.mjs", "\n"],
  ]) {
    const before = fs.readFileSync(path.join(own, name));
    fs.appendFileSync(path.join(own, name), more);
    for (const refused of [studio(), pack()]) {
      assert.notEqual(refused.status, 0, `${name}: ${refused.stdout}`);
      assert.match(refused.stderr, /studio_page\.html: is a page of another engine than that of this package; in the sources, make studio builds it again/);
    }
    assert.deepEqual(tarballs(), []);
    fs.writeFileSync(path.join(own, name), before);
  }
  fs.rmSync(path.join(own, "studio_page.html"));
  const without = pack();
  assert.equal(without.status, 0, without.stderr);
  assert.match(without.stderr, /studio_page\.html: is missing, so this package has no studio; in the sources, make studio puts it in/);
  assert.equal(tarballs().length, 1);
});

test("what an assessment refuses is told in the words of the native program", { skip }, () => {
  const place = path.join(out, "refused");
  fs.mkdirSync(place);
  const file = path.join(place, "model.toml");
  fs.writeFileSync(file, WALL.replace(/\[scatter\]\nuse = .*\n/, ""));
  const native = spawnSync(process.env.WYTHE ?? path.join(root, "build/release/wythe"), ["assess", file, "--out", path.join(place, "out")], { encoding: "utf8" });
  const wasm = command("assess", file, "--out", "refused/out");
  assert.equal(wasm.status, 2);
  assert.equal(wasm.stderr.trim().split("\n")[0], native.stderr.trim().split("\n")[0]);
  assert.ok(!fs.existsSync(path.join(place, "out")));
  fs.writeFileSync(file, WALL);
  for (const [option, value, said] of [
    ["--walls", "1", /walls.*must be a whole number from 2/],
    ["--walls", "many", /--walls: many is no number/],
    ["--until", "0.01", /until.*must be a number more than 0\.05/],
    ["--between", "2", /between.*must be a number more than 0 and up to 1/],
    ["--shard", "1/2", /--shard: is no option of wythe assess/],
  ]) {
    const ended = command("assess", file, "--out", "refused/out", option, ...(value ? [value] : []));
    assert.equal(ended.status, 2, option);
    assert.match(ended.stderr, said);
  }
  assert.ok(!fs.existsSync(path.join(place, "out")));
});

test("the page to draw walls on is that of make studio, with the model in it", { skip: skip || (fs.existsSync(path.join(made, "studio_page.html")) ? false : "make studio") }, () => {
  fs.copyFileSync(pier, path.join(out, "wall.toml"));
  const told = command("studio", "wall.toml", "--out", "wall.html");
  assert.equal(told.status, 0, told.stderr);
  assert.match(told.stdout, /open in a browser: .*wall\.html/);
  const page = read("wall.html");
  assert.ok(page.includes(fs.readFileSync(pier).toString("hex")));
  const whole = path.join(root, "build/studio.html");
  if (fs.existsSync(whole)) assert.equal(page.replace(fs.readFileSync(pier).toString("hex"), "<!--wythe:model-->"), fs.readFileSync(whole, "utf8"));
  assert.equal(command("studio", "--out", "wall.html").status, 0);
  assert.ok(!read("wall.html").includes("<!--wythe:model-->"));
  fs.writeFileSync(path.join(out, "letter.html"), "<p>mine</p>");
  fs.writeFileSync(path.join(out, "study.toml"), '[study]\nbase = "model.toml"\n');
  for (const [words, said, code = 2] of [
    [["wall.toml", "--out", "letter.html"], /is there, and is no earlier answer/],
    [["wall.toml", "--out", "wall.toml"], /would be lost/],
    [["study.toml"], /is a study/],
    [["none.toml"], /none\.toml: cannot be read/],
    [["wall.toml", "--out", "none/wall.html"], /^none\/wall\.html: cannot be opened: its folder is missing; make it, or name another place\n$/, 4],
    [["wall.toml", "--out", "letter.html/wall.html"], /^letter\.html\/wall\.html: cannot be opened: a file stands where a folder must be; name another place\n$/, 4],
  ]) {
    const refused = command("studio", ...words);
    assert.equal(refused.status, code, refused.stdout);
    assert.match(refused.stderr, said);
  }
  assert.equal(read("letter.html"), "<p>mine</p>");
});
