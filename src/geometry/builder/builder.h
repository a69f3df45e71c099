// The builder in space: tables of the model file -> bodies (docs/theory/builder.md).
//
//   [[plan_wall]] ──► plan_meetings: where lines meet ──► plan_walls: courses, teeth, wythes ──┐
//   [[slab]] ──► slabs: outline, level; walls are cut where it reaches into them ──────────────┤
//   [[arch]], [[dome]] ──► vaults: voussoirs between flat joints ─────────────────────────────┴─► BodySpec
//
// Bodies are named "front.c03u05a": wall, course and unit from 0 on, piece; with wythes ".w1" ... at the end.
// Supports are "front.ground". Called when a model file is read (src/io/model/model_file.cpp).
#pragma once

#include <string>
#include <vector>

#include "geometry/polygon.h"
#include "geometry/shape.h"
#include "geometry/wall/storeys.h"
#include "wythe/parts/builder.h"
#include "wythe/parts/error.h"
#include "wythe/parts/message.h"

namespace wythe::geometry {

inline constexpr std::size_t kMostBuilt = 200000;  // bodies of one model

// What the tables are built with: the model's [wall], whose keys they inherit, and its materials.
struct Site {
  const BuilderSpec& spec;
  const ModelSpec& model;
  [[nodiscard]] bool z_up() const { return model.wall.up == "z"; }
  // A material has a density, or the masonry has one.
  void check_material(const std::string& path, const std::string& name, FaultList& faults) const;
};

struct BuiltBody {
  BodySpec body;
  std::string wall;  // "front", or "front.2" of a line with corners
  int course = -1;
  int wythe = 0;  // 1, 2, ...; 0: the whole thickness
};

// Bodies of all three tables; faults stand at the keys of their table.
// `frames`: takes the model's frames as frames_in_walls() places them.
[[nodiscard]] std::vector<BuiltBody> build_bodies(const Site& site, std::vector<Message>& notes,
                                                  FaultList& faults,
                                                  std::vector<FrameSpec>* frames = nullptr);

// --- pieces

// Places in plan (p, q) and heights become the wall's axes: q is z, or the file's y where z points up.
struct PlanAxes {
  bool z_up = false;
  [[nodiscard]] Vec3 place(Vec2 plan, double height) const {
    return {plan.x, height, z_up ? -plan.y : plan.y};
  }
};

// A solid between two polygons of as many corners, the sides flat; turned outside out.
[[nodiscard]] Polyhedron solid_between(const std::vector<Vec3>& bottom,
                                       const std::vector<Vec3>& top);

enum class EndKind { kFree, kCorner, kTee };
struct WallEnd {
  EndKind kind = EndKind::kFree;
  int other = -1;        // the wall it meets
  int other_end = -1;    // at a corner
  bool toothed = false;  //
  double reach = 0;      // of the masonry beyond the line's end, negative where it stops before [m]
  Vec2 face{};           // oblique, and it ends there: dot(face, plan) >= face_at is what stays
  double face_at = 0;
  int passes = 0;  // courses that go through are those with (course + phase) % 2 == passes
};

// A wall that ends on this one.
struct Tee {
  int other = -1, end = -1;
  double at = 0;  // from the first point of the line [m]
};

// One straight wall: a plan_wall, or one side of a polyline.
struct StraightWall {
  int index = 0;           // in the list of plan walls
  std::string name, path;  // "front" or "front.2"; "plan_wall.0"
  Vec2 from, along, across;
  double line = 0;  // length of the line [m]
  double base = 0;  // height of its foot [m]
  double thickness = 0;
  WallSpec wall;  // what it inherits settled; its length is that of the masonry, teeth included
  WallEnd end[2];
  std::vector<Tee> tees;
  int phase = 0;  // its bond begins with this course
  std::vector<Storey> storeys;
  [[nodiscard]] double begin() const { return -end[0].reach; }  // of the masonry, on the line [m]
  [[nodiscard]] int rows() const;                               // courses below the gable
  [[nodiscard]] bool goes_through(int e, int row) const;
};

// Lines cut at their corners, with thicknesses, lengths and meetings.
[[nodiscard]] std::vector<StraightWall> read_plan(const Site& site, FaultList& faults);

// Once the lattices are known: which end goes through in which courses.
void match_courses(std::vector<StraightWall>& walls, FaultList& faults);

// `walls` gets the straight walls that the bodies are of, for what lies on them.
[[nodiscard]] std::vector<BuiltBody> build_plan_walls(const Site& site,
                                                      std::vector<StraightWall>& walls,
                                                      std::vector<Message>& notes,
                                                      FaultList& faults);
// The model's frames, those that name a wall with the place of its middle plane, with the opening that they stand in as
// it was laid, and with the stage that cuts it.
[[nodiscard]] std::vector<FrameSpec> frames_in_walls(const Site& site,
                                                     const std::vector<StraightWall>& walls,
                                                     FaultList& faults);
// Adds the slabs to the bodies of these walls, and cuts these where slabs reach into them.
void build_slabs(const Site& site, const std::vector<StraightWall>& walls,
                 std::vector<BuiltBody>& bodies, std::vector<Message>& notes, FaultList& faults);
// What lies on slabs, one floor for each of their convex parts, with its resultant in the part's middle; and the
// joints that slabs ask for. Both belong to the model beside the bodies.
[[nodiscard]] std::vector<FloorSpec> floors_of_slabs(const Site& site,
                                                     const std::vector<BuiltBody>& bodies);
[[nodiscard]] std::vector<ContactRule> contacts_of_slabs(const Site& site,
                                                         const std::vector<BuiltBody>& bodies,
                                                         FaultList& faults);
[[nodiscard]] std::vector<BuiltBody> build_arch(const Site& site, int index, FaultList& faults);
[[nodiscard]] std::vector<BuiltBody> build_dome(const Site& site, int index, FaultList& faults);

}  // namespace wythe::geometry
