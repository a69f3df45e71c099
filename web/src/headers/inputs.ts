// What the user stated and what the model made of it (src/report/model_inputs.cpp).
import type { Said } from "../texts";

export type Shown = number | Said | null; // "unlimited" stands for infinity, null for what is not stated
export type InputRow = [key: string, value: Shown, unit: string];
export type MaterialRow = [key: string, unit: string, cells: Shown[]]; // a cell a material

export interface Opening {
  name: string;
  x: number; // [m]
  y: number;
  width: number;
  height: number;
  lintel: string; // "": none
  lintel_depth_mm: number | null;
  lintel_bearing_mm: number | null;
  arch: string; // "": none
  arch_depth_mm: number | null;
  sill: string; // "": none
  sill_depth_mm: number | null;
}
export interface Storey {
  name: string;
  foot: number; // [m]
  height: number;
  thickness: number;
}
// What lies on the wall, ties it or holds it.
export interface Carried {
  kind: string;
  name: string;
  where: string;
  rows: InputRow[];
}
export interface StageInputs {
  name: string;
  kind: string;
  rows: InputRow[];
}
// Where a value comes from that the file does not give.
export type OriginRow = [
  table: string,
  key: string,
  value: string,
  kind: string,
  by: string,
  inputs: string,
  formula: string,
  source: string,
];
// Notes of one kind, under a line that counts them.
export interface NoteGroup {
  line: Said;
  members: Said[];
}

export interface ModelInputs {
  wall: InputRow[];
  openings: Opening[];
  storeys?: Storey[]; // not in pages of earlier programs, nor the others that may be missing
  carried?: Carried[];
  materials: { names: string[]; rows: MaterialRow[] };
  masonry?: InputRow[];
  origins?: OriginRow[];
  stages: StageInputs[];
  settings: InputRow[];
  notes: (Said | NoteGroup)[];
}
