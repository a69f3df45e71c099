// Unit tests of the viewer's parts without a browser: decoding, numbers, ticks, thinning, poses.
import assert from "node:assert/strict";
import fs from "node:fs";
import path from "node:path";
import { test } from "node:test";
import { deflateSync } from "node:zlib";
import { folder, lastPoints, viewerModule } from "./helpers.mjs";
import { makeRun } from "./small_study.mjs";

const { fromBase64, unpack } = await viewerModule("base/bundle");
const texts = await viewerModule("base/texts");
const { rangeOf, thinned, ticks } = await viewerModule("base/plot");
const { toCsv } = await viewerModule("base/export");
const wallModule = await viewerModule("wall/wall");

// A bundle as src/report/bundle.cpp lays it out.
function packed(header, arrays = [], version = 2) {
  const text = Buffer.from(JSON.stringify(header));
  const length = text.length + ((8 - ((12 + text.length) % 8)) % 8);
  const head = Buffer.alloc(12 + length, " ");
  head.write("WYTHE\0\0", 0, "latin1");
  head[7] = version;
  head.writeUInt32LE(length, 8);
  text.copy(head, 12);
  return new Uint8Array(deflateSync(Buffer.concat([head, ...arrays])));
}

test("base64 gives back every byte", () => {
  const bytes = Uint8Array.from({ length: 256 }, (_, i) => i);
  assert.deepEqual(fromBase64(Buffer.from(bytes).toString("base64")), bytes);
});

test("arrays of every type are read at their places, rounded ones as numbers", async () => {
  const arrays = Buffer.alloc(40);
  arrays.writeFloatLE(1.5, 0);
  arrays.writeFloatLE(-2, 4);
  arrays.writeInt32LE(-7, 8);
  arrays.writeInt16LE(-32767, 16);
  arrays.writeInt16LE(100, 18);
  arrays[24] = 255;
  const bundle = await unpack(
    packed(
      {
        kind: "run",
        arrays: {
          f: { type: "float32", at: 0, count: 2 },
          i: { type: "int32", at: 8, count: 1 },
          r: { type: "int16", at: 16, count: 2, step: 0.001 },
          b: { type: "uint8", at: 24, count: 1 },
        },
      },
      [arrays],
    ),
  );
  assert.deepEqual([...bundle.array("f")], [1.5, -2]);
  assert.deepEqual([...bundle.array("i")], [-7]);
  assert.ok(Math.abs(bundle.array("r")[0] + 32.767) < 1e-5);
  assert.equal(bundle.array("b")[0], 255);
  assert.ok(bundle.has("f") && !bundle.has("g"));
  assert.throws(() => bundle.array("g"), /lack g/);
});

test("damaged, foreign and newer data are told apart", async () => {
  const good = packed({ kind: "run", arrays: {} });
  await assert.rejects(unpack(good.slice(0, good.length - 6)), /damaged/);
  await assert.rejects(unpack(new Uint8Array([1, 2, 3])), /damaged/);
  await assert.rejects(
    unpack(new Uint8Array(deflateSync(Buffer.from("something else altogether")))),
    /not a report/,
  );
  await assert.rejects(unpack(packed({ arrays: {} }, [], 9)), /version 9/);
});

test("the engine's own data are read: counts agree with the header", async () => {
  const summary = makeRun("bundle_run");
  const bundle = await unpack(
    new Uint8Array(fs.readFileSync(path.join(folder("bundle_run"), "report.data"))),
  );
  assert.equal(bundle.header.kind, "run");
  assert.equal(bundle.header.wall.blocks, summary.blocks);
  const frames = bundle.header.frames.length;
  assert.ok(frames >= 20 && frames <= 70, `${frames} frames`);
  assert.equal(bundle.array("frame.ux").length, frames * summary.blocks);
  assert.equal(bundle.array("frame.opening").length, frames * summary.joints);
  // the curve is that of the CSV, to single precision
  const rows = fs
    .readFileSync(path.join(folder("bundle_run"), "force_displacement.csv"), "utf8")
    .trim()
    .split("\n")
    .slice(1)
    .map((l) => l.split(",").map(Number));
  const reaction = bundle.array("curve.reaction_kN");
  assert.equal(reaction.length, rows.length);
  rows.forEach((row, i) => assert.ok(Math.abs(row[3] - reaction[i]) <= 1e-6 * Math.max(1, Math.abs(row[3]))));
});

const unpackRun = (name) => unpack(new Uint8Array(fs.readFileSync(path.join(folder(name), "report.data"))));
async function lastPose(name) {
  const bundle = await unpackRun(name);
  const wall = wallModule.readWall(bundle),
    frames = new wallModule.Frames(bundle, wall);
  return new wallModule.Pose(wall, frames.at(frames.count - 1), 1);
}
// 16 bits of the largest displacement (some 20 mm) and single-precision outlines
const kNear = 2e-6;

