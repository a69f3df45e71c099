// The results of a run: the curve, the numbers an engineer quotes, and the evidence for them.
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

// The curve of a push up to its first turn, from which stiffnesses are read. Each window is 2 % wider
// than the one before, so that the beginning is equally fine for any number of rows.
struct RisePoint {
  double displacement = 0;  // in the middle of the window [m]
  double force = 0;         // mean of reaction and base shear over the window's path [N]
};

// How far each block has gone along a push since its start. Readings lie a millimetre apart, which is far
// beyond the yield of a stiff wall; these lie a twentieth of the displacement apart or less.
struct MovedBlocks {
  double displacement = 0;    // of the curve [m]
  std::vector<double> moved;  // by number of the block; supports 0 [m]
};

// A fall below a share of the peak lasts unless the force comes back to it before the displacement has grown
// by this share, and then stays for at least as long as it was away (docs/theory/drift.md).
inline constexpr double kLastingShare = 0.1;

// Displacements at which the force falls to `fraction` of the peak, after the peak [m]. A reading is
// censored where the wall reaches farther, as far as the push tells: it never fell, or the push ended
// before the fall had lasted; the displacement is then a lower bound.
struct FallTo {
  double fraction = 0;      // of the peak [-]
  double displacement = 0;  // of the first fall that lasts: the capacity
  double drift = 0;         // displacement / load height [-]
  bool censored = true;
  double first = 0;  // of the first fall of all
  bool censored_first = true;
  double last = 0;  // of the last fall, after which the force never came back
  bool censored_last = true;
};

// A fall from which the force came back: no end of the capacity. After the peak the force before it is the peak.
struct Dip {
  double fraction = 0;        // of the largest force before it, below which it fell [-]
  double from = 0, back = 0;  // where it fell and where it was back [m]
  double lowest = 0;          // the least force on the way, over the largest before it [-]
  bool before_peak = false;   // of the curve
};

