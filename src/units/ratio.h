// Quotients of decimal numbers, for factors of units: N/mm^3 is 10^9 N/m^3 to the bit, and a pound per square inch is the
// double nearest to 0.45359237 * 9.80665 / 0.0254^2.
#pragma once

#include <string_view>

namespace wythe {

// high + low, where low is at most half a unit in the last place of high: an integer is exact up to 10^31 or so.
struct Wide {
  double high = 1, low = 0;
};

// over / under * 10^ten
struct Ratio {
  Wide over, under;
  int ten = 0;

  [[nodiscard]] Ratio times(const Ratio& other) const;
  [[nodiscard]] Ratio power(int exponent) const;
  // Rounded once, here. Not a normal number where a double can't hold it or `over` and `under`, and of 0.
  [[nodiscard]] double value() const;
};

// "-1.5e-3", of a text that is a number.
[[nodiscard]] Ratio ratio_of(std::string_view number);

}  // namespace wythe
