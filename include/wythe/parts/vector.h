// Vectors and rotations for figures in a plane and for walls in the plane or in space.
//
//   Vec2      a figure in its own plane: outlines while a wall is built, chains of macro-blocks
//   Vec3      a place, a displacement or a direction in the wall's axes: x along it, y up, z out of its
//             plane; z is 0 in a plane wall
//   Rotation  a rotation about an axis
#pragma once

#include <cmath>

namespace wythe {

struct Vec2 {
  double x = 0, y = 0;
};
[[nodiscard]] inline Vec2 operator+(Vec2 a, Vec2 b) { return {a.x + b.x, a.y + b.y}; }
[[nodiscard]] inline Vec2 operator-(Vec2 a, Vec2 b) { return {a.x - b.x, a.y - b.y}; }
[[nodiscard]] inline double dot(Vec2 a, Vec2 b) { return a.x * b.x + a.y * b.y; }
[[nodiscard]] inline double cross(Vec2 a, Vec2 b) { return a.x * b.y - a.y * b.x; }
[[nodiscard]] inline double length(Vec2 a) { return std::sqrt(dot(a, a)); }
[[nodiscard]] Vec2 turned(Vec2 a, double angle);  // anticlockwise [rad]

struct Vec3 {
  double x = 0, y = 0, z = 0;
};
[[nodiscard]] inline Vec3 operator+(Vec3 a, Vec3 b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }
[[nodiscard]] inline Vec3 operator-(Vec3 a, Vec3 b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
[[nodiscard]] inline Vec3 operator*(double s, Vec3 a) { return {s * a.x, s * a.y, s * a.z}; }
[[nodiscard]] inline Vec3 operator/(Vec3 a, double s) { return {a.x / s, a.y / s, a.z / s}; }
[[nodiscard]] inline double dot(Vec3 a, Vec3 b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
[[nodiscard]] inline Vec3 cross(Vec3 a, Vec3 b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
[[nodiscard]] inline double length(Vec3 a) { return std::sqrt(dot(a, a)); }

// Rotation about the axis `by` through the angle |by| [rad], anticlockwise seen from the tip. In a plane
// wall by.z is the angle and the other components are 0.
struct Rotation {
  Vec3 by;
};
// New place of the tip of an arm v that starts at `about`: about + R v by Rodrigues' formula,
// R v = v cos + (k x v) sin + k (k . v) (1 - cos), with the unit axis k.
[[nodiscard]] Vec3 turned(Vec3 v, const Rotation& rotation, Vec3 about = {});

}  // namespace wythe
