// Parses the text of a unit into its factor and exponents of SI base units: "kN/mm^2", "lbf.ft-2", "kg m⁻³", "deg per s".
//
//   unit     = product | "" | "/" product
//   product  = power { [ blanks | "." | "-" | "*" | "·" | "/" | "per" ] power }      no sign means times, as in "2(m)"
//   power    = basic [ integer | ("^" | "**") integer | superscript digits ]
//   basic    = name | number | "(" product ")"
//   name     = { prefix by name } [ prefix by symbol ] unit of unit_table.cpp
//
// The language is that of UDUNITS-2, with its rules of blanks ("m-2" is a power, "m -2" a product). Not accepted are dates,
// offsets ("K @ 273.15"), logarithms of the user's own, and "m percent", which UDUNITS reads as "m per cent". A superscript may
// have a sign and exceed 3 here. A unit is found by binary search among some thousand names.
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <string_view>

#include "units/ratio.h"

namespace wythe {

constexpr std::array<std::string_view, 8> kBaseUnits = {"m", "kg",  "s",  "A",
                                                        "K", "mol", "cd", "rad"};
constexpr std::size_t kRadian = 7;  // its exponent is no part of the dimension

struct Unit {
  Ratio factor;  // SI base units in one of this unit
  std::array<int, kBaseUnits.size()> exponent{};
  // True where the zero differs from that of the SI unit, as for degC: no factor converts it.
  bool shifted = false;
  bool logarithm = false;
};

// Nothing where the text is not a unit.
[[nodiscard]] std::optional<Unit> parse_unit(std::string_view text);

}  // namespace wythe
