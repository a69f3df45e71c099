#include "study/record_rows.h"

#include <utility>

namespace wythe::study {
namespace {

constexpr double CurveRow::*kCurve[kCurveColumns] = {
    &CurveRow::time,          &CurveRow::displacement, &CurveRow::drift,
    &CurveRow::reaction,      &CurveRow::base_shear,   &CurveRow::unbalance_ratio,
    &CurveRow::kinetic_ratio, &CurveRow::load_factor};

constexpr std::vector<double> State::*kBlock[kBlockArrays] = {&State::ux, &State::uy,
                                                              &State::theta};
constexpr std::vector<double> State::*kPoint[kPointArrays] = {
    &State::kappa, &State::crush,        &State::plastic_slip,
    &State::slip,  &State::shear_damage, &State::tension_set};
constexpr std::vector<double> State::*kNode[kNodeArrays] = {&State::node_ux, &State::node_uy};

}  // namespace

RecordLists lists_of(const SampleRecord& record) {
  const FailureMode& mode = record.failure_mode;
  RecordLists lists{record.responses.falls, {}, mode.evidence,    mode.flags,
                    mode.elements,          {}, mode.sensitivity, record.features,
                    record.events};
  for (const auto& [name, score] : mode.scores) lists.scores.push_back({name, score});
  for (std::size_t i = 0; i < mode.elements.size(); ++i)
    for (const ElementSign& sign : mode.elements[i].signs)
      lists.signs.push_back({static_cast<std::int64_t>(i), sign});
  return lists;
}

void put_lists(RecordLists lists, SampleRecord& record) {
  FailureMode& mode = record.failure_mode;
  for (const ScoreRow& row : lists.scores) mode.scores[row.name] = row.score;
  for (SignRow& row : lists.signs) {
    const auto element = static_cast<std::size_t>(row.of_element);
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
}

std::vector<double> curve_columns(const std::vector<CurveRow>& curve) {
  std::vector<double> columns;
  columns.reserve(curve.size() * kCurveColumns);
  for (const auto member : kCurve)
    for (const CurveRow& row : curve) columns.push_back(row.*member);
  return columns;
}

std::vector<CurveRow> curve_rows(const std::vector<double>& columns) {
  std::vector<CurveRow> curve(columns.size() / kCurveColumns);
  auto next = columns.begin();
  for (const auto member : kCurve)
    for (CurveRow& row : curve) row.*member = *next++;
  return curve;
}

std::vector<double> state_arrays(const State& state) {
  std::vector<double> arrays;
  arrays.reserve(kBlockArrays * state.ux.size() + kPointArrays * state.kappa.size() +
                 kNodeArrays * state.node_ux.size());
  const auto add = [&](const std::vector<double>& array) {
    arrays.insert(arrays.end(), array.begin(), array.end());
  };
  for (const auto member : kBlock) add(state.*member);
  for (const auto member : kPoint) add(state.*member);
  for (const auto member : kNode) add(state.*member);
  return arrays;
}

State state_at_rest(const std::vector<double>& arrays, std::size_t blocks, std::size_t points) {
  State state;
  auto next = arrays.begin();
  const auto take = [&](std::vector<double>& array, std::size_t count) {
    array.assign(next, next + static_cast<std::ptrdiff_t>(count));
    next += static_cast<std::ptrdiff_t>(count);
  };
  for (const auto member : kBlock) take(state.*member, blocks);
  for (const auto member : kPoint) take(state.*member, points);
  const std::size_t nodes = static_cast<std::size_t>(arrays.end() - next) / kNodeArrays;
  for (const auto member : kNode) take(state.*member, nodes);
  for (auto* velocity : {&state.node_vx, &state.node_vy}) velocity->assign(nodes, 0.0);
  for (auto* velocity : {&state.vx, &state.vy, &state.omega}) velocity->assign(blocks, 0.0);
  return state;
}

}  // namespace wythe::study
