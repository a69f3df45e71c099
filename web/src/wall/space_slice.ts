// A wall in space cut along the plane of one of its frames: the outlines that the cut makes, and how they move within
// that plane. So what the frame carries is drawn as in a plane wall.
//
//      up ^   ______                each part of a body that the plane meets is one block of the slice
//         |  |__|___|   <- slice
//         o---------> along
import type { Bundle, Numbers } from "../base/bundle";
import { dot, type SolidStates, type Solids, type Vec } from "./space";
import { kCarried, type Blocks, type Carried, type FramedStates, type Places } from "./wall";

const kBeside = 1e-3; // from the plane to the cut, so that it lies in no face between two leaves [m]

const minus = (a: Vec, b: Vec): Vec => [a[0] - b[0], a[1] - b[1], a[2] - b[2]];
const across = ([ax, ay, az]: Vec, [bx, by, bz]: Vec): Vec => [ay * bz - az * by, az * bx - ax * bz, ax * by - ay * bx];
const at = (of: Numbers, k: number): Vec => [of[3 * k], of[3 * k + 1], of[3 * k + 2]];

// The plane of a frame: a place in it, two directions in it and the one across it.
interface Plane {
  from: Vec;
  along: Vec;
  up: Vec;
  normal: Vec;
}

// Corners in order of the convex outline that a plane cuts out of a part; none where it misses.
function outlineIn(s: Solids, part: number, { from, along, up, normal }: Plane): [number, number][] {
  const vertex = (i: number): Vec => minus(at(s.vertex, s.vertexBegin[part] + i), from);
  const met: [number, number][] = [];
  for (let f = s.faceBegin[part]; f < s.faceBegin[part + 1]; ++f)
    for (let c = s.cornerBegin[f], last = s.cornerBegin[f + 1] - 1, before = last; c <= last; before = c++) {
      const p = vertex(s.corner[before]),
        q = vertex(s.corner[c]);
      const hp = dot(p, normal) - kBeside,
        hq = dot(q, normal) - kBeside;
      // each edge is met from both of its faces: of the two ways one counts
      if (!(hp > 0 && hq <= 0)) continue;
      const share = hp / (hp - hq);
      met.push([dot(p, along) + share * (dot(q, along) - dot(p, along)), dot(p, up) + share * (dot(q, up) - dot(p, up))]);
    }
  const [mx, my] = [0, 1].map((k) => met.reduce((sum, p) => sum + p[k], 0) / met.length);
  return met.sort((p, q) => Math.atan2(p[1] - my, p[0] - mx) - Math.atan2(q[1] - my, q[0] - mx));
}

// A large wall has more numbers than a call may have arguments.
function extent(numbers: number[]): number {
  let low = Infinity,
    high = -Infinity;
  for (const x of numbers) (low = Math.min(low, x)), (high = Math.max(high, x));
  return high - low;
}

export class SliceStates implements FramedStates {
  readonly count: number;
  readonly wall: Blocks;
  private readonly body: number[] = []; // of each block of the slice
  private readonly plane: Plane;
  private readonly known = new Map<number, Places>();
  private readonly values: Record<Carried, Numbers>;

  constructor(
    bundle: Bundle,
    private readonly states: SolidStates,
    frame: string,
  ) {
    this.count = states.count;
    const values = kCarried.map((what) => [what, bundle.array(`frame.section_${what}`)]);
    this.values = Object.fromEntries(values) as Record<Carried, Numbers>;
    const { members = [], sections = [], roles = [] } = bundle.header.wall!,
      s = states.solids;
    const first = sections.find((section) => members[section.member].frame === frame)!,
      { along, up } = members[first.member];
    this.plane = { from: at(s.centroid, first.b), along: along!, up: up!, normal: across(along!, up!) };
    const role = bundle.array("space.role");
    const begin = [0],
      x: number[] = [],
      y: number[] = [];
    for (let b = 0; b < s.free; ++b)
      for (let part = s.partBegin[b]; part < s.partBegin[b + 1]; ++part) {
        const outline = outlineIn(s, part, this.plane);
        if (outline.length < 3) continue;
        for (const [px, py] of outline) x.push(px), y.push(py);
        begin.push(x.length);
        this.body.push(b);
      }
    // a segment is one part, and the plane of another frame may miss it
    const block = (body: number): number => this.body.indexOf(body);
    this.wall = {
      members,
      sections: sections.map((section) => ({ ...section, a: block(section.a), b: block(section.b) })),
      length: extent(x),
      height: extent(y),
      blocks: this.body.length,
      outlineBegin: Int32Array.from(begin),
      outlineX: Float32Array.from(x),
      outlineY: Float32Array.from(y),
      centroidX: Float32Array.from(this.inPlane(s.centroid, this.plane.along, this.plane.from)),
      centroidY: Float32Array.from(this.inPlane(s.centroid, this.plane.up, this.plane.from)),
      role: this.body.map((b) => roles[role[b]]),
      mesh: null,
    };
  }
  // Of each block the part along `way` of its body's numbers.
  private inPlane(of: Numbers, way: Vec, from: Vec = [0, 0, 0]): number[] {
    return this.body.map((b) => dot(minus(at(of, b), from), way));
  }
  at(frame: number): Places {
    let places = this.known.get(frame);
    if (!places) {
      const { moved, turned } = this.states.at(frame),
        { along, up, normal } = this.plane;
      places = {
        ux: Float32Array.from(this.inPlane(moved, along)),
        uy: Float32Array.from(this.inPlane(moved, up)),
        theta: Float32Array.from(this.inPlane(turned, normal)),
        nodeUx: null,
        nodeUy: null,
      };
      this.known.set(frame, places);
    }
    return places;
  }
  carried(what: Carried, frame: number): Numbers {
    const n = this.wall.sections.length;
    return this.values[what].subarray(frame * n, (frame + 1) * n);
  }
}

// Whether a page has what frames carry, in each state.
export const hasCarried = (bundle: Bundle): boolean =>
  (bundle.header.wall?.members ?? []).length > 0 && kCarried.every((what) => bundle.has(`frame.section_${what}`));
