// Walls stepped side by side, wherever: what LaneSolver asks of LaneStepper (SIMD lanes) and of
// DeviceStepper (a graphics processor).
#pragma once

#include <memory>

#include "dynamics/place.h"

namespace wythe::dynamics {

class SideBySide {
 public:
  SideBySide() = default;
  virtual ~SideBySide() = default;
  SideBySide(const SideBySide&) = delete;
  SideBySide& operator=(const SideBySide&) = delete;

  [[nodiscard]] virtual int lanes() const = 0;
  [[nodiscard]] virtual const Model& model() const = 0;
  // A wall takes a lane; model and state have to live until it is dropped.
  virtual void put(int lane, const Model& model, State& state) = 0;
  // The state's own arrays are brought up to date; the lane stands still from then on.
  virtual void drop(int lane) = 0;
  [[nodiscard]] virtual std::unique_ptr<Place> place(int lane) = 0;
  // What the next step takes of a lane; where it is not set, the lane stands still.
  virtual void set(int lane, const Controls& controls) = 0;
  virtual void step() = 0;
  [[nodiscard]] virtual double reaction(int lane) const = 0;
  // Whether the wall in the lane takes part in the next step.
  [[nodiscard]] virtual bool takes_part(int) const { return true; }
};

}  // namespace wythe::dynamics
