// Parses each formula, orders the dependents depth first so that each comes after those it uses, and derives
// units in that order. A dependent with its own unit must agree with it. Any other takes the unit of its formula,
// which must have integer powers. A formula with a fault causes no further faults of units in those that use it.
#include "campaign/draws/dependents.h"

#include <algorithm>

#include <fmt/format.h>

#include "core/text.h"
#include "units/quantity_error.h"

namespace wythe {

Dependents::Dependents(const StudySpec& study, FaultList& faults)
    : study_(&study),
      variables_(study.variable.size()),
      item_(study.dependent.size()),
      si_unit_(study.dependent.size()) {
  parse_formulas(faults);
  std::vector<Mark> mark(item_.size(), Mark::kNew);
  std::vector<std::size_t> way;
  for (std::size_t i = 0; i < item_.size(); ++i) order_from(i, mark, way, faults);
  derive_units(faults);
  study_ = nullptr;
}

void Dependents::refuse(std::size_t item, const std::string& problem, const std::string& cure,
                        FaultList& faults) const {
  const DependentSpec& spec = study_->dependent[item];
  faults.add({.file = study_->file,
              .path = fmt::format("dependent.{}.formula", spec.name),
              .value = spec.formula,
              .problem = problem,
              .cure = cure});
}

void Dependents::parse_formulas(FaultList& faults) {
  std::vector<std::string> names;
  for (const VariableSpec& variable : study_->variable) names.push_back(variable.name);
  for (const DependentSpec& dependent : study_->dependent) names.push_back(dependent.name);
  for (std::size_t i = 0; i < item_.size(); ++i) try {
      item_[i].formula.emplace(study_->dependent[i].formula, names);
      for (const std::string& name : item_[i].formula->inputs())
        item_[i].column.push_back(
            static_cast<std::size_t>(std::find(names.begin(), names.end(), name) - names.begin()));
    } catch (const FormulaError& error) {
      refuse(i, error.what(), error.cure(), faults);
    }
}

// Depth first: an item is placed after all items that it uses. Meeting an item again on the way means a cycle.
void Dependents::order_from(std::size_t item, std::vector<Mark>& mark,
                            std::vector<std::size_t>& way, FaultList& faults) {
  if (mark[item] == Mark::kDone) return;
  if (mark[item] == Mark::kOpen) {
    report_cycle(way, item, faults);
    return;
  }
  mark[item] = Mark::kOpen;
  way.push_back(item);
  for (const std::size_t column : item_[item].column)
    if (column >= variables_) order_from(column - variables_, mark, way, faults);
  way.pop_back();
  mark[item] = Mark::kDone;
  order_.push_back(item);
}

void Dependents::report_cycle(const std::vector<std::size_t>& way, std::size_t item,
                              FaultList& faults) const {
  std::vector<std::string> names;
  for (auto at = std::find(way.begin(), way.end(), item); at != way.end(); ++at)
    names.push_back(study_->dependent[*at].name);
  names.push_back(study_->dependent[item].name);
  refuse(item, fmt::format("depends on itself: {}", joined(names, " -> ")),
         "let one of them follow from variables only", faults);
}

// --- units ---------------------------------------------------------------------------------------

void Dependents::derive_units(FaultList& faults) {
  std::map<std::string, Dimension> known;
  const auto learn = [&](const InputSpec& input) {
    try {
      if (!input.si_unit.empty()) known[input.name] = dimension_of(input.si_unit);
    } catch (const QuantityError&) {  // reported with its unit
    }
  };
  for (const VariableSpec& variable : study_->variable) learn(variable);
  for (const DependentSpec& dependent : study_->dependent) learn(dependent);
  for (const std::size_t item : order_) derive_unit(item, known, faults);
}

void Dependents::derive_unit(std::size_t item, std::map<std::string, Dimension>& known,
                             FaultList& faults) {
  const DependentSpec& spec = study_->dependent[item];
  const std::optional<Formula>& formula = item_[item].formula;
  si_unit_[item] = spec.si_unit;
  if (!formula) return;
  for (const std::string& name : formula->inputs())
    if (!known.contains(name)) return;  // another fault is the cause
  try {
    const Dimension found = formula->dimension(known);
    if (spec.si_unit.empty()) {
      known[spec.name] = found;
      if (found.is_whole())
        si_unit_[item] = found.unit();
      else
        refuse(item, fmt::format("gives {}, a fractional power", found.words()),
               "write it inside the formula that needs it", faults);
    } else if (known.contains(spec.name) && found != known[spec.name]) {
      refuse(item,
             fmt::format("gives {}, but {} is {}", found.words(),
                         spec.path.empty() ? spec.name : spec.path, known[spec.name].words()),
             fmt::format("make it a formula in {}", spec.unit), faults);
    }
  } catch (const FormulaError& error) {
    refuse(item, error.what(), error.cure(), faults);
  }
}

void Dependents::append_to(std::vector<double>& row) const {
  row.resize(variables_ + item_.size());
  for (const std::size_t item : order_) {
    std::vector<double> inputs;
    for (const std::size_t column : item_[item].column) inputs.push_back(row[column]);
    row[variables_ + item] = item_[item].formula->value(inputs);
  }
}

}  // namespace wythe
