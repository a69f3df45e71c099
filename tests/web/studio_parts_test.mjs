// Arches, storeys, floors, ties and frames drawn in the studio, and a photo under the drawing: by mouse, keys and numbers. Each
// gesture is one edit of the file and one step back; the engine builds what is drawn.
import assert from "node:assert/strict";
import fs from "node:fs";
import path from "node:path";
import { after, before, test } from "node:test";
import { root, viewerModule, violations } from "./helpers.mjs";
import { launch, openStudio, pixelsOf, stonesOf, studioPage, textOf, write } from "./studio.mjs";

let browser, file, page;
before(async () => {
  file = studioPage();
  browser = await launch();
  page = await openStudio(browser, file);
});
after(async () => {
  assert.deepEqual(page.faults, []);
  await browser?.close();
});

const begin = async (name) => {
  await page.locator(".starters").selectOption(name);
  await stonesOf(page);
  await page.locator(".canvas").focus();
};
const move = async (...to) => page.mouse.move(...(await pixelsOf(page, ...to)), { steps: 4 });
const click = async (...to) => page.mouse.click(...(await pixelsOf(page, ...to)));
const drag = async (from, to, during) => {
  await move(...from);
  await page.mouse.down();
  await move(...to);
  try {
    await during?.();
  } finally {
    await page.mouse.up();
  }
};
const has = async (pattern) => assert.match(await textOf(page), pattern);
const lacks = async (pattern) => assert.doesNotMatch(await textOf(page), pattern);
const opening = (k) => page.locator(`[data-opening="${k}"]`);
const field = (label) => page.getByLabel(label, { exact: true });
const enter = async (label, value) => {
  await field(label).fill(value);
  await field(label).press("Enter");
};
// The engine takes the wall as it is drawn.
const isBuilt = async () => {
  await stonesOf(page);
  assert.deepEqual(await page.locator(".fault").allInnerTexts(), []);
  assert.match(await page.locator(".status").innerText(), /blocks/);
};
// What was done is undone by one step, and done again by one.
const isOneStep = async (before) => {
  const done = await textOf(page);
  await page.locator(".canvas").focus();
  await page.keyboard.press("Control+z");
  assert.equal(await textOf(page), before);
  await page.keyboard.press("Control+y");
  assert.equal(await textOf(page), done);
};
// How far the corners of the drawn opening are from corners of the engine's stones, at most [px].
const apart = () =>
  page.evaluate(() => {
    const corners = (path) => {
      const m = path.getScreenCTM();
      return path.getAttribute("d").match(/-?[\d.]+[ ,]-?[\d.]+/g).map((pair) => {
        const [x, y] = pair.split(/[ ,]/).map(Number);
        return [m.a * x + m.e, m.d * y + m.f];
      });
    };
    const stones = [...document.querySelectorAll(".stones [class^=stone]")].flatMap(corners);
    const drawn = corners(document.querySelector('[data-opening="0"]')).slice(1, -1); // the feet stand on the ground
    if (drawn.length < 5) return Infinity;
    return Math.max(...drawn.map(([x, y]) => Math.min(...stones.map(([u, v]) => Math.hypot(u - x, v - y)))));
  });

test("A puts an arch in the lintel's place, drawn as the engine cuts it; A again a lintel", async () => {
  await begin("portal");
  const before = await textOf(page);
  await page.keyboard.press("a");
  await page.locator(".notice", { hasText: /Select a door or window/ }).waitFor();
  await opening(0).click();
  await page.keyboard.press("a");
  await has(/\narch = \{ kind = "segmental", rise = "0\.17 m", depth = "0\.25 m" \}/);
  await lacks(/lintel\]/);
  await isBuilt();
  assert.equal(await page.locator(".stones .timber").count(), 0);
  await isOneStep(before);
  await page.keyboard.press("a");
  await has(/lintel = \{ kind = "timber"/);
  await lacks(/arch = /);
});

