// The compiled wall: flat arrays, grouped by the pass of the computation that reads them.
//
//   ModelSpec --compile()--> Model (const)  +  State (mutable, exactly what a restart needs)
//
// Block  : centroid, mass, polar inertia; moves by (ux, uy, theta).
// Joint  : a pair of faces. Side a may be the ground. Both faces coincide at the start:
//
//              b                 t  along the face,   half = e = half the face vector (along t)
//        ------------> t         n  on the left of t, from a to b
//              a                 arm_a, arm_b: face centre seen from each centroid
//
// Point  : n_face_point per joint at  centre + xi_k e  with the area share weight_k.
// Joints 0..n_pair-1 are between blocks, n_pair..n_joint-1 on the ground.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "wythe/parts/contact_law.h"
#include "wythe/parts/field.h"
#include "wythe/parts/free_contacts.h"
#include "wythe/parts/ground_motion.h"
#include "wythe/parts/hexahedron_shape.h"
#include "wythe/parts/message.h"
#include "wythe/parts/vector.h"
#include "wythe/parts/wall_spec.h"
#include "wythe/parts/words.h"
#include "wythe/parts/zone_shape.h"

namespace wythe {

using BlockId = std::int32_t;
using JointId = std::int32_t;
using PointId = std::int32_t;  // joint * n_face_point + k
inline constexpr BlockId kGroundBlock = -1;

// VTU files hold the numbers of roles and kinds (docs/reference/results.md), so these never change.
enum class BlockRole : std::uint8_t {
  kMasonry = 0,
  kLintel = 1,
  kPlate = 2,
  kBeam = 3,
  kRingBeam = 4,
  kSill = 5,
  kSlab = 6,
  kFrame = 7,
  kCutOut = 8  // masonry where a stage cuts an opening
};
inline constexpr Word<BlockRole> kBlockRoleWords[] = {
    {"masonry", BlockRole::kMasonry},    {"lintel", BlockRole::kLintel},
    {"plate", BlockRole::kPlate},        {"beam", BlockRole::kBeam},
    {"ring_beam", BlockRole::kRingBeam}, {"sill", BlockRole::kSill},
    {"slab", BlockRole::kSlab},          {"frame", BlockRole::kFrame},
    {"cut_out", BlockRole::kCutOut}};
enum class JointKind : std::uint8_t {
  kBed = 0,
  kHead = 1,
  kSplit = 2,
  kFoundation = 3,
  kLintelChain = 4,
  kLintelBond = 5,
  kPlate = 6,
  kBeam = 7,
  kOther = 8,
  kFrame = 9,
  kCoat = 10  // the mortar of a layer, beside the joint that it covers
};
inline constexpr Word<JointKind> kJointKindWords[] = {{"bed", JointKind::kBed},
                                                      {"head", JointKind::kHead},
                                                      {"split", JointKind::kSplit},
                                                      {"foundation", JointKind::kFoundation},
                                                      {"lintel_chain", JointKind::kLintelChain},
                                                      {"lintel_bond", JointKind::kLintelBond},
                                                      {"plate", JointKind::kPlate},
                                                      {"beam", JointKind::kBeam},
                                                      {"other", JointKind::kOther},
                                                      {"frame", JointKind::kFrame},
                                                      {"coat", JointKind::kCoat}};
// Codes of the messages that give their names.
inline constexpr Word<JointKind> kJointKindCodes[] = {{"joint.bed", JointKind::kBed},
                                                      {"joint.head", JointKind::kHead},
                                                      {"joint.unit", JointKind::kSplit},
                                                      {"joint.foundation", JointKind::kFoundation},
                                                      {"joint.lintel", JointKind::kLintelChain},
                                                      {"joint.bearing", JointKind::kLintelBond},
                                                      {"joint.plate", JointKind::kPlate},
                                                      {"joint.beam", JointKind::kBeam},
                                                      {"joint.other", JointKind::kOther},
                                                      {"joint.frame", JointKind::kFrame},
                                                      {"joint.coat", JointKind::kCoat}};

// A dead load of constant direction at a point of a block.
struct PointLoad {
  BlockId block = 0;
  double arm_x = 0, arm_y = 0;  // from the centroid, in the block's own axes [m]
  double fx = 0, fy = 0;        // [N]
  double arm_z = 0, fz = 0;     // in space
};

// A point of a block whose motion is recorded over time ([[history]]).
struct WatchedPoint {
  std::string name;
  BlockId block = 0;
  Vec3 arm;           // from the centroid, in the block's own axes [m]
  double height = 0;  // above the lowest point of the wall [m]
};

// Viscous elements at closed contacts of a wall under a record (docs/theory/dynamics.md).
//
//           +----/\/\/\----+                 the contact itself: k
//           |              |
//     a  ---+----[ c ]-----+---  b           a dashpot beside it: c
//           |              |
//           +-/\/\/--[ ]---+                 a Maxwell element: spring share k, relaxation time
struct Dashpots {
  // Of joints, one row each: stress per rate of opening or slip [Pa s/m]. Empty in a stage without dashpots and elements.
  std::vector<double> normal, shear;
  double rate = 0;  // bound on the highest eigenvalue of M^-1 C [1/s]
  // Of free contacts, with the current stiffness k [N/m] and mass m between the bodies:
  // c = proportional k + 2 impact sqrt(k m).
  double proportional = 0;  // [s]
  double impact = 0;        // fraction of critical damping [-]
  // Of joints and free contacts.
  double spring_share = 0;  // of the contact's stiffness; 0: no Maxwell elements [-]
  double relaxation = 0;    // of a Maxwell element [s]
  [[nodiscard]] bool any() const { return !normal.empty() || spring_share > 0; }
};

// A stage ready to run, in block numbers and SI units.
struct Stage {
  StageSpec spec;  // with all defaults filled in
  std::vector<PointLoad> loads;
  std::vector<BlockId> driven;
  // Force on each driven block over their mean force; all 1 without a pattern. The push prescribes the
  // displacement of the driven blocks, averaged with these weights.
  std::vector<double> driven_share;
  BlockId control = -1;             // its displacement controls the push; -1: the driven mean's
  double drive_x = 0, drive_y = 0;  // unit vector of the push
  double drive_z = 0;               // in space
  double load_height = 0;           // height of the driven blocks' mean centroid [m]
  // Distance of the line of the push from the centroid of the only driven block, the head, in the axes of the head [m];
  // unset: the line passes through the centroids (docs/theory/integration.md, "The point of contraflexure").
  double drive_arm = kUnset;
  // A shake: components of the motion of the base; along the drive, the motion of driven blocks or supports
  // against it; inertia that no weight represents (floors, plates).
  std::vector<GroundMotion> base;
  GroundMotion driven_motion;
  std::vector<PointLoad> carried;  // its fx holds the mass [kg]
  Dashpots dashpots;

