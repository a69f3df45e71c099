// Closed-form intervals of 95 %: shares (Clopper and Pearson, Wilson), means (Student), coefficients of variation
// (Vangel), medians (order statistics), correlations (Fisher z).
//
// A bootstrap interval of few samples contains the true value less often than stated. So only closed
// forms are used below kFewestForBootstrap; tests/verification/small_samples_test.cpp measures their
// coverage. Called by the other files of statistics; docs/theory/statistics.md has the formulas.
#pragma once

#include <vector>

#include "core/normal.h"
#include "wythe/parts/statistics.h"

namespace wythe::study {

inline constexpr double kNormal95 = 1.959963984540054;  // quantile of 97.5 % of the normal

[[nodiscard]] double normal_cdf(double z);
using wythe::normal_quantile;
// 97.5 % quantile of Student's t by the expansion of Abramowitz and Stegun 26.7.5: relative error
// below 1e-3 from 4 degrees of freedom on.
[[nodiscard]] double student_95(int degrees);

inline constexpr int kFewestForInterval = 5;  // with fewer samples their scatter is not known well
inline constexpr int kFewestForBootstrap = 100;  // below, closed forms

// A share of `count` in `n`: the exact interval for few samples, Wilson's for many.
[[nodiscard]] Estimate share_estimate(int count, int n);
// Clopper and Pearson 1934: covers at least 95 % for any share.
[[nodiscard]] Estimate exact_share(int count, int n);
// Score interval of a share of `count` in `n`; (0, 1) when n = 0.
[[nodiscard]] Estimate wilson(int count, int n);
// The same of a share p of n, which may be no whole number; n > 0.
[[nodiscard]] Interval score_interval(double p, double n);

// Running count, mean and standard deviation (Welford).
class Moments {
 public:
  void add(double value);
  [[nodiscard]] int n() const { return n_; }
  [[nodiscard]] double mean() const { return n_ > 0 ? mean_ : kUnset; }
  [[nodiscard]] double standard_deviation() const;  // divisor n - 1; NaN below two values
  [[nodiscard]] Estimate student() const;           // mean and its interval, from five values on
 private:
  int n_ = 0;
  double mean_ = 0, squares_ = 0;
};

// Fisher's z: tanh(atanh(r) +- 1.96 sqrt(spread / (n - 3 - controlled))); `spread` is 1 for Pearson's
// r, 1 + r^2/2 for Spearman's (Bonett and Wright 2000).
[[nodiscard]] Estimate fisher_z(double r, int n, int controlled, double spread);

// The interval of a coefficient of variation of n normal values (Vangel 1996); none below kFewestForInterval.
[[nodiscard]] Estimate vangel(double cov, int n);
// Intervals for median and scatter of a lognormal fit with `observed` observed values and the dispersion beta of maximum
// likelihood: Student and chi-square of the logarithms. Lower bounds improve the fit, but do not count for its certainty.
struct LognormalIntervals {
  Interval median, beta;
};
[[nodiscard]] LognormalIntervals lognormal_intervals(double median, double beta, int observed);
// The interval of the share below x of that law, P = phi(ln(x / median) / hypot(beta, more)).
[[nodiscard]] Interval lognormal_band(double x, double median, double beta, double more,
                                      int observed);

// The largest k for which the k-th smallest and the k-th largest of n contain the median with 95 % (7.24); 0 if none does.
[[nodiscard]] int order_of_median(int n);

// The value at share p of ascending values, linear between neighbours (Hyndman and Fan, type 7).
[[nodiscard]] double quantile_of(const std::vector<double>& ascending, double p);

}  // namespace wythe::study
