// Ties, diaphragms and springs against closed forms, and refusals.
#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>
#include <string>

#include "contact/link.h"
#include "scenes/rig.h"
#include "scenes/scenes.h"
#include "wythe/parts/error.h"
#include "wythe/parts/io.h"
#include "wythe/parts/limit.h"
#include "wythe/parts/reading.h"
#include "wythe/parts/solve.h"

namespace wythe::links_test {
namespace {

using scenes::Rig;

constexpr double kTie = 2e6;  // [N/m], of the ties below: 200 GPa x 10 mm2 / 1 m

// Two blocks of 1 m x 0.5 m x 0.1 m on ice, 1 m between them: only links hold them.
ModelSpec two_on_ice() {
  ModelSpec spec = scenes::assembly(
      {scenes::rectangle("left", 0, 0, 1, 0.5), scenes::rectangle("right", 2, 0, 1, 0.5)},
      scenes::dry_joint(1e9, 1e9, 1e-9), 0.1, 2000);
  spec.stage = {scenes::gravity_stage()};
  return spec;
}

// Over the gap at mid-height, through both centroids.
TieSpec tie_over_the_gap() {
  TieSpec tie;
  tie.name = "tie";
  tie.from.x = 1, tie.from.y = 0.25;
  tie.to.x = 2, tie.to.y = 0.25;
  tie.area = 10e-6;
  tie.youngs_modulus = 200e9;
  return tie;
}

TieSpec anchored() {
  TieSpec tie = tie_over_the_gap();
  tie.from.x = 3;
  tie.to.x = 4;
  tie.anchored = true;
  return tie;
}

StageSpec push_right(Direction direction, double until) {
  StageSpec push = scenes::push_stage("right", direction, 0.002, until);
  push.damping = 0.2;
  return push;
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

// The only link at the first row of the curve that is within 5 um of a displacement.
const LinkRow& at(const Ran& r, double displacement) {
  for (std::size_t k = 0; k < r.result.curve.size(); ++k)
    if (std::fabs(r.result.curve[k].displacement - displacement) < 5e-6)
      return r.result.strengthening.links[k];
  throw std::runtime_error("no row there");
}

// The left block is anchored, the right one pulled away: both ties stretch, each by its share.
TEST(Links, ties_in_a_row_carry_the_same_force_and_share_the_elongation) {
  ModelSpec spec = two_on_ice();
  TieSpec hold = anchored();
  hold.name = "hold";
  hold.from.x = 0, hold.to.x = -0.5;  // half as long: twice as stiff
  spec.tie = {tie_over_the_gap(), hold};
  spec.stage.push_back(push_right(Direction::kPlusX, 0.3e-3));
  const Ran r = solved(spec);
  ASSERT_EQ(r.result.status, SolveStatus::kCompleted);
  const auto links = read_links(r.model, r.state);
  // the left block still trembles by a micrometre
  EXPECT_NEAR(links[0].elongation, 0.2e-3, 0.01 * 0.2e-3);
  EXPECT_NEAR(links[1].elongation, 0.1e-3, 0.02 * 0.1e-3);
  EXPECT_NEAR(links[0].force, kTie * links[0].elongation, 1e-9 * 400);
  EXPECT_NEAR(links[1].force, 2 * kTie * links[1].elongation, 1e-9 * 400);
  EXPECT_NEAR(r.result.curve.back().reaction, 400, 0.01 * 400);
  EXPECT_NEAR(r.result.curve.back().base_shear, 400, 0.01 * 400);  // of the anchor
}

TEST(Links, a_tie_yields_at_its_area_times_yield_strength_and_hangs_slack_on_the_way_back) {
  ModelSpec spec = two_on_ice();
  spec.tie = {anchored()};
  spec.tie[0].yield_strength = 40e6;  // 400 N, at 0.2 mm
  StageSpec push = push_right(Direction::kMinusX, 0);
  push.get<PushStage>().until = kUnset;
  push.get<PushStage>().targets = {0.5e-3, 0.05e-3};
  spec.stage.push_back(push);
  const Ran r = solved(spec);
  ASSERT_EQ(r.result.status, SolveStatus::kCompleted);
  EXPECT_NEAR(at(r, 0.1e-3).force, 200, 5e-6 * kTie);  // as far as its row is off
  EXPECT_NEAR(at(r, 0.4e-3).force, 400, 1e-9);
  EXPECT_NEAR(r.state.link_plastic[0], 0.3e-3, 2e-6);
  EXPECT_EQ(read_links(r.model, r.state)[0].force, 0);  // at 0.05 mm, 0.3 mm of it for good
  EXPECT_NEAR(r.result.energy.friction, 400 * 0.3e-3, 0.01 * 0.12);
  EXPECT_LT(r.result.energy.gap_ratio, 1e-3);
  bool said = false;
  for (const Event& event : r.result.events)
    said = said || (text_of(event.name) == "tie yields" && event.displacement > 0.19e-3 &&
                    event.displacement < 0.21e-3);
  EXPECT_TRUE(said);
}

TEST(Links, the_weaker_of_bar_and_anchor_decides) {
  ModelSpec spec = two_on_ice();
  spec.tie = {anchored()};
  spec.tie[0].yield_strength = 40e6;
  spec.tie[0].anchor_strength = 150;
  EXPECT_EQ(compile(spec).links.tension[0], 150);
  spec.tie[0].anchor_strength = 1e3;
  EXPECT_NEAR(compile(spec).links.tension[0], 400, 1e-9);
}

// N0 is drawn in; the joint between the blocks gives way by N / kn A, and so much the tie loses.
TEST(Links, prestress_presses_the_joint_and_loses_what_the_joint_yields) {
  ModelSpec spec = scenes::assembly(
      {scenes::rectangle("left", 0, 0, 1, 0.5), scenes::rectangle("right", 1, 0, 1, 0.5)},
      scenes::dry_joint(1e9, 1e9, 1e-9), 0.1, 2000);
  spec.solve.settle_ratio = 1e-9;
  spec.tie = {tie_over_the_gap()};
  spec.tie[0].from.x = 0.25, spec.tie[0].to.x = 1.75;
  spec.tie[0].area = 0.03;  // 4 GN/m against the joint's 50 MN/m
  spec.tie[0].prestress = 1e6;
  spec.stage = {scenes::gravity_stage()};
  const Ran r = solved(spec);
  ASSERT_EQ(r.result.status, SolveStatus::kCompleted);
  const double tie = 200e9 * 0.03 / 1.5, joint = 1e9 * 0.5 * 0.1;
  const double force = 30e3 / (1 + tie / joint);
  EXPECT_NEAR(read_links(r.model, r.state)[0].force, force, 1e-5 * force);
  for (const JointReading& j : read_wall(r.model, r.state).joints) {
    if (j.shape.a == kGroundBlock) continue;
    EXPECT_NEAR(j.compression, force, 1e-5 * force);
  }
  EXPECT_LT(r.result.energy.gap_ratio, 1e-3);
}

// Forces and moments of a link are what its energy says: f = -dE/dq, at large rotations too.
TEST(Links, forces_and_moments_are_the_slope_of_the_energy) {
  for (const bool spring : {false, true}) {
    ModelSpec spec = two_on_ice();
    if (spring) {
      SpringSpec s;
      s.at.x = 2.1, s.at.y = 0.45;
      s.stiffness = 1e6;
      s.direction = Direction::kMinusX;
      spec.spring = {s};
    } else {
      spec.tie = {tie_over_the_gap()};
      spec.tie[0].from.x = 0.9, spec.tie[0].from.y = 0.45;
      spec.tie[0].to.x = 2.2, spec.tie[0].to.y = 0.1;
    }
    Rig rig(compile(spec));
    rig.controls.dt = 1e-12;
    const double moved[6] = {-0.02, 0.05, 0.3, 0.1, 0.03, -0.2};
    const auto put = [&](State& s, const double* q) {
      s.ux = {q[0], q[3]}, s.uy = {q[1], q[4]}, s.theta = {q[2], q[5]};
    };
    const auto energy = [&](const double* q) {
      State s = rig.state;
      put(s, q);
      const LinkReading link = read_links(rig.model, s)[0];
      return 0.5 * link.force * link.force / link.stiffness;
    };
    put(rig.state, moved);
    ASSERT_GT(energy(moved), 0);
    rig.step();
    const double* row = rig.view().t.force + 4 * rig.processor.layout().joints;
    double force[6] = {};
    if (const BlockId a = rig.model.links.a[0]; a != kGroundBlock)
      for (int k = 0; k < 3; ++k) force[3 * a + k] = row[k];
    const int b = 3 * rig.model.links.b[0];
    force[b] = -row[0], force[b + 1] = -row[1], force[b + 2] = row[3];
    for (int k = 0; k < 6; ++k) {
      double low[6], high[6];
      for (int i = 0; i < 6; ++i) low[i] = high[i] = moved[i];
      low[k] -= 1e-6, high[k] += 1e-6;
      const double slope = (energy(high) - energy(low)) / 2e-6;
      EXPECT_NEAR(force[k], -slope, 1e-6 * std::fabs(row[0]) + 1e-3) << "component " << k;
    }
  }
}

TEST(Links, a_spring_that_only_pushes_opens_a_gap_and_yields_at_its_strength) {
  ModelSpec spec = two_on_ice();
  SpringSpec wall;
  wall.at.x = 3, wall.at.y = 0.25;
  wall.stiffness = 1e6;
  wall.strength = 300;
  wall.pushes_only = true;
  spec.spring = {wall};
  StageSpec push = push_right(Direction::kPlusX, 0);
  push.get<PushStage>().until = kUnset;
  push.get<PushStage>().targets = {-0.2e-3, 0.5e-3, 0.1e-3};
  spec.stage.push_back(push);
  const Ran r = solved(spec);
  ASSERT_EQ(r.result.status, SolveStatus::kCompleted);
  EXPECT_EQ(at(r, -0.15e-3).force, 0);
  EXPECT_EQ(at(r, 0.45e-3).force, -300);
  EXPECT_NEAR(r.state.link_plastic[0], -0.2e-3, 3e-6);  // pushed back for good
  EXPECT_EQ(read_links(r.model, r.state)[0].force, 0);  // a gap of 0.1 mm is left
}

// Two columns: with a floor between their tops both go the same way.
TEST(Links, a_diaphragm_takes_the_other_column_along) {
  std::vector<BlockSpec> blocks;
  for (int k = 0; k < 4; ++k)
    for (const int column : {0, 1})
      blocks.push_back(scenes::rectangle("c" + std::to_string(column) + std::to_string(k),
                                         2.0 * column, 0.25 * k, 0.5, 0.25));
  ModelSpec spec = scenes::assembly(blocks, scenes::elastic_joint(1e9, 0.4e9), 0.2, 2000);
  StageSpec push = scenes::push_stage("c03", Direction::kPlusX, 0.01, 0.5e-3);
  push.get<PushStage>().fixity.rotation = Freedom::kBlocked;
  spec.stage = {scenes::gravity_stage(), push};
  const auto moved = [](const Ran& r, const char* id) {
    return r.state.ux[scenes::block_named(r.model, id)];
  };
  const Ran alone = solved(spec);
  EXPECT_LT(std::fabs(moved(alone, "c13")), 1e-6);
  DiaphragmSpec floor;
  floor.y = 0.9;
  floor.x = {0.4, 2.1};
  floor.kind = DiaphragmKind::kRigid;
  spec.diaphragm = {floor};
  const Ran rigid = solved(spec);
  // sixteen times stiffer than this column
  EXPECT_LT(std::fabs(read_links(rigid.model, rigid.state)[0].elongation), 0.5e-3 / 16);
  EXPECT_NEAR(moved(rigid, "c13"), 0.5e-3, 0.1 * 0.5e-3);  // less what its block turns
  EXPECT_GT(rigid.result.time_step, 0.9 * alone.result.time_step);
  EXPECT_GT(rigid.result.curve.back().base_shear, 1.3 * alone.result.curve.back().base_shear);
  floor.kind = DiaphragmKind::kElastic;
  floor.stiffness = 1.7 * 1e3;  // 1 N/mm: as good as none
  spec.diaphragm = {floor};
  EXPECT_LT(std::fabs(moved(solved(spec), "c13")), 0.05 * 0.5e-3);
}

// A stiff link shortens the step to what is stable, and says so.
TEST(Links, a_stiff_link_shortens_the_step_and_the_run_stays_stable) {
  ModelSpec spec = two_on_ice();
  const double before = compile(spec).omega_max;
  spec.tie = {tie_over_the_gap()};
  spec.tie[0].area = 0.05;  // 10 GN/m against joints of 0.1 GN/m
  spec.stage.push_back(push_right(Direction::kPlusX, 0.05e-3));
  const Model model = compile(spec);
  EXPECT_GT(model.omega_max, 5 * before);
  std::string notes;
  for (const Message& note : model.anatomy.notes) notes += text_of(note);
  EXPECT_NE(notes.find("tie rules the time step"), std::string::npos) << notes;
  EXPECT_EQ(solved(spec).result.status, SolveStatus::kCompleted);
}

TEST(Links, a_wall_with_ties_keeps_its_ledger) {
  const Ran r = solved(scenes::tied(scenes::small_wall(0.5e-3, 0.01)));
  ASSERT_EQ(r.result.status, SolveStatus::kCompleted);
  EXPECT_LT(r.result.energy.gap_ratio, 2e-3);
  EXPECT_EQ(r.result.strengthening.links.size(), r.result.curve.size() * 5);
}

// --- limit analysis ------------------------------------------------------------------------------

// A block that overturns to the right about its lower right corner.
ModelSpec overturning() {
  ModelSpec spec = scenes::block_on_ground(
      0.5, 2.0, scenes::dry_joint(20e9, 8e9, scenes::degrees(80)), 0.1, 2000);
  StageSpec quake{.name = "quake", .action = BodyForceStage{.rate = 0.5, .factor = 10}};
  spec.stage = {scenes::gravity_stage(), quake};
  return spec;
}
LimitResult dry_limit(const ModelSpec& spec) {
  return limit_load(compile(spec), {.strength = JointStrength::kDry});
}
constexpr double kWeight = 2000 * 0.5 * 2.0 * 0.1 * 9.81;

// lambda W h/2 = W b/2 + N h of a tie at the top that yields; one that would be pressed does nothing.
TEST(LimitLinks, a_tie_adds_its_yield_force_at_its_lever_arm) {
  for (const double side : {-1.0, 1.5}) {
    ModelSpec spec = overturning();
    TieSpec tie = anchored();
    tie.from.x = side < 0 ? 0 : 0.5, tie.from.y = 2.0;
    tie.to.x = side, tie.to.y = 2.0;
    tie.yield_strength = 50e6;  // 500 N
    tie.prestress = 10e6;       // in balance with itself: no part of a limit load
    spec.tie = {tie};
    const LimitResult answer = dry_limit(spec);
    const double force = side < 0 ? 500 : 0;
    EXPECT_NEAR(answer.load, 0.25 + 2 * force / kWeight, 1e-9);
    EXPECT_NEAR(answer.kinematic, answer.load, 1e-9);
    EXPECT_NEAR(answer.link_force.at(0), force, 1e-6);
  }
}

TEST(LimitLinks, a_wall_across_adds_its_strength_where_it_is_pressed) {
  for (const Direction direction : {Direction::kPlusX, Direction::kMinusX}) {
    ModelSpec spec = overturning();
    SpringSpec wall;
    wall.at.x = 0.5, wall.at.y = 1.5;
    wall.direction = direction;
    wall.stiffness = 1e6;
    wall.strength = 400;
    wall.pushes_only = true;
    spec.spring = {wall};
    const double force = direction == Direction::kPlusX ? 400 : 0;
    EXPECT_NEAR(dry_limit(spec).load, 0.25 + 1.5 * force / kWeight, 1e-9);
    EXPECT_NEAR(dry_limit(spec).kinematic, 0.25 + 1.5 * force / kWeight, 1e-9);
  }
}

// Two columns of one weight, one twice as wide: a floor makes both fall at their mean.
TEST(LimitLinks, a_floor_makes_two_columns_fall_together) {
  ModelSpec spec = scenes::assembly(
      {scenes::rectangle("slender", 0, 0, 0.25, 2), scenes::rectangle("stout", 1, 0, 0.5, 2)},
      scenes::dry_joint(20e9, 8e9, scenes::degrees(80)), 0.1, 2000);
  spec.stage = overturning().stage;
  EXPECT_NEAR(dry_limit(spec).load, 0.125, 1e-9);
  DiaphragmSpec floor;
  floor.y = 2;
  floor.x = {0.125, 1.25};
  floor.kind = DiaphragmKind::kRigid;
  spec.diaphragm = {floor};
  // sum of W_i b_i/2 over sum of W_i h/2
  EXPECT_NEAR(dry_limit(spec).load, (0.25 * 0.25 + 0.5 * 0.5) / (2 * 0.75), 1e-9);
}

TEST(LimitLinks, macro_blocks_refuse_a_tie_by_name) {
  ModelSpec spec = scenes::tied(scenes::small_wall());
  try {
    (void)find_portal(compile(spec));
    FAIL() << "taken";
  } catch (const InputError& error) {
    EXPECT_NE(std::string(error.what()).find("tie = across: holds the wall"), std::string::npos)
        << error.what();
  }
}

// --- refused ---------------------------------------------------------------------------------------

void expect_refused(const ModelSpec& spec, const std::string& place, const std::string& problem) {
  std::string said;
  try {
    (void)compile(spec);
  } catch (const InputError& error) {
    said = error.what();
  }
  EXPECT_NE(said.find(place), std::string::npos) << said;
  EXPECT_NE(said.find(problem), std::string::npos) << said;
}

TEST(Links, what_holds_nothing_is_refused_with_its_place) {
  const auto with = [](const auto& change) {
    ModelSpec spec = two_on_ice();
    spec.tie = {tie_over_the_gap()};
    change(spec.tie[0]);
    return spec;
  };
  expect_refused(with([](TieSpec& t) { t.to.x = 7; }), "tie.0.to = (7, 0.25) m", "off the wall");
  expect_refused(with([](TieSpec& t) { t.to.x = 0.2; }), "tie.0 = left", "both ends on one block");
  expect_refused(with([](TieSpec& t) { t.to = {}; }), "tie.0.to", "one point");
  expect_refused(with([](TieSpec& t) { t.to = {}, t.anchored = true; }), "tie.0.to", "no point");
  expect_refused(with([](TieSpec& t) { t.area = kUnset; }), "tie.0.area", "missing");
  expect_refused(with([](TieSpec& t) { t.yield_strength = 1e6, t.prestress = 2e6; }),
                 "tie.0.prestress", "not below");
  ModelSpec spec = with([](TieSpec& t) { t.prestress = 1e6; });
  spec.stage = {push_right(Direction::kPlusX, 1e-3)};
  expect_refused(spec, "tie", "no stage draws");
  spec = with([](TieSpec&) {});
  spec.tie.push_back(spec.tie[0]);
  expect_refused(spec, "tie.1.name = tie", "another");
}

TEST(Links, half_said_floors_and_springs_are_refused) {
  ModelSpec spec = two_on_ice();
  DiaphragmSpec floor;
  floor.y = 0.4;
  floor.x = {0.5};
  floor.stiffness = 1e6;
  spec.diaphragm = {floor};
  expect_refused(spec, "diaphragm.0.x", "nothing to connect");
  spec.diaphragm[0].x = {0.5, 0.7};
  expect_refused(spec, "diaphragm.0.x.1 = left", "the block of the point before");
  spec.diaphragm[0].x = {2.5, 0.5};
  expect_refused(spec, "diaphragm.0.x", "not in order");
  spec.diaphragm[0].x = {0.5, 1.5};
  expect_refused(spec, "diaphragm.0.x.1 = (1.5, 0.4) m", "off the wall");
  spec.diaphragm[0].x = {0.5, 2.5};
  spec.diaphragm[0].stiffness = kUnset;
  expect_refused(spec, "diaphragm.0.stiffness", "missing");
  spec.diaphragm[0].kind = DiaphragmKind::kRigid;
  spec.diaphragm[0].stiffness = 1e6;
  expect_refused(spec, "diaphragm.0.stiffness", "no place in a rigid");
  spec.diaphragm[0].y = kUnset;
  expect_refused(spec, "diaphragm.0", "no level");
  spec = two_on_ice();
  spec.spring.emplace_back();
  expect_refused(spec, "spring.0.at", "one point");
  expect_refused(spec, "spring.0.stiffness", "missing");
}

TEST(Links, columns_of_links_csv_name_the_links) {
  const Ran r = solved(scenes::tied(scenes::small_wall(0.05e-3, 0.05)));
  EXPECT_EQ(r.model.links.name, (std::vector<std::string>{"across", "anchored", "diaphragm 1 1",
                                                          "diaphragm 1 2", "spring 1"}));
}

}  // namespace
}  // namespace wythe::links_test
