// The failure of a wall in space in words, by what moved (docs/theory/failure_modes.md, "In space").
#pragma once

#include "wythe/failure_mode.h"

namespace wythe::study {

// "overturning", "sliding", "turning", "bending", "none", or "unclear".
[[nodiscard]] FailureMode name_in_space(const Model& model, const State& state);

}  // namespace wythe::study
