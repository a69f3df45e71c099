// Writes the answer and the cards of a page as markup, from the JSON of a run, a campaign or a limit analysis.
// Reasons for doubt come before the numbers, and a lower bound is marked. A member that a run lacks reads as null,
// and its sentence is left out. Names that users give are escaped.
#include "report/headline.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <type_traits>

#include "report/html.h"
#include "wythe/parts/failure_mode.h"
#include "wythe/parts/limit.h"
#include "wythe/parts/responses.h"
#include "wythe/parts/statistics.h"

namespace wythe::report {
namespace {

// The member at "bilinear.force_kN", or null where there is none, because the origin of a page's data is unknown.
const Json& member(const Json& json, std::string path) {
  static const Json kNull;
  std::replace(path.begin(), path.end(), '.', '/');
  const Json::json_pointer place("/" + path);
  return json.contains(place) ? json[place] : kNull;
}
double number_in(const Json& json, const char* key) {
  const Json& value = member(json, key);
  return value.is_number() ? value.get<double>() : kUnset;
}
std::string words_in(const Json& json, const char* key) {
  const Json& value = member(json, key);
  return value.is_string() ? value.get<std::string>() : "";
}
// A text of the engine in the page's language; a plain text is the same in all.
std::string text_in(const Texts& texts, const Json& json, const char* key) {
  const Json& said = member(json, key);
  return said.is_array() ? said.at(texts.place()).get<std::string>() : words_in(json, key);
}
std::string bold(const std::string& text) { return "<b>" + text + "</b>"; }
// A reason for doubt, before all numbers. Mild: the numbers may still be used.
std::string caution(const std::string& text, const char* mild = "") {
  return "<strong class=\"caution" + std::string(mild) + "\">" + text + "</strong> ";
}
// The result of a code's assessment of a run or campaign, if it was asked for.
std::string assessed_in(const Texts& texts, const Json& summary) {
  const std::string words = text_in(texts, summary, "assessment.sentence");
  return words.empty() ? "" : " " + report::sentence(words);
}
constexpr double kFew = 0.05;    // share of lower bounds that hardly changes a mean
constexpr double kGap = 0.01;    // of the energy ledger; above it a run is not reliable
constexpr int kListedParts = 3;  // parts of a wall in a sentence; more are counted

// --- a run ---------------------------------------------------------------------------------------

// The responses of a summary in its units, by the table that wrote them; a missing number is NaN, a missing flag false.
Responses shown_in(const Json& summary) {
  Responses shown;
  const auto take = [&](const OutputKey& key, auto& value) {
    using Value = std::decay_t<decltype(value)>;
    if constexpr (std::is_same_v<Value, double>) value = number_in(summary, key.summary);
    if constexpr (std::is_same_v<Value, bool>) value = member(summary, key.summary) == true;
  };
  each_response(take, shown);
  return shown;
}

class RunHeadline {
 public:
  RunHeadline(const Json& header, const Texts& texts)
      : header_(header), s_(header.at("summary")), r_(shown_in(s_)), texts_(texts) {}

  [[nodiscard]] std::string sentence() const {
    return cautions() + answer() + fallen() + assessed_in(texts_, s_) + tests();
  }

  [[nodiscard]] std::string warning() const {
    const std::string status = words_in(s_, "status"), reason = text_in(s_, "reason");
    if (status == "completed" || (status.empty() && reason.empty())) return "";
    return bold(texts_.say("status." + status)) + " " + report::sentence(reason);
  }

  [[nodiscard]] std::string cards() const {
    if (pushes_by_factor()) return draw_cards(cards_of_factor());
    if (has_no_capacity()) return draw_cards(cards_without_capacity());
    if (!(r_.peak_reaction > 0)) return "";
    const std::string rising = bound(r_.censored_peak);
    return draw_cards(
        {{rising + kilonewtons(r_.peak_reaction), texts_.say("card.peak"),
          texts_.say(r_.censored_peak ? "card.peak.rising" : "card.peak.means")},
         {rising + millimetres(r_.displacement_at_peak), texts_.say("card.at_peak"),
          texts_.say("card.at_peak.means") + drift(r_.drift_at_peak, "; ")},
         {bound(r_.censored_80) + millimetres(r_.displacement_at_80), texts_.say("card.at_80"),
          r_.censored_80 ? texts_.say("card.at_80.censored")
                         : texts_.say("card.at_80.means") + drift(r_.drift_at_80, "; ")},
         {bound(r_.censored_max) + millimetres(r_.displacement_max), texts_.say("card.max"),
          texts_.say(r_.censored_max ? "card.max.censored" : "card.max.means")},
         stiffness_card()});
  }

