// The walls of a model, each as it is seen across its plane. Parts are found and damage is evaluated in this view.
//
//      up        along   level, to the right: towards +x, of a wall along z towards +z
//       |        across  towards who looks; along, up and across are right-handed
//       |
//       +---- along      A wall in its plane is one elevation, with unchanged coordinates. In space each wall that
//                        is thin in plan has one; slabs and other bodies have none.
//
// Blocks of other walls that are toothed into a wall belong to its elevation too, so corners have no holes.
#pragma once

#include <cmath>
#include <string>
#include <vector>

#include "wythe/parts/model.h"
#include "wythe/parts/vector.h"

namespace wythe::study {

struct Moved;  // space_pieces.h

struct Elevation {
  std::string wall;      // the builder's name; empty in the plane and where the model has one wall
  Vec3 along{1, 0, 0};   // unit vectors
  Vec3 across{0, 0, 1};  //
  std::vector<char> of;  // for each rigid block: belongs to this wall; empty: all do
  std::vector<BlockId> bodies =
      {};  // deformable blocks of it in space, numbered as in read_block()
  std::vector<double> share =
      {};  // for each joint: its share of the wall's thickness there; empty: all of it

  [[nodiscard]] bool holds(BlockId block) const {
    return of.empty() ||
           (block >= 0 && static_cast<std::size_t>(block) < of.size() && of[block] != 0);
  }
  // A place at the start, projected on the plane. In space it is rounded to a
  // nanometre, so that a place on the edge of a part stays on it in any orientation.
  [[nodiscard]] Vec3 place(Vec3 v) const {
    constexpr double kNanometres = 1e9;
    const auto rounded = [](double x) { return std::round(x * kNanometres) / kNanometres; };
    return of.empty() ? v : Vec3{rounded(dot(v, along)), rounded(v.y), 0};
  }
  // A displacement or a direction: components along, up, across.
  [[nodiscard]] Vec3 seen(Vec3 v) const {
    return of.empty() ? v : Vec3{dot(v, along), v.y, dot(v, across)};
  }
  // The same without the component out of the plane; for a rotation only the component about `across`.
  [[nodiscard]] Vec3 in_plane(Vec3 v) const { return of.empty() ? v : Vec3{dot(v, along), v.y, 0}; }
  [[nodiscard]] Vec3 turn(Vec3 v) const { return of.empty() ? v : Vec3{0, 0, dot(v, across)}; }
};
[[nodiscard]] std::vector<Elevation> elevations_of(const Model& model);

// Outlines of a block in this view at the start, one for each convex part [m].
[[nodiscard]] std::vector<std::vector<Vec3>> outlines_of(const Model& model, const Elevation& seen,
                                                         BlockId block);
// Half the size of a joint in this view, along the wall and upwards [m].
struct Reach {
  double along = 0, up = 0;
};
[[nodiscard]] Reach reach_of(const Elevation& seen, const Vec3& half, const Vec3& half_2);
// Moment of inertia of a rigid block about its centroid, in the plane of the wall [kg m^2].
[[nodiscard]] double inertia_of(const Model& model, const Elevation& seen, BlockId block);

// Whether a rigid block belongs to a wall. Slabs, frames and blocks that a stage cuts out do not.
[[nodiscard]] bool makes_walls(const Model& model, BlockId block);

// The builder's name of the wall: "front" of front.c03u05a, front.lintel0; "" for other ids.
[[nodiscard]] std::string wall_of(const std::string& id);
// Groups of blocks by the builder's names, then by connection; only masonry that stays, without slabs.
struct WallBlocks {
  std::string name;
  std::vector<Moved> blocks;
};
[[nodiscard]] std::vector<WallBlocks> groups_of(const Model& model);

}  // namespace wythe::study
