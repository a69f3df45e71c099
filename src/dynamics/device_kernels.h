// The step of walls side by side as one function a wall and entity, for a machine with thousands of
// threads: on(i, wall) of each struct is what one thread does. The laws and passes are those of
// forces.h, blocks.h, zones.h, wall_pass.h and wall_sums.h, with the same bits; only the work of
// joints and blocks is summed over time first and over the wall when somebody asks, so that the
// energy ledger agrees to rounding.
//
// A wall whose time step is 0 waits: its history stays as it is, and the forces in its lane may be
// another's, not even numbers.
//
// Everything here is plain pointers into the device's memory, copied with the struct.
#pragma once

#include "dynamics/blocks.h"
#include "dynamics/forces.h"
#include "dynamics/shifted.h"
#include "dynamics/wall_pass.h"
#include "dynamics/wall_sums.h"
#include "dynamics/zones.h"

namespace wythe::dynamics::device {

// The numbers of a law; its choice is the same in all walls and stands apart.
inline constexpr int kLawRows = offsetof(contact::LawConstants<double>, choice) / sizeof(double);

// Rows of `walls` numbers that every step brings along; load_scale of each stage follows.
enum Row { kDt, kDamping, kScale, kGravityX, kGravityY, kVelocity, kAimX, kAimY, kRows };

// Work of entity i of each wall since it took its lane [J].
struct WorkRows {
  double* rows;
  int n_row;
  std::ptrdiff_t walls;
  WYTHE_INLINE void add(std::size_t i, int wall, int row, double work) const {
    if (work != 0) rows[(static_cast<std::ptrdiff_t>(i) * n_row + row) * walls + wall] += work;
  }
  WYTHE_INLINE void add(std::size_t i, int wall, const JointWork<double>& w) const {
    add(i, wall, 0, w.friction);
    add(i, wall, 1, w.fracture);
    add(i, wall, 2, w.crushing);
  }
  WYTHE_INLINE void add(std::size_t i, int wall, const BlockWork<double>& w) const {
    add(i, wall, 0, w.loads);
    add(i, wall, 1, w.damping);
  }
};

// Constants of the materials' laws, (n_material, kLawRows, walls).
struct LawRows {
  const double* rows;
  const contact::LawChoice* choice;  // (n_material)
  std::ptrdiff_t walls;
  WYTHE_INLINE contact::LawConstants<double> at(int material, int wall) const {
    const double* row = rows + static_cast<std::ptrdiff_t>(material) * kLawRows * walls + wall;
    const auto next = [&](auto) {
      const double value = *row;
      row += walls;
      return value;
    };
    return law_by<double>(choice[material], next);
  }
};

template <class V, bool on_ground>
struct Joints {
  JointArrays v;
  const std::int32_t* material;
  LawRows law;
  WorkRows work;
  const double* dt;
  std::size_t begin;
  WYTHE_INLINE void on(std::size_t i, int wall) const {
    if (dt[wall] == 0) return;
    const std::size_t j = begin + i;
    const JointArrays mine = shifted(v, wall);
    const Walls<double> access{law.walls};
    JointWork<double> done{0, 0, 0};
    if constexpr (on_ground)
      ground_force<V, 2>(mine, access, law.at(material[j], wall), j, done);
    else
      pair_force<V, 2>(mine, access, law.at(material[j], wall), j, done);
    work.add(j, wall, done);
  }
};

struct Zones {
  ZoneArrays v;
  const ZoneShape* shapes;
  const std::int32_t* shape;
  std::ptrdiff_t walls;
  WYTHE_INLINE void on(std::size_t z, int wall) const {
    zone_run(shifted(v, wall), Walls<double>{walls}, shapes[shape[z]], z, z + 1);
  }
};

template <class V>
struct Edges {
  EdgeArrays v;
  const std::int32_t* material;
  LawRows law;
  WorkRows work;
  const double* dt;
  std::size_t begin, first_work;
  WYTHE_INLINE void on(std::size_t i, int wall) const {
    if (dt[wall] == 0) return;
    const std::size_t c = begin + i;
    JointWork<double> done{0, 0, 0};
    edge_force<V>(shifted(v, wall), Walls<double>{law.walls}, law.at(material[c], wall), c, done);
    work.add(first_work + c, wall, done);
  }
};

struct Gather {
  GatherArrays v;
  std::ptrdiff_t walls;
  WYTHE_INLINE void on(std::size_t i, int wall) const {
    gather_run(shifted(v, wall), Walls<double>{walls}, i, i + 1);
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
};

// Zone contacts and loads of one wall, in order.
struct ContactsAndLoads {
  WallView view;  // of wall 0
  const BlockId* contact_block;
  int n_block, n_contact;
  const WallStage* stage;
  const double* load_scale;  // (n_stage, walls)
  std::ptrdiff_t walls;
  WYTHE_INLINE void on(std::size_t, int wall) const {
    const WallView mine = shifted(view, wall);
    for (int c = 0; c < n_contact; ++c)
      gather_contact(contact_block, n_block, view.contact_block_force.first, view.contact_x.first,
                     view.contact_y.first, view.contact_m.first, c, walls, wall);
    const StageLoad* const first = stage[wall].loads;
    const int n = stage[wall].n_load;
    for (int k = 0; k < n; ++k) {
      const BlockId i = first[k].load.block;
      mine.load_x[i] = mine.load_y[i] = mine.load_m[i] = 0;
    }
    for (int k = 0; k < n; ++k) {
      const double scale = load_scale[first[k].stage * walls + wall];
      if (scale != 0) add_load(first[k].load, scale, mine);
    }
  }
};

struct Move {
  BlockArrays v;
  MoveControls controls;
  WorkRows work;
  WYTHE_INLINE void on(std::size_t i, int wall) const {
    if (controls.dt[wall] == 0) return;
    BlockWork<double> done{0, 0};
    move_block(shifted(v, wall), Walls<double>{work.walls}, shifted(controls, wall), i, done);
    work.add(i, wall, done);
  }
};

struct Nodes {
  NodeArrays v;
  NodeSums sums;
  MoveControls controls;
  WorkRows work;
  std::size_t first_work;
  WYTHE_INLINE void on(std::size_t i, int wall) const {
    if (controls.dt[wall] == 0) return;
    sum_on_node(sums, i, work.walls, wall);
    BlockWork<double> done{0, 0};
    move_node(shifted(v, wall), Walls<double>{work.walls}, shifted(controls, wall), i, done);
    work.add(first_work + i, wall, done);
  }
};

struct Turn {
  BlockArrays v;
  std::ptrdiff_t walls;
  WYTHE_INLINE void on(std::size_t i, int wall) const {
    turn_run(shifted(v, wall), Walls<double>{walls}, i, i + 1);
  }
};

// The driven blocks of one wall; afterwards its reaction and work, rows (4, walls).
struct DriveWalls {
  WallView view;
  WallSizes sizes;
  const WallStage* stage;
  const double* rows;  // Row
  double* answer;      // reaction [N]; work of drive, damping, loads [J]
  std::ptrdiff_t walls;
  WYTHE_INLINE void on(std::size_t, int wall) const {
    const Drive& drive = stage[wall].drive;
    answer[wall] = 0;
    if (drive.n == 0) return;
    double* work = answer + walls + wall;
    WallWork done{work[0], work[walls], work[2 * walls]};
    const WallSizes n = shifted(sizes, wall);
    answer[wall] =
        drive_blocks(drive, shifted(view, wall), n.mass, n.inertia, rows[kDt * walls + wall],
                     rows[kDamping * walls + wall], rows[kVelocity * walls + wall], done);
    work[0] = done.drive;
    work[walls] = done.damping;
    work[2 * walls] = done.loads;
  }
};

// What is asked about walls between steps; kinetic energy without mass scaling.
enum Ask { kUnbalance, kKinetic, kShear, kDistance, kFurthest, kRunaway, kAsks };

// Answers `ask` for all walls; answers (kAsks, walls).
struct LookAt {
  WallView view;
  WallSizes sizes;
  const double* rows;
  double* answers;
  std::ptrdiff_t walls;
  Ask ask;
  WYTHE_INLINE void on(std::size_t, int wall) const {
    const WallView mine = shifted(view, wall);
    const WallSizes n = shifted(sizes, wall);
    double* answer = answers + ask * walls + wall;
    if (ask == kUnbalance) *answer = unbalance_of(n, mine);
    if (ask == kKinetic) *answer = kinetic_of(n, mine, 1.0);
    if (ask == kShear)
      *answer = shear_of(n, mine, rows[kAimX * walls + wall], rows[kAimY * walls + wall]);
    if (ask == kDistance) {
      const Furthest found = furthest_of(n, mine);
      answer[0] = found.distance;
      answer[walls] = found.block;
    }
    if (ask == kRunaway) *answer = runaway_of(n, mine);
  }
};

// Copies between the lane of one wall in several arrays and one row after the other.
struct Columns {
  static constexpr int kMost = 32;
  double* array[kMost];
  std::size_t begin[kMost + 1];
  int n = 0;
  std::ptrdiff_t walls;
  int lane;
  double* flat;
  bool out;
  WYTHE_INLINE void on(std::size_t i, int) const {
    int a = 0;
    while (i >= begin[a + 1]) ++a;
    double& there = array[a][static_cast<std::ptrdiff_t>(i - begin[a]) * walls + lane];
    if (out)
      flat[i] = there;
    else
      there = flat[i];
  }
};

// Work of one wall in kParts parts of its joints and blocks (5, kParts); adding them is the host's.
struct SumWork {
  static constexpr int kParts = 64;
  WorkRows joints, blocks;
  std::size_t n_joint, n_block;  // with zone contacts and nodes
  int lane;
  double* sums;
  WYTHE_INLINE void on(std::size_t part, int) const {
    for (int row = 0; row < 5; ++row) {
      const WorkRows& from = row < 3 ? joints : blocks;
      const std::size_t n = row < 3 ? n_joint : n_block;
      const int r = row < 3 ? row : row - 3;
      double sum = 0;
      for (std::size_t i = part; i < n; i += kParts)
        sum += from.rows[(static_cast<std::ptrdiff_t>(i) * from.n_row + r) * from.walls + lane];
      sums[row * kParts + static_cast<int>(part)] = sum;
    }
  }
};

}  // namespace wythe::dynamics::device
