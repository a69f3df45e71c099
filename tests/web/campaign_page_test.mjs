// The page of a real campaign of 24 samples in a browser.
import assert from "node:assert/strict";
import { execFileSync } from "node:child_process";
import fs from "node:fs";
import path from "node:path";
import { after, before, test } from "node:test";
import { assertReadable, downloaded, folder, launch, open, pageOf, pdfPages, run, screenshot, viewerModule, violations, wantsPictures } from "./helpers.mjs";
import { makeCampaign, makeCampaignOf } from "./small_study.mjs";

let browser, page, s;
const modes = () => Object.entries(s.shares).filter(([, v]) => v.modes.length === 1 && v.count > 0);

before(async () => {
  s = makeCampaign("campaign");
  browser = await launch();
  page = await open(browser, pageOf("campaign"));
});
after(() => browser?.close());

test("opens without errors, requests or dialogs", () => {
  assert.deepEqual(page.faults, []);
  assert.equal(s.samples.answered, 24);
});

test("headline says how strong, how far, how it fails", async () => {
  const words = await page.locator("#headline .answer").innerText();
  assert.match(words, /In 24 samples the wall resists/);
  assert.match(words, /It fails most often by FM-\d/);
});

test("one curve a sample, coloured by its mode", async () => {
  assert.equal(await page.locator("#curves path.sample").count(), 24);
  for (const [mode, share] of modes())
    assert.equal(
      await page.locator(`#curves path.sample.m${mode === "unclear" ? 0 : mode[3]}`).count(),
      share.count,
      mode,
    );
});

test("a mode's toggle hides and shows its curves, dots and mean", async () => {
  const [mode, share] = modes()[0];
  const chip = page.locator(`#curves [data-mode="${mode}"]`);
  const dots = await page.locator("#scatter-1 circle.dot").count();
  await chip.click();
  assert.equal(await page.locator("#curves path.sample").count(), 24 - share.count);
  assert.equal(await page.locator("#scatter-1 circle.dot").count(), dots - share.count);
  assert.equal(await page.locator(`#mean-curves [data-mean="${mode}"]`).count(), 0);
  assert.equal(await chip.getAttribute("aria-pressed"), "false");
  await chip.click();
  assert.equal(await page.locator("#curves path.sample").count(), 24);
  assert.equal(await page.locator(`#mean-curves [data-mean="${mode}"]`).count(), 1);
});

test("curves can be cut at 0.8 of the peak, and shown as means and envelopes", async () => {
  const path0 = page.locator("#curves path.sample").first();
  const whole = (await path0.getAttribute("d")).length;
  await page.locator("#curves [data-option=truncated]").click();
  assert.ok((await path0.getAttribute("d")).length < whole);
  await page.locator("#curves [data-option=means]").click();
  assert.equal(await page.locator("#curves path.sample").count(), 0);
  assert.equal(await page.locator("#curves path.mean").count(), modes().length);
  assert.equal(
    await page.locator("#curves path.envelope").count(),
    modes().filter(([, v]) => v.count > 1).length,
  );
  await page.locator("#curves [data-option=both]").click();
  assert.equal(await page.locator("#curves path.sample").count(), 24);
  await page.locator("#curves [data-option=curves]").click();
  await page.locator("#curves [data-option=whole]").click();
});

test("shares, Table 3, means, exceedance and running mean have the statistics' marks", async () => {
  assert.equal(await page.locator("#shares [data-share]").count(), Object.keys(s.shares).length);
  assert.equal(await page.locator("#shares .whisker").count(), Object.keys(s.shares).length);
  assert.equal(
    await page.locator("#table3-rows tbody tr").count(),
    Object.values(s.table).filter((g) => g.peak_reaction_kN.n > 0).length,
  );
  assert.equal(await page.locator("#mean-curves [data-mean]").count(), Object.entries(s.mean_curves).filter(([name, c]) => name !== "all" && c.curves > 0).length);
  const limits = new Set(s.drift_limits.map((l) => l.limit_drift_percent));
  assert.ok((await page.locator("#mean-curves [data-limit]").count()) <= limits.size);
  assert.equal(
    await page.locator("#exceedance-peak_reaction path.step").getAttribute("data-steps"),
    String(s.exceedance.peak_reaction_kN.probability.length),
  );
  assert.equal(await page.locator("#running path.step").getAttribute("data-points"), "24");
  assert.equal(await page.locator("#drift-limits tbody tr").count(), s.drift_limits.length);
});

