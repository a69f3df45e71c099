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
  visit("peak_reaction_" + side + "_kN", 1e-3 * d.peak_reaction);
  visit("displacement_at_80_percent_" + side + "_mm", 1e3 * d.displacement_at_80);
  visit("censored_80_" + side, d.censored_80);
  visit("first_fall_80_percent_" + side + "_mm", 1e3 * d.first_fall_80);
  visit("censored_first_80_" + side, d.censored_first_80);
  visit("last_fall_80_percent_" + side + "_mm", 1e3 * d.last_fall_80);
  visit("censored_last_80_" + side, d.censored_last_80);
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
