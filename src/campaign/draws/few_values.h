// Rank correlation of variables with few values: measured values that are drawn with replacement. Equal values share a
// rank. So a Gaussian copula correlates them less than continuous variables, and not every rank correlation is possible.
#pragma once

#include <vector>

#include "wythe/parts/study.h"

namespace wythe {

// The share of each value of a variable, in ascending order; empty where it counts as continuous.
[[nodiscard]] std::vector<double> shares_of_values(const VariableSpec& variable);

// The linear correlation of the normal variables behind two variables with these shares and the rank correlation `rank`.
// `within` is the rank correlation reached: `rank`, or the largest possible one, for which `rho` is that of full dependence.
struct RankReached {
  double rho, within;
};
[[nodiscard]] RankReached gaussian_of_rank(double rank, const std::vector<double>& a,
                                           const std::vector<double>& b);
// The inverse: the rank correlation from the linear correlation `rho` of the normal variables.
[[nodiscard]] double rank_of_gaussian(double rho, const std::vector<double>& a,
                                      const std::vector<double>& b);

}  // namespace wythe
