// The vocabulary of units as text, one unit a line; unit_parser.cpp reads it at the first use.
#pragma once

#include <string_view>

namespace wythe {

// Lines "definition | symbols | names". A definition uses only units of earlier lines.
extern const std::string_view kUnitLines;

}  // namespace wythe
