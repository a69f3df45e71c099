// The shape of a text before a parser sees it: how deep it nests, how many keys it has.
//
// Parsers and what destroys their trees call themselves a level at a time, so a text that nests 50 000 deep
// ends the program. One pass over the characters, no memory.
#pragma once

#include <string>
#include <string_view>

namespace wythe {

enum class Syntax { kToml, kJson };

// Throws InputError with the line where brackets or dotted keys nest deeper than kMostDepth, or where a TOML
// text has more than kMostKeys keys. What is no TOML or JSON at all is left to the parser.
void check_shape(std::string_view text, Syntax syntax, const std::string& file);

}  // namespace wythe
