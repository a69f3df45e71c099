// Names of failures in space: walls moved like each
// mechanism, and motions that look similar but are none.
#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <string>
#include <vector>

#include "judge/modes/in_space.h"
#include "scenes/scenes.h"
#include "scenes/space_rig.h"
#include "wythe/parts/failure_mode.h"
#include "wythe/parts/mechanism.h"

namespace wythe::modes_in_space_test {
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

// A wall that just does not stand has moved little when its run ends: 0.05 degrees open its foot by 0.17 mm, 0.06 % of a joint.
TEST_P(ModesInSpace, a_tenth_of_the_motion_names_a_wall_that_is_known_to_fall) {
  const auto name = [&](Wall moved) {
    return study::name_in_space(moved.model, moved.state, study::kLeastMovementOfFall).name;
  };
  const Vec3 little{-0.05 * kDegree, 0, 0};
  EXPECT_EQ(wall().move(everything, little, {0, 0, 0}).name(), "none");
  EXPECT_EQ(name(wall().move(everything, little, {0, 0, 0})), "overturning");
  EXPECT_EQ(name(wall().move(everything, {}, {}, {0.3e-3, 0, 0})), "sliding");
  EXPECT_EQ(name(wall()), "none");
  EXPECT_EQ(name(wall().move(everything, 0.1 * little, {0, 0, 0})), "none");
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
  result.states.readings = {read};
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

// --- walls that a slab ties -------------------------------------------------------------------------------

constexpr double kApart = 3.0;

// Two walls along x, 3 m apart, and a slab across their tops; `right_length` of the second, `right_from` where it begins.
std::vector<BodySpec> tied_walls(double right_length = kLong, double right_from = 0) {
  std::vector<BodySpec> all{box("floor", {-1, -0.2, -1}, {8, 0.2, 6}, true)};
  const auto wall = [&](const std::string& name, double from, double length, double z) {
    for (int course = 0; course < 8; ++course)
      for (double x = course % 2 == 1 ? -0.2 : 0; x < length - 0.1; x += 0.4) {
        const double at = std::max(x, 0.0), to = std::min(x + 0.4, length);
        all.push_back(box(name + ".c0" + std::to_string(course) + "u" + std::to_string(all.size()),
                          {from + at, 0.2 * course, z}, {to - at, 0.2, kThick}));
      }
  };
  wall("front", 0, kLong, 0);
  wall("back", right_from, right_length, kApart);
  all.push_back(
      box("deck", {0, 1.6, 0}, {std::min(kLong, right_from + right_length), 0.2, kApart + kThick}));
  all.back().role = "slab";
  return all;
}
const auto is_front = [](Vec3 c) { return c.y < 1.6 && c.z < 1.5; };
const auto is_back = [](Vec3 c) { return c.y < 1.6 && c.z > 1.5; };
const auto is_deck = [](Vec3 c) { return c.y > 1.6; };

// Both walls lean to +z by `front` and `back` about their toes; the slab lies on their inner edges and moves as they do.
Wall leaning(const Frame& frame, double front, double back) {
  Wall w(tied_walls(), frame);
  w.move(is_front, {front, 0, 0}, {0, 0, kThick});
  w.move(is_back, {back, 0, 0}, {0, 0, kApart + kThick});
  const double t = 0.5 * (front + back);
  w.move(is_deck, {}, {}, {0, 1.6 * (std::cos(t) - 1) + kThick * std::sin(t), 1.6 * std::sin(t)});
  return w;
}

TEST_P(ModesInSpace, walls_that_a_slab_ties_overturn_together_about_lines_of_their_own) {
  for (const double degrees : {1.0, 4.0, 15.0}) {
    const FailureMode mode = leaning(frame(), degrees * kDegree, degrees * kDegree).mode();
    EXPECT_EQ(mode.name, "overturning") << degrees;
    EXPECT_EQ(mode.sentence.code, "space.together");
    EXPECT_NEAR(mode.sentence.number("degrees"), degrees, 0.01 * degrees);
    const std::string said = text_of(mode.sentence);
    EXPECT_NE(said.find("wall front at height"), std::string::npos) << said;
    EXPECT_NE(said.find("wall back at height"), std::string::npos) << said;
  }
}

TEST_P(ModesInSpace, walls_whose_turns_differ_do_not_overturn_together) {
  EXPECT_EQ(leaning(frame(), 2 * kDegree, 1 * kDegree).name(), "unclear");
  EXPECT_EQ(leaning(frame(), 2 * kDegree, -2 * kDegree).name(), "unclear");
}

// Equal turns alone say little: a foot that slides away, a wall that hangs from its top, a turn about the other axis.
TEST_P(ModesInSpace, equal_turns_about_no_foot_get_no_name) {
  const double t = 2 * kDegree;
  Wall slides(tied_walls(), frame());
  slides.move(is_front, {t, 0, 0}, {0, 0, kThick}, {0, 0, 0.03});
  slides.move(is_back, {t, 0, 0}, {0, 0, kApart + kThick}, {0, 0, 0.03});
  EXPECT_EQ(slides.name(), "unclear");
  Wall one(tied_walls(), frame());
  one.move(is_front, {t, 0, 0}, {0, 0, kThick});
  one.move(is_back, {}, {}, {0, 0, 0.8 * t});
  EXPECT_EQ(one.name(), "unclear");
  Wall hangs(tied_walls(), frame());
  hangs.move(is_front, {-t, 0, 0}, {0, 1.6, kThick});
  hangs.move(is_back, {-t, 0, 0}, {0, 1.6, kApart + kThick});
  EXPECT_EQ(hangs.name(), "unclear");
  Wall twists(tied_walls(), frame());
  twists.move(is_front, {t, 0, 0}, {0, 0, kThick});
  twists.move(is_back, {0, 0, -t}, {kLong, 0, 0});
  EXPECT_EQ(twists.name(), "unclear");
}

TEST_P(ModesInSpace, walls_that_do_not_fall_because_of_a_slab_that_slips_are_not_named) {
  const double t = 2 * kDegree;
  Wall w = leaning(frame(), t, t);
  w.move(is_deck, {}, {}, {0.02, 0, 0});  // beside their way
  const FailureMode mode = w.mode();
  EXPECT_EQ(mode.name, "unclear");
  EXPECT_EQ(mode.sentence.code, "space.slab_slips");
  // a slab that stays where another wall holds it, while one wall leaves it, hides nothing
  Wall leaves(tied_walls(), frame());
  leaves.move(is_front, {-t, 0, 0}, {0, 0, 0});
  EXPECT_EQ(leaves.name(), "overturning");
  // and one that goes far beyond the walls is what fails
  Wall slides(tied_walls(), frame());
  slides.move(is_front, {-0.2 * kDegree, 0, 0}, {0, 0, 0});
  slides.move(is_deck, {}, {}, {0.1, 0, 0});
  EXPECT_EQ(slides.name(), "sliding");
}

// Seen from above two walls are far longer across than along: their own planes count, not the plan of both.
TEST_P(ModesInSpace, walls_that_rock_together_in_their_planes_are_told_from_those_that_leave_them) {
  for (const double from : {0.0, 0.8}) {  // same toes, and toes apart
    Wall w(tied_walls(1.6, from), frame());
    const double t = -2 * kDegree;
    w.move(is_front, {0, 0, t}, {kLong, 0, 0});
    w.move(is_back, {0, 0, t}, {from + 1.6, 0, 0});
    const FailureMode mode = w.mode();
    // one rigid piece explains 85 % of it or not, by how far the toes are apart
    EXPECT_TRUE(mode.name == "rocking" || mode.name == "in-plane rocking") << mode.sentence;
    EXPECT_NE(text_of(mode.sentence).find("walls front, back"), std::string::npos);
  }
  std::vector<BodySpec> far = tied_walls(0.8), piers;
  for (const BodySpec& body : far)  // two piers of 0.8 m, 3 m apart: long only across
    if (body.part[0].vertex[0].x < 0.75 || body.fixed || body.role == "slab") piers.push_back(body);
  Wall w(piers, frame());
  w.move(is_front, {2 * kDegree, 0, 0}, {0, 0, kThick});
  w.move(is_back, {2 * kDegree, 0, 0}, {0, 0, kApart + kThick});
  EXPECT_EQ(w.name(), "overturning");
}

INSTANTIATE_TEST_SUITE_P(Turned, ModesInSpace, testing::Values(0.0, 0.7, 2.5));

// The effect of a push on walls depends on their positions, not on the name of the failure.
TEST(ModesInSpace, the_push_tells_which_walls_it_goes_across) {
  for (const Frame& frame : {Frame{}, Frame::turned(1, 0, 0.7, 0, {1, 2, 3})}) {
    const Wall one(false, frame), corner(true, frame);
    const auto by = [&](const Wall& wall, Vec3 push) {
      return study::walls_by_push(wall.model, frame.direction(push));
    };
    EXPECT_TRUE(by(one, {1, 0, 0}).all_along());
    EXPECT_TRUE(by(one, {0.9848, 0, 0.1736}).all_along());  // ten degrees off
    EXPECT_TRUE(by(one, {0, 0, 1}).all_across());
    EXPECT_TRUE(by(one, {0.7071, 0, 0.7071}).all_across());
    // an angle of stones without names has no plane: neither is known of it
    EXPECT_FALSE(by(corner, {1, 0, 0}).all_along());
    EXPECT_FALSE(by(corner, {1, 0, 0}).all_across());
  }
}

}  // namespace
}  // namespace wythe::modes_in_space_test
