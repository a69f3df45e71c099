// The wall in its plane, as SVG: ground, blocks by tint, joints by their
// damage, forces, push. Shapes of one style form one path (paths.ts).
import { append, svg } from "../base/dom";
import { Paths, type Painter } from "../base/paths";
import { qty, say } from "../base/texts";
import { ticks } from "../base/plot";
import {
  bodyCss,
  crackOf,
  fieldOf,
  forcesOf,
  isCutOut,
  isField,
  jointStress,
  kSteps,
  Pose,
  stepOf,
  valueOf,
  zoneStress,
  type Frame,
  type Frames,
  type Measure,
  type Part,
  type Wall,
} from "./wall";

export interface Look {
  frame: number;
  scale: number;
  measure: Measure;
  forces: boolean;
  numbers: boolean; // of piers and spandrels
  lit: string; // name of the highlighted part, "": none
  stressSteps: number[]; // bounds of the colours of stress [MPa]
}
// Style of a stress: class t for tension, c for compression.
export const stressCss = (stress: number, steps: number[]): string =>
  `${stress > 0 ? "t" : "c"} r${stepOf(Math.abs(stress), steps)}`;

const kMargin = 34,
  kTints = 4;

// A tint that differs between neighbours and is the same in all pictures.
const tintOf = (b: number): number => ((Math.imul(b, 2654435761) >>> 13) + b) % kTints;

export interface Canvas {
  width: number;
  height: number;
  X: (x: number) => number;
  Y: (y: number) => number;
  k: number;
}

// Space for the wall and for parts that lean out of it in the last frames.
export function canvasFor(wall: Wall, width: number, tallest = 560): Canvas {
  const { x0, x1, y0, y1 } = wall.bounds;
  const reachX = 0.05 * (x1 - x0),
    reachY = 0.03 * (y1 - y0);
  const wide = x1 - x0 + 2 * reachX,
    high = y1 - y0 + reachY;
  const k = Math.min((width - 2 * kMargin) / wide, (tallest - 2 * kMargin) / high);
  const height = Math.round(high * k + 2 * kMargin);
  const left = (width - (x1 - x0) * k) / 2;
  return { width, height, k, X: (x) => left + (x - x0) * k, Y: (y) => height - kMargin - (y - y0) * k };
}

function drawBlocks(wall: Wall, pose: Pose, paths: Paths): void {
  for (let b = 0; b < wall.blocks; ++b) {
    if (isCutOut(wall, b)) continue;
    const points: [number, number][] = [];
    for (let i = wall.outlineBegin[b]; i < wall.outlineBegin[b + 1]; ++i) points.push(pose.corner(b, i));
    paths.polygon(bodyCss(wall.role[b]) || `stone stone${tintOf(b)}`, points);
  }
}

// Blocks coloured by a field.
function drawBlockField(wall: Wall, pose: Pose, look: Look, paths: Paths): void {
  if (!isField(look.measure)) return;
  const { onBlocks, values, steps } = fieldOf(wall, look.measure);
  for (let b = 0; onBlocks && b < values.length; ++b) {
    if (Number.isNaN(values[b])) continue;
    const points: [number, number][] = [];
    for (let i = wall.outlineBegin[b]; i < wall.outlineBegin[b + 1]; ++i) points.push(pose.corner(b, i));
    paths.polygon(`block-field r${stepOf(values[b], steps)}`, points);
  }
}

function drawZones(wall: Wall, pose: Pose, look: Look, paths: Paths): void {
  if (!wall.mesh) return;
  const { zone } = wall.mesh;
  for (let z = 0; z < zone.length; z += 4) {
    const corners = [0, 1, 2, 3].map((k) => pose.node(wall.mesh!, zone[z + k]));
    const stress = zoneStress(pose.frame, z / 4);
    if (look.measure === "stress" && stepOf(Math.abs(stress), look.stressSteps) > 0)
      paths.polygon(`zone-stress ${stressCss(stress, look.stressSteps)}`, corners);
    paths.polygon("zone", corners);
  }
}

