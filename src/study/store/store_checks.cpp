// Whether a store is what was written: pages, rows and checksums.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "study/store/store.h"
#include "study/store/store_schema.h"
#include "wythe/error.h"

namespace wythe::study {
namespace {

template <class Check>
bool passes(const Check& check) {
  try {
    check();
    return true;
  } catch (const IoError&) {
    return false;
  }
}

}  // namespace

bool is_outcome(const std::string& status) {
  return value_of(kSolveStatusWords, status).has_value() || status == "refused";
}

void check_shakes(Database& database, const SampleRecord& record,
                  const std::vector<ShakeAnswer>& shakes) {
  for (const ShakeAnswer& shake : shakes) {
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

bool Store::inputs_are_whole() {
  return passes([&] { check_inputs_digest(database_); });
}

bool Store::is_whole(int sample) {
  return passes([&] { digests().check_record(sample); });
}

void Store::check_whole(const SampleTable* drawn) {
  constexpr std::size_t kAtOnce = 256;
  Statement check(database_, "PRAGMA quick_check(1)");
  const std::string verdict = check.step() ? check.text() : "";
  if (verdict != "ok") database_.damaged(verdict);
  check_schema_digest(database_);
  if (drawn != nullptr) check_inputs_of(*drawn);
  const SampleTable own = drawn == nullptr ? samples() : SampleTable{};
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
    const auto sample = static_cast<std::size_t>(select.integer(1, drawn.n_sample()));
    const std::vector<double>& inputs = drawn.value[sample - 1];
    const auto position =
        static_cast<std::size_t>(select.integer(0, static_cast<std::int64_t>(inputs.size()) - 1));
    const double value = select.number(), other = inputs[position];
    if (value != other && !(std::isnan(value) && std::isnan(other)))
      select.damaged("an input is not what the checksum of all inputs says");
  }
}

// A row of a sample that is not stored belongs to none.
void Store::check_no_other_sample() {
  for (const std::string& table : result_tables()) {
    if (!is_current() &&
        database_.integer("SELECT count(*) FROM sqlite_schema WHERE name = '" + table + "'") == 0)
      continue;  // older ones lack some
    Statement other(database_,
                    fmt::format("SELECT sample FROM {} WHERE sample NOT IN (SELECT sample FROM "
                                "main.sample) LIMIT 1",
                                table));
    if (other.step()) other.damaged("there is no such sample");
  }
}

void Store::check_states() {
  const OneMoment moment(database_);
  for (const int sample : done()) digests().check_states(sample);
}

int last_counted(Store& store) {
  const int met = store.number_of_sample("until_met_at");
  return met == 0 ? std::numeric_limits<int>::max() : met;
}

}  // namespace wythe::study
