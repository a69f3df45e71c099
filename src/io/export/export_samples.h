// samples.csv of `wythe export`: one row for each sample, with all its results. Columns of
// the campaign's own samples.csv have the same names here. Numbers have all their digits.
#pragma once

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "wythe/parts/campaign.h"

namespace wythe::io {

// Fractions of the peak with columns of their own, besides 0.8.
inline std::vector<double> more_fractions(const StudySpec& study) {
  std::vector<double> fractions =
      study.fractions.empty() ? ResponseOptions{}.fractions : study.fractions;
  std::erase_if(fractions, [](double f) { return std::fabs(f - 0.8) < 1e-9; });
  return fractions;
}

struct ExportColumn {
  std::string name, unit, meaning;
  bool is_text = false;  // else a number
};
[[nodiscard]] nlohmann::ordered_json columns_json(const std::vector<ExportColumn>& columns);

struct ExportCell {
  ExportColumn column;
  std::string text;
};
// The columns are the same for all records of a campaign.
[[nodiscard]] std::vector<ExportCell> sample_cells(const Campaign& campaign,
                                                   const SampleRecord& record);
// The cells of a run, from its summary.json. It has no inputs.
[[nodiscard]] std::vector<ExportCell> run_cells(const nlohmann::json& summary);

}  // namespace wythe::io
