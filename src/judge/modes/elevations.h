// The walls of a model, each as it is seen across its plane: there parts are found and damage is read.
//
//      up        along   level, to the right: towards +x, of a wall along z towards +z
//       |        across  towards who looks; along, up and across are right-handed
//       |
//       +---- along      A wall in its plane is one elevation, and what is seen of it is as it is. In space each
//                        wall that is thin in plan has one; slabs and what else is not thin have none.
//
// What other walls tooth into a wall belongs to its elevation too: a corner has no hole in every second course.
#pragma once

#include <cmath>
#include <string>
#include <vector>

#include "wythe/parts/model.h"
#include "wythe/parts/vector.h"

namespace wythe::study {

struct Elevation {
  std::string wall;      // the builder's name; empty in the plane and where the model has one wall
  Vec3 along{1, 0, 0};   // unit vectors
  Vec3 across{0, 0, 1};  //
  std::vector<char> of;  // of each rigid block whether it is of this wall; empty: all are
  std::vector<BlockId> bodies =
      {};  // deformable blocks of it in space, as read_block() numbers them
  std::vector<double> share =
      {};  // of each joint: how much of the wall's thickness it takes there; empty: all

  [[nodiscard]] bool holds(BlockId block) const {
    return of.empty() || (block >= 0 && static_cast<std::size_t>(block) < of.size() &&
                          of[static_cast<std::size_t>(block)] != 0);
  }
  // A place at the start, without its distance from the plane. In space it is rounded to a nanometre: what lies on an
  // edge of a part lies on it in any world.
  [[nodiscard]] Vec3 place(Vec3 v) const {
    constexpr double kNanometres = 1e9;
    const auto rounded = [](double x) { return std::round(x * kNanometres) / kNanometres; };
    return of.empty() ? v : Vec3{rounded(dot(v, along)), rounded(v.y), 0};
  }
  // A way or a direction: along, up, across.
  [[nodiscard]] Vec3 seen(Vec3 v) const {
    return of.empty() ? v : Vec3{dot(v, along), v.y, dot(v, across)};
  }
  // The same without what leads out of the plane; of a turn that about `across` alone.
  [[nodiscard]] Vec3 way(Vec3 v) const { return of.empty() ? v : Vec3{dot(v, along), v.y, 0}; }
  [[nodiscard]] Vec3 turn(Vec3 v) const { return of.empty() ? v : Vec3{0, 0, dot(v, across)}; }
};
[[nodiscard]] std::vector<Elevation> elevations_of(const Model& model);

// Outlines of a block as it is seen at the start, one of each convex part [m].
[[nodiscard]] std::vector<std::vector<Vec3>> outlines_of(const Model& model, const Elevation& seen,
                                                         BlockId block);
// Half of what is seen of a joint, along the wall and upwards [m].
struct Reach {
  double along = 0, up = 0;
};
[[nodiscard]] Reach reach_of(const Elevation& seen, const Vec3& half, const Vec3& half_2);
// Moment of inertia of a rigid block about its centroid, in the plane of the wall [kg m^2].
[[nodiscard]] double inertia_of(const Model& model, const Elevation& seen, BlockId block);

// Whether a rigid block makes a wall. Slabs and frames do not, and neither does what a stage cuts out.
[[nodiscard]] bool makes_walls(const Model& model, BlockId block);

// The builder's name of the wall: "front" of front.c03u05a, front.lintel0; "" for other ids.
[[nodiscard]] std::string wall_of(const std::string& id);

}  // namespace wythe::study
