// The studio for everybody: no fault of axe and no page wider than its screen, light and dark, desktop, tablet and
// phone, a language for each; its worker's protocol; and a page without an engine.
import assert from "node:assert/strict";
import { execFileSync } from "node:child_process";
import fs from "node:fs";
import path from "node:path";
import { pathToFileURL } from "node:url";
import { after, before, test } from "node:test";
import { folder, root, run, shots, viewerModule, violations, wantsPictures } from "./helpers.mjs";
import { kPatience, kWall, launch, openStudio, stonesOf, studioPage, textOf, write } from "./studio.mjs";

let browser, file;
before(async () => {
  file = studioPage();
  browser = await launch();
});
after(() => browser?.close());

const picture = async (page, name) => {
  if (!wantsPictures) return;
  fs.mkdirSync(shots, { recursive: true });
  await page.screenshot({ path: path.join(shots, `${name}.png`) });
};

const kLocales = ["en-GB", "it-IT", "de-DE", "fr-CA", "es-AR", "pt-BR"];
for (const [k, [width, height]] of [[1440, 900], [820, 1180], [390, 844], [1920, 1080]].entries())
  for (const scheme of ["light", "dark"])
    test(`${width} px, ${scheme}`, async () => {
      const locale = kLocales[(2 * k + (scheme === "dark" ? 1 : 0)) % kLocales.length];
      const page = await openStudio(browser, file, { width, height, scheme, touch: width < 1000, locale });
      assert.equal(await page.getAttribute("html", "lang"), locale.slice(0, 2));
      await page.locator('[data-opening="0"]').click();
      assert.deepEqual(await violations(page), []);
      assert.ok(await page.evaluate(() => document.documentElement.scrollWidth <= window.innerWidth), "wider than the screen");
      await picture(page, `studio_${width}_${scheme}`);
      await page.locator(".canvas").focus();
      await page.keyboard.press("y");
      assert.ok(await page.locator(".family").isVisible());
      assert.deepEqual(await violations(page), []);
      assert.ok(await page.evaluate(() => document.documentElement.scrollWidth <= window.innerWidth), "the family is wider than the screen");
      await page.keyboard.press("Escape");
      await page.locator('[data-pane="file"].tab').click();
      await page.locator(".file-text").fill("[wall]\nlength = 3\n");
      await stonesOf(page);
      assert.deepEqual(await violations(page), []);
      const [numbers, lines] = await page.evaluate(() => [".lines", ".file-text"].map((css) => ["fontSize", "lineHeight", "paddingTop"].map((name) => getComputedStyle(document.querySelector(css))[name])));
      assert.deepEqual(numbers, lines, "numbers of lines do not stand beside them");
      await picture(page, `studio_fault_${width}_${scheme}`);
      await page.locator(".canvas").focus();
      await page.keyboard.press("Control+k");
      assert.deepEqual(await violations(page), []);
      assert.deepEqual(page.faults, []);
      await page.end();
    });

// One picture after the other of what a push finds: two results side by side, the other way, eight walls, a family with its slider.
const kShort = kWall.replace('"4 mm"', '"1 mm"');
async function push(page) {
  await page.locator(".primary").click();
  await page.waitForFunction(() => document.querySelector(".primary.running") === null && /kN/.test(document.querySelector(".key")?.textContent ?? ""), null, { timeout: kPatience });
  await stonesOf(page);
}
test("what a push finds, on a desktop and a phone, in both themes", async () => {
  const page = await openStudio(browser, file, { limit: true });
  const isFine = async (name) => {
    for (const [width, height] of [[1440, 900], [390, 844]])
      for (const colorScheme of ["light", "dark"]) {
        await page.setViewportSize({ width, height });
        await page.emulateMedia({ colorScheme });
        await page.waitForSelector(`html[data-theme="${colorScheme}"]`);
        assert.deepEqual(await violations(page), [], `${name}, ${width} px, ${colorScheme}`);
        assert.ok(await page.evaluate(() => document.documentElement.scrollWidth <= window.innerWidth), `${name}, ${width} px: wider than the screen`);
        const legend = await page.evaluate(() => ({
          isClear: document.querySelector(".curve-legend").hidden || document.querySelector(".curve-legend").getBoundingClientRect().top >= document.querySelector(".curve-box .curve").getBoundingClientRect().bottom,
          bare: [...document.querySelectorAll(".curve-legend li")].filter((li) => li.checkVisibility() && !li.querySelector("path").checkVisibility()).map((li) => li.textContent),
        }));
        assert.deepEqual(legend, { isClear: true, bare: [] }, `${name}, ${width} px: the legend lies on curves, or names one that is not drawn`);
        await picture(page, `studio_${name}_${width}_${colorScheme}`);
      }
    await page.setViewportSize({ width: 1440, height: 900 });
  };
  const action = (name) => page.locator(`[data-action="${name}"]`);
  await write(page, kShort);
  await push(page);
  await isFine("result");
  await action("keep").click();
  await write(page, kShort.replace('thickness = "0.4 m"', 'thickness = "0.5 m"'));
  await push(page);
  await page.locator(".pair figure").nth(1).waitFor();
  await action("other").click();
  await page.waitForSelector(".line.other", { timeout: kPatience });
  await action("walls").click();
  await page.waitForFunction(() => document.querySelectorAll(".one-wall").length === 8, null, { timeout: kPatience });
  await isFine("compare");
  await page.getByTitle("Vary Thickness").click();
  await action("family").click();
  await page.waitForFunction(() => document.querySelectorAll(".curve-box path.member").length === 5, null, { timeout: kPatience });
  await isFine("family");
  await page.locator(".starters").selectOption("frame");
  await stonesOf(page);
  await page.locator('[data-opening="0"]').click();
  await page.getByRole("button", { name: "Anchor it in the masonry" }).click();
  await stonesOf(page);
  await isFine("frame");
  await page.locator(".starters").selectOption("facade");
  await stonesOf(page);
  await page.locator('[data-part="floor 0"]').focus();
  await isFine("floor");
  await page.locator('.tool-button:has-text("Photo")').click();
  await isFine("photo");
  await page.setViewportSize({ width: 1280, height: 600 });
  await page.getByRole("button", { name: "Keys" }).click();
  assert.ok((await page.locator(".sheet-of-keys h2").boundingBox()).y >= 0, "the sheet of keys opens at its end");
  await isFine("keys");
  assert.deepEqual(page.faults, []);
  await page.end();
});

