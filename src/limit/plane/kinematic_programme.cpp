// Kinematic theorem: the mechanism with the least load.
//
// Columns: velocities vx, vy, omega of each block | multipliers >= 0, one for each face of a joint's
// yield surface. Rows: slip of each joint and opening of its points follow from its multipliers
// (associated flow: sliding dilates by mu); the load has unit power.
//
//   slip = v_t(b) - v_t(a) = a2 - a1     opening_k = v_n(b) - v_n(a) at point k
//        = mu (a1 + a2) + u_k - v_k + tangents
#include <array>
#include <cmath>

#include "core/elementary.h"
#include "limit/plane/programmes.h"

namespace wythe::limit {
namespace {

class KinematicProgramme {
 public:
  KinematicProgramme(const Model& m, const LimitLoads& loads, const YieldModel& y,
                     const Units& units)
      : m_(m), loads_(loads), y_(y), u_(units), tangents_of_(y.joint.size()) {
    for (std::size_t t = 0; t < y.tangent.size(); ++t)
      tangents_of_[y.tangent[t].joint].push_back(t);
  }

  void build() {
    for (int i = 0; i < m_.n_block; ++i) add_block(static_cast<std::size_t>(i));
    for (int j = 0; j < m_.n_joint; ++j) add_joint(j);
    for (std::size_t k = 0; k < y_.link.size(); ++k) add_link(k);
    add_unit_power();
  }

  KinematicSolution solve(const Monitor& monitor) {
    KinematicSolution answer;
    answer.status = lp_.solve(monitor);
    answer.accuracy = lp_.accuracy();
    if (answer.status != ProgrammeStatus::kOptimal) return answer;
    answer.load = lp_.objective() * (loads_.is_force ? u_.force : 1.0);
    const std::vector<double>& x = lp_.solution();
    // unit power is load x velocity in scaled units; a factor's load is a weight
    const double scale = loads_.is_force ? 1.0 : 1.0 / u_.force;
    for (int i = 0; i < m_.n_block; ++i) {
      const std::size_t c = 3 * i;
      answer.vx.push_back(x[c] * scale);
      answer.vy.push_back(x[c + 1] * scale);
      answer.omega.push_back(x[c + 2] * scale / u_.length);
    }
    for (std::size_t k = 0; k < capacity_.size(); ++k)
      answer.dissipation += capacity_[k] * x[static_cast<std::size_t>(3 * m_.n_block) + k];
    answer.dissipation *= u_.force * scale;
    return answer;
  }

 private:
  // Objective: the power of the dead loads, negative.
  void add_block(std::size_t i) {
    const BlockForce& f = loads_.dead[i];
    const bool across_y = loads_.held_across[i] && loads_.stage->drive_x != 0;
    const bool across_x = loads_.held_across[i] && loads_.stage->drive_x == 0;
    const auto add = [&](bool held, double force) {
      lp_.add_column(held ? 0 : -kFree, held ? 0 : kFree, -force / u_.force);
    };
    add(across_x, f.fx);
    add(across_y, f.fy);
    add(loads_.held_turn[i] != 0, f.moment / u_.length);
  }

  int add_multiplier(double capacity) {
    capacity_.push_back(capacity / u_.force);
    return lp_.add_column(0, kFree, capacity / u_.force);
  }

  // Velocity of block b relative to a along `axis`, at the joint's centre + xi e.
  [[nodiscard]] std::vector<Entry> relative(int j, std::array<double, 2> axis, double xi) const {
    std::vector<Entry> row;
    const double ex = xi * m_.half_x[j], ey = xi * m_.half_y[j];
    add_motion(row, m_.joint_b[j], 1, axis, m_.arm_b_x[j] + ex, m_.arm_b_y[j] + ey);
    add_motion(row, m_.joint_a[j], -1, axis, m_.arm_a_x[j] + ex, m_.arm_a_y[j] + ey);
    return row;
  }

  // Velocity along `axis` of the point of a block at arm (x, y).
  void add_motion(std::vector<Entry>& row, BlockId block, double sign, std::array<double, 2> axis,
                  double x, double y) const {
    if (block == kGroundBlock) return;
    row.push_back({3 * block, sign * axis[0]});
    row.push_back({3 * block + 1, sign * axis[1]});
    row.push_back({3 * block + 2, sign * (x * axis[1] - y * axis[0]) / u_.length});
  }

