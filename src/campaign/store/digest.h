// Checksums over the rows of a store, so that a damaged number in any column is found and reported.
//
//   sample   table `digest`: one over its inputs and its rows in every table but `state`, one over its states
//   study    rows of `study`: `digest` over the tables study and input, `digest_inputs` over sample_input
//
// A value counts with its type and all its bits, a row with its place. FNV-1a of 64 bits: each step can be undone, so
// a change of one byte always shows, and any other but for 1 in 2^64. They do not protect against deliberate changes.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "campaign/store/database.h"

namespace wythe::study {

inline constexpr const char* kStudyDigest = "digest";
inline constexpr const char* kInputsDigest = "digest_inputs";

struct SampleDigest {
  std::int64_t record = 0, states = 0;
};

// The digests of the samples of one store; its statements are prepared once.
class SampleDigests {
 public:
  explicit SampleDigests(Database& database);
  [[nodiscard]] std::int64_t record(int sample);
  [[nodiscard]] std::int64_t states(int sample);
  // Called in the transaction that stores the sample, after its last row.
  void write(int sample);
  // Throws IoError where rows differ from the stored ones. A sample that is not stored has no states.
  void check_record(int sample);
  void check_states(int sample);

 private:
  struct Table {
    std::string name;
    Statement rows;
  };
  static void add(Table& table, int sample, Hash& hash);
  [[nodiscard]] std::optional<SampleDigest> stored(int sample);
  [[noreturn]] void refuse(int sample, const char* what);

  Database& database_;
  std::vector<Table> tables_;
  Table state_;
  Statement stored_;
  std::optional<Statement> insert_;  // only of a store that is written
};

// Writes both digests of the study again, in the transaction that changed its rows.
void write_study_digests(Database& database);
// Throws IoError if table study or input was changed, or sample_input was.
void check_study_digest(Database& database);
void check_inputs_digest(Database& database);

// All reads within its lifetime see the same state of the store, also while a campaign writes.
class ReadTransaction {
 public:
  explicit ReadTransaction(Database& database);
  ~ReadTransaction();
  ReadTransaction(const ReadTransaction&) = delete;
  ReadTransaction& operator=(const ReadTransaction&) = delete;

 private:
  Database& database_;
};

}  // namespace wythe::study
