// The wall as it stands at a state: blocks, open, slipped and crushed joints, ground, push arrow.
#pragma once

#include <string>

#include "wythe/model.h"

namespace wythe::report {

struct WallPicture {
  std::string svg;     // without a style sheet
  int open = 0;        // joints drawn as open cracks
  int slipped = 0;     // as slipped
  int closed = 0;      // cracked, closed again
  int softening = 0;   // damage begun, not complete
  int crushed = 0;     // points marked as crushed
  double widest = 0;   // opening [m]
  double longest = 0;  // slip [m]
};

[[nodiscard]] WallPicture draw_wall(const Model& model, const State& state, double scale);

// A round magnification at which the largest displacement shows as some 5 % of the wall.
[[nodiscard]] double fitting_scale(const Model& model, const State& state);

}  // namespace wythe::report
