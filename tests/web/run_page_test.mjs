// The page of a real run in a browser: drawings, motion, exports, print.
import assert from "node:assert/strict";
import fs from "node:fs";
import path from "node:path";
import { after, before, test } from "node:test";
import { assertReadable, browserPath, downloaded, folder, launch, open, pageOf, pdfPages, run, screenshot, violations } from "./helpers.mjs";
import { makeFacade, makeRun } from "./small_study.mjs";

let browser, page, summary;
const csvRows = (bytes) =>
  bytes
    .toString()
    .trim()
    .split("\n")
    .map((l) => l.split(","));

before(async () => {
  assert.ok(fs.existsSync(browserPath));
  summary = makeRun("run");
  browser = await launch();
  page = await open(browser, pageOf("run"));
});
after(() => browser?.close());

test("opens without errors, requests or dialogs", () => assert.deepEqual(page.faults, []));

test("headline and key numbers are in the page", async () => {
  const words = await page.locator("#headline .answer").innerText();
  assert.match(words, /The wall resists [\d.]+\skN at [\d.]+\smm/);
  assert.ok(words.includes(summary.failure_mode.name));
  assert.equal(await page.locator(".card").count(), 5);
});

test("names with markup are text", async () => {
  assert.equal(
    await page.locator("script:not([type])").count(),
    await page.evaluate(() => [...document.scripts].filter((s) => !s.type).length),
  );
  assert.ok((await page.locator("#inputs").innerText()).includes("<script>alert('door')</script>"));
  assert.ok((await page.locator("#inputs").innerText()).includes("<script>alert('note')</script>"));
});

test("the curve has its line, its events and its peak", async () => {
  assert.equal(await page.locator("#curve .event").count(), summary.events.length);
  assert.equal(await page.locator("#curve path.force").count(), 1);
  assert.equal(await page.locator("#curve path.base").count(), 1);
  assert.equal(await page.locator("#curve circle.peak").count(), summary.censored_80 ? 1 : 2);
});

test("the wall has every block, and every joint or a chain's silence", async () => {
  const marks = (css) =>
    page.locator(`#wall ${css}`).evaluateAll((e) => e.reduce((n, p) => n + Number(p.dataset.marks), 0));
  assert.equal(
    (await marks("path.stone")) + (await marks("path.timber")) + (await marks("path.plate")),
    summary.blocks,
  );
  const drawn = (await marks("path.mortar")) + (await marks("path.split")) + (await marks("path.crack"));
  assert.ok(drawn > 0.9 * summary.joints && drawn <= summary.joints, `${drawn} of ${summary.joints}`);
});

test("the time slider moves the wall and the cursor on the curve", async () => {
  const slider = page.locator("#wall .time input");
  const state = async () => [
    await page.locator("#wall path.stone0").getAttribute("d"),
    await page.locator("#curve .cursor-line").getAttribute("x1"),
    await page.locator("#wall .wall-caption").innerText(),
  ];
  const end = await state();
  await slider.focus();
  await page.keyboard.press("Home");
  const start = await state();
  end.forEach((v, i) => assert.notEqual(v, start[i]));
  await page.keyboard.press("End");
  assert.deepEqual(await state(), end);
});

