// Assemblies of COMPAS stand or fall as their source or statics says. Their thrust is at least that of a line of thrust.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "core/files.h"
#include "io/bodies/blocks_json.h"
#include "io/bodies/bodies_file.h"
#include "io/bodies/meshes.h"
#include "record.h"
#include "scenes/places.h"
#include "scenes/run.h"
#include "scenes/scenes.h"
#include "scenes/solids.h"
#include "wythe/parts/reading.h"
#include "wythe/parts/solve.h"

namespace wythe::compas_test {
namespace {

using scenes::Outcome;
using verification::verify;

constexpr double kDensity = 2000, kG = 9.81;

// In metres with z up, as COMPAS writes them; supports are the bodies that `is_support` picks.
template <class IsSupport>
std::vector<BodySpec> bodies_of(const std::string& name, double units_in_a_metre,
                                const IsSupport& is_support) {
  const std::string file = source_dir() + "/tests/data/compas/" + name;
  FaultList faults;
  std::vector<BodySpec> bodies =
      io::is_mesh_file(file)
          ? io::parse_mesh_bodies(file, faults)
          : io::compas_bodies(nlohmann::json::parse(read_text(file, 1'000'000)), file, faults);
  io::place(bodies, units_in_a_metre, true);
  faults.throw_if_any();
  for (BodySpec& body : bodies) body.fixed = is_support(body);
  return bodies;
}
double lowest(const BodySpec& body) {
  double y = std::numeric_limits<double>::infinity();
  for (const Polyhedron& part : body.part)
    for (const Vec3& corner : part.vertex) y = std::min(y, corner.y);
  return y;
}

Outcome run(std::vector<BodySpec> bodies, double friction, std::vector<StageSpec> after = {},
            double stiffness = 5e9) {
  ModelSpec spec = scenes::in_space(
      std::move(bodies), scenes::dry_joint(stiffness, 0.4 * stiffness, std::atan(friction)),
      kDensity);
  spec.solve.damping = 0.7;
  spec.solve.settle_ratio = 1e-4;
  spec.stage = {scenes::gravity_stage()};
  for (StageSpec& stage : after) spec.stage.push_back(std::move(stage));
  return scenes::run(spec);
}
SolveStatus ends(const std::string& file, const std::vector<std::string>& supports,
                 double friction) {
  return run(bodies_of(file, 1,
                       [&](const BodySpec& body) {
                         return std::count(supports.begin(), supports.end(), body.id) > 0;
                       }),
             friction)
      .result.status;
}

// Kao et al. 2022: a bar between two posts, held by nothing but friction. Statics alone allows any thrust between
// the posts, and so "finds" that friction holds the bar; nothing makes such a thrust, and the bar falls.
TEST(Compas, a_bar_that_nothing_presses_falls_out_of_its_posts) {
  for (const char* file : {"H.json", "A.json"})
    EXPECT_EQ(ends(file, {"0", "1"}, 0.84), SolveStatus::kCollapsed) << file;
}

// The same paper's shelf falls with two more books on it; cubes on cubes stand.
TEST(Compas, a_shelf_stands_or_falls_as_its_name_says) {
  EXPECT_EQ(ends("shelf-stable.json", {"0"}, 0.9), SolveStatus::kCompleted);
  EXPECT_EQ(ends("shelf.json", {"0"}, 0.9), SolveStatus::kCollapsed);
  EXPECT_EQ(ends("cubes.json", {"0"}, 0.84), SolveStatus::kCompleted);
}

// Arms that hook into each other, weights on them, and piers whose sections have holes.
TEST(Compas, a_bridge_of_hooked_arms_stands) {
  const std::vector<BodySpec> bodies = bodies_of(
      "bridge.json", 1, [](const BodySpec& body) { return body.id == "0" || body.id == "1"; });
  EXPECT_EQ(run(bodies, 0.9).result.status, SolveStatus::kCompleted);
}

// A joint whose teeth hook into each other: it holds at 50 degrees, where friction of 0.84 alone holds up to 40.
TEST(Compas, a_hooked_joint_holds_where_friction_alone_does_not) {
  StageSpec tilt{.name = "tilt",
                 .action = TiltStage{.tilt_rate = 4 * scenes::kPi / 180,
                                     .tilt_until = 50 * scenes::kPi / 180}};
  const Outcome hooked =
      run(bodies_of("concave-long.json", 1, [](const BodySpec& body) { return body.id == "0"; }),
          0.84, {tilt});
  EXPECT_EQ(hooked.result.status, SolveStatus::kCompleted) << hooked.result.reason;
  std::vector<BodySpec> plain{scenes::box_body("floor", {-2, -0.2, -1}, {2, 0, 1}, true),
                              scenes::box_body("block", {-0.5, 0, -0.5}, {0.5, 0.2, 0.5})};
  EXPECT_EQ(run(plain, 0.84, {tilt}).result.status, SolveStatus::kCollapsed);
}

// Reactions of the supports on one side (x > 0).
struct Reaction {
  double lift = 0, thrust = 0;
};
Reaction reaction_of(const Outcome& r, bool right) {
  Reaction sum;
  for (const JointReading& joint : read_wall(r.model, r.state).joints) {
    if (joint.shape.kind != JointKind::kFoundation) continue;
    if ((joint.shape.centre.x > 0) != right) continue;
    const Vec3 force = joint.compression * joint.shape.normal - joint.shear_vector;
    sum.lift += force.y;
    sum.thrust += right ? -force.x : force.x;
  }
  return sum;
}

// --- the barrel vault of compas_dem -------------------------------------------------------------------------
// Laid by the numbers of its script: span 7 m, rise 0.1 m, thickness 0.25 m, length 3 m, 9 strips of voussoirs across
// the span, 13 a strip, every other strip shifted by half a unit; the first and the last strip are supports.
struct Vault {
  static constexpr double kSpan = 7, kRise = 0.1, kThickness = 0.25, kLength = 3;
  static constexpr int kStrips = 9, kUnits = 13;
  double radius = kRise / 2 + kSpan * kSpan / (8 * kRise);
  double step = 2 * std::asin(kSpan / 2 / radius) / kStrips;

