// One wall gives the same bits on any number of threads, in every run.
#include <gtest/gtest.h>

#include <algorithm>
#include <string>

#include "dynamics/passes/tables.h"
#include "scenes/rig.h"
#include "scenes/scenes.h"
#include "scenes/zones.h"
#include "wythe/parts/solve.h"

namespace wythe::threads_test {
namespace {

struct End {
  std::string hash;
  Result result;
};

End run(const Model& model, int threads) {
  State state = initial_state(model);
  SolveOptions options;
  options.threads = threads;
  End r;
  r.result = solve(model, state, options);
  r.hash = state_hash(state);
  return r;
}

// 320 blocks: several chunks of joints and of blocks, so that threads really share the work.
Model wide_wall() {
  ModelSpec spec = scenes::plain_wall(20, 16, 0.3e-3, 0.05);
  spec.solve.settle_ratio = 0.1;  // short: the bits matter, not the statics
  spec.stage.front().ramp = 0.01;
  return compile(spec);
}

TEST(Determinism, threads_do_not_change_a_bit) {
  const Model model = wide_wall();
  const dynamics::Layout layout(model, dynamics::Layout::kNeighbours);
  ASSERT_GT(layout.chunks[dynamics::kJoints].size(), 3U);
  ASSERT_GT(layout.chunks[dynamics::kBlocks].size(), 1U);
  const End one = run(model, 1);
  ASSERT_EQ(one.result.status, SolveStatus::kCompleted) << one.result.reason;
  EXPECT_GT(one.result.energy.fracture, 0);
  for (const int threads : {2, 3, 8}) {
    const End many = run(model, threads);
    EXPECT_EQ(many.hash, one.hash) << threads << " threads";
    EXPECT_EQ(many.result.state_hash, one.result.state_hash) << threads << " threads";
    EXPECT_EQ(many.result.energy.damping, one.result.energy.damping) << threads << " threads";
    EXPECT_EQ(many.result.responses.work_total, one.result.responses.work_total);
  }
}

// Several chunks of pairs that may touch, and joints that give way, as the wall is torn apart.
TEST(Determinism, threads_do_not_change_a_bit_of_free_contacts) {
  ModelSpec spec = scenes::half_units({24, 20, 3, 3, 0}, scenes::dry_joint(5e9, 2e9, 0.5));
  spec.solve.contacts = Contacts::kFree;
  const auto torn = [&](int threads) {
    scenes::Rig rig(compile(spec), threads);
    rig.state.gravity_y = -9.81;
    for (std::size_t i = 0; i < rig.state.vx.size(); ++i) {
      rig.state.vx[i] = 2.0 * static_cast<double>(i * 7919 % 13) / 13 - 1;
      rig.state.omega[i] = 8 * (static_cast<double>(i * 104729 % 11) - 5);
    }
    rig.controls.damping = 0;
    rig.run(300 * rig.controls.dt);
    EXPECT_GT(rig.processor.n_near(), 512);
    EXPECT_GT(rig.state.free_contacts.size(), 5U);
    EXPECT_GT(std::count(rig.state.handed_over.begin(), rig.state.handed_over.end(), 1.0), 2);
    return std::pair(state_hash(rig.state), rig.energy().hand_over);
  };
  const auto one = torn(1);
  EXPECT_EQ(torn(3), one);
}

// 32 x 12 zones: several chunks of zones and of nodes.
TEST(Determinism, threads_do_not_change_a_bit_of_a_lintel_of_zones) {
  ModelSpec spec = scenes::lintel_wall(LintelModel::kZones, 0.05e-3);
  LintelSpec& lintel = spec.wall.opening[0].lintel;
  lintel.zones = 12;
  lintel.zone_length = 0.02;
  spec.solve.settle_ratio = 1e-3;
  const Model model = compile(spec);
  const dynamics::Layout layout(model, dynamics::Layout::kNeighbours);
  ASSERT_GT(layout.chunks[dynamics::kZones].size(), 1U);
  ASSERT_GT(layout.chunks[dynamics::kNodes].size(), 1U);
  const End one = run(model, 1);
  ASSERT_EQ(one.result.status, SolveStatus::kCompleted) << one.result.reason;
  for (const int threads : {2, 3}) {
    const End many = run(model, threads);
    EXPECT_EQ(many.hash, one.hash) << threads << " threads";
    EXPECT_EQ(many.result.energy.damping, one.result.energy.damping) << threads << " threads";
  }
}

TEST(Determinism, two_runs_give_the_same_bits) {
  const Model model = compile(scenes::small_wall());
  const End first = run(model, 1), second = run(model, 1);
  EXPECT_EQ(first.hash, second.hash);
  EXPECT_EQ(first.result.steps, second.result.steps);
  const Model again = compile(scenes::small_wall());
  EXPECT_EQ(run(again, 1).hash, first.hash);
}

TEST(Determinism, the_hash_sees_every_bit) {
  const Model model = compile(scenes::small_wall());
  State state = initial_state(model);
  const std::string hash = state_hash(state);
  state.slip.back() = 1e-300;
  EXPECT_NE(state_hash(state), hash);
  const Model zones = compile(scenes::lintel_wall(LintelModel::kZones));
  State soft = initial_state(zones);
  const std::string before = state_hash(soft);
  soft.node_vy.back() = 1e-300;
  EXPECT_NE(state_hash(soft), before);
  state.slip.back() = -0.0;  // -0 and 0 are one state
  EXPECT_EQ(state_hash(state), hash);
}

}  // namespace
}  // namespace wythe::threads_test
