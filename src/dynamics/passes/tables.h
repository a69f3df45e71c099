// Where the numbers of a step lie: tables of rows, one row a quantity, for one wall or many side by side.
//
//   kind         a lane is           row r of entity e, wall k                        used by
//   kNeighbours  an entity of one    ((e / 8) rows + r) 8 + e % 8                     packs of one wall
//                wall: groups of 8
//   kWalls       a wall              (e rows + r) walls + k                           walls side by side
//
// Data that others look up by an entity's number (poses, forces of joints, zones) lie in rows of four, all
// of an entity together: (e 4 + c) walls + k. Joints come in runs with the same law, support and number of
// points. The last group of 8 is filled up with joints between the ground and itself, which carry nothing.
//
// Tables are pointers into one piece of memory for each type.
#pragma once

#include <cstddef>
#include <cstdint>
#include <new>
#include <type_traits>
#include <vector>

#include "contact/law_constants.h"
#include "wythe/parts/zone_shape.h"

namespace wythe {
struct Model;  // kernels do not include it
}

namespace wythe::dynamics {

inline constexpr int kGroup = 8;    // lanes of the widest pack
inline constexpr int kChunk = 256;  // entities of a chunk; fixed, so sums do not depend on threads

// Rows of the geometry of a joint: arms to the face's centre, tangent, half length, area.
enum JointRow {
  kArmAX,
  kArmAY,
  kArmBX,
  kArmBY,
  kTangentX,
  kTangentY,
  kHalfLength,
  kArea,
  kJointRows
};
// Rows of a zone's contact (solids): arms of its two points, their shares on the edge, tangent, area.
enum EdgeRow {
  kArm0X,
  kArm0Y,
  kArm1X,
  kArm1Y,
  kShare0,
  kShare1,
  kEdgeTangentX,
  kEdgeTangentY,
  kEdgeArea,
  kEdgeRows
};
// Rows of a block; its displacements are columns of its pose.
enum BlockRow {
  kTheta,
  kVx,
  kVy,
  kOmega,
  kRate,      // dt / (mass mass_scaling), dt / (inertia mass_scaling)
  kTurnRate,  //
  kGravityMass,
  kIsFree,  // 0: moved by the drive
  kLoadX,   // dead loads [N], [N m]
  kLoadY,
  kLoadM,
  kBlockRows
};
// Rows of a block that only drive and meters read. Forces and totals are set for driven blocks only.
enum ColdRow {
  kMass,
  kInertia,
  kContactX,
  kContactY,
  kTotalX,
  kTotalY,
  kTotalM,
  kUnbalanced,  // of blocks driven in a pattern; 0 of others [N]
  kColdRows
};
enum NodeRow {
  kNodeUx,
  kNodeUy,
  kNodeVx,
  kNodeVy,
  kNodeRate,
  kNodeGravityMass,
  kNodeTotalX,  // forces with gravity, 0 where held [N]
  kNodeTotalY,
  kNodeMass,
  kNodeRows
};
// Rows of the dashpots of a joint: stress per rate of opening, of slip [Pa s/m].
enum DashpotRow { kNormalDashpot, kShearDashpot, kDashpotRows };
// Rows of the Maxwell elements at a point: their stresses [Pa]. In space shear has a second one.
enum MaxwellRow {
  kNormalElement,
  kShearElement,
  kMaxwellRows,
  kSecondShearElement = kMaxwellRows,
  kMaxwellRowsInSpace
};
// Rows of a link: its history, its law, its place.
enum LinkRowName {
  kLinkForce,
  kLinkPlastic,
  kLinkDrawn,
  kLinkStiffness,
  kLinkTension,
  kLinkCompression,
  kLinkPrestress,
  kLinkJack,  // while a jack works, else 0
  kLinkArmAX,
  kLinkArmAY,
  kLinkArmBX,
  kLinkArmBY,
  kLinkSpanX,
  kLinkSpanY,
  kLinkFollows,
  kLinkRows
};
// Rows of a section of a frame: its history, its place, its law.
enum FrameRowName {
  kFrameLeftSet,
  kFrameMiddleSet,
  kFrameRightSet,
  kFrameAlong,
  kFrameAcross,
  kFrameTurn,
  kFrameArmAX,
  kFrameArmAY,
  kFrameArmBX,
  kFrameArmBY,
  kFrameAxisX,
  kFrameAxisY,
  kFrameRestX,
  kFrameRestY,
  kFrameOuter,
  kFrameMiddle,
  kFrameShear,
  kFrameFibre,
  kFrameOuterYield,
  kFrameMiddleYield,
  kFrameRows
};
// Rows of a node of a layer and of the fibres from it to the
// next node: history, values that follow from it, law, place.
enum LayerRowName {
  kLayerSlip,
  kLayerReached,
  kLayerBroken,
  kLayerSecant,   // of its bond, from kLayerReached
  kLayerStretch,  // of the fibres, in this step
  kLayerShift,    // how far the node slips in the step
  kLayerFlex,     // slip per unbalanced force [m/N]
  kLayerStiffness,
  kLayerStrength,
  kLayerEnergy,
  kLayerRate,
  kLayerArmAX,
  kLayerArmAY,
  kLayerArmBX,
  kLayerArmBY,
  kLayerSpanX,
  kLayerSpanY,
  kLayerRows
};
inline constexpr int kHistoryRows = static_cast<int>(contact::kHistory<double>.size());
inline constexpr int kLawRows = static_cast<int>(contact::kConstants<double>.size());
inline constexpr int kStrengths = contact::kStrengths, kOthers = kLawRows - kStrengths;
// Numbers of a wall that every step sets. kTimeBefore: the time in
// which the present velocities have moved the wall. It is the time
// step, unless damping by mass has changed the velocities since.
// From kHasDashpots on: only for walls with dashpots (dashpots.h).
enum WallRow {
  kDt,
  kDamping,
  kGravityX,
  kGravityY,
  kTimeBefore,
  kHasDashpots,  // 1 in a step with dashpots, else 0
  kRebounds,     // 1 where impacts rebound, else 0
  kElementKept,  // of Maxwell elements (MaxwellStep)
  kElementGain,
  kWallRows
};

// Runs of entities for one call of a kernel. A group is 8 neighbours, or a single entity.
struct Chunk {
  std::int32_t begin = 0, end = 0;  // groups
  std::int32_t first = 0, n = 0;    // entities
  std::int32_t material = 0;        // of joints and edges, as stated; of zones their shape
  std::int32_t strengths = 0;       // first row of them in the table of laws
  std::int32_t others = 0;          // the same of the law's other numbers
  std::int32_t points = 0;          // of a face
  std::int32_t rule = 0;            // places of its points: first index into point_xi, point_weight
  std::int32_t rows = 0;            // of history of their law
  std::int32_t history = 0;         // numbers of history, in one lane, before its first group
  std::int32_t elements = -1;       // the same of Maxwell elements; -1: none
  bool on_ground = false;
  bool at_ends = false;        // two points, one at each end of the face
  bool graded = false;         // each group has strengths of its own (a field), not all the same
  bool graded_others = false;  // and other numbers
  contact::LawChoice choice;
};

// Loops of a step with a kernel. A pass is written once (passes/*.h) and listed here.
enum Pass { kJoints, kZones, kEdges, kDashpots, kBlocks, kNodes, kPasses };

// Works of a chunk [J]: kGroup sums of each term for each wall, added up in order.
enum Term { kFriction, kFracture, kCrushing, kLoads, kDamped, kTerms };
struct NoWork {};

struct Tables {
  std::ptrdiff_t lanes = 1;  // walls side by side; 1 for neighbours
  int n_block = 0;           // number of the ground in `pose`

