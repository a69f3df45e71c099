// Free contacts in space: the common volume of two parts, by cases with coordinates (LMGC90's tests of contact
// between polyhedra, cubes of half size 0.3 m); and blocks that slide off, topple, fall and come to rest.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>

#include "contact/convex_contact_in_space.h"
#include "dynamics/meters/residual.h"
#include "reading/free_contacts.h"
#include "scenes/space_rig.h"
#include "wythe/parts/solve.h"

namespace wythe::verification::contacts_in_space_test {
namespace {

using contact::SpaceFrame;
using contact::SpaceOverlap;
using contact::SpacePart;
using contact::SpaceParts;
using scenes::box;
using scenes::SpaceRig;
using Vec = Vector<double>;

constexpr double kBevel = 1e-4, kDeep = 1e-5;

// A frame turned by `angle` about a unit axis.
SpaceFrame frame(Vec at, double angle = 0, Vec axis = {0, 0, 1}) {
  return {at, {std::cos(angle / 2), std::sin(angle / 2) * axis}};
}

// Cube number 0 rests at the origin, its top at z = 0.3; number 1 presses on it.
struct Cubes {
  SpaceParts parts;
  Cubes() {
    for (int k = 0; k < 2; ++k)
      parts.add(box("cube", {-0.3, -0.3, -0.3}, {0.6, 0.6, 0.6}).part[0], {}, kBevel);
  }
  // The common part if the axes of the second part are at `there`, and its face.
  [[nodiscard]] SpaceOverlap shared(const SpaceFrame& there) const {
    const SpacePart a = contact::part_of(parts, 0), b = contact::part_of(parts, 1);
    const SpaceFrame here = frame({0, 0, 0});
    const contact::Face face =
        contact::face_of(a, b, contact::seen_from(here, there), contact::seen_from(there, here),
                         contact::kNoFeature, 0.25 * kBevel);
    EXPECT_LT(face.distance, 0);
    EXPECT_GE(face.feature, 0) << "of two faces as good the first body's";
    SpaceOverlap overlap =
        contact::overlap_on(a, face.feature, b, contact::seen_from(here, there), 0, true);
    // out of the face's axes
    const contact::Facet& f = a.facet[face.feature];
    for (Vec& p : overlap.polygon) p = f.origin + p.x * f.x + p.y * f.y;
    return overlap;
  }
};

void expect_polygon(const SpaceOverlap& overlap, const std::vector<Vec2>& corners) {
  ASSERT_EQ(overlap.polygon.size(), corners.size());
  for (const Vec2& c : corners)
    EXPECT_TRUE(std::any_of(overlap.polygon.begin(), overlap.polygon.end(),
                            [&](const Vec& p) {
                              return std::hypot(p.x - c.x, p.y - c.y) < 6 * kBevel &&
                                     std::fabs(p.z - 0.3) < 1e-9;
                            }))
        << c.x << ", " << c.y;
}

TEST(ContactInSpace, a_cube_on_a_cube_shares_their_face) {
  const SpaceOverlap overlap = Cubes().shared(frame({0, 0, 0.6 - kDeep}));
  expect_polygon(overlap, {{-0.3, -0.3}, {0.3, -0.3}, {0.3, 0.3}, {-0.3, 0.3}});
  EXPECT_NEAR(overlap.force.z, 0.36 * kDeep, 1e-3 * 0.36 * kDeep);
  EXPECT_NEAR(overlap.spread, 2 * 0.6 * 0.6 / 12, 1e-3 * 0.06);
}

TEST(ContactInSpace, a_cube_half_off_shares_a_square) {
  expect_polygon(Cubes().shared(frame({-0.15, -0.15, 0.6 - kDeep})),
                 {{-0.3, -0.3}, {0.15, -0.3}, {0.15, 0.15}, {-0.3, 0.15}});
}

TEST(ContactInSpace, a_turned_cube_shares_an_octagon) {
  expect_polygon(Cubes().shared(frame({-0.0375, -0.0375, 0.6 - kDeep}, 1.0)), {{-0.3, -0.22547},
                                                                               {-0.3, 0.10893},
                                                                               {-0.17731, 0.3},
                                                                               {-0.00788, 0.3},
                                                                               {0.3, 0.10231},
                                                                               {0.3, -0.06712},
                                                                               {0.15047, -0.3},
                                                                               {-0.18393, -0.3}});
}

// On an edge the pressure is a strip along it; on a corner a spot below it.
TEST(ContactInSpace, an_edge_and_a_corner_press_where_they_are) {
  const double half = 0.3 * std::sqrt(2.0), deep = 1e-3;
  const SpaceOverlap edge =
      Cubes().shared(frame({0.05, 0, 0.3 + half - deep}, M_PI / 4, {1, 0, 0}));
  EXPECT_NEAR(-edge.moment.y / edge.force.z, 0.0, 0.06);
  EXPECT_GT(edge.force.z, 0);
  EXPECT_LT(edge.cover, 0.6 * 2.1 * deep);
  // standing on its corner: about (1, -1, 0) / sqrt 2 by acos(1 / sqrt 3)
  const double tilt = std::acos(1 / std::sqrt(3.0)), corner = 0.3 * std::sqrt(3.0);
  const SpaceOverlap spot = Cubes().shared(
      frame({0.1, 0.05, 0.3 + corner - deep}, tilt, {std::sqrt(0.5), -std::sqrt(0.5), 0}));
  EXPECT_GT(spot.force.z, 0);
  EXPECT_LT(spot.cover, 10 * deep * deep);
}

// There and back over edge, corner and face: the same forces, for a contact has no memory but slip and face.
TEST(ContactInSpace, forces_are_the_same_on_the_way_back) {
  const Cubes cubes;
  std::vector<double> there, back;
  const auto at = [&](int k) {
    const double s = 0.01 * k;
    return cubes.shared(frame({0.5 * s - 0.2, 0.3 * s - 0.1, 0.6 - 2e-4}, 0.7 * s)).force.z;
  };
  for (int k = 0; k <= 100; ++k) there.push_back(at(k));
  for (int k = 100; k >= 0; --k) back.push_back(at(k));
  std::reverse(back.begin(), back.end());
  EXPECT_EQ(there, back);
  for (std::size_t k = 1; k < there.size(); ++k)
    EXPECT_LT(std::fabs(there[k] - there[k - 1]), 0.03 * there[0]) << "no jump at " << k;
}

// --- LMGC90's U-shape and its edges, there and back -------------------------------------------------------

// What part 1 does to part 0 by its force on part 1 in the wall's axes, and where; the face is remembered, as contacts do.
struct Pressed {
  Vec force{0, 0, 0}, place{0, 0, 0};
  double energy = 0, spread = 0;
};
class Pair {
 public:
  Pair(const SpaceParts& parts, int second)
      : a_(contact::part_of(parts, 0)), b_(contact::part_of(parts, second)) {}

