// The rules that name failures of bare walls, dry and in mortar: turning about the toe above a
// stepped crack, sliding, slip under the beam or in many beds, and slip off the neighbours' faces.
#include <fmt/core.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "judge/modes/element_states.h"
#include "scenes/mechanism.h"
#include "scenes/scenes.h"
#include "wythe/parts/failure_mode.h"

namespace wythe::bare_wall_modes_test {
namespace {

using scenes::Mechanism;
using scenes::mirrored;
using scenes::Motion;
using scenes::moved;

const ElementSign& sign_of(const ElementStates& elements, const std::string& element,
                           const std::string& state) {
  for (const ElementState& e : elements)
    for (const ElementSign& s : e.signs)
      if (e.element == element && s.state == state) return s;
  throw std::runtime_error("no sign " + state + " of " + element);
}

// The wall cut at a height: what is above moves by `slip`.
Mechanism cut(double height, double slip) {
  return [=](double, double y) { return Motion{.move_x = y > height ? slip : 0}; };
}

constexpr int kColumns = 10, kCourses = 10;
constexpr double kHalf = 0.155, kCourse = 0.11, kDryLength = kColumns * kHalf;

Model bare_wall(const JointMaterial& joint) {
  ModelSpec spec = scenes::plain_wall(kColumns, kCourses, 1e-3, 0.01);
  spec.material["joint"] = joint;
  spec.wall.beam.height = 0.2;
  spec.material["beam"].density = 100;
  return compile(spec);
}
const Model& dry_wall() {
  static const Model model = bare_wall(scenes::dry_joint(2e10, 8e9, 0.6));
  return model;
}
const Model& mortared_wall() {
  static const Model model = bare_wall(scenes::paper_joint());
  return model;
}

// Above a stepped crack that rises from the right toe, everything turns about it and slides over.
Mechanism over_a_stepped_crack(double turn, double slide) {
  return [=](double x, double y) {
    const bool stands = y < (kDryLength - x) * kCourse / kHalf;
    if (stands) return Motion{};
    return Motion{.pivot_x = kDryLength, .pivot_y = 0, .turn = -turn, .move_x = slide};
  };
}

FailureMode name_bare(const Model& wall, const Mechanism& mechanism) {
  const FailureMode mode = name_from_state(wall, moved(wall, mechanism));
  const FailureMode other = name_from_state(wall, moved(wall, mirrored(mechanism, kDryLength)));
  EXPECT_EQ(other.name, mode.name);
  EXPECT_EQ(other.sentence.code, mode.sentence.code);
  return mode;
}

TEST(DryWalls, body_that_turns_about_its_toe_above_a_stepped_crack_rocks) {
  for (const double turn : {0.01, 0.025, 0.05})
    EXPECT_EQ(name_bare(dry_wall(), over_a_stepped_crack(turn, 0)).name, "rocking") << turn;
}

TEST(DryWalls, sides_that_slide_past_each_other_shear) {
  for (const double slide : {5e-3, 30e-3})
    EXPECT_EQ(name_bare(dry_wall(), over_a_stepped_crack(0, slide)).name, "shear") << slide;
}

// A plane along one bed that goes down by one course near the toe: no bed slips along all of its length.
TEST(DryWalls, what_slides_on_a_plane_that_steps_by_a_course_slides) {
  for (const Model* wall : {&dry_wall(), &mortared_wall()})
    for (const int low : {0, 1, 4})
      for (const double step : {0.3, 0.5, 0.8}) {
        const Mechanism slides = [=](double x, double y) {
          const double bed = kCourse * (low + (x < step * kDryLength ? 1 : 0));
          return Motion{.move_x = y > bed ? 30e-3 : 0};
        };
        const FailureMode mode = name_bare(*wall, slides);
        const bool at_base = low == 0 && step < 0.5;
        if (low > 0 || step != 0.5)
          EXPECT_EQ(mode.name, at_base ? "sliding at the base" : "sliding") << low << " " << step;
        else  // half of it on the foundation
          EXPECT_NE(mode.name.find("sliding"), std::string::npos) << mode.name;
      }
}

// The crack climbs from the tension side in steps of mortar that broke, then everything above turns on a bed.
TEST(DryWalls, what_turns_on_a_bed_above_a_stepped_crack_rocks) {
  const Mechanism turns = [](double x, double y) {
    const double bed = kCourse * std::min(2.0, 1 + std::floor(x / (2 * kHalf)));
    if (y < bed) return Motion{};
    return Motion{.pivot_x = kDryLength, .pivot_y = 2 * kCourse, .turn = -0.02};
  };
  EXPECT_EQ(name_bare(mortared_wall(), turns).name, "rocking");
}

// Flexural cracks at opposite corners, in two beds, are no foot that opens.
TEST(DryWalls, cracks_from_both_sides_of_a_foot_do_not_add_up) {
  const Mechanism cracks = [](double x, double y) {
    if (y < kCourse) return Motion{};
    if (x < 0.3 * kDryLength) return Motion{.move_y = 2e-3};
    if (x > 0.7 * kDryLength && y > 2 * kCourse) return Motion{.move_y = 2e-3};
    return Motion{};
  };
  EXPECT_EQ(name_bare(mortared_wall(), cracks).name.find("rocking"), std::string::npos);
}

TEST(DryWalls, mixture_of_turning_and_sliding_passes_from_rocking_to_shear_through_both) {
  // 20 mm at mid-height by turning, and more and more sliding
  std::vector<std::string> names;
  for (int k = 0; k <= 24; ++k) {
    const double slide = 2.5e-3 * k;
    const FailureMode mode = name_bare(dry_wall(), over_a_stepped_crack(0.03, slide));
    std::string name = mode.name;
    if (name == "unclear") {
      name = text_of(mode.sentence);
      EXPECT_NE(name.find("rocking"), std::string::npos) << slide << name;
      EXPECT_NE(name.find("shear"), std::string::npos) << slide << name;
    }
    if (names.empty() || names.back() != name) names.push_back(name);
  }
  EXPECT_EQ(names.front(), "rocking");
  EXPECT_EQ(names.back(), "shear");
  EXPECT_EQ(std::count(names.begin(), names.end(), "rocking"), 1)
      << fmt::format("{}", names.size());
  EXPECT_EQ(std::count(names.begin(), names.end(), "shear"), 1);
}

TEST(DryWalls, firm_names_have_no_other_name_beside_them) {
  constexpr int kSteps = 120;
  std::vector<FailureMode> modes;
  for (int k = 0; k <= kSteps; ++k)
    modes.push_back(name_bare(dry_wall(), over_a_stepped_crack(0.03, 0.5e-3 * k)));
  int firm = 0;
  for (int k = 1; k < kSteps; ++k) {
    if (modes[k].name == "unclear" || !is_firm(modes[k])) continue;
    ++firm;
    EXPECT_EQ(modes[k - 1].name, modes[k].name) << k;
    EXPECT_EQ(modes[k + 1].name, modes[k].name) << k;
  }
  EXPECT_GT(firm, kSteps / 4);
  for (const auto& [kind, score] : modes.front().scores) {  // each kind counts
    FailureMode doubtful = modes.front();
    doubtful.scores = {{kind, 0.5}};
    EXPECT_FALSE(is_firm(doubtful)) << kind;
  }
}

TEST(DryWalls, crack_that_had_to_break_mortar_is_shear_however_the_parts_move_later) {
  EXPECT_EQ(name_bare(mortared_wall(), over_a_stepped_crack(0.025, 0)).name, "shear");
}

TEST(DryWalls, mortar_that_adds_next_to_nothing_is_none_and_there_is_no_jump_between) {
  // every bed pressed by 40 kPa, strengths of a share of that
  constexpr double kStiffness = 2e10, kPressed = 2e-6;
  std::vector<std::string> names;
  for (int k = 0; k <= 60; ++k) {
    const double share = 0.001 * (k + 1);
    JointMaterial weak = scenes::paper_joint();
    weak.normal_stiffness = kStiffness;
    weak.tensile_strength = weak.cohesion = share * kStiffness * kPressed;
    const Model wall = bare_wall(weak);
    const Mechanism turns = over_a_stepped_crack(0.025, 0);
    const auto pressed = [&](double x, double y) {
      Motion m = turns(x, y);
      m.move_y -= kPressed * (1 + std::floor(y / kCourse));
      return m;
    };
    const FailureMode mode = name_bare(wall, pressed);
    const std::string name = mode.name == "unclear" ? text_of(mode.sentence) : mode.name;
    if (names.empty() || names.back() != name) names.push_back(name);
  }
  EXPECT_EQ(names.front(), "rocking");
  EXPECT_EQ(names.back(), "shear");
  EXPECT_GT(names.size(), 2U);
  for (std::size_t k = 1; k + 1 < names.size(); ++k) {
    EXPECT_NE(names[k].find("rocking"), std::string::npos) << names[k];
    EXPECT_NE(names[k].find("shear"), std::string::npos) << names[k];
  }
}

TEST(DryWalls, top_held_level_rocks_between_two_toes) {
  // the strut turns about the right toe below and the left one above, wedges stay with base and beam
  const double top = kCourses * kCourse, turn = 0.02;
  const auto strut = [=](double x, double y) {
    if (y < 0.6 * (kDryLength - x) * kCourse / kHalf) return Motion{};
    const Motion body{.pivot_x = kDryLength, .pivot_y = 0, .turn = -turn};
    const bool hangs = y > top || top - y < 0.6 * x * kCourse / kHalf;
    if (!hangs) return body;
    return Motion{.move_x = turn * top, .move_y = turn * kDryLength};
  };
  EXPECT_EQ(name_bare(dry_wall(), strut).name, "rocking");
}

// --- sliding -------------------------------------------------------------------------------------

TEST(Sliding, under_a_beam_is_seen) {
  const double top = kCourses * kCourse;
  const auto beam = [=](double, double y) { return Motion{.move_x = y > top ? 11e-3 : 0.0}; };
  for (const Model* wall : {&dry_wall(), &mortared_wall()}) {
    const FailureMode mode = name_bare(*wall, beam);
    EXPECT_EQ(mode.name, "sliding at the top");
    EXPECT_NEAR(sign_of(mode.elements, "top joint", study::kSliding).value, 11, 1e-6);
  }
}

TEST(Sliding, little_in_each_of_many_beds_counts_together) {
  // a third of a threshold in each bed
  const double slip = rules_for(dry_wall()).sliding / 3;
  const auto sheared = [=](double, double y) {
    return Motion{.move_x = slip * std::floor(y / kCourse)};
  };
  EXPECT_EQ(name_bare(dry_wall(), sheared).name, "sliding");
  // to and fro it is no sliding
  const auto rattled = [=](double, double y) {
    return Motion{.move_x = slip * (static_cast<int>(y / kCourse) % 2)};
  };
  EXPECT_EQ(name_bare(dry_wall(), rattled).name, "unclear");
}

TEST(Sliding, on_most_of_the_way_is_not_shear_for_the_small_cracks_on_it) {
  // 20 mm on the foundation, 15 mm in a bed, and columns that part by 1.5 mm each
  const auto slides = [](double x, double y) {
    const double parts = std::floor((x - y) / kHalf);
    return Motion{.move_x = 20e-3 + (y > 0.3 ? 15e-3 : 0.0) + 1.5e-3 * parts};
  };
  const FailureMode mode = name_from_state(dry_wall(), moved(dry_wall(), slides));
  EXPECT_TRUE(sign_of(mode.elements, "wall", study::kDiagonal).holds());
  EXPECT_EQ(mode.name, "sliding + sliding at the base");
}

TEST(SlidOff, name_is_not_vouched_for_where_half_a_section_has_no_face_left) {
  for (const double slip : {0.45 * kHalf, 0.55 * kHalf}) {
    State state = moved(dry_wall(), cut(0.6, slip));
    for (std::size_t b = 0; b < state.uy.size(); ++b)
      if (state.ux[b] > 0) state.uy[b] = -1e-6;  // pressed
    const FailureMode mode = name_from_state(dry_wall(), state);
    EXPECT_EQ(mode.name, slip < 0.5 * kHalf ? "sliding" : "unclear");
    EXPECT_EQ(mode.sentence.code.starts_with("mode.slid_off"), slip > 0.5 * kHalf) << mode.sentence;
  }
}

}  // namespace
}  // namespace wythe::bare_wall_modes_test
