// The wall as the drawing knows it, read from the model file; and the edits of the file that a gesture means.
// Lengths in metres, y upwards from the wall's base. What is not read here stays in the file as it is.
import { readArch, type Arch } from "./parts/arches";
import { readDiaphragms, readFloors, type Diaphragm, type Floor } from "./parts/floors";
import { readFrames, type Frame } from "./parts/frames";
import { readTies, type Tie } from "./parts/ties";
import { appendTable, countAt, find, parse, quoted, removeAt, setValue, valueAt, withRemarks, type Doc, type Path } from "./file/toml";
import { amountOf, lengthOf, readQuantity, times, writeQuantity } from "./file/units";

export interface Box {
  x: number;
  y: number;
  width: number;
  height: number;
}
export interface Opening extends Box {
  name: string;
  foot: number; // of its storey, from where the file counts its y
  lintel: boolean;
  arch: Arch | null;
}
export interface Storey {
  name: string;
  foot: number;
  height: number;
}
// Courses of equal height, from a storey's foot to its top.
export interface Courses {
  foot: number;
  top: number;
  course: number;
}
export interface Drawing {
  length: number;
  height: number;
  openings: Opening[];
  storeys: Storey[];
  floors: Floor[];
  diaphragms: Diaphragm[];
  ties: Tie[];
  frames: Frame[];
  courses: Courses[]; // of each storey, or of the whole wall
  course: number; // height of one, joint included
  half: number; // half a unit's length, joint included
}
// What may be selected, by its place in the file's list.
export type Kind = "opening" | "storey" | "floor" | "tie";
export interface Selected {
  kind: Kind;
  k: number;
}
const kLists = { opening: "openings", storey: "storeys", floor: "floors", tie: "ties" } as const;
export const countOf = (d: Drawing, kind: Kind): number => d[kLists[kind]].length;

// Where it stands in the file.
export const pathOf = (part: Selected): Path => (part.kind === "opening" ? ["wall", "opening", part.k] : [part.kind, part.k]);

// Why the drawing cannot show a file: a text's key, and where in the file.
export interface Refusal {
  why: string;
  path: Path;
}

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
export const isDoor = (o: Opening): boolean => o.y <= o.foot + 1e-9;

// --- edits: text in, text out -----------------------------------------------------------------------

// A length in the unit and with the decimals that stand there already.
export function setLength(text: string, path: Path, value: number): string {
  const old = valueAt(parse(text), path);
  const unit = readQuantity(old)?.unit ?? "m";
  if (lengthOf(old) !== null && Math.abs(lengthOf(old)! - value) < 5e-5) return text;
  return setValue(text, path, quoted(writeQuantity(value, unit, typeof old === "string" ? old : "0.00")));
}

export function setOpening(text: string, k: number, box: Box, foot: number): string {
  const at: Path = ["wall", "opening", k];
  let out = text;
  for (const key of ["x", "y", "width", "height"] as const)
    out = setLength(out, [...at, key], key === "y" ? box.y - foot : box[key]);
  return out;
}

// The storey that holds a height: the last whose foot is not above it.
export const storeyAt = (d: Drawing, y: number): Storey | undefined => d.storeys.filter((s) => s.foot <= y + 1e-6).pop();

export const coursesAt = (d: Drawing, y: number): Courses => d.courses.filter((c) => c.foot <= y + 1e-6).pop() ?? d.courses[0];

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

// --- what is done to the wall ----------------------------------------------------------------------------

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
