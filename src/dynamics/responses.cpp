#include "dynamics/responses.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>

#include "dynamics/stage_run.h"

namespace wythe {
namespace {

// Displacement at which the straight line between two rows crosses a reaction.
double crossing(const CurveRow& a, const CurveRow& b, double reaction) {
  const double rise = b.reaction - a.reaction;
  const double share = rise == 0 ? 0.0 : (reaction - a.reaction) / rise;
  return a.displacement + share * (b.displacement - a.displacement);
}

using Curve = std::vector<CurveRow>;

// Displacement where the rising branch first reaches `reaction`.
double rising_crossing(const Curve& curve, double reaction) {
  for (std::size_t i = 1; i < curve.size(); ++i)
    if (curve[i].reaction >= reaction) return crossing(curve[i - 1], curve[i], reaction);
  return curve.back().displacement;
}

std::size_t peak_row(const Curve& curve) {
  std::size_t peak = 0;
  for (std::size_t i = 1; i < curve.size(); ++i)
    if (curve[i].reaction > curve[peak].reaction) peak = i;
  return peak;
}

// A point of the curve: at `displacement`, `reaction`, between row - 1 and row.
struct Place {
  std::size_t row = 0;
  double displacement = 0, reaction = 0;
  bool censored = true;
};

// First fall to `reaction` after the peak, else the last row: where the wall collapsed it fell there.
Place fall_to(const Curve& curve, std::size_t peak, double reaction, bool collapsed) {
  for (std::size_t i = peak + 1; i < curve.size(); ++i)
    if (curve[i].reaction < reaction)
      return {i, crossing(curve[i - 1], curve[i], reaction), reaction, false};
  return {curve.size() - 1, curve.back().displacement, curve.back().reaction, !collapsed};
}

// Work of the reaction along the curve up to a place on it; unloading gives work back.
double work_up_to(const Curve& curve, const Place& end) {
  double work = 0;
  for (std::size_t i = 1; i < end.row; ++i)
    work += 0.5 * (curve[i].reaction + curve[i - 1].reaction) *
            (curve[i].displacement - curve[i - 1].displacement);
  if (end.row == 0) return work;
  const CurveRow& last = curve[end.row - 1];
  return work + 0.5 * (end.reaction + last.reaction) * (end.displacement - last.displacement);
}

Place row_place(const Curve& curve, std::size_t row) {
  return {row, curve[row].displacement, curve[row].reaction, false};
}

// The drift's height by the curve's own ratio [m].
double load_height_of(const Curve& curve) {
  for (const CurveRow& row : curve)
    if (std::fabs(row.displacement) > 1e-9 && row.drift != 0) return row.displacement / row.drift;
  return 0;
}

// ke: secant at 0.7 peak. Equal areas up to du: A = Fu du - Fu^2 / (2 ke). The smaller root is Fu;
// where the curve holds more than a straight line to du could, the line's end stands for it.
Bilinear bilinear_of(const Curve& curve, double peak, const Place& ultimate) {
  constexpr double kSecant = 0.7;
  Bilinear b;
  const double secant_at = rising_crossing(curve, kSecant * peak);
  b.censored = ultimate.censored;
  b.ultimate_displacement = ultimate.displacement;
  if (!(secant_at > 0) || !(peak > 0)) return b;
  const double work = work_up_to(curve, ultimate), du = ultimate.displacement;
  b.stiffness = kSecant * peak / secant_at;
  b.force = b.stiffness * (du - std::sqrt(std::fmax(0.0, du * du - 2 * work / b.stiffness)));
  b.yield_displacement = b.force / b.stiffness;
  b.ductility = b.yield_displacement > 0 ? du / b.yield_displacement : 0.0;
  return b;
}

Collapse collapse_of(const Curve& curve, const Responses& r, const std::string& reason) {
  Collapse c;
  c.displacement = curve.back().displacement;
  c.censored = false;
  if (!r.censored_max) {
    c.displacement = r.displacement_max;
    c.criterion = "the reaction stays below 0.2 of its peak";
  } else if (!reason.empty()) {
    c.criterion = reason;
  } else {
    c.censored = true;
    c.criterion = "the run ended before the wall collapsed";
  }
  return c;
}

void read_drifts(const Curve& curve, Responses& r) {
  r.load_height = load_height_of(curve);
  if (!(r.load_height > 0)) return;
  r.drift_at_peak = r.displacement_at_peak / r.load_height;
  r.drift_at_80 = r.displacement_at_80 / r.load_height;
  r.drift_max = r.displacement_max / r.load_height;
  r.collapse.drift = r.collapse.displacement / r.load_height;
  for (FallTo& fall : r.falls) fall.drift = fall.displacement / r.load_height;
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

Responses read_responses(const std::vector<CurveRow>& curve, const ResponseOptions& options) {
  Responses r;
  if (curve.empty()) return r;
  const std::size_t peak = peak_row(curve);
  r.peak_reaction = curve[peak].reaction;
  r.displacement_at_peak = curve[peak].displacement;
  const bool collapsed = !options.collapse.empty();
  const Place at_80 = fall_to(curve, peak, 0.8 * r.peak_reaction, collapsed);
  r.displacement_at_80 = at_80.displacement;
  r.censored_80 = at_80.censored;
  for (const double fraction : options.fractions) {
    const Place fall = fall_to(curve, peak, fraction * r.peak_reaction, collapsed);
    r.falls.push_back({fraction, fall.displacement, 0, fall.censored});
  }
  r.displacement_max = curve.back().displacement;
  std::size_t low = curve.size();  // first of the rows that stay below 0.2 peak to the end
  while (low > peak + 1 && curve[low - 1].reaction < 0.2 * r.peak_reaction) --low;
  if (low < curve.size()) {
    r.displacement_max = curve[low].displacement;
    r.censored_max = false;
  }
  const double d1 = rising_crossing(curve, 0.1 * r.peak_reaction);
  const double d3 = rising_crossing(curve, 0.3 * r.peak_reaction);
  if (d3 > d1) r.initial_stiffness = 0.2 * r.peak_reaction / (d3 - d1);
  r.work_to_peak = work_up_to(curve, row_place(curve, peak));
  r.work_to_80 = work_up_to(curve, at_80);
  r.work_total = work_up_to(curve, row_place(curve, curve.size() - 1));
  r.bilinear = bilinear_of(curve, r.peak_reaction, at_80);
  r.collapse = collapse_of(curve, r, options.collapse);
  read_drifts(curve, r);
  return r;
}

namespace dynamics {
namespace {

// Drag is the mean gap between reaction and base shear over the peak. In the rate study of the tuff
// wall (docs/sensitivity.md) the peak lay above its slow limit by 0.9 to 1.7 times the drag.
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
  q.damping_share = result.quasi_static.damping_share;
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
