// The section of a frame between two segments a and b (docs/theory/frames.md): three elastic-plastic fibres, equal in
// tension and compression, and a shear spring.
//
//        a  |  b           n  along the member in the mean rotation of both segments, t on its left
//    =======|=======       e, s  displacement of b's point from a's along n and t;  r  rotation of b against a
//           | - o +d       elongation of a fibre:  e - d r (left, at +d),  e (middle),  e + d r (right, at -d)
//           |   o 0
//           | - o -d       N tension +, M tension on the right
//
// Called by the step (dynamics/passes/frames.h) and by the reader of states (reading/frames.cpp).
#pragma once

#include "contact/link.h"

namespace wythe::contact {

struct Fibre {
  double force, flow;  // [N], growth of the plastic elongation [m]
};
WYTHE_INLINE Fibre fibre_force(double stiffness, double yield, double elongation, double plastic) {
  const double trial = stiffness * (elongation - plastic);
  if (trial > yield) return {yield, (trial - yield) / stiffness};
  if (trial < -yield) return {-yield, (trial + yield) / stiffness};
  return {trial, 0};
}

struct SectionLaw {
  double outer, middle, shear;       // [N/m]
  double fibre;                      // d [m]
  double outer_yield, middle_yield;  // [N]
};
// Relative position of b against a.
struct SectionJump {
  double along, across, turn;  // e, s [m], r [rad]
  double axis_x, axis_y;       // n in the current state
  double gap_x, gap_y;         // from a's point to b's, initially zero [m]
};
// `rest`: offset of b's point from a's at the start, where blocks start away from their outlines (gaps to the masonry);
// half rotations of both as cosine and sine.
WYTHE_INLINE SectionJump section_jump(double axis_x, double axis_y, double rest_x, double rest_y,
                                      const LinkEnd& a, const LinkEnd& b, double turn_a,
                                      double turn_b, double cos_a, double sin_a, double cos_b,
                                      double sin_b) {
  const double c = cos_a * cos_b - sin_a * sin_b, s = sin_a * cos_b + cos_a * sin_b;
  const double x = c * axis_x - s * axis_y, y = s * axis_x + c * axis_y;
  const double gx = b.moved_x - a.moved_x - rest_x, gy = b.moved_y - a.moved_y - rest_y;
  return {gx * x + gy * y, gy * x - gx * y, turn_b - turn_a, x, y, gx, gy};
}

struct SectionForces {
  double normal, shear, moment;  // N, V along t, M
  Fibre left, middle, right;
};
WYTHE_INLINE SectionForces section_forces(const SectionLaw& law, const SectionJump& jump,
                                          double left, double middle, double right) {
  const double bent = law.fibre * jump.turn;
  const Fibre l = fibre_force(law.outer, law.outer_yield, jump.along - bent, left);
  const Fibre m = fibre_force(law.middle, law.middle_yield, jump.along, middle);
  const Fibre r = fibre_force(law.outer, law.outer_yield, jump.along + bent, right);
  return {l.force + m.force + r.force,
          law.shear * jump.across,
          law.fibre * (r.force - l.force),
          l,
          m,
          r};
}

}  // namespace wythe::contact
