// A worker of a page: the engine's script and job.mjs stand before it (page.mjs). One question at a time.
//
//   to it:   {wasm}, answered by {ready, version}; then {id, task, texts, numbers, want, tables}
//   from it: {id, progress} a few times a second; {id, code, texts, tables}
let engine;

onmessage = async ({ data }) => {
  if (data.wasm) {
    engine = await wytheEngine({ wasmBinary: data.wasm, printErr: () => {} });
    postMessage({ ready: true, version: engine.UTF8ToString(engine._wythe_version()) });
    return;
  }
  const { id, task, texts, numbers, want, tables } = data;
  const tell = (what, share, displacement_mm, reaction_kN) => {
    postMessage({ id, progress: { what, share, displacement_mm, reaction_kN } });
    return false;
  };
  try {
    postMessage({ id, ...doTask(engine, task, { texts, numbers }, { texts: want, tables }, tell) });
  } catch (error) {
    postMessage({ id, code: 6, texts: { error: `the engine ended: ${error}` }, tables: {} });
  }
};
