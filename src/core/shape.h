// Checks the shape of a text before a parser reads it: how deep it nests, how many keys it has.
//
// Parsers, and the destructors of their trees, recurse once a level: a text that nests 50 000 levels would
// overflow the stack. The check is one pass over the characters and allocates nothing.
#pragma once

#include <string>
#include <string_view>

namespace wythe {

enum class Syntax { kToml, kJson };

// Throws InputError with the line where brackets or dotted keys nest deeper than kMostDepth, or where a TOML
// text has more than kMostKeys keys. A text that is neither TOML nor JSON is left to the parser.
void check_shape(std::string_view text, Syntax syntax, const std::string& file);

}  // namespace wythe
