// A wall and its states: shapes at the start, places of blocks and joints in a
// frame. The same kinematics as src/reading/places.cpp: a block turns about its
// centroid and moves. The last `bodies` of the blocks are deformable, with nodes
// of zones as corners, and the last `contacts` of the joints are their edges.
import type { Bundle, Numbers } from "../base/bundle";
import type { Said } from "../base/texts";

// The nodes and zones of deformable blocks.
export interface Mesh {
  rigid: number; // blocks before the deformable ones
  joints: number; // joints before the contacts
  rim: Numbers; // node of each corner of the deformable blocks, one block after the other
  nodeX: Numbers;
  nodeY: Numbers;
  zone: Numbers; // four nodes each
  contactP: Numbers; // nodes of the edge; the contact lies between two shares of it
  contactQ: Numbers;
  share0: Numbers;
  share1: Numbers;
}

// A property that varies within the wall: for each joint or block, NaN where it has none.
export interface Field {
  name: string;
  path: string;
  unit: string;
  mean: number; // as in the model; for a field by formula, the mean in this wall
  follows?: boolean;
  note?: Said; // the scatter that remains after truncation
  sample?: number; // of a campaign
  onBlocks: boolean;
  values: Numbers;
  steps: number[]; // bounds of its colours
}

// A pier, spandrel, sill, node, connection or toe, at the start: [x0, x1, y0, y1].
export interface Part {
  name: string;
  mark: string;
  kind: string;
  storey: number;
  box: [number, number, number, number];
  blocks: number[]; // with centroids in it
}

// A tie, diaphragm or spring; `along` is the direction from end a to end b at the start, for a spring a unit vector.
export interface Link {
  name: string;
  kind: "tie" | "diaphragm" | "spring" | "anchor" | "dowel" | "wedge";
  a: number; // block; -1: a fixed point
  b: number;
  arm_a: [number, number];
  arm_b: [number, number];
  along: [number, number];
}

// A straight part of a frame, and its sections: at `place` along it, on block b [m].
export interface Member {
  frame: string;
  words: Said;
  length: number;
  way: [number, number];
  along?: [number, number, number]; // of a wall in space: its plane
  up?: [number, number, number];
}
export interface MemberSection {
  member: number;
  place: number;
  a: number; // -1: the ground
  b: number;
  hinged?: boolean;
  arm: [number, number];
}

// Blocks in a plane, and the frames among them: of a wall in space a slice (space_slice.ts).
export interface Blocks {
  members: Member[];
  sections: MemberSection[];
  length: number;
  height: number;
  blocks: number;
  outlineBegin: Numbers;
  outlineX: Numbers;
  outlineY: Numbers;
  centroidX: Numbers;
  centroidY: Numbers;
  role: string[]; // "masonry", "lintel", "plate", "beam", "ring_beam", "sill"
  mesh: Mesh | null;
}

export interface Wall extends Blocks {
  links: Link[];
  storeys: { name: string; top: number }[]; // from the ground up [m]
  parts: Part[];
  fields: Field[];
  allFields: Field[];
  thickness: number;
  courses: number;
  joints: number;
  pairs: number;
  push: [number, number] | null;
  driven: Numbers | null; // in parts, an arrow each: up to `end`, `length` over the longest
  pushed: { end: number; length: number }[];
  blockThickness: Numbers;
  jointA: Numbers;
  jointB: Numbers;
  kind: string[]; // "bed", "head", ...
  armAX: Numbers;
  armAY: Numbers;
  armBX: Numbers;
  armBY: Numbers;
  halfX: Numbers;
  halfY: Numbers;
  supportBegin: Numbers;
  supportX: Numbers;
  supportY: Numbers;
  bounds: { x0: number; x1: number; y0: number; y1: number };
}

