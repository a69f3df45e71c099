// The page of a shaken building: a strip for each storey, and the table of their drifts.
import assert from "node:assert/strict";
import fs from "node:fs";
import path from "node:path";
import { after, before, test } from "node:test";
import { folder, launch, open, pageOf, root, run, screenshot, violations } from "./helpers.mjs";

let browser, page, storeys;

before(async () => {
  fs.rmSync(folder("shake"), { recursive: true, force: true });
  run("run", path.join(root, "tests/data/shaken_storeys.toml"), "--out", folder("shake"), "--quiet");
  storeys = JSON.parse(fs.readFileSync(path.join(folder("shake"), "summary.json"), "utf8")).shaking.storeys;
  browser = await launch();
  page = await open(browser, pageOf("shake"));
});
after(() => browser?.close());

test("opens without errors, requests or dialogs", () => assert.deepEqual(page.faults, []));

test("each storey has its strip, the uppermost above, and its line in the table", async () => {
  assert.equal(storeys.length, 2);
  const figure = page.locator("#shake-storeys");
  assert.equal(await figure.locator("path.force").count(), storeys.length);
  const labels = await figure.locator("svg svg").evaluateAll((strips) => strips.map((s) => s.textContent));
  assert.ok(labels[0].includes("first") && labels[1].includes("ground"), labels.join(" | "));
  const rows = page.locator("#shake table", { hasText: "first" }).locator("tbody tr");
  assert.equal(await rows.count(), storeys.length);
  const peak = (text) => parseFloat(text.split("\t")[2]);
  for (const [i, storey] of [...storeys].reverse().entries()) {
    const text = await rows.nth(i).innerText();
    assert.ok(text.startsWith(storey.name), text);
    assert.ok(Math.abs(peak(text) - storey.peak_drift_percent) < 0.06, text);
  }
});

test("no accessibility violations", async () => assert.deepEqual(await violations(page), []));

test("fits a phone and a sheet of paper", async () => {
  await screenshot(page, "shake_desktop");
  await page.setViewportSize({ width: 390, height: 844 });
  assert.ok(await page.evaluate(() => document.documentElement.scrollWidth <= innerWidth));
  await screenshot(page, "shake_phone");
  await page.emulateMedia({ media: "print" });
  await screenshot(page, "shake_print");
  await page.emulateMedia({ media: null });
});
