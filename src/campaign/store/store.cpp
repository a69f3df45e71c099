// Each write is one transaction: a new study with its samples, one sample, added samples, or one value.
// Reading checks everything: digests, order and ranges; any mismatch is reported as damage. Binder and
// Taker visit the same lists of record_rows.h, so writing and reading use the same order of columns.
#include "campaign/store/store.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <utility>

#include "campaign/draws/study_check.h"
#include "campaign/store/packing.h"
#include "campaign/store/record_rows.h"
#include "campaign/store/store_schema.h"
#include "core/limits.h"
#include "core/messages.h"
#include "core/number.h"
#include "model/size.h"
#include "wythe/parts/error.h"

namespace wythe::study {
namespace {

namespace fs = std::filesystem;

// Used as first sample: stands for all samples.
constexpr int kWhole = std::numeric_limits<int>::min();

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
  void operator()(const char* name, const Message& message) {
    (*this)(name, text_of(message));
    (*this)(name, message_json(message));
  }
};

// Takes the columns of a row in order.
struct Taker {
  Statement& statement;
  bool bounded = false;  // results may not be infinite
  void operator()(const char* name, double& member) {
    static const std::set<std::string> kRatios = {"unbalance_ratio_mean",
                                                  "unbalance_ratio_max",
                                                  "kinetic_ratio_mean",
                                                  "kinetic_ratio_max",
                                                  "shear_gap",
                                                  "damping_share",
                                                  "rate_lift",
                                                  "force_beyond_peak",
                                                  "energy_gap_ratio"};  // over what may be 0
    member = statement.number();
    if (bounded && std::isinf(member) && !kRatios.contains(name))
      statement.damaged(std::string(name) + " is infinite");
  }
  void operator()(const char*, bool& member) { member = statement.integer() != 0; }
  void operator()(const char*, std::int64_t& member) { member = statement.integer(); }
  void operator()(const char*, std::string& member) { member = statement.text(); }
  void operator()(const char*, Message& member) {
    const std::string text = statement.text();
    member = message_of(statement.text(), text);
  }
};

template <class Prepared>
struct ListWriter {
  const Prepared& prepared;
  int sample;
  const RecordLists& lists;
  template <class Member, class Columns>
  void list(const char* table, std::vector<Member> RecordLists::*which, const Columns& columns) {
    const std::vector<Member>& members = lists.*which;
    if (members.empty()) return;
    ColumnNames names;
    columns(names, members.front());
    Statement& insert = prepared(insert_sql(table, 2 + static_cast<int>(names.columns.size())));
    for (std::size_t i = 0; i < members.size(); ++i) {
      insert.bind(sample);
      insert.bind(i);
      Binder binder{insert};
      columns(binder, members[i]);
      insert.run();
    }
  }
};

// The columns exist, because a store with other tables was refused before.
std::string list_of(const ColumnNames& names) {
  std::string list;
  for (const auto& [name, type] : names.columns) list += ", " + name;
  return list;
}

// Reads one list of the samples in `where`.
struct ListReader {
  Database& database;
  std::map<int, RecordLists>& lists;
  int samples;
  std::string where;
  template <class Member, class Columns>
  void list(const char* table, std::vector<Member> RecordLists::*members, const Columns& columns) {
    ColumnNames names;
    Member any{};
    columns(names, any);
    Statement select(database, fmt::format("SELECT sample, position{} FROM {} {} ORDER BY 1, 2",
                                           list_of(names), table, where));
    static const std::set<std::string> kMeasures = {"score", "evidence", "flag", "sign", "reading"};
    const bool bounded = !kMeasures.contains(table);
    while (select.step()) {
      const auto sample = static_cast<int>(select.integer(1, samples));
      const auto position = static_cast<std::int64_t>((lists[sample].*members).size());
      static_cast<void>(select.integer(position, position));
      Taker taker{select, bounded};
      columns(taker, (lists[sample].*members).emplace_back());
    }
  }
};

// Every sample has a value in each column. NULL stands for a formula without a finite result.
std::vector<std::vector<double>> load_inputs(Database& database, std::size_t columns) {
  std::vector<std::vector<double>> inputs;
  Statement select(database,
                   "SELECT sample, position, value FROM sample_input ORDER BY sample, position");
  while (select.step()) {
    const std::size_t sample =
        inputs.empty() ? 1 : inputs.size() + (inputs.back().size() == columns);
    const std::size_t at = inputs.size() == sample ? inputs.back().size() : 0;
    const auto is = [&](std::int64_t found, std::size_t due) {
      return found == static_cast<std::int64_t>(due);
    };
    if (!is(select.integer(), sample) || !is(select.integer(), at))
      select.damaged(fmt::format("input {} of sample {} is missing", at, sample));
    if (at == 0) inputs.emplace_back();
    inputs.back().push_back(select.number());
  }
  if (!inputs.empty() && inputs.back().size() != columns)
    database.damaged(fmt::format("table sample_input: sample {} has {} of {} inputs", inputs.size(),
                                 inputs.back().size(), columns));
  return inputs;
}

std::vector<std::string> parts_of(const std::string& list) {
  std::vector<std::string> parts(1);
  for (const char c : list)
    if (c == ',')
      parts.emplace_back();
    else
      parts.back() += c;
  return parts;
}

std::map<int, std::vector<CurveRow>> load_curves(Database& database, int samples,
                                                 const std::string& where) {
  std::map<int, std::vector<CurveRow>> curves;
  Statement select(database, "SELECT sample, rows, columns, data FROM curve " + where);
  while (select.step()) {
    const auto sample = static_cast<int>(select.integer(1, samples));
    const std::size_t rows = select.integer(1, kMostRows);
    const std::vector<std::string> names = parts_of(select.text());
    database.take(static_cast<double>(rows * (names.size() * sizeof(double) + sizeof(CurveRow))));
    curves[sample] = curve_rows(
        unpack_doubles(select.bytes(), rows * names.size(),
                       fmt::format("{}: the curve of sample {}", database.name(), sample)),
        names);
  }
  return curves;
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
    const std::vector<double>& values = samples.value[s - 1];
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

// Only file names: a store may be moved, and its study needs no other file.
StudySpec without_folders(StudySpec spec) {
  for (std::string* file : {&spec.file, &spec.model_file})
    *file = fs::path(*file).filename().string();
  return spec;
}

}  // namespace

fs::path store_path(const std::string& folder) { return fs::path(folder) / kStoreName; }

bool holds_store(const std::string& folder) {
  std::error_code error;
  const fs::file_type type = fs::symlink_status(store_path(folder), error).type();
  return type != fs::file_type::not_found && error != std::errc::filename_too_long;
}

PackedSample packed(SampleRecord record, const std::vector<Snapshot>& states) {
  PackedSample out;
  for (const Snapshot& s : states)
    out.states.push_back({s.label, pack_floats(state_arrays(s.state)), s.displacement, s.reaction,
                          s.state.ux.size(), s.state.kappa.size(), s.asked});
  if (record.has_curve()) out.curve = pack_doubles(curve_columns(record.curve));
  out.record = std::move(record);
  return out;
}

Store::Store(const std::string& folder, Access access) : database_(store_path(folder), access) {
  check_version();
  if (access == Access::kWrite) database_.execute("PRAGMA synchronous = NORMAL");
}

namespace {

void fill_store(Database& database, const StudySpec& spec, const SampleTable& samples,
                const StoreHead& head) {
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
  write_study_digests(database);
  database.execute(fmt::format("PRAGMA application_id = {}; PRAGMA user_version = {}", kApplication,
                               kSchemaVersion));
  transaction.commit();
}

}  // namespace

void create_store(const std::string& folder, const StudySpec& spec, const SampleTable& samples,
                  const StoreHead& head) {
  std::error_code error;
  fs::create_directories(folder, error);
  if (error) throw IoError(folder + ": cannot be made: " + error.message());
  NewDatabase fresh(store_path(folder));
  try {
    fill_store(fresh.database(), spec, samples, head);
  } catch (const DiskError& refusal) {
    fresh.refuse(refusal.reason());
  }
  fresh.put_in_place();
}

std::string Store::value(const std::string& key) {
  Statement select(database_, "SELECT value FROM study WHERE key = ?");
  select.bind(key);
  return select.step() ? select.text() : "";
}

void Store::set_value(const std::string& key, const std::string& value) {
  Transaction transaction(database_);
  write_study_rows(database_, {{key, value}});
  write_study_digests(database_);
  transaction.commit();
}

double load_height_of(const Model& model) {
  double height = model.stages.back().load_height;
  for (const Stage& stage : model.stages)
    if (stage.spec.kind() == StageKind::kPush) height = stage.load_height;
  return height;
}

SampleDigests& Store::digests() {
  if (!digests_) digests_.emplace(database_);
  return *digests_;
}

Statement& Store::prepared(const std::string& sql) {
  const auto found = prepared_.find(sql);
  if (found == prepared_.end())
    return prepared_.emplace(sql, Statement(database_, sql)).first->second;
  found->second.reset();
  return found->second;
}

StudySpec Store::study() {
  const ReadTransaction moment(database_);
  check_study_digest(database_);
  Rows rows;
  Statement select(database_, "SELECT key, value FROM study ORDER BY position");
  std::set<std::string> keys;
  while (select.step()) {
    std::string key = select.text();
    if (!keys.insert(key).second)
      database_.damaged(fmt::format("table study: {} stands there twice", key));
    rows.emplace_back(std::move(key), select.text());
  }
  return study_in(rows);
}

StudySpec Store::study_in(const Rows& rows) {
  try {
    if (const std::string said = value_of(rows, "schema_version");
        said != std::to_string(kSchemaVersion))
      throw IoError(fmt::format("schema_version: \"{}\", and the file is of version {}", said,
                                kSchemaVersion));
    StudySpec spec = study_of(rows);
    if (const std::vector<Fault> faults = check_study(spec); !faults.empty())
      throw IoError(InputError(faults).what());
    return spec;
  } catch (const IoError& error) {
    database_.damaged(std::string("table study, ") + error.what());
  }
}

StoreHead Store::head() {
  const std::string height = value("load_height_m");
  const double metres = parse_number(height).value_or(kUnset);
  if (!(metres >= 0) || std::isinf(metres))
    database_.damaged(fmt::format("table study, load_height_m: \"{}\" is not a height", height));
  const std::string shard = value("shard");
  if (!shard_of(shard))
    database_.damaged(fmt::format("table study, shard: \"{}\" is none, such as 1/4", shard));
  return {shard, value("provenance"), metres};
}

int Store::number_of_sample(const std::string& key) {
  const std::string text = value(key);
  if (text.empty()) return 0;
  const int number = parse_number<int>(text).value_or(-1);
  if (number < 0)
    database_.damaged(fmt::format("table study, {}: \"{}\" is not a number of samples", key, text));
  return number;
}

SampleTable Store::columns() {
  SampleTable table;
  Statement select(
      database_,
      "SELECT position, name, path, si_unit, unit, to_unit, shift, is_random, cut_off FROM input "
      "ORDER BY position");
  while (select.step()) {
    const auto position = static_cast<std::int64_t>(table.column.size());
    static_cast<void>(select.integer(position, position));
    InputColumn& c = table.column.emplace_back();
    c.name = select.text();
    c.path = select.text();
    c.si_unit = select.text();
    c.unit = select.text();
    c.to_unit = select.finite();
    c.offset = select.finite();
    c.is_random = select.integer(0, 1) != 0;
    if (c.is_random) table.cut_off.push_back(select.number());
  }
  return table;
}

SampleTable Store::samples() {
  const ReadTransaction moment(database_);
  check_inputs_digest(database_);
  SampleTable table = columns();
  table.value = load_inputs(database_, table.column.size());
  const StudySpec spec = study();
  check_columns_of(spec, table);
  if (table.column.empty()) table.value.resize(count_samples(spec));
  if (const auto asked = count_samples(spec); asked != table.n_sample())
    database_.damaged(fmt::format("it holds the inputs of {} samples, its design has {}",
                                  table.n_sample(), asked));
  set_more(spec, table);
  return table;
}

std::set<int> Store::done() {
  std::set<int> numbers;
  // a study of records alone draws nothing
  std::int64_t drawn = database_.integer("SELECT coalesce(max(sample), 0) FROM sample_input");
  if (drawn == 0) drawn = count_samples(study());
  Statement select(database_, "SELECT sample FROM sample");
  while (select.step()) numbers.insert(static_cast<int>(select.integer(1, drawn)));
  return numbers;
}

void Store::write(const PackedSample& sample) {
  const SampleRecord& r = sample.record;
  Transaction transaction(database_);
  std::string columns = "sample", places = "?";
  for (const auto& [name, type] : record_columns().columns) columns += ", " + name, places += ",?";
  Statement& insert = prepared(fmt::format("INSERT INTO sample ({}) VALUES ({})", columns, places));
  insert.bind(r.sample);
  Binder binder{insert};
  each_column(binder, r);
  binder.nothing = !r.answered();
  each_output(binder, r);
  insert.run();
  const RecordLists lists = lists_of(r);
  const auto kept = [this](const std::string& sql) -> Statement& { return prepared(sql); };
  ListWriter<decltype(kept)> writer{kept, r.sample, lists};
  each_list(writer);
  if (!sample.curve.empty())
    prepared(insert_sql("curve", 4))
        .run(r.sample, r.curve.size(), Bytes{sample.curve}, curve_column_names());
  Statement& insert_state = prepared(insert_sql("state", 9));
  for (std::size_t i = 0; i < sample.states.size(); ++i) {
    const PackedState& s = sample.states[i];
    insert_state.run(r.sample, i, s.label, s.displacement, s.reaction, s.blocks, s.points,
                     Bytes{s.bytes}, s.asked);
  }
  digests().write(r.sample);
  transaction.commit();
}

void Store::add_samples(const SampleTable& samples, int first, const StudySpec& spec) {
  Transaction transaction(database_);
  write_inputs(database_, samples, first);
  write_study_rows(database_, {{"samples", value_of(rows_of(spec), "samples")}});
  write_study_digests(database_);
  transaction.commit();
}

namespace {
// The stage to which stored states belong: the last one with a curve. It decides which blocks stand.
int stage_of_states(const Model& model) {
  const auto has_curve = [](const Stage& stage) {
    const StageKind kind = stage.spec.kind();
    return kind == StageKind::kPush || kind == StageKind::kBodyForce || kind == StageKind::kTilt ||
           kind == StageKind::kShake;
  };
  for (int k = static_cast<int>(model.stages.size()) - 1; k > 0; --k)
    if (has_curve(model.stages[k])) return k;
  return 0;
}
}  // namespace

std::vector<Snapshot> Store::states(int sample, const Model& model) {
  const ReadTransaction moment(database_);
  digests().check_states(sample);
  std::vector<Snapshot> states;
  State rest = initial_state(model);
  rest.stage = stage_of_states(model);
  const std::size_t numbers = state_arrays(rest).size();
  const auto blocks = static_cast<std::int64_t>(rest.ux.size());
  const auto points = static_cast<std::int64_t>(rest.kappa.size());
  Statement select(
      database_,
      "SELECT sample, position, label, displacement_m, reaction_N, blocks, points, data, asked_m "
      "FROM state WHERE sample = ? ORDER BY position");
  select.bind(sample);
  while (select.step()) {
    const auto position = static_cast<std::int64_t>(states.size());
    Snapshot& s = states.emplace_back();
    static_cast<void>(select.integer());
    static_cast<void>(select.integer(position, position));
    s.label = select.text();
    s.displacement = select.finite();
    s.reaction = select.finite();
    static_cast<void>(select.integer(blocks, blocks));  // checks the number of blocks of its wall
    static_cast<void>(select.integer(points, points));
    database_.take(static_cast<double>(2 * numbers * sizeof(double)));
    const std::vector<double> arrays =
        unpack_floats(select.bytes(), numbers,
                      fmt::format("{}: state {} of sample {}", database_.name(), s.label, sample));
    s.asked = select.number();
    if (!std::all_of(arrays.begin(), arrays.end(), [](double x) { return std::isfinite(x); }))
      select.damaged(fmt::format("state {} holds what is not a number", s.label));
    s.state = state_at_rest(arrays, rest);
  }
  return states;
}

std::vector<SampleRecord> Store::records(int last) { return records(samples(), kWhole, last); }

std::vector<SampleRecord> Store::records(const SampleTable& table, int first, int last) {
  const ReadTransaction moment(database_);
  // for all samples the lists are checked too: a row without a sample is damage
  const bool whole = first == kWhole && last == std::numeric_limits<int>::max();
  const std::string where =
      first == kWhole ? "" : fmt::format("WHERE sample BETWEEN {} AND {}", first, last);
  std::map<int, std::vector<CurveRow>> curves = load_curves(database_, table.n_sample(), where);
  std::map<int, RecordLists> lists;
  ListReader reader{database_, lists, table.n_sample(), where};
  each_list(reader);
  std::vector<SampleRecord> records;
  Statement select(
      database_,
      fmt::format("SELECT sample{} FROM sample {} ORDER BY sample", list_of(record_columns()),
                  whole ? "" : fmt::format("WHERE sample BETWEEN {} AND {}", first, last)));
  while (select.step()) {
    SampleRecord& record = records.emplace_back();
    record.sample = static_cast<int>(select.integer(1, table.n_sample()));
    digests().check_record(record.sample);
    record.curve = std::move(curves[record.sample]);
    record.inputs = table.value[record.sample - 1];
    if (records.size() > 1 && record.sample <= records[records.size() - 2].sample)
      select.damaged("it stands there twice");
    Taker taker{select, true};
    each_column(taker, record);
    if (!is_outcome(record.status))
      select.damaged(fmt::format("no sample ends as \"{}\"", record.status));
    check_shakes(database_, record, lists[record.sample].shakes);
    if (!record.answered()) {  // then it has no other lists
      put_lists(std::move(lists[record.sample]), record);
      continue;
    }
    each_output(taker, record);
    check_answer(database_, record, lists[record.sample]);
    put_lists(std::move(lists[record.sample]), record);
  }
  return records;
}

}  // namespace wythe::study
