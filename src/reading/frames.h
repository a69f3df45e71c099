// How the two sides of a frame's section stand to each other in a state.
#pragma once

#include <cstddef>

#include "contact/link.h"
#include "contact/section.h"
#include "wythe/parts/model.h"

namespace wythe::reading {

// How far a point of a block has moved in a state; nothing moves on the ground.
[[nodiscard]] contact::LinkEnd end_in(const State& state, BlockId block, double arm_x,
                                      double arm_y);

// Less what it was when a stage put the section up (frame_along, frame_across, frame_turn), where one did.
struct SectionPlace {
  contact::SectionJump jump;
  contact::LinkEnd b;  // its point on side b
};
[[nodiscard]] SectionPlace section_in(const Model& model, const State& state, std::size_t section);

}  // namespace wythe::reading
