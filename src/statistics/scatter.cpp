// Splits a full table of walls by records into mean squares, and these into components with intervals
// (15.4). If a cell is missing or unfinished, the table is refused with the reason. Quantiles of F, t
// and chi-square are found by bisection of their tails; intervals.cpp uses them too.
#include "statistics/scatter.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <set>

#include "statistics/binary_fit.h"

namespace wythe::study {
namespace {

constexpr double kScatterTail = 0.025;

// Continued fraction of the incomplete beta function (Abramowitz and Stegun 26.5.8, by Lentz's method).
double beta_fraction(double a, double b, double x) {
  constexpr double kTiny = 1e-300;
  const auto away = [](double v) { return std::fabs(v) < kTiny ? kTiny : v; };
  double c = 1, d = 1 / away(1 - (a + b) * x / (a + 1)), sum = d;
  for (int m = 1; m <= 1000; ++m) {
    const double even = m * (b - m) * x / ((a + 2 * m - 1) * (a + 2 * m));
    d = 1 / away(1 + even * d);
    c = away(1 + even / c);
    sum *= d * c;
    const double odd = -(a + m) * (a + b + m) * x / ((a + 2 * m) * (a + 2 * m + 1));
    d = 1 / away(1 + odd * d);
    c = away(1 + odd / c);
    sum *= d * c;
    if (std::fabs(d * c - 1) < 1e-15) break;
  }
  return sum;
}

// I_x(a, b)
double beta_share(double a, double b, double x) {
  if (x <= 0) return 0;
  if (x >= 1) return 1;
  const double front = std::exp(std::lgamma(a + b) - std::lgamma(a) - std::lgamma(b) +
                                a * std::log(x) + b * std::log1p(-x));
  return x < (a + 1) / (a + b + 2) ? front * beta_fraction(a, b, x) / a
                                   : 1 - front * beta_fraction(b, a, 1 - x) / b;
}

// The point where a function that decreases from 1 to 0 has this value.
double where(const std::function<double(double)>& beyond, double probability) {
  double low = 0, high = 1;
  while (beyond(high) > probability) low = high, high *= 2;
  for (int k = 0; k < 200; ++k) {
    const double middle = 0.5 * (low + high);
    if (middle == low || middle == high) break;
    (beyond(middle) > probability ? low : high) = middle;
  }
  return 0.5 * (low + high);
}

double root(double variance) { return variance > 0 ? std::sqrt(variance) : 0; }

// The component from the mean square `of` with `degrees`; each value is a mean over `size`. Interval by Tukey and Williams.
Estimate component(double of, int degrees, double rest, int rest_degrees, int size) {
  const double sum = of * degrees;
  Estimate out;
  out.value = root((of - rest) / size);
  const auto end = [&](double tail) {
    const double f = f_quantile_beyond(tail, degrees, rest_degrees);
    return root((sum - degrees * f * rest) / (size * chi_square_quantile_beyond(tail, degrees)));
  };
  out.interval = {end(kScatterTail), end(1 - kScatterTail)};
  return out;
}

}  // namespace

double f_quantile_beyond(double probability, int degrees, int below) {
  return where(
      [&](double f) {
        return beta_share(0.5 * below, 0.5 * degrees, below / (below + degrees * f));
      },
      probability);
}

double beta_quantile(double share, double a, double b) {
  return where([&](double x) { return 1 - beta_share(a, b, x); }, 1 - share);
}

double student_97(double degrees) {
  return std::sqrt(
      where([&](double f) { return beta_share(0.5 * degrees, 0.5, degrees / (degrees + f)); },
            2 * kScatterTail));
}

double chi_square_quantile_beyond(double probability, int degrees) {
  return where([&](double x) { return chi_square_beyond(x, degrees); }, probability);
}

Scatter scatter_of(const std::vector<Cell>& cells, double bracket) {
  std::set<int> record_set, wall_set;
  for (const Cell& cell : cells) record_set.insert(cell.record), wall_set.insert(cell.wall);
  const std::vector<int> records(record_set.begin(), record_set.end());
  const std::vector<int> walls(wall_set.begin(), wall_set.end());
  Scatter out;
  out.records = static_cast<int>(records.size());
  out.walls = static_cast<int>(walls.size());
  out.bracket = bracket;
  const auto refuse = [&](ScatterVerdict verdict) {
    out.verdict = verdict;
    return out;
  };
  if (out.records < kFewestForScatter || out.walls < kFewestForScatter)
    return refuse(ScatterVerdict::kOneKind);
  if (cells.size() != records.size() * walls.size()) return refuse(ScatterVerdict::kNotCrossed);
  const std::size_t n_w = walls.size(), n_r = records.size();
  std::vector<double> y(cells.size(), kUnset), of_record(n_r, 0.0), of_wall(n_w, 0.0);
  const auto place = [](const std::vector<int>& list, int value) {
    return static_cast<std::size_t>(std::lower_bound(list.begin(), list.end(), value) -
                                    list.begin());
  };
  for (const Cell& cell : cells)
    y[place(records, cell.record) * n_w + place(walls, cell.wall)] = cell.value;
  double mean = 0;
  for (std::size_t r = 0; r < n_r; ++r)
    for (std::size_t w = 0; w < n_w; ++w) {
      const double value = y[r * n_w + w];
      if (!std::isfinite(value)) return refuse(ScatterVerdict::kNotReached);
      mean += value / static_cast<double>(y.size());
      of_record[r] += value / static_cast<double>(n_w);
      of_wall[w] += value / static_cast<double>(n_r);
    }
  double ss_record = 0, ss_wall = 0, ss_rest = 0;
  for (const double m : of_record) ss_record += static_cast<double>(n_w) * (m - mean) * (m - mean);
  for (const double m : of_wall) ss_wall += static_cast<double>(n_r) * (m - mean) * (m - mean);
  for (std::size_t r = 0; r < n_r; ++r)
    for (std::size_t w = 0; w < n_w; ++w) {
      const double e = y[r * n_w + w] - of_record[r] - of_wall[w] + mean;
      ss_rest += e * e;
    }
  const int d_r = out.records - 1, d_w = out.walls - 1, d_e = d_r * d_w;
  const double ms_rest = ss_rest / d_e;
  if (ms_rest < bracket * bracket) return refuse(ScatterVerdict::kWide);
  out.record = component(ss_record / d_r, d_r, ms_rest, d_e, out.walls);
  out.wall = component(ss_wall / d_w, d_w, ms_rest, d_e, out.records);
  out.rest = {std::sqrt(ms_rest),
              {std::sqrt(ss_rest / chi_square_quantile_beyond(kScatterTail, d_e)),
               std::sqrt(ss_rest / chi_square_quantile_beyond(1 - kScatterTail, d_e))}};
  return out;
}

}  // namespace wythe::study
