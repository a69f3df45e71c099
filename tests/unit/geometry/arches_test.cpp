// Claims about arches over openings: voussoirs, the masonry cut to them, and refusals.
#include "geometry/wall/arches.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "geometry/assembly.h"
#include "geometry/polygon.h"
#include "geometry/wall/joints.h"
#include "scenes/scenes.h"

namespace wythe::geometry::arches_test {
namespace {

using scenes::degrees;

// 3 m x 2.6 m of units 0.2 m x 0.1 m, with an opening of 1.2 m in its middle.
ModelSpec wall_with(const ArchSpec& arch) {
  ModelSpec spec;
  spec.wall.length = 3;
  spec.wall.height = 2.6;
  spec.wall.thickness = 0.2;
  spec.wall.unit = {.length = 0.2, .height = 0.1, .density = 1800};
  OpeningSpec opening;
  opening.x = 0.9;
  opening.y = 0;
  opening.width = 1.2;
  opening.height = 1.2;
  opening.arch = arch;
  spec.wall.opening = {opening};
  for (const char* name : {"joint", "unit", "foundation"}) spec.material[name] = {};
  return spec;
}

ArchSpec flat() {
  return {.kind = ArchKind::kFlat, .depth = 0.3, .skewback = degrees(15), .voussoirs = 11};
}
ArchSpec segmental() {
  return {.kind = ArchKind::kSegmental, .rise = 0.2, .depth = 0.25, .voussoirs = 13};
}
ArchSpec round_arch() { return {.kind = ArchKind::kRound, .depth = 0.25, .voussoirs = 17}; }

Assembly build(const ModelSpec& spec) {
  FaultList faults;
  Assembly assembly = build_assembly(spec, faults);
  for (const Fault& fault : faults.all())
    ADD_FAILURE() << fault.path << " = " << fault.value << ": " << fault.problem;
  return assembly;
}

double area_of(const Assembly& wall, bool voussoirs) {
  double area = 0;
  for (const Block& block : wall.blocks)
    if (is_voussoir(block) == voussoirs) area += moments(block.outline).area;
  return area;
}

std::string problem_at(const ModelSpec& spec, const std::string& path) {
  FaultList faults;
  (void)build_assembly(spec, faults);
  std::string others;
  for (const Fault& fault : faults.all()) {
    if (fault.path == path) return fault.problem;
    others += " " + fault.path + ": " + fault.problem;
  }
  return "no fault there, but" + others;
}

// Half the angle that a segmental or round arch of this span and rise opens over, and its radius.
struct Ring {
  double half_angle, radius;
};
Ring ring_of(double span, double rise) {
  const double radius = (span * span / 4 + rise * rise) / (2 * rise);
  return {std::asin(std::min(1.0, span / 2 / radius)), radius};
}

// n voussoirs between polygons on two circles: n trapezoids.
double area_of_ring(const Ring& ring, double depth, int n) {
  const double outer = ring.radius + depth;
  return n / 2.0 * std::sin(2 * ring.half_angle / n) * (outer * outer - ring.radius * ring.radius);
}

TEST(Arches, voussoirs_have_the_area_of_their_polygon) {
  const Assembly flat_wall = build(wall_with(flat()));
  const double wider = 1.2 + 0.3 * std::tan(degrees(15));  // in the middle of the depth
  EXPECT_NEAR(area_of(flat_wall, true), 0.3 * wider, 1e-12);
  EXPECT_NEAR(area_of(build(wall_with(segmental())), true),
              area_of_ring(ring_of(1.2, 0.2), 0.25, 13), 1e-12);
  EXPECT_NEAR(area_of(build(wall_with(round_arch())), true),
              area_of_ring(ring_of(1.2, 0.6), 0.25, 17), 1e-12);
}

// The wall weighs what a solid one does, less the opening up to the springing, less what the intrados leaves free.
TEST(Arches, masonry_and_voussoirs_leave_the_opening_alone_free) {
  const auto free_below = [](const Ring& ring, int n) {
    const double r = ring.radius, a = ring.half_angle;
    return n / 2.0 * std::sin(2 * a / n) * r * r - r * r * std::sin(a) * std::cos(a);
  };
  const std::pair<ArchSpec, double> arches[] = {{flat(), 0},
                                                {segmental(), free_below(ring_of(1.2, 0.2), 13)},
                                                {round_arch(), free_below(ring_of(1.2, 0.6), 17)}};
  for (const auto& [arch, below] : arches) {
    const Assembly wall = build(wall_with(arch));
    const double solid = 3 * 2.6 - 1.2 * 1.2 - below;
    EXPECT_NEAR(area_of(wall, true) + area_of(wall, false), solid, 1e-8);
  }
}

double shared_with(const Assembly& wall, int block, Vec2 from, Vec2 to) {
  double shared = 0;
  for (const Face& face : wall.faces) {
    if (face.a != block && face.b != block) continue;
    const auto on_line = [&](Vec2 p) {
      return std::abs(cross(to - from, p - from)) / length(to - from) < 1e-7;
    };
    if (on_line(face.p0) && on_line(face.p1)) shared += length(face.p1 - face.p0);
  }
  return shared;
}

TEST(Arches, every_voussoir_touches_its_neighbours_all_along) {
  for (const ArchSpec& arch : {flat(), segmental(), round_arch()}) {
    const Assembly wall = build(wall_with(arch));
    EXPECT_EQ(wall.report.lost_joints, 0);
    int voussoirs = 0;
    for (std::size_t b = 0; b < wall.blocks.size(); ++b) {
      const Polygon& outline = wall.blocks[b].outline;
      if (!is_voussoir(wall.blocks[b])) continue;
      ++voussoirs;
      ASSERT_EQ(outline.size(), 4U);
      // 0 to 1 is the intrados; then the right joint, the extrados and the left joint
      for (std::size_t k = 1; k < 4; ++k) {
        const Vec2 from = outline[k], to = outline[(k + 1) % 4];
        EXPECT_NEAR(shared_with(wall, static_cast<int>(b), from, to), length(to - from), 1e-6)
            << wall.blocks[b].id << " side " << k;
      }
      EXPECT_EQ(shared_with(wall, static_cast<int>(b), outline[0], outline[1]), 0);
    }
    EXPECT_EQ(voussoirs, arch.voussoirs);
  }
}

TEST(Arches, blocks_overlap_nowhere_and_none_is_a_sliver) {
  for (const ArchSpec& arch : {flat(), segmental(), round_arch()}) {
    const Assembly wall = build(wall_with(arch));
    for (const auto& [i, j] : near_pairs(wall.blocks, 0))
      EXPECT_LT(overlap_area(wall.blocks[i].outline, wall.blocks[j].outline), 1e-9);
    for (const Block& block : wall.blocks) {
      EXPECT_TRUE(is_simple(block.outline)) << block.id;
      if (is_voussoir(block)) continue;
      EXPECT_GT(moments(block.outline).area, 0.249 * 0.1 * 0.1) << block.id;
    }
  }
}

// Running bond over whole units mirrors itself, so the cut wall does.
TEST(Arches, a_wall_that_mirrors_itself_is_cut_so_that_it_still_does) {
  for (const ArchSpec& arch : {flat(), segmental(), round_arch()}) {
    const Assembly wall = build(wall_with(arch));
    for (const Block& block : wall.blocks) {
      const PolygonMoments m = moments(block.outline);
      const bool has_twin =
          std::any_of(wall.blocks.begin(), wall.blocks.end(), [&](const Block& b) {
            const PolygonMoments o = moments(b.outline);
            return std::abs(o.centroid.x + m.centroid.x - 3) < 1e-7 &&
                   std::abs(o.centroid.y - m.centroid.y) < 1e-7 && std::abs(o.area - m.area) < 1e-8;
          });
      EXPECT_TRUE(has_twin) << block.id << " at " << m.centroid.x << ", " << m.centroid.y;
    }
  }
}

TEST(Arches, ids_are_unique_and_blocks_know_storey_course_and_thickness) {
  const Assembly wall = build(wall_with(round_arch()));
  std::map<std::string, int> seen;
  for (const Block& block : wall.blocks) {
    EXPECT_EQ(++seen[block.id], 1) << block.id;
    EXPECT_EQ(block.thickness, 0.2);
    EXPECT_GE(block.course, 0) << block.id;
  }
  EXPECT_EQ(seen.count("arch0_16"), 1U);
}

TEST(Arches, radial_joints_are_head_joints_of_the_arch_and_the_rest_is_the_masonry_s) {
  ArchSpec arch = round_arch();
  arch.joint = "lime";
  arch.material = "tuff";
  ModelSpec spec = wall_with(arch);
  spec.material["lime"] = {};
  spec.material["tuff"].density = 1400;
  const Assembly wall = build(spec);
  int radial = 0;
  for (const Face& face : wall.faces) {
    if (face.a < 0) continue;
    const bool a = is_voussoir(wall.blocks[face.a]);
    const bool b = is_voussoir(wall.blocks[face.b]);
    EXPECT_EQ(face.material == "lime", a && b);
    EXPECT_TRUE(!(a && b) || face.kind == FaceKind::kHead);
    radial += a && b;
  }
  EXPECT_EQ(radial, 16);
  for (const Block& block : wall.blocks)
    EXPECT_EQ(density_of(spec, block), is_voussoir(block) ? 1400 : 1800);
}

TEST(Arches, without_a_number_voussoirs_are_bricks_on_edge_with_a_keystone) {
  ArchSpec arch = segmental();
  arch.voussoirs = 0;
  const Assembly wall = build(wall_with(arch));
  const auto n = std::count_if(wall.blocks.begin(), wall.blocks.end(), is_voussoir);
  EXPECT_EQ(n, 13);  // 1.287 m of intrados by 0.1 m
  EXPECT_TRUE(std::any_of(wall.report.notes.begin(), wall.report.notes.end(),
                          [](const Message& note) { return note.code == "arch.laid"; }));
}

TEST(Arches, the_key_of_a_shape_knows_the_arch) {
  const ModelSpec plain = wall_with(segmental());
  ArchSpec other = segmental();
  other.rise = 0.21;
  const ModelSpec changed = wall_with(other);
  EXPECT_NE(shape_key(Shape(plain)), shape_key(Shape(changed)));
}

TEST(Arches, keys_that_do_not_go_together_are_refused) {
  const auto problem = [](ArchSpec arch, const char* key) {
    return problem_at(wall_with(arch), std::string("wall.opening.0.arch") + key);
  };
  ArchSpec arch = segmental();
  arch.rise = 0;
  EXPECT_NE(problem(arch, ".rise").find("positive"), std::string::npos);
  arch.rise = kUnset;
  EXPECT_NE(problem(arch, ".rise").find("missing"), std::string::npos);
  arch.rise = 0.7;
  EXPECT_NE(problem(arch, ".rise").find("more than half its span"), std::string::npos);
  arch = round_arch();
  arch.rise = 0.6;
  EXPECT_NE(problem(arch, ".rise").find("half its span"), std::string::npos);
  arch = flat();
  arch.rise = 0.1;
  EXPECT_NE(problem(arch, ".rise").find("level"), std::string::npos);
  arch = flat();
  arch.skewback = kUnset;
  EXPECT_NE(problem(arch, ".skewback").find("missing"), std::string::npos);
  arch = segmental();
  arch.skewback = 0.1;
  EXPECT_NE(problem(arch, ".skewback").find("centre"), std::string::npos);
  arch = segmental();
  arch.depth = kUnset;
  EXPECT_NE(problem(arch, ".depth").find("missing"), std::string::npos);
  arch = segmental();
  arch.voussoirs = 1;
  EXPECT_NE(problem(arch, ".voussoirs").find("two voussoirs"), std::string::npos);
  arch.voussoirs = 10'000'000;
  EXPECT_NE(problem(arch, ".voussoirs").find("thinner"), std::string::npos);
  arch = segmental();
  arch.material = "tuff";
  EXPECT_NE(problem(arch, ".material").find("no such material"), std::string::npos);
}

TEST(Arches, an_arch_needs_room_in_its_storey_and_masonry_beside_it) {
  ModelSpec spec = wall_with(round_arch());
  spec.wall.height = 2;
  EXPECT_NE(problem_at(spec, "wall.opening.0.arch.depth").find("above the wall's top"),
            std::string::npos);
  spec = wall_with(round_arch());
  spec.storey.resize(2);
  spec.storey[0].name = "ground";
  spec.storey[0].height = 1.9;
  spec.storey[1].name = "first";
  spec.storey[1].height = 0.7;
  spec.wall.height = kUnset;
  EXPECT_NE(problem_at(spec, "wall.opening.0.arch.depth").find("storey 0 (ground)"),
            std::string::npos);
  spec = wall_with(round_arch());
  spec.wall.opening[0].x = 0.2;
  EXPECT_NE(problem_at(spec, "wall.opening.0.arch").find("takes its thrust"), std::string::npos);
}

TEST(Arches, neighbours_and_lintels_are_not_run_into) {
  ModelSpec spec = wall_with(round_arch());
  spec.wall.opening[0].x = 0.4;
  spec.wall.opening[0].width = 0.8;
  spec.wall.opening.push_back(spec.wall.opening[0]);
  spec.wall.opening[1].x = 1.6;  // 0.4 m of pier for two arches of 0.25 m
  EXPECT_NE(problem_at(spec, "wall.opening.0.arch").find("overlap"), std::string::npos);
  spec.wall.opening[1].x = 1.8;
  (void)build(spec);
  spec.wall.opening[1].x = 1.3;
  spec.wall.opening[1].y = 0.5;
  spec.wall.opening[1].arch = {};
  EXPECT_NE(problem_at(spec, "wall.opening.0.arch").find("opening 1"), std::string::npos);
  spec = wall_with(round_arch());
  spec.wall.opening[0].lintel = {
      .kind = "timber", .depth = 0.1, .bearing = 0.1, .material = "joint"};
  EXPECT_NE(problem_at(spec, "wall.opening.0.arch").find("lintel and an arch"), std::string::npos);
}

}  // namespace
}  // namespace wythe::geometry::arches_test
