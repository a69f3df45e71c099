// One column of a CSV file of measured values, for an empirical distribution.
#pragma once

#include <string>
#include <vector>

#include "io/text/toml_reader.h"

namespace wythe::io {

struct ColumnRequest {
  std::string file;     // for messages; already resolved relative to the study
  std::string column;   // its header, with or without the unit; "" if the file has only one column
  std::string si_unit;  // the values' unit
  std::string unit;     // unit of the values if the header has none; "" if the study names none
};

// Reads the values [SI]. The header may contain the unit: "ft_MPa", "ft [MPa]", "ft
// (MPa)". Faults have the file and the line. Throws IoError when the file cannot be read.
[[nodiscard]] std::vector<double> parse_value_column(const ColumnRequest& request,
                                                     FaultList& faults);

}  // namespace wythe::io
