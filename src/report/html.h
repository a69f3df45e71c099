// Text for pages and pictures: escaping, and numbers a reader can take in at a glance.
//
// Everything that comes from the user's files goes through escaped(): names are text, never markup.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace wythe::report {

[[nodiscard]] std::string escaped(std::string_view text);

// Significant digits without exponent where sensible: 163.42 -> "163", 0.003514 -> "0.00351",
// 2.4e-7 -> "2.4·10⁻⁷"; not a number -> "–", infinite -> "unlimited". web/src/texts.ts has the same.
[[nodiscard]] std::string rounded(double value, int digits = 3);
// rounded() with a unit after a narrow space; no unit after a dash or a word.
[[nodiscard]] std::string quantity(double value, std::string_view unit, int digits = 3);

// Escaped, with a capital and a full stop.
[[nodiscard]] std::string sentence(std::string_view text);
// With a capital, also of an accented letter; as text.
[[nodiscard]] std::string capital(std::string_view text);

// A number large, its name and what it means below it.
struct Card {
  std::string value, name, means;
};
[[nodiscard]] std::string draw_cards(const std::vector<Card>& cards);

}  // namespace wythe::report
