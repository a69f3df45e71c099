// Rotations of wythe/parts/vector.h.
#include "wythe/parts/vector.h"

#include "core/elementary.h"

namespace wythe {

Vec2 turned(Vec2 a, double angle) {
  const double c = elementary::cos(angle), s = elementary::sin(angle);
  return {c * a.x - s * a.y, s * a.x + c * a.y};
}

Vec3 turned(Vec3 v, const Rotation& rotation, Vec3 about) {
  const double angle = length(rotation.by);
  if (angle == 0) return about + v;
  const Vec3 k = rotation.by / angle;
  const double c = elementary::cos(angle), s = elementary::sin(angle), d = 1 - c;
  return {about.x + (c + d * k.x * k.x) * v.x + (d * k.x * k.y - s * k.z) * v.y +
              (d * k.x * k.z + s * k.y) * v.z,
          about.y + (d * k.x * k.y + s * k.z) * v.x + (c + d * k.y * k.y) * v.y +
              (d * k.y * k.z - s * k.x) * v.z,
          about.z + (d * k.x * k.z - s * k.y) * v.x + (d * k.y * k.z + s * k.x) * v.y +
              (c + d * k.z * k.z) * v.z};
}

}  // namespace wythe