  [[nodiscard]] Vec3 drive() const { return {drive_x, drive_y, drive_z}; }
  // The stage as a push; null for another kind.
  [[nodiscard]] const PushStage* push() const { return std::get_if<PushStage>(&spec.action); }
  // Displacements of a cyclic push, in turn [m]; none for any other stage.
  [[nodiscard]] std::span<const double> targets() const {
    return push() != nullptr ? std::span<const double>(push()->targets) : std::span<const double>();
  }
  [[nodiscard]] bool has_pattern() const {
    return push() != nullptr && push()->pattern != Pattern::kNone;
  }
  // Whether each driven block moves the same way; else their mean is prescribed, and they share the force.
  [[nodiscard]] bool moves_each() const {
    return push() != nullptr ? push()->as == Manner::kEach : spec.kind() == StageKind::kShake;
  }
};

// Names and positions for pictures, failure modes and reports; no pass of the step reads them.
struct Anatomy {
  std::vector<std::string> block_id;
  std::vector<BlockRole> block_role;
  std::vector<int> block_course;             // -1 where a course has no meaning
  std::vector<double> block_thickness;       // [m]
  std::vector<int> outline_begin;            // (n_block + 1) into outline_x, outline_y
  std::vector<double> outline_x, outline_y;  // in the wall's axes at the start [m]
  std::vector<JointKind> joint_kind;
  std::vector<double> pier_x0, pier_x1, pier_height;  // [m], left to right
  std::vector<std::string> storey_name;      // from the ground up; empty without [[storey]]
  std::vector<double> storey_top;            // [m]
  std::vector<double> support_x, support_y;  // outlines of fixed blocks
  std::vector<int> support_begin;
  double length = 0, height = 0, thickness = 0;  // of the masonry [m]
  double half_unit = 0, course_height = 0;       // [m], 0 for a blocks file
  int courses = 0;
  int masonry_blocks_before_lintels = 0;
  int lost_joints = 0;
  std::vector<DrawnField> fields;  // fields of the wall
  std::vector<Message> notes;      // what the builder adjusted or omitted
};

// One deformable block: columns x rows zones, counted from the lower left, or triangles.
struct SolidBody {
  std::string id;
  BlockRole role = BlockRole::kMasonry;
  double x0 = 0, y0 = 0, x1 = 0, y1 = 0;  // bounds [m]
  int columns = 0, rows = 0;              // 0 for triangles
  int first_node = 0, n_node = 0, first_zone = 0, n_zone = 0;
  std::vector<std::int32_t> rim;  // nodes of its outline, anticlockwise, each listed once
  double tension_limit = kUnset, compression_limit = kUnset;  // [Pa]
  [[nodiscard]] int node(int i, int j) const { return first_node + j * (columns + 1) + i; }
  [[nodiscard]] int zone(int i, int j) const { return first_zone + j * columns + i; }
};

// Deformable blocks in the plane: nodes, the zones between them, and their contacts with rigid blocks.
//
//        q           p-q  an edge of a zone; a contact is the overlap of one edge with one face of a
//   a    |           rigid block a (or the ground: block n_block, at rest). Its two points are the ends
//   =====o 1         of the overlap, half the area each. Their positions on the edge are linear:
//        |           point k is (1 - share_k) p + share_k q.
//   =====o 0         n from a to the zone, on the left of t.
//        p
struct Solids {
  int n_node = 0, n_zone = 0, n_contact = 0;

