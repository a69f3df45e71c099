// The bits of a wall in space do not depend on instruction set, threads, lane or neighbours, nor on where a run
// was cut.
#include <gtest/gtest.h>

#include <cmath>
#include <optional>
#include <string>
#include <vector>

#include "dynamics/executors/lane_solver.h"
#include "dynamics/space/executor.h"
#include "dynamics/stages/wall_run.h"
#include "scenes/scenes.h"
#include "wythe/parts/checkpoint.h"
#include "wythe/parts/solve.h"

namespace wythe::space_test {
namespace {

using dynamics::space::SpaceProcessor;

// Two leaves in running bond, pushed askew and out of their plane until they crack and slide.
ModelSpec leaves(double strength = 1, double until = 2e-3) {
  std::vector<BodySpec> bodies{scenes::box("floor", {-1, -0.2, -1}, {3, 0.2, 2}, true)};
  for (int leaf = 0; leaf < 2; ++leaf)
    for (int course = 0; course < 6; ++course)
      for (int k = 0; k < 4; ++k) {
        const double x = 0.2 * k + (course % 2 == 0 ? 0.0 : 0.1);
        bodies.push_back(scenes::box(
            "l" + std::to_string(leaf) + "c" + std::to_string(course) + "u" + std::to_string(k),
            {x, 0.1 * course, 0.12 * leaf}, {0.2, 0.1, 0.12}));
      }
  JointMaterial joint = scenes::paper_joint();
  joint.tensile_strength *= strength;
  joint.mode_1_energy *= strength;
  ModelSpec spec = scenes::in_space(bodies, joint);
  StageSpec push = scenes::push_stage("l0c5*", Direction::kPlusX, 0.05, until);
  push.get<PushStage>().drive.along = {0.3, 0, 1};
  spec.stage = {scenes::gravity_stage(), push};
  TieSpec tie;  // that yields on the way
  tie.from.block = "l0c4u1";
  tie.to.x = 0.4, tie.to.y = 0.5, tie.to.z = -1;
  tie.anchored = true;
  tie.area = 1e-5, tie.youngs_modulus = 200e9, tie.yield_strength = 30e6, tie.prestress = 5e6;
  spec.tie = {tie};
  FloorSpec floor;
  floor.load = 2e3;
  floor.from.x = 0.1, floor.from.y = 0.6, floor.from.z = 0.2;
  floor.to.x = 0.9, floor.to.y = 0.6, floor.to.z = 0.2;
  spec.floor = {floor};
  return spec;
}

struct End {
  std::string hash;
  Result result;
  State state;
};

End run_on(const Model& model, dynamics::Executor& executor, int lane = 0) {
  End end;
  end.state = initial_state(model);
  executor.load_wall(lane, model, end.state);
  const SolveOptions options;
  dynamics::WallRun run(model, end.state, options, executor.access(lane));
  while (!run.ended()) {
    executor.set(lane, run.next());
    executor.step();
    run.after_step(executor.reaction(lane));
  }
  executor.unload_wall(lane);
  end.result = run.finish();
  end.hash = end.result.state_hash;
  return end;
}

void expect_same(const End& a, const End& b, const std::string& what) {
  EXPECT_EQ(a.hash, b.hash) << what;
  EXPECT_EQ(a.result.energy.friction, b.result.energy.friction) << what;
  EXPECT_EQ(a.result.energy.fracture, b.result.energy.fracture) << what;
  EXPECT_EQ(a.result.energy.damping, b.result.energy.damping) << what;
  ASSERT_EQ(a.result.curve.size(), b.result.curve.size()) << what;
  for (std::size_t k = 0; k < a.result.curve.size(); ++k) {
    ASSERT_EQ(a.result.curve[k].reaction, b.result.curve[k].reaction) << what << ", row " << k;
    ASSERT_EQ(a.result.curve[k].base_shear, b.result.curve[k].base_shear) << what << ", row " << k;
    ASSERT_EQ(a.result.curve[k].kinetic_ratio, b.result.curve[k].kinetic_ratio) << what;
  }
}

TEST(SpaceBits, no_instruction_set_and_no_number_of_threads_changes_a_bit) {
  ModelSpec shaken = leaves(0.1);
  shaken.stage[1] = scenes::shake_stage(100, 0.03);
  for (const ModelSpec& spec : {leaves(1, 1e-3), shaken}) {
    const Model model = compile(spec);
    std::optional<End> first;
    for (const auto* set : dynamics::space::kernels_here())
      for (const int threads : {1, 3}) {
        SpaceProcessor processor(model, 1, threads, *set);
        const End now = run_on(model, processor);
        if (!first) first = now;
        expect_same(now, *first, std::string(set->name) + ", threads " + std::to_string(threads));
      }
    EXPECT_GT(first->result.energy.fracture, 0);  // it cracked and slid
    EXPECT_GT(first->result.energy.friction, 0);
  }
}

TEST(SpaceBits, a_wall_has_the_same_bits_in_any_lane_beside_others) {
  std::vector<Model> models;
  for (int k = 0; k < 5; ++k) models.push_back(compile(leaves(1 + 0.1 * k, 1e-3)));
  std::vector<std::string> alone;
  for (const Model& model : models) {
    State state = initial_state(model);
    alone.push_back(solve(model, state).state_hash);
  }
  EXPECT_NE(alone[0], alone[1]);
  for (const int width : {2, 4, 8}) {
    dynamics::LaneSolver solver(width);
    std::vector<State> states;
    for (const Model& model : models) states.push_back(initial_state(model));
    std::size_t next = 0, ended = 0;
    const SolveOptions options;
    while (ended < models.size()) {
      while (next < models.size() && solver.has_room()) {
        solver.add_wall(static_cast<int>(next), models[next], states[next], options);
        ++next;
      }
      const auto done = solver.next();
      EXPECT_EQ(done.result.state_hash, alone[done.ticket])
          << "wall " << done.ticket << " of " << width << " lanes";
      ++ended;
    }
  }
}

TEST(SpaceBits, a_run_that_was_cut_anywhere_ends_with_the_same_bits) {
  const Model model = compile(leaves(1, 1e-3));
  State whole = initial_state(model);
  const Result undisturbed = solve(model, whole);
  for (const std::int64_t every : {311, 2003}) {
    State state = initial_state(model);
    RunRecord record;
    Result result;
    for (bool going = true; going;) {
      SolveOptions options;
      options.step_budget = state.step + every;
      State kept;
      RunRecord so_far;
      options.checkpoint = [&](const State& s, const RunRecord& r, bool last) {
        if (last) kept = s, so_far = r;
      };
      result = solve(model, state, options, std::move(record));
      going = result.status == SolveStatus::kBudgetSpent;
      if (going) state = kept, record = so_far;
    }
    EXPECT_EQ(result.state_hash, undisturbed.state_hash) << every;
    ASSERT_EQ(result.curve.size(), undisturbed.curve.size());
    EXPECT_EQ(result.curve.back().reaction, undisturbed.curve.back().reaction);
    EXPECT_EQ(result.energy.gap, undisturbed.energy.gap);
  }
}

}  // namespace
}  // namespace wythe::space_test
