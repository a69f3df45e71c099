// Lists the joints or blocks on which a field acts, in the assembly's order, and applies drawn values to their materials.
// A drawn number is a factor on the stated value; with a formula it is the value. A wall that changed after the
// draw is refused. docs/theory/fields.md, "Places", defines course and unit of a joint.
#include "model/field_places.h"

#include <algorithm>
#include <cmath>
#include <map>

#include "geometry/blocks_file.h"
#include "geometry/shape.h"
#include "model/space/space_roles.h"

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
    {"mode_2_energy_per_pressure", &JointMaterial::mode_2_energy_per_pressure, "m", "mm"},
    {"compressive_energy", &JointMaterial::compressive_energy, "N/m", "N/m"},
    {"normal_stiffness", &JointMaterial::normal_stiffness, "Pa/m", "GPa/m"},
    {"shear_stiffness", &JointMaterial::shear_stiffness, "Pa/m", "GPa/m"},
    {"density", &JointMaterial::density, "kg/m^3", "kg/m^3"}};

Vec2 centre_of(const Block& block) { return geometry::moments(block.outline).centroid; }

// Units of the assembly have even numbers; a block that is part of none counts as a unit with an odd number.
int unit_of(const Assembly& assembly, int block) {
  const int unit = assembly.blocks[block].unit;
  return unit >= 0 ? 2 * unit : 2 * block + 1;
}

// Whether a density field acts on a block: it must be rigid and have this density.
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
      const Block& block = assembly.blocks[b];
      if (!has_density_of(spec, block, target.material)) continue;
      const Vec2 centre = centre_of(block);
      places.push_back({b, centre.x, centre.y, block.course, unit_of(assembly, b)});
    }
    return places;
  }
  for (int f = 0; f < static_cast<int>(assembly.faces.size()); ++f) {
    const Face& face = assembly.faces[f];
    if (face.material != target.material || face.kind == geometry::FaceKind::kLintelChain) continue;
    const Block& above = assembly.blocks[face.b];
    places.push_back({f, 0.5 * (face.p0.x + face.p1.x), 0.5 * (face.p0.y + face.p1.y), above.course,
                      unit_of(assembly, face.b)});
  }
  return places;
}

namespace {

// Whether a density field acts on a body: it must have this density.
bool has_density_of(const ModelSpec& spec, const BodySpec& body, const std::string& material) {
  if (body.fixed || body.zone.zones > 0) return false;
  const auto own = spec.material.find(body.material);
  const bool has_own = own != spec.material.end() && std::isfinite(own->second.density);
  if (material.empty()) return !has_own;
  return has_own && body.material == material;
}

// Numbers of units and courses of bodies in space, from the names that the builder gives.
class SpaceGroups {
 public:
  explicit SpaceGroups(const geometry::SpaceAssembly& assembly) {
    std::map<std::string, int> units;
    std::map<std::pair<int, std::int64_t>, int> courses;
    for (const BodySpec& body : assembly.body) {
      const std::string unit = wythe::unit_of(body.id);
      const int next = static_cast<int>(units.size());
      unit_.push_back(units.try_emplace(unit.empty() ? "of " + body.id : unit, next).first->second);
      const std::optional<int> course = course_of(body.id);
      const auto foot = std::llround(geometry::box_of(body).low.y / kSameFoot);
      const int number = static_cast<int>(courses.size());
      course_.push_back(course ? courses.try_emplace({*course, foot}, number).first->second : -1);
    }
  }
  [[nodiscard]] int unit(int body) const { return unit_[body]; }
  [[nodiscard]] int course(int body) const { return course_[body]; }

 private:
  static constexpr double kSameFoot = 1e-4;  // [m]
  std::vector<int> unit_, course_;
};

// The block whose course and unit a joint has: the upper one, unless it is fixed.
int upper_of(const geometry::SpaceAssembly& assembly, const geometry::JointFace& face) {
  constexpr double kAlong = 1e-6;
  const Vec3 n = face.normal;
  const double up = std::fabs(n.y) > 0.5 ? n.y : std::fabs(n.x) > kAlong ? n.x : n.z;
  const int upper = up > 0 ? face.b : face.a, other = up > 0 ? face.a : face.b;
  return assembly.body[upper].fixed ? other : upper;
}

}  // namespace

