// The assessment of one wall by a code: `assessment` of a run's summary (src/io/results/assessment_json.cpp).
import type { Said } from "../base/texts";
import type { Bilinear, Mass, Maybe, Noted } from "./common";

export interface Spectrum {
  kind: string;
  ground_acceleration_g: number;
  pga_g: number;
  soil_factor: Maybe;
  topography: Maybe;
  eta: number;
  amplification: Maybe;
  TB_s: number;
  TC_s: number;
  TD_s: number;
  period_s: number[];
  acceleration_g: number[];
  displacement_mm: number[];
}

export interface Criterion {
  name: string;
  words: Said;
  clause: string;
  verified: boolean; // checked against the code's text
  value: Maybe; // in `unit`
  unit: string;
  displacement_mm: Maybe;
  reached: boolean;
  governs: boolean;
}

export interface LimitStateCheck {
  state: string;
  is_checked: boolean;
  verdict: string;
  displacement_mm: Maybe;
  drift_percent: Maybe;
  at_least: boolean; // the push ended before
  governing: string; // name of a criterion
  capacity_over_demand: Maybe;
  spectrum_factor: Maybe;
  pga_g: Maybe;
  ground_acceleration_g: Maybe;
  demand_pga_g: Maybe;
  demand_displacement_mm: Maybe;
  q: Maybe;
  criteria: Criterion[];
}

// The system with one degree of freedom.
export interface Equivalent {
  mass_kg: number;
  participation_factor: number;
  force_kN: number;
  yield_displacement_mm: number;
  ultimate_displacement_mm: number;
  acceleration_g: number;
  period_s: number;
}

export interface Demand {
  q: number;
  elastic_displacement_mm: number;
  equivalent_displacement_mm: number;
  displacement_mm: number; // of the control point
}

interface Asked extends Noted {
  verdict: string;
  may_be_signed: boolean;
  sentence: Said;
  cautions: Said[];
  reason: Said;
  code: string;
  limit_state: string;
  confidence_factor: number;
  masonry_share: number;
  spectrum?: Spectrum; // absent if no demand is given
}

export interface Judged extends Asked {
  decides?: string;
  mass: Mass;
  bilinear: Bilinear;
  equivalent: Equivalent;
  demand?: Demand;
  limit_states: LimitStateCheck[];
}
// The code gives no result: `reason` says why.
export interface Unjudged extends Asked {
  decides?: undefined;
  mass?: undefined;
  bilinear?: undefined;
  equivalent?: undefined;
  demand?: undefined;
  limit_states?: undefined;
}
export type Assessment = Judged | Unjudged;
