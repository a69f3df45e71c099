// Saving and restoring a run is invisible: same state, curve, events and readings, cut at any step of any
// stage.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <string>
#include <vector>

#include "scenes/rig.h"
#include "scenes/scenes.h"
#include "scenes/small_study.h"
#include "scenes/solids.h"
#include "scenes/whole_result.h"
#include "scenes/zones.h"
#include "scenes/zones_in_space.h"
#include "wythe/parts/checkpoint.h"
#include "wythe/parts/io.h"
#include "wythe/parts/solve.h"

namespace wythe::restart_test {
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
  EXPECT_GT(whole.state.energy.dissipated_fracture, 0);
}

// Runs to the end; with `every` > 0 in pieces of so many steps, each in a solve() of its own, from copies or from
// files of checkpoints. `cut_in`: what the pieces were cut in.
struct End {
  std::string hash, whole;
  Result result;
  std::set<std::string> cut_in;
};

// The features that a wall is using in this state.
std::set<std::string> middle_of(const Model& model, const State& state, const RunRecord& record) {
  const StageSpec& stage = model.stages[state.stage].spec;
  const char* kinds[] = {"gravity", "load", "push", "body force", "tilt", "hold", "shake", "cut"};
  std::set<std::string> found = {kinds[static_cast<int>(stage.kind())]};
  const bool settles = stage.kind() == StageKind::kGravity || stage.kind() == StageKind::kLoad;
  if (settles) found.insert(state.progress.time < stage.ramp ? "ramp" : "settling");
  if (stage.kind() == StageKind::kLoad && state.load_scale[1] == 1) found.insert("held load");
  if (stage.kind() == StageKind::kPush && state.progress.pace > 0 && state.progress.pace < 1)
    found.insert("servo");
  if (stage.kind() == StageKind::kPush && state.progress.target > 0) found.insert("cycle");
  const std::vector<CurveRow>& curve = record.result.curve;
  const double peak = record.recording.side[0].peak;
  if (peak > 0 && !curve.empty() && curve.back().reaction < 0.7 * peak)
    found.insert("after the peak");
  const bool grows = stage.kind() == StageKind::kTilt || stage.kind() == StageKind::kBodyForce;
  if (grows && state.progress.balance > 2 * model.solve.settle_ratio) found.insert("standstill");
  if (!record.recording.slid_off.empty() && record.recording.numbers.steps > 0) found.insert("row");
  return found;
}

enum class Through { kCopies, kFiles };

End run(const ModelSpec& spec, std::int64_t every, Through way = Through::kCopies) {
  const scenes::TemporaryFolder folder;
  End end;
  Checkpoint now{.order = order_of(spec, "model.toml"), .spec = spec, .model = compile(spec)};
  now.model.spec_hash = spec_hash(spec);
  now.state = initial_state(now.model);
  Checkpoint kept = now;
  SolveOptions options;
  options.frames = 7;
  options.read_modes_at = 0.7e-3;
  options.checkpoint = [&](const State& state, const RunRecord& record, bool ends) {
    if (!ends) return;
    end.cut_in.merge(middle_of(now.model, state, record));
    if (way == Through::kFiles)
      write_text(folder / kCheckpointFile, checkpoint_bytes(now.order, now.model, state, record));
    else
      kept.state = state, kept.record = record;
  };
  for (std::int64_t stop = every;; stop += every) {
    options.step_budget = stop;
    end.result = solve(now.model, now.state, options, now.record);
    if (end.result.status != SolveStatus::kBudgetSpent) break;
    now = way == Through::kFiles ? read_checkpoint(folder / "") : kept;
  }
  end.hash = state_hash(now.state);
  end.whole = scenes::whole(now.state) + "\n" + scenes::whole(end.result);
  return end;
}

void expect_invisible(const ModelSpec& spec, std::int64_t every,
                      const std::vector<std::string>& cut_in) {
  const End whole = run(spec, 0), pieced = run(spec, every);
  EXPECT_NE(whole.result.status, SolveStatus::kUnstable) << whole.result.reason;
  EXPECT_EQ(pieced.hash, whole.hash) << pieced.result.reason;
  EXPECT_EQ(pieced.whole, whole.whole);
  const End filed = run(spec, 11 * every, Through::kFiles);  // fewer: each waits for the disk
  EXPECT_EQ(filed.whole, whole.whole);
  EXPECT_FALSE(filed.cut_in.empty());
  for (const std::string& phase : cut_in)
    EXPECT_TRUE(pieced.cut_in.contains(phase)) << "no cut in: " << phase;
}

