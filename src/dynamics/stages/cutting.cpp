// New blocks are placed where they fit their neighbours (23.3). Their joints, sections and links start without
// stress, and a gap opens only after its joints are released. Then a step of almost no length gives the unbalanced
// force of each touched block (23.1). Stored energy of removed masonry goes into work_loads, so the ledger closes.
#include "dynamics/stages/cutting.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <vector>

#include "core/elementary.h"
#include "core/rotation.h"
#include "dynamics/executors/executor.h"
#include "dynamics/executors/processor.h"
#include "dynamics/meters/residual.h"
#include "dynamics/space/executor.h"
#include "reading/frames.h"
#include "reading/readers.h"
#include "reading/space_frames.h"
#include "wythe/parts/reading.h"

namespace wythe::dynamics {
namespace {

// Displacement of a place on a block [m]; `arm` from its centroid.
struct Moved2 {
  double x, y;
};
Moved2 moved_at(const State& s, BlockId block, double arm_x, double arm_y) {
  if (block == kGroundBlock) return {0, 0};
  const std::size_t i = block;
  const SinCos<double> half = sin_cos(0.5 * s.theta[i]);
  const contact::LinkEnd end =
      contact::link_end(s.ux[i], s.uy[i], half.cos, half.sin, arm_x, arm_y);
  return {end.moved_x, end.moved_y};
}

// Solves three equations with a symmetric matrix by Cramer's rule.
Vec3 solved(const Vec3 (&m)[3], const Vec3& right) {
  const double whole = dot(m[0], cross(m[1], m[2]));
  return {dot(right, cross(m[1], m[2])) / whole, dot(m[0], cross(right, m[2])) / whole,
          dot(m[0], cross(m[1], right)) / whole};
}

// The blocks that a stage puts up, and the parts of placing them that are the same in the plane and in space.
class PutUp {
 protected:
  PutUp(const Model& model, State& state) : m_(model), s_(state), stage_(state.stage) {
    find_groups();
  }

  [[nodiscard]] bool is_new(BlockId block) const {
    return block >= 0 && block < m_.n_block && m_.standing.from[block] == stage_ && stage_ > 0;
  }

  void move_by_gaps() {
    const Frames& f = m_.frames;
    for (std::size_t k = 0; k < f.moved.size(); ++k) {
      const BlockId block = f.moved[k];
      if (!is_new(block)) continue;
      s_.ux[block] += f.moved_x[k];
      s_.uy[block] += f.moved_y[k];
      if (!f.moved_z.empty()) s_.uz[block] += f.moved_z[k];
    }
  }

  void release_links() {
    const std::vector<LinkReading> links = read_links(m_, s_);
    for (std::size_t k = 0; k < links.size(); ++k)
      if (m_.standing.begins(m_.links.a[k], m_.links.b[k], stage_))
        s_.link_drawn[k] = -links[k].elongation;
  }

  const Model& m_;
  State& s_;
  int stage_;
  std::map<BlockId, std::vector<BlockId>> groups_;  // sets of blocks that are placed together

 private:
  // A segment of a frame is placed by itself. A lintel or sill is placed as one stiff body, joined by its chain.
  void find_groups() {
    std::vector<BlockId> group(m_.n_block);
    for (BlockId i = 0; i < m_.n_block; ++i) group[i] = i;
    const auto root = [&](BlockId i) {
      while (group[i] != i) i = group[i];
      return i;
    };
    for (JointId j = 0; j < m_.n_joint; ++j)
      if (m_.anatomy.joint_kind[j] == JointKind::kLintelChain && is_new(m_.joint_a[j]) &&
          is_new(m_.joint_b[j]))
        group[root(m_.joint_a[j])] = root(m_.joint_b[j]);
    for (BlockId i = 0; i < m_.n_block; ++i)
      if (is_new(i)) groups_[root(i)].push_back(i);
  }
};

// Places the blocks that a stage puts up where they fit.
class Fitter : PutUp {
 public:
  Fitter(const Model& model, State& state) : PutUp(model, state) {}

  void fit() {
    find_mean();
    for (const auto& [group, blocks] : groups_) place(blocks);
    release_joints();  // before the gap opens: it is measured from here
    move_by_gaps();
    release_sections();
    release_links();
  }

