// Hashes all members that shape a wall. Each struct is decomposed into all its members, so that a new member
// does not compile until it is named here. Members that are named but not added, such as moduli, have no effect on the shape.
#include "geometry/shape.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <type_traits>

#include "core/hash.h"

namespace wythe::geometry {
namespace {

// Each struct is decomposed into all its members: a new one does not compile until it is added here.
class Key {
 public:
  template <class... T>
  void add_all(const T&... members) {
    (add(members), ...);
  }

  void add(const WallSpec& wall) {
    const auto& [length, height, thickness, bond, fit, blocks, up, supports, unit, opening, beam,
                 joints, foundation] = wall;
    add_all(length, height, thickness, bond, fit, blocks, up, supports, unit, opening, beam, joints,
            foundation);
  }
  void add(const StoreySpec& storey) {
    const auto& [name, height, thickness, bond, unit, joints, fit] = storey;
    add_all(name, height, thickness, bond, unit, joints, fit);
  }
  void add(const RingBeamSpec& beam) {
    const auto& [name, storey, y, x, width, height, thickness, material, joint, top_joint] = beam;
    add_all(name, storey, y, x, width, height, thickness, material, joint, top_joint);
  }
  void add(const FrameSpec& frame) {
    const auto& [name, round, line, feet, profile, count, section, beam_profile, beam_count,
                 beam_section, grade, yield_strength, youngs_modulus, shear_modulus, joint, gap,
                 stage, anchors, wedges, wall, x, y, z, turn, hole] = frame;
    // grade, strength, moduli, anchors and wedges have no effect on the shape
    add_all(name, round, line, feet, profile, count, section, beam_profile, beam_count,
            beam_section, joint, gap, stage, wall, x, y, z, turn, hole.x, hole.y, hole.width,
            hole.height);
  }
  void add(const RegionSpec& region) {
    const auto& [name, place, joints, density, thickness] = region;
    const auto& [storey, pier, x, y, width, height, polygon] = place;
    add_all(name, storey, pier, x, y, width, height, polygon, joints, thickness);
    add_density(density);
  }
  void add(const BlockSpec& block) {
    const auto& [id, polygon, material, fixed, is_beam, zone] = block;
    add_all(id, polygon, material, fixed, is_beam, zone);
  }
  void add(const Vec3& v) { add_all(v.x, v.y, v.z); }
  void add(const Polyhedron& part) {
    const auto& [vertex, face] = part;
    add_all(vertex, face);
  }
  void add(const BodySpec& body) {
    const auto& [id, part, material, fixed, zone, role, cut, put_in] = body;
    add_all(id, part, material, fixed, zone, role, cut, put_in);
  }
  void add(const ContactRule& rule) {
    const auto& [between, material] = rule;
    add_all(between, material);
  }
  void add(const PlateStage& stage) {
    const auto& [name, joint] = stage;
    add_all(name, joint);
  }
  void add(const std::map<std::string, double>& materials) {
    add(materials.size());
    for (const auto& [name, density] : materials) {
      add(name);
      add_density(density);
    }
  }

  template <class T>
  void add(const std::vector<T>& list) {
    add(list.size());
    for (const T& member : list) add(member);
  }

  [[nodiscard]] std::uint64_t value() const { return hash_.value(); }

 private:
  void add(double number) { hash_.add(&number, sizeof number); }
  void add(const std::array<double, 2>& corner) { add_all(corner[0], corner[1]); }
  void add(const std::string& text) {
    add(text.size());
    hash_.add(text);
  }
  template <class Word>
  requires std::is_enum_v<Word> || std::is_integral_v<Word>
  void add(Word word) {
    const auto number = static_cast<std::int64_t>(word);
    hash_.add(&number, sizeof number);
  }

  // Only the properties of a density that the checks test (is_positive, is_not_negative, whether a material has its own).
  void add_density(double density) { add_all(std::isfinite(density), density > 0, density == 0); }

  void add(const UnitSpec& unit) {
    const auto& [length, height, width, split, density, mortar, real] = unit;
    add_all(length, height, width, split, mortar.bed, mortar.head, real.length, real.height);
    add_density(density);
  }
  void add(const MasonryJoints& joints) {
    const auto& [joint, head_joint, unit_joint] = joints;
    add_all(joint, head_joint, unit_joint);
  }
  void add(const BeamSpec& beam) {
    const auto& [height, density, rotation, joint] = beam;
    add_all(height, rotation, joint);
    add_density(density);
  }
  void add(const OpeningSpec& opening) {
    const auto& [name, x, y, width, height, lintel, arch, storey, sill, cut] = opening;
    add_all(name, x, y, width, height, lintel, arch, storey, sill, cut);
  }
  void add(const SillSpec& sill) {
    const auto& [kind, depth, bearing, material, joint] = sill;
    add_all(kind, depth, bearing, material, joint);
  }
  void add(const SectionSpec& section) {
    const auto& [height, width, area, shear_area, second_moment, plastic_modulus, mass, weak,
                 torsion, weak_shear] = section;
    add_all(height, width, area, shear_area, second_moment, plastic_modulus, mass, weak, torsion,
            weak_shear);
  }
  void add(const FoundationStep& step) { add_all(step.x, step.y); }
  void add(const ArchSpec& arch) {
    const auto& [kind, rise, depth, skewback, voussoirs, joint, material] = arch;
    add_all(kind, rise, depth, skewback, voussoirs, joint, material);
  }
  void add(const LintelSpec& lintel) {
    const auto& [kind, depth, bearing, material, bond, bearing_bond, top_bond, model, zones,
                 zone_length, zone_kind, plane] = lintel;
    add_all(kind, depth, bearing, material, bond, bearing_bond, top_bond, model, zones, zone_length,
            zone_kind, plane);
  }
  void add(const ZoneSpec& zone) {
    const auto& [zones, length, kind, plane] = zone;
    add_all(zones, length, kind, plane);
  }

  Hash hash_;
};

}  // namespace

Shape::Shape(const ModelSpec& spec)
    : wall(spec.wall),
      storey(spec.storey),
      region(spec.region),
      ring_beam(spec.ring_beam),
      frame(spec.frame),
      block(spec.block),
      body(spec.body),
      contact(spec.contact) {
  for (const auto& [name, given] : spec.material) material.emplace(name, given.density);
  for (const StageSpec& stage : spec.stage)
    if (const auto* load = std::get_if<LoadStage>(&stage.action);
        load != nullptr && load->as == Manner::kPlate && std::isfinite(load->pier_load))
      plates.push_back({stage.name, load->plate_joint});
  const bool changes =
      std::any_of(body.begin(), body.end(),
                  [](const BodySpec& b) { return !b.cut.empty() || !b.put_in.empty(); }) ||
      std::any_of(frame.begin(), frame.end(), [](const FrameSpec& f) { return !f.stage.empty(); });
  if (body.empty() || !changes) return;
  for (const StageSpec& stage : spec.stage) stages.push_back(stage.name);
}

std::uint64_t shape_key(const Shape& shape) {
  Key key;
  const auto& [wall, storey, region, ring_beam, frame, block, body, contact, material, plates,
               stages] = shape;
  key.add_all(wall, storey, region, ring_beam, frame, block, body, contact, material, plates);
  if (!stages.empty()) key.add(stages);  // without stages the keys are those of older stores
  return key.value();
}

}  // namespace wythe::geometry
