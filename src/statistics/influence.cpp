// How inputs influence the results: correlation, first-order indices, modes in bins of an input.
#include <algorithm>
#include <cmath>

#include "statistics/correlation.h"
#include "statistics/intervals.h"
#include "statistics/statistics_parts.h"

namespace wythe::study {
namespace {

constexpr int kMostBins = 5, kFewestInBin = 10;

ModeBin bin_of(const Answered& samples, const Column& input, const std::vector<int>& bin,
               int which) {
  ModeBin out;
  Moments moments;
  std::vector<int> count(samples.modes.size(), 0);
  for (int i = 0; i < samples.n(); ++i) {
    if (bin[i] != which) continue;
    out.low = moments.n() == 0 ? input[i] : std::min(out.low, input[i]);
    out.high = moments.n() == 0 ? input[i] : std::max(out.high, input[i]);
    moments.add(input[i]);
    for (std::size_t m = 0; m < samples.modes.size(); ++m)
      count[m] += samples.record[i]->failure_mode.name == samples.modes[m] ? 1 : 0;
  }
  out.n = moments.n(), out.mean = moments.mean();
  for (int of_mode : count) out.share.push_back(share_estimate(of_mode, out.n));
  return out;
}

}  // namespace

std::vector<int> random_columns(const SampleTable& samples) {
  std::vector<int> columns;
  for (std::size_t k = 0; k < samples.column.size(); ++k)
    if (samples.column[k].is_random) columns.push_back(static_cast<int>(k));
  return columns;
}

std::vector<std::string> entangled_with(const std::string& input,
                                        const std::vector<InputCorrelation>& pairs) {
  std::vector<std::string> others;
  for (const InputCorrelation& p : pairs)
    if (std::fabs(p.rank) > kEntangled && (p.a == input || p.b == input))
      others.push_back(p.a == input ? p.b : p.a);
  return others;
}

Column input_of(const std::vector<const SampleRecord*>& records, int column) {
  Column values;
  for (const SampleRecord* record : records) values.push_back(record->inputs.at(column));
  return values;
}

Column values_of(const std::vector<Reading>& readings) {
  Column values;
  for (const Reading& r : readings) values.push_back(r.value);
  return values;
}

std::vector<InputSummary> input_summaries(const Campaign& campaign) {
  std::vector<InputSummary> out;
  for (std::size_t k = 0; k < campaign.samples.column.size(); ++k) {
    const InputColumn& column = campaign.samples.column[k];
    InputSummary summary{.name = column.name, .unit = column.unit, .is_random = column.is_random};
    Moments moments;
    for (const std::vector<double>& row : campaign.samples.value) {
      const double shown = row.at(k) * column.to_unit + column.offset;
      summary.min = moments.n() == 0 ? shown : std::min(summary.min, shown);
      summary.max = moments.n() == 0 ? shown : std::max(summary.max, shown);
      moments.add(shown);
    }
    summary.mean = moments.mean();
    summary.cov = moments.standard_deviation() / moments.mean();
    out.push_back(summary);
  }
  return out;
}

CorrelationTable correlation_table(const Answered& samples, const Group& group,
                                   const Quantity& quantity) {
  CorrelationTable out{group.name, key_of(quantity), 0, {}};
  const std::vector<Reading> readings = readings_of(group, quantity);
  for (const Reading& r : readings) out.censored += r.censored ? 1 : 0;
  const std::vector<int> random = random_columns(samples.campaign.samples);
  const Group known = with_value(group, quantity);
  std::vector<Column> inputs;
  for (int k : random) inputs.push_back(input_of(known.record, k));
  out.input = correlate(inputs, readings);
  if (is_censored(bounds_in(known, quantity), readings.size()))
    for (Correlation& c : out.input) c.pearson = {};  // it would count bounds as values
  for (std::size_t i = 0; i < random.size(); ++i)
    out.input[i].input = samples.campaign.samples.column[random[i]].name;
  return out;
}

std::vector<FirstOrderIndex> first_order_indices(const Answered& samples) {
  std::vector<FirstOrderIndex> out;
  const Group all = all_of(samples);
  const std::vector<InputCorrelation> pairs = input_correlations(samples.campaign.samples);
  for (const Quantity& quantity : quantities()) {
    if (all_censored(all, quantity)) continue;
    const Column response = values_of(readings_of(all, quantity));
    const Group known = with_value(all, quantity);
    const bool censored = is_censored(bounds_in(known, quantity), response.size());
    for (int k : random_columns(samples.campaign.samples)) {
      FirstOrderIndex index;
      if (!censored) index = first_order_index(input_of(known.record, k), response);
      index.input = samples.campaign.samples.column[k].name;
      index.quantity = key_of(quantity);
      index.entangled = entangled_with(index.input, pairs);
      out.push_back(index);
    }
  }
  return out;
}

std::vector<ModeAgainstInput> modes_against_inputs(const Answered& samples) {
  std::vector<ModeAgainstInput> out;
  const int bins = std::min(kMostBins, samples.n() / kFewestInBin);
  if (bins < 2) return out;
  for (int k : random_columns(samples.campaign.samples)) {
    const Column input = input_of(samples.record, k);
    const std::vector<int> bin = equal_bins(input, bins);
    ModeAgainstInput of_input{samples.campaign.samples.column[k], samples.modes, {}};
    for (int b = 0; b < bins; ++b) of_input.bin.push_back(bin_of(samples, input, bin, b));
    out.push_back(std::move(of_input));
  }
  return out;
}

}  // namespace wythe::study

namespace wythe {

std::vector<InputCorrelation> input_correlations(const SampleTable& samples) {
  std::vector<InputCorrelation> pairs;
  std::vector<study::Column> drawn;
  const std::vector<int> random = study::random_columns(samples);
  for (const int k : random) {
    study::Column& column = drawn.emplace_back();
    for (const std::vector<double>& row : samples.value) column.push_back(row.at(k));
    column = study::ranks(column);
  }
  for (std::size_t i = 0; i < drawn.size(); ++i)
    for (std::size_t j = i + 1; j < drawn.size(); ++j)
      pairs.push_back({samples.column[random[i]].name, samples.column[random[j]].name,
                       study::pearson(drawn[i], drawn[j])});
  std::erase_if(pairs, [](const InputCorrelation& p) { return std::isnan(p.rank); });
  std::stable_sort(pairs.begin(), pairs.end(),
                   [](const InputCorrelation& a, const InputCorrelation& b) {
                     return std::fabs(a.rank) > std::fabs(b.rank);
                   });
  return pairs;
}

}  // namespace wythe
