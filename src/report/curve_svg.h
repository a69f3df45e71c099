// The push-over curve as a picture: reaction over displacement, drift on the upper axis, base shear
// as a thin line, peak and 80 % crossing labelled, events as numbered marks.
#pragma once

#include <string>

#include "wythe/result.h"

namespace wythe::report {

// "" when there is nothing to draw. Where no force drives the wall (body force, tilt), the load
// factor takes the place of the reaction.
[[nodiscard]] std::string curve_svg(const Result& result);
[[nodiscard]] bool shows_load_factor(const Result& result);

}  // namespace wythe::report
