// Differences and unions of outlines: areas add up, corners keep their bits, corners that differ by one grid line are joined.
#include "geometry/wall/clip.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

namespace wythe::geometry::clip_test {
namespace {

constexpr double kGrid = 1e-9;  // [m]

// The opening below a round arch, as a polygon.
Polygon round_opening(double radius, Vec2 centre, int parts) {
  Polygon outline{{centre.x - radius, 0}, {centre.x + radius, 0}};
  for (int k = 0; k <= parts; ++k) {
    const double turn = M_PI * k / parts;
    outline.push_back({centre.x + radius * std::cos(turn), centre.y + radius * std::sin(turn)});
  }
  return outline;
}

bool has_corner(const Polygon& outline, Vec2 p) {
  return std::any_of(outline.begin(), outline.end(),
                     [&](Vec2 q) { return q.x == p.x && q.y == p.y; });
}

// Units of walls, cut by openings at any place; `size` 1 for bricks and doors, 10 for stones and bridges.
template <class Check>
void cut_many(double size, const Check& check) {
  std::mt19937 random(3);  // NOLINT(cert-msc51-cpp): the same walls each time
  const auto between = [&](double low, double high) {
    return size * (low + (high - low) * static_cast<double>(random()) / 4294967296.0);
  };
  const auto below = [&](unsigned n) { return static_cast<int>(random() % n); };
  for (int k = 0; k < 400; ++k) {
    const Polygon opening =
        round_opening(between(0.3, 1.2), {between(1, 2), between(0.8, 1.4)}, 6 + below(30));
    const double x = size * 0.125 * below(24), y = size * 0.1 * below(24) - between(0, 0.06);
    check(outline_of({x, y, x + between(0.1, 0.5), y + size * 0.1}), opening);
  }
}

TEST(Clip, what_is_left_and_what_is_cut_off_are_the_whole) {
  for (const double size : {1.0, 10.0}) {
    int cut = 0;
    cut_many(size, [&](const Polygon& unit, const Polygon& opening) {
      double left = 0;
      for (const Polygon& part : difference(unit, opening)) {
        EXPECT_TRUE(is_simple(part));
        EXPECT_GT(moments(part).area, 0);
        left += moments(part).area;
      }
      const double off = overlap_area(unit, opening), whole = moments(unit).area;
      cut += off > 0 && left > 0 ? 1 : 0;
      EXPECT_NEAR(left + off, whole, 6 * size * kGrid);  // a line off along the outline
    });
    EXPECT_GT(cut, 50);
  }
}

TEST(Clip, corners_on_a_line_of_the_grid_with_a_given_one_have_its_bits) {
  cut_many(1, [](const Polygon& unit, const Polygon& opening) {
    for (const Polygon& part : difference(unit, opening))
      for (const Vec2& p : part)
        for (const auto axis : {&Vec2::x, &Vec2::y}) {
          bool is_near = false, is_same = false;
          for (const Polygon* given : {&unit, &opening})
            for (const Vec2& q : *given) {
              is_near |= std::llround(p.*axis / kGrid) == std::llround(q.*axis / kGrid);
              is_same |= p.*axis == q.*axis;
            }
          EXPECT_EQ(is_near, is_same) << p.*axis;
        }
  });
}

TEST(Clip, corners_a_line_apart_are_one) {
  Polygon unit = outline_of({0, 0, 0.25, 0.1});
  unit.insert(unit.begin() + 1, {0.1, -kGrid});  // below the straight side
  unit.push_back({kGrid, 0.1 - kGrid});          // beside a corner
  const std::vector<Polygon> left = difference(unit, outline_of({0.2, -1, 1, 1}));
  ASSERT_EQ(left.size(), 1u);
  EXPECT_EQ(left[0].size(), 4u);
}

TEST(Clip, an_outline_apart_is_left_as_it_was) {
  const Polygon unit = outline_of({0.1, 0.2, 0.35, 0.3}), far = outline_of({2, 2, 3, 3});
  const std::vector<Polygon> left = difference(unit, far);
  ASSERT_EQ(left.size(), 1u);
  ASSERT_EQ(left[0].size(), unit.size());
  for (const Vec2& p : unit) EXPECT_TRUE(has_corner(left[0], p));
  EXPECT_TRUE(difference(unit, outline_of({0, 0, 1, 1})).empty());
}

TEST(Clip, two_that_share_a_side_are_one_and_others_none) {
  const Polygon left = outline_of({0, 0, 0.3, 0.1}), right = outline_of({0.3, 0, 0.5, 0.1});
  const Polygon whole = joined_outline(left, right);
  ASSERT_EQ(whole.size(), 4u);  // no corner where both met
  EXPECT_NEAR(moments(whole).area, 0.05, 1e-12);
  EXPECT_EQ(joined_outline(left, outline_of({0.1, 0.1, 0.2, 0.2})).size(), 8u);
  EXPECT_TRUE(joined_outline(left, outline_of({0.3, 0.1, 0.5, 0.2})).empty());  // a corner alone
  EXPECT_TRUE(joined_outline(left, outline_of({0.4, 0, 0.5, 0.1})).empty());
  // a trough and its lid: as one outline they would fill it
  const Polygon trough{{0, 0},      {0.3, 0},    {0.3, 0.1}, {0.2, 0.1},
                       {0.2, 0.05}, {0.1, 0.05}, {0.1, 0.1}, {0, 0.1}};
  EXPECT_TRUE(joined_outline(trough, outline_of({0.1, 0.1, 0.3, 0.2})).empty());
}

}  // namespace
}  // namespace wythe::geometry::clip_test
