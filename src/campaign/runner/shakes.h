// The shakes of a sample: its next intensity, and the result of each shake.
#pragma once

#include <optional>
#include <vector>

#include "wythe/parts/campaign.h"

namespace wythe::study {

// The intensity after the shakes that are done; none if the sample has ended. It depends only on their results.
[[nodiscard]] std::optional<double> next_intensity(const ShakingSpec& shaking,
                                                   const StudyRecord& record,
                                                   const std::vector<ShakeResult>& done);
// The result of a run with a shake; `shaking` is that of the study.
[[nodiscard]] ShakeResult shake_answer(const ShakingSpec& shaking, double intensity,
                                       const Model& model, const Result& result);
// Refuses drift limits for a control point without a height.
void check_control_point(const ShakingSpec& shaking, const Model& model);
// Sets hash and status of a sample from those of its shakes.
void sum_up(const std::vector<ShakeResult>& shakes, SampleRecord& record);

}  // namespace wythe::study
