// Compares a sample that two stores hold: equal to the bit in every table, or where they differ.
#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "campaign/store/store.h"

namespace wythe::study {

// All that a sample left but the time it took, by which program it was run, and the checksums over both.
class SampleRows {
 public:
  explicit SampleRows(const std::string& folder);
  // The first difference in words, "table event, place (row 2): ... here, ... there"; nothing where all is equal. Packed
  // arrays are compared by what they hold: two versions of zstd may pack the same numbers in other bytes.
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
