// The studio with its own engine, as it is handed on: stones, a push and a report without a network, with the bits of the program.
import assert from "node:assert/strict";
import fs from "node:fs";
import path from "node:path";
import { after, test } from "node:test";
import { gzipSync } from "node:zlib";
import { folder, root, run } from "./helpers.mjs";
import { kPatience, kWall, launch, openStudio, studioPage, write } from "./studio.mjs";

const made = path.join(root, "build/wasm");
const skip = fs.existsSync(path.join(made, "wythe.wasm")) ? false : "build/wasm is not built: make wasm";
let browser;
after(() => browser?.close());

test("a wall is pushed by the page alone, and its report has the state of the program", { skip }, async () => {
  const file = studioPage(made);
  const sent = gzipSync(fs.readFileSync(file)).length; // as a web server sends it
  assert.ok(sent < 4e6, `${sent} bytes`);
  browser = await launch();
  const page = await openStudio(browser, file, { own: true });
  await write(page, kWall);
  assert.match(await page.locator(".status").innerText(), /^\d+ blocks/);
  assert.equal(await page.locator(".stones .stone0").count(), 1);
  await page.locator(".canvas").focus();
  await page.keyboard.press("p");
  await page.waitForSelector(".primary.running");
  await page.waitForFunction(() => !document.querySelector(".primary.running"), null, { timeout: kPatience });

  const model = path.join(folder("studio"), `own_${process.pid}.toml`);
  fs.writeFileSync(model, kWall);
  run("run", model, "--out", `${model}.out`);
  const summary = JSON.parse(fs.readFileSync(path.join(`${model}.out`, "summary.json"), "utf8"));
  const words = await page.locator(".result-words").innerText();
  assert.ok(words.includes(`${Number(summary.peak_reaction_kN.toPrecision(3))}\u202fkN`), words);
  assert.ok(words.includes(summary.failure_mode.name), words);

  const [report] = await Promise.all([page.context().waitForEvent("page"), page.getByRole("button", { name: "Open the report" }).click()]);
  await report.waitForSelector("html[data-ready]");
  assert.ok((await report.content()).includes(summary.state_hash), "the report has another state than the program");
  assert.deepEqual(page.faults, []);
});
