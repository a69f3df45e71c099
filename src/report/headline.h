// What a page says before any script runs: the answer in a sentence and the key numbers, as markup.
#pragma once

#include <string>

#include "report/bundle.h"
#include "report/texts.h"

namespace wythe::report {

// <header> with title, headline and warnings, then the cards, by the kind of the data.
[[nodiscard]] std::string headline_of(const Json& header, const Texts& texts);

}  // namespace wythe::report
