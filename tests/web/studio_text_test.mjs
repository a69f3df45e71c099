// The studio's edits of a model file: one value changes and every other byte stays; what cannot be drawn is told.
import assert from "node:assert/strict";
import fs from "node:fs";
import path from "node:path";
import { before, test } from "node:test";
import { root, viewerModule } from "./helpers.mjs";

let toml, drawing, units, faults, packed, arches, storeys, floors, ties, parts, dxf;
const example = (name, file = "model.toml") => fs.readFileSync(path.join(root, "examples", name, file), "utf8");
const lines = (text) => text.split("\n");
// Lines that differ, as [before, after].
const changes = (a, b) => lines(a).map((l, k) => [l, lines(b)[k]]).filter(([x, y]) => x !== y);

before(async () => {
  toml = await viewerModule("studio/file/toml");
  drawing = Object.assign({}, ...(await Promise.all(["reading", "stages", "parts/openings", "parts/storeys"].map((name) => viewerModule(`studio/${name}`)))));
  units = await viewerModule("studio/file/units");
  faults = await viewerModule("studio/file/faults");
  packed = await viewerModule("studio/file/packed");
  [arches, storeys, floors, ties, parts, dxf] = await Promise.all(["parts/arches", "parts/storeys", "parts/floors", "parts/ties", "parts/parts", "board/dxf"].map((name) => viewerModule(`studio/${name}`)));
});

test("every example is read, and reading changes nothing", () => {
  let read = 0;
  const folders = fs.readdirSync(path.join(root, "examples"), { withFileTypes: true }).filter((e) => e.isDirectory());
  for (const { name: dir } of folders)
    for (const file of fs.readdirSync(path.join(root, "examples", dir)).filter((f) => f.endsWith(".toml"))) {
      const doc = toml.parse(example(dir, file));
      assert.ok(doc.root.keys.size > 0, `${dir}/${file}`);
      ++read;
    }
  assert.ok(read > 15);
});

test("a value changes in place, and its comment keeps its column", () => {
  const text = example("tuff_wall");
  const longer = toml.setValue(text, ["wall", "opening", 0, "lintel", "zone_length"], '"155.25 mm"');
  assert.deepEqual(changes(text, longer), [['zone_length = "155 mm"', 'zone_length = "155.25 mm"']]);
  const [[, line]] = changes(text, toml.setValue(text, ["stage", 2, "damping"], "0.25"));
  assert.equal(line.indexOf("#"), lines(text).find((l) => l.startsWith("damping")).indexOf("#"));
});

test("a key that is missing comes after its sisters, a table where it belongs", () => {
  const text = example("brick_portal");
  const bond = toml.setValue(text, ["wall", "joint"], '"old"');
  assert.equal(lines(bond)[lines(bond).findIndex((l) => l.startsWith("fit ")) + 1], 'joint = "old"');
  const deep = toml.setValue(text, ["wall", "opening", 0, "sill", "kind"], '"stone"');
  assert.equal(toml.valueAt(toml.parse(deep), ["wall", "opening", 0, "sill", "kind"]), "stone");
  assert.ok(deep.indexOf("[wall.opening.sill]") < deep.indexOf("[masonry]"));
  const top = toml.setValue("# a remark\n\n[wall]\n", ["name"], '"n"');
  assert.equal(toml.valueAt(toml.parse(top), ["name"]), "n");
  assert.ok(top.startsWith("# a remark\n"));
});

// A panel may still show an opening that is gone: a table of the list's name would spoil the file.
test("a member that a list does not have takes no key", () => {
  for (const text of ['[[wall.opening]]\nx = "1 m"\n', "wall = { opening = [{ x = 1 }] }\n", "[wall]\n"])
    for (const path of [["wall", "opening", 3, "x"], ["wall", "opening", 3, "sill", "kind"]]) assert.equal(toml.setValue(text, path, '"2 m"'), text);
});

