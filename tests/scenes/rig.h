// A wall stepped by a test: model, state, processor and controls together, without
// stages. The state may be changed between steps. After a step its arrays are up to date.
//
//   Rig rig(compile(spec));
//   rig.state.gravity_y = -9.81;
//   rig.settle(1e-9);          damped until unbalanced / contact forces fall below the ratio
//   rig.controls.damping = 0;
//   rig.run(0.5);              seconds
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <stdexcept>
#include <utility>

#include <array>

#include "dynamics/executors/processor.h"
#include "dynamics/meters/residual.h"
#include "wythe/parts/model.h"
#include "wythe/parts/reading.h"
#include "wythe/parts/result.h"

namespace wythe::scenes {

class Rig {
 public:
  explicit Rig(Model built, int threads = 1)
      : model(std::move(built)), state(initial_state(model)), processor(model, 1, threads) {
    controls.damping = model.solve.damping;
    controls.dt =
        model.solve.step_fraction * 2 / (model.omega_max * std::sqrt(1 + controls.damping));
    processor.load_wall(0, model, state);
    known_ = state;
  }
  Rig(const Rig&) = delete;
  Rig& operator=(const Rig&) = delete;

  // Returns the reaction.
  double step() {
    take_changes();
    go();
    store_state();
    return processor.reaction(0);
  }
  void run(double seconds) {
    take_changes();
    const auto steps = static_cast<std::int64_t>(std::ceil(seconds / controls.dt - 1e-9));
    for (std::int64_t k = 0; k < steps; ++k) go();
    store_state();
  }
  // Throws if the unbalance does not fall below `ratio` within `limit` seconds.
  void settle(double ratio, double limit = 20) {
    take_changes();
    const double start = state.time;
    for (int k = 1; k <= 100; ++k) go();
    while (dynamics::unbalance_of(view()) > ratio) {
      if (state.time - start > limit) throw std::runtime_error("the rig did not settle");
      for (int k = 0; k < 100; ++k) go();
    }
    store_state();
  }
  // Drives blocks at `velocity` along the direction of the first push stage; the velocity is reached in `ramp` seconds.
  void drive(std::size_t stage, double velocity) {
    controls.push = &model.stages[stage];
    controls.drive_velocity = velocity;
    driven_ = model.stages[stage].driven;
    dynamics::choose_driven(view(), driven_);
  }
  [[nodiscard]] PointReading point(JointId joint, int k) const {
    return read_points(model, state)[points_of(model, joint).begin + k];
  }
  [[nodiscard]] EnergyLedger energy() const {
    return dynamics::energy_ledger(model, state, controls.mass_scaling);
  }
  [[nodiscard]] const dynamics::WallView& view() const { return processor.view(0); }
  // Results of the last step: rows fx, fy, ma, mb of a joint; contact forces on a block.
  [[nodiscard]] std::array<double, 4> force(std::size_t joint) const {
    const double* row = view().t.force + 4 * processor.layout().joint_place[joint];
    return {row[0], row[1], row[2], row[3]};
  }
  [[nodiscard]] dynamics::BlockForce<double> contact(std::size_t block) const {
    return dynamics::contact_force(view().t, static_cast<std::ptrdiff_t>(block), 0);
  }

  Model model;
  State state;
  dynamics::Processor processor;
  dynamics::Controls controls;

 private:
  void go() {
    processor.set(0, controls);
    processor.step();
  }
  void store_state() {
    processor.access(0)->store_state(state);
    known_ = state;
  }
  void take_changes() {
    const auto same = [&](const StateField& f) { return state.*f.array == known_.*f.array; };
    if (std::all_of(kStateFields.begin(), kStateFields.end(), same)) return;
    processor.load_wall(0, model, state);
    dynamics::choose_driven(view(), driven_);
  }

  State known_;  // the state that the processor has
  std::vector<BlockId> driven_;
};

}  // namespace wythe::scenes
