// The engine's faults and notes in the page's language: what a wall that is drawn or a file that is edited may meet is said in each of
// the six, and nothing of it is English.
import assert from "node:assert/strict";
import { spawn } from "node:child_process";
import fs from "node:fs";
import path from "node:path";
import { createInterface } from "node:readline";
import { after, before, test } from "node:test";
import { root, viewerModule } from "./helpers.mjs";
import { kLibrary, kPython } from "./studio.mjs";

const kOthers = ["it", "de", "fr", "es", "pt"];
// Places that hold English words, or what a page cannot do: the other languages go without.
const kEnglishAlone = {
  "{1} is not the unit of {2} [{3}]": "2",
  "{o1} has an edge at {2}, {3} from the nearest joint line, more than 2 % of its {4}": "4",
  "the load can grow without end: no mechanism exists, {1} carries any force": "1",
  "give each {1} a name of its own": "1",
  "write larger units or a smaller wall, or state what may be used: {1}": "1",
  "openings or teeth {w1} a strip of masonry too thin to lay at {2}": "1",
  "can't read {1}: {2}": "2",
  "= {1} (derived by {w2} from {3})": "3",
  "= {1} (typical of {w2} {3})": "3",
  "gives {1} [{2}], but {w3} is in {4}": "1",
  "{w1} of {2} [{3}]": "2",
  "adds {1} and {2}": "12",
  "subtracts {1} and {2}": "12",
  "compares {1} and {2}": "12",
  "has {1} [{2}] as an exponent": "1",
  "raises {1} [{2}] to a power that varies": "1",
};
const example = (name) => fs.readFileSync(path.join(root, "examples", name), "utf8");
let inWords, reasonOf, engine, lines;
before(async () => {
  ({ inWords } = await viewerModule("studio/file/said"));
  ({ reasonOf } = await viewerModule("studio/push/limit"));
  engine = spawn(kPython, [path.join(root, "tests/web/engine.py"), kLibrary], { stdio: ["pipe", "pipe", "inherit"] });
  lines = createInterface({ input: engine.stdout })[Symbol.asyncIterator]();
});
after(() => engine?.kill("SIGKILL"));
async function ask(task, texts, want = []) {
  engine.stdin.write(`${JSON.stringify({ id: 1, task, texts, want })}\n`);
  for (;;) {
    const answer = JSON.parse((await lines.next()).value);
    if (!answer.progress) return answer;
  }
}

test("each row has six sentences whose places are those of the English one", () => {
  const rows = JSON.parse(fs.readFileSync(path.join(root, "web/src/studio/file/fault_words.json"), "utf8"));
  for (const [english, ...others] of rows) {
    assert.equal(others.length, 5, english);
    const places = (text) => [...text.matchAll(/\{[a-z]?(\d)\}/g)].map((m) => m[1]).sort();
    const left = places(english).filter((place) => !(kEnglishAlone[english] ?? "").includes(place));
    for (const words of others) {
      assert.ok(words.trim() !== "", english);
      assert.deepEqual(places(words), left, words);
      assert.doesNotMatch(words.replace(/\[[^\]]*\]|\w+ = "[^"]*"/g, ""), /\b(must|missing|write|leave|opening|the|wall is)\b/, words);
    }
  }
});

