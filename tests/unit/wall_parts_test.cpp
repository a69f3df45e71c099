// The parts a wall is read by, and the names of walls that are not of two piers and one opening.
#include "study/modes/wall_parts.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <utility>
#include <vector>

#include "scenes/mechanism.h"
#include "scenes/scenes.h"
#include "wythe/failure_mode.h"

namespace wythe {
namespace {

using scenes::Mechanism;
using scenes::mirror_name;
using scenes::mirrored;
using scenes::Motion;
using scenes::moved;

constexpr double kRoundOff = 1e-9;

const Model& tuff_wall() {
  static const Model model = compile(scenes::tuff_wall(WYTHE_SOURCE_DIR, 50e-3));
  return model;
}

// The wall cut at a height: what is above moves by `slip`.
Mechanism cut(double height, double slip) {
  return [=](double, double y) { return Motion{.move_x = y > height ? slip : 0}; };
}

// --- parts -----------------------------------------------------------------------------------

std::vector<std::string> pier_names(const study::WallParts& parts) {
  std::vector<std::string> names;
  for (const study::Pier& p : parts.piers) names.push_back(p.name);
  return names;
}

TEST(WallParts, tuff_wall_has_two_piers_a_spandrel_and_two_connections) {
  const study::WallParts parts = study::find_parts(tuff_wall());
  EXPECT_EQ(pier_names(parts), (std::vector<std::string>{"left pier", "right pier"}));
  ASSERT_EQ(parts.spandrels.size(), 1U);
  const study::Spandrel& s = parts.spandrels[0];
  EXPECT_NEAR(s.box.x0, 1.70, 1e-3);  // the fit moves edges by less than a millimetre
  EXPECT_NEAR(s.box.x1, 3.40, 1e-3);
  EXPECT_NEAR(s.box.y0, 24 * 3.62 / 33, kRoundOff);
  EXPECT_NEAR(s.lintel, 3.62 / 33, kRoundOff);
  EXPECT_EQ(parts.connections.size(), 2U);
  EXPECT_EQ(parts.toes.size(), 4U);
}

TEST(WallParts, window_has_a_sill_and_piers_as_high_as_itself) {
  const study::WallParts parts = study::find_parts(compile(scenes::small_wall()));
  ASSERT_EQ(parts.spandrels.size(), 2U);
  EXPECT_EQ(parts.spandrels[0].name, "sill");
  EXPECT_EQ(parts.spandrels[1].name, "spandrel");
  for (const study::Pier& p : parts.piers) {
    EXPECT_NEAR(p.box.y0, parts.spandrels[0].box.y1, kRoundOff);
    EXPECT_NEAR(p.box.y1, parts.spandrels[1].box.y0, kRoundOff);
    EXPECT_EQ(p.base, 0);
  }
}

TEST(WallParts, wall_without_opening_is_one_pier) {
  const study::WallParts parts = study::find_parts(compile(scenes::plain_wall(8, 8, 2e-3, 0.02)));
  EXPECT_EQ(pier_names(parts), std::vector<std::string>{"wall"});
  EXPECT_TRUE(parts.spandrels.empty());
}

// A wall of half units with windows at the given columns and courses, 3 x 3 each.
Model windows(const std::vector<std::pair<int, int>>& at, int columns, int courses) {
  ModelSpec spec = scenes::plain_wall(columns, courses, 2e-3, 0.02);
  const double column = spec.wall.length / columns, course = spec.wall.height / courses;
  for (const auto& [i, j] : at) {
    OpeningSpec o;
    o.x = i * column;
    o.y = j * course;
    o.width = 3 * column;
    o.height = 3 * course;
    spec.wall.opening.push_back(o);
  }
  return compile(spec);
}

TEST(WallParts, two_windows_make_three_piers_and_two_spandrels) {
  const study::WallParts parts = study::find_parts(windows({{3, 2}, {9, 2}}, 15, 8));
  EXPECT_EQ(pier_names(parts), (std::vector<std::string>{"pier 1", "pier 2", "pier 3"}));
  EXPECT_EQ(parts.openings, 2);
  ASSERT_EQ(parts.connections.size(), 4U);
  EXPECT_EQ(parts.connections[2].name, "left connection of spandrel 2");
}

TEST(WallParts, two_storeys_have_their_own_piers_and_spandrels) {
  const study::WallParts parts = study::find_parts(windows({{3, 0}, {3, 6}}, 9, 12));
  ASSERT_EQ(parts.piers.size(), 4U);
  EXPECT_NEAR(parts.piers[1].base, parts.piers[0].box.y1, kRoundOff);
  ASSERT_EQ(parts.spandrels.size(), 2U);  // no sill: the wall between the windows is a spandrel
  EXPECT_NEAR(parts.spandrels[0].box.y1, parts.piers[1].box.y0, kRoundOff);
}

// --- blocks files ----------------------------------------------------------------------------

constexpr scenes::BondSize kDoor{
    .columns = 16, .courses = 16, .hole_at_column = 6, .hole_at_course = 4, .hole = 4};

// Left pier's part above a diagonal leans, the rest stands: by place only, not by number.
Motion leaning(double x, double y) {
  return x < 0.93 && y > 0.4 + 0.5 * (0.93 - x) ? Motion{.turn = 0.02, .move_x = -3e-3} : Motion{};
}

std::vector<std::pair<std::string, double>> measures(const ModelSpec& spec,
                                                     const Mechanism& mechanism) {
  const Model model = compile(spec);
  std::vector<std::pair<std::string, double>> all;
  for (const ElementState& e : read_elements(model, moved(model, mechanism)))
    for (const ElementSign& s : e.signs) all.emplace_back(e.element + ": " + s.state, s.value);
  return all;
}

TEST(BlocksFile, has_the_parts_of_its_holes) {
  const Model model = compile(scenes::half_units(kDoor, scenes::paper_joint()));
  const study::WallParts parts = study::find_parts(model);
  EXPECT_EQ(parts.openings, 1);
  EXPECT_EQ(pier_names(parts), (std::vector<std::string>{"left pier", "right pier"}));
  EXPECT_NEAR(parts.piers[0].box.x1, 6 * 0.155, kRoundOff);
  EXPECT_NEAR(parts.spandrels.back().box.y0 - parts.spandrels.front().box.y1, 4 * 0.11, kRoundOff);
}

TEST(BlocksFile, renumbering_changes_no_measure) {
  const ModelSpec spec = scenes::half_units(kDoor, scenes::paper_joint());
  const auto before = measures(spec, leaning), after = measures(scenes::reversed(spec), leaning);
  ASSERT_EQ(before.size(), after.size());
  double sum = 0;
  for (std::size_t i = 0; i < before.size(); ++i) {
    EXPECT_EQ(before[i].first, after[i].first);
    EXPECT_NEAR(before[i].second, after[i].second, kRoundOff) << before[i].first;
    sum += before[i].second;
  }
  EXPECT_GT(sum, 1);  // there is something to compare
}

TEST(BlocksFile, mirrored_file_gives_mirrored_measures) {
  const ModelSpec spec = scenes::half_units(kDoor, scenes::paper_joint());
  const auto before = measures(spec, leaning);
  const auto after = measures(scenes::mirrored(spec), mirrored(leaning, 0));
  for (const auto& [name, value] : before) {
    const auto colon = name.find(':');
    const std::string mirror = mirror_name(name.substr(0, colon)) + name.substr(colon);
    const auto found =
        std::find_if(after.begin(), after.end(), [&](const auto& m) { return m.first == mirror; });
    ASSERT_NE(found, after.end()) << mirror;
    EXPECT_NEAR(found->second, value, kRoundOff * (1 + value)) << mirror;
  }
}

// --- plain names -----------------------------------------------------------------------------

FailureMode plainly(const Mechanism& mechanism) {
  static const Model model = compile(scenes::plain_wall(10, 24, 2e-3, 0.02));
  return name_from_state(model, moved(model, mechanism));
}

TEST(PlainName, wall_that_turns_about_its_corner_rocks) {
  EXPECT_EQ(plainly([](double, double) { return Motion{.pivot_x = 1.55, .turn = -0.01}; }).name,
            "rocking");
}

TEST(PlainName, wall_that_leaves_its_base_slides_there) {
  EXPECT_EQ(plainly(cut(-1, 6e-3)).name, "sliding at the base");
}

TEST(PlainName, wall_cut_level_slides) { EXPECT_EQ(plainly(cut(1.3, 6e-3)).name, "sliding"); }

TEST(PlainName, wall_parted_along_its_diagonal_shears) {
  const auto diagonal = [](double x, double y) {
    return y > 2.64 * (1 - x / 1.55) ? Motion{.move_x = 6e-3, .move_y = 2e-3} : Motion{};
  };
  EXPECT_EQ(plainly(diagonal).name, "shear");
}

TEST(PlainName, intact_wall_has_none) {
  EXPECT_EQ(plainly([](double, double) { return Motion{}; }).name, "unclear");
}

TEST(PlainName, three_piers_are_named_by_kind_of_damage) {
  const Model model = windows({{3, 0}, {9, 0}}, 15, 8);
  const double column = model.anatomy.length / 15;
  // the first two piers rock about their right corners
  const auto rocking = [=](double x, double) {
    if (x < 3 * column) return Motion{.pivot_x = 3 * column, .turn = -0.02};
    if (x > 6 * column && x < 9 * column) return Motion{.pivot_x = 9 * column, .turn = -0.02};
    return Motion{};
  };
  const FailureMode mode = name_from_state(model, moved(model, rocking));
  EXPECT_NE(mode.name.find("pier rocking"), std::string::npos) << mode.name << mode.sentence;
}

}  // namespace
}  // namespace wythe
