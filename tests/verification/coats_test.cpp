// The mortar of layers against closed forms (docs/theory/layers.md, "The mortar").
//
//     | b1 |  pulled or pushed      a dry joint between both blocks, mortar on both faces over it
//    :+====+:
//     | b0 |  held on the ground by a joint that does not fail
#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "scenes/scenes.h"
#include "verification/record.h"
#include "wythe/parts/error.h"
#include "wythe/parts/io.h"
#include "wythe/parts/limit.h"
#include "wythe/parts/mechanism.h"
#include "wythe/parts/reading.h"
#include "wythe/parts/solve.h"

namespace wythe::verification::coats_test {
namespace {

constexpr double kLong = 1, kHigh = 0.5, kThick = 0.3;  // of a block [m]
constexpr double kCoat = 0.03, kE = 12e9;               // of one face [m], [Pa]
constexpr double kTension = 2e6, kCohesion = 3e6;       // of the mortar [Pa]
constexpr double kArea = 2 * kCoat * kLong;

ModelSpec plastered() {
  ModelSpec spec = scenes::stack(2, kLong, kHigh, scenes::elastic_joint(2e11, 1e11), kThick, 2000);
  spec.solve.gravity = 0;
  spec.block[1].material = "upper";
  spec.material["weak"] = scenes::dry_joint(2e10, 1e10, 1e-6);
  spec.contact = {{{"masonry", "upper"}, "weak"}};
  JointMaterial plaster = scenes::paper_joint();
  plaster.tensile_strength = kTension, plaster.cohesion = kCohesion;
  plaster.residual_cohesion = 0;
  plaster.mode_1_energy = 100, plaster.mode_2_energy = 1000;
  spec.material["plaster"] = plaster;
  LayerSpec layer;
  layer.name = "both";
  layer.sides = 2;
  layer.mortar = {.thickness = kCoat, .youngs_modulus = kE, .joint = "plaster"};
  spec.layer = {layer};
  return spec;
}

struct Ran {
  Model model;
  State state;
  Result result;
};
Ran moved(ModelSpec spec, Direction direction, double until) {
  StageSpec push = scenes::push_stage("b1", direction, 2e-3, until);
  push.damping = 0.3;
  spec.stage = {scenes::gravity_stage(), push};
  Ran r{compile(spec), {}, {}};
  r.state = initial_state(r.model);
  r.result = solve(r.model, r.state);
  return r;
}
double largest(const Ran& r) {
  double most = 0;
  for (const CurveRow& row : r.result.curve) most = std::max(most, std::fabs(row.reaction));
  return most;
}

TEST(Coats, mortar_over_a_dry_joint_bears_its_own_tension) {
  const Ran r = moved(plastered(), Direction::kPlusY, 0.5e-3);
  ASSERT_EQ(r.result.status, SolveStatus::kCompleted);
  verify({"LM01", "plaster over a dry joint, pulled apart: largest force", "N", kTension * kArea,
          0.01, "rows of the curve and the damped motion"},
         largest(r));
  EXPECT_LT(r.result.energy.gap_ratio, 1e-3);
}

// Before it cracks, the strain of the mortar over the length from centroid to centroid lies in the joint.
TEST(Coats, mortar_is_as_stiff_as_its_length_between_the_units) {
  const Ran r = moved(plastered(), Direction::kPlusY, 0.02e-3);
  const double own = kE / kHigh * kArea, ground = 2e11 * kThick * kLong;
  const CurveRow& last = r.result.curve.back();
  verify({"LM02", "plaster over a dry joint, pulled: stiffness", "N/m",
          own * ground / (own + ground), 0.01, "the damped motion"},
         std::fabs(last.reaction / last.displacement));
}

TEST(Coats, mortar_over_a_joint_without_friction_bears_its_own_shear) {
  ModelSpec spec = plastered();
  spec.material["plaster"].friction_angle = spec.material["plaster"].residual_friction_angle = 0;
  StageSpec push = scenes::push_stage("b1", Direction::kPlusX, 2e-3, 0.6e-3);
  push.damping = 0.3;
  push.get<PushStage>().fixity = {Freedom::kBlocked, Freedom::kBlocked};
  spec.stage = {scenes::gravity_stage(), push};
  Ran r{compile(spec), {}, {}};
  r.state = initial_state(r.model);
  r.result = solve(r.model, r.state);
  verify({"LM03", "plaster over a joint without friction, sheared: largest force", "N",
          kCohesion * kArea, 0.02, "rows of the curve, the block below turns a little"},
         largest(r));
}

// One face is half of two, and a rectangle covers what lies in it.
TEST(Coats, faces_and_rectangle_say_how_much_there_is) {
  const auto area = [](const ModelSpec& spec) {
    const Model model = compile(spec);
    double sum = 0;
    for (std::size_t j = 0; j < model.area.size(); ++j)
      if (model.anatomy.joint_kind[j] == JointKind::kCoat) sum += model.area[j];
    return sum;
  };
  ModelSpec spec = plastered();
  spec.stage = {scenes::gravity_stage()};
  EXPECT_NEAR(area(spec), kArea, 1e-12);
  spec.layer[0].sides = 1;
  EXPECT_NEAR(area(spec), kArea / 2, 1e-12);
  spec.layer[0].x = 0.25, spec.layer[0].width = 0.5;
  EXPECT_NEAR(area(spec), kArea / 4, 1e-12);
}

TEST(Coats, mortar_weighs_what_it_is_said_to) {
  ModelSpec spec = plastered();
  spec.stage = {scenes::gravity_stage()};
  spec.solve.gravity = 10;
  const double bare = compile(spec).weight;
  spec.layer[0].mortar.density = 1900;
  EXPECT_NEAR(compile(spec).weight - bare, 10 * 1900 * kArea * 2 * kHigh, 1e-6);
}

// A name says what the masonry does, and the ledger holds what its mortar takes.
TEST(Coats, a_plastered_wall_is_stronger_and_keeps_its_ledger) {
  ModelSpec spec = scenes::small_wall(1e-3, 0.01, 20e3);
  const auto peak = [](const ModelSpec& wall) {
    Ran r{compile(wall), {}, {}};
    r.state = initial_state(r.model);
    r.result = solve(r.model, r.state);
    EXPECT_EQ(r.result.status, SolveStatus::kCompleted);
    EXPECT_LT(r.result.energy.gap_ratio, 0.01);
    return largest(r);
  };
  const double plain = peak(spec);
  spec.material["plaster"] = plastered().material["plaster"];
  spec.layer = plastered().layer;
  EXPECT_GT(peak(spec), 1.05 * plain);  // it rocks on its foundation, where the mortar ends
}

// The path and the problem of the first fault.
std::string fault_of(ModelSpec spec) {
  spec.stage = {scenes::gravity_stage()};
  try {
    (void)compile(spec);
  } catch (const InputError& error) {
    return error.faults().front().path + ": " + error.faults().front().problem;
  }
  return "none";
}

TEST(Coats, what_cannot_be_is_refused_with_its_place) {
  EXPECT_EQ(fault_of(plastered()), "none");
  ModelSpec spec = plastered();
  spec.layer[0].mortar.joint = "plastre";
  EXPECT_EQ(fault_of(spec), "layer.0.mortar.joint: is no [material.*] of this model");
  spec = plastered();
  spec.layer[0].mortar.youngs_modulus = kUnset;
  EXPECT_EQ(fault_of(spec), "layer.0.mortar.youngs_modulus: is missing");
  spec = plastered();
  spec.layer[0].y = kHigh, spec.layer[0].height = kHigh;  // it ends at the joint
  EXPECT_EQ(fault_of(spec),
            "layer.0: crosses no joint of the masonry, so it can hold nothing together");
  spec = plastered();
  spec.layer[0].mortar.thickness = kUnset;
  EXPECT_EQ(fault_of(spec), "layer.0.mortar.thickness: is missing");
}

// Its stiffness is that of the layer (22.8), whatever its material says, and its energies are checked with that.
TEST(Coats, the_material_of_mortar_needs_no_stiffness) {
  const auto text = [](const std::string& stiffness) {
    return R"(wall = { length = "1.5 m", height = "2 m", thickness = "0.25 m", unit = { length = "250 mm", height = "125 mm", split = "none", density = "1800 kg/m^3" } }
layer = [{ sides = 2, mortar = { thickness = "30 mm", youngs_modulus = "12 GPa", joint = "plaster" } }]
stage = [{ name = "gravity" }]
[material.joint]
use = "limestone_dry"
normal_stiffness = "5 GPa/m"
shear_stiffness = "2 GPa/m"
friction_tan = 0.6
residual_friction_tan = 0.6
compressive_strength = "unlimited"
[material.plaster]
tensile_strength = "2 MPa"
cohesion = "2 MPa"
residual_cohesion = "0 MPa"
friction_tan = 0.8
residual_friction_tan = 0.6
mode_1_energy = "100 N/m"
mode_2_energy = "1000 N/m"
compressive_strength = "unlimited"
)" + stiffness;
  };
  const Model without = compile(parse_model(text(""), "wall.toml"));
  // with this one the energies would be too small
  const Model soft = compile(parse_model(
      text("normal_stiffness = \"0.1 GPa/m\"\nshear_stiffness = \"0.1 GPa/m\"\n"), "wall.toml"));
  EXPECT_EQ(without.materials.back().normal_stiffness, soft.materials.back().normal_stiffness);
  for (const Message& note : without.anatomy.notes)
    EXPECT_NE(note.code, "material.of_nothing") << text_of(note);
  const auto is_refused = [&] {
    std::string other = text("");
    other.replace(other.find("plaster\" }"), 7, "joint");
    try {
      (void)parse_model(other, "wall.toml");
    } catch (const InputError& error) {
      return error.faults().front().path == "material.plaster";
    }
    return false;
  };
  EXPECT_TRUE(is_refused()) << "a law of joints that lacks its stiffnesses";
  // enough for the stiff joints at the ends of courses (31 N/m), too little for those between whole units (42 N/m)
  std::string brittle = text("");
  brittle.replace(brittle.find("100 N/m"), 7, "35 N/m");
  try {
    (void)compile(parse_model(brittle, "wall.toml"));
    FAIL() << "energies are checked at some joints only";
  } catch (const InputError& error) {
    EXPECT_EQ(error.faults().front().path, "material.plaster.mode_1_energy");
  }
}

// Mortar alone has no fibres, and is a layer all the same.
TEST(Coats, limit_analysis_and_macro_blocks_refuse_mortar) {
  ModelSpec spec = scenes::small_wall(1e-3, 0.01, 20e3);
  spec.material["plaster"] = plastered().material["plaster"];
  spec.layer = plastered().layer;
  const Model model = compile(spec);
  const auto is_refused = [](const auto& work) {
    try {
      work();
    } catch (const InputError& error) {
      for (const Fault& fault : error.faults())
        if (fault.path == "layer") return true;
    }
    return false;
  };
  EXPECT_TRUE(is_refused([&] { (void)limit_load(model, {}, {}); }));
  EXPECT_TRUE(is_refused([&] { (void)find_portal(model); }));
}

}  // namespace
}  // namespace wythe::verification::coats_test
