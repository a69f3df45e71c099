// Head joints with a share of their beds' bond (head_joint_bond; docs/theory/material_rules.md, 9.6):
// the law, the joints that have it in the plane and in space, and the same scatter as in the beds.
#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "contact/parameters.h"
#include "model/compiler.h"
#include "model/fields.h"
#include "model/space/space.h"
#include "model/space/space_roles.h"
#include "scenes/scenes.h"
#include "wythe/parts/io.h"
#include "wythe/parts/reading.h"
#include "wythe/parts/solve.h"

namespace wythe::head_joints_test {
namespace {

JointMaterial bed(double share) {
  JointMaterial m = scenes::paper_joint();
  m.head_joint_bond = share;
  return m;
}

// --- the law ---------------------------------------------------------------------------------------------

TEST(HeadJoints, have_the_share_of_strengths_and_energies_and_all_of_the_rest) {
  JointMaterial m = bed(0.25);
  m.residual_cohesion = 0.02e6;
  const JointMaterial head = contact::head_joint_law(m);
  EXPECT_EQ(head.tensile_strength, 0.25 * m.tensile_strength);
  EXPECT_EQ(head.cohesion, 0.25 * m.cohesion);
  EXPECT_EQ(head.residual_cohesion, 0.005e6);
  EXPECT_EQ(head.mode_1_energy, 0.25 * m.mode_1_energy);
  EXPECT_EQ(head.mode_2_energy, 0.25 * m.mode_2_energy);
  EXPECT_EQ(head.friction_angle, m.friction_angle);
  EXPECT_EQ(head.residual_friction_angle, m.residual_friction_angle);
  EXPECT_EQ(head.normal_stiffness, m.normal_stiffness);
  EXPECT_EQ(head.shear_stiffness, m.shear_stiffness);
  EXPECT_EQ(head.compressive_strength, m.compressive_strength);
  EXPECT_EQ(head.compressive_energy, m.compressive_energy);
}

// (9.1): c 0.15 MPa, tan phi 0.8 and 0.5 at fc 3.96 MPa, ks 8 GPa/m. The drop is 0.0375 + 1.188 MPa, and
// 1.05 x 1.2255^2 / (2 x 8e9) Pa m = 98.56 N/m, where a quarter of 130 would be 32.5.
TEST(HeadJoints, keep_as_much_mode_2_energy_as_the_drop_of_friction_asks_for) {
  JointMaterial m = bed(0.25);
  m.friction_angle = std::atan(0.8);
  m.residual_friction_angle = std::atan(0.5);
  m.mode_2_energy = 130;
  ASSERT_TRUE(check_joint_material(m).empty());
  const double drop = 0.0375e6 + 0.3 * 3.96e6;
  EXPECT_NEAR(contact::head_joint_law(m).mode_2_energy, 1.05 * drop * drop / (2 * 8e9), 1e-9);
  // and never more than the beds
  m.mode_2_energy = 115;
  ASSERT_TRUE(check_joint_material(m).empty());
  EXPECT_LE(contact::head_joint_law(m).mode_2_energy, 115);
}

TEST(HeadJoints, are_admissible_wherever_their_beds_are) {
  EXPECT_TRUE(rc::check("head law of a random bed", [] {
    const auto between = [](double low, double high) {
      return low + (high - low) * *rc::gen::inRange(0, 1001) / 1000.0;
    };
    JointMaterial m = bed(between(0, 1));
    m.softening = *rc::gen::element(Softening::kBilinear, Softening::kExponential,
                                    Softening::kPolynomial, Softening::kPetersson);
    m.tensile_strength = between(0, 0.5e6);
    m.cohesion = between(0, 1e6);
    m.residual_cohesion = between(0, 1) * m.cohesion;
    m.friction_angle = between(0.1, 1.2);
    m.residual_friction_angle = between(0.1, 1) * m.friction_angle;
    m.mode_1_energy = between(0, 20);
    m.mode_2_energy = between(0, 400);
    if (*rc::gen::arbitrary<bool>()) m.mode_2_energy_per_pressure = between(0, 0.2e-3);
    if (*rc::gen::arbitrary<bool>()) m.compressive_strength = kUnlimited;
    RC_PRE(check_joint_material(m).empty());
    const JointMaterial head = contact::head_joint_law(m);
    RC_ASSERT(check_joint_material(head).empty());
    RC_ASSERT(!(head.mode_2_energy > m.mode_2_energy));
  }));
}

TEST(HeadJoints, are_refused_a_share_that_is_none) {
  for (const double share : {-0.1, 1.5, kUnlimited}) {
    const auto faults = check_joint_material(bed(share));
    ASSERT_EQ(faults.size(), 1U) << share;
    EXPECT_EQ(faults[0].key, "head_joint_bond");
    EXPECT_NE(faults[0].problem.find("from 0 to 1"), std::string::npos);
  }
}

// --- one head joint pulled -------------------------------------------------------------------------------

// A wall of one course: the left stone is held by the ground, the right one, on ground without friction, is pulled off.
// Their head joint is 0.2 m x 0.3 m.
ModelSpec one_course(double share) {
  BlockSpec left = scenes::rectangle("left", 0, 0, 0.3, 0.2),
            right = scenes::rectangle("right", 0.3, 0, 0.3, 0.2),
            rock = scenes::rectangle("rock", 0, -0.2, 0.6, 0.2);
  left.material = "held";
  right.material = "free";
  rock.fixed = true;
  ModelSpec spec = scenes::assembly({rock, left, right}, bed(share), 0.3, 1800);
  spec.material["glue"] = scenes::elastic_joint(200e9, 80e9);
  spec.material["ice"] = scenes::dry_joint(20e9, 8e9, 0);
  spec.contact = {{{"held", "masonry"}, "glue"}, {{"free", "masonry"}, "ice"}};
  spec.solve.gravity = 0;
  spec.stage = {scenes::push_stage("right", Direction::kPlusX, 2e-4, 3e-5)};
  return spec;
}

// The same as prisms in space.
ModelSpec one_course_in_space(double share) {
  const ModelSpec plane = one_course(share);
  ModelSpec spec = scenes::prisms(plane);
  for (std::size_t k = 0; k < spec.body.size(); ++k)
    spec.body[k].material = plane.block[k].material;
  return spec;
}

double peak_of(const ModelSpec& spec) {
  const Model model = compile(spec);
  State state = initial_state(model);
  return solve(model, state).responses.peak_raw;
}

// The pull ends at the strength; 1 % is what the inertia of 43 kg and the rows' averages leave of it.
TEST(HeadJoints, pulled_apart_bear_the_share_of_the_tensile_strength_on_their_area) {
  for (const double share : {1.0, 0.5, 0.25}) {
    const double wanted = share * 0.15e6 * 0.2 * 0.3;
    EXPECT_NEAR(peak_of(one_course(share)), wanted, 0.01 * wanted) << share;
    EXPECT_NEAR(peak_of(one_course_in_space(share)), wanted, 0.01 * wanted) << share;
  }
}

// --- which joints ----------------------------------------------------------------------------------------

// Tensile strengths of the joints of each kind [MPa].
std::set<double> strengths(const Model& model, JointKind kind) {
  std::set<double> found;
  for (int j = 0; j < model.n_joint; ++j)
    if (model.anatomy.joint_kind[j] == kind)
      found.insert(model.materials[model.joint_material[j]].tensile_strength / 1e6);
  return found;
}

using Values = std::set<double>;

ModelSpec wall(double share) {
  ModelSpec spec = scenes::small_wall();
  spec.material.at("joint").head_joint_bond = share;
  return spec;
}

TEST(HeadJoints, of_a_wall_take_it_and_beds_foundation_and_units_do_not) {
  const Model model = compile(wall(0.25));
  EXPECT_EQ(strengths(model, JointKind::kHead), Values{0.25 * 0.15});
  EXPECT_EQ(strengths(model, JointKind::kBed), Values{0.15});
  EXPECT_EQ(strengths(model, JointKind::kFoundation), Values{0.15});
  EXPECT_EQ(strengths(model, JointKind::kSplit), Values{0.23});
  const auto said = [&](const Model& of) {
    return std::count_if(of.anatomy.notes.begin(), of.anatomy.notes.end(), [](const Message& note) {
      return note.code == "material.head_joint_bond";
    });
  };
  EXPECT_EQ(said(model), 1);
  EXPECT_EQ(said(compile(wall(1))), 0);
}

TEST(HeadJoints, with_a_material_of_their_own_are_as_it_says) {
  ModelSpec spec = wall(0.25);
  spec.wall.joints.head_joint = "joint";  // by name: as the beds
  EXPECT_EQ(strengths(compile(spec), JointKind::kHead), Values{0.15});
}

TEST(HeadJoints, of_a_region_follow_its_beds) {
  ModelSpec spec = wall(0.25);
  spec.material["new"] = bed(0.5);
  spec.material["new"].tensile_strength = 0.2e6;
  RegionSpec region;
  region.place.x = region.place.y = 0;
  region.place.width = region.place.height = 0.4;
  region.joints.joint = "new";
  spec.region = {region};
  EXPECT_EQ(strengths(compile(spec), JointKind::kHead), (Values{0.25 * 0.15, 0.1}));
  spec.region[0].joints.head_joint = "new";
  EXPECT_EQ(strengths(compile(spec), JointKind::kHead), (Values{0.25 * 0.15, 0.2}));
}

std::string end_of(const ModelSpec& spec) {
  const Model model = compile(spec);
  State state = initial_state(model);
  (void)solve(model, state);
  return state_hash(state);
}

TEST(HeadJoints, without_a_share_are_dry_and_with_all_of_it_as_the_beds) {
  ModelSpec dry = wall(kUnset);
  dry.material["dry"] = dry.material.at("joint");
  dry.material["dry"].tensile_strength = dry.material["dry"].cohesion = 0;
  dry.wall.joints.head_joint = "dry";
  EXPECT_EQ(end_of(wall(0)), end_of(dry));
  EXPECT_EQ(end_of(wall(1)), end_of(wall(kUnset)));
  EXPECT_NE(end_of(wall(0)), end_of(wall(1)));
}

TEST(HeadJoints, of_a_blocks_file_take_it_unless_a_contact_rule_names_their_material) {
  ModelSpec spec = scenes::half_units({}, bed(0.25));
  EXPECT_EQ(strengths(compile(spec), JointKind::kHead), Values{0.25 * 0.15});
  EXPECT_EQ(strengths(compile(spec), JointKind::kBed), Values{0.15});
  spec.contact = {{{"masonry", "masonry"}, "joint"}};
  EXPECT_EQ(strengths(compile(spec), JointKind::kHead), Values{0.15});
}

// --- in space --------------------------------------------------------------------------------------------

const std::string kSpace = R"(
[wall]
height = "0.6 m"
thickness = "0.1 m"
[wall.unit]
length = "200 mm"
height = "100 mm"
density = "2000 kg/m^3"
[material.joint]
normal_stiffness = "20 GPa/m"
shear_stiffness = "8 GPa/m"
tensile_strength = "0.15 MPa"
cohesion = "0.15 MPa"
friction_angle = "30 deg"
residual_friction_angle = "25 deg"
residual_cohesion = "0 MPa"
mode_1_energy = "4.3 N/m"
mode_2_energy = "125 N/m"
compressive_strength = "4 MPa"
compressive_energy = "12800 N/m"
head_joint_bond = 0.25
[[stage]]
name = "gravity"
)";

// Faces of a model in space, by whether they share a bed's material: names of their two bodies.
std::map<bool, std::vector<std::pair<std::string, std::string>>> faces_of(const ModelSpec& spec) {
  FaultList none;
  const geometry::SpaceAssembly assembly = assemble_space(spec, none);
  const geometry::Shape shape(spec);
  std::map<bool, std::vector<std::pair<std::string, std::string>>> found;
  for (const geometry::JointFace& face : assembly.faces) {
    const BodySpec &a = assembly.body[face.a], &b = assembly.body[face.b];
    found[shares_bed(shape, a, b, face.normal)].emplace_back(a.id, b.id);
  }
  return found;
}

const std::string kCorner = R"(
[material.unit]
normal_stiffness = "20 GPa/m"
shear_stiffness = "8 GPa/m"
tensile_strength = "1 MPa"
cohesion = "1 MPa"
friction_angle = "30 deg"
residual_friction_angle = "25 deg"
residual_cohesion = "0 MPa"
mode_1_energy = "80 N/m"
mode_2_energy = "800 N/m"
compressive_strength = "4 MPa"
compressive_energy = "12800 N/m"
[[plan_wall]]
name = "front"
line = [["0 m", "0 m"], ["0.75 m", "0 m"]]
[[plan_wall]]
name = "side"
line = [["0 m", "0 m"], ["0 m", "0.75 m"]]
)";

