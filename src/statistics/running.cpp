// Convergence of results as samples are added: running means (Fig. 8) and when they became precise.
#include <algorithm>
#include <array>
#include <cmath>
#include <map>

#include "core/to_int.h"
#include "statistics/intervals.h"
#include "statistics/statistics_parts.h"

namespace wythe::study {
namespace {

constexpr std::array kMeanTargets = {0.01, 0.02, 0.05};
constexpr std::array kShareTargets = {0.05, 0.1};

// Relative half-width after each sample.
std::vector<double> half_widths(const RunningMean& running) {
  std::vector<double> widths;
  for (const Estimate& mean : running.mean)
    widths.push_back(mean.interval.width() / 2 / std::fabs(mean.value));
  return widths;
}

// Half the widest Wilson interval of any mode after each sample.
std::vector<double> share_half_widths(const Answered& samples) {
  std::map<std::string, int> count;
  std::vector<double> widths;
  for (int n = 1; n <= samples.n(); ++n) {
    ++count[samples.record[n - 1]->failure_mode.name];
    double widest = 0;
    for (const auto& [name, of_mode] : count)
      widest = std::fmax(widest, share_estimate(of_mode, n).interval.width());
    widths.push_back(widest / 2);
  }
  return widths;
}

Precision precision_of(const std::string& what, double target, const std::vector<double>& widths) {
  Precision out{.what = what, .target = target};
  const int n = static_cast<int>(widths.size());
  for (int i = kFewestSamples; i <= n; ++i) {
    const bool met = widths[i - 1] < target;
    if (met && out.first_met == 0) out.first_met = i;
    if (met && out.held_from == 0) out.held_from = i;
    if (!met) out.held_from = 0;
  }
  if (n > 0) out.now = widths.back();
  if (out.held_from == 0 && std::isfinite(out.now))
    out.expected = std::max(kFewestSamples, to_int(std::ceil(n * std::pow(out.now / target, 2))));
  return out;
}

}  // namespace

std::vector<RunningMean> running_means(const Answered& samples) {
  std::vector<RunningMean> out;
  for (const Quantity& quantity : quantities()) {
    RunningMean running;
    Moments moments;
    bool all_censored = true;
    for (const SampleRecord* record : samples.record) {
      const Reading reading = quantity.read(record->responses);
      if (!reading.is_known()) continue;
      moments.add(reading.value);
      all_censored = all_censored && reading.censored;
      running.n.push_back(moments.n());
      running.mean.push_back(moments.student());
      if (all_censored) running.mean.back().interval = {};  // lower bounds alone show nothing
    }
    out.push_back(std::move(running));
  }
  return out;
}

std::vector<Precision> precisions(const Answered& samples,
                                  const std::vector<RunningMean>& running) {
  std::vector<Precision> out;
  for (std::size_t q = 0; q < running.size(); ++q)
    for (const double target : kMeanTargets)
      out.push_back(precision_of(key_of(quantities()[q]), target, half_widths(running[q])));
  for (const double target : kShareTargets)
    out.push_back(precision_of("share", target, share_half_widths(samples)));
  return out;
}

}  // namespace wythe::study
