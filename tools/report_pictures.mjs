#!/usr/bin/env node
// Pictures of the two sample reports for the README: docs/figures/report_run.png, report_campaign.png.
//
//   tools/report_pictures.mjs RUN_DIR CAMPAIGN_DIR
//
// RUN_DIR and CAMPAIGN_DIR are results of examples/tuff_wall (make demo). Needs make web's packages and
// Chromium.
import { createRequire } from "node:module";
import path from "node:path";
import { fileURLToPath, pathToFileURL } from "node:url";

const root = path.resolve(path.dirname(fileURLToPath(import.meta.url)), "..");
const { chromium } = createRequire(path.join(root, "web/package.json"))("playwright-core");
const [run, campaign] = process.argv.slice(2);
if (!run || !campaign) {
  console.error("usage: tools/report_pictures.mjs RUN_DIR CAMPAIGN_DIR");
  process.exit(2);
}
const browser = await chromium.launch({
  executablePath: process.env.CHROMIUM ?? "/usr/bin/chromium",
  args: ["--no-sandbox", "--disable-gpu", "--disable-background-networking"],
});
for (const [name, folder, height] of [
  ["report_run", run, 1120],
  ["report_campaign", campaign, 1120],
]) {
  const page = await browser.newPage({ viewport: { width: 1280, height }, deviceScaleFactor: 1 });
  await page.goto(pathToFileURL(path.join(path.resolve(folder), "report.html")).href);
  await page.waitForFunction(() => document.documentElement.dataset.ready === "yes");
  await page.screenshot({ path: path.join(root, `docs/figures/${name}.png`) });
}
await browser.close();
