// What is read off a curve, on hand-made curves, and the verdict on the speed of a push.
#include "dynamics/responses.h"

#include <gtest/gtest.h>

#include <cmath>
#include <utility>
#include <vector>

#include "dynamics/stage_runner.h"
#include "scenes/scenes.h"
#include "wythe/result.h"

namespace wythe {
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

TEST(Responses, peak_is_the_largest_reaction) {
  const Responses r = read_responses(curve_of({{0, 0}, {1, 60}, {2, 100}, {3, 90}, {4, 100}}));
  EXPECT_EQ(r.peak_reaction, 100);
  EXPECT_EQ(r.displacement_at_peak, 2);  // the first of equals
}

TEST(Responses, displacement_at_80_is_the_first_crossing_after_the_peak) {
  // 50 before the peak does not count; 90 -> 60 crosses 80 at a third; the rise to 95 later neither
  const Responses r =
      read_responses(curve_of({{0, 0}, {1, 50}, {2, 100}, {3, 90}, {6, 60}, {7, 95}}));
  EXPECT_DOUBLE_EQ(r.displacement_at_80, 4);
  EXPECT_FALSE(r.censored_80);
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

TEST(Responses, initial_stiffness_is_the_secant_between_10_and_30_percent) {
  // slope 100 up to 20, then 50: 10 at 0.1, 30 at 0.4
  const Responses r = read_responses(curve_of({{0, 0}, {0.2, 20}, {1.8, 100}}));
  EXPECT_NEAR(r.initial_stiffness, 20 / 0.3, 1e-9);
}

TEST(Responses, empty_curve_gives_zeros) {
  const Responses r = read_responses({});
  EXPECT_EQ(r.peak_reaction, 0);
  EXPECT_TRUE(r.censored_80);
}

Result pushed(double drag) {
  Result result;
  result.curve = curve_of({{0, 0}, {1, 50}, {2, 100}, {3, 90}});
  for (CurveRow& row : result.curve) {
    row.base_shear = row.reaction - drag * 100;
    row.kinetic_ratio = 0.01;
    row.unbalance_ratio = 0.002;
  }
  result.responses = read_responses(result.curve);
  result.energy.drive = 10;
  result.energy.damping = 3;
  return result;
}

TEST(QuasiStatic, verdict_follows_the_drag) {
  EXPECT_EQ(dynamics::judge_quasi_static(pushed(0.005)).verdict.substr(0, 11), "slow enough");
  EXPECT_EQ(dynamics::judge_quasi_static(pushed(0.02)).verdict.substr(0, 6), "usable");
  EXPECT_EQ(dynamics::judge_quasi_static(pushed(0.10)).verdict.substr(0, 8), "too fast");
}

TEST(QuasiStatic, numbers_leave_out_the_start) {
  Result result = pushed(0.03);
  result.curve[0].kinetic_ratio = 1e3;  // where no work is done yet
  const QuasiStatic q = dynamics::judge_quasi_static(result);
  EXPECT_NEAR(q.shear_gap, 0.03, 1e-12);
  EXPECT_NEAR(q.kinetic_ratio_max, 0.01, 1e-15);
  EXPECT_NEAR(q.unbalance_ratio_mean, 0.002, 1e-15);
  EXPECT_NEAR(q.damping_share, 0.3, 1e-15);
}

TEST(QuasiStatic, no_curve_is_no_push) {
  EXPECT_EQ(dynamics::judge_quasi_static({}).verdict, "no push");
}

TEST(Events, peak_and_80_percent_come_in_order) {
  Result result;
  result.curve = curve_of({{0, 0}, {2, 100}, {4, 60}});
  result.responses = read_responses(result.curve);
  result.events.push_back({"first crushing", 3.5, 70, ""});
  dynamics::add_curve_events(result);
  ASSERT_EQ(result.events.size(), 3U);
  EXPECT_EQ(result.events[0].name, "peak");
  EXPECT_EQ(result.events[1].name, "80 % of the peak");
  EXPECT_EQ(result.events[2].name, "first crushing");
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
  stage.spec.until = 5;
  EXPECT_EQ(dynamics::driven_path(stage), 5);
  stage.spec.targets = {1, -1, 2};
  EXPECT_EQ(dynamics::driven_path(stage), 1 + 2 + 3);
}

}  // namespace
}  // namespace wythe
