// A quick limit load beside the exact one: the same wall is refused or answered, the loads differ by kQuickError at
// most, and the mechanism is one that the joints allow.
#include <gtest/gtest.h>

#include <rapidcheck/gtest.h>
#include <algorithm>
#include <cmath>
#include <string>

#include "limit/plane/programmes.h"
#include "scenes/places.h"
#include "scenes/scenes.h"
#include "wythe/parts/error.h"
#include "wythe/parts/io.h"
#include "wythe/parts/limit.h"
#include "wythe/parts/quick_limit.h"

namespace wythe::quick_limit_test {
namespace {

StageSpec body_force() {
  return {.name = "body force",
          .action =
              BodyForceStage{.drive = {.direction = Direction::kPlusX}, .rate = 0.1, .factor = 2}};
}

StageSpec tilt() {
  return {.name = "tilt", .action = TiltStage{.tilt_rate = 0.01, .tilt_until = 1.5}};
}

// A wall in running bond with a window, under a load on its piers.
ModelSpec any_wall() {
  constexpr double kHalf = 0.155, kCourse = 0.11;
  const int columns = *rc::gen::inRange(6, 15), courses = *rc::gen::inRange(5, 13);
  ModelSpec spec = scenes::small_wall(2e-3, 0.02, *rc::gen::element(1e3, 20e3, 200e3));
  spec.wall.length = kHalf * columns;
  spec.wall.height = kCourse * courses;
  OpeningSpec& window = spec.wall.opening.front();
  const int width = *rc::gen::inRange(1, columns - 3), height = *rc::gen::inRange(1, courses - 2);
  window.width = kHalf * width;
  window.height = kCourse * height;
  window.x = kHalf * *rc::gen::inRange(1, columns - width);
  window.y = kCourse * *rc::gen::inRange(0, courses - height - 1);
  for (auto& [name, joint] : spec.material) {
    joint.friction_angle = scenes::degrees(*rc::gen::inRange(5, 50));
    joint.residual_friction_angle = joint.friction_angle;
    joint.residual_cohesion = *rc::gen::element(0.0, 0.0, 1e3, 50e3);
  }
  spec.stage.back().get<PushStage>().at.y = kCourse * (courses - 1.5);
  switch (*rc::gen::inRange(0, 4)) {
    case 0: spec.stage.back() = body_force(); break;
    case 1: spec.stage.back() = tilt(); break;
    default: break;
  }
  return *rc::gen::arbitrary<bool>() ? spec : scenes::with_fields(spec, *rc::gen::inRange(1, 99));
}

struct Answer {
  LimitResult limit;
  std::string refusal;  // what is wrong, not where
};

Answer answer_of(const Model& model, const LimitOptions& options, bool quick) {
  try {
    return {(quick ? quick_limit_load : limit_load)(model, options, {}), ""};
  } catch (const InputError& error) {
    return {{}, error.faults().front().problem};
  }
}

// The largest share of the fastest velocity by which a joint closes, or slips without the opening that its friction
// makes.
double broken_flow(const Model& m, const LimitResult& a) {
  double fastest = 0, broken = 0;
  for (std::size_t i = 0; i < a.vx.size(); ++i)
    fastest = std::max(fastest, std::hypot(a.vx[i], a.vy[i]));
  for (int j = 0; j < m.n_joint; ++j) {
    const double tx = m.tangent_x[j], ty = m.tangent_y[j];
    const auto jump = [&](double nx, double ny, double xi) {
      double sum = 0;
      const auto add = [&](BlockId block, double sign, double x, double y) {
        if (block == kGroundBlock) return;
        const auto i = static_cast<std::size_t>(block);
        x += xi * m.half_x[j];
        y += xi * m.half_y[j];
        sum += sign * (nx * (a.vx[i] - a.omega[i] * y) + ny * (a.vy[i] + a.omega[i] * x));
      };
      add(m.joint_b[j], 1, m.arm_b_x[j], m.arm_b_y[j]);
      add(m.joint_a[j], -1, m.arm_a_x[j], m.arm_a_y[j]);
      return sum;
    };
    const double friction = std::tan(m.materials[m.joint_material[j]].friction_angle);
    for (const double xi : {-1.0, 1.0})
      broken = std::max(broken, friction * std::fabs(jump(tx, ty, 0)) - jump(-ty, tx, xi));
  }
  return broken / fastest;
}

RC_GTEST_PROP(quick_limit, is_the_exact_load_to_its_error, ()) {
  const Model model = compile(any_wall());
  const LimitOptions options{
      .strength =
          *rc::gen::element(JointStrength::kDry, JointStrength::kDry, JointStrength::kBonded),
      .crushing = *rc::gen::element(CrushingChoice::kNone, CrushingChoice::kPoints)};
  const Answer exact = answer_of(model, options, false), quick = answer_of(model, options, true);
  // the tilts before the last one differ, and with them which of its refusals a tilt comes to first
  const bool tilts = model.stages.back().spec.kind() == StageKind::kTilt;
  const bool alike =
      tilts ? quick.refusal.empty() == exact.refusal.empty() : quick.refusal == exact.refusal;
  RC_ASSERT(alike);
  if (!exact.refusal.empty()) return;
  const double load = exact.limit.load, error = kQuickError * std::fabs(load);
  RC_ASSERT(std::fabs(quick.limit.load - load) <= error);
  RC_ASSERT(std::fabs(quick.limit.kinematic - load) <= error);
  RC_ASSERT(std::fabs(quick.limit.dissipation - exact.limit.dissipation) <=
            error + kQuickError * exact.limit.dissipation);
}

// Dry joints without cohesion dissipate nothing: what the mechanism lifts is the load, whoever computed it.
RC_GTEST_PROP(quick_limit, mechanism_flows_and_gives_the_load, ()) {
  ModelSpec spec = any_wall();
  for (auto& [name, joint] : spec.material) joint.residual_cohesion = 0;
  const Model model = compile(spec);
  const Answer quick = answer_of(model, {}, true);
  RC_PRE(quick.refusal.empty());
  RC_ASSERT(broken_flow(model, quick.limit) < kQuickError);
}

TEST(QuickLimit, published_walls_and_the_paper_s) {
  for (const char* name : {"wall1", "wall2", "wall4"}) {
    const Model model =
        compile(read_model(source_dir() + "/validation/ferris_tinloi_walls/model.toml",
                           {std::string("wall.blocks=data/") + name + ".json"}));
    EXPECT_NEAR(answer_of(model, {}, true).limit.load / limit_load(model, {}).load, 1, kQuickError);
  }
  const Model tuff = compile(scenes::tuff_wall(source_dir(), 0.05));
  const double quick = answer_of(tuff, {}, true).limit.load, exact = limit_load(tuff, {}).load;
  EXPECT_NEAR(quick / exact, 1, kQuickError);
  EXPECT_NE(quick, exact) << "the quick search gave up, and the exact one answered";
}

TEST(QuickLimit, walls_in_space) {
  ModelSpec spec = scenes::prisms(scenes::half_units(
      {.columns = 4, .courses = 4, .hole = 0}, scenes::dry_joint(20e9, 8e9, scenes::degrees(30))));
  spec.stage = {scenes::gravity_stage(), scenes::push_stage("r3c0", Direction::kPlusX, 0.01, 0.01)};
  const Model model = compile(spec);
  const LimitResult exact = limit_load(model, {}), quick = quick_limit_load(model, {});
  EXPECT_NEAR(quick.load / exact.load, 1, kQuickError);
  EXPECT_NEAR(quick.kinematic / exact.load, 1, kQuickError);
  EXPECT_NE(quick.load, exact.load) << "the quick search gave up, and the exact one answered";
  double power = 0;  // of the unit load
  for (const BlockId b : model.stages.back().driven) power += quick.vx[b];
  EXPECT_NEAR(power, static_cast<double>(model.stages.back().driven.size()), kQuickError);
}

// A block on ice leans on a low stop: what turns it about the stop's top is its weight alone.
TEST(QuickLimit, without_friction_in_space) {
  ModelSpec spec = scenes::in_space({scenes::box("floor", {-2, -0.2, -2}, {4, 0.2, 4}, true),
                                     scenes::box("stop", {0.15, 0, -0.1}, {0.2, 0.3, 0.2}, true),
                                     scenes::box("b", {-0.15, 0, -0.1}, {0.3, 1.2, 0.2})},
                                    scenes::dry_joint(1e9, 4e8, 0));
  spec.stage = {scenes::gravity_stage(), body_force()};
  const Model model = compile(spec);
  const LimitResult exact = limit_load(model, {}), quick = quick_limit_load(model, {});
  EXPECT_NEAR(exact.load, 0.15 / (0.6 - 0.3), 1e-6);
  EXPECT_NEAR(quick.load / exact.load, 1, kQuickError);
  EXPECT_NEAR(quick.kinematic / exact.load, 1, kQuickError);
  const auto block = static_cast<std::size_t>(model.n_block - 1);
  EXPECT_NEAR(quick.vx[block] / exact.vx[block], 1, kQuickError);
}

// A wall of light stones under a load of a thousand of them, slippery joints: small loads beside large forces.
TEST(QuickLimit, small_loads_beside_heavy_weights) {
  for (const double friction : {0.05, 0.5, 5.0}) {
    ModelSpec plane = scenes::small_wall(2e-3, 0.02, 200e3);
    for (auto& [name, joint] : plane.material) {
      joint.friction_angle = joint.residual_friction_angle = scenes::degrees(friction);
      joint.residual_cohesion = 0;
    }
    ModelSpec space =
        scenes::prisms(scenes::half_units({.columns = 6, .courses = 6, .hole = 0},
                                          scenes::dry_joint(20e9, 8e9, scenes::degrees(friction))));
    space.stage = {scenes::gravity_stage(),
                   scenes::push_stage("r5c0", Direction::kPlusX, 0.01, 0.01)};
    for (ModelSpec* spec : {&plane, &space}) {
      for (const bool pushes : {true, false}) {
        if (!pushes) spec->stage.back() = body_force();
        const Model model = compile(*spec);
        const Answer exact = answer_of(model, {}, false), quick = answer_of(model, {}, true);
        ASSERT_EQ(quick.refusal, exact.refusal);
        const double error = kQuickError * std::fabs(exact.limit.load);
        EXPECT_NEAR(quick.limit.load, exact.limit.load, error);
        EXPECT_NEAR(quick.limit.kinematic, exact.limit.load, error);
      }
    }
  }
}

// What a coarse search says of its own error is what decides whether the exact one follows.
TEST(QuickLimit, a_coarse_search_knows_its_error) {
  ModelSpec spec = scenes::small_wall(2e-3, 0.02, 20e3);
  spec.stage.back() = body_force();
  const Model model = compile(spec);
  const limit::LimitLoads loads = limit::limit_loads(model);
  limit::YieldModel yield = limit::yield_of(model, {});
  const limit::Units units = limit::units_of(model, loads, yield);
  const double exact = limit::solve_static(model, loads, yield, units).load;
  for (const double wanted : {1e-2, 1e-4, 1e-6}) {
    const limit::StaticSolution coarse = limit::solve_static(
        model, loads, yield, units, {}, {.wanted = wanted, .best = wanted, .enough = wanted});
    ASSERT_EQ(coarse.status, limit::ProgrammeStatus::kOptimal);
    EXPECT_LE(std::fabs(coarse.load - exact), coarse.error);
    EXPECT_LE(std::fabs(coarse.dual.load - exact), coarse.error);
  }
}

}  // namespace
}  // namespace wythe::quick_limit_test
