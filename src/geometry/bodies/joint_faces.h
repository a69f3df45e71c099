// Finds where bodies in space touch: coplanar faces in opposite directions, and the polygon they share.
//
//        +-----------+           faces of a and b whose planes agree within the tolerances are projected into their
//        |     b     |           mean plane; the common part of the two convex polygons is one joint face
//   +----+===========+--+
//   |        a          |        normal from a to b; the polygon runs anticlockwise seen from b
//   +-------------------+
//
// Candidate pairs come from a sweep of boxes along the axis on which the bodies spread most. Coplanar pieces of one pair
// that form a convex polygon together are joined: a face that was cut into triangles gives one joint.
// Called by src/model; checks in body_checks.cpp, cutting into convex parts in convex_parts.cpp.
#pragma once

#include <algorithm>
#include <limits>
#include <string>
#include <vector>

#include "geometry/assembly.h"
#include "geometry/bodies/polyhedron.h"
#include "wythe/parts/body.h"
#include "wythe/parts/error.h"
#include "wythe/parts/message.h"

namespace wythe::geometry {

// Tolerances of faces, each as a share of the size of the smaller face (square root of its area).
inline constexpr double kParallelFaces = 1e-2;  // sine of the angle between the normals
inline constexpr double kWidestTouch = 2e-3;    // gap or penetration at any corner of the overlap
inline constexpr double kWidestMiss =
    1e-2;  // a gap up to here is a lost face, a wider one intended
inline constexpr double kSliverFace = 1e-3;   // overlap of a smaller share of its area is lost
inline constexpr double kFinestTouch = 1e-6;  // of the model's size: closer faces always touch

struct JointFace {
  int a = 0, b = 0;           // bodies; a is the fixed one where one is fixed, else a < b
  std::vector<Vec3> polygon;  // convex, plane, anticlockwise about the normal
  Vec3 normal;                // unit, from a to b
  Vec3 centre;                // centroid of the area
  double area = 0;            // [m^2]
};

// A convex piece of a body's surface without contact.
struct OuterFace {
  int body = 0;
  std::vector<Vec3> polygon;
  Vec3 normal;  // pointing out of the body
  double area = 0;
};

// The stages in which a body stands, from the first to the one before the last.
struct StageSpan {
  int from = 0, until = std::numeric_limits<int>::max();
  [[nodiscard]] bool meets(const StageSpan& other) const {
    return from < other.until && other.from < until;
  }
};

// The vertical plane of a frame: x along it in plan, y up.
struct FramePlane {
  Vec3 origin, along, across;
  [[nodiscard]] Vec3 turned(Vec2 v) const { return v.x * along + Vec3{0, v.y, 0}; }
  [[nodiscard]] Vec3 place(Vec2 p) const { return origin + turned(p); }
};
struct SpaceFrame {
  PlacedFrame placed;
  FramePlane plane;
  std::size_t first_body = 0;              // its segments are consecutive bodies
  [[nodiscard]] bool holds_feet() const {  // whether sections connect it to the ground
    return std::any_of(placed.joints.begin(), placed.joints.end(), [](const FrameJoint& joint) {
      return joint.a == kGround || joint.b == kGround;
    });
  }
};

struct SpaceAssembly {
  std::vector<BodySpec>
      body;  // as given and in that order, but oriented outwards and cut into convex parts
  std::vector<SolidMoments> moments;
  std::vector<StageSpan> span;     // of each body
  std::vector<SpaceFrame> frames;  // whose segments are bodies
  std::vector<JointFace> faces;    // by a, b, then by the faces of a and b
  std::vector<OuterFace> outer;    // sorted by body and face
  int lost_faces = 0;              // slivers, and faces across narrow gaps
  std::vector<Message> notes;
};

// Finds the joint faces of `bodies`. Faults stand at "wall.blocks.<id>"; after a fault of a body only bodies are checked. `stages`: names
// in order. Bodies that never stand together may share a place and do not touch. Nor do segments of one of the `frames`, and the
// ground that holds its feet: sections connect these.
[[nodiscard]] SpaceAssembly assemble(const std::vector<BodySpec>& bodies, FaultList& faults,
                                     const std::vector<std::string>& stages = {},
                                     std::vector<SpaceFrame> frames = {});
// Index of the frame whose segment a body is, or -1.
[[nodiscard]] int frame_of(const SpaceAssembly& assembly, int body);

// --- for body_checks.cpp

// Sorted pairs (i < j) of boxes that meet when widened by `margin`.
[[nodiscard]] std::vector<std::pair<int, int>> near_pairs(const std::vector<Box3>& boxes,
                                                          double margin);

// Largest side of the box around all bodies [m].
[[nodiscard]] double model_size(const std::vector<BodySpec>& bodies);

}  // namespace wythe::geometry