// Pieces of a prime number of steps: no period of the solver's own (8, 32, 50, 500) divides them.
constexpr std::int64_t kPiece = 97;

TEST(Restart, settling_loading_and_pushing_in_pieces_gives_the_same_result) {
  ModelSpec spec = scenes::small_wall();
  spec.solve.settle_ratio = 1e-9;  // takes longer than the ramps
  expect_invisible(spec, kPiece,
                   {"gravity", "load", "push", "ramp", "settling", "held load", "row"});
}

// Joints give way, blocks slide off and land: all of it can be cut.
TEST(Restart, free_contacts_that_come_and_go_give_the_same_result) {
  const ModelSpec spec = scenes::falling_portal(0.06);
  const End whole = run(spec, 0), pieced = run(spec, 997);
  ASSERT_EQ(whole.result.status, SolveStatus::kCompleted) << whole.result.reason;
  EXPECT_EQ(pieced.hash, whole.hash);
  EXPECT_EQ(pieced.whole, whole.whole);
  EXPECT_EQ(run(spec, 20011, Through::kFiles).whole, whole.whole);
  const State& end = whole.result.states.readings.back().state;
  EXPECT_GT(std::count(end.handed_over.begin(), end.handed_over.end(), 1.0), 3);
  EXPECT_FALSE(end.free_contacts.empty());
}

TEST(Restart, at_any_step_of_a_stage_gives_the_same_result) {
  ModelSpec spec = scenes::small_wall(0.02e-3, 0.05, 2e3);
  expect_invisible(spec, 7, {"gravity", "load", "push"});
}

TEST(Restart, after_the_peak_of_a_servo_with_elastic_unloading_gives_the_same_result) {
  ModelSpec spec = scenes::small_wall(4e-3, 0.05, 2e3);
  for (auto& [name, material] : spec.material) material.unloading = Unloading::kElastic;
  auto& push = spec.stage.back().get<PushStage>();
  push.fast_velocity = 3 * push.velocity;
  push.fast_below = 3e-2;
  push.stop_below = 0.3;
  expect_invisible(spec, kPiece, {"push", "servo", "after the peak"});
}

TEST(Restart, in_a_hold_after_a_push_gives_the_same_result) {
  ModelSpec spec = scenes::small_wall(0.2e-3, 0.05);
  StageSpec hold{.name = "hold", .action = HoldStage{.duration = 0.02}};
  spec.stage.push_back(hold);
  expect_invisible(spec, kPiece, {"push", "hold"});
}

// The last step of a support is in no state, because it follows from the record.
TEST(Restart, a_support_that_shakes_what_lies_on_it_in_pieces_gives_the_same_result) {
  ModelSpec spec = scenes::in_space({scenes::box("floor", {-1, -0.2, -1}, {2, 0.2, 2}, true),
                                     scenes::box("a", {-0.2, 0, -0.15}, {0.4, 0.3, 0.3}),
                                     scenes::box("b", {-0.2, 0.3, -0.15}, {0.4, 0.3, 0.3})},
                                    scenes::dry_joint(1e9, 4e8, std::atan(0.3)));
  spec.solve.contacts = Contacts::kFree;
  spec.stage = {scenes::gravity_stage(), scenes::shake_stage(8, 0.2)};
  spec.stage.back().get<ShakeStage>().record.front().at.block = "floor";
  spec.stage.back().get<ShakeStage>().free_vibration = 0.01;
  for (const double restitution : {1.0, 0.2}) {
    spec.stage.back().get<ShakeStage>().restitution = restitution;
    const End whole = run(spec, 0);
    ASSERT_EQ(whole.result.status, SolveStatus::kCompleted) << whole.result.reason;
    EXPECT_EQ(run(spec, kPiece).whole, whole.whole);
    const State& end = whole.result.states.snapshots.back().state;
    EXPECT_EQ(std::count(end.handed_over.begin(), end.handed_over.end(), 1.0), 1);
  }
}

TEST(Restart, a_shaken_wall_in_pieces_gives_the_same_result) {
  ModelSpec spec = scenes::small_wall();
  spec.stage.back() = scenes::shake_stage(8, 0.02);
  spec.stage.back().get<ShakeStage>().free_vibration = 0.01;
  expect_invisible(spec, kPiece, {"gravity", "shake"});
}

TEST(Restart, a_wall_with_a_lintel_of_zones_in_pieces_gives_the_same_result) {
  expect_invisible(scenes::lintel_wall(LintelModel::kZones, 0.3e-3), 499, {"push"});
}

