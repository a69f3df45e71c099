// The arrays of model, workspace and state as the kernels take them; shared by the step of one wall
// (step.cpp) and that of walls side by side (lane_step.cpp).
#pragma once

#include <array>

#include "dynamics/kernels.h"
#include "dynamics/wall_view.h"
#include "dynamics/workspace.h"
#include "dynamics/zones.h"
#include "model/fields.h"

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

[[nodiscard]] inline ZoneArrays zone_arrays(const Solids& m, Workspace& w, const State& s,
                                            int lanes) {
  return {
      .corner = {m.corner[0].data(), m.corner[1].data(), m.corner[2].data(), m.corner[3].data()},
      .ux = s.node_ux.data(),
      .uy = s.node_uy.data(),
      .low_force = w.zone_force.data(),
      .high_force = w.zone_force.data() + 4 * static_cast<std::size_t>(m.n_zone * lanes)};
}

inline constexpr double kEdgeXi[2] = {-1.0, 1.0}, kEdgeWeight[2] = {0.5, 0.5};

// History of the contacts follows that of the joints.
[[nodiscard]] inline JointArrays contact_joints(const Model& m, Workspace& w, State& s, int lanes) {
  const auto first = static_cast<std::size_t>(m.n_point() * lanes);
  JointArrays v{};
  v.area = m.solids.contact_area.data();
  v.xi = kEdgeXi;
  v.weight = kEdgeWeight;
  v.n_face_point = 2;
  v.pose = w.pose.data();
  v.kappa = s.kappa.data() + first;
  v.crush = s.crush.data() + first;
  v.plastic_slip = s.plastic_slip.data() + first;
  v.slip = s.slip.data() + first;
  v.shear_damage = s.shear_damage.data() + first;
  v.tension_set = s.tension_set.data() + first;
  v.busy = w.busy.data() + static_cast<std::size_t>(m.n_joint * lanes);
  return v;
}

[[nodiscard]] inline EdgeArrays edge_arrays(const Model& m, Workspace& w, State& s, int lanes) {
  const Solids& solids = m.solids;
  return {.joint = contact_joints(m, w, s, lanes),
          .block = solids.contact_block.data(),
          .p = solids.contact_p.data(),
          .q = solids.contact_q.data(),
          .share_0 = solids.share_0.data(),
          .share_1 = solids.share_1.data(),
          .arm_0_x = solids.arm_0_x.data(),
          .arm_0_y = solids.arm_0_y.data(),
          .arm_1_x = solids.arm_1_x.data(),
          .arm_1_y = solids.arm_1_y.data(),
          .tangent_x = solids.contact_tangent_x.data(),
          .tangent_y = solids.contact_tangent_y.data(),
          .ux = s.node_ux.data(),
          .uy = s.node_uy.data(),
          .block_force = w.contact_block_force.data(),
          .edge_force = w.contact_edge_force.data()};
}

[[nodiscard]] inline NodeArrays node_arrays(const Solids& m, Workspace& w, State& s) {
  return {.mass = m.node_mass.data(),
          .heavy_mass = m.node_heavy_mass.data(),
          .free_x = m.node_free_x.data(),
          .free_y = m.node_free_y.data(),
          .total_x = w.node_total_x.data(),
          .total_y = w.node_total_y.data(),
          .ux = s.node_ux.data(),
          .uy = s.node_uy.data(),
          .vx = s.node_vx.data(),
          .vy = s.node_vy.data()};
}

[[nodiscard]] inline NodeSums node_sums(const Solids& m, Workspace& w) {
  return {.zone_begin = m.zone_begin.data(),
          .zone_entry = m.zone_entry.data(),
          .contact_begin = m.contact_begin.data(),
          .contact_entry = m.contact_entry.data(),
          .zone_force = w.zone_force.data(),
          .edge_force = w.contact_edge_force.data(),
          .total_x = w.node_total_x.data(),
          .total_y = w.node_total_y.data()};
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