function readMesh(bundle: Bundle): Mesh | null {
  const head = bundle.header.wall!;
  if (!head.bodies) return null;
  const get = (name: string): Numbers => bundle.array(`wall.${name}`);
  const edges = head.contacts! > 0 ? get : (): Numbers => new Float32Array();
  return {
    rigid: head.blocks - head.bodies,
    joints: head.joints - head.contacts!,
    rim: get("rim"),
    nodeX: get("node_x"),
    nodeY: get("node_y"),
    zone: get("zone"),
    contactP: edges("contact_p"),
    contactQ: edges("contact_q"),
    share0: edges("share_0"),
    share1: edges("share_1"),
  };
}

// Six steps of equal width from the smallest value to the largest. In
// a campaign: over the fields of all samples, which follow each other.
function readFields(bundle: Bundle): Field[] {
  return (bundle.header.wall!.fields ?? []).map((field, i): Field => {
    const values = bundle.array(`wall.field_${i}`);
    const known = Array.from(values).filter((v) => !Number.isNaN(v));
    const low = Math.min(...known),
      high = Math.max(...known);
    const steps = Array.from({ length: high > low ? 6 : 1 }, (_, k) => low + (k * (high - low)) / 6);
    return { ...field, values, steps };
  });
}

// Roles for data of earlier programs, which had none.
const kRolesBefore = ["masonry", "lintel", "plate", "beam"],
  kKindsBefore = ["bed", "head", "split", "foundation", "lintel_chain", "lintel_bond", "plate", "beam", "other"];

// Parts with their blocks; empty in data of earlier programs.
function readParts(list: Omit<Part, "blocks">[] | undefined, x: Numbers, y: Numbers): Part[] {
  return (list ?? []).map((part) => {
    const [x0, x1, y0, y1] = part.box;
    const blocks: number[] = [];
    for (let b = 0; b < x.length; ++b) if (x[b] > x0 && x[b] < x1 && y[b] > y0 && y[b] < y1) blocks.push(b);
    return { ...part, blocks };
  });
}

// null: the page has no wall, or one in space.
export function readWall(bundle: Bundle): Wall | null {
  const head = bundle.header.wall;
  if (!head || head.space) return null;
  const get = (name: string): Numbers => bundle.array(`wall.${name}`);
  const fields = readFields(bundle);
  const words = (name: string, list: string[]): string[] => Array.from(get(name), (number) => list[number]);
  const wall = {
    ...head,
    links: head.links ?? [],
    members: head.members ?? [],
    sections: head.sections ?? [],
    storeys: head.storeys ?? [],
    push: head.push ?? null,
    driven: head.push ? get("driven") : null,
    pushed: head.pushed ?? (head.push ? [{ end: get("driven").length, length: 1 }] : []),
    outlineBegin: get("outline_begin"),
    outlineX: get("outline_x"),
    outlineY: get("outline_y"),
    centroidX: get("centroid_x"),
    centroidY: get("centroid_y"),
    blockThickness: get("thickness"),
    role: words("role", head.roles ?? kRolesBefore),
    jointA: get("joint_a"),
    jointB: get("joint_b"),
    kind: words("kind", head.kinds ?? kKindsBefore),
    armAX: get("arm_a_x"),
    armAY: get("arm_a_y"),
    armBX: get("arm_b_x"),
    armBY: get("arm_b_y"),
    halfX: get("half_x"),
    halfY: get("half_y"),
    supportBegin: get("support_begin"),
    supportX: get("support_x"),
    supportY: get("support_y"),
    mesh: readMesh(bundle),
    fields,
    allFields: fields,
    parts: readParts(head.parts, get("centroid_x"), get("centroid_y")),
  };
  const bounds = { x0: Infinity, x1: -Infinity, y0: Infinity, y1: -Infinity };
  const take = (xs: Numbers, ys: Numbers): void =>
    xs.forEach((x: number, i: number) => {
      bounds.x0 = Math.min(bounds.x0, x);
      bounds.x1 = Math.max(bounds.x1, x);
      bounds.y0 = Math.min(bounds.y0, ys[i]);
      bounds.y1 = Math.max(bounds.y1, ys[i]);
    });
  take(wall.outlineX, wall.outlineY);
  take(wall.supportX, wall.supportY);
  return { ...wall, bounds };
}

