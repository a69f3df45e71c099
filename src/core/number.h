// Reads numbers from text, the same in every locale: std::strtod, std::stod and streams follow the locale of a
// host program. "+1", leading blanks and numbers too large for the type are refused. fast_float reads fractions;
// std::from_chars reads integers, since not every standard library has it for fractions.
#pragma once

#include <fast_float/fast_float.h>
#include <charconv>
#include <cmath>
#include <optional>
#include <string_view>
#include <system_error>
#include <type_traits>

namespace wythe {

namespace detail {
// Whether the text has digits but its number is too large or too small for a double.
inline bool is_out_of_range(double value, std::string_view text) {
  const std::string_view digits = text.substr(0, text.find_first_of("eE"));
  return (std::isinf(value) && digits.find_first_of("0123456789") != std::string_view::npos) ||
         (value == 0 && digits.find_first_of("123456789") != std::string_view::npos);
}
}  // namespace detail

template <class T>
struct LeadingNumber {
  T value{};
  std::string_view rest;  // the text after the number
};

// Reads the number at the beginning of a text; nothing where there is none.
template <class T = double>
[[nodiscard]] std::optional<LeadingNumber<T>> leading_number(std::string_view text) {
  LeadingNumber<T> out;
  const char *const first = text.data(), *const last = first + text.size();
  const char* end = nullptr;
  if constexpr (std::is_floating_point_v<T>) {
    const auto read = fast_float::from_chars(first, last, out.value);
    const std::size_t length = read.ptr - first;
    if (read.ec != std::errc() || detail::is_out_of_range(out.value, text.substr(0, length)))
      return std::nullopt;
    end = read.ptr;
  } else {
    const auto read = std::from_chars(first, last, out.value);
    if (read.ec != std::errc()) return std::nullopt;
    end = read.ptr;
  }
  out.rest = text.substr(end - first);
  return out;
}

// Reads a text that is one number; nothing where it is none or has more text after it.
template <class T = double>
[[nodiscard]] std::optional<T> parse_number(std::string_view text) {
  const auto found = leading_number<T>(text);
  return found && found->rest.empty() ? std::optional(found->value) : std::nullopt;
}

}  // namespace wythe
