// Corrects the tree from the top, table by table. Unknown keys move to the one table that has them all, or get the
// nearest name. Then wrong brackets are corrected: a table for a list, or the reverse. Each mistake adds a fault,
// so a corrected text is never accepted. A name without a near one is left to the table's reader.
#include "io/keys/meant_names.h"

#include <algorithm>

#include <fmt/format.h>

#include "core/text.h"
#include "wythe/parts/text.h"

namespace wythe::io {
namespace {

using Shape = KnownName::Shape;
using Names = std::vector<KnownName>;

// Words of other programs and of papers for our names.
struct OtherWord {
  const char *theirs, *ours;
};
constexpr OtherWord kOtherWords[] = {{"friction_coefficient", "friction_tan"},
                                     {"friction", "friction_tan"},
                                     {"mu", "friction_tan"},
                                     {"phi", "friction_angle"},
                                     {"c", "cohesion"},
                                     {"ft", "tensile_strength"},
                                     {"fc", "compressive_strength"},
                                     {"fb", "unit_strength"},
                                     {"fm", "masonry_strength"},
                                     {"kn", "normal_stiffness"},
                                     {"ks", "shear_stiffness"},
                                     {"kt", "shear_stiffness"},
                                     {"gf1", "mode_1_energy"},
                                     {"gfi", "mode_1_energy"},
                                     {"gf2", "mode_2_energy"},
                                     {"gfii", "mode_2_energy"},
                                     {"e", "youngs_modulus"},
                                     {"elastic_modulus", "youngs_modulus"},
                                     {"modulus", "youngs_modulus"},
                                     {"g", "shear_modulus"},
                                     {"nu", "poisson_ratio"},
                                     {"rho", "density"},
                                     {"speed", "velocity"},
                                     {"studies", "study"},
                                     {"min", "low"},
                                     {"max", "high"},
                                     {"sd", "standard_deviation"},
                                     {"std", "standard_deviation"},
                                     {"stdev", "standard_deviation"},
                                     {"sigma", "standard_deviation"},
                                     {"w", "weight"}};

const KnownName* find_name(const Names& known, std::string_view name) {
  const auto found = std::find_if(known.begin(), known.end(),
                                  [&](const KnownName& one) { return one.name == name; });
  return found == known.end() ? nullptr : &*found;
}

bool is_list_of_tables(const toml::node& node) {
  const toml::array* list = node.as_array();
  return list && !list->empty() && list->is_homogeneous<toml::table>();
}

// The known name that a wrong key most likely stands for; "" where none is near. The value must be no table. A
// name that the table already has is not suggested, except for tables, which may have been written in two parts.
std::string meant(const Names& known, const toml::table& table, const std::string& word) {
  const toml::node& value = *table.get(word);
  const bool holds_tables = value.is_table() || is_list_of_tables(value);
  std::vector<std::string> names;
  for (const KnownName& one : known)
    if (holds_tables ? one.below != nullptr : one.below == nullptr && !table.contains(one.name))
      names.push_back(one.name);
  for (const OtherWord& other : kOtherWords)
    if (small_letters(word) == other.theirs &&
        std::find(names.begin(), names.end(), other.ours) != names.end())
      return other.ours;
  return nearest_name(word, names);
}

// Coefficients of Table C8.5.II that the program lacks, with a reason of its own (io/model/office.cpp).
bool has_own_reason(std::string_view name) { return name == "core" || name == "thin_joints"; }

// A table of the description: its path as a user writes it, and what it may hold.
struct Home {
  std::string path;  // "wall.unit", "material.<name>", "stage"
  Shape shape = Shape::kTable;
  const Names* names = nullptr;
};

void add_homes(const Names& known, const std::string& path, std::vector<Home>& out) {
  constexpr std::size_t kDeepest = 40;  // characters; no description contains itself
  if (path.size() > 4 * kDeepest) return;
  for (const KnownName& one : known) {
    if (one.below == nullptr) continue;
    const std::string at = under(path, one.name) + (one.shape == Shape::kMap ? ".<name>" : "");
    out.push_back({at, one.shape, &one.below()});
    add_homes(one.below(), at, out);
  }
}

class Mender {
 public:
  Mender(ReadContext& context, toml::table& root, const Names& known)
      : context_(context), root_(root) {
    add_homes(known, "", homes_);
  }

