// The page of a campaign over records: fragilities, response over intensity, scatter.
import assert from "node:assert/strict";
import fs from "node:fs";
import path from "node:path";
import { after, before, test } from "node:test";
import { folder, launch, open, pageOf, root, run, screenshot, violations } from "./helpers.mjs";

let browser, page, statistics;

before(async () => {
  fs.rmSync(folder("shaken"), { recursive: true, force: true });
  run(
    "campaign",
    path.join(root, "examples/parapet_fragility/study.toml"),
    "--out",
    folder("shaken"),
    "--samples",
    "2",
    "--set",
    "shaking.step=2 m/s^2",
    "--set",
    "shaking.halvings=0",
    "--quiet",
  );
  statistics = JSON.parse(fs.readFileSync(path.join(folder("shaken"), "statistics.json"), "utf8"));
  browser = await launch();
  page = await open(browser, pageOf("shaken"));
});
after(() => browser?.close());

test("opens without errors, requests or dialogs", () => assert.deepEqual(page.faults, []));

test("the headline tells shakes, walls, records and a median for each limit state that is told", async () => {
  const words = await page.locator("#headline .answer").innerText();
  const { shakes, walls, records } = statistics.shaking;
  assert.ok(words.startsWith(`${shakes} shakes`), words);
  assert.ok(words.includes(`${walls} walls under ${records} records`), words);
  assert.ok(statistics.fragility.some((f) => f.verdict === "told") && statistics.fragility.some((f) => f.verdict !== "told"));
  for (const f of statistics.fragility) assert.equal(words.includes(f.limit_state), f.verdict === "told");
  assert.equal(await page.locator(".card").count(), statistics.fragility.length);
});

test("each limit state has its figure: a point for each intensity, a curve and a band where it is told", async () => {
  for (const [i, f] of statistics.fragility.entries()) {
    const figure = page.locator(`#limit-state-${i + 1}`);
    assert.equal(await figure.locator("path.force").count(), f.verdict === "told" ? 1 : 0);
    const reached = await figure.locator("circle[data-n]").evaluateAll((dots) => dots.map((d) => +d.dataset.reached));
    // up to one intensity above the last that some sample stood
    const last = f.counts.findLastIndex((c) => c.share < 1);
    assert.deepEqual(
      reached,
      f.counts.slice(0, last + 3).map((c) => c.reached),
    );
  }
});

test("the response has a line for each sample", async () => {
  assert.equal(await page.locator("#shaken-response path.base").count(), statistics.shaking.samples);
});

test("pushes have no part in the page", async () => {
  for (const id of ["capacity", "modes", "all-curves", "influence"])
    assert.equal(await page.locator(`#${id}`).count(), 0);
});

test("no rule of accessibility is broken", async () => assert.deepEqual(await violations(page), []));

test("nothing is wider than a phone", async () => {
  await page.setViewportSize({ width: 390, height: 800 });
  assert.ok(await page.evaluate(() => document.documentElement.scrollWidth <= innerWidth));
  await screenshot(page, "shaken_phone");
  await page.setViewportSize({ width: 1200, height: 900 });
  await screenshot(page, "shaken");
});
