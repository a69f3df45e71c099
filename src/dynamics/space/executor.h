// Walls in space on this processor. Either one wall, with its neighbours in the lanes of packs and its chunks
// shared by threads, or walls side by side, one in each lane. The counterpart of executors/processor.h.
#pragma once

#include <memory>

#include "core/parallel.h"
#include "dynamics/executors/executor.h"
#include "dynamics/space/dashpots.h"
#include "dynamics/space/kernels.h"
#include "dynamics/space/wall.h"
#include "dynamics/space/zones.h"

namespace wythe::dynamics {
template <class Bodies>
class FreeContacts;
}

namespace wythe::dynamics::space {

class SpaceBodies;

class SpaceProcessor final : public Executor {
 public:
  // `lanes`: 1, 2, 4 or 8. Several threads are possible for one wall only.
  SpaceProcessor(const Model& model, int lanes, int threads = 1,
                 const KernelSet& kernels = *kernels_here().back());
  ~SpaceProcessor() override;
  SpaceProcessor(const SpaceProcessor&) = delete;
  SpaceProcessor& operator=(const SpaceProcessor&) = delete;

  [[nodiscard]] int lanes() const override { return static_cast<int>(wall_.size()); }
  [[nodiscard]] const Model& model() const override { return model_; }
  void load_wall(int lane, const Model& model, State& state) override;
  void unload_wall(int lane) override;
  [[nodiscard]] std::unique_ptr<WallAccess> access(int lane) override;
  void set(int lane, const Controls& controls) override;
  [[nodiscard]] double reaction(int lane) const override { return wall_[lane].reaction; }
  [[nodiscard]] const State& state(int lane) const { return *wall_[lane].state; }
  // Copies motion, history and free contacts of the wall in a lane into the arrays of a state.
  void store_state(int lane, State& state) const;
  [[nodiscard]] const WallView& view(int lane) const { return wall_[lane].view; }
  [[nodiscard]] int n_near() const override;
  // Null without deformable blocks.
  [[nodiscard]] const ZoneRun* zones(int lane) const { return wall_[lane].zones.get(); }

 private:
  struct Wall {
    const Model* model = nullptr;  // null: the lane is idle
    State* state = nullptr;
    Controls controls;
    double reaction = 0;
    WallView view;
    DashpotState dashpot_state;
    bool has_stepped = false;
    std::unique_ptr<ZoneRun> zones;  // null without deformable blocks
  };
  // As many walls as one pack holds, with their own memory.
  struct Bank {
    Memory memory;
    Tables tables;
    std::vector<double> joint_works, block_works;  // (chunks, kTerms, walls) [J]
  };

  void begin_step() override;
  void run(Pass pass) override;
  void run_zones(Pass pass);
  static void keep_support_step(Wall& wall, double velocity);
  void update_free_contacts() override;
  void apply_dashpots() override;
  void drive() override;
  void end_step() override;
  // `works`: of the chunk; null for a pass that does none.
  void run_chunk(Kernel kernel, Bank& bank, const Chunk& chunk, double* works) const;

  const Model model_;
  const KernelSet& kernels_;
  const int width_;  // walls of a bank
  const Layout layout_;
  const State rest_;
  std::vector<Wall> wall_;
  std::vector<Bank> bank_;
  std::unique_ptr<FreeContacts<SpaceBodies>> free_;  // only for one wall alone
  Workers workers_;
};

}  // namespace wythe::dynamics::space
