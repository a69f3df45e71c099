// What the dashpots of shaken walls need beside their pass (joint_dashpots.h), and damping in proportion to mass.
//
// A dashpot's force works on the mean of the velocities before and after the step, so its work is added when both are known.
#pragma once

#include "dynamics/passes/drive.h"
#include "dynamics/passes/joint_dashpots.h"
#include "dynamics/passes/wall.h"
#include "model/shaking.h"

namespace wythe::dynamics {

// Whether impacts rebound, so that the share of the first step matters. Without rebound a point sticks anyway.
[[nodiscard]] inline bool rebounds(const Dashpots& dashpots) {
  return dashpots.impact > 0 && dashpots.impact < kNoRebound;
}

[[nodiscard]] inline MaxwellStep<double> maxwell_step(const Dashpots& dashpots, double dt) {
  if (!(dashpots.spring_share > 0)) return {0, 0};
  const double h = dt / dashpots.relaxation, kept = exp_of_minus(h);
  return {kept, dashpots.spring_share * (1 - kept) / h};
}

// What a wall's dashpots need beside its tables.
struct DashpotState {
  const Dashpots* loaded = nullptr;  // whose numbers are in the table
  bool elements_bear = true;         // some stress of a Maxwell element may not be zero
};

// Sets the stresses of a wall's elements to zero, in a stage without them.
inline void clear_elements(const Layout& l, const WallView& wall, DashpotState& of) {
  for (std::ptrdiff_t k = 0; of.elements_bear && k < l.elements; ++k)
    wall.t.element[k * wall.t.lanes + wall.lane] = 0;
  of.elements_bear = false;
}

// Puts the numbers of a step's dashpots into the tables, and the velocities before it.
inline void load_dashpots(const Layout& l, const WallView& wall, const Dashpots& dashpots,
                          double dt, DashpotState& of) {
  if (of.loaded != &dashpots)
    for (std::size_t j = 0; j < dashpots.normal.size(); ++j) {
      wall.number(wall.t.dashpot, kDashpotRows, l.joint_place[j], kNormalDashpot) =
          dashpots.normal[j];
      wall.number(wall.t.dashpot, kDashpotRows, l.joint_place[j], kShearDashpot) =
          dashpots.shear[j];
    }
  of.loaded = &dashpots;
  const MaxwellStep<double> maxwell = maxwell_step(dashpots, dt);
  wall.wall_value(kHasDashpots) = 1;
  wall.wall_value(kRebounds) = rebounds(dashpots) ? 1 : 0;
  wall.wall_value(kElementKept) = maxwell.kept;
  wall.wall_value(kElementGain) = maxwell.gain;
  if (maxwell.gain > 0)
    of.elements_bear = true;
  else
    clear_elements(l, wall, of);
  for (int i = 0; i < wall.moving_blocks; ++i) {
    wall.column_of(wall.t.velocity, i, 0) = wall.block(i, kVx);
    wall.column_of(wall.t.velocity, i, 1) = wall.block(i, kVy);
    wall.column_of(wall.t.velocity, i, 2) = wall.block(i, kOmega);
  }
}

// Energy that the dashpots dissipated in the last step [J].
inline double dashpot_work(const Layout& l, const WallView& wall, const Model& m, double dt) {
  double power = 0;
  const auto add = [&](BlockId block, double sense, double fx, double fy, double moment) {
    const auto v = [&](int c) { return wall.column_of(wall.t.velocity, block, c); };
    power += 0.5 * (sense * fx * (v(0) + wall.block(block, kVx)) +
                    sense * fy * (v(1) + wall.block(block, kVy)) +
                    moment * (v(2) + wall.block(block, kOmega)));
  };
  for (int j = 0; j < m.n_joint; ++j) {
    const auto f = [&](int c) { return wall.column_of(wall.t.viscous_force, l.joint_place[j], c); };
    const double fx = f(0), fy = f(1);
    if (m.joint_a[j] != kGroundBlock) add(m.joint_a[j], 1, fx, fy, f(2));
    add(m.joint_b[j], -1, fx, fy, f(3));
  }
  return dt * power;
}

// Reduces velocities as exp(-alpha t); returns the work of that in a step [J].
inline double damp_by_mass(const WallView& wall, double alpha, double dt) {
  const double kept = kept_by_mass(alpha, dt);
  double energy = 0;
  for (int i = 0; i < wall.blocks; ++i) {
    if (!(wall.block(i, kIsFree) > 0)) continue;
    double& vx = wall.block(i, kVx);
    double& vy = wall.block(i, kVy);
    double& omega = wall.block(i, kOmega);
    energy += wall.cold(i, kMass) * (vx * vx + vy * vy) + wall.cold(i, kInertia) * omega * omega;
    vx *= kept, vy *= kept, omega *= kept;
  }
  for (int i = 0; i < wall.nodes; ++i) {
    double& vx = wall.node(i, kNodeVx);
    double& vy = wall.node(i, kNodeVy);
    energy += wall.node(i, kNodeMass) * (vx * vx + vy * vy);
    vx *= kept, vy *= kept;
  }
  return 0.5 * energy * (kept * kept - 1);
}

}  // namespace wythe::dynamics
