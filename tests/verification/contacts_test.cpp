// Free contacts in the plane against closed forms: standing, toppling, sliding, falling and bouncing blocks.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "reading/free_contacts.h"
#include "scenes/rig.h"
#include "scenes/scenes.h"
#include "wythe/parts/solve.h"

namespace wythe::verification::contacts_test {
namespace {

using scenes::degrees;
using scenes::Rig;

constexpr double kG = 9.81, kThick = 0.2, kDensity = 2000;

// Soft, so that steps are long: 0.3 m of a block on it sink by 0.03 mm under 3 kN.
JointMaterial dry(double friction = degrees(30)) { return scenes::dry_joint(2e9, 1e9, friction); }

JointMaterial stiff() { return scenes::dry_joint(20e9, 10e9, degrees(30)); }

ModelSpec with_free_contacts(std::vector<BlockSpec> blocks, const JointMaterial& joint = dry()) {
  ModelSpec spec = scenes::assembly(std::move(blocks), joint, kThick, kDensity);
  spec.solve.contacts = Contacts::kFree;
  return spec;
}

BlockSpec table(double x, double width) {
  BlockSpec fixed = scenes::rectangle("table", x, -0.2, width, 0.2);
  fixed.fixed = true;
  return fixed;
}

// Every joint given up from the start: dry blocks that lie on each other.
void release(Rig& rig) {
  std::fill(rig.state.handed_over.begin(), rig.state.handed_over.end(), 1.0);
  rig.state.gravity_y = -kG;
}

double ledger_gap(const EnergyLedger& e) { return std::fabs(e.gap); }

// --- at rest ---------------------------------------------------------------------------------------------

TEST(FreeContacts, a_block_over_an_edge_topples_when_its_centroid_has_passed_it) {
  // corners are cut off by a thousandth of a block, 0.17 mm: the edge lies that much further in
  for (const double beyond : {-4e-3, 4e-3}) {  // on so narrow a strip it sinks in, and leans
    Rig rig(compile(with_free_contacts(
        {table(0, 0.5), scenes::rectangle("block", 0.35 + beyond, 0, 0.3, 0.1)}, stiff())));
    release(rig);
    rig.controls.damping = 0.2;
    rig.run(1.0);
    const double turned = std::fabs(rig.state.theta[0]);
    if (beyond < 0) {
      EXPECT_LT(turned, 2e-3);
    } else {
      EXPECT_GT(turned, 0.1);
    }
  }
}

// Five blocks, each over the one below by a share of length / (2 k), k blocks above the edge: the harmonic
// overhang stands up to a share of 1.
TEST(FreeContacts, a_leaning_tower_of_five_stands_up_to_the_harmonic_overhang) {
  for (const double share : {0.95, 1.05}) {  // blocks sink in where they bear on a strip, and lean
    std::vector<BlockSpec> blocks{table(-1, 1.3)};
    double x = 0;
    for (int k = 5; k >= 1; --k) {
      x += share * 0.3 / (2 * k);
      blocks.push_back(scenes::rectangle("b" + std::to_string(5 - k), x, 0.1 * (5 - k), 0.3, 0.1));
    }
    Rig rig(compile(with_free_contacts(blocks, stiff())));
    release(rig);
    rig.controls.damping = 0.8;
    for (int k = 1; k <= 50; ++k) {  // weight by and by
      rig.state.gravity_y = -kG * k / 50;
      rig.run(4e-3);
    }
    rig.controls.damping = 0.1;
    rig.run(1.0);
    const double fell = -*std::min_element(rig.state.uy.begin(), rig.state.uy.end());
    if (share < 1) {
      EXPECT_LT(fell, 2e-3);
    } else {
      EXPECT_GT(fell, 0.05);
    }
  }
}

TEST(FreeContacts, a_stack_of_ten_rests_for_a_minute_without_drift) {
  std::vector<BlockSpec> blocks{table(-1, 2)};
  for (int k = 0; k < 10; ++k)
    blocks.push_back(scenes::rectangle("b" + std::to_string(k), 0.01 * (k % 3), 0.1 * k, 0.3, 0.1));
  Rig rig(compile(with_free_contacts(blocks)));
  release(rig);
  rig.settle(1e-9);
  const State settled = rig.state;
  rig.controls.damping = 0;  // nothing holds it back
  rig.run(60.0);
  for (std::size_t i = 0; i < 10; ++i) {
    EXPECT_NEAR(rig.state.ux[i], settled.ux[i], 1e-9);
    EXPECT_NEAR(rig.state.uy[i], settled.uy[i], 1e-9);
    EXPECT_NEAR(rig.state.theta[i], settled.theta[i], 1e-9);
  }
}

// --- in motion -------------------------------------------------------------------------------------------

TEST(FreeContacts, friction_sticks_and_slides_at_its_tangent) {
  const double friction = degrees(30);
  // on the verge the sudden turn of gravity makes it tremble and creep
  for (const double slope : {degrees(27), degrees(33)}) {
    Rig rig(compile(with_free_contacts({table(-1, 3), scenes::rectangle("block", 0, 0, 0.3, 0.05)},
                                       dry(friction))));
    release(rig);
    rig.settle(1e-9);
    rig.controls.damping = 0;
    const double start = rig.state.ux[0];
    rig.state.gravity_x = kG * std::sin(slope);
    rig.state.gravity_y = -kG * std::cos(slope);
    rig.run(0.4);
    const double pulled = kG * (std::sin(slope) - std::tan(friction) * std::cos(slope));
    const double moved = rig.state.ux[0] - start;
    if (slope < friction) {
      EXPECT_LT(std::fabs(moved), 1e-4);
    } else {
      // elastic slip and the bounce of the sudden turn of gravity
      EXPECT_NEAR(moved, 0.5 * pulled * 0.4 * 0.4, 0.02 * moved);
    }
  }
}

// In the plane what is driven is a block, not a support.
TEST(FreeContacts, a_driven_block_drags_what_lies_on_it) {
  constexpr double kSpeed = 1, kFriction = 0.3;
  ModelSpec spec = with_free_contacts({table(-1, 4), scenes::rectangle("sledge", 0, 0, 1.5, 0.1),
                                       scenes::rectangle("block", 0.6, 0.1, 0.3, 0.05)},
                                      dry(std::atan(kFriction)));
  spec.stage = {scenes::gravity_stage(), scenes::push_stage("sledge", Direction::kPlusX, 1, 1)};
  Rig rig(compile(spec));
  release(rig);
  rig.settle(1e-9);
  rig.controls.damping = 0;
  const double start = rig.state.ux[1], sledge = rig.state.ux[0], before = rig.energy().friction;
  rig.drive(1, kSpeed);
  rig.run(0.2);
  const double pull = kFriction * kG, weight = rig.model.mass[1] * kG;
  EXPECT_NEAR(rig.state.vx[1], 0.2 * pull, 0.02 * pull);
  EXPECT_NEAR(rig.state.ux[1] - start, 0.5 * pull * 0.04, 1e-3);
  rig.run(0.4);
  const double behind = kSpeed * kSpeed / (2 * pull);
  EXPECT_NEAR(rig.state.vx[1], kSpeed, 2e-3);
  EXPECT_NEAR(rig.state.ux[0] - sledge - (rig.state.ux[1] - start), behind, 0.01 * behind);
  // that of the block, and of both on the table
  const double below = kFriction * (weight + rig.model.mass[0] * kG) * (rig.state.ux[0] - sledge);
  const EnergyLedger e = rig.energy();
  EXPECT_NEAR(e.friction - before, kFriction * weight * behind + below, 0.01 * below);
  EXPECT_LT(ledger_gap(e), 2e-3 * e.friction);
}

// Debris that lands fast rolls: a square stone that falls off a wall of five metres turns more than ten times. Sines that
// were made for less than a turn let such stones grow, and a push at 2 m/s ran away.
TEST(FreeContacts, a_stone_that_rolls_many_turns_makes_no_energy) {
  Rig rig(compile(with_free_contacts({table(-2, 60), scenes::rectangle("stone", 0, 0, 0.1, 0.1)},
                                     dry(degrees(31)))));
  rig.state.gravity_y = -kG;
  rig.state.ux[0] = 0.4;
  rig.state.uy[0] = 0.3;
  rig.state.theta[0] = 0.4;
  rig.state.vx[0] = 10;
  rig.state.vy[0] = -9;
  rig.controls.damping = 0;
  const double mass = kDensity * 0.1 * 0.1 * kThick;
  const double given = 0.5 * mass * (100 + 81) + mass * kG * 0.3;
  for (int k = 0; k < 400; ++k) {
    rig.run(0.01);
    const EnergyLedger e = rig.energy();
    // nothing in the ledger gave it the motion that it starts with
    ASSERT_LT(std::fabs(std::fabs(e.gap) - 0.5 * mass * (100 + 81)), 0.02 * given)
        << rig.state.time;
    ASSERT_LT(e.kinetic + mass * kG * rig.state.uy[0], 1.01 * given);
    ASSERT_GT(rig.state.uy[0], -0.06);
  }
  EXPECT_GT(std::fabs(rig.state.theta[0]), 20 * M_PI);
}

// At the longest stable step an impact is seen in a few steps, and its energy is right to some 1e-3.
TEST(FreeContacts, a_dropped_block_falls_in_time_and_bounces_without_gaining_energy) {
  for (const auto& [share_of_step, allowed] : {std::pair(1.0, 5e-3), {0.2, 2e-4}}) {
    // lifted and beside its place, so that its joint gives way
    Rig rig(
        compile(with_free_contacts({table(-2, 4), scenes::rectangle("block", 0, 0, 0.3, 0.1)})));
    rig.state.gravity_y = -kG;
    rig.state.ux[0] = 0.8;
    rig.state.uy[0] = 0.2;
    rig.state.theta[0] = 0.3;
    rig.controls.damping = 0;
    rig.controls.dt *= share_of_step;
    const double low = 0.05 * std::cos(0.3) + 0.15 * std::sin(0.3);
    const double drop = 0.25 - low, time = std::sqrt(2 * drop / kG);
    rig.run(time - 2e-3);
    const double now = rig.state.time;  // half a step of velocity is ahead
    EXPECT_NEAR(rig.state.uy[0], 0.2 - 0.5 * kG * now * (now + rig.controls.dt), 1e-9);
    EXPECT_TRUE(rig.state.free_contacts.empty());
    rig.run(4e-3);
    EXPECT_FALSE(rig.state.free_contacts.empty() && rig.state.vy[0] < 0) << "it has landed";
    const double given = kG * kDensity * 0.3 * 0.1 * kThick * drop;
    double most = 0, friction = 0;
    int flights = 0;
    for (int k = 0; k < 600; ++k) {
      rig.run(2e-3);
      // in a bounce kinetic and elastic energy, half a step apart, do not belong to one instant
      if (!rig.state.free_contacts.empty()) continue;
      ++flights;
      const EnergyLedger e = rig.energy();
      most = std::max(most, ledger_gap(e) / given);
      EXPECT_GE(e.friction, friction);
      friction = e.friction;
    }
    EXPECT_GT(flights, 100);
    EXPECT_GT(friction, 0.1 * given);
    EXPECT_LT(most, allowed);
    EXPECT_GT(rig.state.uy[0], -0.06);  // on the table, not in it
  }
}

TEST(FreeContacts, a_row_of_dominoes_falls) {
  std::vector<BlockSpec> blocks{table(-1, 4)};
  constexpr std::size_t kPieces = 8;
  for (std::size_t k = 0; k < kPieces; ++k)
    blocks.push_back(
        scenes::rectangle("d" + std::to_string(k), 0.1 * static_cast<double>(k), 0, 0.03, 0.2));
  Rig rig(compile(with_free_contacts(blocks)));
  rig.state.gravity_y = -kG;
  rig.settle(1e-8);
  rig.controls.damping = 0.05;
  rig.state.omega[0] = -2;  // about its foot
  rig.state.vx[0] = 0.2;
  rig.run(2.0);
  // each on the next, the last on the table
  for (std::size_t k = 0; k < kPieces; ++k) EXPECT_LT(rig.state.theta[k], -1.1) << k;
  EXPECT_NEAR(rig.state.theta[kPieces - 1], -scenes::kPi / 2, 1e-2);
}

// The deepest a block may go at speed v is that where all its motion is stored: v sqrt(m / (kn A)), flat; more on
// a corner, V = kn t d^3 / 3 for a right angle on its tip.
TEST(FreeContacts, no_block_passes_through_another) {
  Rig rig(compile(with_free_contacts({table(-2, 4), scenes::rectangle("thin", 0, 0, 0.5, 0.01),
                                      scenes::rectangle("fast", 0, 0.01, 0.1, 0.1)})));
  rig.state.gravity_y = -kG;
  rig.state.ux[1] = 0.2;
  rig.state.uy[1] = 0.1;
  rig.state.theta[1] = degrees(45);
  rig.state.vy[1] = -10;
  rig.controls.damping = 0;
  const double mass = kDensity * 0.1 * 0.1 * kThick;
  const double deepest = std::cbrt(3 * 0.5 * mass * 100 / (2e9 * kThick));
  for (int k = 0; k < 400; ++k) {
    rig.run(1e-3);
    EXPECT_LT(reading::deepest_overlap(rig.model, rig.state), 1.1 * deepest);
    ASSERT_GT(rig.state.uy[1], -0.06);
    ASSERT_GT(rig.state.uy[0], -0.02);
  }
}

// --- from joints to free contacts ----------------------------------------------------------------------------

TEST(FreeContacts, a_joint_that_has_slipped_gives_way_without_a_jump) {
  ModelSpec spec = with_free_contacts({table(-1, 3), scenes::rectangle("block", 0, 0, 0.3, 0.1)});
  spec.stage = {scenes::gravity_stage(),
                scenes::push_stage("block", Direction::kPlusX, 0.05, 0.05)};
  Rig rig(compile(spec));
  rig.state.gravity_y = -kG;
  rig.settle(1e-9);
  rig.drive(1, 0.05);
  double last = 0;
  bool handed = false;
  for (int k = 0; k < 200000 && rig.state.ux[0] < 0.03; ++k) {
    const double before = rig.contact(0).y;
    rig.step();
    const bool now = rig.state.handed_over[0] != 0;
    if (now && !handed) {
      EXPECT_NEAR(rig.contact(0).y, before, 1e-4 * before);
      EXPECT_NEAR(rig.state.ux[0], 0.05 * 0.3, 2e-3);
      EXPECT_EQ(rig.state.hand_overs.size(), 1U);
    }
    handed = now;
    last = rig.contact(0).x;
  }
  EXPECT_TRUE(handed);
  const double weight = kG * kDensity * 0.3 * 0.1 * kThick;
  EXPECT_NEAR(-last, std::tan(degrees(30)) * weight, 1e-2 * weight);
  for (const HandOver& h : rig.state.hand_overs) EXPECT_LE(h.share, 1);
  const EnergyLedger e = rig.energy();
  EXPECT_LT(ledger_gap(e), 1e-3 * e.friction);
}

// What is crushed presses no more. Were it given back as a force, this block would be thrown off with hundreds of times
// the work that pushes it over the edge.
TEST(FreeContacts, a_crushed_joint_gives_way_without_making_energy) {
  constexpr double kCrushed = 4e-3;
  JointMaterial joint = dry();
  joint.compressive_strength = 1e6, joint.compressive_energy = 1e4;
  ModelSpec spec =
      with_free_contacts({table(-0.5, 1.0), scenes::rectangle("block", 0, 0, 0.3, 0.1)}, joint);
  spec.stage = {scenes::gravity_stage(), scenes::push_stage("block", Direction::kPlusX, 0.2, 0.6)};
  Rig rig(compile(spec));
  std::fill(rig.state.crush.begin(), rig.state.crush.end(), kCrushed);
  rig.state.uy[0] = -kCrushed;
  rig.state.gravity_y = -kG;
  rig.controls.damping = 0.2;
  rig.settle(1e-6);
  const double weight = kG * kDensity * 0.3 * 0.1 * kThick;
  rig.drive(1, 0.2);
  bool handed = false;
  double fastest = 0;
  for (int k = 0; k < 400000 && rig.state.ux[0] < 0.55; ++k) {
    const double before = rig.contact(0).y;
    rig.step();
    if (rig.state.handed_over[0] != 0 && !handed) {
      handed = true;
      EXPECT_NEAR(rig.contact(0).y, before, 1e-3 * weight);
      ASSERT_EQ(rig.state.free_contacts.size(), 1U);
      EXPECT_NEAR(rig.state.free_contacts[0].rest, kCrushed, 1e-5);
      EXPECT_LT(std::fabs(rig.state.energy.lost_in_hand_over), 1e-5 * weight);
    }
    fastest = std::fmax(fastest, std::fabs(rig.state.vy[0]));
  }
  EXPECT_TRUE(handed);
  EXPECT_LT(rig.state.uy[0], -0.1);  // it has fallen over the edge
  EXPECT_LT(fastest, 1.2 * std::sqrt(2 * kG * -rig.state.uy[0]));
  const EnergyLedger e = rig.energy();
  // where the contact turns over the edge of the table some of what presses is lost; nothing comes of it
  EXPECT_GT(e.hand_over, -1e-2 * weight * 0.1);
  EXPECT_LT(e.hand_over, 0.2 * weight * 0.1);
  EXPECT_LT(ledger_gap(e), 1e-2 * (e.friction + e.kinetic));
}

// A dead load is a weight: it neither throws its block down nor follows it for ever.
TEST(FreeContacts, a_dead_load_falls_no_faster_than_a_weight) {
  constexpr double kHeight = 0.1;
  ModelSpec spec = with_free_contacts(
      {table(0, 0.5), scenes::rectangle("block", 0.4, 0, 0.3, kHeight)}, stiff());
  StageSpec load{.name = "load", .action = LoadStage{.pressure = 5e5}};
  spec.stage = {scenes::gravity_stage(), load};
  Rig rig(compile(spec));
  release(rig);
  rig.state.load_scale[1] = 1;
  rig.controls.damping = 0;
  for (int k = 0; k < 1000000 && rig.state.uy[0] > -1.0; ++k) {
    rig.step();
    const double fall = -rig.state.uy[0], speed = rig.state.vy[0];
    ASSERT_LT(speed * speed, 2.1 * 2 * kG * (std::fmax(fall, 0.0) + kHeight / 4)) << fall;
  }
  EXPECT_LT(rig.state.uy[0], -1.0);
  const double weight = kG * kDensity * 0.3 * kHeight * kThick, all = 5e5 * 0.3 * kThick;
  EXPECT_LT(rig.state.energy.work_loads, weight * 1.01 + all * kHeight);
  EXPECT_GT(rig.state.energy.work_loads, weight);
}

TEST(FreeContacts, a_block_pushed_off_its_neighbour_falls) {
  ModelSpec spec = with_free_contacts({table(0, 0.5), scenes::rectangle("block", 0, 0, 0.3, 0.1)});
  spec.solve.ground = -0.2;
  spec.stage = {scenes::gravity_stage(), scenes::push_stage("block", Direction::kPlusX, 0.5, 0.6)};
  spec.stage[1].damping = 0.1;
  const Model model = compile(spec);
  State state = initial_state(model);
  const Result result = solve(model, state);
  EXPECT_EQ(result.status, SolveStatus::kCompleted) << result.reason;
  EXPECT_LT(state.uy[0], -0.05);  // it may lean on the table
  EXPECT_EQ(result.debris.blocks, 1);
  EXPECT_NEAR(result.debris.volume, 0.3 * 0.1 * kThick, 1e-12);
  EXPECT_GT(result.debris.reach, 0.1);
  EXPECT_LT(result.energy.gap_ratio, 0.01);
}

}  // namespace
}  // namespace wythe::verification::contacts_test
