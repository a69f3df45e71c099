// The page of a run in space: drawings, motion, sections, selection, print.
import assert from "node:assert/strict";
import fs from "node:fs";
import path from "node:path";
import { after, before, test } from "node:test";
import { downloaded, folder, lastPoints, launch, open, pageOf, pdfPages, run } from "./helpers.mjs";
import { screenshot, viewerModule, violations } from "./helpers.mjs";

// Two short walls that meet, dry, pulled out of their plane: 15 blocks, a second. Far from the origin, as surveys
// are; a name with markup.
const kFar = 1200;
function writeWall() {
  const box = (id, x0, y0, z0, x1, y1, z1, more = {}) => ({
    id,
    polygon: [[x0, y0], [x1, y0], [x1, y1], [x0, y1]].map(([x, y]) => [x + kFar, y]),
    z: [z0, z1],
    ...more,
  });
  const blocks = [box("ground", -0.3, -0.2, -0.3, 1.5, 0, 1.1, { fixed: true })];
  for (let course = 0; course < 5; ++course) {
    const [y, top] = [0.2 * course, 0.2 * (course + 1)],
      toothed = course % 2 === 1;
    blocks.push(box(course === 4 ? "<b>front</b>5.1" : `front${course + 1}.1`, 0, y, 0, toothed ? 0.4 : 0.6, top, 0.2));
    blocks.push(box(`front${course + 1}.2`, toothed ? 0.4 : 0.6, y, 0, toothed ? 1 : 1.2, top, 0.2));
    blocks.push(
      toothed ? box(`side${course + 1}.1`, 1, y, 0, 1.2, top, 0.8) : box(`side${course + 1}.1`, 1, y, 0.2, 1.2, top, 0.8),
    );
  }
  fs.mkdirSync(folder("inputs"), { recursive: true });
  fs.writeFileSync(path.join(folder("inputs"), "space_blocks.json"), JSON.stringify({ units: "m", blocks }));
  fs.writeFileSync(
    path.join(folder("inputs"), "space.toml"),
    `name = "two walls that meet"
[wall]
blocks = "space_blocks.json"
[wall.unit]
density = "2000 kg/m^3"
[material.joint]
use = "limestone_dry"
normal_stiffness = "2 GPa/m"
shear_stiffness = "1 GPa/m"
friction_tan = 0.6
residual_friction_tan = 0.6
compressive_strength = "unlimited"
[[stage]]
name = "gravity"
[[stage]]
name = "force"
direction = "-z"
rate = "0.2 1/s"
factor = 1.0
[solve]
damping = 0.4
`,
  );
}

let browser, page, summary;
const solid = () => launch("--use-angle=swiftshader", "--enable-unsafe-swiftshader");
const canvas = () => page.locator("#wall .space-stage canvas").first();
// The picture as bytes, and the share of its pixels that are not paper.
const bytes = async () => (await canvas().screenshot()).toString("base64");
const inked = (on = page) =>
  on.locator("#wall .space-stage").evaluate((stage) => {
    const shown = stage.querySelector("canvas"),
      copy = document.createElement("canvas");
    [copy.width, copy.height] = [shown.width, shown.height];
    const to = copy.getContext("2d");
    return new Promise((done) =>
      requestAnimationFrame(() => {
        // a picture on WebGL can be read only in the task that draws it
        document.querySelector("#wall .space-stage canvas").dispatchEvent(new KeyboardEvent("keydown", { key: "+" }));
        to.drawImage(shown, 0, 0);
        const { data } = to.getImageData(0, 0, copy.width, copy.height);
        const [r, g, b] = data;
        let n = 0;
        for (let i = 0; i < data.length; i += 4) n += data[i] !== r || data[i + 1] !== g || data[i + 2] !== b ? 1 : 0;
        done(n / (copy.width * copy.height));
      }),
    );
  });
const choose = (css, value) => page.locator(`#wall ${css}`).selectOption(value);
const picked = () => page.locator("#wall .picked-body").innerText();

before(async () => {
  writeWall();
  fs.rmSync(folder("space_run"), { recursive: true, force: true });
  run("run", path.join(folder("inputs"), "space.toml"), "--out", folder("space_run"), "--quiet");
  summary = JSON.parse(fs.readFileSync(path.join(folder("space_run"), "summary.json"), "utf8"));
  browser = await solid();
  page = await open(browser, pageOf("space_run"));
});
after(() => browser?.close());

