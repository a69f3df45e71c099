#include "study/store.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>
#include <limits>
#include <map>
#include <utility>

#include "study/packing.h"
#include "study/record_rows.h"
#include "study/store_schema.h"
#include "wythe/error.h"

namespace wythe::study {
namespace {

namespace fs = std::filesystem;

constexpr std::int64_t kApplication = 0x77797468;  // "wyth", PRAGMA application_id

// Version 1 named a reading in words only, "at 20.03 mm" or "crack width x 0.75". The state is the stored
// one at that displacement, the peak, or the end.
constexpr const char* kReadingsOfVersion1 = R"(
PRAGMA query_only = 0;  -- a view of this connection's own, the file stays as it is
CREATE TEMP VIEW reading AS
SELECT sample, position, what, failure_mode,
       CASE WHEN mm IS NULL THEN '' ELSE coalesce(
         (SELECT label FROM state WHERE state.sample = r.sample AND abs(1e3 * displacement_m - mm) < 0.006),
         CASE WHEN abs(1e3 * peak_m - mm) < 0.006 THEN 'peak' ELSE 'end' END) END AS state,
       coalesce(mm / 1e3, read_m) AS displacement_m,
       CASE WHEN mm IS NULL THEN substr(what, 1, instr(what, ' x ') - 1) ELSE '' END AS threshold,
       CASE WHEN mm IS NULL THEN CAST(substr(what, instr(what, ' x ') + 3) AS REAL) ELSE 1.0 END AS factor
FROM (SELECT old.*, displacement_at_peak_m AS peak_m, failure_read_at_m AS read_m,
             CASE WHEN what LIKE 'at % mm' THEN CAST(substr(what, 4) AS REAL) END AS mm
      FROM main.reading AS old JOIN main.sample USING (sample)) AS r;
PRAGMA query_only = 1)";

// Binds the members of a record in order.
struct Binder {
  Statement& statement;
  bool nothing = false;  // NULL for each
  template <class Member>
  void operator()(const char*, const Member& member) {
    if (nothing)
      statement.bind_null();
    else
      statement.bind(member);
  }
};

// Takes the columns of a row in order.
struct Taker {
  Statement& statement;
  void operator()(const char*, double& member) { member = statement.number(); }
  void operator()(const char*, bool& member) { member = statement.integer() != 0; }
  void operator()(const char*, std::int64_t& member) { member = statement.integer(); }
  void operator()(const char*, std::string& member) { member = statement.text(); }
};

struct ListWriter {
  Database& database;
  int sample;
  const RecordLists& lists;
  template <class Member, class Columns>
  void list(const char* table, std::vector<Member> RecordLists::*which, const Columns& columns) {
    const std::vector<Member>& members = lists.*which;
    if (members.empty()) return;
    ColumnNames names;
    columns(names, members.front());
    Statement insert(database, insert_sql(table, 2 + static_cast<int>(names.columns.size())));
    for (std::size_t i = 0; i < members.size(); ++i) {
      insert.bind(sample);
      insert.bind(i);
      Binder binder{insert};
      columns(binder, members[i]);
      insert.run();
    }
  }
};

// Reads one list of all samples.
struct ListReader {
  Database& database;
  std::map<int, RecordLists>& lists;
  int last;
  template <class Member, class Columns>
  void list(const char* table, std::vector<Member> RecordLists::*members, const Columns& columns) {
    Statement select(
        database,
        fmt::format("SELECT * FROM {} WHERE sample <= {} ORDER BY sample, position", table, last));
    while (select.step()) {
      const int sample = static_cast<int>(select.integer());
      static_cast<void>(select.integer());
      Taker taker{select};
      columns(taker, (lists[sample].*members).emplace_back());
    }
  }
};

std::map<int, std::vector<double>> read_inputs(Database& database) {
  std::map<int, std::vector<double>> inputs;
  Statement select(database, "SELECT sample, value FROM sample_input ORDER BY sample, position");
  while (select.step()) {
    const int sample = static_cast<int>(select.integer());
    inputs[sample].push_back(select.number());
  }
  return inputs;
}

void read_curves(Database& database, int last, std::map<int, std::vector<CurveRow>>& curves) {
  Statement select(database,
                   fmt::format("SELECT sample, rows, data FROM curve WHERE sample <= {}", last));
  while (select.step()) {
    const int sample = static_cast<int>(select.integer());
    const auto rows = static_cast<std::size_t>(select.integer());
    curves[sample] = curve_rows(
        unpack_doubles(select.bytes(), rows * kCurveColumns,
                       fmt::format("{}: the curve of sample {}", database.name(), sample)));
  }
}

void write_study_rows(Database& database, const Rows& rows) {
  Statement insert(database,
                   "INSERT INTO study (key, value) VALUES (?, ?) ON CONFLICT (key) DO UPDATE SET "
                   "value = excluded.value");
  for (const auto& [key, value] : rows) insert.run(key, value);
}

void write_inputs(Database& database, const SampleTable& samples, int first) {
  Statement insert(database, insert_sql("sample_input", 3));
  for (int s = first; s <= samples.n_sample(); ++s) {
    const std::vector<double>& values = samples.value[static_cast<std::size_t>(s - 1)];
    for (std::size_t i = 0; i < values.size(); ++i) insert.run(s, i, values[i]);
  }
}

void write_columns(Database& database, const SampleTable& samples) {
  Statement insert(database, insert_sql("input", 9));
  std::size_t variable = 0;
  for (std::size_t i = 0; i < samples.column.size(); ++i) {
    const InputColumn& c = samples.column[i];
    const double cut_off = c.is_random && variable < samples.cut_off.size()
                               ? samples.cut_off[variable++]
                               : std::numeric_limits<double>::quiet_NaN();
    insert.run(i, c.name, c.path, c.si_unit, c.unit, c.to_unit, c.offset, c.is_random, cut_off);
  }
}

// File names alone: a store is passed on, its study needs no other file.
StudySpec without_folders(StudySpec spec) {
  for (std::string* file : {&spec.file, &spec.model_file})
    *file = fs::path(*file).filename().string();
  return spec;
}

}  // namespace

