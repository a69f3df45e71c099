// One time step of a wall, as a list of calls (step.cpp), and the pieces it is made of.
//
//   joint_pass   each joint: opening, slip -> stresses -> its own force            (forces.h)
//   zone_pass    each zone of a deformable block: forces on its corners                  (zones.h)
//   zone_contact_pass   each contact of a zone's edge: as joint_pass                    (zones.h)
//   gather_pass  each block: sum of its joints in CSR order, then of its zone contacts
//   load_pass    dead loads that follow their blocks                                (wall_pass.h)
//   move_pass    central differences with local damping
//   node_pass    the same for the nodes of zones                                 (zone_pass.cpp)
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
  // Work on chunks; a single one is done at once, without waking anybody.
  template <class Work>
  void for_each_chunk(int chunks, const Work& work) {
    if (chunks > 1) return workers_.for_each_chunk(chunks, work);
    if (chunks == 1) work(0);
  }

  void joint_pass(State& state);
  void gather_pass();
  void move_pass(State& state, const Controls& controls);
  void zone_pass(const State& state);
  void zone_contact_pass(State& state);
  void node_pass(State& state, const Controls& controls);
  void turn_pass(State& state);
  void sum_energy(State& state);

  const Model& model_;
  Workspace work_;
  Workers workers_;
  const Kernels& kernels_;
};

}  // namespace wythe::dynamics
