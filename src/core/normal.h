// The standard normal distribution with the same bits on every machine: only + - * / and square roots are used.
#pragma once

#include <cmath>

#include "core/elementary.h"

namespace wythe {

// Probability Phi(z), to an ulp: 1/2 plus the density times z + z^3/3 + z^5/(3 5) + ... (Marsaglia 2004). The sum has twice
// the digits of a double, so that the far tail stays exact. |z| <= 9: beyond, the result is 0 or 1 to 1e-19.
inline double normal_share(double z) {
  using namespace elementary;
  if (!(std::fabs(z) < 9)) return z != z ? z : z > 0 ? 1 : 0;
  const Twofold square = product(z, z);
  Twofold term = {z, 0}, total = term;
  for (int n = 3; std::fabs(term.hi) > 1e-33 * std::fabs(total.hi); n += 2) {
    term = term * square / Twofold{double(n), 0};
    total = total + term;
  }
  constexpr Twofold kDensityAtZero = {0.3989422804014327, -2.4923272022777433e-17};
  const Scaled e = exponential<kExponentialTerms>(-0.5 * square);
  const Twofold density = kDensityAtZero * e.value;
  const Twofold part = density * total;
  return rounded(Twofold{0.5, 0} +
                 Twofold{std::ldexp(part.hi, e.power), std::ldexp(part.lo, e.power)});
}

// Quantile z = Phi^-1(u) for 0 < u < 1 by algorithm AS 241 (Wichura 1988), within 2e-16 of z.
inline double normal_quantile(double u) {
  const auto ratio = [](double r, const double(&over)[8], const double(&under)[8]) {
    double a = over[7], b = under[7];
    for (int k = 6; k >= 0; --k) a = a * r + over[k], b = b * r + under[k];
    return a / b;
  };
  const double q = u - 0.5;
  if (std::fabs(q) <= 0.425) {
    constexpr double kOver[8] = {3.3871328727963666080,   1.3314166789178437745e2,
                                 1.9715909503065514427e3, 1.3731693765509461125e4,
                                 4.5921953931549871457e4, 6.7265770927008700853e4,
                                 3.3430575583588128105e4, 2.5090809287301226727e3};
    constexpr double kUnder[8] = {1.0,
                                  4.2313330701600911252e1,
                                  6.8718700749205790830e2,
                                  5.3941960214247511077e3,
                                  2.1213794301586595867e4,
                                  3.9307895800092710610e4,
                                  2.8729085735721942674e4,
                                  5.2264952788528545610e3};
    return q * ratio(0.180625 - q * q, kOver, kUnder);
  }
  const double r = std::sqrt(-elementary::log(q < 0 ? u : 1 - u));
  double z = 0;
  if (r <= 5) {
    constexpr double kOver[8] = {1.42343711074968357734,    4.63033784615654529590,
                                 5.76949722146069140550,    3.64784832476320460504,
                                 1.27045825245236838258,    2.41780725177450611770e-1,
                                 2.27238449892691845833e-2, 7.74545014278341407640e-4};
    constexpr double kUnder[8] = {1.0,
                                  2.05319162663775882187,
                                  1.67638483018380384940,
                                  6.89767334985100004550e-1,
                                  1.48103976427480074590e-1,
                                  1.51986665636164571966e-2,
                                  5.47593808499534494600e-4,
                                  1.05075007164441684324e-9};
    z = ratio(r - 1.6, kOver, kUnder);
  } else {
    constexpr double kOver[8] = {6.65790464350110377720,    5.46378491116411436990,
                                 1.78482653991729133580,    2.96560571828504891230e-1,
                                 2.65321895265761230930e-2, 1.24266094738807843860e-3,
                                 2.71155556874348757815e-5, 2.01033439929228813265e-7};
    constexpr double kUnder[8] = {1.0,
                                  5.99832206555887937690e-1,
                                  1.36929880922735805310e-1,
                                  1.48753612908506148525e-2,
                                  7.86869131145613259100e-4,
                                  1.84631831751005468180e-5,
                                  1.42151175831644588870e-7,
                                  2.04426310338993978564e-15};
    z = ratio(r - 5, kOver, kUnder);
  }
  return q < 0 ? -z : z;
}

}  // namespace wythe