TEST(HeadJoints, of_walls_in_space_take_it_and_pieces_of_a_unit_do_not) {
  const ModelSpec spec = parse_model(kSpace + kCorner, "wall.toml");
  auto faces = faces_of(spec);
  EXPECT_GT(faces[true].size(), 20U);
  for (const auto& [a, b] : faces[true]) {
    EXPECT_EQ(course_of(a), course_of(b)) << a << ", " << b;
    EXPECT_FALSE(unit_of(a) == unit_of(b) && !unit_of(a).empty()) << a << ", " << b;
  }
  for (const auto& [a, b] : faces[false])
    EXPECT_TRUE(course_of(a) != course_of(b) || unit_of(a) == unit_of(b)) << a << ", " << b;
  const Model model = compile(spec);
  std::map<double, std::size_t> joints;
  for (const std::int32_t m : model.joint_material) ++joints[model.materials[m].tensile_strength];
  EXPECT_EQ(joints[0.25 * 0.15e6], faces[true].size());
}

// The head joints' law of "joint" was once found under "oint", the name without its first letter.
TEST(HeadJoints, in_space_leave_a_material_alone_whose_name_is_theirs_but_one_letter) {
  std::string text = kCorner;
  text.replace(text.find("[material.unit]"), 15, "[material.oint]");
  const Model model = compile(parse_model(kSpace + text, "wall.toml", {"wall.unit_joint=oint"}));
  std::map<double, int> joints;
  for (const std::int32_t m : model.joint_material) ++joints[model.materials[m].tensile_strength];
  EXPECT_GT(joints[1e6], 0);
  EXPECT_GT(joints[0.25 * 0.15e6], 0);
}