test("Table 3 sorts by a column, both ways, and shows every response", async () => {
  const column = () =>
    page
      .locator("#table3-rows tbody tr td:nth-child(2)")
      .allInnerTexts()
      .then((t) => t.map((v) => parseInt(v, 10)).slice(1)); // all samples stay first
  const head = page.locator("#table3-rows thead th").nth(1);
  await head.locator("button").click();
  const down = await column();
  assert.deepEqual(
    down,
    [...down].sort((a, b) => b - a),
  );
  assert.equal(await head.getAttribute("aria-sort"), "descending");
  await head.locator("button").click();
  assert.deepEqual(
    await column(),
    [...down].reverse().sort((a, b) => a - b),
  );
  await page.locator("#table3 select").selectOption({ index: 2 });
  assert.match(await page.locator("#table3-rows caption").innerText(), /80/);
});

test("scatter draws every sample for any input and response, with its correlation", async () => {
  for (const [input, response] of [
    ["phi", "peak_reaction"],
    ["c_j", "displacement_at_peak"],
    ["fc", "initial_stiffness"],
  ]) {
    await page.locator("#scatter-1 .pick-input").selectOption(input);
    await page.locator("#scatter-1 .pick-response").selectOption(response);
    assert.equal(await page.locator("#scatter-1 circle.dot").count(), 24);
    const c = s.correlation.find(
      (r) => r.group === "all" && r.input === input && r.response.startsWith(`${response}_`),
    );
    if (!s.inputs.find((i) => i.name === input).random) continue; // what follows from others has no table
    assert.ok(c, `${input} ${response}`);
    assert.ok(
      (await page.locator("#scatter-1 figcaption").innerText()).includes(
        String(Math.abs(Number(c.spearman.toFixed(2)))),
      ),
      `${input} ${response}`,
    );
  }
});

test("sensitivity has a bar for each random input, for every measure", async () => {
  const random = s.inputs.filter((i) => i.random).length;
  for (const measure of ["spearman", "pearson", "partial_rank", "first_order"]) {
    await page.locator("#sensitivity select").nth(1).selectOption(measure);
    const bars = await page.locator("#sensitivity [data-input]").count();
    assert.ok(bars === random || (measure === "first_order" && bars <= random), `${measure}: ${bars}`);
  }
});

test("every response can be picked, in words", async () => {
  for (const list of ["#table3-quantity", "#scatter-1 .pick-response", "#running select"]) {
    const words = await page.locator(`${list} option`).allInnerTexts();
    assert.equal(words.length, 8, list);
    for (const w of words) assert.doesNotMatch(w, /_|quantity\./, list);
  }
  await page.locator("#table3-quantity").selectOption({ index: 6 });
  assert.match(await page.locator("#table3-rows caption").innerText(), /collapse/);
});

// Values known only from below are never shown as facts, whatever the table.
test("censored values are lower bounds in tables, marked and counted", async () => {
  const of = "displacement_max_mm";
  const all = s.table.all[of];
  assert.ok(all.censored > 0.05 * all.n, "the study censors nothing");
  await page.locator("#table3-quantity").selectOption({ index: 3 });
  const rows = await page.locator("#table3-rows tbody tr").evaluateAll((list) =>
    list.map((r) => [...r.cells].map((c) => c.innerText.trim())),
  );
  const groups = Object.values(s.table).filter((g) => g[of].n > 0);
  assert.equal(rows.length, groups.length);
  groups.forEach((g, i) => {
    const c = g[of],
      row = rows[i];
    assert.equal(row[1].includes(`${c.censored} censored`), c.censored > 0, row.join("|"));
    assert.equal(row[2].startsWith("≥ "), c.censored > 0, row.join("|"));
    if (c.censored > 0.05 * c.n) assert.equal(row[3], "–", "a CoV of lower bounds");
    // all samples ended together: what is censored is the largest, so the largest is a bound
    assert.equal(row[6].startsWith("≥ "), c.censored > 0, row.join("|"));
    if (c.censored === c.n) assert.ok(row[4].startsWith("≥ "), row.join("|"));
  });
  // the peak was passed in every sample
  assert.equal(s.samples.still_rising, 0);
  await page.locator("#table3-quantity").selectOption({ index: 0 });
  assert.doesNotMatch(await page.locator("#table3-rows tbody").innerText(), /≥/);
  const precise = page.locator("#sure table").first();
  const row = (await precise.locator("tbody tr").allInnerTexts())[3];
  assert.match(row, new RegExp(`^largest displacement\\s*${all.censored} of ${all.n} censored\\s*–\\t–`));
  assert.match(await page.locator("#sure").innerText(), /a mean of lower bounds has no precision/);
});

