// Lays a deformable block out in zones and joins zones and nodes.
//
//   n+3  o---o---o---o      a rectangle: a grid of equal quadrilaterals
//        | 3 | 4 | 5 |
//        o---o---o---o      another polygon: ears cut off one by one, the best shaped first, and each
//        | 0 | 1 | 2 |      triangle divided evenly into n^2; edges match because all have n parts
//    n   o---o---o---o
//
// Called by model/plane/solids.cpp for the blocks of a wall, and by the tests.
#pragma once

#include "solids/shape.h"
#include "wythe/parts/model.h"

namespace wythe::solids {

// The part of a grid: its corners in the wall and the number of zones each way.
struct Grid {
  double x0 = 0, y0 = 0, x1 = 0, y1 = 0;  // [m]
  int columns = 1, rows = 1;
};

// Corners of a simple polygon, anticlockwise [m], and into how many parts each edge is cut.
struct Outline {
  std::vector<double> x, y;
  int parts = 1;
};

// A polygon in triangles; three corners each, anticlockwise.
struct Triangles {
  std::vector<double> x, y;  // nodes [m]
  std::vector<std::array<std::int32_t, 3>> corner;
  std::vector<std::int32_t> rim;            // anticlockwise
  double longest = 0, shortest_height = 0;  // over all triangles [m]
};
[[nodiscard]] Triangles triangulate(const Outline& outline);

// Each adds nodes and zones, masses included; returns the body, which is also the last of `solids`.
SolidBody& add_grid(const Grid& grid, ZoneKind kind, const ZoneMaterial& material, Solids& solids);
SolidBody& add_triangles(const Triangles& mesh, const ZoneMaterial& material, Solids& solids);
// Lists which zones and contacts each node takes part in; call after the last change.
void join_nodes(Solids& solids);

}  // namespace wythe::solids
