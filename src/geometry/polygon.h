// Plane polygons: moments, bounds, simplicity, overlap.
//
// Called by the builders (blocks files) and by checks.cpp; reads outlines, writes nothing else.
// Reference: J. O'Rourke, Computational Geometry in C, ch. 1 (ear clipping) and 7 (clipping).
#pragma once

#include <vector>

#include "geometry/assembly.h"

namespace wythe::geometry {

using Polygon = std::vector<Vec2>;

struct Rect {
  double x0 = 0, y0 = 0, x1 = 0, y1 = 0;
};

[[nodiscard]] Polygon outline_of(const Rect& rect);  // anticlockwise from the lower left corner
[[nodiscard]] Rect bounds(const Polygon& outline);
[[nodiscard]] Rect join(const Rect& a, const Rect& b);
// True when the insides of the two rectangles meet by more than `margin` both ways.
[[nodiscard]] bool overlaps(const Rect& a, const Rect& b, double margin);

// True when no two edges cross or touch except neighbours at their common corner.
[[nodiscard]] bool is_simple(const Polygon& outline);
// True for a four-cornered outline whose edges all follow the axes within `tolerance`.
[[nodiscard]] bool is_upright_rectangle(const Polygon& outline, double tolerance);
// Common area of two simple anticlockwise polygons, convex or not [m^2].
[[nodiscard]] double overlap_area(const Polygon& a, const Polygon& b);

// The part of a simple outline inside a convex anticlockwise one; empty where they do not meet. Edges
// may run back over each other where the outline is not convex: its moments are right.
[[nodiscard]] Polygon part_inside(const Polygon& outline, const Polygon& convex);

// Convex polygons that make up a simple anticlockwise outline, itself where it is convex. Corners on a
// straight line are left out.
[[nodiscard]] std::vector<Polygon> convex_parts(const Polygon& outline);
// A convex polygon whose corners are cut off by `bevel` along both edges, by less where an edge is short.
[[nodiscard]] Polygon bevelled(const Polygon& convex, double bevel);

}  // namespace wythe::geometry
