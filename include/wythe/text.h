// Texts of users in messages: names and values may hold anything.
#pragma once

#include <cstddef>
#include <string>

namespace wythe {

// A text as it may be printed: control characters are shown (\x1b, \n), and what is longer than `most`
// bytes is cut, with its length.
[[nodiscard]] std::string readable(const std::string& text, std::size_t most = 100'000);

}  // namespace wythe
