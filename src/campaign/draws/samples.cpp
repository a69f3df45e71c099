// draw_samples: design -> copula -> quantiles -> formulas. Also
// the settings of a sample and of its fields, and its refusal.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>

#include "campaign/draws/copula.h"
#include "campaign/draws/dependents.h"
#include "campaign/draws/formula.h"
#include "campaign/draws/margin.h"
#include "campaign/draws/records.h"
#include "campaign/draws/sampling.h"
#include "campaign/draws/study_check.h"
#include "core/hash.h"
#include "core/number.h"
#include "model/compiler.h"
#include "model/field_places.h"
#include "wythe/parts/model.h"
#include "wythe/parts/units.h"

namespace wythe {

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

namespace {

Columns design_of(const StudySpec& study, int batch) {
  std::vector<std::string> names;
  for (const VariableSpec& variable : study.variable) names.push_back(variable.name);
  Columns u = unit_design(
      {.design = study.design, .samples = study.batch[batch], .seed = study.seed, .batch = batch},
      names);
  const Copula copula = copula_of(study, study.design == Design::kLatinHypercube);
  Columns tied;
  for (const std::size_t variable : copula.variable) tied.push_back(std::move(u[variable]));
  impose_correlation(tied, copula.matrix, study.design);
  for (std::size_t i = 0; i < tied.size(); ++i) u[copula.variable[i]] = std::move(tied[i]);
  return u;
}

// Shortens numbers so that the reason of a refusal fits in a table: "0.28274333882308139 rad" -> "0.282743 rad".
std::string shortened(const std::string& value) {
  const auto number = leading_number(value);
  return number ? fmt::format("{:.6g}{}", number->value, number->rest) : value;
}

// Repeats each drawn wall for each of its records.
void meet_records(const StudySpec& study, SampleTable& table) {
  const std::size_t samples = count_samples(study);
  if (study.variable.empty()) table.value.resize(samples);
  if (!study.shaking.is_asked() || study.variable.empty()) return;
  const std::vector<std::vector<double>> walls = std::move(table.value);
  table.value.clear();
  for (std::size_t i = 0; i < samples; ++i)
    table.value.push_back(walls[case_of(study, static_cast<int>(i)).wall]);
}

}  // namespace

SampleTable draw_samples(const StudySpec& study) {
  if (std::vector<Fault> faults = check_study(study); !faults.empty())
    throw InputError(std::move(faults));
  FaultList none;
  const Dependents dependents(study, none);
  SampleTable table{
      .column = columns_of(study, dependents), .value = {}, .cut_off = {}, .more_setting = {}};
  std::vector<Margin> margin;
  for (const VariableSpec& variable : study.variable) {
    margin.emplace_back(variable);
    table.cut_off.push_back(margin.back().cut_off());
  }
  for (int batch = 0; batch < static_cast<int>(study.batch.size()); ++batch) {
    if (study.variable.empty()) break;  // records alone
    const Columns u = design_of(study, batch);
    for (std::size_t i = 0; i < u.front().size(); ++i) {
      std::vector<double> row;
      for (std::size_t j = 0; j < u.size(); ++j) row.push_back(margin[j].quantile(u[j][i]));
      dependents.append_to(row);
      table.value.push_back(std::move(row));
    }
  }
  meet_records(study, table);
  set_more(study, table);
  return table;
}

std::vector<std::string> settings_of(const SampleTable& samples, int sample) {
  std::vector<std::string> out;
  const std::vector<double>& row = samples.value.at(sample);
  for (std::size_t j = 0; j < samples.column.size(); ++j) {
    const InputColumn& column = samples.column[j];
    if (column.path.empty()) continue;
    // an infinite result is no value, and "inf" would be parsed as "unlimited"
    const std::string number = std::isfinite(row[j]) ? fmt::format("{:.17g}", row[j]) : "nan";
    out.push_back(column.si_unit == "1"
                      ? fmt::format("{}={}", column.path, number)
                      : fmt::format("{}={} {}", column.path, number, column.si_unit));
  }
  if (const auto& more = samples.more_setting; !more.empty()) {
    const auto& own = more.at(sample);
    out.insert(out.end(), own.begin(), own.end());
  }
  return out;
}

namespace {

template <class Compile>
std::vector<Fault> refusal_by(const Compile& compile, const std::vector<std::string>& settings,
                              const ModelBuilder& build) {
  try {
    compile(build(settings));
    return {};
  } catch (const InputError& error) {
    return error.faults();
  }
}

template <class Compile>
std::vector<Fault> refusal_by(const Compile& compile, const SampleTable& samples, int sample,
                              const ModelBuilder& build) {
  const std::vector<double>& row = samples.value.at(sample);
  for (std::size_t j = 0; j < samples.column.size(); ++j)
    if (!std::isfinite(row[j]))
      return {
          {"", samples.column[j].name, fmt::format("{:g}", row[j]), "is not a finite number", ""}};
  return refusal_by(compile, settings_of(samples, sample), build);
}

void compile_alone(const ModelSpec& spec) { (void)compile(spec); }

}  // namespace

std::vector<Fault> refusal_of(const std::vector<std::string>& settings, const ModelBuilder& build) {
  return refusal_by(compile_alone, settings, build);
}

std::vector<Fault> refusal_of(const SampleTable& samples, int sample, const ModelBuilder& build) {
  return refusal_by(compile_alone, samples, sample, build);
}

std::vector<std::vector<Fault>> refusals_of(const SampleTable& samples, const ModelBuilder& build) {
  std::optional<Compiler> first;  // from the first sample that can be built
  const auto compile_beside = [&](const ModelSpec& spec) {
    if (!first) first.emplace(spec);
    (void)first->compile(spec);
  };
  std::vector<std::vector<Fault>> out;
  for (int s = 0; s < samples.n_sample(); ++s)
    out.push_back(refusal_by(compile_beside, samples, s, build));
  return out;
}

std::string in_one_line(const std::vector<Fault>& refusal) {
  if (refusal.empty()) return "";
  const Fault& first = refusal.front();
  const std::string value = first.value.empty() ? "" : " = " + shortened(first.value) + ":";
  const std::string more =
      refusal.size() > 1 ? fmt::format(" (and {} more)", refusal.size() - 1) : "";
  return fmt::format("{}{} {}{}", first.path, value, first.problem, more);
}

// --- fields ---------------------------------------------------------------------------------------

int field_seed_of(const StudySpec& study, int sample) {
  Hash hash;
  hash.add("fields");
  hash.add(&study.seed, sizeof study.seed);
  // i is added last, so that no two samples of a study share a seed
  constexpr std::uint64_t kSeeds = 0x80000000U;
  return static_cast<int>((hash.value() + static_cast<std::uint64_t>(sample)) % kSeeds);
}

namespace {

// Dependents that follow fields joint by joint: as formulas of these fields, for each sample.
class Followers {
 public:
  explicit Followers(const StudySpec& study) : study_(study) {
    std::vector<std::string> names;
    for (const VariableSpec& v : study.variable) names.push_back(v.name);
    for (const DependentSpec& d : study.dependent) names.push_back(d.name);
    for (const DependentSpec& d : study.dependent) formula_.emplace_back(d.formula, names);
  }

