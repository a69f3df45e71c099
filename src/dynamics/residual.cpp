#include "dynamics/residual.h"

#include <algorithm>
#include <cmath>

#include "dynamics/zone_state.h"

namespace wythe::dynamics {

double unbalance_ratio(const Model& model, const WallView& wall) {
  double unbalanced = 0, contact = 0;
  for (std::size_t i = 0; i < static_cast<std::size_t>(model.n_block); ++i)
    if (wall.is_free[i] > 0) unbalanced += std::fabs(wall.total_x[i]) + std::fabs(wall.total_y[i]);
  for (std::size_t i = 0; i < static_cast<std::size_t>(model.solids.n_node); ++i)
    unbalanced += std::fabs(wall.node_total_x[i]) + std::fabs(wall.node_total_y[i]);
  for (std::size_t j = 0; j < static_cast<std::size_t>(model.n_joint); ++j) {
    const double sides = static_cast<int>(j) < model.n_pair ? 2.0 : 1.0;
    contact += sides * (std::fabs(wall.force[4 * j]) + std::fabs(wall.force[4 * j + 1]));
  }
  for (std::size_t c = 0; c < model.solids.contact_block.size(); ++c) {
    const double sides = model.solids.contact_block[c] == model.n_block ? 1.0 : 2.0;
    contact += sides * (std::fabs(wall.contact_block_force[4 * c]) +
                        std::fabs(wall.contact_block_force[4 * c + 1]));
  }
  if (contact > 0) return unbalanced / contact;
  return unbalanced > 0 ? 1.0 : 0.0;
}

double kinetic_energy(const Model& model, const WallView& wall, double mass_scaling) {
  double energy = 0;
  for (std::size_t i = 0; i < static_cast<std::size_t>(model.n_block); ++i) {
    const double vx = wall.vx[i], vy = wall.vy[i], omega = wall.omega[i];
    energy += 0.5 * model.mass[i] * (vx * vx + vy * vy) + 0.5 * model.inertia[i] * omega * omega;
  }
  for (std::size_t i = 0; i < static_cast<std::size_t>(model.solids.n_node); ++i) {
    const double vx = wall.node_vx[i], vy = wall.node_vy[i];
    energy += 0.5 * model.solids.node_mass[i] * (vx * vx + vy * vy);
  }
  return energy * mass_scaling;
}

namespace {

// Recoverable energy of a point per area [J/m^2].
double recoverable(const JointMaterial& m, const PointStress& point, double crush) {
  const double sigma = point.normal_stress, tau = point.shear_stress;
  // secant: recoverable along the line to the origin; elastic unloading: along kn
  const bool secant = sigma > 0 && m.unloading == Unloading::kSecant;
  const double normal =
      secant ? 0.5 * sigma * (point.opening + crush) : 0.5 * sigma * sigma / m.normal_stiffness;
  return normal + 0.5 * tau * tau / m.shear_stiffness;
}

}  // namespace

double elastic_energy(const Model& model, const State& state) {
  const std::vector<PointStress> points = point_stresses(model, state);
  double energy = 0;
  for (std::size_t p = 0; p < points.size(); ++p) {
    const std::size_t j = p / static_cast<std::size_t>(model.n_face_point);
    const std::size_t k = p % static_cast<std::size_t>(model.n_face_point);
    const auto& m = model.materials[static_cast<std::size_t>(model.joint_material[j])];
    energy += model.area[j] * model.point_weight[k] * recoverable(m, points[p], state.crush[p]);
  }
  const Solids& solids = model.solids;
  const std::vector<PointStress> contacts = contact_stresses(model, state);
  for (std::size_t i = 0; i < contacts.size(); ++i) {
    const auto& m = model.materials[static_cast<std::size_t>(solids.contact_material[i / 2])];
    const double crush = state.crush[static_cast<std::size_t>(model.n_point()) + i];
    energy += 0.5 * solids.contact_area[i / 2] * recoverable(m, contacts[i], crush);
  }
  return energy + strain_energy(model, state);
}

double base_shear(const Model& model, const WallView& wall, double px, double py) {
  double sum = 0;  // the force on side a, the ground, resists with the opposite sign
  for (auto j = static_cast<std::size_t>(model.n_pair); j < static_cast<std::size_t>(model.n_joint);
       ++j)
    sum += wall.force[4 * j] * px + wall.force[4 * j + 1] * py;
  for (std::size_t c = 0; c < model.solids.contact_block.size(); ++c)
    if (model.solids.contact_block[c] == model.n_block)
      sum += wall.contact_block_force[4 * c] * px + wall.contact_block_force[4 * c + 1] * py;
  return sum;
}

EnergyLedger energy_ledger(const Model& model, const State& s, double mass_scaling) {
  State moving = s;  // a view is of arrays that may be written
  WallView wall;
  wall.vx = {moving.vx.data()};
  wall.vy = {moving.vy.data()};
  wall.omega = {moving.omega.data()};
  wall.node_vx = {moving.node_vx.data()};
  wall.node_vy = {moving.node_vy.data()};
  EnergyLedger e;
  e.loads = s.work_loads;
  e.drive = s.work_drive;
  e.kinetic = kinetic_energy(model, wall, mass_scaling);
  e.elastic = elastic_energy(model, s);
  e.friction = s.dissipated_friction;
  e.fracture = s.dissipated_fracture;
  e.crushing = s.dissipated_crushing;
  e.damping = -s.work_damping;
  e.gap =
      e.loads + e.drive - e.kinetic - e.elastic - e.friction - e.fracture - e.crushing - e.damping;
  const double scale = std::fabs(e.loads) + std::fabs(e.drive) + e.elastic;
  e.gap_ratio = scale > 0 ? std::fabs(e.gap) / scale : 0.0;
  return e;
}

BlockId runaway_block(const Model& model, const WallView& wall) {
  constexpr double kFast = 100.0;  // [m/s], far beyond any free fall within a wall
  for (std::size_t i = 0; i < static_cast<std::size_t>(model.n_block); ++i) {
    const double speed = std::fabs(wall.vx[i]) + std::fabs(wall.vy[i]);
    if (!(speed < kFast) || !std::isfinite(wall.omega[i]) || !std::isfinite(wall.theta[i]))
      return static_cast<BlockId>(i);
  }
  for (std::size_t i = 0; i < static_cast<std::size_t>(model.solids.n_node); ++i)
    if (!(std::fabs(wall.node_vx[i]) + std::fabs(wall.node_vy[i]) < kFast))
      return model.n_block + static_cast<BlockId>(i);
  return -1;
}

Furthest furthest_block(const Model& model, const WallView& wall) {
  Furthest f;
  const auto look = [&](const Strided& x, const Strided& y, int count, BlockId first) {
    for (std::size_t i = 0; i < static_cast<std::size_t>(count); ++i) {
      const double ux = x[i], uy = y[i];
      const double moved = ux * ux + uy * uy;
      if (moved > f.distance) f = {moved, first + static_cast<BlockId>(i)};
    }
  };
  look(wall.ux, wall.uy, model.n_block, 0);
  look(wall.node_ux, wall.node_uy, model.solids.n_node, model.n_block);
  f.distance = std::sqrt(f.distance);
  return f;
}

}  // namespace wythe::dynamics