export const kCarried = ["moment", "shear", "normal", "use"] as const;
export type Carried = (typeof kCarried)[number];

// States of blocks in a plane, and what sections of frames carry in each: [N], [N], [N m], share of what they bear.
export interface FramedStates {
  readonly count: number;
  readonly wall: Blocks;
  at(frame: number): Places;
  carried(what: Carried, frame: number): Numbers;
}

// Values of every frame, one after the other: (n_frame, n_block) and (n_frame, n_joint).
export class Frames implements FramedStates {
  readonly count: number;
  private readonly arrays: Record<string, Numbers> = {};
  readonly hasForces: boolean;
  readonly hasZoneStress: boolean;

  constructor(
    bundle: Bundle,
    readonly wall: Wall,
  ) {
    this.count = bundle.header.frames?.length ?? 0;
    for (const name of [
      "ux",
      "uy",
      "theta",
      "node_ux",
      "node_uy",
      "opening",
      "slip",
      "damage",
      "crushing",
      "compression",
      "shear",
      "eccentricity",
      "zone_greater",
      "zone_smaller",
      "link_force",
      ...kCarried.map((name) => `section_${name}`),
    ])
      if (bundle.has(`frame.${name}`)) this.arrays[name] = bundle.array(`frame.${name}`);
    this.hasForces = "compression" in this.arrays && this.arrays.compression.length > 0;
    this.hasZoneStress = "zone_greater" in this.arrays && this.arrays.zone_greater.length > 0;
    if (this.count > 0) this.makeRoom();
  }
  // Fallen blocks must be visible: the view grows to their places in the last frame. It grows by
  // no more than the wall's own size, or a single block far away would shrink the wall to a dot.
  private makeRoom(): void {
    const { wall } = this,
      { bounds } = wall,
      { x0, x1, y0, y1 } = bounds;
    const most = Math.max(x1 - x0, y1 - y0),
      pose = new Pose(wall, this.at(this.count - 1), 1);
    for (let b = 0; b < wall.blocks; ++b)
      for (let i = wall.outlineBegin[b]; i < wall.outlineBegin[b + 1]; ++i) {
        const [x, y] = pose.corner(b, i);
        bounds.x0 = Math.min(bounds.x0, Math.max(x, x0 - most));
        bounds.x1 = Math.max(bounds.x1, Math.min(x, x1 + most));
        bounds.y0 = Math.min(bounds.y0, Math.max(y, y0 - most));
        bounds.y1 = Math.max(bounds.y1, Math.min(y, y1 + most));
      }
  }
  private slice(name: string, frame: number, n: number): Numbers {
    return this.arrays[name].subarray(frame * n, (frame + 1) * n);
  }
  at(frame: number): Frame {
    const { blocks, joints } = this.wall;
    const joint = (name: string): Numbers => this.slice(name, frame, joints);
    const nodes = this.wall.mesh?.nodeX.length ?? 0,
      zones = this.hasZoneStress ? this.wall.mesh!.zone.length / 4 : 0;
    return {
      ux: this.slice("ux", frame, blocks),
      uy: this.slice("uy", frame, blocks),
      theta: this.slice("theta", frame, blocks),
      nodeUx: nodes > 0 ? this.slice("node_ux", frame, nodes) : null,
      nodeUy: nodes > 0 ? this.slice("node_uy", frame, nodes) : null,
      opening: joint("opening"),
      slip: joint("slip"),
      damage: joint("damage"),
      crushing: joint("crushing"),
      compression: this.hasForces ? joint("compression") : null,
      shear: this.hasForces ? joint("shear") : null,
      eccentricity: this.hasForces ? joint("eccentricity") : null,
      greater: zones > 0 ? this.slice("zone_greater", frame, zones) : null,
      smaller: zones > 0 ? this.slice("zone_smaller", frame, zones) : null,
      linkForce: "link_force" in this.arrays ? this.slice("link_force", frame, this.wall.links.length) : null,
    };
  }
  carried(what: Carried, frame: number): Numbers {
    return this.slice(`section_${what}`, frame, this.wall.sections.length);
  }
}
// Where blocks are.
export interface Places {
  ux: Numbers;
  uy: Numbers;
  theta: Numbers;
  nodeUx: Numbers | null;
  nodeUy: Numbers | null;
}
export interface Frame extends Places {
  opening: Numbers;
  slip: Numbers;
  damage: Numbers;
  crushing: Numbers; // [m], [m], 0-255, 0-255
  compression: Numbers | null;
  shear: Numbers | null;
  eccentricity: Numbers | null; // [N], [N], -1 to 1
  greater: Numbers | null; // principal stresses of zones, tension positive [Pa]
  smaller: Numbers | null;
  linkForce: Numbers | null; // tension + [N]
}

