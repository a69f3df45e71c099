// Drawing in the studio as people do it: by mouse, touch, keys and numbers. Each gesture is one step back.
import assert from "node:assert/strict";
import { after, before, test } from "node:test";
import { launch, openStudio, pixelsOf, stonesOf, studioPage, textOf } from "./studio.mjs";

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
const drag = async (from, to, { steps = 6, during } = {}) => {
  const a = await pixelsOf(page, ...from),
    b = await pixelsOf(page, ...to);
  await page.mouse.move(...a);
  await page.mouse.down();
  await page.mouse.move(...b, { steps });
  try {
    await during?.();
  } finally {
    await page.mouse.up();
  }
};
const has = async (pattern) => assert.match(await textOf(page), pattern);
const opening = (k) => page.locator(`[data-opening="${k}"]`);
const field = (label) => page.getByLabel(label, { exact: true });
// Answers of the engine that end a question wait until `release`.
const hold = () =>
  page.evaluate(() => {
    window.held = [];
    for (const worker of window.testWorkers) {
      const hear = worker.onmessage;
      worker.onmessage = (e) => (window.held && e.data.code !== undefined ? window.held.push(() => hear(e)) : hear(e));
    }
  });
const release = () =>
  page.evaluate(() => {
    for (const hear of window.held) hear();
    window.held = null;
  });
const status = () => page.locator(".status").innerText();

test("it opens with an example, its stones and its weight", async () => {
  assert.equal(await page.locator(".stones .stone0").count(), 1);
  assert.match(await status(), /^876 blocks · 35\.1\skN/);
});

test("stones and weight are there before the time of a push is known", async () => {
  await hold();
  const before = await status();
  await field("Length").first().fill("3.00");
  await field("Length").first().press("Enter");
  await page.waitForFunction((before) => document.querySelector(".status").textContent !== before && window.held.length > 0, before);
  assert.match(await status(), /^\d+ blocks · [\d.]+\u202fkN$/);
  assert.equal(await page.locator(".stones .stone0").count(), 1);
  await release();
  await stonesOf(page);
  assert.match(await status(), /kN · a push takes about/);
  await page.keyboard.press("Control+z");
  await stonesOf(page);
});

test("nine examples and an empty wall to begin with: each is drawn, and the engine takes it", async () => {
  const names = await page.locator(".starters option").evaluateAll((all) => all.map((option) => option.value).filter(Boolean));
  assert.equal(names.length, 10);
  for (const name of names) {
    await begin(name);
    assert.match(await status(), /blocks/, name);
    assert.equal(await page.locator(".fault").count(), 0, name);
    assert.equal(await page.locator('.tool-button:has-text("Door")').isEnabled(), true, name);
  }
});

test("a wall from nothing: its size by the mouse, its stones at once", async () => {
  await begin("empty");
  await page.keyboard.press("w");
  await drag([0, 0], [3.02, 2.3]);
  await stonesOf(page);
  await has(/length = "3\.00 m"\nheight = "2\.336 m"/); // half units of 125 mm, courses of 73 mm
  assert.doesNotMatch(await status(), /876/);
  await page.keyboard.press("Control+z");
  await has(/length = "4\.00 m"\nheight = "2\.92 m"/);
});

test("a length that is typed while the wall is drawn takes effect", async () => {
  await begin("empty");
  await page.keyboard.press("w");
  await drag([0, 0], [1.5, 1.5], {
    during: async () => {
      await page.keyboard.type("3.3");
      await page.keyboard.press("Tab");
      await page.keyboard.type("2,5");
      assert.match(await page.locator(".typing").innerText(), /Length\s+3\.3.*Height\s+2,5/s);
    },
  });
  await has(/length = "3\.30 m"\nheight = "2\.50 m"/);
});