 private:
  [[nodiscard]] bool pushes_by_factor() const {
    return number_in(s_, "load_factor") > 0 && words_in(s_, "curve_of") != "push";
  }
  // Forces were read, but the ground carried none of them.
  [[nodiscard]] bool has_no_capacity() const {
    return !(r_.peak_reaction > 0) && !pushes_by_factor() && r_.peak_raw > 0;
  }
  // A push that ended early shows only the beginning of a failure.
  [[nodiscard]] bool has_failed() const {
    const double read_at = number_in(s_, "failure_mode.read_at_mm") * 1e-3;  // NaN: not evaluated
    return words_in(s_, "status") == "collapsed" ||
           (!r_.censored_80 && std::fabs(read_at) > 0 && !is_read_early(read_at, kReadModesAt));
  }
  [[nodiscard]] static std::string bound(bool censored) { return censored ? "≥ " : ""; }
  [[nodiscard]] std::string kilonewtons(double value) const { return texts_.quantity(value, "kN"); }
  [[nodiscard]] std::string millimetres(double value) const { return texts_.quantity(value, "mm"); }
  // "; drift 0.25 %" where the drift is known.
  [[nodiscard]] std::string drift(double percent, const std::string& before,
                                  const char* words = "card.drift") const {
    if (!(percent > 0)) return "";
    return before + texts_.say(words, {{"drift", texts_.quantity(percent, "%", 2)}});
  }

  [[nodiscard]] std::string cautions() const {
    std::string words;
    const auto add = [&](const std::string& more) { words += caution(more); };
    const std::string status = words_in(s_, "status");
    if (!status.empty() && status != "completed" && status != "collapsed")
      add(texts_.say("status." + status));
    const std::string judgement = words_in(s_, "quasi_static.judgement");
    if (judgement == "too fast") add(texts_.say("run.too_fast"));
    if (judgement == "usable") words += caution(texts_.say("run.usable"), " mild");
    if (judgement == "slow enough" &&
        words_in(s_, "quasi_static.displacement.verdict") == "not known")
      words += caution(texts_.say("run.no_drift"), " mild");
    const double gap = std::fabs(number_in(s_, "energy_J.gap_ratio"));
    const bool is_none = std::isnan(gap) && member(s_, "energy_J").contains("gap_ratio");
    if (is_none || (judgement == "unknown" && !(gap > kGap))) add(texts_.say("run.unknown_rate"));
    if (gap > kGap)
      add(texts_.say("run.energy_gap", {{"gap", texts_.quantity(100 * gap, "%", 2)}}));
    if (const double at = lost(false); std::isfinite(at))
      add(texts_.say("run.slid_off", {{"at", millimetres(at)}}));
    return words;
  }
  [[nodiscard]] double lost(bool late) const {  // where blocks slid off, before the peak or late
    const double at = number_in(s_, "validity.overlap_lost_at_mm");
    return late == (std::fabs(at) > std::fabs(r_.displacement_at_peak)) ? at : kUnset;
  }
  [[nodiscard]] std::string fallen() const {
    if (const double at = lost(true); std::isfinite(at))
      return " " + texts_.say("run.slid_off_later", {{"at", millimetres(at)}});
    const auto of = [&](const char* key) { return number_in(member(s_, "debris"), key); };
    if (!(of("blocks") > 0)) return "";
    return " " + texts_.say(of("load_off_kN") > 0 ? "run.debris_and_load" : "run.debris",
                            {{"blocks", texts_.number(of("blocks"))},
                             {"volume", texts_.quantity(of("volume_m3"), "m³")},
                             {"reach", texts_.quantity(of("reach_m"), "m", 2)},
                             {"load", texts_.quantity(of("load_off_kN"), "kN")}});
  }
  [[nodiscard]] std::string tests() const {  // how far tested walls support it
    const std::string note = text_in(s_, "tested_range.note");
    return note.empty() ? "" : " " + texts_.say("run.tests", {{"note", escaped(note)}});
  }

