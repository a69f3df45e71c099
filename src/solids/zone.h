// The force of a zone on its four corners for any displacement: corotational and conservative.
//
// The zone rotates with its deformation gradient F at the middle:
//   tan theta = (Fyx - Fxy) / (Fxx + Fyy)
//   d = R' x - X           displacement in the rotated frame, x and X relative to their means
//   E = 1/2 d' K d         strain energy
//   f = -dE/dx = -R (K d - m/r g),  m = moment of K d about the mean,  g = r d theta/dx
//
// The last term belongs to the rotation of the frame. With it the four forces have neither sum nor moment
// in any state, and their work is exactly the change of E. It needs one root, one division, no branch.
#pragma once

#include "core/real.h"
#include "wythe/parts/zone_shape.h"

namespace wythe::solids {

// One vector for each corner.
template <class Real>
struct ZoneVectors {
  Real x[4], y[4];
};

// The rotating frame and the displacements in it.
template <class Real>
struct ZoneMotion {
  Real cos, sin, inv_r;
  ZoneVectors<Real> d;
};

template <class Real>
[[nodiscard]] WYTHE_INLINE ZoneMotion<Real> zone_motion(const ZoneShape& shape,
                                                        const ZoneVectors<Real>& u) {
  // opposite corners have opposite gradients
  const Real x02 = u.x[0] - u.x[2], x13 = u.x[1] - u.x[3];
  const Real y02 = u.y[0] - u.y[2], y13 = u.y[1] - u.y[3];
  const Real gx0(shape.grad_x[0]), gx1(shape.grad_x[1]);
  const Real gy0(shape.grad_y[0]), gy1(shape.grad_y[1]);
  const Real a = Real(2.0) + (gx0 * x02 + gx1 * x13) + (gy0 * y02 + gy1 * y13);
  const Real b = (gx0 * y02 + gx1 * y13) - (gy0 * x02 + gy1 * x13);
  ZoneMotion<Real> m;
  m.inv_r = Real(1.0) / square_root(a * a + b * b);
  m.cos = a * m.inv_r;
  m.sin = b * m.inv_r;
  const Real quarter(0.25), drop = m.cos - Real(1.0);
  const Real mean_x = quarter * ((u.x[0] + u.x[1]) + (u.x[2] + u.x[3]));
  const Real mean_y = quarter * ((u.y[0] + u.y[1]) + (u.y[2] + u.y[3]));
  for (int k = 0; k < 4; ++k) {
    const Real vx = u.x[k] - mean_x, vy = u.y[k] - mean_y;
    const Real x(shape.x[k]), y(shape.y[k]);
    m.d.x[k] = (m.cos * vx + m.sin * vy) + (drop * x + m.sin * y);
    m.d.y[k] = (m.cos * vy - m.sin * vx) + (drop * y - m.sin * x);
  }
  return m;
}

// K d: corner forces in the rotated frame.
template <class Real>
[[nodiscard]] WYTHE_INLINE ZoneVectors<Real> corner_forces(const ZoneShape& shape,
                                                           const ZoneVectors<Real>& d) {
  ZoneVectors<Real> f;
  const auto row = [&](int i) __attribute__((always_inline)) {
    const double* k = shape.stiffness[i];
    return ((Real(k[0]) * d.x[0] + Real(k[1]) * d.y[0]) +
            (Real(k[2]) * d.x[1] + Real(k[3]) * d.y[1])) +
           ((Real(k[4]) * d.x[2] + Real(k[5]) * d.y[2]) +
            (Real(k[6]) * d.x[3] + Real(k[7]) * d.y[3]));
  };
#pragma GCC unroll 4
  for (int k = 0; k < 4; ++k) {
    f.x[k] = row(2 * k);
    f.y[k] = row(2 * k + 1);
  }
  return f;
}

// Forces of the zone on its corners in the axes of the wall [N].
template <class Real>
[[nodiscard]] WYTHE_INLINE ZoneVectors<Real> zone_force(const ZoneShape& shape,
                                                        const ZoneVectors<Real>& u) {
  const ZoneMotion<Real> m = zone_motion(shape, u);
  const ZoneVectors<Real> f = corner_forces(shape, m.d);
  Real moment(0.0);
  for (int k = 0; k < 4; ++k)
    moment =
        moment + ((Real(shape.x[k]) + m.d.x[k]) * f.y[k] - (Real(shape.y[k]) + m.d.y[k]) * f.x[k]);
  const Real turn = moment * m.inv_r;
  ZoneVectors<Real> out;
  for (int k = 0; k < 4; ++k) {
    const Real fx = turn * Real(-shape.grad_y[k]) - f.x[k];
    const Real fy = turn * Real(shape.grad_x[k]) - f.y[k];
    out.x[k] = m.cos * fx - m.sin * fy;
    out.y[k] = m.sin * fx + m.cos * fy;
  }
  return out;
}

// Strain energy [J].
[[nodiscard]] WYTHE_INLINE double zone_energy(const ZoneShape& shape,
                                              const ZoneVectors<double>& u) {
  const ZoneMotion<double> m = zone_motion(shape, u);
  const ZoneVectors<double> f = corner_forces(shape, m.d);
  double twice = 0;
  for (int k = 0; k < 4; ++k) twice += m.d.x[k] * f.x[k] + m.d.y[k] * f.y[k];
  return 0.5 * twice;
}

// Mean stresses in the rotated frame [Pa].
struct PlaneStress {
  double x, y, xy;
};
[[nodiscard]] WYTHE_INLINE PlaneStress zone_stress(const ZoneShape& shape,
                                                   const ZoneVectors<double>& d) {
  double ex = 0, ey = 0, gamma = 0;
  for (int k = 0; k < 4; ++k) {
    ex += shape.grad_x[k] * d.x[k];
    ey += shape.grad_y[k] * d.y[k];
    gamma += shape.grad_y[k] * d.x[k] + shape.grad_x[k] * d.y[k];
  }
  const auto& c = shape.elasticity;
  return {c[0][0] * ex + c[0][1] * ey, c[1][0] * ex + c[1][1] * ey, c[2][2] * gamma};
}

}  // namespace wythe::solids
