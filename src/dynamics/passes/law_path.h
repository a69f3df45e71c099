// The path through the law that a face took in the last step. The next step tries it first. So it decides the time of a
// step and never its result, because each path checks whether it holds. Two are not checked: the history of kUndamaged,
// and the force of kReleased. So each face starts with kFullLaw when a history comes from outside (load_lane).
#pragma once

#include <cstdint>

namespace wythe::dynamics {

// kReleased: all joints of a pack were handed over to free contacts. Their forces are zero and stay so.
enum LawPath : std::uint8_t { kFullLaw, kUndamaged, kClosed, kOpen, kReleased };

// Sets the path of all joints of one wall, in packs of `width`. Released joints, and those
// that fill up a group, lie between the block `rest` and itself, so their `joint_b` is `rest`.
inline void mark_released(const std::int32_t* joint_b, std::int32_t rest, std::int32_t joints,
                          int width, std::uint8_t* law_path) {
  for (std::int32_t pack = 0; pack < joints / width; ++pack) {
    bool released = true;
    for (int k = 0; k < width; ++k) released = released && joint_b[pack * width + k] == rest;
    law_path[pack] = released ? kReleased : kFullLaw;
  }
}

}  // namespace wythe::dynamics
