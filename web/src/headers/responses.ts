// The responses in summary.json, from include/wythe/parts/responses.h: make docs writes this file.
import type { Said } from "../base/texts";
import type { Maybe } from "./common";

export interface Responses {
  peak_reaction_kN: Maybe; // [kN] the capacity: largest reaction of a row in balance (docs/theory/integration.md, 4.11a); body_force, tilt: load factor × weight; none where there is no capacity
  displacement_at_peak_mm: Maybe; // [mm] displacement of the row of the capacity; body_force, tilt: of the top
  displacement_at_80_percent_mm: Maybe; // [mm] displacement capacity: the first fall below 0.8 of the peak, after the peak, that lasts (docs/theory/drift.md), in reaction and base shear, straight between rows; where the wall collapsed before, its last displacement; a lower bound where censored_80 is true
  censored_80: boolean; // true (1): the push ended before the force had fallen below 0.8 of the peak to stay
  displacement_max_mm: Maybe; // [mm] first of the rows that stay below 0.2 of the peak to the end; a lower bound, the last displacement, where censored_max is true
  censored_max: boolean; // true (1): the push ended before the force stayed below 0.2 of the peak
  initial_stiffness_kN_per_mm: Maybe; // [kN/mm] slope of the straight line nearest to the rise from 0.1 to 0.3 of the peak, in the mean of reaction and base shear; none where the two differ there by more than 0.15 of the peak, or where the first force is above 0.1 of it
  drift_percent_max: Maybe; // [%] displacement_max over the load height
  collapse: {
    displacement_mm: Maybe; // [mm] largest displacement at which the wall still stood: displacement_max where the reaction stays below 0.2 of the peak, else the last one; a lower bound where collapse.censored is true
    censored: boolean; // true (1): the run ended before the wall collapsed
    criterion: Said; // what ended the wall
    drift_percent: Maybe; // [%] collapse displacement over the load height
  };
  peak_reason: Said; // why there is no capacity; empty where there is one
  censored_peak: boolean; // true (1): the capacity lies in the last hundredth of the path, or the load never brought the wall down, so it is a lower bound
  peak_raw_kN: Maybe; // [kN] largest reaction of any row, jolts and rebounds included
  displacement_at_peak_raw_mm: Maybe; // [mm] displacement at the largest reaction of any row
  load_height_m: Maybe; // [m] height of the driven blocks' centroids, over which drifts are measured; 0 without a push, and then drifts are 0
  drift_percent_at_peak: Maybe; // [%] displacement at the capacity over the load height
  drift_percent_at_80: Maybe; // [%] displacement at 0.8 of the peak over the load height
  work_to_peak_J: Maybe; // [J] ∫ reaction d(displacement), straight between rows, up to the capacity
  work_to_80_percent_J: Maybe; // [J] the same up to 0.8 of the peak
  work_total_J: Maybe; // [J] the same of the whole curve
  bilinear: {
    stiffness_kN_per_mm: Maybe; // [kN/mm] ke: stiffness of the bilinear curve, secant through 0.6 of the peak
    force_kN: Maybe; // [kN] Fu: yield force of the bilinear curve that has the area of the curve up to du
    yield_displacement_mm: Maybe; // [mm] dy = Fu / ke
    ultimate_displacement_mm: Maybe; // [mm] du: displacement at 0.8 of the peak
    ductility: Maybe; // [–] du / dy; a lower bound where bilinear.censored is true
    censored: boolean; // true (1): 0.8 of the peak was never crossed
  };
  first_fall_80_percent_mm: Maybe; // [mm] the first fall of all below 0.8 of the peak, also one that is made good again
  censored_first_80: boolean; // true (1): the force was never below 0.8 of the peak, so the first fall is a lower bound
  last_fall_80_percent_mm: Maybe; // [mm] the last fall below 0.8 of the peak, after which the force never came back
  censored_last_80: boolean; // true (1): at the end of the push the force was above 0.8 of the peak, so the last fall is a lower bound
  quasi_static: {
    verdict: Said; // how nearly static the push was, with reason and cure
    judgement: string; // the same in a word: slow enough, usable, too fast, unknown, no push
    lift_percent: Maybe; // [%] a slow push moves the peak by no more than about this
    force_beyond_percent: Maybe; // [%] largest force of any row that both reaction and base shear have, beyond the capacity
    unbalance_ratio_mean: Maybe; // [–] unbalanced forces over contact forces, mean of the rows around the peak
    unbalance_ratio_max: Maybe; // [–] the same, largest of these rows
    kinetic_ratio_mean: Maybe; // [–] kinetic energy over the work of the drive, mean of the rows around the peak
    kinetic_ratio_max: Maybe; // [–] the same, largest of these rows
    shear_gap: Maybe; // [–] gap between reaction and base shear over the peak, mean of the rows around it
    damping_share: Maybe; // [–] share of the drive's work that local damping took on the way to the peak
  };
}
