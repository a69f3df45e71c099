// reference_page(), curve_table(), responses_table(): the pages in docs/reference about keys, the curve's
// columns and the responses, from the same descriptions that read and write them. The responses also as a type
// for the report's page.
#include <cmath>
#include <type_traits>

#include <fmt/format.h>

#include "core/files.h"
#include "core/text.h"
#include "io/keys/describe.h"
#include "io/text/range_text.h"
#include "wythe/parts/curve.h"
#include "wythe/parts/error.h"
#include "wythe/parts/io.h"
#include "wythe/parts/responses.h"
#include "wythe/parts/units.h"

namespace wythe {
namespace io {
namespace {

constexpr const char* kHeader = R"(# The model file

A model file describes one wall: its size and bond, its materials, and what is done to it (the *stages*).
This page lists every key that the file may have. The program writes the page from the same description
by which it reads a file, so both agree. To begin, do not read this page: copy an example or write a
starter with `wythe new`, and look up here what you want to change.

The file is TOML: `key = value`, with a `[table]` for each part.

- **A quantity is a text with its unit**: `length = "5.10 m"`. Any unit of the right kind will do
  (`"510 cm"`, `"0.15 N/mm^2"`, `"150 kPa"`; spelt as UDUNITS-2 spells them). A bare number is refused, because
  nobody can see its unit.
- **Numbers without a unit** and true or false stand without quotes; words and names stand in quotes.
- **A key from the command line**: `--set path=value` changes any key for one run. Members of a list are
  named, or counted from 0: `--set stage.push.velocity="1 mm/s"`, `--set wall.opening.0.width="1 m"`.
- **The kind of a stage** is told from its keys: `velocity` makes a push, a load makes a load, `rate` a
  body force, `tilt_rate` a tilt, `duration` a hold.
)";

// The text of a table cell, with each | escaped, because it would end the cell.
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
  void points(const char* name, const std::vector<std::array<double, 2>>&, const Key& key) {
    row(name, key, fmt::format("list of points, {}", key.shown), allowed(key), "",
        ValueKind::kBare);
  }
  void numbers(const char* name, const std::vector<double>&, const Key& key) {
    row(name, key, key.may_be_alone ? "number, or list" : "list of numbers", allowed(key), "",
        ValueKind::kBare);
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
    const std::string count = key.count ? fmt::format("{} ", key.count) : "";
    row(name, key, fmt::format("list of {}texts", count), "", "", ValueKind::kBare);
  }
  void recipe(const char* name, const Key& key) {
    const bool number = std::isfinite(key.range.low);
    const std::string_view example = key.example;
    const bool factor = example == "true", tables = example.starts_with('{');
    const char* type = *key.unit ? key.shown
                       : factor  ? "true or a number"
                       : tables  ? "list of tables"
                       : number  ? "number"
                                 : "text";
    row(name, key, type, number ? allowed(key) : "", "",
        *key.unit                    ? ValueKind::kQuantity
        : factor || tables || number ? ValueKind::kBare
                                     : ValueKind::kText);
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

  [[nodiscard]] std::string text() const { return rows_ + below_; }

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
    below_ +=
        fmt::format("\n## `{}`\n\n{}{}\n{}", heading, key.doc, kinds_text(key.kinds), inner.text());
  }

  std::string path_, rows_, below_;
};

}  // namespace
}  // namespace io

std::string curve_table() {
  std::string table =
      "| column | unit | definition | over | in the store |\n|---|---|---|---|---|\n";
  for (const CurveColumn& c : kCurveColumns)
    table += fmt::format("| `{}` | {} | {}{} | {} | `{}` |\n", c.name, c.unit,
                         c.of == ColumnOf::kLintelOfZones ? "only with a lintel of zones: "
                         : c.of == ColumnOf::kHeldHead    ? "only with `across = \"blocked\"`: "
                                                          : "",
                         io::cell(c.meaning), c.over, c.stored);
  return table;
}

std::string responses_table() {
  std::string table =
      "| key | unit | definition | in the store | in `samples` |\n|---|---|---|---|---|\n";
  const auto line = [&](const OutputKey& key, const auto&) {
    const std::string column =
        key.listed == OutputKey::kNowhere
            ? ""
            : fmt::format("`{}`{}", key.column, key.listed == OutputKey::kCsv ? ", CSV" : "");
    table += fmt::format("| `{}` | {} | {} | `{}` | {} |\n", key.summary, key.unit,
                         io::cell(key.meaning), key.stored, column);
  };
  const Responses responses;
  const RateVerdict meters;
  each_response(line, responses);
  each_quasi_static(line, meters);
  return table;
}

std::string reference_page() {
  ModelSpec spec;
  io::Reference reference("");
  io::describe(reference, spec);
  return io::kHeader + reference.text();
}

namespace {
// The responses as summary.json has them, as a type of TypeScript. Numbers may be null there.
std::string responses_type() {
  std::string text =
      "// The responses in summary.json, from include/wythe/parts/responses.h: make docs writes "
      "this file.\n"
      "import type { Said } from \"../base/texts\";\n"
      "import type { Maybe } from \"./common\";\n\n"
      "export interface Responses {\n";
  std::string open;  // object of the last key
  const auto enter = [&](const std::string& object) {
    if (object == open) return;
    if (!open.empty()) text += "  };\n";
    if (!object.empty()) text += fmt::format("  {}: {{\n", object);
    open = object;
  };
  const auto line = [&](const OutputKey& key, const auto& value) {
    using Value = std::decay_t<decltype(value)>;
    const char* type = std::is_same_v<Value, double>    ? "Maybe"
                       : std::is_same_v<Value, bool>    ? "boolean"
                       : std::is_same_v<Value, Message> ? "Said"
                                                        : "string";
    static_assert(std::is_same_v<Value, double> || std::is_same_v<Value, bool> ||
                  std::is_same_v<Value, Message> || std::is_same_v<Value, std::string>);
    const std::string path = key.summary;  // "bilinear.force_kN" is a member of an object
    const std::size_t dot = path.find('.');
    const bool is_inside = dot != std::string::npos;
    enter(is_inside ? path.substr(0, dot) : "");
    text += fmt::format("  {}{}: {}; // {}{}\n", is_inside ? "  " : "",
                        is_inside ? path.substr(dot + 1) : path, type,
                        *key.unit ? fmt::format("[{}] ", key.unit) : "", key.meaning);
  };
  const Responses responses;
  const RateVerdict meters;
  each_response(line, responses);
  each_quasi_static(line, meters);
  enter("");
  return text + "}\n";
}

// Puts a table between its two marks on a page.
void put_table(std::string& page, const std::string& path, const std::string& name,
               const std::string& table) {
  const std::string begin = fmt::format("<!-- {}: make docs -->\n", name);
  const std::size_t from = page.find(begin), to = page.find("<!-- end -->", from);
  if (from == std::string::npos || to == std::string::npos)
    throw IoError(
        fmt::format("{}: a table belongs between {} and <!-- end -->, which are not there", path,
                    trimmed(begin)));
  page.replace(from + begin.size(), to - from - begin.size(), table);
}
}  // namespace

void write_reference(const std::string& folder, const std::string& headers) {
  constexpr std::size_t kMost = 1 << 20;  // bytes of a page
  const std::string results = folder + "/results.md";
  std::string page = read_text(results, kMost);
  put_table(page, results, "columns of the curve", curve_table());
  put_table(page, results, "responses", responses_table());
  write_text(results, page);
  write_text(folder + "/model.md", reference_page());
  write_text(headers + "/responses.ts", responses_type());
}

}  // namespace wythe
