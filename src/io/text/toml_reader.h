// A visitor that fills a struct from a TOML table and notes every fault with its place.
//
//   ReadContext context{file};                    one per file: faults, --set overrides
//   parse_table(context, table, "wall", spec);     describe(), then unknown keys, then finish()
//
// After describe() the reader knows the possible keys of the table and the present ones. finish() of
// a struct (stage_check.cpp, material_check.cpp) uses this for checks that a range cannot express.
#pragma once

#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include <toml++/toml.h>

#include "core/limits.h"
#include "io/keys/describe.h"
#include "wythe/parts/error.h"

namespace wythe::io {

// One --set that was put into the tree: `path` is its place there
// ("stage.2.velocity"), `given` the user's spelling ("stage.push.velocity").
struct Override {
  std::string path;
  std::string given;
};

// "material.joint.friction_tan" is the key friction_angle, given as its tangent.
inline std::string angle_path(const std::string& path) {
  return path.ends_with("friction_tan") ? path.substr(0, path.size() - 3) + "angle" : path;
}

struct ReadContext {
  std::string file;
  FaultList faults = {};
  std::vector<Override> overrides = {};
  // Values that rules and typologies put into the tree, by path, and the keys of [masonry] that they used.
  struct Derived {
    std::string how;
    int line = 0;  // of the table
  };
  std::map<std::string, Derived> derived = {};
  std::set<std::string, std::less<>> asked = {};
  // Values whose rule lacks an input with a reported fault; they are no faults themselves.
  std::set<std::string, std::less<>> follow_ups = {};
  // Materials of the mortar of layers, which gives them its own stiffness: the layer checks them.
  std::set<std::string, std::less<>> mortars = {};
  const std::map<std::string, std::string>* records = nullptr;  // content of record files, by name

  // Adds a fault at `path`; if an override set that path, it is the override's fault.
  void fault(const std::string& path, int line, const std::string& value,
             const std::string& problem, const std::string& cure);
  [[nodiscard]] bool has_fault_at(const std::string& path) const;
  // Whether there is a fault at the path, or at a key or member below it.
  [[nodiscard]] bool has_fault_in(const std::string& path) const;
};

// Refuses a value where a table or list is required, or the reverse, in words.
void refuse_table_wanted(ReadContext& context, const toml::node& node, const std::string& path,
                         const std::string& name, const char* example = "");
void refuse_list_wanted(ReadContext& context, const toml::node& node, const std::string& path);

[[nodiscard]] int line_of(const toml::node& node);
// The node in the user's terms: a text without its quotes, "a table", "a list".
[[nodiscard]] std::string shown(const toml::node& node);

class TableReader {
 public:
  TableReader(ReadContext& context, const toml::table& table, std::string path)
      : context_(context), table_(table), path_(std::move(path)) {}

  void quantity(const char* name, double& value, const Key& key);
  void quantities(const char* name, std::vector<double>& values, const Key& key);
  void points(const char* name, std::vector<std::array<double, 2>>& points, const Key& key);
  void numbers(const char* name, std::vector<double>& values, const Key& key);
  void number(const char* name, double& value, const Key& key);
  void integer(const char* name, int& value, const Key& key);
  void flag(const char* name, bool& value, const Key& key);
  void text(const char* name, std::string& value, const Key& key);
  void texts(const char* name, std::vector<std::string>& values, const Key& key);
  // A known key that is applied and removed before the table is read (materials.cpp).
  void recipe(const char* name, const Key& key) { (void)find(name, key); }

  template <class E, std::size_t N>
  void choice(const char* name, E& value, const Word<E> (&words)[N], const Key& key) {
    std::vector<std::string> known;
    for (const Word<E>& word : words) known.emplace_back(word.word);
    if (const int found = choose(name, known, key); found >= 0) value = words[found].value;
  }

  template <class T>
  void table(const char* name, T& value, const Key& key) {
    const toml::node* node = find(name, key);
    if (!node) return;
    if (const toml::table* inner = as_table(*node, name, key.example))
      parse_table(context_, *inner, below(name), value);
  }

  template <class T>
  void list(const char* name, std::vector<T>& values, const Key& key) {
    const toml::node* node = find(name, key);
    if (!node) return;
    if (const toml::table* only = key.in_braces ? node->as_table() : nullptr)
      return parse_table(context_, *only, under(below(name), "0"), values.emplace_back());
    const toml::array* array = as_list_of_tables(*node, name);
    for (std::size_t i = 0; array && i < array->size() && !enough(context_.faults); ++i) {
      const std::string path = under(below(name), std::to_string(i));
      parse_table(context_, *array->get(i)->as_table(), path, values.emplace_back());
    }
  }

  template <class T>
  void map(const char* name, std::map<std::string, T>& values, const Key& key) {
    const toml::node* node = find(name, key);
    const toml::table* outer = node ? as_table(*node, name) : nullptr;
    if (!outer) return;
    for (const auto& [inner_name, inner] : *outer) {
      if (enough(context_.faults)) return;
      const std::string label(inner_name.str());
      const toml::table* found = as_table(inner, under(name, label));
      if (found) parse_table(context_, *found, under(below(name), label), values[label]);
    }
  }

