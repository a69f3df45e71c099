// A wall of two piers and a lintel, small enough for tests: 112 blocks, a second for
// each sample. Also with a deformable lintel, and in studies whose pushes end early.
import fs from "node:fs";
import path from "node:path";
import { folder, run } from "./helpers.mjs";

const joint = (name, ft, c, angle) => `
[material.${name}]
normal_stiffness = "20 GPa/m"
shear_stiffness = "8 GPa/m"
tensile_strength = "${ft} MPa"
cohesion = "${c} MPa"
friction_angle = "${angle} deg"
residual_friction_angle = "${angle} deg"
residual_cohesion = "0 MPa"
mode_1_energy = "6 N/m"
mode_2_energy = "150 N/m"
compressive_strength = "4 MPa"
compressive_energy = "12800 N/m"
`;

const kModel = `name = "small wall with a door"
note = "For tests: <script>alert('note')</script>"
[wall]
length = "1.86 m"
height = "1.32 m"
thickness = "0.31 m"
bond = "running"
[wall.unit]
length = "310 mm"
height = "110 mm"
split = "middle"
density = "1250 kg/m^3"
[[wall.opening]]
name = "door <script>alert('door')</script>"
x = "0.62 m"
y = "0 m"
width = "0.62 m"
height = "0.88 m"
lintel = { kind = "timber", depth = "110 mm", bearing = "155 mm", material = "timber" }
${joint("joint", 0.15, 0.15, 20)}${joint("unit", 0.23, 0.46, 38)}${joint("foundation", 0.15, 1.5, 45)}
[material.timber]
density = "500 kg/m^3"
youngs_modulus = "0.3 GPa"
shear_modulus = "0.125 GPa"
[[stage]]
name = "gravity"
[[stage]]
name = "precompression"
pier_load = "80 kN"
[[stage]]
name = "push <script>alert('stage')</script>"
at = { x = "0 m", y = "1.1 m", courses = 3 }
velocity = "6 mm/s"
damping = 0.1
until = "18 mm"
[solve]
point_rule = "corners" # the scenes of these tests were chosen with it
[output]
states = ["6 mm", "12 mm"]
`;

// A facade of eight piers and seven doors under a beam, pushed to the left.
function facadeModel() {
  const material = (name, strength, energy) => joint(name, strength, strength, 30).replace("6 N/m", `${energy} N/m`);
  const doors = Array.from(
    { length: 7 },
    (_, i) => `[[wall.opening]]
x = "${(0.6 + 1.5 * i).toFixed(1)} m"
y = "0 m"
width = "0.9 m"
height = "1.5 m"
lintel = { kind = "timber", depth = "150 mm", bearing = "300 mm", material = "timber" }
`,
  );
  return `name = "facade of eight piers"
[wall]
length = "11.1 m"
height = "2.1 m"
thickness = "0.3 m"
[wall.unit]
length = "600 mm"
height = "150 mm"
split = "none"
density = "1800 kg/m^3"
[wall.beam]
height = "300 mm"
density = "2500 kg/m^3"
joint = "strong"
${doors.join("")}${material("joint", 0.1, 6)}${material("strong", 5, 6000).replace("150 N/m", "9000 N/m")}
[material.timber]
density = "500 kg/m^3"
youngs_modulus = "10 GPa"
shear_modulus = "0.6 GPa"
[[stage]]
name = "gravity"
[[stage]]
name = "load"
beam_load = "200 kN"
[[stage]]
name = "push"
direction = "-x"
at = { beam = true }
velocity = "40 mm/s"
damping = 0.3
until = "45 mm"
[solve]
point_rule = "corners"
`;
}

const kStudy = `[study]
name = "small wall, <script>alert('study')</script>"
model = "model.toml"
samples = 24
seed = 11
states = ["6 mm", "12 mm"]
read_modes_at = "12 mm"
[variable.ft_j]
path = "material.joint.tensile_strength"
distribution = "lognormal"
mean = "0.15 MPa"
cov = 0.3
[variable.phi]
path = "material.joint.friction_angle"
distribution = "normal"
mean = "20 deg"
cov = 0.2
lower = "4 deg"
[variable.fc]
path = "material.joint.compressive_strength"
distribution = "uniform"
mean = "4 MPa"
cov = 0.2
[dependent.c_j]
path = "material.joint.cohesion"
formula = "1.0 * ft_j"
[dependent.phi_residual]
path = "material.joint.residual_friction_angle"
formula = "phi"
`;

const changed = (text, ...pairs) =>
  pairs.reduce((made, [from, to]) => {
    if (!made.includes(from)) throw new Error(`no ${from}`);
    return made.replace(from, to);
  }, text);
