// Dashpots and Maxwell elements at the closed points of joints, and damping in proportion
// to mass (docs/theory/dynamics.md). Only some shakes have them, so joints are taken one
// by one after the pass over joints. The forces are added to the rows of joint forces.
//
//   at a point with  w_e < 0:   sigma += c_n dw/dt + q_n, so that it only presses;  tau += c_s ds/dt + q_s within friction
//                               q <- exp(-dt / T) q + share k (1 - exp(-dt / T)) T / dt  Delta w      (Maxwell elements)
//
// Rates are those of the half step before; the step is limited for this reason (stage_time_step). A force
// works on the mean of the velocities before and after the step, so its work is added when both are known.
#pragma once

#include <vector>

#include "contact/parameters.h"
#include "dynamics/passes/drive.h"
#include "dynamics/passes/joints.h"
#include "dynamics/passes/wall.h"
#include "model/shaking.h"

namespace wythe::dynamics {

// Viscous stresses of a point with known elastic stresses. Both are limited to what a closed joint can bear.
struct PointStress {
  double normal, shear_1, shear_2;  // [Pa]
};
struct ViscousStress {
  PointStress all, spring;  // spring: the share of the Maxwell element
};
// `dashpot` and `spring`: stresses without that limit.
[[nodiscard]] WYTHE_INLINE ViscousStress damp_point(const PointStress& elastic,
                                                    const PointStress& dashpot,
                                                    const PointStress& spring, double friction) {
  if (!(elastic.normal < 0)) return {{0, 0, 0}, {0, 0, 0}};
  const double normal = minimum(dashpot.normal + spring.normal, -elastic.normal);
  const double x = elastic.shear_1, y = elastic.shear_2;
  const double u = dashpot.shear_1 + spring.shear_1, v = dashpot.shear_2 + spring.shear_2;
  const double wanted = square_root(u * u + v * v);
  const double left = -friction * (elastic.normal + normal) - square_root(x * x + y * y);
  const double share = wanted > 0 ? clip(left / wanted, 0.0, 1.0) : 0.0;
  return {
      {normal, share * u, share * v},
      {minimum(spring.normal, -elastic.normal), share * spring.shear_1, share * spring.shear_2}};
}

// A point that closes within a step was closed for a part of it only. A force acts for one step, half of it before and half
// after. So the dashpot of a newly closed point acts for the half to come and for its share of the half before
// (docs/theory/dynamics.md, 14.6a). `motion`: motion of the point in the step, negative where it closes. `open`: present opening.
[[nodiscard]] inline double share_of_first_step(double open, double motion) {
  return open < 0 && open > motion ? 0.5 + open / motion : 1.0;
}
// Whether impacts rebound, so that the share of the first step matters. Without rebound a point sticks anyway.
[[nodiscard]] inline bool rebounds(const Dashpots& dashpots) {
  return dashpots.impact > 0 && dashpots.impact < kNoRebound;
}

// The change of stress q of a Maxwell element in a step, when its contact has stiffness
// k and moves by s at a constant rate. Exact solution: q <- kept q + gain k s.
struct MaxwellStep {
  double kept = 0, gain = 0;
  [[nodiscard]] WYTHE_INLINE double of(double q, double stiffness, double moved) const {
    return kept * q + gain * stiffness * moved;
  }
};
[[nodiscard]] inline MaxwellStep maxwell_step(const Dashpots& dashpots, double dt) {
  if (!(dashpots.spring_share > 0)) return {};
  const double h = dt / dashpots.relaxation, kept = exp_of_minus(h);
  return {kept, dashpots.spring_share * (1 - kept) / h};
}

// Stresses of the Maxwell elements at a wall's points. They are part of its state.
struct MaxwellStresses {
  std::vector<double> normal, shear_1, shear_2;  // empty where no stage has such elements
  bool bears = false;                            // some stress is not zero