  void mend(toml::table& table, const std::string& path, const Names& known) {
    std::vector<std::string> unknown;
    for (const auto& [name, node] : table)
      if (!find_name(known, name.str()) && !has_own_reason(name.str()))
        unknown.emplace_back(name.str());
    const Home* home = unknown.empty() ? nullptr : home_of(unknown, known);
    if (home != nullptr && !(unknown.size() == 1 && is_slip(table, unknown.front(), known)))
      move_home(table, path, unknown, *home);
    else
      for (const std::string& word : unknown) rename(table, path, word, known);
    for (const KnownName& one : known)
      if (toml::node* node = one.below ? table.get(one.name) : nullptr)
        mend_below(table, *node, under(path, one.name), one);
  }

 private:
  // --- names -------------------------------------------------------------------------------------

  // Whether a name is one or two letters from a name of the table, whatever other tables contain.
  static bool is_slip(const toml::table& table, const std::string& word, const Names& known) {
    constexpr int kLetters = 2;
    const std::string name = meant(known, table, word);
    return !name.empty() && edit_distance(word, name) <= kLetters;
  }

  void rename(toml::table& table, const std::string& path, const std::string& word,
              const Names& known) {
    toml::node& node = *table.get(word);
    const std::string name = meant(known, table, word);
    if (name.empty()) return;  // the table's reader lists the known names
    context_.fault(under(path, word), line_of(node), shown(node),
                   fmt::format("no such key {}", word), fmt::format("did you mean {}?", name));
    toml::node* there = table.get(name);
    if (there == nullptr) {
      node.visit([&](auto& value) { table.insert_or_assign(name, std::move(value)); });
    } else if (there->is_table() && node.is_table()) {
      join(*node.as_table(), *there->as_table());
    } else if (there->is_array() && node.is_array()) {
      join(*node.as_array(), *there->as_array());
    } else if (there->is_table() && node.is_array()) {  // [[openin]], then [opening.lintel]
      if (toml::table* last = node.as_array()->back().as_table()) join(*there->as_table(), *last);
      node.visit([&](auto& value) { table.insert_or_assign(name, std::move(value)); });
    }
    table.erase(word);
  }

  static void join(toml::table& from, toml::table& to) {
    for (auto&& [key, node] : from)
      if (const std::string name(key.str()); !to.contains(name))
        node.visit([&](auto& value) { to.insert_or_assign(name, std::move(value)); });
  }

  // Joins two lists in the order of their lines.
  static void join(toml::array& from, toml::array& to) {
    for (toml::node& node : from) {
      const auto at = std::find_if(to.begin(), to.end(), [&](const toml::node& other) {
        return line_of(other) > line_of(node);
      });
      node.visit([&](auto& value) { to.insert(at, std::move(value)); });
    }
  }

  // --- a missing header --------------------------------------------------------------------------

  // The only table, or the only one not there yet, that has all these names with no other spelling.
  const Home* home_of(const std::vector<std::string>& words, const Names& here) const {
    const auto knows_all = [&](const Home& home) {
      return home.names != &here && std::all_of(words.begin(), words.end(), [&](const auto& word) {
               return find_name(*home.names, word) != nullptr;
             });
    };
    std::vector<const Home*> able;
    for (const Home& home : homes_)
      if (knows_all(home)) able.push_back(&home);
    if (able.size() > 1 && words.size() > 1) {
      std::vector<const Home*> absent;
      for (const Home* home : able)
        if (home->shape == Shape::kTable && !is_written(home->path)) absent.push_back(home);
      if (absent.size() == 1) able = absent;
    }
    return able.size() == 1 ? able.front() : nullptr;
  }

  // Whether a table has a header of its own; [wall.unit] alone makes no [wall].
  bool is_written(const std::string& path) const {
    const toml::table* table = root_.at_path(path).as_table();
    return table != nullptr && std::any_of(table->begin(), table->end(), [](const auto& entry) {
             return !entry.second.is_table();
           });
  }

