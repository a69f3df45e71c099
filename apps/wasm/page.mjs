// Puts the engine into a page: pageOf() from a program, or
//
//   node page.mjs BUILT.html ENGINE_FOLDER OUT.html [PACKAGE]   also puts BUILT into a package, for `wythe studio`
//   node page.mjs --check                                       before this package is packed: its page is of its engine, or is missing
//
// The page has two marks: one for the script of its worker, one for the code of the engine, deflated and in base64. In a package it has
// neither, and ends with the hash of those that it was built with.
import { createHash } from "node:crypto";
import fs from "node:fs";
import path from "node:path";
import { fileURLToPath } from "node:url";
import { deflateRawSync } from "node:zlib";
import { isSamePlace } from "./host.mjs";
import { Refused, put, refusalOf, using } from "./refused.mjs";

const here = path.dirname(fileURLToPath(import.meta.url));
const kPage = "studio_page.html"; // in a package
const kEngine = ["wythe.wasm", "wythe.cjs", "worker.js", "job.mjs"]; // of a package: what goes into its page
const bytesOf = (file) => using(file, () => fs.readFileSync(file));
const read = (file) => bytesOf(file).toString();
const hashOf = (bytes) => createHash("sha256").update(bytes).digest("hex");
const endOf = (folder) => `<!--wythe:engine ${hashOf(kEngine.map((name) => hashOf(bytesOf(path.join(folder, name)))).join())}-->\n`;

/** The text of a page, with the engine's script (wythe.js; wythe.cjs in a package) and code. */
export function pageOf(built, script, wasm) {
  const worker = [read(script), read(path.join(here, "job.mjs")).replace(/^export /gm, ""), read(path.join(here, "worker.js"))].join("\n");
  if (/<\/script|<!--/i.test(worker)) throw new Error("the worker's script would end the element that holds it");
  const code = deflateRawSync(bytesOf(wasm), { level: 9 }).toString("base64");
  let page = built;
  for (const [mark, content] of [["<!--wythe:worker-->", worker], ["<!--wythe:wasm-->", code]]) {
    if (page.split(mark).length !== 2) throw new Refused(2, `the page needs ${mark} once; make studio builds it`);
    page = page.replace(mark, () => content);
  }
  return page;
}

/** The page of this package, without an engine; null: it has none. */
export function builtOfPackage() {
  const file = path.join(here, kPage);
  if (!fs.existsSync(file)) return null;
  const page = read(file),
    end = endOf(here);
  if (!page.endsWith(end)) throw new Refused(2, `${file}: is a page of another engine than that of this package; in the sources, make studio builds it again`);
  return page.slice(0, -end.length);
}

function main(words) {
  if (words.length === 1 && words[0] === "--check") {
    if (builtOfPackage() === null) console.error(`${path.join(here, kPage)}: is missing, so this package has no studio; in the sources, make studio puts it in`);
    return;
  }
  const [built, folder, out, toPackage] = words;
  if (out === undefined) throw new Refused(2, "usage: node page.mjs BUILT.html ENGINE_FOLDER OUT.html [PACKAGE]");
  put(out, pageOf(read(built), path.join(folder, "wythe.js"), path.join(folder, "wythe.wasm")));
  if (toPackage) put(path.join(toPackage, kPage), read(built) + endOf(toPackage));
  console.log(`${out}: ${(fs.statSync(out).size / 1e6).toFixed(1)} MB`);
}

if (process.argv[1] && isSamePlace(fs.realpathSync(process.argv[1]), fileURLToPath(import.meta.url)))
  try {
    main(process.argv.slice(2));
  } catch (error) {
    const refusal = refusalOf(error);
    console.error(refusal ? refusal.message : error);
    process.exitCode = refusal?.code ?? 6;
  }
