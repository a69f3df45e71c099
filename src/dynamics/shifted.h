// The arrays of walls side by side (kernels.h), seen from wall `lane`.
#pragma once

#include "dynamics/kernels.h"

namespace wythe::dynamics {

WYTHE_INLINE JointArrays shifted(JointArrays v, std::ptrdiff_t lane) {
  v.pose += lane;
  v.force += lane;
  v.busy += lane;
  v.kappa += lane;
  v.crush += lane;
  v.plastic_slip += lane;
  v.slip += lane;
  v.shear_damage += lane;
  v.tension_set += lane;
  return v;
}

WYTHE_INLINE BlockArrays shifted(BlockArrays v, std::ptrdiff_t lane) {
  v.mass += lane;
  v.heavy_mass += lane;
  v.inertia += lane;
  v.is_free += lane;
  v.contact_x += lane;
  v.contact_y += lane;
  v.contact_m += lane;
  v.load_x += lane;
  v.load_y += lane;
  v.load_m += lane;
  v.total_x += lane;
  v.total_y += lane;
  v.total_m += lane;
  v.ux += lane;
  v.uy += lane;
  v.theta += lane;
  v.vx += lane;
  v.vy += lane;
  v.omega += lane;
  v.pose += lane;
  return v;
}

WYTHE_INLINE GatherArrays shifted(GatherArrays v, std::ptrdiff_t lane) {
  v.force += lane;
  v.contact_x += lane;
  v.contact_y += lane;
  v.contact_m += lane;
  return v;
}

WYTHE_INLINE ZoneArrays shifted(ZoneArrays v, std::ptrdiff_t lane) {
  v.ux += lane;
  v.uy += lane;
  v.low_force += lane;
  v.high_force += lane;
  return v;
}

WYTHE_INLINE EdgeArrays shifted(EdgeArrays v, std::ptrdiff_t lane) {
  v.joint = shifted(v.joint, lane);
  v.ux += lane;
  v.uy += lane;
  v.block_force += lane;
  v.edge_force += lane;
  return v;
}

WYTHE_INLINE NodeArrays shifted(NodeArrays v, std::ptrdiff_t lane) {
  v.mass += lane;
  v.heavy_mass += lane;
  v.total_x += lane;
  v.total_y += lane;
  v.ux += lane;
  v.uy += lane;
  v.vx += lane;
  v.vy += lane;
  return v;
}

}  // namespace wythe::dynamics
