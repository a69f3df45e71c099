// Text for pages and pictures: escaping, and numbers rounded for reading.
//
// All texts from the user's files go through escaped(): names are text, never markup.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace wythe::report {

[[nodiscard]] std::string escaped(std::string_view text);

// Significant digits, without exponent where possible: 163.42 -> "163", 0.003514 -> "0.00351",
// 2.4e-7 -> "2.4·10⁻⁷"; NaN -> "–", infinite -> "unlimited". web/src/base/texts.ts does the same.
[[nodiscard]] std::string rounded(double value, int digits = 3);
// rounded() with a unit after a narrow space; no unit after a dash or a word.
[[nodiscard]] std::string quantity(double value, std::string_view unit, int digits = 3);

// Escaped, with a capital and a full stop.
[[nodiscard]] std::string sentence(std::string_view text);
// With a capital letter, also an accented one; as text.
[[nodiscard]] std::string capital(std::string_view text);

// A large number, with its name and meaning below.
struct Card {
  std::string value, name, means;
};
[[nodiscard]] std::string draw_cards(const std::vector<Card>& cards);

}  // namespace wythe::report
