// Positions of a face's contact points, and their shares of its area.
//
//   xi in [-1, 1] along the face, weights sum to 1:   integral of f over the face = A sum weight_k f(xi_k)
//
//   corners     the two ends, A/2 each                       as in other block codes
//   trapezoid   n equally spaced points, ends A/2(n-1)       exact where f is linear
//   lobatto     n points, both ends among them               exact up to xi^(2n-3)
//   gauss       n points inside the face                     exact up to xi^(2n-1)
//
// The rotation of a face has f = xi^2 in its stiffness. Corners and trapezoid overestimate it, by 3 with two
// points; lobatto with three or more points and gauss with two or more are exact (docs/theory/kinematics.md).
#pragma once

#include <vector>

#include "wythe/parts/error.h"
#include "wythe/parts/wall_spec.h"

namespace wythe {

struct FaceQuadrature {
  std::vector<double> xi, weight;
};

// Rule and number of points of a file: where it states one of them, the other follows.
struct QuadratureChoice {
  PointRule rule;
  int points;
};
[[nodiscard]] QuadratureChoice quadrature_choice(const SolveSpec& solve);
// Adds faults for numbers of points that the rule does not have.
void check_points(const SolveSpec& solve, FaultList& faults);

// Points and weights of a rule; `points` must have passed check_points(), since it throws nothing.
[[nodiscard]] FaceQuadrature face_points(PointRule rule, int points);

}  // namespace wythe
