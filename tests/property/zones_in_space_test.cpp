// Deformable blocks of walls in space: momentum, pressure through unmatched faces, the limit of the
// step, the same bits from threads, lanes and restarts, a lintel of zones against a chain, and refusals.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "dynamics/meters/residual.h"
#include "geometry/builder/builder.h"
#include "reading/zones.h"
#include "scenes/run.h"
#include "scenes/space_rig.h"
#include "scenes/zones_in_space.h"
#include "wythe/parts/builder.h"
#include "wythe/parts/error.h"
#include "wythe/parts/solve.h"

namespace wythe::zones_in_space_test {
namespace {

using scenes::Column;
using scenes::Outcome;
using scenes::run;
using scenes::SpaceRig;

Vec3 node_velocity(const State& s, std::size_t i) {
  return {s.node_vx[i], s.node_vy[i], s.node_vz[i]};
}
Vec3 node_now(const Model& m, const State& s, std::size_t i) {
  return m.space.solids.node[i] + Vec3{s.node_ux[i], s.node_uy[i], s.node_uz[i]};
}

struct Momenta {
  Vec3 linear, angular;
};
Momenta momenta(const SpaceRig& rig) {
  const Model& m = rig.model;
  const State& s = rig.state;
  Momenta sum;
  const auto add = [&](double mass, Vec3 place, Vec3 velocity) {
    sum.linear = sum.linear + mass * velocity;
    sum.angular = sum.angular + mass * cross(place, velocity);
  };
  for (std::size_t i = 0; i < m.mass.size(); ++i) {
    add(m.mass[i], m.space.centroid[i] + rig.moved(i), {s.vx[i], s.vy[i], s.vz[i]});
    sum.angular = sum.angular + rig.momentum(i);
  }
  for (std::size_t i = 0; i < s.node_vz.size(); ++i)
    add(m.space.solids.node_mass[i], node_now(m, s, i), node_velocity(s, i));
  return sum;
}

// A column of zones with its cap that spins in the air, shaken by a blow on one node.
TEST(ZonesInSpace, a_free_body_keeps_its_momenta_and_its_energy) {
  SpaceRig rig(
      compile(scenes::column_of_zones({.zones = 4, .poisson_ratio = 0.2, .on_floor = false})));
  rig.controls.damping = 0;
  rig.controls.dt = 0.2 * 2 / rig.model.omega_max;
  const Vec3 spin{3, -2, 5}, about{0, 0.5, 0};
  for (std::size_t i = 0; i < rig.state.node_vx.size(); ++i) {
    const Vec3 v = cross(spin, rig.model.space.solids.node[i] - about);
    rig.state.node_vx[i] = v.x, rig.state.node_vy[i] = v.y, rig.state.node_vz[i] = v.z;
  }
  rig.state.node_vx[3] += 0.5, rig.state.node_vy[3] -= 0.8, rig.state.node_vz[3] += 0.3;
  rig.set_velocity(0, cross(spin, rig.model.space.centroid[0] - about));
  const Vec3 inertia = rig.model.space.inertia[0];
  rig.set_momentum(0, {inertia.x * spin.x, inertia.y * spin.y, inertia.z * spin.z});
  rig.load_state();
  const Momenta before = momenta(rig);
  double energy = 0, least = 1e300, most = 0;
  for (int k = 0; k < 40; ++k) {
    for (int n = 0; n < 200; ++n) rig.advance();
    rig.store_state();
    const EnergyLedger now = dynamics::energy_ledger(rig.model, rig.state, 1);
    energy = now.kinetic + now.elastic;
    least = std::fmin(least, energy), most = std::fmax(most, energy);
  }
  const Momenta after = momenta(rig);
  EXPECT_LT(length(after.linear - before.linear), 1e-11 * length(before.linear));
  EXPECT_LT(length(after.angular - before.angular), 1e-11 * length(before.angular));
  EXPECT_LT((most - least) / energy, 5e-3);  // swings with the square of the step
  // it has turned, and it deforms
  EXPECT_GT(length(rig.moved(0)), 0.05);
  EXPECT_GT(dynamics::elastic_energy(rig.model, rig.state), 1e-4 * energy);
}

// A slab of zones between a floor and two blocks whose joint lies anywhere: pressed evenly, every node is in balance.
TEST(ZonesInSpace, an_even_pressure_passes_through_faces_that_do_not_match) {
  constexpr double kE = 1e9, kKn = 50e9, kStrain = 1e-7, kHigh = 0.3;
  for (const PointRule rule : {PointRule::kLobatto, PointRule::kTrapezoid, PointRule::kCorners}) {
    std::vector<BodySpec> bodies{scenes::box_body("floor", {-1, -0.2, -1}, {2, 0, 2}, true),
                                 scenes::box_body("slab", {0, 0, 0}, {0.8, kHigh, 0.5}),
                                 scenes::box_body("left", {0, kHigh, 0}, {0.37, 0.5, 0.5}),
                                 scenes::box_body("right", {0.37, kHigh, 0}, {0.8, 0.5, 0.5})};
    bodies[1].material = "stuff";
    bodies[1].zone.zones = 2;
    bodies[1].zone.length = 0.11;
    ModelSpec spec = scenes::in_space(bodies, scenes::elastic_joint(kKn, 20e9));
    spec.material["stuff"] = scenes::elastic_body(kE, 0, 500);
    spec.solve.point_rule = rule;
    spec.solve.points_per_face = rule == PointRule::kCorners ? 2 : 3;
    SpaceRig rig(compile(spec));
    const SpaceSolids& s = rig.model.space.solids;
    ASSERT_GT(s.n_contact, 30);
    const double gap = kE * kStrain / kKn;  // of each joint
    for (std::size_t i = 0; i < s.node.size(); ++i)
      rig.state.node_uy[i] = -gap - kStrain * s.node[i].y;
    for (const std::size_t block : {0, 1}) rig.state.uy[block] = -2 * gap - kStrain * kHigh;
    rig.controls.damping = 0;
    rig.load_state();
    rig.step();
    const double pressure = kE * kStrain, force = pressure * 0.11 * 0.11;
    for (std::size_t i = 0; i < s.node.size(); ++i) {
      const double f = length(node_velocity(rig.state, i)) * s.node_mass[i] / rig.controls.dt;
      EXPECT_LT(f, 1e-6 * force) << "node " << i;
    }
    for (const SpaceZoneReading& zone : read_space_zones(rig.model, rig.state))
      EXPECT_NEAR(zone.stress[1], -pressure, 1e-6 * pressure);
    double pressed = 0, area = 0;
    for (const JointReading& joint : read_wall(rig.model, rig.state).joints)
      if (joint.shape.id >= rig.model.n_joint && joint.shape.a == kGroundBlock) {
        pressed += joint.compression;
        area += joint.shape.area;
      }
    EXPECT_NEAR(area, 0.4, 1e-9);
    EXPECT_NEAR(pressed, pressure * 0.4, 1e-6 * pressure);
  }
}

// At the bound a wall that nothing damps rattles on for ever; at twice the step it flies apart.
TEST(ZonesInSpace, the_step_holds_and_is_not_wasteful) {
  for (const double stuff : {1e9, 100e9}) {  // ruled by the joints, by the zones
    const ModelSpec spec = scenes::column_of_zones(
        {.zones = 3, .zone_length = 0.07, .youngs_modulus = stuff, .poisson_ratio = 0.3});
    const auto speed_after = [&](double of_bound) {
      SpaceRig rig(compile(spec));
      rig.controls.damping = 0;
      rig.controls.dt = of_bound * 2 / rig.model.omega_max;
      for (std::size_t i = 0; i < rig.state.node_vx.size(); ++i) {
        const double n = static_cast<double>(i);
        rig.state.node_vx[i] = 1e-6 * std::sin(3 * n);
        rig.state.node_vy[i] = 1e-6 * std::cos(5 * n);
        rig.state.node_vz[i] = 1e-6 * std::sin(7 * n + 1);
      }
      rig.load_state();
      for (int k = 0; k < 4000; ++k) rig.advance();
      rig.store_state();
      double most = 0;
      for (std::size_t i = 0; i < rig.state.node_vx.size(); ++i) {
        const double v = length(node_velocity(rig.state, i));
        most = v < 1e9 ? std::fmax(most, v) : 1e9;  // also where it is no number
      }
      return most;
    };
    EXPECT_LT(speed_after(0.999), 1e-4) << stuff;
    EXPECT_GT(speed_after(2.0), 1) << stuff;
  }
}

// --- a wall with a window -------------------------------------------------------------------------------------

// A wall of 14 courses with a window under a lintel of oak, loaded on top, then pushed askew.
ModelSpec window_wall(LintelModel kind, double until = 0.3e-3) {
  ModelSpec spec;
  spec.wall.unit.density = 1800;
  spec.material["joint"] = scenes::paper_joint();
  spec.material["oak"] = scenes::elastic_body(8e9, 0.2, 600);
  PlanWallSpec wall;
  wall.name = "front", wall.line = {{0, 0}, {2, 0}};
  wall.height = 1.4, wall.thickness = 0.2, wall.fit = "cut";
  wall.unit.length = 0.4, wall.unit.height = 0.1, wall.unit.split = Split::kNone;
  OpeningSpec window;
  window.x = 0.6, window.y = 0.4, window.width = 0.8, window.height = 0.4;
  window.lintel.kind = "timber", window.lintel.depth = 0.1, window.lintel.bearing = 0.2;
  window.lintel.material = "oak", window.lintel.model = kind;
  wall.opening = {window};
  std::vector<Message> notes;
  FaultList faults;
  const BuilderSpec builder{.plan_wall = {wall}, .slab = {}, .arch = {}, .dome = {}};
  for (geometry::BuiltBody& body : geometry::build_bodies({builder, spec}, notes, faults))
    spec.body.push_back(std::move(body.body));
  faults.throw_if_any();
  StageSpec load{.name = "load",
                 .action = LoadStage{.pressure = 0.2e6, .on = {.block = "front.c13*"}}};
  StageSpec push = scenes::push_stage("front.c12*", Direction::kPlusX, 0.02, until);
  push.get<PushStage>().drive.along = {1, 0, 0.3};
  spec.stage = {scenes::gravity_stage(), load, push};
  return spec;
}

TEST(ZonesInSpace, a_lintel_of_zones_bears_as_a_chain_does) {
  // loaded and left to settle: a fast push would compare their inertia
  const auto loaded = [](LintelModel kind) {
    ModelSpec spec = window_wall(kind);
    spec.stage.resize(2);
    return run(spec);
  };
  const Outcome chain = loaded(LintelModel::kSegments), zones = loaded(LintelModel::kZones);
  ASSERT_EQ(chain.result.status, SolveStatus::kCompleted) << chain.result.reason;
  ASSERT_EQ(zones.result.status, SolveStatus::kCompleted) << zones.result.reason;
  EXPECT_EQ(zones.model.space.solids.bodies.size(), 1U);
  EXPECT_NEAR(zones.model.weight / chain.model.weight, 1, 1e-9);
  EXPECT_LT(zones.result.energy.gap_ratio, 1e-3);
  // what stands on the lintel sinks as far in both
  const auto sag = [](const Outcome& end) {
    double most = 0;
    for (BlockId b = 0; b < end.model.n_block; ++b)
      if (end.model.anatomy.block_id[b].find(".c09") != std::string::npos)
        most = std::fmax(most, -read_block(end.model, end.state, b).moved.y);
    return most;
  };
  ASSERT_GT(sag(chain), 0);
  EXPECT_NEAR(sag(zones) / sag(chain), 1, 0.1);
  EXPECT_GT(reading::strain_energy(zones.model, zones.state), 0);
}

TEST(ZonesInSpace, threads_change_no_bit) {
  const Model model = compile(window_wall(LintelModel::kZones));
  std::string first;
  for (const int threads : {1, 2, 3}) {
    State state = initial_state(model);
    dynamics::space::SpaceProcessor processor(model, 1, threads);
    dynamics::Controls controls;
    controls.dt = 0.5 * 2 / model.omega_max;
    controls.damping = 0.5;
    controls.push = &model.stages[2];
    controls.drive_velocity = 0.05;
    state.gravity_y = -9.81;
    state.load_scale[1] = 1;
    processor.load_wall(0, model, state);
    processor.access(0)->choose_driven(model.stages[2].driven);
    for (int k = 0; k < 300; ++k) {
      processor.set(0, controls);
      processor.step();
    }
    processor.access(0)->store_state(state);
    const std::string now = state_hash(state) + std::to_string(state.energy.work_damping) +
                            std::to_string(state.energy.dissipated_friction);
    if (first.empty()) first = now;
    EXPECT_EQ(now, first) << threads;
    EXPECT_GT(state.energy.dissipated_friction + state.energy.dissipated_fracture, 0);
  }
}

// The same numbers as kept in a store.
TEST(ZonesInSpace, a_copied_state_goes_on_with_the_same_bits) {
  const Model model = compile(window_wall(LintelModel::kZones, 0.1e-3));
  const auto prepare = [](SpaceRig& rig) {
    rig.set_gravity({0, -9.81, 0});
    rig.state.load_scale[1] = 1;
    rig.drive(2, 0.05);
  };
  SpaceRig whole(model);
  prepare(whole);
  whole.load_state();
  for (int k = 0; k < 400; ++k) whole.step();
  const State saved = whole.state;
  for (int k = 0; k < 400; ++k) whole.step();
  SpaceRig resumed(model);
  prepare(resumed);
  resumed.state = saved;
  resumed.load_state();
  for (int k = 0; k < 400; ++k) resumed.step();
  EXPECT_EQ(state_hash(resumed.state), state_hash(whole.state));
  EXPECT_GT(whole.state.energy.dissipated_friction + whole.state.energy.dissipated_fracture, 0);
}

// --- what is refused --------------------------------------------------------------------------------------------

std::string faults_of(const ModelSpec& spec) {
  try {
    (void)compile(spec);
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}
void expect_fault(const ModelSpec& spec, const std::string& words) {
  const std::string said = faults_of(spec);
  EXPECT_NE(said.find(words), std::string::npos) << words << " in: " << said;
}

TEST(ZonesInSpace, what_zones_cannot_do_is_refused_by_name) {
  const Column column;
  ModelSpec spec = scenes::column_of_zones(column);
  spec.body[1].part = {
      scenes::prism_part({{-0.1, 0}, {0.1, 0}, {0.1, 1}, {-0.05, 1}, {-0.1, 0.5}}, -0.05, 0.05)};
  expect_fault(spec, "needs a hexahedron");
  spec = scenes::column_of_zones(column);
  spec.body[1].zone.kind = ZoneKind::kCst;
  expect_fault(spec, "in space there is one kind");
  spec = scenes::column_of_zones(column);
  spec.body[1].zone.plane = Plane::kStrain;
  expect_fault(spec, "walls in their plane");
  spec = scenes::column_of_zones(column);
  spec.body[0].zone.zones = 1;
  expect_fault(spec, "would deform a support");
  spec = scenes::column_of_zones(column);
  spec.body[1].zone.zones = 900;
  spec.body[1].zone.length = 0.01;
  expect_fault(spec, "more than 20000 zones");
  spec = scenes::column_of_zones(column);
  spec.body[1].zone.zones = 300;
  expect_fault(spec, "too thin");
  spec = scenes::column_of_zones(column);
  spec.material["stuff"].shear_modulus = kUnset;
  expect_fault(spec, "shear_modulus");
  spec = scenes::column_of_zones(column);
  spec.body[2].zone.zones = 1, spec.body[2].material = "stuff";
  expect_fault(spec, "every moving block is cut into zones");
  spec.body.push_back(scenes::box_body("top", {-0.1, 1.1, -0.05}, {0.1, 1.2, 0.05}));
  expect_fault(spec, "two blocks of zones touch each other");
  spec = scenes::column_of_zones(column);
  spec.solve.contacts = Contacts::kFree;
  expect_fault(spec, "free contacts know rigid blocks alone");
  spec = scenes::column_of_zones(column);
  spec.stage = {scenes::gravity_stage(), scenes::push_stage("column", Direction::kPlusX, 0.01, 1)};
  expect_fault(spec, "loads and pushes act on rigid blocks");
  StageSpec load{.name = "load", .action = LoadStage{.force = 1000, .at = {.block = "column"}}};
  spec.stage = {load};
  expect_fault(spec, "loads and pushes act on rigid blocks");
  FloorSpec floor;
  floor.from.x = -0.1, floor.from.y = 1, floor.from.z = 0;
  floor.to = floor.from;
  floor.to.x = 0.1;
  floor.load = 1000;
  spec = scenes::column_of_zones(column);
  spec.stage = {scenes::gravity_stage(), load};
  spec.stage[1].get<LoadStage>().at.block = "cap";
  spec.floor = {floor};
  expect_fault(spec, "loads act on rigid blocks");
}

}  // namespace
}  // namespace wythe::zones_in_space_test
