// Links in the view of a wall in space, and the mechanism
// of its limit analysis there: drawings, texts, print.
import assert from "node:assert/strict";
import fs from "node:fs";
import path from "node:path";
import { after, before, test } from "node:test";
import { folder, launch, open, pageOf, pdfPages, run, screenshot, violations } from "./helpers.mjs";

// Two piers that a slab lies on; one is pushed out. A thin tie yields, a second one hangs slack on the near side, a spring
// holds the other pier.
const kModel = `name = "two piers, a slab and what holds them"
[wall]
height = "1.2 m"
thickness = "0.3 m"
[wall.unit]
length = "1.2 m"
height = "0.4 m"
density = "2000 kg/m^3"
split = "none"
[[plan_wall]]
name = "left"
line = [["0 m", "0 m"], ["0 m", "1.2 m"]]
[[plan_wall]]
name = "right"
line = [["3 m", "0 m"], ["3 m", "1.2 m"]]
[[slab]]
name = "deck"
walls = ["left", "right"]
bearing = "150 mm"
thickness = "0.2 m"
material = "concrete"
load = "2 kPa"
[material.concrete]
density = "2500 kg/m^3"
[material.joint]
use = "limestone_dry"
normal_stiffness = "5 GPa/m"
shear_stiffness = "2 GPa/m"
friction_tan = 0.6
residual_friction_tan = 0.6
compressive_strength = "unlimited"
[[tie]]
name = "thin tie"
from = { x = "0 m", y = "1 m", z = "0.3 m" }
to = { x = "3 m", y = "1 m", z = "0.3 m" }
area = "3 mm^2"
youngs_modulus = "200 GPa"
yield_strength = "235 MPa"
[[tie]]
name = "back tie"
from = { x = "0 m", y = "1 m", z = "0.9 m" }
to = { x = "-2 m", y = "1 m", z = "0.9 m" }
anchored = true
area = "100 mm^2"
youngs_modulus = "200 GPa"
yield_strength = "235 MPa"
[[spring]]
name = "neighbour"
at = { x = "3.15 m", y = "1 m", z = "0.6 m" }
direction = "+x"
stiffness = "1 MN/m"
[[stage]]
name = "gravity"
[[stage]]
name = "push"
at = { block = "left.c02*" }
direction = "-x"
velocity = "20 mm/s"
until = "30 mm"
`;

let browser, page;
before(async () => {
  fs.mkdirSync(folder("inputs"), { recursive: true });
  const model = path.join(folder("inputs"), "space_links.toml");
  fs.writeFileSync(model, kModel);
  for (const out of ["space_links", "space_limit"]) fs.rmSync(folder(out), { recursive: true, force: true });
  run("run", model, "--out", folder("space_links"), "--quiet");
  run("limit", model, "--out", folder("space_limit"), "--only", "lp");
  browser = await launch("--use-angle=swiftshader", "--enable-unsafe-swiftshader");
  page = await open(browser, pageOf("space_links"));
});
after(() => browser?.close());

const told = (on) => on.locator("#wall .link-forces").innerText();

test("links are told with force and state, those that have yielded first", async () => {
  assert.deepEqual(page.faults, []);
  const lines = (await told(page)).split("\n");
  assert.equal(lines.length, 3);
  // 235 MPa x 3 mm²
  assert.match(lines[0], /^thin tie: 0\.705.kN, has yielded$/);
  assert.match(lines[1], /^back tie: 0.*slack or open$/);
  assert.match(lines[2], /^neighbour: /);
  await page.locator("#wall .time input").focus();
  await page.keyboard.press("Home");
  assert.doesNotMatch(await told(page), /yielded/);
  await page.keyboard.press("End");
  assert.match(await told(page), /yielded/);
  assert.match(await page.locator("#wall .wall-key").innerText(), /holds[^]*slack or open[^]*has yielded/);
});

