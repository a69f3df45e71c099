// Lays the masonry of a generated wall: every course less openings and lintels.
//
//   course band      |  solid  |##hole##|  solid  |     each solid part is a run of pieces; where a
//                    |---------|--------|---------|     hole takes only part of the height (fit =
//                                                       "cut") the run there is lower
#pragma once

#include <vector>

#include "geometry/assembly.h"
#include "geometry/polygon.h"
#include "geometry/wall/bond.h"

namespace wythe::geometry {

struct Masonry {
  std::vector<Block> blocks;  // course by course, left to right
  int joined_pieces = 0;      // cut pieces too short to stand alone, joined to a neighbour
};

[[nodiscard]] Masonry lay_masonry(const std::vector<Storey>& storeys,
                                  const std::vector<Rect>& holes);

}  // namespace wythe::geometry
