// Finds the peak among rows in balance, then falls after it, dips before it, stiffness, works,
// bilinear curve and drifts. At a fall both reaction and base shear are below the level, because
// a rebound lowers only one of them (docs/theory/drift.md). Stiffness comes from `rise` where it
// is known, because it is finer than rows. Without a peak, all numbers that need one are NaN.
#include "dynamics/meters/responses.h"

#include <algorithm>
#include <cmath>

#include "core/real.h"
#include "dynamics/meters/balance.h"
#include "dynamics/meters/cyclic.h"
#include "dynamics/stages/stage_run.h"
#include "wythe/parts/slow_push.h"

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

// The rising branch from rows, where nothing finer is known.
std::vector<RisePoint> rise_of(const Curve& curve) {
  std::vector<RisePoint> rise;
  for (std::size_t i = 1; i < curve.size(); ++i)
    rise.push_back({curve[i].displacement, 0.5 * (curve[i].reaction + curve[i].base_shear)});
  return rise;
}

// Slope of the straight line that fits the points from 10 to 30 % of the peak best,
// weighted by their windows. With fewer than three points, the secant is used.
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

// The force that a row still carries. A rebound lowers the reaction
// or the base shear alone; a wall that lost its strength lowers both.
double carried(const CurveRow& row) { return std::max(row.reaction, row.base_shear); }

// A point of the curve between row - 1 and row.
struct Place {
  std::size_t row = 0;
  double displacement = 0, reaction = 0;
  bool censored = true;
};

// The force that a row carries for certain: a rebound raises only one of the two.
double held(const CurveRow& row) { return std::min(row.reaction, row.base_shear); }

// Falls to one reaction after the peak.
struct Falls {
  Place first, lasting, last;
  std::vector<Dip> dips;
};

// First row from `begin` on that carries less (or not less) than `reaction`; the curve's size where there is none.
std::size_t next_row(const Curve& curve, std::size_t begin, double reaction, bool less) {
  while (begin < curve.size() && (carried(curve[begin]) < reaction) != less) ++begin;
  return begin;
}

// A stretch of the curve below one reaction: from its fall to the return of the force. The force
// must be back for at least as long as it was away. A shorter return belongs to the same fall.
struct Below {
  Place fell;
  double until = 0;  // displacement where the force is back, or the curve's end [m]
  bool came_back = false;
  std::size_t back = 0;  // first row that carries the reaction again
};

double returns_at(const Curve& curve, std::size_t back, double reaction) {
  return back < curve.size() ? crossing(curve[back - 1], curve[back], reaction)
                             : curve.back().displacement;
}

Below below_from(const Curve& curve, std::size_t fell, double reaction) {
  Below below{{fell, crossing(curve[fell - 1], curve[fell], reaction), reaction, false}};
  const double end = curve.back().displacement;
  for (std::size_t next = fell; next < curve.size();) {
    below.back = next_row(curve, next, reaction, false);
    below.until = returns_at(curve, below.back, reaction);
    next = next_row(curve, below.back, reaction, true);
    const double left =
        next < curve.size() ? crossing(curve[next - 1], curve[next], reaction) : end;
    if (left - below.until >= below.until - below.fell.displacement) break;
    below.until = end,
    below.back = curve.size();  // no return that lasts long enough before the push ends
  }
  below.came_back = below.back < curve.size();
  return below;
}

