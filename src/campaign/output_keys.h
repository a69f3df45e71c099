// The names of a run's results in every file, one line each: the store (record_rows.h), its view `samples`,
// samples.csv, summary.json.
//
//   each_response(v, responses)       v(key, member) for each response
//   each_quasi_static(v, meters)      the same for the meters at the peak
//   kEnergyTerms                      of the ledger
//
// A visitor is called with double, bool, std::string or Message members. The order is that of samples.csv.
#pragma once

#include <iterator>

#include "wythe/parts/result.h"

namespace wythe::study {

// Where a response has a column for each sample: kView is the view alone, kCsv both.
enum class Listed { kNowhere, kView, kCsv };

struct Explained {
  const char* unit;     // as shown; "": none
  const char* meaning;  // in one line, for columns.json
};

struct OutputKey {
  const char* stored;   // column of the store's table `sample`, SI
  const char* summary;  // key of summary.json; "bilinear.force_kN" lies in an object
  Explained explained;
  Listed listed = Listed::kNowhere;
  const char* column = "";  // there
  double to_unit = 1;       // shown = SI * to_unit; in the store as it is
};

// clang-format off
template <class Visitor, class R>
void each_response(const Visitor& v, R& r) {
  v(OutputKey{"peak_reaction_N", "peak_reaction_kN", {"kN", "capacity: largest reaction of a row in balance; no value where there is none"}, Listed::kCsv, "peak_reaction_kN", 1e-3}, r.peak_reaction);
  v(OutputKey{"displacement_at_peak_m", "displacement_at_peak_mm", {"mm", "displacement at the capacity"}, Listed::kCsv, "displacement_at_peak_mm", 1e3}, r.displacement_at_peak);
  v(OutputKey{"displacement_at_80_percent_m", "displacement_at_80_percent_mm", {"mm", "displacement capacity: the first fall below 0.8 of the peak that lasts; a lower bound where censored_80 is 1"}, Listed::kCsv, "displacement_at_80_percent_mm", 1e3}, r.displacement_at_80);
  v(OutputKey{"censored_80", "censored_80", {"", "1: the push ended before the force had fallen below 0.8 of the peak to stay"}, Listed::kCsv, "censored_80"}, r.censored_80);
  v(OutputKey{"displacement_max_m", "displacement_max_mm", {"mm", "where the force stays below 0.2 of the peak; a lower bound where censored_max is 1"}, Listed::kCsv, "displacement_max_mm", 1e3}, r.displacement_max);
  v(OutputKey{"censored_max", "censored_max", {"", "1: the push ended before the force stayed below 0.2 of the peak"}, Listed::kCsv, "censored_max"}, r.censored_max);
  v(OutputKey{"initial_stiffness_N_per_m", "initial_stiffness_kN_per_mm", {"kN/mm", "slope of the rise between 0.1 and 0.3 of the peak"}, Listed::kCsv, "initial_stiffness_kN_per_mm", 1e-6}, r.initial_stiffness);
  v(OutputKey{"drift_max", "drift_percent_max", {"%", "displacement_max over the load height"}, Listed::kCsv, "drift_max_percent", 1e2}, r.drift_max);
  v(OutputKey{"collapse_displacement_m", "collapse.displacement_mm", {"mm", "largest displacement at which the wall still stood; a lower bound where censored_collapse is 1"}, Listed::kCsv, "collapse_displacement_mm", 1e3}, r.collapse.displacement);
  v(OutputKey{"collapse_censored", "collapse.censored", {"", "1: the run ended before the wall collapsed"}, Listed::kCsv, "censored_collapse"}, r.collapse.censored);
  v(OutputKey{"collapse_criterion", "collapse.criterion", {"", "what ended the wall"}, Listed::kCsv, "collapse_criterion"}, r.collapse.criterion);
  v(OutputKey{"collapse_drift", "collapse.drift_percent", {"%", "collapse displacement over the load height"}, Listed::kNowhere, "", 1e2}, r.collapse.drift);
  v(OutputKey{"peak_reason", "peak_reason", {"", "why there is no capacity; empty where there is one"}, Listed::kView, "peak_reason"}, r.peak_reason);
  v(OutputKey{"censored_peak", "censored_peak", {"", "1: the force still rose at the end of the push, so the capacity is a lower bound"}, Listed::kView, "censored_peak"}, r.censored_peak);
  v(OutputKey{"peak_raw_N", "peak_raw_kN", {"kN", "largest reaction of any row, jolts and rebounds included"}, Listed::kView, "peak_raw_kN", 1e-3}, r.peak_raw);
  v(OutputKey{"displacement_at_peak_raw_m", "displacement_at_peak_raw_mm", {"mm", "displacement at the largest reaction of any row"}, Listed::kNowhere, "", 1e3}, r.displacement_at_peak_raw);
  v(OutputKey{"load_height_m", "load_height_m", {"m", "height of the driven blocks' centroids, which drifts are measured over"}}, r.load_height);
  v(OutputKey{"drift_at_peak", "drift_percent_at_peak", {"%", "displacement at the capacity over the load height"}, Listed::kView, "drift_at_peak_percent", 1e2}, r.drift_at_peak);
  v(OutputKey{"drift_at_80_percent", "drift_percent_at_80", {"%", "displacement at 0.8 of the peak over the load height"}, Listed::kView, "drift_at_80_of_peak_percent", 1e2}, r.drift_at_80);
  v(OutputKey{"work_to_peak_J", "work_to_peak_J", {"J", "area under the curve up to the capacity"}}, r.work_to_peak);
  v(OutputKey{"work_to_80_percent_J", "work_to_80_percent_J", {"J", "area under the curve up to 0.8 of the peak"}}, r.work_to_80);
  v(OutputKey{"work_total_J", "work_total_J", {"J", "area under the whole curve"}}, r.work_total);
  v(OutputKey{"bilinear_stiffness_N_per_m", "bilinear.stiffness_kN_per_mm", {"kN/mm", "stiffness of the bilinear curve: secant through 0.6 of the peak"}, Listed::kNowhere, "", 1e-6}, r.bilinear.stiffness);
  v(OutputKey{"bilinear_force_N", "bilinear.force_kN", {"kN", "yield force of the bilinear curve of equal area"}, Listed::kNowhere, "", 1e-3}, r.bilinear.force);
  v(OutputKey{"bilinear_yield_displacement_m", "bilinear.yield_displacement_mm", {"mm", "yield displacement of the bilinear curve"}, Listed::kNowhere, "", 1e3}, r.bilinear.yield_displacement);
  v(OutputKey{"bilinear_ultimate_displacement_m", "bilinear.ultimate_displacement_mm", {"mm", "ultimate displacement of the bilinear curve"}, Listed::kNowhere, "", 1e3}, r.bilinear.ultimate_displacement);
  v(OutputKey{"bilinear_ductility", "bilinear.ductility", {"–", "ultimate over yield displacement; a lower bound where bilinear_censored is 1"}}, r.bilinear.ductility);
  v(OutputKey{"bilinear_censored", "bilinear.censored", {"", "1: 0.8 of the peak was never crossed"}}, r.bilinear.censored);
  v(OutputKey{"first_fall_80_percent_m", "first_fall_80_percent_mm", {"mm", "the first fall of all below 0.8 of the peak, also one that is made good again"}, Listed::kCsv, "first_fall_80_percent_mm", 1e3}, r.first_fall_80);
  v(OutputKey{"censored_first_80", "censored_first_80", {"", "1: the force was never below 0.8 of the peak, so the first fall is a lower bound"}, Listed::kCsv, "censored_first_80"}, r.censored_first_80);
  v(OutputKey{"last_fall_80_percent_m", "last_fall_80_percent_mm", {"mm", "the last fall below 0.8 of the peak, after which the force never came back"}, Listed::kView, "last_fall_80_percent_mm", 1e3}, r.last_fall_80);
  v(OutputKey{"censored_last_80", "censored_last_80", {"", "1: at the end of the push the force was above 0.8 of the peak, so the last fall is a lower bound"}, Listed::kView, "censored_last_80"}, r.censored_last_80);
}

template <class Visitor, class Meters>
void each_quasi_static(const Visitor& v, Meters& q) {
  v(OutputKey{"rate_verdict", "quasi_static.verdict", {"", "how nearly static the push was, with reason and cure"}}, q.verdict);
  v(OutputKey{"rate_judgement", "quasi_static.judgement", {"", "the same in a word: slow enough, usable, too fast, unknown, no push"}, Listed::kView, "rate_judgement"}, q.judgement);
  v(OutputKey{"rate_lift", "quasi_static.lift_percent", {"%", "a slow push moves the peak by no more than about this"}, Listed::kNowhere, "", 1e2}, q.lift);
  v(OutputKey{"force_beyond_peak", "quasi_static.force_beyond_percent", {"%", "largest force of any row that both reaction and base shear have, beyond the capacity"}, Listed::kNowhere, "", 1e2}, q.beyond);
  v(OutputKey{"unbalance_ratio_mean", "quasi_static.unbalance_ratio_mean", {"–", "unbalanced forces over contact forces, mean of the rows around the peak"}}, q.unbalance_ratio_mean);
  v(OutputKey{"unbalance_ratio_max", "quasi_static.unbalance_ratio_max", {"–", "the same, largest of these rows"}}, q.unbalance_ratio_max);
  v(OutputKey{"kinetic_ratio_mean", "quasi_static.kinetic_ratio_mean", {"–", "kinetic energy over the work of the drive, mean of the rows around the peak"}}, q.kinetic_ratio_mean);
  v(OutputKey{"kinetic_ratio_max", "quasi_static.kinetic_ratio_max", {"–", "the same, largest of these rows"}}, q.kinetic_ratio_max);
  v(OutputKey{"shear_gap", "quasi_static.shear_gap", {"–", "gap between reaction and base shear over the peak, mean of the rows around it"}}, q.shear_gap);
  v(OutputKey{"damping_share", "quasi_static.damping_share", {"–", "share of the drive's work that local damping took on the way to the peak"}}, q.damping_share);
}
// clang-format on

struct EnergyTerm {
  const char* name;  // in `energy_J` of summary.json and on the page
  const char* stored;
  double EnergyLedger::*value;
};
inline constexpr EnergyTerm kEnergyTerms[] = {
    {"loads", "energy_loads_J", &EnergyLedger::loads},
    {"drive", "energy_drive_J", &EnergyLedger::drive},
    {"kinetic", "energy_kinetic_J", &EnergyLedger::kinetic},
    {"elastic", "energy_elastic_J", &EnergyLedger::elastic},
    {"friction", "energy_friction_J", &EnergyLedger::friction},
    {"fracture", "energy_fracture_J", &EnergyLedger::fracture},
    {"crushing", "energy_crushing_J", &EnergyLedger::crushing},
    {"damping", "energy_damping_J", &EnergyLedger::damping},
    {"gap", "energy_gap_J", &EnergyLedger::gap},
    {"gap_ratio", "energy_gap_ratio", &EnergyLedger::gap_ratio}};
// hand_over is of runs with free contacts alone (summary_json.cpp)
static_assert(sizeof(EnergyLedger) == (std::size(kEnergyTerms) + 1) * sizeof(double));

}  // namespace wythe::study
