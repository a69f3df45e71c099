// Texts that users wrote, such as names and values; they may contain any characters.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace wythe {

// The text with control characters and invalid UTF-8 as escapes (\x1b, \n). A text longer than `most` bytes is truncated, and
// the result states its length.
[[nodiscard]] std::string readable(const std::string& text, std::size_t most = 100'000);

// As readable() for a text of several lines: line breaks stay.
[[nodiscard]] std::string readable_lines(const std::string& text);

// "did you mean run?" where a name is near the word; otherwise the list of names.
[[nodiscard]] std::string meant_name(std::string_view word, const std::vector<std::string>& names);

// ASCII capitals as small letters; other bytes stay.
[[nodiscard]] std::string small_letters(std::string_view text);

}  // namespace wythe