  // read by the pass over zones (one row a zone)
  std::array<std::vector<std::int32_t>, 4> corner;  // nodes, anticlockwise
  std::vector<std::int32_t> zone_shape;             // into shapes; equal for all of a body
  std::vector<ZoneShape> shapes;

  // read by the pass over zone contacts (one row a contact, sorted by material)
  std::vector<BlockId> contact_block;                        // n_block on the ground
  std::vector<std::int32_t> contact_p, contact_q;            // nodes of the edge
  std::vector<double> share_0, share_1;                      // [-]
  std::vector<double> arm_0_x, arm_0_y, arm_1_x, arm_1_y;    // points seen from a's centroid [m]
  std::vector<double> contact_tangent_x, contact_tangent_y;  // t
  std::vector<double> contact_area;                          // [m^2]
  std::vector<std::int32_t> contact_material;                // into Model::materials

  // read by the pass over nodes (one row a node). An entry is the index of the force at a zone's corner or at
  // a contact's end, in the numbering of join_nodes (src/solids/mesh.cpp).
  std::vector<std::int32_t> zone_begin, zone_entry;        // CSR
  std::vector<std::int32_t> contact_begin, contact_entry;  // CSR
  std::vector<double> node_x, node_y;                      // at the start [m]
  std::vector<double> node_mass, node_gravity_mass;        // inertia; mass for the weight [kg]
  std::vector<double> node_free_x, node_free_y;            // 1, or 0 where the node is held

