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
// Real is one joint (double) or neighbours side by side (Pack); Lanes<Real> loads and stores them.
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
template <int n_point, class V, class Real>
struct FaceHistory {
  contact::History<Real> at[n_point > 0 ? n_point : kMaxFacePoints];

  WYTHE_INLINE void load(const JointArrays& v, std::size_t j) {
    each(v, j,
         [](const double* array, std::ptrdiff_t n, Real contact::History<Real>::*member,
            contact::History<Real>* h) {
           if constexpr (n_point == 2) {
             Lanes<Real>::load_pairs(array, h[0].*member, h[1].*member);
           } else {
             for (int k = 0; k < n; ++k) h[k].*member = Lanes<Real>::load_point(array + k, n);
           }
         });
  }
  WYTHE_INLINE void store(const JointArrays& v, std::size_t j) {
    each(v, j,
         [](double* array, std::ptrdiff_t n, Real contact::History<Real>::*member,
            const contact::History<Real>* h) {
           if constexpr (n_point == 2) {
             Lanes<Real>::store_pairs(h[0].*member, h[1].*member, array);
           } else {
             for (int k = 0; k < n; ++k) Lanes<Real>::store_point(h[k].*member, array + k, n);
           }
         });
  }

 private:
  template <class Do>
  WYTHE_INLINE void each(const JointArrays& v, std::size_t j, const Do& act) {
    using H = contact::History<Real>;
    const auto n = static_cast<std::ptrdiff_t>(n_point > 0 ? n_point : v.n_face_point);
    const auto p = static_cast<std::ptrdiff_t>(j) * n;
    act(v.kappa + p, n, &H::kappa, at);
    act(v.crush + p, n, &H::crush, at);
    act(v.plastic_slip + p, n, &H::plastic_slip, at);
    act(v.slip + p, n, &H::slip, at);
    act(v.shear_damage + p, n, &H::shear_damage, at);
    if constexpr (V::unloading == Unloading::kElastic)
      act(v.tension_set + p, n, &H::tension_set, at);
  }
};

template <class V, int n_point, class Real>
[[nodiscard]] WYTHE_INLINE FaceForce<Real> face_force(const JointArrays& v,
                                                      const contact::LawConstants<Real>& law,
                                                      std::size_t j, const FaceJump<Real>& jump,
                                                      JointWork<Real>& work) {
  const int n = n_point > 0 ? n_point : v.n_face_point;
  const Real area = Lanes<Real>::load(v.area + j);
  FaceHistory<n_point, V, Real> history;
  history.load(v, j);
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
  history.store(v, j);  // commit: the one place where history advances
  return sum;
}