  void add_joint(int j) {
    const JointYield& y = y_.joint[j];
    const std::array<double, 2> t{m_.tangent_x[j], m_.tangent_y[j]}, n{-t[1], t[0]};
    std::vector<Entry> slip = relative(j, t, 0);
    int sliding[2] = {-1, -1};
    if (!std::isinf(y.cohesion)) {
      for (int& multiplier : sliding) multiplier = add_multiplier(y.cohesion);
      slip.push_back({sliding[0], 1.0});
      slip.push_back({sliding[1], -1.0});
    }
    lp_.add_row(slip, 0, 0);
    std::vector<int> tangents;
    for (const std::size_t at : tangents_of_[j])
      tangents.push_back(add_multiplier(y_.tangent[at].capacity / u_.length));
    for (std::size_t k = 0; k < y_.points(); ++k) {
      std::vector<Entry> opening = relative(j, n, y_.xi[k]);
      for (const int multiplier : sliding)
        if (multiplier >= 0) opening.push_back({multiplier, -y.friction});
      if (!std::isinf(y.tension))
        opening.push_back({add_multiplier(y.tension * y_.weight[k]), -1.0});
      if (!std::isinf(y.compression))
        opening.push_back({add_multiplier(y.compression * y_.weight[k]), 1.0});
      add_tangent_flow(j, k, tangents, opening);
      lp_.add_row(opening, 0, 0);
    }
  }

  // A link changes its length at its limit forces; an unlimited one keeps its length.
  void add_link(std::size_t k) {
    const Links& l = m_.links;
    const double length = elementary::hypot(l.span_x[k], l.span_y[k]);
    const std::array<double, 2> n{l.span_x[k] / length, l.span_y[k] / length};
    std::vector<Entry> row;
    add_motion(row, l.b[k], 1, n, l.arm_b_x[k], l.arm_b_y[k]);
    add_motion(row, l.a[k], -1, n, l.arm_a_x[k], l.arm_a_y[k]);
    if (!std::isinf(y_.link[k].tension)) row.push_back({add_multiplier(y_.link[k].tension), -1.0});
    if (!std::isinf(y_.link[k].compression))
      row.push_back({add_multiplier(y_.link[k].compression), 1.0});
    lp_.add_row(row, 0, 0);
  }

  void add_tangent_flow(int j, std::size_t k, const std::vector<int>& multipliers,
                        std::vector<Entry>& opening) const {
    const auto& of_joint = tangents_of_[j];
    for (std::size_t i = 0; i < of_joint.size(); ++i) {
      const Tangent& t = y_.tangent[of_joint[i]];
      const double reach = y_.joint[j].half_length;
      opening.push_back({multipliers[i], (t.sign * reach * y_.xi[k] - t.slope) / u_.length});
    }
  }

  void add_unit_power() {
    const Stage& stage = *loads_.stage;
    if (loads_.together) {
      for (const BlockId b : stage.driven)
        lp_.add_row({{3 * b, loads_.push_x}, {3 * b + 1, loads_.push_y}}, 1, 1);
      return;
    }
    const double scale = loads_.is_force ? 1.0 : 1.0 / u_.force;
    std::vector<Entry> power;
    for (int i = 0; i < m_.n_block; ++i) {
      const BlockForce& g = loads_.growing[i];
      power.push_back({3 * i, g.fx * scale});
      power.push_back({3 * i + 1, g.fy * scale});
      if (g.moment != 0) power.push_back({3 * i + 2, g.moment * scale / u_.length});
    }
    lp_.add_row(power, 1, 1);
  }

  const Model& m_;
  const LimitLoads& loads_;
  const YieldModel& y_;
  Units u_;
  LinearProgramme lp_;
  std::vector<std::vector<std::size_t>> tangents_of_;  // for each joint, into YieldModel::tangent
  std::vector<double> capacity_;                       // for each multiplier, in force units
};

}  // namespace

KinematicSolution solve_kinematic(const Model& model, const LimitLoads& loads,
                                  const YieldModel& yield, const Units& units,
                                  const Monitor& monitor) {
  KinematicProgramme programme(model, loads, yield, units);
  programme.build();
  return programme.solve(monitor);
}

}  // namespace wythe::limit
