// A variable is checked in three steps, each only if the one before found nothing: which parameters are given,
// their values, what truncation leaves. Faults of all parts of a study are reported together. Columns and unused
// variables are looked for only in a study without other faults.
#include "campaign/draws/study_check.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <exception>
#include <map>
#include <numeric>
#include <set>

#include "campaign/draws/dependents.h"
#include "campaign/draws/distribution.h"
#include "campaign/draws/formula_parser.h"
#include "campaign/draws/margin.h"
#include "campaign/draws/result_columns.h"
#include "campaign/draws/sampling.h"
#include "core/text.h"
#include "model/protocol.h"
#include "units/quantity_error.h"
#include "wythe/parts/campaign.h"
#include "wythe/parts/failure_mode.h"
#include "wythe/parts/field_notes.h"
#include "wythe/parts/statistics.h"
#include "wythe/parts/units.h"

namespace wythe {
namespace {

using Names = std::vector<std::string>;
constexpr double kMostPairs = 1e6;  // of walls and records
using study::DistributionForms;
using study::kVariableParameters;
using study::ParameterIs;
using study::VariableParameter;

std::string form_text(Names form) {
  for (std::string& name : form)
    if (name == "spread") name = "cov (or standard_deviation)";
  const std::string last = form.back();
  form.pop_back();
  return form.empty() ? last : joined(form, ", ") + " and " + last;
}

std::string forms_text(const DistributionForms& kind) {
  if (kind.forms.front().empty()) return "file (and column), or values";
  Names texts;
  for (const Names& form : kind.forms) texts.push_back(form_text(form));
  return joined(texts, ", or ");
}

bool holds(const Names& names, const std::string& name) {
  return std::find(names.begin(), names.end(), name) != names.end();
}

class VariableCheck {
 public:
  VariableCheck(const VariableSpec& spec, const std::string& file, FaultList& faults)
      : spec_(spec), file_(file), faults_(faults), kind_(study::forms_of(spec.distribution)) {}

  void run() {
    check_form();
    if (good_) check_values();
    if (good_) check_truncation();
  }

 private:
  void refuse(const std::string& key, const std::string& value, const std::string& problem,
              const std::string& cure) {
    good_ = false;
    const std::string path =
        fmt::format("variable.{}{}{}", spec_.name, key.empty() ? "" : ".", key);
    faults_.add({.file = file_, .path = path, .value = value, .problem = problem, .cure = cure});
  }

  // Checks the parameters given: all of one form, and none too many.
  void check_form() {
    Names given;
    for (const VariableParameter& p : kVariableParameters)
      if (p.is != ParameterIs::kCut && is_set(spec_.*p.value)) given.emplace_back(p.name);
    if (is_set(spec_.cov) && is_set(spec_.standard_deviation))
      refuse("cov", fmt::format("{:g}", spec_.cov), "stands beside standard_deviation",
             "leave one of the two");
    Names form, wrong;
    for (const std::string& name : given) {
      const bool spread = name == "cov" || name == "standard_deviation";
      const std::string role = spread ? "spread" : name;
      if (holds(kind_.optional, name) || holds(form, role)) continue;
      form.push_back(role);
      if (std::none_of(kind_.forms.begin(), kind_.forms.end(),
                       [&](const Names& known) { return holds(known, role); }))
        wrong.push_back(name);
    }
    if (!wrong.empty())
      refuse(wrong.front(), "",
             fmt::format("{} distribution has no {}", kind_.words, joined(wrong, ", ")),
             fmt::format("it takes {}", forms_text(kind_)));
    if (good_ && std::none_of(kind_.forms.begin(), kind_.forms.end(), [&](const Names& known) {
          return std::is_permutation(known.begin(), known.end(), form.begin(), form.end());
        }))
      refuse("", "",
             fmt::format("{} distribution needs {}{}", kind_.words, forms_text(kind_),
                         form.empty() ? "" : "; given: " + joined(given, ", ")),
             kind_.forms.size() > 1 ? "write one set of them, no more" : "add what is missing");
  }

