// The passes of a step that touch a few blocks of one wall, and its clock.
//
//   load_pass    dead loads that follow their blocks
//   drive_pass   the driven blocks: prescribed velocity, common or through a spreader (wall_pass.cpp)
#pragma once

#include "dynamics/wall_view.h"

namespace wythe::dynamics {

// What the stage asks of this step; set by stage_run.cpp, constant within the step.
struct Controls {
  double dt = 0;                // [s]
  double damping = 0;           // local damping lambda [-]
  double mass_scaling = 1;      // inertia only; weights stay
  const Stage* push = nullptr;  // null when nothing is driven
  double drive_velocity = 0;    // along the push [m/s]
};

void load_pass(const Model& model, const State& state, const WallView& wall);
// Returns the reaction: -sum of the contact forces on the driven blocks along the push [N].
double drive_pass(const Model& model, State& state, const WallView& wall, const Controls& controls);
// Marks the blocks that drive_pass moves in place of the move pass.
void choose_driven(const Model& model, const WallView& wall, const std::vector<BlockId>& blocks);

inline void advance_clock(State& state, const Controls& controls) {
  state.time += controls.dt;
  state.stage_time += controls.dt;
  ++state.step;
}

}  // namespace wythe::dynamics
