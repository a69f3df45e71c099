#include "model/step_bound.h"

#include <fmt/core.h>

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <numeric>
#include <vector>

namespace wythe {
namespace {

// Stiffness that joint j's points give to a block whose face centre is at `arm`, in (ux, uy, theta).
Eigen::Matrix3d own_stiffness(const Model& m, std::size_t j, double arm_x, double arm_y) {
  const JointMaterial& material = m.materials[static_cast<std::size_t>(m.joint_material[j])];
  const double tx = m.tangent_x[j], ty = m.tangent_y[j];
  Eigen::Matrix3d k = Eigen::Matrix3d::Zero();
  for (std::size_t p = 0; p < m.point_xi.size(); ++p) {
    const double rx = arm_x + m.point_xi[p] * m.half_x[j];
    const double ry = arm_y + m.point_xi[p] * m.half_y[j];
    const double area = m.area[j] * m.point_weight[p];
    const Eigen::Vector3d n(-ty, tx, rx * tx + ry * ty);
    const Eigen::Vector3d t(tx, ty, rx * ty - ry * tx);
    k += area * (material.normal_stiffness * n * n.transpose() +
                 material.shear_stiffness * t * t.transpose());
  }
  return k;
}

// Highest eigenvalue of the block's own stiffness over its inertia: omega^2 [1/s^2].
double own_bound(const Model& m, std::size_t i) {
  Eigen::Matrix3d k = Eigen::Matrix3d::Zero();
  for (auto e = m.block_begin[i]; e < m.block_begin[i + 1]; ++e) {
    const auto entry = m.block_entry[static_cast<std::size_t>(e)];
    const auto j = static_cast<std::size_t>(entry >> 1);
    const bool is_b = (entry & 1) != 0;
    const double share = static_cast<int>(j) < m.n_pair ? 2.0 : 1.0;
    k += share * own_stiffness(m, j, is_b ? m.arm_b_x[j] : m.arm_a_x[j],
                               is_b ? m.arm_b_y[j] : m.arm_a_y[j]);
  }
  const double im = 1 / std::sqrt(m.mass[i]), ii = 1 / std::sqrt(m.inertia[i]);
  const Eigen::Vector3d scale(im, im, ii);
  const Eigen::Matrix3d scaled = scale.asDiagonal() * k * scale.asDiagonal();
  return Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(scaled, Eigen::EigenvaluesOnly)
      .eigenvalues()
      .maxCoeff();
}

// Blocks that are not masonry and would rule the step get the inertia that brings their bound down
// to the masonry's; weights stay. Returns the mass added [kg].
double raise_light_inertia(Model& m, std::vector<double>& bound, int& raised) {
  double masonry = 0, added = 0;
  for (std::size_t i = 0; i < bound.size(); ++i)
    if (m.anatomy.block_role[i] == BlockRole::kMasonry) masonry = std::max(masonry, bound[i]);
  for (std::size_t i = 0; i < bound.size() && masonry > 0; ++i) {
    if (!(bound[i] > masonry)) continue;
    const double factor = bound[i] / masonry;
    added += (factor - 1) * m.mass[i];
    m.mass[i] *= factor;
    m.inertia[i] *= factor;
    bound[i] = masonry;
    ++raised;
  }
  return added;
}

}  // namespace

void bound_step(Model& m) {
  std::vector<double> bound;
  for (std::size_t i = 0; i < static_cast<std::size_t>(m.n_block); ++i)
    bound.push_back(own_bound(m, i));
  if (m.solve.raise_light_inertia) {
    int raised = 0;
    const double added = raise_light_inertia(m, bound, raised);
    const double all = std::accumulate(m.mass.begin(), m.mass.end(), 0.0);
    if (raised > 0)
      m.anatomy.notes.push_back(fmt::format(
          "inertia (not weight) of {} light block{} raised to the masonry's stable step: +{:.1f} % "
          "of the wall's mass",
          raised, raised == 1 ? "" : "s", 100 * added / (all - added)));
  }
  const auto greatest = std::max_element(bound.begin(), bound.end());
  m.stiffest_block = static_cast<BlockId>(greatest - bound.begin());
  m.omega_max = std::sqrt(*greatest);
}

}  // namespace wythe
