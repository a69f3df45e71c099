// A few walls of one model: medians by order statistics, shares of failure modes.
#include <algorithm>
#include <cmath>
#include <limits>

#include "statistics/intervals.h"
#include "statistics/statistics_parts.h"
#include "wythe/parts/statistics.h"

namespace wythe {
namespace {

double middle_of(const std::vector<double>& ascending) {
  const std::size_t half = ascending.size() / 2;
  return ascending.size() % 2 == 1 ? ascending[half]
                                   : 0.5 * (ascending[half - 1] + ascending[half]);
}

}  // namespace

OfWalls of_walls(const std::vector<Reading>& readings) {
  OfWalls out;
  std::vector<double> low, high;  // each value as a lower bound, and as an upper bound
  study::Moments logs;
  for (const Reading& r : readings) {
    if (!r.is_known()) continue;
    low.push_back(r.value);
    high.push_back(r.censored ? std::numeric_limits<double>::infinity() : r.value);
    out.bounds += r.censored ? 1 : 0;
    if (!r.censored) out.largest = std::fmax(out.largest, r.value);
  }
  out.n = static_cast<int>(low.size());
  if (out.n == 0) return out;
  std::sort(low.begin(), low.end());
  std::sort(high.begin(), high.end());
  out.smallest = low.front();
  // known if bounds do not change it: the true values may be any larger ones
  out.at_least = middle_of(low);
  const double at_most = middle_of(high);
  out.median.value = at_most == out.at_least ? at_most : std::numeric_limits<double>::infinity();
  if (const int k = study::order_of_median(out.n); k > 0)
    out.median.interval = {low[k - 1], high[high.size() - static_cast<std::size_t>(k)]};
  if (out.bounds == 0 && low.front() > 0) {
    for (const double value : low) logs.add(std::log(value));
    out.log_scatter = logs.standard_deviation();
  }
  return out;
}

WallEnsemble ensemble_of(const Campaign& campaign) {
  WallEnsemble out;
  const study::Answered samples = study::answered_of(campaign);
  const auto over = [&](const auto& read) {
    std::vector<Reading> readings;
    for (const SampleRecord* record : samples.record) readings.push_back(read(record->responses));
    return of_walls(readings);
  };
  out.peak_reaction = over([](const Responses& r) {
    return Reading{r.peak_reaction, r.censored_peak};
  });
  out.displacement_at_peak = over([](const Responses& r) {
    return Reading{r.displacement_at_peak, r.censored_peak};
  });
  out.displacement_at_80 = over([](const Responses& r) {
    return Reading{r.displacement_at_80, r.censored_80};
  });
  for (const double left : campaign.study.fractions) {
    out.left.push_back(left);
    out.capacity.push_back(over([&](const Responses& r) {
      const auto fall = std::find_if(r.falls.begin(), r.falls.end(),
                                     [&](const FallTo& f) { return f.fraction == left; });
      return fall == r.falls.end() ? Reading{} : Reading{fall->displacement, fall->censored};
    }));
  }
  out.mode = study::shares_of(samples);
  std::stable_sort(out.mode.begin(), out.mode.end(),
                   [](const Share& a, const Share& b) { return a.count > b.count; });
  std::erase_if(out.mode,
                [](const Share& share) { return share.count == 0 || share.modes.size() > 1; });
  return out;
}

}  // namespace wythe
