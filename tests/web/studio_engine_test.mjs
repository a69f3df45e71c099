// The studio with its own engine, as it is handed on: stones, a push and a report without a network, with the bits of the program.
import assert from "node:assert/strict";
import fs from "node:fs";
import http from "node:http";
import path from "node:path";
import { after, before, test } from "node:test";
import { gzipSync } from "node:zlib";
import { folder, root, run } from "./helpers.mjs";
import { kPatience, kWall, launch, openStudio, pixelsOf, stonesOf, studioPage, textOf, write } from "./studio.mjs";

const made = path.join(root, "build/wasm");
const skip = fs.existsSync(path.join(made, "wythe.wasm")) ? false : "build/wasm is not built: make wasm";
let browser, file;
before(async () => {
  if (skip) return;
  file = studioPage(made);
  browser = await launch();
});
after(() => browser?.close());
const ended = (page) => page.waitForFunction(() => !document.querySelector(".primary.running"), null, { timeout: kPatience });
// The program's own answer to a text.
function summaryOf(name, text) {
  const model = path.join(folder("studio"), `${name}_${process.pid}.toml`);
  fs.writeFileSync(model, text);
  run("run", model, "--out", `${model}.out`);
  return JSON.parse(fs.readFileSync(path.join(`${model}.out`, "summary.json"), "utf8"));
}
// What the page says of a push, and its report, are the program's.
async function isAsTheProgram(page, summary) {
  const words = await page.locator(".result-words").innerText();
  assert.ok(words.includes(`${Number(summary.peak_reaction_kN.toPrecision(3))}\u202fkN`), words);
  assert.ok(words.includes(summary.failure_mode.name), words);
  const [report] = await Promise.all([page.context().waitForEvent("page"), page.getByRole("button", { name: "Open the report" }).click()]);
  await report.waitForSelector("html[data-ready]");
  assert.ok((await report.content()).includes(summary.state_hash), "the report has another state than the program");
}

test("a wall is pushed by the page alone, and its report has the state of the program", { skip }, async () => {
  const sent = gzipSync(fs.readFileSync(file)).length; // as a web server sends it
  assert.ok(sent < 4e6, `${sent} bytes`);
  const page = await openStudio(browser, file, { own: true });
  await write(page, kWall);
  assert.match(await page.locator(".status").innerText(), /^\d+ blocks/);
  assert.equal(await page.locator(".stones .stone0").count(), 1);
  await page.locator(".canvas").focus();
  await page.keyboard.press("p");
  await page.waitForSelector(".primary.running");
  await ended(page);
  await isAsTheProgram(page, summaryOf("own", kWall));
  assert.deepEqual(page.faults, []);
});

test("the tuff wall is drawn by the mouse and pushed until it cracks and on: peak and state are the program's", { skip }, async (t) => {
  const start = performance.now();
  const page = await openStudio(browser, file, { own: true });
  const drawn = async (key, from, to, lengths) => {
    await page.locator(".canvas").focus();
    await page.keyboard.press(key);
    await page.mouse.move(...(await pixelsOf(page, ...from)));
    await page.mouse.down();
    await page.mouse.move(...(await pixelsOf(page, ...to)), { steps: 5 });
    await page.keyboard.type(lengths[0]);
    await page.keyboard.press("Tab");
    await page.keyboard.type(lengths[1]);
    await page.mouse.up();
  };
  const enter = async (label, value) => {
    await page.getByLabel(label, { exact: true }).fill(value);
    await page.getByLabel(label, { exact: true }).press("Enter");
  };
  // the masonry of the tests, and nothing of the wall's shape
  const tuff = fs.readFileSync(path.join(root, "examples/tuff_wall/model.toml"), "utf8");
  const bare = [[/\[\[wall\.opening\]\][^]*?(?=\[material\.joint\])/, ""], ['"5.10 m"', '"3.10 m"'], ['"3.62 m"', '"2.20 m"'], ['y = "3.12 m", courses', 'y = "1.70 m", courses']];
  await write(page, bare.reduce((text, [from, to]) => text.replace(from, to), tuff));
  await drawn("w", [0, 0], [2, 2], ["5,1", "3,62"]);
  await drawn("d", [1.7, 0.5], [3.2, 2.4], ["1,7", "2,64"]);
  await enter("From the left", "1.70");
  await enter("As far as", "5 mm");
  const text = await textOf(page);
  for (const line of tuff.split("\n").filter((l) => /^(length|height|x|y|width|at) = /.test(l))) assert.ok(text.replaceAll("0.00 m", "0 m").includes(line.split(" #")[0].trim()), line);
  await stonesOf(page);
  assert.deepEqual(await page.locator(".fault").allInnerTexts(), []);
  await page.locator(".canvas").focus();
  await page.keyboard.press("p");
  await page.waitForSelector(".primary.running");
  await page.waitForFunction(() => document.querySelector(".stones .crack"), null, { timeout: kPatience });
  t.diagnostic(`${((performance.now() - start) / 1000).toFixed(1)} s from opening the page to the first crack`);
  await ended(page);
  await isAsTheProgram(page, summaryOf("tuff", text));
  assert.deepEqual(page.faults, []);
  await page.end();
});

test("from a web server it opens as from a disk, and asks for nothing more", { skip }, async (t) => {
  const server = http.createServer((_, answer) => answer.setHeader("content-type", "text/html; charset=utf-8").end(fs.readFileSync(file)));
  await new Promise((done) => server.listen(0, "127.0.0.1", done));
  const address = `http://127.0.0.1:${server.address().port}/`;
  const page = await browser.newPage({ locale: "en-GB" });
  const wrong = [];
  page.on("pageerror", (error) => wrong.push(error.message));
  page.on("console", (m) => m.type() === "error" && wrong.push(m.text()));
  page.on("request", (r) => !/^(data|blob):/.test(r.url()) && r.url() !== address && wrong.push(r.url()));
  const start = performance.now();
  await page.goto(address);
  await page.waitForFunction(() => /^\d+ blocks/.test(document.querySelector(".status")?.textContent ?? ""), null, { timeout: kPatience });
  t.diagnostic(`${((performance.now() - start) / 1000).toFixed(2)} s from opening the page to the first stones`);
  assert.equal(await page.locator(".stones .stone0").count(), 1);
  assert.deepEqual(wrong, []);
  await page.close();
  await new Promise((done) => server.close(done));
});
