// wythe assess: the verdict on a wall from many walls of its model. Threads push the walls and hand over their records; the engine of this
// thread judges them. Bits do not depend on how many threads there are. Records stay in the folder, so that --resume goes on with them.
import { createHash } from "node:crypto";
import fs from "node:fs";
import os from "node:os";
import path from "node:path";
import { Worker } from "node:worker_threads";
import { gunzipSync, gzipSync } from "node:zlib";
import { compiled } from "./index.mjs";
import { loaded, seenByUser } from "./host.mjs";
import { Refused, put } from "./refused.mjs";

// Walls that were pushed, in a hidden folder of `out`: batches.json, which says of what they are, and a record for each way and wall.
class Kept {
  constructor(out) {
    this.out = out;
    this.folder = path.join(out, ".wythe_walls");
  }
  // Sizes of the designs, of what they are, and whether their verdict takes the place of another model's; undefined: nothing is kept.
  begun() {
    const file = path.join(this.folder, "batches.json");
    if (!fs.existsSync(file)) return undefined;
    try {
      const { batches, origin, replaces } = JSON.parse(fs.readFileSync(file, "utf8"));
      if (batches.length > 0 && batches.every((walls) => Number.isInteger(walls) && walls >= 2)) return { batches, origin, replaces };
    } catch {
      // told below
    }
    throw new Refused(2, `${file}: is damaged; --replace begins anew`);
  }
  begin(started) {
    fs.mkdirSync(this.folder, { recursive: true });
    put(path.join(this.folder, "batches.json"), JSON.stringify(started));
  }
  clear() {
    fs.rmSync(this.folder, { recursive: true, force: true });
  }
  file = ({ way, wall }) => `way_${way}_wall_${wall}.gz`;
  put(task, record) {
    put(path.join(this.folder, this.file(task)), gzipSync(record));
  }
  has = (task) => fs.existsSync(path.join(this.folder, this.file(task)));
  get(task) {
    const file = path.join(this.folder, this.file(task));
    try {
      return gunzipSync(fs.readFileSync(file)).toString();
    } catch {
      throw new Refused(4, `${file}: cannot be read, or is damaged; remove it, and --resume pushes that wall again`);
    }
  }
}

const sum = (numbers) => numbers.reduce((all, number) => all + number, 0);

// Of what walls are: the model's text, the settings, the draws and the engine. What else a wall hangs on, its record says.
function originOf({ model, set, seed, between }, version) {
  let text = null; // of a file that cannot be read: the engine says what is wrong with it
  try {
    text = fs.readFileSync(model, "utf8");
  } catch {
    // told by the engine
  }
  return createHash("sha256").update(JSON.stringify([text, set, seed ?? 0, between ?? null, version])).digest("hex");
}

// The designs that are asked for: stored ones stay, and more walls are a design of their own.
function asked(options, kept, origin) {
  if (options.resume && options.replace) throw new Refused(2, "--resume: goes on with walls that --replace removes; leave one out");
  const stored = options.replace ? undefined : kept.begun();
  if (stored === undefined) return { batches: [options.walls ?? 8], origin, replaces: options.replace === true };
  if (!options.resume) throw new Refused(2, `${kept.out}: holds walls of an assessment already; --resume goes on with them, --replace begins anew`);
  if (stored.origin !== origin)
    throw new Refused(2, `${kept.out}: holds walls of another model, setting, seed or version of wythe; give what they were pushed with, or --replace begins anew`);
  const more = (options.walls ?? 0) - sum(stored.batches);
  if (more === 1) throw new Refused(2, `--walls: ${options.walls} is one more than there are, and two are added at least; write ${options.walls + 1}`);
  return more > 0 ? { ...stored, batches: [...stored.batches, more] } : stored;
}

// Pushes the walls of `tasks`, each by the next thread that is free; `keep(task, record)` gets each record. `check()` is called before each.
async function pushAll(tasks, { jobs, module, root, inputs, keep, check, say }) {
  const waiting = [...tasks];
  const shares = new Map();
  let done = 0;
  const tell = () => say(done + sum([...shares.values()]), tasks.length);
  const threads = [];
  const serve = () =>
    new Promise((end, fail) => {
      const thread = new Worker(new URL("push_worker.mjs", import.meta.url), { workerData: { module, root } });
      threads.push(thread);
      let task;
      const next = () => {
        task = waiting.shift();
        if (task === undefined) return end();
        check();
        thread.postMessage({ inputs, ...task });
      };
      thread.on("error", fail);
      thread.on("exit", (code) => fail(new Error(`a thread ended with code ${code}`)));
      const take = ({ share, ready, code, record, error }) => {
        if (ready) return next();
        if (share !== undefined) {
          shares.set(task, share);
          return tell();
        }
        if (code !== 0) return fail(new Refused(code, seenByUser(error, root)));
        keep(task, record);
        shares.delete(task);
        ++done;
        tell();
        next();
      };
      thread.on("message", (message) => {
        try {
          take(message);
        } catch (error) {
          fail(error);
        }
      });
    });
  try {
    await Promise.all(Array.from({ length: Math.min(jobs, tasks.length) }, serve));
  } finally {
    await Promise.all(threads.map((thread) => thread.terminate()));
  }
}

