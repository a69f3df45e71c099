// Goes through readings in ascending order with falls and samples at risk: curve (7.4), interval (7.5),
// mean (7.6) and percentiles (7.6b). The lognormal is fitted by expectation and maximisation. Readings must be sorted, equal
// observed ones before censored ones. Weights by count then let a bootstrap use one order for all replicates.
#include "statistics/survival.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <utility>

#include "statistics/intervals.h"
#include "statistics/scatter.h"

namespace wythe::study {
namespace {

// Calls visit(value, events, at_risk) at every observed value, weighted by count.
template <class Visit>
void walk(const std::vector<Reading>& readings, const Counts& count, const Visit& visit) {
  int at_risk = 0;
  for (int c : count) at_risk += c;
  for (std::size_t i = 0; i < readings.size();) {
    const double value = readings[i].value;
    int events = 0, leaving = 0;
    for (; i < readings.size() && readings[i].value == value; ++i) {
      leaving += count[i];
      if (!readings[i].censored) events += count[i];
    }
    if (events > 0) visit(value, events, at_risk);
    at_risk -= leaving;
  }
}

// Means of x and x^2 of a product of independent beta variables.
struct BetaProduct {
  double mean = 1, square = 1;
  [[nodiscard]] BetaProduct times(double a, double b) const {
    const double n = a + b;
    return {mean * a / n, square * a * (a + 1) / (n * (n + 1))};
  }
  // The beta variable with the same two means.
  struct Beta {
    double a, b;
    [[nodiscard]] double samples() const { return a + b - 1; }  // of which it is the share (7.26)
  };
  [[nodiscard]] Beta matched() const {
    const double n = (mean - square) / (square - mean * mean);
    return {mean * n, (1 - mean) * n};
  }
};

// The share that goes beyond a value after some of n samples have fallen at smaller ones (7.4), with its interval (7.5).
class Going {
 public:
  explicit Going(int n) : n_(n), left_(n) {}

  void fall(int events, int at_risk) {
    all_known_ = all_known_ && at_risk == left_;
    left_ -= events;
    // counted, not multiplied, so that the last event gives exactly 0
    share_ = events == at_risk ? 0 : share_ * (1 - static_cast<double>(events) / at_risk);
    fallen_ = fallen_.times(at_risk - events + 1, events);
  }
  // `beyond`: samples of which it is known that they go beyond the value.
  [[nodiscard]] Estimate share(int beyond) const {
    if (all_known_ && beyond == left_) return {share_, share_estimate(left_, n_).interval};
    return {share_, {low(beyond), left_ == n_ ? 1 : end(fallen_, 0.975).high}};
  }

 private:
  [[nodiscard]] double low(int beyond) const {
    return beyond == 0 ? 0 : end(fallen_.times(beyond, 1), 0.025).low;
  }
  // Few samples: the quantile at this level. Many: Wilson's interval.
  [[nodiscard]] Interval end(const BetaProduct& product, double level) const {
    const auto by = product.matched();
    if (by.samples() >= kFewestForBootstrap) return score_interval(share_, by.samples());
    const double quantile = beta_quantile(level, by.a, by.b);
    return {quantile, quantile};
  }

