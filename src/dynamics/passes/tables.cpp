// Lays out the tables of a model and fills what all walls share.
#include "dynamics/passes/tables.h"

#include <algorithm>

#include "contact/parameters.h"
#include "model/fields.h"

namespace wythe::dynamics {
namespace {

// The rows have the order of the table of fields.
static_assert(kNodeVy + 1 == fields_of(Entity::kNode) && kNodeUx == row_of(&State::node_ux) &&
              kNodeUy == row_of(&State::node_uy) && kNodeVx == row_of(&State::node_vx) &&
              kNodeVy == row_of(&State::node_vy));
static_assert(kLinkDrawn + 1 == fields_of(Entity::kLink) &&
              kLinkForce == row_of(&State::link_force) &&
              kLinkPlastic == row_of(&State::link_plastic) &&
              kLinkDrawn == row_of(&State::link_drawn));
static_assert(kFrameRightSet + 1 == fields_of(Entity::kFrameLink) &&
              kFrameLeftSet == row_of(&State::frame_left) &&
              kFrameMiddleSet == row_of(&State::frame_middle) &&
              kFrameRightSet == row_of(&State::frame_right));
static_assert(kLayerBroken + 1 == fields_of(Entity::kLayerNode) &&
              kLayerSlip == row_of(&State::layer_slip) &&
              kLayerReached == row_of(&State::layer_reached) &&
              kLayerBroken == row_of(&State::layer_broken));
static_assert(kHistoryRows == fields_of(Entity::kPoint));
static_assert(kMaxwellRows == fields_of(Entity::kMaxwell) &&
              kNormalElement == row_of(&State::maxwell_normal) &&
              kShearElement == row_of(&State::maxwell_shear));

// Cuts entities 0 .. n-1 into chunks of at most kChunk whose neighbours fit(i
// - 1, i), and forms their groups. A chunk of neighbours begins a new group.
template <class Fits, class Describe>
std::vector<Chunk> cut(int n, Layout::Kind kind, const Fits& fits, const Describe& describe) {
  std::vector<Chunk> chunks;
  for (int i = 0; i < n; ++i) {
    const bool joins = !chunks.empty() && chunks.back().n < kChunk && fits(i - 1, i);
    if (!joins) {
      Chunk chunk;
      if (!chunks.empty()) chunk.begin = chunks.back().end;
      chunk.first = i;
      describe(i, chunk);
      chunks.push_back(chunk);
    }
    Chunk& chunk = chunks.back();
    ++chunk.n;
    chunk.end = chunk.begin + (kind == Layout::kWalls ? chunk.n : (chunk.n + kGroup - 1) / kGroup);
  }
  return chunks;
}

// Sets the places of the entities of chunks; returns the number of places.
std::int32_t place_all(const std::vector<Chunk>& chunks, Layout::Kind kind,
                       std::vector<std::int32_t>& place) {
  const int group = kind == Layout::kWalls ? 1 : kGroup;
  for (const Chunk& chunk : chunks)
    for (int k = 0; k < chunk.n; ++k) place.push_back(chunk.begin * group + k);
  return chunks.empty() ? 0 : chunks.back().end * group;
}

// Lays the histories of chunks one behind the other.
void place_points(std::vector<Chunk>& chunks, std::int32_t& numbers) {
  for (Chunk& chunk : chunks) {
    chunk.rows = contact::history_size(chunk.choice);
    chunk.history = numbers;
    numbers += (chunk.end - chunk.begin) * chunk.points * chunk.rows;
  }
}

// Gives the joints' points Maxwell elements; returns how many numbers these have.
std::int32_t place_elements(std::vector<Chunk>& chunks) {
  std::int32_t numbers = 0;
  for (Chunk& chunk : chunks) {
    chunk.elements = numbers;
    numbers += (chunk.end - chunk.begin) * chunk.points * kMaxwellRows;
  }
  return numbers;
}

// Lays the laws of chunks one behind the other.
void place_laws(std::vector<Chunk>& chunks, std::int32_t& rows) {
  for (Chunk& chunk : chunks) {
    const std::int32_t groups = chunk.end - chunk.begin;
    chunk.strengths = rows;
    rows += (chunk.graded ? groups : 1) * kStrengths;
    chunk.others = rows;
    rows += (chunk.graded_others ? groups : 1) * kOthers;
  }
}

void follow_law(const Model& m, std::int32_t material, Chunk& chunk) {
  chunk.material = m.stated(material);
  chunk.graded = chunk.material != material;
  chunk.graded_others = chunk.graded && varies_beyond_strengths(m, chunk.material);
  chunk.choice = contact::choice_of(m.materials[material]);
}

std::vector<Chunk> cut_joints(const Model& m, Layout::Kind kind) {
  return cut(
      m.n_joint, kind,
      [&](int i, int j) {
        return m.stated(m.joint_material[i]) == m.stated(m.joint_material[j]) && j != m.n_pair;
      },
      [&](int j, Chunk& chunk) {
        follow_law(m, m.joint_material[j], chunk);
        chunk.on_ground = j >= m.n_pair;
        chunk.points = m.n_face_point;
        chunk.at_ends = m.n_face_point == 2 && m.point_xi[0] == -1 && m.point_xi[1] == 1;
      });
}

std::vector<Chunk> cut_edges(const Model& m, Layout::Kind kind) {
  const auto& material = m.solids.contact_material;
  return cut(
      m.solids.n_contact, kind,
      [&](int i, int j) { return m.stated(material[i]) == m.stated(material[j]); },
      [&](int j, Chunk& chunk) {
        follow_law(m, material[j], chunk);
        chunk.points = 2;
        chunk.rule = static_cast<std::int32_t>(m.point_xi.size());
      });
}

std::vector<Chunk> cut_zones(const Solids& s, Layout::Kind kind) {
  return cut(
      s.n_zone, kind, [&](int i, int j) { return s.zone_shape[i] == s.zone_shape[j]; },
      [&](int j, Chunk& chunk) { chunk.material = s.zone_shape[j]; });
}

std::vector<Chunk> cut_plain(int n, Layout::Kind kind) {
  return cut(
      n, kind, [](int, int) { return true; }, [](int, Chunk&) {});
}

// Fills tables that all walls share; everything else of the memory is zero.
class Filler {
 public:
  Filler(const Layout& layout, const Model& model, Tables& tables)
      : l_(layout), m_(model), t_(tables) {}

