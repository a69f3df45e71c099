// Dashpots and Maxwell elements at the closed points of joints (docs/theory/dynamics.md, 14). Only some shakes have
// them, so they have a pass of their own behind that over joints. Its forces are added to the rows of joint forces.
//
//   at a point with  w_e < 0:   sigma += c_n dw/dt + q_n, so that it only presses;  tau += c_s ds/dt + q_s within friction
//                               q <- exp(-dt / T) q + share k (1 - exp(-dt / T)) T / dt  Delta w      (Maxwell elements)
//
// Rates are those of the half step before; the step is limited for this reason (stage_time_step).
#pragma once

#include "dynamics/passes/joints.h"

namespace wythe::dynamics {

// Viscous stresses of a point with known elastic stresses. Both are limited to what a closed joint can bear.
template <class Real>
struct PointStress {
  Real normal, shear_1, shear_2;  // [Pa]
};
template <class Real>
struct ViscousStress {
  PointStress<Real> all, spring;  // spring: the share of the Maxwell element
};
// The size of a shear with one direction (in the plane) or two.
template <int directions, class Real>
[[nodiscard]] WYTHE_INLINE Real size_of(Real shear_1, Real shear_2) {
  if constexpr (directions == 1)
    return magnitude(shear_1);
  else
    return square_root(shear_1 * shear_1 + shear_2 * shear_2);
}
// `dashpot` and `spring`: stresses without that limit. Few points slide in a step, so the division is made only where a closed one does.
template <int directions, class Real>
[[nodiscard]] WYTHE_INLINE ViscousStress<Real> damp_point(const PointStress<Real>& elastic,
                                                          const PointStress<Real>& dashpot,
                                                          const PointStress<Real>& spring,
                                                          Real friction) {
  const Real zero(0.0), one(1.0);
  const bool_of_t<Real> closed = elastic.normal < zero;
  const Real pressed = zero - elastic.normal;
  const Real normal = minimum(dashpot.normal + spring.normal, pressed);
  const Real u = dashpot.shear_1 + spring.shear_1, v = dashpot.shear_2 + spring.shear_2;
  const Real wanted = size_of<directions>(u, v);
  const Real left =
      friction * (pressed - normal) - size_of<directions>(elastic.shear_1, elastic.shear_2);
  const bool_of_t<Real> acts = wanted > zero;
  Real share = select(acts, one, zero);
  const bool_of_t<Real> beyond = left < wanted;
  const bool_of_t<Real> slides = closed & beyond;
  if (any(slides)) share = select(acts, clip(left / select(acts, wanted, one), zero, one), zero);
  const auto where_closed = [&](Real stress) __attribute__((always_inline)) {
    return select(closed, stress, zero);
  };
  return {{where_closed(normal), where_closed(share * u), where_closed(share * v)},
          {where_closed(minimum(spring.normal, pressed)), where_closed(share * spring.shear_1),
           where_closed(share * spring.shear_2)}};
}

// A point that closes within a step was closed for a part of it only. A force acts for one step, half of it before and half
// after. So the dashpot of a newly closed point acts for the half to come and for its share of the half before
// (docs/theory/dynamics.md, 14.6a). `motion`: motion of the point in the step, negative where it closes. `open`: present opening.
// `rebound`: whether impacts of the wall rebound; without, a point sticks anyway, and the share is 1.
template <class Real>
[[nodiscard]] WYTHE_INLINE Real share_of_first_step(bool_of_t<Real> rebound, Real open,
                                                    Real motion) {
  const Real zero(0.0), one(1.0);
  const bool_of_t<Real> closed = open < zero;
  const bool_of_t<Real> was_open = open > motion;
  const bool_of_t<Real> just_closed = closed & was_open;
  const bool_of_t<Real> closes = just_closed & rebound;
  if (!any(closes)) return one;
  return select(closes, Real(0.5) + open / select(closes, motion, one), one);
}

// The change of stress q of a Maxwell element in a step, when its contact has stiffness
// k and moves by s at a constant rate. Exact solution: q <- kept q + gain k s.
template <class Real>
struct MaxwellStep {
  Real kept, gain;
  [[nodiscard]] WYTHE_INLINE Real of(Real q, Real stiffness, Real moved) const {
    return kept * q + gain * stiffness * moved;
  }
};

// Dashpots and elements of joints of one law and one support. A joint without an area has none: one that was released, whose free
// contacts have their own (contact_dashpots.h), of masonry that does not stand, or that fills up a group.
template <class A>
struct JointDashpots {
  using Access = A;
  using Real = typename Access::Real;
  using Work = NoWork;