// An even number of voussoirs has a joint at its crown, as upright as a head joint.
TEST(HeadJoints, of_a_vault_take_it_and_its_beds_do_not_at_the_crown_either) {
  const ModelSpec spec = parse_model(kSpace + R"(
[[arch]]
name = "vault"
span = "2 m"
depth = "0.2 m"
width = "1 m"
voussoirs = 10
units = 3
)",
                                     "vault.toml");
  auto faces = faces_of(spec);
  EXPECT_EQ(faces[true].size(), 10U * 2 + 5U);  // running bond: each second course has a unit more
  for (const auto& [a, b] : faces[true]) EXPECT_EQ(course_of(a), course_of(b)) << a << ", " << b;
}

// --- what varies in the beds -----------------------------------------------------------------------------

TEST(HeadJoints, follow_a_sample_of_the_beds_strength_within_one_assembly) {
  const ModelSpec base = wall(0.25);
  const Compiler compiler(base);
  ModelSpec sample = base;
  sample.material.at("joint").tensile_strength = 0.2e6;
  EXPECT_EQ(strengths(compiler.compile(sample), JointKind::kHead), Values{0.05});
  sample.material.at("joint").head_joint_bond = 0.5;
  EXPECT_EQ(strengths(compiler.compile(sample), JointKind::kHead), Values{0.1});
  sample.material.at("joint").head_joint_bond = 1;
  EXPECT_EQ(strengths(compiler.compile(sample), JointKind::kHead), Values{0.2});
}

