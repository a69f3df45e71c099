// Solids for tests: boxes, prisms, and any body moved to another frame.
#pragma once

#include <array>
#include <cmath>
#include <string>
#include <vector>

#include "wythe/parts/body.h"

namespace wythe::scenes {

inline Polyhedron box_part(Vec3 low, Vec3 high) {
  Polyhedron part;
  for (const double z : {low.z, high.z})
    for (const auto& [x, y] : {std::pair{low.x, low.y}, std::pair{high.x, low.y},
                               std::pair{high.x, high.y}, std::pair{low.x, high.y}})
      part.vertex.push_back({x, y, z});
  part.face = {{0, 3, 2, 1}, {4, 5, 6, 7}, {0, 1, 5, 4}, {1, 2, 6, 5}, {2, 3, 7, 6}, {3, 0, 4, 7}};
  return part;
}

inline BodySpec box_body(std::string id, Vec3 low, Vec3 high, bool fixed = false) {
  BodySpec body;
  body.id = std::move(id);
  body.part = {box_part(low, high)};
  body.fixed = fixed;
  return body;
}

// An anticlockwise outline in x, y between two depths.
inline Polyhedron prism_part(const std::vector<Vec2>& outline, double z0, double z1) {
  Polyhedron part;
  const int n = static_cast<int>(outline.size());
  for (const double z : {z0, z1})
    for (const Vec2 p : outline) part.vertex.push_back({p.x, p.y, z});
  part.face.resize(2);
  for (int i = 0; i < n; ++i) {
    part.face[0].push_back(n - 1 - i);
    part.face[1].push_back(n + i);
    part.face.push_back({i, (i + 1) % n, n + (i + 1) % n, n + i});
  }
  return part;
}

inline BodySpec body_of(std::string id, Polyhedron part, bool fixed = false) {
  BodySpec body;
  body.id = std::move(id);
  body.part = {std::move(part)};
  body.fixed = fixed;
  return body;
}

// A turn by the unit quaternion along (w, x, y, z), rows of its matrix; then a shift.
struct Frame {
  std::array<Vec3, 3> row = {Vec3{1, 0, 0}, Vec3{0, 1, 0}, Vec3{0, 0, 1}};
  Vec3 shift;

  static Frame turned(double w, double x, double y, double z, Vec3 shift = {}) {
    const double l = std::sqrt(w * w + x * x + y * y + z * z);
    w /= l, x /= l, y /= l, z /= l;
    Frame f;
    f.row = {Vec3{1 - 2 * (y * y + z * z), 2 * (x * y - w * z), 2 * (x * z + w * y)},
             Vec3{2 * (x * y + w * z), 1 - 2 * (x * x + z * z), 2 * (y * z - w * x)},
             Vec3{2 * (x * z - w * y), 2 * (y * z + w * x), 1 - 2 * (x * x + y * y)}};
    f.shift = shift;
    return f;
  }
  [[nodiscard]] Vec3 direction(Vec3 v) const {
    return {dot(row[0], v), dot(row[1], v), dot(row[2], v)};
  }
  [[nodiscard]] Vec3 point(Vec3 v) const { return direction(v) + shift; }
  [[nodiscard]] BodySpec body(BodySpec given) const {
    for (Polyhedron& part : given.part)
      for (Vec3& v : part.vertex) v = point(v);
    return given;
  }
};

}  // namespace wythe::scenes