const g = (number) => number.toFixed(3);

function printed(verdict, plan, out) {
  console.log((verdict.may_be_signed ? "" : "WARNING ") + verdict.sentence);
  verdict.ways.forEach((way, k) => {
    const { median, low, high, at_least } = way.pga_capacity_g;
    const name = `${way.direction.padEnd(4)} ${plan.ways[k].words.padEnd(32)} `;
    if (median === null) return console.log(`${name}no answer in any of ${way.walls} walls`);
    const interval = low === null || high === null ? "" : ` (${g(low)} to ${g(high)})`;
    const unknown = ["not_shown", "lost"].map((key) => (way[key] > 0 ? `, ${way[key]} ${key.replace("_", " ")}` : "")).join("");
    console.log(`${name}${at_least ? "at least " : ""}${g(median)} g${interval}: not met in ${way.not_met} of ${way.met + way.not_met} walls${unknown}`);
  });
  for (const way of verdict.ways)
    for (const { wall, why } of way.lost_walls) console.log(`lost: ${way.direction}, wall ${wall}: ${why}`);
  for (const part of verdict.parts.checked) {
    console.log(`out of plane: ${part.sentence.split(". What was found: ").at(-1)}`); // its cautions have lines of their own
    for (const caution of part.cautions) console.log(`  doubtful: ${caution}`);
  }
  for (const part of verdict.parts.not_checked) console.log(`not checked: ${part.what}: ${part.why}`);
  console.log(`report: ${path.join(out, "report.html")}`);
}

/** The command; gives its exit code. `options` as typed; `texts`: file, set, out and language as the engine takes them. */
export async function assess({ options, texts, root, say }) {
  const module = await compiled();
  const wythe = await loaded(root, module);
  const jobs = options.jobs || os.availableParallelism?.() || os.cpus().length;
  const numbers = {};
  for (const name of ["seed", "between", "until"]) if (options[name] !== undefined) numbers[name] = options[name];
  const kept = new Kept(options.out);
  const ask = (...words) => {
    const { code, texts: told } = wythe.do("assess", ...words);
    if (code !== 0) throw new Refused(code, seenByUser(told.error, root));
    return told;
  };
  try {
    const origin = originOf(options, wythe.version);
    const check = () => {
      if (originOf(options, wythe.version) !== origin)
        throw new Refused(2, `${options.model}: was changed while its walls were pushed; put it back and go on with --resume, or begin anew with --replace`);
    };
    const started = asked(options, kept, origin);
    let { batches } = started;
    if (started.replaces) numbers.replace = 1;
    for (let round = 0; ; ++round) {
      const inputs = (more, record) => ({
        texts: record ? { ...texts, record } : texts,
        numbers: { ...numbers, ...more },
        columns: { walls: batches },
      });
      const plan = JSON.parse(ask(inputs({ plan: 1 }), { texts: ["plan"] }).plan);
      if (round === 0 && options.replace) kept.clear();
      kept.begin({ ...started, batches });
      const all = plan.ways.flatMap((_, way) => Array.from({ length: plan.walls }, (__, k) => ({ way, wall: k + 1 })));
      const left = all.filter((task) => !kept.has(task));
      if (!options.quiet) {
        if (round === 0) for (const note of plan.notes) console.error(`note: ${note}`);
        console.error(`${plan.ways.length} ways of pushing, ${plan.walls} walls each: ${left.length} pushes on ${Math.min(jobs, left.length)} threads`);
      }
      await pushAll(left, { jobs, module, root, inputs: inputs(), say, check, keep: (task, record) => kept.put(task, record) });
      check();
      const records = (function* () {
        for (const task of all) yield kept.get(task); // one at a time: the engine holds them
      })();
      const told = ask(inputs({}, records), { texts: ["plan", "assessment"] });
      const verdict = JSON.parse(told.assessment);
      const { next } = JSON.parse(told.plan);
      if (next === 0) {
        say();
        printed(verdict, plan, options.out);
        if (options.until !== undefined && verdict.verdict !== "not known") {
          const [low, high] = verdict.probability_interval_of_walls;
          console.log(`the share that does not meet it is known to ${(high - low).toFixed(2)} after ${verdict.walls} walls`);
        }
        return verdict.verdict === "not known" ? 3 : 0;
      }
      if (!options.quiet) console.error(`${verdict.walls} walls: not met in ${verdict.not_met} of ${verdict.met + verdict.not_met}; going on with ${next} walls`);
      batches = [...batches, next - plan.walls];
    }
  } finally {
    say();
  }
}
