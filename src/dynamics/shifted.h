// The arrays of walls side by side (kernels.h), seen from wall `lane`.
#pragma once

#include "dynamics/kernels.h"
#include "dynamics/wall_sums.h"

namespace wythe::dynamics {

template <class... T>
WYTHE_INLINE void shift(std::ptrdiff_t lane, T*&... array) {
  ((array += lane), ...);
}

WYTHE_INLINE JointArrays shifted(JointArrays v, std::ptrdiff_t lane) {
  shift(lane, v.pose, v.force, v.busy, v.kappa, v.crush, v.plastic_slip, v.slip, v.shear_damage,
        v.tension_set);
  return v;
}

WYTHE_INLINE BlockArrays shifted(BlockArrays v, std::ptrdiff_t lane) {
  shift(lane, v.mass, v.heavy_mass, v.inertia, v.is_free, v.contact_x, v.contact_y, v.contact_m,
        v.load_x, v.load_y, v.load_m, v.total_x, v.total_y, v.total_m, v.ux, v.uy, v.theta, v.vx,
        v.vy, v.omega, v.pose);
  return v;
}

WYTHE_INLINE GatherArrays shifted(GatherArrays v, std::ptrdiff_t lane) {
  shift(lane, v.force, v.contact_x, v.contact_y, v.contact_m);
  return v;
}

WYTHE_INLINE ZoneArrays shifted(ZoneArrays v, std::ptrdiff_t lane) {
  shift(lane, v.ux, v.uy, v.low_force, v.high_force);
  return v;
}

WYTHE_INLINE EdgeArrays shifted(EdgeArrays v, std::ptrdiff_t lane) {
  v.joint = shifted(v.joint, lane);
  shift(lane, v.ux, v.uy, v.block_force, v.edge_force);
  return v;
}

WYTHE_INLINE NodeArrays shifted(NodeArrays v, std::ptrdiff_t lane) {
  shift(lane, v.mass, v.heavy_mass, v.total_x, v.total_y, v.ux, v.uy, v.vx, v.vy);
  return v;
}

WYTHE_INLINE MoveControls shifted(MoveControls v, std::ptrdiff_t lane) {
  shift(lane, v.dt, v.damping, v.mass_scaling, v.gravity_x, v.gravity_y);
  return v;
}

WYTHE_INLINE WallView shifted(WallView v, std::ptrdiff_t lane) {
  shift(lane, v.ux.first, v.uy.first, v.theta.first, v.vx.first, v.vy.first, v.omega.first);
  shift(lane, v.contact_x.first, v.contact_y.first, v.contact_m.first);
  shift(lane, v.load_x.first, v.load_y.first, v.load_m.first);
  shift(lane, v.total_x.first, v.total_y.first, v.total_m.first);
  shift(lane, v.is_free.first, v.pose.first, v.force.first);
  shift(lane, v.node_ux.first, v.node_uy.first, v.node_vx.first, v.node_vy.first);
  shift(lane, v.node_total_x.first, v.node_total_y.first, v.contact_block_force.first);
  return v;
}

WYTHE_INLINE WallSizes shifted(WallSizes n, std::ptrdiff_t lane) {
  shift(lane, n.mass.first, n.inertia.first, n.node_mass.first);
  return n;
}

}  // namespace wythe::dynamics
