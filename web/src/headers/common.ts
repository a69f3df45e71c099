// Parts of several headers: numbers that may be unknown, project data, systems with one degree of freedom.
import type { Said } from "../base/texts";
import type { Responses } from "./responses";

export type Maybe = number | null; // null: not known, or without a limit
export type Interval = Maybe[]; // low and high; an open end is null

// Only the entries that the model file has.
export interface Project {
  title?: string;
  client?: string;
  author?: string;
  date?: string;
  place?: string;
}

export interface Made {
  version: string;
  commit: string;
  compiler: string;
  flags: string;
}

export type Bilinear = Responses["bilinear"];

export interface Mass {
  blocks_kg: number;
  loads_kg: number;
  added_kg: number;
  total_kg: number;
  participating_kg: number;
  participation_factor: number;
  shape: "linear" | "displacements";
  shape_read_at_mm: Maybe;
}

// Effects that a code does not cover, and the basis of its numbers.
export interface Noted {
  notes: Said[];
}
