// Frames: profiles against their listed numbers, where segments and sections stand, what is refused.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <string>
#include <vector>

#include "geometry/assembly.h"
#include "geometry/wall/frames.h"
#include "geometry/wall/profiles.h"
#include "io/keys/same_spec.h"
#include "io/results/curve_csv.h"
#include "scenes/scenes.h"
#include "wythe/parts/error.h"
#include "wythe/parts/io.h"
#include "wythe/parts/model.h"
#include "wythe/parts/reading.h"
#include "wythe/parts/solve.h"

namespace wythe::geometry::frames_test {
namespace {

// --- profiles --------------------------------------------------------------------------------------------

// As tables of profiles print them, to three digits or more [cm2, cm4, cm3, kg/m].
struct Listed {
  const char* name;
  double area, second, plastic, mass;
};
constexpr Listed kListed[] = {
    {"IPE 80", 7.64, 80.1, 23.2, 6.0},     {"IPE 100", 10.3, 171, 39.4, 8.1},
    {"IPE 120", 13.2, 318, 60.7, 10.4},    {"IPE 140", 16.4, 541, 88.3, 12.9},
    {"IPE 160", 20.1, 869, 124, 15.8},     {"IPE 180", 23.9, 1317, 166, 18.8},
    {"IPE 200", 28.5, 1943, 221, 22.4},    {"IPE 220", 33.4, 2772, 285, 26.2},
    {"IPE 240", 39.1, 3892, 367, 30.7},    {"IPE 270", 45.9, 5790, 484, 36.1},
    {"IPE 300", 53.8, 8356, 628, 42.2},    {"IPE 330", 62.6, 11770, 804, 49.1},
    {"IPE 360", 72.7, 16270, 1019, 57.1},  {"IPE 400", 84.5, 23130, 1307, 66.3},
    {"IPE 450", 98.8, 33740, 1702, 77.6},  {"IPE 500", 115.5, 48200, 2194, 90.7},
    {"IPE 550", 134, 67120, 2787, 106},    {"IPE 600", 156, 92080, 3512, 122},
    {"HEA 100", 21.2, 349, 83.0, 16.7},    {"HEA 120", 25.3, 606, 119.5, 19.9},
    {"HEA 140", 31.4, 1033, 173, 24.7},    {"HEA 160", 38.8, 1673, 245, 30.4},
    {"HEA 180", 45.3, 2510, 325, 35.5},    {"HEA 200", 53.8, 3692, 429, 42.3},
    {"HEA 220", 64.3, 5410, 568, 50.5},    {"HEA 240", 76.8, 7763, 745, 60.3},
    {"HEA 260", 86.8, 10450, 920, 68.2},   {"HEA 280", 97.3, 13670, 1112, 76.4},
    {"HEA 300", 112.5, 18260, 1383, 88.3}, {"HEA 320", 124.4, 22930, 1628, 97.6},
    {"HEA 340", 133.5, 27690, 1850, 105},  {"HEA 360", 142.8, 33090, 2088, 112},
    {"HEA 400", 159, 45070, 2562, 125},    {"HEA 450", 178, 63720, 3216, 140},
    {"HEA 500", 197.5, 86970, 3949, 155},  {"HEB 100", 26.0, 450, 104, 20.4},
    {"HEB 120", 34.0, 864, 165, 26.7},     {"HEB 140", 43.0, 1509, 245, 33.7},
    {"HEB 160", 54.3, 2492, 354, 42.6},    {"HEB 180", 65.3, 3831, 481, 51.2},
    {"HEB 200", 78.1, 5696, 642.5, 61.3},  {"HEB 220", 91.0, 8091, 827, 71.5},
    {"HEB 240", 106, 11260, 1053, 83.2},   {"HEB 260", 118.4, 14920, 1283, 93.0},
    {"HEB 280", 131.4, 19270, 1534, 103},  {"HEB 300", 149.1, 25170, 1869, 117},
    {"HEB 320", 161.3, 30820, 2149, 127},  {"HEB 340", 170.9, 36660, 2408, 134},
    {"HEB 360", 180.6, 43190, 2683, 142},  {"HEB 400", 197.8, 57680, 3232, 155},
    {"HEB 450", 218, 79890, 3982, 171},    {"HEB 500", 238.6, 107200, 4815, 187},
    {"SHS 100x5", 18.7, 279, 66.4, 14.7},  {"SHS 200x10", 74.9, 4470, 531, 58.8}};

TEST(Profiles, closed_forms_of_the_nominal_sizes_give_the_listed_numbers) {
  for (const Listed& listed : kListed) {
    const auto found = profile_named(listed.name);
    ASSERT_TRUE(found) << listed.name;
    EXPECT_NEAR(1e4 * found->area, listed.area, 4e-3 * listed.area) << listed.name;
    EXPECT_NEAR(1e8 * found->second_moment, listed.second, 2e-3 * listed.second) << listed.name;
    EXPECT_NEAR(1e6 * found->plastic_modulus, listed.plastic, 4e-3 * listed.plastic) << listed.name;
    EXPECT_NEAR(found->mass, listed.mass, 8e-3 * listed.mass) << listed.name;
  }
}

// Of channels the listed numbers are in the table: flanges as thick as in their middle, without fillets and taper,
// come near them. So no number is of another channel.
TEST(Profiles, of_channels_agree_with_their_nominal_sizes) {
  for (const std::string& name : profile_names()) {
    if (!name.starts_with("UPN")) continue;
    const Section s = *profile_named(name);
    const double h = 1e3 * s.height, b = 1e3 * s.width;
    // tw and tf from the shear area and the area
    double tw = 0, tf = 0, least = 1;
    for (double flange = 5; flange < 20; flange += 0.5) {
      const double web = 1e6 * s.shear_area / (h - flange);
      const double off = std::fabs((h * web + 2 * (b - web) * flange) / (1e6 * s.area) - 1);
      if (off < least) least = off, tw = web, tf = flange;
    }
    ASSERT_LT(least, 0.02) << name;
    const double arm = (h - tf) / 2;
    const double second = tw * h * h * h / 12 + 2 * (b - tw) * tf * (arm * arm + tf * tf / 12);
    const double plastic = tw * h * h / 4 + 2 * (b - tw) * tf * arm;
    EXPECT_NEAR(1e12 * s.second_moment, second, 0.03 * second) << name;
    EXPECT_NEAR(1e9 * s.plastic_modulus, plastic, 0.03 * plastic) << name;
  }
}

TEST(Profiles, are_found_under_the_names_that_people_write) {
  for (const char* name : {"HEB 200", "heb200", "HE 200 B", "HE200B"}) {
    ASSERT_TRUE(profile_named(name)) << name;
    EXPECT_NEAR(profile_named(name)->height, 0.2, 1e-12) << name;
  }
  EXPECT_NEAR(profile_named("HE 200 A")->height, 0.19, 1e-12);
  for (const char* name : {"", "HEB", "HEB 205", "IPE", "A"})
    EXPECT_FALSE(profile_named(name)) << name;
}

// --- places ----------------------------------------------------------------------------------------------

// 4 m x 3 m of units 200 x 100 mm, 0.4 m thick, with a door of 2 m x 2.2 m in the middle.
ModelSpec wall() {
  ModelSpec spec;
  spec.wall.length = 4;
  spec.wall.height = 3;
  spec.wall.thickness = 0.4;
  spec.wall.unit.length = 0.2;
  spec.wall.unit.height = 0.1;
  spec.wall.unit.density = 1800;
  for (const char* name : {"joint", "unit", "foundation"})
    spec.material[name] = scenes::paper_joint();
  spec.material["dry"] = scenes::dry_joint(20e9, 8e9, 0.4);
  spec.stage = {scenes::gravity_stage()};
  OpeningSpec door;
  door.name = "shop";
  door.x = 1, door.y = 0, door.width = 2, door.height = 2.2;
  spec.wall.opening = {door};
  FrameSpec frame;
  frame.name = "F1";
  frame.round = "shop";
  frame.feet = FrameFeet::kFixed;
  frame.profile = "HEB 140";
  frame.grade = "S275";
  frame.joint = "dry";
  spec.frame = {frame};
  return spec;
}

std::string refusal(const ModelSpec& spec) {
  try {
    (void)compile(spec);
  } catch (const InputError& error) {
    std::string text;
    for (const Fault& f : error.faults())
      text += f.path + " " + f.value + ": " + f.problem + "; " + f.cure + "\n";
    return text;
  }
  return "";
}

void expect_refused(const std::function<void(ModelSpec&)>& change,
                    const std::vector<std::string>& words) {
  ModelSpec spec = wall();
  change(spec);
  const std::string text = refusal(spec);
  for (const std::string& word : words)
    EXPECT_NE(text.find(word), std::string::npos) << word << " in: " << text;
}

TEST(Frames, round_an_opening_touch_its_jambs_and_head_and_stand_on_the_ground) {
  const Model m = compile(wall());
  double jambs = 0, head = 0;
  for (JointId j = 0; j < m.n_joint; ++j) {
    const JointShape shape = joint_shape(m, j);
    if (shape.kind != JointKind::kFrame) continue;
    EXPECT_NE(shape.a, kGroundBlock);
    EXPECT_NEAR(shape.area, 2 * length(shape.half) * 0.14, 1e-12);  // as wide as the profile
    (std::fabs(shape.normal.x) > 0.5 ? jambs : head) += 2 * length(shape.half);
  }
  EXPECT_NEAR(jambs, 2 * 2.2, 1e-9);
  EXPECT_NEAR(head, 2, 1e-9);
  double mass = 0, inertia = 0;
  for (std::size_t b = 0; b < m.anatomy.block_role.size(); ++b)
    if (m.anatomy.block_role[b] == BlockRole::kFrame)
      mass += m.gravity_mass[b], inertia += m.mass[b];
  EXPECT_NEAR(mass, profile_named("HEB 140")->mass * (2 * (2.2 - 0.07) + 2 - 0.14), 1e-9 * mass);
  EXPECT_GE(inertia, mass);
  // sections: of each member all its length, whatever the quadrature
  std::vector<double> length_of(m.frames.members.size(), 0);
  for (std::size_t k = 0; k < m.frames.a.size(); ++k)
    length_of[m.frames.member[k]] += m.frames.length[k];
  ASSERT_EQ(length_of.size(), 3U);
  for (std::size_t k = 0; k < length_of.size(); ++k)
    EXPECT_NEAR(length_of[k], m.frames.members[k].length, 1e-12);
  EXPECT_EQ(text_of(m.frames.members[2].words), "right column");
}

TEST(Frames, two_side_by_side_have_twice_the_section) {
  ModelSpec spec = wall();
  const Model one = compile(spec);
  spec.frame[0].count = 2;
  const Model two = compile(spec);
  EXPECT_NEAR(two.frames.outer_stiffness[3], 2 * one.frames.outer_stiffness[3], 1e-3);
  EXPECT_NEAR(two.frames.outer_yield[3], 2 * one.frames.outer_yield[3], 1e-6);
  EXPECT_EQ(two.frames.fibre[3], one.frames.fibre[3]);
}

TEST(Frames, wider_than_the_wall_are_told) {
  ModelSpec spec = wall();
  const auto told = [&] {
    const Model model = compile(spec);
    const auto& notes = model.anatomy.notes;
    return std::any_of(notes.begin(), notes.end(),
                       [](const Message& note) { return note.code == "frame.wide"; });
  };
  EXPECT_FALSE(told());
  spec.frame[0].count = 40;
  EXPECT_TRUE(told());
}

// The outer fibres and the middle have A, I, Npl and Mpl of the profile.
TEST(Frames, a_section_has_the_stiffnesses_and_strengths_of_its_profile) {
  const Model m = compile(wall());
  const Section heb = *profile_named("HEB 140");
  const double l = m.frames.length[5], d = m.frames.fibre[5];
  EXPECT_NEAR((2 * m.frames.outer_stiffness[5] + m.frames.middle_stiffness[5]) * l,
              210e9 * heb.area, 1);
  EXPECT_NEAR(2 * m.frames.outer_stiffness[5] * d * d * l, 210e9 * heb.second_moment, 1e-3);
  EXPECT_NEAR(2 * m.frames.outer_yield[5] + m.frames.middle_yield[5], 275e6 * heb.area, 1e-6);
  EXPECT_NEAR(2 * m.frames.outer_yield[5] * d, 275e6 * heb.plastic_modulus, 1e-6);
}

TEST(Frames, a_gap_is_open_at_the_start_and_bends_nothing) {
  ModelSpec spec = wall();
  spec.frame[0].gap = 0.004;
  const Model m = compile(spec);
  const State start = initial_state(m);
  const WallReading read = read_wall(m, start);
  int open = 0;
  for (const JointReading& joint : read.joints) {
    if (joint.shape.kind != JointKind::kFrame) continue;
    EXPECT_NEAR(joint.opening, 0.004, 1e-12);
    EXPECT_EQ(joint.compression, 0);
    ++open;
  }
  EXPECT_GT(open, 30);
  for (const FrameReading& section : read_frames(m, start)) {
    EXPECT_NEAR(section.normal, 0, 1e-6);
    EXPECT_NEAR(section.moment, 0, 1e-6);
  }
}

TEST(Frames, on_a_base_beam_close_and_stand_by_contact) {
  ModelSpec spec = wall();
  spec.frame[0].feet = FrameFeet::kBaseBeam;
  const Model m = compile(spec);
  ASSERT_EQ(m.frames.members.size(), 4U);
  EXPECT_TRUE(std::none_of(m.frames.a.begin(), m.frames.a.end(),
                           [](BlockId a) { return a == kGroundBlock; }));
  double below = 0;
  for (JointId j = 0; j < m.n_joint; ++j) {
    const JointShape shape = joint_shape(m, j);
    if (shape.kind == JointKind::kFrame && shape.a == kGroundBlock) below += 2 * length(shape.half);
  }
  EXPECT_NEAR(below, 2, 1e-9);
}

// --- what a run says -------------------------------------------------------------------------------------

TEST(Frames, say_what_they_bore_and_where_they_yielded) {
  const ModelSpec spec = scenes::framed(scenes::small_wall(0.1e-3, 0.05));
  const Model m = compile(spec);
  State state = initial_state(m);
  const Result r = solve(m, state);
  ASSERT_EQ(r.strengthening.frame_rows.size(), r.curve.size() * m.frames.a.size());
  ASSERT_EQ(r.strengthening.frame_uses.size(), 1U);
  const FrameUse& use = r.strengthening.frame_uses[0];
  EXPECT_GT(use.use, 0.9);
  // no section bears more axial force and moment than it can; in shear it is elastic
  for (std::size_t row = 0; row < r.strengthening.frame_rows.size(); ++row) {
    const auto member = static_cast<std::size_t>(m.frames.member[row % m.frames.a.size()]);
    const FrameRow& now = r.strengthening.frame_rows[row];
    ASSERT_LE(section_use(m.frames.members[member], now.normal, 0, now.moment), 1 + 1e-9);
  }
  EXPECT_LE(use.yields_at, 0.1e-3);
  EXPECT_EQ(text_of(sentence_of(use, "1")).substr(0, 13), "frame 1: use ");
  EXPECT_NE(text_of(sentence_of(use, "1")).find("yields at"), std::string::npos);
  EXPECT_EQ(text_of(sentence_of(FrameUse{}, "2")), "frame 2 carries nothing");
  double stays = 0;
  for (const double flow : state.frame_left) stays = std::max(stays, std::fabs(flow));
  EXPECT_GT(stays, 0);
  // one line a section and row, and the head
  const std::string csv = io::frames_csv(m, r);
  EXPECT_EQ(std::count(csv.begin(), csv.end(), '\n'),
            static_cast<std::ptrdiff_t>(1 + r.strengthening.frame_rows.size()));
}

// --- in a file -------------------------------------------------------------------------------------------

TEST(Frames, are_read_from_a_file_and_written_back) {
  const std::string text = R"(
[wall]
length = "4 m"
height = "3 m"
thickness = "0.4 m"
unit = { length = "200 mm", height = "100 mm", split = "none", density = "1800 kg/m^3" }
[[wall.opening]]
name = "shop"
x = "1 m"
y = "0 m"
width = "2 m"
height = "2.2 m"
[[frame]]
name = "F1"
round = "shop"
feet = "hinged"
profile = "HEB 140"
count = 2
beam_section = { height = "150 mm", width = "80 mm", area = "20 cm^2", shear_area = "9 cm^2", second_moment = "700 cm^4", plastic_modulus = "105 cm^3", mass = "16 kg/m" }
grade = "S275"
joint = "dry"
gap = "3 mm"
[material.joint]
normal_stiffness = "20 GPa/m"
shear_stiffness = "8 GPa/m"
tensile_strength = "0 MPa"
cohesion = "0 MPa"
residual_cohesion = "0 MPa"
friction_angle = "30 deg"
residual_friction_angle = "30 deg"
compressive_strength = "unlimited"
[material.dry]
normal_stiffness = "20 GPa/m"
shear_stiffness = "8 GPa/m"
tensile_strength = "0 MPa"
cohesion = "0 MPa"
residual_cohesion = "0 MPa"
friction_angle = "22 deg"
residual_friction_angle = "22 deg"
compressive_strength = "unlimited"
[[stage]]
name = "gravity"
)";
  const ModelSpec spec = parse_model(text, "shop.toml", {"frame.F1.count=3"});
  ASSERT_EQ(spec.frame.size(), 1U);
  const FrameSpec& frame = spec.frame[0];
  EXPECT_EQ(frame.count, 3);
  EXPECT_EQ(frame.feet, FrameFeet::kHinged);
  EXPECT_NEAR(frame.beam_section.second_moment, 700e-8, 1e-16);
  EXPECT_NEAR(frame.gap, 0.003, 1e-15);
  EXPECT_EQ(io::first_difference(spec, parse_model(write_model(spec), "shop.toml")), "");
  const Model m = compile(spec);
  EXPECT_NEAR(m.frames.members[0].area, 3 * profile_named("HEB 140")->area, 1e-12);
  EXPECT_NEAR(m.frames.members[1].area, 3 * 20e-4, 1e-12);
  EXPECT_EQ(m.frames.outer_stiffness[0], 0);  // hinged
}

// --- what is refused -------------------------------------------------------------------------------------

TEST(Frames, a_profile_of_columns_and_beams_is_refused_once) {
  for (const char* profile : {"HEB 210", ""}) {
    ModelSpec spec = wall();
    spec.frame[0].profile = profile;
    const std::string text = refusal(spec);
    EXPECT_EQ(std::count(text.begin(), text.end(), '\n'), 1) << text;
  }
}

TEST(Frames, links_closer_than_any_frame_has_them_are_refused) {
  const auto anchored = [](double spacing) {
    return [=](ModelSpec& s) {
      s.frame[0].anchors = {
          .spacing = spacing, .depth = 0.1, .tension = 8e3, .shear = 10e3, .slip = 1e-3};
    };
  };
  expect_refused(anchored(1e-12),
                 {"frame.0.anchors.spacing 1e-09 mm", "makes more than 1000 places", "mm or more"});
  expect_refused([](ModelSpec& s) { s.frame[0].wedges = {.force = 1e3, .spacing = 1e-12}; },
                 {"frame.0.wedges.spacing", "makes more than 1000 places"});
}

TEST(Frames, bad_input_is_named_located_and_cured) {
  expect_refused([](ModelSpec& s) { s.frame[0].profile = "HEB 210"; },
                 {"frame.0.profile", "not in the table of profiles", "HEB 2"});
  // rolled, but larger than what the table has: no smaller one is meant
  expect_refused([](ModelSpec& s) { s.frame[0].profile = "HEB 600"; },
                 {"frame.0.profile", "the table has HEB 100 to HEB 500. Or write its numbers"});
  expect_refused([](ModelSpec& s) { s.frame[0].profile = "upn 20"; },
                 {"frame.0.profile", "the table has UPN"});
  expect_refused([](ModelSpec& s) { s.frame[0].profile = ""; },
                 {"frame.0.profile", "missing", "HEB 200"});
  expect_refused([](ModelSpec& s) { s.frame[0].grade = "S236"; },
                 {"frame.0.grade", "no grade of steel", "S235"});
  expect_refused([](ModelSpec& s) { s.frame[0].grade = ""; },
                 {"frame.0.yield_strength", "frame.0.youngs_modulus"});
  expect_refused([](ModelSpec& s) { s.frame[0].round = "shopp"; },
                 {"frame.0.round", "no opening has this name", "shop"});
  expect_refused([](ModelSpec& s) { s.frame[0].gap = -0.001; },
                 {"frame.0.gap", "must not be negative"});
  expect_refused([](ModelSpec& s) { s.frame[0].feet = FrameFeet::kNone; },
                 {"frame.0.feet", "fixed"});
  expect_refused([](ModelSpec& s) { s.frame[0].joint = ""; }, {"frame.0.joint", "missing"});
  expect_refused([](ModelSpec& s) { s.frame[0].joint = "mortarr"; }, {"material.mortarr", "frame"});
  expect_refused([](ModelSpec& s) { s.frame[0].joint = "joint", s.frame[0].gap = 0.002; },
                 {"frame.0.gap", "dry joint"});
  expect_refused([](ModelSpec& s) { s.frame.push_back(s.frame[0]); },
                 {"frame.1.name", "another frame"});
  expect_refused([](ModelSpec& s) { s.solve.contacts = Contacts::kFree; },
                 {"solve.contacts", "frames"});
  expect_refused([](ModelSpec& s) { s.frame[0].turn = 0.1; },
                 {"frame.0.turn", "is for walls in space"});
  // feet of a window's frame
  expect_refused([](ModelSpec& s) { s.wall.opening[0].y = 0.4, s.wall.opening[0].height = 1.8; },
                 {"frame.0.feet", "1.07 m, 0.4 m", "base_beam"});
  // lines
  const auto line = [](std::vector<std::array<double, 2>> points) {
    return [points](ModelSpec& s) {
      s.frame[0].round = "";
      s.frame[0].line = points;
    };
  };
  expect_refused(line({{6, 0}, {6, 2}, {8, 2}, {8, 0}}), {"frame.0.line", "outside the wall"});
  expect_refused(line({{0.5, 0}, {0.5, 2}, {2, 2}, {2, 0}}), {"frame.0", "reaches into", "c00u0"});
  expect_refused(line({{1.5, 0.1}, {1.5, 2}, {2.5, 2}, {2.5, 0}}),
                 {"frame.0.line", "foot in the air", "1.5 m, 0.1 m"});
  expect_refused(line({{1.5, 0}, {1.7, 2}}), {"frame.0.line.0", "neither level nor upright"});
  expect_refused(line({{1.5, 0}}), {"frame.0.line", "fewer than two points"});
  expect_refused(line({{1.5, 0}, {1.5, 1}, {1.5, 2}, {2.5, 2}, {2.5, 0}}),
                 {"frame.0.line.1", "1.5 m, 1 m", "no corner"});
  // a closed line that begins in the middle of a side has a corner too many
  expect_refused(line({{2, 0.1}, {2.5, 0.1}, {2.5, 2}, {1.5, 2}, {1.5, 0.1}, {2, 0.1}}),
                 {"frame.0.line.0", "2 m, 0.1 m", "no corner", "begin and end at a corner"});
  expect_refused(line({{1.5, 0}, {1.5, 0.2}, {2.5, 0.2}}), {"frame.0", "too short to be a bar"});
  expect_refused(
      [](ModelSpec& s) {
        s.frame[0].line = {{1, 0}, {1, 2}};
      },
      {"frame.0.round", "two places"});
  // numbers that no section has
  expect_refused(
      [](ModelSpec& s) {
        s.frame[0].profile = "";
        SectionSpec& n = s.frame[0].section;
        n.height = n.width = 0.2, n.area = 78e-4, n.shear_area = 17e-4, n.mass = 61;
        n.second_moment = 5696e-8, n.plastic_modulus = 642e-7;
      },
      {"frame.0.section.plastic_modulus", "unit that slipped"});
}

}  // namespace
}  // namespace wythe::geometry::frames_test
