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
    j.slid += m.point_weight[k] * state.plastic_slip[p];
    j.force -= m.point_weight[k] * points[p].normal_stress * m.area[static_cast<std::size_t>(j.id)];
    j.crushed += m.point_weight[k] * state.crush[p];
    j.crushing = std::max(j.crushing, points[p].crushing);
  }
}

}  // namespace

WallMotion read_motion(const Model& m, const State& state) {
  const std::vector<PointStress> points = point_stresses(m, state);
  WallMotion wall;
  for (std::size_t j = 0; j < static_cast<std::size_t>(m.n_joint); ++j) {
    JointMotion joint;
    joint.kind = m.anatomy.joint_kind[j];
    const auto b = static_cast<std::size_t>(m.joint_b[j]);
    joint.id = static_cast<JointId>(j);
    joint.is_bed = std::fabs(m.tangent_x[j]) >= std::fabs(m.tangent_y[j]);
    joint.on_ground = m.joint_a[j] == kGroundBlock;
    joint.x = m.centroid_x[b] + m.arm_b_x[j];
    joint.y = m.centroid_y[b] + m.arm_b_y[j];
    joint.reach_x = std::fabs(m.half_x[j]);
    joint.reach_y = std::fabs(m.half_y[j]);
    const JointMaterial& law = m.materials[static_cast<std::size_t>(m.joint_material[j])];
    joint.bond = m.area[j] * std::max(law.tensile_strength, law.cohesion);
    joint.has_slid_off = has_slid_off(m, points, joint.id);
    read_points(m, state, points, joint);
    const bool is_top = joint.kind == JointKind::kPlate || joint.kind == JointKind::kBeam;
    (is_top ? wall.top : wall.joints).push_back(joint);
  }
  for (std::size_t b = 0; b < static_cast<std::size_t>(m.n_block); ++b) {
    BlockMotion block;
    static_cast<RigidMotion&>(block) = {m.centroid_x[b], m.centroid_y[b], state.ux[b], state.uy[b],
                                        state.theta[b]};
    block.role = m.anatomy.block_role[b];
    block.mass = m.mass[b];
    block.inertia = m.inertia[b];
    wall.blocks.push_back(block);
  }
  return wall;
}

RigidMotion fitted(const std::vector<BlockMotion>& blocks, const Chosen& chosen) {
  RigidMotion fit;
  double mass = 0, turn = 0, inertia = 0;
  for (const BlockMotion& b : blocks) {
    if (!chosen(b)) continue;
    mass += b.mass;
    fit.x += b.mass * b.x;
    fit.y += b.mass * b.y;
    fit.ux += b.mass * b.ux;
    fit.uy += b.mass * b.uy;
  }
  if (!(mass > 0)) return fit;
  for (double* mean : {&fit.x, &fit.y, &fit.ux, &fit.uy}) *mean /= mass;
  for (const BlockMotion& b : blocks) {
    if (!chosen(b)) continue;
    const double x = b.x - fit.x, y = b.y - fit.y;
    turn += b.mass * (x * (b.uy - fit.uy) - y * (b.ux - fit.ux)) + b.inertia * b.turn;
    inertia += b.mass * (x * x + y * y) + b.inertia;
  }
  fit.turn = inertia > 0 ? turn / inertia : 0;
  return fit;
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

double slid_all_across(const BedSection& section, double width) {
  const auto one_way = [&](double sense) {
    BedSection slid = section;
    std::vector<JointMotion> joints;
    joints.reserve(section.joints.size());
    for (std::size_t j = 0; j < slid.joints.size(); ++j) {
      joints.push_back(*section.joints[j]);
      joints.back().slip = std::max(0.0, sense * joints.back().slid);
      slid.joints[j] = &joints.back();
    }
    return sense * slip_all_across(slid, width);
  };
  return one_way(1) + one_way(-1);  // 0.9 of the width cannot go both ways
}

}  // namespace wythe::study
