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

// To be increased whenever a table, a column or the view `samples` changes; a test
// contains the checksum of all declarations. A store of another version is refused.
inline constexpr int kSchemaVersion = 1;
inline constexpr const char* kStoreName = "campaign.db";

[[nodiscard]] std::filesystem::path store_path(const std::string& folder);
// Whether a file of that name exists, readable or not. A store is moved to its place only when it is complete.
[[nodiscard]] bool holds_store(const std::string& folder);

// Data that a campaign has once, beside its study and samples.
struct StoreHead {
  std::string shard = "1/1";
  std::string provenance;
  double load_height = 0;  // [m]
};

// "2/4" as 2 and 4; none where it is no shard.
struct Shard {
  int number = 1, of = 1;
};
[[nodiscard]] std::optional<Shard> shard_of(const std::string& text);
// Whether the inputs of two samples are equal bit for bit. The two zeros count as equal, and NaN equals itself.
[[nodiscard]] bool same_inputs(const std::vector<double>& a, const std::vector<double>& b);
// Load height of the push, or of the last stage [m]; the drifts of all samples refer to it.
[[nodiscard]] double load_height_of(const Model& model);

// A sample ready to be written. It is packed without a lock.
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
  // Throws IoError where they differ from those that were drawn.
  [[nodiscard]] SampleTable samples();
  [[nodiscard]] StoreHead head();
  [[nodiscard]] std::set<int> done();
  [[nodiscard]] std::vector<SampleRecord> records(int last);  // samples 1 .. last
  // Only samples first .. last, with samples() as `table`, because a store may be larger than memory.
  [[nodiscard]] std::vector<SampleRecord> records(const SampleTable& table, int first, int last);
  // The states of one sample with this wall; throws IoError where they do not fit it.
  [[nodiscard]] std::vector<Snapshot> states(int sample, const Model& model);
  [[nodiscard]] std::string value(const std::string& key);
  // A value that is a number of samples; 0 where it is empty.
  [[nodiscard]] int number_of_sample(const std::string& key);

  void set_value(const std::string& key, const std::string& value);
  void add_samples(const SampleTable& samples, int first, const StudySpec& spec);
  void write(const PackedSample& sample);
  // Reads every page and every row except the states, a few samples at a time, and
  // compares all with their checksums (digest.h). Throws IoError where one is damaged.
  // `drawn`: the samples of another store of the same study with the same
  // inputs_digest(). Then only the inputs of samples that ran are read from this store.
  void check_whole(const SampleTable* drawn = nullptr);
  [[nodiscard]] std::string inputs_digest();  // as stored
  // Throws IoError where a table has rows of a sample that is not stored.
  void check_no_other_sample();
  // The same check for the states of every stored sample.
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

// Whether `status` is a possible end of a stored sample or shake.
[[nodiscard]] bool is_outcome(const std::string& status);
// Shakes that count must have numbers, and an end like a run.
void check_shakes(Database& database, const SampleRecord& record,
                  const std::vector<ShakeResult>& shakes);
struct RecordLists;
// The results of an answered sample must be finite numbers, and its references must exist.
void check_answer(Database& database, const SampleRecord& record, const RecordLists& lists);

// Creates the file with the initial data of a campaign.
void create_store(const std::string& folder, const StudySpec& spec, const SampleTable& samples,
                  const StoreHead& head);
// The last sample that counts: the one that met the stop rule, or the last of all.
[[nodiscard]] int last_counted(Store& store);

}  // namespace wythe::study
