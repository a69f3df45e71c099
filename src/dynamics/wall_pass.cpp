// The driven blocks of a push, and the loads that follow their blocks.
//
//   each      every driven block moves at the prescribed velocity
//   spreader  the blocks get equal forces R, and only their mean velocity is prescribed:
//             R = -mean(f) + what the mean acceleration asks; each block then feels f_i + R.
//
// R is found in two parts so that local damping sees the unbalanced force f_i - mean(f) and the
// mean velocity is still met exactly. The reaction is the contact force on the blocks.
#include "dynamics/wall_pass.h"
#include "dynamics/motion.h"

namespace wythe::dynamics {
namespace {

// One driven block in the axes of the push: p along, q across.
struct Along {
  double force, velocity;
};

}  // namespace

double drive_pass(const Model& model, State& s, const WallView& wall, const Controls& controls) {
  double reaction = 0;
  if (controls.push == nullptr) return reaction;
  const Stage& push = *controls.push;
  const double px = push.drive_x, py = push.drive_y, dt = controls.dt, lambda = controls.damping;
  const auto n = static_cast<double>(push.driven.size());
  const bool spread = push.spec.as != Manner::kEach;

  // Equal force that balances the blocks together.
  double sum = 0, mobility = 0;
  for (const BlockId block : push.driven) {
    const auto i = static_cast<std::size_t>(block);
    sum += wall.total_x[i] * px + wall.total_y[i] * py;
    mobility += 1.0 / model.mass[i];
    reaction -= wall.contact_x[i] * px + wall.contact_y[i] * py;
  }
  const double balance = spread ? -sum / n : 0.0;

  // Free motion under f_i + R0; what it misses of the mean velocity is made up by an equal force.
  double missed = 0;
  for (const BlockId block : push.driven) {
    const auto i = static_cast<std::size_t>(block);
    const double f = wall.total_x[i] * px + wall.total_y[i] * py + balance;
    const double v = wall.vx[i] * px + wall.vy[i] * py;
    missed += controls.drive_velocity - accelerate(v, f, dt / model.mass[i], dt, lambda).velocity;
  }
  const double correction = missed / (mobility * dt);

  for (const BlockId block : push.driven) {
    const auto i = static_cast<std::size_t>(block);
    const double m = model.mass[i];
    const Along p{wall.total_x[i] * px + wall.total_y[i] * py, wall.vx[i] * px + wall.vy[i] * py};
    const Along q{wall.total_y[i] * px - wall.total_x[i] * py, wall.vy[i] * px - wall.vx[i] * py};

    double vp = controls.drive_velocity, force = 0, damped = 0;
    if (spread) {
      const Moved<double> along = accelerate(p.velocity, p.force + balance, dt / m, dt, lambda);
      vp = along.velocity + dt / m * correction;
      force = balance + correction;
      damped = -lambda * magnitude(p.force + balance) * sign(p.velocity) * 0.5 * (p.velocity + vp);
    } else {
      force = m * (vp - p.velocity) / dt - p.force;
    }
    Moved<double> across{0, 0, 0}, turn{0, 0, 0};
    if (push.spec.across == Freedom::kFree)
      across = accelerate(q.velocity, q.force, dt / m, dt, lambda);
    if (push.spec.rotation == Freedom::kFree)
      turn = accelerate(wall.omega[i], wall.total_m[i], dt / model.inertia[i], dt, lambda);

    const double mean_p = 0.5 * (p.velocity + vp);
    const double mean_x = mean_p * px - across.mean_velocity * py;
    const double mean_y = mean_p * py + across.mean_velocity * px;
    const double load_x = wall.total_x[i] - wall.contact_x[i];
    const double load_y = wall.total_y[i] - wall.contact_y[i];
    s.work_drive += force * mean_p * dt;
    s.work_damping += damped * dt + across.damping_work + turn.damping_work;
    s.work_loads += dt * (load_x * mean_x + load_y * mean_y + wall.load_m[i] * turn.mean_velocity);

    wall.vx[i] = vp * px - across.velocity * py;
    wall.vy[i] = vp * py + across.velocity * px;
    wall.omega[i] = turn.velocity;
    wall.ux[i] += dt * wall.vx[i];
    wall.uy[i] += dt * wall.vy[i];
    wall.theta[i] += dt * wall.omega[i];
  }
  s.drive_displacement += dt * controls.drive_velocity;
  return reaction;
}

void load_pass(const Model& model, const State& state, const WallView& wall) {
  // Only loaded blocks are touched: cleared first, then summed in the stages' order.
  for (const Stage& stage : model.stages)
    for (const PointLoad& load : stage.loads) {
      const auto i = static_cast<std::size_t>(load.block);
      wall.load_x[i] = wall.load_y[i] = wall.load_m[i] = 0;
    }
  for (std::size_t k = 0; k < model.stages.size(); ++k) {
    const double scale = state.load_scale[k];
    if (scale == 0) continue;
    for (const PointLoad& load : model.stages[k].loads) {
      const auto i = static_cast<std::size_t>(load.block);
      const double c = wall.pose[4 * i + 2], s = wall.pose[4 * i + 3];
      const double drop = -2 * s * s, sine = 2 * s * c;
      const double ax = load.arm_x + drop * load.arm_x - sine * load.arm_y;
      const double ay = load.arm_y + sine * load.arm_x + drop * load.arm_y;
      wall.load_x[i] += scale * load.fx;
      wall.load_y[i] += scale * load.fy;
      wall.load_m[i] += scale * (ax * load.fy - ay * load.fx);
    }
  }
}

void choose_driven(const Model& model, const WallView& wall, const std::vector<BlockId>& blocks) {
  for (std::size_t i = 0; i < static_cast<std::size_t>(model.n_block); ++i) wall.is_free[i] = 1.0;
  for (const BlockId block : blocks) wall.is_free[static_cast<std::size_t>(block)] = 0.0;
}

}  // namespace wythe::dynamics
