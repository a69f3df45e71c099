// Plane polygons: moments, bounds, simplicity, overlap.
//
// Called by builders (blocks files) and checks.cpp.
// Reference: J. O'Rourke, Computational Geometry in C, ch. 1 (ear clipping) and 7 (clipping).
#pragma once

#include <vector>

#include "geometry/assembly.h"

namespace wythe::geometry {

using Polygon = std::vector<Vec2>;

struct Rect {
  double x0 = 0, y0 = 0, x1 = 0, y1 = 0;
};

[[nodiscard]] Polygon polygon_of(const std::vector<Vec3>& corners);  // their x and y
[[nodiscard]] Polygon outline_of(const Rect& rect);  // anticlockwise from the lower left corner
[[nodiscard]] Rect bounds(const Polygon& outline);
[[nodiscard]] Rect join(const Rect& a, const Rect& b);
// Whether the interiors of two rectangles overlap by more than `margin` in both directions.
[[nodiscard]] bool overlaps(const Rect& a, const Rect& b, double margin);

// Whether no two edges cross or touch, except neighbours at their common corner.
[[nodiscard]] bool is_simple(const Polygon& outline);
// Whether the outline has four corners and edges along the axes within `tolerance`.
[[nodiscard]] bool is_upright_rectangle(const Polygon& outline, double tolerance);
// Common area of two simple anticlockwise polygons, convex or not [m^2].
[[nodiscard]] double overlap_area(const Polygon& a, const Polygon& b);

// The part of a simple outline inside a convex anticlockwise one; empty where they do not meet. For an outline that is
// not convex, edges may overlap, but moments stay exact.
[[nodiscard]] Polygon part_inside(const Polygon& outline, const Polygon& convex);

// Convex polygons that compose a simple anticlockwise outline; the outline itself where it is convex. Corners on a
// straight line are removed.
[[nodiscard]] std::vector<Polygon> convex_parts(const Polygon& outline);
// A convex polygon with each corner cut by `bevel` along both edges, by less at short edges.
[[nodiscard]] Polygon bevelled(const Polygon& convex, double bevel);

}  // namespace wythe::geometry
