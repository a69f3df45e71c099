// Writes counts and fragilities of shakes. The unit in the key of an intensity is that of the study's measure. A
// limit state without a fragility keeps its counts and brackets. Brackets number walls and records from 1.
#include "io/export/shaking_json.h"

#include "io/results/message_json.h"

namespace wythe::io {
namespace {

std::string unit_in_key(const ShakingSpec& shaking) {
  return shaking.measure == IntensityMeasure::kPgv ? "_m_per_s" : "_m_per_s2";
}

Json limits_json(const LimitStateSpec& limit) {
  Json json = Json::object();
  const auto set = [&](const char* key, double value, double to_unit) {
    if (!std::isnan(value)) json[key] = number(value * to_unit);
  };
  set("peak_drift_percent", limit.peak_drift, 1e2);
  set("residual_drift_percent", limit.residual_drift, 1e2);
  set("peak_displacement_mm", limit.peak_displacement, 1e3);
  set("residual_displacement_mm", limit.residual_displacement, 1e3);
  set("uplift_mm", limit.uplift, 1e3);
  set("slip_mm", limit.slip, 1e3);
  json["collapse"] = true;
  return json;
}

Json scatter_json(const Scatter& scatter) {
  Json json = {{"verdict", word_of(kScatterVerdictWords, scatter.verdict)},
               {"records", scatter.records},
               {"walls", scatter.walls}};
  if (scatter.verdict != ScatterVerdict::kTold) return json;
  add(json, "record_to_record", scatter.record);
  add(json, "wall_to_wall", scatter.wall);
  add(json, "rest", scatter.rest);
  json["bracket"] = number(scatter.bracket);
  return json;
}

Json counts_json(const LimitStateFragility& f, const std::string& unit) {
  Json list = Json::array();
  for (const LimitStateCount& count : f.count) {
    Json row = {{"intensity" + unit, number(count.intensity)},
                {"n", count.n},
                {"reached", count.reached},
                {"lost", count.lost}};
    add(row, "share", count.share);
    list.push_back(std::move(row));
  }
  return list;
}

// `above`: null where the end was not reached.
Json brackets_json(const LimitStateFragility& f, const std::string& unit) {
  return io::list_of(f.bracket, [&](const Bracket& b) -> Json {
    return {{"sample", b.sample},
            {"wall", b.wall + 1},
            {"record", b.record + 1},
            {"not_at" + unit, number(b.low)},
            {"reached_at" + unit, number(b.high)},
            {"known", b.is_known},
            {"came_back", b.came_back}};
  });
}

Json curve_json(const LimitStateFragility& f, const std::string& unit) {
  Json json = Json::object();
  add_probabilities(json, f.curve);
  json["intensity" + unit] = list_of(f.curve, [](const FragilityPoint& p) { return number(p.x); });
  return json;
}

}  // namespace

Json shaking_json(const ShakingStatistics& s) {
  const std::string unit = unit_in_key(s.shaking);
  Json json = {{"records", s.records}, {"walls", s.walls}, {"samples", s.samples},
               {"shakes", s.shakes},   {"stood", s.stood}, {"collapsed", s.collapsed},
               {"lost", Json::array()}};
  if (!s.damping.empty()) put(json, "damping_of_shakes", s.damping);
  if (s.shaking.is_asked()) {
    json["measure"] = word_of(kIntensityMeasureWords, s.shaking.measure);
    if (!std::isnan(s.shaking.period)) json["period_s"] = number(s.shaking.period);
    if (!std::isnan(s.shaking.damping)) json["damping"] = number(s.shaking.damping);
  }
  for (const LostShake& lost : s.lost)
    json["lost"].push_back({{"sample", lost.sample},
                            {"intensity" + unit, number(lost.intensity)},
                            {"status", lost.status},
                            {"reason", text_of(lost.reason)}});
  Json& list = json["intensities"] = Json::array();
  for (const IntensitySummary& i : s.intensity)
    list.push_back({{"intensity" + unit, number(i.intensity)},
                    {"n", i.n},
                    {"collapsed", i.collapsed},
                    {"lost", i.lost},
                    {"drift_percent_16", number(1e2 * i.drift_16)},
                    {"drift_percent_50", number(1e2 * i.drift_50)},
                    {"drift_percent_84", number(1e2 * i.drift_84)},
                    {"scatter_of_drift", scatter_json(i.scatter)}});
  return json;
}

Json limit_states_json(const ShakingStatistics& s) {
  const std::string unit = unit_in_key(s.shaking);
  Json list = Json::array();
  for (const LimitStateFragility& f : s.fragility) {
    Json row = {{"limit_state", f.limit_state.name},
                {"limits", limits_json(f.limit_state)},
                {"measure", word_of(kIntensityMeasureWords, s.shaking.measure)},
                {"verdict", word_of(kLimitStateVerdictWords, f.verdict)},
                {"n", f.n},
                {"reached", f.reached},
                {"lost", f.lost},
                {"came_back", f.came_back}};
    if (f.verdict == LimitStateVerdict::kTold) {
      add(row, "median" + unit, f.median);
      add(row, "beta", f.beta);
      row["interval_by"] = f.by_bootstrap ? "bootstrap of records and walls" : "profile likelihood";
      row["log_likelihood"] = number(f.log_likelihood);
      row["by_counts"] = {{"median" + unit, number(f.count_median)},
                          {"beta", number(f.count_beta)}};
      if (f.lost > 0)
        row["median_if_lost" + unit] = {{"reached", number(f.median_if_reached)},
                                        {"not_reached", number(f.median_if_not)}};
      row["curve"] = curve_json(f, unit);
    }
    row["counts"] = counts_json(f, unit);
    row["brackets"] = brackets_json(f, unit);
    row["scatter"] = scatter_json(f.scatter);
    list.push_back(std::move(row));
  }
  return list;
}

}  // namespace wythe::io
