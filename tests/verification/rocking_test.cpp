// Rocking and toe crushing: a pier, a block pushed over, a block rocking freely (CF16 - CF18).
#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "scenes/rig.h"
#include "scenes/scenes.h"
#include "verification/record.h"
#include "wythe/parts/solve.h"

namespace wythe::verification::rocking_test {
namespace {

using scenes::degrees;
using scenes::Rig;

// --- CF16: a rigid pier 1.70 m long, pushed at 2.62 m, 200 kN on top, no weight --------------------

constexpr double kLoad = 200e3, kLength = 1.70, kHeight = 2.62, kThickness = 0.31;

// Body and a light head glued on it, whose centre is at the height of the push.
ModelSpec pier(const JointMaterial& base, double until, int supports) {
  const double head_height = 0.1;
  std::vector<BlockSpec> blocks;
  for (int k = 0; k < supports; ++k) {
    BlockSpec support = scenes::rectangle("s" + std::to_string(k), k * kLength / supports, -0.1,
                                          kLength / supports, 0.1);
    support.fixed = true;
    blocks.push_back(support);
  }
  const double body = kHeight - head_height / 2;
  blocks.push_back(scenes::rectangle("body", 0, 0, kLength, body));
  blocks.push_back(scenes::rectangle("head", 0, body, kLength, head_height));
  ModelSpec spec = scenes::assembly(blocks, scenes::elastic_joint(400e9, 160e9), kThickness, 2000);
  spec.material["foundation"] = base;
  StageSpec load{.name = "load", .action = LoadStage{.pier_load = kLoad}};
  StageSpec push = scenes::push_stage("head", Direction::kPlusX, 1e-3, until);
  push.damping = 0;  // local damping would drag: a rocking body's velocity keeps its sign
  push.ramp = 0.2;
  spec.output.rows = 50;
  spec.stage = {load, push};
  return spec;
}

TEST(ClosedForm, CF16a_rocking_strength_of_a_pier) {
  const JointMaterial base = scenes::dry_joint(20e9, 8e9, degrees(60));
  const Model model = compile(pier(base, 1e-3, 1));
  State state = initial_state(model);
  const Result result = solve(model, state);
  ASSERT_EQ(result.status, SolveStatus::kCompleted) << result.reason;
  verify({"CF16a", "rigid pier: rocking strength, fc unlimited", "kN", 64.8855, 5e-3,
          "elastic lean of the load, 1e-4; vibration of the undamped push"},
         result.responses.peak_reaction / 1e3);
}

// The foundation crushes at 0.85 fc without softening, ten supports with 16 points each.
struct Crushed {
  double peak, offset;  // [kN], distance of the base resultant from the toe [m]
};
Crushed crush_toe() {
  JointMaterial base = scenes::dry_joint(400e9, 160e9, degrees(60));
  base.compressive_strength = 0.85 * 3.96e6;
  base.compressive_energy = 1e7;
  ModelSpec spec = pier(base, 2e-3, 10);
  spec.solve.points_per_face = 16;
  const Model model = compile(spec);
  State state = initial_state(model);
  const Result result = solve(model, state);
  EXPECT_EQ(result.status, SolveStatus::kCompleted) << result.reason;
  const WallReading wall = read_wall(model, state);
  double force = 0, moment = 0;
  for (JointId j = model.n_pair; j < model.n_joint; ++j) {
    const JointReading& joint = wall.joints[j];
    for (const PointReading& point : wall.points_of(joint)) {
      const double f = -point.normal_stress * joint.shape.area * point.share;
      force += f;
      moment += f * (kLength - point.where.x);
    }
  }
  return {result.responses.peak_reaction / 1e3, moment / force};
}

TEST(ClosedForm, CF16b_rocking_strength_with_a_stress_block) {
  const Crushed crushed = crush_toe();
  verify(
      {"CF16b", "rigid pier: rocking strength with the stress block 0.85 fc", "kN", 57.56985, 1e-2,
       "elastic edge of the stress block, P-delta of the lean; vibration of the undamped push"},
      crushed.peak);
  verify({"CF16c", "rigid pier: distance of the hinge from the toe", "m", 0.09583501, 2e-2,
          "elastic edge of the stress block; its 0.19 m hold 17 of the 160 points"},
         crushed.offset);
}

// --- CF17: a block 0.4 x 1.6 m of 10 kN, pushed over at its upper rear corner -----------------------

// The upper left corner is cut by 2 cm; a square of light stuff glued on the cut has its centre just
// where the corner was, so that the push acts there.
ModelSpec toppling_block() {
  BlockSpec body, handle;
  body.id = "body";
  body.polygon = {{0, 0}, {0.4, 0}, {0.4, 1.6}, {0.02, 1.6}, {0, 1.58}};
  handle.id = "handle";
  handle.polygon = {{0, 1.58}, {0.02, 1.6}, {0, 1.62}, {-0.02, 1.6}};
  handle.material = "handle";
  const double area = 0.4 * 1.6 - 0.5 * 0.02 * 0.02;
  ModelSpec spec =
      scenes::assembly({body, handle}, scenes::elastic_joint(50e9, 20e9), 1.0, 10e3 / 9.81 / area);
  spec.material["foundation"] = scenes::dry_joint(20e9, 8e9, degrees(60));
  JointMaterial light;
  light.density = 100;
  spec.material["handle"] = light;
  StageSpec push = scenes::push_stage("handle", Direction::kPlusX, 0.01, 0.42);
  push.get<PushStage>().as = Manner::kEach;
  push.ramp = 0.5;
  push.damping = 0;  // as above
  spec.stage = {scenes::gravity_stage(), push};
  spec.solve.collapse_displacement = 2;
  spec.output.rows = 840;
  return spec;
}

const std::vector<CurveRow>& toppling_curve() {
  static const std::vector<CurveRow> curve = [] {
    const Model model = compile(toppling_block());
    State state = initial_state(model);
    Result result = solve(model, state);
    EXPECT_EQ(result.status, SolveStatus::kCompleted) << result.reason;
    return result.curve;
  }();
  return curve;
}

// Mean reaction over 8 mm on either side: the undamped block sways a little on its springs, and the
// force is so nearly linear in the displacement (0.1 N over 10 mm) that the mean is its value.
double force_at(double displacement) {
  const std::vector<CurveRow>& curve = toppling_curve();
  double sum = 0;
  int rows = 0;
  for (std::size_t k = 1; k < curve.size(); ++k) {
    // a row holds the mean over its window, which ends at its displacement
    const double middle = 0.5 * (curve[k - 1].displacement + curve[k].displacement);
    if (std::fabs(middle - displacement) > 8e-3) continue;
    sum += curve[k].reaction;
    ++rows;
  }
  return sum / rows;
}

constexpr const char* kTopple =
    "inertia of a push at 10 mm/s; elastic sink of the toe; weight of the handle, 1 N";

TEST(ClosedForm, CF17_block_pushed_at_its_corner) {
  verify({"CF17", "rigid block pushed at its upper rear corner: force at 0.00 m", "N", 1250, 3e-3,
          kTopple},
         2 * force_at(0.01) - force_at(0.02));
  const double wanted[][2] = {{0.05, 1085.83}, {0.10, 924.94}, {0.20, 610.847}, {0.30, 303.728}};
  for (const auto& [d, force] : wanted)
    verify(
        {"CF17", fmt::format("rigid block pushed at its upper rear corner: force at {:.2f} m", d),
         "N", force, 3e-3, kTopple},
        force_at(d));
}

TEST(ClosedForm, CF17_rotation_of_zero_force) {
  const double f0 = force_at(0.38), f1 = force_at(0.41);
  const double d = 0.38 + 0.03 * f0 / (f0 - f1);
  double theta = 0.2;  // d = H sin theta + B (1 - cos theta), by Newton
  for (int i = 0; i < 20; ++i)
    theta -= (1.6 * std::sin(theta) + 0.4 * (1 - std::cos(theta)) - d) /
             (1.6 * std::cos(theta) + 0.4 * std::sin(theta));
  verify({"CF17", "rigid block pushed at its upper rear corner: rotation of zero force", "rad",
          0.2449787, 1e-3, kTopple},
         theta);
}

// --- CF18: a block 0.5 x 2.0 m rocking freely about its toe -----------------------------------------

constexpr double kHalfBase = 0.25, kHalfHeight = 1.0;
const double kAlpha = std::atan(kHalfBase / kHalfHeight);

// Four times the time from rest at theta0 to upright [s].
double rocking_period(double theta0) {
  Rig rig(compile(scenes::block_on_ground(
      2 * kHalfBase, 2 * kHalfHeight, scenes::dry_joint(1000e9, 400e9, degrees(75)), 0.1, 2000)));
  rig.controls.damping = 0;
  rig.state.gravity_y = -9.81;
  // turned to the left about the left toe, which carries the weight
  const double c = std::cos(theta0), s = std::sin(theta0);
  const double rx = -kHalfBase, ry = -kHalfHeight;  // toe seen from the centroid
  const double sink = rig.model.weight / (1000e9 * 0.5 * rig.model.area[0]);
  rig.state.ux[0] = rx - (c * rx - s * ry);
  rig.state.uy[0] = ry - (s * rx + c * ry) - sink;
  rig.state.theta[0] = theta0;
  while (true) {
    const double before = rig.state.theta[0], t = rig.state.time;
    rig.step();
    const double after = rig.state.theta[0];
    if (after <= 0) return 4 * (t + rig.controls.dt * before / (before - after));
    if (t > 5) return 0;
  }
}

TEST(ClosedForm, CF18_free_rocking_period) {
  struct Case {
    double share, linear, exact;
  };
  // The first quarter is free of impact; no rule of restitution enters. The linearised formula
  // differs from large rotation by up to 0.42 %, so its tolerance is that and the springs' share.
  const Case cases[] = {{0.1, 0.6994056, 0.7023577},
                        {0.3, 1.340866, 1.344677},
                        {0.5, 1.971737, 1.975213},
                        {0.8, 3.432207, 3.434558}};
  for (const Case& k : cases) {
    const double period = rocking_period(k.share * kAlpha);
    verify({"CF18", fmt::format("free rocking, theta0/alpha = {:g}: linearised period", k.share),
            "s", k.linear, 6e-3, "linearisation 0.42 % at most; springs of the toe"},
           period);
    verify({"CF18",
            fmt::format("free rocking, theta0/alpha = {:g}: four exact quarter periods", k.share),
            "s", k.exact, 2e-3, "springs of the toe: pressure and shear build up from rest"},
           period);
  }
}

}  // namespace
}  // namespace wythe::verification::rocking_test
