// At the end of an earthquake history: is the wall safe, or was it not followed for long enough?
#pragma once

#include "wythe/parts/result.h"

namespace wythe::dynamics {

// Whether a shaken wall may still fall when its history ends. After the records its energy does
// not grow, so a wall that has swung back stands. The wall may fall in two cases. Its energy in
// the last tenth is the largest since the records, and lifts its weight by a ten-thousandth of
// its height. Or its first point is farther away than ever and still moves on.
[[nodiscard]] bool is_still_moving(const Model& model, const Result& result);

}  // namespace wythe::dynamics
