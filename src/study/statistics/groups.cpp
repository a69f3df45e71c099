// Samples taken together: the modes that occur, Table 3 of each group, shares, how firm names are.
#include <algorithm>
#include <cmath>
#include <set>

#include "study/statistics/bootstrap.h"
#include "study/statistics/correlation.h"
#include "study/statistics/intervals.h"
#include "study/statistics/statistics_parts.h"
#include "study/statistics/survival.h"

namespace wythe::study {
namespace {

const std::vector<std::string>& paper_modes() {
  static const std::vector<std::string> kModes = {"FM-1", "FM-2", "FM-3", "FM-4", "FM-5"};
  return kModes;
}

bool holds(const std::vector<std::string>& names, const std::string& name) {
  return std::find(names.begin(), names.end(), name) != names.end();
}

// FM-1 ... FM-5 all where any of them occurs, other names by the alphabet, "unclear" last.
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

Moments moments_of(const Column& values, const Counts& count) {
  Moments moments;
  for (std::size_t i = 0; i < values.size(); ++i)
    for (int k = 0; k < count[i]; ++k) moments.add(values[i]);
  return moments;
}

double cov_of(const Column& values, const Counts& count) {
  const Moments moments = moments_of(values, count);
  return moments.standard_deviation() / moments.mean();
}

// Of ascending values, each taken count times.
double median_of(const Column& ascending, const Counts& count) {
  int n = 0;
  for (int c : count) n += c;
  double low = kUnset, high = kUnset;
  int before = 0;
  for (std::size_t i = 0; i < ascending.size(); ++i) {
    if (count[i] == 0) continue;
    if (before <= (n - 1) / 2) low = ascending[i];
    if (before <= n / 2) high = ascending[i];
    before += count[i];
  }
  return 0.5 * (low + high);
}

void treat_censored(const std::vector<Reading>& readings, Summary& out) {
  const int n = static_cast<int>(readings.size());
  out.survival_mean =
      percentile_bootstrap(n, [&](const Counts& count) { return survival_mean(readings, count); });
  out.survival_median = percentile_bootstrap(
      n, [&](const Counts& count) { return survival_quantile(readings, count, 0.5); });
  if (out.censored == 0) return;
  out.percentile_5 = survival_quantile(readings, Counts(n, 1), 0.05);
  out.percentile_95 = survival_quantile(readings, Counts(n, 1), 0.95);
}

Summary summarise_one(std::vector<Reading> readings, bool can_be_censored) {
  readings = in_order(std::move(readings));
  Summary out;
  out.n = static_cast<int>(readings.size());
  if (out.n == 0) return out;
  Column values;
  for (const Reading& r : readings) values.push_back(r.value), out.censored += r.censored ? 1 : 0;
  out.min = values.front(), out.max = values.back();
  out.standard_deviation = moments_of(values, Counts(out.n, 1)).standard_deviation();
  out.mean =
      bca_bootstrap(out.n, [&](const Counts& count) { return moments_of(values, count).mean(); });
  out.cov = bca_bootstrap(out.n, [&](const Counts& count) { return cov_of(values, count); });
  out.median =
      percentile_bootstrap(out.n, [&](const Counts& count) { return median_of(values, count); });
  out.percentile_5 = quantile_of(values, 0.05), out.percentile_95 = quantile_of(values, 0.95);
  if (can_be_censored) treat_censored(readings, out);
  if (out.censored == out.n)  // lower bounds alone scatter little and say nothing
    out.mean.interval = out.cov.interval = out.median.interval = out.survival_mean.interval = {};
  return out;
}

Share share_of(const Group& group, int n) {
  const int count = static_cast<int>(group.record.size());
  return {group.name, group.modes, count, wilson(count, n)};
}

// The one of `all` that `is_it`, added at the end where there is none.
template <class Item, class Test>
Item& found_or_added(std::vector<Item>& all, const Test& is_it) {
  const auto found = std::find_if(all.begin(), all.end(), is_it);
  return found != all.end() ? *found : all.emplace_back();
}

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
  std::vector<NameSensitivity> all;
  for (const SampleRecord* record : samples.record)
    for (const NameReading& other : record->failure_mode.sensitivity) {
      NameSensitivity& s = found_or_added(
          all, [&](const NameSensitivity& a) { return a.reading.what() == other.what(); });
      if (s.n++ == 0) s.reading = other, s.reading.name.clear();
      s.differs += other.name != record->failure_mode.name ? 1 : 0;
    }
  for (NameSensitivity& s : all) s.share = wilson(s.differs, s.n);
  return all;
}

std::vector<FlagCount> flag_counts(const Answered& samples) {
  std::vector<FlagCount> all;
  for (const SampleRecord* record : samples.record)
    for (const Evidence& flag : record->failure_mode.flags) {
      FlagCount& f = found_or_added(all, [&](const FlagCount& a) {
        return a.flag.element == flag.element && a.flag.measure == flag.measure;
      });
      if (f.n++ == 0) f.flag = flag, f.flag.value = 0;
      f.raised += flag.holds() ? 1 : 0;
    }
  for (FlagCount& f : all) f.share = wilson(f.raised, f.n);
  return all;
}

}  // namespace wythe::study
