// The dependent quantities of a study: which follow from which, in what unit, and their values.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "campaign/draws/formula.h"
#include "wythe/parts/error.h"
#include "wythe/parts/study.h"

namespace wythe {

class Dependents {
 public:
  // Parses every formula, orders them so that each comes after those it uses,
  // and derives their units. Faults (a formula that cannot be parsed, a cycle,
  // units that clash) go to `faults`; with any fault nothing may be evaluated.
  Dependents(const StudySpec& study, FaultList& faults);

  // SI unit of each dependent, by its number in the study; "" where it has none because of a fault.
  [[nodiscard]] const std::vector<std::string>& si_units() const { return si_unit_; }
  // `row` holds the variables' values; the dependents' are appended in the study's order [SI].
  void append_to(std::vector<double>& row) const;

 private:
  struct Item {
    std::optional<Formula> formula;
    std::vector<std::size_t> column;  // of each of its inputs: variables first, then dependents
  };
  enum class Mark { kNew, kOpen, kDone };

  void parse_formulas(FaultList& faults);
  void order_from(std::size_t item, std::vector<Mark>& mark, std::vector<std::size_t>& way,
                  FaultList& faults);
  void report_cycle(const std::vector<std::size_t>& way, std::size_t item, FaultList& faults) const;
  void derive_units(FaultList& faults);
  void derive_unit(std::size_t item, std::map<std::string, Dimension>& known, FaultList& faults);
  void refuse(std::size_t item, const std::string& problem, const std::string& cure,
              FaultList& faults) const;

  const StudySpec* study_;  // only read while the constructor runs
  std::size_t variables_ = 0;
  std::vector<Item> item_;
  std::vector<std::size_t> order_;
  std::vector<std::string> si_unit_;
};

// The inputs as columns with derived units: variables in their order, then dependents.
[[nodiscard]] std::vector<InputColumn> columns_of(const StudySpec& study,
                                                  const Dependents& dependents);

}  // namespace wythe
