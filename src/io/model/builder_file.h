// Gives the builder's tables of a model file as they are written. Their bodies are made when the file is read.
//
// Called by model_file.cpp, and by model_key.cpp for the keys that a study may vary.
#pragma once

#include <string>

#include "io/text/toml_reader.h"
#include "wythe/parts/builder.h"

namespace wythe::io {

// Reads them without a word: parse_table has said what is wrong with them. `spec` is what the same root gave.
[[nodiscard]] BuilderSpec parse_builder(const std::string& file, const toml::table& root,
                                        const ModelSpec& spec);

}  // namespace wythe::io
