#include "dynamics/residual.h"

#include <algorithm>
#include <cmath>

namespace wythe::dynamics {

double unbalance_ratio(const Model& model, const Workspace& work) {
  double unbalanced = 0, contact = 0;
  for (std::size_t i = 0; i < work.total_x.size(); ++i)
    if (work.is_free[i] > 0) unbalanced += std::fabs(work.total_x[i]) + std::fabs(work.total_y[i]);
  for (std::size_t j = 0; j < static_cast<std::size_t>(model.n_joint); ++j) {
    const double sides = static_cast<int>(j) < model.n_pair ? 2.0 : 1.0;
    contact += sides * (std::fabs(work.force[4 * j]) + std::fabs(work.force[4 * j + 1]));
  }
  if (contact > 0) return unbalanced / contact;
  return unbalanced > 0 ? 1.0 : 0.0;
}

double kinetic_energy(const Model& model, const State& s, double mass_scaling) {
  double energy = 0;
  for (std::size_t i = 0; i < s.vx.size(); ++i)
    energy += 0.5 * model.mass[i] * (s.vx[i] * s.vx[i] + s.vy[i] * s.vy[i]) +
              0.5 * model.inertia[i] * s.omega[i] * s.omega[i];
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

double base_shear(const Model& model, const Workspace& work, double px, double py) {
  double sum = 0;  // the force on side a, the ground, resists with the opposite sign
  for (auto j = static_cast<std::size_t>(model.n_pair); j < static_cast<std::size_t>(model.n_joint);
       ++j)
    sum += work.force[4 * j] * px + work.force[4 * j + 1] * py;
  return sum;
}

EnergyLedger energy_ledger(const Model& model, const State& s, double mass_scaling) {
  EnergyLedger e;
  e.loads = s.work_loads;
  e.drive = s.work_drive;
  e.kinetic = kinetic_energy(model, s, mass_scaling);
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

BlockId runaway_block(const State& s) {
  constexpr double kFast = 100.0;  // [m/s], far beyond any free fall within a wall
  for (std::size_t i = 0; i < s.vx.size(); ++i) {
    const double speed = std::fabs(s.vx[i]) + std::fabs(s.vy[i]);
    if (!(speed < kFast) || !std::isfinite(s.omega[i]) || !std::isfinite(s.theta[i]))
      return static_cast<BlockId>(i);
  }
  return -1;
}

}  // namespace wythe::dynamics
