// The passes of a step that touch a few blocks of one wall, and its clock.
//
//   load_pass    dead loads that follow their blocks
//   drive_pass   the driven blocks:
//     each      every one moves at the prescribed velocity
//     spreader  they get equal forces R, and only their mean velocity is prescribed:
//               R = -mean(f) + what the mean acceleration asks; each block then feels f_i + R
//
// R is found in two parts so that local damping sees the unbalanced force f_i - mean(f) and the
// mean velocity is still met exactly. The reaction is the contact force on the blocks.
#pragma once

#include "dynamics/motion.h"
#include "dynamics/wall_view.h"

namespace wythe::dynamics {

// What the stage asks of this step; set by stage_run.cpp, constant within the step.
struct Controls {
  double dt = 0;                // [s]
  double damping = 0;           // local damping lambda [-]
  double mass_scaling = 1;      // inertia only; weights stay
  const Stage* push = nullptr;  // null when nothing is driven
  double drive_velocity = 0;    // along the push [m/s]
};

// The load on its turned block, times `scale`.
WYTHE_INLINE void add_load(const PointLoad& load, double scale, const WallView& wall) {
  const BlockId i = load.block;
  const double c = wall.pose[4 * i + 2], s = wall.pose[4 * i + 3];
  const double drop = -2 * s * s, sine = 2 * s * c;
  const double ax = load.arm_x + drop * load.arm_x - sine * load.arm_y;
  const double ay = load.arm_y + sine * load.arm_x + drop * load.arm_y;
  wall.load_x[i] += scale * load.fx;
  wall.load_y[i] += scale * load.fy;
  wall.load_m[i] += scale * (ax * load.fy - ay * load.fx);
}

// Who is driven, and how.
struct Drive {
  const BlockId* driven;
  int n;
  double px, py;  // unit vector of the push
  bool spread, free_across, free_rotation;
};
// The wall's work so far [J].
struct WallWork {
  double drive, damping, loads;
};

// Moves the driven blocks and returns the reaction [N].
WYTHE_INLINE double drive_blocks(const Drive& d, const WallView& wall, ConstStrided mass,
                                 ConstStrided inertia, double dt, double lambda, double velocity,
                                 WallWork& work) {
  const double px = d.px, py = d.py;

  // Equal force that balances the blocks together.
  double reaction = 0, sum = 0, mobility = 0;
  for (int k = 0; k < d.n; ++k) {
    const BlockId i = d.driven[k];
    sum += wall.total_x[i] * px + wall.total_y[i] * py;
    mobility += 1.0 / mass[i];
    reaction -= wall.contact_x[i] * px + wall.contact_y[i] * py;
  }
  const double balance = d.spread ? -sum / static_cast<double>(d.n) : 0.0;

  // Free motion under f_i + R0; what it misses of the mean velocity is made up by an equal force.
  double missed = 0;
  for (int k = 0; k < d.n; ++k) {
    const BlockId i = d.driven[k];
    const double f = wall.total_x[i] * px + wall.total_y[i] * py + balance;
    const double v = wall.vx[i] * px + wall.vy[i] * py;
    missed += velocity - accelerate(v, f, dt / mass[i], dt, lambda).velocity;
  }
  const double correction = missed / (mobility * dt);

  for (int k = 0; k < d.n; ++k) {
    const BlockId i = d.driven[k];
    const double m = mass[i];
    const double along_f = wall.total_x[i] * px + wall.total_y[i] * py;
    const double along_v = wall.vx[i] * px + wall.vy[i] * py;
    const double across_f = wall.total_y[i] * px - wall.total_x[i] * py;
    const double across_v = wall.vy[i] * px - wall.vx[i] * py;

    double vp = velocity, force = 0, damped = 0;
    if (d.spread) {
      const Moved<double> along = accelerate(along_v, along_f + balance, dt / m, dt, lambda);
      vp = along.velocity + dt / m * correction;
      force = balance + correction;
      damped = -lambda * magnitude(along_f + balance) * sign(along_v) * 0.5 * (along_v + vp);
    } else {
      force = m * (vp - along_v) / dt - along_f;
    }
    Moved<double> across{0, 0, 0}, turn{0, 0, 0};
    if (d.free_across) across = accelerate(across_v, across_f, dt / m, dt, lambda);
    if (d.free_rotation)
      turn = accelerate(wall.omega[i], wall.total_m[i], dt / inertia[i], dt, lambda);

    const double mean_p = 0.5 * (along_v + vp);
    const double mean_x = mean_p * px - across.mean_velocity * py;
    const double mean_y = mean_p * py + across.mean_velocity * px;
    const double load_x = wall.total_x[i] - wall.contact_x[i];
    const double load_y = wall.total_y[i] - wall.contact_y[i];
    work.drive += force * mean_p * dt;
    work.damping += damped * dt + across.damping_work + turn.damping_work;
    work.loads += dt * (load_x * mean_x + load_y * mean_y + wall.load_m[i] * turn.mean_velocity);

    wall.vx[i] = vp * px - across.velocity * py;
    wall.vy[i] = vp * py + across.velocity * px;
    wall.omega[i] = turn.velocity;
    wall.ux[i] += dt * wall.vx[i];
    wall.uy[i] += dt * wall.vy[i];
    wall.theta[i] += dt * wall.omega[i];
  }
  return reaction;
}

void load_pass(const Model& model, const State& state, const WallView& wall);
[[nodiscard]] Drive drive_of(const Stage& push);
// Returns the reaction: -sum of the contact forces on the driven blocks along the push [N].
double drive_pass(const Model& model, State& state, const WallView& wall, const Controls& controls);
// Marks the blocks that drive_pass moves in place of the move pass.
void choose_driven(const Model& model, const WallView& wall, const std::vector<BlockId>& blocks);

inline void advance_clock(State& state, const Controls& controls) {
  state.time += controls.dt;
  state.stage_time += controls.dt;
  ++state.step;
}

}  // namespace wythe::dynamics
