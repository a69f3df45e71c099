// The files of the machine as the engine sees them: the drive of the model lies at /host.
import path from "node:path";
import { load } from "./index.mjs";

const HOST = "/host";

/** The engine with the drive `root`; undefined: without files. @param {WebAssembly.Module} [module] compiled before */
export async function loaded(root, module) {
  const wythe = await load(module);
  if (root !== undefined) {
    wythe.engine.FS.mkdir(HOST);
    wythe.engine.FS.mount(wythe.engine.NODEFS, { root }, HOST);
  }
  return wythe;
}

export const seenByEngine = (file, root) => `${HOST}/${path.relative(root, file).split(path.sep).join("/")}`;

/** What the engine says, with paths of the machine. */
export const seenByUser = (text, root) => text.replaceAll(`${HOST}/`, root);
