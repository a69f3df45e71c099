// The stiffness of a quadrilateral zone, composed of constant-strain triangles.
//
//   4---3    two pairs of triangles, one for each diagonal, are superposed with half the
//   |\ /|    thickness each, so that a zone and its mirror image are equally stiff:
//   | X |      cst     each triangle has its own strain: locks in bending
//   |/ \|      mixed   all four share the area mean of ex + ey (mixed discretisation)
//   1---2
//
// A triangle is a quadrilateral whose last two corners coincide: one triangle of each pair remains,
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

// All data of such a zone that the step needs, with its highest frequency.
[[nodiscard]] ZoneShape make_shape(const Corners& corners, ZoneKind kind,
                                   const ZoneMaterial& material);

}  // namespace wythe::solids
