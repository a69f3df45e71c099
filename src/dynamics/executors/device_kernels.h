// What one thread of a device does: on(i, wall) of each struct, for entity i of one wall. The passes are
// those of every executor (passes/*.h), with the same bits; only works of joints and blocks are summed over
// time first and over the wall when somebody asks, so that the energy ledger agrees to rounding.
//
// A wall whose time step is 0 waits: its history stays as it is, and the forces in its lane may be
// another's, not even numbers. Everything here is plain pointers into the device's memory.
#pragma once

#include "dynamics/passes/drive.h"
#include "dynamics/passes/joints.h"
#include "dynamics/passes/links.h"
#include "dynamics/passes/solids.h"
#include "dynamics/passes/sums.h"

namespace wythe::dynamics::device {

using Access = WallLanes<double, 0>;

// Work of entity i of each wall since it took its lane [J], rows of `terms` numbers.
struct Works {
  double* rows;
  int terms;
  std::ptrdiff_t walls;
  WYTHE_INLINE void add(std::ptrdiff_t i, int wall, int term, double work) const {
    if (work != 0) rows[(i * terms + term) * walls + wall] += work;
  }
  WYTHE_INLINE void add(std::ptrdiff_t i, int wall, const JointWork<double>& w) const {
    add(i, wall, 0, w.friction);
    add(i, wall, 1, w.fracture);
    add(i, wall, 2, w.crushing);
  }
  WYTHE_INLINE void add(std::ptrdiff_t i, int wall, const BlockWork<double>& w) const {
    add(i, wall, 0, w.loads);
    add(i, wall, 1, w.damping);
  }
  WYTHE_INLINE void add(std::ptrdiff_t, int, const NoWork&) const {}
};

// A pass over a chunk.
template <class P>
struct RunPass {
  Tables t;
  Chunk chunk;
  Works works;  // of the pass's first entity
  WYTHE_INLINE void on(std::size_t i, int wall) const {
    if (t.wall[kDt * t.lanes + wall] == 0) return;
    const P pass(t, Access{t.lanes, wall}, chunk);
    typename P::Work done{};
    const std::ptrdiff_t spot = chunk.begin + static_cast<std::ptrdiff_t>(i);
    pass.at(spot, done);
    works.add(spot, wall, done);
  }
};

// A load of one wall and the stage it belongs to.
struct StageLoad {
  PointLoad load;
  int stage;
};
// What a wall's stages load and the one under way drives; addresses of the device.
struct WallStage {
  const StageLoad* loads;
  int n_load;
  Drive drive;  // n 0: nothing is driven
  double velocity;
  bool new_rates;  // time step or masses have changed
  double mass_scaling;
  double links_set;  // share of their prestress
};

// Dead loads of one wall, in order.
struct PlaceLoads {
  WallView view;  // of wall 0
  const WallStage* stage;
  const double* load_scale;  // (n_stage, walls)
  WYTHE_INLINE void on(std::size_t, int wall) const {
    WallView mine = view;
    mine.lane = wall;
    const StageLoad* const first = stage[wall].loads;
    const int n = stage[wall].n_load;
    for (int k = 0; k < n; ++k) clear_load(first[k].load.block, mine);
    for (int k = 0; k < n; ++k) {
      const double scale = load_scale[first[k].stage * view.t.lanes + wall];
      if (scale != 0) add_load(first[k].load, scale, mine);
    }
  }
};

// The links of one wall; their works so far in rows 4 and 5 of its answers.
struct PullLinks {
  WallView view;  // of wall 0
  const WallStage* stage;
  double* answer;
  WYTHE_INLINE void on(std::size_t, int wall) const {
    WallView mine = view;
    mine.lane = wall;
    if (mine.of_wall(kDt) == 0) return;
    const LinkWork work = pull_links(mine, stage[wall].links_set);
    answer[4 * view.t.lanes + wall] += work.dissipated;
    answer[5 * view.t.lanes + wall] += work.tensioned;
  }
};

// Rates of all blocks and nodes of a wall whose controls have changed.
struct SetRates {
  WallView view;
  const WallStage* stage;
  WYTHE_INLINE void on(std::size_t, int wall) const {
    if (!stage[wall].new_rates) return;
    WallView mine = view;
    mine.lane = wall;
    set_rates(mine, mine.of_wall(kDt), stage[wall].mass_scaling);
  }
};

// The driven blocks of one wall; afterwards its reaction and work, the first 4 of kAnswers rows.
struct DriveWalls {
  WallView view;
  const WallStage* stage;
  double* answer;  // reaction [N]; work of drive, damping, loads [J]
  WYTHE_INLINE void on(std::size_t, int wall) const {
    const std::ptrdiff_t walls = view.t.lanes;
    const Drive& drive = stage[wall].drive;
    answer[wall] = 0;
    if (drive.n == 0) return;
    WallView mine = view;
    mine.lane = wall;
    double* work = answer + walls + wall;
    WallWork done{work[0], work[walls], work[2 * walls]};
    answer[wall] = drive_blocks(drive, mine, stage[wall].velocity, done);
    work[0] = done.drive;
    work[walls] = done.damping;
    work[2 * walls] = done.loads;
  }
};

inline constexpr int kAnswers = 6;

// What is asked about walls between steps; kinetic energy without mass scaling.
enum Ask { kUnbalance, kKinetic, kShear, kDistance, kFurthest, kRunaway, kMoved, kAsks };

// Answers `ask` for all walls; answers (kAsks, walls), directions of base shear (2, walls).
struct LookAt {
  WallView view;
  const double* aim;
  const double* watched;  // direction, and the block as a number (3, walls)
  double* answers;
  Ask ask;
  WYTHE_INLINE void on(std::size_t, int wall) const {
    const std::ptrdiff_t walls = view.t.lanes;
    WallView mine = view;
    mine.lane = wall;
    double* answer = answers + ask * walls + wall;
    if (ask == kUnbalance) *answer = unbalance_of(mine);
    if (ask == kKinetic) *answer = kinetic_of(mine, nullptr, nullptr, 1.0);
    if (ask == kShear) *answer = shear_of(mine, aim[wall], aim[walls + wall]);
    if (ask == kDistance) {
      const Furthest found = furthest_of(mine);
      answer[0] = found.distance;
      answer[walls] = found.block;
    }
    if (ask == kRunaway) *answer = runaway_of(mine);
    if (ask == kMoved)
      *answer = moved_along(mine, static_cast<BlockId>(watched[2 * walls + wall]), watched[wall],
                            watched[walls + wall]);
  }
};

// Copies between one lane of the tables and one row of numbers.
struct Column {
  double* lanes;  // (n, walls)
  double* flat;   // (n)
  std::ptrdiff_t walls;
  int lane;
  bool out;
  WYTHE_INLINE void on(std::size_t i, int) const {
    double& there = lanes[static_cast<std::ptrdiff_t>(i) * walls + lane];
    if (out)
      flat[i] = there;
    else
      there = flat[i];
  }
};

// Work of one wall in kParts parts of its entities (terms, kParts); adding them is the host's.
struct SumWorks {
  static constexpr int kParts = 64;
  Works works;
  std::size_t n;
  int lane;
  double* sums;
  WYTHE_INLINE void on(std::size_t part, int) const {
    for (int term = 0; term < works.terms; ++term) {
      double sum = 0;
      for (std::size_t i = part; i < n; i += kParts)
        sum +=
            works.rows[(static_cast<std::ptrdiff_t>(i) * works.terms + term) * works.walls + lane];
      sums[term * kParts + static_cast<int>(part)] = sum;
    }
  }
};

}  // namespace wythe::dynamics::device
