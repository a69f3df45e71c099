// Solids with flat faces: mass properties; and the geometry of a polygon in space.
//
// Called by joint_faces.cpp, body_checks.cpp and convex_parts.cpp, and by src/model for masses. Uses only + - x / and
// square roots, so that the bits are the same everywhere.
#pragma once

#include <array>
#include <cmath>
#include <cstdint>
#include <span>
#include <vector>

#include "wythe/parts/body.h"
#include "wythe/parts/vector.h"

namespace wythe::geometry {

// Volume [m^3], centroid [m] and moments of inertia about the centroid per unit of density [m^5], in the
// wall's axes: xx, yy, zz, xy, xz, yz, with Ixx = int (y^2 + z^2) dV and Ixy = -int x y dV.
struct SolidMoments {
  double volume = 0;
  Vec3 centroid;
  std::array<double, 6> inertia{};
};

// Exact for flat faces, convex or not: tetrahedra connect every face, divided from the mean of its corners. The result does not
// depend on the first corner of a warped face or on its side. Sums over the parts.
[[nodiscard]] SolidMoments solid_moments(const BodySpec& body);
[[nodiscard]] SolidMoments solid_moments(const Polyhedron& part);

// As length(), by the square root of the dot product, without libm.
[[nodiscard]] inline double norm(Vec3 v) { return std::sqrt(dot(v, v)); }
[[nodiscard]] inline Vec3 unit(Vec3 v) {
  const double l = norm(v);
  return l > 0 ? v / l : Vec3{};
}
[[nodiscard]] inline Vec3 mean(std::span<const Vec3> points) {
  Vec3 sum;
  for (const Vec3 p : points) sum = sum + p;
  return sum / static_cast<double>(points.size());
}

// A polygon in space and its mean plane: normal of Newell's sum, centroid of its area, and largest distance of its
// corners from that plane.
struct Facet {
  std::vector<Vec3> corner;
  Vec3 normal, centre;
  double area = 0;
  double warp = 0;
};
[[nodiscard]] Facet measured(std::vector<Vec3> corners);
[[nodiscard]] Facet facet_of(const Polyhedron& part, std::span<const std::int32_t> corners);

struct Box3 {
  Vec3 low, high;
  [[nodiscard]] double longest() const {
    return std::fmax(high.x - low.x, std::fmax(high.y - low.y, high.z - low.z));
  }
};
[[nodiscard]] Box3 box_of(std::span<const Vec3> points);
[[nodiscard]] Box3 box_of(const BodySpec& body);
[[nodiscard]] Box3 join(const Box3& a, const Box3& b);
// Whether the boxes meet, each widened by half of `margin`.
[[nodiscard]] bool near(const Box3& a, const Box3& b, double margin);

}  // namespace wythe::geometry
