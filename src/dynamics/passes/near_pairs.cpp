#include "dynamics/passes/near_pairs.h"

#include <algorithm>
#include <numeric>

namespace wythe::dynamics {
namespace {

std::size_t at(std::int32_t i) { return static_cast<std::size_t>(i); }

// The axis along which the moving boxes are spread most: there the fewest are open at a time.
int widest_axis(const std::vector<Box>& boxes, std::int32_t moving) {
  int widest = 0;
  double most = -1;
  for (int k = 0; k < 3; ++k) {
    double low = 1e300, high = -1e300;
    for (std::size_t i = 0; i < at(moving); ++i) {
      low = std::min(low, boxes[i].low[k]);
      high = std::max(high, boxes[i].low[k]);
    }
    if (high - low > most) most = high - low, widest = k;
  }
  return widest;
}

using Pairs = std::vector<std::pair<std::int32_t, std::int32_t>>;

// By a, then by b: those of each a are few.
Pairs sorted(const Pairs& pairs, std::int32_t moving) {
  std::vector<std::size_t> begin(at(moving) + 1, 0);
  for (const auto& [a, b] : pairs) ++begin[at(a) + 1];
  std::partial_sum(begin.begin(), begin.end(), begin.begin());
  Pairs out(pairs.size());
  std::vector<std::size_t> next(begin.begin(), begin.end() - 1);
  for (const auto& pair : pairs) out[next[at(pair.first)]++] = pair;
  const auto place = [&](std::size_t k) { return out.begin() + static_cast<std::ptrdiff_t>(k); };
  for (std::size_t a = 0; a < at(moving); ++a) std::sort(place(begin[a]), place(begin[a + 1]));
  return out;
}

}  // namespace

Pairs near_pairs(const std::vector<Box>& boxes, std::int32_t moving, double margin) {
  const int x = widest_axis(boxes, moving), y = (x + 1) % 3, z = (x + 2) % 3;
  const double gap = 2 * margin;
  const auto apart = [gap](const Box& a, const Box& b, int axis) {
    return a.low[axis] > b.high[axis] + gap || b.low[axis] > a.high[axis] + gap;
  };
  std::vector<std::int32_t> order(boxes.size());
  std::iota(order.begin(), order.end(), 0);
  std::sort(order.begin(), order.end(), [&](std::int32_t i, std::int32_t j) {
    const double li = boxes[at(i)].low[x], lj = boxes[at(j)].low[x];
    return li != lj ? li < lj : i < j;
  });
  Pairs pairs;
  std::vector<std::int32_t> open;  // whose box has begun and may not have ended
  for (const std::int32_t i : order) {
    const Box& box = boxes[at(i)];
    std::size_t kept = 0;
    for (const std::int32_t j : open) {
      const Box& other = boxes[at(j)];
      if (other.high[x] + gap < box.low[x]) continue;
      open[kept++] = j;
      if (apart(box, other, y) || apart(box, other, z)) continue;
      if (const auto [a, b] = std::minmax(i, j); a < moving) pairs.emplace_back(a, b);
    }
    open.resize(kept);
    open.push_back(i);
  }
  return sorted(pairs, moving);
}

}  // namespace wythe::dynamics
