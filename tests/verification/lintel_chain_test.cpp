// The lintel as a chain of rigid segments against beam theory: EI, EA and GA with any number of
// points a face, and convergence with the number of segments.
//
//      P                         pins hold the centres of the end segments, L apart;
//   [=][=][=][=][=]              the face is taller than the structural depth, as in a wall of courses
//    ^           ^
#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <string>
#include <vector>

#include "model/parts.h"
#include "model/plane/step_bound.h"
#include "scenes/rig.h"
#include "scenes/scenes.h"
#include "verification/record.h"
#include "wythe/parts/solve.h"

namespace wythe::verification::lintel_chain_test {
namespace {

using scenes::Rig;

constexpr double kSpan = 2.0, kDepth = 0.2, kFace = 0.25, kThickness = 0.3;
constexpr double kE = 10e9, kG = 0.6e9;
constexpr double kArea = kThickness * kDepth;
constexpr double kInertia = kThickness * kDepth * kDepth * kDepth / 12;
constexpr double kShearArea = 5.0 / 6 * kArea;

JointMaterial timber() {
  JointMaterial m;
  m.density = 500;
  m.youngs_modulus = kE;
  m.shear_modulus = kG;
  return m;
}

// Takes the ground away: joints between blocks only.
void lift_off(Model& m) {
  m.n_joint = m.n_pair;
  const auto n = static_cast<std::size_t>(m.n_pair);
  for (auto* array : {&m.arm_a_x, &m.arm_a_y, &m.arm_b_x, &m.arm_b_y, &m.half_x, &m.half_y,
                      &m.tangent_x, &m.tangent_y, &m.area})
    array->resize(n);
  m.joint_a.resize(n);
  m.joint_b.resize(n);
  m.joint_material.resize(n);
  m.anatomy.joint_kind.resize(n);
  std::vector<std::int32_t> begin{0}, entry;
  for (std::size_t i = 0; i + 1 < m.block_begin.size(); ++i) {
    for (auto e = m.block_begin[i]; e < m.block_begin[i + 1]; ++e) {
      const std::int32_t value = m.block_entry[e];
      if (value < 2 * m.n_joint) entry.push_back(value);
    }
    begin.push_back(static_cast<std::int32_t>(entry.size()));
  }
  m.block_begin = begin;
  m.block_entry = entry;
}

// n segments in a row, their end centres kSpan apart, joined by the derived chain material.
Model beam(int n, int points) {
  const double spacing = kSpan / (n - 1);
  std::vector<BlockSpec> blocks;
  for (int k = 0; k < n; ++k)
    blocks.push_back(
        scenes::rectangle("s" + std::to_string(k), (k - 0.5) * spacing, 0, spacing, kFace));
  ModelSpec spec = scenes::assembly(blocks, scenes::elastic_joint(1e9, 1e9), kThickness, 500);
  spec.solve.points_per_face = points;
  Model m = compile(spec);
  lift_off(m);
  const double scale = chain_half_scale(m, kDepth, kFace);
  m.materials = {chain_material(timber(), spacing, kDepth, kFace)};
  for (std::size_t j = 0; j < m.half_x.size(); ++j) {
    m.joint_material[j] = 0;
    m.half_x[j] *= scale;
    m.half_y[j] *= scale;
  }
  bound_step(m);
  return m;
}

// A stage that holds `blocks` in the direction (x, y) and lets go what is free.
Stage holding(std::vector<BlockId> blocks, double x, double y, Freedom rotation, Freedom across) {
  Stage hold;
  hold.spec.action = PushStage{.as = Manner::kEach, .fixity = {rotation, across}};
  hold.driven = std::move(blocks);
  hold.driven_share.assign(hold.driven.size(), 1.0);
  hold.drive_x = x;
  hold.drive_y = y;
  return hold;
}

// Displacement of segment `loaded` under the force, with the held segments at rest.
struct Bent {
  double x, y;
};
Bent bend(Model model, const Stage& hold, BlockId loaded, double fx, double fy) {
  model.stages.push_back(hold);
  const std::size_t load = scenes::add_load(model, {loaded, 0, 0, fx, fy});
  Rig rig(std::move(model));
  rig.drive(0, 0.0);
  for (int k = 1; k <= 5000; ++k) {
    rig.state.load_scale[load] = k / 5000.0;
    rig.step();
  }
  rig.settle(1e-9, 60);
  const auto i = static_cast<std::size_t>(loaded);
  return {rig.state.ux[i], rig.state.uy[i]};
}

constexpr double kForce = 100;  // [N], small: rotations of 1e-5

// Middle deflection of the simply supported beam under a force in the middle.
double simply_supported(int n, int points) {
  const Stage pins = holding({0, n - 1}, 0, 1, Freedom::kFree, Freedom::kFree);
  return -bend(beam(n, points), pins, (n - 1) / 2, 0, -kForce).y;
}

double timoshenko() {
  return kForce * kSpan * kSpan * kSpan / (48 * kE * kInertia) +
         kForce * kSpan / (4 * kG * kShearArea);
}

TEST(LintelChain, simply_supported_deflection_converges_with_the_square_of_the_spacing) {
  const double exact = timoshenko();
  const double e5 = 1 - simply_supported(5, 2) / exact;
  const double e9 = 1 - simply_supported(9, 2) / exact;
  const double e17 = 1 - simply_supported(17, 2) / exact;
  EXPECT_NEAR(std::log2(e5 / e9), 2.0, 0.05);
  EXPECT_NEAR(std::log2(e9 / e17), 2.0, 0.05);
  verify({"lintel", "simply supported chain of 17 segments: deflection", "m", exact, 5e-3,
          "midpoint rule of the curvature, 1/(n-1)^2 = 4e-3"},
         exact * (1 - e17));
}

TEST(LintelChain, deflection_does_not_depend_on_the_points_a_face) {
  const double two = simply_supported(9, 2);
  for (const int points : {3, 5}) EXPECT_NEAR(simply_supported(9, points) / two, 1.0, 1e-6);
}

TEST(LintelChain, cantilever_deflection) {
  const Stage clamp = holding({0}, 0, 1, Freedom::kBlocked, Freedom::kBlocked);
  const double computed = -bend(beam(17, 2), clamp, 16, 0, -kForce).y;
  verify({"lintel", "cantilever chain of 17 segments: deflection", "m",
          kForce * std::pow(kSpan, 3) / (3 * kE * kInertia) + kForce * kSpan / (kG * kShearArea),
          2e-3, "midpoint rule of the curvature, 1/(4 (n-1)^2) = 1e-3"},
         computed);
}

TEST(LintelChain, axial_stiffness) {
  const Stage clamp = holding({0}, 1, 0, Freedom::kBlocked, Freedom::kBlocked);
  verify({"lintel", "chain of 9 segments pulled: elongation", "m", kForce * kSpan / (kE * kArea),
          1e-6, "springs in series are exact; settled to an unbalance of 1e-9"},
         bend(beam(9, 2), clamp, 8, kForce, 0).x);
}

LintelSpec timber_lintel(double depth) {
  LintelSpec lintel;
  lintel.kind = "timber";
  lintel.depth = depth;
  lintel.bearing = 0.155;
  lintel.material = "timber";
  return lintel;
}

// Every chain joint with its centre between x0 and x1 has the stiffnesses of a beam `depth` deep.
void expect_beam(const Model& m, double depth, double x0, double x1) {
  const double area = 0.31 * depth, second = 0.31 * std::pow(depth, 3) / 12;
  int chains = 0;
  for (std::size_t j = 0; j < m.joint_a.size(); ++j) {
    const auto middle = static_cast<std::size_t>(m.joint_a[j]);
    if (m.anatomy.joint_kind[j] != JointKind::kLintelChain) continue;
    if (m.centroid_x[middle] < x0 || m.centroid_x[middle] > x1) continue;
    ++chains;
    const auto a = static_cast<std::size_t>(m.joint_a[j]),
               b = static_cast<std::size_t>(m.joint_b[j]);
    const double spacing = m.centroid_x[b] - m.centroid_x[a];
    const JointMaterial& material = m.materials[m.joint_material[j]];
    double bending = 0;
    for (std::size_t k = 0; k < m.point_xi.size(); ++k)
      bending += material.normal_stiffness * m.area[j] * m.point_weight[k] *
                 std::pow(m.point_xi[k] * std::hypot(m.half_x[j], m.half_y[j]), 2);
    EXPECT_NEAR(bending * spacing / (kE * second), 1.0, 1e-12);
    EXPECT_NEAR(material.normal_stiffness * m.area[j] * spacing / (kE * area), 1.0, 1e-12);
    EXPECT_NEAR(material.shear_stiffness * m.area[j] * spacing / (5.0 / 6 * kG * area), 1.0, 1e-12);
  }
  EXPECT_GE(chains, 1);
}

TEST(LintelChain, compiled_lintel_has_the_beam_s_stiffnesses) {
  ModelSpec spec = scenes::small_wall();
  spec.material["timber"] = timber();
  spec.wall.opening[0].lintel = timber_lintel(0.09);
  expect_beam(compile(spec), 0.09, 0, 1.24);
}

TEST(LintelChain, two_lintels_of_one_timber_have_each_its_own_depth) {
  ModelSpec spec = scenes::plain_wall(16, 8, 1e-3, 0.02);  // 2.48 m long
  spec.material["timber"] = timber();
  spec.wall.opening = {
      {.name = "door", .x = 0.31, .y = 0, .width = 0.31, .height = 0.44, .lintel = {}},
      {.name = "window", .x = 1.55, .y = 0.22, .width = 0.31, .height = 0.22, .lintel = {}}};
  spec.wall.opening[0].lintel = timber_lintel(0.09);
  spec.wall.opening[1].lintel = timber_lintel(0.22);
  const Model m = compile(spec);
  expect_beam(m, 0.09, 0, 1.24);
  expect_beam(m, 0.22, 1.24, 2.48);
}

// --- ring beams, from the words of a model to what its wall does ------------------------------------------

RingBeamSpec concrete_ring(double y, double height) {
  RingBeamSpec ring;
  ring.y = y;
  ring.height = height;
  ring.material = "concrete";
  ring.joint = "bearing";
  return ring;
}

//      ==============      pushed at its left end by u, held at its right end by a spring K: between the
//   u->[=][=][=][=][=]-K   middles of its end segments the ring is a bar of E A / L; its bed joint is too
//      | | masonry | |     soft to hold it
TEST(RingBeam, pulls_and_pushes_as_a_bar) {
  constexpr double kPush = 1e-3, kSpring = 30e6, kHeight = 0.2, kWidth = 0.25;
  ModelSpec spec = scenes::plain_wall(8, 8, kPush, 0.02);
  spec.ring_beam = {concrete_ring(0.66, kHeight)};
  spec.ring_beam[0].thickness = kWidth;
  spec.material["concrete"] = timber();
  spec.material["concrete"].youngs_modulus = 1e9;
  spec.material["bearing"] = scenes::dry_joint(20e9, 1e3, 0);
  spec.stage = {scenes::gravity_stage(),
                scenes::push_stage("ring0_0", Direction::kPlusX, 5e-3, kPush)};
  SpringSpec hold;
  hold.at.block = "ring0_7";
  hold.stiffness = kSpring;
  spec.spring = {hold};
  const Model model = compile(spec);
  State state = initial_state(model);
  const Result result = solve(model, state);
  const double length = 7 * 0.155, bar = 1e9 * kHeight * kWidth / length;
  verify({"ring beam", "pushed at one end against a spring: reaction", "N",
          kPush / (1 / bar + 1 / kSpring), 2e-3,
          "springs in series are exact; the push at 5 mm/s swings by less than this"},
         result.curve.back().reaction);
}

//      [=][=][=][=][=][=]     its own weight over an opening of the wall's whole height: each end segment
//      | |            | |     lies on a bed joint that is a spring against rotation, k = kn t b^3 / 12, and
//      | |            | |     slides freely: held below its axis, it would be an arch
TEST(RingBeam, bends_over_an_opening_by_its_own_weight) {
  constexpr double kColumn = 0.155, kT = 0.31, kHeight = 0.22, kBed = 2e9;
  ModelSpec spec = scenes::plain_wall(19, 8, 1e-3, 0.02);
  spec.wall.opening = {
      {.name = "gate", .x = kColumn, .y = 0, .width = 17 * kColumn, .height = 0.66, .lintel = {}}};
  spec.ring_beam = {concrete_ring(0.66, kHeight)};
  spec.material["concrete"] = timber();
  for (auto& [name, material] : spec.material)
    if (name != "concrete") material = scenes::elastic_joint(1e12, 1e12);
  spec.material["bearing"] = scenes::elastic_joint(kBed, 1e6);
  spec.solve.point_rule = PointRule::kLobatto;  // corners are three times stiffer in rotation
  spec.solve.points_per_face = 3;
  spec.solve.settle_ratio = 1e-9;
  spec.stage = {scenes::gravity_stage()};
  const Model model = compile(spec);
  State state = initial_state(model);
  (void)solve(model, state);
  std::map<std::string, double> down;
  for (std::size_t b = 0; b < model.anatomy.block_id.size(); ++b)
    down[model.anatomy.block_id[b]] = -state.uy[b];
  const double load = 500 * 9.81 * kHeight * kT, span = 18 * kColumn;
  const double bending = kE * kT * std::pow(kHeight, 3) / 12, shear = kG * 5.0 / 6 * kHeight * kT;
  const double turn = kBed * kT * std::pow(kColumn, 3) / 12;
  const double end = load * std::pow(span, 3) / 24 / bending / (1 / turn + span / 2 / bending);
  const double exact = 5 * load * std::pow(span, 4) / 384 / bending +
                       load * span * span / 8 / shear - end * span * span / 8 / bending;
  verify({"ring beam", "chain of 19 segments over an opening: deflection", "m", exact, 1e-2,
          "midpoint rule of the curvature, 1/(n-1)^2 = 3e-3, and the piers' own turn"},
         down["ring0_9"] - (down["ring0_0"] + down["ring0_18"]) / 2);
}

TEST(RingBeam, compiled_has_the_stiffnesses_of_its_stated_section) {
  ModelSpec spec = scenes::small_wall();
  spec.material["concrete"] = timber();
  spec.material["bearing"] = scenes::paper_joint();
  spec.ring_beam = {concrete_ring(0.77, 0.09)};
  expect_beam(compile(spec), 0.09, 0, 1.24);
}

}  // namespace
}  // namespace wythe::verification::lintel_chain_test
