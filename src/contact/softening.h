// Softening shapes g(x): remaining share of strength after the inelastic displacement x, scaled so
// that g(0) = 1 and the area under g is 1. With x = w_in ft/GI (tension) or s (t0 - tr)/GII (shear)
// every shape dissipates exactly GI or GII (docs/theory/joint_law.md, eq. 3.4).
//
//   bilinear     1 - x/2                           up to x = 2
//   exponential  exp(-x)                           Lourenco & Rots 1997
//   polynomial   (1 - x/3)^2                       up to x = 3
//   petersson    1 -> 1/3 at x = 0.8 -> 0 at 3.6   Petersson 1981
#pragma once

#include "core/real.h"
#include "wythe/parts/contact_law.h"

namespace wythe::contact {

template <class Real>
struct Shape {
  Real left;   // g
  Real slope;  // dg/dx, <= 0
};

template <class Real>
[[nodiscard]] WYTHE_INLINE Shape<Real> soften(Softening kind, Real x) {
  const Real zero(0.0), one(1.0);
  if (kind == Softening::kBilinear) {
    const Real g = maximum(zero, one - Real(0.5) * x);
    return {g, select(g > zero, Real(-0.5), zero)};
  } else if (kind == Softening::kExponential) {
    const Real g = exp_of_minus(x);
    return {g, zero - g};
  } else if (kind == Softening::kPolynomial) {
    const Real r = maximum(zero, one - x * Real(1.0 / 3.0));
    return {r * r, Real(-2.0 / 3.0) * r};
  } else {
    const Real first = one - x * Real(2.0 / 2.4);
    const Real second = maximum(zero, (Real(3.6) - x) * Real(1.0 / 8.4));
    const Real tail = select(second > zero, Real(-1.0 / 8.4), zero);
    return {select(x < Real(0.8), first, second), select(x < Real(0.8), Real(-2.0 / 2.4), tail)};
  }
}

// Steepest slope of each shape, for the check of snap-back.
[[nodiscard]] constexpr double steepest_slope(Softening kind) {
  switch (kind) {
    case Softening::kBilinear: return 0.5;
    case Softening::kExponential: return 1.0;
    case Softening::kPolynomial: return 2.0 / 3.0;
    case Softening::kPetersson: return 2.0 / 2.4;
  }
  return 1.0;
}

}  // namespace wythe::contact
