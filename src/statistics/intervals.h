// Closed-form intervals of 95 %: shares (Wilson), means (Student), correlations (Fisher z).
//
// Called by the other files of statistics; docs/theory/statistics.md has the formulas.
#pragma once

#include <vector>

#include "wythe/statistics.h"

namespace wythe::study {

inline constexpr double kNormal95 = 1.959963984540054;  // quantile of 97.5 % of the normal

[[nodiscard]] double normal_cdf(double z);
// Quantile of the standard normal, 0 < p < 1; Acklam's rational form and one Halley step: 1e-15.
[[nodiscard]] double normal_quantile(double p);
// 97.5 % quantile of Student's t by the expansion of Abramowitz and Stegun 26.7.5: relative error
// below 1e-3 from 4 degrees of freedom on.
[[nodiscard]] double student_95(int degrees);

// Score interval of a share of `count` in `n`; (0, 1) when n = 0.
[[nodiscard]] Estimate wilson(int count, int n);
// Exact interval of the same: it holds the share with at least 95 %, at any n (Clopper and Pearson 1934).
[[nodiscard]] Estimate clopper_pearson(int count, int n);

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

// Value at share p of ascending values, straight between neighbours (Hyndman and Fan, type 7).
[[nodiscard]] double quantile_of(const std::vector<double>& ascending, double p);

}  // namespace wythe::study
