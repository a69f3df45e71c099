// The source and the compiler of this program; --version prints it and every result keeps it.
#pragma once

namespace wythe {

struct Provenance {
  const char* version = "";   // of wythe, e.g. "0.1.0"
  const char* commit = "";    // git commit, "-dirty" when the tree differed, "unknown" without git
  const char* compiler = "";  // e.g. "GNU 12.2.0"
  const char* flags = "";     // compiler flags that may change bits
  const char* build_type = "";  // e.g. "Release"
};
[[nodiscard]] Provenance provenance();

}  // namespace wythe
