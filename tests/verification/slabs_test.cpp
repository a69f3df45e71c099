// Floor slabs as rigid bodies against closed forms: the shares of two walls in an eccentric
// load, the onset of sliding, and the overturning force of two walls tied by a slab.
#include <gtest/gtest.h>

#include <cmath>

#include "record.h"
#include "scenes/scenes.h"
#include "wythe/parts/io.h"
#include "wythe/parts/limit.h"
#include "wythe/parts/reading.h"
#include "wythe/parts/solve.h"

namespace wythe::slabs_test {
namespace {

using verification::verify;

constexpr double kG = 9.81, kDensity = 2000, kConcrete = 2500;
// Two walls of one block each, 1.2 m long along z, 0.3 m thick, 1.2 m high, 3 m apart; a slab 0.2 m thick on their tops.
constexpr double kLong = 1.2, kThick = 0.3, kHigh = 1.2, kClear = 2.7, kDeck = 0.2, kBearing = 0.15;

std::string two_walls(const std::string& more) {
  return R"(
[wall]
height = "1.2 m"
thickness = "0.3 m"
[wall.unit]
length = "1.2 m"
height = "1.2 m"
density = "2000 kg/m^3"
split = "none"
[[plan_wall]]
name = "left"
line = [["0 m", "0 m"], ["0 m", "1.2 m"]]
[[plan_wall]]
name = "right"
line = [["3 m", "0 m"], ["3 m", "1.2 m"]]
[material.concrete]
density = "2500 kg/m^3"
[material.joint]
normal_stiffness = "20 GPa/m"
shear_stiffness = "8 GPa/m"
tensile_strength = "0 MPa"
cohesion = "0 MPa"
residual_cohesion = "0 MPa"
friction_tan = 0.6
residual_friction_tan = 0.6
compressive_strength = "unlimited"
[[slab]]
name = "deck"
walls = ["left", "right"]
bearing = "150 mm"
thickness = "0.2 m"
material = "concrete"
)" + more;
}
constexpr const char* kGravity = R"(
[[stage]]
name = "gravity"
)";

struct Ran {
  Model model;
  State state;
  Result result;
};
Ran solved(const ModelSpec& spec) {
  Ran r{compile(spec), {}, {}};
  r.state = initial_state(r.model);
  r.result = solve(r.model, r.state);
  return r;
}
double compression_on(const Ran& r, const std::string& wall) {
  double sum = 0;
  for (const JointReading& joint : read_wall(r.model, r.state).joints) {
    const auto j = static_cast<std::size_t>(joint.shape.id);  // supports have numbers there
    const BodySpec &a = r.model.space.body[r.model.joint_a[j]],
                   &b = r.model.space.body[r.model.joint_b[j]];
    if ((a.id.starts_with(wall) && b.id == "deck") || (b.id.starts_with(wall) && a.id == "deck"))
      sum += joint.compression;
  }
  return sum;
}

constexpr double kWeight = (kClear + 2 * kBearing) * kLong * kDeck * kConcrete * kG;

// Rigid walls, elastic bearings of area A at x = -s and s: the slab sinks by w and turns by q, a bearing gives
// N = kn A (w -+ q s) and M = kn I q. So N = (W + F)/2 +- F e A s / (2 A s^2 + 2 I).
TEST(Slab, two_walls_share_an_eccentric_load_as_a_rigid_slab_on_elastic_bearings) {
  for (const double e : {0.0, 0.4, 0.9}) {
    ModelSpec spec = parse_model(two_walls(std::string(kGravity) + R"(
[[stage]]
name = "stack"
force = "6 kN"
at = { x = ")" + std::to_string(1.5 + e) + R"( m", y = "1.4 m", z = "0.6 m" }
[solve]
settle_ratio = 1e-8
)"),
                                 "two.toml");
    for (BodySpec& body : spec.body) body.fixed = body.role != "slab";
    const Ran r = solved(spec);
    ASSERT_EQ(r.result.status, SolveStatus::kCompleted);
    const double force = 6e3, s = 0.5 * (kClear + kBearing), area = kBearing * kLong,
                 second = kLong * std::pow(kBearing, 3) / 12;
    const double more = force * e * area * s / (2 * area * s * s + 2 * second);
    verify({"SL1",
            "slab on two walls, a load " + std::to_string(e).substr(0, 3) +
                " m off its middle: reaction",
            "N", 0.5 * (kWeight + force) + more, 1e-4, "settled; bearings keep their whole faces"},
           compression_on(r, "right"));
    verify({"SL1", "the same: reaction of the other wall", "N", 0.5 * (kWeight + force) - more,
            1e-4, "settled; bearings keep their whole faces"},
           compression_on(r, "left"));
  }
}

