// Dashpots and Maxwell elements at the closed points of faces in space, as in the plane (passes/joint_dashpots.h).
// Here shear has two directions, and friction limits both together.
#pragma once

#include "dynamics/passes/joint_dashpots.h"
#include "dynamics/space/joints.h"

namespace wythe::dynamics::space {

// Dashpots and elements of faces of one law, one kind of support and one number of points.
template <class A>
struct JointDashpots {
  using Access = A;
  using Real = typename Access::Real;
  using Work = NoWork;

  const Tables& t;
  Access access;
  const Chunk& chunk;
  const double* history;  // from the run's first item on
  const double* point;    // data of its points, from the run's first item on
  double* element;        // stresses of its elements, likewise; null: none

  WYTHE_INLINE JointDashpots(const Tables& tables, Access lanes, const Chunk& run)
      : t(tables),
        access(lanes),
        chunk(run),
        history(tables.history + static_cast<std::ptrdiff_t>(run.history) * lanes.history_lanes()),
        point(tables.point +
              static_cast<std::ptrdiff_t>(run.rule) * (Access::one_wall ? kGroup : 1)),
        element(run.elements < 0 ? nullptr
                                 : tables.element + run.elements * lanes.history_lanes()) {}

  WYTHE_INLINE void select_part(int part) { access.select_part(part); }
  WYTHE_INLINE void at(std::ptrdiff_t j, NoWork&) const {
    if (chunk.on_ground)
      ground(j);
    else
      pair(j);
  }

 private:
  [[nodiscard]] WYTHE_INLINE Vector<Real> vector(const double* rows, const std::int32_t* id,
                                                 std::ptrdiff_t j) const {
    const Rows<Real> row = access.rows(rows, id, j);
    return {row.c0, row.c1, row.c2};
  }

  WYTHE_INLINE void pair(std::ptrdiff_t j) const {
    const contact::PairFace<Real> face = pair_face(t, access, j);
    const Vector<Real> va = vector(t.velocity, t.joint_a, j), vb = vector(t.velocity, t.joint_b, j);
    const Vector<Real> ra = vector(t.spin_rate, t.joint_a, j);
    const Vector<Real> rb = vector(t.spin_rate, t.joint_b, j);
    const Vector<Real> mean = Real(0.5) * (ra + rb);  // the frame's
    const Vector<Real> jump =
        (vb + cross(rb, face.arm_b)) - (va + cross(ra, face.arm_a)) - cross(mean, face.jump);
    const Vector<Real> d = face.frame.in(rb - ra);
    const Real zero(0.0);
    const contact::FaceGap<Real> rate{
        face.frame.in(jump), {zero, d.z, zero - d.y}, {zero - d.z, zero, d.x}};
    const contact::BlockLoads<Real> l = face.loads(viscous(j, face.gap(), rate));
    add(j, l.f, t.force, t.viscous_force);
    add(j, l.on_a, t.moment_a, t.viscous_moment_a);
    add(j, l.on_b, t.moment_b, t.viscous_moment_b);
  }

  WYTHE_INLINE void ground(std::ptrdiff_t j) const {
    const contact::SupportFace<Real> face = support_face(t, access, j);
    const Vector<Real> v = vector(t.velocity, t.joint_b, j);
    const Vector<Real> r = vector(t.spin_rate, t.joint_b, j);
    // t1 and t2 of the block turn with it
    const auto turns = [&](const Vector<Real>& grown, const Vector<Real>& unit)
        __attribute__((always_inline)) {
      return face.frame.in(cross(r, face.frame.out(grown) + unit));
    };
    const Vector<Real> jump = v + cross(r, face.arm_b) - vector(t.support_velocity, t.joint_a, j);
    const contact::FaceGap<Real> rate{face.frame.in(jump), turns(face.grown_1, face.frame.t1),
                                      turns(face.grown_2, face.frame.t2)};
    const contact::BlockLoads<Real> l = face.loads(viscous(j, face.gap(), rate));
    add(j, l.f, t.force, t.viscous_force);
    add(j, l.on_b, t.moment_b, t.viscous_moment_b);
  }

