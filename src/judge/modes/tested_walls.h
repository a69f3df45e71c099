// Written by tools/validation page from validation/walls.csv and predicted.csv: what the tested walls say, by kind of
// failure (docs/evidence/validation.md).
#pragma once

#include "wythe/result.h"

namespace wythe::study {

struct TestedKind {
  const char* kind;
  int walls;
  double bias, bias_low, bias_high, scatter;  // of predicted over measured peaks
  double slender_low, slender_high;           // height over length of the walls
  double axial_low, axial_high;               // pressure at the base over compressive strength
};
// clang-format off
inline constexpr TestedKind kTestedKinds[] = {
    {"shear", 4, 1.02, 0.773, 1.35, 0.158, 0.989, 2, 0.0312, 0.183},
    {"sliding", 1, 0.829, kUnset, kUnset, kUnset, 0.989, 0.989, 0.0312, 0.0312},
    {"rocking", 4, 0.943, 0.847, 1.05, 0.0476, 1.2, 2.26, 0.00307, 0.0508}};
// clang-format on

}  // namespace wythe::study
