// One wall of the tables, for code that handles a single wall: drive, loads, meters, copies of its state.
#pragma once

#include "dynamics/passes/tables.h"
#include "model/fields.h"

namespace wythe::dynamics {

// Entities that fill up a group of neighbours carry
// nothing and do not move, so sums may include them.
struct WallView {
  Tables t;
  std::ptrdiff_t lane = 0;
  int shift = 0, mask = 0;  // of an entity's number: its group, its place in it
  int blocks = 0, joints = 0, first_ground = 0, nodes = 0, edges = 0;
  int links = 0;                  // without those that fill up a group
  int linked = 0;                 // rows of forces of links, with those that fill up a group
  int frames = 0;                 // sections of frames, without those that fill up
  int layers = 0, crossings = 0;  // nodes of layers and where their fibres cross joints, likewise
  int first_crossing = 0;         // row of forces of the first
  int moving_blocks = 0;          // of the model: nodes are numbered behind them
  int first_free = -1;  // row of forces of block 0's free contacts, the ground's last; -1: none

  WYTHE_INLINE double& number(double* table, int rows, std::ptrdiff_t e, int row) const {
    const std::ptrdiff_t width = mask != 0 ? kGroup : t.lanes;
    return table[((e >> shift) * rows + row) * width + (e & mask) + lane];
  }
  WYTHE_INLINE double& block(std::ptrdiff_t i, BlockRow row) const {
    return number(t.block, kBlockRows, i, row);
  }
  WYTHE_INLINE double& cold(std::ptrdiff_t i, ColdRow row) const {
    return number(t.cold, kColdRows, i, row);
  }
  WYTHE_INLINE double& node(std::ptrdiff_t i, NodeRow row) const {
    return number(t.node, kNodeRows, i, row);
  }
  WYTHE_INLINE double& link(std::ptrdiff_t k, LinkRowName row) const {
    return number(t.link, kLinkRows, k, row);
  }
  WYTHE_INLINE double& frame(std::ptrdiff_t k, FrameRowName row) const {
    return number(t.frame, kFrameRows, k, row);
  }
  WYTHE_INLINE double& layer(std::ptrdiff_t k, LayerRowName row) const {
    return number(t.layer, kLayerRows, k, row);
  }
  WYTHE_INLINE double& ux(std::ptrdiff_t i) const { return column_of(t.pose, i, 0); }
  WYTHE_INLINE double& uy(std::ptrdiff_t i) const { return column_of(t.pose, i, 1); }
  WYTHE_INLINE std::int32_t& special(std::ptrdiff_t i) const { return t.special[i >> shift]; }
  // Column c of a row of four.
  WYTHE_INLINE double& column_of(double* rows, std::ptrdiff_t e, int c) const {
    return rows[(4 * e + c) * t.lanes + lane];
  }
  WYTHE_INLINE double& wall_value(WallRow row) const { return t.wall[row * t.lanes + lane]; }
};

[[nodiscard]] WallView view_of(const Layout& layout, const Model& model, const Tables& tables,
                               int lane);

// Loads a wall into a lane: its own numbers and its state. Its time step is still to be set.
void load_lane(const Layout& layout, const Tables& tables, int lane, const Model& model,
               const State& state);
// For a wall alone in its tables with stages that cut openings. Joints and sections of
// blocks that do not stand in the state's stage get no force, and these blocks keep still.
void stand(const Layout& layout, const Tables& tables, const Model& model, const State& state);
// Only keeps those blocks still, after a drive has chosen its blocks.
void hold_still(const WallView& wall, const Model& model, int stage);
// Stores motion and history of a lane into the state's arrays.
void store_lane(const Layout& layout, const Tables& tables, int lane, const Model& model,
                State& state);
// Sets the pose of every block from its displacement and rotation.
void turn_all(const WallView& wall);

// Sets the factors of a step: dt over each mass.
WYTHE_INLINE void set_rates(const WallView& wall, double dt, double mass_scaling) {
  const auto rate = [&](double mass) { return mass > 0 ? dt / (mass * mass_scaling) : 0; };
  for (int i = 0; i < wall.blocks; ++i) {
    wall.block(i, kRate) = rate(wall.cold(i, kMass));
    wall.block(i, kTurnRate) = rate(wall.cold(i, kInertia));
  }
  for (int i = 0; i < wall.nodes; ++i) wall.node(i, kNodeRate) = rate(wall.node(i, kNodeMass));
}

// Marks the blocks that the drive moves.
inline void choose_driven(const WallView& wall, const std::vector<BlockId>& blocks) {
  for (int i = 0; i < wall.blocks; ++i) {
    wall.block(i, kIsFree) = 1;
    wall.cold(i, kUnbalanced) = 0;
  }
  for (const BlockId block : blocks) wall.block(block, kIsFree) = 0;
}

}  // namespace wythe::dynamics
