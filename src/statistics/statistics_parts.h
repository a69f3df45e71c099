// The parts of statistics_of(), one for each question; statistics.cpp calls them in order.
//
// All use only the answered samples, in the order of their numbers.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "wythe/parts/statistics.h"

namespace wythe::study {

struct Answered {
  const Campaign& campaign;
  std::vector<const SampleRecord*> record;
  std::vector<std::string> modes;  // as Statistics::modes
  [[nodiscard]] int n() const { return static_cast<int>(record.size()); }
};
[[nodiscard]] Answered answered_of(const Campaign& campaign);
// Samples for a model that is fitted many times: all, or this number of them, one at random from each of equal parts.
inline constexpr int kMostFitted = 10000;
[[nodiscard]] Answered for_fits(const Answered& samples);

// Samples taken together: all, one mode, some modes.
struct Group {
  std::string name;
  std::vector<std::string> modes;
  std::vector<const SampleRecord*> record;
};
[[nodiscard]] Group all_of(const Answered& samples);
[[nodiscard]] std::vector<Group> modes_of(const Answered& samples);
// FM-1 + FM-2 (piers) and FM-3 + FM-4 (spandrel), where any such mode occurs.
[[nodiscard]] std::vector<Group> unions_of(const Answered& samples);

// The samples of a group that have a value. A peak without a force in balance has none.
[[nodiscard]] Group with_value(const Group& group, const Quantity& quantity);
[[nodiscard]] std::vector<Reading> readings_of(const Group& group, const Quantity& quantity);
// Whether a group has only lower bounds, or no value at all. Then no influence can be shown.
[[nodiscard]] bool all_censored(const Group& group, const Quantity& quantity);
// The number of lower bounds among the values; a peak at the end of a push is one. Also
// whether more than one in twenty is a bound, too many for methods that use recorded values.
[[nodiscard]] int bounds_in(const Group& known, const Quantity& quantity);
[[nodiscard]] bool is_censored(int bounds, std::size_t n);
[[nodiscard]] std::vector<double> values_of(const std::vector<Reading>& readings);
// The random inputs, and one of them in some samples [SI].
[[nodiscard]] std::vector<int> random_columns(const SampleTable& samples);
[[nodiscard]] std::vector<double> input_of(const std::vector<const SampleRecord*>& records,
                                           int column);
// Inputs whose rank correlation with it exceeds kEntangled.
[[nodiscard]] std::vector<std::string> entangled_with(const std::string& input,
                                                      const std::vector<InputCorrelation>& pairs);
// A variable may move the load, so the sample's own height has priority over the base model's [m].
[[nodiscard]] double height_of(const SampleRecord& record, double base_height);

// groups.cpp: Table 3, shares, certainty of names
[[nodiscard]] GroupSummary summarise(const Group& group);
[[nodiscard]] std::vector<Share> shares_of(const Answered& samples);
[[nodiscard]] std::vector<NameSensitivity> name_sensitivities(const Answered& samples);
[[nodiscard]] std::vector<FlagCount> flag_counts(const Answered& samples);
// running.cpp: convergence of the results
[[nodiscard]] std::vector<RunningMean> running_means(const Answered& samples);
[[nodiscard]] std::vector<Precision> precisions(const Answered& samples,
                                                const std::vector<RunningMean>& running);
// influence.cpp: inputs against results
[[nodiscard]] std::vector<InputSummary> input_summaries(const Campaign& campaign);
[[nodiscard]] CorrelationTable correlation_table(const Answered& samples, const Group& group,
                                                 const Quantity& quantity);
[[nodiscard]] std::vector<FirstOrderIndex> first_order_indices(const Answered& samples);
[[nodiscard]] std::vector<ModeAgainstInput> modes_against_inputs(const Answered& samples);
// capacity.cpp: force and drift
[[nodiscard]] MeanCurve mean_curve_of(const Group& group, double base_height);
[[nodiscard]] std::vector<DriftLimit> drift_limits(const Answered& samples);
[[nodiscard]] std::vector<Exceedance> exceedances(const Answered& samples);
// fragility.cpp: probability of an event given an input
[[nodiscard]] std::vector<Fragility> fragilities(const Answered& samples);
// measuring.cpp: the value of knowing an input; indices by a surrogate
[[nodiscard]] std::vector<Measuring> measurings(const Answered& samples);
// Share of the response's variance that the input explains; its replicates, NaN where there is none.
[[nodiscard]] Estimate variance_taken(const std::vector<double>& input,
                                      const std::vector<double>& response,
                                      std::vector<double>& replicate);
[[nodiscard]] std::vector<SurrogateIndices> surrogate_indices(const Answered& samples);
// For one response, with inputs by column; names are not set.
[[nodiscard]] SurrogateIndices indices_of(const std::vector<std::vector<double>>& inputs,
                                          const std::vector<double>& response);

}  // namespace wythe::study
