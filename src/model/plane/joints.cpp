// Faces -> joints: arms, areas, materials and gather lists.
#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <set>

#include "contact/parameters.h"
#include "core/elementary.h"
#include "model/field_places.h"
#include "model/joint_laws.h"
#include "model/parts.h"
#include "model/quadrature.h"

namespace wythe {
namespace {

using geometry::Assembly;
using geometry::Face;
using geometry::FaceKind;

JointKind kind_of(FaceKind kind) {
  switch (kind) {
    case FaceKind::kBed: return JointKind::kBed;
    case FaceKind::kHead: return JointKind::kHead;
    case FaceKind::kSplit: return JointKind::kSplit;
    case FaceKind::kFoundation: return JointKind::kFoundation;
    case FaceKind::kLintelChain: return JointKind::kLintelChain;
    case FaceKind::kLintelBond: return JointKind::kLintelBond;
    case FaceKind::kPlate: return JointKind::kPlate;
    case FaceKind::kBeam: return JointKind::kBeam;
    case FaceKind::kFrame: return JointKind::kFrame;
    case FaceKind::kCoat: return JointKind::kCoat;
    case FaceKind::kOther: break;
  }
  return JointKind::kOther;
}

void set_points(Model& model) {
  const auto [kind, points] = quadrature_choice(model.solve);
  model.solve.point_rule = kind;
  model.solve.points_per_face = model.n_face_point = points;
  FaceQuadrature rule = face_points(kind, points);
  model.point_xi = std::move(rule.xi);
  model.point_weight = std::move(rule.weight);
}

double length_of(const Face& face) {
  return elementary::hypot(face.p1.x - face.p0.x, face.p1.y - face.p0.y);
}

// The laws of joints, of mortar and of chains.
class MaterialTable : public JointLaws {
 public:
  MaterialTable(const ModelSpec& spec, Model& model, FaultList& faults)
      : JointLaws(spec, model, faults, false) {}

  // Index of the material of face `number`.
  int face_index(const Face& face, int number, const FieldValues& fields) {
    return index_of(face.material, face.shares_bed, number,
                    {0.5 * (face.p0.x + face.p1.x), 0.5 * (face.p0.y + face.p1.y), 0}, fields);
  }

  // Index of the law of mortar; one law for each distance of units.
  int coat_index(const Coat& coat) {
    const auto known = std::find_if(coats_.begin(), coats_.end(), [&](const auto& one) {
      const double k = coat.law.normal_stiffness, other = one.first.law.normal_stiffness;
      return one.first.name == coat.name && std::fabs(k - other) <= 1e-9 * k;
    });
    if (known != coats_.end()) return known->second;
    coats_.emplace_back(coat, append(coat.name, coat.law));
    return coats_.back().second;
  }

  // Index of the law of a lintel's chain; one law for each set of arguments of chain_material().
  int chain_index(const Face& face, double spacing, double depth) {
    const Chain wanted{face.material, spacing, depth, length_of(face), 0};
    const auto known = std::find_if(chains_.begin(), chains_.end(),
                                    [&](const Chain& chain) { return is_same(chain, wanted); });
    if (known != chains_.end()) return known->index;
    const JointMaterial& body = spec_.material.at(face.material);
    for (const auto& [key, value] :
         {std::pair("youngs_modulus", body.youngs_modulus), {"shear_modulus", body.shear_modulus}})
      if (!(value > 0) && has_no_chain_.insert(face.material + "." + key).second)
        faults_.add(
            {"", "material." + face.material + "." + key, "",
             "is missing or not positive; a chain of segments (lintel, sill, ring beam) needs both "
             "moduli",
             fmt::format("add e.g. {} = \"0.3 GPa\"", key), 0});
    chains_.push_back(wanted);
    chains_.back().index = append(fmt::format("{} chain {:.3f} m", face.material, spacing),
                                  chain_material(body, spacing, depth, length_of(face)));
    return chains_.back().index;
  }

 private:
  struct Chain {
    std::string material;
    double spacing, depth, face;  // [m]
    int index;
  };
  // Whether the lengths agree up to round-off of coordinates, which must not give two materials.
  static bool is_same(const Chain& a, const Chain& b) {
    const auto near = [](double x, double y) { return std::fabs(x - y) <= 1e-9 * std::fabs(x); };
    return a.material == b.material && near(a.spacing, b.spacing) && near(a.depth, b.depth) &&
           near(a.face, b.face);
  }

