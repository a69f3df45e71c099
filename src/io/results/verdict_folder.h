// The folder of a verdict whose walls lie in no store: assessment.json, walls.csv and report.html alone.
#pragma once

#include <memory>
#include <string>

#include "wythe/parts/io.h"

namespace wythe {

// Throws InputError where the folder holds other files, such as the campaigns of `wythe assess`, or the verdict on another model.
void check_verdict_folder(const std::string& folder, const Origin& origin);
// The same, then the Replacement for the files (the folder is made if absent), with their origin.
[[nodiscard]] std::unique_ptr<Replacement> replace_verdict(const std::string& folder,
                                                           const Origin& origin);
[[nodiscard]] bool is_file_of_verdict(const std::string& name);  // names of its files

}  // namespace wythe
