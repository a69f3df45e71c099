// Converts a StudySpec to rows of key and value for the store, and back. Also finds changes between
// two studies. Values are exact: the shortest texts that read back to the same bits, in SI units.
#pragma once

#include <map>
#include <string>
#include <utility>
#include <vector>

#include "wythe/parts/error.h"
#include "wythe/parts/study.h"

namespace wythe::study {

using Rows = std::vector<std::pair<std::string, std::string>>;

[[nodiscard]] Rows rows_of(const StudySpec& spec);
[[nodiscard]] StudySpec study_of(const Rows& rows);
// The value of a key, "" where there is none.
[[nodiscard]] std::string value_of(const Rows& rows, const std::string& key);

// Settings by path. Of several with one path the last one counts, as for the model.
[[nodiscard]] std::map<std::string, std::string> in_effect(
    const std::vector<std::string>& settings);

// One fault for each change that leads to other samples or other results: key, old value, new value. Name, note,
// file names, the stop rule and the number of samples may change. `then` says when or where the old value was used.
[[nodiscard]] std::vector<Fault> changes(const StudySpec& was, const StudySpec& is,
                                         const std::string& store,
                                         const std::string& then = "when the campaign began");

// A checksum of the same data: it is equal for two studies if changes() finds no difference.
[[nodiscard]] std::string identity_of(const StudySpec& spec);

}  // namespace wythe::study
