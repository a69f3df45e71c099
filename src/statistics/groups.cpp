// Groups of samples: the modes that occur, Table 3 of each group, shares, and the certainty of names.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>
#include <unordered_map>
#include <utility>

#include "statistics/bootstrap.h"
#include "statistics/correlation.h"
#include "statistics/intervals.h"
#include "statistics/statistics_parts.h"
#include "statistics/survival.h"

namespace wythe::study {
namespace {

const std::vector<std::string>& paper_modes() {
  static const std::vector<std::string> kModes = {"FM-1", "FM-2", "FM-3", "FM-4", "FM-5"};
  return kModes;
}

bool holds(const std::vector<std::string>& names, const std::string& name) {
  return std::find(names.begin(), names.end(), name) != names.end();
}

// All of FM-1 ... FM-5 if any of them occurs, other names alphabetically, "unclear" last.
std::vector<std::string> order_modes(const std::set<std::string>& found) {
  std::vector<std::string> modes;
  for (const std::string& name : paper_modes())
    if (found.contains(name)) {
      modes = paper_modes();
      break;
    }
  for (const std::string& name : found)
    if (!holds(modes, name) && name != "unclear") modes.push_back(name);
  if (found.contains("unclear")) modes.emplace_back("unclear");
  return modes;
}

Group group_of(const Answered& samples, const std::string& name,
               const std::vector<std::string>& modes) {
  Group group{name, modes, {}};
  for (const SampleRecord* record : samples.record)
    if (holds(modes, record->failure_mode.name)) group.record.push_back(record);
  return group;
}

// Mean and coefficient of variation of values, each taken count times. Sums
// about the mean of all lose no digits and need no division for each value.
class Centred {
 public:
  explicit Centred(const Column& values) {
    for (const double value : values) all_.add(value);
    for (const double value : values) deviation_.push_back(value - all_.mean());
  }
  [[nodiscard]] const Moments& all() const { return all_; }
  [[nodiscard]] double cov() const { return all_.standard_deviation() / all_.mean(); }
  struct Pair {
    double mean, cov;
  };
  [[nodiscard]] Pair of(const Counts& count) const {
    constexpr std::size_t kTogether = 4;  // independent sums, for speed
    double first[kTogether] = {}, second[kTogether] = {};
    const std::size_t n = deviation_.size(), whole = n - n % kTogether;
    for (std::size_t i = 0; i < whole; i += kTogether)
      for (std::size_t k = 0; k < kTogether; ++k) {
        const double d = deviation_[i + k], weighted = count[i + k] * d;
        first[k] += weighted, second[k] += weighted * d;
      }
    for (std::size_t i = whole; i < n; ++i) {
      const double d = deviation_[i];
      first[0] += count[i] * d, second[0] += count[i] * d * d;
    }
    return from((first[0] + first[1]) + (first[2] + first[3]),
                (second[0] + second[1]) + (second[2] + second[3]), static_cast<double>(n));
  }
  // The sums without value i.
  [[nodiscard]] Pair without(std::size_t i) const {
    const double d = deviation_[i], n = static_cast<double>(deviation_.size());
    return from(-d, squares() - d * d, n - 1);
  }

