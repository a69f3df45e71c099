// The parts of a wall, and the names of walls other than two piers and one opening.
#include "judge/modes/wall_parts.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "judge/modes/element_states.h"
#include "scenes/mechanism.h"
#include "scenes/places.h"
#include "scenes/scenes.h"
#include "wythe/parts/failure_mode.h"
#include "wythe/parts/mechanism.h"

namespace wythe::wall_parts_test {
namespace {

using scenes::Mechanism;
using scenes::mirror_name, scenes::mirrored;
using scenes::Motion;
using scenes::moved;

constexpr double kRoundOff = 1e-9;

const Model& tuff_wall() {
  static const Model model = compile(scenes::tuff_wall(source_dir(), 50e-3));
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

// --- ring beams and steps of the ground ------------------------------------------------------

TEST(WallParts, a_step_of_the_ground_is_no_opening_and_its_pier_stands_on_it) {
  ModelSpec spec = scenes::plain_wall(16, 8, 1e-3, 0.02);
  spec.wall.foundation = {{0, 0}, {10 * 0.155, 0.33}};
  EXPECT_EQ(pier_names(study::find_parts(compile(spec))), std::vector<std::string>{"wall"});
  spec.wall.opening = {
      {.name = "door", .x = 0.93, .y = 0, .width = 0.62, .height = 0.66, .lintel = {}}};
  const study::WallParts parts = study::find_parts(compile(spec));
  ASSERT_EQ(parts.piers.size(), 2U);
  EXPECT_NEAR(parts.piers[0].base, 0, kRoundOff);
  EXPECT_NEAR(parts.piers[1].base, 0.33, kRoundOff);
}

TEST(WallParts, a_ring_beam_is_no_masonry_of_a_spandrel) {
  ModelSpec spec = scenes::small_wall();
  RingBeamSpec ring;
  ring.y = 0.77;
  ring.height = 0.11;
  ring.material = "concrete";
  spec.material["concrete"] = scenes::paper_joint();
  spec.material["concrete"].density = 2500;
  spec.material["concrete"].youngs_modulus = 30e9;
  spec.material["concrete"].shear_modulus = 12e9;
  const double head = spec.wall.opening[0].y + spec.wall.opening[0].height;
  spec.ring_beam = {ring};  // at the top
  const study::WallParts top = study::find_parts(compile(spec));
  ASSERT_EQ(top.spandrels.size(), 2U);
  EXPECT_NEAR(top.spandrels[1].box.y1, 0.77, kRoundOff);
  EXPECT_EQ(top.spandrels[1].lintel, 0);
  EXPECT_NEAR(top.wall.y1, 0.88, kRoundOff);
  spec.ring_beam[0].y = head;  // as a lintel
  const study::WallParts foot = study::find_parts(compile(spec));
  ASSERT_EQ(foot.spandrels.size(), 2U);
  EXPECT_NEAR(foot.spandrels[1].lintel, 0.11, kRoundOff);
  EXPECT_NEAR(foot.spandrels[1].box.y1, 0.88, kRoundOff);
}

// Columns and courses of half units.
struct Hole {
  int column, course, wide = 3, high = 3;
};

ModelSpec facade_spec(const std::vector<Hole>& holes, int columns, int courses) {
  ModelSpec spec = scenes::plain_wall(columns, courses, 2e-3, 0.02);
  const double column = spec.wall.length / columns, course = spec.wall.height / courses;
  for (const Hole& hole : holes) {
    OpeningSpec o;
    o.x = hole.column * column;
    o.y = hole.course * course;
    o.width = hole.wide * column;
    o.height = hole.high * course;
    spec.wall.opening.push_back(o);
  }
  return spec;
}
Model facade(const std::vector<Hole>& holes, int columns, int courses) {
  return compile(facade_spec(holes, columns, courses));
}
Model windows(const std::vector<std::pair<int, int>>& at, int columns, int courses) {
  std::vector<Hole> holes;
  for (const auto& [i, j] : at) holes.push_back({i, j});
  return facade(holes, columns, courses);
}
constexpr double kColumn = 0.155, kCourse = 0.11;  // of these walls [m]

void expect_box(const study::Part& part, double i0, double i1, double j0, double j1) {
  EXPECT_NEAR(part.box.x0, i0 * kColumn, kRoundOff) << part.name;
  EXPECT_NEAR(part.box.x1, i1 * kColumn, kRoundOff) << part.name;
  EXPECT_NEAR(part.box.y0, j0 * kCourse, kRoundOff) << part.name;
  EXPECT_NEAR(part.box.y1, j1 * kCourse, kRoundOff) << part.name;
}

bool share_ground(const study::Box& a, const study::Box& b) {
  return std::min(a.x1, b.x1) - std::max(a.x0, b.x0) > kRoundOff &&
         std::min(a.y1, b.y1) - std::max(a.y0, b.y0) > kRoundOff;
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
  ASSERT_EQ(parts.storeys, 2);
  EXPECT_EQ(pier_names(parts),
            (std::vector<std::string>{"pier 1 of storey 1", "pier 2 of storey 1",
                                      "pier 1 of storey 2", "pier 2 of storey 2"}));
  EXPECT_EQ(parts.piers[3].mark, "P4");
  // the masonry between two storeys is half the one's, half the other's
  EXPECT_NEAR(parts.piers[2].base, 4.5 * kCourse, kRoundOff);
  ASSERT_EQ(parts.spandrels.size(), 2U);  // no sill: the wall between the windows is a spandrel
  EXPECT_EQ(parts.spandrels[1].name, "spandrel 1 of storey 2");
  EXPECT_NEAR(parts.spandrels[0].box.y1, parts.piers[2].box.y0, kRoundOff);
}

// A door between two windows, and above them two windows that stand beside it.
TEST(WallParts, openings_of_two_storeys_need_not_stand_in_line) {
  const std::vector<Hole> holes = {{3, 3}, {12, 0, 3, 6}, {21, 3}, {8, 10}, {16, 10}};
  const study::WallParts parts = study::find_parts(facade(holes, 27, 16));
  ASSERT_EQ(parts.storeys, 2);
  ASSERT_EQ(parts.piers.size(), 7U);
  expect_box(parts.piers[0], 0, 3, 3, 6);
  expect_box(parts.piers[1], 6, 12, 0, 6);  // from the door's foot; clear from the window's sill
  EXPECT_NEAR(parts.piers[1].clear_y0, 3 * kCourse, kRoundOff);
  EXPECT_NEAR(parts.piers[1].clear_y1, 6 * kCourse, kRoundOff);
  expect_box(parts.piers[5], 11, 16, 10, 13);  // above the door
  EXPECT_EQ(parts.piers[5].name, "pier 2 of storey 2");
  const auto door = std::find_if(parts.spandrels.begin(), parts.spandrels.end(),
                                 [](const auto& s) { return s.name == "spandrel 2 of storey 1"; });
  ASSERT_NE(door, parts.spandrels.end());
  expect_box(*door, 12, 15, 6, 10);  // no farther than the next storey's sills
  const auto sills = std::count_if(parts.spandrels.begin(), parts.spandrels.end(),
                                   [](const study::Spandrel& s) { return s.is_sill; });
  EXPECT_EQ(sills, 2);  // below the lower windows alone
}

TEST(WallParts, no_pier_or_spandrel_lies_in_an_opening_or_in_another_wherever_these_stand) {
  const std::vector<std::vector<Hole>> walls = {
      {{3, 3}, {12, 0, 3, 6}, {21, 3}, {8, 10}, {16, 10}},
      {{2, 2}, {9, 2, 3, 5}, {16, 4, 4, 2}, {3, 9}, {12, 8, 3, 4}},  // of different height
      {{2, 1}, {10, 1}, {6, 5, 2, 4}, {2, 9}, {10, 9}},              // a stair's window between
      {{2, 1}, {6, 1, 3, 12}, {12, 1}, {2, 9}, {12, 9}},             // a gate of two storeys
      {{2, 1}, {5, 5}, {8, 9}, {11, 13}},                            // a stair of windows
      {{2, 0, 2, 2}, {2, 4, 2, 2}, {8, 0, 3, 6}}};                   // two beside one
  for (std::size_t w = 0; w < walls.size(); ++w) {
    const Model model = facade(walls[w], 24, 18);
    const study::WallParts parts = study::find_parts(model);
    std::vector<study::Part> all;
    for (const auto& p : parts.piers) all.push_back(p);
    const std::size_t piers = all.size();
    for (const auto& s : parts.spandrels) all.push_back(s);
    EXPECT_GE(piers, 2U) << w;
    for (std::size_t i = 0; i < all.size(); ++i) {
      EXPECT_GT(all[i].box.height(), 0.5 * kCourse) << w << all[i].name;
      for (const study::Box& o : study::find_openings(model))
        EXPECT_FALSE(share_ground(all[i].box, o)) << w << ": " << all[i].name;
      for (std::size_t k = i + 1; k < piers; ++k)
        EXPECT_FALSE(share_ground(all[i].box, all[k].box)) << w << ": " << all[i].name;
    }
    EXPECT_EQ(parts.toes.size(), 2 * piers);
  }
}

TEST(WallParts, stair_window_between_two_rows_makes_no_storey_of_its_own) {
  const Model model = facade({{2, 1}, {10, 1}, {6, 3, 2, 5}, {2, 9}, {10, 9}}, 15, 14);
  EXPECT_EQ(study::find_parts(model).storeys, 2);
}

TEST(WallParts, opening_at_the_wall_s_end_has_a_pier_on_one_side) {
  const study::WallParts parts = study::find_parts(facade({{0, 0, 3, 5}}, 10, 8));
  EXPECT_EQ(parts.openings, 1);
  ASSERT_EQ(parts.piers.size(), 1U);
  expect_box(parts.piers[0], 3, 10, 0, 5);
  ASSERT_EQ(parts.spandrels.size(), 1U);
  EXPECT_EQ(parts.spandrels[0].left, -1);
  EXPECT_EQ(parts.connections.size(), 1U);
  EXPECT_TRUE(study::find_openings(facade({{0, 0, 3, 5}}, 10, 8)).empty());  // none between piers
}

TEST(WallParts, pockets_of_joists_are_no_openings) {
  std::vector<Hole> holes = {{3, 2, 4, 6}, {12, 2, 4, 6}};
  for (int i = 0; i < 6; ++i) holes.push_back({2 + 3 * i, 11, 1, 1});
  const study::WallParts parts = study::find_parts(facade(holes, 20, 14));
  EXPECT_EQ(parts.openings, 2);
  EXPECT_EQ(parts.piers.size(), 3U);
}

TEST(WallParts, below_a_cornice_or_a_leaning_side_there_is_no_opening) {
  std::vector<BlockSpec> blocks;
  for (int c = 0; c < 20; ++c)
    blocks.push_back(scenes::rectangle("b" + std::to_string(c), 0, 0.1 * c, 0.8, 0.1));
  blocks.push_back(scenes::rectangle("cornice", -0.15, 2.0, 1.1, 0.1));
  const ModelSpec spec = scenes::assembly(blocks, scenes::paper_joint(), 0.3, 1800);
  EXPECT_EQ(study::find_parts(compile(spec)).openings, 0);
  std::vector<BlockSpec> leaning;
  for (int c = 0; c < 20; ++c)
    leaning.push_back(scenes::rectangle("b" + std::to_string(c), 0.02 * c, 0.1 * c, 0.8, 0.1));
  const ModelSpec tower = scenes::assembly(leaning, scenes::paper_joint(), 0.3, 1800);
  EXPECT_EQ(study::find_parts(compile(tower)).openings, 0);
}

TEST(WallParts, mirrored_facade_is_numbered_from_the_other_side) {
  const auto parts = study::find_parts(facade({{3, 3}, {12, 0, 3, 6}, {8, 10}}, 27, 16));
  const auto mirror = study::find_parts(facade({{21, 3}, {12, 0, 3, 6}, {16, 10}}, 27, 16));
  ASSERT_EQ(parts.piers.size(), mirror.piers.size());
  ASSERT_EQ(parts.piers.size(), 5U);
  for (std::size_t i = 0; i < 5; ++i) {
    const std::size_t k = i < 3 ? 2 - i : 7 - i;
    EXPECT_NEAR(parts.piers[i].box.x0, parts.wall.x1 - mirror.piers[k].box.x1, kRoundOff);
    EXPECT_NEAR(parts.piers[i].box.y0, mirror.piers[k].box.y0, kRoundOff);
  }
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
  const WallMechanism whole = mechanism_from_state(model, moved(model, rocking));
  EXPECT_EQ(whole.name, "rocking piers");  // two of three
  EXPECT_EQ(text_of(whole.sentence), "the piers rock");
}

TEST(WallParts, crack_in_the_haunch_of_an_arch_is_one_of_its_spandrel) {
  ModelSpec spec = facade_spec({}, 20, 24);
  OpeningSpec o;
  o.x = 6 * kColumn;
  o.y = 0;
  o.width = 8 * kColumn;
  o.height = 8 * kCourse;
  o.arch = {.kind = ArchKind::kRound, .depth = 0.25, .voussoirs = 17};
  spec.wall.opening = {o};
  const Model model = compile(spec);
  const study::WallParts parts = study::find_parts(model);
  ASSERT_EQ(parts.spandrels.size(), 1U);
  const double crown = parts.spandrels.front().box.y0;
  // two voussoirs of the left haunch go left: the radial joint above them parts, below the crown's height
  const auto opens = [&](double x, double y) {
    const bool is_haunch =
        x > 5.2 * kColumn && x < 6.4 * kColumn && y > 8 * kCourse && y < crown - 0.7 * kCourse;
    return Motion{.move_x = is_haunch ? -4e-3 : 0};
  };
  double length = 0;
  for (const ElementState& e : read_elements(model, moved(model, opens)))
    for (const ElementSign& s : e.signs)
      if (e.kind == "spandrel" && s.state == study::kDiagonal) length = s.value;
  EXPECT_GT(length, 0.05);  // of the joint, 0.25 m long, seen from above
}

// --- an arch alone ---------------------------------------------------------------------------

// A half circle of 16 voussoirs, radii 0.9 and 1.1 m, its middle at x = 1.1 m on the ground.
constexpr int kVoussoirs = 16;
constexpr double kMiddle = 1.1, kPi = 3.14159265358979323846;
double angle_of(double k) { return kPi * (1 - k / kVoussoirs); }  // of joint k, from the left
ModelSpec arch_spec(double outer = 1.1) {
  ModelSpec spec = scenes::plain_wall(8, 8, 1e-3, 0.02);
  spec.wall.blocks = "arch.json";
  spec.stage = {scenes::gravity_stage()};
  const auto place = [](double radius, double k) {
    return std::array<double, 2>{kMiddle + radius * std::cos(angle_of(k)),
                                 radius * std::sin(angle_of(k))};
  };
  for (int k = 0; k < kVoussoirs; ++k) {
    BlockSpec& block = spec.block.emplace_back();
    block.id = "v" + std::to_string(k);
    block.polygon = {place(0.9, k + 1), place(outer, k + 1), place(outer, k), place(0.9, k)};
  }
  for (const double x : {0.0, 2.0}) {
    BlockSpec& support = spec.block.emplace_back();
    support.id = x > 0 ? "right" : "left";
    support.fixed = true;
    support.polygon = {{x - 0.6, -0.2}, {x + 0.8, -0.2}, {x + 0.8, 0}, {x - 0.6, 0}};
  }
  return spec;
}
const Model& bare_arch() {
  static const Model model = compile(arch_spec());
  return model;
}

// The motion about hinges at both springings and at two joints between, whose parts stay together: the turns at the hinges
// have no sum, and no moment about any point.
Mechanism four_hinges(double second, double third, double turn) {
  struct Hinge {
    double joint, x, y, turn;
  };
  const auto at = [](double joint) {
    return Hinge{joint, kMiddle + std::cos(angle_of(joint)), std::sin(angle_of(joint)), 0};
  };
  std::array<Hinge, 4> hinge = {at(0), at(second), at(third), at(kVoussoirs)};
  auto& [a, b, c, d] = hinge;
  a.turn = turn;
  b.turn = -turn * (a.x - d.x) / ((b.x - d.x) - b.y / c.y * (c.x - d.x));
  c.turn = -b.turn * b.y / c.y;
  d.turn = -(a.turn + b.turn + c.turn);
  return [=](double x, double y) {
    const double joint = kVoussoirs * (1 - std::atan2(y, x - kMiddle) / kPi);
    Motion motion;
    for (const Hinge& h : hinge) {
      if (joint < h.joint) break;
      const double arm_x = h.x - motion.pivot_x, arm_y = h.y - motion.pivot_y;
      motion.move_x -= motion.turn * arm_y, motion.move_y += motion.turn * arm_x;
      motion.pivot_x = h.x, motion.pivot_y = h.y;
      motion.turn += h.turn;
    }
    return motion;
  };
}

TEST(Arch, alone_is_one_part_and_no_portal) {
  const study::WallParts parts = study::find_parts(bare_arch());
  EXPECT_TRUE(parts.is_arch);
  EXPECT_EQ(pier_names(parts), std::vector<std::string>{"wall"});
  EXPECT_TRUE(parts.spandrels.empty());
  EXPECT_FALSE(study::find_parts(tuff_wall()).is_arch);
  // masonry up to the corner over a haunch, or deep over the crown: an arch in a wall
  ModelSpec filled = arch_spec();
  filled.block[3].polygon.insert(filled.block[3].polygon.begin() + 2, {0, 1.1});
  EXPECT_FALSE(study::find_parts(compile(filled)).is_arch);
  EXPECT_TRUE(study::find_parts(compile(arch_spec(1.4))).is_arch);
  EXPECT_FALSE(study::find_parts(compile(arch_spec(1.6))).is_arch);
}

TEST(Arch, alone_that_turns_about_four_hinges_is_named_by_them) {
  const FailureMode mode =
      name_from_state(bare_arch(), moved(bare_arch(), four_hinges(5, 11, 0.03)));
  EXPECT_EQ(mode.name, "arch hinges") << text_of(mode.sentence);
  EXPECT_EQ(mode.sentence.code, "mode.arch_hinges");
  EXPECT_EQ(mode.sentence.number("hinges"), 4);
  EXPECT_TRUE(is_firm(mode));
  const WallMechanism whole =
      mechanism_from_state(bare_arch(), moved(bare_arch(), four_hinges(5, 11, 0.03)));
  EXPECT_EQ(whole.name, "arch hinges");
}

TEST(Arch, alone_with_fewer_hinges_gets_no_name_of_a_wall) {
  const FailureMode mode =
      name_from_state(bare_arch(), moved(bare_arch(), [](double x, double) {
                        return Motion{.pivot_y = 1, .turn = x < kMiddle ? 2e-3 : 0};
                      }));
  EXPECT_EQ(mode.name.find("FM-"), std::string::npos) << mode.name;
  EXPECT_EQ(mode.name.find("pier"), std::string::npos) << mode.name;
  EXPECT_NE(mode.name, "arch hinges");
}

// --- mechanism -------------------------------------------------------------------------------

// Two storeys of three piers: 27 x 16 half units, windows of 3 x 3.
const Model& two_storeys() {
  static const Model model = facade({{6, 2}, {18, 2}, {6, 10}, {18, 10}}, 27, 16);
  return model;
}
struct Strip {
  double x0, x1;
};
// The pier a place lies in line with; the masonry over openings goes with the pier on its left.
Strip strip_at(double x) {
  const double c = x / kColumn;
  if (c < 9) return {0, 6 * kColumn};
  if (c < 21) return {9 * kColumn, 18 * kColumn};
  return {21 * kColumn, 27 * kColumn};
}
Mechanism mechanism_of_storey(double foot, double head, bool shears) {
  return [=](double x, double y) {
    const double slip = 8e-3;
    if (y < foot * kCourse) return Motion{};
    if (y > head * kCourse) return Motion{.move_x = slip, .move_y = shears ? 0 : 2e-3};
    const Strip pier = strip_at(x);
    const double share = (x - pier.x0) / (pier.x1 - pier.x0);
    const double height = (y - foot * kCourse) / ((head - foot) * kCourse);
    if (shears) return height > 1 - share ? Motion{.move_x = slip} : Motion{};
    return Motion{
        .pivot_x = pier.x1, .pivot_y = foot * kCourse, .turn = -slip / ((head - foot) * kCourse)};
  };
}
WallMechanism of_two_storeys(const Mechanism& mechanism) {
  return mechanism_from_state(two_storeys(), moved(two_storeys(), mechanism));
}

TEST(Mechanism, piers_of_one_storey_in_shear_under_a_wall_that_follows_are_a_soft_storey) {
  for (const bool mirror : {false, true}) {
    Mechanism first = mechanism_of_storey(2, 5, true), second = mechanism_of_storey(10, 13, true);
    if (mirror) first = mirrored(first, 27 * kColumn), second = mirrored(second, 27 * kColumn);
    EXPECT_EQ(text_of(of_two_storeys(first).sentence), "soft storey 1: the piers fail in shear");
    const auto above = of_two_storeys(second);
    EXPECT_EQ(above.name, "piers in shear");
    EXPECT_EQ(above.storeys, std::vector<int>{2});
    EXPECT_EQ(text_of(above.sentence, "it"), "piano soffice 2: i maschi collassano a taglio");
  }
}

TEST(Mechanism, rocking_piers_of_one_storey_are_named_with_it) {
  for (const bool mirror : {false, true}) {
    Mechanism rocks = mechanism_of_storey(2, 5, false);
    if (mirror) rocks = mirrored(rocks, 27 * kColumn);
    const auto found = of_two_storeys(rocks);
    EXPECT_EQ(found.name, "rocking piers");
    EXPECT_EQ(found.storeys, std::vector<int>{1});
  }
}

TEST(Mechanism, both_storeys_in_shear_are_no_soft_one) {
  const auto both = [](double x, double y) {
    const Motion low = mechanism_of_storey(2, 5, true)(x, y);
    Motion high = mechanism_of_storey(10, 13, true)(x, y);
    high.move_x += low.move_x;
    return y > 9 * kCourse ? high : low;
  };
  const auto found = of_two_storeys(both);
  EXPECT_EQ(found.storeys, (std::vector<int>{1, 2}));
  EXPECT_EQ(text_of(found.sentence), "the piers fail in shear (storey 1, 2)");
}

TEST(Mechanism, one_pier_of_three_that_fails_is_a_part_of_the_wall_alone) {
  const auto all = mechanism_of_storey(2, 5, true);
  const auto one = [=](double x, double y) {
    return x < 6 * kColumn && y < 5 * kCourse ? all(x, y) : Motion{};
  };
  const auto found = of_two_storeys(one);
  EXPECT_EQ(found.name, "partial");
  EXPECT_EQ(text_of(found.sentence), "only a part of the wall fails: pier 1 of storey 1");
}

TEST(Mechanism, nothing_has_happened_to_a_wall_at_rest) {
  const auto found = of_two_storeys([](double, double) { return Motion{}; });
  EXPECT_EQ(found.name, "none");
  EXPECT_EQ(text_of(found.sentence), "no mechanism: no part shows damage");
}

TEST(Mechanism, corner_that_leaves_with_a_pier_breaks_away) {
  // above a stepped crack from the foot of the last pier of storey 2 to the end of the wall
  const auto corner = [](double x, double y) {
    const double c = x / kColumn, r = y / kCourse;
    return c + r > 21 + 10 && c > 21 ? Motion{.move_x = 6e-3, .move_y = -2e-3} : Motion{};
  };
  for (const bool mirror : {false, true}) {
    const auto found = of_two_storeys(mirror ? mirrored(corner, 27 * kColumn) : Mechanism(corner));
    EXPECT_EQ(found.name, "partial");
    const std::string said = text_of(found.sentence);
    const std::string with = mirror ? "pier 1" : "pier 3";
    EXPECT_NE(said.find("breaks away"), std::string::npos) << said;
    EXPECT_NE(said.find(with + " of storey 2, 6.3 mm"), std::string::npos) << said;
  }
  EXPECT_EQ(name_from_state(two_storeys(), moved(two_storeys(), corner)).name,
            "part breaking away");
}

TEST(Mechanism, stones_that_come_loose_are_no_part_that_breaks_away) {
  const auto loose = [=](double x, double y) {  // five of 396
    return x < 5 * kColumn && y > 15 * kCourse ? Motion{.move_x = -6e-3} : Motion{};
  };
  EXPECT_EQ(of_two_storeys(loose).name, "none");
}

TEST(Mechanism, corner_that_hangs_on_at_a_hinge_breaks_away_and_masonry_that_bends_does_not) {
  const auto broken = [](const Mechanism& mechanism) {
    for (const ElementState& e : read_elements(two_storeys(), moved(two_storeys(), mechanism)))
      for (const ElementSign& s : e.signs)
        if (s.state == study::kBreaking) return s.value;
    return 0.0;
  };
  // the end of the wall, from its foot up, turns about the last corner at its foot
  const auto hinge = [](double x, double) {
    return x > 23 * kColumn ? Motion{.pivot_x = 27 * kColumn, .turn = -4e-3} : Motion{};
  };
  const double gone = 1 - 3.3e-3 / (4e-3 * 16 * kCourse);  // of its height: by the way that counts
  EXPECT_NEAR(broken(hinge), 64.0 / 396 * gone, 0.01);     // 64 of the wall's 396 blocks
  // the same end leans out with no crack: each column a little more than the one before
  const auto bends = [](double x, double y) {
    const double c = x / kColumn;
    return c > 15 ? Motion{.move_x = 2e-3 * (c - 15) * y / (16 * kCourse)} : Motion{};
  };
  EXPECT_EQ(broken(bends), 0);
}

TEST(Mechanism, wall_that_goes_or_turns_in_one_piece_has_lost_none) {
  const auto turns = [](double, double) { return Motion{.turn = -0.02}; };
  EXPECT_EQ(text_of(of_two_storeys(turns).sentence).find("breaks away"), std::string::npos);
  for (double way = 0.2e-3; way < 8e-3; way *= 1.3) {  // through the threshold of sliding
    const auto slides = [=](double, double) { return Motion{.move_x = way}; };
    const std::string said = text_of(of_two_storeys(slides).sentence);
    EXPECT_EQ(said.find("breaks away"), std::string::npos) << 1e3 * way << " mm: " << said;
  }
}

TEST(Mechanism, force_that_fell_without_a_failed_pier_or_spandrel_is_not_explained_away) {
  // masonry above a pier moves off in one piece: no pier, no spandrel
  const auto node = [](double x, double y) {
    const double c = x / kColumn, r = y / kCourse;
    return c < 2 && r > 14 ? Motion{.move_x = -6e-3, .move_y = 3e-3} : Motion{};
  };
  const auto at_a_loss_of = [&](double lost) {
    Result result;
    result.states.readings.push_back({"", 40e-3, 0, moved(two_storeys(), node)});
    for (const double at : {10e-3, 40e-3}) {
      CurveRow row;
      row.displacement = at;
      row.reaction = at < 20e-3 ? 1e5 : 1e5 * (1 - lost);
      result.curve.push_back(row);
    }
    return read_mechanism(two_storeys(), result);
  };
  EXPECT_EQ(at_a_loss_of(0.1).name, "none");
  const WallMechanism found = at_a_loss_of(0.4);
  EXPECT_EQ(found.name, "unclear");
  EXPECT_EQ(found.candidates, std::vector<std::string>{"none"});
  const std::string said = text_of(found.sentence);
  EXPECT_NE(said.find("lost 40 % of its peak"), std::string::npos) << said;
  EXPECT_NE(said.find("6.7 mm, is in node 1 of storey 2"), std::string::npos) << said;
}

TEST(Mechanism, wall_that_leaves_its_base_slides_there) {
  const auto found = of_two_storeys(cut(-1, 6e-3));
  EXPECT_EQ(found.name, "base sliding");
  EXPECT_TRUE(found.storeys.empty());
}

TEST(Mechanism, spandrels_that_shear_over_piers_that_stay_are_weak) {
  // the masonry over each opening falls apart in layers
  const auto falls = [](double x, double y) {
    const double c = x / kColumn, r = y / kCourse;
    const bool over = (c > 6 && c < 9) || (c > 18 && c < 21);
    if (!over || r < 5 || (r > 10 && r < 13)) return Motion{};
    return Motion{.move_x = r < 10 ? 4e-3 * std::floor(r - 5) : 4e-3 * std::floor(r - 13)};
  };
  const auto found = of_two_storeys(falls);
  EXPECT_EQ(found.name, "weak spandrels");
}

TEST(Mechanism, share_of_piers_half_way_between_two_leaves_both_as_candidates) {
  // of three piers, two of them in shear, one as wide as these rocks: shear, or both
  const auto shear = mechanism_of_storey(2, 5, true), rock = mechanism_of_storey(2, 5, false);
  const auto mixed = [=](double x, double y) {
    const double c = x / kColumn;
    return c < 9 ? shear(x, y) : c < 20 ? rock(x, y) : shear(x, y);
  };
  const auto found = of_two_storeys(mixed);
  double sum = 0;
  for (const auto& [name, score] : found.scores) sum += score;
  EXPECT_NEAR(sum, 1, kRoundOff);
  EXPECT_EQ(found.name, "piers in shear and rocking") << found.sentence;
}

}  // namespace
}  // namespace wythe::wall_parts_test