// The load on all of it becomes a floor of its name; both press, and both resist.
TEST(Slab, it_slides_at_friction_times_its_weight_and_load) {
  ModelSpec spec = parse_model(two_walls(std::string(R"(
load = "3 kPa"
)") + kGravity + R"(
[[stage]]
name = "push"
at = { role = "slab" }
direction = "+z"
velocity = "2 mm/s"
until = "2 mm"
)"),
                               "two.toml");
  for (BodySpec& body : spec.body) body.fixed = body.role != "slab";
  const Ran r = solved(spec);
  ASSERT_EQ(r.result.status, SolveStatus::kCompleted);
  const double load = 3e3 * (kClear + 2 * kBearing) * kLong;
  verify({"SL2", "force at which a slab slides on its walls", "N", 0.6 * (kWeight + load), 2e-3,
          "mean over a row; slow push"},
         r.result.responses.peak_reaction);
}

// Both walls turn to the left by the same angle about their left toes. On the left wall the slab rests on the inner corner,
// which rises by t; on the right one at its own end, which rises by b. So it tilts by (t - b)/(clear + b).
double force_to_push_over(double load) {
  const double wall = kLong * kThick * kHigh * kDensity * kG, deck = kWeight + load;
  const double tilt = (kThick - kBearing) / (kClear + kBearing);
  const double rise = kThick - tilt * 0.5 * kClear;  // of the slab's middle
  return (2 * wall * 0.5 * kThick + deck * rise) / (kHigh - tilt * 0.5 * kDeck);
}

TEST(Slab, two_walls_that_it_ties_fall_together_in_limit_analysis_and_under_a_push) {
  const std::string push = R"(
[[stage]]
name = "push"
at = { role = "slab" }
direction = "-x"
velocity = "2 mm/s"
until = "4 mm"
)";
  const ModelSpec spec =
      parse_model(two_walls(std::string("load = \"3 kPa\"\n") + kGravity + push), "two.toml");
  const double force = force_to_push_over(3e3 * (kClear + 2 * kBearing) * kLong);
  const LimitResult limit = limit_load(compile(spec), {});
  verify({"SL3", "limit load of two walls that a slab ties by friction", "N", force, 1e-6,
          "rigid; no joint slides"},
         limit.load);
  EXPECT_NEAR(limit.kinematic / limit.load, 1, 1e-6);
  const Ran r = solved(spec);
  ASSERT_EQ(r.result.status, SolveStatus::kCompleted);
  verify({"SL3", "the same, pushed", "N", force, 0.02,
          "elastic edges; the peak comes after some mm of lean"},
         r.result.responses.peak_reaction);
}

// --- shakes of a building with a slab that friction alone holds

// The acceleration of the base along +z grows from 0 to A within R (slowly for the springs of the joints: at once it would
// set the slab swinging, and let it go with the speed A/omega), stays for T, then the base goes on at its speed. A rigid
// slab that rests at friction mu goes along up to mu g. Beyond, with d = A - mu g, it lags from the moment R mu g/A on
//   in the rise   v = d S/2,   s = d S^2/6,   S = R (1 - mu g/A)
//   then          v + d T,     s + v T + d T^2/2
// and comes to the base's speed within v^2/(2 mu g) more.
constexpr double kFriction = 0.3, kRecordStep = 1e-3;
constexpr int kRise = 100, kStay = 160;  // steps of the record, then zeros; linear between
double slid_back(double acceleration) {
  const double holds = kFriction * kG, d = acceleration - holds;
  if (d <= 0) return 0;
  const double slips = kRise * kRecordStep * (1 - holds / acceleration),
               stays = (kStay + 0.5) * kRecordStep;
  const double v = d * slips / 2, end = v + d * stays;
  return d * slips * slips / 6 + v * stays + d * stays * stays / 2 + end * end / (2 * holds);
}

// The displacement of the slab relative to its walls at the end, and that of the walls on the ground [m].
struct Lag {
  double of_slab = 0, of_walls = 0;
};
Lag lag_of(double acceleration, bool walls_are_fixed) {
  std::string numbers;
  for (int k = 0; k <= 400; ++k) {
    const double share = k > kRise + kStay ? 0.0 : std::fmin(1.0, static_cast<double>(k) / kRise);
    numbers += (k > 0 ? ", " : "") + std::to_string(share * acceleration);
  }
  ModelSpec spec = parse_model(two_walls(R"(
joint = "bearing"
[material.bearing]
normal_stiffness = "20 GPa/m"
shear_stiffness = "8 GPa/m"
tensile_strength = "0 MPa"
cohesion = "0 MPa"
residual_cohesion = "0 MPa"
friction_tan = 0.3
residual_friction_tan = 0.3
compressive_strength = "unlimited"
)" + std::string(kGravity) + R"(
[[stage]]
name = "quake"
free_vibration = "0.4 s"
record = { step = "1 ms", unit = "m/s2", direction = "+z", accelerations = [)" +
                                         numbers + "] }\n"),
                               "two.toml");
  for (BodySpec& body : spec.body)
    if (walls_are_fixed) body.fixed = body.role != "slab";
  const Ran r = solved(spec);
  EXPECT_EQ(r.result.status, SolveStatus::kCompleted) << r.result.reason;
  Lag lag;
  for (BlockId b = 0; b < r.model.n_block; ++b) {
    const BlockReading now = read_block(r.model, r.state, b);
    (now.role == BlockRole::kSlab ? lag.of_slab : lag.of_walls) = now.moved.z;
  }
  lag.of_slab -= lag.of_walls;
  return lag;
}

TEST(Slab, a_slab_that_only_rests_slides_in_a_shake_from_mu_g_on) {
  EXPECT_NEAR(lag_of(0.97 * kFriction * kG, true).of_slab, 0, 2e-5);
  for (const double ratio : {1.1, 1.5}) {
    const double acceleration = ratio * kFriction * kG;
    verify({"SL4",
            "slab on fixed walls, base at " + std::to_string(ratio).substr(0, 3) +
                " mu g: it slides back by",
            "m", slid_back(acceleration), 0.01, "an elastic start of some microns; step of time"},
           -lag_of(acceleration, true).of_slab);
  }
}

// Walls that stand on friction of 0.6 and rock from g/2 on, had they no slab on them: they go with the base.
TEST(Slab, on_walls_that_stand_free_it_slides_as_on_fixed_ones) {
  const double acceleration = 1.2 * kFriction * kG;
  const Lag lag = lag_of(acceleration, false);
  verify({"SL4", "slab on free walls, base at 1.2 mu g: it slides back by", "m",
          slid_back(acceleration), 0.03, "walls that sway on their feet"},
         -lag.of_slab);
  EXPECT_LT(std::fabs(lag.of_walls), 2e-4);
}

}  // namespace
}  // namespace wythe::slabs_test
