// One process at a time writes in a folder. Each one adds a line with its number to a file there, in one call of the system, and the
// first whose process lives holds the folder. So a process that was killed holds nothing, and of several that begin at once one does.
import fs from "node:fs";
import os from "node:os";
import path from "node:path";
import { Refused, using } from "./refused.mjs";

const kName = ".wythe_lock";

// Of a process on another machine nobody knows; it is taken as alive.
function isAlive(line) {
  const [, number, machine] = /^process (\d+) on (.+)$/.exec(line) ?? [];
  if (machine !== os.hostname()) return machine !== undefined;
  try {
    process.kill(Number(number), 0); // only asks
    return true;
  } catch (error) {
    return error.code === "EPERM"; // it is another user's
  }
}

function linesOf(file) {
  try {
    return fs.readFileSync(file, "utf8").split("\n");
  } catch (error) {
    if (error.code !== "ENOENT") throw error;
    return [];
  }
}

/** Holds a folder, which is made if absent, and gives what lets go of it; refuses where another process holds it. */
export function hold(folder) {
  const whole = path.resolve(folder);
  const made = fs.mkdirSync(whole, { recursive: true });
  const file = path.join(whole, kName);
  const mine = `process ${process.pid} on ${os.hostname()}`;
  let lines;
  do {
    lines = using(file, () => {
      fs.appendFileSync(file, `${mine}\n`);
      return linesOf(file);
    });
  } while (!lines.includes(mine)); // who held it removed the file just then
  const holder = lines.find(isAlive);
  if (holder !== mine)
    throw new Refused(4, `${folder}: another wythe writes its results there (${holder}); wait for it or stop it, or name another folder; if there is no such process, remove ${file}`);
  return () => {
    fs.rmSync(file, { force: true });
    for (let at = whole; made !== undefined && at.length >= made.length; at = path.dirname(at))
      try {
        fs.rmdirSync(at);
      } catch {
        return; // it holds results
      }
  };
}
