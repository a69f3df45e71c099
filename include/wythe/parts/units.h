// Reads and writes quantities with units. Inside the program all numbers are SI.
#pragma once

#include <string>
#include <string_view>

namespace wythe {

// Reads "0.15 MPa" and returns the value in `si_unit` ("Pa").
// Throws std::invalid_argument when the text has no unit, an unknown unit or one of another dimension;
// the message says what to write instead.
[[nodiscard]] double parse_quantity(std::string_view text, std::string_view si_unit);

// Factor from `unit` to `si_unit` (without offset), e.g. ("mm", "m") -> 0.001.
[[nodiscard]] double unit_factor(std::string_view unit, std::string_view si_unit);

// Writes `value` (in `si_unit`) in `shown_unit` if reading it back gives the same bits, else in SI.
[[nodiscard]] std::string format_quantity(double value, std::string_view si_unit,
                                          std::string_view shown_unit);

}  // namespace wythe
