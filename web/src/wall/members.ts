// Forces of frames, drawn along their members in the present position of the blocks.
//
//        _______         use     colour of each segment, the larger of its two sections
//      |\       /|       M       ordinates on the tension side
//     |__|-----|__|      N, V    positive on the left of the member's direction: outside a frame round an opening
//
// Ordinates are at the sections, as in frames.csv, with straight lines between. Their scale
// is that of the frame's largest value of all states, so that a diagram grows with the push.
import { append, svg } from "../base/dom";
import { fixed, qty } from "../base/texts";
import { bodyCss, stepOf, type BlockPose, type Blocks, type Carried, type FramedStates, type MemberSection } from "./wall";
import type { Canvas } from "./wall2d";

export const kUseSteps = [0.1, 0.25, 0.5, 0.75, 0.9, 1];
// The unit of the page, and its value in the unit of the data.
export const kUnitOf: Record<Carried, [string, number]> = {
  moment: ["kNm", 1e3],
  shear: ["kN", 1e3],
  normal: ["kN", 1e3],
  use: ["", 1],
};

type Place = [number, number];
export interface Station {
  index: number; // of the section
  at: Place; // on the axis [px]
  tip: Place; // of the ordinate [px]
  side: Place; // unit vector towards the ordinate; on the axis, towards a positive one [px]
  value: number; // in the unit of the page
}

const kFrameRole = "frame";
export const isFrameBlock = (wall: Blocks, b: number): boolean => wall.role[b] === kFrameRole;
type Numbered = ArrayLike<number>;

// Sections of each member of a frame, in the member's direction.
export const alongMembers = (wall: Blocks, frame: string): MemberSection[][] =>
  wall.members
    .map((member, m) =>
      member.frame === frame ? wall.sections.filter((s) => s.member === m).sort((s, t) => s.place - t.place) : [],
    )
    .filter((sections) => sections.length > 0);

// The largest absolute value in a frame over all states, in the unit of the page.
export function largestCarried(frames: FramedStates, frame: string, what: Carried): number {
  const mine = alongMembers(frames.wall, frame).flatMap((m) => m.map((s) => frames.wall.sections.indexOf(s)));
  let largest = 0;
  for (let f = 0; f < frames.count; ++f) {
    const values = frames.carried(what, f);
    for (const k of mine) largest = Math.max(largest, Math.abs(values[k]));
  }
  return largest / kUnitOf[what][1];
}

// Positions of a member's sections and ends of their ordinates; `long`: pixels for one unit of the page.
export function stationsOf(
  sections: MemberSection[],
  values: Numbered,
  what: Carried,
  pose: BlockPose,
  canvas: Canvas,
  long: number,
): Station[] {
  const { wall } = pose;
  return sections.map((section) => {
    const { b, arm } = section,
      [wx, wy] = wall.members[section.member].way,
      index = wall.sections.indexOf(section),
      value = values[index] / kUnitOf[what][1];
    const turn = (x: number, y: number): Place => [pose.c[b] * x - pose.s[b] * y, pose.s[b] * x + pose.c[b] * y];
    const [ax, ay] = turn(...arm),
      [lx, ly] = turn(-wy, wx); // left of the direction
    const at: Place = [canvas.X(pose.x[b] + ax), canvas.Y(pose.y[b] + ay)];
    const positive = what === "moment" ? -1 : 1,
      sign = positive * (value < 0 ? -1 : 1);
    const side: Place = [sign * lx, -sign * ly],
      size = Math.abs(value) * long;
    return { index, at, tip: [at[0] + size * side[0], at[1] + size * side[1]], side, value };
  });
}

// --- ordinates -------------------------------------------------------------------------------------------

const point = ([x, y]: Place): string => `${x.toFixed(1)} ${y.toFixed(1)}`;
const between = (a: Place, b: Place, share: number): Place => [a[0] + share * (b[0] - a[0]), a[1] + share * (b[1] - a[1])];

// The areas between neighbouring ordinates by sign: [positive values, negative values].
function fieldsOf(stations: Station[]): [string, string] {
  const paths: [string, string] = ["", ""];
  const add = (value: number, corners: Place[]): void => {
    paths[value < 0 ? 1 : 0] += `M${corners.map(point).join("L")}Z`;
  };
  for (let k = 0; k + 1 < stations.length; ++k) {
    const s = stations[k],
      t = stations[k + 1];
    if (s.value * t.value >= 0) {
      add(s.value + t.value, [s.at, s.tip, t.tip, t.at]);
      continue;
    }
    const zero = between(s.at, t.at, s.value / (s.value - t.value));
    add(s.value, [s.at, s.tip, zero]);
    add(t.value, [t.at, t.tip, zero]);
  }
  return paths;
}

