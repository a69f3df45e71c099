// The roles of its blocks give the kind of a contact, in the order frame, beam, plate, lintel, arch, masonry. The kind
// gives the material; in a blocks file a contact rule may name it. Where the model has no material "joint" or
// "foundation", the masonry's bed joint replaces it. The ground is always side a.
#include "geometry/wall/faces.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include "geometry/blocks_file.h"
#include "geometry/caps.h"
#include "geometry/text.h"
#include "geometry/wall/storeys.h"

namespace wythe::geometry {
namespace {

constexpr double kAlongAxis = 1e-3;  // slope up to which a face counts as level or vertical

FaceKind masonry_kind(const Block& a, const Block& b, const Contact& contact) {
  if (a.unit >= 0 && a.unit == b.unit) return FaceKind::kSplit;
  const Vec2 t = contact.p1 - contact.p0;
  if (std::abs(t.y) <= kAlongAxis * length(t)) return FaceKind::kBed;
  if (std::abs(t.x) <= kAlongAxis * length(t)) return FaceKind::kHead;
  return FaceKind::kOther;
}

bool are_of_one_arch(const Block& a, const Block& b) {
  return is_voussoir(a) && is_voussoir(b) && a.opening == b.opening;
}

FaceKind kind_of(const Block& a, const Block& b, const Contact& contact) {
  const auto either = [&](Role role) { return a.role == role || b.role == role; };
  if (either(Role::kFrame)) return FaceKind::kFrame;
  if (either(Role::kBeam)) return FaceKind::kBeam;
  if (either(Role::kPlate)) return FaceKind::kPlate;
  if (is_chain(a) && a.role == b.role && a.opening == b.opening && a.ring_beam == b.ring_beam)
    return FaceKind::kLintelChain;
  if (either(Role::kLintel)) return FaceKind::kLintelBond;
  if (are_of_one_arch(a, b)) return FaceKind::kHead;
  return masonry_kind(a, b, contact);
}

const LintelSpec& lintel_between(const Shape& shape, const Block& a, const Block& b) {
  const int opening = a.role == Role::kLintel ? a.opening : b.opening;
  return shape.wall.opening[opening].lintel;
}

// The first name of this kind of joint among region, storey and wall; "" where none states one.
std::string stated(const Shape& shape, const Block& block, std::string MasonryJoints::*kind) {
  std::string name;
  if (block.region >= 0) name = shape.region[block.region].joints.*kind;
  if (name.empty() && block.storey >= 0) name = shape.storey[block.storey].joints.*kind;
  return name.empty() ? shape.wall.joints.*kind : name;
}

std::string or_else(const std::string& name, const std::string& otherwise) {
  return name.empty() ? otherwise : name;
}

std::string masonry_material(const Shape& shape, const Block& block, FaceKind kind) {
  if (kind == FaceKind::kSplit)
    return or_else(stated(shape, block, &MasonryJoints::unit_joint), "unit");
  const std::string bed = or_else(stated(shape, block, &MasonryJoints::joint), "joint");
  return kind == FaceKind::kHead ? or_else(stated(shape, block, &MasonryJoints::head_joint), bed)
                                 : bed;
}

// The block that gives the joint: the one whose region is listed first (no region precedes all), else b, the upper or right one.
const Block& owner_of(const Block& a, const Block& b) { return a.region < b.region ? a : b; }

// Replaces a default name that has no material in the spec by the masonry's own joint: "joint"
// (lintel.bond, beam.joint), and "foundation".
std::string own_joint(const Shape& shape, const std::string& name, const Block& masonry) {
  const bool stands_in =
      (name == "joint" || name == "foundation") && !shape.material.contains(name);
  return stands_in ? bed_material(shape, masonry) : name;
}

// Joint material of a lintel; its ends, its bearing and what lies on it may differ.
std::string bond_material(const LintelSpec& lintel, const Block& a, const Contact& contact) {
  const Vec2 t = contact.p1 - contact.p0;
  const bool level = std::abs(t.y) <= kAlongAxis * length(t);
  const bool on_top = a.role == Role::kLintel;  // a is the lower block
  const std::string& own = on_top ? lintel.top_bond : lintel.bearing_bond;
  return level && !own.empty() ? own : lintel.bond;
}

// Joint material of a sill or ring beam (a or b) and its neighbour.
std::string band_material(const Shape& shape, const Block& a, const Block& b,
                          const Contact& contact) {
  const Block& band = a.role == Role::kSill || a.role == Role::kRingBeam ? a : b;
  if (band.role == Role::kSill) return shape.wall.opening[band.opening].sill.joint;
  const RingBeamSpec& beam = shape.ring_beam[band.ring_beam];
  const Vec2 t = contact.p1 - contact.p0;
  const bool on_top = &band == &a && std::abs(t.y) <= kAlongAxis * length(t);
  return on_top && !beam.top_joint.empty() ? beam.top_joint : beam.joint;
}

// Joint material of an arch: its own, or that of the bed joints around; the same between arch and masonry.
std::string arch_material(const Shape& shape, const Block& a, const Block& b) {
  const std::size_t opening = is_voussoir(a) ? a.opening : b.opening;
  const std::string& own = shape.wall.opening[opening].arch.joint;
  return are_of_one_arch(a, b) && !own.empty() ? own : bed_material(shape, owner_of(a, b));
}

const std::string& joint_of_frame(const Shape& shape, const Block& segment) {
  return shape.frame[segment.frame].joint;
}
std::string frame_joint(const Shape& shape, const Block& segment, const Block& other) {
  return own_joint(shape, joint_of_frame(shape, segment), other);
}

std::string pair_material(const Shape& shape, const Block& a, const Block& b, FaceKind kind,
                          const Contact& contact) {
  const Block& masonry = a.role == Role::kMasonry ? a : b;
  switch (kind) {
    case FaceKind::kLintelChain: return a.material;
    case FaceKind::kLintelBond:
      return own_joint(shape, bond_material(lintel_between(shape, a, b), a, contact), masonry);
    case FaceKind::kPlate: return own_joint(shape, plate_joint(shape), masonry);
    case FaceKind::kFrame: return frame_joint(shape, a.frame >= 0 ? a : b, masonry);
    case FaceKind::kBeam: break;
    default:
      if (is_chain(a) || is_chain(b))
        return own_joint(shape, band_material(shape, a, b, contact), masonry);
      if (is_voussoir(a) || is_voussoir(b)) return arch_material(shape, a, b);
  }
  const std::string plain = kind == FaceKind::kBeam
                                ? own_joint(shape, shape.wall.beam.joint, masonry)
                                : masonry_material(shape, owner_of(a, b), kind);
  const bool ruled = uses_blocks_file(shape) && kind != FaceKind::kSplit;
  return ruled ? ruled_material(shape, a.material, b.material, plain) : plain;
}

// Whether a head joint of masonry takes its bed's material: neither a contact rule nor a head_joint names another.
bool shares_bed(const Shape& shape, const Block& a, const Block& b, FaceKind kind) {
  const auto is_plain = [](const Block& block) {
    return block.role == Role::kMasonry && !is_voussoir(block);
  };
  return kind == FaceKind::kHead && is_plain(a) && is_plain(b) &&
         stated(shape, owner_of(a, b), &MasonryJoints::head_joint).empty() &&
         (!uses_blocks_file(shape) || ruled_material(shape, a.material, b.material, "").empty());
}

std::string ground_material(const Shape& shape, const Block& block, const Block* support) {
  std::string material = own_joint(shape, "foundation", block);
  if (!uses_blocks_file(shape)) return material;
  if (support != nullptr)
    material = ruled_material(shape, support->material, block.material, material);
  return ruled_material(shape, "ground", block.material, material);
}

Face pair_face(const Shape& shape, const Block& a, const Block& b, const Contact& contact) {
  const FaceKind kind = kind_of(a, b, contact);
  return {contact.a,
          contact.b,
          contact.p0,
          contact.p1,
          kind,
          pair_material(shape, a, b, kind, contact),
          shares_bed(shape, a, b, kind)};
}

// Makes the ground side a: a contact whose b is the support is reversed.
Face ground_face(const Shape& shape, const std::vector<Block>& blocks, Contact contact,
                 int support) {
  const bool is_frame = blocks[support == contact.a ? contact.b : contact.a].role == Role::kFrame;
  if (support != contact.a) {
    std::swap(contact.a, contact.b);
    std::swap(contact.p0, contact.p1);
  }
  const Block& block = blocks[contact.b];
  const Block* below = support == kGround ? nullptr : &blocks[support];
  return {kGround,
          contact.b,
          contact.p0,
          contact.p1,
          is_frame ? FaceKind::kFrame : FaceKind::kFoundation,
          is_frame ? joint_of_frame(shape, block) : ground_material(shape, block, below)};
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
      return {"missing: a lintel, sill or ring beam is made of it",
              "add " + table + " with its density and moduli"};
    case FaceKind::kLintelBond:
      return {
          "missing: it is the material of the joint between a lintel, sill or ring beam and the "
          "masonry",
          "add " + table};
    case FaceKind::kPlate:
      return {"missing: the plates on the piers lie on it",
              "add " + table + ", or name another plate_joint"};
    case FaceKind::kFrame:
      return {"missing: it is the material of the joint between a frame and the masonry",
              "add " + table + ", dry for contact alone, or name another frame.joint"};
    case FaceKind::kBeam:
      return {"missing: the beam lies on it", "add " + table + ", or name another wall.beam.joint"};
    default:
      return {"missing: it is the material of the joints between the blocks", "add " + table};
  }
}

// Each missing material once, with the first kind of joint that needs it.
using Uses = std::map<std::string, FaceKind>;

void refuse_missing(const Shape& shape, const Uses& uses, FaultList& faults) {
  for (const auto& [material, kind] : uses) {
    if (material.empty() || shape.material.contains(material)) continue;
    const Need need = need_of(kind, material);
    add_fault(faults, "material." + material, "", need.problem, need.cure);
  }
}

void add_chain_uses(const Shape& shape, Uses& uses) {
  for (const OpeningSpec& opening : shape.wall.opening) {
    if (!opening.arch.joint.empty()) uses.emplace(opening.arch.joint, FaceKind::kHead);
    if (!opening.sill.kind.empty()) {
      uses.emplace(opening.sill.material, FaceKind::kLintelChain);
      uses.emplace(own_joint(shape, opening.sill.joint, {}), FaceKind::kLintelBond);
    }
    if (opening.lintel.kind.empty()) continue;
    uses.emplace(opening.lintel.material, FaceKind::kLintelChain);
    for (const auto* bond :
         {&opening.lintel.bond, &opening.lintel.bearing_bond, &opening.lintel.top_bond})
      if (!bond->empty()) uses.emplace(own_joint(shape, *bond, {}), FaceKind::kLintelBond);
  }
  for (const RingBeamSpec& beam : shape.ring_beam) {
    uses.emplace(beam.material, FaceKind::kLintelChain);
    for (const auto* joint : {&beam.joint, &beam.top_joint})
      if (!joint->empty()) uses.emplace(own_joint(shape, *joint, {}), FaceKind::kLintelBond);
  }
}

void add_frame_uses(const Shape& shape, Uses& uses) {
  for (const FrameSpec& frame : shape.frame)
    if (!frame.joint.empty()) uses.emplace(own_joint(shape, frame.joint, {}), FaceKind::kFrame);
}

bool has_crack_planes(const Storey& storey) {
  if (storey.unit.split == Split::kMiddle) return storey.bond != Bond::kHeader;
  return storey.unit.split == Split::kAtJoints && storey.bond != Bond::kStack;
}

void add_masonry_uses(const Shape& shape, Uses& uses) {
  const bool from_file = uses_blocks_file(shape);
  for (const Storey& storey : stated_storeys(shape.wall, shape.storey)) {
    Block block;
    block.storey = storey.index;
    for (const FaceKind kind : {FaceKind::kBed, FaceKind::kHead, FaceKind::kSplit})
      if (kind != FaceKind::kSplit || (!from_file && has_crack_planes(storey)))
        uses.emplace(masonry_material(shape, block, kind), kind);
  }
  for (const RegionSpec& region : shape.region)
    for (const auto& [name, kind] : {std::pair(region.joints.joint, FaceKind::kBed),
                                     {region.joints.head_joint, FaceKind::kHead},
                                     {region.joints.unit_joint, FaceKind::kSplit}})
      if (!name.empty()) uses.emplace(name, kind);
}

// Whether a contact is between two segments of one frame, or of a held foot: sections connect these, not faces.
bool is_within_frame(const Shape& shape, const std::vector<Block>& blocks, const Contact& contact) {
  const auto frame_of = [&](int i) { return i == kGround ? -1 : blocks[i].frame; };
  const auto rests = [&](int i) { return i == kGround || blocks[i].role == Role::kSupport; };
  const int a = frame_of(contact.a), b = frame_of(contact.b);
  if (a >= 0 && a == b) return true;
  if (std::max(a, b) < 0 || !(rests(contact.a) || rests(contact.b))) return false;
  const FrameFeet feet = shape.frame[std::max(a, b)].feet;
  return feet == FrameFeet::kFixed || feet == FrameFeet::kHinged;
}

}  // namespace

