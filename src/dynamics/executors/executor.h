// An executor holds walls and runs each pass of a step over them. It takes either one
// wall, in chunks and threads, or several walls in SIMD lanes (processor.h). The step
// itself is a list of passes, step() in processor.cpp. An executor contains no mechanics.
#pragma once

#include <memory>

#include "dynamics/passes/drive.h"
#include "dynamics/passes/sums.h"
#include "model/fields.h"

namespace wythe::dynamics {

// One wall, as code that looks at it between steps sees it.
class WallAccess {
 public:
  WallAccess() = default;
  virtual ~WallAccess() = default;
  WallAccess(const WallAccess&) = delete;
  WallAccess& operator=(const WallAccess&) = delete;

  // Sum of the unbalanced forces on free blocks, divided by the sum
  // of the contact forces (1-norm). It is 0 where no force acts.
  [[nodiscard]] virtual double unbalance_ratio() const = 0;
  // 1/2 m v^2 + 1/2 I omega^2 at the half step [J].
  [[nodiscard]] virtual double kinetic_energy(double mass_scaling) const = 0;
  // Sum of the ground's forces against the direction [N], positive where the ground resists.
  [[nodiscard]] virtual double base_shear(const Vec3& along) const = 0;
  // First block whose motion is not finite or faster than 100 m/s, or -1; n_block + i for node i.
  [[nodiscard]] virtual BlockId runaway_block() const = 0;
  // The block that has moved furthest (n_block + i stands for node i).
  [[nodiscard]] virtual Furthest furthest_block() const = 0;
  // How far block i has moved along a direction [m].
  [[nodiscard]] virtual double moved(BlockId i, const Vec3& along) const = 0;
  // Marks the blocks that the drive moves.
  virtual void choose_driven(const std::vector<BlockId>& blocks) = 0;
  // Copies motion and history from the lane into the state's arrays.
  virtual void store_state(State& state) const = 0;
  // Loads the state again after it was changed outside.
  virtual void reload_wall(State&) {}
};

class Executor {
 public:
  Executor() = default;
  virtual ~Executor() = default;
  Executor(const Executor&) = delete;
  Executor& operator=(const Executor&) = delete;

  // How many walls it takes; a lane is one of them.
  [[nodiscard]] virtual int lanes() const = 0;
  // The model that stands for all walls that fit together.
  [[nodiscard]] virtual const Model& model() const = 0;
  // Loads a wall into a lane, or loads a state that was
  // changed. Model and state have to live until unload_wall().
  virtual void load_wall(int lane, const Model& model, State& state) = 0;
  // Stores the lane into the state's arrays. The lane is idle afterwards.
  virtual void unload_wall(int lane) = 0;
  [[nodiscard]] virtual std::unique_ptr<WallAccess> access(int lane) = 0;
  // Controls of the next step of a lane. A lane without controls does not move.
  virtual void set(int lane, const Controls& controls) = 0;
  // Contact force on the driven blocks against the push, in the last step [N].
  [[nodiscard]] virtual double reaction(int lane) const = 0;
  // Pairs of bodies that are near each other, of a wall with free contacts.
  [[nodiscard]] virtual int n_near() const { return 0; }

  // One time step of every wall.
  void step();

 protected:
  virtual void begin_step() = 0;    // dead loads, links, frames, layers; numbers that a step brings
  virtual void run(Pass pass) = 0;  // one pass over all its chunks
  virtual void update_free_contacts() {}  // finds contacts and adds their forces
  virtual void apply_dashpots() {}        // dashpots of shaken walls
  virtual void drive() = 0;               // moves the driven blocks, wall by wall
  virtual void end_step() = 0;            // adds works to the ledgers, advances clocks
};

// The executor for walls in their plane or in space. Several threads are possible for one wall only.
[[nodiscard]] std::unique_ptr<Executor> processor_for(const Model& model, int lanes,
                                                      int threads = 1);

// True where walls can be stepped side by side: one topology, the same kinds of dashpots, no free
// contacts, no masonry cut out or put up.
[[nodiscard]] inline bool fit_together(const Model& a, const Model& b) {
  return a.topology == b.topology && has_dashpots(a) == has_dashpots(b) &&
         has_maxwell(a) == has_maxwell(b) && !a.free.any() && !b.free.any() && !a.standing.any() &&
         !b.standing.any();
}

}  // namespace wythe::dynamics
