// Blocks files, laws, paths and responses: valid input, and for
// each bad input the place, the value and the cure in its message.
#include <gtest/gtest.h>

#include <array>
#include <fstream>
#include <string>

#include "io/text/table.h"
#include "unit/io_helpers.h"
#include "wythe/parts/error.h"
#include "wythe/parts/io.h"

namespace wythe::io_files_test {
namespace {

using namespace io_tests;

// --- blocks --------------------------------------------------------------------------------------

ModelSpec model_with_blocks(const Folder& folder, const std::string& json,
                            const std::string& wall = "") {
  folder.write("stones.json", json);
  const std::string tail = kModel.substr(kModel.find("[material.joint]"));
  return read_model(folder.write("model.toml", "[wall]\nblocks = \"stones.json\"\n" + wall + tail));
}

std::string blocks_fault(const std::string& json) {
  const Folder folder;
  try {
    (void)model_with_blocks(folder, json);
  } catch (const InputError& error) {
    const std::string what = error.what();
    return what.substr(what.rfind("stones.json"));
  }
  return "";
}

TEST(Blocks, polygons_in_millimetres) {
  const Folder folder;
  const ModelSpec spec = model_with_blocks(folder, R"({"units": "mm", "thickness": 200, "blocks": [
    {"id": "b1", "polygon": [[0, 0], [310, 0], [0, 110]], "material": "stone", "fixed": true}]})");
  ASSERT_EQ(spec.block.size(), 1U);
  EXPECT_EQ(spec.block[0].id, "b1");
  EXPECT_EQ(spec.block[0].polygon.at(1), (std::array<double, 2>{0.31, 0}));
  EXPECT_EQ(spec.block[0].material, "stone");
  EXPECT_TRUE(spec.block[0].fixed);
  EXPECT_EQ(spec.wall.thickness, 0.2);
}

TEST(Blocks, boxes_with_a_loading_beam) {
  const Folder folder;
  const ModelSpec spec = model_with_blocks(
      folder,
      R"({"units": "m", "thickness": 0.2, "blocks_xyxy": [[0, 0, 0.2, 0.1]], "loading_beam_xyxy": [0, 0.1, 0.2, 0.2]})",
      "thickness = \"0.5 m\"\n");
  ASSERT_EQ(spec.block.size(), 2U);
  EXPECT_EQ(spec.block[0].polygon.at(2), (std::array<double, 2>{0.2, 0.1}));
  EXPECT_EQ(spec.block[1].id, "beam");
  EXPECT_EQ(spec.block[1].material, "beam");
  EXPECT_TRUE(spec.block[1].beam);
  EXPECT_EQ(spec.wall.thickness, 0.5) << "the model file's own thickness stands";
}

TEST(BlocksRefused, missing_file_at_its_key) {
  const std::string fault =
      faults_of("[wall]\nblocks = \"none.json\"\n" + kModel.substr(kModel.find("[material.joint]")))
          .at(0);
  EXPECT_TRUE(fault.starts_with("model.toml:2: wall.blocks = none.json: can't read none.json"))
      << fault;
}

TEST(BlocksRefused, text_that_is_not_json) {
  EXPECT_EQ(
      blocks_fault("{\"units\": \"m\",\n \"blocks\": [NaN]}"),
      "stones.json:2: wall.blocks: not valid JSON at byte 28; correct it there, or write the file "
      "again");
}

TEST(BlocksRefused, missing_units_and_missing_blocks) {
  EXPECT_EQ(
      blocks_fault(R"({"blocks_xyxy": [[0, 0, 1, 1]]})"),
      "stones.json: wall.blocks.units: is missing; write \"units\": \"m\" or \"units\": \"mm\"");
  EXPECT_TRUE(
      blocks_fault(R"({"units": "m"})")
          .starts_with("stones.json: wall.blocks: has neither \"blocks\" nor \"blocks_xyxy\"; "));
}

TEST(BlocksRefused, two_vertices) {
  EXPECT_EQ(
      blocks_fault(R"({"units": "m", "blocks": [{"id": "b7", "polygon": [[0, 0], [1, 0]]}]})"),
      "stones.json: wall.blocks.b7.polygon = [[0,0],[1,0]]: must have 3 vertices or more");
}

TEST(BlocksRefused, vertex_that_is_no_pair_of_numbers) {
  EXPECT_EQ(
      blocks_fault(
          R"({"units": "m", "blocks": [{"id": "b7", "polygon": [[0, 0], [1, 0], [1, null]]}]})"),
      "stones.json: wall.blocks.b7.polygon = [1,null]: must be two finite numbers [x, y] within 10 "
      "km");
}

