// The largest input that each reader accepts, one number a line with its reason (docs/reference/limits.md).
//
// Readers check these before they allocate memory or spend time. Limits of the wall itself stand in model/size.h.
#pragma once

#include <cstddef>

#include "wythe/parts/error.h"

namespace wythe {

// --- bytes of one file
constexpr std::size_t kMostToml = 4'000'000;   // a model of 1000 openings has 0.3 MB
constexpr std::size_t kMostJson = 32'000'000;  // 170 000 blocks; in memory up to 40 times as much
constexpr std::size_t kMostDxf =
    64'000'000;  // a drawing of 200 000 stones; in memory five times as much
constexpr std::size_t kMostMesh = 64'000'000;  // a million triangles; 5000 blocks have 2 MB
constexpr std::size_t kMostCsv = 256'000'000;  // a curve of a million rows has 200 MB
constexpr std::size_t kMostPacked =
    512'000'000;  // data of a report, unpacked: no browser takes more; a cell of a store
constexpr std::size_t kMostCheckpoint = 4'000'000'000;  // 60 states of 200 000 blocks

// --- shape of a text
constexpr int kMostDepth = 32;         // depth of nested tables and lists: a model has 5
constexpr int kMostKeys = 20'000;      // keys of a TOML file: a model of 1000 openings has 11 000
constexpr int kMostSettings = 2'000;   // of --set and study.set: each is searched among all keys
constexpr int kMostColumns = 1'000;    // columns of a CSV file
constexpr int kMostHeadLines = 100;    // lines before the numbers of a record: ESM has 64
constexpr int kMostSampledRows = 50;   // rows of a table that determine its delimiter
constexpr int kMostRows = 10'000'000;  // of a CSV file or a curve: output.rows may ask for a tenth

// --- what an error message lists
constexpr std::size_t kMostFaults = 100;  // listed at once: nobody mends more before the next try
[[nodiscard]] inline bool enough(const FaultList& faults) {
  return faults.all().size() > kMostFaults;
}
constexpr std::size_t kMostCandidates = 500;  // names that a misspelt one is compared with
constexpr std::size_t kLongestName = 100;     // characters of a name that is compared

}  // namespace wythe
