#include "dynamics/meters/responses.h"

#include <algorithm>
#include <cmath>

#include "core/real.h"
#include "dynamics/meters/balance.h"
#include "dynamics/meters/cyclic.h"
#include "dynamics/stages/stage_run.h"

namespace wythe {
namespace {

// Displacement at which the straight line between two rows crosses a reaction.
double crossing(const CurveRow& a, const CurveRow& b, double reaction) {
  const double rise = b.reaction - a.reaction;
  const double share = rise == 0 ? 0.0 : clip((reaction - a.reaction) / rise, 0.0, 1.0);
  return a.displacement + share * (b.displacement - a.displacement);
}

using Curve = std::vector<CurveRow>;

// Displacement where the rising branch first reaches `force`.
double rising_crossing(const std::vector<RisePoint>& rise, double force) {
  RisePoint before;
  for (const RisePoint& point : rise) {
    if (point.force >= force) {
      const double share = (force - before.force) / (point.force - before.force);
      return before.displacement + share * (point.displacement - before.displacement);
    }
    before = point;
  }
  return rise.empty() ? 0.0 : rise.back().displacement;
}

// The rising branch where only rows are known.
std::vector<RisePoint> rise_of(const Curve& curve) {
  std::vector<RisePoint> rise;
  for (std::size_t i = 1; i < curve.size(); ++i)
    rise.push_back({curve[i].displacement, 0.5 * (curve[i].reaction + curve[i].base_shear)});
  return rise;
}

// Slope of the straight line through the points from 10 to 30 % of the peak that is nearest to them, each
// with the weight of its window; with fewer than three of them the secant.
double initial_stiffness_of(const std::vector<RisePoint>& rise, double peak) {
  double w = 0, x = 0, y = 0, xx = 0, xy = 0, before = 0;
  int count = 0;
  for (const RisePoint& point : rise) {
    const double weight = std::fabs(point.displacement - before), d = point.displacement;
    before = d;
    if (point.force > 0.3 * peak) break;
    if (point.force < 0.1 * peak) continue;
    ++count;
    w += weight;
    x += weight * d;
    y += weight * point.force;
    xx += weight * d * d;
    xy += weight * d * point.force;
  }
  const double spread = w * xx - x * x;
  if (count >= 3 && spread > 0) return (w * xy - x * y) / spread;
  const double d1 = rising_crossing(rise, 0.1 * peak), d3 = rising_crossing(rise, 0.3 * peak);
  return d3 > d1 ? 0.2 * peak / (d3 - d1) : kUnset;
}

std::size_t raw_peak_row(const Curve& curve) {
  std::size_t peak = 0;
  for (std::size_t i = 1; i < curve.size(); ++i)
    if (curve[i].reaction > curve[peak].reaction) peak = i;
  return peak;
}

// What a row still carries: a rebound lets the reaction or the base shear dip alone, a wall that has lost
// its strength lets both.
double carried(const CurveRow& row) { return std::max(row.reaction, row.base_shear); }

// A point of the curve: at `displacement`, `reaction`, between row - 1 and row.
struct Place {
  std::size_t row = 0;
  double displacement = 0, reaction = 0;
  bool censored = true;
};

// First fall to `reaction` after the peak, else the last row: where the wall collapsed it fell there.
Place fall_to(const Curve& curve, std::size_t peak, double reaction, bool collapsed) {
  for (std::size_t i = peak + 1; i < curve.size(); ++i)
    if (carried(curve[i]) < reaction)
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
Bilinear bilinear_of(const Curve& curve, const std::vector<RisePoint>& rise, double peak,
                     const Place& ultimate) {
  constexpr double kSecant = 0.7;
  Bilinear b;
  const double secant_at = rising_crossing(rise, kSecant * peak);
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

Collapse collapse_of(const Curve& curve, const Responses& r, const Message& reason) {
  Collapse c;
  c.displacement = curve.back().displacement;
  c.censored = false;
  if (!r.censored_max) {
    c.displacement = r.displacement_max;
    c.criterion = {"collapse.below_a_fifth"};
  } else if (!reason.empty()) {
    c.criterion = reason;
  } else {
    c.censored = true;
    c.criterion = {"collapse.not_reached"};
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

Bilinear no_bilinear() { return {kUnset, kUnset, kUnset, kUnset, kUnset, true}; }

// What only a peak gives is not known without one.
void leave_unknown(Responses& r, const std::vector<double>& fractions) {
  r.displacement_at_80 = r.drift_at_80 = r.drift_at_peak = r.initial_stiffness = kUnset;
  r.work_to_peak = r.work_to_80 = kUnset;
  for (const double fraction : fractions) r.falls.push_back({fraction, kUnset, kUnset, true});
  r.bilinear = no_bilinear();
}

// Largest displacement before the reaction stays below a fifth of the peak, to the end.
void read_largest(const Curve& curve, std::size_t peak, Responses& r) {
  std::size_t low = curve.size();
  while (low > peak + 1 && carried(curve[low - 1]) < 0.2 * r.peak_reaction) --low;
  if (low == curve.size()) return;
  r.displacement_max = curve[low].displacement;
  r.censored_max = false;
}

void read_after_peak(const Curve& curve, std::size_t peak, const ResponseOptions& options,
                     Responses& r) {
  const bool collapsed = !options.collapse.empty();
  const Place at_80 = fall_to(curve, peak, 0.8 * r.peak_reaction, collapsed);
  r.displacement_at_80 = at_80.displacement;
  r.censored_80 = at_80.censored;
  for (const double fraction : options.fractions) {
    const Place fall = fall_to(curve, peak, fraction * r.peak_reaction, collapsed);
    r.falls.push_back({fraction, fall.displacement, 0, fall.censored});
  }
  read_largest(curve, peak, r);
  const std::vector<RisePoint> rise = options.rise.empty() ? rise_of(curve) : options.rise;
  // A push that begins on a wall already pushed has no rise from zero, so neither stiffness is to be had.
  const bool begins_loaded =
      !options.rise.empty() && options.rise.front().force > 0.1 * r.peak_reaction;
  r.initial_stiffness = begins_loaded ? kUnset : initial_stiffness_of(rise, r.peak_reaction);
  r.work_to_peak = work_up_to(curve, row_place(curve, peak));
  r.work_to_80 = work_up_to(curve, at_80);
  r.bilinear = begins_loaded ? no_bilinear() : bilinear_of(curve, rise, r.peak_reaction, at_80);
}

void read_push(const Curve& curve, const ResponseOptions& options, Responses& r) {
  const auto peak = dynamics::largest_in_balance(curve);
  if (!peak || dynamics::force_beyond(curve, curve[*peak].reaction) > dynamics::kKnown) {
    r.peak_reaction = r.displacement_at_peak = kUnset;
    r.peak_reason = dynamics::why_out_of_balance(curve);
    leave_unknown(r, options.fractions);
    return;
  }
  r.peak_reaction = curve[*peak].reaction;
  r.displacement_at_peak = curve[*peak].displacement;
  const bool at_the_end = r.displacement_at_peak >= 0.99 * curve.back().displacement;
  r.censored_peak = at_the_end && options.collapse.empty();
  read_after_peak(curve, *peak, options, r);
}

// A load that grows while the wall is in balance: what it carried, and no more; the wall has no curve
// beyond, for there it runs away.
void read_load(const Curve& curve, const ResponseOptions& options, Responses& r) {
  leave_unknown(r, options.fractions);
  r.displacement_max = kUnset;
  const bool carried_any = options.carried > 0;
  r.peak_reaction = carried_any ? options.carried : kUnset;
  r.displacement_at_peak = carried_any ? curve.back().displacement : kUnset;
  r.censored_peak = carried_any && options.collapse.empty();
  if (!carried_any) r.peak_reason = {"balance.nothing_carried"};
}

}  // namespace

ResponseOptions reading_of(const Model& model, const Result& result) {
  ResponseOptions read;
  // a wall that falls in a shake after its push had ended standing tells nothing of the push
  if (result.status == SolveStatus::kCollapsed && !result.shaking.collapsed)
    read.collapse = result.reason;
  read.rise = result.rise;
  if (is_load_controlled(result)) read.carried = result.load_factor * model.weight;
  return read;
}

Responses read_responses(const std::vector<CurveRow>& curve, const ResponseOptions& options) {
  const bool pushed = std::isnan(options.carried);
  return pushed && dynamics::is_cyclic(curve) ? dynamics::read_cyclic(curve, options)
                                              : read_one_way(curve, options);
}

Responses read_one_way(const std::vector<CurveRow>& curve, const ResponseOptions& options) {
  Responses r;
  if (curve.empty()) return r;
  const std::size_t raw = raw_peak_row(curve);
  r.peak_raw = curve[raw].reaction;
  r.displacement_at_peak_raw = curve[raw].displacement;
  r.displacement_max = curve.back().displacement;
  r.work_total = work_up_to(curve, row_place(curve, curve.size() - 1));
  if (std::isnan(options.carried))
    read_push(curve, options, r);
  else
    read_load(curve, options, r);
  r.collapse = collapse_of(curve, r, options.collapse);
  read_drifts(curve, r);
  return r;
}

namespace dynamics {
void add_curve_events(Result& result) {
  const Responses& r = result.responses;
  if (!(r.peak_reaction > 0) || is_load_controlled(result)) return;
  const double way = r.cyclic.sense < 0 ? -1 : 1;
  result.events.push_back({{"event.peak"}, way * r.displacement_at_peak, way * r.peak_reaction});
  if (!r.censored_80)
    result.events.push_back(
        {{"event.fall_to_80"}, way * r.displacement_at_80, way * 0.8 * r.peak_reaction});
  if (r.cyclic.sense != 0) return;  // displacements to and fro are no order
  std::stable_sort(result.events.begin(), result.events.end(),
                   [](const Event& a, const Event& b) { return a.displacement < b.displacement; });
}

}  // namespace dynamics
}  // namespace wythe