test("inline tables and lists in a line are edited where they stand", () => {
  const text = '[wall]\nopening = [ { x = "1 m", y = "0 m" }, { x = "3 m" } ] # two\n';
  assert.equal(toml.setValue(text, ["wall", "opening", 1, "x"], '"4 m"'), text.replace("3 m", "4 m"));
  assert.equal(toml.setValue(text, ["wall", "opening", 1, "y"], '"1 m"'), text.replace('{ x = "3 m" }', '{ x = "3 m", y = "1 m" }'));
  assert.equal(toml.removeAt(text, ["wall", "opening", 0]), '[wall]\nopening = [ { x = "3 m" } ] # two\n');
  assert.equal(toml.countAt(toml.parse(toml.appendTable(text, ["wall", "opening"], [["x", '"5 m"']])), ["wall", "opening"]), 3);
  assert.equal(toml.removeAt('a = { b = 1, c = 2 }\n', ["a", "c"]), "a = { b = 1 }\n");
  assert.equal(toml.setValue("a.b = 1\n", ["a", "c"], "2"), "a.b = 1\na.c = 2\n");
});

test("an opening is added and removed with its lintel, and all else is as it was", () => {
  for (const name of ["brick_portal", "brick_facade", "tuff_wall", "arch"]) {
    const text = example(name);
    const d = drawing.readDrawing(toml.parse(text));
    const more = drawing.addOpening(text, d, { x: 0.25, y: 0, width: 0.5, height: 1.2 }, "hatch");
    const now = drawing.readDrawing(toml.parse(more));
    assert.equal(now.openings.length, d.openings.length + 1, name);
    const { x, y, width, height, lintel } = now.openings.at(-1);
    assert.deepEqual({ x, y, width, height, lintel }, { x: 0.25, y: 0, width: 0.5, height: 1.2, lintel: true });
    const back = drawing.removeOpening(more, d.openings.length);
    assert.deepEqual(drawing.readDrawing(toml.parse(back)), d);
    for (const line of lines(text)) assert.ok(back.includes(line), `${name} lost ${line}`);
    if (find(text, "timber_face")) assert.equal(back, text, name);
  }
  function find(text, word) {
    return text.includes(`[material.${word}]`) && text.includes("[material.timber]");
  }
});

test("a lintel bears as far as there is masonry, and stays out where there is none", () => {
  const text = example("brick_portal");
  const d = drawing.readDrawing(toml.parse(text));
  const bearing = (x) => toml.valueAt(toml.parse(drawing.addOpening(text, d, { x, y: 0.5, width: 0.5, height: 0.5 }, "o")), ["wall", "opening", 1, "lintel", "bearing"]);
  assert.equal(bearing(0.375), "250 mm");
  assert.equal(bearing(0.125), "125 mm");
  assert.equal(bearing(0), undefined);
});

test("sizes keep their units and decimals, and the push goes along with the wall", () => {
  const text = example("tuff_wall");
  const d = drawing.readDrawing(toml.parse(text));
  const wider = drawing.setWallSize(text, d, 6.2, d.height + 0.5);
  assert.deepEqual(changes(text, wider), [
    ['length = "5.10 m"', 'length = "6.20 m"'],
    ['height = "3.62 m"', 'height = "4.12 m"'],
    ['at = { x = "0 m", y = "3.12 m", courses = 3 }', 'at = { x = "0 m", y = "3.62 m", courses = 3 }'],
  ]);
  assert.equal(drawing.setWallSize(text, d, d.length, d.height), text);
  const other = drawing.setDirection(text, d, "-x");
  assert.match(other, /at = \{ x = "5\.1 m", y = "3\.12 m", courses = 3 \}\ndirection = "-x"/);
  const back = drawing.setDirection(other, d, "+x");
  assert.deepEqual(drawing.pushOf(toml.parse(back)), drawing.pushOf(toml.parse(text)));
});

