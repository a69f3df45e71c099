// Compares a sample that two stores contain: finds whether all tables are equal to the bit, or the first difference.
#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "campaign/store/store.h"

namespace wythe::study {

// All rows of a sample, except its run time, the program that ran it, and the checksums over both.
class SampleRows {
 public:
  explicit SampleRows(const std::string& folder);
  // The first difference in words, "table event, place (row 2): ... here, ... there"; none where all is equal.
  // Packed arrays are compared by content, because two versions of zstd may pack the same numbers differently.
  [[nodiscard]] static std::optional<std::string> difference(SampleRows& here, SampleRows& there,
                                                             int sample);
  struct Run {
    std::string status, state_hash, provenance;
  };
  [[nodiscard]] Run run(int sample);

 private:
  Store store_;
  Statement run_;
  std::vector<std::pair<std::string, Statement>> tables_;
};

}  // namespace wythe::study
