// A wall in space: bodies and the faces between them, their poses in a state, the camera, and
// picking by rays. The same kinematics as src/reading/places.cpp: a body turns about its centroid
// and moves. All places are relative to the middle of the moving bodies (header.wall.space.middle).
import type { Bundle, Numbers } from "../base/bundle";
import type { Crack } from "./wall";

export type Vec = [number, number, number];
export const dot = (a: Vec, b: Vec): number => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];

export interface Load {
  direction: Vec;
  driven: number[]; // bodies; none: all of them
}

// A tie, a strip of a floor or a spring; a: -1 is the ground. For a spring `along` is the direction in which its block is held.
export interface SolidLink {
  name: string;
  kind: "tie" | "diaphragm" | "spring" | "anchor" | "dowel" | "wedge";
  a: number;
  b: number;
  from: Vec;
  to: Vec;
  along: Vec;
}
export const kLinkStates = ["holds", "slack", "yielded"] as const;

// Nested lists, one after the other: parts of a body, vertices and faces of a part, corners of a face.
export interface Solids {
  count: number; // bodies
  free: number; // supports follow
  joints: number;
  middle: Vec;
  load: Load | null;
  links: SolidLink[];
  names: string[];
  materials: string[];
  material: Numbers; // of each body
  centroid: Numbers;
  reach: Float32Array; // farthest vertex from the centroid [m]
  partBegin: Numbers;
  vertexBegin: Numbers;
  faceBegin: Numbers;
  cornerBegin: Numbers;
  corner: Numbers; // indices of vertices within their part
  vertex: Numbers;
  jointA: Numbers; // bodies
  jointB: Numbers;
  kind: string[]; // "bed", "head", ...
  outlineBegin: Numbers; // of each joint's polygon
  outline: Numbers;
  area: Float32Array; // of the polygon [m²]
  low: Vec; // bounds of the moving bodies
  high: Vec;
}

export function readSolids(bundle: Bundle): Solids | null {
  const wall = bundle.header.wall;
  if (!wall?.space) return null;
  const { names, materials, supports, middle, load, links } = wall.space;
  const get = (name: string): Numbers => bundle.array(`space.${name}`);
  const solids: Solids = {
    count: names.length,
    free: names.length - supports,
    joints: wall.joints,
    middle,
    load,
    links: links ?? [],
    names,
    materials,
    material: get("material"),
    centroid: get("centroid"),
    reach: new Float32Array(names.length),
    partBegin: get("part_begin"),
    vertexBegin: get("vertex_begin"),
    faceBegin: get("face_begin"),
    cornerBegin: get("corner_begin"),
    corner: get("corner"),
    vertex: get("vertex"),
    jointA: get("joint_a"),
    jointB: get("joint_b"),
    kind: Array.from(get("kind"), (number) => wall.kinds![number]),
    outlineBegin: get("outline_begin"),
    outline: get("outline"),
    area: new Float32Array(wall.joints),
    low: [Infinity, Infinity, Infinity],
    high: [-Infinity, -Infinity, -Infinity],
  };
  measure(solids);
  return solids;
}

function measure(s: Solids): void {
  for (let v = 0; v < 3 * s.vertexBegin[s.partBegin[s.free]]; ++v) {
    s.low[v % 3] = Math.min(s.low[v % 3], s.vertex[v]);
    s.high[v % 3] = Math.max(s.high[v % 3], s.vertex[v]);
  }
  for (let b = 0; b < s.count; ++b)
    for (let v = s.vertexBegin[s.partBegin[b]]; v < s.vertexBegin[s.partBegin[b + 1]]; ++v)
      s.reach[b] = Math.max(s.reach[b], Math.hypot(...armOf(s, b, v)));
  for (let j = 0; j < s.joints; ++j) {
    const sum: Vec = [0, 0, 0],
      from = s.outlineBegin[j];
    for (let i = from + 1; i + 1 < s.outlineBegin[j + 1]; ++i)
      for (let k = 0; k < 3; ++k) {
        const side = (c: number, axis: number): number => s.outline[3 * c + axis] - s.outline[3 * from + axis];
        const [l, m] = [(k + 1) % 3, (k + 2) % 3];
        sum[k] += (side(i, l) * side(i + 1, m) - side(i, m) * side(i + 1, l)) / 2;
      }
    s.area[j] = Math.hypot(...sum);
  }
}
// A vertex relative to its body's centroid.
export const armOf = (s: Solids, body: number, v: number): Vec => [
  s.vertex[3 * v] - s.centroid[3 * body],
  s.vertex[3 * v + 1] - s.centroid[3 * body + 1],
  s.vertex[3 * v + 2] - s.centroid[3 * body + 2],
];
// Bounds of the view: all moving bodies, and the part of supports near them.
export function boundsOf(s: Solids): [Vec, Vec] {
  const far = 0.15 * sizeOf(s),
    low: Vec = [...s.low],
    high: Vec = [...s.high];
  for (let i = 3 * s.vertexBegin[s.partBegin[s.free]]; i < s.vertex.length; ++i) {
    const k = i % 3;
    low[k] = Math.max(s.low[k] - far, Math.min(low[k], s.vertex[i]));
    high[k] = Math.min(s.high[k] + far, Math.max(high[k], s.vertex[i]));
  }
  return [low, high];
}
export const sizeOf = (s: Solids): number => Math.hypot(...s.high.map((h, k) => h - s.low[k]));

