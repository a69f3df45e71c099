// The protocol of a cyclic test: levels with their cycles, converted to a sequence of displacements.
//
//   amplitudes = a1, a2; cycles = 2     targets = a1, -a1, a1, -a1, a2, -a2, a2, -a2, 0
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "wythe/parts/wall_spec.h"

namespace wythe {

[[nodiscard]] bool has_protocol(const PushStage& push);
// Whether a push changes its direction, by targets or by a protocol.
[[nodiscard]] bool goes_to_and_fro(const PushStage& push);

// Displacements of a push in turn [m]: its targets, or those of its protocol, which end at zero. `height` [m] converts
// drifts. Empty for a push one way. A stage of a Model has both levels and the targets made of them.
[[nodiscard]] std::vector<double> targets_of(const PushStage& push, double height);

// Cycles and levels as a text, in mm or %: "2 × 2.5, 2 × 5".
[[nodiscard]] std::string told_levels(const PushStage& push);

// A fault of a stated protocol: its key in the stage, the value, and the cure.
struct ProtocolFault {
  std::string key, value, problem, cure;
};
[[nodiscard]] std::optional<ProtocolFault> fault_of_protocol(const PushStage& push);

}  // namespace wythe