test("an order statistic is exact below all that is censored", async () => {
  const { Bounds } = await viewerModule("campaign/data");
  const known = new Bounds(10, [7, 9]);
  assert.deepEqual([6.9, 7, 8, null].map((v) => known.reach(v)), [false, true, true, false]);
  assert.equal(known.many, true);
  assert.equal(new Bounds(40, [7, 9]).many, false);
  assert.equal(new Bounds(10, []).reach(1e9), false);
});

test("captions say where modes were read, drifts are in one unit", async () => {
  const read = await page.locator("#shares figcaption").innerText();
  const early = s.samples.named_earlier;
  assert.ok(read.includes(early > 0 ? `in ${early} of 24 samples` : "Modes are read at 12\u202fmm."), read);
  assert.match(await page.locator("#sample .lead").innerText(), /Read at [\d.]+\smm/);
  const drift = page.locator("#exceedance-displacement_at_80_percent");
  const height = `${Number(s.load_height_m.toPrecision(3))}\u202fm`;
  assert.match(await drift.locator("svg.plot").textContent(), /drift over the load’s height, [\d.]+\sm \[%\]/);
  const words = await drift.locator("figcaption").innerText();
  assert.match(words, /median [\d.]+\s% \([\d.]+\smm\)/);
  assert.ok(words.includes(height), words);
});

test("the legend names only the limits that are drawn", async () => {
  const drawn = (p) => p.locator("#mean-curves [data-limit]").count();
  const named = (p) => p.locator("#mean-curves .legend").innerText();
  assert.equal(/near collapse|life safety/.test(await named(page)), (await drawn(page)) > 0);
  makeCampaignOf("rising.toml", "rising");
  const other = await open(browser, pageOf("rising"));
  assert.equal(await drawn(other), 0);
  assert.doesNotMatch(await named(other), /near collapse|life safety/);
  assert.match(
    await other.locator("#mean-curves figcaption").innerText(),
    /Circolare 21 January 2019 n\. 7, [\w.]+ all lie beyond this push, the least at 0\.375\s%/,
  );
  assert.match(await other.locator("#shares figcaption").innerText(), /every push ended earlier/);
  await other.context().close();
});

test("in Italian the engine's words and numbers are Italian too", async () => {
  makeCampaignOf("falling.toml", "falling");
  run("report", folder("falling"), "--lang", "it");
  const other = await open(browser, pageOf("falling"));
  run("report", folder("falling"));
  const words = await other.locator("main").innerText();
  assert.match(words, /Circolare 21 gennaio 2019 n\. 7/);
  assert.doesNotMatch(words, /January|\b(pier|spandrel|samples|censored|crack width|drift limits)\b| x \d/);
  const ticks = (await other.locator("svg text.tick").allTextContents()).join(" ");
  assert.match(ticks, /\d,\d/);
  assert.doesNotMatch(ticks, /\d\.\d/);
  assert.deepEqual(other.faults, []);
  await other.context().close();
});

test("every view has its picture", async () => {
  const more = [
    [1440, "dark"],
    [390, "light"],
  ];
  for (const [width, scheme] of [[1440, "light"], [390, "dark"], ...(wantsPictures ? more : [])]) {
    const other = await open(browser, pageOf("campaign"), { width, scheme });
    for (const view of ["means", "both"]) {
      await other.locator(`#curves [data-option=${view}]`).click();
      await other.locator("#curves [data-option=truncated]").click();
      await screenshot(other, `campaign_${view}_${width}_${scheme}`, "#all-curves");
    }
    for (const section of ["modes", "capacity", "influence", "sure", "sample", "study"])
      await screenshot(other, `campaign_${section}_${width}_${scheme}`, `#${section}`);
    await other.context().close();
  }
});

test("readings that change names, and severity flags, have their rows", async () => {
  const changing = s.name_sensitivity.filter((r) => r.differs > 0);
  assert.ok(changing.length > 0 && changing.length < s.name_sensitivity.length);
  const rows = await page.locator("#name-sensitivity tbody tr").allInnerTexts();
  assert.deepEqual(
    rows.map((r) => r.split("\t").slice(0, 3)),
    changing.map((r) => [
      r.reading.replace(" x ", " × "),
      String(r.n),
      String(r.differs),
    ]),
  );
  const quiet = s.name_sensitivity.length - changing.length;
  assert.ok((await page.locator("#name-sensitivity").innerText()).includes(`other ${quiet} readings`));
  const flags = await page.locator("#flags tbody tr").allInnerTexts();
  assert.deepEqual(
    flags.map((r) => r.split("\t")[1]),
    s.flags.map((f) => `${f.raised} / ${f.n}`),
  );
});

