// Text of a unit to its factor and exponents of SI base units: "kN/mm^2", "lbf.ft-2", "kg m⁻³", "deg per s".
//
//   unit     = product | "" | "/" product
//   product  = power { [ blanks | "." | "-" | "*" | "·" | "/" | "per" ] power }      a sign missing: times, as in "2(m)"
//   power    = basic [ integer | ("^" | "**") integer | superscript digits ]
//   basic    = name | number | "(" product ")"
//   name     = { prefix by name } [ prefix by symbol ] unit of unit_table.cpp
//
// What one may write is what UDUNITS-2 reads, with its rules of blanks ("m-2" is a power, "m -2" a product), save dates,
// offsets ("K @ 273.15"), logarithms of one's own and "m percent", which is "m per cent" there. A superscript may have a
// sign and be more than 3 here. A unit is looked up by binary search among some thousand names.
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <string_view>

#include "units/ratio.h"

namespace wythe {

constexpr std::array<std::string_view, 8> kBaseUnits = {"m", "kg",  "s",  "A",
                                                        "K", "mol", "cd", "rad"};
constexpr std::size_t kRadian = 7;  // its exponent counts for no dimension

struct Unit {
  Ratio factor;  // one of it in SI base units
  std::array<int, kBaseUnits.size()> exponent{};
  // Zero elsewhere than that of the SI unit, as of degC alone: no factor converts it.
  bool shifted = false;
  bool logarithm = false;
};

// Nothing where the text is no unit.
[[nodiscard]] std::optional<Unit> parse_unit(std::string_view text);

}  // namespace wythe
