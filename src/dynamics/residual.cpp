#include "dynamics/residual.h"

#include <algorithm>
#include <cmath>

namespace wythe::dynamics {

double unbalance_ratio(const Model& model, const WallView& wall) {
  double unbalanced = 0, contact = 0;
  for (std::size_t i = 0; i < static_cast<std::size_t>(model.n_block); ++i)
    if (wall.is_free[i] > 0) unbalanced += std::fabs(wall.total_x[i]) + std::fabs(wall.total_y[i]);
  for (std::size_t j = 0; j < static_cast<std::size_t>(model.n_joint); ++j) {
    const double sides = static_cast<int>(j) < model.n_pair ? 2.0 : 1.0;
    contact += sides * (std::fabs(wall.force[4 * j]) + std::fabs(wall.force[4 * j + 1]));
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
  return energy * mass_scaling;
}

double elastic_energy(const Model& model, const State& state) {
  const std::vector<PointStress> points = point_stresses(model, state);
  double energy = 0;
  for (std::size_t p = 0; p < points.size(); ++p) {
    const std::size_t j = p / static_cast<std::size_t>(model.n_face_point);
    const std::size_t k = p % static_cast<std::size_t>(model.n_face_point);
    const auto& m = model.materials[static_cast<std::size_t>(model.joint_material[j])];
    const double area = model.area[j] * model.point_weight[k];
    const double sigma = points[p].normal_stress, tau = points[p].shear_stress;
    const double we = points[p].opening + state.crush[p];
    // secant: recoverable along the line to the origin; elastic unloading: along kn
    const bool secant = sigma > 0 && m.unloading == Unloading::kSecant;
    const double normal = secant ? 0.5 * sigma * we : 0.5 * sigma * sigma / m.normal_stiffness;
    energy += area * (normal + 0.5 * tau * tau / m.shear_stiffness);
  }
  return energy;
}

double base_shear(const Model& model, const WallView& wall, double px, double py) {
  double sum = 0;  // the force on side a, the ground, resists with the opposite sign
  for (auto j = static_cast<std::size_t>(model.n_pair); j < static_cast<std::size_t>(model.n_joint);
       ++j)
    sum += wall.force[4 * j] * px + wall.force[4 * j + 1] * py;
  return sum;
}

EnergyLedger energy_ledger(const Model& model, const State& s, const WallView& wall,
                           double mass_scaling) {
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
  return -1;
}

Furthest furthest_block(const Model& model, const WallView& wall) {
  Furthest f;
  for (std::size_t i = 0; i < static_cast<std::size_t>(model.n_block); ++i) {
    const double ux = wall.ux[i], uy = wall.uy[i];
    const double moved = ux * ux + uy * uy;
    if (moved > f.distance) f = {moved, static_cast<BlockId>(i)};
  }
  f.distance = std::sqrt(f.distance);
  return f;
}

}  // namespace wythe::dynamics