 private:
  // Calls act(new block, place seen from its centroid, displacement of the neighbour
  // there, tangent, weight) at every point where a new block touches a standing one.
  template <class Act>
  void each_meeting(const Act& act) const {
    for (std::size_t j = 0; j < static_cast<std::size_t>(m_.n_joint); ++j) {
      const BlockId a = m_.joint_a[j], b = m_.joint_b[j];
      if (is_new(a) == is_new(b) || !m_.standing.joins(a, b, stage_)) continue;
      for (std::size_t p = 0; p < m_.point_xi.size(); ++p) {
        const double ex = m_.point_xi[p] * m_.half_x[j], ey = m_.point_xi[p] * m_.half_y[j];
        const bool b_is_new = is_new(b);
        const BlockId own = b_is_new ? b : a, other = b_is_new ? a : b;
        const double arm_x = (b_is_new ? m_.arm_b_x[j] : m_.arm_a_x[j]) + ex;
        const double arm_y = (b_is_new ? m_.arm_b_y[j] : m_.arm_a_y[j]) + ey;
        const double far_x = (b_is_new ? m_.arm_a_x[j] : m_.arm_b_x[j]) + ex;
        const double far_y = (b_is_new ? m_.arm_a_y[j] : m_.arm_b_y[j]) + ey;
        act(own, Vec2{arm_x, arm_y}, moved_at(s_, other, far_x, far_y),
            Vec2{m_.tangent_x[j], m_.tangent_y[j]}, m_.area[j] * m_.point_weight[p]);
      }
    }
  }

  void find_mean() {
    double sum = 0;
    each_meeting([&](BlockId, Vec2, Moved2 to, Vec2, double weight) {
      mean_.x += weight * to.x, mean_.y += weight * to.y;
      sum += weight;
    });
    if (sum > 0) mean_.x /= sum, mean_.y /= sum;
  }

  // Displacement (u, v) and turn of a stiff body that fit its neighbours best, by least squares across
  // the faces. Where the faces leave it free, small weights fit it along them and to the mean of all.
  void place(const std::vector<BlockId>& blocks) {
    constexpr double kAlong = 1e-3, kFaint = 1e-6;
    const std::size_t first = blocks.front();
    const double cx = m_.centroid_x[first], cy = m_.centroid_y[first];
    Vec3 normal[3] = {}, wanted;  // rows of the equations of least squares
    const auto want = [&](const Vec3& row, double value, double weight) {
      const double part[3] = {row.x, row.y, row.z};
      for (int k = 0; k < 3; ++k) normal[k] = normal[k] + weight * part[k] * row;
      wanted = wanted + weight * value * row;
    };
    double weights = 0;
    each_meeting([&](BlockId own, Vec2 arm, Moved2 to, Vec2 t, double weight) {
      if (std::find(blocks.begin(), blocks.end(), own) == blocks.end()) return;
      const double x = m_.centroid_x[own] + arm.x - cx, y = m_.centroid_y[own] + arm.y - cy;
      want({-t.y, t.x, x * t.x + y * t.y}, to.y * t.x - to.x * t.y, weight);
      want({t.x, t.y, x * t.y - y * t.x}, to.x * t.x + to.y * t.y, kAlong * weight);
      weights += weight;
    });
    const double faint = weights > 0 ? kFaint * weights : 1;
    want({1, 0, 0}, mean_.x, faint);
    want({0, 1, 0}, mean_.y, faint);
    want({0, 0, 1}, 0, faint);
    const Vec3 q = solved(normal, wanted);
    for (const BlockId block : blocks) {
      const std::size_t i = block;
      const double x = m_.centroid_x[i] - cx, y = m_.centroid_y[i] - cy;
      const double sine = elementary::sin(q.z),
                   drop = -2 * elementary::pow(elementary::sin(0.5 * q.z), 2);
      s_.ux[i] = q.x + drop * x - sine * y;
      s_.uy[i] = q.y + sine * x + drop * y;
      s_.theta[i] = q.z;
    }
  }

