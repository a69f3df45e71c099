// Texts that the sheet of a verdict and its appendix share: numbers, ways of pushing, messages without keys.
#pragma once

#include <fmt/format.h>

#include <cmath>
#include <string>
#include <vector>

#include "report/html.h"
#include "report/texts.h"
#include "report/translation.h"
#include "wythe/parts/verdict.h"

namespace wythe::report {

inline constexpr double kToG = 1 / kStandardGravity;

class VerdictWords {
 public:
  explicit VerdictWords(std::string language) : language_(std::move(language)), texts_(language_) {}

  [[nodiscard]] const std::string& language() const { return language_; }
  [[nodiscard]] const Texts& texts() const { return texts_; }
  [[nodiscard]] std::string say(const std::string& key, Places places = {}) const {
    return texts_.say(key, places);
  }
  // A message in the page's language, as markup.
  [[nodiscard]] std::string words(const Message& message) const {
    return escaped(text_of(for_page(message), language_));
  }
  [[nodiscard]] std::string sentence_of(const Message& message) const {
    return sentence(text_of(for_page(message), language_));
  }
  [[nodiscard]] std::string list(const std::vector<Message>& messages) const {
    std::string out = "<ul>\n";
    for (const Message& message : messages) out += "<li>" + sentence_of(message) + "</li>\n";
    return out + "</ul>\n";
  }
  [[nodiscard]] std::string state(LimitState state) const {
    return say("assessment." + std::string(word_of(kLimitStateWords, state)));
  }
  // Forces along the wall towards one end; a vector in space is unchanged.
  [[nodiscard]] std::string name_of(const WayOfPushing& way) const {
    const char* key = way.direction == "+x"   ? "assess.to_right"
                      : way.direction == "-x" ? "assess.to_left"
                                              : nullptr;
    return (key != nullptr ? say(key) : escaped(way.direction)) + ", " +
           words(words_of_pattern(way.pattern));
  }

  // Three decimals, so that numbers in a column can be compared.
  [[nodiscard]] std::string fixed(double value, const char* unit = "") const {
    const std::string text = texts_.localised(fmt::format("{:.3f}", value));
    return *unit == 0 ? text : text + "\u202f" + unit;
  }
  // " (0.14 to 0.24)"; "" without an interval.
  [[nodiscard]] std::string interval(const Interval& of, double scale) const {
    if (std::isnan(of.low)) return "";
    const std::string from = fixed(of.low * scale);
    return " (" +
           (std::isinf(of.high)
                ? say("assess.or_more", {{"from", from}})
                : say("assess.between", {{"from", from}, {"to", fixed(of.high * scale)}})) +
           ")";
  }
  // The median with its interval.
  [[nodiscard]] std::string capacity(const WallCapacity& c, double scale, const char* unit) const {
    if (std::isnan(c.median.value)) return "–";
    const std::string value = fixed(c.median.value * scale, unit);
    return (c.at_least ? say("assess.at_least", {{"value", value}}) : value) +
           interval(c.with_tests, scale);
  }
  // The result of a part out of plane in a word.
  [[nodiscard]] std::string met(const LocalCheck& part) const {
    switch (part.verdict) {
      case AssessmentVerdict::kHolds: return say("assess.met");
      case AssessmentVerdict::kFails: return say("assess.not_met");
      default: return say("assess.lost");
    }
  }
  [[nodiscard]] std::string not_met_of(const WallCounts& counts) const {
    return say("assess.of", {{"part", fmt::format("{}", counts.not_met)},
                             {"all", fmt::format("{}", counts.met + counts.not_met)}});
  }

 private:
  std::string language_;
  Texts texts_;
};

// The pages after the sheet: each wall, each rule, the inputs. `inputs` are those of model_inputs().
[[nodiscard]] std::string verdict_appendix(const VerdictWords& words, const WallsVerdict& verdict,
                                           const Json& inputs);

}  // namespace wythe::report
