// Test results of units, mortar and masonry: the inputs of the rules for materials.
//
// src/materials derives joint laws from them (docs/theory/material_rules.md).
#pragma once

#include <limits>
#include <string>
#include <vector>

#include "wythe/parts/words.h"

namespace wythe {

// Kinds of unit; for most of them tests give ratios of properties.
enum class UnitType {
  kUnstated,
  kClay,
  kClayPerforated,
  kClayLightPerforated,
  kCalciumSilicate,
  kCalciumSilicatePerforated,
  kLightweightConcrete,
  kAeratedConcrete,
  kTuff,
  kStone
};
inline constexpr Word<UnitType> kUnitTypeWords[] = {
    {"clay", UnitType::kClay},
    {"clay_perforated", UnitType::kClayPerforated},
    {"clay_light_perforated", UnitType::kClayLightPerforated},
    {"calcium_silicate", UnitType::kCalciumSilicate},
    {"calcium_silicate_perforated", UnitType::kCalciumSilicatePerforated},
    {"lightweight_concrete", UnitType::kLightweightConcrete},
    {"aerated_concrete", UnitType::kAeratedConcrete},
    {"tuff", UnitType::kTuff},
    {"stone", UnitType::kStone}};

// Mean values of tests [SI]; NaN where not tested.
struct MasonrySpec {
  static constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
  UnitType unit_type = UnitType::kUnstated;
  double unit_strength = kNone;               // fb, normalised, gross section [Pa]
  double mortar_strength = kNone;             // fmo [Pa]
  double masonry_strength = kNone;            // fm, across the bed joints [Pa]
  double vertical_stress = kNone;             // mean compression of the wall under its loads [Pa]
  double initial_shear_strength = kNone;      // fv0 from triplet tests [Pa]
  double diagonal_shear_strength = kNone;     // tau0 of panels that crack diagonally [Pa]
  double friction_tan = kNone;                // mu from triplet tests [-]
  double youngs_modulus = kNone;              // E of masonry, across the bed joints [Pa]
  double shear_modulus = kNone;               // G of masonry [Pa]
  double weight = kNone;                      // of masonry per volume [N/m^3]
  double density = kNone;                     // of the masonry [kg/m^3]
  double unit_youngs_modulus = kNone;         // Eu [Pa]
  double mortar_youngs_modulus = kNone;       // Em [Pa]
  double interface_normal_stiffness = kNone;  // kn_i between elastic units, as published [Pa/m]
  double interface_shear_stiffness = kNone;   // ks_i [Pa/m]
  double joint_thickness = kNone;             // of a bed joint [m]
  double course_height = kNone;               // height of unit plus bed joint [m]
  double unit_length = kNone;                 // length of unit plus head joint [m]
  std::vector<std::string> origin = {};       // sources of values that were not given
};

}  // namespace wythe
