// The meters of a wall in space: balance, runaways, walls side by side.
#include <gtest/gtest.h>

#include <cmath>

#include "dynamics/executors/executor.h"
#include "scenes/scenes.h"
#include "scenes/space_rig.h"
#include "wythe/parts/solve.h"

namespace wythe::space_meters_test {
namespace {

using scenes::box;
using scenes::SpaceRig;

ModelSpec block_on_floor() {
  return scenes::in_space(
      {box("floor", {-1, -0.2, -1}, {2, 0.2, 2}, true), box("b", {-0.1, 0, -0.1}, {0.2, 0.1, 0.2})},
      scenes::dry_joint(1e9, 4e8, std::atan(0.5)), 2000);
}
SpaceRig& settled(SpaceRig& rig) {
  rig.state.uy[0] = -rig.model.mass[0] * 9.81 / (1e9 * 0.04);
  rig.set_gravity({0, -9.81, 0});
  rig.load_state();
  rig.advance();
  return rig;
}

TEST(SpaceMeters, a_block_that_a_couple_turns_is_not_in_balance) {
  Model model = compile(block_on_floor());
  scenes::add_load(model, 0, {0.1, 0, 0}, {0, 0, 40});
  model.stages[0].loads.push_back({0, -0.1, 0, 0, 0, 0, -40});  // 8 N m against 2.4 of friction
  SpaceRig rig(std::move(model));
  EXPECT_LT(settled(rig).processor.access(0)->unbalance_ratio(), 1e-9);
  rig.state.load_scale[0] = 1;
  rig.controls.damping = 0;
  rig.load_state();
  rig.run(0.02);
  EXPECT_GT(std::fabs(rig.momentum(0).y), 0.05);  // it spins up, with no force to show for it
  EXPECT_GT(rig.processor.access(0)->unbalance_ratio(), 0.1);
}

TEST(SpaceMeters, a_block_that_spins_beyond_all_measure_runs_away) {
  SpaceRig rig(compile(block_on_floor()));
  settled(rig);
  EXPECT_EQ(rig.processor.access(0)->runaway_block(), -1);
  rig.set_momentum(0, {0, 1e6, 0});
  rig.load_state();
  EXPECT_EQ(rig.processor.access(0)->runaway_block(), 0);
}

TEST(SpaceMeters, walls_that_are_damped_otherwise_do_not_go_side_by_side) {
  ModelSpec components = block_on_floor();
  components.solve.damping_form = DampingForm::kComponents;
  const Model a = compile(block_on_floor()), b = compile(components);
  EXPECT_FALSE(dynamics::fit_together(a, b));
  EXPECT_TRUE(dynamics::fit_together(a, compile(block_on_floor())));
}

// --- supports that are driven: the verdict on their rate

// Two stones and a wedge between them: it spreads them apart by its weight.
ModelSpec wedge_between(double velocity, double until) {
  const std::vector<Vec2> left{{-0.5, 0}, {0, 0}, {-0.15, 0.3}, {-0.5, 0.3}},
      right{{0.4, 0}, {0.9, 0}, {0.9, 0.3}, {0.55, 0.3}},
      wedge{{0, 0}, {0.4, 0}, {0.55, 0.3}, {-0.15, 0.3}};
  ModelSpec spec =
      scenes::in_space({scenes::body_of("left", scenes::prism_part(left, 0, 0.3), true),
                        scenes::body_of("right", scenes::prism_part(right, 0, 0.3), true),
                        scenes::body_of("wedge", scenes::prism_part(wedge, 0, 0.3))},
                       scenes::dry_joint(1e9, 4e8, std::atan(0.3)), 2000);
  spec.stage = {scenes::gravity_stage(),
                scenes::push_stage("right", Direction::kPlusX, velocity, until)};
  spec.stage[1].damping = 0.7;
  return spec;
}
Result ran(const ModelSpec& spec) {
  const Model model = compile(spec);
  State state = initial_state(model);
  return solve(model, state);
}

TEST(SupportRate, the_other_supports_say_whether_a_spread_is_slow_enough) {
  const Result slow = ran(wedge_between(0.001, 2e-3));
  EXPECT_EQ(slow.quasi_static.judgement, "slow enough") << text_of(slow.quasi_static.verdict);
  EXPECT_LT(slow.curve.back().reaction, -100);  // the wedge pushes the way its support goes
  for (std::size_t k = slow.curve.size() / 2; k < slow.curve.size(); ++k)
    EXPECT_NEAR(slow.curve[k].base_shear, slow.curve[k].reaction,
                0.02 * std::fabs(slow.curve[k].reaction));
  EXPECT_TRUE(warning_of(slow).empty());
  const Result fast = ran(wedge_between(0.5, 50e-3));
  EXPECT_EQ(fast.quasi_static.judgement, "too fast") << text_of(fast.quasi_static.verdict);
}

TEST(SupportRate, a_settlement_of_all_supports_is_slow_until_it_is_not) {
  ModelSpec spec = wedge_between(0.002, 4e-3);
  spec.stage[1].get<PushStage>().drive.direction = Direction::kMinusY;
  spec.body[0].id = "support left", spec.body[1].id = "support right";
  spec.stage[1].get<PushStage>().at = {.block = "support*"};
  const Result slow = ran(spec);
  EXPECT_EQ(slow.quasi_static.judgement, "slow enough") << text_of(slow.quasi_static.verdict);
  const double weight = 2000 * 9.81 * 0.3 * 0.3 * 0.55;
  EXPECT_NEAR(slow.curve.back().reaction, -weight, 1e-3 * weight);
  EXPECT_NEAR(slow.curve.back().base_shear, -weight, 1e-6 * weight);
  spec.stage[1].get<PushStage>().velocity = 3,
  spec.stage[1].get<PushStage>().until = 0.3;  // the ground drops from under it
  const Result fast = ran(spec);
  EXPECT_EQ(fast.quasi_static.judgement, "too fast") << text_of(fast.quasi_static.verdict);
}

}  // namespace
}  // namespace wythe::space_meters_test
