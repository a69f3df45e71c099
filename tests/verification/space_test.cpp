// Bodies in space against closed forms: statics, sliding in every direction, overturning, a cantilever, and
// the same walls in their plane.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "record.h"
#include "scenes/run.h"
#include "scenes/scenes.h"
#include "wythe/parts/reading.h"
#include "wythe/parts/solve.h"

namespace wythe::space_test {
namespace {

using scenes::box;
using scenes::Outcome;
using scenes::run;
using verification::verify;

constexpr double kG = 9.81, kDensity = 2000;

BodySpec floor_slab() { return box("floor", {-2, -0.2, -2}, {4, 0.2, 4}, true); }

StageSpec push(const std::string& block, Vec3 along, double velocity, double until) {
  StageSpec stage = scenes::push_stage(block, Direction::kPlusX, velocity, until);
  stage.get<PushStage>().drive.along = {along.x, along.y, along.z};
  return stage;
}

TEST(Space, a_stack_settles_as_springs_in_series) {
  std::vector<BodySpec> bodies{floor_slab()};
  for (int k = 0; k < 10; ++k)
    bodies.push_back(box("b" + std::to_string(k), {0, 0.1 * k, 0}, {0.3, 0.1, 0.2}));
  ModelSpec spec = scenes::in_space(bodies, scenes::elastic_joint(20e9, 8e9), kDensity);
  spec.stage = {scenes::gravity_stage()};
  const Outcome r = run(spec);
  ASSERT_EQ(r.result.status, SolveStatus::kCompleted);
  EXPECT_EQ(r.model.n_joint, 10);
  const double weight = kDensity * 0.3 * 0.1 * 0.2 * kG;
  double settled = 0;
  for (int k = 1; k <= 10; ++k) settled += k * weight / (20e9 * 0.3 * 0.2);
  verify({"SP06", "stack of ten in space: settlement of the top", "m", settled, 1e-3,
          "settled to an unbalance of 1e-5"},
         -r.state.uy[9]);
  const WallReading wall = read_wall(r.model, r.state);
  double most = 0;
  for (const JointReading& joint : wall.joints) most = std::fmax(most, joint.compression);
  verify({"SP05", "stack of ten in space: force in the lowest joint", "N", 10 * weight, 1e-4,
          "settled to an unbalance of 1e-5"},
         most);
}

TEST(Space, a_block_slides_at_the_same_force_in_twelve_directions) {
  const double mu = 0.6;
  for (int k = 0; k < 12; ++k) {
    const double angle = k * M_PI / 6;
    ModelSpec spec = scenes::in_space({floor_slab(), box("b", {-0.2, 0, -0.1}, {0.4, 0.1, 0.2})},
                                      scenes::dry_joint(1e9, 4e8, std::atan(mu)), kDensity);
    spec.stage = {scenes::gravity_stage(),
                  push("b", {std::cos(angle), 0, std::sin(angle)}, 2e-3, 1e-3)};
    spec.stage.back().get<PushStage>().fixity.rotation = Freedom::kBlocked;
    const Outcome r = run(spec);
    const double weight = kDensity * 0.4 * 0.1 * 0.2 * kG;
    verify({"SP02", "sliding force at " + std::to_string(30 * k) + " degrees", "N", mu * weight,
            1e-3, "balance of the push"},
           r.result.curve.back().reaction);
    const double across = -std::sin(angle) * r.state.ux[0] + std::cos(angle) * r.state.uz[0];
    EXPECT_LT(std::fabs(across), 1e-9) << k;
  }
}

// A block that overturns about an edge: the largest horizontal share of the weight is b / h, whichever
// edge it is and however the block stands to the axes.
TEST(Space, a_block_overturns_about_each_edge) {
  struct Case {
    double turn;
    Vec3 along;
    double ratio;
  };
  for (const Case& c : {Case{0, {1, 0, 0}, 0.3 / 1.2}, Case{0, {0, 0, 1}, 0.2 / 1.2},
                        Case{0, {0, 0, -1}, 0.2 / 1.2}, Case{0.5, {1, 0, 0}, 0.3 / 1.2}}) {
    ModelSpec spec = scenes::in_space({floor_slab(), box("b", {-0.15, 0, -0.1}, {0.3, 1.2, 0.2})},
                                      scenes::dry_joint(2e10, 8e9, std::atan(2.0)), kDensity);
    StageSpec force{
        .name = "force",
        .action = BodyForceStage{
            .drive = {.along = {c.along.x, c.along.y, c.along.z}}, .rate = 0.02, .factor = 0.5}};
    spec.stage = {scenes::gravity_stage(), force};
    const Outcome r = run(scenes::turned_about_y(spec, c.turn));
    EXPECT_EQ(r.result.status, SolveStatus::kCollapsed);
    verify({"SP20", "overturning of a block in space", "-", c.ratio, 1e-2,
            "Lobatto points at the edge; the servo stops short"},
           r.result.load_factor);
  }
}

TEST(Space, a_cantilever_bends_about_both_axes_as_a_continuous_one) {
  const double b = 0.2, t = 0.1, h = 0.1, kn = 20e9, ks = 8e9;
  for (const bool weak : {false, true}) {
    std::vector<BodySpec> bodies{floor_slab()};
    for (int k = 0; k < 10; ++k)
      bodies.push_back(box("b" + std::to_string(k), {-b / 2, h * k, -t / 2}, {b, h, t}));
    ModelSpec spec = scenes::in_space(bodies, scenes::elastic_joint(kn, ks), kDensity);
    spec.solve.gravity = 0;
    spec.stage = {push("b9", weak ? Vec3{0, 0, 1} : Vec3{1, 0, 0}, 4e-5, 2e-5)};
    spec.stage.front().ramp = 0.2;
    const Outcome r = run(spec);
    const double deep = weak ? t : b, wide = weak ? b : t;
    const double stiff = kn * wide * deep * deep * deep / 12;
    double compliance = 0;  // at the centroid of the topmost block
    for (int k = 0; k < 10; ++k) {
      const double lever = 9.5 * h - k * h;
      compliance += 1 / (ks * b * t) + lever * lever / stiff;
    }
    verify({"SP09", weak ? "cantilever in space, weak axis" : "cantilever in space, strong axis",
            "N/m", 1 / compliance, 5e-3, "slow push"},
           r.result.curve.back().reaction / r.result.curve.back().displacement);
  }
}

TEST(Space, energy_is_kept_and_the_world_may_turn) {
  std::vector<BodySpec> bodies{floor_slab(), box("a", {-0.2, 0, -0.1}, {0.4, 0.2, 0.2}),
                               box("b", {-0.1, 0.2, -0.05}, {0.3, 0.2, 0.2}),
                               box("c", {-0.2, 0.4, -0.1}, {0.3, 0.2, 0.15})};
  ModelSpec spec = scenes::in_space(bodies, scenes::dry_joint(2e9, 8e8, std::atan(0.5)), kDensity);
  spec.stage = {scenes::gravity_stage(), push("b", {0.8, 0, 0.6}, 0.02, 10e-3)};
  const Outcome here = run(spec);
  EXPECT_LT(here.result.energy.gap_ratio, 1e-3);
  const double angle = 0.7;
  // stick and slip magnify rounding: a turn by 1e-9 moves the blocks as much as this one
  constexpr double kRounding = 2e-7;
  const Outcome there = run(scenes::turned_about_y(spec, angle));
  for (std::size_t i = 0; i < 3; ++i) {
    const Vec3 moved =
        turned(Vec3{here.state.ux[i], here.state.uy[i], here.state.uz[i]}, Rotation{{0, angle, 0}});
    EXPECT_NEAR(moved.x, there.state.ux[i], kRounding) << i;
    EXPECT_NEAR(moved.y, there.state.uy[i], kRounding) << i;
    EXPECT_NEAR(moved.z, there.state.uz[i], kRounding) << i;
  }
}

// A wall of prisms, its motion in the plane, against the plane engine with equal points: the same elastic
// state once it is held.
TEST(Space, a_wall_of_prisms_is_the_plane_wall) {
  ModelSpec plane = scenes::half_units({}, scenes::elastic_joint(20e9, 8e9));
  plane.solve.points_per_face = 3;
  plane.solve.point_rule = PointRule::kLobatto;
  plane.solve.settle_ratio = 1e-10;
  StageSpec hold{.name = "hold", .action = HoldStage{.duration = 0.2}};
  plane.stage = {scenes::gravity_stage(), scenes::push_stage("r7c0", Direction::kPlusX, 0.01, 1e-5),
                 hold};
  plane.stage[1].ramp = 2e-4;
  const Outcome flat = run(plane);
  const Outcome solid = run(scenes::prisms(plane));
  ASSERT_EQ(flat.model.n_joint, solid.model.n_joint);
  for (std::size_t i = 0; i < flat.state.ux.size(); ++i) {
    EXPECT_NEAR(flat.state.ux[i], solid.state.ux[i], 1e-6 * 1e-5) << i;
    EXPECT_NEAR(flat.state.uy[i], solid.state.uy[i], 1e-6 * 1e-5) << i;
    EXPECT_LT(std::fabs(solid.state.uz[i]), 1e-15) << i;
  }
}

}  // namespace
}  // namespace wythe::space_test
