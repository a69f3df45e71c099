// Pairs of parts that press, taken eight at a time (dynamics/passes/pressing.h):
// every width gives the same bits as two parts alone.
#include "dynamics/passes/pressing.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <vector>

#include "contact/convex_contact.h"
#include "dynamics/executors/kernels.h"
#include "geometry/polygon.h"
#include "scenes/shares.h"

namespace wythe::dynamics::pressing_test {
namespace {

using scenes::Shares;

// Parts with 6 to 16 corners, so that those of a pack differ.
FreeShapes shapes_of_many_corners() {
  FreeShapes shapes;
  shapes.part_begin = {0};
  shapes.corner_begin = {0};
  for (int sides = 3; sides <= 8; ++sides) {
    geometry::Polygon outline;
    for (int k = 0; k < sides; ++k) {
      const double turn = 6.283185307179586 * (k + 0.3) / sides;
      outline.push_back({0.2 * std::cos(turn), 0.1 * std::sin(turn)});
    }
    for (const Vec2& v : geometry::bevelled(outline, 1e-3)) {
      shapes.corner_x.push_back(v.x);
      shapes.corner_y.push_back(v.y);
    }
    shapes.corner_begin.push_back(static_cast<std::int32_t>(shapes.corner_x.size()));
    shapes.part_begin.push_back(sides - 2);
  }
  return shapes;
}

struct Body {
  contact::BodyFrame frame;
  double vx, vy, spin, unused;
};

struct Scene {
  contact::PartEdges edges{shapes_of_many_corners()};
  std::vector<double> corners = rows_of_corners(edges);
  std::vector<Body> bodies;
  PressGroup group{};

  Scene() {
    Shares share;
    for (int k = 0; k < kGroup; ++k) add(share, k);
  }
  [[nodiscard]] PressTables tables() const {
    return {&bodies.front().frame.x, &edges.edge.front().x, corners.data(), 1e-4};
  }
  [[nodiscard]] contact::Part part(int k, bool other) const {
    return edges.part((k + (other ? 1 : 0)) % 6);
  }

  // The same pairs in new places.
  void shuffle(Shares& share) {
    bodies.clear();
    group.corner_rows = 0;
    for (int k = 0; k < kGroup; ++k) add(share, k);
  }

 private:
  void add(Shares& share, int k) {
    const auto body = [&](double reach) {
      const double turn = 3.1 * share.next();
      bodies.push_back(
          {{reach * share.next(), 0.7 * reach * share.next(), std::cos(turn), std::sin(turn)},
           share.next(),
           share.next(),
           3 * share.next(),
           0});
      return static_cast<std::int32_t>(2 * (bodies.size() - 1));
    };
    const auto n = static_cast<std::size_t>(k);
    group.ref[n] = body(0.05), group.other[n] = body(0.3);
    const contact::BodyFrame seen =
        contact::seen_from(bodies[bodies.size() - 2].frame, bodies[bodies.size() - 1].frame);
    const int edge = contact::separation_of(part(k, false), part(k, true), seen).edge;
    const contact::PartEdges::Range& of = edges.range[n % 6];
    const contact::PartEdges::Range& to = edges.range[(n + 1) % 6];
    group.edge[n] = 2 * (of.first + edge);
    group.corners[n] = kCornerRows * to.shape;
    group.corner_rows = std::max(group.corner_rows, (to.corners + 1) / 2);
    group.rest[n] = share.next() > 0 ? 0.0 : 1e-3;
    group.area[n] = 0.02 * (1 + share.next()), group.slip[n] = 0.1 * share.next();
    group.kn[n] = 1e9, group.ks[n] = 4e8, group.tan_friction[n] = 0.6, group.thickness[n] = 0.25;
  }
};

TEST(Pressing, has_the_bits_of_two_parts_alone_at_every_width) {
  Scene scene;
  Shares share;
  int pressing = 0, sliding = 0;
  for (int round = 0; round < 500; ++round) {
    scene.shuffle(share);
    PressGroup alone = scene.group;
    press_kernel(1)(scene.tables(), alone);
    for (int k = 0; k < kGroup; ++k) {
      const auto n = static_cast<std::size_t>(k);
      const contact::BodyFrame seen =
          contact::seen_from(scene.bodies[2 * n].frame, scene.bodies[2 * n + 1].frame);
      const contact::Part ref = scene.part(k, false);
      const int edge = scene.group.edge[n] / 2 - scene.edges.range[n % 6].first;
      const contact::Overlap overlap =
          contact::overlap_on(ref, edge, scene.part(k, true), seen, scene.group.rest[n]);
      EXPECT_EQ(alone.cover[n], overlap.cover);
      if (!(overlap.cover > 0)) continue;
      ++pressing;
      EXPECT_EQ(alone.pressed[n], (1e9 * 0.25) * overlap.area);
      const double held = 4e8 * alone.area_now[n] * alone.slip_now[n];
      EXPECT_LE(std::fabs(held), 0.6 * alone.pressed[n] * (1 + 1e-12));
      sliding += std::fabs(held) > 0.6 * alone.pressed[n] * (1 - 1e-12);
    }
    for (const Kernels* set : kernels_here()) {
      PressGroup packed = scene.group;
      press_kernel(set->width)(scene.tables(), packed);
      for (int k = 0; k < kGroup; ++k) {
        const auto n = static_cast<std::size_t>(k);
        EXPECT_EQ(packed.cover[n], alone.cover[n]) << set->name;
        if (!(alone.cover[n] > 0)) continue;
        const auto same = [&](const double* of, const double* to, const char* what) {
          EXPECT_EQ(std::memcmp(of + n, to + n, sizeof *of), 0) << what << ", " << set->name;
        };
        same(packed.area_now, alone.area_now, "area");
        same(packed.slip_now, alone.slip_now, "slip");
        same(packed.pressed, alone.pressed, "pressed");
        same(packed.stored, alone.stored, "stored");
        same(packed.friction, alone.friction, "friction");
        same(packed.fx, alone.fx, "fx");
        same(packed.fy, alone.fy, "fy");
        same(packed.on_other, alone.on_other, "on other");
        same(packed.on_ref, alone.on_ref, "on ref");
      }
    }
  }
  EXPECT_GT(pressing, 500);
  EXPECT_GT(sliding, 100);
}

}  // namespace
}  // namespace wythe::dynamics::pressing_test
