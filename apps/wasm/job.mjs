// One task of the engine (include/wythe/c.h) from JavaScript: the same calls in a worker of a page and in Node.

/** @typedef {{texts?: Record<string, string | Iterable<string>>, numbers?: Record<string, number>, columns?: Record<string, ArrayLike<number>>}} Inputs */
/** @typedef {(what: string, share: number, displacement_mm: number, reaction_kN: number) => boolean | void} Progress true stops the job */

/**
 * A job: do() gives the code, and does the rest of a run with `goes_on` that was stopped; answers() gives texts by name, tables by name
 * and column ("*": all); free() ends it.
 * @param {any} engine the module that wytheEngine() gives
 * @param {string} task "run", "check", "limit", "contact" or "keys"
 * @param {Inputs} inputs texts (lists of texts for "set", "only" and "record", taken one by one), numbers and columns of the task
 */
export function openJob(engine, task, inputs) {
  const zone = [];
  const placed = (value) => {
    const size = engine.lengthBytesUTF8(value);
    const at = engine._malloc(size + 1);
    engine.stringToUTF8(value, at, size + 1);
    return [at, size];
  };
  const text = (value) => {
    const [at] = placed(value);
    zone.push(at);
    return at;
  };
  const job = engine._wythe_new(text(task));
  for (const [name, value] of Object.entries(inputs.texts ?? {}))
    for (const one of typeof value === "string" ? [value] : value) {
      const [at, size] = placed(one);
      engine._wythe_set_text(job, text(name), at, size);
      engine._free(at); // the engine has its own
    }
  for (const [name, value] of Object.entries(inputs.numbers ?? {})) engine._wythe_set_number(job, text(name), value);
  for (const [name, values] of Object.entries(inputs.columns ?? {})) {
    const at = engine._malloc(8 * values.length + 8);
    zone.push(at);
    engine.HEAPF64.set(values, at / 8);
    engine._wythe_set_column(job, text(name), at, values.length);
  }
  const answer = (name) => {
    const at = engine._wythe_text(job, text(name), 0);
    return at === 0 ? undefined : engine.UTF8ToString(at);
  };
  const list = (name) => JSON.parse(answer(name) ?? "[]");
  // Why a text or table that is made when it is asked for could not be made; "" where there is none of that name.
  const failure = () => answer("error") ?? "";
  const kNoMemory = 5;
  const kDefect = 6;
  return {
    /** @param {Progress} progress */
    do(progress = () => false) {
      engine.progress = progress;
      return engine._wythe_do_here(job);
    },
    /**
     * The answers that there are; `code` where one could not be made, with its reason as the text "error".
     * @param {{texts?: string[], bytes?: string[], tables?: string[]}} want names of answers; `bytes`: texts as UTF-8
     */
    answers(want = {}) {
      const texts = {};
      for (const name of ["error", "faults"]) texts[name] = answer(name) ?? "";
      const bytes = {};
      let failed = "";
      const taken = (found) => {
        if (found === undefined) failed ||= failure();
        return found !== undefined;
      };
      for (const name of want.bytes ?? []) {
        const found = bytesOf(engine, job, text(name));
        if (taken(found)) bytes[name] = found;
      }
      for (const name of want.texts?.includes("*") ? list("texts") : (want.texts ?? [])) {
        const found = answer(name);
        if (taken(found)) texts[name] = found;
      }
      const tables = {};
      for (const name of want.tables?.includes("*") ? Object.keys(JSON.parse(answer("tables") ?? "{}")) : (want.tables ?? [])) {
        const columns = JSON.parse(answer(`columns of ${name}`) || (taken(undefined), "[]"));
        if (columns.length === 0) continue;
        tables[name] = {};
        for (const column of columns) tables[name][column] = columnOf(engine, job, text(name), text(column));
      }
      if (failed === "") return { texts, bytes, tables };
      return { code: /memory/.test(failed) ? kNoMemory : kDefect, texts: { ...texts, error: failed }, bytes, tables };
    },
    free() {
      engine._wythe_free(job);
      for (const at of zone) engine._free(at);
    },
  };
}

/**
 * Does a task and gives its code and the answers that are asked for.
 * @param {any} engine
 * @param {string} task
 * @param {Inputs} inputs
 * @param {{texts?: string[], tables?: string[]}} want
 * @param {Progress} progress
 */
export function doTask(engine, task, inputs, want = {}, progress = () => false) {
  const job = openJob(engine, task, inputs);
  try {
    return { code: job.do(progress), ...job.answers(want) };
  } finally {
    job.free();
  }
}

function bytesOf(engine, job, name) {
  const size = engine._malloc(8);
  try {
    const at = engine._wythe_text(job, name, size);
    const count = new DataView(engine.HEAPU8.buffer).getUint32(size, true);
    return at === 0 ? undefined : engine.HEAPU8.slice(at, at + count);
  } finally {
    engine._free(size);
  }
}

function columnOf(engine, job, table, column) {
  const rows = engine._malloc(8);
  try {
    const at = engine._wythe_column(job, table, column, rows);
    const count = new DataView(engine.HEAPU8.buffer).getUint32(rows, true);
    return at === 0 ? new Float64Array() : new Float64Array(engine.HEAPU8.buffer.slice(at, at + 8 * count));
  } finally {
    engine._free(rows);
  }
}
