// What stops a command: one line for the user, with its place and its cure, and the exit code of the native program.
import fs from "node:fs";
import path from "node:path";

/** `code`: 2 an input is not admissible, 4 a file of the machine cannot be used. */
export class Refused extends Error {
  constructor(code, words) {
    super(words);
    this.code = code;
  }
}

const kDoes = { mkdir: "made", open: "opened", read: "read", rename: "written", write: "written" }; // by call of the system
const kCauses = {
  EACCES: "there is no right to it; change its rights, or name another place",
  EBUSY: "another program uses it; close that one, or name another place",
  EDQUOT: "its disk is full; make room, or name another place",
  EEXIST: "a file stands where a folder must be; name another place",
  EISDIR: "it is a folder; name a file",
  ENOENT: "it is missing; name another one",
  ENOSPC: "its disk is full; make room, or name another place",
  ENOTDIR: "a file stands where a folder must be; name another place",
  EPERM: "there is no right to it; change its rights, or name another place",
  EROFS: "its disk can only be read; name another place",
};

/** A refusal, or an error of the system about a file, as a refusal; undefined for a defect of the program. */
export function refusalOf(error) {
  if (error instanceof Refused) return error;
  const { code, syscall, path: place } = error ?? {};
  if (!syscall || !place) return undefined;
  const isFolderMissing = code === "ENOENT" && !fs.existsSync(path.dirname(place));
  const why = isFolderMissing ? "its folder is missing; make it, or name another place" : (kCauses[code] ?? `the system says ${code}; name another place`);
  return new Refused(4, `${place}: cannot be ${kDoes[syscall] ?? "used"}: ${why}`);
}

/** Does what uses a file. Node does not name the file where the system fails to read or to write what is open; this does. */
export function using(file, action) {
  try {
    return action();
  } catch (error) {
    throw error.syscall ? Object.assign(error, { path: file }) : error;
  }
}

// The file that a link leads to, though it may be missing; another file is its own.
function targetOf(file) {
  try {
    return fs.realpathSync(file);
  } catch {
    try {
      return path.resolve(fs.realpathSync(path.dirname(file)), fs.readlinkSync(file));
    } catch {
      return file;
    }
  }
}

/** Writes a file that is then complete, or as it was. A link stays one. */
export function put(file, content) {
  const target = targetOf(file);
  const isOther = fs.existsSync(target) && !fs.statSync(target).isFile(); // a folder is refused; a device must not be replaced
  const fresh = isOther ? target : path.join(path.dirname(target), `.${path.basename(target)}.${process.pid}`);
  using(file, () => {
    try {
      fs.writeFileSync(fresh, content);
      if (!isOther) fs.renameSync(fresh, target);
    } catch (error) {
      if (!isOther && fs.existsSync(fresh)) fs.rmSync(fresh);
      throw error;
    }
  });
}
