// Arches of the builder against known results: the thinnest stable
// semicircle, and the forces of a flat arch; on spreading supports.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "geometry/assembly.h"
#include "scenes/rig.h"
#include "scenes/scenes.h"
#include "verification/record.h"
#include "wythe/parts/error.h"
#include "wythe/parts/limit.h"
#include "wythe/parts/reading.h"
#include "wythe/parts/solve.h"

namespace wythe::verification::arch_test {
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
  return {.name = "body force", .action = BodyForceStage{.rate = 0.1, .factor = 2}};
}

// A semicircle with `ratio` = thickness over mean radius. Friction is high, so the arch can only turn about hinges.
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

// --- an arch whose supports part -------------------------------------------------------------------------

constexpr double kMeanRadius = 1, kDepthOfArch = 0.2;
constexpr int kStonesOfArch = 10;

Vec2 at_ray(double radius, int ray) {
  const double angle = M_PI * ray / kStonesOfArch;
  return {radius * std::cos(angle), radius * std::sin(angle)};
}

// Stones 0 to 9 from the right to the left, a support each; the right one lies on the ground and can be driven.
ModelSpec arch_on_supports() {
  const double in = kMeanRadius - kDepthOfArch / 2, out = kMeanRadius + kDepthOfArch / 2;
  std::vector<BlockSpec> blocks;
  for (int k = 0; k < kStonesOfArch; ++k) {
    BlockSpec stone;
    stone.id = "stone" + std::to_string(k);
    for (const Vec2 p : {at_ray(in, k), at_ray(out, k), at_ray(out, k + 1), at_ray(in, k + 1)})
      stone.polygon.push_back({p.x, p.y});
    blocks.push_back(stone);
  }
  blocks.push_back(scenes::rectangle("right", kMeanRadius - 0.5, -0.2, 1, 0.2));
  blocks.push_back(scenes::rectangle("left", -kMeanRadius - 0.5, -0.2, 1, 0.2));
  blocks.back().fixed = true;
  blocks.push_back(scenes::rectangle("ground", -4, -0.4, 8, 0.2));
  blocks.back().fixed = true;
  ModelSpec spec = scenes::assembly(std::move(blocks), scenes::dry_joint(20e9, 10e9, degrees(45)),
                                    kThickness, kDensity);
  spec.solve.contacts = Contacts::kFree;
  spec.stage = {scenes::gravity_stage(), scenes::push_stage("right", Direction::kPlusX, 1, 1)};
  return spec;
}

// A symmetric arch of three hinges by rigid pieces (Ochsendorf 2006): hinges in the crown outside and, inside, at the
// joint of each haunch where the thrust is least at the start. As the supports part by s, the upper pieces turn about
// them; the rise between the hinges falls, and the thrust grows.
struct ThreeHinges {
  double in, out;  // radii on which hinges lie
  Vec2 haunch;
  int hinge = 0;  // joint of the haunch
  static constexpr int kCrown = kStonesOfArch / 2;

  explicit ThreeHinges(double depth) : in(kMeanRadius - depth / 2), out(kMeanRadius + depth / 2) {
    double most = 0;
    int first = 0;
    for (int joint = 0; joint < kCrown; ++joint) {
      hinge = joint, haunch = at_ray(in, joint);
      if (thrust(0) > most) most = thrust(0), first = joint;
    }
    hinge = first, haunch = at_ray(in, first);
  }

