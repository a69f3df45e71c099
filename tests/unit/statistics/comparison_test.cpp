// Pairs against closed forms: known differences, bounds, lost pairs, other samples, nothing to compare.
#include "wythe/parts/comparison.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>
#include <set>

#include "scenes/sample_campaign.h"
#include "scenes/small_study.h"
#include "statistics/intervals.h"
#include "statistics/pairs.h"
#include "wythe/parts/error.h"
#include "wythe/parts/io.h"

namespace wythe::comparison_test {
namespace {

using scenes::sample_campaign;
using scenes::sample_record;

constexpr double kInfinite = std::numeric_limits<double>::infinity();

// n samples of one input x = 1 ... n; the peak of sample i is `peak(x)`.
template <class Peak>
Campaign campaign_of(int n, Peak peak) {
  Campaign campaign;
  campaign.samples.column = {{"x", "material.joint.cohesion", "Pa", "Pa", 1, 0, true}};
  for (int i = 1; i <= n; ++i) {
    campaign.samples.value.push_back({static_cast<double>(i)});
    campaign.records.push_back(sample_record(i, peak(i), "FM-1"));
    campaign.records.back().state_hash = std::to_string(peak(i));
    campaign.records.back().quasi_static.judgement = "slow enough";
  }
  return campaign;
}
Campaign plain(int n) {
  return campaign_of(n, [](int i) { return 100e3 + 1e3 * (i * 7 % 5); });
}
OptionComparison compared(const Campaign& base, const Campaign& option) {
  return compare_campaigns({{"base", "", base}, {"tie", "", option}}).option.at(0);
}
const PairedResponse& peak_of(const OptionComparison& o) { return o.response.at(0); }

std::vector<PairValue> pairs_of(const std::vector<std::pair<Reading, Reading>>& sides) {
  std::vector<PairValue> pairs;
  for (const auto& [base, option] : sides)
    pairs.push_back({static_cast<int>(pairs.size()) + 1, base, option});
  return pairs;
}
bool has(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}
std::string refusal(const Campaign& base, const Campaign& other) {
  try {
    static_cast<void>(compared(base, other));
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

// --- differences ---------------------------------------------------------------------------------

TEST(Pairs, a_constant_difference_is_found_without_scatter) {
  const Campaign base = plain(12);
  Campaign option = campaign_of(12, [](int i) { return 105e3 + 1e3 * (i * 7 % 5); });
  const OptionComparison found = compared(base, option);
  const PairedResponse& peak = peak_of(found);
  EXPECT_EQ(found.pairs, 12);
  EXPECT_NEAR(peak.difference.value, 5e3, 1e-6);
  EXPECT_NEAR(peak.difference.interval.width(), 0, 1e-6);
  EXPECT_NEAR(peak.standard_deviation, 0, 1e-6);
  EXPECT_EQ(peak.larger, 12);
  EXPECT_NEAR(peak.sign_test_p, 2 * std::pow(0.5, 12), 1e-12);
  EXPECT_NEAR(peak.correlation, 1, 1e-12);
  EXPECT_TRUE(peak.gain.empty() || std::fabs(peak.gain[0].slope.value) < 1e-3);
}

TEST(Pairs, mean_and_interval_are_students) {
  // differences 1 ... 9: mean 5, standard deviation sqrt(7.5)
  const Campaign base = campaign_of(9, [](int) { return 100.0; });
  const Campaign option = campaign_of(9, [](int i) { return 100.0 + i; });
  const PairedResponse peak = peak_of(compared(base, option));
  EXPECT_NEAR(peak.difference.value, 5, 1e-9);
  EXPECT_NEAR(peak.standard_deviation, std::sqrt(7.5), 1e-9);
  EXPECT_NEAR(peak.difference.interval.high, 5 + study::student_95(8) * std::sqrt(7.5) / 3, 1e-9);
  EXPECT_NEAR(study::student_95(8), 2.306, 1e-3);  // tables
  // geometric mean of the ratios
  double logs = 0;
  for (int i = 1; i <= 9; ++i) logs += std::log(1 + i / 100.0) / 9;
  EXPECT_NEAR(peak.ratio.value, std::exp(logs), 1e-12);
  // the sign test's interval of a median of nine: second to eighth
  EXPECT_NEAR(peak.median_bounds.low, 5, 1e-9);
  EXPECT_NEAR(peak.median_interval.low, 2, 1e-9);
  EXPECT_NEAR(peak.median_interval.high, 8, 1e-9);
}

TEST(Pairs, pairing_is_worth_what_the_correlation_makes_it) {
  // base and option scatter by s, differences by e: worth = (var a + var b) / var d
  const Campaign base = campaign_of(40, [](int i) { return 100.0 + i; });
  const Campaign option = campaign_of(40, [](int i) { return 110.0 + i + (i % 2); });
  const PairedResponse peak = peak_of(compared(base, option));
  EXPECT_GT(peak.correlation, 0.99);
  EXPECT_NEAR(peak.standard_deviation, std::sqrt(40 * 0.25 / 39), 1e-9);
  EXPECT_GT(peak.worth, 900);
}

TEST(Pairs, equal_walls_are_not_better) {
  const OptionComparison found = compared(plain(20), plain(20));
  const PairedResponse& peak = peak_of(found);
  EXPECT_EQ(peak.difference.value, 0);
  EXPECT_EQ(peak.difference.interval.low, 0);
  EXPECT_EQ(peak.difference.interval.high, 0);
  EXPECT_EQ(peak.ratio.value, 1);
  EXPECT_EQ(peak.equal, 20);
  EXPECT_EQ(peak.larger, 0);
  EXPECT_EQ(peak.share_larger.value, 0);
  EXPECT_TRUE(std::isnan(peak.sign_test_p));
  EXPECT_TRUE(std::isnan(peak.worth));
  EXPECT_TRUE(peak.gain.empty());
  EXPECT_TRUE(found.modes.changed.empty());
  EXPECT_EQ(found.same_bits, 20);
  EXPECT_EQ(found.notes.at(0).code, "compare.same_bits");
  EXPECT_TRUE(has(text_of(found.headline), "is the same in all 20 pairs"));
}

TEST(Pairs, few_give_no_interval) {
  for (const int n : {1, 2, 4}) {
    const OptionComparison found =
        compared(plain(n), campaign_of(n, [](int i) { return 120e3 + i; }));
    EXPECT_EQ(peak_of(found).pairs, n);
    EXPECT_TRUE(std::isnan(peak_of(found).difference.interval.low)) << n;
    EXPECT_TRUE(has(text_of(found.headline), "too few for an interval")) << n;
  }
}

TEST(Pairs, a_difference_that_zero_may_be_is_not_called_one) {
  const Campaign base = campaign_of(30, [](int) { return 100.0; });
  const Campaign option = campaign_of(30, [](int i) { return 100.0 + (i % 2 ? 1 : -0.9); });
  EXPECT_TRUE(has(text_of(compared(base, option).headline), "no sure difference"));
  // one wild pair does not make it sure either
  const Campaign wild = campaign_of(30, [](int i) { return i == 3 ? 1000.0 : 100.5; });
  const PairedResponse peak = peak_of(compared(base, wild));
  EXPECT_LT(peak.median_interval.high, 1);
  EXPECT_GT(peak.difference.value, 30);
  EXPECT_EQ(compared(base, wild).notes.at(0).code, "compare.most_differ");
}

// --- bounds --------------------------------------------------------------------------------------

TEST(Pairs, bounds_give_a_side_where_they_can_and_no_number) {
  const PairedResponse r = study::paired_response(pairs_of({
                                                      {{10, false}, {20, true}},  // larger
                                                      {{10, false}, {10, true}},  // at least equal
                                                      {{30, false}, {20, true}},  // open
                                                      {{20, true}, {10, false}},  // smaller
                                                      {{20, true}, {20, true}},   // open
                                                      {{10, false}, {12, false}},
                                                  }),
                                                  true, 0);
  EXPECT_EQ(r.larger, 2);
  EXPECT_EQ(r.smaller, 1);
  EXPECT_EQ(r.undecided, 3);
  EXPECT_EQ(r.equal, 0);
  EXPECT_EQ(r.bounds, 5);
  EXPECT_EQ(r.up_to, 10);              // the smallest bound: all of min(value, 10) is known
  EXPECT_EQ(r.median_bounds.low, -5);  // of -inf, -inf, -10, 0, 2, 10
  EXPECT_EQ(r.median_bounds.high, kInfinite);
  EXPECT_LT(r.share_larger.interval.low, 0.34);
  EXPECT_GT(r.share_larger.interval.high, 0.8);  // the open ones may all be larger
}

TEST(Pairs, means_of_bounded_displacements_go_up_to_the_end_of_the_push) {
  // true values 10 and 60, push to 50: each pair's difference up to 50 is 40, whatever lies beyond
  std::vector<std::pair<Reading, Reading>> sides(8, {{10, false}, {50, true}});
  const PairedResponse r = study::paired_response(pairs_of(sides), true, 0);
  EXPECT_EQ(r.up_to, 50);
  EXPECT_EQ(r.difference.value, 40);
  EXPECT_EQ(r.larger, 8);
  EXPECT_EQ(r.median_bounds.low, 40);
  EXPECT_EQ(r.median_bounds.high, kInfinite);
}

TEST(Pairs, lower_bounds_alone_show_no_difference) {
  std::vector<std::pair<Reading, Reading>> sides(8, {{50, true}, {50, true}});
  const PairedResponse r = study::paired_response(pairs_of(sides), true, 0);
  EXPECT_TRUE(std::isnan(r.difference.value));
  EXPECT_EQ(r.undecided, 8);
  EXPECT_EQ(r.sign_test_p, 1);
}

TEST(Pairs, values_that_are_none_are_counted) {
  std::vector<std::pair<Reading, Reading>> sides(6, {{10, false}, {12, false}});
  sides[2].second.value = kUnset;
  sides[4].first.value = kInfinite;
  const PairedResponse r = study::paired_response(pairs_of(sides), false, 1);
  EXPECT_EQ(r.pairs, 4);
  EXPECT_EQ(r.without_value, 2);
  EXPECT_DOUBLE_EQ(r.share_larger_with_lost.low, 4.0 / 7);
  EXPECT_DOUBLE_EQ(r.share_larger_with_lost.high, 1);
}

TEST(Pairs, a_peak_still_rising_is_a_bound) {
  Campaign option = plain(10);
  for (SampleRecord& record : option.records) {
    record.responses.peak_reaction -= 2e3;
    record.responses.censored_peak = true;
  }
  const OptionComparison found = compared(plain(10), option);
  EXPECT_EQ(peak_of(found).smaller, 0);
  EXPECT_EQ(peak_of(found).undecided, 10);
  EXPECT_EQ(found.rising_option, 10);
  EXPECT_EQ(found.notes.at(0).code, "compare.rising");
}

TEST(Pairs, bounds_of_a_peak_are_no_numbers) {
  // the same walls, pushed less far in the base: the option is not stronger by half
  Campaign base = plain(6);
  const Campaign option = campaign_of(6, [](int i) { return 150e3 + 1e3 * (i * 7 % 5); });
  for (SampleRecord& record : base.records) record.responses.censored_peak = true;
  const OptionComparison found = compared(base, option);
  const PairedResponse& peak = peak_of(found);
  EXPECT_EQ(peak.undecided, 6);
  EXPECT_EQ(peak.in_means, 0);
  for (const double number : {peak.ratio.value, peak.difference.value, peak.base.value,
                              peak.cov_ratio.value, peak.worth, found.response[1].ratio.value})
    EXPECT_TRUE(std::isnan(number));
  EXPECT_TRUE(peak.gain.empty());
  EXPECT_FALSE(has(text_of(found.headline), "%")) << text_of(found.headline);
  EXPECT_TRUE(has(text_of(found.headline), "6 open")) << text_of(found.headline);
}

TEST(Pairs, means_beside_bounds_are_of_the_pairs_without_one) {
  Campaign option = campaign_of(20, [](int i) { return 110e3 + 1e3 * (i * 7 % 5) + 10 * i; });
  for (int i = 0; i < 4; ++i) {
    option.records[i].responses.censored_peak = true;
    option.records[i].responses.peak_reaction = 300e3;
  }
  const OptionComparison found = compared(plain(20), option);
  const PairedResponse& peak = peak_of(found);
  EXPECT_EQ(peak.larger, 20);  // a bound above the base's peak has a sure sign
  EXPECT_EQ(peak.in_means, 16);
  EXPECT_NEAR(peak.difference.value, 10e3 + 10 * 12.5, 1e-6);
  ASSERT_EQ(peak.gain.size(), 1U);
  EXPECT_EQ(peak.gain[0].n, 16);
  EXPECT_NEAR(peak.gain[0].spearman.value, 1, 1e-12);  // each difference beside its own input
  EXPECT_EQ(found.headline.code, "compare.headline");
  EXPECT_FALSE(has(text_of(found.headline), "%")) << text_of(found.headline);
  EXPECT_EQ(found.notes.at(1).code, "compare.means_beside_bounds");
}

TEST(Pairs, one_push_that_ended_early_does_not_make_a_gain_vanish) {
  std::vector<std::pair<Reading, Reading>> sides;
  for (int i = 0; i < 38; ++i) sides.push_back({{10 + 0.1 * i, false}, {11 + 0.11 * i, false}});
  sides.push_back({{10, false}, {0.05, true}});
  const PairedResponse r = study::paired_response(pairs_of(sides), true, 0);
  EXPECT_EQ(r.larger, 38);
  EXPECT_TRUE(std::isnan(r.difference.value));
  EXPECT_TRUE(std::isnan(r.ratio.value));
  EXPECT_EQ(r.in_means, 0);
  EXPECT_GT(r.median_interval.low, 1);
  EXPECT_LT(r.median_interval.high, 1.4);
}

TEST(Pairs, signs_that_bounds_leave_open_are_not_a_few_samples) {
  // seven larger, none smaller: a few samples do not make the difference, bounds hide the rest
  Campaign base = plain(16), option = plain(16);
  for (SampleRecord& record : option.records) record.responses.peak_reaction *= 1.1;
  for (int i = 7; i < 16; ++i) base.records[i].responses.censored_peak = true;
  std::set<std::string> codes;
  for (const Message& note : compared(base, option).notes) codes.insert(note.code);
  EXPECT_FALSE(codes.contains("compare.few_decide"));
  EXPECT_TRUE(codes.contains("compare.signs_open"));
  // five alike are too few for any sign test, not a contradiction
  EXPECT_TRUE(compared(plain(5), campaign_of(5, [](int i) { return 120e3 + 1e3 * (i * 7 % 5); }))
                  .notes.empty());
}

TEST(Pairs, a_change_within_rounding_is_none) {
  Campaign option = plain(20);
  for (int i = 0; i < 20; ++i) option.records[i].responses.peak_reaction *= 1 + 1e-9 * (1 + i % 3);
  const OptionComparison found = compared(plain(20), option);
  EXPECT_EQ(peak_of(found).equal, 20);
  EXPECT_EQ(peak_of(found).larger, 0);
  EXPECT_TRUE(has(text_of(found.headline), "is the same in all 20 pairs"));
}

// --- lost pairs ----------------------------------------------------------------------------------

TEST(Pairs, a_lost_pair_is_counted_listed_and_said) {
  Campaign option = campaign_of(20, [](int i) { return 120e3 + i; });
  option.records[4].status = "not_settled";
  option.records[4].reason = as_text("stage gravity did not settle");
  option.records.erase(option.records.begin() + 7);  // sample 8 has not run
  const OptionComparison found = compared(plain(20), option);
  EXPECT_EQ(found.pairs, 18);
  ASSERT_EQ(found.lost.size(), 2U);
  EXPECT_EQ(found.lost[0].sample, 5);
  EXPECT_EQ(found.lost[0].option_status, "not_settled");
  EXPECT_EQ(text_of(found.lost[0].option_reason), "stage gravity did not settle");
  EXPECT_TRUE(found.lost[0].base_answered);
  EXPECT_EQ(found.lost[1].sample, 8);
  EXPECT_EQ(found.lost[1].option_status, "");
  EXPECT_EQ(found.base_alone, 2);
  EXPECT_TRUE(has(text_of(found.headline), "pairs lost: 2")) << text_of(found.headline);
  EXPECT_DOUBLE_EQ(peak_of(found).share_larger_with_lost.low, 18.0 / 20);
}

TEST(Pairs, many_lost_ones_are_said_before_any_number) {
  Campaign option = campaign_of(20, [](int i) { return 120e3 + i; });
  for (int i = 0; i < 5; ++i) option.records[i].status = "unstable";
  const OptionComparison found = compared(plain(20), option);
  EXPECT_TRUE(text_of(found.headline).starts_with("tie: 5 of 20 pairs are lost"));
  EXPECT_EQ(found.notes.at(0).code, "compare.many_lost");
}

TEST(Pairs, walls_without_a_peak_are_lost_to_the_headline) {
  Campaign option = campaign_of(20, [](int i) { return 150e3 + i; });
  for (int i = 0; i < 16; ++i) option.records[i].responses.peak_reaction = kUnset;
  const OptionComparison found = compared(plain(20), option);
  EXPECT_EQ(peak_of(found).without_value, 16);
  EXPECT_TRUE(text_of(found.headline).starts_with("tie: 16 of 20 pairs are lost or have no peak"))
      << text_of(found.headline);
}

TEST(Pairs, without_a_peak_on_both_sides_nothing_is_lost_but_peaks) {
  Campaign option = plain(6);
  for (SampleRecord& record : option.records) record.responses.peak_reaction = kUnset;
  const OptionComparison found = compared(plain(6), option);
  EXPECT_TRUE(found.lost.empty());
  EXPECT_EQ(found.headline.code, "compare.headline_no_peak");
  EXPECT_FALSE(has(text_of(found.headline), "lost")) << text_of(found.headline);
}

TEST(Pairs, a_mean_made_by_a_few_samples_is_told) {
  // seven gain much, thirteen lose a little: the mean is sure, most walls are worse
  const Campaign option =
      campaign_of(20, [](int i) { return (i <= 7 ? 150e3 : 99e3) + 1e3 * (i * 7 % 5); });
  const OptionComparison found = compared(plain(20), option);
  EXPECT_EQ(found.headline.code, "compare.headline");
  EXPECT_EQ(found.notes.at(0).code, "compare.few_decide");
}

TEST(Pairs, without_any_nothing_is_compared) {
  Campaign option = plain(5);
  for (SampleRecord& record : option.records) record.status = "refused";
  const OptionComparison found = compared(plain(5), option);
  EXPECT_EQ(found.pairs, 0);
  EXPECT_EQ(found.headline.code, "compare.headline_none");
  EXPECT_FALSE(
      comparison_json(compare_campaigns({{"a", "", plain(5)}, {"b", "", option}})).empty());
}

TEST(Pairs, pushes_that_were_too_fast_are_counted_and_shown_apart) {
  Campaign option =
      campaign_of(20, [](int i) { return i <= 6 ? 200e3 : 101e3 + 1e3 * (i * 7 % 5); });
  for (int i = 0; i < 6; ++i) option.records[i].quasi_static.judgement = "too fast";
  const OptionComparison found = compared(plain(20), option);
  EXPECT_EQ(found.not_slow_enough, 6);
  EXPECT_TRUE(has(text_of(found.headline), "6 pushed too fast"));
  EXPECT_EQ(peak_of(found).slow_enough, 14);
  EXPECT_NEAR(peak_of(found).difference_slow_enough.value, 1e3, 1e-6);
  EXPECT_GT(peak_of(found).difference.value, 20e3);
}

// --- modes, inputs -------------------------------------------------------------------------------

TEST(Pairs, changed_modes_are_tested_mode_by_mode) {
  Campaign option = plain(20);
  for (int i = 0; i < 8; ++i) option.records[i].failure_mode.name = "FM-4";
  const ModeTable modes = compared(plain(20), option).modes;
  EXPECT_EQ(modes.modes, (std::vector<std::string>{"FM-1", "FM-4"}));
  EXPECT_EQ(modes.count, (std::vector<std::vector<int>>{{12, 8}, {0, 0}}));
  EXPECT_EQ(modes.changed.size(), 8U);
  EXPECT_EQ(modes.changed[0].sample, 1);
  EXPECT_EQ(modes.shift[1].came, 8);
  EXPECT_NEAR(modes.shift[1].p, 2.0 / 256, 1e-12);           // McNemar, exact: 8 of 8 one way
  EXPECT_NEAR(modes.shift[1].p_adjusted, 4.0 / 256, 1e-12);  // of two modes
  // as many there as back: shares stay, single walls do not
  Campaign swapped = plain(20), base = plain(20);
  for (int i = 0; i < 8; ++i) (i % 2 ? swapped : base).records[i].failure_mode.name = "FM-4";
  const ModeTable both = compared(base, swapped).modes;
  EXPECT_EQ(both.changed.size(), 8U);
  EXPECT_EQ(both.p, 1);
}

TEST(Pairs, groups_of_modes_shift_as_one) {
  Campaign base = plain(20), option = plain(20);
  for (int i = 0; i < 6; ++i) option.records[i].failure_mode.name = "FM-2";
  for (int i = 6; i < 9; ++i) option.records[i].failure_mode.name = "FM-4";
  const ModeTable modes = compared(base, option).modes;
  EXPECT_EQ(modes.changed.size(), 9U);
  ASSERT_EQ(modes.group_shift.size(), 2U);
  EXPECT_EQ(modes.group_shift[0].mode, "FM-1 + FM-2");  // FM-1 to FM-2 is no change here
  EXPECT_EQ(modes.group_shift[0].went, 3);
  EXPECT_DOUBLE_EQ(modes.group_shift[1].share_difference.value, 3.0 / 20);
}

TEST(Pairs, a_mode_that_is_unclear_is_no_other_mode) {
  Campaign base = plain(20), option = plain(20);
  for (SampleRecord& record : option.records) record.failure_mode.name = "unclear";
  const OptionComparison none = compared(base, option);
  EXPECT_EQ(none.modes.unclear, 20);
  EXPECT_TRUE(none.modes.changed.empty());
  EXPECT_TRUE(std::isnan(none.modes.share_changed.value));
  EXPECT_TRUE(has(text_of(none.headline), "no pair has a failure mode named on both sides"));
  for (SampleRecord& record : base.records) record.failure_mode.name = "unclear";
  EXPECT_FALSE(has(text_of(compared(base, option).headline), "changes in none"));
  // some: the others are counted, the unclear ones told apart
  base = plain(20), option = plain(20);
  for (int i = 0; i < 8; ++i) option.records[i].failure_mode.name = i < 3 ? "FM-4" : "unclear";
  const OptionComparison some = compared(base, option);
  EXPECT_EQ(some.modes.unclear, 5);
  EXPECT_EQ(some.modes.shift[0].went, 3);
  EXPECT_EQ(some.modes.shift[0].base, 20);
  EXPECT_NEAR(some.modes.p, 0.5, 1e-12);  // 3 of 3 one way, two modes
  EXPECT_EQ(some.modes.changed.size(), 3U);
  EXPECT_DOUBLE_EQ(some.modes.share_changed.value, 0.2);
  EXPECT_TRUE(has(text_of(some.headline), "changes in 3, 5 whose mode is unclear"))
      << text_of(some.headline);
}

TEST(Pairs, who_gains_is_found_against_each_input) {
  // weak samples gain more: difference 40 - x
  const Campaign base = campaign_of(30, [](int) { return 100.0; });
  const Campaign option = campaign_of(30, [](int i) { return 140.0 - i; });
  const PairedResponse peak = peak_of(compared(base, option));
  ASSERT_EQ(peak.gain.size(), 1U);
  EXPECT_EQ(peak.gain[0].spearman.value, -1);
  EXPECT_NEAR(peak.gain[0].slope.value, -std::sqrt(30 * 31 / 12.0), 1e-9);
  EXPECT_NEAR(peak.gain[0].low_third.value, 40 - 5.5, 1e-9);
  EXPECT_NEAR(peak.gain[0].high_third.value, 40 - 25.5, 1e-9);
  EXPECT_LT(peak.gain[0].p_adjusted, 1e-6);
}

TEST(Pairs, several_tests_need_more_each) {
  const std::vector<double> p = study::holm({0.01, kUnset, 0.04, 0.03});
  EXPECT_DOUBLE_EQ(p[0], 0.03);
  EXPECT_TRUE(std::isnan(p[1]));
  EXPECT_DOUBLE_EQ(p[3], 0.06);
  EXPECT_DOUBLE_EQ(p[2], 0.06);  // never below one that was smaller before
  EXPECT_NEAR(study::sign_test(9, 1), 2 * 11.0 / 1024, 1e-12);
  EXPECT_NEAR(study::sign_test(9, 1, 4), 2 * 3473.0 / 16384, 1e-12);  // as if 9 against 5
  EXPECT_TRUE(std::isnan(study::sign_test(0, 0)));
}

TEST(Pairs, modes_that_were_read_at_other_displacements_are_told) {
  Campaign base = plain(20), option = plain(20);
  for (Campaign* campaign : {&base, &option})
    for (SampleRecord& record : campaign->records) record.failure_mode.read_at = 0.04;
  option.records[0].failure_mode.read_at = 0.0401;  // the same state
  for (const Message& note : compared(base, option).notes)
    EXPECT_NE(note.code, "compare.modes_read_apart");
  for (int i = 0; i < 5; ++i) option.records[i].failure_mode.read_at = 0.021;
  for (int i = 0; i < 3; ++i) option.records[i].failure_mode.name = "FM-4";
  option.records[4].failure_mode.name = "unclear";  // has no name to change
  const OptionComparison found = compared(base, option);
  EXPECT_EQ(found.modes.read_apart, 4);
  EXPECT_EQ(found.modes.changed_apart, 3);
  ASSERT_FALSE(found.notes.empty());
  EXPECT_TRUE(has(text_of(found.notes.back()), "in 4 of 19 pairs the failure modes were read"))
      << text_of(found.notes.back());
}

TEST(Pairs, a_sure_change_is_not_said_to_be_0) {
  const Campaign base = plain(30);
  Campaign option = plain(30);
  for (int i = 0; i < 30; ++i) option.records[i].responses.peak_reaction *= 1 + 1e-4 * (2 + i % 3);
  const std::string said = text_of(compared(base, option).headline);
  EXPECT_TRUE(has(said, "+0.03 % peak force (95 %: +0.03 to +0.03 %)")) << said;
}

TEST(Pairs, settings_in_another_order_are_a_change) {
  Campaign base = plain(6), option = plain(6);
  base.study.settings = {"stage.push.damping=0.2", "stage.push.damping=0.8"};
  option.study.settings = {"stage.push.damping=0.8", "stage.push.damping=0.2"};
  EXPECT_EQ(compared(base, option).changes, std::vector<std::string>{"stage.push.damping=0.2"});
  // of a table around a key the last counts too
  base.study.settings = {"a.b=1", "a={b = 2}"};
  option.study.settings = {"a={b = 2}", "a.b=1"};
  EXPECT_EQ(compared(base, option).changes, std::vector<std::string>{"a.b=1"});
  // the same in effect is none
  option.study.settings = {"x=1", "a.b=1", "a={b = 2}"};
  base.study.settings = {"a.b=1", "a={b = 2}", "x=1"};
  EXPECT_TRUE(compared(base, option).changes.empty());
}

// --- other samples -------------------------------------------------------------------------------

TEST(Pairs, samples_of_another_seed_are_refused_with_the_first_difference) {
  const std::string why = refusal(sample_campaign(20, 1), sample_campaign(20, 2));
  EXPECT_TRUE(has(why, "sample 1 has fc = ")) << why;
  EXPECT_TRUE(has(why, "[[variant]]")) << why;
}

TEST(Pairs, fields_of_another_seed_are_other_walls) {
  Campaign base = plain(6), other = plain(6);
  base.study.seed = 1, other.study.seed = 2;
  EXPECT_EQ(refusal(base, other), "");  // equal inputs, whatever seed drew them
  StudyField field;
  field.name = "ft";
  other.study.field = {field};
  EXPECT_TRUE(
      has(refusal(base, other), "random fields are drawn from seed = 1 in the base, 2 here"));
  std::swap(base.study.field, other.study.field);
  EXPECT_TRUE(has(refusal(base, other), "[[variant]]"));
  other.study.field = base.study.field;
  other.study.seed = 1;
  EXPECT_EQ(refusal(base, other), "");
  base.study.field[0].follows = other.study.field[0].follows = true;  // nothing is drawn
  other.study.seed = 2;
  EXPECT_EQ(refusal(base, other), "");
}

TEST(Pairs, inputs_must_be_the_same_ones) {
  Campaign other = plain(6);
  other.samples.column[0].name = "y";
  EXPECT_TRUE(has(refusal(plain(6), other), "x is drawn in the base and not here (y)"));
  Campaign unit = plain(6);
  unit.samples.column[0].si_unit = "m";
  EXPECT_TRUE(has(refusal(plain(6), unit), "x is in Pa in the base"));
  Campaign bit = plain(6);
  bit.samples.value[3][0] = std::nextafter(4.0, 5.0);
  EXPECT_TRUE(has(refusal(plain(6), bit), "sample 4 has x = 4 Pa"));
  // shown in another unit it is the same; a dependent is not drawn
  Campaign shown = plain(6);
  shown.samples.column[0].unit = "kPa", shown.samples.column[0].to_unit = 1e-3;
  shown.samples.column.push_back({"c", "", "Pa", "Pa", 1, 0, false});
  for (auto& row : shown.samples.value) row.push_back(1);
  EXPECT_EQ(refusal(plain(6), shown), "");
}

TEST(Pairs, of_designs_of_other_sizes_the_common_samples_count) {
  const OptionComparison found = compared(plain(20), plain(12));
  EXPECT_EQ(found.pairs, 12);
  EXPECT_TRUE(found.lost.empty());
  EXPECT_EQ(found.notes.back().code, "compare.other_size");
}

TEST(Pairs, one_store_is_not_two) {
  const scenes::TemporaryFolder folder;
  std::filesystem::create_directories(folder / "a");
  const Campaign same = plain(5);
  try {
    static_cast<void>(
        compare_campaigns({{"a", folder / "a", same}, {"b", folder / "a/../a", same}}));
    FAIL();
  } catch (const InputError& error) {
    EXPECT_TRUE(has(error.what(), "is the same folder as"));
  }
  EXPECT_THROW(static_cast<void>(compare_campaigns({{"a", "", same}})), InputError);
}

TEST(Pairs, of_made_up_walls_have_finite_numbers_in_json) {
  const Campaign base = sample_campaign(60);
  Campaign option = base;
  for (SampleRecord& record : option.records) record.responses.peak_reaction *= 1.12;
  const PairedComparison comparison =
      compare_campaigns({{"base", "a", base}, {"tie", "b", option}});
  const auto json = nlohmann::json::parse(comparison_json(comparison));
  const auto& peak = json["option"][0]["response"]["peak_reaction_kN"];
  EXPECT_NEAR(peak["ratio"].get<double>(), 1.12, 1e-9);
  EXPECT_EQ(peak["larger"], 60);
  EXPECT_EQ(peak["gain"].size(), 5U);
  EXPECT_EQ(peak["pair"]["base"]["value"].size(), 60U);
  EXPECT_TRUE(has(json["option"][0]["headline"].get<std::string>(), "+12.0 % peak force"));
}

}  // namespace
}  // namespace wythe::comparison_test
