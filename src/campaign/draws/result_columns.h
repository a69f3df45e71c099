// Names of columns that results have, which an input may not take: samples.csv, exported tables and the view
// `samples` of the store would have two columns of one name.
#pragma once

#include <string>

namespace wythe::study {

// Small letters: SQLite, and some programs that read tables, tell no case.
[[nodiscard]] std::string without_case(std::string title);

// Whether results have a column of this title, in any case.
[[nodiscard]] bool is_result_column(const std::string& title);

}  // namespace wythe::study