test("half as fast: what the file says is halved, a push that adapts gets both its speeds, anything else is left", () => {
  const stage = (lines) => `[wall]\nlength = "3 m"\n[[stage]]\nname = "push"\nat = { x = "0 m" }\n${lines}until = "20 mm"\n`;
  assert.equal(drawing.slower(stage('velocity = "10 mm/s" # fast\n')), stage('velocity = "5 mm/s"  # fast\n').replace("  #", " #"));
  assert.equal(drawing.slower(stage('velocity = "2 mm/s"\nfast_velocity = "0.04 m/s"\n')), stage('velocity = "1 mm/s"\nfast_velocity = "0.02 m/s"\n'));
  const adapts = toml.parse(drawing.slower(stage("")));
  const ofEngine = /kWaitingVelocity = ([\d.e-]+), kAdaptedVelocity = ([\d.e-]+)/.exec(fs.readFileSync(path.join(root, "include/wythe/parts/wall_spec.h"), "utf8"));
  const halves = ofEngine.slice(1).map((speed) => `${Number((500 * Number(speed)).toPrecision(6))} mm/s`);
  assert.deepEqual(["velocity", "fast_velocity"].map((key) => toml.valueAt(adapts, ["stage", 0, key])), halves);
  assert.equal(drawing.slower(stage('velocity = "some"\n')), null);
  assert.equal(drawing.slower(stage('velocity = "1e-7 m/s"\n')), stage('velocity = "5e-8 m/s"\n'));
  assert.equal(drawing.slower(stage('velocity = "0.3333333 mm/s"\n')), stage('velocity = "0.16666665 mm/s"\n'));
  assert.equal(drawing.slower('[wall]\nlength = "3 m"\n'), null);
});

test("twice as far: however short the push is, its length is doubled to its last digit", () => {
  const stage = (until) => `[[stage]]\nname = "push"\nat = { x = "0 m" }\nuntil = "${until}"\n`;
  for (const [until, twice] of [["20 mm", "40 mm"], ["0.02 mm", "0.04 mm"], ["1e-5 m", "0.00002 m"], ["1.23456 cm", "2.46912 cm"]]) assert.equal(drawing.farther(stage(until)), stage(twice));
  for (const none of [stage("2 parsec"), '[wall]\nlength = "3 m"\n']) assert.equal(drawing.farther(none), null);
});

test("storeys: openings stand on their floor, the last storey takes the height", () => {
  const text = example("brick_facade");
  const d = drawing.readDrawing(toml.parse(text));
  assert.equal(d.openings[3].y, 3.4 + 0.8);
  assert.ok(Math.abs(d.course - 0.085) < 1e-9 && Math.abs(d.half - 0.15) < 1e-9);
  const more = drawing.addOpening(text, d, { x: 8.8, y: 4.25, width: 0.5, height: 1 }, "window");
  assert.match(more, /name = "window 7"\nstorey = "first floor"\nx = "8\.80 m"\ny = "0\.85 m"/);
  const higher = drawing.setWallSize(text, d, d.length, d.height + 0.17);
  assert.deepEqual(changes(text, higher), [['height = "2.975 m"                 # 35 courses', 'height = "3.145 m"                 # 35 courses']]);
});

test("what cannot be drawn is refused with the place", () => {
  const refused = (text) => drawing.readDrawing(toml.parse(text));
  assert.deepEqual(refused('[[plan_wall]]\nname = "a"\n'), { why: "space", path: ["plan_wall"] });
  assert.deepEqual(refused('[wall]\nblocks = "s.json"\n'), { why: "blocks", path: ["wall", "blocks"] });
  assert.deepEqual(refused("[wall]\nlength = 3\n"), { why: "number", path: ["wall", "length"] });
  const far = '[wall]\nlength = "3 m"\nheight = "2 m"\n[[wall.opening]]\nx = "1 parsec"\n';
  assert.deepEqual(refused(far), { why: "number", path: ["wall", "opening", 0, "x"] });
});

test("broken texts give the line", () => {
  for (const [text, line] of [["a = 1\nb = \n", 2], ["[a\n", 1], ['a = "x\n', 1], ["a = 1\na = 2\n", 2], ["a = 1\n[b]\nc = [1, 2\n", 4], ["x\n", 1], ["[a]\n[a]\n", 2], [`a = ${"[".repeat(50)}`, 1], ["a = x y\n", 1]])
    assert.throws(() => toml.parse(text), (e) => e.line === line, JSON.stringify(text));
});

