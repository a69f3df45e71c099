// Whether a store is what was written: pages, rows and checksums.
#include <fmt/format.h>

#include <cmath>
#include <limits>

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

void Store::check_whole() {
  Statement check(database_, "PRAGMA quick_check(1)");
  const std::string verdict = check.step() ? check.text() : "";
  if (verdict != "ok") database_.damaged(verdict);
  static_cast<void>(records(std::numeric_limits<int>::max()));
  check_no_other_sample();
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
  for (const int sample : done()) digests().check_states(sample);
}

}  // namespace wythe::study
