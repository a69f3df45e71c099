// The statistics of samples under records, in the form of statistics.json.
#pragma once

#include "io/export/statistics_numbers.h"

namespace wythe::io {

// Key `shaking`: shakes, those that do not count, the response at each intensity.
[[nodiscard]] Json shaking_json(const ShakingStatistics& s);
// Key `fragility` of such a study: one object for each limit state.
[[nodiscard]] Json limit_states_json(const ShakingStatistics& s);

}  // namespace wythe::io
