// The sections of frames in one wall in space (reading/space_frames.h).
// A wall has few of them, so they are taken one by one, as links are.
#pragma once

#include "dynamics/space/wall.h"
#include "reading/space_frames.h"

namespace wythe::dynamics::space {

// Adds the forces of all sections in the present pose; returns the energy that yielding dissipated [J].
inline double add_frame_forces(const WallView& w, const Model& m, State& s) {
  const Frames& f = m.frames;
  double yielded = 0;
  const auto pose_of = [&](BlockId i) { return contact::Pose<double>{w.shift(i), w.turn(i)}; };
  for (std::size_t k = 0; k < f.a.size(); ++k) {
    if (!m.standing.joins(f.a[k], f.b[k], s.stage)) continue;  // not put up yet
    const contact::BlockLoads<double> loads =
        reading::with_section(f, k, pose_of, [&](const auto& face) {
          reading::SpaceSectionJump jump = reading::section_jump_in_space(face.gap());
          reading::take_off_set(s, k, jump);
          const contact::SectionForces forces = reading::section_forces_in_space(f, s, k, jump);
          yielded += forces.left.force * forces.left.flow +
                     forces.middle.force * forces.middle.flow +
                     forces.right.force * forces.right.flow;
          s.frame_left[k] += forces.left.flow;
          s.frame_middle[k] += forces.middle.flow;
          s.frame_right[k] += forces.right.flow;
          const double torque = f.twist_stiffness[k] * jump.twist;
          return face.loads({{forces.shear, f.aside_stiffness[k] * jump.aside, forces.normal},
                             {0, 0.5 * torque, -forces.moment},
                             {-0.5 * torque, 0, f.lean_stiffness[k] * jump.lean}});
        });
    const std::ptrdiff_t row = w.layout->first_frame + static_cast<std::ptrdiff_t>(k);
    w.store_vector(loads.f, w.t.force, row);
    w.store_vector(loads.on_a, w.t.moment_a, row);
    w.store_vector(loads.on_b, w.t.moment_b, row);
  }
  return yielded;
}

}  // namespace wythe::dynamics::space