  // Slip and opening at the time of placing cause no stress, as if fresh mortar filled the space. A
  // bed thinner than drawn counts as shortened (crush), a thicker one as lengthened, as by dilatancy.
  void release_joints() {
    const std::vector<PointReading> points = read_points(m_, s_);
    for (JointId j = 0; j < m_.n_joint; ++j) {
      const BlockId a = m_.joint_a[j], b = m_.joint_b[j];
      if (!is_new(a) && !is_new(b)) continue;
      const PointRange range = points_of(m_, j);
      for (PointId p = range.begin; p < range.end; ++p) {
        s_.plastic_slip[p] = points[p].slip;
        s_.crush[p] = -points[p].opening;
      }
    }
  }

  void release_sections() {
    const Frames& f = m_.frames;
    for (std::size_t k = 0; k < f.a.size(); ++k) {
      if (!is_new(f.b[k])) continue;
      const contact::SectionJump jump = reading::section_in(m_, s_, k).jump;
      s_.frame_along[k] = jump.along;
      s_.frame_across[k] = jump.across;
      s_.frame_turn[k] = jump.turn;
    }
  }

  Moved2 mean_{0, 0};
};

// Standing blocks that are new, or that touch masonry which this stage removes or adds.
std::vector<BlockId> touched(const Model& m, int stage) {
  const auto changes = [&](BlockId i) {
    return i >= 0 && i < m.n_block && m.standing.holds(i, stage) != m.standing.holds(i, stage - 1);
  };
  std::vector<bool> found(m.n_block, false);
  const auto join = [&](BlockId a, BlockId b) {
    for (const auto& [own, other] : {std::pair(a, b), std::pair(b, a)})
      if (own >= 0 && own < m.n_block && m.standing.holds(own, stage) &&
          (changes(own) || changes(other)))
        found[own] = true;
  };
  for (std::size_t j = 0; j < m.joint_a.size(); ++j) join(m.joint_a[j], m.joint_b[j]);
  for (std::size_t k = 0; k < m.frames.a.size(); ++k) join(m.frames.a[k], m.frames.b[k]);
  for (std::size_t k = 0; k < m.layers.cross_a.size(); ++k)
    join(m.layers.cross_a[k], m.layers.cross_b[k]);
  std::vector<BlockId> blocks;
  for (BlockId i = 0; i < m.n_block; ++i)
    if (found[i]) blocks.push_back(i);
  return blocks;
}

// As Fitter, for blocks in space.
class SpaceFitter : PutUp {
 public:
  SpaceFitter(const Model& model, State& state) : PutUp(model, state) {}

  void fit() {
    find_mean();
    for (const auto& [group, blocks] : groups_) place(blocks);
    release_joints();  // before the gap opens: it is measured from here
    move_by_gaps();
    release_sections();
    release_links();
  }

 private:
  // The least squares equations for displacement and turn of a group's origin.
  struct Squares {
    std::array<std::array<double, 7>, 6> rows{};  // the last column: the right-hand side
    void want(Vec3 along, Vec3 arm, double value, double weight) {
      const Vec3 turn = cross(arm, along);
      const double row[6] = {along.x, along.y, along.z, turn.x, turn.y, turn.z};
      for (int i = 0; i < 6; ++i) {
        for (int k = 0; k < 6; ++k) rows[i][k] += weight * row[i] * row[k];
        rows[i][6] += weight * row[i] * value;
      }
    }
    // Solves the equations by elimination; the matrix is symmetric and positive definite.
    [[nodiscard]] std::array<double, 6> solved() const {
      auto m = rows;
      for (int i = 0; i < 6; ++i)
        for (int r = i + 1; r < 6; ++r) {
          const double share = m[r][i] / m[i][i];
          for (int k = i; k < 7; ++k) m[r][k] -= share * m[i][k];
        }
      std::array<double, 6> x{};
      for (int i = 5; i >= 0; --i) {
        x[i] = m[i][6];
        for (int k = i + 1; k < 6; ++k) x[i] -= m[i][k] * x[k];
        x[i] /= m[i][i];
      }
      return x;
    }
  };

