// Bodies in space: mass properties, joint faces, and refusals.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <ctime>
#include <string>

#include "geometry/bodies/body_checks.h"
#include "geometry/bodies/joint_faces.h"
#include "scenes/solids.h"
#include "wythe/parts/message.h"

namespace wythe::geometry::bodies_test {
namespace {

using scenes::body_of;
using scenes::box_body;
using scenes::box_part;
using scenes::Frame;
using scenes::prism_part;

bool has(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

std::string said(const FaultList& faults) {
  std::string all;
  for (const Fault& fault : faults.all()) all += to_string(fault) + "\n";
  return all;
}

SpaceAssembly assembled(const std::vector<BodySpec>& bodies) {
  FaultList faults;
  SpaceAssembly assembly = assemble(bodies, faults);
  EXPECT_TRUE(faults.empty()) << said(faults);
  return assembly;
}

std::string refusal(const std::vector<BodySpec>& bodies) {
  FaultList faults;
  (void)assemble(bodies, faults);
  return said(faults);
}

bool notes(const SpaceAssembly& assembly, const std::string& code) {
  return std::any_of(assembly.notes.begin(), assembly.notes.end(),
                     [&](const Message& note) { return note.code == code; });
}

void expect_inertia(const SolidMoments& m, const std::array<double, 6>& wanted, double tolerance) {
  for (std::size_t i = 0; i < 6; ++i) EXPECT_NEAR(m.inertia[i], wanted[i], tolerance) << i;
}

// --- moments: closed forms; tolerances are round-off of a few dozen terms

TEST(SolidMoments, a_box_has_m_over_12_of_its_sides) {
  const SolidMoments m = solid_moments(box_body("b", {1, 2, 3}, {1.4, 2.5, 3.3}));
  const double a = 0.4, b = 0.5, c = 0.3, v = a * b * c;
  EXPECT_NEAR(m.volume, v, 1e-16);
  EXPECT_NEAR(m.centroid.x, 1.2, 1e-14);
  EXPECT_NEAR(m.centroid.y, 2.25, 1e-14);
  EXPECT_NEAR(m.centroid.z, 3.15, 1e-14);
  expect_inertia(
      m, {v * (b * b + c * c) / 12, v * (a * a + c * c) / 12, v * (a * a + b * b) / 12, 0, 0, 0},
      1e-17);
}

TEST(SolidMoments, a_corner_tetrahedron_has_its_products) {
  const double a = 0.7, b = 0.4, c = 1.1, v = a * b * c / 6;
  Polyhedron part{{{0, 0, 0}, {a, 0, 0}, {0, b, 0}, {0, 0, c}},
                  {{0, 2, 1}, {0, 1, 3}, {0, 3, 2}, {1, 2, 3}}};
  const SolidMoments m = solid_moments(part);
  EXPECT_NEAR(m.volume, v, 1e-16);
  EXPECT_NEAR(m.centroid.x, a / 4, 1e-15);
  // int x^2 = 3 V a^2 / 80 and int x y = -V a b / 80 about the centroid
  expect_inertia(m,
                 {3 * v * (b * b + c * c) / 80, 3 * v * (a * a + c * c) / 80,
                  3 * v * (a * a + b * b) / 80, v * a * b / 80, v * a * c / 80, v * b * c / 80},
                 1e-16);
}

TEST(SolidMoments, a_right_prism_has_those_of_its_triangle) {
  const double a = 0.6, h = 0.9, d = 0.5, v = a * h * d / 2;
  const SolidMoments m =
      solid_moments(body_of("p", prism_part({{0, 0}, {a, 0}, {0, h}}, -1, -0.5)));
  EXPECT_NEAR(m.volume, v, 1e-16);
  EXPECT_NEAR(m.centroid.x, a / 3, 1e-15);
  EXPECT_NEAR(m.centroid.z, -0.75, 1e-15);
  const double xx = v * a * a / 18, yy = v * h * h / 18, zz = v * d * d / 12, xy = -v * a * h / 36;
  expect_inertia(m, {yy + zz, xx + zz, xx + yy, -xy, 0, 0}, 1e-16);
}

TEST(SolidMoments, a_frame_of_four_parts_is_the_whole_less_the_hole) {
  BodySpec frame;
  frame.part = {box_part({0, 0, 0}, {1, 0.2, 0.3}), box_part({0, 0.8, 0}, {1, 1, 0.3}),
                box_part({0, 0.2, 0}, {0.2, 0.8, 0.3}), box_part({0.8, 0.2, 0}, {1, 0.8, 0.3})};
  const SolidMoments m = solid_moments(frame);
  const SolidMoments whole = solid_moments(box_part({0, 0, 0}, {1, 1, 0.3})),
                     hole = solid_moments(box_part({0.2, 0.2, 0}, {0.8, 0.8, 0.3}));
  EXPECT_NEAR(m.volume, whole.volume - hole.volume, 1e-15);
  for (std::size_t i = 0; i < 6; ++i)
    EXPECT_NEAR(m.inertia[i], whole.inertia[i] - hole.inertia[i], 1e-15);
}

TEST(SolidMoments, keep_their_digits_a_kilometre_away) {
  const BodySpec here = box_body("b", {0, 0, 0}, {0.25, 0.0625, 0.125});
  const BodySpec there = Frame{.shift = {1024, -2048, 512}}.body(here);
  const SolidMoments a = solid_moments(here), b = solid_moments(there);
  EXPECT_EQ(a.volume, b.volume);
  EXPECT_EQ(a.inertia, b.inertia);
}

// --- joint faces

constexpr double kRay = 0.3;  // half a cube's side, as in LMGC90's tests of contact detection

std::vector<BodySpec> cube_and(BodySpec above) {
  return {box_body("below", {-kRay, -kRay, -kRay}, {kRay, kRay, kRay}, true), std::move(above)};
}

// Corners of the polygon in x, y, from the least x and y on.
std::vector<Vec2> corners_of(const JointFace& face) {
  std::vector<Vec2> corners;
  for (const Vec3 p : face.polygon) corners.push_back({p.x, p.y});
  const auto first = std::min_element(corners.begin(), corners.end(), [](Vec2 a, Vec2 b) {
    return std::abs(a.x - b.x) > 1e-9 ? a.x < b.x : a.y < b.y;
  });
  std::rotate(corners.begin(), first, corners.end());
  return corners;
}

void expect_corners(const JointFace& face, const std::vector<Vec2>& wanted, double tolerance) {
  const std::vector<Vec2> corners = corners_of(face);
  ASSERT_EQ(corners.size(), wanted.size());
  for (std::size_t i = 0; i < wanted.size(); ++i) {
    EXPECT_NEAR(corners[i].x, wanted[i].x, tolerance) << i;
    EXPECT_NEAR(corners[i].y, wanted[i].y, tolerance) << i;
  }
}

TEST(JointFaces, two_equal_cubes_share_a_square) {
  const auto a =
      assembled(cube_and(box_body("above", {-kRay, -kRay, kRay}, {kRay, kRay, 3 * kRay})));
  ASSERT_EQ(a.faces.size(), 1U);
  const JointFace& face = a.faces[0];
  expect_corners(face, {{-0.3, -0.3}, {0.3, -0.3}, {0.3, 0.3}, {-0.3, 0.3}}, 1e-12);
  EXPECT_NEAR(face.area, 0.36, 1e-12);
  EXPECT_EQ(face.a, 0);
  EXPECT_EQ(face.b, 1);
  EXPECT_NEAR(face.normal.z, 1, 1e-15);
  EXPECT_NEAR(face.centre.z, kRay, 1e-15);
  EXPECT_EQ(a.outer.size(), 10U);
  EXPECT_EQ(a.lost_faces, 0);
}

TEST(JointFaces, a_cube_half_beside_shares_a_smaller_square) {
  const double s = kRay / 2;
  const auto a = assembled(
      cube_and(box_body("above", {-kRay - s, -kRay - s, kRay}, {kRay - s, kRay - s, 3 * kRay})));
  ASSERT_EQ(a.faces.size(), 1U);
  expect_corners(a.faces[0], {{-0.3, -0.3}, {0.15, -0.3}, {0.15, 0.15}, {-0.3, 0.15}}, 1e-12);
  double free = 0;
  for (const OuterFace& outer : a.outer) free += outer.area;
  EXPECT_NEAR(free, 12 * 0.36 - 2 * a.faces[0].area, 1e-12);
}

// Turned by one radian about its own vertical axis, then moved by an eighth: LMGC90's corners, given to 1e-5.
TEST(JointFaces, a_turned_cube_shares_an_octagon) {
  BodySpec above = box_body("above", {-kRay, -kRay, -kRay}, {kRay, kRay, kRay});
  above = Frame::turned(std::cos(0.5), 0, 0, std::sin(0.5), {-kRay / 8, -kRay / 8, 2 * kRay})
              .body(above);
  const auto a = assembled(cube_and(above));
  ASSERT_EQ(a.faces.size(), 1U);
  expect_corners(a.faces[0],
                 {{-0.3, -0.22547},
                  {-0.18393, -0.3},
                  {0.15047, -0.3},
                  {0.3, -0.06712},
                  {0.3, 0.10231},
                  {-0.00788, 0.3},
                  {-0.17731, 0.3},
                  {-0.3, 0.10893}},
                 6e-6);
}

// A U of one surface, not convex: cut into parts that move as one, and its two arms stand on the cube.
TEST(JointFaces, a_u_stands_on_its_arms) {
  const double r = kRay, h = kRay / 3;
  BodySpec u = body_of(
      "u",
      prism_part({{-r, -r}, {r, -r}, {r, r}, {h, r}, {h, -h}, {-h, -h}, {-h, r}, {-r, r}}, -r, r));
  u = Frame{.shift = {0, -r, 2 * r}}.body(u);
  const auto a = assembled(cube_and(u));
  EXPECT_TRUE(notes(a, "space.bodies_cut"));
  EXPECT_GE(a.body[1].part.size(), 3U);
  EXPECT_NEAR(a.moments[1].volume, 2 * r * (4 * r * r - 2 * h * (r + h)), 1e-12);
  ASSERT_EQ(a.faces.size(), 2U);
  for (const JointFace& face : a.faces) {
    EXPECT_EQ(face.polygon.size(), 4U);
    EXPECT_NEAR(face.area, (r - h) * r, 1e-12);
  }
}

TEST(JointFaces, a_face_in_triangles_gives_one_joint) {
  Polyhedron part = box_part({-kRay, -kRay, kRay}, {kRay, kRay, 3 * kRay});
  std::vector<std::vector<std::int32_t>> triangles;
  for (const auto& f : part.face) {
    triangles.push_back({f[0], f[1], f[2]});
    triangles.push_back({f[0], f[2], f[3]});
  }
  part.face = triangles;
  const auto a = assembled(cube_and(body_of("above", part)));
  ASSERT_EQ(a.faces.size(), 1U);
  EXPECT_EQ(a.faces[0].polygon.size(), 4U);
  EXPECT_EQ(a.body[1].part[0].face.size(), 6U);
  EXPECT_NEAR(a.faces[0].area, 0.36, 1e-12);
}

TEST(JointFaces, parts_of_one_body_make_no_joint_and_their_pieces_are_one) {
  BodySpec slab;
  slab.id = "slab";
  slab.part = {box_part({-0.3, -0.3, 0.3}, {0, 0.3, 0.5}),
               box_part({0, -0.3, 0.3}, {0.3, 0.3, 0.5})};
  const auto a = assembled(cube_and(slab));
  ASSERT_EQ(a.faces.size(), 1U);
  EXPECT_EQ(a.faces[0].polygon.size(), 4U);
  EXPECT_NEAR(a.faces[0].area, 0.36, 1e-12);
  double free = 0;  // the inner faces are not free
  for (const OuterFace& outer : a.outer)
    if (outer.body == 1) free += outer.area;
  EXPECT_NEAR(free, 0.36 + 4 * 0.6 * 0.2, 1e-12);
}

TEST(JointFaces, a_fixed_body_is_always_the_first) {
  std::vector<BodySpec> bodies = {box_body("free", {0, 1, 0}, {1, 2, 1}),
                                  box_body("ground", {0, 0, 0}, {1, 1, 1}, true)};
  const auto a = assembled(bodies);
  ASSERT_EQ(a.faces.size(), 1U);
  EXPECT_EQ(a.faces[0].a, 1);
  EXPECT_EQ(a.faces[0].normal.y, 1);
}

TEST(JointFaces, two_fixed_bodies_have_none) {
  const auto a = assembled(
      {box_body("a", {0, 0, 0}, {1, 1, 1}, true), box_body("b", {0, 1, 0}, {1, 2, 1}, true)});
  EXPECT_TRUE(a.faces.empty());
  EXPECT_EQ(a.outer.size(), 10U);
}

TEST(JointFaces, edges_and_corners_that_meet_make_none) {
  FaultList faults;
  const auto a =
      assemble({box_body("a", {0, 0, 0}, {1, 1, 1}), box_body("edge", {1, 1, 0}, {2, 2, 1}),
                box_body("corner", {1, 1, 1}, {2, 2, 2})},
               faults);
  ASSERT_EQ(a.faces.size(), 1U);  // edge below corner
  EXPECT_EQ(a.lost_faces, 0);
  EXPECT_TRUE(notes(a, "space.none_fixed"));
}

TEST(JointFaces, nearly_touching_ones_are_lost_and_counted) {
  const auto near = assembled(
      {box_body("a", {0, 0, 0}, {1, 1, 1}, true), box_body("b", {0, 1.005, 0}, {1, 2, 1}, true)});
  EXPECT_EQ(near.lost_faces, 0);  // between two supports nothing is lost
  FaultList faults;
  const auto lost = assemble(
      {box_body("a", {0, 0, 0}, {1, 1, 1}, true), box_body("b", {0, 1.005, 0}, {1, 2, 1})}, faults);
  EXPECT_EQ(lost.lost_faces, 1);
  EXPECT_TRUE(notes(lost, "space.faces_lost"));
  EXPECT_TRUE(has(said(faults), "touches no other body")) << said(faults);
  // three decimals of a file still meet
  const auto rounded = assembled(
      {box_body("a", {0, 0, 0}, {1, 1, 1}, true), box_body("b", {0, 1.0005, 0}, {1, 2, 1})});
  EXPECT_EQ(rounded.faces.size(), 1U);
}

TEST(JointFaces, warped_neighbours_share_the_mean_plane) {
  Polyhedron below = box_part({0, 0, 0}, {1, 1, 1}), above = box_part({0, 1, 0}, {1, 2, 1});
  for (Polyhedron* part : {&below, &above})
    for (Vec3& v : part->vertex)
      if (v.y == 1 && v.x == v.z) v.y = 1.004;
  const auto a = assembled({body_of("below", below, true), body_of("above", above)});
  ASSERT_EQ(a.faces.size(), 1U);
  EXPECT_NEAR(a.faces[0].normal.y, 1, 1e-12);
  EXPECT_NEAR(a.faces[0].centre.y, 1.002, 1e-12);
  EXPECT_TRUE(notes(a, "space.faces_flattened"));
  // what one gains the other loses
  EXPECT_NEAR(a.moments[0].volume + a.moments[1].volume, 2, 1e-14);
}

TEST(JointFaces, of_5000_bodies_are_all_found) {
  std::vector<BodySpec> bodies;
  for (int x = 0; x < 25; ++x)
    for (int y = 0; y < 50; ++y)
      for (int z = 0; z < 4; ++z) {
        const double s = y % 2 == 0 ? 0 : 0.125;
        bodies.push_back(box_body("b" + std::to_string(bodies.size()),
                                  {0.25 * x + s, 0.1 * y, 0.125 * z},
                                  {0.25 * x + s + 0.25, 0.1 * y + 0.1, 0.125 * z + 0.125}, y == 0));
      }
  ASSERT_EQ(bodies.size(), 5000U);
  const std::clock_t start = std::clock();  // of the processor, not the wall's
  const auto a = assembled(bodies);
  const double took = static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC;
  // bed joints 2 under each brick but one at an end, head joints and collar joints but between supports
  EXPECT_EQ(a.faces.size(), 49U * 4 * 49 + 49U * 4 * 24 + 49U * 3 * 25);
  EXPECT_EQ(a.lost_faces, 0);
  RecordProperty("seconds", std::to_string(took));
}

// --- what is refused: named, located, cured

std::vector<BodySpec> with(BodySpec body) {
  return {box_body("ground", {0, -1, 0}, {1, 0, 1}, true), std::move(body)};
}

TEST(BadBodies, an_open_one_names_the_edge) {
  BodySpec body = box_body("stone", {0, 0, 0}, {1, 1, 1});
  body.part[0].face.pop_back();
  const std::string said = refusal(with(body));
  EXPECT_TRUE(has(said, "wall.blocks.stone")) << said;
  EXPECT_TRUE(has(said, "is open")) << said;
  EXPECT_TRUE(has(said, "(0, 0, 0)")) << said;
}

TEST(BadBodies, an_inverted_one_is_turned_with_a_note) {
  BodySpec body = box_body("stone", {0, 0, 0}, {1, 1, 1});
  for (auto& face : body.part[0].face) std::reverse(face.begin(), face.end());
  const auto all = assembled(with(body));
  EXPECT_TRUE(notes(all, "space.bodies_turned"));
  EXPECT_NEAR(all.moments[1].volume, 1, 1e-14);
  body = box_body("stone", {0, 0, 0}, {1, 1, 1});
  std::reverse(body.part[0].face[2].begin(), body.part[0].face[2].end());
  const auto one = assembled(with(body));
  EXPECT_TRUE(notes(one, "space.bodies_turned"));
  EXPECT_NEAR(one.moments[1].volume, 1, 1e-14);
}

TEST(BadBodies, one_that_runs_through_itself_names_the_edge) {
  // an hourglass: the upper square is turned by half a turn against the lower one and pulled through it
  BodySpec body = body_of(
      "stone", prism_part({{0, 0}, {2, 0}, {2, 2}, {1.8, 2}, {1, -0.5}, {0.2, 2}, {0, 2}}, 0, 1));
  const std::string said = refusal(with(body));
  EXPECT_TRUE(has(said, "runs through itself")) << said;
}

TEST(BadBodies, a_hollow_is_no_solid) {
  BodySpec body = box_body("stone", {0, 0, 0}, {1, 1, 1});
  Polyhedron hole = box_part({0.3, 0.3, 0.3}, {0.7, 0.7, 0.7});
  for (auto& face : hole.face) std::reverse(face.begin(), face.end());
  const std::int32_t first = 8;
  for (const auto& face : hole.face) {
    body.part[0].face.push_back({});
    for (const std::int32_t i : face) body.part[0].face.back().push_back(i + first);
  }
  for (const Vec3 v : hole.vertex) body.part[0].vertex.push_back(v);
  const std::string turned_in = refusal(with(body));
  EXPECT_TRUE(has(turned_in, "hollow")) << turned_in;
  for (std::size_t f = 6; f < 12; ++f)
    std::reverse(body.part[0].face[f].begin(), body.part[0].face[f].end());
  const std::string turned_out = refusal(with(body));
  EXPECT_TRUE(has(turned_out, "lie in each other")) << turned_out;
}

TEST(BadBodies, overlapping_and_doubled_ones_are_told_apart) {
  const BodySpec stone = box_body("stone", {0, 0, 0}, {1, 1, 1});
  const std::string deep = refusal({box_body("ground", {0, -1, 0}, {1, 0.03, 1}, true), stone});
  EXPECT_TRUE(has(deep, "30 mm deep")) << deep;
  BodySpec again = stone;
  again.id = "again";
  const std::string twice =
      refusal({box_body("ground", {0, -1, 0}, {1, 0, 1}, true), stone, again});
  EXPECT_TRUE(has(twice, "is the same body as stone")) << twice;
}

TEST(BadBodies, tiny_and_flat_ones_are_named) {
  std::vector<BodySpec> bodies = with(box_body("stone", {0, 0, 0}, {1, 1, 1}));
  bodies.push_back(box_body("crumb", {1, 0, 0}, {1.0005, 0.0005, 0.0005}));
  bodies.push_back(box_body("sheet", {0, 1, 0}, {1, 1.0005, 1}));
  const std::string said = refusal(bodies);
  EXPECT_TRUE(has(said, "wall.blocks.crumb")) << said;
  EXPECT_TRUE(has(said, "is tiny")) << said;
  EXPECT_TRUE(has(said, "wall.blocks.sheet")) << said;
  EXPECT_TRUE(has(said, "is flat")) << said;
  BodySpec leaf = box_body("leaf", {0, 0, 0}, {1, 0, 1});
  const std::string none = refusal(with(leaf));
  EXPECT_TRUE(has(none, "encloses no volume")) << none;
}

TEST(BadBodies, floating_ones_are_named_together) {
  std::vector<BodySpec> bodies = with(box_body("stone", {0, 0, 0}, {1, 1, 1}));
  bodies.push_back(box_body("kite", {0, 5, 0}, {1, 6, 1}));
  bodies.push_back(box_body("low", {3, 5, 0}, {4, 6, 1}));
  bodies.push_back(box_body("high", {3, 6, 0}, {4, 7, 1}));
  const std::string said = refusal(bodies);
  EXPECT_TRUE(has(said, "wall.blocks.kite: touches no other body")) << said;
  EXPECT_TRUE(has(said, "low, high")) << said;
  EXPECT_FALSE(has(said, "stone")) << said;
}

TEST(BadBodies, numbers_that_are_none_and_corners_that_are_not_there) {
  BodySpec nan = box_body("nan", {0, 0, 0}, {1, 1, 1}),
           index = box_body("index", {0, 0, 2}, {1, 1, 3});
  nan.part[0].vertex[3].y = std::nan("");
  index.part[0].face[2][1] = 99;
  BodySpec empty;
  empty.id = "empty";
  const std::string said = refusal({nan, index, empty, nan});
  EXPECT_TRUE(has(said, "no finite number")) << said;
  EXPECT_TRUE(has(said, "a corner that is not there")) << said;
  EXPECT_TRUE(has(said, "has no part")) << said;
  EXPECT_TRUE(has(said, "two bodies have this id")) << said;
}

TEST(BadBodies, depth_is_that_of_the_nearest_way_out) {
  EXPECT_NEAR(depth_of(box_part({0, 0, 0}, {1, 1, 1}), box_part({0.9, 0.2, 0.3}, {2, 3, 4})), 0.1,
              1e-12);
  EXPECT_LT(depth_of(box_part({0, 0, 0}, {1, 1, 1}), box_part({1.1, 0, 0}, {2, 1, 1})), 0);
  // edge against edge: only the cross product of the two edges parts them
  const Frame diamond = Frame::turned(std::cos(M_PI / 8), std::sin(M_PI / 8), 0, 0);
  const Frame across = Frame::turned(std::cos(M_PI / 8), 0, std::sin(M_PI / 8), 0,
                                     {0, 0, 2 * std::sqrt(0.5) + 0.01});
  const BodySpec a = diamond.body(box_body("a", {-2, -0.5, -0.5}, {2, 0.5, 0.5}));
  const BodySpec b = across.body(box_body("b", {-0.5, -2, -0.5}, {0.5, 2, 0.5}));
  EXPECT_NEAR(depth_of(a.part[0], b.part[0]), -0.01, 1e-12);
}

}  // namespace
}  // namespace wythe::geometry::bodies_test
