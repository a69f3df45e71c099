// Draws replicates with a fixed seed, and computes percentile and BCa intervals from them (7.1). Replicates
// that are NaN are dropped. Below kFewestForBootstrap samples there is no interval. Of more than kMostResampled
// samples a part is resampled, and its distances are reduced by the square root of the ratio (7.1b).
#include "statistics/bootstrap.h"

#include <algorithm>
#include <cmath>

#include "statistics/intervals.h"

namespace wythe::study {
namespace {

constexpr std::uint64_t kSeed = 0x57595448u;

// Share of the replicates below the estimate; equal ones count half.
double share_below(const std::vector<double>& ascending, double value) {
  const auto [first, last] = std::equal_range(ascending.begin(), ascending.end(), value);
  const auto below = static_cast<double>(first - ascending.begin());
  const auto equal = static_cast<double>(last - first);
  return (below + equal / 2) / static_cast<double>(ascending.size());
}

void drop_unknown(std::vector<double>& values) {
  std::erase_if(values, [](double v) { return std::isnan(v); });
  std::sort(values.begin(), values.end());
}

// The statistic with each sample left out in turn.
std::vector<double> left_out_of(int n, const Statistic& statistic) {
  Counts count(n, 1);
  std::vector<double> values(n);
  for (int i = 0; i < n; ++i) {
    count[i] = 0;
    values[i] = statistic(count);
    count[i] = 1;
  }
  return values;
}

}  // namespace

void each_replicate(int n, const std::function<void(const Counts& count)>& visit) {
  RandomBits bits(kSeed);
  Counts count(n);
  for (int k = 0; k < kReplicates; ++k) {
    std::fill(count.begin(), count.end(), 0);
    for (int i = 0; i < n; ++i) ++count[bits.below(n)];
    visit(count);
  }
}

std::vector<double> replicates(int n, const Statistic& statistic) {
  std::vector<double> values;
  values.reserve(kReplicates);
  each_replicate(n, [&](const Counts& count) { values.push_back(statistic(count)); });
  drop_unknown(values);
  return values;
}

double acceleration_of(const std::vector<double>& left_out) {
  double mean = 0, squares = 0, cubes = 0;
  for (const double value : left_out) mean += value / static_cast<double>(left_out.size());
  for (const double value : left_out) {
    squares += (mean - value) * (mean - value);
    cubes += (mean - value) * (mean - value) * (mean - value);
  }
  return squares > 0 ? cubes / (6 * std::pow(squares, 1.5)) : 0;
}

Estimate percentile_interval(double value, std::vector<double> replicates) {
  drop_unknown(replicates);
  return {value, {quantile_of(replicates, 0.025), quantile_of(replicates, 0.975)}};
}

Estimate bca_interval(double value, std::vector<double> replicates, double acceleration) {
  Estimate estimate{value, {}};
  drop_unknown(replicates);
  if (replicates.empty()) return estimate;
  // a share of 0 or 1 has no quantile, so half a replicate is added or removed
  const double edge = 0.5 / static_cast<double>(replicates.size());
  const double bias = normal_quantile(std::clamp(share_below(replicates, value), edge, 1 - edge));
  const auto level = [&](double z) {
    const double left = 1 - acceleration * (bias + z);
    return left > 0 ? normal_cdf(bias + (bias + z) / left) : normal_cdf(z);
  };
  estimate.interval = {quantile_of(replicates, level(-kNormal95)),
                       quantile_of(replicates, level(kNormal95))};
  return estimate;
}

Estimate percentile_bootstrap(int n, const Statistic& statistic) {
  if (n == 0) return {};
  const double value = statistic(Counts(n, 1));
  if (n < kFewestForBootstrap || std::isnan(value)) return {value, {}};
  return percentile_interval(value, replicates(n, statistic));
}

Estimate bca_bootstrap(int n, const Statistic& statistic) {
  if (n == 0) return {};
  const double value = statistic(Counts(n, 1));
  if (n < kFewestForBootstrap || std::isnan(value)) return {value, {}};
  return bca_interval(value, replicates(n, statistic), acceleration_of(left_out_of(n, statistic)));
}

Resampled::Resampled(std::size_t n, int most) : m_(static_cast<int>(n)) {
  if (m_ <= most) return;
  m_ = most;
  shrink_ = std::sqrt(static_cast<double>(m_) / static_cast<double>(n));
  RandomBits bits(kSeed);
  const std::size_t parts = most;
  for (std::size_t i = 0; i < parts; ++i) {
    const std::size_t first = i * n / parts, next = (i + 1) * n / parts;
    place_.push_back(first + static_cast<std::size_t>(bits.below(static_cast<int>(next - first))));
  }
}

double Resampled::of_all(double end, double part, double all) const {
  // an end that is infinite or unknown stays as it is
  if (is_all() || !std::isfinite(end) || !std::isfinite(part) || !std::isfinite(all)) return end;
  return all + narrowed(end - part);
}

Estimate Resampled::of_all(const Estimate& part, double all) const {
  return {
      all,
      {of_all(part.interval.low, part.value, all), of_all(part.interval.high, part.value, all)}};
}

}  // namespace wythe::study
