// statistics.json, as the page of a campaign has it (docs/reference/statistics.md).
import type { Said } from "../base/texts";
import type { Interval, Mass, Maybe, Noted, Project } from "./common";

export type QuantityKey = `${string}_kN` | `${string}_mm`; // "peak_reaction_kN", "initial_stiffness_kN_per_mm"

// --- results ---------------------------------------------------------------------------------------

// In the unit of the quantity's key.
export interface ResponseSummary {
  n: number;
  without_value: number;
  censored?: number; // of lower bounds, for quantities that may have some; also those after "survival"
  mean: Maybe;
  mean_interval: Interval;
  cov: Maybe;
  cov_interval: Interval;
  median: Maybe;
  median_interval: Interval;
  standard_deviation: Maybe;
  min: Maybe;
  max: Maybe;
  percentile_5: Maybe;
  percentile_95: Maybe;
  survival_mean?: Maybe;
  survival_mean_interval?: Interval;
  survival_median?: Maybe;
  survival_median_interval?: Interval;
}
export interface Group {
  modes: string[];
  [quantity: QuantityKey]: ResponseSummary;
}
export interface Share {
  modes: string[];
  count: number;
  share: number;
  share_interval: number[];
}

export interface OfWalls {
  n: number;
  bounds: number;
  median: Maybe;
  median_interval: Interval;
  at_least: Maybe;
}
export interface Walls {
  peak_reaction_kN: OfWalls;
  displacement_at_peak_mm: OfWalls;
  drift_capacity: {
    left: number[];
    n: number[];
    median_mm: Maybe[];
    at_least_mm: Maybe[];
    low_mm: Maybe[];
    high_mm: Maybe[];
    bounds: number[];
  };
}

// By the number of samples; in the unit of the quantity's key.
export interface Running {
  n: number[];
  mean: Maybe[];
  low: Maybe[]; // null for the first few
  high: Maybe[];
}
export interface MeanCurve {
  curves: number;
  n: number[];
  displacement_mm: number[];
  drift_percent: Maybe[]; // null where the load's height is not known
  reaction_mean_kN: number[];
  reaction_standard_deviation_kN: Maybe[];
  reaction_5_percent_kN: number[];
  reaction_95_percent_kN: number[];
}
export interface Exceedance {
  n: number;
  censored: number;
  [value: `value_${string}`]: number[]; // by the quantity, as "value_mm"
  probability: number[];
  low: number[];
  high: number[];
  lognormal: { [median: `median_${string}`]: Maybe | Interval; beta: Maybe; misfit: Maybe };
}
export interface Precision {
  what: string; // a quantity's key, or "share"
  half_width_asked: number;
  half_width_now: Maybe;
  first_met_at: Maybe; // samples
  held_from: Maybe;
  expected_at: Maybe;
}
export interface DriftLimit {
  element: string;
  mechanism: string;
  label: string;
  state: string;
  clause: string;
  limit_drift_percent: number;
  below: number;
  unknown: number;
  share_below: Maybe;
  share_below_interval: Interval;
  share_below_is_lower_bound: boolean;
}
export interface NameSensitivity {
  reading: Said;
  n: number;
  differs: number;
  share: Maybe;
  share_interval: Interval;
}
export interface Flag {
  element: string;
  measure: string;
  threshold: Maybe;
  unit: string;
  n: number;
  raised: number;
  share: Maybe;
  share_interval: Interval;
}

// --- inputs and results ----------------------------------------------------------------------------

export interface InputSummary {
  name: string;
  unit: string;
  random: boolean;
  mean: Maybe;
  cov: Maybe;
  min: Maybe;
  max: Maybe;
}
export type Rank = "pearson" | "spearman" | "partial_rank";
export type Correlation = {
  group: string;
  response: string;
  input: string;
  n: number;
  censored: number;
} & { [rank in Rank]: Maybe } & { [rank in `${Rank}_interval`]: Interval };
export interface FirstOrder {
  response: string;
  input: string;
  bins: number;
  index: Maybe;
  index_interval: Interval;
  entangled_with: string[];
}
export interface ModeBin {
  n: number;
  low: number; // of the input, in its unit
  high: number;
  mean: Maybe;
  share: Record<string, { share: number; share_interval: number[] }>;
}
export interface ModeAgainstInput {
  input: string;
  unit: string;
  bins: ModeBin[];
}

export interface Fit {
  law: string;
  slope: Maybe;
  half_at: Maybe; // of the input, in its unit
  half_at_interval: Interval;
  influence_p: Maybe;
  fit_p: Maybe;
}
export interface FragilityInput {
  input: string;
  unit: string;
  verdict: string;
  entangled_with: string[];
  parted_between?: Interval;
  fits: Fit[];
  curve?: { law: string; input: number[]; probability: number[]; low: number[]; high: number[] };
}
export interface FragilityPair {
  inputs: [string, string];
  verdict: string;
  intercept?: Maybe; // of log-odds; either all of these exist, or none
  slope_1?: Maybe;
  slope_2?: Maybe;
  added_p?: Maybe;
  fit_p?: Maybe;
}
// The probability of an event, for pushed walls.
export interface Fragility {
  response: string;
  mode?: string; // or a threshold in `unit`
  greater_than?: Maybe;
  unit?: string;
  n: number;
  seen: number;
  unknown: number;
  repeated: number;
  not_slow_enough: number;
  lost: number;
  share: Maybe;
  share_interval: Interval;
  sample: number[];
  outcome: number[]; // 1, 0; between: unknown
  inputs: FragilityInput[];
  pairs: FragilityPair[];
}
export interface Measuring {
  response: string;
  input: string;
  n: number;
  censored: number;
  variance_share: Maybe;
  variance_share_interval: Interval;
  width_share: Maybe;
  width_share_interval: Interval;
  is_best: Maybe;
}
export interface SurrogateIndices {
  response: string;
  verdict: string;
  n: number;
  q2: Maybe;
  q2_asked: number;
  terms: number;
  inputs: {
    input: string;
    first_order: Maybe;
    first_order_interval: Interval;
    total: Maybe;
    total_interval: Interval;
  }[];
}

