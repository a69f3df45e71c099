// Quantities with units at the text boundary; SI inside. The only door to UDUNITS-2.
#pragma once

#include <string>
#include <string_view>

namespace wythe {

// Reads "0.15 MPa" and returns the value in `si_unit` ("Pa").
// Throws std::invalid_argument with a message that names the cure when the text has no unit, an
// unknown unit, or one of another dimension.
[[nodiscard]] double parse_quantity(std::string_view text, std::string_view si_unit);

// Factor and offset-free conversion of one `unit` to `si_unit`, e.g. ("mm", "m") -> 0.001.
[[nodiscard]] double unit_factor(std::string_view unit, std::string_view si_unit);

// Writes `value` (in `si_unit`) in `shown_unit` if reading it back gives the same bits, else in SI.
[[nodiscard]] std::string format_quantity(double value, std::string_view si_unit,
                                          std::string_view shown_unit);

}  // namespace wythe