test("a design without correlation has no word of caution beside its bars", async () => {
  assert.ok(s.input_correlation.every((c) => Math.abs(c.spearman) <= 0.1));
  assert.equal(await page.locator("#entangled").count(), 0);
});

test("histograms hold every sample", async () => {
  const histograms = page.locator("#histograms figure");
  assert.equal(await histograms.count(), s.inputs.filter((i) => i.random).length);
  for (let i = 0; i < (await histograms.count()); ++i) {
    const counts = await histograms
      .nth(i)
      .locator("rect[data-count]")
      .evaluateAll((r) => r.map((e) => Number(e.dataset.count)));
    assert.equal(
      counts.reduce((a, b) => a + b, 0),
      24,
    );
    assert.equal(await histograms.nth(i).locator("path.fit").count(), 1);
  }
});

test("pressing on a curve opens the sample: curve, inputs, wall, command", async () => {
  const [x, y, sample] = await page
    .locator("#curves path.sample")
    .nth(7)
    .evaluate((p) => {
      p.scrollIntoView({ block: "center" });
      const at = p.getPointAtLength(0.9 * p.getTotalLength()),
        m = p.getScreenCTM();
      return [at.x * m.a + m.e, at.y * m.d + m.f, p.dataset.sample];
    });
  await page.mouse.click(x, y);
  const opened = await page.locator("#sample-number").inputValue();
  assert.equal(await page.locator("#curves [data-selected]").getAttribute("data-selected"), opened);
  assert.ok(sample.length > 0);
  assert.equal(await page.locator("#sample-curve path.selected").count(), 1);
  assert.equal(await page.locator("#sample .input-item").count(), s.inputs.length);
  assert.ok((await page.locator("#sample-wall path.stone").count()) > 0);
  assert.match(
    await page.locator("#sample .replay").innerText(),
    new RegExp(`^wythe replay DIR --sample ${opened} --out`),
  );
});

test("one sample is stepped through at every stored state", async () => {
  await page.locator("#sample-number").fill("3");
  await page.locator("#sample-number").press("Enter");
  const stored = Number(
    execFileSync("python3", [
      "-c",
      `
import sqlite3
print(sqlite3.connect(r"${path.join(folder("campaign"), "campaign.db")}").execute("SELECT COUNT(*) FROM state WHERE sample = 3").fetchone()[0])
`,
    ]),
  );
  assert.ok(stored > 1);
  const slider = page.locator("#sample-wall .time input");
  await slider.focus();
  await page.keyboard.press("Home");
  const seen = new Set();
  for (let i = 0; i < stored; ++i) {
    const words = await page.locator("#sample-wall .wall-caption").innerText();
    assert.match(words, /^sample 3\b/);
    const line = await page.locator("#sample-curve .cursor-line").getAttribute("x1");
    seen.add(`${words} ${line} ${await page.locator("#sample-wall path.stone0").getAttribute("d")}`);
    await page.keyboard.press("ArrowRight");
  }
  assert.equal(seen.size, stored);
  await page.emulateMedia({ media: "print" });
  await page.evaluate(() => window.dispatchEvent(new Event("beforeprint")));
  assert.equal(await page.locator("#sample .pictures figure").count(), stored);
  await page.evaluate(() => window.dispatchEvent(new Event("afterprint")));
  await page.emulateMedia({ media: null });
});

test("all samples stay above their groups however a table is sorted", async () => {
  await page.locator("#table3-quantity").selectOption({ index: 0 });
  const first = () => page.locator("#table3-rows tbody th").first().innerText();
  for (const column of [0, 1, 2, 2, 0]) {
    await page.locator("#table3-rows thead button").nth(column).click();
    assert.equal(await first(), "all", `column ${column}`);
  }
  for (const list of await page.locator("#sensitivity select").last().locator("option").allInnerTexts().then((t) => [t]))
    assert.equal(list[0], "all");
});