  // Calls act(new block, place at the start, displacement of the neighbour there,
  // joint, weight) at every point where a new block touches a standing one.
  template <class Act>
  void each_meeting(const Act& act) const {
    for (JointId j = 0; j < m_.n_joint; ++j) {
      const BlockId a = m_.joint_a[j], b = m_.joint_b[j];
      if (is_new(a) == is_new(b) || !m_.standing.joins(a, b, stage_)) continue;
      const BlockId own = is_new(b) ? b : a, other = is_new(b) ? a : b;
      const Vec3 t1 = m_.space.tangent[j], t2 = cross(m_.space.normal[j], t1);
      for (auto p = m_.space.point_begin[j]; p < m_.space.point_begin[j + 1]; ++p) {
        const Vec3 on_face = m_.space.point_r1[p] * t1 + m_.space.point_r2[p] * t2;
        const Vec3 far = (is_new(b) ? m_.space.arm_a[j] : m_.space.arm_b[j]) + on_face;
        const Vec3 arm = (is_new(b) ? m_.space.arm_b[j] : m_.space.arm_a[j]) + on_face;
        act(own, m_.space.centroid[own] + arm, reading::moved_in_space(m_, s_, other, far), j,
            m_.area[j] * m_.space.point_share[p]);
      }
    }
  }

  void find_mean() {
    double sum = 0;
    each_meeting([&](BlockId, Vec3, Vec3 to, JointId, double weight) {
      mean_ = mean_ + weight * to;
      sum += weight;
    });
    if (sum > 0) mean_ = mean_ / sum;
  }

  void place(const std::vector<BlockId>& blocks) {
    constexpr double kAlong = 1e-3, kFaint = 1e-6;
    const Vec3 origin = m_.space.centroid[blocks.front()];
    Squares squares;
    double weights = 0, reach = 0;
    each_meeting([&](BlockId own, Vec3 where, Vec3 to, JointId j, double weight) {
      if (std::find(blocks.begin(), blocks.end(), own) == blocks.end()) return;
      const Vec3 arm = where - origin, n = m_.space.normal[j], t1 = m_.space.tangent[j];
      squares.want(n, arm, dot(n, to), weight);
      for (const Vec3& t : {t1, cross(n, t1)}) squares.want(t, arm, dot(t, to), kAlong * weight);
      weights += weight;
      reach = std::max(reach, dot(arm, arm));
    });
    const double faint = weights > 0 ? kFaint * weights : 1;
    for (const Vec3& axis : {Vec3{1, 0, 0}, Vec3{0, 1, 0}, Vec3{0, 0, 1}})
      squares.want(axis, {}, dot(axis, mean_), faint);
    // no turn where the faces leave it free
    for (int k = 3; k < 6; ++k) squares.rows[k][k] += faint * (reach > 0 ? reach : 1);
    const std::array<double, 6> q = squares.solved();
    const Vec3 moved{q[0], q[1], q[2]}, turn{q[3], q[4], q[5]};
    const double angle = length(turn);
    const SinCos<double> half = sin_cos(0.5 * angle);
    const double along = angle > 0 ? half.sin / angle : 0.5;
    const Quaternion<double> by{half.cos, {along * turn.x, along * turn.y, along * turn.z}};
    for (const BlockId i : blocks) {
      const Vec3 arm = m_.space.centroid[i] - origin;
      const Vector<double> swung = swing(by, Vector<double>{arm.x, arm.y, arm.z});
      s_.ux[i] = moved.x + swung.x;
      s_.uy[i] = moved.y + swung.y;
      s_.uz[i] = moved.z + swung.z;
      s_.qw[i] = by.w;
      s_.qx[i] = by.v.x;
      s_.qy[i] = by.v.y;
      s_.qz[i] = by.v.z;
    }
  }

  void release_joints() {
    for (JointId j = 0; j < m_.n_joint; ++j) {
      if (!is_new(m_.joint_a[j]) && !is_new(m_.joint_b[j])) continue;
      const std::vector<Vec3> gaps = reading::gaps_in_space(m_, s_, j);
      for (std::size_t k = 0; k < gaps.size(); ++k) {
        const std::size_t p = static_cast<std::size_t>(m_.space.point_begin[j]) + k;
        s_.plastic_slip[p] = gaps[k].x;
        s_.plastic_slip_2[p] = gaps[k].y;
        s_.crush[p] = -gaps[k].z;
      }
    }
  }

