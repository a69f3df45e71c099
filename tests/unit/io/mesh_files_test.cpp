// Bodies from files: OBJ, PLY, STL, COMPAS and blocks files in space; their joint faces against an independent count.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <random>
#include <set>
#include <string>

#include <nlohmann/json.hpp>

#include "core/files.h"
#include "core/limits.h"
#include "geometry/bodies/joint_faces.h"
#include "io/bodies/blocks_json.h"
#include "io/bodies/bodies_file.h"
#include "io/bodies/meshes.h"
#include "scenes/mesh_texts.h"
#include "scenes/places.h"
#include "scenes/small_study.h"
#include "scenes/solids.h"
#include "wythe/parts/io.h"

namespace wythe::mesh_files_test {
namespace {

using scenes::ascii_stl;
using scenes::binary_stl;
using scenes::kTwoBoxes;
using scenes::ply;
using scenes::TemporaryFolder;

bool has(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

std::string data(const std::string& name) { return source_dir() + "/tests/data/compas/" + name; }

void write(const std::string& path, const std::string& text) {
  std::ofstream(path, std::ios::binary) << text;
}

std::string said(const FaultList& faults) {
  std::string all;
  for (const Fault& fault : faults.all()) all += to_string(fault) + "\n";
  return all;
}

constexpr const char* kLaws = R"([material.joint]
normal_stiffness = "20 GPa/m"
shear_stiffness = "8 GPa/m"
tensile_strength = "0.15 MPa"
cohesion = "0.15 MPa"
friction_angle = "16.2 deg"
residual_friction_angle = "14.6 deg"
residual_cohesion = "0 MPa"
mode_1_energy = "4.3 N/m"
mode_2_energy = "125 N/m"
compressive_strength = "3.96 MPa"
compressive_energy = "12800 N/m"
[[stage]]
name = "gravity"
)";

// A model file with this [wall], beside a file of blocks; its spec, or what was refused.
class BodyFiles : public ::testing::Test {
 protected:
  ModelSpec read(const std::string& wall, const std::string& blocks = "") {
    return parse_model(text(wall), at("model.toml"), {}, blocks);
  }
  std::string refusal(const std::string& wall) {
    try {
      (void)read(wall);
    } catch (const InputError& error) {
      return error.what();
    }
    return "";
  }
  [[nodiscard]] std::string at(const std::string& name) const { return folder_ / name; }
  static std::string text(const std::string& wall) {
    return "[wall]\n" + wall + "\n[wall.unit]\ndensity = \"2000 kg/m^3\"\n" + kLaws;
  }

