// Vectors and quaternions of Reals for steps in space. Only + - * / and sqrt are used, so that the bits are the
// same on every machine. Code outside the step uses wythe/parts/vector.h.
#pragma once

#include "core/real.h"

namespace wythe {

template <class Real>
struct Vector {
  Real x, y, z;
};
template <class Real>
[[nodiscard]] WYTHE_INLINE Vector<Real> operator+(const Vector<Real>& a, const Vector<Real>& b) {
  return {a.x + b.x, a.y + b.y, a.z + b.z};
}
template <class Real>
[[nodiscard]] WYTHE_INLINE Vector<Real> operator-(const Vector<Real>& a, const Vector<Real>& b) {
  return {a.x - b.x, a.y - b.y, a.z - b.z};
}
template <class Real>
[[nodiscard]] WYTHE_INLINE Vector<Real> operator*(const Real& s, const Vector<Real>& a) {
  return {s * a.x, s * a.y, s * a.z};
}
template <class Real>
[[nodiscard]] WYTHE_INLINE Real dot(const Vector<Real>& a, const Vector<Real>& b) {
  return a.x * b.x + a.y * b.y + a.z * b.z;
}
template <class Real>
[[nodiscard]] WYTHE_INLINE Vector<Real> cross(const Vector<Real>& a, const Vector<Real>& b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

// Unit quaternion w + x i + y j + z k: a rotation by 2 acos(w) about (x, y, z).
template <class Real>
struct Quaternion {
  Real w;
  Vector<Real> v;
};
// The rotation b followed by the rotation a.
template <class Real>
[[nodiscard]] WYTHE_INLINE Quaternion<Real> operator*(const Quaternion<Real>& a,
                                                      const Quaternion<Real>& b) {
  return {a.w * b.w - dot(a.v, b.v), a.w * b.v + b.w * a.v + cross(a.v, b.v)};
}
// Displacement of the tip of `arm` by a rotation: R a - a, without cancellation.
template <class Real>
[[nodiscard]] WYTHE_INLINE Vector<Real> swing(const Quaternion<Real>& q, const Vector<Real>& arm) {
  const Vector<Real> half = cross(q.v, arm) + q.w * arm;
  return Real(2.0) * cross(q.v, half);
}
template <class Real>
[[nodiscard]] WYTHE_INLINE Vector<Real> turned(const Quaternion<Real>& q, const Vector<Real>& arm) {
  return arm + swing(q, arm);
}
template <class Real>
[[nodiscard]] WYTHE_INLINE Vector<Real> turned_back(const Quaternion<Real>& q,
                                                    const Vector<Real>& arm) {
  return arm + swing(Quaternion<Real>{q.w, Real(-1.0) * q.v}, arm);
}

}  // namespace wythe
