// Where one wall is stepped: alone, or in a lane of walls side by side.
#pragma once

#include <functional>

#include "dynamics/wall_pass.h"

namespace wythe::dynamics {

struct Place {
  WallView view;
  // Copies motion and history from the lane into the state's own arrays; alone they lie there.
  std::function<void(State&)> copy_out;

  void bring_up(State& state) const {
    if (copy_out) copy_out(state);
  }
};

}  // namespace wythe::dynamics
