// Where one wall is stepped, as those see it who look at it between steps: alone, in a lane of walls
// side by side, or on a graphics processor.
#pragma once

#include <functional>

#include "dynamics/residual.h"
#include "dynamics/wall_pass.h"

namespace wythe::dynamics {

class Place {
 public:
  Place() = default;
  virtual ~Place() = default;
  Place(const Place&) = delete;
  Place& operator=(const Place&) = delete;

  // As in residual.h.
  [[nodiscard]] virtual double unbalance_ratio() const = 0;
  [[nodiscard]] virtual double kinetic_energy(double mass_scaling) const = 0;
  [[nodiscard]] virtual double base_shear(double px, double py) const = 0;
  [[nodiscard]] virtual BlockId runaway_block() const = 0;
  [[nodiscard]] virtual Furthest furthest_block() const = 0;
  // Marks the blocks that the drive moves in place of the move pass.
  virtual void choose_driven(const std::vector<BlockId>& blocks) = 0;
  // Copies motion and history from where they are into the state's own arrays.
  virtual void bring_up(State& state) const = 0;
};

// In this machine's memory.
class ViewPlace final : public Place {
 public:
  // `copy_out`: none where the state's own arrays are stepped.
  ViewPlace(const Model& model, const WallView& view, std::function<void(State&)> copy_out = {})
      : model_(model), view_(view), copy_out_(std::move(copy_out)) {}

  [[nodiscard]] double unbalance_ratio() const override {
    return dynamics::unbalance_ratio(model_, view_);
  }
  [[nodiscard]] double kinetic_energy(double mass_scaling) const override {
    return dynamics::kinetic_energy(model_, view_, mass_scaling);
  }
  [[nodiscard]] double base_shear(double px, double py) const override {
    return dynamics::base_shear(model_, view_, px, py);
  }
  [[nodiscard]] BlockId runaway_block() const override {
    return dynamics::runaway_block(model_, view_);
  }
  [[nodiscard]] Furthest furthest_block() const override {
    return dynamics::furthest_block(model_, view_);
  }
  void choose_driven(const std::vector<BlockId>& blocks) override {
    dynamics::choose_driven(model_, view_, blocks);
  }
  void bring_up(State& state) const override {
    if (copy_out_) copy_out_(state);
  }

 private:
  const Model& model_;
  WallView view_;
  std::function<void(State&)> copy_out_;
};

}  // namespace wythe::dynamics
