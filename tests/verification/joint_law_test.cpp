// The joint law along simple paths: areas, peaks and residuals (CF10 - CF13, CF15).
#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "scenes/scenes.h"
#include "verification/record.h"
#include "wythe/parts/contact_law.h"
#include "wythe/parts/solve.h"

namespace wythe::verification::joint_law_test {
namespace {

using scenes::degrees;

JointMaterial tension_only(double ft, double energy, double kn) {
  JointMaterial m = scenes::elastic_joint(kn, 0.4 * kn);
  m.tensile_strength = ft;
  m.mode_1_energy = energy;
  return m;
}

// n rows from 0 to `last` opening.
std::vector<ContactPathRow> opening_path(double last, int n) {
  std::vector<ContactPathRow> path;
  for (int k = 1; k <= n; ++k) path.push_back({last * k / n, 0});
  return path;
}

// Opening at which the falling stress reaches `level`, between rows by a straight line. The branch
// is straight up to its end, so that the last two rows under stress extend to zero exactly.
double falling_to(const std::vector<ContactPathRow>& path,
                  const std::vector<ContactAnswer>& answers, double level) {
  std::size_t k = answers.size() - 1;
  while (k > 1 && answers[k].normal_stress <= level) --k;
  if (level <= 0) --k;
  const double s0 = answers[k].normal_stress, s1 = answers[k + 1].normal_stress;
  const double share = (s0 - level) / (s0 - s1);
  return path[k].opening + share * (path[k + 1].opening - path[k].opening);
}

double opening_at_zero(const JointMaterial& m, double beyond) {
  const auto path = opening_path(beyond, 997);
  return falling_to(path, drive_contact(m, path), 0);
}

constexpr const char* kLine = "straight branch between rows; the value has 7 digits";

TEST(ClosedForm, CF10_opening_at_zero_stress) {
  verify({"CF10", "mode I linear (paper joint): opening at zero stress, whole area", "m",
          5.733333e-05, 1e-6, kLine},
         opening_at_zero(tension_only(0.15e6, 4.3, 20e9), 1e-4));
  verify({"CF10", "mode I linear (paper unit): opening at zero stress, whole area", "m",
          6.956522e-05, 1e-6, kLine},
         opening_at_zero(tension_only(0.23e6, 8, 10e9), 1e-4));
  verify({"CF10", "mode I linear (Lourenco and Rots J4D): opening at zero stress, whole area", "m",
          0.000144, 1e-6, kLine},
         opening_at_zero(tension_only(0.25e6, 18, 82e9), 2e-4));
}

// Pulls a block off the ground by 0.2 mm; dissipated energy over 0.1 m^2 [J].
double energy_of_pulling(const JointMaterial& joint) {
  ModelSpec spec = scenes::block_on_ground(0.5, 0.1, joint, 0.2, 2000);
  StageSpec pull = scenes::push_stage("b0", Direction::kPlusY, 1e-3, 2e-4);
  pull.get<PushStage>().as = Manner::kEach;
  spec.stage = {pull};
  const Model model = compile(spec);
  State state = initial_state(model);
  const Result result = solve(model, state);
  EXPECT_EQ(result.status, SolveStatus::kCompleted);
  EXPECT_NEAR(result.energy.drive, result.energy.fracture, 1e-3 * result.energy.fracture);
  return result.energy.fracture;
}

constexpr const char* kPull = "the return is exact; the last step over the end of the branch";

TEST(ClosedForm, CF10_energy_of_a_joint_pulled_apart) {
  verify({"CF10", "mode I (paper joint): energy of 0.1 m2 pulled apart", "J", 0.43, 1e-3, kPull},
         energy_of_pulling(tension_only(0.15e6, 4.3, 20e9)));
  verify({"CF10", "mode I (paper unit): energy of 0.1 m2 pulled apart", "J", 0.8, 1e-3, kPull},
         energy_of_pulling(tension_only(0.23e6, 8, 10e9)));
  verify({"CF10", "mode I (Lourenco and Rots J4D): energy of 0.1 m2 pulled apart", "J", 1.8, 1e-3,
          kPull},
         energy_of_pulling(tension_only(0.25e6, 18, 82e9)));
}

// Inelastic opening w - sigma/kn where the stress has fallen to `level`, on a fine path.
double inelastic_opening_at(const JointMaterial& m, double level, double beyond) {
  const auto path = opening_path(beyond, 20011);
  const auto answers = drive_contact(m, path);
  return falling_to(path, answers, level) - level / m.normal_stiffness;
}

TEST(ClosedForm, CF11_petersson_knee_and_end) {
  JointMaterial m = tension_only(0.25e6, 18, 82e9);
  m.softening = Softening::kPetersson;
  verify({"CF11", "mode I Petersson: inelastic opening at the knee, ft/3", "m", 5.76e-05, 3e-4,
          "the knee is met within one of 20 000 rows"},
         inelastic_opening_at(m, 0.25e6 / 3, 3e-4));
  verify({"CF11", "mode I Petersson: opening at zero stress", "m", 0.0002592, 1e-6,
          "straight last branch"},
         inelastic_opening_at(m, 0, 3e-4));
}

TEST(ClosedForm, CF12_exponential_stress_at_unit_opening) {
  JointMaterial m = tension_only(0.25e6, 18, 82e9);
  m.softening = Softening::kExponential;
  const double wanted = m.mode_1_energy / m.tensile_strength;  // inelastic opening [m]
  const auto path = opening_path(3e-4, 20011);
  const auto answers = drive_contact(m, path);
  const auto inelastic = [&](std::size_t k) {
    return path[k].opening - answers[k].normal_stress / m.normal_stiffness;
  };
  std::size_t k = 0;
  while (inelastic(k + 1) < wanted) ++k;
  const double share = (wanted - inelastic(k)) / (inelastic(k + 1) - inelastic(k));
  verify(
      {"CF12", "mode I exponential: stress at the inelastic opening Gf/ft", "Pa", 91969.86, 1e-6,
       "straight line between rows, (dw ft/Gf)^2/8 = 5e-9; the value has 7 digits"},
      answers[k].normal_stress + share * (answers[k + 1].normal_stress - answers[k].normal_stress));
}

JointMaterial shear_joint(double residual_friction) {
  JointMaterial m = scenes::paper_joint();
  m.residual_friction_angle = residual_friction;
  return m;
}

// Slips to `last` in n rows under a compression held by the opening.
struct Shearing {
  std::vector<ContactPathRow> path;
  std::vector<ContactAnswer> answers;
};
Shearing shear_under(const JointMaterial& m, double compression, double last, int n) {
  Shearing s;
  for (int k = 0; k <= n; ++k) s.path.push_back({-compression / m.normal_stiffness, last * k / n});
  s.answers = drive_contact(m, s.path);
  return s;
}

TEST(ClosedForm, CF13a_peak_shear_stress) {
  const Shearing s = shear_under(shear_joint(degrees(14.6)), 0.3e6, 1e-4, 20000);
  double peak = 0;
  for (const ContactAnswer& a : s.answers) peak = std::max(peak, a.shear_stress);
  verify({"CF13a", "mode II: peak shear stress", "Pa", 237158.1, 2e-4,
          "the peak is met within one row, ks x 5e-9 m"},
         peak);
}

TEST(ClosedForm, CF13b_residual_shear_stress) {
  const Shearing s = shear_under(shear_joint(degrees(14.6)), 0.3e6, 5e-3, 1000);
  verify(
      {"CF13b", "mode II: residual shear stress", "Pa", 78144.15, 1e-6, "the value has 7 digits"},
      s.answers.back().shear_stress);
}

TEST(ClosedForm, CF13c_slip_at_which_cohesion_is_exhausted) {
  const JointMaterial m = shear_joint(degrees(16.2));
  const Shearing s = shear_under(m, 0.3e6, 3e-3, 3000);
  std::size_t k = 0;
  while (s.answers[k].damage_shear < 1) ++k;
  // the branch is straight in the plastic slip: from two damaged rows to damage 1
  const auto plastic = [&](std::size_t i) {
    return s.path[i].slip - s.answers[i].shear_stress / m.shear_stiffness;
  };
  const double d0 = s.answers[k - 2].damage_shear, d1 = s.answers[k - 1].damage_shear;
  const double end = plastic(k - 1) + (1 - d1) / (d1 - d0) * (plastic(k - 1) - plastic(k - 2));
  verify({"CF13c", "mode II: plastic slip at which cohesion is exhausted", "m", 0.001666667, 1e-6,
          "straight branch; the value has 7 digits"},
         end);
}

TEST(ClosedForm, CF13d_work_to_slip_5_mm) {
  const Shearing s = shear_under(shear_joint(degrees(16.2)), 0.3e6, 5e-3, 5000);
  verify({"CF13d", "mode II: work to slip 5 mm over 0.1 m2", "J", 56.07903, 2e-3,
          "the closed form leaves the elastic slip out: tau/ks = 1.1e-5 m of 5 mm"},
         0.1 * s.answers.back().dissipated);
}

// a 125 N/m, b 0.13 mm, 0.3 MPa: GII = 125 + 39 = 164 N/m; su = 2 x 164/0.15e6.
TEST(ClosedForm, CF13e_energy_that_grows_with_pressure) {
  JointMaterial m = shear_joint(degrees(16.2));
  m.mode_2_energy_per_pressure = 0.13e-3;
  const Shearing s = shear_under(m, 0.3e6, 4e-3, 4000);
  std::size_t k = 0;
  while (s.answers[k].damage_shear < 1) ++k;
  const auto plastic = [&](std::size_t i) {
    return s.path[i].slip - s.answers[i].shear_stress / m.shear_stiffness;
  };
  const double d0 = s.answers[k - 2].damage_shear, d1 = s.answers[k - 1].damage_shear;
  const double end = plastic(k - 1) + (1 - d1) / (d1 - d0) * (plastic(k - 1) - plastic(k - 2));
  verify({"CF13e", "mode II, GII = a + b sn: plastic slip at which cohesion is exhausted", "m",
          0.002186667, 1e-6, "straight branch; the value has 7 digits"},
         end);
  const double friction = 0.3e6 * std::tan(degrees(16.2)) * plastic(static_cast<std::size_t>(4000));
  verify({"CF13e", "mode II, GII = a + b sn: work above the residual under 0.3 MPa", "N/m", 164,
          1e-6, "straight branch; one substep over its end"},
         s.answers.back().dissipated - friction);
}

TEST(ClosedForm, CF15_closure_at_zero_compressive_stress) {
  const JointMaterial m = scenes::paper_joint();
  std::vector<ContactPathRow> path;
  for (int k = 1; k <= 7001; ++k) path.push_back({-7.001e-3 * k / 7001, 0});
  const auto answers = drive_contact(m, path);
  std::size_t k = answers.size() - 1;
  while (answers[k].normal_stress >= 0) --k;
  const double s0 = answers[k - 1].normal_stress, s1 = answers[k].normal_stress;
  const double closure =
      -path[k].opening + s1 / (s0 - s1) * (path[k - 1].opening - path[k].opening);
  verify({"CF15", "compression cap: closure at zero stress, whole area", "m", 0.006464646, 1e-6,
          "straight branch; the value has 7 digits"},
         closure);
  EXPECT_NEAR(answers.back().dissipated, 12800, 1e-3 * 12800);
}

}  // namespace
}  // namespace wythe::verification::joint_law_test
