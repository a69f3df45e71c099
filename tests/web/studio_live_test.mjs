// What the studio shows while one draws and pushes, with its own engine: the limit load of the text as it is, cracks on the way,
// pause, the other way, farther, eight walls, before and after. Bits and numbers are those of the program.
import assert from "node:assert/strict";
import fs from "node:fs";
import path from "node:path";
import { after, before, test } from "node:test";
import { folder, root, run, violations } from "./helpers.mjs";
import { kPatience, kWall, launch, openStudio, stonesOf, studioPage, textOf, write } from "./studio.mjs";

const made = path.join(root, "build/wasm");
const skip = fs.existsSync(path.join(made, "wythe.wasm")) ? false : "build/wasm is not built: make wasm";
let browser, page;
before(async () => {
  if (skip) return;
  const file = studioPage(made);
  browser = await launch();
  page = await openStudio(browser, file, { own: true });
  // a limit load may take as long as this machine needs, but where a test says at once
  await page.evaluate(() => {
    const real = window.setTimeout;
    window.setTimeout = (does, ms, ...rest) => real(does, ms === 3000 ? (window.impatient ? 0 : 1e9) : ms, ...rest);
  });
  await write(page, kWall);
});
after(async () => {
  if (page) assert.deepEqual(page.faults, []);
  await browser?.close();
});
const words = () => page.locator(".result-words").innerText();
const action = (name) => page.locator(`[data-action="${name}"]`);
const push = async () => {
  await page.locator(".canvas").focus();
  await page.keyboard.press("p");
  await page.waitForSelector(".primary.running");
};
const ended = () => page.waitForFunction(() => !document.querySelector(".primary.running"), null, { timeout: kPatience });
const setField = async (label, value) => {
  await page.getByLabel(label, { exact: true }).fill(value);
  await page.getByLabel(label, { exact: true }).press("Enter");
};
// The text is written, and its limit load stands there.
const limitOf = async (text) => {
  await write(page, text);
  await page.waitForFunction(() => !document.documentElement.dataset.limiting && /kN/.test(document.querySelector(".limit-words").textContent), null, { timeout: kPatience });
};
const three = (value) => String(Number(value.toPrecision(3)));
// The program's own answer to a text, in a folder of its own.
let runs = 0;
function program(command, text, ...options) {
  fs.mkdirSync(folder("studio"), { recursive: true });
  const model = path.join(folder("studio"), `live_${process.pid}_${++runs}.toml`);
  fs.writeFileSync(model, text);
  run(command, model, "--out", `${model}.out`, ...options);
  return (name) => JSON.parse(fs.readFileSync(path.join(`${model}.out`, name), "utf8"));
}

test("the limit load stands beside the drawing, with its mechanism", { skip }, async () => {
  await page.waitForFunction(() => /kN/.test(document.querySelector(".limit-words").textContent), null, { timeout: kPatience });
  const { limit_loads } = program("limit", kWall, "--only", "lp")("mechanisms.json");
  const said = await page.locator(".limit-words").innerText();
  assert.ok(said.includes(`${three(limit_loads[0].static_kN)}\u202fkN`), said);
  const weight = Number(/([\d.]+)\u202fkN/.exec(await page.locator(".status").innerText())[1]);
  const share = Number(/([\d.]+)\u202f%/.exec(said)[1]);
  assert.ok(Math.abs(share - (100 * limit_loads[0].static_kN) / weight) < 0.01 * share + 1, `${said}, ${weight} kN`);
  assert.ok((await page.locator(".limit-picture .stone0").count()) > 0);
  assert.ok((await page.locator(".limit-picture .crack.open").count()) > 0);
});

