// notes_of_values of a study: the notes of its model with each input at its median, and notes on unusual scatter.
#include <algorithm>
#include <cmath>
#include <map>
#include <string>
#include <utility>
#include <variant>

#include "model/densities.h"
#include "wythe/parts/error.h"
#include "wythe/parts/study_notes.h"

namespace wythe {
namespace {

double median_of(const SampleTable& samples, std::size_t column) {
  std::vector<double> values;
  for (const std::vector<double>& row : samples.value)
    if (std::isfinite(row[column])) values.push_back(row[column]);
  if (values.empty()) return kUnset;
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

// The notes of the base model with each input at its median. If there are none, each input is also set alone.
std::vector<Message> notes_of_medians(const SampleTable& samples, const ModelBuilder& build) {
  SampleTable medians;
  medians.column = samples.column;
  medians.value.emplace_back();
  for (std::size_t k = 0; k < samples.column.size(); ++k)
    medians.value.front().push_back(median_of(samples, k));
  const std::vector<std::string> settings = settings_of(medians, 0);
  const auto notes_with = [&](const std::vector<std::string>& some) -> std::vector<Message> {
    try {
      return notes_of_values(build(some));
    } catch (const InputError&) {
      return {};  // the refusal is reported elsewhere
    }
  };
  std::vector<Message> notes = notes_with(settings);
  if (!notes.empty()) return notes;
  const auto is_of = [](const Message& note, const std::string& setting) {
    const auto* key = std::get_if<std::string>(&note.arguments.front().value);
    return key != nullptr && setting.starts_with(*key + '=');
  };
  for (const std::string& one : settings)
    for (Message& note : notes_with({one}))
      if (is_of(note, one)) notes.push_back(std::move(note));
  for (Message& note : notes_with({}))  // values that no input sets
    if (std::none_of(settings.begin(), settings.end(),
                     [&](const std::string& one) { return is_of(note, one); }))
      notes.push_back(std::move(note));
  return notes;
}

// Notes a standard deviation that is unusually large or small.
void note_scatter(const VariableSpec& variable, std::vector<Message>& notes) {
  const std::string table = "variable." + variable.name + ".";
  if (is_scatter_odd(variable.cov)) notes.push_back(note_of_scatter(table + "cov", variable.cov));
  if (is_scatter_odd(variable.log_standard_deviation))
    notes.push_back(
        note_of_scatter(table + "log_standard_deviation", variable.log_standard_deviation));
  // a variable used only in formulas may have mean zero
  const double share = variable.standard_deviation / std::fabs(variable.mean);
  constexpr double kLeast = 1e-3;
  if (!variable.path.empty() && (is_scatter_odd(share) || share < kLeast))
    notes.push_back(
        {"scatter.unlike", {{"key", table + "standard_deviation"}, {"cov_percent", 100 * share}}});
}

}  // namespace

std::vector<Message> notes_of_values(const StudySpec& study, const SampleTable& samples,
                                     const ModelBuilder& build) {
  std::map<std::string, std::string> input_of;  // key of the model -> what sets it
  for (const VariableSpec& variable : study.variable)
    input_of[variable.path] = "variable." + variable.name;
  for (const DependentSpec& dependent : study.dependent)
    input_of[dependent.path] = "dependent." + dependent.name;
  std::vector<Message> notes = notes_of_medians(samples, build);
  for (Message& note : notes)
    for (Argument& argument : note.arguments) {
      auto* key = std::get_if<std::string>(&argument.value);
      if (argument.name != "key" || key == nullptr) continue;
      if (const auto found = input_of.find(*key); found != input_of.end())
        *key += " by " + found->second;
    }
  for (const VariableSpec& variable : study.variable) note_scatter(variable, notes);
  return notes;
}

}  // namespace wythe
