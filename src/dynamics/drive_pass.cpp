// The driven blocks of a push.
//
//   each      every driven block moves at the prescribed velocity
//   spreader  the blocks get equal forces R, and only their mean velocity is prescribed:
//             R = -mean(f) + what the mean acceleration asks; each block then feels f_i + R.
//
// R is found in two parts so that local damping sees the unbalanced force f_i - mean(f) and the
// mean velocity is still met exactly. The reaction is the contact force on the blocks.
#include "dynamics/motion.h"
#include "dynamics/step.h"

namespace wythe::dynamics {
namespace {

// One driven block in the axes of the push: p along, q across.
struct Along {
  double force, velocity;
};

}  // namespace

DriveForce Stepper::drive_pass(State& s, const Controls& controls) {
  DriveForce drive;
  if (controls.push == nullptr) return drive;
  const Stage& push = *controls.push;
  const double px = push.drive_x, py = push.drive_y, dt = controls.dt, lambda = controls.damping;
  const auto n = static_cast<double>(push.driven.size());
  const bool spread = push.spec.as != Manner::kEach;

  // Equal force that balances the blocks together.
  double sum = 0, mobility = 0;
  for (const BlockId block : push.driven) {
    const auto i = static_cast<std::size_t>(block);
    sum += work_.total_x[i] * px + work_.total_y[i] * py;
    mobility += 1.0 / model_.mass[i];
    drive.reaction -= work_.contact_x[i] * px + work_.contact_y[i] * py;
  }
  const double balance = spread ? -sum / n : 0.0;

  // Free motion under f_i + R0; what it misses of the mean velocity is made up by an equal force.
  double missed = 0;
  for (const BlockId block : push.driven) {
    const auto i = static_cast<std::size_t>(block);
    const double f = work_.total_x[i] * px + work_.total_y[i] * py + balance;
    const double v = s.vx[i] * px + s.vy[i] * py;
    missed += controls.drive_velocity - accelerate(v, f, model_.mass[i], dt, lambda).velocity;
  }
  const double correction = missed / (mobility * dt);

  for (const BlockId block : push.driven) {
    const auto i = static_cast<std::size_t>(block);
    const double m = model_.mass[i];
    const Along p{work_.total_x[i] * px + work_.total_y[i] * py, s.vx[i] * px + s.vy[i] * py};
    const Along q{work_.total_y[i] * px - work_.total_x[i] * py, s.vy[i] * px - s.vx[i] * py};

    double vp = controls.drive_velocity, force = 0, damped = 0;
    if (spread) {
      const Moved<double> along = accelerate(p.velocity, p.force + balance, m, dt, lambda);
      vp = along.velocity + dt / m * correction;
      force = balance + correction;
      damped = -lambda * magnitude(p.force + balance) * sign(p.velocity) * 0.5 * (p.velocity + vp);
    } else {
      force = m * (vp - p.velocity) / dt - p.force;
    }
    Moved<double> across{0, 0, 0}, turn{0, 0, 0};
    if (push.spec.across == Freedom::kFree) across = accelerate(q.velocity, q.force, m, dt, lambda);
    if (push.spec.rotation == Freedom::kFree)
      turn = accelerate(s.omega[i], work_.total_m[i], model_.inertia[i], dt, lambda);

    const double mean_p = 0.5 * (p.velocity + vp);
    const double mean_x = mean_p * px - across.mean_velocity * py;
    const double mean_y = mean_p * py + across.mean_velocity * px;
    const double load_x = work_.total_x[i] - work_.contact_x[i];
    const double load_y = work_.total_y[i] - work_.contact_y[i];
    s.work_drive += force * mean_p * dt;
    s.work_damping += damped * dt + across.damping_work + turn.damping_work;
    s.work_loads += dt * (load_x * mean_x + load_y * mean_y + work_.load_m[i] * turn.mean_velocity);

    s.vx[i] = vp * px - across.velocity * py;
    s.vy[i] = vp * py + across.velocity * px;
    s.omega[i] = turn.velocity;
    s.ux[i] += dt * s.vx[i];
    s.uy[i] += dt * s.vy[i];
    s.theta[i] += dt * s.omega[i];
  }
  s.drive_displacement += dt * controls.drive_velocity;
  return drive;
}

}  // namespace wythe::dynamics