function drawGround(wall: Wall, canvas: Canvas, paths: Paths): void {
  for (let s = 0; s + 1 < wall.supportBegin.length; ++s) {
    const points: [number, number][] = [];
    for (let i = wall.supportBegin[s]; i < wall.supportBegin[s + 1]; ++i)
      points.push([wall.supportX[i], wall.supportY[i]]);
    paths.polygon("support", points);
  }
  if (wall.supportBegin.length > 1) return;
  for (let j = wall.pairs; j < (wall.mesh?.joints ?? wall.joints); ++j) {
    const b = wall.jointB[j];
    const cx = wall.centroidX[b] + wall.armBX[j],
      cy = wall.centroidY[b] + wall.armBY[j];
    paths.segment(
      "ground",
      [cx - wall.halfX[j], cy - wall.halfY[j]],
      [cx + wall.halfX[j], cy + wall.halfY[j]],
    );
    const from = Math.min(canvas.X(cx - wall.halfX[j]), canvas.X(cx + wall.halfX[j]));
    const to = Math.max(canvas.X(cx - wall.halfX[j]), canvas.X(cx + wall.halfX[j]));
    const y = canvas.Y(cy);
    for (let x = Math.ceil(from / 9) * 9; x < to; x += 9) paths.raw("hatch", `M${x} ${y.toFixed(1)}l-7 8`);
  }
}

// Whether the blocks of a joint are separated (wall_arrays.cpp).
const gaveWay = (frame: Frame, j: number): boolean => frame.opening[j] < 0;

function drawJoints(wall: Wall, frames: Frames, pose: Pose, look: Look, paths: Paths): void {
  const frame = frames.at(look.frame);
  for (let j = 0; j < wall.joints; ++j) {
    if (gaveWay(frame, j)) continue;
    const ends: [[number, number], [number, number]] = [pose.joint(j, -1), pose.joint(j, 1)];
    const quiet = wall.kind[j] === "split" ? "split" : "mortar";
    if (look.measure === "cracks") {
      const crack = crackOf(frame, j);
      if (crack === "sound") {
        if (wall.kind[j] !== "lintel_chain") paths.segment(quiet, ...ends);
      } else {
        const moved = Math.max(frame.opening[j], Math.abs(frame.slip[j])) * 1e3;
        const wide = crack === "softening" || crack === "closed" ? 0 : stepOf(moved, [0.2, 1, 3, 10]);
        paths.segment(`crack ${crack} w${wide}`, ...ends);
      }
      continue;
    }
    if (look.measure === "stress") {
      const stress = jointStress(wall, frame, j);
      const css = stressCss(stress, look.stressSteps);
      if (!css.endsWith("r0")) paths.segment(`joint stress ${css}`, ...ends);
      else if (wall.kind[j] !== "lintel_chain") paths.segment(quiet, ...ends);
      continue;
    }
    if (isField(look.measure)) {
      const { onBlocks, values, steps } = fieldOf(wall, look.measure);
      const drawn = !onBlocks && !Number.isNaN(values[j] ?? NaN);
      if (drawn) paths.segment(`joint field r${stepOf(values[j], steps)}`, ...ends);
      else if (wall.kind[j] !== "lintel_chain") paths.segment(quiet, ...ends);
      continue;
    }
    const step = stepOf(valueOf(frame, j, look.measure), kSteps[look.measure]);
    if (step === 0 && wall.kind[j] === "lintel_chain") continue;
    paths.segment(step === 0 ? quiet : `joint ${look.measure} r${step}`, ...ends);
  }
}

function drawCrushed(wall: Wall, frames: Frames, pose: Pose, look: Look): SVGElement[] {
  if (look.measure !== "cracks") return [];
  const frame = frames.at(look.frame);
  const marks: SVGElement[] = [];
  for (let j = 0; j < wall.joints; ++j) {
    const crushing = frame.crushing[j] / 255;
    if (crushing < 0.05) continue;
    const side = frame.eccentricity ? Math.sign(frame.eccentricity[j]) : 0;
    const [x, y] = pose.joint(j, 0.9 * side);
    marks.push(
      svg("circle", {
        class: "crushed",
        cx: 0,
        cy: 0,
        r: (2.4 + 2 * crushing).toFixed(1),
        "data-x": x,
        "data-y": y,
      }),
    );
  }
  return marks;
}

