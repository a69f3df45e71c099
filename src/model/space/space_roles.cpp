// Parses the ids that the builder gives, and derives unit, course, lintel and joint material of a body from them.
// A [[contact]] rule precedes the ids, and one with "ground" precedes other rules. A role stated in the file precedes
// the id. An id of the same form that a user writes counts as the builder's.
#include "model/space/space_roles.h"

#include "core/number.h"
#include "geometry/blocks_file.h"

#include <cmath>
#include <optional>
#include <string_view>

namespace wythe {
namespace {

using geometry::Shape;

// Index of the first of the digits that end before `end`.
std::size_t digits_before(const std::string& id, std::size_t end) {
  std::size_t k = end;
  while (k > 0 && id[k - 1] >= '0' && id[k - 1] <= '9') --k;
  return k;
}

// Joint material as in a plane wall: for level joints, vertical joints, and crack planes in units.
std::string plain_joint(const Shape& shape, const BodySpec& a, const BodySpec& b, Vec3 normal) {
  const MasonryJoints& named = shape.wall.joints;
  const std::string bed = named.joint.empty() ? "joint" : named.joint;
  if (a.fixed) return shape.material.contains("foundation") ? "foundation" : bed;
  const std::string unit = unit_of(a.id);
  if (!unit.empty() && unit == unit_of(b.id))
    return named.unit_joint.empty() ? "unit" : named.unit_joint;
  const bool upright = std::fabs(normal.y) < 0.5;
  return upright && !named.head_joint.empty() ? named.head_joint : bed;
}

// "vault" of "vault.c03u05", "front.arch0" of "front.arch0_4": names from the builder; "" for any other body.
std::string owner_of(const std::string& id) {
  if (course_of(id)) return id.substr(0, id.rfind(".c"));
  const std::size_t arch = id.rfind(".arch"), number = digits_before(id, id.size());
  const bool is_voussoir = arch != std::string::npos && number < id.size() && number > arch + 5 &&
                           id[number - 1] == '_' && digits_before(id, number - 1) == arch + 5;
  return is_voussoir ? id.substr(0, number - 1) : "";
}

// Whether a joint is between two courses of one arch, vault or dome: a bed, though vertical at the crown.
bool is_bed_at_crown(const std::string& a, const std::string& b) {
  const std::string owner = owner_of(a);
  const bool same_course = course_of(a) && course_of(a) == course_of(b);
  return !owner.empty() && owner == owner_of(b) && !same_course;
}

}  // namespace

std::string unit_of(const std::string& whole) {
  // ".p2": a part that the pocket of a slab cut off
  const std::size_t number = digits_before(whole, whole.size());
  const bool is_part =
      number < whole.size() && number > 2 && whole.compare(number - 2, 2, ".p") == 0;
  const std::string piece = is_part ? whole.substr(0, number - 2) : whole;
  // ".cut0_3": masonry at a place where a stage cuts an opening
  const std::size_t cut = piece.rfind(".cut");
  const std::string id = cut == std::string::npos ? piece : piece.substr(0, cut);
  const bool in_wythe = id.size() > 3 && id[id.size() - 3] == '.' && id[id.size() - 2] == 'w';
  const std::size_t end = in_wythe ? id.size() - 3 : id.ends_with(".t") ? id.size() - 2 : id.size();
  if (end < 5 || id[end - 1] < 'a' || id[end - 1] > 'z') return "";
  const std::size_t unit = digits_before(id, end - 1);
  if (unit == end - 1 || unit == 0 || (id[unit - 1] != 'u' && id[unit - 1] != 't')) return "";
  const std::size_t course = digits_before(id, unit - 1);
  if (course == unit - 1 || course == 0 || id[course - 1] != 'c') return "";
  return id.substr(0, end - 1) + id.substr(end);
}

std::optional<int> course_of(const std::string& id) {
  for (std::size_t dot = id.find('.'); dot != std::string::npos; dot = id.find('.', dot + 1)) {
    std::size_t end = dot + 2;
    while (end < id.size() && id[end] >= '0' && id[end] <= '9') ++end;
    const bool has_unit = end < id.size() && (id[end] == 'u' || id[end] == 't');
    if (dot + 1 < id.size() && id[dot + 1] == 'c' && end > dot + 2 && end < dot + 9 && has_unit)
      return parse_number<int>(std::string_view(id).substr(dot + 2, end - dot - 2));
  }
  return std::nullopt;
}

namespace {

// "ring.beam.s3", or "ring.2.beam.s3" of a line with corners: names from the builder.
bool is_of_ring_beam(const std::string& id) {
  const std::size_t segment = digits_before(id, id.size());
  constexpr std::string_view kBeam = ".beam.s";
  return segment < id.size() && segment >= kBeam.size() &&
         id.compare(segment - kBeam.size(), kBeam.size(), kBeam) == 0;
}

}  // namespace

std::string chain_of(const std::string& id) {
  const std::size_t segment = digits_before(id, id.size());
  if (segment == id.size() || segment < 2 || id.compare(segment - 2, 2, ".s") != 0) return "";
  const std::size_t end = segment - 2, number = digits_before(id, end);
  if (is_of_ring_beam(id)) return id.substr(0, end);
  constexpr std::string_view kLintel = ".lintel";
  if (number == end || number < kLintel.size() ||
      id.compare(number - kLintel.size(), kLintel.size(), kLintel) != 0)
    return "";
  return id.substr(0, end);
}

std::string joint_material_of(const Shape& shape, const BodySpec& a, const BodySpec& b,
                              Vec3 normal) {
  const std::string plain = plain_joint(shape, a, b, normal);
  const std::string between = geometry::ruled_material(shape, a.material, b.material, plain);
  return a.fixed ? geometry::ruled_material(shape, "ground", b.material, between) : between;
}

bool shares_bed(const Shape& shape, const BodySpec& a, const BodySpec& b, Vec3 normal) {
  constexpr double kAlongAxis = 1e-3;  // slope up to which a face counts as vertical
  if (a.fixed || b.fixed || std::fabs(normal.y) > kAlongAxis) return false;
  if (role_of(a) != BlockRole::kMasonry || role_of(b) != BlockRole::kMasonry) return false;
  if (!shape.wall.joints.head_joint.empty() ||
      !geometry::ruled_material(shape, a.material, b.material, "").empty())
    return false;
  const std::string unit = unit_of(a.id);
  const bool is_crack = !unit.empty() && unit == unit_of(b.id);
  return !is_crack && !is_bed_at_crown(a.id, b.id);
}

bool is_chain(const BodySpec& a, const BodySpec& b) {
  if (is_of_ring_beam(a.id) && is_of_ring_beam(b.id)) return a.material == b.material;
  const std::string chain = chain_of(a.id);
  return !chain.empty() && chain == chain_of(b.id);
}

BlockRole role_of(const BodySpec& body) {
  for (const Word<BlockRole>& word : kBlockRoleWords)
    if (body.role == word.word) return word.value;
  return chain_of(body.id).empty() ? BlockRole::kMasonry : BlockRole::kLintel;
}

}  // namespace wythe