// Pieces of the sources' texts between their places: "must be at least {} {}" gives "must be at least ". Texts side by side are one.
function piecesOfSources() {
  const all = new Set();
  const add = (text) => text.split(/\$?\{[^{} ]*\}/).forEach((piece) => all.add(piece.replace(/\{\{/g, "{").replace(/\}\}/g, "}")));
  const read = (file) => fs.readFileSync(file, "utf8").replace(/^\s*\/\/.*$/gm, "").replace(/"\s*\n\s*"/g, "");
  for (const entry of fs.readdirSync(path.join(root, "src"), { recursive: true }))
    if (/\.(cpp|h)$/.test(entry))
      for (const [, text] of read(path.join(root, "src", entry)).matchAll(/"((?:[^"\\\n]|\\.)*)"/g)) add(text.replace(/\\(["\\])/g, "$1"));
  for (const [, text] of read(path.join(root, "web/src/studio/file/toml.ts")).matchAll(/fault\(["`]([^"`]*)["`]\)/g)) add(text);
  all.delete("");
  return [...all];
}
// Whether a text may come out of pieces: it lies in one, or the end of one, whole ones and the start of one make it.
function mayComeOf(text, pieces, whole, joined) {
  const goesOn = (at) => {
    const left = text.slice(at);
    if (pieces.some((piece) => piece.startsWith(left))) return true;
    for (let end = at + 2; end < text.length; ++end) if (whole.has(text.slice(at, end)) && goesOn(end)) return true;
    return false;
  };
  const heads = Array.from({ length: text.length - 1 }, (_, k) => text.slice(0, k + 1));
  return joined.includes(text) || heads.some((head) => pieces.some((piece) => piece.endsWith(head)) && goesOn(head.length));
}

test("the words of each row stand in the sources of the engine or of the studio", () => {
  const pieces = piecesOfSources();
  const [whole, joined] = [new Set(pieces), pieces.join("\n")];
  const comes = (english) => english.split(/\{[a-z]?\d\}/).every((part) => part.trim() === "" || mayComeOf(part, pieces, whole, joined));
  assert.ok(!comes("must be true or false without quotes")); // the engine has a comma there
  const rows = JSON.parse(fs.readFileSync(path.join(root, "web/src/studio/file/fault_words.json"), "utf8"));
  assert.deepEqual(rows.map(([english]) => english).filter((english) => !comes(english)), []);
});

