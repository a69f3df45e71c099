#include "statistics/intervals.h"

#include <algorithm>
#include <cmath>

namespace wythe::study {
namespace {

constexpr int kFewestForStudent = 5;

double polynomial(const double* coefficient, int count, double x) {
  double sum = 0;
  for (int i = 0; i < count; ++i) sum = sum * x + coefficient[i];
  return sum;
}

// Lower tail and middle of Acklam's approximation, relative error 1.2e-9.
double rough_normal_quantile(double p) {
  static constexpr double kA[] = {-3.969683028665376e+01, 2.209460984245205e+02,
                                  -2.759285104469687e+02, 1.383577518672690e+02,
                                  -3.066479806614716e+01, 2.506628277459239e+00};
  static constexpr double kB[] = {-5.447609879822406e+01, 1.615858368580409e+02,
                                  -1.556989798598866e+02, 6.680131188771972e+01,
                                  -1.328068155288572e+01, 1};
  static constexpr double kC[] = {-7.784894002430293e-03, -3.223964580411365e-01,
                                  -2.400758277161838e+00, -2.549732539343734e+00,
                                  4.374664141464968e+00,  2.938163982698783e+00};
  static constexpr double kD[] = {7.784695709041462e-03, 3.224671290700398e-01,
                                  2.445134137142996e+00, 3.754408661907416e+00, 1};
  if (p > 0.5) return -rough_normal_quantile(1 - p);
  if (p < 0.02425) {
    const double q = std::sqrt(-2 * std::log(p));
    return polynomial(kC, 6, q) / polynomial(kD, 5, q);
  }
  const double q = p - 0.5;
  return q * polynomial(kA, 6, q * q) / polynomial(kB, 6, q * q);
}

}  // namespace

double normal_cdf(double z) { return 0.5 * std::erfc(-z / std::sqrt(2.0)); }

double normal_quantile(double p) {
  const double z = rough_normal_quantile(p);
  constexpr double kRootTwoPi = 2.5066282746310002;
  const double step = (normal_cdf(z) - p) * kRootTwoPi * std::exp(z * z / 2);
  return z - step / (1 + z * step / 2);
}

double student_95(int degrees) {
  const double z = kNormal95, z2 = z * z, nu = degrees;
  const double g1 = z * (z2 + 1) / 4;
  const double g2 = z * ((5 * z2 + 16) * z2 + 3) / 96;
  const double g3 = z * (((3 * z2 + 19) * z2 + 17) * z2 - 15) / 384;
  const double g4 = z * ((((79 * z2 + 776) * z2 + 1482) * z2 - 1920) * z2 - 945) / 92160;
  return z + (g1 + (g2 + (g3 + g4 / nu) / nu) / nu) / nu;
}

Estimate wilson(int count, int n) {
  if (n == 0) return {kUnset, {0, 1}};
  const double p = static_cast<double>(count) / n, z2 = kNormal95 * kNormal95;
  const double centre = (p + z2 / (2 * n)) / (1 + z2 / n);
  const double half = kNormal95 / (1 + z2 / n) * std::sqrt(p * (1 - p) / n + z2 / (4.0 * n * n));
  // the end at 0 or 1 is exact, not what rounding leaves of it
  return {p, {count == 0 ? 0 : centre - half, count == n ? 1 : centre + half}};
}

namespace {
// P(X <= k) of n trials, each with chance p in (0, 1).
double binomial_cdf(int k, int n, double p) {
  double sum = 0;
  for (int i = 0; i <= k; ++i)
    sum += std::exp(std::lgamma(n + 1.0) - std::lgamma(i + 1.0) - std::lgamma(n - i + 1.0) +
                    i * std::log(p) + (n - i) * std::log1p(-p));
  return sum;
}
// The chance at which k or fewer of n have this probability: it falls as the chance grows.
double chance_of(int k, int n, double probability) {
  double low = 0, high = 1;
  for (int i = 0; i < 60; ++i) {
    const double p = 0.5 * (low + high);
    (binomial_cdf(k, n, p) > probability ? low : high) = p;
  }
  return 0.5 * (low + high);
}
}  // namespace

Estimate clopper_pearson(int count, int n) {
  if (n == 0) return {kUnset, {0, 1}};
  constexpr double kTail = 0.025;
  return {static_cast<double>(count) / n,
          {count == 0 ? 0 : chance_of(count - 1, n, 1 - kTail),
           count == n ? 1 : chance_of(count, n, kTail)}};
}

void Moments::add(double value) {
  ++n_;
  const double from_old = value - mean_;
  mean_ += from_old / n_;
  squares_ += from_old * (value - mean_);
}

double Moments::standard_deviation() const {
  return n_ > 1 ? std::sqrt(squares_ / (n_ - 1)) : kUnset;
}

Estimate Moments::student() const {
  if (n_ < kFewestForStudent) return {mean(), {}};
  const double half = student_95(n_ - 1) * standard_deviation() / std::sqrt(n_);
  return {mean_, {mean_ - half, mean_ + half}};
}

Estimate fisher_z(double r, int n, int controlled, double spread) {
  const int degrees = n - 3 - controlled;
  if (!std::isfinite(r) || degrees < 1) return {r, {}};
  const double z = std::atanh(std::clamp(r, -1.0, 1.0));
  if (!std::isfinite(z)) return {r, {r, r}};
  const double half = kNormal95 * std::sqrt(spread / degrees);
  return {r, {std::tanh(z - half), std::tanh(z + half)}};
}

double quantile_of(const std::vector<double>& ascending, double p) {
  if (ascending.empty()) return kUnset;
  const double place = p * static_cast<double>(ascending.size() - 1);
  const auto below = static_cast<std::size_t>(std::floor(place));
  const std::size_t above = std::min(below + 1, ascending.size() - 1);
  const double low = ascending[below], high = ascending[above];
  return low == high ? low : low + (place - std::floor(place)) * (high - low);
}

}  // namespace wythe::study
