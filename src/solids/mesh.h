// Divides a deformable block into zones and connects zones and nodes.
//
//   n+3  o---o---o---o      a rectangle: a grid of equal quadrilaterals
//        | 3 | 4 | 5 |
//        o---o---o---o      another polygon: ears are cut one by one, the best shaped first, and each
//        | 0 | 1 | 2 |      triangle is divided evenly into n^2; edges match because all have n parts
//    n   o---o---o---o
//
// Called by model/plane/solids.cpp for the blocks of a wall, and by the tests.
#pragma once

#include "solids/shape.h"
#include "wythe/parts/model.h"

namespace wythe::solids {

// A grid: its corners in the wall and the number of zones in each direction.
struct Grid {
  double x0 = 0, y0 = 0, x1 = 0, y1 = 0;  // [m]
  int columns = 1, rows = 1;
};

// Corners of a simple polygon, anticlockwise [m], and the number of parts of each edge.
struct Outline {
  std::vector<double> x, y;
  int parts = 1;
};

// A triangulated polygon; three corners for each triangle, anticlockwise.
struct Triangles {
  std::vector<double> x, y;  // nodes [m]
  std::vector<std::array<std::int32_t, 3>> corner;
  std::vector<std::int32_t> rim;            // nodes of the outline, anticlockwise
  double longest = 0, shortest_height = 0;  // over all triangles [m]
};
[[nodiscard]] Triangles triangulate(const Outline& outline);

// Each of these adds nodes and zones with their masses, and returns the body, the last one of `solids`.
SolidBody& add_grid(const Grid& grid, ZoneKind kind, const ZoneMaterial& material, Solids& solids);
SolidBody& add_triangles(const Triangles& mesh, const ZoneMaterial& material, Solids& solids);
// Lists the zones and contacts of each node; call it after the last change.
void join_nodes(Solids& solids);

}  // namespace wythe::solids
