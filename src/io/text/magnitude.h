// Limits for the magnitude of values in files. They are far beyond any wall, and no square
// or product of such values leaves the range of a double (docs/reference/limits.md).
#pragma once

#include <cmath>
#include <string>
#include <string_view>

#include <fmt/format.h>

namespace wythe::io {

// Limits for amounts other than zero, in SI.
struct Magnitude {
  std::string_view unit;
  double least, most;
};

inline constexpr Magnitude kMagnitudes[] = {
    {"m", 1e-9, 1e6},     {"m^2", 1e-12, 1e9},  {"s", 1e-6, 1e9},       {"1/s", 1e-6, 1e9},
    {"m/s", 1e-15, 1e3},  {"m/s^2", 1e-9, 1e6}, {"rad", 1e-9, 1e3},     {"rad/s", 1e-9, 1e3},
    {"N", 1e-6, 1e12},    {"N/m", 1e-6, 1e12},  {"Pa", 1e-3, 1e15},     {"Pa/m", 1e-3, 1e18},
    {"kg", 1e-6, 1e12},   {"kg/m", 1e-6, 1e12}, {"kg/m^2", 1e-6, 1e12}, {"kg/m^3", 1e-6, 1e6},
    {"N/m^3", 1e-5, 1e7},
};
inline constexpr Magnitude kMagnitudeOfNumbers{"1", 0, 1e15};

[[nodiscard]] inline Magnitude magnitude_of(std::string_view si_unit) {
  for (const Magnitude& known : kMagnitudes)
    if (known.unit == si_unit) return known;
  return kMagnitudeOfNumbers;
}

// The fault of a value in SI that no wall can have; "" for a possible value.
[[nodiscard]] inline std::string magnitude_problem(double value, std::string_view si_unit) {
  const Magnitude m = magnitude_of(si_unit);
  const double size = std::fabs(value);
  if (value == 0 || (size >= m.least && size <= m.most)) return "";
  const std::string unit = si_unit == "1" ? "" : fmt::format(" {}", si_unit);
  return size > m.most
             ? fmt::format("is larger than any of a wall, {:g}{} at most", m.most, unit)
             : fmt::format("is smaller than any of a wall, {:g}{} at least", m.least, unit);
}

}  // namespace wythe::io