test("the crown is dragged: by the mouse, by a typed rise, up to a round arch", async () => {
  await begin("arch");
  await opening(0).click();
  assert.ok((await apart()) < 0.5, `${await apart()} px`);
  const before = await textOf(page);
  await drag([2.25, 2.1], [2.25, 2.3], async () => assert.match(await page.locator(".typing").innerText(), /Rise\s+0\.6/));
  await has(/rise = "0\.60 m"\ndepth = "0\.29 m" {2,}# of the voussoirs/);
  await isOneStep(before);
  await drag([2.25, 2.3], [2.25, 2.2], () => page.keyboard.type("0.35"));
  await has(/rise = "0\.35 m"/);
  await isBuilt();
  await drag([2.25, 2.05], [2.25, 2.68]);
  await has(/kind = "round"[^\n]*\ndepth/);
  await isBuilt();
  assert.ok((await apart()) < 0.5, `${await apart()} px`);
  await drag([2.25, 2.7], [2.25, 2.4]);
  await has(/kind = "segmental"[^\n]*\ndepth[^\n]*\nrise = "0\.70 m"/);
  await drag([2.25, 2.4], [2.25, 2.2], () => page.keyboard.press("Escape"));
  await has(/rise = "0\.70 m"/);
});

test("kind, rise and depth of an arch stand in the panel", async () => {
  await begin("portal");
  await opening(0).click();
  await field("Above it").selectOption("flat");
  await has(/arch = \{ kind = "flat", skewback = "15 deg", depth = "0\.25 m" \}/);
  await isBuilt();
  await field("Above it").selectOption("segmental");
  await enter("Rise of the arch", "0.25");
  await enter("Depth of the arch", "22 cm");
  await has(/arch = \{ kind = "segmental", depth = "0\.22 m", rise = "0\.25 m" \}/);
  await isBuilt();
  await field("Above it").selectOption("round");
  await has(/arch = \{ kind = "round", depth = "0\.22 m" \}/);
  await field("Above it").selectOption("none");
  await lacks(/arch = |lintel = |opening\.lintel/);
  await isBuilt();
});

const part = (name) => page.locator(`[data-part="${name}"]`);

test("E and a click part the wall in storeys, and openings belong to theirs", async () => {
  await begin("portal");
  const before = await textOf(page);
  await page.keyboard.press("e");
  await move(1, 1.5);
  assert.match(await page.locator(".typing").innerText(), /would cut door/);
  await click(1, 1.5);
  await page.locator(".notice", { hasText: /would cut door/ }).waitFor();
  assert.equal(await textOf(page), before);
  await click(1, 2.34);
  await has(/\[\[storey\]\]\nname = "ground floor"\nheight = "2\.336 m"\n\n\[\[storey\]\]\nname = "first floor"\nheight = "0\.584 m"\n/);
  await has(/storey = "ground floor"/);
  await isBuilt();
  await isOneStep(before);
  assert.equal(await part("storey 1").getAttribute("aria-pressed"), "true");
});

test("above the wall the line makes a storey more, at a typed height; wall and push go along", async () => {
  await begin("portal");
  const before = await textOf(page);
  await page.keyboard.press("e");
  await move(1, 2.5);
  await page.keyboard.type("5,84");
  await page.keyboard.press("Enter");
  await has(/length = "3\.50 m"\nheight = "5\.84 m"/);
  await has(/name = "first floor"\nheight = "2\.92 m"/);
  await has(/at = \{ x = "0 m", y = "5\.52 m"/);
  await isBuilt();
  await isOneStep(before);
  await page.keyboard.press("e"); // by keys alone: another one
  await page.keyboard.press("Enter");
  await has(/name = "second floor"/);
  await isBuilt();
});

test("the right button places nothing, and the middle one pans, with a part at the pointer or between two clicks", async () => {
  await begin("portal");
  const before = await textOf(page);
  const left = () => page.locator(".outline").evaluate((e) => e.getBoundingClientRect().x);
  for (const key of ["e", "g", "i", "o"]) {
    await page.keyboard.press(key);
    const [x, y] = await pixelsOf(page, 0.5, 2.34);
    if (key === "o") await page.mouse.click(x - 20, y + 40); // one corner of a window
    await page.mouse.move(x, y, { steps: 3 });
    await page.mouse.click(x, y, { button: "right" });
    assert.equal(await textOf(page), before, key);
    const from = await left();
    await page.mouse.down({ button: "middle" });
    await page.mouse.move(x + 40, y, { steps: 3 });
    await page.mouse.up({ button: "middle" });
    assert.equal(await textOf(page), before, key);
    assert.ok(Math.abs((await left()) - from - 40) < 1.5, key);
    await page.keyboard.press("f");
  }
  await page.keyboard.press("e");
  await move(0.5, 2.3);
  await click(0.5, 2.34);
  await has(/\[\[storey\]\]/);
  await page.keyboard.press("Control+z");
});

test("a storey's line is dragged with its windows, floors and forces, and taken away", async () => {
  await begin("facade");
  const before = await textOf(page);
  await drag([0.5, 3.4], [0.5, 3.57], async () => assert.match(await page.locator(".typing").innerText(), /Height above the base\s+3\.57/));
  await has(/name = "ground floor"\nheight = "3\.57 m" +# 40 courses/);
  await has(/height = "2\.805 m" +# 35 courses/);
  await has(/levels = \["3\.53 m", "6\.34 m"\]/);
  const lines = (await textOf(page)).split("\n");
  assert.equal(lines.filter((line, k) => line !== before.split("\n")[k]).length, 3);
  await isOneStep(before);
  await page.keyboard.press("Control+z");
  await drag([0.5, 3.4], [0.5, 1.7]);
  await page.locator(".notice", { hasText: /would cut window 1/ }).waitFor();
  await part("storey 1").focus();
  await page.keyboard.press("ArrowUp");
  await page.keyboard.press("ArrowUp");
  await has(/name = "ground floor"\nheight = "3\.57 m"/);
  await page.keyboard.press("Control+z");
  await has(/name = "ground floor"\nheight = "3\.40 m"/);
  await page.keyboard.press("Delete");
  await has(/name = "ground floor"\nheight = "6\.375 m"/);
  await lacks(/"first floor"/);
  await has(/name = "window 3"\nstorey = "ground floor"\nx = "1\.10 m"\ny = "4\.20 m"/);
  await has(/name = "timber floor"\ny = "3\.40 m"[^\n]*\nload = "12 kN\/m"/);
  await isBuilt();
  await isOneStep(before);
});

test("name, height and thickness of a storey stand in the panel; openings snap to its line", async () => {
  await begin("facade");
  await part("storey 1").locator("text").click();
  await enter("Name", "piano nobile");
  await has(/\[\[floor\]\]\nname = "roof"\nstorey = "piano nobile"/);
  await lacks(/"first floor"/);
  await part("storey 0").locator("text").click();
  await field("Height").first().fill("3.57");
  await field("Height").first().press("Enter");
  await has(/name = "ground floor"\nheight = "3\.57 m"/);
  await has(/levels = \["3\.53 m", "6\.51 m"\]/);
  await field("Thickness").first().fill("0.45");
  await field("Thickness").first().press("Enter");
  await has(/thickness = "0\.45 m"/);
  await isBuilt();
  await field("Thickness").first().blur();
  await page.locator(".canvas").focus();
  await page.keyboard.press("o");
  await drag([8.6, 3.0], [9.2, 3.55], async () => assert.equal(await page.locator(".guide").count(), 1));
  await page.keyboard.press("Control+z");
});

test("G lays a floor on a storey's top, or at a height of its own; dragged, it changes from one to the other", async () => {
  await begin("empty");
  const before = await textOf(page);
  await page.keyboard.press("g");
  await move(2, 2.9);
  assert.equal(await page.locator(".guide").count(), 1); // the wall's top
  await click(2, 2.9);
  await has(/\[\[floor\]\]\nname = "floor 1"\ny = "2\.92 m"\nload = "10 kN\/m"\n\n\[masonry\]/);
  await isBuilt();
  await isOneStep(before);
  await begin("facade");
  const facade = await textOf(page);
  await part("floor 0").locator("text").click();
  await drag([8.5, 3.75], [8.5, 4.2], async () => assert.match(await page.locator(".typing").innerText(), /base\s+3\.825/));
  await has(/name = "timber floor"\ny = "3\.825 m" +# on top of this storey\nload = "12 kN\/m"/);
  await isBuilt();
  await isOneStep(facade);
  await drag([8.8, 4.05], [8.8, 3.63]);
  await has(/name = "timber floor"\nstorey = "ground floor" +# on top of this storey/);
  await page.keyboard.press("Delete");
  await lacks(/timber floor"/);
  await isBuilt();
});

test("a floor's load, extent and what it does in its plane stand in the panel", async () => {
  await begin("facade");
  await part("floor 0").locator("text").click();
  await enter("Load", "14");
  await has(/name = "timber floor"\nstorey = "ground floor"[^\n]*\nload = "14 kN\/m"/);
  const before = await textOf(page);
  await field("In its plane").selectOption("rigid");
  await has(/\[\[diaphragm\]\]\nname = "timber floor"\nkind = "rigid"\nstorey = "ground floor"\nx = \["0\.75 m", "3\.425 m", "6\.175 m", "8\.85 m"\]/);
  assert.equal(await page.locator(".held").count(), 4);
  await isBuilt();
  await isOneStep(before);
  await field("In its plane").selectOption("elastic");
  await has(/kind = "elastic"[^]*stiffness = "300 MN"/);
  await isBuilt();
  await part("floor 0").focus();
  await page.keyboard.press("ArrowUp"); // its diaphragm goes along
  await has(/\[\[diaphragm\]\]\nname = "timber floor"\nkind = "elastic"\ny = "3\.485 m"/);
  await field("In its plane").selectOption("none");
  await lacks(/diaphragm/);
  await enter("From the left", "1.5");
  await enter("Width", "6");
  await has(/load = "14 kN\/m"\nx = "1\.50 m"\nwidth = "6\.00 m"/);
  await enter("Width", "60");
  assert.equal(await field("Width").getAttribute("aria-invalid"), "true");
  await enter("Width", "6");
  await isBuilt();
  await page.keyboard.press("Escape");
});

test("I puts a tie through the wall by a click, or from here to there; dragged whole and by its ends", async () => {
  await begin("facade");
  const before = await textOf(page);
  await page.keyboard.press("i");
  await click(2, 3.18);
  await has(/\[\[tie\]\]\nname = "tie 1"\nfrom = \{ x = "0\.075 m", y = "3\.1875 m" \}\nto = \{ x = "9\.525 m", y = "3\.1875 m" \}\narea = "314 mm\^2"/);
  await isBuilt();
  await isOneStep(before);
  await drag([2, 3.1875], [2, 2.87]);
  await has(/from = \{ x = "0\.075 m", y = "2\.8475 m" \}\nto = \{ x = "9\.525 m", y = "2\.8475 m" \}/);
  await drag([0.075, 2.8475], [0.8, 2.8475], async () => assert.match(await page.locator(".typing").innerText(), /Left\s+0\.825/));
  await has(/from = \{ x = "0\.825 m", y = "2\.8475 m" \}\nto = \{ x = "9\.525 m"/);
  await drag([0.825, 2.8475], [2, 2]); // into a window
  await page.locator(".notice", { hasText: /no masonry in window 1/ }).waitFor();
  await page.keyboard.press("i");
  await drag([0.9, 5.9], [8.5, 5.9]);
  await has(/name = "tie 2"\nfrom = \{ x = "0\.975 m"[^\n]*\nto = \{ x = "8\.475 m"/);
  await isBuilt();
  await page.keyboard.press("Delete");
  await lacks(/tie 2/);
  await page.keyboard.press("i");
  await page.keyboard.press("Enter");
  await has(/tie 2/);
});

test("section and force of a tie stand in the panel, with what follows", async () => {
  await begin("tied");
  await part("tie 0").click({ position: { x: 40, y: 9 } });
  assert.equal(await field("Prestress force").inputValue(), "12.56 kN");
  await enter("Section", "491");
  await enter("Prestress force", "20");
  await has(/area = "491 mm\^2" +# one bar of 20 mm[^]*prestress = "40\.73 MPa"/);
  assert.match(await page.locator("output.hint").first().innerText(), /25\smm; yields at 115\skN/);
  await enter("Above the base", "2.0");
  await has(/from = \{ x = "0\.6 m", y = "2\.0 m" \}[^\n]*\nto = \{ x = "3\.9 m", y = "2\.0 m" \}/);
  await enter("Prestress force", "0");
  await lacks(/prestress/);
  await isBuilt();
});

// Numbers of parts that the panel has, each written into the file.
const kNumbers = `
[[floor]]
name = "one"
y = "1.46 m"
x = "0.25 m"
width = "2 m"
load = "12 kN/m"
bearing = "150 mm"
thrust = "8 kN"
mass = "1200 kg/m"

[[floor]]
name = "other"
y = "2.19 m"
g1 = "2.6 kN/m^2"
g2 = "1.4 kN/m^2"
q = "2 kN/m^2"
psi2 = 0.3
span = "4.8 m"

[[tie]]
name = "tie"
from = { x = "0.3 m", y = "2 m" }
to = { x = "3.5 m", y = "2 m" }
area = "491 mm^2"
youngs_modulus = "200 GPa"
yield_strength = "235 MPa"
anchor_strength = "80 kN"
prestress = "60 MPa"

[[frame]]
name = "frame"
round = "door"
feet = "fixed"
profile = "HEB 120"
count = 2
beam_profile = "IPE 200"
beam_count = 3
grade = "S275"
yield_strength = "275 MPa"
joint = "steel_contact"
gap = "5 mm"
stage = "push"

[frame.anchors]
spacing = "400 mm"
depth = "200 mm"
tension = "12 kN"
shear = "15 kN"
slip = "1 mm"

[frame.wedges]
force = "80 kN"
spacing = "400 mm"
`;
// Keys of a table of the model file that may be left out, by its page, which the program writes.
function mayBeLeftOut(table) {
  const page = fs.readFileSync(path.join(root, "docs/reference/model.md"), "utf8").split(/\n## /).find((part) => part.startsWith(`\`[[${table}]]\``) || part.startsWith(`\`${table} = `));
  const rows = page.split("\n").filter((line) => /^\| `\w+` \|/.test(line)).map((line) => line.split(" | "));
  return rows.filter((row) => row.length >= 5 && !/^(required|needed)/.test(row[3])).map((row) => row[0].match(/\w+/)[0]);
}

test("an emptied field leaves its number out of the file where that may be, and only there", async () => {
  const { find, parse } = await viewerModule("studio/file/toml");
  await begin("portal");
  const text = (await textOf(page)).replace("\n[[stage]]", `${kNumbers}\n[[stage]]`);
  const noNumbers = ["name", "profile", "beam_profile", "grade", "round", "stage", "y"];
  const sum = ["g1", "g2", "q", "psi2", "span"]; // a load: it needs them all
  for (const [shown, tables] of [["floor 0", ["floor"]], ["floor 1", ["floor"]], ["tie 0", ["tie"]], ["opening 0", ["frame", "frame.anchors", "frame.wedges"]]]) {
    await write(page, text);
    await page.locator(".canvas").focus();
    await page.keyboard.press("Escape");
    const [kind, k] = shown.split(" ");
    await (kind === "opening" ? opening(k) : part(shown)).focus(); // by a key, which selects it
    const fields = page.locator(".numbers .group").first().locator("input[type=text]");
    for (const label of await fields.evaluateAll((all) => all.map((input) => input.getAttribute("aria-label")))) {
      await field(label).first().fill("");
      await field(label).first().press("Enter");
    }
    const now = parse(await textOf(page));
    for (const table of tables) {
      const [list, inner] = table.split(".");
      const at = [list, list === "floor" ? Number(k) : 0, ...(inner ? [inner] : [])];
      const optional = mayBeLeftOut(table);
      const stay = [...find(parse(text), at).keys.keys()].filter((key) => !optional.includes(key) || noNumbers.includes(key) || (sum.includes(key) && shown === "floor 1"));
      assert.deepEqual([...find(now, at).keys.keys()], stay, shown);
    }
  }
});

test("a floor whose load is a sum has a field for each term, and none can be emptied: the wall is built", async () => {
  await begin("portal");
  const sum = ["Structure, g1", "Finishes, g2", "Live load, q", "Share of q, psi2", "Span of the joists"];
  await write(page, (await textOf(page)).replace("\n[[stage]]", '\n[[floor]]\nname = "f"\ny = "2.336 m"\npsi2 = 0.3\n\n[[stage]]'));
  assert.match((await page.locator(".faults").allInnerTexts()).join(), /missing beside the other loads/);
  await part("floor 0").focus();
  for (const [k, value] of ["2,6", "1.4", "2", "0,5", "4.8"].entries()) await enter(sum[k], value);
  await has(/psi2 = 0\.5\n/);
  await isBuilt();
  const whole = await textOf(page);
  await enter("Share of q, psi2", "1.5");
  assert.equal(await field("Share of q, psi2").getAttribute("aria-invalid"), "true");
  for (const term of sum) {
    const value = await field(term).getAttribute("data-shown");
    await enter(term, "");
    await page.locator(".notice", { hasText: /none may be empty/ }).waitFor();
    await page.locator(".notice").getByText("Close").click();
    assert.deepEqual([await field(term).inputValue(), await field(term).getAttribute("aria-invalid")], [value, null]);
  }
  assert.equal(await textOf(page), whole);
  await isBuilt();
});

test("ties that hang on blocks, floors without a level and what the page does not know stay as they are", async () => {
  await begin("facade");
  const odd = `\n[[tie]]\nfrom = { block = "b12" }\nto = { x = "3 m", y = "1 m" }\nwhatever = 7 # ?\n\n[[floor]]\nname = "nowhere"\nload = "<b>1</b>"\n`;
  await write(page, (await textOf(page)) + odd);
  assert.equal(await page.locator(".tie").count(), 0);
  assert.equal(await page.locator(".floor").count(), 2);
  await page.locator(".canvas").focus();
  await page.keyboard.press("i");
  await click(2, 3.1875);
  assert.ok((await textOf(page)).includes(odd.slice(1, 80)));
  await has(/name = "tie 2"/); // the one without a name is called tie 1
  const strange = (await textOf(page)).replace(/\[\[tie\]\][^]*$/, '[tie]\nname = "no list"\n');
  await write(page, strange);
  await page.locator(".canvas").focus();
  await page.keyboard.press("i");
  await click(2, 3.1875);
  await page.locator(".notice", { hasText: /does not know/ }).waitFor();
  assert.equal(await textOf(page), strange);
  await page.keyboard.press("Escape");
});

test("a longer wall keeps its anchors at its end", async () => {
  await begin("facade");
  await page.keyboard.press("i");
  await click(2, 3.1875);
  await page.keyboard.press("Escape");
  await enter("Length", "10.2");
  await has(/to = \{ x = "10\.125 m"/);
  await isBuilt();
});

test("K puts a steel frame in an opening, with its material; profiles, feet and number are choices", async () => {
  await begin("portal");
  const before = await textOf(page);
  await opening(0).click();
  await page.keyboard.press("k");
  await has(/\[\[frame\]\]\nname = "frame 1"\nround = "door"\nfeet = "fixed"\nprofile = "HEB 120"\ngrade = "S275"\njoint = "steel_contact"\n/);
  await has(/\[material\.steel_contact\][^]*\[\[stage\]\]/);
  assert.equal(await page.locator(".steel").count(), 3);
  await isBuilt();
  await isOneStep(before);
  await field("Columns").selectOption("HEA 140");
  await field("Beam").selectOption("IPE 200");
  await field("Feet").selectOption("base_beam");
  await field("Side by side").fill("2");
  await field("Side by side").press("Enter");
  await has(/feet = "base_beam"\nprofile = "HEA 140"\ngrade = "S275"\njoint = "steel_contact"\nbeam_profile = "IPE 200"\ncount = 2/);
  assert.equal(await page.locator(".steel").count(), 4);
  await isBuilt();
  await enter("Name", "shop");
  await has(/round = "shop"/);
  await field("Beam").selectOption("");
  await lacks(/beam_profile/);
  await page.locator(".canvas").focus();
  await page.keyboard.press("Delete"); // with its frame
  await lacks(/wall\.opening|\[\[frame/);
  await isBuilt();
  await begin("arch");
  await opening(0).click();
  await page.keyboard.press("k");
  await page.locator(".notice", { hasText: /level head/ }).waitFor();
});

test("steel, gap, anchors and wedges of a frame stand in the panel, and the engine takes them", async () => {
  const press = (name) => page.getByRole("button", { name, exact: true }).click();
  await begin("frame");
  await opening(0).click();
  const before = await textOf(page);
  await enter("Beams side by side", "3");
  await has(/\nbeam_count = 3\n/);
  await field("Steel").selectOption("S355");
  await has(/grade = "S355"/);
  await enter("Gap to the masonry", "4");
  await has(/\ngap = "4 mm"\n/);
  await isBuilt();
  await enter("Gap to the masonry", "0");
  await lacks(/\ngap/);
  await press("Anchor it in the masonry");
  await has(/\nanchors = \{ spacing = "400 mm", depth = "150 mm", tension = "12 kN", shear = "15 kN" \}\n/);
  await isBuilt();
  await enter("Pull-out strength", "9");
  await enter("Depth of an anchor", "120");
  await has(/anchors = \{ spacing = "400 mm", depth = "120 mm", tension = "9 kN", shear = "15 kN" \}/);
  await press("Wedge its beam");
  await has(/\nwedges = \{ force = "80 kN", spacing = "400 mm" \}\n/);
  await enter("Force of all wedges", "60");
  await has(/wedges = \{ force = "60 kN"/);
  await isBuilt();
  await press("Without anchors");
  await press("Without wedges");
  await lacks(/anchors|wedges/);
  assert.equal((await textOf(page)).replace("beam_count = 3\n", "").replace("S355", "S275"), before);
  // a frame that stands from the start has no stage that could drive wedges in
  await begin("portal");
  await opening(0).click();
  await page.keyboard.press("k");
  assert.equal(await page.getByRole("button", { name: "Wedge its beam" }).count(), 0);
});

test("a number that is varied and then taken away is gone, and so is that of a wall the drawing cannot show", async () => {
  const title = page.locator(".family h2");
  await begin("portal");
  await opening(0).click();
  await page.getByTitle("Vary Width").click();
  assert.equal(await title.innerText(), "Width, now 1\u202fm");
  await page.locator(".canvas").focus();
  await page.keyboard.press("Delete");
  assert.equal(await title.innerText(), "Width, now –");
  assert.ok(await page.locator('[data-action="family"]').isDisabled());
  // a quantity that has another unit by now is another number
  await page.getByTitle("Vary As far as").click();
  assert.match(await title.innerText(), /^As far as, now \d+\u202fmm$/);
  await field("As far as").fill("2 cm");
  await field("As far as").press("Enter");
  assert.equal(await title.innerText(), "As far as, now –");
  await page.getByTitle("Vary Length").first().click();
  await write(page, '[wall]\nblocks = "house.obj"\n');
  assert.equal(await title.innerText(), "Length, now –");
  await page.locator('[data-action="family"]').waitFor();
  await page.getByRole("button", { name: "Close the family of curves" }).click();
  assert.deepEqual(page.faults, []);
});

test("every profile of the library can be chosen, as high as it is", async () => {
  const { kProfiles } = await viewerModule("studio/parts/profiles");
  const source = fs.readFileSync(path.join(root, "src/geometry/wall/profiles.cpp"), "utf8");
  const listed = [...source.matchAll(/\{"((?:IPE|HEA|HEB|UPN|SHS) [\dx.]+)", ([\d.]+),/g)].map((m) => [m[1], Number(m[2])]);
  assert.ok(listed.length > 60);
  assert.deepEqual(kProfiles.map((p) => [...p]).sort(), listed.sort());
});

// A picture of 200 x 100 pixels, as a file.
const pictureFile = async (name, type = "image/png") => {
  const url = await page.evaluate((type) => {
    const canvas = Object.assign(document.createElement("canvas"), { width: 200, height: 100 });
    const c = canvas.getContext("2d");
    c.fillStyle = "#2a6";
    c.fillRect(0, 0, 200, 100);
    return canvas.toDataURL(type);
  }, type);
  return { name, mimeType: type, buffer: Buffer.from(url.split(",")[1], "base64") };
};
const photo = () => page.locator("image.photo");
// Where it lies [m], on a wall 3.5 m long.
const placeOf = (of = page) =>
  of.locator("image.photo").evaluate((e) => {
    const wall = document.querySelector(".outline").getBoundingClientRect(),
      box = e.getBoundingClientRect();
    const metres = (v) => Math.round((1000 * v * 3.5) / wall.width) / 1000;
    return { x: metres(box.left - wall.left), y: metres(wall.bottom - box.bottom), width: metres(box.width), height: metres(box.height) };
  });

// Waits until it lies there: the drawing may be about to fit itself to another size of the page.
const lies = async (expected) => {
  const isNear = (place) => Object.keys(expected).every((key) => Math.abs(place[key] - expected[key]) < 0.012);
  const until = Date.now() + 20_000;
  let place = await placeOf();
  for (; !isNear(place) && Date.now() < until; place = await placeOf()) await page.evaluate(() => new Promise(requestAnimationFrame));
  assert.ok(isNear(place), `${JSON.stringify(place)}, not ${JSON.stringify(expected)}`);
};

test("a photo lies under the lines: opened, moved, brought to scale by two points, undone, kept, in no file and no link", async () => {
  await begin("portal");
  const before = await textOf(page);
  await page.keyboard.press("b");
  assert.match(await page.locator(".photo-bar").innerText(), /stay in this browser/);
  await page.locator('.photo-bar input[type="file"]').setInputFiles(await pictureFile("front.png"));
  await photo().waitFor();
  const first = { x: 0, y: 0, width: 3.5, height: 1.75 };
  await lies(first);
  await drag([1, 1], [1.5, 1.25]);
  const moved = { ...first, x: 0.5, y: 0.25 };
  await lies(moved);
  await click(1, 1);
  assert.match(await page.locator(".photo-bar").innerText(), /other end/);
  await click(2, 1);
  await field("From one point to the other:").fill("1,5");
  await field("From one point to the other:").press("Enter");
  const scaled = { x: 0.25, y: -0.125, width: 5.25, height: 2.625 };
  await lies(scaled);
  await page.locator(".canvas").focus();
  await page.keyboard.press("Control+z");
  await lies(moved);
  await page.keyboard.press("Control+z");
  await lies(first);
  await page.keyboard.press("Control+y");
  await page.keyboard.press("Control+y");
  await lies(scaled);
  assert.equal(await textOf(page), before);
  await field("Strength").fill("0.3");
  assert.equal(await photo().getAttribute("opacity"), "0.3");
  await page.waitForSelector("html:not([data-keeping])");
  await page.reload();
  await page.waitForSelector("html[data-ready]");
  await stonesOf(page);
  await lies(scaled);
  assert.equal(await photo().getAttribute("opacity"), "0.3");
  await page.locator(".canvas").focus();
  await page.keyboard.press("h");
  assert.equal(await photo().count(), 0);
  await page.keyboard.press("h");
  await page.keyboard.press("b");
  await page.locator('.photo-bar input[type="file"]').setInputFiles({ name: "evil.png", mimeType: "image/png", buffer: Buffer.from("<svg onload=alert(1)>") });
  await page.locator(".notice", { hasText: /evil\.png is no PNG, JPEG or DXF/ }).waitFor();
  await page.locator(".photo-bar").getByText("Delete").click();
  assert.equal(await photo().count(), 0);
  await page.waitForSelector("html:not([data-keeping])");
  await page.reload();
  await page.waitForSelector("html[data-ready]");
  await stonesOf(page);
  assert.equal(await photo().count(), 0);
});

test("a dropped picture is traced, a dropped text is opened", async () => {
  await begin("portal");
  const { buffer } = await pictureFile("photo.jpg", "image/jpeg");
  const drop = (name, type, bytes) =>
    page.evaluate(
      ([name, type, bytes]) => {
        const dataTransfer = new DataTransfer();
        dataTransfer.items.add(new File([Uint8Array.from(bytes)], name, { type }));
        document.querySelector(".board").dispatchEvent(new DragEvent("drop", { dataTransfer, bubbles: true }));
      },
      [name, type, [...bytes]],
    );
  await drop("photo.jpg", "image/jpeg", buffer);
  await photo().waitFor();
  assert.equal(await page.locator(".canvas").getAttribute("data-tool"), "photo");
  await drop("w.toml", "", Buffer.from((await textOf(page)).replace("3.50 m", "4.50 m")));
  await stonesOf(page);
  await has(/length = "4\.50 m"/);
  await page.locator(".photo-bar").getByText("Delete").click();
  await page.keyboard.press("v");
});

// A wall of 3.5 x 2.92 m in millimetres, with an arched door, a circle and a text.
const dxf = (unit = 4) =>
  `0 SECTION 2 HEADER 9 $INSUNITS 70 ${unit} 0 ENDSEC 0 SECTION 2 ENTITIES 0 LWPOLYLINE 90 4 70 1 10 0 20 0 10 3500 20 0 10 3500 20 2920 10 0 20 2920 0 LWPOLYLINE 70 0 10 2250 20 0 10 2250 20 1700 42 1 10 1250 20 1700 10 1250 20 0 0 LINE 10 0 20 1000 11 500 21 1000 0 CIRCLE 10 3000 20 2000 40 100 0 TEXT 1 hello 0 ENDSEC 0 EOF`
    .split(" ")
    .join("\n");

test("lines of a DXF lie under the drawing at their size", async () => {
  const { readDxf } = await viewerModule("studio/board/dxf");
  const lines = readDxf(dxf());
  assert.equal(lines.metre, 1e-3);
  assert.equal(lines.skipped, 1);
  assert.equal(lines.paths.length, 4);
  const crown = Math.max(...lines.paths[1].map((p) => p[1]));
  assert.ok(Math.abs(crown - 2200) < 5, `${crown}`); // half a circle of 1 m
  assert.deepEqual(readDxf("0\nSECTION\n2\nENTITIES\n0\nLINE\n10\nx\n"), { paths: [], metre: 0, skipped: 1 });
  await begin("portal");
  await page.keyboard.press("b");
  await page.locator('.photo-bar input[type="file"]').setInputFiles({ name: "wall.dxf", mimeType: "", buffer: Buffer.from(dxf()) });
  await photo().waitFor();
  await page.locator(".notice", { hasText: /Not shown of the DXF: 1/ }).waitFor();
  const { width, height } = await placeOf();
  assert.ok(Math.abs(width - 3.5) < 0.01 && Math.abs(height - 2.92) < 0.01, `${width} ${height}`);
  await page.locator('.photo-bar input[type="file"]').setInputFiles({ name: "empty.dxf", mimeType: "", buffer: Buffer.from("0\nEOF\n") });
  await page.locator(".notice", { hasText: /empty\.dxf is no PNG/ }).waitFor();
  await page.locator(".photo-bar").getByText("Delete").click();
  await page.keyboard.press("v");
});

test("a file that cannot be opened and a DXF of too many points are told", async () => {
  await begin("portal");
  await page.keyboard.press("b");
  const take = (name, text) => page.locator('.photo-bar input[type="file"]').setInputFiles({ name, mimeType: "", buffer: Buffer.from(text) });
  const told = async (pattern) => {
    await page.locator(".notice").getByText(pattern).waitFor({ timeout: 20000 });
    assert.equal(await photo().count(), 0);
  };
  await take("city.dxf", `0\nSECTION\n2\nENTITIES\n0\nLWPOLYLINE\n${"10\n1\n20\n2\n".repeat(200001)}0\nENDSEC\n`);
  await told(/city\.dxf has more than 200.?000 points/);
  await page.evaluate(() => {
    const { arrayBuffer } = Blob.prototype;
    Blob.prototype.arrayBuffer = function () {
      Blob.prototype.arrayBuffer = arrayBuffer;
      return Promise.reject(new DOMException("gone", "NotFoundError"));
    };
  });
  await take("gone.png", "x");
  await told(/gone\.png is no PNG/);
  await page.keyboard.press("v");
});

test("a field of the photo keeps the focus, and Backspace deletes no opening while the photo is moved", async () => {
  await begin("portal");
  await opening(0).click();
  const before = await textOf(page);
  await page.keyboard.press("b");
  await page.locator('.photo-bar input[type="file"]').setInputFiles(await pictureFile("front.png"));
  await photo().waitFor();
  await enter("Photo’s width", "4");
  assert.ok(Math.abs((await placeOf()).width - 4) < 0.01);
  assert.equal(await page.evaluate(() => document.activeElement.getAttribute("aria-label")), "Photo’s width");
  await page.keyboard.press("Backspace");
  await page.keyboard.type("wide");
  await page.keyboard.press("Enter");
  assert.equal(await field("Photo’s width").getAttribute("aria-invalid"), "true");
  await enter("Photo’s width", "5");
  assert.equal(await field("Photo’s width").getAttribute("aria-invalid"), null);
  await page.locator(".canvas").focus();
  await page.keyboard.press("Control+z");
  assert.equal(await field("Photo’s width").inputValue(), "4.00");
  await page.keyboard.press("Backspace");
  await page.keyboard.press("Delete");
  assert.equal(await textOf(page), before);
  await page.locator(".photo-bar").getByText("Delete").click();
  await page.keyboard.press("Backspace");
  assert.equal(await textOf(page), before);
  await page.keyboard.press("v");
});

test("an undone move of the photo is kept, and no step back does nothing", async () => {
  await begin("portal");
  await page.keyboard.press("b");
  const open = async (name) => {
    await page.locator('.photo-bar input[type="file"]').setInputFiles(await pictureFile(name));
    await photo().waitFor();
  };
  await open("front.png");
  await drag([1, 1], [1.5, 1.25]);
  await page.waitForSelector("html:not([data-keeping])");
  await page.locator(".canvas").focus();
  await page.keyboard.press("Control+z");
  await page.waitForSelector("html:not([data-keeping])");
  await page.reload();
  await page.waitForSelector("html[data-ready]");
  await stonesOf(page);
  assert.ok(Math.abs((await placeOf()).x) < 0.012, `${(await placeOf()).x}`);
  const undo = page.getByLabel("Undo", { exact: true }).first();
  assert.ok(await undo.isDisabled());
  await page.locator(".canvas").focus();
  await page.keyboard.press("b");
  await page.keyboard.press("ArrowRight");
  assert.ok(await undo.isEnabled());
  await open("other.png");
  await page.waitForSelector("html:not([data-keeping])");
  assert.ok(await undo.isDisabled(), "another photo");
  await drag([1, 1], [1.5, 1.25]);
  await page.locator(".photo-bar").getByText("Delete").click();
  await page.locator(".canvas").focus();
  await page.keyboard.press("ArrowRight");
  assert.ok(await undo.isDisabled(), "no photo");
  await page.keyboard.press("v");
});

test("another language waits until the browser has the photo, and asks where it cannot keep it", async () => {
  const other = await openStudio(browser, file, { impatient: true });
  await other.evaluate(() => {
    const { put } = IDBObjectStore.prototype;
    window.storage = "slow";
    IDBObjectStore.prototype.put = function (...all) {
      const hold = () => {
        if (window.storage === "full") this.transaction.abort();
        else if (window.storage === "slow") this.get("").onsuccess = hold;
      };
      hold();
      return put.apply(this, all);
    };
  });
  await other.locator(".canvas").focus();
  await other.keyboard.press("b");
  await other.locator('.photo-bar input[type="file"]').setInputFiles(await pictureFile("front.png"));
  await other.locator("image.photo").waitFor();
  const asked = new Promise((done) => other.once("dialog", (dialog) => (done(dialog.message()), dialog.dismiss())));
  await other.locator(".language").selectOption("it");
  await other.evaluate(() => (window.storage = "full")).catch(() => undefined); // the page may be gone already
  assert.match(String(await Promise.race([asked, other.waitForSelector("html[lang=it]")])), /would be lost: the photo\./);
  assert.equal(await other.locator(".language").inputValue(), "en");
  await other.evaluate(() => (window.storage = "there"));
  await other.locator(".canvas").focus();
  await other.keyboard.press("ArrowRight");
  await other.locator(".language").selectOption("it");
  await other.waitForSelector("html[data-ready][lang=it]");
  await stonesOf(other);
  assert.ok(Math.abs((await placeOf(other)).x - 0.1) < 0.012, JSON.stringify(await placeOf(other)));
  await other.end();
});

for (const [width, height, scheme] of [[1440, 900, "dark"], [390, 844, "light"]])
  test(`parts are for everybody: ${width} px, ${scheme}`, async () => {
    const other = await openStudio(browser, file, { width, height, scheme, touch: width < 1000, locale: "it-IT" });
    await other.locator(".starters").selectOption("facade");
    await stonesOf(other);
    for (const key of ["i", "g", "e"]) {
      await other.locator(".canvas").focus();
      await other.keyboard.press(key);
      await other.keyboard.press("Enter");
      await stonesOf(other);
      assert.deepEqual(await violations(other), []);
    }
    await other.locator('[data-opening="1"]').focus();
    await other.keyboard.press("k");
    await other.keyboard.press("b");
    await stonesOf(other);
    assert.deepEqual(await violations(other), []);
    assert.ok(await other.evaluate(() => document.documentElement.scrollWidth <= window.innerWidth), "wider than the screen");
    await other.addStyleTag({ content: "code { display: none }" }); // keys of the file
    const words = await other.locator("body").innerText();
    for (const word of ["Storey", "Floor", "Tie", "Photo", "frame", "Above"]) assert.ok(!new RegExp(`\\b${word}\\b`).test(words), word);
    assert.deepEqual(other.faults, []);
    await other.end();
  });

test("a finger puts a tie and drags it", async () => {
  const other = await openStudio(browser, file, { width: 820, height: 1180, touch: true });
  await other.locator(".starters").selectOption("empty");
  await stonesOf(other);
  await other.locator('.tool-button:has-text("Tie")').tap();
  const frame = await other.locator(".outline").boundingBox();
  const at = (x, y) => ({ x: frame.x + (x / 4) * frame.width, y: frame.y + frame.height - (y / 2.92) * frame.height });
  const session = await other.context().newCDPSession(other);
  const touch = (type, point) => session.send("Input.dispatchTouchEvent", { type, touchPoints: point ? [point] : [] });
  await touch("touchStart", at(1, 2.5));
  await touch("touchEnd");
  assert.match(await textOf(other), /name = "tie 1"\nfrom = \{ x = "0\.0625 m", y = "2\.5185 m" \}/);
  await touch("touchStart", at(1, 2.5));
  for (let k = 1; k <= 4; ++k) await touch("touchMove", at(1, 2.5 - 0.25 * k));
  await touch("touchEnd");
  assert.match(await textOf(other), /from = \{ x = "0\.0625 m", y = "1\.49\d* m" \}/);
  assert.deepEqual(other.faults, []);
  await other.end();
});
