// Clips convex polygons by the lines of another's edges, one edge at a time (Sutherland and Hodgman). A corner within
// the tolerance of a line belongs to both sides and is not duplicated. The rest is what each edge clips, in turn.
#include "geometry/bodies/polygon_in_space.h"

#include <cmath>

#include "geometry/bodies/polyhedron.h"

namespace wythe::geometry {
namespace {

double distance(Vec2 a, Vec2 b) { return std::sqrt(dot(a - b, a - b)); }

// Height of p above the line from a to b, to its left.
double height(Vec2 a, Vec2 b, Vec2 p) {
  const Vec2 along = b - a;
  const double l = std::sqrt(dot(along, along));
  return l > 0 ? cross(along, p - a) / l : 0;
}

// Intersection of a line with the segment from p to q, whose heights hp and hq have opposite signs.
Vec2 crossing(Vec2 p, Vec2 q, double hp, double hq) {
  const double t = hp / (hp - hq);
  return {p.x + t * (q.x - p.x), p.y + t * (q.y - p.y)};
}

// The part on the left of the line from a to b (side 1) or on its right (side -1).
Convex half(const Convex& polygon, Vec2 a, Vec2 b, double side, double tolerance) {
  Convex kept;
  const std::size_t n = polygon.size();
  for (std::size_t i = 0; i < n; ++i) {
    const Vec2 p = polygon[i], q = polygon[(i + 1) % n];
    const double hp = side * height(a, b, p), hq = side * height(a, b, q);
    if (hp >= -tolerance) kept.push_back(p);
    const bool crosses = (hp > tolerance && hq < -tolerance) || (hp < -tolerance && hq > tolerance);
    if (crosses) kept.push_back(crossing(p, q, hp, hq));
  }
  return kept;
}

}  // namespace

PlaneAxes axes_of(Vec3 origin, Vec3 normal) {
  const double x = std::abs(normal.x), y = std::abs(normal.y), z = std::abs(normal.z);
  Vec3 aside = {1, 0, 0};  // axis most oblique to the normal
  if (y < x && y <= z) aside = {0, 1, 0};
  if (z < x && z < y) aside = {0, 0, 1};
  PlaneAxes axes{.origin = origin, .u = {}, .v = {}, .normal = normal};
  axes.v = unit(cross(normal, aside));
  axes.u = cross(axes.v, normal);
  return axes;
}

double area_of(const Convex& polygon) {
  double twice = 0;
  for (std::size_t i = 1; i + 1 < polygon.size(); ++i)
    twice += cross(polygon[i] - polygon[0], polygon[i + 1] - polygon[0]);
  return twice / 2;
}

double breadth_of(const Convex& polygon) {
  double girth = 0;
  for (std::size_t i = 0; i < polygon.size(); ++i)
    girth += distance(polygon[i], polygon[(i + 1) % polygon.size()]);
  return girth > 0 ? 2 * area_of(polygon) / girth : 0;
}

Vec2 centroid_of(const Convex& polygon) {
  double sum = 0;
  Vec2 at{};
  for (std::size_t i = 1; i + 1 < polygon.size(); ++i) {
    const Vec2 p = polygon[i] - polygon[0], q = polygon[i + 1] - polygon[0];
    const double c = cross(p, q);
    sum += c;
    at = {at.x + c * (p.x + q.x) / 3, at.y + c * (p.y + q.y) / 3};
  }
  if (sum == 0) return polygon.empty() ? Vec2{} : polygon[0];
  return {polygon[0].x + at.x / sum, polygon[0].y + at.y / sum};
}

bool is_convex(const Convex& polygon, double tolerance) {
  const std::size_t n = polygon.size();
  for (std::size_t i = 0; i < n; ++i)
    for (std::size_t k = 0; k < n; ++k)
      if (height(polygon[i], polygon[(i + 1) % n], polygon[k]) < -tolerance) return false;
  return n >= 3;
}

Convex without_idle_corners(const Convex& polygon, double tolerance) {
  Convex kept;
  for (const Vec2 p : polygon)
    if (kept.empty() || distance(kept.back(), p) > tolerance) kept.push_back(p);
  while (kept.size() > 1 && distance(kept.front(), kept.back()) <= tolerance) kept.pop_back();
  for (std::size_t i = 0; kept.size() > 2 && i < kept.size();) {
    const std::size_t n = kept.size();
    const Vec2 before = kept[(i + n - 1) % n], after = kept[(i + 1) % n];
    if (std::abs(height(before, after, kept[i])) <= tolerance)
      kept.erase(kept.begin() + static_cast<std::ptrdiff_t>(i));
    else
      ++i;
  }
  return kept.size() >= 3 ? kept : Convex{};
}

Convex common_part(const Convex& polygon, const Convex& by, double tolerance) {
  Convex rest = polygon;
  for (std::size_t i = 0; i < by.size() && rest.size() >= 3; ++i)
    rest = half(rest, by[i], by[(i + 1) % by.size()], 1, tolerance);
  return without_idle_corners(rest, tolerance);
}

std::vector<Convex> rest_of(const Convex& polygon, const Convex& without, double tolerance) {
  std::vector<Convex> pieces;
  Convex inside = polygon;
  for (std::size_t i = 0; i < without.size() && inside.size() >= 3; ++i) {
    const Vec2 a = without[i], b = without[(i + 1) % without.size()];
    Convex outside = without_idle_corners(half(inside, a, b, -1, tolerance), tolerance);
    if (outside.size() >= 3) pieces.push_back(std::move(outside));
    inside = half(inside, a, b, 1, tolerance);
  }
  return pieces;
}

std::optional<Convex> united(const Convex& a, const Convex& b, double tolerance) {
  const std::size_t n = a.size(), m = b.size();
  for (std::size_t i = 0; i < n; ++i)
    for (std::size_t j = 0; j < m; ++j) {
      const bool shared = distance(a[i], b[(j + 1) % m]) <= tolerance &&
                          distance(a[(i + 1) % n], b[j]) <= tolerance;
      if (!shared) continue;
      Convex both;
      for (std::size_t k = 0; k < n; ++k) both.push_back(a[(i + 1 + k) % n]);
      for (std::size_t k = 2; k < m; ++k) both.push_back(b[(j + k) % m]);
      both = without_idle_corners(both, tolerance);
      if (is_convex(both, tolerance)) return both;
    }
  return std::nullopt;
}

}  // namespace wythe::geometry
