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
  pose.assign(4 * nb * walls, 0.0);
  force.assign(4 * nj * walls, 0.0);
  is_free.assign(nb * walls, 1.0);
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
  gather_pass();
  const WallView view = view_of(state);
  load_pass(model_, state, view);
  move_pass(state, controls);
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
      kernels.joints(arrays, model_.materials[material], &work_.law[material], chunk.on_ground,
                     begin, end, {friction, fracture, crushing});
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
