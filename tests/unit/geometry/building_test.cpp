// Claims about a building's masonry: bare units and their mortar, storeys,
// joints of their own, regions, and messages about masonry that cannot be built.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <map>
#include <set>

#include "geometry/assembly.h"
#include "geometry/polygon.h"
#include "io/keys/model_key.h"
#include "scenes/places.h"
#include "scenes/scenes.h"
#include "wythe/parts/io.h"
#include "wythe/parts/model.h"
#include "wythe/parts/solve.h"

namespace wythe::geometry::building_test {
namespace {

const std::string kFacade = source_dir() + "/tests/data/two_storeys.toml";

// 2 m x 1 m of units 200 x 100 mm in `storeys` equal storeys; none: a plain wall.
ModelSpec building(int storeys) {
  ModelSpec spec;
  spec.wall.length = 2;
  spec.wall.thickness = 0.3;
  spec.wall.unit.length = 0.2;
  spec.wall.unit.height = 0.1;
  spec.wall.unit.density = 1800;
  static const char* const kNames[] = {"ground", "first", "second"};
  for (int i = 0; i < storeys; ++i) {
    StoreySpec storey;
    storey.name = kNames[i];
    storey.height = 1.0 / storeys;
    spec.storey.push_back(storey);
  }
  if (storeys == 0) spec.wall.height = 1;
  for (const char* name : {"joint", "unit", "foundation", "weak", "dry", "new", "stone"})
    spec.material[name] = {};
  spec.material["stone"].density = 2400;
  return spec;
}

ModelSpec bare_units(double length, double height) {
  ModelSpec spec = building(0);
  spec.wall.length = length;
  spec.wall.height = height;
  spec.wall.unit.length = 0.25;
  spec.wall.unit.height = 0.055;
  spec.wall.unit.mortar = {0.010, 0.010};
  return spec;
}

RegionSpec box_region(double x, double y, double width, double height) {
  RegionSpec region;
  region.place.x = x, region.place.y = y;
  region.place.width = width, region.place.height = height;
  region.joints.joint = "new";
  return region;
}

OpeningSpec hole(const std::string& storey, double x, double y, double width, double height) {
  OpeningSpec opening;
  opening.storey = storey;
  opening.x = x, opening.y = y, opening.width = width, opening.height = height;
  return opening;
}

Assembly build(const ModelSpec& spec) {
  FaultList faults;
  Assembly wall = build_assembly(spec, faults);
  for (const Fault& f : faults.all()) ADD_FAILURE() << f.path << ": " << f.problem;
  return wall;
}

std::vector<Fault> faults_of(const ModelSpec& spec) {
  FaultList faults;
  (void)build_assembly(spec, faults);
  return faults.all();
}

// "path: problem; cure" of the one fault.
std::string refusal(const ModelSpec& spec) {
  const std::vector<Fault> faults = faults_of(spec);
  EXPECT_EQ(faults.size(), 1U);
  return faults.empty() ? "" : faults[0].path + ": " + faults[0].problem + "; " + faults[0].cure;
}

void expect_says(const std::string& text, const std::vector<std::string>& words) {
  for (const std::string& word : words)
    EXPECT_NE(text.find(word), std::string::npos) << word << " in: " << text;
}

bool notes_say(const Assembly& wall, const std::string& word) {
  return std::any_of(wall.report.notes.begin(), wall.report.notes.end(),
                     [&](const Message& n) { return text_of(n).find(word) != std::string::npos; });
}

Vec2 middle(const Face& face) { return {(face.p0.x + face.p1.x) / 2, (face.p0.y + face.p1.y) / 2}; }

std::map<std::string, int> materials_of(const Assembly& wall, FaceKind kind) {
  std::map<std::string, int> count;
  for (const Face& face : wall.faces) count[face.material] += face.kind == kind;
  std::erase_if(count, [](const auto& entry) { return entry.second == 0; });
  return count;
}

double area_of(const Assembly& wall) {
  double area = 0;
  for (const Block& block : wall.blocks) area += moments(block.outline).area;
  return area;
}

// Length of the bed joints at one height.
double bed_length(const Assembly& wall, double y) {
  double sum = 0;
  for (const Face& face : wall.faces)
    if (face.kind == FaceKind::kBed && std::abs(middle(face).y - y) < 1e-9)
      sum += length(face.p1 - face.p0);
  return sum;
}

using Names = std::map<std::string, int>;

// --- mortar ----------------------------------------------------------------------------------------------

TEST(Mortar, is_added_to_bare_units) {
  const Assembly wall = build(bare_units(2.60, 0.65));
  EXPECT_NEAR(wall.report.half_unit, 0.13, 1e-12);
  EXPECT_NEAR(wall.report.course, 0.065, 1e-12);
  EXPECT_EQ(wall.blocks.size(), 20U * 10U);
  EXPECT_TRUE(wall.report.notes.empty()) << text_of(wall.report.notes[0]);
}

TEST(Mortar, a_wall_that_ends_without_a_joint_holds_its_units_and_says_who_gave_the_joint) {
  const Assembly wall = build(bare_units(2.59, 0.64));
  EXPECT_EQ(wall.blocks.size(), 20U * 10U);
  EXPECT_EQ(wall.report.courses, 10);
  EXPECT_NEAR(wall.report.half_unit, 2.59 / 20, 1e-15);
  EXPECT_NEAR(area_of(wall), 2.59 * 0.64, 1e-12);
  EXPECT_TRUE(notes_say(wall, "20 x half unit 130 mm end without a last joint of 10 mm"));
  EXPECT_TRUE(notes_say(wall, "10 x course 65 mm end without a last joint of 10 mm"));
}

TEST(Mortar, a_pillar_of_one_unit_is_one_unit_wide) {
  // 250 mm against 260 mm nominal are 4 %, more than a size may change without its joint
  const Assembly pillar = build(bare_units(0.25, 0.64));
  EXPECT_EQ(pillar.blocks.size(), 10U * 2U);
  expect_says(refusal(bare_units(0.24, 0.64)), {"wall.unit.length", "length = \"230 mm\""});
}

TEST(Mortar, jambs_at_the_ends_of_units_are_joint_lines) {
  ModelSpec spec = bare_units(5.19, 1.29);
  // left jamb at the end of unit 5, right jamb at the start of unit 10; sill and head on course 4, 14
  spec.wall.opening = {hole("", 5 * 0.26 - 0.01, 4 * 0.065 - 0.01, 5 * 0.26 + 0.01, 0.65 + 0.01)};
  const Assembly wall = build(spec);
  EXPECT_EQ(wall.piers.size(), 2U);
  EXPECT_NEAR(wall.piers[0].x1, 10 * 5.19 / 40, 1e-12);
  EXPECT_NEAR(wall.piers[1].x0, 20 * 5.19 / 40, 1e-12);
}

TEST(Mortar, of_one_side_is_that_of_both_and_may_be_nothing) {
  ModelSpec spec = bare_units(2.60, 0.65);
  spec.wall.unit.mortar = {0.010, kUnset};
  EXPECT_NEAR(build(spec).report.half_unit, 0.13, 1e-12);
  spec.wall.length = 2.5;
  spec.wall.unit.mortar = {0.010, 0};
  EXPECT_NEAR(build(spec).report.half_unit, 0.125, 1e-12);
}

TEST(Mortar, thicker_than_its_unit_is_refused_and_would_else_fit_any_wall) {
  ModelSpec spec = bare_units(2.60, 0.65);
  spec.wall.unit.mortar.bed = 10;  // "10 m" for "10 mm"
  expect_says(refusal(spec), {"wall.unit.mortar.bed", "thicker than the unit is high (55 mm)"});
  spec.wall.unit.mortar = {0.010, 0.13};
  expect_says(refusal(spec), {"wall.unit.mortar.head", "half long"});
}

TEST(Mortar, a_size_off_by_more_than_joint_and_tolerance_is_refused_with_bare_sizes) {
  const std::string said = refusal(bare_units(0.40, 0.65));
  expect_says(said, {"wall.unit.length", "holds 3.077 half units", "length = \"256.667 mm\"",
                     "wall.fit = \"cut\""});
}

// --- units drawn larger than they were built -----------------------------------------------------------------

TEST(RealUnits, go_a_whole_number_of_times_into_the_drawn_ones) {
  ModelSpec spec = building(0);  // 200 x 100 mm
  spec.wall.unit.real = {0.1, 0.05};
  EXPECT_EQ(build(spec).blocks.size(), build(building(0)).blocks.size());
  spec.wall.unit.real = {0.102, kUnset};  // within what fit = "whole" may change
  EXPECT_EQ(build(spec).blocks.size(), build(building(0)).blocks.size());
  spec.wall.unit.real = {0.12, kUnset};
  expect_says(refusal(spec), {"wall.unit.real.length", "is 0.6 of the drawn unit (200 mm)",
                              "unit.length = \"240 mm\", or real.length = \"100 mm\""});
  spec.wall.unit.real = {kUnset, 0.15};
  expect_says(refusal(spec), {"wall.unit.real.height", "is larger than the drawn unit (100 mm)"});
  spec.wall.unit.real = {0, kUnset};
  expect_says(refusal(spec), {"wall.unit.real.length", "must be positive"});
}

TEST(RealUnits, are_bare_where_mortar_is_stated) {
  ModelSpec spec = bare_units(2.60, 1.30);
  spec.wall.unit.length = 0.51, spec.wall.unit.height = 0.12;  // with joints twice 250 x 55
  spec.wall.unit.real = {0.25, 0.055};
  EXPECT_FALSE(build(spec).blocks.empty());
  spec.wall.unit.real = {0.255,
                         0.06};  // half the bare size, and no half with its joint: 1.96 and 1.86
  expect_says(refusal(spec), {"wall.unit.real.height", "is 0.54 of the drawn unit (120 mm)",
                              "real.height = \"55 mm\""});
}

TEST(RealUnits, of_a_storey_are_its_own) {
  ModelSpec spec = building(2);
  spec.storey[1].unit.real.height = 0.04;
  expect_says(refusal(spec), {"storey.1.unit.real.height"});
}

// --- storeys ---------------------------------------------------------------------------------------------

TEST(Storeys, of_one_unit_are_the_wall_of_their_sum) {
  const Assembly plain = build(building(0)), two = build(building(2));
  ASSERT_EQ(two.blocks.size(), plain.blocks.size());
  for (std::size_t b = 0; b < plain.blocks.size(); ++b) {
    EXPECT_EQ(two.blocks[b].id, plain.blocks[b].id);
    EXPECT_EQ(two.blocks[b].unit, plain.blocks[b].unit);
    for (std::size_t v = 0; v < 4; ++v) {
      EXPECT_NEAR(two.blocks[b].outline[v].x, plain.blocks[b].outline[v].x, 1e-15);
      EXPECT_NEAR(two.blocks[b].outline[v].y, plain.blocks[b].outline[v].y, 1e-15);
    }
  }
  EXPECT_EQ(two.faces.size(), plain.faces.size());
  ASSERT_EQ(two.storeys.size(), 2U);
  EXPECT_EQ(two.storeys[1].first_course, 5);
  EXPECT_EQ(two.storeys[1].foot, two.storeys[0].top);
}

TEST(Storeys, each_have_a_lattice_of_their_own_and_touch_along_the_whole_floor_line) {
  ModelSpec spec = building(2);
  spec.storey[0].height = 0.52;
  spec.storey[0].unit.length = 0.25;
  spec.storey[0].unit.height = 0.13;
  spec.storey[1].height = 0.48;
  spec.storey[1].unit.height = 0.06;
  const Assembly wall = build(spec);
  EXPECT_EQ(wall.report.courses, 4 + 8);
  EXPECT_EQ(wall.blocks.size(), 4U * 16 + 8U * 20);
  EXPECT_EQ(wall.report.lost_joints, 0);
  EXPECT_NEAR(area_of(wall), 2, 1e-12);
  EXPECT_NEAR(bed_length(wall, 0.52), 2, 1e-12);
  std::set<int> courses;
  for (const Block& block : wall.blocks) {
    courses.insert(block.course);
    EXPECT_EQ(block.storey, block.course < 4 ? 0 : 1);
  }
  EXPECT_EQ(courses.size(), 12U);
  EXPECT_EQ(*courses.rbegin(), 11);
}

TEST(Storeys, weigh_what_their_thickness_and_density_say_and_meet_in_the_smaller_thickness) {
  ModelSpec spec = scenes::plain_wall(8, 8, 1e-3, 0.02);
  const double length = spec.wall.length, height = spec.wall.height;
  spec.wall.height = kUnset;
  spec.wall.thickness = 0.40;
  spec.storey.resize(2);
  spec.storey[0].name = "ground";
  spec.storey[0].height = height / 2;
  spec.storey[1].name = "first";
  spec.storey[1].height = height / 2;
  spec.storey[1].thickness = 0.25;
  spec.storey[1].unit.density = 900;
  const Model model = compile(spec);
  const double wanted =
      length * height / 2 * (0.40 * spec.wall.unit.density + 0.25 * 900) * spec.solve.gravity;
  EXPECT_NEAR(model.weight / wanted, 1, 1e-12);
  double floor_line = 0, below = 0;
  for (JointId j = 0; j < model.n_joint; ++j) {
    if (model.anatomy.joint_kind[j] != JointKind::kBed) continue;
    const auto b = static_cast<std::size_t>(model.joint_b[j]);
    const double y = model.centroid_y[b] + model.arm_b_y[j];
    const double area = model.area[j];
    if (std::abs(y - height / 2) < 1e-9) floor_line += area;
    if (std::abs(y - height / 8) < 1e-9) below += area;
  }
  EXPECT_NEAR(floor_line, 0.25 * length, 1e-12);
  EXPECT_NEAR(below, 0.40 * length, 1e-12);
}

TEST(Storeys, a_pressure_on_the_top_acts_on_the_thickness_there) {
  ModelSpec spec = building(2);
  for (const char* name : {"joint", "unit", "foundation"})
    spec.material[name] = scenes::paper_joint();
  spec.storey[1].thickness = 0.2;
  spec.stage = {scenes::gravity_stage(), scenes::gravity_stage()};
  spec.stage[1].action = LoadStage{.pressure = 1e5};
  const Model model = compile(spec);
  double load = 0;
  for (const PointLoad& force : model.stages[1].loads) load -= force.fy;
  EXPECT_NEAR(load / (1e5 * 2 * 0.2), 1, 1e-12);
}

TEST(Storeys, a_building_of_one_storey_runs_as_the_plain_wall_to_the_bit) {
  const ModelSpec plain = scenes::small_wall(5e-4);
  ModelSpec storey = plain;
  storey.wall.height = kUnset;
  storey.storey.resize(1);
  storey.storey[0].name = "ground";
  storey.storey[0].height = plain.wall.height;
  storey.wall.opening[0].storey = "ground";
  const auto hash = [](const ModelSpec& spec) {
    const Model model = compile(spec);
    State state = initial_state(model);
    return solve(model, state).state_hash;
  };
  EXPECT_EQ(hash(storey), hash(plain));
}

TEST(Storeys, openings_count_from_their_foot) {
  ModelSpec spec = building(2);
  spec.wall.opening = {hole("first", 0.6, 0.1, 0.8, 0.2)};
  const Assembly named = build(spec);
  spec.wall.opening = {hole("", 0.6, 0.6, 0.8, 0.2)};
  const Assembly placed = build(spec);
  ASSERT_EQ(named.blocks.size(), placed.blocks.size());
  EXPECT_LT(named.blocks.size(), build(building(2)).blocks.size());
  for (std::size_t b = 0; b < named.blocks.size(); ++b)
    EXPECT_EQ(named.blocks[b].id, placed.blocks[b].id);
}

TEST(Storeys, a_height_of_the_wall_agrees_with_their_sum_or_is_refused_with_it) {
  ModelSpec spec = building(2);
  spec.wall.height = 1;
  EXPECT_DOUBLE_EQ(build(spec).height, 1);
  spec.wall.height = 1.2;
  expect_says(refusal(spec), {"wall.height", "add up to 1 m (0.5 m + 0.5 m)", "leave wall.height"});
}

TEST(Storeys, an_opening_through_a_floor_line_is_refused_with_its_place) {
  ModelSpec spec = building(2);
  spec.wall.opening = {hole("", 0.6, 0.2, 0.8, 0.5)};
  expect_says(refusal(spec), {"wall.opening.0.height", "ends at 0.7 m", "floor line at 0.5 m",
                              "make two of one that goes through", "height = \"0.3 m\""});
  EXPECT_EQ(refusal(spec).find("\"cut\""), std::string::npos) << "which would not cure it";
  spec.wall.opening = {hole("", 0.6, 0.3, 0.8, 0.5)};
  expect_says(refusal(spec), {"wall.opening.0.y", "begins at 0.3 m", "floor line at 0.5 m"});
  spec.wall.opening = {hole("first", 0.6, 0.3, 0.8, 0.5)};
  expect_says(refusal(spec),
              {"wall.opening.0.height", "ends at 0.8 m", "above the top of its storey at 0.5 m"});
  spec.wall.opening = {hole("first", 0.6, 0.6, 0.8, 0.2)};  // from the ground
  expect_says(refusal(spec), {"ends at 0.8 m", "write y = \"0.1 m\""});
  EXPECT_EQ(refusal(spec).find("height = \""), std::string::npos);
}

TEST(Storeys, faults_are_named_with_place_and_cure) {
  const auto said = [](const std::function<void(ModelSpec&)>& change) {
    ModelSpec spec = building(2);
    change(spec);
    return refusal(spec);
  };
  expect_says(said([](ModelSpec& s) { s.wall.opening = {hole("frist", 0, 0, 1, 0.2)}; }),
              {"wall.opening.0.storey", "no such storey", "did you mean first?"});
  expect_says(said([](ModelSpec& s) { s.storey[1].name = "ground"; }),
              {"storey.1.name", "two storeys have this name"});
  expect_says(said([](ModelSpec& s) { s.storey[1].name = ""; }), {"storey.1.name", "missing"});
  expect_says(said([](ModelSpec& s) { s.storey[1].height = kUnset; }),
              {"storey.1.height", "missing"});
  expect_says(said([](ModelSpec& s) { s.storey[0].bond = "flemisch"; }),
              {"storey.0.bond", "did you mean flemish?"});
  expect_says(said([](ModelSpec& s) { s.storey[1].unit.height = 0.3; }),
              {"storey.1.unit.height", "storey 1 (first)'s height of 0.5 m holds 1.667 courses"});
  expect_says(said([](ModelSpec& s) { s.storey[1].thickness = -1; }),
              {"storey.1.thickness", "must be positive"});
  ModelSpec none = building(0);
  none.wall.opening = {hole("ground", 0, 0, 1, 0.2)};
  expect_says(refusal(none), {"wall.opening.0.storey", "the model has no [[storey]]"});
}

TEST(Storeys, what_both_inherit_is_told_once) {
  ModelSpec spec = building(2);
  spec.wall.thickness = kUnset;
  expect_says(refusal(spec), {"wall.thickness", "missing"});
}

TEST(Storeys, of_ten_million_units_are_refused_before_any_is_laid) {
  setenv("WYTHE_MEMORY", "16 GB", 1);
  ModelSpec spec = building(2);
  spec.wall.length = 5000;
  spec.storey[0].height = spec.storey[1].height = 10;
  try {
    (void)compile(spec);
    ADD_FAILURE() << "was taken";
  } catch (const InputError& error) {
    expect_says(error.what(), {"10 million blocks", "of memory", "WYTHE_MEMORY"});
  }
  unsetenv("WYTHE_MEMORY");
}

// --- joints ----------------------------------------------------------------------------------------------

TEST(Joints, of_heads_and_units_have_materials_of_their_own) {
  ModelSpec spec = building(0);
  spec.wall.joints = {.joint = "weak", .head_joint = "dry", .unit_joint = "stone"};
  const Assembly wall = build(spec);
  EXPECT_EQ(materials_of(wall, FaceKind::kBed), (Names{{"weak", 20 * 9}}));
  EXPECT_EQ(materials_of(wall, FaceKind::kHead).begin()->first, "dry");
  EXPECT_EQ(materials_of(wall, FaceKind::kSplit).begin()->first, "stone");
  EXPECT_EQ(materials_of(wall, FaceKind::kHead).size(), 1U);
  EXPECT_EQ(materials_of(wall, FaceKind::kSplit).size(), 1U);
}

TEST(Joints, without_names_are_those_of_the_plain_wall_and_heads_follow_the_beds) {
  ModelSpec spec = building(0);
  EXPECT_EQ(materials_of(build(spec), FaceKind::kHead).begin()->first, "joint");
  spec.wall.joints.joint = "weak";
  spec.material.erase("joint");
  spec.material.erase("foundation");
  const Assembly wall = build(spec);
  EXPECT_EQ(materials_of(wall, FaceKind::kHead).begin()->first, "weak");
  EXPECT_EQ(materials_of(wall, FaceKind::kFoundation).begin()->first, "weak");
  EXPECT_TRUE(notes_say(wall, "take [material.weak]"));
}

TEST(Joints, the_floor_line_is_the_upper_storeys) {
  ModelSpec spec = building(2);
  spec.storey[1].joints.joint = "new";
  const Assembly wall = build(spec);
  for (const Face& face : wall.faces) {
    if (face.kind != FaceKind::kBed) continue;
    EXPECT_EQ(face.material, middle(face).y > 0.5 - 1e-9 ? "new" : "joint");
  }
}

TEST(Joints, that_name_no_material_are_refused_with_their_use) {
  ModelSpec spec = building(2);
  spec.storey[0].joints.head_joint = "nothing";
  expect_says(refusal(spec), {"material.nothing", "missing", "add [material.nothing]"});
}

// --- regions ---------------------------------------------------------------------------------------------

TEST(Regions, of_a_box_have_the_joints_between_their_own_blocks) {
  ModelSpec spec = building(0);
  spec.region = {box_region(0, 0, 0.4, 0.3)};
  const Assembly wall = build(spec);
  int inside = 0;
  for (const Face& face : wall.faces) {
    if (face.kind != FaceKind::kBed && face.kind != FaceKind::kHead) continue;
    const Vec2 m = middle(face);
    const bool own = m.x < 0.4 - 1e-9 && m.y < 0.3 - 1e-9;
    EXPECT_EQ(face.material, own ? "new" : "joint") << m.x << ", " << m.y;
    inside += own;
  }
  EXPECT_GT(inside, 5);
}

TEST(Regions, the_one_listed_later_has_the_blocks_and_their_edge_is_of_the_earlier) {
  ModelSpec spec = building(0);
  spec.region = {box_region(0, 0, 1, 1), box_region(0, 0, 0.4, 0.3)};
  spec.region[0].joints.joint = "weak";
  const Assembly wall = build(spec);
  EXPECT_TRUE(notes_say(wall, "region 1 takes 12 blocks of region 0"));
  for (const Face& face : wall.faces) {
    if (face.kind != FaceKind::kBed) continue;
    const Vec2 m = middle(face);
    EXPECT_EQ(face.material, m.x > 1 ? "joint" : m.x < 0.4 && m.y < 0.3 - 1e-9 ? "new" : "weak");
  }
}

TEST(Regions, of_a_polygon_hold_the_blocks_whose_centre_it_holds) {
  ModelSpec spec = building(0);
  RegionSpec region;
  region.place.polygon = {{2, 0}, {2, 1}, {1, 0}};  // clockwise or not
  region.density = 2500;
  spec.region = {region};
  const Assembly wall = build(spec);
  int held = 0;
  for (const Block& block : wall.blocks) {
    const Vec2 c = moments(block.outline).centroid;
    const bool in = c.y <= c.x - 1 + 1e-9;
    EXPECT_EQ(block.region, in ? 0 : -1);
    EXPECT_EQ(density_of(spec, block), in ? 2500 : 1800);
    held += in;
  }
  EXPECT_EQ(held, 55);  // a stair of 1 + 2 + ... + 10, the diagonal through centres included
}

TEST(Regions, have_a_thickness_of_their_own_and_joints_that_of_the_thinner_block) {
  ModelSpec spec = building(2);
  spec.region = {box_region(0, 0, 0.4, 1), box_region(0.6, 0, 0.4, 0.3)};
  spec.region[0].joints = spec.region[1].joints = {};
  spec.region[0].thickness = 1.2;   // a wall across
  spec.region[1].thickness = 0.12;  // a niche
  const Assembly wall = build(spec);
  const double plain = spec.wall.thickness;
  for (const Block& block : wall.blocks) {
    const double own = block.region == 0 ? 1.2 : block.region == 1 ? 0.12 : plain;
    EXPECT_EQ(block.thickness, own);
  }
  int edges = 0;
  for (const Face& face : wall.faces) {
    const double b = wall.blocks[face.b].thickness;
    const double a = face.a < 0 ? b : wall.blocks[face.a].thickness;
    EXPECT_EQ(wall.thickness_of(face), std::min(a, b));
    edges += a != b;
  }
  EXPECT_GT(edges, 10);
  spec.region[1].thickness = -0.1;
  expect_says(refusal(spec), {"region.1.thickness"});
}

TEST(Regions, of_a_storey_and_of_a_pier_of_it) {
  ModelSpec spec = building(2);
  spec.wall.opening = {hole("ground", 0.6, 0, 0.4, 0.4), hole("first", 1.2, 0.1, 0.2, 0.2)};
  RegionSpec storey, pier;
  storey.place.storey = pier.place.storey = "first";
  storey.density = 2000;
  pier.place.pier = 2;
  pier.density = 2500;
  spec.region = {storey, pier};
  const Assembly wall = build(spec);
  for (const Block& block : wall.blocks) {
    const Vec2 c = moments(block.outline).centroid;
    EXPECT_EQ(block.region, c.y < 0.5 ? -1 : c.x > 1.4 ? 1 : 0);
  }
  spec.region[1].place.pier = 3;
  expect_says(refusal(spec), {"region.1.pier", "storey 1 (first) has 2 piers", "pier = 1 to 2"});
}

TEST(Regions, faults_are_named_with_place_and_cure) {
  const auto said = [](const std::function<void(RegionSpec&)>& change) {
    ModelSpec spec = building(2);
    spec.region = {box_region(0.2, 0.2, 0.4, 0.4)};
    spec.region[0].name = "patch";
    change(spec.region[0]);
    return refusal(spec);
  };
  expect_says(said([](RegionSpec& r) { r.place.x = 5; }),
              {"region.0", "region 0 (patch) holds no block"});
  expect_says(said([](RegionSpec& r) { r.joints = {}; }), {"region.0", "changes nothing", "joint"});
  expect_says(said([](RegionSpec& r) { r.place.pier = 1; }), {"region.0", "more than one place"});
  expect_says(said([](RegionSpec& r) { r.place.x = kUnset; }), {"region.0.x", "missing"});
  expect_says(said([](RegionSpec& r) { r.place.storey = "attic"; }),
              {"region.0.storey", "no such storey"});
  expect_says(said([](RegionSpec& r) { r.joints.joint = "nothing"; }), {"material.nothing"});
  const auto without_box = [](RegionSpec& r) { r.place = {}; };
  expect_says(said(without_box), {"region.0", "has no place"});
  expect_says(said([&](RegionSpec& r) {
                without_box(r);
                r.place.pier = 1;
              }),
              {"region.0.storey", "piers are counted in a storey", "storey = \"ground\""});
  expect_says(said([&](RegionSpec& r) {
                without_box(r);
                r.place.polygon = {{0, 0}, {1, 1}, {1, 0}, {0, 1.5}};
              }),
              {"region.0.polygon", "crosses or touches itself"});
}

TEST(Regions, and_storeys_of_a_blocks_file_go_by_the_centre) {
  ModelSpec spec =
      scenes::half_units({.columns = 4, .courses = 4, .hole = 0}, scenes::paper_joint());
  spec.material["weak"] = scenes::paper_joint();
  spec.wall.thickness = 0.3;
  spec.storey.resize(2);
  spec.storey[0].name = "a", spec.storey[0].height = 0.22;
  spec.storey[1].name = "b", spec.storey[1].height = 0.22, spec.storey[1].thickness = 0.2;
  spec.region.resize(1);
  spec.region[0].place.storey = "b";
  spec.region[0].joints.joint = "weak";
  const Assembly wall = build(spec);
  for (const Block& block : wall.blocks) {
    if (block.role != Role::kMasonry) continue;
    const bool upper = moments(block.outline).centroid.y > 0.22;
    EXPECT_EQ(block.thickness, upper ? 0.2 : 0.3);
    EXPECT_EQ(block.region, upper ? 0 : -1);
  }
  EXPECT_EQ(materials_of(wall, FaceKind::kBed), (Names{{"joint", 8}, {"weak", 4}}));
  spec.storey[1].unit.density = 900;
  EXPECT_TRUE(notes_say(build(spec), "storey.b.unit is not used"));
}

// --- surveyed walls --------------------------------------------------------------------------------------

TEST(Survey, many_sizes_off_the_joints_are_told_once_with_the_cure_of_all_first) {
  ModelSpec spec = building(2);
  for (const char* storey : {"ground", "first"})
    for (int k = 0; k < 3; ++k)
      spec.wall.opening.push_back(hole(storey, 0.25 + 0.6 * k, 0.14, 0.33, 0.26));
  const std::vector<Fault> faults = faults_of(spec);
  ASSERT_EQ(faults.size(), 1U);
  EXPECT_EQ(faults[0].path, "wall.fit");
  expect_says(faults[0].problem, {"12 sizes do not fit"});
  expect_says(faults[0].cure, {"write fit = \"cut\" under [wall]", "wall.opening.0.x = 0.25 m"});
  spec.wall.fit = Fit::kCut;
  EXPECT_EQ(build(spec).piers.size(), 4U);
}

TEST(Survey, what_cutting_would_not_cure_is_told_beside) {
  ModelSpec spec = building(2);
  for (int k = 0; k < 3; ++k)
    spec.wall.opening.push_back(hole("first", 0.25 + 0.6 * k, 0.1, 0.33, 0.3));
  spec.wall.opening.push_back(hole("attic", 0.2, 0.1, 0.2, 0.2));
  const std::vector<Fault> faults = faults_of(spec);
  ASSERT_EQ(faults.size(), 2U);
  EXPECT_EQ(faults[0].path, "wall.fit");
  EXPECT_EQ(faults[1].path, "wall.opening.3.storey");
}

// --- a facade from its file ------------------------------------------------------------------------------

TEST(Facade, of_two_storeys_weighs_what_its_drawing_says) {
  const ModelSpec spec = read_model(kFacade, {});
  const Assembly wall = build(spec);
  EXPECT_EQ(wall.report.courses, 86);
  EXPECT_DOUBLE_EQ(wall.height, 6.4);
  const Model model = compile(spec);
  const double course = 3.2 / 43, half = 0.15;  // openings and lintels on whole courses
  const auto sum = [&](double thickness, int holes, double hole_area, double lintel_length) {
    const double lintels = holes * lintel_length * 2 * course;
    return thickness * (1800 * (9.6 * 3.2 - hole_area - lintels) + 2400 * lintels);
  };
  const double ground = sum(0.44, 3, 1.2 * course * (18 + 30 + 18), 1.2 + 2 * half);
  const double first = sum(0.29, 4, 4 * 1.05 * course * 18, 1.05 + 2 * half);
  EXPECT_NEAR(model.weight / (9.81 * (ground + first)), 1, 1e-12);
  EXPECT_GT(model.n_block, 4000);
}

TEST(Facade, every_number_of_storeys_and_regions_can_be_set_and_sampled) {
  const ModelSpec spec = read_model(kFacade, {});
  const std::vector<io::ModelKey> keys = io::number_keys(spec);
  ASSERT_NE(io::find_key(keys, "storey.ground.height"), nullptr);
  ASSERT_NE(io::find_key(keys, "region.repaired corner.density"), nullptr);
  int tried = 0;
  for (const io::ModelKey& key : keys) {
    if (!key.path.starts_with("storey.") && !key.path.starts_with("wall.unit.")) continue;
    const std::string unit = key.path.ends_with("density") ? "1900 kg/m^3" : "0.1 m";
    EXPECT_NO_THROW((void)read_model(kFacade, {key.path + "=" + unit})) << key.path;
    ++tried;
  }
  EXPECT_GE(tried, 2 * 8 + 6);
  const ModelSpec set = read_model(kFacade, {"storey.ground.height=3.5 m"});
  EXPECT_DOUBLE_EQ(set.storey[0].height, 3.5);
}

TEST(Facade, a_storey_that_says_nothing_of_crack_planes_has_the_walls) {
  EXPECT_EQ(read_model(kFacade, {}).storey[1].unit.split, Split::kMiddle);
  EXPECT_EQ(read_model(kFacade, {"wall.unit.split=none"}).storey[1].unit.split, Split::kNone);
  EXPECT_EQ(read_model(kFacade, {"wall.unit.split=none", "storey.first.unit.split=middle"})
                .storey[1]
                .unit.split,
            Split::kMiddle);
}

}  // namespace
}  // namespace wythe::geometry::building_test
