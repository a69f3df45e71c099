// triangulate(): ear clipping, the best shaped ear first, then even division of every triangle.
#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include "core/elementary.h"
#include "solids/mesh.h"

namespace wythe::solids {
namespace {

using Ear = std::array<std::int32_t, 3>;

double twice_area(const Outline& o, const Ear& t) {
  const auto a = static_cast<std::size_t>(t[0]), b = static_cast<std::size_t>(t[1]),
             c = static_cast<std::size_t>(t[2]);
  return (o.x[b] - o.x[a]) * (o.y[c] - o.y[a]) - (o.x[c] - o.x[a]) * (o.y[b] - o.y[a]);
}

double longest_side(const Outline& o, const Ear& t) {
  double longest = 0;
  for (std::size_t k = 0; k < 3; ++k) {
    const auto p = static_cast<std::size_t>(t[k]), q = static_cast<std::size_t>(t[(k + 1) % 3]);
    longest = std::max(longest, elementary::hypot(o.x[q] - o.x[p], o.y[q] - o.y[p]));
  }
  return longest;
}

// Height over longest side of an ear; 0 where another corner of the outline lies in it.
double quality(const Outline& o, const Ear& ear, const std::vector<std::int32_t>& left) {
  const double area = twice_area(o, ear), side = longest_side(o, ear);
  if (!(area > 0)) return 0;
  for (const std::int32_t p : left) {
    if (p == ear[0] || p == ear[1] || p == ear[2]) continue;
    const bool inside = twice_area(o, {ear[0], ear[1], p}) >= 0 &&
                        twice_area(o, {ear[1], ear[2], p}) >= 0 &&
                        twice_area(o, {ear[2], ear[0], p}) >= 0;
    if (inside) return 0;
  }
  return area / (side * side);
}

std::vector<Ear> cut_ears(const Outline& o) {
  std::vector<std::int32_t> left(o.x.size());
  for (std::size_t k = 0; k < left.size(); ++k) left[k] = static_cast<std::int32_t>(k);
  std::vector<Ear> ears;
  while (left.size() >= 3) {
    const std::size_t n = left.size();
    std::size_t best = n;
    double most = 0;
    for (std::size_t k = 0; k < n; ++k) {
      const double q = quality(o, {left[(k + n - 1) % n], left[k], left[(k + 1) % n]}, left);
      if (q > most) {
        most = q;
        best = k;
      }
    }
    if (best == n) break;  // the rest has no area: collinear corners
    ears.push_back({left[(best + n - 1) % n], left[best], left[(best + 1) % n]});
    left.erase(left.begin() + static_cast<std::ptrdiff_t>(best));
  }
  return ears;
}

// Numbers the nodes: first corners, then those on edges, then those inside.
class Divider {
 public:
  explicit Divider(const Outline& outline) : outline_(outline), n_(outline.parts) {
    mesh_.x = outline.x;
    mesh_.y = outline.y;
  }

  Triangles run() {
    mesh_.shortest_height = HUGE_VAL;
    for (const Ear& ear : cut_ears(outline_)) divide(ear);
    const auto corners = static_cast<std::int32_t>(outline_.x.size());
    for (std::int32_t k = 0; k < corners; ++k)
      for (int part = 0; part < n_; ++part)
        mesh_.rim.push_back(on_edge(k, (k + 1) % corners, part));
    return std::move(mesh_);
  }

 private:
  std::int32_t add(double x, double y) {
    mesh_.x.push_back(x);
    mesh_.y.push_back(y);
    return static_cast<std::int32_t>(mesh_.x.size()) - 1;
  }

  // Node `part` of n on the edge from a to b. Nodes of an edge are created once, from its lower corner.
  std::int32_t on_edge(std::int32_t a, std::int32_t b, int part) {
    if (part == 0) return a;
    if (part == n_) return b;
    if (a > b) return on_edge(b, a, n_ - part);
    const auto [found, is_new] =
        edge_.try_emplace({a, b}, static_cast<std::int32_t>(mesh_.x.size()));
    const auto p = static_cast<std::size_t>(a), q = static_cast<std::size_t>(b);
    for (int k = 1; k < n_ && is_new; ++k) {
      const double share = static_cast<double>(k) / n_;
      add(mesh_.x[p] + share * (mesh_.x[q] - mesh_.x[p]),
          mesh_.y[p] + share * (mesh_.y[q] - mesh_.y[p]));
    }
    return found->second + part - 1;
  }

  // Node i steps along the first side and j steps along the last, i + j <= n.
  std::int32_t in_ear(const Ear& ear, int i, int j) {
    if (j == 0) return on_edge(ear[0], ear[1], i);
    if (i == 0) return on_edge(ear[0], ear[2], j);
    if (i + j == n_) return on_edge(ear[1], ear[2], j);
    const auto [found, is_new] = inner_.try_emplace({i, j}, 0);
    if (is_new) {
      const auto a = static_cast<std::size_t>(ear[0]), b = static_cast<std::size_t>(ear[1]),
                 c = static_cast<std::size_t>(ear[2]);
      const double u = static_cast<double>(i) / n_, v = static_cast<double>(j) / n_;
      found->second =
          add(mesh_.x[a] + u * (mesh_.x[b] - mesh_.x[a]) + v * (mesh_.x[c] - mesh_.x[a]),
              mesh_.y[a] + u * (mesh_.y[b] - mesh_.y[a]) + v * (mesh_.y[c] - mesh_.y[a]));
    }
    return found->second;
  }

  void divide(const Ear& ear) {
    inner_.clear();
    for (int j = 0; j < n_; ++j)
      for (int i = 0; i + j < n_; ++i) {
        mesh_.corner.push_back({in_ear(ear, i, j), in_ear(ear, i + 1, j), in_ear(ear, i, j + 1)});
        if (i + j + 1 < n_)
          mesh_.corner.push_back(
              {in_ear(ear, i + 1, j), in_ear(ear, i + 1, j + 1), in_ear(ear, i, j + 1)});
      }
    const double side = longest_side(outline_, ear) / n_;
    mesh_.longest = std::max(mesh_.longest, side);
    mesh_.shortest_height =
        std::min(mesh_.shortest_height, twice_area(outline_, ear) / (n_ * n_) / side);
  }

  const Outline& outline_;
  int n_;
  Triangles mesh_;
  std::map<std::pair<std::int32_t, std::int32_t>, std::int32_t> edge_;  // first node on an edge
  std::map<std::pair<int, int>, std::int32_t> inner_;
};

}  // namespace

Triangles triangulate(const Outline& outline) { return Divider(outline).run(); }

}  // namespace wythe::solids
