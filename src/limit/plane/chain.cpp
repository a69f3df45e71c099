// A chain of one or three rigid bodies: positions, velocities, and the force in equilibrium with its loads.
//
//   a = C12 - C1,  b = C23 - C12,  c = C23 - C3 (current positions)
//   closure      C1 + a + b = C3 + c        positions: C23 is where two circles meet
//   rates        a + w2 b = w3 c            per unit rate of body 1
//                w2 = -(a x c)/(b x c),  w3 = (a x b)/(c x b)
//   virtual work F (v_load . d) + sum P . v = 0
//
// Equations (6.6), (6.7), (6.10) of docs/theory/limit_analysis.md. Called by cut_mechanism() and tests.
#include <algorithm>
#include <cmath>
#include <optional>

#include "core/elementary.h"
#include "wythe/parts/error.h"
#include "wythe/parts/limit.h"

namespace wythe {
namespace {

constexpr double kMarch = 2e-4;    // step of rotation in the search for the end [rad]
constexpr double kFarthest = 1.5;  // largest rotation of a chain [rad]
constexpr int kStates = 500;       // of a curve
constexpr double kLocked = 1e-9;   // b x c over their lengths

double angle_between(Vec2 from, Vec2 to) {
  return elementary::atan2(cross(from, to), dot(from, to));
}

// Positions of the rotated bodies, for `rotation` of the first one.
struct Pose {
  std::vector<double> rotation, rate;
  std::vector<Vec2> hinges;
};

class Follower {
 public:
  explicit Follower(const Chain& chain) : c_(chain) {}

  [[nodiscard]] std::optional<Pose> pose(double turn) const {
    if (c_.bodies.size() == 1) return Pose{{turn}, {1.0}, c_.hinges};
    const Vec2 p0 = c_.hinges[0], p3 = c_.hinges[3];
    const Vec2 a0 = c_.hinges[1] - p0, b0 = c_.hinges[2] - c_.hinges[1], c0 = c_.hinges[2] - p3;
    const Vec2 a = turned(a0, turn), p1 = p0 + a;
    const std::optional<Vec2> p2 = meet(p1, dot(b0, b0), p3, dot(c0, c0), cross(b0, c0));
    if (!p2) return std::nullopt;
    const Vec2 b = *p2 - p1, c = *p2 - p3;
    const double area = cross(b, c);
    if (std::fabs(area) <= kLocked * std::sqrt(dot(b, b) * dot(c, c))) return std::nullopt;
    return Pose{{turn, angle_between(b0, b), angle_between(c0, c)},
                {1.0, -cross(a, c) / area, -cross(a, b) / area},
                {p0, p1, *p2, p3}};
  }

  // The hinge about which a body rotates in this pose, and the velocity of that hinge.
  struct Pivot {
    Vec2 before, now, velocity;
  };
  [[nodiscard]] Pivot pivot(const Pose& pose, std::size_t body) const {
    if (body == 0) return {c_.hinges[0], pose.hinges[0], {0, 0}};
    if (body == 2) return {c_.hinges[3], pose.hinges[3], {0, 0}};
    const Vec2 arm = pose.hinges[1] - pose.hinges[0];
    return {c_.hinges[1], pose.hinges[1], {-arm.y, arm.x}};
  }
  [[nodiscard]] Vec2 place(const Pose& pose, std::size_t body, Vec2 at) const {
    const Pivot p = pivot(pose, body);
    return p.now + turned(at - p.before, pose.rotation[body]);
  }
  // Velocity of a point of a body, per unit rate of the first body.
  [[nodiscard]] Vec2 velocity(const Pose& pose, std::size_t body, Vec2 at) const {
    const Pivot p = pivot(pose, body);
    const Vec2 arm = turned(at - p.before, pose.rotation[body]);
    const double w = pose.rate[body];
    return {p.velocity.x - w * arm.y, p.velocity.y + w * arm.x};
  }

