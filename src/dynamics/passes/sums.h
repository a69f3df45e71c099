// The sums over a wall that residual.h names. The order of terms is
// fixed, so the result is the same wherever the wall is stepped.
#pragma once

#include "dynamics/passes/blocks.h"
#include "dynamics/passes/wall.h"

namespace wythe::dynamics {

WYTHE_INLINE double unbalance_of(const WallView& wall) {
  double unbalanced = 0, contact = 0;
  for (int i = 0; i < wall.blocks; ++i) {
    if (!(wall.block(i, kIsFree) > 0)) {
      unbalanced += wall.cold(i, kUnbalanced);
      continue;
    }
    const BlockForce<double> f = contact_force(wall.t, i, wall.lane);
    const double heavy = wall.block(i, kGravityMass);
    const double x = f.x + (wall.block(i, kLoadX) + heavy * wall.wall_value(kGravityX));
    const double y = f.y + (wall.block(i, kLoadY) + heavy * wall.wall_value(kGravityY));
    unbalanced += magnitude(x) + magnitude(y);
  }
  for (int i = 0; i < wall.nodes; ++i)
    unbalanced += magnitude(wall.node(i, kNodeTotalX)) + magnitude(wall.node(i, kNodeTotalY));
  for (int j = 0; j < wall.joints; ++j) {
    const double sides = j < wall.first_ground ? 2.0 : 1.0;
    contact += sides * (magnitude(wall.column_of(wall.t.force, j, 0)) +
                        magnitude(wall.column_of(wall.t.force, j, 1)));
  }
  for (int c = 0; c < wall.edges; ++c) {
    const double sides = wall.t.edge_block[c] == wall.t.n_block ? 1.0 : 2.0;
    contact += sides * (magnitude(wall.column_of(wall.t.edge_block_force, c, 0)) +
                        magnitude(wall.column_of(wall.t.edge_block_force, c, 1)));
  }
  for (int k = 0; k < wall.links; ++k) {
    const double sides = wall.t.link_a[k] == wall.t.n_block ? 1.0 : 2.0;
    contact += sides * (magnitude(wall.column_of(wall.t.force, wall.joints + k, 0)) +
                        magnitude(wall.column_of(wall.t.force, wall.joints + k, 1)));
  }
  for (int k = 0; k < wall.frames; ++k) {
    const double sides = wall.t.frame_a[k] == wall.t.n_block ? 1.0 : 2.0;
    const std::ptrdiff_t row = wall.joints + wall.linked + k;
    contact += sides * (magnitude(wall.column_of(wall.t.force, row, 0)) +
                        magnitude(wall.column_of(wall.t.force, row, 1)));
  }
  for (int k = 0; k < wall.crossings; ++k)
    contact += 2.0 * (magnitude(wall.column_of(wall.t.force, wall.first_crossing + k, 0)) +
                      magnitude(wall.column_of(wall.t.force, wall.first_crossing + k, 1)));
  if (wall.first_free >= 0)
    contact += wall.column_of(wall.t.force, wall.first_free + wall.blocks, 3);
  if (contact > 0) return unbalanced / contact;
  return unbalanced > 0 ? 1.0 : 0.0;
}

// Kinetic energy of a body of mass m and inertia I [J].
WYTHE_INLINE double kinetic_of(double m, double I, double vx, double vy, double omega) {
  return 0.5 * m * (vx * vx + vy * vy) + 0.5 * I * omega * omega;
}
// `mass`, `inertia` of its blocks, where they lie closer together than in the tables; or null.
WYTHE_INLINE double kinetic_of(const WallView& wall, const double* mass, const double* inertia,
                               double mass_scaling) {
  double energy = 0;
  for (int i = 0; i < wall.moving_blocks; ++i)
    energy += kinetic_of(mass != nullptr ? mass[i] : wall.cold(i, kMass),
                         inertia != nullptr ? inertia[i] : wall.cold(i, kInertia),
                         wall.block(i, kVx), wall.block(i, kVy), wall.block(i, kOmega));
  for (int i = 0; i < wall.nodes; ++i)
    energy +=
        kinetic_of(wall.node(i, kNodeMass), 0, wall.node(i, kNodeVx), wall.node(i, kNodeVy), 0);
  return energy * mass_scaling;
}

WYTHE_INLINE double shear_of(const WallView& wall, double px, double py) {
  double sum = 0;  // the force on side a, the ground, resists with the opposite sign
  for (int j = wall.first_ground; j < wall.joints; ++j)
    sum += wall.column_of(wall.t.force, j, 0) * px + wall.column_of(wall.t.force, j, 1) * py;
  for (int c = 0; c < wall.edges; ++c)
    if (wall.t.edge_block[c] == wall.t.n_block)
      sum += wall.column_of(wall.t.edge_block_force, c, 0) * px +
             wall.column_of(wall.t.edge_block_force, c, 1) * py;
  for (int k = 0; k < wall.links; ++k)
    if (wall.t.link_a[k] == wall.t.n_block)
      sum += wall.column_of(wall.t.force, wall.joints + k, 0) * px +
             wall.column_of(wall.t.force, wall.joints + k, 1) * py;
  for (int k = 0; k < wall.frames; ++k)
    if (wall.t.frame_a[k] == wall.t.n_block) {
      const std::ptrdiff_t row = wall.joints + wall.linked + k;
      sum += wall.column_of(wall.t.force, row, 0) * px + wall.column_of(wall.t.force, row, 1) * py;
    }
  if (wall.first_free >= 0)
    sum += wall.column_of(wall.t.force, wall.first_free + wall.blocks, 0) * px +
           wall.column_of(wall.t.force, wall.first_free + wall.blocks, 1) * py;
  return sum;
}

// Numbers blocks first, then nodes.
WYTHE_INLINE BlockId runaway_of(const WallView& wall) {
  constexpr double kFast = 100.0;  // [m/s], far beyond any free fall within a wall
  const auto finite = [](double x) { return x - x == 0; };
  // the velocity at its rim, at about sqrt(3) radii of gyration; the rates are dt over mass and inertia
  const auto rim = [&](int i) {
    const double rate = wall.block(i, kRate), turn = wall.block(i, kTurnRate);
    return turn > 0 ? square_root(3 * rate / turn) * magnitude(wall.block(i, kOmega)) : 0.0;
  };
  for (int i = 0; i < wall.blocks; ++i)
    if (!(magnitude(wall.block(i, kVx)) + magnitude(wall.block(i, kVy)) < kFast) ||
        !finite(wall.block(i, kOmega)) || !finite(wall.block(i, kTheta)) || rim(i) >= kFast)
      return i;
  for (int i = 0; i < wall.nodes; ++i)
    if (!(magnitude(wall.node(i, kNodeVx)) + magnitude(wall.node(i, kNodeVy)) < kFast))
      return wall.moving_blocks + i;
  return -1;
}

// The block or node that has moved furthest, and its distance [m]. Blocks are numbered first, then nodes.
struct Furthest {
  double distance = 0;
  BlockId block = 0;
};

// How far block i has moved along (px, py) [m].
WYTHE_INLINE double moved_along(const WallView& wall, BlockId i, double px, double py) {
  return wall.ux(i) * px + wall.uy(i) * py;
}

WYTHE_INLINE Furthest furthest_of(const WallView& wall) {
  double most = 0;
  BlockId block = 0;
  const auto look = [&](double ux, double uy, BlockId i) {
    const double moved = ux * ux + uy * uy;
    if (moved > most) most = moved, block = i;
  };
  for (int i = 0; i < wall.blocks; ++i) look(wall.ux(i), wall.uy(i), i);
  for (int i = 0; i < wall.nodes; ++i)
    look(wall.node(i, kNodeUx), wall.node(i, kNodeUy), wall.moving_blocks + i);
  return {square_root(most), block};
}

}  // namespace wythe::dynamics