// If the wall collapsed, its last row counts as a fall. If the push ended before a fall lasted, the fall is a lower bound.
Falls falls_to(const Curve& curve, std::size_t peak, double reaction, bool collapsed) {
  const Place end{curve.size() - 1, curve.back().displacement, curve.back().reaction, !collapsed};
  Falls falls{end, end, end, {}};
  bool any = false, lasted = false;
  for (std::size_t row = next_row(curve, peak + 1, reaction, true); row < curve.size();) {
    const Below below = below_from(curve, row, reaction);
    const bool lasts = below.until >= (1 + kLastingShare) * below.fell.displacement ||
                       (!below.came_back && collapsed);
    if (!any) falls.first = below.fell;
    any = true;
    if (!lasted && (lasts || !below.came_back)) {
      falls.lasting = below.fell;
      falls.lasting.censored = !lasts;
      lasted = true;
    }
    if (!lasts && below.came_back) {
      Dip dip{reaction / curve[peak].reaction, below.fell.displacement, below.until, 1};
      for (std::size_t i = row; i < below.back; ++i)
        dip.lowest = std::min(dip.lowest, carried(curve[i]) / curve[peak].reaction);
      falls.dips.push_back(dip);
    }
    row = next_row(curve, below.back, reaction, true);
  }
  // the last fall: no row after it carries the reaction
  for (std::size_t row = curve.size() - 1; carried(curve[row]) < reaction && row > peak; --row)
    falls.last = {row, crossing(curve[row - 1], curve[row], reaction), reaction, false};
  falls.last.censored =
      falls.last.censored ||
      (!collapsed && end.displacement < (1 + kLastingShare) * falls.last.displacement);
  return falls;
}

// Falls below `fraction` of the largest force so far, after which the force came back, before the
// peak. Rows below a fifth of the peak are skipped, because they belong to the start of the push.
std::vector<Dip> dips_before(const Curve& curve, std::size_t peak, double fraction) {
  constexpr double kBegun = 0.2;
  std::vector<Dip> dips;
  double largest = 0;
  for (std::size_t row = 1; row < peak;) {
    const double reaction = fraction * largest;
    if (largest < kBegun * curve[peak].reaction || carried(curve[row]) >= reaction) {
      largest = std::max(largest, held(curve[row++]));
      continue;
    }
    const std::size_t back = std::min(peak, next_row(curve, row, reaction, false));
    Dip dip{fraction, crossing(curve[row - 1], curve[row], reaction),
            crossing(curve[back - 1], curve[back], reaction), 1, true};
    for (; row < back; ++row) dip.lowest = std::min(dip.lowest, carried(curve[row]) / largest);
    dips.push_back(dip);
  }
  return dips;
}

