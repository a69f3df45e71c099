// Records of accelerations from files: columns of CSV, and the formats of record_formats.h.
#pragma once

#include "io/text/toml_reader.h"

namespace wythe::io {

// Reads the numbers of every record from a file into its RecordSpec; faults have their keys and lines.
void parse_records(ReadContext& context, ModelSpec& spec);

// The same as a CSV, exact to the bit.
[[nodiscard]] std::string record_text(const RecordSpec& record);

}  // namespace wythe::io
