// Reads a dimension from a unit's definition in SI base units, and writes the SI unit of a dimension.
// The scale of a definition is skipped, and radians count as 1. Named units such as N/m go before products of bases.
#include "units/dimension.h"

#include <array>
#include <cmath>

#include <fmt/format.h>

#include "core/number.h"
#include "units/quantity_error.h"

namespace wythe {
namespace {

constexpr std::array kNamedUnits = {"m",   "s",   "N",     "Pa",     "N/m", "Pa/m",
                                    "m/s", "1/s", "m/s^2", "kg/m^3", "m^2", "kg"};

struct Factor {
  std::string base;
  int exponent = 1;
};

// "m-1" -> m, -1
Factor split_factor(std::string_view text) {
  const std::size_t digits = text.find_first_of("-0123456789");
  Factor out{std::string(text.substr(0, digits)), 1};
  if (digits != std::string_view::npos)
    if (const auto exponent = leading_number<int>(text.substr(digits)))
      out.exponent = exponent->value;
  return out;
}

bool is_number_text(std::string_view word) {
  return word.find_first_not_of("0123456789.eE+-") == std::string_view::npos;
}

}  // namespace

void Dimension::add(const std::string& base, double exponent) {
  double& total = exponent_[base];
  total += exponent;
  if (std::fabs(total) < 1e-12) exponent_.erase(base);
}

Dimension Dimension::combined(const Dimension& other, double sign) const {
  Dimension out = *this;
  for (const auto& [base, exponent] : other.exponent_) out.add(base, sign * exponent);
  return out;
}

Dimension Dimension::power(double exponent) const {
  Dimension out;
  for (const auto& [base, own] : exponent_) out.add(base, own * exponent);
  return out;
}

bool Dimension::is_whole() const {
  for (const auto& [base, exponent] : exponent_)
    if (std::fabs(exponent - std::round(exponent)) > 1e-12) return false;
  return true;
}

std::string Dimension::unit() const {
  if (is_number()) return "1";
  for (const char* name : kNamedUnits)
    if (dimension_of(name) == *this) return name;
  std::string out;
  for (const auto& [base, exponent] : exponent_) {
    out += (out.empty() ? "" : ".") + base;
    if (exponent != 1) out += fmt::format("{}", exponent);
  }
  return out;
}

std::string Dimension::words() const {
  if (is_number()) return "a number";
  const std::string own = unit(), name = quantity_name(own);
  return fmt::format("{} [{}]", name.empty() ? "a quantity" : name, own);
}

Dimension dimension_of(std::string_view unit) {
  const std::string definition = unit_definition(unit);
  if (definition.empty())
    throw QuantityError(fmt::format("the unit {} is not known", unit),
                        "write it in a unit such as MPa, N/m, GPa/m, mm or deg");
  Dimension out;
  for (std::size_t begin = 0; begin < definition.size();) {
    const std::size_t end = std::min(definition.find_first_of(" ", begin), definition.size());
    std::string_view word = std::string_view(definition).substr(begin, end - begin);
    begin = end + 1;
    if (is_number_text(word)) continue;  // the scale
    for (std::size_t from = 0; from < word.size();) {
      const std::size_t dot = std::min(word.find('.', from), word.size());
      const Factor factor = split_factor(word.substr(from, dot - from));
      if (factor.base != "rad") out.add(factor.base, factor.exponent);
      from = dot + 1;
    }
  }
  return out;
}

}  // namespace wythe
