// The header of the page of a run: run_data() and summary.json (docs/reference/results.md).
import type { Said } from "../base/texts";
import type { Assessment } from "./assessment";
import type { Bilinear, Made, Maybe, Project } from "./common";
import type { ModelInputs } from "./inputs";
import type { PageHeader } from "./page";
import type { Responses } from "./responses";

// --- summary ---------------------------------------------------------------------------------------

// Arrays of equal length, by the remaining share of the peak.
export interface DriftCapacity {
  left: number[];
  first_mm: Maybe[];
  lasting_mm: Maybe[];
  last_mm: Maybe[];
  lasting_drift_percent: Maybe[];
  censored_first: boolean[];
  censored_last: boolean[];
  censored: boolean[];
  lasts_percent: number;
  threshold_decides: boolean | null;
  dips: Dip[];
}
export interface Dip {
  left: number;
  from_mm: number;
  back_mm: number;
  lowest_left: number;
  before_peak: boolean;
}

// One direction of a cyclic push.
export interface Direction {
  peak_reaction_kN: Maybe;
  displacement_at_peak_mm: Maybe;
  displacement_at_80_percent_mm: Maybe;
  censored_80: boolean;
  displacement_max_mm: Maybe;
  censored_max: boolean;
  initial_stiffness_kN_per_mm: Maybe;
  drift_capacity: DriftCapacity;
  bilinear: Bilinear;
  envelope: { displacement_mm: number[]; reaction_kN: number[] };
}
export interface Cycle {
  kind: string;
  displacement_max_mm: Maybe;
  displacement_min_mm: Maybe;
  reaction_max_kN: Maybe;
  reaction_min_kN: Maybe;
  in_balance: boolean;
  residual_max_mm: Maybe;
  residual_min_mm: Maybe;
  stiffness_kN_per_mm: Maybe;
  dissipated_J: Maybe;
  drag_J: Maybe;
  damping_ratio: Maybe;
  repeat: number;
  strength_kept: Maybe;
}
export interface Cyclic {
  read_in: "positive" | "negative";
  positive: Direction;
  negative: Direction;
  cycles: Cycle[];
  work_J: number;
}

// A measure of a part and its threshold.
export interface Measured {
  element: string;
  measure: string;
  value: number;
  threshold: number;
  unit: string;
  margin: number; // beyond the threshold, as a share of it
}
export interface Sign {
  state: string;
  holds: boolean;
  measure: string;
  value: number;
  threshold: number;
  unit: string;
  displacement_first_mm: Maybe;
}
export interface Element {
  element: string;
  kind: string;
  mark: string;
  storey: number;
  state: string;
  displacement_first_mm: Maybe;
  signs: Sign[];
}
export interface FailureMode {
  name: string;
  sentence: Said;
  read_at_mm: Maybe;
  reading: Said;
  scores: Record<string, number>;
  evidence: Measured[];
  elements: Element[];
  flags: (Measured & { raised: boolean })[];
  sensitivity: { what: Said; name: string }[];
}

// [J]
export interface Energy {
  loads: number;
  drive: number;
  kinetic: number;
  elastic: number;
  friction: number;
  fracture: number;
  crushing: number;
  damping: number;
  gap: number;
  gap_ratio: Maybe;
}

// Whether a slow push would give the same result.
export interface SlowPush {
  verdict: string;
  reason: Said;
}
// `judgement` is absent in results of earlier programs.
export type QuasiStatic = Omit<Responses["quasi_static"], "judgement"> & { judgement?: string; displacement?: SlowPush; mode?: SlowPush };

export interface Event {
  name: Said;
  displacement_mm: Maybe;
  reaction_kN: Maybe;
  where: Said;
}
export interface StageReport {
  name: string;
  time_s: number;
  steps: number;
  unbalance_ratio: Maybe;
  settled: boolean;
}

export interface ShakenPoint {
  name: string;
  height_m: number;
  peak_displacement_mm: Maybe;
  peak_at_s: Maybe;
  residual_displacement_mm: Maybe;
}
export interface ShakenStorey {
  name: string;
  height_m: number;
  peak_drift_percent: Maybe;
  peak_at_s: Maybe;
  residual_drift_percent: Maybe;
}
export interface AppliedRecord {
  record: string;
  pga_g: number;
  pgv_mm_per_s: number;
  arias_m_per_s: number;
  duration_s: number;
  factor: number;
}
export interface Shaking {
  collapsed: boolean;
  collapse_time_s: Maybe;
  peak_drift_percent: Maybe;
  residual_drift_percent: Maybe;
  peak_base_shear_kN: Maybe;
  largest_opening_mm: Maybe;
  largest_slip_mm: Maybe;
  points: ShakenPoint[];
  storeys?: ShakenStorey[]; // absent in results of earlier programs
  records: AppliedRecord[];
  sentence: Said;
}

export interface Summary extends Omit<Responses, "quasi_static"> {
  status: string;
  reason: Said;
  warning: Said;
  project?: Project;
  drift_capacity: DriftCapacity;
  load_factor: number; // 0: not a load that grows
  assessment?: Assessment;
  cyclic?: Cyclic;
  shaking?: Shaking;
  failure_mode: FailureMode;
  energy_J: Energy;
  quasi_static: QuasiStatic;
  validity: { overlap_lost_at_mm: Maybe; joints: number; where: Said };
  events: Event[];
  stages: StageReport[];
  blocks: number;
  joints: number;
  points: number;
  steps: number;
  time_step_s: number;
  wall_seconds: number;
  state_hash: string;
  provenance: Made & { build_type: string; spec_hash: string };
}

// --- header ----------------------------------------------------------------------------------------

export interface RunFrame {
  labels: Said[]; // "peak", "20 mm"; empty for states between
  displacement_mm: number;
  reaction_kN: number;
  time_s?: number; // of a shake, since its beginning
}

export interface RunHeader extends PageHeader {
  kind: "run";
  title: string;
  note: string;
  weight_kN: number;
  summary: Summary;
  mode: { words: Said; sentence: Said; brief: Said; mechanism: Said; lists_parts: boolean };
  frames_said?: { name: string; words: Said }[];
  layers_said?: Said[];
  inputs: ModelInputs;
  model_text: string;
  frames: RunFrame[];
  energy: Energy[]; // of each frame, since the start of the run
  forces?: { elements: string[]; displacement_mm: number[] }; // of piers and spandrels
}
