// A collapse has the same bits for every instruction set, lane, number of threads and cut, in the plane
// and in space. Contacts that come and go are part of the state, and the search for them is deterministic.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "dynamics/executors/lane_solver.h"
#include "dynamics/executors/processor.h"
#include "dynamics/space/executor.h"
#include "dynamics/stages/wall_run.h"
#include "scenes/scenes.h"
#include "wythe/parts/checkpoint.h"
#include "wythe/parts/solve.h"

namespace wythe::collapse_test {
namespace {

// A dry portal, pushed until it falls.
ModelSpec collapse(bool in_space, double until = 0.06, double friction = 0.55) {
  ModelSpec spec = scenes::falling_portal(until);
  for (auto& [name, material] : spec.material)
    material.friction_angle = material.residual_friction_angle = friction;
  return in_space ? scenes::prisms(spec) : spec;
}

struct End {
  Result result;
  State state;
};

End run_on(const Model& model, dynamics::Executor& executor, const Dashpots* dashpots = nullptr) {
  End end;
  end.state = initial_state(model);
  executor.load_wall(0, model, end.state);
  const SolveOptions options;
  dynamics::WallRun run(model, end.state, options, executor.access(0));
  while (!run.ended()) {
    dynamics::Controls controls = run.next();
    controls.dashpots = dashpots;
    executor.set(0, controls);
    executor.step();
    run.after_step(executor.reaction(0));
  }
  executor.unload_wall(0);
  end.result = run.finish();
  return end;
}

void expect_collapsed(const End& end) {
  EXPECT_NE(end.result.status, SolveStatus::kUnstable) << text_of(end.result.reason);
  EXPECT_GT(std::count(end.state.handed_over.begin(), end.state.handed_over.end(), 1.0), 2);
  EXPECT_FALSE(end.state.free_contacts.empty());
}

void expect_same(const End& a, const End& b, const std::string& what) {
  EXPECT_EQ(a.result.state_hash, b.result.state_hash) << what;
  EXPECT_EQ(a.state.free_contacts.size(), b.state.free_contacts.size()) << what;
  EXPECT_EQ(a.result.energy.hand_over, b.result.energy.hand_over) << what;
  EXPECT_EQ(a.result.energy.friction, b.result.energy.friction) << what;
}

TEST(Collapse, no_instruction_set_and_no_number_of_threads_changes_a_bit) {
  const Model plane = compile(collapse(false)), space = compile(collapse(true));
  std::optional<End> first, first_in_space;
  // all sets, and the widest one with threads too
  for (const dynamics::Kernels* set : dynamics::kernels_here())
    for (const int threads : {1, 2}) {
      if (threads > 1 && set != dynamics::kernels_here().back()) continue;
      dynamics::Processor processor(plane, 1, threads, *set);
      const End now = run_on(plane, processor);
      if (!first) first = now;
      expect_same(now, *first, std::string(set->name) + ", threads " + std::to_string(threads));
    }
  for (const auto* set : dynamics::space::kernels_here())
    for (const int threads : {1, 2}) {
      if (threads > 1 && set != dynamics::space::kernels_here().back()) continue;
      dynamics::space::SpaceProcessor processor(space, 1, threads, *set);
      const End now = run_on(space, processor);
      if (!first_in_space) first_in_space = now;
      expect_same(now, *first_in_space,
                  std::string(set->name) + " in space, threads " + std::to_string(threads));
    }
  expect_collapsed(*first);
  expect_collapsed(*first_in_space);
}

// With dashpots, contacts are taken one by one. These dashpots have no resistance.
TEST(Collapse, contacts_taken_one_by_one_have_the_bits_of_those_in_packs) {
  const Model model = compile(collapse(false));
  Dashpots none;
  none.normal.assign(static_cast<std::size_t>(model.n_joint), 0.0);
  none.shear = none.normal;
  dynamics::Processor in_packs(model, 1), one_by_one(model, 1);
  const End packed = run_on(model, in_packs), single = run_on(model, one_by_one, &none);
  expect_collapsed(packed);
  expect_same(single, packed, "one by one");
}

// Each is let go by its lanes and ends as it does alone.
TEST(Collapse, walls_side_by_side_have_the_bits_of_those_alone) {
  for (const bool in_space : {false, true}) {
    std::vector<Model> models;
    std::vector<std::string> alone;
    for (const double friction : {0.55, 0.5, 0.6, 0.45, 0.65}) {
      models.push_back(compile(collapse(in_space, 0.06, friction)));
      State state = initial_state(models.back());
      alone.push_back(solve(models.back(), state).state_hash);
    }
    EXPECT_NE(alone[0], alone[1]);
    for (const int width : {2, 8}) {
      dynamics::LaneSolver solver(width);
      std::vector<State> states;
      for (const Model& model : models) states.push_back(initial_state(model));
      const SolveOptions options;
      std::size_t next = 0, ended = 0;
      for (; ended < models.size(); ++ended) {
        for (; next < models.size() && solver.has_room(); ++next)
          solver.add_wall(static_cast<int>(next), models[next], states[next], options);
        const auto done = solver.next();
        EXPECT_EQ(done.result.state_hash, alone[done.ticket])
            << "wall " << done.ticket << " of " << width << (in_space ? " in space" : "");
      }
    }
  }
}

// A wall that is put into its place again knows nothing of pairs that are near and do not press: which are looked at, and
// which sleep, must not be seen in the result.
TEST(Collapse, does_not_show_who_was_looked_for_and_who_slept) {
  for (const bool in_space : {false, true}) {
    const Model model = compile(collapse(in_space, 0.15));
    std::vector<End> ends;
    for (const int every : {0, 7}) {
      const std::unique_ptr<dynamics::Executor> executor = dynamics::processor_for(model, 1);
      End end;
      end.state = initial_state(model);
      executor->load_wall(0, model, end.state);
      const SolveOptions options;
      dynamics::WallRun run(model, end.state, options, executor->access(0));
      for (int step = 1; !run.ended(); ++step) {
        executor->set(0, run.next());
        executor->step();
        run.after_step(executor->reaction(0));
        if (every == 0 || step % every != 0) continue;
        executor->unload_wall(0);
        executor->load_wall(0, model, end.state);
        run.move_to(executor->access(0));
      }
      executor->unload_wall(0);
      end.result = run.finish();
      ends.push_back(end);
    }
    expect_collapsed(ends[0]);
    expect_same(ends[1], ends[0], in_space ? "in space" : "in the plane");
  }
}

TEST(Collapse, in_space_cut_anywhere_ends_with_the_same_bits) {
  const Model model = compile(collapse(true));
  State whole = initial_state(model);
  const Result undisturbed = solve(model, whole);
  for (const std::int64_t every : {997, 5003}) {
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
    EXPECT_EQ(result.state_hash, undisturbed.state_hash) << "every " << every;
    EXPECT_EQ(result.energy.hand_over, undisturbed.energy.hand_over);
  }
}

// Without damping nothing but friction takes energy. What the ledger does not explain is an error of the step: friction
// of points that were open in the step before is booked to first order. The bounds were set after the first
// results, -0.3 % at the whole step.
TEST(Collapse, makes_no_energy) {
  for (const bool in_space : {false, true})
    for (const double share : {1.0, 0.5, 0.25}) {
      ModelSpec spec = collapse(in_space, 0.3);
      spec.solve.step_fraction *= share;
      for (StageSpec& stage : spec.stage)
        if (stage.kind() != StageKind::kGravity) stage.damping = 0;
      const Model model = compile(spec);
      State state = initial_state(model);
      const Result result = solve(model, state);
      EXPECT_NE(result.status, SolveStatus::kUnstable) << text_of(result.reason);
      const EnergyLedger& e = result.energy;
      const double moved = std::fabs(e.loads) + std::fabs(e.drive);
      EXPECT_GT(e.loads, 300) << "it has not fallen";
      EXPECT_LT(std::fabs(e.gap), 5e-3 * share * moved)
          << "in space " << in_space << ", step x " << share << ": " << e.gap / moved;
    }
}

}  // namespace
}  // namespace wythe::collapse_test
