// Bound on the highest frequency of a compiled wall, from its blocks.
#pragma once

#include "wythe/parts/model.h"

namespace wythe {

// Sets model.omega_max and model.stiffest_block.
//
// With every contact at full stiffness, the elastic energy of the joints is at most
//   sum over pairs (|u_a|^2 + |u_b|^2)_K  +  sum over ground joints 1/2 |u_b|^2_K,
// so omega^2 <= max over blocks of the largest eigenvalue of M^-1 (2 K_pairs + K_ground). This is the
// 3 x 3 stiffness of a block with its neighbours held (a Gershgorin bound by blocks).
void bound_step(Model& model);

}  // namespace wythe
