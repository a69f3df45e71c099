// A zone in space: a hexahedron of eight nodes that does not lock (docs/theory/zones.md, "Zones in space").
//
//        7---6        trilinear displacements and three internal bending modes: 1 - x^2, 1 - y^2, 1 - z^2 of
//       /|  /|        the natural coordinates (Wilson 1973). They use the Jacobian of the middle, so that constant
//      4---5 |        strains are exact for any shape (Taylor, Beresford, Wilson 1976). They are eliminated
//      | 3-|-2        once: the zone is elastic, so its stiffness is a constant 24 x 24 matrix
//      |/  |/
//      0---1
//
// The zone rotates with its mean deformation gradient F = R U; its force is the exact gradient of its energy:
//   y = R'(x - mean x),  d = y - X,  E = 1/2 d' K d
//   f_i = -R ((K d)_i - mu x g_i),   (tr U - U) mu = m = sum y_i x (K d)_i
// so that the eight forces have neither sum nor moment in any state.
#pragma once

#include <array>

#include "core/rotation.h"
#include "wythe/parts/contact_law.h"
#include "wythe/parts/hexahedron_shape.h"
#include "wythe/parts/vector.h"

namespace wythe::solids {

using HexahedronCorners = std::array<Vec3, 8>;  // [m], in the order of HexahedronShape
// Stresses x, y, z, xy, yz, zx per strain (engineering shear strains) [Pa].
using Elasticity6 = std::array<std::array<double, 6>, 6>;

// Elasticity of a material with its grain along the unit vector `grain`; an isotropic one has no grain. Across the grain all
// directions are equal: E2, nu of all pairs, G23 = E2/2(1 + nu).
[[nodiscard]] Elasticity6 elasticity_in_space(const JointMaterial& body, Vec3 grain);

// Smallest Jacobian of the corners over the mean one: 1 for a box, 0 or negative where the map folds.
[[nodiscard]] double least_jacobian(const HexahedronCorners& corners);
[[nodiscard]] HexahedronShape make_hexahedron(const HexahedronCorners& corners,
                                              const Elasticity6& elasticity, double density);

using HexahedronVectors = std::array<Vector<double>, 8>;

// The rotating frame of a zone and the displacements in it.
struct HexahedronMotion {
  double turn[3][3];     // R
  double stretch[3][3];  // U
  HexahedronVectors d;
};
[[nodiscard]] HexahedronMotion hexahedron_motion(const HexahedronShape& shape,
                                                 const HexahedronVectors& u);
// Forces of the zone on its corners in the axes of the wall [N]; u: displacements [m].
[[nodiscard]] HexahedronVectors hexahedron_force(const HexahedronShape& shape,
                                                 const HexahedronVectors& u);
// Strain energy [J].
[[nodiscard]] double hexahedron_energy(const HexahedronShape& shape, const HexahedronVectors& u);
// Mean stresses x, y, z, xy, yz, zx in the axes of the wall [Pa].
[[nodiscard]] std::array<double, 6> hexahedron_stress(const HexahedronShape& shape,
                                                      const HexahedronVectors& u);
// The three principal stresses, in falling order [Pa].
[[nodiscard]] std::array<double, 3> principal_of(const std::array<double, 6>& stress);

}  // namespace wythe::solids