  void fill() {
    fill_joints();
    fill_edges();
    fill_blocks();
    fill_links();
    fill_solids();
  }

 private:
  void put(double* table, std::int32_t place, int rows, int row, double value) {
    table[l_.number(place, rows, row, 1)] = value;
  }
  // For joints and edges that fill up a group, both sides are the ground.
  [[nodiscard]] std::int32_t pose_of(BlockId block) const {
    return block == kGroundBlock ? t_.n_block : block;
  }

  void fill_joints() {
    std::fill_n(t_.joint_a, l_.joints, t_.n_block);
    std::fill_n(t_.joint_b, l_.joints, t_.n_block);
    for (int j = 0; j < m_.n_joint; ++j) {
      const std::size_t i = j;
      const std::int32_t place = l_.joint_place[i];
      t_.joint_a[place] = pose_of(m_.joint_a[i]);
      t_.joint_b[place] = pose_of(m_.joint_b[i]);
      const double half = m_.half_x[i] * m_.tangent_x[i] + m_.half_y[i] * m_.tangent_y[i];
      const double rows[kJointRows] = {m_.arm_a_x[i], m_.arm_a_y[i],   m_.arm_b_x[i],
                                       m_.arm_b_y[i], m_.tangent_x[i], m_.tangent_y[i],
                                       half,          m_.area[i]};
      for (int r = 0; r < kJointRows; ++r) put(t_.joint, place, kJointRows, r, rows[r]);
    }
    std::copy(m_.point_xi.begin(), m_.point_xi.end(), t_.point_xi);
    std::copy(m_.point_weight.begin(), m_.point_weight.end(), t_.point_weight);
    const std::size_t edge = m_.point_xi.size();
    t_.point_xi[edge] = -1, t_.point_xi[edge + 1] = 1;
    t_.point_weight[edge] = t_.point_weight[edge + 1] = 0.5;
  }

  void fill_edges() {
    const Solids& s = m_.solids;
    std::fill_n(t_.edge_block, l_.edges, t_.n_block);
    for (int c = 0; c < s.n_contact; ++c) {
      const std::size_t i = c;
      const std::int32_t place = l_.edge_place[i];
      t_.edge_block[place] = s.contact_block[i] == m_.n_block ? t_.n_block : s.contact_block[i];
      t_.edge_p[place] = s.contact_p[i];
      t_.edge_q[place] = s.contact_q[i];
      const double rows[kEdgeRows] = {
          s.arm_0_x[i],           s.arm_0_y[i],           s.arm_1_x[i],
          s.arm_1_y[i],           s.share_0[i],           s.share_1[i],
          s.contact_tangent_x[i], s.contact_tangent_y[i], s.contact_area[i]};
      for (int r = 0; r < kEdgeRows; ++r) put(t_.edge, place, kEdgeRows, r, rows[r]);
    }
  }

