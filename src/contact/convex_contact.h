// Two convex parts that meet in the plane: how they overlap, and the force of it
// (docs/theory/contacts.md, "Two parts in the plane").
//
//         other            One edge of one part is the face of the contact: of all edges of both parts
//     \           /        that which the other part passes least. In its axes (x along it, n out of its
//      \         /         part) the other part reaches d(x) below the edge, and
//   ====\-------/===> x
//        \_____/  d(x)         V = kn t / 2  integral of d^2 dx            over the edge alone
//     ref
//
// is the energy of the contact; force and moment are its derivatives, so that what pushing in takes, letting
// out gives back. Where the other part hangs over an end of the edge by the depth d there, that end pushes
// along the edge, by kn t d^2 / 2.
//
// Called by the step (dynamics/passes/free_contacts.h) and by what reads a state (reading/free_contacts.cpp).
#pragma once

#include <cmath>
#include <limits>
#include <span>
#include <vector>

#include "contact/law.h"
#include "core/real.h"
#include "wythe/parts/free_contacts.h"

namespace wythe::contact {

// The nearest multiple of 2^-40 m, 1e-12 m: corners seen from their centroid lie on such a grid, so that units of one size
// have one shape, wherever they stand.
[[nodiscard]] inline double on_grid(double v) {
  constexpr double kCells = 0x1p40;
  return std::nearbyint(v * kCells) / kCells;
}

// Axes of an edge, in its body's: origin at its far end, so that x, n are right-handed. One line of a cache.
struct alignas(64) EdgeAxes {
  double x, y, ax, ay, nx, ny, length;
};
// A part: corners in its body's axes, x beside y, anticlockwise; edge i runs from corner i.
struct Part {
  const double* corner;
  const EdgeAxes* edge;
  int corners;
};
[[nodiscard]] WYTHE_INLINE const EdgeAxes& axes_of(const Part& part, int edge) {
  return part.edge[edge];
}

// Corners and edges of all parts; parts of one shape share them, so that they stay in the cache.
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
    const Range& r = range[static_cast<std::size_t>(part)];
    const auto first = static_cast<std::size_t>(r.first);
    return {&corner[2 * first], &edge[first], r.corners};
  }
};

// Where a body's axes are: their origin, cosine and sine of their turn.
struct BodyFrame {
  double x, y, c, s;
};
// b as seen in the axes of a.
[[nodiscard]] WYTHE_INLINE BodyFrame seen_from(const BodyFrame& a, const BodyFrame& b) {
  const double dx = b.x - a.x, dy = b.y - a.y;
  return {a.c * dx + a.s * dy, a.c * dy - a.s * dx, a.c * b.c + a.s * b.s, a.c * b.s - a.s * b.c};
}

// What lies on one edge; lengths in the axes of the edge, for kn t = 1.
struct Overlap {
  double lowest;  // the other part's lowest corner over the moved edge; above 0 nothing presses [m]
  double cover;   // of the edge that is passed [m]
  double area;    // integral of d [m^2]: force along n
  double moment;  // of the force about the origin of the edge's axes [m^3]
  double side;    // force along x [m^2]
  double energy;  // [m^3]
};

// With the edge moved into its part by `inset` [m]: that much of the overlap does not press.
[[nodiscard]] Overlap overlap_on(const Part& ref, int edge, const Part& other,
                                 const BodyFrame& seen, double inset = 0);

// Of `ref`, the edge from which `other` is farthest, or that it passes least.
struct Separation {
  double distance = -std::numeric_limits<double>::infinity();  // [m], negative where passed
  int edge = 0;
};
[[nodiscard]] Separation separation_of(const Part& ref, const Part& other, const BodyFrame& seen);

// The face of a contact: edge e of a, or -1 - e of b. Where both parts offer one, that of a, unless b's is
// better by `slop` or separates the parts better; `last` is kept while no other is better by `slop`. kNoFeature: there
// is none yet; then the distance is negative only where no face separates the parts.
inline constexpr std::int32_t kNoFeature = std::numeric_limits<std::int32_t>::min();
struct Face {
  double distance;
  std::int32_t feature;
};
[[nodiscard]] Face face_of(const Part& a, const Part& b, const BodyFrame& b_from_a,
                           const BodyFrame& a_from_b, std::int32_t last, double slop);

// The law of two bodies in free contact: stiffness of their joint's kind, and dry friction.
struct FreeLaw {
  double kn = 0, ks = 0;    // [Pa/m]
  double tan_friction = 0;  // [-]
  double thickness = 0;     // [m]
};
// Of a joint's material once it is broken.
[[nodiscard]] FreeLaw free_law(const LawConstants<double>& law, double thickness);

}  // namespace wythe::contact
