// Contact of two convex parts in space: their overlap and its force (docs/theory/contacts.md, "Two parts
// in space"). As convex_contact.h, with a facet in place of an edge:
//
//            n = z                  V = kn / 2  integral of d^2 dA      over the area that the other part's
//            |    y                 facets cover, seen along z; force and moment are its derivatives
//       +----|---/------+
//      /     o--------> x           Facets are inset by the bevel, so that parts that share an edge or a
//     +----------------+            corner at the start do not touch there.
#pragma once

#include <cstdint>
#include <map>
#include <span>
#include <vector>

#include "contact/convex_contact.h"
#include "core/rotation.h"
#include "wythe/parts/body.h"

namespace wythe::contact {

using Vec = Vector<double>;

// A facet in the axes of its body: origin in its plane, x and y in it, z out of the body.
struct Facet {
  Vec origin, x, y, z;
  std::int32_t begin = 0, end = 0;  // its corners, anticlockwise seen from outside
};
// The outward normal of a facet's side, in the facet's axes; `level` is the distance of a place beyond it.
struct FacetSide {
  double nx, ny, offset;
  [[nodiscard]] double level(const Vec& p) const { return nx * p.x + ny * p.y - offset; }
};
// All parts of all bodies, corners relative to the bodies' centroids; parts of one shape share it.
struct SpaceParts {
  std::vector<std::int32_t> shape;           // of each part
  std::vector<std::int32_t> facet_begin{0};  // CSR (shapes + 1)
  std::vector<Facet> facet;
  std::vector<Vec> corner;
  std::vector<FacetSide> side;                        // the side after each corner
  std::map<std::vector<double>, std::int32_t> known;  // shapes by vertices and faces
  // Adds a part whose vertices are taken relative to `centre`.
  void add(const Polyhedron& part, const Vec3& centre, double inset);

  // Facets of a part.
  [[nodiscard]] std::span<const Facet> facets_of(std::int32_t part) const {
    const std::size_t s = shape[part];
    return std::span(facet).subspan(facet_begin[s],
                                    static_cast<std::size_t>(facet_begin[s + 1] - facet_begin[s]));
  }

 private:
  void add_shape(const std::vector<Vec>& vertex, const Polyhedron& part, double inset);
};
struct SpacePart {
  const Facet* facet;
  const Vec* corner;
  const FacetSide* side;
  int facets;
};
[[nodiscard]] inline SpacePart part_of(const SpaceParts& parts, std::int32_t part) {
  const std::span<const Facet> facets = parts.facets_of(part);
  return {facets.data(), parts.corner.data(), parts.side.data(), static_cast<int>(facets.size())};
}

// Pose of a body's axes.
struct SpaceFrame {
  Vec at;
  Quaternion<double> turn;
};
[[nodiscard]] SpaceFrame seen_from(const SpaceFrame& a, const SpaceFrame& b);

// Integrals of the overlap on one facet, in its axes, for kn = 1.
struct SpaceOverlap {
  double lowest =
      0;  // the other part's lowest corner over the moved facet; above 0 there is no contact [m]
  double cover = 0;          // covered area of the facet [m^2]
  Vec force{0, 0, 0};        // [m^3]
  Vec moment{0, 0, 0};       // about the origin of the facet's axes [m^4]
  double energy = 0;         // [m^4]
  double spread = 0;         // mean squared distance of that area from its centroid [m^2]
  std::vector<Vec> polygon;  // of the largest piece, on request
};
// Overlap on a facet that is moved into its part by `inset` [m], so that this depth carries no force.
[[nodiscard]] SpaceOverlap overlap_on(const SpacePart& ref, int facet, const SpacePart& other,
                                      const SpaceFrame& seen, double inset = 0,
                                      bool with_polygon = false);
// Height of the other part's lowest corner above a facet [m].
[[nodiscard]] double lowest_over(const SpacePart& ref, int facet, const SpacePart& other,
                                 const SpaceFrame& seen);
[[nodiscard]] Separation separation_of(const SpacePart& ref, const SpacePart& other,
                                       const SpaceFrame& seen);
[[nodiscard]] Face face_of(const SpacePart& a, const SpacePart& b, const SpaceFrame& b_from_a,
                           const SpaceFrame& a_from_b, std::int32_t last, double slop);

}  // namespace wythe::contact
