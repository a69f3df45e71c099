// Reliability of a wall whose units are drawn larger than built (wall.unit.real). The real size enters no
// computation; it selects comparable walls of docs/evidence/block_size.md, which were computed both ways.
#pragma once

#include "wythe/parts/message.h"
#include "wythe/parts/model.h"
#include "wythe/parts/wall_spec.h"

namespace wythe {

// Three walls with units drawn `times` as long and high, compared with units as built: least and largest mean
// change, and number of walls with another failure mode.
struct CoarseWalls {
  int times;
  double force_low, force_high;  // of the peak [-]
  double drift_low, drift_high;  // of the displacement at 80 % of it; some pushes ended before [-]
  int other, walls;
};
inline constexpr CoarseWalls kCoarseWalls[] = {{2, -0.127, -0.002, 0.525, 0.606, 13, 32},
                                               {3, -0.034, 0.072, 0.429, 0.560, 15, 32}};

// Adds a note where units are drawn larger than built, or larger than any made where their real size is not stated.
void note_coarse_units(const ModelSpec& spec, Model& model);
// Why a verdict on such a wall must not be signed; empty where units are drawn as built.
[[nodiscard]] Message caution_of_units(const ModelSpec& spec);

}  // namespace wythe
