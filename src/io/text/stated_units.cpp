// Reads sizes of units from the tree, because rules of materials are applied before the model is read. A
// key of the storey replaces that of the wall. If mortar is given, the joint is added to the size. A region
// without a storey may be in any. A value that is not a length gives NaN; the key's reader reports it.
#include "io/text/stated_units.h"

#include <algorithm>
#include <cmath>

#include "io/text/toml_reader.h"
#include "units/quantity_error.h"
#include "wythe/parts/units.h"

namespace wythe::io {
namespace {

using Text = std::optional<std::string>;

// The unit of a storey, with each key from the storey or else the wall; or of the wall if there is no storey.
struct Unit {
  const toml::table* own = nullptr;
  const toml::table* wall = nullptr;
  std::string name;  // of the storey

  [[nodiscard]] Text at(const char* table, const char* key) const {
    const Text mine = read(own, table, key);
    return mine ? mine : read(wall, table, key);
  }
  // The path of the key.
  [[nodiscard]] std::string path(const char* table, const char* key) const {
    const std::string part = read(own, table, key) ? "storey." + name : std::string("wall");
    return part + ".unit." + (*table != '\0' ? table : key);
  }

 private:
  static Text read(const toml::table* unit, const char* table, const char* key) {
    if (unit == nullptr) return std::nullopt;
    const auto node = *table != '\0' ? (*unit)[table][key] : (*unit)[key];
    if (!node) return std::nullopt;
    return node.value<std::string>().value_or("");  // else its reader reports it
  }
};

const toml::table* unit_of(const toml::table* part) {
  const toml::node* unit = part ? part->get("unit") : nullptr;
  return unit ? unit->as_table() : nullptr;
}

std::vector<const toml::table*> tables_of(const toml::table& root, const char* list) {
  std::vector<const toml::table*> tables;
  if (const toml::array* array = root[list].as_array())
    for (const toml::node& item : *array)
      if (const toml::table* table = item.as_table()) tables.push_back(table);
  return tables;
}

std::string text_at(const toml::table* table, const char* key) {
  return table ? (*table)[key].value<std::string>().value_or("") : "";
}

// The first text that is not empty.
std::string first_of(const std::string& a, const std::string& b) { return a.empty() ? b : a; }

// Whether this storey's masonry (without regions) has joints of the material.
bool has_joints_of(const toml::table* storey, const toml::table* wall, const std::string& name) {
  const auto stated = [&](const char* kind) {
    return first_of(text_at(storey, kind), text_at(wall, kind));
  };
  const std::string bed = first_of(stated("joint"), "joint");
  return name == bed || name == first_of(stated("head_joint"), bed) ||
         name == first_of(stated("unit_joint"), "unit");
}

bool names(const toml::table* region, const std::string& name) {
  return text_at(region, "joint") == name || text_at(region, "head_joint") == name ||
         text_at(region, "unit_joint") == name;
}

// The storeys whose masonry has the material. A region without a storey may be in any.
std::vector<Unit> units_of(const toml::table& root, const std::string& name) {
  const toml::table* wall = root["wall"].as_table();
  const std::vector<const toml::table*> storeys = tables_of(root, "storey");
  std::vector<Unit> all, used;
  for (const toml::table* storey : storeys) {
    const Unit unit{unit_of(storey), unit_of(wall), text_at(storey, "name")};
    all.push_back(unit);
    bool uses = has_joints_of(storey, wall, name);
    for (const toml::table* region : tables_of(root, "region")) {
      const std::string where = text_at(region, "storey");
      uses = uses || (names(region, name) && (where.empty() || where == unit.name));
    }
    if (uses) used.push_back(unit);
  }
  if (storeys.empty()) return {{nullptr, unit_of(wall), ""}};
  return used.empty() ? all : used;
}

// Calls see(bed, has a head joint of its own) for each masonry in the file, until it returns true.
template <class See>
bool any_masonry(const toml::table& root, See see) {
  const toml::table* wall = root["wall"].as_table();
  std::vector<const toml::table*> storeys = tables_of(root, "storey");
  if (storeys.empty()) storeys.push_back(nullptr);
  for (const toml::table* storey : storeys) {
    const auto stated = [&](const char* kind) {
      return first_of(text_at(storey, kind), text_at(wall, kind));
    };
    const std::string bed = first_of(stated("joint"), "joint"), head = stated("head_joint");
    if (see(bed, !head.empty())) return true;
    for (const toml::table* region : tables_of(root, "region")) {
      const std::string where = text_at(region, "storey");
      if (storey && !where.empty() && where != text_at(storey, "name")) continue;
      if (see(first_of(text_at(region, "joint"), bed),
              !first_of(text_at(region, "head_joint"), head).empty()))
        return true;
    }
  }
  return false;
}

// With mortar, the sizes of a unit are without joints.
StatedSize size_of(const Unit& unit, const std::string& key) {
  const bool course = key == "course_height", joint = key == "joint_thickness";
  const char* name = course ? "height" : "length";
  const Text size = unit.at("", name);
  const Text bed = unit.at("mortar", "bed"), head = unit.at("mortar", "head");
  const Text mortar = key == "unit_length" ? (head ? head : bed) : (bed ? bed : head);
  if (joint ? !mortar : !size) return {};
  const char* side = mortar && mortar == bed ? "bed" : "head";
  StatedSize out;
  try {
    out.value = mortar ? parse_quantity(*mortar, "m") : 0;
    if (!joint) out.value += parse_quantity(*size, "m");
  } catch (const std::invalid_argument&) {
    out.value = kUnset;
  }
  out.path = joint ? unit.path("mortar", side) : unit.path("", name);
  return out;
}

}  // namespace

std::vector<StatedSize> stated_sizes(const toml::table& root, const std::string& material,
                                     const std::string& key) {
  std::vector<StatedSize> sizes;
  if (key != "course_height" && key != "unit_length" && key != "joint_thickness") return sizes;
  for (const Unit& unit : units_of(root, material)) {
    const StatedSize size = size_of(unit, key);
    const auto is_same = [&](const StatedSize& other) {
      return other.value == size.value || (std::isnan(other.value) && std::isnan(size.value));
    };
    if (!size.path.empty() && std::none_of(sizes.begin(), sizes.end(), is_same))
      sizes.push_back(size);
  }
  return sizes;
}

bool has_beds_of(const toml::table& root, const std::string& material) {
  return any_masonry(root, [&](const std::string& bed, bool) { return bed == material; });
}

bool has_heads_of_beds(const toml::table& root, const std::string& material) {
  return any_masonry(root,
                     [&](const std::string& bed, bool own) { return bed == material && !own; });
}

}  // namespace wythe::io