function drawOrdinates(stations: Station[], what: Carried): SVGElement[] {
  const line = `M${stations.map((s) => point(s.tip)).join("L")}`,
    hatch = stations.map((s) => `M${point(s.at)}L${point(s.tip)}`).join("");
  return [
    ...fieldsOf(stations).flatMap((d, i) => (d ? [svg("path", { class: `ordinate ${what} ${i === 0 ? "plus" : "minus"}`, d })] : [])),
    svg("path", { class: `ordinate-hatch ${what}`, d: hatch }),
    svg("path", { class: `ordinate-line ${what}`, d: line, "data-values": stations.map((s) => s.value.toPrecision(6)).join(" ") }),
    svg("path", { class: "member-axis", d: `M${stations.map((s) => point(s.at)).join("L")}` }),
  ];
}

// --- numbers -----------------------------------------------------------------------------------------------

interface Box {
  x0: number;
  x1: number;
  y0: number;
  y1: number;
}
const kLetter = 6.7, // of a label [px]
  kLine = 14,
  kShown = 0.08, // of the state's largest value; smaller ones get no number
  kSame = 0.03; // relative difference of equal values at a corner

const overlaps = (a: Box, b: Box): boolean => a.x0 < b.x1 && b.x0 < a.x1 && a.y0 < b.y1 && b.y0 < a.y1;

// The values to label: ends and extremes of each member, the largest first. Equal
// values at a corner are labelled once. `use` only has the largest of each member.
function numbered(members: Station[][], what: Carried): Station[] {
  const wanted = members.flatMap((stations) => {
    const by = [...stations].sort((s, t) => s.value - t.value),
      most = by[by.length - 1];
    return what === "use" ? [most] : [...new Set([by[0], most, stations[0], stations[stations.length - 1]])];
  });
  const size = (s: Station): number => Math.abs(s.value);
  const least = kShown * Math.max(...wanted.map(size));
  const kept: Station[] = [];
  for (const s of wanted.filter((w) => size(w) > 0 && size(w) >= least).sort((a, b) => size(b) - size(a))) {
    const twin = kept.some(
      (k) => Math.hypot(k.at[0] - s.at[0], k.at[1] - s.at[1]) < 4 && Math.abs(size(k) - size(s)) <= kSame * size(k),
    );
    // a constant value along a member is labelled once
    const level = kept.some(
      (k) => members.some((m) => m.includes(k) && m.includes(s)) && Math.abs(k.value - s.value) <= kSame * size(k),
    );
    if (!twin && !level) kept.push(s);
  }
  return kept;
}

// Points on lines that a label should avoid, a few pixels apart.
function pointsOn(lines: Place[][]): Place[] {
  return lines.flatMap((line) =>
    line.slice(1).flatMap((to, k) => {
      const from = line[k],
        n = Math.max(1, Math.ceil(Math.hypot(to[0] - from[0], to[1] - from[1]) / 4));
      return Array.from({ length: n + 1 }, (_, i) => between(from, to, i / n));
    }),
  );
}

// Places a label beside the end of the ordinate, rather outside than inside, away from other labels and, if possible, from lines.
function placeNumber(s: Station, wide: number, taken: Box[], lines: Place[], canvas: Canvas): Box | null {
  const [dx, dy] = s.side;
  let best: Box | null = null,
    least = Infinity;
  for (let turn = 0; turn < 12; ++turn)
    for (const away of [4, 12, 22]) {
      const angle = (turn * Math.PI) / 6,
        [ux, uy] = [Math.cos(angle), Math.sin(angle)];
      const x = s.tip[0] + ux * (away + wide / 2),
        y = s.tip[1] + uy * (away + kLine / 2);
      const box = { x0: x - wide / 2, x1: x + wide / 2, y0: y - kLine / 2, y1: y + kLine / 2 };
      if (box.x0 < 1 || box.x1 > canvas.width - 1 || box.y0 < 1 || box.y1 > canvas.height - 1) continue;
      if (taken.some((t) => overlaps(t, box))) continue;
      const hits = lines.filter(([px, py]) => px > box.x0 && px < box.x1 && py > box.y0 && py < box.y1).length;
      const cost = 3 * hits + 0.5 * away + 8 * (1 - ux * dx - uy * dy);
      if (cost < least) [best, least] = [box, cost];
    }
  return best;
}

