// Laws of nature: momentum, work conjugacy, the energy ledger, dissipation, contact points.
#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "scenes/rig.h"
#include "scenes/scenes.h"
#include "wythe/parts/solve.h"

namespace wythe::mechanics_test {
namespace {

using scenes::Rig;

constexpr scenes::BondSize kSmall{
    .columns = 3, .courses = 3, .hole_at_column = 9, .hole_at_course = 9};

// A number in [-1, 1].
double random_share() { return *rc::gen::resize(100, rc::gen::inRange(-1000, 1001)) * 1e-3; }

// Every block moved by up to `move` [m] and turned by up to `turn` [rad].
void scatter(State& state, double move, double turn) {
  for (std::size_t i = 0; i < state.ux.size(); ++i) {
    state.ux[i] = move * random_share();
    state.uy[i] = move * random_share();
    state.theta[i] = turn * random_share();
  }
}

// --- momentum -------------------------------------------------------------------------------------------

// Moment about the origin of what joint j does to both its blocks together, and its size.
struct Couple {
  double sum, size;
};
Couple couple_of(const Rig& rig, const State& before, std::size_t j) {
  const auto a = static_cast<std::size_t>(rig.model.joint_a[j]);
  const auto b = static_cast<std::size_t>(rig.model.joint_b[j]);
  const auto row = rig.force(j);
  const double fx = row[0], fy = row[1];
  const double xa = rig.model.centroid_x[a] + before.ux[a],
               ya = rig.model.centroid_y[a] + before.uy[a];
  const double xb = rig.model.centroid_x[b] + before.ux[b],
               yb = rig.model.centroid_y[b] + before.uy[b];
  const double on_a = xa * fy - ya * fx, on_b = -(xb * fy - yb * fx);
  return {on_a + on_b + row[2] + row[3],
          std::fabs(on_a) + std::fabs(on_b) + std::fabs(row[2]) + std::fabs(row[3])};
}

TEST(Momentum, joints_make_no_linear_or_angular_momentum) {
  EXPECT_TRUE(rc::check([] {
    ModelSpec spec = scenes::half_units(kSmall, scenes::paper_joint());
    spec.solve.points_per_face = *rc::gen::inRange(2, 6);
    Rig rig(compile(spec));
    scatter(rig.state, 3e-5, *rc::gen::element(1e-4, 0.3));  // small and large turns
    for (double& slip : rig.state.plastic_slip) slip = 1e-5 * random_share();
    const State before = rig.state;
    rig.step();
    for (std::size_t j = 0; j < static_cast<std::size_t>(rig.model.n_pair); ++j) {
      const Couple couple = couple_of(rig, before, j);
      RC_ASSERT(std::fabs(couple.sum) <= 1e-13 * couple.size);  // some hundred roundings
    }
    // forces cancel in pairs: what is left of the blocks' sum comes from the ground
    double sum_x = 0, sum_y = 0, size = 0;
    for (std::size_t i = 0; i < rig.state.ux.size(); ++i) {
      const auto contact = rig.contact(i);
      sum_x += contact.x;
      sum_y += contact.y;
      size += std::fabs(contact.x) + std::fabs(contact.y);
    }
    for (auto j = static_cast<std::size_t>(rig.model.n_pair); j < rig.model.joint_b.size(); ++j) {
      sum_x += rig.force(j)[0];
      sum_y += rig.force(j)[1];
    }
    RC_ASSERT(std::fabs(sum_x) + std::fabs(sum_y) <= 1e-12 * size);
  }));
}

// --- work conjugacy -------------------------------------------------------------------------------------

double potential(Rig& rig, const State& at, const State& along, double share) {
  State moved = at;
  for (std::size_t i = 0; i < at.ux.size(); ++i) {
    moved.ux[i] += share * along.ux[i];
    moved.uy[i] += share * along.uy[i];
    moved.theta[i] += share * along.theta[i];
  }
  return dynamics::elastic_energy(rig.model, moved);
}

TEST(Conjugacy, forces_are_the_gradient_of_the_elastic_energy_at_any_rotation) {
  EXPECT_TRUE(rc::check([] {
    Rig rig(compile(scenes::half_units(kSmall, scenes::elastic_joint(20e9, 8e9))));
    scatter(rig.state, 1e-3, *rc::gen::element(1e-3, 0.3));
    const State at = rig.state;
    State along = at;
    scatter(along, 1e-3, 1e-2);
    rig.step();
    double power = 0, size = 0;
    for (std::size_t i = 0; i < at.ux.size(); ++i) {
      const auto contact = rig.contact(i);
      const double terms[] = {contact.x * along.ux[i], contact.y * along.uy[i],
                              contact.m * along.theta[i]};
      for (const double term : terms) {
        power -= term;
        size += std::fabs(term);
      }
    }
    // central differences miss by the square of the step: half the step, a quarter of the miss
    double miss[2];
    for (int k = 0; k < 2; ++k) {
      const double h = k == 0 ? 0.2 : 0.1;
      miss[k] = (potential(rig, at, along, h) - potential(rig, at, along, -h)) / (2 * h) - power;
    }
    RC_ASSERT(std::fabs(miss[1]) <= 1e-3 * size);
    RC_ASSERT(std::fabs((4 * miss[1] - miss[0]) / 3) <= 1e-6 * size);  // fourth-order rest
  }));
}

// --- energy ---------------------------------------------------------------------------------------------

TEST(Energy, ledger_closes_on_a_push_that_cracks_and_slides) {
  for (const int points : {2, 3, 5}) {
    ModelSpec spec = scenes::small_wall(4e-3, 0.05);
    spec.solve.points_per_face = points;
    const Model model = compile(spec);
    State state = initial_state(model);
    const Result result = solve(model, state);
    ASSERT_EQ(result.status, SolveStatus::kCompleted) << result.reason;
    const EnergyLedger& e = result.energy;
    EXPECT_GT(e.fracture, 0.01 * e.drive) << points;
    EXPECT_GT(e.friction, 0) << points;
    EXPECT_GT(e.damping, 0) << points;
    EXPECT_LT(std::fabs(e.gap), 1e-3 * (std::fabs(e.loads) + std::fabs(e.drive))) << points;
  }
}

TEST(Energy, ledger_closes_for_every_law) {
  for (const Softening softening :
       {Softening::kExponential, Softening::kPolynomial, Softening::kPetersson})
    for (const Coupling coupling : {Coupling::kMaximum, Coupling::kStiffness}) {
      ModelSpec spec = scenes::small_wall(1e-3, 0.05);
      for (auto& [name, m] : spec.material) {
        m.softening = softening;
        m.coupling = coupling;
        m.unloading = coupling == Coupling::kMaximum ? Unloading::kElastic : Unloading::kSecant;
      }
      spec.solve.step_fraction = 0.5;  // what the ledger misses shrinks with the step
      const Model model = compile(spec);
      State state = initial_state(model);
      const Result result = solve(model, state);
      ASSERT_EQ(result.status, SolveStatus::kCompleted) << result.reason;
      const EnergyLedger& e = result.energy;
      EXPECT_GT(e.fracture, 0.01 * e.drive);
      EXPECT_LT(std::fabs(e.gap), 1e-3 * (std::fabs(e.loads) + std::fabs(e.drive)))
          << static_cast<int>(softening) << static_cast<int>(coupling);
    }
}

TEST(Energy, dissipation_never_falls_and_damage_never_heals) {
  ModelSpec spec = scenes::small_wall(2e-3, 0.05);
  spec.stage.back().get<PushStage>().targets = {1e-3, -1e-3};
  Rig rig(compile(spec));
  rig.state.gravity_y = -9.81;
  rig.settle(1e-4);
  State last = rig.state;
  double elapsed = 0;
  while (elapsed < 0.06) {
    rig.drive(2, elapsed < 0.02 ? 0.05 : -0.05);  // there and back through the start
    for (int k = 0; k < 20; ++k) rig.step();
    elapsed += 20 * rig.controls.dt;
    const State& now = rig.state;
    // a step in which the shear stress turns round may give back what elastic energy took too much (4.15)
    ASSERT_GE(now.energy.dissipated_friction, (1 - 1e-5) * last.energy.dissipated_friction);
    ASSERT_GE(now.energy.dissipated_fracture, last.energy.dissipated_fracture);
    ASSERT_GE(now.energy.dissipated_crushing, last.energy.dissipated_crushing);
    for (std::size_t p = 0; p < now.kappa.size(); ++p) {
      ASSERT_GE(now.kappa[p], last.kappa[p]);
      ASSERT_GE(now.slip[p], last.slip[p]);
      ASSERT_GE(now.shear_damage[p], last.shear_damage[p]);
      ASSERT_GE(now.crush[p], last.crush[p]);
    }
    last = now;
  }
  EXPECT_GT(last.energy.dissipated_fracture, 0);
  EXPECT_GT(last.energy.dissipated_friction, 0);
}

TEST(Points, statics_do_not_depend_on_the_number_of_points) {
  // a determinate stack: forces and pressure centres follow from equilibrium alone
  for (const int points : {2, 3, 5}) {
    ModelSpec spec = scenes::stack(4, 0.3, 0.2, scenes::dry_joint(20e9, 8e9, 0.6), 0.1, 2000);
    spec.solve.points_per_face = points;
    Rig rig(compile(spec));
    rig.state.gravity_y = -9.81;
    rig.state.gravity_x = 0.3;
    rig.settle(1e-9);
    for (const JointReading& joint : read_wall(rig.model, rig.state).joints) {
      const double above = (4 - joint.shape.b) * rig.model.mass[0];
      // lean of 1e-6 rad
      EXPECT_NEAR(joint.compression, 9.81 * above, 1e-5 * 9.81 * above) << points;
      EXPECT_NEAR(joint.shear, 0.3 * above, 1e-4 * 9.81 * above) << points;
    }
  }
}

}  // namespace
}  // namespace wythe::mechanics_test
