// Recognises typing mistakes in a TOML text. The parser's own message only says where it stopped.
#pragma once

#include <string>
#include <string_view>

namespace wythe::io {

struct Slip {
  std::string problem, cure;  // "" where none is known
};

// The mistake in a line at which the parser stopped.
[[nodiscard]] Slip slip_in(std::string_view line);
// The same where the parser says that something is defined twice: "cannot redefine existing ... 'NAME'".
[[nodiscard]] Slip stated_twice(std::string_view line, std::string_view description);

// The parser's message in the user's terms; never empty.
[[nodiscard]] Slip slip_of_parser(std::string_view description);

// "C:\temp" in double quotes contains a tab: the intended name, with / for each \; "" where nothing is wrong.
[[nodiscard]] std::string path_as_meant(std::string_view path);

}  // namespace wythe::io
