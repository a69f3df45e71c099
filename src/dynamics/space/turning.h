// Rotation of a free body in a step, forwards and back (docs/theory/space.md, "Motion").
#pragma once

#include "contact/face_in_space.h"
#include "dynamics/passes/access.h"
#include "dynamics/space/tables.h"

namespace wythe::dynamics::space {

// Principal axes at the start, and 1 / inertia about them.
template <class Real>
struct Inertia {
  Vector<Real> axis[3];
  Real inverse[3];

  // Rate of rotation of the angular momentum m, both in the block's axes.
  [[nodiscard]] WYTHE_INLINE Vector<Real> rate(const Vector<Real>& m) const {
    return (inverse[0] * dot(axis[0], m)) * axis[0] + (inverse[1] * dot(axis[1], m)) * axis[1] +
           (inverse[2] * dot(axis[2], m)) * axis[2];
  }
};

// The turn q of a free body with angular momentum m (in its own axes) after dt: rotations about axes 3, 2, 1,
// 2, 3 with weights 1/2, 1/2, 1, 1/2, 1/2 (Dullweber, Leimkuhler, McLachlan 1997), each with the half angle
// (1, phi/2) / sqrt(1 + phi^2/4) of Cayley, so that no sine is needed; then one step back to length 1.
template <class Real>
[[nodiscard]] WYTHE_INLINE Quaternion<Real> spin(Quaternion<Real> q, Vector<Real> m,
                                                 const Inertia<Real>& body, Real dt) {
  const Real one(1.0), half(0.5), two(2.0);
  const auto about = [&](int k, Real weight) __attribute__((always_inline)) {
    const Vector<Real>& axis = body.axis[k];
    const Real along = dot(axis, m);
    const Real x = half * weight * dt * body.inverse[k] * along;
    const Real c = one / square_root(one + x * x), s = x * c;
    // m turned by -phi about the axis: along it nothing changes
    const Real cosine = one - two * s * s, sine = two * s * c;
    m = cosine * m + (two * s * s * along) * axis + sine * cross(m, axis);
    q = q * Quaternion<Real>{c, s * axis};
  };
  about(2, half);
  about(1, half);
  about(0, one);
  about(1, half);
  about(2, half);
  const Real length = Real(1.5) - half * (q.w * q.w + dot(q.v, q.v));
  return {length * q.w, length * q.v};
}

// The pose of body id[item] in the step before: undoes the motion by its velocity and angular
// momentum. The five rotations of spin() are symmetric, so undoing them is exact up to rounding.
template <class Access, class Real = typename Access::Real>
[[nodiscard]] WYTHE_INLINE contact::Pose<Real> pose_before(const Tables& t, const Access& access,
                                                           const std::int32_t* id,
                                                           std::ptrdiff_t item) {
  const auto vector = [&](int row) {
    const auto of = [&](int c) { return access.of(t.body, kBodyRows, row + c, id, item); };
    return Vector<Real>{of(0), of(1), of(2)};
  };
  const auto axis = [&](int row) {
    if constexpr (Access::one_wall) {
      return access.of(t.axes, kAxisRows, row, id, item);
    } else {
      return access.shared(t.axes, static_cast<std::ptrdiff_t>(id[item]) * kAxisRows + row);
    }
  };
  const Rows<Real> shift = access.rows(t.shift, id, item), turn = access.rows(t.turn, id, item);
  const Real dt = access.wall_value(t.wall, kTimeBefore);
  const Quaternion<Real> q{shift.c3, {turn.c0, turn.c1, turn.c2}};
  Inertia<Real> body;
  for (int k = 0; k < 3; ++k) {
    body.axis[k] = {axis(3 * k), axis(3 * k + 1), axis(3 * k + 2)};
    body.inverse[k] = access.of(t.body, kBodyRows, kInverse + k, id, item);
  }
  const Vector<Real> moved = dt * vector(kV);
  return {Vector<Real>{shift.c0, shift.c1, shift.c2} - moved,
          spin(q, turned_back(q, vector(kL)), body, Real(0.0) - dt)};
}

}  // namespace wythe::dynamics::space
