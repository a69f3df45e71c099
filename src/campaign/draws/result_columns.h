// Names of result columns, which an input may not have. If it did, samples.csv, exported
// tables and the view `samples` of the store would have two columns of one name.
#pragma once

#include <fmt/format.h>

#include <string>

#include "wythe/parts/result.h"

namespace wythe::study {

// The columns of samples.csv for one direction of a cyclic push, "positive" or "negative": visit(title, value) with
// the number in the title's unit, or a bool.
template <class Visitor>
void each_direction_column(Visitor&& visit, const std::string& side, const DirectionReadings& d) {
  const auto column = [&](OutputKey::Listed listed, const char* name, const char* unit,
                          auto value) {
    if (listed == OutputKey::kCsv) visit(fmt::format("{}_{}{}", name, side, unit), value);
  };
  each_direction_reading(column, d);
  for (std::size_t k = 0; k < std::size(kSharesLeft); ++k) {
    if (kSharesLeft[k] == 0.8) continue;
    const FallTo fall = k < d.drift_capacity.size() ? d.drift_capacity[k] : FallTo{};
    const std::string share = fmt::format("{:g}", 100 * kSharesLeft[k]);
    visit("displacement_at_" + share + "_percent_" + side + "_mm", 1e3 * fall.displacement);
    visit("censored_" + share + "_" + side, fall.censored);
  }
  visit("dips_" + side, static_cast<double>(d.dips.size()));
}

// Small letters, because SQLite and some programs for tables ignore case.
[[nodiscard]] std::string without_case(std::string title);

// Whether results have a column of this title, in any case.
[[nodiscard]] bool is_result_column(const std::string& title);

}  // namespace wythe::study
