// Maxwell elements at contacts, and dashpots at free contacts, against closed forms (docs/theory/dynamics.md, 14.8 to
// 14.11).
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <complex>
#include <string>
#include <vector>

#include "model/shaking.h"
#include "scenes/rig.h"
#include "scenes/scenes.h"
#include "verification/record.h"
#include "wythe/parts/solve.h"

namespace wythe::verification::maxwell_test {
namespace {

using scenes::degrees;
using scenes::Rig;

constexpr double kG = 9.81, kPeriod = 0.2, kOmega = 2 * M_PI / kPeriod;

RecordSpec pulse(double amplitude, double period) {
  RecordSpec record;
  record.pulse = PulseShape::kHalfCycle;
  record.amplitude = amplitude;
  record.period = period;
  record.direction = Direction::kPlusY;
  return record;
}
StageSpec shake(double amplitude) {
  return {.name = "quake",
          .action = ShakeStage{
              .record = {pulse(amplitude, 0.3)}, .free_vibration = 1.5, .interval = 1e-3}};
}

// 20 kg on an upright spring; a push from below sets it going.
ModelSpec oscillator(const ViscousSpec& damping) {
  const double stiffness = 20 * kOmega * kOmega / 0.03;
  std::vector<BlockSpec> blocks = {scenes::rectangle("base", 0, -0.1, 0.1, 0.1),
                                   scenes::rectangle("b0", 0, 0, 0.1, 0.3)};
  blocks.front().fixed = true;
  ModelSpec spec = scenes::assembly(
      std::move(blocks), scenes::elastic_joint(stiffness, 0.4 * stiffness), 0.3, 20 / 0.009);
  StageSpec quake = shake(2);
  quake.get<ShakeStage>().maxwell_damping = damping;
  spec.stage = {scenes::gravity_stage(), quake};
  spec.solve.step_fraction = 0.02;  // some 200 steps a period
  return spec;
}

// Root of s^2 + w^2 (1 + share s T / (1 + s T)) = 0, by Newton's method from the undamped vibration.
std::complex<double> root_of(const ViscousSpec& damping) {
  const MaxwellElement e = maxwell_element(damping.fraction, damping.frequency);
  std::complex<double> s(0, kOmega);
  for (int k = 0; k < 50; ++k) {
    const std::complex<double> loose = 1.0 + s * e.relaxation;
    const std::complex<double> f =
        s * s + kOmega * kOmega * (1.0 + e.share * s * e.relaxation / loose);
    s -= f / (2.0 * s + kOmega * kOmega * e.share * e.relaxation / (loose * loose));
  }
  return s;
}

// Logarithmic decrement of the free vibration, by crests between rows.
double decrement(const ModelSpec& spec) {
  const Model model = compile(spec);
  State state = initial_state(model);
  const Result result = solve(model, state);
  EXPECT_EQ(result.status, SolveStatus::kCompleted) << result.reason;
  const ShakeHistory& h = result.history;
  const auto moved = [&](std::size_t k) { return h.motion[k][1] - h.motion.front()[1]; };
  std::vector<double> crests;  // once the element has forgotten the push
  for (std::size_t k = 1; k + 1 < h.row.size(); ++k) {
    if (h.row[k].time < 0.5 || moved(k) <= moved(k - 1) || moved(k) < moved(k + 1)) continue;
    const double slope = 0.5 * (moved(k + 1) - moved(k - 1));
    crests.push_back(moved(k) - 0.5 * slope * slope / (moved(k + 1) - 2 * moved(k) + moved(k - 1)));
  }
  EXPECT_GE(crests.size(), 5U);
  return std::log(crests[0] / crests[4]) / 4;
}

TEST(Maxwell, a_block_on_a_joint_decays_as_in_closed_form) {
  for (const double frequency : {2.5, 5.0, 10.0, 20.0}) {
    const ViscousSpec damping{0.05, frequency};
    const std::complex<double> s = root_of(damping);
    const double wanted = -2 * M_PI * s.real() / s.imag();
    for (const bool in_space : {false, true}) {
      const ModelSpec plane = oscillator(damping);
      verify({"MX01",
              fmt::format("Maxwell elements of 5 % at {:g} Hz{}: decrement at 5 Hz", frequency,
                          in_space ? ", in space" : ""),
              "-", wanted, 1e-2, "crests are read between rows"},
             decrement(in_space ? scenes::prisms(plane) : plane));
    }
    // half of the loss factor, at the frequency of the vibration: what is stated
    const double f = s.imag() / (2 * M_PI);
    const double stated = 0.05 * 2 * f * frequency / (f * f + frequency * frequency);
    EXPECT_NEAR(-s.real() / std::abs(s), stated, 0.06 * stated) << frequency;
  }
}

TEST(Maxwell, elements_shorten_the_step_by_the_root_of_what_they_stiffen) {
  Dashpots d;
  d.spring_share = maxwell_element(0.05, 10).share;
  EXPECT_NEAR(d.spring_share, 8 * 0.0025 + 0.2 * std::sqrt(1.01), 1e-12);
  EXPECT_NEAR(share_of_step(1e4, d), 1 / std::sqrt(1 + d.spring_share), 1e-12);
  EXPECT_NEAR(share_of_step(1e4, d), 0.905, 1e-3);
}

// A dry block that slides, lifts off and comes down: what the elements took is never negative, and the ledger closes.
TEST(Maxwell, elements_never_give_back_more_than_they_took) {
  ModelSpec spec =
      scenes::block_on_ground(0.2, 0.5, scenes::dry_joint(1e9, 4e8, degrees(25)), 0.2, 2000);
  spec.solve.point_rule = PointRule::kCorners;
  StageSpec quake = shake(0);
  quake.get<ShakeStage>().maxwell_damping = {0.2, 30};
  spec.stage = {scenes::gravity_stage(), quake};
  Rig rig(compile(spec));
  rig.state.gravity_y = -kG;
  rig.settle(1e-9);
  rig.controls.damping = 0;
  rig.controls.dashpots = &rig.model.stages.back().dashpots;
  rig.controls.dt = 0.1 * 2 / rig.model.omega_max;
  const double before = rig.state.energy.work_damping;
  const EnergyLedger start = rig.energy();
  double least = 0, most = 0;
  const double stop = rig.state.time + 2;
  while (rig.state.time < stop) {
    rig.state.gravity_x = 6 * std::sin(25 * rig.state.time);
    rig.state.gravity_y = -kG - 14 * std::sin(60 * rig.state.time);
    rig.step();
    const double taken = before - rig.state.energy.work_damping;
    least = std::fmin(least, taken);
    most = std::fmax(most, taken);
  }
  const EnergyLedger end = rig.energy();
  const double worked = std::fabs(end.friction - start.friction) + most;
  EXPECT_GT(most, 0.1);
  EXPECT_GT(least, -1e-9 * most);
  EXPECT_LT(std::fabs(end.gap - start.gap), 5e-3 * worked);
}

// A stage with other dashpots leaves nothing in them: what they held would come back as a blow in the next stage that has some.
TEST(Maxwell, elements_hold_nothing_after_a_stage_without_them) {
  ModelSpec plane = oscillator({0.3, 2});
  plane.stage.back().get<ShakeStage>().record = {pulse(2, 0.2)};
  plane.stage.back().get<ShakeStage>().free_vibration = 0;
  StageSpec other = plane.stage.back();
  other.name = "other", other.get<ShakeStage>().maxwell_damping = {},
  other.get<ShakeStage>().restitution = 0.3;
  const auto held = [](const ModelSpec& spec) {
    const Model model = compile(spec);
    State state = initial_state(model);
    EXPECT_EQ(solve(model, state).status, SolveStatus::kCompleted);
    double most = 0;
    for (const double q : state.maxwell_normal) most = std::fmax(most, std::fabs(q));
    return most;
  };
  for (const bool in_space : {false, true}) {
    const ModelSpec first = in_space ? scenes::prisms(plane) : plane;
    EXPECT_GT(held(first), 1.0) << in_space;
    ModelSpec second = first;
    second.stage.push_back(other);
    EXPECT_EQ(held(second), 0.0) << in_space;
  }
}

// --- free contacts ------------------------------------------------------------------------------------------

struct Bounce {
  double height = 0, gap = 0;  // over the fall; of the ledger over the energy of the fall
};
// A flat block falls on a table that it has no joint with.
Bounce bounce(double restitution) {
  std::vector<BlockSpec> blocks = {scenes::rectangle("table", -2, -0.2, 4, 0.2),
                                   scenes::rectangle("block", 0, 0, 0.4, 0.2)};
  blocks.front().fixed = true;
  ModelSpec spec =
      scenes::assembly(std::move(blocks), scenes::dry_joint(2e10, 8e9, degrees(40)), 0.2, 2000);
  spec.solve.contacts = Contacts::kFree;
  StageSpec quake = shake(0);
  quake.get<ShakeStage>().restitution = restitution;
  spec.stage = {scenes::gravity_stage(), quake};
  Rig rig(compile(spec));
  std::fill(rig.state.handed_over.begin(), rig.state.handed_over.end(), 1.0);
  const Stage& stage = rig.model.stages.back();
  rig.controls.dt = 0.05 * 2 / rig.model.omega_max;
  rig.controls.damping = 0;
  if (stage.dashpots.any()) rig.controls.dashpots = &stage.dashpots;
  rig.state.gravity_y = -kG;
  rig.state.uy[0] = 0.1;
  double before = 0.1;
  while (rig.state.uy[0] > 0) rig.step();
  do {
    before = rig.state.uy[0];
    rig.step();
  } while (rig.state.uy[0] > before || before < 0);
  const double fell = kG * 2000 * 0.4 * 0.2 * 0.2 * 0.1;
  return {before / 0.1, std::fabs(rig.energy().gap) / fell};
}

TEST(FreeDashpots, a_block_that_falls_flat_comes_back_with_its_restitution) {
  for (const double e : {1.0, 0.8, 0.5, 0.2}) {
    const Bounce b = bounce(e);
    verify(
        {"MX02", fmt::format("dropped on a free contact, restitution {:g}: rebound", e),
         "of the fall", e * e, 1e-2, "where contact begins and ends within a step; gravity", true},
        b.height);
    EXPECT_LT(b.gap, 5e-3) << e;
  }
}

}  // namespace
}  // namespace wythe::verification::maxwell_test