  void move_home(toml::table& table, const std::string& path, const std::vector<std::string>& words,
                 const Home& home) {
    const std::string head = home.shape == Shape::kList ? fmt::format("[[{}]]", home.path)
                                                        : fmt::format("[{}]", home.path);
    const auto first =
        *std::min_element(words.begin(), words.end(), [&](const auto& a, const auto& b) {
          return line_of(*table.get(a)) < line_of(*table.get(b));
        });
    const toml::node& node = *table.get(first);
    const bool one = words.size() == 1;
    context_.fault(under(path, first), line_of(node), shown(node),
                   one ? fmt::format("no such key {}", first)
                       : fmt::format("no such keys: {}", joined(words, ", ")),
                   fmt::format("{} under {}", one ? "it belongs" : "they belong", head));
    toml::table* target = target_of(home);
    for (const std::string& word : words) {
      if (target && !target->contains(word))
        table.get(word)->visit(
            [&](auto& value) { target->insert_or_assign(word, std::move(value)); });
      table.erase(word);
    }
  }

  // The table for the keys: one with a unique path, or the one member of a map; null where it is not unique.
  toml::table* target_of(const Home& home) {
    if (home.shape == Shape::kList || home.path.find('<') != home.path.rfind('<')) return nullptr;
    if (home.shape == Shape::kMap) {
      toml::table* map = root_[home.path.substr(0, home.path.find(".<"))].as_table();
      return map && map->size() == 1 ? map->begin()->second.as_table() : nullptr;
    }
    toml::table* table = &root_;
    for (std::size_t from = 0; table != nullptr && from < home.path.size();) {
      const std::size_t dot = std::min(home.path.find('.', from), home.path.size());
      const std::string step = home.path.substr(from, dot - from);
      if (!table->contains(step)) table->insert(step, toml::table{});
      table = table->get(step)->as_table();
      from = dot + 1;
    }
    return table;
  }

  // --- brackets ----------------------------------------------------------------------------------

  void mend_below(toml::table& table, toml::node& node, const std::string& path,
                  const KnownName& known) {
    if (known.shape == Shape::kList) {
      if (node.is_table() && !known.may_be_alone) {
        refuse_list_wanted(context_, node, path);
        toml::array list;
        list.push_back(std::move(*node.as_table()));
        table.insert_or_assign(known.name, std::move(list));
      }
    } else if (is_list_of_tables(node) && known.shape == Shape::kMap) {
      name_members(table, *node.as_array(), path, known.name);
    } else if (is_list_of_tables(node)) {
      refuse_table_wanted(context_, node, path, known.name);
      toml::table first = std::move(*node.as_array()->front().as_table());
      table.insert_or_assign(known.name, std::move(first));
    }
    descend(*table.get(known.name), path, known);
  }

  // Converts [[variable]] with a name in each to [variable.<name>].
  void name_members(toml::table& table, toml::array& list, const std::string& path,
                    const std::string& key) {
    toml::table named;
    std::string first;
    for (std::size_t i = 0; i < list.size(); ++i) {
      toml::table& member = *list.get(i)->as_table();
      const std::string label = member["name"].value<std::string>().value_or(std::to_string(i + 1));
      if (first.empty()) first = label;
      member.erase("name");
      named.insert_or_assign(label, std::move(member));
    }
    context_.fault(path, line_of(list), "a list", "must be named tables",
                   fmt::format("write each under a head of its own, e.g. [{}.{}]", path, first));
    table.insert_or_assign(key, std::move(named));
  }

  void descend(toml::node& node, const std::string& path, const KnownName& known) {
    const Names& names = known.below();
    if (toml::array* list = node.as_array()) {
      for (std::size_t i = 0; i < list->size(); ++i)
        if (toml::table* member = list->get(i)->as_table())
          mend(*member, under(path, std::to_string(i)), names);
    } else if (toml::table* inner = node.as_table(); inner && known.shape == Shape::kMap) {
      for (auto&& [label, member] : *inner) {
        const std::string at = under(path, std::string(label.str()));
        if (is_list_of_tables(member)) {
          refuse_table_wanted(context_, member, at, std::string(label.str()));
          toml::table first = std::move(*member.as_array()->front().as_table());
          inner->insert_or_assign(label.str(), std::move(first));
        }
        if (toml::table* one = inner->get(label.str())->as_table()) mend(*one, at, names);
      }
    } else if (inner) {
      mend(*inner, path, names);
    }
  }

  ReadContext& context_;
  toml::table& root_;
  std::vector<Home> homes_;
};

}  // namespace

void read_names_as_meant(ReadContext& context, toml::table& root,
                         const std::vector<KnownName>& known) {
  Mender(context, root, known).mend(root, "", known);
}

}  // namespace wythe::io
