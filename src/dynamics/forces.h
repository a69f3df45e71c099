// First pass of the step: each joint finds its stresses and writes its own force.
//
// A joint's points lie on the line between the two faces; both faces follow their blocks. With
// j the jump of the face centre, d = (Rb - Ra) e its growth along the face and phi = (ta + tb)/2:
//
//   w(xi) = (j + xi d) . n(phi)      s(xi) = (j + xi d) . t(phi)
//   f = area weight (sigma n + tau t) on a, -f on b, both acting at the midpoint of the pair
//
// The midpoint with the mean rotation is exactly work-conjugate to w and s and gives equal and
// opposite forces on one line of action: linear and angular momentum are kept and no energy is made
// by large rotation (docs/theory/kinematics.md). On the ground the normal stands still and the force
// acts at the block's own point, so that a block may slide any distance.
//
// The half-angle cosines of two blocks multiply to those of the mean angle: no root, no division.
// Access says what the lanes of a Real are: neighbours in one wall, or walls side by side (lanes.h).
#pragma once

#include "dynamics/kernels.h"
#include "dynamics/lanes.h"

namespace wythe::dynamics {

template <class Real>
struct JointWork {
  Real friction, fracture, crushing;  // [J]
};

// Motion of one side: displacement of the face centre, turned arm, and R - I applied to e.
template <class Real>
struct FaceMotion {
  Real move_x, move_y;  // displacement of the face centre
  Real arm_x, arm_y;    // R arm
  Real turn_x, turn_y;  // (R - I) e
};

template <class Real>
[[nodiscard]] WYTHE_INLINE FaceMotion<Real> face_motion(const Rows<Real>& pose, Real arm_x,
                                                        Real arm_y, Real ex, Real ey) {
  const Real c = pose.c2, s = pose.c3;
  const Real drop = Real(-2.0) * s * s;  // cos theta - 1, free of cancellation
  const Real sine = Real(2.0) * s * c;
  const Real dx = drop * arm_x - sine * arm_y, dy = sine * arm_x + drop * arm_y;
  return {pose.c0 + dx, pose.c1 + dy,          arm_x + dx,
          arm_y + dy,   drop * ex - sine * ey, sine * ex + drop * ey};
}

// Sums over the points of a joint, in its (n, t) axes: F = sum f, G = sum xi f.
template <class Real>
struct FaceForce {
  Real fn, ft, gn, gt;
};

// Jump of the face centre and its growth along the face, in the joint's (n, t) axes.
template <class Real>
struct FaceJump {
  Real jn, jt, dn, dt;
};

inline constexpr int kMaxFacePoints = 16;

// The history of a joint's points; n_point = 0 stands for any number.
template <int n_point, class V, class Access>
struct FaceHistory {
  using Real = typename Access::Real;
  using H = contact::History<Real>;
  H at[n_point > 0 ? n_point : kMaxFacePoints];

  WYTHE_INLINE void load(const JointArrays& v, Access access, std::size_t j) {
    each(
        v, [&](const double* array, Real H::*member) __attribute__((always_inline)) {
          access.template points<n_point>(
              array, j, v.n_face_point, [&](int k) __attribute__((always_inline))->Real & {
                return at[k].*member;
              });
        });
  }
  WYTHE_INLINE void store(const JointArrays& v, Access access, std::size_t j) const {
    each(
        v, [&](double* array, Real H::*member) __attribute__((always_inline)) {
          access.template keep_points<n_point>(
              [&](int k) __attribute__((always_inline)) { return at[k].*member; }, array, j,
              v.n_face_point);
        });
  }

