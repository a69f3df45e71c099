// The gamma function with the same bits on every machine.
#pragma once

#include <cmath>

#include "core/elementary.h"

namespace wythe {

// ln Gamma(1 + x) for 0 <= x <= 170, relative error some 1e-15 even for tiny x. Gamma(1 + x) = x Gamma(x) reduces x to
// |x| <= 1/2, then -ln(1 + x) + (1 - gamma) x + sum over k >= 2 of (zeta(k) - 1) (-x)^k / k (Abramowitz and Stegun 6.1.33).
inline double log_gamma_1p(double x) {
  constexpr double kOneLessEuler = 0.42278433509846714;
  constexpr double kZetaLess1[] = {
      // zeta(k) - 1 for k = 2, 3, ...
      0.64493406684822644,   0.20205690315959429,   0.082323233711138192,  0.036927755143369926,
      0.01734306198444914,   0.0083492773819228268, 0.0040773561979443394, 0.0020083928260822144,
      9.9457512781808534e-4, 4.9418860411946456e-4, 2.460865533080483e-4,  1.2271334757848915e-4,
      6.1248135058704829e-5, 3.0588236307020494e-5, 1.5282259408651872e-5, 7.6371976378997623e-6,
      3.8172932649998399e-6, 1.9082127165539389e-6, 9.5396203387279611e-7, 4.7693298678780646e-7,
      2.3845050272773299e-7, 1.1921992596531107e-7, 5.960818905125948e-8,  2.980350351465228e-8,
      1.4901554828365041e-8, 7.4507117898354295e-9, 3.7253340247884571e-9};
  double product = 1;
  for (; x > 0.5; x -= 1) product *= x;
  double sum = 0, power = -x;
  int k = 2;
  for (const double zeta : kZetaLess1) {
    power *= -x;
    sum += zeta * power / k++;
  }
  return (sum + kOneLessEuler * x) - elementary::log1p(x) +
         (product == 1 ? 0 : elementary::log(product));
}

}  // namespace wythe
