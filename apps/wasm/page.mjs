// Puts the engine into a page: node page.mjs BUILT.html ENGINE_FOLDER OUT.html, or pageOf() from a program.
// The page has two marks: one for the script of its worker, one for the code of the engine, deflated and in base64.
import fs from "node:fs";
import path from "node:path";
import { fileURLToPath } from "node:url";
import { deflateRawSync } from "node:zlib";
import { isSamePlace } from "./host.mjs";

const here = path.dirname(fileURLToPath(import.meta.url));
const read = (file) => fs.readFileSync(file, "utf8");

/** The page `built`, with the engine's script (wythe.js; wythe.cjs in a package) and code. */
export function pageOf(built, script, wasm) {
  const worker = [read(script), read(path.join(here, "job.mjs")).replace(/^export /gm, ""), read(path.join(here, "worker.js"))].join("\n");
  if (/<\/script|<!--/i.test(worker)) throw new Error("the worker's script would end the element that holds it");
  const code = deflateRawSync(fs.readFileSync(wasm), { level: 9 }).toString("base64");
  let page = read(built);
  for (const [mark, content] of [["<!--wythe:worker-->", worker], ["<!--wythe:wasm-->", code]]) {
    if (page.split(mark).length !== 2) throw new Error(`${built} needs ${mark} once`);
    page = page.replace(mark, () => content);
  }
  return page;
}

if (process.argv[1] && isSamePlace(fs.realpathSync(process.argv[1]), fileURLToPath(import.meta.url))) {
  const [built, folder, out] = process.argv.slice(2);
  fs.writeFileSync(out, pageOf(built, path.join(folder, "wythe.js"), path.join(folder, "wythe.wasm")));
  console.log(`${out}: ${(fs.statSync(out).size / 1e6).toFixed(1)} MB`);
}
