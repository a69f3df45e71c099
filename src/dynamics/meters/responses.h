// Responses of a run, evaluated from its curve after its end.
#pragma once

#include "wythe/parts/result.h"

namespace wythe {

// Responses of a push that never turns back.
[[nodiscard]] Responses evaluate_one_way(const std::vector<CurveRow>& curve,
                                         const ResponseOptions& options);

namespace dynamics {

// Adds "peak" and "80 % of the peak" to the events.
void add_curve_events(Result& result);

}  // namespace dynamics
}  // namespace wythe
