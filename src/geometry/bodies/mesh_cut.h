// A closed surface of triangles, and its division into convex pieces.
//
//   +-------+            an edge is reflex where its faces enclose more than 180 degrees of the solid. A plane
//   |   A  /|            through it, and through as many other corners as possible, cuts the solid in two.
//   |    r--+---+        Corners within kConvexPart of the plane count as on it, so that no slivers arise.
//   |    :   B  |
//   +----+------+        Pieces are cut again until the caller accepts them as convex. Where no such plane leaves
//                        closed sides, as in a letter with a hole, an upright prism is cut by its base.
//
// Called by convex_parts.cpp. Idea of cutting at notches: B. Chazelle, SIAM J. Comput. 13 (1984).
#pragma once

#include <array>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "wythe/parts/body.h"
#include "wythe/parts/vector.h"

namespace wythe::geometry {

struct Mesh {
  std::vector<Vec3> vertex;
  std::vector<std::array<int, 3>> triangle;  // anticlockwise seen from outside
  std::vector<int> source;  // of each triangle: its face of origin; caps get new ones
};

// The triangulation of least area; for a plane polygon, convex or not, it has no overlaps. Corners are given by their
// place in the list. Cost n^3; empty for more than kMostCorners.
inline constexpr std::size_t kMostCorners = 200;
[[nodiscard]] std::vector<std::array<int, 3>> triangles_of(const std::vector<Vec3>& polygon);

[[nodiscard]] double volume_of(const Mesh& mesh);
// Divides a mesh into pieces that share no edge.
[[nodiscard]] std::vector<Mesh> connected_pieces(const Mesh& mesh);
// Finds an edge that passes through a triangle of other corners.
[[nodiscard]] std::optional<std::array<Vec3, 2>> crossing_edge(const Mesh& mesh);
// Divides a mesh into convex pieces, by planes or, for a prism, by its base; returns "" or why it can't.
using IsConvex = std::function<bool(const Mesh&)>;
[[nodiscard]] std::string cut_into_convex(const Mesh& mesh, const IsConvex& is_convex,
                                          std::vector<Mesh>& pieces);

}  // namespace wythe::geometry