 private:
  template <class Do>
  WYTHE_INLINE static void each(const JointArrays& v, const Do& act) {
    act(v.kappa, &H::kappa);
    act(v.crush, &H::crush);
    act(v.plastic_slip, &H::plastic_slip);
    act(v.slip, &H::slip);
    act(v.shear_damage, &H::shear_damage);
    if constexpr (V::unloading == Unloading::kElastic) act(v.tension_set, &H::tension_set);
  }
};

template <class V, int n_point, class Access, class Real>
[[nodiscard]] WYTHE_INLINE FaceForce<Real> face_force(const JointArrays& v, Access access,
                                                      const contact::LawConstants<Real>& law,
                                                      std::size_t j, const FaceJump<Real>& jump,
                                                      JointWork<Real>& work) {
  const int n = n_point > 0 ? n_point : v.n_face_point;
  const Real area = access.shared(v.area, j);
  FaceHistory<n_point, V, Access> history;
  history.load(v, access, j);
  FaceForce<Real> sum{Real(0.0), Real(0.0), Real(0.0), Real(0.0)};
#pragma GCC unroll 2
  for (int k = 0; k < n; ++k) {
    const Real xi(v.xi[k]);
    const contact::Answer<Real> now =
        contact::update<V>(law, jump.jn + xi * jump.dn, jump.jt + xi * jump.dt, history.at[k]);
    const Real share = area * Real(v.weight[k]);
    const Real fn = now.sigma * share, ft = now.tau * share;
    sum = {sum.fn + fn, sum.ft + ft, sum.gn + fn * xi, sum.gt + ft * xi};
    work = {work.friction + now.friction * share, work.fracture + now.fracture * share,
            work.crushing + now.crushing * share};
  }
  history.store(v, access, j);  // commit: the one place where history advances
  return sum;
}

// Forces of the joints a Real takes from j on. A kernel: the block-block and the ground case share
// all but the frame and the levers.
template <class V, bool on_ground, int n_point, class Access, class Real>
WYTHE_INLINE void joint_force(const JointArrays& v, Access access,
                              const contact::LawConstants<Real>& law, std::size_t j,
                              JointWork<Real>& work) {
  const Real half(0.5), ex = access.shared(v.half_x, j), ey = access.shared(v.half_y, j);
  const Rows<Real> pose_b = access.rows(v.pose, v.b, j);
  FaceMotion<Real> ma{Real(0.0), Real(0.0), Real(0.0), Real(0.0), Real(0.0), Real(0.0)};
  const FaceMotion<Real> mb =
      face_motion(pose_b, access.shared(v.arm_b_x, j), access.shared(v.arm_b_y, j), ex, ey);
  Real tx = access.shared(v.tangent_x, j), ty = access.shared(v.tangent_y, j);
  if constexpr (!on_ground) {
    const Rows<Real> pose_a = access.rows(v.pose, v.a, j);
    ma = face_motion(pose_a, access.shared(v.arm_a_x, j), access.shared(v.arm_a_y, j), ex, ey);
    const Real cos = pose_a.c2 * pose_b.c2 - pose_a.c3 * pose_b.c3;
    const Real sin = pose_a.c3 * pose_b.c2 + pose_a.c2 * pose_b.c3;
    const Real tx0 = tx;
    tx = cos * tx0 - sin * ty;
    ty = sin * tx0 + cos * ty;
  }
  const Real jx = mb.move_x - ma.move_x, jy = mb.move_y - ma.move_y;
  const Real dx = mb.turn_x - ma.turn_x, dy = mb.turn_y - ma.turn_y;
  const FaceForce<Real> f = face_force<V, n_point>(
      v, access, law, j,
      FaceJump<Real>{jy * tx - jx * ty, jx * tx + jy * ty, dy * tx - dx * ty, dx * tx + dy * ty},
      work);
  // back to the wall's axes: n = (-ty, tx)
  const Real fx = f.ft * tx - f.fn * ty, fy = f.ft * ty + f.fn * tx;
  const Real gx = f.gt * tx - f.gn * ty, gy = f.gt * ty + f.gn * tx;
  if constexpr (on_ground) {
    const Real hx = ex + mb.turn_x, hy = ey + mb.turn_y;
    const Real moment_b = (mb.arm_y * fx - mb.arm_x * fy) + (hy * gx - hx * gy);
    access.keep_rows({fx, fy, Real(0.0), moment_b}, v.force, j);
  } else {
    const Real hx = ex + half * (ma.turn_x + mb.turn_x), hy = ey + half * (ma.turn_y + mb.turn_y);
    const Real couple = hx * gy - hy * gx;
    const Real ax = ma.arm_x + half * jx, ay = ma.arm_y + half * jy;
    const Real bx = mb.arm_x - half * jx, by = mb.arm_y - half * jy;
    access.keep_rows({fx, fy, (ax * fy - ay * fx) + couple, (by * fx - bx * fy) - couple}, v.force,
                     j);
  }
}

// The constants of a law, each by take(member).
template <class Real, class Take>
[[nodiscard]] WYTHE_INLINE contact::LawConstants<Real> law_by(const Take& take) {
  using C = contact::LawConstants<double>;
  return {
      take(&C::kn),           take(&C::ks),           take(&C::inv_ks),     take(&C::inv_kn),
      take(&C::ft),           take(&C::w0),           take(&C::ft_over_GI), take(&C::tension_onset),
      take(&C::tension_rate), take(&C::c_res),        take(&C::c_drop),     take(&C::tan_res),
      take(&C::tan_drop),     take(&C::half_inv_GII), take(&C::fc),         take(&C::p_full),
      take(&C::inv_p_full),   take(&C::crush_gain)};
}
// The same law in every lane; the law of each wall.
template <class Real>
[[nodiscard]] WYTHE_INLINE contact::LawConstants<Real> law_of(
    const contact::LawConstants<double>* law, Neighbours<Real>) {
  return law_by<Real>([&](auto member) { return Real(law->*member); });
}
template <class Real>
[[nodiscard]] WYTHE_INLINE contact::LawConstants<Real> law_of(
    const contact::LawConstants<double>* law, Walls<Real>) {
  return law_by<Real>([&](auto member) {
    double lane[Lanes<Real>::width];
    for (int k = 0; k < Lanes<Real>::width; ++k) lane[k] = law[k].*member;
    return Lanes<Real>::load(lane);
  });
}

template <class Access, class Real, int packs>
WYTHE_INLINE void load_work(Access access, const JointEnergy& e, JointWork<Real> (&work)[packs]) {
  for (int k = 0; k < packs; ++k)
    work[k] = {access.energy(e.friction, k), access.energy(e.fracture, k),
               access.energy(e.crushing, k)};
}
template <class Access, class Real, int packs>
WYTHE_INLINE void store_work(Access access, const JointWork<Real> (&work)[packs],
                             const JointEnergy& e) {
  for (int k = 0; k < packs; ++k) {
    access.keep_energy(work[k].friction, e.friction, k);
    access.keep_energy(work[k].fracture, e.fracture, k);
    access.keep_energy(work[k].crushing, e.crushing, k);
  }
}

// Joints begin..end-1, all of one law; for packs of neighbours a whole number of groups.
template <class V, bool on_ground, int n_point, class Access>
void joint_run(const JointArrays& v, Access access, const contact::LawConstants<double>* constants,
               std::size_t begin, std::size_t end, const JointEnergy& energy) {
  using Real = typename Access::Real;
  const contact::LawConstants<Real> law = law_of<Real>(constants, access);
  JointWork<Real> work[Access::packs];
  load_work(access, energy, work);
  int k = 0;
  for (std::size_t j = begin; j < end; j += Access::advance) {
    joint_force<V, on_ground, n_point>(v, access, law, j, work[k]);
    k = (k + 1) % Access::packs;
  }
  store_work(access, work, energy);
}

}  // namespace wythe::dynamics
