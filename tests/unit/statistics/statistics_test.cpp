// Statistics of a campaign: values by hand, groups, the stop rule, unusual campaigns.
#include "wythe/parts/statistics.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <stdexcept>
#include <string>
#include <vector>

#include "scenes/sample_campaign.h"
#include "statistics/bootstrap.h"
#include "statistics/intervals.h"
#include "statistics/survival.h"
#include "wythe/parts/error.h"
#include "wythe/parts/io.h"
#include "wythe/parts/report.h"

namespace wythe::statistics_test {
namespace {

using namespace study;
using scenes::sample_campaign;
using scenes::sample_record;

const Share& share_named(const Statistics& s, const std::string& name) {
  for (const Share& share : s.share)
    if (share.name == name) return share;
  throw std::runtime_error("no share " + name);
}
const GroupSummary& group_named(const Statistics& s, const std::string& name) {
  for (const GroupSummary& group : s.group)
    if (group.name == name) return group;
  throw std::runtime_error("no group " + name);
}
Campaign of_records(std::vector<SampleRecord> records) {
  Campaign campaign;
  campaign.records = std::move(records);
  return campaign;
}
int count(const std::string& text, const std::string& part) {
  int n = 0;
  for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) ++n;
  return n;
}

// --- intervals ---------------------------------------------------------------------------------

TEST(Wilson, meets_published_values) {
  // Newcombe, Stat. Med. 17 (1998), table I, method 3: printed to four digits
  const auto near = [](int k, int n, double low, double high) {
    const Interval i = wilson(k, n).interval;
    EXPECT_NEAR(i.low, low, 5e-5) << k << "/" << n;
    EXPECT_NEAR(i.high, high, 5e-5) << k << "/" << n;
  };
  near(81, 263, 0.2553, 0.3662);
  near(15, 148, 0.0624, 0.1605);
  near(0, 20, 0.0, 0.1611);
  near(1, 29, 0.0061, 0.1718);
}

TEST(Wilson, eight_percent_of_250_is_five_to_twelve) {
  const Interval i = wilson(20, 250).interval;  // physics of the paper's FM-5 share
  EXPECT_NEAR(i.low, 0.0525, 5e-4);
  EXPECT_NEAR(i.high, 0.1203, 5e-4);
}

TEST(Wilson, none_and_all_reach_the_ends_exactly) {
  EXPECT_EQ(wilson(0, 30).interval.low, 0);
  EXPECT_EQ(wilson(30, 30).interval.high, 1);
  EXPECT_EQ(wilson(0, 0).interval.width(), 1);
}

TEST(Quantiles, normal_and_student_meet_tables) {
  EXPECT_NEAR(normal_quantile(0.975), 1.959963984540054, 1e-14);
  EXPECT_NEAR(normal_quantile(1e-6), -4.753424308822899, 1e-12);
  EXPECT_NEAR(normal_quantile(0.5), 0, 1e-15);
  // tables of Student's t, printed to three digits; the expansion errs by 1e-3 at 4 degrees
  EXPECT_NEAR(student_95(4), 2.776, 2e-3);
  EXPECT_NEAR(student_95(10), 2.228, 6e-4);
  EXPECT_NEAR(student_95(30), 2.042, 6e-4);
  EXPECT_NEAR(student_95(249), 1.9695, 6e-4);
}

TEST(Quantiles, of_a_sample_lie_straight_between_neighbours) {
  EXPECT_DOUBLE_EQ(quantile_of({1, 2, 3, 4, 5}, 0.5), 3);
  EXPECT_DOUBLE_EQ(quantile_of({1, 2, 3, 4, 5}, 0.05), 1.2);
  EXPECT_TRUE(std::isnan(quantile_of({}, 0.5)));
}

TEST(Bootstrap, of_equal_values_has_no_width) {
  const Estimate e = bca_bootstrap(kFewestForBootstrap, [](const Counts&) { return 3.0; });
  EXPECT_EQ(e.interval.low, 3);
  EXPECT_EQ(e.interval.high, 3);
}

TEST(Bootstrap, few_samples_have_no_interval) {
  const auto first = [](const Counts& c) { return c[0]; };
  EXPECT_TRUE(std::isnan(bca_bootstrap(kFewestForBootstrap - 1, first).interval.low));
  EXPECT_TRUE(std::isnan(percentile_bootstrap(kFewestForBootstrap - 1, first).interval.low));
}

// --- censored values ---------------------------------------------------------------------------

TEST(KaplanMeier, follows_the_hand_example) {
  // 3, 5, 5+, 8, 10+ : S = 4/5, 4/5 * 3/4, then 3/5 * 1/2
  const std::vector<Reading> r =
      in_order({{10, true}, {5, true}, {3, false}, {8, false}, {5, false}});
  const std::vector<ExceedancePoint> km = kaplan_meier(r);
  ASSERT_EQ(km.size(), 3u);
  EXPECT_NEAR(km[0].probability.value, 0.8, 1e-15);
  EXPECT_NEAR(km[1].probability.value, 0.6, 1e-15);
  EXPECT_NEAR(km[2].probability.value, 0.3, 1e-15);
  const Counts once(5, 1);
  // 3 + 0.8 * 2 + 0.6 * 3 + 0.3 * 2
  EXPECT_NEAR(survival_mean(r, once), 7.0, 1e-14);
  EXPECT_EQ(survival_quantile(r, once, 0.5), 8);
  EXPECT_TRUE(std::isinf(survival_quantile(r, once, 0.95)));
  EXPECT_NEAR(share_before(r, 7.9).value, 0.4, 1e-15);
}

// A bound above a percentile does not change it: the values at its place are known.
TEST(Percentiles, are_linear_ones_until_a_bound_lies_below) {
  std::vector<double> values;
  for (int i = 0; i < 20; ++i) values.push_back(2 + 0.1 * i * i);
  for (const int bounds : {0, 1, 7, 19}) {
    std::vector<Reading> readings;
    for (const double v : values) readings.push_back({v, readings.size() + bounds >= 20});
    const Counts once(20, 1);
    for (const double p : {0.0, 0.05, 0.16, 0.5, 0.84, 0.95, 1.0}) {
      const double linear = quantile_of(values, p), told = survival_quantile(readings, once, p);
      if (std::ceil(19 * p) < 20 - bounds)
        EXPECT_DOUBLE_EQ(told, linear) << bounds << " " << p;
      else
        EXPECT_TRUE(std::isinf(told)) << bounds << " " << p;
    }
  }
}

// 3, 5, 5+, 8, 10+: at places 0 and 1; the bound at 5 leaves its mass to 8 and 10, so that 8 has the places 2 to 2.5.
TEST(Percentiles, give_the_mass_of_a_bound_to_what_lies_beyond) {
  const std::vector<Reading> r =
      in_order({{10, true}, {5, true}, {3, false}, {8, false}, {5, false}});
  const Counts once(5, 1);
  EXPECT_EQ(survival_quantile(r, once, 0), 3);
  EXPECT_DOUBLE_EQ(survival_quantile(r, once, 0.125), 4);
  EXPECT_DOUBLE_EQ(survival_quantile(r, once, 0.375), 6.5);
  EXPECT_EQ(survival_quantile(r, once, 0.5), 8);
  EXPECT_EQ(survival_quantile(r, once, 0.625), 8);
  EXPECT_TRUE(std::isinf(survival_quantile(r, once, 0.65)));
  // a count is that value again
  const std::vector<Reading> twice = in_order({{3, false}, {3, false}, {5, false}, {8, false}});
  for (const double p : {0.1, 0.3, 0.5, 0.9})
    EXPECT_DOUBLE_EQ(
        survival_quantile(twice, Counts(4, 1), p),
        survival_quantile({{3, false}, {5, false}, {6, false}, {8, false}}, {2, 1, 0, 1}, p));
}

TEST(Percentiles, of_a_table_do_not_jump_with_one_bound) {
  std::vector<SampleRecord> records;
  for (int i = 1; i <= 20; ++i) {
    records.push_back(sample_record(i, 100e3 + i, "FM-1"));
    records.back().responses.displacement_at_80 = 1e-3 * i;
    records.back().responses.censored_80 = false;
  }
  const Summary known = statistics_of(of_records(records)).group[0].quantity[2];
  records.back().responses.censored_80 = true;
  const Summary cut = statistics_of(of_records(records)).group[0].quantity[2];
  ASSERT_EQ(cut.censored, 1);
  EXPECT_DOUBLE_EQ(known.percentile_5, 1.95e-3);
  EXPECT_EQ(cut.percentile_5, known.percentile_5);
  EXPECT_TRUE(std::isinf(cut.percentile_95));  // between the last two, of which one is a bound
  EXPECT_DOUBLE_EQ(cut.survival_median.value, cut.median.value);
  EXPECT_DOUBLE_EQ(known.survival_median.value, known.median.value);
}

TEST(KaplanMeier, a_share_is_never_more_certain_than_the_samples) {
  const std::vector<Reading> r =
      in_order({{10, true}, {5, true}, {3, false}, {8, false}, {5, false}});
  // none of five has fallen before 1: no less can be said than by the share of none
  EXPECT_EQ(share_before(r, 1).value, 0);
  EXPECT_DOUBLE_EQ(share_before(r, 1).interval.high, share_estimate(0, 5).interval.high);
  // beyond the last reading three of five are known to have fallen, the others may have
  EXPECT_DOUBLE_EQ(share_before(r, 12).value, 0.6);
  EXPECT_DOUBLE_EQ(share_before(r, 12).interval.low, share_estimate(3, 5).interval.low);
  EXPECT_EQ(share_before(r, 12).interval.high, 1);
  // one left early, then none fell: those still going on count
  const std::vector<Reading> late = in_order({{1, true}, {4, false}, {5, true}, {6, true}});
  EXPECT_DOUBLE_EQ(share_before(late, 3).interval.high, share_estimate(0, 3).interval.high);
  const std::vector<Reading> unknown = in_order({{2, true}, {2, true}});
  EXPECT_TRUE(std::isnan(share_before(unknown, 5).value));
  EXPECT_TRUE(std::isnan(share_before(unknown, 5).interval.low));
  EXPECT_DOUBLE_EQ(share_before(unknown, 1).interval.high, share_estimate(0, 2).interval.high);
}

TEST(KaplanMeier, intervals_are_those_of_a_share_until_a_bound_lies_below) {
  const std::vector<ExceedancePoint> km =
      kaplan_meier(in_order({{3, false}, {5, false}, {5, true}, {8, false}, {10, true}}));
  // the bound at 5 goes beyond 5
  for (const int k : {0, 1}) {
    const Interval exact = exact_share(4 - k, 5).interval;
    EXPECT_EQ(km[static_cast<std::size_t>(k)].probability.interval.low, exact.low);
    EXPECT_EQ(km[static_cast<std::size_t>(k)].probability.interval.high, exact.high);
  }
  // 8 is one of two, and one goes on: wider than one of five, and within (0, 1)
  const Interval last = km[2].probability.interval;
  EXPECT_GT(last.low, 0);
  EXPECT_LT(last.low, 0.3);
  EXPECT_GT(last.high, exact_share(1, 5).interval.high);
  EXPECT_LT(last.high, exact_share(3, 5).interval.high);
}

// Wilson's interval of S, and of as many samples as its variance has: 19 bounds of 400 make it those of some 390.
TEST(KaplanMeier, intervals_of_many_with_bounds_below_are_nearly_those_of_a_share) {
  std::vector<Reading> readings;
  for (int i = 1; i <= 400; ++i) readings.push_back({1.0 * i, i % 21 == 0 && i <= 400});
  for (const ExceedancePoint& p : kaplan_meier(readings)) {
    const double left = p.probability.value;
    const Interval many = score_interval(left, 400), fewer = score_interval(left, 350);
    if (left > 0.9 || left < 0.1) continue;
    EXPECT_LE(p.probability.interval.low, many.low + 0.002) << p.value;
    EXPECT_GE(p.probability.interval.high, many.high - 0.002) << p.value;
    EXPECT_GE(p.probability.interval.low, fewer.low - 0.002) << p.value;
    EXPECT_LE(p.probability.interval.high, fewer.high + 0.002) << p.value;
  }
}

TEST(KaplanMeier, without_censoring_is_the_share_that_goes_beyond) {
  const std::vector<Reading> r = in_order({{4, false}, {1, false}, {2, false}, {3, false}});
  EXPECT_NEAR(survival_mean(r, Counts(4, 1)), 2.5, 1e-14);
  EXPECT_EQ(kaplan_meier(r).back().probability.value, 0);
  EXPECT_EQ(kaplan_meier(r).back().probability.interval.high, exact_share(0, 4).interval.high);
}

TEST(LognormalFit, without_censoring_is_moments_of_logarithms) {
  std::vector<Reading> r;
  for (double log : {1.0, 2.0, 3.0, 6.0}) r.push_back({std::exp(log), false});
  const Lognormal fit = fit_lognormal(r, Counts(4, 1));
  EXPECT_NEAR(std::log(fit.median), 3, 1e-12);
  EXPECT_NEAR(fit.beta, std::sqrt(14.0 / 4), 1e-12);  // greatest likelihood: divisor n
}

TEST(LognormalFit, needs_two_observed_values) {
  EXPECT_TRUE(std::isnan(fit_lognormal({{2, false}, {3, true}}, {1, 1}).median));
}

// --- a campaign --------------------------------------------------------------------------------

// A push without a force in balance has no peak; a wall that fell before it has nothing.
TEST(CampaignStatistics, what_has_no_value_is_not_counted_but_told) {
  std::vector<SampleRecord> records;
  for (int i = 1; i <= 12; ++i) records.push_back(sample_record(i, 100e3 + 1e3 * i, "FM-1"));
  records[3].responses.peak_reaction = records[3].responses.displacement_at_80 = kUnset;
  records[7].status = "collapsed", records[7].curve.clear(), records[7].responses = {};
  const Statistics s = statistics_of(of_records(records));
  EXPECT_EQ(s.answered, 11);
  EXPECT_EQ(s.collapsed_before_push, 1);
  const Summary& peak = s.group[0].quantity[0];
  EXPECT_EQ(peak.n, 10);
  EXPECT_EQ(peak.without_value, 1);
  EXPECT_EQ(peak.min, 101e3);
  EXPECT_NEAR(peak.mean.value, (12 * 100e3 + 78e3 - 104e3 - 108e3) / 10, 1e-6);
  EXPECT_EQ(s.running[0].n.back(), 10);
  EXPECT_EQ(s.share[0].count, 11);
  const std::string json = statistics_json(s);
  EXPECT_NE(json.find("\"collapsed_before_push\": 1"), std::string::npos);
  EXPECT_NE(json.find("\"without_value\": 1"), std::string::npos);
  EXPECT_FALSE(precise_enough("relative_interval(peak_reaction_kN) < 1 %", of_records(records)));
}

// One name with its unit for each response: in no value or key does it stand without.
TEST(CampaignStatistics, the_file_names_each_response_with_its_unit) {
  const auto json =
      nlohmann::json::parse(statistics_json(statistics_of(scenes::sample_campaign(40))));
  for (const auto& [list, key] :
       {std::pair{"correlation", "response"}, {"first_order", "response"}, {"precision", "what"}}) {
    EXPECT_FALSE(json[list].empty());
    for (const auto& row : json[list])
      EXPECT_TRUE(row[key] == "share" || json["table"]["all"].contains(row[key])) << row[key];
  }
  EXPECT_NO_THROW(check_rule(
      "relative_interval(peak_reaction_kN) < 1 % and relative_interval(displacement_max) < 0.1"));
}

TEST(CampaignStatistics, table_by_hand) {
  const Statistics s =
      statistics_of(of_records({sample_record(1, 100e3, "FM-1"), sample_record(2, 120e3, "FM-1"),
                                sample_record(3, 200e3, "FM-4")}));
  const Summary& all = s.group[0].quantity[0];
  EXPECT_EQ(all.n, 3);
  EXPECT_DOUBLE_EQ(all.mean.value, 140e3);
  EXPECT_DOUBLE_EQ(all.median.value, 120e3);
  EXPECT_NEAR(all.cov.value, std::sqrt((1600 + 400 + 3600) / 2.0) * 1e3 / 140e3, 1e-12);
  EXPECT_DOUBLE_EQ(group_named(s, "FM-1").quantity[0].mean.value, 110e3);
  // 0.8 of the peak lies at 10 + 16 mm on every one of these curves
  EXPECT_NEAR(all.max, 200e3, 1e-6);
  EXPECT_NEAR(s.group[0].quantity[2].mean.value, 26e-3, 1e-12);
  EXPECT_EQ(s.group[0].quantity[3].censored, 3);
}

TEST(CampaignStatistics, paper_modes_are_grouped_and_listed_in_order) {
  const Statistics s =
      statistics_of(of_records({sample_record(1, 1, "FM-4"), sample_record(2, 1, "FM-2"),
                                sample_record(3, 1, "unclear"), sample_record(4, 1, "FM-3")}));
  EXPECT_EQ(s.modes, (std::vector<std::string>{"FM-1", "FM-2", "FM-3", "FM-4", "FM-5", "unclear"}));
  EXPECT_EQ(share_named(s, "FM-1 + FM-2").count, 1);
  EXPECT_EQ(share_named(s, "FM-3 + FM-4").count, 2);
  EXPECT_EQ(share_named(s, "FM-5").count, 0);
  EXPECT_DOUBLE_EQ(share_named(s, "unclear").share.value, 0.25);
}

TEST(CampaignStatistics, plain_names_stand_as_they_are) {
  const Statistics s =
      statistics_of(of_records({sample_record(1, 1, "sliding of pier 2"),
                                sample_record(2, 1, "rocking"), sample_record(3, 1, "unclear")}));
  EXPECT_EQ(s.modes, (std::vector<std::string>{"rocking", "sliding of pier 2", "unclear"}));
  EXPECT_EQ(s.share.size(), 3u);
}

TEST(CampaignStatistics, only_ended_pushes_count_and_the_rest_is_listed) {
  SampleRecord unstable = sample_record(2, 300e3, "FM-1"), refused;
  unstable.status = "unstable", unstable.reason = as_text("it flew");
  refused.sample = 3, refused.status = "refused", refused.reason = as_text("snap-back");
  const Statistics s =
      statistics_of(of_records({sample_record(1, 100e3, "FM-1"), unstable, refused}));
  EXPECT_EQ(s.run, 3);
  EXPECT_EQ(s.answered, 1);
  EXPECT_DOUBLE_EQ(s.group[0].quantity[0].max, 100e3);
  ASSERT_EQ(s.unanswered.size(), 2u);
  EXPECT_EQ(text_of(s.unanswered[1].reason), "snap-back");
  EXPECT_EQ(s.status.at("refused"), 1);
}

TEST(CampaignStatistics, running_mean_is_the_mean_of_the_first_n) {
  const Campaign campaign = sample_campaign(40);
  const Statistics s = statistics_of(campaign);
  double sum = 0;
  for (int i = 0; i < 40; ++i) {
    sum += campaign.records[i].responses.peak_reaction;
    EXPECT_NEAR(s.running[0].mean[i].value, sum / (i + 1), 1e-6);
  }
  EXPECT_EQ(s.running[0].n.back(), 40);
}

TEST(CampaignStatistics, order_of_the_records_does_not_matter) {
  Campaign campaign = sample_campaign(30);
  const std::string forward = statistics_json(statistics_of(campaign));
  std::swap(campaign.records[2], campaign.records[20]);
  EXPECT_EQ(statistics_json(statistics_of(campaign)), forward);
}

TEST(CampaignStatistics, same_campaign_same_bytes) {
  const Campaign campaign = sample_campaign(60);
  const Statistics s = statistics_of(campaign), again = statistics_of(campaign);
  EXPECT_EQ(statistics_json(s), statistics_json(again));
  EXPECT_EQ(report_page(campaign_data(campaign, s)), report_page(campaign_data(campaign, again)));
}

TEST(CampaignStatistics, mean_curve_of_scaled_triangles_is_their_middle) {
  const Statistics s =
      statistics_of(of_records({sample_record(1, 100e3, "FM-1"), sample_record(2, 200e3, "FM-1")}));
  for (const CurvePoint& p : s.mean_curve[0].point) {
    const double mm = p.displacement * 1e3;
    const double expected = 150e3 * (mm < 10 ? mm / 10 : 1 - 0.5 * (mm - 10) / 40);
    EXPECT_NEAR(p.mean, expected, 1e-6 * 150e3) << mm;
    EXPECT_EQ(p.n, 2);
  }
}

TEST(CampaignStatistics, drift_limits_count_the_unknown_apart) {
  std::vector<SampleRecord> records;
  for (int i = 1; i <= 10; ++i) {
    records.push_back(sample_record(i, 100e3, "FM-1"));
    Responses& r = records.back().responses;
    r.displacement_at_80 = i <= 4 ? 0.4e-2 : 0.9e-2;  // of a height of 1 m: 0.4 and 0.9 %
    r.censored_80 = i > 7;
    r.load_height = 1;
  }
  for (const DriftLimit& limit : statistics_of(of_records(records)).drift_limit) {
    if (limit.limit == 0.005) {
      EXPECT_EQ(limit.below, 4);
      EXPECT_EQ(limit.unknown, 0);
      EXPECT_DOUBLE_EQ(limit.share.interval.low, share_estimate(4, 10).interval.low);
      EXPECT_FALSE(limit.is_lower_bound);
    }
    if (limit.limit == 0.01) {
      EXPECT_EQ(limit.below, 7);
      EXPECT_EQ(limit.unknown, 3);
      EXPECT_DOUBLE_EQ(limit.share.value, 0.7);  // at least: all pushes end at 0.9 %
      EXPECT_DOUBLE_EQ(limit.share.interval.low, share_estimate(7, 10).interval.low);
      EXPECT_EQ(limit.share.interval.high, 1);
      EXPECT_TRUE(limit.is_lower_bound);
    }
  }
}

TEST(CampaignStatistics, drift_limits_of_pushes_that_end_before_them_are_unknown) {
  std::vector<SampleRecord> records;
  for (int i = 1; i <= 10; ++i) {
    records.push_back(sample_record(i, 100e3, "FM-1"));
    Responses& r = records.back().responses;
    r.displacement_at_80 = 2e-3, r.censored_80 = true, r.load_height = 3;
  }
  for (const DriftLimit& limit : statistics_of(of_records(records)).drift_limit) {
    EXPECT_EQ(limit.unknown, 10);
    EXPECT_TRUE(std::isnan(limit.share.value));
    EXPECT_TRUE(std::isnan(limit.share.interval.high));
  }
}

TEST(CampaignStatistics, drifts_are_over_each_samples_own_height) {
  std::vector<SampleRecord> records;
  for (int i = 1; i <= 10; ++i) {
    records.push_back(sample_record(i, 100e3, "FM-1"));
    Responses& r = records.back().responses;
    r.displacement_at_80 = 12e-3, r.censored_80 = false;
    r.load_height = i <= 5 ? 2 : 3;  // drifts of 0.6 and 0.4 %
  }
  Campaign campaign = of_records(records);
  campaign.load_height = 2;
  const Statistics s = statistics_of(campaign);
  for (const DriftLimit& limit : s.drift_limit) {
    EXPECT_EQ(limit.below, limit.limit > 0.006 ? 10 : limit.limit > 0.004 ? 5 : 0) << limit.limit;
  }
  const CurvePoint& end = s.mean_curve[0].point.back();
  EXPECT_NEAR(end.drift, (50e-3 / 2 + 50e-3 / 3) / 2, 1e-12);
}

TEST(CampaignStatistics, a_collapse_is_an_event_and_not_a_lower_bound) {
  std::vector<SampleRecord> records;
  for (int i = 1; i <= 30; ++i) {
    records.push_back(sample_record(i, 100e3 + 1e3 * i, "FM-1"));
    const bool collapsed = i <= 10;
    if (collapsed) records.back().status = "collapsed";
    auto& curve = records.back().curve;
    if (collapsed) curve.resize(curve.size() - static_cast<std::size_t>(i));
    records.back().responses =
        read_responses(curve, {.collapse = as_text(collapsed ? "a block fell" : "")});
  }
  const Statistics s = statistics_of(of_records(records));
  const auto q = static_cast<std::size_t>(std::find_if(quantities().begin(), quantities().end(),
                                                       [](const Quantity& quantity) {
                                                         return std::string(quantity.name) ==
                                                                "collapse_displacement";
                                                       }) -
                                          quantities().begin());
  ASSERT_LT(q, quantities().size());
  EXPECT_EQ(s.group[0].quantity[q].censored, 20);
  EXPECT_DOUBLE_EQ(s.group[0].quantity[q].min, 40e-3);
  // Kaplan-Meier: ten fell at 40 ... 49 mm, one each, the others go on to 50 mm
  EXPECT_NEAR(s.group[0].quantity[q].survival_mean.value, 50e-3 - (55e-3 / 30), 1e-9);
  const Campaign campaign = of_records(records);
  EXPECT_NE(samples_csv(campaign).find("collapse_displacement_mm"), std::string::npos);
  EXPECT_NE(samples_csv(campaign).find(",49,0,a block fell,"), std::string::npos);
}

TEST(CampaignStatistics, a_quantity_is_found_by_its_whole_name_alone) {
  for (const Quantity& q : quantities()) EXPECT_EQ(&quantity_named(q.name), &q);
  for (const char* name : {"", "peak", "peak_reaction_kN"})
    EXPECT_THROW((void)quantity_named(name), std::logic_error) << name;
}

TEST(CampaignStatistics, lower_bounds_alone_have_no_correlation) {
  const Campaign campaign = sample_campaign(60);
  const Statistics s = statistics_of(campaign);
  for (const CorrelationTable& table : s.correlation) EXPECT_NE(table.quantity, "displacement_max");
  for (const FirstOrderIndex& index : s.first_order) EXPECT_NE(index.quantity, "displacement_max");
}

// Pearson's r and the first-order index take each value as it is recorded, ranks do not.
TEST(CampaignStatistics, what_takes_bounds_as_values_is_not_told_of_many_bounds) {
  for (const int bounds : {2, 12}) {
    Campaign campaign = sample_campaign(60);
    for (int i = 0; i < 60; ++i) {
      Responses& r = campaign.records[i].responses;
      r.displacement_max = 0.01 + 1e-4 * ((37 * i) % 60), r.censored_max = i < bounds;
    }
    const Statistics s = statistics_of(campaign);
    const auto table = std::find_if(s.correlation.begin(), s.correlation.end(), [](const auto& t) {
      return t.group == "all" && t.quantity == "displacement_max_mm";
    });
    ASSERT_NE(table, s.correlation.end());
    const auto index = std::find_if(s.first_order.begin(), s.first_order.end(), [](const auto& f) {
      return f.quantity == "displacement_max_mm";
    });
    ASSERT_NE(index, s.first_order.end());
    EXPECT_EQ(table->censored, bounds);
    EXPECT_EQ(std::isnan(table->input[0].pearson.value), bounds == 12);
    EXPECT_EQ(std::isnan(index->index.value), bounds == 12);
    EXPECT_FALSE(std::isnan(table->input[0].spearman.value));
  }
}

TEST(CampaignStatistics, displacement_at_half_the_peak_is_a_bound_where_it_was_not_read) {
  std::vector<SampleRecord> records = {sample_record(1, 100e3, "FM-1"),
                                       sample_record(2, 100e3, "FM-1")};
  records[1].responses.falls.clear();
  const Statistics s = statistics_of(of_records(records));
  const Summary& half = s.group[0].quantity[5];
  EXPECT_EQ(std::string(quantities()[5].name), "displacement_at_50_percent");
  EXPECT_EQ(half.censored, 2);  // the first falls to 0.5 at its very end, the second was not read
  EXPECT_NEAR(half.max, 50e-3, 1e-9);
  EXPECT_NEAR(half.min, 26e-3, 1e-9);  // 0.8 was crossed there
}

TEST(CampaignStatistics, inputs_drawn_together_are_named_beside_their_indices) {
  Campaign campaign = sample_campaign(60);
  for (std::size_t i = 0; i < 60; ++i)  // the third follows the first
    campaign.samples.value[i][2] = campaign.records[i].inputs[2] = campaign.samples.value[i][0];
  const Statistics s = statistics_of(campaign);
  EXPECT_EQ(s.input_correlation.size(), 10u);
  EXPECT_EQ(s.input_correlation[0].a, "fc");
  EXPECT_EQ(s.input_correlation[0].b, "ft_u");
  EXPECT_NEAR(s.input_correlation[0].rank, 1, 1e-12);
  for (const FirstOrderIndex& f : s.first_order) {
    if (f.input != "fc") continue;
    ASSERT_FALSE(f.entangled.empty());
    EXPECT_EQ(f.entangled[0], "ft_u");
  }
  EXPECT_NE(statistics_json(s).find("\"input_correlation\""), std::string::npos);
}

TEST(CampaignStatistics, changes_of_the_name_and_flags_are_counted_over_samples) {
  std::vector<SampleRecord> records;
  for (int i = 1; i <= 10; ++i) {
    records.push_back(sample_record(i, 100e3, "FM-1"));
    FailureMode& mode = records.back().failure_mode;
    // the peak lies elsewhere in every sample and is one reading all the same
    mode.sensitivity = {{"FM-5", "peak", 1e-3 * i},
                        {i <= 3 ? "FM-1" : "unclear", "20 mm", 20e-3},
                        {i <= 9 ? "FM-1" : "FM-2", "", 40e-3, "crack width", 0.75}};
    mode.flags = {{"reaction", "sudden fall", i <= 4 ? 0.3 : 0.1, 0.2, "share"}};
  }
  const Statistics s = statistics_of(of_records(records));
  ASSERT_EQ(s.name_sensitivity.size(), 3u);
  EXPECT_EQ(text_of(s.name_sensitivity[0].reading.what()), "at the peak");
  EXPECT_EQ(s.name_sensitivity[0].differs, 10);
  EXPECT_EQ(text_of(s.name_sensitivity[1].reading.what()), "at 20 mm");
  EXPECT_EQ(s.name_sensitivity[1].differs, 7);
  EXPECT_EQ(text_of(s.name_sensitivity[2].reading.what()), "crack width x 0.75");
  EXPECT_EQ(s.name_sensitivity[2].differs, 1);
  ASSERT_EQ(s.flag.size(), 1u);
  EXPECT_EQ(s.flag[0].raised, 4);
  EXPECT_DOUBLE_EQ(s.flag[0].share.interval.low, share_estimate(4, 10).interval.low);
  const std::string json = statistics_json(s);
  EXPECT_NE(json.find("\"reading\": \"at 20 mm\""), std::string::npos);
  EXPECT_NE(json.find("\"raised\": 4"), std::string::npos);
}

TEST(CampaignStatistics, a_peak_at_the_end_and_an_early_name_are_counted) {
  std::vector<SampleRecord> records = {sample_record(1, 100e3, "FM-1"),
                                       sample_record(2, 100e3, "FM-1")};
  records[0].curve.resize(9);  // still rising
  records[0].responses = read_responses(records[0].curve);
  records[0].failure_mode.read_at = 8e-3;
  records[1].failure_mode.read_at = 40.05e-3;
  Campaign campaign = of_records(records);
  campaign.study.read_modes_at = 40e-3;
  const Statistics s = statistics_of(campaign);
  EXPECT_EQ(s.still_rising, 1);
  EXPECT_EQ(s.named_earlier, 1);
  const std::string json = statistics_json(s);
  EXPECT_NE(json.find("\"still_rising\": 1"), std::string::npos);
  EXPECT_NE(json.find("\"named_earlier\": 1"), std::string::npos);
}

// Eight walls: Student, Vangel, the second and seventh value; bounds at one end leave the mean up to there.
TEST(CampaignStatistics, of_few_samples_intervals_are_closed_forms) {
  std::vector<SampleRecord> records;
  Moments peaks, ends;
  for (int i = 1; i <= 8; ++i) {
    records.push_back(sample_record(i, 100e3 + 1e3 * i, "FM-1"));
    Responses& r = records.back().responses;
    r.displacement_at_80 = std::fmin(1e-3 * i, 6e-3), r.censored_80 = i > 6;
    peaks.add(r.peak_reaction), ends.add(r.displacement_at_80);
  }
  const Statistics s = statistics_of(of_records(records));
  const Summary &peak = s.group[0].quantity[0], &fall = s.group[0].quantity[2];
  ASSERT_EQ(peak.n, 8);
  ASSERT_EQ(fall.censored, 2);
  EXPECT_DOUBLE_EQ(peak.mean.interval.low, peaks.student().interval.low);
  EXPECT_DOUBLE_EQ(peak.cov.interval.high,
                   vangel(peaks.standard_deviation() / peaks.mean(), 8).interval.high);
  EXPECT_DOUBLE_EQ(peak.median.interval.low, records[0].responses.peak_reaction);
  EXPECT_DOUBLE_EQ(peak.median.interval.high, records[7].responses.peak_reaction);
  EXPECT_DOUBLE_EQ(fall.survival_mean.interval.low, ends.student().interval.low);
  EXPECT_DOUBLE_EQ(fall.survival_median.interval.low, 1e-3);
  EXPECT_TRUE(std::isinf(fall.survival_median.interval.high));
  records[7].responses.displacement_at_80 =
      2.5e-3;  // a push that ended early: no mean up to anywhere
  const Statistics early = statistics_of(of_records(records));
  EXPECT_TRUE(std::isnan(early.group[0].quantity[2].survival_mean.interval.low));
}

TEST(CampaignStatistics, lower_bounds_alone_have_no_interval) {
  std::vector<SampleRecord> records;
  for (int i = 1; i <= 30; ++i) records.push_back(sample_record(i, 100e3 + i, "FM-1"));
  const Campaign campaign = of_records(records);
  const Statistics s = statistics_of(campaign);
  EXPECT_EQ(s.group[0].quantity[3].censored, 30);
  EXPECT_TRUE(std::isnan(s.group[0].quantity[3].mean.interval.low));
  EXPECT_FALSE(precise_enough("relative_interval(displacement_max) < 5 %", campaign));
}

TEST(CampaignStatistics, a_rule_says_how_many_values_are_lower_bounds) {
  std::vector<SampleRecord> records;
  for (int i = 1; i <= 30; ++i) {
    records.push_back(sample_record(i, 100e3 + i, "FM-1"));
    records.back().responses.displacement_max = 0.01 + 1e-6 * i;
    records.back().responses.censored_max = i > 20;
  }
  Message said;
  EXPECT_TRUE(
      precise_enough("relative_interval(displacement_max) < 5 %", of_records(records), &said));
  EXPECT_NE(text_of(said).find("10 values are lower bounds"), std::string::npos) << text_of(said);
}

// --- stop rule ---------------------------------------------------------------------------------

std::string fault_of(const std::string& rule) {
  try {
    check_rule(rule);
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

TEST(UntilRule, well_formed_rules_pass) {
  EXPECT_EQ(fault_of("relative_interval(peak_reaction) < 1 % and interval(share) < 0.1"), "");
  EXPECT_EQ(fault_of("  relative_interval( displacement_max )<0.02 "), "");
  EXPECT_EQ(fault_of("interval(share)<10%"), "");
  EXPECT_EQ(fault_of(""), "");
}

TEST(UntilRule, malformed_rules_say_what_to_write) {
  EXPECT_NE(fault_of("relative_interval(peak_reactoin) < 1 %").find("did you mean peak_reaction?"),
            std::string::npos);
  EXPECT_NE(fault_of("intervall(share) < 0.1").find("did you mean interval?"), std::string::npos);
  EXPECT_NE(fault_of("interval(peak_reaction) < 0.1").find("relative_interval(peak_reaction)"),
            std::string::npos);
  EXPECT_NE(fault_of("interval(share) < 0.1 and").find("a clause is missing"), std::string::npos);
  EXPECT_NE(fault_of("interval(share) > 0.1").find("write e.g."), std::string::npos);
  EXPECT_NE(fault_of("interval(share) < small").find("a number"), std::string::npos);
  EXPECT_NE(fault_of("interval(share) < 0").find("must be positive"), std::string::npos);
  EXPECT_NE(fault_of("interval(share) < 0.1 kN").find("a number"), std::string::npos);
  EXPECT_NE(fault_of("interval(share) < 0.1 or interval(share) < 0.2"), "");
}

TEST(UntilRule, collects_every_fault) {
  EXPECT_EQ(count(fault_of("interval(x) < 0.1 and relative_interval(y) < 1"), "until ="), 2);
}

TEST(UntilRule, is_met_as_soon_as_its_interval_is_narrow_enough) {
  const Campaign campaign = sample_campaign(60);
  Moments moments;
  for (const SampleRecord& r : campaign.records) moments.add(r.responses.peak_reaction);
  const double half = moments.student().interval.width() / 2 / moments.mean();
  const auto rule = [](double limit) {
    return "relative_interval(peak_reaction) < " + std::to_string(limit);
  };
  EXPECT_TRUE(precise_enough(rule(half + 1e-5), campaign));
  EXPECT_FALSE(precise_enough(rule(half - 1e-5), campaign));
  EXPECT_FALSE(precise_enough(rule(half + 1e-5) + " and interval(share) < 0.01", campaign));
}

TEST(UntilRule, never_stops_below_twenty_samples) {
  std::vector<SampleRecord> records;
  for (int i = 1; i <= 19; ++i) records.push_back(sample_record(i, 100e3 + i, "FM-1"));
  const std::string rule = "relative_interval(peak_reaction) < 5 %";
  Message said;
  EXPECT_FALSE(precise_enough(rule, of_records(records), &said));
  EXPECT_NE(text_of(said).find("at least 20"), std::string::npos);
  records.push_back(sample_record(20, 100e3, "FM-1"));
  EXPECT_TRUE(precise_enough(rule, of_records(records), &said));
  EXPECT_NE(text_of(said).find("20 samples"), std::string::npos);
  EXPECT_FALSE(precise_enough("", of_records(records), &said));
}

TEST(Precision, first_met_and_held_are_told_apart) {
  // twenty equal samples, then one far off: 1 % is met at 20, lost at 21 and for long
  std::vector<SampleRecord> records;
  for (int i = 1; i <= 20; ++i) records.push_back(sample_record(i, 100e3 + i, "FM-1"));
  records.push_back(sample_record(21, 300e3, "FM-1"));
  for (const Precision& p : statistics_of(of_records(records)).precision) {
    if (p.what != "peak_reaction_kN" || p.target != 0.01) continue;
    EXPECT_EQ(p.first_met, 20);
    EXPECT_EQ(p.held_from, 0);
    EXPECT_GT(p.expected, 21);
    return;
  }
  FAIL() << "no row";
}

}  // namespace
}  // namespace wythe::statistics_test
