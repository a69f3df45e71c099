// What one push tells of a push ten times slower: of its displacement capacity and its failure mode.
// RateVerdict (result.h) judges the force at the peak; these functions judge the path up to each of the two readings.
// Theory: docs/theory/integration.md, "Displacement and mode".
#pragma once

#include <string>
#include <vector>

#include "wythe/parts/model.h"
#include "wythe/parts/result.h"

namespace wythe {

struct SlowPushVerdict {
  std::string verdict = "no push";  // "slow enough", "not known", "no push"
  Message reason = {};              // of "not known": the cause on the path, and a cure
  [[nodiscard]] bool is_missing() const { return verdict == "not known"; }
};

// The curve of a run or of a stored sample.
struct JudgedCurve {
  const std::vector<CurveRow>& rows;
  const Responses& responses;
  const RateVerdict& rate;
};
// Whether a push ten times slower keeps 80 % of its peak up to the same displacement, within a tenth of it.
[[nodiscard]] SlowPushVerdict displacement_of_slow_push(const Model& model,
                                                        const JudgedCurve& curve);
[[nodiscard]] SlowPushVerdict displacement_of_slow_push(const Model& model, const Result& result);
// Whether it has the same failure mode. The mode was read at `read_at` [m]; `is_firm` is the result of is_firm() (failure_mode.h).
[[nodiscard]] SlowPushVerdict mode_of_slow_push(const Model& model, const JudgedCurve& curve,
                                                double read_at, bool is_firm);
[[nodiscard]] SlowPushVerdict mode_of_slow_push(const Model& model, const Result& result);

// Range of displacements around the peak in which the force stays within kFlatPeak of it: small causes move the peak within this
// range. NaN where there is no peak; `is_bound`: the push ended within the range.
inline constexpr double kFlatPeak = 0.02;
struct FlatPeak {
  double from, to;  // [m]
  bool is_bound;
  // Whether the range exceeds a tenth of the displacement on either side, so that this displacement alone says little.
  [[nodiscard]] bool says_little(double displacement_at_peak) const;
};
[[nodiscard]] FlatPeak flat_peak(const Result& result);  // NaN for load control

// Why a wall with a peak has no initial stiffness; empty where it has one.
[[nodiscard]] Message why_no_stiffness(const Responses& responses);

// Whether the velocity of the model's last push adapts to the wall.
[[nodiscard]] bool adapts(const Model& model);
// warning_of(result), or else the warning that one run cannot determine the drift.
[[nodiscard]] Message warning_of(const Model& model, const Result& result);

}  // namespace wythe