// Elastic, perfectly plastic curve of equal area: the secant through 0.6 peak, cut at the force that
// makes both areas equal up to the ultimate displacement (docs/reference/results.md).
struct Bilinear {
  double stiffness = 0;              // ke [N/m]
  double force = 0;                  // Fu [N]
  double yield_displacement = 0;     // dy [m]
  double ultimate_displacement = 0;  // du [m], at 0.8 peak
  double ductility = 0;              // du / dy
  bool censored = true;  // 0.8 peak was never crossed: du and ductility are lower bounds
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

// One direction of a cyclic push, read from its envelope; all numbers are positive.
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

// One cycle of a cyclic push, complete or not. NaN: the cycle has no such number.
struct Cycle {
  // "full": both directions, each from zero displacement and back; "half": one direction, so;
  // "partial": turned back, but not from zero to zero; "unfinished": never turned back.
  std::string kind;
  double displacement_max = 0, displacement_min = 0;  // where it turned [m]
  double reaction_max = 0, reaction_min = 0;          // largest force in each direction [N]
  double residual_max = 0, residual_min = 0;          // where the force is first zero after it [m]
  double dissipated = 0;                              // area of the loop [J]
  double drag = 0;           // of it, taken by the gap between reaction and base shear [J]
  double stiffness = 0;      // secant between its extremes [N/m]
  double damping_ratio = 0;  // equivalent viscous, E_D / (4 pi E_so)
  std::int64_t repeat = 1;   // 1: the first of its displacements
  double kept = 1;           // its forces against those of the first [-]
  bool in_balance = true;  // its forces are of rows in balance; false: there were none, of any row
};

// Results of a cyclic push (docs/reference/results.md, "Cyclic pushes"). The other members of
// Responses are then those of the direction with the larger peak.
struct CyclicReadings {
  std::int64_t sense = 0;  // of the other members: 1 along the push, -1 against it; 0: not cyclic
  DirectionReadings positive, negative;
  std::vector<Cycle> cycles;
  double work = 0;  // of the reaction along the whole path [J]
};

// Responses read off the curve; definitions in docs/reference/results.md.
struct Responses {
  // The capacity: the largest reaction of a row in balance (is_in_balance); of a load-controlled
  // stage the largest load carried in balance. NaN where there is none: peak_reason says why.
  double peak_reaction = 0;             // [N]
  double displacement_at_peak = 0;      // [m]
  Message peak_reason = {};             // why there is no capacity; empty where there is one
  bool censored_peak = false;           // still rising, or the load never brought the wall down
  double peak_raw = 0;                  // largest reaction of any row, in balance or not [N]
  double displacement_at_peak_raw = 0;  // [m]
  // The first fall below 0.8 peak that lasts, the first and the last of all [m] (FallTo).
  double displacement_at_80 = 0, first_fall_80 = 0, last_fall_80 = 0;
  bool censored_80 = true, censored_first_80 = true, censored_last_80 = true;
  double displacement_max = 0;  // [m], where the reaction stays below 0.2 peak
  bool censored_max = true;
  double initial_stiffness = 0;  // [N/m], secant between 10 and 30 % of the peak
  double load_height = 0;        // what drifts are measured over [m]; 0: not known, no drifts
  double drift_at_peak = 0, drift_at_80 = 0, drift_max = 0;  // displacement / load_height [-]
  double work_to_peak = 0, work_to_80 = 0, work_total = 0;   // area under the curve [J]
  std::vector<FallTo> falls = {};           // one for each fraction asked for, in that order
  std::vector<FallTo> drift_capacity = {};  // d(r), one for each of kSharesLeft
  std::vector<Dip> dips = {};               // below 0.8 of the force before, in their order
  Bilinear bilinear = {};
  Collapse collapse = {};
  CyclicReadings cyclic = {};
};

// Shares of the peak at which the displacement capacity d(r) is read.
inline constexpr double kSharesLeft[] = {0.95, 0.9, 0.85, 0.8, 0.75, 0.7, 0.65, 0.6, 0.55, 0.5};
// d(0.75) over d(0.85) above which the share that is asked for decides the capacity.
inline constexpr double kThresholdDecides = 1.5;

// Further readings that are asked for, and facts that the curve alone does not hold.
struct ResponseOptions {
  std::vector<double> fractions = {0.8, 0.5};  // of the peak, after it, each in (0, 1)
  Message collapse = {};                       // why the run ended by collapse, empty: it did not
  std::vector<RisePoint> rise = {};            // for stiffnesses; empty: read off the rows
  double carried = kUnset;  // load-controlled: the largest load carried in balance [N]
};
// Whether d(0.75) is more than kThresholdDecides times d(0.85); nothing where the push ended too soon to tell.
[[nodiscard]] std::optional<bool> threshold_decides(const std::vector<FallTo>& drift_capacity);
[[nodiscard]] Responses read_responses(const std::vector<CurveRow>& curve,
                                       const ResponseOptions& options = {});
// The curve from which responses are read: the curve itself; of a cyclic push the envelope of the
// direction with the larger peak, with positive numbers.
[[nodiscard]] std::vector<CurveRow> backbone_of(const std::vector<CurveRow>& curve);

// Whether reaction and base shear of a row, of its neighbours and of all rows within 2.5 % of its
// displacement agree within 2 % of its reaction, so that inertia and drag have no part in it.
[[nodiscard]] bool is_in_balance(const std::vector<CurveRow>& curve, std::size_t row);

struct EnergyLedger {
  double loads = 0, drive = 0;                      // work put in [J]
  double kinetic = 0, elastic = 0;                  // stored [J]
  double friction = 0, fracture = 0, crushing = 0;  // dissipated in joints [J]
  double damping = 0;                               // taken by local damping [J]
  double hand_over = 0;                             // taken by hand-overs of contacts [J]
  double gap = 0;                                   // input - stored - dissipated [J]
  double gap_ratio = 0;                             // |gap| / (|loads| + |drive| + elastic)
};

// How nearly static the push was at its peak, in numbers and in words (docs/theory/integration.md,
// "Is it static enough?"). NaN: not known.
struct RateVerdict {
  double unbalance_ratio_mean = 0, unbalance_ratio_max = 0;  // over the rows around the peak
  double kinetic_ratio_mean = 0, kinetic_ratio_max = 0;      // over the rows around the peak
  double shear_gap = 0;      // |mean of (reaction - base shear)| / peak, rows around the peak
  double damping_share = 0;  // of the drive's work on the way to the peak (its last fifth, median)
  double beyond = 0;         // largest min(reaction, base shear) of any row / peak - 1
  double lift = 0;           // a slow push moves the peak by no more than about this share of it
  std::string judgement = "no push";  // "slow enough", "usable", "too fast", "unknown", "no push"
  Message verdict;                    // the judgement with its reason and cure
};

// Something that happened during the run and is marked on the curve.
struct Event {
  Message name;                  // "first crack", "first full crack", "peak", ...
  double displacement = 0;       // [m]
  double reaction = 0;           // [N]
  Message where = {};            // joint kind and place
  bool is_beyond_limit = false;  // a zone's stress passed the limit of its material
};

// A measure and its threshold.
struct Evidence {
  std::string element, measure;
  double value = 0, threshold = 0;
  std::string unit;
  [[nodiscard]] bool holds() const { return value >= threshold; }
  // How far beyond the threshold, as a share of it; negative below.
  [[nodiscard]] double margin() const { return threshold > 0 ? value / threshold - 1 : 0.0; }
};

// One thing that can happen to an element, and the measure that decides whether it did.
struct ElementSign {
  std::string state;    // "flexural crack", "rocking", "diagonal shear crack", "sliding", ...
  std::string measure;  // in words
  double value = 0, threshold = 0;
  std::string unit;                                                      // of both: "mm", "-"
  double displacement_first = std::numeric_limits<double>::quiet_NaN();  // of the first state read
                                                                         // that shows it [m]
  [[nodiscard]] bool holds() const { return value >= threshold; }
};

// What happened to one pier, spandrel, connection or toe.
struct ElementState {
  std::string element;             // "left pier", "spandrel", "left connection", ...
  std::string kind;                // "pier", "spandrel", "connection", "toe"
  std::string state = "intact";    // the signs that hold, gravest first: "rocking, flexural crack"
  std::vector<ElementSign> signs;  // all that were looked for
  // Displacement of the first state that showed a sign of `state` [m], NaN: intact.
  double displacement_first = std::numeric_limits<double>::quiet_NaN();
};

// The failure mode that another reading gives: at another stored state or with another threshold.
struct NameReading {
  std::string name;
  std::string state;        // label of the other state, "20 mm", "peak", "end"; "" at the same one
  double displacement = 0;  // of the state read [m]
  std::string threshold = {};  // the changed threshold, "crack width"; "": none
  double factor = 1;           // by which it was changed
  // "at 20 mm", "at the peak", "crack width x 1.25": the same words for every wall.
  [[nodiscard]] Message what() const;
};

struct FailureMode {
  std::string name = "unclear";
  Message words = {};  // the name, for a reader; not in the store
  std::map<std::string, double> scores;
  std::vector<Evidence> evidence;
  Message sentence;    // in plain words
  double read_at = 0;  // displacement at which it was read [m]
  // In words: "read at 40.0 mm", "read at 18.3 mm, where the push ended". Not in the store.
  Message reading = {};
  std::vector<ElementState> elements = {};
  std::vector<Evidence> flags = {};  // severity; raised where value >= threshold
  std::vector<NameReading> sensitivity = {};
};

// Where the model stops being valid. Contact points belong to the faces that touched at the start. A
// compressed joint whose faces overlap by less than half carries a force where there is no face left.
struct Validity {
  double overlap_lost = std::numeric_limits<double>::quiet_NaN();  // of the first row that shows
                                                                   // such a joint [m], NaN: none
  int joints = 0;  // number of such joints, over all rows
  Message where;   // kind and place of the first one
  [[nodiscard]] bool holds() const { return joints == 0; }
};

// A sum over the joints of a region in one stored state.
struct Feature {
  std::string name;         // "left_pier_opening", "spandrel_slip", "base_crushing"
  double displacement = 0;  // of the stored state [m]
  double value = 0;         // [m], sum over the region's joints of the mean over their points
};

struct Snapshot {
  std::string label;        // "start of push", "peak", "20 mm", "end"
  double displacement = 0;  // [m]
  double reaction = 0;      // [N]
  State state;
  double asked = kUnset;  // by output.states, at this displacement [m]
};

// A link at the end of a row of the curve.
struct LinkRow {
  double force = 0, elongation = 0, plastic = 0;  // tension + [N], [m], [m]
};

// A link of a frame at the end of a row of the curve.
struct FrameRow {
  double normal = 0, shear = 0, moment = 0;  // [N], [N], [N m]; signs: FrameReading
};

// What a frame bore over the curve.
struct FrameUse {
  double use = 0;           // largest of its sections, of what they bear [-]
  double displacement = 0;  // of the row [m]
  Message where;            // "the top of the left column"
  double yields_at =
      std::numeric_limits<double>::quiet_NaN();  // of the first row with a fibre beyond
                                                 // its yield stress [m]; NaN: none
  Message yields_where;
};

// "frame F1: use 0.73, yields at 14.2 mm at the top of the left column".
[[nodiscard]] Message sentence_of(const FrameUse& use, const std::string& frame);

// A layer at the end of a row of the curve.
struct LayerRow {
  double use = 0;  // largest force of its fibres over their strength; 1 where any are broken [-]
  double detached = 0;  // share of its bonded length that has come off [-]
  double broken = 0;    // share of its strands that are broken [-]
  double x = 0, y = 0;  // where the use is largest, as built [m]
};
// What a layer bore over the curve.
struct LayerUse {
  double use = 0;           // largest [-]
  double displacement = 0;  // of the row where it was reached first [m]
  Message where;            // "(1.20, 0.55) m"
  double breaks_at =
      std::numeric_limits<double>::quiet_NaN();  // of the first row with broken fibres [m]
  double detached = 0, broken = 0;               // at the end of the curve, as in a row
};

// "layer east: use 0.73 at (1.20, 0.55) m, 4 % detached".
[[nodiscard]] Message sentence_of(const LayerUse& use, const std::string& layer);

struct StageReport {
  std::string name;
  double time = 0;  // spent [s]
  std::int64_t steps = 0;
  double unbalance_ratio = 0;  // at the end
  bool settled = false;
};

struct Result {
  SolveStatus status = SolveStatus::kCompleted;
  Message reason;  // which residual, where, when; why it stopped
  std::vector<CurveRow> curve;
  std::vector<RisePoint> rise;            // of a push
  std::vector<LinkRow> links;             // (rows of the curve, links of the model)
  std::vector<FrameRow> frame_rows;       // (rows of the curve, links of frames)
  std::vector<FrameUse> frame_uses;       // of each frame
  std::vector<LayerRow> layer_rows;       // (rows of the curve, layers)
  std::vector<LayerUse> layer_uses;       // of each layer
  StageKind curve_of = StageKind::kPush;  // what drove the curve
  Responses responses;
  EnergyLedger energy;
  RateVerdict quasi_static;
  Validity validity;
  Debris debris;  // where contacts are free
  std::vector<Event> events;
  std::vector<double>
      joint_crack_displacement;  // where damage first reached 1 [m], NaN never (n_joint)
  FailureMode failure_mode;
  std::vector<Feature> features;
  ShakeHistory history;   // rows of all shakes
  ShakeReadings shaking;  // what they say
  PushedWall pushed;      // where an assessment is asked for; set by read_pushed_wall()
  std::vector<Snapshot> snapshots;
  // States for the failure mode, independent of output.states: the first step at each millimetre and
  // at SolveOptions::read_modes_at, each turn of a cyclic push ("turn"), and the end ("end").
  std::vector<Snapshot> readings;
  std::vector<MovedBlocks> rise_shapes;  // of a push one way, up to where readings are as close
  std::vector<Snapshot> frames;          // between them, as many as SolveOptions::frames asked for
  std::vector<StageReport> stages;
  double load_factor = 0;       // largest lambda carried in balance (body force), tan(tilt)
  double top_displacement = 0;  // [m]
  std::int64_t steps = 0;
  double time_step = 0;  // [s], of the last stage
  double wall_seconds = 0;
  std::string state_hash;
};

[[nodiscard]] inline bool is_load_controlled(const Result& result) {
  return result.curve_of == StageKind::kBodyForce || result.curve_of == StageKind::kTilt;
}
// A warning to print before all numbers: why the peak is no strength, or how wrong it may be. "": none.
[[nodiscard]] Message warning_of(const Result& result);
// Options with which the responses of this run are read.
[[nodiscard]] ResponseOptions reading_of(const Model& model, const Result& result);

// Which columns the curve of this wall shows.
[[nodiscard]] ShownColumns columns_of(const Model& model);

}  // namespace wythe
