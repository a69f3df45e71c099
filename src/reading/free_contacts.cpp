// Computes the overlap of each free contact from the poses of a state; its slip comes from the state.
// A block has fallen when it has sunk by more than half of its height. The reach of debris is the distance of its corners
// outside the initial extent of the wall. docs/theory/contacts.md.
#include "reading/free_contacts.h"

#include <algorithm>
#include <cmath>

#include "contact/convex_contact.h"
#include "contact/convex_contact_in_space.h"
#include "core/elementary.h"
#include "core/real.h"
#include "model/free_shapes.h"
#include "reading/readers.h"
#include "wythe/parts/reading.h"

namespace wythe::reading {
namespace {

contact::BodyFrame frame_of(const Model& m, const State& s, std::int32_t body) {
  if (body >= m.n_block) return {0, 0, 1, 0};
  const SinCos<double> half = sin_cos(0.5 * s.theta[body]);
  return {m.centroid_x[body] + s.ux[body], m.centroid_y[body] + s.uy[body],
          1 - 2 * half.sin * half.sin, 2 * half.sin * half.cos};
}

contact::SpaceFrame frame_in_space(const Model& m, const State& s, std::int32_t body) {
  const Quaternion<double> none{1, {0, 0, 0}};
  const int support = body - m.n_block;
  if (support >= m.space.n_support) return {{0, 0, 0}, none};
  const Vec3& start = m.space.centroid[body];
  const std::size_t i = support < 0 ? body : support;
  if (support >= 0)
    return {{start.x + s.support_x[i], start.y + s.support_y[i], start.z + s.support_z[i]}, none};
  return {{start.x + s.ux[i], start.y + s.uy[i], start.z + s.uz[i]},
          {s.qw[i], {s.qx[i], s.qy[i], s.qz[i]}}};
}

template <class Visit>
void each_in_space(const Model& m, const State& s, const Visit& visit) {
  const contact::SpaceParts parts = free_parts(m);
  for (const FreeContact& c : s.free_contacts) {
    const auto a = contact::part_of(parts, m.free.part_begin[c.a] + c.part_a);
    const auto b = contact::part_of(parts, m.free.part_begin[c.b] + c.part_b);
    const contact::SpaceFrame fa = frame_in_space(m, s, c.a), fb = frame_in_space(m, s, c.b);
    visit(c, free_law_of(m, c.a, c.b),
          c.feature >= 0
              ? contact::overlap_on(a, c.feature, b, contact::seen_from(fa, fb), c.rest)
              : contact::overlap_on(b, -1 - c.feature, a, contact::seen_from(fb, fa), c.rest));
  }
}

// visit(contact, law, overlap) for each free contact.
template <class Visit>
void each_contact(const Model& m, const State& s, const Visit& visit) {
  if (s.free_contacts.empty()) return;
  if (dimension_of(m) == 3) return each_in_space(m, s, visit);
  const contact::PartEdges edges(m.free);
  for (const FreeContact& c : s.free_contacts) {
    const contact::Part a = edges.part(m.free.part_begin[c.a] + c.part_a);
    const contact::Part b = edges.part(m.free.part_begin[c.b] + c.part_b);
    const contact::BodyFrame fa = frame_of(m, s, c.a), fb = frame_of(m, s, c.b);
    visit(c, free_law_of(m, c.a, c.b),
          c.feature >= 0
              ? contact::overlap_on(a, c.feature, b, contact::seen_from(fa, fb), c.rest)
              : contact::overlap_on(b, -1 - c.feature, a, contact::seen_from(fb, fa), c.rest));
  }
}

double height_of(const std::vector<Vec3>& outline) {
  const auto [low, high] =
      std::minmax_element(outline.begin(), outline.end(), [](Vec3 a, Vec3 b) { return a.y < b.y; });
  return high->y - low->y;
}

}  // namespace

double free_energy(const Model& m, const State& s) {
  double energy = 0;
  each_contact(m, s, [&](const FreeContact& c, const contact::FreeLaw& law, const auto& overlap) {
    energy +=
        law.kn * law.thickness * overlap.energy +
        0.5 * law.ks * c.area * (c.slip_x * c.slip_x + c.slip_y * c.slip_y + c.slip_z * c.slip_z);
  });
  return energy;
}

double deepest_overlap(const Model& m, const State& s) {
  double deepest = 0;
  each_contact(m, s, [&](const FreeContact&, const contact::FreeLaw&, const auto& overlap) {
    deepest = std::max(deepest, -overlap.lowest);
  });
  return deepest;
}

Debris evaluate_debris(const Model& m, const State& s) {
  Debris debris;
  if (!m.free.any()) return debris;
  Vec3 low{1e300, 0, 1e300}, high{-1e300, 0, -1e300};
  for (BlockId i = 0; i < m.n_block; ++i)
    for (const Vec3& v : corners_of(m, i)) {
      low = {std::fmin(low.x, v.x), 0, std::fmin(low.z, v.z)};
      high = {std::fmax(high.x, v.x), 0, std::fmax(high.z, v.z)};
    }
  for (BlockId i = 0; i < m.n_block; ++i) {
    if (-s.uy[i] <= 0.5 * height_of(corners_of(m, i))) continue;
    ++debris.blocks;
    debris.volume += readers_of(m).volume(m, i);
    debris.mass += m.gravity_mass[i];
    for (const Vec3& v : corners_now(m, s, i))
      debris.reach = std::max({debris.reach, v.x - high.x, low.x - v.x, v.z - high.z, low.z - v.z});
  }
  for (std::size_t k = 0; k < m.stages.size(); ++k)
    for (const PointLoad& load : m.stages[k].loads) {
      const double height = height_of(corners_of(m, load.block));
      debris.load += s.load_scale[k] * (1 - load_left(height, -s.uy[load.block])) *
                     elementary::hypot(load.fx, load.fy, load.fz);
    }
  return debris;
}

}  // namespace wythe::reading
