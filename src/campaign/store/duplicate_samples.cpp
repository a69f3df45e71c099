// Walks the rows of both stores side by side, table by table and in order of position, to the first value that differs.
// Only wall_seconds, provenance and the table of checksums are left out. Packed arrays whose bytes differ are unpacked
// and compared by their content.
#include "campaign/store/duplicate_samples.h"

#include <fmt/format.h>

#include "campaign/store/packing.h"
#include "campaign/store/store_schema.h"

namespace wythe::study {
namespace {

// The columns of a table that must be equal.
std::string compared_columns(Database& database, const std::string& table) {
  Statement columns(database, fmt::format("SELECT name FROM pragma_table_info('{}')", table));
  std::string list;
  while (columns.step())
    if (const std::string name = columns.text();
        table != "sample" || (name != "wall_seconds" && name != "provenance"))
      list += (list.empty() ? "" : ", ") + name;
  return list;
}

bool is_packed_the_same(Statement& here, Statement& there, int column, const std::string& what) {
  const std::string_view a = here.packed_at(column), b = there.packed_at(column);
  return !a.empty() && !b.empty() && packed_content(a, what) == packed_content(b, what);
}

}  // namespace

SampleRows::SampleRows(const std::string& folder)
    : store_(folder, Store::Access::kRead),
      run_(store_.database(),
           "SELECT status, state_hash, provenance FROM sample WHERE sample = ?") {
  Database& database = store_.database();
  for (const std::string& table : result_tables()) {
    if (table == "digest") continue;
    const bool is_list = table != "sample" && table != "curve";
    tables_.push_back(
        {table, Statement(database, fmt::format("SELECT {} FROM {} WHERE sample = ?{}",
                                                compared_columns(database, table), table,
                                                is_list ? " ORDER BY position" : ""))});
  }
}

SampleRows::Run SampleRows::run(int sample) {
  run_.reset();
  run_.bind(sample);
  if (!run_.step()) store_.database().damaged(fmt::format("sample {} is missing", sample));
  Run run;
  run.status = run_.text();
  run.state_hash = run_.text();
  run.provenance = run_.text();
  return run;
}

std::optional<std::string> SampleRows::difference(SampleRows& here, SampleRows& there, int sample) {
  const std::string what =
      fmt::format("{}: an array of sample {}", here.store_.database().name(), sample);
  for (std::size_t t = 0; t < here.tables_.size(); ++t) {
    auto& [table, rows] = here.tables_[t];
    Statement& others = there.tables_[t].second;
    rows.reset(), others.reset();
    rows.bind(sample), others.bind(sample);
    for (int row = 0;; ++row) {
      const bool is_one = rows.step(), is_other = others.step();
      if (is_one != is_other)
        return fmt::format("table {} has {} row {} here", table, is_one ? "also a" : "no", row);
      if (!is_one) break;
      for (int column = 0; column < rows.columns(); ++column)
        if (!rows.equals(others, column) && !is_packed_the_same(rows, others, column, what))
          return fmt::format("table {}, {} (row {}): {} here, {} there", table, rows.column(column),
                             row, rows.shown(column), others.shown(column));
    }
  }
  return std::nullopt;
}

}  // namespace wythe::study