  Pressed at(const SpaceFrame& here, const SpaceFrame& there) {
    const SpaceFrame ba = contact::seen_from(here, there), ab = contact::seen_from(there, here);
    const contact::Face face = contact::face_of(a_, b_, ba, ab, last_, 0.25 * kBevel);
    last_ = face.feature;
    if (face.distance >= 0) return {};
    const bool of_a = face.feature >= 0;
    const contact::Facet& f = of_a ? a_.facet[face.feature] : b_.facet[-1 - face.feature];
    const SpaceOverlap o = of_a ? contact::overlap_on(a_, face.feature, b_, ba)
                                : contact::overlap_on(b_, -1 - face.feature, a_, ab);
    if (!(o.cover > 0)) return {};
    const SpaceFrame& frame = of_a ? here : there;
    const auto out = [&](const Vec& v) {
      return turned(frame.turn, v.x * f.x + v.y * f.y + v.z * f.z);
    };
    const Vec middle = f.origin + (-o.moment.y / o.force.z) * f.x + (o.moment.x / o.force.z) * f.y;
    return {(of_a ? 1.0 : -1.0) * out(o.force), frame.at + turned(frame.turn, middle), o.energy,
            o.spread};
  }

 private:
  SpacePart a_, b_;
  std::int32_t last_ = contact::kNoFeature;
};

// Along a way and back. The same forces, but within half a bevel of where two faces are equally good: there
// the one that was before stays. No force jumps by more than `jump` of the largest, and what goes in comes back.
void there_and_back(Pair pair, const SpaceFrame& here, const std::function<SpaceFrame(double)>& way,
                    double jump, bool turns = false) {
  constexpr int kSteps = 4000;
  std::vector<Pressed> there, back;
  for (int k = 0; k <= kSteps; ++k) there.push_back(pair.at(here, way(1.0 * k / kSteps)));
  for (int k = kSteps; k >= 0; --k) back.push_back(pair.at(here, way(1.0 * k / kSteps)));
  std::reverse(back.begin(), back.end());
  double most = 0, work = 0;
  for (const Pressed& p : there) most = std::max(most, std::sqrt(dot(p.force, p.force)));
  ASSERT_GT(most, 0);
  int other = 0;
  for (std::size_t k = 0; k < there.size(); ++k) {
    const Vec d = there[k].force - back[k].force;
    other += std::sqrt(dot(d, d)) > 1e-9 * most;
    if (k == 0) continue;
    const Vec step = there[k].force - there[k - 1].force;
    if (!turns) {
      EXPECT_LT(std::sqrt(dot(step, step)), jump * most) << "no jump at " << k;
    }
    EXPECT_LT(std::fabs(std::sqrt(dot(there[k].force, there[k].force)) -
                        std::sqrt(dot(there[k - 1].force, there[k - 1].force))),
              jump * most);
    const Vec moved = way(1.0 * static_cast<double>(k) / kSteps).at -
                      way(1.0 * static_cast<double>(k - 1) / kSteps).at;
    work += 0.5 * dot(there[k].force + there[k - 1].force, moved);
  }
  EXPECT_LE(other, turns ? kSteps / 50 : 0);
  double stored = 0;
  for (const Pressed& p : there) stored = std::max(stored, p.energy);
  EXPECT_NEAR(work, there.front().energy - there.back().energy, 0.02 * stored);
}

TEST(ContactInSpace, a_u_shape_shares_a_rectangle_with_each_leg) {
  Cubes cubes;  // on the first an inverted U whose legs are 0.2 m wide, seen from between them
  for (const double x : {-0.3, 0.1})
    cubes.parts.add(box("leg", {x, -0.3, 0}, {0.2, 0.6, 0.4}).part[0], {}, kBevel);
  const SpaceFrame here = frame({0, 0, 0}), there = frame({0, -0.3, 0.3 - kDeep});
  for (const int leg : {2, 3}) {
    const SpacePart a = contact::part_of(cubes.parts, 0), b = contact::part_of(cubes.parts, leg);
    const contact::Face face =
        contact::face_of(a, b, contact::seen_from(here, there), contact::seen_from(there, here),
                         contact::kNoFeature, 0.25 * kBevel);
    ASSERT_GE(face.feature, 0);
    SpaceOverlap overlap =
        contact::overlap_on(a, face.feature, b, contact::seen_from(here, there), 0, true);
    const contact::Facet& f = a.facet[face.feature];
    for (Vec& p : overlap.polygon) p = f.origin + p.x * f.x + p.y * f.y;
    const double low = leg == 2 ? -0.3 : 0.1;
    expect_polygon(overlap, {{low, -0.3}, {low + 0.2, -0.3}, {low + 0.2, 0}, {low, 0}});
    EXPECT_NEAR(overlap.force.z, 0.06 * kDeep, 5e-3 * 0.06 * kDeep);
    // over the side of the cube and back
    there_and_back(
        Pair(cubes.parts, leg), here,
        [](double s) {
          return frame({0.25 * s, -0.3 - 0.29 * s, 0.3 - kDeep});
        },
        5e-3);
  }
}

// Two edges that cross press where they cross, upwards: on the bevel of one.
TEST(ContactInSpace, edges_that_cross_press_where_they_cross) {
  const Cubes cubes;
  const double half = 0.3 * std::sqrt(2.0), deep = 2e-3;
  const SpaceFrame here = frame({0, 0, 0}, M_PI / 4, {1, 0, 0});
  const auto across = [&](double x, double y) {
    return frame({x, y, 2 * half - deep}, M_PI / 4, {0, 1, 0});
  };
  for (const double x : {-0.2, 0.0, 0.15}) {
    const Pressed p = Pair(cubes.parts, 1).at(here, across(x, 0.05));
    EXPECT_GT(p.force.z, 0);
    EXPECT_NEAR(p.force.x, 0, 1e-9 * p.force.z);
    EXPECT_NEAR(p.force.y, 0, 1e-9 * p.force.z);
    EXPECT_NEAR(p.place.x, x, deep);
    EXPECT_NEAR(p.place.y, 0, deep);
    EXPECT_NEAR(p.place.z, half, 2 * deep);
  }
  // along its edge, over the end of it; and down on it
  there_and_back(
      Pair(cubes.parts, 1), here, [&](double s) { return across(0.4 * s, 0.05); }, 0.12);
  there_and_back(
      Pair(cubes.parts, 1), here,
      [&](double s) {
        return frame({0.1, 0.05, 2 * half + 1e-3 - 3e-3 * s}, M_PI / 4, {0, 1, 0});
      },
      0.02);
}

// Two edges along each other press all along, on one face or on the other.
TEST(ContactInSpace, edges_along_each_other_press_all_along) {
  const Cubes cubes;
  const double half = 0.3 * std::sqrt(2.0), deep = 2e-3;
  const SpaceFrame here = frame({0, 0, 0}, M_PI / 4, {1, 0, 0});
  const auto above = [&](double x, double y) {
    return frame({x, y, 2 * half - deep}, M_PI / 4, {1, 0, 0});
  };
  for (const double y : {-2e-4, 2e-4}) {
    const Pressed p = Pair(cubes.parts, 1).at(here, above(0, y));
    EXPECT_GT(p.force.z, 0);
    EXPECT_GT(p.force.y * y, 0) << "to the side where it lies";
    EXPECT_NEAR(p.place.x, 0, 1e-6);
    EXPECT_NEAR(p.place.y, 0, deep);
    EXPECT_NEAR(p.spread, 0.6 * 0.6 / 12, 1e-3);
  }
  there_and_back(
      Pair(cubes.parts, 1), here, [&](double s) { return above(0.7 * s, 5e-4); }, 5e-3);
  // over the edge, where the other face takes its place
  there_and_back(
      Pair(cubes.parts, 1), here, [&](double s) { return above(0, 4e-3 * (s - 0.5)); }, 0.05, true);
}

// As in the plane: the slop chooses between faces that are passed, not whether one separates.
TEST(ContactInSpace, whether_parts_are_apart_does_not_hang_on_the_slop) {
  const Cubes cubes;
  const SpacePart a = contact::part_of(cubes.parts, 0), b = contact::part_of(cubes.parts, 1);
  constexpr double kSlop = 0.05;
  std::uint64_t seed = 7;
  const auto next = [&] {
    seed = seed * 6364136223846793005ULL + 1442695040888963407ULL;
    return static_cast<double>(seed >> 11) * 0x1p-52 - 1.0;
  };
  int between = 0;
  for (int k = 0; k < 4000; ++k) {
    const Vec axis{next(), next(), next()}, at{0.9 * next(), 0.9 * next(), 0.9 * next()};
    const SpaceFrame here = frame({0, 0, 0}),
                     there = frame(at, 3 * next(), (1 / std::sqrt(dot(axis, axis))) * axis);
    const SpaceFrame ba = contact::seen_from(here, there), ab = contact::seen_from(there, here);
    const double of_a = contact::separation_of(a, b, ba).distance;
    const double of_b = contact::separation_of(b, a, ab).distance;
    const contact::Face face = contact::face_of(a, b, ba, ab, contact::kNoFeature, kSlop);
    EXPECT_EQ(face.distance >= 0, std::max(of_a, of_b) >= 0);
    between += of_a < 0 && of_b >= 0 && of_b < of_a + kSlop;
  }
  EXPECT_GT(between, 10);
}

TEST(ContactInSpace, units_of_one_size_share_a_shape_wherever_they_stand) {
  SpaceParts parts;
  for (const double x : {0.0, 0.1, 7.0 / 3, 1e3})
    parts.add(box("unit", {x - 0.125, -0.05, 0.1 * x}, {0.25, 0.1, 0.125}).part[0],
              {x, 0, 0.1 * x + 0.0625}, kBevel);
  parts.add(box("other", {0, 0, 0}, {0.2, 0.1, 0.125}).part[0], {0.1, 0.05, 0.0625}, kBevel);
  EXPECT_EQ(parts.shape, (std::vector<std::int32_t>{0, 0, 0, 0, 1}));
  EXPECT_EQ(parts.facet.size(), 12U);
}

TEST(ContactInSpace, force_and_moment_are_the_slope_of_the_energy) {
  const Cubes cubes;
  const SpacePart a = contact::part_of(cubes.parts, 0), b = contact::part_of(cubes.parts, 1);
  std::uint64_t seed = 5;
  const auto next = [&] {
    seed = seed * 6364136223846793005ULL + 1442695040888963407ULL;
    return static_cast<double>(seed >> 11) * 0x1p-52 - 1.0;
  };
  int touching = 0;
  for (int k = 0; k < 3000; ++k) {
    const Vec axis0{next(), next(), next()};
    const Vec axis = (1 / std::sqrt(dot(axis0, axis0))) * axis0;
    const SpaceFrame there = frame({0.7 * next(), 0.7 * next(), 0.7 * next()}, 3 * next(), axis);
    const int facet = contact::separation_of(a, b, there).edge;
    const SpaceOverlap now = contact::overlap_on(a, facet, b, there);
    if (!(now.energy > 1e-9)) continue;
    ++touching;
    const contact::Facet& f = a.facet[facet];
    const auto out = [&](const Vec& v) { return v.x * f.x + v.y * f.y + v.z * f.z; };
    const Vec force = out(now.force), moment = out(now.moment) - cross(there.at - f.origin, force);
    const auto slope = [&](const Vec& move, const Vec& turn) {
      constexpr double h = 1e-6;
      const auto energy = [&](double s) {
        SpaceFrame moved = there;
        moved.at = there.at + s * move;
        const double angle = s * std::sqrt(dot(turn, turn));
        if (angle != 0) {
          const Vec about = (1 / std::sqrt(dot(turn, turn))) * turn;
          moved.turn =
              Quaternion<double>{std::cos(angle / 2), std::sin(angle / 2) * about} * there.turn;
        }
        return contact::overlap_on(a, facet, b, moved).energy;
      };
      return -(energy(h) - energy(-h)) / (2 * h);
    };
    const Vec none{0, 0, 0};
    const Vec unit[3] = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
    const double f3[3] = {force.x, force.y, force.z}, m3[3] = {moment.x, moment.y, moment.z};
    for (int c = 0; c < 3; ++c) {
      EXPECT_NEAR(slope(unit[c], none), f3[c], 2e-7);
      EXPECT_NEAR(slope(none, unit[c]), m3[c], 2e-7);
    }
  }
  EXPECT_GT(touching, 300);
}

// --- blocks ----------------------------------------------------------------------------------------------

constexpr double kG = 9.81;

ModelSpec on_a_table(std::vector<BodySpec> bodies, double friction = 0.5236) {
  bodies.insert(bodies.begin(), box("table", {-1, -0.2, -0.5}, {1.5, 0.2, 1}, true));
  ModelSpec spec = scenes::in_space(std::move(bodies), scenes::dry_joint(2e9, 1e9, friction), 2000);
  spec.solve.contacts = Contacts::kFree;
  return spec;
}
void release(SpaceRig& rig) {
  std::fill(rig.state.handed_over.begin(), rig.state.handed_over.end(), 1.0);
  rig.set_gravity({0, -kG, 0});
  rig.load_state();
}

TEST(ContactInSpace, a_block_over_an_edge_topples_when_its_centroid_has_passed_it) {
  for (const double beyond : {-8e-3, 8e-3}) {
    SpaceRig rig(compile(on_a_table({box("block", {0.35 + beyond, 0, -0.1}, {0.3, 0.1, 0.2})})));
    rig.controls.damping = 0.2;
    release(rig);
    rig.run(1.0);
    const double turned = std::fabs(rig.turn(0).v.z);
    if (beyond < 0) {
      EXPECT_LT(turned, 1e-3);
    } else {
      EXPECT_GT(turned, 0.05);
    }
  }
}

TEST(ContactInSpace, friction_sticks_and_slides_at_its_tangent_in_any_direction) {
  const double friction = scenes::degrees(30);
  for (const double slope : {scenes::degrees(27), scenes::degrees(34)}) {
    SpaceRig rig(compile(on_a_table({box("block", {-0.5, 0, -0.1}, {0.2, 0.04, 0.2})}, friction)));
    rig.controls.damping = 0.5;
    release(rig);
    rig.run(0.2);
    rig.controls.damping = 0;
    const Vec3 start = rig.moved(0);
    const double along = kG * std::sin(slope) * std::sqrt(0.5);
    rig.set_gravity({along, -kG * std::cos(slope), along});
    rig.load_state();
    rig.run(0.25);
    const Vec3 moved = rig.moved(0) - start;
    const double pulled = kG * (std::sin(slope) - std::tan(friction) * std::cos(slope));
    if (slope < friction) {
      EXPECT_LT(length(moved), 1e-4);
    } else {
      EXPECT_NEAR(std::hypot(moved.x, moved.z), 0.5 * pulled * 0.0625, 0.05 * moved.x);
      EXPECT_NEAR(moved.x, moved.z, 1e-6);
    }
  }
}

// A support starts at once with v below a block at rest: friction pulls it at mu g until it goes along, v / (mu g)
// later, and v^2 / (2 mu g) behind.
TEST(ContactInSpace, a_support_that_moves_drags_what_lies_on_it) {
  constexpr double kSpeed = 1, kFriction = 0.3;
  ModelSpec spec =
      on_a_table({box("block", {-0.6, 0, -0.1}, {0.2, 0.04, 0.2})}, std::atan(kFriction));
  spec.body.front().part = box("table", {-1, -0.2, -0.5}, {3, 0.2, 1}, true).part;
  spec.stage = {scenes::gravity_stage(), scenes::push_stage("table", Direction::kPlusX, 1, 1)};
  SpaceRig rig(compile(spec));
  rig.controls.damping = 0.5;
  release(rig);
  rig.run(0.2);
  rig.controls.damping = 0;
  const double work = dynamics::energy_ledger(rig.model, rig.state, 1).drive,
               start = rig.state.ux[0];
  const double before = rig.state.energy.dissipated_friction;
  rig.drive(1, kSpeed);
  rig.run(0.2);
  const double pull = kFriction * kG, weight = rig.model.mass[0] * kG;
  EXPECT_NEAR(rig.state.vx[0], 0.2 * pull, 0.01 * pull);
  EXPECT_NEAR(rig.state.ux[0] - start, 0.5 * pull * 0.04, 2e-4);
  double reaction = 0;
  for (int k = 0; k < 400; ++k) reaction += rig.advance() / 400;
  EXPECT_NEAR(reaction, kFriction * weight, 0.01 * kFriction * weight);
  rig.run(0.4);
  const double behind = kSpeed * kSpeed / (2 * pull);
  EXPECT_NEAR(rig.state.vx[0], kSpeed, 2e-3);
  EXPECT_NEAR(rig.state.support_x[0] - (rig.state.ux[0] - start), behind, 5e-3 * behind);
  const EnergyLedger e = dynamics::energy_ledger(rig.model, rig.state, 1);
  EXPECT_NEAR(e.friction - before, kFriction * weight * behind, 0.01 * weight * behind);
  EXPECT_NEAR(e.drive - work, 2 * kFriction * weight * behind, 0.01 * weight * behind);
  EXPECT_LT(std::fabs(e.gap), 2e-3 * e.friction);
}

// It comes from afar and strikes a block that sleeps: without loss the block leaves at twice the speed.
TEST(ContactInSpace, a_support_that_moves_wakes_what_it_strikes) {
  ModelSpec spec = on_a_table({box("block", {-0.6, 0, -0.1}, {0.2, 0.2, 0.2})}, std::atan(1e-4));
  spec.body.push_back(box("ram", {-1, 0.02, -0.1}, {0.1, 0.16, 0.2}, true));
  spec.stage = {scenes::gravity_stage(), scenes::push_stage("ram", Direction::kPlusX, 1, 1)};
  for (const double speed : {0.5, 3.0}) {
    SpaceRig rig(compile(spec));
    rig.controls.damping = 0;
    rig.controls.dt *= 0.3;  // an impact is right to 1 % there
    release(rig);
    rig.drive(1, speed);
    rig.run(0.29 / speed);
    EXPECT_NEAR(rig.state.ux[0], 0, 1e-4) << "before it is struck";
    rig.run(0.03 / speed);
    EXPECT_NEAR(rig.state.vx[0], 2 * speed, 0.05 * speed);
    EXPECT_GT(0.3 + rig.state.ux[0], rig.state.support_x.back()) << "ahead of the ram";
  }
}

TEST(ContactInSpace, a_dropped_block_keeps_its_energy_and_does_not_pass_the_table) {
  SpaceRig rig(compile(on_a_table({box("block", {-0.6, 0, -0.1}, {0.2, 0.1, 0.2})})));
  rig.controls.damping = 0;
  rig.set_gravity({0, -kG, 0});
  rig.state.handed_over[0] = 1;
  rig.state.uy[0] = 0.3;
  const Vec axis = (1 / std::sqrt(3.0)) * Vec{1, 1, 1};
  rig.state.qw[0] = std::cos(0.3);
  rig.state.qx[0] = rig.state.qy[0] = rig.state.qz[0] = std::sin(0.3) * axis.x;
  rig.load_state();
  const double given = rig.model.mass[0] * kG * 0.3;
  double most = 0;
  for (int k = 0; k < 40; ++k) {
    rig.run(0.02);
    const EnergyLedger e = dynamics::energy_ledger(rig.model, rig.state, 1);
    most = std::max(most, std::fabs(e.gap) / given);
    EXPECT_GT(rig.state.uy[0], -0.03);
    EXPECT_LT(reading::deepest_overlap(rig.model, rig.state), 5e-3);
  }
  EXPECT_LT(most, 0.02);
}

TEST(ContactInSpace, a_joint_that_has_slipped_gives_way_without_a_jump) {
  ModelSpec spec = on_a_table({box("block", {-0.8, 0, -0.1}, {0.2, 0.1, 0.2})});
  StageSpec push = scenes::push_stage("block", Direction::kPlusX, 0.05, 0.05);
  spec.stage = {scenes::gravity_stage(), push};
  SpaceRig rig(compile(spec));
  rig.set_gravity({0, -kG, 0});
  rig.load_state();
  rig.run(0.3);
  rig.drive(1, 0.05);
  double before = 0, reaction = 0;
  bool handed = false;
  while (rig.state.ux[0] < 0.02) {
    before = rig.state.vy[0];
    reaction = rig.step();
    const bool now = rig.state.handed_over[0] != 0;
    if (now && !handed) {
      // of the weight nothing is missing for a step
      EXPECT_LT(std::fabs(rig.state.vy[0] - before) / rig.controls.dt, 1e-2 * kG);
      EXPECT_NEAR(rig.state.ux[0], 0.05 * 0.2, 1e-3);
    }
    handed = now;
  }
  EXPECT_TRUE(handed);
  const double weight = rig.model.mass[0] * kG;
  EXPECT_NEAR(reaction, std::tan(0.5236) * weight, 0.02 * weight);
  const EnergyLedger e = dynamics::energy_ledger(rig.model, rig.state, 1);
  EXPECT_LT(std::fabs(e.gap), 5e-3 * e.friction);
}

TEST(ContactInSpace, a_block_pushed_off_falls_on_the_ground) {
  ModelSpec spec = on_a_table({box("block", {0.1, 0, -0.1}, {0.3, 0.1, 0.2})});
  spec.solve.ground = -0.2;
  spec.stage = {scenes::gravity_stage(), scenes::push_stage("block", Direction::kPlusX, 0.5, 0.6)};
  spec.stage[1].damping = 0.1;
  const Model model = compile(spec);
  State state = initial_state(model);
  const Result result = solve(model, state);
  EXPECT_EQ(result.status, SolveStatus::kCompleted) << text_of(result.reason);
  EXPECT_NEAR(state.uy[0], -0.2, 0.1);
  EXPECT_EQ(result.debris.blocks, 1);
  EXPECT_NEAR(result.debris.volume, 0.3 * 0.1 * 0.2, 1e-12);
}

}  // namespace
}  // namespace wythe::verification::contacts_in_space_test