  [[nodiscard]] std::string answer() const {
    if (pushes_by_factor())
      return texts_.say("run.factor",
                        {{"factor", bold(texts_.number(number_in(s_, "load_factor")))},
                         {"tilt", tilt()}}) +
             mode();
    if (has_no_capacity())
      return texts_.say("run.no_capacity",
                        {{"reason", why_no_capacity()}, {"raw", kilonewtons(r_.peak_raw)}}) +
             mode();
    const std::string shaken = text_in(s_, "shaking.sentence");
    if (!(r_.peak_reaction > 0) && !shaken.empty()) return report::sentence(shaken);
    if (!(r_.peak_reaction > 0)) {
      const bool fell = words_in(s_, "status") == "collapsed";
      return (fell ? caution(texts_.say("run.fell")) : "") +
             texts_.say(fell ? "run.weighs" : "run.unpushed",
                        {{"weight", texts_.quantity(number_in(header_, "weight_kN"), "kN")}});
    }
    return texts_.say(r_.censored_peak ? "run.resists.bound" : "run.resists",
                      {{"force", bold(kilonewtons(r_.peak_reaction))},
                       {"at", bold(millimetres(r_.displacement_at_peak))},
                       {"drift", drift(r_.drift_at_peak, " ", "run.drift")}}) +
           flat() + both_ways() + mode() + (r_.censored_peak ? "" : ductility());
  }
  // A flat curve has no unique displacement at its peak.
  [[nodiscard]] std::string flat() const {
    const Json& flat = member(s_, "flat_peak");
    if (member(flat, "says_little") != true || r_.censored_peak) return "";
    const bool is_bound = member(flat, "is_bound") == true;
    return " " + texts_.say(is_bound ? "run.flat.bound" : "run.flat",
                            {{"from", millimetres(number_in(flat, "from_mm"))},
                             {"to", millimetres(number_in(flat, "to_mm"))},
                             {"share", texts_.number(100 * number_in(flat, "share"))}});
  }
  // ", a tilt of 14°" if the ground was tilted.
  [[nodiscard]] std::string tilt() const {
    const double degrees = number_in(s_, "tilt_degrees");
    if (!(degrees > 0)) return "";
    return texts_.say("run.tilt", {{"tilt", bold(texts_.number(degrees) + "°")}});
  }
  [[nodiscard]] std::vector<Card> cards_of_factor() const {
    std::vector<Card> cards = {{texts_.number(number_in(s_, "load_factor")),
                                texts_.say("card.factor"), texts_.say("card.factor.means")}};
    if (const double degrees = number_in(s_, "tilt_degrees"); degrees > 0)
      cards.push_back(
          {texts_.number(degrees) + "°", texts_.say("card.tilt"), texts_.say("card.tilt.means")});
    if (r_.peak_reaction > 0)
      cards.push_back({kilonewtons(r_.peak_reaction), texts_.say("card.carried"),
                       texts_.say("card.carried.means")});
    cards.push_back({millimetres(number_in(s_, "top_displacement_mm")), texts_.say("card.top"),
                     texts_.say("card.top.means")});
    return cards;
  }
  [[nodiscard]] std::string why_no_capacity() const {
    const std::string reason = text_in(s_, "peak_reason");
    return reason.empty() ? texts_.say("run.no_capacity.reason") : escaped(reason);
  }
  [[nodiscard]] std::vector<Card> cards_without_capacity() const {
    return {{texts_.say("card.not_known"), texts_.say("card.peak"), why_no_capacity()},
            {kilonewtons(r_.peak_raw), texts_.say("card.raw"), texts_.say("card.raw.means")},
            stiffness_card()};
  }
  [[nodiscard]] Card stiffness_card() const {
    const std::string reason = text_in(s_, "initial_stiffness_reason");
    return {texts_.quantity(r_.initial_stiffness, "kN/mm"), texts_.say("card.stiffness"),
            reason.empty() ? texts_.say("card.stiffness.means") : escaped(reason)};
  }
  // A cyclic push: the direction of the results, and the resistance in the other one.
  [[nodiscard]] std::string both_ways() const {
    const Json& cyclic = member(s_, "cyclic");
    const std::string read_in = words_in(cyclic, "read_in");
    if (read_in.empty()) return "";
    const bool along = read_in == "positive";
    const Json& other = member(cyclic, along ? "negative" : "positive");
    const double force = number_in(other, "peak_reaction_kN");
    std::string words = " " + texts_.say(along ? "run.cyclic.along" : "run.cyclic.against");
    if (force > 0)
      words += " " + texts_.say("run.cyclic.other",
                                {{"force", kilonewtons(force)},
                                 {"at", millimetres(number_in(other, "displacement_at_peak_mm"))}});
    return words;
  }
  [[nodiscard]] std::string ductility() const {
    if (std::isnan(r_.displacement_at_80)) return "";
    const char* words = !r_.censored_80        ? "run.keeps"
                        : r_.censored_first_80 ? "run.keeps_to_end"
                                               : "run.falls_at_end";
    return " " +
           texts_.say(words, {{"at", bold(millimetres(r_.displacement_at_80))},
                              {"drift", drift(r_.drift_at_80, " ", "run.drift")}}) +
           dips(true) + dips(false) + threshold() + tested_drift();
  }
  // The deepest fall that the wall recovered from, before its peak or after it. It is not the end of its capacity.
  [[nodiscard]] std::string dips(bool before) const {
    const Json* deepest = nullptr;
    std::size_t count = 0;
    for (const Json& dip : member(s_, "drift_capacity.dips")) {
      if ((member(dip, "before_peak") == true) != before) continue;
      ++count;
      if (deepest == nullptr || number_in(dip, "lowest_left") < number_in(*deepest, "lowest_left"))
        deepest = &dip;
    }
    if (deepest == nullptr) return "";
    const char* one = before ? "run.dip.before" : "run.dip";
    const char* many = before ? "run.dips.before" : "run.dips";
    const auto [from, back] =
        ends_of(number_in(*deepest, "from_mm"), number_in(*deepest, "back_mm"));
    return " " + texts_.say(
                     count > 1 ? many : one,
                     {{"n", std::to_string(count)},
                      {"lowest", texts_.quantity(1e2 * number_in(*deepest, "lowest_left"), "%", 2)},
                      {"from", from},
                      {"back", back}});
  }
  // Two displacements [mm], with as many digits as tell them apart: a brittle crack's dip is a hundredth long.
  [[nodiscard]] std::pair<std::string, std::string> ends_of(double from, double back) const {
    const auto both = [&](int digits) {
      return std::pair(texts_.quantity(from, "mm", digits), texts_.quantity(back, "mm", digits));
    };
    for (int digits = 3; digits < 9; ++digits)
      if (const auto ends = both(digits); ends.first != ends.second) return ends;
    return both(3);
  }
  [[nodiscard]] std::string tested_drift() const {
    const std::string note = text_in(s_, "tested_range.drift.note");
    return note.empty() ? "" : " " + report::sentence(note);
  }
  [[nodiscard]] std::string threshold() const {
    const Json& capacity = member(s_, "drift_capacity");
    if (member(capacity, "threshold_decides") != true) return "";
    const auto at = [&](double left) -> std::string {
      const Json &lefts = member(capacity, "left"), &lasting = member(capacity, "lasting_mm");
      for (std::size_t k = 0; k < lefts.size() && k < lasting.size(); ++k)
        if (lefts[k] == left && lasting[k].is_number())
          return (member(capacity, "censored")[k] == true ? "≥ " : "") +
                 millimetres(lasting[k].get<double>());
      return "–";
    };
    return " " + texts_.say("run.threshold", {{"at_85", at(0.85)}, {"at_75", at(0.75)}});
  }

