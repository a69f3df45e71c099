#include "dynamics/step.h"

#include "contact/parameters.h"
#include "dynamics/step_arrays.h"

namespace wythe::dynamics {
namespace {

// Joints in chunks that share material and ground; the order of joints is the model's.
std::vector<JointChunk> cut_joints(const Model& m) {
  std::vector<JointChunk> chunks;
  for (JointId j = 0; j < m.n_joint; ++j) {
    const bool on_ground = j >= m.n_pair;
    const auto i = static_cast<std::size_t>(j);
    const bool fits = !chunks.empty() && chunks.back().on_ground == on_ground &&
                      j - chunks.back().begin < kChunk &&
                      m.joint_material[i] == m.joint_material[i - 1];
    if (!fits) chunks.push_back({j, j, on_ground});
    chunks.back().end = j + 1;
  }
  return chunks;
}

// Runs of at most kChunk with the same `kind`.
std::vector<JointChunk> cut_runs(const std::vector<std::int32_t>& kind) {
  std::vector<JointChunk> chunks;
  for (std::int32_t k = 0; k < static_cast<std::int32_t>(kind.size()); ++k) {
    const auto i = static_cast<std::size_t>(k);
    const bool fits = !chunks.empty() && k - chunks.back().begin < kChunk && kind[i] == kind[i - 1];
    if (!fits) chunks.push_back({k, k, false});
    chunks.back().end = k + 1;
  }
  return chunks;
}

void size_for_solids(const Solids& s, std::size_t walls, Workspace& w) {
  const auto zones = static_cast<std::size_t>(s.n_zone), nodes = static_cast<std::size_t>(s.n_node);
  const auto contacts = static_cast<std::size_t>(s.n_contact);
  w.zone_chunks = cut_runs(s.zone_shape);
  w.contact_chunks = cut_runs(s.contact_material);
  w.node_chunks = (s.n_node + kChunk - 1) / kChunk;
  w.zone_force.assign(8 * zones * walls, 0.0);
  for (auto* array : {&w.contact_block_force, &w.contact_edge_force})
    array->assign(4 * contacts * walls, 0.0);
  for (auto* array : {&w.node_total_x, &w.node_total_y}) array->assign(nodes * walls, 0.0);
  w.contact_energy.resize(w.contact_chunks.size() * walls);
  w.node_energy.resize(static_cast<std::size_t>(w.node_chunks) * walls);
}

// Entries of a block's list where it is side a come first: where they end.
std::vector<std::int32_t> middle_of_entries(const Model& m) {
  std::vector<std::int32_t> middle;
  for (std::size_t i = 0; i < static_cast<std::size_t>(m.n_block); ++i) {
    auto e = m.block_begin[i];
    while (e < m.block_begin[i + 1] && (m.block_entry[static_cast<std::size_t>(e)] & 1) == 0) ++e;
    middle.push_back(e);
  }
  return middle;
}

}  // namespace

Workspace::Workspace(const Model& m, int lanes) {
  const auto walls = static_cast<std::size_t>(lanes);
  for (const JointMaterial& material : m.materials)
    law.insert(law.end(), walls, contact::constants_of(material));
  joint_chunks = cut_joints(m);
  block_chunks = (m.n_block + kChunk - 1) / kChunk;
  const auto nb = static_cast<std::size_t>(m.n_block), nj = static_cast<std::size_t>(m.n_joint);
  for (auto* array : {&contact_x, &contact_y, &contact_m, &load_x, &load_y, &load_m, &total_x,
                      &total_y, &total_m})
    array->assign(nb * walls, 0.0);
  pose.assign(4 * (nb + 1) * walls, 0.0);
  for (std::size_t k = 0; k < walls; ++k) pose[(4 * nb + 2) * walls + k] = 1.0;  // the ground's
  size_for_solids(m.solids, walls, *this);
  force.assign(4 * nj * walls, 0.0);
  busy.assign((nj + static_cast<std::size_t>(m.solids.n_contact)) * walls, 0);
  is_free.assign(nb * walls, 1.0);
  for (std::size_t j = 0; j < nj; ++j)
    half_length.push_back(m.half_x[j] * m.tangent_x[j] + m.half_y[j] * m.tangent_y[j]);
  block_middle = middle_of_entries(m);
  joint_energy.resize(joint_chunks.size() * walls);
  block_energy.resize(static_cast<std::size_t>(block_chunks) * walls);
}

Stepper::Stepper(const Model& model, int threads, const Kernels& kernels)
    : model_(model), work_(model), workers_(threads), kernels_(kernels) {}

void Stepper::choose_driven(const std::vector<BlockId>& blocks) {
  std::fill(work_.is_free.begin(), work_.is_free.end(), 1.0);
  for (const BlockId block : blocks) work_.is_free[static_cast<std::size_t>(block)] = 0.0;
}

WallView Stepper::view_of(State& state) { return wall_view(work_, state, 1, 0); }

DriveForce Stepper::step(State& state, const Controls& controls) {
  joint_pass(state);
  zone_pass(state);
  zone_contact_pass(state);
  gather_pass();
  gather_zone_contacts(model_, work_, 1);
  const WallView view = view_of(state);
  load_pass(model_, state, view);
  move_pass(state, controls);
  node_pass(state, controls);
  const double reaction = drive_pass(model_, state, view, controls);
  turn_pass(state);
  sum_energy(state);
  advance_clock(state, controls);
  return {reaction};
}

void Stepper::joint_pass(State& state) {
  const JointArrays arrays = joint_arrays(model_, work_, state);
  workers_.for_each_chunk(static_cast<int>(work_.joint_chunks.size()), [&](int c) {
    const JointChunk& chunk = work_.joint_chunks[static_cast<std::size_t>(c)];
    const auto material =
        static_cast<std::size_t>(model_.joint_material[static_cast<std::size_t>(chunk.begin)]);
    const Range range{static_cast<std::size_t>(chunk.begin), static_cast<std::size_t>(chunk.end)};
    double friction[kGroup] = {}, fracture[kGroup] = {}, crushing[kGroup] = {};
    const auto run = [&](const Kernels& kernels, std::size_t begin, std::size_t end) {
      kernels.joints(arrays, &work_.law[material], chunk.on_ground, begin, end,
                     {friction, fracture, crushing});
    };
    run(kernels_, range.begin, range.grouped());
    run(scalar_kernels(), range.grouped(), range.end);
    ChunkEnergy& energy = work_.joint_energy[static_cast<std::size_t>(c)];
    energy.friction = sum_of_groups(friction, 1);
    energy.fracture = sum_of_groups(fracture, 1);
    energy.crushing = sum_of_groups(crushing, 1);
  });
}

void Stepper::gather_pass() {
  const GatherArrays arrays = gather_arrays(model_, work_);
  workers_.for_each_chunk(work_.block_chunks, [&](int c) {
    const Range range = block_range(model_, c);
    scalar_kernels().wall_gather(arrays, 1, range.begin, range.end);
  });
}

void Stepper::move_pass(State& s, const Controls& controls) {
  const BlockArrays arrays = block_arrays(model_, work_, s);
  const MoveControls move{&controls.dt, &controls.damping, &controls.mass_scaling, &s.gravity_x,
                          &s.gravity_y};
  workers_.for_each_chunk(work_.block_chunks, [&](int c) {
    const Range range = block_range(model_, c);
    double loads[kGroup] = {}, damping[kGroup] = {};
    kernels_.move(arrays, move, range.begin, range.grouped(), {loads, damping});
    scalar_kernels().move(arrays, move, range.grouped(), range.end, {loads, damping});
    work_.block_energy[static_cast<std::size_t>(c)].loads = sum_of_groups(loads, 1);
    work_.block_energy[static_cast<std::size_t>(c)].damping = sum_of_groups(damping, 1);
  });
}

void Stepper::turn_pass(State& state) {
  const BlockArrays arrays = block_arrays(model_, work_, state);
  workers_.for_each_chunk(work_.block_chunks, [&](int c) {
    const Range range = block_range(model_, c);
    kernels_.turn(arrays, range.begin, range.grouped());
    scalar_kernels().turn(arrays, range.grouped(), range.end);
  });
}

void Stepper::sum_energy(State& s) { add_energies(work_, 1, 0, s); }

}  // namespace wythe::dynamics
