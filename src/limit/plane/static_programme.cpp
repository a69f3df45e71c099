// Static theorem: forces in equilibrium within the strength of joints.
//
// Columns: load | per joint: shear s, compressions p_k | per link: its force | per driven block: its
// force, where driven blocks share one velocity. Rows: equilibrium of each block (x, y, moment), two sliding planes a joint,
// tangents of stress blocks.
#include <algorithm>
#include <array>
#include <cmath>

#include "core/elementary.h"
#include "limit/plane/programmes.h"

namespace wythe::limit {
namespace {

constexpr int kRounds = 60;        // of tangents; the tuff wall needs about 10
constexpr double kSettled = 1e-8;  // a round that changes the load by less is the last

class StaticProgramme : public StaticRows<3> {
 public:
  StaticProgramme(const Model& m, const LimitLoads& loads, const YieldModel& y, const Units& units)
      : StaticRows(m, units, loads.is_force), loads_(loads), y_(y) {}

  // For kUnbalanced, unbalanced forces have a cost.
  void build(Purpose purpose) {
    add_load(purpose);
    for (int j = 0; j < m_.n_joint; ++j) add_joint(j);
    for (std::size_t k = 0; k < y_.link.size(); ++k) add_link(k);
    add_loads();
    if (purpose == Purpose::kUnbalanced) add_slack();
    add_balance();
    for (int j = 0; j < m_.n_joint; ++j) add_sliding(j);
    add_tangents();
  }

  void add_tangents() {
    for (; tangents_ < y_.tangent.size(); ++tangents_) {
      const Tangent& t = y_.tangent[tangents_];
      const double reach = y_.joint[t.joint].half_length;
      std::vector<Entry> row;
      for (std::size_t k = 0; k < y_.points(); ++k)
        row.push_back({point(t.joint, k), (t.sign * reach * y_.xi[k] - t.slope) / u_.length});
      lp_.add_row(row, -kFree, t.capacity / (u_.force * u_.length));
    }
  }

  StaticSolution solve(const Monitor& monitor, const Tolerance& tolerance) {
    StaticSolution answer;
    if (!solve_for(answer, monitor, tolerance, [this](int j) { return shear(j); })) return answer;
    const std::vector<double>& x = lp_.solution();
    for (int j = 0; j < m_.n_joint; ++j) {
      answer.shear.push_back(x[shear(j)] * u_.force);
      for (std::size_t k = 0; k < y_.points(); ++k)
        answer.point_force.push_back(x[point(j, k)] * u_.force);
    }
    add_motion(answer.dual);
    return answer;
  }

 private:
  void add_motion(KinematicSolution& m) const {
    const double scale = loads_.is_force ? 1.0 : 1.0 / u_.force;
    const auto velocity = [&](std::size_t block, std::size_t axis) {
      const int row = balance_row_[3 * block + axis];
      return row < 0 ? 0.0 : scale * lp_.multipliers()[row];
    };
    for (std::size_t i = 0; i < loads_.dead.size(); ++i) {
      m.vx.push_back(velocity(i, 0));
      m.vy.push_back(velocity(i, 1));
      m.omega.push_back(velocity(i, 2) / u_.length);
      const BlockForce& f = loads_.dead[i];
      m.dissipation += f.fx * m.vx[i] + f.fy * m.vy[i] + f.moment * m.omega[i];
    }
  }

  [[nodiscard]] int shear(int j) const { return 1 + j * static_cast<int>(1 + y_.points()); }
  [[nodiscard]] int point(int j, std::size_t k) const { return shear(j) + 1 + static_cast<int>(k); }

  void put(BlockId block, int axis, int column, double value) {
    balance_[3 * static_cast<std::size_t>(block) + static_cast<std::size_t>(axis)].push_back(
        {column, value});
  }

  // Adds a unit force (fx, fy) at arm (x, y) of a block, scaled by `column`.
  void act(BlockId block, int column, std::array<double, 2> force, std::array<double, 2> arm) {
    if (block == kGroundBlock) return;
    put(block, 0, column, force[0]);
    put(block, 1, column, force[1]);
    put(block, 2, column, (arm[0] * force[1] - arm[1] * force[0]) / u_.length);
  }

  void add_joint(int j) {
    const JointYield& y = y_.joint[j];
    const std::array<double, 2> t{m_.tangent_x[j], m_.tangent_y[j]}, n{-t[1], t[0]};
    lp_.add_column(-kFree, kFree, 0);
    act(m_.joint_b[j], shear(j), t, {m_.arm_b_x[j], m_.arm_b_y[j]});
    act(m_.joint_a[j], shear(j), {-t[0], -t[1]}, {m_.arm_a_x[j], m_.arm_a_y[j]});
    for (std::size_t k = 0; k < y_.points(); ++k) {
      lp_.add_column(-y.tension * y_.weight[k] / u_.force, y.compression * y_.weight[k] / u_.force,
                     0);
      const double ex = y_.xi[k] * m_.half_x[j], ey = y_.xi[k] * m_.half_y[j];
      act(m_.joint_b[j], point(j, k), n, {m_.arm_b_x[j] + ex, m_.arm_b_y[j] + ey});
      act(m_.joint_a[j], point(j, k), {-n[0], -n[1]}, {m_.arm_a_x[j] + ex, m_.arm_a_y[j] + ey});
    }
  }

