// The joint law's own check (check_joint_material), with each fault placed at its key.
#include <algorithm>
#include <array>
#include <set>
#include <string>
#include <string_view>

#include <fmt/format.h>

#include "contact/parameters.h"
#include "io/text/toml_reader.h"

namespace wythe::io {
namespace {

// A table without any of these keys describes a body (lintel, block), not a joint. The words
// softening, coupling and unloading have defaults, and write_model writes them for bodies too.
constexpr std::array<std::string_view, 18> kLawKeys = {
    "normal_stiffness",     "shear_stiffness",
    "tensile_strength",     "cohesion",
    "friction_angle",       "residual_friction_angle",
    "residual_cohesion",    "mode_1_energy",
    "mode_2_energy",        "mode_2_energy_per_pressure",
    "compressive_strength", "compressive_energy",
    "compression_cap",      "hardening_displacement",
    "dilatancy_angle",      "dilatancy_slip",
    "dilatancy_pressure",   "head_joint_bond"};

}  // namespace

bool is_law_key(std::string_view name) {
  return std::find(kLawKeys.begin(), kLawKeys.end(), name) != kLawKeys.end();
}

namespace {

bool is_law(const TableReader& reader) {
  return std::any_of(kLawKeys.begin(), kLawKeys.end(),
                     [&](std::string_view name) { return reader.has(name); });
}

// Of the mortar of a layer: the layer has its stiffness, and checks its energies with that (model/plane/coats.cpp).
constexpr double kAnyStiffness = 1e30;  // [Pa/m], at which no energy is too small
bool is_mortar(TableReader& reader) {
  const std::set<std::string, std::less<>>& names = reader.context().mortars;
  return std::any_of(names.begin(), names.end(), [&](const std::string& name) {
    return reader.below("use") == under(under("material", name), "use");
  });
}

// A refused value stays unset, so the law would report it as missing as well.
bool has_law_fault(TableReader& reader) {
  return std::any_of(kLawKeys.begin(), kLawKeys.end(), [&](std::string_view name) {
    return reader.context().has_fault_at(reader.below(std::string(name)));
  });
}

// One message for all missing values.
void refuse_missing(TableReader& reader, std::vector<MaterialFault> missing) {
  for (const MaterialFault& fault : contact::missing_as_one(std::move(missing))) {
    constexpr const char* kTypical = "; or take typical values, use = \"NAME\" (wythe materials)";
    if (fault.key.empty())
      reader.refuse_table(fault.problem,
                          fault.cure + "; or ask for rules, missing = \"rule\"" + kTypical);
    else
      reader.miss(
          fault.key, fault.problem,
          fault.cure + fmt::format("; or ask for its rule, {} = \"rule\"", fault.key) + kTypical);
  }
}

}  // namespace

void finish(TableReader& reader, JointMaterial& material) {
  if (!is_law(reader)) return;
  const bool half_read = has_law_fault(reader);
  ReadContext& context = reader.context();
  // a correct typology would have given the missing values
  const bool has_no_typology = context.has_fault_at("masonry.use") ||
                               context.has_fault_at("masonry.knowledge_level") ||
                               context.has_fault_at(reader.below("use"));
  JointMaterial checked = material;
  if (is_mortar(reader)) checked.normal_stiffness = checked.shear_stiffness = kAnyStiffness;
  std::vector<MaterialFault> missing;
  for (const MaterialFault& fault : check_joint_material(checked)) {
    // After a refused value, only keys that are missing for certain are reported.
    if (half_read && reader.has(fault.key)) continue;
    if (has_no_typology && !reader.has(fault.key)) continue;
    if (context.has_fault_at(reader.below(fault.key)) ||
        context.follow_ups.contains(reader.below(fault.key)))
      continue;  // one message for one mistake
    if (reader.has(fault.key))
      reader.refuse(fault.key, fault.problem, fault.cure);
    else
      missing.push_back(fault);
  }
  refuse_missing(reader, std::move(missing));
}

}  // namespace wythe::io
