// Finds the pattern of L once from the elimination tree, then computes L and D row by row. A pivot keeps the sign
// that is stated for it. One that round-off cancels becomes kPutBack with that sign. The factors are then those of
// another matrix, and the caller must refine.
#include "limit/solver/sparse_factor.h"

#include <algorithm>

namespace wythe::limit {
namespace {

constexpr double kLost = 1e-13;    // a pivot below is round-off
constexpr double kPutBack = 1e-4;  // what stands for it; 1e-7 and 1e30 end in worse answers

}  // namespace

void SparseFactor::analyse(const Matrix& upper, std::vector<double> signs) {
  n_ = static_cast<int>(upper.rows());
  sign_ = std::move(signs);
  const std::size_t n = n_;
  begin_.assign(upper.outerIndexPtr(), upper.outerIndexPtr() + n_ + 1);
  row_.assign(upper.innerIndexPtr(), upper.innerIndexPtr() + upper.nonZeros());
  parent_.assign(n, -1);
  std::vector<int> count(n, 0), seen(n, -1);
  for (int k = 0; k < n_; ++k) {
    seen[k] = k;
    for (int p = begin_[k]; p < begin_[k + 1]; ++p) {
      for (int i = row_[p]; i < k && seen[i] != k; i = parent_[i]) {
        if (parent_[i] < 0) parent_[i] = k;
        ++count[i];
        seen[i] = k;
      }
    }
  }
  l_begin_.assign(n + 1, 0);
  for (int k = 0; k < n_; ++k) l_begin_[k + 1] = l_begin_[k] + count[k];
  l_row_.resize(l_begin_[n]);
  l_value_.resize(l_row_.size());
  d_.resize(n);
  marked_.assign(n, 0);
  y_.assign(n, 0.0);
}

void SparseFactor::find_path(int k, const double* value, double& diagonal) {
  path_.clear();
  for (int p = begin_[k]; p < begin_[k + 1]; ++p) {
    if (row_[p] == k) {
      diagonal = value[p];
      continue;
    }
    y_[row_[p]] = value[p];
    branch_.clear();
    for (int i = row_[p]; i >= 0 && i < k && !marked_[i]; i = parent_[i]) {
      marked_[i] = 1;
      branch_.push_back(i);
    }
    path_.insert(path_.end(), branch_.rbegin(), branch_.rend());
  }
}

void SparseFactor::factorise(const double* value) {
  std::vector<int> next(l_begin_.begin(), l_begin_.end() - 1);
  for (int k = 0; k < n_; ++k) {
    double d = 0;
    find_path(k, value, d);
    for (auto c = path_.rbegin(); c != path_.rend(); ++c) {
      const double y = y_[*c];
      const int end = next[*c]++;
      for (int p = l_begin_[*c]; p < end; ++p) y_[l_row_[p]] -= l_value_[p] * y;
      l_row_[end] = k;
      l_value_[end] = y * d_[*c];
      d -= y * l_value_[end];
      y_[*c] = 0;
      marked_[*c] = 0;
    }
    if (!(d * sign_[k] > kLost)) d = sign_[k] * kPutBack;
    d_[k] = 1 / d;
  }
}

void SparseFactor::solve(Eigen::VectorXd& x) const {
  for (int k = 0; k < n_; ++k)
    for (int p = l_begin_[k]; p < l_begin_[k + 1]; ++p) x[l_row_[p]] -= l_value_[p] * x[k];
  for (int k = n_; k-- > 0;) {
    double v = x[k] * d_[k];
    for (int p = l_begin_[k]; p < l_begin_[k + 1]; ++p) v -= l_value_[p] * x[l_row_[p]];
    x[k] = v;
  }
}

void SparseFactor::solve(Eigen::VectorXd& x, Eigen::VectorXd& y) const {
  for (int k = 0; k < n_; ++k) {
    const double u = x[k], v = y[k];
    for (int p = l_begin_[k]; p < l_begin_[k + 1]; ++p) {
      const int row = l_row_[p];
      x[row] -= l_value_[p] * u;
      y[row] -= l_value_[p] * v;
    }
  }
  for (int k = n_; k-- > 0;) {
    double u = x[k] * d_[k], v = y[k] * d_[k];
    for (int p = l_begin_[k]; p < l_begin_[k + 1]; ++p) {
      const int row = l_row_[p];
      u -= l_value_[p] * x[row];
      v -= l_value_[p] * y[row];
    }
    x[k] = u;
    y[k] = v;
  }
}

}  // namespace wythe::limit
