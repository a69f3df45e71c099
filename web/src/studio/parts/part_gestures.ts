// Gestures whose outcome is a text: what the file would say if they ended here. The drawing shows that text while they
// are under way, and their end makes it the file's.
import { say } from "../../base/texts";
import { setRise } from "./arches";
import { coursesAt, type Drawing, type Selected } from "../drawing";
import { snapLine, type Guide, type Snapping } from "../board/snap";
import { addFloor, moveFloor } from "./floors";
import { addStorey, cutBy, moveStoreyLine } from "./storeys";
import { addTie, setTieEnds } from "./ties";
import type { FieldName, Point } from "../board/tools";

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
  drawn?: boolean; // the button is held since the start
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
    const out = addStorey(text, d, y, storeyName);
    if (out === null) return { text, selection: null, values: { level: y }, guides, hinder: say("studio.hinder.file") };
    return { text: out, selection, values: { level: y }, guides };
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

// --- floors -------------------------------------------------------------------------------------------

// Floors lie on bed joints; those on a storey's top say its name.
function floorLevel({ now, typed, how, reach }: Place, d: Drawing, from: number): { y: number; guides: Guide[] } {
  const line = snapLine(d, "y", Math.min(d.height, Math.max(0, from + now.y)), -1, reach, how);
  const y = typed("level");
  return y === null ? { y: line.at, guides: line.guides } : { y, guides: [] };
}
const floorHindrance = (d: Drawing, y: number): string | undefined => (y < 1e-6 || y > d.height + 1e-6 ? say("studio.hinder.outside") : undefined);

export const placeFloor = (text: string, d: Drawing): PartGesture => ({
  fields: ["level"],
  at: (place) => {
    const { y, guides } = floorLevel(place, d, 0);
    return { text: addFloor(text, d, y, say("studio.a.floor")), selection: { kind: "floor", k: d.floors.length }, values: { level: y }, guides, hinder: floorHindrance(d, y) };
  },
});
export const dragFloor = (text: string, d: Drawing, k: number): PartGesture => ({
  fields: ["level"],
  at: (place) => {
    const { y, guides } = floorLevel(place, d, d.floors[k].y - place.start.y);
    return { text: moveFloor(text, d, k, y), selection: { kind: "floor", k }, values: { level: y }, guides, hinder: floorHindrance(d, y) };
  },
});

// --- ties ---------------------------------------------------------------------------------------------

// Anchors lie in the middle of a course and beside the head joints.
function anchor(d: Drawing, at: Point, how: Snapping): Point {
  const { foot, course } = coursesAt(d, at.y);
  const middle = (v: number, from: number, step: number): number => from + (Math.floor((v - from) / step) + 0.5) * step;
  const inside = { x: Math.min(d.length - 1e-3, Math.max(1e-3, at.x)), y: Math.min(d.height - 1e-3, Math.max(1e-3, at.y)) };
  if (!how.masonry) return { x: cm(inside.x), y: cm(inside.y) };
  return { x: Math.min(middle(inside.x, 0, d.half), d.length - d.half / 4), y: Math.min(middle(inside.y, foot, course), d.height - course / 4) };
}
function tieHindrance(d: Drawing, from: Point, to: Point): string | undefined {
  if (Math.abs(to.x - from.x) + Math.abs(to.y - from.y) < d.half / 2) return say("studio.hinder.short");
  for (const p of [from, to]) {
    if (p.x < 0 || p.x > d.length || p.y < 0 || p.y > d.height) return say("studio.hinder.outside");
    const hole = d.openings.find((o) => p.x > o.x && p.x < o.x + o.width && p.y > o.y && p.y < o.y + o.height);
    if (hole) return say("studio.hinder.hole", { name: hole.name });
  }
  return undefined;
}
// A click: from end to end of the wall, at this height. Drawn: from here to there, level.
export const placeTie = (text: string, d: Drawing): PartGesture => ({
  fields: ["level"],
  at: ({ start, now, typed, how, reach, drawn }) => {
    const level = typed("level");
    const short = drawn && Math.abs(now.x - start.x) > 2 * reach;
    const y = level ?? anchor(d, short ? start : now, how).y;
    const from = { x: short ? anchor(d, start, how).x : d.half / 2, y },
      to = { x: short ? anchor(d, now, how).x : d.length - d.half / 2, y };
    const bad = tieHindrance(d, from, to);
    return { text: addTie(text, d, from, to, say("studio.a.tie")), selection: { kind: "tie", k: d.ties.length }, values: { level: y }, hinder: bad };
  },
});
// The whole tie, or the end that was taken.
export function dragTie(text: string, d: Drawing, k: number, taken: "whole" | "from" | "to"): PartGesture | null {
  const { from, to } = d.ties[k];
  if (!from || !to) return null;
  return {
    fields: taken === "whole" ? ["level"] : ["left", "level"],
    at: ({ start, now, typed, how }) => {
      const by = { x: now.x - start.x, y: now.y - start.y };
      const level = typed("level"),
        left = typed("left");
      let a = from,
        b = to;
      if (taken === "whole") {
        const wanted = anchor(d, { x: from.x + by.x, y: from.y + by.y }, how);
        const dx = how.masonry ? Math.round(by.x / d.half) * d.half : cm(by.x);
        const dy = level !== null ? level - from.y : by.y === 0 ? 0 : wanted.y - from.y;
        a = { x: from.x + dx, y: from.y + dy };
        b = { x: to.x + dx, y: to.y + dy };
      } else {
        const end = taken === "from" ? from : to,
          other = taken === "from" ? to : from;
        const free = anchor(d, { x: end.x + by.x, y: end.y + by.y }, how);
        // level again where it nearly is
        const y = level ?? (Math.abs(free.y - other.y) < coursesAt(d, other.y).course ? other.y : free.y);
        const moved = { x: left ?? free.x, y };
        if (taken === "from") a = moved;
        else b = moved;
      }
      const shown = taken === "to" ? b : a;
      return { text: setTieEnds(text, k, a, b), selection: { kind: "tie", k }, values: { level: shown.y, left: shown.x }, hinder: tieHindrance(d, a, b) };
    },
  };
}