  [[nodiscard]] std::string mode() const {
    const std::string name = words_in(s_, "failure_mode.name");
    const std::string words = text_in(header_, "mode.brief");
    const std::string at = millimetres(number_in(s_, "failure_mode.read_at_mm"));
    if (name == "unclear" || name.empty())
      return " " +
             (r_.censored_80 && !has_failed() ? texts_.say("run.unclear.so_far", {{"at", at}})
                                              : texts_.say("run.unclear")) +
             (words.empty() ? "" : " " + report::sentence(words));
    return " " +
           texts_.say(has_failed() ? "run.fails" : "run.shows",
                      {{"mode", bold(escaped(name_words(name)))}, {"at", at}}) +
           meaning(words) + ".";
  }
  [[nodiscard]] std::string name_words(const std::string& name) const {
    const std::string words = text_in(header_, "mode.words");
    return words.empty() ? texts_.phrase(name) : words;
  }
  // ": the piers rock"; for a wall of many parts their number, because the table below names them.
  [[nodiscard]] std::string meaning(const std::string& words) const {
    if (words.empty()) return "";
    int damaged = 0;
    for (const Json& e : member(s_, "failure_mode.elements"))
      damaged += words_in(e, "state") != "intact" ? 1 : 0;
    const bool is_list = member(header_, "mode.lists_parts") == true;
    if (!is_list || damaged <= kListedParts) return ": " + escaped(words);
    const std::string mechanism = words_in(s_, "failure_mode.mechanism.name");
    if (!mechanism.empty() && mechanism != "none" && mechanism != "unclear")
      return ": " + escaped(text_in(header_, "mode.mechanism"));
    return ": " + parts();
  }
  [[nodiscard]] std::string parts() const {
    std::string list;
    int kinds = 0;
    for (const char* kind : {"pier", "spandrel", "connection", "toe"}) {
      if (kinds == 2) break;
      int of = 0, n = 0;
      for (const Json& e : member(s_, "failure_mode.elements")) {
        if (words_in(e, "kind") != kind) continue;
        ++of;
        n += words_in(e, "state") != "intact" ? 1 : 0;
      }
      if (n == 0) continue;
      ++kinds;
      list += (list.empty() ? "" : ", ") +
              texts_.say("parts." + std::string(kind),
                         {{"n", std::to_string(n)}, {"of", std::to_string(of)}});
    }
    return texts_.say("parts.damaged", {{"list", list}});
  }

