// Comparison of specs member by member through their description (NaN equals NaN, all bits count).
#pragma once

#include <map>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "io/keys/describe.h"

namespace wythe::io {

// Lists every member as path and text; doubles in hexadecimal, so that the text has all bits.
class Flatten {
 public:
  using Members = std::vector<std::pair<std::string, std::string>>;
  Flatten(Members& out, std::string path) : out_(out), path_(std::move(path)) {}

  void quantity(const char* name, const double& value, const Key&) { number(name, value, {}); }
  void number(const char* name, const double& value, const Key&) {
    out_.emplace_back(under(path_, name), value != value ? "nan" : fmt::format("{:a}", value));
  }
  void quantities(const char* name, const std::vector<double>& values, const Key&) {
    size(name, values.size());
    for (const double value : values) number(name, value, {});
  }
  void numbers(const char* name, const std::vector<double>& values, const Key& key) {
    quantities(name, values, key);
  }
  void points(const char* name, const std::vector<std::array<double, 2>>& points, const Key&) {
    size(name, points.size());
    for (const auto& [x, y] : points) number(name, x, {}), number(name, y, {});
  }
  void integer(const char* name, const int& value, const Key&) {
    out_.emplace_back(under(path_, name), std::to_string(value));
  }
  void flag(const char* name, const bool& value, const Key&) { integer(name, value ? 1 : 0, {}); }
  void text(const char* name, const std::string& value, const Key&) {
    out_.emplace_back(under(path_, name), value);
  }
  void texts(const char* name, const std::vector<std::string>& values, const Key&) {
    size(name, values.size());
    for (const std::string& value : values) text(name, value, {});
  }
  template <class E, std::size_t N>
  void choice(const char* name, const E& value, const Word<E> (&)[N], const Key&) {
    integer(name, static_cast<int>(value), {});
  }
  template <class T>
  void table(const char* name, T& value, const Key&) {
    Flatten inner(out_, under(path_, name));
    describe(inner, value);
  }
  template <class T>
  void list(const char* name, std::vector<T>& values, const Key& key) {
    if (key.optional && values.empty()) return;  // such a model keeps its old hash
    size(name, values.size());
    for (std::size_t i = 0; i < values.size(); ++i)
      table(fmt::format("{}.{}", name, i).c_str(), values[i], {});
  }
  template <class T>
  void map(const char* name, std::map<std::string, T>& values, const Key&) {
    if (values.empty()) return;  // such a model keeps its old hash
    size(name, values.size());
    for (auto& [label, value] : values) table(fmt::format("{}.{}", name, label).c_str(), value, {});
  }

 private:
  void size(const char* name, std::size_t count) {
    out_.emplace_back(under(path_, name) + ".size", std::to_string(count));
  }

  Members& out_;
  std::string path_;
};

template <class T>
[[nodiscard]] Flatten::Members flatten(T value) {
  Flatten::Members out;
  Flatten visitor(out, "");
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
