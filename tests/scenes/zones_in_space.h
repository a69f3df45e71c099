// Deformable blocks in space for tests: a column of zones between a floor and a
// rigid cap, and the zones of any model as an independent system of equations.
#pragma once

#include <Eigen/Sparse>
#include <functional>
#include <string>
#include <vector>

#include "scenes/scenes.h"
#include "scenes/solids.h"
#include "scenes/zones.h"
#include "wythe/parts/model.h"

namespace wythe::scenes {

struct Column {
  double wide = 0.2, deep = 0.1, high = 1.0;  // along x, z, y [m]
  int zones = 10;                             // along y
  double zone_length = 0.1;                   // along x and z
  double youngs_modulus = 10e9, poisson_ratio = 0;
  double kn = 200e9, ks = 100e9;  // of the joints at both ends, elastic
  bool on_floor = true;
};

// Bodies: floor (fixed), column (zones), cap (rigid, block 0), 0.1 m high.
[[nodiscard]] inline ModelSpec column_of_zones(const Column& c) {
  std::vector<BodySpec> bodies;
  const double x = c.wide / 2, z = c.deep / 2;
  if (c.on_floor) bodies.push_back(box_body("floor", {-1, -0.2, -1}, {1, 0, 1}, true));
  bodies.push_back(box_body("column", {-x, 0, -z}, {x, c.high, z}));
  bodies.back().material = "stuff";
  bodies.back().zone.zones = c.zones;
  bodies.back().zone.length = c.zone_length;
  bodies.push_back(box_body("cap", {-x, c.high, -z}, {x, c.high + 0.1, z}));
  ModelSpec spec = in_space(std::move(bodies), elastic_joint(c.kn, c.ks), 2000);
  spec.material["stuff"] = elastic_body(c.youngs_modulus, c.poisson_ratio, 500);
  spec.solve.raise_light_inertia = false;
  return spec;
}

// Stiffness of the zones on their nodes, linear about the start; three rows for each node.
[[nodiscard]] inline Eigen::SparseMatrix<double> stiffness_of_zones(const SpaceSolids& s) {
  std::vector<Eigen::Triplet<double>> entries;
  for (std::size_t zone = 0; zone < static_cast<std::size_t>(s.n_zone); ++zone) {
    const HexahedronShape& shape = s.shapes[s.zone_shape[zone]];
    for (std::size_t i = 0; i < 24; ++i)
      for (std::size_t j = 0; j < 24; ++j)
        entries.emplace_back(3 * s.corner[8 * zone + i / 3] + static_cast<int>(i % 3),
                             3 * s.corner[8 * zone + j / 3] + static_cast<int>(j % 3),
                             shape.stiffness[i][j]);
  }
  Eigen::SparseMatrix<double> k(3 * s.n_node, 3 * s.n_node);
  k.setFromTriplets(entries.begin(), entries.end());
  return k;
}

// Displacements under `load`. `held` [3 n_node] marks prescribed ones, whose values are in `u`.
[[nodiscard]] inline Eigen::VectorXd solved_in_space(const SpaceSolids& s,
                                                     const Eigen::VectorXd& load,
                                                     const std::vector<bool>& held,
                                                     Eigen::VectorXd u) {
  Eigen::SparseMatrix<double> k = stiffness_of_zones(s);
  Eigen::VectorXd right = load - k * u;
  std::vector<Eigen::Triplet<double>> entries;
  for (int j = 0; j < k.outerSize(); ++j)
    for (Eigen::SparseMatrix<double>::InnerIterator e(k, j); e; ++e)
      if (!held[e.row()] && !held[e.col()])
        entries.emplace_back(static_cast<int>(e.row()), static_cast<int>(e.col()), e.value());
  for (int i = 0; i < k.rows(); ++i)
    if (held[i]) {
      entries.emplace_back(i, i, 1.0);
      right(i) = 0;
    }
  Eigen::SparseMatrix<double> free(k.rows(), k.cols());
  free.setFromTriplets(entries.begin(), entries.end());
  const Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>> solver(free);
  return u + solver.solve(right);
}

}  // namespace wythe::scenes
