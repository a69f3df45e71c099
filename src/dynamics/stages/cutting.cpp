// What is put up goes where it fits its neighbours (23.3). What its joints, sections and links have there counts as
// without stress, and a gap opens only after its joints are free. Then a step of almost no length tells what each
// touched block lacks of balance (23.1). Stored energy that left goes into work_loads, so the ledger closes.
#include "dynamics/stages/cutting.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <vector>

#include "core/elementary.h"
#include "dynamics/executors/executor.h"
#include "dynamics/executors/processor.h"
#include "dynamics/meters/residual.h"
#include "reading/frames.h"
#include "wythe/parts/reading.h"

namespace wythe::dynamics {
namespace {

// Displacement of a place on a block [m]; `arm` from its centroid.
struct Moved2 {
  double x, y;
};
Moved2 moved_at(const State& s, BlockId block, double arm_x, double arm_y) {
  if (block == kGroundBlock) return {0, 0};
  const auto i = static_cast<std::size_t>(block);
  const SinCos<double> half = sin_cos(0.5 * s.theta[i]);
  const contact::LinkEnd end =
      contact::link_end(s.ux[i], s.uy[i], half.cos, half.sin, arm_x, arm_y);
  return {end.moved_x, end.moved_y};
}

// Of three equations with a symmetric matrix, by Cramer's rule.
Vec3 solved(const Vec3 (&m)[3], const Vec3& right) {
  const double whole = dot(m[0], cross(m[1], m[2]));
  return {dot(right, cross(m[1], m[2])) / whole, dot(m[0], cross(right, m[2])) / whole,
          dot(m[0], cross(m[1], right)) / whole};
}

// What is put up in a stage, on its way to where it fits.
class Fitter {
 public:
  Fitter(const Model& model, State& state) : m_(model), s_(state), stage_(state.stage) {}

  void fit() {
    find_groups();
    find_mean();
    for (const auto& [group, blocks] : groups_) place(blocks);
    release_joints();  // before the gap, which opens from there
    for (std::size_t k = 0; k < m_.frames.moved.size(); ++k) {
      const BlockId block = m_.frames.moved[k];
      if (!is_new(block)) continue;
      s_.ux[block] += m_.frames.moved_x[k];
      s_.uy[block] += m_.frames.moved_y[k];
    }
    release_sections();
    let_go_of_links();
  }

 private:
  [[nodiscard]] bool is_new(BlockId block) const {
    return block >= 0 && m_.standing.from[block] == stage_ && stage_ > 0;
  }

  // A segment of a frame is placed by itself; a lintel or sill is one stiff body, held together by its chain.
  void find_groups() {
    std::vector<BlockId> group(static_cast<std::size_t>(m_.n_block));
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

  // act(new block, place seen from its centroid, displacement of the neighbour there, tangent, weight) at every point
  // where something new meets what stands.
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

  // Displacement (u, v) and turn of a stiff body that fits its neighbours best: in the mean of squares across the faces,
  // and faintly along them and to the mean of all, where the faces leave it free.
  void place(const std::vector<BlockId>& blocks) {
    constexpr double kAlong = 1e-3, kFaint = 1e-6;
    const auto first = static_cast<std::size_t>(blocks.front());
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
      const auto i = static_cast<std::size_t>(block);
      const double x = m_.centroid_x[i] - cx, y = m_.centroid_y[i] - cy;
      const double sine = elementary::sin(q.z),
                   drop = -2 * elementary::pow(elementary::sin(0.5 * q.z), 2);
      s_.ux[i] = q.x + drop * x - sine * y;
      s_.uy[i] = q.y + sine * x + drop * y;
      s_.theta[i] = q.z;
    }
  }

  // The slip and the opening that are there when something is put up have no stress, as if fresh mortar filled what room
  // there is: a bed narrower than drawn counts as shortened (crush), a wider one as lengthened, as dilatancy does.
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

  void let_go_of_links() {
    const std::vector<LinkReading> links = read_links(m_, s_);
    for (std::size_t k = 0; k < links.size(); ++k)
      if (m_.standing.begins(m_.links.a[k], m_.links.b[k], stage_))
        s_.link_drawn[k] = -links[k].elongation;
  }

  const Model& m_;
  State& s_;
  int stage_;
  std::map<BlockId, std::vector<BlockId>> groups_;
  Moved2 mean_{0, 0};
};

// Blocks that meet what comes or goes in this stage, and what comes.
std::vector<BlockId> touched(const Model& m, int stage) {
  const auto changes = [&](BlockId i) {
    return i >= 0 && m.standing.holds(i, stage) != m.standing.holds(i, stage - 1);
  };
  std::vector<bool> found(static_cast<std::size_t>(m.n_block), false);
  const auto join = [&](BlockId a, BlockId b) {
    for (const auto& [own, other] : {std::pair(a, b), std::pair(b, a)})
      if (own >= 0 && m.standing.holds(own, stage) && (changes(own) || changes(other)))
        found[own] = true;
  };
  for (std::size_t j = 0; j < m.joint_a.size(); ++j) join(m.joint_a[j], m.joint_b[j]);
  for (std::size_t k = 0; k < m.frames.a.size(); ++k) join(m.frames.a[k], m.frames.b[k]);
  std::vector<BlockId> blocks;
  for (BlockId i = 0; i < m.n_block; ++i)
    if (found[i]) blocks.push_back(i);
  return blocks;
}

// What each of these blocks lacks of balance without what was cut out, turned round: a load that holds it.
void set_release(const Model& m, State& s, double dt) {
  for (std::vector<double>* all : {&s.release_x, &s.release_y, &s.release_m})
    std::fill(all->begin(), all->end(), 0.0);
  constexpr double kAnInstant = 1e-9;  // of the step: nothing moves
  State scratch = s;
  Processor instant(m, 1);
  instant.load_wall(0, m, scratch);
  Controls controls;
  controls.dt = kAnInstant * dt;
  instant.set(0, controls);
  static_cast<Executor&>(instant).step();
  const WallView& wall = instant.view(0);
  for (const BlockId i : touched(m, s.stage)) {
    const BlockForce<double> f = contact_force(wall.t, i, 0);
    const double heavy = wall.block(i, kGravityMass);
    s.release_x[i] = -(f.x + wall.block(i, kLoadX) + heavy * wall.wall_value(kGravityX));
    s.release_y[i] = -(f.y + wall.block(i, kLoadY) + heavy * wall.wall_value(kGravityY));
    s.release_m[i] = -(f.m + wall.block(i, kLoadM));
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
  if (state.stage_time > 0 || !model.standing.any()) return;
  wall.access->store_state(state);
  const double before = stored(model, state, state.stage - 1);
  Fitter(model, state).fit();
  set_release(model, state, stage_time_step(model, model.stages[state.stage]));
  // what was stored in what is gone leaves with it
  state.work_loads += stored(model, state, state.stage) - before;
  wall.access->reload_wall(state);
}

}  // namespace wythe::dynamics
