#!/usr/bin/env node
// wythe for Node on any system, with the engine as WebAssembly. Files and bits are those of the program.
//
//   wythe run MODEL.toml --out DIR [--set KEY=VALUE ...] [--lang LANGUAGE] [--replace] [--quiet]
//   wythe check MODEL.toml [--set KEY=VALUE ...]
//   wythe assess MODEL.toml --out DIR [--walls N] [--until WIDTH] [--between COV] [--seed N] [--jobs N] [--resume] [--set KEY=VALUE ...] [--lang LANGUAGE]
//   wythe limit MODEL.toml --out DIR [--set KEY=VALUE ...] [--only NAME ...] [--assessment] [--lang LANGUAGE]
//   wythe report DIR [--lang LANGUAGE]
//   wythe studio [MODEL.toml] [--out FILE.html]
import fs from "node:fs";
import path from "node:path";
import { assess } from "./assess.mjs";
import { hold } from "./hold.mjs";
import { isOnDrive, loaded, seenByEngine, seenByUser } from "./host.mjs";
import { Refused, refusalOf } from "./refused.mjs";
import { studio } from "./studio.mjs";

const USAGE = `usage: wythe run MODEL.toml --out DIR [--set KEY=VALUE ...] [--lang LANGUAGE] [--replace] [--quiet]
       wythe check MODEL.toml [--set KEY=VALUE ...]
       wythe assess MODEL.toml --out DIR [--walls N] [--until WIDTH] [--between COV] [--seed N] [--jobs N]
                    [--set KEY=VALUE ...] [--lang LANGUAGE] [--resume] [--replace] [--quiet]
       wythe limit MODEL.toml --out DIR [--set KEY=VALUE ...] [--only NAME ...] [--assessment] [--lang LANGUAGE]
       wythe report DIR [--lang LANGUAGE]
       wythe studio [MODEL.toml] [--out FILE.html]
       wythe --version

Campaigns, comparisons and checkpoints need the program itself: see the site's page "Install".`;

class Wrong extends Error {}

const OPTIONS = {
  run: { values: ["out", "lang"], lists: ["set"], flags: ["replace", "quiet"] },
  check: { values: [], lists: ["set"], flags: [] },
  assess: { values: ["out", "lang"], numbers: ["walls", "until", "between", "seed", "jobs"], lists: ["set"], flags: ["resume", "replace", "quiet"] },
  limit: { values: ["out", "lang"], lists: ["set", "only"], flags: ["replace", "assessment", "quiet"] },
  report: { values: ["lang"], lists: [], flags: [] },
  studio: { values: ["out"], lists: [], flags: [] },
};

function numberIn(name, text) {
  const number = Number(text);
  if (text.trim() === "" || !Number.isFinite(number)) throw new Wrong(`--${name}: ${text} is no number`);
  if (name === "jobs" && !(Number.isInteger(number) && number >= 0 && number <= 1024)) throw new Wrong("--jobs: must be a whole number from 0 to 1024");
  return number;
}

function parse(command, words) {
  const known = OPTIONS[command];
  const given = command === "report" ? "folder" : "model";
  const options = { set: [], only: [], ...(command === "studio" && { out: "studio.html" }) };
  for (let k = 0; k < words.length; ++k) {
    const [name, stated] = words[k].startsWith("--") ? words[k].slice(2).split(/=(.*)/s) : [undefined, undefined];
    if (name === undefined) {
      if (options.model !== undefined) throw new Wrong(`${words[k]}: one ${given} at a time`);
      options.model = words[k];
    } else if (known.flags.includes(name) && stated === undefined) {
      options[name] = true;
    } else if (known.values.includes(name) || known.lists.includes(name) || known.numbers?.includes(name)) {
      const value = stated ?? words[++k];
      if (value === undefined) throw new Wrong(`--${name}: a value is missing`);
      if (known.lists.includes(name)) options[name].push(value);
      else if (known.numbers?.includes(name)) options[name] = numberIn(name, value);
      else options[name] = value;
    } else {
      throw new Wrong(`--${name}: is no option of wythe ${command}`);
    }
  }
  if (options.model === undefined && command !== "studio") throw new Wrong(`${command === "report" ? "DIR" : "MODEL.toml"}: is missing`);
  if (known.values.includes("out") && !options.out) throw new Wrong("--out: is missing; write the folder for the results");
  return options;
}