// As an enlarged page of 1440 x 900 has it, and a phone that lies.
for (const [width, height] of [[720, 450], [844, 390], [360, 225]])
  test(`a small window, ${width} x ${height}: one column, one row at its top, and what Tab reaches is seen`, async () => {
    const page = await openStudio(browser, file, { width, height });
    await write(page, kShort);
    await push(page);
    assert.ok(await page.evaluate(() => document.documentElement.scrollWidth <= window.innerWidth), "wider than the screen");
    const bar = await page.locator(".top").boundingBox();
    assert.ok(bar.height < 60, `${bar.height} px`);
    const hidden = [];
    for (let ends = 0; ends < 2; ) { // from the button that was pressed to the end, and once round
      await page.keyboard.press("Tab");
      const at = await page.evaluate(() => {
        const e = document.activeElement;
        if (e === document.body) return null;
        e.dataset.reached = "yes";
        const box = e.getBoundingClientRect(),
          bar = document.querySelector(".top");
        const isSeen = bar.contains(e) ? box.left >= -1 && box.right <= innerWidth + 1 : box.bottom > bar.getBoundingClientRect().bottom && box.top < innerHeight;
        const isMarked = e instanceof SVGElement || getComputedStyle(e).outlineStyle !== "none";
        return { name: e.getAttribute("aria-label") ?? e.textContent, fine: isSeen && isMarked };
      });
      if (at === null) ++ends;
      else if (!at.fine) hidden.push(at.name);
    }
    assert.deepEqual(hidden, []);
    const missed = await page.evaluate(() =>
      [...document.querySelectorAll("button, input, select, textarea, summary")].filter((e) => e.checkVisibility() && !e.disabled && e.tabIndex >= 0 && !e.dataset.reached).map((e) => e.getAttribute("aria-label") ?? e.textContent),
    );
    assert.deepEqual(missed, []);
    assert.deepEqual(page.faults, []);
    await page.end();
  });

test("a thumb looks, pushes and changes a number on a phone", async () => {
  const page = await openStudio(browser, file, { width: 390, height: 844, touch: true });
  await write(page, kShort);
  const session = await page.context().newCDPSession(page);
  const touch = (type, ...points) => session.send("Input.dispatchTouchEvent", { type, touchPoints: points.map(([x, y], id) => ({ x, y, id })) });
  const wide = async () => (await page.locator(".outline").boundingBox()).width;
  const before = await wide();
  await touch("touchStart", [170, 250], [220, 250]); // two fingers part
  for (let k = 1; k <= 5; ++k) await touch("touchMove", [170 - 10 * k, 250], [220 + 10 * k, 250]);
  await touch("touchEnd");
  assert.ok((await wide()) > 2 * before, `${before} px, then ${await wide()}`);
  await page.getByRole("button", { name: "Fit", exact: true }).tap();
  assert.ok(Math.abs((await wide()) - before) < 1);
  await page.getByLabel("Thickness").tap();
  await page.getByLabel("Thickness").fill("0.5");
  await page.locator('.tab:has-text("Numbers")').tap(); // the field is left, without Enter
  assert.match(await textOf(page), /thickness = "0\.5 m"/);
  await stonesOf(page);
  await page.locator(".primary").tap();
  await page.waitForFunction(() => document.querySelector(".primary.running") === null && document.querySelector(".key"), null, { timeout: kPatience });
  const slider = page.getByLabel("State of the push");
  await slider.scrollIntoViewIfNeeded();
  const box = await slider.boundingBox();
  const last = await slider.inputValue();
  await page.touchscreen.tap(box.x + 0.3 * box.width, box.y + box.height / 2);
  assert.ok(Number(await slider.inputValue()) < Number(last), `${await slider.inputValue()} of ${last}`);
  await stonesOf(page);
  assert.equal(await page.locator(".canvas.cracked").count(), 1);
  assert.deepEqual(page.faults, []);
  await page.end();
});

