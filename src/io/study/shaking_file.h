// [shaking], [[record]] and [[limit_state]] of a study file.
#pragma once

#include <map>
#include <string>

#include "io/text/toml_reader.h"
#include "wythe/parts/study.h"

namespace wythe::io {

// Fills study.shaking and study.record_text with the content of files, including those of `base`.
// That is the base model as read (its stages and folder; without stages if it has faults).
void parse_shaking(ReadContext& context, const toml::table& root, const ModelSpec& base,
                   StudySpec& study);
// Texts of record files that the study file itself contains.
[[nodiscard]] std::map<std::string, std::string> given_records(ReadContext& context,
                                                               const toml::table& root);
// Builds the base model with each record at its highest intensity. Throws InputError with all faults.
void check_records(const StudySpec& study, const toml::table& root);

// The tables written as TOML again.
[[nodiscard]] std::string shaking_text(const StudySpec& study);

}  // namespace wythe::io
