// Names the failure of a pushed wall from what its joints did; see include/wythe/failure_mode.h.
//
// Measures, each a share in [0, 1], on the wall's own grid (a joint counts when it has opened or
// slipped by more than 1 mm, a tenth of the mortar bed: visible, and beyond any elastic motion):
//
//   spandrel   inner columns of the spandrel with such a bed joint                 sheared  >= 0.7
//   pier i     courses of the pier's shaft with such a vertical joint inside       cracked  >= 0.4
//   slide i    columns of the pier in its most slipped course                      slides   >= 0.9
//   rock       widest opening at a pier's base                                     rocks    >= 1 mm
//
//   no spandrel shear: FM-5 no pier and rocking, FM-1 one pier, FM-2 both; spandrel shear: FM-3 any
//   pier, FM-4 none. Each claim counts from 0 to 1 over a tenth on either side of its threshold.
#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <utility>

#include "wythe/failure_mode.h"

namespace wythe {
namespace {

constexpr double kVisible = 1e-3;  // opening or slip that counts [m]
constexpr double kSheared = 0.7;   // of the spandrel's inner columns
constexpr double kCracked = 0.4;   // of a pier's shaft courses
constexpr double kSliding = 0.9;   // of a pier's columns in one course
constexpr double kReadAt = 40e-3;  // displacement at which the state is read [m]
constexpr double kNarrow = 0.1;    // on either side of a threshold a measure is in doubt
constexpr double kClear = 0.2;     // lead of the best score below which the name is "unclear"

struct Joint {
  JointKind kind;
  double x, y;           // centre at the start [m]
  double opening, slip;  // largest over its points [m]
  double crushing;
};

std::vector<Joint> read_joints(const Model& m, const State& state) {
  const std::vector<PointStress> points = point_stresses(m, state);
  const auto per = static_cast<std::size_t>(m.n_face_point);
  std::vector<Joint> joints;
  for (std::size_t j = 0; j < static_cast<std::size_t>(m.n_joint); ++j) {
    const auto b = static_cast<std::size_t>(m.joint_b[j]);
    Joint joint{m.anatomy.joint_kind[j],
                m.centroid_x[b] + m.arm_b_x[j],
                m.centroid_y[b] + m.arm_b_y[j],
                0,
                0,
                0};
    for (std::size_t p = j * per; p < (j + 1) * per; ++p) {
      joint.opening = std::max(joint.opening, points[p].opening);
      joint.slip = std::max(joint.slip, std::fabs(points[p].slip));
      joint.crushing = std::max(joint.crushing, points[p].crushing);
    }
    joints.push_back(joint);
  }
  return joints;
}

bool moved(const Joint& j) { return j.opening > kVisible || j.slip > kVisible; }
bool is_bed(const Joint& j) {
  return j.kind == JointKind::kBed || j.kind == JointKind::kFoundation ||
         j.kind == JointKind::kLintelBond;
}
bool is_vertical(const Joint& j) {
  return j.kind == JointKind::kHead || j.kind == JointKind::kSplit;
}

struct Box {
  double x0, x1, y0, y1;
  [[nodiscard]] bool holds(const Joint& j) const {
    return j.x > x0 && j.x < x1 && j.y > y0 && j.y < y1;
  }
};

// Share of the slots of `pitch` along x (or y) of the box in which some joint meets the claim.
template <class Claim>
double share_of_slots(const std::vector<Joint>& joints, const Box& box, double pitch, bool along_x,
                      const Claim& claim) {
  const double length = along_x ? box.x1 - box.x0 : box.y1 - box.y0;
  const double start = along_x ? box.x0 : box.y0;
  const int slots = std::max(1, static_cast<int>(std::lround(length / pitch)));
  std::set<int> met;
  for (const Joint& j : joints)
    if (box.holds(j) && claim(j))
      met.insert(std::clamp(static_cast<int>(((along_x ? j.x : j.y) - start) / length * slots), 0,
                            slots - 1));
  return static_cast<double>(met.size()) / slots;
}

class Namer {
 public:
  Namer(const Model& model, const Snapshot& snapshot)
      : a_(model.anatomy), joints_(read_joints(model, snapshot.state)) {
    column_ = a_.half_unit > 0 ? a_.half_unit : a_.length / 20;
    course_ = a_.course_height > 0 ? a_.course_height : a_.height / 15;
    mode_.read_at = snapshot.displacement;
  }

  FailureMode name() {
    for (std::size_t i = 0; i < a_.pier_x0.size(); ++i) measure_pier(i);
    if (a_.pier_x0.size() == 2 && a_.pier_height[0] < a_.height) {
      name_two_piers();
    } else {
      name_plainly();
    }
    return std::move(mode_);
  }

 private:
  void note(const std::string& element, const std::string& measure, double value, double threshold,
            const char* unit = "share") {
    mode_.evidence.push_back({element, measure, value, threshold, unit});
  }

  [[nodiscard]] std::string pier_name(std::size_t i) const {
    if (a_.pier_x0.size() == 1) return "wall";
    if (a_.pier_x0.size() == 2) return i == 0 ? "left pier" : "right pier";
    return fmt::format("pier {}", i + 1);
  }

