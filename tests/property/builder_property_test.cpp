// The builder in space against closed forms: volumes, areas of beds and joints, mirrored and turned
// plans, connections between wythes, and refusals. Tolerances are round-off of coordinates in metres.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <map>
#include <set>

#include "geometry/bodies/joint_faces.h"
#include "geometry/builder/builder.h"

namespace wythe::geometry::builder_property_test {
namespace {

using Points = std::vector<std::array<double, 2>>;
constexpr double kUnit = 0.3, kCourse = 0.1, kThick = 0.15;

PlanWallSpec wall(const std::string& name, Points line, double height = 1.2) {
  PlanWallSpec spec;
  spec.name = name;
  spec.line = std::move(line);
  spec.height = height;
  spec.thickness = kThick;
  spec.unit.length = kUnit;
  spec.unit.height = kCourse;
  spec.unit.split = Split::kNone;
  return spec;
}

BuilderSpec plan(std::vector<PlanWallSpec> walls) {
  BuilderSpec spec;
  spec.plan_wall = std::move(walls);
  return spec;
}

struct Built {
  SpaceAssembly assembly;
  std::vector<BuiltBody> body;
  FaultList faults;
  std::vector<Message> notes;
  double volume = 0;  // of what moves
  double level = 0;   // area of level joint faces
  double all = 0;
};

Built build(const BuilderSpec& spec, double moduli = kUnset) {
  ModelSpec model;
  model.wall.unit.density = 2000;
  model.material["timber"].density = 600;
  model.material["timber"].youngs_modulus = model.material["timber"].shear_modulus = moduli;
  Built b;
  b.body = build_bodies({spec, model}, b.notes, b.faults);
  if (!b.faults.empty()) return b;
  std::vector<BodySpec> bodies;
  for (const BuiltBody& built : b.body) bodies.push_back(built.body);
  b.assembly = assemble(bodies, b.faults);
  for (std::size_t k = 0; k < b.assembly.body.size() && k < b.assembly.moments.size(); ++k)
    if (!b.assembly.body[k].fixed) b.volume += b.assembly.moments[k].volume;
  for (const JointFace& face : b.assembly.faces) {
    b.all += face.area;
    if (std::fabs(face.normal.y) > 0.99) b.level += face.area;
  }
  return b;
}

std::string told(const FaultList& faults) {
  std::string text;
  for (const Fault& fault : faults.all()) text += to_string(fault) + "\n";
  return text;
}

// Walls of `area` in plan, all of one height: no block is lost, doubled or without its bed.
void expect_whole(const BuilderSpec& spec, double area, double height, const std::string& what) {
  const Built b = build(spec);
  EXPECT_TRUE(b.faults.empty()) << what << '\n' << told(b.faults);
  EXPECT_NEAR(b.volume, area * height, 1e-9) << what;
  EXPECT_NEAR(b.level, area * std::round(height / kCourse), 1e-9) << what;
  EXPECT_EQ(b.assembly.lost_faces, 0) << what;
}

TEST(Builder, a_straight_wall_fills_its_volume_and_every_bed_finds_its_partner) {
  expect_whole(plan({wall("a", {{0, 0}, {3, 0}})}), 3 * kThick, 1.2, "straight");
  expect_whole(plan({wall("a", {{1, 2}, {2.8, 4.4}})}), 3 * kThick, 1.2, "at an angle");
}

TEST(Builder, corners_and_rings_fill_their_volume_toothed_and_butted) {
  for (const Meeting meets : {Meeting::kToothed, Meeting::kButted}) {
    PlanWallSpec a = wall("a", {{0, 0}, {2.025, 0}}), b = wall("b", {{0, 0}, {0, 1.425}});
    a.meets = b.meets = meets;
    expect_whole(plan({a, b}), (2.1 + 1.35) * kThick, 1.2, "corner");
    PlanWallSpec ring = wall("r", {{0, 0}, {2.85, 0}, {2.85, 2.25}, {0, 2.25}, {0, 0}});
    ring.meets = meets;
    expect_whole(plan({ring}), 2 * (2.85 + 2.25) * kThick, 1.2, "ring");
  }
}

TEST(Builder, a_wall_that_ends_on_another_fills_its_volume_wherever_it_stands) {
  for (const double x : {1.05, 1.125, 1.2, 1.29, 1.5})
    for (const Meeting meets : {Meeting::kToothed, Meeting::kButted}) {
      PlanWallSpec a = wall("a", {{0, 0}, {3, 0}}), b = wall("b", {{x, 0}, {x, 1.425}});
      a.meets = meets;
      expect_whole(plan({a, b}), (3 + 1.35) * kThick, 1.2, "tee at " + std::to_string(x));
    }
}

// A wall that stands against another at an angle is cut by its face: its axis ends there, and its end is T/sin long. The
// one that goes through reaches beyond the corner until that end is covered.
TEST(Builder, butted_walls_at_an_angle_are_cut_by_the_face_they_stand_against) {
  for (const double degrees : {50.0, 75.0, 90.0, 110.0, 135.0})
    for (const double turned : {0.0, 0.4})
      for (const bool tee : {false, true}) {
        const double angle = degrees * M_PI / 180, s = std::sin(angle), c = std::cos(angle);
        const auto at = [&](double x, double y) {
          return std::array<double, 2>{std::cos(turned) * x - std::sin(turned) * y,
                                       std::sin(turned) * x + std::cos(turned) * y};
        };
        const double from = tee ? 1.5 : 0;  // where b begins on a; at a corner a's first point
        PlanWallSpec a = wall("a", {at(0, 0), at(3, 0)}),
                     b = wall("b", {at(from, 0), at(from + 1.425 * c, 1.425 * s)});
        b.thickness = 0.2, a.meets = Meeting::kButted, a.fit = b.fit = "cut";
        const Built built = build(plan({a, b}));
        const std::string what = std::to_string(degrees) + (tee ? " tee" : " corner");
        ASSERT_TRUE(built.faults.empty()) << what << told(built.faults);
        const double reach = tee ? 0 : std::max(0.0, (0.2 - kThick * c) / (2 * s));
        EXPECT_NEAR(built.volume, 1.2 * ((3 + reach) * kThick + (1.425 - kThick / (2 * s)) * 0.2),
                    1e-9)
            << what;
        double shared = 0;
        for (const JointFace& face : built.assembly.faces) {
          const auto wall_of = [&](int k) { return built.body[k].wall; };
          const bool fixed = built.assembly.body[face.a].fixed;
          if (!fixed && wall_of(face.a) != wall_of(face.b)) shared += face.area;
        }
        EXPECT_NEAR(shared, 1.2 * 0.2 / s, 1e-9) << what;
        EXPECT_EQ(built.assembly.lost_faces, 0) << what;
      }
}

TEST(Builder, walls_of_different_heights_meet_up_to_the_lower) {
  for (const double height : {0.7, 1.9}) {
    PlanWallSpec a = wall("a", {{0, 0}, {2.925, 0}}), b = wall("b", {{0, 0}, {0, 1.425}}, height),
                 c = wall("c", {{1.5, 0}, {1.5, 1.425}}, height);
    const Built built = build(plan({a, b, c}));
    EXPECT_TRUE(built.faults.empty()) << told(built.faults);
    // of corner and tee every course holds the place once, above the lower wall the higher one alone
    const double both = 3 + 2 * (1.5 - kThick);
    const double low = std::min(height, 1.2);
    const double above = height > 1.2 ? 1.5 + 1.5 : 3;
    EXPECT_NEAR(built.volume, (both * low + above * (std::max(height, 1.2) - low)) * kThick, 1e-9)
        << height;
  }
}

// --- regions ---

PlanRegionSpec box_region(double x, double y, double width, double height) {
  PlanRegionSpec region;
  region.place.x = x, region.place.y = y;
  region.place.width = width, region.place.height = height;
  return region;
}

// Numbers of bodies of a material, and their volume.
std::pair<int, double> of_material(const Built& b, const std::string& material) {
  std::pair<int, double> sum{0, 0};
  for (std::size_t k = 0; k < b.assembly.body.size(); ++k)
    if (b.assembly.body[k].material == material && !b.assembly.body[k].fixed) {
      ++sum.first;
      sum.second += b.assembly.moments[k].volume;
    }
  return sum;
}

TEST(Builder, a_region_has_its_material_and_the_wall_keeps_its_volume) {
  for (const double turned : {0.0, 0.4}) {
    BuilderSpec spec = plan({wall("a", {{0, 0}, {3 * std::cos(turned), 3 * std::sin(turned)}})});
    spec.plan_wall[0].unit.split = Split::kMiddle;
    spec.plan_wall[0].region = {box_region(0.6, 0.2, 0.6, 0.5)};
    spec.plan_wall[0].region[0].material = "timber";  // any that has a density
    const Built b = build(spec);
    ASSERT_TRUE(b.faults.empty()) << told(b.faults);
    EXPECT_NEAR(b.volume, 3 * kThick * 1.2, 1e-9);
    const auto [count, volume] = of_material(b, "timber");
    EXPECT_EQ(count, 4 * 5);  // half units of 0.15 m in courses of 0.1 m
    EXPECT_NEAR(volume, 0.6 * 0.5 * kThick, 1e-9);
  }
}

TEST(Builder, a_region_of_another_thickness_lies_on_the_wall_by_what_both_share) {
  for (const auto& [thickness, offset] :
       {std::pair(0.1, 0.0), {0.1, 0.02}, {0.3, 0.0}, {0.3, -0.075}}) {
    BuilderSpec spec = plan({wall("a", {{0, 0}, {3, 0}})});
    spec.plan_wall[0].unit.split = Split::kMiddle;
    spec.plan_wall[0].region = {box_region(0, 0.6, 3, 0.6)};
    spec.plan_wall[0].region[0].thickness = thickness;
    spec.plan_wall[0].region[0].offset = offset;
    const Built b = build(spec);
    ASSERT_TRUE(b.faults.empty()) << told(b.faults);
    EXPECT_NEAR(b.volume, 3 * 0.6 * (kThick + thickness), 1e-9);
    // beds: of six courses below and their foundation, five within the region, one between both
    const double both = std::min(kThick / 2, offset + thickness / 2) -
                        std::max(-kThick / 2, offset - thickness / 2);
    EXPECT_NEAR(b.level, 3 * (6 * kThick + 5 * thickness + both), 1e-9);
    double across = 0, mass = 0;  // centroid of the region's blocks across the line
    for (std::size_t k = 0; k < b.assembly.body.size(); ++k)
      if (b.assembly.moments[k].centroid.y > 0.6) {
        across += b.assembly.moments[k].volume * b.assembly.moments[k].centroid.z;
        mass += b.assembly.moments[k].volume;
      }
    EXPECT_NEAR(across / mass, offset, 1e-12);
  }
}

TEST(Builder, a_region_may_be_a_pier_or_a_polygon_and_the_last_one_has_the_blocks) {
  BuilderSpec spec = plan({wall("a", {{0, 0}, {3, 0}})});
  PlanWallSpec& a = spec.plan_wall[0];
  a.unit.split = Split::kMiddle;
  OpeningSpec door;
  door.x = 0.9, door.y = 0, door.width = 0.6, door.height = 0.8;
  a.opening = {door};
  a.region.resize(2);
  a.region[0].place.pier = 2;  // from 1.5 m to 3 m
  a.region[0].material = "timber";
  a.region[1].place.polygon = {{2.4, 0}, {3, 0}, {3, 1.2}, {2.4, 1.2}};
  a.region[1].thickness = kThick;
  const Built b = build(spec);
  ASSERT_TRUE(b.faults.empty()) << told(b.faults);
  EXPECT_NEAR(of_material(b, "timber").second, 0.9 * 1.2 * kThick, 1e-9);
  EXPECT_NE(texts_of(b.notes).back().find("region 1 takes 48 blocks of region 0"),
            std::string::npos);
}

TEST(Builder, faults_of_regions_are_told_with_their_place) {
  const auto refusal = [](const std::function<void(PlanWallSpec&)>& change) {
    BuilderSpec spec = plan({wall("a", {{0, 0}, {3, 0}})});
    spec.plan_wall[0].region = {box_region(0.6, 0.2, 0.6, 0.5)};
    spec.plan_wall[0].region[0].material = "timber";
    change(spec.plan_wall[0]);
    return told(build(spec).faults);
  };
  const auto expect = [](const std::string& text, const std::string& path,
                         const std::string& what) {
    EXPECT_NE(text.find(path), std::string::npos) << text;
    EXPECT_NE(text.find(what), std::string::npos) << text;
  };
  EXPECT_EQ(refusal([](PlanWallSpec&) {}), "");
  expect(refusal([](PlanWallSpec& w) { w.region[0].material = ""; }), "plan_wall.0.region.0",
         "changes nothing");
  expect(refusal([](PlanWallSpec& w) { w.region[0].material = "gold"; }),
         "plan_wall.0.region.0.material", "material.gold");
  expect(refusal([](PlanWallSpec& w) { w.region[0].place.x = 5; }), "plan_wall.0.region.0",
         "holds no block");
  expect(refusal([](PlanWallSpec& w) { w.region[0].place.pier = 1; }), "plan_wall.0.region.0",
         "more than one place");
  expect(refusal([](PlanWallSpec& w) { w.region[0].offset = 0.2; }), "plan_wall.0.region.0.offset",
         "beside what lies above or below it");
  expect(refusal([](PlanWallSpec& w) { w.wythes = 2, w.region[0].thickness = 0.1; }),
         "plan_wall.0.region.0.thickness", "one wythe");
  expect(refusal([](PlanWallSpec& w) {
           w.line.push_back({3, 3});
         }),
         "plan_wall.0.region", "corners");
}

// --- ring beams ---

TEST(Builder, a_ring_beam_is_one_course_of_segments_with_a_role) {
  PlanWallSpec ring = wall("ring", {{0, 0}, {2.85, 0}, {2.85, 2.25}, {0, 2.25}, {0, 0}}, 0.25);
  ring.base = 1.2, ring.ring_beam = true, ring.material = "timber";
  ring.unit.height = kUnset;
  const Built b = build(plan({ring}));
  ASSERT_TRUE(b.faults.empty()) << told(b.faults);
  EXPECT_NEAR(b.volume, 2 * (2.85 + 2.25) * kThick * 0.25, 1e-9);
  std::set<std::string> ids;
  for (const BuiltBody& built : b.body) {
    EXPECT_EQ(built.body.role, "ring_beam");
    EXPECT_NE(built.body.id.find(".beam.s"), std::string::npos) << built.body.id;
    ids.insert(built.body.id);
  }
  EXPECT_EQ(ids.size(), b.body.size());
  // a ring: as many sections as segments, each of the whole section
  EXPECT_EQ(b.assembly.faces.size(), b.body.size());
  EXPECT_NEAR(b.all, static_cast<double>(b.body.size()) * kThick * 0.25, 1e-9);
  PlanWallSpec faulty = ring;
  faulty.gable = 1, faulty.material = "", faulty.height = kUnset;
  const std::string text = told(build(plan({faulty})).faults);
  for (const char* key : {"plan_wall.0.gable", "plan_wall.0.material", "plan_wall.0.height"})
    EXPECT_NE(text.find(key), std::string::npos) << text;
}

TEST(Builder, an_opening_in_a_meeting_is_refused) {
  BuilderSpec spec = plan({wall("a", {{0, 0}, {3, 0}}), wall("b", {{1.5, 0}, {1.5, 1.425}})});
  OpeningSpec door;
  door.x = 1.2, door.y = 0, door.width = 0.6, door.height = 0.8;
  spec.plan_wall[0].opening = {door};
  const Built b = build(spec);
  ASSERT_FALSE(b.faults.empty());
  EXPECT_EQ(b.faults.all().front().path, "plan_wall.0.opening.0.x") << told(b.faults);
}

// At toothed walls no vertical plane separates them: each course
// that goes through lies on and under blocks of the other wall.
TEST(Builder, teeth_lie_on_the_other_wall_by_turns) {
  const Built b = build(plan({wall("a", {{0, 0}, {2.025, 0}}), wall("b", {{0, 0}, {0, 1.425}})}));
  std::map<int, double> bedded;  // by the upper course: area between the two walls
  for (const JointFace& face : b.assembly.faces) {
    const BuiltBody &p = b.body[face.a], &q = b.body[face.b];
    if (std::fabs(face.normal.y) > 0.99 && p.wall != q.wall && !p.body.fixed)
      bedded[std::max(p.course, q.course)] += face.area;
  }
  EXPECT_EQ(bedded.size(), 11U);
  for (const auto& [course, area] : bedded) EXPECT_NEAR(area, kThick * kThick, 1e-9) << course;
}

// In the courses between, a unit lies over the tooth and past both its sides.
TEST(Builder, a_tooth_in_the_middle_of_a_wall_is_bridged_past_both_sides) {
  for (const double x : {1.05, 1.125, 1.2, 1.5}) {
    const Built b = build(plan({wall("a", {{0, 0}, {3, 0}}), wall("b", {{x, 0}, {x, 1.425}})}));
    int bridged = 0;
    for (const BuiltBody& built : b.body) {
      if (built.wall != "a" || built.body.fixed) continue;
      const Box3 box = box_of(built.body);
      bridged += box.low.x < x - kThick / 2 - 0.03 && box.high.x > x + kThick / 2 + 0.03;
    }
    EXPECT_EQ(bridged, 6) << x;
  }
}

TEST(Builder, a_mirrored_plan_gives_the_mirrored_wall) {
  const auto centres = [](const BuilderSpec& spec, double side) {
    std::vector<std::array<double, 4>> list;
    const Built b = build(spec);
    for (std::size_t k = 0; k < b.assembly.body.size(); ++k) {
      const SolidMoments& m = b.assembly.moments[k];
      list.push_back({std::round(1e9 * side * m.centroid.x) + 0.0, std::round(1e9 * m.centroid.y),
                      std::round(1e9 * m.centroid.z) + 0.0, std::round(1e9 * m.volume)});
    }
    std::sort(list.begin(), list.end());
    return list;
  };
  const auto room = [](double side) {
    PlanWallSpec tee = wall("t", {{side * 1.2, 0}, {side * 1.2, 1.5}});
    tee.bond = "english";
    tee.wythes = 2;
    return plan({wall("a", {{0, 0}, {side * 3, 0}, {side * 3, 1.5}}), tee});
  };
  EXPECT_EQ(centres(room(1), 1), centres(room(-1), -1));
}

TEST(Builder, wythes_fill_the_volume_and_headers_tie_them) {
  for (const char* bond : {"running", "flemish", "english", "header"})
    for (const int wythes : {1, 2, 3}) {
      PlanWallSpec spec = wall("a", {{0, 0}, {3, 0}});
      spec.bond = bond;
      spec.wythes = wythes;
      spec.thickness = 0.3;
      expect_whole(plan({spec}), 3 * 0.3, 1.2, bond + std::to_string(wythes));
    }
  const auto ties = [](const char* bond, int through) {
    PlanWallSpec spec = wall("a", {{0, 0}, {3, 0}});
    spec.bond = bond;
    spec.wythes = 2;
    spec.thickness = 0.3;
    spec.through_courses = through;
    const Built b = build(plan({spec}));
    std::map<int, std::set<int>> touched;  // by a body of the whole thickness: wythes
    for (const JointFace& face : b.assembly.faces)
      for (const auto& [own, other] : {std::pair(face.a, face.b), {face.b, face.a}}) {
        const BuiltBody& built = b.body[own];
        if (!built.body.fixed && built.wythe == 0) touched[own].insert(b.body[other].wythe);
      }
    return std::count_if(touched.begin(), touched.end(), [](const auto& entry) {
      return entry.second.contains(1) && entry.second.contains(2);
    });
  };
  EXPECT_EQ(ties("running", 0), 0);
  EXPECT_EQ(ties("running", 3), 40 + 2);  // four courses of ten and a half units
  EXPECT_GT(ties("english", 0), 60);
  EXPECT_GT(ties("flemish", 0), 60);
}

TEST(Builder, a_gable_fills_its_triangle) {
  for (const double rise : {0.6, 0.95, 1.3}) {
    PlanWallSpec spec = wall("a", {{0, 0}, {3, 0}});
    spec.gable = rise;
    const Built b = build(plan({spec}));
    EXPECT_TRUE(b.faults.empty()) << told(b.faults);
    EXPECT_NEAR(b.volume, 3 * kThick * (1.2 + rise / 2), 1e-9) << rise;
  }
}

TEST(Builder, an_opening_takes_its_volume_and_its_lintel_is_one_block) {
  BuilderSpec spec = plan({wall("a", {{0, 0}, {3, 0}})});
  OpeningSpec door;
  door.x = 1.2, door.y = 0, door.width = 0.6, door.height = 0.8;
  door.lintel.kind = "timber", door.lintel.material = "timber";
  door.lintel.depth = 0.1, door.lintel.bearing = 0.15;
  spec.plan_wall[0].opening = {door};
  const Built b = build(spec);
  EXPECT_TRUE(b.faults.empty()) << told(b.faults);
  EXPECT_NEAR(b.volume, (3 * 1.2 - 0.6 * 0.8) * kThick, 1e-9);
  int lintels = 0;
  for (std::size_t k = 0; k < b.assembly.body.size(); ++k)
    if (b.assembly.body[k].id == "a.lintel0") {
      ++lintels;
      EXPECT_NEAR(b.assembly.moments[k].volume, 0.9 * 0.1 * kThick, 1e-12);
    }
  EXPECT_EQ(lintels, 1);
}

TEST(Builder, a_lintel_whose_material_has_moduli_is_a_chain_that_bends) {
  BuilderSpec spec = plan({wall("a", {{0, 0}, {3, 0}})});
  OpeningSpec door;
  door.x = 1.2, door.y = 0, door.width = 0.6, door.height = 0.8;
  door.lintel.kind = "timber", door.lintel.material = "timber";
  door.lintel.depth = 0.1, door.lintel.bearing = 0.15;
  spec.plan_wall[0].opening = {door};
  const auto lintel_of = [](const Built& b) {
    double volume = 0;
    int segments = 0;
    for (std::size_t k = 0; k < b.assembly.body.size(); ++k)
      if (b.assembly.body[k].id.starts_with("a.lintel0.s"))
        ++segments, volume += b.assembly.moments[k].volume;
    return std::pair(segments, volume);
  };
  EXPECT_EQ(lintel_of(build(spec)).first, 0);
  const auto [segments, volume] = lintel_of(build(spec, 10e9));
  EXPECT_EQ(segments, 6);
  EXPECT_NEAR(volume, 0.9 * 0.1 * kThick, 1e-12);
}

// --- vaults -----------------------------------------------------------------------------------------

TEST(Builder, an_arch_and_a_vault_have_the_volume_and_joints_of_their_chords) {
  for (const double rise : {2.0, 0.6, 2.4})
    for (const int units : {1, 5}) {
      BuilderSpec spec = plan({});
      StandingArchSpec arch;
      arch.name = "v", arch.span = 4, arch.rise = rise, arch.depth = 0.3, arch.width = 3;
      arch.voussoirs = 17, arch.units = units, arch.turn = 0.3;
      spec.arch = {arch};
      const Built b = build(spec);
      EXPECT_TRUE(b.faults.empty()) << told(b.faults);
      const double inner = (4 + rise * rise) / (2 * rise), outer = inner + 0.3;
      const double angle = 2 * std::atan2(2, inner - rise);
      EXPECT_NEAR(b.volume, 17 * 0.5 * std::sin(angle / 17) * (outer * outer - inner * inner) * 3,
                  1e-9);
      const int upright = 9 * (units - 1) + (units > 1 ? 8 * units : 0);
      const double end = b.volume / 17 / 3;
      EXPECT_NEAR(b.all, 18 * 0.3 * 3 + upright * end, 1e-9) << rise << ' ' << units;
    }
}

TEST(Builder, a_dome_has_the_volume_and_joints_of_its_chords) {
  for (const double rise : {2.0, 0.8})
    for (const double oculus : {0.0, 0.7})
      for (const char* bond : {"running", "stack"}) {
        BuilderSpec spec = plan({});
        DomeSpec dome;
        dome.name = "d", dome.span = 4, dome.rise = rise, dome.depth = 0.25;
        dome.courses = 7, dome.units = 9, dome.oculus = oculus, dome.bond = bond;
        spec.dome = {dome};
        const Built b = build(spec);
        EXPECT_TRUE(b.faults.empty()) << told(b.faults);
        const double inner = (4 + rise * rise) / (2 * rise), outer = inner + 0.25;
        const double reach = std::atan2(2, inner - rise);
        const double eye = oculus > 0 ? std::asin(oculus / 2 / inner) : reach / 7.5 / 2;
        const double step = (reach - eye) / 7, half = M_PI / 9;
        const double cubes = (std::pow(outer, 3) - std::pow(inner, 3)) / 3;
        const double squares = (outer * outer - inner * inner) / 2;
        double volume = 0, joints = 0;
        for (int c = 0; c <= 7; ++c) {
          const double low = reach - c * step, high = low - step;
          // a wedge is a pyramid over the four corners on the unit sphere, less its tip
          const double a = 2 * std::sin(low) * std::sin(half / 2);
          const double t = 2 * std::sin(high) * std::sin(half / 2);
          const double flat = std::cos(half / 2);
          const Vec2 foot{std::sin(low) * flat, std::cos(low)},
              head{std::sin(high) * flat, std::cos(high)};
          const double tall = length(head - foot);
          const double away = std::fabs(cross(foot, head)) / tall;
          if (c < 7) volume += 18 * 0.5 * (a + t) * tall * away * cubes;
          const double spread =
              std::acos(std::pow(std::cos(low), 2) + std::pow(std::sin(low), 2) * std::cos(half));
          if (c < 7 || oculus == 0) joints += 18 * squares * std::sin(spread);
          if (c < 7) joints += 9 * squares * std::sin(step);
        }
        if (oculus == 0)
          volume += 18 * 0.5 * std::pow(std::sin(eye), 2) * std::sin(half) * std::cos(eye) * cubes;
        EXPECT_NEAR(b.volume, volume, 1e-9) << rise << ' ' << oculus << ' ' << bond;
        EXPECT_NEAR(b.all, joints, 1e-9) << rise << ' ' << oculus << ' ' << bond;
      }
}

// --- bad input --------------------------------------------------------------------------------------

void expect_refused(const BuilderSpec& spec, const std::string& path, const std::string& problem) {
  const Built b = build(spec);
  const auto& all = b.faults.all();
  EXPECT_TRUE(std::any_of(all.begin(), all.end(),
                          [&](const Fault& fault) {
                            return fault.path == path &&
                                   fault.problem.find(problem) != std::string::npos &&
                                   !fault.cure.empty();
                          }))
      << problem << "\nsaid:\n"
      << told(b.faults);
}

TEST(Builder, walls_that_do_not_meet_are_refused_by_place) {
  const PlanWallSpec a = wall("a", {{0, 0}, {3, 0}});
  expect_refused(plan({a, wall("b", {{1, 0.05}, {1, 2}})}), "plan_wall.1.line", "off the middle");
  expect_refused(plan({a, wall("b", {{1, -1}, {1, 2}})}), "plan_wall.1.line", "crosses");
  expect_refused(plan({a, wall("b", {{0, 0}, {1, 2}})}), "plan_wall.1.line", "another angle");
  PlanWallSpec flat = wall("b", {{0, 0}, {2, 1}});
  flat.meets = Meeting::kButted;
  expect_refused(plan({a, flat}), "plan_wall.1.line", "less than 45 degrees");
  expect_refused(plan({a, wall("b", {{3, 0}, {5, 0}})}), "plan_wall.1.line", "straight on");
  expect_refused(plan({a, wall("b", {{0, 0}, {0, 2}}), wall("c", {{0, 0}, {0, -2}})}),
                 "plan_wall.1.line", "more than two");
  expect_refused(plan({a, wall("b", {{1, 0}, {1, 2}}), wall("c", {{1.05, 0}, {1.05, -2}})}),
                 "plan_wall.2.line", "where b does");
}

TEST(Builder, an_end_that_barely_misses_a_wall_is_noted_with_the_place_where_both_meet) {
  const PlanWallSpec a = wall("a", {{0, 0}, {2.25, 0}});
  const double half = 0.5 * kThick;
  const auto misses = [&](const PlanWallSpec& other) {
    std::vector<Message> found;
    for (const Message& note : build(plan({a, other})).notes)
      if (note.code == "plan_wall.near_miss") found.push_back(note);
    return found;
  };
  // 10 mm beside the corner, and 10 mm before the face
  for (const PlanWallSpec& b : {wall("b", {{2.25 + half + 0.01, 0.5}, {2.25 + half + 0.01, -1.75}}),
                                wall("b", {{1.125, half + 0.01}, {1.125, half + 2.26}})}) {
    const std::vector<Message> found = misses(b);
    ASSERT_EQ(found.size(), 1U);
    EXPECT_NEAR(found[0].number("gap_mm"), 10, 1e-6);
    EXPECT_NE(text_of(found[0]).find("let both lines go to ["), std::string::npos);
  }
  // walls that meet, that stand apart, and leaves side by side
  EXPECT_TRUE(misses(wall("b", {{2.25, 0}, {2.25, 2.25}})).empty());
  EXPECT_TRUE(misses(wall("b", {{1.125, 2 * half + 0.1}, {1.125, 2.25 + 2 * half + 0.1}})).empty());
  EXPECT_TRUE(misses(wall("b", {{0, 2 * half + 0.05}, {2.25, 2 * half + 0.05}})).empty());
}

TEST(Builder, courses_that_do_not_match_are_refused_where_walls_are_toothed) {
  const PlanWallSpec a = wall("a", {{0, 0}, {2.025, 0}});
  PlanWallSpec b = wall("b", {{0, 0}, {0, 1.425}});
  b.unit.height = 0.15;
  expect_refused(plan({a, b}), "plan_wall.0.height", "do not match");
  b.meets = Meeting::kButted;
  EXPECT_TRUE(build(plan({a, b})).faults.empty());
  b = wall("b", {{0, 0}, {0, 1.5}});
  b.thickness = 0.3;  // units of 0.3 m do not lap it
  expect_refused(plan({wall("a", {{0, 0}, {2.1, 0}}), b}), "plan_wall.0.unit.length", "lap");
  // a ring in which one wall has an odd number of half units: at its last corner both would go through
  PlanWallSpec odd = wall("b", {{2.85, 0}, {2.85, 2.25}});
  odd.unit.length = 0.32;
  expect_refused(plan({wall("a", {{0, 0}, {2.85, 0}}), odd, wall("c", {{2.85, 2.25}, {0, 2.25}}),
                       wall("d", {{0, 2.25}, {0, 0}})}),
                 "plan_wall.3.line", "both would go through");
}

TEST(Builder, what_has_no_density_is_refused_before_it_is_laid) {
  BuilderSpec spec = plan({wall("a", {{0, 0}, {3, 0}})});
  StandingArchSpec arch;
  arch.name = "v", arch.span = 4, arch.depth = 0.3, arch.width = 3, arch.voussoirs = 7;
  spec.arch = {arch};
  const auto faults_with = [&](double density) {
    ModelSpec model;
    model.material["stone"].density = density;
    std::vector<Message> notes;
    FaultList faults;
    (void)build_bodies({spec, model}, notes, faults);
    return faults;
  };
  EXPECT_EQ(faults_with(kUnset).all().size(), 2U);
  spec.plan_wall[0].material = spec.arch[0].material = "stone";
  EXPECT_TRUE(faults_with(2000).empty()) << told(faults_with(2000));
  EXPECT_FALSE(faults_with(kUnset).empty());
}

TEST(Builder, bad_numbers_are_refused_all_at_once) {
  PlanWallSpec a = wall("a", {{0, 0}, {3, 0}});
  a.wythes = 5, a.bond = "runing", a.unit.density = 1500;
  PlanWallSpec b = wall("a", {{0, 2}});
  BuilderSpec spec = plan({a, b});
  StandingArchSpec arch;
  arch.name = "v", arch.span = 4, arch.depth = 0.3, arch.width = 3, arch.voussoirs = 2;
  spec.arch = {arch};
  DomeSpec dome;
  dome.name = "a*", dome.span = -1, dome.units = 3;
  spec.dome = {dome};
  const Built built = build(spec);
  std::set<std::string> paths;
  for (const Fault& fault : built.faults.all()) paths.insert(fault.path);
  for (const char* path :
       {"plan_wall.0.wythes", "plan_wall.0.bond", "plan_wall.0.unit.density", "plan_wall.1.name",
        "plan_wall.1.line", "arch.0.voussoirs", "dome.0.name", "dome.0.span", "dome.0.depth",
        "dome.0.courses", "dome.0.units"})
    EXPECT_TRUE(paths.contains(path)) << path << '\n' << told(built.faults);
}

}  // namespace
}  // namespace wythe::geometry::builder_property_test
