// From signs to a name: FM-1 ... FM-5 for two piers and one opening, a plain name otherwise.
// Called by failure_mode.cpp.
#pragma once

#include <vector>

#include "judge/modes/element_states.h"
#include "wythe/parts/failure_mode.h"
#include "wythe/parts/mechanism.h"

namespace wythe::study {

// Name, scores, sentence, evidence and elements, without flags and first displacements. `spandrel_later`:
// the truth that a pier of a portal sheared before its spandrel; one state cannot show it.
[[nodiscard]] FailureMode name_parts(const WallParts& parts, const WallMotion& motion,
                                     const ModeRules& rules, double spandrel_later = 0);
[[nodiscard]] bool is_two_pier_wall(const WallParts& parts);
// That truth, from the element states `readings` up to the state that is read.
struct ElementReading {
  double displacement = 0;  // [m]
  ElementStates elements;
};
[[nodiscard]] double spandrel_later(const WallParts& parts,
                                    const std::vector<ElementReading>& readings,
                                    const ModeRules& rules);
// The same with the mechanism of the whole wall.
struct Named {
  FailureMode mode;
  WallMechanism mechanism;
};
[[nodiscard]] Named name_wall(const WallParts& parts, const WallMotion& motion,
                              const ModeRules& rules, double spandrel_later = 0);

// The name of a mode in words for a reader; a name without words stays unchanged.
[[nodiscard]] Message words_of_mode(const std::string& name);

}  // namespace wythe::study
