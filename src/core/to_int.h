// From a double to an int, also where no int is as large: the language leaves such a conversion undefined.
#pragma once

#include <algorithm>
#include <cmath>

namespace wythe {

// The integer part; a thousand million at most on either side, 0 for what is no number.
[[nodiscard]] inline int to_int(double x) {
  return std::isnan(x) ? 0 : static_cast<int>(std::clamp(x, -1e9, 1e9));
}

}  // namespace wythe
