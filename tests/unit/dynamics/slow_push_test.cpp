// Whether a slow push would give the same displacement and mode, on artificial curves.
#include "wythe/parts/slow_push.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "dynamics/meters/balance.h"
#include "dynamics/meters/responses.h"

namespace wythe::slow_push_test {
namespace {

// A push to 4 mm. It rises to 100 at 1 mm, jumps by `fall` at 2 mm, and falls to 60 at 3 mm.
struct Push {
  double fall = 10;      // [N]
  double unbalance = 0;  // of the row in which it jumps
  double later = 60;     // from 3 mm on [N]
  double felt = 1;       // base shear / reaction between 1.3 and 1.5 mm
  double damping = 0.2;  // local
  int rows = 400;
  double turned = 1;  // -1: pushed the other way
};

constexpr double kVelocity = 5e-3;

struct Pushed {
  Model model;
  Result result;
  [[nodiscard]] SlowPushVerdict displacement() const {
    return displacement_of_slow_push(model, result);
  }
  [[nodiscard]] SlowPushVerdict mode() const { return mode_of_slow_push(model, result); }
};

double force_at(double d, const Push& p) {
  if (d <= 1) return 100 * d;
  if (d <= 2) return 100;
  return d <= 3 ? 100 - p.fall : p.later;
}

Pushed pushed(const Push& p) {
  Pushed made;
  made.model.n_block = 1;
  Stage push;
  push.spec.action = PushStage{.velocity = kVelocity};
  push.spec.damping = p.damping;
  made.model.stages.push_back(push);
  std::vector<CurveRow>& rows = made.result.curve;
  for (int i = 0; i <= p.rows; ++i) {
    const double d = 4.0 * i / p.rows, window = 4.0 / p.rows;
    CurveRow row;
    row.displacement = p.turned * 1e-3 * d;
    row.time = 1e-3 * d / kVelocity;
    row.reaction = p.turned * force_at(d, p);
    row.base_shear = (d > 1.3 && d <= 1.5 ? p.felt : 1) * row.reaction;
    // what a row says is the mean over its way
    row.unbalance_ratio =
        2e-5 + (d > 2 && d <= 2 + window * 1.01 ? p.unbalance * 0.01 / window : 0);
    row.work_drive = rows.empty() ? 0.0 : rows.back().work_drive + window * 1e-3 * force_at(d, p);
    rows.push_back(row);
  }
  made.result.responses = read_responses(rows);
  made.result.quasi_static = dynamics::judge_quasi_static(made.result);
  made.result.failure_mode.read_at = p.turned * 4e-3;
  return made;
}

TEST(SlowPushVerdict, a_push_in_balance_all_the_way_promises_displacement_and_mode) {
  const Pushed still = pushed({});
  EXPECT_EQ(still.result.quasi_static.judgement, "slow enough");
  EXPECT_NEAR(still.result.responses.displacement_at_80, 3e-3, 2e-5);
  EXPECT_EQ(still.displacement().verdict, "slow enough") << text_of(still.displacement().reason);
  EXPECT_EQ(still.mode().verdict, "slow enough");
  EXPECT_TRUE(warning_of(still.model, still.result).empty());
}

TEST(SlowPushVerdict, a_name_that_hangs_on_a_threshold_is_not_promised) {
  Pushed doubtful = pushed({});
  FailureMode& mode = doubtful.result.failure_mode;
  mode.name = "shear";
  mode.scores = {{"shear", 1}, {"rocking", 0.1}};
  EXPECT_EQ(doubtful.mode().verdict, "slow enough");
  mode.scores["rocking"] = 0.26;
  EXPECT_EQ(doubtful.mode().reason.code, "promise.name");
}

// 0.012 of unbalance over 0.01 mm: 0.04 mm at the limit of 0.003, 2.5 % of 2 mm at damping 0.2.
TEST(SlowPushVerdict, a_drive_that_goes_on_in_a_jump_promises_nothing_beyond_it) {
  const Pushed went_on = pushed({.unbalance = 0.012});
  const SlowPushVerdict said = went_on.displacement();
  EXPECT_EQ(said.verdict, "not known");
  EXPECT_EQ(said.reason.code, "promise.jump");
  EXPECT_NEAR(said.reason.number("displacement_mm"), 2, 1e-9);
  EXPECT_NEAR(said.reason.number("way_percent"), 2.5, 0.02);
  EXPECT_EQ(went_on.mode().reason.code, "promise.jump");
  EXPECT_EQ(warning_of(went_on.model, went_on.result).code, "promise.no_drift");
  EXPECT_EQ(pushed({.unbalance = 0.004}).displacement().verdict, "slow enough");
  EXPECT_EQ(pushed({.unbalance = 0.012, .turned = -1}).displacement().reason.code, "promise.jump");
}

TEST(SlowPushVerdict, the_way_pushed_in_a_jump_does_not_hang_on_the_rows) {
  for (const int rows : {80, 200, 400})
    EXPECT_NEAR(
        pushed({.unbalance = 0.012, .rows = rows}).displacement().reason.number("way_percent"), 2.5,
        0.05)
        << rows;
}

// A control point may run ahead of the drive.
TEST(SlowPushVerdict, the_way_pushed_is_that_of_the_drive) {
  Pushed flies = pushed({.unbalance = 0.012});
  flies.model.stages.back().spec.get<PushStage>().velocity = 0.1 * kVelocity;
  EXPECT_EQ(flies.displacement().verdict, "slow enough");
}

TEST(SlowPushVerdict, unbalance_that_lifts_no_force_off_the_wall_is_no_jump) {
  EXPECT_EQ(pushed({.fall = 1.9, .unbalance = 0.05}).displacement().verdict, "slow enough");
  EXPECT_EQ(pushed({.fall = 2.1, .unbalance = 0.05}).displacement().verdict, "not known");
}

// Local damping leaves 1 - damping of the unbalanced force to an accelerating block.
TEST(SlowPushVerdict, damping_makes_a_jump_slower) {
  const Pushed light = pushed({.unbalance = 0.002}),
               heavy = pushed({.unbalance = 0.002, .damping = 0.9});
  EXPECT_EQ(light.displacement().verdict, "slow enough");
  EXPECT_NEAR(heavy.displacement().reason.number("way_percent"),
              0.002 * 0.01 / 0.003 / 0.1 / 2 * 100, 0.05);
}

// Up to the start of the fall the wall was in balance, and a slow push falls at least as far.
TEST(SlowPushVerdict, the_fall_itself_is_no_reason_to_doubt_where_it_is) {
  Push fails{.fall = 30, .unbalance = 0.05};
  EXPECT_EQ(pushed(fails).displacement().verdict, "slow enough");
  EXPECT_EQ(pushed(fails).mode().reason.code, "promise.jump");  // read beyond it
}

TEST(SlowPushVerdict, drag_in_one_part_of_the_way_is_enough) {
  EXPECT_EQ(pushed({.felt = 0.995}).displacement().verdict, "slow enough");
  Pushed dragged = pushed({});
  for (CurveRow& row : dragged.result.curve)
    if (row.displacement > 2.4e-3 && row.displacement < 3e-3) row.base_shear = 0.985 * row.reaction;
  EXPECT_EQ(dragged.result.quasi_static.judgement, "slow enough");
  EXPECT_EQ(dragged.displacement().reason.code, "promise.drag");
  EXPECT_NEAR(dragged.displacement().reason.number("drag_percent"), 1.35, 1e-6);
}

// A wall that stands for long at 0.81 of its peak: 2 % of the force decide where it ends.
TEST(SlowPushVerdict, a_capacity_on_a_knifes_edge_is_not_known) {
  const SlowPushVerdict near = pushed({.fall = 19}).displacement();
  EXPECT_EQ(near.reason.code, "promise.threshold");
  EXPECT_NEAR(near.reason.number("low_mm"), 2, 0.02);
  EXPECT_NEAR(near.reason.number("high_mm"), 3, 0.02);
  EXPECT_EQ(pushed({.fall = 10}).displacement().verdict, "slow enough");
  // a lower bound is one unless forces that are a little less end the wall before
  EXPECT_EQ(pushed({.later = 90}).displacement().verdict, "slow enough");
  EXPECT_EQ(pushed({.fall = 19, .later = 81}).displacement().reason.code, "promise.threshold");
}

TEST(SlowPushVerdict, nothing_is_promised_where_the_force_is_not) {
  Pushed made = pushed({});
  for (const char* judgement : {"usable", "too fast", "unknown"}) {
    made.result.quasi_static.judgement = judgement;
    EXPECT_EQ(made.displacement().reason.code, "promise.force");
    EXPECT_EQ(made.mode().reason.code, "promise.force");
  }
  made.result.quasi_static.judgement = "no push";
  EXPECT_EQ(made.displacement().verdict, "no push");
  made = pushed({});
  made.result.quasi_static.verdict.code = "rate.load";
  EXPECT_EQ(made.mode().verdict, "no push");
  made = pushed({});
  made.result.failure_mode.read_at = 0;
  EXPECT_EQ(made.mode().reason.code, "promise.no_mode");
  made.model.stages.clear();
  EXPECT_EQ(made.displacement().verdict, "no push");
}

TEST(SlowPushVerdict, the_cure_is_that_of_the_push) {
  Pushed made = pushed({.unbalance = 0.024});
  const auto cure = [&] {
    for (const Argument& a : made.displacement().reason.arguments)
      if (a.name == "cure") return std::get<std::vector<Message>>(a.value).front();
    return Message{};
  };
  EXPECT_EQ(cure().code, "promise.cure");
  EXPECT_NEAR(cure().number("velocity"), 0.5,
              0.01);  // 5 % where 1 % is allowed: a tenth of the speed
  made.model.stages.back().spec.get<PushStage>().velocity = 1e-4;
  made.model.stages.back().spec.get<PushStage>().fast_velocity = 5e-3;
  made.model.stages.back().spec.get<PushStage>().fast_below = 1e-4;
  EXPECT_EQ(cure().code, "promise.cure_adapted");
  EXPECT_NEAR(cure().number("velocity"), 0.5, 0.01);
  EXPECT_NEAR(cure().number("below"), 5e-5, 1e-9);
}

}  // namespace
}  // namespace wythe::slow_push_test