  std::vector<Chain> chains_;
  std::vector<std::pair<Coat, int>> coats_;  // with the index of their law
  std::set<std::string> has_no_chain_;       // materials without moduli, reported once
};

// Structural depth of the body of a chain's face; length of the face where none is stated.
double chain_depth(const ModelSpec& spec, const Assembly& assembly, const Face& face) {
  const geometry::Block& block = assembly.blocks[face.b];
  if (block.ring_beam >= 0) return spec.ring_beam[block.ring_beam].height;
  if (block.opening < 0) return length_of(face);
  const OpeningSpec& opening = spec.wall.opening[block.opening];
  return block.role == geometry::Role::kSill ? opening.sill.depth : opening.lintel.depth;
}

bool touches_solid(const Face& face, const BlockMap& map) {
  const auto solid = [&](int block) { return block != geometry::kGround && is_solid(map[block]); };
  return solid(face.a) || solid(face.b);
}

// Order of joints for the step: pairs before ground, then by variant and material, else as found.
std::vector<std::size_t> joint_order(const std::vector<Face>& faces, const BlockMap& map,
                                     const std::vector<int>& material, const Model& model) {
  std::vector<std::size_t> order(faces.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  const auto key = [&](std::size_t f) {
    const Face& face = faces[f];
    const bool ground = face.a == geometry::kGround || map[face.a] == kGroundBlock;
    const JointMaterial& m = model.materials[material[f]];
    return std::tuple(ground, m.softening, m.coupling, m.unloading, contact::choice_of(m).cap,
                      model.stated(material[f]));
  };
  std::stable_sort(order.begin(), order.end(), [&](auto a, auto b) { return key(a) < key(b); });
  return order;
}

void add_joint(const Face& face, int material, double half_scale, double thickness,
               const BlockMap& map, Model& m) {
  const BlockId a = face.a == geometry::kGround ? kGroundBlock : map[face.a];
  const BlockId b = map[face.b];
  const double cx = 0.5 * (face.p0.x + face.p1.x), cy = 0.5 * (face.p0.y + face.p1.y);
  const double length = length_of(face);
  m.joint_a.push_back(a);
  m.joint_b.push_back(b);
  m.joint_material.push_back(material);
  m.arm_a_x.push_back(a == kGroundBlock ? 0.0 : cx - m.centroid_x[a]);
  m.arm_a_y.push_back(a == kGroundBlock ? 0.0 : cy - m.centroid_y[a]);
  m.arm_b_x.push_back(cx - m.centroid_x[b]);
  m.arm_b_y.push_back(cy - m.centroid_y[b]);
  m.tangent_x.push_back((face.p1.x - face.p0.x) / length);
  m.tangent_y.push_back((face.p1.y - face.p0.y) / length);
  m.half_x.push_back(0.5 * half_scale * (face.p1.x - face.p0.x));
  m.half_y.push_back(0.5 * half_scale * (face.p1.y - face.p0.y));
  m.area.push_back(length * thickness);
  m.anatomy.joint_kind.push_back(kind_of(face.kind));
  ++m.n_joint;
  if (a != kGroundBlock) ++m.n_pair;
}

}  // namespace

// First the joints in which a block is side a, then those in which it is b.
void list_joints_of_blocks(Model& model) {
  std::vector<std::vector<std::int32_t>> of(model.n_block);
  for (const int side : {0, 1})
    for (int j = 0; j < model.n_joint; ++j) {
      const BlockId block = (side == 0 ? model.joint_a : model.joint_b)[j];
      if (block >= 0 && block < model.n_block) of[block].push_back(2 * j + side);
    }
  model.block_begin.assign(1, 0);
  model.block_entry.clear();
  for (const auto& entries : of) {
    model.block_entry.insert(model.block_entry.end(), entries.begin(), entries.end());
    model.block_begin.push_back(static_cast<std::int32_t>(model.block_entry.size()));
  }
}

JointMaterial chain_material(const JointMaterial& body, double spacing, double depth, double face) {
  constexpr double kShearCorrection = 5.0 / 6.0;  // rectangular section
  JointMaterial chain;
  chain.normal_stiffness = body.youngs_modulus / spacing * depth / face;
  chain.shear_stiffness = kShearCorrection * body.shear_modulus / spacing * depth / face;
  chain.tensile_strength = chain.cohesion = chain.residual_cohesion = kUnlimited;
  chain.friction_angle = chain.residual_friction_angle = 0;
  chain.compressive_strength = kUnlimited;
  return chain;
}

double chain_half_scale(const Model& model, double depth, double face) {
  double second = 0;
  for (std::size_t k = 0; k < model.point_xi.size(); ++k)
    second += model.point_weight[k] * model.point_xi[k] * model.point_xi[k];
  return depth / face / std::sqrt(3.0 * second);
}

void compile_joints(const ModelSpec& spec, const Assembly& assembly, const BlockMap& map,
                    const FieldValues& fields, Model& model, FaultList& faults) {
  set_points(model);
  MaterialTable table(spec, model, faults);
  std::vector<int> material;
  std::vector<double> half_scale, thickness;
  std::vector<Face> faces;  // between rigid blocks
  std::vector<SolidFace> solid_faces;
  for (std::size_t number = 0; number < assembly.faces.size(); ++number) {
    const Face& face = assembly.faces[number];
    if (touches_solid(face, map)) {
      solid_faces.push_back({&face, table.face_index(face, static_cast<int>(number), fields)});
      continue;
    }
    faces.push_back(face);
    thickness.push_back(assembly.thickness_of(face));
    if (face.kind != FaceKind::kLintelChain) {
      material.push_back(table.face_index(face, static_cast<int>(number), fields));
      half_scale.push_back(1.0);
      continue;
    }
    const BlockId a = map[face.a], b = map[face.b];
    const double spacing = std::fabs(model.centroid_x[b] - model.centroid_x[a]);
    const double depth = chain_depth(spec, assembly, face);
    material.push_back(table.chain_index(face, spacing, depth));
    half_scale.push_back(chain_half_scale(model, depth, length_of(face)));
  }
  table.report_drawn();
  for (const Coat& coat : compile_coats(spec, assembly, map, model, faults)) {
    faces.push_back(coat.face);
    thickness.push_back(coat.thickness);
    material.push_back(table.coat_index(coat));
    half_scale.push_back(1.0);
  }
  for (const std::size_t f : joint_order(faces, map, material, model))
    add_joint(faces[f], material[f], half_scale[f], thickness[f], map, model);
  list_joints_of_blocks(model);
  if (!model.solids.bodies.empty())
    compile_contacts(assembly, map, std::move(solid_faces), model, faults);
}

Message head_bond_note(const std::string& name, const JointMaterial& bed) {
  return {"material.head_joint_bond", {{"material", name}, {"share", bed.head_joint_bond}}};
}

}  // namespace wythe