TEST(BlocksRefused, unknown_key_and_repeated_id) {
  EXPECT_EQ(
      blocks_fault(
          R"({"units": "m", "blocks": [{"poligon": [], "polygon": [[0, 0], [1, 0], [1, 1]]}]})"),
      "stones.json: wall.blocks.b1.poligon = []: no such key; did you mean polygon?");
  EXPECT_EQ(
      blocks_fault(R"({"units": "m", "blocks": [{"id": "a", "polygon": [[0, 0], [1, 0], [1, 1]]},
                                                      {"id": "a", "polygon": [[0, 0], [1, 0], [1, 1]]}]})"),
      "stones.json: wall.blocks.a = a: two blocks have this id; give each block an id of its own");
}

TEST(BlocksRefused, box_upside_down) {
  EXPECT_EQ(blocks_fault(R"({"units": "m", "blocks_xyxy": [[0, 1, 1, 0]]})"),
            "stones.json: wall.blocks.b1 = [0,1,1,0]: must be four finite numbers x0 < x1, y0 < y1 "
            "within 10 km; "
            "write them as [x0, y0, x1, y1]");
}

// --- contact files -------------------------------------------------------------------------------

const std::string kLaw = kModel.substr(kModel.find("[material.joint]"),
                                       kModel.find("[[stage]]") - kModel.find("[material.joint]"));

template <class Read>
std::string refusal(Read read) {
  try {
    read();
  } catch (const InputError& error) {
    const std::string what = error.what();
    return what.substr(what.find_last_of('/') + 1);
  }
  return "";
}

TEST(Law, is_the_joint_or_the_only_one) {
  const Folder folder;
  EXPECT_EQ(read_law(folder.write("law.toml", kLaw)).cohesion, 0.15e6);
  EXPECT_EQ(read_law(folder.write("law.toml", with(kLaw, "joint", "bed"))).cohesion, 0.15e6);
  EXPECT_EQ(read_law(folder.write("law.toml", kModel)).cohesion, 0.15e6);
  const std::string two =
      with(kLaw, "joint", "bed") + with(kLaw.substr(0, kLaw.find("[material.t")), "0.15", "0.3");
  EXPECT_EQ(read_law(folder.write("law.toml", two)).tensile_strength, 0.3e6);
}

TEST(LawRefused, none_and_several) {
  const Folder folder;
  const std::string body =
      folder.write("law.toml", "[material.timber]\ndensity = \"600 kg/m^3\"\n");
  EXPECT_EQ(
      refusal([&] { (void)read_law(body); }),
      "law.toml: material: is missing, the file has no joint law; write [material.joint] and its "
      "keys under it");
  const std::string one = kLaw.substr(0, kLaw.find("[material.timber]"));
  const std::string two =
      folder.write("law.toml", with(one, "joint", "a") + with(one, "joint", "b"));
  EXPECT_EQ(
      refusal([&] { (void)read_law(two); }),
      "law.toml: material = a, b: several laws, and none is called joint; leave one, or call the "
      "one meant [material.joint]");
}

TEST(Path, columns_in_any_order_and_more_of_them) {
  const Folder folder;
  const auto rows = read_contact_path(folder.write(
      "p.csv", "\xEF\xBB\xBFtime, slip_mm ,opening_mm\r\n0,1,-0.5\r\n\r\n1,+2,1e-3\r\n"));
  ASSERT_EQ(rows.size(), 2U);
  EXPECT_EQ(rows[0].slip, 0.001);
  EXPECT_EQ(rows[0].opening, -0.0005);
  EXPECT_EQ(rows[1].opening, 1e-6);
}

std::string path_fault(const std::string& text) {
  const Folder folder;
  const std::string path = folder.write("p.csv", text);
  return refusal([&] { (void)read_contact_path(path); });
}

TEST(Path, is_read_as_spreadsheets_write_it) {
  for (const char* text :
       {"opening_mm;slip_mm\n0,5;2,5\n", "\"opening [mm]\";\"slip [mm]\"\n0,5;2,5\n",
        "n\topening (mm)\tslip (mm)\n1\t0.5\t2.5\n", "slip_cm opening_mm\n0.25 0.5\n",
        "opening_m,slip_m\n0.0005,0.0025\n"}) {
    const Folder folder;
    const std::vector<ContactPathRow> rows = read_contact_path(folder.write("p.csv", text));
    ASSERT_EQ(rows.size(), 1U) << text;
    EXPECT_DOUBLE_EQ(rows[0].opening, 0.0005) << text;
    EXPECT_DOUBLE_EQ(rows[0].slip, 0.0025) << text;
  }
}

