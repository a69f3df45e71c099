#include "scenes/zones.h"

#include <Eigen/Sparse>
#include <Eigen/SparseCholesky>
#include <stdexcept>

#include "model/plane/step_bound.h"
#include "scenes/scenes.h"
#include "solids/elasticity.h"
#include "solids/zone.h"

namespace wythe::scenes {
namespace {

solids::ZoneVectors<double> of_zone(const Solids& s, const NodeVectors& u, std::size_t zone) {
  solids::ZoneVectors<double> v{};
  for (std::size_t k = 0; k < 4; ++k) {
    v.x[k] = u.x[s.corner[k][zone]];
    v.y[k] = u.y[s.corner[k][zone]];
  }
  return v;
}

const ZoneShape& shape_of(const Solids& s, std::size_t zone) {
  return s.shapes[s.zone_shape[zone]];
}

}  // namespace

JointMaterial elastic_body(double youngs_modulus, double poisson_ratio, double density) {
  JointMaterial m;
  m.density = density;
  m.youngs_modulus = youngs_modulus;
  m.shear_modulus = youngs_modulus / (2 * (1 + poisson_ratio));
  return m;
}

JointMaterial timber_body() {
  JointMaterial m;
  m.density = 500;
  m.youngs_modulus = 10e9;
  m.youngs_modulus_across = 0.4e9;
  m.shear_modulus = 0.6e9;
  m.poisson_ratio = 0.4;
  return m;
}

solids::ZoneMaterial zone_material(const JointMaterial& body, double thickness, Plane plane) {
  return {solids::elasticity_of(body, plane), thickness, body.density};
}

Model free_solids(Solids solids) {
  Model model;
  model.solids = std::move(solids);
  solids::join_nodes(model.solids);
  model.block_begin = {0};
  bound_step(model);
  return model;
}

Model free_grid(const solids::Grid& grid, ZoneKind kind, const JointMaterial& body,
                double thickness, Plane plane) {
  Solids s;
  solids::add_grid(grid, kind, zone_material(body, thickness, plane), s);
  return free_solids(std::move(s));
}

NodeVectors field(const Solids& s, const Field& ux, const Field& uy) {
  NodeVectors u(s);
  for (std::size_t i = 0; i < u.x.size(); ++i) {
    u.x[i] = ux(s.node_x[i], s.node_y[i]);
    u.y[i] = uy(s.node_x[i], s.node_y[i]);
  }
  return u;
}

NodeVectors forces_of_zones(const Solids& s, const NodeVectors& u) {
  NodeVectors sum(s);
  for (std::size_t z = 0; z < s.zone_shape.size(); ++z) {
    const auto f = solids::zone_force(shape_of(s, z), of_zone(s, u, z));
    for (std::size_t k = 0; k < 4; ++k) {
      sum.x[s.corner[k][z]] += f.x[k];
      sum.y[s.corner[k][z]] += f.y[k];
    }
  }
  return sum;
}

double energy_of_zones(const Solids& s, const NodeVectors& u) {
  double energy = 0;
  for (std::size_t z = 0; z < s.zone_shape.size(); ++z)
    energy += solids::zone_energy(shape_of(s, z), of_zone(s, u, z));
  return energy;
}

NodeVectors solved(const Solids& s, const NodeVectors& load) {
  std::vector<Eigen::Triplet<double>> entries;
  const auto is_free = [&](int dof) {
    const auto i = static_cast<std::size_t>(dof / 2);
    return (dof % 2 == 0 ? s.node_free_x[i] : s.node_free_y[i]) > 0;
  };
  for (std::size_t z = 0; z < s.zone_shape.size(); ++z)
    for (int i = 0; i < 8; ++i)
      for (int j = 0; j < 8; ++j) {
        const int a = 2 * s.corner[i / 2][z] + i % 2;
        const int b = 2 * s.corner[j / 2][z] + j % 2;
        if (is_free(a) && is_free(b)) entries.emplace_back(a, b, shape_of(s, z).stiffness[i][j]);
      }
  Eigen::VectorXd f(2 * s.n_node);
  for (int dof = 0; dof < 2 * s.n_node; ++dof) {
    const auto i = static_cast<std::size_t>(dof / 2);
    f(dof) = is_free(dof) ? (dof % 2 == 0 ? load.x[i] : load.y[i]) : 0.0;
    if (!is_free(dof)) entries.emplace_back(dof, dof, 1.0);
  }
  Eigen::SparseMatrix<double> k(2 * s.n_node, 2 * s.n_node);
  k.setFromTriplets(entries.begin(), entries.end());
  const Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>> factors(k);
  if (factors.info() != Eigen::Success) throw std::runtime_error("the zones are not held");
  const Eigen::VectorXd answer = factors.solve(f);
  NodeVectors u(s);
  for (int i = 0; i < s.n_node; ++i) {
    u.x[i] = answer(2 * i);
    u.y[i] = answer(2 * i + 1);
  }
  return u;
}

double work(const NodeVectors& force, const NodeVectors& u) {
  double sum = 0;
  for (std::size_t i = 0; i < u.x.size(); ++i) sum += force.x[i] * u.x[i] + force.y[i] * u.y[i];
  return sum;
}

ModelSpec lintel_wall(LintelModel kind, double until) {
  ModelSpec spec = small_wall(until);
  spec.material["timber"] = elastic_body(0.3e9, 0.2, 500);
  LintelSpec& lintel = spec.wall.opening[0].lintel;
  lintel.kind = lintel.material = "timber";
  lintel.depth = 0.11;
  lintel.bearing = 0.155;
  lintel.model = kind;
  return spec;
}

}  // namespace wythe::scenes