  void check_values() {
    for (const VariableParameter& p : kVariableParameters)
      if (p.is != ParameterIs::kCut && std::isinf(spec_.*p.value))
        refuse(p.name, "inf", "is not a finite number", "");
    for (const VariableParameter& p : kVariableParameters)
      if (p.must_be_positive() && is_set(spec_.*p.value) && spec_.*p.value <= 0)
        refuse(p.name,
               p.is == ParameterIs::kNumber ? fmt::format("{:g}", spec_.*p.value)
                                            : shown_value(spec_, spec_.*p.value),
               "must be more than 0",
               *p.example == '\0' ? "write a positive one"
                                  : fmt::format("write e.g. {} = {}", p.name, p.example));
    check_location();
    check_bounds();
    if (spec_.distribution == DistributionKind::kEmpirical && spec_.values.empty())
      refuse("", "", "an empirical distribution needs file (and column), or values",
             "write e.g. file = \"tests.csv\"");
  }

  void check_location() {
    const bool lognormal = spec_.distribution == DistributionKind::kLognormal;
    if (lognormal && is_set(spec_.mean) && spec_.mean <= 0)
      refuse("mean", shown_value(spec_, spec_.mean), "a lognormal mean must be more than 0",
             "write a value above 0, or distribution = \"normal\"");
    else if (is_set(spec_.cov) && spec_.mean == 0)
      refuse("cov", fmt::format("{:g}", spec_.cov), "has no meaning with a mean of 0",
             "write standard_deviation instead");
    if (is_set(spec_.median) && spec_.median <= 0)
      refuse("median", shown_value(spec_, spec_.median), "must be more than 0",
             "write a value above 0");
    const double location = is_set(spec_.location) ? spec_.location : 0.0;
    if (spec_.distribution == DistributionKind::kWeibull && is_set(spec_.mean) &&
        spec_.mean <= location)
      refuse("mean", shown_value(spec_, spec_.mean),
             fmt::format("must be more than the location {}", shown_value(spec_, location)),
             "write a larger mean, or a smaller location");
  }

  void check_bounds() {
    if (is_set(spec_.low) && is_set(spec_.high) && spec_.low >= spec_.high) {
      refuse("low", shown_value(spec_, spec_.low),
             fmt::format("must be less than high = {}", shown_value(spec_, spec_.high)),
             "exchange them");
      return;
    }
    if (is_set(spec_.mode) && (spec_.mode < spec_.low || spec_.mode > spec_.high))
      refuse("mode", shown_value(spec_, spec_.mode),
             fmt::format("must lie from {} to {}", shown_value(spec_, spec_.low),
                         shown_value(spec_, spec_.high)),
             "");
    if (spec_.distribution == DistributionKind::kBeta && is_set(spec_.mean)) check_beta_moments();
  }

  // The variance of a beta distribution is largest with all its weight at both ends.
  void check_beta_moments() {
    if (spec_.mean <= spec_.low || spec_.mean >= spec_.high) {
      refuse("mean", shown_value(spec_, spec_.mean), "must lie between low and high", "");
      return;
    }
    const double deviation =
        is_set(spec_.cov) ? spec_.cov * std::fabs(spec_.mean) : spec_.standard_deviation;
    const double widest = std::sqrt((spec_.mean - spec_.low) * (spec_.high - spec_.mean));
    if (deviation >= widest)
      refuse(is_set(spec_.cov) ? "cov" : "standard_deviation", "",
             fmt::format("a standard deviation of {} does not fit between low and high",
                         shown_value(spec_, deviation)),
             fmt::format("stay below {}", shown_value(spec_, widest)));
  }

  void check_truncation() {
    if (is_set(spec_.lower) && is_set(spec_.upper) && spec_.lower >= spec_.upper) {
      refuse("lower", shown_value(spec_, spec_.lower),
             fmt::format("must be less than upper = {}", shown_value(spec_, spec_.upper)),
             "exchange them");
      return;
    }
    try {
      constexpr double kNothing = 1e-9;  // below, quantiles of the rest lose their digits
      if (Margin(spec_).kept() < kNothing)
        refuse(is_set(spec_.lower) ? "lower" : "upper",
               shown_value(spec_, is_set(spec_.lower) ? spec_.lower : spec_.upper),
               "the truncation leaves nothing of the distribution", "widen lower and upper");
    } catch (const std::exception& error) {  // for example moments that no Weibull distribution has
      refuse("", "", fmt::format("no such distribution: {}", error.what()), "");
    }
  }

