#include "report/headline.h"

#include <algorithm>
#include <cmath>

#include "report/html.h"
#include "wythe/failure_mode.h"
#include "wythe/statistics.h"

namespace wythe::report {
namespace {

double number_in(const Json& json, const char* key) {
  return json.contains(key) && json[key].is_number() ? json[key].get<double>() : kUnset;
}

std::string bold(const std::string& text) { return "<b>" + text + "</b>"; }

constexpr double kFew = 0.05;  // share of lower bounds that hardly moves a mean

struct Card {
  std::string value, name, means;
};

std::string draw_cards(const std::vector<Card>& cards) {
  if (cards.empty()) return "";
  std::string out = "<section class=\"cards\">\n";
  for (const Card& c : cards)
    out += "<div class=\"card\"><div class=\"value\">" + c.value + "</div><div class=\"name\">" +
           c.name + "</div><div class=\"means\">" + c.means + "</div></div>\n";
  return out + "</section>\n";
}

// --- a run ---------------------------------------------------------------------------------------

class RunHeadline {
 public:
  RunHeadline(const Json& header, const Texts& texts)
      : header_(header), s_(header["summary"]), texts_(texts) {}

  [[nodiscard]] std::string sentence() const {
    if (pushes_by_factor())
      return texts_.say("run.factor",
                        {{"factor", bold(texts_.number(number_in(s_, "load_factor")))}}) +
             mode();
    if (!(peak() > 0))
      return texts_.say("run.unpushed",
                        {{"weight", texts_.quantity(number_in(header_, "weight_kN"), "kN")}});
    return texts_.say(is_still_rising() ? "run.resists.bound" : "run.resists",
                      {{"force", bold(kilonewtons(peak()))},
                       {"at", bold(millimetres("displacement_at_peak_mm"))},
                       {"drift", percent("drift_percent_at_peak")}}) +
           mode() + (is_still_rising() ? "" : ductility());
  }

  [[nodiscard]] std::string warning() const {
    const std::string status = s_["status"];
    if (status == "completed") return "";
    return bold(texts_.say("status." + status)) + " " +
           report::sentence(texts_.phrase(s_["reason"].get<std::string>()));
  }

  [[nodiscard]] std::string cards() const {
    if (pushes_by_factor())
      return draw_cards({{texts_.number(number_in(s_, "load_factor")), texts_.say("card.factor"),
                          texts_.say("card.factor.means")},
                         {millimetres("top_displacement_mm"), texts_.say("card.top"),
                          texts_.say("card.top.means")}});
    if (!(peak() > 0)) return "";
    const std::string rising = is_still_rising() ? "≥ " : "";
    return draw_cards(
        {{rising + kilonewtons(peak()), texts_.say("card.peak"),
          texts_.say(is_still_rising() ? "card.peak.rising" : "card.peak.means")},
         {rising + millimetres("displacement_at_peak_mm"), texts_.say("card.at_peak"),
          texts_.say("card.at_peak.means", {{"drift", percent("drift_percent_at_peak")}})},
         {bound("censored_80") + millimetres("displacement_at_80_percent_mm"),
          texts_.say("card.at_80"),
          is("censored_80")
              ? texts_.say("card.at_80.censored")
              : texts_.say("card.at_80.means", {{"drift", percent("drift_percent_at_80")}})},
         {bound("censored_max") + millimetres("displacement_max_mm"), texts_.say("card.max"),
          texts_.say(is("censored_max") ? "card.max.censored" : "card.max.means")},
         {texts_.quantity(number_in(s_, "initial_stiffness_kN_per_mm"), "kN/mm"),
          texts_.say("card.stiffness"), texts_.say("card.stiffness.means")}});
  }