function drawNumbers(members: Station[][], what: Carried, pose: BlockPose, canvas: Canvas): SVGElement[] {
  const taken: Box[] = [],
    [unit] = kUnitOf[what],
    { sections } = pose.wall;
  const feet = members.flat().filter((s) => sections[s.index].a < 0);
  const lines = pointsOn([
    ...members.flatMap((m) => [m.map((s) => s.at), m.map((s) => s.tip)]),
    ...feet.map(({ at: [x, y] }): Place[] => [[x - 17, y + 3], [x + 15, y + 3]]),
    ...(what === "use" ? segmentsOf(pose.wall, members).map((b) => cornersOf(pose, b, canvas)) : []),
  ]);
  return numbered(members, what).flatMap((s, k) => {
    const text = what === "use" ? fixed(s.value) : qty(s.value, unit, 3),
      box = placeNumber(s, kLetter * text.length, taken, lines, canvas);
    if (!box) return [];
    taken.push(box);
    return [
      svg(
        "text",
        {
          class: k === 0 ? "halo strong" : "halo",
          x: ((box.x0 + box.x1) / 2).toFixed(1),
          y: (box.y1 - 3).toFixed(1),
          "text-anchor": "middle",
          "data-section": s.index,
        },
        text,
      ),
    ];
  });
}

// --- the drawing ---------------------------------------------------------------------------------------------

// Segments coloured by their use, each between its two sections.
function drawUse(members: Station[][], pose: BlockPose, canvas: Canvas): SVGElement[] {
  const { sections } = pose.wall;
  return segmentsOf(pose.wall, members).map((b) => {
    const mine = members.flat().filter((s) => sections[s.index].a === b || sections[s.index].b === b);
    const use = Math.max(...mine.map((s) => s.value));
    return svg("path", { class: `member-use r${stepOf(use, kUseSteps)}`, d: outlineOf(pose, b, canvas) });
  });
}
function cornersOf(pose: BlockPose, b: number, canvas: Canvas): Place[] {
  const { outlineBegin } = pose.wall;
  return Array.from({ length: outlineBegin[b + 1] - outlineBegin[b] }, (_, i) => {
    const [x, y] = pose.corner(b, outlineBegin[b] + i);
    return [canvas.X(x), canvas.Y(y)];
  });
}
export const outlineOf = (pose: BlockPose, b: number, canvas: Canvas): string =>
  `M${cornersOf(pose, b, canvas).map(point).join("L")}Z`;
// Blocks of members.
const segmentsOf = (wall: Blocks, members: Station[][]): number[] =>
  [...new Set(members.flat().flatMap((s) => [wall.sections[s.index].a, wall.sections[s.index].b]))].filter((b) => b >= 0);

// The foot of a frame on the ground: fixed or hinged.
function drawFoot({ a, hinged }: MemberSection, [x, y]: Place): SVGElement[] {
  if (a >= 0) return [];
  const top = y + (hinged ? 11 : 0);
  const hatch = [-12, -6, 0, 6, 12].map((dx) => `M${(x + dx).toFixed(1)} ${top.toFixed(1)}l-5 6`).join("");
  const line = `M${(x - 15).toFixed(1)} ${top.toFixed(1)}h30`;
  const foot = svg("path", { class: "foot", d: line + hatch });
  if (!hinged) return [foot];
  const legs = `M${(x - 7).toFixed(1)} ${top.toFixed(1)}L${point([x, y])}L${(x + 7).toFixed(1)} ${top.toFixed(1)}`;
  return [foot, svg("path", { class: "foot", d: legs }), svg("circle", { class: "foot-hinge", cx: x.toFixed(1), cy: y.toFixed(1), r: 3 })];
}

// The members of one frame with their forces in a state; `reach`: pixels of the largest ordinate.
export function drawMembers(
  wall: Blocks,
  frames: FramedStates,
  { name, state, what, largest }: { name: string; state: number; what: Carried; largest: number },
  pose: BlockPose,
  canvas: Canvas,
  reach: number,
): SVGElement {
  const values = frames.carried(what, state),
    layer = svg("g", { class: "members", "data-carried": what });
  const long = what === "use" ? 0 : reach / (largest || 1);
  const members = alongMembers(wall, name).map((s) => stationsOf(s, values, what, pose, canvas, long));
  const css = `member ${bodyCss(kFrameRole)}`;
  append(
    layer,
    what === "use"
      ? drawUse(members, pose, canvas)
      : [
          ...segmentsOf(wall, members).map((b) => svg("path", { class: css, d: outlineOf(pose, b, canvas) })),
          ...members.flatMap((stations) => drawOrdinates(stations, what)),
        ],
  );
  append(layer, members.flat().flatMap((s) => drawFoot(wall.sections[s.index], s.at)));
  const use = frames.carried("use", state);
  append(
    layer,
    members
      .flat()
      .filter((s) => use[s.index] >= 0.9995)
      .map((s) => svg("circle", { class: "hinge", cx: s.at[0].toFixed(1), cy: s.at[1].toFixed(1), r: 4 })),
  );
  append(layer, drawNumbers(members, what, pose, canvas));
  return layer;
}
