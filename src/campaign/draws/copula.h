// From the pairs of a study to the matrix of its Gaussian copula.
#pragma once

#include <vector>

#include "campaign/draws/sampling.h"
#include "wythe/study.h"

namespace wythe {

// Variables in the study's order, and the matrix between them.
struct Copula {
  std::vector<std::size_t> variable;
  CorrelationMatrix matrix{0};
};
// Every pair must name two variables. `all`: the variables in no pair too, correlated with none.
[[nodiscard]] Copula copula_of(const StudySpec& study, bool all = false);

// Spearman's rank correlation of two jointly normal variables and their linear correlation:
//   rho = 2 sin(pi rank / 6),   rank = 6/pi asin(rho / 2)
[[nodiscard]] double gaussian_of_rank(double rank);
[[nodiscard]] double rank_of_gaussian(double rho);

}  // namespace wythe
