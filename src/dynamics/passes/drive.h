// What a stage does to a few blocks of one wall: dead loads and the drive.
//
//   loads        dead loads that follow their blocks
//   drive        the driven blocks:
//     each      every one moves at the prescribed velocity
//     spreader  they get equal forces R, and only their mean velocity is prescribed:
//               R = -mean(f) + what the mean acceleration asks; each block then feels f_i + R
//
// R is found in two parts so that local damping sees the unbalanced force f_i - mean(f) and the
// mean velocity is still met exactly. The reaction is the contact force on the blocks.
#pragma once

#include "dynamics/passes/blocks.h"
#include "dynamics/passes/wall.h"

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
  const double c = wall.of_four(wall.t.pose, i, 2), s = wall.of_four(wall.t.pose, i, 3);
  const double drop = -2 * s * s, sine = 2 * s * c;
  const double ax = load.arm_x + drop * load.arm_x - sine * load.arm_y;
  const double ay = load.arm_y + sine * load.arm_x + drop * load.arm_y;
  wall.block(i, kLoadX) += scale * load.fx;
  wall.block(i, kLoadY) += scale * load.fy;
  wall.block(i, kLoadM) += scale * (ax * load.fy - ay * load.fx);
}
WYTHE_INLINE void clear_load(BlockId i, const WallView& wall) {
  wall.block(i, kLoadX) = wall.block(i, kLoadY) = wall.block(i, kLoadM) = 0;
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

// Forces on block i: of its joints, and with dead loads and gravity.
WYTHE_INLINE void sum_forces(BlockId i, const WallView& wall) {
  const BlockForce<double> contact = contact_force(wall.t, i, wall.lane);
  const double heavy = wall.block(i, kHeavyMass);
  const double load_x = wall.block(i, kLoadX) + heavy * wall.of_wall(kGravityX);
  const double load_y = wall.block(i, kLoadY) + heavy * wall.of_wall(kGravityY);
  wall.cold(i, kContactX) = contact.x;
  wall.cold(i, kContactY) = contact.y;
  wall.cold(i, kTotalX) = contact.x + load_x;
  wall.cold(i, kTotalY) = contact.y + load_y;
  wall.cold(i, kTotalM) = wall.t.turn_freedom[i] * (contact.m + wall.block(i, kLoadM));
}

// Moves the driven blocks and returns the reaction [N].
WYTHE_INLINE double drive_blocks(const Drive& d, const WallView& wall, double velocity,
                                 WallWork& work) {
  const double px = d.px, py = d.py, dt = wall.of_wall(kDt), lambda = wall.of_wall(kDamping);
  const auto total = [&](BlockId i, ColdRow row) { return wall.cold(i, row); };

  // Equal force that balances the blocks together.
  double reaction = 0, sum = 0, mobility = 0;
  for (int k = 0; k < d.n; ++k) {
    const BlockId i = d.driven[k];
    sum_forces(i, wall);
    sum += total(i, kTotalX) * px + total(i, kTotalY) * py;
    mobility += 1.0 / wall.cold(i, kMass);
    reaction -= total(i, kContactX) * px + total(i, kContactY) * py;
  }
  const double balance = d.spread ? -sum / static_cast<double>(d.n) : 0.0;

  // Free motion under f_i + R0; what it misses of the mean velocity is made up by an equal force.
  double missed = 0;
  for (int k = 0; k < d.n; ++k) {
    const BlockId i = d.driven[k];
    const double f = total(i, kTotalX) * px + total(i, kTotalY) * py + balance;
    const double v = wall.block(i, kVx) * px + wall.block(i, kVy) * py;
    missed += velocity - accelerate(v, f, dt / wall.cold(i, kMass), dt, lambda).velocity;
  }
  const double correction = missed / (mobility * dt);

  for (int k = 0; k < d.n; ++k) {
    const BlockId i = d.driven[k];
    const double m = wall.cold(i, kMass), fx = total(i, kTotalX), fy = total(i, kTotalY);
    const double vx = wall.block(i, kVx), vy = wall.block(i, kVy);
    const double along_f = fx * px + fy * py, along_v = vx * px + vy * py;
    const double across_f = fy * px - fx * py, across_v = vy * px - vx * py;

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
      turn = accelerate(wall.block(i, kOmega), total(i, kTotalM), dt / wall.cold(i, kInertia), dt,
                        lambda);

    const double mean_p = 0.5 * (along_v + vp);
    const double mean_x = mean_p * px - across.mean_velocity * py;
    const double mean_y = mean_p * py + across.mean_velocity * px;
    const double load_x = fx - total(i, kContactX), load_y = fy - total(i, kContactY);
    work.drive += force * mean_p * dt;
    work.damping += damped * dt + across.damping_work + turn.damping_work;
    work.loads +=
        dt * (load_x * mean_x + load_y * mean_y + wall.block(i, kLoadM) * turn.mean_velocity);

    wall.block(i, kVx) = vp * px - across.velocity * py;
    wall.block(i, kVy) = vp * py + across.velocity * px;
    wall.block(i, kOmega) = turn.velocity;
    wall.ux(i) += dt * wall.block(i, kVx);
    wall.uy(i) += dt * wall.block(i, kVy);
    wall.block(i, kTheta) += dt * turn.velocity;
    const SinCos<double> half = sin_cos(0.5 * wall.block(i, kTheta));
    wall.of_four(wall.t.pose, i, 2) = half.cos;
    wall.of_four(wall.t.pose, i, 3) = half.sin;
  }
  return reaction;
}

[[nodiscard]] inline Drive drive_of(const Stage& push) {
  return {push.driven.data(),
          static_cast<int>(push.driven.size()),
          push.drive_x,
          push.drive_y,
          push.spec.as != Manner::kEach,
          push.spec.across == Freedom::kFree,
          push.spec.rotation == Freedom::kFree};
}

inline void advance_clock(State& state, const Controls& controls) {
  state.time += controls.dt;
  state.stage_time += controls.dt;
  ++state.step;
}

}  // namespace wythe::dynamics