test("forces and stresses are in kN and MPa, whatever unit the study has", async () => {
  const words = await page.locator("#study").innerText();
  assert.doesNotMatch(words, /\t(N\/m|Pa|GPa\/m|GPa|N)\t/);
  const { pageUnit } = await viewerModule("base/texts");
  for (const [unit, factor] of [
    ["N/m", 1e-3],
    ["GPa/m", 1],
    ["GPa", 1e3],
    ["Pa", 1e-6],
  ])
    assert.equal(pageUnit(unit)[1], factor, unit);
});

test("the replay command of the page works and gives the same bits", async () => {
  const words = (await page.locator("#sample .replay").innerText())
    .split(" ")
    .slice(1)
    .map((w) => (w === "DIR" ? folder("campaign") : w));
  words[words.length - 1] = folder("replayed");
  assert.match(run(...words, "--quiet"), /equals that of the campaign, bit for bit/);
});

test("samples are reached by keyboard and number too", async () => {
  await page.locator("#sample-number").fill("3");
  await page.locator("#sample-number").press("Enter");
  assert.match(await page.locator("#sample .lead").innerText(), /^sample 3:/);
  await page.locator("#sample .button").nth(1).press("Enter");
  assert.match(await page.locator("#sample .lead").innerText(), /^sample 4:/);
  await page.locator("#sample-number").fill("99");
  await page.locator("#sample-number").press("Enter");
  assert.match(await page.locator("#sample").innerText(), /No sample 99/);
});

test("every figure exports what can be read", async () => {
  await page.locator("#sample-number").fill("2");
  await page.locator("#sample-number").press("Enter");
  const figures = await page.locator("figure[id]").evaluateAll((f) => f.map((e) => e.id));
  assert.ok(figures.length >= 14, figures.join());
  for (const id of figures) {
    const press = (kind) =>
      downloaded(page, () => page.locator(`[id="${id}"] [data-export=${kind}]`).click());
    const svg = (await press("svg")).toString();
    const fault = await page.evaluate(
      (text) =>
        new DOMParser().parseFromString(text, "image/svg+xml").querySelector("parsererror")?.textContent ??
        "",
      svg,
    );
    assert.equal(fault, "", id);
    const rows = (await press("csv")).toString().trim().split("\n");
    assert.ok(rows.length > 1, id);
  }
  const rows = (await downloaded(page, () => page.locator("#shares [data-export=csv]").click()))
    .toString()
    .trim()
    .split("\n");
  assert.equal(rows.length, 1 + Object.keys(s.shares).length);
});

test("pushes that end before the peak: lower bounds in words, correlated inputs with a caution", async () => {
  const short = makeCampaignOf("rising.toml", "rising");
  const n = short.samples.answered;
  assert.ok(2 * short.samples.still_rising > n && short.samples.named_earlier === n);
  const other = await open(browser, pageOf("rising"));
  assert.match(await other.locator("#headline .answer").innerText(), /resists at least .* on average/);
  const warning = await other.locator("#headline .warning").innerText();
  assert.ok(warning.includes(`In ${short.samples.still_rising} of ${n} samples the force was still rising`));
  assert.ok(warning.includes(`${n} of ${n} pushes ended before 12\u202fmm`), warning);
  const pairs = short.input_correlation.filter((c) => Math.abs(c.spearman) > 0.1);
  assert.ok(pairs.length > 0);
  const caution = await other.locator("#entangled").innerText();
  for (const c of pairs) assert.ok(caution.includes(`${c.a}, ${c.b} (`), caution);
  assert.deepEqual(await violations(other), []);
  assert.deepEqual(other.faults, []);
  await screenshot(other, "campaign_rising_1440_light");
  await other.context().close();
});

test("shares below a drift limit that no push reached are lower bounds, or unknown", async () => {
  const kinds = new Set();
  for (const name of ["rising", "falling"]) {
    const short = makeCampaignOf(`${name}.toml`, name);
    const other = await open(browser, pageOf(name));
    const cells = await other.locator("#drift-limits tbody tr td:last-child").allInnerTexts();
    assert.equal(cells.length, short.drift_limits.length);
    short.drift_limits.forEach((d, i) => {
      const kind =
        d.share_below === null ? "unknown" : d.share_below_is_lower_bound ? "at least" : "share";
      kinds.add(kind);
      assert.equal(cells[i].includes("unknown"), kind === "unknown", cells[i]);
      assert.equal(cells[i].startsWith("at least "), kind === "at least", cells[i]);
    });
    assert.deepEqual(other.faults, []);
    await other.context().close();
  }
  assert.deepEqual([...kinds].sort(), ["at least", "share", "unknown"]);
});

test("axe finds nothing, in light and dark, wide and narrow", () => assertReadable(browser, "campaign"));

