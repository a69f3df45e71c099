// Nearest names, for messages that say "did you mean ..."; and bytes as text.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace wythe {

// Smallest number of inserted, dropped, changed or swapped neighbouring letters from `a` to `b`.
[[nodiscard]] int edit_distance(std::string_view a, std::string_view b);

// The candidate closest to `name`, or "" when none is close enough to be meant: at most one slip
// for every three letters, and never less than one. Upper and lower case count as the same. Long names and long lists of
// names (core/limits.h) have none: a file could make the comparison last for hours.
[[nodiscard]] std::string nearest_name(std::string_view name,
                                       const std::vector<std::string>& candidates);

// "did you mean length?" when a candidate is near, "known here: a, b, c" otherwise.
[[nodiscard]] std::string name_advice(std::string_view name,
                                      const std::vector<std::string>& candidates);

// One of 0 to 9, whatever the locale.
[[nodiscard]] constexpr bool is_digit(char c) { return c >= '0' && c <= '9'; }
[[nodiscard]] std::string_view trimmed(std::string_view text);
[[nodiscard]] std::string joined(const std::vector<std::string>& parts, std::string_view between);

// Bytes of the UTF-8 character at `i` (RFC 3629); 0 where there is none, and for a zero byte, which no text holds.
[[nodiscard]] std::size_t utf8_size(std::string_view text, std::size_t i);
[[nodiscard]] bool is_utf8(std::string_view text);

// RFC 4648, with padding.
[[nodiscard]] std::string base64(std::span<const std::uint8_t> bytes);
// Back again; "" where that is no such text.
[[nodiscard]] std::string bytes_of_base64(std::string_view text);

}  // namespace wythe
