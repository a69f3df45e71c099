// Cholesky with the largest pivot first, so that a kernel whose matrix is singular to rounding is factored too
// (docs/theory/fields.md, "Drawing"). Coordinates that differ by no more than `same` become one column or row. The grid
// or the list of places is factored, whichever takes fewer operations. Every sum runs in a fixed order.
#include "campaign/draws/field_factor.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <numeric>

#include "core/real.h"

namespace wythe {
namespace {

// Joins values that differ by no more than `same` to the smallest of them; also returns the index of each.
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

template <class Distance>
std::vector<double> correlations(std::size_t n, const Distance& distance, FieldKernel kernel,
                                 double length) {
  std::vector<double> c;
  for (std::size_t i = 0; i < n; ++i)
    for (std::size_t k = 0; k < n; ++k) c.push_back(correlation_at(kernel, distance(i, k), length));
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

FieldGrid::FieldGrid(const std::vector<double>& x, const std::vector<double>& z,
                     const std::vector<double>& y, double same)
    : row_(gather(y, same, y_)) {
  std::vector<double> lines_x, lines_z;
  const std::vector<std::size_t> i = gather(x, same, lines_x), k = gather(z, same, lines_z);
  std::map<std::pair<std::size_t, std::size_t>, std::size_t> number;
  for (std::size_t p = 0; p < x.size(); ++p) number[{i[p], k[p]}] = 0;
  for (auto& [place, column] : number) {
    column = x_.size();
    x_.push_back(lines_x[place.first]);
    z_.push_back(lines_z[place.second]);
  }
  for (std::size_t p = 0; p < x.size(); ++p) column_.push_back(number[{i[p], k[p]}]);
}

double FieldGrid::between_columns(std::size_t i, std::size_t k) const {
  const double dx = x_[i] - x_[k], dz = z_.empty() ? 0 : z_[i] - z_[k];
  return dz == 0 ? dx : std::sqrt(dx * dx + dz * dz);
}

double FieldGrid::width() const {
  const auto extent = [](const std::vector<double>& v) {
    if (v.empty()) return 0.0;
    const auto [low, high] = std::minmax_element(v.begin(), v.end());
    return *high - *low;
  };
  const double wide = extent(x_), deep = extent(z_);
  return deep == 0 ? wide : std::sqrt(wide * wide + deep * deep);
}

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
  const auto columns = [&](std::size_t i, std::size_t k) { return between_columns(i, k); };
  const auto rows = [&](std::size_t i, std::size_t k) { return y_[i] - y_[k]; };
  if (is_grid()) {
    along_ = factor_of(correlations(x_.size(), columns, kernel, along), x_.size());
    across_ = factor_of(correlations(y_.size(), rows, kernel, across), y_.size());
    return;
  }
  const std::size_t n = column_.size();
  std::vector<double> c(n * n);
  for (std::size_t i = 0; i < n; ++i)
    for (std::size_t j = 0; j < n; ++j)
      c[i * n + j] = correlation_at(kernel, columns(column_[i], column_[j]), along) *
                     correlation_at(kernel, rows(row_[i], row_[j]), across);
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
  // V = W Fy^T (rank of x, rows), then Z = Fx V only at the places
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
