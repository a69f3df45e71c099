// Protocols of cyclic tests: levels and cycles against the same displacements written out.
#include "model/protocol.h"

#include <gtest/gtest.h>

#include "model/size.h"
#include "scenes/scenes.h"
#include "wythe/parts/model.h"
#include "wythe/parts/solve.h"

namespace wythe::protocol_test {
namespace {

PushStage levels(std::vector<double> amplitudes, std::vector<double> cycles = {}) {
  return {.amplitudes = std::move(amplitudes), .cycles = std::move(cycles)};
}

TEST(Protocol, levels_and_cycles_are_targets_that_end_at_zero) {
  using Targets = std::vector<double>;
  EXPECT_EQ(targets_of(levels({1, 3}), 0), (Targets{1, -1, 3, -3, 0}));
  EXPECT_EQ(targets_of(levels({1, 3}, {2}), 0), (Targets{1, -1, 1, -1, 3, -3, 3, -3, 0}));
  EXPECT_EQ(targets_of(levels({1, 3}, {2, 1}), 0), (Targets{1, -1, 1, -1, 3, -3, 0}));
  EXPECT_EQ(targets_of({.drifts = {0.001, 0.002}}, 2), (Targets{0.002, -0.002, 0.004, -0.004, 0}));
  PushStage plain;
  EXPECT_TRUE(targets_of(plain, 2).empty());
  plain.targets = {1, -2};
  EXPECT_EQ(targets_of(plain, 2), plain.targets);
}

TEST(Protocol, levels_are_told_with_their_cycles) {
  EXPECT_EQ(told_levels(levels({0.0025, 0.005}, {2, 1})), "2 × 2.5, 1 × 5");
}

// The file's reader says the same words with their place (ModelRefused.a_protocol_that_cannot_be_run).
TEST(Protocol, a_spec_that_no_file_was_read_for_is_refused_by_compile) {
  const auto refused_at = [](const PushStage& protocol) -> std::string {
    ModelSpec spec = scenes::stack(1, 0.2, 0.1, scenes::paper_joint(), 0.1, 2000);
    spec.stage = {scenes::gravity_stage(), scenes::push_stage("b0", Direction::kPlusX, 0.01, 1e-3)};
    auto& push = spec.stage[1].get<PushStage>();
    push.amplitudes = protocol.amplitudes, push.cycles = protocol.cycles;
    push.drifts = protocol.drifts, push.targets = protocol.targets;
    try {
      (void)compile(spec);
    } catch (const InputError& error) {
      return error.faults().front().path;
    }
    return "";
  };
  EXPECT_EQ(refused_at(levels({1e-3, 2e-3}, {2, 3})), "");
  EXPECT_EQ(refused_at(levels({1e-3, 1e-3})), "");
  EXPECT_EQ(refused_at(levels({2e-3, 1e-3})), "stage.1.amplitudes.1");
  EXPECT_EQ(refused_at(levels({0, 1e-3})), "stage.1.amplitudes.0");
  EXPECT_EQ(refused_at(levels({1e-3}, {0})), "stage.1.cycles.0");
  EXPECT_EQ(refused_at(levels({1e-3}, {1.5})), "stage.1.cycles.0");
  EXPECT_EQ(refused_at(levels({1e-3, 2e-3, 3e-3}, {1, 2})), "stage.1.cycles");
  EXPECT_EQ(refused_at(levels({1e-3}, {1e9})), "stage.1.cycles");
  EXPECT_EQ(refused_at(levels({}, {2})), "stage.1.cycles");
  PushStage both = levels({1e-3});
  both.targets = {1e-3};
  EXPECT_EQ(refused_at(both), "stage.1.targets");
  both.targets.clear(), both.drifts = {1e-3};
  EXPECT_EQ(refused_at(both), "stage.1.drifts");
}

// The bits of a run by its levels, by drifts of them, and by the same targets written out.
TEST(Protocol, gives_the_bits_of_its_targets) {
  ModelSpec spec = scenes::small_wall(1e-3, 0.1);
  auto& push = spec.stage.back().get<PushStage>();
  push.until = kUnset;
  const auto hash = [&] {
    const Model model = compile(spec);
    State state = initial_state(model);
    const Result result = solve(model, state);
    EXPECT_EQ(result.status, SolveStatus::kCompleted) << result.reason;
    EXPECT_NEAR(state.progress.drive_displacement, 0, 2 * 0.1 * result.time_step);
    return std::pair(result.state_hash, result.curve.size());
  };
  push.targets = {0.25e-3, -0.25e-3, 0.25e-3, -0.25e-3, 0.5e-3, -0.5e-3, 0};
  const double height = compile(spec).stages.back().load_height;
  const auto written_out = hash();
  push.targets.clear();
  push.amplitudes = {0.25e-3, 0.5e-3}, push.cycles = {2, 1};
  EXPECT_EQ(hash(), written_out);
  // the rows' own drift: 0.25 mm over the height of what is pushed
  push.amplitudes.clear();
  push.drifts = {0.25e-3 / height, 0.5e-3 / height};
  const std::vector<double> targets = compile(spec).stages.back().push()->targets;
  ASSERT_EQ(targets.size(), 7U);
  EXPECT_NEAR(targets.front(), 0.25e-3, 1e-18);
  EXPECT_EQ(targets.back(), 0);
}

// The path of a protocol, and the memory for it, before and after the wall is built.
TEST(Protocol, is_as_long_as_its_targets) {
  ModelSpec spec = scenes::small_wall(1e-3, 0.1);
  auto& push = spec.stage.back().get<PushStage>();
  push.until = kUnset;
  push.amplitudes = {1e-3, 2e-3}, push.cycles = {2};
  const double path = pace_of(spec.stage.back()).path;
  EXPECT_NEAR(path, 24e-3, 1e-12);
  EXPECT_EQ(pace_of(compile(spec).stages.back().spec).path, path);
  // states are kept where the push goes farther, not at each of its cycles
  push.cycles = {1000};
  const double to_and_fro = size_of(spec).bytes;
  push.amplitudes.clear(), push.cycles.clear();
  push.until = 2e-3;
  EXPECT_EQ(size_of(spec).bytes, to_and_fro);
}

}  // namespace
}  // namespace wythe::protocol_test
