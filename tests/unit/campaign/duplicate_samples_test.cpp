// A sample that two stores contain is merged if it is equal to the bit in every table, and refused with its name if not.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>
#include <utility>
#include <vector>

#include "campaign/store/packing.h"
#include "campaign/store/store_schema.h"
#include "scenes/changed_store.h"
#include "scenes/places.h"
#include "scenes/small_study.h"
#include "wythe/parts/error.h"
#include "wythe/parts/io.h"

namespace wythe::study::duplicate_samples_test {
namespace {

namespace fs = std::filesystem;
using scenes::TemporaryFolder;

bool has(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

std::string bytes_of(const std::string& folder) {
  std::ifstream file(store_path(folder), std::ios::binary);
  return {std::istreambuf_iterator<char>(file), {}};
}

std::size_t curve_columns_in(Database& database) {
  Statement select(database, "SELECT columns FROM curve WHERE sample = 2");
  if (!select.step()) return 0;
  const std::string names = select.text();
  return static_cast<std::size_t>(std::count(names.begin(), names.end(), ',')) + 1;
}

class Doubles : public testing::Test {
 protected:
  void SetUp() override {
    const StudySpec study = scenes::small_study(2);
    run_campaign(study, model_builder(study), a_, {.jobs = 1});
    Database database(store_path(a_), Database::Access::kWrite);
    // tables that a wall of this kind leaves empty, so that each has a row
    for (const char* sql :
         {"INSERT INTO rise VALUES (2, 0, 0.001, 5)",
          "INSERT INTO shake (sample, position, intensity, status) VALUES (2, 0, 1.5, 'unstable')",
          "INSERT INTO moved VALUES (2, 0, 0.001, 1, 1, 1, NULL)",
          "INSERT INTO pier_drift VALUES (2, 0, 'left pier', 'P1', 0.001, 0.01, 5)"})
      database.execute(std::string("DELETE FROM ") +
                       std::string(sql).substr(12, std::string(sql).find(' ', 12) - 12) +
                       " WHERE sample = 2; " + sql);
  }
  void copy() {
    fs::remove_all(b_);
    fs::create_directories(b_);
    fs::copy_file(store_path(a_), store_path(b_));
  }
  std::string merged() {
    fs::remove_all(m_);
    try {
      merge_campaigns({a_, b_}, m_);
    } catch (const InputError& error) {
      return error.what();
    } catch (const IoError& error) {
      return std::string("damaged? ") + error.what();
    }
    return "";
  }
  TemporaryFolder folder_;
  std::string a_ = folder_ / "a", b_ = folder_ / "b", m_ = folder_ / "m";
};

TEST_F(Doubles, a_changed_value_in_any_table_is_refused_by_its_column) {
  scenes::renew_checksums(a_);
  copy();
  ASSERT_EQ(merged(), "");
  int tables = 0;
  for (const std::string& table : result_tables()) {
    if (table == "digest") continue;
    copy();
    const std::string column = table == "sample"                          ? "steps"
                               : table == "curve"                         ? "data"
                               : table == "state"                         ? "data"
                               : table == "score"                         ? "score"
                               : table == "element"                       ? "state"
                               : table == "reading"                       ? "factor"
                               : table == "feature"                       ? "value_m"
                               : table == "event"                         ? "reaction_N"
                               : table == "rise"                          ? "force_N"
                               : table == "moved"                         ? "first_kg_m"
                               : table == "shake"                         ? "intensity"
                               : table == "fall" || table == "pier_drift" ? "drift"
                                                                          : "value";
    {
      Database database(store_path(b_), Database::Access::kWrite);
      if (column == "data") {
        Statement select(database, "SELECT " + std::string(table == "curve" ? "rows" : "blocks") +
                                       ", data FROM " + table + " WHERE sample = 2");
        ASSERT_TRUE(select.step()) << table;
        const auto rows = static_cast<std::size_t>(select.integer());
        const std::string bytes(select.bytes());
        std::string changed;
        if (table == "curve") {
          const std::size_t columns = curve_columns_in(database);
          std::vector<double> numbers = unpack_doubles(bytes, rows * columns, "curve");
          numbers.back() = std::nextafter(numbers.back(), 1e9);
          changed = pack_doubles(numbers);
        } else {
          const std::size_t count = packed_content(bytes, "state").bytes / sizeof(float);
          std::vector<double> numbers = unpack_floats(bytes, count, "state");
          numbers[0] += 1e-3;
          changed = pack_floats(numbers);
        }
        Statement(database, "UPDATE " + table + " SET data = ? WHERE sample = 2" +
                                (table == "state" ? " AND position = 0" : ""))
            .run(Bytes{changed});
      } else if (column == "state") {
        database.execute("UPDATE element SET state = state || 'x' WHERE sample = 2");
      } else {
        database.execute("UPDATE " + table + " SET " + column + " = " + column +
                         " * 2 + 1 WHERE sample = 2");
      }
      ASSERT_GT(database.integer("SELECT changes()"), 0) << table;
    }
    scenes::renew_checksums(b_);
    const std::string before = bytes_of(a_), other = bytes_of(b_), said = merged();
    EXPECT_TRUE(has(said, "sample 2") && has(said, "table " + table + ", " + column + " (row 0): "))
        << table << ": " << said;
    EXPECT_TRUE(has(said, "by ") && has(said, "in " + a_)) << said;  // both who ran it
    EXPECT_FALSE(fs::exists(m_)) << table;
    EXPECT_TRUE(bytes_of(a_) == before && bytes_of(b_) == other) << table;
    ++tables;
  }
  EXPECT_EQ(tables, 16);
}

TEST_F(Doubles, a_row_more_or_less_is_refused) {
  scenes::renew_checksums(a_);
  copy();
  Database(store_path(b_), Database::Access::kWrite).execute("DELETE FROM rise");
  scenes::renew_checksums(b_);
  EXPECT_TRUE(has(merged(), "table rise has no row 0 here")) << merged();
  EXPECT_FALSE(fs::exists(m_));
}

// Machines differ in speed and programs in name; neither is a result.
TEST_F(Doubles, time_and_program_may_differ) {
  scenes::renew_checksums(a_);
  copy();
  Database(store_path(b_), Database::Access::kWrite)
      .execute("UPDATE sample SET wall_seconds = 99, provenance = 'another machine'");
  scenes::renew_checksums(b_);
  EXPECT_EQ(merged(), "");
}

}  // namespace
}  // namespace wythe::study::duplicate_samples_test
