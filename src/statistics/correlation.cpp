// Computes Pearson, Spearman and partial rank correlations with intervals (7.7), and variance ratios
// in bins (7.10). A lower bound gets the mean of its possible ranks (7.9); Pearson and the bins use
// its recorded value. Values are centred before they are squared. Collinear inputs give NaN.
#include "statistics/correlation.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

#include "statistics/bootstrap.h"
#include "statistics/intervals.h"

namespace wythe::study {
namespace {

// Indices of the values in ascending order; equal values keep their order.
std::vector<int> order_of(const Column& values) {
  std::vector<int> order(values.size());
  std::iota(order.begin(), order.end(), 0);
  std::stable_sort(order.begin(), order.end(), [&](int a, int b) { return values[a] < values[b]; });
  return order;
}

using Matrix = std::vector<Column>;

constexpr double kSingular = 1e-10;  // for entries of order 1: the rest is rounding

Matrix correlation_matrix(const std::vector<Column>& columns) {
  const std::size_t n = columns.size();
  Matrix matrix(n, Column(n, 1));
  for (std::size_t i = 0; i < n; ++i)
    for (std::size_t j = 0; j < i; ++j)
      matrix[i][j] = matrix[j][i] = pearson(columns[i], columns[j]);
  return matrix;
}

void eliminate(Matrix& a, Matrix& inverse, std::size_t pivot) {
  const std::size_t n = a.size();
  const double scale = 1 / a[pivot][pivot];
  for (std::size_t j = 0; j < n; ++j) a[pivot][j] *= scale, inverse[pivot][j] *= scale;
  for (std::size_t i = 0; i < n; ++i) {
    if (i == pivot) continue;
    const double factor = a[i][pivot];
    for (std::size_t j = 0; j < n; ++j) {
      a[i][j] -= factor * a[pivot][j];
      inverse[i][j] -= factor * inverse[pivot][j];
    }
  }
}

// Gauss-Jordan with row pivots; empty when singular. The inputs are few, so speed does not matter.
Matrix inverse_of(Matrix a) {
  const std::size_t n = a.size();
  Matrix inverse(n, Column(n, 0));
  for (std::size_t i = 0; i < n; ++i) inverse[i][i] = 1;
  for (std::size_t k = 0; k < n; ++k) {
    std::size_t best = k;
    for (std::size_t i = k + 1; i < n; ++i)
      if (std::fabs(a[i][k]) > std::fabs(a[best][k])) best = i;
    if (!(std::fabs(a[best][k]) > kSingular)) return {};
    std::swap(a[k], a[best]), std::swap(inverse[k], inverse[best]);
    eliminate(a, inverse, k);
  }
  return inverse;
}

// a' M b
double product(const Column& a, const Matrix& m, const Column& b) {
  double sum = 0;
  for (std::size_t i = 0; i < a.size(); ++i)
    for (std::size_t j = 0; j < b.size(); ++j) sum += a[i] * m[i][j] * b[j];
  return sum;
}

// Correlation of column k and the last column, after the effect of the other columns is removed.
double partial_of(const Matrix& r, std::size_t k) {
  const std::size_t last = r.size() - 1;
  Matrix others;
  Column of_k, of_last;
  for (std::size_t i = 0; i < last; ++i) {
    if (i == k) continue;
    Column row;
    for (std::size_t j = 0; j < last; ++j)
      if (j != k) row.push_back(r[i][j]);
    others.push_back(std::move(row));
    of_k.push_back(r[i][k]), of_last.push_back(r[i][last]);
  }
  const Matrix inverse = inverse_of(others);
  if (inverse.size() != others.size()) return kUnset;
  const double k_left = 1 - product(of_k, inverse, of_k);
  const double last_left = 1 - product(of_last, inverse, of_last);
  if (!(k_left > kSingular) || !(last_left > kSingular)) return kUnset;
  const double joint = r[k][last] - product(of_k, inverse, of_last);
  return std::clamp(joint / std::sqrt(k_left * last_left), -1.0, 1.0);
}

// Sums of squares of a one-way analysis of variance, weighted by count.
struct Variance {
  double n = 0, within = 0, between = 0;
  int bins = 0;  // that hold anything
  [[nodiscard]] double total() const { return within + between; }
  [[nodiscard]] double ratio() const { return total() > 0 ? between / total() : kUnset; }
  [[nodiscard]] double index() const {
    const double chance = n > bins ? (bins - 1) * within / (n - bins) : kUnset;
    return total() > 0 ? (between - chance) / total() : kUnset;
  }
};

// `y` is centred, so that the sums of squares lose no digits.
Variance analyse(const std::vector<int>& bin, int bins, const Column& y, const Counts& count) {
  Column n(bins, 0), sum(bins, 0);
  double square = 0, sum_all = 0;
  Variance v;
  for (std::size_t i = 0; i < y.size(); ++i) {
    n[bin[i]] += count[i], sum[bin[i]] += count[i] * y[i];
    square += count[i] * y[i] * y[i];
  }
  double of_means = 0;
  for (int b = 0; b < bins; ++b) {
    if (n[b] == 0) continue;
    ++v.bins, v.n += n[b], sum_all += sum[b];
    of_means += sum[b] * sum[b] / n[b];
  }
  v.within = std::fmax(square - of_means, 0.0);
  v.between = std::fmax(of_means - sum_all * sum_all / v.n, 0.0);
  return v;
}

Column centred(Column y) {
  Moments moments;
  for (double value : y) moments.add(value);
  for (double& value : y) value -= moments.mean();
  return y;
}

}  // namespace

Column ranks(const Column& values) {
  const std::vector<int> order = order_of(values);
  Column rank(values.size());
  for (std::size_t i = 0; i < order.size();) {
    std::size_t end = i + 1;
    while (end < order.size() && values[order[end]] == values[order[i]]) ++end;
    for (std::size_t k = i; k < end; ++k) rank[order[k]] = 0.5 * static_cast<double>(i + 1 + end);
    i = end;
  }
  return rank;
}

// Every value has a mass of 1. A bound distributes its mass equally to
// the values beyond it (Efron), as in the curve of Kaplan and Meier.
Column ranks(const std::vector<Reading>& readings) {
  std::vector<int> order(readings.size());
  std::iota(order.begin(), order.end(), 0);
  std::stable_sort(order.begin(), order.end(), [&](int a, int b) {
    const Reading &x = readings[a], &y = readings[b];
    return x.value != y.value ? x.value < y.value : x.censored < y.censored;
  });
  const auto n = static_cast<double>(readings.size());
  Column rank(readings.size());
  double below = 0, mass = 1;  // of all earlier values; of each remaining value
  for (std::size_t i = 0; i < order.size();) {
    const Reading& first = readings[order[i]];
    std::size_t end = i;
    while (end < order.size() && readings[order[end]].value == first.value &&
           readings[order[end]].censored == first.censored)
      ++end;
    const auto equal = static_cast<double>(end - i), left = static_cast<double>(order.size() - end);
    const double here = first.censored ? n - below : equal * mass;  // the true values lie within it
    for (std::size_t k = i; k < end; ++k) rank[order[k]] = below + 0.5 * here + 0.5;
    if (!first.censored)
      below += equal * mass;
    else if (left > 0)
      mass += equal * mass / left;
    i = end;
  }
  return rank;
}

std::vector<Reading> observed(const Column& values) {
  std::vector<Reading> readings;
  for (const double value : values) readings.push_back({value, false});
  return readings;
}

double pearson(const Column& x, const Column& y) {
  if (x.size() < 3) return kUnset;
  const Column a = centred(x), b = centred(y);
  double aa = 0, bb = 0, ab = 0;
  for (std::size_t i = 0; i < a.size(); ++i)
    aa += a[i] * a[i], bb += b[i] * b[i], ab += a[i] * b[i];
  if (!(aa > 0) || !(bb > 0)) return kUnset;
  return std::clamp(ab / (std::sqrt(aa) * std::sqrt(bb)), -1.0, 1.0);
}

Column partial_correlations(const std::vector<Column>& x, const Column& y) {
  std::vector<Column> columns = x;
  columns.push_back(y);
  const Matrix r = correlation_matrix(columns);
  Column partial(x.size(), kUnset);
  for (std::size_t k = 0; k < x.size(); ++k) partial[k] = partial_of(r, k);
  return partial;
}

std::vector<Correlation> correlate(const std::vector<Column>& inputs,
                                   const std::vector<Reading>& readings) {
  const int n = static_cast<int>(readings.size());
  const int controlled = static_cast<int>(inputs.size()) - 1;
  const Column response_ranks = ranks(readings);
  Column response;  // as recorded
  for (const Reading& r : readings) response.push_back(r.value);
  std::vector<Column> input_ranks;
  for (const Column& input : inputs) input_ranks.push_back(ranks(input));
  // with as many columns as samples no correlation is left
  Column partial(inputs.size(), kUnset);
  if (n > controlled + 3) partial = partial_correlations(input_ranks, response_ranks);
  std::vector<Correlation> out(inputs.size());
  for (std::size_t k = 0; k < inputs.size(); ++k) {
    const double rho = pearson(input_ranks[k], response_ranks);
    out[k].n = n;
    out[k].pearson = fisher_z(pearson(inputs[k], response), n, 0, 1);
    out[k].spearman = fisher_z(rho, n, 0, 1 + rho * rho / 2);
    out[k].partial_rank = fisher_z(partial[k], n, controlled, 1 + partial[k] * partial[k] / 2);
  }
  return out;
}

std::vector<int> equal_bins(const Column& values, int bins) {
  const std::vector<int> order = order_of(values);
  std::vector<int> bin(values.size());
  for (std::size_t i = 0; i < order.size(); ++i)
    bin[order[i]] = static_cast<int>(i * static_cast<std::size_t>(bins) / order.size());
  return bin;
}

FirstOrderIndex first_order_index(const Column& input, const Column& response) {
  const int n = static_cast<int>(response.size());
  FirstOrderIndex out;
  if (n < kFewestSamples) return out;
  out.bins = std::clamp(static_cast<int>(std::lround(std::sqrt(n))), 4, 50);
  const std::vector<int> bin = equal_bins(input, out.bins);
  const Column y = centred(response);
  const Variance own = analyse(bin, out.bins, y, Counts(n, 1));
  out.index.value = own.index();
  if (!std::isfinite(out.index.value) || n < kFewestForBootstrap) return out;
  // For a replicate the samples are the truth, and its index estimates their ratio()
  // with chance included. So index - S scatters like the replicates' index - ratio().
  const Resampled part(response.size());
  const std::vector<int> bins = part.of(bin);
  const Column few = part.is_all() ? y : centred(part.of(response));
  const double centre =
      part.is_all() ? own.ratio() : analyse(bins, out.bins, few, Counts(part.size(), 1)).ratio();
  const std::vector<double> values = replicates(part.size(), [&](const Counts& count) {
    return analyse(bins, out.bins, few, count).index();
  });
  const auto above = [&](double p) { return part.narrowed(quantile_of(values, p) - centre); };
  out.index.interval = {out.index.value - above(0.975), out.index.value - above(0.025)};
  return out;
}

}  // namespace wythe::study