  // All stones weigh 1; their centroids lie on this radius (isosceles trapezoids).
  static Vec2 centroid(int stone) {
    const double half = M_PI / kStonesOfArch / 2, a = kMeanRadius - kDepthOfArch / 2,
                 b = kMeanRadius + kDepthOfArch / 2;
    const double radius = 2.0 / 3 * std::cos(half) * (a * a + a * b + b * b) / (a + b);
    return {radius * std::cos((2 * stone + 1) * half), radius * std::sin((2 * stone + 1) * half)};
  }
  [[nodiscard]] double rise(double s) const {
    const double wide = haunch.x + s / 2;
    return std::sqrt(haunch.x * haunch.x + (out - haunch.y) * (out - haunch.y) - wide * wide);
  }
  [[nodiscard]] double thrust(double s) const {
    const double turn =
        std::atan2(rise(s), -haunch.x - s / 2) - std::atan2(out - haunch.y, -haunch.x);
    double moment = 0;  // of the upper piece about its haunch
    for (int k = hinge; k < kCrown; ++k) {
      const Vec2 c = centroid(k);
      moment -= std::cos(turn) * (c.x - haunch.x) - std::sin(turn) * (c.y - haunch.y);
    }
    return moment / rise(s);
  }
  // About the outside of a foot the thrust overturns, and the weights of half the arch hold.
  [[nodiscard]] bool stands(double s) const {
    double holds = (kCrown - hinge) * (out - haunch.x);
    for (int k = 0; k < hinge; ++k) holds += out - centroid(k).x;
    return thrust(s) * haunch.y < holds;
  }
  [[nodiscard]] double spread_that_fells() const {
    double low = 0, high = 0.9 * 2 * (std::hypot(haunch.x, out - haunch.y) - haunch.x);
    while (high - low > 1e-9) {
      const double middle = (low + high) / 2;
      (stands(middle) ? low : high) = middle;
    }
    return low;
  }
};

// Supports part slowly: joints turn into free contacts at the hinges, the arch sinks as its hinges say, falls where
// its thrust leaves the feet, and lies in pieces on the ground.
TEST(Arch, CF30_on_supports_that_part_falls_where_its_hinges_say) {
  const ThreeHinges hinges(kDepthOfArch), inward(0.98 * kDepthOfArch);
  const double foreseen = hinges.spread_that_fells();
  scenes::Rig rig(compile(arch_on_supports()));
  rig.state.gravity_y = -kGravity;
  rig.settle(1e-6);
  rig.controls.damping = 0.3;
  const std::size_t stone = kStonesOfArch / 2, support = kStonesOfArch;  // beside the crown
  const auto parted = [&] { return rig.state.ux[support]; };
  const auto sunk = [&] {  // the outer corner of that stone in the crown
    const Vec2 c = ThreeHinges::centroid(kStonesOfArch / 2);
    const double x = -c.x, y = hinges.out - c.y;
    const double turn = rig.state.theta[stone];
    return -(rig.state.uy[stone] + std::sin(turn) * x + (std::cos(turn) - 1) * y);
  };
  rig.drive(1, 0.02);
  while (parted() < 0.8 * foreseen) rig.run(0.05);
  rig.drive(1, 0.002);
  while (parted() < 0.95 * foreseen) rig.run(0.05);
  const double sinks = hinges.rise(0) - hinges.rise(parted());
  EXPECT_NEAR(sunk(), sinks, inward.rise(0) - inward.rise(parted()) - sinks);
  while (parted() < 1.5 * foreseen && rig.state.vy[stone] > -0.05) rig.run(0.05);
  verify(
      {"CF30", "spread of its supports that fells a semicircular arch, t / R = 0.2", "m", foreseen,
       1 - inward.spread_that_fells() / foreseen, "hinges that lie 1 % of the depth further in"},
      parted());
  rig.drive(1, 0);
  rig.run(5);
  double motion = 0;
  for (std::size_t k = 0; k < kStonesOfArch; ++k) {
    const double height = ThreeHinges::centroid(static_cast<int>(k)).y + rig.state.uy[k];
    EXPECT_GT(height, -0.2) << "stone " << k << " is in the ground";
    EXPECT_LT(height, 0.6) << "stone " << k << " still stands";
    motion = std::fmax(motion, std::hypot(rig.state.vx[k], rig.state.vy[k]));
  }
  EXPECT_LT(motion, 1e-3);
  const EnergyLedger energy = rig.energy();
  EXPECT_LT(std::fabs(energy.gap), 1e-2 * rig.model.weight * hinges.out);
}

}  // namespace
}  // namespace wythe::verification::arch_test
