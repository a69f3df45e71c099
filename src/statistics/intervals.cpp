// Evaluates the closed forms (7.2), (7.3), (7.7) and (7.24) to (7.28) of docs/theory/statistics.md.
// Quantiles of F and chi-square come from scatter.cpp. Below kFewestForInterval samples, a mean, a
// CoV and a lognormal give NaN; shares have an interval from one sample on.
#include "statistics/intervals.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "statistics/scatter.h"

namespace wythe::study {
namespace {

constexpr double kTail = 0.025;

}  // namespace

double normal_cdf(double z) { return 0.5 * std::erfc(-z / std::sqrt(2.0)); }

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
  const double p = static_cast<double>(count) / n;
  return {p, score_interval(p, n)};
}

Interval score_interval(double p, double n) {
  const double z2 = kNormal95 * kNormal95;
  const double centre = (p + z2 / (2 * n)) / (1 + z2 / n);
  const double half = kNormal95 / (1 + z2 / n) * std::sqrt(p * (1 - p) / n + z2 / (4.0 * n * n));
  // the end at 0 or 1 is exact, without rounding
  return {p == 0 ? 0 : centre - half, p == 1 ? 1 : centre + half};
}

Estimate exact_share(int count, int n) {
  if (n == 0) return {kUnset, {0, 1}};
  const auto end = [](int k, int rest) {  // below it lies the tail of k or more
    return k / (k + (rest + 1) * f_quantile_beyond(kTail, 2 * (rest + 1), 2 * k));
  };
  return {static_cast<double>(count) / n,
          {count == 0 ? 0 : end(count, n - count), count == n ? 1 : 1 - end(n - count, count)}};
}

Estimate share_estimate(int count, int n) {
  return n < kFewestForBootstrap ? exact_share(count, n) : wilson(count, n);
}

// K = sqrt(chi^2): v / sqrt(((chi^2 + 2)/n - 1) v^2 + chi^2/(n - 1)).
Estimate vangel(double cov, int n) {
  if (n < kFewestForInterval || !std::isfinite(cov)) return {cov, {}};
  const double v2 = cov * cov;
  const auto end = [&](double beyond) {
    const double chi = chi_square_quantile_beyond(beyond, n - 1);
    const double under = ((chi + 2) / n - 1) * v2 + chi / (n - 1);
    return under > 0 ? cov / std::sqrt(under) : std::numeric_limits<double>::infinity();
  };
  return {cov, {end(kTail), end(1 - kTail)}};
}

LognormalIntervals lognormal_intervals(double median, double beta, int observed) {
  LognormalIntervals out;
  if (observed < kFewestForInterval || !(beta > 0)) return out;
  const double r = observed, s = beta * std::sqrt(r / (r - 1));
  const double half = student_95(observed - 1) * s / std::sqrt(r);
  out.median = {median * std::exp(-half), median * std::exp(half)};
  const auto end = [&](double beyond) {
    return s * std::sqrt((r - 1) / chi_square_quantile_beyond(beyond, observed - 1));
  };
  out.beta = {end(kTail), end(1 - kTail)};
  return out;
}

// z = ln(x / median) / hypot(beta, more) by first order in both, on Student's scale.
Interval lognormal_band(double x, double median, double beta, double more, int observed) {
  if (observed < kFewestForInterval || !(beta > 0)) return {};
  if (!(x > 0)) return {0, 0};
  const double r = observed, s = beta * std::sqrt(r / (r - 1)), all = std::hypot(s, more);
  const double part = s * s / (all * all), z = std::log(x / median) / all;
  const double half =
      student_95(observed - 1) * std::sqrt(part / r + z * z * part * part / (2 * (r - 1)));
  return {normal_cdf(z - half), normal_cdf(z + half)};
}

// The median lies below the k-th smallest where fewer than k of n fall below it, P = sum_{i<k} C(n, i) / 2^n (David and
// Nagaraja, Order Statistics, 7.1).
int order_of_median(int n) {
  double term = std::pow(0.5, n), below = term;
  int k = 0;
  while (below <= kTail && k < n / 2) {
    ++k;
    term *= static_cast<double>(n - k + 1) / k;
    below += term;
  }
  return k;
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
  if (n_ < kFewestForInterval) return {mean(), {}};
  const double half = student_95(n_ - 1) * standard_deviation() / std::sqrt(n_);
  return {mean_, {mean_ - half, mean_ + half}};
}

Estimate fisher_z(double r, int n, int controlled, double spread) {
  const int degrees = n - 3 - controlled;
  if (!std::isfinite(r) || degrees < 1) return {r, {}};
  // a few ranks may all agree by chance, though the correlation is smaller
  constexpr double kRounding = 1e-9;
  if (1 - std::fabs(r) < kRounding) return {r, spread > 1 ? Interval{} : Interval{r, r}};
  const double z = std::atanh(r);
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
