// Commented files to start from (wythe new). Each is one of examples/, inside the program, and runs as it is.
#pragma once

#include <string>
#include <vector>

namespace wythe {

[[nodiscard]] std::vector<std::string> starter_kinds();
// Writes the files of a starter into `folder`, made if absent, and returns their paths, the one to run first
// ahead. Throws InputError for a kind that is not known and where one of the files is there already: nothing
// is written then. Throws IoError where the system refuses.
std::vector<std::string> write_starter(const std::string& kind, const std::string& folder);

}  // namespace wythe
