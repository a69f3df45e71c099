// The sections of frames in one wall (contact/section.h, docs/theory/frames.md). A wall has few of them, so
// they are taken one by one before the joints, as links are. Their forces lie in rows behind those of links.
#pragma once

#include "contact/section.h"
#include "dynamics/passes/links.h"

namespace wythe::dynamics {

// Adds the forces of all sections in the present pose; returns the energy that yielding dissipated [J].
WYTHE_INLINE double add_frame_forces(const WallView& wall) {
  double yielded = 0;
  for (int k = 0; k < wall.frames; ++k) {
    const auto of = [&](FrameRowName row) { return wall.frame(k, row); };
    const std::int32_t i = wall.t.frame_a[k], j = wall.t.frame_b[k];
    if (j == wall.t.n_block) continue;  // not put up yet: no force
    const contact::LinkEnd a = end_of(wall, i, of(kFrameArmAX), of(kFrameArmAY));
    const contact::LinkEnd b = end_of(wall, j, of(kFrameArmBX), of(kFrameArmBY));
    const auto pose = [&](std::int32_t block, int c) {
      return wall.column_of(wall.t.pose, block, c);
    };
    contact::SectionJump jump =
        contact::section_jump(of(kFrameAxisX), of(kFrameAxisY), of(kFrameRestX), of(kFrameRestY), a,
                              b, wall.block(i, kTheta), wall.block(j, kTheta), pose(i, 2),
                              pose(i, 3), pose(j, 2), pose(j, 3));
    jump.along -= of(kFrameAlong);
    jump.across -= of(kFrameAcross);
    jump.turn -= of(kFrameTurn);
    const contact::SectionForces forces =
        contact::section_forces({of(kFrameOuter), of(kFrameMiddle), of(kFrameShear),
                                 of(kFrameFibre), of(kFrameOuterYield), of(kFrameMiddleYield)},
                                jump, of(kFrameLeftSet), of(kFrameMiddleSet), of(kFrameRightSet));
    yielded += forces.left.force * forces.left.flow + forces.middle.force * forces.middle.flow +
               forces.right.force * forces.right.flow;
    wall.frame(k, kFrameLeftSet) = of(kFrameLeftSet) + forces.left.flow;
    wall.frame(k, kFrameMiddleSet) = of(kFrameMiddleSet) + forces.middle.flow;
    wall.frame(k, kFrameRightSet) = of(kFrameRightSet) + forces.right.flow;
    const double fx = forces.normal * jump.axis_x - forces.shear * jump.axis_y;
    const double fy = forces.normal * jump.axis_y + forces.shear * jump.axis_x;
    // the shear force acts half way between both points (20.5)
    const double across = 0.5 * (jump.gap_x * fy - jump.gap_y * fx);
    const std::ptrdiff_t row = wall.joints + wall.linked + k;
    wall.column_of(wall.t.force, row, 0) = fx;
    wall.column_of(wall.t.force, row, 1) = fy;
    wall.column_of(wall.t.force, row, 2) = a.arm_x * fy - a.arm_y * fx + across + forces.moment;
    wall.column_of(wall.t.force, row, 3) = b.arm_y * fx - b.arm_x * fy + across - forces.moment;
  }
  return yielded;
}

}  // namespace wythe::dynamics
