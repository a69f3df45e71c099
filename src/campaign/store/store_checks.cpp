// Checks that a store is as it was written: version, tables, pages, rows and checksums.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <map>
#include <string_view>
#include <vector>

#include "campaign/store/record_rows.h"
#include "campaign/store/store.h"
#include "campaign/store/store_schema.h"
#include "core/number.h"
#include "wythe/parts/error.h"
#include "wythe/parts/result.h"
#include "wythe/parts/units.h"

namespace wythe::study {
namespace {

// Possible judgements of the push rate; empty without a push.
constexpr std::string_view kJudgements[] = {"slow enough", "usable",  "too fast",
                                            "unknown",     "no push", ""};

// Peaks must be rows of the curve. This does not hold for a load that grows: its peak is a multiple of the weight.
template <class Refuse>
void check_peaks(const Refuse& refuse, const SampleRecord& record) {
  const Responses& r = record.responses;
  const auto is_row = [&](double reaction, double displacement) {
    return std::any_of(record.curve.begin(), record.curve.end(), [&](const CurveRow& row) {
      return std::fabs(row.reaction) == std::fabs(reaction) &&
             std::fabs(row.displacement) == std::fabs(displacement);
    });
  };
  const bool by_load = std::any_of(record.curve.begin(), record.curve.end(),
                                   [](const CurveRow& row) { return row.load_factor != 0; });
  if (by_load) return;
  if (!std::isnan(r.peak_raw) && !is_row(r.peak_raw, r.displacement_at_peak_raw))
    refuse("peak_raw_N and displacement_at_peak_raw_m are no row of its curve");
  if (!std::isnan(r.peak_reaction) && !is_row(r.peak_reaction, r.displacement_at_peak))
    refuse("peak_reaction_N and displacement_at_peak_m are no row of its curve");
}

// The states of a pushed wall must ascend, and each pier needs a drift at the same states up to the last (for an assessment).
// Shapes of the rise, of the first 20 mm, may reach beyond the last reading of a wall that falls, but not to the next.
template <class Refuse>
void check_pushed_wall(const Refuse& refuse, const RecordLists& lists) {
  double before = 0;
  for (const MovedRow& row : lists.moved) {
    const MovedMass& m = row.mass;
    if (!std::isfinite(m.first) || !std::isfinite(m.second) || !std::isfinite(m.mixed))
      refuse("its moved masses hold what is not a number");
    if (!(m.displacement > before)) refuse("its moved masses are not in order");
    before = m.displacement;
  }
  const std::vector<PierRow>& piers = lists.piers;
  if (piers.empty()) return;
  const auto is_of_first = [&](const PierRow& row) { return row.element == piers.front().element; };
  const std::size_t states =
      std::find_if_not(piers.begin(), piers.end(), is_of_first) - piers.begin();
  constexpr double kRise =
      0.021;  // shapes end where 5 % of the displacement are a reading's distance [m]
  const auto readings_up_to = [&](double displacement) {
    return lists.moved.back().mass.displacement > kRise ? displacement
                                                        : std::floor(displacement / kReadingsApart);
  };
  if (piers.size() % states != 0 || lists.moved.empty() ||
      readings_up_to(piers.back().at.displacement) <
          readings_up_to(lists.moved.back().mass.displacement))
    refuse("a pier's drift is missing");
  const auto is_state = [&](double displacement) {
    return std::any_of(lists.moved.begin(), lists.moved.end(),
                       [&](const MovedRow& row) { return row.mass.displacement == displacement; });
  };
  for (std::size_t i = 0; i < piers.size(); ++i) {
    const PierRow &row = piers[i], &first = piers[i - i % states];
    if (!std::isfinite(row.at.drift) || row.element != first.element ||
        row.at.displacement != piers[i % states].at.displacement || !is_state(row.at.displacement))
      refuse("a pier's drifts are not those of its states");
  }
}

}  // namespace

void check_answer(Database& database, const SampleRecord& record, const RecordLists& lists) {
  const auto refuse = [&](const std::string& what) {
    database.damaged(fmt::format("sample {}: {}", record.sample, what));
  };
  for (const double input : record.inputs)
    if (!std::isfinite(input)) refuse("it has run with an input that is no number");
  for (const CurveRow& row : record.curve)
    if (!std::isfinite(row.displacement) || !std::isfinite(row.reaction))
      refuse("its curve holds what is not a number");
  check_peaks(refuse, record);
  const std::string& judgement = record.quasi_static.judgement;
  if (std::find(std::begin(kJudgements), std::end(kJudgements), judgement) == std::end(kJudgements))
    refuse(fmt::format("rate_judgement is \"{}\", which no wythe says", judgement));
  std::set<std::string> scored;
  for (const ScoreRow& row : lists.scores)
    if (!scored.insert(row.name).second) refuse("the score of " + row.name + " stands there twice");
  check_pushed_wall(refuse, lists);
  for (const SignRow& row : lists.signs)
    if (row.of_element < 0 || row.of_element >= static_cast<std::int64_t>(lists.elements.size()))
      refuse(
          fmt::format("a sign belongs to element {} of {}", row.of_element, lists.elements.size()));
}

void Store::check_version() {
  const std::string& name = database_.name();
  const std::int64_t application = database_.integer("PRAGMA application_id");
  const std::int64_t version = database_.integer("PRAGMA user_version");
  if (application == 0 && database_.integer("SELECT count(*) FROM sqlite_schema") == 0)
    throw IoError(
        name +
        ": is empty, no campaign is in it; restore it from a copy, or remove it and begin "
        "the campaign again");
  if (application != kApplication)
    throw IoError(name + ": is an SQLite file, but not a campaign of wythe; name another folder");
  if (version != kSchemaVersion)
    throw IoError(
        fmt::format("{}: has store version {}, and this wythe reads and writes version {}; use the "
                    "wythe that wrote it, or "
                    "run the campaign again in another folder",
                    name, version, kSchemaVersion));
  check_tables();
}

// Only tables with rows are allowed. A foreign view or computed column could run without end,
// and a trigger could write. The declarations must be those of this version, word for word.
void Store::check_tables() {
  std::map<std::string, std::string> due = declared_tables();
  const std::map<std::string, std::string> all = due;
  Statement select(database_, "SELECT type, name, tbl_name, sql FROM main.sqlite_schema");
  while (select.step()) {
    const std::string type = select.text(), name = select.text(), of = select.text(),
                      sql = select.text();
    const auto none = [&](const std::string& why) {
      database_.damaged(fmt::format("its {} {} is none that wythe made{}", type, name, why));
    };
    if (name.starts_with("sqlite_stat")) continue;  // of ANALYZE
    if (type == "index" && sql.empty() && all.contains(of)) continue;
    if (type == "view" && name == "samples") continue;  // check_view()
    const auto found = all.find(name);
    if (type != "table" || found == all.end())
      none(fmt::format(" (if it is yours: DROP {} {})", type, name));
    due.erase(name);
    if (sql != found->second)
      throw IoError(fmt::format(
          "{}: its table {} is not declared as this wythe declares it: another state of wythe "
          "wrote "
          "the store, or it is damaged; use the wythe that wrote it, restore it from a copy, or "
          "run "
          "the campaign again in another folder",
          database_.name(), name));
  }
  if (!due.empty()) database_.damaged("table " + due.begin()->first + " is missing");
}

void Store::check_view() {
  const std::string due = samples_view_sql(columns());
  Statement select(database_,
                   "SELECT sql FROM main.sqlite_schema WHERE type = 'view' AND name = 'samples'");
  if (!select.step()) database_.damaged("the view samples is missing");
  if (due.substr(due.find("CREATE VIEW")) != select.text() + ";\n")
    database_.damaged("the view samples is not declared as wythe declares it for these inputs");
}

// The inputs of the study must agree with the table `input`.
void Store::check_columns_of(const StudySpec& spec, const SampleTable& table) {
  const auto refuse = [&](std::size_t i, const char* what) {
    database_.damaged(
        fmt::format("table input, position {}: {} is not that of the study", i, what));
  };
  const std::size_t variables = spec.variable.size(), all = variables + spec.dependent.size();
  if (table.column.size() != all)
    database_.damaged(
        fmt::format("table input has {} rows, the study {} inputs", table.column.size(), all));
  for (std::size_t i = 0; i < all; ++i) {
    const InputColumn& column = table.column[i];
    const InputSpec& input = i < variables ? static_cast<const InputSpec&>(spec.variable[i])
                                           : spec.dependent[i - variables];
    if (column.name != input.name) refuse(i, "name");
    if (column.path != input.path) refuse(i, "path");
    if (column.is_random != (i < variables)) refuse(i, "is_random");
    if (i < variables && column.si_unit != input.si_unit) refuse(i, "si_unit");
    if (column.unit != (input.unit.empty() ? column.si_unit : input.unit)) refuse(i, "unit");
    const double factor = column.si_unit == "1" ? 1 : 1 / unit_factor(column.unit, column.si_unit);
    if (column.to_unit != factor) refuse(i, "to_unit");
  }
}

bool is_outcome(const std::string& status) {
  return value_of(kSolveStatusWords, status).has_value() || status == "refused";
}

void check_shakes(Database& database, const SampleRecord& record,
                  const std::vector<ShakeResult>& shakes) {
  for (const ShakeResult& shake : shakes) {
    const auto refuse = [&](const std::string& what) {
      database.damaged(fmt::format("sample {}: a shake {}", record.sample, what));
    };
    if (!is_outcome(shake.status)) refuse(fmt::format("ends as \"{}\"", shake.status));
    if (shake.intensity <= 0 || std::isinf(shake.intensity)) refuse("has no intensity");
    if (!shake.counts()) continue;
    for (const double number : {shake.peak_displacement, shake.residual_displacement, shake.uplift,
                                shake.slip, shake.peak_drift, shake.residual_drift})
      if (!(number >= 0) || std::isinf(number)) refuse("holds what is not a number");
  }
}

void Store::check_whole(const SampleTable* drawn) {
  constexpr std::size_t kAtOnce = 256;
  Statement check(database_, "PRAGMA quick_check(1)");
  const std::string verdict = check.step() ? check.text() : "";
  if (verdict != "ok") database_.damaged(verdict);
  if (drawn != nullptr) check_inputs_of(*drawn);
  const SampleTable own = drawn == nullptr ? samples() : SampleTable{};
  check_view();
  const SampleTable& table = drawn == nullptr ? own : *drawn;
  const std::set<int> there = done();
  const std::vector<int> ran(there.begin(), there.end());
  for (std::size_t i = 0; i < ran.size(); i += kAtOnce) {
    static_cast<void>(records(table, ran[i], ran[std::min(i + kAtOnce, ran.size()) - 1]));
    database_.give_back();
  }
  check_no_other_sample();
}

std::string Store::inputs_digest() { return value(kInputsDigest); }

void Store::check_inputs_of(const SampleTable& drawn) {
  Statement select(
      database_,
      "SELECT sample, position, value FROM sample_input WHERE sample IN (SELECT sample "
      "FROM main.sample) ORDER BY sample, position");
  while (select.step()) {
    const std::size_t sample = select.integer(1, drawn.n_sample());
    const std::vector<double>& inputs = drawn.value[sample - 1];
    const auto position =
        static_cast<std::size_t>(select.integer(0, static_cast<std::int64_t>(inputs.size()) - 1));
    const double value = select.number(), other = inputs[position];
    if (value != other && !(std::isnan(value) && std::isnan(other)))
      select.damaged("an input is not what the checksum of all inputs says");
  }
}

// A row of a sample that is not stored is damage.
void Store::check_no_other_sample() {
  for (const std::string& table : result_tables()) {
    Statement other(database_,
                    fmt::format("SELECT sample FROM {} WHERE sample NOT IN (SELECT sample FROM "
                                "main.sample) LIMIT 1",
                                table));
    if (other.step()) other.damaged("there is no such sample");
  }
}

void Store::check_states() {
  const ReadTransaction moment(database_);
  for (const int sample : done()) digests().check_states(sample);
}

int last_counted(Store& store) {
  const int met = store.number_of_sample("until_met_at");
  return met == 0 ? std::numeric_limits<int>::max() : met;
}

std::optional<Shard> shard_of(const std::string& text) {
  const auto number = leading_number<int>(text);
  if (!number || !number->rest.starts_with('/')) return std::nullopt;
  const auto of = parse_number<int>(number->rest.substr(1));
  if (!of || number->value < 1 || *of < number->value) return std::nullopt;
  const Shard shard{number->value, *of};
  if (text != fmt::format("{}/{}", shard.number, shard.of)) return std::nullopt;  // " 01/2"
  return shard;
}

bool same_inputs(const std::vector<double>& a, const std::vector<double>& b) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end(), [](double one, double other) {
    return one == other || (std::isnan(one) && std::isnan(other));
  });
}

}  // namespace wythe::study
