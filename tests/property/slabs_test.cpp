// Floor slabs of the builder against closed forms: volumes, areas of their joints, pockets,
// positions, turned plans, and refusals. Tolerances are round-off of coordinates in metres.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "geometry/bodies/joint_faces.h"
#include "geometry/bodies/solid_cut.h"
#include "geometry/builder/builder.h"

namespace wythe::geometry::slabs_test {
namespace {

using Points = std::vector<std::array<double, 2>>;
constexpr double kThick = 0.15, kCourse = 0.1, kHigh = 1.2;

PlanWallSpec wall(const std::string& name, Points line, double height = kHigh) {
  PlanWallSpec spec;
  spec.name = name;
  spec.line = std::move(line);
  spec.height = height;
  spec.thickness = kThick;
  spec.unit.length = 0.3;
  spec.unit.height = kCourse;
  spec.unit.split = Split::kNone;
  return spec;
}

SlabSpec slab(std::vector<std::string> walls, double level, double bearing) {
  SlabSpec spec;
  spec.name = "deck";
  spec.walls = std::move(walls);
  spec.level = level, spec.bearing = bearing, spec.thickness = 0.16;
  spec.material = "concrete";
  return spec;
}

struct Built {
  SpaceAssembly assembly;
  std::vector<BuiltBody> body;
  FaultList faults;
  std::vector<Message> notes;
  std::vector<FloorSpec> floors;
  double walls = 0, deck = 0;              // volumes of what moves
  double under = 0, over = 0, beside = 0;  // areas of the deck's joints
};

ModelSpec site_model(bool z_up = false) {
  ModelSpec model;
  model.wall.unit.density = 2000;
  model.wall.up = z_up ? "z" : "";
  model.material["concrete"].density = 2500;
  model.material["bearing"].density = kUnset;
  return model;
}

Built build(const BuilderSpec& spec, bool z_up = false) {
  const ModelSpec model = site_model(z_up);
  Built b;
  const Site site{spec, model};
  b.body = build_bodies(site, b.notes, b.faults);
  if (!b.faults.empty()) return b;
  b.floors = floors_of_slabs(site, b.body);
  (void)contacts_of_slabs(site, b.body, b.faults);
  std::vector<BodySpec> bodies;
  for (const BuiltBody& built : b.body) bodies.push_back(built.body);
  b.assembly = assemble(bodies, b.faults);
  const auto is_deck = [&](int k) { return b.body[k].body.role == "slab"; };
  for (std::size_t k = 0; k < b.assembly.body.size() && k < b.assembly.moments.size(); ++k)
    if (!b.assembly.body[k].fixed)
      (is_deck(static_cast<int>(k)) ? b.deck : b.walls) += b.assembly.moments[k].volume;
  for (const JointFace& face : b.assembly.faces) {
    if (is_deck(face.a) == is_deck(face.b)) continue;
    const double up = is_deck(face.b) ? face.normal.y : -face.normal.y;  // towards the deck
    (up > 0.9 ? b.under : up < -0.9 ? b.over : b.beside) += face.area;
  }
  return b;
}

std::string told(const FaultList& faults) {
  std::string text;
  for (const Fault& fault : faults.all()) text += to_string(fault) + "\n";
  return text;
}

// A room of 2.7 x 2.1 m inside.
BuilderSpec room() {
  BuilderSpec spec;
  spec.plan_wall = {wall("r", {{0, 0}, {2.85, 0}, {2.85, 2.25}, {0, 2.25}, {0, 0}})};
  return spec;
}
constexpr double kInside = 2.7 * 2.1, kWalls = 2 * (2.85 + 2.25) * kThick;

TEST(Slabs, a_slab_in_a_pocket_all_round_takes_its_own_volume_from_the_walls) {
  for (const double thickness : {0.1, 0.16, 0.2}) {  // one course, one and a part, two
    BuilderSpec spec = room();
    spec.slab = {slab({"r"}, 0.8, 0.1)};
    spec.slab[0].thickness = thickness;
    const Built b = build(spec);
    ASSERT_TRUE(b.faults.empty()) << told(b.faults);
    const double all = 2.9 * 2.3, rests = all - kInside;
    EXPECT_NEAR(b.deck, all * thickness, 1e-9);
    EXPECT_NEAR(b.walls, kWalls * kHigh - rests * thickness, 1e-9);
    EXPECT_NEAR(b.under, rests, 1e-9);
    EXPECT_NEAR(b.over, rests, 1e-9);
    EXPECT_NEAR(b.beside, 2 * (2.9 + 2.3) * thickness, 1e-9);
    EXPECT_EQ(b.assembly.lost_faces, 0);
  }
}

TEST(Slabs, a_slab_through_the_whole_wall_carries_what_stands_above) {
  BuilderSpec spec = room();
  spec.slab = {slab({"r"}, 0.8, kThick)};
  const Built b = build(spec);
  ASSERT_TRUE(b.faults.empty()) << told(b.faults);
  const double all = 3.0 * 2.4;
  EXPECT_NEAR(b.walls, kWalls * (kHigh - 0.16), 1e-9);
  EXPECT_NEAR(b.under, all - kInside, 1e-9);
  EXPECT_NEAR(b.over, all - kInside, 1e-9);
  EXPECT_NEAR(b.beside, 0, 1e-9);
}

TEST(Slabs, a_slab_on_two_walls_lies_on_their_tops_and_ends_at_the_others_by_its_gap) {
  for (const double gap : {0.0, 0.02}) {
    BuilderSpec spec = room();
    spec.slab = {slab({"r.1", "r.3"}, kUnset, 0.1)};
    spec.slab[0].gap = gap;
    spec.plan_wall[0].height = 1.2;
    // side walls one course higher would stand beside it: a parapet on them does
    PlanWallSpec left = wall("left", {{0, 0.075}, {0, 2.175}}, 0.4),
                 right = wall("right", {{2.85, 0.075}, {2.85, 2.175}}, 0.4);
    for (PlanWallSpec* parapet : {&left, &right}) {
      parapet->base = kHigh;
      spec.plan_wall.push_back(*parapet);
    }
    const Built b = build(spec);
    ASSERT_TRUE(b.faults.empty()) << told(b.faults);
    EXPECT_NEAR(b.deck, (2.7 - 2 * gap) * 2.3 * 0.16, 1e-9);
    EXPECT_NEAR(b.under, (2.7 - 2 * gap) * 0.2, 1e-9);
    EXPECT_NEAR(b.beside, gap > 0 ? 0.0 : 2 * 2.1 * 0.16, 1e-9);
    EXPECT_NEAR(b.walls, kWalls * kHigh + 2 * 2.1 * kThick * 0.4, 1e-9);  // nothing was cut
  }
}

TEST(Slabs, an_outline_with_a_corner_inwards_is_one_body) {
  BuilderSpec spec = room();
  SlabSpec deck = slab({}, kHigh, kUnset);
  deck.outline = {{0, 0}, {2.85, 0}, {2.85, 2.25}, {1.5, 2.25}, {1.5, 1}, {0, 1}};
  deck.load = 2000;
  spec.slab = {deck};
  const Built b = build(spec);
  ASSERT_TRUE(b.faults.empty()) << told(b.faults);
  const double area = 2.85 * 2.25 - 1.5 * 1.25;
  EXPECT_NEAR(b.deck, area * 0.16, 1e-9);
  EXPECT_EQ(std::count_if(b.body.begin(), b.body.end(),
                          [](const BuiltBody& one) { return one.body.role == "slab"; }),
            1);
  // the loads of its parts together: their sum, and their moments about the origin
  double sum = 0, x = 0, z = 0;
  for (const FloorSpec& floor : b.floors) {
    const double force =
        floor.load * std::hypot(floor.to.x - floor.from.x, floor.to.z - floor.from.z);
    sum += force;
    x += force * 0.5 * (floor.from.x + floor.to.x);
    z += force * 0.5 * (floor.from.z + floor.to.z);
    EXPECT_NEAR(floor.from.y, kHigh + 0.16, 1e-9);
  }
  EXPECT_NEAR(sum, 2000 * area, 1e-6);
  EXPECT_NEAR(x, 2000 * (2.85 * 2.25 * 1.425 - 1.5 * 1.25 * 0.75), 1e-6);
  EXPECT_NEAR(z, 2000 * (2.85 * 2.25 * 1.125 - 1.5 * 1.25 * 1.625), 1e-6);
}

TEST(Slabs, a_turned_plan_gives_the_turned_building_whichever_axis_points_up) {
  const auto turned_room = [](double angle) {
    const auto at = [&](double x, double z) {
      return std::array<double, 2>{x * std::cos(angle) - z * std::sin(angle) + 1,
                                   x * std::sin(angle) + z * std::cos(angle) - 2};
    };
    BuilderSpec spec;
    spec.plan_wall = {wall("r", {at(0, 0), at(2.85, 0), at(2.85, 2.25), at(0, 2.25), at(0, 0)})};
    spec.slab = {slab({"r.2", "r.4", "r.1"}, 0.8, 0.1)};
    return spec;
  };
  const Built straight = build(turned_room(0));
  ASSERT_TRUE(straight.faults.empty()) << told(straight.faults);
  for (const double angle : {0.3, 1.1, M_PI / 2, 2.5})
    for (const bool z_up : {false, true}) {
      const Built b = build(turned_room(angle), z_up);
      ASSERT_TRUE(b.faults.empty()) << told(b.faults);
      EXPECT_NEAR(b.deck, straight.deck, 1e-9);
      EXPECT_NEAR(b.walls, straight.walls, 1e-9);
      EXPECT_NEAR(b.under, straight.under, 1e-9);
      EXPECT_NEAR(b.over, straight.over, 1e-9);
      EXPECT_NEAR(b.beside, straight.beside, 1e-9);
      EXPECT_EQ(b.assembly.faces.size(), straight.assembly.faces.size());
    }
}

TEST(Slabs, a_level_within_10_mm_of_a_bed_joint_moves_there_and_says_so) {
  BuilderSpec spec = room();
  spec.slab = {slab({"r"}, 0.806, 0.1)};
  const Built b = build(spec);
  ASSERT_TRUE(b.faults.empty()) << told(b.faults);
  EXPECT_NEAR(b.under, 2.9 * 2.3 - kInside, 1e-9);
  EXPECT_TRUE(std::any_of(b.notes.begin(), b.notes.end(), [](const Message& note) {
    return note.code == "slab.moved" &&
           std::fabs(note.number("to_m") - note.number("from_m") + 0.006) < 1e-9;
  }));
}

TEST(Slabs, two_storeys_stand_on_each_other) {
  BuilderSpec spec = room();
  spec.slab = {slab({"r"}, kUnset, kThick)};
  PlanWallSpec upper = spec.plan_wall[0];
  upper.name = "u", upper.base = kHigh + 0.16;
  spec.plan_wall.push_back(upper);
  const Built b = build(spec);
  ASSERT_TRUE(b.faults.empty()) << told(b.faults);
  EXPECT_NEAR(b.walls, 2 * kWalls * kHigh, 1e-9);
  EXPECT_NEAR(b.under, kWalls, 1e-9);
  EXPECT_NEAR(b.over, kWalls, 1e-9);
}

// Each fault at its key, with the value that is wrong.
TEST(Slabs, what_cannot_be_built_is_refused_at_its_key) {
  const auto first = [](const BuilderSpec& spec) {
    const Built b = build(spec);
    return b.faults.empty() ? std::string("none") : b.faults.all().front().path;
  };
  const auto with = [&](const auto& change) {
    BuilderSpec spec = room();
    spec.slab = {slab({"r"}, 0.8, 0.1)};
    change(spec);
    return first(spec);
  };
  EXPECT_EQ(with([](BuilderSpec&) {}), "none");
  EXPECT_EQ(with([](BuilderSpec& s) { s.slab[0].thickness = kUnset; }), "slab.0.thickness");
  EXPECT_EQ(with([](BuilderSpec& s) { s.slab[0].material = ""; }), "slab.0.material");
  EXPECT_EQ(with([](BuilderSpec& s) { s.slab[0].joint = "mortar"; }), "slab.0.joint");
  EXPECT_EQ(with([](BuilderSpec& s) { s.slab[0].bearing = 0.2; }), "slab.0.bearing");
  EXPECT_EQ(with([](BuilderSpec& s) { s.slab[0].bearing = kUnset; }), "slab.0.bearing");
  EXPECT_EQ(with([](BuilderSpec& s) { s.slab[0].walls = {"q"}; }), "slab.0.walls.0");
  EXPECT_EQ(with([](BuilderSpec& s) { s.slab[0].walls = {"r.1", "r.2"}; }), "slab.0.walls");
  EXPECT_EQ(with([](BuilderSpec& s) { s.slab[0].walls = {}; }), "slab.0.walls");
  EXPECT_EQ(with([](BuilderSpec& s) {
              s.slab[0].outline = {{0, 0}, {1, 0}, {1, 1}};
            }),
            "slab.0.outline");
  EXPECT_EQ(with([](BuilderSpec& s) { s.slab[0].level = 0.85; }), "slab.0.level");
  EXPECT_EQ(with([](BuilderSpec& s) {
              s.slab[0].walls = {}, s.slab[0].bearing = kUnset;
              s.slab[0].outline = {{0, 0}, {1, 1}, {1, 0}, {0, 1}};
            }),
            "slab.0.outline");
  EXPECT_EQ(
      with([](BuilderSpec& s) {
        s.plan_wall.push_back(wall("t", {{1.4, 0}, {1.4, 2.25}})), s.slab[0].walls = {"r.1", "r.3"};
      }),
      "slab.0.walls");
  EXPECT_EQ(with([](BuilderSpec& s) {
              s.slab.push_back(s.slab[0]), s.slab[1].name = "again", s.slab[1].level = 1.0,
                                           s.slab[1].joint = "bearing";
            }),
            "slab.1.joint");
  EXPECT_EQ(with([](BuilderSpec& s) { s.slab[0].name = "r"; }), "slab.0.name");
  EXPECT_EQ(with([](BuilderSpec& s) { s.plan_wall[0].base = -1; }), "plan_wall.0.base");
}

// A lintel is no masonry: it is not cut.
TEST(Slabs, a_lintel_in_the_way_is_named) {
  BuilderSpec spec = room();
  PlanWallSpec front = wall("front", {{0, 0}, {3, 0}}), back = wall("back", {{0, 2}, {3, 2}});
  OpeningSpec door;
  door.x = 1.2, door.y = 0, door.width = 0.6, door.height = 0.8;
  door.lintel.kind = "timber", door.lintel.depth = 0.1, door.lintel.bearing = 0.15,
  door.lintel.material = "concrete";
  front.opening = {door};
  spec.plan_wall = {front, back};
  spec.slab = {slab({"front", "back"}, 0.8, 0.1)};
  const Built b = build(spec);
  ASSERT_FALSE(b.faults.empty());
  EXPECT_EQ(b.faults.all().front().value, "front.lintel0") << told(b.faults);
}

// --- cutting

Polyhedron box(Vec3 low, Vec3 high) {
  return solid_between({{low.x, low.y, low.z},
                        {high.x, low.y, low.z},
                        {high.x, low.y, high.z},
                        {low.x, low.y, high.z}},
                       {{low.x, high.y, low.z},
                        {high.x, high.y, low.z},
                        {high.x, high.y, high.z},
                        {low.x, high.y, high.z}});
}

TEST(SolidCut, halves_have_the_volume_and_the_section_of_the_whole) {
  const Polyhedron whole = box({0, 0, 0}, {3, 2, 1});
  for (const Vec3 way :
       {Vec3{1, 0, 0}, Vec3{0.6, 0.8, 0}, Vec3{0.48, 0.6, 0.64}, Vec3{-0.36, 0.48, -0.8}}) {
    const double middle = dot(way, {1.5, 1, 0.5});
    const Halves halves = cut(whole, way, middle);
    EXPECT_NEAR(solid_moments(halves.below).volume, 3, 1e-12);  // through the centre: both alike
    EXPECT_NEAR(solid_moments(halves.above).volume, 3, 1e-12);
    EXPECT_GT(shared_area(halves.below, halves.above), 0.5);
  }
}

TEST(SolidCut, what_is_left_of_a_solid_hangs_together_unless_it_was_cut_through) {
  const Polyhedron whole = box({0, 0, 0}, {3, 2, 1});
  const std::vector<Polyhedron> notched = rest_of(whole, box({1, 1, -1}, {2, 3, 2}));
  double volume = 0;
  for (const Polyhedron& part : notched) volume += solid_moments(part).volume;
  EXPECT_NEAR(volume, 5, 1e-12);
  EXPECT_EQ(connected(notched).size(), 1U);
  EXPECT_EQ(connected(rest_of(whole, box({1, -1, -1}, {2, 3, 2}))).size(), 2U);
  EXPECT_EQ(rest_of(whole, box({0.5, 0.5, 0.2}, {1, 1, 0.6})).size(), 6U);  // a hole inside
  EXPECT_EQ(rest_of(whole, box({4, 0, 0}, {5, 1, 1})).size(), 1U);
}

}  // namespace
}  // namespace wythe::geometry::slabs_test
