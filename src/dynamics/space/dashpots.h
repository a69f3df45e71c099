// What the dashpots of shaken walls in space need beside their pass (joint_dashpots.h), and damping in proportion to mass: as
// passes/dashpots.h.
#pragma once

#include <vector>

#include "dynamics/passes/dashpots.h"
#include "dynamics/space/joint_dashpots.h"
#include "dynamics/space/wall.h"

namespace wythe::dynamics::space {

struct Twist {
  Vec v, rate;  // [m/s], [1/s]
};
inline Twist twist_of(std::ptrdiff_t i, const WallView& w) {
  const Quaternion<double> q = w.turn(i);
  return {w.body_vector(i, kV),
          turned(q, inertia_of(i, w).rate(turned_back(q, w.body_vector(i, kL))))};
}

// Velocity of a support in the last step.
inline Vec velocity_of(std::int32_t support, const WallView& w) {
  if (!w.is_driven_support(support)) return {0, 0, 0};
  const Vec step{w.wall_value(kSupportStep), w.wall_value(kSupportStep + 1),
                 w.wall_value(kSupportStep + 2)};
  return (1 / w.wall_value(kStep)) * step;
}

// Sets the stresses of a wall's elements to zero, in a stage without them.
inline void clear_elements(const WallView& w, DashpotState& of) {
  const std::ptrdiff_t numbers =
      static_cast<std::ptrdiff_t>(w.layout->elements) * w.layout->group();
  for (std::ptrdiff_t k = 0; of.elements_bear && k < numbers; ++k)
    w.t.element[k * w.t.lanes + w.lane] = 0;
  of.elements_bear = false;
}

// Puts the numbers of a step's dashpots into the tables, and the velocities before it.
inline void load_dashpots(const WallView& w, const Dashpots& dashpots, double dt,
                          DashpotState& of) {
  if (of.loaded != &dashpots)
    for (std::size_t j = 0; j < dashpots.normal.size(); ++j) {
      const std::int32_t e = w.layout->joint_place[j];
      w.number(w.t.dashpot, kDashpotRows, e, kNormalDashpot) = dashpots.normal[j];
      w.number(w.t.dashpot, kDashpotRows, e, kShearDashpot) = dashpots.shear[j];
    }
  of.loaded = &dashpots;
  const MaxwellStep<double> maxwell = maxwell_step(dashpots, dt);
  w.wall_value(kHasDashpots) = 1;
  w.wall_value(kRebounds) = rebounds(dashpots) ? 1 : 0;
  w.wall_value(kElementKept) = maxwell.kept;
  w.wall_value(kElementGain) = maxwell.gain;
  if (maxwell.gain > 0)
    of.elements_bear = true;
  else
    clear_elements(w, of);
  for (int i = 0; i < w.blocks; ++i) {
    const Twist twist = twist_of(i, w);
    w.store_vector(twist.v, w.t.velocity, i);
    w.store_vector(twist.rate, w.t.spin_rate, i);
  }
  for (int i = 0; i < w.supports; ++i) w.store_vector(velocity_of(i, w), w.t.support_velocity, i);
}

// Energy that the dashpots dissipated in the last step [J].
inline double dashpot_work(const WallView& w, const Model& m, double dt) {
  std::vector<Load<double>> on(m.n_block, Load<double>{{0, 0, 0}, {0, 0, 0}});
  double power = 0;
  for (int j = 0; j < m.n_joint; ++j) {
    const std::int32_t e = w.layout->joint_place[j];
    const Vec f = w.vector(w.t.viscous_force, e);
    Load<double>& b = on[m.joint_b[j]];
    b = {b.f - f, b.m + w.vector(w.t.viscous_moment_b, e)};
    if (j >= m.n_pair) {
      const std::int32_t support = m.joint_a[j] - m.n_block;
      power += 0.5 * dot(f, w.vector(w.t.support_velocity, support) + velocity_of(support, w));
      continue;
    }
    Load<double>& a = on[m.joint_a[j]];
    a = {a.f + f, a.m + w.vector(w.t.viscous_moment_a, e)};
  }
  for (int i = 0; i < m.n_block; ++i) {
    const Twist now = twist_of(i, w);
    power += 0.5 * (dot(on[i].f, w.vector(w.t.velocity, i) + now.v) +
                    dot(on[i].m, w.vector(w.t.spin_rate, i) + now.rate));
  }
  return dt * power;
}

// Inertia force of mass that does not count as weight of its block. Gravity already contains the base acceleration.
inline void add_carried(const WallView& w, const Model& m, const State& s) {
  const std::size_t now = s.stage;
  if (now >= m.stages.size()) return;
  const Vec base{s.gravity_x, s.gravity_y + m.solve.gravity, s.gravity_z};
  for (const PointLoad& mass : m.stages[now].carried)
    w.store_body_vector(w.body_vector(mass.block, kLoad) + mass.fx * base, mass.block, kLoad);
}

// Reduces velocities as exp(-alpha t); returns the work of that in a step [J].
inline double damp_by_mass(const WallView& w, double alpha, double dt) {
  const double kept = kept_by_mass(alpha, dt);
  double energy = 0;
  for (int i = 0; i < w.blocks; ++i) {
    if (!(w.body(i, kFree) > 0)) continue;
    const Twist twist = twist_of(i, w);
    const Vec l = w.body_vector(i, kL);
    energy += w.still(i, kBodyMass) * dot(twist.v, twist.v) + dot(l, twist.rate);
    w.store_body_vector(kept * twist.v, i, kV);
    w.store_body_vector(kept * l, i, kL);
  }
  return 0.5 * energy * (kept * kept - 1);
}

}  // namespace wythe::dynamics::space