test("random edits leave a text that reads back what was set", () => {
  let seed = 7;
  const random = (n) => (seed = (seed * 1103515245 + 12345) % 2147483648) % n;
  for (const name of ["brick_facade", "tuff_wall", "palazzina", "ring_beam"]) {
    let text = example(name);
    for (let k = 0; k < 200; ++k) {
      const doc = toml.parse(text);
      const d = drawing.readDrawing(doc);
      const box = { x: random(40) / 10, y: d.storeys[0] ? random(10) / 10 : random(10) / 10, width: (1 + random(20)) / 10, height: (1 + random(9)) / 10 };
      const which = d.openings.length > 0 ? random(d.openings.length) : -1;
      if (which < 0 || random(3) === 0) {
        text = drawing.addOpening(text, d, box, "o", random(2) === 0);
        const made = drawing.readDrawing(toml.parse(text)).openings.at(-1);
        for (const key of ["x", "y", "width", "height"]) assert.ok(Math.abs(made[key] - box[key]) < 1e-4);
      } else if (random(3) === 0) {
        const left = d.openings.filter((_, i) => i !== which).map((o) => o.name);
        text = drawing.removeOpening(text, which);
        assert.deepEqual(drawing.readDrawing(toml.parse(text)).openings.map((o) => o.name), left);
      } else {
        const o = d.openings[which];
        box.y += o.foot;
        text = drawing.setOpening(text, which, box, o.foot);
        const moved = drawing.readDrawing(toml.parse(text)).openings[which];
        for (const key of ["x", "y", "width", "height"]) assert.ok(Math.abs(moved[key] - box[key]) < 1e-4, `${moved[key]} ${box[key]}`);
      }
    }
    for (const line of lines(example(name)).filter((l) => l.startsWith("#"))) assert.ok(text.includes(line), line);
  }
});

test("storeys, floors, ties and arches drawn at random leave a text that reads back, with every remark", () => {
  let seed = 11;
  const random = (n) => (seed = (seed * 1103515245 + 12345) % 2147483648) % n;
  const close = (a, b, what) => assert.ok(Math.abs(a - b) < 2e-4, `${what}: ${a} ${b}`);
  for (const name of ["brick_portal", "palazzina", "tied_arch", "ring_beam"]) {
    let text = example(name);
    const read = () => drawing.readDrawing(toml.parse(text));
    for (let k = 0; k < 120; ++k) {
      const d = read();
      const y = ((1 + random(98)) / 100) * d.height;
      const kind = ["storey", "floor", "tie"][random(3)];
      const list = { storey: d.storeys, floor: d.floors, tie: d.ties }[kind];
      const which = random(Math.max(1, list.length));
      const tops = d.openings.map((o) => o.y);
      if (random(5) === 0 && d.openings.length > 0) {
        const o = random(d.openings.length);
        const head = arches.kHeads[random(5)];
        text = arches.setHead(text, d, o, head);
        const now = arches.headOf(read().openings[o]);
        assert.ok(now === head || (head === "lintel" && now === "none"), `${head} ${now}`); // no room to bear on
      } else if (list.length < 2 || random(3) === 0) {
        if (kind === "storey" && (d.storeys.some((s) => Math.abs(s.foot - y) < 0.1) || storeys.cutBy(d, y) || d.height > 30)) continue;
        text = kind === "storey" ? storeys.addStorey(text, d, y, (n) => `storey ${n}`) : kind === "floor" ? floors.addFloor(text, d, y, "floor") : ties.addTie(text, d, { x: 0.1, y }, { x: d.length - 0.1, y }, "tie");
        if (kind === "storey") read().openings.forEach((o, i) => close(o.y, tops[i], "an opening moved"));
        if (kind === "floor") assert.ok(Math.abs(read().floors.at(-1).y - y) < 0.011);
      } else if (random(2) === 0) {
        if (kind === "storey" && which === 0) continue;
        text = parts.removePart(text, d, { kind, k: which });
        const now = read();
        assert.equal({ storey: now.storeys, floor: now.floors, tie: now.ties }[kind].length, list.length - 1);
        if (kind === "storey") {
          now.openings.forEach((o, i) => close(o.y, tops[i], "an opening moved"));
          now.floors.forEach((f, i) => close(f.y, d.floors[i].y, "a floor moved"));
        }
      } else if (kind === "floor") {
        text = floors.moveFloor(text, d, which, y);
        assert.ok(Math.abs(read().floors[which].y - y) < 0.011);
        text = floors.setHold(text, read(), which, floors.kHolds[random(3)]);
      } else if (kind === "tie" && d.ties[which].from) {
        text = ties.setTieEnds(text, which, { x: 0.2, y }, { x: 1, y });
        close(read().ties[which].to.y, y, "tie");
      } else if (kind === "storey" && which > 0) {
        const line = d.storeys[which - 1].foot + ((1 + random(8)) / 10) * (d.storeys[which].foot + d.storeys[which].height - d.storeys[which - 1].foot);
        text = storeys.moveStoreyLine(text, d, which, line);
        close(read().storeys[which].foot, line, "line");
        close(read().height, d.height, "height");
      }
    }
    for (const line of lines(example(name)).filter((l) => l.startsWith("#"))) assert.ok(text.includes(line), line);
  }
});

