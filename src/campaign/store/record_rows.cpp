// Converts the nested members of a record to flat lists of rows, and back. A sign refers to its element by its
// position in the list; rows of one pier are consecutive. A sample without an answer keeps only its shakes. Arrays
// are stored column after column. Those of a curve are read by name, and a column that a store lacks is NaN.
#include "campaign/store/record_rows.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <utility>

namespace wythe::study {

RecordLists lists_of(const SampleRecord& record) {
  if (!record.answered()) {
    RecordLists lists;
    lists.shakes = record.shakes;
    return lists;
  }
  const FailureMode& mode = record.failure_mode;
  RecordLists lists{record.responses.falls,
                    {},
                    mode.evidence,
                    mode.flags,
                    mode.elements,
                    {},
                    mode.sensitivity,
                    record.features,
                    record.events,
                    record.rise,
                    {},
                    {},
                    record.shakes};
  const PushedWall& wall = record.pushed;
  for (std::size_t i = 0; i < wall.moved.size(); ++i)
    lists.moved.push_back(
        {wall.moved[i], i < wall.storeys.size() ? wall.storeys[i].drift : kUnset});
  for (const PierDrift& pier : wall.piers)
    for (const DriftPoint& at : pier.drifts) lists.piers.push_back({pier.element, pier.mark, at});
  for (const auto& [name, score] : mode.scores) lists.scores.push_back({name, score});
  for (std::size_t i = 0; i < mode.elements.size(); ++i)
    for (const ElementSign& sign : mode.elements[i].signs)
      lists.signs.push_back({static_cast<std::int64_t>(i), sign});
  return lists;
}

void put_lists(RecordLists lists, SampleRecord& record) {
  record.shakes = std::move(lists.shakes);
  if (!record.answered()) return;
  FailureMode& mode = record.failure_mode;
  for (const ScoreRow& row : lists.scores) mode.scores[row.name] = row.score;
  for (SignRow& row : lists.signs) {
    const std::size_t element = row.of_element;
    if (element < lists.elements.size())
      lists.elements[element].signs.push_back(std::move(row.sign));
  }
  record.responses.falls = std::move(lists.falls);
  mode.evidence = std::move(lists.evidence);
  mode.flags = std::move(lists.flags);
  mode.elements = std::move(lists.elements);
  mode.sensitivity = std::move(lists.readings);
  record.features = std::move(lists.features);
  record.events = std::move(lists.events);
  record.rise = std::move(lists.rise);
  PushedWall& wall = record.pushed;
  for (const MovedRow& row : lists.moved) {
    wall.moved.push_back(row.mass);
    if (std::isfinite(row.storey_drift))
      wall.storeys.push_back({row.mass.displacement, row.storey_drift});
  }
  for (const PierRow& row : lists.piers) {
    if (wall.piers.empty() || wall.piers.back().element != row.element)
      wall.piers.push_back(
          {.mark = row.mark, .mechanism = "", .drifts = {}, .element = row.element});
    wall.piers.back().drifts.push_back(row.at);
  }
}

std::string curve_column_names() {
  std::string names;
  for (const CurveColumn& column : kCurveColumns)
    names += (names.empty() ? "" : ",") + std::string(column.stored);
  return names;
}

std::vector<double> curve_columns(const std::vector<CurveRow>& curve) {
  std::vector<double> columns;
  columns.reserve(curve.size() * std::size(kCurveColumns));
  for (const CurveColumn& column : kCurveColumns)
    for (const CurveRow& row : curve) columns.push_back(row.*column.value);
  return columns;
}

std::vector<CurveRow> curve_rows(const std::vector<double>& columns,
                                 const std::vector<std::string>& names) {
  std::vector<CurveRow> curve(columns.size() / names.size());
  for (const CurveColumn& column : kCurveColumns) {
    const auto found = std::find(names.begin(), names.end(), column.stored);
    const auto first = static_cast<std::size_t>(found - names.begin()) * curve.size();
    for (std::size_t i = 0; i < curve.size(); ++i)
      curve[i].*column.value = found == names.end() ? kUnset : columns[first + i];
  }
  return curve;
}

std::vector<double> state_arrays(const State& state) {
  std::vector<double> arrays;
  for (const StateField& field : kStateFields)
    if (field.in_store)
      arrays.insert(arrays.end(), (state.*field.array).begin(), (state.*field.array).end());
  return arrays;
}

State state_at_rest(const std::vector<double>& arrays, const State& rest) {
  State state = rest;
  auto next = arrays.begin();
  for (const StateField& field : kStateFields) {
    if (!field.in_store) continue;
    std::vector<double>& array = state.*field.array;
    std::copy_n(next, array.size(), array.begin());
    next += static_cast<std::ptrdiff_t>(array.size());
  }
  return state;
}

}  // namespace wythe::study
