// import { load } from "wythe";
// const wythe = await load();
// const { texts } = wythe.do("run", { texts: { model: toml } }, { texts: ["summary"] });
import { readFile } from "node:fs/promises";
import { createRequire } from "node:module";
import { doTask, openJob } from "./job.mjs";

/** The engine's code, compiled once for several threads. */
export const compiled = async () => WebAssembly.compile(await readFile(new URL("wythe.wasm", import.meta.url)));

/**
 * The engine in this process: `do(task, inputs, want, progress)` and `open(task, inputs)` as doTask and openJob of job.mjs, and its version.
 * @param {WebAssembly.Module} [module] compiled before
 */
export async function load(module) {
  const code = module ?? (await compiled());
  const engine = await createRequire(import.meta.url)("./wythe.cjs")({
    instantiateWasm(imports, done) {
      WebAssembly.instantiate(code, imports).then((instance) => done(instance, code));
      return {};
    },
    printErr: () => {},
  });
  return {
    engine,
    version: engine.UTF8ToString(engine._wythe_version()),
    do: (task, inputs, want, progress) => doTask(engine, task, inputs, want, progress),
    open: (task, inputs) => openJob(engine, task, inputs),
  };
}