test("opens without errors or requests, and is accessible", async () => {
  assert.equal(summary.status, "collapsed");
  assert.deepEqual(page.faults, []);
  assert.deepEqual(await violations(page), []);
});

test("the wall is drawn, and no section that only a plane wall has", async () => {
  const share = await inked();
  assert.ok(share > 0.1 && share < 0.95, `${share} of the picture`);
  assert.equal(await page.locator("#wall .no-webgl").count(), 0);
  for (const css of ["#elements", "#wall svg.wall"]) assert.equal(await page.locator(css).count(), 0, css);
  for (const section of await page.locator("main > section:not(.print-only)").all())
    assert.ok((await section.innerText()).trim().split("\n").length > 1, await section.getAttribute("id"));
  await screenshot(page, "space_1440_light");
});

test("play moves it through the fall, up to the end", async () => {
  const slider = page.locator("#wall .time input");
  await slider.focus();
  await page.keyboard.press("Home");
  const [start, words] = [await bytes(), await page.locator("#wall .wall-caption").innerText()];
  const far = await page.evaluate(() => document.querySelectorAll("#wall .time input")[0].max);
  await page.locator("#wall .play").click();
  await page.waitForFunction(() => {
    const s = document.querySelector("#wall .time input");
    return s.value === s.max && document.querySelector("#wall .play").textContent === "▶";
  });
  assert.notEqual(await bytes(), start);
  assert.notEqual(await page.locator("#wall .wall-caption").innerText(), words);
  assert.ok(Number(far) > 40, `${far} states: those of the fall are among them`);
});

test("turning, views, colours and magnification change the picture", async () => {
  const seen = new Set([await bytes()]);
  const changes = async (what, act) => {
    await act();
    const now = await bytes();
    assert.ok(!seen.has(now), `${what} changes nothing`);
    seen.add(now);
  };
  for (const view of ["front", "side", "top"])
    await changes(view, () => page.locator(`#wall [data-view=${view}]`).click());
  await page.locator("#wall [data-view=oblique]").click();
  await canvas().focus();
  await changes("ArrowLeft", () => page.keyboard.press("ArrowLeft"));
  await changes("Shift+ArrowUp", () => page.keyboard.press("Shift+ArrowUp"));
  const box = await canvas().boundingBox();
  await changes("a drag", async () => {
    await page.mouse.move(box.x + 200, box.y + 100);
    await page.mouse.down();
    await page.mouse.move(box.x + 260, box.y + 130);
    await page.mouse.up();
  });
  await page.locator("#wall [data-view=oblique]").click();
  const selects = page.locator("#wall .controls").first().locator("select");
  for (const bodies of ["moved", "turned", "damage", "material", "group"])
    await changes(bodies, () => selects.nth(1).selectOption(bodies));
  await selects.nth(1).selectOption("stone");
  for (const faces of ["opening", "slip", "stress"]) await changes(faces, () => selects.nth(0).selectOption(faces));
  await selects.nth(0).selectOption("cracks");
  await changes("see through", () => page.locator("#wall .check input").check());
  await page.locator("#wall .check input").uncheck();
  await changes("magnification", () => page.locator("#wall input.scale").fill("3"));
  await page.locator("#wall input.scale").fill("0");
});

test("a section hides the blocks on one side, and says how many", async () => {
  const whole = await inked();
  await choose(".cut-axis", "x");
  const told = async () => (await page.locator("#wall .cut-told").innerText()).match(/x = ([\d.]+).*; (\d+) of (\d+)/s);
  const [, at, n, all] = await told();
  assert.ok(Math.abs(Number(at) - kFar - 0.6) < 1, at); // in the file's axes
  assert.equal(Number(all), summary.blocks);
  assert.ok(Number(n) > 0 && Number(n) < summary.blocks, n);
  assert.ok((await inked()) < whole);
  await page.locator("#wall .cut-at").fill("0");
  const low = Number((await told())[2]);
  await page.locator("#wall .cut-at").fill("200");
  const high = Number((await told())[2]);
  assert.deepEqual([low, high].sort((a, b) => a - b), [0, summary.blocks]);
  await page.locator("#wall .cut-at").fill("100");
  await page.locator("#wall .segment.lone").click();
  assert.notEqual((await told())[2], n);
  await screenshot(page, "space_section_1440_light", "#wall");
  await choose(".cut-axis", "");
  assert.ok(await page.locator("#wall .cut-told").isHidden());
});

