// Forces of links in a state.
#include "contact/link.h"
#include "reading/frames.h"
#include "reading/readers.h"
#include "wythe/parts/reading.h"

namespace wythe {

contact::LinkEnd reading::end_in(const State& s, BlockId block, double arm_x, double arm_y) {
  if (block == kGroundBlock) return {0, 0, 0, 0};
  const SinCos<double> half = sin_cos(0.5 * s.theta[block]);
  return contact::link_end(s.ux[block], s.uy[block], half.cos, half.sin, arm_x, arm_y);
}

namespace {

using reading::end_in;

contact::SpaceLinkEnd end_in_space(const State& s, BlockId block, const Vector<double>& arm) {
  if (block == kGroundBlock) return {{0, 0, 0}, {0, 0, 0}};
  return contact::link_end({s.ux[block], s.uy[block], s.uz[block]},
                           {s.qw[block], {s.qx[block], s.qy[block], s.qz[block]}}, arm);
}

}  // namespace

LinkReading reading::link_in_space(const Model& m, const State& s, std::size_t k) {
  const Links& l = m.links;
  const Vector<double> span{l.span_x[k], l.span_y[k], l.span_z[k]};
  const contact::SpaceLinkEnd a =
      end_in_space(s, l.a[k], {l.arm_a_x[k], l.arm_a_y[k], l.arm_a_z[k]});
  const contact::SpaceLinkEnd b =
      end_in_space(s, l.b[k], {l.arm_b_x[k], l.arm_b_y[k], l.arm_b_z[k]});
  const contact::SpaceLinkLine line = contact::link_line(span, l.follows[k] > 0, a, b);
  const contact::LinkForce now =
      m.standing.joins(l.a[k], l.b[k], s.stage)
          ? contact::force_of_link({l.stiffness[k], l.tension[k], l.compression[k]},
                                   line.elongation, s.link_plastic[k], s.link_drawn[k])
          : contact::LinkForce{0, 0};
  const Vec3 c = m.space.centroid[l.b[k]];
  const Vec3 end =
      c + Vec3{l.arm_b_x[k], l.arm_b_y[k], l.arm_b_z[k]} + Vec3{b.moved.x, b.moved.y, b.moved.z};
  const Vector<double> gone = span + (b.moved - a.moved);
  const Vec3 start = l.follows[k] > 0 ? end - Vec3{gone.x, gone.y, gone.z} : end;
  return {l.stiffness[k], now.force, line.elongation, s.link_plastic[k] + now.flow, {start, end}};
}

LinkReading reading::link_in_plane(const Model& m, const State& s, std::size_t k) {
  const Links& l = m.links;
  const contact::LinkEnd a = end_in(s, l.a[k], l.arm_a_x[k], l.arm_a_y[k]);
  const contact::LinkEnd b = end_in(s, l.b[k], l.arm_b_x[k], l.arm_b_y[k]);
  const contact::LinkLine line =
      contact::link_line(l.span_x[k], l.span_y[k], l.follows[k] > 0, a, b);
  const contact::LinkForce now =
      m.standing.joins(l.a[k], l.b[k], s.stage)
          ? contact::force_of_link({l.stiffness[k], l.tension[k], l.compression[k]},
                                   line.elongation, s.link_plastic[k], s.link_drawn[k])
          : contact::LinkForce{0, 0};
  const std::size_t block = l.b[k];
  const Vec3 end{m.centroid_x[block] + l.arm_b_x[k] + b.moved_x,
                 m.centroid_y[block] + l.arm_b_y[k] + b.moved_y, 0};
  Vec3 start = end;
  if (l.a[k] != kGroundBlock && !(l.follows[k] > 0)) {
    const std::size_t other = l.a[k];
    start = {m.centroid_x[other] + l.arm_a_x[k] + a.moved_x,
             m.centroid_y[other] + l.arm_a_y[k] + a.moved_y, 0};
  }
  if (l.follows[k] > 0)
    start = {end.x - l.span_x[k] - (b.moved_x - a.moved_x),
             end.y - l.span_y[k] - (b.moved_y - a.moved_y), 0};
  return {l.stiffness[k], now.force, line.elongation, s.link_plastic[k] + now.flow, {start, end}};
}

std::vector<LinkReading> read_links(const Model& m, const State& s) {
  std::vector<LinkReading> links;
  for (std::size_t k = 0; k < m.links.a.size(); ++k)
    links.push_back(reading::readers_of(m).link(m, s, k));
  return links;
}

}  // namespace wythe
