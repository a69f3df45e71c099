// Virtual work of a strip that falls on its face: the onset, the equivalent system, and where it falls by itself.
//
//   alpha(theta) sum Q u'(theta) = sum P v'(theta) + sum T u'(theta)      u along the earthquake, v upwards
//
// Equations (21.1) to (21.8) of docs/theory/local_mechanisms.md. Called by parts.cpp and of_limit.cpp.
#include <algorithm>
#include <cmath>

#include "wythe/parts/local_check.h"

namespace wythe {
namespace {

constexpr double kHalfTurn = 3.14159265358979323846;
constexpr double kQuarter = 0.5 * kHalfTurn;
constexpr double kHalf = 0.5;  // of the capacity: what breaks with more ends life safety

// (21.3): M* and e* by what is pushed, at rest. Gives sum Q travel^2 / sum Q travel, the travel of the equivalent system.
double equivalent(double first, double second, double gravity, LocalCapacity& c) {
  c.mass = first * first / (gravity * second);
  c.mass_share = gravity * c.mass / c.pushed;
  return second / first;
}

}  // namespace

std::vector<LocalCapacity> overturning(const std::vector<LocalWeight>& weights,
                                       const std::vector<LocalHold>& holds, double resisted,
                                       double top, double gravity) {
  LocalCapacity c;
  double first = 0, second = 0, rise = 0, drop = 0;
  for (const LocalWeight& w : weights) {
    c.weight += w.weight, c.pushed += w.pushed;
    first += w.pushed * w.travel, second += w.pushed * w.travel * w.travel;
    rise += w.weight * w.rise, drop += w.weight * w.drop;
  }
  if (!(first > 0)) {
    c.no_displacement = {"local.nothing_pushed"};
    return {c};
  }
  const double travel = equivalent(first, second, gravity, c);
  double held = 0;
  for (const LocalHold& hold : holds) held += hold.force * hold.travel;
  c.alpha0 = (rise + held + resisted) / first;  // (21.1)
  for (const LocalWeight& w : weights)
    if (w.travel > 0) c.slides_off = std::min(c.slides_off, w.slides_off / w.travel * travel);

  std::vector<LocalHold> known;  // by the rotation at which they let go
  for (const LocalHold& hold : holds)
    if (std::isfinite(hold.lets_go) && hold.travel > 0) known.push_back(hold);
  std::stable_sort(known.begin(), known.end(), [](const LocalHold& a, const LocalHold& b) {
    return a.lets_go * b.travel < b.lets_go * a.travel;
  });
  const auto way_of = [&](const LocalHold& hold) { return hold.lets_go / hold.travel * travel; };
  double resistance = rise;
  for (const LocalHold& hold : known) resistance += hold.force * hold.travel;

  std::vector<LocalCapacity> curves;
  double lost = 0, left_out = kUnset, lets_go = std::numeric_limits<double>::infinity();
  for (std::size_t gone = 0; gone <= known.size(); ++gone) {
    if (gone > 0) {
      const LocalHold& hold = known[gone - 1];
      const double turn = std::asin(std::min(1.0, hold.lets_go / hold.travel));
      lost += hold.force * (hold.travel + hold.rise * std::tan(turn));
      if (lost > kHalf * resistance) lets_go = std::min(lets_go, way_of(hold));
    }
    LocalCapacity curve = c;
    double a = rise, b = drop;  // a cos - b sin
    for (std::size_t k = gone; k < known.size(); ++k)
      a += known[k].force * known[k].travel, b -= known[k].force * known[k].rise;
    if (gone > 0 && !(a > 0)) break;  // without this one it falls by itself
    curve.alpha0_to_end = a / first;
    curve.rotation0 = a > 0 ? std::atan2(a, b) : 0;  // (21.4)
    curve.lets_go = lets_go;
    curve.without_holds_from = left_out;
    if (gone < known.size() &&
        known[gone].lets_go < known[gone].travel * std::sin(std::min(curve.rotation0, kQuarter))) {
      curve.ends_with_hold = true;
      left_out = std::isnan(left_out) ? way_of(known[gone]) : left_out;  // of the next curves
      curve.rotation0 = std::asin(known[gone].lets_go / known[gone].travel);
    }
    if (curve.rotation0 >= kQuarter) {
      curve.rotation0 = kUnset;
      curve.no_displacement = {"local.held_for_good"};
    } else {
      curve.displacement0 = travel * std::sin(curve.rotation0);  // (21.5)
      curve.top0 = top * std::sin(curve.rotation0);
    }
    curves.push_back(curve);
  }
  return curves;
}

namespace {

// A bent strip at a turn of its lower body.
class Bent {
 public:
  Bent(const BentStrip& s, double hinge)
      : s_(s),
        hinge_(hinge),
        arm_(s.at_hinge - 2 * s.inset),  // of the upper line behind the lower one
        ahead_(s.at_hinge - s.inset - 0.5 * s.at_head),
        above_(s.height - hinge) {}

