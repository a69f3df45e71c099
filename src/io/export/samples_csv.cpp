// samples.csv of a campaign: one row for each sample that ran, in order, with results that depend only on its inputs.
//
// It has no data of the machine (times, jobs), so that an undisturbed, a resumed and a merged campaign give the
// same bytes. Columns: docs/reference/store.md.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string_view>
#include <type_traits>

#include "campaign/draws/result_columns.h"
#include "io/export/export_samples.h"
#include "io/results/shakes_csv.h"
#include "io/text/csv.h"
#include "wythe/parts/io.h"
#include "wythe/parts/responses.h"

namespace wythe {
namespace {

const FallTo* fall_to(const Responses& responses, double fraction) {
  for (const FallTo& fall : responses.falls)
    if (std::fabs(fall.fraction - fraction) < 1e-9) return &fall;
  return nullptr;
}

// Responses of a cyclic push, computed from the stored rows.
CyclicReadings cyclic_readings(const SampleRecord& record) {
  if (!record.answered()) return {};
  ResponseOptions read;
  if (record.status == to_string(SolveStatus::kCollapsed)) read.collapse = record.reason;
  return read_responses(record.curve, read).cyclic;
}

bool any_cyclic(const Campaign& campaign) {
  return std::any_of(campaign.records.begin(), campaign.records.end(),
                     [](const SampleRecord& record) { return cyclic_readings(record).sense != 0; });
}

// One column of a result: its title, and its cell in a row.
struct Cell {
  std::string title, text;
};

// The two directions of a cyclic push, after all other columns.
std::vector<Cell> cyclic_cells(const CyclicReadings& c) {
  std::vector<Cell> cells = {{"read_in", c.sense > 0 ? "positive" : "negative"}};
  const auto add = [&](const std::string& title, auto value) {
    if constexpr (std::is_same_v<decltype(value), bool>)
      cells.push_back({title, value ? "1" : "0"});
    else
      cells.push_back({title, io::short_cell(value)});
  };
  study::each_direction_column(add, "positive", c.positive);
  study::each_direction_column(add, "negative", c.negative);
  if (c.sense == 0)
    for (Cell& cell : cells) cell.text.clear();
  return cells;
}

// The columns of the responses (responses.h), with the failure
// mode and the other fractions of the peak between them.
std::vector<Cell> answer_cells(const Campaign& campaign, const SampleRecord& record) {
  const Responses& r = record.responses;
  std::vector<Cell> cells;
  const auto add = [&](const OutputKey& key, const auto& value) {
    using Value = std::decay_t<decltype(value)>;
    if (key.listed != OutputKey::kCsv) return;
    if constexpr (std::is_same_v<Value, double>)
      cells.push_back({key.column, io::short_cell(key.to_unit * value)});
    else if constexpr (std::is_same_v<Value, bool>)
      cells.push_back({key.column, value ? "1" : "0"});
    else if constexpr (std::is_same_v<Value, Message>)
      cells.push_back({key.column, io::csv_cell(text_of(value))});
    else
      cells.push_back({key.column, io::csv_cell(value)});
    if (std::string_view(key.stored) == "displacement_max_m")
      cells.push_back({"failure_mode", io::csv_cell(record.failure_mode.name)});
    if (std::string_view(key.stored) != "censored_max") return;
    for (const double fraction : io::more_fractions(campaign.study)) {
      const FallTo* fall = fall_to(r, fraction);
      cells.push_back({fmt::format("displacement_at_{:g}_percent_mm", 100 * fraction),
                       fall ? io::short_cell(1e3 * fall->displacement) : ""});
      cells.push_back({fmt::format("censored_{:g}", 100 * fraction), !fall            ? ""
                                                                     : fall->censored ? "1"
                                                                                      : "0"});
    }
  };
  each_response(add, r);
  if (!record.answered())
    for (Cell& cell : cells) cell.text.clear();
  return cells;
}

bool any_shaken(const Campaign& campaign) {
  return std::any_of(campaign.records.begin(), campaign.records.end(),
                     [](const SampleRecord& record) { return !record.shakes.empty(); });
}

std::string title_row(const Campaign& campaign, bool cyclic) {
  std::string row = "sample";
  for (const InputColumn& column : campaign.samples.column)
    row += "," + io::csv_cell(column_title(column));
  row += ",status";
  for (const Cell& cell : answer_cells(campaign, {})) row += "," + cell.title;
  row += ",retried,state_hash";
  if (cyclic)
    for (const Cell& cell : cyclic_cells({})) row += "," + cell.title;
  return row + "\n";
}

}  // namespace

std::string samples_csv(const Campaign& campaign) {
  if (campaign.study.shaking.is_asked()) return io::shakes_csv(campaign);
  const bool shaken = any_shaken(campaign);
  const bool cyclic = any_cyclic(campaign);
  std::string text = title_row(campaign, cyclic);
  if (shaken) text.insert(text.size() - 1, io::shake_titles(campaign.study));
  for (const SampleRecord& record : campaign.records) {
    text += std::to_string(record.sample);
    for (std::size_t i = 0; i < record.inputs.size(); ++i) {
      const InputColumn& column = campaign.samples.column[i];
      text += "," + io::short_cell(record.inputs[i] * column.to_unit + column.offset);
    }
    text += "," + io::csv_cell(record.status);
    for (const Cell& cell : answer_cells(campaign, record)) text += "," + cell.text;
    text += fmt::format(",{},{}", record.retried ? 1 : 0, record.state_hash);
    if (cyclic)
      for (const Cell& cell : cyclic_cells(cyclic_readings(record))) text += "," + cell.text;
    if (shaken)
      text += io::shake_cells(campaign.study,
                              record.shakes.empty() ? ShakeResult{} : record.shakes.front());
    text += "\n";
  }
  return text;
}

}  // namespace wythe
