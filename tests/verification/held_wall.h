// A one-way wall that cracks at half height: as two rocking bodies in closed form, and by the engine.
#pragma once

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "model/shaking.h"
#include "scenes/scenes.h"
#include "wythe/parts/solve.h"

namespace wythe::verification {

inline constexpr double kGravity = 9.81;

//    o  head held sideways, free to rise  The lower body turns by theta about its toe, the upper one by phi the other
//    /  h                                 way about its lower edge on the other face. One degree of freedom: phi follows
//    \  h                                 from the place of the top. Both bodies have mass 1.
struct HeldWall {
  double b, h;  // half of the thickness, height of one body

  struct Place {
    double x1, y1, a1, x2, y2, a2;
  };
  // The position bent to +x by theta >= 0.
  [[nodiscard]] Place at(double theta) const {
    const double c = std::cos(theta), s = std::sin(theta);
    double phi = theta;
    for (int k = 0; k < 8; ++k)
      phi -= (b - 2 * b * c + h * s + b * std::cos(phi) - h * std::sin(phi)) /
             (-b * std::sin(phi) - h * std::cos(phi));
    const double ax = b - 2 * b * c + h * s, ay = 2 * b * s + h * c;
    const double cp = std::cos(phi), sp = std::sin(phi);
    return {b - b * c + 0.5 * h * s,    b * s + 0.5 * h * c,        -theta,
            ax + b * cp - 0.5 * h * sp, ay + b * sp + 0.5 * h * cp, phi};
  }
  // theta'' in this position and at this rate, under an acceleration of the base towards +x.
  [[nodiscard]] double pull(double theta, double rate, double base) const {
    constexpr double d = 1e-5;
    const double at0 = std::fmax(theta, 2 * d), i2 = (4 * b * b + h * h) / 12;
    const auto slope = [&](double t) {
      const Place p = at(t - d), q = at(t + d);
      const auto over = [&](double Place::*m) { return (q.*m - p.*m) / (2 * d); };
      return Place{over(&Place::x1), over(&Place::y1), over(&Place::a1),
                   over(&Place::x2), over(&Place::y2), over(&Place::a2)};
    };
    const auto mass = [&](const Place& v) {
      return v.x1 * v.x1 + v.y1 * v.y1 + v.x2 * v.x2 + v.y2 * v.y2 +
             i2 * (v.a1 * v.a1 + v.a2 * v.a2);
    };
    const Place v = slope(at0);
    const double grows = (mass(slope(at0 + d)) - mass(slope(at0 - d))) / (2 * d);
    return (-base * (v.x1 + v.x2) - kGravity * (v.y1 + v.y2) - 0.5 * grows * rate * rate) / mass(v);
  }
  // The share of the rate that remains after an impact: moments of the impulses about the new mechanism vanish.
  [[nodiscard]] double kept() const {
    const double i2 = (4 * b * b + h * h) / 12, same = 0.5 * h * h + 2 * i2, lift = 10 * b * b;
    return (same - lift) / (same + lift);
  }
  [[nodiscard]] double uplift() const { return 4 * kGravity * b / h; }
};

// Largest displacement of the lower body's centre over b; 9 if the wall falls.
inline double bent(const HeldWall& w, const GroundMotion& base, double seconds) {
  constexpr double h = 2e-4;
  double theta = 0, rate = 0, side = 0, most = 0;
  for (double t = 0; t < seconds; t += h) {
    const auto a = [&](double at) { return side * base.acceleration_at(at); };
    if (side == 0) {
      const double now = base.acceleration_at(t + h);
      if (std::fabs(now) <= w.uplift()) continue;
      side = now < 0 ? 1 : -1;  // bent to +x where the base goes to -x
    }
    const double k1 = w.pull(theta, rate, a(t));
    const double k2 = w.pull(theta + h / 2 * rate, rate + h / 2 * k1, a(t + h / 2));
    const double k3 =
        w.pull(theta + h / 2 * rate + h * h / 4 * k1, rate + h / 2 * k2, a(t + h / 2));
    const double k4 = w.pull(theta + h * rate + h * h / 2 * k2, rate + h * k3, a(t + h));
    theta += h * rate + h * h / 6 * (k1 + k2 + k3);
    rate += h / 6 * (k1 + 2 * k2 + 2 * k3 + k4);
    if (theta < 0) {
      theta = 0;
      rate *= -w.kept();
      side = -side;
      if (rate < 1e-3) side = rate = 0;
    }
    most = std::fmax(most, w.at(theta).x1 / w.b);
    if (theta > 0.9) return 9;
  }
  return most;
}

inline double shaken_bend(const HeldWall& w, const RecordSpec& record, double stiffness) {
  std::vector<BlockSpec> blocks{scenes::rectangle("lower", 0, 0, 2 * w.b, w.h),
                                scenes::rectangle("upper", 0, w.h, 2 * w.b, w.h)};
  ModelSpec spec = scenes::assembly(
      blocks, scenes::dry_joint(stiffness, 0.4 * stiffness, scenes::degrees(70)), 1.0, 2000);
  spec.solve.point_rule = PointRule::kCorners;
  spec.solve.points_per_face = 2;
  SpringSpec top;
  top.name = "top";
  top.at.x = w.b, top.at.y = 2 * w.h;
  top.stiffness = 1e9;  // at 1e8, and hinges of 1e10 Pa/m, the mean is 0.031, rms 0.053
  spec.spring = {top};
  StageSpec shake{.name = "quake",
                  .action = ShakeStage{.record = {record}, .free_vibration = 2, .restitution = 0}};
  spec.stage = {scenes::gravity_stage(), shake};
  HistorySpec lower;
  lower.name = "lower";
  lower.at.block = "lower";
  spec.history = {lower};
  const Model model = compile(spec);
  State state = initial_state(model);
  const Result result = solve(model, state);
  if (result.status == SolveStatus::kCollapsed) return 9;
  EXPECT_EQ(result.status, SolveStatus::kCompleted) << result.reason;
  double most = 0;
  for (const PointMotion& u : result.history.motion) most = std::fmax(most, std::fabs(u[0]));
  return most / w.b;
}

}  // namespace wythe::verification
