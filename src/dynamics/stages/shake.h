// A wall under an earthquake, computed in the frame of the base (docs/theory/dynamics.md).
#pragma once

#include "dynamics/stages/stage_run.h"

namespace wythe::dynamics {

[[nodiscard]] std::unique_ptr<StageRun> make_shake(StageContext& wall, const Stage& stage);

// Duration of a shake [s], and the time between rows of its history.
[[nodiscard]] double shake_duration(const Stage& stage);
[[nodiscard]] double shake_interval(const Stage& stage);

// Evaluates the results of all shakes from their rows.
void evaluate_shaking(const Model& model, Result& result);

}  // namespace wythe::dynamics
