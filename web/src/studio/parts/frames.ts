// Steel frames round openings: read from the file, drawn where the engine puts their members, and the edits that a
// command or a choice means.
import type { Box, Drawing } from "../drawing";
import { beforeStages, isDoor } from "./openings";
import { heightOf } from "./profiles";
import { appendTable, countAt, find, parse, quoted, removeAt, setValue, valueAt, type Doc, type Path } from "../file/toml";
import { lengthOf, writeQuantity } from "../file/units";

export interface Frame {
  name: string;
  round: string; // name of its opening, or "" where it has a line of its own
  feet: string;
  column: number; // height of the section in the wall's plane [m]
  beam: number;
  gap: number;
}
export const kGrades = ["S235", "S275", "S355"];
export const kFeet = ["fixed", "hinged", "base_beam", "resting"] as const;

export function readFrames(doc: Doc): Frame[] {
  return Array.from({ length: countAt(doc, ["frame"]) }, (_, k) => {
    const at: Path = ["frame", k];
    const word = (key: string): string => String(valueAt(doc, [...at, key]) ?? "");
    const height = (profile: string, section: string): number | null => heightOf(word(profile)) ?? lengthOf(valueAt(doc, [...at, section, "height"]));
    const column = height("profile", "section") ?? 0.1;
    return { name: word("name") || String(k + 1), round: word("round"), feet: word("feet"), column, beam: height("beam_profile", "beam_section") ?? column, gap: lengthOf(valueAt(doc, [...at, "gap"])) ?? 0 };
  });
}
// The frame round an opening, or -1.
export function frameOf(d: Drawing, k: number): number {
  const o = d.openings[k];
  return o ? d.frames.findIndex((f) => f.round !== "" && f.round === o.name && d.openings.findIndex((other) => other.name === f.round) === k) : -1;
}
// Its members, as seen: columns, the beam under the head, perhaps one on the ground.
export function membersOf(frame: Frame, box: Box): Box[] {
  const { column, beam, gap } = frame;
  const x0 = box.x + gap,
    x1 = box.x + box.width - gap,
    top = box.y + box.height - gap;
  const foot = frame.feet === "base_beam" ? box.y + beam : box.y;
  const upright = (x: number): Box => ({ x, y: foot, width: column, height: top - beam - foot });
  const level = (y: number): Box => ({ x: x0, y, width: x1 - x0, height: beam });
  return [upright(x0), upright(x1 - column), level(top - beam), ...(frame.feet === "base_beam" ? [level(box.y)] : [])];
}

// --- edits ------------------------------------------------------------------------------------------

// Contact alone, as in docs/howto/frame.md.
const kContact = `[material.steel_contact]           # contact alone: presses and rubs, does not pull
normal_stiffness = "20 GPa/m"
shear_stiffness = "8 GPa/m"
tensile_strength = "0 MPa"
cohesion = "0 MPa"
residual_cohesion = "0 MPa"
friction_angle = "22 deg"
residual_friction_angle = "22 deg"
compressive_strength = "unlimited"
`;

// HEB 120 at the jambs and under the head; round a window with a beam below too.
export function addFrame(text: string, d: Drawing, k: number, word: string): string {
  const o = d.openings[k];
  const taken = new Set(d.frames.map((f) => f.name));
  let n = 1;
  while (taken.has(`${word} ${n}`)) ++n;
  let out = text;
  if (valueAt(parse(out), ["wall", "opening", k, "name"]) === undefined) out = setValue(out, ["wall", "opening", k, "name"], quoted(o.name));
  const onGround = isDoor(o) && o.foot < 1e-9;
  out = appendTable(
    out, ["frame"],
    [["name", quoted(`${word} ${n}`)], ["round", quoted(o.name)], ["feet", quoted(onGround ? "fixed" : "base_beam")], ["profile", quoted("HEB 120")], ["grade", quoted("S275")], ["joint", quoted("steel_contact")]],
    ["wall", "storey", "region", "floor", "diaphragm", "tie", "ring_beam"],
  );
  return find(parse(out), ["material", "steel_contact"]) ? out : beforeStages(out, kContact);
}
export const removeFrame = (text: string, k: number): string => removeAt(text, ["frame", k]);

// A profile of the columns, or of level parts: "" is the columns' own.
export function setProfile(text: string, k: number, key: "profile" | "beam_profile", name: string): string {
  const path: Path = ["frame", k, key];
  if (name !== "") return setValue(text, path, quoted(name));
  return find(parse(text), path) ? removeAt(text, path) : text;
}
// No gap is no key.
export function setGap(text: string, k: number, gap: number): string {
  const path: Path = ["frame", k, "gap"];
  if (gap > 0) return setValue(text, path, quoted(writeQuantity(gap, "mm")));
  return find(parse(text), path) ? removeAt(text, path) : text;
}

// What a frame may have beside, in a table of its own: its keys, and numbers to begin with (docs/howto/frame.md).
export const kExtras = {
  anchors: { keys: ["spacing", "depth", "tension", "shear"], first: '{ spacing = "400 mm", depth = "150 mm", tension = "12 kN", shear = "15 kN" }' },
  wedges: { keys: ["force", "spacing"], first: '{ force = "80 kN", spacing = "400 mm" }' },
};
export type Extra = keyof typeof kExtras;
export const addExtra = (text: string, k: number, extra: Extra): string => setValue(text, ["frame", k, extra], kExtras[extra].first);
export const removeExtra = (text: string, k: number, extra: Extra): string => removeAt(text, ["frame", k, extra]);
// Wedges are driven in by the stage that puts the frame up: it needs one.
export function isPutUp(doc: Doc, k: number): boolean {
  const round = valueAt(doc, ["frame", k, "round"]);
  const cuts = Array.from({ length: countAt(doc, ["wall", "opening"]) }, (_, o): Path => ["wall", "opening", o]).some((o) => valueAt(doc, [...o, "name"]) === round && find(doc, [...o, "cut"]));
  return find(doc, ["frame", k, "stage"]) !== undefined || cuts;
}

// An opening's name, also where its frame says it.
export function renameOpening(text: string, d: Drawing, k: number, name: string): string {
  const out = setValue(text, ["wall", "opening", k, "name"], quoted(name));
  const frame = frameOf(d, k);
  return frame < 0 ? out : setValue(out, ["frame", frame, "round"], quoted(name));
}
