// The user's inputs and the values that the model derived (src/report/model_inputs.cpp).
import type { Said } from "../base/texts";

export type Shown = number | Said | null; // "unlimited" stands for infinity, null for an input that is not given
export type InputRow = [key: string, value: Shown, unit: string];
export type MaterialRow = [key: string, unit: string, cells: Shown[]]; // one cell for each material

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
// Loads on the wall, ties and restraints.
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
// The origin of a value that the file does not give.
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
  storeys?: Storey[]; // absent in pages of earlier programs, like the other optional members
  carried?: Carried[];
  materials: { names: string[]; rows: MaterialRow[] };
  masonry?: InputRow[];
  origins?: OriginRow[];
  stages: StageInputs[];
  settings: InputRow[];
  notes: (Said | NoteGroup)[];
}