  const Tables& t;
  FaceRun<Access> run;
  std::ptrdiff_t rows;  // of history of a point
  double* element;      // from the run's first item on; null: none
  bool on_ground;

  WYTHE_INLINE JointDashpots(const Tables& tables, Access access, const Chunk& chunk)
      : t(tables),
        run(face_run(tables, access, chunk, nullptr)),
        rows(chunk.rows),
        element(chunk.elements < 0 ? nullptr
                                   : tables.element + chunk.elements * access.history_lanes()),
        on_ground(chunk.on_ground) {}

  WYTHE_INLINE void select_part(int part) { run.access.select_part(part); }
  WYTHE_INLINE void at(std::ptrdiff_t j, NoWork&) const {
    if (on_ground)
      ground(j);
    else
      pair(j);
  }

 private:
  [[nodiscard]] WYTHE_INLINE Real of_wall(WallRow row) const {
    return run.access.wall_value(t.wall, row);
  }
  WYTHE_INLINE void pair(std::ptrdiff_t j) const {
    const Real half(0.5);
    const PairPlace<Real> p = pair_in(t, run.access, j, run.access.rows(t.pose, t.joint_a, j),
                                      run.access.rows(t.pose, t.joint_b, j));
    const Rows<Real> a = run.access.rows(t.velocity, t.joint_a, j);  // vx, vy, omega
    const Rows<Real> b = run.access.rows(t.velocity, t.joint_b, j);
    const Real x = b.c0 - b.c2 * p.b.arm_y - (a.c0 - a.c2 * p.a.arm_y);
    const Real y = b.c1 + b.c2 * p.b.arm_x - (a.c1 + a.c2 * p.a.arm_x);
    const Real spin = half * (a.c2 + b.c2);  // of the joint's axes
    const FaceJump<Real> rate{(y * p.tx - x * p.ty) - spin * p.jump.jt,
                              (x * p.tx + y * p.ty) + spin * p.jump.jn, p.lever * (b.c2 - a.c2),
                              Real(0.0)};
    const FaceForce<Real> f = viscous(j, p.jump, rate);
    const Real fx = f.ft * p.tx - f.fn * p.ty, fy = f.ft * p.ty + f.fn * p.tx;
    const Real couple = p.lever * f.gn;
    const Real cx = half * p.jx, cy = half * p.jy;
    add(j, {fx, fy, ((p.a.arm_x + cx) * fy - (p.a.arm_y + cy) * fx) + couple,
            ((p.b.arm_y - cy) * fx - (p.b.arm_x - cx) * fy) - couple});
  }

  WYTHE_INLINE void ground(std::ptrdiff_t j) const {
    const GroundPlace<Real> g = ground_in(t, run.access, j, run.access.rows(t.pose, t.joint_b, j));
    const Rows<Real> b = run.access.rows(t.velocity, t.joint_b, j);
    const Real tx = joint_row(t, run.access, j, kTangentX);
    const Real ty = joint_row(t, run.access, j, kTangentY);
    const Real reach = joint_row(t, run.access, j, kHalfLength);
    const Real along = reach * (Real(1.0) + g.turn.drop), across = reach * g.turn.sine;
    const Real x = b.c0 - b.c2 * g.b.arm_y, y = b.c1 + b.c2 * g.b.arm_x;
    const FaceJump<Real> rate{y * tx - x * ty, x * tx + y * ty, along * b.c2,
                              Real(0.0) - across * b.c2};
    const FaceForce<Real> f = viscous(j, g.jump, rate);
    const Real fx = f.ft * tx - f.fn * ty, fy = f.ft * ty + f.fn * tx;
    const Real couple = along * f.gn - across * f.gt;
    add(j, {fx, fy, Real(0.0), (g.b.arm_y * fx - g.b.arm_x * fy) - couple});
  }

