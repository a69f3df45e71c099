// Gestures at random in the studio, with its own engine: no error in the console, no worker that is left over, no memory that grows.
// 200 of them in make test; more by WANDER=9000, others by SEED=7.
import assert from "node:assert/strict";
import fs from "node:fs";
import path from "node:path";
import { after, before, test } from "node:test";
import { root } from "./helpers.mjs";
import { kPatience, launch, openStudio, stonesOf, studioPage, textOf } from "./studio.mjs";

const count = Number(process.env.WANDER ?? 200);
const seed = Number(process.env.SEED ?? 1);
const made = path.join(root, "build/wasm");
const skip = fs.existsSync(path.join(made, "wythe.wasm")) ? false : "build/wasm is not built: make wasm";
const kWorkers = 4; // stones, limit load, push, pushes beside it
const kMost = 24e6; // what the page's own memory may grow by, after its garbage is gone [bytes]

let browser, page;
before(async () => {
  if (skip) return;
  browser = await launch();
  page = await openStudio(browser, studioPage(made), { own: true });
});
after(() => browser?.close());

// mulberry32
let state = seed;
const random = () => {
  state = (state + 0x6d2b79f5) | 0;
  let t = Math.imul(state ^ (state >>> 15), 1 | state);
  t = (t + Math.imul(t ^ (t >>> 7), 61 | t)) ^ t;
  return ((t ^ (t >>> 14)) >>> 0) / 4294967296;
};
const below = (n) => Math.floor(random() * n);
const one = (list) => list[below(list.length)];

const place = async () => {
  const box = await page.locator(".canvas").boundingBox();
  return [box.x + random() * box.width, box.y + random() * box.height];
};
const kKeys = ["w", "d", "o", "v", "a", "e", "g", "i", "k", "b", "p", "p", "r", "f", "s", "y", "Delete", "Control+z", "Control+z", "Control+y", "Enter", "Escape", "ArrowLeft", "ArrowRight", "ArrowUp", "Shift+ArrowDown", "Tab", " ", "+", "-", "n"];
const kGestures = {
  key: async () => {
    await page.locator(".canvas").focus();
    await page.keyboard.press(one(kKeys));
  },
  drag: async () => {
    await page.mouse.move(...(await place()));
    await page.mouse.down();
    await page.mouse.move(...(await place()), { steps: 1 + below(6) });
    if (random() < 0.2) await page.keyboard.press(one(["Escape", "Control+z", "Tab", "1"]));
    await page.mouse.up();
  },
  click: async () => page.mouse.click(...(await place())),
  wheel: async () => {
    await page.mouse.move(...(await place()));
    await page.mouse.wheel(0, 400 * (random() - 0.5));
  },
  button: async () => {
    const shown = await page.locator("button:visible:not(:disabled)").all();
    const button = shown[below(shown.length)];
    const name = (await button?.textContent().catch(() => "")) ?? "";
    if (!/Save|Open|Link|Theme/.test(name)) await button?.click({ timeout: 1000 }).catch(() => undefined); // it may be gone, or under another
  },
  number: async () => {
    const fields = await page.locator(".numbers input[type=text]:visible:not(:disabled)").all();
    const field = fields[below(fields.length)];
    if (!field) return;
    await field.fill(one(["0.4", "1.2 m", "2", "38 cm", "x", "", "5 mm", "0.1 MPa", "-1"]), { timeout: 1000 }).catch(() => undefined);
    await field.press("Enter", { timeout: 1000 }).catch(() => undefined);
  },
  begin: async () => page.locator(".starters").selectOption(one(["empty", "portal", "pier", "tuff", "arch", "frame"])),
  line: async () => {
    const text = await textOf(page);
    const lines = text.split("\n");
    if (random() < 0.7) lines.splice(below(lines.length), 1);
    else lines[below(lines.length)] += one([" # a remark", "=", '"', "]"]);
    await page.locator(".file-text").evaluate((area, text) => {
      area.value = text;
      area.dispatchEvent(new Event("blur"));
    }, lines.join("\n"));
  },
  wait: () => page.waitForTimeout(below(900)),
};
const kOften = ["key", "key", "key", "drag", "drag", "click", "wheel", "button", "button", "number", "begin", "line", "wait", "wait"];

// Everything is at rest: an empty wall, nothing asked. Bytes of the page's own memory, workers that there are.
async function rest(session) {
  await page.evaluate(() => document.querySelectorAll("dialog[open]").forEach((dialog) => dialog.close()));
  await page.keyboard.press("Escape");
  await page.locator(".starters").selectOption("empty");
  await stonesOf(page);
  if (await page.locator(".primary.running").count()) await page.locator(".primary").click();
  await page.waitForFunction(() => document.documentElement.dataset.limiting === undefined && !document.querySelector(".primary.running"), null, { timeout: kPatience });
  await session.send("HeapProfiler.collectGarbage");
  const { usedSize } = await session.send("Runtime.getHeapUsage");
  const nodes = await page.evaluate(() => document.querySelectorAll("*").length);
  return { bytes: usedSize, nodes, workers: page.workers().length };
}

test(`${count} gestures at random (seed ${seed})`, { skip, timeout: 1e3 * count + 4 * kPatience }, async (t) => {
  const session = await page.context().newCDPSession(page);
  page.on("popup", (other) => void other.close().catch(() => undefined));
  page.on("dialog", (dialog) => void dialog.dismiss());
  const first = await rest(session);
  const did = [];
  let most = 0;
  while (did.length < count) {
    const what = one(kOften);
    did.push(what);
    await kGestures[what]();
    most = Math.max(most, page.workers().length);
    if (page.faults.length > 0) break;
  }
  assert.deepEqual(page.faults, [], `after ${did.length} gestures, the last: ${did.slice(-12).join(", ")}`);
  assert.ok(most <= kWorkers + 2, `${most} workers at once`); // of those that were ended some are still counted
  const last = await rest(session);
  t.diagnostic(`${did.length} gestures, at most ${most} workers; ${(first.bytes / 1e6).toFixed(1)} MB and ${first.nodes} elements before, ${(last.bytes / 1e6).toFixed(1)} MB and ${last.nodes} after, ${last.workers} workers`);
  assert.ok(last.workers <= kWorkers, `${last.workers} workers are left`);
  assert.ok(last.bytes < first.bytes + kMost, `${first.bytes} bytes before, ${last.bytes} after`);
  assert.ok(last.nodes < first.nodes + 3000, `${first.nodes} elements before, ${last.nodes} after`);
  assert.deepEqual(page.faults, []);
});
