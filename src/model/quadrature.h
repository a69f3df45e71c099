// Where the contact points of a face stand, and what share of its area each takes.
//
//   xi in [-1, 1] along the face, weights sum to 1:   integral of f over the face = A sum weight_k f(xi_k)
//
//   corners     the two ends, A/2 each                       the setting of block codes
//   trapezoid   n points at equal distances, ends A/2(n-1)   exact where f is straight
//   lobatto     n points, both ends among them               exact up to xi^(2n-3)
//   gauss       n points inside the face                     exact up to xi^(2n-1)
//
// A face that turns has f = xi^2 in its stiffness: corners and trapezoid get it too large, by 3 with two
// points; lobatto from three and gauss from two points on get it right (docs/theory/kinematics.md).
#pragma once

#include <vector>

#include "wythe/parts/error.h"
#include "wythe/parts/wall_spec.h"

namespace wythe {

struct FaceQuadrature {
  std::vector<double> xi, weight;
};

// The rule and number a file means: where it states one of the two, the other follows.
struct QuadratureChoice {
  PointRule rule;
  int points;
};
[[nodiscard]] QuadratureChoice quadrature_choice(const SolveSpec& solve);
// Numbers that the rule does not have, as faults.
void check_points(const SolveSpec& solve, FaultList& faults);

// Throws nothing: `points` must have passed check_points().
[[nodiscard]] FaceQuadrature face_points(PointRule rule, int points);

}  // namespace wythe