test("nothing of an older text is shown: an edit empties it at once, overtaken questions are dropped", { skip }, async () => {
  const seen = await page.evaluate(async () => {
    const area = document.querySelector(".file-text"),
      shown = document.querySelector(".limit-words");
    const was = area.value;
    const texts = ["0.5", "0.6", "0.7"].map((t) => was.replace('thickness = "0.4 m"', `thickness = "${t} m"`));
    const seen = [];
    for (const text of texts) {
      area.value = text;
      area.dispatchEvent(new Event("blur"));
      seen.push(shown.textContent);
      while (document.documentElement.dataset.limiting !== "yes") await new Promise(requestAnimationFrame); // it is asked
    }
    return seen;
  });
  assert.deepEqual(seen, ["…", "…", "…"]);
  await page.waitForFunction(() => /kN/.test(document.querySelector(".limit-words").textContent), null, { timeout: kPatience });
  const { limit_loads } = program("limit", await textOf(page), "--only", "lp")("mechanisms.json");
  assert.ok((await page.locator(".limit-words").innerText()).includes(`${three(limit_loads[0].static_kN)}\u202fkN`));
  await write(page, kWall);
});

test("a limit load that takes too long is ended, and the page says so", { skip }, async () => {
  await page.evaluate(() => (window.impatient = true));
  await write(page, kWall.replace('"2.4 m"', '"9.6 m"').replace('"1.6 m"', '"4.8 m"').replace('"1.5 m"', '"4.7 m"').replace('"400 mm"\nheight = "200 mm"', '"200 mm"\nheight = "50 mm"'));
  assert.match(await page.locator(".status").innerText(), /^4\d\d\d blocks/);
  await page.waitForFunction(() => /not within 3 s/.test(document.querySelector(".limit-words").textContent), null, { timeout: kPatience });
  assert.equal(await page.locator(".limit-picture path").count(), 0);
  await page.evaluate(() => (window.impatient = false));
  await write(page, kWall);
});

test("cracks are shown on the way; a pause holds, and the state at the end has the program's bits", { skip }, async () => {
  const far = kWall.replace('"4 mm"', '"30 mm"');
  await write(page, far);
  // the page itself presses the key at the first crack: from outside it may come when the push is over
  const cracked = page.evaluate(
    () =>
      new Promise((done) =>
        new MutationObserver((_, watch) => {
          if (!document.querySelector(".canvas.cracked .stones .crack")) return;
          watch.disconnect();
          done(document.querySelectorAll(".primary.running").length);
          document.querySelector(".canvas").dispatchEvent(new KeyboardEvent("keydown", { key: " ", bubbles: true }));
        }).observe(document.body, { subtree: true, childList: true, attributes: true }),
      ),
  );
  await push();
  assert.equal(await cracked, 1, "cracks came only with the end");
  assert.equal(await action("pause").innerText(), "Go on");
  const at = () => page.locator(".live").innerText();
  await page.waitForSelector(".push.held"); // a piece was still under way
  const then = await at();
  await limitOf(far.replace('thickness = "0.4 m"', 'thickness = "0.5 m"')); // another worker answers meanwhile
  await limitOf(far);
  assert.equal(await at(), then);
  assert.equal(await page.locator(".push.held").count(), 1);
  await action("pause").click();
  await ended();
  const summary = program("run", far)("summary.json");
  const [report] = await Promise.all([page.context().waitForEvent("page"), page.getByRole("button", { name: "Open the report" }).click()]);
  await report.waitForSelector("html[data-ready]");
  assert.ok((await report.content()).includes(summary.state_hash), "the report has another state than the program");
  await report.close();
  await write(page, kWall);
  await push();
  await ended();
});

test("the other way and eight walls stand beside the curve, in words too", { skip }, async () => {
  await action("other").click();
  await page.waitForSelector(".line.other", { timeout: kPatience });
  const other = program("run", kWall.replace('velocity = "1 mm/s"', 'velocity = "1 mm/s"\ndirection = "-x"').replace('at = { x = "0 m"', 'at = { x = "2.4 m"'))("summary.json");
  assert.ok((await words()).includes(`to the left ←: at most ${three(other.peak_reaction_kN)}\u202fkN`), await words());
  await action("walls").click();
  await page.waitForFunction(() => document.querySelectorAll(".one-wall").length === 8, null, { timeout: kPatience });
  assert.equal(await page.locator("path.band").count(), 2); // the band and its sample in the legend
  const first = program("run", kWall, "--set", 'scatter.use="clay_brick"', "--set", "scatter.seed=1")("summary.json").peak_reaction_kN;
  const [, low, high] = /8 walls, .* the weakest ([\d.]+)\u202fkN, the strongest ([\d.]+)\u202fkN/.exec(await words());
  assert.ok(first > Number(low) - 0.1 && first < Number(high) + 0.1, `${low} ${first} ${high}`);
  assert.deepEqual(await page.locator(".curve-legend li").allInnerTexts(), ["this push", "to the left ←", "8 walls"]);
});