// The force of side a on side b in every joint, with a line width by its size.
function drawForces(wall: Wall, pose: Pose, canvas: Canvas): SVGElement[] {
  const bins = 6;
  const paths: string[][] = Array.from({ length: bins }, () => []);
  for (const { from, to, share } of forcesOf(wall, pose.frame, pose))
    paths[Math.min(bins - 1, Math.floor(Math.sqrt(share) * bins))].push(
      `M${canvas.X(from[0]).toFixed(1)} ${canvas.Y(from[1]).toFixed(1)}` +
        `L${canvas.X(to[0]).toFixed(1)} ${canvas.Y(to[1]).toFixed(1)}`,
    );
  return paths
    .map((d, i) =>
      svg("path", {
        class: "thrust",
        "stroke-width": (0.5 + 0.55 * i).toFixed(2),
        d: d.join(""),
        "data-marks": d.length,
      }),
    )
    .filter((p) => p.getAttribute("data-marks") !== "0");
}

// One arrow for each part of the pushed blocks.
function drawArrows(wall: Wall, pose: Pose, canvas: Canvas): (SVGElement | null)[] {
  const { pushed, driven } = wall;
  return pushed.map(({ end, length }, i) =>
    drawArrow(wall, Array.from(driven!.subarray(i ? pushed[i - 1].end : 0, end)), length, pose, canvas),
  );
}

// The arrow ends at the edge of the blocks.
function drawArrow(wall: Wall, driven: number[], length: number, pose: Pose, canvas: Canvas): SVGElement | null {
  if (!wall.push || driven.length === 0) return null;
  let x0 = Infinity,
    x1 = -Infinity,
    y0 = Infinity,
    y1 = -Infinity;
  for (const b of driven) {
    for (let i = wall.outlineBegin[b]; i < wall.outlineBegin[b + 1]; ++i) {
      const [x, y] = pose.corner(b, i);
      x0 = Math.min(x0, x);
      x1 = Math.max(x1, x);
      y0 = Math.min(y0, y);
      y1 = Math.max(y1, y);
    }
  }
  const [dx, dy] = [wall.push[0], -wall.push[1]];
  const tx = canvas.X(dx > 0.5 ? x0 : dx < -0.5 ? x1 : (x0 + x1) / 2) - 3 * dx;
  const ty = canvas.Y(dy < -0.5 ? y0 : dy > 0.5 ? y1 : (y0 + y1) / 2) - 3 * dy;
  const long = 12 + 18 * length;
  return svg("path", {
    class: "arrow",
    d:
      `M${tx - long * dx} ${ty - long * dy}L${tx} ${ty}` +
      `M${tx - 9 * dx - 6 * dy} ${ty - 9 * dy + 6 * dx}L${tx} ${ty}L${tx - 9 * dx + 6 * dy} ${ty - 9 * dy - 6 * dx}`,
  });
}

// Present middle of a part: the mean displacement of its blocks moves it.
function middleOf(part: Part, pose: Pose): [number, number] {
  const { wall, scale, frame } = pose,
    [x0, x1, y0, y1] = part.box;
  let ux = 0,
    uy = 0,
    n = 0;
  for (const b of part.blocks) {
    if (wall.role[b] !== "masonry") continue;
    ux += frame.ux[b];
    uy += frame.uy[b];
    ++n;
  }
  const k = n > 0 ? scale / n : 0;
  return [(x0 + x1) / 2 + k * ux, (y0 + y1) / 2 + k * uy];
}

