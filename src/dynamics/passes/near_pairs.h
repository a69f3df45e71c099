// Which bodies may touch: boxes widened by a margin, sorted along the wall and swept.
//
//   near_pairs(boxes, margin)   pairs (a, b), a < b, a < moving, whose widened boxes meet, sorted
//
// A pair that is left out cannot touch before one of its bodies has moved by the margin. The caller adds up
// how far bodies can have moved (Travel) and searches again in time. The order of ties has no influence.
#pragma once

#include <cstdint>
#include <utility>
#include <vector>

namespace wythe::dynamics {

struct Box {
  double low[3], high[3];
};

[[nodiscard]] std::vector<std::pair<std::int32_t, std::int32_t>> near_pairs(
    const std::vector<Box>& boxes, std::int32_t moving, double margin);

}  // namespace wythe::dynamics
