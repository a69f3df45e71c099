// Looks up words in assets/texts.json, which is parsed once. A text is escaped before values
// are inserted. An unknown key throws. Phrases joined by " + " are looked up one by one.
#include "report/texts.h"

#include <algorithm>
#include <nlohmann/json.hpp>

#include "core/text.h"
#include "report/assets.h"
#include "report/html.h"
#include "wythe/parts/error.h"

namespace wythe::report {
namespace {

using Json = nlohmann::ordered_json;

const Json& table() {
  static const Json kTable = Json::parse(kTextsJson);
  return kTable;
}

constexpr std::string_view kTogether = " + ";  // a mode may have two names

std::vector<std::string> split(const std::string& text, std::string_view between) {
  std::vector<std::string> parts;
  std::size_t from = 0;
  for (std::size_t at; (at = text.find(between, from)) != std::string::npos;
       from = at + between.size())
    parts.push_back(text.substr(from, at - from));
  parts.push_back(text.substr(from));
  return parts;
}

}  // namespace

std::vector<std::string> languages() { return table()["languages"]; }

Texts::Texts(const std::string& language) {
  const std::vector<std::string> known = languages();
  const auto at = std::find(known.begin(), known.end(), language);
  if (at == known.end())
    throw InputError({{.file = "--lang",
                       .value = language,
                       .problem = "is no language of the report",
                       .cure = "write one of: " + joined(known, ", ")}});
  language_ = static_cast<std::size_t>(at - known.begin());
}

std::string Texts::say(const std::string& key, Places places) const {
  const std::string pattern = escaped(table()["texts"].at(key).at(language_).get<std::string>());
  std::string text;
  std::size_t from = 0;
  for (std::size_t open; (open = pattern.find('{', from)) != std::string::npos;) {
    const std::size_t close = std::min(pattern.find('}', open), pattern.size() - 1);
    const std::string place = pattern.substr(open + 1, close - open - 1);
    const auto* found = std::find_if(places.begin(), places.end(),
                                     [&](const auto& one) { return one.first == place; });
    text += pattern.substr(from, open - from);
    text += found == places.end() ? pattern.substr(open, close + 1 - open) : found->second;
    from = close + 1;
  }
  return text + pattern.substr(std::min(from, pattern.size()));
}

std::string Texts::phrase(const std::string& english) const {
  if (language_ == 0) return english;
  const Json& phrases = table()["phrases"];
  std::vector<std::string> words = split(english, kTogether);
  for (std::string& word : words)
    if (phrases.contains(word)) word = phrases[word].at(language_ - 1);
  return joined(words, kTogether);
}

std::string Texts::localised(std::string number) const {
  const std::string sign = table()["decimal"].at(language_);
  const std::size_t at = number.find('.');
  if (at != std::string::npos) number.replace(at, 1, sign);
  return number;
}

std::string Texts::number(double value, int digits) const {
  return std::isinf(value) ? say("unlimited") : localised(rounded(value, digits));
}

std::string Texts::quantity(double value, std::string_view unit, int digits) const {
  return std::isinf(value) ? say("unlimited") : localised(report::quantity(value, unit, digits));
}

std::string texts_for_page(const std::string& language) {
  const std::size_t own = Texts(language).place();
  // of the languages in a row, `missing` have no text
  const auto only_own = [&](const Json& row, std::size_t missing) {
    Json out = Json::array();
    for (std::size_t k = 0; k + missing <= own; ++k)
      out.push_back(k + missing == own || k + missing == 0 ? row.at(k) : Json(nullptr));
    return out;
  };
  Json out = {{"languages", table()["languages"]}, {"decimal", table()["decimal"]}};
  for (const auto& [key, row] : table()["texts"].items())
    if (!key.starts_with("studio.")) out["texts"][key] = only_own(row, 0);
  out["phrases"] = Json::object();
  for (const auto& [english, row] : table()["phrases"].items())
    if (own > 0) out["phrases"][english] = only_own(row, 1);
  std::string text = out.dump();
  for (std::size_t at = text.find('<'); at != std::string::npos; at = text.find('<', at))
    text.replace(at, 1, "\\u003c");
  return text;
}

}  // namespace wythe::report
