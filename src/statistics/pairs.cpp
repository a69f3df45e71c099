// Computes signs, median, means, scatter and gains of paired differences, option less base (7.11) to (7.13). A lower
// bound leaves the difference open on its side, and open pairs count against a finding. Means of displacements are cut
// at the smallest bound; other means leave out pairs with bounds. With too few pairs, or too many cut, there is no mean.
#include "statistics/pairs.h"

#include <algorithm>
#include <cmath>

#include "statistics/bootstrap.h"
#include "statistics/intervals.h"

namespace wythe::study {
namespace {

constexpr double kLevel = 0.05;
constexpr int kFewestForGain = 10;  // pairs to correlate with an input
constexpr int kFewestBesideBounds =
    5;                             // fewest pairs without a bound for a mean, if others have one
constexpr double kCut = 1.01;      // a value above this many times the end of the means is cut
constexpr double kEqualTo = 1e-6;  // a smaller relative difference is none

struct Sides {
  Column base, option, difference;
};

Sides sides_of(const PairedResponse& r) {
  Sides sides;
  for (const PairValue& pair : r.pair) {
    if (!enters_means(r, pair)) continue;
    double base = pair.base.value, option = pair.option.value;
    if (!std::isnan(r.up_to)) base = std::min(base, r.up_to), option = std::min(option, r.up_to);
    sides.base.push_back(base);
    sides.option.push_back(option);
    sides.difference.push_back(option - base);
  }
  return sides;
}

Moments moments_of(const Column& values) {
  Moments moments;
  for (const double value : values) moments.add(value);
  return moments;
}

double mean_of(const Column& values, const Counts& count) {
  double sum = 0;
  int n = 0;
  for (std::size_t i = 0; i < values.size(); ++i) sum += count[i] * values[i], n += count[i];
  return sum / n;
}

double cov_of(const Column& values, const Counts& count) {
  const double mean = mean_of(values, count);
  double squares = 0;
  int n = 0;
  for (std::size_t i = 0; i < values.size(); ++i)
    squares += count[i] * (values[i] - mean) * (values[i] - mean), n += count[i];
  return n > 1 && mean != 0 ? std::sqrt(squares / (n - 1)) / std::fabs(mean) : kUnset;
}

void count_signs(PairedResponse& r) {
  for (const PairValue& pair : r.pair) {
    const Interval d = difference_bounds(pair);
    const double same =
        kEqualTo * std::max(std::fabs(pair.base.value), std::fabs(pair.option.value));
    r.bounds += pair.base.censored || pair.option.censored ? 1 : 0;
    if (d.low > same)
      ++r.larger;
    else if (d.high < -same)
      ++r.smaller;
    else if (d.low >= -same && d.high <= same)
      ++r.equal;
    else
      ++r.undecided;
  }
}

// Finds the smallest bound. No other bound is below it, so min(value, it) is known for all values.
void cut_at_first_bound(PairedResponse& r) {
  for (const PairValue& pair : r.pair)
    for (const Reading* side : {&pair.base, &pair.option})
      if (side->censored && !(r.up_to <= side->value)) r.up_to = side->value;
}

// Whether a mean is meaningful. If some pairs have bounds, at least half must have none. A cut
// must leave most pairs unchanged, and some scatter, or the mean would be that of the cut.
bool has_means(const PairedResponse& r, const Sides& sides) {
  const int n = static_cast<int>(sides.difference.size());
  if (std::isnan(r.up_to))
    return n > 0 && (r.bounds == 0 || (n >= kFewestBesideBounds && 2 * n >= r.pairs));
  int cut = 0, known = 0;
  for (const PairValue& pair : r.pair) {
    cut += std::max(pair.base.value, pair.option.value) > kCut * r.up_to ? 1 : 0;
    known += pair.base.censored && pair.option.censored ? 0 : 1;
  }
  const bool scatters = moments_of(sides.difference).standard_deviation() > 0;
  return known > 0 && 2 * cut <= r.pairs && (cut == 0 || scatters);
}

void take_means(PairedResponse& r, const Sides& sides) {
  r.base = moments_of(sides.base).student();
  r.option = moments_of(sides.option).student();
  const Moments difference = moments_of(sides.difference);
  r.difference = difference.student();
  r.standard_deviation = difference.standard_deviation();
  const int n = r.in_means;
  const Resampled part(sides.difference.size());
  const Column few = part.of(sides.difference);
  const Estimate of_few =
      bca_bootstrap(part.size(), [&](const Counts& count) { return mean_of(few, count); });
  r.difference_bootstrap = part.of_all(of_few, difference.mean()).interval;
  Moments logarithm;
  bool positive = n > 0;
  for (std::size_t i = 0; i < sides.base.size(); ++i) {
    positive = positive && sides.base[i] > 0 && sides.option[i] > 0;
    if (positive) logarithm.add(std::log(sides.option[i] / sides.base[i]));
  }
  if (!positive) return;
  const Estimate log_ratio = logarithm.student();
  r.ratio = {std::exp(log_ratio.value),
             {std::exp(log_ratio.interval.low), std::exp(log_ratio.interval.high)}};
}

void take_scatter(PairedResponse& r, const Sides& sides) {
  if (std::isnan(r.up_to)) {  // values that are cut have no scatter of their own
    const Resampled part(sides.base.size());
    const Column bases = part.of(sides.base), options = part.of(sides.option);
    const Counts once(sides.base.size(), 1);
    const auto scatter = [&](const auto& of) {
      if (r.in_means < kFewestForBootstrap) return Estimate{of(bases, options, once), {}};
      const Estimate of_few = percentile_bootstrap(
          part.size(), [&](const Counts& count) { return of(bases, options, count); });
      return part.of_all(of_few, of(sides.base, sides.option, once));
    };
    r.cov_base = scatter(
        [](const Column& base, const Column&, const Counts& count) { return cov_of(base, count); });
    r.cov_option = scatter([](const Column&, const Column& option, const Counts& count) {
      return cov_of(option, count);
    });
    r.cov_ratio = scatter([](const Column& base, const Column& option, const Counts& count) {
      const double of_base = cov_of(base, count);
      return of_base > 0 ? cov_of(option, count) / of_base : kUnset;
    });
    if (r.in_means < kFewestForBootstrap) {
      r.cov_base = vangel(r.cov_base.value, r.in_means);
      r.cov_option = vangel(r.cov_option.value, r.in_means);
    }
  }
  r.correlation = pearson(sides.base, sides.option);
  const double base = moments_of(sides.base).standard_deviation();
  const double option = moments_of(sides.option).standard_deviation();
  const double spread = r.standard_deviation * r.standard_deviation;
  if (spread > 0) r.worth = (base * base + option * option) / spread;
}

// The median of ascending values, which may be infinite.
double middle_of(const Column& ascending) {
  const std::size_t n = ascending.size();
  return n % 2 == 1 ? ascending[n / 2] : 0.5 * (ascending[n / 2 - 1] + ascending[n / 2]);
}

// The median and its order statistics, from the lower and the upper ends of the differences.
void take_median(PairedResponse& r) {
  if (r.pairs == 0) return;
  Column low, high;
  for (const PairValue& pair : r.pair) {
    const Interval d = difference_bounds(pair);
    low.push_back(d.low), high.push_back(d.high);
  }
  std::sort(low.begin(), low.end());
  std::sort(high.begin(), high.end());
  r.median_bounds = {middle_of(low), middle_of(high)};
  int k = -1;
  while (fair_tail(k + 1, r.pairs) <= kLevel / 2) ++k;
  if (k < 0) return;  // fewer than six pairs
  r.median_interval = {low[k], high[r.pairs - 1 - k]};
}

void take_shares(PairedResponse& r, int lost) {
  const int n = r.pairs;
  r.share_larger = share_estimate(r.larger, n);
  r.share_larger.interval.high = share_estimate(r.larger + r.undecided, n).interval.high;
  const double all = n + lost + r.without_value;
  if (all > 0)
    r.share_larger_with_lost = {r.larger / all,
                                (r.larger + r.undecided + lost + r.without_value) / all};
  r.sign_test_p = sign_test(r.larger, r.smaller, r.undecided);
}

// Mean of the differences in the k-th third of the input.
Estimate third(const Column& difference, const std::vector<int>& bin, int k) {
  Moments moments;
  for (std::size_t i = 0; i < bin.size(); ++i)
    if (bin[i] == k) moments.add(difference[i]);
  return moments.student();
}

double p_of(double rho, int n) {
  const double z =
      std::atanh(std::clamp(rho, -1.0, 1.0)) * std::sqrt((n - 3) / (1 + rho * rho / 2));
  return std::isnan(rho) ? kUnset : std::erfc(std::fabs(z) / std::sqrt(2.0));
}

}  // namespace

double fair_tail(int k, int n) {
  if (k < 0) return 0;
  double sum = 0;
  for (int i = 0; i <= std::min(k, n); ++i)
    sum += std::exp(std::lgamma(n + 1.0) - std::lgamma(i + 1.0) - std::lgamma(n - i + 1.0) -
                    n * std::log(2.0));
  return std::min(1.0, sum);
}

double sign_test(int a, int b, int open) {
  const int n = a + b + open;
  if (n == 0) return kUnset;
  const int fewer = std::min(std::min(a, b) + open, n / 2);
  return std::min(1.0, 2 * fair_tail(fewer, n));
}

std::vector<double> holm(const std::vector<double>& p) {
  std::vector<std::size_t> order;
  for (std::size_t i = 0; i < p.size(); ++i)
    if (!std::isnan(p[i])) order.push_back(i);
  std::sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return p[a] < p[b]; });
  std::vector<double> adjusted(p.size(), kUnset);
  double largest = 0;
  for (std::size_t rank = 0; rank < order.size(); ++rank) {
    largest = std::max(largest, p[order[rank]] * static_cast<double>(order.size() - rank));
    adjusted[order[rank]] = std::min(1.0, largest);
  }
  return adjusted;
}