  struct Rates {
    double u = 0, v = 0;
  };
  // Rates of the line between the bodies.
  [[nodiscard]] Rates line(double turn) const {
    return {hinge_ * std::cos(turn) + arm_ * std::sin(turn),
            arm_ * std::cos(turn) - hinge_ * std::sin(turn)};
  }
  [[nodiscard]] double line_travel(double turn) const {
    return hinge_ * std::sin(turn) + arm_ * (1 - std::cos(turn));
  }
  // The head cannot move sideways: travel of the line + ahead (cos psi - 1) - above sin psi = 0.
  [[nodiscard]] double upper_turn(double turn) const {
    const double reach = std::hypot(ahead_, above_);
    const double wanted = (ahead_ - line_travel(turn)) / reach;
    return std::fabs(wanted) > 1 ? kUnset : std::acos(wanted) - std::atan2(above_, ahead_);
  }
  [[nodiscard]] Rates lower(const BentStrip::Weight& w, double turn) const {
    const double x = w.behind - s_.inset, z = w.height;
    return {z * std::cos(turn) + x * std::sin(turn), x * std::cos(turn) - z * std::sin(turn)};
  }
  [[nodiscard]] Rates upper(const BentStrip::Weight& w, double turn) const {
    const double psi = upper_turn(turn), c = std::cos(psi), s = std::sin(psi);
    const Rates at = line(turn);
    const double rate = at.u / (ahead_ * s + above_ * c);  // of psi
    const double x = s_.at_hinge - s_.inset - w.behind, z = w.height - hinge_;
    return {at.u - rate * (x * s + z * c), at.v + rate * (x * c - z * s)};
  }
  // How far weights have gone along the earthquake.
  [[nodiscard]] double lower_travel(const BentStrip::Weight& w, double turn) const {
    return w.height * std::sin(turn) + (w.behind - s_.inset) * (1 - std::cos(turn));
  }
  [[nodiscard]] double upper_travel(const BentStrip::Weight& w, double turn) const {
    const double psi = upper_turn(turn);
    const double x = s_.at_hinge - s_.inset - w.behind, z = w.height - hinge_;
    return line_travel(turn) - x * (1 - std::cos(psi)) - z * std::sin(psi);
  }
  // Whether a floor has moved by its bearing.
  [[nodiscard]] bool is_off(double turn) const {
    bool is = false;
    for (const auto& w : s_.lower) is |= lower_travel(w, turn) >= w.slides_off;
    for (const auto& w : s_.upper) is |= upper_travel(w, turn) >= w.slides_off;
    return is;
  }
  // Work of the weights per turn: what is still needed to bend it on.
  [[nodiscard]] double needed(double turn) const {
    double sum = 0;
    for (const auto& w : s_.lower) sum += w.weight * lower(w, turn).v;
    for (const auto& w : s_.upper) sum += w.weight * upper(w, turn).v;
    return sum;
  }

 private:
  const BentStrip& s_;
  double hinge_, arm_, ahead_, above_;
};

}  // namespace

LocalCapacity bending(const BentStrip& strip, double hinge, double gravity) {
  const Bent bent(strip, hinge);
  LocalCapacity c;
  double first = 0, second = 0;
  const auto add = [&](const BentStrip::Weight& w, double travel) {
    c.weight += w.weight, c.pushed += w.pushed;
    first += w.pushed * travel, second += w.pushed * travel * travel;
  };
  for (const auto& w : strip.lower) add(w, bent.lower(w, 0).u);
  for (const auto& w : strip.upper) add(w, bent.upper(w, 0).u);
  if (!(first > 0)) {
    c.no_displacement = {"local.nothing_pushed"};
    return c;
  }
  const double travel = equivalent(first, second, gravity, c);
  c.alpha0 = c.alpha0_to_end = bent.needed(0) / first;
  // the first turn at which nothing more is needed: march, then halve
  constexpr double kMarch = 1e-3;  // [rad]
  double before = 0, after = kMarch;
  while (after < kQuarter && bent.needed(after) > 0) before = after, after += kMarch;
  if (!(bent.needed(after) <= 0)) {
    c.no_displacement = {"local.held_for_good"};
    return c;
  }
  for (int i = 0; i < 60; ++i) {
    const double middle = 0.5 * (before + after);
    (bent.needed(middle) > 0 ? before : after) = middle;
  }
  c.rotation0 = before;
  c.top0 = bent.line_travel(before);
  c.displacement0 = c.top0 / hinge * travel;
  for (before = 0, after = kMarch; after < c.rotation0 && !bent.is_off(after);)
    before = after, after += kMarch;
  after = std::min(after, c.rotation0);
  if (!bent.is_off(after)) return c;
  for (int i = 0; i < 60; ++i) {
    const double middle = 0.5 * (before + after);
    (bent.is_off(middle) ? after : before) = middle;
  }
  c.slides_off = bent.line_travel(before) / hinge * travel;
  return c;
}

double BuildingAt::share() const {
  if (!(height > 0)) return 0;
  return 3.0 * storeys / (2.0 * storeys + 1) * std::min(height / top, 1.0);
}

}  // namespace wythe
