// The protocol of a cyclic test: levels, each with its cycles, as displacements to be reached one after the other.
//
//   amplitudes = a1, a2; cycles = 2     targets = a1, -a1, a1, -a1, a2, -a2, a2, -a2, 0
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "wythe/parts/wall_spec.h"

namespace wythe {

[[nodiscard]] bool has_protocol(const StageSpec& stage);
// Whether a push turns back, by targets or by a protocol.
[[nodiscard]] bool goes_to_and_fro(const StageSpec& stage);

// Displacements of a push in turn [m]: its targets, or those of its protocol, which end at zero. `height`: what
// drifts are of [m]. Empty: a push one way. A stage of a Model has both: its levels and the targets made of them.
[[nodiscard]] std::vector<double> targets_of(const StageSpec& stage, double height);

// Cycles and levels, in mm or %: "2 × 2.5, 2 × 5".
[[nodiscard]] std::string told_levels(const StageSpec& stage);

// What is wrong with a stated protocol: at which key of the stage, with its value, and the cure.
struct ProtocolFault {
  std::string key, value, problem, cure;
};
[[nodiscard]] std::optional<ProtocolFault> fault_of_protocol(const StageSpec& stage);

}  // namespace wythe
