// Probability of an event given one or two inputs: regression of outcomes that are 0 or 1.
//
//   logistic   P = 1 / (1 + exp(-eta))          eta = b0 + b1 x1 (+ b2 x2)
//   lognormal  P = Phi(eta)                     the same in ln x: Phi(ln(x / theta) / beta)
//
// Maximum likelihood by Fisher scoring; equations (7.14) to (7.18) of docs/theory/statistics.md. References:
// McCullagh and Nelder, Generalized Linear Models (1989); Hosmer and Lemeshow, Applied Logistic Regression
// (2000); Albert and Anderson, Biometrika 71 (1984), for separation.
#pragma once

#include <array>
#include <functional>
#include <utility>
#include <vector>

#include "statistics/correlation.h"

namespace wythe::study {

// Outcomes: 0, 1, or 0.5 where the outcome is not known.
struct BinaryData {
  FragilityLaw law = FragilityLaw::kLogistic;
  std::vector<Column>
      x;  // one or two inputs in the form that the law takes (for lognormal, logarithms)
  Column y;
};

class BinaryFit {
 public:
  explicit BinaryFit(const BinaryData& data);
  // False if no finite slope fits best, because the inputs separate the outcomes.
  [[nodiscard]] bool is_finite() const { return finite_; }
  [[nodiscard]] double log_likelihood() const { return log_likelihood_; }
  // The slope k per unit of x[k], and the intercept at x = 0.
  [[nodiscard]] double slope(std::size_t k) const { return b_[k + 1] / scale_[k]; }
  [[nodiscard]] double intercept() const;
  // Wald interval of a slope.
  [[nodiscard]] Interval wald_slope(std::size_t k) const;
  // P and its Wald interval on the scale of eta, at x.
  [[nodiscard]] Estimate at(const std::vector<double>& x) const;
  [[nodiscard]] double probability(std::size_t sample) const;

  // For one input: profile likelihood intervals of the slope and of the x where P = 1/2. An
  // end is infinite where the likelihood stays near its maximum as far as the search goes.
  [[nodiscard]] Interval profile_slope() const;
  [[nodiscard]] Estimate half() const;

  // p of the likelihood ratio test against no influence.
  [[nodiscard]] double influence_p() const;
  // p of the test of Hosmer and Lemeshow over groups of similar probability; NaN with too few groups.
  [[nodiscard]] double fit_p() const;

 private:
  using Vector = std::array<double, 3>;
  [[nodiscard]] double eta(const Vector& b, std::size_t sample) const;
  [[nodiscard]] double likelihood(const Vector& b) const;
  void maximise();
  using Line = std::function<std::pair<double, double>(double z)>;  // offset and d of eta
  [[nodiscard]] double best_along(double t, const Line& line) const;
  [[nodiscard]] double best_with_slope(double slope) const;
  [[nodiscard]] double best_with_half(double place) const;

  BinaryData data_;  // standardised
  std::vector<double> mean_, scale_;
  std::size_t p_ = 2;  // parameters
  Vector b_ = {};      // of standardised inputs
  std::array<Vector, 3> covariance_ = {};
  double log_likelihood_ = 0;
  bool finite_ = false;
};

// Whether one input separates the outcomes: all of one kind at or below a value, all others at or above it.
[[nodiscard]] bool parts(const Column& x, const Column& y);
// P(chi^2 > x) with whole degrees of freedom.
[[nodiscard]] double chi_square_beyond(double x, int degrees);

}  // namespace wythe::study
