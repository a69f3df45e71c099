// Motion and forces of a hexahedron in a step (hexahedron.h). Only + - x / are used, so that bits are the same everywhere.
#include "solids/hexahedron.h"

#include <algorithm>

namespace wythe::solids {
namespace {

using Matrix = double[3][3];

Vector<double> times(const Matrix& m, const Vector<double>& v) {
  return {m[0][0] * v.x + m[0][1] * v.y + m[0][2] * v.z,
          m[1][0] * v.x + m[1][1] * v.y + m[1][2] * v.z,
          m[2][0] * v.x + m[2][1] * v.y + m[2][2] * v.z};
}
Vector<double> times_transposed(const Matrix& m, const Vector<double>& v) {
  return {m[0][0] * v.x + m[1][0] * v.y + m[2][0] * v.z,
          m[0][1] * v.x + m[1][1] * v.y + m[2][1] * v.z,
          m[0][2] * v.x + m[1][2] * v.y + m[2][2] * v.z};
}

// Cofactors of m; returns the determinant. m' cofactors = determinant times the unit matrix.
double cofactors_of(const Matrix& m, Matrix& c) {
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j) {
      const int a = (i + 1) % 3, b = (i + 2) % 3, p = (j + 1) % 3, q = (j + 2) % 3;
      c[i][j] = m[a][p] * m[b][q] - m[a][q] * m[b][p];
    }
  return m[0][0] * c[0][0] + m[0][1] * c[0][1] + m[0][2] * c[0][2];
}

// Rotation R of f = R U by Newton's iteration r = (r + r^-T)/2, which squares the error each time. At rest, where f is
// 1, R is exactly 1.
void turn_of(const Matrix& f, Matrix& r) {
  constexpr int kMost = 30;
  constexpr double kEnough = 1e-9;  // the next correction would be half its square
  std::copy_n(&f[0][0], 9, &r[0][0]);
  for (int k = 0; k < kMost; ++k) {
    Matrix c;
    const double inverse = 1.0 / cofactors_of(r, c);
    double change = 0;
    for (int i = 0; i < 3; ++i)
      for (int j = 0; j < 3; ++j) {
        const double next = 0.5 * (r[i][j] + inverse * c[i][j]);
        const double step = next - r[i][j];
        change = std::max(change, step < 0 ? -step : step);
        r[i][j] = next;
      }
    if (!(change > kEnough)) return;
  }
}

Vector<double> place_of(const HexahedronShape& shape, int i) {
  return {shape.place[i][0], shape.place[i][1], shape.place[i][2]};
}

HexahedronVectors corner_forces(const HexahedronShape& shape, const HexahedronVectors& d) {
  double flat[24], f[24];
  for (std::size_t i = 0; i < 8; ++i)
    flat[3 * i] = d[i].x, flat[3 * i + 1] = d[i].y, flat[3 * i + 2] = d[i].z;
  std::fill_n(f, 24, 0.0);
  // column by column (K is symmetric): sums in one order, several at once
  for (int j = 0; j < 24; ++j)
    for (int i = 0; i < 24; ++i) f[i] += shape.stiffness[j][i] * flat[j];
  HexahedronVectors force;
  for (std::size_t i = 0; i < 8; ++i) force[i] = {f[3 * i], f[3 * i + 1], f[3 * i + 2]};
  return force;
}

// The solution v of (tr u - u) v = m, u symmetric.
Vector<double> undo_spin(const Matrix& u, const Vector<double>& m) {
  const double trace = u[0][0] + u[1][1] + u[2][2];
  Matrix s, c;
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j) s[i][j] = (i == j ? trace : 0.0) - u[i][j];
  const double inverse = 1.0 / cofactors_of(s, c);
  return inverse * times_transposed(c, m);
}

}  // namespace