  // Sums over the points of a face with known gap and its rate. The elements advance by a step.
  [[nodiscard]] WYTHE_INLINE contact::FaceLoad<Real> viscous(
      std::ptrdiff_t j, const contact::FaceGap<Real>& gap,
      const contact::FaceGap<Real>& rate) const {
    const Real zero(0.0), dt = access.wall_value(t.wall, kStep);
    const Vector<Real> none{zero, zero, zero};
    const std::ptrdiff_t step = chunk.graded ? (j - chunk.begin) * kLawRows : 0;
    const contact::LawConstants<Real> law =
        law_of(access, t.law, chunk.strengths + step, chunk.others + step, chunk.choice);
    const Real area = access.shared(t.face, j * kFaceRows + kFaceArea);
    const bool_of_t<Real> rebound = access.wall_value(t.wall, kRebounds) > zero;
    const Real c_n = access.load(t.dashpot, j * kDashpotRows + kNormalDashpot);
    const Real c_s = access.load(t.dashpot, j * kDashpotRows + kShearDashpot);
    contact::FaceLoad<Real> sum{none, none, none};
    for (int k = 0; k < chunk.points; ++k) {
      const std::ptrdiff_t number = (j - chunk.begin) * chunk.points + k;
      const auto history_at = [&](int row) __attribute__((always_inline)) {
        return access.load(history, number * chunk.rows + row);
      };
      const Real r1 = access.shared(point, number * kPointRows + kR1);
      const Real r2 = access.shared(point, number * kPointRows + kR2);
      const Real share = area * access.shared(point, number * kPointRows + kShare);
      const Vector<Real> g = gap.j + r1 * gap.a + r2 * gap.b;
      const Vector<Real> v = rate.j + r1 * rate.a + r2 * rate.b;
      const Real open = g.z + history_at(1);
      const Real closed = share_of_first_step(rebound, open, dt * v.z);
      const PointStress<Real> elastic{law.kn * open, law.ks * (g.x - history_at(2)),
                                      law.ks * (g.y - history_at(chunk.rows - 1))};
      const PointStress<Real> q = stress(number);
      const ViscousStress<Real> now =
          damp_point<2>(elastic, {closed * c_n * v.z, closed * c_s * v.x, closed * c_s * v.y},
                        advanced(q, law, dt * v), law.tan_res);
      store(j, number, q, now.spring);
      const Vector<Real> f = share * Vector<Real>{now.all.shear_1, now.all.shear_2, now.all.normal};
      sum.f = sum.f + f;
      sum.r1 = sum.r1 + r1 * f;
      sum.r2 = sum.r2 + r2 * f;
    }
    return sum;
  }

  // Stresses of the element at a point; of a motion in the step along t1, t2, n they become advanced().
  [[nodiscard]] WYTHE_INLINE PointStress<Real> stress(std::ptrdiff_t number) const {
    const Real zero(0.0);
    if (element == nullptr) return {zero, zero, zero};
    const auto of = [&](MaxwellRow row) __attribute__((always_inline)) {
      return access.load(element, number * kMaxwellRowsInSpace + row);
    };
    return {of(kNormalElement), of(kShearElement), of(kSecondShearElement)};
  }
  [[nodiscard]] WYTHE_INLINE PointStress<Real> advanced(const PointStress<Real>& q,
                                                        const contact::LawConstants<Real>& law,
                                                        const Vector<Real>& moved) const {
    if (element == nullptr) return q;
    const MaxwellStep<Real> maxwell{access.wall_value(t.wall, kElementKept),
                                    access.wall_value(t.wall, kElementGain)};
    return {maxwell.of(q.normal, law.kn, moved.z), maxwell.of(q.shear_1, law.ks, moved.x),
            maxwell.of(q.shear_2, law.ks, moved.y)};
  }
  WYTHE_INLINE void store(std::ptrdiff_t j, std::ptrdiff_t number, const PointStress<Real>& before,
                          const PointStress<Real>& now) const {
    if (element == nullptr) return;
    const Real zero(0.0);
    const bool_of_t<Real> acts = is_damped(j);
    const bool_of_t<Real> has_elements = access.wall_value(t.wall, kElementGain) > zero;
    const auto put = [&](MaxwellRow row, Real was, Real is) __attribute__((always_inline)) {
      access.store(select(has_elements, select(acts, is, zero), was), element,
                   number * kMaxwellRowsInSpace + row);
    };
    put(kNormalElement, before.normal, now.normal);
    put(kShearElement, before.shear_1, now.shear_1);
    put(kSecondShearElement, before.shear_2, now.shear_2);
  }

  [[nodiscard]] WYTHE_INLINE bool_of_t<Real> is_damped(std::ptrdiff_t j) const {
    const Real zero(0.0);
    const bool_of_t<Real> acts = access.wall_value(t.wall, kHasDashpots) > zero;
    const bool_of_t<Real> joins = access.shared(t.face, j * kFaceRows + kFaceArea) > zero;
    return acts & joins;
  }
  WYTHE_INLINE void add(std::ptrdiff_t j, const Vector<Real>& v, double* to, double* share) const {
    const Real zero(0.0);
    const bool_of_t<Real> acts = is_damped(j);
    const Rows<Real> f = access.load_rows(to, j);
    access.store_rows(
        {select(acts, v.x, zero), select(acts, v.y, zero), select(acts, v.z, zero), zero}, share,
        j);
    access.store_rows({select(acts, f.c0 + v.x, f.c0), select(acts, f.c1 + v.y, f.c1),
                       select(acts, f.c2 + v.z, f.c2), f.c3},
                      to, j);
  }
};

}  // namespace wythe::dynamics::space
