// Numbers, intervals and estimates as statistics.json and comparison.json write them.
#pragma once

#include <fmt/format.h>

#include <cmath>
#include <nlohmann/json.hpp>
#include <string>

#include "core/number.h"
#include "io/results/message_json.h"
#include "wythe/parts/statistics.h"

namespace wythe::io {

using Json = nlohmann::ordered_json;

inline Json number(double value) {
  if (!std::isfinite(value)) return nullptr;
  return *parse_number(fmt::format("{:.9g}", value));
}
inline Json pair(const Interval& interval, double scale = 1) {
  return Json::array({number(interval.low * scale), number(interval.high * scale)});
}
inline void add(Json& json, const std::string& key, const Estimate& estimate, double scale = 1) {
  json[key] = number(estimate.value * scale);
  json[key + "_interval"] = pair(estimate.interval, scale);
}
// Probabilities of a fragility with their intervals, point by point.
inline void add_probabilities(Json& json, const std::vector<FragilityPoint>& points) {
  const auto each = [&](const auto& value) {
    return list_of(points, [&](const FragilityPoint& p) { return number(value(p.probability)); });
  };
  json["probability"] = each([](const Estimate& e) { return e.value; });
  json["low"] = each([](const Estimate& e) { return e.interval.low; });
  json["high"] = each([](const Estimate& e) { return e.interval.high; });
}

}  // namespace wythe::io
