// Internal forces of frame sections in a state.
#include <algorithm>
#include <cmath>

#include "core/rotation.h"
#include "reading/frames.h"
#include "reading/readers.h"
#include "reading/space_frames.h"
#include "wythe/parts/reading.h"

namespace wythe {
namespace {

// One end of a section, with the rotation of its block.
struct Side {
  contact::LinkEnd end;
  double turn, cos, sin;  // of half the rotation
};
Side side_of(const State& s, BlockId block, double arm_x, double arm_y) {
  if (block == kGroundBlock) return {{0, 0, 0, 0}, 0, 1, 0};
  const SinCos<double> half = sin_cos(0.5 * s.theta[block]);
  return {contact::link_end(s.ux[block], s.uy[block], half.cos, half.sin, arm_x, arm_y),
          s.theta[block], half.cos, half.sin};
}

double stored_in(double stiffness, double force) {
  return stiffness > 0 ? 0.5 * force * force / stiffness : 0.0;
}

}  // namespace

namespace reading {

SectionPlace section_in(const Model& m, const State& s, std::size_t k) {
  const Frames& f = m.frames;
  const Side a = side_of(s, f.a[k], f.arm_a_x[k], f.arm_a_y[k]);
  const Side b = side_of(s, f.b[k], f.arm_b_x[k], f.arm_b_y[k]);
  contact::SectionJump jump =
      contact::section_jump(f.axis_x[k], f.axis_y[k], f.rest_x[k], f.rest_y[k], a.end, b.end,
                            a.turn, b.turn, a.cos, a.sin, b.cos, b.sin);
  if (!s.frame_turn.empty()) {
    jump.along -= s.frame_along[k];
    jump.across -= s.frame_across[k];
    jump.turn -= s.frame_turn[k];
  }
  return {jump, b.end};
}

}  // namespace reading

double section_use(const FrameMember& m, double normal, double shear, double moment) {
  const double bent = std::fabs(moment) / (m.yield_strength * m.plastic_modulus);
  const double pulled = std::fabs(normal) / (m.yield_strength * m.area);
  const double outer = m.second_moment / (m.area * m.fibre * m.fibre);  // both outer fibres' share
  const double sheared = std::sqrt(3.0) * std::fabs(shear) / (m.yield_strength * m.shear_area);
  return std::max({bent, pulled + outer * bent, sheared});
}

namespace reading {

std::vector<FrameReading> frames_in_space(const Model& m, const State& s) {
  const Frames& f = m.frames;
  std::vector<FrameReading> read(f.a.size());
  for (std::size_t k = 0; k < read.size(); ++k) {
    const SpaceSectionJump jump = section_in_space(m, s, k);
    const contact::SectionForces forces = section_forces_in_space(f, s, k, jump);
    const FrameMember& member = m.frames.members[f.member[k]];
    FrameReading& now = read[k];
    const Vec3 arm{f.arm_b_x[k], f.arm_b_y[k], f.arm_b_z[k]};
    now.where = m.space.centroid[f.b[k]] + arm + moved_in_space(m, s, f.b[k], arm);
    if (!m.standing.joins(f.a[k], f.b[k], s.stage)) continue;  // not installed yet
    // a foot at the end of the member, where the ground is side a, has its axis reversed
    const bool back = f.a[k] == kGroundBlock && f.place[k] > 0.5 * member.length;
    now.normal = forces.normal;
    now.shear = -forces.shear;
    now.moment = back ? -forces.moment : forces.moment;
    now.use = section_use(member, now.normal, now.shear, now.moment);
    now.plastic = std::max({std::fabs(s.frame_left[k] + forces.left.flow),
                            std::fabs(s.frame_middle[k] + forces.middle.flow),
                            std::fabs(s.frame_right[k] + forces.right.flow)});
    now.stored = stored_in(f.outer_stiffness[k], forces.left.force) +
                 stored_in(f.outer_stiffness[k], forces.right.force) +
                 stored_in(f.middle_stiffness[k], forces.middle.force) +
                 stored_in(f.shear_stiffness[k], forces.shear) +
                 0.5 * (f.aside_stiffness[k] * jump.aside * jump.aside +
                        f.lean_stiffness[k] * jump.lean * jump.lean +
                        f.twist_stiffness[k] * jump.twist * jump.twist);
  }
  return read;
}

std::vector<FrameReading> frames_in_plane(const Model& m, const State& s) {
  const Frames& f = m.frames;
  std::vector<FrameReading> read(f.a.size());
  for (std::size_t k = 0; k < read.size(); ++k) {
    const auto [jump, end_b] = section_in(m, s, k);
    const contact::SectionLaw law{f.outer_stiffness[k], f.middle_stiffness[k], f.shear_stiffness[k],
                                  f.fibre[k],           f.outer_yield[k],      f.middle_yield[k]};
    const contact::SectionForces forces =
        contact::section_forces(law, jump, s.frame_left[k], s.frame_middle[k], s.frame_right[k]);
    const FrameMember& member = m.frames.members[f.member[k]];
    // a foot at the end of the member has its axis reversed
    const double forth = f.axis_x[k] * member.direction_x + f.axis_y[k] * member.direction_y;
    FrameReading& now = read[k];
    const std::size_t i = f.b[k];
    now.where = {m.centroid_x[i] + f.arm_b_x[k] + end_b.moved_x,
                 m.centroid_y[i] + f.arm_b_y[k] + end_b.moved_y, 0};
    if (!m.standing.joins(f.a[k], f.b[k], s.stage)) continue;  // not installed yet
    now.normal = forces.normal;
    now.shear = -forces.shear;
    now.moment = forth < 0 ? -forces.moment : forces.moment;
    now.use = section_use(member, now.normal, now.shear, now.moment);
    now.plastic = std::max({std::fabs(s.frame_left[k] + forces.left.flow),
                            std::fabs(s.frame_middle[k] + forces.middle.flow),
                            std::fabs(s.frame_right[k] + forces.right.flow)});
    now.stored = stored_in(law.outer, forces.left.force) +
                 stored_in(law.outer, forces.right.force) +
                 stored_in(law.middle, forces.middle.force) + stored_in(law.shear, forces.shear);
  }
  return read;
}

}  // namespace reading
}  // namespace wythe
