// Meshes, drawings and records that could take hours or all memory: each is refused at once.
#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "core/files.h"
#include "core/limits.h"
#include "io/bodies/dxf.h"
#include "io/bodies/meshes.h"
#include "scenes/places.h"
#include "scenes/small_study.h"
#include "wythe/parts/io.h"
#include "wythe/parts/model.h"

namespace wythe::mesh_limits_test {
namespace {

std::string said(const FaultList& faults) {
  std::string all;
  for (const Fault& fault : faults.all()) all += to_string(fault) + "\n";
  return all;
}

std::string obj(const std::string& text) {
  FaultList faults;
  (void)io::parse_obj({text, "f.obj", "f"}, faults);
  return said(faults);
}

TEST(MeshLimits, faces_that_meet_at_one_edge_are_counted_before_they_are_followed) {
  std::string text = "v 0 0 0\nv 0 0 1\n";
  for (int i = 0; i < 20'000; ++i) text += "v 1 " + std::to_string(i) + " 0.5\n";
  for (int i = 0; i < 20'000; ++i)
    text += (i % 2 == 0 ? "f 1 2 " : "f 2 1 ") + std::to_string(i + 3) + "\n";
  EXPECT_NE(obj(text).find("has an edge at which 20000 faces meet"), std::string::npos);
}

TEST(MeshLimits, faces_without_any_edge_take_no_time) {
  std::string text = "v 0 0 0\nv 0 0 0\nv 0 0 0\n";
  for (int i = 0; i < 250'001; ++i) text += "f 1 2 3\n";
  EXPECT_NE(obj(text).find("has 250001 surfaces, more than 250000"), std::string::npos);
}

TEST(MeshLimits, groups_are_found_by_name_and_not_one_by_one) {
  std::string text;
  for (int i = 0; i < 300'000; ++i) text += "g part" + std::to_string(i) + "\n";
  EXPECT_EQ(obj(text), "");  // 4e10 comparisons else: minutes
}

TEST(MeshLimits, each_solid_of_an_stl_is_read_with_its_own_corners_alone) {
  std::string text;
  for (int i = 0; i < 20'000; ++i)
    text += "solid s" + std::to_string(i) +
            "\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 1 0\nendloop\nendsolid\n";
  FaultList faults;
  const auto bodies = io::parse_stl({text, "f.stl", "f"}, faults);
  EXPECT_EQ(bodies.size(), 20'000U);  // 1e9 corners sorted else
  EXPECT_EQ(bodies.back().part[0].vertex.size(), 3U);
}

// A prism of many sides; what follows looks at faces pair by pair.
TEST(MeshLimits, a_solid_of_very_many_faces_is_refused) {
  constexpr int kSides = 10'001;
  std::string text, low = "f", high = "f", sides;
  for (const char* z : {"0", "1"})
    for (int i = 0; i < kSides; ++i) {
      const double turn = 2 * M_PI * i / kSides;
      text += "v " + std::to_string(std::cos(turn)) + " " + std::to_string(std::sin(turn)) + " " +
              z + "\n";
    }
  for (int i = 0; i < kSides; ++i) {
    low += " " + std::to_string(kSides - i);
    high += " " + std::to_string(kSides + i + 1);
    const int a = i + 1, b = (i + 1) % kSides + 1;
    sides += "f " + std::to_string(a) + " " + std::to_string(b) + " " + std::to_string(kSides + b) +
             " " + std::to_string(kSides + a) + "\n";
  }
  const scenes::TemporaryFolder folder;
  write_text(folder / "round.obj", text + low + "\n" + high + "\n" + sides);
  try {
    (void)compile(parse_model(
        "[wall]\nblocks = \"round.obj\"\nblocks_unit = \"m\"\n[wall.unit]\ndensity = \"1800 "
        "kg/m^3\"\n"
        "[material.joint]\nnormal_stiffness = \"20 GPa/m\"\nshear_stiffness = \"8 GPa/m\"\n"
        "tensile_strength = \"0 MPa\"\ncohesion = \"0 MPa\"\nresidual_cohesion = \"0 MPa\"\n"
        "friction_angle = \"30 deg\"\nresidual_friction_angle = \"30 deg\"\n"
        "compressive_strength = \"unlimited\"\n[[stage]]\nname = \"gravity\"\n",
        folder / "m.toml"));
    FAIL();
  } catch (const InputError& error) {
    EXPECT_NE(std::string(error.what()).find("has more than 10000 corners or faces"),
              std::string::npos)
        << error.what();
  }
}

std::string drawing(const std::string& entities, const std::string& tail) {
  const scenes::TemporaryFolder folder;
  write_text(folder / "d.dxf",
             "0\nSECTION\n2\nHEADER\n9\n$INSUNITS\n70\n6\n0\nENDSEC\n0\nSECTION\n2\nENTITIES\n" +
                 entities + "0\nENDSEC\n0\nEOF\n" + tail);
  try {
    return std::to_string(io::parse_drawing(folder / "d.dxf", "").layers.size()) + " layers";
  } catch (const InputError& error) {
    return error.what();
  }
}

TEST(DrawingLimits, layers_and_blank_lines_at_the_end_take_no_time) {
  std::string text;
  for (int i = 0; i < 300'000; ++i) text += "0\nLINE\n8\nlayer " + std::to_string(i) + "\n";
  EXPECT_EQ(drawing(text, std::string(8'000'000, '\n')), "300000 layers");
}

TEST(DrawingLimits, of_entities_is_told) {
  std::string text;
  for (int i = 0; i < 1'000'001; ++i) text += "0\nLINE\n";
  EXPECT_NE(drawing(text, "").find("has more than 1000000 entities"), std::string::npos);
}

// All of an AT2 file may be one line: its faults are counted as they come.
TEST(RecordLimits, a_line_of_words_gives_no_more_faults_than_are_told) {
  std::string text = read_text(source_dir() + "/examples/shaken_parapet/model.toml", kMostToml);
  const std::string file = "\"record.csv\"";
  text.replace(text.find(file), file.size(), "\"record.at2\"");
  std::string record =
      "PEER\n1994\nACCELERATION TIME SERIES IN UNITS OF M/S/S\nNPTS= 4, DT= .01 SEC\n";
  for (int i = 0; i < 200'000; ++i) record += "x ";
  const scenes::TemporaryFolder folder;
  write_text(folder / "record.at2", record);
  try {
    (void)parse_model(text, folder / "m.toml");
    FAIL();
  } catch (const InputError& error) {
    EXPECT_GT(error.faults().size(), kMostFaults);
    EXPECT_LT(error.faults().size(), kMostFaults + 10);
  }
}

}  // namespace
}  // namespace wythe::mesh_limits_test
