// Fragilities against the law of their samples, coverage of their intervals, the rejection rate of the test
// of fit, and indices against closed forms. Artificial campaigns with fixed seeds, as in intervals_test.
#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <numbers>
#include <vector>

#include "statistics/binary_fit.h"
#include "statistics/bootstrap.h"
#include "statistics/intervals.h"
#include "statistics/statistics_parts.h"
#include "verification/record.h"

namespace wythe::verification::fragility_test {
namespace {

using namespace study;

double normal(RandomBits& bits) { return normal_quantile(bits.uniform()); }

// Outcomes of a law at inputs drawn by `input`, log-odds or probit a + b x.
BinaryData drawn(RandomBits& bits, FragilityLaw law, int n, double a, double b,
                 const std::function<double(RandomBits&)>& input) {
  BinaryData data{law, {Column()}, {}};
  for (int i = 0; i < n; ++i) {
    const double x = input(bits), eta = a + b * x;
    const double p = law == FragilityLaw::kLogistic ? 1 / (1 + std::exp(-eta)) : normal_cdf(eta);
    data.x[0].push_back(x), data.y.push_back(bits.uniform() < p ? 1 : 0);
  }
  return data;
}

TEST(BinaryFit, meets_a_closed_form) {
  // two groups: the slope is the difference of the log-odds, whatever the iteration does; a third of the
  // groups' middle would move it
  BinaryData data{FragilityLaw::kLogistic, {Column()}, {}};
  const auto add = [&](double x, int yes, int no) {
    for (int i = 0; i < yes + no; ++i) data.x[0].push_back(x), data.y.push_back(i < yes ? 1 : 0);
  };
  add(0, 6, 24), add(2, 21, 9);
  const BinaryFit fit(data);
  ASSERT_TRUE(fit.is_finite());
  const char* because = "the iteration's own end, 1e-8";
  verify({"fragility", "slope of a logistic fit to two groups", "-",
          (std::log(21.0 / 9) - std::log(6.0 / 24)) / 2, 1e-7, because},
         fit.slope(0));
  verify({"fragility", "its intercept", "-", std::log(6.0 / 24), 1e-7, because}, fit.intercept());
  const double error = std::sqrt(1 / 6.0 + 1 / 24.0 + 1 / 21.0 + 1 / 9.0) / 2;
  verify({"fragility", "Wald half-width of the slope: sqrt of the sum of inverse counts", "-",
          kNormal95 * error, 1e-6, because},
         fit.wald_slope(0).high - fit.slope(0));
  const double whole = 27 * std::log(27.0 / 60) + 33 * std::log(33.0 / 60);
  const double split =
      6 * std::log(0.2) + 24 * std::log(0.8) + 21 * std::log(0.7) + 9 * std::log(0.3);
  verify({"fragility", "log-likelihood of that fit", "-", split, 1e-9, because},
         fit.log_likelihood());
  verify(
      {"fragility", "p of its influence", "-", std::erfc(std::sqrt(split - whole)), 1e-6, because},
      fit.influence_p());
}

TEST(BinaryFit, profile_interval_of_a_slope_ends_where_the_likelihood_has_fallen) {
  // two groups again: with slope s fixed, the best intercept has no closed form, but both groups' shares are
  // free under the null of equal odds: the interval holds 0 exactly where p of the influence is above 5 %
  for (const int yes : {14, 15, 16, 17, 18}) {
    BinaryData data{FragilityLaw::kLogistic, {Column()}, {}};
    for (int i = 0; i < 60; ++i)
      data.x[0].push_back(i < 30 ? 0 : 1), data.y.push_back(i < 10 || (i >= 30 && i < 30 + yes));
    const BinaryFit fit(data);
    EXPECT_EQ(fit.profile_slope().low > 0, fit.influence_p() < 0.05) << yes;
  }
}

TEST(ChiSquare, tail_meets_tables) {
  for (const auto& [x, degrees, p] : {std::tuple{3.841459, 1, 0.05},
                                      {5.991465, 2, 0.05},
                                      {15.50731, 8, 0.05},
                                      {16.91898, 9, 0.05},
                                      {2.167350, 7, 0.95}})
    verify({"fragility", "P(chi^2 > x), tables", "-", p, 4e-6,
            "seven digits of x: half a unit of the last, 5e-6, times the density 0.03 over p"},
           chi_square_beyond(x, degrees));
}

struct Coverages {
  double slope = 0, half = 0, curve_low = 0, curve_middle = 0, rejected = 0;
  double bias = 0;  // of the mean slope, relative
};
// Over 600 campaigns of n samples; the curve at the 10 % and 60 % points of a uniform input.
Coverages coverages(FragilityLaw law, int n, double a, double b) {
  constexpr int kCampaigns = 600;
  RandomBits bits(20240229);
  Coverages c;
  int told = 0, tested = 0;
  const auto holds = [](const Interval& i, double truth) {
    return i.low <= truth && truth <= i.high;
  };
  const auto p = [&](double x) {
    return law == FragilityLaw::kLogistic ? 1 / (1 + std::exp(-a - b * x)) : normal_cdf(a + b * x);
  };
  for (int k = 0; k < kCampaigns; ++k) {
    const BinaryData data = drawn(bits, law, n, a, b, [](RandomBits& r) { return r.uniform(); });
    const BinaryFit fit(data);
    if (!fit.is_finite()) continue;
    ++told;
    c.slope += holds(fit.profile_slope(), b);
    c.half += holds(fit.half().interval, -a / b);
    c.curve_low += holds(fit.at({0.1}).interval, p(0.1));
    c.curve_middle += holds(fit.at({0.6}).interval, p(0.6));
    c.bias += fit.slope(0) / b - 1;
    const double fit_p = fit.fit_p();
    tested += std::isfinite(fit_p) ? 1 : 0, c.rejected += fit_p < 0.05 ? 1 : 0;
  }
  EXPECT_GT(told, 590);
  for (double* share : {&c.slope, &c.half, &c.curve_low, &c.curve_middle, &c.bias}) *share /= told;
  c.rejected /= tested;
  return c;
}

TEST(Fragility, intervals_of_both_laws_cover) {
  const char* because = "scatter of 600 toy campaigns, 0.9 %, two and a half times";
  for (const FragilityLaw law : {FragilityLaw::kLogistic, FragilityLaw::kLognormal})
    for (const int n : {60, 250}) {
      const bool logit = law == FragilityLaw::kLogistic;
      const Coverages c = logit ? coverages(law, n, -4, 7) : coverages(law, n, -2.2, 4);
      const std::string what =
          std::string(word_of(kFragilityLawWords, law)) + ", " + std::to_string(n) + " samples: ";
      verify({"coverage", what + "slope, profile likelihood", "-", 0.95, 0.023, because, true},
             c.slope);
      verify({"coverage", what + "place of P = 1/2", "-", 0.95, 0.023, because, true}, c.half);
      verify({"coverage", what + "curve at its lower end", "-", 0.95, 0.023, because, true},
             c.curve_low);
      verify({"coverage", what + "curve in its middle", "-", 0.95, 0.023, because, true},
             c.curve_middle);
      verify({"coverage", what + "share rejected by the test of fit", "-", 0.05, 0.03,
              "scatter 0.9 %, and 2 % for a test that is exact for many samples alone", true},
             c.rejected);
    }
}

TEST(Fragility, recovers_a_lognormal_resistance) {
  // theta = 0.15, beta = 0.3, 4000 samples: b = 1 / beta
  RandomBits bits(7);
  const BinaryData data =
      drawn(bits, FragilityLaw::kLognormal, 4000, -std::log(0.15) / 0.3, 1 / 0.3,
            [](RandomBits& r) { return std::log(0.15) + 0.4 * normal(r); });
  const BinaryFit fit(data);
  const char* because = "three standard errors of 4000 samples";
  verify({"fragility", "median of a lognormal resistance", "MPa", 0.15, 0.03, because},
         std::exp(fit.half().value));
  verify({"fragility", "its beta", "-", 0.3, 0.1, because}, 1 / fit.slope(0));
}

TEST(Fragility, test_of_fit_sees_a_law_that_is_none) {
  // the event happens in the middle of the input: no rising law fits
  RandomBits bits(3);
  int rejected = 0;
  for (int k = 0; k < 100; ++k) {
    BinaryData data{FragilityLaw::kLogistic, {Column()}, {}};
    for (int i = 0; i < 250; ++i) {
      const double x = bits.uniform();
      data.x[0].push_back(x);
      data.y.push_back(bits.uniform() < (x < 0.3 ? 0.1 : x < 0.6 ? 0.8 : 0.3) ? 1 : 0);
    }
    rejected += BinaryFit(data).fit_p() < 0.05 ? 1 : 0;
  }
  EXPECT_GT(rejected, 95);
}

TEST(Fragility, a_step_has_no_finite_slope) {
  for (const FragilityLaw law : {FragilityLaw::kLogistic, FragilityLaw::kLognormal}) {
    BinaryData data{law, {Column()}, {}};
    for (int i = 0; i < 40; ++i) data.x[0].push_back(i), data.y.push_back(i > 17 ? 1 : 0);
    EXPECT_TRUE(parts(data.x[0], data.y));
    EXPECT_FALSE(BinaryFit(data).is_finite());
    data.y[19] = 0, data.y[17] = 1;  // steep, but the kinds overlap
    EXPECT_FALSE(parts(data.x[0], data.y));
  }
}

// --- indices ---------------------------------------------------------------------------------------

std::vector<Column> uniforms(RandomBits& bits, int inputs, int n) {
  std::vector<Column> x(inputs, Column(n));
  for (Column& column : x) {  // Latin hypercube, as campaigns are drawn
    std::vector<int> stratum(n);
    for (int i = 0; i < n; ++i) stratum[i] = i;
    for (int i = n - 1; i > 0; --i) std::swap(stratum[i], stratum[bits.below(i + 1)]);
    for (int i = 0; i < n; ++i) column[i] = (stratum[i] + bits.uniform()) / n;
  }
  return x;
}

Column ishigami(const std::vector<Column>& u) {
  Column y;
  const auto angle = [](double v) { return (2 * v - 1) * std::numbers::pi; };
  for (std::size_t i = 0; i < u[0].size(); ++i) {
    const double s2 = std::sin(angle(u[1][i]));
    y.push_back(std::sin(angle(u[0][i])) * (1 + 0.1 * std::pow(angle(u[2][i]), 4)) + 7 * s2 * s2);
  }
  return y;
}

TEST(SurrogateIndices, meet_ishigami) {
  RandomBits bits(5);
  const std::vector<Column> u = uniforms(bits, 3, 400);
  const SurrogateIndices of = indices_of(u, ishigami(u));
  ASSERT_EQ(of.verdict, IndexVerdict::kTold);
  EXPECT_GT(of.q2, 0.95);
  const double first[] = {0.3139, 0.4424, 0}, total[] = {0.5576, 0.4424, 0.2437};
  const char* because = "400 samples; what the surrogate does not predict, below 5 %";
  for (int k = 0; k < 3; ++k) {
    const std::string input = "Ishigami by a surrogate, input " + std::to_string(k + 1);
    verify({"first order", input, "-", first[k], 0.03, because, true},
           of.input[k].first_order.value);
    verify({"total", input, "-", total[k], 0.03, because, true}, of.input[k].total.value);
    for (const auto& [index, truth] :
         {std::pair(of.input[k].first_order, first[k]), std::pair(of.input[k].total, total[k])}) {
      EXPECT_LE(index.interval.low, truth) << k;
      EXPECT_GE(index.interval.high, truth) << k;
    }
  }
}

TEST(SurrogateIndices, meet_an_additive_model) {
  // shares 9, 4 and 1 of 14 for slopes 3, 2, 1 of uniform inputs, first order and total alike
  RandomBits bits(6);
  const std::vector<Column> u = uniforms(bits, 4, 100);
  Column y;
  for (int i = 0; i < 100; ++i) y.push_back(3 * u[0][i] + 2 * u[1][i] - u[2][i]);
  const SurrogateIndices of = indices_of(u, y);
  ASSERT_EQ(of.verdict, IndexVerdict::kTold);
  const double share[] = {9 / 14.0, 4 / 14.0, 1 / 14.0, 0};
  for (int k = 0; k < 4; ++k)
    verify({"total", "additive model by a surrogate, input " + std::to_string(k + 1), "-", share[k],
            0.01, "places of a hundred strata instead of their values", true},
           of.input[k].total.value);
}

TEST(SurrogateIndices, are_not_told_of_what_no_polynomial_predicts) {
  RandomBits bits(8);
  const std::vector<Column> u = uniforms(bits, 3, 60);
  EXPECT_EQ(indices_of(u, ishigami(u)).verdict, IndexVerdict::kUnexplained);  // 60 are too few
  Column noise;
  for (int i = 0; i < 60; ++i) noise.push_back(normal(bits));
  EXPECT_EQ(indices_of(u, noise).verdict, IndexVerdict::kUnexplained);
  const std::vector<Column> few = uniforms(bits, 2, 20);
  EXPECT_EQ(indices_of(few, few[0]).verdict, IndexVerdict::kFewSamples);
  std::vector<Column> discrete = u;
  for (double& v : discrete[0]) v = std::floor(3 * v);
  EXPECT_EQ(indices_of(discrete, u[1]).verdict, IndexVerdict::kDiscrete);
}

TEST(Measuring, takes_the_share_of_an_additive_model) {
  // y = a + b + e in equal parts, a and b uniform; and a response that rises and falls
  RandomBits bits(9);
  const int n = 100, campaigns = 150;
  int covered = 0;
  Moments value;
  for (int k = 0; k < campaigns; ++k) {
    Column a, y;
    for (int i = 0; i < n; ++i) {
      a.push_back(bits.uniform());
      y.push_back(std::sqrt(12.0) * (a.back() + bits.uniform()) + normal(bits));
    }
    std::vector<double> replicate;
    const Estimate share = variance_taken(a, y, replicate);
    value.add(share.value);
    covered += share.interval.low <= 1 / 3.0 && 1 / 3.0 <= share.interval.high ? 1 : 0;
  }
  verify({"measuring", "share of the variance that an input takes, mean of 150 campaigns of 100",
          "-", 1 / 3.0, 0.02, "scatter of one is 0.07, of the mean 0.006; three of these", true},
         value.mean());
  verify({"coverage", "interval of that share", "-", 0.95, 0.045,
          "scatter of 150 toy campaigns, 1.8 %, twice, and 1 % of the bootstrap", true},
         static_cast<double>(covered) / campaigns);
}

}  // namespace
}  // namespace wythe::verification::fragility_test
