// Doors and windows with their lintels: edits of the file that a gesture means, and the free lengths beside them.
import { storeyAt, type Box, type Drawing, type Opening } from "../drawing";
import { appendTable, find, parse, quoted, removeAt, setValue, withRemarks, type Path } from "../file/toml";
import { setLength, writeQuantity } from "../file/units";

export const isDoor = (o: Opening): boolean => o.y <= o.foot + 1e-9;

export function setOpening(text: string, k: number, box: Box, foot: number): string {
  const at: Path = ["wall", "opening", k];
  let out = text;
  for (const key of ["x", "y", "width", "height"] as const)
    out = setLength(out, [...at, key], key === "y" ? box.y - foot : box[key]);
  return out;
}

// Free lengths from an opening, or one that is being drawn, to its neighbours or the ends of the wall.
export function gaps(d: Drawing, box: Box, self = -1): { left: number; right: number; below: number; above: number } {
  let left = 0,
    right = d.length,
    below = 0,
    above = d.height;
  const overlap = (a0: number, a1: number, b0: number, b1: number): boolean => a0 < b1 - 1e-9 && b0 < a1 - 1e-9;
  d.openings.forEach((o, k) => {
    if (k === self) return;
    if (overlap(o.y, o.y + o.height, box.y, box.y + box.height)) {
      if (o.x + o.width <= box.x + 1e-9) left = Math.max(left, o.x + o.width);
      if (o.x >= box.x + box.width - 1e-9) right = Math.min(right, o.x);
    }
    if (overlap(o.x, o.x + o.width, box.x, box.x + box.width)) {
      if (o.y + o.height <= box.y + 1e-9) below = Math.max(below, o.y + o.height);
      if (o.y >= box.y + box.height - 1e-9) above = Math.min(above, o.y);
    }
  });
  return { left: box.x - left, right: right - box.x - box.width, below: box.y - below, above: above - box.y - box.height };
}

export function addOpening(text: string, d: Drawing, box: Box, word: string, withLintel = true): string {
  const storey = storeyAt(d, box.y);
  const taken = new Set(d.openings.map((o) => o.name));
  let n = 1;
  while (taken.has(`${word} ${n}`)) ++n;
  const metres = (v: number): string => quoted(writeQuantity(v, "m", "0.00"));
  const pairs: [string, string][] = [["name", quoted(`${word} ${n}`)]];
  if (storey) pairs.push(["storey", quoted(storey.name)]);
  pairs.push(["x", metres(box.x)], ["y", metres(box.y - (storey?.foot ?? 0))], ["width", metres(box.width)], ["height", metres(box.height)]);
  const out = appendTable(text, ["wall", "opening"], pairs);
  return withLintel ? addLintel(out, d, d.openings.length, box) : out;
}

export const removeOpening = (text: string, k: number): string => removeAt(text, ["wall", "opening", k]);

// Softwood, and a face to which mortar does not stick: as in the program's starters.
const kTimber = `[material.timber]
density = "500 kg/m^3"
youngs_modulus = "10 GPa"
shear_modulus = "0.6 GPa"
`;

const kTimberFace = `[material.timber_face]             # mortar does not stick to timber: friction alone
normal_stiffness = "20 GPa/m"
shear_stiffness = "8 GPa/m"
tensile_strength = "0 MPa"
cohesion = "0 MPa"
friction_angle = "30 deg"
residual_friction_angle = "30 deg"
residual_cohesion = "0 MPa"
compressive_strength = "unlimited"
`;

// A timber lintel over opening k, where there is masonry beside it to bear on; its materials come along where the
// file has none.
export function addLintel(text: string, d: Drawing, k: number, box: Box = d.openings[k]): string {
  const room = gaps(d, box, k);
  const halves = Math.min(2, Math.floor((Math.min(room.left, room.right) + 1e-6) / d.half));
  if (halves < 1) return text;
  const courses = Math.max(1, Math.round(0.15 / d.course));
  const mm = (v: number): string => quoted(writeQuantity(v, "mm"));
  const lintel = `{ kind = "timber", depth = ${mm(courses * d.course)}, bearing = ${mm(halves * d.half)}, material = "timber", bond = "timber_face" }`;
  let out = setValue(text, ["wall", "opening", k, "lintel"], lintel);
  for (const [name, lines] of [["timber", kTimber], ["timber_face", kTimberFace]])
    if (!find(parse(out), ["material", name])) out = beforeStages(out, lines);
  return out;
}

export const removeLintel = (text: string, k: number): string => removeAt(text, ["wall", "opening", k, "lintel"]);

// Materials stand before what is done to the wall, with the remarks that belong to the stages below them.
export function beforeStages(text: string, lines: string): string {
  const first = parse(text).sections.find((s) => s.path[0] === "stage");
  if (!first) return `${text.trimEnd()}\n\n${lines}`;
  const at = withRemarks(text, first.start);
  return `${text.slice(0, at)}${lines}\n${text.slice(at)}`;
}