  void measure_pier(std::size_t i) {
    const double x0 = a_.pier_x0[i], x1 = a_.pier_x1[i], top = a_.pier_height[i];
    const double width = x1 - x0;
    // the shaft: above the toe zone (a quarter of the width), inside the two outer columns
    const Box shaft{x0 + 0.5 * column_, x1 - 0.5 * column_, std::min(0.25 * width, 0.25 * top),
                    top};
    const double cracked = share_of_slots(
        joints_, shaft, course_, false, [](const Joint& j) { return is_vertical(j) && moved(j); });
    cracked_.push_back(cracked);
    note(pier_name(i), "courses with an open vertical joint", cracked, kCracked);
    double slid = 0;
    const Box whole{x0, x1, -1e-6, top};
    std::set<long> levels;
    for (const Joint& j : joints_)
      if (whole.holds(j) && is_bed(j)) levels.insert(std::lround(j.y / course_ * 8));
    for (const long level : levels) {
      const double y = static_cast<double>(level) * course_ / 8;
      const Box row{x0, x1, y - 0.1 * course_, y + 0.1 * course_};
      slid = std::max(slid, share_of_slots(joints_, row, column_, true, [](const Joint& j) {
                        return is_bed(j) && j.slip > kVisible;
                      }));
    }
    slid_.push_back(slid);
    note(pier_name(i), "columns sliding in one course", slid, kSliding);
    double crushed = 0, opened = 0;
    const Box base{x0, x1, -1e-6, 0.25 * width};
    for (const Joint& j : joints_) {
      if (!base.holds(j)) continue;
      crushed = std::max(crushed, j.crushing);
      if (is_bed(j)) opened = std::max(opened, j.opening);
    }
    crushed_.push_back(crushed);
    note(pier_name(i), "crushing at the toe", crushed, 0.05);
    opened_.push_back(opened);
    note(pier_name(i), "opening at the base", 1e3 * opened, 1e3 * kVisible, "mm");
  }

  void name_two_piers() {
    const double inner0 = a_.pier_x1[0], inner1 = a_.pier_x0[1];
    const Box spandrel{inner0, inner1, a_.pier_height[0] + 0.5 * course_, a_.height};
    const double sheared = share_of_slots(joints_, spandrel, column_, true,
                                          [](const Joint& j) { return is_bed(j) && moved(j); });
    note("spandrel", "columns with a moved bed joint", sheared, kSheared);
    const double s = holds(sheared, kSheared);
    const double left = holds(cracked_[0], kCracked), right = holds(cracked_[1], kCracked);
    const double none = (1 - left) * (1 - right), both = left * right;
    const double opened = std::max(opened_[0], opened_[1]) / kVisible;
    note("piers", "opening at a base", 1e3 * kVisible * opened, 1e3 * kVisible, "mm");
    const double rocks = holds(opened, 1.0);
    mode_.scores = {{"FM-1", (1 - s) * (1 - none - both)},
                    {"FM-2", (1 - s) * both},
                    {"FM-3", s * (1 - none)},
                    {"FM-4", s * none},
                    {"FM-5", (1 - s) * none * rocks}};
    name_highest_score();
  }

  // How surely a measure is beyond its threshold: 0 a tenth below, 1 a tenth above.
  static double holds(double value, double threshold) {
    return std::clamp(0.5 + (value - threshold) / (2 * kNarrow), 0.0, 1.0);
  }

  void name_highest_score() {
    static const std::map<std::string, const char*> kWords = {
        {"FM-1", "one pier cracks diagonally after flexural cracks at the connections"},
        {"FM-2", "both piers crack diagonally after flexural cracks at the connections"},
        {"FM-3", "the spandrel fails in flexure and shear and a pier cracks diagonally"},
        {"FM-4",
         "the spandrel fails in flexure and shear; the piers rock with damage at their toes"},
        {"FM-5", "the piers rock, with flexural cracks at the connections"}};
    std::vector<std::pair<double, std::string>> ranked;
    for (const auto& [name, score] : mode_.scores) ranked.emplace_back(-score, name);
    std::sort(ranked.begin(), ranked.end());
    const std::string first = ranked[0].second, second = ranked[1].second;
    mode_.name = first;
    mode_.sentence = kWords.at(first);
    if (-ranked[0].first < kClear) {
      mode_.name = "unclear";
      mode_.sentence = "no mechanism shows at this displacement";
      return;
    }
    if (ranked[1].first - ranked[0].first >= kClear) return;
    mode_.name = "unclear";
    mode_.sentence = fmt::format("between {} ({}) and {} ({})", first, kWords.at(first), second,
                                 kWords.at(second));
  }

  // Any other wall: what happened, in words, the gravest first.
  void name_plainly() {
    std::vector<std::string> found;
    const auto add = [&](const char* word, const std::vector<double>& measure, double threshold) {
      for (std::size_t i = 0; i < measure.size(); ++i)
        if (measure[i] >= threshold)
          found.push_back(fmt::format("{} of the {}", word, pier_name(i)));
    };
    add("diagonal cracking", cracked_, kCracked);
    add("sliding", slid_, kSliding);
    add("rocking", opened_, kVisible);
    add("toe crushing", crushed_, 0.05);
    for (const std::string& word : found) mode_.scores[word] = 1;
    mode_.name = found.empty() ? "unclear" : found.front();
    mode_.sentence = found.empty() ? "no element shows a mechanism at this displacement" : "";
    for (std::size_t i = 0; i < found.size(); ++i)
      mode_.sentence += (i == 0 ? "" : ", ") + found[i];
  }

  const Anatomy& a_;
  std::vector<Joint> joints_;
  std::vector<double> cracked_, slid_, crushed_, opened_;  // by pier
  double column_ = 0, course_ = 0;
  FailureMode mode_;
};

}  // namespace

FailureMode name_failure_mode(const Model& model, const Result& result) {
  const Snapshot* read = nullptr;
  for (const Snapshot& s : result.snapshots)
    if (s.label != "start" && s.displacement <= kReadAt * 1.01 &&
        (read == nullptr || s.displacement >= read->displacement))
      read = &s;
  if (read == nullptr) {
    FailureMode none;
    none.sentence = "no state of a push to read";
    return none;
  }
  return Namer(model, *read).name();
}

}  // namespace wythe
