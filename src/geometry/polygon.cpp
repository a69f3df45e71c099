// Moments by Green's theorem about the first corner, since a distant origin would cost digits. The overlap is
// the sum over pairs of triangles, each clipped by the other (Sutherland-Hodgman).
#include "geometry/polygon.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace wythe::geometry {
namespace {

using Triangle = std::array<Vec2, 3>;

double side_of(Vec2 a, Vec2 b, Vec2 p) { return cross(b - a, p - a); }

bool holds(const Triangle& t, Vec2 p) {
  return side_of(t[0], t[1], p) >= 0 && side_of(t[1], t[2], p) >= 0 && side_of(t[2], t[0], p) >= 0;
}

bool same_point(Vec2 a, Vec2 b) { return a.x == b.x && a.y == b.y; }

bool is_ear(const Polygon& outline, const Triangle& t) {
  if (side_of(t[0], t[1], t[2]) <= 0) return false;
  return std::none_of(outline.begin(), outline.end(), [&](Vec2 p) {
    const bool is_corner = same_point(p, t[0]) || same_point(p, t[1]) || same_point(p, t[2]);
    return !is_corner && holds(t, p);
  });
}

Triangle corner(const Polygon& outline, std::size_t i) {
  const std::size_t n = outline.size();
  return {outline[(i + n - 1) % n], outline[i], outline[(i + 1) % n]};
}

// Index of an ear; of a flat corner where rounding leaves no ear.
std::size_t find_ear(const Polygon& outline) {
  for (std::size_t i = 0; i < outline.size(); ++i) {
    if (is_ear(outline, corner(outline, i))) return i;
  }
  return 0;
}

std::vector<Triangle> triangles_of(Polygon outline) {
  std::vector<Triangle> triangles;
  while (outline.size() > 3) {
    const std::size_t ear = find_ear(outline);
    triangles.push_back(corner(outline, ear));
    outline.erase(outline.begin() + static_cast<std::ptrdiff_t>(ear));
  }
  triangles.push_back({outline[0], outline[1], outline[2]});
  return triangles;
}

Vec2 crossing(Vec2 p, Vec2 q, double side_p, double side_q) {
  const double s = side_p / (side_p - side_q);
  return {p.x + s * (q.x - p.x), p.y + s * (q.y - p.y)};
}

// The part of `shape` to the left of the line a -> b.
Polygon keep_left(const Polygon& shape, Vec2 a, Vec2 b) {
  Polygon kept;
  for (std::size_t i = 0; i < shape.size(); ++i) {
    const Vec2 p = shape[i], q = shape[(i + 1) % shape.size()];
    const double side_p = side_of(a, b, p), side_q = side_of(a, b, q);
    if (side_p >= 0) kept.push_back(p);
    if ((side_p > 0 && side_q < 0) || (side_p < 0 && side_q > 0)) {
      kept.push_back(crossing(p, q, side_p, side_q));
    }
  }
  return kept;
}

double common_area(const Triangle& s, const Triangle& t) {
  Polygon shape(s.begin(), s.end());
  for (std::size_t i = 0; i < 3 && !shape.empty(); ++i) {
    shape = keep_left(shape, t[i], t[(i + 1) % 3]);
  }
  return shape.size() < 3 ? 0 : std::max(0.0, moments(shape).area);
}

int sign(double x) { return (x > 0) - (x < 0); }

bool lies_between(Vec2 a, Vec2 b, Vec2 p) {
  return std::min(a.x, b.x) <= p.x && p.x <= std::max(a.x, b.x) && std::min(a.y, b.y) <= p.y &&
         p.y <= std::max(a.y, b.y);
}

bool segments_meet(Vec2 a, Vec2 b, Vec2 c, Vec2 d) {
  if (std::max(a.x, b.x) < std::min(c.x, d.x) || std::max(c.x, d.x) < std::min(a.x, b.x) ||
      std::max(a.y, b.y) < std::min(c.y, d.y) || std::max(c.y, d.y) < std::min(a.y, b.y))
    return false;
  const int c_side = sign(side_of(a, b, c)), d_side = sign(side_of(a, b, d));
  const int a_side = sign(side_of(c, d, a)), b_side = sign(side_of(c, d, b));
  if (c_side * d_side < 0 && a_side * b_side < 0) return true;
  return (c_side == 0 && lies_between(a, b, c)) || (d_side == 0 && lies_between(a, b, d)) ||
         (a_side == 0 && lies_between(c, d, a)) || (b_side == 0 && lies_between(c, d, b));
}

// Neighbouring edges may share their corner but must not fold back.
bool folds_back(const Triangle& t) {
  return side_of(t[0], t[1], t[2]) == 0 && dot(t[1] - t[0], t[2] - t[1]) <= 0;
}

}  // namespace

Polygon part_inside(const Polygon& outline, const Polygon& convex) {
  Polygon shape = outline;
  for (std::size_t i = 0; i < convex.size() && !shape.empty(); ++i)
    shape = keep_left(shape, convex[i], convex[(i + 1) % convex.size()]);
  return shape.size() < 3 ? Polygon{} : shape;
}

PolygonMoments moments(const Polygon& outline) {
  PolygonMoments m;
  if (outline.empty()) return m;
  const Vec2 origin = outline.front();
  double area = 0, sx = 0, sy = 0, polar = 0;
  for (std::size_t i = 0; i < outline.size(); ++i) {
    const Vec2 p = outline[i] - origin, q = outline[(i + 1) % outline.size()] - origin;
    const double c = cross(p, q);
    area += c / 2;
    sx += c * (p.x + q.x) / 6;
    sy += c * (p.y + q.y) / 6;
    polar += c * (dot(p, p) + dot(p, q) + dot(q, q)) / 12;
  }
  if (area == 0) return m;
  const Vec2 centre{sx / area, sy / area};
  m.area = area;
  m.centroid = {origin.x + centre.x, origin.y + centre.y};
  m.polar = polar - area * dot(centre, centre);
  return m;
}