fs::path store_path(const std::string& folder) { return fs::path(folder) / kStoreName; }

bool holds_store(const std::string& folder) {
  const fs::path path = store_path(folder);
  std::error_code error;
  if (!fs::exists(path, error) || fs::file_size(path, error) == 0) return false;
  Database database(path, Database::Access::kRead);
  return database.integer("SELECT count(*) FROM sqlite_schema") > 0;
}

PackedSample packed(SampleRecord record, const std::vector<Snapshot>& states) {
  PackedSample out;
  for (const Snapshot& s : states)
    out.states.push_back({s.label, pack_floats(state_arrays(s.state)), s.displacement, s.reaction,
                          s.state.ux.size(), s.state.kappa.size()});
  if (record.has_curve()) out.curve = pack_doubles(curve_columns(record.curve));
  out.record = std::move(record);
  return out;
}

Store::Store(const std::string& folder, Access access) : database_(store_path(folder), access) {
  check_version(access);
  if (access == Access::kWrite) database_.execute("PRAGMA synchronous = NORMAL");
}

void Store::check_version(Access access) {
  const std::string& name = database_.name();
  const std::int64_t application = database_.integer("PRAGMA application_id");
  version_ = database_.integer("PRAGMA user_version");
  if (application != kApplication)
    throw IoError(name + ": is an SQLite file, but not a campaign of wythe; name another folder");
  if (version_ > kSchemaVersion)
    throw IoError(
        fmt::format("{}: was written by a newer wythe (store version {}, this one reads up "
                    "to {}); use that version or a later one",
                    name, version_, kSchemaVersion));
  if (is_current()) return;
  if (access == Access::kWrite)
    throw IoError(
        fmt::format("{}: was written by an older wythe (store version {}, now {}); it can be read, "
                    "reported and replayed; to add samples begin a campaign in another folder",
                    name, version_, kSchemaVersion));
  database_.execute(kReadingsOfVersion1);
}

void create_store(const std::string& folder, const StudySpec& spec, const SampleTable& samples,
                  const StoreHead& head) {
  std::error_code error;
  fs::create_directories(folder, error);
  if (error) throw IoError(folder + ": cannot be made: " + error.message());
  Database database(store_path(folder), Database::Access::kWrite);
  database.execute("PRAGMA journal_mode = WAL; PRAGMA synchronous = NORMAL");
  Transaction transaction(database);
  database.execute(schema_sql());
  database.execute(samples_view_sql(samples));
  Rows rows = rows_of(without_folders(spec));
  rows.insert(rows.begin(), {{"schema_version", std::to_string(kSchemaVersion)},
                             {"provenance", head.provenance},
                             {"shard", head.shard},
                             {"load_height_m", fmt::format("{}", head.load_height)},
                             {"until_met_at", ""}});
  write_study_rows(database, rows);
  write_columns(database, samples);
  write_inputs(database, samples, 1);
  database.execute(fmt::format("PRAGMA application_id = {}; PRAGMA user_version = {}", kApplication,
                               kSchemaVersion));
  transaction.commit();
}

std::string Store::value(const std::string& key) {
  Statement select(database_, "SELECT value FROM study WHERE key = ?");
  select.bind(key);
  return select.step() ? select.text() : "";
}

void Store::set_value(const std::string& key, const std::string& value) {
  write_study_rows(database_, {{key, value}});
}

StudySpec Store::study() {
  Rows rows;
  Statement select(database_, "SELECT key, value FROM study ORDER BY position");
  while (select.step()) {
    std::string key = select.text();
    rows.emplace_back(std::move(key), select.text());
  }
  return study_of(rows);
}

StoreHead Store::head() {
  return {value("shard"), value("provenance"),
          std::strtod(value("load_height_m").c_str(), nullptr)};
}

