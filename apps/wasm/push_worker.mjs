// A thread that pushes walls of `wythe assess`: it takes {way, wall}, and gives {share} on the way and {code, record, error} at the end.
import { parentPort, workerData } from "node:worker_threads";
import { loaded } from "./host.mjs";

const kOften = 300; // between two news of progress [ms]
const { module, root } = workerData;
const wythe = await loaded(root, module);

parentPort.on("message", ({ inputs, way, wall }) => {
  let told = Date.now();
  const tell = (what, share) => {
    if (Date.now() - told < kOften) return false;
    told = Date.now();
    parentPort.postMessage({ share });
    return false;
  };
  try {
    const done = wythe.do("assess", { ...inputs, numbers: { ...inputs.numbers, way, wall } }, { texts: ["record"] }, tell);
    parentPort.postMessage({ code: done.code, record: done.texts.record, error: done.texts.error });
  } catch (error) {
    parentPort.postMessage({ code: 6, error: `the engine ended: ${error}` });
  }
});
parentPort.postMessage({ ready: true });