  std::vector<SolidBody> bodies;
};

// A bar between two points: of two blocks, or of the ground (a) and a block (b).
// An anchor of a frame is two links: kAnchor resists pull-out, kDowel shear.
enum class LinkKind { kTie, kDiaphragm, kSpring, kAnchor, kDowel, kWedge };
inline constexpr Word<LinkKind> kLinkKindWords[] = {
    {"tie", LinkKind::kTie},       {"diaphragm", LinkKind::kDiaphragm},
    {"spring", LinkKind::kSpring}, {"anchor", LinkKind::kAnchor},
    {"dowel", LinkKind::kDowel},   {"wedge", LinkKind::kWedge}};

// Ties, diaphragms and springs (docs/theory/links.md), anchors and wedges of frames (docs/theory/frames.md); one row
// a link.
struct Links {
  int n = 0;
  std::vector<BlockId> a, b;  // a is kGroundBlock at an anchor
  std::vector<double> arm_a_x, arm_a_y, arm_b_x,
      arm_b_y;                           // ends from the centroids [m]; 0 on the ground
  std::vector<double> arm_a_z, arm_b_z;  // the same; 0 in the plane
  std::vector<double> span_x, span_y,
      span_z;                       // from a to b at the start [m]; of a spring a unit vector
  std::vector<double> follows;      // 1: its line turns with its ends; 0: constant direction
  std::vector<double> stiffness;    // [N/m]
  std::vector<double> tension;      // yield force in tension, 0: hangs slack [N]
  std::vector<double> compression;  // yield force in compression, positive [N]
  std::vector<double> prestress;    // force that shortens the link during stage set_by [N]
  std::vector<double> jack;         // force of a wedge, applied by the stage that installs it [N]
  std::vector<std::string> name;    // unique
  std::vector<LinkKind> kind;
  int set_by = -1;  // stage whose ramp applies prestress; -1: none is prestressed
};

// One straight part of a frame, from corner to corner.
struct FrameMember {
  int frame = 0;                            // into Frames::name
  Message words;                            // "left column"
  double length = 0;                        // [m]
  double x0 = 0, y0 = 0;                    // its beginning in the plane of the frame, as built [m]
  double direction_x = 0, direction_y = 0;  // unit vector there
  // of the section, all its pieces together
  double area = 0, shear_area = 0;                // [m^2]
  double second_moment = 0, plastic_modulus = 0;  // [m^4], [m^3]
  double youngs_modulus = 0, yield_strength = 0;  // [Pa]
  double fibre = 0;                               // I / Wpl: of the outer fibres from the axis [m]
};

// Frames as chains of rigid segments (docs/theory/frames.md); one row a link, a section of three fibres between two
// segments, or between the ground (a) and a foot.
struct Frames {
  int n = 0;
  std::vector<BlockId> a, b;  // a is kGroundBlock at a foot
  std::vector<double> arm_a_x, arm_a_y, arm_b_x,
      arm_b_y;                                            // section from the centroids [m]
  std::vector<double> axis_x, axis_y;                     // along the member, from a to b
  std::vector<double> rest_x, rest_y;                     // initial offset of b from a (gaps) [m]
  std::vector<double> outer_stiffness, middle_stiffness;  // of one outer fibre, of the middle [N/m]
  std::vector<double> shear_stiffness;                    // [N/m]
  std::vector<double> fibre;                              // of the outer ones from the axis [m]
  std::vector<double> outer_yield, middle_yield;          // [N]

  // in space in addition: third components; unit vector to the left of the member; normal to the frame's plane
  std::vector<double> arm_a_z, arm_b_z, axis_z, rest_z;
  std::vector<Vec3> left;
  std::vector<double> aside_stiffness;                  // shear stiffness normal to the plane [N/m]
  std::vector<double> lean_stiffness, twist_stiffness;  // about `left`; about the axis [N m]

  // read by results only
  std::vector<std::int32_t> member;  // into members
  std::vector<double> place;         // distance along its member [m]
  std::vector<double> length;        // length of member that the section represents [m]
  std::vector<FrameMember> members;
  std::vector<std::string> name;  // of frames, unique

