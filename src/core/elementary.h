// Elementary functions with the same bits on every machine. Only +, -, *, / and the square root of IEEE 754 are used, since
// all processors round these alike; library functions differ in the last bit. Each function sums its Taylor series with twice
// the digits of a double (Dekker 1971) and rounds once at the end: the error is below 0.5001 ulp. A call takes a quarter of a
// microsecond to one. Use them to build a model, not in a time step: there sin_cos of core/rotation.h is the choice.
#pragma once

#include <array>
#include <cmath>
#include <limits>

namespace wythe::elementary {

// The sum hi + lo, where |lo| is below half an ulp of hi: some 106 bits in all.
struct Twofold {
  double hi, lo;
};

constexpr Twofold fast_sum(double a, double b) {  // |a| >= |b|
  const double s = a + b;
  return {s, b - (s - a)};
}
constexpr Twofold sum(double a, double b) {
  const double s = a + b, t = s - a;
  return {s, (a - (s - t)) + (b - t)};
}
constexpr Twofold product(double a, double b) {
  const auto split = [](double x) {
    const double c = 134217729.0 * x;  // 2^27 + 1
    return c - (c - x);
  };
  const double p = a * b, a1 = split(a), a2 = a - a1, b1 = split(b), b2 = b - b1;
  return {p, ((a1 * b1 - p) + a1 * b2 + a2 * b1) + a2 * b2};
}
constexpr Twofold operator+(const Twofold& a, const Twofold& b) {
  const Twofold s = sum(a.hi, b.hi), t = sum(a.lo, b.lo);
  const Twofold v = fast_sum(s.hi, s.lo + t.hi);
  return fast_sum(v.hi, v.lo + t.lo);
}
constexpr Twofold operator-(const Twofold& a) { return {-a.hi, -a.lo}; }
constexpr Twofold operator-(const Twofold& a, const Twofold& b) { return a + -b; }
constexpr Twofold operator*(const Twofold& a, const Twofold& b) {
  const Twofold p = product(a.hi, b.hi);
  return fast_sum(p.hi, p.lo + (a.hi * b.lo + a.lo * b.hi));
}
constexpr Twofold operator*(double a, const Twofold& b) { return Twofold{a, 0} * b; }
constexpr Twofold operator/(const Twofold& a, const Twofold& b) {
  const double q = a.hi / b.hi;
  const Twofold r = a - q * b;
  const double q2 = r.hi / b.hi;
  const Twofold r2 = r - q2 * b;
  return fast_sum(q, q2) + Twofold{r2.hi / b.hi, 0};
}
inline Twofold root(const Twofold& a) {
  if (!(a.hi > 0)) return {std::sqrt(a.hi), 0};
  const double s = std::sqrt(a.hi);
  const Twofold rest = a - product(s, s);
  return fast_sum(s, rest.hi / (2 * s));
}
inline double rounded(const Twofold& a) { return a.hi + a.lo; }

inline constexpr Twofold kPi = {3.141592653589793116e+00, 1.224646799147353207e-16};
inline constexpr double kPiRest = -2.994769809718339666e-33;  // the third part of pi, after kPi
inline constexpr Twofold kLn2 = {6.931471805599452862e-01, 2.319046813846299558e-17};
inline constexpr Twofold kOne = {1, 0};

// Coefficients of the series below, computed by the compiler.
template <int kCount>
using Coefficients = std::array<Twofold, kCount>;
// 1/(first)!, 1/(first + step)!, ...; where `sign` is -1 the signs alternate.
template <int kCount>
consteval Coefficients<kCount> inverse_factorials(int first, int step, double sign) {
  Coefficients<kCount> c{};
  Twofold one = kOne;
  double of_term = 1;
  for (int n = 1, k = 0; k < kCount; ++n) {
    if (n - 1 == first + k * step) {
      c[k++] = of_term * one;
      of_term *= sign;
    }
    one = one / Twofold{double(n), 0};
  }
  return c;
}
// 1, sign/3, 1/5, sign/7, ...
template <int kCount>
consteval Coefficients<kCount> inverse_odds(double sign) {
  Coefficients<kCount> c{};
  double of_term = 1;
  for (int k = 0; k < kCount; ++k, of_term *= sign)
    c[k] = Twofold{of_term, 0} / Twofold{2.0 * k + 1, 0};
  return c;
}

// c[0] + c[1] x + c[2] x^2 + ..., the first kTwofold terms with twice the digits. A double has digits enough for the others: they
// are below 2^-28 of the sum for the largest |x| of their series, and rounded to 2^-53 of that.
template <std::size_t kTwofold, std::size_t kCount>
Twofold polynomial(const std::array<Twofold, kCount>& c, const Twofold& x) {
  double small = c[kCount - 1].hi;
  for (std::size_t k = kCount - 1; k-- > kTwofold;) small = small * x.hi + c[k].hi;
  Twofold total = {small, 0};
  for (std::size_t k = kTwofold; k-- > 0;) total = total * x + c[k];
  return total;
}

// --- exponential and logarithm --------------------------------------------------------------------

struct Scaled {
  Twofold value;   // 1 to 2, about
  int power;       // of 2
  Twofold less_1;  // value - 1, kept apart since it loses digits where it is small
};
// e^x = (1 + y)^32 2^k. The squaring is done on y, as 2y + y^2, since 1 + y would lose the digits of a small y. All of its terms are
// twofold where a caller goes on with all digits of the result (core/normal.h); four are enough to round it.
constexpr std::size_t kExponentialTerms = 14, kTermsToRound = 4;
template <std::size_t kTwofold = kTermsToRound>
inline Scaled exponential(const Twofold& x) {
  constexpr int kHalvings = 5;
  const double k = std::nearbyint(x.hi / kLn2.hi);
  const Twofold r = (1.0 / 32) * (x - k * kLn2);
  constexpr auto kTerms = inverse_factorials<kExponentialTerms>(1, 1, 1);
  Twofold y = r * polynomial<kTwofold>(kTerms, r);  // |r| <= ln 2 / 64
  for (int i = 0; i < kHalvings; ++i) y = y * y + 2.0 * y;
  return {kOne + y, static_cast<int>(k), y};
}
inline Twofold logarithm(const Twofold& x) {
  int power = 0;
  if (std::frexp(x.hi, &power) < 0.70710678118654752440) --power;
  const Twofold m = {std::ldexp(x.hi, -power), std::ldexp(x.lo, -power)};  // about 1
  const Twofold s = (m - kOne) / (m + kOne);
  constexpr auto kTerms = inverse_odds<23>(1);
  return double(power) * kLn2 + 2.0 * (s * polynomial<5>(kTerms, s * s));  // s^2 <= 0.0295
}

inline double exp(double x) {
  if (!(std::fabs(x) < 746))
    return x != x ? x : x > 0 ? std::numeric_limits<double>::infinity() : 0;
  const Scaled e = exponential({x, 0});
  return std::ldexp(rounded(e.value), e.power);
}
inline double log(double x) {
  if (!(x > 0) || x > std::numeric_limits<double>::max())
    return x == 0  ? -std::numeric_limits<double>::infinity()
           : x > 0 ? x
                   : std::numeric_limits<double>::quiet_NaN();
  return rounded(logarithm({x, 0}));
}
inline double expm1(double x) {
  if (!(std::fabs(x) < 700)) return exp(x) - 1;
  if (std::fabs(x) < 1e-300) return x;
  const Scaled e = exponential({x, 0});
  if (e.power == 0) return rounded(e.less_1);
  return rounded(Twofold{std::ldexp(e.value.hi, e.power), std::ldexp(e.value.lo, e.power)} - kOne);
}
inline double log1p(double x) {
  if (!(x > -1) || x > std::numeric_limits<double>::max()) return log(1 + x);
  return std::fabs(x) < 1e-300 ? x : rounded(logarithm(sum(1, x)));
}
inline double log10(double x) {
  constexpr Twofold kLn10 = {2.302585092994045901e+00, -2.170756223382249351e-16};
  return x > 0 && x <= std::numeric_limits<double>::max() ? rounded(logarithm({x, 0}) / kLn10)
                                                          : log(x);
}
inline double pow(double x, double y) {
  if (y == 0 || x == 1) return 1;
  if (x != x || y != y) return x + y;
  const double size = std::fabs(x);
  const bool is_whole = std::nearbyint(y) == y;
  const bool is_odd = is_whole && std::fabs(y) < 9007199254740992.0 && std::fmod(y, 2) != 0;
  if (x < 0 && !is_whole) return std::numeric_limits<double>::quiet_NaN();
  const double sign = x < 0 && is_odd ? -1 : 1;
  if (size == 0 || std::isinf(x) || std::isinf(y)) {  // exact on every machine: nothing is rounded
    return std::pow(x, y);
  }
  const Twofold e = Twofold{y, 0} * logarithm({size, 0});
  if (!(std::fabs(e.hi) < 746))
    return sign * (e.hi > 0 ? std::numeric_limits<double>::infinity() : 0);
  const Scaled s = exponential(e);
  return sign * std::ldexp(rounded(s.value), s.power);
}
inline double cbrt(double x) {
  if (x == 0 || !(std::fabs(x) <= std::numeric_limits<double>::max())) return x;
  const Scaled s = exponential(logarithm({std::fabs(x), 0}) / Twofold{3, 0});
  return std::copysign(std::ldexp(rounded(s.value), s.power), x);
}

// --- angles ---------------------------------------------------------------------------------------

// An angle less quarter turns, within an eighth of a turn.
struct Angle {
  Twofold rest;
  long quarters;
};
inline Angle less_quarters(double x) {
  const double k = std::nearbyint(x / (kPi.hi / 2));
  return {Twofold{x, 0} - (k / 2) * kPi - Twofold{k / 2 * kPiRest, 0}, static_cast<long>(k)};
}
// The sine of the angle and of `more` quarter turns.
inline Twofold sine(const Angle& angle, long more) {
  const Twofold& r = angle.rest;
  const Twofold r2 = r * r;  // <= pi^2 / 16
  constexpr auto kSine = inverse_factorials<16>(1, 2, -1),
                 kCosine = inverse_factorials<16>(0, 2, -1);
  const long quarters = angle.quarters + more;
  const Twofold size =
      (quarters & 1) == 0 ? r * polynomial<5>(kSine, r2) : polynomial<6>(kCosine, r2);
  return (quarters & 2) == 0 ? size : -size;
}
inline constexpr double kFarthest = 1e9;  // beyond this an angle has no digits left [rad]
inline double sin(double x) {
  return std::fabs(x) < kFarthest ? (x == 0 ? x : rounded(sine(less_quarters(x), 0)))
                                  : std::numeric_limits<double>::quiet_NaN();
}
inline double cos(double x) {
  return std::fabs(x) < kFarthest ? rounded(sine(less_quarters(x), 1))
                                  : std::numeric_limits<double>::quiet_NaN();
}
inline double tan(double x) {
  if (x == 0) return x;
  if (!(std::fabs(x) < kFarthest)) return std::numeric_limits<double>::quiet_NaN();
  const Angle angle = less_quarters(x);
  return rounded(sine(angle, 0) / sine(angle, 1));
}

// The arctangent of a quotient t between 0 and 1.
inline Twofold arctangent(Twofold t) {
  for (int i = 0; i < 2; ++i) t = t / (kOne + root(kOne + t * t));
  constexpr auto kTerms = inverse_odds<25>(-1);
  return 4.0 * (t * polynomial<6>(kTerms, t * t));  // t^2 <= 0.0396
}
// The angle of the point (x, y) with y >= 0. Both are hi + lo, and not both are 0.
inline Twofold angle(const Twofold& y, const Twofold& x) {
  const bool left = x.hi < 0;
  const Twofold ax = left ? -x : x;
  const Twofold first = ax.hi >= y.hi ? arctangent(y / ax) : 0.5 * kPi - arctangent(ax / y);
  return left ? kPi - first : first;
}
inline double atan2(double y, double x) {
  if (x != x || y != y) return x + y;
  if (y == 0) return std::signbit(x) ? std::copysign(kPi.hi, y) : y;
  const double big = std::fmax(std::fabs(x), std::fabs(y));
  if (std::isinf(big)) {
    const double one = std::isinf(x) ? std::copysign(1, x) : 0, up = std::isinf(y) ? 1 : 0;
    return std::copysign(up == 0 && one > 0 ? 0.0 : rounded(angle({up, 0}, {one, 0})), y);
  }
  int power = 0;
  static_cast<void>(std::frexp(big, &power));
  const double sy = std::ldexp(std::fabs(y), -power), sx = std::ldexp(x, -power);
  if (sy == 0) return std::copysign(sx > 0 ? std::fabs(y) / x : kPi.hi, y);
  return std::copysign(rounded(angle({sy, 0}, {sx, 0})), y);
}
inline double atan(double x) { return atan2(x, 1); }
inline double asin(double x) {
  if (x == 0) return x;
  const Twofold c = root(sum(1, -std::fabs(x)) * sum(1, std::fabs(x)));
  return std::fabs(x) <= 1 ? std::copysign(rounded(angle({std::fabs(x), 0}, c)), x)
                           : std::numeric_limits<double>::quiet_NaN();
}
inline double acos(double x) {
  if (x == 1) return 0;
  const Twofold s = root(sum(1, -std::fabs(x)) * sum(1, std::fabs(x)));
  return std::fabs(x) <= 1 ? rounded(angle(s, {x, 0})) : std::numeric_limits<double>::quiet_NaN();
}
inline double hypot(double x, double y) {
  const double big = std::fmax(std::fabs(x), std::fabs(y));
  if (std::isinf(x) || std::isinf(y)) return std::numeric_limits<double>::infinity();
  if (x != x || y != y || big == 0) return x != x ? x : y != y ? y : 0;
  int power = 0;
  static_cast<void>(std::frexp(big, &power));
  const double a = std::ldexp(x, -power), b = std::ldexp(y, -power);
  return std::ldexp(rounded(root(product(a, a) + product(b, b))), power);
}

inline double hypot(double x, double y, double z) { return hypot(hypot(x, y), z); }

}  // namespace wythe::elementary
