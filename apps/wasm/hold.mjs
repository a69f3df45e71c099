// One process at a time writes in a folder. Each one adds a line with its number to a file there, in one call of the system, and the
// first whose process lives holds the folder. So of several that begin at once one does. A process that was killed holds nothing. On Linux
// its line says when it began, so that its number may be given again.
import fs from "node:fs";
import os from "node:os";
import path from "node:path";
import { Refused, using } from "./refused.mjs";

const kName = ".wythe_lock";
const kTries = 100; // more is no holder that lets go just then

// When a process began, in ticks of the clock since the machine did; undefined: the system does not say it so.
function beginOf(number) {
  try {
    const stat = fs.readFileSync(`/proc/${number}/stat`, "latin1");
    return stat.slice(stat.lastIndexOf(")") + 2).split(" ")[19]; // behind the program's name, which may hold anything
  } catch {
    return undefined;
  }
}

// Of a process on another machine nobody knows; it is taken as alive.
function isAlive(line) {
  const [, number, machine, begin] = /^process (\d+) on (.+?)(?:, begun (\d+))?$/.exec(line) ?? [];
  if (machine !== os.hostname()) return machine !== undefined;
  try {
    process.kill(Number(number), 0); // only asks
  } catch (error) {
    if (error.code !== "EPERM") return false; // else it is another user's
  }
  return begin === undefined || (beginOf(number) ?? begin) === begin;
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
  const file = path.join(whole, kName);
  const place = `process ${process.pid} on ${os.hostname()}`;
  const begin = beginOf(process.pid);
  const mine = begin === undefined ? place : `${place}, begun ${begin}`;
  let made;
  let lines = [];
  for (let tries = 1; !lines.includes(mine); ++tries) {
    try {
      made = fs.mkdirSync(whole, { recursive: true }) ?? made;
      lines = using(file, () => {
        fs.appendFileSync(file, `${mine}\n`);
        return linesOf(file); // without this line if the holder removed the file just then
      });
    } catch (error) {
      if (error.code !== "ENOENT" || tries === kTries) throw error; // else the holder removed the folder just then
    }
  }
  const holder = lines.find(isAlive);
  if (holder !== mine)
    throw new Refused(
      4,
      `${folder}: another wythe writes its results there (${holder.replace(/, begun \d+$/, "")}); wait for it, or name another folder; if that process is no wythe, or is gone, remove ${file}`,
    );
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