  void load_state(const State& s) {
    normal = s.maxwell_normal, shear_1 = s.maxwell_shear, shear_2 = s.maxwell_shear_2;
    bears = true;
  }
  void store_state(State& s) const {
    s.maxwell_normal = normal, s.maxwell_shear = shear_1, s.maxwell_shear_2 = shear_2;
  }
  // Sets all stresses to zero, for a stage without Maxwell elements.
  void set_zero() {
    for (std::vector<double>* all : {&normal, &shear_1, &shear_2})
      if (bears) std::fill(all->begin(), all->end(), 0.0);
    bears = false;
  }
  [[nodiscard]] PointStress of(std::size_t p) const {
    return {normal[p], shear_1[p], shear_2.empty() ? 0.0 : shear_2[p]};
  }
  void store(std::size_t p, const PointStress& q) {
    normal[p] = q.normal, shear_1[p] = q.shear_1;
    if (!shear_2.empty()) shear_2[p] = q.shear_2;
  }
};

// Data for a wall's dashpots beside its tables: velocities before the step, forces on the blocks.
struct DashpotState {
  std::vector<double> friction;               // of each joint's law
  std::vector<std::array<double, 3>> before;  // velocities of blocks
  std::vector<std::array<double, 4>> force;   // of joints: fx, fy on a, moments on a and b
  MaxwellStresses maxwell;                    // kept from step to step
};

inline void prepare_dashpots(const Model& m, DashpotState& dashpot_state) {
  if (!dashpot_state.friction.empty()) return;
  for (const std::int32_t material : m.joint_material)
    dashpot_state.friction.push_back(contact::constants_of(m.materials[material]).tan_res);
  dashpot_state.before.resize(m.n_block);
  dashpot_state.force.resize(m.n_joint);
}

// One joint with the motion of its two blocks.
struct DampedJoint {
  double tx, ty, reach;                     // tangent now, half length along it
  double jn, jt, dn, dt;                    // jump (joints.h)
  double rate_n, rate_t, grows_n, grows_t;  // and their rates
  double arm_ax, arm_ay, arm_bx, arm_by;    // levers of the force
  double couple_n, couple_t;                // moment of the sums of xi f
};

inline DampedJoint damped_joint(const WallView& wall, const Model& m, std::size_t j,
                                const DashpotState& dashpot_state) {
  struct Side {
    Rows<double> pose;
    std::array<double, 3> v;
  };
  const auto side = [&](BlockId block) -> Side {
    if (block == kGroundBlock) return {{0, 0, 1, 0}, {0, 0, 0}};
    const auto of = [&](int c) { return wall.column_of(wall.t.pose, block, c); };
    return {{of(0), of(1), of(2), of(3)}, dashpot_state.before[block]};
  };
  const bool on_ground = m.joint_a[j] == kGroundBlock;
  const Side a = side(m.joint_a[j]), b = side(m.joint_b[j]);
  const auto fa = face_motion(a.pose, turn_of(a.pose), m.arm_a_x[j], m.arm_a_y[j]);
  const auto fb = face_motion(b.pose, turn_of(b.pose), m.arm_b_x[j], m.arm_b_y[j]);
  const double reach = m.half_x[j] * m.tangent_x[j] + m.half_y[j] * m.tangent_y[j];
  const double tx0 = m.tangent_x[j], ty0 = m.tangent_y[j];
  const double rx = b.v[0] - b.v[2] * fb.arm_y - (on_ground ? 0 : a.v[0] - a.v[2] * fa.arm_y);
  const double ry = b.v[1] + b.v[2] * fb.arm_x - (on_ground ? 0 : a.v[1] + a.v[2] * fa.arm_x);
  if (on_ground) {
    const Turn<double> turn = turn_of(b.pose);
    const double cosine = 1 + turn.drop;
    return {tx0,
            ty0,
            reach,
            fb.move_y * tx0 - fb.move_x * ty0,
            fb.move_x * tx0 + fb.move_y * ty0,
            reach * turn.sine,
            reach * turn.drop,
            ry * tx0 - rx * ty0,
            rx * tx0 + ry * ty0,
            reach * cosine * b.v[2],
            -reach * turn.sine * b.v[2],
            0,
            0,
            fb.arm_x,
            fb.arm_y,
            reach * cosine,
            -reach * turn.sine};
  }
  const double cc = a.pose.c2 * b.pose.c2, ss = a.pose.c3 * b.pose.c3;
  const double sc = a.pose.c3 * b.pose.c2, cs = a.pose.c2 * b.pose.c3;
  const double cosine = cc - ss, sine = sc + cs;
  const double tx = cosine * tx0 - sine * ty0, ty = sine * tx0 + cosine * ty0;
  const double jx = fb.move_x - fa.move_x, jy = fb.move_y - fa.move_y;
  const double jn = jy * tx - jx * ty, jt = jx * tx + jy * ty;
  const double spin = 0.5 * (a.v[2] + b.v[2]);
  return {tx,
          ty,
          reach,
          jn,
          jt,
          2 * reach * (cs - sc),
          0,
          (ry * tx - rx * ty) - spin * jt,
          (rx * tx + ry * ty) + spin * jn,
          reach * (cc + ss) * (b.v[2] - a.v[2]),
          0,
          fa.arm_x + 0.5 * jx,
          fa.arm_y + 0.5 * jy,
          fb.arm_x - 0.5 * jx,
          fb.arm_y - 0.5 * jy,
          reach * (cc + ss),
          0};
}

// Viscous forces of all joints, added to those of the law.
inline void damp_joints(const Layout& l, const WallView& wall, const Model& m,
                        const Dashpots& dashpots, double dt, DashpotState& dashpot_state) {
  const MaxwellStep maxwell = maxwell_step(dashpots, dt);
  const bool springs = maxwell.gain > 0, rebound = rebounds(dashpots);
  if (!springs) dashpot_state.maxwell.set_zero();
  dashpot_state.maxwell.bears = springs;
  for (int i = 0; i < m.n_block; ++i)
    dashpot_state.before[i] = {wall.block(i, kVx), wall.block(i, kVy), wall.block(i, kOmega)};
  for (const Chunk& chunk : l.chunks[kJoints]) {
    for (int n = 0; n < chunk.n; ++n) {
      const std::size_t j = chunk.first + n;
      dashpot_state.force[j] = {0, 0, 0, 0};
      const std::size_t first = j * static_cast<std::size_t>(chunk.points);
      if (wall.t.joint[l.number(l.joint_place[j], kJointRows, kArea, 1)] == 0) {
        for (int k = 0; springs && k < chunk.points; ++k)
          dashpot_state.maxwell.store(first + static_cast<std::size_t>(k), {0, 0, 0});
        continue;  // free contacts have their own dashpots
      }
      const JointMaterial& law = m.materials[m.joint_material[j]];
      const DampedJoint joint = damped_joint(wall, m, j, dashpot_state);
      double fn = 0, ft = 0, gn = 0, gt = 0;
      for (int k = 0; k < chunk.points; ++k) {
        const double xi = m.point_xi[k], share = m.area[j] * m.point_weight[k];
        const auto history = [&](int row) {
          return wall.t.history[l.point_number(chunk, n, k, row, static_cast<int>(wall.t.lanes)) +
                                wall.lane];
        };
        const double w = joint.jn + xi * joint.dn + history(1);
        const double s = joint.jt + xi * joint.dt - history(2);
        const double rate_n = joint.rate_n + xi * joint.grows_n;
        const double rate_t = joint.rate_t + xi * joint.grows_t;
        PointStress spring{0, 0, 0};
        if (springs) {
          const PointStress q = dashpot_state.maxwell.of(first + static_cast<std::size_t>(k));
          spring = {maxwell.of(q.normal, law.normal_stiffness, dt * rate_n),
                    maxwell.of(q.shear_1, law.shear_stiffness, dt * rate_t), 0};
        }
        const double closed = rebound ? share_of_first_step(w, dt * rate_n) : 1.0;
        const ViscousStress both = damp_point(
            {law.normal_stiffness * w, law.shear_stiffness * s, 0},
            {closed * dashpots.normal[j] * rate_n, closed * dashpots.shear[j] * rate_t, 0}, spring,
            dashpot_state.friction[j]);
        if (springs) dashpot_state.maxwell.store(first + static_cast<std::size_t>(k), both.spring);
        const PointStress& viscous = both.all;
        fn += share * viscous.normal, gn += share * viscous.normal * xi;
        ft += share * viscous.shear_1, gt += share * viscous.shear_1 * xi;
      }
      const double fx = ft * joint.tx - fn * joint.ty, fy = ft * joint.ty + fn * joint.tx;
      const double couple = joint.couple_n * gn + joint.couple_t * gt;
      const bool on_ground = m.joint_a[j] == kGroundBlock;
      dashpot_state.force[j] = {fx, fy,
                                on_ground ? 0 : (joint.arm_ax * fy - joint.arm_ay * fx) + couple,
                                (joint.arm_by * fx - joint.arm_bx * fy) - couple};
      for (int c = 0; c < 4; ++c)
        wall.column_of(wall.t.force, l.joint_place[j], c) += dashpot_state.force[j][c];
    }
  }
}

// Energy that the dashpots dissipated in the last step [J].
inline double dashpot_work(const WallView& wall, const Model& m, const DashpotState& dashpot_state,
                           double dt) {
  double power = 0;
  const auto add = [&](BlockId block, double sense, double fx, double fy, double moment) {
    const std::array<double, 3>& v = dashpot_state.before[block];
    power += 0.5 * (sense * fx * (v[0] + wall.block(block, kVx)) +
                    sense * fy * (v[1] + wall.block(block, kVy)) +
                    moment * (v[2] + wall.block(block, kOmega)));
  };
  for (std::size_t j = 0; j < dashpot_state.force.size(); ++j) {
    const auto& [fx, fy, on_a, on_b] = dashpot_state.force[j];
    if (m.joint_a[j] != kGroundBlock) add(m.joint_a[j], 1, fx, fy, on_a);
    add(m.joint_b[j], -1, fx, fy, on_b);
  }
  return dt * power;
}

// Reduces velocities as exp(-alpha t); returns the work of that in a step [J].
inline double damp_by_mass(const WallView& wall, double alpha, double dt) {
  const double kept = kept_by_mass(alpha, dt);
  double energy = 0;
  for (int i = 0; i < wall.blocks; ++i) {
    if (!(wall.block(i, kIsFree) > 0)) continue;
    double& vx = wall.block(i, kVx);
    double& vy = wall.block(i, kVy);
    double& omega = wall.block(i, kOmega);
    energy += wall.cold(i, kMass) * (vx * vx + vy * vy) + wall.cold(i, kInertia) * omega * omega;
    vx *= kept, vy *= kept, omega *= kept;
  }
  for (int i = 0; i < wall.nodes; ++i) {
    double& vx = wall.node(i, kNodeVx);
    double& vy = wall.node(i, kNodeVy);
    energy += wall.node(i, kNodeMass) * (vx * vx + vy * vy);
    vx *= kept, vy *= kept;
  }
  return 0.5 * energy * (kept * kept - 1);
}

}  // namespace wythe::dynamics