  [[nodiscard]] std::string text_in(const Json& json, const char* key) const {
    return report::text_in(texts_, json, key);
  }

  const Json& header_;
  const Json& s_;
  const Responses r_;  // in the units of the summary
  const Texts& texts_;
};

// --- a campaign ----------------------------------------------------------------------------------

class CampaignHeadline {
 public:
  CampaignHeadline(const Json& header, const Texts& texts)
      : s_(header.at("statistics")), samples_(s_.at("samples")), texts_(texts) {
    count_judgements(member(header, "samples"));
  }

  [[nodiscard]] std::string sentence() const {
    if (count("run") == 0) return texts_.say("campaign.empty");
    if (count("answered") == 0)
      return texts_.say("campaign.no_answer", {{"run", std::to_string(count("run"))}});
    if (without_force_ == count("answered"))
      return cautions() + texts_.say("campaign.no_capacity") + fails();
    return cautions() + strong() + far() + fails() + assessed_in(texts_, s_);
  }

  [[nodiscard]] std::string warning() const {
    std::string words;
    const auto add = [&](const std::string& more) { words += (words.empty() ? "" : " ") + more; };
    const int asked = count("asked"), run = count("run"), answered = count("answered");
    if (answered < run)
      add(texts_.say("campaign.unanswered",
                     {{"missing", std::to_string(run - answered)}, {"run", std::to_string(run)}}));
    if (const int fell = count("collapsed_before_push"); fell > 0)
      add(texts_.say("campaign.before_push", {{"n", std::to_string(fell)}}));
    if (run < asked)
      add(texts_.say("campaign.unrun",
                     {{"missing", std::to_string(asked - run)}, {"asked", std::to_string(asked)}}));
    if (answered > 0 && answered < kFewestSamples)
      add(texts_.say(answered == 1 ? "campaign.one" : "campaign.few",
                     {{"n", std::to_string(answered)}}));
    if (judged("usable") > 0) add(of_all("campaign.usable", judged("usable")));
    for (const auto& [key, text] : {std::pair{"still_rising", "campaign.still_rising"},
                                    std::pair{"named_earlier", "campaign.named_earlier"}})
      if (answered > 0 && count(key) > 0)
        add(texts_.say(text, {{"n", std::to_string(count(key))},
                              {"of", std::to_string(answered)},
                              {"at", texts_.quantity(number_in(s_, "read_modes_at_mm"), "mm")}}));
    return words;
  }