// --- walls under records ---------------------------------------------------------------------------

// The end of a key for the study's measure: of each pair of keys the page has only that one.
export type IntensityUnit = "_m_per_s" | "_m_per_s2";
type ByUnit<Name extends string, Value> = { [key in `${Name}${IntensityUnit}`]: Value };

export type ScatterPart = "record_to_record" | "wall_to_wall" | "rest";
export type Scatter = { verdict: string; records: number; walls: number; bracket?: Maybe } & {
  [part in ScatterPart]?: Maybe; // either all of these exist, or none
} & { [part in `${ScatterPart}_interval`]?: Interval };

export interface ShakenCount extends ByUnit<"intensity", number> {
  n: number;
  reached: number;
  lost: number;
  share: Maybe;
  share_interval: Interval;
}
// Statistics of reaching a limit state; without a result there are only counts.
export interface ShakenFragility
  extends Partial<ByUnit<"median", Maybe>>,
    Partial<ByMedianInterval>,
    Partial<ByUnit<"median_if_lost", { reached: Maybe; not_reached: Maybe }>> {
  limit_state: string;
  verdict: string;
  n: number;
  reached: number;
  lost: number;
  came_back: number;
  beta?: Maybe;
  beta_interval?: Interval;
  interval_by?: string;
  curve?: ByUnit<"intensity", number[]> & { probability: number[]; low: Interval; high: Interval };
  counts: ShakenCount[];
  scatter: Scatter;
}
type ByMedianInterval = { [key in `median${IntensityUnit}_interval`]: Interval };

export interface ShakenIntensity extends ByUnit<"intensity", number> {
  n: number;
  collapsed: number;
  lost: number;
  drift_percent_16: Maybe;
  drift_percent_50: Maybe;
  drift_percent_84: Maybe;
}
export interface LostShake extends ByUnit<"intensity", Maybe> {
  sample: number;
  status: string;
  reason: string;
}
export interface ShakingStatistics {
  records: number;
  walls: number;
  samples: number;
  shakes: number;
  stood: number;
  collapsed: number;
  lost: LostShake[];
  damping_of_shakes?: Said[];
  measure?: string; // of the response over intensities
  period_s?: Maybe;
  damping?: Maybe;
  intensities: ShakenIntensity[];
}

// --- assessment ------------------------------------------------------------------------------------

// Over peak ground acceleration.
export interface PgaFragility {
  limit_state: string;
  is_checked: boolean;
  n: number;
  censored: number;
  median_pga_g: Maybe;
  median_pga_g_interval: Interval;
  beta_capacity: Maybe;
  beta_capacity_interval: Interval;
  beta: Maybe;
  demand_pga_g: Maybe;
  probability_at_demand: Maybe;
  probability_at_demand_interval: Interval;
  curve: { pga_g: number[]; probability: number[]; low: Maybe[]; high: Maybe[] };
  samples: { pga_g: number[]; share_reached: number[] };
}
export interface CampaignAssessment extends Noted {
  code: string;
  limit_state: string;
  record_scatter: Maybe;
  answered: number;
  without_answer: number;
  not_to_be_signed: number;
  mass: Mass;
  sentence: Said;
  cautions: Said[];
  reason: Said; // "": there is a result
  limit_states: PgaFragility[];
}

export interface Statistics {
  study: string;
  design: string;
  seed: number;
  project?: Project;
  samples: {
    asked: number;
    run: number;
    answered: number;
    still_rising: number;
    named_earlier: number;
    unanswered: { sample: number; status: string; reason: Said }[];
  };
  load_height_m: Maybe;
  read_modes_at_mm: Maybe;
  inputs: InputSummary[];
  input_correlation: { a: string; b: string; spearman: Maybe }[];
  modes: string[];
  table: Record<string, Group>;
  shares: Record<string, Share>;
  walls?: Walls; // not in pages of earlier programs
  name_sensitivity: NameSensitivity[];
  flags: Flag[];
  precision: Precision[];
  drift_limits: DriftLimit[];
  correlation: Correlation[];
  first_order: FirstOrder[];
  mode_against_input: ModeAgainstInput[];
  fragility?: Fragility[] | ShakenFragility[]; // the second for walls under records
  shaking?: ShakingStatistics;
  assessment?: CampaignAssessment;
  measuring?: Measuring[];
  surrogate_indices?: SurrogateIndices[];
  running: Record<string, Running>; // by the quantity's key
  mean_curves: Record<string, MeanCurve>; // by the group
  exceedance: Record<string, Exceedance>; // by the quantity's key
}
