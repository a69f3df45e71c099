// Deformable blocks in files and results: reading and writing, refusals with
// place, value and cure, and the run's messages about limits and steps.
#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

#include "io/bodies/blocks_json.h"
#include "io/results/curve_csv.h"
#include "io/results/vtu.h"
#include "reading/zones.h"
#include "scenes/scenes.h"
#include "scenes/zones.h"
#include "unit/io_helpers.h"
#include "wythe/parts/error.h"
#include "wythe/parts/report.h"
#include "wythe/parts/solve.h"

namespace wythe::zone_input_test {
namespace {

using namespace io_tests;

bool has(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

std::string refusal(const ModelSpec& spec) {
  try {
    (void)compile(spec);
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

std::string notes(const Model& model) {
  std::string all;
  for (const Message& note : model.anatomy.notes) all += text_of(note) + "\n";
  return all;
}

// A soft block on the ground between two rigid ones.
ModelSpec three_blocks() {
  ModelSpec spec = scenes::stack(3, 0.5, 0.2, scenes::elastic_joint(20e9, 8e9), 0.3, 1000);
  spec.material["soft"] = scenes::elastic_body(1e9, 0.2, 800);
  spec.block[1].material = "soft";
  spec.block[1].zone.zones = 2;
  return spec;
}

TEST(ZoneInput, stiff_fine_zones_say_that_their_added_inertia_drags) {
  ModelSpec spec = scenes::lintel_wall(LintelModel::kZones);
  spec.wall.opening[0].lintel.zones = 1;
  EXPECT_FALSE(has(notes(compile(spec)), "drags on the wall")) << notes(compile(spec));
  spec.material["timber"] = scenes::elastic_body(10e9, 0.2, 500);
  spec.wall.opening[0].lintel.zones = 4;
  EXPECT_TRUE(has(notes(compile(spec)), "drags on the wall")) << notes(compile(spec));
}

TEST(ZoneInput, keys_of_zones_beside_rigid_segments_are_said_to_be_idle) {
  ModelSpec spec = scenes::lintel_wall(LintelModel::kSegments);
  EXPECT_FALSE(has(notes(compile(spec)), "not used")) << notes(compile(spec));
  spec.wall.opening[0].lintel.zone_kind = ZoneKind::kCst;
  EXPECT_TRUE(has(notes(compile(spec)), "not used by rigid segments")) << notes(compile(spec));
}

// --- blocks files -----------------------------------------------------------------------------------

TEST(ZoneInput, a_blocks_file_keeps_its_zones) {
  const Folder folder;
  folder.write("stones.json", R"({"units": "mm", "thickness": 300, "blocks": [
    {"id": "b1", "polygon": [[0, 0], [500, 0], [500, 200]], "zones": 4, "zone_length": 50,
     "zone_kind": "cst", "plane": "strain", "material": "joint"},
    {"id": "b2", "polygon": [[0, 0], [500, 200], [0, 200]], "zones": 1}]})");
  const std::string tail = kModel.substr(kModel.find("[material.joint]"));
  const ModelSpec spec =
      read_model(folder.write("model.toml", "[wall]\nblocks = \"stones.json\"\n" + tail));
  ASSERT_EQ(spec.block.size(), 2U);
  EXPECT_EQ(spec.block[0].zone.zones, 4);
  EXPECT_EQ(spec.block[0].zone.length, 0.05);
  EXPECT_EQ(spec.block[0].zone.kind, ZoneKind::kCst);
  EXPECT_EQ(spec.block[0].zone.plane, Plane::kStrain);
  EXPECT_TRUE(std::isnan(spec.block[1].zone.length));

  folder.write("again.json", io::blocks_text(spec.block));
  const ModelSpec again = read_model(folder.write(
      "again.toml", "[wall]\nblocks = \"again.json\"\nthickness = \"0.3 m\"\n" + tail));
  for (std::size_t k = 0; k < 2; ++k) {
    EXPECT_EQ(again.block[k].zone.zones, spec.block[k].zone.zones);
    EXPECT_EQ(again.block[k].zone.kind, spec.block[k].zone.kind);
    EXPECT_EQ(again.block[k].zone.plane, spec.block[k].zone.plane);
  }
  EXPECT_EQ(again.block[0].zone.length, 0.05);
}

TEST(ZoneInput, bad_zones_in_a_blocks_file_are_named) {
  const auto fault = [](const std::string& keys) {
    const Folder folder;
    folder.write("stones.json",
                 R"({"units": "m", "thickness": 0.3, "blocks": [{"id": "b7", "polygon": [[0, 0],
                 [1, 0], [1, 1]], )" +
                     keys + "}]}");
    try {
      (void)read_model(folder.write(
          "model.toml",
          "[wall]\nblocks = \"stones.json\"\n" + kModel.substr(kModel.find("[material.joint]"))));
    } catch (const InputError& error) {
      return std::string(error.what());
    }
    return std::string();
  };
  EXPECT_TRUE(has(fault(R"("zones": -1)"),
                  "wall.blocks.b7.zones = -1: must be a whole number of zones, 0 or more"));
  EXPECT_TRUE(has(fault(R"("zones": 2.5)"), "wall.blocks.b7.zones = 2.5"));
  EXPECT_TRUE(has(fault(R"("zones": 2, "zone_length": 0)"),
                  "wall.blocks.b7.zone_length = 0: must be a number more than 0"));
  EXPECT_TRUE(has(fault(R"("zones": 2, "zone_kind": "quad")"),
                  R"(b7.zone_kind = "quad": must be one of "mixed", "cst")"));
}

// --- the model file -----------------------------------------------------------------------------------

TEST(ZoneInput, a_lintel_of_zones_is_read_and_written) {
  ModelSpec spec = scenes::lintel_wall(LintelModel::kZones);
  LintelSpec& lintel = spec.wall.opening[0].lintel;
  lintel.zones = 3;
  lintel.zone_length = 0.05;
  lintel.zone_kind = ZoneKind::kCst;
  lintel.top_bond = "joint";
  const std::string text = write_model(spec);
  EXPECT_TRUE(has(text, R"(model = "zones")")) << text;
  const ModelSpec again = parse_model(text, "model.toml", {});
  const LintelSpec& read = again.wall.opening[0].lintel;
  EXPECT_EQ(read.model, LintelModel::kZones);
  EXPECT_EQ(read.zones, 3);
  EXPECT_EQ(read.zone_length, 0.05);
  EXPECT_EQ(read.zone_kind, ZoneKind::kCst);
  EXPECT_EQ(read.top_bond, "joint");
  EXPECT_EQ(read.bearing_bond, "");
}

// --- what compile() refuses ---------------------------------------------------------------------------

TEST(ZoneInput, zones_too_thin_or_too_many) {
  ModelSpec spec = three_blocks();
  spec.block[1].zone.zones = 40;
  spec.block[1].zone.length = 0.5;
  EXPECT_TRUE(has(refusal(spec), "wall.blocks.b1.zones = 500 x 5 mm: zones are too thin"))
      << refusal(spec);
  spec.block[1].zone.length = 1e-3;
  spec.block[1].zone.zones = 1;
  EXPECT_TRUE(has(refusal(spec), "wall.blocks.b1.zone_length = 200 x 1 mm: zones are too thin"))
      << refusal(spec);
  spec.block[1].zone.zones = 200;
  EXPECT_TRUE(has(refusal(spec), "makes more than 20000 zones")) << refusal(spec);
}

TEST(ZoneInput, material_missing_or_inadmissible_is_said_once) {
  ModelSpec spec = three_blocks();
  spec.block[1].material = "nowhere";
  EXPECT_TRUE(has(refusal(spec), "is no [material.*] table")) << refusal(spec);
  spec = three_blocks();
  spec.material["soft"].shear_modulus = 0.3e9;
  spec.block[2].zone.zones = 1;
  spec.block[2].material = "soft";
  const std::string text = refusal(spec);
  const std::string problem = "makes the Poisson ratio E/2G - 1 = 0.667";
  EXPECT_TRUE(has(text, "material.soft.shear_modulus: " + problem)) << text;
  EXPECT_EQ(text.find(problem), text.rfind(problem)) << text;
  spec = three_blocks();
  spec.material["soft"].density = 0;
  EXPECT_TRUE(has(refusal(spec), "density")) << refusal(spec);
}

TEST(ZoneInput, neighbours_loads_and_pushes_need_rigid_blocks) {
  ModelSpec spec = three_blocks();
  spec.block[2].zone.zones = 1;
  spec.block[2].material = "soft";
  EXPECT_TRUE(has(refusal(spec), "two blocks of zones touch each other")) << refusal(spec);
  spec = three_blocks();
  spec.stage = {scenes::push_stage("b1", Direction::kPlusX, 0.01, 1e-3)};
  EXPECT_TRUE(has(refusal(spec), "stage.0.at = b1: would act on a block of zones"))
      << refusal(spec);
  spec = three_blocks();
  std::swap(spec.block[1].zone, spec.block[2].zone);
  std::swap(spec.block[1].material, spec.block[2].material);
  StageSpec load{.name = "load", .action = LoadStage{.pressure = 1e5}};
  spec.stage = {load};
  EXPECT_TRUE(has(refusal(spec), "stage.0.pressure = b2: would act on a block of zones"))
      << refusal(spec);
  spec = three_blocks();
  spec.block[0].fixed = true;
  spec.block.pop_back();
  EXPECT_TRUE(has(refusal(spec), "wall.blocks: every moving block is cut into zones"))
      << refusal(spec);
  spec = three_blocks();
  spec.block[1].beam = true;
  EXPECT_TRUE(has(refusal(spec), "wall.blocks.b1.zones = 2: the loading beam is rigid"))
      << refusal(spec);
}

TEST(ZoneInput, the_step_says_which_zones_rule_it) {
  ModelSpec spec = three_blocks();
  spec.block[1].zone.zones = 20;
  spec.block[1].zone.length = 0.01;
  spec.material["soft"].youngs_modulus = 50e9;
  spec.material["soft"].shear_modulus = 20e9;
  const Model raised = compile(spec);
  EXPECT_TRUE(has(notes(raised), "b1: inertia (not weight) of its nodes raised")) << notes(raised);
  spec.solve.raise_light_inertia = false;
  const Model strict = compile(spec);
  EXPECT_TRUE(has(notes(strict), "the node of b1 at (0.000, 0.200) m rules the time step"))
      << notes(strict);
  EXPECT_GT(strict.omega_max, 1.5 * raised.omega_max);
  EXPECT_NEAR(raised.weight, strict.weight, 1e-9);
}

// --- triangles in a wall --------------------------------------------------------------------------------

TEST(ZoneInput, a_polygon_is_cut_into_triangles_that_carry_its_weight) {
  BlockSpec base = scenes::rectangle("base", 0, 0, 1, 0.2), cap;
  cap.id = "gable";
  cap.polygon = {{0, 0.2}, {1, 0.2}, {0.8, 0.6}, {0.2, 0.6}};
  cap.material = "soft";
  cap.zone.zones = 3;
  ModelSpec spec = scenes::assembly({base, cap}, scenes::elastic_joint(20e9, 8e9), 0.3, 1000);
  spec.material["soft"] = scenes::elastic_body(1e9, 0.2, 800);
  spec.stage = {scenes::gravity_stage()};
  const Model model = compile(spec);
  EXPECT_TRUE(has(notes(model), "gable: ")) << notes(model);
  EXPECT_NEAR(model.weight, 9.81 * 0.3 * (0.2 * 1000 + 0.32 * 800), 1e-9);
  double face = 0;
  for (const double area : model.solids.contact_area) face += area;
  EXPECT_NEAR(face, 0.3, 1e-12);
  State state = initial_state(model);
  const Result result = solve(model, state, {});
  ASSERT_EQ(result.status, SolveStatus::kCompleted) << result.reason;
  double pressed = 0;
  for (const JointReading& joint : read_wall(model, state).joints)
    if (joint.shape.id >= model.n_joint) pressed += joint.compression;
  EXPECT_NEAR(pressed / (9.81 * 0.3 * 0.32 * 800), 1, 1e-4);  // settled to 1e-5
}

// --- results -----------------------------------------------------------------------------------------------

struct Pushed {
  Model model;
  State state;
  Result result;
};
Pushed pushed(double limit) {
  ModelSpec spec = scenes::lintel_wall(LintelModel::kZones, 0.5e-3);
  spec.material["timber"].tension_limit = limit;
  Pushed p{compile(spec), {}, {}};
  p.state = initial_state(p.model);
  p.result = solve(p.model, p.state, {});
  return p;
}

TEST(ZoneResults, a_limit_that_is_passed_is_said_once_with_its_place) {
  const auto beyond = [](const Result& result) {
    std::vector<std::string> found;
    for (const Event& event : result.events)
      if (event.name.code == "event.beyond_tension")
        found.push_back(text_of(event.name) + ": " + text_of(event.where));
    return found;
  };
  const auto said = beyond(pushed(1e3).result);
  ASSERT_EQ(said.size(), 1U);
  EXPECT_TRUE(has(said[0], "limit 0.001 MPa; it stays elastic")) << said[0];
  EXPECT_TRUE(beyond(pushed(1e9).result).empty());
}

TEST(ZoneResults, files_and_pictures_show_the_zones) {
  const Pushed p = pushed(kUnset);
  const std::string csv = io::curve_csv(p.result.curve, {.lintel_of_zones = true});
  EXPECT_TRUE(has(csv,
                  "work_damping_J,load_factor,lintel_deflection_mm,lintel_end_rotation_mrad,"
                  "lintel_axial_kN\n"));
  const std::string vtu = io::zones_vtu(p.model, p.state);
  EXPECT_TRUE(has(vtu, "NumberOfCells=\"" + std::to_string(p.model.solids.n_zone) + "\""));
  for (const char* name : {"stress_x_MPa", "stress_y_MPa", "stress_xy_MPa", "principal_1_MPa"})
    EXPECT_TRUE(has(vtu, name)) << name;
  const std::string joints = io::joints_vtu(p.model, p.state);
  EXPECT_TRUE(has(joints, "NumberOfCells=\"" +
                              std::to_string(p.model.n_joint + p.model.solids.n_contact) + "\""));
  State crushed = p.state;  // bearings crush as joints do
  crushed.crush[points_of(p.model, p.model.n_joint).begin] = 1;
  EXPECT_FALSE(has(wall_svg(p.model, p.state, 1), "class=\"crushed\""));
  EXPECT_TRUE(has(wall_svg(p.model, crushed, 1), "class=\"crushed\""));
  const std::string svg = wall_svg(p.model, p.state, 1);
  EXPECT_TRUE(has(svg, "class=\"timber\""));
  EXPECT_TRUE(has(svg, "class=\"zone\""));
}

TEST(ZoneResults, principal_stresses_are_those_of_mohr_s_circle) {
  ZoneReading zone;
  zone.sigma_x = 3;
  zone.sigma_y = -1;
  zone.tau = 1.5;
  const auto [greatest, least] = principal_stresses(zone);
  EXPECT_NEAR(greatest, 3.5, 1e-14);
  EXPECT_NEAR(least, -1.5, 1e-14);
}

}  // namespace
}  // namespace wythe::zone_input_test