HexahedronMotion hexahedron_motion(const HexahedronShape& shape, const HexahedronVectors& u) {
  HexahedronMotion m;
  Vector<double> mean{0, 0, 0};
  for (const Vector<double>& v : u) mean = mean + v;
  mean = 0.125 * mean;
  Matrix f = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  for (int i = 0; i < 8; ++i) {
    const Vector<double> v = u[i] - mean;
    const double row[3] = {v.x, v.y, v.z};
    for (int a = 0; a < 3; ++a)
      for (int b = 0; b < 3; ++b) f[a][b] += row[a] * shape.gradient[i][b];
  }
  turn_of(f, m.turn);
  for (int a = 0; a < 3; ++a)
    for (int b = a; b < 3; ++b) {
      double ab = 0, ba = 0;
      for (int k = 0; k < 3; ++k) {
        ab += m.turn[k][a] * f[k][b];
        ba += m.turn[k][b] * f[k][a];
      }
      m.stretch[a][b] = m.stretch[b][a] = 0.5 * (ab + ba);
    }
  Matrix drop;
  for (int a = 0; a < 3; ++a)
    for (int b = 0; b < 3; ++b) drop[a][b] = m.turn[a][b] - (a == b ? 1.0 : 0.0);
  for (int i = 0; i < 8; ++i) {
    m.d[i] = times_transposed(m.turn, u[i] - mean) + times_transposed(drop, place_of(shape, i));
  }
  return m;
}

HexahedronVectors hexahedron_force(const HexahedronShape& shape, const HexahedronVectors& u) {
  const HexahedronMotion m = hexahedron_motion(shape, u);
  const HexahedronVectors f = corner_forces(shape, m.d);
  Vector<double> moment{0, 0, 0};
  for (int i = 0; i < 8; ++i) {
    moment = moment + cross(place_of(shape, i) + m.d[i], f[i]);
  }
  const Vector<double> spin = undo_spin(m.stretch, moment);
  HexahedronVectors out;
  for (int i = 0; i < 8; ++i) {
    const Vector<double> g{shape.gradient[i][0], shape.gradient[i][1], shape.gradient[i][2]};
    out[i] = times(m.turn, cross(spin, g) - f[i]);
  }
  return out;
}

double hexahedron_energy(const HexahedronShape& shape, const HexahedronVectors& u) {
  const HexahedronMotion m = hexahedron_motion(shape, u);
  const HexahedronVectors f = corner_forces(shape, m.d);
  double twice = 0;
  for (std::size_t k = 0; k < 8; ++k) twice += dot(m.d[k], f[k]);
  return 0.5 * twice;
}

std::array<double, 6> hexahedron_stress(const HexahedronShape& shape, const HexahedronVectors& u) {
  const HexahedronMotion m = hexahedron_motion(shape, u);
  double strain[6] = {};
  for (int i = 0; i < 8; ++i) {
    const Vector<double>& d = m.d[i];
    const double gx = shape.gradient[i][0], gy = shape.gradient[i][1], gz = shape.gradient[i][2];
    strain[0] += gx * d.x;
    strain[1] += gy * d.y;
    strain[2] += gz * d.z;
    strain[3] += gy * d.x + gx * d.y;
    strain[4] += gz * d.y + gy * d.z;
    strain[5] += gz * d.x + gx * d.z;
  }
  double own[6] = {};
  for (int a = 0; a < 6; ++a)
    for (int b = 0; b < 6; ++b) own[a] += shape.elasticity[a][b] * strain[b];
  const Matrix s = {{own[0], own[3], own[5]}, {own[3], own[1], own[4]}, {own[5], own[4], own[2]}};
  Matrix half, full;
  for (int a = 0; a < 3; ++a)
    for (int b = 0; b < 3; ++b) {
      half[a][b] = 0;
      for (int k = 0; k < 3; ++k) half[a][b] += m.turn[a][k] * s[k][b];
    }
  for (int a = 0; a < 3; ++a)
    for (int b = 0; b < 3; ++b) {
      full[a][b] = 0;
      for (int k = 0; k < 3; ++k) full[a][b] += half[a][k] * m.turn[b][k];
    }
  return {full[0][0], full[1][1], full[2][2], full[0][1], full[1][2], full[2][0]};
}

}  // namespace wythe::solids
