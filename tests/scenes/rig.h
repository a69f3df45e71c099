// A wall stepped by hand: model, state, stepper and controls together, without stages.
//
//   Rig rig(compile(spec));
//   rig.state.gravity_y = -9.81;
//   rig.settle(1e-9);          damped until unbalanced / contact forces fall below the ratio
//   rig.controls.damping = 0;
//   rig.run(0.5);              seconds
#pragma once

#include <cmath>
#include <cstdint>
#include <stdexcept>
#include <utility>

#include "dynamics/residual.h"
#include "dynamics/step.h"
#include "wythe/model.h"
#include "wythe/result.h"

namespace wythe::scenes {

class Rig {
 public:
  explicit Rig(Model built, int threads = 1)
      : model(std::move(built)), state(initial_state(model)), stepper(model, threads) {
    controls.damping = model.solve.damping;
    controls.dt =
        model.solve.step_fraction * 2 / (model.omega_max * std::sqrt(1 + controls.damping));
    stepper.refresh(state);
  }
  Rig(const Rig&) = delete;
  Rig& operator=(const Rig&) = delete;

  dynamics::DriveForce step() { return stepper.step(state, controls); }
  void run(double seconds) {
    const auto steps = static_cast<std::int64_t>(std::ceil(seconds / controls.dt - 1e-9));
    for (std::int64_t k = 0; k < steps; ++k) step();
  }
  // Throws when the unbalance does not fall below `ratio` within `limit` seconds.
  void settle(double ratio, double limit = 20) {
    const double start = state.time;
    for (int k = 1; k <= 100; ++k) step();
    while (dynamics::unbalance_ratio(model, view()) > ratio) {
      if (state.time - start > limit) throw std::runtime_error("the rig did not settle");
      for (int k = 0; k < 100; ++k) step();
    }
  }
  // Blocks driven at `velocity` along the first push stage's direction; `ramp` seconds to get there.
  void drive(std::size_t stage, double velocity) {
    controls.push = &model.stages[stage];
    controls.drive_velocity = velocity;
    stepper.choose_driven(model.stages[stage].driven);
  }
  [[nodiscard]] PointStress point(JointId joint, int k) const {
    return point_stresses(model, state)[static_cast<std::size_t>(joint * model.n_face_point + k)];
  }
  [[nodiscard]] EnergyLedger energy() const {
    return dynamics::energy_ledger(model, state, controls.mass_scaling);
  }
  [[nodiscard]] dynamics::WallView view() { return stepper.view_of(state); }

  Model model;
  State state;
  dynamics::Stepper stepper;
  dynamics::Controls controls;
};

}  // namespace wythe::scenes
