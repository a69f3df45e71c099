// A sample's bits do not depend on lane, neighbours, number of lanes, threads or instruction set.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "dynamics/executors/lane_solver.h"
#include "scenes/scenes.h"
#include "scenes/small_study.h"
#include "scenes/zones.h"
#include "scenes/zones_in_space.h"
#include "wythe/parts/campaign.h"
#include "wythe/parts/error.h"
#include "wythe/parts/io.h"
#include "wythe/parts/lanes.h"

namespace wythe::lanes_test {
namespace {

using dynamics::LaneSolver;
using scenes::TemporaryFolder;

class ForcedLanes {
 public:
  explicit ForcedLanes(const std::string& lanes) { setenv("WYTHE_LANES", lanes.c_str(), 1); }
  ~ForcedLanes() { unsetenv("WYTHE_LANES"); }
};

TEST(Lanes, of_few_walls_are_no_more_than_they) {
  const ForcedLanes forced("4");
  EXPECT_EQ(lanes_for(1), 1);
  EXPECT_EQ(lanes_for(3), 3);
  EXPECT_EQ(lanes_for(9), 4);
}

// --- campaigns -----------------------------------------------------------------------------------

std::vector<SampleRecord> records(const StudySpec& study, const std::string& folder, int jobs) {
  CampaignOptions options;
  options.jobs = jobs;
  run_campaign(study, model_builder(study), folder, options, {});
  return read_campaign(folder).records;
}

void expect_same(const SampleRecord& a, const SampleRecord& b, const std::string& what) {
  EXPECT_EQ(a.state_hash, b.state_hash) << what;
  EXPECT_EQ(a.steps, b.steps) << what;
  EXPECT_EQ(a.energy.friction, b.energy.friction) << what;
  EXPECT_EQ(a.energy.fracture, b.energy.fracture) << what;
  EXPECT_EQ(a.energy.damping, b.energy.damping) << what;
  EXPECT_EQ(a.energy.loads, b.energy.loads) << what;
  ASSERT_EQ(a.curve.size(), b.curve.size()) << what;
  for (std::size_t k = 0; k < a.curve.size(); ++k) {
    ASSERT_EQ(a.curve[k].reaction, b.curve[k].reaction) << what << ", row " << k;
    ASSERT_EQ(a.curve[k].base_shear, b.curve[k].base_shear) << what << ", row " << k;
    ASSERT_EQ(a.curve[k].kinetic_ratio, b.curve[k].kinetic_ratio) << what << ", row " << k;
    ASSERT_EQ(a.curve[k].unbalance_ratio, b.curve[k].unbalance_ratio) << what << ", row " << k;
  }
}

TEST(Lanes, no_number_of_lanes_or_jobs_changes_a_bit_of_24_samples) {
  const TemporaryFolder folder;
  const StudySpec study = scenes::small_study(24);
  std::vector<SampleRecord> first;
  for (const char* lanes : {"1", "2", "4", "8"})
    for (const int jobs : {1, 2, 3}) {
      const ForcedLanes forced(lanes);
      const std::string what = std::string(lanes) + " lanes, jobs " + std::to_string(jobs);
      const auto now = records(study, folder / what, jobs);
      ASSERT_EQ(now.size(), 24U);
      if (first.empty()) first = now;
      for (std::size_t k = 0; k < now.size(); ++k)
        expect_same(now[k], first[k], what + ", sample " + std::to_string(k + 1));
    }
  // not all walls do the same
  EXPECT_NE(first[0].state_hash, first[1].state_hash);
  EXPECT_GT(first[0].energy.fracture, 0);
}

TEST(Lanes, a_sample_alone_has_the_bits_it_has_among_others) {
  const TemporaryFolder folder;
  const StudySpec study = scenes::small_study(5);
  const ForcedLanes forced("4");
  const auto together = records(study, folder / "out", 1);
  const SampleTable samples = draw_samples(study);
  for (int sample = 1; sample <= 5; ++sample) {
    const SampleRun alone = run_sample(study, samples, sample, model_builder(study), {});
    EXPECT_EQ(alone.result.state_hash, together[sample - 1].state_hash);
  }
}

// --- single walls --------------------------------------------------------------------------------

struct Wall {
  Model model;
  State state;
  std::string alone;  // state hash of the wall solved by itself
  // `haste` 1 keeps the stable step, 20 takes one twenty times as long.
  Wall(const ModelSpec& spec, double haste) : model(compile(spec)), state(initial_state(model)) {
    model.omega_max /= haste;
    State own = initial_state(model);
    alone = solve(model, own, {}).state_hash;
  }
};

// Joint strength is the wall's own; all share the geometry unless `columns` says otherwise.
std::unique_ptr<Wall> wall_of(double strength, int columns = 5, double haste = 1) {
  ModelSpec spec = scenes::plain_wall(columns, 7, 0.2e-3, 0.05);
  spec.material.at("joint").tensile_strength *= strength;
  spec.material.at("joint").cohesion *= strength;
  return std::make_unique<Wall>(spec, haste);
}

// Solves all walls with `width` lanes and compares every one with itself alone.
std::vector<Result> solve_together(std::vector<std::unique_ptr<Wall>>& walls, int width) {
  LaneSolver solver(width);
  std::vector<Result> results(walls.size());
  const SolveOptions options;
  std::size_t next = 0;
  while (next < walls.size() || solver.running() > 0) {
    for (; solver.has_room() && next < walls.size(); ++next)
      solver.add_wall(static_cast<int>(next), walls[next]->model, walls[next]->state, options);
    auto ended = solver.next();
    const auto k = static_cast<std::size_t>(ended.ticket);
    results[k] = std::move(ended.result);
    // what is not a number has no bits to compare
    if (results[k].status == SolveStatus::kUnstable) continue;
    EXPECT_EQ(results[k].state_hash, walls[k]->alone) << "wall " << k << ", width " << width;
    EXPECT_EQ(state_hash(walls[k]->state), walls[k]->alone) << "wall " << k;
  }
  return results;
}

TEST(Lanes, a_wall_that_goes_unstable_leaves_its_neighbours_alone) {
  for (const int width : {2, 4, 8}) {
    std::vector<std::unique_ptr<Wall>> walls;
    for (const double strength : {1.0, 1.1, 0.9, 1.2, 0.8}) walls.push_back(wall_of(strength));
    walls.insert(walls.begin() + 1, wall_of(1.0, 5, 20));
    const std::vector<Result> results = solve_together(walls, width);
    for (std::size_t k = 0; k < results.size(); ++k)
      EXPECT_EQ(results[k].status, k == 1 ? SolveStatus::kUnstable : SolveStatus::kCompleted);
  }
}

TEST(Lanes, walls_that_do_not_fit_are_stepped_beside_the_others) {
  const auto five = wall_of(1.0), other = wall_of(1.2), six = wall_of(1.0, 6);
  EXPECT_TRUE(dynamics::fit_together(five->model, other->model));
  EXPECT_FALSE(dynamics::fit_together(five->model, six->model));
  std::vector<std::unique_ptr<Wall>> walls;
  for (const int columns : {5, 6, 5, 6, 6, 5, 7}) walls.push_back(wall_of(1.0, columns));
  solve_together(walls, 4);
}

TEST(Lanes, walls_with_deformable_lintels_too) {
  for (const int width : {2, 4, 8}) {
    std::vector<std::unique_ptr<Wall>> walls;
    for (const double strength : {1.0, 1.1, 0.9, 1.2, 0.8}) {
      ModelSpec spec = scenes::lintel_wall(LintelModel::kZones, 0.05e-3);
      spec.material.at("joint").tensile_strength *= strength;
      walls.push_back(std::make_unique<Wall>(spec, 1));
    }
    ASSERT_TRUE(dynamics::fit_together(walls[0]->model, walls[1]->model));
    solve_together(walls, width);
  }
  ModelSpec stiffer = scenes::lintel_wall(LintelModel::kZones, 0.05e-3);
  JointMaterial& timber = stiffer.material.at("timber");
  timber.youngs_modulus *= 2;
  timber.shear_modulus *= 2;
  EXPECT_FALSE(dynamics::fit_together(compile(stiffer),
                                      compile(scenes::lintel_wall(LintelModel::kZones, 0.05e-3))));
}

TEST(Lanes, shaken_walls_too) {
  for (const bool in_space : {false, true})
    for (const int width : {2, 8}) {
      std::vector<std::unique_ptr<Wall>> walls;
      for (const double amplitude : {8.0, 4.0, 12.0, 6.0, 10.0}) {
        ModelSpec spec = scenes::half_units({5, 6, 2, 2, 1}, scenes::paper_joint());
        spec.stage = {scenes::gravity_stage(), scenes::shake_stage(amplitude, 0.02)};
        walls.push_back(std::make_unique<Wall>(in_space ? scenes::prisms(spec) : spec, 1));
      }
      ASSERT_TRUE(dynamics::fit_together(walls[0]->model, walls[1]->model));
      EXPECT_NE(walls[0]->alone, walls[1]->alone);
      solve_together(walls, width);
    }
}

// Each kind of damping has tables of its own. A second shake, without elements, follows one with them.
TEST(Lanes, only_walls_with_the_same_kinds_of_dashpots_share_lanes) {
  for (const bool in_space : {false, true}) {
    const auto shaken = [&](double amplitude, bool elements, bool dashpots) {
      ModelSpec spec = scenes::half_units({5, 4, 2, 2, 1}, scenes::paper_joint());
      spec.stage = {scenes::gravity_stage(), scenes::shake_stage(amplitude, 0.02),
                    scenes::shake_stage(amplitude, 0.02)};
      spec.stage[2].name = "aftershock";
      for (const int k : {1, 2}) {
        ShakeStage& shake = spec.stage[k].get<ShakeStage>();
        if (!elements || k == 2) shake.maxwell_damping = {};
        if (!dashpots) shake.restitution = 1;
      }
      return in_space ? scenes::prisms(spec) : spec;
    };
    const Model both = compile(shaken(8, true, true)), one = compile(shaken(8, false, true)),
                none = compile(shaken(8, false, false));
    EXPECT_FALSE(dynamics::fit_together(both, one));
    EXPECT_FALSE(dynamics::fit_together(one, none));
    EXPECT_TRUE(dynamics::fit_together(both, compile(shaken(4, true, true))));
    std::vector<std::unique_ptr<Wall>> walls;
    for (const double amplitude : {8.0, 4.0, 6.0}) {
      walls.push_back(std::make_unique<Wall>(shaken(amplitude, true, true), 1));
      walls.push_back(std::make_unique<Wall>(shaken(amplitude, false, true), 1));
      walls.push_back(std::make_unique<Wall>(shaken(amplitude, false, false), 1));
    }
    solve_together(walls, 4);
  }
}

TEST(Lanes, walls_with_zones_in_space_too) {
  for (const int width : {2, 8}) {
    std::vector<std::unique_ptr<Wall>> walls;
    for (const double times : {1.0, 1.1, 0.9, 1.2, 0.8}) {
      ModelSpec spec = scenes::column_of_zones({.high = 0.4, .zones = 3, .zone_length = 0.1});
      spec.material["joint"] = scenes::paper_joint();
      spec.material["stuff"].youngs_modulus *= times;
      spec.material["stuff"].shear_modulus *= times;
      spec.stage = {scenes::gravity_stage(),
                    scenes::push_stage("cap", Direction::kPlusX, 0.02, 0.2e-3)};
      walls.push_back(std::make_unique<Wall>(spec, 1));
    }
    ASSERT_TRUE(dynamics::fit_together(walls[0]->model, walls[1]->model));
    EXPECT_NE(walls[0]->alone, walls[1]->alone);
    solve_together(walls, width);
  }
}

TEST(Lanes, walls_with_ties_too) {
  for (const int width : {2, 4, 8}) {
    std::vector<std::unique_ptr<Wall>> walls;
    for (const double area : {1.0, 1.1, 0.9, 1.2, 0.8}) {
      ModelSpec spec = scenes::tied(scenes::small_wall(0.1e-3, 0.05));
      spec.tie[0].area *= area;
      walls.push_back(std::make_unique<Wall>(spec, 1));
    }
    ASSERT_TRUE(dynamics::fit_together(walls[0]->model, walls[1]->model));
    EXPECT_NE(walls[0]->alone, walls[1]->alone);
    solve_together(walls, width);
  }
  ModelSpec fewer = scenes::tied(scenes::small_wall(0.1e-3, 0.05));
  fewer.tie.pop_back();
  EXPECT_FALSE(dynamics::fit_together(compile(fewer),
                                      compile(scenes::tied(scenes::small_wall(0.1e-3, 0.05)))));
}

TEST(Lanes, walls_with_frames_too) {
  for (const int width : {2, 4, 8}) {
    std::vector<std::unique_ptr<Wall>> walls;
    for (const double strength : {1.0, 1.1, 0.9, 1.2, 0.8}) {
      ModelSpec spec = scenes::framed(scenes::small_wall(0.1e-3, 0.05));
      spec.frame[0].yield_strength *= strength;
      walls.push_back(std::make_unique<Wall>(spec, 1));
    }
    ASSERT_TRUE(dynamics::fit_together(walls[0]->model, walls[1]->model));
    EXPECT_NE(walls[0]->alone, walls[1]->alone);
    solve_together(walls, width);
  }
  EXPECT_FALSE(dynamics::fit_together(compile(scenes::small_wall(0.1e-3, 0.05)),
                                      compile(scenes::framed(scenes::small_wall(0.1e-3, 0.05)))));
}

TEST(Lanes, walls_in_space_with_frames_too) {
  const auto wall = [](double strength) {
    ModelSpec spec = scenes::framed(scenes::small_wall(0.1e-3, 0.05));
    spec.stage.erase(spec.stage.begin() + 1);  // what presses on piers is of the plane
    spec.stage.back().get<PushStage>().at.x = 0.05;
    spec.frame[0].yield_strength *= strength;
    return scenes::along_a_line(spec);
  };
  for (const int width : {2, 4, 8}) {
    std::vector<std::unique_ptr<Wall>> walls;
    for (const double strength : {1.0, 1.1, 0.9, 1.2, 0.8})
      walls.push_back(std::make_unique<Wall>(wall(strength), 1));
    ASSERT_TRUE(dynamics::fit_together(walls[0]->model, walls[1]->model));
    EXPECT_NE(walls[0]->alone, walls[1]->alone);
    solve_together(walls, width);
  }
}

TEST(Lanes, walls_with_layers_too) {
  for (const int width : {2, 4, 8}) {
    std::vector<std::unique_ptr<Wall>> walls;
    for (const double strength : {1.0, 1.1, 0.9, 1.2, 0.8}) {
      ModelSpec spec = scenes::layered(scenes::small_wall(0.1e-3, 0.05));
      spec.layer[0].fibres.strength *= strength;
      walls.push_back(std::make_unique<Wall>(spec, 1));
    }
    ASSERT_TRUE(dynamics::fit_together(walls[0]->model, walls[1]->model));
    EXPECT_NE(walls[0]->alone, walls[1]->alone);
    solve_together(walls, width);
  }
  EXPECT_FALSE(dynamics::fit_together(compile(scenes::small_wall(0.1e-3, 0.05)),
                                      compile(scenes::layered(scenes::small_wall(0.1e-3, 0.05)))));
}

// Walls whose fields differ share a topology, alone and in lanes.
std::vector<std::unique_ptr<Wall>> walls_with_fields() {
  std::vector<std::unique_ptr<Wall>> walls;
  for (const int seed : {1, 2, 3, 4, 5})
    walls.push_back(std::make_unique<Wall>(
        scenes::with_fields(scenes::plain_wall(5, 7, 0.2e-3, 0.05), seed), 1));
  EXPECT_TRUE(dynamics::fit_together(walls[0]->model, walls[1]->model));
  EXPECT_NE(walls[0]->alone, walls[1]->alone);
  return walls;
}

TEST(Lanes, walls_with_fields_keep_the_bits_of_those_alone) {
  for (const int width : {2, 4, 8}) {
    auto walls = walls_with_fields();
    solve_together(walls, width);
  }
  // a plain wall has other laws: beside them
  auto walls = walls_with_fields();
  walls.push_back(wall_of(1.0));
  solve_together(walls, 4);
}

TEST(Lanes, walls_with_fields_and_a_deformable_lintel_too) {
  std::vector<std::unique_ptr<Wall>> walls;
  for (const int seed : {1, 2, 3})
    walls.push_back(std::make_unique<Wall>(
        scenes::with_fields(scenes::lintel_wall(LintelModel::kZones, 0.05e-3), seed), 1));
  ASSERT_TRUE(dynamics::fit_together(walls[0]->model, walls[1]->model));
  solve_together(walls, 4);
}

// In a study, by jobs and lanes, and each sample by itself.
TEST(Lanes, samples_with_fields_do_not_depend_on_lanes_or_jobs) {
  const TemporaryFolder folder;
  const StudySpec study =
      parse_study(write_study(scenes::small_study(5)) +
                      "[field.ft]\ncov = 0.2\nalong = \"0.5 m\"\nacross = \"0.2 m\"\nupper = 2\n",
                  "small_study.toml");
  const SampleTable samples = draw_samples(study);
  std::vector<SampleRecord> first;
  for (const char* lanes : {"1", "4"})
    for (const int jobs : {1, 2}) {
      const ForcedLanes forced(lanes);
      const std::string what = std::string(lanes) + " lanes, jobs " + std::to_string(jobs);
      const auto now = records(study, folder / what, jobs);
      ASSERT_EQ(now.size(), 5U);
      if (first.empty()) first = now;
      for (std::size_t k = 0; k < now.size(); ++k) expect_same(now[k], first[k], what);
    }
  const SampleTable stored = read_campaign(folder / "4 lanes, jobs 1").samples;
  for (int sample = 1; sample <= 5; ++sample) {
    EXPECT_EQ(settings_of(stored, sample - 1), settings_of(samples, sample - 1));
    const SampleRun alone = run_sample(study, samples, sample, model_builder(study), {});
    EXPECT_EQ(alone.result.state_hash, first[sample - 1].state_hash);
  }
}

// The hash of a wall after 20 steps in the last lane; `damaged`: its joints have slid, worn and crushed, while
// its blocks are where they were.
std::string after_steps(dynamics::Executor& executor, const Model& model, bool damaged) {
  State state = initial_state(model);
  state.gravity_y = -9.81;
  if (damaged) {
    std::fill(state.plastic_slip.begin(), state.plastic_slip.end(), 2e-6);
    std::fill(state.slip.begin(), state.slip.end(), 2e-6);
    std::fill(state.shear_damage.begin(), state.shear_damage.end(), 0.1);
    std::fill(state.crush.begin(), state.crush.end(), 1e-6);
  }
  const int lane = executor.lanes() - 1;
  executor.load_wall(lane, model, state);
  dynamics::Controls controls;
  controls.damping = 0.4;
  controls.dt = model.solve.step_fraction * 2 / (model.omega_max * std::sqrt(1.4));
  executor.set(lane, controls);
  for (int k = 0; k < 20; ++k) executor.step();
  executor.unload_wall(lane);
  return state_hash(state);
}

// A face is marked as one to which nothing has happened; the wall that comes next is not taken for it.
TEST(Lanes, a_damaged_wall_that_takes_the_lane_of_an_intact_one_keeps_its_history) {
  const Model model = compile(scenes::plain_wall(5, 7, 0.2e-3, 0.05));
  dynamics::Processor alone(model, 1), fresh(model, 1), beside(model, 2);
  const std::string expected = after_steps(fresh, model, true);
  EXPECT_NE(after_steps(fresh, model, false), expected);
  for (dynamics::Executor* executor : std::initializer_list<dynamics::Executor*>{&alone, &beside}) {
    after_steps(*executor, model, false);
    EXPECT_EQ(after_steps(*executor, model, true), expected) << executor->lanes() << " lanes";
  }
}

// Walls with three and with five points a face, without and with a cap.
TEST(Lanes, any_number_of_points_a_face) {
  for (const int points : {3, 5})
    for (const bool cap : {false, true}) {
      std::vector<std::unique_ptr<Wall>> walls;
      for (const double strength : {1.0, 1.1, 0.9}) {
        ModelSpec spec = scenes::plain_wall(5, 7, 0.3e-3, 0.05);
        spec.solve.points_per_face = points;
        JointMaterial& joint = spec.material.at("joint");
        joint.tensile_strength *= strength;
        if (cap) {
          joint.compression_cap = 9;
          joint.compressive_strength = 1e6;  // crushes here
          joint.hardening_displacement = 0.01e-3;
          joint.dilatancy_angle = 0.3 * joint.residual_friction_angle;
        }
        walls.push_back(std::make_unique<Wall>(spec, 1));
      }
      ASSERT_TRUE(dynamics::fit_together(walls[0]->model, walls[1]->model));
      solve_together(walls, 4);
    }
}

// GII grows with pressure in one, by another b in the next, and by 0 in the last. Of little cohesion, so that joints slide.
TEST(Lanes, walls_whose_energy_grows_with_pressure_too) {
  for (const bool in_space : {false, true}) {
    const auto wall = [&](double b) {
      ModelSpec spec = scenes::plain_wall(5, 7, 1.5e-3, 0.05);
      JointMaterial& joint = spec.material.at("joint");
      joint.cohesion *= 0.1;
      joint.mode_2_energy_per_pressure = b;
      return in_space ? scenes::prisms(spec) : spec;
    };
    std::vector<std::unique_ptr<Wall>> walls;
    for (const double b : {0.2e-3, 0.05e-3, 0.0})
      walls.push_back(std::make_unique<Wall>(wall(b), 1));
    const Wall none(wall(kUnset), 1);
    for (const std::size_t k : {1, 2})
      ASSERT_TRUE(dynamics::fit_together(walls[0]->model, walls[k]->model));
    EXPECT_FALSE(dynamics::fit_together(walls[2]->model, none.model));
    EXPECT_NE(walls[0]->alone, walls[1]->alone);
    EXPECT_EQ(walls[2]->alone, none.alone);
    solve_together(walls, 4);
  }
}

// Walls that were stepped alone beside others enter lanes of their own in the middle of their run.
TEST(Lanes, walls_that_enter_midway_keep_their_bits) {
  std::vector<std::unique_ptr<Wall>> walls;
  walls.push_back(std::make_unique<Wall>(scenes::plain_wall(5, 7, 0.4e-3, 0.05), 1));
  for (const double to : {1.6e-3, 1.61e-3})
    walls.push_back(std::make_unique<Wall>(scenes::plain_wall(6, 7, to, 0.05), 1));
  solve_together(walls, 4);
}

Result solve_alone(const ModelSpec& spec) {
  const Model model = compile(spec);
  State state = initial_state(model);
  return solve(model, state, {});
}

// Curve and ledger of two equal walls in lanes, each beside the wall alone: to the bit.
void expect_same_result(const ModelSpec& spec) {
  const Model model = compile(spec);
  State alone_state = initial_state(model);
  State state[2] = {initial_state(model), initial_state(model)};
  const Result alone = solve(model, alone_state, {});
  LaneSolver solver(2);
  const SolveOptions options;
  for (const int k : {0, 1}) solver.add_wall(k, model, state[k], options);
  while (solver.running() > 0) {
    const Result there = solver.next().result;
    EXPECT_EQ(there.state_hash, alone.state_hash);
    EXPECT_EQ(there.steps, alone.steps);
    ASSERT_EQ(there.curve.size(), alone.curve.size());
    for (std::size_t k = 0; k < alone.curve.size(); ++k) {
      EXPECT_EQ(there.curve[k].reaction, alone.curve[k].reaction) << k;
      EXPECT_EQ(there.curve[k].base_shear, alone.curve[k].base_shear) << k;
      EXPECT_EQ(there.curve[k].unbalance_ratio, alone.curve[k].unbalance_ratio) << k;
      EXPECT_EQ(there.curve[k].kinetic_ratio, alone.curve[k].kinetic_ratio) << k;
    }
    const EnergyLedger &a = there.energy, &b = alone.energy;
    EXPECT_EQ(a.drive, b.drive);
    EXPECT_EQ(a.kinetic, b.kinetic);
    EXPECT_EQ(a.loads, b.loads);
    EXPECT_EQ(a.damping, b.damping);
    EXPECT_EQ(a.friction, b.friction);
    EXPECT_EQ(a.fracture, b.fracture);
    EXPECT_EQ(a.crushing, b.crushing);
    EXPECT_GT(b.damping, 0);
  }
}

TEST(Lanes, curve_and_ledger_of_a_plain_wall) {
  expect_same_result(scenes::plain_wall(5, 7, 0.4e-3, 0.05));
}
TEST(Lanes, curve_and_ledger_of_a_wall_with_ties) {
  expect_same_result(scenes::tied(scenes::small_wall(0.1e-3, 0.05)));
}
TEST(Lanes, curve_and_ledger_of_a_wall_with_a_frame) {
  expect_same_result(scenes::framed(scenes::small_wall(0.1e-3, 0.05)));
}
TEST(Lanes, curve_and_ledger_of_a_wall_with_layers) {
  expect_same_result(scenes::layered(scenes::small_wall(0.1e-3, 0.05)));
}
TEST(Lanes, curve_and_ledger_of_a_wall_with_a_deformable_lintel) {
  expect_same_result(scenes::lintel_wall(LintelModel::kZones, 0.1e-3));
}
TEST(Lanes, a_loaded_wall_pushed_to_and_fro_and_held) {
  ModelSpec spec = scenes::small_wall(0.1e-3, 0.05);
  spec.solve.mass_scaling = 10;
  spec.stage.back().get<PushStage>().targets = {0.1e-3, -0.05e-3};
  spec.stage.back().get<PushStage>().fixity.rotation = Freedom::kBlocked;
  StageSpec hold{.name = "hold", .action = HoldStage{.duration = 0.01}};
  spec.stage.push_back(hold);
  expect_same_result(spec);
}
TEST(Lanes, a_push_that_changes_its_pace) {
  ModelSpec spec = scenes::plain_wall(4, 5, 0.5e-3, 0.02);
  const std::int64_t steps = solve_alone(spec).steps;
  spec.stage.back().get<PushStage>().fast_velocity = 0.1;
  spec.stage.back().get<PushStage>().fast_below = 1e-2;
  EXPECT_LT(solve_alone(spec).steps, steps);
  expect_same_result(spec);
}
TEST(Lanes, a_push_in_a_pattern_with_a_control_block) {
  for (const Pattern pattern : {Pattern::kMass, Pattern::kMassHeight}) {
    ModelSpec spec = scenes::small_wall(0.3e-3, 0.02);
    auto& push = spec.stage.back().get<PushStage>();
    push.at = {};
    push.pattern = pattern;
    if (pattern != Pattern::kMass) push.levels = {0.4, 0.8};
    push.control.x = 0;
    push.control.y = 0.8;
    expect_same_result(spec);
    EXPECT_GT(solve_alone(spec).responses.peak_raw, 0);
  }
}
TEST(Lanes, body_force_and_tilt) {
  for (const StageAction& action :
       {StageAction{BodyForceStage{.rate = 0.2, .factor = 0.005}},
        StageAction{TiltStage{.tilt_rate = 0.2, .tilt_until = 0.005}}}) {
    ModelSpec spec = scenes::plain_wall(4, 5, 0.1e-3, 0.05);
    spec.stage.back() = {.name = "load", .ramp = 0.01, .action = action};
    expect_same_result(spec);
    EXPECT_GT(solve_alone(spec).load_factor, 0);
  }
}
TEST(Lanes, every_law_is_compiled_for_them) {
  for (const Softening softening :
       {Softening::kExponential, Softening::kPolynomial, Softening::kPetersson})
    for (const Unloading unloading : {Unloading::kSecant, Unloading::kElastic}) {
      ModelSpec spec = scenes::plain_wall(4, 5, 0.1e-3, 0.05);
      for (auto& [name, material] : spec.material) {
        material.softening = softening;
        material.unloading = unloading;
        material.coupling =
            unloading == Unloading::kElastic ? Coupling::kMaximum : Coupling::kStiffness;
      }
      expect_same_result(spec);
    }
}

TEST(Lanes, a_wall_with_another_law_does_not_fit) {
  ModelSpec spec = scenes::plain_wall(5, 7, 0.2e-3, 0.05);
  const Model bilinear = compile(spec);
  for (auto& [name, material] : spec.material) material.softening = Softening::kExponential;
  EXPECT_FALSE(dynamics::fit_together(bilinear, compile(spec)));
}

TEST(Lanes, a_wrong_number_of_lanes_is_refused) {
  const ForcedLanes forced("3");
  try {
    static_cast<void>(dynamics::lanes_in_use());
    FAIL() << "3 lanes were taken";
  } catch (const InputError& error) {
    EXPECT_NE(std::string(error.what()).find("1, 2, 4 or 8"), std::string::npos) << error.what();
  }
}

}  // namespace
}  // namespace wythe::lanes_test
