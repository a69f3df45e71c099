// What a page says, in the languages of assets/texts.json: the one table of words that the static
// headline (C++) and the viewer (web/src/texts.ts) share.
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

  // The text as markup, values of its places put in as they are: they must be markup already.
  [[nodiscard]] std::string say(const std::string& key, Places places = {}) const;
  // A word or name of the engine, as text; what is not in the table stays as it is. Sentences come as
  // messages (report/translation.h).
  [[nodiscard]] std::string phrase(const std::string& english) const;
  // rounded() and quantity() of html.h with the language's decimal sign.
  [[nodiscard]] std::string number(double value, int digits = 3) const;
  [[nodiscard]] std::string quantity(double value, std::string_view unit, int digits = 3) const;
  // A number in digits with the language's decimal sign.
  [[nodiscard]] std::string localised(std::string number) const;
  // Of the language in every row of the table.
  [[nodiscard]] std::size_t place() const { return language_; }

 private:
  std::size_t language_;  // its place in every row of the table
};

[[nodiscard]] std::vector<std::string> languages();
// The table as JSON for an element of a page in `language`: each row has English first and the page's language at its
// place, null between. Without the words of the studio, and without "<".
[[nodiscard]] std::string texts_for_page(const std::string& language);

}  // namespace wythe::report
