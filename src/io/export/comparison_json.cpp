// comparison.json: options side by side for other programs; keys in docs/reference/comparison.md.
//
// Numbers have nine significant digits; NaN and the open end of an interval are null.

#include <cmath>
#include <nlohmann/json.hpp>

#include "io/export/statistics_numbers.h"
#include "io/results/message_json.h"
#include "wythe/parts/comparison.h"
#include "wythe/parts/io.h"

namespace wythe {
namespace {

using namespace io;

Json reading_json(const std::vector<PairValue>& pairs, Reading PairValue::*side, double scale) {
  Json values = Json::array(), bounds = Json::array();
  for (const PairValue& pair : pairs) {
    values.push_back(number((pair.*side).value * scale));
    if ((pair.*side).censored) bounds.push_back(pair.sample);
  }
  return {{"value", values}, {"lower_bounds", bounds}};
}

Json gain_json(const GainAgainstInput& gain, double scale) {
  Json json = {{"input", gain.input}, {"n", gain.n}};
  add(json, "spearman", gain.spearman);
  json["p"] = number(gain.p);
  json["p_adjusted"] = number(gain.p_adjusted);
  add(json, "slope", gain.slope, scale);
  add(json, "low_third", gain.low_third, scale);
  add(json, "middle_third", gain.middle_third, scale);
  add(json, "high_third", gain.high_third, scale);
  return json;
}

Json response_json(const PairedResponse& r, const Quantity& q) {
  const double scale = q.to_unit;
  Json json = {
      {"unit", q.unit},          {"pairs", r.pairs},        {"without_value", r.without_value},
      {"with_bounds", r.bounds}, {"larger", r.larger},      {"smaller", r.smaller},
      {"equal", r.equal},        {"undecided", r.undecided}};
  json["in_means"] = r.in_means;
  json["up_to"] = number(r.up_to * scale);
  add(json, "base", r.base, scale);
  add(json, "option", r.option, scale);
  add(json, "difference", r.difference, scale);
  json["difference_bootstrap"] = pair(r.difference_bootstrap, scale);
  add(json, "ratio", r.ratio);
  json["standard_deviation"] = number(r.standard_deviation * scale);
  json["median_difference_bounds"] = pair(r.median_bounds, scale);
  json["median_difference_interval"] = pair(r.median_interval, scale);
  add(json, "share_larger", r.share_larger);
  json["share_larger_with_lost"] = pair(r.share_larger_with_lost);
  json["sign_test_p"] = number(r.sign_test_p);
  add(json, "cov_base", r.cov_base);
  add(json, "cov_option", r.cov_option);
  add(json, "cov_ratio", r.cov_ratio);
  json["correlation"] = number(r.correlation);
  json["worth"] = number(r.worth);
  json["slow_enough"] = r.slow_enough;
  add(json, "difference_slow_enough", r.difference_slow_enough, scale);
  Json gains = Json::array();
  for (const GainAgainstInput& gain : r.gain) gains.push_back(gain_json(gain, scale));
  json["gain"] = gains;
  Json samples = Json::array();
  for (const PairValue& value : r.pair) samples.push_back(value.sample);
  json["pair"] = {{"sample", samples},
                  {"base", reading_json(r.pair, &PairValue::base, scale)},
                  {"option", reading_json(r.pair, &PairValue::option, scale)}};
  return json;
}

Json shifts_json(const std::vector<ModeShift>& list) {
  Json shifts = Json::array();
  for (const ModeShift& shift : list) {
    Json& json = shifts.emplace_back(Json{{"mode", shift.mode},
                                          {"base", shift.base},
                                          {"option", shift.option},
                                          {"came", shift.came},
                                          {"went", shift.went}});
    add(json, "share_difference", shift.share_difference);
    json["p"] = number(shift.p);
    json["p_adjusted"] = number(shift.p_adjusted);
  }
  return shifts;
}

Json modes_json(const ModeTable& table) {
  Json changed = Json::array();
  for (const ChangedMode& one : table.changed)
    changed.push_back({{"sample", one.sample}, {"base", one.base}, {"option", one.option}});
  Json json = {{"modes", table.modes},           {"count", table.count},
               {"pairs", table.pairs},           {"unclear", table.unclear},
               {"read_apart", table.read_apart}, {"changed_apart", table.changed_apart}};
  add(json, "share_changed", table.share_changed);
  json["changed"] = changed;
  json["shift"] = shifts_json(table.shift);
  json["group_shift"] = shifts_json(table.group_shift);
  json["p"] = number(table.p);
  return json;
}

Json lost_json(const std::vector<LostPair>& lost) {
  Json list = Json::array();
  for (const LostPair& pair : lost) {
    Json& json = list.emplace_back(Json{{"sample", pair.sample},
                                        {"base_status", pair.base_status},
                                        {"option_status", pair.option_status},
                                        {"base_answered", pair.base_answered},
                                        {"option_answered", pair.option_answered}});
    put(json, "base_reason", pair.base_reason);
    put(json, "option_reason", pair.option_reason);
  }
  return list;
}

Json option_json(const OptionComparison& option) {
  Json json = {{"name", option.name}, {"folder", option.folder}, {"changes", option.changes}};
  if (!option.push.direction.empty()) {
    json["direction"] = option.push.direction;
    json["pattern"] = option.push.pattern;
    json["base_folder"] = option.base_folder;
  }
  put(json, "headline", option.headline);
  put(json, "notes", option.notes);
  json["pairs"] = option.pairs;
  json["lost"] = option.lost.size();
  json["base_alone"] = option.base_alone;
  json["option_alone"] = option.option_alone;
  json["not_run"] = option.not_run;
  json["not_slow_enough"] = option.not_slow_enough;
  json["too_fast"] = option.too_fast;
  json["still_rising"] = {{"base", option.rising_base}, {"option", option.rising_option}};
  json["same_bits"] = option.same_bits;
  json["steps"] = {{"base", number(option.steps_base)}, {"option", number(option.steps_option)}};
  json["lost_pairs"] = lost_json(option.lost);
  Json responses = Json::object();
  for (std::size_t q = 0; q < option.response.size(); ++q)
    responses[key_of(quantities()[q])] = response_json(option.response[q], quantities()[q]);
  json["response"] = responses;
  json["modes"] = modes_json(option.modes);
  return json;
}

Json capacity_json(const ModelCapacity& capacity) {
  constexpr double kToG = 1 / kStandardGravity;
  return {{"median", number(capacity.pga.value * kToG)},
          {"low", number(capacity.pga.interval.low * kToG)},
          {"high", number(capacity.pga.interval.high * kToG)},
          {"at_least", capacity.at_least}};
}

Json change_json(const CheckedChange& change) {
  Json ways = Json::array();
  for (std::size_t k = 0; k < change.way.size(); ++k) {
    const Change& way = change.way[k];
    Json& json = ways.emplace_back(Json{{"direction", way.push.direction},
                                        {"pattern", way.push.pattern},
                                        {"decides", k == change.worst},
                                        {"pairs", way.pairs},
                                        {"answer", word_of(kChangeAnswerWords, way.answer)},
                                        {"same", way.is_same},
                                        {"at_least", way.at_least},
                                        {"at_most", way.at_most}});
    add(json, "ratio", way.ratio);
    put(json, "why", way.why);
  }
  Json json = {{"response", key_of(quantity_named(change.quantity))},
               {"least", number(change.least)},
               {"most", number(change.most)},
               {"limit", change.is_default ? "default, not verified" : "asked"},
               {"answer", word_of(kChangeAnswerWords, change.answer)},
               {"decides", change.way[change.worst].push.text()}};
  put(json, "what", change.what);
  put(json, "decides_in_words", change.way[change.worst].push.words());
  put(json, "answer_in_words", change.said);
  json["way"] = ways;
  return json;
}

Json intervention_json(const Intervention& one, const PairedComparison& all) {
  Json json = {{"name", one.name}, {"answer", word_of(kChangeAnswerWords, one.answer)}};
  put(json, "sentence", one.sentence);
  put(json, "cautions", one.cautions);
  put(json, "notes", one.notes);
  json["option"] = Json::array();
  for (const std::size_t k : one.option) json["option"].push_back(all.option[k].name);
  json["change"] = Json::array();
  for (const CheckedChange& change : one.change) json["change"].push_back(change_json(change));
  if (!std::isnan(one.before.pga.value) || !std::isnan(one.after.pga.value))
    json["pga_capacity_g"] = {{"before", capacity_json(one.before)},
                              {"after", capacity_json(one.after)}};
  return json;
}

}  // namespace

std::string comparison_json(const PairedComparison& comparison) {
  Json inputs = Json::array();
  for (std::size_t k = 0; k < comparison.input.size(); ++k) {
    const InputColumn& column = comparison.input[k];
    Json values = Json::array();
    for (const std::vector<double>& row : comparison.value)
      values.push_back(number(row[k] * column.to_unit + column.offset));
    inputs.push_back({{"name", column.name}, {"unit", column.unit}, {"value", values}});
  }
  Json json = {{"study", comparison.study},
               {"provenance", comparison.provenance},
               {"base", {{"name", comparison.base_name}, {"folder", comparison.base_folder}}},
               {"samples", comparison.samples}};
  Json options = Json::array();
  for (const OptionComparison& option : comparison.option) options.push_back(option_json(option));
  json["option"] = options;
  if (!comparison.intervention.empty()) {
    Json& list = json["intervention"] = Json::array();
    for (const Intervention& one : comparison.intervention)
      list.push_back(intervention_json(one, comparison));
  }
  json["input"] = inputs;
  return json.dump(1) + "\n";
}

}  // namespace wythe
