// The tower of peers.cpp in wythe, with the same measures: peers_ours -> one line of CSV as peers.cpp, then the gap of the ledger.
//
// The tower settles under its weight, then the base is accelerated as there. Its step and its damping are those of the shake in
// tower.toml. Steps are taken without stages, since a block that has toppled would end a shake.
#include <cstdio>
#include <ctime>
#include <exception>
#include <memory>
#include <string>

#include "dynamics/meters/residual.h"
#include "dynamics/stages/stage_run.h"
#include "meter.h"
#include "wythe/parts/io.h"
#include "wythe/parts/model.h"

namespace {

using namespace wythe;
using namespace peers;

std::vector<Block> blocks_of(const Model& m) {
  std::vector<Block> blocks;
  for (std::size_t i = 0; i < static_cast<std::size_t>(m.n_block); ++i)
    blocks.push_back(
        {m.centroid_x[i], m.centroid_y[i], m.mass[i] / (kDensity * kHeight * kThickness)});
  return blocks;
}
std::vector<Pose> poses_of(const Model& m, const State& s) {
  std::vector<Pose> poses;
  for (std::size_t i = 0; i < static_cast<std::size_t>(m.n_block); ++i)
    poses.push_back({m.centroid_x[i] + s.ux[i], m.centroid_y[i] + s.uy[i], s.theta[i], s.vx[i],
                     s.vy[i], s.omega[i]});
  return poses;
}

void run() {
  const Model model = compile(read_model(WYTHE_SOURCE_DIR "/benchmarks/peers/tower.toml"));
  State state = initial_state(model);
  const std::unique_ptr<dynamics::Executor> executor = dynamics::processor_for(model, 1);
  dynamics::Controls controls;
  executor->load_wall(0, model, state);
  state.gravity_y = -kGravity;
  const auto step_for = [&](double time) {
    const long steps = std::lround(time / controls.dt);
    executor->set(0, controls);
    for (long k = 0; k < steps; ++k) executor->step();
    return steps;
  };
  controls.damping = 0.8;
  controls.dt = dynamics::stage_time_step(model, model.stages.front());
  step_for(0.5);

  const Stage& shake = model.stages.back();
  controls.damping = 0;
  controls.dt = dynamics::stage_time_step(model, shake);
  controls.dashpots = &shake.dashpots;
  const std::vector<Block> blocks = blocks_of(model);
  Meter meter(blocks);
  double push = kPush, seconds = 0, potential = 0;
  for (const Block& b : blocks) potential += b.mass() * kGravity * b.y;
  long steps = 0;
  for (int look = 0; look * kLook < kDuration; ++look) {
    if (look * kLook >= kPushed) push = 0;
    state.gravity_x = push;
    const std::clock_t start = std::clock();
    steps += step_for(kLook);
    seconds += static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC;
    executor->access(0)->store_state(state);
    meter.look(poses_of(model, state), push);
  }
  const EnergyLedger e = dynamics::energy_ledger(model, state, 1);
  std::printf("wythe,%zu,%g,%ld,%.3f,%.1f,%.3g,%.3g,%.3g\n", blocks.size(), controls.dt, steps,
              seconds,
              1e9 * seconds / static_cast<double>(steps) / static_cast<double>(blocks.size()),
              1e3 * meter.deepest(), meter.growth() / potential, e.gap_ratio);
}

}  // namespace

int main() {
  try {
    run();
  } catch (const std::exception& e) {
    std::fprintf(stderr, "peers_ours: %s\n", e.what());
    return 1;
  }
}
