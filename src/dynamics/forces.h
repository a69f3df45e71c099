// First pass of the step: each joint finds its stresses and writes its own force.
//
// A joint's points lie on the line between the two faces; both faces follow their blocks. With
// j the jump of the face centre, h the half length of the face, delta = tb - ta, phi = (ta + tb)/2
// and the face along the tangent, its growth (Rb - Ra) e is normal to the mean face and its mean
// (Ra + Rb) e / 2 along it:
//
//   w(xi) = j . n(phi) + xi 2 h sin(delta/2)      s(xi) = j . t(phi)      the same at all points
//   f = area weight (sigma n + tau t) on a, -f on b, both acting at the midpoint of the pair
//   lever of the points about the midpoint of the centres: xi h cos(delta/2) t(phi)
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

// Motion of one side: displacement of the face centre and the turned arm to it.
template <class Real>
struct FaceMotion {
  Real move_x, move_y;
  Real arm_x, arm_y;
};

// cos theta - 1, free of cancellation, and sin theta.
template <class Real>
struct Turn {
  Real drop, sine;
};
template <class Real>
[[nodiscard]] WYTHE_INLINE Turn<Real> turn_of(const Rows<Real>& pose) {
  return {Real(-2.0) * pose.c3 * pose.c3, Real(2.0) * pose.c3 * pose.c2};
}

template <class Real>
[[nodiscard]] WYTHE_INLINE FaceMotion<Real> face_motion(const Rows<Real>& pose,
                                                        const Turn<Real>& turn, Real arm_x,
                                                        Real arm_y) {
  const Real dx = turn.drop * arm_x - turn.sine * arm_y;
  const Real dy = turn.sine * arm_x + turn.drop * arm_y;
  return {pose.c0 + dx, pose.c1 + dy, arm_x + dx, arm_y + dy};
}

// Sums over the points of a joint, in its (n, t) axes: F = sum f, G = sum xi f.
template <class Real>
struct FaceForce {
  Real fn, ft, gn, gt;
};

// Jump of the face centre and its growth along the face, in the joint's (n, t) axes. Between two
// blocks nothing grows along t: `dt` is not read.
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

  WYTHE_INLINE void load(const JointArrays& v, Access access,
                         const contact::LawConstants<Real>& law, std::size_t j) {
    each(
        v, law, [&](const double* array, Real H::*member) __attribute__((always_inline)) {
          access.template points<n_point>(
              array, j, v.n_face_point, [&](int k) __attribute__((always_inline))->Real & {
                return at[k].*member;
              });
        });
  }
  WYTHE_INLINE void store(const JointArrays& v, Access access,
                          const contact::LawConstants<Real>& law, std::size_t j) const {
    each(
        v, law, [&](double* array, Real H::*member) __attribute__((always_inline)) {
          access.template keep_points<n_point>(
              [&](int k) __attribute__((always_inline)) { return at[k].*member; }, array, j,
              v.n_face_point);
        });
  }

 private:
  template <class Do>
  WYTHE_INLINE static void each(const JointArrays& v, const contact::LawConstants<Real>& law,
                                const Do& act) {
    act(v.kappa, &H::kappa);
    act(v.crush, &H::crush);
    act(v.plastic_slip, &H::plastic_slip);
    act(v.slip, &H::slip);
    act(v.shear_damage, &H::shear_damage);
    if (contact::choice_of<V>(law).unloading == Unloading::kElastic)
      act(v.tension_set, &H::tension_set);
  }
};

// The points of a face one after the other: act(k, xi, share, opening, slip).
template <int n_point, bool one_slip, class Access, class Real, class Act>
WYTHE_INLINE void each_point(const JointArrays& v, Access access, std::size_t j,
                             const FaceJump<Real>& jump, const Act& act) {
  const Real area = access.shared(v.area, j);
  const int n = n_point > 0 ? n_point : v.n_face_point;
#pragma GCC unroll 2
  for (int k = 0; k < n; ++k) {
    const Real xi(v.xi[k]);
    Real slip = jump.jt;
    if constexpr (!one_slip) slip = slip + xi * jump.dt;
    act(k, xi, area * Real(v.weight[k]), jump.jn + xi * jump.dn, slip);
  }
}

