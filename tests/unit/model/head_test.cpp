// The head of a pier: a push along a line through the point of contraflexure,
// and the axial force from a head that is held against rising.
#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "io/results/curve_csv.h"
#include "scenes/rig.h"
#include "scenes/scenes.h"
#include "wythe/parts/error.h"
#include "wythe/parts/io.h"
#include "wythe/parts/limit.h"
#include "wythe/parts/solve.h"

namespace wythe::head_test {
namespace {

using scenes::Rig;

constexpr double kWidth = 0.8, kCourse = 0.1, kThickness = 0.2;  // [m]
constexpr int kCourses = 21;                                     // the last is the head

StageSpec pushed_head(double contraflexure, double velocity, double until) {
  StageSpec push =
      scenes::push_stage("b" + std::to_string(kCourses - 1), Direction::kPlusX, velocity, until);
  push.get<PushStage>().contraflexure = contraflexure;
  return push;
}

// An elastic column of 20 courses under a head, without weight.
ModelSpec column(double contraflexure) {
  ModelSpec spec =
      scenes::stack(kCourses, kWidth, kCourse, scenes::elastic_joint(20e9, 8e9), kThickness, 2000);
  spec.stage = {pushed_head(contraflexure, 1e-3, 1e-4)};
  return spec;
}

// The moment that what lies above a level brings to it, about its middle, by the joints there [N m].
double moment_at(const Model& model, const State& state, double y) {
  const WallReading wall = read_wall(model, state);
  double moment = 0;
  for (const JointReading& joint : wall.joints)
    if (std::fabs(joint.shape.centre.y - y) < 1e-9)
      moment += cross(joint.shape.centre - Vec3{0.5 * kWidth, y}, force_of(model, joint, wall)).z +
                joint.moment;
  return moment;
}

class Contraflexure : public testing::TestWithParam<double> {};

TEST_P(Contraflexure, is_where_the_moment_is_nil_and_the_base_has_the_shear_times_its_height) {
  const double share = GetParam();
  Rig rig(compile(column(share)));
  const Stage& push = rig.model.stages.front();
  const auto head = static_cast<std::size_t>(push.driven.front());
  const double height = share * rig.model.anatomy.height;
  EXPECT_NEAR(rig.model.centroid_y[head] + push.drive_arm, height, 1e-12);
  EXPECT_EQ(push.control, push.driven.front());
  rig.drive(0, 1e-3);
  rig.run(0.02);
  rig.controls.drive_velocity = 0;
  rig.settle(1e-10);
  const double shear = rig.step();
  ASSERT_GT(shear, 10.0);
  // the end of the arm has risen and leaned with the head
  const double now =
      height + rig.state.uy[head] + push.drive_arm * (std::cos(rig.state.theta[head]) - 1);
  EXPECT_NEAR(std::fabs(moment_at(rig.model, rig.state, 0)) / (shear * now), 1, 1e-6);
  // along the pier; the joint nearest to the point is at most half a course from it
  const double top = kCourse * (kCourses - 1);
  for (const double y : {0.25 * top, 0.5 * top, 0.75 * top, top}) {
    const double moment = std::fabs(moment_at(rig.model, rig.state, y));
    EXPECT_NEAR(moment / (shear * now), std::fabs(now - y) / now, 2e-6) << y;
  }
  if (share < 1) {
    const double at = std::round(height / kCourse) * kCourse;
    EXPECT_LE(std::fabs(moment_at(rig.model, rig.state, at)), 0.51 * kCourse * shear);
    EXPECT_LT(moment_at(rig.model, rig.state, 0) * moment_at(rig.model, rig.state, top), 0);
  }
}
INSTANTIATE_TEST_SUITE_P(Shares, Contraflexure, testing::Values(0.5, 0.75, 0.95, 1.5));

// The drive works on the end of the arm, by force and moment: the ledger closes.
TEST(Head, work_of_its_push_is_in_the_ledger) {
  ModelSpec spec = column(0.5);
  spec.stage.back().get<PushStage>().velocity = 5e-3;
  spec.solve.damping = 0.2;
  const Model model = compile(spec);
  State state = initial_state(model);
  const Result result = solve(model, state);
  ASSERT_EQ(result.status, SolveStatus::kCompleted) << result.reason;
  EXPECT_LT(result.energy.gap_ratio, 2e-3);
  EXPECT_NEAR(result.curve.back().displacement, 1e-4, 2e-6);  // of the head, not of the arm's end
  EXPECT_GT(result.energy.drive, 0);
}

// A rigid pier that rocks about its toe, without weight, N = 200 kN in the middle of its head: V H0 = N b / 2.
// With the point half way up this is the pier that rocks at both ends, V = N b / H.
ModelSpec rocking(double contraflexure, double until = 2e-3) {
  std::vector<BlockSpec> blocks;
  BlockSpec support = scenes::rectangle("s", 0, -0.1, 1.7, 0.1);
  support.fixed = true;
  blocks.push_back(support);
  blocks.push_back(scenes::rectangle("body", 0, 0, 1.7, 2.5));
  blocks.push_back(scenes::rectangle("head", 0, 2.5, 1.7, 0.1));
  ModelSpec spec = scenes::assembly(blocks, scenes::elastic_joint(400e9, 160e9), 0.31, 2000);
  spec.material["foundation"] = scenes::dry_joint(20e9, 8e9, scenes::degrees(60));
  StageSpec load{.name = "load", .action = LoadStage{.pier_load = 200e3}};
  StageSpec push = scenes::push_stage("head", Direction::kPlusX, 1e-3, until);
  push.damping = 0;  // a rocking body's velocity keeps its sign, so that local damping would drag
  push.ramp = 0.2;
  push.get<PushStage>().contraflexure = contraflexure;
  spec.output.rows = 50;
  spec.stage = {load, push};
  return spec;
}

TEST(Head, with_its_point_of_contraflexure_gives_the_rocking_strength_of_statics) {
  for (const double share : {0.5, 0.75, 1.0}) {
    const Model model = compile(rocking(share));
    const double statics = 200e3 * 1.7 / 2 / (share * model.anatomy.height);
    State state = initial_state(model);
    const Result result = solve(model, state);
    ASSERT_EQ(result.status, SolveStatus::kCompleted) << result.reason;
    // the elastic base leans 1e-3 of its width before it rocks
    EXPECT_NEAR(result.responses.peak_reaction / statics, 1, 1e-2) << share;
    const LimitResult limit = limit_load(model, {});
    EXPECT_NEAR(limit.kinematic / statics, 1, 1e-6) << share;
    EXPECT_NEAR(limit.load / statics, 1, 1e-6) << share;
  }
}

std::string refused(const std::string& keys) {
  const std::string text = R"([wall]
length = "1 m"
height = "1.2 m"
thickness = "0.2 m"
unit = { length = "200 mm", height = "100 mm", split = "none", density = "1800 kg/m^3" }
beam = { height = "200 mm", density = "2500 kg/m^3" }
[material.joint]
normal_stiffness = "20 GPa/m"
shear_stiffness = "8 GPa/m"
tensile_strength = "0 MPa"
cohesion = "0 MPa"
residual_cohesion = "0 MPa"
friction_angle = "30 deg"
residual_friction_angle = "30 deg"
compressive_strength = "unlimited"
[[stage]]
name = "gravity"
[[stage]]
name = "push"
velocity = "10 mm/s"
)";
  try {
    (void)compile(parse_model(text + keys, "head.toml"));
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

TEST(Head, refuses_a_point_of_contraflexure_that_cannot_be) {
  const auto has = [](const std::string& keys, const std::string& part) {
    const std::string said = refused(keys);
    EXPECT_NE(said.find("contraflexure"), std::string::npos) << said;
    EXPECT_NE(said.find(part), std::string::npos) << said;
  };
  const std::string beam = "until = \"5 mm\"\nat = { beam = true }\n";
  EXPECT_EQ(refused(beam + "contraflexure = 0.75\n"), "");
  has(beam + "contraflexure = -0.75\n", "0.5");
  has(beam + "contraflexure = 0.4\n", "0.5");
  has(beam + "contraflexure = 0.75\nrotation = \"blocked\"\n", "a head that turns");
  has(beam + "contraflexure = 0.75\ndirection = \"+y\"\n", "not horizontal");
  has(beam + "contraflexure = 0.75\nas = \"each\"\n", "one head");
  has("until = \"5 mm\"\npattern = \"mass\"\ncontraflexure = 0.75\n", "a pattern pushes");
  has("until = \"5 mm\"\nat = { x = \"0 m\", y = \"1.05 m\", courses = 3 }\ncontraflexure = 0.75\n",
      "3 blocks are pushed");
  has("targets = [\"1 mm\", \"-1 mm\"]\nat = { beam = true }\ncontraflexure = 0.75\n",
      "one direction");
}

// --- a head that is held against rising -------------------------------------------------------------

TEST(Head, held_against_rising_tells_its_axial_force) {
  ModelSpec spec = rocking(0.75);
  spec.stage.back().get<PushStage>().fixity.across = Freedom::kBlocked;
  spec.stage.back().damping = 0.3;
  spec.stage.insert(spec.stage.begin(), scenes::gravity_stage());
  const Model model = compile(spec);
  State state = initial_state(model);
  const Result result = solve(model, state);
  ASSERT_EQ(result.status, SolveStatus::kCompleted) << result.reason;
  const auto head = static_cast<std::size_t>(model.stages.back().driven.front());
  const double own = 9.81 * model.gravity_mass[head];
  // at first what lies on the head; then more, as the pier would rise on its toe
  EXPECT_NEAR(result.curve.front().head_axial, 200e3 + own, 50);
  for (std::size_t k = 1; k < result.curve.size(); ++k)
    EXPECT_GT(result.curve[k].head_axial, result.curve[k - 1].head_axial - 50) << k;
  EXPECT_GT(result.curve.back().head_axial, 1.5 * result.curve.front().head_axial);
  // the ground's reaction less the weight of the body between
  const WallReading wall = read_wall(model, state);
  double ground = 0;
  for (JointId j = model.n_pair; j < model.n_joint; ++j)
    ground += force_of(model, wall.joints[j], wall).y;
  const double body = model.weight - own;
  EXPECT_NEAR(result.curve.back().head_axial / (ground - body), 1, 1e-3);
}

TEST(Head, that_is_free_to_rise_has_no_such_column) {
  const auto columns = [](Freedom across) {
    ModelSpec spec = rocking(0.75);
    spec.stage.back().get<PushStage>().fixity.across = across;
    return io::curve_csv({CurveRow{}}, columns_of(compile(spec)));
  };
  EXPECT_NE(columns(Freedom::kBlocked).find("head_axial_kN"), std::string::npos);
  EXPECT_EQ(columns(Freedom::kFree).find("head_axial_kN"), std::string::npos);
}

}  // namespace
}  // namespace wythe::head_test
