// The passes of the step that concern deformable blocks (docs/theory/zones.md).
#include <algorithm>

#include "contact/parameters.h"
#include "dynamics/step.h"

namespace wythe::dynamics {
namespace {

constexpr double kXi[2] = {-1.0, 1.0}, kHalf[2] = {0.5, 0.5};

ZoneArrays zone_arrays(const Solids& m, Workspace& w, const State& s) {
  return {
      .corner = {m.corner[0].data(), m.corner[1].data(), m.corner[2].data(), m.corner[3].data()},
      .ux = s.node_ux.data(),
      .uy = s.node_uy.data(),
      .low_force = w.zone_force.data(),
      .high_force = w.zone_force.data() + 4 * static_cast<std::size_t>(m.n_zone)};
}

// History of the contacts follows that of the joints.
JointArrays contact_joints(const Model& m, Workspace& w, State& s) {
  const auto first = static_cast<std::size_t>(m.n_point());
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
  return v;
}

EdgeArrays edge_arrays(const Model& m, Workspace& w, State& s) {
  const Solids& solids = m.solids;
  return {.joint = contact_joints(m, w, s),
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

double sum_of(const double (&lanes)[kGroup]) {
  double sum = 0;
  for (const double lane : lanes) sum += lane;
  return sum;
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

// Forces of zones and contacts on node i, in the order of its lists.
void sum_on_node(const Solids& m, Workspace& w, std::size_t i) {
  double x = 0, y = 0;
  const auto add = [&](const std::vector<std::int32_t>& begin,
                       const std::vector<std::int32_t>& list, const double* force) {
    for (auto e = begin[i]; e < begin[i + 1]; ++e) {
      const double* at = force + list[static_cast<std::size_t>(e)];
      x += at[0];
      y += at[1];
    }
  };
  add(m.zone_begin, m.zone_entry, w.zone_force.data());
  add(m.contact_begin, m.contact_entry, w.contact_edge_force.data());
  w.node_total_x[i] = x;
  w.node_total_y[i] = y;
}

}  // namespace

void Stepper::zone_pass(const State& state) {
  const Solids& m = model_.solids;
  const ZoneArrays arrays = zone_arrays(m, work_, state);
  for_each_chunk(static_cast<int>(work_.zone_chunks.size()), [&](int c) {
    const JointChunk& chunk = work_.zone_chunks[static_cast<std::size_t>(c)];
    const ZoneShape& shape =
        m.shapes[static_cast<std::size_t>(m.zone_shape[static_cast<std::size_t>(chunk.begin)])];
    run_chunk(chunk, kernels_, [&](const Kernels& kernels, std::size_t begin, std::size_t end) {
      kernels.zones(arrays, shape, begin, end);
    });
  });
}

void Stepper::zone_contact_pass(State& state) {
  const Solids& m = model_.solids;
  if (m.n_contact == 0) return;
  const EdgeArrays arrays = edge_arrays(model_, work_, state);
  for_each_chunk(static_cast<int>(work_.contact_chunks.size()), [&](int c) {
    const JointChunk& chunk = work_.contact_chunks[static_cast<std::size_t>(c)];
    const auto material =
        static_cast<std::size_t>(m.contact_material[static_cast<std::size_t>(chunk.begin)]);
    JointLanes lanes;
    run_chunk(chunk, kernels_, [&](const Kernels& kernels, std::size_t begin, std::size_t end) {
      kernels.edges(arrays, model_.materials[material], work_.law[material], begin, end, lanes);
    });
    ChunkEnergy& energy = work_.contact_energy[static_cast<std::size_t>(c)];
    energy.friction = sum_of(lanes.friction);
    energy.fracture = sum_of(lanes.fracture);
    energy.crushing = sum_of(lanes.crushing);
  });
}

// In the contacts' order, after the joints: a few dozen rows.
void Stepper::gather_zone_contacts() {
  const Solids& m = model_.solids;
  for (std::size_t c = 0; c < m.contact_block.size(); ++c) {
    if (m.contact_block[c] == model_.n_block) continue;
    const auto i = static_cast<std::size_t>(m.contact_block[c]);
    const double* row = work_.contact_block_force.data() + 4 * c;
    work_.contact_x[i] += row[0];
    work_.contact_y[i] += row[1];
    work_.contact_m[i] += row[2];
  }
}

void Stepper::node_pass(State& s, const Controls& controls) {
  const Solids& m = model_.solids;
  const NodeArrays arrays = node_arrays(m, work_, s);
  const MoveControls move{controls.dt, controls.damping, controls.mass_scaling, s.gravity_x,
                          s.gravity_y};
  for_each_chunk(work_.node_chunks, [&](int c) {
    const JointChunk chunk{c * kChunk, std::min((c + 1) * kChunk, m.n_node), false};
    for (auto i = chunk.begin; i < chunk.end; ++i)
      sum_on_node(m, work_, static_cast<std::size_t>(i));
    BlockLanes lanes;
    run_chunk(chunk, kernels_, [&](const Kernels& kernels, std::size_t begin, std::size_t end) {
      kernels.nodes(arrays, move, begin, end, lanes);
    });
    work_.node_energy[static_cast<std::size_t>(c)].loads = sum_of(lanes.loads);
    work_.node_energy[static_cast<std::size_t>(c)].damping = sum_of(lanes.damping);
  });
}

}  // namespace wythe::dynamics