// A path of thousands of blocks is slow to draw; pixels are not, and the drawing follows when all is at rest.
test("while it moves the wall is painted, at rest it is drawn", async () => {
  const wall = page.locator("#wall .wall-stage");
  const drawing = await wall.locator("path.stone0").getAttribute("d");
  const moving = await wall.evaluate((stage) => {
    const slider = document.querySelector("#wall .time input");
    const looks = (css) => getComputedStyle(stage.querySelector(css));
    const wanted = { stone: looks("path.stone0").fill, open: looks("path.crack.open").stroke };
    const frames = [Number(slider.max) - 1, Number(slider.max)].map((frame) => {
      slider.value = frame;
      slider.dispatchEvent(new Event("input"));
      return stage.querySelector("canvas");
    });
    const [width, height] = [frames[1].width, frames[1].height];
    const { data } = frames[1].getContext("2d").getImageData(0, 0, width, height);
    const share = (colour) => {
      const [r, g, b] = colour.match(/\d+/g).map(Number);
      let n = 0;
      for (let i = 0; i < data.length; i += 4)
        n += data[i] === r && data[i + 1] === g && data[i + 2] === b && data[i + 3] === 255 ? 1 : 0;
      return n / (width * height);
    };
    return {
      canvases: stage.querySelectorAll("canvas").length,
      same: frames[0] === frames[1],
      built: stage.querySelectorAll("path.stone, path.mortar, path.crack").length,
      arrow: stage.querySelectorAll("path.arrow").length,
      stone: share(wanted.stone),
      open: share(wanted.open),
    };
  });
  assert.deepEqual([moving.canvases, moving.same, moving.built, moving.arrow], [1, true, 0, 1]);
  assert.ok(moving.stone > 0.03 && moving.open > 1e-4, `${moving.stone} ${moving.open}`);
  assert.equal(await wall.locator("path.stone0").getAttribute("d"), drawing);
  assert.equal(await wall.locator("canvas").count(), 0);
});

test("pressing on the curve moves the wall", async () => {
  const before = await page.locator("#wall .wall-caption").innerText();
  const box = await page.locator("#curve svg.plot").boundingBox();
  await page.mouse.click(box.x + 0.4 * box.width, box.y + 0.5 * box.height);
  assert.notEqual(await page.locator("#wall .wall-caption").innerText(), before);
});

test("play runs to the end and stops", async () => {
  await page.locator("#wall .time input").evaluate((s) => {
    s.value = Number(s.max) - 3;
    s.dispatchEvent(new Event("input"));
  });
  await page.locator("#wall .play").click();
  await page.waitForFunction(() => {
    const s = document.querySelector("#wall .time input");
    return s.value === s.max;
  });
  await page.waitForFunction(() => document.querySelector("#wall .play").textContent === "▶");
});

test("the magnification, the measure and the forces change the picture", async () => {
  const before = await page.locator("#wall path.stone0").getAttribute("d");
  await page.locator("#wall input.scale").focus();
  await page.keyboard.press("End");
  assert.notEqual(await page.locator("#wall path.stone0").getAttribute("d"), before);
  for (const measure of ["opening", "slip", "damage"]) {
    await page.locator("#wall select").selectOption(measure);
    assert.ok((await page.locator(`#wall path.joint.${measure}`).count()) > 0, measure);
    assert.equal(await page.locator("#wall path.crack").count(), 0);
  }
  await page.locator("#wall select").selectOption("cracks");
  await page.locator("#wall .check input").check();
  assert.ok((await page.locator("#wall path.thrust").count()) > 1);
  await page.locator("#wall .check input").uncheck();
});

test("pointing at a joint tells its numbers", async () => {
  const [x, y] = await page
    .locator("#wall path.crack")
    .first()
    .evaluate((p) => {
      const at = p.getPointAtLength(2),
        m = p.getScreenCTM();
      return [at.x * m.a + m.e, at.y * m.d + m.f];
    });
  await page.mouse.move(x, y);
  assert.match(await page.locator(".tip").innerText(), /opening/);
});

// A colour of stress is a bound of the legend; the same steps are drawn and explained.
test("joints show their stress, with a legend in MPa", async () => {
  await page.locator("#wall select").selectOption("stress");
  const drawn = await page
    .locator("#wall path.joint.stress")
    .evaluateAll((e) => e.reduce((n, p) => n + Number(p.dataset.marks), 0));
  assert.ok(drawn > 0.2 * summary.joints && drawn <= summary.joints, `${drawn} of ${summary.joints}`);
  const words = await page.locator("#wall .wall-key").innerText();
  assert.match(words, /compression[^]*> [\d.]+\sMPa[^]*tension[^]*> [\d.]+\sMPa/);
  assert.match(words, /mean stress across them/);
  // the classes of the drawing are those of the legend
  const classes = await page
    .locator("#wall path.joint.stress")
    .evaluateAll((e) => e.map((p) => [...p.classList].slice(2).join(" ")));
  for (const css of classes)
    assert.equal(await page.locator(`#wall .stress-keys .${css.replace(" ", ".")}`).count(), 1, css);
  await page.locator("#wall select").selectOption("cracks");
});

