// A joint face between two blocks in space: the motion that the joint law sees, and the forces of its stresses
// on the blocks (docs/theory/space.md, "The face between two blocks").
//
// Between two blocks the frame (t1, t2, n) rotates with the mean of both rotations. j is the jump of the face's
// centre, the quaternion p the rotation of b against a. The jump grows along the face by d = 2 vec(p):
//
//   g(r) = j + d x r,   r = r1 t1 + r2 t2       w = g . n    s1 = g . t1    s2 = g . t2
//   F = sum f,  M = sum r x f,  f = share area (sigma n + tau1 t1 + tau2 t2)
//   on a:   F  at its face's centre, and  j x F / 2 + C - D,    C = M - vec(p) (vec(p) . M) / (1 + w(p))
//   on b:  -F  at its face's centre, and  j x F / 2 - C + D,    D = vec(p) x (j x F) / (2 (1 + w(p)))
//
// These are the exact gradient of the law's work; momentum and angular momentum are conserved exactly.
// On a support the frame is fixed, and each force acts at the point of the block.
#pragma once

#include "core/rotation.h"

namespace wythe::contact {

// Displacement of a block's centroid, and its rotation since the start.
template <class Real>
struct Pose {
  Vector<Real> u;
  Quaternion<Real> q;
};

// Jump of the points of a face in its frame: g(r) = j + r1 a + r2 b; components along t1, t2, n.
template <class Real>
struct FaceGap {
  Vector<Real> j, a, b;
};
// Forces of the law on a face, in the same components: sums of f, r1 f and r2 f.
template <class Real>
struct FaceLoad {
  Vector<Real> f, r1, r2;
};
// Forces on the blocks in the axes of the wall: f on a and -f on b, with moments about their centroids.
template <class Real>
struct BlockLoads {
  Vector<Real> f, on_a, on_b;
};

template <class Real>
struct Frame {
  Vector<Real> t1, t2, n;
  [[nodiscard]] WYTHE_INLINE Vector<Real> in(const Vector<Real>& v) const {
    return {dot(v, t1), dot(v, t2), dot(v, n)};
  }
  [[nodiscard]] WYTHE_INLINE Vector<Real> out(const Vector<Real>& c) const {
    return c.x * t1 + c.y * t2 + c.z * n;
  }
};

// A face between two free blocks.
template <class Real>
struct PairFace {
  Frame<Real> frame;
  Vector<Real> arm_a, arm_b;  // turned
  Vector<Real> jump;          // in the wall's axes
  Vector<Real> p;             // vector part of the rotation of b against a
  Real inv;                   // 1 / (1 + w(p))

  WYTHE_INLINE PairFace(const Pose<Real>& a, const Pose<Real>& b, const Vector<Real>& arm_a0,
                        const Vector<Real>& arm_b0, const Vector<Real>& t0,
                        const Vector<Real>& n0) {
    const Vector<Real> move_a = swing(a.q, arm_a0), move_b = swing(b.q, arm_b0);
    arm_a = arm_a0 + move_a;
    arm_b = arm_b0 + move_b;
    jump = (b.u + move_b) - (a.u + move_a);
    // of the two quaternions +-q of b's rotation the one nearer to a's
    const Real product = a.q.w * b.q.w + dot(a.q.v, b.q.v);
    const Real one(1.0), sense = select(product < Real(0.0), Real(-1.0), one);
    const Quaternion<Real> qb{sense * b.q.w, sense * b.q.v};
    p = (a.q.w * qb.v - qb.w * a.q.v) - cross(qb.v, a.q.v);
    inv = one / (one + magnitude(product));
    const Quaternion<Real> sum{a.q.w + qb.w, a.q.v + qb.v};
    frame.t1 = t0 + inv * cross(sum.v, cross(sum.v, t0) + sum.w * t0);
    frame.n = n0 + inv * cross(sum.v, cross(sum.v, n0) + sum.w * n0);
    frame.t2 = cross(frame.n, frame.t1);
  }
  [[nodiscard]] WYTHE_INLINE FaceGap<Real> gap() const {
    const Real two(2.0), zero(0.0);
    const Vector<Real> d = two * frame.in(p);
    return {frame.in(jump), {zero, d.z, zero - d.y}, {zero - d.z, zero, d.x}};
  }
  [[nodiscard]] WYTHE_INLINE BlockLoads<Real> loads(const FaceLoad<Real>& l) const {
    const Real half(0.5);
    const Vector<Real> f = frame.out(l.f);
    const Vector<Real> m = frame.out({l.r2.z, Real(0.0) - l.r1.z, l.r1.y - l.r2.x});
    const Vector<Real> lever = half * cross(jump, f);
    const Vector<Real> c = m - (inv * dot(p, m)) * p;
    const Vector<Real> d = c - inv * cross(p, lever);
    return {f, (cross(arm_a, f) + lever) + d, (lever - cross(arm_b, f)) - d};
  }
};

// A face on a support, which translates but does not rotate.
template <class Real>
struct SupportFace {
  Frame<Real> frame;
  Vector<Real> arm_b, jump;
  Vector<Real> grown_1, grown_2;  // growth of t1 and t2 by the block's rotation, in the frame

  WYTHE_INLINE SupportFace(const Vector<Real>& support, const Pose<Real>& b,
                           const Vector<Real>& arm_b0, const Vector<Real>& t0,
                           const Vector<Real>& n0) {
    frame = {t0, cross(n0, t0), n0};
    const Vector<Real> move_b = swing(b.q, arm_b0);
    arm_b = arm_b0 + move_b;
    jump = (b.u + move_b) - support;
    grown_1 = frame.in(swing(b.q, frame.t1));
    grown_2 = frame.in(swing(b.q, frame.t2));
  }
  [[nodiscard]] WYTHE_INLINE FaceGap<Real> gap() const {
    return {frame.in(jump), grown_1, grown_2};
  }
  [[nodiscard]] WYTHE_INLINE BlockLoads<Real> loads(const FaceLoad<Real>& l) const {
    const Real zero(0.0), one(1.0);
    const Vector<Real> f = frame.out(l.f);
    const Vector<Real> t1{one + grown_1.x, grown_1.y, grown_1.z};
    const Vector<Real> t2{grown_2.x, one + grown_2.y, grown_2.z};
    const Vector<Real> m = frame.out(cross(t1, l.r1) + cross(t2, l.r2));
    return {f, {zero, zero, zero}, Real(-1.0) * (cross(arm_b, f) + m)};
  }
};

// Shear as a vector: the law gets the length e of the elastic slip, and the plastic slip has its
// direction (radial return on the friction circle).
template <class Real>
struct Shear {
  Real e1, e2, e;
};
template <class Real>
[[nodiscard]] WYTHE_INLINE Shear<Real> shear_of(Real s1, Real s2, Real plastic_1, Real plastic_2) {
  const Real e1 = s1 - plastic_1, e2 = s2 - plastic_2;
  return {e1, e2, square_root(e1 * e1 + e2 * e2)};
}
// Component of `other` along `shear`.
template <class Real>
[[nodiscard]] WYTHE_INLINE Real along(const Shear<Real>& shear, const Shear<Real>& other) {
  return (shear.e1 * other.e1 + shear.e2 * other.e2) / maximum(shear.e, Real(1e-300));
}

}  // namespace wythe::contact
