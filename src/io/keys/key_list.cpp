// keys_json(): every key of a model file for other programs, from the description by which files are read.
#include <fmt/format.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "io/keys/describe.h"
#include "io/text/range_text.h"
#include "wythe/parts/io.h"
#include "wythe/parts/units.h"

namespace wythe {
namespace io {
namespace {

using Json = nlohmann::ordered_json;

class KeyList {
 public:
  KeyList(Json& list, std::string path) : list_(list), path_(std::move(path)) {}

  void quantity(const char* name, const double& value, const Key& key) {
    add(name, "quantity", key,
        std::isnan(value) ? "" : format_quantity(value, key.unit, key.shown));
  }
  void quantities(const char* name, const std::vector<double>&, const Key& key) {
    add(name, "quantities", key);
  }
  void points(const char* name, const std::vector<std::array<double, 2>>&, const Key& key) {
    add(name, "points", key);
  }
  void numbers(const char* name, const std::vector<double>&, const Key& key) {
    add(name, "numbers", key);
  }
  void number(const char* name, const double& value, const Key& key) {
    add(name, "number", key, std::isnan(value) ? "" : fmt::format("{}", value));
  }
  void integer(const char* name, const int& value, const Key& key) {
    add(name, "integer", key, std::to_string(value));
  }
  void flag(const char* name, const bool& value, const Key& key) {
    add(name, "flag", key, value ? "true" : "false");
  }
  void text(const char* name, const std::string& value, const Key& key) {
    add(name, "text", key, value);
  }
  void texts(const char* name, const std::vector<std::string>&, const Key& key) {
    add(name, "texts", key);
  }
  void recipe(const char* name, const Key& key) {
    const std::string_view example = key.example;
    add(name,
        *key.unit                      ? "quantity"
        : std::isfinite(key.range.low) ? "number"
        : example == "true"            ? "factor"
        : example.starts_with('{')     ? "tables"
                                       : "text",
        key);
  }
  template <class E, std::size_t N>
  void choice(const char* name, const E& value, const Word<E> (&words)[N], const Key& key) {
    std::string own;
    for (const Word<E>& word : words)
      if (word.value == value) own = word.word;
    Json& row = add(name, "word", key, own);
    for (const Word<E>& word : words) row["words"].push_back(word.word);
  }
  template <class T>
  void table(const char* name, T& value, const Key& key) {
    add(name, "table", key);
    inside(under(path_, name), value);
  }
  template <class T>
  void list(const char* name, std::vector<T>&, const Key& key) {
    add(name, "list", key);
    T value;
    inside(under(path_, name) + "[]", value);
  }
  template <class T>
  void map(const char* name, std::map<std::string, T>&, const Key& key) {
    add(name, "map", key);
    T value;
    inside(under(path_, name) + ".<name>", value);
  }

 private:
  // `own`: the default of a model without this key. `allowed` is written where it excludes values.
  Json& add(const char* name, const char* kind, const Key& key, const std::string& own = "") {
    Json row = {{"path", under(path_, name)}, {"kind", kind}};
    if (*key.shown != '\0') row["unit"] = key.shown;
    if (const std::string allowed = range_text(key); allowed != range_text({}))
      row["allowed"] = allowed;
    if (key.may_be_unlimited) row["unlimited"] = true;
    if (*key.fallback != '\0')
      row["default"] = key.fallback;
    else if (!own.empty())
      row["default"] = own;
    if (*key.example != '\0') row["example"] = key.example;
    row["meaning"] = key.doc;
    list_.push_back(std::move(row));
    return list_.back();
  }
  template <class T>
  void inside(const std::string& path, T& value) {
    KeyList inner(list_, path);
    describe(inner, value);
  }

  Json& list_;
  std::string path_;
};

}  // namespace
}  // namespace io

std::string keys_json() {
  nlohmann::ordered_json list = nlohmann::ordered_json::array();
  ModelSpec spec;
  io::KeyList keys(list, "");
  io::describe(keys, spec);
  return list.dump(1);
}

}  // namespace wythe
