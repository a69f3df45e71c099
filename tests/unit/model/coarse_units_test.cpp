// Notes for walls with units drawn larger than they were built: only claims that docs/evidence/block_size.md supports.
#include "model/coarse_units.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <sstream>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "core/files.h"
#include "scenes/places.h"
#include "scenes/scenes.h"
#include "wythe/parts/io.h"
#include "wythe/parts/model.h"

namespace wythe::coarse_units_test {
namespace {

struct Row {
  double force = kUnset, drift = kUnset;  // changes [%]
  int other = 0, walls = 0;               // pairs in which the failure got another name
};

// Rows of one option, a wall each. Cells: wall, F, CoV, change, D, CoV, change, modes, another mode, pairs.
std::vector<Row> rows_of(const std::string& page, const std::string& option) {
  std::vector<Row> rows;
  std::istringstream lines(page);
  for (std::string line; std::getline(lines, line);) {
    if (!line.starts_with("| " + option + " |")) continue;
    std::vector<std::string> cells;
    std::istringstream rest(line.substr(1));
    for (std::string cell; std::getline(rest, cell, '|');) cells.push_back(cell);
    const auto number = [&](std::size_t k) {
      try {
        return std::stod(cells.at(k));
      } catch (const std::invalid_argument&) {
        return kUnset;  // a dash
      }
    };
    rows.push_back(
        {number(3), number(6), static_cast<int>(number(8)), static_cast<int>(number(9))});
  }
  return rows;
}

TEST(CoarseUnits, are_worth_what_the_page_of_evidence_says) {
  const std::string page = read_text(source_dir() + "/docs/evidence/block_size.md", 1 << 20);
  for (const auto& [option, walls] :
       {std::pair("twice", kCoarseWalls[0]), std::pair("three times", kCoarseWalls[1])}) {
    SCOPED_TRACE(option);
    const std::vector<Row> rows = rows_of(page, option);
    ASSERT_EQ(rows.size(), 3U);
    double force_low = kUnset, force_high = kUnset, drift_low = kUnset, drift_high = kUnset;
    int other = 0, all = 0;
    for (const Row& row : rows) {
      force_low = std::fmin(force_low, row.force), force_high = std::fmax(force_high, row.force);
      drift_low = std::fmin(drift_low, row.drift), drift_high = std::fmax(drift_high, row.drift);
      other += row.other, all += row.walls;
    }
    EXPECT_NEAR(100 * walls.force_low, force_low, 1e-9);
    EXPECT_NEAR(100 * walls.force_high, force_high, 1e-9);
    EXPECT_NEAR(100 * walls.drift_low, drift_low, 1e-9);
    EXPECT_NEAR(100 * walls.drift_high, drift_high, 1e-9);
    EXPECT_EQ(walls.other, other);
    EXPECT_EQ(walls.walls, all);
  }
}

// 310 x 110 mm
ModelSpec wall_of(double real_length, double real_height) {
  ModelSpec spec = scenes::plain_wall(8, 8, 1e-3, 0.02);
  spec.wall.unit.real = {real_length * spec.wall.unit.length, real_height * spec.wall.unit.height};
  return spec;
}

TEST(CoarseUnits, say_nothing_where_they_are_as_built_or_nobody_knows) {
  EXPECT_TRUE(caution_of_units(scenes::plain_wall(8, 8, 1e-3, 0.02)).empty());
  EXPECT_TRUE(caution_of_units(wall_of(1, 1)).empty());
  EXPECT_TRUE(caution_of_units(wall_of(1.01, 0.99)).empty());  // fitted to the wall
}

TEST(CoarseUnits, are_compared_as_far_as_walls_were) {
  const auto code = [](const ModelSpec& spec) { return caution_of_units(spec).code; };
  EXPECT_EQ(code(wall_of(0.5, 0.5)), "assessment.caution.coarse");
  EXPECT_EQ(code(wall_of(1 / 3.0, 1 / 3.0)), "assessment.caution.coarse");
  const std::string beyond = "assessment.caution.coarse_untested";
  EXPECT_EQ(code(wall_of(0.25, 0.25)), beyond);
  EXPECT_EQ(code(wall_of(0.5, 1 / 3.0)), beyond);
  EXPECT_EQ(code(wall_of(0.5, kUnset)), beyond);
  ModelSpec stacked = wall_of(0.5, 0.5);
  stacked.wall.bond = Bond::kStack;
  EXPECT_EQ(code(stacked), beyond);
  // a storey that was not compared decides over one that was
  ModelSpec storeys = wall_of(0.5, 0.5);
  storeys.storey.resize(2);
  storeys.storey[1].unit.real.height = storeys.wall.unit.height / 4;
  EXPECT_EQ(code(storeys), beyond);
}

// Units drawn several as one without a word of it: no brick is so large.
TEST(CoarseUnits, are_doubted_where_no_unit_of_their_material_is_so_large) {
  const auto code = [](UnitType type, double length, double height, const char* scatter = "",
                       double density = 1800) {
    ModelSpec spec = scenes::plain_wall(8, 8, 1e-3, 0.02);
    spec.masonry.unit_type = type;
    spec.scatter.use = scatter;
    spec.wall.unit.length = length, spec.wall.unit.height = height;
    spec.wall.unit.density = density;
    return caution_of_units(spec).code;
  };
  const std::string larger = "assessment.caution.larger_than_made";
  EXPECT_EQ(code(UnitType::kClay, 0.5, 0.13), larger);
  EXPECT_EQ(code(UnitType::kClay, 0.5, 0.065), larger);
  EXPECT_EQ(code(UnitType::kClay, 0.25, 0.13), larger);
  EXPECT_EQ(code(UnitType::kClayPerforated, 1.0, 0.25), larger);
  EXPECT_EQ(code(UnitType::kUnstated, 0.5, 0.13, "clay_brick"), larger);
  // bricks and blocks that are made
  EXPECT_EQ(code(UnitType::kClay, 0.25, 0.065), "");
  EXPECT_EQ(code(UnitType::kClay, 0.25, 0.125), "");
  EXPECT_EQ(code(UnitType::kClayPerforated, 0.5, 0.25), "");
  EXPECT_EQ(code(UnitType::kUnstated, 0.31, 0.205, "clay_brick", 1200), "");
  for (const UnitType any : {UnitType::kTuff, UnitType::kStone, UnitType::kAeratedConcrete})
    EXPECT_EQ(code(any, 0.625, 0.5), "");
  EXPECT_EQ(code(UnitType::kUnstated, 0.5, 0.13), "");
  // walls in space with units of their own: those are looked at, not the wall's
  ModelSpec built = scenes::plain_wall(8, 8, 1e-3, 0.02);
  built.masonry.unit_type = UnitType::kClay;
  built.wall.unit.length = 0.25, built.wall.unit.height = 0.065;
  built.built_unit.assign(2, built.wall.unit);
  EXPECT_TRUE(caution_of_units(built).empty());
  built.built_unit[1].height = 0.13;
  EXPECT_EQ(caution_of_units(built).code, larger);
  // a stated size decides
  ModelSpec stated = wall_of(1, 1);
  stated.masonry.unit_type = UnitType::kClay;
  stated.wall.unit.length = stated.wall.unit.real.length = 0.5;
  stated.wall.unit.height = stated.wall.unit.real.height = 0.13;
  EXPECT_TRUE(caution_of_units(stated).empty());
  stated.wall.unit.real = {0.25, 0.065};
  EXPECT_EQ(caution_of_units(stated).code, "assessment.caution.coarse");
}

TEST(CoarseUnits, of_typical_values_are_of_their_material) {
  ModelSpec spec = scenes::plain_wall(8, 8, 1e-3, 0.02);
  spec.wall.unit.length = 0.5, spec.wall.unit.height = 0.13;
  spec.material.begin()->second.origin = {
      "mode_1_energy 18 N/m: typical of clay_brick_eindhoven (Lourenco and Rots 1997)"};
  EXPECT_EQ(caution_of_units(spec).code, "assessment.caution.larger_than_made");
  spec.material.begin()->second.origin = {"cohesion 0.2 MPa: typical of granite_dry (Oliveira)"};
  EXPECT_TRUE(caution_of_units(spec).empty());
}

TEST(CoarseUnits, of_a_model_are_in_its_notes) {
  const auto notes = [](const ModelSpec& spec) {
    const Model model = compile(spec);
    return std::count_if(model.anatomy.notes.begin(), model.anatomy.notes.end(),
                         [](const Message& note) { return note.code == "unit.coarse"; });
  };
  EXPECT_EQ(notes(wall_of(0.5, 0.5)), 1);
  EXPECT_EQ(notes(scenes::plain_wall(8, 8, 1e-3, 0.02)), 0);
}

// Each [[plan_wall]] may have units of its own.
TEST(CoarseUnits, of_each_wall_in_space_are_looked_at) {
  const auto said = [](const std::string& own) {
    const ModelSpec spec = parse_model(R"([wall]
height = "1.3 m"
thickness = "0.25 m"
[wall.unit]
length = "250 mm"
height = "65 mm"
density = "1800 kg/m^3"
[masonry]
use = "clay_brick_old"
vertical_stress = "0.1 MPa"
shear_modulus = "rule"
unit_youngs_modulus = "rule"
[material.joint]
missing = "rule"
[material.unit]
missing = "rule"
[[plan_wall]]
name = "front"
line = [["0 m", "0 m"], ["2 m", "0 m"]]
)" + own + R"(
[[stage]]
name = "gravity"
)",
                                       "wall.toml");
    return caution_of_units(spec).code;
  };
  EXPECT_EQ(said(""), "");
  EXPECT_EQ(said("unit.length = \"500 mm\"\nunit.height = \"130 mm\""),
            "assessment.caution.larger_than_made");
}

// The factor that capacity over demand goes by lies between that of the force and that of the displacement, for it is a
// mean of the two with weights 1 - T/TC and T/TC (docs/theory/assessment.md, "Units drawn larger").
TEST(CoarseUnits, move_capacity_over_demand_between_force_and_displacement) {
  const Message said = caution_of_units(wall_of(0.5, 0.5));
  EXPECT_NEAR(said.number("low_percent"), 100 * kCoarseWalls[0].force_low, 1e-9);
  EXPECT_NEAR(said.number("high_percent"), 100 * kCoarseWalls[0].drift_high, 1e-9);
}

}  // namespace
}  // namespace wythe::coarse_units_test