test("a push that ended early says so far; the curve says what its bilinear curve is", async () => {
  const caption = (p) => p.locator("#curve figcaption").innerText();
  assert.match(await caption(page), /same area up to 80\s%/);
  for (const [name, force] of [
    ["rising", /resists at least [\d.]+\skN: it was still rising/],
    ["falling", /The wall resists [\d.]+\skN at/],
  ]) {
    const made = makeRun(`${name}_run`, `${name}_model.toml`);
    assert.ok(made.failure_mode.read_at_mm < 39 && made.censored_max);
    const other = await open(browser, pageOf(`${name}_run`));
    const words = await other.locator("#headline .answer").innerText();
    assert.match(words, force);
    assert.match(words, /So far, at [\d.]+\smm, it/);
    assert.doesNotMatch(words, /It fails by/);
    assert.equal(await other.locator("#failure .note").count(), made.censored_80 ? 1 : 0);
    if (made.censored_80) assert.match(await caption(other), /up to where the push ended/);
    assert.deepEqual(other.faults, []);
    await other.context().close();
  }
});

test("the materials have one column each, and units beside what is measured", async () => {
  const table = page.locator("#inputs table", { hasText: "friction angle" });
  assert.equal((await table.locator("caption").innerText()).trim(), "Materials");
  const heads = await table.locator("thead th").allInnerTexts();
  assert.deepEqual(heads, ["foundation", "joint", "timber", "unit"]);
  assert.match(await table.innerText(), /tensile strength \[MPa\]/);
});

test("what is cut on a narrow screen says so, and scrolls", async () => {
  const other = await open(browser, pageOf("run"), { width: 390 });
  const more = (css) => other.locator(css).first().getAttribute("data-more");
  assert.equal(await more(".bar-links"), "right");
  const cut = other.locator(".scroll[data-more=right]").first();
  const hint = await cut.evaluate((e) => getComputedStyle(e, "::after").display);
  assert.notEqual(hint, "none");
  const name = await cut.locator("caption").innerText();
  const slide = other.locator(".scroll", { hasText: name }).first().locator(".slide");
  await slide.evaluate((e) => e.scrollTo(10000, 0));
  await other.waitForFunction(() => document.querySelector('.scroll[data-more="left"]') !== null);
  // on a wide screen nothing is cut
  assert.equal(await page.locator(".scroll[data-more~=right]").count(), 0);
  await other.context().close();
});

test("without WebGL the view in the plane stays, with a note", async () => {
  const flat = await launch("--disable-3d-apis");
  const other = await open(flat, pageOf("run"));
  await other.locator("#wall .segment").nth(1).click();
  assert.equal(await other.locator("#wall .no-webgl").count(), 1);
  assert.equal(await other.locator("#wall svg.wall").count(), 1);
  assert.equal(await other.locator("#wall .segment").nth(0).getAttribute("aria-pressed"), "true");
  assert.deepEqual(other.faults, []);
  await flat.close();
});

test("with WebGL the wall stands in space and turns", async () => {
  const solid = await launch("--use-angle=swiftshader", "--enable-unsafe-swiftshader");
  const other = await open(solid, pageOf("run"));
  await other.locator("#wall .segment").nth(1).click();
  const canvas = other.locator("#wall canvas");
  await canvas.waitFor();
  const picture = () => canvas.evaluate((c) => c.toDataURL());
  const before = await picture();
  assert.ok(before.length > 5000, "the picture is empty");
  await canvas.focus();
  await other.keyboard.press("ArrowLeft");
  const turned = await picture();
  assert.notEqual(turned, before);
  await other.locator("#wall .check input").check();
  const forces = await picture();
  assert.notEqual(forces, turned, "contact forces are not drawn in space");
  await screenshot(other, "run_3d_forces_1440_light");
  await other.locator("#wall .check input").uncheck();
  assert.equal(await picture(), turned);
  await screenshot(other, "run_3d_1440_light");
  assert.deepEqual(other.faults, []);
  await solid.close();
});

