// The builder's tables of a model file as written. Their bodies are made when the file is read.
//
// Called by model_file.cpp, and by model_key.cpp for the keys that a study may vary.
#pragma once

#include <string>

#include "io/text/toml_reader.h"
#include "wythe/parts/builder.h"

namespace wythe::io {

// Parses them without messages, because parse_table has reported their faults. `spec` is from the same root.
[[nodiscard]] BuilderSpec parse_builder(const std::string& file, const toml::table& root,
                                        const ModelSpec& spec);

}  // namespace wythe::io
