// The passes of the step that concern deformable blocks (docs/theory/zones.md).
#include <algorithm>

#include "dynamics/lane_step.h"
#include "dynamics/step.h"
#include "dynamics/step_arrays.h"

namespace wythe::dynamics {
namespace {

constexpr double kXi[2] = {-1.0, 1.0}, kHalf[2] = {0.5, 0.5};

ZoneArrays zone_arrays(const Solids& m, Workspace& w, const State& s, int lanes) {
  return {
      .corner = {m.corner[0].data(), m.corner[1].data(), m.corner[2].data(), m.corner[3].data()},
      .ux = s.node_ux.data(),
      .uy = s.node_uy.data(),
      .low_force = w.zone_force.data(),
      .high_force = w.zone_force.data() + 4 * static_cast<std::size_t>(m.n_zone * lanes)};
}

// History of the contacts follows that of the joints.
JointArrays contact_joints(const Model& m, Workspace& w, State& s, int lanes) {
  const auto first = static_cast<std::size_t>(m.n_point() * lanes);
  JointArrays v{};
  v.area = m.solids.contact_area.data();
  v.xi = kXi;
  v.weight = kHalf;
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

EdgeArrays edge_arrays(const Model& m, Workspace& w, State& s, int lanes) {
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

// A chunk's whole groups go through the packs, what is left over through the scalar kernel.
template <class Run>
void run_chunk(const JointChunk& chunk, const Kernels& kernels, const Run& run) {
  const auto begin = static_cast<std::size_t>(chunk.begin),
             end = static_cast<std::size_t>(chunk.end);
  const std::size_t grouped = end - (end - begin) % kGroup;
  run(kernels, begin, grouped);
  run(scalar_kernels(), grouped, end);
}

NodeArrays node_arrays(const Solids& m, Workspace& w, State& s) {
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

// Forces of zones and contacts on node i of all walls, in the order of its lists.
void sum_on_node(const Solids& m, Workspace& w, std::size_t i, int lanes) {
  const auto walls = static_cast<std::size_t>(lanes);
  double* x = w.node_total_x.data() + i * walls;
  double* y = w.node_total_y.data() + i * walls;
  for (std::size_t k = 0; k < walls; ++k) x[k] = y[k] = 0;
  const auto add = [&](const std::vector<std::int32_t>& begin,
                       const std::vector<std::int32_t>& list, const double* force) {
    for (auto e = begin[i]; e < begin[i + 1]; ++e) {
      const double* at =
          force + static_cast<std::size_t>(list[static_cast<std::size_t>(e)]) * walls;
      for (std::size_t k = 0; k < walls; ++k) {
        x[k] += at[k];
        y[k] += at[walls + k];
      }
    }
  };
  add(m.zone_begin, m.zone_entry, w.zone_force.data());
  add(m.contact_begin, m.contact_entry, w.contact_edge_force.data());
}

JointChunk node_chunk(const Solids& m, int c) {
  return {c * kChunk, std::min((c + 1) * kChunk, m.n_node), false};
}

const ZoneShape& shape_of(const Solids& m, const JointChunk& chunk) {
  return m.shapes[static_cast<std::size_t>(m.zone_shape[static_cast<std::size_t>(chunk.begin)])];
}

std::size_t material_of(const Solids& m, const JointChunk& chunk) {
  return static_cast<std::size_t>(m.contact_material[static_cast<std::size_t>(chunk.begin)]);
}

ZoneArrays shifted(ZoneArrays v, int lane) {
  v.ux += lane;
  v.uy += lane;
  v.low_force += lane;
  v.high_force += lane;
  return v;
}

EdgeArrays shifted(EdgeArrays v, int lane) {
  JointArrays& j = v.joint;
  j.pose += lane;
  j.busy += lane;
  for (double** array :
       {&j.kappa, &j.crush, &j.plastic_slip, &j.slip, &j.shear_damage, &j.tension_set})
    *array += lane;
  v.ux += lane;
  v.uy += lane;
  v.block_force += lane;
  v.edge_force += lane;
  return v;
}

NodeArrays shifted(NodeArrays v, int lane) {
  v.mass += lane;
  v.heavy_mass += lane;
  for (double** array : {&v.total_x, &v.total_y, &v.ux, &v.uy, &v.vx, &v.vy}) *array += lane;
  return v;
}

}  // namespace

// --- one wall ------------------------------------------------------------------------------------

void Stepper::zone_pass(const State& state) {
  const Solids& m = model_.solids;
  const ZoneArrays arrays = zone_arrays(m, work_, state, 1);
  for_each_chunk(static_cast<int>(work_.zone_chunks.size()), [&](int c) {
    const JointChunk& chunk = work_.zone_chunks[static_cast<std::size_t>(c)];
    run_chunk(chunk, kernels_, [&](const Kernels& kernels, std::size_t begin, std::size_t end) {
      kernels.zones(arrays, shape_of(m, chunk), begin, end);
    });
  });
}

void Stepper::zone_contact_pass(State& state) {
  const Solids& m = model_.solids;
  if (m.n_contact == 0) return;
  const EdgeArrays arrays = edge_arrays(model_, work_, state, 1);
  for_each_chunk(static_cast<int>(work_.contact_chunks.size()), [&](int c) {
    const JointChunk& chunk = work_.contact_chunks[static_cast<std::size_t>(c)];
    const std::size_t material = material_of(m, chunk);
    double friction[kGroup] = {}, fracture[kGroup] = {}, crushing[kGroup] = {};
    run_chunk(chunk, kernels_, [&](const Kernels& kernels, std::size_t begin, std::size_t end) {
      kernels.edges(arrays, model_.materials[material], &work_.law[material], begin, end,
                    {friction, fracture, crushing});
    });
    ChunkEnergy& energy = work_.contact_energy[static_cast<std::size_t>(c)];
    energy.friction = sum_of_groups(friction, 1);
    energy.fracture = sum_of_groups(fracture, 1);
    energy.crushing = sum_of_groups(crushing, 1);
  });
}

void Stepper::node_pass(State& s, const Controls& controls) {
  const Solids& m = model_.solids;
  const NodeArrays arrays = node_arrays(m, work_, s);
  const MoveControls move{&controls.dt, &controls.damping, &controls.mass_scaling, &s.gravity_x,
                          &s.gravity_y};
  for_each_chunk(work_.node_chunks, [&](int c) {
    const JointChunk chunk = node_chunk(m, c);
    for (auto i = chunk.begin; i < chunk.end; ++i)
      sum_on_node(m, work_, static_cast<std::size_t>(i), 1);
    double loads[kGroup] = {}, damping[kGroup] = {};
    run_chunk(chunk, kernels_, [&](const Kernels& kernels, std::size_t begin, std::size_t end) {
      kernels.nodes(arrays, move, begin, end, {loads, damping});
    });
    work_.node_energy[static_cast<std::size_t>(c)].loads = sum_of_groups(loads, 1);
    work_.node_energy[static_cast<std::size_t>(c)].damping = sum_of_groups(damping, 1);
  });
}

// A few dozen rows.
void gather_zone_contacts(const Model& model, Workspace& work, int lanes) {
  const Solids& m = model.solids;
  const auto walls = static_cast<std::size_t>(lanes);
  for (std::size_t c = 0; c < m.contact_block.size(); ++c) {
    if (m.contact_block[c] == model.n_block) continue;
    const std::size_t i = static_cast<std::size_t>(m.contact_block[c]) * walls;
    const double* row = work.contact_block_force.data() + 4 * c * walls;
    for (std::size_t k = 0; k < walls; ++k) {
      work.contact_x[i + k] += row[k];
      work.contact_y[i + k] += row[walls + k];
      work.contact_m[i + k] += row[2 * walls + k];
    }
  }
}

// --- walls side by side --------------------------------------------------------------------------

void LaneStepper::zone_pass() {
  const ZoneArrays arrays = zone_arrays(model_.solids, work_, all_, lanes_);
  for (const JointChunk& chunk : work_.zone_chunks)
    for (int lane = 0; lane < lanes_; lane += kernels_.width)
      kernels_.wall_zones(shifted(arrays, lane), lanes_, shape_of(model_.solids, chunk),
                          static_cast<std::size_t>(chunk.begin),
                          static_cast<std::size_t>(chunk.end));
}

void LaneStepper::zone_contact_pass() {
  const EdgeArrays arrays = edge_arrays(model_, work_, all_, lanes_);
  for (std::size_t c = 0; c < work_.contact_chunks.size(); ++c) {
    const JointChunk& chunk = work_.contact_chunks[c];
    const std::size_t material = material_of(model_.solids, chunk);
    sum_joints(c, work_.contact_energy, [&](int lane, const JointEnergy& energy) {
      kernels_.wall_edges(shifted(arrays, lane), lanes_, model_.materials[material],
                          &work_.law[material * at(lanes_) + at(lane)],
                          static_cast<std::size_t>(chunk.begin),
                          static_cast<std::size_t>(chunk.end), energy);
    });
  }
}

void LaneStepper::node_pass() {
  NodeArrays arrays = node_arrays(model_.solids, work_, all_);
  arrays.mass = node_mass_.data();
  arrays.heavy_mass = node_heavy_mass_.data();
  for (int c = 0; c < work_.node_chunks; ++c) {
    const JointChunk chunk = node_chunk(model_.solids, c);
    for (auto i = chunk.begin; i < chunk.end; ++i)
      sum_on_node(model_.solids, work_, static_cast<std::size_t>(i), lanes_);
    sum_blocks(at(c), work_.node_energy, [&](int lane, const BlockEnergy& energy) {
      kernels_.wall_nodes(shifted(arrays, lane), lanes_, move_controls(lane),
                          static_cast<std::size_t>(chunk.begin),
                          static_cast<std::size_t>(chunk.end), energy);
    });
  }
}

}  // namespace wythe::dynamics
