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
#pragma once

#include "contact/law.h"
#include "wythe/model.h"

namespace wythe::dynamics {

// Pointers to what the pass reads and writes; Real is the type of everything that differs between
// samples, so that lanes of samples run through the same code.
template <class Real>
struct JointView {
  const BlockId *a, *b;
  const std::int32_t* material;
  const double *arm_a_x, *arm_a_y, *arm_b_x, *arm_b_y;
  const double *half_x, *half_y, *tangent_x, *tangent_y, *area;
  const double *xi, *weight;
  int n_face_point;
  const contact::LawConstants<Real>* law;

  const Real *ux, *uy, *half_cos, *half_sin;
  Real *kappa, *crush, *plastic_slip, *slip, *shear_damage, *tension_set;
  Real *force_x, *force_y, *moment_a, *moment_b;
};

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
[[nodiscard]] WYTHE_INLINE FaceMotion<Real> face_motion(const JointView<Real>& v, BlockId block,
                                                        double arm_x, double arm_y, double ex,
                                                        double ey) {
  const auto i = static_cast<std::size_t>(block);
  const Real c = v.half_cos[i], s = v.half_sin[i];
  const Real drop = Real(-2.0) * s * s;  // cos theta - 1, free of cancellation
  const Real sine = Real(2.0) * s * c;
  const Real dx = drop * arm_x - sine * arm_y, dy = sine * arm_x + drop * arm_y;
  return {v.ux[i] + dx, v.uy[i] + dy,          arm_x + dx,
          arm_y + dy,   drop * ex - sine * ey, sine * ex + drop * ey};
}

// Sums over the points of a joint, in its (n, t) axes: F = sum f, G = sum xi f.
template <class Real>
struct FaceForce {
  Real fn, ft, gn, gt;
};

template <class V, class Real>
[[nodiscard]] WYTHE_INLINE FaceForce<Real> face_force(const JointView<Real>& v, std::size_t joint,
                                                      Real jn, Real jt, Real dn, Real dt,
                                                      JointWork<Real>& work) {
  const contact::LawConstants<Real>& law = v.law[v.material[joint]];
  FaceForce<Real> sum{Real(0.0), Real(0.0), Real(0.0), Real(0.0)};
  for (int k = 0; k < v.n_face_point; ++k) {
    const std::size_t p =
        joint * static_cast<std::size_t>(v.n_face_point) + static_cast<std::size_t>(k);
    contact::History<Real> h{v.kappa[p], v.crush[p],        v.plastic_slip[p],
                             v.slip[p],  v.shear_damage[p], v.tension_set[p]};
    const contact::Answer<Real> now =
        contact::update<V>(law, jn + v.xi[k] * dn, jt + v.xi[k] * dt, h);
    // commit: the one place where history advances
    v.kappa[p] = h.kappa;
    v.crush[p] = h.crush;
    v.plastic_slip[p] = h.plastic_slip;
    v.slip[p] = h.slip;
    v.shear_damage[p] = h.shear_damage;
    if constexpr (V::unloading == Unloading::kElastic) v.tension_set[p] = h.tension_set;
    const double share = v.area[joint] * v.weight[k];
    const Real fn = now.sigma * share, ft = now.tau * share;
    sum = {sum.fn + fn, sum.ft + ft, sum.gn + fn * v.xi[k], sum.gt + ft * v.xi[k]};
    work = {work.friction + now.friction * share, work.fracture + now.fracture * share,
            work.crushing + now.crushing * share};
  }
  return sum;
}

// Forces of the joints begin..end-1. A kernel: the block-block and the ground case share all but
// the frame and the levers.
template <class V, bool on_ground, class Real>
[[nodiscard]] JointWork<Real> joint_forces(const JointView<Real>& v, JointId begin, JointId end) {
  const Real half(0.5);
  JointWork<Real> work{Real(0.0), Real(0.0), Real(0.0)};
  for (auto j = static_cast<std::size_t>(begin); j < static_cast<std::size_t>(end); ++j) {
    const double ex = v.half_x[j], ey = v.half_y[j];
    const auto b = static_cast<std::size_t>(v.b[j]);
    FaceMotion<Real> ma{};
    const FaceMotion<Real> mb = face_motion(v, v.b[j], v.arm_b_x[j], v.arm_b_y[j], ex, ey);
    Real cos(1.0), sin(0.0);
    if constexpr (!on_ground) {
      const auto a = static_cast<std::size_t>(v.a[j]);
      ma = face_motion(v, v.a[j], v.arm_a_x[j], v.arm_a_y[j], ex, ey);
      cos = v.half_cos[a] * v.half_cos[b] - v.half_sin[a] * v.half_sin[b];
      sin = v.half_sin[a] * v.half_cos[b] + v.half_cos[a] * v.half_sin[b];
    }
    // frame, jump and its growth along the face
    const Real tx = cos * v.tangent_x[j] - sin * v.tangent_y[j];
    const Real ty = sin * v.tangent_x[j] + cos * v.tangent_y[j];
    const Real jx = mb.move_x - ma.move_x, jy = mb.move_y - ma.move_y;
    const Real dx = mb.turn_x - ma.turn_x, dy = mb.turn_y - ma.turn_y;
    const FaceForce<Real> f = face_force<V>(v, j, jy * tx - jx * ty, jx * tx + jy * ty,
                                            dy * tx - dx * ty, dx * tx + dy * ty, work);
    // back to the wall's axes: n = (-ty, tx)
    const Real fx = f.ft * tx - f.fn * ty, fy = f.ft * ty + f.fn * tx;
    const Real gx = f.gt * tx - f.gn * ty, gy = f.gt * ty + f.gn * tx;
    v.force_x[j] = fx;
    v.force_y[j] = fy;
    if constexpr (on_ground) {
      const Real hx = ex + mb.turn_x, hy = ey + mb.turn_y;
      v.moment_b[j] = (mb.arm_y * fx - mb.arm_x * fy) + (hy * gx - hx * gy);
    } else {
      const Real hx = ex + half * (ma.turn_x + mb.turn_x), hy = ey + half * (ma.turn_y + mb.turn_y);
      const Real couple = hx * gy - hy * gx;
      const Real ax = ma.arm_x + half * jx, ay = ma.arm_y + half * jy;
      const Real bx = mb.arm_x - half * jx, by = mb.arm_y - half * jy;
      v.moment_a[j] = (ax * fy - ay * fx) + couple;
      v.moment_b[j] = (by * fx - bx * fy) - couple;
    }
  }
  return work;
}

}  // namespace wythe::dynamics