test("a block that is pressed says its name, how far it moved and turned", async () => {
  await page.locator("#wall [data-view=oblique]").click();
  const box = await canvas().boundingBox();
  await page.mouse.click(box.x + 0.5 * box.width, box.y + 0.5 * box.height);
  assert.match(await picked(), /(front|side)(<.b>)?\d\.\d[^]*moved [\d.]+[^]*turned [\d.]+[^]*joints/);
  await canvas().focus();
  await page.keyboard.press("Escape");
  assert.equal((await picked()).trim(), "");
  // by its name; which is text, never markup
  await page.locator("#wall .find-body").fill("<b>front</b>5.1");
  assert.ok((await picked()).includes("<b>front</b>5.1"));
  await page.locator("#wall .find-body").fill("");
});

test("the pieces go out as PNG and CSV", async () => {
  const png = await downloaded(page, () => page.locator("#wall [data-export=png]").click());
  assert.equal(png.subarray(1, 4).toString(), "PNG");
  assert.ok(png.length > 5000);
  const csv = await downloaded(page, () => page.locator("#wall [data-export=csv]").click());
  const rows = csv.toString().trim().split("\n");
  assert.equal(rows.length, summary.joints + 1);
  assert.match(rows[0], /block_a.*block_b.*opening_mm/);
  assert.ok(rows.slice(1).every((r) => Number(r.split(",")[3]) > kFar - 1), "places are the file's");
});

test("paper shows pictures of it, in light colours from a dark page too", async () => {
  const dark = await open(browser, pageOf("space_run"), { scheme: "dark" });
  await dark.evaluate(() => window.dispatchEvent(new Event("beforeprint")));
  const pictures = await dark.locator(".pictures canvas, .a4-pictures canvas").evaluateAll((all) =>
    all.map((c) => {
      const { data } = c.getContext("2d").getImageData(0, 0, c.width, c.height);
      let other = 0;
      for (let i = 0; i < data.length; i += 4) other += data[i] !== data[0] ? 1 : 0;
      return [data[0], other / (c.width * c.height)];
    }),
  );
  assert.ok(pictures.length >= 2, `${pictures.length} pictures`);
  for (const [paper, share] of pictures) assert.ok(paper === 255 && share > 0.1, `${paper} ${share}`);
  assert.doesNotMatch(await dark.locator("#sheet").textContent(), /out-of-plane failure is not modelled/);
  await dark.evaluate(() => window.dispatchEvent(new Event("afterprint")));
  assert.equal(await dark.locator(".a4-pictures canvas").count(), 0);
  const pdf = await dark.pdf({ format: "A4" });
  assert.ok(pdfPages(pdf) <= 5, `${pdfPages(pdf)} pages`);
  assert.deepEqual(dark.faults, []);
  await dark.context().close();
});

test("a phone shows it without scrolling sideways, in Italian too", async () => {
  const italian = run("report", folder("space_run"), "--lang", "it");
  assert.ok(italian !== undefined);
  const phone = await open(browser, pageOf("space_run"), { width: 390 });
  assert.ok(await phone.evaluate(() => document.documentElement.scrollWidth <= window.innerWidth));
  assert.ok((await inked(phone)) > 0.1);
  assert.match(await phone.locator("#wall").innerText(), /Sezione[^]*Blocco/);
  await screenshot(phone, "space_390_light");
  await phone.context().close();
  run("report", folder("space_run"), "--lang", "en");
});

