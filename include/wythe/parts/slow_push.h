// What one push says of a push ten times slower, beyond its force: of the displacement capacity and of the failure
// mode. RateVerdict (result.h) judges the force at the peak; these judge the way to where each of them is read.
// Theory: docs/theory/integration.md, "Displacement and mode".
#pragma once

#include <string>
#include <vector>

#include "wythe/parts/model.h"
#include "wythe/parts/result.h"

namespace wythe {

struct SlowPushVerdict {
  std::string verdict = "no push";  // "slow enough", "not known", "no push"
  Message reason = {};              // of "not known": what happened on the way, and what helps
  [[nodiscard]] bool is_missing() const { return verdict == "not known"; }
};

// Of a run or of a stored sample.
struct JudgedCurve {
  const std::vector<CurveRow>& rows;
  const Responses& responses;
  const RateVerdict& rate;
};
// That a push ten times slower keeps 80 % of its peak up to the same displacement, within a tenth of it.
[[nodiscard]] SlowPushVerdict displacement_of_slow_push(const Model& model,
                                                        const JudgedCurve& curve);
[[nodiscard]] SlowPushVerdict displacement_of_slow_push(const Model& model, const Result& result);
// That it fails in the same way. The mode is read at a displacement [m]; `is_firm`: what is_firm() of failure_mode.h says.
[[nodiscard]] SlowPushVerdict mode_of_slow_push(const Model& model, const JudgedCurve& curve,
                                                double read_at, bool is_firm);
[[nodiscard]] SlowPushVerdict mode_of_slow_push(const Model& model, const Result& result);

// Around the peak, where the force stays within kFlatPeak of it: on a flat curve small causes move the displacement of the
// peak this far. NaN where there is no peak; `is_bound`: the push ended within it.
inline constexpr double kFlatPeak = 0.02;
struct FlatPeak {
  double from, to;  // [m]
  bool is_bound;
  // Whether that is more than a tenth of the displacement to either side: the displacement alone says little then.
  [[nodiscard]] bool says_little(double displacement_at_peak) const;
};
[[nodiscard]] FlatPeak flat_peak(const Result& result);

// Why a wall with a peak has no initial stiffness; empty where it has one.
[[nodiscard]] Message why_no_stiffness(const Responses& responses);

// Whether the speed of its last push follows the wall.
[[nodiscard]] bool adapts(const Model& model);
// warning_of(result), or else that one run cannot tell the drift.
[[nodiscard]] Message warning_of(const Model& model, const Result& result);

}  // namespace wythe
