// Names and values that users wrote: they may contain any characters.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace wythe {

// The text with control characters and bytes that are no UTF-8 written out (\x1b, \n). A text longer than `most` bytes is cut, and
// its length is stated.
[[nodiscard]] std::string readable(const std::string& text, std::size_t most = 100'000);

// The same for a text of several lines: their ends stay.
[[nodiscard]] std::string readable_lines(const std::string& text);

// "did you mean run?" of a word that is near one of the names; else which there are.
[[nodiscard]] std::string meant_name(std::string_view word, const std::vector<std::string>& names);

// Capitals of ASCII made small; other bytes stay.
[[nodiscard]] std::string small_letters(std::string_view text);

}  // namespace wythe
