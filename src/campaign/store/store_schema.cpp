// Tables of results are made from record_rows.h, so each member listed there has its column.
// Each list of a record is a table with key (sample, position). The view `samples` has the
// titles and units of samples.csv. It ends with the sample that met the campaign's stop rule.
#include "campaign/store/store_schema.h"

#include <fmt/format.h>

#include <string_view>
#include <type_traits>

#include "campaign/store/record_rows.h"

namespace wythe::study {
namespace {

// Every list of a record is a table of its own: sample, position, then its columns.
struct ListTables {
  std::string sql;
  template <class Member, class Columns>
  void list(const char* table, std::vector<Member> RecordLists::*, const Columns& columns) {
    ColumnNames names;
    Member member{};
    columns(names, member);
    sql +=
        fmt::format("CREATE TABLE {} (sample INTEGER NOT NULL, position INTEGER NOT NULL", table);
    for (const auto& [name, type] : names.columns) sql += fmt::format(", {} {}", name, type);
    sql += ", PRIMARY KEY (sample, position)) WITHOUT ROWID;\n";
  }
};

struct ListNames {
  std::vector<std::string> names;
  template <class Member, class Columns>
  void list(const char* table, std::vector<Member> RecordLists::*, const Columns&) {
    names.emplace_back(table);
  }
};

std::string quoted(const std::string& name) {
  std::string out = "\"";
  for (const char c : name) out += c == '"' ? "\"\"" : std::string(1, c);
  return out + "\"";
}

}  // namespace

std::vector<std::string> result_tables() {
  ListNames tables{{"sample", "curve", "state", "digest"}};
  each_list(tables);
  return tables.names;
}

std::string schema_sql() {
  std::string sql =
      "CREATE TABLE study (position INTEGER PRIMARY KEY, key TEXT NOT NULL UNIQUE, value TEXT);\n"
      "CREATE TABLE input (position INTEGER PRIMARY KEY, name TEXT NOT NULL, path TEXT, si_unit "
      "TEXT,"
      " unit TEXT, to_unit REAL, shift REAL, is_random INTEGER, cut_off REAL);\n"
      "CREATE TABLE sample_input (sample INTEGER NOT NULL, position INTEGER NOT NULL, value REAL,"
      " PRIMARY KEY (sample, position)) WITHOUT ROWID;\n"
      "CREATE TABLE curve (sample INTEGER PRIMARY KEY, rows INTEGER NOT NULL, data BLOB NOT NULL,"
      " columns TEXT NOT NULL);\n"
      "CREATE TABLE state (sample INTEGER NOT NULL, position INTEGER NOT NULL, label TEXT,"
      " displacement_m REAL, reaction_N REAL, blocks INTEGER, points INTEGER, data BLOB NOT NULL,"
      " asked_m REAL,"
      " PRIMARY KEY (sample, position));\n"
      "CREATE TABLE digest (sample INTEGER PRIMARY KEY, record INTEGER NOT NULL, states INTEGER "
      "NOT "
      "NULL);\n"
      "CREATE TABLE sample (sample INTEGER PRIMARY KEY";
  for (const auto& [name, type] : record_columns().columns)
    sql += fmt::format(", {} {}", name, type);
  sql += ");\n";
  ListTables tables;
  each_list(tables);
  return sql + tables.sql;
}

const std::map<std::string, std::string>& declared_tables() {
  static const std::map<std::string, std::string> kTables = [] {
    constexpr std::string_view kBegin = "CREATE TABLE ";
    std::map<std::string, std::string> tables;
    const std::string sql = schema_sql();
    for (std::size_t at = 0, end = 0; (end = sql.find(";\n", at)) != std::string::npos;
         at = end + 2) {
      const std::string one = sql.substr(at, end - at);
      tables[one.substr(kBegin.size(), one.find(' ', kBegin.size()) - kBegin.size())] = one;
    }
    return tables;
  }();
  return kTables;
}

std::string samples_view_sql(const SampleTable& samples) {
  std::string sql = "DROP VIEW IF EXISTS samples;\nCREATE VIEW samples AS SELECT sample";
  for (std::size_t i = 0; i < samples.column.size(); ++i) {
    const InputColumn& column = samples.column[i];
    sql += fmt::format(
        ",\n (SELECT i.value * {:.17g} + {:.17g} FROM sample_input i WHERE i.sample = s.sample AND "
        "i.position = {}) AS {}",
        column.to_unit, column.offset, i, quoted(column_title(column)));
  }
  std::string listed = ",\n status";
  const auto add = [&](const OutputKey& key, const auto& value) {
    if (key.listed == OutputKey::kNowhere) return;
    if constexpr (std::is_same_v<decltype(value), const double&>)
      listed += fmt::format(", {} * {:g} AS {}", key.stored, key.to_unit, key.column);
    else
      listed += fmt::format(", {} AS {}", key.stored, key.column);
    if (std::string_view(key.stored) == "displacement_max_m") listed += ", failure_mode";
  };
  const SampleRecord any;
  each_response(add, any.responses);
  each_quasi_static(add, any.quasi_static);
  sql += listed +
         ", reason\n"
         "FROM sample s WHERE sample <= coalesce((SELECT CAST(value AS INTEGER) FROM study"
         " WHERE key = 'until_met_at' AND value <> ''), 1000000000);\n";
  return sql;
}

ColumnNames record_columns() {
  ColumnNames names;
  SampleRecord record;
  each_column(names, record);
  each_output(names, record);
  return names;
}

std::string insert_sql(const std::string& table, int columns) {
  std::string places = "?";
  for (int i = 1; i < columns; ++i) places += ",?";
  return fmt::format("INSERT INTO {} VALUES ({})", table, places);
}

}  // namespace wythe::study
