// Lays out the tables of a model in space and fills what all walls share.
#include "dynamics/space/tables.h"

#include <algorithm>

#include "contact/parameters.h"
#include "model/fields.h"
#include "wythe/parts/model.h"

namespace wythe::dynamics::space {
namespace {

int points_of_face(const Model& m, int j) {
  return m.space.point_begin[j + 1] - m.space.point_begin[j];
}

// Runs of joints of one law, one kind of support and one number of points.
void cut_joints(const Model& m, Layout& l) {
  const auto fits = [&](int i, int j) {
    return m.stated(m.joint_material[i]) == m.stated(m.joint_material[j]) && j != m.n_pair &&
           points_of_face(m, i) == points_of_face(m, j);
  };
  for (int j = 0; j < m.n_joint; ++j) {
    if (l.joints.empty() || l.joints.back().n == kChunk || !fits(j - 1, j)) {
      Chunk chunk;
      if (!l.joints.empty()) chunk.begin = l.joints.back().end;
      chunk.first = j;
      const std::int32_t material = m.joint_material[j];
      chunk.material = m.stated(material);
      chunk.graded = chunk.material != material;
      chunk.choice = contact::choice_of(m.materials[material]);
      chunk.on_ground = j >= m.n_pair;
      chunk.points = points_of_face(m, j);
      chunk.rows = contact::history_size(chunk.choice) + 1;  // and the second slip
      l.joints.push_back(chunk);
    }
    Chunk& chunk = l.joints.back();
    ++chunk.n;
    chunk.end = chunk.begin + (chunk.n + l.group() - 1) / l.group();
  }
  const bool has_elements = has_maxwell(m);
  for (Chunk& chunk : l.joints) {
    const std::int32_t spots = chunk.end - chunk.begin;
    chunk.history = l.history;
    chunk.rule = l.points;
    chunk.strengths = l.laws;
    chunk.others = l.laws + kStrengths;
    if (has_elements) {
      chunk.elements = l.elements;
      l.elements += spots * chunk.points * kMaxwellRowsInSpace;
    }
    l.history += spots * chunk.points * chunk.rows;
    l.points += spots * chunk.points * kPointRows;
    l.laws += (chunk.graded ? spots : 1) * kLawRows;
    for (int k = 0; k < chunk.n; ++k) l.joint_place.push_back(chunk.begin * l.group() + k);
  }
  l.n_joint = l.joints.empty() ? 0 : l.joints.back().end * l.group();
  if (has_dashpots(m)) l.damped = l.n_joint;
}

void cut_blocks(const Model& m, Layout& l) {
  for (int i = 0; i < m.n_block; i += kChunk) {
    Chunk chunk;
    if (!l.blocks.empty()) chunk.begin = l.blocks.back().end;
    chunk.first = i;
    chunk.n = std::min(kChunk, m.n_block - i);
    chunk.end = chunk.begin + (chunk.n + l.group() - 1) / l.group();
    l.blocks.push_back(chunk);
  }
  l.n_block = l.blocks.empty() ? 0 : l.blocks.back().end * l.group();
}

// Points each table into its memory: the first run counts, the second one points.
struct Placed {
  double* numbers = nullptr;
  std::int32_t* ids = nullptr;
  std::uint8_t* law_paths = nullptr;
  std::size_t n_number = 0, n_id = 0, n_law_path = 0;

  void take(double*& table, std::size_t n) { put(table, numbers, n_number, n); }
  void take(std::int32_t*& table, std::size_t n) { put(table, ids, n_id, n); }
  void take(std::uint8_t*& table, std::size_t n) { put(table, law_paths, n_law_path, n); }

