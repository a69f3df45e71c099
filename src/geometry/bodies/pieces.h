// Separates the solids in one list of faces, as a mesh file without names gives them.
//
// Blocks that touch share corners, edges, even whole faces. So the surface of a solid is followed through its
// inside: from a face to the one that encloses the smallest angle with it at their edge.
//
//        |  B  |
//   -----+-----+      at the edge + of a floor and two stones four faces meet; the face of A below continues
//      A       |      with the face of A, not with those of B, which lie at larger angles
#pragma once

#include <cstdint>
#include <vector>

#include "wythe/parts/vector.h"

namespace wythe::geometry {

using FaceList = std::vector<std::vector<std::int32_t>>;

// Merges corners at one place: corners of faces are renamed to the first of them.
void weld_corners(const std::vector<Vec3>& vertex, FaceList& faces);

// Faces of each solid, solids in the order of their first face. Faces are polygons, anticlockwise seen
// from outside, with welded corners; a face without area may belong to any solid along its edges.
[[nodiscard]] std::vector<std::vector<int>> solids_of(const std::vector<Vec3>& vertex,
                                                      const FaceList& faces);

// Largest number of faces at one edge: two for a solid, four or more where solids touch.
[[nodiscard]] std::size_t most_faces_at_an_edge(const FaceList& faces);

}  // namespace wythe::geometry