TEST(PathRefused, factor_in_the_head) {
  for (const char* head : {"opening [mm],slip [mm] x 10", "opening (mm) *100,slip (mm)"}) {
    const std::string fault = path_fault(std::string(head) + "\n0,0\n");
    EXPECT_NE(fault.find("may not be the value itself"), std::string::npos) << fault;
  }
}

TEST(Heads, of_what_changes_the_numbers_and_of_what_does_not) {
  for (const char* head :
       {"ft x100 [MPa]", "100*ft (MPa)", "ft/10 [MPa]", "CoV of ft [MPa]", "log10(ft) [Pa]",
        "std ft [MPa]", "ft (MPa) st.dev.", "standard deviation of ft [MPa]"})
    EXPECT_NE(io::factor_in_head(head), "") << head;
  for (const char* head : {"ft [MPa]", "cov", "cov_ft", "rho_kN/m3", "kn [N/mm**3]",
                           "ft 28 days [MPa]", "Gf_N/m", "max ft [MPa]"})
    EXPECT_EQ(io::factor_in_head(head), "") << head;
}

TEST(PathRefused, thousands_or_decimals) {
  for (const char* rows : {"0;0\n0;900\n0;1.050\n", "0;0\n1,200;4\n", "0;950\n-1.000;980\n"}) {
    const std::string fault = path_fault(std::string("opening_mm;slip_mm\n") + rows);
    EXPECT_NE(fault.find("three decimals or marks of thousands"), std::string::npos) << fault;
  }
  EXPECT_EQ(path_fault("opening_mm;slip_mm\n0;0.000\n0;1.050\n"), "");
  EXPECT_EQ(path_fault("opening_mm;slip_mm\n0;0\n0.5;1.050\n"), "");
}

TEST(PathRefused, missing_column) {
  EXPECT_EQ(path_fault("opening_mm,slip\n0,0\n"),
            "p.csv:1: slip_mm: no such column in the header; the columns are opening_mm, slip; "
            "opening_mm and slip_mm are needed");
}

TEST(PathRefused, bad_numbers_all_at_once) {
  const std::string fault = path_fault("opening_mm,slip_mm\n0,0\nx,0\n0,nan\n");
  EXPECT_EQ(fault,
            "p.csv:4: slip_mm = nan: must be a finite number; write it as 0.05 or 1.5e-3, without "
            "a unit or marks of thousands");
  const Folder folder;
  const std::string path = folder.write("p.csv", "opening_mm,slip_mm\nx,0\n0,y\n");
  try {
    (void)read_contact_path(path);
    FAIL();
  } catch (const InputError& error) {
    ASSERT_EQ(error.faults().size(), 2U);
    EXPECT_EQ(error.faults()[0].line, 2);
    EXPECT_EQ(error.faults()[0].path, "opening_mm");
    EXPECT_EQ(error.faults()[0].value, "x");
  }
}

TEST(PathRefused, row_of_another_width_and_no_rows) {
  EXPECT_EQ(
      path_fault("opening_mm,slip_mm\n0,0,0\n"),
      "p.csv:2: 0,0,0: has 3 cells, the head has 2; separate cells by commas and decimals by a "
      "point, or cells by semicolons and decimals by a comma");
  EXPECT_EQ(path_fault(""),
            "p.csv: is empty; write a header opening_mm,slip_mm and one row for each "
            "point of the path");
  EXPECT_EQ(path_fault("opening_mm,slip_mm\n"),
            "p.csv: has no rows; write a header opening_mm,slip_mm and one row for each point of "
            "the path");
}

TEST(Answer, has_the_agreed_columns_and_shortest_numbers) {
  const Folder folder;
  const std::string path = folder.write("f.csv", "");
  const ContactAnswer answer{.normal_stress = 0.15e6,
                             .shear_stress = -2e5,
                             .damage_tension = 0.25,
                             .damage_shear = 0.5,
                             .damage = 0.625,
                             .crushing = 0,
                             .dissipated = 4.3};
  write_contact_answer(path, {{.opening = 0.0003, .slip = -0.002}}, {answer});
  std::ifstream in(path);
  const std::string text{std::istreambuf_iterator<char>(in), {}};
  EXPECT_EQ(text,
            "opening_mm,slip_mm,normal_stress_MPa,shear_stress_MPa,damage_tension,damage_shear,"
            "damage,crushing,dissipated_N_per_m\n"
            "0.3,-2,0.15,-0.2,0.25,0.5,0.625,0,4.3\n");
}

TEST(Answer, a_device_and_a_missing_folder_are_refused) {
  EXPECT_THROW(write_contact_answer("/dev/full", {{}}, {{}}), InputError);
  EXPECT_THROW(write_contact_answer("/nowhere/f.csv", {{}}, {{}}), IoError);
}

}  // namespace
}  // namespace wythe::io_files_test
