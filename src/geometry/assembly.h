// The wall as geometry: blocks as polygons and the faces they share. No mechanics.
//
// build_assembly() makes it from a Shape, either from its wall (bond patterns, openings, lintels, plates, beam) or
// from the blocks of a file already read; model/compile.cpp turns it into the arrays of a Model.
//
//      +-----+-----+        each pair of faces in contact is one Face: the overlap segment p0-p1, the two
//      |  b  |     |        blocks, and the unit normal pointing from a to b
//      +--^--+-----+   p0 --n-- p1
//      |  a  |     |
#pragma once

#include <string>
#include <vector>

#include "geometry/shape.h"
#include "wythe/parts/error.h"
#include "wythe/parts/message.h"
#include "wythe/parts/vector.h"

namespace wythe::geometry {

enum class Role { kMasonry, kLintel, kPlate, kBeam, kSupport, kRingBeam, kSill, kFrame };

struct Block {
  std::string id;               // "c03u07a" (course, unit, half) or the id in a blocks file
  std::vector<Vec2> outline;    // anticlockwise, no repeated end point [m]
  std::string material;         // block material name ("masonry", the lintel's material, ...)
  double thickness = kUnset;    // [m]
  Role role = Role::kMasonry;   // kSupport blocks are fixed
  int course = -1;              // 0 at the bottom, -1 without courses
  int unit = -1;                // the blocks of one masonry unit share it; -1: none
  int opening = -1;             // of segments of a lintel or sill, and of voussoirs: their opening
  int ring_beam = -1;           // of its segments: index in the model's list
  int frame = -1;               // of its segments: index in the model's list
  int segment = -1;             // of a frame's segments: index in PlacedFrame
  double own_density = kUnset;  // of a frame's segment, by its section [kg/m^3]
  int storey = -1;              // in the model's list; -1: the model has none
  int region = -1;              // last region of the model's list with its centroid; -1: none
  ZoneSpec zone;                // deformable where zone.zones > 0
  int cut_from = -1;            // masonry that a stage cuts out: index of its opening
};

// Whether a block is a voussoir: masonry that belongs to an opening.
[[nodiscard]] inline bool is_voussoir(const Block& block) {
  return block.role == Role::kMasonry && block.opening >= 0;
}

// Whether a block is a segment of a lintel, sill or ring beam.
[[nodiscard]] inline bool is_chain(const Block& block) {
  return block.role == Role::kLintel || block.role == Role::kSill || block.role == Role::kRingBeam;
}

enum class FaceKind {
  kBed,
  kHead,
  kSplit,
  kFoundation,
  kLintelChain,
  kLintelBond,
  kPlate,
  kBeam,
  kOther,
  kFrame,
  kCoat
};

inline constexpr int kGround = -1;

struct Face {
  int a = kGround;  // kGround when the support side
  int b = 0;
  Vec2 p0, p1;  // overlap segment; from p0 to p1 the normal is on the LEFT: n = (-ty, tx)
  FaceKind kind = FaceKind::kOther;
  std::string material;     // joint material name
  bool shares_bed = false;  // a head joint with its bed's material: head_joint_bond acts
};

// What the geometry changed or omitted of the user's input; `wythe check` shows it.
struct BuildReport {
  std::vector<Message> notes;  // e.g. "half unit 155 mm -> 154.5 mm (-0.3 %)"
  double half_unit = 0;        // fitted [m], 0 for a blocks file
  double course = 0;           // fitted course height [m]
  int courses = 0;
  int masonry_blocks_before_lintels = 0;
  int lost_joints = 0;  // facing pairs omitted (shorter than the smallest contact)
};

// One pier: an interval of the wall's length beside openings, from bottom to top.
struct Pier {
  double x0 = 0, x1 = 0;  // [m]
  double height = 0;      // top of the lower adjacent opening [m]; wall height without openings
};

// One storey as laid; storeys are listed from the ground up.
struct StoreyBand {
  std::string name;
  double foot = 0, top = 0;           // [m]
  double thickness = 0;               // [m]
  int first_course = 0, courses = 0;  // 0 courses in a blocks file
};

// Level ground below a generated wall, from x0 to x1 at height y.
struct GroundStep {
  double x0 = 0, x1 = 0, y = 0;  // [m]
};

// One straight part of a frame, as built: with its gap.
struct FramePart {
  Message words;  // "left column"
  Vec2 from, direction;
  double length = 0;  // between corners, on the axis [m]
};

// A section between two segments of a frame, or between the ground and a foot; `a` comes first along the frame.
struct FrameJoint {
  int part = 0;
  int a = kGround, b = kGround;  // segments
  double place = 0;              // along its part [m]
  double length = 0;             // length of frame that the section represents [m]
  bool hinged = false;
};

struct PlacedFrame {
  int index = 0;  // in the model's list
  std::string name;
  std::vector<FramePart> parts;
  std::vector<FrameJoint> joints;
  std::vector<Block> segments;  // outlines moved by the gap, so that they touch their neighbours
  std::vector<Vec2> moved;      // of each segment: from outline to true place (the gap) [m]
};

struct Assembly {
  std::vector<Block> blocks;
  std::vector<Face> faces;
  std::vector<PlacedFrame> frames;
  std::vector<Pier> piers;  // left to right; the whole wall when it has no opening
  std::vector<StoreyBand> storeys;
  std::vector<GroundStep> ground;                // of a generated wall, left to right
  double length = 0, height = 0, thickness = 0;  // bounding box of the masonry; of its foot [m]
  double top_thickness = 0;                      // of the topmost masonry [m]
  [[nodiscard]] double thickness_of(const Face& face) const;  // the smaller of its blocks' [m]
  BuildReport report;
};

// Builds the wall, from shape.block when the spec names a blocks file. A wall that can't be built gives `faults`
// with their spec paths.
[[nodiscard]] Assembly build_assembly(const Shape& shape, FaultList& faults);

// Density of a block [kg/m^3]. It is no member of Block, so that walls of different density share an assembly.
[[nodiscard]] double density_of(const Shape& shape, const Block& block);

// Area, centroid and second polar moment about the centroid of a simple anticlockwise polygon.
struct PolygonMoments {
  double area = 0;  // [m^2], negative when clockwise
  Vec2 centroid;
  double polar = 0;  // about the centroid [m^4]
};
[[nodiscard]] PolygonMoments moments(const std::vector<Vec2>& outline);

}  // namespace wythe::geometry
