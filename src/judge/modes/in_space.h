// The failure of a wall in space in words, by what moved (docs/theory/failure_modes.md, "In space").
#pragma once

#include "wythe/parts/failure_mode.h"

namespace wythe::study {

// "overturning", "sliding", "turning", "bending", "none", or "unclear".
[[nodiscard]] FailureMode name_in_space(const Model& model, const State& state);

// Walls by their planes as they were built: what a push does to them does not depend on how they fail.
struct WallsByPush {
  int walls = 0;              // by the builder's names, else what hangs together
  int along = 0, across = 0;  // of them, by their planes; the others have none
  [[nodiscard]] bool all_along() const { return along == walls; }
  [[nodiscard]] bool all_across() const { return across > 0 && across == walls; }
};
[[nodiscard]] WallsByPush walls_by_push(const Model& model, const Vec3& push);

}  // namespace wythe::study
