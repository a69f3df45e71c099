// Bond patterns: where the joints of one course stand, before openings are cut.
//
//   running      |--a--:--b--|--a--:--b--|     english, odd course   |-|---|---|---|---|-|
//                |--|--a--:--b--|--a--:--|     flemish               |--a--:--b--|---|--a--:-
//
//   | head joint   : potential crack in the middle of a stretcher   a, b its halves
//
// With split = at_joints the planes stand in line with the head joints above and below: in running bond
// that is the middle; in flemish bond a quarter unit from the ends of a stretcher; in english bond there,
// and in the middle of a header.
//
// Called by courses.cpp; pure arithmetic on the lattice.
#pragma once

#include <vector>

#include "geometry/wall/storeys.h"

namespace wythe::geometry {

// A piece of masonry along its course; pieces of one course are contiguous.
struct Piece {
  double x0 = 0, x1 = 0;  // [m]
  int unit = 0;           // counted from the left end of the course
  char half = ' ';        // 'a', 'b', ..., or ' ' for a whole unit or a closer
};

// The pieces of course `course`, counted from the ground, over the whole wall, left to right.
[[nodiscard]] std::vector<Piece> lay_course(const Storey& storey, int course);

// The pieces within x0..x1. Cut pieces shorter than `shortest` are joined to their neighbour, first
// of the same unit, else the shorter one; `joined` counts them.
[[nodiscard]] std::vector<Piece> cut_pieces(const std::vector<Piece>& course, double x0, double x1,
                                            double shortest, int& joined);

}  // namespace wythe::geometry
