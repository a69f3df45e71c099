#include "report/texts.h"

#include <algorithm>
#include <nlohmann/json.hpp>
#include <optional>

#include "core/text.h"
#include "report/assets.h"
#include "report/html.h"
#include "wythe/error.h"

namespace wythe::report {
namespace {

using Json = nlohmann::ordered_json;

const Json& table() {
  static const Json kTable = Json::parse(kTextsJson);
  return kTable;
}

bool is_number(std::string_view text) {
  return !text.empty() && text.find_first_not_of("0123456789.-+e") == std::string_view::npos &&
         text.find_first_of("0123456789") != std::string_view::npos;
}

// The parts of `text` that stand at the {} of `pattern`; nothing where it does not fit.
std::optional<std::vector<std::string>> places_in(std::string_view text, std::string_view pattern) {
  std::vector<std::string> found;
  std::size_t at = 0;
  for (std::size_t from = 0;;) {
    const std::size_t place = pattern.find("{}", from);
    const std::string_view literal = pattern.substr(from, place - from);
    const bool first = from == 0;
    const bool last = place == std::string_view::npos;
    std::size_t where = first ? 0 : text.find(literal, at);
    if (last && !first && text.ends_with(literal)) where = text.size() - literal.size();
    if (where == std::string_view::npos || where < at ||
        text.substr(where, literal.size()) != literal)
      return std::nullopt;
    if (!first) found.emplace_back(text.substr(at, where - at));
    at = where + literal.size();
    if (last) break;
    from = place + 2;
  }
  if (at != text.size()) return std::nullopt;
  return found;
}

// Patterns with a {}, the most telling first: "{} mm" fits whatever ends in millimetres.
const std::vector<std::string>& patterns() {
  static const std::vector<std::string> kPatterns = [] {
    std::vector<std::string> all;
    for (const auto& [pattern, others] : table()["phrases"].items())
      if (pattern.find("{}") != std::string::npos) all.push_back(pattern);
    std::stable_sort(all.begin(), all.end(), [](const std::string& a, const std::string& b) {
      const auto letters = [](const std::string& p) {
        return p.size() - 2 * static_cast<std::size_t>(std::count(p.begin(), p.end(), '{'));
      };
      return letters(a) > letters(b);
    });
    return all;
  }();
  return kPatterns;
}

std::vector<std::string> split(const std::string& text, std::string_view between) {
  std::vector<std::string> parts;
  std::size_t from = 0;
  for (std::size_t at; (at = text.find(between, from)) != std::string::npos;
       from = at + between.size())
    parts.push_back(text.substr(from, at - from));
  parts.push_back(text.substr(from));
  return parts;
}

std::string filled(const std::string& pattern, const std::vector<std::string>& values) {
  std::string out = pattern;
  std::size_t from = 0;
  for (const std::string& value : values) {
    const std::size_t at = out.find("{}", from);
    if (at == std::string::npos) break;
    out.replace(at, 2, value);
    from = at + value.size();
  }
  return out;
}

}  // namespace

std::vector<std::string> languages() { return table()["languages"]; }

Texts::Texts(const std::string& language) {
  const std::vector<std::string> known = languages();
  const auto at = std::find(known.begin(), known.end(), language);
  if (at == known.end())
    throw InputError({{.file = "--lang",
                       .path = "",
                       .value = language,
                       .problem = "is no language of the report",
                       .cure = "write one of: " + joined(known, ", ")}});
  language_ = static_cast<std::size_t>(at - known.begin());
}

std::string Texts::say(const std::string& key, Places places) const {
  std::string text = escaped(table()["texts"].at(key).at(language_).get<std::string>());
  for (const auto& [name, value] : places) {
    const std::string place = "{" + std::string(name) + "}";
    const std::size_t at = text.find(place);
    if (at != std::string::npos) text.replace(at, place.size(), value);
  }
  return text;
}

std::string Texts::phrase(const std::string& english) const {
  if (language_ == 0) return english;
  if (is_number(english)) return localised(english);
  const Json& phrases = table()["phrases"];
  if (phrases.contains(english)) return phrases[english].at(language_ - 1);
  for (const std::string& pattern : patterns()) {
    const auto places = places_in(english, pattern);
    if (!places) continue;
    std::vector<std::string> said;
    for (const std::string& part : *places) said.push_back(phrase(part));
    return filled(phrases[pattern].at(language_ - 1), said);
  }
  for (const char* between : {"; ", ": ", ", ", " + "}) {
    std::vector<std::string> parts = split(english, between);
    if (parts.size() < 2) continue;
    for (std::string& part : parts) part = phrase(part);
    return joined(parts, between);
  }
  return english;
}

std::string Texts::localised(std::string number) const {
  const std::string sign = table()["decimal"].at(language_);
  const std::size_t at = number.find('.');
  if (at != std::string::npos) number.replace(at, 1, sign);
  return number;
}

std::string Texts::number(double value, int digits) const {
  return localised(rounded(value, digits));
}

std::string Texts::quantity(double value, std::string_view unit, int digits) const {
  return localised(report::quantity(value, unit, digits));
}

}  // namespace wythe::report
