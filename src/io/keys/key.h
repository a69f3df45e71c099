// Properties of one key in a description, besides its name and its place in the struct.
#pragma once

#include <limits>
#include <string>

#include "wythe/parts/wall_spec.h"

namespace wythe::io {

// Admissible values, in SI; open ends are not admissible.
struct Range {
  double low = -std::numeric_limits<double>::infinity();
  double high = std::numeric_limits<double>::infinity();
  bool low_open = false;
  bool high_open = false;

  [[nodiscard]] bool holds(double value) const {
    const bool above = low_open ? value > low : value >= low;
    return above && (high_open ? value < high : value <= high);
  }
};

inline constexpr double kQuarterTurn = 1.57079632679489661923;  // [rad]
inline constexpr Range kAnyValue{};
inline constexpr Range kPositive{.low = 0, .low_open = true};
inline constexpr Range kNotNegative{.low = 0};
// A wall is no longer than ten kilometres, and no block of one moves at 100 m/s (a run stops there).
inline constexpr double kLongest = 1e4;  // [m]
inline constexpr Range kLength{.low = 0, .high = kLongest, .low_open = true};
inline constexpr Range kDistance{.low = 0, .high = kLongest};
inline constexpr Range kCoordinate{.low = -kLongest, .high = kLongest};
inline constexpr Range kSpeed{.low = 0, .high = 100, .low_open = true, .high_open = true};
// Below this range a spectrum equals the peak acceleration, above it the peak displacement.
inline constexpr Range kSpectralPeriod{.low = 1e-3, .high = 100};  // [s]
inline constexpr Range kPoisson{.low = 0, .high = 0.5, .high_open = true};
inline constexpr Range kFromZero{.low = 0};
inline constexpr Range kFromOne{.low = 1};
inline constexpr Range kContraflexure{.low = 0.5, .high = 10};  // H0 / H
inline constexpr Range kBelowOne{.low = 0, .high = 1, .high_open = true};
inline constexpr Range kZeroToOne{.low = 0, .high = 1};
inline constexpr Range kPositiveToOne{.low = 0, .high = 1, .low_open = true};
inline constexpr Range kFrictionAngle{.low = 0, .high = kQuarterTurn, .high_open = true};
inline constexpr Range kSkewback{
    .low = 0, .high = kQuarterTurn, .low_open = true, .high_open = true};
inline constexpr Range kLean{
    .low = -kQuarterTurn, .high = kQuarterTurn, .low_open = true, .high_open = true};
inline constexpr Range kTiltAngle{
    .low = 0, .high = kQuarterTurn, .low_open = true, .high_open = true};

// Stage kinds of a key, as a bit set. 0 stands for every kind (and for all other tables).
using Kinds = unsigned;
constexpr Kinds kind_bit(StageKind kind) { return 1U << static_cast<unsigned>(kind); }

// As `fallback`: a key that is required, for the stages of its kind.
inline constexpr const char* kRequired = "required";

struct Key {
  const char* unit = "";   // SI unit of a quantity
  const char* shown = "";  // unit an engineer writes it in
  Range range = kAnyValue;
  bool may_be_unlimited = false;
  bool may_be_alone = false;  // of a list of numbers: a single one needs no brackets
  int count = 0;              // of a list of words: how many, 0 for any number
  Kinds kinds = 0;
  bool in_braces = false;     // table written as key = { ... }
  bool optional = false;      // table not written while it has no content
  const char* fallback = "";  // the effective value of an absent key without a default
  const char* example = "";   // as in the file, a quantity or text without its quotes
  const char* doc = "";
};

[[nodiscard]] inline std::string under(const std::string& path, const std::string& name) {
  return path.empty() ? name : path + '.' + name;
}

}  // namespace wythe::io