SampleTable Store::samples() {
  SampleTable table;
  Statement select(
      database_,
      "SELECT name, path, si_unit, unit, to_unit, shift, is_random, cut_off FROM input "
      "ORDER BY position");
  while (select.step()) {
    InputColumn& c = table.column.emplace_back();
    c.name = select.text();
    c.path = select.text();
    c.si_unit = select.text();
    c.unit = select.text();
    c.to_unit = select.number();
    c.offset = select.number();
    c.is_random = select.integer() != 0;
    if (c.is_random) table.cut_off.push_back(select.number());
  }
  for (auto& [sample, values] : read_inputs(database_)) table.value.push_back(std::move(values));
  return table;
}

std::set<int> Store::done() {
  std::set<int> numbers;
  Statement select(database_, "SELECT sample FROM sample");
  while (select.step()) numbers.insert(static_cast<int>(select.integer()));
  return numbers;
}

void Store::write(const PackedSample& sample) {
  const SampleRecord& r = sample.record;
  Transaction transaction(database_);
  // one column for the number, the others from the list
  ColumnNames names;
  each_column(names, r);
  each_answer(names, r);
  Statement insert(database_, insert_sql("sample", 1 + static_cast<int>(names.columns.size())));
  insert.bind(r.sample);
  Binder binder{insert};
  each_column(binder, r);
  binder.nothing = !r.answered();
  each_answer(binder, r);
  insert.run();
  if (r.answered()) {
    const RecordLists lists = lists_of(r);
    ListWriter writer{database_, r.sample, lists};
    each_list(writer);
  }
  if (!sample.curve.empty())
    Statement(database_, insert_sql("curve", 3)).run(r.sample, r.curve.size(), Bytes{sample.curve});
  Statement insert_state(database_, insert_sql("state", 8));
  for (std::size_t i = 0; i < sample.states.size(); ++i) {
    const PackedState& s = sample.states[i];
    insert_state.run(r.sample, i, s.label, s.displacement, s.reaction, s.blocks, s.points,
                     Bytes{s.bytes});
  }
  transaction.commit();
}

void Store::add_samples(const SampleTable& samples, int first, const StudySpec& spec) {
  Transaction transaction(database_);
  write_inputs(database_, samples, first);
  write_study_rows(database_, {{"samples", value_of(rows_of(spec), "samples")}});
  transaction.commit();
}

void Store::check_whole() {
  Statement check(database_, "PRAGMA quick_check(1)");
  const std::string verdict = check.step() ? check.text() : "";
  if (verdict != "ok")
    throw IoError(
        fmt::format("{}: is damaged ({}); restore it from a copy, save what can be read with "
                    "sqlite3 FILE \".recover\", or begin the campaign in another folder",
                    database_.name(), verdict));
}

std::vector<Snapshot> Store::states(int sample) {
  std::vector<Snapshot> states;
  Statement select(
      database_,
      "SELECT label, displacement_m, reaction_N, blocks, points, data FROM state WHERE "
      "sample = ? ORDER BY position");
  select.bind(sample);
  while (select.step()) {
    Snapshot& s = states.emplace_back();
    s.label = select.text();
    s.displacement = select.number();
    s.reaction = select.number();
    const auto blocks = static_cast<std::size_t>(select.integer());
    const auto points = static_cast<std::size_t>(select.integer());
    const std::string_view packed = select.bytes();
    const std::size_t least = kBlockArrays * blocks + kPointArrays * points;
    const std::size_t more = std::max(least, packed_floats(packed)) - least;
    const std::vector<double> arrays =
        unpack_floats(packed, least + more / kNodeArrays * kNodeArrays,
                      fmt::format("{}: state {} of sample {}", database_.name(), s.label, sample));
    s.state = state_at_rest(arrays, blocks, points);
  }
  return states;
}

int last_counted(Store& store) {
  const std::string met = store.value("until_met_at");
  return met.empty() ? std::numeric_limits<int>::max() : std::atoi(met.c_str());
}

std::vector<SampleRecord> Store::records(int last) {
  std::map<int, std::vector<double>> inputs = read_inputs(database_);
  std::map<int, std::vector<CurveRow>> curves;
  read_curves(database_, last, curves);
  std::map<int, RecordLists> lists;
  ListReader reader{database_, lists, last};
  each_list(reader);
  std::vector<SampleRecord> records;
  Statement select(database_,
                   fmt::format("SELECT sample, {} FROM sample WHERE sample <= {} ORDER BY "
                               "sample",
                               sample_columns(), last));
  while (select.step()) {
    SampleRecord& record = records.emplace_back();
    record.sample = static_cast<int>(select.integer());
    Taker taker{select};
    each_column(taker, record);
    if (record.answered()) each_answer(taker, record);
    record.inputs = std::move(inputs[record.sample]);
    record.curve = std::move(curves[record.sample]);
    put_lists(std::move(lists[record.sample]), record);
  }
  return records;
}

}  // namespace wythe::study
