// Stores with contradictions but correct checksums: each is refused
// with file, table and column, by an IoError (exit code 4).
#include <gtest/gtest.h>
#include <sqlite3.h>

#include <filesystem>
#include <string>
#include <utility>
#include <vector>

#include "campaign/store/store_schema.h"
#include "scenes/changed_store.h"
#include "scenes/places.h"
#include "scenes/small_study.h"
#include "wythe/parts/error.h"
#include "wythe/parts/io.h"

namespace wythe::study::signed_store_test {
namespace {

namespace fs = std::filesystem;
using scenes::TemporaryFolder;

bool has(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

class SignedStore : public testing::Test {
 protected:
  static void SetUpTestSuite() {
    made_ = new TemporaryFolder;
    const StudySpec study = scenes::small_study(2);
    run_campaign(study, model_builder(study), *made_ / "out", {.jobs = 1});
    Database(store_path(*made_ / "out"), Database::Access::kWrite)
        .execute("PRAGMA journal_mode = DELETE");
  }
  static void TearDownTestSuite() { delete made_; }
  void put_back() {
    fs::remove_all(out_);
    fs::create_directories(out_);
    fs::copy_file(store_path(*made_ / "out"), store_path(out_));
  }
  // Also what SQLite keeps from changing.
  void change(const std::string& sql) {
    Database database(store_path(out_), Database::Access::kWrite);
    sqlite3_db_config(database.handle(), SQLITE_DBCONFIG_DEFENSIVE, 0, nullptr);
    database.execute("PRAGMA synchronous = OFF; PRAGMA writable_schema = 1; " + sql);
  }
  void sign() { scenes::renew_checksums(out_); }
  std::string said() {
    try {
      check_campaign(out_);
    } catch (const IoError& error) {
      return error.what();
    }
    return "";
  }
  static TemporaryFolder* made_;
  TemporaryFolder folder_;
  std::string out_ = folder_ / "out";
};
TemporaryFolder* SignedStore::made_ = nullptr;

TEST_F(SignedStore, answers_that_cannot_be_are_refused) {
  put_back();
  sign();
  ASSERT_EQ(said(), "");
  for (const auto& [sql, words] : std::vector<std::pair<std::string, std::string>>{
           {"UPDATE sample SET peak_reaction_N = 9e999 WHERE sample = 2",
            "table sample, sample 2: peak_reaction_N is infinite"},
           {"UPDATE sample SET displacement_max_m = -9e999 WHERE sample = 2",
            "table sample, sample 2: displacement_max_m is infinite"},
           {"UPDATE event SET reaction_N = 9e999 WHERE sample = 1",
            "table event, sample 1: reaction_N is infinite"},
           {"UPDATE sample SET peak_reaction_N = peak_reaction_N * 1.5, peak_raw_N = peak_raw_N "
            "WHERE sample = 2 AND peak_reaction_N > 0",
            "sample 2: peak_reaction_N and displacement_at_peak_m are no row of its curve"},
           {"UPDATE sample SET displacement_at_peak_raw_m = 0.0123",
            "peak_raw_N and displacement_at_peak_raw_m are no row of its curve"},
           {"UPDATE sample SET rate_judgement = 'excellent' WHERE sample = 1",
            "sample 1: rate_judgement is \"excellent\""},
           {"UPDATE event SET position = position + 1 WHERE sample = 2 AND position = (SELECT "
            "max(position) FROM event WHERE sample = 2)",
            "table event, sample 2: position is "},
           {"UPDATE score SET failure_mode = 'FM-1'", "the score of FM-1 stands there twice"},
           {"UPDATE study SET value = '1/2x' WHERE key = 'shard'", "shard: \"1/2x\" is none"},
           {"UPDATE study SET value = '3/2' WHERE key = 'shard'", "shard: \"3/2\" is none"},
           {"UPDATE study SET value = '+1/2' WHERE key = 'shard'", "shard: \"+1/2\" is none"},
           {"UPDATE study SET value = '6' WHERE key = 'schema_version'",
            "table study, schema_version: \"6\""},
           {"UPDATE input SET name = 'fx' WHERE position = 0",
            "table input, position 0: name is not that of the study"},
           {"UPDATE input SET path = 'wall.thickness' WHERE position = 0",
            "position 0: path is not"},
           {"UPDATE input SET unit = 'kPa' WHERE position = 0", "position 0: unit is not"},
           {"UPDATE input SET to_unit = 1 WHERE position = 0", "position 0: to_unit is not"},
           {"UPDATE input SET si_unit = 'N' WHERE position = 0", "position 0: si_unit is not"},
           {"UPDATE input SET is_random = 1 WHERE position = 1", "position 1: is_random is not"}}) {
    put_back();
    change(sql);
    sign();
    const std::string refused = said();
    EXPECT_TRUE(has(refused, words) && has(refused, "out/campaign.db: is damaged"))
        << sql << "\n  said: " << refused;
  }
}

TEST_F(SignedStore, declarations_are_compared_word_for_word) {
  std::vector<std::pair<std::string, std::string>> changes = {
      {"CREATE TRIGGER t AFTER INSERT ON sample BEGIN DELETE FROM curve; END",
       "its trigger t is none"},
      {"CREATE VIEW more AS SELECT * FROM sample", "its view more is none"},
      {"CREATE INDEX quick ON sample (steps)", "its index quick is none"},
      {"CREATE TABLE notes (text)", "its table notes is none"},
      {"DROP VIEW samples", "view samples is missing"},
      {"DROP VIEW samples; CREATE VIEW samples AS SELECT * FROM sample",
       "the view samples is not declared as wythe declares it"},
      {"UPDATE sqlite_schema SET sql = replace(sql, 'e-06', 'e-05') WHERE name = 'samples'",
       "the view samples is not declared as wythe declares it"}};
  for (const auto& [table, sql] : declared_tables()) {
    changes.emplace_back(
        "UPDATE sqlite_schema SET sql = replace(sql, ' (', '  (') WHERE name = '" + table + "'",
        "its table " + table + " is not declared as this wythe declares it");
    changes.emplace_back("DROP TABLE " + table, "table " + table + " is missing");
  }
  for (const auto& [sql, words] : changes) {
    put_back();
    change(sql);
    if (!has(sql, "DROP TABLE")) {
      try {
        sign();
      } catch (const IoError&) {
      }
    }
    const std::string refused = said();
    EXPECT_TRUE(has(refused, words)) << sql << "\n  said: " << refused;
  }
}

// Samples beyond the end of a stop rule count again after a merge with other samples, because they were requested.
TEST_F(SignedStore, a_rule_that_was_met_ends_with_a_merge) {
  put_back();
  StudySpec more = scenes::small_study(2);
  more.batch = {2, 2};
  const std::string other = folder_ / "other";
  run_campaign(more, model_builder(more), other, {.jobs = 1});
  Store(out_, Store::Access::kWrite).set_value("until_met_at", "1");
  ASSERT_EQ(read_campaign(out_).records.size(), 1U);
  merge_campaigns({*made_ / "out"}, out_);  // nothing new: the rule stands
  EXPECT_EQ(read_campaign(out_).records.size(), 1U);
  merge_campaigns({other}, out_);
  EXPECT_EQ(read_campaign(out_).records.size(), 4U);
  check_campaign(out_);
}

}  // namespace
}  // namespace wythe::study::signed_store_test
