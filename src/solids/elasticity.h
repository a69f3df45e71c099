// Linear elasticity of a deformable block in its plane, from the moduli of its material.
//
//   isotropic     E and nu = E/2G - 1 (or poisson_ratio)
//   orthotropic   E along the grain, E across it (and out of the plane), G, nu from along to across
//
// Plane stress: a lintel with free faces on both sides of the wall. Plane strain: a long body.
#pragma once

#include <array>
#include <vector>

#include "wythe/parts/contact_law.h"
#include "wythe/parts/wall_spec.h"

namespace wythe::solids {

using Elasticity = std::array<std::array<double, 3>, 3>;  // stresses x, y, xy per strain [Pa]

// Faults of the moduli, each with its numbers; the functions below require moduli without faults.
[[nodiscard]] std::vector<MaterialFault> check_elasticity(const JointMaterial& body);
[[nodiscard]] double poisson_ratio_of(const JointMaterial& body);
[[nodiscard]] Elasticity elasticity_of(const JointMaterial& body, Plane plane);

}  // namespace wythe::solids
