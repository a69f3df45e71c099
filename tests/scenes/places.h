// The folders of the tests: where the sources are, and where output goes.
#pragma once

#include <string>

namespace wythe {

// The folder of the sources.
[[nodiscard]] std::string source_dir();
// <build>/tests/fresh: new golden files and figures, from which tools/bless and tools/verification_table copy.
[[nodiscard]] std::string fresh_dir();

}  // namespace wythe
