// The header of the page of a limit analysis: limit_data() and mechanisms.json (docs/reference/limit.md).
import type { Mechanism } from "../limit/mechanism";
import type { Said } from "../base/texts";
import type { Made, Maybe } from "./common";
import type { ModelInputs } from "./inputs";
import type { PageHeader } from "./page";

// Numbers of a load: forces as NAME_kN, load factors as NAME.
type LoadUnder<Name extends string> = { [key in Name | `${Name}_kN`]?: Maybe };

export interface LimitLoad extends LoadUnder<"static" | "kinematic"> {
  name: string;
  joints: string;
  friction: string;
  crushing: string;
  gap: number;
  accuracy: Maybe;
  rows: number;
  columns: number;
  tangents: number;
  seconds: number;
  velocity_x: number[]; // of blocks, per unit velocity of the load
  velocity_y: number[];
  spin_per_m: number[];
  velocity_z?: number[]; // in space, as the other two
  spin_x_per_m?: number[];
  spin_y_per_m?: number[];
}

export interface Bound extends LoadUnder<"peak" | "bound"> {
  run: string;
  allowance: number;
  holds: boolean;
}
export interface Bracket extends LoadUnder<"low" | "high" | "least_peak" | "most_peak"> {
  runs: number;
  below: number;
  above: number;
  nominal: boolean;
}

// Curves of runs with the same failure, at equal displacement; pages of earlier programs have no percentiles.
export interface Envelope {
  displacement_mm: number[];
  low_kN: number[];
  percentile_5_kN?: number[];
  mean_kN: number[];
  percentile_95_kN?: number[];
  high_kN: number[];
}
export interface OpinionOnRuns {
  with: string;
  runs: number;
  groups: {
    mode: string;
    mechanism: string;
    runs: number;
    mean_peak_kN: Maybe;
    mean_peak_ratio: Maybe;
    mean_post_peak_gap_kN: Maybe;
    mean_post_peak_gap_share_of_peak: Maybe;
  }[];
  bounds: Bound[];
  without_bound?: { run: string; why: string }[];
  bracket?: Bracket | null;
  curves: {
    run: string;
    mode: string;
    mechanism: string;
    peak_ratio: Maybe;
    post_peak_gap_kN: Maybe;
    post_peak_gap_share_of_peak: Maybe;
  }[];
  curve?: { displacement_mm: number[]; force_kN: number[] }; // of a single run
  envelopes?: Record<string, Envelope>; // by failure mode
}

// A mechanism with numbers for a code.
export interface MechanismAssessment {
  clause: string;
  alpha0: Maybe;
  alpha0_by_weights: Maybe;
  participating_mass_kg: Maybe;
  participating_mass_share: Maybe;
  acceleration0_m_per_s2: Maybe;
  displacement0_mm: Maybe;
  life_safety_displacement_mm: Maybe;
  near_collapse_displacement_mm: Maybe;
  spectral_displacement0_mm: Maybe;
  life_safety_spectral_displacement_mm: Maybe;
  near_collapse_spectral_displacement_mm: Maybe;
}

export interface LocalState {
  limit_state: string;
  verdict: string;
  pga_demand_g: Maybe;
  pga_capacity_g: Maybe;
  acceleration_demand_m_per_s2: Maybe;
  q: Maybe;
  capacity_over_demand_by_q: Maybe;
  displacement_mm: Maybe;
  secant_period_s: Maybe;
  displacement_demand_mm: Maybe;
  capacity_over_demand_by_displacement: Maybe;
  by_onset: boolean;
}
// A part that falls on its face.
export interface LocalPart {
  name: string;
  by: string; // "part", "found", or the kind of hold
  clause: string;
  may_be_signed: boolean;
  sentence: Said;
  notes: Said[];
  foot_m: Maybe;
  head_m: Maybe;
  hinge_m: Maybe;
  inset_mm: Maybe;
  masonry_kN: Maybe;
  floors_kN: Maybe;
  alpha0: Maybe;
  participating_mass_kg: Maybe;
  participating_mass_share: Maybe;
  confidence_factor: Maybe;
  acceleration0_m_per_s2: Maybe;
  acceleration0_to_the_end_m_per_s2: Maybe;
  displacement0_mm: Maybe;
  displacement0_of_top_mm: Maybe;
  slides_off_mm: Maybe;
  limit_states: LocalState[];
}

export interface Opinion {
  mechanisms: Mechanism[];
  local?: LocalPart[]; // absent in pages of earlier programs
  limit_loads: LimitLoad[];
  refused?: { what: Said; why: string }[];
  notes?: Said[];
  comparison: OpinionOnRuns | null;
}

export interface LimitHeader extends PageHeader {
  kind: "limit";
  title: string;
  note: string;
  opinion: Opinion;
  inputs: ModelInputs;
  model_text: string;
  provenance: Made;
}