test("a pose at scale 1 puts blocks where the engine's VTK files have them", async () => {
  makeRun("bundle_run");
  const pose = await lastPose("bundle_run"),
    points = lastPoints("bundle_run", "blocks");
  const { blocks, outlineBegin } = pose.wall;
  for (let b = 0, k = 0; b < blocks; ++b)
    for (let i = outlineBegin[b]; i < outlineBegin[b + 1]; ++i, ++k) {
      const [x, y] = pose.corner(b, i);
      assert.ok(Math.hypot(x - points[3 * k], y - points[3 * k + 1]) < kNear, `block ${b}`);
    }
});

test("zones of a deformable lintel lie where the VTK files have them, contacts on their edges", async () => {
  const summary = makeRun("bundle_zones", "zones.toml");
  const pose = await lastPose("bundle_zones"),
    points = lastPoints("bundle_zones", "zones");
  const { wall } = pose,
    { mesh } = wall;
  assert.equal(mesh.zone.length, 4 * summary.zones);
  assert.equal(wall.joints - mesh.joints, summary.zone_contacts);
  mesh.zone.forEach((node, k) => {
    const [x, y] = pose.node(mesh, node);
    assert.ok(Math.hypot(x - points[3 * k], y - points[3 * k + 1]) < kNear, `corner ${k}`);
  });
  // the lintel's outline and the ends of every contact stand on nodes or edges of the mesh
  const places = Array.from(mesh.nodeX, (_, n) => pose.node(mesh, n));
  const off = ([x, y]) => Math.min(...places.map(([u, v]) => Math.hypot(x - u, y - v)));
  for (let i = wall.outlineBegin[mesh.rigid]; i < wall.outlineBegin[mesh.rigid + 1]; ++i)
    assert.ok(off(pose.corner(mesh.rigid, i)) < kNear);
  for (let j = mesh.joints; j < wall.joints; ++j) {
    const [a, b] = [pose.joint(j, -1), pose.joint(j, 1)];
    const long = Math.hypot(a[0] - b[0], a[1] - b[1]);
    // a little longer or shorter than undeformed, as far as the lintel strains
    assert.ok(Math.abs(long / (2 * Math.hypot(wall.halfX[j], wall.halfY[j])) - 1) < 0.01, `contact ${j}`);
    assert.equal(wall.jointB[j], mesh.rigid);
  }
});

// A named array of the last state's zones.
function lastZones(name, array) {
  const file = fs
    .readdirSync(folder(name))
    .filter((n) => n.startsWith("state_zones"))
    .sort()
    .at(-1);
  const vtu = fs.readFileSync(path.join(folder(name), file), "utf8");
  const bytes = Buffer.from(new RegExp(`Name="${array}"[^>]*>([^<]*)<`).exec(vtu)[1], "base64");
  return new Float64Array(bytes.buffer.slice(bytes.byteOffset + 8, bytes.byteOffset + bytes.length));
}

test("stresses of zones are those of the VTK files, to 16 bits of the largest", async () => {
  const summary = makeRun("bundle_zones", "zones.toml");
  const { frame } = await lastPose("bundle_zones");
  const [first, second] = [lastZones("bundle_zones", "principal_1_MPa"), lastZones("bundle_zones", "principal_2_MPa")];
  assert.equal(frame.greater.length, summary.zones);
  assert.equal(first.length, summary.zones);
  const bundle = await unpackRun("bundle_zones");
  const step = (name) => 1e-6 * bundle.header.arrays[`frame.${name}`].step;
  first.forEach((v, z) => {
    assert.ok(Math.abs(1e-6 * frame.greater[z] - v) <= 0.51 * step("zone_greater") + 1e-7, `zone ${z}`);
    assert.ok(Math.abs(1e-6 * frame.smaller[z] - second[z]) <= 0.51 * step("zone_smaller") + 1e-7, `zone ${z}`);
    const larger = Math.abs(v) > Math.abs(second[z]) ? v : second[z];
    assert.ok(Math.abs(wallModule.zoneStress(frame, z) - larger) < 1e-3 * Math.max(1, Math.abs(larger)));
  });
});

test("stresses on the foundation carry the wall and its loads", async () => {
  makeRun("bundle_run");
  const bundle = await unpackRun("bundle_run"),
    { wall, frame } = await lastPose("bundle_run");
  let carried = 0; // kN
  for (let j = 0; j < wall.joints; ++j)
    if (wall.kind[j] === "foundation")
      carried -= 1e3 * wallModule.jointStress(wall, frame, j) * 2 * wall.halfX[j] * wall.thickness;
  const stood = bundle.header.weight_kN + 2 * 80; // two piers, pier_load = 80 kN
  // the push is slow, not static: the wall may move up and down by some per cent of its weight
  assert.ok(Math.abs(carried / stood - 1) < 0.03, `${carried} of ${stood} kN`);
  const steps = wallModule.stressSteps(wall, new wallModule.Frames(bundle, wall));
  assert.equal(steps.length, 6);
  steps.forEach((s, i) => assert.ok(i === 0 || s > steps[i - 1]));
});

