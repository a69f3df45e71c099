#include "study/draws/field_factor.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "core/real.h"

namespace wythe {
namespace {

// Values that differ by no more than `same` become one, the least of them; which one each is.
std::vector<std::size_t> gather(const std::vector<double>& values, double same,
                                std::vector<double>& distinct) {
  std::vector<std::size_t> order(values.size()), of(values.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(),
                   [&](std::size_t a, std::size_t b) { return values[a] < values[b]; });
  for (const std::size_t i : order) {
    if (distinct.empty() || values[i] > distinct.back() + same) distinct.push_back(values[i]);
    of[i] = distinct.size() - 1;
  }
  return of;
}

std::vector<double> correlations(const std::vector<double>& x, FieldKernel kernel, double length) {
  std::vector<double> c;
  for (const double a : x)
    for (const double b : x) c.push_back(correlation_at(kernel, a - b, length));
  return c;
}

double cubed(std::size_t n) {
  const auto x = static_cast<double>(n);
  return x * x * x;
}

}  // namespace

double correlation_at(FieldKernel kernel, double d, double length) {
  const double ratio = std::fabs(d) / length;
  const double fade = kernel == FieldKernel::kExponential ? ratio : ratio * ratio;
  return fade > 700 ? 0.0 : exp_of_minus(fade);
}

FieldFactor factor_of(std::vector<double> c, std::size_t n) {
  const double least = static_cast<double>(n) * std::numeric_limits<double>::epsilon();
  std::vector<std::vector<double>> columns;
  std::vector<double> left(n);
  for (std::size_t i = 0; i < n; ++i) left[i] = c[i * n + i];
  std::vector<char> done(n, 0);
  for (std::size_t k = 0; k < n; ++k) {
    std::size_t pivot = n;
    for (std::size_t i = 0; i < n; ++i)
      if (!done[i] && (pivot == n || left[i] > left[pivot])) pivot = i;
    if (!(left[pivot] > least)) break;
    done[pivot] = 1;
    std::vector<double> column(n, 0.0);
    const double root = std::sqrt(left[pivot]);
    column[pivot] = root;
    for (std::size_t i = 0; i < n; ++i) {
      if (done[i]) continue;
      double rest = c[i * n + pivot];
      for (const std::vector<double>& before : columns) rest -= before[i] * before[pivot];
      column[i] = rest / root;
      left[i] -= column[i] * column[i];
    }
    columns.push_back(std::move(column));
  }
  FieldFactor factor{n, columns.size(), std::vector<double>(n * columns.size())};
  for (std::size_t k = 0; k < columns.size(); ++k)
    for (std::size_t i = 0; i < n; ++i) factor.value[i * columns.size() + k] = columns[k][i];
  return factor;
}

FieldGrid::FieldGrid(const std::vector<double>& x, const std::vector<double>& y, double same)
    : column_(gather(x, same, x_)), row_(gather(y, same, y_)) {}

bool FieldGrid::is_grid() const {
  const auto nx = static_cast<double>(x_.size()), ny = static_cast<double>(y_.size());
  return cubed(x_.size()) / 3 + cubed(y_.size()) / 3 + nx * ny * (nx + ny) <=
         cubed(column_.size()) / 3;
}

double FieldGrid::cost() const {
  const auto nx = static_cast<double>(x_.size()), ny = static_cast<double>(y_.size());
  return is_grid() ? cubed(x_.size()) / 3 + cubed(y_.size()) / 3 + nx * ny * (nx + ny)
                   : cubed(column_.size()) / 3;
}

void FieldGrid::correlate(FieldKernel kernel, double along, double across) {
  if (is_grid()) {
    along_ = factor_of(correlations(x_, kernel, along), x_.size());
    across_ = factor_of(correlations(y_, kernel, across), y_.size());
    return;
  }
  const std::size_t n = column_.size();
  std::vector<double> c(n * n);
  for (std::size_t i = 0; i < n; ++i)
    for (std::size_t j = 0; j < n; ++j)
      c[i * n + j] = correlation_at(kernel, x_[column_[i]] - x_[column_[j]], along) *
                     correlation_at(kernel, y_[row_[i]] - y_[row_[j]], across);
  along_ = factor_of(std::move(c), n);
  across_ = {};
}

std::size_t FieldGrid::numbers() const {
  return across_.n > 0 ? along_.rank * across_.rank : along_.rank;
}

std::vector<double> FieldGrid::draw(const std::vector<double>& w) const {
  std::vector<double> z(column_.size());
  if (across_.n == 0) {
    for (std::size_t i = 0; i < z.size(); ++i)
      for (std::size_t k = 0; k < along_.rank; ++k) z[i] += along_.at(i, k) * w[k];
    return z;
  }
  // V = W Fy^T (rank of x, rows), then Z = Fx V at the places alone
  const std::size_t ranks = across_.rank, rows = y_.size();
  std::vector<double> v(along_.rank * rows, 0.0);
  for (std::size_t k = 0; k < along_.rank; ++k)
    for (std::size_t j = 0; j < rows; ++j)
      for (std::size_t m = 0; m < ranks; ++m)
        v[k * rows + j] += w[k * ranks + m] * across_.at(j, m);
  for (std::size_t i = 0; i < z.size(); ++i)
    for (std::size_t k = 0; k < along_.rank; ++k)
      z[i] += along_.at(column_[i], k) * v[k * rows + row_[i]];
  return z;
}

}  // namespace wythe
