// Our elementary functions: their bits, and their agreement with the functions that they stand for.
#include "core/elementary.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>

namespace wythe::elementary_test {
namespace {

// Rounded from 113 bits (libquadmath of GCC 12).
TEST(Elementary, bits_are_those_of_the_rounded_value) {
  const struct {
    double (*function)(double);
    double x, y;
  } known[] = {
      {elementary::sin, 0x1p-1, 0x1.eaee8744b05fp-2},
      {elementary::sin, 0x1.8p+1, 0x1.210386db6d55bp-3},
      {elementary::sin, 0x1.86ap+16, 0x1.24daa9c527e96p-5},
      {elementary::cos, 0x1p-1, 0x1.c1528065b7d5p-1},
      {elementary::cos, -0x1.d333333333333p+2, 0x1.0d5a0848a01cbp-1},
      {elementary::tan, 0x1.0c152382d7365p-1, 0x1.279a74590331cp-1},
      {elementary::tan, 0x1.8p+0, 0x1.c33ed50b88777p+3},
      {elementary::atan, 0x1.8p-1, 0x1.4978fa3269ee1p-1},
      {elementary::atan, -0x1.4p+4, -0x1.8555a2787981fp+0},
      {elementary::asin, 0x1.3333333333333p-1, 0x1.4978fa3269ee1p-1},
      {elementary::acos, -0x1.3333333333333p-2, 0x1.e0200bbc96ad8p+0},
      {elementary::exp, 0x1p+0, 0x1.5bf0a8b145769p+1},
      {elementary::exp, -0x1.299999999999ap+5, 0x1.422f4cf50e1d5p-54},
      {elementary::expm1, 0x1.4f8b588e368f1p-17, 0x1.4f8bc681cdfb6p-17},
      {elementary::log, 0x1p+1, 0x1.62e42fefa39efp-1},
      {elementary::log, 0x1.000001ad7f29bp+0, 0x1.ad7f2847b6492p-24},
      {elementary::log10, 0x1.89374bc6a7efap-9, -0x1.42edb0d36054p+1},
      {elementary::log1p, 0x1.12e0be826d695p-30, 0x1.12e0be801f1d9p-30},
      {elementary::cbrt, 0x1p+1, 0x1.428a2f98d728bp+0},
  };
  for (const auto& [function, x, y] : known) EXPECT_EQ(function(x), y) << x;
}

// libm is within an ulp of the true value, and this is within half a one.
TEST(Elementary, agree_with_the_library_to_an_ulp_and_a_half) {
  std::mt19937_64 random(1);
  const auto near = [](double a, double b) {
    const double ulp = std::nextafter(std::fabs(b), 1e308) - std::fabs(b);
    return std::fabs(a - b) <= 1.5 * ulp;
  };
  std::uniform_real_distribution<double> any(-3, 3), share(-1, 1), size(-30, 30);
  for (int i = 0; i < 2000; ++i) {
    const double x = any(random), y = any(random), s = share(random), e = size(random);
    const double p = std::exp(e);
    EXPECT_TRUE(near(elementary::sin(x), std::sin(x))) << x;
    EXPECT_TRUE(near(elementary::cos(x), std::cos(x))) << x;
    EXPECT_TRUE(near(elementary::tan(x), std::tan(x))) << x;
    EXPECT_TRUE(near(elementary::atan2(x, y), std::atan2(x, y))) << x << " " << y;
    EXPECT_TRUE(near(elementary::asin(s), std::asin(s))) << s;
    EXPECT_TRUE(near(elementary::acos(s), std::acos(s))) << s;
    EXPECT_TRUE(near(elementary::exp(e), std::exp(e))) << e;
    EXPECT_TRUE(near(elementary::expm1(s), std::expm1(s))) << s;
    EXPECT_TRUE(near(elementary::log(p), std::log(p))) << p;
    EXPECT_TRUE(near(elementary::log1p(p), std::log1p(p))) << p;
    EXPECT_TRUE(near(elementary::log10(p), std::log10(p))) << p;
    EXPECT_TRUE(near(elementary::pow(p, x), std::pow(p, x))) << p << " " << x;
    const double side = elementary::cbrt(x);  // glibc's own is off by up to 4 ulp
    EXPECT_NEAR(side * side * side, x, 8e-16 * std::fabs(x));
    EXPECT_TRUE(near(elementary::hypot(x, p), std::hypot(x, p))) << x << " " << p;
  }
}

// Exact results stay exact, and edge cases are those of IEEE 754 and C.
TEST(Elementary, exact_values_and_edges) {
  constexpr double kInf = std::numeric_limits<double>::infinity();
  const auto is_nan = [](double x) { return std::isnan(x); };
  EXPECT_EQ(elementary::hypot(3, 4), 5);
  EXPECT_EQ(elementary::hypot(std::ldexp(3, 600), -std::ldexp(4, 600)), std::ldexp(5, 600));
  EXPECT_EQ(elementary::hypot(3e-320, 0), 3e-320);
  EXPECT_EQ(elementary::pow(-2, 3), -8);
  EXPECT_EQ(elementary::pow(10, -3), 1e-3);
  EXPECT_EQ(elementary::pow(2, 0.5), std::sqrt(2.0));
  EXPECT_EQ(elementary::pow(0, 0.5), 0);
  EXPECT_TRUE(is_nan(elementary::pow(-2, 0.5)));
  EXPECT_EQ(elementary::log10(1000), 3);
  EXPECT_EQ(elementary::log10(1e-5), -5);
  EXPECT_EQ(elementary::cbrt(-27), -3);
  EXPECT_EQ(elementary::exp(0), 1);
  EXPECT_EQ(elementary::exp(-800), 0);
  EXPECT_EQ(elementary::exp(800), kInf);
  EXPECT_EQ(elementary::log(0), -kInf);
  EXPECT_TRUE(is_nan(elementary::log(-1)));
  EXPECT_EQ(elementary::tan(0), 0);
  EXPECT_EQ(elementary::atan2(0, -1), 3.141592653589793);
  EXPECT_EQ(elementary::atan2(-0.0, -1), -3.141592653589793);
  EXPECT_EQ(elementary::atan2(1, 0), 1.5707963267948966);
  EXPECT_EQ(elementary::atan2(kInf, -kInf), 3 * 0.7853981633974483);
  EXPECT_EQ(elementary::asin(1), 1.5707963267948966);
  EXPECT_EQ(elementary::acos(-1), 3.141592653589793);
  EXPECT_TRUE(is_nan(elementary::acos(1.5)));
  EXPECT_TRUE(is_nan(elementary::sin(kInf)));
}

}  // namespace
}  // namespace wythe::elementary_test
