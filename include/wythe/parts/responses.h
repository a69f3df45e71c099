// The responses of a run, which are read off its curve, and what every file calls them.
//
// A response is a member of Responses or RateVerdict, filled in src/dynamics/meters/responses.cpp or balance.cpp, and its
// line in each_response or each_quasi_static. From there it reaches summary.json, the store and its view
// `samples`, samples.csv, columns.json, the table of docs/reference/results.md and web/src/headers/responses.ts (make docs).
//
//   each_response(v, responses)       v(key, member) for each response
//   each_direction_reading(v, d)      v(listed, name, unit, value) for one direction of a cyclic push
//   each_quasi_static(v, meters)      the same for the meters at the peak
//   kEnergyTerms                      of the ledger
//
// A visitor is called with double, bool, std::string or Message members. The order is that of samples.csv.
#pragma once

#include <cstdint>
#include <iterator>
#include <optional>
#include <string>
#include <vector>

#include "wythe/parts/curve.h"
#include "wythe/parts/message.h"
#include "wythe/parts/model.h"

namespace wythe {

// The initial curve of a push, up to its first turn, for stiffnesses. Each window is 2 % wider than the previous
// one, so the resolution of the beginning does not depend on the number of rows.
struct RisePoint {
  double displacement = 0;  // middle of the window [m]
  double force = 0;         // mean of reaction and base shear over the window [N]
};

// A fall below a share of the peak is temporary if the force returns before the displacement has grown by this share. The
// force must then stay above for at least as long as it was below (docs/theory/drift.md).
inline constexpr double kLastingShare = 0.1;

// Displacements at which the force falls to `fraction` of the peak, after the peak [m]. A value is
// censored, a lower bound, where the push shows no end: the force never fell, or the push ended
// before the fall had lasted.
struct FallTo {
  double fraction = 0;      // of the peak [-]
  double displacement = 0;  // of the first lasting fall: the capacity
  double drift = 0;         // displacement / load height [-]
  bool censored = true;
  double first = 0;  // of the first fall, lasting or not
  bool censored_first = true;
  double last = 0;  // of the last fall, from which the force never returned
  bool censored_last = true;
};

// A fall from which the force returned; it does not end the capacity. After the peak the reference force is the peak.
struct Dip {
  double fraction = 0;        // of the largest previous force [-]
  double from = 0, back = 0;  // displacements of the fall and the return [m]
  double lowest = 0;          // least force between them, over the largest previous one [-]
  bool before_peak = false;   // before the peak of the curve
};

// Elastic-perfectly plastic curve of equal area: the secant through 0.6 peak, and the plateau that
// makes both areas equal up to the ultimate displacement (docs/reference/results.md).
struct Bilinear {
  double stiffness = 0;              // ke [N/m]
  double force = 0;                  // Fu [N]
  double yield_displacement = 0;     // dy [m]
  double ultimate_displacement = 0;  // du [m], at 0.8 peak
  double ductility = 0;              // du / dy
  bool censored = true;  // the force never fell to 0.8 peak: du, ductility are lower bounds
};

// The largest displacement at which the wall still stood, and the criterion that ended it.
struct Collapse {
  double displacement = 0;  // [m]
  double drift = 0;         // displacement / load height [-]
  bool censored = true;     // the run ended before the wall collapsed
  Message criterion;        // "the reaction stays below 0.2 of the peak", "a block fell", ...
};

struct BackbonePoint {
  double displacement = 0;  // [m]
  double reaction = 0;      // [N]
};

// Results of one direction of a cyclic push, from its envelope; all numbers are positive.
struct DirectionReadings {
  double peak_reaction = 0;         // [N]
  double displacement_at_peak = 0;  // [m]
  // As of Responses [m].
  double displacement_at_80 = 0, first_fall_80 = 0, last_fall_80 = 0;
  bool censored_80 = true, censored_first_80 = true, censored_last_80 = true;
  double displacement_max = 0;  // [m]
  bool censored_max = true;
  double initial_stiffness = 0;  // [N/m]
  std::vector<FallTo> drift_capacity = {};
  std::vector<Dip> dips = {};
  Bilinear bilinear = {};
  std::vector<BackbonePoint> backbone = {};
};

// One cycle of a cyclic push, complete or not. NaN: the number does not exist for this cycle.
struct Cycle {
  // "full": both directions, from zero displacement back to zero; "half": the same in one direction;
  // "partial": turned back, but not from zero to zero; "unfinished": no turn.
  std::string kind;
  double displacement_max = 0, displacement_min = 0;  // at the turns [m]
  double reaction_max = 0, reaction_min = 0;          // largest force in each direction [N]
  double residual_max = 0, residual_min = 0;          // where the force first returns to zero [m]
  double dissipated = 0;                              // area of the loop [J]
  double drag = 0;                                    // part of it due to reaction - base shear [J]
  double stiffness = 0;                               // secant between the extremes [N/m]
  double damping_ratio = 0;                           // equivalent viscous, E_D / (4 pi E_so)
  std::int64_t repeat = 1;                            // repetition at this amplitude, 1: first
  double kept = 1;                                    // forces over those of repetition 1 [-]
  bool in_balance = true;  // false: no row in balance, so forces are of any row
};

// Results of a cyclic push (docs/reference/results.md, "Cyclic pushes"). The other members of
// Responses then belong to the direction with the larger peak.
struct CyclicReadings {
  std::int64_t sense = 0;  // direction of these: 1 along the push, -1 against it; 0: not cyclic
  DirectionReadings positive, negative;
  std::vector<Cycle> cycles;
  double work = 0;  // of the reaction over the whole path [J]
};

// What every file calls a response, once.
struct OutputKey {
  enum Listed {
    kNowhere,
    kView,
    kCsv
  };                    // a column for each sample: in the view alone, or in samples.csv too
  const char* stored;   // column of the store's table `sample`, SI
  const char* summary;  // key of summary.json; "bilinear.force_kN" lies in an object
  const char* unit;     // as shown; "": none
  const char* meaning;  // and when it is missing; for results.md and columns.json
  Listed listed = kNowhere;
  const char* column = "";  // there
  double to_unit = 1;       // shown = SI * to_unit; in the store as it is
};

// Responses derived from the curve; definitions: docs/reference/results.md.
struct Responses {
  // The capacity: the largest reaction of a row in balance (is_in_balance); for a load-controlled
  // stage the largest load carried in balance. NaN: none, peak_reason says why.
  double peak_reaction = 0;             // [N]
  double displacement_at_peak = 0;      // [m]
  Message peak_reason = {};             // why there is no capacity; empty where there is one
  bool censored_peak = false;           // lower bound: still rising, or the load caused no collapse
  double peak_raw = 0;                  // largest reaction of any row [N]
  double displacement_at_peak_raw = 0;  // [m]
  // Falls below 0.8 peak: the first lasting one, the first and the last [m] (FallTo).
  double displacement_at_80 = 0, first_fall_80 = 0, last_fall_80 = 0;
  bool censored_80 = true, censored_first_80 = true, censored_last_80 = true;
  double displacement_max = 0;  // [m], from here the reaction stays below 0.2 peak
  bool censored_max = true;
  double initial_stiffness = 0;  // [N/m], secant between 10 and 30 % of the peak
  double load_height = 0;        // reference height of drifts [m]; 0: not known, no drifts
  double drift_at_peak = 0, drift_at_80 = 0, drift_max = 0;  // displacement / load_height [-]
  double work_to_peak = 0, work_to_80 = 0, work_total = 0;   // area under the curve [J]
  std::vector<FallTo> falls = {};           // for each requested fraction, in order
  std::vector<FallTo> drift_capacity = {};  // d(r) for each of kSharesLeft
  std::vector<Dip> dips = {};               // below 0.8 of the previous force, in order
  Bilinear bilinear = {};
  Collapse collapse = {};
  CyclicReadings cyclic = {};
};

// clang-format off
template <class Visitor, class R>
void each_response(const Visitor& v, R& r) {
  // A new member does not compile until it stands here.
  auto& [peak_reaction, displacement_at_peak, peak_reason, censored_peak, peak_raw, displacement_at_peak_raw, displacement_at_80,
         first_fall_80, last_fall_80, censored_80, censored_first_80, censored_last_80, displacement_max, censored_max,
         initial_stiffness, load_height, drift_at_peak, drift_at_80, drift_max, work_to_peak, work_to_80, work_total, falls,
         drift_capacity, dips, bilinear, collapse, cyclic] = r;
  v(OutputKey{"peak_reaction_N", "peak_reaction_kN", "kN",
      "the capacity: largest reaction of a row in balance (docs/theory/integration.md, 4.11a); body_force, tilt: load factor × "
      "weight; none where there is no capacity",
      OutputKey::kCsv, "peak_reaction_kN", 1e-3}, peak_reaction);
  v(OutputKey{"displacement_at_peak_m", "displacement_at_peak_mm", "mm",
      "displacement of the row of the capacity; body_force, tilt: of the top",
      OutputKey::kCsv, "displacement_at_peak_mm", 1e3}, displacement_at_peak);
  v(OutputKey{"displacement_at_80_percent_m", "displacement_at_80_percent_mm", "mm",
      "displacement capacity: the first fall below 0.8 of the peak, after the peak, that lasts (docs/theory/drift.md), in reaction "
      "and base shear, straight between rows; where the wall collapsed before, its last displacement; a lower bound where "
      "censored_80 is true",
      OutputKey::kCsv, "displacement_at_80_percent_mm", 1e3}, displacement_at_80);
  v(OutputKey{"censored_80", "censored_80", "",
      "true (1): the push ended before the force had fallen below 0.8 of the peak to stay",
      OutputKey::kCsv, "censored_80"}, censored_80);
  v(OutputKey{"displacement_max_m", "displacement_max_mm", "mm",
      "first of the rows that stay below 0.2 of the peak to the end; a lower bound, the last displacement, where censored_max is true",
      OutputKey::kCsv, "displacement_max_mm", 1e3}, displacement_max);
  v(OutputKey{"censored_max", "censored_max", "",
      "true (1): the push ended before the force stayed below 0.2 of the peak",
      OutputKey::kCsv, "censored_max"}, censored_max);
  v(OutputKey{"initial_stiffness_N_per_m", "initial_stiffness_kN_per_mm", "kN/mm",
      "slope of the straight line nearest to the rise from 0.1 to 0.3 of the peak, in the mean of reaction and base shear; none "
      "where the two differ there by more than 0.15 of the peak, or where the first force is above 0.1 of it",
      OutputKey::kCsv, "initial_stiffness_kN_per_mm", 1e-6}, initial_stiffness);
  v(OutputKey{"drift_max", "drift_percent_max", "%",
      "displacement_max over the load height",
      OutputKey::kCsv, "drift_max_percent", 1e2}, drift_max);
  v(OutputKey{"collapse_displacement_m", "collapse.displacement_mm", "mm",
      "largest displacement at which the wall still stood: displacement_max where the reaction stays below 0.2 of the peak, else "
      "the last one; a lower bound where collapse.censored is true",
      OutputKey::kCsv, "collapse_displacement_mm", 1e3}, collapse.displacement);
  v(OutputKey{"collapse_censored", "collapse.censored", "",
      "true (1): the run ended before the wall collapsed",
      OutputKey::kCsv, "censored_collapse"}, collapse.censored);
  v(OutputKey{"collapse_criterion", "collapse.criterion", "",
      "what ended the wall",
      OutputKey::kCsv, "collapse_criterion"}, collapse.criterion);
  v(OutputKey{"collapse_drift", "collapse.drift_percent", "%",
      "collapse displacement over the load height",
      OutputKey::kNowhere, "", 1e2}, collapse.drift);
  v(OutputKey{"peak_reason", "peak_reason", "",
      "why there is no capacity; empty where there is one",
      OutputKey::kView, "peak_reason"}, peak_reason);
  v(OutputKey{"censored_peak", "censored_peak", "",
      "true (1): the capacity lies in the last hundredth of the path, or the load never brought the wall down, so it is a lower bound",
      OutputKey::kView, "censored_peak"}, censored_peak);
  v(OutputKey{"peak_raw_N", "peak_raw_kN", "kN",
      "largest reaction of any row, jolts and rebounds included",
      OutputKey::kView, "peak_raw_kN", 1e-3}, peak_raw);
  v(OutputKey{"displacement_at_peak_raw_m", "displacement_at_peak_raw_mm", "mm",
      "displacement at the largest reaction of any row",
      OutputKey::kNowhere, "", 1e3}, displacement_at_peak_raw);
  v(OutputKey{"load_height_m", "load_height_m", "m",
      "height of the driven blocks' centroids, over which drifts are measured; 0 without a push, and then drifts are 0"}, load_height);
  v(OutputKey{"drift_at_peak", "drift_percent_at_peak", "%",
      "displacement at the capacity over the load height",
      OutputKey::kView, "drift_at_peak_percent", 1e2}, drift_at_peak);
  v(OutputKey{"drift_at_80_percent", "drift_percent_at_80", "%",
      "displacement at 0.8 of the peak over the load height",
      OutputKey::kView, "drift_at_80_of_peak_percent", 1e2}, drift_at_80);
  v(OutputKey{"work_to_peak_J", "work_to_peak_J", "J",
      "∫ reaction d(displacement), straight between rows, up to the capacity"}, work_to_peak);
  v(OutputKey{"work_to_80_percent_J", "work_to_80_percent_J", "J",
      "the same up to 0.8 of the peak"}, work_to_80);
  v(OutputKey{"work_total_J", "work_total_J", "J",
      "the same of the whole curve"}, work_total);
  v(OutputKey{"bilinear_stiffness_N_per_m", "bilinear.stiffness_kN_per_mm", "kN/mm",
      "ke: stiffness of the bilinear curve, secant through 0.6 of the peak",
      OutputKey::kNowhere, "", 1e-6}, bilinear.stiffness);
  v(OutputKey{"bilinear_force_N", "bilinear.force_kN", "kN",
      "Fu: yield force of the bilinear curve that has the area of the curve up to du",
      OutputKey::kNowhere, "", 1e-3}, bilinear.force);
  v(OutputKey{"bilinear_yield_displacement_m", "bilinear.yield_displacement_mm", "mm",
      "dy = Fu / ke",
      OutputKey::kNowhere, "", 1e3}, bilinear.yield_displacement);
  v(OutputKey{"bilinear_ultimate_displacement_m", "bilinear.ultimate_displacement_mm", "mm",
      "du: displacement at 0.8 of the peak",
      OutputKey::kNowhere, "", 1e3}, bilinear.ultimate_displacement);
  v(OutputKey{"bilinear_ductility", "bilinear.ductility", "–",
      "du / dy; a lower bound where bilinear.censored is true"}, bilinear.ductility);
  v(OutputKey{"bilinear_censored", "bilinear.censored", "",
      "true (1): 0.8 of the peak was never crossed"}, bilinear.censored);
  v(OutputKey{"first_fall_80_percent_m", "first_fall_80_percent_mm", "mm",
      "the first fall of all below 0.8 of the peak, also one that is made good again",
      OutputKey::kCsv, "first_fall_80_percent_mm", 1e3}, first_fall_80);
  v(OutputKey{"censored_first_80", "censored_first_80", "",
      "true (1): the force was never below 0.8 of the peak, so the first fall is a lower bound",
      OutputKey::kCsv, "censored_first_80"}, censored_first_80);
  v(OutputKey{"last_fall_80_percent_m", "last_fall_80_percent_mm", "mm",
      "the last fall below 0.8 of the peak, after which the force never came back",
      OutputKey::kView, "last_fall_80_percent_mm", 1e3}, last_fall_80);
  v(OutputKey{"censored_last_80", "censored_last_80", "",
      "true (1): at the end of the push the force was above 0.8 of the peak, so the last fall is a lower bound",
      OutputKey::kView, "censored_last_80"}, censored_last_80);
}

// clang-format on

// Each value is in its unit, or a bool. summary.json calls it "peak_reaction_kN"; samples.csv, where it is listed,
// "peak_reaction_positive_kN".
template <class Visitor>
void each_direction_reading(const Visitor& v, const DirectionReadings& d) {
  v(OutputKey::kCsv, "peak_reaction", "_kN", 1e-3 * d.peak_reaction);
  v(OutputKey::kNowhere, "displacement_at_peak", "_mm", 1e3 * d.displacement_at_peak);
  v(OutputKey::kCsv, "displacement_at_80_percent", "_mm", 1e3 * d.displacement_at_80);
  v(OutputKey::kCsv, "censored_80", "", d.censored_80);
  v(OutputKey::kCsv, "first_fall_80_percent", "_mm", 1e3 * d.first_fall_80);
  v(OutputKey::kCsv, "censored_first_80", "", d.censored_first_80);
  v(OutputKey::kCsv, "last_fall_80_percent", "_mm", 1e3 * d.last_fall_80);
  v(OutputKey::kCsv, "censored_last_80", "", d.censored_last_80);
  v(OutputKey::kNowhere, "displacement_max", "_mm", 1e3 * d.displacement_max);
  v(OutputKey::kNowhere, "censored_max", "", d.censored_max);
  v(OutputKey::kNowhere, "initial_stiffness", "_kN_per_mm", 1e-6 * d.initial_stiffness);
}

// Shares r of the peak at which the displacement capacity d(r) is evaluated.
inline constexpr double kSharesLeft[] = {0.95, 0.9, 0.85, 0.8, 0.75, 0.7, 0.65, 0.6, 0.55, 0.5};
// Ratio d(0.75)/d(0.85) above which the capacity depends on the chosen share of the peak.
inline constexpr double kThresholdDecides = 1.5;

// Options of the responses, and facts that the curve does not contain.
struct ResponseOptions {
  std::vector<double> fractions = {0.8, 0.5};  // of the peak, after it, each in (0, 1)
  Message collapse = {};                       // reason of a collapse; empty: no collapse
  std::vector<RisePoint> rise = {};            // for stiffnesses; empty: the rows give them
  double carried = kUnset;  // of a load-controlled stage: largest load in balance [N]
};
// Whether d(0.75) exceeds kThresholdDecides times d(0.85); nothing where the push ended too early to tell.
[[nodiscard]] std::optional<bool> threshold_decides(const std::vector<FallTo>& drift_capacity);
[[nodiscard]] Responses read_responses(const std::vector<CurveRow>& curve,
                                       const ResponseOptions& options = {});
// The curve behind the responses: the curve itself; for a cyclic push the envelope of the
// direction with the larger peak, in positive numbers.
[[nodiscard]] std::vector<CurveRow> backbone_of(const std::vector<CurveRow>& curve);

// Whether reaction and base shear agree within 2 % of the reaction, in this row, its neighbours and all rows within 2.5 % of
// its displacement. Inertia and drag then have no part in the force.
[[nodiscard]] bool is_in_balance(const std::vector<CurveRow>& curve, std::size_t row);

// How nearly static the push was at its peak, in numbers and words (docs/theory/integration.md,
// "Is it static enough?"). NaN: not known.
struct RateVerdict {
  double unbalance_ratio_mean = 0, unbalance_ratio_max = 0;  // over the rows around the peak
  double kinetic_ratio_mean = 0, kinetic_ratio_max = 0;      // the same
  double shear_gap = 0;      // |mean of (reaction - base shear)| / peak, rows around the peak
  double damping_share = 0;  // over the drive's work before the peak (last fifth, median)
  double beyond = 0;         // largest min(reaction, base shear) of any row / peak - 1
  double lift = 0;           // largest relative change of the peak by a slow push
  std::string judgement = "no push";  // "slow enough", "usable", "too fast", "unknown", "no push"
  Message verdict;                    // judgement with reason and cure
};

// clang-format off
template <class Visitor, class Meters>
void each_quasi_static(const Visitor& v, Meters& q) {
  // A new member does not compile until it stands here.
  auto& [unbalance_ratio_mean, unbalance_ratio_max, kinetic_ratio_mean, kinetic_ratio_max, shear_gap, damping_share, beyond, lift,
         judgement, verdict] = q;
  v(OutputKey{"rate_verdict", "quasi_static.verdict", "",
      "how nearly static the push was, with reason and cure"}, verdict);
  v(OutputKey{"rate_judgement", "quasi_static.judgement", "",
      "the same in a word: slow enough, usable, too fast, unknown, no push",
      OutputKey::kView, "rate_judgement"}, judgement);
  v(OutputKey{"rate_lift", "quasi_static.lift_percent", "%",
      "a slow push moves the peak by no more than about this",
      OutputKey::kNowhere, "", 1e2}, lift);
  v(OutputKey{"force_beyond_peak", "quasi_static.force_beyond_percent", "%",
      "largest force of any row that both reaction and base shear have, beyond the capacity",
      OutputKey::kNowhere, "", 1e2}, beyond);
  v(OutputKey{"unbalance_ratio_mean", "quasi_static.unbalance_ratio_mean", "–",
      "unbalanced forces over contact forces, mean of the rows around the peak"}, unbalance_ratio_mean);
  v(OutputKey{"unbalance_ratio_max", "quasi_static.unbalance_ratio_max", "–",
      "the same, largest of these rows"}, unbalance_ratio_max);
  v(OutputKey{"kinetic_ratio_mean", "quasi_static.kinetic_ratio_mean", "–",
      "kinetic energy over the work of the drive, mean of the rows around the peak"}, kinetic_ratio_mean);
  v(OutputKey{"kinetic_ratio_max", "quasi_static.kinetic_ratio_max", "–",
      "the same, largest of these rows"}, kinetic_ratio_max);
  v(OutputKey{"shear_gap", "quasi_static.shear_gap", "–",
      "gap between reaction and base shear over the peak, mean of the rows around it"}, shear_gap);
  v(OutputKey{"damping_share", "quasi_static.damping_share", "–",
      "share of the drive's work that local damping took on the way to the peak"}, damping_share);
}
// clang-format on

struct EnergyLedger {
  double loads = 0, drive = 0;                      // work put in [J]
  double kinetic = 0, elastic = 0;                  // stored [J]
  double friction = 0, fracture = 0, crushing = 0;  // dissipated in joints [J]
  double damping = 0;                               // removed by local damping [J]
  double hand_over = 0;                             // removed by hand-overs of contacts [J]
  double gap = 0;                                   // input - stored - dissipated [J]
  double gap_ratio = 0;                             // |gap| / (|loads| + |drive| + elastic)
};

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

}  // namespace wythe
