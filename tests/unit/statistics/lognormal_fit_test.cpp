// The lognormal fit of brackets: against optima from another method, its refusals, and the coverage of its intervals.
#include "statistics/lognormal_fit.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "statistics/bootstrap.h"
#include "statistics/intervals.h"
#include "statistics/scatter.h"

namespace wythe::study::lognormal_fit_test {
namespace {

constexpr double kInf = std::numeric_limits<double>::infinity();

double phi(double z) { return 0.5 * std::erfc(-z / std::sqrt(2.0)); }

// As Baker writes it, without any of the fit's transformations.
double likelihood(const std::vector<Between>& data, double median, double beta) {
  double sum = 0;
  for (const Between& d : data) {
    const double low = d.low > 0 ? phi(std::log(d.low / median) / beta) : 0;
    const double high = std::isinf(d.high) ? 1 : phi(std::log(d.high / median) / beta);
    sum += d.weight * std::log(high - low);
  }
  return sum;
}

struct Optimum {
  double median, beta;
};
// Grids that close in on the best point.
Optimum by_grid(const std::vector<Between>& data, double median, double beta) {
  double best = -kInf, width_m = 1, width_b = 1;
  Optimum at{median, beta};
  for (int round = 0; round < 40; ++round) {
    const Optimum middle = at;
    for (int i = -8; i <= 8; ++i)
      for (int j = -8; j <= 8; ++j) {
        const Optimum p{middle.median * std::exp(width_m * i / 8.0),
                        middle.beta * std::exp(width_b * j / 8.0)};
        const double l = likelihood(data, p.median, p.beta);
        if (l > best) best = l, at = p;
      }
    width_m *= 0.6, width_b *= 0.6;
  }
  return at;
}

std::vector<Between> stripes() {  // 1, 2, 3 m/s^2 ...: reached of 20
  std::vector<Between> data;
  const int reached[] = {0, 2, 7, 11, 16, 19};
  for (int k = 0; k < 6; ++k) {
    data.push_back({0, k + 1.0, static_cast<double>(reached[k])});
    data.push_back({k + 1.0, kInf, static_cast<double>(20 - reached[k])});
  }
  return data;
}

TEST(LognormalFit, stripes_have_the_optimum_of_a_grid) {
  const std::vector<Between> data = stripes();
  const LognormalFit fit(data);
  ASSERT_TRUE(fit.is_told());
  const Optimum grid = by_grid(data, 4, 0.5);
  // a grid sees the maximum to the root of rounding: 1e-8 in L is 1e-5 in the parameters
  EXPECT_NEAR(fit.median() / grid.median, 1, 2e-5);
  EXPECT_NEAR(fit.beta() / grid.beta, 1, 2e-5);
  EXPECT_NEAR(fit.log_likelihood(), likelihood(data, fit.median(), fit.beta()), 1e-9);
  EXPECT_GE(fit.log_likelihood(), likelihood(data, grid.median, grid.beta) - 1e-12);
}

TEST(LognormalFit, brackets_and_cut_off_ones_have_the_optimum_of_a_grid) {
  const std::vector<Between> data = {{1, 1.5}, {1.5, 2}, {2, 3},    {2.5, 3},
                                     {3, 3.5}, {0, 1},   {4, kInf}, {4, kInf}};
  const LognormalFit fit(data);
  ASSERT_TRUE(fit.is_told());
  const Optimum grid = by_grid(data, 2, 0.5);
  EXPECT_NEAR(fit.median() / grid.median, 1, 2e-5);
  EXPECT_NEAR(fit.beta() / grid.beta, 1, 2e-5);
}

// Brackets as narrow as rounding allows are values: then the fit is the mean of their logarithms and their
// standard deviation with divisor n.
TEST(LognormalFit, narrow_brackets_give_moments_of_the_logarithms) {
  std::vector<Between> data;
  Moments moments;
  for (const double x : {1.1, 1.7, 2.0, 2.6, 3.9, 4.4}) {
    data.push_back({x * (1 - 1e-6), x * (1 + 1e-6)});
    moments.add(std::log(x));
  }
  const LognormalFit fit(data);
  EXPECT_NEAR(std::log(fit.median()), moments.mean(), 1e-6);
  EXPECT_NEAR(fit.beta(), moments.standard_deviation() * std::sqrt(5.0 / 6.0), 1e-6);
}

// Half of them cut off: Baker's equation for truncated analyses, density times probability beyond.
TEST(LognormalFit, values_and_cut_off_ones_maximise_bakers_equation) {
  const std::vector<double> values = {1.1, 1.7, 2.0, 2.6};
  std::vector<Between> data = {{3, kInf, 3}};
  for (const double x : values) data.push_back({x * (1 - 1e-7), x * (1 + 1e-7)});
  const LognormalFit fit(data);
  const auto baker = [&](double median, double beta) {
    double sum = 3 * std::log(1 - phi(std::log(3 / median) / beta));
    for (const double x : values)
      sum += -0.5 * std::pow(std::log(x / median) / beta, 2) - std::log(beta);
    return sum;
  };
  const double best = baker(fit.median(), fit.beta());
  for (const double m : {0.999, 1.001})
    for (const double b : {0.999, 1.0, 1.001})
      EXPECT_LT(baker(fit.median() * m, fit.beta() * b), best);
  for (const double b : {0.999, 1.001}) EXPECT_LT(baker(fit.median(), fit.beta() * b), best);
}

TEST(LognormalFit, order_and_splitting_change_no_bit) {
  std::vector<Between> data = stripes();
  const LognormalFit fit(data);
  std::reverse(data.begin(), data.end());
  data.push_back({3, kInf, 4});
  for (Between& d : data)
    if (d.low == 3 && d.weight == 13) d.weight = 9;
  const LognormalFit other(data);
  EXPECT_EQ(fit.median(), other.median());
  EXPECT_EQ(fit.beta(), other.beta());
  EXPECT_EQ(fit.profile_beta().low, other.profile_beta().low);
}

TEST(LognormalFit, units_scale_the_median_alone) {
  std::vector<Between> data = stripes();
  const LognormalFit fit(data);
  for (Between& d : data) d.low *= 9.81, d.high *= 9.81;
  const LognormalFit other(data);
  EXPECT_NEAR(other.median() / fit.median(), 9.81, 1e-9);
  EXPECT_NEAR(other.beta(), fit.beta(), 1e-10);
}

TEST(LognormalFit, nothing_is_told_of_what_does_not_identify_it) {
  const auto verdict = [](std::vector<Between> data) {
    return LognormalFit(std::move(data)).verdict();
  };
  using V = LimitStateVerdict;
  EXPECT_EQ(verdict({}), V::kNever);
  EXPECT_EQ(verdict({{2, kInf, 9}, {3, kInf, 2}}), V::kNever);
  EXPECT_EQ(verdict({{0, 2, 9}, {0, 3, 2}}), V::kAlways);
  // all that reached it did at 3 or below, all others at 2 or above were not: any median between does
  EXPECT_EQ(verdict({{0, 3, 5}, {2, kInf, 5}}), V::kSeparated);
  EXPECT_EQ(verdict({{0, 3, 5}, {3, kInf, 5}}), V::kSeparated);
  EXPECT_EQ(verdict({{2, 3, 11}}), V::kSeparated);
  EXPECT_EQ(verdict({{1, 2, 4}, {2, 3, 4}}), V::kSeparated);
  // as often at 1 as at 4, or more often at 1
  EXPECT_EQ(verdict({{0, 1, 5}, {1, kInf, 5}, {0, 4, 5}, {4, kInf, 5}}), V::kNoTrend);
  EXPECT_EQ(verdict({{0, 1, 8}, {1, kInf, 2}, {0, 4, 2}, {4, kInf, 8}}), V::kNoTrend);
  EXPECT_EQ(verdict({{0, 1, 10}, {4, kInf, 10}}), V::kNoTrend);
  EXPECT_TRUE(std::isnan(LognormalFit({{2, kInf, 9}}).median()));
}

// A slope that the samples hardly show has no end on one side.
TEST(LognormalFit, an_interval_that_is_not_bounded_says_so) {
  const LognormalFit fit({{0, 1, 4}, {1, kInf, 6}, {0, 4, 5}, {4, kInf, 5}});
  ASSERT_TRUE(fit.is_told());
  EXPECT_TRUE(std::isinf(fit.profile_beta().high));
  EXPECT_GT(fit.profile_beta().low, 0);
}

// At the ends of the profile interval the best likelihood is 1.92 below the maximum; found by the grid.
TEST(LognormalFit, profile_ends_lie_where_the_likelihood_has_fallen) {
  const std::vector<Between> data = stripes();
  const LognormalFit fit(data);
  const Interval median = fit.profile_median();
  for (const double end : {median.low, median.high}) {
    double best = -kInf;
    for (double beta = 0.05; beta < 5; beta *= 1.0005)
      best = std::max(best, likelihood(data, end, beta));
    EXPECT_NEAR(2 * (fit.log_likelihood() - best), 3.8414588, 1e-4);
  }
  const Interval beta = fit.profile_beta();
  for (const double end : {beta.low, beta.high}) {
    double best = -kInf;
    for (double m = 0.5; m < 30; m *= 1.0005) best = std::max(best, likelihood(data, m, end));
    EXPECT_NEAR(2 * (fit.log_likelihood() - best), 3.8414588, 1e-4);
  }
}

// 200 incremental analyses of 20 records with steps of 0.5 around a median of 3, beta 0.4. The bounds are three
// standard errors of a share of 95 % in 200, 0.046, and what likelihood intervals miss with 20 records.
TEST(LognormalFit, intervals_hold_the_truth_as_often_as_they_say) {
  RandomBits bits(7);
  int median = 0, beta = 0;
  constexpr int kTrials = 200;
  for (int k = 0; k < kTrials; ++k) {
    std::vector<Between> data;
    for (int i = 0; i < 20; ++i) {
      const double x = 3 * std::exp(0.4 * normal_quantile(bits.uniform()));
      const double low = 0.5 * std::floor(std::min(x, 8.0) / 0.5);
      data.push_back({low, x > 8 ? kInf : low + 0.5});
    }
    const LognormalFit fit(data);
    const Interval m = fit.profile_median(), b = fit.profile_beta();
    median += m.low <= 3 && 3 <= m.high ? 1 : 0;
    beta += b.low <= 0.4 && 0.4 <= b.high ? 1 : 0;
  }
  EXPECT_NEAR(median, 0.95 * kTrials, 0.05 * kTrials);
  EXPECT_NEAR(beta, 0.94 * kTrials, 0.05 * kTrials);
}

// --- scatter ----------------------------------------------------------------------------------------

TEST(Scatter, quantiles_are_those_of_tables) {
  EXPECT_NEAR(f_quantile_beyond(0.05, 3, 20), 3.0984, 5e-5);
  EXPECT_NEAR(f_quantile_beyond(0.025, 10, 10), 3.7168, 5e-5);
  EXPECT_NEAR(f_quantile_beyond(0.975, 10, 10), 1 / 3.71679, 5e-5);
  EXPECT_NEAR(chi_square_quantile_beyond(0.05, 9), 16.9190, 5e-5);
  EXPECT_NEAR(chi_square_quantile_beyond(0.975, 4), 0.48442, 5e-5);
}

// A layout whose mean squares are known by hand: effects of 0, 3 and 0, 1 and 0, 2 make MS_R = 9, ...
TEST(Scatter, a_layout_without_interaction_has_none) {
  std::vector<Cell> cells;
  for (int r = 0; r < 3; ++r)
    for (int w = 0; w < 4; ++w) cells.push_back({r, w, 2.0 * r + 0.5 * w});
  const Scatter s = scatter_of(cells, 0);
  ASSERT_EQ(s.verdict, ScatterVerdict::kTold);
  EXPECT_NEAR(s.record.value, 2, 1e-12);                       // variance of 0, 2, 4
  EXPECT_NEAR(s.wall.value, 0.5 * std::sqrt(5.0 / 3), 1e-12);  // of 0, 0.5, 1, 1.5
  EXPECT_NEAR(s.rest.value, 0, 1e-12);
}

TEST(Scatter, refuses_what_does_not_tell_them_apart) {
  std::vector<Cell> cells;
  for (int r = 0; r < 4; ++r)
    for (int w = 0; w < 4; ++w) cells.push_back({r, w, 0.1 * r * w + r});
  EXPECT_EQ(scatter_of(cells, 0).verdict, ScatterVerdict::kTold);
  EXPECT_EQ(scatter_of(cells, 10).verdict, ScatterVerdict::kWide);
  std::vector<Cell> holes = cells;
  holes.pop_back();
  EXPECT_EQ(scatter_of(holes, 0).verdict, ScatterVerdict::kNotCrossed);
  holes = cells;
  holes[5].value = kUnset;
  EXPECT_EQ(scatter_of(holes, 0).verdict, ScatterVerdict::kNotReached);
  std::erase_if(cells, [](const Cell& c) { return c.wall > 1; });
  EXPECT_EQ(scatter_of(cells, 0).verdict, ScatterVerdict::kOneKind);
}

// 300 layouts of 12 records and 6 walls. Three standard errors of a share of 95 % are 0.038.
TEST(Scatter, intervals_hold_the_truth_as_often_as_they_say) {
  RandomBits bits(11);
  constexpr int kTrials = 300;
  int record = 0, wall = 0, rest = 0;
  const auto holds = [](const Estimate& e, double truth) {
    return e.interval.low <= truth && truth <= e.interval.high ? 1 : 0;
  };
  for (int k = 0; k < kTrials; ++k) {
    std::vector<double> of_record(12), of_wall(6);
    for (double& r : of_record) r = 0.4 * normal_quantile(bits.uniform());
    for (double& w : of_wall) w = 0.15 * normal_quantile(bits.uniform());
    std::vector<Cell> cells;
    for (int r = 0; r < 12; ++r)
      for (int w = 0; w < 6; ++w)
        cells.push_back({r, w, of_record[r] + of_wall[w] + 0.1 * normal_quantile(bits.uniform())});
    const Scatter s = scatter_of(cells, 0);
    record += holds(s.record, 0.4), wall += holds(s.wall, 0.15), rest += holds(s.rest, 0.1);
  }
  for (const int held : {record, wall, rest}) EXPECT_NEAR(held, 0.95 * kTrials, 0.038 * kTrials);
}

}  // namespace
}  // namespace wythe::study::lognormal_fit_test
