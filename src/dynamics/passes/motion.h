// Central differences with local damping, one degree of freedom at a time.
#pragma once

#include "core/real.h"

namespace wythe::dynamics {

template <class Real>
struct Moved {
  Real velocity;       // at the next half step
  Real mean_velocity;  // mean of the two half steps, for the work of a force
  Real damping_work;   // [J]
};

// v+ = v- + dt/m (F - lambda |F| sgn v-), sgn(0) = 0 (paper, eqs. 1-2): the damping force opposes
// the velocity with a share of the unbalanced force. `rate` is dt/m.
template <class Real>
[[nodiscard]] WYTHE_INLINE Moved<Real> accelerate(Real v, Real force, Real rate, Real dt,
                                                  Real lambda) {
  const Real zero(0.0), drag = lambda * magnitude(force);
  const Real damping = select(v > zero, zero - drag, select(v < zero, drag, zero));
  const Real v1 = v + rate * (force + damping);
  const Real mean = Real(0.5) * (v + v1);
  return {v1, mean, damping * mean * dt};
}

}  // namespace wythe::dynamics
