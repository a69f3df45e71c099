// The page of options side by side: a real study of two options on the same samples, one of which loses pairs.
import assert from "node:assert/strict";
import fs from "node:fs";
import path from "node:path";
import { after, before, test } from "node:test";
import { pathToFileURL } from "node:url";
import { downloaded, folder, launch, open, pdfPages, run, screenshot, violations } from "./helpers.mjs";
import { input, writeInputs } from "./small_study.mjs";

const kOptions = `
[[variant]]
name = "more load <script>alert('option')</script>"
set = ["stage.precompression.pier_load=120 kN"]
[[variant]]
name = "brittle mortar"
set = ["material.joint.mode_1_energy=1 N/m"]
`;
const out = folder("comparison");
const url = pathToFileURL(path.join(out, "comparison.html")).href;
let browser, page, c;

before(async () => {
  writeInputs();
  const study = fs.readFileSync(input("study.toml"), "utf8").replace("samples = 24", "samples = 12");
  fs.writeFileSync(input("options.toml"), study + kOptions);
  fs.rmSync(out, { recursive: true, force: true });
  try {
    run("campaign", input("options.toml"), "--out", out, "--quiet");
  } catch (error) {
    if (error.status !== 3) throw error;
  }
  c = JSON.parse(fs.readFileSync(path.join(out, "comparison.json"), "utf8"));
  browser = await launch();
  page = await open(browser, url);
});
after(() => browser?.close());

test("opens without errors, requests or dialogs; names of options are text", async () => {
  assert.deepEqual(page.faults, []);
  assert.match(await page.locator("#headline .answer").innerText(), /More load <script>/);
});

test("the first sentences are the headlines, and every option has its card", async () => {
  const answer = await page.locator("#headline .answer").innerText();
  for (const option of c.option) assert.ok(answer.toLowerCase().includes(option.headline.slice(0, 20).toLowerCase()), option.headline);
  assert.equal(await page.locator(".cards .card").count(), 2);
  assert.match(await page.locator(".cards .card .value").first().innerText(), /^[+−]?[\d.]+/);
});

test("the forest shows every ratio that is known", async () => {
  const known = c.option.flatMap((o) => Object.values(o.response)).filter((r) => r.ratio_interval[0] !== null);
  assert.equal(await page.locator("#forest svg.plot circle.dot").count(), known.length);
});

test("every pair is a point; another response and option can be chosen", async () => {
  const dots = page.locator("#pairs svg.plot circle.dot");
  const first = c.option.find((o) => o.pairs > 0);
  assert.equal(await dots.count(), first.response.peak_reaction_kN.pairs);
  await page.locator("#pairs .pick-response").selectOption("initial_stiffness_kN_per_mm");
  assert.equal(await dots.count(), first.response.initial_stiffness_kN_per_mm.pairs);
  const changed = first.modes.changed.length;
  assert.equal(await page.locator("#pairs svg.plot circle.m1").count() <= changed, true);
});

test("who gains: the difference against each input", async () => {
  const peak = c.option[0].response.peak_reaction_kN;
  assert.equal(await page.locator("#gain svg.plot circle.dot").count(), peak.gain.length > 0 ? peak.pairs : 0);
  const csv = (await downloaded(page, () => page.locator("#gain [data-export=csv]").click())).toString();
  assert.equal(csv.trim().split("\n").length, peak.pairs + 1);
});

test("lost pairs are listed with their reasons", async () => {
  for (const option of c.option.filter((o) => o.lost > 0))
    assert.ok((await page.locator("#lost").innerText()).includes(`${option.lost} of ${option.lost + option.pairs} pairs lost`));
});

test("is accessible, and fits a phone", async () => {
  assert.deepEqual(await violations(page), []);
  await screenshot(page, "comparison");
  const phone = await open(browser, url, { width: 390 });
  assert.equal(await phone.evaluate(() => document.documentElement.scrollWidth <= 390), true);
  await screenshot(phone, "comparison_phone");
  const dark = await open(browser, url, { scheme: "dark" });
  await screenshot(dark, "comparison_dark");
  assert.deepEqual(phone.faults.concat(dark.faults), []);
});

test("prints on four pages at most", async () => {
  const pdf = await page.pdf({ format: "A4" });
  fs.writeFileSync(path.join(out, "comparison.pdf"), pdf);
  assert.ok(pdfPages(pdf) <= 4, `${pdfPages(pdf)} pages`);
});

test("is written again in Italian", async () => {
  run("compare", out, "--out", folder("comparison_it"), "--lang", "it");
  const italian = await open(browser, pathToFileURL(path.join(folder("comparison_it"), "comparison.html")).href);
  assert.match(await italian.locator("#headline .answer").innerText(), /forza di picco/);
  const words = await italian.locator("main").innerText();
  for (const english of ["Pair by pair", "difference", "What was compared", "lost pairs"])
    assert.ok(!words.includes(english), english);
  assert.deepEqual(italian.faults, []);
});