test("a door stands on the ground, with a lintel; one gesture is one step", async () => {
  await begin("empty");
  const before = await textOf(page);
  await page.keyboard.press("d");
  await drag([1.52, 0.8], [2.6, 2.06]);
  await stonesOf(page);
  await has(/name = "door 1"\nx = "1\.50 m"\ny = "0\.00 m"\nwidth = "1\.125 m"\nheight = "2\.044 m"\nlintel = \{/);
  await has(/\[material\.timber\]/);
  assert.equal(await page.locator(".stones .timber").count(), 1);
  assert.equal(await opening(0).getAttribute("aria-pressed"), "true");
  await page.keyboard.press("Control+z");
  assert.equal(await textOf(page), before);
  await page.keyboard.press("Control+y");
  await has(/name = "door 1"/);
});

test("a window between two clicks, its width typed", async () => {
  await begin("empty");
  await page.keyboard.press("o");
  await page.mouse.click(...(await pixelsOf(page, 1, 0.95)));
  await page.mouse.move(...(await pixelsOf(page, 1.6, 1.9)), { steps: 4 });
  await page.keyboard.type("1.2");
  await page.keyboard.press("Enter");
  await has(/name = "window 1"\nx = "1\.00 m"\ny = "0\.949 m"\nwidth = "1\.20 m"/);
  await page.keyboard.press("Escape");
});

test("while an opening is dragged, dimensions go along and lines show what it is aligned with", async () => {
  await begin("portal");
  const before = await textOf(page);
  await drag([1.75, 1], [1.52, 1], {
    during: async () => {
      const gaps = await page.locator(".dim.gap text").allTextContents();
      assert.ok(gaps.length >= 3, gaps.join());
      assert.match(gaps[0], /^1\s?m|^1\.0/);
      assert.match(await page.locator(".typing").innerText(), /Left/);
    },
  });
  await has(/x = "1\.00 m"/);
  await drag([1.5, 1], [1.76, 1], {
    during: async () => assert.equal(await page.locator(".guide").count(), 1), // its axis on the wall's
  });
  await has(/x = "1\.25 m"/);
  await page.keyboard.press("Control+z");
  await page.keyboard.press("Control+z");
  assert.equal(await textOf(page), before);
});

test("snapping is switched by its chips, and Escape gives a gesture up", async () => {
  await begin("portal");
  await page.keyboard.press("s");
  assert.equal(await page.locator('[data-snap="masonry"]').getAttribute("aria-pressed"), "false");
  await drag([1.75, 1], [1.683, 1]);
  await has(/x = "1\.18 m"/);
  await page.locator('[data-snap="masonry"]').click();
  await page.locator('[data-snap="objects"]').click();
  const before = await textOf(page);
  await drag([1.7, 1], [2.2, 1], { during: () => page.keyboard.press("Escape") });
  assert.equal(await textOf(page), before);
});

test("an undo in the middle of a gesture ends the gesture", async () => {
  await begin("portal");
  await page.keyboard.press("o");
  await page.keyboard.press("Enter");
  const [x, y] = await opening(1).evaluate((e) => {
    const box = e.getBoundingClientRect();
    return [box.x + box.width / 3, box.y + box.height / 2];
  });
  await page.mouse.move(x, y);
  await page.mouse.down();
  await page.mouse.move(x + 30, y, { steps: 3 });
  await page.keyboard.press("Control+z");
  await page.mouse.move(x + 60, y, { steps: 3 });
  await page.mouse.up();
  assert.doesNotMatch(await textOf(page), /window 1/);
  assert.deepEqual(page.faults, []);
});

test("an opening is resized by its handles, and a typed distance moves it", async () => {
  await begin("portal");
  await opening(0).click();
  await drag([2.25, 1.05], [2.49, 1.05]);
  await has(/x = "1\.25 m"\ny = "0 m"\nwidth = "1\.25 m"/);
  await drag([1.8, 0.6], [1.9, 0.6], { during: () => page.keyboard.type("0.6") });
  await has(/x = "0\.60 m"/);
});

test("keys alone draw, move and delete an opening", async () => {
  await begin("empty");
  await page.keyboard.press("o");
  await page.keyboard.press("Enter");
  await has(/name = "window 1"\nx = "1\.50 m"/);
  await page.keyboard.press("ArrowLeft");
  await page.keyboard.press("ArrowLeft");
  await page.keyboard.press("ArrowUp");
  await page.keyboard.press("Shift+ArrowRight");
  await has(/x = "1\.26 m"/);
  await page.keyboard.press("Control+z"); // the steps of arrows are one gesture
  await has(/x = "1\.50 m"/);
  await page.keyboard.press("Delete");
  assert.doesNotMatch(await textOf(page), /window 1/);
});

test("numbers beside the drawing: lengths, bond, material, load, push", async () => {
  await begin("portal");
  await field("Length").fill("4,2");
  await field("Length").press("Enter");
  await has(/length = "4\.20 m"/);
  await page.keyboard.press("Control+z"); // the focus is in the field still
  await has(/length = "3\.50 m"/);
  await page.keyboard.press("Control+y");
  await has(/length = "4\.20 m"/);
  await field("Thickness").fill("38 cm");
  await field("Thickness").press("Enter");
  await has(/thickness = "0\.38 m"/);
  await field("Bond").selectOption("english");
  await field("Typical values of").selectOption("circolare_brick_lime");
  await field("On each pier").fill("75");
  await field("On each pier").press("Enter");
  await field("Push").selectOption("-x");
  await field("As far as").fill("12 mm");
  await field("As far as").press("Enter");
  await has(/bond = "english"[^]*use = "circolare_brick_lime"[^]*pier_load = "75 kN"[^]*x = "4\.2 m"[^]*until = "12 mm"/);
  await field("Length").fill("wide");
  await field("Length").press("Enter");
  assert.equal(await field("Length").getAttribute("aria-invalid"), "true");
  await has(/length = "4\.20 m"/);
});

test("what is typed stays when the engine asks for more fields", async () => {
  await begin("portal");
  await hold();
  await field("Typical values of").selectOption("circolare_brick_lime"); // it lacks numbers, which get fields
  const before = await page.locator(".numbers input").count();
  await field("On each pier").fill("75");
  await field("On each pier").evaluate((input) => input.setSelectionRange(1, 2));
  await page.waitForFunction(() => window.held.length > 0);
  await release();
  await page.waitForFunction((before) => document.querySelectorAll(".numbers input").length > before, before);
  assert.equal(await field("On each pier").inputValue(), "75");
  await page.keyboard.press("8"); // in the place of the 5, which is selected still
  await page.keyboard.press("Enter");
  await has(/pier_load = "78 kN"/);
});

test("the masonry says where its numbers come from, and at which knowledge level", async () => {
  await begin("portal");
  const origins = page.locator(".origins");
  await origins.locator("summary").click();
  assert.match(await origins.innerText(), /masonry_strength 7\.92\smPa\s+typical: Magenes and Calvi 1992, CoV 0\.17[^]*normal_stiffness 40\.97\sGPa\/m\s+derived: kn_from_e/i);
  assert.equal(await field("Knowledge level").count(), 0);
  await field("Typical values of").selectOption("circolare_brick_lime");
  await field("Knowledge level").selectOption("LC2");
  await has(/use = "circolare_brick_lime"[^]*\nknowledge_level = "LC2"/);
  await stonesOf(page);
  assert.equal(await field("Initial shear strength").count(), 0); // the table has it
  await field("Compressive strength of units, normalised").fill("8"); // this it does not have
  await field("Compressive strength of units, normalised").press("Enter");
  await has(/\nunit_strength = "8 MPa"/);
  await stonesOf(page);
  assert.equal(await page.locator(".fault").count(), 0);
  assert.match(await origins.innerText(), /Table C8\.5\.I, LC2/);
  await field("Knowledge level").selectOption("");
  assert.doesNotMatch(await textOf(page), /knowledge_level/);
  await field("Knowledge level").selectOption("LC1");
  await field("Typical values of").focus();
  await field("Typical values of").selectOption("clay_brick_old");
  assert.doesNotMatch(await textOf(page), /knowledge_level/);
  assert.equal(await page.evaluate(() => document.activeElement.getAttribute("aria-label")), "Typical values of"); // other fields, the same focus
  await begin("tuff");
  assert.equal(await origins.isVisible(), false);
});

test("the palette and the sheet of keys", async () => {
  await page.locator(".canvas").focus();
  await page.keyboard.press("Control+k");
  await page.keyboard.type("tuff");
  assert.equal(await page.locator("#palette-list li").count(), 1);
  await page.keyboard.press("Enter");
  await has(/tuff wall with one opening/);
  await page.locator(".canvas").focus();
  await page.keyboard.press("?");
  assert.ok((await page.locator(".sheet-of-keys dd").count()) > 15);
  await page.keyboard.press("Escape");
  assert.equal(await page.locator(".sheet-of-keys").isVisible(), false);
});

test("zoom by the wheel, and F fits again", async () => {
  await begin("portal");
  const wide = () => page.locator(".outline").evaluate((e) => e.getBoundingClientRect().width);
  const fitted = await wide();
  await page.mouse.move(500, 300);
  await page.mouse.wheel(0, -400);
  assert.ok((await wide()) > 1.5 * fitted);
  await page.keyboard.press("f");
  assert.ok(Math.abs((await wide()) - fitted) < 1);
});