test("a deformable lintel shows its zones, and they move", async () => {
  const made = makeRun("zones_run", "zones.toml");
  const other = await open(browser, pageOf("zones_run"));
  const zones = other.locator("#wall path.zone");
  assert.equal(await zones.getAttribute("data-marks"), String(made.zones));
  assert.equal(await other.locator("#wall path.timber").getAttribute("data-marks"), "1");
  const end = await zones.getAttribute("d");
  await screenshot(other, "run_zones_1440_light");
  await other.locator("#wall select").selectOption("stress");
  const coloured = await other
    .locator("#wall path.zone-stress")
    .evaluateAll((e) => e.reduce((n, p) => n + Number(p.dataset.marks), 0));
  assert.ok(coloured > 0 && coloured <= made.zones, `${coloured} of ${made.zones}`);
  assert.match(await other.locator("#wall .wall-key").innerText(), /principal stress/);
  // the middle of the first zone: half way between two of its corners
  const [x, y] = await other
    .locator("#wall path.zone-stress")
    .first()
    .evaluate((p) => {
      const n = p.getAttribute("d").match(/-?[\d.]+/g).map(Number),
        m = p.getScreenCTM();
      return [((n[0] + n[4]) / 2) * m.a + m.e, ((n[1] + n[5]) / 2) * m.d + m.f];
    });
  await other.mouse.move(x, y);
  assert.match(await other.locator(".tip").innerText(), /greater principal stress\s*−?[\d.]+\sMPa/);
  await screenshot(other, "run_zones_stress_1440_light");
  await other.locator("#wall .time input").focus();
  await other.keyboard.press("Home");
  assert.notEqual(await zones.getAttribute("d"), end);
  assert.deepEqual(other.faults, []);
  await other.context().close();
});

test("ties, floors and walls across are drawn where they are, with the force of the state shown", async () => {
  makeRun("tied", "tied.toml");
  const csv = csvRows(fs.readFileSync(path.join(folder("tied"), "links.csv")));
  const tied = await open(browser, pageOf("tied"));
  const links = (kind) => tied.locator(`#wall svg.wall .link${kind}`);
  assert.equal(await links(".tie").count(), 2);
  assert.equal(await links(".diaphragm").count(), 2); // between three points
  assert.equal(await links(".spring").count(), 1);
  const told = async () =>
    await links("").evaluateAll((all) => all.map((e) => [e.dataset.link, e.querySelector("title").textContent]));
  const force = (text) => Number(text.replace("−", "-").match(/: (-?[\d.]+)/)[1]);
  const check = async (row) => {
    for (const [name, title] of await told()) {
      const at = csv[0].findIndex((cell) => cell.replaceAll('"', "") === `${name} force_kN`);
      assert.ok(at > 0, name);
      assert.ok(title.startsWith(`${name}: `) && title.includes("kN"), title);
      assert.ok(Math.abs(force(title) - Number(row[at])) <= 0.01 * Math.abs(row[at]) + 0.005, `${title}: ${row[at]}`);
    }
  };
  await check(csv[csv.length - 1]);
  const end = await told();
  await tied.locator("#wall .time input").focus();
  await tied.keyboard.press("Home");
  await check(csv[1]);
  assert.notDeepEqual(await told(), end);
  // the tie runs from one pier to the other, level, within the picture
  const box = await links(".tie").first().boundingBox(),
    wall = await tied.locator("#wall svg.wall").boundingBox();
  assert.ok(box.width > 0.4 * wall.width && box.height < 0.1 * wall.height, JSON.stringify(box));
  assert.ok(box.x > wall.x && box.x + box.width < wall.x + wall.width);
  await screenshot(tied, "tied_1440", "#push");
  assert.deepEqual(tied.faults, []);
  await tied.context().close();
});