test("without WebGL it is painted, and the page says so", async () => {
  const flat = await launch("--disable-3d-apis");
  const other = await open(flat, pageOf("space_run"));
  assert.equal(await other.locator("#wall .no-webgl").count(), 1);
  assert.ok((await inked(other)) > 0.1);
  const before = await other.locator("#wall .space-stage").screenshot();
  await other.locator("#wall .time input").focus();
  await other.keyboard.press("Home");
  assert.ok(!before.equals(await other.locator("#wall .space-stage").screenshot()));
  const box = await other.locator("#wall .space-stage canvas").first().boundingBox();
  await other.mouse.click(box.x + 0.5 * box.width, box.y + 0.5 * box.height);
  assert.match(await other.locator("#wall .picked-body").innerText(), /moved/);
  await screenshot(other, "space_painted_1440_light", "#wall");
  assert.deepEqual(other.faults, []);
  await flat.close();
});

test("the page of a campaign in space shows the wall of each sample", async () => {
  fs.writeFileSync(
    path.join(folder("inputs"), "space_study.toml"),
    `[study]
model = "space.toml"
samples = 2
seed = 3
states = ["2 mm"]
[variable.kn]
path = "material.joint.normal_stiffness"
distribution = "uniform"
mean = "2 GPa/m"
cov = 0.2
`,
  );
  fs.rmSync(folder("space_campaign"), { recursive: true, force: true });
  run("campaign", path.join(folder("inputs"), "space_study.toml"), "--out", folder("space_campaign"), "--quiet");
  const other = await open(browser, pageOf("space_campaign"));
  assert.deepEqual(other.faults, []);
  assert.equal(await other.locator(".warning[role=alert]").count(), 0);
  await other.locator("#sample-number").fill("2");
  await other.keyboard.press("Tab");
  const stage = other.locator("#sample-wall .space-stage");
  await stage.waitFor();
  const blank = await stage.screenshot();
  await other.locator("#sample-wall [data-view=top]").click();
  assert.ok(!blank.equals(await stage.screenshot()));
  assert.match(await other.locator("#sample-wall .wall-caption").innerText(), /2/);
  await screenshot(other, "space_sample_1440_light", "#sample-wall");
  assert.deepEqual(other.faults, []);
  await other.context().close();
});

// --- what needs no page ------------------------------------------------------------------------------

// One unit cube whose centroid is at x.
function cubes(...x) {
  const corners = [-0.5, 0.5].flatMap((z) => [-0.5, 0.5].flatMap((y) => [-0.5, 0.5].map((dx) => [dx, y, z])));
  const faces = [[0, 2, 3, 1], [4, 5, 7, 6], [0, 1, 5, 4], [2, 6, 7, 3], [0, 4, 6, 2], [1, 3, 7, 5]];
  const n = x.length,
    upTo = (count, step) => Int32Array.from({ length: count + 1 }, (_, i) => step * i);
  return {
    count: n,
    free: n,
    joints: 0,
    middle: [0, 0, 0],
    load: null,
    names: x.map((_, i) => `cube${i}`),
    centroid: Float32Array.from(x.flatMap((at) => [at, 0, 0])),
    reach: new Float32Array(n).fill(Math.sqrt(0.75)),
    partBegin: upTo(n, 1),
    vertexBegin: upTo(n, 8),
    faceBegin: upTo(n, 6),
    cornerBegin: upTo(6 * n, 4),
    corner: Int32Array.from(x.flatMap(() => faces.flat())),
    vertex: Float32Array.from(x.flatMap((at) => corners.flatMap(([dx, y, z]) => [at + dx, y, z]))),
    low: [Math.min(...x) - 0.5, -0.5, -0.5],
    high: [Math.max(...x) + 0.5, 0.5, 0.5],
  };
}
const states = (solids, ...frames) => ({
  solids,
  count: frames.length,
  at: (f) => ({ moved: Float32Array.from(frames[f].moved), turned: Float32Array.from(frames[f].turned) }),
});

