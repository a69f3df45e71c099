// Limit analysis of block models: published walls, closed forms, and both theorems at once.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "scenes/places.h"
#include "scenes/scenes.h"
#include "scenes/zones.h"
#include "verification/record.h"
#include "wythe/parts/error.h"
#include "wythe/parts/io.h"
#include "wythe/parts/limit.h"
#include "wythe/parts/quick_limit.h"
#include "wythe/parts/solve.h"

namespace wythe::verification::limit_load_test {
namespace {

using scenes::degrees;

// A dead load that is in force when the push begins.
void load_before_push(Model& model, const PointLoad& load) {
  scenes::add_load(model, load);
  std::rotate(model.stages.begin(), model.stages.end() - 1, model.stages.end());
}

constexpr double kGravity = 9.81;

StageSpec body_force() {
  return {.name = "body force",
          .action =
              BodyForceStage{.drive = {.direction = Direction::kPlusX}, .rate = 0.1, .factor = 2}};
}

ModelSpec with_stages(ModelSpec spec, StageSpec growing) {
  spec.stage = {scenes::gravity_stage(), std::move(growing)};
  return spec;
}

Model ferris_wall(const std::string& name) {
  return compile(read_model(source_dir() + "/validation/ferris_tinloi_walls/model.toml",
                            {"wall.blocks=data/" + name + ".json"}));
}

// The static and the kinematic programme are built apart; at the optimum they agree to `kGap`.
constexpr double kGap = 1e-6;

void expect_no_gap(const LimitResult& answer) {
  EXPECT_NEAR(answer.kinematic / answer.load, 1, kGap);
}

TEST(LimitLoad, Ferris_and_Tin_Loi_walls) {
  const struct {
    const char* file;
    const char* what;
    double factor;
  } walls[] = {{"wall1", "wall 1, 33 blocks", 0.64286},
               {"wall2", "wall 2, 55 blocks", 0.58000},
               {"wall4", "wall 4, 55 blocks, two openings", 0.33195}};
  for (const auto& wall : walls) {
    const LimitResult answer = limit_load(ferris_wall(wall.file), {});
    EXPECT_FALSE(answer.is_force);
    expect_no_gap(answer);
    verify({"LP-FTL", std::string("associated load factor of Ferris and Tin-Loi's ") + wall.what,
            "-", wall.factor, 1e-4, "published with 5 digits"},
           answer.load);
  }
}

// Forces in proportion to weight, controlled by displacement: peaks beside the factors published for
// friction that does not dilate, and the branch that falls behind them.
TEST(Pattern, Ferris_and_Tin_Loi_walls_reach_the_published_factors_and_fall_behind) {
  const struct {
    const char* file;
    double factor, until, left;  // published; end of the push [m]; of the peak, there, at most
  } walls[] = {
      {"wall1", 0.64, 1.6e-3, 1}, {"wall2", 0.563, 3e-3, 1}, {"wall4", 0.264, 25e-3, 0.75}};
  for (const auto& wall : walls) {
    ModelSpec spec = read_model(source_dir() + "/validation/ferris_tinloi_walls/model.toml",
                                {std::string("wall.blocks=data/") + wall.file + ".json"});
    StageSpec push{
        .name = "push",
        .damping = 0.1,
        .action = PushStage{.pattern = Pattern::kMass, .velocity = 2e-3, .until = wall.until}};
    spec.stage = {spec.stage.front(), push};
    spec.solve.collapse_displacement = 2;
    const Model model = compile(spec);
    State state = initial_state(model);
    const Result result = solve(model, state);
    EXPECT_EQ(result.status, SolveStatus::kCompleted) << wall.file;
    verify({"FTL-P",
            std::string("peak over weight, pushed by its mass: Ferris and Tin-Loi's ") + wall.file,
            "-", wall.factor, 0.03, "published with 3 digits; a push of 2 mm/s"},
           result.responses.peak_raw / model.weight);
    EXPECT_LE(result.curve.back().reaction, wall.left * result.responses.peak_raw) << wall.file;
  }
}

TEST(LimitLoad, block_overturns_or_slides_whichever_is_less) {
  for (const double friction : {0.1, 0.7}) {
    ModelSpec spec = scenes::block_on_ground(
        0.4, 1.6, scenes::dry_joint(20e9, 8e9, std::atan(friction)), 0.3, 2000);
    const LimitResult answer = limit_load(compile(with_stages(spec, body_force())), {});
    expect_no_gap(answer);
    verify({"CF20", "block under a body force, friction " + fmt::format("{}", friction), "-",
            std::min(0.4 / 1.6, friction), 1e-9, "round-off of the interior point"},
           answer.load);
  }
}

// 200 kN on a weightless pier 1.70 x 2.62 m, pushed at its head.
ModelSpec loaded_pier(double compressive_strength) {
  JointMaterial joint = scenes::dry_joint(20e9, 8e9, degrees(60));
  joint.compressive_strength = compressive_strength;
  // enough for any strength asked here: no snap-back
  joint.compressive_energy = std::isinf(compressive_strength) ? kUnset : 1e15;
  ModelSpec spec = scenes::block_on_ground(1.70, 2.62, joint, 0.31, 1e-6);
  spec.stage = {scenes::gravity_stage(), scenes::push_stage("b0", Direction::kPlusX, 0.01, 0.01)};
  return spec;
}

double rocking_force(double compressive_strength, CrushingChoice crushing) {
  Model model = compile(loaded_pier(compressive_strength));
  load_before_push(model, {.block = 0, .fy = -200e3});
  const LimitResult answer = limit_load(model, {.crushing = crushing});
  EXPECT_TRUE(answer.is_force);
  expect_no_gap(answer);
  // the push acts at the centroid: F h/2 is what F' h is at the head
  return answer.load / 2;
}

TEST(LimitLoad, CF16_rocking_of_a_pier) {
  verify({"CF16a", "rocking strength by linear programming, unlimited fc", "kN", 64.8855, 1e-5,
          "six digits; the block weighs 1e-8 of its load"},
         1e-3 * rocking_force(kUnlimited, CrushingChoice::kNone));
  const double sigma = 200e3 / (1.70 * 0.31);
  verify({"CF16b", "the same with a stress block at 0.85 fc", "kN",
          64.8855 * (1 - sigma / (0.85 * 3.96e6)), 1e-5, "tangents cut to 1e-9"},
         1e-3 * rocking_force(0.85 * 3.96e6, CrushingChoice::kStressBlock));
}

TEST(LimitLoad, crushing_at_two_points_bites_only_beyond_half_the_strength) {
  const double half = 200e3 / (1.70 * 0.31) * 2;  // fc at which one point carries all of N
  EXPECT_NEAR(rocking_force(1.01 * half, CrushingChoice::kPoints),
              rocking_force(kUnlimited, CrushingChoice::kNone), 1);
  EXPECT_LT(rocking_force(0.9 * half, CrushingChoice::kPoints),
            0.95 * rocking_force(kUnlimited, CrushingChoice::kNone));
}

TEST(LimitLoad, unlimited_strength_is_the_limit_of_a_large_one) {
  const double infinite = rocking_force(kUnlimited, CrushingChoice::kStressBlock);
  EXPECT_NEAR(rocking_force(1e12, CrushingChoice::kStressBlock) / infinite, 1, 1e-6);
}

TEST(LimitLoad, without_friction_a_stack_carries_nothing) {
  const ModelSpec spec = scenes::stack(3, 0.4, 0.2, scenes::dry_joint(20e9, 8e9, 0), 0.3, 2000);
  const LimitResult answer = limit_load(compile(with_stages(spec, body_force())), {});
  EXPECT_NEAR(answer.load, 0, 1e-9);
}

// Cohesion and tensile strength, closed forms of one joint; the base is c A wide.
TEST(LimitLoad, bonded_block_slides_at_c_A_plus_mu_W) {
  ModelSpec spec = scenes::block_on_ground(1.0, 0.1, scenes::paper_joint(), 0.31, 2000);
  const double weight = 1.0 * 0.1 * 0.31 * 2000 * kGravity;
  const LimitResult answer =
      limit_load(compile(with_stages(spec, body_force())), {.strength = JointStrength::kBonded});
  verify(
      {"LP-1", "bonded slab slides: c A / W + mu", "-",
       0.15e6 * 0.31 / weight + std::tan(degrees(16.2)), 1e-9, "round-off of the interior point"},
      answer.load);
}

// A wall of 1 m by 2 m with a wall across at its left end, whose blocks are five times as thick: as one body it turns
// about either toe, with its weight at a lever of its own.
TEST(LimitLoad, a_wall_across_holds_an_end_down) {
  const std::string text = R"(
[wall]
length = "1 m"
height = "2 m"
thickness = "0.25 m"
unit = { length = "250 mm", height = "100 mm", density = "2000 kg/m^3" }
[material.joint]
tensile_strength = "50 MPa"
cohesion = "90 MPa"
friction_angle = "40 deg"
residual_friction_angle = "40 deg"
residual_cohesion = "0 MPa"
normal_stiffness = "20 GPa/m"
shear_stiffness = "8 GPa/m"
compressive_strength = "unlimited"
mode_1_energy = "1e6 N/m"
mode_2_energy = "1e7 N/m"
[material.unit]
tensile_strength = "50 MPa"
cohesion = "90 MPa"
friction_angle = "40 deg"
residual_friction_angle = "40 deg"
residual_cohesion = "0 MPa"
normal_stiffness = "20 GPa/m"
shear_stiffness = "8 GPa/m"
compressive_strength = "unlimited"
mode_1_energy = "1e6 N/m"
mode_2_energy = "1e7 N/m"
[material.foundation]
tensile_strength = "0 MPa"
cohesion = "0 MPa"
residual_cohesion = "0 MPa"
friction_tan = 2
residual_friction_tan = 2
normal_stiffness = "20 GPa/m"
shear_stiffness = "8 GPa/m"
compressive_strength = "unlimited"
[[region]]
name = "wall across"
x = "0 m"
y = "0 m"
width = "0.25 m"
height = "2 m"
thickness = "1.25 m"
[[stage]]
name = "gravity"
[[stage]]
name = "lean"
direction = "DIRECTION"
rate = "0.1 1/s"
factor = 2
)";
  const double flange = 0.25 * 1.25, web = 0.75 * 0.25;  // areas in plan, as shares of the weight
  const struct {
    const char *way, *what;
    double lever_of_flange, lever_of_web;
  } cases[] = {{"+x", "a wall across holds the heel down", 1 - 0.125, 0.375},
               {"-x", "a wall across at the toe helps little", 0.125, 1 - 0.375}};
  for (const auto& c : cases) {
    std::string model = text;
    model.replace(model.find("DIRECTION"), 9, c.way);
    const LimitResult answer =
        limit_load(compile(parse_model(model, "model.toml")), {.strength = JointStrength::kBonded});
    verify({"LP-7", std::string(c.what) + ": sum of W x over W h / 2", "-",
            (flange * c.lever_of_flange + web * c.lever_of_web) / (flange + web), 1e-6,
            "1e-6: what both theorems may differ by"},
           answer.load);
  }
}

// A load of many million weights is large, not without limit.
TEST(LimitLoad, a_bonded_slab_of_next_to_no_weight_has_a_limit) {
  for (const double density : {1.0, 1e-3, 1e-4}) {
    ModelSpec spec = scenes::block_on_ground(1.0, 0.1, scenes::paper_joint(), 0.31, density);
    const double weight = 1.0 * 0.1 * 0.31 * density * kGravity;
    const LimitResult answer =
        limit_load(compile(with_stages(spec, body_force())), {.strength = JointStrength::kBonded});
    const double load = 0.15e6 * 0.31 / weight + std::tan(degrees(16.2));
    EXPECT_NEAR(answer.load / load, 1, 1e-8) << density;
    EXPECT_NEAR(answer.kinematic / load, 1, 1e-8) << density;
  }
}

TEST(LimitLoad, bonded_tower_tears_at_its_base) {
  JointMaterial joint = scenes::paper_joint();
  joint.cohesion = 10e6;
  joint.mode_2_energy = 1e5;
  ModelSpec spec = scenes::block_on_ground(0.2, 2.0, joint, 0.31, 2000);
  const double weight = 0.2 * 2.0 * 0.31 * 2000 * kGravity, area = 0.2 * 0.31;
  // points at the ends: M = (N + ft A/2 2) l/2 with N = W and the far point at its cut-off
  const double moment = (weight / 2 + 0.15e6 * area / 2) * 0.2;
  const LimitResult answer =
      limit_load(compile(with_stages(spec, body_force())), {.strength = JointStrength::kBonded});
  verify({"LP-2", "bonded tower tears at its base", "-", moment / (weight * 1.0), 1e-9,
          "round-off of the interior point"},
         answer.load);
}

// --- what the test rig holds

// A weightless panel b x h under a beam of height 2 c with 200 kN on it, pushed at the beam.
double pushed_beam(Freedom rotation, const char* as = "free") {
  const double b = 1.0, h = 2.0, c = 0.1;
  std::vector<BlockSpec> blocks{scenes::rectangle("panel", 0, 0, b, h),
                                scenes::rectangle("beam", 0, h, b, 2 * c)};
  blocks[1].beam = true;
  ModelSpec spec = scenes::assembly(blocks, scenes::dry_joint(20e9, 8e9, degrees(60)), 0.3, 1e-6);
  spec.wall.beam.rotation = rotation;
  StageSpec push = scenes::push_stage("beam", Direction::kPlusX, 0.01, 0.01);
  if (std::string(as) == "blocked") push.get<PushStage>().fixity.rotation = Freedom::kBlocked;
  spec.stage = {scenes::gravity_stage(), push};
  Model model = compile(spec);
  Stage load = model.stages.front();
  load.spec.action = LoadStage{};
  load.loads = {{.block = scenes::block_named(model, "beam"), .fy = -200e3}};
  model.stages.insert(model.stages.begin() + 1, load);
  const LimitResult answer = limit_load(model, {});
  expect_no_gap(answer);
  return answer.load;
}

TEST(LimitLoad, a_beam_kept_level_rocks_the_panel_on_both_its_corners) {
  verify({"LP-3", "panel under a beam free to turn: N b/2 / (h + c)", "kN", 200 * 0.5 / 2.1, 1e-6,
          "the blocks weigh 1e-8 of their load"},
         1e-3 * pushed_beam(Freedom::kFree));
  verify({"LP-4", "panel under a beam kept level: N b / h", "kN", 200 * 1.0 / 2.0, 1e-6,
          "the blocks weigh 1e-8 of their load"},
         1e-3 * pushed_beam(Freedom::kBlocked));
  EXPECT_NEAR(pushed_beam(Freedom::kFree, "blocked"), pushed_beam(Freedom::kBlocked), 1e-3)
      << "the same said of the push";
}

// A slab with bond on a tilting ground.
Model tilted_slab(double density) {
  ModelSpec spec = scenes::block_on_ground(1.0, 0.1, scenes::paper_joint(), 0.31, density);
  StageSpec tilt{.name = "tilt", .action = TiltStage{.tilt_rate = 0.01, .tilt_until = 1.5}};
  return compile(with_stages(spec, tilt));
}
constexpr LimitOptions kBond{.strength = JointStrength::kBonded};

// Strengths and weights do not grow alike: W sin = c A + W cos tan phi. Over the cosine, x = tan phi + b sqrt(1 + x^2) with
// b = c A/W, a quadratic equation. With b near 1 each tilt changes the next by nearly as much as itself.
TEST(LimitLoad, bonded_slab_on_a_tilting_ground) {
  const double m = std::tan(degrees(16.2));
  for (const double density : {400000.0, 200000.0, 160000.0, 154000.0}) {
    const double b = 0.15e6 * 0.31 / (1.0 * 0.1 * 0.31 * density * kGravity);
    const double x = (m + b * std::sqrt(1 + m * m - b * b)) / (1 - b * b);
    const Model model = tilted_slab(density);
    EXPECT_NEAR(limit_load(model, kBond).load, x, 1e-6 * x) << b;
    EXPECT_NEAR(quick_limit_load(model, kBond).load, x, 2e-4 * x) << b;
  }
}

// With b > 1 it stays on a vertical face.
TEST(LimitLoad, no_tilt_brings_down_what_stays_on_a_vertical_face) {
  try {
    FAIL() << limit_load(tilted_slab(140000), kBond).load;
  } catch (const InputError& error) {
    EXPECT_NE(std::string(error.what()).find("no tilt up to 90 degrees"), std::string::npos)
        << error.what();
  }
}

TEST(LimitLoad, loads_that_come_after_the_push_do_not_hold_it) {
  Model model = compile(loaded_pier(kUnlimited));
  const double without = limit_load(model, {}).load;
  Stage late = model.stages.front();
  late.spec.action = LoadStage{};
  late.loads = {{.block = 0, .fy = -200e3}};
  model.stages.push_back(late);
  EXPECT_EQ(limit_load(model, {}).load, without);
  EXPECT_EQ(left_aside(model).size(), 1U);
}

TEST(LimitLoad, of_blocks_that_weigh_nothing_is_said_or_refused) {
  ModelSpec spec = scenes::half_units({}, scenes::dry_joint(20e9, 8e9, degrees(35)));
  spec.stage = {scenes::push_stage("r6c0", Direction::kPlusX, 0.01, 0.01)};
  const auto notes = [](const ModelSpec& of) {
    std::string text;
    for (const Message& note : left_aside(compile(of))) text += text_of(note) + "\n";
    return text;
  };
  EXPECT_NE(notes(spec).find("weigh nothing"), std::string::npos) << notes(spec);
  spec.stage.push_back(scenes::gravity_stage());  // too late
  EXPECT_NE(notes(spec).find("weigh nothing"), std::string::npos);
  std::swap(spec.stage[0], spec.stage[1]);
  EXPECT_EQ(notes(spec), "");
  spec.stage[1].action = BodyForceStage{};
  EXPECT_EQ(notes(spec), "");
  Model floating = compile(spec);
  floating.solve.gravity = 0;
  try {
    static_cast<void>(limit_load(floating, {}));
    ADD_FAILURE() << "a share of no weight";
  } catch (const InputError& error) {
    EXPECT_NE(std::string(error.what()).find("solve.gravity"), std::string::npos) << error.what();
  }
}

TEST(LimitLoad, targets_behind_the_push_turn_it_round) {
  ModelSpec spec = scenes::half_units({}, scenes::dry_joint(20e9, 8e9, degrees(35)));
  StageSpec push = scenes::push_stage("r6c0", Direction::kMinusX, 0.01, 0.01);
  spec.stage = {scenes::gravity_stage(), push};
  const double there = limit_load(compile(spec), {}).load;
  spec.stage[1].get<PushStage>().drive.direction = Direction::kPlusX;
  const double back = limit_load(compile(spec), {}).load;
  spec.stage[1].get<PushStage>().targets = {-0.002, -0.001, -0.003};
  EXPECT_NEAR(limit_load(compile(spec), {}).load, there, 1e-9 * there);
  EXPECT_GT(std::fabs(back - there), 1e-3 * there) << "else it shows nothing";
}

TEST(LimitLoad, stops_when_asked_to) {
  const Model model = compile(scenes::small_wall());
  const std::atomic<bool> stop{true};
  EXPECT_THROW((void)limit_load(model, {}, {.stop = &stop}), LimitStopped);
}

// --- beside runs

ComparedRun run_with_peak(double peak, const std::string& judgement) {
  ComparedRun run{.name = "run", .mode = "FM-1"};
  run.curve = {{.displacement = 0}, {.displacement = 1e-3, .reaction = peak}};
  run.bound = 100e3;
  run.judgement = judgement;
  return run;
}

TEST(LimitLoad, a_run_above_its_bound_is_wrong_whatever_it_says_of_its_rate) {
  for (const char* verdict : {"slow enough", "too fast", ""}) {
    EXPECT_FALSE(compare("x", {run_with_peak(200e3, verdict)}, {}).bounds.front().holds());
    EXPECT_FALSE(compare("x", {run_with_peak(102.1e3, verdict)}, {}).bounds.front().holds());
    EXPECT_TRUE(compare("x", {run_with_peak(101.9e3, verdict)}, {}).bounds.front().holds());
  }
}

TEST(LimitLoad, a_run_that_calls_itself_too_fast_is_no_evidence) {
  const auto why = [](const ComparedRun& run) {
    return compare("x", {run}, {}).bounds.front().no_evidence;
  };
  EXPECT_TRUE(why(run_with_peak(90e3, "slow enough")).empty());
  EXPECT_EQ(why(run_with_peak(90e3, "too fast")).code, "evidence.own_verdict");
  EXPECT_EQ(why(run_with_peak(90e3, "usable")).code, "evidence.own_verdict");
  ComparedRun without = run_with_peak(90e3, "slow enough");
  without.capacity = std::nan("");
  EXPECT_EQ(why(without).code, "evidence.no_balance");
  ComparedRun capacity = run_with_peak(200e3, "slow enough");
  capacity.capacity = 95e3;
  EXPECT_TRUE(compare("x", {capacity}, {}).bounds.front().holds()) << "the rebound is no capacity";
}

// --- properties

TEST(LimitLoad, joint_forces_balance_every_block_and_respect_friction) {
  const Model model = ferris_wall("wall4");
  const LimitResult answer = limit_load(model, {});
  std::vector<double> fx(static_cast<std::size_t>(model.n_block)), fy = fx, m = fx;
  for (std::size_t i = 0; i < fx.size(); ++i) {
    const double w = model.solve.gravity * model.gravity_mass[i];
    fx[i] = answer.load * w;
    fy[i] = -w;
  }
  for (int j = 0; j < model.n_joint; ++j) {
    const double tx = model.tangent_x[j], ty = model.tangent_y[j];
    double normal = 0;
    for (int k = 0; k < 2; ++k) {
      const double p = answer.point_force[2 * j + k];
      const double s = answer.shear_force[j] / 2, xi = k == 0 ? -1 : 1;
      EXPECT_GE(p, -1e-6 * model.weight);
      normal += p;
      const double px = p * -ty + s * tx, py = p * tx + s * ty;  // on b
      const auto act = [&](BlockId block, double sign, double x, double y) {
        if (block == kGroundBlock) return;
        const auto i = static_cast<std::size_t>(block);
        x += xi * model.half_x[j];
        y += xi * model.half_y[j];
        fx[i] += sign * px;
        fy[i] += sign * py;
        m[i] += sign * (x * py - y * px);
      };
      act(model.joint_b[j], 1, model.arm_b_x[j], model.arm_b_y[j]);
      act(model.joint_a[j], -1, model.arm_a_x[j], model.arm_a_y[j]);
    }
    EXPECT_LE(std::fabs(answer.shear_force[j]), 0.65 * normal + 1e-6 * model.weight);
  }
  for (std::size_t i = 0; i < fx.size(); ++i) {
    EXPECT_NEAR(fx[i], 0, 1e-6 * model.weight);
    EXPECT_NEAR(fy[i], 0, 1e-6 * model.weight);
    EXPECT_NEAR(m[i], 0, 1e-6 * model.weight);
  }
}

// A push on the small wall with a window, everything counted: cohesion, tension, crushing.
TEST(LimitLoad, both_theorems_agree_whatever_the_joints_resist) {
  const Model model = compile(scenes::small_wall());
  double dry = 0, bonded = 0;
  for (const auto strength : {JointStrength::kDry, JointStrength::kBonded}) {
    double before = HUGE_VAL;
    for (const auto crushing :
         {CrushingChoice::kNone, CrushingChoice::kPoints, CrushingChoice::kStressBlock}) {
      const LimitResult answer = limit_load(model, {.strength = strength, .crushing = crushing});
      expect_no_gap(answer);
      EXPECT_GT(answer.load, 0);
      EXPECT_LE(answer.load, before * (1 + kGap)) << "a tighter yield surface carries no more";
      before = answer.load;
    }
    (strength == JointStrength::kDry ? dry : bonded) = before;
  }
  EXPECT_GT(bonded, 1.5 * dry);
}

TEST(LimitLoad, mirror_and_scale) {
  ModelSpec spec = scenes::half_units({}, scenes::dry_joint(20e9, 8e9, degrees(35)));
  spec.stage = {scenes::gravity_stage(), scenes::push_stage("r6c0", Direction::kPlusX, 0.01, 0.01)};
  const double load = limit_load(compile(spec), {}).load;
  EXPECT_NEAR(limit_load(compile(scenes::mirrored(spec)), {}).load / load, 1, 1e-9);
  // lengths x 2 with gravity / 2: weights x 4
  EXPECT_NEAR(limit_load(compile(scenes::scaled(spec, 2)), {}).load / (4 * load), 1, 1e-9);
}

// Without their strength units are two halves each, and the wall carries a fraction. It is said where any plane loses some.
TEST(LimitLoad, dry_says_that_units_count_as_cracked_where_their_planes_have_strength) {
  const auto notes = [](const ModelSpec& spec, JointStrength strength) {
    SecondOpinion opinion;
    opinion.limits.push_back({"", {.options = {.strength = strength}}});
    return notes_on(compile(spec), opinion);
  };
  ModelSpec spec = scenes::small_wall();
  ASSERT_EQ(notes(spec, JointStrength::kDry).size(), 1U);
  EXPECT_EQ(notes(spec, JointStrength::kDry)[0].code, "limit.cracked_units");
  EXPECT_EQ(notes(spec, JointStrength::kBonded).size(), 0U);
  const double halves = limit_load(compile(spec), {}).load;
  ModelSpec whole = spec;
  whole.wall.unit.split = Split::kNone;
  EXPECT_EQ(notes(whole, JointStrength::kDry).size(), 0U);
  EXPECT_LT(halves, 0.9 * limit_load(compile(whole), {}).load);
  JointMaterial& unit = spec.material["unit"];
  unit.tensile_strength = 0;  // nothing that dry could take away
  EXPECT_EQ(notes(spec, JointStrength::kDry).size(), 0U);
}

// Two columns, a lintel, two blocks on it: dry, a face in one piece and in pieces resist the same.
TEST(LimitLoad, a_lintel_of_zones_is_one_rigid_block) {
  const auto load = [](int zones) {
    std::vector<BlockSpec> blocks;
    for (const auto& [name, x] : {std::pair{"l", 0.0}, {"r", 0.9}})
      for (int k = 0; k < 2; ++k)
        blocks.push_back(scenes::rectangle(name + std::to_string(k), x, 0.2 * k, 0.3, 0.2));
    blocks.push_back(scenes::rectangle("lintel", 0, 0.4, 1.2, 0.15));
    blocks.push_back(scenes::rectangle("t0", 0, 0.55, 0.5, 0.2));
    blocks.push_back(scenes::rectangle("t1", 0.5, 0.55, 0.7, 0.2));
    ModelSpec spec = scenes::assembly(blocks, scenes::dry_joint(20e9, 8e9, degrees(35)), 0.3, 1500);
    if (zones > 0) {
      spec.material["soft"] = scenes::elastic_body(1e9, 0.2, 1500);
      for (BlockSpec& block : spec.block) {
        if (block.id != "lintel") continue;
        block.material = "soft";
        block.zone.zones = zones;
      }
    }
    spec.stage = {scenes::gravity_stage(), scenes::push_stage("t0", Direction::kPlusX, 0.01, 0.01)};
    const Model model = compile(spec);
    const LimitResult answer = limit_load(model, {});
    expect_no_gap(answer);
    EXPECT_EQ(answer.vx.size(), static_cast<std::size_t>(model.n_block));
    EXPECT_EQ(answer.shear_force.size(), static_cast<std::size_t>(model.n_joint));
    return answer.load;
  };
  const double rigid = load(0);
  EXPECT_GT(rigid, 0);
  for (const int zones : {1, 3}) EXPECT_NEAR(load(zones) / rigid, 1, 1e-9) << zones;
}

TEST(LimitLoad, only_a_strength_that_can_be_lost_is_a_bond) {
  ModelSpec spec = scenes::lintel_wall(LintelModel::kSegments);
  EXPECT_TRUE(has_bond(compile(spec)));
  for (auto& [name, joint] : spec.material) {
    joint.tensile_strength = joint.cohesion = 0;
    joint.mode_1_energy = joint.mode_2_energy = kUnset;
  }
  EXPECT_FALSE(has_bond(compile(spec))) << "the chain of the lintel has unlimited strength";
}

// The paper's wall, the largest programme of these tests.
TEST(LimitLoad, both_bounds_of_the_tuff_wall_meet) {
  const Model model = compile(scenes::tuff_wall(source_dir(), 0.05));
  const auto load = [&](const LimitOptions& options) {
    const LimitResult answer = limit_load(model, options);
    expect_no_gap(answer);
    return answer.load;
  };
  const double dry = load({});
  const double residual =
      load({.friction = FrictionChoice::kResidual, .crushing = CrushingChoice::kStressBlock});
  const double bonded = load({.strength = JointStrength::kBonded});
  EXPECT_LT(residual, dry);
  EXPECT_LT(dry, bonded);
}

// --- what has no answer

std::string refusal(const Model& model, const LimitOptions& options = {}) {
  try {
    (void)limit_load(model, options);
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

TEST(LimitLoad, a_block_without_neighbours_flies) {
  ModelSpec spec = scenes::stack(2, 0.4, 0.2, scenes::dry_joint(20e9, 8e9, 0.5), 0.3, 2000);
  spec.block[1].id = "balloon";
  Model model = compile(with_stages(spec, body_force()));
  // compile() refuses such walls: the joint is taken away afterwards
  const auto between = model.joint_a[0] == kGroundBlock ? 1 : 0;
  model.joint_b[between] = model.joint_a[between];
  model.block_begin.assign({0, 1, 1});
  const std::string text = refusal(model);
  EXPECT_NE(text.find("balloon"), std::string::npos) << text;
  EXPECT_NE(text.find("flies"), std::string::npos) << text;
}

TEST(LimitLoad, a_block_that_overhangs_cannot_stand) {
  ModelSpec spec = scenes::stack(1, 0.4, 0.2, scenes::dry_joint(20e9, 8e9, 0.5), 0.3, 2000);
  spec.block.push_back(scenes::rectangle("ledge", 0.3, 0.2, 1.0, 0.1));
  const std::string text = refusal(compile(with_stages(spec, body_force())));
  EXPECT_NE(text.find("cannot stand"), std::string::npos) << text;
}

// The push onto the ground has no limit, but the ledge falls all the same.
TEST(LimitLoad, a_wall_that_cannot_stand_has_no_unlimited_load_either) {
  ModelSpec spec = scenes::stack(2, 0.4, 0.2, scenes::dry_joint(20e9, 8e9, 0.5), 0.3, 2000);
  spec.block.push_back(scenes::rectangle("ledge", 0.3, 0.4, 1.0, 0.1));
  spec.stage = {scenes::gravity_stage(), scenes::push_stage("b0", Direction::kMinusY, 0.01, 0.01)};
  const std::string text = refusal(compile(spec));
  EXPECT_NE(text.find("cannot stand"), std::string::npos) << text;
  EXPECT_EQ(text.find("without end"), std::string::npos) << text;
}

TEST(LimitLoad, a_load_no_mechanism_follows_has_no_limit) {
  JointMaterial joint = scenes::dry_joint(20e9, 8e9, 0.5);
  joint.tensile_strength = joint.cohesion = kUnlimited;
  ModelSpec spec = scenes::stack(2, 0.4, 0.2, scenes::dry_joint(20e9, 8e9, 0.5), 0.3, 2000);
  spec.stage = {scenes::gravity_stage(), scenes::push_stage("b1", Direction::kMinusY, 0.01, 0.01)};
  const std::string text = refusal(compile(spec));
  EXPECT_NE(text.find("without end"), std::string::npos) << text;
  EXPECT_NE(text.find("b0"), std::string::npos) << text;
}

TEST(LimitLoad, nothing_that_grows_is_refused) {
  ModelSpec spec = scenes::stack(2, 0.4, 0.2, scenes::dry_joint(20e9, 8e9, 0.5), 0.3, 2000);
  spec.stage = {scenes::gravity_stage()};
  EXPECT_NE(refusal(compile(spec)).find("no stage has a load that grows"), std::string::npos);
}

}  // namespace
}  // namespace wythe::verification::limit_load_test
