// A row is in balance if a stretch of rows around it is (4.11a). Reaction and base shear
// that vibrate against each other would be equal twice in a period. The rate is judged at
// the largest force in balance (4.12), for driven supports in the worst fifth of the path
// (4.12a). A NaN stays a NaN and never passes. A ledger that does not close gives "unknown".
#include "dynamics/meters/balance.h"

#include <algorithm>
#include <cmath>

namespace wythe {
namespace dynamics {
namespace {

using Curve = std::vector<CurveRow>;

constexpr std::size_t kFewestRows = 3;  // the first is zero, and a row needs one beside it
constexpr const char* kTooFewRows = "balance.too_few_rows";

}  // namespace

Stretch stretch_around(const Curve& curve, std::size_t row) {
  const double at = curve[row].displacement, half = 0.5 * kBalanceOver * std::fabs(at);
  const auto near = [&](std::size_t i) { return std::fabs(curve[i].displacement - at) <= half; };
  Stretch s{row, row};
  while (s.first > 1 && near(s.first - 1)) --s.first;
  while (s.last + 1 < curve.size() && near(s.last + 1)) ++s.last;
  if (s.first == row && row > 1) --s.first;
  if (s.last == row && row + 1 < curve.size()) ++s.last;
  return s;
}

double passed_on(const CurveRow& row) { return std::min(row.reaction, row.base_shear); }

std::optional<std::size_t> largest_in_balance(const Curve& curve, double sense) {
  std::optional<std::size_t> best;
  for (std::size_t i = 1; i < curve.size(); ++i) {
    const double force = sense * curve[i].reaction;
    if (force > 0 && (!best || force > sense * curve[*best].reaction) && is_in_balance(curve, i))
      best = i;
  }
  return best;
}

double force_beyond(const Curve& curve, double peak) {
  double most = peak;
  for (const CurveRow& row : curve) most = std::max(most, passed_on(row));
  return most / peak - 1;
}

// The limit is half of the wall's own force: there the stiffness that was read grew by 18 % with the velocity.
bool outruns(const Curve& curve, double peak) {
  for (std::size_t i = 1; i < curve.size(); ++i) {
    if (std::fabs(curve[i].reaction - curve[i].base_shear) > kOutrun * peak) return true;
    if (0.5 * std::fabs(curve[i].reaction + curve[i].base_shear) >= 2 * kOutrun * peak) break;
  }
  return false;
}

Message why_out_of_balance(const Curve& curve) {
  double reaction = 0, passed = 0;
  for (const CurveRow& row : curve) {
    reaction = std::max(reaction, row.reaction);
    passed = std::max(passed, passed_on(row));
  }
  if (!(reaction > 0)) return {"balance.nothing_resisted"};
  if (curve.size() < kFewestRows) return {kTooFewRows};
  const auto balanced = largest_in_balance(curve);
  Message why{balanced ? "balance.at_first_only" : "balance.never",
              {{"limit_percent", 100 * kBalance},
               {"reaction_kN", 1e-3 * reaction},
               {"passed_kN", 1e-3 * passed}}};
  if (balanced) why.arguments.emplace_back("balanced_kN", 1e-3 * curve[*balanced].reaction);
  return why;
}

namespace {

// Limits of the verdict; docs/theory/integration.md says where each comes from.
constexpr double kScatter = 0.02;  // two runs that differ by rounding alone differ by up to this
constexpr double kLift = 2.0;      // of the drag at the peak: what it adds to the force, at most
constexpr double kSlow = 0.04;     // lift up to which a push is slow enough: a drag of 1 %
constexpr double kUsable = 0.08;   // up to which it is usable: a drag of 3 %
constexpr double kKinetic = 0.05;  // kinetic energy / work of the drive, at the peak
constexpr double kLedger = 0.01;   // energy that the ledger misses
constexpr double kSpent =
    1e-3;  // of the drive's work, to break and crush: what a jolt can take from the wall
constexpr double kApproach = 0.8;  // of the displacement at the peak: where the way to it begins

// The larger of two numbers, NaN where either is NaN.
// Comparisons with NaN are false, so std::max could drop it.
double larger(double a, double b) { return std::isnan(a) || a > b ? a : b; }

// Median; NaN where any value is NaN, because NaN has no place in the order.
double median(std::vector<double> of) {
  if (of.empty()) return 0;
  if (std::any_of(of.begin(), of.end(), [](double x) { return std::isnan(x); })) return kUnset;
  const auto middle = of.begin() + static_cast<std::ptrdiff_t>(of.size() / 2);
  std::nth_element(of.begin(), middle, of.end());
  return *middle;
}

// Share of the drive's work that damping takes: the median over the rows from 80 to 100 % of the displacement
// at the peak. A crack that snaps there releases energy at any rate, but fills only a row or two.
double damping_on_the_way(const Curve& curve, std::size_t peak) {
  std::vector<double> share;
  for (std::size_t i = peak; i >= 1; --i) {
    const bool near = curve[i].displacement >= kApproach * curve[peak].displacement;
    if (!near && share.size() >= 3) break;
    const double drive = curve[i].work_drive - curve[i - 1].work_drive;
    if (!(drive <= 0)) share.push_back((curve[i].work_damping - curve[i - 1].work_damping) / drive);
  }
  return share.empty() ? kUnset : median(std::move(share));
}

void evaluate_meters(const Curve& curve, std::size_t peak, RateVerdict& q) {
  const Stretch s = stretch_around(curve, peak);
  double gap = 0;
  for (std::size_t i = s.first; i <= s.last; ++i) {
    gap += curve[i].reaction - curve[i].base_shear;
    q.unbalance_ratio_mean += curve[i].unbalance_ratio;
    q.kinetic_ratio_mean += curve[i].kinetic_ratio;
    q.unbalance_ratio_max = larger(q.unbalance_ratio_max, curve[i].unbalance_ratio);
    q.kinetic_ratio_max = larger(q.kinetic_ratio_max, curve[i].kinetic_ratio);
  }
  const double count = static_cast<double>(s.last - s.first + 1);
  q.unbalance_ratio_mean /= count;
  q.kinetic_ratio_mean /= count;
  q.shear_gap = std::fabs(gap) / count / curve[peak].reaction;
  q.damping_share = damping_on_the_way(curve, peak);
}

Message share(const char* code, double share) { return {code, {{"share_percent", 100 * share}}}; }

Message veto_of(const RateVerdict& q) {
  if (q.kinetic_ratio_mean > kKinetic) return share("meter.motion", q.kinetic_ratio_mean);
  if (q.unbalance_ratio_mean > kUnbalance) return share("meter.unbalance", q.unbalance_ratio_mean);
  return {};
}

Message reason_of(const RateVerdict& q) {
  const double drag = larger(q.shear_gap, q.damping_share);
  if (q.beyond > kLift * drag) return share("meter.beyond", q.beyond);
  if (q.shear_gap >= q.damping_share) return share("meter.shear_gap", q.shear_gap);
  return share("meter.damping", q.damping_share);
}

// A curve or meters with NaN or infinity get no verdict.
bool is_finite(const CurveRow& row) {
  for (const double value :
       {row.time, row.displacement, row.reaction, row.base_shear, row.unbalance_ratio,
        row.kinetic_ratio, row.work_drive, row.work_damping})
    if (!std::isfinite(value)) return false;
  return true;
}

RateVerdict not_known(const char* why) {
  RateVerdict q;
  q.judgement = "unknown";
  q.verdict = {"rate.unknown", {{"why", Message{why}}}};
  q.lift = q.shear_gap = q.damping_share = q.beyond = kUnset;
  q.unbalance_ratio_mean = q.unbalance_ratio_max = kUnset;
  q.kinetic_ratio_mean = q.kinetic_ratio_max = kUnset;
  return q;
}

// Sets judgement and verdict text from the meters.
void judge(RateVerdict& q) {
  const double drag = larger(q.shear_gap, q.damping_share);
  q.lift = kScatter + larger(kLift * drag, q.beyond);
  const Message veto = veto_of(q);
  const double lift = 100 * q.lift;
  if (std::isnan(q.lift) || q.lift > kKnown) {
    q.judgement = "too fast";
    q.verdict = {"rate.far_too_fast", {{"why", reason_of(q)}}};
    q.lift = kUnset;
  } else if (!veto.empty() || q.lift > kUsable) {
    q.judgement = "too fast";
    q.verdict = {"rate.too_fast",
                 {{"lift_percent", lift}, {"why", veto.empty() ? reason_of(q) : veto}}};
  } else if (q.lift > kSlow) {
    q.judgement = "usable";
    q.verdict = {"rate.usable", {{"lift_percent", lift}, {"why", reason_of(q)}}};
  } else {
    q.judgement = "slow enough";
    q.verdict = {"rate.slow_enough", {{"lift_percent", lift}}};
  }
}

bool is_finite(const EnergyLedger& e) {
  for (const double entry : {e.loads, e.drive, e.kinetic, e.elastic, e.friction, e.fracture,
                             e.crushing, e.damping, e.hand_over, e.gap, e.gap_ratio})
    if (!std::isfinite(entry)) return false;
  return true;
}

// True where all entries are finite and the gap of the ledger is small.
bool is_balanced(const EnergyLedger& e) { return is_finite(e) && e.gap_ratio <= kLedger; }

// The message for a ledger that is not balanced; `code` is used where the gap is a number.
Message energy_missing(const EnergyLedger& e, const char* code = "rate.energy_missing") {
  if (!is_finite(e)) return {"rate.unknown", {{"why", Message{"balance.no_number"}}}};
  return {code, {{"gap_percent", 100 * e.gap_ratio}}};
}

RateVerdict of_a_load(const Result& result) {
  RateVerdict q;
  if (std::isnan(result.responses.peak_reaction)) return q;
  q.judgement = "slow enough";
  q.verdict = {"rate.load"};
  return q;
}

// Driven supports, judged over the worst fifth of their path. In balance their force equals that
// of the other supports, in either direction. The force of a slow drive lies between both, so
// the gap counts once. A snap fills only a row or two of a fifth, and the median ignores them.
RateVerdict of_supports(const Curve& curve) {
  constexpr int kParts = 5;
  RateVerdict q;
  double largest = 0;  // force that both sides feel: a jolt at the start is felt by one side alone
  for (const CurveRow& row : curve)
    if (row.reaction * row.base_shear > 0)
      largest = std::max(largest, std::min(std::fabs(row.reaction), std::fabs(row.base_shear)));
  double way = 0;
  for (const CurveRow& row : curve) way = std::max(way, std::fabs(row.displacement));
  for (int part = 0; part < kParts; ++part) {
    std::vector<double> gap, damping, unbalance, kinetic;
    for (std::size_t i = 1; i < curve.size(); ++i) {
      const double at = std::fabs(curve[i].displacement) / way * kParts;
      if (at <= part || at > part + 1) continue;
      const double moved = std::fabs(curve[i].displacement - curve[i - 1].displacement);
      gap.push_back(std::fabs(curve[i].reaction - curve[i].base_shear) / largest);
      if (moved > 0)
        damping.push_back((curve[i].work_damping - curve[i - 1].work_damping) / (moved * largest));
      unbalance.push_back(curve[i].unbalance_ratio);
      kinetic.push_back(curve[i].kinetic_ratio);
    }
    const auto worst = [](double& most, double now) { most = larger(most, now); };
    worst(q.shear_gap, median(gap));
    worst(q.damping_share, median(damping));
    worst(q.unbalance_ratio_mean, median(unbalance));
    if (part > 0) worst(q.kinetic_ratio_mean, median(kinetic));  // the start sets it in motion
    for (const double u : unbalance) worst(q.unbalance_ratio_max, u);
    for (const double k : kinetic) worst(q.kinetic_ratio_max, k);
  }
  const double drag = larger(q.shear_gap, q.damping_share);
  q.lift = kScatter + drag;
  const Message why =
      q.kinetic_ratio_mean > kKinetic ? share("meter.supports_motion", q.kinetic_ratio_mean)
      : q.unbalance_ratio_mean > kUnbalance
          ? share("meter.supports_unbalance", q.unbalance_ratio_mean)
      : q.shear_gap >= q.damping_share ? share("meter.supports_gap", q.shear_gap)
                                       : share("meter.supports_damping", q.damping_share);
  const bool vetoed = q.kinetic_ratio_mean > kKinetic || q.unbalance_ratio_mean > kUnbalance;
  const double lift = 100 * q.lift;
  if (!(largest > 0) || !(q.lift <= kKnown)) {
    q.judgement = "too fast";
    q.verdict = {"rate.supports_far_too_fast"};
    q.lift = kUnset;
  } else if (vetoed || q.lift > kUsable) {
    q.judgement = "too fast";
    q.verdict = {"rate.supports_too_fast", {{"lift_percent", lift}, {"why", why}}};
  } else if (q.lift > kSlow) {
    q.judgement = "usable";
    q.verdict = {"rate.supports_usable", {{"lift_percent", lift}, {"why", why}}};
  } else {
    q.judgement = "slow enough";
    q.verdict = {"rate.supports_slow_enough", {{"lift_percent", lift}}};
  }
  return q;
}

// The stricter of two verdicts.
const RateVerdict& worse(const RateVerdict& a, const RateVerdict& b) {
  const auto rank = [](const RateVerdict& q) {
    return q.judgement == "slow enough" ? 0 : q.judgement == "usable" ? 1 : 2;
  };
  if (rank(a) != rank(b)) return rank(a) > rank(b) ? a : b;
  return !(a.lift < b.lift) ? a : b;
}

// A jolt at the start breaks bond that a slow push would keep, and the calm curve after it does not show this.
// In a wall of dry joints nothing breaks, so the force is right all the same; but the push was not slow.
void judge_outrun(const EnergyLedger& energy, double work, RateVerdict& q) {
  const Message outran = share("meter.outran", kOutrun);
  if (energy.fracture + energy.crushing > kSpent * work) {
    q.judgement = "too fast";
    q.verdict = {"rate.far_too_fast", {{"why", outran}}};
    q.lift = kUnset;
  } else if (q.judgement == "slow enough") {
    q.judgement = "usable";
    q.verdict = {"rate.usable", {{"lift_percent", 100 * q.lift}, {"why", outran}}};
  }
}

// Judges a push at its largest force in balance.
RateVerdict of_a_push(const Curve& curve, const EnergyLedger& energy) {
  RateVerdict q;
  const auto peak = largest_in_balance(curve);
  if (peak && force_beyond(curve, curve[*peak].reaction) <= kKnown) {
    evaluate_meters(curve, *peak, q);
    q.beyond = force_beyond(curve, curve[*peak].reaction);
    judge(q);
    if (outruns(curve, curve[*peak].reaction)) judge_outrun(energy, curve.back().work_drive, q);
    return q;
  }
  q.unbalance_ratio_mean = q.unbalance_ratio_max = q.kinetic_ratio_mean = q.kinetic_ratio_max =
      kUnset;
  q.shear_gap = q.damping_share = q.beyond = q.lift = kUnset;
  q.judgement = "too fast";
  q.verdict = {"rate.no_balance", {{"why", why_out_of_balance(curve)}}};
  return q;
}

}  // namespace

RateVerdict judge_quasi_static(const Result& result, bool supports) {
  const Curve curve = is_load_controlled(result) ? result.curve : backbone_of(result.curve);
  RateVerdict q;
  q.verdict = {"rate.no_push"};
  if (result.shaking.was_shaken && result.curve.empty())
    q.verdict = {"rate.shaken", {{"gap_percent", 100 * result.energy.gap_ratio}}};
  if (!std::all_of(curve.begin(), curve.end(),
                   [](const CurveRow& row) { return is_finite(row); })) {
    q = not_known("balance.no_number");
  } else if (is_load_controlled(result)) {
    q = of_a_load(result);
  } else if (curve.size() > 1 && curve.size() < kFewestRows) {
    q = not_known(kTooFewRows);
  } else if (curve.size() >= kFewestRows && supports) {
    q = of_supports(curve);
    if (largest_in_balance(curve))
      q = worse(q, of_a_push(curve, result.energy));  // its capacity is read from the curve
  } else if (curve.size() >= kFewestRows) {
    q = of_a_push(curve, result.energy);
  }
  if (!is_balanced(result.energy) && q.judgement != "no push") {
    q.judgement = "unknown";
    q.verdict = energy_missing(result.energy);
  }
  return q;
}

}  // namespace dynamics

Message warning_of(const Result& result) {
  if (result.curve_of == StageKind::kPush && result.load_factor > 0)
    return {"doubt.held_factor", {{"factor", result.load_factor}}};
  const RateVerdict& q = result.quasi_static;
  // the verdict of a usable push says how far its force may be off, so it needs no warning
  if (q.judgement != "slow enough" && q.judgement != "usable" && q.judgement != "no push")
    return q.verdict;
  if (!dynamics::is_balanced(result.energy)) {
    if (result.shaking.was_shaken && result.curve.empty())
      return dynamics::energy_missing(result.energy, "shake.energy_missing");
    return dynamics::energy_missing(result.energy);
  }
  if (result.validity.overlap_lost <= result.responses.displacement_at_peak)
    return {"doubt.slid_off", {{"displacement_mm", 1e3 * result.validity.overlap_lost}}};
  return {};
}

bool is_in_balance(const std::vector<CurveRow>& curve, std::size_t row) {
  if (row < 1 || row >= curve.size() || curve.size() < dynamics::kFewestRows) return false;
  const double allowed = dynamics::kBalance * std::fabs(curve[row].reaction);
  const dynamics::Stretch s = dynamics::stretch_around(curve, row);
  for (std::size_t i = s.first; i <= s.last; ++i)
    if (!(std::fabs(curve[i].reaction - curve[i].base_shear) <= allowed)) return false;
  return true;
}

}  // namespace wythe