TEST(Restart, zones_in_space_in_pieces_give_the_same_result) {
  ModelSpec spec = scenes::column_of_zones({.high = 0.4, .zones = 3, .zone_length = 0.1});
  spec.material["joint"] = scenes::paper_joint();
  spec.stage = {scenes::gravity_stage(),
                scenes::push_stage("cap", Direction::kPlusX, 0.02, 0.2e-3)};
  const RunOrder order = order_of(spec, "model.toml");  // as a file holds it
  const ModelSpec read = parse_model(order.model_text, order.model_file, {}, order.blocks);
  ASSERT_EQ(read.body[1].zone.zones, 3);
  ASSERT_EQ(read.body[1].zone.length, 0.1);
  expect_invisible(read, kPiece, {"gravity", "push"});
}

TEST(Restart, a_wall_with_ties_in_pieces_gives_the_same_result) {
  ModelSpec spec = scenes::tied(scenes::small_wall(0.1e-3, 0.05));
  spec.stage.back().get<PushStage>().targets = {0.1e-3, -0.1e-3};
  expect_invisible(spec, kPiece, {"gravity", "push", "cycle"});
}

TEST(Restart, a_wall_with_a_frame_that_yields_in_pieces_gives_the_same_result) {
  ModelSpec spec = scenes::framed(scenes::small_wall(0.1e-3, 0.05));
  spec.stage.back().get<PushStage>().targets = {0.1e-3, -0.1e-3};
  expect_invisible(spec, kPiece, {"gravity", "push", "cycle"});
}

TEST(Restart, a_wall_whose_opening_is_cut_in_pieces_gives_the_same_result) {
  expect_invisible(scenes::cut_under_load(scenes::framed(scenes::small_wall(0.1e-3, 0.05))), kPiece,
                   {"gravity", "cut", "push"});
}

TEST(Restart, a_wall_in_space_whose_opening_is_cut_in_pieces_gives_the_same_result) {
  ModelSpec spec = scenes::cut_under_load(scenes::framed(scenes::small_wall(0.1e-3, 0.05)));
  spec.stage.erase(spec.stage.begin() + 1);  // what presses on piers is of the plane
  spec.stage.back().get<PushStage>().at.x = 0.05;
  expect_invisible(scenes::along_a_line(spec), kPiece, {"gravity", "cut", "push"});
}

TEST(Restart, a_wall_with_a_layer_that_is_cut_in_pieces_gives_the_same_result) {
  expect_invisible(scenes::cut_under_load(scenes::layered(scenes::small_wall(0.1e-3, 0.05))),
                   kPiece, {"gravity", "cut", "push"});
}

TEST(Restart, a_wall_with_layers_that_come_off_and_break_in_pieces_gives_the_same_result) {
  ModelSpec spec = scenes::layered(scenes::small_wall(0.1e-3, 0.05));
  spec.stage.back().get<PushStage>().targets = {0.1e-3, -0.1e-3};
  expect_invisible(spec, kPiece, {"gravity", "push", "cycle"});
}

TEST(Restart, a_cyclic_push_in_pieces_gives_the_same_result) {
  ModelSpec spec = scenes::small_wall();
  spec.stage.back().get<PushStage>().targets = {0.4e-3, -0.4e-3, 0.2e-3};
  spec.stage.back().get<PushStage>().fast_velocity =
      1.5 * spec.stage.back().get<PushStage>().velocity;
  expect_invisible(spec, kPiece, {"push", "cycle"});
}

TEST(Restart, a_tilt_in_pieces_gives_the_same_result) {
  ModelSpec spec = scenes::small_wall();
  spec.stage.resize(1);
  StageSpec tilt{
      .name = "tilt",
      .action = TiltStage{.tilt_rate = scenes::degrees(40), .tilt_until = scenes::degrees(5)}};
  spec.stage.push_back(tilt);
  expect_invisible(spec, kPiece, {"tilt", "row"});
}

TEST(Restart, a_body_force_that_stands_still_in_pieces_gives_the_same_result) {
  ModelSpec spec = scenes::block_on_ground(
      0.5, 2.0, scenes::dry_joint(20e9, 8e9, scenes::degrees(60)), 0.1, 2000);
  StageSpec quake{.name = "quake", .action = BodyForceStage{.rate = 0.5, .factor = 1}};
  spec.stage = {scenes::gravity_stage(), quake};
  expect_invisible(spec, kPiece, {"body force", "standstill"});
}

}  // namespace
}  // namespace wythe::restart_test
