// Deformable blocks in space: hexahedra -> zones, and their faces -> contacts with rigid blocks (solids.cpp in
// the plane; docs/theory/zones.md, "Zones in space").
#pragma once

#include "geometry/bodies/joint_faces.h"
#include "model/quadrature.h"
#include "wythe/parts/error.h"
#include "wythe/parts/model.h"

namespace wythe {

[[nodiscard]] inline bool has_zones(const BodySpec& body) { return body.zone.zones > 0; }

// A face between a rigid body and a deformable one.
struct SpaceSolidFace {
  const geometry::JointFace* face;
  BlockId rigid;          // block, or support n_block + i
  std::int32_t body;      // into SpaceSolids::bodies
  std::int32_t material;  // into Model::materials
  Vec3 tangent;           // of the face's frame
  bool from_rigid;        // whether its normal points from the rigid body to the zones
  Vec3 centroid;          // of the rigid body
};

// Makes nodes and zones of every body that requests zones, in order.
void compile_space_solids(const ModelSpec& spec, const geometry::SpaceAssembly& assembly,
                          Model& model, FaultList& faults);
// Makes their contacts, after the joints, whose points come first; lists zones and contacts of each node.
void compile_space_contacts(const std::vector<SpaceSolidFace>& faces,
                            const QuadratureChoice& choice, Model& model, FaultList& faults);

// --- the longest step (space_bound.cpp): omega^2 of each node from its zones and contacts
[[nodiscard]] std::vector<double> space_node_bounds(const Model& model);

}  // namespace wythe