  [[nodiscard]] double load_speed(const Pose& pose) const {
    return c_.direction * velocity(pose, loaded(), c_.load_point).x;
  }
  [[nodiscard]] double dead_power(const Pose& pose) const {
    double power = 0;
    for (std::size_t i = 0; i < c_.bodies.size(); ++i) {
      for (const BodyLoad& load : c_.bodies[i].loads) {
        const Vec2 v = velocity(pose, i, load.at);
        power += load.fx * v.x + load.fy * v.y;
      }
    }
    return power;
  }
  [[nodiscard]] ChainState state(const Pose& pose) const {
    ChainState s;
    const Vec2 now = place(pose, loaded(), c_.load_point);
    s.displacement = c_.direction * (now.x - c_.load_point.x);
    s.force = -dead_power(pose) / load_speed(pose);
    s.rotation = pose.rotation;
    s.rate = pose.rate;
    s.hinges = pose.hinges;
    return s;
  }

 private:
  [[nodiscard]] std::size_t loaded() const { return static_cast<std::size_t>(c_.loaded_body); }

  // Intersection of the circles about p1 and p3 (squared radii), on the side given by the sign of b x c.
  static std::optional<Vec2> meet(Vec2 p1, double r1, Vec2 p3, double r3, double side) {
    const Vec2 base = p3 - p1;
    const double length2 = dot(base, base);
    const double along = (r1 - r3 + length2) / (2 * length2);
    const double height2 = r1 / length2 - along * along;
    if (height2 < 0) return std::nullopt;
    // b x c = base x b, for c = b - base
    const double height = std::copysign(std::sqrt(height2), side);
    return p1 + Vec2{along * base.x - height * base.y, along * base.y + height * base.x};
  }

