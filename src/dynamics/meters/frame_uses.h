// The largest use of each frame over the curve, and where and when it first yielded.
#pragma once

#include <vector>

#include "wythe/parts/result.h"

namespace wythe::dynamics {

[[nodiscard]] std::vector<FrameUse> evaluate_frame_uses(const Model& model, const Result& result);

// "the top of the left column", "1.20 m along the beam".
[[nodiscard]] Message place_in_frame(const Model& model, std::size_t section);

}  // namespace wythe::dynamics
