// The dimension of a unit, and the SI unit of a dimension: named units such as N/m take precedence over products of bases.
#include "units/dimension.h"

#include <array>
#include <cmath>

#include <fmt/format.h>

#include "units/quantity_error.h"
#include "units/unit_parser.h"

namespace wythe {
namespace {

constexpr std::array kNamedUnits = {"m",   "s",   "N",     "Pa",     "N/m", "Pa/m",
                                    "m/s", "1/s", "m/s^2", "kg/m^3", "m^2", "kg"};

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
  const auto known = parse_unit(unit);
  if (!known || known->logarithm)
    throw QuantityError(fmt::format("the unit {} is not known", unit),
                        "write it in a unit such as MPa, N/m, GPa/m, mm or deg");
  Dimension out;
  for (std::size_t i = 0; i < kRadian; ++i) out.add(std::string(kBaseUnits[i]), known->exponent[i]);
  return out;
}

}  // namespace wythe