std::string bed_material(const Shape& shape, const Block& block) {
  return masonry_material(shape, block, FaceKind::kBed);
}

bool uses_blocks_file(const Shape& shape) {
  return !shape.wall.blocks.empty() || !shape.block.empty();
}

std::vector<Face> name_faces(const Shape& shape, const std::vector<Block>& blocks,
                             const std::vector<Contact>& contacts) {
  const auto is_support = [&](int i) { return i == kGround || blocks[i].role == Role::kSupport; };
  std::vector<Face> faces;
  faces.reserve(contacts.size());
  for (const Contact& contact : contacts) {
    const bool a_rests = is_support(contact.a), b_rests = is_support(contact.b);
    if ((a_rests && b_rests) || is_within_frame(shape, blocks, contact)) continue;
    if (a_rests || b_rests) {
      faces.push_back(ground_face(shape, blocks, contact, a_rests ? contact.a : contact.b));
    } else {
      faces.push_back(pair_face(shape, blocks[contact.a], blocks[contact.b], contact));
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
  if (!uses_blocks_file(shape)) add_chain_uses(shape, uses);
  add_frame_uses(shape, uses);
  refuse_missing(shape, uses, faults);
}

void check_stated_materials(const Shape& shape, FaultList& faults) {
  Uses uses;
  add_masonry_uses(shape, uses);
  for (const ContactRule& rule : shape.contact) uses.emplace(rule.material, FaceKind::kBed);
  if (!uses_blocks_file(shape)) add_chain_uses(shape, uses);
  Block top;
  top.storey = static_cast<int>(shape.storey.size()) - 1;
  if (std::isfinite(shape.wall.beam.height))
    uses.emplace(own_joint(shape, shape.wall.beam.joint, top), FaceKind::kBeam);
  uses.emplace(own_joint(shape, plate_joint(shape), top), FaceKind::kPlate);
  add_frame_uses(shape, uses);
  refuse_missing(shape, uses, faults);
}

}  // namespace wythe::geometry
