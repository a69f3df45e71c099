// Words of enumerations: the name of a value in files, stores, pages and messages. The table stands beside
// the enumeration, in any order. src/api/word_tables.cpp checks at compile time that each enumerator has one unique word.
// So enumerators can be added or moved without renaming anything that is stored.
//
//   enum class Fit { kWhole, kCut };
//   inline constexpr Word<Fit> kFitWords[] = {{"whole", Fit::kWhole}, {"cut", Fit::kCut}};
//   static_assert(names_all(kFitWords));  // in word_tables.cpp
#pragma once

#include <cstddef>
#include <optional>
#include <string_view>
#include <utility>

namespace wythe {

template <class E>
struct Word {
  const char* word;
  E value;
};

// Whether `value` is an enumerator. Compilers write an enumerator by its name, any other value as "(E)7".
template <auto value>
[[nodiscard]] consteval bool is_enumerator() {
  const std::string_view text = __PRETTY_FUNCTION__;
  constexpr std::string_view kBefore = "value = ";
  return text[text.find(kBefore) + kBefore.size()] != '(';
}

// Number of enumerators of an enumeration with values from 0 to 63.
template <class E>
[[nodiscard]] consteval std::size_t count_enumerators() {
  return []<std::size_t... value>(std::index_sequence<value...>) {
    return (std::size_t{0} + ... + (is_enumerator<static_cast<E>(value)>() ? 1 : 0));
  }
  (std::make_index_sequence<64>{});
}

// Whether a table names each enumerator once, except `unnamed` of them, with different words.
template <class E, std::size_t N>
[[nodiscard]] consteval bool names_all(const Word<E> (&words)[N], std::size_t unnamed = 0) {
  for (std::size_t i = 0; i < N; ++i)
    for (std::size_t k = 0; k < i; ++k)
      if (words[i].value == words[k].value ||
          std::string_view(words[i].word) == std::string_view(words[k].word))
        return false;
  return N + unnamed == count_enumerators<E>();
}

// The word of a value; "" where it has none.
template <class E, std::size_t N>
[[nodiscard]] constexpr const char* word_of(const Word<E> (&words)[N], E value) {
  for (const Word<E>& word : words)
    if (word.value == value) return word.word;
  return "";
}

// The value that a word names; nothing for an unknown word.
template <class E, std::size_t N>
[[nodiscard]] constexpr std::optional<E> value_of(const Word<E> (&words)[N],
                                                  std::string_view text) {
  for (const Word<E>& word : words)
    if (text == word.word) return word.value;
  return std::nullopt;
}

}  // namespace wythe
