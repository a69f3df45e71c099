// Ties: steel bars between two points of the wall. Only those between two points are drawn.
import type { Drawing } from "../drawing";
import type { Point } from "../board/tools";
import { appendTable, countAt, find, parse, quoted, removeAt, setValue, valueAt, type Doc, type Path } from "../file/toml";
import { amountOf, lengthOf, setLength, writeQuantity } from "../file/units";

export interface Tie {
  name: string;
  from: Point | null; // null: a block, a box or the beam
  to: Point | null;
  // null: the file says one that is not read here
  area: number | null; // [m^2]
  prestress: number | null; // [Pa]
  yields: number | null; // at this stress [Pa]; Infinity where the file says none
}

function pointOf(doc: Doc, at: Path): Point | null {
  if (["block", "beam", "width", "height"].some((key) => find(doc, [...at, key]))) return null;
  const x = lengthOf(valueAt(doc, [...at, "x"])),
    y = lengthOf(valueAt(doc, [...at, "y"]));
  return x === null || y === null ? null : { x, y };
}
export function readTies(doc: Doc): Tie[] {
  return Array.from({ length: countAt(doc, ["tie"]) }, (_, k) => {
    const at: Path = ["tie", k];
    const value = (key: string, base: string, missing: number): number | null => (find(doc, [...at, key]) ? amountOf(valueAt(doc, [...at, key]), base) : missing);
    return {
      name: String(valueAt(doc, [...at, "name"]) ?? `tie ${k + 1}`),
      from: pointOf(doc, [...at, "from"]),
      to: pointOf(doc, [...at, "to"]),
      area: value("area", "m^2", 0),
      prestress: value("prestress", "Pa", 0),
      yields: value("yield_strength", "Pa", Infinity),
    };
  });
}

// --- edits ------------------------------------------------------------------------------------------

const metres = (v: number): string => quoted(writeQuantity(v, "m", "0.00"));
const point = (p: Point): string => `{ x = ${metres(p.x)}, y = ${metres(p.y)} }`;

// One bar of 20 mm.
export function addTie(text: string, d: Drawing, from: Point, to: Point, word: string): string {
  const taken = new Set(d.ties.map((t) => t.name));
  let n = 1;
  while (taken.has(`${word} ${n}`)) ++n;
  const [a, b] = from.x <= to.x ? [from, to] : [to, from];
  const pairs: [string, string][] = [
    ["name", quoted(`${word} ${n}`)], ["from", point(a)], ["to", point(b)],
    ["area", quoted("314 mm^2")], ["youngs_modulus", quoted("200 GPa")], ["yield_strength", quoted("235 MPa")], ["anchor_strength", quoted("50 kN")],
  ];
  return appendTable(text, ["tie"], pairs, ["wall", "storey", "region", "floor", "diaphragm"]);
}
export function setTieEnds(text: string, k: number, from: Point, to: Point): string {
  let out = text;
  for (const [end, p] of [["from", from], ["to", to]] as const)
    for (const axis of ["x", "y"] as const) out = setLength(out, ["tie", k, end, axis], p[axis]);
  return out;
}
// The force that is drawn in, as the stress that the file has.
export function setTieForce(text: string, tie: Tie, k: number, force: number): string | null {
  const path: Path = ["tie", k, "prestress"];
  if (force < 0 || tie.area === null || tie.area <= 0) return null;
  if (force === 0) return find(parse(text), path) ? removeAt(text, path) : text;
  return setValue(text, path, quoted(writeQuantity(Math.round(force / tie.area / 1e4) * 1e4, "MPa")));
}
export const forceOf = ({ prestress, area }: Tie): number | null => (prestress === null || area === null ? null : prestress * area);
export const removeTie = (text: string, k: number): string => removeAt(text, ["tie", k]);
