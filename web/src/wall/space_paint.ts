// The content of a picture of a wall in space, and two things painted on a plain canvas. One is the whole
// picture if the browser has no WebGL; the other, above either, has the axes, the load and the picked body.
import {
  crossing,
  isCutAway,
  mayCross,
  sectionsOf,
  type Camera,
  type Cut,
  type Planes,
  type Poses,
  type SectionLine,
  type Solids,
  type Vec,
} from "./space";

export type Rgb = [number, number, number]; // 0-255

// Joints with something to show: red, green, blue and half the width in 255ths of 8 pixels, four numbers each.
export interface Marks {
  count: number;
  joints: Int32Array;
  look: Uint8Array;
}
// How a link is drawn above the picture.
export interface LinkMark {
  colour: Rgb;
  width: number; // [px]
  dash: number[];
}
export interface Scene {
  camera: Camera;
  poses: Poses;
  tints: Uint8Array; // of the bodies, four numbers each
  marks: Marks; // a new object whenever it or `tints` changes
  cut: Cut | null;
  clear: boolean; // blocks are transparent
  farthest: number; // largest displacement in the picture [m]
  links: LinkMark[]; // one for each link
  palette: { paper: Rgb; edge: Rgb; ink: Rgb; load: Rgb };
}
export interface Picture {
  readonly element: HTMLCanvasElement;
  draw(scene: Scene): void;
}

export const cssOf = (rgb: ArrayLike<number>, light = 1): string =>
  `rgb(${[0, 1, 2].map((k) => Math.min(255, Math.round(rgb[k] * light))).join(" ")})`;

export const kCapLight = 0.84; // of surfaces in a section
const kThin = 12; // style of an outline
// Outlines of the bodies that a cut crosses, and its cracks.
export function sectionLines(
  solids: Solids,
  { poses, marks, palette }: Scene,
  cut: Cut,
  opened: SectionLine[],
): { line: [Vec, Vec]; look: ArrayLike<number> }[] {
  const outline = [...palette.edge, kThin],
    lines: { line: [Vec, Vec]; look: ArrayLike<number> }[] = opened.map(({ line }) => ({ line, look: outline }));
  for (let m = 0; m < marks.count; ++m) {
    if (!mayCross(solids, poses, marks.joints[m], cut)) continue;
    const line = crossing(polygonOf(solids, poses, marks.joints[m]), cut);
    if (line) lines.push({ line, look: marks.look.subarray(4 * m, 4 * m + 4) });
  }
  return lines;
}
function polygonOf(solids: Solids, poses: Poses, j: number): Vec[] {
  const corners: Vec[] = [];
  for (let c = solids.outlineBegin[j]; c < solids.outlineBegin[j + 1]; ++c) corners.push(poses.between(j, c));
  return corners;
}

// --- without WebGL -----------------------------------------------------------------------------------

const lightOf = (n: Vec, toward: Vec): number =>
  0.62 + 0.3 * Math.max(0, n[0] * toward[0] + n[1] * toward[1] + n[2] * toward[2]) + 0.14 * n[1];

// The part of a polygon that remains after a cut.
function kept(corners: Vec[], cut: Cut): Vec[] {
  const out: Vec[] = [];
  corners.forEach((p, i) => {
    const q = corners[(i + 1) % corners.length];
    const a = cut.sense * (p[cut.axis] - cut.at),
      b = cut.sense * (q[cut.axis] - cut.at);
    if (a <= 0) out.push(p);
    if (a <= 0 !== b <= 0) out.push([0, 1, 2].map((k) => p[k] + (a / (a - b)) * (q[k] - p[k])) as Vec);
  });
  return out;
}

// Bodies from the farthest to the nearest, by their centroids. This may be wrong for
// bodies of very different size, so supports come first as long as the eye is above.
export class PaintedPicture implements Picture {
  readonly element = document.createElement("canvas");
  constructor(
    private readonly solids: Solids,
    private readonly planes: Planes,
  ) {}

  draw(scene: Scene): void {
    const { camera, poses, palette } = scene;
    const to = beginCanvas(this.element, camera.width, camera.height);
    to.fillStyle = cssOf(palette.paper);
    to.fillRect(0, 0, camera.width, camera.height);
    const depth = Float64Array.from({ length: this.solids.count }, (_, b) => {
      const far = camera.see([poses.data[8 * b], poses.data[8 * b + 1], poses.data[8 * b + 2]])[2];
      return b < this.solids.free ? far : far - (camera.tilt >= 0 ? 1e6 : -1e6);
    });
    const order = Array.from(depth.keys()).sort((a, b) => depth[a] - depth[b]);
    const rank = new Int32Array(order.length);
    order.forEach((b, i) => (rank[b] = i));
    const marksOf = new Map<number, number[]>(); // by the body that is painted last
    for (let m = 0; m < scene.marks.count; ++m) {
      const j = scene.marks.joints[m],
        a = this.solids.jointA[j],
        b = this.solids.jointB[j],
        last = rank[a] > rank[b] ? a : b;
      marksOf.set(last, [...(marksOf.get(last) ?? []), m]);
    }
    const sections = scene.cut ? sectionsOf(this.solids, poses, scene.cut) : [],
      opened = new Map<number, Vec[][]>(); // triangles of the closing surfaces
    if (scene.cut && scene.cut.sense * camera.axes()[2][scene.cut.axis] > 0)
      for (const { body, line, centre } of sections)
        opened.set(body, [...(opened.get(body) ?? []), [...line, centre]]);
    for (const b of order) {
      this.body(to, scene, b);
      const tint = cssOf(scene.tints.subarray(4 * b, 4 * b + 3), kCapLight);
      for (const corners of opened.get(b) ?? []) polygon(to, camera, corners, tint, tint);
      for (const m of marksOf.get(b) ?? []) this.mark(to, scene, m);
    }
    if (scene.cut)
      for (const one of sectionLines(this.solids, scene, scene.cut, sections)) line(to, camera, ...one.line, one.look);
  }

