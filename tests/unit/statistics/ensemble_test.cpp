// A few walls of one model: medians by order statistics.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>

#include "wythe/parts/statistics.h"

namespace wythe::ensemble_test {
namespace {

TEST(OfWalls, the_interval_of_a_median_is_that_of_the_binomial) {
  // David and Nagaraja: of 8 the smallest and the largest hold it with 1 - 2/256, the next ones with 1 - 18/256
  const auto ordered = [](int n) {
    std::vector<Reading> readings;
    for (int i = 1; i <= n; ++i) readings.push_back({static_cast<double>(i), false});
    return of_walls(readings).median;
  };
  EXPECT_TRUE(std::isnan(ordered(5).interval.low));
  EXPECT_EQ(ordered(6).interval.low, 1);
  EXPECT_EQ(ordered(8).interval.low, 1);
  EXPECT_EQ(ordered(8).interval.high, 8);
  EXPECT_EQ(ordered(9).interval.low, 2);   // 1 - 20/512 = 0.961
  EXPECT_EQ(ordered(20).interval.low, 6);  // tables: 6th and 15th
  EXPECT_EQ(ordered(20).interval.high, 15);
  EXPECT_EQ(ordered(8).value, 4.5);
  EXPECT_EQ(ordered(9).value, 5);
}

TEST(OfWalls, it_holds_the_median_of_any_distribution_as_often_as_it_says) {
  // median of exp(u) is exp(1/2) of u uniform: 4000 ensembles of 8, of which 1 - 2/256 hold it
  std::uint64_t state = 1;
  const auto uniform = [&] {
    state = state * 6364136223846793005ULL + 1442695040888963407ULL;
    return static_cast<double>(state >> 11) / 9007199254740992.0;
  };
  int held = 0;
  for (int k = 0; k < 4000; ++k) {
    std::vector<Reading> readings;
    for (int i = 0; i < 8; ++i) readings.push_back({std::exp(uniform()), false});
    const Interval interval = of_walls(readings).median.interval;
    held += interval.low <= std::exp(0.5) && std::exp(0.5) <= interval.high ? 1 : 0;
  }
  EXPECT_NEAR(held / 4000.0, 1 - 2.0 / 256, 0.006);  // four standard deviations
}

TEST(OfWalls, bounds_count_as_bounds) {
  // three of eight reach farther than the push, at 30
  std::vector<Reading> readings = {{10, false}, {12, false}, {14, false}, {16, false},
                                   {18, false}, {30, true},  {30, true},  {30, true}};
  OfWalls of = of_walls(readings);
  EXPECT_EQ(of.bounds, 3);
  EXPECT_EQ(of.median.value, 17);
  EXPECT_EQ(of.median.interval.low, 10);
  EXPECT_TRUE(std::isinf(of.median.interval.high));
  EXPECT_EQ(of.largest, 18);
  EXPECT_TRUE(std::isnan(of.log_scatter));
  // with five the median itself is not reached
  readings[3].censored = readings[4].censored = true;
  EXPECT_TRUE(std::isinf(of_walls(readings).median.value));
  EXPECT_EQ(of_walls(readings).at_least, 17);
  // a bound below the middle may stand above it, so the middle is not known
  const OfWalls low = of_walls({{10, false}, {12, true}, {14, false}, {16, false}, {18, false}});
  EXPECT_TRUE(std::isinf(low.median.value));
  EXPECT_EQ(low.at_least, 14);
  // a wall without a number is not counted
  EXPECT_EQ(of_walls({{1, false}, {}}).n, 1);
}

}  // namespace
}  // namespace wythe::ensemble_test