  void fill_links() {
    for (int k = 0; k < m_.links.n; ++k) {
      t_.link_a[k] = pose_of(m_.links.a[k]);
      t_.link_b[k] = pose_of(m_.links.b[k]);
    }
    for (int k = 0; k < m_.frames.n; ++k) {
      t_.frame_a[k] = pose_of(m_.frames.a[k]);
      t_.frame_b[k] = pose_of(m_.frames.b[k]);
    }
    for (int k = 0; k < m_.layers.n; ++k) {
      t_.layer_a[k] = pose_of(m_.layers.a[k]);
      t_.layer_b[k] = pose_of(m_.layers.b[k]);
      t_.layer_crossing[k] = m_.layers.crossing[k];
    }
  }

  // Lists for each block its joints in the model's order, then its links, sections and
  // crossings: first those of which it is side a, then side b. Then lists its zone contacts.
  void fill_blocks() {
    std::int32_t next = 0, next_edge = 0;
    std::vector<std::vector<std::int32_t>> edges_of(m_.n_block);
    for (int c = 0; c < m_.solids.n_contact; ++c)
      if (const BlockId block = m_.solids.contact_block[c]; block != m_.n_block)
        edges_of[block].push_back(l_.edge_place[c]);
    const auto add = [&](std::int32_t entry) {
      t_.block_entry[next++] = l_.joint_place[entry >> 1];
    };
    const auto add_rows = [&](const std::vector<BlockId>& side, int n, int first, BlockId block) {
      for (int k = 0; k < n; ++k)
        if (side[k] == block) t_.block_entry[next++] = first + k;
    };
    const auto add_links = [&](bool b, BlockId block) {
      add_rows(b ? m_.links.b : m_.links.a, m_.links.n, l_.joints, block);
      add_rows(b ? m_.frames.b : m_.frames.a, m_.frames.n, l_.joints + l_.links, block);
      const std::vector<BlockId>& crossed = b ? m_.layers.cross_b : m_.layers.cross_a;
      add_rows(crossed, static_cast<int>(crossed.size()), l_.joints + l_.links + l_.sections,
               block);
    };
    for (int i = 0; i < l_.blocks; ++i) {
      t_.block_begin[i] = next;
      t_.block_edge_begin[i] = next_edge;
      t_.block_middle[i] = next;
      if (i >= m_.n_block) continue;
      t_.turn_freedom[i] = m_.turn_freedom[i];
      auto e = m_.block_begin[i];
      for (; e < m_.block_begin[i + 1] && (m_.block_entry[e] & 1) == 0; ++e) add(m_.block_entry[e]);
      add_links(false, i);
      if (l_.frees > 0)
        t_.block_entry[next++] = l_.joints + l_.links + l_.sections + l_.crossings + i;
      t_.block_middle[i] = next;
      for (; e < m_.block_begin[i + 1]; ++e) add(m_.block_entry[e]);
      add_links(true, i);
      for (const std::int32_t edge : edges_of[i]) t_.block_edge_entry[next_edge++] = edge;
    }
    t_.block_begin[l_.blocks] = next;
    t_.block_edge_begin[l_.blocks] = next_edge;
  }

  void fill_solids() {
    const Solids& s = m_.solids;
    for (int k = 0; k < 4; ++k)
      for (int z = 0; z < s.n_zone; ++z) t_.corner[k][l_.zone_place[z]] = s.corner[k][z];
    std::copy(s.shapes.begin(), s.shapes.end(), t_.shapes);
    std::copy(s.node_free_x.begin(), s.node_free_x.end(), t_.node_free_x);
    std::copy(s.node_free_y.begin(), s.node_free_y.end(), t_.node_free_y);
    const auto list = [&](const std::vector<std::int32_t>& begin, std::int32_t* to) {
      for (int i = 0; i <= l_.nodes; ++i) to[i] = begin.empty() ? 0 : begin[std::min(i, s.n_node)];
    };
    list(s.zone_begin, t_.node_zone_begin);
    list(s.contact_begin, t_.node_edge_begin);
    // an entry is the place of an x component in rows of four of zones (corners 0 and 1, then 2 and 3)
    for (std::size_t e = 0; e < s.zone_entry.size(); ++e) {
      const std::int32_t was = s.zone_entry[e], low = 4 * s.n_zone;
      const std::int32_t z = (was % low) / 4;
      t_.node_zone_entry[e] = (was >= low ? 4 * l_.zones : 0) + 4 * l_.zone_place[z] + was % 4;
    }
    for (std::size_t e = 0; e < s.contact_entry.size(); ++e)
      t_.node_edge_entry[e] = 4 * l_.edge_place[s.contact_entry[e] / 4] + s.contact_entry[e] % 4;
  }

