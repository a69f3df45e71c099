// A wall under an earthquake, computed in the frame of the base (docs/theory/dynamics.md).
#pragma once

#include "dynamics/stages/stage_run.h"

namespace wythe::dynamics {

// Whether a wall that was shaken may fall yet when its history ends. After the records its energy does not grow, so a wall
// that has swung back stands. It may fall if in the last tenth of its history it moves more than ever since the records
// ended, with an energy that lifts its weight by a ten-thousandth of its height, or if its first point is farther away
// than ever and still goes on.
[[nodiscard]] bool is_still_moving(const Model& model, const Result& result);

[[nodiscard]] std::unique_ptr<StageRun> make_shake(WallUnderWay& wall, const Stage& stage);

// Length of a shake [s], and the time between rows of its history.
[[nodiscard]] double shake_duration(const Stage& stage);
[[nodiscard]] double shake_interval(const Stage& stage);

// What the rows of all shakes say.
void read_shaking(const Model& model, Result& result);

}  // namespace wythe::dynamics
