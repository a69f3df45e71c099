// Comparison of specs member by member through their description (NaN equals NaN, all bits count).
#pragma once

#include <algorithm>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "io/keys/describe.h"
#include "wythe/parts/units.h"

namespace wythe::io {

// Lists every member as path and text. kExact: doubles in hexadecimal, so that the text has all bits.
// kReadable: as a model file states them, without what is not stated.
class Flatten {
 public:
  enum Form { kExact, kReadable };
  using Members = std::vector<std::pair<std::string, std::string>>;
  Flatten(Members& out, std::string path, Form form)
      : out_(out), path_(std::move(path)), form_(form) {}

  void quantity(const char* name, const double& value, const Key& key) {
    if (form_ == kExact) return exact(name, value);
    if (value == value)
      out_.emplace_back(under(path_, name), format_quantity(value, key.unit, key.shown));
  }
  void number(const char* name, const double& value, const Key&) {
    if (form_ == kExact) return exact(name, value);
    if (value == value) out_.emplace_back(under(path_, name), fmt::format("{}", value));
  }
  void quantities(const char* name, const std::vector<double>& values, const Key& key) {
    size(name, values.size());
    each(
        values, [&](const char* part, double value) { quantity(part, value, key); }, name);
  }
  void numbers(const char* name, const std::vector<double>& values, const Key& key) {
    size(name, values.size());
    each(
        values, [&](const char* part, double value) { number(part, value, key); }, name);
  }
  void points(const char* name, const std::vector<std::array<double, 2>>& points, const Key& key) {
    std::vector<double> values;
    for (const auto& [x, y] : points) values.insert(values.end(), {x, y});
    size(name, points.size());
    each(
        values, [&](const char* part, double value) { quantity(part, value, key); }, name);
  }
  void integer(const char* name, const int& value, const Key&) {
    out_.emplace_back(under(path_, name), std::to_string(value));
  }
  void flag(const char* name, const bool& value, const Key&) { integer(name, value ? 1 : 0, {}); }
  void text(const char* name, const std::string& value, const Key&) {
    if (form_ == kExact || !value.empty()) out_.emplace_back(under(path_, name), value);
  }
  void texts(const char* name, const std::vector<std::string>& values, const Key&) {
    size(name, values.size());
    if (form_ == kReadable) return text(name, fmt::format("{}", fmt::join(values, "; ")), {});
    for (const std::string& value : values) text(name, value, {});
  }
  template <class E, std::size_t N>
  void choice(const char* name, const E& value, const Word<E> (&words)[N], const Key&) {
    if (form_ == kExact) return integer(name, static_cast<int>(value), {});
    for (const Word<E>& word : words)
      if (word.value == value) return text(name, word.word, {});
  }
  template <class T>
  void table(const char* name, T& value, const Key&) {
    Flatten inner(out_, under(path_, name), form_);
    describe(inner, value);
  }
  template <class T>
  void list(const char* name, std::vector<T>& values, const Key& key) {
    if (key.optional && values.empty()) return;  // such a model keeps its old hash
    size(name, values.size());
    for (std::size_t i = 0; i < values.size(); ++i)
      table(fmt::format("{}.{}", name, member_of(values, i)).c_str(), values[i], {});
  }
  template <class T>
  void map(const char* name, std::map<std::string, T>& values, const Key&) {
    if (values.empty()) return;  // such a model keeps its old hash
    size(name, values.size());
    for (auto& [label, value] : values) table(fmt::format("{}.{}", name, label).c_str(), value, {});
  }

 private:
  void exact(const char* name, double value) {
    out_.emplace_back(under(path_, name), value != value ? "nan" : fmt::format("{:a}", value));
  }
  // Each number of a list is a member of its own: of the list's name, or readable with its place in it.
  template <class Act>
  void each(const std::vector<double>& values, const Act& act, const char* name) {
    for (std::size_t i = 0; i < values.size(); ++i)
      act(form_ == kExact ? name : fmt::format("{}.{}", name, i).c_str(), values[i]);
  }
  // A member's place in its list; readable by its name if no other has it, so that one more before it changes nothing.
  template <class T>
  [[nodiscard]] std::string member_of(const std::vector<T>& list, std::size_t place) const {
    if constexpr (requires { std::string(list[place].name); }) {
      const std::string& name = list[place].name;
      const auto has_it = [&](const T& member) { return member.name == name; };
      if (form_ == kReadable && !name.empty() &&
          std::count_if(list.begin(), list.end(), has_it) == 1)
        return name;
    }
    return std::to_string(place);
  }
  void size(const char* name, std::size_t count) {
    out_.emplace_back(under(path_, name) + ".size", std::to_string(count));
  }

  Members& out_;
  std::string path_;
  Form form_;
};

template <class T>
[[nodiscard]] Flatten::Members flatten(T value, Flatten::Form form = Flatten::kExact) {
  Flatten::Members out;
  Flatten visitor(out, "", form);
  describe(visitor, value);
  return out;
}

// "" when both are equal, else the first member that differs, with both values.
template <class T>
[[nodiscard]] std::string first_difference(const T& a, const T& b) {
  const Flatten::Members in_a = flatten(a), in_b = flatten(b);
  for (std::size_t i = 0; i < in_a.size() && i < in_b.size(); ++i)
    if (in_a[i] != in_b[i])
      return fmt::format("{} = {} against {} = {}", in_a[i].first, in_a[i].second, in_b[i].first,
                         in_b[i].second);
  return in_a.size() == in_b.size() ? "" : "different number of members";
}

}  // namespace wythe::io
