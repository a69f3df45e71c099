#include "study/joint_motion.h"

#include <algorithm>
#include <cmath>

#include "wythe/result.h"

namespace wythe::study {
namespace {

bool is_masonry(JointKind kind) {
  return kind != JointKind::kLintelChain && kind != JointKind::kLintelBond;
}

void read_points(const Model& m, const State& state, const std::vector<PointStress>& points,
                 JointMotion& j) {
  const auto per = static_cast<std::size_t>(m.n_face_point);
  for (std::size_t k = 0; k < per; ++k) {
    const std::size_t p = static_cast<std::size_t>(j.id) * per + k;
    const double most = std::max({0.0, points[p].opening, state.kappa[p]});
    j.opening += m.point_weight[k] * std::max(0.0, points[p].opening);
    j.opened += m.point_weight[k] * most;
    j.widest = std::max(j.widest, most);
    j.slip += m.point_weight[k] * points[p].slip;
    j.crushed += m.point_weight[k] * state.crush[p];
    j.crushing = std::max(j.crushing, points[p].crushing);
  }
}

}  // namespace

std::vector<JointMotion> read_joint_motion(const Model& m, const State& state) {
  const std::vector<PointStress> points = point_stresses(m, state);
  std::vector<JointMotion> joints;
  for (std::size_t j = 0; j < static_cast<std::size_t>(m.n_joint); ++j) {
    JointMotion joint;
    joint.kind = m.anatomy.joint_kind[j];
    if (joint.kind == JointKind::kPlate || joint.kind == JointKind::kBeam) continue;
    const auto b = static_cast<std::size_t>(m.joint_b[j]);
    joint.id = static_cast<JointId>(j);
    joint.is_bed = std::fabs(m.tangent_x[j]) >= std::fabs(m.tangent_y[j]);
    joint.on_ground = m.joint_a[j] == kGroundBlock;
    joint.x = m.centroid_x[b] + m.arm_b_x[j];
    joint.y = m.centroid_y[b] + m.arm_b_y[j];
    joint.reach_x = std::fabs(m.half_x[j]);
    joint.reach_y = std::fabs(m.half_y[j]);
    read_points(m, state, points, joint);
    joints.push_back(joint);
  }
  return joints;
}

double LineSum::movement() const { return std::hypot(opened, slip); }

std::vector<LineSum> scan(const std::vector<JointMotion>& joints, const Box& box, Lines lines,
                          double pitch) {
  const bool level = lines == Lines::kLevel;
  const double start = level ? box.y0 : box.x0, length = level ? box.height() : box.width();
  constexpr double kTouch = 1e-6;  // [m]
  const int n = 4 * std::max(1, static_cast<int>(std::lround(length / pitch)));
  const double step = length / n;
  std::vector<LineSum> sums(static_cast<std::size_t>(n));
  for (int i = 0; i < n; ++i) sums[static_cast<std::size_t>(i)].at = start + (i + 0.5) * step;
  for (const JointMotion& j : joints) {
    if (j.is_bed == level || !is_masonry(j.kind)) continue;
    const double across = level ? j.x : j.y;
    const double lo = level ? box.x0 : box.y0, hi = level ? box.x1 : box.y1;
    if (!(across > lo + kTouch && across < hi - kTouch)) continue;
    const double centre = level ? j.y : j.x, reach = level ? j.reach_y : j.reach_x;
    for (LineSum& line : sums) {
      if (std::fabs(line.at - centre) > reach) continue;
      line.opening += j.opening;
      line.opened += j.opened;
      line.slip += j.slip;
    }
  }
  return sums;
}

std::vector<BedSection> bed_sections(const std::vector<JointMotion>& joints, const Box& box,
                                     double course) {
  std::vector<const JointMotion*> beds;
  for (const JointMotion& j : joints)
    if (j.is_bed && box.holds(j.x, j.y)) beds.push_back(&j);
  std::stable_sort(beds.begin(), beds.end(),
                   [](const JointMotion* a, const JointMotion* b) { return a->y < b->y; });
  std::vector<BedSection> sections;
  for (const JointMotion* bed : beds) {
    if (sections.empty() || bed->y > sections.back().y + 0.25 * course)
      sections.push_back({bed->y, {}});
    sections.back().joints.push_back(bed);
  }
  return sections;
}

double open_share(const BedSection& section, double width, double crack) {
  double open = 0;
  for (const JointMotion* j : section.joints)
    if (j->widest >= crack) open += j->length();
  return std::min(1.0, open / width);
}

double slip_all_across(const BedSection& section, double width) {
  constexpr double kAll = 0.9;  // a corner may hang on
  std::vector<const JointMotion*> sorted = section.joints;
  std::sort(sorted.begin(), sorted.end(), [](const JointMotion* a, const JointMotion* b) {
    return std::fabs(a->slip) > std::fabs(b->slip);
  });
  double covered = 0;
  for (const JointMotion* j : sorted) {
    covered += j->length();
    if (covered >= kAll * width) return std::fabs(j->slip);
  }
  return 0;
}

}  // namespace wythe::study