  [[nodiscard]] std::string cards() const {
    if (count("answered") == 0) return "";
    const Json &peak = all("peak_reaction_kN"), &far = all("displacement_at_80_percent_mm");
    const std::string bound = is_bound() ? "≥ " : "";
    std::vector<Card> cards = {{bound + texts_.quantity(number_in(peak, "mean"), "kN"),
                                texts_.say("card.mean_peak"),
                                interval(member(peak, "mean_interval"), "kN") + cov(peak)}};
    if (count("answered") >= kFewestSamples)
      cards.push_back({bound + texts_.quantity(number_in(peak, "percentile_5"), "kN"),
                       texts_.say("card.weak"), texts_.say("card.weak.means")});
    cards.push_back({(is_far_bound() ? "≥ " : "") + texts_.quantity(mean_80(), "mm"),
                     texts_.say("card.mean_80"), far_means(far)});
    cards.push_back(
        {texts_.say("card.answered.value", {{"answered", std::to_string(count("answered"))},
                                            {"asked", std::to_string(count("asked"))}}),
         texts_.say("card.answered"),
         escaped(texts_.phrase(s_.at("design"))) + ", " +
             texts_.say("seed", {{"seed", s_.at("seed").dump()}})});
    return draw_cards(cards);
  }

 private:
  void count_judgements(const Json& samples) {
    for (const auto& [judgement, n] : member(samples_, "judgements").items())
      if (n.is_number()) judgements_[judgement] = n.get<int>();
    for (const Json& sample : samples) {
      if (!member(sample, "answered").is_boolean() || !sample.at("answered").get<bool>()) continue;
      const Json& response = member(sample, "response");
      without_force_ += response.is_array() && !response.empty() && response[0].is_null() ? 1 : 0;
    }
  }
  [[nodiscard]] int judged(const char* judgement) const {
    const auto at = judgements_.find(judgement);
    return at == judgements_.end() ? 0 : at->second;
  }
  [[nodiscard]] std::string of_all(const char* text, int n) const {
    return texts_.say(text, {{"n", std::to_string(n)}, {"of", std::to_string(count("answered"))}});
  }
  [[nodiscard]] std::string cautions() const {
    std::string words;
    for (const auto& [n, text] : {std::pair{judged("too fast"), "campaign.too_fast"},
                                  std::pair{judged("unknown"), "campaign.unknown_rate"},
                                  std::pair{without_force_, "campaign.without_force"}})
      if (n > 0) words += caution(of_all(text, n));
    return words;
  }
  [[nodiscard]] int count(const char* key) const { return samples_.value(key, 0); }
  // Whether most pushes ended before their peak, so that forces are lower bounds.
  [[nodiscard]] bool is_bound() const { return 2 * count("still_rising") > count("answered"); }
  [[nodiscard]] const Json& all(const char* response) const {
    return s_.at("table").at("all").at(response);
  }
  [[nodiscard]] double mean_80() const {
    return number_in(all("displacement_at_80_percent_mm"), "survival_mean");
  }
  [[nodiscard]] int held() const {  // samples that still carried 80 % at the end of their push
    return all("displacement_at_80_percent_mm").value("censored", 0);
  }
  [[nodiscard]] bool is_far_bound() const { return held() > kFew * count("answered"); }
  [[nodiscard]] std::string far_means(const Json& far) const {
    if (held() == count("answered")) return texts_.say("card.at_80.censored");
    const std::string words = interval(member(far, "survival_mean_interval"), "mm");
    if (held() == 0) return words;
    return words + "; " +
           texts_.say("card.bounds",
                      {{"n", std::to_string(held())}, {"of", std::to_string(count("answered"))}});
  }
  [[nodiscard]] std::string interval(const Json& pair, const char* unit) const {
    if (!pair.is_array() || !pair[0].is_number() || !pair[1].is_number())
      return texts_.say("card.no_interval");
    return texts_.say("card.interval", {{"low", texts_.number(pair[0])},
                                        {"high", texts_.quantity(pair[1].get<double>(), unit)}});
  }
  [[nodiscard]] std::string cov(const Json& cell) const {
    const double value = number_in(cell, "cov");
    return std::isnan(value) ? "" : "; CoV " + texts_.number(value, 2);
  }

