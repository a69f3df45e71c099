// Stiffness, masses and highest frequency of a hexahedron (hexahedron.h).
#include <Eigen/Dense>

#include <cmath>

#include "solids/elasticity.h"
#include "solids/hexahedron.h"

namespace wythe::solids {
namespace {

using Matrix3 = Eigen::Matrix3d;
using Matrix24 = Eigen::Matrix<double, 24, 24>;
using Shares = Eigen::Matrix<double, 8, 3>;  // derivatives of shape functions, one row a corner

constexpr double kNatural[8][3] = {{-1, -1, -1}, {1, -1, -1}, {1, 1, -1}, {-1, 1, -1},
                                   {-1, -1, 1},  {1, -1, 1},  {1, 1, 1},  {-1, 1, 1}};

// Derivatives of the shape functions along the natural coordinates.
Shares slopes_at(const double (&x)[3]) {
  Shares slope;
  for (int i = 0; i < 8; ++i)
    for (int c = 0; c < 3; ++c) {
      const int d = (c + 1) % 3, e = (c + 2) % 3;
      slope(i, c) =
          0.125 * kNatural[i][c] * (1 + kNatural[i][d] * x[d]) * (1 + kNatural[i][e] * x[e]);
    }
  return slope;
}

double share_at(int i, const double (&x)[3]) {
  return 0.125 * (1 + kNatural[i][0] * x[0]) * (1 + kNatural[i][1] * x[1]) *
         (1 + kNatural[i][2] * x[2]);
}

Shares places_of(const HexahedronCorners& corners) {
  Shares place;
  for (int i = 0; i < 8; ++i) {
    const Vec3& p = corners[i];
    place.row(i) << p.x, p.y, p.z;
  }
  return place;
}

// dx_r / dxi_c
Matrix3 jacobian_at(const Shares& place, const double (&x)[3]) {
  return place.transpose() * slopes_at(x);
}

// Strains xx, yy, zz, xy, yz, zx per displacement: three columns for each row of derivatives.
template <int n>
Eigen::Matrix<double, 6, 3 * n> strains_of(const Eigen::Matrix<double, n, 3>& slope) {
  Eigen::Matrix<double, 6, 3 * n> b = Eigen::Matrix<double, 6, 3 * n>::Zero();
  for (int i = 0; i < n; ++i) {
    const double gx = slope(i, 0), gy = slope(i, 1), gz = slope(i, 2);
    b(0, 3 * i) = gx;
    b(1, 3 * i + 1) = gy;
    b(2, 3 * i + 2) = gz;
    b(3, 3 * i) = gy, b(3, 3 * i + 1) = gx;
    b(4, 3 * i + 1) = gz, b(4, 3 * i + 2) = gy;
    b(5, 3 * i) = gz, b(5, 3 * i + 2) = gx;
  }
  return b;
}

// visit(natural coordinates, weight) at two Gauss points along each direction.
template <class Visit>
void each_point(const Visit& visit) {
  const double g = 1 / std::sqrt(3.0);
  for (const auto& corner : kNatural) {
    const double x[3] = {g * corner[0], g * corner[1], g * corner[2]};
    visit(x);
  }
}

Matrix24 stiffness_of(const Shares& place, const Elasticity6& elasticity) {
  Eigen::Matrix<double, 6, 6> d;
  for (int i = 0; i < 6; ++i)
    for (int j = 0; j < 6; ++j) d(i, j) = elasticity[i][j];
  const double middle[3] = {0, 0, 0};
  const Matrix3 j0 = jacobian_at(place, middle);
  const Matrix3 inverse_0 = j0.inverse();
  const double det_0 = j0.determinant();
  Matrix24 k = Matrix24::Zero();
  Eigen::Matrix<double, 9, 24> mixed = Eigen::Matrix<double, 9, 24>::Zero();
  Eigen::Matrix<double, 9, 9> inner = Eigen::Matrix<double, 9, 9>::Zero();
  each_point([&](const double(&x)[3]) {
    const Matrix3 j = jacobian_at(place, x);
    const double det = j.determinant();
    const Shares slope = slopes_at(x) * j.inverse();
    Matrix3 bubble = Matrix3::Zero();  // derivatives of 1 - x^2, 1 - y^2, 1 - z^2
    for (int c = 0; c < 3; ++c) bubble(c, c) = -2 * x[c];
    const Matrix3 bent = det_0 / det * bubble * inverse_0;
    const Eigen::Matrix<double, 6, 24> b = strains_of<8>(slope);
    const Eigen::Matrix<double, 6, 9> g = strains_of<3>(bent);
    k += det * b.transpose() * d * b;
    mixed += det * g.transpose() * d * b;
    inner += det * g.transpose() * d * g;
  });
  k -= mixed.transpose() * inner.ldlt().solve(mixed);
  return 0.5 * (k + k.transpose());
}

}  // namespace

Elasticity6 elasticity_in_space(const JointMaterial& body, Vec3 grain) {
  const bool is_orthotropic = !std::isnan(body.youngs_modulus_across);
  const double e1 = body.youngs_modulus, nu = poisson_ratio_of(body);
  const double e2 = is_orthotropic ? body.youngs_modulus_across : e1;
  const double across = e2 / (2 * (1 + nu));
  const double along = is_orthotropic ? body.shear_modulus : across;
  Eigen::Matrix3d s;  // compliances along the grain and in both directions across
  s << 1 / e1, -nu / e1, -nu / e1, -nu / e1, 1 / e2, -nu / e2, -nu / e1, -nu / e2, 1 / e2;
  Eigen::Matrix<double, 6, 6> own = Eigen::Matrix<double, 6, 6>::Zero();
  own.topLeftCorner<3, 3>() = s.inverse();
  own(3, 3) = own(5, 5) = along;
  own(4, 4) = across;
  Eigen::Matrix<double, 6, 6> d = own;
  if (is_orthotropic) {
    // axes of the body: the grain, and two across it
    const Eigen::Vector3d a = Eigen::Vector3d(grain.x, grain.y, grain.z).normalized();
    const Eigen::Vector3d b = a.unitOrthogonal(), c = a.cross(b);
    Matrix3 q;
    q.row(0) = a, q.row(1) = b, q.row(2) = c;
    constexpr int kPair[6][2] = {{0, 0}, {1, 1}, {2, 2}, {0, 1}, {1, 2}, {2, 0}};
    Eigen::Matrix<double, 6, 6> turn;  // from strains in the wall's axes to strains in the body's
    for (int i = 0; i < 6; ++i)
      for (int j = 0; j < 6; ++j) {
        const auto [m, n] = kPair[i];
        const auto [r, t] = kPair[j];
        // half of a shear strain stands at each of its two places in the tensor
        double sum = q(m, r) * q(n, t);
        if (r != t) sum = 0.5 * (sum + q(m, t) * q(n, r));
        turn(i, j) = i < 3 ? sum : 2 * sum;
      }
    d = turn.transpose() * own * turn;
  }
  Elasticity6 out{};
  for (std::size_t i = 0; i < 6; ++i)
    for (std::size_t j = 0; j < 6; ++j)
      out[i][j] = 0.5 * (d(static_cast<int>(i), static_cast<int>(j)) +
                         d(static_cast<int>(j), static_cast<int>(i)));
  return out;
}

double least_jacobian(const HexahedronCorners& corners) {
  const Shares place = places_of(corners);
  double least = 1e300, sum = 0;
  for (const auto& corner : kNatural) {
    const double det = jacobian_at(place, corner).determinant();
    least = std::fmin(least, det);
    sum += det;
  }
  return least / (std::fabs(sum) / 8);
}

HexahedronShape make_hexahedron(const HexahedronCorners& corners, const Elasticity6& elasticity,
                                double density) {
  HexahedronShape shape;
  Shares place = places_of(corners);
  const Eigen::RowVector3d mean = place.colwise().mean();
  place.rowwise() -= mean;
  Shares gradient = Shares::Zero();
  each_point([&](const double(&x)[3]) {
    const Matrix3 j = jacobian_at(place, x);
    const double det = j.determinant();
    shape.volume += det;
    gradient += det * slopes_at(x) * j.inverse();
    for (int i = 0; i < 8; ++i) shape.share[i] += det * share_at(i, x);
  });
  for (int i = 0; i < 8; ++i) {
    shape.share[i] /= shape.volume;
    for (int c = 0; c < 3; ++c) {
      shape.place[i][c] = place(i, c);
      shape.gradient[i][c] = gradient(i, c) / shape.volume;
    }
  }
  shape.mass = density * shape.volume;
  for (std::size_t i = 0; i < 6; ++i)
    for (std::size_t j = 0; j < 6; ++j) shape.elasticity[i][j] = elasticity[i][j];
  const Matrix24 k = stiffness_of(place, elasticity);
  Eigen::Vector<double, 24> scale;
  for (int i = 0; i < 24; ++i) {
    scale(i) = 1 / std::sqrt(shape.share[i / 3] * shape.mass);
    for (int j = 0; j < 24; ++j) shape.stiffness[i][j] = k(i, j);
  }
  const Eigen::MatrixXd scaled = scale.asDiagonal() * k * scale.asDiagonal();
  shape.omega_squared =
      Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(scaled, Eigen::EigenvaluesOnly)
          .eigenvalues()
          .maxCoeff();
  return shape;
}

std::array<double, 3> principal_of(const std::array<double, 6>& s) {
  Matrix3 m;
  m << s[0], s[3], s[5], s[3], s[1], s[4], s[5], s[4], s[2];
  const Eigen::Vector3d values =
      Eigen::SelfAdjointEigenSolver<Matrix3>(m, Eigen::EigenvaluesOnly).eigenvalues();
  return {values(2), values(1), values(0)};
}

}  // namespace wythe::solids
