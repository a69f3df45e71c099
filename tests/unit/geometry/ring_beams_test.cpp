// Ring beams, sills and stepped foundations: their places, their joints, and refusals.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <map>
#include <string>

#include "geometry/assembly.h"
#include "scenes/scenes.h"
#include "wythe/parts/io.h"
#include "wythe/parts/limit.h"
#include "wythe/parts/model.h"
#include "wythe/parts/solve.h"

namespace wythe::geometry::ring_beams_test {
namespace {

JointMaterial body(double density = 2500) {
  JointMaterial m;
  m.density = density;
  m.youngs_modulus = 30e9;
  m.shear_modulus = 12e9;
  return m;
}

// 2 m x 1 m of units 200 x 100 mm, 0.3 m thick, in two storeys of 0.5 m where asked.
ModelSpec wall(bool storeys = false) {
  ModelSpec spec;
  spec.wall.length = 2;
  spec.wall.height = 1;
  spec.wall.thickness = 0.3;
  spec.wall.unit.length = 0.2;
  spec.wall.unit.height = 0.1;
  spec.wall.unit.density = 1800;
  for (const char* name : {"joint", "unit", "foundation", "bed", "top"})
    spec.material[name] = scenes::paper_joint();
  spec.material["concrete"] = spec.material["stone"] = body();
  spec.stage = {scenes::gravity_stage()};
  for (const char* name : {"ground", "first"})
    if (storeys) spec.storey.emplace_back().name = name, spec.storey.back().height = 0.5;
  return spec;
}

RingBeamSpec ring(double y, double height = 0.2) {
  RingBeamSpec beam;
  beam.name = "roof";
  beam.y = y;
  beam.height = height;
  beam.material = "concrete";
  return beam;
}

OpeningSpec window(double x, double y, double width, double height) {
  OpeningSpec opening;
  opening.x = x, opening.y = y, opening.width = width, opening.height = height;
  return opening;
}

OpeningSpec window_with_sill() {
  OpeningSpec opening = window(0.6, 0.4, 0.6, 0.3);
  opening.sill = {.kind = "stone", .depth = 0.1, .bearing = 0.1, .material = "stone"};
  return opening;
}

ModelSpec stepped(std::vector<FoundationStep> steps) {
  ModelSpec spec = wall();
  spec.wall.foundation = std::move(steps);
  return spec;
}

Assembly build(const ModelSpec& spec) {
  FaultList faults;
  Assembly built = build_assembly(spec, faults);
  for (const Fault& f : faults.all()) ADD_FAILURE() << f.path << ": " << f.problem;
  return built;
}

// "path: problem; cure" of every fault.
std::string refusal(const ModelSpec& spec) {
  FaultList faults;
  (void)build_assembly(spec, faults);
  std::string text;
  for (const Fault& f : faults.all()) text += f.path + ": " + f.problem + "; " + f.cure + "\n";
  return text;
}

void expect_says(const std::string& text, const std::vector<std::string>& words) {
  for (const std::string& word : words)
    EXPECT_NE(text.find(word), std::string::npos) << word << " in: " << text;
}

bool notes_say(const Assembly& built, const std::string& word) {
  return std::any_of(built.report.notes.begin(), built.report.notes.end(),
                     [&](const Message& n) { return text_of(n).find(word) != std::string::npos; });
}

double area_of(const Assembly& built, Role role) {
  double area = 0;
  for (const Block& block : built.blocks)
    if (block.role == role) area += moments(block.outline).area;
  return area;
}

// Length of the faces of this material and kind.
double face_length(const Assembly& built, FaceKind kind, const std::string& material) {
  double sum = 0;
  for (const Face& face : built.faces)
    if (face.kind == kind && face.material == material) sum += length(face.p1 - face.p0);
  return sum;
}

// --- ring beams ------------------------------------------------------------------------------------------

TEST(RingBeam, lies_on_whole_courses_in_segments_of_half_units_with_joints_of_its_own) {
  ModelSpec spec = wall();
  spec.ring_beam = {ring(0.6)};
  spec.ring_beam[0].joint = "bed";
  spec.ring_beam[0].top_joint = "top";
  const Assembly built = build(spec);
  EXPECT_NEAR(area_of(built, Role::kRingBeam), 2 * 0.2, 1e-12);
  EXPECT_NEAR(area_of(built, Role::kMasonry), 2 * 0.8, 1e-12);
  EXPECT_NEAR(face_length(built, FaceKind::kLintelChain, "concrete"), 19 * 0.2, 1e-12);
  EXPECT_NEAR(face_length(built, FaceKind::kBed, "bed"), 2, 1e-12);
  EXPECT_NEAR(face_length(built, FaceKind::kBed, "top"), 2, 1e-12);
  EXPECT_EQ(built.report.lost_joints, 0);
}

TEST(RingBeam, of_a_storey_ends_at_its_top_and_carries_the_floor_there) {
  ModelSpec spec = wall(true);
  spec.ring_beam = {ring(kUnset)};
  spec.ring_beam[0].storey = "ground";
  spec.floor.resize(1);
  spec.floor[0].storey = "ground";
  spec.floor[0].load = 10e3;
  double top = 0;
  for (const Block& block : build(spec).blocks)
    if (block.role == Role::kRingBeam) top = std::max(top, block.outline[2].y);
  EXPECT_NEAR(top, 0.5, 1e-12);
  const Model model = compile(spec);
  for (const PointLoad& load : model.stages[0].loads)
    EXPECT_EQ(model.anatomy.block_role[load.block], BlockRole::kRingBeam);
  EXPECT_EQ(model.stages[0].loads.size(), 20U);
}

TEST(RingBeam, weighs_what_its_section_weighs_whatever_courses_it_takes) {
  ModelSpec spec = wall();
  spec.ring_beam = {ring(0.6, 0.23)};
  spec.ring_beam[0].thickness = 0.25;
  const Model model = compile(spec);
  double mass = 0, stiffness = 0;
  for (std::size_t b = 0; b < model.gravity_mass.size(); ++b)
    if (model.anatomy.block_role[b] == BlockRole::kRingBeam) mass += model.gravity_mass[b];
  EXPECT_NEAR(mass, 2 * 0.23 * 0.25 * 2500, 1e-9);
  for (std::size_t j = 0; j < model.joint_a.size(); ++j)
    if (model.anatomy.joint_kind[j] == JointKind::kLintelChain)
      stiffness = model.area[j] * model.materials[model.joint_material[j]].normal_stiffness;
  EXPECT_NEAR(stiffness / (30e9 * 0.23 * 0.25 / 0.1), 1, 1e-9);
  EXPECT_TRUE(notes_say(build(spec), "from y = 0.6 to 0.8 m"));
  EXPECT_TRUE(notes_say(build(spec), "230 mm high"));
}

TEST(RingBeam, over_a_part_of_the_wall_meets_the_masonry_at_its_ends) {
  ModelSpec spec = wall();
  spec.ring_beam = {ring(0.6)};
  spec.ring_beam[0].x = 0.42;
  spec.ring_beam[0].width = 1;
  spec.ring_beam[0].joint = "bed";
  const Assembly built = build(spec);
  EXPECT_NEAR(area_of(built, Role::kRingBeam), 1 * 0.2, 1e-12);
  EXPECT_NEAR(face_length(built, FaceKind::kHead, "bed"), 2 * 0.2, 1e-12);
  EXPECT_TRUE(notes_say(built, "from 0.42 to 1.42 m -> from 0.4 to 1.4 m"));
}

TEST(RingBeam, at_a_cut_end_of_a_surveyed_wall_goes_to_the_end) {
  ModelSpec spec = wall();
  spec.wall.fit = Fit::kCut;
  spec.wall.length = 2.07;
  spec.wall.height = 1.04;
  spec.ring_beam = {ring(0.8)};
  const Assembly built = build(spec);
  double right = 0;
  for (const Block& block : built.blocks)
    if (block.role == Role::kRingBeam) right = std::max(right, block.outline[1].x);
  EXPECT_NEAR(right, 2.07, 1e-12);
}

TEST(RingBeam, over_an_opening_is_its_lintel) {
  ModelSpec spec = wall();
  spec.wall.opening = {window(0.6, 0.2, 0.6, 0.4)};
  spec.ring_beam = {ring(0.6)};
  const Assembly built = build(spec);
  EXPECT_FALSE(notes_say(built, "hangs on its joints"));
  EXPECT_NEAR(area_of(built, Role::kRingBeam), 0.4, 1e-12);
}

TEST(RingBeam, faults_are_named_with_place_and_cure) {
  const auto said = [](const std::function<void(ModelSpec&)>& change) {
    ModelSpec spec = wall(true);
    spec.ring_beam = {ring(0.2)};
    change(spec);
    return refusal(spec);
  };
  expect_says(said([](ModelSpec& s) { s.ring_beam[0].storey = "first"; }),
              {"ring_beam.0", "two levels"});
  expect_says(said([](ModelSpec& s) { s.ring_beam[0].y = kUnset; }), {"ring_beam.0", "no level"});
  expect_says(said([](ModelSpec& s) { s.ring_beam[0].y = 0.4; }),
              {"ring_beam.0.y", "does not end within storey 0 (ground)", "y = \"0.3 m\" or less"});
  expect_says(said([](ModelSpec& s) { s.ring_beam[0].height = 0.7; }),
              {"ring_beam.0.height", "write height = \"500 mm\" or less"});
  expect_says(said([](ModelSpec& s) { s.ring_beam[0].height = kUnset; }),
              {"ring_beam.0.height", "missing"});
  expect_says(said([](ModelSpec& s) { s.ring_beam[0].thickness = 0.4; }),
              {"ring_beam.0.thickness", "thicker than the masonry there, 0.3 m"});
  expect_says(said([](ModelSpec& s) { s.ring_beam[0].x = 3; }), {"ring_beam.0.x", "outside the"});
  expect_says(said([](ModelSpec& s) { s.ring_beam[0].x = 1, s.ring_beam[0].width = 2; }),
              {"ring_beam.0.width", "ends at 3 m, outside the wall"});
  expect_says(said([](ModelSpec& s) { s.ring_beam[0].material = ""; }),
              {"ring_beam.0.material", "missing"});
  expect_says(said([](ModelSpec& s) { s.ring_beam[0].material = "cncrete"; }),
              {"material.cncrete", "a lintel, sill or ring beam is made of it"});
  expect_says(said([](ModelSpec& s) { s.ring_beam[0].joint = "none"; }),
              {"material.none", "it is the material of the joints between the blocks"});
  expect_says(said([](ModelSpec& s) { s.ring_beam.push_back(ring(0.3)); }),
              {"ring_beam.0.y", "reaches into ring beam 1 (roof)"});
  expect_says(said([](ModelSpec& s) { s.wall.opening = {window(0.6, 0.1, 0.6, 0.3)}; }),
              {"ring_beam.0.y", "reaches into opening 0"});
}

TEST(RingBeam, without_moduli_is_refused) {
  ModelSpec spec = wall();
  spec.ring_beam = {ring(0.6)};
  spec.material["concrete"].shear_modulus = kUnset;
  try {
    (void)compile(spec);
    ADD_FAILURE() << "compiled";
  } catch (const InputError& error) {
    expect_says(error.what(), {"material.concrete.shear_modulus", "ring beam"});
  }
}

TEST(RingBeam, in_a_blocks_file_says_nothing_and_is_told) {
  ModelSpec spec = scenes::block_on_ground(1, 1, scenes::paper_joint(), 0.3, 1800);
  spec.ring_beam = {ring(0.6)};
  EXPECT_TRUE(notes_say(build(spec), "ring_beam"));
}

// --- sills -----------------------------------------------------------------------------------------------

TEST(Sill, lies_in_the_courses_below_the_opening_and_reaches_into_the_masonry) {
  ModelSpec spec = wall();
  spec.wall.opening = {window_with_sill()};
  spec.wall.opening[0].sill.joint = "bed";
  const Assembly built = build(spec);
  EXPECT_NEAR(area_of(built, Role::kSill), 0.8 * 0.1, 1e-12);
  EXPECT_NEAR(face_length(built, FaceKind::kLintelChain, "stone"), 7 * 0.1, 1e-12);
  // below it, on its two ends and at its two sides
  EXPECT_NEAR(face_length(built, FaceKind::kBed, "bed"), 0.8 + 2 * 0.1, 1e-12);
  EXPECT_NEAR(face_length(built, FaceKind::kHead, "bed"), 2 * 0.1, 1e-12);
}

TEST(Sill, and_lintel_of_one_opening_are_two_chains) {
  ModelSpec spec = wall();
  spec.wall.opening = {window_with_sill()};
  spec.wall.opening[0].lintel.kind = "stone";
  spec.wall.opening[0].lintel.depth = 0.2;
  spec.wall.opening[0].lintel.bearing = 0.2;
  spec.wall.opening[0].lintel.material = "stone";
  const Assembly built = build(spec);
  EXPECT_NEAR(area_of(built, Role::kSill), 0.8 * 0.1, 1e-12);
  EXPECT_NEAR(area_of(built, Role::kLintel), 1.0 * 0.2, 1e-12);
}

TEST(Sill, of_a_cut_wall_moves_the_opening_s_foot_to_a_bed_joint) {
  ModelSpec spec = wall();
  spec.wall.fit = Fit::kCut;
  spec.wall.opening = {window_with_sill()};
  spec.wall.opening[0].y = 0.44;
  const Assembly built = build(spec);
  EXPECT_TRUE(notes_say(built, "foot 0.44 m -> 0.4 m (its sill lies under a bed joint)"));
  EXPECT_NEAR(area_of(built, Role::kSill), 0.8 * 0.1, 1e-12);
}

TEST(Sill, faults_are_named_with_place_and_cure) {
  const auto said = [](const std::function<void(ModelSpec&)>& change) {
    ModelSpec spec = wall();
    spec.wall.opening = {window_with_sill()};
    change(spec);
    return refusal(spec);
  };
  expect_says(said([](ModelSpec& s) { s.wall.opening[0].y = 0; }),
              {"wall.opening.0.sill.depth", "deeper than the masonry", "leave the sill out"});
  expect_says(said([](ModelSpec& s) { s.wall.opening[0].sill.depth = 0.6; }),
              {"wall.opening.0.sill.depth", "write depth = \"400 mm\""});
  expect_says(said([](ModelSpec& s) { s.wall.opening[0].sill.bearing = 1; }),
              {"wall.opening.0.sill.bearing", "reaches outside the wall"});
  expect_says(said([](ModelSpec& s) { s.wall.opening[0].sill.bearing = 0.02; }),
              {"wall.opening.0.sill.bearing", "a sill bears on whole half units"});
  expect_says(said([](ModelSpec& s) { s.wall.opening[0].sill.material = ""; }),
              {"wall.opening.0.sill.material", "missing"});
  expect_says(said([](ModelSpec& s) { s.wall.opening.push_back(window(1.2, 0.1, 0.4, 0.3)); }),
              {"wall.opening.0.sill", "the sill of opening 0 reaches into opening 1"});
}

// --- foundations in steps ----------------------------------------------------------------------------------

TEST(Foundation, in_steps_carries_the_wall_on_each_and_has_no_joint_at_their_sides) {
  const Assembly built = build(stepped({{0, 0.3}, {0.8, 0}, {1.4, 0.5}}));
  EXPECT_NEAR(area_of(built, Role::kMasonry), 2 - 0.8 * 0.3 - 0.6 * 0.5, 1e-12);
  std::map<double, double> carried;
  for (const Face& face : built.faces)
    if (face.kind == FaceKind::kFoundation) {
      EXPECT_EQ(face.a, kGround);
      EXPECT_NEAR(face.p0.y, face.p1.y, 1e-12);
      carried[std::round(1e3 * face.p0.y)] += length(face.p1 - face.p0);
    }
  ASSERT_EQ(carried.size(), 3U);
  EXPECT_NEAR(carried[300], 0.8, 1e-12);
  EXPECT_NEAR(carried[0], 0.6, 1e-12);
  EXPECT_NEAR(carried[500], 0.6, 1e-12);
}

TEST(Foundation, in_steps_of_a_surveyed_wall_cuts_the_units_along_them) {
  ModelSpec spec = stepped({{0, 0}, {0.93, 0.36}});
  spec.wall.fit = Fit::kCut;
  const Assembly built = build(spec);
  EXPECT_NEAR(area_of(built, Role::kMasonry), 2 - 1.07 * 0.36, 1e-12);
  double ground = 0;
  for (const Face& face : built.faces)
    if (face.kind == FaceKind::kFoundation) ground += length(face.p1 - face.p0);
  EXPECT_NEAR(ground, 2, 1e-12);
}

TEST(Foundation, of_level_ground_is_the_wall_without_one) {
  const Assembly plain = build(wall()), level = build(stepped({{0, 0}}));
  ASSERT_EQ(plain.blocks.size(), level.blocks.size());
  ASSERT_EQ(plain.faces.size(), level.faces.size());
  for (std::size_t f = 0; f < plain.faces.size(); ++f) {
    EXPECT_EQ(plain.faces[f].b, level.faces[f].b);
    EXPECT_EQ(plain.faces[f].p0.x, level.faces[f].p0.x);
  }
}

TEST(Foundation, in_steps_carries_the_whole_weight) {
  ModelSpec spec = stepped({{0, 0.3}, {1.0, 0}});
  const Model model = compile(spec);
  State state = initial_state(model);
  const Result result = solve(model, state);
  EXPECT_EQ(result.status, SolveStatus::kCompleted);
  EXPECT_NEAR(model.weight, (2 - 0.3) * 0.3 * 1800 * 9.81, 1e-6);
}

TEST(Foundation, faults_are_named_with_place_and_cure) {
  expect_says(refusal(stepped({{0.2, 0}, {1, 0.3}})), {"wall.foundation.0.x", "\"0 m\""});
  expect_says(refusal(stepped({{0, 0.2}, {1, 0.3}})),
              {"wall.foundation.0.y", "no step is at y = 0 m", "lower every step by 0.2 m"});
  expect_says(refusal(stepped({{0, 0}, {1, 0.3}, {0.5, 0}})),
              {"wall.foundation.2.x", "from left to right"});
  expect_says(refusal(stepped({{0, 0}, {1, 0}})), {"wall.foundation.1.y", "no step"});
  expect_says(refusal(stepped({{0, 0}, {2.5, 0.3}})),
              {"wall.foundation.1.x", "beyond the wall's right end"});
  expect_says(refusal(stepped({{0, 0}, {1, 1.0}})), {"wall.foundation.1.y", "leaves no masonry"});
  expect_says(refusal(stepped({{0, 0}, {1.03, 0.3}})),
              {"wall.foundation.1.x", "x = \"1 m\"", "wall.fit = \"cut\""});
  expect_says(refusal(stepped({{0, 0}, {1, 0.34}})), {"wall.foundation.1.y", "y = \"0.3 m\""});
  expect_says(refusal(stepped({{0, 0}, {1, kUnset}})), {"wall.foundation.1.y", "missing"});
  ModelSpec door = stepped({{0, 0}, {1, 0.3}});
  door.wall.opening = {window(1.2, 0.2, 0.4, 0.4)};
  expect_says(refusal(door), {"wall.opening.0.y", "reaches into the ground, which is at 0.3 m"});
}

// --- a storey's own fit ----------------------------------------------------------------------------------

TEST(Storeys, one_may_be_cut_and_the_other_whole) {
  ModelSpec spec = wall(true);
  spec.wall.height = kUnset;
  spec.storey[1].height = 0.47;
  expect_says(refusal(spec), {"wall.unit.height", "or wall.fit = \"cut\""});
  spec.storey[1].fit = "cut";
  EXPECT_NEAR(area_of(build(spec), Role::kMasonry), 2 * 0.97, 1e-12);
  spec.wall.fit = Fit::kCut;
  spec.storey[1].fit = "whole";
  expect_says(refusal(spec), {"or storey.1.fit = \"cut\""});
  spec.storey[1].fit = "cute";
  expect_says(refusal(spec), {"storey.1.fit", "must be one of whole, cut", "did you mean cut?"});
}

TEST(Storeys, the_guided_way_of_a_surveyed_wall_is_not_offered_where_a_storey_refuses_it) {
  ModelSpec spec = wall(true);
  spec.wall.height = kUnset;
  spec.storey[1].height = 0.47;
  for (int i = 0; i < 3; ++i) spec.wall.opening.push_back(window(0.13 + 0.6 * i, 0.13, 0.4, 0.3));
  expect_says(refusal(spec), {"wall.fit", "sizes do not fit whole units"});
  spec.storey[1].fit = "whole";
  EXPECT_EQ(refusal(spec).find("sizes do not fit whole units"), std::string::npos);
}

// --- loads on strips of full height, second opinions -------------------------------------------------------

TEST(PierLoad, on_a_building_says_on_which_strips_it_acts) {
  ModelSpec spec = wall(true);
  spec.wall.opening = {window(0.4, 0.1, 0.4, 0.3), window(1.0, 0.6, 0.4, 0.3)};
  StageSpec load{.name = "load", .action = LoadStage{.pier_load = 50e3}};
  spec.stage.push_back(load);
  std::string notes;
  for (const Message& note : compile(spec).anatomy.notes) notes += text_of(note) + "\n";
  expect_says(notes, {"50 kN", "each of the 3 strips", "x = 0 to 0.4 m, 0.8 to 1 m, 1.4 to 2 m"});
}

TEST(PierLoad, without_a_strip_of_full_height_is_refused_and_would_load_nothing) {
  ModelSpec spec = wall(true);
  spec.wall.opening = {window(0, 0.1, 1.2, 0.3), window(1.0, 0.6, 1.0, 0.3)};
  StageSpec load{.name = "load", .action = LoadStage{.pier_load = 50e3}};
  spec.stage.push_back(load);
  try {
    (void)compile(spec);
    ADD_FAILURE() << "compiled";
  } catch (const InputError& error) {
    expect_says(error.what(), {"pier_load", "no strip of full height", "pressure"});
  }
}

// Portals have three bodies on one ground.
TEST(RingBeam, and_steps_of_the_ground_have_no_macro_blocks_and_say_so_by_name) {
  const auto said = [](const std::function<void(ModelSpec&)>& change) -> std::string {
    ModelSpec spec = scenes::small_wall();
    spec.wall.opening[0].y = 0;
    spec.wall.opening[0].height = 0.44;
    spec.material["concrete"] = body();
    change(spec);
    try {
      (void)find_portal(compile(spec));
    } catch (const InputError& error) {
      return error.what();
    }
    return "";
  };
  EXPECT_EQ(said([](ModelSpec&) {}), "");
  expect_says(said([](ModelSpec& s) { s.ring_beam = {ring(0.77, 0.11)}; }),
              {"ring_beam", "ties the macro-blocks together"});
  expect_says(said([](ModelSpec& s) {
                s.wall.foundation = {{0, 0}, {0.93, 0.22}};
              }),
              {"wall.foundation", "ground of one level"});
}

// From 3 % of the wall's mass on, added inertia changes a
// push by more than a percent or two (docs/decisions/0009).
TEST(RingBeam, whose_segments_get_much_inertia_says_that_it_drags) {
  bool dragged = false, raised = false;
  for (const auto& [modulus, width] : {std::pair(30e9, kUnset), std::pair(10e9, kUnset),
                                       std::pair(10e9, 0.4), std::pair(5e9, 0.4)}) {
    ModelSpec spec = wall();
    spec.material["concrete"].youngs_modulus = modulus;
    spec.material["concrete"].shear_modulus = 0.4 * modulus;
    spec.ring_beam = {ring(0.8)};
    spec.ring_beam[0].width = width;
    const Model model = compile(spec);
    double heavy = 0, mass = 0, said = 0;
    for (std::size_t i = 0; i < model.mass.size(); ++i)
      heavy += model.gravity_mass[i], mass += model.mass[i];
    const double percent = 100 * (mass / heavy - 1);
    for (const Message& note : model.anatomy.notes) {
      if (!note.code.starts_with("inertia.block")) continue;
      EXPECT_EQ(note.code == "inertia.blocks_drag", percent > 3) << modulus;
      for (const Argument& argument : note.arguments)
        if (argument.name == "of_wall_percent") said = std::get<double>(argument.value);
      (percent > 3 ? dragged : raised) = true;
    }
    EXPECT_NEAR(said, percent, 1e-9) << modulus;
  }
  EXPECT_TRUE(dragged);
  EXPECT_TRUE(raised);
}

// A ring beam with the masonry's weight and joints can only carry more (static theorem).
TEST(RingBeam, counts_as_rigid_in_the_limit_load_and_is_named) {
  ModelSpec spec = scenes::small_wall();
  spec.material["concrete"] = body(spec.wall.unit.density);
  const double bare = limit_load(compile(spec), {}).load;
  spec.ring_beam = {ring(0.66, 0.11)};
  const Model model = compile(spec);
  std::string notes;
  for (const Message& note : left_aside(model)) notes += text_of(note) + "\n";
  expect_says(notes, {"ring beams", "rigid and unbreakable"});
  EXPECT_GE(limit_load(model, {}).load, bare * (1 - 1e-6));
}

}  // namespace
}  // namespace wythe::geometry::ring_beams_test
