// Floors: their weight lies on the wall at a level, on a storey's top or at a height of its own; and the diaphragm that
// keeps points of the wall at their distance there.
import { crownOf } from "./arches";
import { coursesAt, type Drawing, type Storey } from "../drawing";
import { appendTable, countAt, find, listAt, parse, quoted, removeAt, renameKey, setValue, valueAt, type Doc, type Path } from "../file/toml";
import { amountOf, lengthOf, setLength, writeQuantity } from "../file/units";

export interface Floor {
  name: string;
  y: number; // NaN: the file says no level that is known
  onStorey: boolean; // on the top of one, not at a height of its own
  x: number;
  width: number;
  load: number | null; // [N/m]; null: the file says one that is not read here
  diaphragm: number; // at its level, or -1
}
export interface Diaphragm {
  y: number;
  x: number[];
  kind: string;
}
export const kHolds = ["none", "rigid", "elastic"] as const;
export type Hold = (typeof kHolds)[number];

const kNear = 0.011; // the engine moves a floor to a bed joint within 10 mm
const metres = (v: number): string => quoted(writeQuantity(v, "m", "0.00"));
const topOf = (s: Storey): number => s.foot + s.height;

function levelOf(doc: Doc, at: Path, storeys: Storey[]): number {
  const name = valueAt(doc, [...at, "storey"]);
  const storey = storeys.find((s) => s.name === name);
  return storey ? topOf(storey) : (lengthOf(valueAt(doc, [...at, "y"])) ?? NaN);
}
export function readDiaphragms(doc: Doc, storeys: Storey[]): Diaphragm[] {
  return Array.from({ length: countAt(doc, ["diaphragm"]) }, (_, k) => ({
    y: levelOf(doc, ["diaphragm", k], storeys),
    x: listAt(doc, ["diaphragm", k, "x"]).map((v) => lengthOf(v) ?? NaN),
    kind: String(valueAt(doc, ["diaphragm", k, "kind"]) ?? "elastic"),
  }));
}
export function readFloors(doc: Doc, storeys: Storey[], length: number): Floor[] {
  const diaphragms = readDiaphragms(doc, storeys);
  return Array.from({ length: countAt(doc, ["floor"]) }, (_, k) => {
    const at: Path = ["floor", k];
    const y = levelOf(doc, at, storeys);
    const x = lengthOf(valueAt(doc, [...at, "x"])) ?? 0;
    return {
      name: String(valueAt(doc, [...at, "name"]) ?? k + 1),
      y,
      onStorey: valueAt(doc, [...at, "storey"]) !== undefined,
      x,
      width: lengthOf(valueAt(doc, [...at, "width"])) ?? length - x,
      load: loadOf(doc, at),
      diaphragm: diaphragms.findIndex((d) => Math.abs(d.y - y) < kNear),
    };
  });
}
// load, or (g1 + g2 + psi2 q) span / 2.
function loadOf(doc: Doc, at: Path): number | null {
  const has = (key: string): boolean => find(doc, [...at, key]) !== undefined;
  const value = (key: string, base: string): number | null => (has(key) ? amountOf(valueAt(doc, [...at, key]), base) : 0);
  if (has("load")) return value("load", "N/m");
  const [g1, g2, q, span] = [value("g1", "Pa"), value("g2", "Pa"), value("q", "Pa"), value("span", "m")];
  const psi2 = has("psi2") ? valueAt(doc, [...at, "psi2"]) : 0;
  if (g1 === null || g2 === null || q === null || span === null || typeof psi2 !== "number") return null;
  return ((g1 + g2 + psi2 * q) * span) / 2;
}

// --- edits ------------------------------------------------------------------------------------------

const storeyBelow = (d: Drawing, y: number): Storey | undefined => d.storeys.find((s) => Math.abs(topOf(s) - y) < kNear);

