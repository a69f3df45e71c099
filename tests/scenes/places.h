// Where the tests find the sources, and where they put what they write.
#pragma once

#include <string>

namespace wythe {

// The folder of the sources.
[[nodiscard]] std::string source_dir();
// <build>/tests/fresh: new golden files and figures, from which tools/bless and tools/verification_table copy.
[[nodiscard]] std::string fresh_dir();

}  // namespace wythe
