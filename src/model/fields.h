// The table of fields: it declares every array of State and Model once.
//
// A line gives content, entity and unit of an array. All lists of arrays are derived from the table, so
// that no other place lists them: the allocation (initial_state), the rows of a step for walls
// side by side (dynamics/passes/tables.h), and copies to and from these rows. Others are the hash of a
// state, restarts, packed snapshots, and the identity of a topology.
//
// To add a number to the history of the joint law: a member of contact::History and its line in
// contact::kHistory (law_constants.h), an array in State, and its line below, in the same order.
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <string_view>
#include <vector>

#include "wythe/parts/model.h"

namespace wythe {

// The entity that an array has one number for.
// kBody, kFacePoint: additional numbers of a block or point in space.
enum class Entity {
  kBlock,
  kNode,
  kPoint,
  kJoint,
  kZone,
  kContact,
  kLink,
  kFrameLink,
  kLayerNode,
  kBody,
  kFacePoint,
  kSupport,
  kSpaceNode,   // additional numbers of a node of zones in space
  kHandedOver,  // joints of a wall with free contacts
  kMaxwell,     // points of the joints of a wall with Maxwell elements
  kMaxwellInSpace,
  kFrameSet,  // a frame section of a wall where a stage installs something
  kFrameSetInSpace,
  kRelease,  // a block of a wall where a stage cuts an opening
  kReleaseInSpace,
  kOther
};

// Whether any stage of a wall has Maxwell elements.
[[nodiscard]] inline bool has_maxwell(const Model& m) {
  return std::any_of(m.stages.begin(), m.stages.end(),
                     [](const Stage& s) { return s.dashpots.spring_share > 0; });
}

// Whether any stage of a wall has dashpots or Maxwell elements.
[[nodiscard]] inline bool has_dashpots(const Model& m) {
  return std::any_of(m.stages.begin(), m.stages.end(),
                     [](const Stage& s) { return s.dashpots.any(); });
}

[[nodiscard]] inline std::size_t count_of(const Model& m, Entity entity) {
  switch (entity) {
    case Entity::kBlock: return static_cast<std::size_t>(m.n_block);
    case Entity::kNode: return static_cast<std::size_t>(m.solids.n_node + m.space.solids.n_node);
    case Entity::kSpaceNode: return static_cast<std::size_t>(m.space.solids.n_node);
    case Entity::kPoint: return static_cast<std::size_t>(m.n_history());
    case Entity::kJoint: return static_cast<std::size_t>(m.n_joint);
    case Entity::kZone: return static_cast<std::size_t>(m.solids.n_zone);
    case Entity::kContact: return static_cast<std::size_t>(m.solids.n_contact);
    case Entity::kLink: return static_cast<std::size_t>(m.links.n);
    case Entity::kFrameLink: return static_cast<std::size_t>(m.frames.n);
    case Entity::kLayerNode: return static_cast<std::size_t>(m.layers.n);
    case Entity::kBody: return m.space.inertia.empty() ? 0 : static_cast<std::size_t>(m.n_block);
    case Entity::kFacePoint:
      return m.space.point_share.empty() ? 0 : static_cast<std::size_t>(m.n_history());
    case Entity::kSupport: return static_cast<std::size_t>(m.space.n_support);
    case Entity::kHandedOver: return m.free.any() ? static_cast<std::size_t>(m.n_joint) : 0;
    case Entity::kMaxwell: return has_maxwell(m) ? static_cast<std::size_t>(m.n_point()) : 0;
    case Entity::kMaxwellInSpace:
      return m.space.point_share.empty() ? 0 : count_of(m, Entity::kMaxwell);
    case Entity::kFrameSet: return m.standing.any() ? count_of(m, Entity::kFrameLink) : 0;
    case Entity::kFrameSetInSpace:
      return m.space.inertia.empty() ? 0 : count_of(m, Entity::kFrameSet);
    case Entity::kRelease: return m.standing.any() ? count_of(m, Entity::kBlock) : 0;
    case Entity::kReleaseInSpace:
      return m.space.inertia.empty() ? 0 : count_of(m, Entity::kRelease);
    case Entity::kOther: break;
  }
  return 0;
}

// --- the state: its own for each wall; kept between steps, hashed, saved and packed in this order ------

struct StateField {
  std::vector<double> State::*array;
  Entity entity;
  bool in_store;  // stored by campaigns, in this order; without velocities
  std::string_view name, unit, meaning;
};

inline constexpr std::array kStateFields{
    StateField{&State::ux, Entity::kBlock, true, "ux", "m", "displacement of the centroid along x"},
    StateField{&State::uy, Entity::kBlock, true, "uy", "m", "displacement of the centroid along y"},
    StateField{&State::theta, Entity::kBlock, true, "theta", "rad", "rotation, anticlockwise"},
    StateField{&State::vx, Entity::kBlock, false, "vx", "m/s",
               "velocity along x, half a step back"},
    StateField{&State::vy, Entity::kBlock, false, "vy", "m/s",
               "velocity along y, half a step back"},
    StateField{&State::omega, Entity::kBlock, false, "omega", "rad/s",
               "rate of rotation, half a step back"},
    StateField{&State::kappa, Entity::kPoint, true, "kappa", "m", "largest opening reached"},
    StateField{&State::crush, Entity::kPoint, true, "crush", "m", "shortening by crushing"},
    StateField{&State::plastic_slip, Entity::kPoint, true, "plastic_slip", "m",
               "plastic slip, signed"},
    StateField{&State::slip, Entity::kPoint, true, "slip", "m",
               "plastic slip, summed without sign"},
    StateField{&State::shear_damage, Entity::kPoint, true, "shear_damage", "1", "damage in shear"},
    StateField{&State::tension_set, Entity::kPoint, true, "tension_set", "m",
               "opening that stays (elastic unloading)"},
    StateField{&State::crush_path, Entity::kPoint, true, "crush_path", "m",
               "path of crushing (compression cap); of no length in walls without one"},
    StateField{&State::node_ux, Entity::kNode, true, "node_ux", "m",
               "displacement of a node along x"},
    StateField{&State::node_uy, Entity::kNode, true, "node_uy", "m",
               "displacement of a node along y"},
    StateField{&State::node_vx, Entity::kNode, false, "node_vx", "m/s",
               "velocity of a node along x"},
    StateField{&State::node_vy, Entity::kNode, false, "node_vy", "m/s",
               "velocity of a node along y"},
    StateField{&State::link_force, Entity::kLink, true, "link_force", "N",
               "force of a link, tension +"},
    StateField{&State::link_plastic, Entity::kLink, true, "link_plastic", "m",
               "elongation of a link that stays"},
    StateField{&State::link_drawn, Entity::kLink, true, "link_drawn", "m",
               "elongation of a link drawn in by prestress"},
    StateField{&State::uz, Entity::kBody, true, "uz", "m", "displacement of the centroid along z"},
    StateField{&State::qw, Entity::kBody, true, "qw", "1",
               "turn since the start, a unit quaternion"},
    StateField{&State::qx, Entity::kBody, true, "qx", "1", "its part along x"},
    StateField{&State::qy, Entity::kBody, true, "qy", "1", "its part along y"},
    StateField{&State::qz, Entity::kBody, true, "qz", "1", "its part along z"},
    StateField{&State::vz, Entity::kBody, false, "vz", "m/s", "velocity along z, half a step back"},
    StateField{&State::lx, Entity::kBody, false, "lx", "kg m^2/s",
               "angular momentum about x, half a step back"},
    StateField{&State::ly, Entity::kBody, false, "ly", "kg m^2/s",
               "angular momentum about y, half a step back"},
    StateField{&State::lz, Entity::kBody, false, "lz", "kg m^2/s",
               "angular momentum about z, half a step back"},
    StateField{&State::plastic_slip_2, Entity::kFacePoint, true, "plastic_slip_2", "m",
               "plastic slip across the first direction of the face"},
    StateField{&State::support_x, Entity::kSupport, true, "support_x", "m",
               "displacement of a support along x"},
    StateField{&State::support_y, Entity::kSupport, true, "support_y", "m",
               "displacement of a support along y"},
    StateField{&State::support_z, Entity::kSupport, true, "support_z", "m",
               "displacement of a support along z"},
    StateField{&State::node_uz, Entity::kSpaceNode, true, "node_uz", "m",
               "displacement of a node along z"},
    StateField{&State::node_vz, Entity::kSpaceNode, false, "node_vz", "m/s",
               "velocity of a node along z"},
    StateField{&State::handed_over, Entity::kHandedOver, true, "handed_over", "1",
               "1: a joint that gave way to free contact; of no length in walls without such"},
    StateField{&State::maxwell_normal, Entity::kMaxwell, false, "maxwell_normal", "Pa",
               "normal stress of a Maxwell element; of no length in walls without such"},
    StateField{&State::maxwell_shear, Entity::kMaxwell, false, "maxwell_shear", "Pa",
               "shear stress of a Maxwell element"},
    StateField{&State::maxwell_shear_2, Entity::kMaxwellInSpace, false, "maxwell_shear_2", "Pa",
               "the same across the first direction of the face"},
    StateField{&State::frame_left, Entity::kFrameLink, true, "frame_left", "m",
               "elongation that stays of a frame's fibre left of its member's way"},
    StateField{&State::frame_middle, Entity::kFrameLink, true, "frame_middle", "m",
               "the same in the axis"},
    StateField{&State::frame_right, Entity::kFrameLink, true, "frame_right", "m",
               "the same right of the way"},
    StateField{&State::frame_along, Entity::kFrameSet, true, "frame_along", "m",
               "how far a frame's section had gone along its member when a stage put it up"},
    StateField{&State::frame_across, Entity::kFrameSet, true, "frame_across", "m",
               "the same across it"},
    StateField{&State::frame_turn, Entity::kFrameSet, true, "frame_turn", "rad",
               "how far it had turned"},
    StateField{&State::frame_aside, Entity::kFrameSetInSpace, true, "frame_aside", "m",
               "how far it had gone across the frame's plane"},
    StateField{&State::frame_lean, Entity::kFrameSetInSpace, true, "frame_lean", "rad",
               "how far it had turned about the left of its member's way"},
    StateField{&State::frame_twist, Entity::kFrameSetInSpace, true, "frame_twist", "rad",
               "the same about the member's axis"},
    StateField{
        &State::release_x, Entity::kRelease, true, "release_x", "N",
        "force along x that what was cut out left on its neighbours; of no length in other walls"},
    StateField{&State::release_y, Entity::kRelease, true, "release_y", "N", "the same along y"},
    StateField{&State::release_m, Entity::kRelease, true, "release_m", "N m",
               "the same about the centroid; in space about z"},
    StateField{&State::release_z, Entity::kReleaseInSpace, true, "release_z", "N",
               "the same along z"},
    StateField{&State::release_mx, Entity::kReleaseInSpace, true, "release_mx", "N m",
               "the same about x"},
    StateField{&State::release_my, Entity::kReleaseInSpace, true, "release_my", "N m",
               "the same about y"},
    StateField{&State::layer_slip, Entity::kLayerNode, true, "layer_slip", "m",
               "slip of a layer's node on its block"},
    StateField{&State::layer_reached, Entity::kLayerNode, true, "layer_reached", "m",
               "largest slip reached, without sign"},
    StateField{&State::layer_broken, Entity::kLayerNode, true, "layer_broken", "1",
               "1: the fibres to the next node are broken"},
};

// Number of values in an array of the state; 0 where the wall has no law that needs it.
[[nodiscard]] std::size_t count_of(const Model& model, const StateField& field);

// Number of an entity's fields, and the index of an array among them: its row.
[[nodiscard]] constexpr int fields_of(Entity entity) {
  return static_cast<int>(std::count_if(kStateFields.begin(), kStateFields.end(),
                                        [&](const StateField& f) { return f.entity == entity; }));
}
[[nodiscard]] constexpr int row_of(std::vector<double> State::*array) {
  int row = 0;
  for (const StateField& field : kStateFields) {
    if (field.array != array) continue;
    for (const StateField* before = kStateFields.data(); before != &field; ++before)
      row += before->entity == field.entity ? 1 : 0;
  }
  return row;
}

// --- the model -------------------------------------------------------------------------------------------

// Walls of a campaign can be stepped side by side if they differ in kOwn fields only.
enum class Shared {
  kTopology,  // contacts and their places: equal in walls side by side
  kOwn,       // numbers of each wall
};

// visit(array, entity, shared, name, unit) for every array of the model that a step reads. M: Model or
// const Model. The function is long because it is a table, one line a field.
template <class M, class Visit>
void each_model_field(M& m, const Visit& visit) {
  using E = Entity;
  constexpr Shared kAll = Shared::kTopology, kOwn = Shared::kOwn;
  visit(m.joint_a, E::kJoint, kAll, "joint_a", "");
  visit(m.joint_b, E::kJoint, kAll, "joint_b", "");
  visit(m.joint_material, E::kJoint, kAll, "joint_material", "");
  visit(m.arm_a_x, E::kJoint, kAll, "arm_a_x", "m");
  visit(m.arm_a_y, E::kJoint, kAll, "arm_a_y", "m");
  visit(m.arm_b_x, E::kJoint, kAll, "arm_b_x", "m");
  visit(m.arm_b_y, E::kJoint, kAll, "arm_b_y", "m");
  visit(m.half_x, E::kJoint, kAll, "half_x", "m");
  visit(m.half_y, E::kJoint, kAll, "half_y", "m");
  visit(m.tangent_x, E::kJoint, kAll, "tangent_x", "1");
  visit(m.tangent_y, E::kJoint, kAll, "tangent_y", "1");
  visit(m.area, E::kJoint, kAll, "area", "m^2");
  visit(m.point_xi, E::kOther, kAll, "point_xi", "1");
  visit(m.point_weight, E::kOther, kAll, "point_weight", "1");
  visit(m.block_begin, E::kOther, kAll, "block_begin", "");
  visit(m.block_entry, E::kOther, kAll, "block_entry", "");
  visit(m.turn_freedom, E::kBlock, kAll, "turn_freedom", "1");
  visit(m.mass, E::kBlock, kOwn, "mass", "kg");
  visit(m.gravity_mass, E::kBlock, kOwn, "heavy_mass", "kg");
  visit(m.inertia, E::kBlock, kOwn, "inertia", "kg m^2");

  auto& s = m.solids;
  for (auto& corner : s.corner) visit(corner, E::kZone, kAll, "corner", "");
  visit(s.zone_shape, E::kZone, kAll, "zone_shape", "");
  visit(s.shapes, E::kOther, kAll, "shapes", "");
  visit(s.contact_block, E::kContact, kAll, "contact_block", "");
  visit(s.contact_p, E::kContact, kAll, "contact_p", "");
  visit(s.contact_q, E::kContact, kAll, "contact_q", "");
  visit(s.share_0, E::kContact, kAll, "share_0", "1");
  visit(s.share_1, E::kContact, kAll, "share_1", "1");
  visit(s.arm_0_x, E::kContact, kAll, "arm_0_x", "m");
  visit(s.arm_0_y, E::kContact, kAll, "arm_0_y", "m");
  visit(s.arm_1_x, E::kContact, kAll, "arm_1_x", "m");
  visit(s.arm_1_y, E::kContact, kAll, "arm_1_y", "m");
  visit(s.contact_tangent_x, E::kContact, kAll, "contact_tangent_x", "1");
  visit(s.contact_tangent_y, E::kContact, kAll, "contact_tangent_y", "1");
  visit(s.contact_area, E::kContact, kAll, "contact_area", "m^2");
  visit(s.contact_material, E::kContact, kAll, "contact_material", "");
  visit(s.zone_begin, E::kOther, kAll, "zone_begin", "");
  visit(s.zone_entry, E::kOther, kAll, "zone_entry", "");
  visit(s.contact_begin, E::kOther, kAll, "contact_begin", "");
  visit(s.contact_entry, E::kOther, kAll, "contact_entry", "");
  visit(s.node_free_x, E::kNode, kAll, "node_free_x", "1");
  visit(s.node_free_y, E::kNode, kAll, "node_free_y", "1");
  visit(s.node_mass, E::kNode, kOwn, "node_mass", "kg");
  visit(s.node_gravity_mass, E::kNode, kOwn, "node_heavy_mass", "kg");

  auto& l = m.links;
  auto& b = m.space;
  visit(b.arm_a, E::kJoint, kAll, "space_arm_a", "m");
  visit(b.arm_b, E::kJoint, kAll, "space_arm_b", "m");
  visit(b.tangent, E::kJoint, kAll, "space_tangent", "1");
  visit(b.normal, E::kJoint, kAll, "space_normal", "1");
  visit(b.point_begin, E::kOther, kAll, "space_point_begin", "");
  visit(b.point_r1, E::kPoint, kAll, "space_point_r1", "m");
  visit(b.point_r2, E::kPoint, kAll, "space_point_r2", "m");
  visit(b.point_share, E::kPoint, kAll, "space_point_share", "1");
  visit(b.axis_1, E::kBlock, kAll, "space_axis_1", "1");
  visit(b.axis_2, E::kBlock, kAll, "space_axis_2", "1");
  visit(b.axis_3, E::kBlock, kAll, "space_axis_3", "1");
  visit(b.inertia, E::kBlock, kOwn, "space_inertia", "kg m^2");

  auto& z = b.solids;
  if (z.n_zone > 0) {
    visit(z.corner, E::kOther, kAll, "space_corner", "");
    visit(z.zone_shape, E::kOther, kAll, "space_zone_shape", "");
    visit(z.contact_block, E::kOther, kAll, "space_contact_block", "");
    visit(z.contact_node, E::kOther, kAll, "space_contact_node", "");
    visit(z.point_begin, E::kOther, kAll, "space_contact_point_begin", "");
    visit(z.node_share, E::kOther, kAll, "space_node_share", "1");
    visit(z.contact_arm, E::kOther, kAll, "space_contact_arm", "m");
    visit(z.contact_tangent, E::kOther, kAll, "space_contact_tangent", "1");
    visit(z.contact_normal, E::kOther, kAll, "space_contact_normal", "1");
    visit(z.contact_area, E::kOther, kAll, "space_contact_area", "m^2");
    visit(z.contact_material, E::kOther, kAll, "space_contact_material", "");
    visit(z.node, E::kOther, kAll, "space_node", "m");
    visit(z.node_mass, E::kSpaceNode, kOwn, "space_node_mass", "kg");
    visit(z.node_gravity_mass, E::kSpaceNode, kOwn, "space_node_heavy_mass", "kg");
  }

  visit(l.a, E::kLink, kAll, "link_a", "");
  visit(l.b, E::kLink, kAll, "link_b", "");
  visit(l.arm_a_x, E::kLink, kOwn, "link_arm_a_x", "m");
  visit(l.arm_a_y, E::kLink, kOwn, "link_arm_a_y", "m");
  visit(l.arm_b_x, E::kLink, kOwn, "link_arm_b_x", "m");
  visit(l.arm_b_y, E::kLink, kOwn, "link_arm_b_y", "m");
  visit(l.span_x, E::kLink, kOwn, "link_span_x", "m");
  visit(l.span_y, E::kLink, kOwn, "link_span_y", "m");
  visit(l.arm_a_z, E::kLink, kOwn, "link_arm_a_z", "m");
  visit(l.arm_b_z, E::kLink, kOwn, "link_arm_b_z", "m");
  visit(l.span_z, E::kLink, kOwn, "link_span_z", "m");
  visit(l.follows, E::kLink, kOwn, "link_follows", "1");
  visit(l.stiffness, E::kLink, kOwn, "link_stiffness", "N/m");
  visit(l.tension, E::kLink, kOwn, "link_tension", "N");
  visit(l.compression, E::kLink, kOwn, "link_compression", "N");
  visit(l.prestress, E::kLink, kOwn, "link_prestress", "N");
  visit(l.jack, E::kLink, kOwn, "link_jack", "N");

  auto& f = m.frames;
  if (f.n > 0) {
    visit(f.a, E::kFrameLink, kAll, "frame_a", "");
    visit(f.b, E::kFrameLink, kAll, "frame_b", "");
    visit(f.arm_a_x, E::kFrameLink, kOwn, "frame_arm_a_x", "m");
    visit(f.arm_a_y, E::kFrameLink, kOwn, "frame_arm_a_y", "m");
    visit(f.arm_b_x, E::kFrameLink, kOwn, "frame_arm_b_x", "m");
    visit(f.arm_b_y, E::kFrameLink, kOwn, "frame_arm_b_y", "m");
    visit(f.axis_x, E::kFrameLink, kOwn, "frame_axis_x", "1");
    visit(f.axis_y, E::kFrameLink, kOwn, "frame_axis_y", "1");
    visit(f.rest_x, E::kFrameLink, kOwn, "frame_rest_x", "m");
    visit(f.rest_y, E::kFrameLink, kOwn, "frame_rest_y", "m");
    visit(f.outer_stiffness, E::kFrameLink, kOwn, "frame_outer_stiffness", "N/m");
    visit(f.middle_stiffness, E::kFrameLink, kOwn, "frame_middle_stiffness", "N/m");
    visit(f.shear_stiffness, E::kFrameLink, kOwn, "frame_shear_stiffness", "N/m");
    visit(f.fibre, E::kFrameLink, kOwn, "frame_fibre", "m");
    visit(f.outer_yield, E::kFrameLink, kOwn, "frame_outer_yield", "N");
    visit(f.middle_yield, E::kFrameLink, kOwn, "frame_middle_yield", "N");
    visit(f.arm_a_z, E::kFrameLink, kOwn, "frame_arm_a_z", "m");
    visit(f.arm_b_z, E::kFrameLink, kOwn, "frame_arm_b_z", "m");
    visit(f.axis_z, E::kFrameLink, kOwn, "frame_axis_z", "1");
    visit(f.rest_z, E::kFrameLink, kOwn, "frame_rest_z", "m");
    visit(f.left, E::kFrameLink, kOwn, "frame_left_of_way", "1");
    visit(f.aside_stiffness, E::kFrameLink, kOwn, "frame_aside_stiffness", "N/m");
    visit(f.lean_stiffness, E::kFrameLink, kOwn, "frame_lean_stiffness", "N m");
    visit(f.twist_stiffness, E::kFrameLink, kOwn, "frame_twist_stiffness", "N m");
  }

  if (m.standing.any()) {
    visit(m.standing.from, E::kBlock, kAll, "stands_from", "");
    visit(m.standing.until, E::kBlock, kAll, "stands_until", "");
  }

  auto& n = m.layers;
  if (n.n > 0) {
    visit(n.a, E::kLayerNode, kAll, "layer_a", "");
    visit(n.b, E::kLayerNode, kAll, "layer_b", "");
    visit(n.crossing, E::kLayerNode, kAll, "layer_crossing", "");
    visit(n.cross_a, E::kOther, kAll, "layer_cross_a", "");
    visit(n.cross_b, E::kOther, kAll, "layer_cross_b", "");
    visit(n.arm_a_x, E::kLayerNode, kOwn, "layer_arm_a_x", "m");
    visit(n.arm_a_y, E::kLayerNode, kOwn, "layer_arm_a_y", "m");
    visit(n.arm_b_x, E::kLayerNode, kOwn, "layer_arm_b_x", "m");
    visit(n.arm_b_y, E::kLayerNode, kOwn, "layer_arm_b_y", "m");
    visit(n.span_x, E::kLayerNode, kOwn, "layer_span_x", "m");
    visit(n.span_y, E::kLayerNode, kOwn, "layer_span_y", "m");
    visit(n.stiffness, E::kLayerNode, kOwn, "layer_stiffness", "N/m");
    visit(n.strength, E::kLayerNode, kOwn, "layer_strength", "N");
    visit(n.bond_energy, E::kLayerNode, kOwn, "layer_bond_energy", "J");
    visit(n.bond_rate, E::kLayerNode, kOwn, "layer_bond_rate", "1/m");
  }
}

// Identity of what walls must share to be stepped side by side: a hash of the kTopology fields, the number
// of stages, the laws of materials (not their strengths), and which materials a field varies beyond their
// strengths. compile() stores it in
// Model::topology.
[[nodiscard]] std::uint64_t topology_of(const Model& model);

// Whether joints of one stated material differ in more than the first contact::kStrengths constants of their law.
[[nodiscard]] bool varies_beyond_strengths(const Model& model, std::int32_t stated);

}  // namespace wythe
