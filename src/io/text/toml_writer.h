// A visitor that writes a struct as TOML: a table's own keys first, then the tables below it.
//
// Unset quantities (NaN), empty optional texts and keys of other stage kinds are left
// out. All else is written, defaults included, so that reading it gives the same bits.
#pragma once

#include <map>
#include <string>
#include <utility>
#include <vector>

#include "io/keys/same_spec.h"

namespace wythe::io {

[[nodiscard]] std::string quoted(const std::string& text);    // TOML basic string
[[nodiscard]] std::string key_text(const std::string& name);  // bare where TOML allows it

class Writer {
 public:
  explicit Writer(std::string path) : path_(std::move(path)) {}

  void quantity(const char* name, const double& value, const Key& key);
  void quantities(const char* name, const std::vector<double>& values, const Key& key);
  void numbers(const char* name, const std::vector<double>& values, const Key& key);
  void points(const char* name, const std::vector<std::array<double, 2>>& points, const Key& key);
  void number(const char* name, const double& value, const Key& key);
  void integer(const char* name, const int& value, const Key& key);
  void flag(const char* name, const bool& value, const Key& key);
  void text(const char* name, const std::string& value, const Key& key);
  void texts(const char* name, const std::vector<std::string>& values, const Key& key);

  template <class E, std::size_t N>
  void choice(const char* name, const E& value, const Word<E> (&words)[N], const Key& key) {
    if constexpr (std::is_same_v<E, StageKind>) kind_ = kind_bit(value);
    if (const std::string word = word_of(words, value); !word.empty()) put(name, quoted(word), key);
  }

  template <class T>
  void table(const char* name, T& value, const Key& key) {
    if (key.optional && first_difference(value, T{}).empty()) return;
    const std::string path = under(path_, name);
    Writer inner(path);
    describe(inner, value);
    if (key.in_braces)
      put(name, inner.in_braces(), key);
    else
      below_ += "\n[" + path + "]\n" + inner.text();
  }

  template <class T>
  void list(const char* name, std::vector<T>& values, const Key&) {
    for (T& value : values) {
      const std::string path = under(path_, name);
      Writer inner(path);
      describe(inner, value);
      below_ += "\n[[" + path + "]]\n" + inner.text();
    }
  }

  template <class T>
  void map(const char* name, std::map<std::string, T>& values, const Key&) {
    for (auto& [label, value] : values) {
      const std::string path = under(under(path_, name), key_text(label));
      Writer inner(path);
      describe(inner, value);
      below_ += "\n[" + path + "]\n" + inner.text();
    }
  }

  [[nodiscard]] std::string text() const;
  [[nodiscard]] std::string in_braces() const;

 private:
  void put(const char* name, std::string value, const Key& key);

  std::string path_;
  Kinds kind_ = 0;  // of the stage being written
  std::vector<std::pair<std::string, std::string>> lines_;
  std::string below_;
};

}  // namespace wythe::io
