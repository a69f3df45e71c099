// Evaluates the envelope of each direction like a push that never turns back. The direction with the
// larger peak gives the responses. Excursions lie between turns of the displacement. Two successive half
// cycles of opposite sense form one full cycle. Definitions: docs/reference/results.md, "Cyclic pushes".
#include "dynamics/meters/cyclic.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <utility>

#include "dynamics/meters/balance.h"
#include "dynamics/meters/responses.h"

namespace wythe::dynamics {
namespace {

using Curve = std::vector<CurveRow>;

constexpr double kTurn = 1e-3;          // of the range: shortest way back that counts as a turn
constexpr double kBack = 0.05;          // of an excursion: a displacement below it counts as zero
constexpr double kSame = 0.02;          // largest difference of amplitudes within one cycle
constexpr std::size_t kFewestRows = 4;  // on the way out and back, to give a damping ratio
constexpr double kNone = std::numeric_limits<double>::quiet_NaN();

// The shortest way back that counts as a turn [m].
double turn_of(const Curve& curve) {
  double low = 0, high = 0;
  for (const CurveRow& row : curve) {
    low = std::min(low, row.displacement);
    high = std::max(high, row.displacement);
  }
  return kTurn * (high - low);
}

// Rows where the displacement turns, with the first row and the farthest row after the last turn.
std::vector<std::size_t> turns_of(const Curve& curve) {
  const double turn = turn_of(curve);
  std::vector<std::size_t> turns = {0};
  std::size_t farthest = 0;
  double way = 0;
  for (std::size_t i = 1; i < curve.size(); ++i) {
    const double step = curve[i].displacement - curve[farthest].displacement;
    if (way == 0) {
      if (std::fabs(step) <= turn) continue;
      way = step > 0 ? 1 : -1;
    } else if (way * step < -turn) {
      turns.push_back(farthest);
      way = -way;
    } else if (way * step <= 0) {
      continue;
    }
    farthest = i;
  }
  if (farthest > turns.back()) turns.push_back(farthest);
  return turns;
}

CurveRow mirrored(CurveRow row, int sense) {
  row.displacement *= sense;
  row.drift *= sense;
  row.reaction *= sense;
  row.base_shear *= sense;
  return row;
}

// --- cycles

// From one turn over the extreme to the next turn, seen along its own sense.
struct Excursion {
  int sense = 1;
  std::size_t before = 0, extreme = 0, after = 0;  // rows; after = extreme: no turn
  double begin = 0, end = 0, amplitude = 0;        // [m]
  [[nodiscard]] bool turned_back() const { return after > extreme; }
  [[nodiscard]] bool is_half() const {
    return turned_back() && std::max(begin, end) <= kBack * amplitude;
  }
  [[nodiscard]] bool is_resolved() const {
    return extreme - before >= kFewestRows && after - extreme >= kFewestRows;
  }
};

std::vector<Excursion> excursions_of(const Curve& curve) {
  const std::vector<std::size_t> turns = turns_of(curve);
  const double turn = turn_of(curve);
  std::vector<Excursion> all;
  for (std::size_t k = 1; k < turns.size(); ++k) {
    Excursion e;
    e.before = turns[k - 1], e.extreme = turns[k];
    e.after = k + 1 < turns.size() ? turns[k + 1] : turns[k];
    e.sense = curve[e.extreme].displacement < 0 ? -1 : 1;
    const auto along = [&](std::size_t i) { return e.sense * curve[i].displacement; };
    e.amplitude = along(e.extreme);
    e.begin = std::max(0.0, along(e.before));
    e.end = std::max(0.0, along(e.after));
    if (e.amplitude - e.begin > turn) all.push_back(e);
  }
  return all;
}

// Largest force in a sense, in the rows on the excursion's own side of zero.
double largest_force(const Curve& curve, const Excursion& e, int sense) {
  double largest = 0;
  for (std::size_t i = e.before + 1; i <= e.after; ++i)
    if (e.sense * curve[i].displacement > 0) largest = std::max(largest, sense * curve[i].reaction);
  return largest;
}

// That force, and whether a row in balance reached it within kBalance. If not, it may be a rebound.
struct Force {
  double value = 0;
  bool in_balance = true;
};
Force force_of(const Curve& curve, const Excursion& e, int sense) {
  Curve own(1);
  for (std::size_t i = e.before + 1; i <= e.after; ++i)
    if (e.sense * curve[i].displacement > 0) own.push_back(curve[i]);
  const double any = largest_force(curve, e, sense);
  const auto row = largest_in_balance(own, sense);
  const double balanced = row ? sense * own[*row].reaction : 0;
  if (any <= (1 + kBalance) * balanced) return {balanced, true};
  return {any, any == 0};
}

// Displacement at which the force first falls to zero on the way back, interpolated between middles of windows.
double residual_of(const Curve& curve, const Excursion& e) {
  const auto middle = [&](std::size_t i) {
    return 0.5 * (curve[i].displacement + curve[i - 1].displacement);
  };
  for (std::size_t i = e.extreme + 1; i <= e.after; ++i) {
    const double force = e.sense * curve[i].reaction;
    if (force > 0) continue;
    if (i == e.extreme + 1) return curve[e.extreme].displacement;
    const double before = e.sense * curve[i - 1].reaction;
    return middle(i - 1) + before / (before - force) * (middle(i) - middle(i - 1));
  }
  return kNone;
}

// Work of `force` along the excursion, without the part below the displacement to which it came back.
template <class Force>
double loop_work(const Curve& curve, const Excursion& e, const Force& force) {
  const double level = std::max(e.begin, e.end);
  const auto beyond = [&](std::size_t i) {
    return std::max(level, e.sense * curve[i].displacement);
  };
  double work = 0;
  for (std::size_t i = e.before + 1; i <= e.after; ++i)
    work += e.sense * force(curve[i]) * (beyond(i) - beyond(i - 1));
  return work;
}

Cycle cycle_of(const Curve& curve, const Excursion& e) {
  Cycle c;
  c.displacement_max = c.displacement_min = c.reaction_max = c.reaction_min = kNone;
  c.residual_max = c.residual_min = c.dissipated = c.drag = c.damping_ratio = kNone;
  c.kind = e.is_half() ? "half" : e.turned_back() ? "partial" : "unfinished";
  const bool up = e.sense > 0;
  const auto [force, in_balance] = force_of(curve, e, e.sense);
  c.in_balance = in_balance;
  (up ? c.displacement_max : c.displacement_min) = curve[e.extreme].displacement;
  (up ? c.reaction_max : c.reaction_min) = e.sense * force;
  (up ? c.residual_max : c.residual_min) = residual_of(curve, e);
  c.stiffness = force / e.amplitude;
  if (!e.turned_back()) return c;
  c.dissipated = loop_work(curve, e, [](const CurveRow& r) { return r.reaction; });
  c.drag = loop_work(curve, e, [](const CurveRow& r) { return r.reaction - r.base_shear; });
  // The box around all its rows limits xi to 2 / pi.
  const double either = std::max(largest_force(curve, e, 1), largest_force(curve, e, -1));
  if (e.is_half() && e.is_resolved() && either > 0)
    c.damping_ratio = c.dissipated / (std::numbers::pi * either * e.amplitude);
  return c;
}

// Joins two half cycles to one loop. E_so is the larger of two areas: the mean of F d / 2 of
// both directions, and the triangle under the diagonal of the loop's box,
// (F+ - F-) (d+ - d-) / 8. Both are equal where the directions are alike. So xi approaches that
// of a half cycle where one direction is small. No loop exceeds 2 / pi, the value of a slider.
Cycle joined(const Curve& curve, const Excursion& first, const Excursion& second) {
  const Excursion &up = first.sense > 0 ? first : second, &down = &up == &first ? second : first;
  Cycle c = cycle_of(curve, up);
  const Cycle other = cycle_of(curve, down);
  c.kind = "full";
  c.displacement_min = other.displacement_min;
  c.residual_min = other.residual_min;
  c.reaction_max = std::max(c.reaction_max, force_of(curve, down, 1).value);
  c.reaction_min = -std::max(-other.reaction_min, force_of(curve, up, -1).value);
  c.in_balance = c.in_balance && other.in_balance;
  c.dissipated += other.dissipated;
  c.drag += other.drag;
  const double path = c.displacement_max - c.displacement_min;
  c.stiffness = (c.reaction_max - c.reaction_min) / path;
  const double plus = std::max(largest_force(curve, up, 1), largest_force(curve, down, 1));
  const double minus = std::max(largest_force(curve, up, -1), largest_force(curve, down, -1));
  const double mean = (plus * c.displacement_max - minus * c.displacement_min) / 4;
  const double strain = std::max(mean, (plus + minus) * path / 8);
  const bool resolved = up.is_resolved() && down.is_resolved();
  c.damping_ratio = resolved && strain > 0 ? c.dissipated / (4 * std::numbers::pi * strain) : kNone;
  return c;
}

double or_zero(double value) { return std::isnan(value) ? 0 : value; }

bool is_same(double a, double b) {
  return std::isnan(a) ? std::isnan(b) : std::fabs(a - b) <= kSame * std::fabs(b);
}

double forces_of(const Cycle& c) { return or_zero(c.reaction_max) - or_zero(c.reaction_min); }

void count_repeats(std::vector<Cycle>& cycles) {
  for (std::size_t k = 0; k < cycles.size(); ++k) {
    const Cycle* first = nullptr;
    for (std::size_t j = 0; j < k; ++j) {
      if (!is_same(cycles[j].displacement_max, cycles[k].displacement_max) ||
          !is_same(cycles[j].displacement_min, cycles[k].displacement_min))
        continue;
      if (first == nullptr) first = &cycles[j];
      ++cycles[k].repeat;
    }
    if (first != nullptr && forces_of(*first) > 0)
      cycles[k].kept = first->in_balance && cycles[k].in_balance
                           ? forces_of(cycles[k]) / forces_of(*first)
                           : kNone;
  }
}

std::vector<Cycle> cycles_of(const Curve& curve) {
  const std::vector<Excursion> all = excursions_of(curve);
  std::vector<Cycle> cycles;
  for (std::size_t k = 0; k < all.size(); ++k) {
    const bool pairs = k + 1 < all.size() && all[k].is_half() && all[k + 1].is_half() &&
                       all[k].sense != all[k + 1].sense;
    cycles.push_back(pairs ? joined(curve, all[k], all[k + 1]) : cycle_of(curve, all[k]));
    if (pairs) ++k;
  }
  count_repeats(cycles);
  return cycles;
}

// --- directions

DirectionReadings direction_of(const Responses& r, const Curve& envelope) {
  DirectionReadings d{.peak_reaction = r.peak_reaction,
                      .displacement_at_peak = r.displacement_at_peak,
                      .displacement_at_80 = r.displacement_at_80,
                      .first_fall_80 = r.first_fall_80,
                      .last_fall_80 = r.last_fall_80,
                      .censored_80 = r.censored_80,
                      .censored_first_80 = r.censored_first_80,
                      .censored_last_80 = r.censored_last_80,
                      .displacement_max = r.displacement_max,
                      .censored_max = r.censored_max,
                      .initial_stiffness = r.initial_stiffness,
                      .drift_capacity = r.drift_capacity,
                      .dips = r.dips,
                      .bilinear = r.bilinear};
  for (const CurveRow& row : envelope) d.backbone.push_back({row.displacement, row.reaction});
  return d;
}

// Responses of both envelopes. Only the side on which the wall collapsed has reached its end.
struct BothWays {
  Curve along, against;
  Responses forth, back;
  bool collapsed_along = false;
  int sense = 1;
};

// Responses of one direction. `rise`, finer than rows, is used for the first direction if it reaches most of the peak.
Responses evaluate_side(const Curve& envelope, ResponseOptions options, bool is_first) {
  constexpr double kMost = 0.6;   // the bilinear curve's secant needs 0.6 of the peak
  constexpr double kBegin = 0.1;  // the stiffness needs the curve from 0.1 of the peak
  const std::vector<RisePoint> rise = std::exchange(options.rise, {});
  Responses by_rows = evaluate_one_way(envelope, options);
  const bool reaches = std::any_of(rise.begin(), rise.end(), [&](const RisePoint& point) {
    return point.force >= kMost * by_rows.peak_reaction;
  });
  if (is_first && reaches) {
    options.rise = rise;
    return evaluate_one_way(envelope, options);
  }
  // A wall that comes back from the other side may pass zero under force. Then it has no rise from zero.
  const double begins = envelope.size() > 1 ? envelope[1].reaction / by_rows.peak_reaction : 0;
  if (!is_first && begins > kBegin) by_rows.initial_stiffness = kNone;
  if (!is_first && begins > kMost)
    by_rows.bilinear = {kNone, kNone, kNone, kNone, kNone, by_rows.censored_80};
  return by_rows;
}

BothWays evaluate_both(const Curve& curve, const ResponseOptions& options) {
  BothWays b;
  b.along = envelope_of(curve, 1);
  b.against = envelope_of(curve, -1);
  b.collapsed_along = curve.back().displacement >= 0;
  const bool first_along = curve[turns_of(curve)[1]].displacement >= 0;
  ResponseOptions standing = options;
  standing.collapse = {};
  b.forth = evaluate_side(b.along, b.collapsed_along ? options : standing, first_along);
  b.back = evaluate_side(b.against, b.collapsed_along ? standing : options, !first_along);
  // A direction whose strength is not known counts with its largest row.
  // If that row is the larger one, the strength of the wall is not known.
  const auto strength = [](const Responses& r) {
    return std::isnan(r.peak_reaction) ? r.peak_raw : r.peak_reaction;
  };
  b.sense = strength(b.back) > strength(b.forth) ? -1 : 1;
  return b;
}

}  // namespace

bool is_cyclic(const Curve& curve) {
  if (curve.size() < 2) return false;
  const bool by_factor = std::any_of(curve.begin(), curve.end(),
                                     [](const CurveRow& row) { return row.load_factor != 0; });
  if (by_factor) return false;
  const std::vector<std::size_t> turns = turns_of(curve);
  return turns.size() > 2 || (turns.size() == 2 && curve[turns[1]].displacement < 0);
}

Curve envelope_of(const Curve& curve, int sense) {
  Curve envelope = {mirrored(curve.front(), sense)};
  double record = std::max(0.0, envelope.front().displacement);
  for (std::size_t i = 1; i < curve.size();) {
    // one excursion beyond the farthest displacement so far
    Curve rows;
    for (; i < curve.size() && sense * curve[i].displacement > record; ++i) {
      rows.push_back(mirrored(curve[i], sense));
      record = rows.back().displacement;
    }
    if (rows.empty()) {
      ++i;
      continue;
    }
    const double held = envelope.back().reaction;
    auto from = rows.begin();
    if (envelope.size() > 1) {
      from = std::find_if(rows.begin(), rows.end(),
                          [&](const CurveRow& row) { return row.reaction >= held; });
      if (from == rows.end())
        from = std::max_element(rows.begin(), rows.end(), [](const CurveRow& a, const CurveRow& b) {
          return a.reaction < b.reaction;
        });
    }
    envelope.insert(envelope.end(), from, rows.end());
  }
  return envelope;
}

Responses evaluate_cyclic(const Curve& curve, const ResponseOptions& options) {
  const BothWays both = evaluate_both(curve, options);
  Responses r = both.sense > 0 ? both.forth : both.back;
  r.cyclic.sense = both.sense;
  r.cyclic.positive = direction_of(both.forth, both.along);
  r.cyclic.negative = direction_of(both.back, both.against);
  r.cyclic.cycles = cycles_of(curve);
  for (std::size_t i = 1; i < curve.size(); ++i)
    r.cyclic.work += curve[i].reaction * (curve[i].displacement - curve[i - 1].displacement);
  // A collapsed wall is lost in both directions, whichever side it fell to.
  if (!options.collapse.empty())
    r.collapse = (both.collapsed_along ? both.forth : both.back).collapse;
  return r;
}

}  // namespace wythe::dynamics

namespace wythe {

std::vector<CurveRow> backbone_of(const std::vector<CurveRow>& curve) {
  if (!dynamics::is_cyclic(curve)) return curve;
  const dynamics::BothWays both = dynamics::evaluate_both(curve, {});
  return both.sense > 0 ? both.along : both.against;
}

}  // namespace wythe
