// samples.csv of `wythe export`: one row a sample, with all that is said of it. Names are those of the
// campaign's own samples.csv where that has the same; digits are all there are.
#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "wythe/campaign.h"

namespace wythe::io {

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
// The same of a run, from its summary.json; no inputs are known.
[[nodiscard]] std::vector<ExportCell> run_cells(const nlohmann::json& summary);

}  // namespace wythe::io