  int n_, left_;
  bool all_known_ = true;
  double share_ = 1;
  BetaProduct fallen_;
};

// Means of x and x^2 of a standard normal beyond `a`.
struct Tail {
  double mean, square;
};
Tail beyond(double a) {
  const double left = normal_cdf(-a);
  // for large a the ratio tends to a, exact to 1e-6 here
  const double mill = left > 1e-280 ? std::exp(-a * a / 2) / 2.5066282746310002 / left : a + 1 / a;
  return {mill, 1 + a * mill};
}

struct Normal {
  double mean, sigma;
};

// Logarithms of weighted readings: the observed ones as sums about their mean, the censored ones one by one.
struct Logs {
  double n = 0;  // observed and censored
  Moments observed;
  std::vector<std::pair<double, double>> censored;  // logarithm, weight
};

Logs logs_of(const std::vector<Reading>& readings, const Counts& count) {
  Logs logs;
  for (std::size_t i = 0; i < readings.size(); ++i) {
    const double log = count[i] > 0 ? std::log(readings[i].value) : 0;
    logs.n += count[i];
    if (!readings[i].censored) {
      for (int k = 0; k < count[i]; ++k) logs.observed.add(log);
    } else if (!logs.censored.empty() && logs.censored.back().first == log) {
      logs.censored.back().second += count[i];
    } else if (count[i] > 0) {
      logs.censored.emplace_back(log, count[i]);
    }
  }
  return logs;
}

// One step of expectation and maximisation: censored values are replaced by their expected values beyond the bound.
Normal expected_step(const Logs& logs, Normal now) {
  const double sd = logs.observed.standard_deviation(), m = logs.observed.n();
  double sum = m * (logs.observed.mean() - now.mean) / now.sigma;
  double square = sum * sum / m + (m - 1) * sd * sd / (now.sigma * now.sigma);
  for (const auto& [log, weight] : logs.censored) {
    const Tail tail = beyond((log - now.mean) / now.sigma);
    sum += weight * tail.mean, square += weight * tail.square;
  }
  const double shift = sum / logs.n;
  return {now.mean + now.sigma * shift,
          now.sigma * std::sqrt(std::fmax(square / logs.n - shift * shift, 0.0))};
}

double misfit_of(const Lognormal& fit, const std::vector<ExceedancePoint>& points) {
  double misfit = 0, before = 1;
  for (const ExceedancePoint& p : points) {
    const double expected = fit.exceedance(p.value);
    misfit =
        std::max({misfit, std::fabs(expected - p.probability.value), std::fabs(expected - before)});
    before = p.probability.value;
  }
  return std::isfinite(fit.median) ? misfit : kUnset;
}

}  // namespace

std::vector<Reading> in_order(std::vector<Reading> readings) {
  std::stable_sort(readings.begin(), readings.end(), [](const Reading& a, const Reading& b) {
    return a.value != b.value ? a.value < b.value : a.censored < b.censored;
  });
  return readings;
}

std::vector<ExceedancePoint> kaplan_meier(const std::vector<Reading>& readings) {
  std::vector<ExceedancePoint> points;
  Going going(static_cast<int>(readings.size()));
  walk(readings, Counts(readings.size(), 1), [&](double value, int events, int at_risk) {
    going.fall(events, at_risk);
    points.push_back({value, going.share(at_risk - events)});
  });
  return points;
}

Estimate share_before(const std::vector<Reading>& readings, double x) {
  const auto n = static_cast<int>(readings.size());
  int before = 0, fallen = 0;
  for (const Reading& r : readings)
    if (r.value < x) ++before, fallen += r.censored ? 0 : 1;
  const bool all_known = fallen == before;
  if (all_known || before == n) {
    if (!all_known && fallen == 0) return {};
    Estimate share = share_estimate(fallen, n);
    if (!all_known) share.interval.high = 1;
    return share;
  }
  Going going(n);
  walk(readings, Counts(readings.size(), 1), [&](double value, int events, int at_risk) {
    if (value < x) going.fall(events, at_risk);
  });
  const Estimate beyond = going.share(n - before);
  return {1 - beyond.value, {1 - beyond.interval.high, 1 - beyond.interval.low}};
}

double survival_mean(const std::vector<Reading>& readings, const Counts& count) {
  double survival = 1, mean = 0, reached = 0, last = 0;
  for (std::size_t i = 0; i < readings.size(); ++i)
    if (count[i] > 0) last = readings[i].value;
  walk(readings, count, [&](double value, int events, int at_risk) {
    mean += survival * (value - reached);
    reached = value;
    survival = events == at_risk ? 0 : survival * (1 - static_cast<double>(events) / at_risk);
  });
  return mean + survival * (last - reached);
}

// A value takes the places from the mass below it on, as many as its own mass; the mass of bounds that ended goes to what
// was still going on (7.6b). Masses are whole numbers as long as no bound lies below.
double survival_quantile(const std::vector<Reading>& readings, const Counts& count, double p) {
  constexpr double kRounding = 1e-9;
  const int n = std::accumulate(count.begin(), count.end(), 0);
  const double place = p * (n - 1);
  double left = n, last = -1, before = kUnset, answer = std::numeric_limits<double>::infinity();
  walk(readings, count, [&](double value, int events, int at_risk) {
    const double first = last + 1;
    left = events == at_risk ? 0 : left - events * (left / at_risk);
    const double own_last = n - left - 1;
    if (std::isinf(answer) && place <= own_last + kRounding)
      answer = place < first && before < value ? before + (place - last) * (value - before) : value;
    last = own_last, before = value;
  });
  return answer;
}

double Lognormal::exceedance(double x) const {
  return x > 0 ? normal_cdf(-std::log(x / median) / beta) : 1;
}

Lognormal fit_lognormal(const std::vector<Reading>& readings, const Counts& count) {
  for (std::size_t i = 0; i < readings.size(); ++i)
    if (count[i] > 0 && !(readings[i].value > 0)) return {};
  const Logs logs = logs_of(readings, count);
  if (logs.observed.n() < 2 || !(logs.observed.standard_deviation() > 0)) return {};
  Normal now{logs.observed.mean(), logs.observed.standard_deviation()};
  constexpr int kMostSteps = 500;
  constexpr double kStill = 1e-8;  // change of a step; far below the scatter of any sample
  for (int step = 0; step < kMostSteps; ++step) {
    const Normal next = expected_step(logs, now);
    const double moved = std::fabs(next.mean - now.mean) + std::fabs(next.sigma - now.sigma);
    now = next;
    if (moved < kStill) break;
  }
  return {std::exp(now.mean), now.sigma};
}

LognormalReplicates lognormal_replicates(const std::vector<Reading>& readings,
                                         const Lognormal& fit) {
  const Resampled part(readings.size());
  const std::vector<Reading> taken = part.of(readings);
  const Lognormal centre =
      part.is_all() ? fit : fit_lognormal(taken, Counts(static_cast<std::size_t>(part.size()), 1));
  LognormalReplicates out;
  std::vector<double> medians, betas;
  each_replicate(part.size(), [&](const Counts& count) {
    Lognormal again = fit_lognormal(taken, count);
    if (!std::isfinite(again.beta)) return;
    again.median = part.of_all(again.median, centre.median, fit.median);
    again.beta = part.of_all(again.beta, centre.beta, fit.beta);
    out.fit.push_back(again);
    medians.push_back(again.median), betas.push_back(again.beta);
  });
  out.median = percentile_interval(fit.median, std::move(medians)).interval;
  out.beta = percentile_interval(fit.beta, std::move(betas)).interval;
  return out;
}

Exceedance exceedance_of(const std::string& quantity, std::vector<Reading> readings) {
  readings = in_order(std::move(readings));
  const int n = static_cast<int>(readings.size());
  Exceedance out;
  out.quantity = quantity, out.n = n;
  for (const Reading& r : readings) out.censored += r.censored ? 1 : 0;
  out.point = kaplan_meier(readings);
  // of few values the fit of a median beyond most of them rests on one or two: 6.5 m of a wall of 0.8 m
  const bool is_known = n >= kFewestForBootstrap || 2 * out.censored <= n;
  const Lognormal fit = is_known ? fit_lognormal(readings, Counts(n, 1)) : Lognormal{};
  out.median.value = fit.median, out.beta.value = fit.beta;
  if (n >= kFewestForBootstrap && std::isfinite(fit.median)) {
    const LognormalReplicates by = lognormal_replicates(readings, fit);
    out.median.interval = by.median, out.beta.interval = by.beta;
  } else if (std::isfinite(fit.median)) {
    const LognormalIntervals by = lognormal_intervals(fit.median, fit.beta, n - out.censored);
    out.median.interval = by.median, out.beta.interval = by.beta;
  }
  out.misfit = misfit_of(fit, out.point);
  return out;
}

}  // namespace wythe::study
