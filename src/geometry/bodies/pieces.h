// Solids in one list of faces, as a mesh file without names gives them.
//
// Blocks that touch share corners, edges, even whole faces, so the surface of a solid is followed through its
// inside: from a face to the one that encloses the smallest angle with it at their edge.
//
//        |  B  |
//   -----+-----+      at the edge + of a floor and two stones four faces meet; the face of A below goes on
//      A       |      to the face of A, not to those of B, which lie at larger angles
#pragma once

#include <cstdint>
#include <vector>

#include "wythe/parts/vector.h"

namespace wythe::geometry {

using FaceList = std::vector<std::vector<std::int32_t>>;

// Corners at one place become one: face corners are renamed to the first of them.
void weld_corners(const std::vector<Vec3>& vertex, FaceList& faces);

// Numbers of the faces of each solid, in the order of their first face. Faces are polygons, anticlockwise seen
// from outside, with welded corners; a face without area may go anywhere along its edges.
[[nodiscard]] std::vector<std::vector<int>> solids_of(const std::vector<Vec3>& vertex,
                                                      const FaceList& faces);

// The most faces that meet at one edge: two of a solid, four or more where solids touch.
[[nodiscard]] std::size_t most_faces_at_an_edge(const FaceList& faces);

}  // namespace wythe::geometry
