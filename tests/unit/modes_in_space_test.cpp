// Names of failures in space: walls moved by hand as each mechanism moves them, and what looks like one and is
// none.
#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <string>
#include <vector>

#include "scenes/scenes.h"
#include "scenes/space_rig.h"
#include "study/modes/in_space.h"
#include "wythe/failure_mode.h"
#include "wythe/mechanism.h"

namespace wythe {
namespace {

using scenes::box;
using scenes::Frame;

constexpr double kLong = 2.4, kHigh = 1.6, kThick = 0.2, kDegree = M_PI / 180;

// Running bond of 0.4 x 0.2 m along x; where asked a return along z at x = 0, toothed in.
std::vector<BodySpec> bodies(bool with_return) {
  std::vector<BodySpec> all{box("floor", {-1, -0.2, -1}, {5, 0.2, 5}, true)};
  const auto unit = [&](Vec3 corner, Vec3 size) {
    all.push_back(box("u" + std::to_string(all.size()), corner, size));
  };
  for (int course = 0; course < 8; ++course) {
    const double y = 0.2 * course;
    const bool odd = course % 2 == 1;
    for (double x = odd ? -0.2 : 0; x < kLong - 0.1; x += 0.4) {
      const double from = std::max(x, with_return && odd ? 0.2 : 0.0),
                   to = std::min(x + 0.4, kLong);
      if (to > from + 0.1) unit({from, y, 0}, {to - from, 0.2, kThick});
    }
    if (!with_return) continue;
    for (double z = odd ? 0 : 0.2; z < 1.6 - 0.1; z += 0.4) unit({0, y, z}, {kThick, 0.2, 0.4});
  }
  return all;
}

struct Wall {
  Frame frame;
  Model model;
  State state;

  explicit Wall(bool with_return = false, const Frame& seen = {})
      : Wall(bodies(with_return), seen) {}
  Wall(const std::vector<BodySpec>& all, const Frame& seen)
      : frame(seen),
        model(compile(scenes::in_frame(scenes::in_space(all, scenes::paper_joint()), seen))),
        state(initial_state(model)) {}

