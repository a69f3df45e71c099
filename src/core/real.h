// The scalar types the joint law and the step are written for: double here, Dual in dual.h, SIMD
// packs later. Everything is branch-free through select(); no libm transcendental appears, so that
// the bits are the same on every machine.
#pragma once

#include <algorithm>
#include <cmath>

namespace wythe {

[[nodiscard]] inline double select(bool condition, double yes, double no) {
  return condition ? yes : no;
}
[[nodiscard]] inline double minimum(double a, double b) { return a < b ? a : b; }
[[nodiscard]] inline double maximum(double a, double b) { return a > b ? a : b; }
[[nodiscard]] inline double magnitude(double a) { return std::fabs(a); }
// -1, 0 or 1; 0 at 0 keeps mirror images mirrored (physics: sgn(0) = 0).
[[nodiscard]] inline double sign(double a) { return (a > 0.0 ? 1.0 : 0.0) - (a < 0.0 ? 1.0 : 0.0); }
[[nodiscard]] inline double value_of(double a) { return a; }

// What a comparison of two Reals gives: bool for double and Dual, a mask for a pack.
template <class Real>
using bool_of_t = decltype(Real(0.0) < Real(0.0));

template <class Real>
[[nodiscard]] Real clip(Real a, Real low, Real high) {
  return minimum(maximum(a, low), high);
}

// exp(-x) for x >= 0, zero beyond 45: Taylor of degree 11 at x/256, squared eight times.
// Relative error below 1e-13 (tests/unit/real_test.cpp).
template <class Real>
[[nodiscard]] Real exp_of_minus(Real x) {
  const Real y = minimum(x, Real(45.0)) * Real(-1.0 / 256.0);
  Real p = Real(1.0);
  for (int k = 11; k >= 1; --k) p = Real(1.0) + p * y * Real(1.0 / k);
  for (int k = 0; k < 8; ++k) p = p * p;
  return select(x < Real(45.0), p, Real(0.0));
}

// Sine and cosine by polynomial for |angle| <= pi/2 and beyond by halving: the double-angle formula
// is applied twice, so the polynomial sees angle/4. Absolute error below 4e-16 up to pi.
template <class Real>
struct SinCos {
  Real sin, cos;
};
template <class Real>
[[nodiscard]] SinCos<Real> sin_cos(Real angle) {
  const Real q = angle * Real(0.25);
  const Real z = q * q;
  Real s = Real(1.0), v = Real(1.0);  // sin(q)/q and 2 (1 - cos q)/q^2, Horner from the tail
  for (int k = 17; k >= 3; k -= 2) s = Real(1.0) - s * z * Real(1.0 / (k * (k - 1)));
  for (int k = 18; k >= 4; k -= 2) v = Real(1.0) - v * z * Real(1.0 / (k * (k - 1)));
  Real sine = q * s;
  Real versine = Real(0.5) * z * v;  // 1 - cos, free of cancellation
  for (int k = 0; k < 2; ++k) {
    const Real cosine = Real(1.0) - versine;
    versine = Real(2.0) * sine * sine;
    sine = Real(2.0) * sine * cosine;
  }
  return {sine, Real(1.0) - versine};
}

}  // namespace wythe
