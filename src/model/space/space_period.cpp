// First period of a wall of rigid blocks in space along a direction, as in ../period.cpp: Rayleigh's quotient of the static
// displacement under gravity along it, with all joints closed.
#include <Eigen/SparseCholesky>
#include <Eigen/SparseCore>
#include <cmath>
#include <vector>

#include "model/space/space.h"

namespace wythe {
namespace {

using Sparse = Eigen::SparseMatrix<double>;

// Coefficients of one component of a point's jump for the six motions of each block; a support has none.
struct Row {
  std::int32_t block[2] = {-1, -1};
  double share[2][6] = {};
  void add(const Model& m, int side, BlockId b, double sign, Vec3 direction, Vec3 arm) {
    if (b >= m.n_block || b == kGroundBlock) return;
    const Vec3 turn = cross(arm, direction);
    const double shares[6] = {direction.x, direction.y, direction.z, turn.x, turn.y, turn.z};
    block[side] = b;
    for (int k = 0; k < 6; ++k) share[side][k] = sign * shares[k];
  }
};

Sparse stiffness_of(const Model& m) {
  std::vector<Eigen::Triplet<double>> entries;
  const auto spring = [&](const Row& row, double stiffness) {
    for (int i = 0; i < 12; ++i)
      for (int j = 0; j < 12; ++j)
        if (row.block[i / 6] >= 0 && row.block[j / 6] >= 0)
          entries.emplace_back(6 * row.block[i / 6] + i % 6, 6 * row.block[j / 6] + j % 6,
                               stiffness * row.share[i / 6][i % 6] * row.share[j / 6][j % 6]);
  };
  const Space& s = m.space;
  for (std::size_t j = 0; j < static_cast<std::size_t>(m.n_joint); ++j) {
    const JointMaterial& law = m.materials[m.joint_material[j]];
    const Vec3 n = s.normal[j], t1 = s.tangent[j], t2 = cross(n, t1);
    for (std::size_t p = s.point_begin[j]; p < static_cast<std::size_t>(s.point_begin[j + 1]);
         ++p) {
      const Vec3 to = s.point_r1[p] * t1 + s.point_r2[p] * t2;
      const double area = m.area[j] * s.point_share[p];
      for (const auto& [along, stiffness] : {std::pair(n, law.normal_stiffness),
                                             {t1, law.shear_stiffness},
                                             {t2, law.shear_stiffness}}) {
        Row row;
        row.add(m, 0, m.joint_b[j], 1, along, s.arm_b[j] + to);
        row.add(m, 1, m.joint_a[j], -1, along, s.arm_a[j] + to);
        spring(row, area * stiffness);
      }
    }
  }
  Sparse sum(6 * m.n_block, 6 * m.n_block);
  sum.setFromTriplets(entries.begin(), entries.end());
  return sum;
}

}  // namespace

double first_period_in_space(const Model& m, Vec3 along) {
  constexpr int kMostBlocks = 5000;  // beyond this, factorisation takes seconds and gigabytes
  if (m.n_block > kMostBlocks || m.links.n > 0 || m.frames.n > 0 || m.space.solids.n_node > 0)
    return kUnset;
  const Eigen::SimplicialLDLT<Sparse> solver(stiffness_of(m));
  if (solver.info() != Eigen::Success) return kUnset;
  Eigen::VectorXd force = Eigen::VectorXd::Zero(6 * m.n_block);
  for (int i = 0; i < m.n_block; ++i) {
    const double mass = m.mass[i];
    force[6 * i] = mass * along.x, force[6 * i + 1] = mass * along.y;
    force[6 * i + 2] = mass * along.z;
  }
  const Eigen::VectorXd u = solver.solve(force);
  double moving = 0;  // u.M u
  for (int i = 0; i < m.n_block; ++i) {
    const Vec3 shift{u[6 * i], u[6 * i + 1], u[6 * i + 2]};
    const Vec3 turn{u[6 * i + 3], u[6 * i + 4], u[6 * i + 5]};
    const Space& s = m.space;
    const Vec3 own = s.inertia[i];
    const double about_1 = dot(turn, s.axis_1[i]), about_2 = dot(turn, s.axis_2[i]),
                 about_3 = dot(turn, s.axis_3[i]);
    moving += m.mass[i] * dot(shift, shift) + own.x * about_1 * about_1 +
              own.y * about_2 * about_2 + own.z * about_3 * about_3;
  }
  const double omega_squared = u.dot(force) / moving;
  return omega_squared > 0 && std::isfinite(omega_squared) ? 2 * M_PI / std::sqrt(omega_squared)
                                                           : kUnset;
}

}  // namespace wythe
