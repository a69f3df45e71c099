// What tests say about units, mortar and masonry: the inputs of the rules for materials.
//
// Read by src/materials, which derives joint laws from it (docs/theory/material_rules.md).
#pragma once

#include "wythe/words.h"

namespace wythe {

// Kinds of unit; tests give ratios for most of them.
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
static_assert(names_all(kUnitTypeWords, 1));  // kUnstated is not written

}  // namespace wythe
