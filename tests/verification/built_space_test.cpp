// Structures of the builder in space against closed forms: reactions, the
// least thrust of an arch, and thicknesses at which arches and domes collapse.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "geometry/builder/builder.h"
#include "record.h"
#include "scenes/run.h"
#include "scenes/scenes.h"
#include "wythe/parts/reading.h"
#include "wythe/parts/solve.h"

namespace wythe::built_space_test {
namespace {

using scenes::Outcome;
using scenes::run;
using verification::verify;

constexpr double kDensity = 2000, kG = 9.81;

std::vector<BodySpec> built(const BuilderSpec& spec) {
  ModelSpec model;
  model.wall.unit.density = kDensity;
  std::vector<Message> notes;
  FaultList faults;
  std::vector<BodySpec> bodies;
  for (geometry::BuiltBody& body : geometry::build_bodies({spec, model}, notes, faults))
    bodies.push_back(std::move(body.body));
  faults.throw_if_any();
  return bodies;
}

// Friction is high, so that stones turn about their edges only.
ModelSpec standing(const BuilderSpec& spec, double friction_tan = 2) {
  ModelSpec model = scenes::in_space(
      built(spec), scenes::dry_joint(2e10, 8e9, std::atan(friction_tan)), kDensity);
  model.stage = {scenes::gravity_stage()};
  return model;
}

// A mean radius of 1 m.
BuilderSpec semicircle(double depth, int voussoirs) {
  StandingArchSpec arch;
  arch.name = "a", arch.span = 2 - depth, arch.depth = depth, arch.width = 0.3;
  arch.voussoirs = voussoirs;
  return {.plan_wall = {}, .slab = {}, .arch = {arch}, .dome = {}};
}
BuilderSpec hemisphere(double depth, const char* bond) {
  DomeSpec dome;
  dome.name = "d", dome.span = 2 - depth, dome.depth = depth, dome.bond = bond;
  dome.courses = 10, dome.units = 20;
  return {.plan_wall = {}, .slab = {}, .arch = {}, .dome = {dome}};
}

TEST(BuiltSpace, an_arch_stands_or_falls_on_either_side_of_milankovitchs_thickness) {
  EXPECT_EQ(run(standing(semicircle(0.12, 30))).result.status, SolveStatus::kCompleted);
  EXPECT_NE(run(standing(semicircle(0.095, 30))).result.status, SolveStatus::kCompleted);
}

// Heyman's dome of lunes, t / R = 0.042: upright joints run through and carry no tension. Chords of 20 units make it
// thicker by 1 - cos(pi / 40) = 0.003 R at most. Joints broken from course to course hold rings by friction: that
// dome stands.
TEST(BuiltSpace, a_dome_of_lunes_stands_or_falls_on_either_side_of_heymans_thickness) {
  EXPECT_EQ(run(standing(hemisphere(0.06, "stack"))).result.status, SolveStatus::kCompleted);
  EXPECT_NE(run(standing(hemisphere(0.03, "stack"))).result.status, SolveStatus::kCompleted);
  EXPECT_EQ(run(standing(hemisphere(0.03, "running"))).result.status, SolveStatus::kCompleted);
}

// The crown turns about its extrados, each haunch about the intrados of the joint that asks for the largest thrust.
double least_thrust(double depth, int n, double width) {
  const double in = 1 - depth / 2, out = 1 + depth / 2, step = M_PI / n;
  const double weight = 0.5 * std::sin(step) * (out * out - in * in) * width * kDensity * kG;
  const double centre = 2.0 / 3 * std::cos(step / 2) * (out * out + out * in + in * in) /
                        (out + in);  // radius of a voussoir's centroid: trapezoids between rays
  double most = 0, load = 0, moment = 0;
  for (int k = 1; k <= n / 2; ++k) {
    load += weight;
    moment += weight * centre * std::sin((k - 0.5) * step);
    most = std::fmax(most,
                     (load * in * std::sin(k * step) - moment) / (out - in * std::cos(k * step)));
  }
  return most;
}

TEST(BuiltSpace, an_arch_on_spreading_supports_thrusts_the_least_and_weighs_its_weight) {
  const double depth = 0.2;
  ModelSpec spec = standing(semicircle(depth, 16));
  spec.stage.push_back(scenes::push_stage("a.right", Direction::kPlusX, 2e-3, 2e-3));
  StageSpec hold;
  hold.name = "hold", hold.kind = StageKind::kHold, hold.duration = 0.5;
  spec.stage.push_back(hold);
  const Outcome r = run(spec);
  ASSERT_EQ(r.result.status, SolveStatus::kCompleted);
  double lift = 0, thrust = 0;
  for (const JointReading& joint : read_wall(r.model, r.state).joints) {
    if (joint.shape.kind != JointKind::kFoundation) continue;
    const Vec3 force = joint.compression * joint.shape.normal - joint.shear_vector;
    lift += force.y;
    thrust += 0.5 * std::fabs(force.x);
  }
  verify({"SP30", "least thrust of a semicircular arch on spreading supports, t / R = 0.2", "N",
          least_thrust(depth, 16, 0.3), 0.02, "hinges at elastic edges; moved by 1 % of its depth"},
         thrust);
  verify({"SP31", "vertical reaction of the same arch", "N", r.model.weight, 1e-3,
          "held until it rests"},
         lift);
}

}  // namespace
}  // namespace wythe::built_space_test
