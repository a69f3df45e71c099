// Walls in space seen across their planes. A wall in its plane, as prisms in space and as turned
// prisms has the same parts, forces, drifts and names. A building has those of each of its walls.
#include "judge/modes/elevations.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <string>
#include <vector>

#include "judge/modes/in_space.h"
#include "judge/modes/joint_motion.h"
#include "judge/modes/wall_parts.h"
#include "report/wall_picture.h"
#include "scenes/mechanism.h"
#include "scenes/scenes.h"
#include "wythe/parts/assessment.h"
#include "wythe/parts/element_forces.h"
#include "wythe/parts/error.h"
#include "wythe/parts/failure_mode.h"
#include "wythe/parts/io.h"
#include "wythe/parts/mechanism.h"
#include "wythe/parts/reading.h"
#include "wythe/parts/solve.h"

namespace wythe::elevations_test {
namespace {

using scenes::Mechanism;
using scenes::Motion;

constexpr double kColumn = 0.155, kCourse = 0.11, kTurn = 0.7, kRoundOff = 1e-9;
constexpr scenes::BondSize kPortal{
    .columns = 14, .courses = 12, .hole_at_column = 5, .hole_at_course = 4, .hole = 4};
constexpr double kLength = kPortal.columns * kColumn;

ModelSpec portal() {
  ModelSpec spec = scenes::half_units(kPortal, scenes::paper_joint());
  StageSpec push = scenes::push_stage("r11c0", Direction::kPlusX, 0.02, 3e-3);
  push.damping = 0.2;
  spec.stage = {scenes::gravity_stage(), push};
  return spec;
}
ModelSpec portal_in_space(double turn = 0) {
  ModelSpec plane = portal();
  ModelSpec solid = scenes::prisms(plane);
  solid.stage.back().get<PushStage>().drive.along = {1, 0, 0};
  return turn == 0 ? solid : scenes::turned_about_y(solid, turn);
}

// A state of a wall in its plane as one of its prisms, turned about the upright axis.
State in_space(const Model& plane, const State& flat, const Model& solid, double turn = 0) {
  State state = initial_state(solid);
  const Rotation about{{0, turn, 0}};
  for (BlockId b = 0; b < plane.n_block; ++b) {
    const auto i = static_cast<std::size_t>(b);
    const auto k = static_cast<std::size_t>(scenes::block_named(solid, plane.anatomy.block_id[i]));
    const Vec3 u = turned(Vec3{flat.ux[i], flat.uy[i], 0}, about);
    const Vec3 axis = turned(Vec3{0, 0, 1}, about);
    state.ux[k] = u.x, state.uy[k] = u.y, state.uz[k] = u.z;
    const double sine = std::sin(flat.theta[i] / 2);
    state.qw[k] = std::cos(flat.theta[i] / 2);
    state.qx[k] = sine * axis.x, state.qy[k] = sine * axis.y, state.qz[k] = sine * axis.z;
  }
  const std::vector<PointReading> points = read_points(solid, state);
  for (std::size_t p = 0; p < points.size(); ++p) {
    state.kappa[p] = std::max(0.0, points[p].opening);
    state.slip[p] = points[p].slip;
    state.plastic_slip[p] = points[p].slip;
  }
  return state;
}

Result read_at(const State& state) {
  Result result;
  result.states.readings.push_back({"end", 40e-3, 0, state});
  return result;
}

void expect_same(const study::Part& a, const study::Part& b, double tolerance) {
  EXPECT_EQ(a.name, b.name);
  EXPECT_EQ(a.mark, b.mark);
  EXPECT_EQ(a.storey, b.storey);
  EXPECT_NEAR(a.box.width(), b.box.width(), tolerance) << a.name;
  EXPECT_NEAR(a.box.y0, b.box.y0, tolerance) << a.name;
  EXPECT_NEAR(a.box.y1, b.box.y1, tolerance) << a.name;
}

TEST(Elevations, a_wall_in_space_has_the_parts_of_the_plane_wall_in_any_world) {
  const auto plane = study::find_parts(compile(portal()));
  ASSERT_EQ(plane.piers.size(), 2U);
  for (const double turn : {0.0, kTurn, -1.2}) {
    const auto solid = study::find_parts(compile(portal_in_space(turn)));
    const auto of_plane = study::all_parts(plane), of_solid = study::all_parts(solid);
    ASSERT_EQ(of_plane.size(), of_solid.size()) << turn;
    for (std::size_t k = 0; k < of_plane.size(); ++k)
      expect_same(*of_plane[k].first, *of_solid[k].first, kRoundOff);
    EXPECT_NEAR(plane.course, solid.course, kRoundOff);
    EXPECT_NEAR(plane.column, solid.column, kRoundOff);
  }
}

// Rigid bodies that move as some kinds of failure do.
std::vector<Mechanism> mechanisms() {
  const double head = 8 * kCourse, jamb = 5 * kColumn, far_jamb = 9 * kColumn;
  return {
      [=](double x, double y) {  // both piers rock, the spandrel goes along level
        if (y > head) return Motion{.move_x = 8 * kCourse * 0.02, .move_y = 0};
        if (x < jamb) return Motion{.pivot_x = jamb, .pivot_y = 0, .turn = -0.02};
        if (x > far_jamb) return Motion{.pivot_x = kLength, .pivot_y = 0, .turn = -0.02};
        return Motion{};
      },
      [=](double, double y) { return Motion{.move_x = y > 0 ? 0.01 : 0}; },
      [=](double, double y) { return Motion{.move_x = y > 6 * kCourse ? 0.01 : 0}; },
      [=](double x, double y) {  // a step through the right pier
        const bool beyond = x > far_jamb && y > 4 * kCourse + 0.7 * (x - far_jamb);
        return Motion{.move_x = beyond || y > head ? 0.01 : 0};
      },
  };
}

TEST(Elevations, a_wall_in_space_fails_by_the_name_of_the_plane_wall) {
  const Model plane = compile(portal());
  std::set<std::string> names;
  for (const double turn : {0.0, kTurn}) {
    const Model solid = compile(portal_in_space(turn));
    for (const Mechanism& mechanism : mechanisms())
      for (const bool mirror : {false, true}) {
        const State flat =
            scenes::moved(plane, mirror ? scenes::mirrored(mechanism, kLength) : mechanism);
        const Result in_plane = read_at(flat),
                     as_solid = read_at(in_space(plane, flat, solid, turn));
        const FailureMode a = name_failure_mode(plane, in_plane),
                          b = name_failure_mode(solid, as_solid);
        names.insert(a.name);
        ASSERT_EQ(a.elements.size(), b.elements.size());
        for (std::size_t k = 0; k < a.elements.size(); ++k) {
          EXPECT_EQ(a.elements[k].element, b.elements[k].element);
          EXPECT_EQ(a.elements[k].state, b.elements[k].state) << a.elements[k].element;
          for (std::size_t s = 0; s < a.elements[k].signs.size(); ++s)
            EXPECT_NEAR(a.elements[k].signs[s].value, b.elements[k].signs[s].value,
                        1e-6 + 1e-3 * std::fabs(a.elements[k].signs[s].value))
                << a.elements[k].element << ": " << a.elements[k].signs[s].state;
        }
        if (a.name == "unclear") continue;  // in space it may still have a name by what moved
        EXPECT_EQ(a.name, b.name);
        EXPECT_EQ(read_mechanism(plane, in_plane).name, read_mechanism(solid, as_solid).name);
        EXPECT_TRUE(study::stays_in_plane(b.name)) << b.name;
      }
  }
  EXPECT_GE(names.size(), 3U);
}

struct Pushed {
  Model model;
  Result result;
  PushedWall wall;
  explicit Pushed(const ModelSpec& spec) : model(compile(spec)) {
    State state = initial_state(model);
    result = solve(model, state, {});
    wall = read_pushed_wall(spec, model, result);
  }
};

// Equal points, so that nothing but the step differs.
ModelSpec with_storeys(ModelSpec spec) {
  spec.solve.points_per_face = 2;
  spec.solve.point_rule = PointRule::kCorners;
  StoreySpec low, high;
  low.name = "low", low.height = 6 * kCourse;
  high.name = "high", high.height = 5.5 * kCourse;
  if (!spec.body.empty()) spec.storey = {low, high};
  return spec;
}

TEST(Elevations, a_push_in_space_has_the_drifts_and_the_forces_of_the_plane_push) {
  ModelSpec plane_spec = with_storeys(portal());
  plane_spec.storey.clear();
  const Pushed plane(plane_spec), solid(with_storeys(portal_in_space())),
      turned(with_storeys(portal_in_space(kTurn)));
  const auto forces = read_element_forces(plane.model, plane.result);
  for (const Pushed* other : {&solid, &turned}) {
    ASSERT_EQ(other->wall.piers.size(), plane.wall.piers.size());
    for (std::size_t k = 0; k < plane.wall.piers.size(); ++k) {
      const PierDrift &a = plane.wall.piers[k], &b = other->wall.piers[k];
      EXPECT_EQ(a.element, b.element);
      ASSERT_EQ(a.drifts.size(), b.drifts.size());
      EXPECT_NEAR(a.drifts.front().drift, b.drifts.front().drift, 0.02 * a.drifts.front().drift);
      EXPECT_NEAR(a.drifts.front().shear, b.drifts.front().shear,
                  0.02 * std::fabs(a.drifts.front().shear));
    }
    const auto own = read_element_forces(other->model, other->result);
    ASSERT_EQ(own.size(), forces.size());
    double most = 0;
    for (const ElementForces& e : forces) most = std::max(most, std::fabs(e.rows[1].end[0].axial));
    for (std::size_t e = 0; e < forces.size(); ++e)
      for (const std::size_t end : {0, 1}) {
        const ElementEnd &a = forces[e].rows[1].end[end], &b = own[e].rows[1].end[end];
        EXPECT_NEAR(a.axial, b.axial, 0.02 * most) << forces[e].element;
        EXPECT_NEAR(a.shear, b.shear, 0.02 * most) << forces[e].element;
        EXPECT_NEAR(a.moment, b.moment, 0.02 * most * kLength) << forces[e].element;
      }
    EXPECT_FALSE(other->wall.storeys.empty());
  }
  for (std::size_t k = 0; k < solid.wall.storeys.size() && k < turned.wall.storeys.size(); ++k)
    EXPECT_NEAR(solid.wall.storeys[k].drift, turned.wall.storeys[k].drift,
                0.05 * solid.wall.storeys[k].drift);
}

// The capacity of both walls, and the governing limit.
CodeAssessment assessed(ModelSpec spec) {
  spec.assessment.code = "circolare_2019";
  spec.assessment.spectrum.kind = SpectrumKind::kEn1998;
  spec.assessment.spectrum.ground_acceleration = 2;
  spec.assessment.spectrum.ground = "B", spec.assessment.spectrum.shape = "1";
  const Model model = compile(spec);
  State state = initial_state(model);
  Result result = solve(model, state, {});
  result.failure_mode = name_failure_mode(model, result, 3e-3);
  return assess_run(spec, model, result);
}

TEST(Elevations, a_wall_in_space_gets_the_verdict_of_the_plane_wall) {
  ModelSpec plane_spec = with_storeys(portal());
  const CodeAssessment plane = assessed(plane_spec),
                       solid = assessed(with_storeys(portal_in_space(kTurn)));
  EXPECT_EQ(plane.verdict, solid.verdict);
  ASSERT_NE(plane.asked(), nullptr);
  ASSERT_NE(solid.asked(), nullptr);
  ASSERT_TRUE(std::isfinite(plane.asked()->acceleration)) << text_of(plane.sentence);
  EXPECT_EQ(plane.asked()->governing, solid.asked()->governing);
  EXPECT_NEAR(plane.asked()->acceleration, solid.asked()->acceleration,
              0.05 * plane.asked()->acceleration);
  const auto notes_piers = [](const CodeAssessment& a) {
    return std::any_of(a.notes.begin(), a.notes.end(), [](const Message& note) {
      return note.code == "assessment.note.pier_drift";
    });
  };
  EXPECT_EQ(notes_piers(plane), notes_piers(solid));
}

// --- a building --------------------------------------------------------------------------------------

const std::string kHouse = R"(
[wall]
height = "1.2 m"
thickness = "0.2 m"
[wall.unit]
length = "400 mm"
height = "100 mm"
density = "2000 kg/m^3"
split = "none"
[material.joint]
normal_stiffness = "20 GPa/m"
shear_stiffness = "8 GPa/m"
tensile_strength = "0.5 MPa"
cohesion = "0.8 MPa"
residual_cohesion = "0 MPa"
friction_angle = "30 deg"
residual_friction_angle = "30 deg"
mode_1_energy = "20 N/m"
mode_2_energy = "200 N/m"
compressive_strength = "unlimited"
[material.timber]
density = "600 kg/m^3"
[[plan_wall]]
name = "front"
line = [["0 m", "0 m"], ["2.0 m", "0 m"]]
MEETS
[[plan_wall.opening]]
name = "window"
x = "0.8 m"
y = "0.4 m"
width = "0.4 m"
height = "0.4 m"
lintel = { kind = "timber", bearing = "200 mm", depth = "100 mm", material = "timber" }
[[plan_wall]]
name = "left"
line = [["0 m", "1.5 m"], ["0 m", "0 m"]]
MEETS
[[plan_wall]]
name = "right"
line = [["2.0 m", "0 m"], ["2.0 m", "1.5 m"]]
MEETS
[[stage]]
name = "gravity"
)";
Model house(const std::string& meets, const std::string& more = "") {
  std::string text = kHouse + more;
  for (std::size_t k = text.find("MEETS"); k != std::string::npos; k = text.find("MEETS"))
    text.replace(k, 5, "meets = \"" + meets + "\"");
  return compile(parse_model(text, "house.toml", {}));
}

TEST(Elevations, a_house_has_the_parts_of_each_of_its_walls) {
  for (const std::string meets : {"toothed", "butted"}) {
    const Model model = house(meets);
    const auto walls = study::elevations_of(model);
    ASSERT_EQ(walls.size(), 3U);
    EXPECT_EQ(walls[0].wall, "front");
    EXPECT_NEAR(walls[0].along.x, 1, kRoundOff);
    EXPECT_NEAR(walls[1].along.z, 1, kRoundOff) << "towards +z, whatever its line";
    EXPECT_TRUE(study::is_along(walls[0], {1, 0, 0}));
    EXPECT_FALSE(study::is_along(walls[1], {1, 0, 0}));
    const auto parts = study::find_parts(model);
    std::vector<std::string> names;
    for (const study::Pier& pier : parts.piers) names.push_back(pier.name);
    EXPECT_EQ(names, (std::vector<std::string>{"front: left pier", "front: right pier",
                                               "left: wall", "right: wall"}))
        << meets;
    ASSERT_EQ(parts.spandrels.size(), 2U);  // a sill and a spandrel
    EXPECT_EQ(parts.openings, 1) << "a corner has no hole in every second course";
    EXPECT_NEAR(parts.column, 0.2, kRoundOff);
    EXPECT_NEAR(parts.course, 0.1, kRoundOff);
    EXPECT_NEAR(parts.piers[0].box.y0, 0.4, kRoundOff);
    EXPECT_NEAR(parts.piers[0].box.y1, 0.8, kRoundOff);
    EXPECT_EQ(parts.piers[2].mark, "P3");
    EXPECT_EQ(parts.piers[2].elevation, 1);
  }
}

// Butted walls share no block, so that the ground carries each wall's own piers: together the whole house.
TEST(Elevations, what_the_walls_of_a_house_carry_adds_up_to_its_weight) {
  const Model model = house("butted");
  State state = initial_state(model);
  const Result result = solve(model, state, {});
  ASSERT_EQ(result.status, SolveStatus::kCompleted) << result.reason;
  Result rest;
  rest.states.readings.push_back({"end", 0, 0, state});
  double windows = 0, bare = 0;
  for (const ElementForces& e : read_element_forces(model, rest)) {
    if (e.kind != "pier") continue;
    (e.element.starts_with("front") ? windows : bare) += e.rows.back().end[0].axial;
  }
  double above = 0, sides = 0;
  for (BlockId b = 0; b < model.n_block; ++b) {
    const auto i = static_cast<std::size_t>(b);
    const double weight = model.gravity_mass[i] * model.solve.gravity;
    if (!model.anatomy.block_id[i].starts_with("front"))
      sides += weight;
    else if (model.centroid_y[i] > 0.4)
      above += weight;
  }
  // bonded walls hang on each other at the corners: the sum is exact, the shares are not
  EXPECT_NEAR(windows + bare, above + sides, 0.02 * (above + sides));
  EXPECT_GT(windows, 0.7 * above);
  EXPECT_GT(bare, 0.7 * sides);
}

// In space a storey is a level: the blocks that hold its top tell its drift.
TEST(Elevations, storeys_of_a_house_are_levels_and_lay_no_masonry) {
  const std::string levels =
      "[[storey]]\nname = \"low\"\nheight = \"0.55 m\"\n"
      "[[storey]]\nname = \"high\"\nheight = \"0.6 m\"\n";
  const Model model = house("toothed", levels);
  EXPECT_EQ(model.anatomy.storey_name, (std::vector<std::string>{"low", "high"}));
  ASSERT_EQ(model.anatomy.storey_top.size(), 2U);
  EXPECT_DOUBLE_EQ(model.anatomy.storey_top[1], 1.15);
  const auto refusal = [&](const std::string& more) -> std::string {
    try {
      (void)house("toothed", more);
    } catch (const InputError& error) {
      return error.what();
    }
    return "";
  };
  const std::string thick = refusal(levels + "thickness = \"0.3 m\"\n");
  EXPECT_NE(thick.find("storey"), std::string::npos) << thick;
  EXPECT_NE(thick.find("write it in [[plan_wall]]"), std::string::npos) << thick;
  const std::string twice = refusal(levels + levels);
  EXPECT_NE(twice.find("two storeys have this name"), std::string::npos) << twice;
  const std::string region = refusal("[[region]]\nstorey = \"low\"\n");
  EXPECT_NE(region.find("is for walls in their plane"), std::string::npos) << region;
}

// --- what is of a wall -----------------------------------------------------------------------------

// Blocks that `moves` names by id and place go 10 mm along x; joints bear what that does to them.
template <class Moves>
State slid_along_x(const Model& model, const Moves& moves) {
  State state = initial_state(model);
  for (BlockId b = 0; b < model.n_block; ++b) {
    const auto i = static_cast<std::size_t>(b);
    if (moves(model.anatomy.block_id[i], centroid_of(model, b))) state.ux[i] = 0.01;
  }
  const std::vector<PointReading> points = read_points(model, state);
  for (std::size_t p = 0; p < points.size(); ++p) {
    state.slip[p] = state.plastic_slip[p] = points[p].slip;
    state.kappa[p] = std::max(0.0, points[p].opening);
  }
  return state;
}

Model two_leaves() {
  std::string text = kHouse.substr(0, kHouse.find("[[plan_wall]]"));
  text.replace(text.find("split = \"none\""), 14, "split = \"middle\"");
  const std::size_t joint = text.find("[material.joint]"), timber = text.find("[material.timber]");
  text += "[material.unit]" + text.substr(joint + 16, timber - joint - 16) +
          "[[plan_wall]]\nname = \"front\"\nline = [[\"0 m\", \"0 m\"], [\"2.0 m\", \"0 m\"]]\n"
          "wythes = 2\n[[stage]]\nname = \"gravity\"\n";
  return compile(parse_model(text, "leaves.toml", {}));
}

TEST(Elevations, leaves_of_a_wall_count_by_their_share_of_its_thickness) {
  const Model model = two_leaves();
  const auto walls = study::elevations_of(model);
  ASSERT_EQ(walls.size(), 1U);
  const study::WallParts parts = study::find_parts(model);
  const auto slip_of = [&](const std::string& leaf) {
    const State state = slid_along_x(model, [&](const std::string& id, const Vec3& at) {
      return at.y > 0.6 && (leaf.empty() || id.ends_with(leaf));
    });
    const auto motion = study::evaluate_motion(model, state, walls[0]);
    double most = 0;
    for (const auto& section : study::bed_sections(motion.joints, parts.wall, parts.course)) {
      double length = 0;
      for (const study::JointMotion* j : section.joints) length += j->length();
      EXPECT_NEAR(length, 2.0, 1e-6) << section.y;
      most = std::max(most, study::slip_all_across(section, parts.wall.width()));
    }
    return most;
  };
  EXPECT_NEAR(slip_of(""), 0.01, 1e-6);
  EXPECT_EQ(slip_of(".w1"), 0) << "half of the wall did not slide";
  const State parted = slid_along_x(
      model, [](const std::string& id, const Vec3& at) { return at.x > 1 && id.ends_with(".w1"); });
  const auto motion = study::evaluate_motion(model, parted, walls[0]);
  for (const auto& line : study::scan(motion.joints, parts.wall, study::Lines::kLevel, 0.1))
    EXPECT_NEAR(line.opening, 0.005, 1e-6) << "one leaf of two by 10 mm, at " << line.at;
  EXPECT_NEAR(parts.column, 0.2, kRoundOff) << "halves of a unit in a leaf are one unit";
}

TEST(Elevations, frames_and_what_is_cut_out_are_no_walls) {
  for (const bool is_cut : {false, true}) {
    ModelSpec spec = scenes::framed(scenes::small_wall());
    spec.wall.opening[0].name = "window";
    spec.stage[1].get<LoadStage>().pier_load = kUnset;
    spec.stage[1].get<LoadStage>().pressure = 50e3;
    if (is_cut) spec = scenes::cut_under_load(spec);
    const Model model = compile(scenes::along_a_line(spec));
    ASSERT_GT(model.frames.n, 0);
    const auto walls = study::elevations_of(model);
    ASSERT_EQ(walls.size(), 1U) << is_cut;
    EXPECT_EQ(study::walls_by_push(model, {1, 0, 0}).walls, 1) << is_cut;
    // the picture has what stands before the first cut
    int standing = 0;
    for (BlockId b = 0; b < model.n_block; ++b)
      standing += walls[0].holds(b) && model.standing.holds(b, 0) ? 1 : 0;
    const std::string svg = report::draw_elevations(model, walls, {{}});
    int drawn = 0;
    for (const char* css : {"stone0", "stone1", "stone2", "stone3", "timber", "plate"}) {
      const std::size_t at = svg.find("class=\"" + std::string(css) + "\"");
      if (at == std::string::npos) continue;
      const std::string path = svg.substr(at, svg.find('>', at) - at);
      drawn += static_cast<int>(std::count(path.begin(), path.end(), 'M'));
    }
    EXPECT_EQ(drawn, standing) << is_cut;
  }
}

// Every wall slides along x: the front in its plane, the sides out of theirs.
TEST(Elevations, walls_that_slide_along_and_across_do_not_stay_in_their_planes) {
  const std::string push =
      "[[stage]]\nname = \"push\"\nat = { x = \"0.1 m\", y = \"1.15 m\", z = \"0 m\" }\n"
      "direction = \"+x\"\nvelocity = \"2 mm/s\"\nuntil = \"1 mm\"\n";
  std::string text = kHouse + push;
  for (std::size_t k = text.find("MEETS"); k != std::string::npos; k = text.find("MEETS"))
    text.replace(k, 5, "meets = \"butted\"");
  const ModelSpec spec = parse_model(text, "house.toml", {});
  const Model model = compile(spec);
  const auto mode_of = [&](bool front_alone) {
    return name_from_state(model, slid_along_x(model, [&](const std::string& id, const Vec3& at) {
                             return at.y > 0.8 && (!front_alone || id.starts_with("front"));
                           }));
  };
  const FailureMode both = mode_of(false), front = mode_of(true);
  EXPECT_EQ(both.name, "sliding");
  EXPECT_FALSE(both.elements.empty());
  EXPECT_FALSE(study::stays_in_planes(both));
  EXPECT_TRUE(study::stays_in_planes(front)) << front.name;
  const auto cautions_of = [&](FailureMode mode, const std::string& name) {
    Result result;
    result.failure_mode = std::move(mode);
    result.failure_mode.name = name;
    std::set<std::string> codes;
    for (const Message& caution : assess_run(spec, model, result).cautions)
      codes.insert(caution.code);
    return codes;
  };
  EXPECT_TRUE(cautions_of(both, "sliding").contains("assessment.caution.sliding"));
  EXPECT_FALSE(cautions_of(front, "sliding").contains("assessment.caution.sliding"));
  const std::string breaking = "part breaking away", off = "assessment.caution.out_of_plane";
  EXPECT_TRUE(cautions_of(both, breaking).contains(off));
  EXPECT_FALSE(cautions_of(front, breaking).contains(off)) << "it broke away in its plane";
}

TEST(Elevations, a_wall_that_leaves_its_plane_has_no_mechanism_of_plane_walls) {
  const Model model = compile(portal_in_space());
  State state = initial_state(model);
  const double turn = 0.02;
  double half = 0;
  for (BlockId b = 0; b < model.n_block; ++b)
    for (const Vec3& corner : corners_of(model, b)) half = std::max(half, corner.z);
  for (BlockId b = 0; b < model.n_block; ++b) {
    const auto i = static_cast<std::size_t>(b);
    const Vec3 arm = centroid_of(model, b) - Vec3{0, 0, half};
    const Vec3 u = turned(arm, Rotation{{turn, 0, 0}}) - arm;
    state.ux[i] = u.x, state.uy[i] = u.y, state.uz[i] = u.z;
    state.qw[i] = std::cos(turn / 2), state.qx[i] = std::sin(turn / 2);
  }
  const FailureMode mode = name_from_state(model, state);
  EXPECT_EQ(mode.name, "overturning");
  EXPECT_FALSE(study::stays_in_planes(mode));
  EXPECT_EQ(mechanism_from_state(model, state).name, "overturning");
}

}  // namespace
}  // namespace wythe::elevations_test
