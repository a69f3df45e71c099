// Correlation between variables: the matrix of a Gaussian copula, and the columns that it correlates.
#pragma once

#include <vector>

#include "campaign/draws/sampling.h"
#include "wythe/parts/study.h"

namespace wythe {

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

// Correlates the columns by a Gaussian copula with this matrix, x = Phi(L Phi^-1(u)).
// A Latin hypercube keeps its strata: each column keeps its values and takes only the
// ranks of x (Stein 1987). Chance correlations of the ranks are removed first (after
// Iman and Conover 1982), so that the correlations are those of the matrix. Column j
// then depends on the earlier ones. With the other designs the columns become x.
void impose_correlation(Columns& u, const CorrelationMatrix& matrix, Design design);

}  // namespace wythe
