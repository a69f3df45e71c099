// Campaigns and pages with missing data: the page reports what is missing and never shows nothing.
import assert from "node:assert/strict";
import { execFileSync } from "node:child_process";
import fs from "node:fs";
import path from "node:path";
import { after, before, test } from "node:test";
import { folder, launch, open, pageOf, run, screenshot } from "./helpers.mjs";
import { makeCampaign, makeRun } from "./small_study.mjs";

let browser;
before(async () => {
  browser = await launch();
});
after(() => browser?.close());

async function words(name) {
  const page = await open(browser, pageOf(name));
  const text = await page.locator("main").innerText();
  assert.deepEqual(page.faults, [], name);
  assert.equal(await page.evaluate(() => document.documentElement.dataset.ready), "yes");
  await screenshot(page, `fault_${name}_1440_light`);
  await page.context().close();
  return text;
}

// A push that ends early, where nobody reads what it found.
const kEarly = ["--set", 'stage.2.until="1 mm"'];

// Samples that have not run: all that a store has of them but their inputs.
function forgetSamples(name, which) {
  execFileSync("python3", [
    "-c",
    `
import sqlite3
with sqlite3.connect(r"${path.join(folder(name), "campaign.db")}") as db:
    tables = [row[0] for row in db.execute("SELECT name FROM sqlite_master WHERE type = 'table'")]
    for table in tables:
        columns = [row[1] for row in db.execute("PRAGMA table_info(" + table + ")")]
        if "sample" in columns and table != "sample_input":
            db.execute("DELETE FROM " + table + " WHERE ${which}")
`,
  ]);
}

test("an empty campaign says so", async () => {
  makeCampaign("empty", "--samples", "4", ...kEarly);
  forgetSamples("empty", "1");
  run("report", folder("empty"));
  assert.match(await words("empty"), /No sample has run yet/);
});

test("two samples have curves, no intervals, and a word about it", async () => {
  makeCampaign("two", "--samples", "2");
  const text = await words("two");
  assert.match(text, /2 samples are few/);
  assert.match(text, /too few samples for an interval|95\s%/);
});

test("one sample says so", async () => {
  makeCampaign("one", "--samples", "4");
  forgetSamples("one", "sample <> 2");
  run("report", folder("one"));
  const text = await words("one");
  assert.match(text, /One sample answered/);
  assert.match(text, /3 of 4 samples have not run/);
});

test("when all failed the page lists the causes", async () => {
  makeCampaign(
    "failed",
    "--samples",
    "2",
    "--set",
    "solve.settle_ratio=1e-300",
    "--set",
    "solve.settle_limit=0.01 s",
  );
  const text = await words("failed");
  assert.match(text, /None of the 2 samples/);
  assert.match(text, /did not settle/);
});

test("missing states: the page says so and shows the rest", async () => {
  makeCampaign("stateless", "--samples", "6");
  execFileSync("python3", [
    "-c",
    `
import sqlite3
checksum = 0xcbf29ce484222325  # of no states (src/campaign/store/digest.cpp), as of a study that stores none
for byte in b"state": checksum = (checksum ^ byte) * 0x100000001b3 % 2**64
with sqlite3.connect(r"${path.join(folder("stateless"), "campaign.db")}") as db:
    db.execute("DELETE FROM state")
    db.execute("UPDATE digest SET states = ?", [checksum - 2**64 if checksum >= 2**63 else checksum])
`,
  ]);
  run("report", folder("stateless"));
  assert.match(await words("stateless"), /No states of the walls are stored/);
});

test("a damaged database gives a message and leaves the old page", () => {
  makeCampaign("damaged", "--samples", "2", ...kEarly);
  const db = path.join(folder("damaged"), "campaign.db"),
    page = path.join(folder("damaged"), "report.html");
  const before = fs.readFileSync(page);
  fs.truncateSync(db, Math.floor(fs.statSync(db).size / 2));
  assert.throws(
    () => run("report", folder("damaged")),
    (error) => error.status === 4 && /damaged/.test(error.stderr),
  );
  assert.ok(fs.readFileSync(page).equals(before));
});

test("damaged data of a run give a message", () => {
  makeRun("spoilt");
  const data = path.join(folder("spoilt"), "report.data");
  fs.truncateSync(data, 1000);
  assert.throws(
    () => run("report", folder("spoilt")),
    (error) => error.status === 4 && /damaged/.test(error.stderr) && error.stderr.includes("spoilt"),
  );
  fs.rmSync(data);
  assert.throws(
    () => run("report", folder("spoilt")),
    (error) => error.status === 2 && /report\.data/.test(error.stderr),
  );
});

test("a page whose data were cut keeps its headline and says what is wrong", async () => {
  makeRun("cut");
  const file = path.join(folder("cut"), "report.html");
  const page = fs.readFileSync(file, "utf8");
  const at = page.lastIndexOf("</script>");
  fs.writeFileSync(file, page.slice(0, at - 4000) + page.slice(at));
  const other = await open(browser, pageOf("cut"));
  assert.match(await other.locator(".warning[role=alert]").innerText(), /damaged/);
  assert.match(await other.locator("#headline").innerText(), /The wall resists/);
  await other.context().close();
});

test("an unknown language is refused before anything runs", () => {
  assert.throws(
    () => run("report", folder("cut"), "--lang", "xx"),
    (error) => error.status === 2 && /en, it/.test(error.stderr),
  );
});

test("a run that is only gravity has a page without a curve", async () => {
  makeRun("standing");
  const model = fs.readFileSync(path.join(folder("inputs"), "model.toml"), "utf8");
  const quiet = model.slice(0, model.lastIndexOf("[[stage]]"));
  fs.writeFileSync(path.join(folder("inputs"), "quiet.toml"), quiet);
  run("run", path.join(folder("inputs"), "quiet.toml"), "--out", folder("gravity_only"), "--quiet");
  const text = await words("gravity_only");
  assert.match(text, /nothing pushed it/);
  assert.match(text, /no curve to draw/);
});
