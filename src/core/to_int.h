// Converts a double to an int of any size: C++ leaves the conversion undefined where no int is as large.
#pragma once

#include <algorithm>
#include <cmath>

namespace wythe {

// The integer part, limited to a thousand million on either side; 0 for NaN.
[[nodiscard]] inline int to_int(double x) {
  return std::isnan(x) ? 0 : static_cast<int>(std::clamp(x, -1e9, 1e9));
}

}  // namespace wythe
