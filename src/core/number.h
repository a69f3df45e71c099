// Numbers from text, the same in every locale: std::strtod, std::stod and streams follow the decimal comma that a host
// program may have set. Through std::from_chars, so "+1", blanks in front and numbers too large are none.
#pragma once

#include <charconv>
#include <optional>
#include <string_view>
#include <system_error>

namespace wythe {

template <class T>
struct LeadingNumber {
  T value{};
  std::string_view rest;  // of the text, behind the number
};

// The number that a text begins with; nothing where it begins with none.
template <class T = double>
[[nodiscard]] std::optional<LeadingNumber<T>> leading_number(std::string_view text) {
  LeadingNumber<T> out;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), out.value);
  if (error != std::errc()) return std::nullopt;
  out.rest = text.substr(static_cast<std::size_t>(end - text.data()));
  return out;
}

// The number that a text is; nothing where it is none, or more than that.
template <class T = double>
[[nodiscard]] std::optional<T> parse_number(std::string_view text) {
  const auto found = leading_number<T>(text);
  return found && found->rest.empty() ? std::optional(found->value) : std::nullopt;
}

}  // namespace wythe
