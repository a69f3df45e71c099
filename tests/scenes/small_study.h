// A study small enough for tests: 8 x 8 half units pushed by half
// a millimetre, 40 ms for each sample; and a temporary folder.
#pragma once

#include <filesystem>
#include <string>

#include "wythe/parts/study.h"

namespace wythe::scenes {

// Tensile strength of the joints is random, cohesion follows from it. `distribution` are the keys of
// [variable.ft], e.g. "distribution = \"normal\"\nmean = \"0.15 MPa\"\ncov = 0.2\n".
[[nodiscard]] StudySpec small_study(int samples, const std::string& distribution = "");

class TemporaryFolder {
 public:
  TemporaryFolder();
  ~TemporaryFolder();
  TemporaryFolder(const TemporaryFolder&) = delete;
  TemporaryFolder& operator=(const TemporaryFolder&) = delete;
  [[nodiscard]] std::string operator/(const std::string& name) const {
    return (path_ / name).string();
  }

 private:
  std::filesystem::path path_;
};

}  // namespace wythe::scenes
