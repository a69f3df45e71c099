// Laws of every generated wall, for any bond, split, size and openings:
//   nothing overlaps, nothing is missing (areas add up), every pair of facing units touches over all of its
//   common length (lengths add up), head joints are staggered, a mirrored wall mirrors.
// Tolerances are round-off: coordinates of metres, a few hundred to thousands of terms.
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

#include "geometry/polygon.h"
#include "geometry/wall/checks.h"

namespace wythe::geometry::geometry_property_test {
namespace {

constexpr double kColumn = 0.12, kCourse = 0.08;  // half unit and course [m]

// An opening in whole columns and courses; `width` 0 is none.
struct Window {
  int x = 0, y = 0, width = 0, height = 0;
};

struct Scene {
  Bond bond = Bond::kRunning;
  Split split = Split::kMiddle;
  int columns = 12, courses = 8;
  Window window;
  bool has_lintel = false;
  double header = kUnset;
};

OpeningSpec opening_of(const Scene& scene) {
  OpeningSpec opening;
  opening.x = kColumn * scene.window.x;
  opening.y = kCourse * scene.window.y;
  opening.width = kColumn * scene.window.width;
  opening.height = kCourse * scene.window.height;
  if (scene.has_lintel) {
    opening.lintel = {.kind = "timber", .depth = kCourse, .bearing = kColumn, .material = "timber"};
  }
  return opening;
}

ModelSpec spec_of(const Scene& scene) {
  ModelSpec spec;
  spec.wall.length = kColumn * scene.columns;
  spec.wall.height = kCourse * scene.courses;
  spec.wall.thickness = 0.25;
  spec.wall.bond = scene.bond;
  spec.wall.unit.length = 2 * kColumn;
  spec.wall.unit.height = kCourse;
  spec.wall.unit.split = scene.split;
  spec.wall.unit.density = 1800;
  // In header bond the header is the unit that spans two columns.
  spec.wall.unit.width = scene.bond == Bond::kHeader ? 2 * kColumn : scene.header;
  for (const char* name : {"joint", "unit", "timber"}) spec.material[name] = {};
  spec.material["timber"].density = 500;
  if (scene.window.width > 0) spec.wall.opening = {opening_of(scene)};
  return spec;
}

Assembly build(const Scene& scene) {
  FaultList faults;
  Assembly wall = build_assembly(spec_of(scene), faults);
  for (const Fault& fault : faults.all()) ADD_FAILURE() << fault.path << ": " << fault.problem;
  return wall;
}

double window_area(const Scene& s) { return s.window.width * s.window.height * kColumn * kCourse; }

double total_area(const Assembly& wall) {
  double area = 0;
  for (const Block& block : wall.blocks) area += moments(block.outline).area;
  return area;
}

double perimeter(const Polygon& outline) {
  double sum = 0;
  for (std::size_t i = 0; i < outline.size(); ++i) {
    sum += length(outline[(i + 1) % outline.size()] - outline[i]);
  }
  return sum;
}

// Boundary of the solid that no block or ground can touch. A window on the ground has no sill.
double free_boundary(const Scene& s, const Assembly& wall) {
  const double width = kColumn * s.window.width, height = kCourse * s.window.height;
  const double sill = s.window.y > 0 ? width : 0;
  return 2 * wall.height + wall.length + 2 * height + width + sill;
}

// Each contact covers one side of two blocks (of one on the ground).
double touched_boundary(const Assembly& wall) {
  double sum = 0;
  for (const Face& face : wall.faces) {
    sum += (face.a == kGround ? 1 : 2) * length(face.p1 - face.p0);
  }
  return sum;
}

void expect_laws(const Scene& scene) {
  const Assembly wall = build(scene);
  FaultList overlaps_found;
  check_overlaps(wall.blocks, overlaps_found);
  EXPECT_TRUE(overlaps_found.empty());
  EXPECT_EQ(wall.report.lost_joints, 0);
  EXPECT_NEAR(total_area(wall), wall.length * wall.height - window_area(scene), 1e-10);
  double boundary = 0;
  for (const Block& block : wall.blocks) boundary += perimeter(block.outline);
  EXPECT_NEAR(touched_boundary(wall) + free_boundary(scene, wall), boundary, 1e-9);
}

long micrometres(double x) { return std::lround(1e6 * x); }

// Head joints (not cracks inside units) of each course.
std::map<int, std::set<long>> heads_by_course(const Assembly& wall) {
  std::map<int, std::set<long>> heads;
  for (const Face& face : wall.faces) {
    if (face.kind != FaceKind::kHead) continue;
    const int course = wall.blocks[face.a].course;
    heads[course].insert(micrometres(face.p0.x));
  }
  return heads;
}

int aligned_heads(const Assembly& wall) {
  int aligned = 0;
  auto heads = heads_by_course(wall);
  for (const auto& [course, joints] : heads) {
    for (long x : joints) aligned += static_cast<int>(heads[course + 1].count(x));
  }
  return aligned;
}

const std::vector<Bond> kBonds = {Bond::kRunning, Bond::kStack, Bond::kFlemish, Bond::kEnglish,
                                  Bond::kHeader};

class EveryBond : public testing::TestWithParam<Bond> {};

TEST_P(EveryBond, fills_a_plain_wall) {
  for (int columns : {7, 12}) expect_laws({.bond = GetParam(), .columns = columns, .window = {}});
}

TEST_P(EveryBond, fills_a_wall_of_whole_units) {
  expect_laws({.bond = GetParam(), .split = Split::kNone, .window = {}});
}

TEST_P(EveryBond, fills_round_a_window_with_lintel) {
  expect_laws({.bond = GetParam(), .window = {4, 2, 5, 3}, .has_lintel = true});
}

TEST_P(EveryBond, fills_round_a_door) {
  expect_laws({.bond = GetParam(), .window = {3, 0, 5, 5}, .has_lintel = true});
}

INSTANTIATE_TEST_SUITE_P(geometry, EveryBond, testing::ValuesIn(kBonds));

TEST(geometry_bond, head_joints_are_staggered_in_every_bond_but_stack) {
  for (Bond bond : {Bond::kRunning, Bond::kFlemish, Bond::kEnglish, Bond::kHeader}) {
    EXPECT_EQ(aligned_heads(build({.bond = bond, .columns = 13, .window = {4, 2, 5, 3}})), 0)
        << "bond " << static_cast<int>(bond);
  }
}

TEST(geometry_bond, stack_aligns_all_head_joints) {
  const Scene scene{.bond = Bond::kStack, .window = {}};
  EXPECT_EQ(aligned_heads(build(scene)), (scene.courses - 1) * (scene.columns / 2 - 1));
}

TEST(geometry_bond, flemish_takes_short_headers) {
  const Scene scene{.bond = Bond::kFlemish, .window = {4, 2, 5, 3}, .header = 0.8 * kColumn};
  expect_laws(scene);
  EXPECT_EQ(aligned_heads(build(scene)), 0);
}

TEST(geometry_bond, flemish_header_stands_in_the_middle_of_the_stretcher_below) {
  // Stretcher over columns 0-2 in course 0; in course 1 a header over columns 0.5-1.5.
  const auto heads = heads_by_course(build({.bond = Bond::kFlemish, .window = {}}));
  EXPECT_TRUE(heads.at(0).count(micrometres(2 * kColumn)));
  EXPECT_TRUE(heads.at(1).count(micrometres(0.5 * kColumn)));
  EXPECT_TRUE(heads.at(1).count(micrometres(1.5 * kColumn)));
}

// Crack planes of each course.
std::map<int, std::set<long>> planes_by_course(const Assembly& wall) {
  std::map<int, std::set<long>> planes;
  for (const Face& face : wall.faces)
    if (face.kind == FaceKind::kSplit)
      planes[wall.blocks[face.a].course].insert(micrometres(face.p0.x));
  return planes;
}

TEST(geometry_bond, planes_at_joints_are_those_in_the_middle_in_running_bond) {
  const Scene at_joints{.split = Split::kAtJoints, .window = {4, 2, 5, 3}};
  const Scene middle{.split = Split::kMiddle, .window = {4, 2, 5, 3}};
  EXPECT_EQ(planes_by_course(build(at_joints)), planes_by_course(build(middle)));
  EXPECT_EQ(build(at_joints).blocks.size(), build(middle).blocks.size());
}

TEST(geometry_bond, planes_at_joints_go_on_where_head_joints_end) {
  for (const Bond bond : {Bond::kFlemish, Bond::kEnglish, Bond::kHeader, Bond::kRunning}) {
    const Assembly wall = build({.bond = bond, .split = Split::kAtJoints, .window = {}});
    const auto planes = planes_by_course(wall);
    auto heads = heads_by_course(wall);
    for (const auto& [course, at] : planes) {
      std::set<long> beside = heads[course + 1];
      beside.merge(heads[course - 1]);
      EXPECT_EQ(at, beside) << "bond " << static_cast<int>(bond) << ", course " << course;
    }
    EXPECT_GE(planes.size(), 8u);
  }
}

TEST(geometry_bond, flemish_cracks_a_quarter_unit_from_the_ends_of_a_stretcher) {
  const auto planes =
      planes_by_course(build({.bond = Bond::kFlemish, .split = Split::kAtJoints, .window = {}}));
  // the stretcher over columns 0-2; above it a header over columns 0.5-1.5
  EXPECT_TRUE(planes.at(0).count(micrometres(0.5 * kColumn)));
  EXPECT_TRUE(planes.at(0).count(micrometres(1.5 * kColumn)));
  EXPECT_FALSE(planes.at(0).count(micrometres(kColumn)));
}

TEST(geometry_bond, stack_has_no_joints_to_be_in_line_with) {
  const Assembly wall = build({.bond = Bond::kStack, .split = Split::kAtJoints, .window = {}});
  EXPECT_TRUE(planes_by_course(wall).empty());
}

RC_GTEST_PROP(geometry_law, running_bond_fills_any_wall_round_any_window, ()) {
  Scene scene;
  scene.columns = *rc::gen::inRange(5, 16);
  scene.courses = *rc::gen::inRange(5, 12);
  scene.window.width = *rc::gen::inRange(1, scene.columns - 3);
  scene.window.x = *rc::gen::inRange(1, scene.columns - scene.window.width);
  scene.window.height = *rc::gen::inRange(1, scene.courses - 2);
  scene.window.y = *rc::gen::inRange(0, scene.courses - scene.window.height - 1);
  scene.has_lintel = *rc::gen::arbitrary<bool>();
  scene.split = *rc::gen::element(Split::kMiddle, Split::kAtJoints, Split::kNone);
  scene.bond = *rc::gen::elementOf(kBonds);
  expect_laws(scene);
  RC_ASSERT(!testing::Test::HasFailure());
}

RC_GTEST_PROP(geometry_law, a_building_of_one_storey_is_the_plain_wall_to_the_bit, ()) {
  Scene scene;
  scene.bond = *rc::gen::elementOf(kBonds);
  scene.split = *rc::gen::element(Split::kMiddle, Split::kAtJoints, Split::kNone);
  scene.columns = *rc::gen::inRange(6, 16);
  scene.courses = *rc::gen::inRange(5, 12);
  scene.window = {2, *rc::gen::inRange(0, 2), 3, 2};
  scene.has_lintel = *rc::gen::arbitrary<bool>();
  const ModelSpec plain = spec_of(scene);
  ModelSpec storey = plain;
  storey.storey.resize(1);
  storey.storey[0].name = "ground";
  storey.storey[0].height = plain.wall.height;
  storey.storey[0].unit.split = scene.split;
  storey.wall.height = *rc::gen::element(plain.wall.height, kUnset);
  if (*rc::gen::arbitrary<bool>()) storey.wall.opening[0].storey = "ground";
  FaultList faults;
  const Assembly a = build_assembly(plain, faults), b = build_assembly(storey, faults);
  RC_ASSERT(faults.empty());
  RC_ASSERT(a.blocks.size() == b.blocks.size());
  RC_ASSERT(a.faces.size() == b.faces.size());
  for (std::size_t i = 0; i < a.blocks.size(); ++i) {
    RC_ASSERT(a.blocks[i].id == b.blocks[i].id);
    RC_ASSERT(a.blocks[i].unit == b.blocks[i].unit);
    for (std::size_t v = 0; v < 4; ++v) {
      RC_ASSERT(a.blocks[i].outline[v].x == b.blocks[i].outline[v].x);
      RC_ASSERT(a.blocks[i].outline[v].y == b.blocks[i].outline[v].y);
    }
  }
  for (std::size_t i = 0; i < a.faces.size(); ++i) {
    RC_ASSERT(a.faces[i].a == b.faces[i].a);
    RC_ASSERT(a.faces[i].b == b.faces[i].b);
    RC_ASSERT(a.faces[i].kind == b.faces[i].kind);
    RC_ASSERT(a.faces[i].material == b.faces[i].material);
    RC_ASSERT(a.faces[i].p0.x == b.faces[i].p0.x);
    RC_ASSERT(a.faces[i].p1.y == b.faces[i].p1.y);
  }
}

// Faces as (kind, centre), `sign` -1 for their mirror images in a wall of this length.
std::multiset<std::tuple<int, long, long>> face_set(const Assembly& wall, bool mirrored) {
  std::multiset<std::tuple<int, long, long>> faces;
  for (const Face& face : wall.faces) {
    const double x = (face.p0.x + face.p1.x) / 2, y = (face.p0.y + face.p1.y) / 2;
    faces.emplace(static_cast<int>(face.kind), micrometres(mirrored ? wall.length - x : x),
                  micrometres(y));
  }
  return faces;
}

TEST(geometry_mirror, a_mirrored_opening_mirrors_the_wall_of_whole_units) {
  // An even number of half units: every course is its own mirror image.
  const Assembly left = build({.columns = 14, .window = {2, 1, 4, 4}, .has_lintel = true});
  const Assembly right = build({.columns = 14, .window = {8, 1, 4, 4}, .has_lintel = true});
  EXPECT_EQ(face_set(left, true), face_set(right, false));
}

TEST(geometry_mirror, odd_walls_mirror_into_the_next_courses_pattern) {
  // An odd number of half units: course c mirrored is course c + 1, so blocks mirror, units don't.
  const Assembly wall = build({.columns = 13, .window = {}});
  const auto heads = heads_by_course(wall);
  std::set<long> mirrored;
  for (long x : heads.at(0)) mirrored.insert(micrometres(wall.length) - x);
  EXPECT_EQ(mirrored, heads.at(1));
}

TEST(geometry_size, twenty_thousand_blocks_make_every_face_once) {
  const int columns = 200, courses = 100;
  const Assembly wall = build({.columns = columns, .courses = courses, .window = {}});
  EXPECT_EQ(wall.blocks.size(), 20000U);
  EXPECT_EQ(wall.faces.size(),
            static_cast<std::size_t>(columns * courses + (columns - 1) * courses));
}

TEST(geometry_determinism, the_same_spec_gives_the_same_faces) {
  const Scene scene{.bond = Bond::kFlemish, .window = {4, 2, 5, 3}, .has_lintel = true};
  const Assembly first = build(scene), second = build(scene);
  ASSERT_EQ(first.faces.size(), second.faces.size());
  for (std::size_t i = 0; i < first.faces.size(); ++i) {
    EXPECT_EQ(first.faces[i].p0.x, second.faces[i].p0.x);
    EXPECT_EQ(first.faces[i].b, second.faces[i].b);
  }
}

}  // namespace
}  // namespace wythe::geometry::geometry_property_test