  private body(to: CanvasRenderingContext2D, scene: Scene, b: number): void {
    const s = this.solids,
      { camera, poses, cut } = scene,
      toward = camera.axes()[2],
      tint = scene.tints.subarray(4 * b, 4 * b + 3);
    const edge = cssOf(scene.palette.edge);
    to.globalAlpha = scene.clear ? 0.2 : 1;
    for (let part = s.partBegin[b]; part < s.partBegin[b + 1]; ++part)
      for (let f = s.faceBegin[part]; f < s.faceBegin[part + 1]; ++f) {
        const n = poses.rotated(b, this.planes.of[4 * f], this.planes.of[4 * f + 1], this.planes.of[4 * f + 2], 1);
        if (n[0] * toward[0] + n[1] * toward[1] + n[2] * toward[2] <= 0) continue;
        const corners: Vec[] = [];
        for (let i = s.cornerBegin[f]; i < s.cornerBegin[f + 1]; ++i)
          corners.push(poses.place(b, s.vertex, 3 * (s.vertexBegin[part] + s.corner[i])));
        polygon(to, camera, cut ? kept(corners, cut) : corners, cssOf(tint, lightOf(n, toward)), edge);
      }
    to.globalAlpha = 1;
  }

  // Draws the part of a rim that neither of its bodies hides.
  private mark(to: CanvasRenderingContext2D, scene: Scene, m: number): void {
    const s = this.solids,
      { camera, poses, cut } = scene,
      j = scene.marks.joints[m],
      toward = camera.axes()[2];
    const corners = polygonOf(s, poses, j),
      size = Math.sqrt(s.area[j]);
    corners.forEach((p, i) => {
      const q = corners[(i + 1) % corners.length],
        middle = [0, 1, 2].map((k) => (p[k] + q[k]) / 2 + 0.02 * size * toward[k]) as Vec;
      const hides = (b: number): boolean => this.planes.enters(b, poses, middle, toward, 0, 1e6) < 1e6;
      if (isCutAway(cut, middle) || hides(s.jointA[j]) || hides(s.jointB[j])) return;
      line(to, camera, p, q, scene.marks.look.subarray(4 * m, 4 * m + 4));
    });
  }
}

export function beginCanvas(canvas: HTMLCanvasElement, width: number, height: number): CanvasRenderingContext2D {
  const fine = Math.min(2, window.devicePixelRatio || 1);
  canvas.width = Math.round(fine * width);
  canvas.height = Math.round(fine * height);
  canvas.style.width = `${width}px`;
  canvas.style.height = `${height}px`;
  const to = canvas.getContext("2d")!;
  to.setTransform(fine, 0, 0, fine, 0, 0);
  to.lineJoin = to.lineCap = "round";
  return to;
}
function polygon(to: CanvasRenderingContext2D, camera: Camera, corners: Vec[], fill: string, edge: string): void {
  if (corners.length < 3) return;
  to.beginPath();
  for (const p of corners) {
    const [x, y] = camera.see(p);
    to.lineTo(x, y);
  }
  to.closePath();
  to.fillStyle = fill;
  to.fill();
  to.strokeStyle = edge;
  to.lineWidth = 0.7;
  to.stroke();
}
function line(to: CanvasRenderingContext2D, camera: Camera, p: Vec, q: Vec, look: ArrayLike<number>): void {
  const [x, y] = camera.see(p),
    [u, v] = camera.see(q);
  to.strokeStyle = cssOf(look);
  to.lineWidth = (16 * look[3]) / 255;
  to.beginPath();
  to.moveTo(x, y);
  to.lineTo(u, v);
  to.stroke();
}

// --- above the picture -------------------------------------------------------------------------------

