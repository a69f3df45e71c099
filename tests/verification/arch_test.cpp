// Arches of the builder against what is known of them: the thinnest semicircle that stands, and the forces of a flat
// arch.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "geometry/assembly.h"
#include "scenes/scenes.h"
#include "verification/record.h"
#include "wythe/error.h"
#include "wythe/limit.h"
#include "wythe/reading.h"
#include "wythe/solve.h"

namespace wythe::verification {
namespace {

using scenes::degrees;

constexpr double kDensity = 2000, kThickness = 0.3, kGravity = 9.81;

std::vector<std::array<double, 2>> corners_of(const std::vector<Vec2>& outline) {
  std::vector<std::array<double, 2>> corners;
  for (const Vec2& p : outline) corners.push_back({p.x, p.y});
  return corners;
}

// A fixed stone behind an end joint, on the side where x is less (-1) or more (1).
BlockSpec abutment(const std::string& id, std::array<double, 2> p, std::array<double, 2> q,
                   double away_x, double away_y) {
  BlockSpec block;
  block.id = id;
  block.polygon = {p, q, {q[0] + away_x, q[1] + away_y}, {p[0] + away_x, p[1] + away_y}};
  block.fixed = true;
  return block;
}

// The voussoirs that the builder lays over an opening of this span, between fixed end joints, and nothing else.
ModelSpec bare_arch(const ArchSpec& arch, double span, double friction_angle) {
  ModelSpec wall;
  wall.wall.length = span + 3;
  wall.wall.height = span + 2;
  wall.wall.thickness = kThickness;
  wall.wall.fit = Fit::kCut;
  wall.wall.unit.length = 0.2;
  wall.wall.unit.height = 0.1;
  wall.wall.unit.density = kDensity;
  wall.wall.unit.split = Split::kNone;
  wall.material["joint"] = {};
  OpeningSpec opening;
  opening.x = 1.5;
  opening.y = 0;
  opening.width = span;
  opening.height = 0.5;
  opening.arch = arch;
  wall.wall.opening = {opening};
  FaultList faults;
  const geometry::Assembly laid = geometry::build_assembly(wall, faults);
  faults.throw_if_any();
  std::vector<BlockSpec> blocks;
  for (const geometry::Block& block : laid.blocks) {
    if (!geometry::is_voussoir(block)) continue;
    blocks.push_back({.id = block.id, .polygon = corners_of(block.outline), .zone = {}});
  }
  std::sort(blocks.begin(), blocks.end(), [](const BlockSpec& a, const BlockSpec& b) {
    return a.polygon[0][0] + a.polygon[1][0] < b.polygon[0][0] + b.polygon[1][0];
  });
  const auto left = blocks.front().polygon, right = blocks.back().polygon;
  const bool is_round = arch.kind == ArchKind::kRound;
  const double x = is_round ? 0 : 1, y = is_round ? -1 : 0;
  blocks.push_back(abutment("left", left[0], left[3], -x, y));
  blocks.push_back(abutment("right", right[1], right[2], x, y));
  return scenes::assembly(std::move(blocks), scenes::dry_joint(20e9, 8e9, friction_angle),
                          kThickness, kDensity);
}

StageSpec body_force() {
  StageSpec stage;
  stage.name = "body force";
  stage.kind = StageKind::kBodyForce;
  stage.rate = 0.1;
  stage.factor = 2;
  return stage;
}

// Of `ratio` = thickness over mean radius. Friction is high, so that the arch can only turn about hinges.
ModelSpec semicircle(double ratio, int voussoirs) {
  ArchSpec arch;
  arch.kind = ArchKind::kRound;
  arch.depth = ratio / (1 - ratio / 2);  // the intrados has 1 m
  arch.voussoirs = voussoirs;
  return bare_arch(arch, 2, degrees(70));
}

bool carries_itself(double ratio, int voussoirs) {
  ModelSpec spec = semicircle(ratio, voussoirs);
  spec.stage = {scenes::gravity_stage(), body_force()};
  try {
    (void)limit_load(compile(spec), {});
    return true;
  } catch (const InputError& error) {
    const std::string said = error.what();
    EXPECT_NE(said.find("cannot"), std::string::npos) << said;
    return false;
  }
}

// Milankovitch 1907; Cocchetti, Colasante, Rizzi 2011: 0.1075 where joints are radial and everywhere. Voussoirs have
// straight sides, and hinges only between them: both fade with their number.
TEST(Arch, CF29_thinnest_semicircle_that_stands) {
  constexpr int kVoussoirs = 120;
  double falls = 0.08, stands = 0.13;
  ASSERT_FALSE(carries_itself(falls, kVoussoirs));
  ASSERT_TRUE(carries_itself(stands, kVoussoirs));
  while (stands - falls > 1e-5) {
    const double middle = (falls + stands) / 2;
    (carries_itself(middle, kVoussoirs) ? stands : falls) = middle;
  }
  verify({"CF29", "least thickness of a semicircular arch under its weight over its mean radius",
          "-", 0.1075, 0.002, "published to four digits; 120 voussoirs with straight sides"},
         (falls + stands) / 2);
}

SolveStatus status_of(ModelSpec spec) {
  spec.stage = {scenes::gravity_stage()};
  const Model model = compile(spec);
  State state = initial_state(model);
  return solve(model, state).status;
}

TEST(Arch, a_run_of_a_semicircle_stands_or_falls_on_either_side_of_the_limit) {
  EXPECT_EQ(status_of(semicircle(0.12, 30)), SolveStatus::kCompleted);
  EXPECT_NE(status_of(semicircle(0.095, 30)), SolveStatus::kCompleted);
}

// Self-weight W, thrust H the same in every joint, W/2 down on each skewback.
TEST(Arch, a_flat_arch_stands_by_its_thrust) {
  ArchSpec arch;
  arch.kind = ArchKind::kFlat;
  arch.depth = 0.3;
  arch.skewback = degrees(15);
  arch.voussoirs = 9;
  ModelSpec spec = bare_arch(arch, 1.2, degrees(35));
  spec.stage = {scenes::gravity_stage()};
  const Model model = compile(spec);
  State state = initial_state(model);
  ASSERT_EQ(solve(model, state).status, SolveStatus::kCompleted);
  const double weight =
      kDensity * kGravity * kThickness * 0.3 * (1.2 + 0.3 * std::tan(degrees(15)));
  double held = 0, least = 1e300, most = 0;
  for (const JointReading& joint : read_wall(model, state).joints) {
    // on b: a joint keeps the force on a
    const Vec3 force = joint.compression * joint.shape.normal + (-joint.shear) * joint.shape.along;
    const double thrust = std::fabs(force.x);
    least = std::min(least, thrust);
    most = std::max(most, thrust);
    if (joint.shape.a == kGroundBlock) held += std::fabs(force.y);
  }
  EXPECT_NEAR(held / weight, 1, 1e-3);
  EXPECT_NEAR(least / most, 1, 1e-3);
  // the thrust line stays in the depth: half the weight acts at a quarter of the span from the skewback
  EXPECT_GT(most, weight / 2 * 1.2 / 4 / 0.3 * 0.9);
  // the crown sinks straight down
  for (BlockId b = 0; b < model.n_block; ++b) {
    const BlockReading middle = read_block(model, state, b);
    if (std::fabs(middle.start.x - 2.1) > 1e-6) continue;
    EXPECT_LT(middle.moved.y, 0);
    EXPECT_LT(std::fabs(middle.moved.x), 1e-2 * std::fabs(middle.moved.y));
  }
}

// The same where the masonry around is cut to the arch: what gravity does mirrors itself.
TEST(Arch, a_symmetric_wall_with_an_arch_settles_symmetrically) {
  for (const ArchKind kind : {ArchKind::kFlat, ArchKind::kSegmental, ArchKind::kRound}) {
    ModelSpec spec = scenes::plain_wall(12, 14, 1e-3, 0.02);
    spec.stage.resize(1);
    OpeningSpec opening;
    opening.x = 4 * 0.155;
    opening.y = 0;
    opening.width = 4 * 0.155;
    opening.height = 6 * 0.11;
    opening.arch.kind = kind;
    opening.arch.depth = 0.2;
    if (kind == ArchKind::kFlat) opening.arch.skewback = degrees(15);
    if (kind == ArchKind::kSegmental) opening.arch.rise = 0.1;
    spec.wall.opening = {opening};
    const Model model = compile(spec);
    State state = initial_state(model);
    ASSERT_EQ(solve(model, state).status, SolveStatus::kCompleted);
    const WallReading wall = read_wall(model, state);
    double largest = 0;
    for (const BlockReading& block : wall.blocks) largest = std::max(largest, length(block.moved));
    for (const BlockReading& block : wall.blocks) {
      const auto twin =
          std::find_if(wall.blocks.begin(), wall.blocks.end(), [&](const auto& other) {
            return std::fabs(other.start.x + block.start.x - 12 * 0.155) < 1e-6 &&
                   std::fabs(other.start.y - block.start.y) < 1e-6;
          });
      ASSERT_NE(twin, wall.blocks.end()) << "at " << block.start.x << ", " << block.start.y;
      EXPECT_NEAR(twin->moved.x, -block.moved.x, 0.01 * largest);
      EXPECT_NEAR(twin->moved.y, block.moved.y, 0.01 * largest);
    }
  }
}

}  // namespace
}  // namespace wythe::verification
