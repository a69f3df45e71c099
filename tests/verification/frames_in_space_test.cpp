// Frames in space against closed forms: in their plane as in the plane's frames_test.cpp, in a plane that is turned, and
// across it (docs/theory/frames.md, "In space").
#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <string>
#include <vector>

#include "geometry/wall/profiles.h"
#include "scenes/scenes.h"
#include "scenes/zones.h"
#include "verification/record.h"
#include "wythe/parts/error.h"
#include "wythe/parts/reading.h"
#include "wythe/parts/solve.h"

namespace wythe::verification::frames_in_space_test {
namespace {

constexpr double kSpan = 4, kHeight = 3;  // of the axis [m]
constexpr double kE = 210e9, kG = 81e9, kYield = 235e6;
constexpr double kTurn = 0.5;  // of the frame's plane [rad]

// A block in the middle, and no weight: frames are pushed alone.
ModelSpec yard() {
  ModelSpec spec = scenes::in_space({scenes::box("ground", {-3, -0.1, -1}, {7, 0.1, 2}, true),
                                     scenes::box("b0", {0, 0, -0.15}, {1, 0.5, 0.3})},
                                    scenes::dry_joint(60e9, 30e9, 0.5), 2000);
  spec = scenes::turned_about_y(spec, kTurn);
  spec.material["contact"] = scenes::dry_joint(60e9, 30e9, 0.5);
  spec.solve.gravity = 0;
  spec.solve.raise_light_inertia = false;  // the block would lend its own slowness
  spec.solve.collapse_displacement = 10;
  return spec;
}

FrameSpec portal(FrameFeet feet) {
  FrameSpec frame;
  frame.name = "F1";
  const double left = 0.5 - kSpan / 2, right = 0.5 + kSpan / 2;
  frame.line = {{left, 0}, {left, kHeight}, {right, kHeight}, {right, 0}};
  frame.feet = feet;
  frame.profile = "HEB 200";
  frame.grade = "S235";
  frame.joint = "contact";
  frame.x = frame.y = frame.z = 0;
  frame.turn = kTurn;
  return frame;
}

const std::vector<double> kAlong = {std::cos(kTurn), 0, -std::sin(kTurn)};
const std::vector<double> kAcross = {std::sin(kTurn), 0, std::cos(kTurn)};

StageSpec push(const std::string& block, const std::vector<double>& along, double until,
               double velocity) {
  StageSpec stage = scenes::push_stage(block, Direction::kPlusX, velocity, until);
  stage.get<PushStage>().drive.along = along;
  return stage;
}

struct Ran {
  Model model;
  State state;
  Result result;
};
Ran solved(const ModelSpec& spec) {
  Ran r{compile(spec), {}, {}};
  r.state = initial_state(r.model);
  r.result = solve(r.model, r.state);
  EXPECT_EQ(r.result.status, SolveStatus::kCompleted) << text_of(r.result.reason);
  return r;
}

double stiffness(const FrameSpec& frame, const std::string& block,
                 const std::vector<double>& along) {
  ModelSpec spec = yard();
  spec.frame = {frame};
  spec.stage = {scenes::gravity_stage(), push(block, along, 1e-3, 5e-4)};
  const CurveRow last = solved(spec).result.curve.back();
  return last.base_shear / last.displacement;
}

// As slender as the textbook's: neither shear nor axial force lengthens anything.
FrameSpec slender(FrameFeet feet) {
  const geometry::Section heb = *geometry::profile_named("HEB 200");
  FrameSpec frame = portal(feet);
  frame.profile = "";
  frame.section = {.height = heb.height,
                   .width = heb.width,
                   .area = 40 * heb.area,
                   .shear_area = 40 * heb.shear_area,
                   .second_moment = heb.second_moment,
                   .plastic_modulus = heb.plastic_modulus,
                   .mass = heb.mass,
                   .weak_second_moment = heb.weak_second_moment,
                   .torsion_constant = heb.torsion_constant};
  return frame;
}

TEST(FramesInSpace, a_portal_has_the_stiffness_of_the_textbook) {
  const double bending = kE * slender(FrameFeet::kFixed).section.second_moment;
  const double beta = kHeight / kSpan;
  verify({"SF01", "portal in a turned plane, fixed feet: lateral stiffness", "N/m",
          24 * bending / std::pow(kHeight, 3) * (6 * beta + 1) / (6 * beta + 4), 1e-2,
          "quadrature is exact; axial and shear flexibility of the section left, 0.5 %"},
         stiffness(slender(FrameFeet::kFixed), "frame0_0", kAlong));
  verify({"SF02", "portal in a turned plane, hinged feet: lateral stiffness", "N/m",
          12 * bending / std::pow(kHeight, 3) / (2 + 1 / beta), 1e-2, "as with fixed feet"},
         stiffness(slender(FrameFeet::kHinged), "frame0_0", kAlong));
}

double plastic_moment() { return kYield * geometry::profile_named("HEB 200")->plastic_modulus; }

TEST(FramesInSpace, sway_of_a_portal_takes_its_plastic_moments_over_its_height) {
  for (const FrameFeet feet : {FrameFeet::kFixed, FrameFeet::kHinged}) {
    ModelSpec spec = yard();
    spec.frame = {portal(feet)};
    spec.stage = {scenes::gravity_stage(), push("frame0_0", kAlong, 0.15, 0.05)};
    const Ran r = solved(spec);
    const double hinges = feet == FrameFeet::kFixed ? 4 : 2;
    verify({"SF03", "sway of a portal in a turned plane: collapse load", "N",
            hinges * plastic_moment() / kHeight, 1e-2,
            "hinges at the ends of the columns; geometry of 150 mm, 0.3 %"},
           r.result.curve.back().base_shear);
    EXPECT_LT(r.result.energy.gap_ratio, 1e-3);
  }
}

// A load on the last segment of 8, half a segment from the end; the quadrature is exact for it.
TEST(FramesInSpace, a_post_bends_across_its_plane_about_its_weak_axis) {
  FrameSpec post = portal(FrameFeet::kFixed);
  post.line = {{-0.5, 0}, {-0.5, kHeight}};
  const geometry::Section heb = *geometry::profile_named("HEB 200");
  const double arm = kHeight * 15 / 16;
  verify({"SF04", "post pushed across its frame's plane: stiffness", "N/m",
          1 / (std::pow(arm, 3) / (3 * kE * heb.weak_second_moment) +
               arm / (kG * heb.weak_shear_area)),
          1e-2, "quadrature is exact; the push at 0.5 mm/s swings by less"},
         stiffness(post, "frame0_7", kAcross));
}

//      4 ---------- x    the load acts across the plane: the post twists and bends, the arm bends
//      |
TEST(FramesInSpace, a_post_with_an_arm_twists) {
  constexpr double kArm = 2;
  FrameSpec crane = portal(FrameFeet::kFixed);
  crane.profile = "SHS 200x10";
  crane.line = {{-0.5, 0}, {-0.5, kHeight}, {-0.5 + kArm, kHeight}};
  const geometry::Section tube = *geometry::profile_named("SHS 200x10");
  const double arm = kArm * 15 / 16, ei = kE * tube.weak_second_moment;
  const double gives = (std::pow(arm, 3) + std::pow(kHeight, 3)) / (3 * ei) +
                       arm * arm * kHeight / (kG * tube.torsion_constant) +
                       (arm + kHeight) / (kG * tube.weak_shear_area);
  // segment 0 is the corner, 1 to 8 the post, 9 to 16 the arm
  verify({"SF05", "post with an arm, pushed across their plane: stiffness", "N/m", 1 / gives, 1e-2,
          "quadrature is exact; the push at 0.5 mm/s swings by less"},
         stiffness(crane, "frame0_16", kAcross));
}

// Every segment in a motion of its own, and nothing that damps it.
TEST(FramesInSpace, energy_balances_while_a_frame_swings_freely) {
  ModelSpec spec = yard();
  spec.frame = {portal(FrameFeet::kFixed)};
  spec.frame[0].yield_strength = 1e12;
  spec.solve.step_fraction = 0.1;
  StageSpec swing{
      .name = "swing", .damping = 0, .action = HoldStage{.duration = 0.05, .release = true}};
  spec.stage = {swing};
  Ran r{compile(spec), {}, {}};
  r.state = initial_state(r.model);
  for (std::size_t i = 0; i < r.state.vx.size(); ++i) {
    if (r.model.anatomy.block_role[i] != BlockRole::kFrame) continue;
    const double phase = static_cast<double>(i);
    r.state.vx[i] = std::sin(phase), r.state.vy[i] = std::sin(2 * phase);
    r.state.vz[i] = std::sin(3 * phase);
  }
  const double before = 0.5 * [&] {
    double sum = 0;
    for (std::size_t i = 0; i < r.state.vx.size(); ++i)
      sum += r.model.mass[i] * (r.state.vx[i] * r.state.vx[i] + r.state.vy[i] * r.state.vy[i] +
                                r.state.vz[i] * r.state.vz[i]);
    return sum;
  }();
  r.result = solve(r.model, r.state);
  const EnergyLedger& e = r.result.energy;
  verify({"SF06", "frame swinging freely in space: energy", "J", before, 2e-2,
          "kinetic and elastic energy are of moments half a step apart"},
         e.kinetic + e.elastic);
  EXPECT_GT(e.elastic, 0.02 * before);
}

// --- anchors and wedges ------------------------------------------------------------------------------------

constexpr double kTension = 5e3, kShear = 3e3;  // of one anchor, at a slip of 1 mm [N]

// As in the plane (anchors_test.cpp): a block beside a stiff column, two anchors at its height.
Ran pulled(const std::vector<double>& along, double until) {
  ModelSpec spec = yard();
  spec.material["contact"] = scenes::dry_joint(60e9, 30e9, 1e-6);
  FrameSpec column = portal(FrameFeet::kFixed);
  column.line = {{1.1, 0}, {1.1, 1}};
  column.anchors = {
      .spacing = 0.25, .depth = 0.1, .tension = kTension, .shear = kShear, .slip = 1e-3};
  spec.frame = {column};
  StageSpec stage = push("b0", along, until, 0.01);
  stage.get<PushStage>().fixity.rotation = Freedom::kBlocked;
  spec.stage = {scenes::gravity_stage(), stage};
  return solved(spec);
}

TEST(FramesInSpace, anchors_are_pulled_out_and_sheared_off_at_their_strengths) {
  const Ran out = pulled({-kAlong[0], 0, -kAlong[2]}, 3e-3);
  ASSERT_EQ(out.model.links.n, 6);
  verify({"SF09", "two anchors of a column in space, block pulled off: force", "N", 2 * kTension,
          2e-3, "the damped motion of the block"},
         std::fabs(out.result.curve.back().base_shear));
  EXPECT_LT(out.result.energy.gap_ratio, 1e-3);
  const Ran off = pulled(kAcross, 4e-3);
  const std::vector<LinkReading> links = read_links(off.model, off.state);
  double across = 0;
  for (std::size_t k = 0; k < links.size(); ++k)
    if (off.model.links.name[k].ends_with("aside")) across += std::fabs(links[k].force);
  verify({"SF10", "the same, block pushed across the frame's plane: force across them", "N",
          2 * kShear, 1e-6, "their law"},
         across);
}

// --- with masonry ------------------------------------------------------------------------------------------

// The window of small_wall, cut under load, with a frame in it that bends and yields.
ModelSpec plane_wall() {
  ModelSpec spec = scenes::small_wall(1e-3, 5e-3, 0);
  spec.wall.opening[0].name = "window";
  spec.stage[1].get<LoadStage>().pier_load = kUnset;
  spec.stage[1].get<LoadStage>().pressure = 50e3;
  spec.stage.back().get<PushStage>().at.x = 0.05;
  spec.material["joint"] = scenes::elastic_joint(20e9, 8e9);
  spec.material["unit"] = scenes::elastic_joint(40e9, 16e9);
  spec = scenes::framed(spec);
  spec.frame[0].yield_strength = 500e6;
  return spec;
}
using scenes::along_a_line;

double largest_moment(const Ran& r) {
  double most = 0;
  for (const FrameReading& section : read_frames(r.model, r.state))
    most = std::max(most, std::fabs(section.moment));
  return most;
}

TEST(FramesInSpace, a_wall_with_a_frame_bears_as_in_its_plane) {
  for (const bool is_cut : {false, true}) {
    const ModelSpec plane = is_cut ? scenes::cut_under_load(plane_wall()) : plane_wall();
    const Ran flat = solved(plane), r = solved(along_a_line(plane));
    EXPECT_EQ(r.model.frames.n, flat.model.frames.n);
    verify({"SF07", "wall with a frame, pushed in space and in its plane: force", "N",
            flat.result.curve.back().base_shear, 0.01,
            "the frame is as wide in both; points of faces across the thickness"},
           r.result.curve.back().base_shear);
    verify({"SF08", "the same: largest moment in the frame", "N m", largest_moment(flat), 0.02,
            "as before"},
           largest_moment(r));
    EXPECT_LT(r.result.energy.gap_ratio, 1e-3);
  }
}

TEST(FramesInSpace, threads_give_the_same_bits) {
  const ModelSpec spec = along_a_line(scenes::cut_under_load(plane_wall()));
  std::string hash;
  for (const int threads : {1, 2}) {
    Ran r{compile(spec), {}, {}};
    r.state = initial_state(r.model);
    SolveOptions options;
    options.threads = threads;
    options.step_budget = 20000;
    r.result = solve(r.model, r.state, options);
    if (hash.empty()) hash = r.result.state_hash;
    EXPECT_EQ(r.result.state_hash, hash);
  }
}

// They press with their force when the stage has ended, and the frame holds it against the wall above.
TEST(FramesInSpace, wedges_press_with_their_force) {
  constexpr double kWedged = 8e3;
  ModelSpec spec = scenes::cut_under_load(plane_wall());
  spec.frame[0].wedges = {.force = kWedged, .spacing = 0.1};
  spec.frame[0].section.area *= 4;
  spec.stage.pop_back();
  const Ran r = solved(along_a_line(spec));
  double force = 0;
  const std::vector<LinkReading> links = read_links(r.model, r.state);
  for (std::size_t k = 0; k < links.size(); ++k)
    if (r.model.links.kind[k] == LinkKind::kWedge) force -= links[k].force;
  verify({"SF11", "wedges above a beam in space, driven in by the stage that cuts: force", "N",
          kWedged, 1e-6, "their law"},
         force);
  EXPECT_LT(r.result.energy.gap_ratio, 1e-3);
}

// A middle post, whose line ends on the edges of the hole that it stands in.
TEST(FramesInSpace, a_post_across_the_opening_comes_with_the_cut) {
  ModelSpec plane = scenes::cut_under_load(plane_wall());
  plane.frame[0].round = "";
  plane.frame[0].feet = FrameFeet::kResting;
  plane.frame[0].line = {{4 * 0.155, 3 * 0.11}, {4 * 0.155, 5 * 0.11}};
  EXPECT_EQ(along_a_line(plane).frame[0].stage, "cut");
  plane.frame[0].line = {{6 * 0.155, 3 * 0.11}, {6 * 0.155, 5 * 0.11}};  // in a pier
  EXPECT_EQ(along_a_line(plane).frame[0].stage, "");
}

// As one `round` the opening: where it stands is said in numbers.
TEST(FramesInSpace, a_frame_in_its_own_hole_comes_with_the_cut) {
  ModelSpec plane = scenes::cut_under_load(plane_wall());
  const OpeningSpec window = plane.wall.opening[0];
  plane.frame[0].round = "";
  plane.frame[0].hole = {window.x, window.y, window.width, window.height};
  EXPECT_EQ(along_a_line(plane).frame[0].stage, "cut");
  plane.frame[0].hole.x += window.width;  // beside it
  EXPECT_EQ(along_a_line(plane).frame[0].stage, "");
}

TEST(FramesInSpace, touch_a_deformable_block_with_their_own_joint) {
  ModelSpec spec = yard();
  FrameSpec column = portal(FrameFeet::kFixed);
  column.line = {{1.1, 0}, {1.1, 1}};
  column.joint = "steel";
  spec.frame = {column};
  spec.material["steel"] = scenes::dry_joint(50e9, 20e9, 0.3);
  spec.material["stuff"] = scenes::elastic_body(10e9, 0.2, 2000);
  spec.body[1].material = "stuff";
  spec.body[1].zone.zones = 2, spec.body[1].zone.length = 0.25;
  const Model model = compile(spec);
  const SpaceSolids& solids = model.space.solids;
  int of_frame = 0;
  for (std::size_t c = 0; c < solids.contact_block.size(); ++c) {
    const bool is_ground = solids.contact_block[c] >= model.n_block;
    const auto material = static_cast<std::size_t>(solids.contact_material[c]);
    EXPECT_EQ(model.material_names[material], is_ground ? "joint" : "steel");
    of_frame += is_ground ? 0 : 1;
  }
  EXPECT_GT(of_frame, 0);
}

template <class Build>
std::string fault_when(const Build& build) {
  try {
    (void)build();
  } catch (const InputError& error) {
    return error.faults().front().path + ": " + error.faults().front().problem;
  }
  return "none";
}
std::string fault_of(const ModelSpec& spec) {
  return fault_when([&] { return compile(spec); });
}

TEST(FramesInSpace, what_cannot_be_is_refused_with_its_place) {
  ModelSpec spec = yard();
  spec.frame = {portal(FrameFeet::kFixed)};
  spec.frame[0].x = kUnset;
  EXPECT_EQ(fault_of(spec), "frame.0.wall: is missing: a frame in space stands in a wall");
  spec.frame[0] = portal(FrameFeet::kFixed);
  spec.frame[0].wedges = {.force = 1e3, .spacing = 0.4};
  EXPECT_EQ(fault_of(spec),
            "frame.0.wedges: are driven in while a stage puts the frame up, and this one stands "
            "from the start");
  spec.frame[0] = portal(FrameFeet::kFixed);
  spec.stage = {scenes::gravity_stage(), push("ground", kAlong, 1e-3, 5e-4)};
  EXPECT_EQ(fault_of(spec),
            "stage.1.at: drives supports, and the feet of frame F1 stand still in the ground");
  spec.stage.clear();
  spec.frame[0].z = 50;
  EXPECT_EQ(fault_of(spec), "frame.0.x: stands in a plane that cuts no block that moves");
  spec.body.push_back(scenes::box("far", {0, 0, 49.9}, {1, 0.5, 0.3}));
  spec.frame[0].turn = 0;
  EXPECT_EQ(
      fault_of(spec),
      "frame.0.feet: frame F1: has no ground to hold its feet: its plane cuts no fixed block");
}

// Beams that have no section of their own have the columns', and no key of their own that could be mended.
TEST(FramesInSpace, a_section_in_numbers_that_lacks_one_across_is_told_once) {
  ModelSpec spec = yard();
  spec.frame = {slender(FrameFeet::kFixed)};
  const auto told = [&] {
    std::vector<std::string> all;
    try {
      (void)compile(spec);
    } catch (const InputError& error) {
      for (const Fault& fault : error.faults()) all.push_back(fault.path + ": " + fault.problem);
    }
    return all;
  };
  const std::string twists = ".torsion_constant: is missing: in space a member twists";
  spec.frame[0].section.torsion_constant = kUnset;
  EXPECT_EQ(told(), std::vector<std::string>{"frame.0.section" + twists});
  spec.frame[0].beam_section = spec.frame[0].section;
  spec.frame[0].section.torsion_constant = 1e-6;
  EXPECT_EQ(told(), std::vector<std::string>{"frame.0.beam_section" + twists});
  spec.frame[0].beam_section = {};
  spec.frame[0].section.weak_second_moment = kUnset;
  EXPECT_EQ(told(), std::vector<std::string>{"frame.0.section.weak_second_moment: is missing: in "
                                             "space a member bends across its plane"});
}

// A section in numbers states it, else it is that in the plane.
TEST(FramesInSpace, the_shear_area_across_the_plane_may_be_stated) {
  ModelSpec spec = yard();
  spec.frame = {slender(FrameFeet::kFixed)};
  const double area = spec.frame[0].section.shear_area;
  const auto aside = [&] { return compile(spec).frames.aside_stiffness.front(); };
  const double as_in_plane = aside();
  EXPECT_EQ(as_in_plane, compile(spec).frames.shear_stiffness.front());
  spec.frame[0].section.weak_shear_area = 3 * area;
  EXPECT_NEAR(aside(), 3 * as_in_plane, 1e-12 * as_in_plane);
  spec.frame[0].section.weak_shear_area = -area;
  EXPECT_EQ(fault_of(spec), "frame.0.section.weak_shear_area: must be positive");
}

TEST(FramesInSpace, a_place_that_is_half_stated_or_stated_twice_is_refused) {
  ModelSpec spec = yard();
  spec.frame = {portal(FrameFeet::kFixed)};
  spec.frame[0].line.clear();
  spec.frame[0].hole = {.y = 0, .width = 2, .height = 2};
  EXPECT_EQ(fault_of(spec), "frame.0.hole.x: is missing");
  spec.frame[0].hole = {.x = 1};
  EXPECT_EQ(fault_of(spec), "frame.0.hole.y: is missing");
  const auto laid = [](const std::function<void(FrameSpec&)>& change) {
    ModelSpec plane = plane_wall();
    change(plane.frame[0]);
    return fault_when([&] { return along_a_line(plane); });
  };
  EXPECT_EQ(laid([](FrameSpec&) {}), "none");
  const std::string beside = ": stands beside wall, which says where the plane is";
  EXPECT_EQ(laid([](FrameSpec& f) { f.x = 0; }), "frame.0.x" + beside);
  EXPECT_EQ(laid([](FrameSpec& f) { f.z = 1; }), "frame.0.z" + beside);
  EXPECT_EQ(laid([](FrameSpec& f) { f.turn = 0.1; }), "frame.0.turn" + beside);
  EXPECT_EQ(laid([](FrameSpec& f) { f.hole.width = 1; }),
            "frame.0.hole: stands beside round, which says where the opening is");
}

TEST(FramesInSpace, faults_name_the_frame) {
  ModelSpec spec = yard();
  spec.frame = {portal(FrameFeet::kFixed), portal(FrameFeet::kFixed)};
  EXPECT_EQ(fault_of(spec), "frame.1.name: is the name of another frame");
  FrameSpec& post = spec.frame[0];
  post.name = "F0", post.feet = FrameFeet::kResting;
  post.line = {{-2.5, 0}, {-2.5, kHeight}};
  spec.stage = {scenes::gravity_stage(), push("ground", kAlong, 1e-3, 5e-4)};
  EXPECT_EQ(fault_of(spec),
            "stage.1.at: drives supports, and the feet of frame F1 stand still in the ground");
  spec.stage.pop_back();
  spec.frame[1].stage = "works";
  EXPECT_EQ(fault_of(spec), "frame.1.stage: no stage has this name");
}

}  // namespace
}  // namespace wythe::verification::frames_in_space_test
