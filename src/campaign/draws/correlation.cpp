// Cholesky factor, eigenvalues and ranks. Eigen holds the matrices, which have a few rows.
#include "campaign/draws/correlation.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

#include "campaign/draws/generator.h"
#include "core/normal.h"

namespace wythe {
namespace {

// Used by nearest_positive_definite(), times n. Rounding every entry to
// three digits, ranks or not, moves an eigenvalue by at most 5.3e-4 (n - 1).
constexpr double kLeastEigenvalue = 6e-4;
constexpr std::size_t kFewestPerColumn = 3;  // samples that make_uncorrelated() needs for each

Eigen::MatrixXd matrix_of(const CorrelationMatrix& matrix) {
  const auto n = static_cast<Eigen::Index>(matrix.n);
  return Eigen::Map<const Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>>(
      matrix.value.data(), n, n);
}

// The nearest symmetric matrix whose eigenvalues are at least `least`.
CorrelationMatrix with_eigenvalues_raised(const CorrelationMatrix& matrix, double least) {
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> solved(matrix_of(matrix));
  const Eigen::MatrixXd raised = solved.eigenvectors() *
                                 solved.eigenvalues().cwiseMax(least).asDiagonal() *
                                 solved.eigenvectors().transpose();
  CorrelationMatrix out(matrix.n);
  for (std::size_t i = 0; i < matrix.n; ++i)
    for (std::size_t j = 0; j < matrix.n; ++j)
      out.at(i, j) = raised(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(j));
  return out;
}

// Rank of each value, 0 for the smallest; equal values keep their order.
std::vector<std::size_t> order_of(const std::vector<double>& values) {
  std::vector<std::size_t> order(values.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(),
                   [&](std::size_t a, std::size_t b) { return values[a] < values[b]; });
  return order;
}

// The values of `column`, reordered so that they have the ranks of `scores`.
std::vector<double> arranged(std::vector<double> column, const std::vector<double>& scores) {
  std::sort(column.begin(), column.end());
  const std::vector<std::size_t> order = order_of(scores);
  std::vector<double> out(column.size());
  for (std::size_t k = 0; k < column.size(); ++k) out[order[k]] = column[k];
  return out;
}

// Each column minus its projections on the earlier columns, with mean 0 and mean square 1.
void make_uncorrelated(Columns& z) {
  const auto n = static_cast<double>(z.front().size());
  const auto product = [&](const std::vector<double>& a, const std::vector<double>& b) {
    return std::inner_product(a.begin(), a.end(), b.begin(), 0.0) / n;
  };
  for (std::size_t j = 0; j < z.size(); ++j) {
    const double mean = std::accumulate(z[j].begin(), z[j].end(), 0.0) / n;
    for (double& value : z[j]) value -= mean;
    for (std::size_t k = 0; k < j; ++k) {
      const double share = product(z[j], z[k]);
      for (std::size_t i = 0; i < z[j].size(); ++i) z[j][i] -= share * z[k][i];
    }
    const double size = std::sqrt(product(z[j], z[j]));
    for (double& value : z[j]) value /= size;
  }
}

// Reorders the values of each column like the uncorrelated columns, three
// times. This leaves rank correlations of at most 0.004 in 250 samples.
void remove_chance_correlations(Columns& u) {
  for (int round = 0; round < 3; ++round) {
    Columns order = u;
    make_uncorrelated(order);
    for (std::size_t j = 0; j < u.size(); ++j) u[j] = arranged(std::move(u[j]), order[j]);
  }
}

}  // namespace

CorrelationMatrix::CorrelationMatrix(std::size_t size) : n(size), value(size * size, 0.0) {
  for (std::size_t i = 0; i < n; ++i) at(i, i) = 1;
}

bool is_positive_definite(const CorrelationMatrix& matrix) {
  return matrix_of(matrix).llt().info() == Eigen::Success;
}

// Dykstra's correction is needed on the first set only: the second is a plane (Higham 2002, alg. 3.3).
CorrelationMatrix nearest_positive_definite(const CorrelationMatrix& matrix) {
  const double least = kLeastEigenvalue * static_cast<double>(matrix.n);
  CorrelationMatrix y = matrix, correction = matrix;
  std::fill(correction.value.begin(), correction.value.end(), 0.0);
  for (int round = 0; round < 500; ++round) {
    CorrelationMatrix r = y;
    for (std::size_t k = 0; k < r.value.size(); ++k) r.value[k] -= correction.value[k];
    const CorrelationMatrix x = with_eigenvalues_raised(r, least);
    double change = 0;
    for (std::size_t k = 0; k < r.value.size(); ++k) {
      correction.value[k] = x.value[k] - r.value[k];
      change = std::max(change, std::fabs(x.value[k] - y.value[k]));
    }
    y = x;
    for (std::size_t i = 0; i < y.n; ++i) y.at(i, i) = 1;
    if (change < 1e-7) break;
  }
  return y;
}

void impose_correlation(Columns& u, const CorrelationMatrix& matrix, Design design) {
  if (u.empty()) return;
  const std::size_t n = u.front().size();
  if (design == Design::kLatinHypercube && n >= kFewestPerColumn * u.size())
    remove_chance_correlations(u);
  const Eigen::MatrixXd factor = matrix_of(matrix).llt().matrixL();
  Columns scores = u;
  for (std::vector<double>& column : scores)
    for (double& value : column) value = normal_quantile(value);
  for (std::size_t j = 0; j < u.size(); ++j) {
    std::vector<double> tied(n);
    for (std::size_t i = 0; i < n; ++i) {
      double z = 0;
      for (std::size_t k = 0; k <= j; ++k)
        z += factor(static_cast<Eigen::Index>(j), static_cast<Eigen::Index>(k)) * scores[k][i];
      tied[i] = inside(normal_share(z));
    }
    u[j] = design == Design::kLatinHypercube ? arranged(std::move(u[j]), tied) : tied;
  }
}

}  // namespace wythe