// Forces of joint j and its Lanes<Real>::width - 1 neighbours. A kernel: the block-block and the
// ground case share all but the frame and the levers.
template <class V, bool on_ground, int n_point, class Real>
WYTHE_INLINE void joint_force(const JointArrays& v, const contact::LawConstants<Real>& law,
                              std::size_t j, JointWork<Real>& work) {
  using L = Lanes<Real>;
  const Real half(0.5), ex = L::load(v.half_x + j), ey = L::load(v.half_y + j);
  const Rows<Real> pose_b = L::load_rows(v.pose, v.b + j);
  FaceMotion<Real> ma{Real(0.0), Real(0.0), Real(0.0), Real(0.0), Real(0.0), Real(0.0)};
  const FaceMotion<Real> mb =
      face_motion(pose_b, L::load(v.arm_b_x + j), L::load(v.arm_b_y + j), ex, ey);
  Real tx = L::load(v.tangent_x + j), ty = L::load(v.tangent_y + j);
  if constexpr (!on_ground) {
    const Rows<Real> pose_a = L::load_rows(v.pose, v.a + j);
    ma = face_motion(pose_a, L::load(v.arm_a_x + j), L::load(v.arm_a_y + j), ex, ey);
    const Real cos = pose_a.c2 * pose_b.c2 - pose_a.c3 * pose_b.c3;
    const Real sin = pose_a.c3 * pose_b.c2 + pose_a.c2 * pose_b.c3;
    const Real tx0 = tx;
    tx = cos * tx0 - sin * ty;
    ty = sin * tx0 + cos * ty;
  }
  const Real jx = mb.move_x - ma.move_x, jy = mb.move_y - ma.move_y;
  const Real dx = mb.turn_x - ma.turn_x, dy = mb.turn_y - ma.turn_y;
  const FaceForce<Real> f = face_force<V, n_point>(
      v, law, j, {jy * tx - jx * ty, jx * tx + jy * ty, dy * tx - dx * ty, dx * tx + dy * ty},
      work);
  // back to the wall's axes: n = (-ty, tx)
  const Real fx = f.ft * tx - f.fn * ty, fy = f.ft * ty + f.fn * tx;
  const Real gx = f.gt * tx - f.gn * ty, gy = f.gt * ty + f.gn * tx;
  if constexpr (on_ground) {
    const Real hx = ex + mb.turn_x, hy = ey + mb.turn_y;
    const Real moment_b = (mb.arm_y * fx - mb.arm_x * fy) + (hy * gx - hx * gy);
    L::store_rows({fx, fy, Real(0.0), moment_b}, v.force + 4 * j);
  } else {
    const Real hx = ex + half * (ma.turn_x + mb.turn_x), hy = ey + half * (ma.turn_y + mb.turn_y);
    const Real couple = hx * gy - hy * gx;
    const Real ax = ma.arm_x + half * jx, ay = ma.arm_y + half * jy;
    const Real bx = mb.arm_x - half * jx, by = mb.arm_y - half * jy;
    L::store_rows({fx, fy, (ax * fy - ay * fx) + couple, (by * fx - bx * fy) - couple},
                  v.force + 4 * j);
  }
}

// The same law in every lane.
template <class Real>
[[nodiscard]] WYTHE_INLINE contact::LawConstants<Real> same_in_lanes(
    const contact::LawConstants<double>& m) {
  return {Real(m.kn),           Real(m.ks),           Real(m.inv_ks),     Real(m.inv_kn),
          Real(m.ft),           Real(m.w0),           Real(m.ft_over_GI), Real(m.tension_onset),
          Real(m.tension_rate), Real(m.c_res),        Real(m.c_drop),     Real(m.tan_res),
          Real(m.tan_drop),     Real(m.half_inv_GII), Real(m.fc),         Real(m.p_full),
          Real(m.inv_p_full),   Real(m.crush_gain)};
}

template <class Real, int packs>
WYTHE_INLINE void load_work(const JointLanes& lanes, JointWork<Real> (&work)[packs]) {
  using L = Lanes<Real>;
  for (int k = 0; k < packs; ++k)
    work[k] = {L::load(lanes.friction + k * L::width), L::load(lanes.fracture + k * L::width),
               L::load(lanes.crushing + k * L::width)};
}
template <class Real, int packs>
WYTHE_INLINE void store_work(const JointWork<Real> (&work)[packs], JointLanes& lanes) {
  using L = Lanes<Real>;
  for (int k = 0; k < packs; ++k) {
    L::store(work[k].friction, lanes.friction + k * L::width);
    L::store(work[k].fracture, lanes.fracture + k * L::width);
    L::store(work[k].crushing, lanes.crushing + k * L::width);
  }
}

// Joints begin..end-1, all of one law; for packs a whole number of groups.
template <class V, bool on_ground, int n_point, class Real>
void joint_run(const JointArrays& v, const contact::LawConstants<double>& constants,
               std::size_t begin, std::size_t end, JointLanes& lanes) {
  using L = Lanes<Real>;
  constexpr int packs = kGroup / L::width;
  const contact::LawConstants<Real> law = same_in_lanes<Real>(constants);
  JointWork<Real> work[packs];
  load_work(lanes, work);
  int k = 0;
  for (std::size_t j = begin; j < end; j += static_cast<std::size_t>(L::width)) {
    joint_force<V, on_ground, n_point>(v, law, j, work[k]);
    k = (k + 1) % packs;
  }
  store_work(work, lanes);
}

}  // namespace wythe::dynamics