// What is drawn or written, and what may be wrong with it.
const kFaulty = {
  "brick_portal/model.toml": [
    ['length = "3.50 m"', 'length = "0 m"'], ['length = "3.50 m"', "length = 3.5"], ['length = "3.50 m"', 'length = "3,50 m"'], ['length = "3.50 m"', 'length = "3.50 kN"'], ['length = "3.50 m"', 'length = "3.50 foo"'],
    ['length = "3.50 m"', 'lenght = "3.50 m"'], ['length = "3.50 m"', 'length = "3.50 mm"'], ['length = "3.50 m"', 'length = "3500 m"'], ['thickness = "0.25 m"\n', ""], ['bond = "running"', 'bond = "runing"'], ["[wall]", "[wal]"], ["[wall]", "[wall"],
    ['x = "1.25 m"', 'x = "3.25 m"'], ['x = "1.25 m"', 'x = "0.1 m"'], ['x = "1.25 m"', 'x = "-1 m"'], ['height = "2.10 m"', 'height = "4 m"'], ['height = "2.10 m"\n', ""],
    ['depth = "146 mm"', 'depth = "1 m"'], ['bearing = "250 mm"', 'bearing = "2 m"'], ['material = "timber"\n', ""], ['material = "timber"', 'material = "steel"'], ['bond = "timber_face"', 'bond = "nothing"'],
    ['use = "clay_brick_old"', 'use = "concrete"'], ['use = "clay_brick_old"\n', ""], ["[masonry]", "[mason]"], ['pier_load = "60 kN"', 'pier_load = "60 kN/m"'], ['pier_load = "60 kN"', 'beam_load = "60 kN"'],
    ['y = "2.6 m", courses', 'y = "5 m", courses'], ["courses = 3", "courses = 300"], ["courses = 3", "courses = 2.5"], ['until = "20 mm"\n', ""], ['until = "20 mm"', 'until = "0 mm"'], ["damping = 0.2 ", 'damping = "0.2" '], ["damping = 0.2 ", "damping: 0.2 "],
    ['name = "push"', 'name = "gravity"'], ['youngs_modulus = "10 GPa"\n', ""], ['friction_angle = "30 deg"', 'friction_angle = "95 deg"'], ['residual_cohesion = "0 MPa"', 'residual_cohesion = "1 MPa"'], ["[[stage]]", "[stage]"], ['density = "1800 kg/m^3"', 'density = "18 kN/m^3"'],
    ["\n[masonry]", '\n[[wall.opening]]\nname = "w"\nx = "1.5 m"\ny = "1 m"\nwidth = "1 m"\nheight = "0.5 m"\n[masonry]'],
    ["\n[masonry]", '\n[[tie]]\nname = "t"\nfrom = { x = "0.1 m", y = "2.6 m" }\nto = { x = "3.9 m", y = "2.6 m" }\narea = "314 mm^2"\nyoungs_modulus = "210 GPa"\n[masonry]'],
    ['height = "2.10 m"\n', 'height = "2.10 m"\narch = { kind = "segmental", rise = "2 m", depth = "0.25 m" }\n'],
    // keys of a stage together
    ['until = "20 mm"', 'until = "20 mm"\nrate = "0.1 1/s"'], ['courses = 3 }', 'courses = 3 }\npattern = "mass"\nas = "each"\nlevels = ["1 m"]'], ['courses = 3 }', 'role = "mansory" }'], ['pier_load = "60 kN"', 'force = "1 kN"\nface = "top"'],
    ['until = "20 mm"', 'targets = ["0 mm", "-1 mm"]\ncontraflexure = 1.0\ncontrol = { x = "1 m" }'],
    ['until = "20 mm"', 'until = "20 mm"\n[[stage]]\nname = "quake"\nrecord = { pulse = "half_cycle", amplitude = "1 m/s^2", period = "0.5 s", column = "2" }\nscale = { pga = "1 m/s^2", factor = 2.0 }\nrotation = "blocked"\nmass_damping = { fraction = 0.02 }'],
    ['until = "20 mm"', 'until = "20 mm"\n[[stage]]\nname = "quake"\nrecord = { file = "a.csv", unit = "g" }'],
    // values by rule, knowledge levels, what a code asks
    ['missing = "rule"', 'friction_tan = "0.5"\nfriction_angle = "30 deg"'], ['missing = "rule"', 'tensile_strength = "0 MPa"'], ['missing = "rule"', 'cohesion = "rule: none"\ndensity = "rule"\nuse = "granite_lime"'], ['vertical_stress = "0.2 MPa"', 'vertical_stress = "60 MPa"'],
    ['use = "clay_brick_old"', 'use = "circolare_brick_lime"\nknowledge_level = "LC1"\ncourses = 3.0\ngood_mortar = true\ncore = true\ndeep_wedges = true\ntest = 3'], ['use = "clay_brick_old"', 'use = "clay_brick_old"\nknowledge_level = "LC1"'],
    ["\n[material.joint]", '\n[[masonry.test]]\nof = "masonry_strength"\nfoo = 3\n[material.joint]'], ["\n[masonry]", '\n[assessment.spectrum]\nground_acceleration = "1 m/s^2"\n[masonry]'],
    ["\n[masonry]", '\n[[assessment.part]]\nname = "p"\nfoot = "2 m"\nhead = "1 m"\nhold = [{ height = "1 m" }]\nteeth = { corners = 1 }\n[masonry]'],
    // what has no effect, files that are not there, units
    ['bond = "running"', 'up = "z"\nbeam = { density = "1 kg/m^3" }\nsupports = ["a"]'], ['bond = "running"', 'blocks = "a.stl"'], ["[wall.opening.lintel]", '[wall.opening.sill]\ndepth = "100 mm"\n[wall.opening.lintel]'], ["\n[masonry]", "\n[[contact]]\n[masonry]"],
    ['density = "1800 kg/m^3"', 'density = "18 ton/m^3"'], ['friction_angle = "30 deg"', 'friction_angle = "30 %"'], ['pier_load = "60 kN"', 'pier_load = "60,000 N"'], ['pier_load = "60 kN"', 'pier_load = "6000 kg"'], ['pier_load = "60 kN"', 'pier_load = ""'], ['height = "73 mm"', 'height = "73e-12 m"'],
    // fields and their formulas
    ["\n[output]", '\n[field.a]\npath = "wall.length"\ncov = 0.3\nby = "joint"\n[output]'], ["\n[output]", '\n[field.a]\npath = "material.joint.cohesion"\ncov = 20.0\nby = "joint"\nlower = 1.2\ncorrelation = { b = { gaussian = 0.5 } }\n[output]'],
    ...["3 Pa", "log(ft)", "ft + 1", "(ft"].map((formula) => ["\n[output]", `\n[field.ft]\npath = "material.joint.tensile_strength"\ncov = 0.3\nby = "joint"\n[field.c]\npath = "material.joint.cohesion"\nformula = "${formula}"\n[output]`]),
    // slips of TOML
    ...['height = "2.92 m" // of it', "a = { x = 1,", "[wall,unit]", "height = True", "; height", 'height of = "3 m"', "height = .5", "height = \u201c2.92 m\u201d", "height = 2,92", "height = 3 m", "height = [1, 2", 'height = "a'].map((line) => ['height = "2.92 m"', line]),
    ["\n[masonry]", '\n[[ring_beam]]\ny = "2 m"\nheight = "73 mm"\nmaterial = "timber"\n[masonry]'], ["\n[masonry]", '\n[[region]]\njoint = "joint"\n[masonry]'],
    ["\n[masonry]", '\n[[region]]\npolygon = [["0 m", "0 m"], ["1 m", "0 m"], ["2 m", "0 m"]]\njoint = "joint"\n[masonry]'], ["\n[masonry]", '\n[[wall.foundation]]\nx = "0 m"\ny = "0 m"\n[[wall.foundation]]\nx = "1.5 m"\ny = "4 m"\n[masonry]'],
    ["\n[masonry]", '\n[[floor]]\ny = "2.92 m"\nload = "3 kN/m"\njoists = ["0.3 m", "0.3 m"]\n[masonry]'], ["\n[masonry]", '\n[[diaphragm]]\nkind = "rigid"\ny = "2.6 m"\nx = ["0.2 m"]\n[masonry]'], ["\n[masonry]", '\n[[spring]]\nat = { x = "0.1 m", y = "2.6 m" }\ndirection = "+z"\nstiffness = "20 kN/mm"\n[masonry]'],
    ["\n[masonry]", '\n[[layer]]\nsides = 2\nx = "9 m"\nwidth = "1 m"\nfibres = { vertical = "46 mm^2/m", youngs_modulus = "72 GPa" }\nbond = { energy = "400 N/m", slip = "0.2 mm" }\n[masonry]'], ["\n[masonry]", '\n[field.f]\npath = "material.timber_face.normal_stiffness"\ndistribution = "normal"\ncov = 3\nalong = "1 m"\nacross = "1 m"\n[masonry]'],
    ['until = "20 mm"', 'amplitudes = ["4 mm", "2 mm"]\ncycles = 2'], ['until = "20 mm"', 'until = "20 mm"\ncontraflexure = 0.5'], ['until = "20 mm"', 'until = "20 mm"\n[solve]\nground = "0 m"'], ["\n[output]", '\n[[stage]]\nname = "q"\nrecord = { accelerations = [0, 1, 0], times = [0, 1], unit = "g", direction = "+x" }\n[output]'],
    ['bond = "timber_face"', 'model = "zones"\nzones = 60\nzone_length = "200 mm"'], ['compressive_strength = "unlimited"', 'compressive_strength = "unlimited"\ncompression_cap = 9'], ['until = "20 mm"', 'until = "1900 mm"\n[output]\nwindow = "0.001 mm"\n[more]'],
  ],
  "brick_facade/model.toml": [
    ['height = "3.40 m"', 'height = "2 m"'], ['name = "first floor"', 'name = "ground floor"'], ['storey = "ground floor"', 'storey = "cellar"'], ['storey = "ground floor"            #', 'y = "1 m" #'], ['load = "12 kN/m"', 'load = "12 kN/m^2"'],
    ['load = "12 kN/m"', 'load = "12 kN/m"\nx = "5 m"\nwidth = "9 m"'], ['load = "12 kN/m"\n', ""],
    ['load = "12 kN/m"', 'g1 = "2.6 kN/m^2"'], ['load = "12 kN/m"', 'load = "12 kN/m"\npsi2 = 0.3'], ['load = "12 kN/m"', 'g1 = "2.6 kN/m"\ng2 = "1.4 kN/m^2"\nq = "2 kN/m^2"\npsi2 = 3\nspan = "0 m"'], ['load = "12 kN/m"', 'mass = "rule"'], ['[wall]\n', '[wall]\nheight = "7 m"\n'],
  ],
  "opening/after.toml": [
    ['round = "shop"', 'round = "door"'], ['feet = "fixed"', 'feet = "free"'], ['profile = "HEB 120"', 'profile = "HEB 121"'], ['profile = "HEB 120"', 'profile = "HEB 500"'], ['grade = "S275"', 'grade = "S999"'], ['joint = "steel_contact"', 'joint = "j"'],
    ['grade = "S275"', 'grade = "S275"\ngap = "80 mm"'], ['grade = "S275"', 'grade = "S275"\ngap = "8 mm"\nanchors = { spacing = "400 mm", depth = "150 mm", tension = "12 kN", shear = "15 kN" }'],
    ['grade = "S275"', 'grade = "S275"\nanchors = { spacing = "400 mm", depth = "2 m", tension = "12 kN", shear = "15 kN" }'], ['cut = "works"', 'cut = "work"'],
    ['at = { x = "0 m", y = "2.7 m" }', 'at = { x = "0 m", y = "2.7 m", z = "1 m" }\nalong = [1, 0, 1]'], ['feet = "fixed"', 'feet = "fixed"\nwall = "front"'], ['feet = "fixed"', 'feet = "fixed"\nsection = { height = "120 mm" }'],
  ],
  "palazzina/model.toml": [['corner_period = "0.32 s"', 'corner_period = "9 s"'], ['amplification = 2.45 ', "amplification = 0.5 "]],
  "corner/model.toml": [
    ['["1.125 m", "0 m"]]', '["1.2 m", "0 m"]]'], ['["0 m", "1.125 m"]]', '["0.5 m", "1.125 m"]]'], ['[["0 m", "0 m"], ["0 m", "1.125 m"]]', '[["0 m", "0.05 m"], ["0 m", "1.125 m"]]'], ['name = "side"', 'name = "side"\nbase = "0.3 m"'], ['name = "side"', 'name = "a.b"'], ['name = "side"', 'name = "side"\nthrough_courses = 3'],
    ["[material.joint]", '[[plan_wall]]\nname = "up"\nline = [["0.2 m", "0 m"], ["0.8 m", "0 m"]]\nbase = "1.5 m"\n[material.joint]'], ['direction = "-z"', 'direction = "-y"'], ["[solve]", '[[stage]]\nname = "press"\npressure = "1 MPa"\nface = "up"\n[solve]'], ["[material.joint]", '[wall.beam]\nheight = "0.2 m"\ndensity = "2400 kg/m^3"\n[material.joint]'],
    ["[material.joint]", '[[floor]]\nfrom = { x = "0 m", y = "0.93 m", z = "0 m" }\nto = { x = "1 m", y = "0.93 m", z = "0 m" }\nload = "12 kN/m"\n[material.joint]'], ["[material.joint]", '[[frame]]\nname = "F"\nwall = "front"\nline = [["0.1 m", "0.5 m"], ["0.8 m", "0.5 m"]]\nfeet = "fixed"\nprofile = "HEB 100"\ngrade = "S275"\njoint = "joint"\n[material.joint]'],
  ],
  "stone_house/model.toml": [['walls = ["front", "back"]', 'walls = ["front", "right"]'], ['walls = ["front", "back"]', 'walls = ["front", "bak"]'], ['level = "2.0 m"', 'level = "1.9 m"'], ['bearing = "125 mm"', 'bearing = "400 mm"'], ['x = "0.75 m"\ny = "0 m"\nwidth', 'x = "7.5 m"\ny = "0 m"\nwidth'], ['name = "back"', 'name = "back"\ngable = "1 m"\nmeets = "toothd"']],
  "barrel_vault/model.toml": [['rise = "0.8 m"', 'rise = "8 m"'], ["[material.joint]", '[[arch]]\nname = "w"\nspan = "3 m"\nrise = "0.8 m"\ndepth = "300 mm"\nwidth = "1.8 m"\nvoussoirs = 13\nunits = 3\n[material.joint]'], ["[material.joint]", '[[arch]]\nname = "w"\nz = "9 m"\nspan = "3 m"\ndepth = "300 mm"\nwidth = "1.8 m"\nvoussoirs = 3\nspringers = false\n[material.joint]']],
};