 private:
  [[nodiscard]] double peak() const { return number_in(s_, "peak_reaction_kN"); }
  [[nodiscard]] bool pushes_by_factor() const {
    return !(peak() > 0) && number_in(s_, "load_factor") > 0;
  }
  [[nodiscard]] bool is(const char* key) const { return s_.value(key, false); }
  // The largest reaction is the last: a lower bound.
  [[nodiscard]] bool is_still_rising() const {
    return is("censored_max") &&
           number_in(s_, "displacement_at_peak_mm") >= number_in(s_, "displacement_max_mm");
  }
  // A push that ended early has shown no more than the beginning of a failure.
  [[nodiscard]] bool has_failed() const {
    const double read_at = number_in(s_["failure_mode"], "read_at_mm") * 1e-3;  // NaN: not read
    return s_["status"] == "collapsed" ||
           (!is("censored_80") && std::fabs(read_at) > 0 && !is_read_early(read_at, kReadModesAt));
  }
  [[nodiscard]] std::string bound(const char* key) const { return is(key) ? "≥ " : ""; }
  [[nodiscard]] std::string kilonewtons(double value) const { return texts_.quantity(value, "kN"); }
  [[nodiscard]] std::string millimetres(const char* key) const {
    return texts_.quantity(number_in(s_, key), "mm");
  }
  [[nodiscard]] std::string percent(const char* key) const {
    return texts_.quantity(number_in(s_, key), "%", 2);
  }
  [[nodiscard]] std::string ductility() const {
    return " " + texts_.say(is("censored_80") ? "run.keeps_to_end" : "run.keeps",
                            {{"at", bold(millimetres("displacement_at_80_percent_mm"))},
                             {"drift", percent("drift_percent_at_80")}});
  }
  [[nodiscard]] std::string mode() const {
    const Json& m = s_["failure_mode"];
    const std::string name = m["name"], words = m["sentence"];
    const std::string at = texts_.quantity(number_in(m, "read_at_mm"), "mm");
    if (name == "unclear")
      return " " +
             (is("censored_80") && !has_failed() ? texts_.say("run.unclear.so_far", {{"at", at}})
                                                 : texts_.say("run.unclear")) +
             (words.empty() ? "" : " " + bare(words));
    return " " +
           texts_.say(has_failed() ? "run.fails" : "run.shows",
                      {{"mode", bold(escaped(texts_.phrase(name)))}, {"at", at}}) +
           (words.empty() ? "" : ": " + escaped(texts_.phrase(words))) + ".";
  }
  [[nodiscard]] std::string bare(const std::string& words) const {
    return report::sentence(texts_.phrase(words));
  }

  const Json& header_;
  const Json& s_;
  const Texts& texts_;
};

// --- a campaign ----------------------------------------------------------------------------------

class CampaignHeadline {
 public:
  CampaignHeadline(const Json& header, const Texts& texts)
      : s_(header["statistics"]), samples_(s_["samples"]), texts_(texts) {}

  [[nodiscard]] std::string sentence() const {
    if (count("run") == 0) return texts_.say("campaign.empty");
    if (count("answered") == 0)
      return texts_.say("campaign.no_answer", {{"run", std::to_string(count("run"))}});
    return strong() + far() + fails();
  }

  [[nodiscard]] std::string warning() const {
    std::string words;
    const auto add = [&](const std::string& more) { words += (words.empty() ? "" : " ") + more; };
    const int asked = count("asked"), run = count("run"), answered = count("answered");
    if (answered < run)
      add(texts_.say("campaign.unanswered",
                     {{"missing", std::to_string(run - answered)}, {"run", std::to_string(run)}}));
    if (run < asked)
      add(texts_.say("campaign.unrun",
                     {{"missing", std::to_string(asked - run)}, {"asked", std::to_string(asked)}}));
    if (answered > 0 && answered < kFewestSamples)
      add(texts_.say(answered == 1 ? "campaign.one" : "campaign.few",
                     {{"n", std::to_string(answered)}}));
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
                                interval(peak["mean_interval"], "kN") + cov(peak)}};
    if (count("answered") >= kFewestSamples)
      cards.push_back({bound + texts_.quantity(number_in(peak, "percentile_5"), "kN"),
                       texts_.say("card.weak"), texts_.say("card.weak.means")});
    cards.push_back({(is_far_bound() ? "≥ " : "") + texts_.quantity(mean_80(), "mm"),
                     texts_.say("card.mean_80"), far_means(far)});
    cards.push_back(
        {texts_.say("card.answered.value", {{"answered", std::to_string(count("answered"))},
                                            {"asked", std::to_string(count("asked"))}}),
         texts_.say("card.answered"),
         escaped(texts_.phrase(s_["design"])) + ", " +
             texts_.say("seed", {{"seed", s_["seed"].dump()}})});
    return draw_cards(cards);
  }

