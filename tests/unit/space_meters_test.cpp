// What the meters of a wall in space may vouch for: balance, runaways, walls side by side.
#include <gtest/gtest.h>

#include <cmath>

#include "dynamics/executors/executor.h"
#include "scenes/scenes.h"
#include "scenes/space_rig.h"

namespace wythe {
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
  rig.put();
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
  rig.put();
  rig.run(0.02);
  EXPECT_GT(std::fabs(rig.momentum(0).y), 0.05);  // it spins up, with no force to show for it
  EXPECT_GT(rig.processor.access(0)->unbalance_ratio(), 0.1);
}

TEST(SpaceMeters, a_block_that_spins_beyond_all_measure_runs_away) {
  SpaceRig rig(compile(block_on_floor()));
  settled(rig);
  EXPECT_EQ(rig.processor.access(0)->runaway_block(), -1);
  rig.set_momentum(0, {0, 1e6, 0});
  rig.put();
  EXPECT_EQ(rig.processor.access(0)->runaway_block(), 0);
}

TEST(SpaceMeters, walls_that_are_damped_otherwise_do_not_go_side_by_side) {
  ModelSpec components = block_on_floor();
  components.solve.damping_form = DampingForm::kComponents;
  const Model a = compile(block_on_floor()), b = compile(components);
  EXPECT_FALSE(dynamics::fit_together(a, b));
  EXPECT_TRUE(dynamics::fit_together(a, compile(block_on_floor())));
}

}  // namespace
}  // namespace wythe