export function addFloor(text: string, d: Drawing, y: number, word: string): string {
  const taken = new Set(d.floors.map((f) => f.name));
  let n = 1;
  while (taken.has(`${word} ${n}`)) ++n;
  const storey = storeyBelow(d, y);
  const level: [string, string] = storey ? ["storey", quoted(storey.name)] : ["y", metres(y)];
  return appendTable(text, ["floor"], [["name", quoted(`${word} ${n}`)], level, ["load", quoted("10 kN/m")]], ["wall", "storey", "region"]);
}
// To another height, and its diaphragm with it.
export function moveFloor(text: string, d: Drawing, k: number, y: number): string {
  let out = atLevel(text, ["floor", k], d, y);
  if (d.floors[k].diaphragm >= 0) out = atLevel(out, ["diaphragm", d.floors[k].diaphragm], d, y);
  return out;
}
function atLevel(text: string, at: Path, d: Drawing, y: number): string {
  const storey = storeyBelow(d, y);
  if (find(parse(text), [...at, "storey"])) return storey ? setValue(text, [...at, "storey"], quoted(storey.name)) : renameKey(text, [...at, "storey"], "y", metres(y));
  return storey ? renameKey(text, [...at, "y"], "storey", quoted(storey.name)) : setLength(text, [...at, "y"], y);
}
// From x over a width; the whole wall needs no words.
export function setFloorSpan(text: string, d: Drawing, k: number, x: number, width: number): string {
  let out = text;
  for (const [key, value, whole] of [["x", x, 0], ["width", width, d.length - x]] as const) {
    const path: Path = ["floor", k, key];
    const has = find(parse(out), path) !== undefined;
    if (has || Math.abs(value - whole) > 1e-4) out = setLength(out, path, value);
  }
  return out;
}
export function removeFloor(text: string, d: Drawing, k: number): string {
  const { diaphragm } = d.floors[k];
  const alone = d.floors.filter((f) => f.diaphragm === diaphragm).length === 1;
  const out = removeAt(text, ["floor", k]);
  return diaphragm >= 0 && alone ? removeAt(out, ["diaphragm", diaphragm]) : out;
}

export const holdOf = (d: Drawing, k: number): Hold => (d.floors[k].diaphragm < 0 ? "none" : d.diaphragms[d.floors[k].diaphragm].kind === "rigid" ? "rigid" : "elastic");
export function setHold(text: string, d: Drawing, k: number, hold: Hold): string {
  const floor = d.floors[k];
  if (hold === "none") return floor.diaphragm < 0 ? text : removeAt(text, ["diaphragm", floor.diaphragm]);
  const stiffness = quoted("300 MN"); // of a floor of planks with a layer of concrete, some metres wide
  if (floor.diaphragm >= 0) {
    const at: Path = ["diaphragm", floor.diaphragm];
    const out = setValue(text, [...at, "kind"], quoted(hold));
    if (hold === "rigid") return removeAt(out, [...at, "stiffness"]);
    return find(parse(out), [...at, "stiffness"]) ? out : setValue(out, [...at, "stiffness"], stiffness);
  }
  const storey = storeyBelow(d, floor.y);
  const pairs: [string, string][] = [
    ["name", quoted(floor.name)],
    ["kind", quoted(hold)],
    storey ? ["storey", quoted(storey.name)] : ["y", metres(floor.y)],
    ["x", `[${piersBelow(d, floor).map(metres).join(", ")}]`],
  ];
  if (hold === "elastic") pairs.push(["stiffness", stiffness]);
  return appendTable(text, ["diaphragm"], pairs, ["wall", "storey", "region", "floor"]);
}
// Middles of the masonry just below a floor, between openings; of one wall without any, its ends.
function piersBelow(d: Drawing, floor: Floor): number[] {
  const low = floor.y - coursesAt(d, floor.y - 1e-3).course / 2;
  const end = Math.min(d.length, floor.x + floor.width);
  const out: number[] = [];
  let from = floor.x;
  const storey = d.storeys.find((s) => s.foot < low && topOf(s) > low);
  // openings of the storey below part it in piers, wherever their heads are
  const below = d.openings.filter((o) => (storey ? o.y >= storey.foot - 1e-6 : true) && o.y < low && (storey !== undefined || crownOf(o) <= floor.y + 1e-6));
  for (const o of below.sort((a, b) => a.x - b.x)) {
    if (o.x - from > d.half) out.push((from + Math.min(o.x, end)) / 2);
    from = Math.max(from, o.x + o.width);
  }
  if (end - from > d.half) out.push((from + end) / 2);
  return out.length > 1 ? out : [floor.x + d.half / 2, end - d.half / 2];
}
