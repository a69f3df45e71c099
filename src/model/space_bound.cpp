// The longest stable step in space: omega^2 <= 2 max lambda(M^-1 K_own), of each block the 6 x 6 stiffness of
// its own joints (once on a support), for (x - y) k (x - y) <= 2 x k x + 2 y k y (docs/theory/space.md).
#include <Eigen/Dense>

#include <cmath>

#include "model/space.h"

namespace wythe {
namespace {

using Matrix6 = Eigen::Matrix<double, 6, 6>;
using Vector6 = Eigen::Matrix<double, 6, 1>;

std::size_t at(std::int64_t i) { return static_cast<std::size_t>(i); }

Vector6 row(Vec3 direction, Vec3 arm) {
  const Vec3 turn = cross(arm, direction);
  Vector6 r;
  r << direction.x, direction.y, direction.z, turn.x, turn.y, turn.z;
  return r;
}

// Stiffness that joint j gives to a block whose centroid sees the face at `arm`.
Matrix6 own_stiffness(const Model& m, std::size_t j, Vec3 arm) {
  const JointMaterial& law = m.materials[at(m.joint_material[j])];
  const Space& s = m.space;
  const Vec3 t1 = s.tangent[j], n = s.normal[j], t2 = cross(n, t1);
  Matrix6 sum = Matrix6::Zero();
  for (auto p = at(s.point_begin[j]); p < at(s.point_begin[j + 1]); ++p) {
    const Vec3 to = arm + s.point_r1[p] * t1 + s.point_r2[p] * t2;
    const double area = m.area[j] * s.point_share[p];
    const auto spring = [&](Vec3 direction, double stiffness) {
      const Vector6 r = row(direction, to);
      sum += area * stiffness * r * r.transpose();
    };
    spring(n, law.normal_stiffness);
    spring(t1, law.shear_stiffness);
    spring(t2, law.shear_stiffness);
  }
  return sum;
}

double own_bound(const Model& m, std::size_t i) {
  const Space& s = m.space;
  Matrix6 k = Matrix6::Zero();
  for (auto e = m.block_begin[i]; e < m.block_begin[i + 1]; ++e) {
    const auto entry = m.block_entry[at(e)];
    const auto j = at(entry >> 1);
    const double share = static_cast<int>(j) < m.n_pair ? 2.0 : 1.0;
    k += share * own_stiffness(m, j, (entry & 1) != 0 ? s.arm_b[j] : s.arm_a[j]);
  }
  // to the block's principal axes, each scaled by the root of its inertia
  Matrix6 turn = Matrix6::Zero();
  const Vec3 axes[3] = {s.axis_1[i], s.axis_2[i], s.axis_3[i]};
  const double inertia[3] = {s.inertia[i].x, s.inertia[i].y, s.inertia[i].z};
  for (int a = 0; a < 3; ++a) {
    turn(a, a) = 1 / std::sqrt(m.mass[i]);
    const double scale = 1 / std::sqrt(inertia[a]);
    turn(3, 3 + a) = scale * axes[a].x;
    turn(4, 3 + a) = scale * axes[a].y;
    turn(5, 3 + a) = scale * axes[a].z;
  }
  const Matrix6 scaled = turn.transpose() * k * turn;
  return Eigen::SelfAdjointEigenSolver<Matrix6>(scaled, Eigen::EigenvaluesOnly)
      .eigenvalues()
      .maxCoeff();
}

}  // namespace

void bound_space_step(Model& m) {
  double most = 0;
  for (int i = 0; i < m.n_block; ++i) {
    const double bound = own_bound(m, at(i));
    if (bound > most) most = bound, m.stiffest_block = i;
  }
  m.omega_max = std::sqrt(most);
}

}  // namespace wythe
