// Relative position of the two sides of a frame's section in a state.
#pragma once

#include <cstddef>

#include "contact/link.h"
#include "contact/section.h"
#include "wythe/parts/model.h"

namespace wythe::reading {

// Displacement of a point of a block in a state; zero on the ground.
[[nodiscard]] contact::LinkEnd end_in(const State& state, BlockId block, double arm_x,
                                      double arm_y);

// Position without its value at installation (frame_along, frame_across, frame_turn).
struct SectionPlace {
  contact::SectionJump jump;
  contact::LinkEnd b;  // the point on side b
};
[[nodiscard]] SectionPlace section_in(const Model& model, const State& state, std::size_t section);

}  // namespace wythe::reading