test("a wall that is kept is compared with the next one", { skip }, async () => {
  await action("keep").click();
  await setField("Thickness", "0.5");
  await stonesOf(page);
  assert.equal(await action("walls").isDisabled(), true, "eight walls of an older text");
  await push();
  await ended();
  const rows = await page.locator(".compare tbody tr").allInnerTexts();
  assert.match(rows[0], /stiffness\s+243\skN\/mm\s+304\skN\/mm\s+\+25\s%/);
  assert.match(rows[1], /strength\s+98\.8\skN\s+123\skN\s+\+25\s%/);
  assert.match(rows[2], /> 4\smm\s+> 4\smm\s+–/); // both are lower bounds: nothing can be said
  assert.equal(await page.locator(".line.kept").count(), 2);
  await action("keep").click();
  assert.equal(await page.locator(".compare").isVisible(), false);
  await page.locator(".canvas").focus();
  await page.keyboard.press("Control+z");
  await stonesOf(page);
});

test("twice as far is an edit of the file and a push", { skip }, async () => {
  await push();
  await ended();
  await action("farther").click();
  await page.waitForSelector(".primary.running");
  assert.match(await textOf(page), /until = "8 mm"/);
  await ended();
  await page.locator(".canvas").focus();
  await page.keyboard.press("Control+z");
  assert.equal(await textOf(page), kWall);
  assert.equal(await page.locator(".push.stale").count(), 1);
});

test("half as fast is an edit of the file and a push", { skip }, async () => {
  await push();
  await ended();
  await action("slower").click();
  await page.waitForSelector(".primary.running");
  assert.match(await textOf(page), /velocity = "0\.5 mm\/s"/);
  await ended();
  await page.locator(".canvas").focus();
  await page.keyboard.press("Control+z");
  assert.equal(await textOf(page), kWall);
});

test("eight walls stop at once, and with an edit", { skip }, async () => {
  await page.keyboard.press("Control+y");
  await stonesOf(page);
  await action("walls").click();
  await page.waitForSelector(".one-wall", { timeout: kPatience });
  await action("walls").click();
  assert.equal(await action("walls").innerText(), "Eight walls");
  const some = await page.locator(".one-wall").count();
  assert.ok(some > 0 && some < 8, String(some));
  await action("other").click();
  await setField("Thickness", "0.6");
  await page.waitForFunction(() => document.querySelector('[data-action="other"]').textContent !== "Stop");
});

