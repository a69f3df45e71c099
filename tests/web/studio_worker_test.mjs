// The worker of a page (apps/wasm/worker.js) whose engine fails, and the limit load that a page shows of an answer.
import assert from "node:assert/strict";
import fs from "node:fs";
import path from "node:path";
import { before, test } from "node:test";
import vm from "node:vm";
import { root, viewerModule } from "./helpers.mjs";
import { standInForPage } from "./studio.mjs";

const script = fs.readFileSync(path.join(root, "apps/wasm/worker.js"), "utf8");
// What a worker throws that is given this engine.
function thrownWith(wytheEngine) {
  let threw;
  const thrown = new Promise((done) => (threw = done));
  class Module {}
  const context = vm.createContext({
    wytheEngine,
    setTimeout: (does) => setTimeout(() => { try { does(); } catch (error) { threw(error); } }),
    WebAssembly: { Module, instantiate: () => Promise.reject(new Error("no memory for it")) },
  });
  vm.runInContext(script, context);
  void context.onmessage({ data: { wasm: new Module() } });
  return thrown;
}

test("an engine that cannot be made is an error of the worker, so that the page hears of it", async () => {
  const made = ({ instantiateWasm }) => new Promise((done) => instantiateWasm({}, done));
  assert.match(String(await thrownWith(made)), /no memory for it/);
});

let LiveLimit;
before(async () => {
  standInForPage();
  globalThis.DOMParser = class {
    parseFromString = () => ({ documentElement: { localName: "html" } }); // no picture
  };
  ({ LiveLimit } = await viewerModule("studio/limit"));
});
const shown = async (code, texts) => {
  const limit = new LiveLimit({ stop() {}, ask: async () => ({ code, texts, tables: {} }) });
  limit.ask("");
  await new Promise((done) => setTimeout(done));
  return limit.root.text;
};

test("the limit load is that of dry joints, and a refusal is shown with its reason", async () => {
  const loads = [{ name: "bonded", static_kN: 99 }, { name: "dry", static_kN: 12 }];
  assert.match(await shown(0, { mechanisms: JSON.stringify({ limit_loads: loads }) }), /12 kN/);
  const refused = { limit_loads: loads.slice(0, 1), refused: [{ what: "dry", why: "it cannot stand" }] };
  const words = await shown(0, { mechanisms: JSON.stringify(refused) });
  assert.match(words, /has no answer for this wall:\s+it cannot stand/);
  assert.doesNotMatch(words, /99/);
  assert.match(await shown(2, { faults: JSON.stringify([{ problem: "the load can grow without end" }]) }), /:\s+the load can grow without end/);
});
