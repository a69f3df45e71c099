#include "geometry/faces.h"

#include <cmath>
#include <map>
#include <utility>

#include "geometry/blocks_file.h"
#include "geometry/caps.h"
#include "geometry/text.h"

namespace wythe::geometry {
namespace {

constexpr double kAlongAxis = 1e-3;  // slope up to which a face counts as level or upright

FaceKind masonry_kind(const Block& a, const Block& b, const Contact& contact) {
  if (a.unit >= 0 && a.unit == b.unit) return FaceKind::kSplit;
  const Vec2 t = contact.p1 - contact.p0;
  if (std::abs(t.y) <= kAlongAxis * length(t)) return FaceKind::kBed;
  if (std::abs(t.x) <= kAlongAxis * length(t)) return FaceKind::kHead;
  return FaceKind::kOther;
}

FaceKind kind_of(const Block& a, const Block& b, const Contact& contact) {
  const auto either = [&](Role role) { return a.role == role || b.role == role; };
  if (either(Role::kBeam)) return FaceKind::kBeam;
  if (either(Role::kPlate)) return FaceKind::kPlate;
  const bool both_lintel = a.role == Role::kLintel && b.role == Role::kLintel;
  if (both_lintel && a.opening == b.opening) return FaceKind::kLintelChain;
  if (either(Role::kLintel)) return FaceKind::kLintelBond;
  return masonry_kind(a, b, contact);
}

const LintelSpec& lintel_between(const Shape& shape, const Block& a, const Block& b) {
  const int opening = a.role == Role::kLintel ? a.opening : b.opening;
  return shape.wall.opening[static_cast<std::size_t>(opening)].lintel;
}

// "foundation", where the spec has no such material "joint".
std::string foundation_or_joint(const Shape& shape, const std::string& name) {
  return name == "foundation" && !shape.material.contains(name) ? "joint" : name;
}

// A lintel's ends, its bearing and what lies on it may have materials of their own.
std::string bond_material(const LintelSpec& lintel, const Block& a, const Contact& contact) {
  const Vec2 t = contact.p1 - contact.p0;
  const bool level = std::abs(t.y) <= kAlongAxis * length(t);
  const bool on_top = a.role == Role::kLintel;  // a is the lower block
  const std::string& own = on_top ? lintel.top_bond : lintel.bearing_bond;
  return level && !own.empty() ? own : lintel.bond;
}

std::string pair_material(const Shape& shape, const Block& a, const Block& b, FaceKind kind,
                          const Contact& contact) {
  if (kind == FaceKind::kLintelChain) return lintel_between(shape, a, b).material;
  if (kind == FaceKind::kLintelBond) return bond_material(lintel_between(shape, a, b), a, contact);
  if (kind == FaceKind::kPlate) return foundation_or_joint(shape, plate_joint(shape));
  if (kind == FaceKind::kSplit) return "unit";
  const std::string plain = kind == FaceKind::kBeam ? shape.wall.beam.joint : "joint";
  return uses_blocks_file(shape) ? ruled_material(shape, a.material, b.material, plain) : plain;
}

std::string ground_material(const Shape& shape, const Block& block, const Block* support) {
  std::string material = foundation_or_joint(shape, "foundation");
  if (!uses_blocks_file(shape)) return material;
  if (support != nullptr)
    material = ruled_material(shape, support->material, block.material, material);
  return ruled_material(shape, "ground", block.material, material);
}

Face pair_face(const Shape& shape, const Block& a, const Block& b, const Contact& contact) {
  const FaceKind kind = kind_of(a, b, contact);
  return {contact.a,  contact.b, contact.p0,
          contact.p1, kind,      pair_material(shape, a, b, kind, contact)};
}

// The ground is always side a: a contact whose b is the support is turned round.
Face ground_face(const Shape& shape, const std::vector<Block>& blocks, Contact contact,
                 int support) {
  if (support != contact.a) {
    std::swap(contact.a, contact.b);
    std::swap(contact.p0, contact.p1);
  }
  const Block& block = blocks[static_cast<std::size_t>(contact.b)];
  const Block* below = support == kGround ? nullptr : &blocks[static_cast<std::size_t>(support)];
  return {kGround,
          contact.b,
          contact.p0,
          contact.p1,
          FaceKind::kFoundation,
          ground_material(shape, block, below)};
}

struct Need {
  std::string problem, cure;
};

Need need_of(FaceKind kind, const std::string& material) {
  const std::string table = "[material." + material + "]";
  switch (kind) {
    case FaceKind::kSplit:
      return {"missing: wall.unit.split needs it for the potential cracks inside the units",
              "add " + table + ", or write wall.unit.split = \"none\""};
    case FaceKind::kLintelChain:
      return {"missing: the lintel is made of it", "add " + table + " with its density and moduli"};
    case FaceKind::kLintelBond:
      return {"missing: the lintel meets the masonry through it", "add " + table};
    case FaceKind::kPlate:
      return {"missing: the plates on the piers lie on it",
              "add " + table + ", or name another plate_joint"};
    case FaceKind::kBeam:
      return {"missing: the beam lies on it", "add " + table + ", or name another wall.beam.joint"};
    default: return {"missing: the joints between the blocks take it", "add " + table};
  }
}

// Each missing material once, with the first use that needs it.
using Uses = std::map<std::string, FaceKind>;

void refuse_missing(const Shape& shape, const Uses& uses, FaultList& faults) {
  for (const auto& [material, kind] : uses) {
    if (material.empty() || shape.material.contains(material)) continue;
    const Need need = need_of(kind, material);
    add_fault(faults, "material." + material, "", need.problem, need.cure);
  }
}

void add_lintel_uses(const Shape& shape, Uses& uses) {
  for (const OpeningSpec& opening : shape.wall.opening) {
    if (opening.lintel.kind.empty()) continue;
    uses.emplace(opening.lintel.material, FaceKind::kLintelChain);
    for (const auto* bond :
         {&opening.lintel.bond, &opening.lintel.bearing_bond, &opening.lintel.top_bond})
      if (!bond->empty()) uses.emplace(*bond, FaceKind::kLintelBond);
  }
}

}  // namespace

bool uses_blocks_file(const Shape& shape) {
  return !shape.wall.blocks.empty() || !shape.block.empty();
}

std::vector<Face> name_faces(const Shape& shape, const std::vector<Block>& blocks,
                             const std::vector<Contact>& contacts) {
  const auto is_support = [&](int i) {
    return i == kGround || blocks[static_cast<std::size_t>(i)].role == Role::kSupport;
  };
  std::vector<Face> faces;
  faces.reserve(contacts.size());
  for (const Contact& contact : contacts) {
    const bool a_rests = is_support(contact.a), b_rests = is_support(contact.b);
    if (a_rests && b_rests) continue;
    if (a_rests || b_rests) {
      faces.push_back(ground_face(shape, blocks, contact, a_rests ? contact.a : contact.b));
    } else {
      faces.push_back(pair_face(shape, blocks[static_cast<std::size_t>(contact.a)],
                                blocks[static_cast<std::size_t>(contact.b)], contact));
    }
  }
  return faces;
}

void check_materials(const Shape& shape, const std::vector<Face>& faces, FaultList& faults) {
  Uses uses;
  for (const Face& face : faces) uses.emplace(face.material, face.kind);
  if (const auto unnamed = uses.find(""); unnamed != uses.end())
    add_fault(faults, "material", "\"\"", need_of(unnamed->second, "").problem,
              "name a [material.*] table there");
  if (!uses_blocks_file(shape)) add_lintel_uses(shape, uses);
  refuse_missing(shape, uses, faults);
}

void check_stated_materials(const Shape& shape, FaultList& faults) {
  Uses uses{{"joint", FaceKind::kBed}};
  for (const ContactRule& rule : shape.contact) uses.emplace(rule.material, FaceKind::kBed);
  if (!uses_blocks_file(shape)) {
    add_lintel_uses(shape, uses);
    const Split split = shape.wall.unit.split;
    const Bond bond = shape.wall.bond;
    const bool cracks = split == Split::kMiddle ? bond != Bond::kHeader
                                                : split == Split::kAtJoints && bond != Bond::kStack;
    if (cracks) uses.emplace("unit", FaceKind::kSplit);
  }
  if (std::isfinite(shape.wall.beam.height)) uses.emplace(shape.wall.beam.joint, FaceKind::kBeam);
  uses.emplace(foundation_or_joint(shape, plate_joint(shape)), FaceKind::kPlate);
  refuse_missing(shape, uses, faults);
}

}  // namespace wythe::geometry
