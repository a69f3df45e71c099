// Collects the titles of columns in small letters: from output keys, from directions of a
// cyclic push, and from a list of titles that no key gives. A new column without a key belongs
// in that list. Columns of study.fractions contain a number, so they are matched by a pattern.
#include "campaign/draws/result_columns.h"

#include <algorithm>
#include <set>
#include <string_view>

#include "wythe/parts/campaign.h"
#include "wythe/parts/responses.h"

namespace wythe::study {
namespace {

// Titles without an output key: of the sample itself, of a cyclic push, of shakes (src/io/export/samples_csv.cpp,
// shakes_csv.cpp). tests/unit/io/study_input_test.cpp compares them with the headers that are written.
constexpr const char* kMoreColumns[] = {"sample",
                                        "wall",
                                        "record",
                                        "status",
                                        "reason",
                                        "retried",
                                        "failure_mode",
                                        "state_hash",
                                        "read_in",
                                        "intensity_pga_m_per_s2",
                                        "intensity_sa_m_per_s2",
                                        "intensity_pgv_m_per_s",
                                        "pga_m_per_s2",
                                        "pgv_m_per_s",
                                        "sa_m_per_s2",
                                        "peak_drift_percent",
                                        "residual_drift_percent",
                                        "peak_displacement_mm",
                                        "residual_displacement_mm",
                                        "uplift_mm",
                                        "slip_mm",
                                        "peak_base_shear_kN",
                                        "collapse_time_s",
                                        "energy_gap_percent",
                                        "shaken_to_collapse",
                                        "counts",
                                        "limit_states"};

std::set<std::string> all_columns() {
  std::set<std::string> all;
  for (const char* more : kMoreColumns) all.insert(without_case(more));
  for (const char* side : {"positive", "negative"})
    each_direction_column([&](const std::string& title, auto) { all.insert(without_case(title)); },
                          side, {});
  const auto add = [&](const OutputKey& key, const auto&) {
    std::string summary = key.summary;  // an exported table uses this name
    std::replace(summary.begin(), summary.end(), '.', '_');
    all.insert(without_case(*key.column != '\0' ? key.column : summary));
  };
  const SampleRecord any;
  each_response(add, any.responses);
  each_quasi_static(add, any.quasi_static);
  return all;
}

// A column for each of study.fractions: displacement_at_50_percent_mm, censored_50.
bool is_of_a_fraction(std::string_view title) {
  const auto is_number = [](std::string_view text) {
    return !text.empty() && text.find_first_not_of("0123456789.e-+_") == std::string_view::npos;
  };
  constexpr std::string_view kFall = "displacement_at_", kEnd = "_percent_mm", kCut = "censored_";
  if (title.starts_with(kCut)) return is_number(title.substr(kCut.size()));
  return title.starts_with(kFall) && title.ends_with(kEnd) &&
         title.size() > kFall.size() + kEnd.size() &&
         is_number(title.substr(kFall.size(), title.size() - kFall.size() - kEnd.size()));
}

}  // namespace

std::string without_case(std::string title) {
  for (char& c : title)
    if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
  return title;
}

bool is_result_column(const std::string& title) {
  static const std::set<std::string> kAll = all_columns();
  const std::string lower = without_case(title);
  return kAll.contains(lower) || is_of_a_fraction(lower);
}

}  // namespace wythe::study

namespace wythe {

std::string column_title(const InputColumn& column) {
  if (column.unit.empty() || column.unit == "1") return column.name;
  std::string unit;
  for (const char c : column.unit) {
    if (c == '/')
      unit += "_per_";
    else if (c == '%')
      unit += "percent";
    else if (c == ' ' || c == '*' || c == '.')
      unit += '_';
    else if (c != '^')
      unit += c;
  }
  return column.name + "_" + unit;
}

}  // namespace wythe
