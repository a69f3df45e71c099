// Reads the wall from the model file. What is not read here stays in the file as it is.
import type { Courses, Drawing, Opening, Refusal, Storey } from "./drawing";
import { countAt, find, valueAt, type Doc, type Path } from "./file/toml";
import { lengthOf } from "./file/units";
import { readArch } from "./parts/arches";
import { readDiaphragms, readFloors } from "./parts/floors";
import { readFrames } from "./parts/frames";
import { readTies } from "./parts/ties";

const kElsewhere = ["plan_wall", "slab", "arch", "dome"]; // walls in space

export function readDrawing(doc: Doc): Drawing | Refusal {
  for (const name of kElsewhere) if (doc.root.keys.has(name)) return { why: "space", path: [name] };
  if (find(doc, ["wall", "blocks"])) return { why: "blocks", path: ["wall", "blocks"] };
  const metres = (...path: Path): number | null => lengthOf(valueAt(doc, path));
  const storeys: Storey[] = [];
  let top = 0;
  for (let k = 0; k < countAt(doc, ["storey"]); ++k) {
    const height = metres("storey", k, "height");
    if (!height) return { why: "number", path: ["storey", k, "height"] };
    storeys.push({ name: String(valueAt(doc, ["storey", k, "name"]) ?? k), foot: top, height });
    top += height;
  }
  const length = metres("wall", "length");
  if (!length || length <= 0) return { why: "number", path: ["wall", "length"] };
  const height = storeys.length > 0 ? top : metres("wall", "height");
  if (!height || height <= 0) return { why: "number", path: ["wall", "height"] };
  const openings: Opening[] = [];
  for (let k = 0; k < countAt(doc, ["wall", "opening"]); ++k) {
    const at: Path = ["wall", "opening", k];
    const box = { x: 0, y: 0, width: 0, height: 0 };
    for (const key of ["x", "y", "width", "height"] as const) {
      const value = metres(...at, key);
      if (value === null) return { why: "number", path: [...at, key] };
      box[key] = value;
    }
    const name = valueAt(doc, [...at, "storey"]);
    const storey = storeys.find((s) => s.name === name);
    if (name !== undefined && !storey) return { why: "storey", path: [...at, "storey"] };
    const foot = storey?.foot ?? 0;
    openings.push({
      ...box,
      y: box.y + foot,
      foot,
      name: String(valueAt(doc, [...at, "name"]) ?? k),
      lintel: find(doc, [...at, "lintel"]) !== undefined,
      arch: readArch(doc, [...at, "arch"]),
    });
  }
  const mortar = (key: string): number => metres("wall", "unit", "mortar", key) ?? 0;
  const bed = mortar("bed") || mortar("head"),
    head = mortar("head") || mortar("bed");
  const course = Math.max(0.01, (metres("wall", "unit", "height") ?? 0.1) + bed);
  const laid = (foot: number, top: number, own: Path): Courses => {
    const height = metres(...own, "unit", "height");
    const nominal = height === null ? course : Math.max(0.01, height + (metres(...own, "unit", "mortar", "bed") ?? bed));
    const cut = (valueAt(doc, [...own, "fit"]) ?? valueAt(doc, ["wall", "fit"])) === "cut";
    return { foot, top, course: cut ? nominal : (top - foot) / Math.max(1, Math.round((top - foot) / nominal)) };
  };
  return {
    length,
    height,
    openings,
    storeys,
    floors: readFloors(doc, storeys, length),
    diaphragms: readDiaphragms(doc, storeys),
    ties: readTies(doc),
    frames: readFrames(doc),
    courses: storeys.length > 0 ? storeys.map((s, k) => laid(s.foot, s.foot + s.height, ["storey", k])) : [laid(0, height, ["wall"])],
    course,
    half: Math.max(0.01, ((metres("wall", "unit", "length") ?? 0.2) + head) / 2),
  };
}

export const isRefusal = (d: Drawing | Refusal): d is Refusal => "why" in d;
