// The rules for materials; docs/theory/material_rules.md explains each of them under its name.
#include "materials/rules.h"

#include <algorithm>
#include <cmath>

#include "core/elementary.h"

namespace wythe::materials {
namespace {

constexpr double kMPa = 1e6;                 // [Pa]
constexpr double kUnitPoisson = 0.15;        // of fired clay and stone
constexpr double kPublishedFriction = 0.75;  // residual tan of mortar joints
constexpr double kCrackFriction = 0.8;       // tan of a crack through a unit

// JCSS Probabilistic Model Code, part 3.2, after Schubert (2010): c2, its scatter, c1, K, alpha, beta.
// E of masonry of solid clay brick: Kaushik, Rai and Jain (2007).
constexpr UnitRatios kRatios[] = {
    {UnitType::kClay, 0.040, 0.24, 550, 0.73, 0.73, 0.16},
    {UnitType::kClayPerforated, 0.030, 0.24, 1170, 0.55, 0.56, 0.46},
    {UnitType::kClayLightPerforated, 0.010, 0.24, 1170, 0.26, 0.82, 0.42},
    {UnitType::kCalciumSilicate, 0.063, 0.26, 500, 0.70, 0.74, 0.21},
    {UnitType::kCalciumSilicatePerforated, 0.035, 0.26, 500, 0.85, 0.57, 0.20},
    {UnitType::kLightweightConcrete, 0.080, 0.24, 1040, 0.85, 0.72, 0.09},
    {UnitType::kAeratedConcrete, 0.110, 0.16, 520, 0.98, 0.68, 0.02}};

const UnitRatios& of(UnitType type) {
  return *std::find_if(std::begin(kRatios), std::end(kRatios),
                       [&](const UnitRatios& r) { return r.type == type; });
}

// --- masonry -------------------------------------------------------------------------------------

double masonry_strength(const Inputs& in) {
  const UnitRatios& r = of(in.unit_type);
  return kMPa * r.k * elementary::pow(in[0] / kMPa, r.alpha) *
         elementary::pow(in[1] / kMPa, r.beta);
}
double masonry_modulus(const Inputs& in) { return of(in.unit_type).stiffness * in[0]; }
double masonry_shear_modulus(const Inputs& in) { return 0.4 * in[0]; }
double unit_modulus(const Inputs& in) { return 300 * in[0]; }
// The rule fm_from_units solved for fb.
double unit_strength(const Inputs& in) {
  const UnitRatios& r = of(in.unit_type);
  const double fm = in[0] / kMPa / (r.k * elementary::pow(in[1] / kMPa, r.beta));
  return kMPa * elementary::pow(fm, 1 / r.alpha);
}
// Cohesion from a stepped crack through the bond, without load, at the diagonal shear strength of a panel: tau0, mu, h, l.
double cohesion_of_panel(const Inputs& in) { return 1.5 * in[0] * (1 + in[1] * 2 * in[2] / in[3]); }
double local_friction(const Inputs&) { return 0.577; }
double mass_of_weight(const Inputs& in) { return in[0] / 9.81; }

// --- joint ---------------------------------------------------------------------------------------

double over_course(const Inputs& in) { return in[0] / in[1]; }
double layers(const Inputs& in) {
  const double course = in[0], joint = in[1];
  return 1 / ((course - joint) / in[2] + joint / in[3]);
}
double series(const Inputs& in) { return 1 / (in[0] / in[1] + 1 / in[2]); }
double shear_series(const Inputs& in) {
  const double unit_g = in[1] / (2 * (1 + kUnitPoisson));
  return 1 / (in[0] / unit_g + 1 / in[2]);
}
double stiffness_by_g(const Inputs& in) { return in[0] * in[1] / in[2]; }
double same(const Inputs& in) { return in[0]; }
double angle_of_tan(const Inputs& in) { return elementary::atan(in[0]); }
double nothing(const Inputs&) { return 0; }
double bond_of_cohesion(const Inputs& in) { return in[0] / 2.76; }
double bond_as_published(const Inputs& in) { return in[0] / 1.5; }
double joint_residual(const Inputs& in) {
  return std::min(in[0], elementary::atan(kPublishedFriction));
}
double bond_energy(const Inputs& in) { return 0.029e-3 * in[0]; }
// Inputs c, phi, phi_res, ks, fc, b. The drop from peak to residual is largest at fc, and a branch steeper
// than ks has no path (docs/theory/joint_law.md, 3.13).
double slip_energy(const Inputs& in) {
  constexpr double kGreatest = 10e6;  // largest compression without crushing [Pa]
  const double fc = std::isfinite(in[4]) ? in[4] : kGreatest;
  const auto least = [&](double drop) { return 1.05 * drop * drop / (2 * in[3]); };
  const double pressed =
      in[0] + fc * std::max(0.0, elementary::tan(in[1]) - elementary::tan(in[2]));
  return std::max({0.093e-3 * in[0], least(in[0]), least(pressed) - in[5] * fc});
}
double slip_energy_per_pressure(const Inputs&) { return 0.13e-3; }
double slip_energy_as_published(const Inputs& in) { return 125 / 0.15e6 * in[0]; }
double crushing_energy(const Inputs& in) {
  const double f = in[0] / kMPa;
  return 1e3 * std::min(1.6 * f, 15 + 0.43 * f - 0.0036 * f * f);
}
double crushing_as_published(const Inputs& in) { return 3.2e-3 * in[0]; }

// --- crack plane of a unit -----------------------------------------------------------------------

double cap_as_published(const Inputs&) { return 9; }
double quarter(const Inputs&) { return 0.25; }
double half_unit(const Inputs& in) { return 2 * in[0] / in[1]; }
double shear_of_unit(const Inputs& in) { return in[0] / (2 * (1 + kUnitPoisson)); }
double unit_tension(const Inputs& in) {
  const double across = 1 - in[1] / in[0];  // compression across the bed lowers tension along it
  return of(in.unit_type).tension * in[0] * elementary::pow(across, 1 / 0.58);
}
double principal_tension(const Inputs& in) { return std::sqrt(in[0] * (in[0] + in[1])); }
double crack_friction(const Inputs&) { return elementary::atan(kCrackFriction); }
double crack_residual(const Inputs& in) {
  return std::min(in[0], elementary::atan(kCrackFriction));
}
double unit_energy(const Inputs& in) { return 25 * elementary::pow(2 * in[0] / kMPa, 0.7); }
double unit_slip_energy(const Inputs& in) { return 10 * in[0]; }

// clang-format off
const Rule kRules[] = {
  // --- masonry
  {"fm_from_units", Role::kMasonry, "masonry_strength", {"unit_strength", "mortar_strength"},
   "fm = K fb^alpha fmo^beta in MPa, K, alpha, beta by unit_type",
   "JCSS Probabilistic Model Code 3.2 (Schubert 2010)", 0.20,
   {{"unit_strength", 2e6, 100e6}, {"mortar_strength", 0.5e6, 40e6}}, masonry_strength, true},
  {"e_from_fm", Role::kMasonry, "youngs_modulus", {"masonry_strength"},
   "E = c1 fm, c1 by unit_type", "JCSS Probabilistic Model Code 3.2; solid clay brick: Kaushik et al. 2007", 0.25,
   {{"masonry_strength", 1e6, 40e6}}, masonry_modulus, true},
  {"g_from_e", Role::kMasonry, "shear_modulus", {"youngs_modulus"},
   "G = 0.4 E", "EN 1996-1-1, 3.7.3", 0.25, {{"youngs_modulus", 0.1e9, 50e9}}, masonry_shear_modulus},
  {"unit_e_from_fb", Role::kMasonry, "unit_youngs_modulus", {"unit_strength"},
   "Eu = 300 fb", "Kaushik, Rai and Jain 2007: bricks, 150 to 500 fb", 0.35,
   {{"unit_strength", 5e6, 100e6}}, unit_modulus},
  {"unit_e_is_e", Role::kMasonry, "unit_youngs_modulus", {"youngs_modulus"},
   "Eu = E", "the least a unit can have: mortar is softer; where units were not tested", 0.35,
   {{"youngs_modulus", 0.1e9, 50e9}}, same},
  {"fb_from_fm", Role::kMasonry, "unit_strength", {"masonry_strength", "mortar_strength"},
   "fb = (fm / (K fmo^beta))^(1/alpha) in MPa, K, alpha, beta by unit_type",
   "fm_from_units solved for fb: units as weak as the masonry allows", 0.27,
   {{"masonry_strength", 1e6, 40e6}, {"mortar_strength", 0.5e6, 40e6}}, unit_strength, true},
  {"fv0_from_tau0", Role::kMasonry, "initial_shear_strength",
   {"diagonal_shear_strength", "friction_tan", "course_height", "unit_length"},
   "fv0 = 1.5 tau0 (1 + mu 2h/l), h the course, l the unit",
   "Circolare 7/2019, C8.7.1.3: an unloaded panel as strong by steps through the bond as by tau0", 0.15,
   {{"diagonal_shear_strength", 0.005e6, 1e6}, {"friction_tan", 0.1, 2}, {"course_height", 0.02, 2, "unit_length"}},
   cohesion_of_panel},
  {"friction_of_code", Role::kMasonry, "friction_tan", {},
   "mu = 0.577", "Circolare 7/2019, C8.7.1.3, local coefficient of a joint", 0.19, {}, local_friction},
  {"density_from_weight", Role::kMasonry, "density", {"weight"},
   "density = weight / 9.81 m/s^2", "definition", 0, {{"weight", 1e3, 40e3}}, mass_of_weight},
  // --- joint
  {"kn_from_e", Role::kJoint, "normal_stiffness", {"youngs_modulus", "course_height"},
   "kn = E / h, h the course height", "rigid blocks: all deformation of a course lies in its joint [1]", 0.25,
   {{"youngs_modulus", 0.1e9, 50e9}, {"course_height", 0.02, 1.0}}, over_course},
  {"kn_of_layers", Role::kJoint, "normal_stiffness",
   {"course_height", "joint_thickness", "unit_youngs_modulus", "mortar_youngs_modulus"},
   "kn = 1 / ((h - t)/Eu + t/Em)", "unit and mortar in series", 0.35,
   {{"joint_thickness", 0, 0.5, "course_height"}, {"mortar_youngs_modulus", 0.01, 1, "unit_youngs_modulus"}}, layers},
  {"kn_in_series", Role::kJoint, "normal_stiffness",
   {"course_height", "unit_youngs_modulus", "interface_normal_stiffness"},
   "kn = 1 / (h/Eu + 1/kn_i), kn_i of a micro-model with elastic units", "unit and interface in series", 0.25,
   {{"course_height", 0.02, 1.0}, {"unit_youngs_modulus", 0.5e9, 100e9}}, series},
  {"ks_from_g", Role::kJoint, "shear_stiffness", {"normal_stiffness", "shear_modulus", "youngs_modulus"},
   "ks = kn G / E", "rigid blocks: all deformation of a course lies in its joint [1]", 0.25,
   {{"shear_modulus", 0.1, 0.5, "youngs_modulus"}}, stiffness_by_g},
  {"ks_in_series", Role::kJoint, "shear_stiffness",
   {"course_height", "unit_youngs_modulus", "interface_shear_stiffness"},
   "ks = 1 / (h/Gu + 1/ks_i), Gu = Eu/2.3, ks_i of a micro-model with elastic units",
   "unit and interface in series", 0.25,
   {{"course_height", 0.02, 1.0}, {"unit_youngs_modulus", 0.5e9, 100e9}}, shear_series},
  {"c_from_fv0", Role::kJoint, "cohesion", {"initial_shear_strength"},
   "c = fv0", "EN 1052-3: fv0 is the intercept of the line through triplets", 0,
   {{"initial_shear_strength", 0, 3e6}}, same},
  {"ft_from_cohesion", Role::kJoint, "tensile_strength", {"cohesion"},
   "ft = c / 2.76", "Gooch et al. 2023: shear over flexural bond 1.34, flexural over direct tension 2.06", 0.42,
   {{"cohesion", 0, 2e6}}, bond_of_cohesion},
  {"ft_published", Role::kJoint, "tensile_strength", {"cohesion"},
   "ft = c / 1.5", "Pulatsu et al. 2022 [1], as micro-models assume it; no couplet test", 0.42,
   {{"cohesion", 0, 2e6}}, bond_as_published},
  {"friction_from_tan", Role::kJoint, "friction_angle", {"friction_tan"},
   "phi = arctan(mu)", "definition", 0, {{"friction_tan", 0, 2}}, angle_of_tan},
  {"residual_friction", Role::kJoint, "residual_friction_angle", {"friction_angle"},
   "tan phi_res = min(tan phi, 0.75)", "van der Pluijm 1993: near 0.75 whatever the peak", 0.10,
   {{"friction_angle", 0, 1.2}}, joint_residual},
  {"no_residual_cohesion", Role::kJoint, "residual_cohesion", {},
   "c_res = 0", "van der Pluijm 1993: dry friction remains", 0, {}, nothing},
  {"gi_from_ft", Role::kJoint, "mode_1_energy", {"tensile_strength"},
   "GI = 0.029 mm ft", "Pulatsu et al. 2022 [1]; van der Pluijm 1992: 5 to 20 N/m at 0.3 to 0.9 MPa", 0.50,
   {{"tensile_strength", 0, 1e6}}, bond_energy},
  {"gii_from_cohesion", Role::kJoint, "mode_2_energy",
   {"cohesion", "friction_angle", "residual_friction_angle", "shear_stiffness", "compressive_strength", "mode_2_energy_per_pressure"},
   "GII = 0.093 mm c, at least 1.05 c^2 / (2 ks) and 1.05 (c + fc (tan phi - tan phi_res))^2 / (2 ks) - b fc: no snap-back; b = mode_2_energy_per_pressure or 0", "Lourenco 2008, from van der Pluijm 1993: 10 to 250 N/m at 0.1 to 1.8 MPa, no compression", 0.50,
   {{"cohesion", 0, 2e6}}, slip_energy},
  {"gii_published", Role::kJoint, "mode_2_energy", {"tensile_strength"},
   "GII = 125 N/m ft / 0.15 MPa", "Pulatsu et al. 2022 [1], tuff", 0.50,
   {{"tensile_strength", 0, 0.5e6}}, slip_energy_as_published},
  {"gii_per_pressure", Role::kJoint, "mode_2_energy_per_pressure", {},
   "b = 0.13 mm, clay units", "van der Pluijm 1993 as Rots 1997 has it, recalled: GII = 0.058 N/mm + 0.13 mm sn, sn from 0.1 to 1 MPa", 0.50,
   {}, slip_energy_per_pressure, true, false, true},
  {"fc_is_fm", Role::kJoint, "compressive_strength", {"masonry_strength"},
   "fc = fm", "crushing of the masonry takes place in the joint [1]", 0, {{"masonry_strength", 0.5e6, 100e6}}, same},
  {"gc_from_fc", Role::kJoint, "compressive_energy", {"compressive_strength"},
   "Gc = min(1.6 mm fc, 15 + 0.43 fc - 0.0036 fc^2 N/mm), fc in MPa", "CEB-FIP Model Code 1990; below 12 MPa Lourenco 2008", 0.30,
   {{"compressive_strength", 0.5e6, 80e6}}, crushing_energy},
  {"gc_published", Role::kJoint, "compressive_energy", {"compressive_strength"},
   "Gc = 3.2 mm fc", "Pulatsu et al. 2022 [1], tuff", 0.30, {{"compressive_strength", 0.5e6, 12e6}}, crushing_as_published},
  {"css_published", Role::kJoint, "compression_cap", {},
   "Css = 9", "Lourenco and Rots 1997, an assumption; no test", 0.30, {}, cap_as_published, false, true},
  {"head_joint_quarter", Role::kJoint, "head_joint_bond", {},
   "0.25 of the bond of the beds",
   "Schubert's tests in the JCSS Probabilistic Model Code 3.2: filled less empty head joints over beds, 0.24 of -0.12 to 0.68", 1.4,
   {}, quarter},
  // --- crack plane inside a unit
  {"kn_of_half_unit", Role::kUnit, "normal_stiffness", {"unit_youngs_modulus", "unit_length"},
   "kn = Eu / (l/2), l the unit's length", "rigid halves: the plane takes the deformation of half a unit", 0.30,
   {{"unit_youngs_modulus", 0.5e9, 100e9}, {"unit_length", 0.05, 2.0}}, half_unit},
  {"ks_of_half_unit", Role::kUnit, "shear_stiffness", {"normal_stiffness"},
   "ks = kn / 2.3", "isotropic unit, Poisson's ratio 0.15", 0.10, {{"normal_stiffness", 1e8, 1e17}}, shear_of_unit},
  {"unit_ft_from_fb", Role::kUnit, "tensile_strength", {"unit_strength", "vertical_stress"},
   "ft = c2 fb (1 - sv/fb)^1.72, c2 by unit_type, sv the mean vertical stress",
   "c2: JCSS Probabilistic Model Code 3.2 (Schubert 2010, direct tension along the unit); brick in tension and compression: Khoo and Hendry 1973, McNary and Abrams 1985",
   0.24, {{"unit_strength", 2e6, 100e6}, {"vertical_stress", 0, 0.5, "unit_strength"}}, unit_tension, true},
  {"unit_c_from_ft", Role::kUnit, "cohesion", {"tensile_strength", "vertical_stress"},
   "c = sqrt(ft (ft + sv)), sv the mean vertical stress", "principal tension reaches ft; torsion of concrete: Bresler and Pister 1958", 0.25,
   {{"tensile_strength", 0.01e6, 15e6}, {"vertical_stress", 0, 15e6}}, principal_tension},
  {"unit_friction", Role::kUnit, "friction_angle", {},
   "tan phi = 0.8", "Mattock and Hawkins 1972: concrete pushed off along a plane, cracked and not", 0.15, {}, crack_friction},
  {"unit_residual_friction", Role::kUnit, "residual_friction_angle", {"friction_angle"},
   "tan phi_res = min(tan phi, 0.8)", "Mattock and Hawkins 1972: the same slope along an open crack", 0.15,
   {{"friction_angle", 0, 1.4}}, crack_residual},
  {"unit_no_residual_cohesion", Role::kUnit, "residual_cohesion", {}, "c_res = 0", "an open crack", 0, {}, nothing},
  {"unit_gi_from_ft", Role::kUnit, "mode_1_energy", {"tensile_strength"},
   "GI = 0.025 N/mm (2 ft)^0.7, ft in MPa", "CEB-FIP Model Code 1990 with ft = 5 % fc; van der Pluijm 1992: 60 to 130 N/m at 1.5 to 3.5 MPa", 0.30,
   {{"tensile_strength", 0.05e6, 5e6}}, unit_energy},
  {"unit_gi_by_index", Role::kUnit, "mode_1_energy", {"tensile_strength"},
   "GI = 0.029 mm ft", "Lourenco 2008: brick, 0.018 to 0.040 mm", 0.30, {{"tensile_strength", 0.05e6, 5e6}}, bond_energy},
  {"unit_gii_from_gi", Role::kUnit, "mode_2_energy", {"mode_1_energy"},
   "GII = 10 GI", "between diagonal opening alone, 1.4, and Bazant and Pfeiffer 1986, about 25", 0.60,
   {{"mode_1_energy", 0.5, 500}}, unit_slip_energy},
  {"unit_fc_is_fm", Role::kUnit, "compressive_strength", {"masonry_strength"},
   "fc = fm", "crushing as in the masonry [1]", 0, {{"masonry_strength", 0.5e6, 100e6}}, same},
  {"unit_gc_from_fc", Role::kUnit, "compressive_energy", {"compressive_strength"},
   "Gc = min(1.6 mm fc, 15 + 0.43 fc - 0.0036 fc^2 N/mm), fc in MPa", "CEB-FIP Model Code 1990; below 12 MPa Lourenco 2008", 0.30,
   {{"compressive_strength", 0.5e6, 80e6}}, crushing_energy},
};
// clang-format on

}  // namespace

std::span<const Rule> rules() { return kRules; }

const Rule* rule_for(Role role, std::string_view key, std::string_view name) {
  for (const Rule& rule : kRules)
    if (rule.role == role && rule.gives == key && (name.empty() || rule.name == name)) return &rule;
  return nullptr;
}

std::optional<UnitRatios> ratios_of(UnitType type) {
  for (const UnitRatios& ratios : kRatios)
    if (ratios.type == type) return ratios;
  return std::nullopt;
}

bool holds_for(const Rule& rule, UnitType type) {
  if (rule.clay_alone)
    return type == UnitType::kClay || type == UnitType::kClayPerforated ||
           type == UnitType::kClayLightPerforated;
  return !rule.by_unit_type || ratios_of(type);
}

double cov_of(const Rule& rule, UnitType type) {
  const auto ratios = ratios_of(type);
  const bool tension = rule.value == unit_tension && ratios;
  return tension ? ratios->tension_cov : rule.cov;
}

}  // namespace wythe::materials
