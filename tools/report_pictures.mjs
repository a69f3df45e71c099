#!/usr/bin/env node
// Pictures of sample reports: docs/figures/report_run.png, report_campaign.png, report_comparison.png.
//
//   tools/report_pictures.mjs RUN_DIR CAMPAIGN_DIR COMPARISON_DIR
//   tools/report_pictures.mjs --wall RUN_DIR PICTURE.png     the wall of a run at its end, as in examples/*/wall.png
//   tools/report_pictures.mjs --sheet DIR PICTURE.png        the sheet of a verdict (wythe assess) as it is printed
//   tools/report_pictures.mjs --joint ANSWER.csv PICTURE.svg what wythe contact wrote, as in examples/joint_law/curve.svg
//
// RUN_DIR and CAMPAIGN_DIR are results of examples/tuff_wall (make demo), COMPARISON_DIR of examples/what_if; "-" leaves
// one out. Needs make web's packages and
// Chromium.
import { createRequire } from "node:module";
import { existsSync, readFileSync, writeFileSync } from "node:fs";
import path from "node:path";
import { fileURLToPath, pathToFileURL } from "node:url";

const root = path.resolve(path.dirname(fileURLToPath(import.meta.url)), "..");
const { chromium } = createRequire(path.join(root, "web/package.json"))("playwright-core");
const [run, campaign, comparison] = process.argv.slice(2);
if (!comparison) {
  console.error("usage: tools/report_pictures.mjs RUN_DIR CAMPAIGN_DIR COMPARISON_DIR | --wall RUN_DIR PICTURE.png | --sheet DIR PICTURE.png | --joint ANSWER.csv PICTURE.svg");
  process.exit(2);
}
// Stress over opening, and shear stress over slip: two frames side by side.
function jointPicture(answer, picture) {
  const [head, ...rows] = readFileSync(answer, "utf8").trim().split("\n").map((line) => line.split(","));
  const frame = ([xs, ys], left, label) => {
    const [x, y] = [xs, ys].map((name) => rows.map((row) => Number(row[head.indexOf(name)])));
    const place = (values, from, to) => {
      const [least, most] = [Math.min(0, ...values), Math.max(0, ...values)];
      return (value) => from + ((value - least) / (most - least)) * (to - from);
    };
    const [px, py] = [place(x, left, left + 170), place(y, 240, 30)];
    const points = x.map((value, k) => `${px(value).toFixed(1)},${py(y[k]).toFixed(1)}`).join(" ");
    const [ox, oy] = [px(0), py(0)];
    return `<path d="M${left} ${oy}H${left + 175}M${ox} 25V245" stroke="#667" fill="none"/>
<polyline points="${points}" fill="none" stroke="#b5541f" stroke-width="2"/>
<text x="${left}" y="16">${label[1]}, up to ${Math.max(...y).toFixed(2)} MPa</text>
<text x="${left}" y="268">over ${label[0]}, up to ${Math.max(...x).toFixed(2)} mm</text>`;
  };
  const frames = [
    frame(["opening_mm", "normal_stress_MPa"], 20, ["opening", "normal stress"]),
    frame(["slip_mm", "shear_stress_MPa"], 230, ["slip", "shear stress"]),
  ];
  writeFileSync(
    picture,
    `<svg xmlns="http://www.w3.org/2000/svg" width="420" height="280" viewBox="0 0 420 280" font-family="sans-serif" font-size="12" fill="#334">
${frames.join("\n")}
</svg>
`,
  );
}

if (run === "--joint") {
  jointPicture(campaign, comparison);
  process.exit(0);
}
const browser = await chromium.launch({
  executablePath: process.env.CHROMIUM ?? ["/usr/bin/chromium-headless-shell", "/usr/bin/chromium"].find((file) => existsSync(file)),
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
  const wall = page.locator("#push svg.wall, #wall .space-stage canvas").first(); // in the plane, in space
  for (let width = 500, k = 0; k < 3; ++k) {
    await page.setViewportSize({ width, height: 1000 });
    await page.evaluate(() => new Promise((done) => requestAnimationFrame(() => requestAnimationFrame(done))));
    width += kWide - Math.round((await wall.boundingBox()).width);
  }
  await wall.screenshot({ path: picture });
}

// A4 less its margins; the page of a verdict needs no script.
async function sheetPicture(folder, picture) {
  const page = await browser.newPage({ viewport: { width: 703, height: 1000 }, deviceScaleFactor: 1 });
  await page.goto(pathToFileURL(path.join(path.resolve(folder), "report.html")).href);
  await page.emulateMedia({ media: "print" });
  await page.addStyleTag({ content: ".sheet { padding: 16px }" });
  await page.locator(".sheet").screenshot({ path: picture });
}

if (run === "--sheet") await sheetPicture(campaign, comparison);
else if (run === "--wall") await wallPicture(campaign, comparison);
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
