// The studio in a browser, for its tests: the page is built once, and its workers are answered by the program's own
// library (engine.py) in the place of WebAssembly.
import { execFileSync, spawn } from "node:child_process";
import { createHash } from "node:crypto";
import fs from "node:fs";
import path from "node:path";
import { createInterface } from "node:readline";
import { pathToFileURL } from "node:url";
import { filesIn, folder, launch as launchBrowser, root } from "./helpers.mjs";

const build = process.env.BUILD ?? path.join(root, "build/release");
export const kLibrary = path.join(build, "libwythe.so");
// Debian's own: what stands for python3 on a PATH may take ten times as long to start, and each worker starts one.
export const kPython = "/usr/bin/python3";
export const kPatience = 120000; // [ms]; only a defect takes as long

// A wall of large stones: pushed in a second.
export const kWall = `name = "wall of large stones"

[wall]
length = "2.4 m"
height = "1.6 m"
thickness = "0.4 m"

[wall.unit]
length = "400 mm"
height = "200 mm"
split = "none"
density = "1800 kg/m^3"

[masonry]
use = "clay_brick_old"
vertical_stress = "0.1 MPa"
shear_modulus = "rule"
unit_youngs_modulus = "rule"

[material.joint]
missing = "rule"

[material.unit]
missing = "rule"

[[stage]]
name = "gravity"

[[stage]]
name = "floor"
pressure = "0.1 MPa"

[[stage]]
name = "push"
at = { x = "0 m", y = "1.5 m" }
velocity = "1 mm/s"
until = "4 mm"
`;

// Every place that the page is made of: pages built of the same files are the same.
const kSources = ["web/src", "web/studio.html", "web/texts_of.js", "web/tsconfig.json", "web/vite.studio.config.js", "web/package-lock.json"]
  .concat(["src/report/assets", "apps/wasm", "examples", "tests/web/studio.mjs"]).map((name) => path.join(root, name));
function stampOf(places) {
  const hash = createHash("sha256");
  for (const file of places.flatMap((place) => (fs.statSync(place).isDirectory() ? filesIn(place).sort() : [place]))) {
    const { size, mtimeMs } = fs.statSync(file);
    hash.update(`${file} ${size} ${mtimeMs}\n`);
  }
  return hash.digest("hex").slice(0, 16);
}

// studio.html as `make studio` builds it, with a mark in the place of the engine; or with the engine of `folder`. The first test that asks
// builds it for all, in a folder of its own, for two may begin at once. Pages that no test asked for in a week go.
export function studioPage(engine) {
  const out = folder("studio");
  const file = path.join(out, `page_${stampOf(engine ? [...kSources, path.join(engine, "wythe.js"), path.join(engine, "wythe.wasm")] : kSources)}.html`);
  if (fs.existsSync(file)) {
    fs.utimesSync(file, new Date(), new Date());
    return file;
  }
  const own = path.join(out, String(process.pid)); // also where the finished page lies until it is whole
  fs.mkdirSync(own, { recursive: true });
  for (const old of fs.readdirSync(out).filter((name) => /^page_.*html$/.test(name)).map((name) => path.join(out, name)))
    if (Date.now() - (fs.statSync(old, { throwIfNoEntry: false })?.mtimeMs ?? Infinity) > 7 * 86400e3) fs.rmSync(old, { force: true });
  execFileSync("npx", ["vite", "build", "--config", "vite.studio.config.js"], {
    cwd: path.join(root, "web"),
    env: { ...process.env, STUDIO_OUT: own },
    stdio: "pipe",
  });
  const [built, made] = ["studio.html", "made.html"].map((name) => path.join(own, name));
  if (engine) execFileSync(process.execPath, [path.join(root, "apps/wasm/page.mjs"), built, engine, made], { stdio: "pipe" });
  else fs.writeFileSync(made, fs.readFileSync(built, "utf8").replace("<!--wythe:worker-->", "/* answered by the test */"));
  fs.renameSync(made, file);
  fs.rmSync(own, { recursive: true });
  return file;
}

// In the page: workers that hand their questions to the test. The limit load is asked for after each edit and takes most of the engine's
// time, so it is answered where a test says `limit: true`; else the page waits and then says that it takes too long.
function fakeWorkers() {
  window.testWorkers = [];
  window.Worker = class {
    constructor() {
      this.number = window.testWorkers.push(this) - 1;
    }
    postMessage(question) {
      if ("wasm" in question) queueMicrotask(() => this.onmessage({ data: { ready: true, version: "test" } }));
      else if (question.task !== "limit" || window.testLimit) void window.testAsk(this.number, JSON.stringify(question));
    }
    terminate() {
      this.onmessage = () => undefined;
      void window.testAsk(this.number, "");
    }
  };
}