const kQuarter = Math.PI / 2;
// Poses of all blocks at a magnification: centroid, cosine and sine.
export class BlockPose {
  readonly x: Float64Array;
  readonly y: Float64Array;
  readonly c: Float64Array;
  readonly s: Float64Array;
  constructor(
    readonly wall: Blocks,
    readonly frame: Places,
    readonly scale: number,
  ) {
    const n = wall.blocks;
    this.x = new Float64Array(n);
    this.y = new Float64Array(n);
    this.c = new Float64Array(n);
    this.s = new Float64Array(n);
    for (let b = 0; b < n; ++b) {
      const theta = frame.theta[b];
      // up to a quarter turn rotations are magnified; beyond, blocks would spin
      const turn =
        Math.abs(theta) > kQuarter ? theta : Math.min(kQuarter, Math.max(-kQuarter, theta * scale));
      this.c[b] = Math.cos(turn);
      this.s[b] = Math.sin(turn);
      this.x[b] = wall.centroidX[b] + scale * frame.ux[b];
      this.y[b] = wall.centroidY[b] + scale * frame.uy[b];
    }
  }
  // Present place of corner i of the outlines, which belongs to block b.
  corner(b: number, i: number): [number, number] {
    const mesh = this.wall.mesh;
    if (mesh && b >= mesh.rigid) return this.node(mesh, mesh.rim[i - this.wall.outlineBegin[mesh.rigid]]);
    const ax = this.wall.outlineX[i] - this.wall.centroidX[b],
      ay = this.wall.outlineY[i] - this.wall.centroidY[b];
    return [this.x[b] + this.c[b] * ax - this.s[b] * ay, this.y[b] + this.s[b] * ax + this.c[b] * ay];
  }
  node(mesh: Mesh, n: number): [number, number] {
    const { nodeUx, nodeUy } = this.frame;
    return [
      mesh.nodeX[n] + this.scale * (nodeUx ? nodeUx[n] : 0),
      mesh.nodeY[n] + this.scale * (nodeUy ? nodeUy[n] : 0),
    ];
  }
}

