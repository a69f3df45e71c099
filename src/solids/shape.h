// The stiffness of a quadrilateral zone, made of constant-strain triangles.
//
//   4---3    two pairs of triangles, one for each diagonal, are laid over each other with half the
//   |\ /|    thickness each, so that a zone is as stiff in the mirror as it is:
//   | X |      cst     every triangle has its own strain: locks in bending
//   |/ \|      mixed   all four share the area mean of ex + ey (mixed discretisation)
//   1---2
//
// A triangle is the quadrilateral whose last two corners coincide: one triangle of each pair is left,
// and both kinds are the same.
//
// Marti, Cundall, Mixed discretization procedure for accurate modelling of plastic collapse, Int. J.
// Numer. Anal. Methods Geomech. 6 (1982).
#pragma once

#include <array>

#include "solids/elasticity.h"
#include "wythe/parts/model.h"

namespace wythe::solids {

struct Corners {
  std::array<double, 4> x, y;  // anticlockwise [m]
};

struct ZoneMaterial {
  Elasticity elasticity;
  double thickness = 0, density = 0;
};

// Everything the step needs of such a zone, with its own highest frequency.
[[nodiscard]] ZoneShape make_shape(const Corners& corners, ZoneKind kind,
                                   const ZoneMaterial& material);

}  // namespace wythe::solids