test("energy, ratios, elements and inputs are all there", async () => {
  assert.equal(await page.locator("#energy-chart path.area").count(), 6);
  assert.equal(await page.locator("#ratios path.force, #ratios path.base").count(), 2);
  const rows = await page.locator("#failure table").first().locator("tbody tr").count();
  assert.equal(rows, summary.failure_mode.elements.length);
  assert.ok((await page.locator("#inputs table").count()) >= 4);
  assert.ok((await page.locator("#provenance").innerText()).includes(summary.state_hash));
});

test("the failure mode stands beside its flags and the readings that name it otherwise", async () => {
  const mode = summary.failure_mode,
    words = await page.locator("#failure").innerText();
  assert.ok(words.includes("growth of its width"));
  assert.equal(await page.locator("#failure table").nth(1).locator("tbody tr").count(), mode.flags.length);
  const others = mode.sensitivity.filter((r) => r.name !== mode.name);
  assert.match(
    words,
    new RegExp(
      others.length > 0
        ? `Of ${mode.sensitivity.length} other readings`
        : `Read in ${mode.sensitivity.length} other ways`,
    ),
  );
  for (const r of others) assert.ok(words.includes(`${r.what}: ${r.name}`), r.what);
  for (const r of mode.sensitivity.filter((r) => r.name === mode.name))
    assert.ok(!words.includes(`${r.what}: `), r.what);
});

// Numbers stand on the wall; a row lights its part; its number keeps it lit and draws its forces.
test("piers and spandrels are numbered on the wall and lit from their rows", async () => {
  const marks = await page.locator("#parts text.part").allTextContents();
  assert.deepEqual(marks.sort(), ["P1", "P2", "S1"]);
  const rows = page.locator("#elements tbody tr");
  const lit = () => page.locator("#parts path.lit, #wall path.lit").evaluateAll((p) => p.map((e) => e.dataset.part));
  await rows.nth(0).hover();
  const name = await rows.nth(0).locator(".mark-button").getAttribute("data-part");
  assert.deepEqual(await lit(), [name, name]);
  await page.locator("#failure .lead").hover();
  assert.deepEqual(await lit(), []);
  const drawn = () => page.locator("#element-forces path.force").getAttribute("d");
  const before = await drawn();
  await rows.nth(1).locator(".mark-button").click();
  await page.locator("#failure .lead").hover();
  assert.equal((await lit()).length, 2);
  assert.notEqual(await drawn(), before);
  await rows.nth(1).locator(".mark-button").click();
  assert.deepEqual(await lit(), []);
  assert.ok((await page.locator("#mechanism").innerText()).length > 12);
});

test("every figure exports SVG, PNG and CSV that can be read", async () => {
  const figures = await page.locator("figure[id]").evaluateAll((f) => f.map((e) => e.id));
  assert.deepEqual(figures.sort(), ["curve", "element-forces", "energy-chart", "parts", "ratios", "wall"]);
  for (const id of figures) {
    const press = (kind) => downloaded(page, () => page.locator(`#${id} [data-export=${kind}]`).click());
    const svg = (await press("svg")).toString();
    const fault = await page.evaluate(
      (text) =>
        new DOMParser().parseFromString(text, "image/svg+xml").querySelector("parsererror")?.textContent ??
        "",
      svg,
    );
    assert.equal(fault, "", id);
    assert.ok(!svg.includes("var(--") && svg.includes("<path"), id);
    const png = await press("png");
    assert.equal(png.subarray(1, 4).toString(), "PNG", id);
    const rows = csvRows(await press("csv"));
    assert.ok(rows.length > 5 && rows.every((r) => r.length === rows[0].length), id);
  }
});

test("the curve's CSV has every row of the run", async () => {
  const rows = csvRows(await downloaded(page, () => page.locator("#curve [data-export=csv]").click()));
  const file = fs
    .readFileSync(path.join(folder("run"), "force_displacement.csv"), "utf8")
    .trim()
    .split("\n");
  assert.equal(rows.length, file.length);
});

