// The vocabulary of units, as text: one unit a line, read by unit_parser.cpp at the first use.
#pragma once

#include <string_view>

namespace wythe {

// Lines "definition | symbols | names". A definition names units of earlier lines alone.
extern const std::string_view kUnitLines;

}  // namespace wythe
