// The headline of a campaign over records: the intensity at which each limit state is reached.
#include <cmath>
#include <limits>

#include "report/headline.h"
#include "report/html.h"

namespace wythe::report {
namespace {

constexpr std::size_t kShakenSentences =
    3;  // limit states with a sentence each; more are in the cards

// The same as in headline.cpp: a number, or NaN.
double number_at(const Json& json, const std::string& key) {
  const auto found = json.find(key);
  return found != json.end() && found->is_number() ? found->get<double>()
                                                   : std::numeric_limits<double>::quiet_NaN();
}

class ShakenHeadline {
 public:
  ShakenHeadline(const Json& header, const Texts& texts)
      : s_(header.at("statistics")),
        shaking_(s_.at("shaking")),
        states_(s_.at("fragility")),
        texts_(texts),
        is_velocity_(shaking_.at("measure") == "pgv") {}

  [[nodiscard]] std::string sentence() const {
    std::string words = texts_.say("shaken.lead", {{"shakes", count("shakes")},
                                                   {"samples", count("samples")},
                                                   {"records", count("records")},
                                                   {"walls", count("walls")}});
    std::size_t told = 0;
    for (const Json& f : states_)
      if (is_told(f) && told++ < kShakenSentences)
        words += " " + texts_.say("shaken.half", {{"state", "<b>" + name_of(f) + "</b>"},
                                                  {"at", "<b>" + median(f) + "</b>"},
                                                  {"low", texts_.number(end(f, 0))},
                                                  {"high", with_unit(end(f, 1))}});
    if (told == 0) words += " " + texts_.say("shaken.nothing");
    if (const std::string how = damping(); !how.empty())
      words += " " + texts_.say("shaken.damping", {{"how", how}});
    return words;
  }
  [[nodiscard]] std::string warning() const {
    std::string words;
    const auto add = [&](const std::string& more) { words += (words.empty() ? "" : " ") + more; };
    const Json& samples = s_.at("samples");
    const int missing = samples.at("asked").get<int>() - samples.at("run").get<int>();
    if (missing > 0)
      add(texts_.say("campaign.unrun",
                     {{"missing", std::to_string(missing)},
                      {"asked", std::to_string(samples.at("asked").get<int>())}}));
    if (const std::size_t lost = shaking_.at("lost").size(); lost > 0)
      add(texts_.say("shaken.lost", {{"n", std::to_string(lost)}, {"of", count("shakes")}}));
    return words;
  }
  [[nodiscard]] std::string cards() const {
    std::vector<Card> cards;
    for (const Json& f : states_) {
      const std::string verdict = f.at("verdict");
      if (is_told(f))
        cards.push_back(
            {median(f), name_of(f),
             texts_.say("shaken.card", {{"low", texts_.number(end(f, 0))},
                                        {"high", with_unit(end(f, 1))},
                                        {"beta", texts_.number(number_at(f, "beta"), 2)}})});
      else
        cards.push_back({texts_.say("card.not_known"), name_of(f),
                         texts_.say("shaken_verdict." + underscored(verdict))});
    }
    return draw_cards(cards);
  }

 private:
  // The damping as a list of texts, each in every language where they differ (translation.h).
  [[nodiscard]] std::string damping() const {
    std::string words;
    if (!shaking_.contains("damping_of_shakes")) return words;
    for (const Json& one : shaking_.at("damping_of_shakes")) {
      const Json& text = one.is_array() ? one.at(texts_.place()) : one;
      words += (words.empty() ? "" : "; ") + escaped(text.get<std::string>());
    }
    return words;
  }
  static bool is_told(const Json& f) { return f.at("verdict") == "told"; }
  static std::string underscored(std::string word) {
    for (char& c : word)
      if (c == ' ') c = '_';
    return word;
  }
  [[nodiscard]] std::string count(const char* key) const {
    return std::to_string(shaking_.at(key).get<int>());
  }
  static std::string name_of(const Json& f) {
    return escaped(f.at("limit_state").get<std::string>());
  }
  [[nodiscard]] std::string key() const {
    return is_velocity_ ? "median_m_per_s" : "median_m_per_s2";
  }
  [[nodiscard]] std::string with_unit(double value) const {
    return std::isnan(value) ? "?" : texts_.quantity(value, is_velocity_ ? "m/s" : "m/s²");
  }
  [[nodiscard]] std::string median(const Json& f) const { return with_unit(number_at(f, key())); }
  [[nodiscard]] double end(const Json& f, std::size_t which) const {
    const Json& pair = f.at(key() + "_interval");
    return pair.at(which).is_number() ? pair.at(which).get<double>()
                                      : std::numeric_limits<double>::quiet_NaN();
  }

  const Json& s_;
  const Json& shaking_;
  const Json& states_;
  const Texts& texts_;
  bool is_velocity_;
};

}  // namespace

bool is_shaken(const Json& header) {
  return header.at("kind") == "campaign" && header.at("statistics").contains("shaking") &&
         header.at("statistics").at("shaking").contains("measure");
}

Headline shaken_headline(const Json& header, const Texts& texts) {
  const ShakenHeadline of(header, texts);
  return {of.sentence(), of.warning(), of.cards()};
}

}  // namespace wythe::report
