// Storeys: a line that parts the wall, moved or taken away, and what stands or lies on it goes along.
import { crownOf } from "./arches";
import { pushAlong } from "../stages";
import type { Drawing } from "../drawing";
import { appendTable, countAt, find, insertTable, literalOf, parse, quoted, removeAt, renameKey, setValue, valueAt, type Doc, type Path } from "../file/toml";
import { lengthOf, setLength, writeQuantity } from "../file/units";

const metres = (v: number): string => quoted(writeQuantity(v, "m", "0.00"));
const kNear = 0.011; // of a level that belongs to a line [m]
const kNearPush = 0.3; // a push acts in the courses below a floor [m]

const topOf = (d: Drawing, k: number): number => d.storeys[k].foot + d.storeys[k].height;

// The opening that a line at this height would cut.
export const cutBy = (d: Drawing, y: number): string | null => d.openings.find((o) => o.y < y - 1e-6 && crownOf(o) > y + 1e-6)?.name ?? null;

// A line at height y: it parts the wall or a storey in two. Above the wall's top it makes a storey more.
// null: what the file says of regions there cannot be kept.
export function addStorey(text: string, d: Drawing, y: number, nameOf: (n: number) => string): string | null {
  const taken = new Set(d.storeys.map((s) => s.name));
  const fresh = (): string => {
    let n = 0;
    while (taken.has(nameOf(n))) ++n;
    taken.add(nameOf(n));
    return nameOf(n);
  };
  const higher = y > d.height + 1e-6;
  if (d.storeys.length === 0) {
    if (boundTo(parse(text), null)) return null;
    const lower = fresh(),
      upper = fresh();
    const line = higher ? d.height : y;
    let out = appendTable(text, ["storey"], [["name", quoted(lower)], ["height", metres(line)]], ["wall"]);
    out = appendTable(out, ["storey"], [["name", quoted(upper)], ["height", metres((higher ? y : d.height) - line)]]);
    d.openings.forEach((o, k) => (out = intoStorey(out, k, o.y >= line - 1e-6 ? upper : lower, o.y >= line - 1e-6 ? o.y - line : o.y)));
    return higher ? wallAsHigh(pushAlong(out, d, d.length, y), y) : out;
  }
  const name = fresh();
  if (higher) return wallAsHigh(pushAlong(appendTable(text, ["storey"], [["name", quoted(name)], ["height", metres(y - d.height)]]), d, d.length, y), y);
  const k = d.storeys.findIndex((_, i) => topOf(d, i) > y);
  const storey = d.storeys[k];
  const doc = parse(text);
  if (boundTo(doc, storey.name)) return null;
  const node = find(doc, ["storey", k]);
  const own = node?.kind === "table" ? [...node.keys.keys()].filter((key) => key !== "name" && key !== "height") : [];
  const pairs: [string, string][] = [["name", quoted(name)], ["height", metres(topOf(d, k) - y)], ...own.map((key): [string, string] => [key, literalOf(doc, ["storey", k, key])])];
  let out = insertTable(setLength(text, ["storey", k, "height"], y - storey.foot), ["storey"], k + 1, pairs);
  d.openings.forEach((o, i) => {
    if (o.foot === storey.foot && o.y >= y - 1e-6 && find(doc, ["wall", "opening", i, "storey"])) out = intoStorey(out, i, name, o.y - y);
  });
  return renameTops(out, storey.name, name);
}

// The line below storey k, to height y: both storeys share their height anew.
export function moveStoreyLine(text: string, d: Drawing, k: number, y: number): string {
  let out = setLength(text, ["storey", k - 1, "height"], y - d.storeys[k - 1].foot);
  out = setLength(out, ["storey", k, "height"], topOf(d, k) - y);
  return follow(out, [[d.storeys[k].foot, y]]);
}

// Storey k of another height: what is above rises with it.
export function setStoreyHeight(text: string, d: Drawing, k: number, height: number): string {
  if (height <= 0) return text;
  if (k === d.storeys.length - 1) return setWallSize(text, d, d.length, d.storeys[k].foot + height);
  const by = height - d.storeys[k].height;
  const out = setLength(text, ["storey", k, "height"], height);
  const lines = d.storeys.slice(k + 1).map((s): [number, number] => [s.foot, s.foot + by]);
  const whole = d.height + by;
  return wallAsHigh(pushAlong(follow(out, [...lines, [d.height, whole]]), d, d.length, whole), whole);
}

// Without the line below storey k: the storey below takes it in, with its own masonry. null: as for addStorey.
export function removeStoreyLine(text: string, d: Drawing, k: number): string | null {
  const below = d.storeys[k - 1],
    storey = d.storeys[k];
  let out = setLength(text, ["storey", k - 1, "height"], below.height + storey.height);
  const doc = parse(text);
  if (boundTo(doc, below.name) || boundTo(doc, storey.name)) return null;
  // what lies on the line stays at its height; a beam's is that of its foot
  for (const list of ["floor", "diaphragm", "ring_beam"])
    for (let i = 0; i < countAt(doc, [list]); ++i) {
      const at: Path = [list, i];
      const name = valueAt(doc, [...at, "storey"]);
      if (name === below.name) {
        const depth = list === "ring_beam" ? lengthOf(valueAt(doc, [...at, "height"])) : 0;
        if (depth === null) return null;
        out = renameKey(out, [...at, "storey"], "y", metres(storey.foot - depth));
      }
      if (name === storey.name) out = setValue(out, [...at, "storey"], quoted(below.name));
    }
  d.openings.forEach((o, i) => {
    if (valueAt(doc, ["wall", "opening", i, "storey"]) === storey.name) out = intoStorey(out, i, below.name, o.y - below.foot);
  });
  for (let i = 0; i < countAt(doc, ["region"]); ++i) {
    const at: Path = ["region", i];
    if (valueAt(doc, [...at, "storey"]) !== storey.name) continue;
    out = setValue(out, [...at, "storey"], quoted(below.name));
    for (const path of heightsOf(doc, at)) out = setLength(out, path, lengthOf(valueAt(doc, path))! + below.height);
  }
  return removeAt(out, ["storey", k]);
}

