// The header of the page of options side by side: comparison_data() and comparison.json
// (docs/reference/comparison.md).
import type { Said } from "../base/texts";
import type { Interval, Maybe } from "./common";
import type { PageHeader } from "./page";

export interface Side {
  value: number[];
  lower_bounds: number[]; // samples
}
export interface Gain {
  input: string;
  n: number;
  spearman: Maybe;
  spearman_interval: Interval;
  p: Maybe;
  p_adjusted: Maybe;
  low_third: Maybe; // in the response's unit
  middle_third: Maybe;
  high_third: Maybe;
}
// The differences in one response, in its unit.
export interface PairedResponse {
  unit: string;
  pairs: number;
  without_value: number;
  with_bounds: number;
  larger: number;
  smaller: number;
  equal: number;
  undecided: number;
  in_means: number;
  up_to: Maybe;
  base: Maybe;
  option: Maybe;
  difference: Maybe;
  difference_interval: Interval;
  ratio: Maybe;
  ratio_interval: Interval;
  median_difference_bounds: Interval;
  share_larger: Maybe;
  share_larger_interval: Interval;
  cov_ratio: Maybe;
  cov_ratio_interval: Interval;
  worth: Maybe;
  slow_enough: number;
  difference_slow_enough: Maybe;
  gain: Gain[];
  pair: { sample: number[]; base: Side; option: Side };
}

export interface ModeShift {
  mode: string;
  base: number;
  option: number;
  came: number;
  went: number;
  share_difference: Maybe;
  share_difference_interval: Interval;
  p: Maybe;
  p_adjusted: Maybe;
}
export interface ModeTable {
  modes: string[];
  count: number[][]; // from the base's mode to the option's
  pairs: number;
  unclear: number;
  changed: { sample: number; base: string; option: string }[];
  shift: ModeShift[];
}

export interface LostPair {
  sample: number;
  base_status: string; // "": not run
  option_status: string;
  base_answered: boolean;
  option_answered: boolean;
  base_reason: Said;
  option_reason: Said;
}

export interface Option {
  name: string;
  folder: string;
  changes: string[];
  notes: Said[];
  pairs: number;
  lost: number;
  lost_pairs: LostPair[];
  response: Record<string, PairedResponse>; // by the quantity's key
  modes: ModeTable;
}

export interface ComparedQuantity {
  name: string;
  key: string;
  unit: string;
}
export interface ComparisonHeader extends PageHeader {
  kind: "comparison";
  title: string;
  comparison: {
    base: { name: string; folder: string };
    samples: number;
    option: Option[];
    input: { name: string; unit: string; value: number[] }[];
  };
  quantities: ComparedQuantity[];
  provenance: string;
}
