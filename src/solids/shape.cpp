// Sums the stiffness of a zone over four triangles with half the thickness each, (8.1) or (8.2).
// Triangles without area are skipped: a quadrilateral with two equal corners is thus a triangle. The highest
// omega^2 is that of a single zone on its own masses, as (8.7) requires.
#include "solids/shape.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <vector>

namespace wythe::solids {
namespace {

using Matrix8 = Eigen::Matrix<double, 8, 8>;
using Strain = Eigen::Matrix<double, 3, 8>;  // strains x, y, xy per corner displacement

constexpr int kTriangle[4][3] = {{0, 1, 2}, {0, 2, 3}, {0, 1, 3}, {1, 2, 3}};

double area_of(const Corners& c, const int (&t)[3]) {
  return 0.5 * ((c.x[t[1]] - c.x[t[0]]) * (c.y[t[2]] - c.y[t[0]]) -
                (c.x[t[2]] - c.x[t[0]]) * (c.y[t[1]] - c.y[t[0]]));
}

Strain strain_of(const Corners& c, const int (&t)[3]) {
  Strain b = Strain::Zero();
  const double twice = 2 * area_of(c, t);
  for (int k = 0; k < 3; ++k) {
    const int next = t[(k + 1) % 3], last = t[(k + 2) % 3];
    const double gx = (c.y[next] - c.y[last]) / twice, gy = (c.x[last] - c.x[next]) / twice;
    b(0, 2 * t[k]) = gx;
    b(1, 2 * t[k] + 1) = gy;
    b(2, 2 * t[k]) = gy;
    b(2, 2 * t[k] + 1) = gx;
  }
  return b;
}

Matrix8 stiffness_of(const Corners& c, ZoneKind kind, const ZoneMaterial& m) {
  Eigen::Matrix3d d;
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j) d(i, j) = m.elasticity[i][j];
  std::vector<Strain> strain;
  std::vector<double> weight;  // areas of the triangles, half of each pair
  double all = 0;
  Eigen::RowVector<double, 8> mean = Eigen::RowVector<double, 8>::Zero();
  for (const auto& triangle : kTriangle) {
    const double area = 0.5 * area_of(c, triangle);
    if (area == 0) continue;  // two of the four have no area in a triangle
    strain.push_back(strain_of(c, triangle));
    weight.push_back(area);
    all += area;
    mean += area * (strain.back().row(0) + strain.back().row(1));
  }
  mean /= all;
  Matrix8 k = Matrix8::Zero();
  for (std::size_t t = 0; t < strain.size(); ++t) {
    Strain& b = strain[t];
    if (kind == ZoneKind::kMixed) {
      const Eigen::RowVector<double, 8> lift = 0.5 * (mean - b.row(0) - b.row(1));
      b.row(0) += lift;
      b.row(1) += lift;
    }
    k += m.thickness * weight[t] * b.transpose() * d * b;
  }
  return 0.5 * (k + k.transpose());
}

// Each corner gets a third of the mass of each adjacent triangle.
std::array<double, 4> mass_shares(const Corners& c) {
  std::array<double, 4> share{};
  double all = 0;
  for (const auto& triangle : kTriangle) all += area_of(c, triangle);
  for (const auto& triangle : kTriangle)
    for (const int k : triangle) share[k] += area_of(c, triangle) / 3 / all;
  return share;
}

// Highest omega^2 of a zone on its own masses; the last corner of a triangle moves with the third one.
double highest_mode(const Corners& c, Matrix8 k, std::array<double, 4> share, double mass) {
  if (c.x[2] == c.x[3] && c.y[2] == c.y[3]) {
    k.middleRows<2>(4) += k.middleRows<2>(6);
    k.middleCols<2>(4) += k.middleCols<2>(6);
    k.bottomRows<2>().setZero();
    k.rightCols<2>().setZero();
    share[2] += share[3];
  }
  Eigen::Vector<double, 8> scale;
  for (int i = 0; i < 8; ++i) scale(i) = 1 / std::sqrt(share[i / 2] * mass);
  const Matrix8 scaled = scale.asDiagonal() * k * scale.asDiagonal();
  return Eigen::SelfAdjointEigenSolver<Matrix8>(scaled, Eigen::EigenvaluesOnly)
      .eigenvalues()
      .maxCoeff();
}

}  // namespace

ZoneShape make_shape(const Corners& corners, ZoneKind kind, const ZoneMaterial& material) {
  ZoneShape shape;
  const double mx = 0.25 * (corners.x[0] + corners.x[1] + corners.x[2] + corners.x[3]);
  const double my = 0.25 * (corners.y[0] + corners.y[1] + corners.y[2] + corners.y[3]);
  shape.area = area_of(corners, kTriangle[0]) + area_of(corners, kTriangle[1]);
  shape.thickness = material.thickness;
  shape.mass = material.density * material.thickness * shape.area;
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j) shape.elasticity[i][j] = material.elasticity[i][j];
  for (int k = 0; k < 4; ++k) {
    const int next = (k + 1) % 4, last = (k + 3) % 4;
    shape.x[k] = corners.x[k] - mx;
    shape.y[k] = corners.y[k] - my;
    shape.grad_x[k] = 0.5 * (corners.y[next] - corners.y[last]) / shape.area;
    shape.grad_y[k] = 0.5 * (corners.x[last] - corners.x[next]) / shape.area;
  }
  const std::array<double, 4> share = mass_shares(corners);
  std::copy(share.begin(), share.end(), shape.share);
  const Matrix8 k = stiffness_of(corners, kind, material);
  for (int i = 0; i < 8; ++i)
    for (int j = 0; j < 8; ++j) shape.stiffness[i][j] = k(i, j);
  shape.omega_squared = highest_mode(corners, k, share, shape.mass);
  return shape;
}

}  // namespace wythe::solids
