// Rules for materials against numbers worked out by hand (docs/theory/material_rules.md).
#include <cmath>
#include <limits>
#include <set>
#include <string>

#include <gtest/gtest.h>

#include "materials/rules.h"
#include "wythe/parts/contact_law.h"

namespace wythe::materials::materials_test {
namespace {

double by(Role role, const char* key, const char* name, std::vector<double> inputs,
          UnitType type = UnitType::kUnstated) {
  const Rule* rule = rule_for(role, key, name);
  EXPECT_NE(rule, nullptr) << name;
  if (!rule) return std::nan("");
  EXPECT_EQ(rule->inputs.size(), inputs.size()) << name;
  return rule->value({std::move(inputs), type});
}

// fb 14.92 MPa under 1.2 MPa: 0.040 x 14.92 = 0.5968 MPa; (1 - 0.08043)^(1/0.58) = 0.8654.
TEST(MaterialRules, compression_across_a_brick_lowers_its_tension_along) {
  const auto ft = [](double fb, double sv, UnitType type) {
    return by(Role::kUnit, "tensile_strength", "unit_ft_from_fb", {fb, sv}, type);
  };
  EXPECT_NEAR(ft(14.92e6, 0, UnitType::kClay), 0.5968e6, 1);
  EXPECT_NEAR(ft(14.92e6, 1.2e6, UnitType::kClay), 0.5165e6, 0.0002e6);
  EXPECT_NEAR(ft(39.55e6, 0, UnitType::kClayPerforated), 1.1865e6, 1);
  EXPECT_NEAR(ft(10e6, 0, UnitType::kClayLightPerforated), 0.1e6, 1);
  EXPECT_NEAR(ft(20e6, 0, UnitType::kCalciumSilicate), 1.26e6, 1);
}

// sqrt(0.5 x 1.7) = 0.92195 MPa; without vertical stress the plane fails at c = ft (pure shear).
TEST(MaterialRules, a_units_cohesion_is_the_shear_at_which_principal_tension_reaches_ft) {
  const auto c = [](double ft, double sv) {
    return by(Role::kUnit, "cohesion", "unit_c_from_ft", {ft, sv});
  };
  EXPECT_NEAR(c(0.5e6, 1.2e6), 0.92195e6, 10);
  EXPECT_DOUBLE_EQ(c(0.5e6, 0), 0.5e6);
  const double sv = 1.2e6, tau = c(0.5e6, sv);
  EXPECT_NEAR(-sv / 2 + std::hypot(sv / 2, tau), 0.5e6, 1e-3);
}

// 0.025 N/mm (2 x 2)^0.7 = 0.06598 N/mm; 0.029 mm x 2 MPa = 0.058 N/mm; GII ten times.
TEST(MaterialRules, energies_of_a_unit) {
  EXPECT_NEAR(by(Role::kUnit, "mode_1_energy", "", {2e6}), 65.98, 0.01);
  EXPECT_NEAR(by(Role::kUnit, "mode_1_energy", "unit_gi_by_index", {2e6}), 58.0, 1e-9);
  EXPECT_NEAR(by(Role::kUnit, "mode_2_energy", "", {80}), 800, 1e-9);
  EXPECT_NEAR(std::tan(by(Role::kUnit, "friction_angle", "", {})), 0.8, 1e-12);
  EXPECT_NEAR(std::tan(by(Role::kUnit, "residual_friction_angle", "", {std::atan(0.6)})), 0.6,
              1e-12);
}

// 0.21/2.76 = 0.07609 MPa; 0.029 mm x 0.15 MPa = 4.35 N/m; 0.093 mm x 0.35 MPa = 32.55 N/m.
TEST(MaterialRules, bond_and_energies_of_a_joint) {
  EXPECT_NEAR(by(Role::kJoint, "tensile_strength", "", {0.21e6}), 0.076087e6, 1);
  EXPECT_NEAR(by(Role::kJoint, "tensile_strength", "ft_published", {0.21e6}), 0.14e6, 1);
  EXPECT_NEAR(by(Role::kJoint, "mode_1_energy", "", {0.15e6}), 4.35, 1e-9);
  EXPECT_NEAR(by(Role::kJoint, "mode_2_energy", "gii_published", {0.15e6}), 125, 1e-9);
  const double phi = std::atan(0.75);
  EXPECT_NEAR(by(Role::kJoint, "mode_2_energy", "", {0.35e6, phi, phi, 8e9, 10e6, 0}), 32.55, 1e-6);
  EXPECT_DOUBLE_EQ(by(Role::kJoint, "residual_friction_angle", "", {std::atan(0.94)}),
                   std::atan(0.75));
  EXPECT_DOUBLE_EQ(by(Role::kJoint, "residual_friction_angle", "", {std::atan(0.55)}),
                   std::atan(0.55));
  EXPECT_EQ(by(Role::kJoint, "residual_cohesion", "", {}), 0);
}

// If friction drops too, 0.093 mm c may be steeper than ks: 0.27 + 5.87 x
// 0.19 = 1.3853 MPa, squared over 2 x 7.474 GPa/m = 128.4 N/m, against 25.1.
TEST(MaterialRules, energy_of_slip_never_snaps_back) {
  const double phi = std::atan(0.94), residual = std::atan(0.75), ks = 0.4 * 3.55e9 / 0.19;
  const double gii = by(Role::kJoint, "mode_2_energy", "", {0.27e6, phi, residual, ks, 5.87e6, 0});
  EXPECT_NEAR(gii, 1.05 * 128.4, 0.2);
  JointMaterial m{.normal_stiffness = 3.55e9 / 0.19,
                  .shear_stiffness = ks,
                  .tensile_strength = 0.1e6,
                  .cohesion = 0.27e6,
                  .friction_angle = phi,
                  .residual_friction_angle = residual,
                  .residual_cohesion = 0,
                  .mode_1_energy = 2.9,
                  .mode_2_energy = gii,
                  .compressive_strength = 5.87e6,
                  .compressive_energy = 9392};
  EXPECT_TRUE(check_joint_material(m).empty());
  m.mode_2_energy = 0.093e-3 * 0.27e6;
  EXPECT_EQ(check_joint_material(m).size(), 1U);
  const double unlimited = std::numeric_limits<double>::infinity();
  EXPECT_NEAR(by(Role::kJoint, "mode_2_energy", "", {0.27e6, phi, residual, ks, unlimited, 0}),
              1.05 * std::pow(0.27e6 + 1.9e6, 2) / (2 * ks), 1e-6);
}

// The same joint with b = 0.02 mm: 134.8 - 0.02 x 5870 = 17.4 N/m, less than 0.093 mm c; with 0.01 mm 76.1 N/m. Stiff
// cohesion alone: 1.05 x 2^2/(2 x 7.474 GPa/m) = 281 N/m, above 0.093 mm x 2 MPa.
TEST(MaterialRules, energy_of_slip_beside_one_that_grows_with_pressure) {
  const double phi = std::atan(0.94), residual = std::atan(0.75), ks = 0.4 * 3.55e9 / 0.19;
  const auto gii = [&](double c, double b) {
    return by(Role::kJoint, "mode_2_energy", "", {c, phi, residual, ks, 5.87e6, b});
  };
  const double without = gii(0.27e6, 0);
  EXPECT_NEAR(gii(0.27e6, 0.01e-3), without - 58.7, 1e-9);
  EXPECT_NEAR(gii(0.27e6, 0.02e-3), 25.11, 1e-9);
  EXPECT_NEAR(gii(2e6, 1e-3), 1.05 * 4e12 / (2 * ks), 1e-9);
}

TEST(MaterialRules, energy_per_pressure_is_of_clay) {
  const Rule* rule = rule_for(Role::kJoint, "mode_2_energy_per_pressure");
  ASSERT_NE(rule, nullptr);
  EXPECT_EQ(rule_for(Role::kUnit, "mode_2_energy_per_pressure"), nullptr);
  EXPECT_DOUBLE_EQ(rule->value({}), 0.13e-3);
  for (const UnitType type :
       {UnitType::kClay, UnitType::kClayPerforated, UnitType::kClayLightPerforated})
    EXPECT_TRUE(holds_for(*rule, type));
  for (const UnitType type : {UnitType::kCalciumSilicate, UnitType::kAeratedConcrete,
                              UnitType::kTuff, UnitType::kUnstated})
    EXPECT_FALSE(holds_for(*rule, type));
}

// 1.6 mm x 4 MPa = 6.4 N/mm; at 20 MPa 15 + 8.6 - 1.44 = 22.16 N/mm.
TEST(MaterialRules, crushing_energy_has_no_step_where_its_formula_changes) {
  const auto gc = [](double fc) { return by(Role::kJoint, "compressive_energy", "", {fc}); };
  EXPECT_NEAR(gc(4e6), 6400, 1e-6);
  EXPECT_NEAR(gc(20e6), 22160, 1e-6);
  for (double fc = 12e6; fc < 13e6; fc += 1e3) EXPECT_LT(std::fabs(gc(fc + 1e3) - gc(fc)), 2.0);
  EXPECT_NEAR(by(Role::kJoint, "compressive_energy", "gc_published", {4e6}), 12800, 1e-6);
}

// E 2991 MPa over courses of 64.5 mm: 46.37 GPa/m. Unit 16.7 GPa, interface 82 GPa/m, course 62 mm:
// 1/(0.062/16.7e9 + 1/82e9) = 62.87 GPa/m; shear: Gu = 7.261 GPa, 36 GPa/m: 27.53 GPa/m.
TEST(MaterialRules, stiffness_of_a_joint_takes_the_deformation_of_its_course) {
  EXPECT_NEAR(by(Role::kJoint, "normal_stiffness", "", {2991e6, 0.0645}), 46.372e9, 1e6);
  EXPECT_NEAR(by(Role::kJoint, "shear_stiffness", "", {46e9, 1.2e9, 3e9}), 18.4e9, 1);
  EXPECT_NEAR(by(Role::kJoint, "normal_stiffness", "kn_in_series", {0.062, 16.7e9, 82e9}), 62.87e9,
              0.01e9);
  EXPECT_NEAR(by(Role::kJoint, "shear_stiffness", "ks_in_series", {0.062, 16.7e9, 36e9}), 27.53e9,
              0.01e9);
  // 52 mm at 16.7 GPa and 10 mm at 2 GPa: 1/(3.1138e-12 + 5e-12) = 123.25 GPa/m
  EXPECT_NEAR(by(Role::kJoint, "normal_stiffness", "kn_of_layers", {0.062, 0.010, 16.7e9, 2e9}),
              123.25e9, 0.01e9);
}

// A plane of a unit of 16.7 GPa, 0.22 m long: 16.7/0.11 = 151.8 GPa/m, not 1e6 N/mm3.
TEST(MaterialRules, stiffness_of_a_crack_plane_takes_the_deformation_of_half_a_unit) {
  const double kn = by(Role::kUnit, "normal_stiffness", "", {16.7e9, 0.22});
  EXPECT_NEAR(kn, 151.82e9, 0.01e9);
  EXPECT_NEAR(by(Role::kUnit, "shear_stiffness", "", {kn}), 66.01e9, 0.01e9);
}

// 0.73 x 14.92^0.73 x 4.33^0.16 = 6.6376 MPa; E of solid clay 550 fm; G 0.4 E; Eu 300 fb.
TEST(MaterialRules, masonry_from_units_and_mortar) {
  EXPECT_NEAR(by(Role::kMasonry, "masonry_strength", "", {14.92e6, 4.33e6}, UnitType::kClay),
              0.73 * std::exp(0.73 * std::log(14.92) + 0.16 * std::log(4.33)) * 1e6, 1);
  EXPECT_NEAR(by(Role::kMasonry, "masonry_strength", "", {14.92e6, 4.33e6}, UnitType::kClay),
              6.6376e6, 0.0001e6);
  EXPECT_NEAR(by(Role::kMasonry, "youngs_modulus", "", {8e6}, UnitType::kClay), 4.4e9, 1);
  EXPECT_NEAR(by(Role::kMasonry, "shear_modulus", "", {3e9}), 1.2e9, 1);
  EXPECT_NEAR(by(Role::kMasonry, "unit_youngs_modulus", "", {15e6}), 4.5e9, 1);
}

TEST(MaterialRules, a_rule_by_kind_of_unit_holds_only_for_kinds_that_were_tested) {
  const Rule& tension = *rule_for(Role::kUnit, "tensile_strength");
  EXPECT_TRUE(holds_for(tension, UnitType::kClay));
  for (const UnitType type : {UnitType::kTuff, UnitType::kStone, UnitType::kUnstated})
    EXPECT_FALSE(holds_for(tension, type));
  EXPECT_TRUE(holds_for(*rule_for(Role::kJoint, "cohesion"), UnitType::kUnstated));
  EXPECT_EQ(cov_of(tension, UnitType::kCalciumSilicate), 0.26);
  EXPECT_EQ(cov_of(tension, UnitType::kClay), 0.24);
}

TEST(MaterialRules, every_rule_states_source_formula_and_the_range_of_its_inputs) {
  std::set<std::string> names;
  for (const Rule& rule : rules()) {
    EXPECT_TRUE(names.insert(rule.name).second) << rule.name << " twice";
    EXPECT_STRNE(rule.formula, "") << rule.name;
    EXPECT_STRNE(rule.source, "") << rule.name;
    // a difference of two strengths, of three kinds of unit: tests have it below 0, too
    const double most = std::string_view(rule.gives) == "head_joint_bond" ? 1.5 : 0.6;
    EXPECT_TRUE(std::isfinite(rule.cov) && rule.cov >= 0 && rule.cov <= most) << rule.name;
    for (const Bound& bound : rule.range) {
      const auto is_input = [&](const char* name) {
        for (const char* input : rule.inputs)
          if (std::string_view(input) == name) return true;
        return false;
      };
      EXPECT_TRUE(is_input(bound.input)) << rule.name;
      EXPECT_TRUE(*bound.per == '\0' || is_input(bound.per)) << rule.name;
    }
  }
}

}  // namespace
}  // namespace wythe::materials::materials_test
