// The layers of one wall: strands of fibres on a chain of nodes that slip on the blocks (contact/layer.h,
// docs/theory/layers.md). They are taken before the joints, as links are. Where a strand crosses a joint,
// its force goes into a row behind those of frames. Within a block it moves only nodes.
//
// Nodes have no mass. Each step moves every node by half of the distance that would balance it if the others stood
// still (22.7). The energy of this is the exact difference of stored energies, and goes into the ledger as damping.
#pragma once

#include "contact/layer.h"
#include "dynamics/passes/links.h"

namespace wythe::dynamics {

struct LayerWork {
  double fracture = 0,
         damping = 0;  // dissipated by bond and fibres, and by the nodes' motion to balance [J]
};

// Stretches all fibres in the present pose, sets their forces where they cross joints, and finds what breaks.
WYTHE_INLINE void stretch_layers(const WallView& wall, LayerWork& work) {
  for (int k = 0; k < wall.layers; ++k) {
    const auto of = [&](LayerRowName row) { return wall.layer(k, row); };
    const double stiffness = of(kLayerStiffness);
    double stretch = 0;
    if (stiffness > 0) {
      stretch = wall.layer(k + 1, kLayerSlip) - of(kLayerSlip);
      const std::int32_t crossing = wall.t.layer_crossing[k];
      contact::LinkEnd a{}, b{};
      contact::LinkLine line{};
      if (crossing >= 0) {
        a = end_of(wall, wall.t.layer_a[k], of(kLayerArmAX), of(kLayerArmAY));
        b = end_of(wall, wall.t.layer_b[k], of(kLayerArmBX), of(kLayerArmBY));
        line = contact::link_line(of(kLayerSpanX), of(kLayerSpanY), true, a, b);
        stretch += line.elongation;
      }
      if (of(kLayerBroken) > 0) {
        stretch = 0;
      } else if (contact::fibres_pull(stiffness, stretch) > of(kLayerStrength)) {
        work.fracture += contact::fibres_store(stiffness, stretch);
        wall.layer(k, kLayerBroken) = 1;
        stretch = 0;
      }
      if (crossing >= 0) {
        const double force = contact::fibres_pull(stiffness, stretch);
        const double fx = force * line.axis_x, fy = force * line.axis_y;
        const std::ptrdiff_t row = wall.first_crossing + crossing;
        wall.column_of(wall.t.force, row, 0) = fx;
        wall.column_of(wall.t.force, row, 1) = fy;
        wall.column_of(wall.t.force, row, 2) = a.arm_x * fy - a.arm_y * fx;
        wall.column_of(wall.t.force, row, 3) = b.arm_y * fx - b.arm_x * fy;
      }
    }
    wall.layer(k, kLayerStretch) = stretch;
  }
}

// Moves every node towards its balance.
WYTHE_INLINE void slip_layers(const WallView& wall, LayerWork& work) {
  double behind = 0, stored = 0, lost = 0;
  for (int k = 0; k < wall.layers; ++k) {
    const auto of = [&](LayerRowName row) { return wall.layer(k, row); };
    const double ahead = contact::fibres_pull(of(kLayerStiffness), of(kLayerStretch));
    const double slip = of(kLayerSlip), secant = of(kLayerSecant);
    const double shift = (ahead - behind - secant * slip) * of(kLayerFlex), now = slip + shift;
    behind = ahead;
    wall.layer(k, kLayerSlip) = now;
    wall.layer(k, kLayerShift) = shift;
    double hold = secant;
    if (magnitude(now) > of(kLayerReached)) {
      const contact::LayerBond bond{of(kLayerEnergy), of(kLayerRate)};
      hold = contact::bond_secant(bond, magnitude(now));
      lost += contact::bond_lost(bond, hold, magnitude(now)) -
              contact::bond_lost(bond, secant, of(kLayerReached));
      wall.layer(k, kLayerReached) = magnitude(now);
      wall.layer(k, kLayerSecant) = hold;
    }
    stored += 0.5 * hold * now * now - 0.5 * secant * slip * slip;
  }
  for (int k = 0; k < wall.layers; ++k) {
    const auto of = [&](LayerRowName row) { return wall.layer(k, row); };
    if (!(of(kLayerStiffness) > 0) || of(kLayerBroken) > 0) continue;
    const double was = of(kLayerStretch),
                 now = was + (wall.layer(k + 1, kLayerShift) - of(kLayerShift));
    stored += contact::fibres_store(of(kLayerStiffness), now) -
              contact::fibres_store(of(kLayerStiffness), was);
  }
  work.fracture += lost;
  work.damping -= stored + lost;
}

WYTHE_INLINE LayerWork add_layer_forces(const WallView& wall) {
  LayerWork work;
  stretch_layers(wall, work);
  slip_layers(wall, work);
  return work;
}

}  // namespace wythe::dynamics
