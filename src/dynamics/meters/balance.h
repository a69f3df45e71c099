// Which rows of a curve are forces in balance, and how nearly static a push was where its peak is.
//
//   reaction    what the driven blocks feel          |  in balance both are one force; where they differ,
//   base shear  what reaches the ground              |  inertia or damping carries the difference
//
// Theory: docs/theory/integration.md, "A force in balance", "Is it static enough?".
#pragma once

#include <optional>

#include "wythe/parts/model.h"
#include "wythe/parts/result.h"

namespace wythe::dynamics {

inline constexpr double kBalance = 0.02;  // gap of a row in balance, as a share of the force
inline constexpr double kBalanceOver =
    0.05;  // length of the stretch, as a share of its displacement
inline constexpr double kUnbalance =
    0.003;  // unbalanced forces / contact forces: more rejects a peak

// Rows within kBalanceOver of a row's displacement (half on either side), at least the rows beside it.
struct Stretch {
  std::size_t first = 0, last = 0;  // both included
};
[[nodiscard]] Stretch stretch_around(const std::vector<CurveRow>& curve, std::size_t row);

// The row in balance with the largest reaction along `sense` (+1, or -1 for the other way).
[[nodiscard]] std::optional<std::size_t> largest_in_balance(const std::vector<CurveRow>& curve,
                                                            double sense = 1);

// How far the largest force that was applied and reached the ground exceeds `peak`, as a share of `peak`. The
// wall may carry it, although that row is out of balance. Above kKnown, `peak` only says where the push began.
inline constexpr double kKnown = 0.25;
[[nodiscard]] double force_beyond(const std::vector<CurveRow>& curve, double peak);

// The force of a row that was applied and reached the ground: the smaller of reaction and base shear.
[[nodiscard]] double passed_on(const CurveRow& row);

// Whether a push outran the wall: reaction and base shear differ by more than kOutrun of the
// peak before the wall's own force (their mean) is twice that. The force then rises from a jolt.
inline constexpr double kOutrun = 0.15;
[[nodiscard]] bool outruns(const std::vector<CurveRow>& curve, double peak);

// Why a curve has no force in balance.
[[nodiscard]] Message why_out_of_balance(const std::vector<CurveRow>& curve);

// Whether a push goes faster while the wall is in balance (4.7a).
[[nodiscard]] inline bool adapts(const PushStage& push) {
  return push.fast_velocity > push.velocity;
}

[[nodiscard]] inline bool drives_supports(const Model& model, const Stage& push) {
  return !push.driven.empty() && push.driven.front() >= model.n_block;
}

// The verdict on the push rate, from curve, responses and energy of a run. `supports`: a
// stage drives supports. They may move away from the wall as well as press on it, so no peak
// represents the path. The whole path is judged then (docs/theory/integration.md, 4.12a).
[[nodiscard]] RateVerdict judge_quasi_static(const Result& result, bool supports = false);

}  // namespace wythe::dynamics
