// Writes limits in the unit in which an engineer writes the key, and an example with the quotes that its kind needs.
#include "io/text/range_text.h"

#include <cmath>

#include <fmt/format.h>

#include "wythe/parts/units.h"

namespace wythe::io {
namespace {

std::string limit_text(double limit, const Key& key) {
  return *key.unit ? format_quantity(limit, key.unit, key.shown) : fmt::format("{}", limit);
}

}  // namespace

std::string range_text(const Key& key) {
  const Range& range = key.range;
  const bool below = std::isfinite(range.low), above = std::isfinite(range.high);
  const std::string low = below ? limit_text(range.low, key) : "";
  const std::string high = above ? limit_text(range.high, key) : "";
  if (below && above)
    return fmt::format("{} {} {} {}", range.low_open ? "more than" : "from", low,
                       range.high_open  ? "to less than"
                       : range.low_open ? "and up to"
                                        : "to",
                       high);
  if (below) return (range.low_open ? "more than " : "at least ") + low;
  if (above) return (range.high_open ? "less than " : "at most ") + high;
  return "any";
}

std::string example_text(const std::string& name, const Key& key, ValueKind kind) {
  const std::string example = key.example;
  if (example.empty()) return "";
  // A list has its own quotes.
  const bool quoted = kind != ValueKind::kBare && !example.starts_with('[');
  return quoted ? fmt::format("{} = \"{}\"", name, example) : fmt::format("{} = {}", name, example);
}

}  // namespace wythe::io
