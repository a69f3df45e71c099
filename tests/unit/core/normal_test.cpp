// The standard normal distribution and the gamma function against forty digits of mpmath.
#include "core/normal.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "core/gamma.h"

namespace wythe {
namespace {

struct Known {
  double at, value;
};

TEST(NormalShare, has_the_digits_of_a_double_in_both_tails) {
  for (const Known& k :
       {Known{-8, 6.2209605742717841e-16}, Known{-5.5, 1.8989562465887719e-8},
        Known{-3, 0.0013498980316300945}, Known{-1.25, 0.10564977366685526},
        Known{-0.001, 0.49960105778608893}, Known{0, 0.5}, Known{0.3, 0.61791142218895263},
        Known{1, 0.84134474606854295}, Known{2.5, 0.99379033467422386},
        Known{6, 0.99999999901341235}, Known{8, 0.99999999999999938}})
    EXPECT_NEAR(normal_share(k.at) / k.value, 1, 3e-16) << k.at;
  EXPECT_EQ(normal_share(40), 1);
  EXPECT_EQ(normal_share(-40), 0);
  EXPECT_TRUE(std::isnan(normal_share(std::numeric_limits<double>::quiet_NaN())));
}

TEST(NormalQuantile, has_the_digits_of_a_double) {
  for (const Known& k : {Known{1e-300, -37.047096299361199}, Known{1e-17, -8.4937932241095981},
                         Known{1e-9, -5.9978070150076869}, Known{0.01, -2.3263478740408411},
                         Known{0.075, -1.4395314709384559}, Known{0.3, -0.52440051270804082},
                         Known{0.9, 1.2815515655446006}, Known{0.999, 3.0902323061678133}})
    EXPECT_NEAR(normal_quantile(k.at) / k.value, 1, 8e-16) << k.at;
  EXPECT_EQ(normal_quantile(0.5), 0);
}

TEST(NormalQuantile, undoes_the_share_and_never_falls) {
  double before = -40;
  for (double u = 0x1p-40; u < 1; u += 1.0 / 4096) {
    const double z = normal_quantile(u);
    EXPECT_GE(z, before);
    EXPECT_NEAR(normal_share(z), u, 4e-16);  // 8e-16 of z moves it by z times the density of that
    before = z;
  }
}

TEST(LogGamma, has_the_digits_of_a_double_from_tiny_to_large) {
  for (const Known& k : {Known{1e-12, -5.7721566490071038e-13}, Known{1e-6, -5.7721484243490010e-7},
                         Known{0.01, -0.0056903079460696456}, Known{0.3, -0.10817480950786047},
                         Known{0.5, -0.12078223763524522}, Known{0.75, -0.084401121020485556},
                         Known{2.5, 1.2009736023470742}, Known{7.25, 9.0331869196051229},
                         Known{55, 168.32744544842765}, Known{109.2, 406.56166430202995}})
    EXPECT_NEAR(log_gamma_1p(k.at) / k.value, 1, 4e-15) << k.at;
  EXPECT_NEAR(log_gamma_1p(1), 0, 4e-16);  // Gamma(2) = 1
}

}  // namespace
}  // namespace wythe
