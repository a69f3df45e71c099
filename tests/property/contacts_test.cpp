// Laws of free contacts: forces are the gradient of the energy, numbering
// and mirroring do not matter, and the search finds all touching pairs.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "contact/convex_contact.h"
#include "dynamics/passes/near_pairs.h"
#include "geometry/polygon.h"
#include "reading/free_contacts.h"
#include "scenes/rig.h"
#include "scenes/scenes.h"
#include "scenes/shares.h"

namespace wythe::contacts_test {
namespace {

using scenes::Rig;
using scenes::Shares;

// A bevelled box and a bevelled wedge, as two bodies.
FreeShapes two_shapes() {
  FreeShapes shapes;
  shapes.part_begin = {0, 1, 2};
  shapes.corner_begin = {0};
  const std::vector<geometry::Polygon> outlines = {
      {{-0.2, -0.1}, {0.2, -0.1}, {0.2, 0.1}, {-0.2, 0.1}},
      {{-0.15, -0.08}, {0.1, -0.1}, {0.16, 0.05}, {-0.02, 0.12}}};
  for (const auto& outline : outlines) {
    for (const Vec2& v : geometry::bevelled(outline, 1e-3)) {
      shapes.corner_x.push_back(v.x);
      shapes.corner_y.push_back(v.y);
    }
    shapes.corner_begin.push_back(static_cast<std::int32_t>(shapes.corner_x.size()));
  }
  return shapes;
}

TEST(FreeContact, force_and_moment_are_the_slope_of_the_energy) {
  const FreeShapes shapes = two_shapes();
  const contact::PartEdges edges(shapes);
  const contact::Part ref = edges.part(0), other = edges.part(1);
  Shares share;
  int touching = 0, hanging = 0;
  for (int k = 0; k < 4000; ++k) {
    const double angle = 3.1 * share.next(), x = 0.35 * share.next(), y = 0.3 * share.next();
    const auto frame = [](double px, double py, double turn) {
      return contact::BodyFrame{px, py, std::cos(turn), std::sin(turn)};
    };
    const contact::BodyFrame seen = frame(x, y, angle);
    const int edge = contact::separation_of(ref, other, seen).edge;
    const contact::Overlap now = contact::overlap_on(ref, edge, other, seen);
    if (!(now.energy > 1e-9)) continue;
    ++touching;
    hanging += now.side != 0;
    const contact::EdgeAxes axes = contact::axes_of(ref, edge);
    const double fx = now.area * axes.nx + now.side * axes.ax,
                 fy = now.area * axes.ny + now.side * axes.ay;
    const double about = now.moment - ((x - axes.x) * fy - (y - axes.y) * fx);
    const auto slope = [&](double dx, double dy, double turn) {
      constexpr double h = 1e-6;
      const auto energy = [&](double s) {
        return contact::overlap_on(ref, edge, other,
                                   frame(x + s * dx, y + s * dy, angle + s * turn))
            .energy;
      };
      return -(energy(h) - energy(-h)) / (2 * h);
    };
    // central differences of a function whose second derivative has kinks: h times the force's own slope
    EXPECT_NEAR(slope(1, 0, 0), fx, 1e-6);
    EXPECT_NEAR(slope(0, 1, 0), fy, 1e-6);
    EXPECT_NEAR(slope(0, 0, 1), about, 1e-6);
  }
  EXPECT_GT(touching, 300);
  EXPECT_GT(hanging, 50);
}

TEST(FreeContact, parts_apart_have_no_force_and_a_separation_that_is_no_more_than_their_distance) {
  const FreeShapes shapes = two_shapes();
  const contact::PartEdges edges(shapes);
  const contact::Part a = edges.part(0), b = edges.part(1);
  Shares share;
  for (int k = 0; k < 4000; ++k) {
    const double angle = 3.1 * share.next();
    const contact::BodyFrame fa{0, 0, 1, 0},
        fb{0.6 * share.next(), 0.5 * share.next(), std::cos(angle), std::sin(angle)};
    const contact::BodyFrame ba = contact::seen_from(fa, fb), ab = contact::seen_from(fb, fa);
    const contact::Face face = contact::face_of(a, b, ba, ab, contact::kNoFeature, 1e-4);
    double nearest = 1e300;
    for (int i = 0; i < b.corners; ++i) {
      const double x = fb.x + fb.c * b.corner[2 * i] - fb.s * b.corner[2 * i + 1],
                   y = fb.y + fb.s * b.corner[2 * i] + fb.c * b.corner[2 * i + 1];
      nearest = std::min(nearest, std::hypot(std::max(0.0, std::fabs(x) - 0.2),
                                             std::max(0.0, std::fabs(y) - 0.1)));
    }
    if (face.distance > 0) {
      EXPECT_LE(face.distance, nearest + 1.5e-3);
    }
    if (nearest == 0) {
      EXPECT_LT(face.distance, 1e-3);
    }
  }
}

// A pair that begins to touch has no face yet, one that was near has: both must say the same, or a run that is cut and
// goes on would differ. The slop chooses between faces that are passed, not whether one separates.
TEST(FreeContact, whether_parts_are_apart_does_not_hang_on_the_slop) {
  const FreeShapes shapes = two_shapes();
  const contact::PartEdges edges(shapes);
  const contact::Part a = edges.part(0), b = edges.part(1);
  constexpr double kSlop = 2e-2;  // far more than a wall's, so that many poses fall into it
  Shares share;
  int between = 0;
  for (int k = 0; k < 4000; ++k) {
    const double turn = 3.1 * share.next();
    const contact::BodyFrame fa{0, 0, 1, 0},
        fb{0.4 * share.next(), 0.3 * share.next(), std::cos(turn), std::sin(turn)};
    const contact::BodyFrame ba = contact::seen_from(fa, fb), ab = contact::seen_from(fb, fa);
    const double of_a = contact::separation_of(a, b, ba).distance;
    const double of_b = contact::separation_of(b, a, ab).distance;
    const contact::Face face = contact::face_of(a, b, ba, ab, contact::kNoFeature, kSlop);
    EXPECT_EQ(face.distance >= 0, std::max(of_a, of_b) >= 0);
    between += of_a < 0 && of_b >= 0 && of_b < of_a + kSlop;
  }
  EXPECT_GT(between, 10);
}

TEST(FreeContact, the_search_finds_every_pair_of_boxes_that_meet) {
  Shares share;
  std::vector<dynamics::Box> boxes;
  for (int k = 0; k < 300; ++k) {
    dynamics::Box box{};
    for (int d = 0; d < 2; ++d) {
      box.low[d] = 5 * share.next();
      box.high[d] = box.low[d] + 0.3 + 0.3 * share.next();
    }
    boxes.push_back(box);
  }
  const auto found = dynamics::near_pairs(boxes, 290, 0.1);
  EXPECT_TRUE(std::is_sorted(found.begin(), found.end()));
  std::size_t meeting = 0;
  for (std::int32_t i = 0; i < 290; ++i)
    for (std::int32_t j = i + 1; j < 300; ++j) {
      const auto &a = boxes[i], &b = boxes[j];
      bool meet = true;
      for (int d = 0; d < 2; ++d)
        meet = meet && a.low[d] <= b.high[d] + 0.2 && b.low[d] <= a.high[d] + 0.2;
      meeting += meet;
      EXPECT_EQ(std::binary_search(found.begin(), found.end(), std::pair(i, j)), meet);
    }
  EXPECT_EQ(found.size(), meeting);
}

// A pile of tilted blocks on a table, every joint given up.
ModelSpec pile() {
  std::vector<BlockSpec> blocks{scenes::rectangle("table", -1, -0.1, 3, 0.1)};
  blocks.back().fixed = true;
  for (int k = 0; k < 9; ++k)
    blocks.push_back(scenes::rectangle("b" + std::to_string(k), 0.22 * (k % 3) + 0.05 * (k / 3),
                                       0.1 * (k / 3), 0.2, 0.1));
  ModelSpec spec = scenes::assembly(std::move(blocks),
                                    scenes::dry_joint(2e9, 1e9, scenes::degrees(30)), 0.2, 2000);
  spec.solve.contacts = Contacts::kFree;
  return spec;
}

void run(Rig& rig, double steps) {
  std::fill(rig.state.handed_over.begin(), rig.state.handed_over.end(), 1.0);
  rig.state.gravity_y = -9.81;
  rig.state.gravity_x = 3;
  rig.controls.damping = 0;
  rig.run(steps * rig.controls.dt);
}

// If two faces are equally good, that of the body with the smaller number is taken
// (docs/theory/contacts.md). The two differ by the tilt between them squared and the depth over the length,
// some 1e-4. In an undamped pile that moves by 0.1 mm this is a few per cent of the motion after 1500 steps.
TEST(FreeContact, numbers_of_blocks_do_not_matter) {
  Rig one(compile(pile())), other(compile(scenes::reversed(pile())));
  run(one, 1500);
  run(other, 1500);
  const std::size_t n = one.state.ux.size();
  ASSERT_FALSE(one.state.free_contacts.empty());
  for (std::size_t i = 0; i < n; ++i) {
    EXPECT_NEAR(one.state.ux[i], other.state.ux[n - 1 - i], 5e-6);
    EXPECT_NEAR(one.state.uy[i], other.state.uy[n - 1 - i], 5e-6);
  }
}

TEST(FreeContact, a_mirrored_pile_moves_mirrored) {
  Rig one(compile(pile())), other(compile(scenes::mirrored(pile())));
  run(one, 1500);
  std::fill(other.state.handed_over.begin(), other.state.handed_over.end(), 1.0);
  other.state.gravity_y = -9.81;
  other.state.gravity_x = -3;
  other.controls.damping = 0;
  other.run(1500 * other.controls.dt);
  for (std::size_t i = 0; i < one.state.ux.size(); ++i) {
    EXPECT_NEAR(one.state.ux[i], -other.state.ux[i], 1e-7);
    EXPECT_NEAR(one.state.uy[i], other.state.uy[i], 1e-7);
  }
}

// Momentum: forces between two free blocks cancel, and so do their moments.
TEST(FreeContact, two_free_blocks_keep_their_momentum) {
  Rig rig(compile(pile()));
  std::fill(rig.state.handed_over.begin(), rig.state.handed_over.end(), 1.0);
  rig.controls.damping = 0;
  Shares share;
  for (std::size_t i = 0; i < rig.state.ux.size(); ++i) {
    rig.state.uy[i] += 1;  // off the table, into each other
    rig.state.ux[i] += 2e-3 * share.next();
    rig.state.vx[i] = 0.5 * share.next();
    rig.state.vy[i] = 0.5 * share.next();
    rig.state.omega[i] = 3 * share.next();
  }
  const auto sums = [&] {
    double px = 0, py = 0, l = 0, scale = 0;
    for (std::size_t i = 0; i < rig.state.ux.size(); ++i) {
      const double m = rig.model.mass[i];
      const double x = rig.model.centroid_x[i] + rig.state.ux[i];
      const double y = rig.model.centroid_y[i] + rig.state.uy[i];
      px += m * rig.state.vx[i];
      py += m * rig.state.vy[i];
      l += m * (x * rig.state.vy[i] - y * rig.state.vx[i]) +
           rig.model.inertia[i] * rig.state.omega[i];
      scale += m * (std::fabs(rig.state.vx[i]) + std::fabs(rig.state.vy[i]));
    }
    return std::array{px, py, l, scale};
  };
  const auto before = sums();
  const std::vector<double> first = rig.state.vy;
  rig.run(0.05);
  const auto after = sums();
  double changed = 0;
  for (std::size_t i = 0; i < first.size(); ++i)
    changed = std::max(changed, std::fabs(rig.state.vy[i] - first[i]));
  EXPECT_GT(changed, 1e-3) << "they met";
  for (int k = 0; k < 2; ++k) EXPECT_NEAR(after[k], before[k], 1e-10 * before[3]);
  // positions are half a step ahead of velocities
  EXPECT_NEAR(after[2], before[2], 1e-3 * before[3]);
}

}  // namespace
}  // namespace wythe::contacts_test
