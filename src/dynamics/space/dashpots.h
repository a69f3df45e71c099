// Dashpots at the closed points of faces in space, and damping in proportion to mass: as passes/dashpots.h.
#pragma once

#include <vector>

#include "contact/parameters.h"
#include "dynamics/passes/dashpots.h"
#include "dynamics/space/wall.h"

namespace wythe::dynamics::space {

struct DashpotState {
  struct Twist {
    Vec v, rate;
  };
  std::vector<double> friction;                   // of each joint's law
  std::vector<Twist> before;                      // of blocks
  std::vector<contact::BlockLoads<double>> load;  // of joints
  std::vector<Vec> support;                       // velocity of each support before the step
  MaxwellStresses maxwell;                        // kept from step to step
};

inline DashpotState::Twist twist_of(std::ptrdiff_t i, const WallView& w) {
  const Quaternion<double> q = w.turn(i);
  return {w.body_vector(i, kV),
          turned(q, inertia_of(i, w).rate(turned_back(q, w.body_vector(i, kL))))};
}

// Velocity of a support in the last step.
inline Vec velocity_of(std::int32_t support, const WallView& w) {
  if (!w.is_driven_support(support)) return {0, 0, 0};
  const Vec step{w.wall_value(kSupportStep), w.wall_value(kSupportStep + 1),
                 w.wall_value(kSupportStep + 2)};
  return (1 / w.wall_value(kStep)) * step;
}

inline void prepare_dashpots(const WallView& w, const Model& m, DashpotState& dashpot_state) {
  if (dashpot_state.friction.empty())
    for (const std::int32_t material : m.joint_material)
      dashpot_state.friction.push_back(contact::constants_of(m.materials[material]).tan_res);
  dashpot_state.load.resize(m.n_joint);
  dashpot_state.before.resize(m.n_block);
  for (int i = 0; i < m.n_block; ++i) dashpot_state.before[i] = twist_of(i, w);
  dashpot_state.support.resize(m.space.n_support);
  for (int i = 0; i < m.space.n_support; ++i) dashpot_state.support[i] = velocity_of(i, w);
}

// Viscous forces of a face with known gap and rate of the gap.
template <class Face>
contact::BlockLoads<double> damp_face(const Face& face, const contact::FaceGap<double>& rate,
                                      const Chunk& chunk, int n, const WallView& w, const Model& m,
                                      const Controls& controls, DashpotState& dashpot_state) {
  const std::size_t j = chunk.first + n;
  const Dashpots& dashpots = *controls.dashpots;
  const double dt = controls.dt, c_n = dashpots.normal[j], c_s = dashpots.shear[j];
  const MaxwellStep maxwell = maxwell_step(dashpots, dt);
  const bool rebound = rebounds(dashpots);
  const JointMaterial& law = m.materials[m.joint_material[j]];
  const contact::FaceGap<double> gap = face.gap();
  contact::FaceLoad<double> sum{{0, 0, 0}, {0, 0, 0}, {0, 0, 0}};
  for (int k = 0; k < chunk.points; ++k) {
    const std::size_t p = m.space.point_begin[j] + k;
    const auto history = [&](int row) {
      return w.t
          .history[w.layout->point_number(chunk, chunk.history, n, k, chunk.rows, row, w.t.lanes) +
                   w.lane];
    };
    const double r1 = m.space.point_r1[p], r2 = m.space.point_r2[p];
    const double share = m.area[j] * m.space.point_share[p];
    const Vec g = gap.j + r1 * gap.a + r2 * gap.b, v = rate.j + r1 * rate.a + r2 * rate.b;
    PointStress spring{0, 0, 0};
    if (maxwell.gain > 0) {
      const PointStress q = dashpot_state.maxwell.of(p);
      spring = {maxwell.of(q.normal, law.normal_stiffness, dt * v.z),
                maxwell.of(q.shear_1, law.shear_stiffness, dt * v.x),
                maxwell.of(q.shear_2, law.shear_stiffness, dt * v.y)};
    }
    const double open = g.z + history(1);
    const double closed = rebound ? share_of_first_step(open, dt * v.z) : 1.0;
    const ViscousStress both =
        damp_point({law.normal_stiffness * open, law.shear_stiffness * (g.x - history(2)),
                    law.shear_stiffness * (g.y - history(chunk.rows - 1))},
                   {closed * c_n * v.z, closed * c_s * v.x, closed * c_s * v.y}, spring,
                   dashpot_state.friction[j]);
    if (maxwell.gain > 0) dashpot_state.maxwell.store(p, both.spring);
    const PointStress& viscous = both.all;
    const Vec f = share * Vec{viscous.shear_1, viscous.shear_2, viscous.normal};
    sum.f = sum.f + f;
    sum.r1 = sum.r1 + r1 * f;
    sum.r2 = sum.r2 + r2 * f;
  }
  return face.loads(sum);
}

inline contact::BlockLoads<double> damp_joint(const Chunk& chunk, int n, const WallView& w,
                                              const Model& m, const Controls& controls,
                                              DashpotState& dashpot_state) {
  const std::size_t j = chunk.first + n;
  const Space& s = m.space;
  const auto pose = [&](BlockId i) { return contact::Pose<double>{w.shift(i), w.turn(i)}; };
  const BlockId a = m.joint_a[j], b = m.joint_b[j];
  const DashpotState::Twist& tb = dashpot_state.before[b];
  if (static_cast<int>(j) >= m.n_pair) {
    const auto support = [&](int c) { return w.column_of(w.t.support, a - m.n_block, c); };
    const contact::SupportFace<double> face({support(0), support(1), support(2)}, pose(b),
                                            vec(s.arm_b[j]), vec(s.tangent[j]), vec(s.normal[j]));
    // t1 and t2 of the block turn with it
    const auto turns = [&](const Vec& grown, const Vec& unit) {
      return face.frame.in(cross(tb.rate, face.frame.out(grown) + unit));
    };
    const Vec jump = tb.v + cross(tb.rate, face.arm_b) - dashpot_state.support[a - m.n_block];
    return damp_face(face,
                     {face.frame.in(jump), turns(face.grown_1, face.frame.t1),
                      turns(face.grown_2, face.frame.t2)},
                     chunk, n, w, m, controls, dashpot_state);
  }
  const DashpotState::Twist& ta = dashpot_state.before[a];
  const contact::PairFace<double> face(pose(a), pose(b), vec(s.arm_a[j]), vec(s.arm_b[j]),
                                       vec(s.tangent[j]), vec(s.normal[j]));
  const Vec mean = 0.5 * (ta.rate + tb.rate);
  const Vec jump = (tb.v + cross(tb.rate, face.arm_b)) - (ta.v + cross(ta.rate, face.arm_a)) -
                   cross(mean, face.jump);
  const Vec d = face.frame.in(tb.rate - ta.rate);
  return damp_face(face, {face.frame.in(jump), {0, d.z, -d.y}, {-d.z, 0, d.x}}, chunk, n, w, m,
                   controls, dashpot_state);
}

// Viscous forces of all joints, added to those of the law.
inline void damp_joints(const WallView& w, const Model& m, const Controls& controls,
                        DashpotState& dashpot_state) {
  prepare_dashpots(w, m, dashpot_state);
  if (!(controls.dashpots->spring_share > 0)) dashpot_state.maxwell.set_zero();
  dashpot_state.maxwell.bears = controls.dashpots->spring_share > 0;
  for (const Chunk& chunk : w.layout->joints)
    for (int n = 0; n < chunk.n; ++n) {
      const std::size_t j = chunk.first + n;
      dashpot_state.load[j] = {{0, 0, 0}, {0, 0, 0}, {0, 0, 0}};
      if (w.t.face[w.layout->number(w.layout->joint_place[j], kFaceRows, kFaceArea, 1)] == 0) {
        for (int p = m.space.point_begin[j];
             dashpot_state.maxwell.bears && p < m.space.point_begin[j + 1]; ++p)
          dashpot_state.maxwell.store(static_cast<std::size_t>(p), {0, 0, 0});
        continue;  // free contacts have their own dashpots
      }
      const contact::BlockLoads<double> l = damp_joint(chunk, n, w, m, controls, dashpot_state);
      dashpot_state.load[j] = l;
      const std::int32_t e = w.layout->joint_place[j];
      const auto add = [&](double* rows, const Vec& v) {
        w.column_of(rows, e, 0) += v.x, w.column_of(rows, e, 1) += v.y,
            w.column_of(rows, e, 2) += v.z;
      };
      add(w.t.force, l.f);
      if (static_cast<int>(j) < m.n_pair) add(w.t.moment_a, l.on_a);
      add(w.t.moment_b, l.on_b);
    }
}

// Energy that the dashpots dissipated in the last step [J].
inline double dashpot_work(const WallView& w, const Model& m, const DashpotState& dashpot_state,
                           double dt) {
  std::vector<Load<double>> on(m.n_block, Load<double>{{0, 0, 0}, {0, 0, 0}});
  double power = 0;
  for (std::size_t j = 0; j < dashpot_state.load.size(); ++j) {
    const contact::BlockLoads<double>& l = dashpot_state.load[j];
    Load<double>& b = on[m.joint_b[j]];
    b = {b.f - l.f, b.m + l.on_b};
    if (static_cast<int>(j) >= m.n_pair) {
      const std::int32_t support = m.joint_a[j] - m.n_block;
      power += 0.5 * dot(l.f, dashpot_state.support[support] + velocity_of(support, w));
      continue;
    }
    Load<double>& a = on[m.joint_a[j]];
    a = {a.f + l.f, a.m + l.on_a};
  }
  for (int i = 0; i < m.n_block; ++i) {
    const DashpotState::Twist now = twist_of(i, w), &before = dashpot_state.before[i];
    power += 0.5 * (dot(on[i].f, before.v + now.v) + dot(on[i].m, before.rate + now.rate));
  }
  return dt * power;
}

// Inertia force of mass that does not count as weight of its block. Gravity already contains the base acceleration.
inline void add_carried(const WallView& w, const Model& m, const State& s) {
  const std::size_t now = s.stage;
  if (now >= m.stages.size()) return;
  const Vec base{s.gravity_x, s.gravity_y + m.solve.gravity, s.gravity_z};
  for (const PointLoad& mass : m.stages[now].carried)
    w.store_body_vector(w.body_vector(mass.block, kLoad) + mass.fx * base, mass.block, kLoad);
}

// Reduces velocities as exp(-alpha t); returns the work of that in a step [J].
inline double damp_by_mass(const WallView& w, double alpha, double dt) {
  const double kept = kept_by_mass(alpha, dt);
  double energy = 0;
  for (int i = 0; i < w.blocks; ++i) {
    if (!(w.body(i, kFree) > 0)) continue;
    const DashpotState::Twist twist = twist_of(i, w);
    const Vec l = w.body_vector(i, kL);
    energy += w.still(i, kBodyMass) * dot(twist.v, twist.v) + dot(l, twist.rate);
    w.store_body_vector(kept * twist.v, i, kV);
    w.store_body_vector(kept * l, i, kL);
  }
  return 0.5 * energy * (kept * kept - 1);
}

}  // namespace wythe::dynamics::space
