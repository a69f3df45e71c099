// Where walls are stepped, and how a pass runs over them: one wall in chunks and threads or walls in SIMD
// lanes (processor.h). The step itself is written once, as
// a list of passes (step(), processor.cpp); an executor knows no mechanics.
#pragma once

#include <memory>

#include "dynamics/passes/drive.h"
#include "dynamics/passes/sums.h"

namespace wythe::dynamics {

// One wall as those see it who look at it between steps.
class WallAccess {
 public:
  WallAccess() = default;
  virtual ~WallAccess() = default;
  WallAccess(const WallAccess&) = delete;
  WallAccess& operator=(const WallAccess&) = delete;

  // Sum of the unbalanced forces on free blocks over that of the contact forces, 1-norm; 0 where nothing
  // acts.
  [[nodiscard]] virtual double unbalance_ratio() const = 0;
  // 1/2 m v^2 + 1/2 I omega^2 at the half step [J].
  [[nodiscard]] virtual double kinetic_energy(double mass_scaling) const = 0;
  // Sum of the ground's forces against the direction, + resists [N].
  [[nodiscard]] virtual double base_shear(const Vec3& along) const = 0;
  // First block whose motion is not finite or faster than 100 m/s, or -1; n_block + i for node i.
  [[nodiscard]] virtual BlockId runaway_block() const = 0;
  // The block (n_block + i: node i) that has moved furthest.
  [[nodiscard]] virtual Furthest furthest_block() const = 0;
  // How far block i has moved along a direction [m].
  [[nodiscard]] virtual double moved(BlockId i, const Vec3& along) const = 0;
  // Marks the blocks that the drive moves.
  virtual void choose_driven(const std::vector<BlockId>& blocks) = 0;
  // Copies motion and history from the lane into the state's arrays.
  virtual void store_state(State& state) const = 0;
  // Loads what was changed in the state.
  virtual void reload_wall(State&) {}
};

// Of free contacts in the last step: pairs of parts that are near, those of them that may touch; searches so far.
struct FreeCounts {
  int near = 0, awake = 0, searches = 0;
};

class Executor {
 public:
  Executor() = default;
  virtual ~Executor() = default;
  Executor(const Executor&) = delete;
  Executor& operator=(const Executor&) = delete;

  // How many walls it takes; a lane is one of them.
  [[nodiscard]] virtual int lanes() const = 0;
  // Stands for all walls that fit it.
  [[nodiscard]] virtual const Model& model() const = 0;
  // A wall takes a lane, or loads again what was changed in its state. Model and state have to live until
  // unload_wall().
  virtual void load_wall(int lane, const Model& model, State& state) = 0;
  // Stores the lane into the state's arrays; the lane stands still from then on.
  virtual void unload_wall(int lane) = 0;
  [[nodiscard]] virtual std::unique_ptr<WallAccess> access(int lane) = 0;
  // What the next step takes of a lane; where it is not set, the lane stands still.
  virtual void set(int lane, const Controls& controls) = 0;
  // Contact force on the driven blocks against the push, in the last step [N].
  [[nodiscard]] virtual double reaction(int lane) const = 0;
  [[nodiscard]] virtual FreeCounts free_counts() const { return {}; }

  // One time step of every wall.
  void step();

 protected:
  virtual void begin_step() = 0;    // dead loads follow their blocks; what the step brings along
  virtual void run(Pass pass) = 0;  // a pass over all its chunks
  virtual void update_free_contacts() {}  // contacts that come and go
  virtual void apply_dashpots() {}        // dashpots of shaken walls
  virtual void drive() = 0;               // the driven blocks, wall by wall
  virtual void end_step() = 0;            // works into the walls' ledgers, clocks
};

// This processor for walls in their plane or in space; several threads for one wall only.
[[nodiscard]] std::unique_ptr<Executor> processor_for(const Model& model, int lanes,
                                                      int threads = 1);

// True where the walls can be stepped side by side: one topology, and joints that stay what they are.
[[nodiscard]] inline bool fit_together(const Model& a, const Model& b) {
  return a.topology == b.topology && !a.free.any() && !b.free.any() && !a.standing.any() &&
         !b.standing.any();
}

}  // namespace wythe::dynamics
