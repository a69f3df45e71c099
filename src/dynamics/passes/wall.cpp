#include "dynamics/passes/wall.h"

#include "contact/parameters.h"
#include "core/real.h"

namespace wythe::dynamics {
namespace {

std::size_t at(std::int64_t i) { return static_cast<std::size_t>(i); }

// act(entity of the model, its number in the table) for all entities of a field.
template <class Act>
void each_number(const Layout& l, const Tables& t, const Model& m, const StateField& field,
                 const Act& act) {
  const int walls = static_cast<int>(t.lanes), row = row_of(field.array);
  const auto plain = [&](double* table, int n, int rows) {
    for (int i = 0; i < n; ++i) act(at(i), table + l.number(i, rows, row, walls));
  };
  if (field.entity == Entity::kBlock) return plain(t.block, m.n_block, kBlockRows);
  if (field.entity == Entity::kNode) return plain(t.node, m.solids.n_node, kNodeRows);
  const auto points = [&](const std::vector<std::int32_t>& place,
                          const std::vector<std::int32_t>& history, int per, std::size_t first) {
    for (std::size_t j = 0; j < place.size(); ++j)
      for (int k = 0; k < per; ++k)
        act(first + j * at(per) + at(k),
            t.history + l.point_number(place[j], history[j], k, row, walls));
  };
  points(l.joint_place, l.joint_history, m.n_face_point, 0);
  points(l.edge_place, l.edge_history, 2, at(m.n_point()));
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
  view.first_ground = m.n_pair < m.n_joint ? l.joint_place[at(m.n_pair)] : l.joints;
  view.nodes = l.nodes;
  view.edges = l.edges;
  view.moving_blocks = m.n_block;
  return view;
}

void put_wall(const Layout& l, const Tables& t, int lane, const Model& m, const State& s) {
  const int walls = static_cast<int>(t.lanes);
  for (std::size_t material = 0; material < m.materials.size(); ++material) {
    const contact::LawConstants<double> law = contact::constants_of(m.materials[material]);
    for (std::size_t k = 0; k < at(kLawRows); ++k)
      t.law[(material * at(kLawRows) + k) * at(walls) + at(lane)] =
          law.*contact::kConstants<double>[k];
  }
  for (const StateField& field : kStateFields)
    each_number(l, t, m, field, [&](std::size_t i, double* to) { to[lane] = (s.*field.array)[i]; });
  const WallView wall = view_of(l, m, t, lane);
  for (int i = 0; i < m.n_block; ++i) {
    wall.block(i, kHeavyMass) = m.heavy_mass[at(i)];
    wall.block(i, kIsFree) = 1;
    wall.block(i, kLoadX) = wall.block(i, kLoadY) = wall.block(i, kLoadM) = 0;
    wall.cold(i, kMass) = m.mass[at(i)];
    wall.cold(i, kInertia) = m.inertia[at(i)];
  }
  for (int i = 0; i < m.solids.n_node; ++i) {
    wall.node(i, kNodeHeavyMass) = m.solids.node_heavy_mass[at(i)];
    wall.node(i, kNodeMass) = m.solids.node_mass[at(i)];
  }
  wall.of_four(t.pose, t.n_block, 2) = 1;  // the ground's cosine
  turn_all(wall);
}

void read_wall(const Layout& l, const Tables& t, int lane, const Model& m, State& s) {
  for (const StateField& field : kStateFields)
    each_number(l, t, m, field,
                [&](std::size_t i, const double* from) { (s.*field.array)[i] = from[lane]; });
}

void turn_all(const WallView& wall) {
  for (int i = 0; i < wall.blocks; ++i) {
    const SinCos<double> half = sin_cos(0.5 * wall.block(i, kTheta));
    const double row[4] = {wall.block(i, kUx), wall.block(i, kUy), half.cos, half.sin};
    for (int c = 0; c < 4; ++c) wall.of_four(wall.t.pose, i, c) = row[c];
  }
}

}  // namespace wythe::dynamics
