// Reading of single values: type, unit, range. Every refusal says what to write instead.
#include "io/text/toml_reader.h"

#include <algorithm>
#include <cmath>
#include <filesystem>

#include <fmt/format.h>

#include "core/files.h"
#include "core/number.h"
#include "core/shape.h"
#include "core/text.h"
#include "io/text/magnitude.h"
#include "io/text/range_text.h"
#include "io/text/toml_slips.h"
#include "units/quantity_error.h"
#include "wythe/parts/io.h"
#include "wythe/parts/text.h"
#include "wythe/parts/units.h"

namespace wythe::io {
namespace {

std::string cure_by_example(const char* name, const Key& key, ValueKind kind) {
  const std::string example = example_text(name, key, kind);
  return example.empty() ? "" : "write e.g. " + example;
}

constexpr double kMostWhole = std::numeric_limits<int>::max();

// What to write for a text where a number is asked for: its own number, if that is one of the key's; else the example.
// A share in % is meant as a share of 1, and "0.15 g" as the multiple of gravity that the keys of loads ask for.
std::string cure_of_text(const toml::node& node, const char* name, const Key& key, bool is_whole) {
  const auto* text = node.as_string();
  const auto found = text ? leading_number(trimmed(text->get())) : std::nullopt;
  const std::string_view unit = found ? trimmed(found->rest) : "?";
  const double value = found ? (unit == "%" ? found->value / 100 : found->value) : kUnset;
  const bool fits = !is_whole || (value == std::round(value) && value <= kMostWhole);
  const bool is_meant = (unit.empty() || unit == "%" || unit == "g") && std::isfinite(value) &&
                        key.range.holds(value) && fits;
  return is_meant ? fmt::format("write {} = {}", name, value)
                  : cure_by_example(name, key, ValueKind::kBare);
}

std::string range_problem(const Key& key) {
  std::string out = "must be " + range_text(key);
  if (key.may_be_unlimited) out += ", or \"unlimited\"";
  return out;
}

// Whether `above` is `path` itself or a table around it.
bool is_at_or_above(const std::string& above, const std::string& path) {
  return path == above || path.starts_with(above + '.');
}

std::vector<std::string> names_of(const std::vector<TableReader::Entry>& entries) {
  std::vector<std::string> names;
  for (const TableReader::Entry& entry : entries) names.push_back(entry.name);
  return names;
}

}  // namespace

int line_of(const toml::node& node) { return static_cast<int>(node.source().begin.line); }

std::string shown(const toml::node& node) {
  if (const auto* text = node.as_string()) return text->get();
  if (const auto* number = node.as_floating_point()) return fmt::format("{}", number->get());
  if (const auto* number = node.as_integer()) return fmt::format("{}", number->get());
  if (const auto* flag = node.as_boolean()) return flag->get() ? "true" : "false";
  if (node.is_table()) return "a table";
  if (node.is_array()) return "a list";
  return "a date or time";
}

void ReadContext::fault(const std::string& path, int line, const std::string& value,
                        const std::string& problem, const std::string& cure) {
  Fault out{
      .file = file, .path = path, .value = value, .problem = problem, .cure = cure, .line = line};
  if (const auto found = derived.find(path); found != derived.end()) {
    out.value += fmt::format(" ({})", found->second.how);
    if (line == 0) out.line = found->second.line;
  }
  for (const Override& set : overrides) {
    const bool reaches = is_at_or_above(set.path, path);
    // A table that is in no file was created for the override's key.
    const bool made = line == 0 && set.path.starts_with(path + '.') && !value.empty();
    if (!reaches && !made) continue;
    out.file = "--set";
    out.path = reaches ? set.given + path.substr(set.path.size()) : set.given;
    if (made) out.value.clear();
    out.line = 0;
  }
  faults.add(std::move(out));
}

// Whether there is a fault at the path, directly or under an override; with `below` also below the path.
static bool has_fault(const ReadContext& context, const std::string& path, bool below) {
  const auto is_at = [&](const Fault& fault, const std::string& place) {
    return fault.path == place || (below && fault.path.starts_with(place + '.'));
  };
  const auto& faults = context.faults.all();
  return std::any_of(faults.begin(), faults.end(), [&](const Fault& fault) {
    return is_at(fault, path) ||
           std::any_of(context.overrides.begin(), context.overrides.end(), [&](const Override& o) {
             return is_at_or_above(o.path, path) &&
                    is_at(fault, o.given + path.substr(o.path.size()));
           });
  });
}

bool ReadContext::has_fault_at(const std::string& path) const {
  return has_fault(*this, path, false);
}
bool ReadContext::has_fault_in(const std::string& path) const {
  return has_fault(*this, path, true);
}

// --- single values -------------------------------------------------------------------------------

std::optional<double> TableReader::unlimited(const std::string& text, const Key& key) {
  if (!key.may_be_unlimited) return std::nullopt;
  std::string_view word = trimmed(text);
  if (word == "unlimited") return kUnlimited;
  if (word.starts_with('+')) word.remove_prefix(1);
  if (!word.starts_with("inf")) return std::nullopt;
  try {
    (void)parse_quantity("1" + std::string(word.substr(3)), key.unit);
    return kUnlimited;
  } catch (const QuantityError&) {
    return std::nullopt;
  }
}

// The correct spelling where a weight is given for a mass, or a mass for a weight; "" for other values.
static std::string weight_and_mass(const std::string& text, const char* name, const Key& key) {
  constexpr double kGravity = 9.81;
  struct Pair {
    const char *mass, *weight;
  };
  for (const Pair& pair :
       {Pair{"kg", "N"}, {"kg/m", "N/m"}, {"kg/m^2", "Pa"}, {"kg/m^3", "N/m^3"}}) {
    const bool wants_mass = std::string_view(key.unit) == pair.mass;
    if (!wants_mass && std::string_view(key.unit) != pair.weight) continue;
    try {
      const double given = parse_quantity(text, wants_mass ? pair.weight : pair.mass);
      const double meant = wants_mass ? given / kGravity : given * kGravity;
      return fmt::format("write {} = \"{:.4g} {}\", {} {} 9.81 m/s^2", name,
                         meant / unit_factor(key.shown, key.unit), key.shown, text,
                         wants_mass ? "divided by" : "times");
    } catch (const QuantityError&) {
    }
  }
  return "";
}

// The cure where a floor load by area is given for a load along the wall; "" for other values.
static std::string load_by_area(const std::string& text, const char* name, const Key& key) {
  if (std::string_view(name) != "load" || std::string_view(key.unit) != "N/m") return "";
  try {
    (void)parse_quantity(text, "Pa");
    return "write it in kN/m; or write g1, g2, q, psi2 and span, which make it from kN/m^2";
  } catch (const QuantityError&) {
    return "";
  }
}

std::optional<double> TableReader::read_quantity(const toml::node& node, const std::string& path,
                                                 const char* name, const Key& key) {
  const std::string example = example_text(name, key, ValueKind::kQuantity);
  const auto refuse_value = [&](const std::string& problem, const std::string& cure) {
    context_.fault(path, line_of(node), shown(node), problem, cure);
    return std::optional<double>();
  };
  if (node.is_number())
    return refuse_value("has no unit", "write it with its unit, e.g. " + example);
  const auto* text = node.as_string();
  if (!text) return refuse_value("must be a quantity in quotes", "write e.g. " + example);
  if (const auto value = unlimited(text->get(), key)) return value;
  try {
    const double value = parse_quantity(text->get(), key.unit);
    if (key.range.holds(value)) {
      const std::string problem = magnitude_problem(value, key.unit);
      if (problem.empty()) return value;
      return refuse_value(problem, "check its unit; write e.g. " + example);
    }
    Key broken = key;  // for a length or speed below its range, only the lower end matters
    if (value <= key.range.low && std::string_view(key.unit) != "rad")
      broken.range.high = std::numeric_limits<double>::infinity(), broken.range.high_open = false;
    return refuse_value(range_problem(broken), "write e.g. " + example);
  } catch (const QuantityError& error) {
    const bool bare = error.problem() == "has no unit";
    if (error.problem() == "has a decimal comma")
      return refuse_value(error.problem(), error.cure());
    if (key.may_be_unlimited && trimmed(text->get()).starts_with("inf"))
      return refuse_value(error.problem(), fmt::format("write {} = \"unlimited\"", name));
    if (const std::string cure = bare ? "" : load_by_area(text->get(), name, key); !cure.empty())
      return refuse_value("is a load by area, where one along the wall is asked for", cure);
    if (const std::string cure = bare ? "" : weight_and_mass(text->get(), name, key); !cure.empty())
      return refuse_value(error.problem(), cure);
    return refuse_value(error.problem(),
                        (bare ? "write it with its unit, e.g. " : "write e.g. ") + example);
  }
}

void TableReader::quantity(const char* name, double& value, const Key& key) {
  const toml::node* node = find(name, key);
  if (!node) return;
  if (const auto read = read_quantity(*node, below(name), name, key)) value = *read;
}

void TableReader::quantities(const char* name, std::vector<double>& values, const Key& key) {
  const toml::node* node = find(name, key);
  if (!node) return;
  const toml::array* array = node->as_array();
  if (!array) {
    refuse(name, "must be a list of quantities", cure_by_example(name, key, ValueKind::kQuantity));
    return;
  }
  values.clear();
  for (std::size_t i = 0; i < array->size() && !enough(context_.faults); ++i) {
    const std::string path = under(below(name), std::to_string(i));
    const auto read = read_quantity(*array->get(i), path, name, key);
    if (!read) return;  // the others mostly have the same mistake
    values.push_back(*read);
  }
}

void TableReader::points(const char* name, std::vector<std::array<double, 2>>& points,
                         const Key& key) {
  const toml::node* node = find(name, key);
  if (!node) return;
  const auto is_pair = [](const toml::node& item) {
    return item.is_array() && item.as_array()->size() == 2;
  };
  const toml::array* array = node->as_array();
  if (!array || !std::all_of(array->begin(), array->end(), is_pair)) {
    refuse(name, "must be a list of points, each with x and y",
           fmt::format("write e.g. {} = {}", name, key.example));
    return;
  }
  points.clear();
  for (std::size_t i = 0; i < array->size() && !enough(context_.faults); ++i) {
    const toml::array& pair = *array->get(i)->as_array();
    const std::string path = under(below(name), std::to_string(i));
    const auto x = read_quantity(*pair.get(0), under(path, "0"), name, key);
    const auto y = read_quantity(*pair.get(1), under(path, "1"), name, key);
    if (x && y) points.push_back({*x, *y});
  }
}

void TableReader::numbers(const char* name, std::vector<double>& values, const Key& key) {
  const toml::node* node = find(name, key);
  if (!node) return;
  const auto is_good = [](const toml::node& item) {
    return item.is_number() && std::isfinite(*item.value<double>());
  };
  toml::array one;
  if (key.may_be_alone && is_good(*node)) one.push_back(*node->value<double>());
  const toml::array* array = one.empty() ? node->as_array() : &one;
  if (!array || !std::all_of(array->begin(), array->end(), is_good)) {
    refuse(name,
           key.may_be_alone ? "must be a number, or a list of them, without quotes"
                            : "must be a list of numbers without quotes",
           cure_by_example(name, key, ValueKind::kBare));
    return;
  }
  values.clear();
  for (const toml::node& item : *array) {
    const double value = *item.value<double>();
    if (const std::string problem = magnitude_problem(value, "1"); !problem.empty())
      return refuse(name, problem, cure_by_example(name, key, ValueKind::kBare));
    values.push_back(value);
  }
}

void TableReader::number(const char* name, double& value, const Key& key) {
  const toml::node* node = find(name, key);
  if (!node) return;
  const auto read = node->is_number() ? node->value<double>() : std::nullopt;
  const std::string cure = cure_by_example(name, key, ValueKind::kBare);
  if (!read) {
    refuse(name, "must be a number without quotes", cure_of_text(*node, name, key, false));
  } else if (!std::isfinite(*read)) {
    refuse(name, "is not a finite number", cure);
  } else if (!key.range.holds(*read)) {
    refuse(name, range_problem(key), cure);
  } else if (const std::string problem = magnitude_problem(*read, "1"); !problem.empty()) {
    refuse(name, problem, cure);
  } else {
    value = *read;
  }
}

void TableReader::integer(const char* name, int& value, const Key& key) {
  const toml::node* node = find(name, key);
  if (!node) return;
  const auto* read = node->as_integer();
  const std::string cure = cure_by_example(name, key, ValueKind::kBare);
  Range range = key.range;
  range.high = std::min(range.high, kMostWhole);
  if (!read) {
    refuse(name, "must be a whole number without quotes", cure_of_text(*node, name, key, true));
  } else if (!range.holds(static_cast<double>(read->get()))) {
    refuse(name, range_problem(key), cure);
  } else {
    value = static_cast<int>(read->get());
  }
}

void TableReader::flag(const char* name, bool& value, const Key& key) {
  const toml::node* node = find(name, key);
  if (!node) return;
  const auto* read = node->as_boolean();
  if (read) {
    value = read->get();
  } else {
    refuse(name, "must be true or false, without quotes",
           cure_by_example(name, key, ValueKind::kBare));
  }
}

namespace {

bool is_one_of_paths(std::string_view key) {
  return key == "file" || key == "blocks" || key == "model" || key == "logo";
}

}  // namespace

void TableReader::text(const char* name, std::string& value, const Key& key) {
  const toml::node* node = find(name, key, true);
  if (!node) return;
  const auto* read = node->as_string();
  if (read) {
    value = read->get();
    const bool is_path = is_one_of_paths(name);
    if (const std::string meant = is_path ? path_as_meant(value) : ""; !meant.empty())
      refuse(name, "holds a tab or another mark that a \\ in double quotes makes",
             fmt::format("write {} = \"{}\", or single quotes", name, meant));
  } else {
    refuse(name, "must be a text in quotes", cure_by_example(name, key, ValueKind::kText));
  }
}

void TableReader::texts(const char* name, std::vector<std::string>& values, const Key& key) {
  const toml::node* node = find(name, key, true);
  if (!node) return;
  const toml::array* array = node->as_array();
  const std::size_t count = key.count;
  const bool good = array && (array->empty() || array->is_homogeneous<std::string>()) &&
                    (count == 0 || array->size() == count);
  if (!good) {
    const std::string many = count ? std::to_string(count) : "";
    refuse(name, fmt::format("must be a list of {}{}texts in quotes", many, count ? " " : ""),
           cure_by_example(name, key, ValueKind::kText));
    return;
  }
  values.clear();
  for (const toml::node& item : *array) values.push_back(item.as_string()->get());
}

int TableReader::choose(const char* name, const std::vector<std::string>& words, const Key& key) {
  const toml::node* node = find(name, key, true);
  if (!node) return -1;
  const auto* read = node->as_string();
  const auto found = read ? std::find(words.begin(), words.end(), read->get()) : words.end();
  if (found != words.end()) return static_cast<int>(found - words.begin());
  const std::string nearest = read ? nearest_name(read->get(), words) : "";
  refuse(name, "must be one of " + joined(words, ", "),
         nearest.empty() ? cure_by_example(name, key, ValueKind::kText)
                         : fmt::format("did you mean \"{}\"?", nearest));
  return -1;
}

// --- tables --------------------------------------------------------------------------------------

void refuse_table_wanted(ReadContext& context, const toml::node& node, const std::string& path,
                         const std::string& name, const char* example) {
  const bool numbered = path.find_first_of("0123456789") != std::string::npos;
  const std::string written = *example != '\0' ? example : "{ ... }";
  context.fault(path, line_of(node), shown(node), "must be a table",
                numbered ? fmt::format("write {} = {}", name, written)
                         : fmt::format("write it under [{}]", path));
}

void refuse_list_wanted(ReadContext& context, const toml::node& node, const std::string& path) {
  context.fault(path, line_of(node), shown(node), "must be a list of tables",
                fmt::format("write each under [[{}]], with two brackets", path));
}

const toml::table* TableReader::as_table(const toml::node& node, const std::string& name,
                                         const char* example) {
  if (const toml::table* table = node.as_table()) return table;
  refuse_table_wanted(context_, node, below(name), name, example);
  return nullptr;
}

const toml::array* TableReader::as_list_of_tables(const toml::node& node, const std::string& name) {
  const toml::array* array = node.as_array();
  const bool good = array && std::all_of(array->begin(), array->end(),
                                         [](const toml::node& item) { return item.is_table(); });
  if (good) return array;
  refuse_list_wanted(context_, node, below(name));
  return nullptr;
}

const toml::node* TableReader::find(const char* name, const Key& key, bool is_text) {
  const toml::node* node = table_.get(name);
  entries_.push_back({name, key, node, is_text});
  return node;
}

const TableReader::Entry* TableReader::entry(std::string_view name) const {
  for (const Entry& entry : entries_)
    if (entry.name == name) return &entry;
  return nullptr;
}

bool TableReader::has(std::string_view name) const {
  const Entry* found = entry(name);
  return found && found->node;
}

void TableReader::refuse(std::string_view name, const std::string& problem,
                         const std::string& cure) {
  const toml::node* node = table_.get(name);
  context_.fault(below(std::string(name)), node ? line_of(*node) : line_of(table_),
                 node ? shown(*node) : "", problem, cure);
}

void TableReader::miss(std::string_view name, const std::string& problem, const std::string& cure) {
  const Entry* found = entry(name);
  std::string advice = cure;
  if (advice.empty() && found) {
    const ValueKind kind = found->is_text     ? ValueKind::kText
                           : *found->key.unit ? ValueKind::kQuantity
                                              : ValueKind::kBare;
    advice = cure_by_example(found->name.c_str(), found->key, kind);
  }
  context_.fault(below(std::string(name)), line_of(table_), "", problem, advice);
}

void TableReader::refuse_member(std::string_view list, std::size_t index, std::string_view name,
                                const std::string& problem, const std::string& cure) {
  const auto item = table_.at_path(list)[index][name];
  const std::string path = fmt::format("{}.{}.{}", below(std::string(list)), index, name);
  context_.fault(path, item ? line_of(*item.node()) : 0, item ? shown(*item.node()) : "", problem,
                 cure);
}

void TableReader::refuse_table(const std::string& problem, const std::string& cure) {
  context_.fault(path_, line_of(table_), "", problem, cure);
}

void TableReader::refuse_unknown() {
  const std::vector<std::string> known = names_of(entries_);
  for (const auto& [name, node] : table_) {
    const std::string word(name.str());
    if (entry(word)) continue;
    has_unknown_ = true;
    if (enough(context_.faults)) return;
    context_.fault(below(word), line_of(node), shown(node), fmt::format("no such key {}", word),
                   name_advice(word, known));
  }
}

// --- whole files ---------------------------------------------------------------------------------

toml::table parse_toml(const std::string& text, const std::string& file) {
  check_shape(text, Syntax::kToml, file);
  try {
    return toml::parse(text, file);
  } catch (const toml::parse_error& error) {
    const auto line = static_cast<int>(error.source().begin.line);
    std::string_view rest = text;
    for (int k = 1; k < line && !rest.empty(); ++k)
      rest.remove_prefix(std::min(rest.size(), rest.find('\n') + 1));
    constexpr std::size_t kLongestLine = 1000;
    const std::string_view written = rest.substr(0, std::min(rest.find('\n'), kLongestLine));
    Slip slip = slip_in(written);
    if (slip.problem.empty()) slip = stated_twice(written, error.description());
    if (slip.problem.empty()) slip = slip_of_parser(error.description());
    throw InputError({Fault{.file = file,
                            .problem = "not valid TOML: " + slip.problem,
                            .cure = slip.cure,
                            .line = line}});
  }
}

std::string nearest_file(const std::string& path) {
  namespace fs = std::filesystem;
  std::error_code error;
  const fs::path above = fs::path(path).parent_path();
  std::vector<std::string> beside;
  for (fs::directory_iterator it(above.empty() ? "." : above, error), end; !error && it != end;
       it.increment(error))
    beside.push_back(it->path().filename().string());
  const std::string own = fs::path(path).filename().string(), near = nearest_name(own, beside);
  // the ending does not count: one.toml is not near to two.toml
  const auto stem = [](const std::string& name) {
    return small_letters(fs::path(name).stem().string());
  };
  const int most = std::max(1, static_cast<int>(stem(own).size()) / 3);
  return near == own || near.empty() || edit_distance(stem(own), stem(near)) > most ? "" : near;
}

std::string read_input(const std::string& path, const char* example, std::size_t most) {
  namespace fs = std::filesystem;
  std::error_code error;
  // the link itself: for a link that leads nowhere, read_text reports it
  if (fs::symlink_status(path, error).type() != fs::file_type::not_found)
    return read_text(path, most);
  const fs::path above = fs::path(path).parent_path();
  const std::string nearest = nearest_file(path);
  throw InputError({Fault{
      .file = path,
      .problem = "there is no such file",
      .cure = nearest.empty() ? fmt::format("name a file, e.g. {}", example)
                              : fmt::format("did you mean {}?", (above / nearest).string())}});
}

void throw_faults(const ReadContext& context) {
  std::vector<Fault> sorted = context.faults.all();
  std::stable_sort(sorted.begin(), sorted.end(),
                   [](const Fault& a, const Fault& b) { return a.line < b.line; });
  if (!sorted.empty()) throw InputError(std::move(sorted));
}

bool is_unit_joint(const toml::table& root, std::string_view name) {
  if (name == "unit") return true;
  const auto names_it = [&](const toml::node* table) {
    const toml::table* known = table ? table->as_table() : nullptr;
    return known && (*known)["unit_joint"].value<std::string_view>() == name;
  };
  if (names_it(root.get("wall"))) return true;
  for (const char* part : {"storey", "region"})
    if (const toml::array* list = root[part].as_array())
      for (const toml::node& item : *list)
        if (names_it(&item)) return true;
  return false;
}

std::vector<std::pair<std::string, const toml::table*>> in_file_order(ReadContext& context,
                                                                      const toml::node* node,
                                                                      const std::string& part) {
  std::vector<std::pair<std::string, const toml::table*>> out;
  if (!node) return out;
  const toml::table* tables = node->as_table();
  if (!tables) {
    context.fault(part, line_of(*node), shown(*node), "must be named tables",
                  fmt::format("write each under [{}.<name>]", part));
    return out;
  }
  for (const auto& [name, inner] : *tables) {
    const std::string label(name.str());
    if (const toml::table* table = inner.as_table())
      out.emplace_back(label, table);
    else
      context.fault(under(part, label), line_of(inner), shown(inner), "must be a table",
                    fmt::format("write it under [{}.{}]", part, label));
  }
  std::stable_sort(out.begin(), out.end(), [](const auto& a, const auto& b) {
    return line_of(*a.second) < line_of(*b.second);
  });
  return out;
}

}  // namespace wythe::io