  // Columns of links directly follow those of joints.
  void add_link(std::size_t k) {
    const Links& l = m_.links;
    const double length = elementary::hypot(l.span_x[k], l.span_y[k]);
    const double x = l.span_x[k] / length, y = l.span_y[k] / length;
    const int column =
        lp_.add_column(-y_.link[k].compression / u_.force, y_.link[k].tension / u_.force, 0);
    act(l.a[k], column, {x, y}, {l.arm_a_x[k], l.arm_a_y[k]});
    act(l.b[k], column, {-x, -y}, {l.arm_b_x[k], l.arm_b_y[k]});
  }

  void add_loads() {
    const double scale = loads_.is_force ? 1.0 : 1.0 / u_.force;
    for (int i = 0; i < m_.n_block; ++i) {
      const BlockForce& g = loads_.growing[i];
      put(i, 0, load_, g.fx * scale);
      put(i, 1, load_, g.fy * scale);
      if (g.moment != 0) put(i, 2, load_, g.moment * scale / u_.length);
    }
    if (!loads_.together) return;
    const Stage& push = *loads_.stage;
    std::vector<Entry> sum{{load_, -1.0}};
    for (const BlockId b : push.driven) {
      const int column = lp_.add_column(-kFree, kFree, 0);
      put(b, 0, column, loads_.push_x);
      put(b, 1, column, loads_.push_y);
      sum.push_back({column, 1.0});
    }
    sum_ = sum;
  }

  [[nodiscard]] bool is_held(std::size_t block, int axis) const {
    if (axis == 2) return loads_.held_turn[block] != 0;
    const bool across = loads_.stage->drive_x != 0 ? axis == 1 : axis == 0;
    return across && loads_.held_across[block] != 0;
  }

  void add_balance() {
    for (std::size_t i = 0; i < loads_.dead.size(); ++i) {
      const BlockForce& f = loads_.dead[i];
      const double wanted[3] = {-f.fx, -f.fy, -f.moment / u_.length};
      for (int axis = 0; axis < 3; ++axis) {
        const auto row = 3 * i + static_cast<std::size_t>(axis);
        const double right = wanted[axis] / u_.force;
        balance_row_.push_back(is_held(i, axis) ? -1 : lp_.add_row(balance_[row], right, right));
      }
    }
    if (!sum_.empty()) lp_.add_row(sum_, 0, 0);
  }

  void add_sliding(int j) {
    const JointYield& y = y_.joint[j];
    if (std::isinf(y.cohesion)) return;
    for (const double sign : {1.0, -1.0}) {
      std::vector<Entry> row{{shear(j), sign}};
      for (std::size_t k = 0; k < y_.points(); ++k) row.push_back({point(j, k), -y.friction});
      lp_.add_row(row, -kFree, y.cohesion / u_.force);
    }
  }

  const LimitLoads& loads_;
  const YieldModel& y_;
  std::size_t tangents_ = 0;
};

}  // namespace

Units units_of(const Model& model, const LimitLoads& loads, const YieldModel& yield) {
  Units units{0, 0};
  for (const BlockForce& f : loads.dead) units.force += elementary::hypot(f.fx, f.fy);
  for (const JointYield& y : yield.joint) units.length += y.half_length;
  units.force /= std::max(1, model.n_block);
  units.length *= 2.0 / std::max(1, model.n_joint);
  if (!(units.force > 0)) units.force = 1000;
  if (!(units.length > 0)) units.length = 1;
  return units;
}

StaticSolution solve_static(const Model& model, const LimitLoads& loads, YieldModel& yield,
                            const Units& units, const Monitor& monitor,
                            const Tolerance& tolerance) {
  StaticProgramme programme(model, loads, yield, units);
  programme.build(Purpose::kLoad);
  StaticSolution answer = programme.solve(monitor, tolerance);
  for (int round = 0; round < kRounds && answer.status == ProgrammeStatus::kOptimal; ++round) {
    if (cut_stress_blocks(yield, answer.point_force) == 0) break;
    const double before = answer.load;
    programme.add_tangents();
    answer = programme.solve(monitor, tolerance);
    if (std::fabs(answer.load - before) <= kSettled * std::fabs(before)) break;
  }
  if (answer.status == ProgrammeStatus::kOptimal) drop_idle_tangents(yield, answer.point_force);
  return answer;
}

ProgrammeStatus find_rest(const Model& model, const LimitLoads& loads, const YieldModel& yield,
                          const Units& units, const Monitor& monitor) {
  StaticProgramme programme(model, loads, yield, units);
  programme.build(Purpose::kRest);
  return programme.stands(monitor);
}

Unbalanced find_unbalanced(const Model& model, const LimitLoads& loads, const YieldModel& yield,
                           const Units& units, const Monitor& monitor) {
  StaticProgramme programme(model, loads, yield, units);
  programme.build(Purpose::kUnbalanced);
  return programme.worst(monitor);
}

}  // namespace wythe::limit
