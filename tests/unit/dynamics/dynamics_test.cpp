// The step and the stages: integration, local damping, the spreader, the step bound, how stages end.
#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <string>

#include "dynamics/passes/motion.h"
#include "scenes/places.h"
#include "scenes/rig.h"
#include "scenes/scenes.h"
#include "wythe/parts/failure_mode.h"
#include "wythe/parts/solve.h"

namespace wythe::dynamics_test {
namespace {

using scenes::Rig;

// --- one degree of freedom ------------------------------------------------------------------------------

TEST(Accelerate, local_damping_opposes_the_velocity_with_a_share_of_the_force) {
  const auto with = dynamics::accelerate(2.0, 10.0, 0.1 / 4.0, 0.1, 0.8);
  EXPECT_DOUBLE_EQ(with.velocity, 2 + 0.1 / 4 * (10 - 8));
  const auto against = dynamics::accelerate(-2.0, 10.0, 0.1 / 4.0, 0.1, 0.8);
  EXPECT_DOUBLE_EQ(against.velocity, -2 + 0.1 / 4 * (10 + 8));
  EXPECT_LT(with.damping_work, 0);
  EXPECT_LT(against.damping_work, 0);
}

TEST(Accelerate, a_block_at_rest_is_not_damped) {
  const auto moved = dynamics::accelerate(0.0, -10.0, 0.1 / 4.0, 0.1, 0.8);
  EXPECT_DOUBLE_EQ(moved.velocity, -0.25);
  EXPECT_EQ(moved.damping_work, 0);
}

// --- the step -------------------------------------------------------------------------------------------

TEST(Step, free_fall_follows_the_discrete_parabola) {
  Rig rig(compile(scenes::block_on_ground(0.4, 0.2, scenes::dry_joint(1e9, 1e9, 0.5), 0.1, 2000)));
  rig.controls.damping = 0;
  rig.state.uy[0] = 2.0;  // far above the ground
  rig.state.gravity_y = -9.81;
  const int n = 1000;
  const double dt = rig.controls.dt;
  for (int k = 0; k < n; ++k) rig.step();
  EXPECT_NEAR(rig.state.vy[0], -9.81 * n * dt, 1e-12);
  EXPECT_NEAR(rig.state.uy[0], 2 - 9.81 * dt * dt * n * (n + 1) / 2, 1e-12);  // sum of 1 ... n
  EXPECT_EQ(rig.state.ux[0], 0);
  EXPECT_EQ(rig.state.theta[0], 0);
}

TEST(Step, gravity_is_carried_by_the_ground) {
  Rig rig(compile(scenes::small_wall()));
  rig.state.gravity_y = -9.81;
  rig.settle(1e-7);
  double up = 0;
  for (auto j = static_cast<std::size_t>(rig.model.n_pair); j < rig.model.joint_b.size(); ++j)
    up -= rig.force(j)[1];
  EXPECT_NEAR(up / rig.model.weight, 1.0, 1e-5);  // unbalance per block, 50 blocks
  EXPECT_NEAR(dynamics::shear_of(rig.view(), 1, 0), 0, 1e-5 * rig.model.weight);
}

TEST(Step, a_load_keeps_its_direction_and_follows_its_block) {
  Model model =
      compile(scenes::block_on_ground(0.4, 0.2, scenes::dry_joint(1e9, 1e9, 0.5), 0.1, 2000));
  const std::size_t load = scenes::add_load(model, {0, 0.1, 0.05, 0, -50});
  Rig rig(std::move(model));
  rig.controls.damping = 0;
  rig.state.uy[0] = 10;
  rig.state.theta[0] = 0.5 * scenes::kPi;  // (0.1, 0.05) now points to (-0.05, 0.1)
  rig.state.load_scale[load] = 1;
  rig.step();
  EXPECT_NEAR(rig.view().block(0, dynamics::kLoadY), -50, 1e-12);
  EXPECT_NEAR(rig.view().block(0, dynamics::kLoadM), 0.05 * 50, 1e-12);
}

TEST(Step, half_the_bound_is_stable_and_the_bound_holds_for_a_wall) {
  ModelSpec spec = scenes::half_units({}, scenes::elastic_joint(20e9, 8e9));
  for (const double share : {0.5, 0.99}) {
    Rig rig(compile(spec));
    rig.controls.damping = 0;
    rig.controls.dt = share * 2 / rig.model.omega_max;
    for (std::size_t i = 0; i < rig.state.ux.size(); ++i)
      rig.state.vx[i] = 1e-3 * std::sin(3.0 * static_cast<double>(i));
    const double before = rig.energy().kinetic;
    for (int k = 0; k < 20000; ++k) rig.step();
    // stable central differences hold the energy within 1/(1 - share^2) of itself
    EXPECT_LT(rig.energy().kinetic, before / (1 - share * share)) << share;
  }
}

TEST(Step, the_bound_is_not_wasteful) {
  // a wall's highest frequency must lie within a third below its bound: 1.5 times the step diverges
  Rig rig(compile(scenes::half_units({}, scenes::elastic_joint(20e9, 8e9))));
  rig.controls.damping = 0;
  rig.controls.dt = 1.5 * 2 / rig.model.omega_max;
  for (std::size_t i = 0; i < rig.state.ux.size(); ++i)
    rig.state.vx[i] = 1e-9 * std::sin(3.0 * static_cast<double>(i));
  for (int k = 0; k < 5000 && dynamics::runaway_of(rig.view()) < 0; ++k) rig.step();
  EXPECT_GE(dynamics::runaway_of(rig.view()), 0);
}

// --- the drive ------------------------------------------------------------------------------------------

// Small wall whose push moves the three blocks on the left edge.
Model spread_wall(Manner manner) {
  ModelSpec spec = scenes::small_wall();
  auto& push = spec.stage.back().get<PushStage>();
  push.at.courses = 3;
  push.at.y = 5.5 * 0.11;
  push.as = manner;
  return compile(spec);
}

TEST(Drive, spreader_meets_the_mean_velocity_and_gives_equal_forces) {
  Rig rig(spread_wall(Manner::kSpreader));
  rig.controls.damping = 0;
  rig.drive(2, 0.05);
  const auto& driven = rig.model.stages[2].driven;
  ASSERT_EQ(driven.size(), 3U);
  for (int k = 0; k < 200; ++k) rig.step();
  std::vector<double> before = rig.state.vx;
  rig.step();
  double mean = 0;
  for (const BlockId b : driven) mean += rig.state.vx[b] / 3;
  EXPECT_NEAR(mean, 0.05, 1e-14);
  // applied force = m a - (contact and body forces), the same on every driven block
  std::vector<double> applied;
  for (const BlockId b : driven) {
    const auto i = static_cast<std::size_t>(b);
    applied.push_back(rig.model.mass[i] * (rig.state.vx[i] - before[i]) / rig.controls.dt -
                      rig.view().cold(b, dynamics::kTotalX));
  }
  EXPECT_NEAR(applied[1] / applied[0], 1.0, 1e-9);
  EXPECT_NEAR(applied[2] / applied[0], 1.0, 1e-9);
}

TEST(Drive, each_moves_every_driven_block_at_the_velocity) {
  Rig rig(spread_wall(Manner::kEach));
  rig.drive(2, 0.05);
  for (int k = 0; k < 200; ++k) rig.step();
  for (const BlockId b : rig.model.stages[2].driven) EXPECT_NEAR(rig.state.vx[b], 0.05, 1e-14);
}

TEST(Drive, reaction_balances_the_base_shear_when_pushed_slowly) {
  const Model model = compile(scenes::small_wall(0.2e-3, 2e-3));
  State state = initial_state(model);
  const Result result = solve(model, state);
  ASSERT_EQ(result.status, SolveStatus::kCompleted) << result.reason;
  const CurveRow& last = result.curve.back();
  EXPECT_GT(last.reaction, 1e3);
  EXPECT_NEAR(last.reaction / last.base_shear, 1.0, 0.02);  // inertia and damping drag at 2 mm/s
  EXPECT_NEAR(last.displacement, 0.2e-3, 1e-9 + 2e-3 * result.time_step);  // ends within a step
}

TEST(Readings, are_of_the_first_step_at_each_millimetre_and_where_asked_and_of_the_end) {
  const Model model = compile(scenes::small_wall(3.2e-3, 0.1));
  State state = initial_state(model);
  SolveOptions options;
  options.read_modes_at = 1.7e-3;
  const Result result = solve(model, state, options);
  const double expected[] = {1e-3, 1.7e-3, 2e-3, 3e-3, 3.2e-3};
  ASSERT_EQ(result.states.readings.size(), std::size(expected));
  for (std::size_t i = 0; i < std::size(expected); ++i) {
    EXPECT_GE(result.states.readings[i].displacement, expected[i]);
    EXPECT_LT(result.states.readings[i].displacement, expected[i] + 0.1 * result.time_step);
  }
}

TEST(Readings, and_their_name_do_not_depend_on_what_is_written) {
  FailureMode first;
  for (int way = 0; way < 5; ++way) {
    ModelSpec spec = scenes::small_wall(1.2e-3, 0.1);
    if (way == 1) spec.output.states = {0.2e-3, 0.6e-3, 0.705e-3};
    if (way == 2) spec.output.rows = 7;
    if (way == 3) spec.output.window = 0.5e-3;
    if (way == 4) spec.output.rows = 3, spec.output.states = {1.1e-3};
    const Model model = compile(spec);
    State state = initial_state(model);
    SolveOptions options;
    options.read_modes_at = 0.7e-3;
    const Result result = solve(model, state, options);
    const FailureMode mode = name_failure_mode(model, result, 0.7e-3);
    if (way == 0) first = mode;
    EXPECT_EQ(mode.name, first.name) << way;
    EXPECT_EQ(mode.sentence, first.sentence) << way;
    EXPECT_EQ(mode.read_at, first.read_at) << way;
    EXPECT_EQ(text_of(mode.reading), "read at 0.70 mm") << way;
    ASSERT_EQ(mode.evidence.size(), first.evidence.size());
    for (std::size_t i = 0; i < first.evidence.size(); ++i)
      EXPECT_EQ(mode.evidence[i].value, first.evidence[i].value) << way;
  }
}

TEST(Readings, of_a_cyclic_push_are_taken_where_it_turns_farther_than_before) {
  ModelSpec spec = scenes::small_wall(1e-3, 0.1);
  spec.stage.back().get<PushStage>().until = kUnset;
  spec.stage.back().get<PushStage>().targets = {0.3e-3, -0.3e-3, 0.5e-3, -0.2e-3};
  const Model model = compile(spec);
  State state = initial_state(model);
  const Result result = solve(model, state);
  std::vector<double> turns;
  for (const Snapshot& s : result.states.readings)
    if (s.label == "turn") turns.push_back(s.displacement);
  ASSERT_GE(turns.size(), 2U);
  EXPECT_NEAR(turns.front(), 0.3e-3, 2 * 0.1 * result.time_step);
  EXPECT_NEAR(turns.back(), 0.5e-3, 2 * 0.1 * result.time_step);
  EXPECT_NEAR(result.failure_mode.read_at, 0.5e-3, 2 * 0.1 * result.time_step);
  EXPECT_EQ(result.failure_mode.name, name_failure_mode(model, result).name);
}

// --- where the model ends -------------------------------------------------------------------------------

// Two dry blocks of 0.4 x 0.2 m on the ground, or the lower one fixed; the upper one pushed off.
Result pushed_off(const std::string& pushed, bool on_support, double until) {
  ModelSpec spec = scenes::stack(2, 0.4, 0.2, scenes::dry_joint(2e9, 8e8, 0.3), 0.2, 2000);
  spec.block[0].fixed = on_support;
  spec.solve.collapse_displacement = 1;
  spec.stage = {scenes::gravity_stage(), scenes::push_stage(pushed, Direction::kPlusX, 0.5, until)};
  const Model model = compile(spec);
  State state = initial_state(model);
  return solve(model, state);
}

TEST(Validity, ends_where_faces_overlap_by_less_than_half) {
  for (const bool on_support : {false, true}) {
    const Result off = pushed_off("b1", on_support, 0.22);
    EXPECT_EQ(off.validity.joints, 1) << on_support;
    EXPECT_NEAR(off.validity.overlap_lost, 0.2, 2 * 0.22 / 500) << on_support;  // to the row
    const auto is_marked = [](const Event& e) { return e.name.code == "event.slid_off"; };
    EXPECT_TRUE(std::any_of(off.events.begin(), off.events.end(), is_marked));
    EXPECT_TRUE(pushed_off("b1", on_support, 0.19).validity.holds());
  }
  EXPECT_EQ(pushed_off("b1", false, 0.22).validity.where.code, "place.joint");
}

TEST(Validity, lasts_on_ground_that_goes_on) {
  EXPECT_TRUE(pushed_off("b0", false, 0.25).validity.holds());
}

// A dry stack of 0.4 x 0.8 m turns about its foot, pushed at 0.3 m. Its top goes farther than the push by more than
// collapse_displacement long before it falls at atan(0.5).
TEST(Collapse, is_no_wall_that_turns_with_the_push_and_carries_it) {
  const auto pushed = [](double until, const std::vector<double>& back = {}, bool holds = false) {
    ModelSpec spec = scenes::stack(4, 0.4, 0.2, scenes::dry_joint(2e9, 8e8, 0.9), 0.9, 2000);
    spec.solve.collapse_displacement = 0.02;
    StageSpec push = scenes::push_stage("b1", Direction::kPlusX, 0.05, until);
    if (!back.empty()) push.get<PushStage>().targets = back, push.get<PushStage>().until = kUnset;
    spec.stage = {scenes::gravity_stage(), push};
    if (holds) {  // a second push from where the first one ended
      spec.stage.push_back(scenes::push_stage("b1", Direction::kPlusX, 0.01, 0.005));
      spec.stage.back().name = "again";
    }
    const Model model = compile(spec);
    State state = initial_state(model);
    return solve(model, state);
  };
  const Result stands = pushed(0.03);
  EXPECT_EQ(stands.status, SolveStatus::kCompleted) << text_of(stands.reason);
  EXPECT_GT(stands.curve.back().reaction, 0.7 * 2000 * 9.81 * 0.4 * 0.8 * 0.2 / 0.3 * 0.2);
  EXPECT_EQ(pushed(0.25).status, SolveStatus::kCollapsed);
  const Result back = pushed(0.03, {0.03, 0});
  EXPECT_EQ(back.status, SolveStatus::kCompleted) << text_of(back.reason);
  const Result again = pushed(0.03, {}, true);
  EXPECT_EQ(again.status, SolveStatus::kCompleted) << text_of(again.reason);
}

TEST(Scenes, tuff_wall_is_the_paper_s) {
  const Model model = compile(scenes::tuff_wall(source_dir(), 1e-3));
  EXPECT_EQ(model.anatomy.masonry_blocks_before_lintels, 825);
  EXPECT_EQ(model.stages.back().spec.get<PushStage>().until, 1e-3);
}

// --- how stages end -------------------------------------------------------------------------------------

TEST(Stages, settling_that_fails_is_reported) {
  ModelSpec spec = scenes::small_wall();
  spec.stage.resize(1);
  spec.solve.settle_ratio = 1e-30;
  spec.solve.settle_limit = 0.01;
  const Model model = compile(spec);
  State state = initial_state(model);
  const Result result = solve(model, state);
  EXPECT_EQ(result.status, SolveStatus::kNotSettled);
  EXPECT_EQ(result.reason.code, "stage.not_settled") << result.reason;
}

TEST(Stages, an_unstable_step_is_reported_with_the_block) {
  Model model = compile(scenes::plain_wall(4, 4, 1e-3, 0.01));
  for (JointMaterial& m : model.materials) m = scenes::elastic_joint(20e9, 8e9);
  model.solve.step_fraction = 3;
  State state = initial_state(model);
  const Result result = solve(model, state);
  EXPECT_EQ(result.status, SolveStatus::kUnstable) << result.reason;
  EXPECT_EQ(result.reason.code, "block.runs_away") << result.reason;
}

TEST(Stages, a_wall_that_ran_away_has_not_collapsed) {
  ModelSpec spec = scenes::assembly(
      {scenes::rectangle("low", 0, 0, 0.2, 0.1), scenes::rectangle("high", 0, 0.1, 0.2, 0.1),
       scenes::rectangle("alone", 1, 0, 0.2, 0.1)},
      scenes::paper_joint(), 0.1, 2000);
  spec.stage = {scenes::push_stage("high", Direction::kPlusX, 1, 50e-3)};
  spec.stage[0].ramp = 1e-3;
  const Model model = compile(spec);
  const auto run = [&](double speed) {
    State state = initial_state(model);
    state.uy[2] = 10;  // far from everything, at a speed no wall has
    state.vy[2] = speed;
    return solve(model, state);
  };
  const Result quiet = run(1);
  EXPECT_EQ(quiet.status, SolveStatus::kCollapsed) << quiet.reason;
  const Result wild = run(1000);
  EXPECT_EQ(wild.status, SolveStatus::kUnstable) << wild.reason;
}

// Only a peak can be fallen from: a push back on a wall under force begins below any.
TEST(Stages, a_push_back_is_not_stopped_before_its_peak) {
  ModelSpec spec = scenes::small_wall(0.3e-3, 0.02);
  StageSpec back = spec.stage.back();
  back.name = "back", back.get<PushStage>().drive.direction = Direction::kMinusX,
  back.get<PushStage>().stop_below = 0.5;
  spec.stage.push_back(back);
  const Model model = compile(spec);
  State state = initial_state(model);
  const Result result = solve(model, state);
  EXPECT_EQ(result.status, SolveStatus::kCompleted) << result.reason;
  EXPECT_TRUE(result.reason.empty()) << result.reason;
  EXPECT_NEAR(result.curve.back().displacement, 0.3e-3, 1e-6);
}

TEST(Stages, stages_after_a_push_that_fell_go_on) {
  ModelSpec spec = scenes::stack(2, 0.2, 0.1, scenes::paper_joint(), 0.1, 2000);
  spec.stage = {scenes::gravity_stage(), scenes::push_stage("b1", Direction::kPlusX, 5e-4, 1e-3)};
  spec.stage[1].get<PushStage>().stop_below = 0.7;
  StageSpec hold{.name = "hold", .action = HoldStage{.duration = 0.01}};
  spec.stage.push_back(hold);
  const Model model = compile(spec);
  State state = initial_state(model);
  const Result result = solve(model, state);
  ASSERT_EQ(result.stages.size(), 3U);
  EXPECT_LT(state.progress.drive_displacement, 1e-3);
}

// The wall stands, so it has not collapsed. Each share above the rule's is read, and none below is but where the push
// has seen the fall last.
TEST(Stages, a_push_stops_where_the_reaction_has_fallen_to_stay) {
  ModelSpec spec = scenes::stack(2, 0.2, 0.1, scenes::paper_joint(), 0.1, 2000);
  spec.stage = {scenes::gravity_stage(), scenes::push_stage("b1", Direction::kPlusX, 5e-4, 1e-3)};
  spec.stage[1].get<PushStage>().stop_below = 0.7;
  const Model model = compile(spec);
  State state = initial_state(model);
  const Result result = solve(model, state);
  EXPECT_EQ(result.status, SolveStatus::kCompleted) << result.reason;
  EXPECT_EQ(result.reason.code, "push.fell_below") << result.reason;
  EXPECT_LT(result.curve.back().reaction, 0.7 * result.responses.peak_raw);
  EXPECT_LT(state.progress.drive_displacement, 1e-3);
  ASSERT_FALSE(result.responses.drift_capacity.empty());
  for (const FallTo& fall : result.responses.drift_capacity)
    EXPECT_TRUE(fall.fraction < 0.7 || !fall.censored) << fall.fraction;
  const double end = state.progress.drive_displacement;
  for (const FallTo& fall : result.responses.drift_capacity)
    EXPECT_EQ(fall.censored, end < (1 + kLastingShare) * fall.displacement) << fall.fraction;
}

// The side on which the force fell is said, with its sign.
TEST(Stages, a_push_to_and_fro_says_in_which_direction_it_fell) {
  for (const double way : {1.0, -1.0}) {
    ModelSpec spec = scenes::stack(2, 0.2, 0.1, scenes::paper_joint(), 0.1, 2000);
    spec.stage = {scenes::gravity_stage(), scenes::push_stage("b1", Direction::kPlusX, 5e-4, 1e-3)};
    spec.stage[1].get<PushStage>().stop_below = 0.7;
    spec.stage[1].get<PushStage>().targets = {-way * 0.02e-3, way * 1e-3};
    const Model model = compile(spec);
    State state = initial_state(model);
    const Message why = solve(model, state).reason;
    EXPECT_EQ(why.code, way > 0 ? "push.fell_below_along" : "push.fell_below_against") << why;
    EXPECT_NE(text_of(why).find(way > 0 ? "along the push" : "against the push"),
              std::string::npos);
    EXPECT_EQ(text_of(why).find("from -") != std::string::npos, way < 0) << why;
  }
}

TEST(Stages, a_push_without_a_velocity_adapts_it) {
  ModelSpec spec = scenes::stack(2, 0.2, 0.1, scenes::paper_joint(), 0.1, 2000);
  spec.stage = {scenes::gravity_stage(), scenes::push_stage("b1", Direction::kPlusX, kUnset, 1e-3)};
  const StageSpec push = compile(spec).stages[1].spec;
  EXPECT_EQ(push.get<PushStage>().velocity, kWaitingVelocity);
  EXPECT_EQ(push.get<PushStage>().fast_velocity, kAdaptedVelocity);
  spec.stage[1].get<PushStage>().fast_velocity = 2e-3;
  EXPECT_EQ(compile(spec).stages[1].spec.get<PushStage>().fast_velocity, 2e-3);
  spec.stage[1].get<PushStage>().fast_velocity = kUnset;
  spec.stage[1].get<PushStage>().velocity = 1e-3;
  EXPECT_TRUE(std::isnan(compile(spec).stages[1].spec.get<PushStage>().fast_velocity));
}

// Seconds of a cracking wall that is pushed at 20 mm/s, and at 100 mm/s while its unbalance is less than `below`.
double push_seconds(double fast, double below) {
  ModelSpec spec = scenes::small_wall(3e-3, 0.02);
  spec.stage.back().ramp = 0.05;
  spec.stage.back().get<PushStage>().fast_velocity = fast;
  spec.stage.back().get<PushStage>().fast_below = below;
  const Model model = compile(spec);
  State state = initial_state(model);
  const Result result = solve(model, state);
  EXPECT_EQ(result.status, SolveStatus::kCompleted) << result.reason;
  EXPECT_GT(result.energy.fracture, 0);
  return result.stages.back().time;
}

TEST(Stages, a_push_goes_fast_while_the_wall_is_near_balance) {
  const double slow = push_seconds(kUnset, 2e-4);
  EXPECT_EQ(push_seconds(0.1, 1e-12), slow);  // never quiet enough
  // always quiet: from 20 to 100 mm/s within the smooth start's 0.05 s, then at 100 mm/s
  const double fast = push_seconds(0.1, 10);
  EXPECT_NEAR(fast, 0.05 + (3e-3 - 0.05 * 0.038) / 0.1, 0.1 * fast);
  const double between = push_seconds(0.1, 2e-3);
  EXPECT_LT(between, 0.95 * slow);
  EXPECT_GT(between, 1.05 * fast);
}

TEST(Stages, a_set_flag_interrupts) {
  const Model model = compile(scenes::small_wall());
  State state = initial_state(model);
  const std::atomic<bool> stop{true};
  SolveOptions options;
  options.stop = &stop;
  EXPECT_EQ(solve(model, state, options).status, SolveStatus::kInterrupted);
  EXPECT_LE(state.step, 1000);
}

TEST(Stages, mass_scaling_shortens_settling_and_leaves_the_answer) {
  ModelSpec spec = scenes::small_wall();
  spec.stage.resize(2);
  spec.solve.settle_ratio = 1e-8;
  std::vector<double> settled;
  std::int64_t steps = 0;
  for (const double scaling : {1.0, 100.0}) {
    spec.solve.mass_scaling = scaling;
    const Model model = compile(spec);
    State state = initial_state(model);
    const Result result = solve(model, state);
    ASSERT_EQ(result.status, SolveStatus::kCompleted) << result.reason;
    settled.push_back(*std::min_element(state.uy.begin(), state.uy.end()));
    if (scaling == 1)
      steps = result.steps;
    else
      EXPECT_LT(result.steps, steps / 2);
  }
  EXPECT_NEAR(settled[1] / settled[0], 1.0, 1e-3);  // slip in the joints on the way may differ
}

// The smooth start is slow: steps there are many and short, and must not outweigh those that follow.
TEST(Stages, a_row_is_the_mean_over_its_path_however_fast_the_push_goes) {
  ModelSpec spec = scenes::stack(1, 0.2, 0.1, scenes::paper_joint(), 0.1, 2000);
  spec.stage = {scenes::gravity_stage(),
                scenes::push_stage("b0", Direction::kPlusX, 1e-4, 0.01e-3)};
  spec.stage[1].get<PushStage>().fixity = {Freedom::kBlocked, Freedom::kBlocked};
  spec.stage[1].ramp = 0.08;  // nearly half of the path
  spec.output.rows = 10;
  const Model model = compile(spec);
  State state = initial_state(model);
  const Result result = solve(model, state);
  ASSERT_EQ(result.status, SolveStatus::kCompleted) << result.reason;
  ASSERT_GE(result.curve.size(), 10U);
  const double stiffness = scenes::paper_joint().shear_stiffness * 0.2 * 0.1;
  for (std::size_t k = 1; k < result.curve.size(); ++k) {
    const double middle = 0.5 * (result.curve[k - 1].displacement + result.curve[k].displacement);
    EXPECT_NEAR(result.curve[k].reaction, stiffness * middle, 0.01 * stiffness * middle) << k;
    EXPECT_NEAR(result.curve[k].base_shear, stiffness * middle, 0.05 * stiffness * middle)
        << k;  // every 8th step
  }
  EXPECT_NEAR(result.responses.initial_stiffness, stiffness, 0.01 * stiffness);
}

TEST(Stages, what_settling_damped_is_not_the_pushs_share) {
  ModelSpec spec = scenes::small_wall(0.2e-3, 0.02);
  spec.stage[0].ramp = spec.stage[1].ramp = 1e-4;  // shakes the wall
  const Model model = compile(spec);
  spec.stage.resize(2);
  const Model settling = compile(spec);
  State state = initial_state(settling);
  const double before = solve(settling, state).energy.damping;
  state = initial_state(model);
  const Result result = solve(model, state);
  const double push = result.energy.damping - before;
  EXPECT_GT(before, push);
  EXPECT_NEAR(result.curve.back().work_damping, push, 0.01 * push);
}

TEST(Stages, a_cyclic_push_visits_its_targets) {
  ModelSpec spec = scenes::stack(1, 0.2, 0.1, scenes::paper_joint(), 0.1, 2000);
  spec.stage = {scenes::gravity_stage(), scenes::push_stage("b0", Direction::kPlusX, 0.01, 1e-3)};
  spec.stage[1].get<PushStage>().targets = {1e-3, -0.5e-3, 0};
  const Model model = compile(spec);
  State state = initial_state(model);
  const Result result = solve(model, state);
  ASSERT_EQ(result.status, SolveStatus::kCompleted) << result.reason;
  double high = 0, low = 0;
  for (const CurveRow& row : result.curve) {
    high = std::max(high, row.displacement);
    low = std::min(low, row.displacement);
  }
  const double window = 4e-3 / 500 + 0.01 * result.time_step;
  EXPECT_NEAR(high, 1e-3, window);
  EXPECT_NEAR(low, -0.5e-3, window);
  EXPECT_NEAR(state.progress.drive_displacement, 0, window);
}

}  // namespace
}  // namespace wythe::dynamics_test