  TemporaryFolder folder_;
};

struct Counted {
  std::string file;
  std::size_t bodies, pairs;
  double area, volume;
  double
      closeness;  // of area and volume: round-off; warped faces, whose triangles are another surface
};

// Read as metres with z up; assembled without supports.
geometry::SpaceAssembly assembly_of(const std::string& file) {
  FaultList faults;
  std::vector<BodySpec> bodies;
  if (io::is_mesh_file(file))
    bodies = io::parse_mesh_bodies(file, faults);
  else
    bodies = io::compas_bodies(nlohmann::json::parse(read_text(file, 1'000'000)), file, faults);
  io::place(bodies, 1, true);
  for (BodySpec& body : bodies) body.fixed = false;
  geometry::SpaceAssembly assembly = geometry::assemble(bodies, faults);
  EXPECT_TRUE(faults.empty()) << said(faults);
  return assembly;
}

// Area of the upper base of body 0 of bridge.json: the sum over its border edges, which triangles inside share.
double section_of_pier() {
  const auto json = nlohmann::json::parse(read_text(data("bridge.json"), 1'000'000));
  const auto& mesh =
      json.at("data").at("graph").at("data").at("node").at("0").at("block").at("data");
  double area = 0;
  for (const auto& face : mesh.at("face")) {
    double twice = 0;
    bool is_base = true;
    for (std::size_t k = 0; k < face.size(); ++k) {
      const auto corner = [&](std::size_t i) {
        return mesh.at("vertex").at(std::to_string(face[i % face.size()].get<int>()));
      };
      const auto p = corner(k), q = corner(k + 1);
      is_base = is_base && p.at("y").get<double>() > 0.25;
      twice += p.at("x").get<double>() * q.at("z").get<double>() -
               q.at("x").get<double>() * p.at("z").get<double>();
    }
    if (is_base) area += std::fabs(twice) / 2;
  }
  return area;
}

// Counts of tests/data/compas/count_faces.py, which clips triangle by triangle. It takes 9 strips of 0.2 to 0.5 between
// blocks of the cross vault that meet at an edge for pairs (461); COMPAS, which found 452 too, does not.
TEST(MeshFiles, joint_faces_are_those_of_an_independent_count) {
  const std::vector<Counted> files = {
      {"crossvault.obj", 184, 452, 227232, 3524259, 1e-4},
      {"dome.obj", 90, 250, 72.4756, 37.717993, 1e-2},
      {"wall.obj", 38, 60, 14.625, 4.365625, 1e-9},
      {"A.json", 3, 2, 1.84752, 2.6380163, 1e-5},
      {"H.json", 3, 2, 1.6, 2.4000002, 1e-5},
      {"cubes.json", 3, 2, 1.9412, 7.3659708, 1e-5},
      {"shelf.json", 11, 18, 0.400812, 0.33599687, 1e-5},
      {"dem_crossvault.json", 38, 60, 58.5, 34.925, 1e-9},
  };
  for (const Counted& known : files) {
    SCOPED_TRACE(known.file);
    const auto assembly = assembly_of(data(known.file));
    ASSERT_EQ(assembly.moments.size(), known.bodies);
    std::set<std::pair<int, int>> pairs;
    double area = 0, volume = 0;
    for (const auto& face : assembly.faces) {
      pairs.emplace(face.a, face.b);
      area += face.area;
    }
    for (const auto& moments : assembly.moments) volume += moments.volume;
    EXPECT_EQ(pairs.size(), known.pairs);
    EXPECT_NEAR(area, known.area, known.closeness * known.area);
    EXPECT_NEAR(volume, known.volume, known.closeness * known.volume);
  }
}

// COMPAS stores the contacts it found: 60 polygons of 58.5 in all, and 5 blocks as supports.
TEST(MeshFiles, a_block_model_has_the_contacts_that_compas_found) {
  const auto assembly = assembly_of(data("dem_crossvault.json"));
  double area = 0;
  for (const auto& face : assembly.faces) area += face.area;
  EXPECT_EQ(assembly.faces.size(), 60U);
  EXPECT_NEAR(area, 58.5, 1e-9);
  FaultList faults;
  const auto bodies = io::compas_bodies(
      nlohmann::json::parse(read_text(data("dem_crossvault.json"), 1'000'000)), "f", faults);
  EXPECT_EQ(std::count_if(bodies.begin(), bodies.end(), [](const auto& b) { return b.fixed; }), 5);
  EXPECT_EQ(bodies[12].id, "12");
}

// Six stray solids of COMPAS's examples, two pairs of which lie in each other.
TEST(MeshFiles, solids_in_each_other_are_named_with_their_depth) {
  FaultList faults;
  auto bodies = io::parse_mesh_bodies(data("ursula.obj"), faults);
  ASSERT_EQ(bodies.size(), 6U);
  (void)geometry::assemble(bodies, faults);
  EXPECT_TRUE(has(said(faults), "wall.blocks.Mesh 4 = 51.3408 mm deep: lies in body Mesh 3"))
      << said(faults);
}

TEST(MeshFiles, a_dome_has_a_joint_for_each_pair_and_two_parts_a_block) {
  const auto dome = assembly_of(data("dome.obj"));
  EXPECT_EQ(dome.faces.size(), 250U);
  EXPECT_EQ(dome.lost_faces, 0);
  for (const BodySpec& body : dome.body) EXPECT_EQ(body.part.size(), 2U) << body.id;
  const auto vault = assembly_of(data("crossvault.obj"));
  EXPECT_EQ(vault.faces.size(), 488U);  // as many as COMPAS found
  EXPECT_EQ(vault.lost_faces, 0);
}

TEST(MeshFiles, bodies_that_are_not_convex_are_cut_and_keep_their_volume) {
  const auto vault = assembly_of(data("crossvault.obj"));
  int cut = 0;
  for (const BodySpec& body : vault.body) cut += body.part.size() > 1;
  EXPECT_EQ(cut, 40);  // the groins
  for (const BodySpec& body : vault.body) EXPECT_LE(body.part.size(), 4U) << body.id;
}

// The piers of this bridge are letters with two holes each, which no plane cuts without a hole in its cap.
TEST(MeshFiles, a_prism_with_holes_is_cut_by_its_base) {
  const auto bridge = assembly_of(data("bridge.json"));
  ASSERT_EQ(bridge.body.size(), 16U);
  for (const std::size_t pier : {0U, 1U}) {
    EXPECT_GT(bridge.body[pier].part.size(), 4U);
    EXPECT_LT(bridge.body[pier].part.size(), 25U);
    for (const Polyhedron& part : bridge.body[pier].part)
      EXPECT_GT(geometry::solid_moments(part).volume, 0);
  }
  // the section's polygon less its holes, by the shoelace formula, times 0.5 m
  EXPECT_NEAR(bridge.moments[0].volume, 0.5 * section_of_pier(), 1e-6);
}

TEST(MeshFiles, a_body_that_can_not_be_cut_is_named) {
  FaultList faults;
  auto bodies = io::compas_bodies(nlohmann::json::parse(read_text(data("bridge.json"), 1'000'000)),
                                  "f", faults);
  bodies.resize(1);
  for (Polyhedron& part : bodies[0].part)
    for (Vec3& corner : part.vertex) corner.x *= 1 + 0.4 * corner.y;  // no prism any more
  (void)geometry::assemble(bodies, faults);
  EXPECT_TRUE(has(said(faults), "wall.blocks.0: is not convex")) << said(faults);
}

// --- the same solids in every format

TEST_F(BodyFiles, an_obj_has_a_block_a_group_with_its_material) {
  write(at("two.obj"), kTwoBoxes);
  const ModelSpec spec = read("blocks = \"two.obj\"\nblocks_unit = \"m\"\nsupports = [\"lo*\"]");
  ASSERT_EQ(spec.body.size(), 2U);
  EXPECT_EQ(spec.body[0].id, "low");
  EXPECT_EQ(spec.body[0].material, "tuff");
  EXPECT_EQ(spec.body[1].material, "brick");
  EXPECT_TRUE(spec.body[0].fixed);
  EXPECT_FALSE(spec.body[1].fixed);
  EXPECT_EQ(spec.wall.up, "z");
  // (x, y, z) with z up becomes (x, z, -y)
  EXPECT_EQ(spec.body[1].part[0].vertex.back().y, 2);
  EXPECT_EQ(spec.body[1].part[0].vertex.back().z, -1);
  FaultList faults;
  const auto assembly = geometry::assemble(spec.body, faults);
  ASSERT_EQ(assembly.faces.size(), 1U) << said(faults);
  EXPECT_EQ(assembly.faces[0].normal.y, 1);
}

TEST_F(BodyFiles, every_mesh_format_gives_the_same_solids) {
  const std::vector<BodySpec> boxes = {
      scenes::box_body("a", {0, 0, 0}, {1, 1, 1}), scenes::box_body("b", {0, 0, 1}, {1, 1, 2}),
      scenes::box_body("c", {1, 0, 0}, {2, 1, 1}), scenes::box_body("d", {0, 1, 1}, {1, 2, 2})};
  write(at("w1.stl"), ascii_stl(boxes));
  write(at("w2.stl"), binary_stl(boxes));
  write(at("w3.ply"), ply(boxes, "ascii"));
  write(at("w4.ply"), ply(boxes, "binary_little_endian"));
  write(at("w5.ply"), ply(boxes, "binary_big_endian"));
  for (const std::string name : {"w1.stl", "w2.stl", "w3.ply", "w4.ply", "w5.ply"}) {
    SCOPED_TRACE(name);
    FaultList faults;
    const auto bodies = io::parse_mesh_bodies(at(name), faults);
    ASSERT_EQ(bodies.size(), 4U) << said(faults);  // though they share corners, edges and faces
    const auto assembly = geometry::assemble(bodies, faults);
    EXPECT_TRUE(faults.empty()) << said(faults);
    EXPECT_EQ(assembly.faces.size(), 3U);  // a-b, a-c, b-d
    for (const auto& face : assembly.faces) {
      EXPECT_NEAR(face.area, 1, 1e-12);
      EXPECT_EQ(face.polygon.size(), 4U);
    }
    for (const auto& moments : assembly.moments) EXPECT_NEAR(moments.volume, 1, 1e-12);
  }
}

TEST_F(BodyFiles, a_star_in_the_name_reads_a_file_a_block) {
  std::filesystem::create_directory(at("stones"));
  for (const int k : {10, 2, 1})
    write(
        at("stones/stone_" + std::to_string(k) + ".ply"),
        ply({scenes::box_body("a", {0, 0, 1000.0 * k}, {1000, 1000, 1000.0 * (k + 1)})}, "ascii"));
  const ModelSpec spec =
      read("blocks = \"stones/*.ply\"\nblocks_unit = \"mm\"\nsupports = [\"lowest\"]");
  ASSERT_EQ(spec.body.size(), 3U);
  EXPECT_EQ(spec.body[0].id, "stone_1");
  EXPECT_EQ(spec.body[2].id, "stone_10");
  EXPECT_EQ(spec.body[0].part[0].vertex.back().y, 2);
  EXPECT_TRUE(spec.body[0].fixed);
  EXPECT_FALSE(spec.body[1].fixed);
  EXPECT_TRUE(has(refusal("blocks = \"none/*.ply\"\nblocks_unit = \"m\""), "names no file"));
}

constexpr const char* kSpaceJson = R"({"units": "mm", "blocks": [
  {"id": "base", "polygon": [[0, 0], [0, -100], [1000, -100], [1000, 0]], "z": [0, 200], "fixed": true},
  {"id": "wedge", "material": "stone", "vertices": [[0, 0, 0], [400, 0, 0], [0, 300, 0], [0, 0, 200], [400, 0, 200], [0, 300, 200]],
   "faces": [[0, 2, 1], [3, 4, 5], [0, 1, 4, 3], [1, 2, 5, 4], [2, 0, 3, 5]]},
  {"id": "pair", "parts": [{"polygon": [[500, 0], [600, 0], [600, 100], [500, 100]], "z": [0, 200]},
                           {"polygon": [[600, 0], [700, 0], [700, 200], [600, 200]], "z": [0, 200]}]}]})";

