// A StudySpec as rows of key and value, as the store keeps it, and back; and what changed between
// two. Values are exact: shortest texts that read back to the same bits, SI.
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

// Settings by path, of one path the last: what they do to the model.
[[nodiscard]] std::map<std::string, std::string> in_effect(
    const std::vector<std::string>& settings);

// One fault for everything that makes other samples or other answers: key, was, is. Name, note,
// file names, the stop rule and the number of samples may change. `then` says when or where it was so.
[[nodiscard]] std::vector<Fault> changes(const StudySpec& was, const StudySpec& is,
                                         const std::string& store,
                                         const std::string& then = "when the campaign began");

// A checksum of the same: two studies have one where changes() finds nothing between them.
[[nodiscard]] std::string identity_of(const StudySpec& spec);

}  // namespace wythe::study
