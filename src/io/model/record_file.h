// Records of accelerations from files: CSV and PEER's AT2.
#pragma once

#include "io/text/toml_reader.h"

namespace wythe::io {

// The numbers of every record that is a file, into its RecordSpec; faults at their keys and lines.
void parse_records(ReadContext& context, ModelSpec& spec);

// The same as a CSV, exact to the bit.
[[nodiscard]] std::string record_text(const RecordSpec& record);

}  // namespace wythe::io