 private:
  [[nodiscard]] int count(const char* key) const { return samples_.value(key, 0); }
  // Most pushes ended before their peak: the forces are lower bounds.
  [[nodiscard]] bool is_bound() const { return 2 * count("still_rising") > count("answered"); }
  [[nodiscard]] const Json& all(const char* response) const { return s_["table"]["all"][response]; }
  [[nodiscard]] double mean_80() const {
    return number_in(all("displacement_at_80_percent_mm"), "survival_mean");
  }
  [[nodiscard]] int held() const {  // samples that still held 80 % where their push ended
    return all("displacement_at_80_percent_mm").value("censored", 0);
  }
  [[nodiscard]] bool is_far_bound() const { return held() > kFew * count("answered"); }
  [[nodiscard]] std::string far_means(const Json& far) const {
    if (held() == count("answered")) return texts_.say("card.at_80.censored");
    const std::string words = interval(far.value("survival_mean_interval", Json()), "mm");
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
    const int n = far["n"], censored = far.value("censored", 0);
    if (2 * censored > n)
      return " " + texts_.say("campaign.far.beyond",
                              {{"at", bold(texts_.quantity(number_in(far, "max"), "mm"))}});
    const double height = number_in(s_, "load_height_m");
    const std::string drift =
        height > 0 ? texts_.quantity(mean_80() / height / 10, "%", 2) : std::string("–");
    const char* several = is_far_bound() ? "campaign.far.bound" : "campaign.far";
    return " " + texts_.say(n > 1 ? several : "campaign.far.one",
                            {{"mean", bold(texts_.quantity(mean_80(), "mm"))}, {"drift", drift}});
  }
  [[nodiscard]] std::string fails() const {
    std::vector<std::pair<int, std::string>> counts;
    for (const auto& [name, share] : s_["shares"].items())
      if (share["modes"].size() == 1 && share["count"] > 0 && name != "unclear")
        counts.emplace_back(-share["count"].get<int>(), name);
    std::stable_sort(counts.begin(), counts.end(),
                     [](const auto& a, const auto& b) { return a.first < b.first; });
    std::string list;
    for (std::size_t i = 0; i < std::min<std::size_t>(3, counts.size()); ++i) {
      const double share = s_["shares"][counts[i].second]["share"];
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
};

// --- a limit analysis ----------------------------------------------------------------------------

class LimitHeadline {
 public:
  LimitHeadline(const Json& header, const Texts& texts) : o_(header["opinion"]), texts_(texts) {
    for (const Json& m : o_["mechanisms"])
      if (weakest_ == nullptr ||
          number_in(m, "force_at_rest_kN") < number_in(*weakest_, "force_at_rest_kN"))
        weakest_ = &m;
  }

  [[nodiscard]] std::string sentence() const {
    std::string words;
    const auto add = [&](const std::string& more) { words += (words.empty() ? "" : " ") + more; };
    if (weakest_ != nullptr)
      add(texts_.say("limit.weakest", {{"mode", bold(mode())},
                                       {"force", bold(force())},
                                       {"hypothesis", hypothesis()},
                                       {"means", hypothesis(".means")}}));
    const Json& loads = o_["limit_loads"];
    if (loads.size() > 1)
      add(texts_.say("limit.bracket",
                     {{"low", bold(load(extreme(false)))}, {"high", bold(load(extreme(true)))}}));
    else if (!loads.empty())
      add(texts_.say("limit.single", {{"load", bold(load(loads.front()))}}));
    if (const int passed = passing(); passed >= 0)
      add(texts_.say(passed == 0 ? "limit.none_passes" : "limit.some_pass",
                     {{"n", std::to_string(passed)}}));
    return words.empty() ? texts_.say("limit.nothing") : words;
  }

  [[nodiscard]] std::string warning() const {
    const int passed = passing();
    return passed > 0 ? texts_.say("limit.warning", {{"n", std::to_string(passed)}}) : "";
  }

  [[nodiscard]] std::string cards() const {
    std::vector<Card> cards;
    if (weakest_ != nullptr)
      cards.push_back({force(), texts_.say("card.weakest"),
                       mode() + ", " + hypothesis() + ": " + hypothesis(".means")});
    for (const Json& l : o_["limit_loads"])
      cards.push_back({load(l), texts_.say("card.limit_load"),
                       escaped(texts_.phrase(l["name"].get<std::string>()))});
    return draw_cards(cards);
  }

 private:
  [[nodiscard]] std::string mode() const { return escaped((*weakest_)["mode"].get<std::string>()); }
  [[nodiscard]] std::string force() const {
    return texts_.quantity(number_in(*weakest_, "force_at_rest_kN"), "kN");
  }
  [[nodiscard]] std::string hypothesis(const std::string& what = "") const {
    return texts_.say("hypothesis." + (*weakest_)["hypothesis"].get<std::string>() + what);
  }
  [[nodiscard]] static double value_of(const Json& l) {
    return l.contains("static_kN") ? number_in(l, "static_kN") : number_in(l, "static");
  }
  [[nodiscard]] std::string load(const Json& l) const {
    return l.contains("static_kN") ? texts_.quantity(value_of(l), "kN")
                                   : "λ = " + texts_.number(value_of(l));
  }
  [[nodiscard]] const Json& extreme(bool largest) const {
    const Json& loads = o_["limit_loads"];
    const auto less = [](const Json& a, const Json& b) { return value_of(a) < value_of(b); };
    return largest ? *std::max_element(loads.begin(), loads.end(), less)
                   : *std::min_element(loads.begin(), loads.end(), less);
  }
  // Runs whose peak lies above their limit load; -1 where none was compared.
  [[nodiscard]] int passing() const {
    const Json& c = o_["comparison"];
    if (!c.is_object() || c["bounds"].empty()) return -1;
    return static_cast<int>(std::count_if(c["bounds"].begin(), c["bounds"].end(),
                                          [](const Json& b) { return !b["holds"].get<bool>(); }));
  }

  const Json& o_;
  const Texts& texts_;
  const Json* weakest_ = nullptr;
};

template <class Headline>
std::string put_together(const Json& header, const Texts& texts, const std::string& kind) {
  const Headline headline(header, texts);
  const std::string title = header.value("title", "");
  std::string out = "<header id=\"headline\">\n<p class=\"kind\">" + texts.say("kind." + kind) +
                    "</p>\n<h1>" + escaped(title.empty() ? texts.say("untitled." + kind) : title) +
                    "</h1>\n<p class=\"answer\">" + headline.sentence() + "</p>\n";
  const std::string warning = headline.warning();
  if (!warning.empty()) out += "<p class=\"warning\">" + warning + "</p>\n";
  return out + "</header>\n" + headline.cards();
}

}  // namespace

std::string headline_of(const Json& header, const Texts& texts) {
  if (header["kind"] == "campaign")
    return put_together<CampaignHeadline>(header, texts, "campaign");
  if (header["kind"] == "limit") return put_together<LimitHeadline>(header, texts, "limit");
  return put_together<RunHeadline>(header, texts, "run");
}

}  // namespace wythe::report
