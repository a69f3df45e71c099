// An artificial campaign with curves from formulas, so that every statistic has a result.
#pragma once

#include "wythe/parts/campaign.h"

namespace wythe::scenes {

// `n` samples of five inputs, all five modes, some censored displacements; no engine involved.
[[nodiscard]] Campaign sample_campaign(int n, std::uint64_t seed = 1);
// One answered sample: a triangle up to the peak at 10 mm, then down to 0.5 peak at 50 mm.
[[nodiscard]] SampleRecord sample_record(int sample, double peak, const std::string& mode);

}  // namespace wythe::scenes
