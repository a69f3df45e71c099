// A row is inputs, status, then answers in the order of wythe/parts/responses.h, with falls and failure mode among them.
// A sample without an answer has empty cells, so that all rows have the same columns. The row of a run has the same
// names and is filled from summary.json by the keys of that file.
#include "io/export/export_samples.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <type_traits>

#include "io/text/csv.h"
#include "wythe/parts/error.h"
#include "wythe/parts/responses.h"

namespace wythe::io {
namespace {

using Cells = std::vector<ExportCell>;

const ExportColumn kSample{"sample", "", "number of the sample, from 1; of a run 1"};
const ExportColumn kStatus{"status", "", "how it ended: completed, collapsed, refused, ...", true};
const ExportColumn kReason{"reason", "", "why it stopped", true};
const ExportColumn kRetried{"retried", "", "1: run again with half the step"};
const ExportColumn kMode{"failure_mode", "", "FM-1 to FM-5, another name, or unclear", true};
const ExportColumn kHash{"state_hash", "", "identifies the final state bit for bit", true};

std::string flag(bool value) { return value ? "1" : "0"; }

// The name of a result in these tables: its own column name, else the key of summary.json.
template <class Value>
ExportColumn column_of(const OutputKey& key, const Value&) {
  std::string name = *key.column != '\0' ? key.column : key.summary;
  std::replace(name.begin(), name.end(), '.', '_');
  constexpr bool kIsText = !std::is_same_v<Value, double> && !std::is_same_v<Value, bool>;
  return {std::move(name), key.unit, key.meaning, kIsText};
}

std::string text_of_value(const OutputKey& key, const auto& value) {
  using Value = std::decay_t<decltype(value)>;
  if constexpr (std::is_same_v<Value, double>)
    return csv_cell(value * key.to_unit);
  else if constexpr (std::is_same_v<Value, bool>)
    return flag(value);
  else if constexpr (std::is_same_v<Value, Message>)
    return csv_cell(text_of(value));
  else
    return csv_cell(value);
}

std::string meaning_of(const StudySpec& study, const InputColumn& column) {
  for (const DependentSpec& d : study.dependent)
    if (d.name == column.name) return "input: " + d.formula;
  return column.path.empty() ? "input of formulas alone" : "input: sets " + column.path;
}

// Adds a fraction of the peak other than 0.8, which has its own columns.
void add_fall(Cells& cells, double fraction, const std::string& displacement,
              const std::string& censored) {
  const double percent = 100 * fraction;
  cells.push_back({{fmt::format("displacement_at_{:g}_percent_mm", percent), "mm",
                    fmt::format("where the force falls below {:g} of the peak to stay; a "
                                "lower bound where censored_{:g} is 1",
                                fraction, percent)},
                   displacement});
  cells.push_back(
      {{fmt::format("censored_{:g}", percent), "",
        fmt::format("1: the push ended before the force had fallen below {:g} of the peak to stay",
                    fraction)},
       censored});
}

// The value of a summary at "bilinear.force_kN", as a cell.
std::string text_at(const nlohmann::json& summary, const std::string& path) {
  const nlohmann::json* at = &summary;
  std::size_t begin = 0;
  while (at != nullptr && begin <= path.size()) {
    const std::size_t dot = std::min(path.find('.', begin), path.size());
    const auto found = at->is_object() ? at->find(path.substr(begin, dot - begin)) : at->end();
    at = at->is_object() && found != at->end() ? &*found : nullptr;
    begin = dot + 1;
  }
  if (at == nullptr || at->is_null()) return "";
  if (at->is_boolean()) return flag(at->get<bool>());
  if (at->is_number()) return csv_cell(at->get<double>());
  return at->is_string() ? csv_cell(at->get<std::string>()) : "";
}

}  // namespace

nlohmann::ordered_json columns_json(const std::vector<ExportColumn>& columns) {
  nlohmann::ordered_json list = nlohmann::ordered_json::array();
  for (const ExportColumn& column : columns)
    list.push_back({{"name", column.name}, {"unit", column.unit}, {"meaning", column.meaning}});
  return list;
}

std::vector<ExportCell> sample_cells(const Campaign& campaign, const SampleRecord& record) {
  Cells cells = {{kSample, std::to_string(record.sample)}};
  for (std::size_t i = 0; i < campaign.samples.column.size(); ++i) {
    const InputColumn& c = campaign.samples.column[i];
    const double value = i < record.inputs.size() ? record.inputs[i] : kUnset;
    cells.push_back({{column_title(c), c.unit == "1" ? "–" : c.unit, meaning_of(campaign.study, c)},
                     csv_cell(value * c.to_unit + c.offset)});
  }
  cells.push_back({kStatus, csv_cell(record.status)});
  cells.push_back({kReason, csv_cell(text_of(record.reason))});
  cells.push_back({kRetried, flag(record.retried)});
  const bool answered = record.answered();
  const auto add = [&](const OutputKey& key, const auto& value) {
    cells.push_back({column_of(key, value), answered ? text_of_value(key, value) : ""});
  };
  each_response(add, record.responses);
  for (const double fraction : more_fractions(campaign.study)) {
    const auto fall =
        std::find_if(record.responses.falls.begin(), record.responses.falls.end(),
                     [&](const FallTo& f) { return std::fabs(f.fraction - fraction) < 1e-9; });
    const bool known = answered && fall != record.responses.falls.end();
    add_fall(cells, fraction, known ? csv_cell(1e3 * fall->displacement) : "",
             known ? flag(fall->censored) : "");
  }
  cells.push_back({kMode, answered ? csv_cell(record.failure_mode.name) : ""});
  each_quasi_static(add, record.quasi_static);
  cells.push_back({kHash, csv_cell(record.state_hash)});
  return cells;
}

std::vector<ExportCell> run_cells(const nlohmann::json& summary) {
  Cells cells = {
      {kSample, "1"}, {kStatus, text_at(summary, "status")}, {kReason, text_at(summary, "reason")}};
  const auto add = [&](const OutputKey& key, const auto& value) {
    cells.push_back({column_of(key, value), text_at(summary, key.summary)});
  };
  const SampleRecord any;
  each_response(add, any.responses);
  if (const auto falls = summary.find("falls"); falls != summary.end() && falls->is_array())
    for (const nlohmann::json& fall : *falls) {
      const auto fraction = fall.is_object() ? fall.find("fraction") : fall.end();
      if (!fall.is_object() || fraction == fall.end() || !fraction->is_number()) continue;
      if (std::fabs(fraction->get<double>() - 0.8) < 1e-9) continue;
      add_fall(cells, fraction->get<double>(), text_at(fall, "displacement_mm"),
               text_at(fall, "censored"));
    }
  cells.push_back({kMode, text_at(summary, "failure_mode.name")});
  each_quasi_static(add, any.quasi_static);
  cells.push_back({kHash, text_at(summary, "state_hash")});
  return cells;
}

}  // namespace wythe::io
