// Gestures whose outcome is a text: what the file would say if they ended here. The drawing shows that text while they
// are under way, and their end makes it the file's.
import { say } from "../texts";
import { setRise } from "./arches";
import { coursesAt, type Drawing, type Selected } from "./drawing";
import { snapLine, type Guide, type Snapping } from "./snap";
import { addStorey, cutBy, moveStoreyLine } from "./storeys";
import type { FieldName, Point } from "./tools";

export interface Offer {
  text: string;
  selection: Selected | null;
  values: Partial<Record<FieldName, number>>; // of the fields that may be typed
  guides?: Guide[];
  hinder?: string; // why it cannot be, in words
}
export interface Place {
  start: Point;
  now: Point;
  typed: (field: FieldName) => number | null;
  how: Snapping;
  reach: number; // of snapping [m]
}
export interface PartGesture {
  fields: FieldName[];
  at(place: Place): Offer;
}

const cm = (v: number): number => Math.round(100 * v) / 100;

// The crown of an arch, up and down. At half the span the arch is round.
export function dragCrown(text: string, d: Drawing, k: number): PartGesture {
  const o = d.openings[k];
  const half = o.width / 2;
  return {
    fields: ["rise"],
    at: ({ now, typed, how, reach }) => {
      const free = now.y - o.y - o.height;
      const rise = typed("rise") ?? (how.objects && Math.abs(free - half) < reach ? half : how.masonry ? cm(free) : Math.round(1000 * free) / 1000);
      const held = Math.min(half, Math.max(0.01, rise));
      return { text: setRise(text, d, k, held), selection: { kind: "opening", k }, values: { rise: held } };
    },
  };
}

// --- storeys ------------------------------------------------------------------------------------------

const kFewest = 2; // courses between two lines
const kNames = ["ground", "first", "second", "third"];
const storeyName = (n: number): string => (n < kNames.length ? say(`studio.storey.${kNames[n]}`) : say("studio.storey.number", { n }));

// Why no line can lie there.
function hindrance(d: Drawing, y: number, lines: number[]): string | undefined {
  if (lines.some((at) => Math.abs(at - y) < kFewest * coursesAt(d, y).course - 1e-6)) return say("studio.hinder.near");
  const cut = cutBy(d, y);
  return cut === null ? undefined : say("studio.hinder.cut", { name: cut });
}
export const placeStorey = (text: string, d: Drawing): PartGesture => ({
  fields: ["level"],
  at: ({ now, typed, how, reach }) => {
    const line = snapLine(d, "y", Math.max(0, now.y), -1, reach, how);
    const y = typed("level") ?? line.at;
    const hinder = hindrance(d, y, [0, d.height, ...d.storeys.map((s) => s.foot)]);
    const k = d.storeys.filter((s) => s.foot + s.height <= y + 1e-6).length + 1;
    const selection: Selected = { kind: "storey", k: d.storeys.length === 0 ? 1 : Math.min(k, d.storeys.length) };
    const guides: Guide[] = typed("level") === null ? line.guides : [];
    if (hinder) return { text, selection: null, values: { level: y }, guides: [{ axis: "y", at: y, from: 0, to: d.length }], hinder };
    return { text: addStorey(text, d, y, storeyName), selection, values: { level: y }, guides };
  },
});
export const dragStorey = (text: string, d: Drawing, k: number): PartGesture => ({
  fields: ["level"],
  at: ({ start, now, typed, how, reach }) => {
    const foot = d.storeys[k].foot;
    const line = snapLine(d, "y", foot + now.y - start.y, -1, reach, how);
    const y = typed("level") ?? line.at;
    const selection: Selected = { kind: "storey", k };
    const others = [0, d.height, ...d.storeys.filter((_, i) => i !== k).map((s) => s.foot)];
    const beyond = y <= d.storeys[k - 1].foot || y >= foot + d.storeys[k].height;
    const hinder = beyond ? say("studio.hinder.beyond") : hindrance({ ...d, openings: d.openings.filter((o) => o.foot < foot) }, y, others);
    if (hinder) return { text, selection, values: { level: y }, guides: [{ axis: "y", at: y, from: 0, to: d.length }], hinder };
    return { text: moveStoreyLine(text, d, k, y), selection, values: { level: y } };
  },
});

// --- any part ------------------------------------------------------------------------------------------

// Dragging what was taken at a place; null: it stays where it is.
export function dragPart(text: string, d: Drawing, part: Selected, _at: Point): PartGesture | null {
  if (part.kind === "storey" && part.k > 0) return dragStorey(text, d, part.k);
  return null;
}
// A step by the keys.
export function nudgePart(text: string, d: Drawing, part: Selected, by: Point): Offer | null {
  const start = { x: 0, y: 0 };
  const level = part.kind === "storey" ? d.storeys[part.k].foot + by.y : 0;
  const typed = (field: FieldName): number | null => (field === "level" ? level : null);
  return dragPart(text, d, part, start)?.at({ start, now: by, typed, how: { masonry: false, objects: false }, reach: 0 }) ?? null;
}
// Without a pointer: where one would most likely put it.
export function placePart(_tool: string, text: string, d: Drawing): Offer {
  const at = (gesture: PartGesture, x: number, y: number): Offer => gesture.at({ start: { x, y }, now: { x, y }, typed: () => null, how: { masonry: true, objects: false }, reach: 0 });
  const heights = [3, d.height / 2].filter((y) => y < d.height - 1); // a usual storey, else half the wall
  const tries = [...(d.storeys.length === 0 ? heights : []), d.height + 3].map((y) => at(placeStorey(text, d), d.length / 2, y));
  return tries.find((offer) => !offer.hinder) ?? tries[0];
}
