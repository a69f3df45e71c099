// assessment.json and walls.csv of `wythe assess`; keys and columns: docs/reference/assess.md.
#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "io/export/statistics_numbers.h"
#include "io/results/assessment_json.h"
#include "io/results/message_json.h"
#include "io/text/csv.h"
#include "wythe/parts/io.h"
#include "wythe/parts/verdict.h"

namespace wythe {
namespace {

using io::Json;
using io::number;

constexpr double kGPerAcceleration = 1 / kStandardGravity;

Json capacity_json(const WallCapacity& c, double scale) {
  return {{"median", number(c.median.value * scale)},
          {"low", number(c.with_tests.low * scale)},
          {"high", number(c.with_tests.high * scale)},
          {"at_least", c.at_least}};
}

void add_counts(Json& json, const WallCounts& counts) {
  const Estimate share = counts.probability();
  json["probability"] = number(share.value);
  json["probability_interval"] = io::pair(counts.with_tests());
  json["probability_interval_of_walls"] = io::pair(share.interval);
  json["walls"] = counts.walls;
  json["met"] = counts.met;
  json["not_met"] = counts.not_met;
  json["not_shown"] = counts.not_shown;
  json["lost"] = counts.lost;
  const int enough = walls_to_decide(counts);
  json["walls_to_decide"] = enough > counts.walls ? Json(enough) : Json(nullptr);
}

Json rules_json(const std::vector<RuleOfWalls>& rules) {
  Json list = Json::array();
  for (const RuleOfWalls& rule : rules) {
    Json& one = list.emplace_back();
    io::put(one, "rule", rule.words);
    one["walls"] = rule.walls;
    one["decides"] = rule.decides;
    one["displacement_mm"] = number(rule.displacement * 1e3);
  }
  return list;
}

Json states_json(const std::vector<StateVerdict>& states) {
  Json list = Json::array();
  for (const StateVerdict& v : states) {
    Json& json =
        list.emplace_back(Json{{"state", word_of(kLimitStateWords, v.state)},
                               {"is_checked", v.is_checked},
                               {"verdict", word_of(kAssessmentVerdictWords, v.verdict)},
                               {"direction", v.direction},
                               {"pattern", v.pattern},
                               {"pga_demand_g", number(v.demand * kGPerAcceleration)},
                               {"pga_capacity_g", capacity_json(v.capacity, kGPerAcceleration)},
                               {"risk_index", capacity_json(v.capacity, 1 / v.demand)},
                               {"rules", rules_json(v.rules)}});
    if (v.is_checked) add_counts(json, v.counts);
  }
  return list;
}

Json tests_json(const WallsVerdict& v) {
  Json list = Json::array();
  for (const WayOfPushing& way : v.ways)
    for (const JudgedWall& wall : way.walls) {
      if (wall.is_lost() || wall.assessment.tests.empty()) continue;
      for (const DriftOfTests& t : wall.assessment.tests)
        list.push_back({{"failure", t.mechanism},
                        {"masonry", t.stone ? "stone" : "brick"},
                        {"walls", t.walls},
                        {"drift_low", number(t.low)},
                        {"drift_high", number(t.high)}});
      return list;
    }
  return list;
}

Json ways_json(const std::vector<WayOfPushing>& ways) {
  Json list = Json::array();
  for (const WayOfPushing& way : ways) {
    Json& json = list.emplace_back(
        Json{{"direction", way.direction}, {"pattern", way.pattern}, {"folder", way.folder}});
    add_counts(json, way.counts);
    json["pga_capacity_g"] = capacity_json(way.capacity, kGPerAcceleration);
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

// Parts out of plane: the result of each, and the parts that could not be checked.
Json parts_json(const WallsVerdict& v) {
  const LocalCheck* least = v.least_part();
  Json json = {{"named", v.parts.are_any_named()},
               {"least", least != nullptr ? Json(least->name) : Json(nullptr)}};
  Json &checked = json["checked"] = Json::array(), &refused = json["not_checked"] = Json::array();
  for (const LocalCheck& part : v.parts.checked) checked.push_back(io::local_json(part));
  for (const Refusal& part : v.parts.refused)
    refused.push_back({{"what", text_of(part.what)}, {"why", part.why}});
  return json;
}

// "-x" is not a formula, so it is not changed.
std::string direction_cell(const std::string& direction) {
  return direction.starts_with('[') ? io::csv_cell(direction) : direction;
}

}  // namespace

std::string verdict_json(const WallsVerdict& v) {
  Json json = {{"verdict", word_of(kAssessmentVerdictWords, v.verdict)},
               {"verdict_of_pushes", word_of(kAssessmentVerdictWords, v.of_pushes)},
               {"may_be_signed", v.may_be_signed}};
  io::put(json, "sentence", v.sentence);
  io::put(json, "cautions", v.cautions);
  io::put(json, "reason", v.reason);
  const StateVerdict& worst = v.worst;
  add_counts(json, worst.counts);
  json["pga_capacity_g"] = capacity_json(worst.capacity, kGPerAcceleration);
  json["pga_interval_of_walls_g"] =
      io::pair({worst.capacity.median.interval.low * kGPerAcceleration,
                worst.capacity.median.interval.high * kGPerAcceleration});
  json["tested_drifts"] = tests_json(v);
  json["pga_demand_g"] = number(worst.demand * kGPerAcceleration);
  json["risk_index"] = capacity_json(worst.capacity, 1 / worst.demand);
  json["decides"] = v.decides().text();
  json["direction"] = worst.direction;
  json["pattern"] = worst.pattern;
  json["failure_mode"] = {{"name", v.mode}, {"walls", v.mode_count}};
  json["code"] = v.spec.code;
  json["limit_state"] = word_of(kLimitStateWords, worst.state);
  json["confidence_factor"] = number(v.spec.confidence_factor);
  json["limit_states"] = states_json(v.limit_states);
  json["parts"] = parts_json(v);
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
      const Reading capacity = wall.capacity(v.worst.state);
      text +=
          fmt::format("{},{},{},{},{},{},{},{},{}", wall.wall, wall.seed,
                      direction_cell(way.direction), io::csv_cell(way.pattern),
                      io::csv_cell(word_of(kAssessmentVerdictWords, wall.verdict(v.worst.state))),
                      io::csv_cell(capacity.value * kGPerAcceleration), capacity.censored ? 1 : 0,
                      io::csv_cell(wall.mode), wall.is_in_plane ? 1 : 0);
      for (std::size_t s = 0; s < std::size(kLimitStateWords); ++s) {
        const LimitStateCheck* found = nullptr;
        for (const LimitStateCheck& check : wall.assessment.limit_states)
          if (check.state == static_cast<LimitState>(s)) found = &check;
        text += found == nullptr
                    ? ",,,"
                    : fmt::format(
                          ",{},{},{}", io::csv_cell(found->acceleration * kGPerAcceleration),
                          io::csv_cell(found->displacement * 1e3), io::csv_cell(found->governing));
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
