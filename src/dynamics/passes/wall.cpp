// Copies a wall from its state to the tables and back. Both directions use each_number(), which knows the
// place of each field, so they agree. Assertions tie rows to the order of fields. In stages that cut openings,
// joints of blocks that do not stand lie between the ground and itself, and these blocks keep still.
#include "dynamics/passes/wall.h"

#include <algorithm>

#include "contact/layer.h"
#include "contact/parameters.h"
#include "core/real.h"
#include "dynamics/passes/links.h"

namespace wythe::dynamics {
namespace {

static_assert(kFrameAcross == kFrameAlong + row_of(&State::frame_across) &&
              kFrameTurn == kFrameAlong + row_of(&State::frame_turn));
static_assert(row_of(&State::ux) == 0 && row_of(&State::uy) == 1 &&
              row_of(&State::theta) == kTheta + 2 && row_of(&State::vx) == kVx + 2 &&
              row_of(&State::vy) == kVy + 2 && row_of(&State::omega) == kOmega + 2 &&
              fields_of(Entity::kBlock) == kOmega + 3);

// Calls act(entity of the model, its number in the table) for all entities of a field.
template <class Act>
void each_number(const Layout& l, const Tables& t, const Model& m, const StateField& field,
                 const Act& act) {
  const int walls = static_cast<int>(t.lanes), row = row_of(field.array);
  // a displacement is a column of the pose; the rows of a block begin behind both
  if (field.array == &State::ux || field.array == &State::uy) {
    for (int i = 0; i < m.n_block; ++i)
      act(static_cast<std::size_t>(i), t.pose + (4 * i + row) * walls);
    return;
  }
  const auto plain = [&](double* table, int n, int rows, int r) {
    for (int i = 0; i < n; ++i)
      act(static_cast<std::size_t>(i), table + l.number(i, rows, r, walls));
  };
  if (field.entity == Entity::kBlock) return plain(t.block, m.n_block, kBlockRows, row - 2);
  if (field.entity == Entity::kNode) return plain(t.node, m.solids.n_node, kNodeRows, row);
  if (field.entity == Entity::kLink) return plain(t.link, m.links.n, kLinkRows, row);
  if (field.entity == Entity::kFrameLink) return plain(t.frame, m.frames.n, kFrameRows, row);
  if (field.entity == Entity::kFrameSet && m.standing.any())
    return plain(t.frame, m.frames.n, kFrameRows, kFrameAlong + row);
  if (field.entity == Entity::kLayerNode) return plain(t.layer, m.layers.n, kLayerRows, row);
  const auto each_point = [&](const Chunk& chunk, std::size_t first, const auto& number) {
    for (int n = 0; n < chunk.n; ++n)
      for (int k = 0; k < chunk.points; ++k)
        act(first + static_cast<std::size_t>((chunk.first + n) * chunk.points + k), number(n, k));
  };
  if (field.entity == Entity::kMaxwell && l.elements > 0)
    for (const Chunk& chunk : l.chunks[kDashpots])
      each_point(chunk, 0, [&](int n, int k) {
        return t.element + l.point_number(chunk, chunk.elements, n, k, kMaxwellRows, row, walls);
      });
  if (field.entity != Entity::kPoint) return;  // done, or only for walls in space
  const auto histories = [&](const std::vector<Chunk>& chunks, std::size_t first) {
    for (const Chunk& chunk : chunks)
      if (row < chunk.rows)
        each_point(chunk, first, [&](int n, int k) {
          return t.history + l.point_number(chunk, chunk.history, n, k, chunk.rows, row, walls);
        });
  };
  histories(l.chunks[kJoints], 0);
  histories(l.chunks[kEdges], static_cast<std::size_t>(m.n_point()));
}

// Loads the law of each entity of chunks: one material for the whole chunk, or each its own. The last one fills up a group.
void load_laws(const Layout& l, const Tables& t, int lane, const Model& m,
               const std::vector<Chunk>& chunks, const std::vector<std::int32_t>& material) {
  const int group = l.kind == Layout::kWalls ? 1 : kGroup;
  for (const Chunk& chunk : chunks) {
    const int filled = chunk.graded ? (chunk.end - chunk.begin) * group : group;
    for (int n = 0; n < filled; ++n) {
      const int entity = chunk.first + (chunk.graded ? std::min(n, chunk.n - 1) : 0);
      const contact::LawConstants<double> law =
          contact::constants_of(m.materials[material[entity]]);
      for (int k = 0; k < kLawRows; ++k)
        t.law[l.law_number(chunk, n, k, static_cast<int>(t.lanes)) + lane] =
            law.*contact::kConstants<double>[k];
    }
  }
}

void load_frames(const WallView& wall, const Frames& frames) {
  for (int k = 0; k < frames.n; ++k) {
    const auto put = [&](FrameRowName row, const std::vector<double>& of) {
      wall.frame(k, row) = of[k];
    };
    put(kFrameArmAX, frames.arm_a_x);
    put(kFrameArmAY, frames.arm_a_y);
    put(kFrameArmBX, frames.arm_b_x);
    put(kFrameArmBY, frames.arm_b_y);
    put(kFrameAxisX, frames.axis_x);
    put(kFrameAxisY, frames.axis_y);
    put(kFrameRestX, frames.rest_x);
    put(kFrameRestY, frames.rest_y);
    put(kFrameOuter, frames.outer_stiffness);
    put(kFrameMiddle, frames.middle_stiffness);
    put(kFrameShear, frames.shear_stiffness);
    put(kFrameFibre, frames.fibre);
    put(kFrameOuterYield, frames.outer_yield);
    put(kFrameMiddleYield, frames.middle_yield);
  }
}

void load_layers(const WallView& wall, const Layers& layers) {
  constexpr double kShare = 0.5;  // of the slip that would balance a node (22.7)
  double behind = 0;
  for (int k = 0; k < layers.n; ++k) {
    const auto put = [&](LayerRowName row, const std::vector<double>& of) {
      wall.layer(k, row) = of[k];
    };
    put(kLayerStiffness, layers.stiffness);
    put(kLayerStrength, layers.strength);
    put(kLayerEnergy, layers.bond_energy);
    put(kLayerRate, layers.bond_rate);
    put(kLayerArmAX, layers.arm_a_x);
    put(kLayerArmAY, layers.arm_a_y);
    put(kLayerArmBX, layers.arm_b_x);
    put(kLayerArmBY, layers.arm_b_y);
    put(kLayerSpanX, layers.span_x);
    put(kLayerSpanY, layers.span_y);
    const contact::LayerBond bond{layers.bond_energy[k], layers.bond_rate[k]};
    const double ahead = layers.stiffness[k];
    wall.layer(k, kLayerFlex) = kShare / (behind + ahead + contact::bond_secant(bond, 0));
    wall.layer(k, kLayerSecant) = contact::bond_secant(bond, wall.layer(k, kLayerReached));
    wall.layer(k, kLayerStretch) = wall.layer(k, kLayerShift) = 0;
    behind = ahead;
  }
}

}  // namespace

WallView view_of(const Layout& l, const Model& m, const Tables& t, int lane) {
  WallView view;
  view.t = t;
  view.lane = lane;
  const bool grouped = l.kind == Layout::kNeighbours;
  view.shift = grouped ? 3 : 0;
  view.mask = grouped ? kGroup - 1 : 0;
  view.blocks = l.blocks;
  view.joints = l.joints;
  view.first_ground = m.n_pair < m.n_joint ? l.joint_place[m.n_pair] : l.joints;
  view.nodes = l.nodes;
  view.edges = l.edges;
  view.links = m.links.n;
  view.linked = l.links;
  view.frames = m.frames.n;
  view.layers = m.layers.n;
  view.crossings = static_cast<int>(m.layers.cross_a.size());
  view.first_crossing = l.joints + l.links + l.sections;
  view.moving_blocks = m.n_block;
  if (l.frees > 0) view.first_free = view.first_crossing + l.crossings;
  return view;
}

void load_lane(const Layout& l, const Tables& t, int lane, const Model& m, const State& s) {
  load_laws(l, t, lane, m, l.chunks[kJoints], m.joint_material);
  load_laws(l, t, lane, m, l.chunks[kEdges], m.solids.contact_material);
  for (const StateField& field : kStateFields)
    each_number(l, t, m, field, [&](std::size_t i, double* to) { to[lane] = (s.*field.array)[i]; });
  // from now on no face counts as undamaged
  std::fill_n(t.joint_law_path, l.joints * t.lanes, std::uint8_t{0});
  std::fill_n(t.edge_law_path, l.edges * t.lanes, std::uint8_t{0});
  const WallView wall = view_of(l, m, t, lane);
  for (int i = 0; i < m.n_block; ++i) {
    wall.block(i, kGravityMass) = m.gravity_mass[i];
    wall.block(i, kIsFree) = 1;
    wall.block(i, kLoadX) = wall.block(i, kLoadY) = wall.block(i, kLoadM) = 0;
    wall.cold(i, kMass) = m.mass[i];
    wall.cold(i, kInertia) = m.inertia[i];
  }
  for (const Stage& stage : m.stages) {
    for (const PointLoad& load : stage.loads) wall.special(load.block) = 1;
    for (const PointLoad& mass : stage.carried) wall.special(mass.block) = 1;
    for (const BlockId block : stage.driven) wall.special(block) = 1;
  }
  for (int i = 0; i < m.solids.n_node; ++i) {
    wall.node(i, kNodeGravityMass) = m.solids.node_gravity_mass[i];
    wall.node(i, kNodeMass) = m.solids.node_mass[i];
  }
  load_links(wall, m.links);
  load_frames(wall, m.frames);
  load_layers(wall, m.layers);
  wall.column_of(t.pose, t.n_block, 2) = 1;  // the ground's cosine
  turn_all(wall);
}

void stand(const Layout& l, const Tables& t, const Model& m, const State& s) {
  const WallView wall = view_of(l, m, t, 0);
  for (JointId j = 0; j < m.n_joint; ++j) {
    const std::size_t i = j;
    const std::int32_t place = l.joint_place[i];
    const bool stands = m.standing.joins(m.joint_a[i], m.joint_b[i], s.stage);
    const std::int32_t a = m.joint_a[i] == kGroundBlock ? t.n_block : m.joint_a[i];
    t.joint_a[place] =
        stands ? a : t.n_block;  // else between the ground and itself, without an area
    t.joint_b[place] = stands ? m.joint_b[i] : t.n_block;
    t.joint[l.number(place, kJointRows, kArea, 1)] = stands ? m.area[i] : 0;
    std::fill_n(t.force + 4 * static_cast<std::ptrdiff_t>(place), 4, 0.0);
  }
  for (int k = 0; k < m.links.n; ++k) {
    const std::size_t i = k;
    const BlockId a = m.links.a[i], b = m.links.b[i];
    const bool stands = m.standing.joins(a, b, s.stage);
    t.link_a[k] = stands && a != kGroundBlock ? a : t.n_block;
    t.link_b[k] = stands ? b : t.n_block;
    wall.link(k, kLinkJack) = stands && m.standing.begins(a, b, s.stage) ? m.links.jack[i] : 0;
    std::fill_n(t.force + 4 * static_cast<std::ptrdiff_t>(wall.joints + k), 4, 0.0);
  }
  for (int k = 0; k < m.frames.n; ++k) {
    const std::size_t i = k;
    const bool stands = m.standing.joins(m.frames.a[i], m.frames.b[i], s.stage);
    const std::int32_t a = m.frames.a[i] == kGroundBlock ? t.n_block : m.frames.a[i];
    t.frame_a[k] = stands ? a : t.n_block;
    t.frame_b[k] = stands ? m.frames.b[i] : t.n_block;
    std::fill_n(t.force + 4 * static_cast<std::ptrdiff_t>(wall.joints + wall.linked + k), 4, 0.0);
  }
  for (int i = 0; i < m.n_block; ++i)
    if (!m.standing.holds(i, s.stage) || s.release_x[i] != 0 || s.release_y[i] != 0 ||
        s.release_m[i] != 0)
      wall.special(i) = 1;
  hold_still(wall, m, s.stage);
}

void hold_still(const WallView& wall, const Model& m, int stage) {
  for (int i = 0; i < m.n_block; ++i) {
    if (m.standing.holds(i, stage)) continue;
    wall.block(i, kIsFree) = 0;
    wall.block(i, kVx) = wall.block(i, kVy) = wall.block(i, kOmega) = 0;
  }
}

void store_lane(const Layout& l, const Tables& t, int lane, const Model& m, State& s) {
  for (const StateField& field : kStateFields)
    each_number(l, t, m, field,
                [&](std::size_t i, const double* from) { (s.*field.array)[i] = from[lane]; });
}

void turn_all(const WallView& wall) {
  for (int i = 0; i < wall.blocks; ++i) {
    const SinCos<double> half = sin_cos(0.5 * wall.block(i, kTheta));
    wall.column_of(wall.t.pose, i, 2) = half.cos;
    wall.column_of(wall.t.pose, i, 3) = half.sin;
  }
}

}  // namespace wythe::dynamics