  [[nodiscard]] Vec2 corner(int ray, bool outer) const {  // of the ray left of strip `ray`
    const double r = radius + (outer ? 0.5 : -0.5) * kThickness;
    const double angle = (ray - 0.5 * kStrips) * step;
    return {r * std::sin(angle), kRise - radius + r * std::cos(angle)};
  }
  [[nodiscard]] std::vector<BodySpec> bodies() const {
    std::vector<BodySpec> all;
    const double unit = kLength / kUnits;
    for (int strip = 0; strip < kStrips; ++strip) {
      std::vector<double> cut{0};
      for (int k = 0; k < kUnits; ++k) cut.push_back((k + (strip % 2 == 0 ? 1 : 0.5)) * unit);
      if (strip % 2 == 1) cut.push_back(kLength);
      for (std::size_t k = 0; k + 1 < cut.size(); ++k) {
        const std::vector<Vec2> outline{corner(strip, false), corner(strip + 1, false),
                                        corner(strip + 1, true), corner(strip, true)};
        const bool is_support = strip == 0 || strip == kStrips - 1;
        const std::string name = strip == 0 ? "left" : strip == kStrips - 1 ? "right" : "v";
        all.push_back(scenes::body_of(
            name + std::to_string(strip) + "_" + std::to_string(k),
            scenes::prism_part(outline, cut[k] - kLength / 2, cut[k + 1] - kLength / 2),
            is_support));
      }
    }
    return all;
  }
  // Least horizontal force H whose line of pressure stays in every joint, by symmetry from the crown: H runs at the
  // height y, and M(P) = H (y - P.y) - sum w (P.x - x_w) must not be negative at the lower end of a joint, nor
  // positive at the upper. For each pair of joints that gives H = (m_lower - m_upper) / (Q.y - P.y) + ..., linear in
  // H and H y: the least H of all pairs of a lower and an upper end.
  [[nodiscard]] double least_thrust() const {
    const double unit_weight = kLength * kDensity * kG;
    struct End {
      double y, moment;
    };
    std::vector<End> lower, upper;
    // half of the middle strip, then whole ones
    double load = 0, moment = 0;
    upper.push_back({kRise - radius + (radius + kThickness / 2) * std::cos(step / 2), 0});
    const int middle = kStrips / 2;
    for (int ray = middle + 1; ray < kStrips; ++ray) {
      std::vector<Vec2> outline{corner(ray - 1, false), corner(ray, false), corner(ray, true),
                                corner(ray - 1, true)};
      if (ray == middle + 1) outline[0].x = outline[3].x = 0;
      double area = 0, first = 0;
      for (std::size_t k = 0; k < 4; ++k) {
        const Vec2 a = outline[k], b = outline[(k + 1) % 4];
        const double twice = a.x * b.y - b.x * a.y;
        area += twice / 2;
        first += twice * (a.x + b.x) / 6;
      }
      load += std::fabs(area) * unit_weight;
      moment += std::fabs(first) * unit_weight;
      for (const bool outer : {false, true}) {
        const Vec2 p = corner(ray, outer);
        (outer ? upper : lower).push_back({p.y, load * p.x - moment});
      }
    }
    // q = H y: lower end q - H P.y >= m(P); upper end q - H Q.y <= m(Q); at the crown q <= H * upper[0].y
    double least = 0;
    for (const End& p : lower)
      for (const End& q : upper)
        if (q.y > p.y) least = std::fmax(least, (p.moment - q.moment) / (q.y - p.y));
    return least;
  }
};

TEST(Compas, a_barrel_vault_weighs_and_thrusts_as_it_must) {
  const Vault vault;
  std::vector<BodySpec> bodies = vault.bodies();
  EXPECT_EQ(bodies.size(), 121U);
  const Outcome rests = run(bodies, 0.5);
  ASSERT_EQ(rests.result.status, SolveStatus::kCompleted) << rests.result.reason;
  EXPECT_EQ(rests.model.n_block, 95);
  verify({"CD01", "barrel vault of compas_dem: weight of its 95 free blocks", "N", 80156, 1e-4,
          "given to five digits"},
         rests.model.weight);
  const Reaction left = reaction_of(rests, false), right = reaction_of(rests, true);
  verify({"CD02", "barrel vault of compas_dem: vertical reaction on the left, of LMGC90", "N",
          40070, 2e-3, "LMGC90's two sides differ by 7e-4"},
         left.lift);
  verify({"CD02", "barrel vault of compas_dem: vertical reaction on the right, of LMGC90", "N",
          40100, 2e-3, "LMGC90's two sides differ by 7e-4"},
         right.lift);
  verify({"CD03", "barrel vault of compas_dem: thrust on the right over that on the left", "-", 1,
          2e-3, "at rest to the criterion of gravity"},
         right.thrust / left.thrust);
  // rigid blocks leave the thrust open between bounds: LMGC90's 175.97 kN is one answer, ours another
  const double least = vault.least_thrust();
  EXPECT_GT(left.thrust, least);
  EXPECT_GT(175970, least);

  // joints so stiff that a spread of 1 mm opens hinges, and so small a spread that the rise of 0.35 m stays
  StageSpec hold{.name = "hold", .action = HoldStage{.duration = 0.5}};
  const Outcome spread =
      run(std::move(bodies), 0.5,
          {scenes::push_stage("right*", Direction::kPlusX, 2e-3, 1e-3), hold}, 1e11);
  ASSERT_EQ(spread.result.status, SolveStatus::kCompleted) << spread.result.reason;
  verify(
      {"CD04", "barrel vault of compas_dem on spread supports: least thrust of a line of pressure",
       "N", least, 0.03, "the crown sinks by 1 % of the rise; hinges at elastic edges"},
      reaction_of(spread, true).thrust);
}

// The cross vault of compas_dem: it stands on its four corners, and thrusts less when two of them move away.
TEST(Compas, a_cross_vault_stands_and_thrusts_less_on_spread_supports) {
  std::vector<BodySpec> bodies =
      bodies_of("crossvault.obj", 100, [](const BodySpec&) { return false; });
  double low = lowest(bodies.front());
  for (const BodySpec& body : bodies) low = std::min(low, lowest(body));
  int supports = 0;
  for (BodySpec& body : bodies)
    if (lowest(body) < low + 1e-3) {
      body.fixed = true;
      body.id =
          (body.part.front().vertex.front().x > 0 ? "right" : "left") + std::to_string(supports++);
    }
  ASSERT_EQ(supports, 4);
  const Outcome rests = run(bodies, 0.7);
  ASSERT_EQ(rests.result.status, SolveStatus::kCompleted) << rests.result.reason;
  const Reaction left = reaction_of(rests, false), right = reaction_of(rests, true);
  verify({"CD05", "cross vault of compas_dem: vertical reaction", "N", rests.model.weight, 1e-3,
          "at rest to the criterion of gravity"},
         left.lift + right.lift);
  EXPECT_NEAR(right.thrust / left.thrust, 1, 5e-3);
  StageSpec hold{.name = "hold", .action = HoldStage{.duration = 0.5}};
  const Outcome spread = run(std::move(bodies), 0.7,
                             {scenes::push_stage("right*", Direction::kPlusX, 5e-3, 5e-3), hold});
  ASSERT_EQ(spread.result.status, SolveStatus::kCompleted) << spread.result.reason;
  EXPECT_LT(reaction_of(spread, true).thrust, right.thrust);
  EXPECT_NEAR(reaction_of(spread, true).lift + reaction_of(spread, false).lift, rests.model.weight,
              2e-3 * rests.model.weight);
}

TEST(Compas, a_dome_stands) {
  std::vector<BodySpec> bodies = bodies_of("dome.obj", 1, [](const BodySpec&) { return false; });
  double low = lowest(bodies.front());
  for (const BodySpec& body : bodies) low = std::min(low, lowest(body));
  for (BodySpec& body : bodies) body.fixed = lowest(body) < low + 1e-3;
  const Outcome r = run(std::move(bodies), 0.7);
  EXPECT_EQ(r.result.status, SolveStatus::kCompleted) << r.result.reason;
  const Reaction left = reaction_of(r, false), right = reaction_of(r, true);
  EXPECT_NEAR((left.lift + right.lift) / r.model.weight, 1, 1e-3);
}

}  // namespace
}  // namespace wythe::compas_test
