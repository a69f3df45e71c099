// The door to OpenTURNS: distributions, designs and the Gaussian copula (sampling.cpp).
//
//   unit_design()         u(i, j) in (0, 1): where sample i lies in the probability of variable j
//   impose_correlation()  ties columns of u together by a Gaussian copula, the strata of each kept
//   Margin                u -> value of one variable, truncation included
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <mutex>
#include <string>
#include <utility>
#include <vector>

#include "wythe/study.h"

namespace wythe {

// OpenTURNS for one caller at a time, with the settings that change an answer at their defaults. It reads settings from
// openturns.conf while it is loaded, and a program that has this library in it may set others; afterwards they are as
// they were. Its threads change no answer and are left alone.
class OpenTurnsAsDelivered {
 public:
  OpenTurnsAsDelivered();
  ~OpenTurnsAsDelivered();
  OpenTurnsAsDelivered(const OpenTurnsAsDelivered&) = delete;
  OpenTurnsAsDelivered& operator=(const OpenTurnsAsDelivered&) = delete;

 private:
  std::unique_lock<std::mutex> lock_;
  std::vector<std::pair<std::string, double>> before_;
};

// One variable's distribution; `spec` must have passed its check (check_variable in study_check.h).
class Margin {
 public:
  explicit Margin(const VariableSpec& spec);
  ~Margin();
  Margin(Margin&&) noexcept;
  Margin& operator=(Margin&&) noexcept;

  // Value below which a share `u` of the truncated distribution lies [SI]; 0 < u < 1.
  [[nodiscard]] double quantile(double u) const;
  // Density of the truncated distribution [1/SI]; 0 everywhere for measured values.
  [[nodiscard]] double density(double x) const;
  // Share of the distribution as stated that lies outside `lower` and `upper`.
  [[nodiscard]] double cut_off() const { return below_ + above_; }
  // Share that is left, never below 0.
  [[nodiscard]] double kept() const;

 private:
  struct Whole;  // the distribution as stated
  std::unique_ptr<Whole> whole_;
  double lower_, upper_;          // -inf, inf where there is no truncation
  double below_ = 0, above_ = 0;  // probability cut off at either end
};

using Columns = std::vector<std::vector<double>>;  // (n_variable, n_sample)

struct DesignRequest {
  Design design = Design::kLatinHypercube;
  int samples = 0;
  std::uint64_t seed = 0;
  int batch = 0;
};
// One column for each name, from a stream of its own: a column never depends on the others, but for
// the place of a Sobol dimension, which goes by the order of names.
//   Latin hypercube  one sample in each of n equal strata, at random in it (McKay et al. 1979)
//   Monte Carlo      independent
//   Sobol            the first n points of the sequence, digitally shifted by the seed
[[nodiscard]] Columns unit_design(const DesignRequest& request,
                                  const std::vector<std::string>& names);
// Largest number of variables of a Sobol design.
[[nodiscard]] int most_sobol_variables();

// `count` independent standard normal numbers of the stream `name` of a seed.
[[nodiscard]] std::vector<double> normal_numbers(int seed, const std::string& name,
                                                 std::size_t count);
// One for each place, of the seed, the name and that place alone.
using PlaceKey = std::array<std::int64_t, 3>;
[[nodiscard]] std::vector<double> normal_numbers_at(int seed, const std::string& name,
                                                    const std::vector<PlaceKey>& places);
// Share of the standard normal distribution below z, in (0, 1).
[[nodiscard]] double normal_share(double z);

// Symmetric matrix of correlations, row by row, ones on its diagonal.
struct CorrelationMatrix {
  std::size_t n = 0;
  std::vector<double> value;
  explicit CorrelationMatrix(std::size_t size);
  double& at(std::size_t i, std::size_t j) { return value[i * n + j]; }
  [[nodiscard]] double at(std::size_t i, std::size_t j) const { return value[i * n + j]; }
};
[[nodiscard]] bool is_positive_definite(const CorrelationMatrix& matrix);
// The nearest correlation matrix (least squares of its entries) whose eigenvalues are far enough
// from zero for its entries to be rounded to three digits: alternating projections, Higham 2002.
[[nodiscard]] CorrelationMatrix nearest_positive_definite(const CorrelationMatrix& matrix);

// Ties the columns together by a Gaussian copula with this matrix, x = Phi(L Phi^-1(u)). A Latin
// hypercube keeps its strata: each column keeps its values and takes only the ranks of x (Stein
// 1987), and what chance put between the ranks is taken out first (after Iman and Conover 1982), so
// that the columns are as uncorrelated as the matrix says. Column j then depends on those before
// it. With the other designs the columns become x.
void impose_correlation(Columns& u, const CorrelationMatrix& matrix, Design design);

}  // namespace wythe
