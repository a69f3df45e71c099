// Which way a face took in the last step, and so the one to try first in the next. It decides what a step takes, never
// what it gives: each way finds out whether it holds. Only kWhole is taken at its word as to the history, and kGone as to
// the force: a face is kMoving wherever a history comes from outside (put_wall).
#pragma once

#include <cstdint>

namespace wythe::dynamics {

// kGone: all joints of a pack gave way to free contacts, so that their forces are zero and stay so.
enum Way : std::uint8_t { kMoving, kWhole, kClosed, kOpen, kGone };

// Marks anew all joints of one wall that lie in packs of `width`. Those that gave way, or fill up a group, lie between
// `rest` and itself: `joint_b` is `rest`.
inline void mark_gone(const std::int32_t* joint_b, std::int32_t rest, std::int32_t joints,
                      int width, std::uint8_t* way) {
  for (std::int32_t pack = 0; pack < joints / width; ++pack) {
    bool gone = true;
    for (int k = 0; k < width; ++k) gone = gone && joint_b[pack * width + k] == rest;
    way[pack] = gone ? kGone : kMoving;
  }
}

}  // namespace wythe::dynamics
