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
#include "wythe/parts/responses.h"
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

// Displacement of each block along a push. Readings are a millimetre apart, far beyond the yield of a
// stiff wall; these states are at most a twentieth of the displacement apart.
struct MovedBlocks {
  double displacement = 0;    // of the curve [m]
  std::vector<double> moved;  // by block; supports 0 [m]
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

// What ties, springs, frames and layers did.
struct Strengthening {
  std::vector<LinkRow> links;        // (rows of the curve, links of the model)
  std::vector<FrameRow> frame_rows;  // (rows of the curve, links of frames)
  std::vector<FrameUse> frame_uses;  // of each frame
  std::vector<LayerRow> layer_rows;  // (rows of the curve, layers)
  std::vector<LayerUse> layer_uses;  // of each layer
};

// States of the wall that a run keeps.
inline constexpr double kReadingsApart = 1e-3;  // at most, of a push that goes on [m]

struct KeptStates {
  std::vector<Snapshot> snapshots;  // start, output.states, peak and end
  // For the failure mode, independent of output.states: the first step at each millimetre and at
  // SolveOptions::read_modes_at, each turn of a cyclic push ("turn"), and the end ("end").
  std::vector<Snapshot> readings;
  std::vector<MovedBlocks> rise_shapes;  // of a one-way push, until readings are as close
  std::vector<Snapshot> frames;          // between snapshots, as SolveOptions::frames requests
};

struct Result {
  SolveStatus status = SolveStatus::kCompleted;
  Message reason;  // residual with place and time, and why the stage stopped
  std::vector<CurveRow> curve;
  std::vector<RisePoint> rise;  // of a push
  Strengthening strengthening;
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
  KeptStates states;
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
