// Openings that a stage cuts out of walls in space, against walls built with the opening, equilibrium and the same wall
// in its plane (docs/theory/cutting.md).
#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <string>
#include <vector>

#include "scenes/scenes.h"
#include "verification/record.h"
#include "wythe/parts/error.h"
#include "wythe/parts/limit.h"
#include "wythe/parts/reading.h"
#include "wythe/parts/solve.h"

namespace wythe::verification::cutting_in_space_test {
namespace {

constexpr double kPressure = 50e3;  // on the top of the wall [Pa]

// The window of small_wall, cut under load, in the plane.
ModelSpec plane_wall() {
  ModelSpec spec = scenes::small_wall(1e-3, 0.02, 0);
  spec.wall.opening[0].name = "window";
  spec.wall.opening[0].cut = "cut";
  spec.stage[1].get<LoadStage>().pier_load = kUnset;
  spec.stage[1].get<LoadStage>().pressure = kPressure;
  StageSpec cut{.name = "cut", .action = CutStage{}};
  spec.stage.back() = cut;
  spec.solve.settle_ratio = 1e-7;
  return spec;
}

using scenes::along_a_line;
ModelSpec built(ModelSpec plane) {
  plane.wall.opening[0].cut = "";
  return plane;
}
ModelSpec elastic(ModelSpec spec) {
  spec.material["joint"] = scenes::elastic_joint(20e9, 8e9);
  spec.material["unit"] = scenes::elastic_joint(40e9, 16e9);
  return spec;
}

struct Ran {
  Model model;
  State state;
  Result result;
};
Ran solved(const ModelSpec& spec, std::int64_t steps = 0, int threads = 1) {
  Ran r{compile(spec), {}, {}};
  r.state = initial_state(r.model);
  SolveOptions options;
  options.step_budget = steps;
  options.threads = threads;
  r.result = solve(r.model, r.state, options);
  return r;
}
// With one step of the last stage.
Ran begun(const ModelSpec& spec) {
  const Result whole = solved(spec).result;
  return solved(spec, whole.steps - whole.stages.back().steps + 1);
}

std::map<std::string, Vec3> motions(const Ran& r) {
  std::map<std::string, Vec3> all;
  for (std::size_t i = 0; i < r.state.ux.size(); ++i)
    if (r.model.anatomy.block_role[i] != BlockRole::kCutOut)
      all[r.model.anatomy.block_id[i]] = {r.state.ux[i], r.state.uy[i], r.state.uz[i]};
  return all;
}

double ground_force(const Ran& r) {
  double sum = 0;
  for (const JointReading& joint : read_wall(r.model, r.state).joints)
    if (joint.shape.kind == JointKind::kFoundation) sum += joint.compression;
  return sum;
}

double load_of(const Ran& r) {
  double sum = 0;
  for (const PointLoad& load : r.model.stages[1].loads) sum -= load.fy;
  return sum;
}

TEST(CuttingInSpace, an_elastic_wall_ends_as_if_it_had_been_built_so) {
  for (const int wythes : {1, 2}) {
    const Ran cut = solved(along_a_line(elastic(plane_wall()), wythes)),
              whole = solved(along_a_line(elastic(built(plane_wall())), wythes));
    ASSERT_EQ(cut.result.status, SolveStatus::kCompleted) << text_of(cut.result.reason);
    const auto was = motions(cut), wanted = motions(whole);
    ASSERT_EQ(was.size(), wanted.size());
    double most = 0, apart = 0;
    for (const auto& [id, motion] : wanted) {
      most = std::max(most, length(motion));
      apart = std::max(apart, length(was.at(id) - motion));
    }
    verify({"CU11", "wall in space cut under load: displacement off that of one built so", "", 0,
            1e-4, "settled twice to 1e-7, finite turns", true},
           apart / most);
    EXPECT_GT(most, 1e-6);
  }
}

TEST(CuttingInSpace, the_ground_bears_what_is_left) {
  for (const bool is_elastic : {true, false}) {
    const Ran r = solved(along_a_line(is_elastic ? elastic(plane_wall()) : plane_wall()));
    ASSERT_EQ(r.result.status, SolveStatus::kCompleted) << text_of(r.result.reason);
    const Model whole = compile(along_a_line(built(plane_wall())));
    EXPECT_NEAR(r.model.weight, whole.weight, 1e-9 * whole.weight);
    EXPECT_NEAR(load_of(r), kPressure * 8 * 0.155 * 0.31, 1e-6);
    verify({"CU12", "wall in space cut under load: force on the ground", "N",
            whole.weight + load_of(r), 1e-4, "settled to 1e-7"},
           ground_force(r));
    EXPECT_LT(r.result.energy.gap_ratio, 1e-3);
  }
}

TEST(CuttingInSpace, begins_without_a_jolt) {
  const Ran start = begun(along_a_line(elastic(plane_wall())));
  double speed = 0;
  for (std::size_t i = 0; i < start.state.vx.size(); ++i)
    speed = std::max(speed, length({start.state.vx[i], start.state.vy[i], start.state.vz[i]}));
  // a block let go falls by g dt in the first step
  EXPECT_LT(speed, 0.01 * start.model.solve.gravity * start.result.time_step);
}

ModelSpec with_lintel(ModelSpec spec) {
  LintelSpec& lintel = spec.wall.opening[0].lintel;
  lintel.kind = "timber";
  lintel.depth = 0.11;
  lintel.bearing = 0.155;
  lintel.material = "timber";
  spec.material["timber"].density = 500;
  spec.material["timber"].youngs_modulus = 10e9;
  spec.material["timber"].shear_modulus = 0.6e9;
  return spec;
}

TEST(CuttingInSpace, a_lintel_is_put_in_without_force_and_then_bears) {
  const ModelSpec spec = along_a_line(with_lintel(plane_wall()));
  const auto most = [](const Ran& r) {
    double force = 0;
    for (const JointReading& joint : read_wall(r.model, r.state).joints)
      if (!r.model.standing.joins(joint.shape.a, joint.shape.b, 0) && !joint.handed_over)
        force = std::max(force, std::fabs(joint.compression));
    return force;
  };
  const Ran start = begun(spec), r = solved(spec);
  ASSERT_EQ(r.result.status, SolveStatus::kCompleted) << text_of(r.result.reason);
  EXPECT_GT(most(r), 100);
  EXPECT_LT(most(start), 0.05 * most(r));
  EXPECT_LT(r.result.energy.gap_ratio, 1e-3);
}

TEST(CuttingInSpace, threads_and_restarts_give_the_same_bits) {
  ModelSpec spec = along_a_line(with_lintel(plane_wall()));
  spec.solve.settle_ratio = 1e-3;
  const Ran one = solved(spec);
  EXPECT_EQ(solved(spec, 0, 2).result.state_hash, one.result.state_hash);
  const auto cut = one.result.steps - one.result.stages.back().steps;
  Ran two{compile(spec), {}, {}};
  two.state = initial_state(two.model);
  RunRecord record;
  for (const std::int64_t steps : {cut + 100, std::int64_t{0}}) {
    SolveOptions options;
    options.step_budget = steps;
    options.checkpoint = [&](const State&, const RunRecord& now, bool) { record = now; };
    two.result = solve(two.model, two.state, options, record);
  }
  EXPECT_EQ(two.result.state_hash, one.result.state_hash);
}

// Wet mortar that cracks: the push after the cut is that of the wall in its plane.
TEST(CuttingInSpace, bears_as_much_as_the_same_wall_in_its_plane) {
  const auto pushed = [](ModelSpec spec) {
    spec.solve.settle_ratio = 1e-4;
    spec.stage.push_back(scenes::push_stage("", Direction::kPlusX, 5e-3, 1e-3));
    spec.stage.back().get<PushStage>().at = {.x = 0.05, .y = 6.5 * 0.11};
    return spec;
  };
  const Ran flat = solved(pushed(plane_wall())), r = solved(along_a_line(pushed(plane_wall())));
  ASSERT_EQ(r.result.status, SolveStatus::kCompleted) << text_of(r.result.reason);
  verify({"CU13", "wall cut under load and pushed, in space and in its plane: force", "N",
          flat.result.curve.back().base_shear, 0.02,
          "points of faces across the thickness; round-off of a path with cracks"},
         r.result.curve.back().base_shear);
}

// Limit analysis sees the wall that stands when the push begins.
TEST(CuttingInSpace, the_limit_load_is_that_of_the_wall_after_the_cut) {
  const auto pushed = [](ModelSpec spec) {
    spec.stage.push_back(scenes::push_stage("", Direction::kPlusX, 5e-3, 1e-3));
    spec.stage.back().get<PushStage>().at = {.x = 0.05, .y = 6.5 * 0.11};
    return compile(along_a_line(with_lintel(spec)));
  };
  const Model cut = pushed(plane_wall());
  const LimitResult found = limit_load(cut, {}),
                    wanted = limit_load(pushed(built(plane_wall())), {});
  verify({"CU15", "limit load of a wall in space whose opening a stage cuts", "N", wanted.load,
          1e-5, "the same programme, its rows in another order"},
         found.load);
  EXPECT_EQ(found.vx.size(), static_cast<std::size_t>(cut.n_block));
  EXPECT_EQ(found.point_force.size(), static_cast<std::size_t>(cut.n_point()));
}

//      [ ---- beam ---- ]     the prop comes in one stage and goes in another
//      [ ]    [prop]  [ ]
TEST(CuttingInSpace, a_prop_comes_without_force_and_goes_without_a_trace) {
  const auto blocks = [](bool has_prop) {
    ModelSpec spec = scenes::in_space({scenes::box("floor", {-1, -0.1, -1}, {4, 0.1, 2}, true),
                                       scenes::box("left", {0, 0, 0}, {0.2, 0.5, 0.2}),
                                       scenes::box("right", {1.8, 0, 0}, {0.2, 0.5, 0.2}),
                                       scenes::box("beam", {0, 0.5, 0}, {2, 0.2, 0.2})},
                                      scenes::elastic_joint(20e9, 8e9), 2000);
    if (has_prop) {
      spec.body.push_back(scenes::box("prop", {0.9, 0, 0}, {0.2, 0.5, 0.2}));
      spec.body.back().put_in = "prop";
      spec.body.back().cut = "unprop";
    }
    spec.stage = {scenes::gravity_stage()};
    for (const char* name : {"prop", "unprop"}) {
      StageSpec stage{.name = name, .action = CutStage{}};
      spec.stage.push_back(stage);
    }
    spec.solve.settle_ratio = 1e-8;
    return spec;
  };
  const Ran with = solved(blocks(true)), without = solved(blocks(false));
  ASSERT_EQ(with.result.status, SolveStatus::kCompleted) << text_of(with.result.reason);
  const auto was = motions(with), wanted = motions(without);
  double most = 0, apart = 0;
  for (const auto& [id, motion] : wanted) {
    most = std::max(most, length(motion));
    apart = std::max(apart, length(was.at(id) - motion));
  }
  verify({"CU14", "beam that was propped and let go: displacement off that of one never propped",
          "", 0, 1e-4, "settled to 1e-8", true},
         apart / most);
  const Result& result = with.result;
  const Ran propped = solved(blocks(true), result.steps - result.stages.back().steps - 1);
  double weight = 0;
  for (const JointReading& joint : read_wall(propped.model, propped.state).joints)
    if (!joint.handed_over && joint.shape.kind == JointKind::kFoundation &&
        propped.model.standing.from[joint.shape.b] > 0)
      weight += joint.compression;
  // of its own weight the joint above holds a part; the beam, four times as heavy, gives it nothing
  const double own = 2000 * 9.81 * 0.2 * 0.5 * 0.2;
  EXPECT_GT(weight, 0.3 * own);
  EXPECT_LT(weight, 1.001 * own);
}

std::string fault_of(const ModelSpec& plane) {
  try {
    (void)compile(along_a_line(plane));
  } catch (const InputError& error) {
    return error.faults().front().path + ": " + error.faults().front().problem;
  }
  return "none";
}

TEST(CuttingInSpace, what_cannot_be_is_refused_with_its_place) {
  ModelSpec spec = plane_wall();
  spec.wall.opening[0].cut = "later";
  EXPECT_EQ(fault_of(spec), "plan_wall.0.opening.0.cut: no stage has this name");
  spec.wall.opening[0].cut = "precompression";
  EXPECT_EQ(fault_of(spec), "plan_wall.0.opening.0.cut: is a load stage");
  spec = plane_wall();
  spec.solve.contacts = Contacts::kFree;
  EXPECT_NE(fault_of(spec).find("solve.contacts: does not go with blocks that a stage cuts out"),
            std::string::npos);
  spec = plane_wall();
  spec.stage.push_back(scenes::push_stage("w.c03u01b.cut0_1", Direction::kPlusX, 0.02, 1e-3));
  EXPECT_NE(fault_of(spec).find("stage.3.at: "), std::string::npos);
}

// An inertia alone would vanish with the masonry, since no force tells of it.
TEST(CuttingInSpace, a_floor_on_masonry_that_goes_is_refused_with_its_stage) {
  for (const bool inertia : {false, true}) {
    ModelSpec spec = plane_wall();
    FloorSpec floor;
    floor.from.x = 0.1, floor.from.y = 0.44, floor.from.z = 0;
    floor.to = floor.from;
    floor.to.x = 0.9;
    (inertia ? floor.mass : floor.load) = 1e3;
    spec.floor.push_back(floor);
    EXPECT_NE(fault_of(spec).find("m along its line on masonry that stage \"cut\" cuts out"),
              std::string::npos)
        << fault_of(spec);
    spec.floor[0].to.x = 0.4;
    EXPECT_EQ(fault_of(spec), "none");
  }
}

}  // namespace
}  // namespace wythe::verification::cutting_in_space_test