  // the same for all walls
  double *joint, *edge, *turn_freedom, *node_free_x, *node_free_y;
  double *point_xi, *point_weight;
  std::int32_t *joint_a, *joint_b;  // poses of the two sides
  std::int32_t *block_begin, *block_middle,
      *block_entry;                                   // joints of a block: as side a, then as b
  std::int32_t *block_edge_begin, *block_edge_entry;  // zone contacts of a block
  std::int32_t*
      special;  // of a group (item): a stage of some wall loads or drives one of its blocks
  std::int32_t *edge_block, *edge_p, *edge_q;
  std::int32_t *link_a, *link_b;    // poses of the two ends
  std::int32_t *frame_a, *frame_b;  // poses of the two ends of sections
  std::int32_t *layer_a, *layer_b,
      *layer_crossing;  // poses of nodes of layers; row of their force, or -1
  std::int32_t* corner[4];
  std::int32_t *node_zone_begin, *node_zone_entry, *node_edge_begin, *node_edge_entry;
  ZoneShape* shapes;

  // for each wall
  double* law;      // kStrengths rows and kOthers for each chunk, or for each group where they are
                    // graded; for neighbours a number in each lane
  double* block;    // (n_block, kBlockRows); then the ground, at rest
  double* cold;     // (n_block, kColdRows)
  double* pose;     // rows of four: ux, uy, cos theta/2, sin theta/2; the ground's last
  double* history;  // (points, kHistoryRows)
  double* force;    // rows of four: fx, fy on side a, moments on a and b about their centroids;
      // joints, links, frames, crossings of layers, then free contacts: one row for each
      // block
  double* link;      // (links, kLinkRows)
  double* frame;     // (sections of frames, kFrameRows)
  double* layer;     // (nodes of layers, kLayerRows)
  double* node;      // (n_node, kNodeRows)
  double* dashpot;   // (joints, kDashpotRows)
  double* element;   // (points, kMaxwellRows)
  double* velocity;  // rows of four of blocks: vx, vy, omega before the step; the ground's last
  double* viscous_force;     // rows of four as `force`: the share of dashpots
  double* zone_force;        // rows of four: forces on corners 0 and 1 of each zone
  double* high_force;        // the same for corners 2 and 3, in a table of its own
  double* edge_block_force;  // rows of four: fx, fy, moment on the rigid block
  double* edge_force;        // rows of four: on nodes p and q
  double* wall;              // (kWallRows)
  std::uint8_t *joint_law_path, *edge_law_path;  // that a face took in the last step (joints.h)
};

// The length of each table and the place of each entity.
struct Layout {
  enum Kind { kNeighbours, kWalls };