test("a family of curves: as many walls with another thickness, one of them taken, and nothing left running", { skip }, async () => {
  await write(page, kWall);
  const family = page.locator(".family");
  const curves = page.locator(".curve-box path.member");
  const workers = page.workers().length;
  const thickness = page.getByTitle("Vary Thickness");
  await thickness.click();
  assert.equal(await family.locator("h2").innerText(), "Thickness, now 0.4\u202fm");
  assert.equal(await page.getByLabel("to", { exact: true }).inputValue(), "0.8");
  await page.keyboard.press("Enter"); // the button has the focus
  await page.waitForFunction(() => document.querySelectorAll(".curve-box path.member").length === 5, null, { timeout: kPatience });
  await page.waitForFunction(() => document.querySelector('[data-action="family"]').textContent === "Push 5 walls", null, { timeout: kPatience });
  assert.deepEqual(await family.locator("li span:first-of-type").allInnerTexts(), ["0.2", "0.283", "0.4", "0.566", "0.8"]);
  const slider = page.getByLabel("Value of: Thickness");
  await slider.focus();
  await page.keyboard.press("End");
  const twice = program("run", kWall.replace('thickness = "0.4 m"', 'thickness = "0.80 m"'))("summary.json");
  assert.equal(await slider.getAttribute("aria-valuetext"), `0.8\u202fm: ${three(twice.peak_reaction_kN)}\u202fkN`);
  const said = (await family.locator(".family-answer").innerText()).replace(/\s+/g, " ");
  assert.ok(said.includes(`stiffness ${three(twice.initial_stiffness_kN_per_mm)} kN/mm failure mode ${twice.failure_mode.name}`), said);
  assert.equal(await curves.last().getAttribute("class"), "line member chosen");
  assert.deepEqual(await violations(page, ".family, .curve-box"), []);
  await page.getByRole("button", { name: "Take 0.8 m" }).click();
  assert.match(await textOf(page), /thickness = "0.8 m"/);
  await stonesOf(page);
  assert.equal(await curves.count(), 5); // of this wall too
  await page.locator(".canvas").focus();
  await page.keyboard.press("Control+z");
  assert.equal(await textOf(page), kWall);
  await setField("Height", "1.8");
  assert.equal(await curves.count(), 0);
  assert.match(await family.innerText(), /has changed since/);
  // another number, from the file; closed while it is at it
  await page.locator(".canvas").focus();
  await page.keyboard.press("t");
  await page.locator(".file-text").evaluate((area) => area.setSelectionRange(...Array(2).fill(area.value.indexOf("vertical_stress") + 3)));
  await page.locator(".file-number .button", { hasText: "Vary masonry.vertical_stress" }).click();
  assert.match(await family.locator("h2").innerText(), /now 0.1\u202fMPa/);
  await page.locator('[data-action="family"]').click();
  await curves.first().waitFor({ state: "attached", timeout: kPatience });
  await page.locator('[data-action="family"]').press("Escape");
  assert.equal(await family.isVisible(), false);
  assert.equal(await curves.count(), 0);
  if (page.workers().length > workers) await page.workers().at(-1).waitForEvent("close");
  assert.ok(page.workers().length <= workers);
  await page.locator(".tab", { hasText: "Numbers" }).click();
  await page.locator(".canvas").focus();
  await page.keyboard.press("Control+z");
  await page.keyboard.press("y");
  await family.waitFor();
  await page.keyboard.press("Escape");
});

test("automatic: a wall is pushed when it rests, beside the drawing, and an edit begins anew", { skip }, async () => {
  await write(page, kWall.replace('"4 mm"', '"40 mm"'));
  await action("itself").click();
  await page.waitForSelector(".primary.running");
  const edited = kWall.replace('thickness = "0.4 m"', 'thickness = "0.7 m"');
  await write(page, edited);
  const peak = `${three(program("run", edited)("summary.json").peak_reaction_kN)}\u202fkN`;
  await page.waitForFunction((peak) => !document.querySelector(".primary.running") && document.querySelector(".key")?.textContent.includes(peak), peak, { timeout: kPatience });
  assert.equal(await page.locator(".canvas.cracked").count(), 0);
  await page.getByLabel("State of the push").press("Home");
  await page.waitForSelector(".canvas.cracked");
  await action("itself").click();
});

test("automatic: nothing is pushed that the engine has not taken", { skip }, async () => {
  const kRest = 1500; // of push.ts
  const waits = () => page.evaluate(() => window.waits);
  await page.evaluate(() => {
    const real = window.setTimeout;
    window.waits = [];
    window.setTimeout = (does, ms) => (window.waits.push(ms), real(does, ms));
  });
  await write(page, kWall.replace('thickness = "0.7 m"', 'thickness = "0.4 m"').replace('"4 mm"', '"12 parsnips"'));
  await action("itself").click();
  assert.ok(!(await waits()).includes(kRest), "a push was set for a file with a fault");
  await write(page, kWall);
  await page.waitForFunction((rest) => window.waits.includes(rest), kRest);
  await action("itself").click();
});