// Numbers of piers and spandrels, and the highlighted part. They form a
// layer of their own, so that pointing at a table does not redraw the wall.
export function drawParts(wall: Wall, frames: Frames, look: Look, canvas: Canvas): SVGGElement {
  const pose = new Pose(wall, frames.at(look.frame), look.scale);
  const layer = svg("g", { class: "parts" });
  const lit = wall.parts.find((p) => p.name === look.lit);
  if (lit) {
    const d = lit.blocks.map((b) => {
      const corners: string[] = [];
      for (let i = wall.outlineBegin[b]; i < wall.outlineBegin[b + 1]; ++i) {
        const [x, y] = pose.corner(b, i);
        corners.push(`${canvas.X(x).toFixed(1)} ${canvas.Y(y).toFixed(1)}`);
      }
      return `M${corners.join("L")}Z`;
    });
    layer.appendChild(svg("path", { class: "lit", d: d.join(""), "data-part": lit.name }));
  }
  for (const part of wall.parts) {
    const numbered = look.numbers && (part.kind === "pier" || part.kind === "spandrel");
    if (!numbered && part !== lit) continue;
    const [x, y] = middleOf(part, pose);
    layer.appendChild(
      svg(
        "text",
        {
          class: part === lit ? "part lit-mark" : "part",
          x: canvas.X(x).toFixed(1),
          y: (canvas.Y(y) + 5).toFixed(1),
          "text-anchor": "middle",
          "data-mark": part.mark,
        },
        part.mark,
      ),
    );
  }
  return layer;
}

// A cross wall as a coil between the point and a short vertical line for the neighbour; dx, dy in pixels.
function coil(x: number, y: number, dx: number, dy: number): string {
  const at = (along: number, off: number): string =>
    `${(x + along * dx - off * dy).toFixed(1)} ${(y + along * dy + off * dx).toFixed(1)}`;
  const turns = [5, -5, 5, -5, 5].map((off, k) => at(5 * (k + 1), off));
  return `M${at(0, 0)}L${turns.join("L")}L${at(30, 0)}M${at(30, -9)}L${at(30, 9)}`;
}

// Ties, diaphragms and springs, with their forces as tooltips; a slack tie is dashed.
function drawLinks(wall: Wall, pose: Pose, canvas: Canvas): SVGElement[] {
  const force = pose.frame.linkForce;
  return wall.links.map((link, k) => {
    const [[ax, ay], [bx, by]] = pose.link(link).map(([x, y]) => [canvas.X(x), canvas.Y(y)]);
    const d =
      link.kind === "spring"
        ? coil(bx, by, -link.along[0], link.along[1])
        : `M${ax.toFixed(1)} ${ay.toFixed(1)}L${bx.toFixed(1)} ${by.toFixed(1)}`;
    const slack = link.kind === "tie" && force !== null && !(force[k] > 0) ? " slack" : "";
    const ends =
      link.kind === "spring" ? [] : [[ax, ay], [bx, by]].map(([cx, cy]) => svg("circle", { cx, cy, r: 3 }));
    const words = force === null ? link.name : `${link.name}: ${qty(force[k] / 1e3, "kN", 3)}`;
    return svg(
      "g",
      { class: `link ${link.kind}${slack}`, "data-link": link.name },
      svg("title", {}, words),
      svg("path", { d }),
      ...ends,
    );
  });
}

// Tops of storeys, at the wall's right end.
function drawStoreys(wall: Wall, canvas: Canvas): SVGElement[] {
  return wall.storeys.flatMap(({ name, top }) => {
    const x = canvas.X(wall.length),
      y = canvas.Y(top);
    return [
      svg("path", { class: "level", d: `M${x + 2} ${y.toFixed(1)}H${canvas.width - 2}` }),
      svg(
        "text",
        { class: "tick", x: canvas.width - 2, y: (y - 3).toFixed(1), "text-anchor": "end" },
        svg("title", {}, name),
        qty(top, "m", 3),
      ),
    ];
  });
}

function drawScaleBar(canvas: Canvas): SVGElement {
  const metres = ticks([0, (0.25 * canvas.width) / canvas.k], 3)[1];
  const right = canvas.width - 8,
    left = right - metres * canvas.k,
    y = canvas.height - 8;
  return svg(
    "g",
    {},
    svg("path", { class: "scalebar", d: `M${left} ${y - 4}V${y}H${right}V${y - 4}` }),
    svg(
      "text",
      { class: "tick", x: (left + right) / 2, y: y - 6, "text-anchor": "middle" },
      metres >= 1 ? qty(metres, "m") : qty(metres * 1e3, "mm"),
    ),
  );
}

const kOrder = [
  "support",
  "hatch",
  "ground",
  "rest",
  "stone stone0",
  "stone stone1",
  "stone stone2",
  "stone stone3",
  "timber",
  "plate",
  ...[1, 2, 3, 4, 5, 6].map((r) => `block-field r${r}`),
  ...["t", "c"].flatMap((sign) => [1, 2, 3, 4, 5, 6].map((r) => `zone-stress ${sign} r${r}`)),
  "zone",
  "split",
  "mortar",
];

