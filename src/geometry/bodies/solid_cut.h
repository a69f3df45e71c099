// Convex solids cut by planes: what one leaves of another, and which pieces still hang together.
//
// Called by slabs.cpp, which cuts pockets into walls.
#pragma once

#include <array>
#include <vector>

#include "geometry/bodies/polyhedron.h"
#include "wythe/parts/body.h"

namespace wythe::geometry {

inline constexpr double kOnPlane = 1e-7;  // a corner this near to a plane lies on it [m]

// Below the plane dot(x, normal) = offset, and above it. A side of which nothing is left has no corners.
struct Halves {
  Polyhedron below, above;
};
[[nodiscard]] Halves cut(const Polyhedron& part, Vec3 normal, double offset);

// Convex pieces of `part` outside of `without`, also convex; `part` itself where the two do not meet. Level planes
// of `without` cut first.
[[nodiscard]] std::vector<Polyhedron> rest_of(const Polyhedron& part, const Polyhedron& without);

// Area that two convex solids which do not overlap share [m^2].
[[nodiscard]] double shared_area(const Polyhedron& a, const Polyhedron& b);

// Parts by what hangs together through shared areas, the largest volume first.
[[nodiscard]] std::vector<std::vector<Polyhedron>> connected(std::vector<Polyhedron> parts);

}  // namespace wythe::geometry