const kZones = changed(kModel, ['kind = "timber",', 'kind = "timber", model = "zones", zones = 2,']);
const kCyclic = changed(kModel, [
  'until = "18 mm"',
  'targets = ["2 mm", "-2 mm", "2 mm", "-2 mm", "6 mm", "-6 mm", "6 mm"]',
]);
// A tie between two blocks, one to a rigid anchor, the points of a floor, a wall across.
const kTied = `${changed(kModel, ['until = "18 mm"', 'until = "3 mm"'], ['states = ["6 mm", "12 mm"]', 'states = ["1 mm"]'])}
[[tie]]
name = "tie <script>alert('tie')</script>"
from = { x = "0.3 m", y = "1.05 m" }
to = { x = "1.55 m", y = "1.05 m" }
area = "100 mm^2"
youngs_modulus = "200 GPa"
prestress = "20 MPa"
[[tie]]
name = "anchored"
from = { x = "0.3 m", y = "0.5 m" }
anchored = true
to = { x = "-0.4 m", y = "0.5 m" }
area = "100 mm^2"
youngs_modulus = "200 GPa"
[[diaphragm]]
name = "floor"
y = "1.2 m"
x = ["0.2 m", "1.0 m", "1.7 m"]
stiffness = "50 MN"
[[spring]]
name = "neighbour"
at = { x = "1.8 m", y = "0.8 m" }
stiffness = "2 kN/mm"
`;
// Pushed no farther than that; drawn so that the inputs are correlated.
const shortModel = (until) =>
  changed(kModel, ['until = "18 mm"', `until = "${until}"`], ['states = ["6 mm", "12 mm"]', ""]);
// Joints of a typology, one energy by rule.
const kTypical = changed(
  shortModel("1 mm"),
  [joint("joint", 0.15, 0.15, 20), '[material.joint]\nuse = "tuff_pozzolanic"\nmode_1_energy = "rule"\n'],
);
const shortStudy = (model) =>
  changed(
    kStudy,
    ["model.toml", model],
    ["samples = 24", 'samples = 12\ndesign = "monte_carlo"'],
    ['states = ["6 mm", "12 mm"]\n', ""],
  );

export function writeInputs() {
  fs.mkdirSync(folder("inputs"), { recursive: true });
  for (const [name, text] of [
    ["model.toml", kModel],
    ["study.toml", kStudy],
    ["zones.toml", kZones],
    ["typical.toml", kTypical],
    ["cyclic.toml", kCyclic],
    ["tied.toml", kTied],
    ["rising_model.toml", shortModel("1 mm")], // hardly a wall reaches its peak
    ["rising.toml", shortStudy("rising_model.toml")],
    ["falling_model.toml", shortModel("12.5 mm")], // some fall below 0.8 of it to stay
    ["falling.toml", shortStudy("falling_model.toml")],
  ]) {
    // whole or not at all: other tests read them at the same time
    const draft = path.join(folder("inputs"), `${name}.${process.pid}`);
    fs.writeFileSync(draft, text);
    fs.renameSync(draft, path.join(folder("inputs"), name));
  }
}
export const input = (name) => path.join(folder("inputs"), name);

// Once for each folder of a file of tests: a second test that asks for the same gets what is there.
const kMade = new Map();

export function makeRun(name, model = "model.toml") {
  if (kMade.get(name) !== model) {
    writeInputs();
    fs.rmSync(folder(name), { recursive: true, force: true });
    run("run", input(model), "--out", folder(name), "--quiet");
    kMade.set(name, model);
  }
  return JSON.parse(fs.readFileSync(path.join(folder(name), "summary.json"), "utf8"));
}

export function makeFacade(name) {
  fs.mkdirSync(folder("inputs"), { recursive: true });
  fs.writeFileSync(path.join(folder("inputs"), "facade.toml"), facadeModel());
  return makeRun(name, "facade.toml");
}

// Two piers of which a code asks something, by an author; and 24 samples of it.
export function writeAssessed() {
  writeInputs();
  const code = `
[project]
title = "School <script>alert('project')</script>"
client = "Town of Pavia"
author = "A. Rossi"
date = "3 May 2027"
[assessment]
code = "circolare_2019"
record_scatter = 0.3
[assessment.spectrum]
kind = "en1998"
ground_acceleration = "1.5 m/s^2"
`;
  fs.writeFileSync(input("assessed.toml"), kModel + code);
  fs.writeFileSync(input("assessed_study.toml"), changed(kStudy, ['model = "model.toml"', 'model = "assessed.toml"']));
}

export function makeCampaign(name, ...more) {
  return makeCampaignOf("study.toml", name, ...more);
}

export function makeCampaignOf(study, name, ...more) {
  const asked = [study, ...more].join(" ");
  if (kMade.get(name) !== asked) {
    writeInputs();
    fs.rmSync(folder(name), { recursive: true, force: true });
    try {
      run("campaign", input(study), "--out", folder(name), "--quiet", ...more);
    } catch (error) {
      if (error.status !== 3) throw error; // no sample answered: the page says so
    }
    kMade.set(name, asked);
  }
  return JSON.parse(fs.readFileSync(path.join(folder(name), "statistics.json"), "utf8"));
}
