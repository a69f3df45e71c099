// A push with a pattern of forces: shares, prescribed and controlled motion, refusals.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "scenes/places.h"
#include "scenes/rig.h"
#include "scenes/scenes.h"
#include "scenes/zones.h"
#include "wythe/parts/error.h"
#include "wythe/parts/io.h"
#include "wythe/parts/limit.h"
#include "wythe/parts/solve.h"

namespace wythe::pattern_test {
namespace {

using scenes::Rig;

ModelSpec pushed_at(Pattern pattern, std::vector<double> levels, double until = 2e-3) {
  ModelSpec spec = scenes::small_wall(until);
  spec.stage.back().get<PushStage>().at = {};
  spec.stage.back().get<PushStage>().pattern = pattern;
  spec.stage.back().get<PushStage>().levels = std::move(levels);
  return spec;
}

const Stage& push_of(const Model& model) { return model.stages.back(); }

TEST(Pattern, forces_have_their_shares_and_the_mean_with_these_shares_is_prescribed) {
  ModelSpec spec = pushed_at(Pattern::kGiven, {0.3, 0.8});
  spec.stage.back().get<PushStage>().shares = {1, 3};
  Rig rig(compile(spec));
  rig.controls.damping = 0;
  rig.drive(2, 0.05);
  const Stage& push = rig.model.stages[2];
  ASSERT_GT(push.driven.size(), 8U);
  for (int k = 0; k < 200; ++k) rig.step();
  const std::vector<double> before = rig.state.vx;
  const double reaction = rig.step();
  double mean = 0, shares = 0, all = 0, low = 0;
  std::vector<double> force;
  for (std::size_t k = 0; k < push.driven.size(); ++k) {
    const auto i = static_cast<std::size_t>(push.driven[k]);
    mean += push.driven_share[k] * rig.state.vx[i];
    shares += push.driven_share[k];
    force.push_back(rig.model.mass[i] * (rig.state.vx[i] - before[i]) / rig.controls.dt -
                    rig.view().cold(push.driven[k], dynamics::kTotalX));
    all += force.back();
    if (rig.model.centroid_y[i] < 0.5) low += force.back();
  }
  EXPECT_NEAR(shares, static_cast<double>(push.driven.size()), 1e-9);
  EXPECT_NEAR(mean / shares, 0.05, 1e-14);
  for (std::size_t k = 1; k < force.size(); ++k)
    EXPECT_NEAR(force[k] / force[0], push.driven_share[k] / push.driven_share[0], 1e-7) << k;
  EXPECT_NEAR(low / all, 0.25, 1e-9);
  EXPECT_GT(std::fabs(reaction), 0);
}

// Shares of levels from masses worked out by hand.
TEST(Pattern, levels_carry_the_mass_nearest_to_them) {
  const auto share_of_top = [](Pattern pattern) {
    const Model model = compile(pushed_at(pattern, {0.3, 0.8}));
    const Stage& push = push_of(model);
    double top = 0, all = 0;
    for (std::size_t k = 0; k < push.driven.size(); ++k) {
      all += push.driven_share[k];
      if (model.centroid_y[push.driven[k]] > 0.5) top += push.driven_share[k];
    }
    return top / all;
  };
  const Model model = compile(pushed_at(Pattern::kUniform, {0.3, 0.8}));
  double low = 0, high = 0;  // nearer to 0.3 m than to the ground and to 0.8 m; nearer to 0.8 m
  for (int b = 0; b < model.n_block; ++b) {
    const auto i = static_cast<std::size_t>(b);
    const double y = model.centroid_y[i];
    if (y > 0.55)
      high += model.gravity_mass[i];
    else if (y > 0.15)
      low += model.gravity_mass[i];
  }
  for (const Stage& stage : model.stages)
    for (const PointLoad& load : stage.loads) high -= load.fy / model.solve.gravity;
  EXPECT_NEAR(share_of_top(Pattern::kUniform), high / (low + high), 1e-12);
  EXPECT_NEAR(share_of_top(Pattern::kMassHeight), 0.8 * high / (0.3 * low + 0.8 * high), 1e-12);
}

TEST(Pattern, of_mass_pushes_every_block_by_its_mass) {
  const Model model = compile(pushed_at(Pattern::kMass, {}));
  const Stage& push = push_of(model);
  ASSERT_EQ(push.driven.size(), static_cast<std::size_t>(model.n_block));
  for (std::size_t k = 0; k < push.driven.size(); ++k)
    EXPECT_NEAR(push.driven_share[k] * model.weight / model.solve.gravity / model.n_block,
                model.gravity_mass[push.driven[k]], 1e-9);
}

// The lintel's mass goes to the blocks that it touches, and to no other: in sum all masses push.
TEST(Pattern, of_mass_counts_a_lintel_of_zones) {
  ModelSpec spec = scenes::lintel_wall(LintelModel::kZones);
  spec.stage.back().get<PushStage>().at = {};
  spec.stage.back().get<PushStage>().pattern = Pattern::kMass;
  const Model model = compile(spec);
  double zones = 0, added = 0;
  for (const double mass : model.solids.node_gravity_mass) zones += mass;
  ASSERT_GT(zones, 1);
  const Stage& push = push_of(model);
  ASSERT_EQ(push.driven.size(), static_cast<std::size_t>(model.n_block));
  const auto& touched = model.solids.contact_block;
  for (std::size_t k = 0; k < push.driven.size(); ++k) {
    const double mass = push.driven_share[k] * model.weight / model.solve.gravity / model.n_block;
    const double more = mass - model.gravity_mass[push.driven[k]];
    const bool touches = std::find(touched.begin(), touched.end(), push.driven[k]) != touched.end();
    EXPECT_EQ(more > 1e-9, touches) << k;
    added += more;
  }
  EXPECT_NEAR(added, zones, 1e-9 * model.weight);
}

TEST(Pattern, at_levels_counts_a_lintel_of_zones_where_it_is_nearest) {
  ModelSpec spec = scenes::lintel_wall(LintelModel::kZones);
  spec.stage.back().get<PushStage>().at = {};
  spec.stage.back().get<PushStage>().pattern = Pattern::kUniform;
  const Model plain = compile(scenes::lintel_wall(LintelModel::kZones));
  const double top = plain.anatomy.height;
  spec.stage.back().get<PushStage>().levels = {0.25 * top, 0.95 * top};
  const Model model = compile(spec);
  double low = 0, high = 0, share = 0, all = 0;
  const auto add = [&](double mass, double y) {
    if (y > 0.6 * top)
      high += mass;
    else if (y > 0.125 * top)
      low += mass;
  };
  for (int b = 0; b < model.n_block; ++b) add(model.gravity_mass[b], model.centroid_y[b]);
  for (const SolidBody& body : model.solids.bodies) {
    double mass = 0;
    for (int n = body.first_node; n < body.first_node + body.n_node; ++n)
      mass += model.solids.node_gravity_mass[n];
    add(mass, 0.5 * (body.y0 + body.y1));
  }
  for (const Stage& stage : model.stages)
    for (const PointLoad& load : stage.loads) high -= load.fy / model.solve.gravity;
  const Stage& push = push_of(model);
  for (std::size_t k = 0; k < push.driven.size(); ++k) {
    all += push.driven_share[k];
    if (model.centroid_y[push.driven[k]] > 0.6 * top) share += push.driven_share[k];
  }
  EXPECT_NEAR(share / all, high / (low + high), 1e-9);
}

ModelSpec dry_wall(const std::string& wall) {
  ModelSpec spec = read_model(source_dir() + "/validation/ferris_tinloi_walls/model.toml",
                              {"wall.blocks=data/" + wall + ".json"});
  StageSpec push{.name = "push",
                 .damping = 0.1,
                 .action = PushStage{.pattern = Pattern::kMass, .velocity = 2e-3, .until = 0.05}};
  spec.stage = {spec.stage.front(), push};
  spec.solve.collapse_displacement = 0.175;  // a block's height
  return spec;
}

// A third of the wall turns about its toe: its top goes 5 times as far as the mean that is pushed, and carries
// as it went. It is no collapse.
TEST(Pattern, a_part_of_the_wall_that_turns_has_not_collapsed) {
  for (const char* wall : {"wall1", "wall4"}) {
    const Model model = compile(dry_wall(wall));
    State state = initial_state(model);
    const Result result = solve(model, state);
    EXPECT_EQ(result.status, SolveStatus::kCompleted) << wall << ": " << text_of(result.reason);
    EXPECT_GT(*std::max_element(state.ux.begin(), state.ux.end()), 0.05 + 0.13) << wall;
    EXPECT_GT(result.curve.back().reaction, 0.3 * result.responses.peak_raw) << wall;
  }
}

TEST(Pattern, a_block_that_falls_has) {
  ModelSpec spec = scenes::block_on_ground(
      0.2, 1.0, scenes::dry_joint(20e9, 8e9, scenes::degrees(60)), 0.3, 2000);
  StageSpec push{.name = "push",
                 .action = PushStage{.pattern = Pattern::kMass, .velocity = 0.2, .until = 0.8}};
  spec.stage = {scenes::gravity_stage(), push};
  spec.solve.collapse_displacement = 0.1;
  const Model model = compile(spec);
  State state = initial_state(model);
  const Result result = solve(model, state);
  EXPECT_EQ(result.status, SolveStatus::kCollapsed);
  EXPECT_EQ(result.reason.code, "block.fallen") << text_of(result.reason);
}

// The meters look at what is driven too: otherwise a pushed wall would have nothing out of balance.
TEST(Pattern, a_fast_push_of_every_block_is_not_called_slow) {
  ModelSpec spec = pushed_at(Pattern::kMass, {});
  spec.stage.back().get<PushStage>().velocity = 0.5;
  const Model model = compile(spec);
  State state = initial_state(model);
  const Result result = solve(model, state);
  double most = 0;
  for (const CurveRow& row : result.curve) most = std::max(most, row.unbalance_ratio);
  EXPECT_GT(most, 0.01);
  EXPECT_NE(result.quasi_static.judgement, "slow enough");
}

TEST(Pattern, the_limit_load_of_a_mass_pattern_is_the_load_factor_times_the_weight) {
  const ModelSpec push = [] {
    ModelSpec spec = scenes::plain_wall(4, 6, 1e-3, 0.05);
    for (auto& [name, material] : spec.material) {
      material.tensile_strength = material.cohesion = material.residual_cohesion = 0;
      material.compressive_strength = kUnlimited;
    }
    spec.stage = {scenes::gravity_stage(), spec.stage.back()};
    spec.stage.back().get<PushStage>().at = {};
    spec.stage.back().get<PushStage>().pattern = Pattern::kMass;
    return spec;
  }();
  ModelSpec body = push;
  body.stage.back() = {.name = "lean", .action = BodyForceStage{.rate = 0.1, .factor = 2}};
  const Model model = compile(push);
  const double force = limit_load(model, {}).load, factor = limit_load(compile(body), {}).load;
  EXPECT_NEAR(force / (factor * model.weight), 1, 1e-6);
}

TEST(Control, the_rows_tell_and_the_push_ends_where_the_control_block_is) {
  ModelSpec spec = pushed_at(Pattern::kUniform, {0.85}, 0.1e-3);
  spec.stage.back().get<PushStage>().control.x = 0;
  spec.stage.back().get<PushStage>().control.y = 0.7;
  const Model model = compile(spec);
  ASSERT_GE(push_of(model).control, 0);
  const auto i = static_cast<std::size_t>(push_of(model).control);
  EXPECT_NEAR(push_of(model).load_height, model.centroid_y[i], 1e-12);
  State state = initial_state(model);
  const Result result = solve(model, state);
  ASSERT_EQ(result.status, SolveStatus::kCompleted) << result.reason;
  double start = 0;
  for (const Snapshot& shot : result.states.snapshots)
    if (shot.label == "start") start = shot.state.ux[i];
  EXPECT_NEAR(result.curve.back().displacement, state.ux[i] - start, 1e-9);
  EXPECT_NEAR(result.curve.back().displacement, 0.1e-3, 2e-6);
  EXPECT_NE(state.progress.drive_displacement, result.curve.back().displacement);
}

// The lower course slides through; the upper one, which is the control, springs back.
TEST(Control, that_goes_back_ends_the_push_and_is_no_reversal) {
  ModelSpec spec = pushed_at(Pattern::kUniform, {0.4, 0.8}, 1e-3);
  spec.stage.back().get<PushStage>().control.x = 0;
  spec.stage.back().get<PushStage>().control.y = 0.8;
  const Model model = compile(spec);
  State state = initial_state(model);
  const Result result = solve(model, state);
  EXPECT_EQ(result.status, SolveStatus::kNotSettled);
  EXPECT_EQ(result.reason.code, "push.control_goes_back");
  for (std::size_t k = 1; k < result.curve.size(); ++k)
    EXPECT_GE(result.curve[k].displacement, result.curve[k - 1].displacement) << k;
}

// Two blocks side by side: the pushed one slides off, the control block stays.
TEST(Control, that_stays_behind_ends_the_push_and_says_so) {
  const JointMaterial dry = scenes::dry_joint(1e9, 1e9, 0.5);
  ModelSpec spec = scenes::block_on_ground(0.4, 0.2, dry, 0.1, 2000);
  BlockSpec other = *std::find_if(spec.block.begin(), spec.block.end(),
                                  [](const BlockSpec& block) { return !block.fixed; });
  other.id = "other";
  for (auto& p : other.polygon) p[0] += 2;
  spec.block.push_back(other);
  spec.stage.push_back(scenes::push_stage("b0", Direction::kPlusX, 2e-3, 0.05));
  spec.stage.back().get<PushStage>().control.block = "other";
  const Model model = compile(spec);
  State state = initial_state(model);
  const Result result = solve(model, state);
  EXPECT_EQ(result.status, SolveStatus::kNotSettled);
  EXPECT_EQ(result.reason.code, "push.control_stays_behind");
}

// --- what is refused ----------------------------------------------------------------------------------

std::string refusal_of(const std::string& push) {
  const std::string text = write_model(scenes::small_wall());
  const std::size_t stage = text.rfind("[[stage]]"), rest = text.find("[solve]", stage);
  const std::string changed = text.substr(0, stage) +
                              "[[stage]]\nname = \"push\"\nvelocity = \"5 mm/s\"\n"
                              "until = \"5 mm\"\n" +
                              push + "\n" + text.substr(rest);
  try {
    (void)compile(parse_model(changed, "model.toml"));
    return "";
  } catch (const InputError& error) {
    return error.what();
  }
}

TEST(PatternInput, what_makes_no_sense_is_refused_at_its_key) {
  const struct {
    const char *push, *key, *problem;
  } cases[] = {
      {"", "stage.2.at", "is missing"},
      {"levels = [\"0.8 m\"]\nat = { x = \"0 m\", y = \"0.8 m\" }", "stage.2.levels",
       "belongs to a"},
      {"pattern = \"uniform\"", "stage.2.levels", "is missing"},
      {"pattern = \"uniform\"\nlevels = []", "stage.2.levels", "is empty"},
      {"pattern = \"uniform\"\nlevels = [\"9 m\"]", "stage.2.levels.0", "no moving block"},
      {"pattern = \"uniform\"\nlevels = [\"0.8 m\", \"0.81 m\"]", "stage.2.levels.1",
       "same course"},
      {"pattern = \"mass\"\nlevels = [\"0.8 m\"]", "stage.2.levels", "has no meaning"},
      {"pattern = \"given\"\nlevels = [\"0.8 m\"]", "stage.2.shares", "is missing"},
      {"pattern = \"given\"\nlevels = [\"0.3 m\", \"0.8 m\"]\nshares = [1]", "stage.2.shares",
       "as many as"},
      {"pattern = \"given\"\nlevels = [\"0.3 m\", \"0.8 m\"]\nshares = [1, -1]", "stage.2.shares",
       "add up to nothing"},
      {"pattern = \"given\"\nlevels = [\"0.3 m\"]\nshares = [\"1\"]", "stage.2.shares",
       "list of numb"},
      {"pattern = \"mass\"\nat = { x = \"0 m\", y = \"0.8 m\" }", "stage.2.at",
       "without a pattern"},
      {"pattern = \"mass\"\nas = \"each\"", "stage.2.as", "shares forces"},
      {"pattern = \"mass\"\ncontrol = { x = \"0 m\", y = \"90 m\" }", "stage.2.control",
       "finds no moving block"},
      {"pattern = \"mass\"\ncontrol = { x = \"0 m\" }", "stage.2.control", "must be one point"},
  };
  for (const auto& c : cases) {
    const std::string said = refusal_of(c.push);
    EXPECT_NE(said.find(c.key), std::string::npos) << c.push << "\n" << said;
    EXPECT_NE(said.find(c.problem), std::string::npos) << c.push << "\n" << said;
  }
  EXPECT_EQ(refusal_of("pattern = \"mass_height\"\nlevels = [\"0.3 m\", \"0.8 m\"]\n"
                       "control = { x = \"0 m\", y = \"0.8 m\" }"),
            "");
}

TEST(PlaneWall, refuses_what_only_a_wall_in_space_has) {
  const auto said = [](const StageSpec& stage) {
    ModelSpec spec = scenes::small_wall();
    spec.stage.back() = stage;
    std::string text;
    try {
      (void)compile(spec);
    } catch (const InputError& error) {
      for (const Fault& fault : error.faults()) text += fault.path + ": " + fault.problem + "\n";
    }
    return text;
  };
  StageSpec force{.name = "force",
                  .action = BodyForceStage{
                      .drive = {.direction = Direction::kPlusY}, .rate = 0.1, .factor = 0.1}};
  EXPECT_NE(said(force).find("stage.2.direction: a body_force stage acts sideways"),
            std::string::npos)
      << said(force);
  StageSpec push = scenes::small_wall().stage.back();
  push.get<PushStage>().drive.direction = Direction::kMinusZ;
  push.get<PushStage>().at.z = 0.1;
  push.get<PushStage>().drive.along = {0, 0, 1};
  for (const char* words : {"direction: is out of the wall's plane", "along: is for walls in space",
                            "at: is for walls in space"})
    EXPECT_NE(said(push).find(words), std::string::npos) << words << "\n" << said(push);
}

}  // namespace
}  // namespace wythe::pattern_test