test("the theme can be chosen", async () => {
  const paper = () => page.evaluate(() => getComputedStyle(document.body).backgroundColor);
  const light = await paper();
  const button = page.locator(".bar-tools button").first();
  await button.click();
  await button.click();
  assert.notEqual(await paper(), light);
  await button.click();
  assert.equal(await paper(), light);
});

test("axe finds nothing, in light and dark, wide and narrow", () => assertReadable(browser, "run"));

test("a push to and fro shows its loops, their envelopes and every cycle", async () => {
  const { cyclic } = makeRun("cyclic_run", "cyclic.toml");
  assert.deepEqual(
    cyclic.cycles.map((c) => c.kind),
    ["full", "full", "full", "unfinished"],
  );
  const other = await open(browser, pageOf("cyclic_run"));
  assert.deepEqual(other.faults, []);
  const words = await other.locator("#headline .answer").innerText();
  assert.match(words, /to and fro/);
  assert.equal(await other.locator("#curve path.force.thin").count(), 1);
  assert.equal(await other.locator("#curve path.work").count(), 2); // an envelope a direction
  assert.equal(await other.locator("#curve path.fit").count(), 2);
  const tables = other.locator("#cycles tbody");
  assert.equal(await tables.nth(0).locator("tr").count(), 2);
  assert.equal(await tables.nth(1).locator("tr").count(), cyclic.cycles.length);
  assert.match(await tables.nth(1).innerText(), /unfinished/);
  // d(r) of both directions, by three readings
  assert.equal(await tables.nth(2).locator("tr").count(), cyclic.positive.drift_capacity.left.length);
  assert.equal(await tables.nth(2).locator("tr").first().locator("td").count(), 6);
  // the mark of the peak lies on the side that is read
  await other.locator("#curve svg.plot").scrollIntoViewIfNeeded();
  const peak = await other.locator("#curve circle.peak").first().boundingBox();
  const axis = await other.locator("#curve svg.plot").boundingBox();
  const middle = axis.x + axis.width / 2;
  assert.equal(peak.x > middle, cyclic.read_in === "positive");
  // a press on the lower branch shows the wall there, not at the same displacement of another cycle
  await other.mouse.click(axis.x + 0.3 * axis.width, axis.y + 0.85 * axis.height);
  assert.match(await other.locator("#wall .wall-caption").innerText(), /−/);
  assert.deepEqual(await violations(other), []);
  await screenshot(other, "run_cyclic_1440_light");
  await other.context().close();
});

test("prints as a sheet and an appendix of A4 pages", async () => {
  const pdf = await page.pdf({ preferCSSPageSize: true });
  fs.writeFileSync(path.join(folder("run"), "report.pdf"), pdf);
  assert.ok(pdfPages(pdf) >= 4 && pdfPages(pdf) <= 5, `${pdfPages(pdf)} pages`);
  assert.match(pdf.toString("latin1"), /MediaBox \[0 0 59[45][.\d]* 84[12][.\d]*\]/);
});

// What can only be pressed or dragged is not said on paper; a wall of many parts stays within five pages.
test("paper says nothing of the mouse, and lists only what matters", async () => {
  makeFacade("facade_run");
  const other = await open(browser, pageOf("facade_run"));
  assert.ok(pdfPages(await other.pdf({ preferCSSPageSize: true })) <= 5);
  const said = async (p) => {
    await p.emulateMedia({ media: "print" });
    const words = await p.locator("main").innerText();
    await p.emulateMedia({ media: null });
    return words;
  };
  for (const p of [page, other]) assert.doesNotMatch(await said(p), /\b([Pp]ress|[Pp]ressing|slider|Drag|[Pp]oint(ing)? at)\b/);
  assert.match(await page.locator("#curve figcaption").innerText(), /Press on the curve/);
  const found = JSON.parse(fs.readFileSync(path.join(folder("facade_run"), "summary.json"), "utf8"));
  const mode = found.failure_mode;
  const damaged = mode.elements.filter((e) => e.state !== "intact").length;
  assert.ok(mode.elements.length > 12 && damaged < mode.elements.length);
  assert.equal(await other.locator("#elements tbody tr").count(), damaged);
  assert.ok((await other.locator("#elements").innerText()).includes(`${mode.elements.length - damaged} parts`));
  const answer = await other.locator("#headline .answer").innerText();
  assert.ok(answer.length < 400, answer);
  assert.deepEqual(other.faults, []);
  await other.context().close();
});

