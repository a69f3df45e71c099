// Relations of inputs and responses: ranks, also with lower bounds, partial correlations, bins.
#include "statistics/correlation.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "statistics/bootstrap.h"

namespace wythe::study::correlation_test {
namespace {

TEST(Correlation, ranks_share_ties) {
  EXPECT_EQ(ranks({30, 10, 20, 20}), (Column{4, 1, 2.5, 2.5}));
}

TEST(Correlation, spearman_sees_any_rising_curve_as_one) {
  Column x, y;
  for (int i = 0; i < 20; ++i) x.push_back(i), y.push_back(std::exp(i));
  const Correlation c = correlate({x}, observed(y)).front();
  EXPECT_DOUBLE_EQ(c.spearman.value, 1);
  EXPECT_LT(c.pearson.value, 0.8);
}

TEST(Correlation, spearman_by_hand) {
  // ranks differ by 1, -1, 0, 1, -1: 1 - 6 * 4 / (5 * 24)
  const Correlation c = correlate({{1, 2, 3, 4, 5}}, observed({2, 1, 3, 5, 4})).front();
  EXPECT_NEAR(c.spearman.value, 0.8, 1e-14);
}

TEST(Correlation, a_lower_bound_has_the_mean_of_the_ranks_it_can_have) {
  // 1, then a bound at 2 that is 3, 4 or beyond, then 3 and 4: the bound is anywhere from 2 to 4
  const Column by_hand = ranks({{1, false}, {2, true}, {3, false}, {4, false}});
  EXPECT_EQ(by_hand, (Column{1, 3, 2.25, 3.75}));
  const Column ends = ranks({{50.02, true}, {7, false}, {49.98, true}, {9, false}, {50, true}});
  EXPECT_EQ(ends, (Column{4, 1, 4, 2, 4})) << "where a push ended says nothing";
  EXPECT_EQ(ranks(observed({30, 10, 20, 20})), ranks(Column{30, 10, 20, 20}));
}

// Four pushes in five end before the response, within 0.02 mm of each other and earlier where an idle
// input is large: as recorded, the order of the ends was a rank correlation of 0.5.
TEST(Correlation, of_an_idle_input_with_where_pushes_end_is_none) {
  constexpr int kSamples = 400;
  Column strong, idle;
  std::vector<Reading> response;
  Column as_recorded;
  for (int i = 0; i < kSamples; ++i) {
    strong.push_back(std::fmod(0.6180339887 * i, 1.0)),
        idle.push_back(std::fmod(0.7548776662 * i, 1.0));
    const bool censored = strong.back() > 0.2;
    response.push_back({censored ? 50 + 0.02 * idle.back() : 200 * strong.back(), censored});
    as_recorded.push_back(response.back().value);
  }
  EXPECT_GT(pearson(ranks(idle), ranks(as_recorded)), 0.45);
  const std::vector<Correlation> c = correlate({strong, idle}, response);
  EXPECT_NEAR(c[1].spearman.value, 0, 0.1);
  EXPECT_NEAR(c[1].partial_rank.value, 0, 0.1);
  // a rising response of which a share p is cut off at one place: sqrt(1 - p^3)
  EXPECT_NEAR(c[0].spearman.value, std::sqrt(1 - std::pow(0.8, 3)), 0.02);
  EXPECT_GT(c[0].partial_rank.value, 0.6);
}

TEST(Correlation, partial_follows_the_formula_of_three) {
  const Column a = {1, 2, 3, 4, 5, 6}, b = {2, 1, 4, 3, 6, 5}, y = {1, 3, 2, 6, 4, 5};
  const double ay = pearson(a, y), by = pearson(b, y), ab = pearson(a, b);
  const double expected = (ay - ab * by) / std::sqrt((1 - ab * ab) * (1 - by * by));
  EXPECT_NEAR(partial_correlations({a, b}, y)[0], expected, 1e-13);
}

TEST(Correlation, partial_finds_a_weak_input_behind_a_strong_one) {
  // y = 10 a + b exactly: given the other, each decides alone
  Column a, b, y;
  RandomBits bits(3);
  for (int i = 0; i < 200; ++i) {
    a.push_back(bits.uniform()), b.push_back(bits.uniform());
    y.push_back(10 * a.back() + b.back());
  }
  EXPECT_LT(pearson(b, y), 0.25);
  EXPECT_NEAR(partial_correlations({a, b}, y)[0], 1, 1e-9);
  EXPECT_NEAR(partial_correlations({a, b}, y)[1], 1, 1e-9);
}

TEST(Correlation, a_column_that_follows_from_another_has_no_partial) {
  EXPECT_TRUE(std::isnan(partial_correlations({{1, 2, 3, 4}, {2, 4, 6, 8}}, {1, 3, 2, 4})[0]));
}

TEST(FirstOrder, bins_hold_equal_counts) {
  const std::vector<int> bin = equal_bins({5, 1, 4, 2, 3, 6}, 3);
  EXPECT_EQ(bin, (std::vector<int>{2, 0, 1, 0, 1, 2}));
}

}  // namespace
}  // namespace wythe::study::correlation_test