TEST_F(BodyFiles, a_blocks_file_has_a_third_dimension) {
  write(at("b.json"), kSpaceJson);
  const ModelSpec spec = read("blocks = \"b.json\"");
  ASSERT_EQ(spec.body.size(), 3U);
  EXPECT_TRUE(spec.block.empty());
  EXPECT_EQ(spec.wall.up, "y");
  EXPECT_TRUE(spec.body[0].fixed);
  EXPECT_EQ(spec.body[1].material, "stone");
  EXPECT_EQ(spec.body[2].part.size(), 2U);
  FaultList faults;
  const auto assembly = geometry::assemble(spec.body, faults);
  EXPECT_TRUE(faults.empty()) << said(faults);
  EXPECT_NEAR(assembly.moments[0].volume, 0.02, 1e-15);
  EXPECT_NEAR(assembly.moments[1].volume, 0.012, 1e-15);
  EXPECT_NEAR(assembly.moments[2].volume, 0.006, 1e-15);
  EXPECT_EQ(assembly.faces.size(), 2U);
}

// The blocks file beside the results of a run is read again to the bit, in the file's axes.
TEST_F(BodyFiles, what_is_written_back_is_read_to_the_bit) {
  write(at("b.json"), kSpaceJson);
  std::filesystem::copy_file(data("dome.obj"), at("dome.obj"));
  std::filesystem::copy_file(data("bridge.json"), at("bridge.json"));
  for (const std::string wall :
       {"blocks = \"b.json\"", "blocks = \"b.json\"\nup = \"z\"",
        "blocks = \"dome.obj\"\nblocks_unit = \"ft\"\nsupports = [\"lowest\"]",
        "blocks = \"bridge.json\"\nblocks_unit = \"cm\"\nup = \"y\""}) {
    SCOPED_TRACE(wall);
    const ModelSpec spec = read(wall);
    ASSERT_FALSE(spec.body.empty());
    const ModelSpec given = read(wall, io::blocks_text(spec, true));  // a campaign keeps the text
    ModelSpec used = spec;                                            // a run writes both files
    used.wall.blocks = "again.json";
    write(at("again.json"), io::blocks_text(spec));
    const ModelSpec again = parse_model(write_model(used), at("model.used.toml"), {});
    for (const ModelSpec* other : {&given, &again}) {
      ASSERT_EQ(other->body.size(), spec.body.size());
      EXPECT_EQ(other->wall.up, spec.wall.up);
      for (std::size_t i = 0; i < spec.body.size(); ++i) {
        EXPECT_EQ(other->body[i].id, spec.body[i].id);
        EXPECT_EQ(other->body[i].fixed, spec.body[i].fixed);
        EXPECT_EQ(other->body[i].material, spec.body[i].material);
        ASSERT_EQ(other->body[i].part.size(), spec.body[i].part.size());
        for (std::size_t p = 0; p < spec.body[i].part.size(); ++p) {
          const Polyhedron &a = spec.body[i].part[p], &b = other->body[i].part[p];
          EXPECT_EQ(a.face, b.face);
          ASSERT_EQ(a.vertex.size(), b.vertex.size());
          for (std::size_t k = 0; k < a.vertex.size(); ++k)
            EXPECT_TRUE(a.vertex[k].x == b.vertex[k].x && a.vertex[k].y == b.vertex[k].y &&
                        a.vertex[k].z == b.vertex[k].z);
        }
      }
    }
  }
}

