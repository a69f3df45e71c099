// Claims about the wall's geometry: the paper's grid, openings, lintels, caps, blocks files, faults.
// The laws of bonds (no overlap, full contact, staggered joints) are in tests/property.
#include "geometry/assembly.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "geometry/polygon.h"

namespace wythe::geometry::geometry_test {
namespace {

// The paper's wall (examples/tuff_wall).
ModelSpec papers_wall() {
  ModelSpec spec;
  spec.wall.length = 5.10;
  spec.wall.height = 3.62;
  spec.wall.thickness = 0.31;
  spec.wall.unit = {.length = 0.31, .height = 0.11, .density = 1250};
  LintelSpec lintel{.kind = "timber", .depth = 0.11, .bearing = 0.15, .material = "timber"};
  spec.wall.opening = {
      {.name = "door", .x = 1.70, .y = 0, .width = 1.70, .height = 2.64, .lintel = lintel}};
  for (const char* name : {"joint", "unit", "foundation", "timber"}) spec.material[name] = {};
  spec.material["timber"].density = 500;
  return spec;
}

// A plain wall of whole courses and half units: `columns` x `courses` of 0.1 m x 0.1 m.
ModelSpec plain_wall(int columns, int courses) {
  ModelSpec spec;
  spec.wall.length = 0.1 * columns;
  spec.wall.height = 0.1 * courses;
  spec.wall.thickness = 0.1;
  spec.wall.unit = {.length = 0.2, .height = 0.1, .density = 1800};
  for (const char* name : {"joint", "unit", "foundation"}) spec.material[name] = {};
  return spec;
}

StageSpec plate_load(const std::string& name, double newtons) {
  return {.name = name, .action = LoadStage{.pier_load = newtons, .as = Manner::kPlate}};
}

OpeningSpec hole(double x, double y, double width, double height) {
  OpeningSpec opening;
  opening.x = x;
  opening.y = y;
  opening.width = width;
  opening.height = height;
  return opening;
}

Assembly build(const ModelSpec& spec) {
  FaultList faults;
  Assembly assembly = build_assembly(spec, faults);
  for (const Fault& fault : faults.all()) {
    ADD_FAILURE() << fault.path << " = " << fault.value << ": " << fault.problem;
  }
  return assembly;
}

std::vector<Fault> faults_of(const ModelSpec& spec) {
  FaultList faults;
  (void)build_assembly(spec, faults);
  return faults.all();
}

// The fault at `path`; an empty one where there is none.
Fault fault_at(const ModelSpec& spec, const std::string& path) {
  for (const Fault& fault : faults_of(spec)) {
    if (fault.path == path) return fault;
  }
  return {};
}

bool mentions(const std::string& text, const std::string& word) {
  return text.find(word) != std::string::npos;
}

bool notes_mention(const Assembly& assembly, const std::string& word) {
  const auto& notes = assembly.report.notes;
  return std::any_of(notes.begin(), notes.end(),
                     [&](const Message& n) { return mentions(text_of(n), word); });
}

int count(const Assembly& assembly, Role role) {
  return static_cast<int>(std::count_if(assembly.blocks.begin(), assembly.blocks.end(),
                                        [&](const Block& b) { return b.role == role; }));
}

int count(const Assembly& assembly, FaceKind kind) {
  return static_cast<int>(std::count_if(assembly.faces.begin(), assembly.faces.end(),
                                        [&](const Face& f) { return f.kind == kind; }));
}

double face_length(const Face& face) { return length(face.p1 - face.p0); }

BlockSpec block(const std::string& id, std::vector<std::array<double, 2>> polygon,
                bool fixed = false) {
  BlockSpec spec;
  spec.id = id;
  spec.polygon = std::move(polygon);
  spec.fixed = fixed;
  return spec;
}

BlockSpec box(const std::string& id, double x0, double y0, double x1, double y1,
              bool fixed = false) {
  return block(id, {{x0, y0}, {x1, y0}, {x1, y1}, {x0, y1}}, fixed);
}

ModelSpec blocks_wall(std::vector<BlockSpec> blocks) {
  ModelSpec spec;
  spec.wall.blocks = "blocks.json";
  spec.wall.thickness = 1;
  spec.wall.unit.density = 2000;
  spec.block = std::move(blocks);
  spec.material["joint"] = {};
  return spec;
}

// Courses in block lengths, negative is opening; blocks of 0.4 m x 0.175 m (Ferris and Tin-Loi 2001).
ModelSpec ferris_wall(const std::vector<std::vector<double>>& courses) {
  std::vector<BlockSpec> blocks;
  for (std::size_t row = 0; row < courses.size(); ++row) {
    double x = 0;
    const double y = 0.175 * static_cast<double>(row);
    for (double share : courses[row]) {
      const double end = x + 0.4 * std::abs(share);
      if (share > 0) blocks.push_back(box(std::to_string(blocks.size()), x, y, end, y + 0.175));
      x = end;
    }
  }
  return blocks_wall(blocks);
}

const std::vector<double> kClosers = {0.5, 1, 1, 1, 1, 0.5};
const std::vector<double> kWhole = {1, 1, 1, 1, 1};

TEST(geometry_polygon, moments_of_a_rectangle_are_textbook) {
  const PolygonMoments m = moments({{10, 20}, {13, 20}, {13, 22}, {10, 22}});
  EXPECT_DOUBLE_EQ(m.area, 6);
  EXPECT_DOUBLE_EQ(m.centroid.x, 11.5);
  EXPECT_DOUBLE_EQ(m.centroid.y, 21);
  EXPECT_NEAR(m.polar, 6 * (9 + 4) / 12.0, 1e-12);
}

TEST(geometry_polygon, clockwise_outlines_have_negative_area) {
  EXPECT_DOUBLE_EQ(moments({{0, 0}, {0, 2}, {1, 2}, {1, 0}}).area, -2);
}

TEST(geometry_polygon, polar_moment_of_an_l_shape_is_the_sum_of_its_parts) {
  // 2 x 1 and 1 x 1 rectangles about their own centroids, moved to the common one (5/6, 5/6).
  const PolygonMoments m = moments({{0, 0}, {2, 0}, {2, 1}, {1, 1}, {1, 2}, {0, 2}});
  const double parts = 2 * 5 / 12.0 + 2 / 12.0;
  const double moved = 2 * (1 / 36.0 + 4 / 36.0) + (1 / 9.0 + 4 / 9.0);
  EXPECT_NEAR(m.centroid.x, 5 / 6.0, 1e-14);
  EXPECT_NEAR(m.polar, parts + moved, 1e-12);
}

TEST(geometry_polygon, overlap_of_a_notched_block_leaves_the_notch_out) {
  const Polygon u = {{0, 0}, {3, 0}, {3, 2}, {2, 2}, {2, 1}, {1, 1}, {1, 2}, {0, 2}};
  EXPECT_NEAR(overlap_area(u, {{1, 1}, {2, 1}, {2, 2}, {1, 2}}), 0, 1e-15);
  EXPECT_NEAR(overlap_area(u, {{0.5, 0.5}, {2.5, 0.5}, {2.5, 1.5}, {0.5, 1.5}}), 1.5, 1e-12);
}

TEST(geometry_papers_wall, has_825_masonry_blocks) {
  const Assembly wall = build(papers_wall());
  EXPECT_EQ(wall.report.masonry_blocks_before_lintels, 825);
  EXPECT_EQ(count(wall, Role::kMasonry), 812);
  EXPECT_EQ(count(wall, Role::kLintel), 13);
}

TEST(geometry_papers_wall, is_a_grid_of_33_by_33) {
  const Assembly wall = build(papers_wall());
  EXPECT_EQ(wall.report.courses, 33);
  EXPECT_DOUBLE_EQ(wall.report.half_unit, 5.10 / 33);
  EXPECT_DOUBLE_EQ(wall.report.course, 3.62 / 33);
  EXPECT_TRUE(notes_mention(wall, "half unit 155 mm -> 154.545 mm (-0.3 %)"));
}

TEST(geometry_papers_wall, has_two_piers_as_high_as_the_opening) {
  const Assembly wall = build(papers_wall());
  ASSERT_EQ(wall.piers.size(), 2U);
  EXPECT_NEAR(wall.piers[0].x1, 1.70, 1e-12);
  EXPECT_NEAR(wall.piers[1].x0, 3.40, 1e-12);
  EXPECT_NEAR(wall.piers[0].height, 24 * 3.62 / 33, 1e-12);
}

TEST(geometry_papers_wall, has_a_spandrel_of_nine_courses) {
  int spandrel = 0;
  for (const Block& b : build(papers_wall()).blocks) {
    spandrel += b.course >= 24 && std::abs(moments(b.outline).centroid.x - 2.55) < 0.01;
  }
  EXPECT_EQ(spandrel, 8);  // one block a course above the lintel course
}

TEST(geometry_papers_wall, every_face_is_a_whole_side_of_both_blocks) {
  for (const Face& face : build(papers_wall()).faces) {
    const bool is_bed_length = std::abs(face_length(face) - 5.10 / 33) < 1e-12;
    const bool is_head_length = std::abs(face_length(face) - 3.62 / 33) < 1e-12;
    EXPECT_TRUE(is_bed_length || is_head_length);
  }
}

TEST(geometry_papers_wall, joints_of_each_kind_are_counted_by_hand) {
  const Assembly wall = build(papers_wall());
  // Bed faces: 32 bed planes x 33 columns - 11 x 24 under the lintel or in the opening,
  // of which 13 on the lintel and 2 under its ends belong to the bond.
  EXPECT_EQ(count(wall, FaceKind::kBed), 32 * 33 - 11 * 24 - 13 - 2);
  EXPECT_EQ(count(wall, FaceKind::kFoundation), 22);
  EXPECT_EQ(count(wall, FaceKind::kLintelChain), 12);
  EXPECT_EQ(count(wall, FaceKind::kLintelBond), 13 + 2 + 2);
  // Upright faces: 24 courses x 2 piers x 10, 8 x 32 above, 2 x 9 beside the lintel.
  EXPECT_EQ(count(wall, FaceKind::kHead) + count(wall, FaceKind::kSplit), 480 + 256 + 18);
}

TEST(geometry_papers_wall, materials_follow_the_kind_of_joint) {
  for (const Face& face : build(papers_wall()).faces) {
    if (face.kind == FaceKind::kSplit) {
      EXPECT_EQ(face.material, "unit");
    }
    if (face.kind == FaceKind::kFoundation) {
      EXPECT_EQ(face.material, "foundation");
    }
    if (face.kind == FaceKind::kLintelChain) {
      EXPECT_EQ(face.material, "timber");
    }
    if (face.kind == FaceKind::kLintelBond) {
      EXPECT_EQ(face.material, "joint");
    }
  }
}

TEST(geometry_faces, normal_on_the_left_points_from_a_to_b) {
  const Assembly wall = build(papers_wall());
  for (const Face& face : wall.faces) {
    const Vec2 t = face.p1 - face.p0;
    const Vec2 b = moments(wall.blocks[face.b].outline).centroid;
    EXPECT_GT(cross(t, b - face.p0), 0);
    if (face.a == kGround) continue;
    const Vec2 a = moments(wall.blocks[face.a].outline).centroid;
    EXPECT_LT(cross(t, a - face.p0), 0);
  }
}

TEST(geometry_faces, side_a_is_the_lower_or_the_left_block) {
  for (const Face& face : build(papers_wall()).faces) {
    const Vec2 t = face.p1 - face.p0;  // +x below b, -y on the left of b
    EXPECT_TRUE(t.x > 1e-9 || (std::abs(t.x) < 1e-9 && t.y < 0));
  }
}

TEST(geometry_faces, run_from_the_bottom_up) {
  double height = -1;
  for (const Face& face : build(papers_wall()).faces) {
    const double centre = (face.p0.y + face.p1.y) / 2;
    EXPECT_GE(centre, height - 1e-5);  // equal heights within the contact tolerance
    height = centre;
  }
}

TEST(geometry_blocks, of_a_generated_wall_have_unique_ids) {
  std::vector<std::string> ids;
  for (const Block& b : build(papers_wall()).blocks) ids.push_back(b.id);
  std::sort(ids.begin(), ids.end());
  EXPECT_EQ(std::adjacent_find(ids.begin(), ids.end()), ids.end());
  EXPECT_EQ(ids.front(), "c00u00a");
}

TEST(geometry_split, none_lays_whole_units_and_needs_no_unit_material) {
  ModelSpec spec = plain_wall(8, 2);
  spec.wall.unit.split = Split::kNone;
  spec.material.erase("unit");
  const Assembly wall = build(spec);
  EXPECT_EQ(wall.blocks.size(), 4U + 5U);
  EXPECT_EQ(count(wall, FaceKind::kSplit), 0);
}

TEST(geometry_split, middle_without_unit_material_names_both_ways_out) {
  ModelSpec spec = papers_wall();
  spec.material.erase("unit");
  const Fault fault = fault_at(spec, "material.unit");
  EXPECT_TRUE(mentions(fault.problem, "wall.unit.split"));
  EXPECT_TRUE(mentions(fault.cure, "\"none\""));
}

TEST(geometry_fit, refuses_units_that_would_change_by_more_than_two_percent) {
  ModelSpec spec = plain_wall(10, 10);
  spec.wall.length = 1.05;
  const Fault fault = fault_at(spec, "wall.unit.length");
  EXPECT_EQ(fault.value, "200 mm");
  EXPECT_TRUE(mentions(fault.cure, "write length = \"190.909 mm\" (or 210 mm)")) << fault.cure;
  EXPECT_TRUE(mentions(fault.cure, "1 m or 1.1 m")) << fault.cure;
}

TEST(geometry_fit, cut_lays_nominal_units_and_cuts_the_last) {
  ModelSpec spec = plain_wall(10, 10);
  spec.wall.fit = Fit::kCut;
  spec.wall.length = 1.05;
  spec.wall.height = 1.02;  // a rest of 20 mm is joined to the course below
  const Assembly wall = build(spec);
  EXPECT_EQ(wall.report.courses, 10);
  EXPECT_EQ(wall.blocks.size(), 110U);
  double area = 0;
  for (const Block& b : wall.blocks) area += moments(b.outline).area;
  EXPECT_NEAR(area, 1.05 * 1.02, 1e-12);
  EXPECT_TRUE(notes_mention(wall, "last half unit"));
}

TEST(geometry_fit, cut_openings_cut_units_and_bricks) {
  ModelSpec spec = plain_wall(20, 10);
  spec.wall.fit = Fit::kCut;
  spec.wall.opening = {hole(0.74, 0.33, 0.5, 0.42)};
  const Assembly wall = build(spec);
  double area = 0;
  for (const Block& b : wall.blocks) area += moments(b.outline).area;
  EXPECT_NEAR(area, 2.0 - 0.5 * 0.42, 1e-12);
  EXPECT_EQ(wall.report.lost_joints, 0);
}

TEST(geometry_openings, off_the_grid_are_refused_with_the_sizes_that_fit) {
  ModelSpec spec = plain_wall(20, 10);
  spec.wall.opening = {hole(0.54, 0, 0.6, 0.5)};
  const Fault fault = fault_at(spec, "wall.opening.0.x");
  EXPECT_EQ(fault.value, "0.54 m");
  EXPECT_TRUE(mentions(fault.cure, "write x = \"0.5 m\", on")) << fault.cure;
}

TEST(geometry_openings, outside_the_wall_are_refused) {
  ModelSpec spec = plain_wall(20, 10);
  spec.wall.opening = {hole(0.5, 0, 6, 0.5)};
  const Fault fault = fault_at(spec, "wall.opening.0.width");
  EXPECT_EQ(fault.value, "6 m");
  EXPECT_TRUE(mentions(fault.problem, "outside the wall"));
}

// The cure keeps what is stated as far as it goes: units are cut anywhere.
TEST(geometry_openings, outside_a_wall_of_cut_units_are_to_end_at_its_edge) {
  ModelSpec spec = plain_wall(20, 10);  // 2 m
  spec.wall.fit = Fit::kCut;
  spec.wall.opening = {hole(1.53, 0, 2, 0.5)};
  EXPECT_EQ(fault_at(spec, "wall.opening.0.width").cure, "write width = \"0.47 m\"");
}

// Of an opening far to the right the place is wrong, not the width.
TEST(geometry_openings, that_begin_beyond_the_wall_are_to_move) {
  ModelSpec spec = plain_wall(20, 10);  // 2 m
  spec.wall.opening = {hole(25, 0, 0.5, 0.5)};
  EXPECT_EQ(fault_at(spec, "wall.opening.0.x").value, "25 m");
  EXPECT_TRUE(mentions(fault_at(spec, "wall.opening.0.x").cure, "write x = \"1.5 m\""));
}

TEST(geometry_openings, that_overlap_are_refused) {
  ModelSpec spec = plain_wall(20, 10);
  spec.wall.opening = {hole(0.5, 0, 0.5, 0.5), hole(0.8, 0.2, 0.5, 0.5)};
  const Fault fault = fault_at(spec, "wall.opening.1.x");
  EXPECT_TRUE(mentions(fault.problem, "overlaps opening 0"));
  EXPECT_EQ(fault.value, "0.8 m");  // as stated, not where it would be laid
}

TEST(geometry_openings, without_numbers_are_missing_one_fault_each) {
  ModelSpec spec = plain_wall(20, 10);
  spec.wall.opening = {OpeningSpec{}};
  EXPECT_EQ(faults_of(spec).size(), 4U);
  EXPECT_EQ(fault_at(spec, "wall.opening.0.height").problem, "missing");
}

TEST(geometry_openings, without_lintel_are_noted) {
  ModelSpec spec = plain_wall(20, 10);
  spec.wall.opening = {hole(0.5, 0.2, 0.5, 0.4)};
  EXPECT_TRUE(notes_mention(build(spec), "no lintel"));
}

TEST(geometry_openings, from_end_to_end_leave_blocks_without_support) {
  ModelSpec spec = plain_wall(10, 10);
  spec.wall.opening = {hole(0, 0.4, 1, 0.2)};
  const Fault fault = fault_at(spec, "wall");
  EXPECT_TRUE(mentions(fault.problem, "no support"));
  EXPECT_EQ(fault.value, "40 blocks");
}

TEST(geometry_piers, take_the_lower_of_two_adjacent_openings) {
  ModelSpec spec = plain_wall(30, 10);
  spec.wall.opening = {hole(0.5, 0, 0.5, 0.8), hole(1.5, 0.3, 0.5, 0.3)};
  const Assembly wall = build(spec);
  ASSERT_EQ(wall.piers.size(), 3U);
  EXPECT_NEAR(wall.piers[0].height, 0.8, 1e-12);
  EXPECT_NEAR(wall.piers[1].height, 0.6, 1e-12);
  EXPECT_NEAR(wall.piers[2].x1, 3.0, 1e-12);
}

TEST(geometry_piers, of_a_wall_without_openings_are_the_whole_wall) {
  const Assembly wall = build(plain_wall(10, 5));
  ASSERT_EQ(wall.piers.size(), 1U);
  EXPECT_DOUBLE_EQ(wall.piers[0].height, 0.5);
}

TEST(geometry_lintel, reaching_outside_the_wall_is_refused) {
  ModelSpec spec = papers_wall();
  spec.wall.opening[0].lintel.bearing = 3;
  EXPECT_TRUE(
      mentions(fault_at(spec, "wall.opening.0.lintel.bearing").problem, "outside the wall"));
}

TEST(geometry_lintel, deeper_than_the_spandrel_is_refused) {
  ModelSpec spec = papers_wall();
  spec.wall.opening[0].lintel.depth = 1.5;
  EXPECT_TRUE(mentions(fault_at(spec, "wall.opening.0.lintel.depth").problem, "deeper"));
}

TEST(geometry_lintel, two_courses_deep_stays_one_chain) {
  ModelSpec spec = papers_wall();
  spec.wall.opening[0].lintel.depth = 0.22;
  const Assembly wall = build(spec);
  EXPECT_EQ(count(wall, Role::kLintel), 13);
  EXPECT_EQ(count(wall, Role::kMasonry), 825 - 26);
  EXPECT_EQ(count(wall, FaceKind::kLintelBond), 13 + 2 + 4);
}

TEST(geometry_lintel, without_bearing_or_density_is_refused) {
  ModelSpec spec = papers_wall();
  spec.wall.opening[0].lintel.bearing = 0;
  spec.material["timber"].density = kUnset;
  EXPECT_EQ(fault_at(spec, "wall.opening.0.lintel.bearing").problem, "must be positive");
  EXPECT_EQ(fault_at(spec, "material.timber.density").problem, "missing");
}

TEST(geometry_lintel, reaching_into_the_next_opening_is_refused) {
  ModelSpec spec = plain_wall(30, 10);
  spec.material["timber"].density = 500;
  spec.wall.opening = {hole(0.5, 0, 0.5, 0.5), hole(1.1, 0, 0.5, 0.8)};
  spec.wall.opening[0].lintel = {
      .kind = "timber", .depth = 0.1, .bearing = 0.2, .material = "timber"};
  EXPECT_TRUE(mentions(fault_at(spec, "wall.opening.0.lintel.bearing").problem, "opening 1"));
}

TEST(geometry_foundation, falls_back_to_the_joint_with_a_note) {
  ModelSpec spec = plain_wall(10, 5);
  spec.material.erase("foundation");
  const Assembly wall = build(spec);
  EXPECT_EQ(wall.faces.front().kind, FaceKind::kFoundation);
  EXPECT_EQ(wall.faces.front().material, "joint");
  EXPECT_TRUE(notes_mention(wall, "[material.foundation]"));
}

TEST(geometry_caps, plates_cover_each_pier_exactly) {
  ModelSpec spec = papers_wall();
  spec.stage = {plate_load("precompression", 200e3)};
  const Assembly wall = build(spec);
  EXPECT_EQ(count(wall, Role::kPlate), 2);
  EXPECT_EQ(count(wall, FaceKind::kPlate), 22);
  const Rect plate = bounds(wall.blocks.back().outline);
  EXPECT_NEAR(plate.x1 - plate.x0, 1.70, 1e-12);
  EXPECT_NEAR(plate.y1 - plate.y0, 3.62 / 66, 1e-12);
}

TEST(geometry_caps, beam_covers_the_whole_top) {
  ModelSpec spec = plain_wall(10, 5);
  spec.wall.beam.height = 0.2;
  const Assembly wall = build(spec);
  EXPECT_EQ(count(wall, Role::kBeam), 1);
  EXPECT_EQ(count(wall, FaceKind::kBeam), 10);
  EXPECT_EQ(density_of(spec, wall.blocks.back()), 0);
}

TEST(geometry_caps, plate_and_beam_together_are_refused) {
  ModelSpec spec = plain_wall(10, 5);
  spec.wall.beam.height = 0.2;
  spec.stage = {plate_load("load", 1e3)};
  EXPECT_TRUE(mentions(fault_at(spec, "stage.load.as").problem, "beam"));
}

TEST(geometry_missing_numbers, are_all_reported_at_once) {
  const std::vector<Fault> faults = faults_of(ModelSpec{});
  for (const char* path : {"wall.length", "wall.height", "wall.thickness", "wall.unit.length",
                           "wall.unit.height", "wall.unit.density", "material.joint"}) {
    EXPECT_TRUE(std::any_of(faults.begin(), faults.end(), [&](const Fault& f) {
      return f.path == path;
    })) << path;
  }
}

TEST(geometry_missing_numbers, negative_and_infinite_sizes_are_refused) {
  ModelSpec spec = plain_wall(10, 5);
  spec.wall.length = -1;
  spec.wall.height = kUnlimited;
  EXPECT_EQ(fault_at(spec, "wall.length").problem, "must be positive");
  EXPECT_EQ(fault_at(spec, "wall.height").problem, "must be finite");
}

TEST(geometry_blocks_file, ferris_tinloi_wall_1_has_33_blocks_and_83_interfaces) {
  const Assembly wall = build(ferris_wall({kClosers, kWhole, kClosers, kWhole, kClosers, kWhole}));
  EXPECT_EQ(wall.blocks.size(), 33U);
  EXPECT_EQ(wall.faces.size(), 83U);
  EXPECT_EQ(wall.report.courses, 6);
}

TEST(geometry_blocks_file, ferris_tinloi_wall_2_has_55_blocks_and_141_interfaces) {
  const Assembly wall = build(ferris_wall(
      {kClosers, kWhole, kClosers, kWhole, kClosers, kWhole, kClosers, kWhole, kClosers, kWhole}));
  EXPECT_EQ(wall.blocks.size(), 55U);
  EXPECT_EQ(wall.faces.size(), 141U);
}

TEST(geometry_blocks_file, ferris_tinloi_wall_4_with_windows_has_55_blocks_and_116_interfaces) {
  const std::vector<double> wide = {1, -1, 1, -1, 1};
  const std::vector<double> halves = {0.5, 0.5, -1, 0.5, 0.5, -1, 0.5, 0.5};
  const Assembly wall = build(ferris_wall(
      {kClosers, kWhole, kClosers, wide, halves, wide, halves, wide, kClosers, kWhole, kClosers}));
  EXPECT_EQ(wall.blocks.size(), 55U);
  EXPECT_EQ(wall.faces.size(), 116U);
}

TEST(geometry_blocks_file, turns_clockwise_outlines_round) {
  const Assembly wall = build(blocks_wall({block("a", {{0, 0}, {0, 1}, {1, 1}, {1, 0}})}));
  EXPECT_DOUBLE_EQ(moments(wall.blocks[0].outline).area, 1);
  EXPECT_EQ(wall.faces.size(), 1U);
}

TEST(geometry_blocks_file, fixed_blocks_are_the_ground) {
  const Assembly wall = build(blocks_wall({box("base", -1, -1, 3, 0, true), box("a", 0, 0, 1, 1)}));
  ASSERT_EQ(wall.faces.size(), 1U);
  EXPECT_EQ(wall.faces[0].a, kGround);
  EXPECT_EQ(wall.faces[0].b, 1);
  EXPECT_GT(wall.faces[0].p1.x, wall.faces[0].p0.x);
  EXPECT_EQ(count(wall, Role::kSupport), 1);
}

TEST(geometry_blocks_file, a_support_above_keeps_its_side_a) {
  const Assembly wall = build(blocks_wall({box("a", 0, 0, 1, 1), box("roof", 0, 1, 1, 2, true)}));
  ASSERT_EQ(wall.faces.size(), 1U);
  EXPECT_EQ(wall.faces[0].a, kGround);
  EXPECT_LT(wall.faces[0].p1.x, wall.faces[0].p0.x);  // block below: its side is the left of -x
}

TEST(geometry_blocks_file, without_fixed_blocks_stands_on_its_lowest_line) {
  const Assembly wall = build(blocks_wall({box("a", 0, 5, 1, 6)}));
  EXPECT_EQ(wall.faces.size(), 1U);
  EXPECT_TRUE(notes_mention(wall, "y = 5 m"));
}

TEST(geometry_blocks_file, contact_rules_name_the_joint) {
  ModelSpec spec = blocks_wall({box("a", 0, 0, 1, 1), box("b", 0, 1, 1, 2)});
  spec.block[1].material = "stone";
  spec.contact = {{{"stone", "masonry"}, "lime"}, {{"masonry", "ground"}, "rock"}};
  spec.material["lime"] = {};
  spec.material["rock"] = {};
  const Assembly wall = build(spec);
  EXPECT_EQ(wall.faces[0].material, "rock");
  EXPECT_EQ(wall.faces[1].material, "lime");
}

TEST(geometry_blocks_file, materials_with_a_density_bring_their_own) {
  ModelSpec spec = blocks_wall({box("a", 0, 0, 1, 1), box("b", 0, 1, 1, 2)});
  spec.block[1].material = "stone";
  spec.material["stone"].density = 2700;
  const Assembly wall = build(spec);
  EXPECT_EQ(density_of(spec, wall.blocks[0]), 2000);
  EXPECT_EQ(density_of(spec, wall.blocks[1]), 2700);
}

TEST(geometry_blocks_file, overlaps_name_both_blocks_and_the_area) {
  const Fault fault =
      fault_at(blocks_wall({box("a", 0, 0, 1, 1), box("b", 0.5, 0.5, 1.5, 1.5)}), "wall.blocks.b");
  EXPECT_EQ(fault.problem, "blocks \"a\" and \"b\" overlap by 0.25 m^2");
}

TEST(geometry_blocks_file, bad_outlines_and_repeated_ids_are_all_reported) {
  const ModelSpec spec = blocks_wall(
      {block("bow", {{0, 0}, {1, 1}, {1, 0}, {0, 1.5}}), block("line", {{0, 0}, {1, 1}}),
       box("twin", 3, 0, 4, 1), box("twin", 4, 0, 5, 1), block("flat", {{0, 0}, {1, 0}, {2, 0}})});
  EXPECT_TRUE(mentions(fault_at(spec, "wall.blocks.bow").problem, "crosses"));
  EXPECT_TRUE(mentions(fault_at(spec, "wall.blocks.line").problem, "at least 3"));
  EXPECT_TRUE(mentions(fault_at(spec, "wall.blocks.twin").problem, "two blocks"));
  EXPECT_TRUE(mentions(fault_at(spec, "wall.blocks.flat").problem, "no area"));
}

TEST(geometry_blocks_file, floating_blocks_have_no_support) {
  const Fault fault = fault_at(blocks_wall({box("a", 0, 0, 1, 1), box("b", 0, 2, 1, 3)}), "wall");
  EXPECT_EQ(fault.problem, "no support: blocks b are not connected to the ground");
}

TEST(geometry_blocks_file, short_overlaps_and_gaps_are_lost_with_a_note) {
  const Assembly wall = build(
      blocks_wall({box("a", 0, 0, 1, 1), box("b", 1.002, 0, 2, 1), box("c", 0.5, 1, 1.0025, 2)}));
  EXPECT_EQ(wall.report.lost_joints, 2);
  EXPECT_TRUE(notes_mention(wall, "stand apart by up to 2 mm"));
  EXPECT_TRUE(notes_mention(wall, "share only 0.5 mm"));
}

TEST(geometry_blocks_file, inclined_faces_of_an_arch_meet) {
  // Three voussoirs between two abutments; all joints radial.
  const auto at = [](double radius, double turn) {
    return std::array<double, 2>{radius * std::cos(turn), radius * std::sin(turn)};
  };
  std::vector<BlockSpec> blocks;
  const double step = std::acos(-1.0) / 5;
  for (int i = 0; i < 5; ++i) {
    const double from = step * i, to = step * (i + 1);
    blocks.push_back(block("v" + std::to_string(i),
                           {at(1, from), at(1.2, from), at(1.2, to), at(1, to)}, i == 0 || i == 4));
  }
  const Assembly arch = build(blocks_wall(blocks));
  ASSERT_EQ(arch.faces.size(), 4U);
  for (const Face& face : arch.faces) EXPECT_NEAR(face_length(face), 0.2, 1e-12);
  EXPECT_EQ(arch.blocks[2].course, -1);
}

}  // namespace
}  // namespace wythe::geometry::geometry_test