test("on paper there are the drawing, the answer and the numbers, dark or not, and no buttons", async () => {
  const page = await openStudio(browser, file, { scheme: "dark" });
  await write(page, kShort);
  await push(page);
  await page.evaluate(() => {
    window.addEventListener("beforeprint", () => (window.onPaper = [document.querySelector(".canvas").getAttribute("viewBox"), document.documentElement.dataset.theme]));
  });
  await page.pdf({ format: "A4" });
  assert.deepEqual(await page.evaluate(() => window.onPaper), [await page.evaluate(() => `0 0 ${document.querySelector(".canvas").clientWidth} ${document.querySelector(".canvas").clientHeight}`), "light"]);
  assert.equal(await page.getAttribute("html", "data-theme"), "dark");
  assert.equal(await page.locator(".canvas").getAttribute("viewBox"), null);
  await page.emulateMedia({ media: "print" });
  assert.equal(await page.locator("button:visible, summary:visible").count(), 0);
  for (const part of [".canvas", ".curve-box .curve", ".key", ".numbers"]) assert.ok(await page.locator(part).first().isVisible(), part);
  await page.end();
});

test("no other language has an English word left of the page's own, and an unknown one is English", async () => {
  for (const [locale, button] of [["it-IT", "Spingi"], ["de-AT", "Schieben"], ["fr-FR", "Pousser"], ["es-ES", "Empujar"], ["pt-PT", "Empurrar"], ["fi-FI", "Push"]]) {
    const page = await openStudio(browser, file, { locale });
    const words = await page.locator("body").innerText();
    assert.ok(words.includes(button), `${locale}: ${button}`);
    if (button !== "Push")
      for (const word of ["Push", "Length", "Height", "Thickness", "Wall", "Load", "File saved", "blocks", "Select"])
        assert.ok(!new RegExp(`\\b${word}\\b`).test(words), `${locale}: ${word}`);
    else assert.equal(await page.getAttribute("html", "lang"), "en");
    await write(page, '[wall]\nlength = 3\nheigth = "2 m"\n');
    const faults = await page.locator(".faults").innerText();
    assert.equal(/\b(missing|write|such|mean)\b/.test(faults), button === "Push", `${locale}: ${faults}`);
    await page.end();
  }
});

test("a finger draws a door", async () => {
  const page = await openStudio(browser, file, { width: 820, height: 1180, touch: true });
  await page.locator(".starters").selectOption("empty");
  await stonesOf(page);
  await page.locator('.tool-button:has-text("Door")').tap();
  const frame = await page.locator(".outline").boundingBox();
  const at = (x, y) => ({ x: frame.x + (x / 4) * frame.width, y: frame.y + frame.height - (y / 2.92) * frame.height });
  const session = await page.context().newCDPSession(page);
  const touch = (type, point) => session.send("Input.dispatchTouchEvent", { type, touchPoints: point ? [point] : [] });
  await touch("touchStart", at(1, 0.5));
  for (let k = 1; k <= 5; ++k) await touch("touchMove", at(1 + 0.2 * k, 0.5 + 0.3 * k));
  await touch("touchEnd");
  assert.match(await page.locator(".file-text").inputValue(), /name = "door 1"\nx = "1\.00 m"\ny = "0\.00 m"\nwidth = "1\.00 m"/);
  assert.deepEqual(page.faults, []);
  await page.end();
});

test("every material of the library can be chosen", async () => {
  const { kMaterials } = await viewerModule("studio/masonry/materials");
  const listed = run("materials").split("\n\n")[0].split("\n").slice(1).map((l) => l.trim().split(/\s+/)[0]);
  assert.deepEqual([...kMaterials].sort(), listed.sort());
  const { texts } = JSON.parse(fs.readFileSync(path.join(root, "src/report/assets/texts.json"), "utf8"));
  for (const name of kMaterials) assert.ok(`studio.material.${name}` in texts, name);
});

