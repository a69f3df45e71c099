// The builder in space: turns tables of the model file into bodies (docs/theory/builder.md).
//
//   [[plan_wall]] ──► plan_meetings: where lines meet ──► plan_walls: courses, teeth, wythes ──┐
//   [[slab]] ──► slabs: outline, level; walls are cut where slabs reach into them ─────────────┤
//   [[arch]], [[dome]] ──► vaults: voussoirs between flat joints ─────────────────────────────┴─► BodySpec
//
// Ids of bodies are "front.c03u05a": wall, course and unit counted from 0, piece; with wythes ".w1" ... at the end.
// Those of supports are "front.ground". Called when a model file is read (src/io/model/model_file.cpp).
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

// Data for all tables: the model's [wall], whose keys they inherit, and its materials.
struct Site {
  const BuilderSpec& spec;
  const ModelSpec& model;
  [[nodiscard]] bool z_up() const { return model.wall.up == "z"; }
  // Adds a fault where a material has no density and the masonry has none either.
  void check_material(const std::string& path, const std::string& name, FaultList& faults) const;
};

struct BuiltBody {
  BodySpec body;
  std::string wall;  // "front", or "front.2" of a line with corners
  int course = -1;
  int wythe = 0;            // 1, 2, ...; 0: full thickness
  std::string region = {};  // for messages, where a region gives it a depth of its own
};

// Builds the bodies of all tables; faults stand at the keys of their table.
// `frames` gets the model's frames as frames_in_walls() places them.
[[nodiscard]] std::vector<BuiltBody> build_bodies(const Site& site, std::vector<Message>& notes,
                                                  FaultList& faults,
                                                  std::vector<FrameSpec>* frames = nullptr);

// --- pieces

// Converts places in plan (p, q) and heights to the wall's axes: q is z, or the file's y where z points up.
struct PlanAxes {
  bool z_up = false;
  [[nodiscard]] Vec3 place(Vec2 plan, double height) const {
    return {plan.x, height, z_up ? -plan.y : plan.y};
  }
};

// The solid between two polygons with equal numbers of corners and plane sides; oriented outwards.
[[nodiscard]] Polyhedron solid_between(const std::vector<Vec3>& bottom,
                                       const std::vector<Vec3>& top);

enum class EndKind { kFree, kCorner, kTee };
struct WallEnd {
  EndKind kind = EndKind::kFree;
  int other = -1;        // the wall it meets
  int other_end = -1;    // at a corner
  bool toothed = false;  //
  double reach = 0;      // length of masonry beyond the line's end; < 0: it ends before [m]
  Vec2 face{};           // of an oblique end: masonry with dot(face, plan) >= face_at stays
  double face_at = 0;
  int passes = 0;  // courses with (course + phase) % 2 == passes go through
};

// A wall that ends on this one.
struct Tee {
  int other = -1, end = -1;
  double at = 0;  // from the first point of the line [m]
};

// One straight wall: a plan_wall, or one segment of its line.
struct StraightWall {
  int index = 0;           // in the list of plan walls
  std::string name, path;  // "front" or "front.2"; "plan_wall.0"
  Vec2 from, along, across;
  double line = 0;  // length of the line [m]
  double base = 0;  // height of its foot [m]
  double thickness = 0;
  WallSpec wall;  // with inherited values; its length is that of the masonry with teeth
  WallEnd end[2];
  std::vector<Tee> tees;
  int phase = 0;  // first course of its bond
  std::vector<Storey> storeys;
  [[nodiscard]] double begin() const { return -end[0].reach; }  // of the masonry, on its line [m]
  [[nodiscard]] int rows() const;                               // courses below the gable
  [[nodiscard]] bool goes_through(int e, int row) const;
};

// Divides lines at their corners and finds thicknesses, lengths and meetings; notes ends that barely miss another wall.
[[nodiscard]] std::vector<StraightWall> read_plan(const Site& site, std::vector<Message>& notes,
                                                  FaultList& faults);

// Decides which end goes through in which courses, once the lattices are known.
void match_courses(std::vector<StraightWall>& walls, FaultList& faults);

// Builds all plan walls. `walls` gets the straight walls behind the bodies, for slabs and frames on them.
[[nodiscard]] std::vector<BuiltBody> build_plan_walls(const Site& site,
                                                      std::vector<StraightWall>& walls,
                                                      std::vector<Message>& notes,
                                                      FaultList& faults);
// The model's frames. One that names a wall gets the place of the wall's middle plane, the opening as laid, and
// the stage that cuts this opening.
[[nodiscard]] std::vector<FrameSpec> frames_in_walls(const Site& site,
                                                     const std::vector<StraightWall>& walls,
                                                     FaultList& faults);
// Adds slabs to the bodies of these walls, and cuts pockets where slabs reach into walls.
void build_slabs(const Site& site, const std::vector<StraightWall>& walls,
                 std::vector<BuiltBody>& bodies, std::vector<Message>& notes, FaultList& faults);
// Loads of slabs, one floor for each convex part with its resultant in the middle of the part; and the
// rules for joints of slabs. Both belong to the model, not to the bodies.
[[nodiscard]] std::vector<FloorSpec> floors_of_slabs(const Site& site,
                                                     const std::vector<BuiltBody>& bodies);
[[nodiscard]] std::vector<ContactRule> contacts_of_slabs(const Site& site,
                                                         const std::vector<BuiltBody>& bodies,
                                                         FaultList& faults);
[[nodiscard]] std::vector<BuiltBody> build_arch(const Site& site, int index, FaultList& faults);
[[nodiscard]] std::vector<BuiltBody> build_dome(const Site& site, int index, FaultList& faults);

}  // namespace wythe::geometry