  void release_sections() {
    for (std::size_t k = 0; k < m_.frames.a.size(); ++k) {
      if (!is_new(m_.frames.b[k])) continue;
      const reading::SpaceSectionJump jump = reading::section_in_space(m_, s_, k);
      s_.frame_along[k] = jump.in_plane.along;
      s_.frame_across[k] = jump.in_plane.across;
      s_.frame_turn[k] = jump.in_plane.turn;
      s_.frame_aside[k] = jump.aside;
      s_.frame_lean[k] = jump.lean;
      s_.frame_twist[k] = jump.twist;
    }
  }

  Vec3 mean_;
};

// Makes a step of almost no length from a copy of the state: it gives the forces of all standing parts, and nothing moves.
template <class Walls>
void step_an_instant(const Model& m, double dt, State& scratch, Walls& instant) {
  constexpr double kAnInstant = 1e-9;  // of the time step
  instant.load_wall(0, m, scratch);
  Controls controls;
  controls.dt = kAnInstant * dt;
  instant.set(0, controls);
  static_cast<Executor&>(instant).step();
}

// For each touched block, the unbalanced force without the removed masonry, with opposite sign: a load that holds it.
void set_release(const Model& m, State& s, double dt) {
  for (std::vector<double>* all :
       {&s.release_x, &s.release_y, &s.release_m, &s.release_z, &s.release_mx, &s.release_my})
    std::fill(all->begin(), all->end(), 0.0);
  State scratch = s;
  if (dimension_of(m) == 3) {
    space::SpaceProcessor instant(m, 1);
    step_an_instant(m, dt, scratch, instant);
    const space::WallView& wall = instant.view(0);
    for (const BlockId i : touched(m, s.stage)) {
      const space::Load<double> contact = space::contact_load(wall.t, i, wall.lane);
      const space::Vec f = contact.f + wall.body_vector(i, space::kLoad) +
                           wall.body(i, space::kGravityMass) * wall.gravity();
      const space::Vec moment = contact.m + wall.body_vector(i, space::kLoadMoment);
      s.release_x[i] = -f.x, s.release_y[i] = -f.y, s.release_z[i] = -f.z;
      s.release_mx[i] = -moment.x, s.release_my[i] = -moment.y, s.release_m[i] = -moment.z;
    }
    return;
  }
  Processor instant(m, 1);
  step_an_instant(m, dt, scratch, instant);
  const WallView& wall = instant.view(0);
  for (const BlockId i : touched(m, s.stage)) {
    const BlockForce<double> f = contact_force(wall.t, i, 0);
    const double heavy = wall.block(i, kGravityMass);
    s.release_x[i] = -(f.x + wall.block(i, kLoadX) + heavy * wall.wall_value(kGravityX));
    s.release_y[i] = -(f.y + wall.block(i, kLoadY) + heavy * wall.wall_value(kGravityY));
    s.release_m[i] = -(f.m + wall.block(i, kLoadM));
  }
}

// A layer is removed with the masonry below it, and its fibres are cut at the edge.
void cut_layers(const Model& m, State& s) {
  const Layers& l = m.layers;
  for (std::size_t k = 0; k < l.a.size(); ++k) {
    if (!m.standing.joins(l.a[k], l.b[k], s.stage)) s.layer_broken[k] = 1;
    if (!m.standing.holds(l.a[k], s.stage)) s.layer_slip[k] = s.layer_reached[k] = 0;
  }
}

double stored(const Model& model, const State& state, int stage) {
  State then = state;
  then.stage = stage;
  return elastic_energy(model, then);
}

}  // namespace

void begin_cut(StageContext& wall) {
  const Model& model = wall.model;
  State& state = wall.state;
  if (state.progress.time > 0 || !model.standing.any()) return;
  wall.access->store_state(state);
  const double before = stored(model, state, state.stage - 1);
  cut_layers(model, state);
  if (dimension_of(model) == 3)
    SpaceFitter(model, state).fit();
  else
    Fitter(model, state).fit();
  set_release(model, state, stage_time_step(model, model.stages[state.stage]));
  // energy stored in removed masonry leaves with it
  state.energy.work_loads += stored(model, state, state.stage) - before;
  wall.access->reload_wall(state);
}

}  // namespace wythe::dynamics
