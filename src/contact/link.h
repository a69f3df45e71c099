// The law of a link: a tie, spring or diaphragm, a bar between two points a and b (docs/theory/links.md).
//
//       a o------------------o b      its length is L0 + e        N > 0: tension
//            axis from a to b
//
//   N = k (e - e_p + d)     d: elongation imposed by prestress or a jack, or -e at installation; N is
//                           limited in tension and compression. Beyond a limit e_p grows. A limit of 0
//                           has no plastic flow: the link hangs slack, or has a gap, and carries force
//                           again from the same length
//
// Called by the step (dynamics/passes/links.h) and by the reader of states (reading/links.cpp).
#pragma once

#include "core/real.h"
#include "core/rotation.h"

namespace wythe::contact {

// An end: its arm from the centroid, rotated with the block, and its displacement [m].
struct LinkEnd {
  double arm_x, arm_y, moved_x, moved_y;
};
// `c`, `s`: cosine and sine of half the block's rotation.
WYTHE_INLINE LinkEnd link_end(double ux, double uy, double c, double s, double arm_x,
                              double arm_y) {
  const double drop = -2 * s * s, sine = 2 * s * c;
  const double turned_x = drop * arm_x - sine * arm_y, turned_y = sine * arm_x + drop * arm_y;
  return {arm_x + turned_x, arm_y + turned_y, ux + turned_x, uy + turned_y};
}

struct LinkLine {
  double elongation, axis_x, axis_y;
};
// `span`: from a to b at the start; for a link of constant direction a unit vector.
WYTHE_INLINE LinkLine link_line(double span_x, double span_y, bool follows, const LinkEnd& a,
                                const LinkEnd& b) {
  const double dx = b.moved_x - a.moved_x, dy = b.moved_y - a.moved_y;
  const double along = span_x * dx + span_y * dy;
  if (!follows) return {along, span_x, span_y};
  const double x = span_x + dx, y = span_y + dy;
  const double start = square_root(span_x * span_x + span_y * span_y);
  const double now = square_root(x * x + y * y);
  return {(2 * along + dx * dx + dy * dy) / (start + now), x / now, y / now};
}

// The end of a link in space.
struct SpaceLinkEnd {
  Vector<double> arm, moved;
};
WYTHE_INLINE SpaceLinkEnd link_end(const Vector<double>& u, const Quaternion<double>& q,
                                   const Vector<double>& arm) {
  const Vector<double> swung = swing(q, arm);
  return {arm + swung, u + swung};
}
struct SpaceLinkLine {
  double elongation;
  Vector<double> axis;
};
WYTHE_INLINE SpaceLinkLine link_line(const Vector<double>& span, bool follows,
                                     const SpaceLinkEnd& a, const SpaceLinkEnd& b) {
  const Vector<double> d = b.moved - a.moved;
  const double along = dot(span, d);
  if (!follows) return {along, span};
  const Vector<double> line = span + d;
  const double start = square_root(dot(span, span)), now = square_root(dot(line, line));
  return {(2 * along + dot(d, d)) / (start + now), (1 / now) * line};
}

struct LinkLimits {
  double stiffness, tension, compression;  // [N/m], [N]
};
struct LinkForce {
  double force, flow;  // [N], growth of e_p [m]
};
WYTHE_INLINE LinkForce force_of_link(const LinkLimits& limits, double elongation, double plastic,
                                     double drawn) {
  const double trial = limits.stiffness * (elongation - plastic + drawn);
  if (trial > limits.tension)
    return {limits.tension, limits.tension > 0 ? (trial - limits.tension) / limits.stiffness : 0.0};
  if (trial < -limits.compression)
    return {-limits.compression,
            limits.compression > 0 ? (trial + limits.compression) / limits.stiffness : 0.0};
  return {trial, 0};
}

}  // namespace wythe::contact
