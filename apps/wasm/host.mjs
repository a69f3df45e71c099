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

/** Whether a file lies on the drive `root`. The case of a name counts where the system counts it: C: and c: are one drive. */
export const isOnDrive = (file, root, paths = path) => !paths.isAbsolute(paths.relative(root, file));
export const isSamePlace = (one, other, paths = path) => paths.relative(one, other) === "";

/** What the engine says, with paths of the machine. */
export const seenByUser = (text, root) => text.replaceAll(`${HOST}/`, root);
