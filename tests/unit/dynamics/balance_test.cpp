// The verdict on the rate of a push, on artificial curves: each meter has a veto.
#include "dynamics/meters/balance.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "dynamics/meters/responses.h"

namespace wythe::balance_test {
namespace {

// A push to 4 that peaks at 2 with 100; rows of 0.02 and what the meters show in each.
struct Push {
  double felt = 1;         // base shear / reaction
  double damped = 0;       // of the drive's work
  double kinetic = 0.001;  // kinetic energy / work so far
  double unbalance = 1e-5;
};

Result pushed(const Push& p) {
  Result result;
  for (int i = 0; i <= 200; ++i) {
    CurveRow row;
    row.displacement = 0.02 * i;
    row.reaction = row.displacement <= 2 ? 50 * row.displacement : 150 - 25 * row.displacement;
    row.base_shear = p.felt * row.reaction;
    row.kinetic_ratio = p.kinetic;
    row.unbalance_ratio = p.unbalance;
    row.work_drive = (i == 0 ? 0.0 : result.curve.back().work_drive) + 0.02 * row.reaction;
    row.work_damping = p.damped * row.work_drive;
    result.curve.push_back(row);
  }
  return result;
}

RateVerdict judged(Result result) {
  result.responses = read_responses(result.curve);
  return dynamics::judge_quasi_static(result);
}

// The largest force of such a push holds the held load too.
TEST(Verdict, a_push_during_a_held_body_force_is_warned_of_first) {
  Result result = pushed({});
  result.quasi_static.judgement = "slow enough";
  EXPECT_NE(warning_of(result).code, "doubt.held_factor");
  result.load_factor = 0.5;
  EXPECT_EQ(warning_of(result).code, "doubt.held_factor");
  result.quasi_static.judgement = "too fast";
  EXPECT_EQ(warning_of(result).code, "doubt.held_factor");
  result.curve_of = StageKind::kBodyForce;
  EXPECT_NE(warning_of(result).code, "doubt.held_factor");
}

TEST(Verdict, a_static_push_is_slow_enough) {
  const RateVerdict q = judged(pushed({}));
  EXPECT_EQ(q.judgement, "slow enough");
  EXPECT_NEAR(q.lift, 0.02, 1e-12);  // what rounding alone may move
  EXPECT_EQ(q.verdict.code, "rate.slow_enough");
}

TEST(Verdict, a_gap_at_the_peak_counts) {
  EXPECT_EQ(judged(pushed({.felt = 0.995})).judgement, "slow enough");
  EXPECT_EQ(judged(pushed({.felt = 0.985})).judgement, "usable");
  EXPECT_EQ(judged(pushed({.felt = 0.9})).judgement, "too fast");  // no row is in balance
  EXPECT_TRUE(std::isnan(judged(pushed({.felt = 0.9})).lift));
}

TEST(Verdict, a_longer_push_hides_no_gap) {
  // drag up to 2.5, none beyond: a mean over the whole push would fall with its length
  Result result = pushed({.felt = 0.985});
  for (CurveRow& row : result.curve)
    if (row.displacement > 2.5) row.base_shear = row.reaction;
  const double gap = judged(result).shear_gap;
  for (int i = 0; i < 2000; ++i) {
    CurveRow row = result.curve.back();
    row.displacement += 0.02;
    result.curve.push_back(row);
  }
  EXPECT_DOUBLE_EQ(judged(result).shear_gap, gap);
}

TEST(Verdict, damping_has_a_veto_where_the_forces_agree) {
  // every block driven: the reaction is the base shear by construction
  EXPECT_EQ(judged(pushed({.damped = 0.005})).judgement, "slow enough");
  EXPECT_EQ(judged(pushed({.damped = 0.02})).judgement, "usable");
  EXPECT_EQ(judged(pushed({.damped = 0.06})).judgement, "too fast");
  const RateVerdict q = judged(pushed({.damped = 0.63}));
  EXPECT_EQ(q.judgement, "too fast");
  EXPECT_TRUE(std::isnan(q.lift));  // no such extrapolation is worth a number
  EXPECT_EQ(q.verdict.code, "rate.far_too_fast");
}

TEST(Verdict, a_crack_that_snaps_is_no_drag) {
  // it gives its energy to damping in one row, at any rate
  Result result = pushed({});
  for (std::size_t i = 95; i < result.curve.size(); ++i)
    result.curve[i].work_damping += 0.5 * result.curve[95].work_drive;
  EXPECT_EQ(judged(result).judgement, "slow enough");
}

TEST(Verdict, motion_and_unbalance_have_a_veto) {
  EXPECT_EQ(judged(pushed({.kinetic = 0.08})).judgement, "too fast");
  EXPECT_EQ(judged(pushed({.unbalance = 0.01})).judgement, "too fast");
}

TEST(Verdict, a_larger_force_out_of_balance_is_not_passed_over) {
  // the push outruns the wall from 1.8 on: what is read in balance is not all that it carried
  Result result = pushed({});
  for (CurveRow& row : result.curve)
    if (row.displacement > 1.8) row.base_shear = 0.97 * row.reaction;
  const RateVerdict q = judged(result);
  EXPECT_EQ(q.judgement, "too fast");
  EXPECT_NEAR(q.beyond, 0.97 / 0.88 - 1, 0.02);
}

TEST(Verdict, the_beginning_of_a_push_that_outruns_the_wall_is_no_strength) {
  Result result = pushed({});
  for (CurveRow& row : result.curve)
    if (row.displacement > 1) row.base_shear = 0.9 * row.reaction;
  result.responses = read_responses(result.curve);
  EXPECT_TRUE(std::isnan(result.responses.peak_reaction));
  EXPECT_EQ(result.responses.peak_reason.code, "balance.at_first_only");
  EXPECT_EQ(judged(result).judgement, "too fast");
  EXPECT_TRUE(std::isnan(judged(result).lift));
}

// The peak stays what the ground feels; but a wall that is hit is not pushed slowly.
TEST(Verdict, a_jolt_that_the_ground_does_not_feel_is_no_strength) {
  Result result = pushed({});
  for (std::size_t i = 1; i < 10; ++i) result.curve[i].reaction += 150;  // the start of the push
  EXPECT_EQ(read_responses(result.curve).peak_reaction, 100);
  const RateVerdict q = judged(result);
  EXPECT_EQ(q.judgement, "usable");
  EXPECT_EQ(q.verdict.code, "rate.usable");
}

// A calm curve after the jolt does not show the bond that it broke: a pier with a layer had 79.5 kN at 120 mm/s and
// 88.0 at 2 mm/s, and a pier without was "slow enough" at 300 mm/s.
TEST(Verdict, a_jolt_on_a_wall_that_breaks_is_too_fast) {
  Result result = pushed({});
  for (std::size_t i = 1; i < 4; ++i) result.curve[i].base_shear = -20;
  result.energy.fracture = 0.05 * result.curve.back().work_drive;
  const RateVerdict q = judged(result);
  EXPECT_EQ(q.judgement, "too fast");
  EXPECT_TRUE(std::isnan(q.lift));

  result.energy.fracture = 0;
  EXPECT_EQ(judged(result).judgement, "usable");
  result.energy.crushing = 0.05 * result.curve.back().work_drive;
  EXPECT_EQ(judged(result).judgement, "too fast");
}

// A wall that leans pulls the drive along: its work is then below zero, and no share of it bounds what broke.
TEST(Verdict, a_jolt_on_a_wall_that_pulls_its_drive_along_is_too_fast) {
  Result result = pushed({});
  for (std::size_t i = 1; i < 4; ++i) result.curve[i].base_shear = -20;
  for (std::size_t i = 1; i < result.curve.size(); ++i) result.curve[i].work_drive -= 1e6;
  result.energy.fracture = 10;
  EXPECT_EQ(judged(result).judgement, "too fast");
}

// The way up to 0.3 of the peak decides: beyond, the meters at the peak and the drag on the way do.
TEST(Verdict, a_gap_of_a_seventh_of_the_peak_at_the_start_is_no_jolt) {
  Result result = pushed({});
  result.energy.fracture = 0.05 * result.curve.back().work_drive;
  for (std::size_t i = 1; i < 4; ++i) result.curve[i].base_shear -= 14;
  EXPECT_EQ(judged(result).judgement, "slow enough");
  result.curve[2].base_shear -= 2;
  EXPECT_EQ(judged(result).judgement, "too fast");
}

TEST(Verdict, a_ledger_that_misses_a_percent_knows_nothing) {
  Result result = pushed({});
  result.energy.gap_ratio = 0.02;
  EXPECT_EQ(judged(result).judgement, "unknown");
}

// Comparisons with what is no number hold never, so each limit must ask whether it is kept.
TEST(Verdict, a_ledger_with_an_entry_that_is_no_number_knows_nothing) {
  constexpr double kInfinite = std::numeric_limits<double>::infinity();
  double EnergyLedger::*const entries[] = {
      &EnergyLedger::loads,     &EnergyLedger::drive,    &EnergyLedger::kinetic,
      &EnergyLedger::elastic,   &EnergyLedger::friction, &EnergyLedger::fracture,
      &EnergyLedger::crushing,  &EnergyLedger::damping,  &EnergyLedger::gap,
      &EnergyLedger::gap_ratio, &EnergyLedger::hand_over};
  for (const double bad : {kUnset, kInfinite, -kInfinite})
    for (double EnergyLedger::*const entry : entries) {
      if (entry == &EnergyLedger::gap_ratio && bad < 0) continue;  // a share has no sign
      Result result = pushed({});
      result.energy.*entry = bad;
      result.quasi_static = judged(result);
      EXPECT_EQ(result.quasi_static.judgement, "unknown") << bad;
      EXPECT_EQ(warning_of(result).code, "rate.unknown") << bad;
      Result shaken;
      shaken.shaking.was_shaken = true;
      shaken.energy.*entry = bad;
      shaken.quasi_static = dynamics::judge_quasi_static(shaken);
      EXPECT_EQ(warning_of(shaken).code, "rate.unknown") << bad;
    }
}

TEST(Verdict, a_curve_with_a_value_that_is_no_number_knows_nothing) {
  constexpr double kInfinite = std::numeric_limits<double>::infinity();
  double CurveRow::*const values[] = {&CurveRow::time,          &CurveRow::displacement,
                                      &CurveRow::reaction,      &CurveRow::base_shear,
                                      &CurveRow::kinetic_ratio, &CurveRow::unbalance_ratio,
                                      &CurveRow::work_drive,    &CurveRow::work_damping};
  for (const double bad : {kUnset, kInfinite, -kInfinite})
    for (double CurveRow::*const value : values)
      for (const std::size_t row : {5, 95, 100, 101, 190})  // of a peak at 100
        for (const bool supports : {false, true}) {
          Result result = pushed({});
          result.responses = read_responses(result.curve);
          result.curve[row].*value = bad;
          EXPECT_EQ(dynamics::judge_quasi_static(result, supports).judgement, "unknown")
              << bad << " in row " << row;
          result.curve_of = StageKind::kBodyForce;
          EXPECT_EQ(dynamics::judge_quasi_static(result).judgement, "unknown");
        }
}

TEST(Verdict, a_load_that_waits_for_balance_is_slow_enough) {
  Result result = pushed({.felt = 0.5});
  result.curve_of = StageKind::kBodyForce;
  result.responses.peak_reaction = 80;
  EXPECT_EQ(dynamics::judge_quasi_static(result).judgement, "slow enough");
  result.responses.peak_reaction = kUnset;
  EXPECT_EQ(dynamics::judge_quasi_static(result).judgement, "no push");
}

TEST(Verdict, a_curve_of_one_row_knows_nothing) {
  Result result = pushed({});
  result.curve = {result.curve[0], result.curve[200]};
  const RateVerdict q = judged(result);
  EXPECT_EQ(q.judgement, "unknown");
  EXPECT_NE(text_of(q.verdict).find("output.window"), std::string::npos);
  const Responses r = read_responses(result.curve);
  EXPECT_TRUE(std::isnan(r.peak_reaction));
  EXPECT_EQ(r.peak_reason.code, "balance.too_few_rows");
}

// Supports that give way to a wall, which presses on them with `force` all the way; `others` feel a share of it.
struct Drive {
  double others = 1;       // of the driven supports' force
  double damped = 0;       // of the force, over the way
  double kinetic = 0.001;  // kinetic energy / work so far
  double unbalance = 1e-5;
  double from = 0, to = 4;  // where on the way this is so
};
RateVerdict driven(const Drive& d) {
  Result result;
  for (int i = 0; i <= 200; ++i) {
    CurveRow row;
    row.displacement = 0.02 * i;
    const bool here = row.displacement >= d.from && row.displacement <= d.to;
    row.reaction = -(100 + 20 * std::exp(-row.displacement));
    row.base_shear = row.reaction * (here ? d.others : 1);
    row.kinetic_ratio = here ? d.kinetic : 0.001;
    row.unbalance_ratio = here ? d.unbalance : 1e-5;
    const CurveRow before = result.curve.empty() ? CurveRow{} : result.curve.back();
    row.work_drive = before.work_drive + 0.02 * row.reaction;
    row.work_damping = before.work_damping + 0.02 * (here ? d.damped : 0) * 100;
    result.curve.push_back(row);
  }
  result.responses = read_responses(result.curve);
  return dynamics::judge_quasi_static(result, true);
}

TEST(SupportVerdict, supports_that_give_way_slowly_are_slow_enough) {
  const RateVerdict q = driven({});
  EXPECT_EQ(q.judgement, "slow enough");
  EXPECT_EQ(q.verdict.code, "rate.supports_slow_enough");
  EXPECT_NEAR(q.lift, 0.02, 1e-12);
}

TEST(SupportVerdict, drag_between_the_supports_is_said) {
  EXPECT_EQ(driven({.others = 1.015}).judgement, "slow enough");
  EXPECT_EQ(driven({.others = 1.05}).judgement, "usable");
  EXPECT_EQ(driven({.others = 1.1}).judgement, "too fast");
  EXPECT_EQ(driven({.others = 0}).verdict.code, "rate.supports_far_too_fast");
  EXPECT_EQ(driven({.others = -1}).verdict.code, "rate.supports_far_too_fast");
  EXPECT_EQ(driven({.damped = 0.1}).judgement, "too fast");
}

TEST(SupportVerdict, a_fifth_of_the_way_is_enough_to_be_too_fast_and_a_snap_is_not) {
  EXPECT_EQ(driven({.others = 1.2, .from = 1.61, .to = 2.4}).judgement, "too fast");
  EXPECT_EQ(driven({.others = 3, .damped = 40, .from = 2, .to = 2.1}).judgement, "slow enough");
}

TEST(SupportVerdict, motion_and_unbalance_have_a_veto) {
  EXPECT_EQ(driven({.kinetic = 0.08}).judgement, "too fast");
  EXPECT_EQ(driven({.unbalance = 0.01}).judgement, "too fast");
}

TEST(SupportVerdict, a_jolt_at_the_start_does_not_hide_the_drag_behind_it) {
  // were the jolt the measure, a tenth of what follows would be little beside it
  Result result;
  for (int i = 0; i <= 200; ++i) {
    CurveRow row;
    row.displacement = 0.02 * i;
    row.reaction = i > 0 && i < 5 ? -5000 : -100;
    row.base_shear = -110;
    row.work_drive = -2 * i;
    result.curve.push_back(row);
  }
  EXPECT_EQ(dynamics::judge_quasi_static(result, true).judgement, "too fast");
}

TEST(Verdict, no_curve_is_no_push) {
  EXPECT_EQ(dynamics::judge_quasi_static({}).judgement, "no push");
}

}  // namespace
}  // namespace wythe::balance_test