  void refuse_unknown();
  // The node of a key that is parsed by hand; null when absent.
  const toml::node* find(const char* name, const Key& key, bool is_text = false);

  // The kind of a stage: the stated one, or that of the keys that are present (stage_check.cpp).
  [[nodiscard]] StageKind kind_by_keys(StageKind stated) const;

  // --- for finish() ---
  struct Entry {
    std::string name;
    Key key;
    const toml::node* node;  // nullptr when absent
    bool is_text = false;    // its example is written in quotes
  };
  [[nodiscard]] const std::vector<Entry>& entries() const { return entries_; }
  [[nodiscard]] bool has(std::string_view name) const;
  // Whether the table has an unknown key, which was refused. Its intended value is then missing elsewhere.
  [[nodiscard]] bool has_unknown() const { return has_unknown_; }
  [[nodiscard]] std::string below(const std::string& name) const { return under(path_, name); }
  [[nodiscard]] ReadContext& context() { return context_; }
  // Adds faults at a present key, at a missing key, and at the table itself.
  void refuse(std::string_view name, const std::string& problem, const std::string& cure);
  void miss(std::string_view name, const std::string& problem, const std::string& cure = "");
  void refuse_member(std::string_view list, std::size_t index, std::string_view name,
                     const std::string& problem, const std::string& cure);
  void refuse_table(const std::string& problem, const std::string& cure);

 private:
  const Entry* entry(std::string_view name) const;
  int choose(const char* name, const std::vector<std::string>& words, const Key& key);
  const toml::table* as_table(const toml::node& node, const std::string& name,
                              const char* example = "");
  const toml::array* as_list_of_tables(const toml::node& node, const std::string& name);
  std::optional<double> read_quantity(const toml::node& node, const std::string& path,
                                      const char* name, const Key& key);
  std::optional<double> unlimited(const std::string& text, const Key& key);

  ReadContext& context_;
  const toml::table& table_;
  std::string path_;
  std::vector<Entry> entries_;
  bool has_unknown_ = false;
};

// Checks between several keys of one struct; does nothing for most structs.
template <class T>
void finish(TableReader&, T&) {}
void finish(TableReader& reader, StageSpec& stage);
void finish(TableReader& reader, PlaceSpec& place);
void finish(TableReader& reader, JointMaterial& material);
void finish(TableReader& reader, ContactRule& rule);
void finish(TableReader& reader, LintelSpec& lintel);
void finish(TableReader& reader, SillSpec& sill);
void finish(TableReader& reader, ArchSpec& arch);
void finish(TableReader& reader, ModelSpec& model);
void finish(TableReader& reader, SpectrumSpec& spectrum);
void finish(TableReader& reader, AssessmentSpec& assessment);
void finish(TableReader& reader, HoldSpec& hold);
void finish(TableReader& reader, TeethSpec& teeth);
void finish(TableReader& reader, PartSpec& part);

// "" for a word of BlockRole and for an empty one; else the list of words.
[[nodiscard]] std::string role_advice(const std::string& role);

template <class T>
void parse_table(ReadContext& context, const toml::table& table, const std::string& path,
                 T& value) {
  TableReader reader(context, table, path);
  describe(reader, value);
  reader.refuse_unknown();
  finish(reader, value);
}

// Parses TOML. Throws InputError with the line for a syntax error, and for a text that is too deep or too long.
[[nodiscard]] toml::table parse_toml(const std::string& text, const std::string& file);
// Reads a file that the user named, by read_text (core/files.h); if it does not exist, suggests the nearest name beside it.
[[nodiscard]] std::string read_input(const std::string& path, const char* example,
                                     std::size_t most = kMostToml);
// The name of an existing file nearby that differs in case or a letter or two; "" where there is none.
[[nodiscard]] std::string nearest_file(const std::string& path);
// The path of `other`, given relative to `file`, as seen from the working directory.
[[nodiscard]] std::string beside(const std::string& file, const std::string& other);
[[nodiscard]] bool has_study(const toml::table& root);
// Throws where the tree of a model is given for a study, or that of a study for a model.
void refuse_study(const toml::table& root, const std::string& file);
void refuse_model(const toml::table& root, const std::string& file);
// Throws all faults of the context, ordered by line.
void throw_faults(const ReadContext& context);

// Puts derived and typical values into the tree, before it is read (materials.cpp).
void resolve_materials(ReadContext& context, toml::table& root);
// The same for floor loads by area and span (floor_loads.cpp).
void resolve_floors(ReadContext& context, toml::table& root);
[[nodiscard]] bool is_law_key(std::string_view name);
// "unit", and the unit_joint of wall, storeys and regions: the law of a crack in a unit.
[[nodiscard]] bool is_unit_joint(const toml::table& root, std::string_view name);

// A table as "path=value" texts that recreate it.
void list_settings(const toml::table& table, const std::string& path,
                   std::vector<std::string>& texts);

// Puts "path=value" texts into the tree before it is read (overrides.cpp).
void apply_overrides(ReadContext& context, toml::table& root,
                     const std::vector<std::string>& texts);

// Named tables in the order of the file; TOML sorts them by name.
[[nodiscard]] std::vector<std::pair<std::string, const toml::table*>> in_file_order(
    ReadContext& context, const toml::node* node, const std::string& part);

}  // namespace wythe::io