test("faults of drawn walls and edited files, and their cures, are said in each language", async () => {
  const english = new Set();
  for (const [name, edits] of Object.entries(kFaulty)) {
    const text = example(name);
    for (const [from, to] of edits) {
      assert.ok(text.includes(from), from);
      const { code, texts } = await ask("check", { model: text.replace(from, to) });
      assert.equal(code, 2, to);
      for (const { problem, cure } of JSON.parse(texts.faults)) english.add(problem).add(cure);
    }
  }
  english.delete("");
  assert.ok(english.size > 200, `${english.size} sentences`);
  assert.equal(inWords("must be more than 0 m", "en"), "must be more than 0 m");
  const missing = [...english].filter((sentence) => kOthers.some((language) => inWords(sentence, language) === null));
  assert.deepEqual(missing, []);
  for (const sentence of english)
    for (const language of kOthers) {
      const words = inWords(sentence, language).replace(/\w+ = "[^"]*"|"[^"]*"|\[[^\]]*\]|\{[^}]*\}|\([^)]*\)/g, "");
      assert.doesNotMatch(words, /\{\d\}|\b(must|missing|write|the|opening|lintel|leave|outside|known)\b/, `${language}: ${sentence} -> ${words}`);
    }
  assert.equal(inWords("opening 1 (w) overlaps opening 0 (door)", "de"), "Öffnung 1 (w) überschneidet Öffnung 0 (door)");
  assert.equal(inWords('add cohesion = "0.15 MPa" (0 for a dry joint), compressive_strength = "3.96 MPa" or "unlimited"; or ask for rules, missing = "rule"; or take typical values, use = "NAME" (wythe materials)', "de"),
    'cohesion = "0.15 MPa" (0 für eine trockene Fuge), compressive_strength = "3.96 MPa" oder "unlimited" hinzufügen; oder Regeln verlangen, missing = "rule"; oder typische Werte nehmen, use = "NAME"');
  assert.equal(inWords("= a table", "de"), "= eine Tabelle"); // a value
  assert.equal(inWords("opening 1 (w) is what nobody has written down", "de"), null); // an opening's name says no more than that
  assert.equal(inWords("the sill of opening 0 (a) reaches into ring beam 1", "it"), "il davanzale dell’apertura 0 (a) e il cordolo 1 si sovrappongono");
  assert.equal(inWords("frame F1: is no corner of its own", "de"), null); // a part without a row
  assert.equal(inWords("what nobody has written down", "de"), null);
});