  [[nodiscard]] std::string strong() const {
    const Json& peak = all("peak_reaction_kN");
    const std::string mean = bold(texts_.quantity(number_in(peak, "mean"), "kN"));
    if (count("answered") == 1)
      return texts_.say(is_bound() ? "campaign.strong.one.bound" : "campaign.strong.one",
                        {{"mean", mean}});
    const double low = number_in(peak, "percentile_5");
    return texts_.say(is_bound() ? "campaign.strong.bound" : "campaign.strong",
                      {{"n", std::to_string(count("answered"))},
                       {"mean", mean},
                       {"low", bold(is_bound() ? texts_.quantity(low, "kN") : texts_.number(low))},
                       {"high", bold(texts_.quantity(number_in(peak, "percentile_95"), "kN"))}});
  }
  [[nodiscard]] std::string far() const {
    const Json& far = all("displacement_at_80_percent_mm");
    const int n = far.value("n", 0), censored = far.value("censored", 0);
    if (n == 0) return "";
    if (2 * censored > n)
      return " " + texts_.say("campaign.far.beyond",
                              {{"at", bold(texts_.quantity(number_in(far, "max"), "mm"))}});
    const double height = number_in(s_, "load_height_m");
    const std::string drift =
        height > 0 ? " " + texts_.say("run.drift",
                                      {{"drift", texts_.quantity(mean_80() / height / 10, "%", 2)}})
                   : "";
    const char* several = is_far_bound() ? "campaign.far.bound" : "campaign.far";
    return " " + texts_.say(n > 1 ? several : "campaign.far.one",
                            {{"mean", bold(texts_.quantity(mean_80(), "mm"))}, {"drift", drift}});
  }
  [[nodiscard]] std::string fails() const {
    std::vector<std::pair<int, std::string>> counts;
    for (const auto& [name, share] : s_.at("shares").items())
      if (share.at("modes").size() == 1 && share.at("count") > 0 && name != "unclear")
        counts.emplace_back(-share.at("count").get<int>(), name);
    std::stable_sort(counts.begin(), counts.end(),
                     [](const auto& a, const auto& b) { return a.first < b.first; });
    std::string list;
    for (std::size_t i = 0; i < std::min<std::size_t>(3, counts.size()); ++i) {
      const double share = s_.at("shares").at(counts[i].second).at("share");
      list += (i == 0 ? "" : ", ") + bold(escaped(texts_.phrase(counts[i].second))) + " (" +
              texts_.quantity(100 * share, "%", 2) + ")";
    }
    const bool early = 2 * std::max(held(), count("named_earlier")) > count("answered");
    return list.empty()
               ? ""
               : " " + texts_.say(early ? "campaign.shows" : "campaign.fails", {{"modes", list}});
  }

  const Json& s_;
  const Json& samples_;
  const Texts& texts_;
  std::map<std::string, int> judgements_;  // of the answered samples
  int without_force_ = 0;                  // of them those without a force in balance
};

// --- a limit analysis ----------------------------------------------------------------------------

class LimitHeadline {
 public:
  LimitHeadline(const Json& header, const Texts& texts) : o_(header.at("opinion")), texts_(texts) {
    for (const Json& m : o_.at("mechanisms"))
      if (weakest_ == nullptr ||
          number_in(m, "force_at_rest_kN") < number_in(*weakest_, "force_at_rest_kN"))
        weakest_ = &m;
  }

  [[nodiscard]] std::string sentence() const {
    std::string words;
    const auto add = [&](const std::string& more) { words += (words.empty() ? "" : " ") + more; };
    if (const int passed = passing(); passed > 0)
      add(texts_.say("limit.some_pass", {{"n", std::to_string(passed)}}));
    if (weakest_ != nullptr)
      add(texts_.say("limit.weakest", {{"mode", bold(mode())},
                                       {"force", bold(force())},
                                       {"hypothesis", hypothesis()},
                                       {"means", hypothesis(".means")}}));
    const Json& loads = o_.at("limit_loads");
    if (loads.size() > 1 && load(extreme(false)) != load(extreme(true)))
      add(texts_.say("limit.bracket",
                     {{"low", bold(load(extreme(false)))}, {"high", bold(load(extreme(true)))}}));
    else if (!loads.empty())  // where joints have no bond, all strengths may give one load
      add(texts_.say("limit.single", {{"load", bold(load(loads.front()))}}));
    if (passing() == 0) add(texts_.say("limit.none_passes"));
    if (const Json* part = worst_part(); part != nullptr) {
      const std::string said = escaped(text_in(texts_, *part, "sentence"));
      add(words.empty() ? said + "." : "<br>" + said + ".");
    }
    return words.empty() ? texts_.say("limit.nothing") : words;
  }

  [[nodiscard]] std::string warning() const {
    const int passed = passing();
    return passed > 0
               ? texts_.say("limit.warning", {{"n", std::to_string(passed)},
                                              {"allowance", texts_.number(1e2 * kBoundTolerance)}})
               : "";
  }

