#include "dynamics/responses.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>

#include "dynamics/stage_runner.h"

namespace wythe {
namespace {

// Displacement at which the straight line between two rows crosses a reaction.
double crossing(const CurveRow& a, const CurveRow& b, double reaction) {
  const double rise = b.reaction - a.reaction;
  const double share = rise == 0 ? 0.0 : (reaction - a.reaction) / rise;
  return a.displacement + share * (b.displacement - a.displacement);
}

// Displacement where the rising branch first reaches `reaction`.
double rising_crossing(const std::vector<CurveRow>& curve, double reaction) {
  for (std::size_t i = 1; i < curve.size(); ++i)
    if (curve[i].reaction >= reaction) return crossing(curve[i - 1], curve[i], reaction);
  return curve.back().displacement;
}

}  // namespace

const char* to_string(SolveStatus status) {
  switch (status) {
    case SolveStatus::kCompleted: return "completed";
    case SolveStatus::kCollapsed: return "collapsed";
    case SolveStatus::kInterrupted: return "interrupted";
    case SolveStatus::kNotSettled: return "not_settled";
    case SolveStatus::kUnstable: return "unstable";
    case SolveStatus::kBudgetSpent: break;
  }
  return "budget_spent";
}

Responses read_responses(const std::vector<CurveRow>& curve) {
  Responses r;
  if (curve.empty()) return r;
  std::size_t peak = 0;
  for (std::size_t i = 1; i < curve.size(); ++i)
    if (curve[i].reaction > curve[peak].reaction) peak = i;
  r.peak_reaction = curve[peak].reaction;
  r.displacement_at_peak = curve[peak].displacement;
  r.displacement_at_80 = r.displacement_max = curve.back().displacement;
  for (std::size_t i = peak + 1; i < curve.size(); ++i) {
    if (curve[i].reaction >= 0.8 * r.peak_reaction) continue;
    r.displacement_at_80 = crossing(curve[i - 1], curve[i], 0.8 * r.peak_reaction);
    r.censored_80 = false;
    break;
  }
  std::size_t low = curve.size();  // first of the rows that stay below 0.2 peak to the end
  while (low > peak + 1 && curve[low - 1].reaction < 0.2 * r.peak_reaction) --low;
  if (low < curve.size()) {
    r.displacement_max = curve[low].displacement;
    r.censored_max = false;
  }
  const double d1 = rising_crossing(curve, 0.1 * r.peak_reaction);
  const double d3 = rising_crossing(curve, 0.3 * r.peak_reaction);
  if (d3 > d1) r.initial_stiffness = 0.2 * r.peak_reaction / (d3 - d1);
  return r;
}

namespace dynamics {
namespace {

// Drag is the mean gap between reaction and base shear over the peak. In the rate study of the tuff
// wall (docs/sensitivity.md) the peak lay above its slow limit by 1.3 to 1.9 times the drag.
constexpr double kLift = 1.7;
constexpr double kSlowDrag = 0.01;  // below: the peak is at most about 2 % high
constexpr double kFastDrag = 0.03;  // above: about 5 % and more

std::string verdict_for(const QuasiStatic& q) {
  const double percent = 100 * q.shear_gap, lift = kLift * percent;
  const auto say = [&](const char* words) {
    return fmt::format(
        "{}: inertia and damping drag on the push with {:.1f} % of the peak, which "
        "is then about {:.1f} % above that of a slow push",
        words, percent, lift);
  };
  if (q.shear_gap < kSlowDrag) return say("slow enough");
  if (q.shear_gap < kFastDrag)
    return say("usable, but halve the velocity or lower stage.damping to be sure");
  return say("too fast: halve the velocity");
}

}  // namespace

QuasiStatic judge_quasi_static(const Result& result) {
  QuasiStatic q;
  const double peak = result.responses.peak_reaction;
  if (result.curve.size() < 3 || !(peak > 0)) {
    q.verdict = "no push";
    return q;
  }
  // The start, where the work done is next to nothing, says nothing about the ratios.
  double count = 0, gap = 0;
  for (const CurveRow& row : result.curve) {
    if (row.displacement < 0.1 * result.responses.displacement_at_peak) continue;
    ++count;
    q.unbalance_ratio_mean += row.unbalance_ratio;
    q.kinetic_ratio_mean += row.kinetic_ratio;
    q.unbalance_ratio_max = std::max(q.unbalance_ratio_max, row.unbalance_ratio);
    q.kinetic_ratio_max = std::max(q.kinetic_ratio_max, row.kinetic_ratio);
    gap += row.reaction - row.base_shear;
  }
  if (count == 0) return q;
  q.unbalance_ratio_mean /= count;
  q.kinetic_ratio_mean /= count;
  q.shear_gap = std::fabs(gap) / count / peak;
  q.damping_share = result.energy.drive > 0 ? result.energy.damping / result.energy.drive : 0.0;
  q.verdict = verdict_for(q);
  return q;
}

void add_curve_events(Result& result) {
  const Responses& r = result.responses;
  if (!(r.peak_reaction > 0)) return;
  result.events.push_back({"peak", r.displacement_at_peak, r.peak_reaction, ""});
  if (!r.censored_80)
    result.events.push_back({"80 % of the peak", r.displacement_at_80, 0.8 * r.peak_reaction, ""});
  std::stable_sort(result.events.begin(), result.events.end(),
                   [](const Event& a, const Event& b) { return a.displacement < b.displacement; });
}

double expected_seconds(const Stage& stage) {
  constexpr double kSettle = 0.1;  // what a wall usually needs after the ramp [s]
  const StageSpec& s = stage.spec;
  switch (s.kind) {
    case StageKind::kGravity:
    case StageKind::kLoad: return s.ramp + kSettle;
    case StageKind::kPush: return driven_path(stage) / s.velocity + 0.5 * s.ramp;
    case StageKind::kBodyForce: return s.factor / s.rate;
    case StageKind::kTilt: return s.tilt_until / s.tilt_rate;
    case StageKind::kHold: return s.duration;
  }
  return 0;
}

}  // namespace dynamics
}  // namespace wythe
