// Values of a state for each block, joint and contact point: position, displacement, forces and remaining
// strength. Failure modes, features, files and pictures read a wall only through this header,
// so none of them depends on the coordinates of the computation.
//
//   Model + State ──► read_wall() ──► blocks, joints, points
//
// Places, displacements and directions are in the axes of the wall (vector.h). Deformable blocks follow the
// rigid ones: n_block + i is SolidBody i. Their contacts follow the other joints, here and in
// the history: n_joint + c is contact c. In space deformable blocks follow the supports, n_block + n_support + i is
// SpaceSolidBody i, and read_wall() leaves them out.
#pragma once

#include <array>
#include <span>
#include <utility>
#include <vector>

#include "wythe/parts/model.h"
#include "wythe/parts/vector.h"

namespace wythe {

// --- constant data ---------------------------------------------------------------------------------

// Rows begin to end - 1 of State's history and of WallReading::points.
struct PointRange {
  PointId begin = 0, end = 0;
  [[nodiscard]] int size() const { return end - begin; }
};
// Points of a joint. Only this function knows how points are numbered.
[[nodiscard]] PointRange points_of(const Model& model, JointId joint);

[[nodiscard]] int dimension_of(const Model& model);  // of places: 2 in the wall's plane, 3 in space
[[nodiscard]] int joint_count(const Model& model);   // with the contacts of deformable blocks
[[nodiscard]] int block_count(const Model& model);   // with deformable blocks

//        b         along   unit vector of the face; half: from its centre to its end along it
//   ----------->           normal  to the left of it, from a to b
//        a
struct JointShape {
  JointId id = 0;
  JointKind kind = JointKind::kOther;
  BlockId a = kGroundBlock, b = 0;
  std::int32_t material = 0;  // into Model::materials
  double area = 0;            // [m^2]
  Vec3 centre;                // of the face at the start [m]
  Vec3 half;                  // [m]; shortened where a joint stands for a continuous section
  Vec3 half_2;                // in space, along the other direction of the face [m]; 0 in the plane
  Vec3 along, normal;         // unit vectors at the start
  Vec3 arm_a, arm_b;  // centre seen from the centroids of a and b [m]; 0 of the ground and of
                      // deformable blocks
};
[[nodiscard]] JointShape joint_shape(const Model& model, JointId joint);
// Whether there are potential crack planes inside the units.
[[nodiscard]] bool has_unit_planes(const Model& model);
// Whether a joint is such a plane; in space too, where its blocks are pieces of one unit by the builder's names.
[[nodiscard]] bool is_unit_plane(const Model& model, JointId joint);

[[nodiscard]] Vec3 centroid_of(const Model& model,
                               BlockId block);  // of a rigid block, at the start [m]
// Corners of a block at the start, anticlockwise [m]; none in space.
[[nodiscard]] std::vector<Vec3> outline_of(const Model& model, BlockId block);
// Corners of a block of any wall at the start [m]; in space those of each convex part, unordered.
[[nodiscard]] std::vector<Vec3> corners_of(const Model& model, BlockId block);

// --- positions -------------------------------------------------------------------------------------

// Position of a block. A deformable block moves with its first node and does not rotate.
struct BlockReading {
  BlockId id = 0;
  BlockRole role = BlockRole::kMasonry;
  Vec3 start;  // centroid at the start; middle of the bounds of a deformable block [m]
  Vec3 moved;  // displacement of that point [m]
  Rotation turned;
};
[[nodiscard]] BlockReading read_block(const Model& model, const State& state, BlockId block);

// Outline of a block in a state [m]. `scale` magnifies displacements and rotations; 1 gives true positions.
[[nodiscard]] std::vector<Vec3> outline_now(const Model& model, const State& state, BlockId block,
                                            double scale = 1);
// Both ends of a joint, midway between its two faces [m]; a ground face stays in place. For a
// contact they lie on the edge of the deformable block.
[[nodiscard]] std::array<Vec3, 2> ends_now(const Model& model, const State& state, JointId joint,
                                           double scale = 1);
[[nodiscard]] Vec3 node_now(const Model& model, const State& state, int node, double scale = 1);
[[nodiscard]] Vec3 node_moved(const State& state, int node);  // [m]
[[nodiscard]] std::vector<Vec3> corners_now(const Model& model, const State& state, BlockId block);
// Displacement of the point of a rigid block that started at `arm` from its centroid [m].
[[nodiscard]] Vec3 displacement_of(const Model& model, const State& state, BlockId block, Vec3 arm);
[[nodiscard]] double tilt_of(const Model& model, const State& state, BlockId block);  // [rad]

// Convex parts of a block in space, displaced; n_block + i is support i.
[[nodiscard]] std::vector<Polyhedron> solid_now(const Model& model, const State& state,
                                                BlockId block, double scale = 1);
// Polygon of a joint, midway between its two faces, anticlockwise about the normal [m]; in the plane its ends.
[[nodiscard]] std::vector<Vec3> face_now(const Model& model, const State& state, JointId joint,
                                         double scale = 1);

// --- deformations and forces -----------------------------------------------------------------------

// A point of a joint: its history, and the stresses of the joint law in this state, without a further step but with the arithmetic
// of the step.
struct PointReading {
  double share = 0;                            // of its joint's area [-]
  double place = 0;                            // on the face, from -1 to 1 along it [-]
  Vec3 where;                                  // current place, midway between the two faces [m]
  double opening = 0, slip = 0;                // of b against a, along normal and face [m]
  double opened = 0;                           // largest effective opening so far [m]
  double slid = 0;                             // plastic part of the slip [m]
  double crushed = 0;                          // shortening by crushing [m]
  double normal_stress = 0, shear_stress = 0;  // tension + [Pa]
  double damage_tension = 0, damage_shear = 0, damage = 0, crushing = 0;  // [-]
  // vectors in space; slip and shear_stress are their lengths
  Vec3 slip_vector;   // [m]
  Vec3 shear_vector;  // stress on a [Pa]
};
// Points of all joints, in the order of points_of().
[[nodiscard]] std::vector<PointReading> read_points(const Model& model, const State& state);

struct JointReading {
  JointShape shape;
  PointRange points;
  Vec3 where;                                   // current centre [m]
  double opening = 0;                           // at its wider end; negative where closed [m]
  double slip = 0;                              // the one of largest magnitude among its points [m]
  double damage_tension = 0, damage_shear = 0;  // largest of its points [-]
  double damage = 0, crushing = 0;              // largest of its points [-]
  double normal_stress = 0, shear_stress = 0;   // area means, tension + [Pa]
  double compression = 0, shear = 0;            // normal, compression +; along the face [N]
  double moment = 0;                            // of the normal force about the centre [N m]
  double eccentricity = 0;                      // of the normal force over half the face, -1 to 1;
                                                // 0 without compression; in space the larger value
                                                // of both directions
  // the joint carries nothing and its sides may be far apart: a free contact replaces it, or it does not stand in this stage
  bool handed_over = false;
  // vectors in space; shear and moment are their lengths
  Vec3 slip_vector;    // area mean [m]
  Vec3 shear_vector;   // force on a, along the face [N]
  Vec3 moment_vector;  // on a about the centre; its normal component is torsion [N m]
};

struct WallReading {
  std::vector<BlockReading> blocks;
  std::vector<JointReading> joints;
  std::vector<PointReading> points;
  [[nodiscard]] std::span<const PointReading> points_of(const JointReading& joint) const {
    return std::span(points).subspan(joint.points.begin,
                                     static_cast<std::size_t>(joint.points.size()));
  }
};
[[nodiscard]] WallReading read_wall(const Model& model, const State& state);
// The force of a on b in the axes of the wall, for the current direction of the face: a ground face has not rotated; the edge of
// a deformable block has the direction of its neighbour [N].
[[nodiscard]] Vec3 force_of(const Model& model, const JointReading& joint, const WallReading& wall);

// Whether a joint is compressed while its faces overlap by less than half; `points` are those of the whole wall.
[[nodiscard]] bool has_slid_off(const Model& model, const std::vector<PointReading>& points,
                                JointId joint);

// A link in this state, with the arithmetic of the step.
struct LinkReading {
  double stiffness = 0;      // [N/m]
  double force = 0;          // tension + [N]
  double elongation = 0;     // against the initial length, without prestress [m]
  double plastic = 0;        // plastic part of it [m]
  std::array<Vec3, 2> ends;  // current [m]; of a spring both at its point on the block
};
// All links of the model, in their order.
[[nodiscard]] std::vector<LinkReading> read_links(const Model& model, const State& state);

// The section of a frame at one of its links in this state, with the arithmetic of the step.
struct FrameReading {
  double normal = 0;   // tension + [N]
  double shear = 0;    // of the following segment on this one, to the left + [N]
  double moment = 0;   // tension on the right of the member + [N m]
  double use = 0;      // over the capacity; 1: fully plastic (frames.md, 20.8) [-]
  double plastic = 0;  // largest |plastic elongation| of a fibre [m]
  double stored = 0;   // elastic energy [J]
  Vec3 where;          // current place [m]
};
// All links of frames, in their order.
[[nodiscard]] std::vector<FrameReading> read_frames(const Model& model, const State& state);
// Utilisation of a member's section by N, V and M [-] (frames.md, 20.8).
[[nodiscard]] double section_use(const FrameMember& member, double normal, double shear,
                                 double moment);

// A node of a layer and the fibres to the next node, with the arithmetic of the step.
struct LayerReading {
  double force = 0;   // of the fibres [N]
  double use = 0;     // force over strength; 1 where broken [-]
  double slip = 0;    // on the block, along the strand [m]
  double spent = 0;   // share of the bond energy used so far; detached from 0.95 on [-]
  double stored = 0;  // elastic, of fibres and bond [J]
  bool broken = false;
};
// All nodes of layers, in their order.
[[nodiscard]] std::vector<LayerReading> read_layers(const Model& model, const State& state);

// A zone of a deformable block: mean stresses in the axes of the wall, and current corners.
struct ZoneReading {
  double sigma_x = 0, sigma_y = 0, tau = 0;  // [Pa]
  int corners = 4;                           // 3: a triangle, whose last two corners coincide
  std::array<Vec3, 4> corner;                // [m]
  Vec3 moved;                                // mean displacement of its corners [m]
};
[[nodiscard]] std::vector<ZoneReading> read_zones(const Model& model, const State& state);
// The greater and the smaller principal stress in the plane, tension positive [Pa].
[[nodiscard]] std::pair<double, double> principal_stresses(const ZoneReading& zone);

// A zone of a deformable block in space, as ZoneReading.
struct SpaceZoneReading {
  std::array<double, 6> stress{};     // x, y, z, xy, yz, zx in the wall's axes, tension + [Pa]
  std::array<double, 3> principal{};  // in falling order [Pa]
  std::array<Vec3, 8> corner;         // [m], in the order of HexahedronShape
  Vec3 middle;                        // mean of its corners at the start [m]
  Vec3 moved;                         // displacement of `middle` [m]
  Rotation turned;                    // mean rotation
};
[[nodiscard]] std::vector<SpaceZoneReading> read_space_zones(const Model& model,
                                                             const State& state);

}  // namespace wythe
