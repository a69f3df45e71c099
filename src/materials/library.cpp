// The library of typical materials; docs/theory/material_rules.md gives the sources of its values.
#include "materials/library.h"

#include <cmath>

#include "core/elementary.h"

namespace wythe::materials {
namespace {

constexpr Role kAll = Role::kMasonry, kBed = Role::kJoint, kCrack = Role::kUnit;
constexpr const char* kCircolare = "Circolare 21 January 2019 n. 7, Table C8.5.I";
constexpr const char* kFv0 =
    "JCSS Probabilistic Model Code 3.2: means that belong to EN 1996-1-1, Table 3.4";
constexpr const char* kTest = "Scatter: JCSS Probabilistic Model Code 3.2.";
constexpr const char* kNoJoint =
    "The table gives no fv0 for this masonry, only tau0 of diagonal cracks; a joint's cohesion "
    "follows by initial_shear_strength = \"rule\".";
constexpr const char* kLocalFriction = "Friction 0.577: C8.7.1.3, as a local coefficient.";

Datum between(const char* key, const char* unit, double low, double high) {
  return {kAll, key, unit, (low + high) / 2, low, high};
}
Datum mean(const char* key, const char* unit, double value, double cov = Datum::kNoBound) {
  return {.role = kAll, .key = key, .unit = unit, .value = value, .cov = cov};
}
Datum law(Role role, const char* key, const char* unit, double value,
          double cov = Datum::kNoBound) {
  return {.role = role, .key = key, .unit = unit, .value = value, .cov = cov};
}

struct Interval {
  double low, high;
};

// A row of the Italian table: fm, tau0, E and G [MPa], weight [kN/m^3], fv0 [MPa] (low 0: none).
Entry circolare(const char* name, const char* title, const char* note, UnitType type, Interval fm,
                Interval tau0, Interval e, Interval g, Interval weight, Interval fv0 = {0, 0}) {
  Entry out{name, title, kCircolare, note, type, {}};
  out.data = {between("masonry_strength", "MPa", fm.low, fm.high),
              between("diagonal_shear_strength", "MPa", tau0.low, tau0.high),
              between("youngs_modulus", "MPa", e.low, e.high),
              between("shear_modulus", "MPa", g.low, g.high),
              between("weight", "kN/m^3", weight.low, weight.high)};
  // C8.5.3.1: all rows but the last are for lime mortar of modest quality
  if (type != UnitType::kClayPerforated)
    out.data.push_back(between("mortar_strength", "MPa", 0.7, 1.5));
  if (fv0.low > 0) {
    out.data.push_back(between("initial_shear_strength", "MPa", fv0.low, fv0.high));
    out.data.push_back(mean("friction_tan", "", 0.577));
  }
  return out;
}

// Shear tests of couplets, by class of mortar, for a kind of unit.
Entry couplets(const char* name, const char* title, UnitType type, double fv0, double cov) {
  return {
      name, title,
      kFv0, "",
      type, {mean("initial_shear_strength", "MPa", fv0, cov), mean("friction_tan", "", 0.8, 0.19)}};
}

// Tests of one kind of masonry: fb, fmo, fm, E [MPa], fv0 [MPa], mu.
Entry tested(const char* name, const char* title, const char* source, UnitType type,
             const std::vector<double>& v) {
  return {
      name,
      title,
      source,
      kTest,
      type,
      {mean("unit_strength", "MPa", v[0]), mean("mortar_strength", "MPa", v[1]),
       mean("masonry_strength", "MPa", v[2], 0.17), mean("youngs_modulus", "MPa", v[3], 0.25),
       mean("initial_shear_strength", "MPa", v[4], 0.40), mean("friction_tan", "", v[5], 0.19)}};
}

// clang-format off
std::vector<Entry> codes() {
  return {
    circolare("circolare_rubble", "irregular rubble (pebbles, erratic and irregular stones)", kNoJoint,
              UnitType::kStone, {1.0, 2.0}, {0.018, 0.032}, {690, 1050}, {230, 350}, {19, 19}),
    circolare("circolare_rough_blocks", "roughly cut stones, leaves of uneven thickness", kNoJoint,
              UnitType::kStone, {2.0, 2.0}, {0.035, 0.051}, {1020, 1440}, {340, 480}, {20, 20}),
    circolare("circolare_split_stone", "split stones, well laid", kNoJoint,
              UnitType::kStone, {2.6, 3.8}, {0.056, 0.074}, {1500, 1980}, {500, 660}, {21, 21}),
    circolare("circolare_soft_stone_irregular", "irregular soft stone (tuff, calcarenite)", kNoJoint,
              UnitType::kTuff, {1.4, 2.2}, {0.028, 0.042}, {900, 1260}, {300, 420}, {13, 16}),
    circolare("circolare_soft_stone_regular", "regular blocks of soft stone (tuff, calcarenite)", kLocalFriction,
              UnitType::kTuff, {2.0, 3.2}, {0.04, 0.08}, {1200, 1620}, {400, 500}, {13, 16}, {0.10, 0.19}),
    circolare("circolare_squared_stone", "squared stone blocks", kLocalFriction,
              UnitType::kStone, {5.8, 8.2}, {0.09, 0.12}, {2400, 3300}, {800, 1100}, {22, 22}, {0.18, 0.28}),
    circolare("circolare_brick_lime", "solid bricks in lime mortar", kLocalFriction,
              UnitType::kClay, {2.6, 4.3}, {0.05, 0.13}, {1200, 1800}, {400, 600}, {18, 18}, {0.13, 0.27}),
    circolare("circolare_perforated_brick_cement", "perforated bricks (up to 40 %) in cement mortar", kLocalFriction,
              UnitType::kClayPerforated, {5.0, 8.0}, {0.08, 0.17}, {3500, 5600}, {875, 1400}, {15, 15}, {0.20, 0.36}),
    couplets("en1996_clay_m1", "clay units, general purpose mortar M1 to M2", UnitType::kClay, 0.04, 0.40),
    couplets("en1996_clay_m2_5", "clay units, general purpose mortar M2.5 to M4.5", UnitType::kClay, 0.14, 0.40),
    couplets("en1996_clay_m5", "clay units, general purpose mortar M5 to M9", UnitType::kClay, 0.28, 0.40),
    couplets("en1996_clay_m10", "clay units, general purpose mortar M10 to M19", UnitType::kClay, 0.37, 0.40),
    couplets("en1996_clay_m20", "clay units, general purpose mortar M20 and above", UnitType::kClay, 0.42, 0.40),
    couplets("en1996_calcium_silicate_m5", "calcium silicate units, general purpose mortar M5 to M9", UnitType::kCalciumSilicate, 0.28, 0.35),
    couplets("en1996_calcium_silicate_thin", "calcium silicate units, thin layer mortar", UnitType::kCalciumSilicate, 0.65, 0.35)};
}

std::vector<Entry> tests() {
  return {
    tested("clay_brick_old", "solid clay bricks in weak lime mortar, as in old walls", "Magenes and Calvi 1992", UnitType::kClay,
           {14.92, 4.33, 7.92, 2991, 0.21, 0.81}),
    tested("clay_brick_new", "strong solid clay bricks in weak mortar", "Graziotti et al. 2016", UnitType::kClay,
           {46.8, 4.12, 11.22, 9833, 0.15, 0.55}),
    tested("clay_perforated_new", "perforated clay blocks (49 % voids) in cement mortar", "Petry and Beyer 2014", UnitType::kClayPerforated,
           {39.55, 11.2, 5.87, 3550, 0.27, 0.94}),
    {"clay_brick_eindhoven", "solid clay bricks in cement lime mortar, as micro-models state them",
     "Lourenco and Rots 1997, tests of van der Pluijm and Raijmakers", "Energies and strengths of one series; compression is not included.", UnitType::kClay,
     {mean("unit_youngs_modulus", "MPa", 16700), mean("interface_normal_stiffness", "GPa/m", 82),
      mean("interface_shear_stiffness", "GPa/m", 36), mean("initial_shear_strength", "MPa", 0.35), mean("friction_tan", "", 0.75),
      law(kBed, "tensile_strength", "MPa", 0.25), law(kBed, "mode_1_energy", "N/m", 18), law(kBed, "mode_2_energy", "N/m", 125),
      law(kBed, "residual_cohesion", "MPa", 0), law(kCrack, "tensile_strength", "MPa", 2.0), law(kCrack, "mode_1_energy", "N/m", 80)}},
    {"tuff_pozzolanic", "Neapolitan tuff in pozzolanic mortar", "Pulatsu et al. 2022, Tables 1 and 2, tests of Augenti and Parisi", "", UnitType::kTuff,
     {law(kBed, "normal_stiffness", "GPa/m", 20), law(kBed, "shear_stiffness", "GPa/m", 8), law(kBed, "tensile_strength", "MPa", 0.15, 0.30),
      law(kBed, "cohesion", "MPa", 0.15), law(kBed, "friction_angle", "deg", 16.2, 0.20), law(kBed, "residual_friction_angle", "deg", 14.6),
      law(kBed, "residual_cohesion", "MPa", 0), law(kBed, "mode_1_energy", "N/m", 4.3), law(kBed, "mode_2_energy", "N/m", 125),
      law(kBed, "compressive_strength", "MPa", 3.96, 0.125), law(kBed, "compressive_energy", "N/m", 12800),
      law(kCrack, "normal_stiffness", "GPa/m", 10, 0.20), law(kCrack, "shear_stiffness", "GPa/m", 4), law(kCrack, "tensile_strength", "MPa", 0.23, 0.22),
      law(kCrack, "cohesion", "MPa", 0.46), law(kCrack, "friction_angle", "deg", 38), law(kCrack, "residual_friction_angle", "deg", 38),
      law(kCrack, "residual_cohesion", "MPa", 0), law(kCrack, "mode_1_energy", "N/m", 8), law(kCrack, "mode_2_energy", "N/m", 550),
      law(kCrack, "compressive_strength", "MPa", 3.96, 0.125), law(kCrack, "compressive_energy", "N/m", 12800)}},
    {"granite_dry", "sawn granite blocks without mortar", "Vasconcelos 2005, Vasconcelos and Lourenco 2009", "Friction as assumed there.", UnitType::kStone,
     {mean("masonry_strength", "MPa", 73), between("youngs_modulus", "MPa", 3287, 4068), mean("friction_tan", "", 0.65),
      law(kBed, "tensile_strength", "MPa", 0), law(kBed, "cohesion", "MPa", 0), law(kBed, "residual_cohesion", "MPa", 0)}},
    {"granite_lime", "granite blocks in hydraulic lime mortar", "Vasconcelos and Lourenco 2009", "No couplets: cohesion and friction are not known.", UnitType::kStone,
     {mean("unit_strength", "MPa", 69.2), mean("unit_youngs_modulus", "MPa", 20200), mean("mortar_strength", "MPa", 3.75),
      mean("masonry_strength", "MPa", 18.4), mean("youngs_modulus", "MPa", 3840)}},
    {"limestone_dry", "sawn limestone blocks without mortar", "Lourenco et al. 2005", "Friction as assumed there.", UnitType::kStone,
     {mean("youngs_modulus", "MPa", 756), mean("friction_tan", "", 0.62),
      law(kBed, "tensile_strength", "MPa", 0), law(kBed, "cohesion", "MPa", 0), law(kBed, "residual_cohesion", "MPa", 0)}}};
}
// clang-format on

}  // namespace

std::span<const Entry> library() {
  static const std::vector<Entry> all = [] {
    std::vector<Entry> out = codes();
    for (Entry& entry : tests()) out.push_back(std::move(entry));
    return out;
  }();
  return all;
}

const Entry* entry_of(std::string_view name) {
  for (const Entry& entry : library())
    if (entry.name == name) return &entry;
  return nullptr;
}

const Datum* datum_of(const Entry& entry, Role role, std::string_view key) {
  for (const Datum& datum : entry.data)
    if (datum.role == role && datum.key == key) return &datum;
  return nullptr;
}

double cov_of(const Datum& datum) {
  if (!std::isnan(datum.cov) || !(datum.high > datum.low)) return datum.cov;
  const double s = 0.5 * elementary::log(datum.high / datum.low);
  return std::sqrt(elementary::expm1(s * s));
}

}  // namespace wythe::materials
