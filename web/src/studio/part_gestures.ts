// Gestures whose outcome is a text: what the file would say if they ended here. The drawing shows that text while they
// are under way, and their end makes it the file's.
import { setRise } from "./arches";
import { type Drawing, type Selected } from "./drawing";
import type { FieldName, Point } from "./tools";
import type { Snapping } from "./snap";

export interface Offer {
  text: string;
  selection: Selected | null;
  values: Partial<Record<FieldName, number>>; // of the fields that may be typed
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
