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

// How far each block has gone along a push since its start. Readings lie a millimetre apart, which is far
// beyond the yield of a stiff wall; these lie a twentieth of the displacement apart or less.
struct MovedBlocks {
  double displacement = 0;    // of the curve [m]
  std::vector<double> moved;  // by number of the block; supports 0 [m]
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