// The same with what lies between blocks.
export class Pose extends BlockPose {
  declare readonly wall: Wall;
  declare readonly frame: Frame;
  constructor(wall: Wall, frame: Frame, scale: number) {
    super(wall, frame, scale);
  }
  // Both ends of a link; for a spring both are where it holds its block.
  link(l: Link): [[number, number], [number, number]] {
    const of = (b: number, [x, y]: [number, number]): [number, number] => [
      this.x[b] + this.c[b] * x - this.s[b] * y,
      this.y[b] + this.s[b] * x + this.c[b] * y,
    ];
    const end = of(l.b, l.arm_b);
    if (l.kind === "spring") return [end, end];
    if (l.a >= 0) return [of(l.a, l.arm_a), end];
    const { centroidX, centroidY } = this.wall;
    return [[centroidX[l.b] + l.arm_b[0] - l.along[0], centroidY[l.b] + l.arm_b[1] - l.along[1]], end];
  }
  private contact(mesh: Mesh, c: number, xi: number): [number, number] {
    const [px, py] = this.node(mesh, mesh.contactP[c]),
      [qx, qy] = this.node(mesh, mesh.contactQ[c]);
    const share = mesh.share0[c] + 0.5 * (xi + 1) * (mesh.share1[c] - mesh.share0[c]);
    return [px + share * (qx - px), py + share * (qy - py)];
  }
  // A point of a joint, half way between its faces; xi from -1 to 1 along it.
  joint(j: number, xi: number): [number, number] {
    const w = this.wall;
    if (w.mesh && j >= w.mesh.joints) return this.contact(w.mesh, j - w.mesh.joints, xi);
    const a = w.jointA[j],
      b = w.jointB[j];
    const bx = w.armBX[j] + xi * w.halfX[j],
      by = w.armBY[j] + xi * w.halfY[j];
    const x = this.x[b] + this.c[b] * bx - this.s[b] * by,
      y = this.y[b] + this.s[b] * bx + this.c[b] * by;
    if (a < 0) return [(x + w.centroidX[b] + bx) / 2, (y + w.centroidY[b] + by) / 2];
    const ax = w.armAX[j] + xi * w.halfX[j],
      ay = w.armAY[j] + xi * w.halfY[j];
    return [
      (x + this.x[a] + this.c[a] * ax - this.s[a] * ay) / 2,
      (y + this.y[a] + this.s[a] * ax + this.c[a] * ay) / 2,
    ];
  }
}

// Whether a stage cuts this masonry out of the wall; no view shows it.
export const isCutOut = (wall: Blocks, b: number): boolean => wall.role[b] === "cut_out";

// Style of a block that is not masonry, else "".
export const bodyCss = (role: string): string =>
  role === "lintel" || role === "sill" ? "timber" : role === "masonry" ? "" : "plate";

// A round magnification with which the largest displacement is about 5 % of the wall.
export function fittingScale(wall: Blocks, frames: FramedStates, frame = frames.count - 1): number {
  if (frames.count === 0) return 1;
  const { ux, uy } = frames.at(frame);
  let largest = 0;
  for (let b = 0; b < wall.blocks; ++b) largest = Math.max(largest, Math.hypot(ux[b], uy[b]));
  const wanted = 0.05 * Math.hypot(wall.length, wall.height);
  return [1, 2, 5, 10, 20, 50, 100].filter((s) => s === 1 || largest * s <= wanted).pop()!;
}

