// Shared by the tests of the viewer: results of the program, made once;
// a browser; a page that is checked for errors and network requests.
import assert from "node:assert/strict";
import { execFileSync } from "node:child_process";
import { createRequire } from "node:module";
import fs from "node:fs";
import path from "node:path";
import { fileURLToPath, pathToFileURL } from "node:url";

export const root = path.resolve(path.dirname(fileURLToPath(import.meta.url)), "../..");
const require = createRequire(path.join(root, "web/package.json"));
const { chromium } = require("playwright-core");
export const esbuild = createRequire(require.resolve("vite")).call(null, "esbuild");
const kAxe = fs.readFileSync(require.resolve("axe-core/axe.min.js"), "utf8");

const build = process.env.BUILD ?? path.join(root, "build/release");
const wythe = process.env.WYTHE ?? path.join(build, "wythe");
export const results = path.join(build, "tests/web");
export const shots = path.join(root, "build/screenshots");

export function run(...words) {
  return execFileSync(wythe, words, { encoding: "utf8", stdio: ["ignore", "pipe", "pipe"] });
}
export const folder = (name) => path.join(results, name);
export const filesIn = (dir) =>
  fs.readdirSync(dir, { withFileTypes: true }).flatMap((e) => (e.isDirectory() ? filesIn(path.join(dir, e.name)) : [path.join(dir, e.name)]));
export const pageOf = (name) => pathToFileURL(path.join(folder(name), "report.html")).href;

// --- what the engine wrote beside ----------------------------------------------------------------------

// Points of the last state of a run in the engine's VTK files.
export function lastPoints(name, kind) {
  const files = fs
    .readdirSync(folder(name))
    .filter((n) => n.startsWith(`state_${kind}`))
    .sort();
  const vtu = fs.readFileSync(path.join(folder(name), files.at(-1)), "utf8");
  const bytes = Buffer.from(/Name="Points"[^>]*>([^<]*)</.exec(vtu)[1], "base64");
  return new Float64Array(bytes.buffer.slice(bytes.byteOffset + 8, bytes.byteOffset + bytes.length));
}

// --- browser -----------------------------------------------------------------------------------------

export const browserPath = process.env.CHROMIUM ?? ["/usr/bin/chromium-headless-shell", "/usr/bin/chromium"].find((file) => fs.existsSync(file));
const kArguments = [
  "--no-sandbox",
  "--no-first-run",
  "--disable-background-networking",
  "--disable-component-update",
  "--disable-sync",
  "--disable-gpu",
];

export const launch = (...more) =>
  chromium.launch({ executablePath: browserPath, args: [...kArguments, ...more] });

// Waits until the viewer has no work left (data-ready) and the frames have passed in which the browser tells
// figures their widths.
const drawn = (page) =>
  page.evaluate(
    () =>
      new Promise((done) => {
        const look = (frames) =>
          requestAnimationFrame(() => {
            if (!document.documentElement.dataset.ready) look(2);
            else if (frames > 0) look(frames - 1);
            else done();
          });
        look(1);
      }),
  );

// Whatever a test reads of a page, it reads when all of it is drawn: no count comes too early.
const kReads = ["allInnerTexts", "allTextContents", "boundingBox", "count", "evaluate", "evaluateAll"].concat(
  ["getAttribute", "innerText", "inputValue", "screenshot", "textContent"],
);
function readOnlyWhatIsDrawn(page) {
  const locator = Object.getPrototypeOf(page.locator("html"));
  if (locator.readsWhatIsDrawn) return;
  locator.readsWhatIsDrawn = true;
  for (const name of kReads) {
    const read = locator[name];
    locator[name] = async function (...words) {
      if (this.page().hasScripts) await drawn(this.page());
      return read.apply(this, words);
    };
  }
}

// A new page of a context of its own. `page.faults` collects what must not happen.
async function newPage(browser, hasScripts) {
  const context = await browser.newContext({
    viewport: { width: 1440, height: 900 },
    acceptDownloads: true,
    javaScriptEnabled: hasScripts,
  });
  const page = await context.newPage();
  readOnlyWhatIsDrawn(page);
  page.on("console", (m) => {
    if (m.type() === "error") page.faults.push(`console: ${m.text()}`);
  });
  page.on("pageerror", (e) => page.faults.push(`error: ${e.message}`));
  page.on("request", (r) => {
    if (!/^(file|data|blob):/.test(r.url()) || (r.url().startsWith("file:") && r.url() !== page.asked))
      page.faults.push(`request: ${r.url()}`);
  });
  page.on("dialog", (d) => {
    page.faults.push(`dialog: ${d.message()}`);
    void d.dismiss();
  });
  return page;
}

