// Differences and unions of outlines, by Boost.Geometry: the only file that knows it is clip.cpp.
//
// Corners lie on a grid of a nanometre. A corner whose coordinate falls on the grid line of a given
// corner gets that corner's bits, so what touched before touches afterwards.
#pragma once

#include <vector>

#include "geometry/polygon.h"

namespace wythe::geometry {

// What is left of an outline without another, in parts, each anticlockwise from its lowest left corner; `without`
// never lies inside it as a hole.
[[nodiscard]] std::vector<Polygon> difference(const Polygon& outline, const Polygon& without);

// Both together; empty where they do not share a side, or enclose a hole.
[[nodiscard]] Polygon joined_outline(const Polygon& a, const Polygon& b);

}  // namespace wythe::geometry
