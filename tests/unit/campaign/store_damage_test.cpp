// Stores that were changed: they are read with their content, or refused
// with a reason. There is never a crash or a number from beyond an array.
#include <gtest/gtest.h>
#include <sqlite3.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <set>
#include <string>
#include <vector>

#include "campaign/store/store.h"
#include "scenes/changed_store.h"
#include "scenes/places.h"
#include "scenes/small_study.h"
#include "wythe/parts/error.h"
#include "wythe/parts/io.h"
#include "wythe/parts/report.h"
#include "wythe/parts/solve.h"
#include "wythe/parts/statistics.h"

namespace wythe::study::store_damage_test {
namespace {

namespace fs = std::filesystem;
using scenes::TemporaryFolder;

bool has(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

// The message of an input or store error, "" if there was none; any other error is a failure.
template <class Call>
std::string said_by(Call call) {
  try {
    call();
  } catch (const IoError& error) {
    return error.what();
  } catch (const InputError& error) {
    return error.what();
  } catch (const std::exception& error) {
    ADD_FAILURE() << "neither IoError nor InputError: " << error.what();
  }
  return "";
}

// All that `wythe report` makes of a store.
std::string reported(const std::string& folder) {
  const Campaign campaign = read_campaign(folder);
  const Statistics statistics = statistics_of(campaign);
  const SampleWalls walls = {
      .build = model_builder(campaign.study),
      .states = [&](int sample, const Model& model) { return read_states(folder, sample, model); }};
  return samples_csv(campaign) + statistics_json(statistics) +
         campaign_data(campaign, statistics, walls);
}

// --- stores that somebody has changed

class ChangedStore : public testing::Test {
 protected:
  static void SetUpTestSuite() {
    made_ = new TemporaryFolder;
    const StudySpec study = scenes::small_study(2);
    run_campaign(study, model_builder(study), *made_ / "out", {.jobs = 1});
    // hundreds of copies are opened: without a journal of their own that is quick
    Database(store_path(*made_ / "out"), Database::Access::kWrite)
        .execute("PRAGMA journal_mode = DELETE");
  }
  static void TearDownTestSuite() { delete made_; }
  void SetUp() override { put_back(); }

  void put_back() {
    fs::remove_all(out_);
    fs::remove_all(folder_ / "merged");
    fs::create_directories(out_);
    fs::copy_file(store_path(*made_ / "out"), store_path(out_));
  }
  // The number of changed rows; 0 also if the file itself forbids the change.
  std::int64_t change(const std::string& sql) {
    Database database(store_path(out_), Database::Access::kWrite);
    try {
      database.execute("PRAGMA synchronous = OFF");
      database.execute(sql);
    } catch (const IoError&) {
      return 0;
    }
    return database.integer("SELECT changes()");
  }
  // Reads such a table like the reading commands; tables of lists are only used through the record.
  void use(const std::string& table) {
    static const std::set<std::string> kDrawn = {"study", "input", "sample_input", "curve",
                                                 "state"};
    if (kDrawn.contains(table)) {
      (void)reported(out_);
    } else {
      const Campaign campaign = read_campaign(out_);
      (void)(samples_csv(campaign) + statistics_json(statistics_of(campaign)));
    }
    if (table != "study" && table != "sample_input") return;
    const Campaign campaign = read_campaign(out_);
    SolveOptions few;
    few.step_budget = 1000;
    (void)run_sample(campaign.study, campaign.samples, 1, model_builder(campaign.study), few);
  }
  // And those that write.
  void go_on(const std::string& table) {
    static const std::set<std::string> kCopied = {"study", "input", "sample_input", "sample",
                                                  "curve", "state", "sign"};
    if (!kCopied.contains(table)) return;
    const std::string merged = said_by([&] { merge_campaigns({out_}, folder_ / "merged"); });
    EXPECT_EQ(merged.empty(), fs::exists(folder_ / "merged")) << merged;
    const StudySpec asked = scenes::small_study(2);
    run_campaign(asked, model_builder(asked), out_, {.jobs = 1, .resume = true});
  }
  void renew_checksums() { scenes::renew_checksums(out_); }
  std::string said_by_report() {
    return said_by([&] { (void)reported(out_); });
  }

  static TemporaryFolder* made_;
  TemporaryFolder folder_;
  std::string out_ = folder_ / "out";
};
TemporaryFolder* ChangedStore::made_ = nullptr;

TEST_F(ChangedStore, counts_are_compared_with_the_wall_and_the_study) {
  for (const auto& [sql, words] : std::vector<std::pair<std::string, std::string>>{
           {"UPDATE state SET blocks = blocks + 1", "table state, sample 1: blocks is "},
           {"UPDATE state SET points = 1000000000000", "table state, sample 1: points is 10000"},
           {"UPDATE state SET blocks = -1", "blocks is -1"},
           {"UPDATE state SET data = (SELECT data FROM curve)", "does not hold"},
           {"UPDATE curve SET rows = 9000000", "the curve of sample 1 is damaged"},
           {"UPDATE curve SET rows = 4611686018427387904", "rows is 4611686018427387904"},
           {"UPDATE curve SET rows = 0", "rows is 0"},
           {"UPDATE curve SET sample = 9 WHERE sample = 2",
            "sample is 9, which must be from 1 to 2"},
           {"DELETE FROM sample_input WHERE sample = 1 AND position = 0", "input 0 of sample 1"},
           {"DELETE FROM sample_input WHERE sample = 2", "inputs of 1 samples, its design has 2"},
           {"UPDATE sample_input SET position = 7 WHERE position = 1", "input 1 of sample 1"},
           {"UPDATE sample_input SET value = NULL", "an input that is no number"},
           {"UPDATE study SET value = '3' WHERE key = 'samples'", "its design has 3"},
           {"UPDATE study SET value = '1e300' WHERE key = 'samples'", "samples: "},
           {"UPDATE study SET value = 'sometimes' WHERE key = 'design'", "design: \"sometimes\""},
           {"UPDATE study SET value = 'high' WHERE key = 'load_height_m'", "is not a height"},
           {"UPDATE study SET value = '-3' WHERE key = 'until_met_at'", "not a number of samples"},
           {"UPDATE sign SET of_element = 1000000000", "a sign belongs to element 1000000000"},
           {"UPDATE sample SET status = 'excellent'", "no sample ends as \"excellent\""},
           {"UPDATE sample SET peak_reaction_N = 'strong'", "peak_reaction_N is not a number"},
           {"ALTER TABLE sample DROP COLUMN peak_reaction_N",
            "its table sample is not declared as this wythe declares it"},
           {"DROP TABLE event", "event"}}) {
    put_back();
    Database(store_path(out_), Database::Access::kWrite).execute("DROP VIEW samples;" + sql);
    if (!has(sql, "DROP TABLE")) renew_checksums();
    const std::string said = said_by_report();
    EXPECT_TRUE(has(said, words)) << sql << "\n  said: " << said;
    EXPECT_TRUE(has(said, "campaign.db")) << said;
    EXPECT_TRUE(has(said, "restore it from a copy") || has(sql, "DROP TABLE")) << said;
  }
}

// A store may not have a table that runs without end, computes its cells, or writes when it is written to.
TEST_F(ChangedStore, tables_that_compute_are_refused_before_they_are_read) {
  const std::string endless =
      "WITH RECURSIVE n(i) AS (SELECT 1 UNION ALL SELECT i + 1 FROM n) SELECT i AS sample, 0 AS "
      "position, 'x' AS name FROM n";
  for (const auto& [sql, words] : std::vector<std::pair<std::string, std::string>>{
           {"DROP TABLE event; CREATE VIEW event AS " + endless, "its view event is none"},
           {"DROP TABLE study; CREATE VIEW study AS " + endless, "its view study is none"},
           {"CREATE TRIGGER t AFTER INSERT ON sample BEGIN DELETE FROM curve; END",
            "its trigger t is none"},
           {"ALTER TABLE event ADD COLUMN z AS (zeroblob(1000000000))",
            "its table event is not declared"},
           {"ALTER TABLE event ADD COLUMN z TEXT DEFAULT 'long'",
            "its table event is not declared"}}) {
    put_back();
    Database(store_path(out_), Database::Access::kWrite).execute("DROP VIEW samples;" + sql);
    const std::string said = said_by_report();
    EXPECT_TRUE(has(said, words) && has(said, "restore it from a copy")) << sql << "\n  " << said;
  }
}

TEST_F(ChangedStore, states_that_unpack_to_more_than_memory_are_refused) {
  const Campaign campaign = read_campaign(out_);
  const Model model = compile(model_builder(campaign.study)(settings_of(campaign.samples, 0)));
  EXPECT_GT(read_states(out_, 1, model).size(), 0U);
  Database(store_path(out_), Database::Access::kWrite)
      .execute(
          "WITH RECURSIVE n(i) AS (SELECT count(*) FROM state WHERE sample = 1 UNION ALL SELECT i "
          "+ 1 "
          "FROM n WHERE i < 1100) "
          "INSERT INTO state SELECT 1, i, 'copy', 0, 0, blocks, points, data, NULL FROM n, "
          "(SELECT * FROM state WHERE sample = 1 LIMIT 1)");
  renew_checksums();
  ::setenv("WYTHE_MEMORY", "10 MB", 1);
  const std::string said = said_by([&] { (void)read_states(out_, 1, model); });
  ::unsetenv("WYTHE_MEMORY");
  EXPECT_TRUE(has(said, "unpacks to more than 0.01 GB")) << said;
}

TEST_F(ChangedStore, another_walls_state_is_not_drawn_as_this_ones) {
  const TemporaryFolder other;
  const SampleRecord any = read_campaign(out_).records.at(0);
  Store store(out_, Store::Access::kWrite);
  store.database().execute("DELETE FROM state");
  State small;
  for (auto* a : {&small.ux, &small.uy, &small.theta}) a->assign(2, 1e-3);
  for (auto* a : {&small.kappa, &small.crush, &small.plastic_slip, &small.slip, &small.shear_damage,
                  &small.tension_set})
    a->assign(4, 0.0);
  const PackedSample two_blocks = packed(any, {{"end", 1e-3, 1e3, small}});
  Statement(store.database(), "INSERT INTO state VALUES (1, 0, 'end', 1e-3, 1e3, 2, 4, ?, NULL)")
      .run(Bytes{two_blocks.states[0].bytes});
  renew_checksums();
  EXPECT_TRUE(has(said_by_report(), "table state, sample 1: blocks is 2, which must be from "));
}

// Numbers that are possible but not those that were stored, in every column of every table.
TEST_F(ChangedStore, no_changed_number_passes_for_what_was_stored) {
  std::vector<std::pair<std::string, std::string>> columns;
  {
    Database database(store_path(out_), Database::Access::kRead);
    Statement all(database,
                  "SELECT t.name, c.name FROM sqlite_schema t, pragma_table_info(t.name) c WHERE "
                  "t.type = 'table'");
    while (all.step()) {
      std::string table = all.text();
      columns.emplace_back(std::move(table), all.text());
    }
  }
  int changes = 0;
  for (const auto& [table, column] : columns) {
    if (table == "study" && column == "position") continue;  // their order says nothing
    for (const std::string& value :
         {column + " * (1 + 1e-15)", column + " + 1", column + " || 'x'", std::string("NULL")}) {
      put_back();
      const std::string cell = table + "." + column + " = " + value;
      if (change("UPDATE OR IGNORE " + table + " SET " + column + " = " + value + " WHERE " +
                 column + " IS NOT " + value + " AND rowid = (SELECT max(rowid) FROM " + table +
                 ")") == 0 &&
          change("UPDATE OR IGNORE " + table + " SET " + column + " = " + value + " WHERE " +
                 column + " IS NOT " + value) == 0)
        continue;
      ++changes;
      const std::string said = said_by([&] { check_campaign(out_); });
      EXPECT_TRUE(has(said, "campaign.db") && has(said, "damaged")) << cell << ": " << said;
    }
  }
  EXPECT_GT(changes, 250);
  put_back();
  EXPECT_EQ(said_by([&] { check_campaign(out_); }), "");
}

TEST_F(ChangedStore, a_changed_sample_is_neither_reported_merged_nor_continued) {
  for (const char* sql :
       {"UPDATE sample SET peak_reaction_N = peak_reaction_N * 1.5 WHERE sample = 2",
        "UPDATE feature SET value_m = value_m * 2 WHERE sample = 2",
        "UPDATE sample_input SET value = value * 2 WHERE sample = 2",
        "UPDATE study SET value = '8' WHERE key = 'seed'", "UPDATE input SET to_unit = 1",
        "DELETE FROM digest WHERE sample = 2",
        "DELETE FROM event WHERE sample = 2 AND position = 0",
        "UPDATE state SET reaction_N = reaction_N + 1 WHERE sample = 2"}) {
    put_back();
    change(sql);
    EXPECT_TRUE(has(said_by_report(), "damaged")) << sql;
    const std::string merged = said_by([&] { merge_campaigns({out_}, folder_ / "merged"); });
    EXPECT_TRUE(has(merged, "damaged") && !fs::exists(folder_ / "merged")) << sql << merged;
  }
}

// A byte of the view would turn Pa into something else for whoever asks it, with every row as it was.
TEST_F(ChangedStore, a_table_or_view_that_is_declared_otherwise_is_found) {
  for (const char* sql :
       {"UPDATE sqlite_schema SET sql = replace(sql, 'e-06', 'e-05') WHERE name = 'samples'",
        "UPDATE sqlite_schema SET sql = replace(sql, 'element TEXT', 'element TEYT') WHERE name = "
        "'evidence'"}) {
    put_back();
    study::Database database(study::store_path(out_), study::Database::Access::kWrite);
    sqlite3_db_config(database.handle(), SQLITE_DBCONFIG_DEFENSIVE, 0, nullptr);
    database.execute(std::string("PRAGMA writable_schema = 1; ") + sql);
    ASSERT_GT(sqlite3_changes(database.handle()), 0) << sql;
    EXPECT_TRUE(has(said_by([&] { check_campaign(out_); }), "damaged")) << sql;
  }
  put_back();
}

TEST_F(ChangedStore, rows_of_a_sample_that_is_not_stored_are_found) {
  for (const char* sql :
       {"UPDATE sample SET sample = 4294967297 WHERE sample = 1",
        "DELETE FROM sample WHERE sample = 1", "UPDATE state SET sample = sample + 8"}) {
    put_back();
    change(sql);
    EXPECT_TRUE(has(said_by([&] { check_campaign(out_); }), "damaged")) << sql;
  }
}

// Every column of every table in turn, by every kind of wrong value: an answer or a message.
TEST_F(ChangedStore, no_column_crashes_anything) {
  std::vector<std::pair<std::string, std::string>> columns;
  {
    Database database(store_path(out_), Database::Access::kRead);
    Statement all(database,
                  "SELECT t.name, c.name FROM sqlite_schema t, pragma_table_info(t.name) c WHERE "
                  "t.type = 'table'");
    while (all.step()) {
      std::string table = all.text();
      columns.emplace_back(std::move(table), all.text());
    }
  }
  EXPECT_GT(columns.size(), 100U);
  int changes = 0;
  std::set<std::string> messages;
  for (const auto& [held_by, column] : columns) {
    const std::string& table = held_by;
    std::vector<std::string> values = {"NULL",  "-1",     "9223372036854775807",
                                       "1e300", "'text'", "x'00ff'"};
    if (column == "data") {
      values.push_back("substr(data, 1, length(data) / 2)");
      values.push_back("(SELECT data FROM " + table + " o WHERE o.sample <> " + table + ".sample)");
    }
    for (const std::string& value : values) {
      put_back();
      if (change("UPDATE OR IGNORE " + table + " SET " + column + " = " + value) == 0) continue;
      if (table != "digest" && value != "'text'") renew_checksums();
      ++changes;
      SCOPED_TRACE(table + "." + column + " = " + value);
      messages.insert(said_by([&] { use(table); }));
      if (value == "'text'") messages.insert(said_by([&] { go_on(table); }));
    }
  }
  EXPECT_GT(changes, 300);
  EXPECT_GT(messages.size(), 30U);
}

}  // namespace
}  // namespace wythe::study::store_damage_test