// --- COMPAS's traps

std::string compas_box(const std::string& more) {
  nlohmann::json mesh = {{"vertex", nlohmann::json::object()}, {"face", nlohmann::json::object()}};
  const Polyhedron box = scenes::box_part({0, 0, 0}, {1, 1, 1});
  for (std::size_t i = 0; i < 8; ++i) {
    nlohmann::json corner = nlohmann::json::object();  // zeros are left out
    if (box.vertex[i].x != 0) corner["x"] = box.vertex[i].x;
    if (box.vertex[i].y != 0) corner["y"] = box.vertex[i].y;
    if (box.vertex[i].z != 0) corner["z"] = box.vertex[i].z;
    mesh["vertex"][std::to_string(100 + i)] = corner;
  }
  for (std::size_t f = 0; f < 6; ++f) {
    if (more == "halfedge") {
      for (std::size_t k = 0; k < 4; ++k)
        mesh["face"][std::to_string(f)][std::to_string(100 + box.face[f][k])] =
            100 + box.face[f][(k + 1) % 4];
      continue;
    }
    for (const std::int32_t i : box.face[f]) {
      const nlohmann::json key =
          more == "text" ? nlohmann::json(std::to_string(100 + i)) : nlohmann::json(100 + i);
      mesh["face"][std::to_string(f)].push_back(key);
    }
  }
  return mesh.dump();
}

