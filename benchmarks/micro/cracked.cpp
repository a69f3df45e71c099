#include "cracked.h"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <stdexcept>

#include "bare_packs.h"
#include "contact/parameters.h"
#include "counted.h"
#include "dynamics/executors/kernel_set.h"
#include "wythe/parts/io.h"
#include "wythe/parts/solve.h"

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
  now.energy.work_loads -= start.energy.work_loads;
  now.energy.work_damping -= start.energy.work_damping;
  now.energy.dissipated_friction -= start.energy.dissipated_friction;
  now.energy.dissipated_fracture -= start.energy.dissipated_fracture;
  now.energy.dissipated_crushing -= start.energy.dissipated_crushing;
  return now;
}

// The engine books friction by the stresses at both ends of a step (docs/theory/integration.md, 4.15), a bare kernel by that
// at its end: they differ by half of what the stress changes in a step in which a point slides.
constexpr double kFrictionTolerance = 0.02;

void refuse_unless_same(const std::string& kernel, const State& bare, const State& engine) {
  double gap = difference(bare, engine);
  if (std::fabs(bare.energy.dissipated_friction / engine.energy.dissipated_friction - 1) >
      kFrictionTolerance)
    gap = 1;
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

// Rigid blocks alone: the bare kernels know no zones.
Model tuff_wall(const std::vector<std::string>& more) {
  std::vector<std::string> settings = {"stage.push.until=6 mm",
                                       "wall.opening.window.lintel.model=segments",
                                       "wall.opening.window.lintel.bearing_bond=joint",
                                       "wall.opening.window.lintel.top_bond=joint",
                                       "material.timber.youngs_modulus=0.3 GPa",
                                       "material.timber.shear_modulus=0.125 GPa"};
  settings.insert(settings.end(), more.begin(), more.end());
  return compile(read_model(WYTHE_SOURCE_DIR "/examples/tuff_wall/model.toml", settings));
}

}  // namespace

Cracked::Cracked(const std::vector<std::string>& more)
    : model(tuff_wall(more)), state(initial_state(model)) {
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

const Cracked& graded() {
  static const Cracked wall(
      {"field.ft.path=material.joint.tensile_strength", "field.ft.cov=0", "field.ft.by=joint"});
  if (wall.hash != cracked().hash)
    throw std::runtime_error("the graded wall went another way than the plain one");
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
  for (const auto work :
       {&AccumulatedEnergy::work_loads, &AccumulatedEnergy::work_damping,
        &AccumulatedEnergy::dissipated_fracture, &AccumulatedEnergy::dissipated_crushing})
    if (const double gap = std::fabs(bare.energy.*work - engine.energy.*work); gap > 0)
      worst = std::max(worst, gap / std::fabs(engine.energy.*work));
  return worst;
}

State engine_after(int steps) {
  const Cracked& wall = cracked();
  State state = wall.held;
  dynamics::Processor processor(wall.model, 1);
  processor.load_wall(0, wall.model, state);
  processor.access(0)->choose_driven(wall.push().driven);
  dynamics::Controls controls;
  controls.dt = wall.dt;
  controls.damping = kLambda;
  processor.set(0, controls);
  for (int k = 0; k < steps; ++k) processor.step();
  processor.unload_wall(0);
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
  using Access = dynamics::WallLanes<Counted, 1>;
  const dynamics::Layout layout(m, dynamics::Layout::kWalls);
  dynamics::Memory memory;
  const dynamics::Tables t = dynamics::make_tables(layout, m, 1, memory);
  dynamics::load_lane(layout, t, 0, m, cracked().held);
  const dynamics::WallView wall = dynamics::view_of(layout, m, t, 0);
  dynamics::set_rates(wall, cracked().dt, 1);
  wall.wall_value(dynamics::kDt) = cracked().dt;
  wall.wall_value(dynamics::kDamping) = kLambda;
  const auto step = [&] {
    double works[dynamics::kTerms * dynamics::kGroup] = {};
    for (const dynamics::Chunk& chunk : layout.chunks[dynamics::kJoints])
      dynamics::PassesOf<Access>::joints(t, chunk, works);
    for (const dynamics::Chunk& chunk : layout.chunks[dynamics::kBlocks])
      dynamics::run_pass<dynamics::Blocks<Access>>(t, chunk, works);
  };
  step();  // until it knows which joints move
  counts = {};
  step();
  // Each wall's own: history of a point, force of a joint, rows of a block. Shared: geometry, lists.
  const auto nj = static_cast<double>(m.n_joint), np = static_cast<double>(m.n_point());
  const auto nb = static_cast<double>(m.n_block);
  const double own = 8 * (dynamics::kHistoryRows * np + 4 * nj + (dynamics::kBlockRows + 4) * nb);
  const double shared = nj * (2 * 4 + dynamics::kJointRows * 8) +
                        static_cast<double>(m.block_entry.size()) * 4 + nb * (2 * 4 + 8);
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