// Progress of an assessment on a terminal: say(done, of) a few times a second, say() at the end.
function teller(quiet) {
  const start = Date.now();
  let shown = 0;
  return (done, of) => {
    if (done === undefined && shown > 0) process.stderr.write("\r\u001b[K");
    if (done === undefined || quiet || !process.stderr.isTTY || Date.now() - shown < 200) return;
    shown = Date.now();
    const left = done > 0 ? ((Date.now() - start) / 60_000) * (of / done - 1) : NaN;
    process.stderr.write(`\r${Math.floor(done)} of ${of} pushes${Number.isNaN(left) ? "" : `, about ${Math.ceil(left)} min left`}   `);
  };
}

async function main(words) {
  const [command, ...rest] = words;
  if (command === "--version") {
    console.log((await loaded()).version);
    return 0;
  }
  if (command === undefined || command === "--help" || command === "help" || !Object.hasOwn(OPTIONS, command)) {
    (command === undefined || !command.endsWith("help") ? console.error : console.log)(USAGE);
    return command?.endsWith("help") ? 0 : 2;
  }
  const options = parse(command, rest);
  if (command === "studio") {
    studio(options.model, options.out);
    return 0;
  }
  const file = path.resolve(options.model);
  const root = path.parse(file).root;
  const out = options.out && path.resolve(options.out);
  if (out && !isOnDrive(out, root)) throw new Wrong(`--out: ${out} is on another drive than the model`);
  const seen = seenByEngine(file, root);
  const texts = command === "report" ? { folder: seen } : { file: seen, set: options.set };
  if (options.lang) texts.language = options.lang;
  if (options.only.length > 0) texts.only = options.only;
  if (out) texts.out = seenByEngine(out, root);
  const written = command === "report" && fs.existsSync(file) && fs.statSync(file).isDirectory() ? options.model : options.out;
  const release = written ? hold(written) : () => undefined;
  try {
    if (command === "report" && written) refusePacked(written);
    return command === "assess" ? await assess({ options, texts, root, say: teller(options.quiet) }) : await obey(command, options, texts, root);
  } finally {
    release();
  }
}

// The native program packs the data of a report, and this engine reads them unpacked alone.
function refusePacked(folder) {
  const file = path.join(folder, "report.data");
  const start = fs.existsSync(file) ? fs.readFileSync(file).subarray(0, 2) : [];
  if (start[0] === 0x78 && start[1] !== 0x01)
    throw new Refused(4, `${file}: was packed by the native program; write the page by its own command "wythe report", or run the model here`);
}

// The commands that do one task of the engine.
async function obey(command, options, texts, root) {
  const wythe = await loaded(root);
  const numbers = {};
  for (const flag of ["assessment", "replace"]) if (options[flag]) numbers[flag] = 1;
  let shown = 0;
  const progress = (what, share, mm, kN) => {
    if (options.quiet || !process.stderr.isTTY || Date.now() - shown < 200) return false;
    shown = Date.now();
    process.stderr.write(`\r${what} ${Math.round(100 * share)} %  ${mm.toFixed(2)} mm  ${kN.toFixed(1)} kN   `);
    return false;
  };
  const want = { run: ["summary"], check: ["check"], limit: ["mechanisms"], report: [] }[command];
  const { code, texts: told } = wythe.do(command, { texts, numbers }, { texts: want }, progress);
  if (shown > 0) process.stderr.write("\r\u001b[K");
  if (told.error) console.error(seenByUser(told.error, root));
  if (code !== 0) return code;
  if (command === "check") console.log(told.check);
  if (command === "run") {
    const summary = JSON.parse(told.summary);
    const peak = summary.peak_reaction_kN === null ? "no peak known" : `peak ${summary.peak_reaction_kN.toPrecision(4)} kN`;
    console.log(`${options.out}: ${peak}, state ${summary.state_hash}`);
  }
  if (command === "report") console.log(`report ${path.join(options.model, "report.html")}`);
  if (options.out) console.log(`report: ${path.join(options.out, "report.html")}`);
  return 0;
}

main(process.argv.slice(2)).then(
  (code) => { process.exitCode = code; },
  (error) => {
    const refusal = refusalOf(error);
    console.error(error instanceof Wrong ? `wythe: ${error.message}\n\n${USAGE}` : refusal ? refusal.message : error);
    process.exitCode = error instanceof Wrong ? 2 : (refusal?.code ?? 6);
  },
);
