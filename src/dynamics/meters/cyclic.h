// A push that turns back: its envelope in each direction, and what each of its cycles says.
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

// A push whose displacement turns back by more than a thousandth of its range, or goes below zero.
// Body forces and tilts, whose rows have a load factor, are none.
[[nodiscard]] bool is_cyclic(const std::vector<CurveRow>& curve);

// Rows that go farther than all before in a sense (1, -1), as of a push along it. Where a later
// excursion comes back with less force than the last one ended with, the envelope is straight from
// there to where the force is regained, or else to the largest one beyond.
[[nodiscard]] std::vector<CurveRow> envelope_of(const std::vector<CurveRow>& curve, int sense);

// All of Responses for a cyclic curve.
[[nodiscard]] Responses evaluate_cyclic(const std::vector<CurveRow>& curve,
                                        const ResponseOptions& options);

}  // namespace wythe::dynamics
