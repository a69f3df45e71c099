// The energy ledger of undamped walls that slide to and fro under a varying pressure: the work
// of friction is exact to second order in the time step (docs/theory/integration.md, 4.15).
#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

#include "scenes/scenes.h"
#include "scenes/zones.h"
#include "verification/record.h"
#include "wythe/parts/solve.h"

namespace wythe::verification::ledger_test {
namespace {

using scenes::degrees;

RecordSpec pulse(PulseShape shape, double amplitude, double period, Direction direction) {
  RecordSpec record;
  record.pulse = shape;
  record.amplitude = amplitude;
  record.period = period;
  record.direction = direction;
  return record;
}

// The base goes to and fro, and up and down four times as fast: the block slides both ways, under a pressure that rises and
// falls by the shaking and by its own bouncing on its joint.
StageSpec to_and_fro() {
  return {.name = "quake",
          .action = ShakeStage{.record = {pulse(PulseShape::kCycle, 9, 0.4, Direction::kPlusX),
                                          pulse(PulseShape::kRicker, 6, 0.1, Direction::kPlusY)},
                               .free_vibration = 0.1}};
}

EnergyLedger ledger(ModelSpec spec, double step_fraction) {
  spec.solve.step_fraction = step_fraction;
  const Model model = compile(spec);
  State state = initial_state(model);
  const Result result = solve(model, state);
  EXPECT_EQ(result.status, SolveStatus::kCompleted) << result.reason;
  return result.energy;
}
// The gap of the ledger, over the work of friction.
double missed(const ModelSpec& spec, double step_fraction) {
  const EnergyLedger energy = ledger(spec, step_fraction);
  EXPECT_GT(energy.friction, 0.2 * (std::fabs(energy.loads) + energy.elastic));
  return std::fabs(energy.gap) / energy.friction;
}

// At half of the longest step, and at a fifth of that.
void expect_second_order(const std::string& what, const ModelSpec& spec, double most) {
  constexpr double kCoarse = 0.5, kTimes = 5;
  verify({"EL01", what + ": what the ledger misses", "of the friction", 0, most,
          "where contact begins and ends within a step", true},
         missed(spec, kCoarse));
  verify({"EL01", what + ": the same with a fifth of the step", "of the friction", 0,
          2 * most / (kTimes * kTimes), "second order in the step; twice for its phase", true},
         missed(spec, kCoarse / kTimes));
}

ModelSpec sliding_block() {
  ModelSpec spec =
      scenes::block_on_ground(0.4, 0.2, scenes::dry_joint(1e9, 4e8, degrees(25)), 0.2, 2000);
  spec.stage = {scenes::gravity_stage(), to_and_fro()};
  return spec;
}

TEST(Ledger, a_block_that_slides_to_and_fro_in_its_plane) {
  expect_second_order("block sliding to and fro", sliding_block(), 2e-5);
}

TEST(Ledger, two_blocks_that_slide_on_each_other) {
  ModelSpec spec = scenes::stack(2, 0.4, 0.2, scenes::dry_joint(1e9, 4e8, degrees(25)), 0.2, 2000);
  spec.stage = {scenes::gravity_stage(), to_and_fro()};
  expect_second_order("two blocks sliding to and fro", spec, 2e-5);
}

// On a fixed block, so that it can be a wall in space too.
ModelSpec on_a_table(const JointMaterial& joint) {
  std::vector<BlockSpec> blocks = {scenes::rectangle("table", -1, -0.2, 2.4, 0.2),
                                   scenes::rectangle("block", 0, 0, 0.4, 0.2)};
  blocks.front().fixed = true;
  ModelSpec spec = scenes::assembly(std::move(blocks), joint, 0.2, 2000);
  spec.stage = {scenes::gravity_stage(), to_and_fro()};
  return spec;
}

TEST(Ledger, a_block_that_slides_to_and_fro_in_space) {
  ModelSpec spec = scenes::prisms(on_a_table(scenes::dry_joint(1e9, 4e8, degrees(25))));
  // across, out of step: the slip turns, and so does the block
  spec.stage.back().get<ShakeStage>().record.push_back(
      pulse(PulseShape::kCycle, 7, 0.25, Direction::kPlusZ));
  expect_second_order("block sliding in two directions", spec, 2e-5);
}

TEST(Ledger, a_deformable_block_that_slides_to_and_fro) {
  ModelSpec spec = on_a_table(scenes::dry_joint(1e9, 4e8, degrees(25)));
  spec.material["soft"] = scenes::elastic_body(1e9, 0.2, 2000);
  spec.block.back().material = "soft";
  spec.block.back().zone.zones = 2;
  spec.block.push_back(scenes::rectangle("rider", 0, 0.2, 0.4, 0.1));
  expect_second_order("deformable block sliding to and fro", spec, 2e-4);
  expect_second_order("deformable block sliding in space", scenes::prisms(spec), 2e-4);
}

// Its slip lifts it against the pressure, and a cap bounds that: crushing stays far away.
TEST(Ledger, a_joint_with_dilatancy_that_slides_to_and_fro) {
  JointMaterial joint = scenes::capped_joint();
  joint.normal_stiffness = 1e9, joint.shear_stiffness = 4e8;
  joint.tensile_strength = joint.cohesion = 2e3;
  joint.friction_angle = joint.residual_friction_angle = degrees(25);
  joint.mode_1_energy = 0.1, joint.mode_2_energy = 1;
  joint.dilatancy_slip = 0.05;
  // what is left of its bond breaks within a few of the coarse steps
  expect_second_order("joint with dilatancy sliding to and fro", on_a_table(joint), 2e-2);
}

}  // namespace
}  // namespace wythe::verification::ledger_test