std::vector<BodySpec> compas_in(const std::string& text, std::string* refused = nullptr) {
  FaultList faults;
  auto bodies = io::compas_bodies(nlohmann::json::parse(text), "f.json", faults);
  if (refused) *refused = said(faults);
  EXPECT_TRUE(refused != nullptr || faults.empty()) << said(faults);
  return bodies;
}

TEST(Compas, meshes_come_in_many_wrappers) {
  const std::string mesh = compas_box("text");
  const std::string whole = R"({"dtype": "compas.datastructures/Mesh", "data": )" + mesh + "}";
  for (const std::string& text :
       {whole, "[[" + whole + "]]", R"({"dtype": "Mesh", "value": {"data": )" + mesh + "}}",
        R"({"dtype": "compas.datastructures/Mesh", "data": )" + compas_box("halfedge") + "}",
        R"({"dtype": "A", "data": {"graph": {"node": {"7": {"block": )" + whole + "}}}}}",
        R"({"dtype": "A", "data": {"elements": [{"data": {"shape": )" + whole + "}}]}}"}) {
    const auto bodies = compas_in(text);
    ASSERT_EQ(bodies.size(), 1U) << text;
    EXPECT_NEAR(geometry::solid_moments(bodies[0]).volume, 1, 1e-15) << text;
  }
}

