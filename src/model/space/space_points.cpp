// Places the points of a rule on a face, with shares of its area that sum to 1.
// Shares on a quadrilateral are divided by their sum. On other polygons, coinciding points of triangles become one
// point with the sum of their shares. Corners are relative to the centre of the area, where the fan begins.
#include "model/space/space_points.h"

#include <cmath>

namespace wythe {
namespace {

Vec2 mix(double a, Vec2 p, double b, Vec2 q) { return {a * p.x + b * q.x, a * p.y + b * q.y}; }

// Adds the share to an existing point at this place, or adds a new point.
void add(FacePoints& points, Vec2 place, double share, double near) {
  for (std::size_t k = 0; k < points.r1.size(); ++k)
    if (std::fabs(points.r1[k] - place.x) <= near && std::fabs(points.r2[k] - place.y) <= near) {
      points.share[k] += share;
      return;
    }
  points.r1.push_back(place.x);
  points.r2.push_back(place.y);
  points.share.push_back(share);
}

FacePoints on_quadrilateral(std::span<const Vec2> c, const FaceQuadrature& rule) {
  FacePoints points;
  double sum = 0;
  const std::size_t n = rule.xi.size();
  for (std::size_t j = 0; j < n; ++j)
    for (std::size_t i = 0; i < n; ++i) {
      const double x = rule.xi[i], y = rule.xi[j];
      const Vec2 low = mix(0.5 * (1 - x), c[0], 0.5 * (1 + x), c[1]);
      const Vec2 high = mix(0.5 * (1 - x), c[3], 0.5 * (1 + x), c[2]);
      const Vec2 place = mix(0.5 * (1 - y), low, 0.5 * (1 + y), high);
      const Vec2 along = mix(0.5 * (1 - y), c[1] - c[0], 0.5 * (1 + y), c[2] - c[3]);
      const double weight = rule.weight[i] * rule.weight[j] * cross(along, high - low);
      points.r1.push_back(place.x);
      points.r2.push_back(place.y);
      points.share.push_back(weight);
      sum += weight;
    }
  for (double& share : points.share) share /= sum;
  return points;
}

FacePoints on_polygon(std::span<const Vec2> c, bool corners) {
  FacePoints points;
  const std::size_t n = c.size();
  double area = 0, size = 0;
  for (std::size_t k = 0; k < n; ++k) {
    area += cross(c[k], c[(k + 1) % n]);
    size = std::fmax(size, length(c[k]));
  }
  const double near = 1e-9 * size;
  for (std::size_t k = 0; k < n; ++k) {
    const Vec2 triangle[3] = {{0, 0}, c[k], c[(k + 1) % n]};
    const double share = cross(triangle[1], triangle[2]) / area;
    for (int v = 0; v < 3; ++v) {
      const Vec2 p = triangle[v], q = triangle[(v + 1) % 3];
      if (corners) {
        add(points, p, share / 3, near);
      } else {
        add(points, p, share / 20, near);
        add(points, mix(0.5, p, 0.5, q), share * 2 / 15, near);
      }
    }
    if (!corners)
      add(points, mix(1.0 / 3, triangle[1], 1.0 / 3, triangle[2]), share * 9 / 20, near);
  }
  return points;
}

}  // namespace

FacePoints points_on(std::span<const Vec2> corner, const QuadratureChoice& choice) {
  if (corner.size() == 4) return on_quadrilateral(corner, face_points(choice.rule, choice.points));
  return on_polygon(corner, choice.rule == PointRule::kCorners);
}

}  // namespace wythe
