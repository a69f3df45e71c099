// The header of the page of a campaign: campaign_data().
import type { Said } from "../base/texts";
import type { Maybe } from "./common";
import type { ModelInputs } from "./inputs";
import type { PageHeader } from "./page";
import type { QuantityKey, Statistics } from "./statistics";

export interface StudyInput {
  name: string;
  title: string;
  unit: string;
  path: string;
  random: boolean;
  distribution?: string; // or a formula, or neither
  formula?: string;
  density: { x: number[]; y: number[] } | null;
}

// Members after `rows` exist only for answered samples.
export interface SampleHead {
  sample: number;
  status: string;
  reason: Said;
  answered: boolean;
  rows: number; // of its curve
  mode?: string;
  sentence?: Said;
  read_at_mm?: Maybe;
  read_early?: boolean;
  still_rising?: boolean;
  response?: Maybe[]; // in the order of the header's quantities, in their units
  censored?: boolean[];
  verdict?: Said;
  judgement?: string;
  state_hash?: string;
}

export interface SampleFrame {
  sample: number;
  label: string;
  asked_mm: Maybe;
  stored?: number; // states of this sample in the store
  displacement_mm: number;
  reaction_kN: number;
}

export interface Shake {
  sample: number;
  wall: number; // from 1, as records
  record: number;
  intensity: number; // [m/s²], of a velocity [m/s]
  drift_percent: number;
  residual_percent: Maybe;
  collapsed: boolean;
}

export interface CampaignHeader extends PageHeader {
  kind: "campaign";
  title: string;
  note: string;
  statistics: Statistics;
  quantities: { name: string; key: QuantityKey; unit: string; can_be_censored: boolean }[];
  provenance: string;
  model_file: string;
  model_text: string;
  until?: { rule: string; met: boolean; measures: Said };
  shakes?: Shake[];
  records?: string[];
  inputs: StudyInput[];
  drawn: number; // walls
  thinned?: { n: number; of: number }; // number of samples shown, and of all
  samples: SampleHead[];
  model?: ModelInputs; // with the walls; absent without them
  frames?: SampleFrame[];
}