// Pages that were closed, by browser and by whether they have scripts. A context and its process take more than half of what opening a page
// takes, so the next one to open gets an old one, empty and without memory.
const kIdle = new WeakMap();
async function putAway(page, idle) {
  page.hasScripts = false; // nothing is waited for
  if (page.url().startsWith("file:"))
    await page.evaluate(() => {
      localStorage.clear();
      sessionStorage.clear();
    });
  await page.goto("about:blank");
  idle.push(page);
}

// Opens a page and waits until it is built. `page.context().close()` ends it.
export async function open(browser, url, options = {}) {
  const hasScripts = options.javaScript ?? true;
  if (!kIdle.has(browser)) kIdle.set(browser, { true: [], false: [] });
  const idle = kIdle.get(browser)[hasScripts];
  const page = idle.pop() ?? (await newPage(browser, hasScripts));
  page.context().close = () => putAway(page, idle);
  page.faults = [];
  page.asked = url;
  const size = { width: options.width ?? 1440, height: 900 };
  if (JSON.stringify(page.viewportSize()) !== JSON.stringify(size)) await page.setViewportSize(size);
  await page.emulateMedia({ media: null, colorScheme: options.scheme ?? "light", reducedMotion: "reduce" });
  await page.goto(url);
  page.hasScripts = hasScripts;
  if (hasScripts) await drawn(page);
  return page;
}

// Chromium drops downloads that follow each other too closely: ten a second. A slow machine is only farther
// from that.
export async function downloaded(page, click) {
  await page.waitForTimeout(150);
  const [download] = await Promise.all([page.waitForEvent("download"), click()]);
  return fs.readFileSync(await download.path());
}

// Violations of axe-core on a page or in parts of it, one line each. A page reads axe-core's half a megabyte once.
export async function violations(page, parts = "html") {
  if (!(await page.evaluate(() => "axe" in window))) await page.evaluate(kAxe);
  return page.evaluate(async (parts) => {
    const { violations } = await window.axe.run(parts, { resultTypes: ["violations"] });
    return violations.map((v) => `${v.id}: ${v.nodes.map((n) => `${n.target.join(" ")} ${n.failureSummary}`).join("; ")}`);
  }, parts);
}

// Axe finds nothing on the page, and it is no wider than the screen: light and dark, on a desktop and on a phone.
export async function assertReadable(browser, name) {
  for (const [scheme, width] of [["light", 1440], ["light", 390], ["dark", 1440], ["dark", 390]]) {
    const page = await open(browser, pageOf(name), { width, scheme });
    assert.deepEqual(await violations(page), [], `${name}, ${scheme}, ${width} px`);
    assert.ok(await page.evaluate(() => document.documentElement.scrollWidth <= window.innerWidth), `${name} is wider than ${width} px`);
    await screenshot(page, `${name}_${width}_${scheme}`);
    await page.context().close();
  }
}

// Pages of a PDF: its page objects; streams of Chromium's PDFs leave them readable.
export const pdfPages = (pdf) => (pdf.toString("latin1").match(/\/Type\s*\/Page\b(?!s)/g) ?? []).length;

// Whether pictures are asked for, which a person then looks at: one takes a second of a core, and no test reads it.
export const wantsPictures = Boolean(process.env.WYTHE_PICTURES);

// The whole page, or one part of it, as a picture in build/screenshots if such are wanted. It must be there in any case.
export async function screenshot(page, name, part = "") {
  if (!wantsPictures) {
    if (!(await page.locator(part || "body").isVisible())) throw new Error(`${name}: ${part || "the page"} is not shown`);
    return;
  }
  fs.mkdirSync(shots, { recursive: true });
  const file = path.join(shots, `${name}.png`);
  if (part) {
    await page.addStyleTag({ content: ".bar { position: static !important }" }); // or it lies over the part
    await page.locator(part).screenshot({ path: file });
  } else await page.screenshot({ path: file, fullPage: true });
}

// --- TypeScript of the viewer ---------------------------------------------------------------------------

// A module of web/src as it is, bundled for Node.
export async function viewerModule(name) {
  const outfile = path.join(results, "modules", `${name}.mjs`);
  await esbuild.build({
    entryPoints: [path.join(root, "web/src", `${name}.ts`)],
    outfile,
    bundle: true,
    format: "esm",
    platform: "node",
    logLevel: "error",
  });
  return import(pathToFileURL(outfile).href);
}
