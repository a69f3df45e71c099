// Typical materials: values from codes and from tests in the literature, with source and scatter.
//
// Used by src/io where a file states `use`. Test results of the building itself take precedence.
#pragma once

#include <limits>
#include <span>
#include <string_view>
#include <vector>

#include "materials/rules.h"

namespace wythe::materials {

// One typical value. Where the source gives an interval, `value` is its midpoint.
struct Datum {
  Role role;  // kMasonry: a key of [masonry], an input of rules; else a key of a joint law
  const char* key;
  const char* unit;  // of the three below; "": a plain number
  double value;
  double low = kNoBound, high = kNoBound;
  double cov = kNoBound;  // stated scatter; NaN: by the interval, or not known
  static constexpr double kNoBound = std::numeric_limits<double>::quiet_NaN();
};

struct Entry {
  const char* name;
  const char* title;
  const char* source;
  const char* note;
  UnitType unit_type;
  std::vector<Datum> data;
};

[[nodiscard]] std::span<const Entry> library();
[[nodiscard]] const Entry* entry_of(std::string_view name);
[[nodiscard]] const Datum* datum_of(const Entry& entry, Role role, std::string_view key);
// Coefficient of variation [-]. An interval counts as the 16 and 84 % fractiles of a lognormal variable
// (CNR-DT 212/2013). NaN where nothing is known.
[[nodiscard]] double cov_of(const Datum& datum);

}  // namespace wythe::materials
