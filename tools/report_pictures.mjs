#!/usr/bin/env node
// Pictures of sample reports: docs/figures/report_run.png, report_campaign.png, report_comparison.png.
//
//   tools/report_pictures.mjs RUN_DIR CAMPAIGN_DIR COMPARISON_DIR
//   tools/report_pictures.mjs --wall RUN_DIR PICTURE.png     the wall of a run at its end, as in examples/*/wall.png
//
// RUN_DIR and CAMPAIGN_DIR are results of examples/tuff_wall (make demo), COMPARISON_DIR of examples/what_if; "-" leaves
// one out. Needs make web's packages and
// Chromium.
import { createRequire } from "node:module";
import path from "node:path";
import { fileURLToPath, pathToFileURL } from "node:url";

const root = path.resolve(path.dirname(fileURLToPath(import.meta.url)), "..");
const { chromium } = createRequire(path.join(root, "web/package.json"))("playwright-core");
const [run, campaign, comparison] = process.argv.slice(2);
if (!comparison) {
  console.error("usage: tools/report_pictures.mjs RUN_DIR CAMPAIGN_DIR COMPARISON_DIR | --wall RUN_DIR PICTURE.png");
  process.exit(2);
}
const browser = await chromium.launch({
  executablePath: process.env.CHROMIUM ?? "/usr/bin/chromium",
  args: ["--no-sandbox", "--disable-gpu", "--disable-background-networking"],
});
async function pageOf(folder, file, viewport) {
  const page = await browser.newPage({ viewport, deviceScaleFactor: 1 });
  await page.goto(pathToFileURL(path.join(path.resolve(folder), file)).href);
  await page.waitForFunction(() => document.documentElement.dataset.ready === "yes");
  return page;
}

async function wallPicture(folder, picture) {
  const kWide = 420; // pixels of the drawing
  const page = await pageOf(folder, "report.html", { width: 2 * kWide, height: 1000 });
  const wall = page.locator("#push svg.wall");
  for (let width = 500, k = 0; k < 3; ++k) {
    await page.setViewportSize({ width, height: 1000 });
    await page.evaluate(() => new Promise((done) => requestAnimationFrame(() => requestAnimationFrame(done))));
    width += kWide - Math.round((await wall.boundingBox()).width);
  }
  await wall.screenshot({ path: picture });
}

if (run === "--wall") await wallPicture(campaign, comparison);
else
  for (const [name, folder, file] of [
    ["report_run", run, "report.html"],
    ["report_campaign", campaign, "report.html"],
    ["report_comparison", comparison, "comparison.html"],
  ].filter((picture) => picture[1] !== "-")) {
    const page = await pageOf(folder, file, { width: 1280, height: 1120 });
    await page.screenshot({ path: path.join(root, `docs/figures/${name}.png`) });
  }
await browser.close();
