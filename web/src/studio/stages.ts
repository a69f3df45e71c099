// What is done to the wall: its push and the load on its top, read from the file, and their edits.
import type { Drawing } from "./drawing";
import { countAt, find, parse, quoted, setValue, valueAt, type Doc, type Path } from "./file/toml";
import { amountOf, lengthOf, setLength, times } from "./file/units";

export interface Push {
  stage: number;
  x: number | null; // of a point that is pushed
  y: number | null;
  direction: string;
  until: string | null;
}

export function pushOf(doc: Doc): Push | null {
  for (let k = 0; k < countAt(doc, ["stage"]); ++k) {
    const has = (key: string): boolean => find(doc, ["stage", k, key]) !== undefined;
    if (!has("until") && !has("at") && !has("pattern")) continue;
    const until = valueAt(doc, ["stage", k, "until"]);
    return {
      stage: k,
      x: lengthOf(valueAt(doc, ["stage", k, "at", "x"])),
      y: lengthOf(valueAt(doc, ["stage", k, "at", "y"])),
      direction: String(valueAt(doc, ["stage", k, "direction"]) ?? "+x"),
      until: typeof until === "string" ? until : null,
    };
  }
  return null;
}

// The other way: a push at one end begins at the other.
export function setDirection(text: string, d: Drawing, direction: string): string {
  const push = pushOf(parse(text));
  if (!push || push.direction === direction) return text;
  let out = setValue(text, ["stage", push.stage, "direction"], quoted(direction));
  if (push.x !== null) out = setLength(out, ["stage", push.stage, "at", "x"], Math.max(0, d.length - push.x));
  return out;
}

export function pushAlong(text: string, d: Drawing, length: number, height: number): string {
  let out = text;
  const push = pushOf(parse(out));
  if (!push) return out;
  const at: Path = ["stage", push.stage, "at"];
  if (push.x !== null && push.x > 0.5 * d.length) out = setLength(out, [...at, "x"], Math.max(0, push.x + length - d.length));
  if (push.y !== null && push.y > 0.5 * d.height) {
    const course = d.course / 2;
    out = setLength(out, [...at, "y"], Math.min(height - course, Math.max(course, push.y + height - d.height)));
  }
  return out;
}

// A push at half its speed. One that adapts has the engine's two speeds, which are not in the file. null: it cannot be read.
const kSpeeds = { velocity: "0.1 mm/s", fast_velocity: "5 mm/s" };

export function slower(text: string): string | null {
  const doc = parse(text);
  const push = pushOf(doc);
  if (!push) return null;
  const stated = (key: string): unknown => valueAt(doc, ["stage", push.stage, key]);
  let out = text;
  for (const key of ["velocity", "fast_velocity"] as const) {
    if (stated(key) === undefined && stated("velocity") !== undefined) continue; // one speed throughout
    const half = times(stated(key) ?? kSpeeds[key], 0.5);
    if (half === null || amountOf(half, "m/s") === null) return null;
    out = setValue(out, ["stage", push.stage, key], quoted(half));
  }
  return out;
}

// A push twice as far. null: how far cannot be read.
export function farther(text: string): string | null {
  const push = pushOf(parse(text));
  const twice = push && times(push.until, 2);
  return push && twice !== null && lengthOf(twice) !== null ? setValue(text, ["stage", push.stage, "until"], quoted(twice)) : null;
}

// The load on the top: the first stage that has one.
export const kLoads = ["pier_load", "beam_load", "pressure"] as const;

export interface Load {
  path: Path;
  key: (typeof kLoads)[number];
  value: string;
}

export function loadOf(doc: Doc): Load | null {
  for (let k = 0; k < countAt(doc, ["stage"]); ++k)
    for (const key of kLoads) {
      const value = valueAt(doc, ["stage", k, key]);
      if (typeof value === "string") return { path: ["stage", k, key], key, value };
    }
  return null;
}
