// The mechanism of the whole wall, from the damage of its parts. Called by mode_names.cpp.
//
// With W the truth that the spandrels are sheared (more than half of their length), M_k that the piers of
// storey k have failed (more than half of their width is sheared or rocks) and M the largest M_k, the
// scores share out 1:
//
//   sliding   S                       (1 - S)   W       1 - W
//                                     M         weak spandrels and piers,      piers alone
//                                     1 - M     weak spandrels alone           none, or partial
//
// Partial: a pier or spandrel has failed, but not most of a storey's piers or of the spandrels.
// M is shared out further: the piers are in shear where two thirds of the failed width are sheared, they
// rock where two thirds rock, else both. A wall of two piers and one opening takes its mode's name.
#pragma once

#include "judge/modes/element_states.h"
#include "wythe/parts/mechanism.h"

namespace wythe::study {

// The slip along the whole wall, and the truth that it is most of the wall's displacement.
struct Slips {
  double base = 0, bed = 0, top = 0;  // [m]
  double truth = 0;
  [[nodiscard]] double all() const { return base + bed + top; }
};

struct WallSigns {
  const WallParts& parts;
  const ElementStates& elements;
  const Truths& truths;
  const WallMotion& motion;
  const ModeRules& rules;
  Slips slips;
};

[[nodiscard]] WallMechanism mechanism_of(const WallSigns& wall);
// The mechanism of a wall of two piers and one opening, from the scores of its modes.
[[nodiscard]] WallMechanism mechanism_of_portal(const FailureMode& mode, const WallSigns& wall);

inline constexpr double kClear = 0.3;  // lead below which a name is "unclear"

}  // namespace wythe::study