  // Blocks of which `takes` says yes at their centroid turn by `turn` about `about`, then shift.
  Wall& move(const std::function<bool(Vec3)>& takes, Vec3 turn, Vec3 about, Vec3 shift = {}) {
    for (std::size_t i = 0; i < state.ux.size(); ++i) {
      const Vec3 here = model.space.centroid[i] - frame.shift;
      const Vec3 at{dot(here, frame.direction({1, 0, 0})), dot(here, frame.direction({0, 1, 0})),
                    dot(here, frame.direction({0, 0, 1}))};
      if (!takes(at)) continue;
      const Vec3 to = turned(at - about, Rotation{turn}, about) + shift;
      const Vec3 u = frame.direction(to - at);
      state.ux[i] += u.x, state.uy[i] += u.y, state.uz[i] += u.z;
      const double angle = length(turn);
      if (angle == 0) continue;
      const Vec3 v = std::sin(angle / 2) / angle * frame.direction(turn);
      state.qw[i] = std::cos(angle / 2);
      state.qx[i] = v.x, state.qy[i] = v.y, state.qz[i] = v.z;
    }
    return *this;
  }
  [[nodiscard]] FailureMode mode() const { return study::name_in_space(model, state); }
  [[nodiscard]] std::string name() const { return mode().name; }
};

const auto everything = [](Vec3) { return true; };
const auto upper = [](Vec3 c) { return c.y > 0.8; };

// In the wall's own axes and in a world turned about the upright axis.
class ModesInSpace : public testing::TestWithParam<double> {
 protected:
  [[nodiscard]] Frame frame() const {
    return Frame::turned(std::cos(GetParam() / 2), 0, std::sin(GetParam() / 2), 0, {1, 0, 2});
  }
  [[nodiscard]] Wall wall(bool with_return = false) const { return Wall(with_return, frame()); }
};

TEST_P(ModesInSpace, a_wall_that_turns_about_its_foot_overturns_however_far) {
  for (const double degrees : {0.5, 3.0, 20.0, 60.0}) {
    const FailureMode mode = wall().move(everything, {-degrees * kDegree, 0, 0}, {0, 0, 0}).mode();
    EXPECT_EQ(mode.name, "overturning") << degrees;
    EXPECT_NEAR(mode.sentence.number("degrees"), degrees, 0.01 * degrees);
    EXPECT_GT(mode.scores.at("one piece"), 0.99);
  }
}

// A pillar's centre is where its own turn moves nothing; its corners tell.
TEST_P(ModesInSpace, a_single_stone_that_topples_does_not_slide) {
  for (const int stones : {1, 3}) {
    std::vector<BodySpec> pillar{box("floor", {-1, -0.2, -1}, {3, 0.2, 3}, true)};
    for (int k = 0; k < stones; ++k)
      pillar.push_back(
          box("s" + std::to_string(k), {0, 3.0 * k / stones, 0}, {0.5, 3.0 / stones, 0.5}));
    const auto all = [](Vec3) { return true; };
    EXPECT_NE(Wall(pillar, frame()).move(all, {0, 0, -2 * kDegree}, {0.5, 0, 0}).name(), "sliding")
        << stones;
    EXPECT_NE(Wall(pillar, frame()).move(all, {2 * kDegree, 0, 0}, {0, 0, 0.5}).name(), "sliding")
        << stones;
    EXPECT_EQ(Wall(pillar, frame()).move(all, {}, {}, {0.05, 0, 0}).name(), "sliding") << stones;
  }
}

TEST_P(ModesInSpace, a_wall_that_turns_about_its_toe_rocks_in_its_plane) {
  EXPECT_EQ(wall().move(everything, {0, 0, -2 * kDegree}, {kLong, 0, 0}).name(), "rocking");
}

TEST_P(ModesInSpace, what_shifts_along_or_across_slides_and_what_goes_down_does_not) {
  for (const Vec3 way : {Vec3{0.01, 0, 0}, Vec3{0, 0, -0.01}, Vec3{0.01, 0, 0.01}})
    EXPECT_EQ(wall().move(upper, {}, {}, way).name(), "sliding");
  EXPECT_EQ(wall().move([](Vec3 c) { return c.x > 1.2; }, {}, {}, {0, -0.01, 0}).name(), "unclear");
  EXPECT_EQ(wall().move(upper, {}, {}, {0, 0.01, 0}).name(), "unclear");
}

TEST_P(ModesInSpace, a_part_that_turns_about_an_upright_axis_turns) {
  EXPECT_EQ(wall().move(upper, {0, 2 * kDegree, 0}, {1.2, 0, 0.1}).name(), "turning");
}

TEST_P(ModesInSpace, a_wall_held_at_top_and_foot_bends) {
  // both halves turn against each other about a hinge at mid height, which moves out
  Wall w = wall();
  const double t = 2 * kDegree;
  w.move([](Vec3 c) { return c.y < 0.8; }, {t, 0, 0}, {0, 0, 0});
  w.move(upper, {-t, 0, 0}, {0, 0.8, 0}, {0, 0, 0.8 * std::sin(t)});
  const FailureMode mode = w.mode();
  EXPECT_EQ(mode.name, "bending");
  EXPECT_NEAR(mode.sentence.number("y_m"), 0.9, 0.15);
}

TEST_P(ModesInSpace, a_wall_held_at_both_sides_bends_sideways) {
  Wall w = wall();
  const double t = 2 * kDegree;
  w.move([](Vec3 c) { return c.x < 1.2; }, {0, -t, 0}, {0, 0, 0});
  w.move([](Vec3 c) { return c.x > 1.2; }, {0, t, 0}, {kLong, 0, 0});
  EXPECT_EQ(w.name(), "horizontal bending");
}

TEST_P(ModesInSpace, a_wall_held_at_its_sides_and_foot_bends_both_ways) {
  // two triangles turn about the sides, the one between them about the foot
  Wall w = wall();
  const double t = 2 * kDegree;
  const auto below = [](Vec3 c) { return c.y < 1.2 * std::min(c.x, kLong - c.x) / 1.2; };
  w.move([&](Vec3 c) { return !below(c) && c.x < 1.2; }, {0, -t, 0}, {0, 0, 0});
  w.move([&](Vec3 c) { return !below(c) && c.x > 1.2; }, {0, t, 0}, {kLong, 0, 0});
  w.move(below, {t, 0, 0}, {0, 0, 0});
  EXPECT_EQ(w.name(), "two-way bending");
}

TEST_P(ModesInSpace, a_wedge_at_a_corner_tilts_out_of_both_walls) {
  Wall w = wall(true);
  // about a line across the corner at mid height, away from both walls
  const double t = 2 * kDegree / std::sqrt(2.0);
  w.move([](Vec3 c) { return c.y > 0.6 && c.x + c.z < 1.5; }, {-t, 0, t}, {0, 0.6, 0});
  EXPECT_EQ(w.name(), "corner wedge");
}

TEST_P(ModesInSpace, a_wall_that_shears_in_its_plane_is_told_from_one_whose_parts_rock) {
  Wall shears = wall();
  for (int course = 1; course < 8; ++course)
    shears.move([&](Vec3 c) { return c.y > 0.2 * course; }, {}, {}, {0.003 * course, 0, 0});
  EXPECT_EQ(shears.name(), "in-plane shear");
  Wall rocks = wall();
  for (const double toe : {0.8, 1.6, 2.4})
    rocks.move([&](Vec3 c) { return c.x < toe && c.x > toe - 0.8; }, {0, 0, -1 * kDegree},
               {toe, 0, 0});
  EXPECT_EQ(rocks.name(), "in-plane rocking");
}

TEST_P(ModesInSpace, a_wall_that_drags_stones_of_its_return_overturns) {
  Wall w = wall(true);
  const auto facade = [](Vec3 c) { return c.z < 0.25 && c.y > 0.2; };
  w.move(facade, {-4 * kDegree, 0, 0}, {0, 0.2, 0});
  w.move([&](Vec3 c) { return !facade(c) && c.y > 0.6 && c.z < c.y - 0.4; }, {4 * kDegree, 0, 0},
         {0, 0.6, 1.2}, {0, 0, -0.05});
  const FailureMode mode = w.mode();
  EXPECT_EQ(mode.name, "overturning");
  EXPECT_EQ(mode.sentence.code, "space.drags");
}

TEST_P(ModesInSpace, a_stone_that_fell_far_does_not_name_the_wall_behind_it) {
  Wall w = wall();
  w.move(everything, {-1 * kDegree, 0, 0}, {0, 0, 0});
  w.state.uy[20] -= 1.0;
  EXPECT_EQ(w.name(), "unclear");
  EXPECT_EQ(w.mode().sentence.code, "space.loose");
}

TEST_P(ModesInSpace, what_has_slid_off_its_support_gets_no_name) {
  Wall w = wall();
  w.move(upper, {}, {}, {0, -1e-6, 0.15});  // pressed, by three quarters of its depth
  const FailureMode mode = w.mode();
  EXPECT_EQ(mode.name, "unclear");
  EXPECT_EQ(mode.sentence.code, "mode.slid_off");
}

TEST_P(ModesInSpace, a_force_that_fell_is_not_called_none) {
  const Wall w = wall();
  EXPECT_EQ(w.name(), "none");
  Result result;
  Snapshot read;
  read.state = w.state;
  read.displacement = 0.04;
  result.readings = {read};
  for (int k = 0; k <= 40; ++k) {
    CurveRow row;
    row.displacement = 1e-3 * k;
    row.reaction = row.base_shear = k < 10 ? 100.0 * k : 1000.0 - 20 * (k - 10);
    result.curve.push_back(row);
  }
  EXPECT_EQ(name_failure_mode(w.model, result).name, "unclear");
  EXPECT_EQ(read_mechanism(w.model, result).name, "unclear");
  for (CurveRow& row : result.curve) row.reaction = row.base_shear = 1000;
  EXPECT_EQ(name_failure_mode(w.model, result).name, "none");
}

INSTANTIATE_TEST_SUITE_P(Turned, ModesInSpace, testing::Values(0.0, 0.7, 2.5));

}  // namespace
}  // namespace wythe
