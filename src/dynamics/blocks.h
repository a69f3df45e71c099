// The block passes of the step: central differences, then poses for the next joint pass.
#pragma once

#include "dynamics/kernels.h"
#include "dynamics/lanes.h"
#include "dynamics/motion.h"

namespace wythe::dynamics {

template <class Real>
struct BlockWork {
  Real loads, damping;  // [J]
};

// The blocks a Real takes from i on; driven ones keep their motion (drive_pass).
template <class Access, class Real>
WYTHE_INLINE void move_block(const BlockArrays& v, Access access, const MoveControls& controls,
                             std::size_t i, BlockWork<Real>& work) {
  const Real zero(0.0), dt = access.of_wall(controls.dt),
                        damping = access.of_wall(controls.damping);
  const Real scale = access.of_wall(controls.mass_scaling);
  const Real heavy = access.own(v.heavy_mass, i), load_m = access.own(v.load_m, i);
  const Real load_x = access.own(v.load_x, i) + heavy * access.of_wall(controls.gravity_x);
  const Real load_y = access.own(v.load_y, i) + heavy * access.of_wall(controls.gravity_y);
  const Real fx = access.own(v.contact_x, i) + load_x, fy = access.own(v.contact_y, i) + load_y;
  const Real fm = access.shared(v.turn_freedom, i) * (access.own(v.contact_m, i) + load_m);
  access.keep(fx, v.total_x, i);
  access.keep(fy, v.total_y, i);
  access.keep(fm, v.total_m, i);
  const auto is_free = access.own(v.is_free, i) > zero;
  const Real rate = dt / (access.own(v.mass, i) * scale);
  const Real turn_rate = dt / (access.own(v.inertia, i) * scale);
  const auto advance = [&](double* velocity, double* place, Real force, Real dt_over_m)
      __attribute__((always_inline)) {
    const Real v0 = access.own(velocity, i), u0 = access.own(place, i);
    const Moved<Real> moved = accelerate(v0, force, dt_over_m, dt, damping);
    access.keep(select(is_free, moved.velocity, v0), velocity, i);
    access.keep(select(is_free, u0 + dt * moved.velocity, u0), place, i);
    return moved;
  };
  const Moved<Real> x = advance(v.vx, v.ux, fx, rate);
  const Moved<Real> y = advance(v.vy, v.uy, fy, rate);
  const Moved<Real> r = advance(v.omega, v.theta, fm, turn_rate);
  const Real loads =
      dt * (load_x * x.mean_velocity + load_y * y.mean_velocity + load_m * r.mean_velocity);
  const Real damped = x.damping_work + y.damping_work + r.damping_work;
  work = {work.loads + select(is_free, loads, zero), work.damping + select(is_free, damped, zero)};
}

template <class Access, class Real, int packs>
WYTHE_INLINE void load_work(Access access, const BlockEnergy& e, BlockWork<Real> (&work)[packs]) {
  for (int k = 0; k < packs; ++k)
    work[k] = {access.energy(e.loads, k), access.energy(e.damping, k)};
}
template <class Access, class Real, int packs>
WYTHE_INLINE void store_work(Access access, const BlockWork<Real> (&work)[packs],
                             const BlockEnergy& e) {
  for (int k = 0; k < packs; ++k) {
    access.keep_energy(work[k].loads, e.loads, k);
    access.keep_energy(work[k].damping, e.damping, k);
  }
}

// Blocks begin..end-1; for packs of neighbours a whole number of groups.
template <class Access>
void move_run(const BlockArrays& v, Access access, const MoveControls& controls, std::size_t begin,
              std::size_t end, const BlockEnergy& energy) {
  BlockWork<typename Access::Real> work[Access::packs];
  load_work(access, energy, work);
  int k = 0;
  for (std::size_t i = begin; i < end; i += Access::advance) {
    move_block(v, access, controls, i, work[k]);
    k = (k + 1) % Access::packs;
  }
  store_work(access, work, energy);
}

template <class Access>
WYTHE_BOTH void turn_run(const BlockArrays& v, Access access, std::size_t begin, std::size_t end) {
  using Real = typename Access::Real;
  for (std::size_t i = begin; i < end; i += Access::advance) {
    const SinCos<Real> turned = sin_cos(Real(0.5) * access.own(v.theta, i));
    access.keep_rows({access.own(v.ux, i), access.own(v.uy, i), turned.cos, turned.sin}, v.pose, i);
  }
}

// Contact force on each block: the joints of which it is side a, then those of which it is side b.
template <class Real>
WYTHE_BOTH void gather_run(const GatherArrays& v, Walls<Real> access, std::size_t begin,
                           std::size_t end) {
  for (std::size_t i = begin; i < end; ++i) {
    Real ax(0.0), ay(0.0), am(0.0), bx(0.0), by(0.0), bm(0.0);
    const auto middle = v.middle[i], last = v.begin[i + 1];
    for (auto e = v.begin[i]; e < middle; ++e) {
      const Rows<Real> f = access.row(v.force, v.entry[e] >> 1);
      ax = ax + f.c0;
      ay = ay + f.c1;
      am = am + f.c2;
    }
    for (auto e = middle; e < last; ++e) {
      const Rows<Real> f = access.row(v.force, v.entry[e] >> 1);
      bx = bx + f.c0;
      by = by + f.c1;
      bm = bm + f.c3;
    }
    access.keep(ax - bx, v.contact_x, i);
    access.keep(ay - by, v.contact_y, i);
    access.keep(am + bm, v.contact_m, i);
  }
}

}  // namespace wythe::dynamics
