// From a share of probability to the value of one variable, by closed forms: normal, lognormal, uniform, triangular, beta,
// Weibull and measured values, with truncation (docs/theory/statistics.md).
#pragma once

#include <functional>
#include <vector>

#include "wythe/parts/study.h"

namespace wythe {

// The distribution without truncation; the functions are empty for measured values.
struct Distribution {
  std::function<double(double x)> below, above;  // shares on either side of x
  std::function<double(double x)> density;       // [1/SI]
  std::function<double(double u)> quantile;      // value with the share u below it, 0 < u < 1 [SI]
};

// A zero of f between low and high, where f changes sign, to the last bits (Alefeld, Potra and Shi 1995, algorithm 748).
[[nodiscard]] double root_between(const std::function<double(double)>& f, double low, double high);

// One variable's distribution; `spec` must have passed its check (check_variable in study_check.h).
class Margin {
 public:
  // Throws std::domain_error where no distribution of the kind has these numbers.
  explicit Margin(const VariableSpec& spec);

  // Value below which a share `u` of the truncated distribution lies [SI]; 0 < u < 1.
  [[nodiscard]] double quantile(double u) const;
  // Density of the truncated distribution [1/SI]; 0 everywhere for measured values.
  [[nodiscard]] double density(double x) const;
  // Share of the distribution without truncation that lies outside `lower` and `upper`.
  [[nodiscard]] double cut_off() const { return below_ + above_; }
  // The remaining share, never below 0.
  [[nodiscard]] double kept() const;

 private:
  Distribution stated_;
  std::vector<double> values_;    // empirical: those inside the truncation, in order
  double lower_, upper_;          // -inf, inf where there is no truncation
  double below_ = 0, above_ = 0;  // probability cut off at either end
};

}  // namespace wythe
