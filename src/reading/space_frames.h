// The section of a frame in space (docs/theory/frames.md, "In space"): a face with t1 to the left of the member and
// n along its axis. In the frame's plane it has the three fibres of the plane's section; normal to it, it is elastic.
// Called by the step (dynamics/space/frames.h), by the start of a cut, and by readers of a state.
#pragma once

#include "contact/face_in_space.h"
#include "contact/section.h"
#include "wythe/parts/model.h"

namespace wythe::reading {

// Relative position of b's side of a section: in the plane, as the plane's law receives it, and out of it.
struct SpaceSectionJump {
  contact::SectionJump in_plane;
  double aside, lean, twist;  // [m]; rotation about the left, about the axis [rad]
};
[[nodiscard]] inline SpaceSectionJump section_jump_in_space(const contact::FaceGap<double>& gap) {
  return {{.along = gap.j.z,
           .across = gap.j.x,
           .turn = -gap.a.z,
           .axis_x = 0,
           .axis_y = 0,
           .gap_x = 0,
           .gap_y = 0},
          gap.j.y,
          gap.b.z,
          0.5 * (gap.a.y - gap.b.x)};
}

// Calls act(face) with the face of section k between the poses that pose_of(block) returns; the ground is fixed.
template <class PoseOf, class Act>
auto with_section(const Frames& f, std::size_t k, const PoseOf& pose_of, const Act& act) {
  const auto of = [](const Vec3& v) { return Vector<double>{v.x, v.y, v.z}; };
  const Vector<double> axis{f.axis_x[k], f.axis_y[k], f.axis_z[k]}, left = of(f.left[k]);
  const Vector<double> rest{f.rest_x[k], f.rest_y[k], f.rest_z[k]};
  const Vector<double> arm_a{f.arm_a_x[k], f.arm_a_y[k], f.arm_a_z[k]};
  const Vector<double> arm_b{f.arm_b_x[k], f.arm_b_y[k], f.arm_b_z[k]};
  const contact::Pose<double> b = pose_of(f.b[k]);
  if (f.a[k] == kGroundBlock) return act(contact::SupportFace<double>(rest, b, arm_b, left, axis));
  contact::Pose<double> a = pose_of(f.a[k]);
  a.u = a.u + rest;
  return act(contact::PairFace<double>(a, b, arm_a, arm_b, left, axis));
}

// Subtracts the jump at installation, where a stage installed the section.
inline void take_off_set(const State& s, std::size_t k, SpaceSectionJump& jump) {
  if (s.frame_turn.empty()) return;
  jump.in_plane.along -= s.frame_along[k];
  jump.in_plane.across -= s.frame_across[k];
  jump.in_plane.turn -= s.frame_turn[k];
  jump.aside -= s.frame_aside[k];
  jump.lean -= s.frame_lean[k];
  jump.twist -= s.frame_twist[k];
}

[[nodiscard]] inline contact::SectionForces section_forces_in_space(const Frames& f, const State& s,
                                                                    std::size_t k,
                                                                    const SpaceSectionJump& jump) {
  const contact::SectionLaw law{f.outer_stiffness[k], f.middle_stiffness[k], f.shear_stiffness[k],
                                f.fibre[k],           f.outer_yield[k],      f.middle_yield[k]};
  return contact::section_forces(law, jump.in_plane, s.frame_left[k], s.frame_middle[k],
                                 s.frame_right[k]);
}

// Pose of a block in a state.
[[nodiscard]] inline contact::Pose<double> pose_in_space(const State& s, BlockId block) {
  return {{s.ux[block], s.uy[block], s.uz[block]},
          {s.qw[block], {s.qx[block], s.qy[block], s.qz[block]}}};
}
[[nodiscard]] inline SpaceSectionJump section_in_space(const Model& m, const State& s,
                                                       std::size_t k) {
  SpaceSectionJump jump = with_section(
      m.frames, k, [&](BlockId i) { return pose_in_space(s, i); },
      [](const auto& face) { return section_jump_in_space(face.gap()); });
  take_off_set(s, k, jump);
  return jump;
}

}  // namespace wythe::reading
