#include "dynamics/step.h"

#include "contact/parameters.h"
#include "core/real.h"
#include "dynamics/forces.h"
#include "dynamics/motion.h"

namespace wythe::dynamics {
namespace {

JointView<double> view_of(const Model& m, Workspace& w, State& s) {
  return {.a = m.joint_a.data(),
          .b = m.joint_b.data(),
          .material = m.joint_material.data(),
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
          .law = w.law.data(),
          .ux = s.ux.data(),
          .uy = s.uy.data(),
          .half_cos = w.half_cos.data(),
          .half_sin = w.half_sin.data(),
          .kappa = s.kappa.data(),
          .crush = s.crush.data(),
          .plastic_slip = s.plastic_slip.data(),
          .slip = s.slip.data(),
          .shear_damage = s.shear_damage.data(),
          .tension_set = s.tension_set.data(),
          .force_x = w.force_x.data(),
          .force_y = w.force_y.data(),
          .moment_a = w.moment_a.data(),
          .moment_b = w.moment_b.data()};
}

// Joints in chunks that share variant and ground; the order of joints is the model's.
std::vector<JointChunk> cut_joints(const Model& m) {
  std::vector<JointChunk> chunks;
  for (JointId j = 0; j < m.n_joint; ++j) {
    const bool on_ground = j >= m.n_pair;
    const auto i = static_cast<std::size_t>(j);
    const bool fits =
        !chunks.empty() && chunks.back().on_ground == on_ground &&
        j - chunks.back().begin < kChunk &&
        contact::same_variant(m.materials[static_cast<std::size_t>(m.joint_material[i])],
                              m.materials[static_cast<std::size_t>(m.joint_material[i - 1])]);
    if (!fits) chunks.push_back({j, j, on_ground});
    chunks.back().end = j + 1;
  }
  return chunks;
}

struct Range {
  std::size_t begin, end;
};
Range block_range(const Model& m, int chunk) {
  const auto begin = static_cast<std::size_t>(chunk) * kChunk;
  return {begin, std::min(begin + kChunk, static_cast<std::size_t>(m.n_block))};
}

}  // namespace

Workspace::Workspace(const Model& m) {
  for (const JointMaterial& material : m.materials) law.push_back(contact::constants_of(material));
  joint_chunks = cut_joints(m);
  block_chunks = (m.n_block + kChunk - 1) / kChunk;
  const auto nb = static_cast<std::size_t>(m.n_block), nj = static_cast<std::size_t>(m.n_joint);
  for (auto* array : {&half_cos, &half_sin, &contact_x, &contact_y, &contact_m, &load_x, &load_y,
                      &load_m, &total_x, &total_y, &total_m})
    array->assign(nb, 0.0);
  for (auto* array : {&force_x, &force_y, &moment_a, &moment_b}) array->assign(nj, 0.0);
  driven.assign(nb, 0);
  joint_energy.resize(joint_chunks.size());
  block_energy.resize(static_cast<std::size_t>(block_chunks));
}

Stepper::Stepper(const Model& model, int threads)
    : model_(model), work_(model), workers_(threads) {}

void Stepper::choose_driven(const std::vector<BlockId>& blocks) {
  std::fill(work_.driven.begin(), work_.driven.end(), std::uint8_t{0});
  for (const BlockId block : blocks) work_.driven[static_cast<std::size_t>(block)] = 1;
}

DriveForce Stepper::step(State& state, const Controls& controls) {
  joint_pass(state);
  gather_pass();
  load_pass(state);
  move_pass(state, controls);
  const DriveForce drive = drive_pass(state, controls);
  turn_pass(state);
  sum_energy(state);
  state.time += controls.dt;
  state.stage_time += controls.dt;
  ++state.step;
  return drive;
}

void Stepper::joint_pass(State& state) {
  const JointView<double> view = view_of(model_, work_, state);
  workers_.for_each_chunk(static_cast<int>(work_.joint_chunks.size()), [&](int c) {
    const JointChunk& chunk = work_.joint_chunks[static_cast<std::size_t>(c)];
    const auto material = model_.joint_material[static_cast<std::size_t>(chunk.begin)];
    const JointWork<double> done = contact::with_variant(
        model_.materials[static_cast<std::size_t>(material)], [&](auto variant) {
          using V = decltype(variant);
          return chunk.on_ground ? joint_forces<V, true>(view, chunk.begin, chunk.end)
                                 : joint_forces<V, false>(view, chunk.begin, chunk.end);
        });
    ChunkEnergy& energy = work_.joint_energy[static_cast<std::size_t>(c)];
    energy.friction = done.friction;
    energy.fracture = done.fracture;
    energy.crushing = done.crushing;
  });
}

void Stepper::gather_pass() {
  workers_.for_each_chunk(work_.block_chunks, [&](int c) {
    const Range range = block_range(model_, c);
    for (std::size_t i = range.begin; i < range.end; ++i) {
      double fx = 0, fy = 0, m = 0;
      for (auto e = model_.block_begin[i]; e < model_.block_begin[i + 1]; ++e) {
        const auto entry = model_.block_entry[static_cast<std::size_t>(e)];
        const auto j = static_cast<std::size_t>(entry >> 1);
        const bool is_b = (entry & 1) != 0;
        fx += is_b ? -work_.force_x[j] : work_.force_x[j];
        fy += is_b ? -work_.force_y[j] : work_.force_y[j];
        m += is_b ? work_.moment_b[j] : work_.moment_a[j];
      }
      work_.contact_x[i] = fx;
      work_.contact_y[i] = fy;
      work_.contact_m[i] = m;
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
      const double c = work_.half_cos[i], s = work_.half_sin[i];
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
  const double g_x = s.gravity_x, g_y = s.gravity_y;
  workers_.for_each_chunk(work_.block_chunks, [&](int c) {
    ChunkEnergy energy;
    const Range range = block_range(model_, c);
    for (std::size_t i = range.begin; i < range.end; ++i) {
      const double m = model_.mass[i], heavy = model_.heavy_mass[i];
      const double load_x = work_.load_x[i] + heavy * g_x, load_y = work_.load_y[i] + heavy * g_y;
      const double fx = work_.contact_x[i] + load_x, fy = work_.contact_y[i] + load_y;
      const double fm = model_.turn_freedom[i] * (work_.contact_m[i] + work_.load_m[i]);
      work_.total_x[i] = fx;
      work_.total_y[i] = fy;
      work_.total_m[i] = fm;
      if (work_.driven[i] != 0) continue;  // drive_pass moves these
      const double dt = controls.dt, scaling = controls.mass_scaling;
      const Moved x = accelerate(s.vx[i], fx, m * scaling, dt, controls.damping);
      const Moved y = accelerate(s.vy[i], fy, m * scaling, dt, controls.damping);
      const Moved r = accelerate(s.omega[i], fm, model_.inertia[i] * scaling, dt, controls.damping);
      s.vx[i] = x.velocity;
      s.vy[i] = y.velocity;
      s.omega[i] = r.velocity;
      s.ux[i] += dt * x.velocity;
      s.uy[i] += dt * y.velocity;
      s.theta[i] += dt * r.velocity;
      energy.loads += dt * (load_x * x.mean_velocity + load_y * y.mean_velocity +
                            work_.load_m[i] * r.mean_velocity);
      energy.damping += x.damping_work + y.damping_work + r.damping_work;
    }
    work_.block_energy[static_cast<std::size_t>(c)].loads = energy.loads;
    work_.block_energy[static_cast<std::size_t>(c)].damping = energy.damping;
  });
}

void Stepper::turn_pass(const State& state) {
  workers_.for_each_chunk(work_.block_chunks, [&](int c) {
    const Range range = block_range(model_, c);
    for (std::size_t i = range.begin; i < range.end; ++i) {
      const SinCos<double> turned = sin_cos(0.5 * state.theta[i]);
      work_.half_cos[i] = turned.cos;
      work_.half_sin[i] = turned.sin;
    }
  });
}

void Stepper::sum_energy(State& s) {
  for (const ChunkEnergy& e : work_.joint_energy) {
    s.dissipated_friction += e.friction;
    s.dissipated_fracture += e.fracture;
    s.dissipated_crushing += e.crushing;
  }
  for (const ChunkEnergy& e : work_.block_energy) {
    s.work_loads += e.loads;
    s.work_damping += e.damping;
  }
}

}  // namespace wythe::dynamics
