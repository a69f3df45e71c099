// Walls in space: loads at points and along lines, floors, ties, springs and diaphragms, and refusals.
#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

#include "scenes/scenes.h"
#include "scenes/space_rig.h"
#include "wythe/parts/error.h"
#include "wythe/parts/io.h"
#include "wythe/parts/limit.h"
#include "wythe/parts/reading.h"
#include "wythe/parts/solve.h"

namespace wythe::space_loads_test {
namespace {

using scenes::box;

constexpr double kG = 9.81, kDensity = 2000;

PlaceSpec at(double x, double y, double z) {
  PlaceSpec place;
  place.x = x, place.y = y, place.z = z;
  return place;
}
PlaceSpec block(const std::string& id) {
  PlaceSpec place;
  place.block = id;
  return place;
}

StageSpec load_stage(const std::string& name, LoadStage load) {
  return {.name = name, .ramp = 0.3, .action = std::move(load)};
}

// Two courses along x, 1.2 m long, 0.3 m thick (z from 0 to 0.3), three stones each, in stack bond.
ModelSpec two_courses(double friction_degrees = 35) {
  std::vector<BodySpec> bodies{box("ground", {-1, -0.2, -1}, {4, 0.2, 3}, true)};
  for (int c = 0; c < 2; ++c)
    for (int u = 0; u < 3; ++u)
      bodies.push_back(box("c" + std::to_string(c) + "u" + std::to_string(u), {0.4 * u, 0.3 * c, 0},
                           {0.4, 0.3, 0.3}));
  ModelSpec spec = scenes::in_space(
      bodies, scenes::dry_joint(2e10, 8e9, scenes::degrees(friction_degrees)), kDensity);
  spec.stage = {scenes::gravity_stage()};
  spec.solve.settle_ratio = 1e-8;
  return spec;
}

struct Ran {
  Model model;
  State state;
  Result result;
};
Ran solved(const ModelSpec& spec) {
  Ran r{compile(spec), {}, {}};
  r.state = initial_state(r.model);
  r.result = solve(r.model, r.state);
  return r;
}

// The joint under a block, and what it carries.
JointReading under(const Ran& r, const std::string& id) {
  for (const JointReading& joint : read_wall(r.model, r.state).joints)
    if (joint.shape.b == scenes::block_named(r.model, id) && std::fabs(joint.shape.normal.y) > 0.9)
      return joint;
  throw std::runtime_error("no joint under " + id);
}

std::string faults_of(const ModelSpec& spec) {
  try {
    (void)compile(spec);
  } catch (const InputError& error) {
    std::string all;
    for (const Fault& f : error.faults())
      all += f.path + " [" + f.value + "] " + f.problem + "; " + f.cure + "\n";
    return all;
  }
  return "";
}

// --- loads ----------------------------------------------------------------------------------------

TEST(SpaceLoads, a_force_at_a_point_presses_with_its_eccentricity) {
  ModelSpec spec = two_courses();
  // 40 mm off the middle of c1u1
  spec.stage.push_back(load_stage("hook", {.force = 3000, .at = at(0.6, 0.6, 0.19)}));
  const Ran r = solved(spec);
  ASSERT_EQ(r.result.status, SolveStatus::kCompleted);
  const double weight = kDensity * kG * 0.4 * 0.3 * 0.3;
  const JointReading joint = under(r, "c1u1");
  EXPECT_NEAR(joint.compression, weight + 3000, 1e-4 * weight);
  EXPECT_NEAR(joint.moment, 3000 * 0.04, 1e-3 * 120);
  EXPECT_NEAR(under(r, "c1u0").compression, weight, 1e-4 * weight);
}

TEST(SpaceLoads, a_force_goes_where_along_says) {
  ModelSpec spec = two_courses();
  spec.stage.push_back(load_stage("wind", {.force = 100, .at = block("c1u1"), .along = {0, 0, 2}}));
  const Ran r = solved(spec);
  ASSERT_EQ(r.result.status, SolveStatus::kCompleted);
  EXPECT_NEAR(under(r, "c1u1").shear, 100, 0.01);
}

// A window: the sill lies below the head, and is pressed only where it is named.
TEST(SpaceLoads, a_pressure_presses_the_faces_that_nothing_stands_before) {
  ModelSpec spec = two_courses();
  spec.body = {box("ground", {-1, -0.2, -1}, {4, 0.2, 3}, true),
               box("left", {0, 0, 0}, {0.4, 0.6, 0.3}), box("right", {0.8, 0, 0}, {0.4, 0.6, 0.3}),
               box("sill", {0.4, 0, 0}, {0.4, 0.3, 0.3}),
               box("head", {0, 0.6, 0}, {1.2, 0.3, 0.3})};
  spec.stage.push_back(load_stage("snow", {.pressure = 10e3}));
  const auto pressed = [&] {
    const Model model = compile(spec);
    std::vector<std::string> ids;
    for (const PointLoad& load : model.stages[1].loads)
      ids.push_back(model.anatomy.block_id[load.block]);
    return ids;
  };
  EXPECT_EQ(pressed(), std::vector<std::string>{"head"});
  // not the reveal of the right pier, which looks at the left one
  spec.stage.back().get<LoadStage>().face = "-x";
  EXPECT_EQ(pressed(), (std::vector<std::string>{"left", "head"}));
  spec.stage.back().get<LoadStage>().face = "";
  spec.stage.back().get<LoadStage>().on = block("sill");
  EXPECT_EQ(pressed(), std::vector<std::string>{"sill"});
  spec.stage.back().get<LoadStage>().on = block("*");  // names all, and says so
  EXPECT_EQ(pressed(), (std::vector<std::string>{"sill", "head"}));
}

// What stands before a part of a face takes that part alone, wherever the middle of the face lies.
TEST(SpaceLoads, a_pressure_presses_the_open_part_of_a_face) {
  const auto force_on = [](std::vector<BodySpec> above, const std::string& id) {
    ModelSpec spec = two_courses();
    spec.body = {box("ground", {-1, -0.2, -1}, {8, 0.2, 8}, true),
                 box("slab", {0, 0, 0}, {6, 0.2, 3})};
    for (BodySpec& body : above) spec.body.push_back(body);
    spec.stage.push_back(load_stage("snow", {.pressure = 10e3}));
    const Model model = compile(spec);
    double force = 0;
    for (const PointLoad& load : model.stages[1].loads)
      if (model.anatomy.block_id[load.block] == id) force -= load.fy;
    return force;
  };
  EXPECT_NEAR(force_on({}, "slab"), 180e3, 1e-6);
  // two slabs of a roof that meet over the middle of the floor
  EXPECT_EQ(
      force_on({box("post", {0, 0.2, 0}, {0.3, 2, 3}), box("post 2", {5.7, 0.2, 0}, {0.3, 2, 3}),
                box("roof", {0, 2.2, 0}, {3, 0.2, 3}), box("roof 2", {3, 2.2, 0}, {3, 0.2, 3})},
               "slab"),
      0);
  // a ridge beam over its middle leaves the most of it open
  EXPECT_GT(force_on({box("ridge", {2.9, 0.2, 0}, {0.2, 0.2, 3})}, "slab"), 80e3);
}

TEST(SpaceLoads, a_line_load_falls_to_each_block_by_the_length_on_it) {
  ModelSpec spec = two_courses();
  spec.stage.push_back(load_stage(
      "wall above", {.line_load = 10e3, .from = at(0.3, 0.6, 0.12), .to = at(1.2, 0.6, 0.12)}));
  const Model model = compile(spec);
  const auto& loads = model.stages[1].loads;
  ASSERT_EQ(loads.size(), 3U);
  const double force[] = {1e3, 4e3, 4e3}, arm_x[] = {0.15, 0, 0};
  for (std::size_t k = 0; k < 3; ++k) {
    EXPECT_EQ(loads[k].block, scenes::block_named(model, "c1u" + std::to_string(k)));
    EXPECT_NEAR(loads[k].fy, -force[k], 1e-9);
    EXPECT_NEAR(loads[k].arm_x, arm_x[k], 1e-12);
    EXPECT_NEAR(loads[k].arm_y, 0.15, 1e-12);
    EXPECT_NEAR(loads[k].arm_z, -0.03, 1e-12);  // 30 mm off the middle: an eccentricity
  }
  // head joints pass some on, and the ground bears it all
  const Ran r = solved(spec);
  ASSERT_EQ(r.result.status, SolveStatus::kCompleted);
  double on_ground = 0;
  for (const char* id : {"c0u0", "c0u1", "c0u2"}) on_ground += under(r, id).compression;
  EXPECT_NEAR(on_ground, 9e3 + 6 * kDensity * kG * 0.4 * 0.3 * 0.3, 1);
}

TEST(SpaceLoads, a_line_on_the_edge_of_two_leaves_is_shared) {
  ModelSpec spec = scenes::in_space(
      {box("ground", {-1, -0.2, -1}, {4, 0.2, 3}, true), box("front", {0, 0, 0}, {1, 0.5, 0.2}),
       box("back", {0, 0, 0.2}, {1, 0.5, 0.2})},
      scenes::dry_joint(2e10, 8e9, 0.6), kDensity);
  spec.stage = {
      scenes::gravity_stage(),
      load_stage("line", {.line_load = 4e3, .from = at(0, 0.5, 0.2), .to = at(1, 0.5, 0.2)})};
  const Model model = compile(spec);
  ASSERT_EQ(model.stages[1].loads.size(), 2U);
  for (const PointLoad& load : model.stages[1].loads) EXPECT_NEAR(load.fy, -2e3, 1e-9);
}

TEST(SpaceLoads, a_line_that_lies_on_nothing_is_refused_with_the_gap) {
  ModelSpec spec = two_courses();
  spec.body.erase(spec.body.begin() + 5);  // c1u1: an opening
  spec.stage.push_back(
      load_stage("line", {.line_load = 4e3, .from = at(0, 0.6, 0.15), .to = at(1.2, 0.6, 0.15)}));
  EXPECT_NE(faults_of(spec).find("from 0.400 to 0.800 m"), std::string::npos) << faults_of(spec);
  spec = two_courses();
  spec.stage.push_back(
      load_stage("line", {.line_load = 4e3, .from = at(0, 0.75, 0.15), .to = at(1.2, 0.75, 0.15)}));
  EXPECT_NE(faults_of(spec).find("the nearest is 0.150 m off"), std::string::npos)
      << faults_of(spec);
}

TEST(SpaceLoads, a_force_beside_the_wall_or_on_a_support_is_refused) {
  ModelSpec spec = two_courses();
  spec.stage.push_back(load_stage("a", {.force = 1, .at = at(0.6, 0.9, 0.15)}));
  EXPECT_NE(faults_of(spec).find("stage.1.at [(0.6, 0.9, 0.15) m] lies on no block"),
            std::string::npos)
      << faults_of(spec);
  spec.stage.back().get<LoadStage>().at = block("ground");
  EXPECT_NE(faults_of(spec).find("one block that moves"), std::string::npos);
  spec.stage.back().get<LoadStage>().at = block("c1*");
  EXPECT_NE(faults_of(spec).find("one block that moves"), std::string::npos);
}

// --- floors ---------------------------------------------------------------------------------------

FloorSpec floor_on_top() {
  FloorSpec floor;
  floor.name = "first";
  floor.from = at(0, 0.6, 0.1);
  floor.to = at(1.2, 0.6, 0.1);
  floor.load = 5e3;
  return floor;
}

TEST(SpaceFloors, gravity_sets_them_and_they_bear_off_the_middle) {
  ModelSpec spec = two_courses();
  spec.floor = {floor_on_top()};
  spec.floor[0].mass = 500;
  const Ran r = solved(spec);
  ASSERT_EQ(r.result.status, SolveStatus::kCompleted);
  const double weight = kDensity * kG * 0.4 * 0.3 * 0.3, part = 5e3 * 0.4;
  EXPECT_NEAR(under(r, "c1u2").compression, weight + part, 0.5);
  EXPECT_NEAR(under(r, "c1u2").moment, part * 0.05, 0.1);
  const auto top = static_cast<std::size_t>(scenes::block_named(r.model, "c1u0"));
  EXPECT_NEAR(r.model.mass[top] - r.model.gravity_mass[top], 500 * 0.4, 1e-9);
}

TEST(SpaceFloors, joists_share_the_load_and_one_over_a_joint_lies_on_both_blocks) {
  ModelSpec spec = two_courses();
  spec.floor = {floor_on_top()};
  spec.floor[0].joists = {0.2, 0.8};
  const Model model = compile(spec);
  const auto& loads = model.stages[0].loads;
  ASSERT_EQ(loads.size(), 3U);
  EXPECT_NEAR(loads[0].fy, -3e3, 1e-9);
  EXPECT_NEAR(loads[1].fy, -1.5e3, 1e-9);
  EXPECT_NEAR(loads[2].fy, -1.5e3, 1e-9);
  spec.floor[0].joists = {0.2, 1.5};
  EXPECT_NE(faults_of(spec).find("beyond the end of the line"), std::string::npos)
      << faults_of(spec);
}

TEST(SpaceFloors, keys_of_the_plane_are_refused_here_and_those_of_space_there) {
  ModelSpec spec = two_courses();
  spec.floor = {floor_on_top()};
  spec.floor[0].y = 0.6, spec.floor[0].thrust = 10;
  EXPECT_NE(faults_of(spec).find("floor.0.y"), std::string::npos);
  EXPECT_NE(faults_of(spec).find("floor.0.thrust"), std::string::npos);
  ModelSpec plane = scenes::small_wall();
  plane.floor = {floor_on_top()};
  plane.floor[0].y = 0.88;
  EXPECT_NE(faults_of(plane).find("floor.0.from"), std::string::npos) << faults_of(plane);
  plane = scenes::small_wall();
  plane.stage[1].get<LoadStage>().force = 10;
  plane.stage[1].get<LoadStage>().at.block = "b0";
  EXPECT_NE(faults_of(plane).find("stage.1.force"), std::string::npos) << faults_of(plane);
}

TEST(SpaceFloors, a_push_by_mass_counts_the_floors_that_lie_on_it) {
  ModelSpec spec = two_courses();
  spec.floor = {floor_on_top()};
  StageSpec push = scenes::push_stage("", Direction::kPlusX, 0.01, 1e-3);
  push.get<PushStage>().pattern = Pattern::kMass;
  spec.stage.push_back(push);
  const Model model = compile(spec);
  const double own = kDensity * 0.4 * 0.3 * 0.3, with = own + 5e3 * 0.4 / kG;
  EXPECT_NEAR(model.stages[1].driven_share[3] / model.stages[1].driven_share[0], with / own, 1e-9);
}

// --- ties, springs, diaphragms --------------------------------------------------------------------

TieSpec tie_between(PlaceSpec from, PlaceSpec to, bool anchored) {
  TieSpec tie;
  tie.name = "tie";
  tie.from = from, tie.to = to;
  tie.anchored = anchored;
  tie.area = 1e-4;
  tie.youngs_modulus = 200e9;
  return tie;
}

TEST(SpaceLinks, forces_and_moments_are_the_slope_of_the_energy) {
  for (const bool spring : {false, true}) {
    ModelSpec spec = scenes::in_space(
        {box("ground", {-5, -0.2, -5}, {9, 0.2, 9}, true), box("a", {0, 0, 0}, {0.5, 0.4, 0.3}),
         box("b", {1.5, 0, 1}, {0.5, 0.6, 0.4})},
        scenes::dry_joint(1e9, 1e9, 0.5), kDensity);
    if (spring) {
      SpringSpec s;
      s.at = at(1.6, 0.5, 1.4);
      s.stiffness = 1e6;
      s.direction = Direction::kMinusZ;
      spec.spring = {s};
    } else {
      spec.tie = {tie_between(at(0.4, 0.35, 0.3), at(1.6, 0.1, 1.0), false)};
    }
    spec.stage = {scenes::gravity_stage()};
    scenes::SpaceRig rig(compile(spec));
    // each block somewhere else, turned by more than half a radian
    const double moved[2][3] = {{-0.2, 0.6, -0.3}, {0.1, 0.7, 0.35}};
    const Vec3 spin[2] = {{0.3, -0.5, 0.2}, {-0.2, 0.4, 0.5}};
    const auto put = [&](State& s, int block, int component, double by) {
      for (std::size_t i = 0; i < 2; ++i) {
        double u[3] = {moved[i][0], moved[i][1], moved[i][2]};
        Quaternion<double> q{std::sqrt(1 - dot(spin[i], spin[i]) / 4),
                             {spin[i].x / 2, spin[i].y / 2, spin[i].z / 2}};
        if (static_cast<int>(i) == block && component < 3) u[component] += by;
        if (static_cast<int>(i) == block && component >= 3) {
          double v[3] = {0, 0, 0};
          v[component - 3] = std::sin(by / 2);
          q = Quaternion<double>{std::cos(by / 2), {v[0], v[1], v[2]}} * q;
        }
        s.ux[i] = u[0], s.uy[i] = u[1], s.uz[i] = u[2];
        s.qw[i] = q.w, s.qx[i] = q.v.x, s.qy[i] = q.v.y, s.qz[i] = q.v.z;
      }
    };
    const auto energy = [&](int block, int component, double by) {
      State s = rig.state;
      put(s, block, component, by);
      const LinkReading link = read_links(rig.model, s)[0];
      return 0.5 * link.force * link.force / link.stiffness;
    };
    put(rig.state, -1, 0, 0);
    ASSERT_GT(energy(-1, 0, 0), 1);
    rig.controls.dt = 1e-9, rig.controls.damping = 0;
    rig.load_state();
    rig.step();
    double pull = 0;
    for (std::size_t i = 0; i < 2; ++i) {
      const auto id = static_cast<int>(i);
      const double mass = rig.model.mass[i] / rig.controls.dt, turn = 1 / rig.controls.dt;
      const double of[6] = {mass * rig.state.vx[i], mass * rig.state.vy[i], mass * rig.state.vz[i],
                            turn * rig.state.lx[i], turn * rig.state.ly[i], turn * rig.state.lz[i]};
      pull = std::fmax(pull, std::hypot(of[0], of[1], of[2]));
      for (int c = 0; c < 6; ++c) {
        const double slope = (energy(id, c, 1e-6) - energy(id, c, -1e-6)) / 2e-6;
        EXPECT_NEAR(of[c], -slope, 1e-5 * pull + 1e-2)
            << (spring ? "spring" : "tie") << " block " << i << " component " << c;
      }
    }
    EXPECT_GT(pull, 1e4);
  }
}

// A block 0.4 m deep and 2 m high overturns about its edge: lambda W h/2 = W t/2 + N h of a tie at its top.
TEST(SpaceLinks, a_tie_across_the_wall_adds_its_yield_force_to_the_limit_load) {
  for (const double side : {-1.0, 1.0}) {
    ModelSpec spec = scenes::in_space(
        {box("ground", {-1, -0.2, -3}, {4, 0.2, 6}, true), box("wall", {0, 0, 0}, {1.5, 2, 0.4})},
        scenes::dry_joint(20e9, 8e9, scenes::degrees(60)), kDensity);
    StageSpec quake{
        .name = "quake",
        .action = BodyForceStage{.drive = {.along = {0, 0, 1}}, .rate = 0.5, .factor = 5}};
    spec.stage = {scenes::gravity_stage(), quake};
    spec.tie = {tie_between(at(0.7, 2, side < 0 ? 0.0 : 0.4), at(0.7, 2, 2 * side), true)};
    spec.tie[0].yield_strength = 10e6;  // 1 kN
    const LimitResult answer = limit_load(compile(spec), {.strength = JointStrength::kDry});
    const double weight = kDensity * kG * 1.5 * 2 * 0.4, force = side < 0 ? 1e3 : 0;
    EXPECT_NEAR(answer.load, 0.2 + 2 * force / weight, 1e-6);
    EXPECT_NEAR(answer.kinematic, answer.load, 1e-6);
    EXPECT_NEAR(answer.link_force.at(0), force, 1e-3);
  }
}

TEST(SpaceLinks, a_dead_line_load_is_in_the_limit_load) {
  // a load off the middle holds a wall that overturns: lambda W h/2 = W t/2 + q l (t - e)
  ModelSpec spec = scenes::in_space(
      {box("ground", {-1, -0.2, -3}, {4, 0.2, 6}, true), box("wall", {0, 0, 0}, {1.5, 2, 0.4})},
      scenes::dry_joint(20e9, 8e9, scenes::degrees(60)), kDensity);
  const StageSpec line =
      load_stage("line", {.line_load = 8e3, .from = at(0, 2, 0.1), .to = at(1.5, 2, 0.1)});
  const StageSpec quake{
      .name = "quake",
      .action = BodyForceStage{.drive = {.along = {0, 0, 1}}, .rate = 0.5, .factor = 5}};
  spec.stage = {scenes::gravity_stage(), line, quake};
  const double weight = kDensity * kG * 1.5 * 2 * 0.4;
  const LimitResult answer = limit_load(compile(spec), {.strength = JointStrength::kDry});
  EXPECT_NEAR(answer.load, 0.2 + 8e3 * 1.5 * 0.3 / weight, 1e-6);
}

TEST(SpaceLinks, a_tie_holds_a_wall_that_is_pushed_off_and_the_ledger_closes) {
  ModelSpec spec = two_courses(5);
  spec.tie = {tie_between(block("c1u1"), at(0.6, 0.45, -2), true)};
  spec.tie[0].yield_strength = 20e6;  // 2 kN, at 0.215 mm
  StageSpec push = scenes::push_stage("c1u1", Direction::kPlusZ, 0.002, 0.5e-3);
  push.damping = 0.2;
  spec.stage.push_back(push);
  const Ran r = solved(spec);
  ASSERT_EQ(r.result.status, SolveStatus::kCompleted);
  const LinkReading link = read_links(r.model, r.state)[0];
  EXPECT_NEAR(link.force, 2000, 1e-6);
  EXPECT_NEAR(link.plastic, 0.5e-3 - 20e6 / 200e9 * 2.15, 3e-6);
  const double friction = std::tan(scenes::degrees(5)) * kDensity * kG * 0.4 * 0.3 * 0.3;
  EXPECT_NEAR(r.result.curve.back().reaction, 2000 + friction, 20);
  EXPECT_NEAR(r.result.curve.back().base_shear, 2000 + friction, 20);  // of anchor and ground
  EXPECT_LT(r.result.energy.gap_ratio, 2e-3);
  EXPECT_EQ(r.result.strengthening.links.size(), r.result.curve.size());
}

TEST(SpaceLinks, prestress_presses_the_stones_and_loses_what_the_joint_yields) {
  ModelSpec spec = scenes::in_space(
      {box("ground", {-1, -0.2, -1}, {4, 0.2, 3}, true), box("left", {0, 0, 0}, {0.3, 0.5, 1}),
       box("right", {0.3, 0, 0}, {0.3, 0.5, 1})},
      scenes::dry_joint(1e9, 1e9, 1e-9), kDensity);
  spec.solve.settle_ratio = 1e-9;
  spec.tie = {tie_between(at(0.05, 0.25, 0.5), at(0.55, 0.25, 0.5), false)};
  spec.tie[0].area = 0.03;
  spec.tie[0].prestress = 1e6;
  spec.stage = {scenes::gravity_stage()};
  const Ran r = solved(spec);
  ASSERT_EQ(r.result.status, SolveStatus::kCompleted);
  const double tie = 200e9 * 0.03 / 0.5, joint = 1e9 * 0.5;
  EXPECT_NEAR(read_links(r.model, r.state)[0].force, 30e3 / (1 + tie / joint),
              1e-4 * 30e3 / (1 + tie / joint));
}

TEST(SpaceLinks, a_rigid_diaphragm_takes_the_other_wall_along) {
  std::vector<BodySpec> bodies{box("ground", {-1, -0.2, -1}, {4, 0.2, 5}, true)};
  for (const int wall : {0, 1})
    for (int k = 0; k < 4; ++k)
      bodies.push_back(box("w" + std::to_string(wall) + std::to_string(k),
                           {0, 0.25 * k, 2.0 * wall}, {0.6, 0.25, 0.3}));
  ModelSpec spec = scenes::in_space(bodies, scenes::elastic_joint(1e9, 0.4e9), kDensity);
  StageSpec push = scenes::push_stage("w03", Direction::kPlusZ, 0.01, 0.5e-3);
  spec.stage = {scenes::gravity_stage(), push};
  const auto moved = [](const Ran& r) { return r.state.uz[scenes::block_named(r.model, "w13")]; };
  const Ran alone = solved(spec);
  EXPECT_LT(std::fabs(moved(alone)), 1e-6);
  DiaphragmSpec floor;
  floor.y = 0.9;
  floor.x = {0.3, 0.3}, floor.z = {0.25, 2.05};
  floor.kind = DiaphragmKind::kRigid;
  spec.diaphragm = {floor};
  const Ran rigid = solved(spec);
  EXPECT_NEAR(moved(rigid), 0.5e-3, 0.15 * 0.5e-3);
  EXPECT_GT(rigid.result.time_step, 0.9 * alone.result.time_step);
  spec.diaphragm[0].z = {0.25};
  EXPECT_NE(faults_of(spec).find("diaphragm.0.z"), std::string::npos) << faults_of(spec);
}

// Places of a model file are in the axes of its blocks file: the same wall with z up, whose bodies reading has turned.
TEST(SpaceLinks, places_mean_the_same_with_z_up) {
  ModelSpec y_up = two_courses();
  DiaphragmSpec bar;
  bar.y = 0.5, bar.x = {0.2, 1.0}, bar.z = {0.1, 0.2};
  bar.stiffness = 1e6;
  y_up.diaphragm = {bar};
  y_up.tie = {tie_between(at(0.6, 0.45, 0.3), at(0.6, 0.45, 2), true)};
  SpringSpec spring;
  spring.at = at(0.2, 0.5, 0.3);
  spring.stiffness = 1e6;
  spring.direction = Direction::kPlusZ;
  y_up.spring = {spring};
  y_up.stage.push_back(
      load_stage("line", {.line_load = 1e3, .from = at(0, 0.6, 0.1), .to = at(1.2, 0.6, 0.2)}));
  ModelSpec z_up = y_up;
  z_up.wall.up = "z";
  const auto turned = [](PlaceSpec& p) { p = at(p.x, -p.z, p.y); };
  z_up.diaphragm[0].z = {-0.1, -0.2};
  turned(z_up.tie[0].from), turned(z_up.tie[0].to), turned(z_up.spring[0].at);
  z_up.spring[0].direction = Direction::kMinusY;
  turned(z_up.stage[1].get<LoadStage>().from), turned(z_up.stage[1].get<LoadStage>().to);
  const Model a = compile(y_up), b = compile(z_up);
  ASSERT_EQ(a.links.n, 3);
  for (const auto array :
       {&Links::arm_a_x, &Links::arm_a_y, &Links::arm_a_z, &Links::arm_b_x, &Links::arm_b_y,
        &Links::arm_b_z, &Links::span_x, &Links::span_y, &Links::span_z})
    for (std::size_t k = 0; k < 3; ++k)
      EXPECT_NEAR((a.links.*array)[k], (b.links.*array)[k], 1e-12);
  ASSERT_EQ(a.stages[1].loads.size(), b.stages[1].loads.size());
  for (std::size_t k = 0; k < a.stages[1].loads.size(); ++k) {
    EXPECT_NEAR(a.stages[1].loads[k].arm_z, b.stages[1].loads[k].arm_z, 1e-12);
    EXPECT_NEAR(a.stages[1].loads[k].fy, b.stages[1].loads[k].fy, 1e-9);
  }
}

TEST(SpaceLinks, ends_that_hold_nothing_are_refused_by_name) {
  ModelSpec spec = two_courses();
  spec.tie = {tie_between(block("ground"), block("c1u1"), false)};
  EXPECT_NE(faults_of(spec).find("is a support"), std::string::npos) << faults_of(spec);
  spec.tie = {tie_between(at(0.6, 0.9, 0.1), block("c1u1"), false)};
  EXPECT_NE(faults_of(spec).find("lies off the wall"), std::string::npos) << faults_of(spec);
  spec.tie = {tie_between(at(0.6, 0.5, kUnset), block("c1u1"), false)};
  EXPECT_NE(faults_of(spec).find("must be one point"), std::string::npos) << faults_of(spec);
  ModelSpec plane = scenes::tied(scenes::small_wall());
  plane.tie[0].from.z = 0.1;
  EXPECT_NE(faults_of(plane).find("tie.0.from"), std::string::npos) << faults_of(plane);
  plane = scenes::tied(scenes::small_wall());
  plane.spring[0].direction = Direction::kPlusZ;
  EXPECT_NE(faults_of(plane).find("spring.0.direction"), std::string::npos) << faults_of(plane);
}

// --- in files -------------------------------------------------------------------------------------

TEST(SpaceLoads, a_load_stage_knows_which_keys_go_together) {
  const auto faults = [](const std::string& keys) {
    try {
      (void)parse_model("name = \"x\"\n[[stage]]\nname = \"s\"\n" + keys, "model.toml");
    } catch (const InputError& error) {
      std::string all;
      for (const Fault& f : error.faults()) all += f.path + " " + f.problem + "\n";
      return all;
    }
    return std::string();
  };
  EXPECT_NE(faults("line_load = \"1 kN/m\"").find("from is missing"), std::string::npos)
      << faults("line_load = \"1 kN/m\"");
  EXPECT_NE(faults("force = \"1 kN\"").find("at is missing"), std::string::npos);
  EXPECT_NE(faults("pressure = \"1 kPa\"\nforce = \"1 kN\"").find("more than one"),
            std::string::npos);
  EXPECT_NE(faults("pressure = \"1 kPa\"\nalong = [0, 0, 1]").find("along has no say"),
            std::string::npos);
  EXPECT_NE(faults("pressure = \"1 kPa\"\nat = { block = \"a\" }").find("there is none"),
            std::string::npos);
}

}  // namespace
}  // namespace wythe::space_loads_test
