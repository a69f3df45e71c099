// Openings that a stage cuts out of standing masonry, against equilibrium, superposition and walls built with the
// opening (docs/theory/cutting.md).
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

namespace wythe::verification::cutting_test {
namespace {

constexpr double kLoad = 20e3;  // on each pier [N]

StageSpec cut_stage() { return {.name = "cut", .action = CutStage{}}; }

// The window of small_wall, cut under load; no push.
ModelSpec cut_wall() {
  ModelSpec spec = scenes::small_wall(1e-3, 0.02, kLoad);
  spec.wall.opening[0].name = "window";
  spec.wall.opening[0].cut = "cut";
  spec.stage.back() = cut_stage();
  spec.solve.settle_ratio = 1e-7;
  return spec;
}
ModelSpec built_wall() {
  ModelSpec spec = cut_wall();
  spec.wall.opening[0].cut = "";
  return spec;
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
Ran solved(const ModelSpec& spec, std::int64_t steps = 0) {
  Ran r{compile(spec), {}, {}};
  r.state = initial_state(r.model);
  SolveOptions options;
  options.step_budget = steps;
  r.result = solve(r.model, r.state, options);
  return r;
}
// With one step of the last stage.
Ran begun(const ModelSpec& spec) {
  const Result whole = solved(spec).result;
  return solved(spec, whole.steps - whole.stages.back().steps + 1);
}

std::map<std::string, std::vector<double>> motions(const Ran& r) {
  std::map<std::string, std::vector<double>> all;
  for (std::size_t i = 0; i < r.state.ux.size(); ++i)
    if (r.model.anatomy.block_role[i] != BlockRole::kCutOut)
      all[r.model.anatomy.block_id[i]] = {r.state.ux[i], r.state.uy[i], 0.1 * r.state.theta[i]};
  return all;
}

double ground_force(const Ran& r) {
  const WallReading wall = read_wall(r.model, r.state);
  double sum = 0;
  for (const JointReading& joint : wall.joints)
    if (joint.shape.a == kGroundBlock) sum += joint.compression;
  return sum;
}

// Elastic joints forget how a load came on, so the wall ends as if it had been built with its opening.
TEST(Cutting, an_elastic_wall_ends_as_if_it_had_been_built_so) {
  const Ran cut = solved(elastic(cut_wall())), built = solved(elastic(built_wall()));
  ASSERT_EQ(cut.result.status, SolveStatus::kCompleted);
  const auto was = motions(cut), wanted = motions(built);
  ASSERT_EQ(was.size(), wanted.size());
  double most = 0, apart = 0;
  for (const auto& [id, motion] : wanted)
    for (std::size_t k = 0; k < 3; ++k) {
      most = std::max(most, std::fabs(motion[k]));
      apart = std::max(apart, std::fabs(was.at(id)[k] - motion[k]));
    }
  verify({"CU01", "wall cut under load: displacement off that of a wall built with the opening", "",
          0, 1e-4, "settled twice to 1e-7, finite turns", true},
         apart / most);
  EXPECT_GT(most, 1e-6);
}

// What was cut out bears nothing and weighs nothing; all else stands on the ground.
TEST(Cutting, the_ground_bears_what_is_left) {
  for (const bool is_elastic : {true, false}) {
    const Ran r = solved(is_elastic ? elastic(cut_wall()) : cut_wall());
    ASSERT_EQ(r.result.status, SolveStatus::kCompleted);
    const Model built = compile(built_wall());
    EXPECT_NEAR(r.model.weight, built.weight, 1e-9 * built.weight);
    const double loads = kLoad * static_cast<double>(r.model.anatomy.pier_x0.size());
    verify({"CU02", "wall cut under load: force on the ground", "N", built.weight + loads, 1e-4,
            "settled to 1e-7"},
           ground_force(r));
    EXPECT_LT(r.result.energy.gap_ratio, 1e-3);
  }
}

// At the start of the stage all neighbours are held as they were: nothing moves at once.
TEST(Cutting, begins_without_a_jolt) {
  const ModelSpec spec = elastic(cut_wall());
  const Ran start = begun(spec);
  double speed = 0;
  for (std::size_t i = 0; i < start.state.vx.size(); ++i)
    speed = std::max(speed, std::hypot(start.state.vx[i], start.state.vy[i]));
  // a block let go falls by g dt in the first step
  EXPECT_LT(speed, 0.01 * start.model.solve.gravity * start.result.time_step);
}

ModelSpec with_frame(ModelSpec spec) {
  spec = scenes::framed(std::move(spec));
  spec.frame[0].yield_strength = 500e6;
  spec.frame[0].section.area *= 4;
  spec.frame[0].section.mass *= 4;
  return spec;
}

// A frame is put up without force, so it bears less than one that was there when the loads came.
TEST(Cutting, a_frame_is_put_up_without_force) {
  const ModelSpec spec = with_frame(cut_wall());
  const auto most = [](const Ran& r) {
    double force = 0;
    for (const FrameReading& section : read_frames(r.model, r.state))
      force = std::max({force, std::fabs(section.normal), std::fabs(section.shear)});
    return force;
  };
  const Ran start = begun(spec), cut = solved(spec), built = solved(with_frame(built_wall()));
  ASSERT_EQ(cut.result.status, SolveStatus::kCompleted);
  EXPECT_LT(most(start), 1e-3 * most(cut));
  EXPECT_GT(most(cut), 1.0);
  EXPECT_LT(most(cut), most(built));
  for (const FrameReading& section : read_frames(cut.model, cut.state))
    EXPECT_EQ(section.plastic, 0);  // where it was put up is no yielding
  EXPECT_LT(cut.result.energy.gap_ratio, 1e-3);
}

ModelSpec with_lintel(ModelSpec spec, const JointMaterial& bond) {
  LintelSpec& lintel = spec.wall.opening[0].lintel;
  lintel.kind = "timber";
  lintel.depth = 0.11;
  lintel.bearing = 0.155;
  lintel.material = "timber";
  lintel.bond = "bond";
  spec.material["timber"].density = 500;
  spec.material["timber"].youngs_modulus = 10e9;
  spec.material["timber"].shear_modulus = 0.6e9;
  spec.material["bond"] = bond;
  return spec;
}

// With a gap it stands off by that, and bears nothing before it has closed.
TEST(Cutting, a_frame_with_a_gap_is_put_up_at_that_gap) {
  ModelSpec spec = with_frame(cut_wall());
  spec.frame[0].gap = 1e-3;
  const Ran start = begun(spec);
  int faces = 0;
  for (const JointReading& joint : read_wall(start.model, start.state).joints) {
    if (joint.shape.kind != JointKind::kFrame ||
        joint.shape.normal.y > 0.5 * joint.shape.normal.x || joint.handed_over)
      continue;
    ++faces;  // at the jambs
    EXPECT_NEAR(joint.opening, 1e-3, 0.05e-3);
    EXPECT_EQ(joint.compression, 0);
  }
  EXPECT_GT(faces, 3);
}

// A lintel comes in as one piece and takes what is above it.
TEST(Cutting, a_lintel_is_put_in_without_force_and_then_bears) {
  const ModelSpec spec = with_lintel(cut_wall(), scenes::dry_joint(20e9, 8e9, 0.4));
  const auto bearing = [](const Ran& r) {
    double force = 0;
    for (const JointReading& joint : read_wall(r.model, r.state).joints)
      if (joint.shape.kind == JointKind::kLintelBond && joint.shape.b >= 0 &&
          r.model.anatomy.block_role[joint.shape.b] == BlockRole::kLintel)
        force += joint.compression;
    return force;
  };
  const Ran start = begun(spec), r = solved(spec);
  ASSERT_EQ(r.result.status, SolveStatus::kCompleted);
  EXPECT_GT(bearing(r), 100);
  EXPECT_LT(std::fabs(bearing(start)), 0.05 * bearing(r));
  EXPECT_LT(r.result.energy.gap_ratio, 1e-3);
}

// Nor does its fresh mortar, which a few micrometres would crack, though they are there.
TEST(Cutting, the_mortar_of_a_lintel_and_a_sill_is_put_in_whole) {
  JointMaterial mortar = scenes::paper_joint();
  mortar.normal_stiffness = 20e9;
  ModelSpec spec = with_lintel(cut_wall(), mortar);
  spec.wall.opening[0].sill = {
      .kind = "stone", .depth = 0.11, .bearing = 0.155, .material = "timber", .joint = "bond"};
  const Ran start = begun(spec), r = solved(spec);
  ASSERT_EQ(r.result.status, SolveStatus::kCompleted);
  double most = 0;
  for (const JointReading& joint : read_wall(start.model, start.state).joints)
    if (!start.model.standing.joins(joint.shape.a, joint.shape.b, 0) && !joint.handed_over) {
      most = std::max(most, std::fabs(joint.normal_stress));
      EXPECT_EQ(joint.damage, 0);
    }
  EXPECT_LT(most, 1e3);  // [Pa], of a tensile strength of 0.15 MPa
  EXPECT_LT(r.result.energy.gap_ratio, 1e-4);
  for (const Event& event : r.result.events) EXPECT_NE(event.name.code, "event.first_crushing");
}

// What was built with the wall rests on masonry that is cut out later, as on any other.
TEST(Cutting, a_sill_of_a_window_rests_on_the_masonry_of_the_door_below_it) {
  ModelSpec spec = cut_wall();
  OpeningSpec window = spec.wall.opening[0];  // courses 3 and 4 are cut; the sill is course 5
  window.name = "window above";
  window.cut = "";
  window.y = 6 * 0.11;
  window.height = 0.11;
  window.sill = {
      .kind = "stone", .depth = 0.11, .bearing = 0.155, .material = "stone", .joint = "joint"};
  spec.material["stone"].density = 2400;
  spec.material["stone"].youngs_modulus = 20e9;
  spec.material["stone"].shear_modulus = 8e9;
  spec.wall.opening.push_back(window);
  const Model model = compile(spec);
  int faces = 0;
  for (std::size_t j = 0; j < model.joint_a.size(); ++j) {
    const auto role = [&](BlockId block) {
      return block < 0 ? BlockRole::kMasonry : model.anatomy.block_role[block];
    };
    faces +=
        role(model.joint_a[j]) == BlockRole::kCutOut && role(model.joint_b[j]) == BlockRole::kSill;
  }
  EXPECT_GT(faces, 0);
}

// Along a line in the opening it comes with the cut too.
TEST(Cutting, a_frame_along_a_line_in_the_opening_comes_with_the_cut) {
  ModelSpec spec = with_frame(cut_wall());
  const double x0 = 3 * 0.155 + 0.01, y0 = 3 * 0.11 + 0.01, x1 = 5 * 0.155 - 0.01,
               y1 = 5 * 0.11 - 0.01;
  spec.frame[0].round = "";
  spec.frame[0].line = {{x0, y0}, {x0, y1}, {x1, y1}, {x1, y0}, {x0, y0}};
  const Model model = compile(spec);
  for (std::size_t i = 0; i < model.anatomy.block_role.size(); ++i)
    if (model.anatomy.block_role[i] == BlockRole::kFrame) {
      EXPECT_EQ(model.standing.from[i], 2);
    }
}

// --- layers, zones, limit loads --------------------------------------------------------------------------

// Fibres that crossed the cut hold nothing, and what was held by them is let go of slowly.
TEST(Cutting, a_layer_goes_with_its_masonry) {
  const ModelSpec spec = scenes::layered(cut_wall());
  const Ran start = begun(spec), r = solved(spec);
  ASSERT_EQ(r.result.status, SolveStatus::kCompleted) << text_of(r.result.reason);
  const Layers& l = r.model.layers;
  const std::vector<LayerReading> nodes = read_layers(r.model, r.state);
  int severed = 0, gone = 0;
  for (std::size_t k = 0; k < nodes.size(); ++k) {
    const bool here = r.model.standing.holds(l.a[k], 2), there = r.model.standing.holds(l.b[k], 2);
    gone += here ? 0 : 1;
    severed += here != there ? 1 : 0;
    if (here && there) continue;
    EXPECT_EQ(nodes[k].force, 0);
    EXPECT_FALSE(nodes[k].broken);
  }
  EXPECT_GT(gone, 10);
  EXPECT_GT(severed, 4);
  const double loads = kLoad * static_cast<double>(r.model.anatomy.pier_x0.size());
  verify({"CU03", "wall with a layer, cut under load: force on the ground", "N",
          r.model.weight + loads, 1e-4, "settled to 1e-7"},
         ground_force(r));
  EXPECT_LT(r.result.energy.gap_ratio, 1e-3);
  double speed = 0;
  for (std::size_t i = 0; i < start.state.vx.size(); ++i)
    speed = std::max(speed, std::hypot(start.state.vx[i], start.state.vy[i]));
  EXPECT_LT(speed, 0.01 * start.model.solve.gravity * start.result.time_step);
}

// A wall with a window whose lintel is cut into zones, and a second window that a stage cuts.
ModelSpec wall_with_zones() {
  ModelSpec spec = cut_wall();
  spec.wall.length = 16 * 0.155;
  OpeningSpec other = spec.wall.opening[0];
  other.name = "other", other.cut = "";
  other.x = 11 * 0.155;
  spec.wall.opening.push_back(other);
  ModelSpec lintel = with_lintel(built_wall(), scenes::dry_joint(20e9, 8e9, 0.4));
  spec.wall.opening[1].lintel = lintel.wall.opening[0].lintel;
  spec.wall.opening[1].lintel.model = LintelModel::kZones;
  spec.wall.opening[1].lintel.zones = 1;
  spec.material["timber"] = lintel.material["timber"];
  spec.material["timber"].shear_modulus = 4e9;
  spec.material["bond"] = lintel.material["bond"];
  return spec;
}

TEST(Cutting, zones_elsewhere_stay_as_they_are) {
  const Ran r = solved(wall_with_zones());
  ASSERT_EQ(r.result.status, SolveStatus::kCompleted) << text_of(r.result.reason);
  ASSERT_EQ(r.model.solids.bodies.size(), 1U);
  const double loads = kLoad * static_cast<double>(r.model.anatomy.pier_x0.size());
  verify({"CU04", "wall with a lintel of zones, cut under load elsewhere: force on the ground", "N",
          r.model.weight + loads, 1e-4, "settled to 1e-7"},
         ground_force(r));
  EXPECT_LT(r.result.energy.gap_ratio, 1e-3);
}

// Limit analysis sees the wall that stands when the push begins.
TEST(Cutting, the_limit_load_is_that_of_the_wall_after_the_cut) {
  const auto pushed = [](ModelSpec spec) {
    spec.stage.push_back(scenes::push_stage("", Direction::kPlusX, 0.02, 1e-3));
    spec.stage.back().get<PushStage>().at = {.x = 0, .y = 6.5 * 0.11};
    return with_lintel(spec, scenes::dry_joint(20e9, 8e9, 0.4));
  };
  const Model cut = compile(pushed(cut_wall())), whole = compile(pushed(built_wall()));
  const LimitResult found = limit_load(cut, {}), wanted = limit_load(whole, {});
  verify({"CU05", "limit load of a wall whose opening a stage cuts", "N", wanted.load, 1e-6,
          "the same programme, its rows in another order"},
         found.load);
  EXPECT_EQ(found.vx.size(), static_cast<std::size_t>(cut.n_block));
  EXPECT_EQ(found.shear_force.size(), static_cast<std::size_t>(cut.n_joint));
  bool told = false;
  for (const Message& note : left_aside(cut)) told = told || note.code == "limit.stands_in";
  EXPECT_TRUE(told);
}

TEST(Cutting, threads_give_the_same_bits) {
  ModelSpec spec = cut_wall();
  spec.solve.settle_ratio = 1e-3;
  const Ran one = solved(spec);
  Ran two{compile(spec), {}, {}};
  two.state = initial_state(two.model);
  SolveOptions options;
  options.threads = 2;
  EXPECT_EQ(solve(two.model, two.state, options).state_hash, one.result.state_hash);
}

// The path and the problem of the first fault.
std::string fault_of(const ModelSpec& spec) {
  try {
    (void)compile(spec);
  } catch (const InputError& error) {
    return error.faults().front().path + ": " + error.faults().front().problem;
  }
  return "none";
}

TEST(Cutting, what_cannot_be_is_refused_with_its_place) {
  ModelSpec spec = cut_wall();
  spec.wall.opening[0].cut = "later";
  EXPECT_EQ(fault_of(spec), "wall.opening.0.cut: no stage has this name");
  spec.wall.opening[0].cut = "precompression";
  EXPECT_EQ(fault_of(spec), "wall.opening.0.cut: is a load stage");
  spec = cut_wall();
  std::swap(spec.stage[0], spec.stage[2]);
  EXPECT_EQ(fault_of(spec), "wall.opening.0.cut: comes before gravity: nothing stands there yet");
  spec = cut_wall();
  spec.wall.opening[0].arch.kind = ArchKind::kSegmental;
  spec.wall.opening[0].arch.rise = 0.05;
  spec.wall.opening[0].arch.depth = 0.11;
  EXPECT_EQ(fault_of(spec), "wall.opening.0.cut: an arch cannot be laid into standing masonry");
  spec = wall_with_zones();
  spec.wall.opening[1].cut = "cut";
  EXPECT_EQ(fault_of(spec),
            "wall.opening.1.lintel.model: is put in by a stage, and deformable blocks stand from "
            "the first stage on");
  spec = cut_wall();
  spec.solve.contacts = Contacts::kFree;
  EXPECT_NE(fault_of(spec).find("solve.contacts: does not go with openings that a stage cuts"),
            std::string::npos);
  spec = cut_wall();
  spec.stage.push_back(scenes::push_stage("cut0_0", Direction::kPlusX, 0.02, 1e-3));
  EXPECT_EQ(fault_of(spec), "stage.3.at: pushes masonry that a stage cuts out");
}

// The part of a floor on masonry that goes would hang in the air; a load or an inertia alone, in a line or in joists.
TEST(Cutting, a_floor_on_masonry_that_goes_is_refused_with_its_opening) {
  const std::string fault =
      "floor.0: lies at x = 0.542 m on masonry that stage \"cut\" cuts out for opening \"window\"";
  for (const bool inertia : {false, true}) {
    ModelSpec spec = cut_wall();
    FloorSpec floor;
    floor.y = 4 * 0.11;
    (inertia ? floor.mass : floor.load) = 1e3;
    spec.floor.push_back(floor);
    EXPECT_EQ(fault_of(spec), fault);
    spec.floor[0].joists = {0.2, 0.5425};
    EXPECT_EQ(fault_of(spec), fault);
    spec.floor[0].joists = {0.2};
    EXPECT_NO_THROW((void)compile(spec));
  }
}

TEST(Cutting, a_stage_that_cuts_nothing_is_told) {
  ModelSpec spec = built_wall();
  const Model model = compile(spec);
  bool told = false;
  for (const Message& note : model.anatomy.notes) told = told || note.code == "cut.nothing";
  EXPECT_TRUE(told);
}

}  // namespace
}  // namespace wythe::verification::cutting_test
