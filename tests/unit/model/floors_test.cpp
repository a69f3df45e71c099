// Floors: their loads on blocks, how their weight counts, and refusals.
#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "scenes/scenes.h"
#include "wythe/parts/error.h"
#include "wythe/parts/io.h"
#include "wythe/parts/limit.h"
#include "wythe/parts/reading.h"
#include "wythe/parts/solve.h"

namespace wythe::floors_test {
namespace {

constexpr double kGravity = 9.81;

// A floor of 10 kN/m on the whole second course from the top of the wall with a window.
FloorSpec floor_at(double y, double load = 10e3) {
  FloorSpec floor;
  floor.name = "first";
  floor.y = y;
  floor.load = load;
  return floor;
}

ModelSpec wall_with(const FloorSpec& floor) {
  ModelSpec spec = scenes::small_wall();
  spec.floor = {floor};
  return spec;
}

const std::vector<PointLoad>& loads_of_gravity(const Model& model) { return model.stages[0].loads; }

struct Sum {
  double down = 0, right = 0, moment = 0, top = -1e300, foot = 1e300;
};
// About the wall's lower left corner, anticlockwise.
Sum sum_of(const Model& model) {
  Sum sum;
  for (const PointLoad& load : loads_of_gravity(model)) {
    const auto i = static_cast<std::size_t>(load.block);
    const double x = model.centroid_x[i] + load.arm_x, y = model.centroid_y[i] + load.arm_y;
    sum.down -= load.fy;
    sum.right += load.fx;
    sum.moment += x * load.fy - y * load.fx;
    sum.top = std::max(sum.top, y);
    sum.foot = std::min(sum.foot, y);
  }
  return sum;
}

std::string faults_of(const ModelSpec& spec) {
  try {
    (void)compile(spec);
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}
void expect_refused(const ModelSpec& spec, const std::string& place, const std::string& problem,
                    const std::string& cure) {
  const std::string said = faults_of(spec);
  EXPECT_NE(said.find(place), std::string::npos) << said;
  EXPECT_NE(said.find(problem), std::string::npos) << said;
  EXPECT_NE(said.find(cure), std::string::npos) << said;
}

TEST(Floors, a_line_load_stands_whole_on_the_blocks_that_end_at_its_level) {
  const Model model = compile(wall_with(floor_at(0.66)));
  const Sum sum = sum_of(model);
  EXPECT_NEAR(sum.down, 12.4e3, 1e-9 * 12.4e3);
  EXPECT_NEAR(sum.moment, -12.4e3 * 0.62, 1e-6);
  EXPECT_NEAR(sum.top, 0.66, 1e-9);
  EXPECT_NEAR(sum.foot, 0.66, 1e-9);
  for (const PointLoad& load : loads_of_gravity(model)) EXPECT_GT(load.arm_y, 0);
}

TEST(Floors, a_part_of_the_wall_takes_its_resultant_where_the_part_is) {
  FloorSpec floor = floor_at(0.66);
  floor.x = 0.1, floor.width = 0.5, floor.thrust = 3e3;
  const Sum sum = sum_of(compile(wall_with(floor)));
  EXPECT_NEAR(sum.down, 5e3, 1e-6);
  EXPECT_NEAR(sum.right, 3e3, 1e-6);
  EXPECT_NEAR(sum.moment, -5e3 * 0.35 - 3e3 * 0.66, 1e-6);
}

TEST(Floors, joists_share_the_load_and_one_over_a_head_joint_lies_on_both_blocks) {
  FloorSpec floor = floor_at(0.66);
  floor.joists = {0.155, 0.20, 1.0};
  const Model model = compile(wall_with(floor));
  const Sum sum = sum_of(model);
  EXPECT_EQ(loads_of_gravity(model).size(), 4U);
  EXPECT_NEAR(sum.down, 12.4e3, 1e-6);
  EXPECT_NEAR(sum.moment, -12.4e3 / 3 * (0.155 + 0.20 + 1.0), 1e-6);
}

// The ground's answer in balance: weight and floor together, at the place that moments ask for.
TEST(Floors, the_ground_carries_weight_and_floor) {
  FloorSpec floor = floor_at(0.66, 40e3);
  floor.width = 0.62;
  ModelSpec spec = wall_with(floor);
  spec.stage.resize(1);
  spec.solve.settle_ratio = 1e-8;
  const Model model = compile(spec);
  State state = initial_state(model);
  ASSERT_EQ(solve(model, state).status, SolveStatus::kCompleted);
  double carried = 0, moment = 0, weight = 0, of_weight = 0;
  for (const JointReading& joint : read_wall(model, state).joints)
    if (joint.shape.a == kGroundBlock) {
      carried += joint.compression;
      moment += joint.compression * joint.shape.centre.x + joint.moment;
    }
  for (std::size_t i = 0; i < model.gravity_mass.size(); ++i) {
    weight += kGravity * model.gravity_mass[i];
    of_weight += kGravity * model.gravity_mass[i] * model.centroid_x[i];
  }
  EXPECT_NEAR(carried, weight + 40e3 * 0.62, 1e-5 * weight);
  // the arms are those of the wall at the start, the blocks stand a few micrometres beside
  const double wanted = of_weight + 40e3 * 0.62 * 0.31;
  EXPECT_NEAR(moment, wanted, 1e-4 * wanted);
}

TEST(Floors, a_load_stage_that_asks_for_them_sets_them_in_the_place_of_gravity) {
  ModelSpec spec = wall_with(floor_at(0.66));
  StageSpec load{.name = "floors", .action = LoadStage{.floors = true}};
  spec.stage.insert(spec.stage.begin() + 1, load);
  const Model model = compile(spec);
  EXPECT_TRUE(model.stages[0].loads.empty());
  double down = 0;
  for (const PointLoad& p : model.stages[1].loads) down -= p.fy;
  EXPECT_NEAR(down, 12.4e3, 1e-6);
}

TEST(Floors, mass_is_inertia_and_no_weight) {
  FloorSpec floor = floor_at(0.66);
  const Model without = compile(wall_with(floor));
  floor.mass = 1000;
  const Model with = compile(wall_with(floor));
  double added = 0;
  for (std::size_t i = 0; i < with.mass.size(); ++i) added += with.mass[i] - without.mass[i];
  EXPECT_NEAR(added, 1240, 1e-9 * 1240);
  EXPECT_EQ(with.weight, without.weight);
  EXPECT_EQ(with.gravity_mass, without.gravity_mass);
}

TEST(Floors, patterns_count_the_floor_as_mass_at_its_level) {
  const auto share_of_floor = [](Pattern pattern, double load) {
    ModelSpec spec = wall_with(floor_at(0.66, load));
    spec.stage = {spec.stage[0], spec.stage[2]};
    auto& pushed = spec.stage.back().get<PushStage>();
    pushed.at = {};
    pushed.pattern = pattern;
    if (pattern != Pattern::kMass) pushed.levels = {0.275, 0.605};
    const Model model = compile(spec);
    const Stage& push = model.stages.back();
    double at = 0, all = 0;
    for (std::size_t k = 0; k < push.driven.size(); ++k) {
      const double y = model.centroid_y[push.driven[k]];
      all += push.driven_share[k];
      at += y > 0.55 && y < 0.66 ? push.driven_share[k] : 0.0;
    }
    return at / all;
  };
  const double load = 10e3 * 1.24;
  for (const Pattern pattern : {Pattern::kUniform, Pattern::kMass}) {
    const Model wall = compile(scenes::small_wall());
    double counted = 0;  // of levels: what is not nearest to the ground
    for (std::size_t i = 0; i < wall.gravity_mass.size(); ++i)
      counted += pattern == Pattern::kMass || wall.centroid_y[i] > 0.06
                     ? kGravity * wall.gravity_mass[i]
                     : 0.0;
    const double bare = share_of_floor(pattern, 1e-6);  // so light that it has no part
    EXPECT_NEAR(share_of_floor(pattern, 10e3), (bare * counted + load) / (counted + load), 1e-8);
  }
}

// A block that overturns: lambda W h/2 = (W + F) b/2.
TEST(Floors, limit_analysis_takes_their_weight) {
  ModelSpec spec = scenes::block_on_ground(
      0.5, 2.0, scenes::dry_joint(20e9, 8e9, scenes::degrees(80)), 0.1, 2000);
  StageSpec quake{.name = "quake", .action = BodyForceStage{.rate = 0.5, .factor = 10}};
  spec.stage = {scenes::gravity_stage(), quake};
  spec.floor = {floor_at(2.0, 4e3)};
  const double weight = 2000 * 0.5 * 2.0 * 0.1 * kGravity;
  const LimitOptions dry{.strength = JointStrength::kDry};
  EXPECT_NEAR(limit_load(compile(spec), dry).load, 0.25 * (1 + 4e3 * 0.5 / weight), 1e-9);
}

TEST(Floors, a_storey_stands_for_its_top) {
  FloorSpec floor = floor_at(kUnset);
  floor.storey = "upper";
  ModelSpec spec = wall_with(floor);
  expect_refused(spec, "floor.0.storey = upper", "is not among the storeys", "height y");
  spec.storey.resize(2);
  spec.storey[0].name = "ground", spec.storey[0].height = 0.44;
  spec.storey[1].name = "upper", spec.storey[1].height = 0.44;
  spec.wall.opening.clear();
  spec.stage.resize(1);
  EXPECT_NEAR(sum_of(compile(spec)).top, 0.88, 1e-9);
  spec.floor[0].storey = "ground";
  EXPECT_NEAR(sum_of(compile(spec)).top, 0.44, 1e-9);
  spec.floor[0].storey = "attic";
  expect_refused(spec, "floor.0.storey = attic", "is not among", "ground, upper");
}

TEST(Floors, what_cannot_carry_them_is_refused_with_its_place_and_cure) {
  expect_refused(wall_with(floor_at(0.70)), "floor.0.y = 0.7 m", "no block ends at this height",
                 "y = \"0.660 m\" or y = \"0.770 m\"");
  expect_refused(wall_with(floor_at(0.95)), "floor.0.y", "no block ends", "y = \"0.880 m\"");
  expect_refused(wall_with(floor_at(0.44)), "floor.0", "lies on nothing between 0.465 and 0.775 m",
                 "two floors");
  FloorSpec floor = floor_at(0.66);
  floor.x = 1.0, floor.width = 0.5;
  expect_refused(wall_with(floor), "floor.0.x", "from 1.000 to 1.500 m", "within the wall");
  floor = floor_at(0.44);
  floor.joists = {0.2, 0.6};
  expect_refused(wall_with(floor), "floor.0.joists.1 = 0.6 m", "lies on nothing", "on masonry");
  floor = floor_at(0.66);
  floor.width = 0.5, floor.joists = {0.9};
  expect_refused(wall_with(floor), "floor.0.joists.0", "beside the floor", "0.500 m");
}

// The place would get two shares, and every other joist less.
TEST(Floors, two_joists_at_one_place_are_refused) {
  FloorSpec floor = floor_at(0.66);
  floor.joists = {0.2, 1.0, 0.2004};
  expect_refused(wall_with(floor), "floor.0.joists.2 = 0.2004 m", "joist 0 lies there already",
                 "a [[floor]] of its own");
}

TEST(Floors, half_said_floors_are_refused) {
  FloorSpec floor = floor_at(0.66, kUnset);
  expect_refused(wall_with(floor), "floor.0", "does nothing", "load = ");
  floor = floor_at(kUnset);
  expect_refused(wall_with(floor), "floor.0", "has no level", "height y");
  floor = floor_at(0.66);
  floor.storey = "ground";
  expect_refused(wall_with(floor), "floor.0", "has two levels", "storey");
  floor = floor_at(0.66);
  floor.bearing = 0.4;
  expect_refused(wall_with(floor), "floor.0.bearing", "thick", "thickness");
  floor.bearing = 0.1, floor.joists = {0.2};
  expect_refused(wall_with(floor), "floor.0.bearing", "joists", "leave it out");
  ModelSpec spec = wall_with(floor_at(0.66));
  spec.stage.erase(spec.stage.begin());
  expect_refused(spec, "floor.0", "no stage sets it", "gravity stage");
  spec = scenes::small_wall();
  spec.stage[1].get<LoadStage>().pier_load = kUnset;
  spec.stage[1].get<LoadStage>().floors = true;
  expect_refused(spec, "stage.1.floors", "there is no floor", "[[floor]]");
  spec = wall_with(floor_at(0.66));
  spec.stage[1].get<LoadStage>().floors = true;
  spec.stage.insert(spec.stage.begin() + 1, spec.stage[1]);
  expect_refused(spec, "stage.2.floors", "already", "one stage");
}

// Pushed first and loaded then, a wall would be judged without its floors.
TEST(Floors, a_wall_is_not_pushed_before_its_floors_lie_on_it) {
  ModelSpec spec = wall_with(floor_at(0.66));
  StageSpec load{.name = "floors", .action = LoadStage{.floors = true}};
  spec.stage.push_back(load);
  const std::string stage = "stage." + std::to_string(spec.stage.size() - 1) + ".floors";
  expect_refused(spec, stage, "only after stage.", "before it");
}

// Within ten millimetres the bed joint is meant; a note says where the floor lies.
TEST(Floors, a_level_beside_the_bed_joint_by_a_few_millimetres_is_the_bed_joint) {
  const Model model = compile(wall_with(floor_at(0.667)));
  EXPECT_NEAR(sum_of(model).top, 0.66, 1e-9);
  bool said = false;
  for (const Message& note : model.anatomy.notes)
    said = said || text_of(note).find("12.4 kN at 0.660 m") != std::string::npos;
  EXPECT_TRUE(said);
}

TEST(Floors, the_pressure_under_a_bearing_is_held_against_the_strength) {
  FloorSpec floor = floor_at(0.66, 400e3);
  floor.bearing = 0.05;  // 8 MPa
  std::string notes;
  for (const Message& note : compile(wall_with(floor)).anatomy.notes) notes += text_of(note) + "\n";
  EXPECT_NE(notes.find("8.00 MPa under its bearing, beyond the strength"), std::string::npos)
      << notes;
}

}  // namespace
}  // namespace wythe::floors_test
