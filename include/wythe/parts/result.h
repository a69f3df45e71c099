// The results of a run: the curve, the numbers that an engineer quotes, and the evidence for them.
#pragma once

#include <array>
#include <cstdint>
#include <limits>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "wythe/parts/curve.h"
#include "wythe/parts/message.h"
#include "wythe/parts/model.h"
#include "wythe/parts/pushed_wall.h"
#include "wythe/parts/shaking.h"

namespace wythe {

enum class SolveStatus {
  kCompleted,
  kCollapsed,
  kInterrupted,
  kNotSettled,
  kUnstable,
  kBudgetSpent
};
inline constexpr Word<SolveStatus> kSolveStatusWords[] = {
    {"completed", SolveStatus::kCompleted},     {"collapsed", SolveStatus::kCollapsed},
    {"interrupted", SolveStatus::kInterrupted}, {"not_settled", SolveStatus::kNotSettled},
    {"unstable", SolveStatus::kUnstable},       {"budget_spent", SolveStatus::kBudgetSpent}};
[[nodiscard]] inline const char* to_string(SolveStatus status) {
  return word_of(kSolveStatusWords, status);
}

// The initial curve of a push, up to its first turn, for stiffnesses. Each window is 2 % wider than the previous
// one, so the resolution of the beginning does not depend on the number of rows.
struct RisePoint {
  double displacement = 0;  // middle of the window [m]
  double force = 0;         // mean of reaction and base shear over the window [N]
};

// Displacement of each block along a push. Readings are a millimetre apart, far beyond the yield of a
// stiff wall; these states are at most a twentieth of the displacement apart.
struct MovedBlocks {
  double displacement = 0;    // of the curve [m]
  std::vector<double> moved;  // by block; supports 0 [m]
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

struct EnergyLedger {
  double loads = 0, drive = 0;                      // work put in [J]
  double kinetic = 0, elastic = 0;                  // stored [J]
  double friction = 0, fracture = 0, crushing = 0;  // dissipated in joints [J]
  double damping = 0;                               // removed by local damping [J]
  double hand_over = 0;                             // removed by hand-overs of contacts [J]
  double gap = 0;                                   // input - stored - dissipated [J]
  double gap_ratio = 0;                             // |gap| / (|loads| + |drive| + elastic)
};

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

// An event during the run that the curve marks.
struct Event {
  Message name;                  // "first crack", "first full crack", "peak", ...
  double displacement = 0;       // [m]
  double reaction = 0;           // [N]
  Message where = {};            // joint kind and place
  bool is_beyond_limit = false;  // a zone's stress exceeded the limit of its material
};

// A measure and its threshold.
struct Evidence {
  std::string element, measure;
  double value = 0, threshold = 0;
  std::string unit;
  [[nodiscard]] bool holds() const { return value >= threshold; }
  // Relative distance beyond the threshold; negative below it.
  [[nodiscard]] double margin() const { return threshold > 0 ? value / threshold - 1 : 0.0; }
};

// One possible damage of an element, and the measure that decides whether it occurred.
struct ElementSign {
  std::string state;    // "flexural crack", "rocking", "diagonal shear crack", "sliding", ...
  std::string measure;  // in words
  double value = 0, threshold = 0;
  std::string unit;                                                      // of both: "mm", "-"
  double displacement_first = std::numeric_limits<double>::quiet_NaN();  // of the first state
                                                                         // that shows it [m]
  [[nodiscard]] bool holds() const { return value >= threshold; }
};

// The state of one pier, spandrel, connection or toe.
struct ElementState {
  std::string element;             // "left pier", "spandrel", "left connection", ...
  std::string kind;                // "pier", "spandrel", "connection", "toe"
  std::string state = "intact";    // the signs that hold, gravest first: "rocking, flexural crack"
  std::vector<ElementSign> signs;  // all that were checked
  // Displacement of the first state with a sign of `state` [m]; NaN: intact.
  double displacement_first = std::numeric_limits<double>::quiet_NaN();
};

// The failure mode from another reading: of another stored state, or with another threshold.
struct NameReading {
  std::string name;
  std::string state;        // label of the other state, "20 mm", "peak", "end"; "" at the same one
  double displacement = 0;  // of the state read [m]
  std::string threshold = {};  // name of the changed threshold, "crack width"; "": none
  double factor = 1;           // factor of that threshold
  // The reading in words, equal for all walls: "at 20 mm", "at the peak", "crack width x 1.25".
  [[nodiscard]] Message what() const;
};

struct FailureMode {
  std::string name = "unclear";
  Message words = {};  // the name in words; not stored
  std::map<std::string, double> scores;
  std::vector<Evidence> evidence;
  Message sentence;    // in plain words
  double read_at = 0;  // displacement at which it was read [m]
  // "read at 40.0 mm", "read at 18.3 mm, where the push ended"; not stored.
  Message reading = {};
  std::vector<ElementState> elements = {};
  std::vector<Evidence> flags = {};  // severity; raised where value >= threshold
  std::vector<NameReading> sensitivity = {};
};

// The limit of validity. Contact points belong to the faces that touched at the start. So a
// compressed joint whose faces overlap by less than half carries a force outside its face.
struct Validity {
  double overlap_lost = std::numeric_limits<double>::quiet_NaN();  // of the first row with
                                                                   // such a joint [m]; NaN: none
  int joints = 0;  // number of such joints in all rows
  Message where;   // kind and place of the first one
  [[nodiscard]] bool holds() const { return joints == 0; }
};

// A sum over the joints of a region in one stored state.
struct Feature {
  std::string name;         // "left_pier_opening", "spandrel_slip", "base_crushing"
  double displacement = 0;  // of the stored state [m]
  double value = 0;         // sum over joints of the mean over their points [m]
};

struct Snapshot {
  std::string label;        // "start of push", "peak", "20 mm", "end"
  double displacement = 0;  // [m]
  double reaction = 0;      // [N]
  State state;
  double asked = kUnset;  // requested by output.states [m]
};

// A link at the end of a curve's row.
struct LinkRow {
  double force = 0, elongation = 0, plastic = 0;  // tension + [N], [m], [m]
};

// A frame's link at the end of a curve's row.
struct FrameRow {
  double normal = 0, shear = 0, moment = 0;  // [N], [N], [N m]; signs: FrameReading
};

// Utilisation of a frame over the curve.
struct FrameUse {
  double use = 0;           // largest of its sections [-]
  double displacement = 0;  // of the row [m]
  Message where;            // "the top of the left column"
  double yields_at =
      std::numeric_limits<double>::quiet_NaN();  // of the first row with a fibre beyond
                                                 // yield [m]; NaN: none
  Message yields_where;
};

// "frame F1: use 0.73, yields at 14.2 mm at the top of the left column".
[[nodiscard]] Message sentence_of(const FrameUse& use, const std::string& frame);

// A layer at the end of a curve's row.
struct LayerRow {
  double use = 0;       // largest fibre force over strength; 1 with broken fibres [-]
  double detached = 0;  // detached share of its bonded length [-]
  double broken = 0;    // share of broken strands [-]
  double x = 0, y = 0;  // place of that force, as built [m]
};
// Utilisation of a layer over the curve.
struct LayerUse {
  double use = 0;           // largest [-]
  double displacement = 0;  // of the first row with that value [m]
  Message where;            // "(1.20, 0.55) m"
  double breaks_at =
      std::numeric_limits<double>::quiet_NaN();  // of the first row with broken fibres [m]
  double detached = 0, broken = 0;               // at the end of the curve
};

// "layer east: use 0.73 at (1.20, 0.55) m, 4 % detached".
[[nodiscard]] Message sentence_of(const LayerUse& use, const std::string& layer);

struct StageReport {
  std::string name;
  double time = 0;  // duration [s]
  std::int64_t steps = 0;
  double unbalance_ratio = 0;  // at the end
  bool settled = false;
};

struct Result {
  SolveStatus status = SolveStatus::kCompleted;
  Message reason;  // residual with place and time, and why the stage stopped
  std::vector<CurveRow> curve;
  std::vector<RisePoint> rise;            // of a push
  std::vector<LinkRow> links;             // (rows of the curve, links of the model)
  std::vector<FrameRow> frame_rows;       // (rows of the curve, links of frames)
  std::vector<FrameUse> frame_uses;       // of each frame
  std::vector<LayerRow> layer_rows;       // (rows of the curve, layers)
  std::vector<LayerUse> layer_uses;       // of each layer
  StageKind curve_of = StageKind::kPush;  // kind of the stage that gave the curve
  Responses responses;
  EnergyLedger energy;
  RateVerdict quasi_static;
  Validity validity;
  Debris debris;  // with free contacts
  std::vector<Event> events;
  std::vector<double>
      joint_crack_displacement;  // first displacement with damage 1 [m], NaN: none (n_joint)
  FailureMode failure_mode;
  std::vector<Feature> features;
  ShakeHistory history;   // rows of all shakes
  ShakeReadings shaking;  // its results
  PushedWall pushed;      // for an assessment; set by read_pushed_wall()
  std::vector<Snapshot> snapshots;
  // States for the failure mode, independent of output.states: the first step at each millimetre and
  // at SolveOptions::read_modes_at, each turn of a cyclic push ("turn"), and the end ("end").
  std::vector<Snapshot> readings;
  std::vector<MovedBlocks> rise_shapes;  // of a one-way push, until readings are as close
  std::vector<Snapshot> frames;          // between them, as SolveOptions::frames requests
  std::vector<StageReport> stages;
  double load_factor = 0;       // largest lambda in balance (body force), tan(tilt)
  double top_displacement = 0;  // [m]
  std::int64_t steps = 0;
  double time_step = 0;  // of the last stage [s]
  double wall_seconds = 0;
  std::string state_hash;
};

[[nodiscard]] inline bool is_load_controlled(const Result& result) {
  return result.curve_of == StageKind::kBodyForce || result.curve_of == StageKind::kTilt;
}
// A warning that precedes all numbers: why the peak is no strength, or how wrong it may be. Empty: none.
[[nodiscard]] Message warning_of(const Result& result);
// Options by which the responses of this run are derived.
[[nodiscard]] ResponseOptions reading_of(const Model& model, const Result& result);

// Columns that the curve of this wall shows.
[[nodiscard]] ShownColumns columns_of(const Model& model);

}  // namespace wythe