  // Blocks that start away from their drawn outlines, by the gap to the masonry.
  std::vector<BlockId> moved;
  std::vector<double> moved_x, moved_y, moved_z;  // [m]; z in space alone
};

// Which blocks stand in which stage, where stages cut openings and insert parts (docs/theory/cutting.md). Block i stands in
// the stages from[i] to until[i] - 1, a joint or section as long as both its sides. Empty: all stand in all stages.
struct Standing {
  std::vector<std::int32_t> from, until;  // (n_block)
  [[nodiscard]] bool any() const { return !from.empty(); }
  [[nodiscard]] bool holds(BlockId block, int stage) const {
    if (from.empty() || block < 0) return true;
    const std::size_t i = block;
    return i >= from.size() || (from[i] <= stage && stage < until[i]);
  }
  [[nodiscard]] bool joins(BlockId a, BlockId b, int stage) const {
    return holds(a, stage) && holds(b, stage);
  }
  // Whether this stage installs what connects a and b.
  [[nodiscard]] bool begins(BlockId a, BlockId b, int stage) const {
    return stage > 0 && joins(a, b, stage) && !joins(a, b, stage - 1);
  }
};

// Layers of fibres on the masonry (docs/theory/layers.md): strands, each a chain of nodes; one row a node in the
// order of the strands. A node is bonded to its block and may slip; fibres connect it with the next node.
//
//     o===o===o===|=o===o===o     fibres; across a joint the two nodes are on different blocks
//     '   '   '   | '   '   '     bond, over the length of each node
//    -- block ----|--- block ---
struct Layers {
  int n = 0;
  std::vector<BlockId> a,
      b;  // blocks of the node and of the next one; equal at a strand's end
  std::vector<double> arm_a_x, arm_a_y, arm_b_x,
      arm_b_y;                            // both nodes from the centroids [m]
  std::vector<double> span_x, span_y;     // from the node to the next at the start [m]
  std::vector<double> stiffness;          // of the fibres between them [N/m]; 0 after the last
  std::vector<double> strength;           // tensile strength of the fibres [N]
  std::vector<double> bond_energy;        // energy that detaches the node [J]
  std::vector<double> bond_rate;          // B [1/m]
  std::vector<std::int32_t> crossing;     // into cross_a where the fibres cross a joint, else -1
  std::vector<BlockId> cross_a, cross_b;  // (n_crossing)

  // read by results only
  std::vector<std::int32_t> layer, strand;  // into name; number in its layer, from 0
  std::vector<double> length;               // bonded length [m]
  std::vector<double> x, y;                 // of the node at the start [m]
  std::vector<std::string> name;            // of layers, unique
};

// One deformable block in space: zones along its directions a, b, c; b is the one nearest to y. Its corner i
// lies at the same ends of a, b and c as corner i of a zone.
struct SpaceSolidBody {
  BodySpec body;
  Vec3 centroid;  // at the start [m]
  BlockRole role = BlockRole::kMasonry;
  std::array<int, 3> count = {1, 1, 1};  // zones along a, b, c
  int first_node = 0, n_node = 0, first_zone = 0, n_zone = 0;
  double tension_limit = kUnset, compression_limit = kUnset;  // [Pa]
  [[nodiscard]] int node(int i, int j, int k) const {
    return first_node + (k * (count[1] + 1) + j) * (count[0] + 1) + i;
  }
  [[nodiscard]] int zone(int i, int j, int k) const {
    return first_zone + (k * count[1] + j) * count[0] + i;
  }
};

// Deformable blocks in space (docs/theory/zones.md, "Zones in space"): nodes, the zones between them, and
// their contacts with rigid blocks and supports.
//
// A contact is the overlap of one side of a zone, with nodes p0 to p3, and one face of a rigid block a. Its points
// are centre + r1 t1 + r2 t2 on the face, with n from a to the zone; on the side they are the sum of share_k p_k.
// Their r1, r2, shares of the area and history follow those of the joints (Space, State).
struct SpaceSolids {
  int n_node = 0, n_zone = 0, n_contact = 0;

  // read by the pass over zones (one row a zone)
  std::vector<std::int32_t> corner;      // nodes, eight for each zone
  std::vector<std::int32_t> zone_shape;  // into shapes
  std::vector<HexahedronShape> shapes;