template <class Real>
WYTHE_INLINE void add_point(Real xi, Real share, Real sigma, Real tau, FaceForce<Real>& sum) {
  const Real fn = sigma * share, ft = tau * share;
  sum = {sum.fn + fn, sum.ft + ft, sum.gn + fn * xi, sum.gt + ft * xi};
}

// Forces of a face that may open, slide or crush: the one place where history advances.
template <class V, int n_point, bool one_slip, class Access, class Real>
WYTHE_OUTLINE FaceForce<Real> busy_face(const JointArrays& v, Access access,
                                        const contact::LawConstants<Real>& law, std::size_t j,
                                        const FaceJump<Real>& jump, JointWork<Real>& work) {
  FaceHistory<n_point, V, Access> history;
  history.load(v, access, law, j);
  const Real zero(0.0);
  FaceForce<Real> sum{zero, zero, zero, zero};
  bool_of_t<Real> busy = zero > zero;
  each_point<n_point, one_slip>(
      v, access, j, jump,
      [&](int k, Real xi, Real share, Real opening, Real slip) __attribute__((always_inline)) {
        const contact::History<Real> before = history.at[k];
        const contact::Answer<Real> now = contact::update<V>(law, opening, slip, history.at[k]);
        busy = busy | contact::stays_busy(before, history.at[k], opening);
        add_point(xi, share, now.sigma, now.tau, sum);
        work = {work.friction + now.friction * share, work.fracture + now.fracture * share,
                work.crushing + now.crushing * share};
      });
  history.store(v, access, law, j);
  access.mark(v.busy, j, any(busy));
  return sum;
}

// Forces of a face whose points are all at rest, or false.
template <class V, int n_point, bool one_slip, class Access, class Real>
[[nodiscard]] WYTHE_INLINE bool resting_face(const JointArrays& v, Access access,
                                             const contact::LawConstants<Real>& law, std::size_t j,
                                             const FaceJump<Real>& jump, FaceForce<Real>& sum) {
  FaceHistory<n_point, V, Access> history;
  history.load(v, access, law, j);
  const Real zero(0.0);
  sum = {zero, zero, zero, zero};
  bool_of_t<Real> rests = zero <= zero;
  each_point<n_point, one_slip>(
      v, access, j, jump,
      [&](int k, Real xi, Real share, Real opening, Real slip) __attribute__((always_inline)) {
        const contact::Rest<Real> now = contact::at_rest<V>(law, opening, slip, history.at[k]);
        add_point(xi, share, now.sigma, now.tau, sum);
        rests = rests & now.rests;
      });
  return all(rests);
}

// A face that was busy in the last step is not asked whether it rests.
template <class V, int n_point, bool one_slip, class Access, class Real>
[[nodiscard]] WYTHE_INLINE FaceForce<Real> face_force(const JointArrays& v, Access access,
                                                      const contact::LawConstants<Real>& law,
                                                      std::size_t j, const FaceJump<Real>& jump,
                                                      JointWork<Real>& work) {
  FaceForce<Real> sum;
  if (!access.marked(v.busy, j) && resting_face<V, n_point, one_slip>(v, access, law, j, jump, sum))
    return sum;
  return busy_face<V, n_point, one_slip>(v, access, law, j, jump, work);
}

