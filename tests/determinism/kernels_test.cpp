// Every set of kernels gives the bits of the scalar one: for each variant of the law, any number
// of points, small and large rotations of blocks, and runs that do not fill the last pack.
#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

#include "dynamics/executors/processor.h"
#include "scenes/scenes.h"
#include "scenes/shares.h"
#include "scenes/zones.h"

namespace wythe::kernels_test {
namespace {

using dynamics::Kernels;
using scenes::Shares;

// Blocks displaced at random: some joints open, some slide, some crush.
State scattered(const Model& model, double turn) {
  State state = initial_state(model);
  Shares share;
  for (auto* array : {&state.ux, &state.uy})
    for (double& u : *array) u = 2e-4 * share.next();
  for (auto* array : {&state.node_ux, &state.node_uy})
    for (double& u : *array) u = 2e-4 * share.next();
  for (double& theta : state.theta) theta = turn * share.next();
  for (double& slip : state.plastic_slip) slip = 1e-5 * share.next();
  state.gravity_y = -9.81;
  return state;
}

struct End {
  std::string hash;
  double friction, fracture, crushing, damping;
  bool operator==(const End&) const = default;
};

End step_with(const Kernels& kernels, const Model& model, double turn) {
  State state = scattered(model, turn);
  dynamics::Processor processor(model, 1, 1, kernels);
  processor.load_wall(0, model, state);
  processor.access(0)->choose_driven({3});
  dynamics::Controls controls;
  controls.damping = 0.4;
  controls.dt = model.solve.step_fraction * 2 / (model.omega_max * std::sqrt(1.4));
  processor.set(0, controls);
  for (int k = 0; k < 40; ++k) processor.step();
  processor.unload_wall(0);
  return {state_hash(state), state.energy.dissipated_friction, state.energy.dissipated_fracture,
          state.energy.dissipated_crushing, state.energy.work_damping};
}

// Crushing under pressure and shear, hardening and dilatancy.
void add_cap(JointMaterial& material) {
  material.compression_cap = 9;
  material.hardening_displacement = 0.01e-3;
  material.dilatancy_angle = 0.3 * material.residual_friction_angle;
}

Model wall_of(Softening softening, Coupling coupling, Unloading unloading, int points, bool cap,
              bool rising = false) {
  ModelSpec spec = scenes::plain_wall(5, 7, 0.3e-3, 0.05);
  for (auto& [name, material] : spec.material) {
    material.softening = softening;
    material.coupling = coupling;
    material.unloading = unloading;
    if (cap && std::isfinite(material.compressive_strength)) add_cap(material);
    if (rising) material.mode_2_energy_per_pressure = 0.2e-3;
  }
  spec.solve.points_per_face = points;
  return compile(spec);
}

TEST(Kernels, all_sets_give_the_bits_of_the_scalar_one) {
  const auto& all = dynamics::kernels_here();
  for (const Softening softening : {Softening::kBilinear, Softening::kExponential,
                                    Softening::kPolynomial, Softening::kPetersson})
    for (const Coupling coupling : {Coupling::kUnion, Coupling::kMaximum, Coupling::kStiffness})
      for (const Unloading unloading : {Unloading::kSecant, Unloading::kElastic})
        for (const int points : {2, 3, -2, -3}) {  // below 0: with a cap
          const Model model = wall_of(softening, coupling, unloading, std::abs(points), points < 0);
          for (const double turn : {1e-4, 0.4}) {
            const End scalar = step_with(*all[0], model, turn);
            EXPECT_GT(scalar.friction, 0);
            EXPECT_GT(scalar.fracture, 0);
            EXPECT_GT(scalar.crushing, 0);
            for (const Kernels* set : all)
              EXPECT_TRUE(step_with(*set, model, turn) == scalar)
                  << set->name << ", " << points << " points, turn " << turn;
          }
        }
}

// The end of a wall after 40 steps with the dashpots of its shake, and two of the stage behind it where `ended`.
End shake_with(const Kernels& kernels, const Model& model, double turn, bool ended) {
  State state = scattered(model, turn);
  dynamics::Processor processor(model, 1, 1, kernels);
  processor.load_wall(0, model, state);
  dynamics::Controls controls;
  controls.dt = 0.2 * 2 / model.omega_max;
  controls.dashpots = &model.stages[1].dashpots;
  processor.set(0, controls);
  for (int k = 0; k < 40; ++k) processor.step();
  if (ended) controls.dashpots = nullptr;
  processor.set(0, controls);
  for (int k = 0; k < 2; ++k) processor.step();
  processor.unload_wall(0);
  const bool has_elements = model.stages[1].dashpots.spring_share > 0;
  EXPECT_EQ(std::ranges::any_of(state.maxwell_normal, [](double q) { return q != 0; }),
            has_elements && !ended && turn < 0.1);  // turned further, all points are open
  EXPECT_NE(state.energy.work_damping, 0);
  return {state_hash(state), state.energy.dissipated_friction, state.energy.dissipated_fracture,
          state.energy.dissipated_crushing, state.energy.work_damping};
}

// Dashpots that rebound, Maxwell elements, and both, at closed, open and sliding points.
TEST(Kernels, all_sets_give_the_bits_of_the_scalar_one_in_a_shake) {
  for (const int kind : {0, 1, 2}) {
    ModelSpec spec = scenes::plain_wall(5, 7, 0.3e-3, 0.05);
    spec.stage = {scenes::gravity_stage(), scenes::shake_stage(5, 0.05)};
    if (kind == 0) spec.stage[1].get<ShakeStage>().maxwell_damping = {};
    if (kind == 1) spec.stage[1].get<ShakeStage>().restitution = 1;
    const Model model = compile(spec);
    for (const double turn : {1e-4, 0.4})
      for (const bool ended : {false, true}) {
        const End scalar = shake_with(*dynamics::kernels_here()[0], model, turn, ended);
        for (const Kernels* set : dynamics::kernels_here())
          EXPECT_TRUE(shake_with(*set, model, turn, ended) == scalar)
              << set->name << ", kind " << kind << ", turn " << turn;
      }
  }
}

TEST(Kernels, all_sets_give_the_bits_of_the_scalar_one_where_energy_grows_with_pressure) {
  for (const Softening softening : {Softening::kBilinear, Softening::kExponential})
    for (const bool cap : {false, true}) {
      const Model model = wall_of(softening, Coupling::kUnion, Unloading::kSecant, 3, cap, true);
      const Model without = wall_of(softening, Coupling::kUnion, Unloading::kSecant, 3, cap);
      const End scalar = step_with(*dynamics::kernels_here()[0], model, 1e-4);
      EXPECT_FALSE(scalar == step_with(*dynamics::kernels_here()[0], without, 1e-4));
      for (const Kernels* set : dynamics::kernels_here())
        EXPECT_TRUE(step_with(*set, model, 1e-4) == scalar) << set->name;
    }
}

// 15 x 3 zones and their contacts: whole packs and what is left over.
TEST(Kernels, all_sets_give_the_bits_of_the_scalar_one_on_zones) {
  for (const ZoneKind kind : {ZoneKind::kMixed, ZoneKind::kCst})
    for (const Unloading unloading : {Unloading::kSecant, Unloading::kElastic}) {
      ModelSpec spec = scenes::lintel_wall(LintelModel::kZones);
      spec.wall.opening[0].lintel.zones = 3;
      spec.wall.opening[0].lintel.zone_kind = kind;
      spec.material["joint"].unloading = unloading;
      const Model model = compile(spec);
      ASSERT_NE(model.solids.n_zone % dynamics::kGroup, 0);
      ASSERT_NE(model.solids.n_contact % dynamics::kGroup, 0);
      for (const double turn : {1e-4, 0.4}) {
        const End scalar = step_with(dynamics::scalar_kernels(), model, turn);
        for (const Kernels* set : dynamics::kernels_here())
          EXPECT_TRUE(step_with(*set, model, turn) == scalar) << set->name << ", turn " << turn;
      }
    }
}

// Each joint with a law of its own, of every variant; runs that do not fill the last pack.
TEST(Kernels, all_sets_give_the_bits_of_the_scalar_one_on_walls_with_fields) {
  for (const Softening softening : {Softening::kBilinear, Softening::kExponential})
    for (const int points : {2, 3, -3}) {  // below 0: with a cap
      ModelSpec spec = scenes::with_fields(scenes::plain_wall(5, 7, 0.3e-3, 0.05), 3);
      for (auto& [name, material] : spec.material) {
        material.softening = softening;
        if (points < 0 && std::isfinite(material.compressive_strength)) add_cap(material);
      }
      spec.solve.points_per_face = std::abs(points);
      const Model model = compile(spec);
      ASSERT_FALSE(model.stated_material.empty());
      for (const double turn : {1e-4, 0.4}) {
        const End scalar = step_with(dynamics::scalar_kernels(), model, turn);
        for (const Kernels* set : dynamics::kernels_here())
          EXPECT_TRUE(step_with(*set, model, turn) == scalar)
              << set->name << ", " << points << " points, turn " << turn;
      }
    }
}

TEST(Kernels, one_is_chosen_for_this_processor) {
  const std::string name = dynamics::kernels_in_use().name;
  EXPECT_TRUE(name == "scalar" || name == "sse2" || name == "avx2" || name == "avx512") << name;
}

}  // namespace
}  // namespace wythe::kernels_test
