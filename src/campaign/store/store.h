// The store of a campaign: DIR/campaign.db, one SQLite file (docs/reference/store.md).
//
//   create_store()  study and samples in one transaction: a file is a complete campaign or none
//   Store::write()  one sample in one transaction
//
// Journal in WAL mode with synchronous = NORMAL: killing the program loses nothing committed; after
// a power cut the file is consistent and may miss the last samples, which are run again. Not for
// use by two threads at once: the runner holds its own mutex.
#pragma once

#include <filesystem>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "campaign/store/database.h"
#include "campaign/store/digest.h"
#include "campaign/store/study_rows.h"
#include "wythe/parts/campaign.h"
#include "wythe/parts/error.h"

namespace wythe::study {

// Raised whenever a table, a column or the view `samples` changes: a test holds the checksum of all declarations beside
// it. A store of another version is refused.
inline constexpr int kSchemaVersion = 1;
inline constexpr const char* kStoreName = "campaign.db";

[[nodiscard]] std::filesystem::path store_path(const std::string& folder);
// Something of that name is there, whether it can be read or not: stores come into their place whole.
[[nodiscard]] bool holds_store(const std::string& folder);

// What is said once about a campaign beside its study and samples.
struct StoreHead {
  std::string shard = "1/1";
  std::string provenance;
  double load_height = 0;  // [m]
};

// "2/4" as 2 and 4; nothing where it is no shard.
struct Shard {
  int number = 1, of = 1;
};
[[nodiscard]] std::optional<Shard> shard_of(const std::string& text);
// Inputs of one sample, bit for bit but for the kind of zero; not a number is equal to itself.
[[nodiscard]] bool same_inputs(const std::vector<double>& a, const std::vector<double>& b);
// Of the push, or of the last stage [m]: drifts of every sample refer to it.
[[nodiscard]] double load_height_of(const Model& model);

// A sample ready to be written; packing it needs no lock.
struct PackedState {
  std::string label, bytes;
  double displacement = 0, reaction = 0;
  std::size_t blocks = 0, points = 0;
  double asked = kUnset;
};
struct PackedSample {
  SampleRecord record;
  std::string curve;
  std::vector<PackedState> states;
};
[[nodiscard]] PackedSample packed(SampleRecord record, const std::vector<Snapshot>& states);

class Store {
 public:
  using Access = Database::Access;
  Store(const std::string& folder, Access access);

  [[nodiscard]] StudySpec study();
  // Throws IoError where they are not those that were drawn.
  [[nodiscard]] SampleTable samples();
  [[nodiscard]] StoreHead head();
  [[nodiscard]] std::set<int> done();
  [[nodiscard]] std::vector<SampleRecord> records(int last);  // samples 1 .. last
  // Samples first .. last alone, `table` being samples(): a store may be larger than memory.
  [[nodiscard]] std::vector<SampleRecord> records(const SampleTable& table, int first, int last);
  // Of one sample, whose wall this is; IoError where they are not states of it.
  [[nodiscard]] std::vector<Snapshot> states(int sample, const Model& model);
  [[nodiscard]] std::string value(const std::string& key);
  // A value that counts samples; 0 where it is empty.
  [[nodiscard]] int number_of_sample(const std::string& key);

  void set_value(const std::string& key, const std::string& value);
  void add_samples(const SampleTable& samples, int first, const StudySpec& spec);
  void write(const PackedSample& sample);
  // Reads every page and every row but the states, and compares all with their checksums (digest.h);
  // IoError where one is damaged. A few samples at a time. `drawn`: what another
  // store of the same study drew, where this one says that it drew the same (inputs_digest()); then of its own
  // table only the rows of samples that ran are read.
  void check_whole(const SampleTable* drawn = nullptr);
  [[nodiscard]] std::string inputs_digest();  // as stored
  // Throws IoError where a table has rows of a sample that is not stored.
  void check_no_other_sample();
  // The same of the states of every sample that is stored.
  void check_states();
  [[nodiscard]] Database& database() { return database_; }

 private:
  void check_version();
  void check_tables();
  void check_view();
  void check_columns_of(const StudySpec& spec, const SampleTable& table);
  [[nodiscard]] SampleTable columns();  // without values
  void check_inputs_of(const SampleTable& drawn);
  [[nodiscard]] StudySpec study_in(const Rows& rows);
  SampleDigests& digests();
  Statement& prepared(const std::string& sql);  // kept, ready for its binds
  Database database_;
  std::optional<SampleDigests> digests_;
  std::map<std::string, Statement> prepared_;
};

// How a sample, or a shake of one, that is stored has ended.
[[nodiscard]] bool is_outcome(const std::string& status);
// Shakes that count have numbers, and end as a run does.
void check_shakes(Database& database, const SampleRecord& record,
                  const std::vector<ShakeResult>& shakes);
struct RecordLists;
// What an answered sample says must be numbers and places that there are.
void check_answer(Database& database, const SampleRecord& record, const RecordLists& lists);

// Makes the file and what a campaign begins with.
void create_store(const std::string& folder, const StudySpec& spec, const SampleTable& samples,
                  const StoreHead& head);
// The last sample that counts: where an until rule was met, or all.
[[nodiscard]] int last_counted(Store& store);

}  // namespace wythe::study
