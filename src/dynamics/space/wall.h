// One wall in space among the tables, for code that handles a single wall: loads, drive,
// meters, copies of its state. The counterpart of passes/wall.h, drive.h and sums.h.
#pragma once

#include "dynamics/passes/drive.h"
#include "dynamics/passes/links.h"
#include "dynamics/passes/sums.h"
#include "dynamics/space/blocks.h"

namespace wythe::dynamics::space {

using Vec = Vector<double>;
[[nodiscard]] inline Vec vec(const Vec3& v) { return {v.x, v.y, v.z}; }

class ZoneRun;  // zones.h

struct WallView {
  Tables t;
  const Layout* layout = nullptr;
  std::ptrdiff_t lane = 0;
  int blocks = 0, supports = 0, links = 0;
  int first_free = -1;  // row of forces of body 0's free contacts; -1: none
  int bodies = 0;       // number of bodies with such rows, fixed ones included
  const std::vector<BlockId>* contact_block = nullptr;  // of the contacts of zones

  [[nodiscard]] double& number(double* table, int rows, std::ptrdiff_t e, int row) const {
    return table[layout->number(e, rows, row, t.lanes) + lane];
  }
  [[nodiscard]] double& body(std::ptrdiff_t i, int row) const {
    return number(t.body, kBodyRows, i, row);
  }
  [[nodiscard]] double& still(std::ptrdiff_t i, int row) const {
    return number(t.still, kStillRows, i, row);
  }
  [[nodiscard]] double& link(std::ptrdiff_t k, int row) const {
    return t.link[(k * kSpaceLinkRows + row) * t.lanes + lane];
  }
  [[nodiscard]] Vec body_vector(std::ptrdiff_t i, int row) const {
    return {body(i, row), body(i, row + 1), body(i, row + 2)};
  }
  [[nodiscard]] Vec still_vector(std::ptrdiff_t i, int row) const {
    return {still(i, row), still(i, row + 1), still(i, row + 2)};
  }
  void store_body_vector(const Vec& v, std::ptrdiff_t i, int row) const {
    body(i, row) = v.x, body(i, row + 1) = v.y, body(i, row + 2) = v.z;
  }
  void store_still_vector(const Vec& v, std::ptrdiff_t i, int row) const {
    still(i, row) = v.x, still(i, row + 1) = v.y, still(i, row + 2) = v.z;
  }
  // Column c of a row of four.
  [[nodiscard]] double& column_of(double* rows, std::ptrdiff_t e, int c) const {
    return rows[(4 * e + c) * t.lanes + lane];
  }
  // Its first three columns.
  [[nodiscard]] Vec vector(double* rows, std::ptrdiff_t e) const {
    return {column_of(rows, e, 0), column_of(rows, e, 1), column_of(rows, e, 2)};
  }
  void store_vector(const Vec& v, double* rows, std::ptrdiff_t e) const {
    column_of(rows, e, 0) = v.x, column_of(rows, e, 1) = v.y, column_of(rows, e, 2) = v.z;
  }
  [[nodiscard]] Vec force(std::ptrdiff_t row) const { return vector(t.force, row); }
  [[nodiscard]] bool is_driven_support(std::int32_t support) const {
    return column_of(t.support, support, kDriven) > 0;
  }
  [[nodiscard]] Vec shift(std::ptrdiff_t i) const { return vector(t.shift, i); }
  [[nodiscard]] Quaternion<double> turn(std::ptrdiff_t i) const {
    return {column_of(t.shift, i, 3), vector(t.turn, i)};
  }
  [[nodiscard]] double& wall_value(int row) const { return t.wall[row * t.lanes + lane]; }
  [[nodiscard]] Vec gravity() const {
    return {wall_value(kGravity), wall_value(kGravity + 1), wall_value(kGravity + 2)};
  }
  [[nodiscard]] std::int32_t& special(std::ptrdiff_t i) const {
    return t.special[layout->grouped() ? i / kGroup : i];
  }
};

[[nodiscard]] WallView view_of(const Layout& layout, const Model& model, const Tables& tables,
                               int lane);
// Loads a wall into a lane: its own numbers and its state. Its time step is still to be set.
void load_lane(const WallView& wall, const Model& model, const State& state);
// For a wall alone in its tables with stages that cut blocks out. Joints and links of blocks that
// do not stand in the state's stage get no force, and these blocks keep still (as in the plane).
void stand(const WallView& wall, const Model& model, const State& state);
// Only keeps those blocks still, after a drive has chosen its blocks.
void hold_still(const WallView& wall, const Model& model, int stage);
// Sets the forces that hold the neighbours of cut-out blocks, at `share` (23.2).
void release(const WallView& wall, const State& state, double share);
// Stores motion and history of a lane into the state's arrays.
void store_lane(const WallView& wall, const Model& model, State& state);

[[nodiscard]] Inertia<double> inertia_of(std::ptrdiff_t i, const WallView& wall);
// Pose of block i in the step before (turning.h).
[[nodiscard]] contact::Pose<double> pose_before(std::ptrdiff_t i, const WallView& wall);
void set_rates(const WallView& wall, double dt, double mass_scaling);
// Marks the blocks that the drive moves.
void choose_driven(const WallView& wall, const std::vector<BlockId>& blocks);
void clear_load(BlockId block, const WallView& wall);
void add_load(const PointLoad& load, double scale, const WallView& wall);

// Adds the forces of all links in the present pose. `set`: the present share of their
// prestress. `jacked`: the share of the jacks' force, below 0 where no jack works.
[[nodiscard]] LinkWork add_link_forces(const WallView& wall, double set, double jacked);

// Moves the driven blocks, or supports, and returns the reaction [N].
[[nodiscard]] double drive(const Stage& push, const WallView& wall, double velocity,
                           WallWork& work);

// The meters (sums.h). Forces count as vectors, so that axes have no influence.
[[nodiscard]] double unbalance_of(const WallView& wall, const Model& model, const ZoneRun* zones);
[[nodiscard]] double kinetic_of(const WallView& wall, double mass_scaling);
// Base shear of the supports that no stage drives, to compare with the force of a drive.
[[nodiscard]] double shear_of(const WallView& wall, const Model& model, const Vec3& along);
[[nodiscard]] BlockId runaway_of(const WallView& wall);
[[nodiscard]] Furthest furthest_of(const WallView& wall);

}  // namespace wythe::dynamics::space
