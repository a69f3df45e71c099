// Saving and restoring the state is invisible: same bits, at any step, through any stage.
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "scenes/rig.h"
#include "scenes/scenes.h"
#include "scenes/zones.h"
#include "wythe/solve.h"

namespace wythe {
namespace {

using scenes::Rig;

TEST(Restart, a_copied_state_goes_on_in_a_new_stepper_with_the_same_bits) {
  const Model model = compile(scenes::small_wall());
  const auto prepare = [](Rig& rig) {
    rig.state.gravity_y = -9.81;
    rig.state.load_scale[1] = 1;
    rig.drive(2, 0.05);
  };
  Rig whole(model);
  prepare(whole);
  for (int k = 0; k < 1500; ++k) whole.step();
  const State saved = whole.state;
  for (int k = 0; k < 1500; ++k) whole.step();

  Rig resumed(model);
  prepare(resumed);
  resumed.state = saved;
  for (int k = 0; k < 1500; ++k) resumed.step();
  EXPECT_EQ(state_hash(resumed.state), state_hash(whole.state));
  EXPECT_EQ(resumed.energy().gap, whole.energy().gap);
  EXPECT_GT(whole.state.dissipated_fracture, 0);
}

struct End {
  std::string hash;
  Result result;
  std::int64_t stops = 0;
};

// Runs to the end; with `every` > 0 in pieces of so many steps, each in a fresh solve() of a copy.
End run(const Model& model, std::int64_t every) {
  End end;
  State state = initial_state(model);
  SolveOptions options;
  while (true) {
    options.step_budget = every > 0 ? state.step + every : 0;
    end.result = solve(model, state, options);
    if (end.result.status != SolveStatus::kBudgetSpent) break;
    const State copy = state;
    state = copy;
    if (++end.stops > 10000) break;
  }
  end.hash = state_hash(state);
  return end;
}

void expect_invisible(const ModelSpec& spec, const std::vector<std::int64_t>& pieces) {
  const Model model = compile(spec);
  const End whole = run(model, 0);
  for (const std::int64_t every : pieces) {
    const End pieced = run(model, every);
    EXPECT_GT(pieced.stops, 2) << every;
    EXPECT_EQ(pieced.result.status, whole.result.status) << every << ": " << pieced.result.reason;
    EXPECT_EQ(pieced.result.steps, whole.result.steps) << every;
    EXPECT_EQ(pieced.hash, whole.hash) << every;
  }
}

TEST(Restart, settling_loading_and_pushing_in_pieces_gives_the_same_bits) {
  expect_invisible(scenes::small_wall(), {500, 1500, 2500});
}

TEST(Restart, a_wall_with_a_lintel_of_zones_in_pieces_gives_the_same_bits) {
  expect_invisible(scenes::lintel_wall(LintelModel::kZones, 0.3e-3), {1500});
}

TEST(Restart, a_cyclic_push_in_pieces_gives_the_same_bits) {
  ModelSpec spec = scenes::small_wall();
  spec.stage.back().targets = {0.4e-3, -0.4e-3, 0.2e-3};
  spec.stage.back().fast_velocity = 1.5 * spec.stage.back().velocity;
  expect_invisible(spec, {1500, 2500});
}

TEST(Restart, a_tilt_in_pieces_gives_the_same_bits) {
  ModelSpec spec = scenes::small_wall();
  spec.stage.resize(1);
  StageSpec tilt;
  tilt.name = "tilt";
  tilt.kind = StageKind::kTilt;
  tilt.tilt_rate = scenes::degrees(40);
  tilt.tilt_until = scenes::degrees(5);
  spec.stage.push_back(tilt);
  expect_invisible(spec, {1500, 2500});
}

TEST(Restart, a_body_force_in_pieces_gives_the_same_load_factor) {
  ModelSpec spec = scenes::block_on_ground(
      0.5, 2.0, scenes::dry_joint(20e9, 8e9, scenes::degrees(60)), 0.1, 2000);
  StageSpec quake;
  quake.name = "quake";
  quake.kind = StageKind::kBodyForce;
  quake.rate = 0.5;
  quake.factor = 1;
  spec.stage = {scenes::gravity_stage(), quake};
  const Model model = compile(spec);
  const End whole = run(model, 0), pieced = run(model, 1000);
  EXPECT_EQ(whole.result.status, SolveStatus::kCollapsed);
  EXPECT_EQ(pieced.hash, whole.hash);
  EXPECT_EQ(pieced.result.load_factor, whole.result.load_factor);
}

}  // namespace
}  // namespace wythe
