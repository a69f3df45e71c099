// The site (make site) in a browser, opened from a file: it sends no requests,
// fits a phone, follows the system's dark mode, and its search finds pages.
import assert from "node:assert/strict";
import { spawnSync } from "node:child_process";
import path from "node:path";
import { after, before, test } from "node:test";
import { pathToFileURL } from "node:url";
import { launch, root } from "./helpers.mjs";

const built = spawnSync(path.join(root, "tools/site"), ["--check"], { encoding: "utf8" }); // as tests/cli/site_test.py: it is built once
const skip = built.status === 77 && built.stderr.trim();
const kPages = ["index", "gallery", "search", "docs/tutorial/first_wall", "docs/reference/model", "docs/evidence/validation", "cpp/model"];
let browser;

before(async () => {
  browser = await launch();
});
after(() => browser.close());

// Opens a page of the site; what goes wrong on it is added to `faults`.
async function open(name, width, colorScheme, faults = []) {
  const page = await browser.newPage({ viewport: { width, height: 844 }, colorScheme });
  page.on("pageerror", (error) => faults.push(`${name}: ${error.message}`));
  page.on("requestfailed", (request) => faults.push(`${name}: ${request.url()} failed`));
  page.on("request", (request) => {
    if (!/^(file|data):/.test(request.url())) faults.push(`${name}: asks for ${request.url()}`);
  });
  const [file, query] = name.split("?");
  await page.goto(`${pathToFileURL(path.join(root, "build/site", file)).href}.html?${query ?? ""}`);
  return page;
}
const brightness = (page) =>
  page.evaluate(() => Number(/\d+/.exec(getComputedStyle(document.body).backgroundColor)[0]));

test("the site is built", { skip }, () => assert.equal(built.status, 0, built.stdout + built.stderr));

test("pages fit a phone, and neither fail nor ask for anything", { skip }, async () => {
  const faults = [];
  for (const name of kPages) {
    const page = await open(name, 390, "light", faults);
    assert.equal(await page.evaluate(() => document.documentElement.scrollWidth), 390, name);
    await page.close();
  }
  assert.deepEqual(faults, []);
});

test("a page is dark where the system is, until the button is pressed", { skip }, async () => {
  const light = await open("index", 1300, "light");
  assert.ok((await brightness(light)) > 200);
  const dark = await open("index", 1300, "dark");
  assert.ok((await brightness(dark)) < 50);
  await dark.locator(".theme-toggle").locator("visible=true").first().click();
  assert.ok((await brightness(dark)) > 200);
});

test("the search finds pages without a server", { skip }, async () => {
  const faults = [];
  const page = await open("search?q=lobatto", 1300, "light", faults);
  await page.getByText("Search finished").waitFor();
  assert.ok((await page.locator("#search-results li").count()) > 5);
  assert.deepEqual(faults, []);
});
