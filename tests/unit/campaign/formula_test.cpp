// Formulas of dependent quantities: values by hand, units, and messages about wrong formulas.
#include "campaign/draws/formula.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include "units/dimension.h"

namespace wythe::formula_test {
namespace {

const std::vector<std::string> kNames = {"ft", "E", "x"};

double value_of(const std::string& text) {
  const Formula formula(text, kNames);
  std::vector<double> inputs;
  for (const std::string& name : formula.inputs())
    inputs.push_back(name == "ft" ? 0.2e6 : name == "E" ? 2e9 : 3);
  return formula.value(inputs);
}

std::string unit_of(const std::string& text) {
  return Formula(text, kNames)
      .dimension({{"ft", dimension_of("Pa")}, {"E", dimension_of("Pa")}, {"x", Dimension()}})
      .unit();
}

std::string formula_fault(const std::string& text) {
  try {
    (void)unit_of(text);
  } catch (const FormulaError& error) {
    return std::string(error.what()) + "; " + error.cure();
  }
  return "";
}

// One rounding an operation.
TEST(FormulaValue, is_that_of_the_hand) {
  EXPECT_DOUBLE_EQ(value_of("1.5 * ft"), 0.3e6);
  EXPECT_DOUBLE_EQ(value_of("0.029 mm * ft"), 5.8);
  EXPECT_DOUBLE_EQ(value_of("ft / (0.15 MPa) * 125 N/m"), 125 * 4 / 3.0);
  EXPECT_DOUBLE_EQ(value_of("125 N/m * ft / 0.15 MPa"), 125 * 4 / 3.0);  // a unit holds closest
  EXPECT_DOUBLE_EQ(value_of("2 kg/m^3"), 2);
  EXPECT_DOUBLE_EQ(value_of("-x^2"), -9);
  EXPECT_DOUBLE_EQ(value_of("2^x^0.5"), std::pow(2, std::sqrt(3.0)));  // from the right
  EXPECT_DOUBLE_EQ(value_of("2^-1"), 0.5);
  EXPECT_DOUBLE_EQ(value_of("8 - x - 2"), 3);
  EXPECT_DOUBLE_EQ(value_of("12 / x / 2"), 2);
  EXPECT_DOUBLE_EQ(value_of("2 + x * 4"), 14);
  EXPECT_DOUBLE_EQ(value_of("(2 + x) * 4"), 20);
  EXPECT_DOUBLE_EQ(value_of("sqrt(16 MPa * 1 Pa)"), 4e3);
  EXPECT_DOUBLE_EQ(value_of("exp(log(x))"), 3);
  EXPECT_DOUBLE_EQ(value_of("atan(tan(30 deg))"), std::numbers::pi / 6);
  EXPECT_DOUBLE_EQ(value_of("min(x, 2, 5) + max(x, 2)"), 5);
  EXPECT_DOUBLE_EQ(value_of("sin(30 deg) + cos(60 deg)"), 1);
  EXPECT_DOUBLE_EQ(value_of("1e3 mm + .5 m"), 1.5);
}

TEST(FormulaUnit, follows_the_operations) {
  EXPECT_EQ(unit_of("1.5 * ft"), "Pa");
  EXPECT_EQ(unit_of("0.029 mm * ft"), "N/m");
  EXPECT_EQ(unit_of("ft / 2 mm"), "Pa/m");
  EXPECT_EQ(unit_of("ft / E * 3"), "1");
  EXPECT_EQ(unit_of("sqrt(ft * E)"), "Pa");
  EXPECT_EQ(unit_of("(ft * E)^0.5"), "Pa");
  EXPECT_EQ(unit_of("(8 m)^(1/3 + 2/3)"), "m");
  EXPECT_EQ(unit_of("atan(tan(16 deg))"), "1");
  EXPECT_EQ(unit_of("max(ft, 0.1 MPa)"), "Pa");
  EXPECT_EQ(unit_of("3 m * 2 m"), "m^2");
  EXPECT_EQ(unit_of("ft * 1 s"), "kg.m-1.s-1");
  EXPECT_EQ(dimension_of("kg.m-1.s-1"), dimension_of("Pa").times(dimension_of("s")));
}

TEST(FormulaRefused, with_both_units) {
  EXPECT_EQ(formula_fault("ft + 3 N/m"),
            "adds a stress [Pa] and a force per length or an energy per area [N/m]; give both the "
            "same unit");
  EXPECT_EQ(formula_fault("ft - 1"),
            "subtracts a stress [Pa] and a number; give both the same unit");
  EXPECT_EQ(formula_fault("max(ft, 2 m)"),
            "compares a stress [Pa] and a length [m]; give both the same unit");
  EXPECT_EQ(formula_fault("tan(ft)"), "tan of a stress [Pa]; divide by a quantity in Pa first");
  EXPECT_EQ(formula_fault("x ^ ft"),
            "has a stress [Pa] as an exponent; an exponent is a number without unit");
  EXPECT_EQ(formula_fault("ft ^ x"),
            "raises a stress [Pa] to a power that varies; divide by a quantity in Pa first");
}

TEST(FormulaRefused, where_it_can_not_be_read) {
  EXPECT_EQ(formula_fault(""), "is empty; write e.g. formula = \"1.5 * ft_j\"");
  EXPECT_EQ(formula_fault("1.5 ft"), "there is no operator between 1.5 and ft; write 1.5 * ft");
  EXPECT_EQ(formula_fault("1.5 * fx"), "there is no variable or dependent fx; did you mean ft?");
  EXPECT_EQ(formula_fault("1.5 Mpa").find("the unit Mpa is not known"), 0U);
  EXPECT_EQ(formula_fault("(ft * 2"),
            "')' is missing after the bracket's expression; close the bracket");
  EXPECT_EQ(formula_fault("ft *"), "ends where a number or a name is expected; complete it");
  EXPECT_EQ(formula_fault("ft ; 2").find("'; 2' is not expected there"), 0U);
  EXPECT_EQ(formula_fault("sqrt(x, 2)"), "sqrt has 2 operands; write sqrt(x)");
  EXPECT_EQ(formula_fault("max(x)"), "max has 1 operands; write max(x, y)");
  EXPECT_NE(formula_fault(std::string(500, '(')), "");
  EXPECT_NE(formula_fault(std::string(3000, '-') + "1"), "");
}

}  // namespace
}  // namespace wythe::formula_test
