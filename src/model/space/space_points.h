// Positions of the points on a joint face in space: the rule of a plane face (quadrature.h) in both
// directions of a quadrilateral; on other polygons a fan of triangles.
//
//   quadrilateral   n x n points, weights w_i w_j times the local stretch of its bilinear map
//   other           corners: two thirds of each triangle between centroid and side at the side's ends, the rest
//                   in the middle. Else each triangle by corners 1/20, middles of sides 2/15, centroid 9/20,
//                   exact to third order (Zienkiewicz and Taylor)
#pragma once

#include <span>
#include <vector>

#include "model/quadrature.h"
#include "wythe/parts/vector.h"

namespace wythe {

struct FacePoints {
  std::vector<double> r1, r2;  // from the centre of the area [m]
  std::vector<double> share;   // sums to 1
};

// `corner`: corners of a convex polygon relative to the centre of its area, in order.
[[nodiscard]] FacePoints points_on(std::span<const Vec2> corner, const QuadratureChoice& choice);

}  // namespace wythe
