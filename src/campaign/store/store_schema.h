// The tables of the store as SQL, made from the lists of record_rows.h.
#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "wythe/parts/study.h"

namespace wythe::study {

inline constexpr std::int64_t kApplication = 0x77797468;  // "wyth", PRAGMA application_id

[[nodiscard]] std::string schema_sql();
// The declaration of each table as SQLite keeps it, by its name.
[[nodiscard]] const std::map<std::string, std::string>& declared_tables();
// Tables with the results of samples.
[[nodiscard]] std::vector<std::string> result_tables();
// The view `samples`: inputs and responses in the units of samples.csv, one row a sample.
[[nodiscard]] std::string samples_view_sql(const SampleTable& samples);
[[nodiscard]] std::string insert_sql(const std::string& table, int columns);

// Collects the names of the members in a list of record_rows.h.
struct ColumnNames {
  std::vector<std::pair<std::string, const char*>> columns;
  void operator()(const char* name, const double&) { columns.emplace_back(name, "REAL"); }
  void operator()(const char* name, const bool&) { columns.emplace_back(name, "INTEGER"); }
  void operator()(const char* name, const std::int64_t&) { columns.emplace_back(name, "INTEGER"); }
  void operator()(const char* name, const std::string&) { columns.emplace_back(name, "TEXT"); }
  void operator()(const char* name, const Message&) {  // in English, and as data
    columns.emplace_back(name, "TEXT");
    columns.emplace_back(name + std::string("_message"), "TEXT");
  }
};

// The columns of `sample` after its number, in the order of record_rows.h.
[[nodiscard]] ColumnNames record_columns();

}  // namespace wythe::study
