// Where a line that is being drawn comes to lie: on what stands nearby (ends of the wall, edges and axes of
// other openings), else on the masonry's own lines (half units, courses). Objects win over the grid.
import { coursesAt, type Box, type Drawing } from "../drawing";

export interface Snapping {
  masonry: boolean;
  objects: boolean;
}
// A line that the drawing shows because something lies on it.
export interface Guide {
  axis: "x" | "y";
  at: number;
  from: number; // of what it is aligned with, along the other axis
  to: number;
}
interface Target {
  at: number;
  from: number;
  to: number;
}

export function targetsX(d: Drawing, self: number): Target[] {
  const out: Target[] = [0, d.length / 2, d.length].map((at) => ({ at, from: 0, to: d.height }));
  d.openings.forEach((o, k) => {
    if (k !== self) for (const at of [o.x, o.x + o.width / 2, o.x + o.width]) out.push({ at, from: o.y, to: o.y + o.height });
  });
  return out;
}
export function targetsY(d: Drawing, self: number): Target[] {
  const out: Target[] = [0, d.height, ...d.storeys.map((s) => s.foot)].map((at) => ({ at, from: 0, to: d.length }));
  d.openings.forEach((o, k) => {
    if (k !== self) for (const at of [o.y, o.y + o.height]) out.push({ at, from: o.x, to: o.x + o.width });
  });
  return out;
}

// Lines of the masonry: every `step` from `foot` on.
interface Grid {
  foot: number;
  step: number;
}
const gridX = (d: Drawing): Grid => ({ foot: 0, step: d.half });
const gridY = (d: Drawing, y: number): Grid => {
  const { foot, course } = coursesAt(d, y);
  return { foot, step: course };
};

// The shift that brings one of `points` onto a target within `reach`, or onto the grid; and the target.
export function shiftFor(points: number[], targets: Target[], grid: Grid, reach: number, how: Snapping): { shift: number; target?: Target } {
  let best: { shift: number; target?: Target } | null = null;
  if (how.objects)
    for (const target of targets)
      for (const point of points) {
        const shift = target.at - point;
        if (Math.abs(shift) <= reach && (!best || Math.abs(shift) < Math.abs(best.shift) - 1e-9)) best = { shift, target };
      }
  if (best) return best;
  const rounded = grid.foot + Math.round((points[0] - grid.foot) / grid.step) * grid.step - points[0];
  return { shift: how.masonry ? rounded : Math.round(points[0] * 100) / 100 - points[0] };
}

// A box moved as a whole.
export function snapMove(d: Drawing, self: number, box: Box, reach: number, how: Snapping): { box: Box; guides: Guide[] } {
  const x = shiftFor([box.x, box.x + box.width, box.x + box.width / 2], targetsX(d, self), gridX(d), reach, how);
  const y = shiftFor([box.y, box.y + box.height], targetsY(d, self), gridY(d, box.y), reach, how);
  const moved = { ...box, x: box.x + x.shift, y: box.y + y.shift };
  const guides: Guide[] = [];
  const near = (a: number, b: number): boolean => Math.abs(a - b) < 1e-6;
  if (x.target)
    for (const at of [moved.x, moved.x + moved.width, moved.x + moved.width / 2])
      if (near(at, x.target.at)) guides.push({ axis: "x", ...x.target, at });
  if (y.target && y.target.at > 0) for (const at of [moved.y, moved.y + moved.height]) if (near(at, y.target.at)) guides.push({ axis: "y", ...y.target, at });
  return { box: moved, guides };
}

// One line: an edge that is dragged, a corner of what is drawn.
export function snapLine(d: Drawing, axis: "x" | "y", value: number, self: number, reach: number, how: Snapping): { at: number; guides: Guide[] } {
  const targets = axis === "x" ? targetsX(d, self) : targetsY(d, self);
  const { shift, target } = shiftFor([value], targets, axis === "x" ? gridX(d) : gridY(d, value), reach, how);
  return { at: value + shift, guides: target ? [{ axis, ...target, at: value + shift }] : [] };
}