  // In the run that counts, memory is null, and nothing may be added to a null pointer.
  template <class T>
  static void put(T*& table, T* memory, std::size_t& used, std::size_t n) {
    table = memory == nullptr ? nullptr : memory + used;
    used += n;
  }
};

void place(const Layout& l, const Model& m, Tables& t, Placed& to) {
  const std::size_t joints = l.n_joint, blocks = static_cast<std::size_t>(l.n_block),
                    walls = static_cast<std::size_t>(t.lanes);
  const std::size_t group = l.grouped() ? kGroup : 1;
  to.take(t.face, joints * kFaceRows);
  to.take(t.point, static_cast<std::size_t>(l.points) * group);
  to.take(t.axes, (blocks + kGroup) * kAxisRows);  // then those of the resting pose
  to.take(t.joint_a, joints);
  to.take(t.joint_b, joints);
  to.take(t.block_begin, blocks + 1);
  to.take(t.block_middle, blocks);
  const std::size_t frees = m.free.any() ? static_cast<std::size_t>(m.n_block + m.free.n_fixed) : 0;
  to.take(t.block_entry, m.block_entry.size() + 2 * static_cast<std::size_t>(l.n_link) +
                             2 * static_cast<std::size_t>(l.n_frame) +
                             (frees > 0 ? static_cast<std::size_t>(m.n_block) : 0) +
                             static_cast<std::size_t>(l.n_contact));
  to.take(t.link_a, static_cast<std::size_t>(l.n_link));
  to.take(t.link_b, static_cast<std::size_t>(l.n_link));
  to.take(t.special, blocks);
  to.take(t.law, static_cast<std::size_t>(l.laws) * group * walls);
  to.take(t.body, (blocks + kGroup) * kBodyRows * walls);
  to.take(t.still, blocks * kStillRows * walls);
  to.take(t.history, static_cast<std::size_t>(l.history) * group * walls);
  to.take(t.wall, kWallRows * walls);
  to.take(t.shift, 4 * (blocks + 1) * walls);
  to.take(t.turn, 4 * (blocks + 1) * walls);
  to.take(t.support, 4 * static_cast<std::size_t>(m.space.n_support + 1) * walls);
  to.take(t.link, static_cast<std::size_t>(l.n_link) * kSpaceLinkRows * walls);
  // of joints, links, free contacts (one for each body), and contacts of zones
  for (double** rows : {&t.force, &t.moment_a, &t.moment_b})
    to.take(*rows, 4 *
                       (joints + static_cast<std::size_t>(l.n_link + l.n_frame) + frees +
                        static_cast<std::size_t>(l.n_contact)) *
                       walls);
  const std::size_t damped = l.damped, moving = damped > 0 ? blocks + 1 : 0,
                    supports = damped > 0 ? static_cast<std::size_t>(m.space.n_support + 1) : 0;
  to.take(t.dashpot, damped * kDashpotRows * walls);
  to.take(t.element, static_cast<std::size_t>(l.elements) * group * walls);
  for (double** rows : {&t.velocity, &t.spin_rate}) to.take(*rows, 4 * moving * walls);
  to.take(t.support_velocity, 4 * supports * walls);
  for (double** rows : {&t.viscous_force, &t.viscous_moment_a, &t.viscous_moment_b})
    to.take(*rows, 4 * damped * walls);
  to.take(t.law_path, joints * walls);
}

void fill_joints(const Layout& l, const Model& m, Tables& t) {
  std::fill_n(t.joint_b, l.n_joint, t.n_block);
  for (const Chunk& chunk : l.joints)  // entities that fill up a group are at rest
    std::fill_n(t.joint_a + chunk.begin * l.group(), (chunk.end - chunk.begin) * l.group(),
                chunk.on_ground ? m.space.n_support : t.n_block);
  for (const Chunk& chunk : l.joints)
    for (int n = 0; n < chunk.n; ++n) {
      const int j = chunk.first + n;
      const std::int32_t item = l.joint_place[j];
      t.joint_a[item] = chunk.on_ground ? m.joint_a[j] - m.n_block : m.joint_a[j];
      t.joint_b[item] = m.joint_b[j];
      const auto put = [&](int row, const Vec3& v) {
        const double all[3] = {v.x, v.y, v.z};
        for (int c = 0; c < 3; ++c) t.face[l.number(item, kFaceRows, row + c, 1)] = all[c];
      };
      put(kArmA, m.space.arm_a[j]);
      put(kArmB, m.space.arm_b[j]);
      put(kTangent, m.space.tangent[j]);
      put(kNormal, m.space.normal[j]);
      t.face[l.number(item, kFaceRows, kFaceArea, 1)] = m.area[j];
      for (int k = 0; k < chunk.points; ++k) {
        const std::size_t p = m.space.point_begin[j] + k;
        const auto row = [&](int r) -> double& {
          return t.point[l.point_number(chunk, chunk.rule, n, k, kPointRows, r, 1)];
        };
        row(kR1) = m.space.point_r1[p];
        row(kR2) = m.space.point_r2[p];
        row(kShare) = m.space.point_share[p];
      }
    }
}

// Lists for each block its joints in the model's order, then its links: first
// those of which it is side a, with the contacts of zones, then side b.
void fill_blocks(const Layout& l, const Model& m, Tables& t) {
  std::int32_t next = 0;
  const auto add = [&](const std::vector<BlockId>& side, BlockId block, std::int32_t first) {
    for (std::size_t k = 0; k < side.size(); ++k)
      if (side[k] == block) t.block_entry[next++] = first + static_cast<std::int32_t>(k);
  };
  for (int i = 0; i < l.n_block; ++i) {
    t.block_begin[i] = t.block_middle[i] = next;
    if (i >= m.n_block) continue;
    const Vec3* axes[3] = {&m.space.axis_1[i], &m.space.axis_2[i], &m.space.axis_3[i]};
    for (int k = 0; k < 3; ++k) {
      const double all[3] = {axes[k]->x, axes[k]->y, axes[k]->z};
      for (int c = 0; c < 3; ++c) t.axes[l.number(i, kAxisRows, 3 * k + c, 1)] = all[c];
    }
    auto e = m.block_begin[i];
    const auto last = m.block_begin[i + 1];
    for (; e < last && (m.block_entry[e] & 1) == 0; ++e)
      t.block_entry[next++] = l.joint_place[m.block_entry[e] >> 1];
    add(m.links.a, i, l.n_joint);
    add(m.frames.a, i, l.first_frame);
    if (m.free.any()) t.block_entry[next++] = l.first_frame + l.n_frame + i;
    for (std::int32_t c = 0; c < l.n_contact; ++c)
      if (m.space.solids.contact_block[c] == i) t.block_entry[next++] = l.first_contact + c;
    t.block_middle[i] = next;
    for (; e < last; ++e) t.block_entry[next++] = l.joint_place[m.block_entry[e] >> 1];
    add(m.links.b, i, l.n_joint);
    add(m.frames.b, i, l.first_frame);
  }
  for (int k = 0; k < l.n_link; ++k) {
    const BlockId a = m.links.a[k];
    t.link_a[k] = a == kGroundBlock ? l.n_block : a;
    t.link_b[k] = m.links.b[k];
  }
  t.block_begin[l.n_block] = next;
}

}  // namespace

Layout::Layout(const Model& m, dynamics::Layout::Kind of) : kind(of) {
  n_link = m.links.n;
  n_frame = m.frames.n;
  n_contact = m.space.solids.n_contact;
  cut_joints(m, *this);
  cut_blocks(m, *this);
  first_frame = n_joint + n_link;
  first_contact = first_frame + n_frame + (m.free.any() ? m.n_block + m.free.n_fixed : 0);
}

Tables make_tables(const Layout& l, const Model& m, int walls, Memory& memory) {
  Tables t;
  t.lanes = l.grouped() ? 1 : walls;
  t.n_block = l.n_block;
  t.damps_components = m.solve.damping_form == DampingForm::kComponents;
  Placed count;
  place(l, m, t, count);
  memory.numbers.assign(count.n_number, 0.0);
  memory.ids.assign(count.n_id, 0);
  memory.law_paths.assign(count.n_law_path, 0);
  Placed there{memory.numbers.data(), memory.ids.data(), memory.law_paths.data()};
  place(l, m, t, there);
  fill_joints(l, m, t);
  fill_blocks(l, m, t);
  for (std::ptrdiff_t i = 0; i <= t.n_block; ++i)  // no turn: w = 1
    std::fill_n(t.shift + (4 * i + 3) * t.lanes, t.lanes, 1.0);
  return t;
}

}  // namespace wythe::dynamics::space