  // read by the pass over zone contacts (one row a contact)
  std::vector<BlockId> contact_block;      // a block, or support n_block + i
  std::vector<std::int32_t> contact_body;  // into bodies
  std::vector<std::int32_t> contact_node;  // four for each contact
  std::vector<std::int32_t>
      point_begin;                 // CSR (n_contact + 1) into the points, from Model::n_point() on
  std::vector<double> node_share;  // four for each point
  std::vector<Vec3> contact_arm;   // centre from a's centroid [m]
  std::vector<Vec3> contact_tangent, contact_normal;  // t1, n
  std::vector<double> contact_area;                   // [m^2]
  std::vector<std::int32_t> contact_material;         // into Model::materials

  // read by the pass over nodes (one row a node)
  std::vector<std::int32_t> zone_begin, zone_entry;        // CSR; entry: 8 zone + corner
  std::vector<std::int32_t> contact_begin, contact_entry;  // the same; 4 contact + k
  std::vector<double> node_mass, node_gravity_mass;        // inertia; mass for the weight [kg]

  std::vector<Vec3> node;                       // at the start [m]
  std::vector<std::vector<Vec3>> contact_face;  // outline of each contact at the start
  std::vector<SpaceSolidBody> bodies;
};

// Arrays of walls in space that have no counterpart in the plane (docs/theory/space.md). Empty in a plane
// wall; in space the plane's arrays of arms, faces and points are empty.
//
//        n                t1, t2 and n = t1 x t2 are right-handed; n points from a to b.
//        |   t2           Block b of a joint is free; a is free or support a - n_block.
//     +--|--/------+      Point k of joint j is centre + r1_k t1 + r2_k t2 and carries
//    /   | /   .  /       the area share_k * area_j.
//   /    o-----> t1
//  +------------+
struct Space {
  int n_support = 0;

  // read by the pass over joint faces (one row a joint, sorted by law, support and number of points)
  std::vector<Vec3> arm_a, arm_b;          // face centre seen from the centroids [m]
  std::vector<Vec3> tangent, normal;       // t1, n at the start
  std::vector<std::int32_t> point_begin;   // CSR (n_joint + 1) into the next three
  std::vector<double> point_r1, point_r2;  // [m]
  std::vector<double> point_share;         // share of the face's area; sums to 1 on each face

  // read by the pass over blocks (one row a block)
  std::vector<Vec3> axis_1, axis_2, axis_3;  // principal axes at the start, right-handed
  std::vector<Vec3> inertia;                 // about them [kg m^2]
  std::vector<Vec3> centroid;                // at the start, blocks then supports [m]
  // names and shapes for pictures and reports; blocks first, then supports
  std::vector<BodySpec> body;
  std::vector<std::vector<Vec3>>
      face;  // outline of each joint at the start, anticlockwise about n [m]

  SpaceSolids solids;  // deformable blocks; empty in a wall of rigid ones
};

struct Model {
  int n_block = 0, n_joint = 0, n_pair = 0, n_face_point = 2;

  // read by forces (one row a joint)
  std::vector<BlockId> joint_a, joint_b;       // a is kGroundBlock on the ground
  std::vector<std::int32_t> joint_material;    // into materials
  std::vector<double> arm_a_x, arm_a_y;        // [m] (n_joint)
  std::vector<double> arm_b_x, arm_b_y;        // [m] (n_joint)
  std::vector<double> half_x, half_y;          // e [m] (n_joint); shortened where a joint stands
                                               // for a continuous section (lintel chain)
  std::vector<double> tangent_x, tangent_y;    // t (n_joint)
  std::vector<double> area;                    // [m^2] (n_joint)
  std::vector<double> point_xi, point_weight;  // (n_face_point), weights sum to 1

