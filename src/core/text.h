// Finds the nearest names, for messages such as "did you mean ...", and reads bytes as text.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace wythe {

// Fewest letters to insert, delete, change or swap with a neighbour that turn `a` into `b`.
[[nodiscard]] int edit_distance(std::string_view a, std::string_view b);

// The candidate nearest to `name`, or "" where none is near enough: at most one error for every three
// letters, and at least one is allowed. Upper and lower case count as the same. Long names and long lists of
// names (core/limits.h) give "", since a hostile file could make the comparison last for hours.
[[nodiscard]] std::string nearest_name(std::string_view name,
                                       const std::vector<std::string>& candidates);

// "did you mean length?" where a candidate is near, "known here: a, b, c" otherwise.
[[nodiscard]] std::string name_advice(std::string_view name,
                                      const std::vector<std::string>& candidates);

// Whether `c` is one of 0 to 9, in any locale.
[[nodiscard]] constexpr bool is_digit(char c) { return c >= '0' && c <= '9'; }
[[nodiscard]] std::string_view trimmed(std::string_view text);
[[nodiscard]] std::string joined(const std::vector<std::string>& parts, std::string_view between);

// Number of bytes of the UTF-8 character at `i` (RFC 3629). 0 where there is none, and for a zero byte.
[[nodiscard]] std::size_t utf8_size(std::string_view text, std::size_t i);
[[nodiscard]] bool is_utf8(std::string_view text);

// RFC 4648, with padding.
[[nodiscard]] std::string base64(std::span<const std::uint8_t> bytes);
// Decodes base64; "" where the text is none.
[[nodiscard]] std::string bytes_of_base64(std::string_view text);

}  // namespace wythe
