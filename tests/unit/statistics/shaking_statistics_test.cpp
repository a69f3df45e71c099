// Statistics of samples under records, from artificial campaigns: brackets, counts, shakes that do not count.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "statistics/bootstrap.h"
#include "statistics/intervals.h"
#include "wythe/parts/io.h"
#include "wythe/parts/statistics.h"

namespace wythe::shaking_statistics_test {
namespace {

ShakeResult answer(double intensity, double capacity, double drift = 0.01) {
  ShakeResult a;
  a.intensity = intensity;
  a.collapsed = intensity >= capacity;
  a.status = a.collapsed ? "collapsed" : "completed";
  a.gap_ratio = 0;
  a.peak_drift = a.collapsed ? 1 : drift * intensity;
  a.residual_drift = a.peak_displacement = a.residual_displacement = a.uplift = a.slip = 0;
  return a;
}

struct Made {
  int records = 10, walls = 1;
  double sigma_record = 0.4, sigma_wall = 0, sigma_rest = 0;
  std::vector<double> levels = {1, 1.5, 2, 2.5, 3, 3.5, 4, 5, 6, 8, 11, 15};
  std::uint64_t seed = 3;
};

// Every wall under every record, with a capacity of median 3; record k is called by `name`.
Campaign made(const Made& m, const std::function<std::string(int)>& name = {}) {
  Campaign c;
  ShakingSpec& s = c.study.shaking;
  s.stage = "quake";
  s.levels = m.levels;
  s.limit_state = {{.name = "overturning", .collapse = true}};
  c.study.batch = {m.walls};
  study::RandomBits bits(m.seed);
  std::vector<double> of_record, of_wall;
  for (int r = 0; r < m.records; ++r) {
    of_record.push_back(m.sigma_record * study::normal_quantile(bits.uniform()));
    s.record.push_back({name ? name(r) : std::string(1, static_cast<char>('a' + r)), "[]", {}});
  }
  for (int w = 0; w < m.walls; ++w)
    of_wall.push_back(m.sigma_wall * study::normal_quantile(bits.uniform()));
  for (int w = 0; w < m.walls; ++w)
    for (int r = 0; r < m.records; ++r) {
      SampleRecord record;
      record.sample = 1 + w * m.records + r;
      record.status = "completed";
      const double capacity = 3 * std::exp(of_record[r] + of_wall[w] +
                                           m.sigma_rest * study::normal_quantile(bits.uniform()));
      for (const double x : m.levels) record.shakes.push_back(answer(x, capacity));
      c.records.push_back(record);
      c.samples.value.push_back({});
    }
  return c;
}

const LimitStateFragility& first(const ShakingStatistics& s) { return s.fragility.at(0); }

TEST(ShakingStatistics, records_alone_are_told_by_profile_likelihood) {
  const ShakingStatistics s = shaking_statistics(made({.records = 16}));
  const LimitStateFragility& f = first(s);
  EXPECT_EQ(s.records, 16);
  EXPECT_EQ(s.walls, 1);
  EXPECT_EQ(s.shakes, 16 * 12);
  ASSERT_EQ(f.verdict, LimitStateVerdict::kTold);
  EXPECT_FALSE(f.by_bootstrap);
  EXPECT_LT(f.median.interval.low, f.median.value);
  EXPECT_GT(f.median.interval.high, f.median.value);
  EXPECT_EQ(f.bracket.size(), 16U);
  for (const Bracket& b : f.bracket) EXPECT_LT(b.low, b.high);
  // with the same records at each level the counts have the same marginal law: the two medians agree closely
  EXPECT_NEAR(f.count_median / f.median.value, 1, 0.05);
  ASSERT_EQ(f.count.size(), 12U);
  for (const LimitStateCount& count : f.count) EXPECT_EQ(count.n, 16);
}

// One level a record: brackets are outcomes, and the fit is the binomial one of Baker's equation 11.
// Copies of a motion under other names bring no knowledge: walls end under them in the same states.
TEST(ShakingStatistics, copies_of_a_record_count_once) {
  Campaign c = made({.records = 10});
  for (SampleRecord& record : c.records)
    for (ShakeResult& shake : record.shakes)
      shake.state_hash = std::to_string(record.sample % 2) + "@" + std::to_string(shake.intensity);
  EXPECT_EQ(first(shaking_statistics(c)).verdict, LimitStateVerdict::kFewRecords);
  for (SampleRecord& record : c.records)
    for (ShakeResult& shake : record.shakes)
      shake.state_hash = std::to_string(record.sample) + "@" + std::to_string(shake.intensity);
  EXPECT_EQ(first(shaking_statistics(c)).verdict, LimitStateVerdict::kTold);
}

TEST(ShakingStatistics, stripes_of_their_own_records_are_the_binomial_fit) {
  Campaign c = made({.records = 24, .levels = {1}});
  study::RandomBits bits(5);
  c.study.shaking.levels.clear();
  for (int r = 0; r < 24; ++r) {
    const double level = 1.5 + r % 4;
    c.study.shaking.record[r].levels = {level};
    c.records[r].shakes = {
        answer(level, 3 * std::exp(0.4 * study::normal_quantile(bits.uniform())))};
  }
  const LimitStateFragility f = first(shaking_statistics(c));
  ASSERT_EQ(f.verdict, LimitStateVerdict::kTold);
  EXPECT_EQ(f.median.value, f.count_median);
  EXPECT_EQ(f.beta.value, f.count_beta);
}

TEST(ShakingStatistics, several_walls_are_told_by_a_bootstrap_over_both) {
  const LimitStateFragility one = first(shaking_statistics(made({.records = 16, .walls = 1})));
  const LimitStateFragility many = first(shaking_statistics(made({.records = 16, .walls = 8})));
  ASSERT_TRUE(many.by_bootstrap);
  // eight equal walls are no eightfold knowledge of the records: the interval stays as wide
  const auto width = [](const Estimate& e) { return std::log(e.interval.high / e.interval.low); };
  EXPECT_NEAR(width(many.median) / width(one.median), 1, 0.2);
}

TEST(ShakingStatistics, order_of_records_and_samples_changes_no_bit) {
  const Made m{.records = 9, .walls = 4, .sigma_wall = 0.15, .sigma_rest = 0.1};
  const Campaign a = made(m);
  Campaign b = a;
  // the same with the records in another order: place r goes to p
  const int places[] = {4, 8, 0, 2, 6, 1, 7, 3, 5};
  for (int r = 0; r < 9; ++r) b.study.shaking.record[places[r]] = a.study.shaking.record[r];
  for (SampleRecord& record : b.records) {
    const int w = (record.sample - 1) / 9, r = (record.sample - 1) % 9;
    record.sample = 1 + w * 9 + places[r];
  }
  std::sort(b.records.begin(), b.records.end(),
            [](const SampleRecord& x, const SampleRecord& y) { return x.sample < y.sample; });
  const LimitStateFragility x = first(shaking_statistics(a)), y = first(shaking_statistics(b));
  ASSERT_EQ(x.verdict, LimitStateVerdict::kTold);
  EXPECT_EQ(x.median.value, y.median.value);
  EXPECT_EQ(x.median.interval.low, y.median.interval.low);
  EXPECT_EQ(x.beta.interval.high, y.beta.interval.high);
  EXPECT_EQ(x.scatter.record.value, y.scatter.record.value);
  EXPECT_EQ(x.scatter.wall.interval.high, y.scatter.wall.interval.high);
  ASSERT_EQ(x.curve.size(), y.curve.size());
  for (std::size_t i = 0; i < x.curve.size(); ++i)
    EXPECT_EQ(x.curve[i].probability.interval.low, y.curve[i].probability.interval.low);
}

TEST(ShakingStatistics, scatter_of_records_and_walls_is_found_again) {
  // closer levels: the brackets are narrow beside what both do together
  std::vector<double> levels;
  for (double x = 0.3; x < 40; x *= 1.04) levels.push_back(x);
  const LimitStateFragility f = first(shaking_statistics(made({.records = 20,
                                                               .walls = 12,
                                                               .sigma_wall = 0.2,
                                                               .sigma_rest = 0.1,
                                                               .levels = levels,
                                                               .seed = 11})));
  ASSERT_EQ(f.scatter.verdict, ScatterVerdict::kTold);
  EXPECT_LT(f.scatter.record.interval.low, 0.4);
  EXPECT_GT(f.scatter.record.interval.high, 0.4);
  EXPECT_LT(f.scatter.wall.interval.low, 0.2);
  EXPECT_GT(f.scatter.wall.interval.high, 0.2);
  EXPECT_NEAR(f.scatter.rest.value, 0.1, 0.015);
  EXPECT_NEAR(f.scatter.bracket, std::log(1.04) / std::sqrt(12.0), 1e-6);
}

TEST(ShakingStatistics, scatter_is_refused_where_brackets_hide_it) {
  const LimitStateFragility f = first(shaking_statistics(
      made({.records = 8, .walls = 6, .sigma_wall = 0.01, .levels = {0.5, 1, 2, 4, 8, 16}})));
  EXPECT_EQ(f.scatter.verdict, ScatterVerdict::kWide);
  const LimitStateFragility cut = first(
      shaking_statistics(made({.records = 8, .walls = 6, .sigma_wall = 0.2, .levels = {1, 2, 3}})));
  EXPECT_EQ(cut.scatter.verdict, ScatterVerdict::kNotReached);
}

// --- what does not count ------------------------------------------------------------------------------

TEST(ShakingStatistics, lost_shakes_are_neither_stood_nor_fallen) {
  Campaign c = made({.records = 10});
  const LimitStateFragility whole = first(shaking_statistics(c));
  // record a: the shake below its collapse is lost, so its bracket grows; nothing is assumed
  std::vector<ShakeResult>& shakes = c.records[0].shakes;
  const auto fell =
      std::find_if(shakes.begin(), shakes.end(), [](const auto& s) { return s.collapsed; });
  ASSERT_TRUE(fell - shakes.begin() >= 2);
  (fell - 1)->status = "unstable";
  const ShakingStatistics s = shaking_statistics(c);
  ASSERT_EQ(s.lost.size(), 1U);
  EXPECT_EQ(s.lost[0].sample, 1);
  EXPECT_EQ(s.lost[0].status, "unstable");
  EXPECT_EQ(s.stood + s.collapsed, s.shakes - 1);
  EXPECT_TRUE(first(s).bracket[0].is_known);
  EXPECT_EQ(first(s).bracket[0].low, (fell - 2)->intensity);
  EXPECT_EQ(first(s).bracket[0].high, whole.bracket[0].high);
}

TEST(ShakingStatistics, a_sample_whose_deciding_shakes_are_lost_is_left_out_and_bounded) {
  Campaign c = made({.records = 10});
  const LimitStateFragility whole = first(shaking_statistics(c));
  for (ShakeResult& shake : c.records[2].shakes)
    if (shake.collapsed) shake.gap_ratio = 0.5, shake.status = "completed", shake.collapsed = false;
  const LimitStateFragility f = first(shaking_statistics(c));
  EXPECT_EQ(f.n, 9);
  EXPECT_EQ(f.lost, 1);
  EXPECT_FALSE(f.bracket[2].is_known);
  ASSERT_EQ(f.verdict, LimitStateVerdict::kTold);
  // it had reached it at the first that is lost, so that one extreme is the truth
  EXPECT_EQ(f.median_if_reached, whole.median.value);
  EXPECT_GT(f.median_if_not, f.median_if_reached);
  for (const LimitStateCount& count : f.count) EXPECT_EQ(count.n + count.lost, 10);
}

TEST(ShakingStatistics, a_limit_state_that_comes_back_counts_at_its_lowest) {
  Campaign c = made({.records = 10});
  const auto strong = std::find_if(c.records.begin(), c.records.end(),
                                   [](const SampleRecord& r) { return !r.shakes[4].collapsed; });
  ASSERT_NE(strong, c.records.end());
  std::vector<ShakeResult>& shakes = strong->shakes;
  shakes[2] = answer(shakes[2].intensity, 0);  // falls early, and stands again
  const LimitStateFragility f = first(shaking_statistics(c));
  const Bracket& bracket = f.bracket.at(strong->sample - 1);
  EXPECT_TRUE(bracket.came_back);
  EXPECT_EQ(f.came_back, 1);
  EXPECT_EQ(bracket.high, shakes[2].intensity);
  EXPECT_EQ(bracket.low, shakes[1].intensity);
}

TEST(ShakingStatistics, tells_nothing_where_nothing_is_known) {
  using V = LimitStateVerdict;
  const auto verdict = [](const Campaign& c) { return first(shaking_statistics(c)).verdict; };
  EXPECT_EQ(verdict(made({.records = 6})), V::kFewRecords);
  EXPECT_EQ(verdict(made({.records = 6, .walls = 50})), V::kFewRecords);
  EXPECT_EQ(verdict(made({.levels = {0.1, 0.2}})), V::kNever);
  EXPECT_EQ(verdict(made({.levels = {50, 60}})), V::kAlways);
  EXPECT_EQ(verdict(made({.levels = {0.1, 50}})), V::kSeparated);
  EXPECT_EQ(verdict(made({.levels = {3}})), V::kSeparated);
  Campaign lost = made({});
  for (SampleRecord& r : lost.records)
    for (ShakeResult& s : r.shakes) s.status = "unstable";
  EXPECT_EQ(verdict(lost), V::kFewRecords);
  EXPECT_TRUE(std::isnan(first(shaking_statistics(lost)).median.value));
  Campaign none = made({});
  none.records.clear();
  EXPECT_FALSE(shaking_statistics(none).is_told());
  for (const Made& m : {Made{.records = 6}, Made{.levels = {0.1, 50}}, Made{.walls = 3}})
    EXPECT_FALSE(statistics_json(statistics_of(made(m))).empty());
}

TEST(ShakingStatistics, limits_are_reached_by_any_of_them_and_by_collapse) {
  const LimitStateSpec drift{.name = "d", .peak_drift = 0.02, .slip = 5e-3};
  ShakeResult a = answer(1, 10, 0.0199);
  EXPECT_FALSE(reaches(drift, a));
  a.slip = 5e-3;
  EXPECT_TRUE(reaches(drift, a));
  EXPECT_TRUE(reaches(drift, answer(1, 10, 0.02)));
  EXPECT_TRUE(reaches(drift, answer(10, 10)));
  EXPECT_FALSE(reaches({.name = "c", .collapse = true}, a));
}

TEST(ShakingStatistics, half_of_the_samples_collapsed_have_no_median_drift) {
  const ShakingStatistics s = shaking_statistics(made({.records = 10}));
  for (const IntensitySummary& i : s.intensity) {
    EXPECT_EQ(i.n, 10);
    if (i.collapsed == 0) {
      EXPECT_NEAR(i.drift_50, 0.01 * i.intensity, 1e-12);
    } else if (i.collapsed > 5) {
      EXPECT_TRUE(std::isinf(i.drift_50));
    }
  }
}

// 60 campaigns of few records and walls with scatter of both: the intervals hold the truth about as often as they say.
// Three standard errors of a share of 92 % in 60 are 0.105. Percentiles of a bootstrap hold beta in 75 % of them.
TEST(ShakingStatistics, the_bootstrap_of_both_holds_median_and_dispersion) {
  int held = 0, held_beta = 0;
  for (int k = 0; k < 60; ++k) {
    const LimitStateFragility f =
        first(shaking_statistics(made({.records = 16,
                                       .walls = 6,
                                       .sigma_wall = 0.2,
                                       .sigma_rest = 0.1,
                                       .seed = 100U + static_cast<unsigned>(k)})));
    ASSERT_EQ(f.verdict, LimitStateVerdict::kTold);
    held += f.median.interval.low <= 3 && 3 <= f.median.interval.high ? 1 : 0;
    const double beta = std::sqrt(0.4 * 0.4 + 0.2 * 0.2 + 0.1 * 0.1);
    held_beta += f.beta.interval.low <= beta && beta <= f.beta.interval.high ? 1 : 0;
  }
  EXPECT_GE(held, 50);
  EXPECT_GE(held_beta, 50);
}

}  // namespace
}  // namespace wythe::shaking_statistics_test
