// Differences and unions of outlines by Boost.Geometry; only clip.cpp includes it.
//
// Corners lie on a grid of one nanometre. A corner whose coordinate falls on the grid line of a given
// corner gets that corner's bits, so that touching outlines still touch afterwards.
#pragma once

#include <vector>

#include "geometry/polygon.h"

namespace wythe::geometry {

// The parts of `outline` outside `without`, each anticlockwise from its lowest left corner; `without` must not lie
// inside as a hole.
[[nodiscard]] std::vector<Polygon> difference(const Polygon& outline, const Polygon& without);

// The union; empty where the two share no side or enclose a hole.
[[nodiscard]] Polygon joined_outline(const Polygon& a, const Polygon& b);

}  // namespace wythe::geometry