  const VariableSpec& spec_;
  const std::string& file_;
  FaultList& faults_;
  const DistributionForms& kind_;
  bool good_ = true;
};

// --- the study as a whole -------------------------------------------------------------------------

bool is_word(const std::string& name) {
  const auto good = [](char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_';
  };
  return !name.empty() && (name[0] < '0' || name[0] > '9') &&
         std::all_of(name.begin(), name.end(), good);
}

class StudyCheck {
 public:
  explicit StudyCheck(const StudySpec& study) : study_(study) {}

  std::vector<Fault> run() {
    check_sizes();
    check_shaking();
    if (study_.variable.empty() && !study_.shaking.is_asked() && !has_scatter() && !is_one_wall())
      refuse("variable", "",
             "is missing, and nothing scatters within the wall: all samples would be one",
             "write [variable.ft_j] and under it its path, distribution, mean and cov; or "
             "[scatter] in the model");
    for (const VariableSpec& variable : study_.variable) {
      check_input("variable." + variable.name, variable);
      check_variable(variable, study_.file, faults_);
    }
    for (const DependentSpec& dependent : study_.dependent)
      check_input("dependent." + dependent.name, dependent);
    check_until();
    check_fields();
    check_fragility();
    const Dependents checked(study_, faults_);
    check_correlation(study_, faults_);
    if (faults_.empty()) check_columns(checked);
    if (faults_.empty()) check_use();
    return faults_.all();
  }

 private:
  void refuse(const std::string& path, const std::string& value, const std::string& problem,
              const std::string& cure) {
    faults_.add(
        {.file = study_.file, .path = path, .value = value, .problem = problem, .cure = cure});
  }

  [[nodiscard]] bool has_scatter() const {
    return std::any_of(study_.field.begin(), study_.field.end(),
                       [](const StudyField& field) { return !field.follows; });
  }

  // A field and a variable of one name belong together: scatter within a wall and scatter between walls.
  void check_fields() {
    for (const StudyField& field : study_.field)
      for (const VariableSpec& variable : study_.variable)
        if (variable.name == field.name && variable.path != field.path)
          refuse("field." + field.name + ".path", field.path,
                 fmt::format("is not what variable.{} sets, {}", variable.name,
                             variable.path.empty() ? "no key" : variable.path),
                 "leave path out, or give the field another name");
  }

  // Whether all samples would be the same wall, so that one sample is enough.
  [[nodiscard]] bool is_one_wall() const {
    return study_.batch == std::vector<int>{1} && study_.variable.empty();
  }

  void check_sizes() {
    if (study_.batch.empty()) refuse("study.samples", "", "is missing", "write e.g. samples = 250");
    const bool records_alone = study_.shaking.is_asked() && study_.variable.empty();
    if (records_alone && study_.batch != std::vector<int>{1})
      refuse("study.samples", "", "must be 1, since no variable tells one wall from another",
             "write samples = 1, or give [variable.<name>]");
    for (const int size : study_.batch)
      if (size < 2 && !records_alone && !(is_one_wall() && !has_scatter()))
        refuse("study.samples", std::to_string(size),
               "must be at least 2: one sample has no scatter", "write e.g. samples = 250");
    for (const double fraction : study_.fractions)
      if (!(fraction > 0 && fraction < 1))
        refuse("study.fractions", fmt::format("{:g}", fraction),
               "must be more than 0 and less than 1, a share of the peak",
               "write e.g. fractions = [0.8, 0.5]");
    std::set<std::string> shares;  // titles as in samples.csv
    for (const double fraction : study_.fractions)
      if (!shares.insert(fmt::format("{:g}", 100 * fraction)).second)
        refuse("study.fractions", fmt::format("{:g}", fraction), "stands there twice",
               "leave one of them out");
    for (const double state : study_.states)
      if (!(state > 0))
        refuse("study.states", format_quantity(state, "m", "mm"), "must be more than 0 mm",
               "write e.g. states = [\"10 mm\", \"40 mm\"]");
    if (study_.read_modes_at <= 0)
      refuse("study.read_modes_at", format_quantity(study_.read_modes_at, "m", "mm"),
             "must be more than 0 mm", "write e.g. read_modes_at = \"40 mm\"");
    const auto variables = static_cast<int>(study_.variable.size());
    if (study_.design == Design::kSobol && variables > most_sobol_variables())
      refuse("study.design", "sobol",
             fmt::format("has at most {} variables, the study has {}", most_sobol_variables(),
                         variables),
             "write design = \"latin_hypercube\"");
  }

