// Bare walls: one step of a plane wall in the paper's law, by hand, with no engine around it. They
// are the limit the engine is held to, and do as little as the equations allow:
//
//   tables by joint and by block, what is used together side by side, in the order of use
//   walls: a block moves soon after its last joint, while it is in the cache
//   a joint at rest (closed, sticking, damaged and crushed no further) costs five rows a point, writes
//   no history, and has no branch but the one that says so
//   a face lies along its tangent: with delta = tb - ta its growth is d = 2 |e| sin(delta/2) n and the
//   mean of its two directions cos(delta/2) |e| t, so that both its points slip alike
//
// Two shapes: walls side by side, one a lane, and one wall in packs of joints. Arrays are filled in
// bare_wall.cpp; the steps are templates over the instruction set (bare_packs.h).
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "dynamics/passes/tables.h"
#include "wythe/parts/model.h"

namespace wythe::bench {

// Rows of a block in a wall of many.
enum BlockRow {
  // pose: displacement [m], cos theta - 1, sin theta, cosine and sine of theta/2
  kUx,
  kUy,
  kDrop,
  kSine,
  kCos,
  kSin,
  // forces: start at the load, joints add [N], [N m]
  kFx,
  kFy,
  kMoment,
  // motion [rad], [m/s], [rad/s]
  kTheta,
  kVx,
  kVy,
  kOmega,
  // mobility: dt/m, dt/I; 0 where the block is held
  kRate,
  kTurnRate,
  // weight and dead loads
  kLoadX,
  kLoadY,
  kLoadMoment,
  kBlockRows
};
// Rows of a material.
enum LawRow {
  kKn,
  kKs,
  kInvKs,
  kInvKn,
  kFt,
  kLeftAtNone,
  kLeftRate,
  kCRes,
  kCDrop,
  kTanRes,
  kTanDrop,
  kHalfInvGII,
  kTwoGII,
  kFc,
  kPFull,
  kInvPFull,
  kCrushGain,
  kLawRows
};
// Rows of a point, of which a joint has two. Hot: what is asked of a point at rest.
enum HotRow {
  kCrush,         // p [m]
  kCrushesBelow,  // opening at which -kn (w + p) = fc(p) [m]
  kLeft,          // (1 - dt) (1 - ds)
  kPlastic,       // [m]
  kDamagedFrom,   // shear strength above the residual at which the slip so far damages more [Pa]
  kHotRows
};
enum ColdRow { kKappa, kSlip, kShear, kColdRows };
// Rows of a wall: time step, damping, ledger; the last two in units of dt/2.
enum WallRow { kDt, kDamping, kFriction, kFracture, kCrushing, kLoads, kDamped, kWallRows };

struct BareJoint {
  std::int32_t a, b, material;  // a = -1: the ground
  std::int32_t moved;           // this many blocks, in order, have moved when it is done
  double ax, ay, bx, by, tx, ty, half, share;
};
inline constexpr int kChains = 12;
inline constexpr int kGeometryRows = 8;  // of a BareJoint, from ax on
// A dead load that follows its block.
struct BareLoad {
  std::int32_t block;
  double arm_x, arm_y, fx, fy;
};

// Walls side by side, one a lane: row r of entity i lies at (i rows + r) lanes.
struct BareWalls {
  int n_joint, n_load;
  const BareJoint* joint;
  const std::int32_t* order;  // blocks as they move
  const BareLoad* load;
  const double* law;
  double *hot, *cold, *block, *wall;
  unsigned char* busy;  // of a joint: a point was not at rest
};

// One wall: packs of as many joints of one material as there are lanes.
struct BareGroup {
  std::int32_t first, last, material;  // packs
  bool on_ground;
};
struct BareJoints {
  int n_block, n_group, n_load;
  const BareGroup* group;
  const std::int32_t *a, *b;  // (packs, lanes)
  const double* geometry;     // (packs, kGeometryRows, lanes)
  const BareLoad* load;
  const double* law;
  double *hot, *cold;  // (packs, 2, rows, lanes)
  unsigned char* busy;
  double* force;                               // rows fx, fy, ma, mb (packs, lanes, 4)
  const std::int32_t *begin, *middle, *entry;  // joints of each block: as side a, then as side b
  double* pose;              // rows ux, uy, cos, sin; the ground's and nobody's are the last two
  double *place, *velocity;  // rows x, y, theta, 0
  const double* rate;        // rows dt/m, dt/m, dt/I, 0
  double* weight;            // rows x, y, moment, 0 of weight and dead loads
  double* wall;
};

// The steps of one instruction set, and what its units can do.
struct BareKernels {
  const char* name;
  int lanes;
  void (*walls)(const BareWalls&);
  void (*joints)(const BareJoints&);
  double (*multiply_add)(std::int64_t rounds);  // kChains multiplications and additions a lane
  double (*fused)(std::int64_t rounds);         // the same in fused operations; null: has none
};
[[nodiscard]] const BareKernels& bare_scalar();
#if defined(__x86_64__)
[[nodiscard]] const BareKernels& bare_sse2();
[[nodiscard]] const BareKernels& bare_avx2();
[[nodiscard]] const BareKernels& bare_avx512();
#endif
// All this processor has, narrowest first.
[[nodiscard]] std::vector<const BareKernels*> bare_here();

// What bare walls start from: the paper's law, two points a face, no zones; `held` blocks stand still.
struct BareStart {
  const Model& model;
  const State& state;
  double dt, damping;
  const std::vector<BlockId>& held;
};

// The rows of all materials, `lanes` times each.
[[nodiscard]] dynamics::Lines<double> law_rows(const Model& model, int lanes);

// As many equal walls as the set has lanes.
class BareWallsRun {
 public:
  BareWallsRun(const BareStart& start, const BareKernels& kernels);
  void step() { kernels_.walls(view_); }
  [[nodiscard]] State state(int lane) const;  // motion, history, and the ledger since the start
  [[nodiscard]] double bytes_per_point() const;
  [[nodiscard]] double busy_share() const;  // of the joints

 private:
  const BareKernels& kernels_;
  const State start_;
  std::vector<BareJoint> joint_;
  std::vector<JointId> joint_of_;  // the model's
  std::vector<std::int32_t> order_;
  std::vector<BareLoad> load_;
  dynamics::Lines<double> law_, hot_, cold_, block_, wall_;
  std::vector<unsigned char> busy_;
  BareWalls view_;
};

// One wall, packs of joints.
class BareJointsRun {
 public:
  BareJointsRun(const BareStart& start, const BareKernels& kernels);
  void step() { kernels_.joints(view_); }
  [[nodiscard]] State state() const;
  [[nodiscard]] double bytes_per_point() const;

 private:
  void add_pack(const Model& m, const std::vector<JointId>& joints);

  const BareKernels& kernels_;
  const State start_;
  std::vector<BareGroup> group_;
  std::vector<JointId> joint_of_;  // the model's; -1: nobody
  std::vector<std::int32_t> a_, b_, begin_, middle_, entry_;
  std::vector<BareLoad> load_;
  dynamics::Lines<double> geometry_, law_, hot_, cold_, force_, pose_, place_, velocity_, rate_,
      weight_;
  dynamics::Lines<double> wall_;
  std::vector<unsigned char> busy_;
  BareJoints view_;
};

}  // namespace wythe::bench
