// A run inside the range of the tested walls has no note; each kind of excess has its own.
#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

#include "judge/modes/tested_range.h"
#include "scenes/mechanism.h"
#include "scenes/scenes.h"

namespace wythe::tested_range_test {
namespace {

using study::TestedKind;

constexpr int kColumns = 8, kCourses = 16;  // 1.24 m x 1.76 m
constexpr double kPressure = 0.4e6;         // 10 % of the strength of the joints

constexpr TestedKind kTests[] = {{"shear", 5, 1.05, 0.95, 1.12, 0.1, 1.0, 2.0, 0.03, 0.2},
                                 {"sliding", 1, 0.9, kUnset, kUnset, kUnset, 1.0, 2.0, 0.03, 0.2},
                                 {"rocking", 6, 1.3, 1.1, 1.5, 0.1, 1.0, 2.0, 0.03, 0.2}};

ModelSpec wall_spec() {
  ModelSpec spec = scenes::plain_wall(kColumns, kCourses, 1e-3, 0.01);
  spec.solve.point_rule = PointRule::kLobatto;
  spec.solve.points_per_face = 3;
  spec.material["joint"].compressive_strength = 4e6;
  return spec;
}

// A run of that wall that failed so, pressed on the ground by so much before its push.
Result run_of(const Model& model, const std::string& mode, double pressure = kPressure) {
  Result result;
  result.responses.peak_reaction = 1e4;
  result.failure_mode.name = mode;
  const double kn = model.materials[model.joint_material[0]].normal_stiffness;
  result.states.snapshots.push_back({"start", 0, 0, scenes::moved(model, [=](double, double) {
                                       return scenes::Motion{.move_y = -pressure / kn};
                                     })});
  return result;
}

std::vector<std::string> codes_of(const Model& model, const Result& result) {
  std::vector<std::string> codes;
  for (const Message& m : study::compare_with(kTests, model, result).notes) codes.push_back(m.code);
  return codes;
}
using Codes = std::vector<std::string>;

TEST(TestedRange, InsideItNothingIsSaid) {
  const Model model = compile(wall_spec());
  EXPECT_EQ(codes_of(model, run_of(model, "shear + rocking")), Codes{});
  const TestedRange range = study::compare_with(kTests, model, run_of(model, "shear"));
  EXPECT_EQ(range.kind, "shear");
  EXPECT_EQ(range.walls, 5);
  EXPECT_DOUBLE_EQ(range.bias, 1.05);
}

TEST(TestedRange, AKindWithABiasSaysIt) {
  const Model model = compile(wall_spec());
  EXPECT_EQ(codes_of(model, run_of(model, "rocking + toe crushing")), Codes{"range.bias"});
}

TEST(TestedRange, AKindOfFewWallsIsNotVouchedFor) {
  const Model model = compile(wall_spec());
  EXPECT_EQ(codes_of(model, run_of(model, "sliding at the base")), Codes{"range.few"});
}

TEST(TestedRange, AFailureOfNoTestedKindSaysSo) {
  const Model model = compile(wall_spec());
  EXPECT_EQ(codes_of(model, run_of(model, "unclear")), Codes{"range.no_kind"});
}

// validation/drift_constants.csv: brick in shear 0.28 %, mixed 0.71, stone rocking 1.74
TEST(TestedDrift, is_that_of_the_kind_and_masonry) {
  const Model brick = compile(wall_spec());
  ModelSpec spec = wall_spec();
  spec.wall.unit.split = Split::kNone;
  const Model whole = compile(spec);  // bricks or stones: nobody knows
  for (auto& [name, material] : spec.material)
    material.tensile_strength = material.cohesion = material.residual_cohesion = 0;
  const Model stone = compile(spec);
  const auto drift = [](const Model& model, const char* mode) {
    return study::compare_with(kTests, model, run_of(model, mode)).drift;
  };
  EXPECT_DOUBLE_EQ(drift(brick, "shear").median, 0.00277);
  EXPECT_DOUBLE_EQ(drift(brick, "shear + rocking").median, 0.00711);
  EXPECT_DOUBLE_EQ(drift(stone, "rocking").median, 0.0174);
  EXPECT_TRUE(drift(stone, "rocking").stone);
  EXPECT_EQ(drift(whole, "shear").walls, 0);
  EXPECT_EQ(drift(brick, "sliding at the top").walls, 0);
  EXPECT_EQ(drift(brick, "unclear").walls, 0);
}

TEST(TestedDrift, is_told_with_its_range_and_nothing_where_none_is_known) {
  const Model brick = compile(wall_spec());
  const auto note = [&](const char* mode) {
    return text_of(drift_note_of(study::compare_with(kTests, brick, run_of(brick, mode))));
  };
  EXPECT_NE(note("shear").find("up to a drift of 0.28 % (nine of ten of 79 walls: 0.18 to 0.61 %)"),
            std::string::npos)
      << note("shear");
  EXPECT_NE(note("shear").find("do not rely on that of this run"), std::string::npos)
      << note("shear");
  EXPECT_EQ(note("sliding at the base"), "");
}

TEST(TestedRange, PressureBeyondTheTestsAndBelowThemIsNoted) {
  const Model model = compile(wall_spec());
  EXPECT_EQ(codes_of(model, run_of(model, "shear", 0.24 * 4e6)), Codes{});  // within a quarter
  EXPECT_EQ(codes_of(model, run_of(model, "shear", 0.26 * 4e6)), Codes{"range.axial"});
  EXPECT_EQ(codes_of(model, run_of(model, "shear", 0.02 * 4e6)), Codes{"range.axial"});
}

TEST(TestedRange, WallsMoreSlenderOrMoreSquatThanTheTestsAreNoted) {
  for (const int courses : {7, 40}) {  // height over length 0.62 and 3.5
    ModelSpec spec = wall_spec();
    spec.wall.height = courses * 0.11;
    spec.stage.clear();
    const Model model = compile(spec);
    EXPECT_EQ(codes_of(model, run_of(model, "shear")), Codes{"range.slenderness"}) << courses;
  }
}

TEST(TestedRange, ShearOfUnitsThatCannotCrackIsNotedAndRockingIsNot) {
  ModelSpec spec = wall_spec();
  spec.wall.unit.split = Split::kNone;
  const Model model = compile(spec);
  EXPECT_EQ(codes_of(model, run_of(model, "shear")), Codes{"range.no_planes"});
  EXPECT_EQ(codes_of(model, run_of(model, "rocking")), Codes{"range.bias"});
}

TEST(TestedRange, JointsThatAreTooStiffInRotationAreNoted) {
  ModelSpec spec = wall_spec();
  spec.solve.point_rule = PointRule::kCorners;
  spec.solve.points_per_face = 2;
  const Model corners = compile(spec);
  const TestedRange range = study::compare_with(kTests, corners, run_of(corners, "shear"));
  ASSERT_EQ(range.notes.size(), 1u);
  EXPECT_EQ(range.notes[0].code, "range.points");
  EXPECT_NEAR(range.notes[0].number("times"), 3, 1e-12);
  spec.solve.point_rule = PointRule::kGauss;
  const Model gauss = compile(spec);
  EXPECT_EQ(codes_of(gauss, run_of(gauss, "shear")), Codes{});
}

TEST(TestedRange, WallsWithOpeningsAreOutsideWhateverTheirName) {
  ModelSpec spec = scenes::small_wall();
  const Model model = compile(spec);
  EXPECT_EQ(codes_of(model, run_of(model, "pier rocking")), Codes{"range.openings"});
  EXPECT_EQ(codes_of(model, run_of(model, "FM-4")), Codes{"range.openings"});
}

TEST(TestedRange, APushToAndFroIsNoted) {
  const Model model = compile(wall_spec());
  Result result = run_of(model, "shear");
  result.responses.cyclic.sense = 1;
  EXPECT_EQ(codes_of(model, result), Codes{"range.cyclic"});
}

TEST(TestedRange, WithoutAPeakOrAPushThereIsNothingToCompare) {
  const Model model = compile(wall_spec());
  Result result = run_of(model, "shear");
  result.responses.peak_reaction = kUnset;
  EXPECT_EQ(codes_of(model, result), Codes{});
  result = run_of(model, "shear");
  result.curve_of = StageKind::kBodyForce;
  EXPECT_EQ(codes_of(model, result), Codes{});
}

TEST(TestedRange, NamesOfFailuresHaveTheirKinds) {
  for (const auto& [name, kind] :
       std::vector<std::pair<std::string, std::string>>{{"shear + rocking", "shear"},
                                                        {"sliding at the base", "sliding"},
                                                        {"rocking + sliding", "sliding"},
                                                        {"toe crushing", "rocking"},
                                                        {"flexural cracks", "rocking"},
                                                        {"unclear", ""},
                                                        {"", ""}})
    EXPECT_EQ(kind_of_mode(name), kind) << name;
}

}  // namespace
}  // namespace wythe::tested_range_test
