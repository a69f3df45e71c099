// Quantities as text: units of masonry papers, refusals with their cure, and exact round trips.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>
#include <string>
#include <thread>
#include <vector>

#include "core/text.h"
#include "core/to_int.h"
#include "geometry/wall/fit.h"
#include "wythe/parts/units.h"

namespace wythe::units_test {
namespace {

struct Reading {
  const char* text;
  const char* si_unit;
  double value;
};

class Quantity : public testing::TestWithParam<Reading> {};

// Two bits: the factor of a unit may be off by one rounding, the product by another.
TEST_P(Quantity, is_read_in_si) {
  const Reading& reading = GetParam();
  const double bound = 2 * std::numeric_limits<double>::epsilon() * std::abs(reading.value);
  EXPECT_NEAR(parse_quantity(reading.text, reading.si_unit), reading.value, bound) << reading.text;
}

constexpr double kDegree = std::numbers::pi / 180;
INSTANTIATE_TEST_SUITE_P(
    units, Quantity,
    testing::Values(Reading{"0.15 MPa", "Pa", 0.15e6}, Reading{"20 GPa/m", "Pa/m", 20e9},
                    Reading{"4.3 N/m", "N/m", 4.3}, Reading{"16.2 deg", "rad", 16.2 * kDegree},
                    Reading{"1250 kg/m^3", "kg/m^3", 1250}, Reading{"10 mm/s", "m/s", 0.01},
                    Reading{"200 kN", "N", 200e3}, Reading{"9.81 m/s^2", "m/s^2", 9.81},
                    Reading{"0.15 g", "m/s^2", 0.15 * 9.80665}, Reading{"0.1 1/s", "1/s", 0.1},
                    Reading{"0.1 /s", "1/s", 0.1}, Reading{"2 deg/s", "rad/s", 2 * kDegree},
                    Reading{"310 mm", "m", 0.31}, Reading{"5 N/mm^2", "Pa", 5e6},
                    Reading{"5 kJ/m^2", "N/m", 5000}, Reading{"0.3 rad", "rad", 0.3},
                    Reading{"2 min", "s", 120}, Reading{"  +5.1m ", "m", 5.1},
                    Reading{"-1e-3 m", "m", -1e-3}));

std::string refusal(const std::string& text, const std::string& si_unit) {
  try {
    (void)parse_quantity(text, si_unit);
  } catch (const std::invalid_argument& error) {
    return error.what();
  }
  return "";
}

// A short ton and a grain, as UDUNITS has them, nobody means who weighs masonry.
TEST(QuantityRefused, words_that_mean_two_things) {
  for (const char* text : {"1.8 ton/m^3", "1.8 ton m-3", "1.8 tons/m^3", "0.0018 kton/m^3"})
    EXPECT_NE(refusal(text, "kg/m^3").find("write t (1000 kg) or 2000 lb"), std::string::npos)
        << text;
  for (const char* text : {"1.8 gr/cm^3", "1800 kgr/m^3", "1.8 gr cm-3"})
    EXPECT_NE(refusal(text, "kg/m^3").find("write g"), std::string::npos) << text;
  for (const char* text : {"15 ton_force/m^2", "15 ton_force m-2"})
    EXPECT_NE(refusal(text, "Pa").find("9.80665 kN"), std::string::npos) << text;
  for (const char* text : {"1.8 t/m^3", "1.8 tonne/m^3", "1.8 metric_ton/m^3", "1.8 g/cm^3"})
    EXPECT_NEAR(parse_quantity(text, "kg/m^3"), 1800, 1e-9) << text;
}

TEST(QuantityRefused, bare_number_names_the_cure) {
  EXPECT_EQ(refusal("5.10", "m"), "has no unit; write it with its unit, e.g. \"5.10 m\"");
}

TEST(QuantityRefused, other_dimension_names_both_units) {
  EXPECT_EQ(refusal("3 kg", "Pa"),
            "kg is not the unit of a stress [Pa]; write it in Pa or a multiple of it");
  EXPECT_NE(refusal("3 m", "rad"), "");
}

// 3 s is no 1/3 of 1/s, and degC has another zero than K.
TEST(QuantityRefused, reciprocals_and_offsets_are_not_factors) {
  EXPECT_NE(refusal("3 s", "1/s"), "");
  EXPECT_NE(refusal("3 degC", "K"), "");
}

TEST(QuantityRefused, unknown_unit) {
  EXPECT_EQ(refusal("3 Mpa", "Pa"),
            "the unit Mpa is not known; write it in Pa or a multiple of it");
}

TEST(QuantityRefused, numbers_that_are_none) {
  for (const char* text : {"nan MPa", "inf MPa", "-inf MPa", "1e999 MPa", "1e308 GPa", "", "MPa"})
    EXPECT_NE(refusal(text, "Pa"), "") << text;
}

// A word is no number followed by a unit: "infinite" is not inf times inite.
TEST(QuantityRefused, words_that_begin_like_a_number) {
  for (const char* word : {"infinite", "inflation", "nano", "nanometre", "Infinitely"})
    EXPECT_NE(refusal(word, "Pa").find(std::string("'") + word + "' is not a number with a unit"),
              std::string::npos)
        << refusal(word, "Pa");
  for (const char* number : {"inf", "infinity", "nan", "inf Pa"})
    EXPECT_NE(refusal(number, "Pa").find("is not a finite number"), std::string::npos)
        << refusal(number, "Pa");
}

TEST(QuantityRefused, decimal_comma_and_grouped_digits) {
  EXPECT_NE(refusal("0,15 MPa", "Pa").find("decimal comma"), std::string::npos);
  EXPECT_NE(refusal("1 200 mm", "m").find("more than one number"), std::string::npos);
  EXPECT_NE(refusal("3 m 4", "m").find("more than one number"), std::string::npos);
  // a second point, a range, a mark of thousands or brackets would multiply
  for (const char* text : {"1.0.5 m", "1.0 .5 m", "10-20 mm", "10+20 mm", "1'000 mm", "3(2 m)",
                           "3 m.5", "3 m(5)", "3 m'5", "1′000 mm", "3 m²5"})
    EXPECT_NE(refusal(text, "m").find("is more than one number"), std::string::npos) << text;
  EXPECT_EQ(parse_quantity("3 kg.m-3", "kg/m^3"), 3);
  EXPECT_EQ(parse_quantity("3 kN.m-1", "N/m"), 3000);
  EXPECT_EQ(parse_quantity("3 m(kg/s2)/m2", "Pa"), 3);
  EXPECT_EQ(parse_quantity("3 1/s", "1/s"), 3);
  EXPECT_EQ(parse_quantity("3 N (1/mm2)", "Pa"), 3e6);
  EXPECT_EQ(parse_quantity("3 N·mm⁻²", "Pa"), 3e6);
  EXPECT_EQ(parse_quantity("3 kN/(m.s)", "N/m/s"), 3000);
}

TEST(QuantityWritten, in_the_engineers_unit_and_back_to_the_bit) {
  EXPECT_EQ(format_quantity(parse_quantity("16.2 deg", "rad"), "rad", "deg"), "16.2 deg");
  EXPECT_EQ(format_quantity(0.31, "m", "mm"), "310 mm");
  EXPECT_EQ(format_quantity(0.15e6, "Pa", "MPa"), "0.15 MPa");
  EXPECT_EQ(format_quantity(std::numeric_limits<double>::infinity(), "Pa", "MPa"), "unlimited");
}

TEST(QuantityWritten, awkward_values_return_to_the_bit) {
  for (const double value :
       {1.0 / 3, 0.1 + 0.2, 5e-324, 1e-310, 1.7976931348623157e308, -0.0, 1e22})
    for (const auto& [si, shown] : {std::pair("m", "mm"), std::pair("Pa", "MPa"),
                                    std::pair("rad", "deg"), std::pair("1", "%")}) {
      const double back = parse_quantity(format_quantity(value, si, shown), si);
      EXPECT_EQ(back, value) << si;
      EXPECT_EQ(std::signbit(back), std::signbit(value));
    }
}

TEST(UnitFactor, converts_units_and_refuses_others) {
  EXPECT_EQ(unit_factor("mm", "m"), 0.001);
  EXPECT_THROW((void)unit_factor("mm", "s"), std::invalid_argument);
  for (const char* with_number : {"1000 mm", "4444fm", "mm 2", "1e3 m", "m/10", "m*10", "m×10",
                                  "m·10"})  // no unit: "0.5 1000 mm" is two numbers
    EXPECT_THROW((void)unit_factor(with_number, "m"), std::invalid_argument) << with_number;
  EXPECT_EQ(unit_factor("1", "1"), 1);
  EXPECT_EQ(unit_factor("1/ms", "1/s"), 1000);
  EXPECT_EQ(unit_factor("N/mm**2", "Pa"), 1e6);
  EXPECT_EQ(unit_factor("kN·m-2", "Pa"), 1e3);
}

// The table of units is made at the first call, by one thread for all.
TEST(UnitTable, serves_threads_at_once) {
  std::vector<std::thread> threads;
  std::vector<int> wrong(4, 0);
  for (std::size_t t = 0; t < wrong.size(); ++t)
    threads.emplace_back([&wrong, t] {
      for (int i = 1; i <= 500; ++i) {
        const std::string text = std::to_string(i) + " " + (i % 2 ? "mm" : "cm");
        wrong[t] += parse_quantity(text, "m") != i / (i % 2 ? 1000.0 : 100.0);
        wrong[t] += refusal("1 furlongg" + std::to_string(i), "m").empty();
      }
    });
  for (std::thread& thread : threads) thread.join();
  EXPECT_EQ(wrong, std::vector<int>(4, 0));
}

// No int is as large as some places: the cast alone gave the first line for them.
TEST(Axis, far_places_are_nearest_to_its_ends) {
  geometry::Axis axis;
  axis.extent = 2, axis.step = 0.5, axis.count = 4;
  for (const double far : {3.0, 1e10, 1e12}) {
    EXPECT_EQ(axis.nearest(far), 4) << far;
    EXPECT_EQ(axis.nearest(-far), 0) << far;
  }
  EXPECT_EQ(to_int(-1e300), -1'000'000'000);
  EXPECT_EQ(to_int(std::nan("")), 0);
  EXPECT_EQ(to_int(2.9), 2);
}

TEST(EditDistance, counts_slips) {
  EXPECT_EQ(edit_distance("length", "length"), 0);
  EXPECT_EQ(edit_distance("lenght", "length"), 1);  // a swap
  EXPECT_EQ(edit_distance("lngth", "length"), 1);
  EXPECT_EQ(edit_distance("", "abc"), 3);
}

TEST(NearestName, is_offered_only_when_near) {
  EXPECT_EQ(nearest_name("Thicknes", {"length", "thickness"}), "thickness");
  EXPECT_EQ(nearest_name("colour", {"length", "thickness"}), "");
  EXPECT_EQ(name_advice("colour", {"length", "thickness"}), "known here: length, thickness");
}

// Names that are too long or too short to be near are left out unseen: nobody notices but the clock.
TEST(NearestName, begins_alike_where_several_are_as_near) {
  EXPECT_EQ(nearest_name("g", {"y", "g1", "g2"}), "g1");
  EXPECT_EQ(nearest_name("qx", {"x", "q"}), "q");
  EXPECT_EQ(nearest_name("z", {"x", "y"}), "");  // another letter is another name
}

TEST(NearestName, is_the_first_of_the_least_distance) {
  const std::vector<std::string> names = {"a",   "length",           "thickness",     "cohesion",
                                          "bed", "tensile_strength", "shear_strength"};
  for (const std::string& name : names)
    for (std::size_t cut = 0; cut <= name.size(); ++cut)
      for (const char* more : {"", "x", "xyz", "_strength"}) {
        const std::string wanted = name.substr(0, cut) + more;
        int best = std::max(1, static_cast<int>(wanted.size()) / 3) + 1;
        std::string nearest;
        bool begun = false;
        for (const std::string& other : names) {
          const int far = edit_distance(wanted, other);
          const bool begins = other.starts_with(wanted) || wanted.starts_with(other);
          if (far >= static_cast<int>(std::max(wanted.size(), other.size()))) continue;
          if (far < best || (far == best && !nearest.empty() && begins && !begun)) {
            best = far;
            nearest = other;
            begun = begins;
          }
        }
        EXPECT_EQ(nearest_name(wanted, names), nearest) << wanted;
      }
}

}  // namespace
}  // namespace wythe::units_test
