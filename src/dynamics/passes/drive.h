// Forces and motions that a stage prescribes for a few blocks of one wall: dead loads and the drive.
//
//   loads        dead loads that follow their blocks
//   drive        the driven blocks:
//     each      every one moves at the prescribed velocity
//     spreader  they get forces R r_i in fixed shares r_i (1 without a pattern), and only the mean of
//               their velocities with these shares is prescribed, which R works on:
//               sum r_i v_i = v sum r_i,   power of the drive = sum R r_i v_i = R v sum r_i
//
// R is found in two parts so that local damping sees the unbalanced force f_i + R0 r_i, where
// R0 = -sum r_i f_i / sum r_i^2 leaves nothing along the shares, and the mean velocity is still met
// exactly. The reaction is the contact force on the blocks.
//
// A head is one block that R pushes along a line beside its centroid, by an arm fixed to it. R then turns it
// too, by c R, and what is prescribed is the velocity of the arm's end, which R works on:
//               v + c omega = v_0,         R0 = -(f / m + c M / I) / (1 / m + c^2 / I)
#pragma once

#include "dynamics/passes/blocks.h"
#include "dynamics/passes/wall.h"

namespace wythe::dynamics {

// What the stage asks of this step; set by stage_run.cpp, constant within the step.
struct Controls {
  double dt = 0;                       // [s]
  double damping = 0;                  // local damping lambda [-]
  double mass_scaling = 1;             // inertia only; weights stay
  const Stage* push = nullptr;         // null when nothing is driven
  double drive_velocity = 0;           // along the push [m/s]
  double drive_before = kUnset;        // the same in the step before; unset: as in this step
  double mass_damping = 0;             // alpha of a shake: velocities fall as exp(-alpha t) [1/s]
  const Dashpots* dashpots = nullptr;  // of a shake; null: none
};

// The factor by which damping by mass reduces velocities in a step.
[[nodiscard]] WYTHE_INLINE double kept_by_mass(double alpha, double dt) {
  return (1 - 0.5 * alpha * dt) / (1 + 0.5 * alpha * dt);
}
// The time in which the velocities that joints see have moved the wall (kTimeBefore).
[[nodiscard]] WYTHE_INLINE double time_before(const Controls& controls) {
  const double kept = kept_by_mass(controls.mass_damping, controls.dt);
  return kept > 0 ? controls.dt / kept : controls.dt;
}

// Adds a load, times `scale`, to its block in its present pose.
WYTHE_INLINE void add_load(const PointLoad& load, double scale, const WallView& wall) {
  const BlockId i = load.block;
  const double c = wall.column_of(wall.t.pose, i, 2), s = wall.column_of(wall.t.pose, i, 3);
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

// Inertia force of mass that does not count as weight of its block. Gravity already contains the base acceleration.
WYTHE_INLINE void add_carried(const PointLoad& mass, double ax, double ay, const WallView& wall) {
  wall.block(mass.block, kLoadX) += mass.fx * ax;
  wall.block(mass.block, kLoadY) += mass.fx * ay;
}

// The driven blocks and how they are driven.
struct Drive {
  const BlockId* driven;
  const double* share;  // r_i
  int n;
  double px, py;  // unit vector of the push
  bool spread, free_across, free_rotation;
  bool is_pattern;  // the meters count its unbalanced forces
  bool has_arm;
  double arm;  // from the head's centroid to the line of the push, in its own axes [m]
};
// The wall's work so far [J].
struct WallWork {
  double drive, damping, loads;
};

// Sets the forces on block i: those of its joints, and the total with dead loads and gravity.
WYTHE_INLINE void sum_forces(BlockId i, const WallView& wall) {
  const BlockForce<double> contact = contact_force(wall.t, i, wall.lane);
  const double heavy = wall.block(i, kGravityMass);
  const double load_x = wall.block(i, kLoadX) + heavy * wall.wall_value(kGravityX);
  const double load_y = wall.block(i, kLoadY) + heavy * wall.wall_value(kGravityY);
  wall.cold(i, kContactX) = contact.x;
  wall.cold(i, kContactY) = contact.y;
  wall.cold(i, kTotalX) = contact.x + load_x;
  wall.cold(i, kTotalY) = contact.y + load_y;
  wall.cold(i, kTotalM) = wall.t.turn_freedom[i] * (contact.m + wall.block(i, kLoadM));
}

// Moment of a unit force along the push about the centroid of the head in its present pose [m].
WYTHE_INLINE double lever_of(const Drive& d, BlockId head, const WallView& wall) {
  if (!d.has_arm) return 0;
  const double c = wall.column_of(wall.t.pose, head, 2), s = wall.column_of(wall.t.pose, head, 3);
  const double x = -(2 * s * c) * d.arm, y = d.arm - 2 * s * s * d.arm;
  return x * d.py - y * d.px;
}

// Turns the head under the moment of its joints and of R. Returns its turn and adds to the work.
WYTHE_INLINE Moved<double> turn_head(double lever, double balance, double correction, double rate,
                                     BlockId head, const WallView& wall, WallWork& work) {
  const double dt = wall.wall_value(kDt), lambda = wall.wall_value(kDamping);
  const double omega = wall.block(head, kOmega);
  const double left = wall.cold(head, kTotalM) + lever * balance;
  Moved<double> turn = accelerate(omega, left, rate, dt, lambda);
  const double damping = -lambda * magnitude(left) * sign(omega);
  turn.velocity += rate * (lever * correction);
  turn.mean_velocity = 0.5 * (omega + turn.velocity);
  turn.damping_work = damping * turn.mean_velocity * dt;
  work.drive += lever * (balance + correction) * turn.mean_velocity * dt;
  return turn;
}

// Motion of a driven block in a step. Along the push: velocity before and after, force
// on it [N], work of its damping. Then its motion across the push, and its turn.
struct DrivenMotion {
  double before, after, force, damping_work;
  Moved<double> across, turn;
};
// Moves a driven block by this motion and adds to the work.
WYTHE_INLINE void keep_motion(const Drive& d, BlockId i, const DrivenMotion& now,
                              const WallView& wall, WallWork& work) {
  const double px = d.px, py = d.py, dt = wall.wall_value(kDt);
  const double mean_p = 0.5 * (now.before + now.after);
  const double mean_x = mean_p * px - now.across.mean_velocity * py;
  const double mean_y = mean_p * py + now.across.mean_velocity * px;
  const double load_x = wall.cold(i, kTotalX) - wall.cold(i, kContactX);
  const double load_y = wall.cold(i, kTotalY) - wall.cold(i, kContactY);
  work.drive += now.force * mean_p * dt;
  work.damping += now.damping_work + now.across.damping_work + now.turn.damping_work;
  work.loads +=
      dt * (load_x * mean_x + load_y * mean_y + wall.block(i, kLoadM) * now.turn.mean_velocity);

  wall.block(i, kVx) = now.after * px - now.across.velocity * py;
  wall.block(i, kVy) = now.after * py + now.across.velocity * px;
  wall.block(i, kOmega) = now.turn.velocity;
  wall.ux(i) += dt * wall.block(i, kVx);
  wall.uy(i) += dt * wall.block(i, kVy);
  wall.block(i, kTheta) += dt * now.turn.velocity;
  const SinCos<double> half = sin_cos(0.5 * wall.block(i, kTheta));
  wall.column_of(wall.t.pose, i, 2) = half.cos;
  wall.column_of(wall.t.pose, i, 3) = half.sin;
}

// Moves the driven blocks and returns the reaction [N].
WYTHE_INLINE double drive_blocks(const Drive& d, const WallView& wall, double velocity,
                                 WallWork& work) {
  const double px = d.px, py = d.py, dt = wall.wall_value(kDt), lambda = wall.wall_value(kDamping);
  const auto total = [&](BlockId i, ColdRow row) { return wall.cold(i, row); };

  // Forces in the given shares that balance all driven blocks together.
  double reaction = 0, sum = 0, mobility = 0, squares = 0;
  for (int k = 0; k < d.n; ++k) {
    const BlockId i = d.driven[k];
    sum_forces(i, wall);
    const double r = d.share[k];
    sum += r * (total(i, kTotalX) * px + total(i, kTotalY) * py);
    squares += r * r;
    mobility += r * r / wall.cold(i, kMass);
    reaction -= total(i, kContactX) * px + total(i, kContactY) * py;
  }
  double balance = d.spread ? -sum / squares : 0.0;
  const BlockId head = d.has_arm ? d.driven[0] : 0;
  const double lever = lever_of(d, head, wall);
  if (d.has_arm) {
    const double inertia = wall.cold(head, kInertia), mass = wall.cold(head, kMass);
    mobility = 1 / mass + lever * lever / inertia;
    balance = -(sum / mass + lever * total(head, kTotalM) / inertia) / mobility;
  }

  // Free motion under f_i + R0 r_i. A correction in the same shares then gives the prescribed mean velocity.
  double missed = 0;
  for (int k = 0; k < d.n; ++k) {
    const BlockId i = d.driven[k];
    const double r = d.share[k];
    const double f = total(i, kTotalX) * px + total(i, kTotalY) * py + r * balance;
    const double v = wall.block(i, kVx) * px + wall.block(i, kVy) * py;
    missed += r * (velocity - accelerate(v, f, dt / wall.cold(i, kMass), dt, lambda).velocity);
  }
  if (d.has_arm) {
    const double turned =
        accelerate(wall.block(head, kOmega), total(head, kTotalM) + lever * balance,
                   dt / wall.cold(head, kInertia), dt, lambda)
            .velocity;
    missed -= lever * turned;
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
      const double r = d.share[k], left = along_f + r * balance;
      const Moved<double> along = accelerate(along_v, left, dt / m, dt, lambda);
      vp = along.velocity + dt / m * (r * correction);
      force = r * (balance + correction);
      damped = -lambda * magnitude(left) * sign(along_v) * 0.5 * (along_v + vp);
      if (d.is_pattern) wall.cold(i, kUnbalanced) = magnitude(left) + magnitude(across_f);
    } else {
      force = m * (vp - along_v) / dt - along_f;
    }
    Moved<double> across{0, 0, 0}, turn{0, 0, 0};
    if (d.free_across) across = accelerate(across_v, across_f, dt / m, dt, lambda);
    if (d.has_arm)
      turn = turn_head(lever, balance, correction, dt / wall.cold(i, kInertia), i, wall, work);
    else if (d.free_rotation)
      turn = accelerate(wall.block(i, kOmega), total(i, kTotalM), dt / wall.cold(i, kInertia), dt,
                        lambda);

    keep_motion(d, i, {along_v, vp, force, damped * dt, across, turn}, wall, work);
  }
  return reaction;
}

[[nodiscard]] inline Drive drive_of(const Stage& push) {
  const FixitySpec fixity = fixity_of(push.spec);
  return {push.driven.data(),
          push.driven_share.data(),
          static_cast<int>(push.driven.size()),
          push.drive_x,
          push.drive_y,
          !push.moves_each(),
          fixity.across == Freedom::kFree,
          fixity.rotation == Freedom::kFree,
          push.has_pattern(),
          push.drive_arm == push.drive_arm,  // set
          push.drive_arm};
}

// The present share of the links' prestress.
[[nodiscard]] inline double links_set(const Model& model, const State& state) {
  return model.links.set_by < 0 ? 0.0 : state.load_scale[model.links.set_by];
}

// The present share of the force of wedges (jacks), while a cut stage drives them in. Below 0 in other stages.
[[nodiscard]] inline double jacks_set(const Model& model, const State& state) {
  const std::size_t now = state.stage;
  const bool cuts = model.standing.any() && now < model.stages.size() &&
                    model.stages[now].spec.kind() == StageKind::kCut;
  return cuts ? state.load_scale[now] : -1.0;
}

inline void advance_clock(State& state, const Controls& controls) {
  state.time += controls.dt;
  state.progress.time += controls.dt;
  ++state.step;
}

}  // namespace wythe::dynamics
