// From signs to a name: FM-1 ... FM-5 for two piers and one opening, a plain name otherwise.
// Called by failure_mode.cpp.
#pragma once

#include <vector>

#include "study/modes/element_states.h"
#include "wythe/failure_mode.h"
#include "wythe/mechanism.h"

namespace wythe::study {

// Name, scores, sentence, evidence and elements; no flags, no first displacements.
[[nodiscard]] FailureMode name_parts(const WallParts& parts, const WallMotion& motion,
                                     const ModeRules& rules);
// The same with the mechanism of the whole wall.
struct Named {
  FailureMode mode;
  WallMechanism mechanism;
};
[[nodiscard]] Named name_wall(const WallParts& parts, const WallMotion& motion,
                              const ModeRules& rules);

}  // namespace wythe::study