Polygon polygon_of(const std::vector<Vec3>& corners) {
  Polygon outline;
  for (const Vec3& corner : corners) outline.push_back({corner.x, corner.y});
  return outline;
}

Polygon outline_of(const Rect& r) {
  return {{r.x0, r.y0}, {r.x1, r.y0}, {r.x1, r.y1}, {r.x0, r.y1}};
}

Rect bounds(const Polygon& outline) {
  Rect r{outline[0].x, outline[0].y, outline[0].x, outline[0].y};
  for (const Vec2& p : outline) r = join(r, {p.x, p.y, p.x, p.y});
  return r;
}

Rect join(const Rect& a, const Rect& b) {
  return {std::min(a.x0, b.x0), std::min(a.y0, b.y0), std::max(a.x1, b.x1), std::max(a.y1, b.y1)};
}

bool overlaps(const Rect& a, const Rect& b, double margin) {
  return std::min(a.x1, b.x1) - std::max(a.x0, b.x0) > margin &&
         std::min(a.y1, b.y1) - std::max(a.y0, b.y0) > margin;
}

bool is_simple(const Polygon& outline) {
  const std::size_t n = outline.size();
  for (std::size_t i = 0; i < n; ++i) {
    if (folds_back(corner(outline, i))) return false;
    for (std::size_t j = i + 2; j < n; ++j) {
      if (i == 0 && j == n - 1) continue;
      if (segments_meet(outline[i], outline[i + 1], outline[j], outline[(j + 1) % n])) return false;
    }
  }
  return true;
}

bool is_upright_rectangle(const Polygon& outline, double tolerance) {
  if (outline.size() != 4) return false;
  for (std::size_t i = 0; i < 4; ++i) {
    const Vec2 edge = outline[(i + 1) % 4] - outline[i];
    if (std::min(std::abs(edge.x), std::abs(edge.y)) > tolerance) return false;
  }
  return true;
}

double overlap_area(const Polygon& a, const Polygon& b) {
  double area = 0;
  const std::vector<Triangle> parts_of_b = triangles_of(b);
  for (const Triangle& s : triangles_of(a)) {
    for (const Triangle& t : parts_of_b) area += common_area(s, t);
  }
  return area;
}

namespace {

// Sine of the angle below which a corner counts as straight.
constexpr double kStraight = 1e-9;

double turn_at(const Polygon& outline, std::size_t i) {
  const Triangle t = corner(outline, i);
  const Vec2 before = t[1] - t[0], after = t[2] - t[1];
  return cross(before, after) / (length(before) * length(after));
}

Polygon without_straight_corners(Polygon outline) {
  for (std::size_t i = outline.size(); i-- > 0 && outline.size() > 3;)
    if (std::abs(turn_at(outline, i)) <= kStraight)
      outline.erase(outline.begin() + static_cast<std::ptrdiff_t>(i));
  return outline;
}

bool is_convex(const Polygon& outline) {
  for (std::size_t i = 0; i < outline.size(); ++i)
    if (turn_at(outline, i) < -kStraight) return false;
  return true;
}

// The union of both polygons along their common edge; empty where they share none.
Polygon joined(const Polygon& a, const Polygon& b) {
  for (std::size_t i = 0; i < a.size(); ++i) {
    const Vec2 p = a[i], q = a[(i + 1) % a.size()];
    for (std::size_t k = 0; k < b.size(); ++k) {
      if (!same_point(b[k], q) || !same_point(b[(k + 1) % b.size()], p)) continue;
      Polygon both;
      for (std::size_t n = 0; n < a.size(); ++n) both.push_back(a[(i + 1 + n) % a.size()]);
      for (std::size_t n = 2; n < b.size(); ++n) both.push_back(b[(k + n) % b.size()]);
      return both;
    }
  }
  return {};
}

}  // namespace

std::vector<Polygon> convex_parts(const Polygon& outline) {
  const Polygon clean = without_straight_corners(outline);
  if (is_convex(clean)) return {clean};
  std::vector<Polygon> parts;
  for (const Triangle& t : triangles_of(clean)) parts.emplace_back(t.begin(), t.end());
  // join triangles again while the result is convex
  for (std::size_t i = 0; i < parts.size(); ++i)
    for (std::size_t k = i + 1; k < parts.size();) {
      const Polygon both = joined(parts[i], parts[k]);
      if (both.empty() || !is_convex(both)) {
        ++k;
        continue;
      }
      parts[i] = both;
      parts.erase(parts.begin() + static_cast<std::ptrdiff_t>(k));
      k = i + 1;
    }
  for (Polygon& part : parts) part = without_straight_corners(part);
  return parts;
}

Polygon bevelled(const Polygon& convex, double bevel) {
  constexpr double kMostOfEdge = 0.25;
  Polygon cut;
  for (std::size_t i = 0; i < convex.size(); ++i) {
    const Triangle t = corner(convex, i);
    const auto towards = [&](Vec2 other) {
      const Vec2 edge = other - t[1];
      const double share = std::min(kMostOfEdge, bevel / length(edge));
      return Vec2{t[1].x + share * edge.x, t[1].y + share * edge.y};
    };
    cut.push_back(towards(t[0]));
    cut.push_back(towards(t[2]));
  }
  return cut;
}

}  // namespace wythe::geometry
