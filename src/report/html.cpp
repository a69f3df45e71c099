// Escapes text for HTML and XML, and rounds numbers to significant digits.
// Final zeros of decimals are dropped, and a minus is written as a minus
// sign. Values, names and meanings of cards must be markup already.
#include "report/html.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/ascii.h"

namespace wythe::report {
namespace {

// "2.4e-07" -> "2.4·10⁻⁷"
std::string with_power(double value, int digits) {
  static constexpr const char* kRaised[] = {"⁰", "¹", "²", "³", "⁴", "⁵", "⁶", "⁷", "⁸", "⁹"};
  const std::string text = fmt::format("{:.{}e}", value, std::max(0, digits - 2));
  const std::size_t e = text.find('e');
  std::string_view power = std::string_view(text).substr(e + 2);  // without its sign
  while (power.size() > 1 && power.front() == '0') power.remove_prefix(1);
  std::string raised = text[e + 1] == '-' ? "⁻" : "";
  for (const char c : power) raised += kRaised[c - '0'];
  return text.substr(0, e) + "·10" + raised;
}

// A large number with a small unit: "49.4 kN/mm" fits a narrow card.
std::string with_small_unit(const std::string& value) {
  static const std::string kSpace = "\u202f";
  const std::size_t at = value.rfind(kSpace);
  if (at == std::string::npos) return value;
  return value.substr(0, at) + "\u2009<span class=\"unit\">" + value.substr(at + kSpace.size()) +
         "</span>";
}

}  // namespace

std::string escaped(std::string_view text) {
  std::string out;
  out.reserve(text.size());
  for (char c : text) {
    switch (c) {
      case '&': out += "&amp;"; break;
      case '<': out += "&lt;"; break;
      case '>': out += "&gt;"; break;
      case '"': out += "&quot;"; break;
      case '\'': out += "&#39;"; break;
      default:
        // control characters are not allowed in XML, and would hide text in HTML
        out += static_cast<unsigned char>(c) < 0x20 && c != '\n' && c != '\t' ? ' ' : c;
    }
  }
  return out;
}

std::string rounded(double value, int digits) {
  if (std::isnan(value)) return "–";
  if (std::isinf(value)) return "unlimited";
  const double magnitude = std::abs(value);
  if (magnitude == 0) return "0";
  if (magnitude < 1e-4 || magnitude >= 1e7)
    return (value < 0 ? "−" : "") + with_power(magnitude, digits);
  const int whole = static_cast<int>(std::floor(std::log10(magnitude))) + 1;
  std::string text = fmt::format("{:.{}f}", value, std::clamp(digits - whole, 0, 8));
  if (text.find('.') != std::string::npos) {
    text.erase(text.find_last_not_of('0') + 1);
    if (text.back() == '.') text.pop_back();
  }
  return text.front() == '-' ? "−" + text.substr(1) : text;
}

std::string capital(std::string_view text) {
  std::string out(text);
  if (!out.empty()) out[0] = ascii_capital(out[0]);
  // letters from U+00E0 to U+00FE, except the division sign: their capitals are 32 lower
  const auto second = out.size() > 1 ? static_cast<unsigned char>(out[1]) : 0;
  if (out.starts_with('\xc3') && second >= 0xa0 && second <= 0xbe && second != 0xb7)
    out[1] = static_cast<char>(second - 0x20);
  return out;
}

std::string sentence(std::string_view text) {
  if (text.empty()) return "";
  std::string out = capital(text);
  if (out.back() != '.' && out.back() != '!' && out.back() != '?') out += '.';
  return escaped(out);
}

std::string quantity(double value, std::string_view unit, int digits) {
  std::string text = rounded(value, digits);
  if (!std::isfinite(value) || unit.empty()) return text;
  return text + "\u202f" + escaped(unit);
}

std::string draw_cards(const std::vector<Card>& cards) {
  if (cards.empty()) return "";
  std::string out = "<section class=\"cards\">\n";
  for (const Card& c : cards)
    out += "<div class=\"card\"><div class=\"value\">" + with_small_unit(c.value) +
           "</div><div class=\"name\">" + c.name + "</div><div class=\"means\">" + c.means +
           "</div></div>\n";
  return out + "</section>\n";
}

}  // namespace wythe::report