// A link is drawn above the blocks: in the colour of what has yielded there is nothing else when joints show nothing.
test("a link that has yielded has its colour in the picture", async () => {
  const coloured = () =>
    page.locator("#wall .space-stage .over").evaluate((over) => {
      const probe = document.createElement("canvas").getContext("2d");
      probe.fillStyle = getComputedStyle(document.documentElement).getPropertyValue("--open").trim();
      probe.fillRect(0, 0, 1, 1);
      const [r, g, b] = probe.getImageData(0, 0, 1, 1).data,
        { data } = over.getContext("2d").getImageData(0, 0, over.width, over.height);
      let n = 0;
      for (let i = 0; i < data.length; i += 4)
        n += Math.abs(data[i] - r) + Math.abs(data[i + 1] - g) + Math.abs(data[i + 2] - b) < 12 && data[i + 3] > 200 ? 1 : 0;
      return n;
    });
  await page.locator("#wall .time input").focus();
  await page.keyboard.press("Home");
  assert.equal(await coloured(), 0);
  await page.keyboard.press("End");
  assert.ok((await coloured()) > 100, "the tie from pier to pier");
  await screenshot(page, "space_links_1440_light", "#wall");
});

test("what is taken for granted, and where loads lie, is that of a wall in space", async () => {
  const text = await page.locator("main").evaluate((main) => main.textContent);
  assert.doesNotMatch(text, /works in its own plane/);
  assert.doesNotMatch(text, /\bnan\b/);
  assert.match(text, / m\) – \(/); // from, to
});

// Of a tie that holds and one that has yielded nobody should have to compare two blues.
test("what holds and what has yielded have colours that nobody mixes up", async () => {
  for (const scheme of ["light", "dark"]) {
    await page.emulateMedia({ colorScheme: scheme });
    const apart = await page.locator("#wall .link-mark").evaluateAll((marks) => {
      const colour = (mark) => getComputedStyle(mark).stroke.match(/\d+/g).slice(0, 3).map(Number),
        of = (name) => marks.find((mark) => mark.classList.contains(name)),
        [a, b] = [colour(of("holds")), colour(of("yielded"))];
      return Math.hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]);
    });
    assert.ok(apart > 150, `${scheme}: ${apart} of 441`);
  }
  await page.emulateMedia({ colorScheme: "light" });
});

test("on a phone and on paper too, in Italian too", async () => {
  const phone = await open(browser, pageOf("space_links"), { width: 390 });
  assert.ok(await phone.evaluate(() => document.documentElement.scrollWidth <= window.innerWidth));
  assert.match(await told(phone), /thin tie/);
  await screenshot(phone, "space_links_390_light", "#wall");
  await phone.context().close();
  const pdf = await page.pdf({ format: "A4" });
  assert.ok(pdfPages(pdf) <= 5, `${pdfPages(pdf)} pages`);
  run("report", folder("space_links"), "--lang", "it");
  const italian = await open(browser, pageOf("space_links"));
  assert.match(await told(italian), /snervato/);
  await italian.context().close();
  run("report", folder("space_links"), "--lang", "en");
});

test("the page of a limit analysis plays the mechanism in space", async () => {
  const limit = await open(browser, pageOf("space_limit"));
  assert.deepEqual(limit.faults, []);
  assert.deepEqual(await violations(limit), []);
  const stage = limit.locator("#collapse .space-stage canvas").first();
  assert.equal(await stage.count(), 1);
  const last = await stage.screenshot();
  await screenshot(limit, "space_limit_1440_light", ".collapse-in-space");
  await limit.locator("#collapse .time input").focus();
  await limit.keyboard.press("Home");
  assert.ok(!last.equals(await stage.screenshot()), "the blocks at rest");
  assert.doesNotMatch(await limit.locator("#collapse .wall-caption").innerText(), /NaN|undefined/);
  await limit.context().close();
  const phone = await open(browser, pageOf("space_limit"), { width: 390 });
  assert.ok(await phone.evaluate(() => document.documentElement.scrollWidth <= window.innerWidth));
  await phone.context().close();
});