test("a real worker: made from the page's text, given its code, asked, and ended", async () => {
  const worker = `onmessage = ({ data }) => {
    if ("wasm" in data) return postMessage({ ready: true, version: new TextDecoder().decode(data.wasm) });
    if (data.task === "check") {
      const text = { blocks: 7, weight_kN: 1, expected_seconds: 2, length_m: 3.5, notes: [] };
      const svg = '<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 20 20"><script>document.title="owned"</' + 'script><style>*{display:none}</style>' +
        '<path class="rest" d="M1.0 9.0L1.0 1.0L8.0 1.0L8.0 9.0"/><path class="stone0" onclick="x()" style="fill:red" d="M1 9L2 9L2 8Z"/><image href="http://evil.example/x"/></svg>';
      const check = JSON.stringify(text);
      postMessage({ id: data.id, progress: { texts: { counts: check, svg } } });
      return postMessage({ id: data.id, code: 0, texts: { check, counts: check, svg }, tables: {} });
    }
    postMessage({ id: data.id, progress: { what: "push", share: 0.5, displacement_mm: 1, reaction_kN: 2 } });
  };`;
  const code = execFileSync("node", ["-e", "process.stdout.write(require('zlib').deflateRawSync('code').toString('base64'))"]).toString();
  const own = path.join(folder("studio"), `worker_${process.pid}.html`);
  const html = fs.readFileSync(file, "utf8").replace("/* answered by the test */", () => worker.replace(/<\//g, "<\\/")).replace("<!--wythe:wasm-->", code);
  fs.writeFileSync(own, html);
  const page = await browser.newPage();
  const wrong = [];
  page.on("pageerror", (e) => wrong.push(e.message));
  page.on("console", (m) => m.type() === "error" && wrong.push(m.text()));
  page.on("request", (r) => /^https?:/.test(r.url()) && wrong.push(r.url()));
  await page.goto(pathToFileURL(own).href);
  await page.waitForFunction(() => /^7 blocks/.test(document.querySelector(".status")?.textContent ?? ""));
  assert.equal(await page.locator(".stones .stone0").count(), 1);
  assert.equal(await page.locator(".stones .stone0").getAttribute("style"), null);
  assert.equal(await page.locator(".stones .stone0").getAttribute("onclick"), null);
  assert.equal(await page.locator(".stones script, .stones style, .stones image").count(), 0);
  await page.locator(".canvas").focus();
  await page.keyboard.press("p");
  await page.waitForFunction(() => /2\skN/.test(document.querySelector(".result-words").textContent));
  await page.keyboard.press("p");
  await page.waitForFunction(() => /Stopped/.test(document.querySelector(".result-words").textContent));
  assert.deepEqual(wrong, []);
  await page.close();
});

test("a page without an engine draws and says so", async () => {
  const bare = path.join(folder("studio"), `bare_${process.pid}.html`);
  fs.writeFileSync(bare, fs.readFileSync(file, "utf8").replace("/* answered by the test */", "<!--wythe:worker-->"));
  const page = await browser.newPage();
  await page.goto(pathToFileURL(bare).href);
  await page.waitForFunction(() => /holds no engine/.test(document.querySelector(".status")?.textContent ?? ""));
  assert.equal(await page.locator('[data-opening="0"]').count(), 1);
  assert.equal(await page.locator(".limit").isVisible(), false, "a limit load that will never come");
  const [push, answers] = await Promise.all([".push", ".answers"].map((css) => page.locator(css).boundingBox()));
  assert.equal(push.width, answers.width);
  await page.close();
});

test("a browser that is too old or runs no scripts is told which ones will do", async () => {
  for (const [options, isTold] of [[{ javaScriptEnabled: false }, true], [{}, true], [{ locale: "en" }, false]]) {
    const context = await browser.newContext(options);
    const page = await context.newPage();
    if (!options.locale) await page.addInitScript(() => delete window.DecompressionStream);
    await page.goto(pathToFileURL(file).href);
    for (const lang of ["en", "it", "de", "fr", "es", "pt"]) assert.equal(await page.locator(`#old [lang="${lang}"]`).isVisible(), isTold, lang);
    await context.close();
  }
});

test("the page is small and asks for nothing", () => {
  const page = fs.readFileSync(file, "utf8");
  // more than half are the engine's faults in six languages, which a web server sends in a fifth
  assert.ok(Buffer.byteLength(page) < 700e3, `${Buffer.byteLength(page)} bytes`);
  for (const door of [/<script[^>]+src=/, /<link[^>]+href="(?!data:)/, /@import/, /url\((?!#|"?data:)/]) assert.doesNotMatch(page, door);
  assert.match(page, /default-src 'none'/);
});