// Tensile strength of each joint by its place [Pa].
std::map<std::array<double, 3>, double> strength_at(const ModelSpec& spec) {
  const Model model = compile(spec);
  std::map<std::array<double, 3>, double> found;
  for (int j = 0; j < model.n_joint; ++j) {
    const Vec3 c = joint_shape(model, j).centre;
    found[{c.x, c.y, c.z}] = model.materials[model.joint_material[j]].tensile_strength;
  }
  return found;
}

TEST(HeadJoints, have_their_share_of_a_field_at_their_place) {
  const ModelSpec plane = scenes::half_units({}, bed(1));
  for (const ModelSpec& bare : {plane, scenes::prisms(plane)}) {
    ModelSpec spec = scenes::with_fields(bare, 7);
    const auto full = strength_at(spec);
    spec.material.at("joint").head_joint_bond = 0.25;
    const auto quarter = strength_at(spec);
    std::set<double> heads, beds;
    for (const auto& [place, own] : quarter) {
      const double whole = full.at(place);
      (own == whole ? beds : heads).insert(own);
      EXPECT_TRUE(own == whole || own == 0.25 * whole) << own << " of " << whole;
    }
    EXPECT_GT(heads.size(), 30U);
    EXPECT_GT(beds.size(), 30U);
  }
}

}  // namespace
}  // namespace wythe::head_joints_test
