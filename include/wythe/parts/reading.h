// What a state says, block by block, joint by joint and point by point: where each is now, how far it
// moved, what it carries and what is left of it. Failure modes, features, files and pictures read a wall
// here and nowhere else, so none of them depends on the coordinates in which it is computed.
//
//   Model + State ──► read_wall() ──► blocks, joints, points
//
// Places, displacements and directions are in the wall's axes (vector.h). Deformable blocks follow the
// rigid ones: n_block + i is SolidBody i. Their contacts are joints too and follow the others, here and in
// the history: n_joint + c is contact c. In space deformable blocks follow the supports, and read_wall() leaves
// them out: n_block + n_support + i is SpaceSolidBody i.
#pragma once

#include <array>
#include <span>
#include <utility>
#include <vector>

#include "wythe/parts/model.h"
#include "wythe/parts/vector.h"

namespace wythe {

// --- what never changes ----------------------------------------------------------------------------

// Rows begin to end - 1, of State's history and of WallReading::points.
struct PointRange {
  PointId begin = 0, end = 0;
  [[nodiscard]] int size() const { return end - begin; }
};
// How points are numbered is written here alone.
[[nodiscard]] PointRange points_of(const Model& model, JointId joint);

[[nodiscard]] int dimension_of(const Model& model);  // of places: 2 in the wall's plane, 3 in space
[[nodiscard]] int joint_count(const Model& model);   // with the contacts of deformable blocks
[[nodiscard]] int block_count(const Model& model);   // with deformable blocks

//        b         along   the face; half: from its centre to its end along it
//   ----------->           normal  on the left of it, from a to b
//        a
struct JointShape {
  JointId id = 0;
  JointKind kind = JointKind::kOther;
  BlockId a = kGroundBlock, b = 0;
  std::int32_t material = 0;  // into Model::materials
  double area = 0;            // [m^2]
  Vec3 centre;                // of the face at the start [m]
  Vec3 half;                  // [m]; shortened where a joint stands for a continuous section
  Vec3 half_2;                // in space, the other way in the face [m]; 0 in the plane
  Vec3 along, normal;         // unit vectors at the start
  Vec3 arm_a, arm_b;  // centre seen from the centroids of a and b [m]; 0 of the ground and of
                      // deformable blocks
};
[[nodiscard]] JointShape joint_shape(const Model& model, JointId joint);

[[nodiscard]] Vec3 centroid_of(const Model& model,
                               BlockId block);  // of a rigid one at the start [m]
// Corners of a block at the start, anticlockwise [m]; none in space.
[[nodiscard]] std::vector<Vec3> outline_of(const Model& model, BlockId block);
// The same of any wall; in space the corners of each convex part, in no order.
[[nodiscard]] std::vector<Vec3> corners_of(const Model& model, BlockId block);

// --- where it is now -------------------------------------------------------------------------------

// A deformable block moves with its first node and does not turn.
struct BlockReading {
  BlockId id = 0;
  BlockRole role = BlockRole::kMasonry;
  Vec3 start;  // its centroid at the start; of a deformable block the middle of its bounds [m]
  Vec3 moved;  // how far that went [m]
  Rotation turned;
};
[[nodiscard]] BlockReading read_block(const Model& model, const State& state, BlockId block);

// `scale` magnifies displacements and rotations; at 1 places are where they really are.
[[nodiscard]] std::vector<Vec3> outline_now(const Model& model, const State& state, BlockId block,
                                            double scale = 1);
// Both ends of a joint, half way between its two faces [m]; a ground face stays where it was. Of a
// contact those of the deformable block's edge.
[[nodiscard]] std::array<Vec3, 2> ends_now(const Model& model, const State& state, JointId joint,
                                           double scale = 1);
[[nodiscard]] Vec3 node_now(const Model& model, const State& state, int node, double scale = 1);
[[nodiscard]] Vec3 node_moved(const State& state, int node);  // [m]
[[nodiscard]] std::vector<Vec3> corners_now(const Model& model, const State& state, BlockId block);
// How far the point of a rigid block went that started at `arm` from its centroid [m].
[[nodiscard]] Vec3 way_of(const Model& model, const State& state, BlockId block, Vec3 arm);
[[nodiscard]] double tilt_of(const Model& model, const State& state, BlockId block);  // [rad]

// Convex parts of a block of a wall in space; n_block + i is support i.
[[nodiscard]] std::vector<Polyhedron> solid_now(const Model& model, const State& state,
                                                BlockId block, double scale = 1);
// The joint's polygon, half way between its two faces, anticlockwise about its normal; in the plane its ends.
[[nodiscard]] std::vector<Vec3> face_now(const Model& model, const State& state, JointId joint,
                                         double scale = 1);

// --- what it does and carries ----------------------------------------------------------------------

// A point of a joint: the law's answer at rest on the present state, with the step's arithmetic; and
// what it remembers.
struct PointReading {
  double share = 0;                            // of its joint's area [-]
  double place = 0;                            // on the face, from -1 to 1 along it [-]
  Vec3 where;                                  // now, half way between the two faces [m]
  double opening = 0, slip = 0;                // jump along normal and face, b against a [m]
  double opened = 0;                           // the largest effective opening so far [m]
  double slid = 0;                             // plastic part of the slip [m]
  double crushed = 0;                          // shortening by crushing [m]
  double normal_stress = 0, shear_stress = 0;  // tension + [Pa]
  double damage_tension = 0, damage_shear = 0, damage = 0, crushing = 0;  // [-]
  // in space, where slip and shear_stress are their lengths
  Vec3 slip_vector;   // [m]
  Vec3 shear_vector;  // stress on a [Pa]
};
// Of all joints, in the order of points_of().
[[nodiscard]] std::vector<PointReading> read_points(const Model& model, const State& state);

struct JointReading {
  JointShape shape;
  PointRange points;
  Vec3 where;                                   // its centre now [m]
  double opening = 0;                           // at its wider end; negative where it is closed [m]
  double slip = 0;                              // of its points that of largest magnitude [m]
  double damage_tension = 0, damage_shear = 0;  // largest of its points [-]
  double damage = 0, crushing = 0;              // largest of its points [-]
  double normal_stress = 0, shear_stress = 0;   // means over the area, tension + [Pa]
  double compression = 0, shear = 0;            // forces: normal, pressed +; along the face [N]
  double moment = 0;                            // of the compression about the centre [N m]
  double eccentricity = 0;                      // of the compression over half the face, -1 to 1; 0
      // where nothing presses; in space the larger of both
      // directions of the face
  // a free contact has its place, or it does not stand in this stage: it carries nothing, and its sides may be far apart
  bool handed_over = false;
  // in space, where shear and moment are their lengths
  Vec3 slip_vector;    // mean over the area [m]
  Vec3 shear_vector;   // force on a, along the face [N]
  Vec3 moment_vector;  // on a about the centre; its part along the normal is the torsion [N m]
};

struct WallReading {
  std::vector<BlockReading> blocks;
  std::vector<JointReading> joints;
  std::vector<PointReading> points;
  [[nodiscard]] std::span<const PointReading> points_of(const JointReading& joint) const {
    return std::span(points).subspan(static_cast<std::size_t>(joint.points.begin),
                                     static_cast<std::size_t>(joint.points.size()));
  }
};
[[nodiscard]] WallReading read_wall(const Model& model, const State& state);
// The force of a on b, in the wall's axes, as the face lies now: the ground's has not turned, the edge of a
// deformable block lies as its neighbour [N].
[[nodiscard]] Vec3 force_of(const Model& model, const JointReading& joint, const WallReading& wall);

// Whether a joint is pressed and its faces overlap by less than half; `points` of the whole wall.
[[nodiscard]] bool has_slid_off(const Model& model, const std::vector<PointReading>& points,
                                JointId joint);

// A link at rest on the present state, with the step's arithmetic.
struct LinkReading {
  double stiffness = 0;      // [N/m]
  double force = 0;          // tension + [N]
  double elongation = 0;     // from its length at the start, prestress apart [m]
  double plastic = 0;        // part of it that stays [m]
  std::array<Vec3, 2> ends;  // now [m]; of a spring both where it holds its block
};
// Of all links of the model, in their order.
[[nodiscard]] std::vector<LinkReading> read_links(const Model& model, const State& state);

// The section of a frame at one of its links, at rest on the present state, with the step's arithmetic.
struct FrameReading {
  double normal = 0;   // tension + [N]
  double shear = 0;    // of what comes on the way, to the left + [N]
  double moment = 0;   // that stretches the right of the way + [N m]
  double use = 0;      // of what the section bears: 1 where it is plastic through (frames.md, 20.8)
  double plastic = 0;  // largest elongation of a fibre that stays, without sign [m]
  double stored = 0;   // elastic energy [J]
  Vec3 where;          // now [m]
};
// Of all links of frames, in their order.
[[nodiscard]] std::vector<FrameReading> read_frames(const Model& model, const State& state);
// What N, V and M use of a member's section (frames.md, 20.8).
[[nodiscard]] double section_use(const FrameMember& member, double normal, double shear,
                                 double moment);

// A node of a layer and the fibres from it to the next one, with the step's arithmetic.
struct LayerReading {
  double force = 0;  // of the fibres [N]
  double use = 0;    // over their strength; 1 where they are broken [-]
  double slip = 0;   // on the block, along the strand [m]
  double spent = 0;  // share of the bond's energy up to the largest slip; detached from 0.95 on [-]
  double stored = 0;  // elastic energy of fibres and bond [J]
  bool broken = false;
};
// Of all nodes of layers, in their order.
[[nodiscard]] std::vector<LayerReading> read_layers(const Model& model, const State& state);

// A zone of a deformable block: its mean stresses in the wall's axes, and where its corners are now.
struct ZoneReading {
  double sigma_x = 0, sigma_y = 0, tau = 0;  // [Pa]
  int corners = 4;                           // 3: a triangle, its last two corners are one
  std::array<Vec3, 4> corner;                // [m]
  Vec3 moved;                                // mean of its corners [m]
};
[[nodiscard]] std::vector<ZoneReading> read_zones(const Model& model, const State& state);
// The greater and the smaller principal stress in the plane, tension positive [Pa].
[[nodiscard]] std::pair<double, double> principal_stresses(const ZoneReading& zone);

// A zone of a deformable block in space: the same.
struct SpaceZoneReading {
  std::array<double, 6> stress{};     // x, y, z, xy, yz, zx in the wall's axes, tension + [Pa]
  std::array<double, 3> principal{};  // the greatest first [Pa]
  std::array<Vec3, 8> corner;         // [m], in the order of HexahedronShape
  Vec3 middle;                        // mean of its corners at the start [m]
  Vec3 moved;                         // how far that went [m]
  Rotation turned;                    // of its mean deformation
};
[[nodiscard]] std::vector<SpaceZoneReading> read_space_zones(const Model& model,
                                                             const State& state);

}  // namespace wythe