TEST(Compas, supports_stand_at_the_node_the_element_or_the_mesh) {
  const std::string mesh = compas_box("");
  const auto model = [&](const std::string& node, const std::string& element,
                         const std::string& attributes) {
    return R"({"dtype": "M", "data": {"graph": {"node": {"0": {)" + node +
           R"("block": {"data": {)" + element + R"("geometry": {"data": {"attributes": {)" +
           attributes + "}, " + mesh.substr(1) + "}}}}}}}}";
  };
  EXPECT_FALSE(compas_in(model("", "", ""))[0].fixed);
  EXPECT_TRUE(compas_in(model(R"("is_support": true, )", "", ""))[0].fixed);
  EXPECT_TRUE(compas_in(model("", R"("is_support": true, )", ""))[0].fixed);
  EXPECT_TRUE(compas_in(model("", "", R"("is_support": true)"))[0].fixed);
}

TEST(Compas, blocks_are_numbered_as_numbers_and_moved_as_they_are) {
  const std::string mesh = R"({"data": )" + compas_box("") + "}";
  const auto ten = compas_in(R"({"dtype": "A", "data": {"graph": {"node": {"10": {"block": )" +
                             mesh + R"(}, "9": {"block": )" + mesh + "}}}}}");
  ASSERT_EQ(ten.size(), 2U);
  EXPECT_EQ(ten[0].id, "9");
  const auto moved = compas_in(
      R"({"dtype": "A", "data": {"elements": [{"data": {"transformation": {"dtype": "compas.geometry/Translation",
       "data": {"matrix": [[1, 0, 0, 5], [0, 1, 0, 0], [0, 0, 1, 0], [0, 0, 0, 1]]}}, "geometry": )" +
      mesh + "}}]}}");
  EXPECT_NEAR(geometry::solid_moments(moved[0]).centroid.x, 5.5, 1e-12);
  std::string refused;
  (void)compas_in(
      R"({"dtype": "A", "data": {"elements": [{"data": {"features": [{}], "geometry": )" + mesh +
          "}}]}}",
      &refused);
  EXPECT_TRUE(has(refused, "features")) << refused;
}

// --- bad input

TEST_F(BodyFiles, a_file_without_a_unit_asks_for_it) {
  write(at("two.obj"), kTwoBoxes);
  std::filesystem::copy_file(data("cubes.json"), at("cubes.json"));
  for (const std::string file : {"two.obj", "cubes.json"}) {
    EXPECT_TRUE(has(refusal("blocks = \"" + file + "\""), "wall.blocks_unit: is missing")) << file;
    const std::string unknown = refusal("blocks = \"" + file + "\"\nblocks_unit = \"furlong\"");
    EXPECT_TRUE(has(unknown, "furlong") && has(unknown, "mm")) << unknown;
  }
}

