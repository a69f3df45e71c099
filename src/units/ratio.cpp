// Products and quotients of sums of two doubles, after T. J. Dekker, A floating-point technique for extending the available
// precision, Numerische Mathematik 18 (1971). A fused multiply-add replaces his splitting.
#include "units/ratio.h"

#include <cmath>
#include <cstdlib>
#include <utility>

#include "core/number.h"
#include "core/text.h"

namespace wythe {
namespace {

// high + low with no overlap of their bits; requires |low| <= |high| or high = 0.
Wide normalized(double high, double low) {
  const double sum = high + low;
  return {sum, low - (sum - high)};
}

Wide product(const Wide& a, const Wide& b) {
  const double high = a.high * b.high;
  return normalized(high, std::fma(a.high, b.high, -high) + (a.high * b.low + a.low * b.high));
}

Wide raised(Wide base, int exponent) {
  Wide out;
  for (; exponent > 0; exponent /= 2, base = product(base, base))
    if (exponent % 2 == 1) out = product(out, base);
  return out;
}

}  // namespace

Ratio Ratio::times(const Ratio& other) const {
  return {product(over, other.over), product(under, other.under), ten + other.ten};
}

Ratio Ratio::power(int exponent) const {
  const int times = std::abs(exponent);
  Ratio out{raised(over, times), raised(under, times), ten * exponent};
  if (exponent < 0) std::swap(out.over, out.under);
  return out;
}

double Ratio::value() const {
  const Wide power_of_ten = raised({10, 0}, std::abs(ten));
  const Wide a = ten > 0 ? product(over, power_of_ten) : over;
  const Wide b = ten < 0 ? product(under, power_of_ten) : under;
  const double quotient = a.high / b.high;
  const double rest = std::fma(-quotient, b.high, a.high) + (a.low - quotient * b.low);
  return quotient + rest / b.high;
}

Ratio ratio_of(std::string_view number) {
  const bool negative = number.starts_with('-');
  if (negative || number.starts_with('+')) number.remove_prefix(1);
  Ratio out;
  out.over = {0, 0};
  bool in_fraction = false;
  int zeros = 0;  // since the last other digit: they become part of the power of ten
  for (; !number.empty() && (is_digit(number[0]) || number[0] == '.'); number.remove_prefix(1)) {
    if (number[0] == '.') {
      in_fraction = true;
      continue;
    }
    out.ten -= in_fraction;
    ++zeros;
    if (number[0] == '0') continue;
    const Wide shifted = product(out.over, raised({10, 0}, zeros));
    const Wide sum = normalized(shifted.high, number[0] - '0');
    out.over = normalized(sum.high, sum.low + shifted.low);
    zeros = 0;
  }
  if (negative) out.over = {-out.over.high, -out.over.low};
  out.ten += zeros;
  if (number.empty()) return out;
  number.remove_prefix(1);  // e
  if (number.starts_with('+')) number.remove_prefix(1);
  const auto exponent = leading_number<int>(number);
  out.ten += exponent ? exponent->value : 0;
  return out;
}

}  // namespace wythe
