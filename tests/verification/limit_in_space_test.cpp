// Limit analysis of bodies in space: closed forms, the same walls in their plane, turned walls, and cases without a solution.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "limit/in_space.h"
#include "record.h"
#include "scenes/places.h"
#include "scenes/scenes.h"
#include "wythe/parts/builder.h"
#include "wythe/parts/error.h"
#include "wythe/parts/io.h"
#include "wythe/parts/limit.h"

namespace wythe::limit_in_space_test {
namespace {

using scenes::box;
using verification::verify;

constexpr double kG = 9.81, kDensity = 2000;

BodySpec floor_slab() { return box("floor", {-2, -0.2, -2}, {4, 0.2, 4}, true); }

StageSpec body_force(Vec3 along) {
  return {.name = "force",
          .action = BodyForceStage{
              .drive = {.along = {along.x, along.y, along.z}}, .rate = 0.1, .factor = 2}};
}

ModelSpec block_on_slab(Vec3 size, double mu, Vec3 along) {
  ModelSpec spec =
      scenes::in_space({floor_slab(), box("b", {-0.5 * size.x, 0, -0.5 * size.z}, size)},
                       scenes::dry_joint(1e9, 4e8, std::atan(mu)), kDensity);
  spec.stage = {scenes::gravity_stage(), body_force(along)};
  return spec;
}

LimitResult answer_of(const ModelSpec& spec, const LimitOptions& options = {}) {
  LimitResult answer = limit_load(compile(spec), options);
  EXPECT_NEAR(answer.kinematic / answer.load, 1, 1e-6);
  return answer;
}

TEST(LimitInSpace, a_block_slides_alike_in_twelve_directions) {
  for (int k = 0; k < 12; ++k) {
    const double angle = k * M_PI / 6 + 0.1;
    const LimitResult answer =
        answer_of(block_on_slab({0.4, 0.02, 0.3}, 0.6, {std::cos(angle), 0, std::sin(angle)}));
    verify({"LP-S1",
            "limit load of a block that slides, at " + std::to_string(30 * k) + " + 5.7 degrees",
            "-", 0.6, 1e-6, "1e-6: what both theorems may differ by"},
           answer.load);
    EXPECT_LE(answer.friction_excess, 1e-6);
  }
}

TEST(LimitInSpace, a_block_overturns_about_each_edge) {
  for (const auto& [along, ratio] : {std::pair(Vec3{1, 0, 0}, 0.3 / 1.2),
                                     {Vec3{0, 0, 1}, 0.2 / 1.2},
                                     {Vec3{0, 0, -1}, 0.2 / 1.2}}) {
    const ModelSpec spec = block_on_slab({0.3, 1.2, 0.2}, 2.0, along);
    verify(
        {"LP-S2", "limit load of a block that overturns", "-", ratio, 1e-7, "interior point, 1e-9"},
        answer_of(spec).load);
    verify({"LP-S2", "the same in a turned world", "-", ratio, 1e-7, "interior point, 1e-9"},
           answer_of(scenes::turned_about_y(spec, 0.4)).load);
  }
}

// Its whole bed pulls at ft when it turns about its edge.
TEST(LimitInSpace, a_bonded_block_tears_at_its_bed) {
  ModelSpec spec = block_on_slab({0.3, 1.2, 0.2}, 2.0, {1, 0, 0});
  JointMaterial& joint = spec.material.begin()->second;
  joint.tensile_strength = 50e3;
  joint.cohesion = 1e6;
  joint.mode_1_energy = 4, joint.mode_2_energy = 3000;
  const double weight = kDensity * 0.3 * 1.2 * 0.2 * kG;
  const double expected = (0.5 * 0.3 * (weight + 50e3 * 0.3 * 0.2)) / (0.6 * weight);
  verify({"LP-S3", "limit load of a bonded block that overturns", "-", expected, 1e-7,
          "interior point, 1e-9"},
         answer_of(spec, {.strength = JointStrength::kBonded}).load);
}

//      [   ]          a parapet of 0.2 m, its middle plane 0.1 m beside that of the wall: it falls about the edge of what
//   [     ]           both share, at 0.15 m towards one side and at 0 m towards the other
//   [     ]
TEST(LimitInSpace, a_region_beside_the_walls_middle_plane_falls_about_the_edge_of_its_bed) {
  PlanWallSpec wall;
  wall.name = "a", wall.line = {{0, 0}, {1, 0}}, wall.height = 1.2, wall.thickness = 0.3;
  wall.unit.length = 0.5, wall.unit.height = 0.1, wall.unit.split = Split::kNone;
  PlanRegionSpec parapet;
  parapet.place.x = 0, parapet.place.y = 0.6;
  parapet.place.width = 1, parapet.place.height = 0.6;
  parapet.thickness = 0.2, parapet.offset = 0.1;
  wall.region = {parapet};
  for (const auto& [way, arm] : {std::pair(1.0, 0.05), {-1.0, 0.1}}) {
    ModelSpec spec = scenes::in_space({}, scenes::dry_joint(1e9, 4e8, std::atan(2.0)), kDensity);
    spec.wall.blocks = "";
    lay_bodies({.plan_wall = {wall}, .slab = {}, .arch = {}, .dome = {}}, spec);
    spec.stage = {scenes::gravity_stage(), body_force({0, 0, way})};
    verify({"LP-S7", "limit load of a thinner part beside the wall's middle plane", "-", arm / 0.3,
            1e-7, "interior point, 1e-9"},
           answer_of(spec).load);
  }
}

TEST(LimitInSpace, walls_of_prisms_have_the_limit_loads_of_their_plane) {
  for (const char* name : {"wall1", "wall2", "wall4"}) {
    const ModelSpec plane = read_model(source_dir() + "/validation/ferris_tinloi_walls/model.toml",
                                       {std::string("wall.blocks=data/") + name + ".json"});
    const double flat = limit_load(compile(plane), {}).load;
    ModelSpec solid = scenes::prisms(plane);
    double lowest = 1e9;
    for (const BodySpec& body : solid.body)
      for (const Polyhedron& part : body.part)
        for (const Vec3& v : part.vertex) lowest = std::fmin(lowest, v.y);
    solid.body.push_back(box("ground", {-50, lowest - 1, -5}, {100, 1, 10}, true));
    verify({"LP-S4", std::string("limit load of Ferris and Tin-Loi's ") + name + " as prisms", "-",
            flat, 1e-6, "1e-6: what both theorems may differ by"},
           answer_of(solid).load);
  }
}

TEST(LimitInSpace, joint_forces_balance_every_block_and_respect_friction) {
  const Model m = compile(read_model(source_dir() + "/examples/wall_with_returns/model.toml"));
  const LimitResult answer = limit_load(m, {});
  EXPECT_NEAR(answer.kinematic / answer.load, 1, 1e-6);
  const Space& s = m.space;
  std::vector<Vec3> force(static_cast<std::size_t>(m.n_block)), moment(force.size());
  for (std::size_t i = 0; i < force.size(); ++i)
    force[i] = m.gravity_mass[i] * m.solve.gravity *
               (Vec3{0, -1, 0} + answer.load * m.stages.back().drive());
  for (int j = 0; j < m.n_joint; ++j) {
    const auto u = static_cast<std::size_t>(j);
    const Vec3 t2 = cross(s.normal[u], s.tangent[u]);
    const double mu = std::tan(m.materials[m.joint_material[u]].friction_angle);
    for (int p = s.point_begin[u]; p < s.point_begin[u + 1]; ++p) {
      const auto k = static_cast<std::size_t>(p);
      const double n = answer.point_force[k], s1 = answer.shear_force[k],
                   s2 = answer.shear_force_2[k];
      EXPECT_GE(n, -1e-4);
      EXPECT_LE(std::hypot(s1, s2), mu * n * (1 + 1.01 * answer.friction_excess) + 1e-4);
      const Vec3 f = n * s.normal[u] + s1 * s.tangent[u] + s2 * t2;
      const Vec3 r = s.point_r1[k] * s.tangent[u] + s.point_r2[k] * t2;
      for (const auto& [block, sign, arm] : {std::tuple(m.joint_a[u], -1.0, s.arm_a[u]),
                                             std::tuple(m.joint_b[u], 1.0, s.arm_b[u])}) {
        if (block == kGroundBlock || block >= m.n_block) continue;
        const auto b = static_cast<std::size_t>(block);
        force[b] = force[b] + sign * f;
        moment[b] = moment[b] + sign * cross(arm + r, f);
      }
    }
  }
  for (std::size_t i = 0; i < force.size(); ++i) {
    EXPECT_LT(length(force[i]), 1e-3) << i;  // of blocks of some 500 N
    EXPECT_LT(length(moment[i]), 1e-3) << i;
  }
  // the mechanism does the load unit power, and no face closes in it
  double power = 0;
  for (std::size_t i = 0; i < force.size(); ++i)
    power += m.gravity_mass[i] * m.solve.gravity *
             dot(m.stages.back().drive(), Vec3{answer.vx[i], answer.vy[i], answer.vz[i]});
  EXPECT_NEAR(power, 1, 1e-6);
}

TEST(LimitInSpace, what_a_run_carries_is_below_its_limit_load) {
  ModelSpec spec = read_model(source_dir() + "/examples/wall_with_returns/model.toml");
  const double one = answer_of(spec).load;
  verify({"LP-S5", "limit load of the wall with returns, turned by 30 degrees", "-", one, 1e-6,
          "1e-6: what both theorems may differ by"},
         answer_of([&] {
           *scenes::along_of(spec.stage.back()) = {0, 0, -1};
           return scenes::turned_about_y(spec, M_PI / 6);
         }())
             .load);
  EXPECT_GT(one, 0.345);  // of the run, docs of the example
  EXPECT_LT(one, 0.345 / 0.8);
}

TEST(LimitInSpace, a_tilt_is_the_angle_whose_tangent_a_body_force_has) {
  ModelSpec spec = block_on_slab({0.4, 0.02, 0.3}, 0.6, {0.6, 0, 0.8});
  const double force = answer_of(spec).load;
  spec.stage.back().action = TiltStage{.drive = drive_of(spec.stage.back()), .tilt_until = 0.7};
  EXPECT_NEAR(answer_of(spec).load, force, 1e-6);
}

// At no tilt the wind is carried; over the cosine of the limit tilt it would not be.
TEST(LimitInSpace, a_tilted_wall_stands_at_rest_under_the_loads_it_has_there) {
  ModelSpec spec = block_on_slab({0.4, 0.4, 0.4}, 2, {0, 0, 1});
  const double weight = kDensity * 0.4 * 0.4 * 0.4 * kG;
  // towards -z, it falls at 1
  const StageSpec wind{.name = "wind",
                       .action = LoadStage{.pressure = 0.5 * weight / (0.4 * 0.4), .face = "+z"}};
  spec.stage.insert(spec.stage.begin() + 1, wind);
  spec.stage.back().action = TiltStage{.drive = drive_of(spec.stage.back()), .tilt_until = 1.5};
  // sin t - 0.5 = cos t: the wind keeps its direction beside a weight that turns
  const double t = M_PI / 4 + std::asin(0.5 / std::sqrt(2.0));
  EXPECT_NEAR(answer_of(spec).load, std::tan(t), 1e-4 * std::tan(t));
}

TEST(LimitInSpace, circles_that_were_not_reached_are_noted) {
  const Model model = compile(block_on_slab({0.4, 0.1, 0.2}, 0.6, {1, 0, 0}));
  SecondOpinion opinion;
  opinion.limits.push_back({"dry", {}});
  EXPECT_TRUE(notes_on(model, opinion).empty());
  opinion.limits.back().answer.friction_excess = 0.03;
  ASSERT_EQ(notes_on(model, opinion).size(), 1u);
  EXPECT_EQ(notes_on(model, opinion).front().code, "limit.friction_circles");
}

TEST(LimitInSpace, dry_says_that_units_count_as_cracked_there_too) {
  const auto planes = [](const std::string& split) {
    const ModelSpec spec = parse_model(R"(
wall = { height = "0.6 m", thickness = "0.15 m", unit = { length = "300 mm", height = "100 mm", density = "2000 kg/m^3", split = ")" +
                                           split + R"(" } }
plan_wall = [{ name = "front", line = [["0 m", "0 m"], ["1.2 m", "0 m"]] }]
[material.joint]
use = "limestone_dry"
normal_stiffness = "5 GPa/m"
shear_stiffness = "2 GPa/m"
residual_friction_tan = 0.6
compressive_strength = "unlimited"
[material.unit]
normal_stiffness = "5 GPa/m"
shear_stiffness = "2 GPa/m"
tensile_strength = "1 MPa"
mode_1_energy = "500 N/m"
cohesion = "2 MPa"
mode_2_energy = "5000 N/m"
residual_cohesion = "0 MPa"
friction_tan = 0.6
residual_friction_tan = 0.6
compressive_strength = "unlimited"
[[stage]]
name = "gravity"
[[stage]]
name = "push"
rate = "0.1 1/s"
direction = "+z"
factor = 1
)",
                                       "wall.toml");
    SecondOpinion opinion;
    opinion.limits.push_back({"dry", {}});
    const std::vector<Message> notes = notes_on(compile(spec), opinion);
    return notes.empty() ? 0 : notes.front().number("planes");
  };
  EXPECT_EQ(planes("middle"), 6 * 4 - 3);  // every second course has a half unit at each end
  EXPECT_EQ(planes("none"), 0);
}

TEST(LimitInSpace, a_push_on_a_block_is_a_force) {
  ModelSpec spec = block_on_slab({0.4, 0.1, 0.2}, 0.6, {1, 0, 0});
  spec.stage.back() = scenes::push_stage("b", Direction::kPlusX, 2e-3, 1e-3);
  spec.stage.back().get<PushStage>().drive.along = {0.6, 0, 0.8};
  for (const Freedom rotation : {Freedom::kFree, Freedom::kBlocked})
    for (const Manner manner : {Manner::kSpreader, Manner::kEach}) {
      spec.stage.back().get<PushStage>().fixity.rotation = rotation;
      spec.stage.back().get<PushStage>().as = manner;
      verify(
          {"LP-S6", "limit force of a pushed block that slides", "N",
           0.6 * kDensity * 0.4 * 0.1 * 0.2 * kG, 1e-6, "1e-6: what both theorems may differ by"},
          answer_of(spec).load);
    }
}

// Its floor slides, its stones turn: two seconds.
TEST(LimitInSpace, a_house_carries_what_both_theorems_say_and_more_than_its_run) {
  const LimitResult answer =
      limit_load(compile(read_model(source_dir() + "/examples/stone_house/model.toml")), {});
  EXPECT_NEAR(answer.kinematic / answer.load, 1, 1e-7);
  EXPECT_EQ(answer.cuts, 0);
  EXPECT_LE(answer.friction_excess, 1e-6);
  EXPECT_GT(answer.load, 23.7e3);  // the run, README.md of the example
}

std::string fault_of(const ModelSpec& spec, const LimitOptions& options = {}) {
  try {
    (void)limit_load(compile(spec), options);
  } catch (const InputError& error) {
    return error.what();
  }
  return "no fault";
}

TEST(LimitInSpace, what_has_no_limit_load_is_refused_by_name) {
  const auto has = [](const std::string& text, const std::string& part) {
    return text.find(part) != std::string::npos;
  };
  ModelSpec spec = block_on_slab({0.4, 0.1, 0.2}, 0.6, {1, 0, 0});
  EXPECT_TRUE(has(fault_of(spec, {.crushing = CrushingChoice::kStressBlock}), "stress block"));
  ModelSpec bare = spec;
  bare.stage.pop_back();
  EXPECT_TRUE(has(fault_of(bare), "no stage has a load that grows"));
  ModelSpec support = spec;
  support.stage.back() = scenes::push_stage("floor", Direction::kPlusX, 2e-3, 1e-3);
  EXPECT_TRUE(has(fault_of(support), "moves a support"));
  ModelSpec pressed = spec;
  pressed.stage.back() = scenes::push_stage("b", Direction::kMinusY, 2e-3, 1e-3);
  EXPECT_TRUE(has(fault_of(pressed), "between floor and b")) << fault_of(pressed);
  ModelSpec overhung = pressed;  // no limit either, but the ledge falls all the same
  overhung.body.push_back(box("ledge", {0.1, 0.1, -0.1}, {0.5, 0.1, 0.2}));
  EXPECT_TRUE(has(fault_of(overhung), "ledge: cannot stand")) << fault_of(overhung);
  // dead loads that topple it: it stands only where the force holds it up, and so has no strength
  ModelSpec pushed_over = block_on_slab({1, 2, 0.4}, 0.65, {0, 0, 1});
  StageSpec wind{.name = "wind", .action = LoadStage{.pressure = 5e3, .face = "+z"}};
  pushed_over.stage.insert(pushed_over.stage.begin() + 1, wind);
  EXPECT_TRUE(has(fault_of(pushed_over), "cannot stand under the dead loads alone"))
      << fault_of(pushed_over);
  ModelSpec flying = spec;
  flying.body.push_back(box("kite", {1, 1, 1}, {0.1, 0.1, 0.1}));
  EXPECT_TRUE(has(fault_of(flying), "kite")) << fault_of(flying);
}

// The eight facets that once stood for a circle let a stone stand that slides: between two of them it was passed by 8 %.
TEST(LimitInSpace, a_stone_stands_below_the_friction_of_its_bed_and_not_above) {
  const double size = 0.4, weight = kDensity * size * size * size * kG;
  for (const double share : {0.59, 0.61}) {
    ModelSpec blown = block_on_slab({size, size, size}, 0.6, {1, 0, 0});
    for (const auto& [face, part] :
         {std::pair("+x", std::cos(M_PI / 8)), {"+z", std::sin(M_PI / 8)}}) {
      StageSpec wind{
          .name = std::string("wind on ") + face,
          .action = LoadStage{.pressure = share * weight * part / (size * size), .face = face}};
      blown.stage.insert(blown.stage.end() - 1, wind);
    }
    const std::string fault = fault_of(blown);
    EXPECT_EQ(fault.find("cannot stand under the dead loads alone") == std::string::npos,
              share < 0.6)
        << fault;
  }
}

}  // namespace
}  // namespace wythe::limit_in_space_test
