// The texts of a page in the languages of assets/texts.json: one table of
// words for the static headline (C++) and the viewer (web/src/base/texts.ts).
//
//   texts    key -> one text a language, with {places} for values
//   phrases  a word or name of the engine ("rocking", "bonded") -> other languages
#pragma once

#include <initializer_list>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace wythe::report {

using Places = std::initializer_list<std::pair<std::string_view, std::string>>;

class Texts {
 public:
  // Throws InputError where the language is not in the table.
  explicit Texts(const std::string& language);

  // The text as markup with values inserted unchanged, so they must be markup already.
  [[nodiscard]] std::string say(const std::string& key, Places places = {}) const;
  // A word or name of the engine, as text; a word that is not in the table
  // is unchanged. Sentences come as messages (report/translation.h).
  [[nodiscard]] std::string phrase(const std::string& english) const;
  // rounded() and quantity() of html.h with the language's decimal sign.
  [[nodiscard]] std::string number(double value, int digits = 3) const;
  [[nodiscard]] std::string quantity(double value, std::string_view unit, int digits = 3) const;
  // A number in digits with the language's decimal sign.
  [[nodiscard]] std::string localised(std::string number) const;
  // The index of the language in every row of the table.
  [[nodiscard]] std::size_t place() const { return language_; }

 private:
  std::size_t language_;  // its place in every row of the table
};

[[nodiscard]] std::vector<std::string> languages();
// The table as JSON for an element of a page in `language`. Each row has English first and
// the page's language at its index, null between. It has no words of the studio, and no "<".
[[nodiscard]] std::string texts_for_page(const std::string& language);

}  // namespace wythe::report
