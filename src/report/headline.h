// The part of a page that needs no script: the answer in a sentence and the key numbers, as markup.
#pragma once

#include <string>

#include "report/bundle.h"
#include "report/texts.h"

namespace wythe::report {

// <header> with title, headline and warnings, then the cards, depending on the kind of data.
[[nodiscard]] std::string headline_of(const Json& header, const Texts& texts);

// The headline of options side by side (comparison_data.cpp).
struct Headline {
  std::string sentence, warning, cards;
};
[[nodiscard]] Headline comparison_headline(const Json& header, const Texts& texts);
// Whether it is a campaign over records (shaken_headline.cpp).
[[nodiscard]] bool is_shaken(const Json& header);
// Whether it is a run with a shake.
[[nodiscard]] inline bool is_one_shake(const Json& header) {
  return header.at("kind") == "run" && header.at("summary").contains("shaking");
}
[[nodiscard]] Headline shaken_headline(const Json& header, const Texts& texts);

}  // namespace wythe::report