TEST_F(BodyFiles, keys_that_have_no_meaning_or_find_nothing_are_named) {
  write(at("two.obj"), kTwoBoxes);
  const std::string obj = "blocks = \"two.obj\"\nblocks_unit = \"m\"\n";
  const std::string lost = refusal(obj + "supports = [\"lwo\"]");
  EXPECT_TRUE(has(lost, "wall.supports") && has(lost, "names no block") &&
              has(lost, "did you mean low?"))
      << lost;
  EXPECT_TRUE(has(refusal(obj + "up = \"x\""), "wall.up")) << refusal(obj + "up = \"x\"");
  write(at("flat.json"), R"({"units": "m", "blocks": [{"polygon": [[0, 0], [1, 0], [1, 1]]}]})");
  EXPECT_TRUE(has(refusal("blocks = \"flat.json\"\nsupports = [\"b1\"]\nthickness = \"1 m\""),
                  "lie in a plane"));
  write(at("far.obj"),
        "v 0 0 0\nv 1e9 0 0\nv 0 1 0\nv 0 0 1\nf 1 3 2\nf 1 2 4\nf 1 4 3\nf 2 3 4\n");
  EXPECT_TRUE(has(refusal("blocks = \"far.obj\"\nblocks_unit = \"m\""), "10 km"));
}

TEST_F(BodyFiles, faults_of_a_blocks_file_in_space_are_told_at_once) {
  write(at("b.json"), R"({"units": "m", "blocks": [
    {"id": "a", "vertices": [[0, 0, 0]], "faces": []},
    {"id": "b", "vertices": [[0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1]], "faces": [[0, 2, 1], [0, 1, 9], [0, 3, 2], [1, 2, 3]]},
    {"id": "c", "polygon": [[0, 0], [1, 0], [1, 1]], "z": [1, 0]},
    {"id": "d", "parts": []}, {"id": "e", "parts": [3]}, {"id": "f", "z": [0, 1], "beam": true},
    {"id": "g", "polygon": [[0, 0], [1, 0], [1, 1]]}]})");
  const std::string all = refusal("blocks = \"b.json\"");
  for (const char* part :
       {"blocks.a.vertices", "blocks.b.faces", "blocks.c.z", "blocks.d.parts", "blocks.e.parts",
        "blocks.f.beam", "blocks.f.polygon", "lies in the plane"})
    EXPECT_TRUE(has(all, part)) << part << " in " << all;
}

TEST(MeshFiles, faults_name_their_line) {
  const auto obj = [](const std::string& text) {
    FaultList faults;
    (void)io::parse_obj({text, "f.obj", "f"}, faults);
    return said(faults);
  };
  EXPECT_TRUE(has(obj("v 0 0 0\nv 1 x 0\n"), "f.obj:2"));
  EXPECT_TRUE(has(obj("v 0 0 nan\n"), "three finite numbers"));
  EXPECT_TRUE(has(obj("v 0 0 0\nf 1 2 3\n"), "no corner listed before"));
  EXPECT_TRUE(has(obj("v 0 0 0\nf 1 1 0\n"), "no corner listed before"));
  EXPECT_TRUE(has(obj("v 0 0 0\nf 1 1\n"), "three corners or more"));
  EXPECT_TRUE(has(obj("curv 0 1 2\n"), "curved surface"));
  const auto stl = [](const std::string& text) {
    FaultList faults;
    (void)io::parse_stl({text, "f.stl", "f"}, faults);
    return said(faults);
  };
  EXPECT_TRUE(has(stl("solid\nvertex 0 0\nendloop\n"), "f.stl:2"));
  EXPECT_TRUE(has(stl("solid\nvertex 0 0 0\nendloop\n"), "a facet has three corners"));
  EXPECT_TRUE(has(stl("nothing of the kind"), "is no STL file"));
  const auto ply_of = [](const std::string& text) {
    FaultList faults;
    (void)io::parse_ply({text, "f.ply", "f"}, faults);
    return said(faults);
  };
  EXPECT_TRUE(has(ply_of("plx\n"), "is no PLY file"));
  EXPECT_TRUE(
      has(ply_of("ply\nformat ascii 1.0\nelement vertex 99999999999\n"), "count of elements"));
  EXPECT_TRUE(has(ply_of("ply\nformat ascii 1.0\nend_header\n"), "has no face"));
  EXPECT_TRUE(
      has(ply_of("ply\nformat ascii 1.0\nelement vertex 9\nproperty float x\nend_header\n1 2\n"),
          "ends before"));
}

