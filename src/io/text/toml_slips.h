// Names typing mistakes in a TOML text. The parser's own message says where it stopped, not what is wrong.
#pragma once

#include <string>
#include <string_view>

namespace wythe::io {

struct Slip {
  std::string problem, cure;  // "" where none is known
};

// What is wrong with a line at which the parser stopped.
[[nodiscard]] Slip slip_in(std::string_view line);
// The same where the parser says that the line states something a second time: "cannot redefine existing ... 'NAME'".
[[nodiscard]] Slip stated_twice(std::string_view line, std::string_view description);

// What the parser says, in a user's words; never empty.
[[nodiscard]] Slip slip_of_parser(std::string_view description);

// "C:\temp" in double quotes holds a tab: the name as it was written, with / for each \; "" where nothing is wrong.
[[nodiscard]] std::string path_as_meant(std::string_view path);

}  // namespace wythe::io
