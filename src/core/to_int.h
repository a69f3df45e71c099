// From a double to a whole number, also where no int is as large: such a conversion is undefined in the language.
#pragma once

#include <algorithm>
#include <cmath>

namespace wythe {

// The whole part; a thousand million at most on either side, 0 for what is no number.
[[nodiscard]] inline int to_int(double x) {
  return std::isnan(x) ? 0 : static_cast<int>(std::clamp(x, -1e9, 1e9));
}

}  // namespace wythe
