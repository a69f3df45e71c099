// Convex polygons in one plane: their common part, what one leaves of the other, and their union.
//
// Called by joint_faces.cpp, in the axes of the mean plane (PlaneAxes); polygons run anticlockwise.
#pragma once

#include <optional>
#include <vector>

#include "wythe/parts/vector.h"

namespace wythe::geometry {

// Right-handed axes of a plane: u x v = normal. They follow the wall's axes where the normal does.
struct PlaneAxes {
  Vec3 origin, u, v, normal;
  [[nodiscard]] Vec2 flat(Vec3 p) const { return {dot(p - origin, u), dot(p - origin, v)}; }
  [[nodiscard]] Vec3 raised(Vec2 p, double height = 0) const {
    return origin + p.x * u + p.y * v + height * normal;
  }
};
[[nodiscard]] PlaneAxes axes_of(Vec3 origin, Vec3 normal);

using Convex = std::vector<Vec2>;

[[nodiscard]] double area_of(const Convex& polygon);
// Area over half the perimeter: the width of a long strip.
[[nodiscard]] double breadth_of(const Convex& polygon);
[[nodiscard]] Vec2 centroid_of(const Convex& polygon);
[[nodiscard]] bool is_convex(const Convex& polygon, double tolerance);

// Clips `polygon` by each edge of `by` (Sutherland and Hodgman). Corners nearer to each other than
// `tolerance`, and those on the line of their neighbours, are removed; empty where nothing remains.
[[nodiscard]] Convex common_part(const Convex& polygon, const Convex& by, double tolerance);
// The part of `polygon` outside `without`, in convex pieces.
[[nodiscard]] std::vector<Convex> rest_of(const Convex& polygon, const Convex& without,
                                          double tolerance);
// The union as one convex polygon, where both share a whole edge and the union is convex.
[[nodiscard]] std::optional<Convex> united(const Convex& a, const Convex& b, double tolerance);
[[nodiscard]] Convex without_idle_corners(const Convex& polygon, double tolerance);

}  // namespace wythe::geometry