test("a storey that is parted keeps its own masonry in both halves", () => {
  const text = example("palazzina");
  const d = drawing.readDrawing(toml.parse(text));
  const more = storeys.addStorey(text, d, 8.06, () => "attic");
  assert.match(more, /height = "1\.56 m"[^\n]*\nthickness = "0\.30 m"[^\n]*\n\n\[\[storey\]\]\nname = "attic"\nheight = "1\.30 m"\nthickness = "0\.30 m"\n/);
  const middle = storeys.addStorey(text, d, 1.3, () => "mezzanine");
  assert.match(middle, /height = "1\.30 m"[^\n]*\n\n\[\[storey\]\]\nname = "mezzanine"\nheight = "2\.08 m"\n\n\[\[storey\]\]\nname = "first floor"/);
});

// A wall of two storeys of 3 m and 2 m, with a beam on the first one's top.
const kHouse = `[wall]
length = "5 m"
height = "5 m"
[[storey]]
name = "low"
height = "3 m"
[[storey]]
name = "high"
height = "2 m"
[[ring_beam]]
storey = "low" # a beam
height = "250 mm"
[[ring_beam]]
storey = "high"
height = "250 mm"
`;
const read = (text) => drawing.readDrawing(toml.parse(text));

test("a storey's line that goes leaves ring beams, boxes and polygons of regions at their height", () => {
  const text = `${kHouse}[[region]]\nstorey = "high"\nx = "1 m"\ny = "0.5 m"\nwidth = "1 m"\nheight = "1 m"\n[[region]]\nstorey = "high"\npolygon = [["0 m", "0 m"], ["1 m", "0 m"], ["0 m", "1.5 m"]]\n[[region]]\nstorey = "low"\nx = "1 m"\ny = "0.5 m"\nwidth = "1 m"\nheight = "1 m"\n`;
  const out = storeys.removeStoreyLine(text, read(text), 1);
  assert.match(out, /\[\[ring_beam\]\]\ny = "2\.75 m" # a beam\nheight = "250 mm"\n\[\[ring_beam\]\]\nstorey = "low"\nheight = "250 mm"/);
  assert.match(out, /storey = "low"\nx = "1 m"\ny = "3\.5 m"\nwidth/);
  assert.match(out, /storey = "low"\npolygon = \[\["0 m", "3 m"\], \["1 m", "3 m"\], \["0 m", "4\.5 m"\]\]/);
  assert.match(out, /storey = "low"\nx = "1 m"\ny = "0\.5 m"/);
  assert.doesNotMatch(out, /high/);
  const odd = kHouse.replace('height = "250 mm"', 'height = "a foot"');
  assert.equal(storeys.removeStoreyLine(odd, read(odd), 1), null);
});

test("a line is refused where a region is as high as the storey", () => {
  const region = (lines) => `${kHouse}[[region]]\njoint = "old"\n${lines}\n`;
  const add = (text, y) => storeys.addStorey(text, read(text), y, (n) => `storey ${n}`);
  for (const whole of ["", "pier = 1\n"]) {
    for (const name of ["low", "high"]) {
      const text = region(`${whole}storey = "${name}"`);
      assert.equal(storeys.removeStoreyLine(text, read(text), 1), null, text);
      assert.equal(parts.removePart(text, read(text), { kind: "storey", k: 1 }), null);
      assert.equal(add(text, name === "low" ? 1.5 : 4), null, text);
      assert.notEqual(add(text, name === "low" ? 4 : 1.5), null, text);
      assert.notEqual(add(text, 7), null, text);
    }
  }
  const bare = '[wall]\nlength = "5 m"\nheight = "5 m"\n[[region]]\npier = 1\njoint = "old"\n';
  assert.equal(add(bare, 2.5), null);
  const box = bare.replace("pier = 1", 'x = "1 m"\ny = "1 m"\nwidth = "1 m"\nheight = "1 m"');
  assert.match(add(box, 2.5), /name = "storey 1"/);
});

test("moves by the keys are one step as long as the same part is selected", async () => {
  const { Project } = await viewerModule("studio/project");
  const project = new Project();
  const text = example("brick_facade");
  const nudged = (x) => project.change(drawing.setOpening(project.text, 0, { ...project.drawing.openings[0], x }), 0, "nudge 0");
  project.open(text);
  project.select(0);
  nudged(1.01);
  nudged(1.02);
  const then = project.text;
  project.select(1);
  project.select(0);
  nudged(1.03);
  project.undo();
  assert.equal(project.text, then);
  project.undo();
  assert.equal(project.text, text);
});

test("keys with dots go together, in lines and in braces", () => {
  const text = '[[wall.opening]]\narch.kind = "round" # above\nx = "1 m"\narch.depth = "0.25 m"\narch.a.b = 1\nwidth = "1 m"\n';
  assert.equal(toml.removeAt(text, ["wall", "opening", 0, "arch"]), '[[wall.opening]]\nx = "1 m"\nwidth = "1 m"\n');
  assert.equal(toml.removeAt(text, ["wall", "opening", 0, "arch", "a"]), text.replace("arch.a.b = 1\n", ""));
  const row = "a = { b.c = 1, d = 2, b.e = 3 }\n";
  assert.equal(toml.removeAt(row, ["a", "b"]), "a = { d = 2 }\n");
  assert.equal(toml.removeAt(row, ["a", "b", "c"]), "a = { d = 2, b.e = 3 }\n");
  assert.equal(toml.removeAt("a = { b.c = 1, b.e = 3 }\n", ["a", "b"]), "a = {  }\n");
  assert.equal(toml.removeAt("a.b = 1\nc = 2\na.d = 3", ["a"]), "c = 2\n");
  const wall = `[wall]\nlength = "5 m"\nheight = "3 m"\n[[wall.opening]]\nname = "o"\nx = "2 m"\ny = "0 m"\nwidth = "1 m"\nheight = "1.5 m"\narch.kind = "round"\narch.depth = "0.25 m"\n`;
  const d = drawing.readDrawing(toml.parse(wall));
  assert.doesNotMatch(arches.setHead(wall, d, 0, "none"), /arch/);
  const lintel = wall.replace("arch.kind", "lintel.kind").replace("arch.depth", "lintel.depth");
  assert.doesNotMatch(drawing.removeLintel(lintel, 0), /lintel/);
});

test("a quantity that cannot be read counts as unknown, not as nothing", () => {
  const floor = (lines) => floors.readFloors(toml.parse(`[[floor]]\n${lines.join("\n")}\n`), [], 5)[0].load;
  const close = (a, b) => assert.ok(Math.abs(a - b) < 1e-6, `${a} ${b}`);
  const span = 'span = "4 m"';
  close(floor(['g1 = "3 kN/m^2"', 'g2 = "300 daN/m^2"', span]), 12000);
  close(floor(['load = "1200 kgf/m"']), 1200 * 9.80665);
  close(floor(['g1 = "3 kN/m2"', 'q = "2 kN/m^2"', "psi2 = 0.5", span]), 8000);
  assert.equal(floor([]), 0);
  assert.equal(floor(['mass = "1200 kg/m"']), 0);
  for (const bad of [['load = "12 stone/m"'], ['load = "1200 kg/m"'], ['g1 = "300 kg/m^2"', span], ['g1 = "3 kN/m^2"', 'g2 = "some"', span], ['g1 = "3 kN/m^2"', 'span = "wide"'], ['g1 = "3 kN/m^2"', 'psi2 = "half"', span], ["load = 12"]])
    assert.equal(floor(bad), null, bad.join());
  const tie = (lines) => ties.readTies(toml.parse(`[[tie]]\n${lines.join("\n")}\n`))[0];
  close(tie(['area = "3.14e-4 m^2"']).area, 3.14e-4);
  const odd = tie(['area = "a bar"', 'prestress = "40 MPa"', 'yield_strength = "high"']);
  assert.deepEqual([odd.area, odd.yields, ties.forceOf(odd), ties.setTieForce("", odd, 0, 1000)], [null, null, null, null]);
  assert.deepEqual([tie([]).area, tie([]).prestress, tie([]).yields], [0, 0, Infinity]);
  assert.equal(units.readQuantity("1200 kg/m").base, "kg/m");
  assert.equal(units.readQuantity("2 m2").value, 2);
});

test("a DXF with bulges next to nothing, angles of many turns, numbers that are none or too many points", () => {
  const file = (text) => ["0", "SECTION", "2", "ENTITIES", ...text.split(" "), "0", "ENDSEC", ""].join("\n");
  const { paths } = dxf.readDxf(file("0 LWPOLYLINE 10 0 20 0 42 1e-300 10 2 20 0 42 -1e-12 10 2 20 1"));
  assert.deepEqual(paths, [[[0, 0], [2, 0], [2, 1]]]);
  const turn = (from, to) => dxf.readDxf(file(`0 ARC 10 0 20 0 40 1 50 ${from} 51 ${to}`)).paths[0].length - 1;
  assert.equal(turn(0, 90), 8);
  assert.equal(turn(0, 3690), 8);
  assert.equal(turn(350, 80), 8);
  assert.equal(turn(0, 360), 32);
  assert.ok(turn(0, 1e12) <= 33);
  const odd = dxf.readDxf(file("0 LINE 10 x 20 0 11 1 21 1 0 CIRCLE 10 0 20 0 40 1e999 0 LINE 10 0 20 0 11 1 21 1"));
  assert.deepEqual([odd.paths.length, odd.skipped], [1, 2]);
  assert.equal(dxf.readDxf(file(Array(7000).fill("0 CIRCLE 10 0 20 0 40 1").join(" "))), null);
  assert.equal(dxf.readDxf(file(`0 LWPOLYLINE ${Array(7000).fill("10 0 20 0 42 1 10 1 20 0 42 1").join(" ")}`)), null);
});

test("lengths as people type them", () => {
  const close = (a, b) => assert.ok(Math.abs(a - b) < 1e-12, `${a} ${b}`);
  close(units.typedLength("1,25"), 1.25);
  close(units.typedLength(" 80 cm"), 0.8);
  close(units.typedLength("310mm"), 0.31);
  for (const bad of ["", "x", "1.2.3", "1 kg", "1e999"]) assert.equal(units.typedLength(bad), null, bad);
  assert.equal(units.typedQuantity("70", "60 kN"), "70 kN");
  assert.equal(units.typedQuantity("0,3", "0.2 MPa"), "0.3 MPa");
  assert.equal(units.typedQuantity("3 m", "60 kN"), null);
  assert.equal(units.writeQuantity(0.1 + 0.2, "m", "0.00"), "0.30 m");
  assert.equal(units.writeQuantity(0.146, "mm"), "146 mm");
});

test("a cure that is a value can be done; an example cannot", () => {
  const doc = toml.parse(example("brick_facade"));
  const fault = (path, cure) => ({ line: 1, path, value: "", problem: "", cure });
  assert.deepEqual(faults.editsOf(fault("wall.bond", 'did you mean "running"?'), doc), [[["wall", "bond"], '"running"']]);
  const both = 'write x = "9.15 m" and width = "0.15 m", on the joint lines every 150 mm';
  assert.deepEqual(faults.editsOf(fault("wall.opening.2.width", both), doc), [
    [["wall", "opening", 2, "x"], '"9.15 m"'],
    [["wall", "opening", 2, "width"], '"0.15 m"'],
  ]);
  assert.equal(faults.editsOf(fault("wall.opening.2.x", 'write it with its unit, e.g. x = "1.70 m"'), doc), null);
  assert.equal(faults.editsOf(fault("stage", 'write [[stage]] and under it name = "gravity"'), doc), null);
});

test("a link gives the text back, and refuses what is none", async () => {
  const text = example("brick_facade") + "# è così ✓\n";
  const link = await packed.toLink(text);
  assert.match(link, /^[A-Za-z0-9_-]+$/);
  assert.ok(link.length < 4000, `${link.length}`);
  assert.equal(await packed.fromLink(link), text);
  await assert.rejects(packed.fromLink("%%%"));
  await assert.rejects(packed.fromLink("AAAA"));
  await assert.rejects(packed.fromLink(await packed.toLink("a".repeat(3 << 20))), /too long/);
});