  Layout(const Model& model, Kind kind);

  Kind kind;
  std::vector<Chunk> chunks[kPasses];
  // Of joint j, zone z, edge c: the place in its tables.
  std::vector<std::int32_t> joint_place, zone_place, edge_place;

  // numbers of entities, with those that fill up groups
  std::int32_t joints = 0, zones = 0, edges = 0, blocks = 0, nodes = 0, links = 0, history = 0;
  std::int32_t sections = 0;               // of frames
  std::int32_t layers = 0, crossings = 0;  // nodes of layers; where their fibres cross a joint
  std::int32_t damped = 0, elements = 0;   // joints with dashpots; numbers of Maxwell elements
  std::int32_t frees = 0;  // rows of forces of free contacts: blocks and the ground, or none
  std::int32_t laws = 0;   // rows
  std::size_t entries = 0, edge_entries = 0;
  // of the model: points of a quadrature, entries of the lists of nodes, shapes of zones
  std::size_t rule_points = 0, zone_entries = 0, contact_entries = 0, shapes = 0;

  // Index of row r of entity e in a table of `rows`; neighbours in lanes have successive indices.
  [[nodiscard]] std::ptrdiff_t number(std::int32_t e, int rows, int row, int walls) const {
    if (kind == kWalls) return (static_cast<std::ptrdiff_t>(e) * rows + row) * walls;
    return (static_cast<std::ptrdiff_t>(e / kGroup) * rows + row) * kGroup + e % kGroup;
  }
  // Index of number `k` of the law of entity n of a chunk of joints or edges.
  [[nodiscard]] std::ptrdiff_t law_number(const Chunk& chunk, int n, int k, int walls) const {
    const int group = kind == kWalls ? n : n / kGroup;
    const std::ptrdiff_t number =
        k < kStrengths
            ? chunk.strengths + (chunk.graded ? group : 0) * kStrengths + k
            : chunk.others + (chunk.graded_others ? group : 0) * kOthers + k - kStrengths;
    return kind == kWalls ? number * walls : number * kGroup + n % kGroup;
  }
  // Index of row `row` of point k of entity n of a chunk of joints or edges, in a table of points
  // of `rows` where the chunk begins with number `first`.
  [[nodiscard]] std::ptrdiff_t point_number(const Chunk& chunk, std::int32_t first, int n, int k,
                                            int rows, int row, int walls) const {
    const int group = kind == kWalls ? n : n / kGroup;
    const std::ptrdiff_t number =
        first + (static_cast<std::ptrdiff_t>(group) * chunk.points + k) * rows + row;
    return kind == kWalls ? number * walls : number * kGroup + n % kGroup;
  }
};

// A vector that begins at a cache line, so that eight lanes never lie in two lines.
template <class T>
struct LineAllocator {
  using value_type = T;
  static constexpr std::align_val_t kLine{64};
  LineAllocator() = default;
  template <class U>
  LineAllocator(const LineAllocator<U>&) {}  // NOLINT: as the standard asks
  T* allocate(std::size_t n) { return static_cast<T*>(::operator new(n * sizeof(T), kLine)); }
  void deallocate(T* p, std::size_t) { ::operator delete(p, kLine); }
  bool operator==(const LineAllocator&) const = default;
};
template <class T>
using Lines = std::vector<T, LineAllocator<T>>;

// The memory of the tables of `walls` walls: what all share and what each has for itself.
struct Memory {
  Lines<double> shared, own;
  Lines<std::int32_t> ids;
  Lines<ZoneShape> shapes;
  Lines<std::uint8_t> law_paths;
};

// Calls visit(pointer, count) for every table, and own(pointer, count) for tables of
// each wall, with counts of one wall. Allocating and pointing both follow this list.
template <class Visit, class Own>
void each_table(const Layout& l, Tables& t, const Visit& visit, const Own& own) {
  const auto n = [](auto count) { return static_cast<std::size_t>(count); };
  visit(t.joint, n(l.joints) * kJointRows);
  visit(t.edge, n(l.edges) * kEdgeRows);
  visit(t.turn_freedom, n(l.blocks));
  visit(t.node_free_x, n(l.nodes));
  visit(t.node_free_y, n(l.nodes));
  visit(t.point_xi, l.rule_points + 2);
  visit(t.point_weight, l.rule_points + 2);
  visit(t.joint_a, n(l.joints));
  visit(t.joint_b, n(l.joints));
  visit(t.block_begin, n(l.blocks) + 1);
  visit(t.block_middle, n(l.blocks));
  visit(t.block_entry, l.entries);
  visit(t.block_edge_begin, n(l.blocks) + 1);
  visit(t.block_edge_entry, l.edge_entries);
  visit(t.special, n(l.blocks));
  visit(t.edge_block, n(l.edges));
  visit(t.edge_p, n(l.edges));
  visit(t.edge_q, n(l.edges));
  visit(t.link_a, n(l.links));
  visit(t.link_b, n(l.links));
  visit(t.frame_a, n(l.sections));
  visit(t.frame_b, n(l.sections));
  visit(t.layer_a, n(l.layers));
  visit(t.layer_b, n(l.layers));
  visit(t.layer_crossing, n(l.layers));
  for (auto& corner : t.corner) visit(corner, n(l.zones));
  visit(t.node_zone_begin, n(l.nodes) + 1);
  visit(t.node_zone_entry, l.zone_entries);
  visit(t.node_edge_begin, n(l.nodes) + 1);
  visit(t.node_edge_entry, l.contact_entries);
  visit(t.shapes, l.shapes);
  own(t.law, n(l.laws) * (l.kind == Layout::kWalls ? 1 : kGroup));
  own(t.block, n(l.blocks + kGroup) * kBlockRows);
  own(t.cold, n(l.blocks) * kColdRows);
  own(t.history, n(l.history));
  own(t.force, 4 * n(l.joints + l.links + l.sections + l.crossings + l.frees));
  own(t.link, n(l.links) * kLinkRows);
  own(t.frame, n(l.sections) * kFrameRows);
  own(t.layer, n(l.layers) * kLayerRows);
  own(t.dashpot, n(l.damped) * kDashpotRows);
  own(t.element, n(l.elements));
  own(t.velocity, l.damped > 0 ? 4 * (n(l.blocks) + 1) : 0);
  own(t.viscous_force, 4 * n(l.damped));
  own(t.node, n(l.nodes) * kNodeRows);
  own(t.zone_force, 4 * n(l.zones));
  own(t.high_force, 4 * n(l.zones));  // right behind zone_force: lists of nodes reach into it
  own(t.edge_block_force, 4 * n(l.edges));
  own(t.edge_force, 4 * n(l.edges));
  own(t.pose, 4 * (n(l.blocks) + 1));
  own(t.wall, n(kWallRows));
  own(t.joint_law_path, n(l.joints));
  own(t.edge_law_path, n(l.edges));
}

// Points the tables into memory of this or another machine, laid out as Memory is.
template <class Doubles, class Ids, class Shapes, class Bytes>
void point_tables(const Layout& l, Tables& t, Doubles* shared, Doubles* own, Ids* ids,
                  Shapes* shapes, Bytes* law_paths) {
  const auto take = [](auto*& table, auto*& next, std::size_t n) {
    table = next;
    next += n;
  };
  each_table(
      l, t,
      [&](auto*& table, std::size_t n) {
        using T = std::remove_cvref_t<decltype(*table)>;
        if constexpr (std::is_same_v<T, double>) take(table, shared, n);
        if constexpr (std::is_same_v<T, std::int32_t>) take(table, ids, n);
        if constexpr (std::is_same_v<T, ZoneShape>) take(table, shapes, n);
      },
      [&](auto*& table, std::size_t n) {
        using T = std::remove_cvref_t<decltype(*table)>;
        if constexpr (std::is_same_v<T, double>)
          take(table, own, n * static_cast<std::size_t>(t.lanes));
        if constexpr (std::is_same_v<T, std::uint8_t>)
          take(table, law_paths, n * static_cast<std::size_t>(t.lanes));
      });
}

// Tables in memory of this machine, with the data that all walls share. Every wall is at rest and has no law.
[[nodiscard]] Tables make_tables(const Layout& layout, const Model& model, int walls,
                                 Memory& memory);

}  // namespace wythe::dynamics
