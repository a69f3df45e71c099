// Sweeps along the axis on which the moving boxes are spread most, in strips along the next widest axis
// (docs/theory/contacts.md, "Who may touch"). A pair that shares several strips is found in the first of them only.
// Equal places are ordered by number and pairs are sorted at the end, so the result depends only on the boxes.
#include "dynamics/passes/near_pairs.h"

#include <algorithm>
#include <array>
#include <numeric>

namespace wythe::dynamics {
namespace {

// Axes, sorted by the spread of the moving boxes, widest first: there the fewest boxes overlap at a time.
std::array<int, 3> axes_by_spread(const std::vector<Box>& boxes, std::int32_t moving) {
  double spread[3];
  for (int k = 0; k < 3; ++k) {
    double low = 1e300, high = -1e300;
    for (std::size_t i = 0; i < static_cast<std::size_t>(moving); ++i) {
      low = std::min(low, boxes[i].low[k]);
      high = std::max(high, boxes[i].low[k]);
    }
    spread[k] = high - low;
  }
  std::array<int, 3> axes{0, 1, 2};
  std::stable_sort(axes.begin(), axes.end(), [&](int i, int j) { return spread[i] > spread[j]; });
  return axes;
}

// Strips across the sweep, twice as wide as an average moving box. Boxes in different strips are not compared.
struct Strips {
  double low = 1e300, width = 1;
  std::size_t count = 1;

  Strips(const std::vector<Box>& boxes, std::int32_t moving, int axis) {
    double high = -1e300, sizes = 0;
    for (std::size_t i = 0; i < static_cast<std::size_t>(moving); ++i) {
      low = std::min(low, boxes[i].low[axis]);
      high = std::max(high, boxes[i].high[axis]);
      sizes += boxes[i].high[axis] - boxes[i].low[axis];
    }
    width = 2 * sizes / std::max(1, moving);
    if (width > 0 && high > low)
      count = static_cast<std::size_t>(std::min((high - low) / width, 1.0 * moving)) + 1;
  }
  // The strip of a place. Places outside belong to the first or the last strip.
  [[nodiscard]] std::size_t of(double place) const {
    const double strip = (place - low) / width, last = static_cast<double>(count - 1);
    return strip > 0 ? static_cast<std::size_t>(std::min(strip, last)) : 0;
  }
};

using Pairs = std::vector<std::pair<std::int32_t, std::int32_t>>;

// Sorted by a, then by b. Each a has few pairs.
Pairs sorted(const Pairs& pairs, std::int32_t moving) {
  std::vector<std::size_t> begin(static_cast<std::size_t>(moving) + 1, 0);
  for (const auto& [a, b] : pairs) ++begin[a + 1];
  std::partial_sum(begin.begin(), begin.end(), begin.begin());
  Pairs out(pairs.size());
  std::vector<std::size_t> next(begin.begin(), begin.end() - 1);
  for (const auto& pair : pairs) out[next[pair.first]++] = pair;
  const auto place = [&](std::size_t k) { return out.begin() + static_cast<std::ptrdiff_t>(k); };
  for (std::size_t a = 0; a < static_cast<std::size_t>(moving); ++a)
    std::sort(place(begin[a]), place(begin[a + 1]));
  return out;
}

}  // namespace

Pairs near_pairs(const std::vector<Box>& boxes, std::int32_t moving, double margin) {
  const std::array<int, 3> axes = axes_by_spread(boxes, moving);
  const int x = axes[0], y = axes[1], z = axes[2];
  const double gap = 2 * margin;
  std::vector<std::int32_t> order(boxes.size());
  std::iota(order.begin(), order.end(), 0);
  std::sort(order.begin(), order.end(), [&](std::int32_t i, std::int32_t j) {
    const double li = boxes[i].low[x], lj = boxes[j].low[x];
    return li != lj ? li < lj : i < j;
  });
  // each box in all strips that it reaches, in the order of the sweep
  const Strips strips(boxes, moving, y);
  std::vector<std::vector<std::int32_t>> of_strip(strips.count);
  for (const std::int32_t i : order) {
    const std::size_t last = strips.of(boxes[i].high[y] + gap);
    for (std::size_t k = strips.of(boxes[i].low[y]); k <= last; ++k) of_strip[k].push_back(i);
  }
  Pairs pairs;
  std::vector<Box> in_strip;
  for (std::size_t strip = 0; strip < strips.count; ++strip) {
    const std::vector<std::int32_t>& bodies = of_strip[strip];
    in_strip.clear();
    for (const std::int32_t i : bodies) in_strip.push_back(boxes[i]);
    for (std::size_t i = 0; i < bodies.size(); ++i) {
      const Box& box = in_strip[i];
      const double end = box.high[x] + gap;
      for (std::size_t j = i + 1; j < bodies.size() && in_strip[j].low[x] <= end; ++j) {
        const Box& other = in_strip[j];
        const auto apart = [&](int axis) {
          return other.low[axis] > box.high[axis] + gap || box.low[axis] > other.high[axis] + gap;
        };
        if (apart(y) || apart(z)) continue;
        // two boxes that share several strips are compared in the first one only
        if (strips.of(std::max(box.low[y], other.low[y])) != strip) continue;
        if (const auto [a, b] = std::minmax(bodies[i], bodies[j]); a < moving)
          pairs.emplace_back(a, b);
      }
    }
  }
  return sorted(pairs, moving);
}

}  // namespace wythe::dynamics
