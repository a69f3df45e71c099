// The passes of the step that concern deformable blocks (docs/theory/zones.md).
#include <algorithm>

#include "dynamics/lane_step.h"
#include "dynamics/shifted.h"
#include "dynamics/step.h"
#include "dynamics/step_arrays.h"

namespace wythe::dynamics {
namespace {

// A chunk's whole groups go through the packs, what is left over through the scalar kernel.
template <class Run>
void run_chunk(const JointChunk& chunk, const Kernels& kernels, const Run& run) {
  const auto begin = static_cast<std::size_t>(chunk.begin),
             end = static_cast<std::size_t>(chunk.end);
  const std::size_t grouped = end - (end - begin) % kGroup;
  run(kernels, begin, grouped);
  run(scalar_kernels(), grouped, end);
}

void sum_on_nodes(const Solids& m, Workspace& w, const JointChunk& nodes, int lanes) {
  const NodeSums sums = node_sums(m, w);
  for (auto i = nodes.begin; i < nodes.end; ++i)
    for (int lane = 0; lane < lanes; ++lane)
      sum_on_node(sums, static_cast<std::size_t>(i), lanes, lane);
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
      kernels.edges(arrays, &work_.law[material], begin, end, {friction, fracture, crushing});
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
    sum_on_nodes(m, work_, chunk, 1);
    double loads[kGroup] = {}, damping[kGroup] = {};
    run_chunk(chunk, kernels_, [&](const Kernels& kernels, std::size_t begin, std::size_t end) {
      kernels.nodes(arrays, move, begin, end, {loads, damping});
    });
    work_.node_energy[static_cast<std::size_t>(c)].loads = sum_of_groups(loads, 1);
    work_.node_energy[static_cast<std::size_t>(c)].damping = sum_of_groups(damping, 1);
  });
}

// Adds the forces of the zone contacts to the blocks they touch; not in parallel, as there are few.
void gather_zone_contacts(const Model& model, Workspace& work, int lanes) {
  const Solids& m = model.solids;
  for (int c = 0; c < m.n_contact; ++c)
    for (int lane = 0; lane < lanes; ++lane)
      gather_contact(m.contact_block.data(), model.n_block, work.contact_block_force.data(),
                     work.contact_x.data(), work.contact_y.data(), work.contact_m.data(), c, lanes,
                     lane);
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
      kernels_.wall_edges(
          shifted(arrays, lane), lanes_, &work_.law[material * at(lanes_) + at(lane)],
          static_cast<std::size_t>(chunk.begin), static_cast<std::size_t>(chunk.end), energy);
    });
  }
}

void LaneStepper::node_pass() {
  NodeArrays arrays = node_arrays(model_.solids, work_, all_);
  arrays.mass = node_mass_.data();
  arrays.heavy_mass = node_heavy_mass_.data();
  for (int c = 0; c < work_.node_chunks; ++c) {
    const JointChunk chunk = node_chunk(model_.solids, c);
    sum_on_nodes(model_.solids, work_, chunk, lanes_);
    sum_blocks(at(c), work_.node_energy, [&](int lane, const BlockEnergy& energy) {
      kernels_.wall_nodes(shifted(arrays, lane), lanes_, move_controls(lane),
                          static_cast<std::size_t>(chunk.begin),
                          static_cast<std::size_t>(chunk.end), energy);
    });
  }
}

}  // namespace wythe::dynamics