TEST_F(BodyFiles, a_file_too_large_or_none_is_refused_before_it_is_read) {
  for (const std::string name : {"large.obj", "large.ply", "large.stl"}) {
    write(at(name), "");
    std::filesystem::resize_file(at(name), kMostMesh + 1);
    const std::string said = refusal("blocks = \"" + name + "\"\nblocks_unit = \"m\"");
    EXPECT_TRUE(has(said, "64 MB")) << said;
  }
  std::filesystem::create_directory(at("folder.stl"));
  EXPECT_TRUE(has(refusal("blocks = \"folder.stl\"\nblocks_unit = \"m\""), "folder"));
  EXPECT_TRUE(has(refusal("blocks = \"gone.stl\"\nblocks_unit = \"m\""), "gone.stl"));
}

// Damaged files give errors or bodies, never a crash; whatever is read is then assembled too.
TEST(MeshFiles, damaged_files_are_refused_or_read) {
  const std::vector<BodySpec> boxes = {scenes::box_body("a", {0, 0, 0}, {1, 1, 1}),
                                       scenes::box_body("b", {0, 0, 1}, {1, 1, 2})};
  const std::vector<std::pair<std::string, std::string>> sound = {
      {"obj", kTwoBoxes},
      {"stl", ascii_stl(boxes)},
      {"stl", binary_stl(boxes)},
      {"ply", ply(boxes, "ascii")},
      {"ply", ply(boxes, "binary_little_endian")},
      {"json", read_text(data("cubes.json"), 1'000'000)}};
  std::mt19937 dice(7);
  const auto roll = [&](std::size_t n) { return static_cast<std::size_t>(dice()) % n; };
  int refused = 0, read = 0;
  for (int round = 0; round < 3000; ++round) {
    auto [kind, text] = sound[roll(sound.size())];
    for (std::size_t hits = 1 + roll(3); hits > 0; --hits) {
      const std::size_t place = roll(text.size());
      switch (roll(4)) {
        case 0: text[place] = static_cast<char>(roll(256)); break;
        case 1: text.erase(place, 1 + roll(20)); break;
        case 2: text.insert(place, text.substr(roll(text.size()), roll(30))); break;
        default: text[place] = "0123456789-+.eE \n"[roll(17)]; break;
      }
      if (text.empty()) break;
    }
    FaultList faults;
    std::vector<BodySpec> bodies;
    try {
      const io::MeshText mesh{text, "f", "f"};
      if (kind == "obj") bodies = io::parse_obj(mesh, faults);
      if (kind == "stl") bodies = io::parse_stl(mesh, faults);
      if (kind == "ply") bodies = io::parse_ply(mesh, faults);
      if (kind == "json") {
        const auto json = nlohmann::json::parse(text, nullptr, false);
        if (!json.is_discarded()) bodies = io::compas_bodies(json, "f", faults);
      }
      if (faults.empty() && !bodies.empty()) (void)geometry::assemble(bodies, faults);
    } catch (const InputError&) {
      ++refused;
      continue;
    }
    ++(faults.empty() ? read : refused);
  }
  EXPECT_GT(refused, 300);
  EXPECT_GT(read, 100);
}

}  // namespace
}  // namespace wythe::mesh_files_test
