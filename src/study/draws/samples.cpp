// draw_samples: design -> copula -> quantiles -> formulas; settings of a sample, and its refusal.
#include <fmt/format.h>

#include <charconv>
#include <cmath>

#include "study/draws/copula.h"
#include "study/draws/dependents.h"
#include "study/draws/sampling.h"
#include "study/draws/study_check.h"
#include "wythe/model.h"
#include "wythe/units.h"

namespace wythe {
namespace {

std::vector<InputColumn> columns_of(const StudySpec& study, const Dependents& dependents) {
  std::vector<InputColumn> out;
  for (const VariableSpec& v : study.variable)
    out.push_back({.name = v.name, .path = v.path, .si_unit = v.si_unit, .unit = v.unit});
  for (std::size_t i = 0; i < study.dependent.size(); ++i) {
    const DependentSpec& d = study.dependent[i];
    const std::string& si_unit = dependents.si_units()[i];
    out.push_back({.name = d.name,
                   .path = d.path,
                   .si_unit = si_unit,
                   .unit = d.unit.empty() ? si_unit : d.unit,
                   .is_random = false});
  }
  for (InputColumn& column : out)
    if (column.si_unit != "1") column.to_unit = 1 / unit_factor(column.unit, column.si_unit);
  return out;
}

Columns design_of(const StudySpec& study, int batch) {
  std::vector<std::string> names;
  for (const VariableSpec& variable : study.variable) names.push_back(variable.name);
  Columns u = unit_design({.design = study.design,
                           .samples = study.batch[static_cast<std::size_t>(batch)],
                           .seed = study.seed,
                           .batch = batch},
                          names);
  const Copula copula = copula_of(study, study.design == Design::kLatinHypercube);
  Columns tied;
  for (const std::size_t variable : copula.variable) tied.push_back(std::move(u[variable]));
  impose_correlation(tied, copula.matrix, study.design);
  for (std::size_t i = 0; i < tied.size(); ++i) u[copula.variable[i]] = std::move(tied[i]);
  return u;
}

// The reason of a refusal has to fit in a table: "0.28274333882308139 rad" -> "0.282743 rad".
std::string shortened(const std::string& value) {
  double number = 0;
  const char* end = value.data() + value.size();
  const auto [stop, error] = std::from_chars(value.data(), end, number);
  if (error != std::errc()) return value;
  return fmt::format("{:.6g}{}", number,
                     std::string_view(stop, static_cast<std::size_t>(end - stop)));
}

}  // namespace

SampleTable draw_samples(const StudySpec& study) {
  if (std::vector<Fault> faults = check_study(study); !faults.empty())
    throw InputError(std::move(faults));
  FaultList none;
  const Dependents dependents(study, none);
  SampleTable table{
      .column = columns_of(study, dependents), .value = {}, .cut_off = {}, .field_setting = {}};
  std::vector<Margin> margin;
  for (const VariableSpec& variable : study.variable) {
    margin.emplace_back(variable);
    table.cut_off.push_back(margin.back().cut_off());
  }
  for (int batch = 0; batch < static_cast<int>(study.batch.size()); ++batch) {
    const Columns u = design_of(study, batch);
    for (std::size_t i = 0; i < u.front().size(); ++i) {
      std::vector<double> row;
      for (std::size_t j = 0; j < u.size(); ++j) row.push_back(margin[j].quantile(u[j][i]));
      dependents.append_to(row);
      table.value.push_back(std::move(row));
    }
  }
  set_fields(study, table);
  return table;
}

std::vector<std::string> settings_of(const SampleTable& samples, int sample) {
  std::vector<std::string> out;
  const std::vector<double>& row = samples.value.at(static_cast<std::size_t>(sample));
  for (std::size_t j = 0; j < samples.column.size(); ++j) {
    const InputColumn& column = samples.column[j];
    if (column.path.empty()) continue;
    // inf would read as "unlimited": what a formula can't give is no value
    const std::string number = std::isfinite(row[j]) ? fmt::format("{:.17g}", row[j]) : "nan";
    out.push_back(column.si_unit == "1"
                      ? fmt::format("{}={}", column.path, number)
                      : fmt::format("{}={} {}", column.path, number, column.si_unit));
  }
  if (const auto& fields = samples.field_setting; !fields.empty()) {
    const auto& own = fields.at(static_cast<std::size_t>(sample));
    out.insert(out.end(), own.begin(), own.end());
  }
  return out;
}

std::vector<Fault> refusal_of(const std::vector<std::string>& settings, const ModelBuilder& build) {
  try {
    (void)compile(build(settings));
    return {};
  } catch (const InputError& error) {
    return error.faults();
  }
}

std::vector<Fault> refusal_of(const SampleTable& samples, int sample, const ModelBuilder& build) {
  const std::vector<double>& row = samples.value.at(static_cast<std::size_t>(sample));
  for (std::size_t j = 0; j < samples.column.size(); ++j)
    if (!std::isfinite(row[j]))
      return {
          {"", samples.column[j].name, fmt::format("{:g}", row[j]), "is not a finite number", ""}};
  return refusal_of(settings_of(samples, sample), build);
}

std::string in_one_line(const std::vector<Fault>& refusal) {
  if (refusal.empty()) return "";
  const Fault& first = refusal.front();
  const std::string value = first.value.empty() ? "" : " = " + shortened(first.value) + ":";
  const std::string more =
      refusal.size() > 1 ? fmt::format(" (and {} more)", refusal.size() - 1) : "";
  return fmt::format("{}{} {}{}", first.path, value, first.problem, more);
}

}  // namespace wythe