function arrow(to: CanvasRenderingContext2D, x: number, y: number, dx: number, dy: number): void {
  const long = Math.hypot(dx, dy);
  if (long < 3) return void (to.beginPath(), to.arc(x, y, 3, 0, 7), to.fill()); // towards or away from the eye
  const [ex, ey] = [dx / long, dy / long],
    head = Math.min(9, 0.5 * long);
  to.beginPath();
  to.moveTo(x, y);
  to.lineTo(x + dx, y + dy);
  to.moveTo(x + dx - head * (ex - 0.5 * ey), y + dy - head * (ey + 0.5 * ex));
  to.lineTo(x + dx, y + dy);
  to.lineTo(x + dx - head * (ex + 0.5 * ey), y + dy - head * (ey - 0.5 * ex));
  to.stroke();
}

// Axes at the lower left, an arrow for the load, and a scale bar.
export function drawOver(to: CanvasRenderingContext2D, solids: Solids, scene: Scene, length: { metres: number; words: string }): void {
  const { camera, poses, palette } = scene;
  drawLinks(to, solids, scene);
  const axes = camera.axes();
  to.lineWidth = 1.5;
  to.font = "600 12px system-ui, sans-serif";
  to.textAlign = "center";
  to.textBaseline = "middle";
  const write = (words: string, x: number, y: number): void => {
    to.save();
    to.strokeStyle = cssOf(palette.paper);
    to.lineWidth = 3;
    to.strokeText(words, x, y);
    to.restore();
    to.fillText(words, x, y);
  };
  to.strokeStyle = to.fillStyle = cssOf(palette.ink);
  const [x0, y0] = [34, camera.height - 34];
  ["x", "y", "z"].forEach((name, k) => {
    const dx = 24 * axes[0][k],
      dy = -24 * axes[1][k];
    if (Math.hypot(dx, dy) < 4) return;
    arrow(to, x0, y0, dx, dy);
    write(name, x0 + 1.35 * dx, y0 + 1.35 * dy);
  });
  const long = length.metres * camera.zoom,
    right = camera.width - 14;
  to.beginPath();
  to.moveTo(right - long, camera.height - 18);
  to.lineTo(right - long, camera.height - 12);
  to.lineTo(right, camera.height - 12);
  to.lineTo(right, camera.height - 18);
  to.stroke();
  to.font = "12px system-ui, sans-serif";
  write(length.words, right - long / 2, camera.height - 24);
  if (solids.load) loadArrow(to, solids, camera, poses, cssOf(palette.load));
}

// Links are visible through blocks, as in a plan; a spring is a coil from its block to the ground.
function drawLinks(to: CanvasRenderingContext2D, solids: Solids, { camera, poses, cut, links, palette }: Scene): void {
  solids.links.forEach((link, k) => {
    const [p, q] = poses.link(link);
    if (isCutAway(cut, p) && isCutAway(cut, q)) return;
    const [x, y] = camera.see(p),
      [u, v] = camera.see(q),
      look = links[k];
    const ends: [number, number][] = link.kind === "spring" ? coilOf(camera, q, link.along) : [[x, y], [u, v]];
    for (const [colour, width, dash] of [[palette.paper, look.width + 2.5, []], [look.colour, look.width, look.dash]] as const) {
      to.strokeStyle = to.fillStyle = cssOf(colour);
      to.lineWidth = width;
      to.setLineDash(dash as number[]);
      to.beginPath();
      ends.forEach(([a, b]) => to.lineTo(a, b));
      to.stroke();
      to.setLineDash([]);
      for (const [a, b] of link.kind === "spring" ? [[u, v]] : [[x, y], [u, v]]) {
        to.beginPath();
        to.arc(a, b, 0.5 * width + 1.5, 0, 7);
        to.fill();
      }
    }
  });
}
function coilOf(camera: Camera, from: Vec, along: Vec): [number, number][] {
  const axes = camera.axes(),
    side = (k: number): number => along.reduce((sum, d, i) => sum + d * axes[k][i], 0);
  const [dx, dy] = [-side(0), side(1)],
    [x, y] = camera.see(from);
  const at = (far: number, off: number): [number, number] => [x + far * dx - off * dy, y + far * dy + off * dx];
  return [at(0, 0), ...[5, -5, 5, -5, 5].map((off, k) => at(6 * (k + 1), off)), at(36, 0), at(36, -9), at(36, 9)];
}

// The arrow is at the middle of the driven bodies, outside of them.
function loadArrow(to: CanvasRenderingContext2D, s: Solids, camera: Camera, poses: Poses, colour: string): void {
  const { direction, driven } = s.load!,
    bodies = driven.length > 0 ? driven : Array.from({ length: s.free }, (_, b) => b);
  const middle: Vec = [0, 0, 0];
  for (const b of bodies) for (let k = 0; k < 3; ++k) middle[k] += poses.data[8 * b + k] / bodies.length;
  const axes = camera.axes(),
    along = (k: number): number => direction.reduce((sum, d, i) => sum + d * axes[k][i], 0);
  const [x, y] = camera.see(middle),
    [dx, dy] = [64 * along(0), -64 * along(1)];
  to.strokeStyle = to.fillStyle = colour;
  to.lineWidth = 3;
  arrow(to, x, y, dx, dy);
}