Interval difference_bounds(const PairValue& pair) {
  const double d = pair.option.value - pair.base.value;
  return {pair.base.censored ? -kInfinity : d, pair.option.censored ? kInfinity : d};
}

PairedResponse paired_response(std::vector<PairValue> pairs, bool cut, int lost) {
  PairedResponse r;
  for (PairValue& pair : pairs) {
    if (!std::isfinite(pair.base.value) || !std::isfinite(pair.option.value))
      ++r.without_value;
    else
      r.pair.push_back(pair);
  }
  r.pairs = static_cast<int>(r.pair.size());
  count_signs(r);
  if (cut) cut_at_first_bound(r);
  take_median(r);
  take_shares(r, lost);
  const Sides sides = sides_of(r);
  if (!has_means(r, sides)) return r;
  r.in_means = static_cast<int>(sides.difference.size());
  take_means(r, sides);
  take_scatter(r, sides);
  return r;
}

bool enters_means(const PairedResponse& response, const PairValue& pair) {
  return !std::isnan(response.up_to) || !(pair.base.censored || pair.option.censored);
}

Column differences(const PairedResponse& response) { return sides_of(response).difference; }

std::vector<GainAgainstInput> gains(const std::vector<Column>& input,
                                    const std::vector<std::string>& name,
                                    const Column& difference) {
  std::vector<GainAgainstInput> out;
  const int n = static_cast<int>(difference.size());
  const Moments moments = moments_of(difference);
  if (n < kFewestForGain || !(moments.standard_deviation() > 0)) return out;
  const Column rank = ranks(difference);
  std::vector<double> p;
  for (std::size_t k = 0; k < input.size(); ++k) {
    GainAgainstInput& gain = out.emplace_back();
    gain.input = name[k];
    gain.n = n;
    const double rho = pearson(ranks(input[k]), rank), r = pearson(input[k], difference);
    gain.spearman = fisher_z(rho, n, 0, 1 + rho * rho / 2);
    gain.p = p_of(rho, n);
    p.push_back(gain.p);
    const double spread = moments.standard_deviation(), slope = r * spread;
    const double half = student_95(n - 2) * spread * std::sqrt(std::max(0.0, 1 - r * r) / (n - 2));
    gain.slope = {slope, {slope - half, slope + half}};
    const std::vector<int> bin = equal_bins(input[k], 3);
    gain.low_third = third(difference, bin, 0);
    gain.middle_third = third(difference, bin, 1);
    gain.high_third = third(difference, bin, 2);
  }
  const std::vector<double> adjusted = holm(p);
  for (std::size_t k = 0; k < out.size(); ++k) out[k].p_adjusted = adjusted[k];
  return out;
}

