// Contact of two convex parts in the plane: their overlap and its force
// (docs/theory/contacts.md, "Two parts in the plane").
//
//         other            One edge of one part is the face of the contact: of all edges of both parts, the one
//     \           /        with the least penetration. In its axes (x along it, n out of its
//      \         /         part) the other part reaches d(x) below the edge, and
//   ====\-------/===> x
//        \_____/  d(x)         V = kn t / 2  integral of d^2 dx            over the edge alone
//     ref
//
// is the energy of the contact. Force and moment are its derivatives, so the work of loading is returned on
// unloading. Where the other part extends beyond an end of the edge, at depth d there, this end has a force
// kn t d^2 / 2 along the edge.
//
// Called by the step (dynamics/passes/free_contacts.h) and by the reader of states (reading/free_contacts.cpp).
#pragma once

#include <cmath>
#include <limits>
#include <vector>

#include "contact/law_constants.h"
#include "core/real.h"
#include "wythe/parts/free_contacts.h"

namespace wythe::contact {

// The nearest multiple of 2^-40 m (1e-12 m). Corners relative to their centroid lie on this grid, so that equal units have
// one shape wherever they stand.
[[nodiscard]] inline double on_grid(double v) {
  constexpr double kCells = 0x1p40;
  return std::nearbyint(v * kCells) / kCells;
}

// Axes of an edge in those of its body: origin at its far end, so that x, n are right-handed. Fills a cache line.
struct alignas(64) EdgeAxes {
  double x, y, ax, ay, nx, ny, length;
};
// A part: corners in the axes of its body, x beside y, anticlockwise; edge i starts at corner i.
struct Part {
  const double* corner;
  const EdgeAxes* edge;
  int corners;
};
[[nodiscard]] WYTHE_INLINE const EdgeAxes& axes_of(const Part& part, int edge) {
  return part.edge[edge];
}

// Corners and edges of all parts. Parts of one shape share them, so that they stay in the cache.
struct PartEdges {
  struct Range {
    std::int32_t first, corners, shape;
  };
  std::vector<Range> range;  // of each part
  std::vector<Range> shape;  // of each shape
  std::vector<double> corner;
  std::vector<EdgeAxes> edge;
  explicit PartEdges(const FreeShapes& shapes);
  [[nodiscard]] Part part(std::int32_t part) const {
    const Range& r = range[part];
    const std::size_t first = r.first;
    return {&corner[2 * first], &edge[first], r.corners};
  }
};

// Pose of a body's axes: origin, cosine and sine of the rotation.
struct BodyFrame {
  double x, y, c, s;
};
// Pose of b in the axes of a.
[[nodiscard]] WYTHE_INLINE BodyFrame seen_from(const BodyFrame& a, const BodyFrame& b) {
  const double dx = b.x - a.x, dy = b.y - a.y;
  return {a.c * dx + a.s * dy, a.c * dy - a.s * dx, a.c * b.c + a.s * b.s, a.c * b.s - a.s * b.c};
}

// Integrals of the overlap on one edge, in the axes of the edge, for kn t = 1.
struct Overlap {
  double lowest;  // lowest corner of the other part over the moved edge; > 0: no contact [m]
  double cover;   // overlapped length of the edge [m]
  double area;    // integral of d [m^2]: force along n
  double moment;  // of the force about the origin of the edge's axes [m^3]
  double side;    // force along x [m^2]
  double energy;  // [m^3]
};

// Overlap on an edge that is moved into its part by `inset` [m], so that this depth carries no force.
[[nodiscard]] Overlap overlap_on(const Part& ref, int edge, const Part& other,
                                 const BodyFrame& seen, double inset = 0);

// The edge of `ref` with the largest distance to `other`, or with the least penetration.
struct Separation {
  double distance = -std::numeric_limits<double>::infinity();  // [m], negative in penetration
  int edge = 0;
};
[[nodiscard]] Separation separation_of(const Part& ref, const Part& other, const BodyFrame& seen);

// The face of a contact: edge e of a, or -1 - e of b. That of a is preferred, unless that of b is
// better by `slop` or separates the parts better; `last` stays while no other is better by `slop`. kNoFeature: no face
// yet; then the distance is negative only where no face separates the parts.
inline constexpr std::int32_t kNoFeature = std::numeric_limits<std::int32_t>::min();
struct Face {
  double distance;
  std::int32_t feature;
};
[[nodiscard]] Face face_of(const Part& a, const Part& b, const BodyFrame& b_from_a,
                           const BodyFrame& a_from_b, std::int32_t last, double slop);

// The law of two bodies in free contact: stiffnesses of their joint material, and dry friction.
struct FreeLaw {
  double kn = 0, ks = 0;    // [Pa/m]
  double tan_friction = 0;  // [-]
  double thickness = 0;     // [m]
};
// The law of a broken joint of this material.
[[nodiscard]] FreeLaw free_law(const LawConstants<double>& law, double thickness);

}  // namespace wythe::contact