  const Layout& l_;
  const Model& m_;
  Tables& t_;
};

}  // namespace

Layout::Layout(const Model& m, Kind of) : kind(of) {
  const Solids& s = m.solids;
  chunks[kJoints] = cut_joints(m, kind);
  chunks[kEdges] = cut_edges(m, kind);
  chunks[kZones] = cut_zones(s, kind);
  chunks[kBlocks] = cut_plain(m.n_block, kind);
  chunks[kNodes] = cut_plain(s.n_node, kind);
  joints = place_all(chunks[kJoints], kind, joint_place);
  edges = place_all(chunks[kEdges], kind, edge_place);
  zones = place_all(chunks[kZones], kind, zone_place);
  std::vector<std::int32_t> same;
  blocks = place_all(chunks[kBlocks], kind, same);
  nodes = place_all(chunks[kNodes], kind, same);
  links = place_all(cut_plain(m.links.n, kind), kind, same);
  sections = place_all(cut_plain(m.frames.n, kind), kind, same);
  layers = place_all(cut_plain(m.layers.n, kind), kind, same);
  crossings = place_all(cut_plain(static_cast<int>(m.layers.cross_a.size()), kind), kind, same);
  place_points(chunks[kJoints], history);
  place_points(chunks[kEdges], history);
  place_laws(chunks[kJoints], laws);
  place_laws(chunks[kEdges], laws);
  if (has_dashpots(m)) {
    damped = joints;
    if (has_maxwell(m)) elements = place_elements(chunks[kJoints]);
    chunks[kDashpots] = chunks[kJoints];
  }
  const int lanes = kind == kWalls ? 1 : kGroup;
  history *= lanes, elements *= lanes;
  rule_points = m.point_xi.size();
  zone_entries = s.zone_entry.size();
  contact_entries = s.contact_entry.size();
  shapes = s.shapes.size();
  frees = m.free.any() ? blocks + 1 : 0;
  entries = m.block_entry.size() +
            2 * (m.links.a.size() + m.frames.a.size() + m.layers.cross_a.size()) +
            (frees > 0 ? static_cast<std::size_t>(m.n_block) : 0);
  edge_entries =
      static_cast<std::size_t>(std::count_if(s.contact_block.begin(), s.contact_block.end(),
                                             [&](BlockId block) { return block != m.n_block; }));
}

Tables make_tables(const Layout& l, const Model& m, int walls, Memory& memory) {
  Tables t;
  t.lanes = l.kind == Layout::kWalls ? walls : 1;
  t.n_block = l.blocks;
  // first run: count; second run: point
  const std::size_t lanes = t.lanes;
  std::size_t shared = 0, own = 0, ids = 0, law_paths = 0;
  const auto count = [&](auto*& table, std::size_t n) {
    using T = std::remove_cvref_t<decltype(*table)>;
    if constexpr (std::is_same_v<T, double>) shared += n;
    if constexpr (std::is_same_v<T, std::int32_t>) ids += n;
  };
  const auto count_own = [&](auto*& table, std::size_t n) {
    using T = std::remove_cvref_t<decltype(*table)>;
    (std::is_same_v<T, double> ? own : law_paths) += n * lanes;
  };
  each_table(l, t, count, count_own);
  memory.shared.assign(shared, 0.0);
  memory.own.assign(own, 0.0);
  memory.ids.assign(ids, 0);
  memory.shapes.resize(m.solids.shapes.size());
  memory.law_paths.assign(law_paths, 0);
  point_tables(l, t, memory.shared.data(), memory.own.data(), memory.ids.data(),
               memory.shapes.data(), memory.law_paths.data());
  Filler(l, m, t).fill();
  return t;
}

}  // namespace wythe::dynamics