  const Chain& c_;
};

[[noreturn]] void refuse(const std::string& problem, const std::string& cure) {
  throw InputError({{.path = "wall", .problem = problem, .cure = cure}});
}

struct End {
  double turn = 0;
  ChainEnd why = ChainEnd::kNoForce;
};

// Whether the chain ends at this rotation, and why.
std::optional<ChainEnd> ends_at(const Follower& follower, double sense, double turn) {
  const std::optional<Pose> pose = follower.pose(sense * turn);
  if (!pose) return ChainEnd::kLocked;
  if (sense * follower.load_speed(*pose) <= 0) return ChainEnd::kTurnsBack;
  if (follower.state(*pose).force <= 0) return ChainEnd::kNoForce;
  return std::nullopt;
}

End find_end(const Follower& follower, double sense) {
  double before = 0, after = kMarch;
  std::optional<ChainEnd> why;
  while (!(why = ends_at(follower, sense, after)) && after < kFarthest) {
    before = after;
    after += kMarch;
  }
  if (!why) return {after, ChainEnd::kLocked};
  for (int i = 0; i < 60 && after - before > 0; ++i) {
    const double middle = 0.5 * (before + after);
    const std::optional<ChainEnd> ended = ends_at(follower, sense, middle);
    (ended ? after : before) = middle;
    if (ended) why = ended;
  }
  return {before, *why};
}

}  // namespace

Vec2 placed(const Chain& chain, const ChainState& state, std::size_t body, Vec2 at) {
  return Follower(chain).place({state.rotation, state.rate, state.hinges}, body, at);
}

// Moments of the piers about their feet give H12: a x H12 = -M1, c x (R2 - H12) = -M3.
std::vector<Vec2> hinge_forces(const Chain& chain, double force) {
  std::vector<Vec2> sum(chain.bodies.size(), {0, 0});  // of the loads on each body
  const auto moment = [&](std::size_t body, Vec2 about) {
    double m = 0;
    for (const BodyLoad& load : chain.bodies[body].loads)
      m += cross(load.at - about, {load.fx, load.fy});
    if (static_cast<std::size_t>(chain.loaded_body) == body)
      m += cross(chain.load_point - about, {chain.direction * force, 0});
    return m;
  };
  for (std::size_t i = 0; i < sum.size(); ++i)
    for (const BodyLoad& load : chain.bodies[i].loads) sum[i] = sum[i] + Vec2{load.fx, load.fy};
  Vec2& loaded = sum[chain.loaded_body];
  loaded.x += chain.direction * force;
  if (sum.size() == 1) return {{-sum[0].x, -sum[0].y}};
  const std::vector<Vec2>& h = chain.hinges;
  const Vec2 a = h[1] - h[0], c = h[2] - h[3];
  const double m1 = -moment(0, h[0]), m3 = moment(2, h[3]) + cross(c, sum[1]);
  const double det = a.y * c.x - a.x * c.y;  // of (a x H, c x H) in H.x, H.y
  const Vec2 h12{(a.x * m3 - c.x * m1) / det, (a.y * m3 - c.y * m1) / det};
  const Vec2 h23 = sum[1] - h12;
  return {{-sum[0].x - h12.x, -sum[0].y - h12.y}, h12, h23, {-sum[2].x - h23.x, -sum[2].y - h23.y}};
}

CapacityCurve follow(const Chain& chain) {
  const Follower follower(chain);
  const std::optional<Pose> rest = follower.pose(0);
  if (!rest) refuse("the chain of macro-blocks is locked", "check the hinges");
  const double speed = follower.load_speed(*rest);
  if (std::fabs(speed) < 1e-9)
    refuse("the load point does not move in this mechanism", "push higher, beside the spandrel");
  const double sense = speed > 0 ? 1 : -1;
  if (follower.state(*rest).force <= 0)
    refuse("this mechanism falls under the dead loads alone",
           "lower the loads on the spandrel, or check the push's direction");
  const End end = find_end(follower, sense);
  CapacityCurve curve;
  curve.end = end.why;
  for (int i = 0; i <= kStates; ++i)
    if (const auto pose = follower.pose(sense * end.turn * i / kStates))
      curve.states.push_back(follower.state(*pose));
  curve.states.front().displacement = 0;
  if (curve.end == ChainEnd::kNoForce) curve.states.back().force = 0;
  return curve;
}

double CapacityCurve::force_at(double displacement) const {
  const auto after = std::find_if(states.begin(), states.end(), [&](const ChainState& s) {
    return s.displacement >= displacement;
  });
  if (after == states.end()) return 0;
  if (after == states.begin()) return after->force;
  const ChainState& a = *(after - 1);
  const double share = (displacement - a.displacement) / (after->displacement - a.displacement);
  return a.force + share * (after->force - a.force);
}

Assessment assess(const Chain& chain, const CapacityCurve& curve, double gravity,
                  const LimitStateShares& shares) {
  const Follower follower(chain);
  const Pose rest = follower.pose(0).value();
  const double sense = follower.load_speed(rest) > 0 ? 1 : -1;
  double weight = 0, first = 0, second = 0, lifted = 0;
  for (std::size_t i = 0; i < chain.bodies.size(); ++i) {
    for (const BodyLoad& load : chain.bodies[i].loads) {
      const Vec2 v = follower.velocity(rest, i, load.at);
      const double p = -load.fy, along = sense * chain.direction * v.x;
      weight += p;
      first += p * along;
      second += p * along * along;
      lifted += p * sense * v.y;
    }
  }
  Assessment a;
  a.alpha0 = curve.states.front().force / weight;
  a.alpha0_by_weights = lifted / first;
  a.participating_mass = first * first / (gravity * second);
  a.mass_share = gravity * a.participating_mass / weight;
  a.acceleration0 = a.alpha0_by_weights * gravity / a.mass_share;
  a.displacement0 = curve.states.back().displacement;
  a.spectral_share = second / (std::fabs(follower.load_speed(rest)) * first);
  a.life_safety = shares.life_safety * a.displacement0;
  a.near_collapse = shares.near_collapse * a.displacement0;
  return a;
}

}  // namespace wythe
