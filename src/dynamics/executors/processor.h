// Walls on this processor. Either one wall, with its neighbours in the lanes of
// packs and its chunks shared by threads, or walls side by side, one in each lane.
//
//   Processor one(model, 1, threads);
//   one.load_wall(0, model, state);
//   one.set(0, controls);
//   one.step();
//   one.access(0)->store_state(state);
#pragma once

#include <memory>
#include <vector>

#include "core/parallel.h"
#include "dynamics/executors/executor.h"
#include "dynamics/executors/kernels.h"
#include "dynamics/passes/dashpots.h"
#include "dynamics/passes/wall.h"

namespace wythe::dynamics {

template <class Bodies>
class FreeContacts;
class PlaneBodies;

class Processor final : public Executor {
 public:
  // `lanes`: 1, 2, 4 or 8. Several threads are possible for one wall only.
  Processor(const Model& model, int lanes, int threads = 1,
            const Kernels& kernels = kernels_in_use());
  ~Processor() override;
  Processor(const Processor&) = delete;
  Processor& operator=(const Processor&) = delete;

  [[nodiscard]] int lanes() const override { return static_cast<int>(wall_.size()); }
  [[nodiscard]] const Model& model() const override { return model_; }
  void load_wall(int lane, const Model& model, State& state) override;
  void unload_wall(int lane) override;
  [[nodiscard]] std::unique_ptr<WallAccess> access(int lane) override;
  void set(int lane, const Controls& controls) override;
  [[nodiscard]] double reaction(int lane) const override { return wall_[lane].reaction; }

  [[nodiscard]] const Layout& layout() const { return layout_; }
  [[nodiscard]] const State& state(int lane) const { return *wall_[lane].state; }
  [[nodiscard]] const WallView& view(int lane) const { return wall_[lane].view; }
  // Copies motion, history and free contacts of the wall in a lane into the arrays of a state.
  void store_state(int lane, State& state) const;
  [[nodiscard]] int n_near() const override;

 private:
  struct Wall {
    const Model* model = nullptr;  // null: the lane is idle
    State* state = nullptr;
    Controls controls;
    double reaction = 0;
    WallView view;
    DashpotState dashpot_state;
  };
  // As many walls as one pack holds, with their own memory.
  struct Bank {
    Memory memory;
    Tables tables;
    std::vector<double> works[kPasses];  // (chunks, kTerms, walls) [J]
  };

  void begin_step() override;
  void run(Pass pass) override;
  void apply_dashpots() override;
  void update_free_contacts() override;
  void drive() override;
  void end_step() override;
  void run_chunk(Pass pass, Bank& bank, std::size_t chunk);

  [[nodiscard]] const Bank& bank_of(int lane) const { return bank_[lane / width_]; }

  const Model model_;
  const Kernels& kernels_;
  const int width_;  // walls of a bank
  const Layout layout_;
  const State rest_;
  std::vector<Wall> wall_;
  std::vector<Bank> bank_;
  std::unique_ptr<FreeContacts<PlaneBodies>> free_;  // only for one wall alone
  Workers workers_;
};

}  // namespace wythe::dynamics