test("poses turn and move bodies as the engine does, and magnify up to a quarter turn", async () => {
  const { Poses } = await viewerModule("wall/space");
  const solids = cubes(0);
  const of = (turned, scale, moved = [0, 0, 0]) => new Poses(states(solids, { moved, turned })).set(0, scale);
  const near = (a, b) => a.forEach((v, k) => assert.ok(Math.abs(v - b[k]) < 1e-6, `${a} ${b}`));
  near(of([0, 0, Math.PI / 2], 1, [1, 2, 3]).place(0, Float32Array.from([1, 0, 0]), 0), [1, 3, 3]);
  near(of([0, 0, Math.PI / 8], 2).place(0, Float32Array.from([1, 0, 0]), 0), [Math.SQRT1_2, Math.SQRT1_2, 0]);
  near(of([0, 1, 0], 50).place(0, Float32Array.from([1, 0, 0]), 0), [0, 0, -1]); // no further
  near(of([0, 3, 0], 50).place(0, Float32Array.from([1, 0, 0]), 0), [Math.cos(3), 0, -Math.sin(3)]);
  const between = new Poses(states(solids, { moved: [0, 0, 0], turned: [0, 0, 0] }, { moved: [1, 0, 0], turned: [0, 0, 1] }));
  near(between.set(0.5, 1).place(0, Float32Array.from([0, 0, 0]), 0), [0.5, 0, 0]);
});

test("bodies stand where the engine's VTK files have them", async () => {
  const { unpack } = await viewerModule("base/bundle");
  const { Poses, readSolids, SolidStates } = await viewerModule("wall/space");
  const bundle = await unpack(new Uint8Array(fs.readFileSync(path.join(folder("space_run"), "report.data"))));
  const solids = readSolids(bundle),
    last = bundle.header.frames.length - 1,
    poses = new Poses(new SolidStates(bundle, solids)).set(last, 1);
  const points = lastPoints("space_run", "blocks");
  let k = 0;
  for (let b = 0; b < solids.free; ++b)
    for (let v = solids.vertexBegin[solids.partBegin[b]]; v < solids.vertexBegin[solids.partBegin[b + 1]]; ++v, k += 3) {
      const at = poses.place(b, solids.vertex, 3 * v);
      // 16 bits of the largest displacement (some 300 mm) and rotation
      for (let axis = 0; axis < 3; ++axis)
        assert.ok(Math.abs(at[axis] + solids.middle[axis] - points[k + axis]) < 2e-5, `${solids.names[b]}`);
    }
  assert.equal(k, points.length);
});

test("a ray finds the nearest body, and through a section the one behind", async () => {
  const { Camera, Planes, Poses } = await viewerModule("wall/space");
  const solids = cubes(0, 3),
    planes = new Planes(solids);
  const poses = new Poses(states(solids, { moved: [0, 0, 0, 0, 0, 0], turned: [0, 0, 0, 0, 0, 0] })).set(0, 1);
  const camera = Object.assign(new Camera(), { width: 100, height: 100, zoom: 10, turn: Math.PI / 2 }); // from +x
  assert.equal(planes.pick(camera, poses, null, 50, 50), 1);
  assert.equal(planes.pick(camera, poses, { axis: 0, at: 2, sense: 1 }, 50, 50), 0);
  assert.equal(planes.pick(camera, poses, { axis: 0, at: -1, sense: 1 }, 50, 50), -1);
  assert.equal(planes.pick(camera, poses, null, 90, 50), -1);
  assert.equal(planes.hidden(poses, { axis: 0, at: 2, sense: 1 }), 1);
  assert.equal(planes.hidden(poses, { axis: 0, at: 3, sense: 1 }), 0); // cut in two, not hidden
});

test("a section closes a body: its triangles have the area of the cut", async () => {
  const { Poses, sectionsOf } = await viewerModule("wall/space");
  const solids = cubes(0);
  const poses = new Poses(states(solids, { moved: [0, 0, 0], turned: [0, 0, Math.PI / 4] })).set(0, 1);
  let area = 0;
  for (const { line: [p, q], centre: m } of sectionsOf(solids, poses, { axis: 0, at: 0.2, sense: 1 })) {
    const [a, b] = [p, q].map((v) => v.map((c, k) => c - m[k]));
    area += Math.hypot(a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]) / 2;
  }
  assert.ok(Math.abs(area - 2 * (Math.SQRT1_2 - 0.2)) < 1e-5, `${area}`); // a diagonal less what the tilt takes
});

test("names are grouped by what stands before their numbers", async () => {
  const { groupOf } = await viewerModule("wall/space");
  assert.deepEqual(["front3.2", "left wall 12", "7", "key"].map(groupOf), ["front", "left wall", "", "key"]);
});