type FieldMeasure = `field ${number}`; // number of a field
export type Measure = "cracks" | "opening" | "slip" | "damage" | "crushing" | "stress" | FieldMeasure;
type Scalar = Exclude<Measure, "cracks" | "stress" | FieldMeasure>;
export const isField = (measure: Measure): measure is FieldMeasure => measure.startsWith("field ");
// Shows the fields of this sample on a campaign's wall.
export function takeFields(wall: Wall, sample: number): void {
  wall.fields = wall.allFields.filter((f) => f.sample === sample);
}
export const fieldOf = (wall: Wall, measure: FieldMeasure): Field => wall.fields[Number(measure.slice(6))];
export const measuresOf = (frames: Frames): Measure[] => [
  "cracks",
  "opening",
  "slip",
  "damage",
  "crushing",
  ...(frames.hasForces || frames.hasZoneStress ? ["stress" as const] : []),
  ...frames.wall.fields.map((_, i): FieldMeasure => `field ${i}`),
];
// Bounds of the colour steps: millimetres, or shares.
export const kSteps: Record<Scalar, number[]> = {
  opening: [0.05, 0.2, 0.5, 1, 3, 10],
  slip: [0.05, 0.2, 0.5, 1, 3, 10],
  damage: [0.05, 0.25, 0.5, 0.75, 0.9, 0.999],
  crushing: [0.02, 0.1, 0.25, 0.5, 0.75, 0.9],
};
export function valueOf(frame: Frame, j: number, measure: Scalar): number {
  switch (measure) {
    case "opening":
      return frame.opening[j] * 1e3;
    case "slip":
      return Math.abs(frame.slip[j]) * 1e3;
    case "damage":
      return frame.damage[j] / 255;
    case "crushing":
      return frame.crushing[j] / 255;
  }
}
// Index of a colour step: 0 below the first bound; k above the k-th.
export function stepOf(value: number, bounds: number[]): number {
  let k = 0;
  while (k < bounds.length && value >= bounds[k]) ++k;
  return k;
}
// Mean stress across a joint, tension positive [MPa].
export function jointStress(wall: Wall, frame: Frame, j: number): number {
  if (!frame.compression) return 0;
  const area = 2 * Math.hypot(wall.halfX[j], wall.halfY[j]) * wall.blockThickness[wall.jointB[j]];
  return area > 0 ? (-1e-6 * frame.compression[j]) / area : 0;
}
// The principal stress of a zone with the larger absolute value, tension positive [MPa].
export function zoneStress(frame: Frame, z: number): number {
  if (!frame.greater || !frame.smaller) return 0;
  const [a, b] = [frame.greater[z], frame.smaller[z]];
  return 1e-6 * (Math.abs(a) > Math.abs(b) ? a : b);
}
// Bounds of the colour steps of stress [MPa], from the largest value of all frames.
export function stressSteps(wall: Wall, frames: Frames): number[] {
  let largest = 0;
  for (let f = 0; f < frames.count; ++f) {
    const frame = frames.at(f);
    for (let j = 0; j < wall.joints; ++j) largest = Math.max(largest, Math.abs(jointStress(wall, frame, j)));
    const zones = frame.greater?.length ?? 0;
    for (let z = 0; z < zones; ++z) largest = Math.max(largest, Math.abs(zoneStress(frame, z)));
  }
  return roundSteps(largest);
}
// 1, 2, 5 times powers of ten, up to about the largest.
export function roundSteps(largest: number, most = 6): number[] {
  const round = [1, 2, 5].flatMap((m) => Array.from({ length: 19 }, (_, i) => m * 10 ** (i - 9)));
  return round
    .sort((a, b) => a - b)
    .filter((v) => v <= 0.8 * largest)
    .slice(-most);
}

// Forces between blocks: point of action, direction, and share of the largest.
export interface Force {
  from: [number, number];
  to: [number, number];
  share: number;
}
const kLeast = 0.03; // of the largest force; smaller ones are not drawn
export function forcesOf(wall: Wall, frame: Frame, pose: Pose): Force[] {
  const { compression, shear, eccentricity } = frame;
  if (!compression || !shear || !eccentricity) return [];
  const sizes = Array.from({ length: wall.joints }, (_, j) => Math.hypot(compression[j], shear[j]));
  const largest = sizes.reduce((a, b) => Math.max(a, b), 0),
    reach = 0.04 * Math.max(wall.length, wall.height);
  return sizes.flatMap((size, j): Force[] => {
    if (!(size >= kLeast * largest) || !(largest > 0)) return [];
    const half = Math.hypot(wall.halfX[j], wall.halfY[j]);
    const tx = wall.halfX[j] / half,
      ty = wall.halfY[j] / half; // n is on the left of t
    // of side a on side b: compression along n, and the shear force along t
    const fx = -ty * compression[j] - tx * shear[j],
      fy = tx * compression[j] - ty * shear[j];
    const [x, y] = pose.joint(j, eccentricity[j]);
    const share = size / largest,
      long = (0.5 * reach * (0.25 + 0.75 * Math.sqrt(share))) / size;
    return [
      { from: [x - fx * long, y - fy * long], to: [x + fx * long, y + fy * long], share },
    ];
  });
}

const kVisible = 0.05; // smaller openings and slips count as closed [mm]
// The kind of crack of a joint.
export type Crack = "sound" | "softening" | "closed" | "open" | "slip";
export function crackOf(frame: Frame, j: number): Crack {
  const damage = frame.damage[j] / 255;
  if (damage <= 0.012) return "sound";
  if (damage < 0.998) return "softening";
  const opening = frame.opening[j] * 1e3,
    slip = Math.abs(frame.slip[j]) * 1e3;
  if (Math.max(opening, slip) < kVisible) return "closed";
  return opening >= slip ? "open" : "slip";
}