  // read by gather and integrate (one row a block)
  std::vector<std::int32_t> block_begin;       // CSR (n_block + 1) into block_entry
  std::vector<std::int32_t> block_entry;       // 2 joint + side (0: block is a, 1: block is b);
                                               // entries of side a come first
  std::vector<double> mass;                    // inertia [kg] (n_block)
  std::vector<double> gravity_mass;            // mass for the weight [kg] (n_block); 0 for plates,
                                               // whose weight is part of their load
  std::vector<double> inertia;                 // [kg m^2] (n_block)
  std::vector<double> turn_freedom;            // 1, or 0 where rotation is blocked (n_block)
  std::vector<double> centroid_x, centroid_y;  // at the start [m] (n_block)

  Solids solids;      // deformable blocks; empty in a wall of rigid ones
  Links links;        // ties, diaphragms and springs
  Frames frames;      // of steel or concrete
  Layers layers;      // of fibres on the masonry
  Standing standing;  // where stages cut openings
  Space space;        // walls in space
  FreeShapes free;    // shapes for free contacts; empty without them

  // read once per run
  double omega_max = 0;        // bound on the highest circular frequency [1/s]
  BlockId stiffest_block = 0;  // block at which the bound is reached
  double weight = 0;           // of all moving blocks [N]
  std::vector<JointMaterial> materials;
  std::vector<std::string> material_names;
  std::vector<std::int32_t> stated_material;  // of each material (stated()); empty without fields
  std::vector<Stage> stages;
  std::vector<WatchedPoint> watched;  // the first is the control point of a shake
  SolveSpec solve;
  OutputSpec output;
  Anatomy anatomy;
  std::uint64_t spec_hash = 0;
  std::uint64_t topology = 0;  // equal: walls can be stepped side by side (model/fields.h)

  // The stated material from which a field drew this one; the material itself where no field acts on it.
  [[nodiscard]] std::int32_t stated(std::int32_t material) const {
    return stated_material.empty() ? material : stated_material[material];
  }
  [[nodiscard]] bool in_space() const { return !space.point_begin.empty(); }
  [[nodiscard]] int n_point() const {
    return in_space() ? space.point_begin.back() : n_joint * n_face_point;
  }
  // Points with a history: those of joints, then those of zone contacts.
  [[nodiscard]] int n_history() const {
    const auto& in_space = space.solids.point_begin;
    return in_space.empty() ? n_point() + 2 * solids.n_contact : in_space.back();
  }
};

// What stages remember from step to step. `time` and `first_step` start anew with each; a push resets what it uses.
struct StageProgress {
  double time = 0;                // since the stage's start [s]
  std::int64_t first_step = 0;    // number of the step before the stage's first
  double body_factor = 0;         // lambda of the body force, or the angle of a tilt
  double load_factor = 0;         // largest load factor in balance
  double balance = 1;             // unbalance ratio at the last sample of the servo
  double last_growth = 0;         // stage time when a load factor last grew [s]
  double moved_then = 0;          // displacement of the furthest block at that time [m]
  double drive_displacement = 0;  // prescribed displacement along the push [m]
  double travelled = 0;           // length of the driven path so far [m]
  double control_start = 0;       // position of a push's control block at its start [m]
  double control_moved = 0;       // its displacement since then [m]
  double control_furthest = 0;    // the largest value of that [m]
  double turn_time = 0;           // stage time of the last start or turn of a push [s]
  double pace = 0;                // of a push: 0 is `velocity`, 1 is `fast_velocity`
  int target = 0;                 // index of the next target, in a cyclic stage
};

// Work and dissipation since the start of the run [J]; an EnergyLedger adds what is stored.
struct AccumulatedEnergy {
  double work_loads = 0, work_drive = 0, work_damping = 0;
  double dissipated_friction = 0, dissipated_fracture = 0, dissipated_crushing = 0;
  double lost_in_hand_over = 0;  // removed by hand-overs of contacts
};

// All that a restart needs: a run that is saved and restored gives the same bits. A RunRecord (recording.h)
// holds what its curve needs besides.
struct State {
  // written by integrate (n_block)
  std::vector<double> ux, uy, theta;  // [m], [m], [rad]
  std::vector<double> vx, vy, omega;  // at the half step [m/s], [rad/s]

