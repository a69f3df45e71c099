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
  StageSpec hold{.name = "hold", .action = HoldStage{.duration = 0.5}};
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

// Torsion constant of a rectangle a >= b by Saint-Venant's series.
double saint_venant(double a, double b) {
  double sum = 0;
  for (int n = 1; n < 60; n += 2) sum += std::tanh(0.5 * n * M_PI * a / b) / std::pow(n, 5);
  return a * b * b * b * (1.0 / 3 - 64 / std::pow(M_PI, 5) * b / a * sum);
}

// From above:  ##=============.     clamped at ##; its load hangs on the end of the other leg, 1.5 m beside the first, which
//                             |     bends and turns. The section at the corner carries moment and torque as any other.
//                             P
TEST(BuiltSpace, a_ring_beam_bends_and_turns_round_its_corner) {
  const double thick = 0.25, high = 0.3, e = 30e9, g = 12.5e9, step = 0.25, force = 2000;
  const double leg = 2.0,
               arm =
                   1.5;  // from the middles of the clamped and of the loaded segment to the corner
  ModelSpec spec;
  spec.wall.unit.density = kDensity;
  spec.material["joint"] = scenes::dry_joint(2e10, 8e9, std::atan(2.0));
  spec.material["concrete"].density = 2500;
  spec.material["concrete"].youngs_modulus = e;
  spec.material["concrete"].shear_modulus = g;
  PlanWallSpec beam;
  beam.name = "ring", beam.ring_beam = true, beam.material = "concrete";
  beam.line = {{0, 0}, {leg + step / 2, 0}, {leg + step / 2, arm + step / 2}};
  beam.base = 1, beam.height = high, beam.thickness = thick, beam.unit.length = step;
  lay_bodies({.plan_wall = {beam}, .slab = {}, .arch = {}, .dome = {}}, spec);
  ASSERT_EQ(spec.body.size(), 9U + 6U);
  spec.body.front().fixed = true;
  spec.solve.gravity = 0;
  spec.solve.settle_ratio = 1e-7;
  StageSpec load{.name = "load",
                 .action = LoadStage{.force = force,
                                     .at = {.x = leg + step / 2, .y = 1 + high / 2, .z = arm},
                                     .along = {0, -1, 0}}};
  spec.stage = {load};
  const Outcome r = run(spec);
  ASSERT_EQ(r.result.status, SolveStatus::kCompleted) << text_of(r.result.reason);
  double lowest = 0;
  for (BlockId b = 0; b < r.model.n_block; ++b)
    lowest = std::fmin(lowest, read_block(r.model, r.state, b).moved.y);
  // the chain turns in the middles of its steps, so that of L^3/3 it has L^3/3 - L step^2/12
  const auto bending = [&](double l) { return (l * l * l / 3 - l * step * step / 12); };
  const double area = thick * high, second = thick * high * high * high / 12;
  const double exact =
      force * ((bending(leg) + bending(arm)) / (e * second) + (leg + arm) * 1.2 / (g * area) +
               arm * arm * leg / (g * saint_venant(high, thick)));
  verify({"SP32", "ring beam round a corner, loaded at its end: deflection", "m", exact, 4e-3,
          "torsion constant by Roark's polynomial, 0.5 %"},
         -lowest);
}

}  // namespace
}  // namespace wythe::built_space_test