export async function openStudio(browser, file, options = {}) {
  const context = await browser.newContext({
    viewport: { width: options.width ?? 1440, height: options.height ?? 900 },
    colorScheme: options.scheme ?? "light",
    hasTouch: options.touch ?? false,
    locale: options.locale ?? "en-GB",
    acceptDownloads: true,
  });
  context.setDefaultTimeout(kPatience);
  const page = await context.newPage();
  page.faults = [];
  page.on("console", (m) => m.type() === "error" && page.faults.push(`console: ${m.text()}`));
  page.on("pageerror", (e) => page.faults.push(`error: ${e.message}`));
  const address = pathToFileURL(file).href;
  page.on("request", (r) => {
    if (!/^(data|blob):/.test(r.url()) && r.url().split("#")[0] !== address) page.faults.push(`request: ${r.url()}`);
  });
  const children = new Map();
  await page.exposeFunction("testAsk", (number, question) => {
    if (question === "") {
      children.get(number)?.kill("SIGKILL");
      return void children.delete(number);
    }
    if (!children.has(number)) {
      const child = spawn(kPython, [path.join(root, "tests/web/engine.py"), kLibrary], { stdio: ["pipe", "pipe", "inherit"] });
      createInterface({ input: child.stdout }).on("line", (line) => {
        page
          .evaluate(
            ([k, text]) => {
              const data = JSON.parse(text);
              for (const table of Object.values(data.tables ?? {}))
                for (const name of Object.keys(table)) table[name] = Float64Array.from(table[name]);
              window.testWorkers[k].onmessage({ data });
            },
            [number, line],
          )
          .catch(() => undefined); // the page is gone
      });
      children.set(number, child);
    }
    children.get(number).stdin.write(`${question}\n`);
  });
  if (options.limit) await page.addInitScript(() => (window.testLimit = true));
  if (!options.own) await page.addInitScript(fakeWorkers);
  page.on("close", () => {
    for (const child of children.values()) child.kill("SIGKILL");
  });
  page.end = () => context.close();
  await page.goto(address + (options.hash ?? ""));
  await page.waitForSelector("html[data-ready]");
  if (!options.impatient) await stonesOf(page);
  return page;
}
export const launch = launchBrowser;

// Waits until the stones belong to the text as it is, or to the state of the push that is shown.
export async function stonesOf(page) {
  await page.waitForFunction(
    () => ["typing", "checking", "reading"].every((mark) => document.documentElement.dataset[mark] === undefined),
    null,
    { timeout: kPatience },
  );
}
// Puts a text into the file, as somebody who pastes it there.
export async function write(page, text) {
  await page.locator(".file-text").evaluate((area, text) => {
    area.value = text;
    area.dispatchEvent(new Event("blur"));
  }, text);
  await stonesOf(page);
}
export const textOf = (page) => page.locator(".file-text").inputValue();

// Pixels of a point of the wall [m].
export const pixelsOf = (page, x, y) =>
  page.evaluate(
    async ([x, y]) => {
      // A bar that got a line more makes the drawing smaller, one frame later: wait until two frames show it in one place.
      const placeOf = () => document.querySelector(".outline").getBoundingClientRect();
      let frame = placeOf();
      for (let still = 0; still < 2; ) {
        await new Promise(requestAnimationFrame);
        const now = placeOf();
        still = ["left", "bottom", "width", "height"].every((key) => now[key] === frame[key]) ? still + 1 : 0;
        frame = now;
      }
      const [length, height] = [...document.querySelectorAll(".numbers .group")]
        .flatMap((g) => [...g.querySelectorAll("input")])
        .filter((i) => ["Length", "Height", "Lunghezza", "Altezza"].includes(i.closest("label")?.firstChild.textContent))
        .slice(-2)
        .map((i) => Number(i.value));
      return [frame.left + (x / length) * frame.width, frame.bottom - (y / height) * frame.height];
    },
    [x, y],
  );

// As much of a page as sentences need, for tests of parts without a browser: `text` of an element is what it says.
class StandIn {
  children = [];
  classList = { toggle() {} };
  style = { setProperty() {} };
  setAttribute() {}
  addEventListener() {}
  focus() {}
  scrollIntoView() {}
  appendChild(child) {
    this.children.push(child);
  }
  append(...all) {
    this.children.push(...all);
  }
  replaceChildren(...all) {
    this.children = all;
  }
  set textContent(text) {
    this.children = [text];
  }
  get text() {
    return this.children.map((c) => c.text ?? String(c)).join(" ").replace(/\u202f/g, " ");
  }
}
export function standInForPage() {
  const createElement = () => new StandIn();
  globalThis.Node = StandIn;
  globalThis.window = globalThis;
  globalThis.document = { createElement, createElementNS: createElement, createTextNode: (text) => Object.assign(new StandIn(), { children: [text] }), querySelector: () => null, documentElement: { dataset: {} } };
}
