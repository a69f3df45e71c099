// The page of `wythe assess`: one sheet of A4 and an appendix of at most five pages, in both
// languages, on paper and on a phone. It shows no keys, no dots for words, and no English in Italian.
import assert from "node:assert/strict";
import fs from "node:fs";
import path from "node:path";
import { after, before, test } from "node:test";
import { folder, launch, open, pageOf, pdfPages, root, run, screenshot, shots, violations } from "./helpers.mjs";

const kPalazzina = path.join(root, "examples/palazzina/model.toml");
// Of large units, fast and short: what the numbers are is no matter here.
const kShort = ['stage.push.until="8 mm"', 'stage.push.velocity="8 mm/s"', 'stage.push.fast_velocity="8 mm/s"', 'wall.unit.length="1 m"',
  'wall.unit.height="260 mm"'].flatMap((text) => ["--set", text]);

let browser;
before(async () => {
  const english = folder("verdict_palazzina"), italian = folder("verdict_palazzina_it");
  for (const made of [english, italian]) fs.rmSync(made, { recursive: true, force: true });
  run("assess", kPalazzina, "--out", english, "--walls", "2", "--quiet", ...kShort);
  fs.cpSync(english, italian, { recursive: true }); // the same walls, in other words
  run("assess", kPalazzina, "--out", italian, "--resume", "--lang", "it", "--quiet", ...kShort);
  browser = await launch();
});
after(() => browser?.close());

const kWidth = 703; // of A4 less its margins [px]
const kHeight = 275; // [mm]

async function printed(name) {
  const page = await open(browser, pageOf(name), { width: kWidth, javaScript: false });
  const pdf = await page.pdf({ preferCSSPageSize: true });
  fs.mkdirSync(shots, { recursive: true });
  fs.writeFileSync(path.join(shots, `${name}.pdf`), pdf);
  await page.emulateMedia({ media: "print" });
  const seen = await page.evaluate(() => {
    const mm = (e) => (e.getBoundingClientRect().height * 25.4) / 96;
    const all = [...document.querySelectorAll("main *")];
    return {
      sheet: mm(document.querySelector(".sheet")),
      appendix: mm(document.querySelector(".appendix")),
      out: all.filter((e) => !e.closest("svg") && e.getBoundingClientRect().right > innerWidth + 1).map((e) => `${e.tagName} ${e.textContent.slice(0, 50)}`),
      cut: all.filter((e) => ["hidden", "clip"].includes(getComputedStyle(e).overflow) && !e.closest("svg") || getComputedStyle(e).textOverflow === "ellipsis").length,
      words: document.querySelector("main").innerText,
    };
  });
  assert.deepEqual(page.faults, []);
  await page.context().close();
  return { ...seen, pages: pdfPages(pdf) };
}

// What the engine calls a thing, never a reader: keys of the table of words, of the model file, options, commands.
const kKey = /\b(assess|assessment|sheet|input|origin|section|verdict|stage|promise|rate|mode|range)\.[a-z_]+|--[a-z]+|\bwythe (run|assess|limit)\b|\[[a-z]{4,}(\.[a-z]+)?\]|\b(?!timber_face\b)[a-z]+_[a-z_]+\b/g;
// English words that no Italian sentence has.
const kEnglish = /\b(the|of|and|with|is|are|was|were|than|from|by|which|wall|walls|each|solid|bricks|lime|forces|pier|spandrel|unclear|given|derived|typical|load|joint|unit)\b/;

test("the sheet is one page, the appendix five at most, nothing cut, nothing beyond the margin", async () => {
  for (const name of ["verdict_palazzina", "verdict_palazzina_it"]) {
    const seen = await printed(name);
    assert.ok(seen.sheet < kHeight, `${name}: the sheet is ${seen.sheet} mm high`);
    assert.ok(seen.pages >= 2 && seen.pages <= 6, `${name}: ${seen.pages} pages`);
    // no page but the last is half empty: breaks cost less than half a page in all
    assert.ok(seen.appendix > (seen.pages - 2) * kHeight * 0.75, `${name}: ${seen.appendix} mm on ${seen.pages - 1} pages`);
    assert.deepEqual([seen.out, seen.cut], [[], 0], name);
    assert.doesNotMatch(seen.words, /…|\.\.\.|undefined|NaN|\bnan\b|null|\[object/);
  }
});

test("the verdict comes first, then what it rests on, then what was not modelled", async () => {
  const { words } = await printed("verdict_palazzina");
  const order = [/Palazzina of three storeys/, /Not to be signed/, /asked 0\.168 g/, /ζE/, /Circolare 7\/2019/, /LC2, 1\.2/, /2 walls, 4 pushes each/, /Why it is not to be signed/,
    /to the right \(\+x\), forces by mass times height/, /Limit states/, /What it rests on/, /What was not modelled[^]*Out of plane/, /Every wall/, /How each limit state is reached/,
    /Spectra[^]*0\.14/, /first timber floor/, /Masonry, and where its values come from[^]*2\.875/, /wythe 0\./];
  let at = -1;
  for (const wanted of order) {
    const found = words.slice(at + 1).search(wanted);
    assert.ok(found >= 0, `${wanted} after ${at}: ${words}`);
    at += found + 1;
  }
  assert.doesNotMatch(words, /Signature/);
});

test("no key is shown, and nothing is said twice", async () => {
  for (const name of ["verdict_palazzina", "verdict_palazzina_it"]) {
    const { words } = await printed(name);
    assert.deepEqual(words.match(kKey) ?? [], [], name);
    const sentences = words.split(/\n|(?<=[a-z]{3}[.:]) /).filter((text) => text.length > 50);
    assert.deepEqual(sentences.filter((text, k) => sentences.indexOf(text) !== k), [], name);
  }
});

test("in Italian no English is left", async () => {
  const { words } = await printed("verdict_palazzina_it");
  const given = /Palazzina of three storeys, street front|front of a palazzina|a site of moderate hazard|an example|(ground|first|second) floor|(first|second) timber floor|tie of the (first|second) floor|roof|(GNU|Clang).*|wythe 0.*/g;
  assert.deepEqual(words.replace(given, "").split("\n").filter((line) => kEnglish.test(line)), []);
  assert.match(words, /Da non firmare[^]*Su che cosa si basa[^]*Che cosa non è stato modellato/);
});

test("it reads on a phone and in the dark, and needs no script", async () => {
  for (const [width, scheme] of [[390, "light"], [1440, "light"], [1440, "dark"]]) {
    const page = await open(browser, pageOf("verdict_palazzina"), { width, scheme, javaScript: false });
    assert.ok(await page.evaluate(() => document.documentElement.scrollWidth <= innerWidth), `${width} px`);
    const least = await page.evaluate(() => Math.min(...[...document.querySelectorAll("main p, main li, main td, main th, main b, main span, main figcaption")]
      .filter((e) => e.textContent.trim() !== "").map((e) => parseFloat(getComputedStyle(e).fontSize))));
    assert.ok(least >= 11, `${width} px: letters of ${least} px`);
    assert.deepEqual(page.faults, []);
    await screenshot(page, `verdict_${width}_${scheme}`);
    await page.context().close();
  }
  // axe-core is a script of its own; open() would wait for one of the page's
  const context = await browser.newContext({ viewport: { width: 1440, height: 900 } });
  const page = await context.newPage();
  await page.goto(pageOf("verdict_palazzina"));
  assert.deepEqual(await violations(page), []);
  await context.close();
});
