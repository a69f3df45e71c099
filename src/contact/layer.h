// The law of a strand of fibres that is bonded to a block (docs/theory/layers.md). A node of the strand slips by s:
//
//   bond    energy of all that its slip has done so far:  W(s) = G (1 - exp(-B s))^2                      (22.1)
//           stress on the first way out: dW/ds; back and forth below the largest slip straight to the origin
//   fibres  N = k e, slack where pressed; broken from their strength on
//
// Called by the step (dynamics/passes/layers.h) and by what reads a state (reading/layers.cpp).
#pragma once

#include "core/real.h"

namespace wythe::contact {

// Of a node: energy G of all its bond [J], rate B [1/m].
struct LayerBond {
  double energy, rate;
};

// 1 - exp(-x) over x, for x >= 0.
WYTHE_INLINE double mean_of_decay(double x) {
  constexpr double kSmall = 1e-3;  // below it the series has 15 digits
  if (x < kSmall) return 1 - x * (0.5 - x * (1.0 / 6.0 - x * (1.0 / 24.0 - x * (1.0 / 120.0))));
  return (1 - exp_of_minus(x)) / x;
}

// Force over slip below the largest slip reached: the straight line to the origin [N/m].
WYTHE_INLINE double bond_secant(const LayerBond& bond, double reached) {
  const double x = bond.rate * reached;
  return 2 * bond.energy * bond.rate * bond.rate * exp_of_minus(x) * mean_of_decay(x);
}
// Share of the energy that the largest slip took, what is stored included.
WYTHE_INLINE double bond_spent(const LayerBond& bond, double reached) {
  const double x = bond.rate * reached, force = x * mean_of_decay(x);
  return force * force;
}
// What is lost for good [J].
WYTHE_INLINE double bond_lost(const LayerBond& bond, double secant, double reached) {
  return bond.energy * bond_spent(bond, reached) - 0.5 * secant * reached * reached;
}

// Fibres pull, and hang slack when pressed.
WYTHE_INLINE double fibres_pull(double stiffness, double stretch) {
  return stretch > 0 ? stiffness * stretch : 0.0;
}
WYTHE_INLINE double fibres_store(double stiffness, double stretch) {
  return stretch > 0 ? 0.5 * stiffness * stretch * stretch : 0.0;
}

}  // namespace wythe::contact