// With a painter, blocks and joints go to its canvas, and the drawing above it only has the rest.
export function drawWall(
  wall: Wall,
  frames: Frames,
  look: Look,
  canvas: Canvas,
  painter?: Painter,
): SVGSVGElement {
  const pose = new Pose(wall, frames.at(look.frame), look.scale);
  const paths = new Paths(canvas.X, canvas.Y);
  drawGround(wall, canvas, paths);
  if (wall.courses > 0) {
    const { X, Y } = canvas;
    paths.raw("rest", `M${X(0)} ${Y(0)}V${Y(wall.height)}H${X(wall.length)}V${Y(0)}`);
  }
  drawBlocks(wall, pose, paths);
  drawBlockField(wall, pose, look, paths);
  drawZones(wall, pose, look, paths);
  drawJoints(wall, frames, pose, look, paths);
  const picture = svg("svg", {
    class: "plot wall",
    viewBox: `0 0 ${canvas.width} ${canvas.height}`,
    width: canvas.width,
    height: canvas.height,
    role: "img",
    "aria-label": say("wall.alt"),
  });
  painter?.clear();
  if (painter) paths.paint(kOrder, painter);
  else append(picture, paths.elements(kOrder));
  for (const mark of drawCrushed(wall, frames, pose, look)) {
    mark.setAttribute("cx", canvas.X(Number(mark.getAttribute("data-x"))).toFixed(1));
    mark.setAttribute("cy", canvas.Y(Number(mark.getAttribute("data-y"))).toFixed(1));
    picture.appendChild(mark);
  }
  if (look.forces) append(picture, drawForces(wall, pose, canvas));
  append(picture, [...drawLinks(wall, pose, canvas), ...drawStoreys(wall, canvas)]);
  append(picture, [...drawArrows(wall, pose, canvas), drawScaleBar(canvas)]);
  picture.appendChild(drawParts(wall, frames, look, canvas));
  return picture;
}

// The zone at a place in the drawing; -1 if there is none.
export function zoneAt(
  wall: Wall,
  frames: Frames,
  look: Look,
  canvas: Canvas,
  px: number,
  py: number,
): number {
  if (!wall.mesh || !frames.hasZoneStress) return -1;
  const pose = new Pose(wall, frames.at(look.frame), look.scale),
    { zone } = wall.mesh;
  for (let z = 0; z < zone.length; z += 4) {
    let inside = false;
    for (let k = 0, l = 3; k < 4; l = k++) {
      const [ax, ay] = pose.node(wall.mesh, zone[z + k]),
        [bx, by] = pose.node(wall.mesh, zone[z + l]);
      const [y0, y1] = [canvas.Y(ay), canvas.Y(by)];
      if (y0 > py !== y1 > py && px < canvas.X(ax) + ((py - y0) / (y1 - y0)) * (canvas.X(bx) - canvas.X(ax)))
        inside = !inside;
    }
    if (inside) return z / 4;
  }
  return -1;
}

// The joint nearest to a place in the drawing, within a few pixels; -1 if there is none.
export function jointAt(
  wall: Wall,
  frames: Frames,
  look: Look,
  canvas: Canvas,
  px: number,
  py: number,
): number {
  const pose = new Pose(wall, frames.at(look.frame), look.scale);
  let best = 9,
    found = -1;
  for (let j = 0; j < wall.joints; ++j) {
    if (gaveWay(pose.frame, j)) continue;
    const a = pose.joint(j, -1),
      b = pose.joint(j, 1);
    const ax = canvas.X(a[0]),
      ay = canvas.Y(a[1]),
      dx = canvas.X(b[0]) - ax,
      dy = canvas.Y(b[1]) - ay;
    const t = Math.min(1, Math.max(0, ((px - ax) * dx + (py - ay) * dy) / (dx * dx + dy * dy || 1)));
    const off = Math.hypot(px - ax - t * dx, py - ay - t * dy);
    if (off < best) {
      best = off;
      found = j;
    }
  }
  return found;
}
