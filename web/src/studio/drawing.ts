// The wall as the drawing knows it: lengths in metres, y upwards from the wall's base.
import type { Path } from "./file/toml";
import type { Arch } from "./parts/arches";
import type { Diaphragm, Floor } from "./parts/floors";
import type { Frame } from "./parts/frames";
import type { Tie } from "./parts/ties";

export interface Box {
  x: number;
  y: number;
  width: number;
  height: number;
}

export interface Opening extends Box {
  name: string;
  foot: number; // of its storey, from where the file counts its y
  lintel: boolean;
  arch: Arch | null;
}

export interface Storey {
  name: string;
  foot: number;
  height: number;
}

// Courses of equal height, from a storey's foot to its top.
export interface Courses {
  foot: number;
  top: number;
  course: number;
}

export interface Drawing {
  length: number;
  height: number;
  openings: Opening[];
  storeys: Storey[];
  floors: Floor[];
  diaphragms: Diaphragm[];
  ties: Tie[];
  frames: Frame[];
  courses: Courses[]; // of each storey, or of the whole wall
  course: number; // height of one, joint included
  half: number; // half a unit's length, joint included
}

// What may be selected, by its place in the file's list.
export type Kind = "opening" | "storey" | "floor" | "tie";

export interface Selected {
  kind: Kind;
  k: number;
}

const kLists = { opening: "openings", storey: "storeys", floor: "floors", tie: "ties" } as const;

export const countOf = (d: Drawing, kind: Kind): number => d[kLists[kind]].length;

// Where it stands in the file.
export const pathOf = (part: Selected): Path => (part.kind === "opening" ? ["wall", "opening", part.k] : [part.kind, part.k]);

// Why the drawing cannot show a file: a text's key, and where in the file.
export interface Refusal {
  why: string;
  path: Path;
}

// The storey that holds a height: the last whose foot is not above it.
export const storeyAt = (d: Drawing, y: number): Storey | undefined => d.storeys.filter((s) => s.foot <= y + 1e-6).pop();

export const coursesAt = (d: Drawing, y: number): Courses => d.courses.filter((c) => c.foot <= y + 1e-6).pop() ?? d.courses[0];