// Another name, wherever the file says it.
export function renameStorey(text: string, d: Drawing, k: number, name: string): string {
  if (d.storeys.some((s, i) => i !== k && s.name === name)) return text;
  const old = d.storeys[k].name;
  let out = setValue(text, ["storey", k, "name"], quoted(name));
  const doc = parse(text);
  for (const list of [["wall", "opening"], ["floor"], ["diaphragm"], ["ring_beam"], ["region"]])
    for (let i = 0; i < countAt(doc, list); ++i)
      if (valueAt(doc, [...list, i, "storey"]) === old) out = setValue(out, [...list, i, "storey"], quoted(name));
  return out;
}

// --- regions ----------------------------------------------------------------------------------------

// Where a box or a polygon says its heights, from the foot of its storey; none where they cannot be read.
function heightsOf(doc: Doc, at: Path): Path[] {
  const corners = countAt(doc, [...at, "polygon"]);
  const paths = corners > 0 ? Array.from({ length: corners }, (_, n): Path => [...at, "polygon", n, 1]) : [[...at, "y"]];
  return paths.every((path) => lengthOf(valueAt(doc, path)) !== null) ? paths : [];
}
// Whether a region is as high as a storey, or as the wall without storeys: all of it or a pier.
function boundTo(doc: Doc, storey: string | null): boolean {
  const regions = Array.from({ length: countAt(doc, ["region"]) }, (_, i): Path => ["region", i]);
  return regions.some((at) => (valueAt(doc, [...at, "storey"]) ?? null) === storey && heightsOf(doc, at).length === 0);
}

// --- what goes along --------------------------------------------------------------------------------

function intoStorey(text: string, k: number, name: string, y: number): string {
  return setLength(setValue(text, ["wall", "opening", k, "storey"], quoted(name)), ["wall", "opening", k, "y"], y);
}
// What lies on top of a storey lies on its upper part when it is parted.
function renameTops(text: string, from: string, to: string): string {
  let out = text;
  const doc = parse(text);
  for (const list of ["floor", "diaphragm", "ring_beam"])
    for (let i = 0; i < countAt(doc, [list]); ++i) if (valueAt(doc, [list, i, "storey"]) === from) out = setValue(out, [list, i, "storey"], quoted(to));
  return out;
}
function wallAsHigh(text: string, height: number): string {
  return valueAt(parse(text), ["wall", "height"]) === undefined ? text : setLength(text, ["wall", "height"], height);
}
// Lines that moved take along floors, ties and diaphragms at their height, and forces of a push just below.
function follow(text: string, moves: [from: number, to: number][]): string {
  let out = text;
  const doc = parse(text);
  const take = (path: Path, below: number): void => {
    const y = lengthOf(valueAt(doc, path));
    const move = y === null ? undefined : moves.find(([from]) => y <= from + kNear && y >= from - below);
    if (move) out = setLength(out, path, y! + move[1] - move[0]);
  };
  for (const list of ["floor", "diaphragm"]) for (let i = 0; i < countAt(doc, [list]); ++i) take([list, i, "y"], kNear);
  for (let i = 0; i < countAt(doc, ["tie"]); ++i) for (const end of ["from", "to"]) take(["tie", i, end, "y"], kNearPush);
  for (let i = 0; i < countAt(doc, ["stage"]); ++i) {
    for (let n = 0; n < countAt(doc, ["stage", i, "levels"]); ++n) take(["stage", i, "levels", n], kNearPush);
    take(["stage", i, "control", "y"], kNearPush);
  }
  return out;
}

// A wall of another size: what pushes it stays at its side and as far below the top.
export function setWallSize(text: string, d: Drawing, length: number, height: number): string {
  let out = setLength(text, ["wall", "length"], length);
  if (d.storeys.length > 0) {
    const last = d.storeys.length - 1;
    const rest = height - d.storeys[last].foot;
    if (rest > 0) out = setLength(out, ["storey", last, "height"], rest);
    if (valueAt(parse(out), ["wall", "height"]) !== undefined) out = setLength(out, ["wall", "height"], height);
  } else out = setLength(out, ["wall", "height"], height);
  return pushAlong(tiesAlong(out, d, length), d, length, height);
}

// Anchors at the right end stay there.
const kEnd = 0.5; // [m]

function tiesAlong(text: string, d: Drawing, length: number): string {
  let out = text;
  d.ties.forEach((t, k) => {
    for (const end of ["from", "to"] as const) {
      const p = t[end];
      if (p && p.x > d.length - kEnd && p.x > d.length / 2) out = setLength(out, ["tie", k, end, "x"], Math.max(0, p.x + length - d.length));
    }
  });
  return out;
}