FallTo fall_to(double fraction, const Falls& falls) {
  return {.fraction = fraction,
          .displacement = falls.lasting.displacement,
          .drift = 0,
          .censored = falls.lasting.censored,
          .first = falls.first.displacement,
          .censored_first = falls.first.censored,
          .last = falls.last.displacement,
          .censored_last = falls.last.censored};
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

// Height that the curve uses for the drift [m].
double load_height_of(const Curve& curve) {
  for (const CurveRow& row : curve)
    if (std::fabs(row.displacement) > 1e-9 && row.drift != 0) return row.displacement / row.drift;
  return 0;
}

// ke: secant at 0.6 peak. Equal areas up to du: A = Fu du - Fu^2 / (2 ke), of which Fu is the smaller
// root. Where the curve has more area than a straight line to du, Fu is that line's force at du.
Bilinear bilinear_of(const Curve& curve, const std::vector<RisePoint>& rise, double peak,
                     const Place& ultimate) {
  constexpr double kSecant = 0.6;
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

void evaluate_drifts(const Curve& curve, Responses& r) {
  r.load_height = load_height_of(curve);
  if (!(r.load_height > 0)) return;
  r.drift_at_peak = r.displacement_at_peak / r.load_height;
  r.drift_at_80 = r.displacement_at_80 / r.load_height;
  r.drift_max = r.displacement_max / r.load_height;
  r.collapse.drift = r.collapse.displacement / r.load_height;
  for (std::vector<FallTo>* falls : {&r.falls, &r.drift_capacity})
    for (FallTo& fall : *falls) fall.drift = fall.displacement / r.load_height;
}

Bilinear no_bilinear() { return {kUnset, kUnset, kUnset, kUnset, kUnset, true}; }

// Without a peak, all numbers that need one are unknown.
void leave_unknown(Responses& r, const std::vector<double>& fractions) {
  r.displacement_at_80 = r.drift_at_80 = r.drift_at_peak = r.initial_stiffness = kUnset;
  r.first_fall_80 = r.last_fall_80 = r.work_to_peak = r.work_to_80 = kUnset;
  const auto unknown = [](double fraction) {
    return FallTo{.fraction = fraction,
                  .displacement = kUnset,
                  .drift = kUnset,
                  .first = kUnset,
                  .last = kUnset};
  };
  for (const double fraction : fractions) r.falls.push_back(unknown(fraction));
  for (const double fraction : kSharesLeft) r.drift_capacity.push_back(unknown(fraction));
  r.bilinear = no_bilinear();
}

// Largest displacement before the reaction falls below a fifth of the peak for good.
void evaluate_largest(const Curve& curve, std::size_t peak, Responses& r) {
  std::size_t low = curve.size();
  while (low > peak + 1 && carried(curve[low - 1]) < 0.2 * r.peak_reaction) --low;
  if (low == curve.size()) return;
  r.displacement_max = curve[low].displacement;
  r.censored_max = false;
}

void evaluate_after_peak(const Curve& curve, std::size_t peak, const ResponseOptions& options,
                         Responses& r) {
  const bool collapsed = !options.collapse.empty();
  const auto falls = [&](double fraction) {
    return falls_to(curve, peak, fraction * r.peak_reaction, collapsed);
  };
  const Falls to_80 = falls(0.8);
  const Place& at_80 = to_80.lasting;
  const FallTo read = fall_to(0.8, to_80);
  r.displacement_at_80 = read.displacement, r.censored_80 = read.censored;
  r.first_fall_80 = read.first, r.censored_first_80 = read.censored_first;
  r.last_fall_80 = read.last, r.censored_last_80 = read.censored_last;
  r.dips = dips_before(curve, peak, 0.8);
  r.dips.insert(r.dips.end(), to_80.dips.begin(), to_80.dips.end());
  for (const double fraction : options.fractions)
    r.falls.push_back(fall_to(fraction, falls(fraction)));
  for (const double left : kSharesLeft) r.drift_capacity.push_back(fall_to(left, falls(left)));
  evaluate_largest(curve, peak, r);
  const std::vector<RisePoint> rise = options.rise.empty() ? rise_of(curve) : options.rise;
  // A push that starts on a loaded wall has no rise from zero, so neither stiffness can be read.
  const bool begins_loaded =
      !options.rise.empty() && options.rise.front().force > 0.1 * r.peak_reaction;
  const bool is_told = !begins_loaded && !dynamics::outruns(curve, r.peak_reaction);
  r.initial_stiffness = is_told ? initial_stiffness_of(rise, r.peak_reaction) : kUnset;
  r.work_to_peak = work_up_to(curve, row_place(curve, peak));
  r.work_to_80 = work_up_to(curve, at_80);
  r.bilinear = begins_loaded ? no_bilinear() : bilinear_of(curve, rise, r.peak_reaction, at_80);
}

void evaluate_push(const Curve& curve, const ResponseOptions& options, Responses& r) {
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
  evaluate_after_peak(curve, *peak, options, r);
}

// A load that grows while the wall is in balance gives only the load that was
// carried. Beyond it the wall runs away, so the curve has no falling branch.
void evaluate_load(const Curve& curve, const ResponseOptions& options, Responses& r) {
  leave_unknown(r, options.fractions);
  r.displacement_max = kUnset;
  const bool carried_any = options.carried > 0;
  r.peak_reaction = carried_any ? options.carried : kUnset;
  r.displacement_at_peak = carried_any ? curve.back().displacement : kUnset;
  r.censored_peak = carried_any && options.collapse.empty();
  if (!carried_any) r.peak_reason = {"balance.nothing_carried"};
}

// Whether the run ended in the stage of its curve, not in a later stage.
bool ended_in_curve(const Model& model, const Result& result) {
  const std::size_t reports = std::min(result.stages.size(), model.stages.size());
  for (std::size_t k = reports; k-- > 0;)
    if (model.stages[k].spec.kind() == result.curve_of) return k + 1 == reports;
  return true;
}
}  // namespace

ResponseOptions reading_of(const Model& model, const Result& result) {
  ResponseOptions read;
  // a wall that fell after its push had ended, in a shake or under a load, shows nothing about the push
  if (result.status == SolveStatus::kCollapsed && !result.shaking.collapsed &&
      ended_in_curve(model, result))
    read.collapse = result.reason;
  read.rise = result.rise;
  if (is_load_controlled(result)) read.carried = result.load_factor * model.weight;
  return read;
}

std::optional<bool> threshold_decides(const std::vector<FallTo>& drift_capacity) {
  const auto at = [&](double fraction) {
    const auto found = std::find_if(drift_capacity.begin(), drift_capacity.end(),
                                    [&](const FallTo& fall) { return fall.fraction == fraction; });
    return found == drift_capacity.end() ? FallTo{} : *found;
  };
  const FallTo late = at(0.75), early = at(0.85);
  if (late.displacement > kThresholdDecides * early.displacement) return true;
  if (late.censored || early.censored) return std::nullopt;
  return false;
}

Responses read_responses(const std::vector<CurveRow>& curve, const ResponseOptions& options) {
  const bool pushed = std::isnan(options.carried);
  return pushed && dynamics::is_cyclic(curve) ? dynamics::evaluate_cyclic(curve, options)
                                              : evaluate_one_way(curve, options);
}

bool FlatPeak::says_little(double at_peak) const {
  constexpr double kLittle = 0.1;
  return from < (1 - kLittle) * at_peak || to > (1 + kLittle) * at_peak;
}

FlatPeak flat_peak(const Result& result) {
  const Responses& r = result.responses;
  const std::vector<CurveRow> curve = backbone_of(result.curve);
  FlatPeak flat{kUnset, kUnset, false};
  if (!(r.peak_reaction > 0) || is_load_controlled(result) || curve.empty()) return flat;
  std::size_t peak = 0;
  while (peak + 1 < curve.size() && curve[peak].displacement < r.displacement_at_peak) ++peak;
  const double least = (1 - kFlatPeak) * r.peak_reaction;
  std::size_t first = peak, last = peak;
  while (first > 0 && carried(curve[first - 1]) >= least) --first;
  while (last + 1 < curve.size() && carried(curve[last + 1]) >= least) ++last;
  flat.from = first > 0 ? crossing(curve[first - 1], curve[first], least) : curve[0].displacement;
  flat.is_bound = last + 1 == curve.size();
  flat.to =
      flat.is_bound ? curve[last].displacement : crossing(curve[last], curve[last + 1], least);
  return flat;
}

Message why_no_stiffness(const Responses& r) {
  if (!(r.peak_reaction > 0) || !std::isnan(r.initial_stiffness)) return {};
  if (r.cyclic.sense != 0) return {"stiffness.to_and_fro"};
  if (std::isnan(r.displacement_at_80)) return {"stiffness.load"};
  if (std::isnan(r.bilinear.stiffness)) return {"stiffness.no_rise"};
  return {"stiffness.outrun", {{"apart_percent", 100 * dynamics::kOutrun}}};
}

Responses evaluate_one_way(const std::vector<CurveRow>& curve, const ResponseOptions& options) {
  Responses r;
  if (curve.empty()) return r;
  const std::size_t raw = raw_peak_row(curve);
  r.peak_raw = curve[raw].reaction;
  r.displacement_at_peak_raw = curve[raw].displacement;
  r.displacement_max = curve.back().displacement;
  r.work_total = work_up_to(curve, row_place(curve, curve.size() - 1));
  if (std::isnan(options.carried))
    evaluate_push(curve, options, r);
  else
    evaluate_load(curve, options, r);
  r.collapse = collapse_of(curve, r, options.collapse);
  evaluate_drifts(curve, r);
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