  [[nodiscard]] std::string cards() const {
    std::vector<Card> cards;
    if (weakest_ != nullptr)
      cards.push_back({force(), texts_.say("card.weakest"),
                       mode() + ", " + hypothesis() + ": " + hypothesis(".means")});
    for (const Json& l : o_.at("limit_loads"))
      cards.push_back({load(l), texts_.say("card.limit_load"),
                       escaped(texts_.phrase(l.at("name").get<std::string>()))});
    return draw_cards(cards);
  }

 private:
  [[nodiscard]] std::string mode() const {
    return escaped((*weakest_).at("mode").get<std::string>());
  }
  [[nodiscard]] std::string force() const {
    return texts_.quantity(number_in(*weakest_, "force_at_rest_kN"), "kN");
  }
  [[nodiscard]] std::string hypothesis(const std::string& what = "") const {
    return texts_.say("hypothesis." + (*weakest_).at("hypothesis").get<std::string>() + what);
  }
  [[nodiscard]] static double value_of(const Json& l) {
    return l.contains("static_kN") ? number_in(l, "static_kN") : number_in(l, "static");
  }
  [[nodiscard]] std::string load(const Json& l) const {
    return l.contains("static_kN") ? texts_.quantity(value_of(l), "kN")
                                   : "λ = " + texts_.number(value_of(l));
  }
  [[nodiscard]] const Json& extreme(bool largest) const {
    const Json& loads = o_.at("limit_loads");
    const auto less = [](const Json& a, const Json& b) { return value_of(a) < value_of(b); };
    return largest ? *std::max_element(loads.begin(), loads.end(), less)
                   : *std::min_element(loads.begin(), loads.end(), less);
  }
  // The part out of plane with the least reserve; a part without a demand comes last.
  [[nodiscard]] const Json* worst_part() const {
    const Json* worst = nullptr;
    double least = std::numeric_limits<double>::infinity();
    for (const Json& part : member(o_, "local")) {
      double reserve = std::numeric_limits<double>::max();
      if (part.at("verdict") == "fails" && part.at("limit_states").empty()) reserve = 0;
      for (const Json& s : part.at("limit_states"))
        if (s.at("pga_capacity_g").is_number())
          reserve =
              std::min(reserve, number_in(s, "pga_capacity_g") / number_in(s, "pga_demand_g"));
      if (reserve < least) least = reserve, worst = &part;
    }
    return worst;
  }
  // Number of runs with a peak above their limit load; -1 where none was compared.
  [[nodiscard]] int passing() const {
    const Json& c = o_.at("comparison");
    if (!c.is_object() || c.at("bounds").empty()) return -1;
    return static_cast<int>(
        std::count_if(c.at("bounds").begin(), c.at("bounds").end(),
                      [](const Json& b) { return !b.at("holds").get<bool>(); }));
  }

  const Json& o_;
  const Texts& texts_;
  const Json* weakest_ = nullptr;
};

template <class OfKind>
Headline made(const Json& header, const Texts& texts) {
  const OfKind of(header, texts);
  return {of.sentence(), of.warning(), of.cards()};
}

}  // namespace

std::string headline_of(const Json& header, const Texts& texts) {
  const std::string kind = is_shaken(header) ? "shaken" : header.at("kind").get<std::string>();
  const Headline headline = kind == "shaken"       ? shaken_headline(header, texts)
                            : kind == "campaign"   ? made<CampaignHeadline>(header, texts)
                            : kind == "limit"      ? made<LimitHeadline>(header, texts)
                            : kind == "comparison" ? comparison_headline(header, texts)
                                                   : made<RunHeadline>(header, texts);
  const std::string title = header.value("title", "");
  std::string out = "<header id=\"headline\">\n<p class=\"kind\">" +
                    texts.say("kind." + (is_one_shake(header) ? "shake" : kind)) + "</p>\n<h1>" +
                    escaped(title.empty() ? texts.say("untitled." + kind) : title) +
                    "</h1>\n<p class=\"answer\">" + headline.sentence + "</p>\n";
  if (!headline.warning.empty()) out += "<p class=\"warning\">" + headline.warning + "</p>\n";
  return out + "</header>\n" + headline.cards;
}

}  // namespace wythe::report
