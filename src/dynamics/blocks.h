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

// Block i and its Lanes<Real>::width - 1 neighbours; driven ones keep their motion (drive_pass).
template <class Real>
WYTHE_INLINE void move_block(const BlockArrays& v, const MoveControls& controls, std::size_t i,
                             BlockWork<Real>& work) {
  using L = Lanes<Real>;
  const Real zero(0.0), dt(controls.dt), damping(controls.damping), scale(controls.mass_scaling);
  const Real heavy = L::load(v.heavy_mass + i), load_m = L::load(v.load_m + i);
  const Real load_x = L::load(v.load_x + i) + heavy * Real(controls.gravity_x);
  const Real load_y = L::load(v.load_y + i) + heavy * Real(controls.gravity_y);
  const Real fx = L::load(v.contact_x + i) + load_x, fy = L::load(v.contact_y + i) + load_y;
  const Real fm = L::load(v.turn_freedom + i) * (L::load(v.contact_m + i) + load_m);
  L::store(fx, v.total_x + i);
  L::store(fy, v.total_y + i);
  L::store(fm, v.total_m + i);
  const auto is_free = L::load(v.is_free + i) > zero;
  const Real m = L::load(v.mass + i) * scale, inertia = L::load(v.inertia + i) * scale;
  const auto advance = [&](double* velocity, double* place, Real force, Real inert)
      __attribute__((always_inline)) {
    const Real v0 = L::load(velocity + i), u0 = L::load(place + i);
    const Moved<Real> moved = accelerate(v0, force, inert, dt, damping);
    L::store(select(is_free, moved.velocity, v0), velocity + i);
    L::store(select(is_free, u0 + dt * moved.velocity, u0), place + i);
    return moved;
  };
  const Moved<Real> x = advance(v.vx, v.ux, fx, m);
  const Moved<Real> y = advance(v.vy, v.uy, fy, m);
  const Moved<Real> r = advance(v.omega, v.theta, fm, inertia);
  const Real loads =
      dt * (load_x * x.mean_velocity + load_y * y.mean_velocity + load_m * r.mean_velocity);
  const Real damped = x.damping_work + y.damping_work + r.damping_work;
  work = {work.loads + select(is_free, loads, zero), work.damping + select(is_free, damped, zero)};
}

template <class Real, int packs>
WYTHE_INLINE void load_work(const BlockLanes& lanes, BlockWork<Real> (&work)[packs]) {
  using L = Lanes<Real>;
  for (int k = 0; k < packs; ++k)
    work[k] = {L::load(lanes.loads + k * L::width), L::load(lanes.damping + k * L::width)};
}
template <class Real, int packs>
WYTHE_INLINE void store_work(const BlockWork<Real> (&work)[packs], BlockLanes& lanes) {
  using L = Lanes<Real>;
  for (int k = 0; k < packs; ++k) {
    L::store(work[k].loads, lanes.loads + k * L::width);
    L::store(work[k].damping, lanes.damping + k * L::width);
  }
}

// Blocks begin..end-1; for packs a whole number of groups.
template <class Real>
void move_run(const BlockArrays& v, const MoveControls& controls, std::size_t begin,
              std::size_t end, BlockLanes& lanes) {
  using L = Lanes<Real>;
  constexpr int packs = kGroup / L::width;
  BlockWork<Real> work[packs];
  load_work(lanes, work);
  int k = 0;
  for (std::size_t i = begin; i < end; i += static_cast<std::size_t>(L::width)) {
    move_block(v, controls, i, work[k]);
    k = (k + 1) % packs;
  }
  store_work(work, lanes);
}

template <class Real>
void turn_run(const BlockArrays& v, std::size_t begin, std::size_t end) {
  using L = Lanes<Real>;
  for (std::size_t i = begin; i < end; i += static_cast<std::size_t>(L::width)) {
    const SinCos<Real> turned = sin_cos(Real(0.5) * L::load(v.theta + i));
    L::store_rows({L::load(v.ux + i), L::load(v.uy + i), turned.cos, turned.sin}, v.pose + 4 * i);
  }
}

}  // namespace wythe::dynamics
