// Splits the faces of a convex solid at a plane and closes both halves by one face, whose corners are sorted by their angle.
// A corner within kOnPlane [m] of the plane lies on it and belongs to both halves. A difference keeps one piece for
// each plane that cuts. Parts are connected where they share more than 1e-8 m^2.
#include "geometry/bodies/solid_cut.h"

#include <algorithm>
#include <cmath>
#include <map>

#include "core/elementary.h"
#include "geometry/bodies/polygon_in_space.h"

namespace wythe::geometry {
namespace {

// Collects the corners of one half, each place once.
class Half {
 public:
  explicit Half(const Polyhedron& whole) : of_(whole.vertex.size(), -1) {}

  std::int32_t corner(std::int32_t index, Vec3 place) {
    if (of_[index] < 0) of_[index] = add(place);
    return of_[index];
  }
  // The corner where an edge crosses the plane.
  std::int32_t crossing(std::int32_t a, std::int32_t b, Vec3 place) {
    const auto key = std::minmax(a, b);
    const auto known = crossing_.find(key);
    if (known != crossing_.end()) return known->second;
    return crossing_[key] = add(place);
  }
  void add_face(std::vector<std::int32_t> face) {
    face.erase(std::unique(face.begin(), face.end()), face.end());
    while (face.size() > 1 && face.front() == face.back()) face.pop_back();
    if (face.size() >= 3) solid_.face.push_back(std::move(face));
  }
  // The face in the plane: corners on it, sorted around their mean, anticlockwise about `outward`.
  void close(const std::vector<std::int32_t>& on, Vec3 outward) {
    if (on.size() < 3) return;
    std::vector<Vec3> places;
    for (const std::int32_t i : on) places.push_back(solid_.vertex[i]);
    const PlaneAxes axes = axes_of(mean(places), outward);
    std::vector<std::pair<double, std::int32_t>> turn;
    for (const std::int32_t i : on) {
      const Vec2 p = axes.flat(solid_.vertex[i]);
      turn.emplace_back(elementary::atan2(p.y, p.x), i);
    }
    std::sort(turn.begin(), turn.end());
    std::vector<std::int32_t> face;
    for (const auto& [angle, i] : turn) face.push_back(i);
    add_face(std::move(face));
  }
  [[nodiscard]] Polyhedron take() { return std::move(solid_); }

 private:
  std::int32_t add(Vec3 place) {
    solid_.vertex.push_back(place);
    return static_cast<std::int32_t>(solid_.vertex.size()) - 1;
  }

  std::vector<std::int32_t> of_;
  std::map<std::pair<std::int32_t, std::int32_t>, std::int32_t> crossing_;
  Polyhedron solid_;
};

// The half with side[k] <= 0; `side` gives the side of each corner, `height` its distance from the plane.
Polyhedron half_of(const Polyhedron& part, const std::vector<int>& side,
                   const std::vector<double>& height, Vec3 outward) {
  Half half(part);
  std::vector<std::int32_t> on;
  const auto note = [&](std::int32_t i) {
    if (std::find(on.begin(), on.end(), i) == on.end()) on.push_back(i);
    return i;
  };
  for (const auto& corners : part.face) {
    std::vector<std::int32_t> kept;
    bool is_in_plane = true;
    for (std::size_t k = 0; k < corners.size(); ++k) {
      const std::int32_t a = corners[k], b = corners[(k + 1) % corners.size()];
      const Vec3 pa = part.vertex[a], pb = part.vertex[b];
      is_in_plane &= side[a] == 0;
      if (side[a] <= 0) {
        const std::int32_t i = half.corner(a, pa);
        kept.push_back(side[a] == 0 ? note(i) : i);
      }
      if (side[a] * side[b] < 0) {
        const double share = height[a] / (height[a] - height[b]);
        kept.push_back(note(half.crossing(a, b, pa + share * (pb - pa))));
      }
    }
    if (!is_in_plane) half.add_face(std::move(kept));
  }
  half.close(on, outward);
  return half.take();
}

double volume_of(const std::vector<Polyhedron>& parts) {
  double volume = 0;
  for (const Polyhedron& part : parts) volume += solid_moments(part).volume;
  return volume;
}

}  // namespace

Halves cut(const Polyhedron& part, Vec3 normal, double offset) {
  std::vector<double> height;
  std::vector<int> side, other;
  for (const Vec3& v : part.vertex) {
    height.push_back(dot(v, normal) - offset);
    side.push_back(height.back() > kOnPlane ? 1 : height.back() < -kOnPlane ? -1 : 0);
    other.push_back(-side.back());
  }
  const bool is_above = std::any_of(side.begin(), side.end(), [](int s) { return s > 0; });
  const bool is_below = std::any_of(side.begin(), side.end(), [](int s) { return s < 0; });
  if (!is_above) return {part, {}};
  if (!is_below) return {{}, part};
  return {half_of(part, side, height, normal), half_of(part, other, height, -1.0 * normal)};
}

std::vector<Polyhedron> rest_of(const Polyhedron& part, const Polyhedron& without) {
  std::vector<Facet> planes;
  for (const auto& face : without.face) planes.push_back(facet_of(without, face));
  std::stable_partition(planes.begin(), planes.end(),
                        [](const Facet& f) { return std::fabs(f.normal.y) > 0.5; });
  std::vector<Polyhedron> pieces;
  Polyhedron inside = part;
  for (const Facet& plane : planes) {
    Halves halves = cut(inside, plane.normal, dot(plane.centre, plane.normal));
    if (halves.below.vertex.empty()) return {part};
    if (!halves.above.vertex.empty()) pieces.push_back(std::move(halves.above));
    inside = std::move(halves.below);
  }
  return pieces;
}

double shared_area(const Polyhedron& a, const Polyhedron& b) {
  double area = 0;
  for (const auto& own : a.face)
    for (const auto& other : b.face) {
      const Facet f = facet_of(a, own), g = facet_of(b, other);
      if (dot(f.normal, g.normal) > -1 + 1e-9 ||
          std::fabs(dot(g.centre - f.centre, f.normal)) > 10 * kOnPlane)
        continue;
      const PlaneAxes axes = axes_of(f.centre, f.normal);
      Convex p, q;
      for (const Vec3& c : f.corner) p.push_back(axes.flat(c));
      for (const Vec3& c : g.corner) q.insert(q.begin(), axes.flat(c));
      const Convex both = common_part(p, q, kOnPlane);
      if (both.size() >= 3) area += area_of(both);
    }
  return area;
}

std::vector<std::vector<Polyhedron>> connected(std::vector<Polyhedron> parts) {
  constexpr double kTouch = 1e-8;  // [m^2]
  std::vector<std::vector<Polyhedron>> groups;
  while (!parts.empty()) {
    std::vector<Polyhedron> group{std::move(parts.front())};
    parts.erase(parts.begin());
    for (std::size_t k = 0; k < group.size(); ++k)
      for (std::size_t i = 0; i < parts.size();) {
        if (shared_area(group[k], parts[i]) <= kTouch) {
          ++i;
          continue;
        }
        group.push_back(std::move(parts[i]));
        parts.erase(parts.begin() + static_cast<std::ptrdiff_t>(i));
      }
    groups.push_back(std::move(group));
  }
  std::stable_sort(groups.begin(), groups.end(), [](const auto& p, const auto& q) {
    return volume_of(p) > volume_of(q) * (1 + 1e-9);
  });
  return groups;
}

}  // namespace wythe::geometry