test("what the file does not state of its masonry has its source, its level or its rule", async () => {
  const { originsIn } = await viewerModule("studio/masonry/origins");
  const { find, parse } = await viewerModule("studio/file/toml");
  const taken = async (name) => (await ask("check", { model: example(name) }, ["model"])).texts.model;
  const of = (tables, name, key) => tables.find((table) => table.name === name).origins.find((o) => o.key === key);
  const portal = await taken("brick_portal/model.toml");
  const tables = originsIn(portal);
  assert.deepEqual(tables.map((table) => table.name), ["masonry", "material.joint", "material.unit"]);
  assert.deepEqual(of(tables, "masonry", "masonry_strength"), { key: "masonry_strength", value: "7.92 MPa", kind: "typical", by: "Magenes and Calvi 1992, CoV 0.17" });
  assert.deepEqual(of(tables, "material.joint", "cohesion"), { key: "cohesion", value: "0.21 MPa", kind: "derived", by: "c_from_fv0" });
  for (const { name, origins } of tables) assert.equal(origins.length, find(parse(portal), [...name.split("."), "origin"]).items.length, name);
  const palazzina = originsIn(await taken("palazzina/model.toml"));
  assert.equal(of(palazzina, "masonry", "friction_tan").by, "Circolare 21 January 2019 n. 7, Table C8.5.I, LC2");
  assert.deepEqual(originsIn(await taken("tuff_wall/model.toml")), []);
  assert.deepEqual(originsIn(""), []);
});

