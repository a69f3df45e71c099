// Lays the masonry of a generated wall: every course without openings and lintels.
//
//   course band      |  solid  |##hole##|  solid  |     each solid part is a run of pieces; a hole that takes
//                    |---------|--------|---------|     only a part of the height (fit = "cut") leaves
//                                                       a lower run
#pragma once

#include <vector>

#include "geometry/assembly.h"
#include "geometry/polygon.h"
#include "geometry/wall/bond.h"

namespace wythe::geometry {

struct Masonry {
  std::vector<Block> blocks;  // course by course, left to right
  int joined_pieces = 0;      // short cut pieces that were joined to a neighbour
};

[[nodiscard]] Masonry lay_masonry(const std::vector<Storey>& storeys,
                                  const std::vector<Rect>& holes);

}  // namespace wythe::geometry
