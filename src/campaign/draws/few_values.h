// Rank correlation of variables that have few values: measured ones that are drawn with replacement. Equal values share
// a rank, so a Gaussian copula correlates them less than continuous variables, and not every rank correlation exists.
#pragma once

#include <vector>

#include "wythe/parts/study.h"

namespace wythe {

// The share of each value of a variable, in their order; empty: as good as continuous.
[[nodiscard]] std::vector<double> shares_of_values(const VariableSpec& variable);

// The linear correlation of two normal variables behind two with these shares, whose ranks correlate by `rank`. `within`: what
// can be reached; where `rank` lies beyond, `within` is the largest (or the least) and `rho` that of full dependence.
struct RankReached {
  double rho, within;
};
[[nodiscard]] RankReached gaussian_of_rank(double rank, const std::vector<double>& a,
                                           const std::vector<double>& b);
// Its inverse: the rank correlation that a linear correlation `rho` behind them gives.
[[nodiscard]] double rank_of_gaussian(double rho, const std::vector<double>& a,
                                      const std::vector<double>& b);

}  // namespace wythe
