// The end of a history of an earthquake: did the wall stand, or was it only not watched long enough?
#pragma once

#include "wythe/parts/result.h"

namespace wythe::dynamics {

// Whether a wall that was shaken may fall yet when its history ends. After the records its energy does not grow, so a wall
// that has swung back stands. It may fall if in the last tenth of its history it moves more than ever since the records
// ended, with an energy that lifts its weight by a ten-thousandth of its height, or if its first point is farther away
// than ever and still goes on.
[[nodiscard]] bool is_still_moving(const Model& model, const Result& result);

}  // namespace wythe::dynamics