 private:
  [[nodiscard]] double squares() const {
    const double sd = all_.standard_deviation();
    return sd * sd * static_cast<double>(deviation_.size() - 1);
  }
  [[nodiscard]] Pair from(double first, double second, double n) const {
    const double mean = all_.mean() + first / n;
    const double left = std::fmax(second - first * first / n, 0.0);
    return {mean, std::sqrt(left / (n - 1)) / mean};
  }
  Moments all_;
  std::vector<double> deviation_;
};

// Of ascending values, each taken count times, n in all.
double median_of(const Column& ascending, const Counts& count) {
  const int n = static_cast<int>(ascending.size());
  double low = kUnset;
  int before = 0;
  for (std::size_t i = 0; i < ascending.size(); ++i) {
    if (count[i] == 0) continue;
    if (before <= (n - 1) / 2) low = ascending[i];
    before += count[i];
    if (before > n / 2) return 0.5 * (low + ascending[i]);
  }
  return kUnset;
}

// Every estimate of Table 3 from the same replicates of ascending readings.
struct Replicated {
  std::vector<double> mean, cov, median, survival_mean, survival_median;
};
Replicated replicated(const std::vector<Reading>& readings, const Column& values,
                      const Centred& centred, bool can_be_censored) {
  Replicated out;
  for (auto* of : {&out.mean, &out.cov, &out.median}) of->reserve(kReplicates);
  each_replicate(static_cast<int>(values.size()), [&](const Counts& count) {
    const Centred::Pair pair = centred.of(count);
    out.mean.push_back(pair.mean), out.cov.push_back(pair.cov);
    out.median.push_back(median_of(values, count));
    if (!can_be_censored) return;
    out.survival_mean.push_back(survival_mean(readings, count));
    out.survival_median.push_back(survival_quantile(readings, count, 0.5));
  });
  return out;
}

// Closed forms for few readings, because the bootstrap of few samples covers less than 95 %. The mean up to
// the end of the pushes has an interval only if all bounds lie at that end; it is that of the recorded values.
void put_few_intervals(const std::vector<Reading>& readings, bool can_be_censored, Summary& out) {
  Moments moments;
  bool at_the_end = true;
  Column high;
  for (const Reading& r : readings) {
    moments.add(r.value);
    at_the_end = at_the_end && (!r.censored || r.value == readings.back().value);
    high.push_back(r.censored ? std::numeric_limits<double>::infinity() : r.value);
  }
  std::sort(high.begin(), high.end());
  out.mean.interval = moments.student().interval;
  out.cov = vangel(out.cov.value, out.n);
  const std::size_t k = order_of_median(out.n);
  if (k > 0) out.median.interval = {readings[k - 1].value, readings[readings.size() - k].value};
  if (!can_be_censored) return;
  if (at_the_end) out.survival_mean.interval = out.mean.interval;
  if (k > 0) out.survival_median.interval = {readings[k - 1].value, high[high.size() - k]};
}

// Intervals from the resampled part, converted to all readings. All values of `out` are set already.
void put_intervals(const std::vector<Reading>& readings, bool can_be_censored, Summary& out) {
  const Resampled part(readings.size());
  const std::vector<Reading> taken = part.of(readings);
  const Column values = values_of(taken);
  const Centred centred(values);
  Replicated by = replicated(taken, values, centred, can_be_censored);
  std::vector<double> mean_without, cov_without;
  for (std::size_t i = 0; i < values.size(); ++i) {
    const Centred::Pair pair = centred.without(i);
    mean_without.push_back(pair.mean), cov_without.push_back(pair.cov);
  }
  const auto bca = [&](Estimate& estimate, double of_part, std::vector<double>& replicates,
                       const std::vector<double>& without) {
    if (std::isnan(estimate.value)) return;
    estimate = part.of_all(bca_interval(of_part, std::move(replicates), acceleration_of(without)),
                           estimate.value);
  };
  const auto percentile = [&](Estimate& estimate, double of_part, std::vector<double>& replicates) {
    if (std::isnan(estimate.value)) return;
    estimate = part.of_all(percentile_interval(of_part, std::move(replicates)), estimate.value);
  };
  const Counts once(values.size(), 1);
  bca(out.mean, centred.all().mean(), by.mean, mean_without);
  bca(out.cov, centred.cov(), by.cov, cov_without);
  percentile(out.median, median_of(values, once), by.median);
  if (!can_be_censored) return;
  percentile(out.survival_mean, survival_mean(taken, once), by.survival_mean);
  percentile(out.survival_median, survival_quantile(taken, once, 0.5), by.survival_median);
}

Summary summarise_one(std::vector<Reading> readings, bool can_be_censored) {
  readings = in_order(std::move(readings));
  Summary out;
  out.n = static_cast<int>(readings.size());
  if (out.n == 0) return out;
  const Column values = values_of(readings);
  const Counts once(values.size(), 1);
  for (const Reading& r : readings) out.censored += r.censored ? 1 : 0;
  out.min = values.front(), out.max = values.back();
  const Centred centred(values);
  out.standard_deviation = centred.all().standard_deviation();
  out.mean.value = centred.all().mean(), out.cov.value = centred.cov();
  out.median.value = median_of(values, once);
  out.percentile_5 = quantile_of(values, 0.05), out.percentile_95 = quantile_of(values, 0.95);
  if (can_be_censored) {
    out.survival_mean.value = survival_mean(readings, once);
    out.survival_median.value = survival_quantile(readings, once, 0.5);
    out.percentile_5 = survival_quantile(readings, once, 0.05);
    out.percentile_95 = survival_quantile(readings, once, 0.95);
  }
  if (out.n >= kFewestForBootstrap)
    put_intervals(readings, can_be_censored, out);
  else if (out.n >= kFewestForInterval)
    put_few_intervals(readings, can_be_censored, out);
  if (out.censored == out.n)  // lower bounds alone scatter little and show nothing
    out.mean.interval = out.cov.interval = out.median.interval = out.survival_mean.interval = {};
  return out;
}

Share share_of(const Group& group, int n) {
  const int count = static_cast<int>(group.record.size());
  return {group.name, group.modes, count, share_estimate(count, n)};
}

// The same name for readings with the same meaning.
std::string name_of(const NameReading& reading) {
  return reading.threshold.empty() ? "state " + reading.state
                                   : fmt::format("{} x {}", reading.threshold, reading.factor);
}

// Items by name, in the order of first occurrence.
template <class Item>
class ByName {
 public:
  Item& operator[](const std::string& name) {
    const auto [found, is_new] = place_.emplace(name, all.size());
    return is_new ? all.emplace_back() : all[found->second];
  }
  std::vector<Item> all;

