// The mechanism of the whole wall in one short sentence: docs/theory/failure_modes.md, "Mechanism".
//
//   "soft storey 1: the piers fail in shear"      "the wall slides on its foundation"
//   "weak spandrels, and the piers rock"          "unclear: the piers rock; or one pier fails in shear"
#pragma once

#include <map>
#include <string>
#include <vector>

#include "wythe/parts/failure_mode.h"

namespace wythe {

struct WallMechanism {
  std::string name = "none";  // "base sliding", "piers in shear", "weak spandrels, rocking piers",
                              // ..., "partial", "none", "unclear"
  std::vector<int> storeys = {};              // whose piers move so; empty: not of single storeys
  std::vector<std::string> candidates = {};   // of "unclear": the two most likely
  std::map<std::string, double> scores = {};  // 0 to 1, their sum is 1
  Message sentence = {};                      // empty where no state was read
};

[[nodiscard]] WallMechanism mechanism_from_state(const Model& model, const State& state);
// Reads the mechanism from the state that name_failure_mode() reads, by the same rules and doubts.
[[nodiscard]] WallMechanism read_mechanism(const Model& model, const Result& result,
                                           double read_at = kReadModesAt);

}  // namespace wythe
