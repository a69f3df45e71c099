#include "study/statistics/bootstrap.h"

#include <algorithm>
#include <cmath>

#include "study/statistics/intervals.h"

namespace wythe::study {
namespace {

constexpr std::uint64_t kSeed = 0x57595448u;

// Share of the replicates below the estimate, those equal to it counted half.
double share_below(const std::vector<double>& ascending, double value) {
  const auto [first, last] = std::equal_range(ascending.begin(), ascending.end(), value);
  const auto below = static_cast<double>(first - ascending.begin());
  const auto equal = static_cast<double>(last - first);
  return (below + equal / 2) / static_cast<double>(ascending.size());
}

// Efron's acceleration: skewness of the statistic over samples left out one at a time.
double acceleration(int n, const Statistic& statistic) {
  Counts count(n, 1);
  std::vector<double> left_out(n);
  double mean = 0;
  for (int i = 0; i < n; ++i) {
    count[i] = 0;
    left_out[i] = statistic(count);
    count[i] = 1;
    mean += left_out[i] / n;
  }
  double squares = 0, cubes = 0;
  for (double value : left_out) {
    squares += (mean - value) * (mean - value);
    cubes += (mean - value) * (mean - value) * (mean - value);
  }
  return squares > 0 ? cubes / (6 * std::pow(squares, 1.5)) : 0;
}

}  // namespace

std::vector<double> replicates(int n, const Statistic& statistic) {
  RandomBits bits(kSeed);
  std::vector<double> values;
  values.reserve(kReplicates);
  Counts count(n);
  for (int k = 0; k < kReplicates; ++k) {
    std::fill(count.begin(), count.end(), 0);
    for (int i = 0; i < n; ++i) ++count[bits.below(n)];
    const double value = statistic(count);
    if (!std::isnan(value)) values.push_back(value);
  }
  std::sort(values.begin(), values.end());
  return values;
}

Estimate percentile_bootstrap(int n, const Statistic& statistic) {
  if (n == 0) return {};
  Estimate estimate{statistic(Counts(n, 1)), {}};
  if (n < kFewestForBootstrap || std::isnan(estimate.value)) return estimate;
  const std::vector<double> values = replicates(n, statistic);
  estimate.interval = {quantile_of(values, 0.025), quantile_of(values, 0.975)};
  return estimate;
}

Estimate bca_bootstrap(int n, const Statistic& statistic) {
  if (n == 0) return {};
  Estimate estimate{statistic(Counts(n, 1)), {}};
  if (n < kFewestForBootstrap || std::isnan(estimate.value)) return estimate;
  const std::vector<double> values = replicates(n, statistic);
  if (values.empty()) return estimate;
  // a share of 0 or 1 has no quantile: half a replicate away from it
  const double edge = 0.5 / static_cast<double>(values.size());
  const double bias =
      normal_quantile(std::clamp(share_below(values, estimate.value), edge, 1 - edge));
  const double a = acceleration(n, statistic);
  const auto level = [&](double z) {
    const double left = 1 - a * (bias + z);
    return left > 0 ? normal_cdf(bias + (bias + z) / left) : normal_cdf(z);
  };
  estimate.interval = {quantile_of(values, level(-kNormal95)),
                       quantile_of(values, level(kNormal95))};
  return estimate;
}

}  // namespace wythe::study