 private:
  std::unordered_map<std::string, std::size_t> place_;
};

}  // namespace

Answered answered_of(const Campaign& campaign) {
  Answered samples{campaign, {}, {}};
  std::set<std::string> found;
  for (const SampleRecord& record : campaign.records) {
    if (!is_answered(record)) continue;
    samples.record.push_back(&record);
    found.insert(record.failure_mode.name);
  }
  std::stable_sort(
      samples.record.begin(), samples.record.end(),
      [](const SampleRecord* a, const SampleRecord* b) { return a->sample < b->sample; });
  samples.modes = order_modes(found);
  return samples;
}

Answered for_fits(const Answered& samples) {
  const Resampled part(samples.record.size(), kMostFitted);
  return {samples.campaign, part.of(samples.record), samples.modes};
}

Group all_of(const Answered& samples) { return {"all", samples.modes, samples.record}; }

std::vector<Group> modes_of(const Answered& samples) {
  std::vector<Group> groups;
  for (const std::string& mode : samples.modes) groups.push_back(group_of(samples, mode, {mode}));
  return groups;
}

std::vector<Group> unions_of(const Answered& samples) {
  if (!holds(samples.modes, "FM-1")) return {};
  return {group_of(samples, "FM-1 + FM-2", {"FM-1", "FM-2"}),
          group_of(samples, "FM-3 + FM-4", {"FM-3", "FM-4"})};
}

Group with_value(const Group& group, const Quantity& quantity) {
  Group known{group.name, group.modes, {}};
  for (const SampleRecord* record : group.record)
    if (quantity.read(record->responses).is_known()) known.record.push_back(record);
  return known;
}

std::vector<Reading> readings_of(const Group& group, const Quantity& quantity) {
  std::vector<Reading> readings;
  for (const SampleRecord* record : group.record)
    if (const Reading reading = quantity.read(record->responses); reading.is_known())
      readings.push_back(reading);
  return readings;
}

bool all_censored(const Group& group, const Quantity& quantity) {
  const std::vector<Reading> readings = readings_of(group, quantity);
  return std::all_of(readings.begin(), readings.end(), [](const Reading& r) { return r.censored; });
}

GroupSummary summarise(const Group& group) {
  GroupSummary out{group.name, group.modes, {}};
  for (const Quantity& quantity : quantities()) {
    out.quantity.push_back(summarise_one(readings_of(group, quantity), quantity.can_be_censored));
    out.quantity.back().without_value =
        static_cast<int>(group.record.size()) - out.quantity.back().n;
  }
  return out;
}

std::vector<Share> shares_of(const Answered& samples) {
  std::vector<Share> shares;
  for (const Group& group : modes_of(samples)) shares.push_back(share_of(group, samples.n()));
  for (const Group& group : unions_of(samples)) shares.push_back(share_of(group, samples.n()));
  return shares;
}

std::vector<NameSensitivity> name_sensitivities(const Answered& samples) {
  ByName<NameSensitivity> by;
  for (const SampleRecord* record : samples.record)
    for (const NameReading& other : record->failure_mode.sensitivity) {
      NameSensitivity& s = by[name_of(other)];
      if (s.n++ == 0) s.reading = other, s.reading.name.clear();
      s.differs += other.name != record->failure_mode.name ? 1 : 0;
    }
  for (NameSensitivity& s : by.all) s.share = share_estimate(s.differs, s.n);
  return std::move(by.all);
}

std::vector<FlagCount> flag_counts(const Answered& samples) {
  ByName<FlagCount> by;
  for (const SampleRecord* record : samples.record)
    for (const Evidence& flag : record->failure_mode.flags) {
      FlagCount& f = by[flag.element + '\n' + flag.measure];
      if (f.n++ == 0) f.flag = flag, f.flag.value = 0;
      f.raised += flag.holds() ? 1 : 0;
    }
  for (FlagCount& f : by.all) f.share = share_estimate(f.raised, f.n);
  return std::move(by.all);
}

}  // namespace wythe::study
