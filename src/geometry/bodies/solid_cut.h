// Cuts convex solids by planes: the difference of two, and the pieces that remain connected.
//
// Called by slabs.cpp, which cuts pockets into walls.
#pragma once

#include <vector>

#include "geometry/bodies/polyhedron.h"
#include "wythe/parts/body.h"

namespace wythe::geometry {

inline constexpr double kOnPlane = 1e-7;  // a corner within this distance lies on a plane [m]

// The parts below the plane dot(x, normal) = offset and above it. An empty part has no corners.
struct Halves {
  Polyhedron below, above;
};
[[nodiscard]] Halves cut(const Polyhedron& part, Vec3 normal, double offset);

// Convex pieces of `part` outside the convex `without`; `part` itself where the two do not meet. Level planes
// of `without` cut first.
[[nodiscard]] std::vector<Polyhedron> rest_of(const Polyhedron& part, const Polyhedron& without);

// Contact area of two convex solids that do not overlap [m^2].
[[nodiscard]] double shared_area(const Polyhedron& a, const Polyhedron& b);

// Groups of parts connected through shared areas, the largest volume first.
[[nodiscard]] std::vector<std::vector<Polyhedron>> connected(std::vector<Polyhedron> parts);

}  // namespace wythe::geometry
