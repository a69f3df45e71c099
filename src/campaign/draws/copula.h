// From the pairs of a study to the matrix of its Gaussian copula.
#pragma once

#include <vector>

#include "campaign/draws/correlation.h"
#include "wythe/parts/study.h"

namespace wythe {

// Variables in the study's order, and the matrix between them.
struct Copula {
  std::vector<std::size_t> variable;
  CorrelationMatrix matrix{0};
};
// Every pair must name two variables. `all` includes variables in no pair, which are correlated with none.
[[nodiscard]] Copula copula_of(const StudySpec& study, bool all = false);

// The linear correlation of two jointly normal variables from Spearman's rank correlation: rho = 2 sin(pi rank / 6).
[[nodiscard]] double gaussian_of_rank(double rank);

}  // namespace wythe