// Forces of the joints a Real takes from j on.
template <class V, int n_point, class Access, class Real>
WYTHE_INLINE void pair_force(const JointArrays& v, Access access,
                             const contact::LawConstants<Real>& law, std::size_t j,
                             JointWork<Real>& work) {
  const Real half(0.5);
  const Rows<Real> pose_a = access.rows(v.pose, v.a, j), pose_b = access.rows(v.pose, v.b, j);
  const FaceMotion<Real> a = face_motion(pose_a, turn_of(pose_a), access.shared(v.arm_a_x, j),
                                         access.shared(v.arm_a_y, j));
  const FaceMotion<Real> b = face_motion(pose_b, turn_of(pose_b), access.shared(v.arm_b_x, j),
                                         access.shared(v.arm_b_y, j));
  // cosine and sine of phi and of delta/2
  const Real cc = pose_a.c2 * pose_b.c2, ss = pose_a.c3 * pose_b.c3;
  const Real sc = pose_a.c3 * pose_b.c2, cs = pose_a.c2 * pose_b.c3;
  const Real cos = cc - ss, sin = sc + cs;
  const Real tx0 = access.shared(v.tangent_x, j), ty0 = access.shared(v.tangent_y, j);
  const Real tx = cos * tx0 - sin * ty0, ty = sin * tx0 + cos * ty0;
  const Real reach = access.shared(v.half_length, j);
  const Real jx = b.move_x - a.move_x, jy = b.move_y - a.move_y;
  const FaceForce<Real> f =
      face_force<V, n_point, true>(v, access, law, j,
                                   FaceJump<Real>{jy * tx - jx * ty, jx * tx + jy * ty,
                                                  Real(2.0) * reach * (cs - sc), Real(0.0)},
                                   work);
  // back to the wall's axes: n = (-ty, tx)
  const Real fx = f.ft * tx - f.fn * ty, fy = f.ft * ty + f.fn * tx;
  const Real couple = reach * (cc + ss) * f.gn;
  const Real cx = half * jx, cy = half * jy;
  access.keep_rows({fx, fy, ((a.arm_x + cx) * fy - (a.arm_y + cy) * fx) + couple,
                    ((b.arm_y - cy) * fx - (b.arm_x - cx) * fy) - couple},
                   v.force, j);
}

// The same on the ground, whose tangent stands still and which has no lever.
template <class V, int n_point, class Access, class Real>
WYTHE_INLINE void ground_force(const JointArrays& v, Access access,
                               const contact::LawConstants<Real>& law, std::size_t j,
                               JointWork<Real>& work) {
  const Rows<Real> pose = access.rows(v.pose, v.b, j);
  const Turn<Real> turn = turn_of(pose);
  const FaceMotion<Real> b =
      face_motion(pose, turn, access.shared(v.arm_b_x, j), access.shared(v.arm_b_y, j));
  const Real tx = access.shared(v.tangent_x, j), ty = access.shared(v.tangent_y, j);
  const Real reach = access.shared(v.half_length, j);
  const FaceForce<Real> f = face_force<V, n_point, false>(
      v, access, law, j,
      FaceJump<Real>{b.move_y * tx - b.move_x * ty, b.move_x * tx + b.move_y * ty,
                     reach * turn.sine, reach * turn.drop},
      work);
  const Real fx = f.ft * tx - f.fn * ty, fy = f.ft * ty + f.fn * tx;
  // the turned face is h ((1 + drop) t + sine n)
  const Real couple = reach * ((Real(1.0) + turn.drop) * f.gn - turn.sine * f.gt);
  access.keep_rows({fx, fy, Real(0.0), (b.arm_y * fx - b.arm_x * fy) - couple}, v.force, j);
}

// The constants of a law, each by take(member).
template <class Real, class Take>
[[nodiscard]] WYTHE_INLINE contact::LawConstants<Real> law_by(const contact::LawChoice& choice,
                                                              const Take& take) {
  using C = contact::LawConstants<double>;
  return {take(&C::kn),
          take(&C::ks),
          take(&C::inv_ks),
          take(&C::inv_kn),
          take(&C::ft),
          take(&C::w0),
          take(&C::ft_over_GI),
          take(&C::tension_onset),
          take(&C::tension_rate),
          take(&C::c_res),
          take(&C::c_drop),
          take(&C::tan_res),
          take(&C::tan_drop),
          take(&C::half_inv_GII),
          take(&C::fc),
          take(&C::p_full),
          take(&C::inv_p_full),
          take(&C::crush_gain),
          choice};
}
// The same law in every lane; the law of each wall.
template <class Real>
[[nodiscard]] WYTHE_INLINE contact::LawConstants<Real> law_of(
    const contact::LawConstants<double>* law, Neighbours<Real>) {
  return law_by<Real>(law->choice, [&](auto member) { return Real(law->*member); });
}
template <class Real>
[[nodiscard]] WYTHE_INLINE contact::LawConstants<Real> law_of(
    const contact::LawConstants<double>* law, Walls<Real>) {
  return law_by<Real>(law->choice, [&](auto member) {
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
    if constexpr (on_ground)
      ground_force<V, n_point>(v, access, law, j, work[k]);
    else
      pair_force<V, n_point>(v, access, law, j, work[k]);
    k = (k + 1) % Access::packs;
  }
  store_work(access, work, energy);
}

}  // namespace wythe::dynamics