bool is_named(const std::string& mode) { return !mode.empty() && mode != "unclear"; }

ModeTable mode_table(const std::vector<ChangedMode>& pairs, const std::vector<std::string>& order) {
  ModeTable table;
  table.modes = order;
  table.pairs = static_cast<int>(pairs.size());
  table.count.assign(order.size(), std::vector<int>(order.size(), 0));
  const auto place = [&](const std::string& mode) {
    return static_cast<std::size_t>(std::find(order.begin(), order.end(), mode) - order.begin());
  };
  for (const ChangedMode& pair : pairs) {
    ++table.count[place(pair.base)][place(pair.option)];
    if (!is_named(pair.base) || !is_named(pair.option))
      ++table.unclear;
    else if (pair.base != pair.option)
      table.changed.push_back(pair);
  }
  const int named = table.pairs - table.unclear;
  table.share_changed = share_estimate(static_cast<int>(table.changed.size()), named);
  std::vector<double> p;
  for (std::size_t m = 0; m < order.size(); ++m) {
    ModeShift& shift = table.shift.emplace_back();
    shift.mode = order[m];
    for (std::size_t other = 0; other < order.size(); ++other) {
      shift.base += table.count[m][other], shift.option += table.count[other][m];
      if (other == m || !is_named(order[m]) || !is_named(order[other])) continue;
      shift.went += table.count[m][other], shift.came += table.count[other][m];
    }
    if (!is_named(order[m])) {
      p.push_back(kUnset);
      continue;
    }
    const double n = named + 2, came = shift.came + 0.5, went = shift.went + 0.5;
    const double gap = (came - went) / n;
    const double half = kNormal95 * std::sqrt(std::max(0.0, (came + went) / n - gap * gap) / n);
    if (named > 0)
      shift.share_difference = {(shift.came - shift.went) / static_cast<double>(named),
                                {std::max(-1.0, gap - half), std::min(1.0, gap + half)}};
    shift.p = shift.came + shift.went > 0 ? sign_test(shift.came, shift.went) : 1;
    p.push_back(shift.p);
  }
  const std::vector<double> adjusted = holm(p);
  for (std::size_t m = 0; m < order.size(); ++m) {
    table.shift[m].p_adjusted = adjusted[m];
    if (!std::isnan(adjusted[m]) && !(table.p <= adjusted[m])) table.p = adjusted[m];
  }
  return table;
}

}  // namespace wythe::study