  // Sums over the points of a joint with known opening and slip, and their rates. The elements advance by a step.
  [[nodiscard]] WYTHE_INLINE FaceForce<Real> viscous(std::ptrdiff_t j, const FaceJump<Real>& jump,
                                                     const FaceJump<Real>& rate) const {
    const Real zero(0.0), dt = of_wall(kDt), area = joint_row(t, run.access, j, kArea);
    const bool_of_t<Real> rebound = of_wall(kRebounds) > zero, acts = is_damped(j);
    const bool_of_t<Real> has_elements = of_wall(kElementGain) > zero;
    const contact::LawConstants<Real> law = run.law_at(j);
    const Real c_n = run.access.load(t.dashpot, j * kDashpotRows + kNormalDashpot);
    const Real c_s = run.access.load(t.dashpot, j * kDashpotRows + kShearDashpot);
    const MaxwellStep<Real> maxwell{of_wall(kElementKept), of_wall(kElementGain)};
    FaceForce<Real> sum{zero, zero, zero, zero};
    for (int k = 0; k < run.points; ++k) {
      const std::ptrdiff_t point = (j - run.begin) * run.points + k;
      const Real xi(run.xi[k]), share = area * Real(run.weight[k]);
      const Real w = jump.jn + xi * jump.dn + run.access.load(run.history, point * rows + 1);
      const Real s = jump.jt + xi * jump.dt - run.access.load(run.history, point * rows + 2);
      const Real rate_n = rate.jn + xi * rate.dn, rate_t = rate.jt + xi * rate.dt;
      PointStress<Real> q{zero, zero, zero}, spring = q;
      if (element != nullptr) {
        q.normal = run.access.load(element, point * kMaxwellRows + kNormalElement);
        q.shear_1 = run.access.load(element, point * kMaxwellRows + kShearElement);
        spring.normal = maxwell.of(q.normal, law.kn, dt * rate_n);
        spring.shear_1 = maxwell.of(q.shear_1, law.ks, dt * rate_t);
      }
      const Real closed = share_of_first_step(rebound, w, dt * rate_n);
      const ViscousStress<Real> now =
          damp_point<1>({law.kn * w, law.ks * s, zero},
                        {closed * c_n * rate_n, closed * c_s * rate_t, zero}, spring, law.tan_res);
      if (element != nullptr) {
        const auto store = [&](Real stress, Real before, MaxwellRow row)
            __attribute__((always_inline)) {
          run.access.store(select(has_elements, select(acts, stress, zero), before), element,
                           point * kMaxwellRows + row);
        };
        store(now.spring.normal, q.normal, kNormalElement);
        store(now.spring.shear_1, q.shear_1, kShearElement);
      }
      const Real fn = share * now.all.normal, ft = share * now.all.shear_1;
      sum = {sum.fn + fn, sum.ft + ft, sum.gn + fn * xi, sum.gt + ft * xi};
    }
    return sum;
  }

  [[nodiscard]] WYTHE_INLINE bool_of_t<Real> is_damped(std::ptrdiff_t j) const {
    const bool_of_t<Real> acts = of_wall(kHasDashpots) > Real(0.0);
    const bool_of_t<Real> joins = joint_row(t, run.access, j, kArea) > Real(0.0);
    return acts & joins;
  }
  WYTHE_INLINE void add(std::ptrdiff_t j, const Rows<Real>& viscous) const {
    const Real zero(0.0);
    const bool_of_t<Real> acts = is_damped(j);
    const Rows<Real> f = run.access.load_rows(t.force, j);
    run.access.store_rows({select(acts, viscous.c0, zero), select(acts, viscous.c1, zero),
                           select(acts, viscous.c2, zero), select(acts, viscous.c3, zero)},
                          t.viscous_force, j);
    run.access.store_rows(
        {select(acts, f.c0 + viscous.c0, f.c0), select(acts, f.c1 + viscous.c1, f.c1),
         select(acts, f.c2 + viscous.c2, f.c2), select(acts, f.c3 + viscous.c3, f.c3)},
        t.force, j);
  }
};

}  // namespace wythe::dynamics