test("a fragility shows every sample, and its law within the samples alone", async () => {
  const figure = page.locator("#fragility-input"),
    pairs = page.locator("#fragility-pair");
  assert.ok(s.fragility.length > 1);
  for (const [k, event] of s.fragility.entries()) {
    await page.locator(".pick-event").selectOption(String(k));
    for (const input of event.inputs) {
      await page.locator(".pick-fragility-input").selectOption(input.input);
      const dots = figure.locator("circle[data-outcome]");
      assert.equal(await dots.count(), event.n);
      assert.equal(await figure.locator('circle[data-outcome="1"]').count(), event.seen);
      assert.equal(await figure.locator("path[data-law]").count(), input.curve ? 1 : 0);
      assert.doesNotMatch(await figure.locator("figcaption").innerText(), /fragility[._]|undefined|NaN|\{/);
      if (!input.curve) continue;
      const at = await dots.evaluateAll((c) => c.map((e) => Number(e.getAttribute("cx"))));
      const line = (await figure.locator("path[data-law]").getAttribute("d"))
        .slice(1)
        .split("L")
        .map((p) => Number(p.split(" ")[0]));
      assert.ok(Math.min(...line) >= Math.min(...at) - 0.2 && Math.max(...line) <= Math.max(...at) + 0.2);
    }
    assert.equal(await pairs.locator("circle[data-outcome]").count(), event.n);
    assert.doesNotMatch(await pairs.locator("figcaption").innerText(), /fragility[._]|undefined|NaN|\{/);
  }
  const best = await page.locator("#measuring tbody tr").count();
  assert.ok(best > 0 && best <= s.measuring.length);
  assert.doesNotMatch(await page.locator("#surrogate-indices").textContent(), /indices[._]|undefined|NaN|\{/);
});

test("the wall of a sample shows its own field", async () => {
  fs.rmSync(folder("fields"), { recursive: true, force: true });
  const study = new URL("../../examples/random_field/study.toml", import.meta.url).pathname;
  run("campaign", study, "--out", folder("fields"), "--samples", "2", "--quiet", "--set", "stage.push.until=0.2 mm", "--set", "field.ft.upper=1.6");
  run("report", folder("fields"), "--lang", "it");
  const other = await open(browser, pageOf("fields"));
  const seen = [];
  for (const sample of [1, 2]) {
    await other.locator("#sample-number").fill(String(sample));
    await other.locator("#sample-number").blur();
    const choice = other.locator("#sample-wall select").first();
    const names = await choice.locator("option").allInnerTexts();
    const values = await choice.locator("option").evaluateAll((all) => all.map((o) => o.value));
    await choice.selectOption(values[names.indexOf("campo: ft")]);
    const words = await other.locator("#sample-wall .field-key").innerText();
    assert.match(words, /tensile_strength, estratto per questa parete; la media data nel modello: 0,\d+/);
    assert.match(words, /i limiti lasciano una dispersione \(CoV\) del 2\d,\d\s%; il 30,0\s% del file/);
    seen.push(words.split("material.")[0]);
    await choice.selectOption(values[names.indexOf("campo: c")]);
    assert.match(await other.locator("#sample-wall .field-key").innerText(), /segue una formula di altri campi/);
  }
  assert.notEqual(seen[0], seen[1]);
  assert.deepEqual(other.faults, []);
  await screenshot(other, "campaign_fields");
  await other.context().close();
});

test("prints as a sheet and an appendix of A4 pages", async () => {
  const pdf = await page.pdf({ preferCSSPageSize: true });
  fs.writeFileSync(path.join(folder("campaign"), "report.pdf"), pdf);
  assert.ok(pdfPages(pdf) >= 5 && pdfPages(pdf) <= 9, `${pdfPages(pdf)} pages`);
});

test("the first paint waits for neither scripts nor data", async () => {
  const html = fs.readFileSync(path.join(folder("campaign"), "report.html"), "utf8");
  const early = html.slice(0, html.indexOf('id="headline"')).match(/<script\b[^>]*>/g) ?? [];
  for (const script of early) assert.match(script, /type="module"|defer/, "a script that is run before the headline is read");
  assert.ok(html.indexOf('id="headline"') < html.indexOf('id="wythe-data"'), "the data come before the headline");
  const other = await open(browser, pageOf("campaign"), { javaScript: false });
  assert.match(await other.locator("#headline .answer").innerText(), /In 24 samples the wall resists/);
  await other.context().close();
});