test("drift limits keep their labels apart, in words or as numbers", async () => {
  const { limitRows } = await viewerModule("campaign/limits");
  const limits = [0.375, 0.5, 0.75, 1, 1.125, 1.5].map((v) => ({
    limit_drift_percent: v,
    label: "pier, rocking",
    state: "near collapse",
  }));
  for (const width of [300, 420, 700, 1200]) {
    const { labels, short, top } = limitRows(limits, [0, 1.6], width, 84);
    assert.equal(labels.length, limits.length);
    assert.ok(width < 1000 || !short);
    const long = (l) => 6.3 * `${l.limit.value} %${short ? "" : ` ${l.limit.words}`}`.length;
    const x = (l) => 56 + ((width - 84 - 56) * l.limit.value) / 1.6;
    const spans = labels.map((l) => [l.row, l.atRight ? x(l) - long(l) : x(l), l.atRight ? x(l) : x(l) + long(l)]);
    for (const [i, a] of spans.entries())
      for (const b of spans.slice(i + 1)) assert.ok(a[0] !== b[0] || a[2] <= b[1] || b[2] <= a[1], `${width}`);
    assert.ok(top >= 14 + 15 * (1 + Math.max(...labels.map((l) => l.row))));
  }
});

test("numbers read as in the engine, in both languages", () => {
  texts.speak("en");
  const cases = [
    [163.42, "163"],
    [11.04, "11"],
    [0.003514, "0.00351"],
    [-1234.5, "−1235"],
    [2.4e-7, "2.4·10⁻⁷"],
    [0, "0"],
    [NaN, "–"],
    [null, "–"],
  ];
  for (const [value, words] of cases) assert.equal(texts.num(value), words);
  assert.equal(texts.qty(1.25, "mm"), "1.25\u202fmm");
  texts.speak("it");
  assert.equal(texts.num(0.351), "0,351");
  assert.equal(texts.phrase("no such words"), "no such words");
  const toe = ["left toe of the right pier", "piede sinistro del maschio destro"];
  const fitted = ["half unit 155 mm -> 154.545 mm (-0.3 %)", "mezzo elemento 155 mm -> 154,545 mm (-0,3 %)"];
  texts.learn({ [toe[0]]: toe });
  assert.equal(texts.phrase(toe[0]), toe[1]);
  assert.equal(texts.phrase(fitted), "mezzo elemento 155 mm → 154,545 mm (−0,3\u202f%)");
  assert.equal(
    texts.phrase("Circolare 21 January 2019 n. 7, C8.7.1.3.1.1"),
    "Circolare 21 gennaio 2019 n. 7, C8.7.1.3.1.1",
  );
  texts.speak("en");
  assert.equal(texts.phrase(toe[0]), toe[0]);
  assert.equal(texts.phrase(fitted), "half unit 155 mm → 154.545 mm (−0.3\u202f%)");
  assert.equal(texts.phrase("crack width x 0.75"), "crack width × 0.75");
  texts.learn({});
});

test("ticks are round and inside, ranges hold their values, thinning keeps corners", () => {
  assert.deepEqual(ticks([0, 50], 10), [0, 5, 10, 15, 20, 25, 30, 35, 40, 45, 50]);
  assert.deepEqual(ticks([-0.35, 0.35], 5), [-0.2, 0, 0.2]);
  assert.deepEqual(rangeOf([3, null, NaN, 1]), [1, 3]);
  const [low, high] = rangeOf([5, 5]);
  assert.ok(low < 5 && high > 5);
  const corner = Array.from({ length: 101 }, (_, i) => [i, i < 50 ? 0 : i - 50]);
  assert.deepEqual(thinned(corner, 0.4), [
    [0, 0],
    [50, 0],
    [100, 50],
  ]);
});

test("CSV quotes what needs it and defuses formulas", () => {
  assert.equal(
    toCsv({
      head: ["a", 'b"c'],
      rows: [
        [1.5, "x,y"],
        [null, "=1+1"],
        [NaN, "-"],
      ],
    }),
    'a,"b""c"\n1.5,"x,y"\n,\'=1+1\n,\'-\n',
  );
});

// A block pressed down by 4 and pushed to the right by 3 hands both on: the line slants down to the right.
test("a force between blocks is drawn along itself", () => {
  const one = (v) => Float32Array.of(v);
  const wall = { joints: 1, length: 1, height: 1, halfX: one(0.5), halfY: one(0) };
  const frame = { compression: one(4), shear: one(3), eccentricity: one(0) };
  const [force] = wallModule.forcesOf(wall, frame, { joint: () => [0, 0] });
  const slope = (force.to[1] - force.from[1]) / (force.to[0] - force.from[0]);
  assert.ok(Math.abs(slope + 4 / 3) < 1e-6, `${slope}`);
});
