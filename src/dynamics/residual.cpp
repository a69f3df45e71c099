#include "dynamics/residual.h"

#include <algorithm>
#include <cmath>

#include "dynamics/zone_state.h"

namespace wythe::dynamics {

double unbalance_ratio(const Model& model, const Workspace& work) {
  double unbalanced = 0, contact = 0;
  for (std::size_t i = 0; i < work.total_x.size(); ++i)
    if (work.is_free[i] > 0) unbalanced += std::fabs(work.total_x[i]) + std::fabs(work.total_y[i]);
  for (std::size_t j = 0; j < static_cast<std::size_t>(model.n_joint); ++j) {
    const double sides = static_cast<int>(j) < model.n_pair ? 2.0 : 1.0;
    contact += sides * (std::fabs(work.force[4 * j]) + std::fabs(work.force[4 * j + 1]));
  }
  for (std::size_t i = 0; i < work.node_total_x.size(); ++i)
    unbalanced += std::fabs(work.node_total_x[i]) + std::fabs(work.node_total_y[i]);
  for (std::size_t c = 0; c < model.solids.contact_block.size(); ++c) {
    const double sides = model.solids.contact_block[c] == model.n_block ? 1.0 : 2.0;
    contact += sides * (std::fabs(work.contact_block_force[4 * c]) +
                        std::fabs(work.contact_block_force[4 * c + 1]));
  }
  if (contact > 0) return unbalanced / contact;
  return unbalanced > 0 ? 1.0 : 0.0;
}

double kinetic_energy(const Model& model, const State& s, double mass_scaling) {
  double energy = 0;
  for (std::size_t i = 0; i < s.vx.size(); ++i)
    energy += 0.5 * model.mass[i] * (s.vx[i] * s.vx[i] + s.vy[i] * s.vy[i]) +
              0.5 * model.inertia[i] * s.omega[i] * s.omega[i];
  for (std::size_t i = 0; i < s.node_vx.size(); ++i)
    energy += 0.5 * model.solids.node_mass[i] *
              (s.node_vx[i] * s.node_vx[i] + s.node_vy[i] * s.node_vy[i]);
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

double base_shear(const Model& model, const Workspace& work, double px, double py) {
  double sum = 0;  // the force on side a, the ground, resists with the opposite sign
  for (auto j = static_cast<std::size_t>(model.n_pair); j < static_cast<std::size_t>(model.n_joint);
       ++j)
    sum += work.force[4 * j] * px + work.force[4 * j + 1] * py;
  for (std::size_t c = 0; c < model.solids.contact_block.size(); ++c)
    if (model.solids.contact_block[c] == model.n_block)
      sum += work.contact_block_force[4 * c] * px + work.contact_block_force[4 * c + 1] * py;
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
  for (std::size_t i = 0; i < s.node_vx.size(); ++i)
    if (!(std::fabs(s.node_vx[i]) + std::fabs(s.node_vy[i]) < kFast))
      return static_cast<BlockId>(s.vx.size() + i);
  return -1;
}

}  // namespace wythe::dynamics
