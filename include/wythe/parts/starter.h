// Commented files to start from (`wythe new`). Each is one of examples/, stored inside the program, and runs unchanged.
#pragma once

#include <string>
#include <vector>

namespace wythe {

[[nodiscard]] std::vector<std::string> starter_kinds();  // values of `kind` below
// Writes the files of a starter into `folder`, made if absent, and returns their paths; the first one is the file to
// run. Throws InputError for an unknown kind, and where one of the files exists: then nothing is
// written. Throws IoError where the system refuses.
std::vector<std::string> write_starter(const std::string& kind, const std::string& folder);

}  // namespace wythe
