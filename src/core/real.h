// The scalar types of the joint law and the step: double here, Dual in dual.h, SIMD packs in pack.h.
// Branches are written as select(), and no transcendental function of libm is called, so that the bits
// are the same on every machine.
#pragma once

#include <algorithm>
#include <cmath>

// The optimiser would call parts of a hot kernel as functions (3x slower), so they are always inlined.
#define WYTHE_INLINE [[gnu::always_inline]] inline
#define WYTHE_OUTLINE [[gnu::noinline]]

namespace wythe {

[[nodiscard]] WYTHE_INLINE double select(bool condition, double yes, double no) {
  return condition ? yes : no;
}
[[nodiscard]] WYTHE_INLINE double minimum(double a, double b) { return a < b ? a : b; }
[[nodiscard]] WYTHE_INLINE double maximum(double a, double b) { return a > b ? a : b; }
[[nodiscard]] WYTHE_INLINE double magnitude(double a) { return std::fabs(a); }
[[nodiscard]] WYTHE_INLINE double square_root(double a) {
  return std::sqrt(a);
}  // IEEE: exact bits
// -1, 0 or 1. It is 0 at 0, so that mirrored walls give mirrored results.
[[nodiscard]] WYTHE_INLINE double sign(double a) {
  return (a > 0.0 ? 1.0 : 0.0) - (a < 0.0 ? 1.0 : 0.0);
}
[[nodiscard]] WYTHE_INLINE double value_of(double a) { return a; }
// True where at least one lane is true. It skips work that would change no lane.
[[nodiscard]] WYTHE_INLINE bool any(bool condition) { return condition; }
[[nodiscard]] WYTHE_INLINE bool all(bool condition) { return condition; }

// Type of a comparison of two Reals: bool for double and Dual, a mask for a pack.
template <class Real>
using bool_of_t = decltype(Real(0.0) < Real(0.0));

template <class Real>
[[nodiscard]] WYTHE_INLINE Real clip(Real a, Real low, Real high) {
  return minimum(maximum(a, low), high);
}

// exp(-x) for x >= 0, zero beyond 45: Taylor series of degree 11 at x/256, squared eight times.
// Relative error below 1e-13 (tests/unit/core/real_test.cpp).
template <class Real>
[[nodiscard]] WYTHE_INLINE Real exp_of_minus(Real x) {
  const Real y = minimum(x, Real(45.0)) * Real(-1.0 / 256.0);
  Real p = Real(1.0);
  for (int k = 11; k >= 1; --k) p = Real(1.0) + p * y * Real(1.0 / k);
  for (int k = 0; k < 8; ++k) p = p * p;
  return select(x < Real(45.0), p, Real(0.0));
}

template <class Real>
struct SinCos {
  Real sin, cos;
};

namespace detail {
// sin(q)/q and 2 (1 - cos q)/q^2 by Taylor series up to q^last, evaluated by Horner's rule.
template <int last, class Real>
WYTHE_INLINE void sine_series(Real z, Real& s, Real& v) {
  s = Real(1.0);
  v = Real(1.0);
#pragma GCC unroll 16
  for (int k = last; k >= 3; k -= 2) {
    s = Real(1.0) - s * z * Real(1.0 / (k * (k - 1)));
    v = Real(1.0) - v * z * Real(1.0 / ((k + 1) * k));
  }
}
}  // namespace detail

namespace detail {
// An angle without its full turns, after Cody and Waite: 2 pi in two parts, the first of which is exact times a count of turns.
template <class Real>
[[nodiscard]] WYTHE_INLINE Real within_a_turn(Real angle) {
  constexpr double kTurn = 6.283185243606567, kRest = 6.357301909411278e-08;
  constexpr double kRounder =
      6755399441055744.0;  // 1.5 x 2^52: a number added to it loses its fraction
  const Real turns = (angle * Real(1 / (kTurn + kRest)) + Real(kRounder)) - Real(kRounder);
  return (angle - turns * Real(kTurn)) - turns * Real(kRest);
}
}  // namespace detail

// Sine and cosine by polynomials. For |angle| <= 1/8, as in every block short of collapse, the degree is 9. Beyond,
// a polynomial of degree 17 in angle/4 is followed by two double-angle formulas. Above 4, for blocks that roll, full
// turns are removed first.
// The absolute error is below 2e-15 up to pi, 1e-13 up to a thousand turns. The choice depends on the angle alone.
template <class Real>
[[nodiscard]] WYTHE_INLINE SinCos<Real> sin_cos(Real angle) {
  const Real one(1.0), half(0.5), two(2.0);
  Real s, v;
  detail::sine_series<9>(angle * angle, s, v);
  SinCos<Real> small{angle * s, one - half * angle * angle * v};
  const auto large = magnitude(angle) > Real(0.125);
  if (!any(large)) return small;
  const auto turns = magnitude(angle) > Real(4.0);
  if (any(turns)) angle = select(turns, detail::within_a_turn(angle), angle);
  const Real q = angle * Real(0.25);
  detail::sine_series<17>(q * q, s, v);
  Real sine = q * s;
  Real versine = half * q * q * v;  // 1 - cos, without cancellation
  for (int k = 0; k < 2; ++k) {
    const Real cosine = one - versine;
    versine = two * sine * sine;
    sine = two * sine * cosine;
  }
  return {select(large, sine, small.sin), select(large, one - versine, small.cos)};
}

}  // namespace wythe
