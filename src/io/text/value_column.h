// One column of a CSV file of measured values, for an empirical distribution.
#pragma once

#include <string>
#include <vector>

#include "io/text/toml_reader.h"

namespace wythe::io {

struct ColumnRequest {
  std::string file;     // as messages name it; already found relative to the study
  std::string column;   // its head, with or without the unit; "" where the file has one column only
  std::string si_unit;  // the values' unit
  std::string unit;     // of the values where the head names none; "" when the study names none
};

// Reads the values [SI]. The head may name the unit: "ft_MPa", "ft [MPa]", "ft (MPa)". What is wrong
// becomes a fault with the file and its line. Throws IoError when the file can't be read.
[[nodiscard]] std::vector<double> parse_value_column(const ColumnRequest& request,
                                                     FaultList& faults);

}  // namespace wythe::io