  // Refuses settings of pushes in a study of shakes.
  void check_shaking() {
    const ShakingSpec& shaking = study_.shaking;
    if (!shaking.is_asked()) return;
    const auto idle = [&](const char* key, bool stands) {
      if (stands)
        refuse(std::string("study.") + key, "", "is of pushes, and [shaking] asks for shakes alone",
               "leave it out");
    };
    idle("until", !study_.until.empty());
    idle("fragility", !study_.fragility.empty());
    idle("states", !study_.states.empty());
    idle("fractions", !study_.fractions.empty());
    idle("read_modes_at", !std::isnan(study_.read_modes_at));
    check_intensities();
    const double walls = std::accumulate(study_.batch.begin(), study_.batch.end(), 0.0);
    if (walls * static_cast<double>(shaking.record.size()) > kMostPairs)
      refuse("study.samples", fmt::format("{:g}", walls),
             fmt::format("with {} records is too many, at most {:g} pairs", shaking.record.size(),
                         kMostPairs),
             "write fewer samples, or pairing = \"in_turn\"");
    if (shaking.pairing == Pairing::kInTurn && walls < static_cast<double>(shaking.record.size()))
      refuse(
          "shaking.pairing", "in_turn",
          fmt::format("leaves records out: {} samples, {} records", walls, shaking.record.size()),
          "write as many samples as records at least, or pairing = \"each\"");
  }

  // Checks records and intensities, which a damaged store may lack.
  void check_intensities() {
    const ShakingSpec& shaking = study_.shaking;
    if (shaking.record.empty())
      refuse("record", "", "is missing", "write [[record]] and under it name, file and unit");
    const auto rise = [](const std::vector<double>& levels) {
      return std::adjacent_find(levels.begin(), levels.end(),
                                [](double a, double b) { return !(a < b); }) == levels.end() &&
             std::all_of(levels.begin(), levels.end(),
                         [](double x) { return x > 0 && std::isfinite(x); });
    };
    bool good = rise(shaking.levels);
    for (const StudyRecord& record : shaking.record)
      good = good && rise(record.levels) &&
             (!record.levels.empty() || !shaking.levels.empty() || shaking.climbs());
    if (!good)
      refuse("shaking.levels", "", "are not intensities that rise, for every record",
             "write e.g. levels = [\"1 m/s^2\", \"2 m/s^2\"]");
    if (shaking.climbs() && !(shaking.first > 0 && shaking.step > 0 &&
                              shaking.most >= shaking.first && std::isfinite(shaking.most)))
      refuse("shaking.most", "", "is no intensity above from, with a step above 0",
             "write from, step and most");
    if (shaking.halvings < 0 || shaking.halvings > 20)
      refuse("shaking.halvings", std::to_string(shaking.halvings), "must be from 0 to 20", "");
  }

  // A variable without a key of the model must occur in a formula.
  void check_use() {
    std::set<std::string> used;
    std::vector<std::string> known;
    for (const VariableSpec& variable : study_.variable) known.push_back(variable.name);
    for (const DependentSpec& dependent : study_.dependent) known.push_back(dependent.name);
    for (const DependentSpec& dependent : study_.dependent) {
      const Formula formula(dependent.formula, known);
      used.insert(formula.inputs().begin(), formula.inputs().end());
    }
    for (const VariableSpec& variable : study_.variable)
      if (variable.path.empty() && !used.contains(variable.name))
        refuse("variable." + variable.name, "",
               "nothing uses it: it has no path, and no formula names it",
               "write path = \"...\", use it in a formula, or leave it out");
  }

