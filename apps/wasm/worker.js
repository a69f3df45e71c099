// A worker of a page: the engine's script and job.mjs stand before it (page.mjs). One question at a time.
//
//   to it:   {wasm}, answered by {ready, version}, or by an error of the worker; then {id, task, texts, numbers, want, first, bytes, tables, pieces},
//            and {pause} while it is at it
//   from it: {id, progress} a few times a second; {id, code, texts, bytes, tables}, with `thrown` where texts.error is the browser's
//
// `pieces`: a run is stopped a few times a second and goes on, with the same bits. In between it shows the wall as it stands
// (progress.svg), and pauses where it is told to, which it says (progress.held). `bytes`: texts that come as UTF-8, not copied.
// `first`: texts that are sent before the others are made (progress.texts).
const kPiece = 350; // of a run in pieces, at least [ms]
const kShare = 4; // a piece takes so many times what the stop after it costs
let engine;
let paused = false;
let goOn = () => undefined;

onmessage = async ({ data }) => {
  if (data.wasm) return start(data.wasm).catch((error) => setTimeout(() => { throw error; })); // the page hears of it (onerror); nothing else would
  if ("pause" in data) {
    paused = data.pause;
    return goOn();
  }
  paused = false;
  try {
    await answer(data);
  } catch (error) {
    postMessage({ id: data.id, code: 6, texts: { error: String(error) }, tables: {}, thrown: true });
  }
};

async function start(wasm) {
  engine = await new Promise((done, refuse) => {
    const instantiateWasm = (imports, made) => {
      WebAssembly.instantiate(wasm, imports).then((instance) => made(instance, wasm)).catch(refuse);
      return {};
    };
    const compiled = wasm instanceof WebAssembly.Module; // by the page, for all its workers
    wytheEngine({ ...(compiled ? { instantiateWasm } : { wasmBinary: wasm }), printErr: () => {} }).then(done, refuse);
  });
  postMessage({ ready: true, version: engine.UTF8ToString(engine._wythe_version()) });
}

async function answer({ id, task, texts, numbers, want, first, bytes, tables, pieces }) {
  const job = openJob(engine, task, { texts, numbers: pieces ? { ...numbers, goes_on: 1 } : numbers });
  let last = null; // progress
  let until = Infinity; // end of the piece [ms]
  let stopped = 0; // when the piece before was [ms]
  let length = kPiece;
  const tell = (what, share, displacement_mm, reaction_kN) => {
    const now = performance.now();
    if (stopped > 0) {
      length = Math.max(kPiece, kShare * (now - stopped));
      until = now + length;
      stopped = 0;
    }
    last = { what, share, displacement_mm, reaction_kN };
    postMessage({ id, progress: last });
    if (now < until) return false;
    stopped = now;
    return true;
  };
  try {
    if (pieces) until = performance.now() + length;
    let code = job.do(tell);
    while (pieces && code === 3) {
      postMessage({ id, progress: { ...last, svg: job.answers({ texts: ["svg"] }).texts.svg ?? "" } });
      const cost = performance.now() - stopped;
      await new Promise((done) => setTimeout(done)); // what the page says meanwhile is heard
      if (paused) postMessage({ id, progress: { ...last, held: true } });
      while (paused) await new Promise((done) => (goOn = done));
      stopped = performance.now() - cost;
      code = job.do(tell);
    }
    const early = first && code === 0 ? job.answers({ texts: first }) : { texts: {} };
    if (first && early.code === undefined) postMessage({ id, progress: { ...last, texts: early.texts } });
    const answers = early.code === undefined ? job.answers({ texts: (want ?? []).filter((name) => !(name in early.texts)), bytes, tables }) : early;
    answers.texts = { ...early.texts, ...answers.texts };
    postMessage({ id, code, ...answers }, Object.values(answers.bytes ?? {}).map((b) => b.buffer)); // a text that could not be made has a code
  } finally {
    job.free();
  }
}
