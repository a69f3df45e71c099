#include "dynamics/step.h"

#include "contact/parameters.h"
#include "dynamics/kernels.h"

namespace wythe::dynamics {
namespace {

JointArrays arrays_of(const Model& m, Workspace& w, State& s) {
  return {.a = m.joint_a.data(),
          .b = m.joint_b.data(),
          .arm_a_x = m.arm_a_x.data(),
          .arm_a_y = m.arm_a_y.data(),
          .arm_b_x = m.arm_b_x.data(),
          .arm_b_y = m.arm_b_y.data(),
          .half_x = m.half_x.data(),
          .half_y = m.half_y.data(),
          .tangent_x = m.tangent_x.data(),
          .tangent_y = m.tangent_y.data(),
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
          .force = w.force.data()};
}

BlockArrays arrays_of_blocks(const Model& m, Workspace& w, State& s) {
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

double sum_of(const double (&lanes)[kGroup]) {
  double sum = 0;
  for (const double lane : lanes) sum += lane;
  return sum;
}

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

struct Range {
  std::size_t begin, end;
  // where the whole groups of kGroup end
  [[nodiscard]] std::size_t grouped() const { return end - (end - begin) % kGroup; }
};
Range block_range(const Model& m, int chunk) {
  const auto begin = static_cast<std::size_t>(chunk) * kChunk;
  return {begin, std::min(begin + kChunk, static_cast<std::size_t>(m.n_block))};
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

void size_for_solids(const Solids& s, Workspace& w) {
  const auto zones = static_cast<std::size_t>(s.n_zone), nodes = static_cast<std::size_t>(s.n_node);
  const auto contacts = static_cast<std::size_t>(s.n_contact);
  w.zone_chunks = cut_runs(s.zone_shape);
  w.contact_chunks = cut_runs(s.contact_material);
  w.node_chunks = (s.n_node + kChunk - 1) / kChunk;
  w.zone_force.assign(8 * zones, 0.0);
  for (auto* array : {&w.contact_block_force, &w.contact_edge_force})
    array->assign(4 * contacts, 0.0);
  for (auto* array : {&w.node_total_x, &w.node_total_y}) array->assign(nodes, 0.0);
  w.contact_energy.resize(w.contact_chunks.size());
  w.node_energy.resize(static_cast<std::size_t>(w.node_chunks));
}

}  // namespace

Workspace::Workspace(const Model& m) {
  for (const JointMaterial& material : m.materials) law.push_back(contact::constants_of(material));
  joint_chunks = cut_joints(m);
  block_chunks = (m.n_block + kChunk - 1) / kChunk;
  const auto nb = static_cast<std::size_t>(m.n_block), nj = static_cast<std::size_t>(m.n_joint);
  for (auto* array : {&contact_x, &contact_y, &contact_m, &load_x, &load_y, &load_m, &total_x,
                      &total_y, &total_m})
    array->assign(nb, 0.0);
  pose.assign(4 * nb + 4, 0.0);
  pose[4 * nb + 2] = 1.0;
  force.assign(4 * nj, 0.0);
  is_free.assign(nb, 1.0);
  block_middle = middle_of_entries(m);
  joint_energy.resize(joint_chunks.size());
  block_energy.resize(static_cast<std::size_t>(block_chunks));
  size_for_solids(m.solids, *this);
}

Stepper::Stepper(const Model& model, int threads, const Kernels& kernels)
    : model_(model), work_(model), workers_(threads), kernels_(kernels) {}

void Stepper::choose_driven(const std::vector<BlockId>& blocks) {
  std::fill(work_.is_free.begin(), work_.is_free.end(), 1.0);
  for (const BlockId block : blocks) work_.is_free[static_cast<std::size_t>(block)] = 0.0;
}

DriveForce Stepper::step(State& state, const Controls& controls) {
  joint_pass(state);
  zone_pass(state);
  zone_contact_pass(state);
  gather_pass();
  gather_zone_contacts();
  load_pass(state);
  move_pass(state, controls);
  node_pass(state, controls);
  const DriveForce drive = drive_pass(state, controls);
  turn_pass(state);
  sum_energy(state);
  state.time += controls.dt;
  state.stage_time += controls.dt;
  ++state.step;
  return drive;
}

void Stepper::joint_pass(State& state) {
  const JointArrays arrays = arrays_of(model_, work_, state);
  workers_.for_each_chunk(static_cast<int>(work_.joint_chunks.size()), [&](int c) {
    const JointChunk& chunk = work_.joint_chunks[static_cast<std::size_t>(c)];
    const auto material =
        static_cast<std::size_t>(model_.joint_material[static_cast<std::size_t>(chunk.begin)]);
    const Range range{static_cast<std::size_t>(chunk.begin), static_cast<std::size_t>(chunk.end)};
    JointLanes lanes;
    const auto run = [&](const Kernels& kernels, std::size_t begin, std::size_t end) {
      kernels.joints(arrays, model_.materials[material], work_.law[material], chunk.on_ground,
                     begin, end, lanes);
    };
    run(kernels_, range.begin, range.grouped());
    run(scalar_kernels(), range.grouped(), range.end);
    ChunkEnergy& energy = work_.joint_energy[static_cast<std::size_t>(c)];
    energy.friction = sum_of(lanes.friction);
    energy.fracture = sum_of(lanes.fracture);
    energy.crushing = sum_of(lanes.crushing);
  });
}

void Stepper::gather_pass() {
  workers_.for_each_chunk(work_.block_chunks, [&](int c) {
    const Range range = block_range(model_, c);
    const double* force = work_.force.data();
    const auto row = [&](std::int32_t e) {
      return force + 4 * (model_.block_entry[static_cast<std::size_t>(e)] >> 1);
    };
    for (std::size_t i = range.begin; i < range.end; ++i) {
      double ax = 0, ay = 0, am = 0, bx = 0, by = 0, bm = 0;
      const auto middle = work_.block_middle[i], end = model_.block_begin[i + 1];
      for (auto e = model_.block_begin[i]; e < middle; ++e) {
        const double* f = row(e);
        ax += f[0];
        ay += f[1];
        am += f[2];
      }
      for (auto e = middle; e < end; ++e) {
        const double* f = row(e);
        bx += f[0];
        by += f[1];
        bm += f[3];
      }
      work_.contact_x[i] = ax - bx;
      work_.contact_y[i] = ay - by;
      work_.contact_m[i] = am + bm;
    }
  });
}

void Stepper::load_pass(const State& state) {
  // Only loaded blocks are touched: cleared first, then summed in the stages' order.
  for (const Stage& stage : model_.stages)
    for (const PointLoad& load : stage.loads) {
      const auto i = static_cast<std::size_t>(load.block);
      work_.load_x[i] = work_.load_y[i] = work_.load_m[i] = 0;
    }
  for (std::size_t k = 0; k < model_.stages.size(); ++k) {
    const double scale = state.load_scale[k];
    if (scale == 0) continue;
    for (const PointLoad& load : model_.stages[k].loads) {
      const auto i = static_cast<std::size_t>(load.block);
      const double c = work_.pose[4 * i + 2], s = work_.pose[4 * i + 3];
      const double drop = -2 * s * s, sine = 2 * s * c;
      const double ax = load.arm_x + drop * load.arm_x - sine * load.arm_y;
      const double ay = load.arm_y + sine * load.arm_x + drop * load.arm_y;
      work_.load_x[i] += scale * load.fx;
      work_.load_y[i] += scale * load.fy;
      work_.load_m[i] += scale * (ax * load.fy - ay * load.fx);
    }
  }
}

void Stepper::move_pass(State& s, const Controls& controls) {
  const BlockArrays arrays = arrays_of_blocks(model_, work_, s);
  const MoveControls move{controls.dt, controls.damping, controls.mass_scaling, s.gravity_x,
                          s.gravity_y};
  workers_.for_each_chunk(work_.block_chunks, [&](int c) {
    const Range range = block_range(model_, c);
    BlockLanes lanes;
    kernels_.move(arrays, move, range.begin, range.grouped(), lanes);
    scalar_kernels().move(arrays, move, range.grouped(), range.end, lanes);
    work_.block_energy[static_cast<std::size_t>(c)].loads = sum_of(lanes.loads);
    work_.block_energy[static_cast<std::size_t>(c)].damping = sum_of(lanes.damping);
  });
}

void Stepper::turn_pass(State& state) {
  const BlockArrays arrays = arrays_of_blocks(model_, work_, state);
  workers_.for_each_chunk(work_.block_chunks, [&](int c) {
    const Range range = block_range(model_, c);
    kernels_.turn(arrays, range.begin, range.grouped());
    scalar_kernels().turn(arrays, range.grouped(), range.end);
  });
}

void Stepper::sum_energy(State& s) {
  for (const ChunkEnergy& e : work_.joint_energy) {
    s.dissipated_friction += e.friction;
    s.dissipated_fracture += e.fracture;
    s.dissipated_crushing += e.crushing;
  }
  for (const ChunkEnergy& e : work_.contact_energy) {
    s.dissipated_friction += e.friction;
    s.dissipated_fracture += e.fracture;
    s.dissipated_crushing += e.crushing;
  }
  for (const auto* energies : {&work_.block_energy, &work_.node_energy})
    for (const ChunkEnergy& e : *energies) {
      s.work_loads += e.loads;
      s.work_damping += e.damping;
    }
}

}  // namespace wythe::dynamics
