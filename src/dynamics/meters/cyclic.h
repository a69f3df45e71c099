// A push that turns back: its envelope in each direction, and the results of each cycle.
//
//   force ^      ____ envelope: rows that go farther than all before, along +
//         |   __/|
//         |  /  ||  <- unloading
//   ------+-/---||---> displacement
//         |/    |
//
// Rows are means over their windows, so force x step is the work of a window (docs/reference/results.md).
#pragma once

#include "wythe/parts/result.h"

namespace wythe::dynamics {

// True for a push whose displacement turns back by more than a thousandth of its range,
// or goes below zero. False for body forces and tilts, whose rows have a load factor.
[[nodiscard]] bool is_cyclic(const std::vector<CurveRow>& curve);

// The rows that go farther than all earlier ones in a sense (1, -1), like a push along it.
// A later excursion may come back with less force than the last one ended with. Then the
// envelope is straight until the force is regained, or up to the largest force beyond.
[[nodiscard]] std::vector<CurveRow> envelope_of(const std::vector<CurveRow>& curve, int sense);

// All responses of a cyclic curve.
[[nodiscard]] Responses evaluate_cyclic(const std::vector<CurveRow>& curve,
                                        const ResponseOptions& options);

}  // namespace wythe::dynamics
