// Arithmetic of dimensions for formulas with quantities: Pa m = N/m, N/m / Pa = m.
//
// A dimension is the exponents of the SI base units. Angles count as numbers here (rad = 1), so that
// tan(friction_angle) and atan(...) need no units of their own.
#pragma once

#include <map>
#include <string>
#include <string_view>

namespace wythe {

class Dimension {
 public:
  Dimension() = default;  // of a plain number

  [[nodiscard]] bool is_number() const { return exponent_.empty(); }
  // Whether every exponent is an integer; only such a dimension has a unit.
  [[nodiscard]] bool is_whole() const;
  // "Pa", "N/m", "m2.s-1", "1": the SI unit, as parse_quantity() reads it. With fractional exponents
  // it is a text for messages only.
  [[nodiscard]] std::string unit() const;
  // "a stress [Pa]", "a number"
  [[nodiscard]] std::string words() const;

  [[nodiscard]] Dimension times(const Dimension& other) const { return combined(other, 1); }
  [[nodiscard]] Dimension over(const Dimension& other) const { return combined(other, -1); }
  [[nodiscard]] Dimension power(double exponent) const;

  bool operator==(const Dimension& other) const = default;

 private:
  friend Dimension dimension_of(std::string_view unit);
  [[nodiscard]] Dimension combined(const Dimension& other, double sign) const;
  void add(const std::string& base, double exponent);

  std::map<std::string, double> exponent_;  // base unit -> exponent, never 0
};

// Dimension of "MPa", "GPa/m", "deg"; throws QuantityError for an unknown unit.
[[nodiscard]] Dimension dimension_of(std::string_view unit);

// The unit in SI base units, "1000000 m-1.kg.s-2", without the offset of degC; "" for an unknown unit (units.cpp).
[[nodiscard]] std::string unit_definition(std::string_view unit);

// "a stress" for "Pa"; "" for a unit whose quantity has no name (units.cpp).
[[nodiscard]] std::string quantity_name(std::string_view si_unit);

}  // namespace wythe
