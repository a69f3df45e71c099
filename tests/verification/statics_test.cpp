// Statics: a block on a slope, a stack, a cantilever column, tilting (CF01, CF05, CF06, CF09, CF20).
#include <gtest/gtest.h>

#include <cmath>

#include "scenes/rig.h"
#include "scenes/scenes.h"
#include "verification/record.h"
#include "wythe/parts/solve.h"

namespace wythe::verification::statics_test {
namespace {

using scenes::degrees;
using scenes::Rig;

constexpr double kGravity = 9.81;

// 100 kg on 0.1 m^2: 1.0 x 0.1 x 0.1 m. Low, so that the slope moves the pressure little.
ModelSpec slab(double friction) {
  return scenes::block_on_ground(1.0, 0.1, scenes::dry_joint(10e9, 4e9, std::atan(friction)), 0.1,
                                 1e4);
}

void tilt_gravity(State& state, double angle) {
  state.gravity_x = kGravity * std::sin(angle);
  state.gravity_y = -kGravity * std::cos(angle);
}

TEST(ClosedForm, CF01a_block_on_slope_sticks) {
  Rig rig(compile(slab(0.7)));
  // a smooth start along the friction cone: no transient slips
  for (int k = 1; k <= 2000; ++k) {
    tilt_gravity(rig.state, degrees(30));
    rig.state.gravity_x *= k / 2000.0;
    rig.step();
  }
  rig.settle(1e-9);
  const double slip = 0.5 * (rig.point(0, 0).slip + rig.point(0, 1).slip);
  verify({"CF01a", "block on a slope, stick: elastic slip", "m", 1.22625e-6, 1e-5,
          "settled to an unbalance of 1e-9; the value has 6 digits"},
         slip);
  EXPECT_EQ(rig.state.slip[0] + rig.state.slip[1], 0.0);
}

TEST(ClosedForm, CF01b_slope_angle_at_which_sliding_starts) {
  ModelSpec spec = slab(0.6);
  StageSpec tilt{.name = "tilt",
                 .action = TiltStage{.tilt_rate = degrees(1), .tilt_until = degrees(45)}};
  spec.stage = {scenes::gravity_stage(), tilt};
  const Model model = compile(spec);
  State state = initial_state(model);
  const Result result = solve(model, state);
  // at the limit the slab creeps: it may be given up as unsettled before it has moved far
  EXPECT_NE(result.status, SolveStatus::kCompleted) << result.reason;
  verify({"CF01b", "slope angle at which sliding starts", "deg", 30.96376, 0.02,
          "the tilt halts while the unbalance is above settle_ratio", true},
         std::atan(result.load_factor) * 180 / scenes::kPi);
}

// Ten blocks of 20 kg, 0.3 x 0.1 m in plan.
Model stack_of_ten() {
  ModelSpec spec =
      scenes::stack(10, 0.3, 0.2, scenes::dry_joint(20e9, 8e9, degrees(30)), 0.1, 20 / 0.006);
  spec.stage = {scenes::gravity_stage()};
  spec.solve.settle_ratio = 1e-8;
  return compile(spec);
}

TEST(ClosedForm, CF05_stack_normal_forces) {
  const Model model = stack_of_ten();
  State state = initial_state(model);
  ASSERT_EQ(solve(model, state).status, SolveStatus::kCompleted);
  for (const JointReading& joint : read_wall(model, state).joints) {
    const double force = joint.compression;
    const BlockId above = joint.shape.b;
    EXPECT_NEAR(force, (10 - above) * 20 * kGravity, 1e-6 * 1962) << "joint under block " << above;
    if (above == 0)
      verify({"CF05", "stack of 10 blocks: normal force under the lowest", "N", 1962, 1e-6,
              "settled to an unbalance of 1e-8"},
             force);
  }
}

TEST(ClosedForm, CF06_stack_settlement) {
  const Model model = stack_of_ten();
  State state = initial_state(model);
  ASSERT_EQ(solve(model, state).status, SolveStatus::kCompleted);
  verify({"CF06", "settlement of the top block of the stack", "m", 1.7985e-5, 1e-5,
          "settled to an unbalance of 1e-8; springs in series"},
         -state.uy[9]);
}

// Tip displacement of the column of CF09 with n points a face [m].
double column_tip(int points) {
  ModelSpec spec = scenes::stack(10, 0.2, 0.1, scenes::elastic_joint(20e9, 8e9), 0.1, 2000);
  spec.solve.points_per_face = points;
  Model model = compile(spec);
  const std::size_t load = scenes::add_load(model, {9, 0, 0.05, 100, 0});
  Rig rig(std::move(model));
  for (int k = 1; k <= 2000; ++k) {
    rig.state.load_scale[load] = k / 2000.0;
    rig.step();
  }
  rig.settle(1e-8);
  return rig.state.ux[9] - std::sin(rig.state.theta[9]) * 0.05;
}

constexpr const char* kColumn =
    "settled to an unbalance of 1e-8; rotations of 1e-4 change the lever by 1e-8";

TEST(ClosedForm, CF09_cantilever_column_two_points) {
  verify({"CF09", "cantilever column, tip displacement, 2 points a face", "m", 0.0001025, 1e-5,
          kColumn},
         column_tip(2));
}

TEST(ClosedForm, CF09_cantilever_column_three_points) {
  verify({"CF09", "cantilever column, tip displacement, 3 points a face", "m", 0.00019875, 1e-5,
          kColumn},
         column_tip(3));
}

TEST(ClosedForm, CF09_cantilever_column_many_points) {
  // sum w xi^2 of n points is (1 + 2/(n-1)^2)/3: the flexibility tends to the continuous joint's
  // with the square of the spacing, so two results extrapolate to it.
  const double u4 = column_tip(4), u8 = column_tip(8), u15 = column_tip(15);
  const double limit = 0.000295;
  const double order = std::log((limit - u8) / (limit - u15)) / std::log(14.0 / 7.0);
  EXPECT_NEAR(order, 2.0, 0.05);
  EXPECT_LT(u4, u8);
  const double extrapolated = (4 * u15 - u8) / 3;
  verify({"CF09", "cantilever column, many points (8 and 15, extrapolated)", "m", limit, 5e-4,
          "fourth-order rest of the Richardson extrapolation, 1/7^4 = 4.2e-4"},
         extrapolated);
}

// Tilts a dry stack of n blocks that together are 0.4 x 1.6 m until it falls [deg]. Slowly: what
// tilts on before the unbalance is noticed is counted as carried.
double tilt_at_collapse(int n) {
  ModelSpec spec =
      scenes::stack(n, 0.4, 1.6 / n, scenes::dry_joint(20e9, 8e9, std::atan(0.7)), 0.1, 2000);
  StageSpec tilt{.name = "tilt",
                 .action = TiltStage{.tilt_rate = degrees(1), .tilt_until = degrees(30)}};
  spec.stage = {scenes::gravity_stage(), tilt};
  const Model model = compile(spec);
  State state = initial_state(model);
  const Result result = solve(model, state);
  EXPECT_EQ(result.status, SolveStatus::kCollapsed) << result.reason;
  return std::atan(result.load_factor) * 180 / scenes::kPi;
}

constexpr const char* kTilt =
    "the tilt halts while the unbalance is above settle_ratio; elastic P-delta";

TEST(ClosedForm, CF20_tilt_angle_of_collapse_of_a_block) {
  verify({"CF20", "tilt angle of collapse of a block", "deg", 14.03624, 0.03, kTilt, true},
         tilt_at_collapse(1));
}

TEST(ClosedForm, CF20_tilt_angle_of_collapse_of_a_dry_stack) {
  verify({"CF20", "tilt angle of collapse of a dry stack of 4", "deg", 14.03624, 0.03, kTilt, true},
         tilt_at_collapse(4));
}

TEST(ClosedForm, CF20_uplift_acceleration) {
  ModelSpec spec =
      scenes::block_on_ground(0.5, 2.0, scenes::dry_joint(20e9, 8e9, degrees(60)), 0.1, 2000);
  StageSpec quake{.name = "quake", .action = BodyForceStage{.rate = 0.005, .factor = 1}};
  spec.stage = {scenes::gravity_stage(), quake};
  const Model model = compile(spec);
  State state = initial_state(model);
  const Result result = solve(model, state);
  EXPECT_EQ(result.status, SolveStatus::kCollapsed) << result.reason;
  verify({"CF20", "uplift acceleration of a block, b/h = 0.25", "m/s^2", 2.4525, 1e-3,
          "the factor halts while the unbalance is above settle_ratio; elastic P-delta"},
         kGravity * result.load_factor);
}

}  // namespace
}  // namespace wythe::verification::statics_test