  // Settings of one sample, whose inputs are `row` in the order of the columns.
  void append_to(std::vector<std::string>& settings, const SampleTable& samples,
                 const std::vector<double>& row) const {
    for (std::size_t d = 0; d < formula_.size(); ++d) {
      const DependentSpec& dependent = study_.dependent[d];
      const auto target = field_target(dependent.path);
      const bool own =
          std::any_of(study_.field.begin(), study_.field.end(), [&](const StudyField& f) {
            return f.path == dependent.path || f.name == dependent.name;
          });
      if (!target || own || !varies(d, *target)) continue;
      const std::string at = "field." + dependent.name;
      settings.push_back(at + ".path=" + dependent.path);
      settings.push_back(at + ".formula=\"" + text_of(d, *target, samples, row) + '"');
    }
  }

 private:
  // Whether `name` is a variable that gives the mean of a field over the joints of `target`.
  [[nodiscard]] bool is_field(const std::string& name, const FieldTarget& target) const {
    return std::any_of(study_.field.begin(), study_.field.end(), [&](const StudyField& f) {
      const auto its = field_target(f.path);
      return !f.follows && f.name == name && its && its->material == target.material &&
             its->is_density() == target.is_density();
    });
  }
  [[nodiscard]] std::size_t dependent_named(const std::string& name) const {
    const auto found = std::find_if(study_.dependent.begin(), study_.dependent.end(),
                                    [&](const DependentSpec& d) { return d.name == name; });
    return static_cast<std::size_t>(found - study_.dependent.begin());
  }
  [[nodiscard]] bool varies(std::size_t d, const FieldTarget& target) const {
    const std::vector<std::string>& inputs = formula_[d].inputs();
    return std::any_of(inputs.begin(), inputs.end(), [&](const std::string& name) {
      const std::size_t inner = dependent_named(name);
      return inner < formula_.size() ? varies(inner, target) : is_field(name, target);
    });
  }
  [[nodiscard]] std::string text_of(std::size_t d, const FieldTarget& target,
                                    const SampleTable& samples,
                                    const std::vector<double>& row) const {
    std::map<std::string, std::string> by;
    for (const std::string& name : formula_[d].inputs()) {
      const std::size_t inner = dependent_named(name);
      if (inner < formula_.size() && varies(inner, target))
        by[name] = "(" + text_of(inner, target, samples, row) + ")";
      else if (inner < formula_.size() || !is_field(name, target))
        by[name] = amount_of(name, samples, row);
    }
    return formula_[d].replaced(by);
  }
  // "(0.000029 m)"; for a unit like "m2.s-1" a product of powers.
  static std::string amount_of(const std::string& name, const SampleTable& samples,
                               const std::vector<double>& row) {
    const auto column = std::find_if(samples.column.begin(), samples.column.end(),
                                     [&](const InputColumn& c) { return c.name == name; });
    const double value = row[column - samples.column.begin()];
    const std::string& unit = column->si_unit;
    if (unit == "1" || unit.empty()) return fmt::format("({:.17g})", value);
    if (unit.find('.') == std::string::npos && unit.find('-') == std::string::npos)
      return fmt::format("({:.17g} {})", value, unit);
    std::string text = fmt::format("({:.17g}", value);
    for (std::size_t begin = 0; begin < unit.size();) {
      const std::size_t end = std::min(unit.find('.', begin), unit.size());
      const std::string part = unit.substr(begin, end - begin);
      const std::size_t digit = std::min(part.find_first_of("-0123456789"), part.size());
      text += fmt::format(" * (1 {})^({})", part.substr(0, digit),
                          digit < part.size() ? part.substr(digit) : "1");
      begin = end + 1;
    }
    return text + ")";
  }

  const StudySpec& study_;
  std::vector<Formula> formula_;
};

}  // namespace

void set_more(const StudySpec& study, SampleTable& samples) {
  samples.more_setting.clear();
  const ShakingSpec& shaking = study.shaking;
  if (study.field.empty() && !shaking.is_asked()) return;
  const Followers followers(study);
  for (int i = 0; i < samples.n_sample(); ++i) {
    const SampleCase of = case_of(study, i);
    std::vector<std::string>& settings = samples.more_setting.emplace_back();
    for (const StudyField& field : study.field)
      if (!field.follows)
        settings.push_back(
            fmt::format("field.{}.seed={}", field.name, field_seed_of(study, of.wall)));
    followers.append_to(settings, samples, samples.value[i]);
    if (of.record < 0) continue;
    const StudyRecord& record = shaking.record[of.record];
    settings.push_back(fmt::format("stage.{}.record={}", shaking.stage, record.motion));
    settings.push_back(intensity_setting(shaking, first_intensity(shaking, record)));
  }
}

}  // namespace wythe
