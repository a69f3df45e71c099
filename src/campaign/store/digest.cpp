// A digest runs over the rows of one sample, table by table and in order of position, with all columns of each row.
// States have a digest of their own. The digests themselves are left out. The study is compared within one read
// transaction, so that no writer comes between its rows and its digest.
#include "campaign/store/digest.h"

#include <fmt/format.h>
#include <sqlite3.h>

#include "campaign/store/store_schema.h"
#include "core/bits.h"
#include "core/hash.h"

namespace wythe::study {
namespace {

std::int64_t as_stored(const Hash& hash) { return bits_as<std::int64_t>(hash.value()); }

std::string rows_of_sample(const std::string& table) {
  const bool is_list = table != "sample" && table != "curve";
  return fmt::format("SELECT * FROM {} WHERE sample = ?{}", table,
                     is_list ? " ORDER BY position" : "");
}

std::string digest_of(Database& database, const std::vector<std::string>& queries) {
  Hash hash;
  for (const std::string& query : queries) {
    Statement rows(database, query);
    while (rows.step()) rows.add_row(hash);
  }
  return hash.text();
}

const std::vector<std::string>& study_rows() {
  static const std::vector<std::string> kQueries = {
      fmt::format("SELECT key, value FROM study WHERE key NOT IN ('{}', '{}') ORDER BY position",
                  kStudyDigest, kInputsDigest),
      "SELECT * FROM input ORDER BY position"};
  return kQueries;
}
const std::vector<std::string>& input_rows() {
  static const std::vector<std::string> kQueries = {
      "SELECT sample, position, value FROM sample_input ORDER BY sample, position"};
  return kQueries;
}

void write(Database& database, const char* key, const std::string& value) {
  Statement(database,
            "INSERT INTO study (key, value) VALUES (?, ?) ON CONFLICT (key) DO UPDATE SET value = "
            "excluded.value")
      .run(key, value);
}

void check(Database& database, const char* key, const std::vector<std::string>& queries,
           const char* what) {
  const ReadTransaction moment(database);
  Statement select(database, "SELECT value FROM study WHERE key = ?");
  select.bind(key);
  const std::string stored = select.step() ? select.text() : "";
  if (digest_of(database, queries) != stored)
    database.damaged(std::string(what) + " is not what was stored (its checksum differs)");
}

}  // namespace

SampleDigests::SampleDigests(Database& database)
    : database_(database),
      state_{"state", Statement(database, rows_of_sample("state"))},
      stored_(database, "SELECT record, states FROM digest WHERE sample = ?") {
  tables_.push_back({"sample_input", Statement(database, rows_of_sample("sample_input"))});
  for (const std::string& table : result_tables())
    if (table != "state" && table != "digest")
      tables_.push_back({table, Statement(database, rows_of_sample(table))});
}

void SampleDigests::add(Table& table, int sample, Hash& hash) {
  hash.add(table.name);
  table.rows.bind(sample);
  while (table.rows.step()) table.rows.add_row(hash);
  table.rows.reset();
}

std::int64_t SampleDigests::record(int sample) {
  Hash hash;
  for (Table& table : tables_) add(table, sample, hash);
  return as_stored(hash);
}

std::int64_t SampleDigests::states(int sample) {
  Hash hash;
  add(state_, sample, hash);
  return as_stored(hash);
}

void SampleDigests::write(int sample) {
  if (!insert_) insert_.emplace(database_, insert_sql("digest", 3));
  insert_->run(sample, record(sample), states(sample));
}

std::optional<SampleDigest> SampleDigests::stored(int sample) {
  stored_.bind(sample);
  std::optional<SampleDigest> digest;
  if (stored_.step()) {
    const std::int64_t record = stored_.integer();
    digest = {record, stored_.integer()};
  }
  stored_.reset();
  return digest;
}

void SampleDigests::refuse(int sample, const char* what) {
  database_.damaged(
      fmt::format("sample {}: {} not what was stored (the checksum differs)", sample, what));
}

void SampleDigests::check_record(int sample) {
  const std::optional<SampleDigest> digest = stored(sample);
  if (!digest || digest->record != record(sample)) refuse(sample, "its numbers are");
}

void SampleDigests::check_states(int sample) {
  Hash none;
  none.add(state_.name);
  const std::optional<SampleDigest> digest = stored(sample);
  if (states(sample) != (digest ? digest->states : as_stored(none)))
    refuse(sample, "its states are");
}

void write_study_digests(Database& database) {
  write(database, kInputsDigest, digest_of(database, input_rows()));
  write(database, kStudyDigest, digest_of(database, study_rows()));
}

void check_study_digest(Database& database) {
  check(database, kStudyDigest, study_rows(), "the study (table study or input)");
}

void check_inputs_digest(Database& database) {
  check(database, kInputsDigest, input_rows(), "what was drawn (table sample_input)");
}

ReadTransaction::ReadTransaction(Database& database) : database_(database) {
  database_.execute("SAVEPOINT moment");
}
ReadTransaction::~ReadTransaction() {
  sqlite3_exec(database_.handle(), "RELEASE moment", nullptr, nullptr, nullptr);
}

}  // namespace wythe::study
