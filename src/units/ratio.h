// Quotients of decimal numbers for the factors of units, rounded once: N/mm^3 is exactly 10^9 N/m^3, and a pound per square
// inch is the double nearest to 0.45359237 * 9.80665 / 0.0254^2.
#pragma once

#include <string_view>

namespace wythe {

// The sum high + low, where |low| is at most half an ulp of high: integers are exact up to some 10^31.
struct Wide {
  double high = 1, low = 0;
};

// The number over / under * 10^ten.
struct Ratio {
  Wide over, under;
  int ten = 0;

  [[nodiscard]] Ratio times(const Ratio& other) const;
  [[nodiscard]] Ratio power(int exponent) const;
  // The nearest double, rounded once. Not a normal number where a double can't hold it, `over` or `under`; 0 for 0.
  [[nodiscard]] double value() const;
};

// Reads the decimal number "-1.5e-3"; the text must be a number.
[[nodiscard]] Ratio ratio_of(std::string_view number);

}  // namespace wythe
