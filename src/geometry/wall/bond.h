// Bond patterns: the joints of one course before openings are cut.
//
//   running      |--a--:--b--|--a--:--b--|     english, odd course   |-|---|---|---|---|-|
//                |--|--a--:--b--|--a--:--|     flemish               |--a--:--b--|---|--a--:-
//
//   | head joint   : potential crack in the middle of a stretcher   a, b its halves
//
// With split = at_joints the planes align with head joints above and below. In running bond this is the
// middle; in flemish bond it is a quarter unit from the ends of a stretcher; in english bond the same place,
// and in the middle of a header.
//
// Called by courses.cpp; it only computes on the lattice.
#pragma once

#include <vector>

#include "geometry/wall/storeys.h"

namespace wythe::geometry {

// A piece of masonry in its course; the pieces of a course are contiguous.
struct Piece {
  double x0 = 0, x1 = 0;  // [m]
  int unit = 0;           // counted from the left end of the course
  char half = ' ';        // 'a', 'b', ..., or ' ' for a whole unit or a closer
};

// The pieces of course `course`, counted from the ground, over the whole wall from left to right.
[[nodiscard]] std::vector<Piece> lay_course(const Storey& storey, int course);

// The pieces within x0..x1. Cut pieces shorter than `shortest` are joined to a neighbour: one of the
// same unit, else the shorter one. `joined` counts them.
[[nodiscard]] std::vector<Piece> cut_pieces(const std::vector<Piece>& course, double x0, double x1,
                                            double shortest, int& joined);

}  // namespace wythe::geometry
