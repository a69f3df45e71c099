// Responses from artificial curves, and the verdict on the speed of a push.
#include "dynamics/meters/responses.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <iterator>
#include <nlohmann/json.hpp>
#include <string>
#include <utility>
#include <vector>

#include "dynamics/stages/stage_run.h"
#include "scenes/sample_run.h"
#include "scenes/scenes.h"
#include "wythe/parts/io.h"
#include "wythe/parts/result.h"
#include "wythe/parts/slow_push.h"

namespace wythe::responses_test {
namespace {

std::vector<CurveRow> curve_of(const std::vector<std::pair<double, double>>& points) {
  std::vector<CurveRow> curve;
  for (const auto& [displacement, reaction] : points) {
    CurveRow row;
    row.displacement = displacement;
    row.reaction = row.base_shear = reaction;
    curve.push_back(row);
  }
  return curve;
}

// The push of a wall that softens: 100 at 2, down to 50 at 4, in rows of 0.02; base shear `felt` of it.
std::vector<CurveRow> fine_curve(double felt = 1) {
  std::vector<CurveRow> curve;
  for (int i = 0; i <= 200; ++i) {
    CurveRow row;
    row.displacement = 0.02 * i;
    row.reaction = row.displacement <= 2 ? 50 * row.displacement : 150 - 25 * row.displacement;
    row.base_shear = felt * row.reaction;
    row.work_drive = (i == 0 ? 0.0 : curve.back().work_drive) + 0.02 * row.reaction;
    curve.push_back(row);
  }
  return curve;
}

TEST(Balance, a_rebound_is_no_capacity) {
  auto curve = fine_curve();
  curve[90].reaction = 240;  // of one row, which the ground does not feel
  const Responses r = read_responses(curve);
  EXPECT_DOUBLE_EQ(r.peak_reaction, 100);
  EXPECT_DOUBLE_EQ(r.displacement_at_peak, 2);
  EXPECT_DOUBLE_EQ(r.peak_raw, 240);
  EXPECT_DOUBLE_EQ(r.displacement_at_peak_raw, 1.8);
}

TEST(Balance, a_chance_meeting_of_both_forces_is_no_balance) {
  // reaction and base shear vibrate against each other and are equal in one row of eight
  auto curve = fine_curve();
  for (std::size_t i = 1; i < curve.size(); ++i) {
    const double swing = std::sin(M_PI * static_cast<double>(i) / 8);
    curve[i].reaction *= 1 + 0.2 * swing;
    curve[i].base_shear *= 1 - 0.2 * swing;
  }
  const Responses r = read_responses(curve);
  EXPECT_TRUE(std::isnan(r.peak_reaction));
  EXPECT_TRUE(std::isnan(r.displacement_at_80));
  EXPECT_TRUE(std::isnan(r.bilinear.ductility));
  EXPECT_GT(r.peak_raw, 100);
  EXPECT_EQ(r.peak_reason.number("limit_percent"), 2) << r.peak_reason;
}

TEST(Balance, rows_ten_times_finer_or_coarser_give_the_same_capacity) {
  const auto rows_of = [](double width) {
    std::vector<CurveRow> curve;
    for (int i = 0; width * i <= 4 + 1e-9; ++i) {
      CurveRow row;
      row.displacement = width * i;
      row.reaction = row.displacement <= 2 ? 50 * row.displacement : 150 - 25 * row.displacement;
      // drag at the start that has died out at 1
      row.base_shear = row.reaction * (1 - 0.1 * std::fmax(0.0, 1 - row.displacement));
      curve.push_back(row);
    }
    return curve;
  };
  for (const double width : {0.2, 0.02, 0.002})
    EXPECT_NEAR(read_responses(rows_of(width)).peak_reaction, 100, 1e-9) << width;
}

TEST(Balance, base_shear_above_the_reaction_is_out_of_balance_too) {
  EXPECT_TRUE(std::isnan(read_responses(fine_curve(1.03)).peak_reaction));
  EXPECT_DOUBLE_EQ(read_responses(fine_curve(1.019)).peak_reaction, 100);
}

TEST(Balance, a_dip_of_the_reaction_alone_is_no_fall) {
  auto curve = fine_curve();
  curve[105].reaction =
      10;  // the wall rebounds once after its peak; the ground feels nothing of it
  const Responses r = read_responses(curve);
  EXPECT_NEAR(r.displacement_at_80, 2.8, 1e-9);
}

TEST(Load, capacity_is_the_load_carried_and_nothing_is_read_beyond) {
  const auto curve = curve_of({{0, 0}, {1e-3, 40}, {2e-3, 80}, {90e-3, 85}});
  const Responses fell =
      read_responses(curve, {.collapse = as_text("the wall keeps moving"), .carried = 80});
  EXPECT_EQ(fell.peak_reaction, 80);
  EXPECT_FALSE(fell.censored_peak);
  EXPECT_TRUE(std::isnan(fell.displacement_at_80));
  EXPECT_TRUE(std::isnan(fell.bilinear.ductility));
  EXPECT_TRUE(std::isnan(fell.initial_stiffness));
  EXPECT_EQ(why_no_stiffness(fell).code, "stiffness.load");
  EXPECT_TRUE(read_responses(curve, {.carried = 85}).censored_peak);  // it never fell
}

TEST(Load, none_carried_is_no_capacity) {
  const Responses r = read_responses(curve_of({{0, 0}, {1, 1}}), {.carried = 0});
  EXPECT_TRUE(std::isnan(r.peak_reaction));
  EXPECT_FALSE(r.peak_reason.empty());
}

TEST(InitialStiffness, comes_from_the_rise_whatever_the_rows_are) {
  // linear, 100 a unit up to 20, then 50: rows too coarse to see it
  std::vector<RisePoint> rise;
  for (double d = 1e-3; d < 2; d *= 1.02)
    rise.push_back({d, d <= 0.2 ? 100 * d : 20 + 44.4 * (d - 0.2)});
  const auto coarse = curve_of({{0, 0}, {1, 55.5}, {2, 100}, {3, 90}});
  const double secant = 20 / (0.2 + 10 / 44.4 - 0.1);  // 30 % at 0.425, 10 % at 0.1
  EXPECT_NEAR(read_responses(coarse, {.rise = rise}).initial_stiffness, secant, 0.1 * secant);
  std::vector<RisePoint> straight;
  for (double d = 1e-3; d < 2; d *= 1.02) straight.push_back({d, 50 * d});
  EXPECT_NEAR(read_responses(coarse, {.rise = straight}).initial_stiffness, 50, 1e-9);
}

TEST(InitialStiffness, of_a_wall_already_pushed_is_not_known) {
  // a second push: 60 stand at its start, so 10 and 30 % of the peak are passed in its first window
  std::vector<RisePoint> rise;
  for (double d = 1e-3; d < 2; d *= 1.02) rise.push_back({d, 60 + 20 * d});
  const Responses r =
      read_responses(curve_of({{0, 0}, {1, 80}, {2, 100}, {3, 90}}), {.rise = rise});
  EXPECT_DOUBLE_EQ(r.peak_reaction, 100);
  EXPECT_TRUE(std::isnan(r.initial_stiffness));
  EXPECT_TRUE(std::isnan(r.bilinear.ductility));
  EXPECT_EQ(why_no_stiffness(r).code, "stiffness.no_rise");
}

TEST(Responses, peak_is_the_largest_reaction) {
  const Responses r = read_responses(curve_of({{0, 0}, {1, 60}, {2, 100}, {3, 90}, {4, 100}}));
  EXPECT_EQ(r.peak_reaction, 100);
  EXPECT_EQ(r.displacement_at_peak, 2);  // the first of equals
}

TEST(Responses, displacement_at_80_is_the_first_fall_that_lasts) {
  // 50 before the peak does not count; 90 -> 60 crosses 80 at a third; back at 80 at 6.57, past 1.1 x 4
  const Responses r =
      read_responses(curve_of({{0, 0}, {1, 50}, {2, 100}, {3, 90}, {6, 60}, {7, 95}}));
  EXPECT_DOUBLE_EQ(r.displacement_at_80, 4);
  EXPECT_FALSE(r.censored_80);
  EXPECT_DOUBLE_EQ(r.first_fall_80, 4);
  EXPECT_TRUE(r.censored_last_80);  // it carries 95 at the end
  EXPECT_DOUBLE_EQ(r.last_fall_80, 7);
  EXPECT_TRUE(r.dips.empty());
}

// 100 at 2, 81 at 10; from there down to `low` and back to 81 at `back`, then a fall at 14 for good.
std::vector<CurveRow> with_a_dip(double low, double back) {
  return curve_of({{0, 0},
                   {2, 100},
                   {10, 81},
                   {10.1, low},
                   {back, low},
                   {back + 0.1, 82},
                   {14, 81},
                   {14.1, 0},
                   {20, 0}});
}

TEST(Lasting, a_dip_that_is_made_good_soon_is_named_and_not_counted) {
  const Responses r = read_responses(with_a_dip(60, 10.8));
  const double fell = 10 + 0.1 / 21, back = 10.8 + 0.1 * 20 / 22;
  EXPECT_NEAR(r.first_fall_80, fell, 1e-12);
  EXPECT_NEAR(r.displacement_at_80, 14 + 0.1 / 81, 1e-12);
  EXPECT_DOUBLE_EQ(r.last_fall_80, r.displacement_at_80);
  EXPECT_FALSE(r.censored_80);
  ASSERT_EQ(r.dips.size(), 1U);
  EXPECT_NEAR(r.dips[0].from, fell, 1e-12);
  EXPECT_NEAR(r.dips[0].back, back, 1e-12);
  EXPECT_DOUBLE_EQ(r.dips[0].lowest, 0.6);
  EXPECT_DOUBLE_EQ(r.bilinear.ultimate_displacement, r.displacement_at_80);
}

TEST(Lasting, a_dip_of_more_than_the_stated_share_is_the_fall) {
  const double fell = 10 + 0.1 / 21;
  for (const double longer : {-0.01, 0.01}) {
    const double back = (1 + kLastingShare) * fell + longer - 0.1 * 20 / 22;
    const Responses r = read_responses(with_a_dip(60, back));
    if (longer > 0)
      EXPECT_NEAR(r.displacement_at_80, fell, 1e-12);
    else
      EXPECT_GT(r.displacement_at_80, 14);
    EXPECT_GT(r.last_fall_80, 14);
  }
}

TEST(Lasting, a_dip_before_the_peak_is_named_and_moves_no_reading) {
  // 100 at 2, down to 60, 100 again at 3.1 and 120 at 4; straight down to 0 at 16 from there
  const auto curve =
      curve_of({{0, 0}, {2, 100}, {2.1, 60}, {3, 60}, {3.1, 100}, {4, 120}, {16, 0}, {20, 0}});
  const Responses r = read_responses(curve);
  ASSERT_EQ(r.dips.size(), 1U);
  EXPECT_TRUE(r.dips[0].before_peak);
  EXPECT_EQ(r.dips[0].fraction, 0.8);
  EXPECT_NEAR(r.dips[0].from, 2.05, 1e-12);
  EXPECT_NEAR(r.dips[0].back, 3.05, 1e-12);
  EXPECT_NEAR(r.dips[0].lowest, 0.6, 1e-12);
  EXPECT_NEAR(r.displacement_at_80, 6.4, 1e-12);
  EXPECT_NEAR(r.first_fall_80, 6.4, 1e-12);
  // one after it is told apart
  EXPECT_FALSE(read_responses(with_a_dip(60, 10.8)).dips.at(0).before_peak);
}

TEST(Lasting, what_is_no_dip_before_the_peak) {
  const auto dips = [](const std::vector<CurveRow>& curve) { return read_responses(curve).dips; };
  // where the push begins, below a fifth of the peak
  EXPECT_TRUE(dips(curve_of({{0, 0}, {0.1, 19}, {0.2, 1}, {0.3, 19}, {2, 100}, {9, 0}})).empty());
  // to 81 of 100, and a rise that only slows down
  EXPECT_TRUE(dips(curve_of({{0, 0}, {1, 100}, {1.5, 81}, {2, 120}, {9, 0}})).empty());
  EXPECT_TRUE(dips(curve_of({{0, 0}, {1, 80}, {2, 80}, {3, 100}, {9, 0}})).empty());
  // a rebound: the reaction or the base shear alone jumps up, or dips
  for (const auto& [reaction, shear] : {std::pair(130, 70), {70, 130}, {10, 75}, {75, 10}}) {
    auto curve = curve_of({{0, 0}, {1, 75}, {1.4, 75}, {1.5, 75}, {1.6, 75}, {3, 100}, {9, 0}});
    curve[3].reaction = reaction, curve[3].base_shear = shear;
    EXPECT_TRUE(dips(curve).empty()) << reaction << " " << shear;
  }
}

TEST(Lasting, dips_that_follow_each_other_closely_are_one) {
  // a saw: below 80 for 0.3, back for 0.1, again and again from 10 to 12: more than a tenth of 10 in all
  std::vector<std::pair<double, double>> points = {{0, 0}, {2, 100}, {10, 80}};
  for (double d = 10; d < 12 - 1e-9; d += 0.4) {
    points.insert(points.end(), {{d + 0.01, 70}, {d + 0.29, 70}, {d + 0.3, 80}, {d + 0.4, 80}});
  }
  points.insert(points.end(), {{14, 80}, {15, 0}, {16, 0}, {20, 0}});
  const Responses saw = read_responses(curve_of(points));
  EXPECT_DOUBLE_EQ(saw.displacement_at_80, 10);
  EXPECT_FALSE(saw.censored_80);
  EXPECT_DOUBLE_EQ(saw.last_fall_80, 14);
  EXPECT_TRUE(saw.dips.empty());
  // the same teeth with long ways between them are dips
  const Responses teeth = read_responses(curve_of({{0, 0},
                                                   {2, 100},
                                                   {10, 80},
                                                   {10.01, 70},
                                                   {10.29, 70},
                                                   {10.3, 80},
                                                   {11, 80},
                                                   {11.01, 70},
                                                   {11.29, 70},
                                                   {11.3, 80},
                                                   {14, 80},
                                                   {15, 0},
                                                   {20, 0}}));
  EXPECT_DOUBLE_EQ(teeth.displacement_at_80, 14);
  EXPECT_EQ(teeth.dips.size(), 2U);
}

TEST(Lasting, a_return_too_short_to_be_held_at_the_end_makes_no_dip) {
  // below 80 from 10 to 10.6, back for 0.2 when the push ends: had it gone on, it might have fallen at once
  const Responses r = read_responses(
      curve_of({{0, 0}, {2, 100}, {10, 80}, {10.01, 70}, {10.59, 70}, {10.6, 80}, {10.8, 80}}));
  EXPECT_DOUBLE_EQ(r.displacement_at_80, 10);
  EXPECT_TRUE(r.censored_80);
  EXPECT_TRUE(r.dips.empty());
}

// A push that its rule stopped at 0.9, and a wall that falls in a stage after it: what the push did not show it did not
// show.
TEST(Lasting, a_fall_after_the_push_is_none_of_it) {
  Model model;
  model.stages.resize(3);
  model.stages[1].spec.action = PushStage{};
  model.stages[2].spec.action = HoldStage{};
  Result result;
  result.curve = curve_of({{0, 0}, {2, 100}, {10, 89}, {11.1, 88}});
  result.status = SolveStatus::kCollapsed;
  result.reason = {"block.moved_away"};
  const auto read = [&](std::size_t stages) {
    result.stages.assign(stages, {});
    return read_responses(result.curve, reading_of(model, result));
  };
  EXPECT_FALSE(read(2).censored_80);  // it fell as it was pushed
  const Responses later = read(3);
  EXPECT_TRUE(later.censored_80);
  EXPECT_TRUE(later.collapse.censored);
  for (const FallTo& fall : later.drift_capacity)
    EXPECT_EQ(fall.censored, fall.fraction < 0.9) << fall.fraction;
}

// A stop at a share is a bound for every share below it, in each reading.
TEST(Lasting, a_stop_rule_makes_no_fall_below_its_share) {
  const Responses r = read_responses(curve_of({{0, 0}, {2, 100}, {7, 92}, {7.2, 89}, {8, 89}}),
                                     {.fractions = {0.8, 0.5}});
  EXPECT_TRUE(r.censored_80 && r.censored_first_80 && r.censored_last_80 && r.censored_max);
  EXPECT_TRUE(r.collapse.censored && r.bilinear.censored);
  EXPECT_DOUBLE_EQ(r.displacement_at_80, 8);
  for (const FallTo& fall : r.falls)
    EXPECT_TRUE(fall.censored && fall.censored_first && fall.censored_last) << fall.fraction;
  for (const FallTo& fall : r.drift_capacity)
    EXPECT_EQ(fall.censored, fall.fraction < 0.895) << fall.fraction;
}

TEST(Lasting, a_last_fall_not_seen_to_last_is_a_bound) {
  const Responses r =
      read_responses(curve_of({{0, 0}, {2, 100}, {10, 80}, {10.01, 70}, {10.5, 70}}));
  EXPECT_TRUE(r.censored_80);
  EXPECT_TRUE(r.censored_last_80);
  EXPECT_FALSE(r.censored_first_80);
}

TEST(Lasting, a_push_that_ends_in_a_dip_gives_a_bound) {
  auto curve = with_a_dip(60, 10.8);
  curve.resize(5);  // ends at 10.8, 8 % beyond the fall
  const Responses r = read_responses(curve);
  EXPECT_TRUE(r.censored_80);
  EXPECT_NEAR(r.displacement_at_80, 10 + 0.1 / 21, 1e-12);
  EXPECT_FALSE(r.censored_first_80);
  // one that came down fell there for good
  EXPECT_FALSE(read_responses(curve, {.collapse = as_text("a block fell")}).censored_80);
}

TEST(Lasting, capacity_never_shrinks_as_less_force_is_asked_for) {
  // a seeded walk down with jumps of both signs: d(r) by each reading grows as r falls, and first <= lasting <= last
  std::uint32_t seed = 7;
  const auto random = [&] { return (seed = seed * 1664525U + 1013904223U) / 4294967296.0; };
  for (int curve = 0; curve < 200; ++curve) {
    std::vector<std::pair<double, double>> points = {{0, 0}, {1, 100}};
    for (double d = 1.1; d < 12; d += 0.4 * random())
      points.emplace_back(d, std::fmax(0, 100 * (1 - d / 12) + 80 * (random() - 0.5)));
    const Responses r = read_responses(curve_of(points));
    ASSERT_EQ(r.drift_capacity.size(), std::size(kSharesLeft));
    for (std::size_t k = 0; k < r.drift_capacity.size(); ++k) {
      const FallTo& fall = r.drift_capacity[k];
      EXPECT_LE(fall.first, fall.displacement);
      EXPECT_LE(fall.displacement, fall.last);
      if (k == 0) continue;
      EXPECT_GE(fall.first, r.drift_capacity[k - 1].first);
      EXPECT_GE(fall.displacement, r.drift_capacity[k - 1].displacement);
      EXPECT_GE(fall.last, r.drift_capacity[k - 1].last);
    }
  }
}

TEST(Lasting, a_knife_edge_is_told) {
  // slides at 0.78 of its peak for ever: 80 % at 2.2, 75 % not within 40
  const Responses r = read_responses(curve_of({{0, 0}, {2, 100}, {2.22, 78}, {40, 78}}));
  EXPECT_NEAR(r.displacement_at_80, 2.2, 1e-9);
  const auto decides = [](const Responses& read) { return threshold_decides(read.drift_capacity); };
  EXPECT_EQ(decides(r), true);
  EXPECT_EQ(decides(read_responses(curve_of({{0, 0}, {2, 100}, {12, 0}}))), false);
  // a bound below 1.5 times says nothing, nor does a wall without a peak, or without a curve
  EXPECT_EQ(decides(read_responses(curve_of({{0, 0}, {2, 100}, {2.22, 78}, {3, 78}}))),
            std::nullopt);
  EXPECT_EQ(decides(read_responses(std::vector<CurveRow>(3))), std::nullopt);
  EXPECT_EQ(decides({}), std::nullopt);
}

TEST(Responses, displacement_at_80_is_censored_where_the_force_stays) {
  const Responses r = read_responses(curve_of({{0, 0}, {2, 100}, {9, 81}}));
  EXPECT_DOUBLE_EQ(r.displacement_at_80, 9);
  EXPECT_TRUE(r.censored_80);
}

TEST(Responses, displacement_max_is_where_the_force_stays_below_a_fifth) {
  const auto fallen = curve_of({{0, 0}, {1, 100}, {2, 10}, {3, 30}, {4, 15}, {5, 5}});
  EXPECT_DOUBLE_EQ(read_responses(fallen).displacement_max, 4);
  EXPECT_FALSE(read_responses(fallen).censored_max);
  const auto carried = curve_of({{0, 0}, {1, 100}, {2, 10}, {3, 30}});
  EXPECT_DOUBLE_EQ(read_responses(carried).displacement_max, 3);
  EXPECT_TRUE(read_responses(carried).censored_max);
}

TEST(Responses, initial_stiffness_is_the_secant_between_10_and_30_percent_where_rows_are_few) {
  // slope 100 up to 20, then 50: 10 at 0.1, 30 at 0.4
  const Responses r = read_responses(curve_of({{0, 0}, {0.2, 20}, {1.8, 100}}));
  EXPECT_NEAR(r.initial_stiffness, 20 / 0.3, 1e-9);
}

TEST(Responses, empty_curve_gives_zeros) {
  const Responses r = read_responses({});
  EXPECT_EQ(r.peak_reaction, 0);
  EXPECT_TRUE(r.censored_80);
}

// --- responses of closed form
// A curve with a drift height of 2 m, so that drift = displacement / 2.
std::vector<CurveRow> over_two_metres(std::vector<CurveRow> curve) {
  for (CurveRow& row : curve) row.drift = row.displacement / 2;
  return curve;
}

TEST(Falls, each_fraction_has_its_own_crossing) {
  // a straight softening line from 100 at 2 to 0 at 12: 10 a unit
  const auto line = over_two_metres(curve_of({{0, 0}, {2, 100}, {12, 0}}));
  const Responses r = read_responses(line, {.fractions = {0.9, 0.5, 0.25}});
  ASSERT_EQ(r.falls.size(), 3U);
  EXPECT_DOUBLE_EQ(r.falls[0].displacement, 3);
  EXPECT_DOUBLE_EQ(r.falls[1].displacement, 7);
  EXPECT_DOUBLE_EQ(r.falls[2].displacement, 9.5);
  EXPECT_DOUBLE_EQ(r.falls[1].drift, 3.5);
  for (const FallTo& fall : r.falls) EXPECT_FALSE(fall.censored);
}

TEST(Falls, default_fractions_are_80_and_50_percent) {
  const Responses r = read_responses(curve_of({{0, 0}, {2, 100}, {12, 0}}));
  ASSERT_EQ(r.falls.size(), 2U);
  EXPECT_DOUBLE_EQ(r.falls[0].displacement, r.displacement_at_80);
  EXPECT_DOUBLE_EQ(r.falls[1].displacement, 7);
}

TEST(Falls, curve_that_never_falls_is_censored_at_its_end) {
  const Responses r = read_responses(curve_of({{0, 0}, {1, 100}, {8, 100}}), {.fractions = {0.99}});
  EXPECT_TRUE(r.falls[0].censored);
  EXPECT_DOUBLE_EQ(r.falls[0].displacement, 8);
  EXPECT_TRUE(r.bilinear.censored);
}

TEST(Drifts, each_displacement_over_the_load_height) {
  const Responses r = read_responses(over_two_metres(curve_of({{0, 0}, {2, 100}, {12, 0}})));
  EXPECT_DOUBLE_EQ(r.load_height, 2);
  EXPECT_DOUBLE_EQ(r.drift_at_peak, 1);
  EXPECT_DOUBLE_EQ(r.drift_at_80, r.displacement_at_80 / 2);
  EXPECT_DOUBLE_EQ(r.drift_max, r.displacement_max / 2);
  EXPECT_DOUBLE_EQ(r.collapse.drift, r.collapse.displacement / 2);
}

TEST(Drifts, no_height_gives_none) {
  const Responses r = read_responses(curve_of({{0, 0}, {2, 100}, {12, 0}}));
  EXPECT_EQ(r.load_height, 0);
  EXPECT_EQ(r.drift_at_80, 0);
}

TEST(Work, triangle_is_its_area) {
  // to the peak 100; on to 80 at 4: 90 x 2 = 180 more; all of it 100 + 500
  const Responses r = read_responses(curve_of({{0, 0}, {2, 100}, {12, 0}}));
  EXPECT_DOUBLE_EQ(r.work_to_peak, 100);
  EXPECT_DOUBLE_EQ(r.work_to_80, 280);
  EXPECT_DOUBLE_EQ(r.work_total, 600);
}

TEST(Work, unloading_gives_work_back) {
  // rows are means over their windows: 50 on the way to 100, 50 on the way back
  const Responses r = read_responses(curve_of({{0, 0}, {2, 50}, {0, 50}}));
  EXPECT_DOUBLE_EQ(r.cyclic.work, 0);
}

TEST(Work, does_not_depend_on_the_rows) {
  // a straight branch in one row or in a hundred
  std::vector<std::pair<double, double>> fine;
  for (int i = 0; i <= 100; ++i) fine.emplace_back(0.02 * i, i);
  for (int i = 1; i <= 100; ++i) fine.emplace_back(2 + 0.1 * i, 100 - i);
  const Responses r = read_responses(curve_of(fine));
  EXPECT_NEAR(r.work_to_80, 280, 1e-9);  // round-off of 130 sums
  EXPECT_NEAR(r.bilinear.force,
              read_responses(curve_of({{0, 0}, {2, 100}, {12, 0}})).bilinear.force, 1e-9);
}

TEST(Bilinear, of_an_elastic_plastic_curve_is_the_curve_itself) {
  const Responses r = read_responses(curve_of({{0, 0}, {2, 100}, {10, 100}, {10.001, 0}, {12, 0}}));
  EXPECT_DOUBLE_EQ(r.bilinear.stiffness, 50);
  EXPECT_NEAR(r.bilinear.force, 100, 0.02);  // the fall to 0.8 peak takes 0.0002 of extra path
  EXPECT_NEAR(r.bilinear.yield_displacement, 2, 4e-4);
  EXPECT_NEAR(r.bilinear.ductility, 5, 1e-2);
  EXPECT_FALSE(r.bilinear.censored);
}

TEST(Bilinear, of_a_triangle_follows_from_equal_areas) {
  // ke = 50, du = 4, A = 280: Fu = 50 (4 - sqrt(16 - 11.2))
  const Responses r = read_responses(curve_of({{0, 0}, {2, 100}, {12, 0}}));
  const double force = 50 * (4 - std::sqrt(16 - 11.2));
  EXPECT_DOUBLE_EQ(r.bilinear.ultimate_displacement, 4);
  EXPECT_NEAR(r.bilinear.force, force, 1e-12 * force);
  const double dy = r.bilinear.yield_displacement;
  EXPECT_NEAR(0.5 * force * dy + force * (4 - dy), 280, 1e-9);  // the areas are equal
}

TEST(Bilinear, of_a_straight_line_has_no_plastic_part) {
  const Responses r = read_responses(curve_of({{0, 0}, {2.5, 50}, {5, 100}}));
  EXPECT_NEAR(r.bilinear.force, 100, 1e-5);  // a root at its branch point: half the digits
  EXPECT_NEAR(r.bilinear.ductility, 1, 1e-6);
}

// Circolare 7/2019, C7.3.4.2
TEST(Bilinear, secant_reads_the_curve_at_six_tenths) {
  // soft beyond 0.5 peak: 60 at 0.5 + 10 / 50 x 2.5 = 1
  const Responses r = read_responses(curve_of({{0, 0}, {0.5, 50}, {3, 100}, {9, 70}}));
  EXPECT_NEAR(r.bilinear.stiffness, 60, 1e-12);
}

TEST(Collapse, says_by_what_it_was_told) {
  const auto fallen = curve_of({{0, 0}, {1, 100}, {2, 10}, {5, 5}});
  const Responses low = read_responses(fallen);
  EXPECT_FALSE(low.collapse.censored);
  EXPECT_DOUBLE_EQ(low.collapse.displacement, 2);
  EXPECT_EQ(text_of(low.collapse.criterion), "the reaction stays below 0.2 of its peak");

  const auto held = curve_of({{0, 0}, {1, 100}, {5, 90}});
  const Responses fell = read_responses(held, {.collapse = as_text("block c03 has moved 200 mm")});
  EXPECT_FALSE(fell.collapse.censored);
  EXPECT_DOUBLE_EQ(fell.collapse.displacement, 5);
  EXPECT_EQ(text_of(fell.collapse.criterion), "block c03 has moved 200 mm");
  EXPECT_TRUE(fell.censored_max);  // its definition looks at the reaction only

  EXPECT_TRUE(read_responses(held).collapse.censored);
}

TEST(Responses, noise_moves_them_by_no_more_than_its_size) {
  // +-1 on the straight softening line with 10 a unit: a crossing moves by 0.1 at the most
  std::vector<std::pair<double, double>> rows;
  for (int i = 0; i <= 240; ++i) {
    const double d = 0.05 * i, smooth = d <= 2 ? 50 * d : 120 - 10 * d;
    rows.emplace_back(d, smooth + (i == 0 || i % 2 == 0 ? 0 : 1.0));
  }
  const Responses r = read_responses(curve_of(rows), {.fractions = {0.5}});
  EXPECT_NEAR(r.peak_reaction, 100, 1);
  EXPECT_NEAR(r.falls[0].displacement, 7, 0.2);  // 0.1, and 0.1 as the peak itself may be 1 higher
  EXPECT_NEAR(r.work_total, 600, 12 * 1);        // 1 on at most the whole path of 12
}

// --- where they are shown

TEST(SummaryJson, carries_every_response_with_its_unit) {
  Result result = scenes::sample_result();
  result.responses = read_responses(over_two_metres(curve_of({{0, 0}, {2e-3, 100e3}, {12e-3, 0}})));
  result.features = {{"spandrel_slip", 20e-3, 3e-3}};
  const auto json = nlohmann::json::parse(summary_json(scenes::sample_model(), result));
  EXPECT_DOUBLE_EQ(json["load_height_m"], 2);
  EXPECT_NEAR(json["drift_percent_at_80"], 0.2, 1e-12);
  EXPECT_NEAR(json["work_to_80_percent_J"], 280, 1e-9);
  EXPECT_NEAR(json["falls"][1]["displacement_mm"], 7, 1e-12);
  EXPECT_EQ(json["falls"][1]["fraction"], 0.5);
  EXPECT_NEAR(json["bilinear"]["stiffness_kN_per_mm"], 50, 1e-9);
  EXPECT_NEAR(json["bilinear"]["ultimate_displacement_mm"], 4, 1e-12);
  EXPECT_EQ(json["collapse"]["criterion"], "the reaction stays below 0.2 of its peak");
  EXPECT_EQ(json["features"][0]["name"], "spandrel_slip");
  EXPECT_NEAR(json["features"][0]["value_mm"], 3, 1e-12);
}

// What a mode says of its elements, in summary.json; the page is tested in tests/web.
TEST(FailureModeShown, with_elements_flags_and_other_readings) {
  Result result = scenes::sample_result();
  FailureMode& mode = result.failure_mode;
  ElementSign rocking;
  rocking.state = "rocking";
  rocking.value = 0.8;
  rocking.threshold = 0.5;
  rocking.displacement_first = 10e-3;
  ElementState pier;
  pier.element = "left pier";
  pier.state = "rocking";
  pier.signs = {rocking};
  mode.elements = {pier};
  mode.flags = {{"left pier", "growth of its width", 9, 8, "mm"}};
  mode.sensitivity = {{"FM-5", "10 mm", 10e-3}, {mode.name, "20 mm", 20e-3}};

  const auto json =
      nlohmann::json::parse(summary_json(scenes::sample_model(), result))["failure_mode"];
  EXPECT_NEAR(json["elements"][0]["signs"][0]["displacement_first_mm"], 10, 1e-12);
  EXPECT_TRUE(json["elements"][0]["signs"][0]["holds"]);
  EXPECT_TRUE(json["elements"][0]["displacement_first_mm"].is_null());
  EXPECT_TRUE(json["flags"][0]["raised"]);
  EXPECT_NEAR(json["flags"][0]["margin"], 0.125, 1e-12);
  EXPECT_EQ(json["sensitivity"][0]["name"], "FM-5");
}

TEST(Events, peak_and_80_percent_come_in_order) {
  Result result;
  result.curve = curve_of({{0, 0}, {2, 100}, {4, 60}});
  result.responses = read_responses(result.curve);
  result.events.push_back({{"event.first_crushing"}, 3.5, 70});
  dynamics::add_curve_events(result);
  ASSERT_EQ(result.events.size(), 3U);
  EXPECT_EQ(result.events[0].name.code, "event.peak");
  EXPECT_EQ(result.events[1].name.code, "event.fall_to_80");
  EXPECT_EQ(result.events[2].name.code, "event.first_crushing");
}

TEST(SmoothStep, starts_and_ends_flat) {
  using dynamics::smooth_step;
  EXPECT_EQ(smooth_step(-1), 0);
  EXPECT_EQ(smooth_step(0), 0);
  EXPECT_EQ(smooth_step(0.5), 0.5);
  EXPECT_EQ(smooth_step(1), 1);
  EXPECT_EQ(smooth_step(7), 1);
  EXPECT_LT(smooth_step(1e-3) / 1e-3, 4e-3);
  EXPECT_LT((1 - smooth_step(1 - 1e-3)) / 1e-3, 4e-3);
}

TEST(DrivenPath, adds_up_the_legs_of_a_cyclic_push) {
  Stage stage;
  stage.spec.action = PushStage{.until = 5};
  EXPECT_EQ(dynamics::driven_path(stage), 5);
  stage.spec.get<PushStage>().targets = {1, -1, 2};
  EXPECT_EQ(dynamics::driven_path(stage), 1 + 2 + 3);
}

}  // namespace
}  // namespace wythe::responses_test
