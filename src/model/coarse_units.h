// What a wall is worth whose units are drawn larger than they were built (wall.unit.real). Nothing is computed from the
// real size: it says which walls of docs/evidence/block_size.md, drawn so and as built, this one is like.
#pragma once

#include "wythe/parts/message.h"
#include "wythe/parts/model.h"
#include "wythe/parts/wall_spec.h"

namespace wythe {

// Three walls with units drawn `times` as long and high, over the same with units as built: least and largest mean
// change, and how many walls failed in another way.
struct CoarseWalls {
  int times;
  double force_low, force_high;  // of the peak [-]
  double drift_low, drift_high;  // of the displacement at 80 % of it; some pushes ended before [-]
  int other, walls;
};
inline constexpr CoarseWalls kCoarseWalls[] = {{2, -0.127, -0.002, 0.435, 0.608, 13, 32},
                                               {3, -0.033, 0.076, 0.431, 0.577, 15, 32}};

// A note where units are drawn larger than they were built.
void note_coarse_units(const ModelSpec& spec, Model& model);
// Why no verdict on such a wall is to be signed; empty where units are drawn as built, or nothing says how large those
// were.
[[nodiscard]] Message caution_of_units(const ModelSpec& spec);

}  // namespace wythe