  void check_until() {
    try {
      if (!study_.until.empty()) check_rule(study_.until);
    } catch (const InputError& error) {
      for (const Fault& fault : error.faults())
        refuse("study.until", study_.until, fault.problem, fault.cure);
    }
  }
  void check_fragility() {
    for (const std::string& event : study_.fragility) {
      try {
        static_cast<void>(fragility_event(event));
      } catch (const InputError& error) {
        for (const Fault& fault : error.faults())
          refuse("study.fragility", event, fault.problem, fault.cure);
      }
    }
  }

  void check_input(const std::string& place, const InputSpec& input) {
    if (!is_word(input.name))
      refuse(place, "", "a name is made of letters, digits and _, and begins with a letter",
             "rename it, e.g. ft_j");
    else if (is_function_name(input.name))
      refuse(place, "", fmt::format("{} is a function of formulas", input.name), "rename it");
    else if (!names_.insert(input.name).second)
      refuse(place, "", "there is a variable of this name", "give it a name of its own");
    if (input.path.empty()) return;
    const auto [known, is_new] = setter_.emplace(input.path, place);
    if (!is_new)
      refuse(place + ".path", input.path, fmt::format("is set by {} too", known->second),
             "leave one of the two");
  }

  // Each input becomes a column of the results, with its name and unit.
  void check_columns(const Dependents& dependents) {
    std::map<std::string, std::string> taken;  // title in small letters -> its origin
    for (const InputColumn& column : columns_of(study_, dependents)) {
      const std::string place = (column.is_random ? "variable." : "dependent.") + column.name;
      const std::string title = column_title(column);
      const std::string cure = "rename it, e.g. " + column.name + "_input";
      const auto [known, is_new] = taken.emplace(study::without_case(title), place);
      if (study::is_result_column(title))
        refuse(place, "", fmt::format("results have a column {} of their own", title), cure);
      else if (!is_new)
        refuse(place, "",
               fmt::format("its column of the results, {}, has the name of that of {}, but for the "
                           "case of letters",
                           title, known->second),
               cure);
    }
  }

  const StudySpec& study_;
  FaultList faults_;
  std::set<std::string> names_;
  std::map<std::string, std::string> setter_;  // path -> what sets it
};

}  // namespace

std::string shown_value(const InputSpec& input, double value) {
  if (input.si_unit.empty() || input.si_unit == "1") return fmt::format("{:g}", value);
  try {
    const std::string& unit = input.unit.empty() ? input.si_unit : input.unit;
    return fmt::format("{:.6g} {}", value / unit_factor(unit, input.si_unit), unit);
  } catch (const QuantityError&) {
    return fmt::format("{:.6g} {}", value, input.si_unit);
  }
}

void check_variable(const VariableSpec& spec, const std::string& file, FaultList& faults) {
  VariableCheck(spec, file, faults).run();
}

std::vector<Fault> check_study(const StudySpec& study) { return StudyCheck(study).run(); }

std::vector<Message> notes_of(const StudySpec& study, const ModelSpec& base) {
  double end = 0;  // of the farthest push [m]
  for (const StageSpec& stage : base.stage) {
    const auto* push = std::get_if<PushStage>(&stage.action);
    if (push == nullptr) continue;
    if (!std::isnan(push->until)) end = std::max(end, push->until);
    if (!push->drifts.empty())
      return notes_of_fields(base);  // their height is known only when the wall is built
    for (const double target : targets_of(*push, 0)) end = std::max(end, std::fabs(target));
  }
  std::vector<Message> notes = notes_of_fields(base);
  if (!(end > 0)) return notes;
  const double read_at = std::isnan(study.read_modes_at) ? kReadModesAt : study.read_modes_at;
  const auto note = [&](const char* code, double at) {
    if (at > end * (1 + 1e-9))
      notes.push_back({code, {{"at_mm", 1e3 * at}, {"end_mm", 1e3 * end}}});
  };
  for (const double state : study.states) note("study.state_beyond_push", state);
  note("study.modes_beyond_push", read_at);
  return notes;
}

}  // namespace wythe
