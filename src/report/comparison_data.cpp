// comparison_data(): the data for the page of options side by side, as in comparison.json, and its headline.
#include <algorithm>
#include <filesystem>

#include "core/decimal_point.h"
#include "report/bundle.h"
#include "report/headline.h"
#include "report/html.h"
#include "report/translation.h"
#include "wythe/parts/comparison.h"
#include "wythe/parts/io.h"
#include "wythe/parts/provenance.h"
#include "wythe/parts/report.h"

namespace wythe {
namespace report {
namespace {

constexpr std::size_t kSentences = 4;  // options with a sentence each; more are in the cards

// A message in the language of the page, as markup.
std::string words_of(const Json& words, const Texts& texts) {
  if (words.is_string()) return sentence(words.get<std::string>());
  return words.is_array() && texts.place() < words.size()
             ? sentence(words[texts.place()].get<std::string>())
             : "";
}

// The same without capital and full stop.
std::string plain(const Json& words, const Texts& texts) {
  return escaped((words.is_array() ? words.at(texts.place()) : words).get<std::string>());
}

std::string change_of(const Json& ratio, const Texts& texts) {
  if (!ratio.is_number()) return texts.say("card.not_known");
  const double percent = 100 * (ratio.get<double>() - 1);
  return (percent > 0 ? "+" : "") + texts.quantity(percent, "%");
}

Card card_of(const Json& option, const Texts& texts) {
  const Json& peak = option.at("response").at("peak_reaction_kN");
  const std::string name = escaped(option.at("name").get<std::string>());
  const Json& interval = peak.at("ratio_interval");
  if (peak.at("with_bounds") > 0)  // a change of the other pairs alone would pass for that of all
    return {texts.say("card.not_known"), texts.say("card.peak_change", {{"option", name}}),
            texts.say("card.bounds",
                      {{"n", peak.at("with_bounds").dump()}, {"of", peak.at("pairs").dump()}})};
  std::string means = texts.say("card.no_interval");
  if (option.at("pairs") == 0)
    means = texts.say("card.no_pairs");
  else if (interval.at(0).is_number() && interval.at(1).is_number())
    means = texts.say("card.interval", {{"low", change_of(interval[0], texts)},
                                        {"high", change_of(interval[1], texts)}});
  return {change_of(peak.at("ratio"), texts), texts.say("card.peak_change", {{"option", name}}),
          means};
}

// Cards for a model against the one before: its changes in the way of pushing that decides.
std::vector<Card> cards_of(const Json& intervention, const Texts& texts) {
  std::vector<Card> cards;
  for (const Json& change : intervention.at("change")) {
    const Json& ways = change.at("way");
    const Json& way = *std::find_if(ways.begin(), ways.end(),
                                    [](const Json& w) { return w.at("decides") == true; });
    const Json& interval = way.at("ratio_interval");
    const bool has_interval = interval.at(0).is_number() && interval.at(1).is_number();
    const std::string bound = way.at("at_least") == true  ? "≥ "
                              : way.at("at_most") == true ? "≤ "
                                                          : "";
    const bool known = way.at("answer") != "not known";
    cards.push_back(
        {known ? bound + change_of(way.at("ratio"), texts) : texts.say("card.not_known"),
         plain(change.at("what"), texts) + ", " + plain(change.at("decides_in_words"), texts) +
             ": <b>" + plain(change.at("answer_in_words"), texts) + "</b>",
         !known || !bound.empty() ? ""
         : has_interval ? texts.say("card.interval", {{"low", change_of(interval[0], texts)},
                                                      {"high", change_of(interval[1], texts)}})
                        : texts.say("card.no_interval")});
  }
  return cards;
}

// Pages are passed on, so of a folder only its own name is kept.
void drop_folders(Json& comparison) {
  const auto shorten = [](Json& of) {
    std::filesystem::path path(of.at("folder").get<std::string>());
    if (!path.has_filename()) path = path.parent_path();  // "out/base/"
    of["folder"] = path.filename().string();
  };
  if (comparison.contains("intervention"))
    return;  // they are inside the folder, and named by their way of pushing
  shorten(comparison["base"]);
  for (Json& option : comparison["option"]) shorten(option);
}

}  // namespace

Headline comparison_headline(const Json& header, const Texts& texts) {
  const Json& comparison = header.at("comparison");
  const Json& options = comparison.at("option");
  Headline out;
  if (comparison.contains("intervention")) {
    std::vector<Card> cards;
    for (const Json& one : comparison.at("intervention")) {
      out.sentence += (out.sentence.empty() ? "" : "<br>") + words_of(one.at("sentence"), texts);
      for (Card& card : cards_of(one, texts)) cards.push_back(std::move(card));
      for (const Json& note : one.at("notes"))
        out.warning += (out.warning.empty() ? "" : "<br>") + words_of(note, texts);
    }
    out.cards = draw_cards(cards);
    return out;
  }
  if (options.size() > kSentences)
    out.sentence =
        texts.say("compare.several",
                  {{"n", std::to_string(options.size())},
                   {"base", escaped(comparison.at("base").at("name").get<std::string>())}});
  else
    for (const Json& option : options)
      out.sentence += (out.sentence.empty() ? "" : "<br>") + words_of(option.at("headline"), texts);
  std::vector<Card> cards;
  for (const Json& option : options) {
    cards.push_back(card_of(option, texts));
    // reasons for doubt come first; the rest is in the table
    const double lost = option.at("lost"), pairs = option.at("pairs");
    if (pairs > 0 && lost > 0.1 * (pairs + lost))
      out.warning +=
          (out.warning.empty() ? "" : "<br>") + words_of(option.at("notes").at(0), texts);
  }
  out.cards = draw_cards(cards);
  return out;
}

}  // namespace report

std::string comparison_data(const PairedComparison& comparison) {
  using namespace report;
  Bundle bundle;
  bundle.header["kind"] = "comparison";
  bundle.header["title"] = comparison.study;
  const DecimalPoint point;
  bundle.header["comparison"] = Json::parse(comparison_json(comparison));
  drop_folders(bundle.header["comparison"]);
  translate_messages(bundle.header["comparison"]);
  Json list = Json::array();
  for (const Quantity& q : quantities())
    list.push_back({{"name", q.name}, {"key", key_of(q)}, {"unit", q.unit}});
  bundle.header["quantities"] = list;
  bundle.header["provenance"] = comparison.provenance;
  return bundle.packed();
}

}  // namespace wythe