std::vector<FieldPlace> field_places(const ModelSpec& spec, const geometry::SpaceAssembly& assembly,
                                     const FieldTarget& target) {
  const SpaceGroups groups(assembly);
  std::vector<FieldPlace> places;
  const auto add = [&](int entity, Vec3 p, int body) {
    places.push_back({entity, p.x, p.y, groups.course(body), groups.unit(body), p.z});
  };
  if (target.is_density()) {
    for (int b = 0; b < static_cast<int>(assembly.body.size()); ++b)
      if (has_density_of(spec, assembly.body[b], target.material))
        add(b, assembly.moments[b].centroid, b);
    return places;
  }
  const geometry::Shape shape(spec);
  for (int f = 0; f < static_cast<int>(assembly.faces.size()); ++f) {
    const geometry::JointFace& face = assembly.faces[f];
    const BodySpec &a = assembly.body[face.a], &b = assembly.body[face.b];
    if ((a.fixed && b.fixed) || is_chain(a, b) ||
        joint_material_of(shape, a, b, face.normal) != target.material)
      continue;
    add(f, face.centre, upper_of(assembly, face));
  }
  return places;
}

template <class Assembly>
void FieldValues::take(const ModelSpec& spec, const Assembly& assembly, std::size_t blocks,
                       FaultList& faults) {
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
    item.value.assign(target->is_density() ? blocks : assembly.faces.size(), kUnset);
    for (std::size_t k = 0; k < places.size(); ++k) item.value[places[k].entity] = field.drawn[k];
    items_.push_back(std::move(item));
  }
}

FieldValues::FieldValues(const ModelSpec& spec, const Assembly& assembly, FaultList& faults) {
  take(spec, assembly, assembly.blocks.size(), faults);
}
FieldValues::FieldValues(const ModelSpec& spec, const geometry::SpaceAssembly& assembly,
                         FaultList& faults) {
  take(spec, assembly, assembly.body.size(), faults);
}

bool FieldValues::act_on(const std::string& material) const {
  return std::any_of(items_.begin(), items_.end(), [&](const Item& item) {
    return !item.target.is_density() && item.target.material == material;
  });
}

double FieldValues::put(const Item& item, int entity, double stated) {
  const double drawn = item.value[entity];
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

template <class Density>
void FieldValues::put_into(const ModelSpec& spec, const BlockMap& map, const Density& density,
                           Model& model) const {
  auto item = items_.begin();
  for (const auto& [name, field] : spec.field) {
    const Item& drawn = *item++;
    const FieldTarget& target = drawn.target;
    DrawnField shown{name, field.path, {}, {}};
    if (target.is_density()) {
      shown.of_block.assign(model.n_block, kUnset);
      for (std::size_t b = 0; b < map.size(); ++b)
        if (map[b] >= 0 && map[b] < model.n_block && !std::isnan(drawn.value[b]))
          shown.of_block[map[b]] = put(drawn, static_cast<int>(b), density(b));
    } else {
      for (const std::int32_t m : model.joint_material) {
        const bool own = model.stated(m) != m && model.material_names[m] == target.material;
        shown.of_joint.push_back(own ? model.materials[m].*target.key->value : kUnset);
      }
    }
    model.anatomy.fields.push_back(std::move(shown));
  }
}

void FieldValues::describe(const ModelSpec& spec, const Assembly& assembly, const BlockMap& map,
                           Model& model) const {
  const geometry::Shape shape(spec);
  const auto density = [&](std::size_t b) {
    return geometry::density_of(shape, assembly.blocks[b]);
  };
  put_into(spec, map, density, model);
}

void FieldValues::describe(const ModelSpec& spec, const geometry::SpaceAssembly& assembly,
                           const BlockMap& map, Model& model) const {
  const geometry::Shape shape(spec);
  const auto density = [&](std::size_t b) {
    return geometry::density_in_file(shape, assembly.body[b].material);
  };
  put_into(spec, map, density, model);
}

}  // namespace wythe
