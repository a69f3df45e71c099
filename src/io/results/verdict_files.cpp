// assessment.json and walls.csv of `wythe assess`; keys and columns: docs/reference/assess.md.
#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "io/export/statistics_numbers.h"
#include "io/results/assessment_json.h"
#include "io/results/message_json.h"
#include "io/text/csv.h"
#include "wythe/io.h"
#include "wythe/verdict.h"

namespace wythe {
namespace {

using io::Json;
using io::number;

constexpr double kToG = 1 / kStandardGravity;

Json capacity_json(const WallCapacity& c, double scale) {
  return {{"median", number(c.median.value * scale)},
          {"low", number(c.median.interval.low * scale)},
          {"high", number(c.median.interval.high * scale)},
          {"at_least", c.at_least}};
}

void add_counts(Json& json, const WallCounts& counts) {
  const Estimate share = counts.probability();
  json["probability"] = number(share.value);
  json["probability_interval"] = io::pair(share.interval);
  json["walls"] = counts.walls;
  json["met"] = counts.met;
  json["not_met"] = counts.not_met;
  json["not_shown"] = counts.not_shown;
  json["lost"] = counts.lost;
}

Json ways_json(const std::vector<WayOfPushing>& ways) {
  Json list = Json::array();
  for (const WayOfPushing& way : ways) {
    Json& json = list.emplace_back(
        Json{{"direction", way.direction}, {"pattern", way.pattern}, {"folder", way.folder}});
    add_counts(json, way.counts);
    json["pga_capacity_g"] = capacity_json(way.capacity, kToG);
    Json lost = Json::array();
    for (const JudgedWall& wall : way.walls) {
      if (!wall.is_lost()) continue;
      Json one = {{"wall", wall.wall}, {"seed", wall.seed}};
      io::put(one, "why", wall.lost);
      lost.push_back(std::move(one));
    }
    json["lost_walls"] = std::move(lost);
  }
  return list;
}

// "-x" is no formula, and stays as it is.
std::string direction_cell(const std::string& direction) {
  return direction.starts_with('[') ? io::csv_cell(direction) : direction;
}

}  // namespace

std::string verdict_json(const WallsVerdict& v) {
  Json json = {{"verdict", word_of(kAssessmentVerdictWords, v.verdict)},
               {"may_be_signed", v.may_be_signed}};
  io::put(json, "sentence", v.sentence);
  io::put(json, "cautions", v.cautions);
  io::put(json, "reason", v.reason);
  add_counts(json, v.counts);
  json["pga_capacity_g"] = capacity_json(v.capacity, kToG);
  const double demand = v.spectrum.is_given() ? v.spectrum.peak_ground_acceleration() : kUnset;
  json["pga_demand_g"] = number(demand * kToG);
  json["risk_index"] = capacity_json(v.capacity, 1 / demand);
  json["decides"] = v.decides();
  json["direction"] = v.direction;
  json["pattern"] = v.pattern;
  json["failure_mode"] = {{"name", v.mode}, {"walls", v.mode_count}};
  json["code"] = v.spec.code;
  json["limit_state"] = v.spec.limit_state;
  json["confidence_factor"] = number(v.spec.confidence_factor);
  Json states = Json::array();
  for (std::size_t s = 0; s < v.limit_states.size(); ++s) {
    const std::string state = word_of(kLimitStateWords, static_cast<LimitState>(s));
    states.push_back({{"state", state},
                      {"is_checked", state == v.spec.limit_state},
                      {"pga_capacity_g", capacity_json(v.limit_states[s], kToG)}});
  }
  json["limit_states"] = std::move(states);
  json["ways"] = ways_json(v.ways);
  if (v.spectrum.is_given()) json["spectrum"] = io::spectrum_json(v.spectrum);
  io::put(json, "notes", v.notes);
  return json.dump(1) + "\n";
}

std::string walls_csv(const WallsVerdict& v) {
  std::string text =
      "wall,seed,direction,pattern,verdict,pga_capacity_g,at_least,failure_mode,in_plane";
  for (const auto& word : kLimitStateWords)
    text += fmt::format(",{0}_pga_g,{0}_mm,{0}_ends_by", word.word);
  text += ",cautions,lost,state_hash\n";
  for (const WayOfPushing& way : v.ways)
    for (const JudgedWall& wall : way.walls) {
      const Reading capacity = wall.capacity();
      text += fmt::format("{},{},{},{},{},{},{},{},{}", wall.wall, wall.seed,
                          direction_cell(way.direction), io::csv_cell(way.pattern),
                          io::csv_cell(word_of(kAssessmentVerdictWords, wall.verdict())),
                          io::csv_cell(capacity.value * kToG), capacity.censored ? 1 : 0,
                          io::csv_cell(wall.mode), wall.is_in_plane ? 1 : 0);
      for (std::size_t s = 0; s < std::size(kLimitStateWords); ++s) {
        const LimitStateCheck* found = nullptr;
        for (const LimitStateCheck& check : wall.assessment.limit_states)
          if (check.state == static_cast<LimitState>(s)) found = &check;
        text += found == nullptr
                    ? ",,,"
                    : fmt::format(",{},{},{}", io::csv_cell(found->acceleration * kToG),
                                  io::csv_cell(found->displacement * 1e3),
                                  io::csv_cell(found->governing));
      }
      std::string cautions;
      for (const Message& caution : wall.assessment.cautions)
        cautions += (cautions.empty() ? "" : "; ") + text_of(caution);
      text += fmt::format(",{},{},{}\n", io::csv_cell(cautions), io::csv_cell(text_of(wall.lost)),
                          io::csv_cell(wall.state_hash));
    }
  return text;
}

}  // namespace wythe
