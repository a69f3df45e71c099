// The arrays of model, workspace and state as the kernels take them; shared by the step of one wall
// (step.cpp) and that of walls side by side (lane_step.cpp).
#pragma once

#include "dynamics/kernels.h"
#include "dynamics/wall_view.h"
#include "dynamics/workspace.h"

namespace wythe::dynamics {

[[nodiscard]] inline JointArrays joint_arrays(const Model& m, Workspace& w, State& s) {
  return {.a = m.joint_a.data(),
          .b = m.joint_b.data(),
          .arm_a_x = m.arm_a_x.data(),
          .arm_a_y = m.arm_a_y.data(),
          .arm_b_x = m.arm_b_x.data(),
          .arm_b_y = m.arm_b_y.data(),
          .tangent_x = m.tangent_x.data(),
          .tangent_y = m.tangent_y.data(),
          .half_length = w.half_length.data(),
          .area = m.area.data(),
          .xi = m.point_xi.data(),
          .weight = m.point_weight.data(),
          .n_face_point = m.n_face_point,
          .pose = w.pose.data(),
          .kappa = s.kappa.data(),
          .crush = s.crush.data(),
          .plastic_slip = s.plastic_slip.data(),
          .slip = s.slip.data(),
          .shear_damage = s.shear_damage.data(),
          .tension_set = s.tension_set.data(),
          .busy = w.busy.data(),
          .force = w.force.data()};
}

[[nodiscard]] inline BlockArrays block_arrays(const Model& m, Workspace& w, State& s) {
  return {.mass = m.mass.data(),
          .heavy_mass = m.heavy_mass.data(),
          .inertia = m.inertia.data(),
          .turn_freedom = m.turn_freedom.data(),
          .is_free = w.is_free.data(),
          .contact_x = w.contact_x.data(),
          .contact_y = w.contact_y.data(),
          .contact_m = w.contact_m.data(),
          .load_x = w.load_x.data(),
          .load_y = w.load_y.data(),
          .load_m = w.load_m.data(),
          .total_x = w.total_x.data(),
          .total_y = w.total_y.data(),
          .total_m = w.total_m.data(),
          .ux = s.ux.data(),
          .uy = s.uy.data(),
          .theta = s.theta.data(),
          .vx = s.vx.data(),
          .vy = s.vy.data(),
          .omega = s.omega.data(),
          .pose = w.pose.data()};
}

// The kGroup sums of a run, `stride` apart, in order.
[[nodiscard]] inline double sum_of_groups(const double* group, std::ptrdiff_t stride) {
  double sum = 0;
  for (int k = 0; k < kGroup; ++k) sum += group[k * stride];
  return sum;
}

[[nodiscard]] inline GatherArrays gather_arrays(const Model& m, Workspace& w) {
  return {m.block_begin.data(), w.block_middle.data(), m.block_entry.data(), w.force.data(),
          w.contact_x.data(),   w.contact_y.data(),    w.contact_m.data()};
}

// Wall `lane` of `lanes` walls side by side.
[[nodiscard]] inline WallView wall_view(Workspace& w, State& s, int lanes, int lane) {
  const auto at = [&](std::vector<double>& array) { return Strided{array.data() + lane, lanes}; };
  return {.ux = at(s.ux),
          .uy = at(s.uy),
          .theta = at(s.theta),
          .vx = at(s.vx),
          .vy = at(s.vy),
          .omega = at(s.omega),
          .contact_x = at(w.contact_x),
          .contact_y = at(w.contact_y),
          .contact_m = at(w.contact_m),
          .load_x = at(w.load_x),
          .load_y = at(w.load_y),
          .load_m = at(w.load_m),
          .total_x = at(w.total_x),
          .total_y = at(w.total_y),
          .total_m = at(w.total_m),
          .is_free = at(w.is_free),
          .pose = at(w.pose),
          .force = at(w.force),
          .node_ux = at(s.node_ux),
          .node_uy = at(s.node_uy),
          .node_vx = at(s.node_vx),
          .node_vy = at(s.node_vy),
          .node_total_x = at(w.node_total_x),
          .node_total_y = at(w.node_total_y),
          .contact_block_force = at(w.contact_block_force)};
}

struct Range {
  std::size_t begin, end;
  // where the whole groups of kGroup end
  [[nodiscard]] std::size_t grouped() const { return end - (end - begin) % kGroup; }
};
[[nodiscard]] inline Range block_range(const Model& m, int chunk) {
  const auto begin = static_cast<std::size_t>(chunk) * kChunk;
  return {begin, std::min(begin + kChunk, static_cast<std::size_t>(m.n_block))};
}

// Adds the zone contacts' forces to their rigid blocks, in the contacts' order, after the joints.
void gather_zone_contacts(const Model& model, Workspace& work, int lanes);

// What the chunks of wall `lane` have done, in order, into its ledger.
inline void add_energies(const Workspace& w, int lanes, int lane, State& s) {
  const auto stride = static_cast<std::size_t>(lanes), first = static_cast<std::size_t>(lane);
  for (const auto* energies : {&w.joint_energy, &w.contact_energy})
    for (std::size_t c = first; c < energies->size(); c += stride) {
      s.dissipated_friction += (*energies)[c].friction;
      s.dissipated_fracture += (*energies)[c].fracture;
      s.dissipated_crushing += (*energies)[c].crushing;
    }
  for (const auto* energies : {&w.block_energy, &w.node_energy})
    for (std::size_t c = first; c < energies->size(); c += stride) {
      s.work_loads += (*energies)[c].loads;
      s.work_damping += (*energies)[c].damping;
    }
}

}  // namespace wythe::dynamics
