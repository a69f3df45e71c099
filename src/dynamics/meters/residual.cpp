// Sums the elastic energy over the points of a state. The ledger compares it and kinetic
// energy with the works that the steps added up (docs/theory/integration.md, "Energy
// ledger"). Velocities stand half a step before displacements, so the two energies belong to
// different times. Where no work was done, the gap ratio is 0. A gap that is NaN stays NaN.
#include "dynamics/meters/residual.h"

#include <algorithm>
#include <cmath>

#include "core/elementary.h"
#include "core/rotation.h"
#include "dynamics/passes/sums.h"
#include "reading/free_contacts.h"
#include "reading/zones.h"

namespace wythe::dynamics {

namespace {

// Recoverable energy of a point per area [J/m^2].
double recoverable(const JointMaterial& m, const PointReading& point) {
  const double sigma = point.normal_stress, tau = point.shear_stress;
  // secant: recoverable along the line to the origin; elastic unloading: recoverable along kn
  const bool secant = sigma > 0 && m.unloading == Unloading::kSecant;
  const double normal = secant ? 0.5 * sigma * (point.opening + point.crushed)
                               : 0.5 * sigma * sigma / m.normal_stiffness;
  return normal + 0.5 * tau * tau / m.shear_stiffness;
}

double kinetic_in_space(const Model& m, const State& s) {
  double energy = 0;
  for (std::size_t i = 0; i < s.vx.size(); ++i) {
    const Quaternion<double> q{s.qw[i], {s.qx[i], s.qy[i], s.qz[i]}};
    const Vector<double> l = turned_back(q, Vector<double>{s.lx[i], s.ly[i], s.lz[i]});
    const auto about = [&](const Vec3& axis, double inertia) {
      const double along = l.x * axis.x + l.y * axis.y + l.z * axis.z;
      return 0.5 * along * along / inertia;
    };
    const Space& w = m.space;
    energy += 0.5 * m.mass[i] * (s.vx[i] * s.vx[i] + s.vy[i] * s.vy[i] + s.vz[i] * s.vz[i]) +
              about(w.axis_1[i], w.inertia[i].x) + about(w.axis_2[i], w.inertia[i].y) +
              about(w.axis_3[i], w.inertia[i].z);
  }
  for (std::size_t i = 0; i < s.node_vz.size(); ++i)
    energy +=
        0.5 * m.space.solids.node_mass[i] *
        (s.node_vx[i] * s.node_vx[i] + s.node_vy[i] * s.node_vy[i] + s.node_vz[i] * s.node_vz[i]);
  return energy;
}

// Kinetic energy at the half step, without mass scaling [J].
double kinetic_energy(const Model& m, const State& s) {
  double energy = 0;
  if (!s.lx.empty()) return kinetic_in_space(m, s);
  for (std::size_t i = 0; i < s.vx.size(); ++i)
    energy += kinetic_of(m.mass[i], m.inertia[i], s.vx[i], s.vy[i], s.omega[i]);
  for (std::size_t i = 0; i < s.node_vx.size(); ++i)
    energy += kinetic_of(m.solids.node_mass[i], 0, s.node_vx[i], s.node_vy[i], 0);
  return energy;
}

}  // namespace

double elastic_energy(const Model& model, const State& state) {
  const std::vector<PointReading> points = read_points(model, state);
  double energy = 0;
  for (JointId joint = 0; joint < joint_count(model); ++joint) {
    const JointShape shape = joint_shape(model, joint);
    const JointMaterial& law = model.materials[shape.material];
    const PointRange range = points_of(model, joint);
    for (PointId p = range.begin; p < range.end; ++p) {
      const PointReading& point = points[p];
      energy += shape.area * point.share * recoverable(law, point);
    }
  }
  for (const LinkReading& link : read_links(model, state))
    energy += 0.5 * link.force * link.force / link.stiffness;
  for (const FrameReading& section : read_frames(model, state)) energy += section.stored;
  for (const LayerReading& node : read_layers(model, state)) energy += node.stored;
  return energy + reading::strain_energy(model, state) + reading::free_energy(model, state);
}

EnergyLedger energy_ledger(const Model& model, const State& s, double mass_scaling) {
  EnergyLedger e;
  e.loads = s.energy.work_loads;
  e.drive = s.energy.work_drive;
  e.kinetic = kinetic_energy(model, s) * mass_scaling;
  e.elastic = elastic_energy(model, s);
  e.friction = s.energy.dissipated_friction;
  e.fracture = s.energy.dissipated_fracture;
  e.crushing = s.energy.dissipated_crushing;
  e.damping = -s.energy.work_damping;
  e.hand_over = s.energy.lost_in_hand_over;
  e.gap = e.loads + e.drive - e.kinetic - e.elastic - e.friction - e.fracture - e.crushing -
          e.damping - e.hand_over;
  const double scale = std::fabs(e.loads) + std::fabs(e.drive) + e.elastic;
  const bool nothing_happened = scale == 0 && std::isfinite(e.gap);
  e.gap_ratio = nothing_happened ? 0.0 : std::fabs(e.gap) / scale;  // NaN stays NaN
  return e;
}

double top_displacement(const Model& model, const State& state) {
  double moved = 0;
  const double top = *std::max_element(model.centroid_y.begin(), model.centroid_y.end());
  for (std::size_t i = 0; i < state.ux.size(); ++i)
    if (model.centroid_y[i] > top - 0.01 * model.anatomy.height)
      moved = std::max(moved, state.uz.empty() ? std::fabs(state.ux[i])
                                               : elementary::hypot(state.ux[i], state.uz[i]));
  return moved;
}

}  // namespace wythe::dynamics
