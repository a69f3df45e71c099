// Corrects misspelt names and wrong brackets, so that one mistake gives one message, and not one more for each
// missing value.
//
//   [masonr]            ─► masonr: no such key; did you mean masonry?   and the table is read as [masonry]
//   [[wall]]            ─► wall = a list: must be a table               and its first member is read
//   keys of [masonry] whose head was left out
//                       ─► they belong under [masonry]                  and are read there
//
// Done before anything is read, so that rules and checks find the values that the user meant.
#pragma once

#include <map>
#include <string>
#include <type_traits>
#include <vector>

#include "io/keys/key.h"
#include "io/text/toml_reader.h"

namespace wythe::io {

// A possible name in a table, and the names below it.
struct KnownName {
  enum class Shape { kValue, kTable, kList, kMap };
  std::string name;
  Shape shape = Shape::kValue;
  bool may_be_alone = false;  // a list that one table in braces may stand for
  const std::vector<KnownName>& (*below)() =
      nullptr;  // of a table, of each member of a list or map
};

template <class T>
const std::vector<KnownName>& known_names();

// Collects the names of one described struct.
class NameCollector {
 public:
  explicit NameCollector(std::vector<KnownName>& out) : out_(out) {}

  template <class V>
  void quantity(const char* name, const V&, const Key&) {
    value(name);
  }
  template <class V>
  void quantities(const char* name, const V&, const Key&) {
    value(name);
  }
  template <class V>
  void points(const char* name, const V&, const Key&) {
    value(name);
  }
  template <class V>
  void numbers(const char* name, const V&, const Key&) {
    value(name);
  }
  template <class V>
  void number(const char* name, const V&, const Key&) {
    value(name);
  }
  template <class V>
  void integer(const char* name, const V&, const Key&) {
    value(name);
  }
  template <class V>
  void flag(const char* name, const V&, const Key&) {
    value(name);
  }
  template <class V>
  void text(const char* name, const V&, const Key&) {
    value(name);
  }
  template <class V>
  void texts(const char* name, const V&, const Key&) {
    value(name);
  }
  void recipe(const char* name, const Key&) { value(name); }
  template <class E, class W>
  void choice(const char* name, const E&, const W&, const Key&) {
    value(name);
  }
  template <class T>
  void table(const char* name, const T&, const Key&) {
    out_.push_back({name, KnownName::Shape::kTable, false, &known_names<T>});
  }
  template <class T>
  void list(const char* name, const std::vector<T>&, const Key& key) {
    out_.push_back({name, KnownName::Shape::kList, key.in_braces, &known_names<T>});
  }
  template <class T>
  void map(const char* name, const std::map<std::string, T>&, const Key&) {
    out_.push_back({name, KnownName::Shape::kMap, false, &known_names<T>});
  }

 private:
  void value(const char* name) { out_.push_back({name, KnownName::Shape::kValue, false, nullptr}); }
  std::vector<KnownName>& out_;
};

template <class T>
const std::vector<KnownName>& known_names() {
  static const std::vector<KnownName> names = [] {
    std::vector<KnownName> out;
    NameCollector collector(out);
    T described;
    describe(collector, described);
    return out;
  }();
  return names;
}

// Adds a fault for each mistake, and corrects the tree.
void read_names_as_meant(ReadContext& context, toml::table& root,
                         const std::vector<KnownName>& known);

}  // namespace wythe::io
