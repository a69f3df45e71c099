// Arches over openings: read from the file, drawn as the engine lays them (src/geometry/wall/arches.h), and the edits
// that make one in the place of a lintel.
import { storeyAt, type Box, type Drawing, type Opening } from "../drawing";
import { addLintel, gaps, removeLintel } from "./openings";
import { find, parse, quoted, removeAt, setValue, valueAt, type Doc, type Path } from "../file/toml";
import { lengthOf, setLength, writeQuantity } from "../file/units";

export const kArchKinds = ["flat", "segmental", "round"] as const;
export type ArchKind = (typeof kArchKinds)[number];
export interface Arch {
  kind: ArchKind;
  rise: number; // of a segmental one, above the springing [m]
  depth: number; // of the voussoirs [m]
  voussoirs: number; // 0: the engine counts
}
// What stands over an opening, as a choice.
export const kHeads = ["none", "lintel", ...kArchKinds] as const;
export type Head = (typeof kHeads)[number];

export function readArch(doc: Doc, at: Path): Arch | null {
  if (find(doc, at) === undefined) return null;
  const kind = valueAt(doc, [...at, "kind"]) as ArchKind;
  const count = valueAt(doc, [...at, "voussoirs"]);
  return {
    kind: kArchKinds.includes(kind) ? kind : "flat",
    rise: lengthOf(valueAt(doc, [...at, "rise"])) ?? 0,
    depth: lengthOf(valueAt(doc, [...at, "depth"])) ?? 0,
    voussoirs: typeof count === "number" && count >= 2 ? Math.min(count, 999) : 0,
  };
}

export const riseOf = (arch: Arch | null, width: number): number =>
  arch === null || arch.kind === "flat" ? 0 : arch.kind === "round" ? width / 2 : Math.min(arch.rise, width / 2);
export const crownOf = (o: Opening, box: Box = o): number => box.y + box.height + riseOf(o.arch, box.width);
export const headOf = (o: Opening): Head => o.arch?.kind ?? (o.lintel ? "lintel" : "none");

// Corners of the voussoirs along the intrados, from the left springing to the right one.
export function intrados(arch: Arch, box: Box, course: number): [number, number][] {
  const half = box.width / 2,
    top = box.y + box.height,
    rise = riseOf(arch, box.width);
  const ends: [number, number][] = [[box.x, top], [box.x + box.width, top]];
  if (rise < 1e-9) return ends;
  const radius = (half * half + rise * rise) / (2 * rise);
  const angle = Math.atan2(half, radius - rise); // between crown and end joint
  const fit = (2 * angle * radius) / course;
  const n = arch.voussoirs || Math.min(999, Math.max(3, 2 * Math.floor(fit / 2) + 1));
  const inner = Array.from({ length: n - 1 }, (_, k): [number, number] => {
    const a = (1 - (2 * (k + 1)) / n) * angle;
    return [box.x + half - radius * Math.sin(a), top + rise - radius + radius * Math.cos(a)];
  });
  return [ends[0], ...inner, ends[1]];
}

// --- edits ------------------------------------------------------------------------------------------

const metres = (v: number): string => quoted(writeQuantity(v, "m", "0.00"));

// Nothing, a lintel or an arch over opening k.
export function setHead(text: string, d: Drawing, k: number, head: Head): string {
  const at: Path = ["wall", "opening", k, "arch"];
  if (head === "none" || head === "lintel") {
    const bare = removeAt(text, at);
    return head === "none" ? removeLintel(bare, k) : d.openings[k].lintel ? bare : addLintel(bare, d, k);
  }
  return setArch(removeLintel(text, k), d, k, head);
}

// Of an arch that is there only what its kind asks for changes. A new one takes up the room there is.
function setArch(text: string, d: Drawing, k: number, kind: ArchKind, rise?: number): string {
  const o = d.openings[k];
  const at: Path = ["wall", "opening", k, "arch"];
  const room = roomAbove(d, k);
  const round2 = (v: number): number => Math.max(0.01, Math.round(100 * v) / 100);
  const wanted = rise ?? round2(Math.min(o.width / 6, room / 2));
  const keys: [string, string | null][] = [
    ["rise", kind === "segmental" ? metres(wanted) : null],
    ["skewback", kind === "flat" ? quoted("15 deg") : null],
  ];
  if (o.arch === null) {
    const unit = 2 * d.half;
    const up = kind === "flat" ? 0 : kind === "round" ? o.width / 2 : wanted;
    const depth = Math.max(d.course, Math.min(unit, Math.floor(100 * (room - up) + 1e-6) / 100));
    const needed = keys.filter(([, literal]) => literal !== null).map(([key, literal]) => `, ${key} = ${literal}`);
    return setValue(text, at, `{ kind = ${quoted(kind)}${needed.join("")}, depth = ${metres(depth)} }`);
  }
  let out = setValue(text, [...at, "kind"], quoted(kind));
  for (const [key, literal] of keys) {
    const has = find(parse(out), [...at, key]) !== undefined;
    if (literal === null && has) out = removeAt(out, [...at, key]);
    else if (literal !== null && !has) out = setValue(out, [...at, key], literal);
    else if (key === "rise" && literal !== null && rise !== undefined) out = setLength(out, [...at, key], wanted);
  }
  return out;
}

// A rise of half the span makes an arch round.
export function setRise(text: string, d: Drawing, k: number, rise: number): string {
  const half = d.openings[k].width / 2;
  if (rise >= half - 1e-6) return setArch(text, d, k, "round");
  return setArch(text, d, k, "segmental", Math.max(0.01, rise));
}

// Free height above the springing, within the storey.
function roomAbove(d: Drawing, k: number): number {
  const o = d.openings[k];
  const storey = storeyAt(d, o.y);
  const top = storey ? storey.foot + storey.height : d.height;
  return Math.max(0, Math.min(gaps(d, o, k).above, top - o.y - o.height));
}
