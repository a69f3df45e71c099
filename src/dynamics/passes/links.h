// The links of one wall: ties, springs and diaphragms (contact/link.h, docs/theory/links.md).
// A wall has few of them, so they are taken one by one before the joints. Their forces lie in
// rows behind those of the joints, where the pass over blocks gathers both (tables.h).
#pragma once

#include <utility>
#include <vector>

#include "contact/link.h"
#include "dynamics/passes/wall.h"

namespace wythe::dynamics {

// Energy that links dissipated and energy that prestressed them in a step [J].
struct LinkWork {
  double dissipated = 0, tensioned = 0;
};

// Law and place of all links, without jacks; in space their third components follow.
template <class View>
void load_links(const View& wall, const Links& links) {
  const std::pair<LinkRowName, const std::vector<double>*> rows[] = {
      {kLinkStiffness, &links.stiffness},
      {kLinkTension, &links.tension},
      {kLinkCompression, &links.compression},
      {kLinkPrestress, &links.prestress},
      {kLinkArmAX, &links.arm_a_x},
      {kLinkArmAY, &links.arm_a_y},
      {kLinkArmBX, &links.arm_b_x},
      {kLinkArmBY, &links.arm_b_y},
      {kLinkSpanX, &links.span_x},
      {kLinkSpanY, &links.span_y},
      {kLinkFollows, &links.follows}};
  for (int k = 0; k < links.n; ++k) {
    for (const auto& [row, of] : rows) wall.link(k, row) = (*of)[k];
    wall.link(k, kLinkJack) = 0;
  }
}

WYTHE_INLINE contact::LinkEnd end_of(const WallView& wall, std::int32_t block, double arm_x,
                                     double arm_y) {
  return contact::link_end(wall.ux(block), wall.uy(block), wall.column_of(wall.t.pose, block, 2),
                           wall.column_of(wall.t.pose, block, 3), arm_x, arm_y);
}

// Updates link k, which is longer by `elongation` than at rest, keeps what stays of it, adds its works and returns its force.
template <class View>
WYTHE_INLINE double update_link(const View& wall, int k, double elongation, double set,
                                double jacked, LinkWork& work) {
  const auto of = [&](LinkRowName row) { return wall.link(k, row); };
  const double before = of(kLinkForce);
  double drawn = of(kLinkDrawn);
  if (of(kLinkPrestress) != 0) drawn = set * of(kLinkPrestress) / of(kLinkStiffness);
  if (jacked >= 0 && of(kLinkJack) > 0)
    drawn = of(kLinkPlastic) - elongation - jacked * of(kLinkJack) / of(kLinkStiffness);
  const contact::LinkForce after =
      contact::force_of_link({of(kLinkStiffness), of(kLinkTension), of(kLinkCompression)},
                             elongation, of(kLinkPlastic), drawn);
  const double mean = 0.5 * (before + after.force);
  work.dissipated += mean * after.flow;
  work.tensioned += mean * (drawn - of(kLinkDrawn));
  wall.link(k, kLinkForce) = after.force;
  wall.link(k, kLinkPlastic) = of(kLinkPlastic) + after.flow;
  wall.link(k, kLinkDrawn) = drawn;
  return after.force;
}

// Adds the forces of all links in the present pose. `set`: the present share of their
// prestress. `jacked`: the share of the jacks' force, below 0 where no jack works. A jack keeps
// its force over any distance, because it draws its link to the length that gives this force.
WYTHE_INLINE LinkWork add_link_forces(const WallView& wall, double set, double jacked) {
  LinkWork work;
  for (int k = 0; k < wall.links; ++k) {
    const auto of = [&](LinkRowName row) { return wall.link(k, row); };
    if (wall.t.link_b[k] == wall.t.n_block) continue;  // not put up yet: no force
    const contact::LinkEnd a = end_of(wall, wall.t.link_a[k], of(kLinkArmAX), of(kLinkArmAY));
    const contact::LinkEnd b = end_of(wall, wall.t.link_b[k], of(kLinkArmBX), of(kLinkArmBY));
    const contact::LinkLine line =
        contact::link_line(of(kLinkSpanX), of(kLinkSpanY), of(kLinkFollows) > 0, a, b);
    const double force = update_link(wall, k, line.elongation, set, jacked, work);
    const double fx = force * line.axis_x, fy = force * line.axis_y;
    const std::ptrdiff_t row = wall.joints + k;
    wall.column_of(wall.t.force, row, 0) = fx;
    wall.column_of(wall.t.force, row, 1) = fy;
    wall.column_of(wall.t.force, row, 2) = a.arm_x * fy - a.arm_y * fx;
    wall.column_of(wall.t.force, row, 3) = b.arm_y * fx - b.arm_x * fy;
  }
  return work;
}

}  // namespace wythe::dynamics
