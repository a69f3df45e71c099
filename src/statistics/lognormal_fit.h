// A lognormal distribution of the intensity at which an event first happens, from brackets of that intensity.
//
//   log L = sum_i w_i log[ Phi(ln(high_i / theta) / beta) - Phi(ln(low_i / theta) / beta) ]
//
// Brackets describe all procedures. (0, x] and (x, inf) are the outcomes of a stripe, and their sum is
// the binomial likelihood; (low, high] is the end of an incremental analysis; (most, inf) one that was
// cut off (Baker, Earthquake Spectra 31 (2015), eqs. 6 and 11). In a = -ln(theta) / beta and b = 1 /
// beta it is concave, so Newton's method finds its only maximum. Equations: docs/theory/fragility.md.
#pragma once

#include <array>
#include <vector>

#include "wythe/parts/statistics.h"

namespace wythe::study {

struct Between {
  double low = 0, high = 0;  // 0 <= low < high <= inf
  double weight = 1;
};

class LognormalFit {
 public:
  // Equal brackets are joined and sorted, so that their order changes no bit.
  explicit LognormalFit(std::vector<Between> data);
  // kTold, kNever, kAlways, kSeparated or kNoTrend.
  [[nodiscard]] LimitStateVerdict verdict() const { return verdict_; }
  [[nodiscard]] bool is_told() const { return verdict_ == LimitStateVerdict::kTold; }
  [[nodiscard]] double median() const;
  [[nodiscard]] double beta() const;
  [[nodiscard]] double log_likelihood() const { return likelihood_; }
  // Profile likelihood intervals for independent brackets; 0 or infinite where the likelihood never falls far enough.
  [[nodiscard]] Interval profile_median() const;
  [[nodiscard]] Interval profile_beta() const;
  // P at x, and its Wald interval on the scale of a + b ln x.
  [[nodiscard]] Estimate at(double x) const;

 private:
  struct Slope {
    double value = 0;                   // log L
    std::array<double, 2> first = {};   // by a, b
    std::array<double, 3> second = {};  // aa, ab, bb
  };
  [[nodiscard]] Slope slope(double a, double b) const;
  void maximise();
  [[nodiscard]] double best_with_place(double z) const;  // of standardised ln theta
  [[nodiscard]] double best_with_b(double b) const;

  std::vector<Between> data_;  // standardised logarithms
  double mean_ = 0, scale_ = 1;
  double a_ = 0, b_ = 1;  // of standardised logarithms
  double likelihood_ = kUnset;
  std::array<double, 3> covariance_ = {};
  LimitStateVerdict verdict_ = LimitStateVerdict::kTold;
};

}  // namespace wythe::study
