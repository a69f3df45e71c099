#include "dynamics/passes/near_pairs.h"

#include <algorithm>
#include <numeric>

namespace wythe::dynamics {
namespace {

bool meet(const Box& a, const Box& b, double gap) {
  for (int k = 1; k < 3; ++k)
    if (a.low[k] > b.high[k] + gap || b.low[k] > a.high[k] + gap) return false;
  return true;
}

}  // namespace

std::vector<std::pair<std::int32_t, std::int32_t>> near_pairs(const std::vector<Box>& boxes,
                                                              std::int32_t moving, double margin) {
  const auto box = [&](std::int32_t i) -> const Box& { return boxes[static_cast<std::size_t>(i)]; };
  std::vector<std::int32_t> order(boxes.size());
  std::iota(order.begin(), order.end(), 0);
  std::sort(order.begin(), order.end(), [&](std::int32_t i, std::int32_t j) {
    return box(i).low[0] != box(j).low[0] ? box(i).low[0] < box(j).low[0] : i < j;
  });
  const double gap = 2 * margin;
  std::vector<std::pair<std::int32_t, std::int32_t>> pairs;
  std::vector<std::int32_t> open;  // whose box has begun and may not have ended
  for (const std::int32_t i : order) {
    std::size_t kept = 0;
    for (const std::int32_t j : open) {
      if (box(j).high[0] + gap < box(i).low[0]) continue;
      open[kept++] = j;
      const auto [a, b] = std::minmax(i, j);
      if (a < moving && meet(box(i), box(j), gap)) pairs.emplace_back(a, b);
    }
    open.resize(kept);
    open.push_back(i);
  }
  std::sort(pairs.begin(), pairs.end());
  return pairs;
}

}  // namespace wythe::dynamics
