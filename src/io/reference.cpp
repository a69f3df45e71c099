// reference_page(): every key as Markdown, from the same description that reads it.
#include <cmath>

#include <fmt/format.h>

#include "core/text.h"
#include "io/describe.h"
#include "io/range_text.h"
#include "wythe/io.h"
#include "wythe/units.h"

namespace wythe {
namespace io {
namespace {

constexpr const char* kHeader = R"(# The model file

Generated from the program (`wythe reference`); the description that reads a model writes this page.

A model file is TOML. A quantity is a text with its unit, `length = "5.10 m"`; any unit that UDUNITS-2
knows and that has the right dimension will do (`"510 cm"`, `"0.15 N/mm^2"`, `"150 kPa"`). A bare
number for a quantity is refused. Numbers without a dimension and true/false stand without quotes,
words and names in quotes. `--set path=value` changes any key from the command line, with members of
a list by their name or index: `--set stage.push.velocity="1 mm/s"`, `--set wall.opening.0.width="1 m"`.

The kind of a stage is told from its keys: `velocity` makes a push, a load a load, `rate` a body
force, `tilt_rate` a tilt, `duration` a hold.
)";

// A bar would end the cell.
std::string cell(std::string text) {
  for (std::size_t at = text.find('|'); at != std::string::npos; at = text.find('|', at + 2))
    text.insert(at, "\\");
  return text;
}

std::string code(const std::string& text) { return text.empty() ? "" : "`" + text + "`"; }

std::string kinds_text(Kinds kinds) {
  std::vector<std::string> words;
  for (const auto& word : kStageKindWords)
    if (kinds & kind_bit(word.value)) words.emplace_back(word.word);
  return words.empty() ? "" : " Only in: " + joined(words, ", ") + ".";
}

class Reference {
 public:
  explicit Reference(std::string path) : path_(std::move(path)) {}

  void quantity(const char* name, const double& value, const Key& key) {
    const std::string fallback =
        std::isnan(value) ? "" : format_quantity(value, key.unit, key.shown);
    row(name, key, key.shown, allowed(key), fallback, ValueKind::kQuantity);
  }
  void quantities(const char* name, const std::vector<double>&, const Key& key) {
    row(name, key, fmt::format("list, {}", key.shown), allowed(key), "", ValueKind::kQuantity);
  }
  void number(const char* name, const double& value, const Key& key) {
    const std::string fallback = std::isnan(value) ? "" : fmt::format("{}", value);
    row(name, key, "number", allowed(key), fallback, ValueKind::kBare);
  }
  void integer(const char* name, const int& value, const Key& key) {
    row(name, key, "whole number", allowed(key), std::to_string(value), ValueKind::kBare);
  }
  void flag(const char* name, const bool& value, const Key& key) {
    row(name, key, "true or false", "", value ? "true" : "false", ValueKind::kBare);
  }
  void text(const char* name, const std::string& value, const Key& key) {
    row(name, key, "text", "", value, ValueKind::kText);
  }
  void texts(const char* name, const std::vector<std::string>&, const Key& key) {
    row(name, key, fmt::format("list of {} texts", key.count), "", "", ValueKind::kBare);
  }
  template <class E, std::size_t N>
  void choice(const char* name, const E& value, const Word<E> (&words)[N], const Key& key) {
    std::vector<std::string> known;
    std::string fallback;
    for (const Word<E>& word : words) {
      known.push_back(code(word.word));
      if (word.value == value && *key.fallback == '\0') fallback = word.word;
    }
    row(name, key, "word", joined(known, ", "), fallback, ValueKind::kText);
  }
  template <class T>
  void table(const char* name, T& value, const Key& key) {
    const std::string path = under(path_, name);
    const std::string heading =
        key.in_braces ? fmt::format("{} = {{ ... }}", path) : '[' + path + ']';
    section(heading, path, key, value);
  }
  template <class T>
  void list(const char* name, std::vector<T>&, const Key& key) {
    const std::string path = under(path_, name);
    T value;
    section("[[" + path + "]]", path, key, value);
  }
  template <class T>
  void map(const char* name, std::map<std::string, T>&, const Key& key) {
    const std::string path = under(path_, name) + ".<name>";
    T value;
    section('[' + path + ']', path, key, value);
  }

  [[nodiscard]] std::string whole() const { return rows_ + below_; }

 private:
  static std::string allowed(const Key& key) {
    return range_text(key) + (key.may_be_unlimited ? ", or `unlimited`" : "");
  }

  void row(const char* name, const Key& key, const std::string& unit, const std::string& allowed,
           const std::string& value, ValueKind kind) {
    if (rows_.empty())
      rows_ =
          "\n| key | unit or type | allowed | default | meaning | example |\n"
          "|---|---|---|---|---|---|\n";
    const std::string fallback = value.empty() ? key.fallback : code(value);
    rows_ += fmt::format("| `{}` | {} | {} | {} | {}{} | {} |\n", name, unit, cell(allowed),
                         fallback, cell(key.doc), kinds_text(key.kinds),
                         cell(code(example_text(name, key, kind))));
  }

  template <class T>
  void section(const std::string& heading, const std::string& path, const Key& key, T& value) {
    Reference inner(path);
    describe(inner, value);
    below_ += fmt::format("\n## `{}`\n\n{}{}\n{}", heading, key.doc, kinds_text(key.kinds),
                          inner.whole());
  }

  std::string path_, rows_, below_;
};

}  // namespace
}  // namespace io

std::string reference_page() {
  ModelSpec spec;
  io::Reference reference("");
  io::describe(reference, spec);
  return io::kHeader + reference.whole();
}

}  // namespace wythe