test("no card's text leaves its card, wide, narrow or printed", async () => {
  for (const [width, media] of [
    [1440, null],
    [390, null],
    [700, "print"],
  ]) {
    const other = await open(browser, pageOf("run"), { width });
    await other.emulateMedia({ media });
    const out = await other.locator(".card").evaluateAll((cards) =>
      cards.flatMap((card) => {
        const box = card.getBoundingClientRect(),
          air = parseFloat(getComputedStyle(card).paddingRight) - 1;
        return [...card.querySelectorAll(".value, .unit, .name, .means")]
          .flatMap((e) => {
            const range = document.createRange();
            range.selectNodeContents(e);
            return [...range.getClientRects()];
          })
          .filter((r) => r.right > box.right - air)
          .map((r) => `${card.textContent}: ${r.right} of ${box.right}`);
      }),
    );
    assert.deepEqual(out, [], `${width} ${media}`);
    await other.context().close();
  }
});

// Words of a language, not of files: what stays English in the Italian page is a phrase without translation.
test("a value that was not given is marked, and its rule or typology explained", async () => {
  makeRun("typical_run", "typical.toml");
  const other = await open(browser, pageOf("typical_run"));
  const marks = async (sign) => (await other.locator("#inputs sup").allInnerTexts()).filter((t) => t.trim() === sign).length;
  assert.equal(await marks("t"), 10);
  assert.equal(await marks("r"), 1);
  await other.locator("#inputs details.origins summary").click();
  const said = await other.locator("#inputs details.origins").innerText();
  assert.match(said, /gi_from_ft: tensile_strength 0\.15 MPa \(t: tuff_pozzolanic\)/);
  assert.match(said, /GI = 0\.029 mm ft/);
  assert.match(said, /Pulatsu et al\. 2022/);
  assert.equal(await page.locator("#inputs details.origins").count(), 0);
  assert.match(await page.locator("#inputs").innerText(), /All values are given/);
});

test("in Italian no English is left, notes and reasons included", async () => {
  makeRun("zones_run", "zones.toml");
  makeFacade("facade_run");
  for (const name of ["zones_run", "facade_run"]) {
    run("report", folder(name), "--lang", "it");
    const other = await open(browser, pageOf(name));
    await other.locator("#failure details summary").click();
    const words = (await other.locator("main").innerText()).replace(/^.*alert\('.*$/gm, "").replace(/^(facade of eight piers|small wall with a door)$/gm, "");
    const found = words.split("\n").filter((l) => /\b(the|of|and|with|is|are|was|were|than|from|at|by|no|which|slow|wall)\b/.test(l.replace(/no(?=\t|$)/g, "")));
    assert.deepEqual(found, [], name);
    assert.deepEqual(other.faults, []);
    await other.context().close();
    run("report", folder(name));
  }
});

test("without scripts the main result is still told", async () => {
  const other = await open(browser, pageOf("run"), { javaScript: false });
  assert.match(await other.locator("main").innerText(), /The wall resists[^]*peak reaction[^]*JavaScript/);
  await other.context().close();
});

test("wythe report writes the page again, in Italian too", async () => {
  const file = path.join(folder("run"), "report.html");
  const first = fs.readFileSync(file);
  run("report", folder("run"));
  assert.ok(fs.readFileSync(file).equals(first));
  run("report", folder("run"), "--lang", "it");
  const other = await open(browser, pageOf("run"));
  assert.equal(await other.evaluate(() => document.documentElement.lang), "it");
  const words = await other.locator("main").innerText();
  assert.match(words, /La parete resiste a/);
  assert.match(words, /Come collassa/);
  assert.match(words, /\d,\d/);
  assert.deepEqual(other.faults, []);
  run("report", folder("run"));
  await other.context().close();
});
