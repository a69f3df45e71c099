// The law of a strand of fibres bonded to a block (docs/theory/layers.md), for the slip s of a node:
//
//   bond    energy up to the largest slip:  W(s) = G (1 - exp(-B s))^2                                    (22.1)
//           stress at first loading: dW/ds; below the largest slip a straight line to the origin
//   fibres  N = k e, slack in compression; broken beyond their strength
//
// Called by the step (dynamics/passes/layers.h) and by the reader of states (reading/layers.cpp).
#pragma once

#include "core/real.h"

namespace wythe::contact {

// Bond of a node: total energy G [J], rate B [1/m].
struct LayerBond {
  double energy, rate;
};

// (1 - exp(-x)) / x for x >= 0.
WYTHE_INLINE double mean_of_decay(double x) {
  constexpr double kSmall = 1e-3;  // below it the series has 15 digits
  if (x < kSmall) return 1 - x * (0.5 - x * (1.0 / 6.0 - x * (1.0 / 24.0 - x * (1.0 / 120.0))));
  return (1 - exp_of_minus(x)) / x;
}

// Secant stiffness at the largest slip: the slope of the line to the origin [N/m].
WYTHE_INLINE double bond_secant(const LayerBond& bond, double reached) {
  const double x = bond.rate * reached;
  return 2 * bond.energy * bond.rate * bond.rate * exp_of_minus(x) * mean_of_decay(x);
}
// Share of the energy up to the largest slip, including the stored part.
WYTHE_INLINE double bond_spent(const LayerBond& bond, double reached) {
  const double x = bond.rate * reached, force = x * mean_of_decay(x);
  return force * force;
}
// Dissipated energy [J].
WYTHE_INLINE double bond_lost(const LayerBond& bond, double secant, double reached) {
  return bond.energy * bond_spent(bond, reached) - 0.5 * secant * reached * reached;
}

// Force of fibres: tension only, slack in compression.
WYTHE_INLINE double fibres_pull(double stiffness, double stretch) {
  return stretch > 0 ? stiffness * stretch : 0.0;
}
WYTHE_INLINE double fibres_store(double stiffness, double stretch) {
  return stretch > 0 ? 0.5 * stiffness * stretch * stretch : 0.0;
}

}  // namespace wythe::contact
