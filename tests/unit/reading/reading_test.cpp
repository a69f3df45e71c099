// Readings of blocks, joints and points in a state (wythe/parts/reading.h), and their vectors.
#include "wythe/parts/reading.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <numeric>

#include "scenes/rig.h"
#include "scenes/scenes.h"
#include "scenes/zones.h"
#include "wythe/parts/solve.h"

namespace wythe::reading_test {
namespace {

using scenes::Rig;
constexpr double kPi = std::numbers::pi;

void expect_near(Vec3 a, Vec3 b, double tolerance) { EXPECT_LE(length(a - b), tolerance); }

TEST(Vectors, a_quarter_turn_about_each_axis_moves_the_next_axis_to_the_third) {
  const Vec3 x{1, 0, 0}, y{0, 1, 0}, z{0, 0, 1};
  expect_near(turned(x, {kPi / 2 * z}), y, 1e-15);
  expect_near(turned(y, {kPi / 2 * x}), z, 1e-15);
  expect_near(turned(z, {kPi / 2 * y}), x, 1e-15);
  expect_near(turned(x, {{0, 0, -kPi / 2}}, y), {0, 0, 0}, 1e-15);
}

TEST(Vectors, a_turn_about_any_axis_keeps_lengths_and_that_axis_and_is_undone_backwards) {
  const Rotation r{{0.3, -0.8, 1.1}}, back{-1.0 * r.by};
  const Vec3 v{2, 0.5, -1};
  EXPECT_NEAR(length(turned(v, r)), length(v), 1e-15);
  EXPECT_NEAR(dot(turned(v, r), r.by), dot(v, r.by), 1e-15);
  expect_near(turned(r.by, r), r.by, 1e-15);
  expect_near(turned(turned(v, r), back), v, 1e-15);
}

TEST(Vectors, many_small_turns_are_one_large_one) {
  const Rotation whole{{0.3, -0.8, 1.1}}, part{whole.by / 1000};
  Vec3 v{2, 0.5, -1};
  const Vec3 at_once = turned(v, whole);
  for (int i = 0; i < 1000; ++i) v = turned(v, part);
  expect_near(v, at_once, 1e-12);  // 1000 roundings
}

TEST(Reading, points_of_joints_and_contacts_are_the_history_each_once) {
  for (const int points : {2, 5}) {
    ModelSpec spec = scenes::lintel_wall(LintelModel::kZones);
    spec.solve.points_per_face = points;
    const Model model = compile(spec);
    ASSERT_GT(joint_count(model), model.n_joint);
    PointId next = 0;
    for (JointId j = 0; j < joint_count(model); ++j) {
      EXPECT_EQ(points_of(model, j).begin, next);
      next = points_of(model, j).end;
    }
    EXPECT_EQ(next, model.n_history());
  }
}

TEST(Reading, shares_of_a_joint_s_area_sum_to_it_and_its_frame_is_right_handed) {
  const Model model = compile(scenes::lintel_wall(LintelModel::kZones));
  const WallReading wall = read_wall(model, initial_state(model));
  ASSERT_EQ(wall.joints.size(), static_cast<std::size_t>(joint_count(model)));
  for (const JointReading& joint : wall.joints) {
    double share = 0;
    for (const PointReading& point : wall.points_of(joint)) share += point.share;
    EXPECT_NEAR(share, 1, 1e-15);
    expect_near(cross(joint.shape.along, joint.shape.normal), {0, 0, 1}, 1e-12);
    expect_near(joint.where, joint.shape.centre, 1e-12);
    const auto ends = ends_now(model, initial_state(model), joint.shape.id);
    expect_near(0.5 * (ends[1] - ends[0]), joint.shape.half, 1e-12);
  }
}

// Four blocks pressed off their middle: on every joint below, what holds the blocks above in balance.
TEST(Reading, compression_shear_and_moment_hold_what_stands_above) {
  ModelSpec spec = scenes::stack(4, 0.3, 0.2, scenes::elastic_joint(20e9, 8e9), 0.1, 2000);
  Model model = compile(spec);
  constexpr double kLoad = 2e3, kOff = 0.03, kPush = 50;
  const std::size_t load = scenes::add_load(model, {3, kOff, 0, kPush, -kLoad});
  Rig rig(std::move(model));
  rig.state.load_scale[load] = 1;
  rig.settle(1e-10);
  for (const JointReading& joint : read_wall(rig.model, rig.state).joints) {
    EXPECT_NEAR(joint.compression, kLoad, 1e-5 * kLoad);
    EXPECT_NEAR(joint.shear, kPush, 1e-3 * kPush);  // leans by a few 1e-6 rad under 2 kN
    const double moment = kOff * kLoad + kPush * (rig.model.centroid_y[3] - joint.shape.centre.y);
    EXPECT_NEAR(joint.moment, moment, 1e-3 * moment);
    EXPECT_NEAR(joint.eccentricity, joint.moment / joint.compression / length(joint.shape.half),
                1e-12);
    EXPECT_LT(joint.normal_stress, 0);
    EXPECT_NEAR(-joint.normal_stress * joint.shape.area, joint.compression, 1e-9 * kLoad);
  }
}

TEST(Reading, a_block_that_has_turned_says_so_and_its_corners_follow) {
  const Model model =
      compile(scenes::stack(2, 0.4, 0.2, scenes::elastic_joint(20e9, 8e9), 0.1, 2000));
  State state = initial_state(model);
  state.ux[1] = 0.1;
  state.theta[1] = kPi / 2;
  const BlockReading block = read_block(model, state, 1);
  expect_near(block.moved, {0.1, 0, 0}, 0);
  expect_near(block.turned.by, {0, 0, kPi / 2}, 0);
  const std::vector<Vec3> rest = outline_of(model, 1), now = outline_now(model, state, 1);
  for (std::size_t i = 0; i < rest.size(); ++i) {
    const Vec3 arm = rest[i] - block.start;
    expect_near(now[i], block.start + block.moved + Vec3{-arm.y, arm.x}, 1e-15);
  }
  // magnified: the way in full, the turn up to a quarter
  const std::vector<Vec3> far = outline_now(model, state, 1, 3);
  for (std::size_t i = 0; i < rest.size(); ++i) expect_near(far[i] - now[i], {0.2, 0, 0}, 1e-15);
}

TEST(Reading, of_the_bearings_of_a_deformable_lintel_the_forces_carry_its_weight) {
  ModelSpec spec = scenes::lintel_wall(LintelModel::kZones);
  spec.stage = {scenes::gravity_stage()};
  const Model model = compile(spec);
  State state = initial_state(model);
  ASSERT_EQ(solve(model, state, {}).status, SolveStatus::kCompleted);
  double up = 0;  // on the lintel
  for (const JointReading& joint : read_wall(model, state).joints) {
    if (joint.shape.id < model.n_joint) continue;
    EXPECT_EQ(joint.shape.b, model.n_block);
    up += joint.compression * joint.shape.normal.y - joint.shear * joint.shape.along.y;
  }
  const std::vector<double>& mass = model.solids.node_gravity_mass;
  const double weight = model.solve.gravity * std::accumulate(mass.begin(), mass.end(), 0.0);
  EXPECT_NEAR(up / weight, 1, 1e-3);  // settled
}

}  // namespace
}  // namespace wythe::reading_test
