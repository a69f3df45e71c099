// Where the numbers of a step in space lie: tables of rows as in the plane (passes/tables.h), for one wall or
// for walls side by side. Groups, chunks and paths are the same. Only the rows of bodies and faces differ.
#pragma once

#include <cstdint>
#include <vector>

#include "dynamics/passes/tables.h"

namespace wythe::dynamics::space {

// Rows of a joint face: arms to its centre, t1 and n at the start, area.
enum FaceRow { kArmA, kArmB = 3, kTangent = 6, kNormal = 9, kFaceArea = 12, kFaceRows };
// Rows of a point: its place on the face, its share of the area.
enum PointRow { kR1, kR2, kShare, kPointRows };
// Rows of a body; displacement and turn are rows of four.
enum BodyRow {
  kV,                 // velocity at the half step
  kL = 3,             // angular momentum there
  kMassRate = 6,      // dt / (mass mass_scaling), 0 where nothing moves
  kInverse,           // 1 / (inertia mass_scaling) about the principal axes
  kGravityMass = 10,  // mass for the weight
  kFree,              // 0: moved by the drive
  kLoad,              // dead loads
  kLoadMoment = 15,   //
  kBodyRows = 18
};
// Rows of a body that only drive and meters read.
enum StillRow {
  kBodyMass,
  kBodyInertia,       // about the principal axes
  kContact = 4,       // force of its joints: driven blocks only
  kTotal = 7,         // with weight and loads
  kTotalMoment = 10,  //
  kLacking = 13,      // of blocks driven in a pattern
  kStillRows
};
// Last of the four of a support: 1 while a stage drives it.
inline constexpr int kDriven = 3;
// Rows of a link beside those of the plane: the third components.
enum LinkRow { kLinkArmAZ = kLinkRows, kLinkArmBZ, kLinkSpanZ, kSpaceLinkRows };
inline constexpr int kAxisRows = 9;  // three principal axes at the start

struct Tables {
  std::ptrdiff_t lanes = 1;
  int n_block = 0;                // number of the resting pose
  bool damps_components = false;  // local damping of each component in the wall's axes

  // the same for all walls
  double *face = nullptr, *point = nullptr, *axes = nullptr;
  std::int32_t *joint_a = nullptr, *joint_b = nullptr;  // poses; side a on a support: its number
  std::int32_t *block_begin = nullptr, *block_middle = nullptr, *block_entry = nullptr;
  std::int32_t *link_a = nullptr, *link_b = nullptr;  // poses of the two ends
  std::int32_t* special =
      nullptr;  // of an item: a stage of some wall loads or drives one of its blocks

  // for each wall
  double *law = nullptr, *body = nullptr, *still = nullptr, *history = nullptr, *wall = nullptr;
  double *shift = nullptr, *turn = nullptr;  // rows of four: u and w of the turn; its x, y, z
  double* support = nullptr;  // rows of four: displacement and kDriven; the last is at rest
  double* link = nullptr;     // (links, kSpaceLinkRows)
  double *force = nullptr, *moment_a = nullptr,
         *moment_b =
             nullptr;  // rows of four: joints, links, frames, free contacts, contacts of zones
  // of walls with dashpots only (dashpots.h)
  double *dashpot = nullptr,
         *element = nullptr;  // (joints, kDashpotRows), (points, kMaxwellRowsInSpace)
  double *velocity = nullptr, *spin_rate = nullptr;  // rows of four: of blocks before the step
  double* support_velocity = nullptr;                // rows of four; the last is at rest
  double *viscous_force = nullptr, *viscous_moment_a = nullptr,
         *viscous_moment_b = nullptr;  // rows of four as `force`: the share of dashpots
  std::uint8_t* law_path = nullptr;
};
// Numbers of a wall that every step sets. kTimeBefore as in the plane; kSupportStep: how far driven supports move. From
// kHasDashpots on as in the plane, only for walls with dashpots.
enum WallRow {
  kStep,
  kLambda,
  kGravity,
  kTimeBefore = 5,
  kSupportStep,
  kHasDashpots = kSupportStep + 3,
  kRebounds,
  kElementKept,
  kElementGain,
  kWallRows
};

struct Layout {
  Layout(const Model& model, dynamics::Layout::Kind kind);

  dynamics::Layout::Kind kind;
  std::vector<Chunk> joints, blocks;      // Chunk::rule: the first of its points in `point`
  std::vector<std::int32_t> joint_place;  // of joint j
  std::int32_t n_joint = 0, n_block = 0;  // with those that fill up groups
  std::int32_t n_link = 0, n_frame = 0, n_contact = 0;
  std::int32_t first_frame = 0;    // row of forces of the first section of frames
  std::int32_t first_contact = 0;  // row of forces of the first contact of zones
  std::int32_t history = 0, points = 0, laws = 0;
  std::int32_t damped = 0, elements = 0;  // joints with dashpots; numbers of Maxwell elements

  [[nodiscard]] bool grouped() const { return kind == dynamics::Layout::kNeighbours; }
  [[nodiscard]] int group() const { return grouped() ? kGroup : 1; }
  // Index of row r of entity e in a table of `rows`.
  [[nodiscard]] std::ptrdiff_t number(std::ptrdiff_t e, int rows, int row,
                                      std::ptrdiff_t walls) const {
    if (!grouped()) return (e * rows + row) * walls;
    return (e / kGroup * rows + row) * kGroup + e % kGroup;
  }
  // Index of row `row` of `rows` of point k of entity n of a chunk; `first` is the first index of the chunk.
  [[nodiscard]] std::ptrdiff_t point_number(const Chunk& chunk, std::ptrdiff_t first, int n, int k,
                                            int rows, int row, std::ptrdiff_t walls) const {
    const std::ptrdiff_t number = first + (n / group() * chunk.points + k) * rows + row;
    return grouped() ? number * kGroup + n % kGroup : number * walls;
  }
};

struct Memory {
  std::vector<double> numbers;
  std::vector<std::int32_t> ids;
  std::vector<std::uint8_t> law_paths;
};

// Tables with the data that all walls share. Every wall is at rest and has no law.
[[nodiscard]] Tables make_tables(const Layout& layout, const Model& model, int walls,
                                 Memory& memory);

}  // namespace wythe::dynamics::space