// --- any part ------------------------------------------------------------------------------------------

// Dragging what was taken at a place, by a pointer that reaches so far [m]; null: it stays where it is.
export function dragPart(text: string, d: Drawing, { kind, k }: Selected, at: Point, reach: number): PartGesture | null {
  if (kind === "storey") return k > 0 ? dragStorey(text, d, k) : null;
  if (kind === "floor") return Number.isFinite(d.floors[k].y) ? dragFloor(text, d, k) : null;
  if (kind !== "tie") return null;
  const { from, to } = d.ties[k];
  const near = (p: Point | null): boolean => p !== null && Math.hypot(p.x - at.x, p.y - at.y) < 2 * reach;
  return dragTie(text, d, k, near(from) ? "from" : near(to) ? "to" : "whole");
}
// A step by the keys.
export function nudgePart(text: string, d: Drawing, part: Selected, by: Point): Offer | null {
  const start = { x: 0, y: 0 };
  const foot = part.kind === "storey" ? d.storeys[part.k].foot : part.kind === "floor" ? d.floors[part.k].y : null;
  const typed = (field: FieldName): number | null => (field === "level" && foot !== null ? foot + by.y : null);
  const gesture = part.kind === "tie" ? dragTie(text, d, part.k, "whole") : dragPart(text, d, part, start, 0);
  return gesture?.at({ start, now: by, typed, how: { masonry: false, objects: false }, reach: 0 }) ?? null;
}
// Without a pointer: where one would most likely put it.
export function placePart(tool: string, text: string, d: Drawing): Offer {
  const gesture = kPlaces[tool](text, d);
  const at = (y: number): Offer => {
    const now = { x: d.length / 2, y };
    return gesture.at({ start: now, now, typed: () => null, how: { masonry: true, objects: false }, reach: 0.01 });
  };
  const tops = d.storeys.map((s) => s.foot + s.height);
  const bare = tops.filter((y) => !d.floors.some((f) => Math.abs(f.y - y) < 0.05)); // storeys without a floor
  const heights = [3, d.height / 2].filter((y) => y < d.height - 1); // a usual storey, else half the wall
  const tries: Record<string, number[]> = {
    storey: [...(d.storeys.length === 0 ? heights : []), d.height + 3],
    floor: [...bare, d.height],
    tie: [...tops.map((y) => y - d.course), d.height - 3 * d.course],
  };
  const offers = tries[tool].map(at);
  return offers.find((offer) => !offer.hinder) ?? offers[0];
}
// Tools that put a part where the pointer is.
export const kPlaces: Record<string, (text: string, d: Drawing) => PartGesture> = { storey: placeStorey, floor: placeFloor, tie: placeTie };
