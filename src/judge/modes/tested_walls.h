// Written by tools/validation page from validation/walls.csv and predicted.csv:
// results of the tested walls by failure kind (docs/evidence/validation.md).
#pragma once

#include "wythe/parts/result.h"

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
    {"shear", 23, 0.894, 0.848, 0.943, 0.103, 0.445, 2, 0.0312, 0.283},
    {"sliding", 1, 0.798, kUnset, kUnset, kUnset, 0.989, 0.989, 0.0312, 0.0312},
    {"rocking", 11, 0.973, 0.931, 1.02, 0.0467, 0.963, 2.26, 0.00307, 0.215}};

// Drift at which walls of a kind have lost 20 % of their peak [-]: validation/drift_constants.csv.
struct TestedDriftKind {
  const char* kind;
  bool stone;
  int walls;
  double median, low, high;  // low to high contains nine of ten walls
};
inline constexpr TestedDriftKind kTestedDrifts[] = {
    {"shear", false, 79, 0.00277, 0.00181, 0.0061},
    {"mixed", false, 40, 0.00711, 0.00218, 0.0185},
    {"rocking", false, 18, 0.00956, 0.00277, 0.0215},
    {"shear", true, 49, 0.0077, 0.0033, 0.0178},
    {"mixed", true, 21, 0.0162, 0.0056, 0.047},
    {"rocking", true, 54, 0.0174, 0.0067, 0.045}};

// Predicted over measured drifts by kind: median ratio, and exp(sd of ln) about it.
struct OwnDrift {
  const char* kind;
  int walls;
  double ratio, factor;
};
inline constexpr OwnDrift kOwnDrifts[] = {
    {"shear", 23, 0.762, 3.6},
    {"rocking", 0, kUnset, kUnset},
    {"mixed", 5, 1.48, 1.92}};
// clang-format on

}  // namespace wythe::study