  // written by the pass over nodes (n_node)
  std::vector<double> node_ux, node_uy;  // [m]
  std::vector<double> node_vx, node_vy;  // at the half step [m/s]

  // written by forces, committed history of the joint law (n_history)
  std::vector<double> kappa;         // largest opening reached [m]
  std::vector<double> crush;         // crushing shortening -w_p [m]
  std::vector<double> plastic_slip;  // signed plastic slip [m]
  std::vector<double> slip;          // accumulated |plastic slip| s [m]
  std::vector<double> shear_damage;  // ds [-]
  std::vector<double> tension_set;   // w_t [m], elastic unloading only
  std::vector<double> crush_path;    // q [m]; empty where no law of the wall has a cap

  // written by the pass over dashpots: stresses of Maxwell elements, compression negative; empty where no stage has any
  // (n_history); maxwell_shear_2, along t2, in space only
  std::vector<double> maxwell_normal, maxwell_shear, maxwell_shear_2;  // [Pa]

  // in space only: third displacement and velocity, rotation since the start as a unit quaternion, angular
  // momentum about the centroid, in the axes of the wall (n_block)
  std::vector<double> uz, vz;          // [m], [m/s]
  std::vector<double> qw, qx, qy, qz;  // [-]
  std::vector<double> lx, ly, lz;      // at the half step [kg m^2/s]
  std::vector<double> plastic_slip_2;  // along t2; plastic_slip is along t1 [m] (n_history)
  std::vector<double> support_x, support_y,
      support_z;                         // displacement of driven supports [m] (n_support)
  std::vector<double> node_uz, node_vz;  // of nodes of zones [m], [m/s] (n_node)

  // written by the pass over links (n_link)
  std::vector<double> link_force;    // tension + [N]
  std::vector<double> link_plastic;  // plastic elongation [m]
  std::vector<double> link_drawn;    // shortening by prestress so far [m]

  // written by the pass over frames (n_frame_link): plastic elongation of a fibre, to the left of the member's axis, on
  // it, to the right of it [m]
  std::vector<double> frame_left, frame_middle, frame_right;
  // relative displacement along and across, and rotation, of each section when a stage installed it without force
  // (n_frame_link, or empty) [m], [m], [rad]
  std::vector<double> frame_along, frame_across, frame_turn;
  // in space in addition: the offset normal to the frame's plane, about `left`, about the axis
  std::vector<double> frame_aside, frame_lean, frame_twist;

  // force and moment on neighbours of blocks that a stage cut out; they fade (n_block, or empty) [N], [N m]
  std::vector<double> release_x, release_y, release_m;
  // in space the other components; release_m is about z
  std::vector<double> release_z, release_mx, release_my;

  // written by the pass over layers (n_layer_node)
  std::vector<double> layer_slip;     // of a node on its block, along the strand [m]
  std::vector<double> layer_reached;  // largest |slip| so far [m]
  std::vector<double> layer_broken;   // 1: the fibres to the next node are broken

  // written by the pass over free contacts, sorted by bodies, parts and features; empty without free contacts
  std::vector<FreeContact> free_contacts;
  std::vector<HandOver> hand_overs;
  std::vector<double> handed_over;  // 1: released joint, replaced by a free contact (n_joint)

  // place in the run
  int stage = 0;          // index into Model::stages
  std::int64_t step = 0;  // since the start of the run
  double time = 0;        // [s]
  StageProgress progress;

  // loads in force, written by stages
  double gravity_x = 0, gravity_y = 0;  // current acceleration [m/s^2]
  double gravity_z = 0;                 // in space
  std::vector<double> load_scale;       // current factor of each stage's loads (n_stage)

  AccumulatedEnergy energy;
};

// Compiles the model; throws InputError with every fault found.
[[nodiscard]] Model compile(const ModelSpec& spec);
[[nodiscard]] State initial_state(const Model& model);  // at rest; frames displaced by their gaps
// 64-bit hash of all bits of the mechanical state (blocks and joints), as 16 hex digits.
[[nodiscard]] std::string state_hash(const State& state);

}  // namespace wythe
