#include "cracked.h"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <stdexcept>

#include "bare_packs.h"
#include "contact/parameters.h"
#include "counted.h"
#include "dynamics/blocks.h"
#include "dynamics/forces.h"
#include "dynamics/step_arrays.h"
#include "wythe/io.h"
#include "wythe/solve.h"

namespace wythe::bench {
namespace {

constexpr int kSteps = 200;
constexpr double kLambda = 0.2;
// Bits differ by the order of operations; rounding grows to 1.3e-11 (velocities) in 200 steps, while
// a wrong term shows in the first step by more than 1e-6.
constexpr double kTolerance = 1e-8;

constexpr std::array kArrays{&State::ux,    &State::uy,          &State::theta,
                             &State::vx,    &State::vy,          &State::omega,
                             &State::kappa, &State::crush,       &State::plastic_slip,
                             &State::slip,  &State::shear_damage};

State ledger_since(State now, const State& start) {
  now.work_loads -= start.work_loads;
  now.work_damping -= start.work_damping;
  now.dissipated_friction -= start.dissipated_friction;
  now.dissipated_fracture -= start.dissipated_fracture;
  now.dissipated_crushing -= start.dissipated_crushing;
  return now;
}

void refuse_unless_same(const std::string& kernel, const State& bare, const State& engine) {
  const double gap = difference(bare, engine);
  if (!(gap < kTolerance))
    throw std::runtime_error(fmt::format(
        "bare kernel {}: {:.1e} from the engine after {} steps, more than {:.0e}: it computes "
        "something else, so its time means nothing",
        kernel, gap, kSteps, kTolerance));
}

Cost per_point(const Counts& counted, double bytes) {
  const auto n = static_cast<double>(cracked().model.n_point());
  return {static_cast<double>(counted.arithmetic) / n, static_cast<double>(counted.other) / n,
          bytes};
}

}  // namespace

Cracked::Cracked()
    // rigid blocks alone: the bare kernels know no zones
    : model(compile(read_model(
          WYTHE_SOURCE_DIR "/examples/tuff_wall/model.toml",
          {"stage.push.until=6 mm", "wall.opening.window.lintel.model=segments",
           "wall.opening.window.lintel.bearing_bond=joint",
           "wall.opening.window.lintel.top_bond=joint", "material.timber.youngs_modulus=0.3 GPa",
           "material.timber.shear_modulus=0.125 GPa"}))),
      state(initial_state(model)) {
  const Result result = solve(model, state);
  hash = result.state_hash;
  dt = result.time_step;
  for (const JointMaterial& m : model.materials) law.push_back(contact::constants_of(m));
  held = state;
  for (const BlockId block : push().driven) {
    const auto i = static_cast<std::size_t>(block);
    held.vx[i] = held.vy[i] = held.omega[i] = 0;
  }
}

BareStart Cracked::bare() const { return {model, held, dt, kLambda, push().driven}; }

const Cracked& cracked() {
  static const Cracked wall;
  return wall;
}

double difference(const State& bare, const State& engine) {
  double worst = 0;
  for (const auto array : kArrays) {
    double gap = 0, size = 0;
    for (std::size_t i = 0; i < (bare.*array).size(); ++i) {
      gap = std::max(gap, std::fabs((bare.*array)[i] - (engine.*array)[i]));
      size = std::max(size, std::fabs((engine.*array)[i]));
    }
    if (gap > 0) worst = std::max(worst, gap / size);
  }
  for (const auto work : {&State::work_loads, &State::work_damping, &State::dissipated_friction,
                          &State::dissipated_fracture, &State::dissipated_crushing})
    if (const double gap = std::fabs(bare.*work - engine.*work); gap > 0)
      worst = std::max(worst, gap / std::fabs(engine.*work));
  return worst;
}

State engine_after(int steps) {
  const Cracked& wall = cracked();
  State state = wall.held;
  dynamics::Stepper stepper(wall.model, 1);
  stepper.refresh(state);
  stepper.choose_driven(wall.push().driven);
  dynamics::Controls controls;
  controls.dt = wall.dt;
  controls.damping = kLambda;
  for (int k = 0; k < steps; ++k) stepper.step(state, controls);
  return ledger_since(state, wall.held);
}

void check_bare_kernels() {
  const State engine = engine_after(kSteps);
  for (const BareKernels* set : bare_here()) {
    BareWallsRun walls(cracked().bare(), *set);
    BareJointsRun joints(cracked().bare(), *set);
    for (int k = 0; k < kSteps; ++k) {
      walls.step();
      joints.step();
    }
    refuse_unless_same(fmt::format("walls/{}", set->name), walls.state(set->lanes - 1), engine);
    refuse_unless_same(fmt::format("joints/{}", set->name), joints.state(), engine);
  }
}

Cost engine_cost(int lanes) {
  const Model& m = cracked().model;
  State s = cracked().held;
  dynamics::Workspace work(m);
  using Access = dynamics::Walls<Counted>;
  double sums[3 * dynamics::kGroup] = {};
  const dynamics::JointEnergy joints{sums, sums + dynamics::kGroup, sums + 2 * dynamics::kGroup};
  const dynamics::BlockEnergy blocks{sums, sums + dynamics::kGroup};
  const auto nb = static_cast<std::size_t>(m.n_block);
  const dynamics::BlockArrays arrays = dynamics::block_arrays(m, work, s);
  dynamics::turn_run(arrays, Access{}, 0, nb);
  counts = {};
  for (const dynamics::JointChunk& c : work.joint_chunks) {
    const auto begin = static_cast<std::size_t>(c.begin), end = static_cast<std::size_t>(c.end);
    const auto* law = &work.law[static_cast<std::size_t>(m.joint_material[begin])];
    const dynamics::JointArrays v = dynamics::joint_arrays(m, work, s);
    if (c.on_ground)
      dynamics::joint_run<contact::PaperVariant, true, 0>(v, Access{}, law, begin, end, joints);
    else
      dynamics::joint_run<contact::PaperVariant, false, 2>(v, Access{}, law, begin, end, joints);
  }
  dynamics::gather_run(dynamics::gather_arrays(m, work), Access{}, 0, nb);
  const double damping = kLambda, scale = 1;
  dynamics::move_run(arrays, Access{},
                     {&cracked().dt, &damping, &scale, &s.gravity_x, &s.gravity_y}, 0, nb, blocks);
  dynamics::turn_run(arrays, Access{}, 0, nb);
  // Each wall's own: history of a point, force of a joint, rows of a block. Shared: geometry, lists.
  const auto nj = static_cast<double>(m.n_joint), np = static_cast<double>(m.n_point());
  const double own = 8 * (5 * np + 4 * nj + 23 * static_cast<double>(nb));
  const double shared = nj * (2 * 4 + 9 * 8) + static_cast<double>(m.block_entry.size()) * 4 +
                        static_cast<double>(nb) * (2 * 4 + 8);
  return per_point(counts, (own + shared / lanes) / np);
}

Cost bare_cost() {
  static constexpr BareKernels kCounting = bare_kernels<Counted>("counted");
  BareWallsRun run(cracked().bare(), kCounting);
  for (int k = 0; k < kSteps; ++k) run.step();  // until it knows which joints are at rest
  counts = {};
  run.step();
  return per_point(counts, run.bytes_per_point());
}

}  // namespace wythe::bench
