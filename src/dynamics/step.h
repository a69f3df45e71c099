// One time step of a wall, as a list of calls (step.cpp), and the pieces it is made of.
//
//   joint_pass   each joint: opening, slip -> stresses -> its own force            (forces.h)
//   gather_pass  each block: sum of its joints in CSR order
//   load_pass    dead loads that follow their blocks                                (wall_pass.h)
//   move_pass    central differences with local damping
//   drive_pass   the driven blocks: prescribed velocity, common or through a spreader (wall_pass.h)
//   turn_pass    poses for the next step: displacement, half-angle cosine and sine
//
// Reads Model and Controls; writes State and Workspace.
#pragma once

#include <vector>

#include "core/parallel.h"
#include "dynamics/kernels.h"
#include "dynamics/wall_pass.h"
#include "dynamics/workspace.h"
#include "wythe/model.h"

namespace wythe::dynamics {

// What the drive did in this step.
struct DriveForce {
  double reaction = 0;  // -sum of the contact forces on the driven blocks along the push [N]
};

class Stepper {
 public:
  Stepper(const Model& model, int threads, const Kernels& kernels = kernels_in_use());

  // Advances the state by one step.
  DriveForce step(State& state, const Controls& controls);
  // Takes up a state that was set or restored from outside.
  void refresh(State& state) { turn_pass(state); }
  // Marks the blocks that drive_pass moves in place of move_pass.
  void choose_driven(const std::vector<BlockId>& blocks);

  [[nodiscard]] const Workspace& workspace() const { return work_; }
  [[nodiscard]] WallView view_of(State& state);

 private:
  void joint_pass(State& state);
  void gather_pass();
  void move_pass(State& state, const Controls& controls);
  void turn_pass(State& state);
  void sum_energy(State& state);

  const Model& model_;
  Workspace work_;
  Workers workers_;
  const Kernels& kernels_;
};

}  // namespace wythe::dynamics
