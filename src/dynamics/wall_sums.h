// The sums over a wall that residual.h names, over plain arrays, for whoever holds them: this machine's
// memory, or a graphics processor's (device_step.h). One order of terms, hence one result.
#pragma once

#include "dynamics/wall_view.h"

namespace wythe::dynamics {

struct WallSizes {
  int n_block, n_pair, n_joint, n_node, n_contact;
  const BlockId* contact_block;  // n_block: the ground
  ConstStrided mass, inertia, node_mass;
};

WYTHE_INLINE double unbalance_of(const WallSizes& n, const WallView& wall) {
  double unbalanced = 0, contact = 0;
  for (int i = 0; i < n.n_block; ++i)
    if (wall.is_free[i] > 0) unbalanced += magnitude(wall.total_x[i]) + magnitude(wall.total_y[i]);
  for (int i = 0; i < n.n_node; ++i)
    unbalanced += magnitude(wall.node_total_x[i]) + magnitude(wall.node_total_y[i]);
  for (int j = 0; j < n.n_joint; ++j) {
    const double sides = j < n.n_pair ? 2.0 : 1.0;
    contact += sides * (magnitude(wall.force[4 * j]) + magnitude(wall.force[4 * j + 1]));
  }
  for (int c = 0; c < n.n_contact; ++c) {
    const double sides = n.contact_block[c] == n.n_block ? 1.0 : 2.0;
    contact += sides * (magnitude(wall.contact_block_force[4 * c]) +
                        magnitude(wall.contact_block_force[4 * c + 1]));
  }
  if (contact > 0) return unbalanced / contact;
  return unbalanced > 0 ? 1.0 : 0.0;
}

WYTHE_INLINE double kinetic_of(const WallSizes& n, const WallView& wall, double mass_scaling) {
  double energy = 0;
  for (int i = 0; i < n.n_block; ++i) {
    const double vx = wall.vx[i], vy = wall.vy[i], omega = wall.omega[i];
    energy += 0.5 * n.mass[i] * (vx * vx + vy * vy) + 0.5 * n.inertia[i] * omega * omega;
  }
  for (int i = 0; i < n.n_node; ++i) {
    const double vx = wall.node_vx[i], vy = wall.node_vy[i];
    energy += 0.5 * n.node_mass[i] * (vx * vx + vy * vy);
  }
  return energy * mass_scaling;
}

WYTHE_INLINE double shear_of(const WallSizes& n, const WallView& wall, double px, double py) {
  double sum = 0;  // the force on side a, the ground, resists with the opposite sign
  for (int j = n.n_pair; j < n.n_joint; ++j)
    sum += wall.force[4 * j] * px + wall.force[4 * j + 1] * py;
  for (int c = 0; c < n.n_contact; ++c)
    if (n.contact_block[c] == n.n_block)
      sum += wall.contact_block_force[4 * c] * px + wall.contact_block_force[4 * c + 1] * py;
  return sum;
}

WYTHE_INLINE BlockId runaway_of(const WallSizes& n, const WallView& wall) {
  constexpr double kFast = 100.0;  // [m/s], far beyond any free fall within a wall
  const auto finite = [](double x) { return x - x == 0; };
  for (int i = 0; i < n.n_block; ++i)
    if (!(magnitude(wall.vx[i]) + magnitude(wall.vy[i]) < kFast) || !finite(wall.omega[i]) ||
        !finite(wall.theta[i]))
      return i;
  for (int i = 0; i < n.n_node; ++i)
    if (!(magnitude(wall.node_vx[i]) + magnitude(wall.node_vy[i]) < kFast)) return n.n_block + i;
  return -1;
}

// Distance of the block that has moved furthest [m], and which it is; n_block + i for node i.
struct Furthest {
  double distance = 0;
  BlockId block = 0;
};

WYTHE_INLINE Furthest furthest_of(const WallSizes& n, const WallView& wall) {
  double most = 0;
  BlockId block = 0;
  const auto look = [&](const Strided& x, const Strided& y, int count, BlockId first) {
    for (int i = 0; i < count; ++i) {
      const double ux = x[i], uy = y[i];
      const double moved = ux * ux + uy * uy;
      if (moved > most) most = moved, block = first + i;
    }
  };
  look(wall.ux, wall.uy, n.n_block, 0);
  look(wall.node_ux, wall.node_uy, n.n_node, n.n_block);
  return {square_root(most), block};
}

}  // namespace wythe::dynamics
