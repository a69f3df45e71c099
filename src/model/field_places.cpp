#include "model/field_places.h"

#include <algorithm>
#include <cmath>

#include "geometry/shape.h"

namespace wythe {
namespace {

using geometry::Assembly;
using geometry::Block;
using geometry::Face;

constexpr FieldKey kKeys[] = {
    {"tensile_strength", &JointMaterial::tensile_strength, "Pa", "MPa"},
    {"cohesion", &JointMaterial::cohesion, "Pa", "MPa"},
    {"residual_cohesion", &JointMaterial::residual_cohesion, "Pa", "MPa"},
    {"friction_angle", &JointMaterial::friction_angle, "rad", "deg"},
    {"residual_friction_angle", &JointMaterial::residual_friction_angle, "rad", "deg"},
    {"compressive_strength", &JointMaterial::compressive_strength, "Pa", "MPa"},
    {"mode_1_energy", &JointMaterial::mode_1_energy, "N/m", "N/m"},
    {"mode_2_energy", &JointMaterial::mode_2_energy, "N/m", "N/m"},
    {"compressive_energy", &JointMaterial::compressive_energy, "N/m", "N/m"},
    {"normal_stiffness", &JointMaterial::normal_stiffness, "Pa/m", "GPa/m"},
    {"shear_stiffness", &JointMaterial::shear_stiffness, "Pa/m", "GPa/m"},
    {"density", &JointMaterial::density, "kg/m^3", "kg/m^3"}};

std::size_t at(std::int64_t i) { return static_cast<std::size_t>(i); }

Vec2 centre_of(const Block& block) { return geometry::moments(block.outline).centroid; }

// A block of no unit of several is a unit of its own; they are numbered from above those of the assembly.
int unit_of(const Assembly& assembly, int block) {
  const int unit = assembly.blocks[at(block)].unit;
  return unit >= 0 ? 2 * unit : 2 * block + 1;
}

// A density field acts on rigid blocks that have this density.
bool has_density_of(const ModelSpec& spec, const Block& block, const std::string& material) {
  if (block.role == geometry::Role::kSupport || block.role == geometry::Role::kPlate ||
      block.zone.zones > 0)
    return false;
  const auto own = spec.material.find(block.material);
  const bool has_own = own != spec.material.end() && std::isfinite(own->second.density);
  if (material.empty()) return block.role == geometry::Role::kMasonry && !has_own;
  return has_own && block.material == material;
}

}  // namespace

std::span<const FieldKey> field_keys() { return kKeys; }

std::optional<FieldTarget> field_target(const std::string& path) {
  const std::size_t dot = path.rfind('.');
  if (dot == std::string::npos) return std::nullopt;
  const std::string table = path.substr(0, dot), name = path.substr(dot + 1);
  const auto key = std::find_if(std::begin(kKeys), std::end(kKeys),
                                [&](const FieldKey& k) { return name == k.name; });
  if (key == std::end(kKeys)) return std::nullopt;
  FieldTarget target{"", key};
  if (table == "wall.unit" && target.is_density()) return target;
  if (!table.starts_with("material.") || table.size() == 9) return std::nullopt;
  target.material = table.substr(9);
  return target;
}

double mean_of(const ModelSpec& spec, const FieldTarget& target) {
  if (target.material.empty()) return spec.wall.unit.density;
  const auto found = spec.material.find(target.material);
  return found == spec.material.end() ? kUnset : found->second.*target.key->value;
}

std::vector<FieldPlace> field_places(const ModelSpec& spec, const Assembly& assembly,
                                     const FieldTarget& target) {
  std::vector<FieldPlace> places;
  if (target.is_density()) {
    for (int b = 0; b < static_cast<int>(assembly.blocks.size()); ++b) {
      const Block& block = assembly.blocks[at(b)];
      if (!has_density_of(spec, block, target.material)) continue;
      const Vec2 centre = centre_of(block);
      places.push_back({b, centre.x, centre.y, block.course, unit_of(assembly, b)});
    }
    return places;
  }
  for (int f = 0; f < static_cast<int>(assembly.faces.size()); ++f) {
    const Face& face = assembly.faces[at(f)];
    if (face.material != target.material || face.kind == geometry::FaceKind::kLintelChain) continue;
    const Block& above = assembly.blocks[at(face.b)];
    places.push_back({f, 0.5 * (face.p0.x + face.p1.x), 0.5 * (face.p0.y + face.p1.y), above.course,
                      unit_of(assembly, face.b)});
  }
  return places;
}

FieldValues::FieldValues(const ModelSpec& spec, const Assembly& assembly, FaultList& faults) {
  if (spec.field.empty()) return;
  const std::uint64_t shape = geometry::shape_key(spec);
  for (const auto& [name, field] : spec.field) {
    const std::optional<FieldTarget> target = field_target(field.path);
    const std::vector<FieldPlace> places =
        target ? field_places(spec, assembly, *target) : std::vector<FieldPlace>{};
    if (!target || field.drawn_for != shape || field.drawn.size() != places.size()) {
      faults.add({"", "field." + name, "", "has not been drawn for this wall",
                  "call draw_fields() after the last change of the wall", 0});
      continue;
    }
    Item item{*target, field.formula.empty(), {}};
    item.value.assign(target->is_density() ? assembly.blocks.size() : assembly.faces.size(),
                      kUnset);
    for (std::size_t k = 0; k < places.size(); ++k)
      item.value[at(places[k].entity)] = field.drawn[k];
    items_.push_back(std::move(item));
  }
}

bool FieldValues::act_on(const std::string& material) const {
  return std::any_of(items_.begin(), items_.end(), [&](const Item& item) {
    return !item.target.is_density() && item.target.material == material;
  });
}

double FieldValues::put(const Item& item, int entity, double stated) {
  const double drawn = item.value[at(entity)];
  if (std::isnan(drawn)) return stated;
  return item.is_factor ? stated * drawn : drawn;
}

JointMaterial FieldValues::of_face(int face, const JointMaterial& stated) const {
  JointMaterial own = stated;
  own.origin.clear();
  for (const Item& item : items_)
    if (!item.target.is_density()) {
      double& value = own.*item.target.key->value;
      value = put(item, face, value);
    }
  return own;
}

double FieldValues::density_of(int block, double stated) const {
  double density = stated;
  for (const Item& item : items_)
    if (item.target.is_density()) density = put(item, block, density);
  return density;
}

void FieldValues::describe(const ModelSpec& spec, const Assembly& assembly, const BlockMap& map,
                           Model& model) const {
  const geometry::Shape shape(spec);
  auto item = items_.begin();
  for (const auto& [name, field] : spec.field) {
    const Item& drawn = *item++;
    const FieldTarget& target = drawn.target;
    DrawnField shown{name, field.path, {}, {}};
    if (target.is_density()) {
      shown.of_block.assign(at(model.n_block), kUnset);
      for (std::size_t b = 0; b < map.size(); ++b)
        if (map[b] >= 0 && !std::isnan(drawn.value[b]))
          shown.of_block[at(map[b])] =
              put(drawn, static_cast<int>(b), geometry::density_of(shape, assembly.blocks[b]));
    } else {
      for (const std::int32_t m : model.joint_material) {
        const bool own = model.stated(m) != m && model.material_names[at(m)] == target.material;
        shown.of_joint.push_back(own ? model.materials[at(m)].*target.key->value : kUnset);
      }
    }
    model.anatomy.fields.push_back(std::move(shown));
  }
}

}  // namespace wythe