// A body's name without its number: "front3.2" and "front4.1" belong to "front".
export const groupOf = (name: string): string => /^[^\d]*/.exec(name)![0].replace(/[\s._#:/(-]+$/, "");

// --- states ------------------------------------------------------------------------------------------

export interface SolidState {
  moved: Numbers; // (n_body, 3) [m]
  turned: Numbers; // vectors of rotation [rad]
  opening: Numbers; // (n_joint), largest of a joint's points [m]
  slip: Numbers;
  stress: Numbers; // mean over the joint, tension + [Pa]
  damage: Numbers; // 0-255
  crushing: Numbers;
  linkForce: Numbers; // (n_link) tension + [N]; empty in pages without links
  linkState: Numbers; // indices into kLinkStates
}

export class SolidStates {
  readonly count: number;
  private readonly arrays: SolidState;
  constructor(
    bundle: Bundle,
    readonly solids: Solids,
  ) {
    this.count = bundle.header.frames?.length ?? 0;
    const get = (name: string): Numbers => bundle.array(`frame.${name}`);
    this.arrays = {
      moved: get("moved"),
      turned: get("turned"),
      opening: get("opening"),
      slip: get("slip"),
      stress: get("stress"),
      damage: get("damage"),
      crushing: get("crushing"),
      linkForce: solids.links.length > 0 ? get("link_force") : new Float32Array(0),
      linkState: solids.links.length > 0 ? get("link_state") : new Float32Array(0),
    };
  }
  at(frame: number): SolidState {
    const { count, joints, links } = this.solids;
    const slice = (name: keyof SolidState, n: number): Numbers =>
      this.arrays[name].subarray(frame * n, (frame + 1) * n);
    return {
      moved: slice("moved", 3 * count),
      turned: slice("turned", 3 * count),
      opening: slice("opening", joints),
      slip: slice("slip", joints),
      stress: slice("stress", joints),
      damage: slice("damage", joints),
      crushing: slice("crushing", joints),
      linkForce: slice("linkForce", links.length),
      linkState: slice("linkState", links.length),
    };
  }
}

const kRounds = [1, 2, 5, 10, 20, 50, 100];
// A round magnification with which the largest displacement is about 5 % of the wall.
export function fittingSize(states: SolidStates, frame: number): number {
  if (states.count === 0) return 1;
  const { moved } = states.at(frame);
  let largest = 0;
  for (let i = 0; i < 3 * states.solids.free; i += 3)
    largest = Math.max(largest, Math.hypot(moved[i], moved[i + 1], moved[i + 2]));
  return kRounds.filter((s) => s === 1 || largest * s <= 0.05 * sizeOf(states.solids)).pop()!;
}

const kVisible = 0.05; // smaller openings and slips count as closed [mm]
// The kind of crack of a joint, as in the plane.
export function crackOfFace(state: SolidState, j: number): Crack {
  const damage = state.damage[j] / 255;
  if (damage <= 0.012) return "sound";
  if (damage < 0.998) return "softening";
  const opening = state.opening[j] * 1e3,
    slip = Math.abs(state.slip[j]) * 1e3;
  if (Math.max(opening, slip) < kVisible) return "closed";
  return opening >= slip ? "open" : "slip";
}

const kQuarter = Math.PI / 2;
// Poses of all bodies, eight numbers each: the centroid, one unused, the turn as a quaternion x y z w.
export class Poses {
  readonly data: Float32Array;
  constructor(
    private readonly states: SolidStates,
    room = 8 * states.solids.count,
  ) {
    this.data = new Float32Array(room);
  }
  // Between two stored states (`at` is not an integer) bodies move linearly.
  set(at: number, scale: number): this {
    const { solids, count } = this.states;
    const frame = Math.min(Math.floor(at), Math.max(0, count - 1)),
      share = frame + 1 < count ? at - frame : 0;
    const a = this.states.at(frame),
      b = share > 0 ? this.states.at(frame + 1) : a;
    const { data } = this,
      rest = 1 - share;
    for (let i = 0, k = 0; k < 8 * solids.count; i += 3, k += 8) {
      data[k] = solids.centroid[i] + scale * (rest * a.moved[i] + share * b.moved[i]);
      data[k + 1] = solids.centroid[i + 1] + scale * (rest * a.moved[i + 1] + share * b.moved[i + 1]);
      data[k + 2] = solids.centroid[i + 2] + scale * (rest * a.moved[i + 2] + share * b.moved[i + 2]);
      let x = a.turned[i],
        y = a.turned[i + 1],
        z = a.turned[i + 2];
      if (share > 0) {
        const dx = b.turned[i] - x,
          dy = b.turned[i + 1] - y,
          dz = b.turned[i + 2] - z;
        // beyond half a turn, a rotation vector has the opposite direction
        if (dx * dx + dy * dy + dz * dz < Math.PI * Math.PI) (x += share * dx), (y += share * dy), (z += share * dz);
      }
      const angle = Math.sqrt(x * x + y * y + z * z);
      // up to a quarter turn rotations are magnified; beyond, blocks would spin
      const turn = angle > kQuarter ? angle : Math.min(kQuarter, angle * scale);
      const sine = angle > 0 ? Math.sin(turn / 2) / angle : 0;
      data[k + 4] = sine * x;
      data[k + 5] = sine * y;
      data[k + 6] = sine * z;
      data[k + 7] = Math.cos(turn / 2);
    }
    return this;
  }
  // Place of a body's point that started at `from`.
  place(body: number, from: Numbers, i: number): Vec {
    const { centroid } = this.states.solids,
      c = 3 * body;
    return this.carried(body, from[i] - centroid[c], from[i + 1] - centroid[c + 1], from[i + 2] - centroid[c + 2]);
  }
  private carriedFrom(body: number, [x, y, z]: Vec): Vec {
    const { centroid } = this.states.solids,
      c = 3 * body;
    return this.carried(body, x - centroid[c], y - centroid[c + 1], z - centroid[c + 2]);
  }
  private carried(body: number, x: number, y: number, z: number): Vec {
    const { data } = this,
      k = 8 * body;
    const [tx, ty, tz] = this.rotated(body, x, y, z, 1);
    return [data[k] + tx, data[k + 1] + ty, data[k + 2] + tz];
  }
  // A direction rotated with the body (sense 1) or back (-1).
  rotated(body: number, x: number, y: number, z: number, sense: number): Vec {
    const { data } = this,
      k = 8 * body;
    const qx = sense * data[k + 4],
      qy = sense * data[k + 5],
      qz = sense * data[k + 6],
      w = data[k + 7];
    const cx = qy * z - qz * y + w * x,
      cy = qz * x - qx * z + w * y,
      cz = qx * y - qy * x + w * z;
    return [x + 2 * (qy * cz - qz * cy), y + 2 * (qz * cx - qx * cz), z + 2 * (qx * cy - qy * cx)];
  }
  // Both ends of a link; an end in the ground does not move.
  link(l: SolidLink): [Vec, Vec] {
    const end = (body: number, from: Vec): Vec => (body < 0 ? from : this.carriedFrom(body, from));
    return [end(l.a, l.from), end(l.b, l.to)];
  }
  // A corner of a joint's polygon, half way between its two faces.
  between(j: number, corner: number): Vec {
    const { jointA, jointB, outline } = this.states.solids;
    const a = this.place(jointA[j], outline, 3 * corner),
      b = this.place(jointB[j], outline, 3 * corner);
    return [(a[0] + b[0]) / 2, (a[1] + b[1]) / 2, (a[2] + b[2]) / 2];
  }
}

// --- looking -----------------------------------------------------------------------------------------

// A parallel projection, without perspective, so that lengths across the view are true.
export class Camera {
  turn = 0; // about the vertical; 0: from +z, x to the right
  tilt = 0; // upwards
  target: Vec = [0, 0, 0];
  zoom = 1; // pixels for each metre
  width = 1;
  height = 1;

  // Axes of the view: to the right, up, and towards the eye.
  axes(): [Vec, Vec, Vec] {
    const [s, c] = [Math.sin(this.turn), Math.cos(this.turn)],
      [st, ct] = [Math.sin(this.tilt), Math.cos(this.tilt)];
    return [
      [c, 0, -s],
      [-st * s, ct, -st * c],
      [ct * s, st, ct * c],
    ];
  }
  // Projects a place: pixels from the left and the top, and metres towards the eye.
  see(p: Vec): Vec {
    const [right, up, toward] = this.axes();
    const v: Vec = [p[0] - this.target[0], p[1] - this.target[1], p[2] - this.target[2]];
    return [this.width / 2 + this.zoom * dot(v, right), this.height / 2 - this.zoom * dot(v, up), dot(v, toward)];
  }
  // The place at a pixel, in the plane of the target.
  at(x: number, y: number): Vec {
    const [right, up] = this.axes();
    const r = (x - this.width / 2) / this.zoom,
      u = (this.height / 2 - y) / this.zoom;
    return [0, 1, 2].map((k) => this.target[k] + r * right[k] + u * up[k]) as Vec;
  }
  shift(x: number, y: number): void {
    const [right, up] = this.axes();
    for (let k = 0; k < 3; ++k) this.target[k] += (-x * right[k] + y * up[k]) / this.zoom;
  }
  // Fits a box into the view, with a margin.
  fit(low: Vec, high: Vec, air = 0.08): void {
    const [right, up] = this.axes();
    this.target = [0, 1, 2].map((k) => (low[k] + high[k]) / 2) as Vec;
    const span = (axis: Vec): number => [0, 1, 2].reduce((sum, k) => sum + (high[k] - low[k]) * Math.abs(axis[k]), 0);
    this.zoom = (1 - air) * Math.min(this.width / (span(right) || 1), this.height / (span(up) || 1));
  }
}

// Hides everything beyond a plane across an axis: sense · (place − at) > 0.
export interface Cut {
  axis: number;
  at: number;
  sense: number;
}
export const isCutAway = (cut: Cut | null, p: Vec): boolean =>
  cut !== null && cut.sense * (p[cut.axis] - cut.at) > 0;

// --- picking by rays ---------------------------------------------------------------------------------

// Planes of the faces of every part, relative to the body's centroid: outward normal and distance.
export class Planes {
  readonly of: Float32Array; // four numbers for each face
  constructor(readonly solids: Solids) {
    const s = solids;
    this.of = new Float32Array(4 * (s.cornerBegin.length - 1));
    for (let b = 0; b < s.count; ++b)
      for (let part = s.partBegin[b]; part < s.partBegin[b + 1]; ++part)
        for (let f = s.faceBegin[part]; f < s.faceBegin[part + 1]; ++f) this.set(b, part, f);
  }
  // The normal comes from the sum over all corners, because three of them may lie on a line.
  private set(body: number, part: number, f: number): void {
    const s = this.solids,
      n: Vec = [0, 0, 0];
    const corner = (i: number): Vec => armOf(s, body, s.vertexBegin[part] + s.corner[i]);
    const from = s.cornerBegin[f],
      end = s.cornerBegin[f + 1];
    for (let i = from; i < end; ++i) {
      const p = corner(i),
        q = corner(i + 1 < end ? i + 1 : from);
      for (let k = 0; k < 3; ++k) n[k] += p[(k + 1) % 3] * q[(k + 2) % 3] - p[(k + 2) % 3] * q[(k + 1) % 3];
    }
    const size = Math.hypot(...n) || 1;
    for (let k = 0; k < 3; ++k) this.of[4 * f + k] = n[k] / size;
    this.of[4 * f + 3] = dot(corner(from), n) / size;
  }

  // Distance along a ray, between `begin` and `end`, at which it enters a body; Infinity if it misses.
  enters(body: number, poses: Poses, from: Vec, way: Vec, begin: number, end: number): number {
    const s = this.solids,
      k = 8 * body,
      { data } = poses;
    const away: Vec = [from[0] - data[k], from[1] - data[k + 1], from[2] - data[k + 2]];
    const along = dot(away, way);
    if (dot(away, away) - along * along > s.reach[body] * s.reach[body]) return Infinity;
    const o = poses.rotated(body, ...away, -1),
      d = poses.rotated(body, ...way, -1);
    let first = Infinity;
    for (let part = s.partBegin[body]; part < s.partBegin[body + 1]; ++part) {
      let near = begin,
        far = end;
      for (let f = 4 * s.faceBegin[part]; f < 4 * s.faceBegin[part + 1] && near <= far; f += 4) {
        const speed = this.of[f] * d[0] + this.of[f + 1] * d[1] + this.of[f + 2] * d[2],
          room = this.of[f + 3] - (this.of[f] * o[0] + this.of[f + 1] * o[1] + this.of[f + 2] * o[2]);
        if (Math.abs(speed) < 1e-9) near = room < 0 ? Infinity : near;
        else if (speed < 0) near = Math.max(near, room / speed);
        else far = Math.min(far, room / speed);
      }
      if (near <= far) first = Math.min(first, near);
    }
    return first;
  }

  // The body seen at a pixel, -1: none.
  pick(camera: Camera, poses: Poses, cut: Cut | null, x: number, y: number): number {
    const toward = camera.axes()[2],
      way: Vec = [-toward[0], -toward[1], -toward[2]],
      from = camera.at(x, y);
    let begin = -1e6,
      end = 1e6;
    if (cut) {
      const speed = cut.sense * way[cut.axis],
        room = cut.sense * (cut.at - from[cut.axis]);
      if (Math.abs(speed) < 1e-9) end = room < 0 ? -Infinity : end;
      else if (speed > 0) end = room / speed;
      else begin = room / speed;
    }
    let found = -1,
      nearest = Infinity;
    for (let b = 0; b < this.solids.count; ++b) {
      const depth = this.enters(b, poses, from, way, begin, end);
      if (depth < nearest) (nearest = depth), (found = b);
    }
    return found;
  }

  // Number of free bodies completely beyond a cut.
  hidden(poses: Poses, cut: Cut | null): number {
    const s = this.solids;
    let n = 0;
    for (let b = 0; cut && b < s.free; ++b) {
      const far = beyondBy(poses, b, cut);
      if (far <= 0) continue;
      let all = true;
      const last = s.vertexBegin[s.partBegin[b + 1]];
      for (let v = s.vertexBegin[s.partBegin[b]]; v < last && all; ++v)
        all = isCutAway(cut, poses.place(b, s.vertex, 3 * v));
      if (all) ++n;
    }
    return n;
  }
}

// --- sections by a cut -------------------------------------------------------------------------------

// Distance of a body's centroid beyond a cut.
const beyondBy = (poses: Poses, body: number, cut: Cut): number =>
  cut.sense * (poses.data[8 * body + cut.axis] - cut.at);

// False if both bodies of a joint lie completely on one side of a cut.
export function mayCross(s: Solids, poses: Poses, j: number, cut: Cut): boolean {
  const a = s.jointA[j],
    b = s.jointB[j],
    far = beyondBy(poses, a, cut),
    near = beyondBy(poses, b, cut);
  return far * near < 0 || Math.abs(far) <= s.reach[a] || Math.abs(near) <= s.reach[b];
}

// The two points where a polygon crosses a cut, or null.
export function crossing(corners: Vec[], cut: Cut): [Vec, Vec] | null {
  const ends: Vec[] = [];
  for (let i = 0; i < corners.length; ++i) {
    const p = corners[i],
      q = corners[(i + 1) % corners.length];
    const a = p[cut.axis] - cut.at,
      b = q[cut.axis] - cut.at;
    if (a < 0 === b < 0) continue;
    const share = a / (a - b);
    ends.push([0, 1, 2].map((k) => p[k] + share * (q[k] - p[k])) as Vec);
  }
  return ends.length === 2 ? [ends[0], ends[1]] : null;
}

// A line where a face of a part crosses a cut, and the middle of all
// lines of that part: together one triangle of the closing surface.
export interface SectionLine {
  body: number;
  line: [Vec, Vec];
  centre: Vec;
}
export function sectionsOf(s: Solids, poses: Poses, cut: Cut): SectionLine[] {
  const all: SectionLine[] = [];
  for (let body = 0; body < s.count; ++body) {
    if (Math.abs(beyondBy(poses, body, cut)) > s.reach[body]) continue;
    for (let part = s.partBegin[body]; part < s.partBegin[body + 1]; ++part) {
      const from = s.vertexBegin[part],
        places: Vec[] = [];
      let beyond = 0;
      for (let v = from; v < s.vertexBegin[part + 1]; ++v) {
        const p = poses.place(body, s.vertex, 3 * v);
        beyond += p[cut.axis] >= cut.at ? 1 : 0;
        places.push(p);
      }
      if (beyond === 0 || beyond === places.length) continue;
      const lines: [Vec, Vec][] = [],
        centre: Vec = [0, 0, 0];
      for (let f = s.faceBegin[part]; f < s.faceBegin[part + 1]; ++f) {
        const face: Vec[] = [];
        for (let i = s.cornerBegin[f]; i < s.cornerBegin[f + 1]; ++i) face.push(places[s.corner[i]]);
        const line = crossing(face, cut);
        if (line) lines.push(line);
      }
      for (const [p, q] of lines) for (let k = 0; k < 3; ++k) centre[k] += (p[k] + q[k]) / (2 * lines.length);
      for (const line of lines) all.push({ body, line, centre });
    }
  }
  return all;
}
