// Compares a run with the tested walls of its failure kind; see wythe/parts/tested_range.h.
#include "judge/modes/tested_range.h"

#include <algorithm>
#include <cmath>

#include "judge/modes/wall_parts.h"
#include "wythe/parts/reading.h"

namespace wythe {
namespace {

using study::TestedKind;

// A wall this much beyond the most extreme test still counts as similar, because tests of a kind differ by more.
constexpr double kNearTested = 1.25;
constexpr double kUsableLow = 0.9, kUsableHigh = 1.15;  // a bias between them is not reported
constexpr double kUsableFactor = 1.65;  // of drifts: exp(0.5); a constant of shear has exp(0.38)
constexpr int kFew = 3;                 // below so many walls a bias means little

bool is_beyond(double value, double low, double high) {
  return value < low / kNearTested || value > kNearTested * high;
}

// Mean pressure on the ground before the push, over the strength there; NaN where no joint crushes.
double axial_ratio(const Model& model, const Result& result) {
  if (result.states.snapshots.empty()) return kUnset;
  double force = 0, strength = 0;
  const WallReading wall = read_wall(model, result.states.snapshots.front().state);
  for (const JointReading& j : wall.joints) {
    if (j.shape.a != kGroundBlock && j.shape.b != kGroundBlock) continue;
    force += j.compression;
    strength += j.shape.area * model.materials[j.shape.material].compressive_strength;
  }
  return std::isfinite(strength) && strength > 0 ? force / strength : kUnset;
}

// Ratio of the rotational stiffness of a joint with points to that of a continuous one; 3 with two end points.
double times_too_stiff(const Model& model, const Result& result) {
  if (result.states.snapshots.empty() || joint_count(model) == 0) return kUnset;
  const std::vector<PointReading> points =
      read_points(model, result.states.snapshots.front().state);
  double inertia = 0;
  const PointRange first = points_of(model, 0);
  for (PointId p = first.begin; p < first.end; ++p) {
    const PointReading& point = points[p];
    inertia += point.share * point.place * point.place;
  }
  return 3 * inertia;
}

// --- reasons ---------------------------------------------------------------------------------------

void note_shape(std::vector<Message>& notes, const TestedKind& tested, const Model& model,
                const Result& result) {
  const study::Box wall = study::find_parts(model).wall;
  const double slender = wall.height() / wall.width();
  if (is_beyond(slender, tested.slender_low, tested.slender_high))
    notes.push_back(
        {"range.slenderness",
         {{"value", slender}, {"low", tested.slender_low}, {"high", tested.slender_high}}});
  const double axial = axial_ratio(model, result);
  if (is_beyond(axial, tested.axial_low, tested.axial_high))
    notes.push_back({"range.axial",
                     {{"value_percent", 100 * axial},
                      {"low_percent", 100 * tested.axial_low},
                      {"high_percent", 100 * tested.axial_high}}});
}

const char* kind_key(const std::string& kind) {
  if (kind == "shear") return "range.kind_shear";
  return kind == "sliding" ? "range.kind_sliding" : "range.kind_rocking";
}

// Shear and rocking together count as a kind of their own.
std::string drift_kind(const std::string& name) {
  const bool both =
      name.find("shear") != std::string::npos && name.find("rocking") != std::string::npos;
  return both ? "mixed" : kind_of_mode(name);
}

TestedDrift drift_of(const Model& model, const std::string& kind) {
  TestedDrift out;
  out.stone = study::is_dry(model);  // tested stone walls have units that cannot crack
  if (!out.stone && !has_unit_planes(model)) return out;
  for (const study::TestedDriftKind& tested : study::kTestedDrifts) {
    if (kind != tested.kind || out.stone != tested.stone) continue;
    out.walls = tested.walls;
    out.median = tested.median, out.low = tested.low, out.high = tested.high;
  }
  for (const study::OwnDrift& own : study::kOwnDrifts)
    if (!out.stone && kind == own.kind)
      out.own_walls = own.walls, out.own_ratio = own.ratio, out.own_factor = own.factor;
  return out;
}

void note_bias(std::vector<Message>& notes, const TestedKind& tested) {
  const Message kind{kind_key(tested.kind)};
  if (tested.walls < kFew) {
    notes.push_back({"range.few", {{"kind", kind}, {"walls", tested.walls}}});
  } else if (tested.bias < kUsableLow || tested.bias > kUsableHigh) {
    notes.push_back({"range.bias",
                     {{"kind", kind},
                      {"walls", tested.walls},
                      {"bias", tested.bias},
                      {"low", tested.bias_low},
                      {"high", tested.bias_high}}});
  }
}

}  // namespace

std::string kind_of_mode(const std::string& name) {
  const auto has = [&](const char* word) { return name.find(word) != std::string::npos; };
  if (has("shear")) return "shear";
  if (has("sliding")) return "sliding";
  if (has("rocking") || has("toe crushing") || has("flexural")) return "rocking";
  return "";
}

Message note_of(const TestedRange& range) {
  return range.notes.empty() ? Message{} : Message{"range.note", {{"notes", range.notes}}};
}

Message drift_note_of(const TestedRange& range) {
  const TestedDrift& d = range.drift;
  if (d.walls == 0) return {};
  Message note{d.stone ? "range.drift_stone" : "range.drift_brick",
               {{"walls", d.walls},
                {"median", 1e2 * d.median},
                {"low", 1e2 * d.low},
                {"high", 1e2 * d.high}}};
  if (d.own_walls < kFew) return note;
  const char* own = d.own_factor > kUsableFactor ? "range.drift_worthless" : "range.drift_own";
  return {
      "range.drift_both",
      {{"tests", std::move(note)},
       {"own",
        Message{own, {{"walls", d.own_walls}, {"ratio", d.own_ratio}, {"factor", d.own_factor}}}}}};
}

bool study::is_dry(const Model& model) {
  for (JointId j = 0; j < joint_count(model); ++j) {
    const auto& law = model.materials[joint_shape(model, j).material];
    if (law.tensile_strength > 0 || law.cohesion > 0) return false;
  }
  return true;
}

TestedRange study::compare_with(std::span<const TestedKind> tests, const Model& model,
                                const Result& result) {
  TestedRange range;
  if (is_load_controlled(result) || !(result.responses.peak_reaction > 0)) return range;
  if (const int openings = study::find_parts(model).openings; openings > 0) {
    range.notes.push_back({"range.openings", {{"openings", openings}}});
    return range;
  }
  range.kind = kind_of_mode(result.failure_mode.name);
  range.drift = drift_of(model, drift_kind(result.failure_mode.name));
  const auto tested = std::find_if(tests.begin(), tests.end(),
                                   [&](const TestedKind& k) { return range.kind == k.kind; });
  if (tested == tests.end()) {
    range.notes.push_back({"range.no_kind"});
    return range;
  }
  range.walls = tested->walls;
  range.bias = tested->bias;
  range.bias_low = tested->bias_low;
  range.bias_high = tested->bias_high;
  range.scatter = tested->scatter;
  note_bias(range.notes, *tested);
  note_shape(range.notes, *tested, model, result);
  if (range.kind == "shear" && !has_unit_planes(model)) range.notes.push_back({"range.no_planes"});
  if (result.responses.cyclic.sense != 0) range.notes.push_back({"range.cyclic"});
  if (const double times = times_too_stiff(model, result); times > kNearTested)
    range.notes.push_back({"range.points", {{"times", times}}});
  return range;
}

TestedRange compare_with_tests(const Model& model, const Result& result) {
  return study::compare_with(study::kTestedKinds, model, result);
}

}  // namespace wythe
