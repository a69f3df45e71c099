// The shakes of one sample: the next intensity, and the result of each.
#pragma once

#include <optional>
#include <vector>

#include "wythe/parts/campaign.h"

namespace wythe::study {

// The intensity after those that are done; none: the sample has ended. It depends on the answers alone.
[[nodiscard]] std::optional<double> next_intensity(const ShakingSpec& shaking,
                                                   const StudyRecord& record,
                                                   const std::vector<ShakeResult>& done);
// What a run answered that was shaken; `shaking` is the study's.
[[nodiscard]] ShakeResult shake_answer(const ShakingSpec& shaking, double intensity,
                                       const Model& model, const Result& result);
// Refuses limits of drift for a control point that has no height to measure it by.
void check_control_point(const ShakingSpec& shaking, const Model& model);
// Hash and status of a sample from those of its shakes.
void sum_up(const std::vector<ShakeResult>& shakes, SampleRecord& record);

}  // namespace wythe::study
