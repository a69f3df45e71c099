// The header of every page, with the wall in it (src/report/bundle.cpp, wall_arrays.cpp, space_arrays.cpp).
import type { Load, SolidLink, Vec } from "../wall/space";
import type { Said } from "../base/texts";
import type { Field, Link, Member, MemberSection, Part } from "../wall/wall";

// The place of an array in the bytes.
export interface Place {
  type: "float32" | "int32" | "int16" | "uint8";
  at: number;
  count: number;
  step?: number; // of rounded values
  steps?: number[]; // or one for each of as many equal parts
}

export interface SpaceHead {
  supports: number; // the last of the bodies
  middle: Vec; // [m]
  load: Load | null;
  names: string[];
  materials: string[];
  links?: SolidLink[];
}

export interface WallHead {
  length: number; // [m]
  height: number;
  thickness: number;
  courses: number;
  blocks: number;
  joints: number;
  pairs: number;
  roles?: string[]; // in the order of their numbers; absent in pages of earlier programs
  kinds?: string[];
  bodies?: number; // deformable blocks, the last of them
  nodes?: number;
  zones?: number;
  contacts?: number;
  links?: Link[];
  members?: Member[];
  sections?: MemberSection[];
  storeys?: { name: string; top: number }[]; // [m]
  push?: [number, number];
  load_height?: number; // [m]
  pushed?: { end: number; length: number }[];
  parts?: Omit<Part, "blocks">[];
  fields?: Omit<Field, "values" | "steps">[];
  space?: SpaceHead; // if the wall is not in its plane
}

export interface PageHeader {
  kind: string;
  title?: string;
  arrays: Record<string, Place>;
  names?: Record<string, Said>; // of the parts of the wall
  wall?: WallHead;
  frames?: unknown[]; // states of the wall
}