test("with the numbers that the panel asks for, an empty wall of any masonry of the list is built", async () => {
  const { kAsked } = await viewerModule("studio/masonry/masonry");
  const { kMaterials } = await viewerModule("studio/masonry/materials");
  const { parse, setValue, valueAt } = await viewerModule("studio/file/toml");
  const values = { unit_strength: '"15 MPa"', mortar_strength: '"2 MPa"', masonry_strength: '"4 MPa"', initial_shear_strength: '"0.15 MPa"', friction_tan: "0.6", youngs_modulus: '"2 GPa"', tensile_strength: '"1 MPa"' };
  const empty = /kEmpty = `([^`]*)`/.exec(fs.readFileSync(path.join(root, "web/src/studio/file/starters.ts"), "utf8"))[1];
  for (const masonry of kMaterials) {
    let text = empty.replace("clay_brick_old", masonry);
    for (const [key] of kAsked) {
      const at = key.split(".");
      if (valueAt(parse(text), at) === undefined) text = setValue(text, at, values[at.at(-1)]);
    }
    const { code, texts } = await ask("check", { model: text });
    assert.equal(code, 0, `${masonry}: ${texts.faults}`);
  }
});

test("why a limit load has no answer is said in each language", async () => {
  const { texts } = await ask("limit", { model: example("opening/after.toml"), only: ["lp"] });
  const [{ problem }] = JSON.parse(texts.faults);
  const cases = [
    [problem, "frame = F1", "bends and yields, and limit analysis knows no frames"],
    ["layer = FRCM: north: detaches and breaks, and limit analysis knows no layers; leave it out for this analysis; the run takes it", "layer = FRCM: north", "detaches and breaks, and limit analysis knows no layers"],
    ["layer = a = b; c: detaches and breaks, and limit analysis knows no layers; leave it out", "layer = a = b; c", "detaches and breaks, and limit analysis knows no layers"],
    ["wall: its linear programme was not solved: round-off is larger than the answer; look for joints", "wall", "its linear programme was not solved: round-off is larger than the answer"],
    ["wall: its limit load is not known: the theorems give 1.25e+03 and 1e+04; look for joints or blocks", "wall", "its limit load is not known: the theorems give 1.25e+03 and 1e+04"],
    ["wall.blocks.right.lintel0.zones: is a deformable block in space, and limit analysis in space knows rigid blocks alone; leave zones out", "wall.blocks.right.lintel0.zones", "is a deformable block in space, and limit analysis in space knows rigid blocks alone"],
    ["stage: what grows moves a support, and a limit load needs a force; run it", "stage", "what grows moves a support, and a limit load needs a force"],
    ["stage = tilt: east: the wall's limit tilt could not be found; use a body force", "stage = tilt: east", "the wall's limit tilt could not be found"],
  ];
  for (const [words, place, why] of cases) {
    assert.deepEqual(reasonOf({ problem: words, path: "limit load", value: "" }, ""), [place, why]);
    assert.deepEqual(reasonOf(undefined, words), [place, why]);
    for (const language of kOthers) assert.notEqual(inWords(why, language), null, why);
  }
  assert.match(inWords(cases[4][2], "it"), /1\.25e\+03 e 1e\+04/);
  assert.deepEqual(reasonOf({ problem: "odd: what nobody has written down", path: "wall.length", value: "3 m" }, ""), ["wall.length = 3 m", "odd: what nobody has written down"]);
});

test("notes on a wall and the reason of a run come in the language that is asked for", async () => {
  const model = example("tied_arch/model.toml");
  const notes = async (language) => JSON.parse((await ask("check", { model, language }, ["check"])).texts.check).notes;
  const english = await notes("en");
  assert.ok(english.length > 0);
  for (const language of kOthers) (await notes(language)).forEach((note, k) => assert.notEqual(note, english[k]));
  assert.equal((await ask("check", { model, language: "xx" })).code, 2);
});
