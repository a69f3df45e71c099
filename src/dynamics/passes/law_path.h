// Which way a face took in the last step, and so the one to try first in the next. It decides what a step takes, never
// what it gives: each way finds out whether it holds. Only kUndamaged is taken at its word as to the history, and kReleased as to
// the force: a face is kFullLaw wherever a history comes from outside (load_lane).
#pragma once

#include <cstdint>

namespace wythe::dynamics {

// kReleased: all joints of a pack gave way to free contacts, so that their forces are zero and stay so.
enum LawPath : std::uint8_t { kFullLaw, kUndamaged, kClosed, kOpen, kReleased };

// Marks anew all joints of one wall that lie in packs of `width`. Those that gave way, or fill up a group, lie between
// `rest` and itself: `joint_b` is `rest`.
inline void mark_released(const std::int32_t* joint_b, std::int32_t rest, std::int32_t joints,
                          int width, std::uint8_t* law_path) {
  for (std::int32_t pack = 0; pack < joints / width; ++pack) {
    bool released = true;
    for (int k = 0; k < width; ++k) released = released && joint_b[pack * width + k] == rest;
    law_path[pack] = released ? kReleased : kFullLaw;
  }
}

}  // namespace wythe::dynamics
