// Earthquakes: an oscillator under a pulse, damping, bouncing, Housner's block, overturning by a pulse.
#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "model/shaking.h"
#include "scenes/rig.h"
#include "scenes/scenes.h"
#include "verification/held_wall.h"
#include "verification/record.h"
#include "wythe/parts/solve.h"

namespace wythe::verification::shaking_test {
namespace {

using scenes::box;
using scenes::degrees;
using scenes::Rig;

constexpr double kG = 9.81;

StageSpec plain_shake() { return {.name = "quake", .action = ShakeStage{}}; }
RecordSpec pulse(PulseShape shape, double amplitude, double period,
                 Direction direction = Direction::kPlusX) {
  RecordSpec record;
  record.pulse = shape;
  record.amplitude = amplitude;
  record.period = period;
  record.direction = direction;
  return record;
}
// Nothing moves the base for so long.
RecordSpec stillness(double seconds) { return pulse(PulseShape::kCycle, 0, seconds); }

// --- an oscillator: 20 kg on an upright spring, 0.2 s ------------------------------------------------------

constexpr double kPeriod = 0.2, kOmega = 2 * M_PI / kPeriod;

ModelSpec oscillator() {
  const double stiffness = 20 * kOmega * kOmega / 0.03;
  ModelSpec spec = scenes::block_on_ground(
      0.1, 0.3, scenes::elastic_joint(stiffness, 0.4 * stiffness), 0.3, 20 / 0.009);
  spec.stage = {scenes::gravity_stage()};
  spec.solve.step_fraction = 0.02;  // some 200 steps a period
  return spec;
}

struct Shaken {
  Model model;
  State state;
  Result result;
};
Shaken shaken(const ModelSpec& spec) {
  Shaken s{compile(spec), {}, {}};
  s.state = initial_state(s.model);
  s.result = solve(s.model, s.state);
  return s;
}

TEST(Shaking, an_oscillator_under_half_a_sine_moves_as_in_closed_form) {
  constexpr double kAmplitude = 2, kPulse = 0.3;  // period of the sine: it lasts 0.75 T
  ModelSpec spec = oscillator();
  StageSpec shake = plain_shake();
  shake.get<ShakeStage>().record = {
      pulse(PulseShape::kHalfCycle, kAmplitude, kPulse, Direction::kPlusY)};
  shake.get<ShakeStage>().free_vibration = 0.3;
  shake.get<ShakeStage>().interval = 1e-3;
  spec.stage.push_back(shake);
  const Shaken s = shaken(spec);
  ASSERT_EQ(s.result.status, SolveStatus::kCompleted) << s.result.reason;
  const double w = 2 * M_PI / kPulse, b = w / kOmega, scale = kAmplitude / (kOmega * kOmega);
  const auto during = [&](double t) {
    return -scale / (1 - b * b) * (std::sin(w * t) - b * std::sin(kOmega * t));
  };
  const auto rate = [&](double t) {
    return -scale / (1 - b * b) * (w * std::cos(w * t) - b * kOmega * std::cos(kOmega * t));
  };
  const double end = 0.5 * kPulse;
  const double largest = std::hypot(during(end), rate(end) / kOmega);
  double off = 0, peak = 0;
  const double rest = s.result.history.motion.front()[1];
  for (std::size_t k = 0; k < s.result.history.row.size(); ++k) {
    const double t = s.result.history.row[k].time;
    const double moved = s.result.history.motion[k][1] - rest;
    const double wanted = t < end ? during(t)
                                  : during(end) * std::cos(kOmega * (t - end)) +
                                        rate(end) / kOmega * std::sin(kOmega * (t - end));
    off = std::fmax(off, std::fabs(moved - wanted));
    if (t > end) peak = std::fmax(peak, std::fabs(moved));
  }
  verify({"SH01", "oscillator under half a sine: amplitude after it", "m", largest, 3e-3,
          "(omega dt)^2/24 of the frequency, rows each millisecond or so"},
         peak);
  verify({"SH01", "oscillator under half a sine: largest error over time", "of its amplitude", 0,
          1e-2, "phase by dt/2 and (omega dt)^2/24 over two periods", true},
         off / largest);
}

// Amplitudes of free vibration, one at each turn; damped as `shake` says.
double decrement(const StageSpec& shake) {
  ModelSpec spec = oscillator();
  spec.stage.push_back(shake);
  const Model model = compile(spec);
  Rig rig(compile(spec));
  const Stage& stage = rig.model.stages.back();
  rig.controls.dt *= std::sqrt(1 + rig.controls.damping);
  const double xi = 0.5 * stage.dashpots.rate / rig.model.omega_max;
  rig.controls.dt *= std::sqrt(1 + xi * xi) - xi;
  rig.state.gravity_y = -kG;
  rig.settle(1e-12);
  const double rest = rig.state.uy[0];
  rig.controls.damping = 0;
  const ViscousSpec& damping = shake.get<ShakeStage>().mass_damping;
  if (std::isfinite(damping.fraction))
    rig.controls.mass_damping = 4 * M_PI * damping.fraction * damping.frequency;
  if (!stage.dashpots.normal.empty()) rig.controls.dashpots = &stage.dashpots;
  rig.state.vy[0] = 0;
  rig.state.uy[0] = rest + 1e-3;
  std::vector<double> turns;
  double before = rig.state.uy[0];
  bool falls = true;
  while (turns.size() < 11) {
    rig.step();
    const double now = rig.state.uy[0];
    if ((now < before) != falls) {
      falls = !falls;
      turns.push_back(std::fabs(before - rest));
    }
    before = now;
  }
  return std::log(turns[0] / turns[10]) / 5;
}

TEST(Shaking, damping_has_the_stated_fraction_at_the_stated_frequency) {
  constexpr double kFraction = 0.05;
  const double wanted = 2 * M_PI * kFraction / std::sqrt(1 - kFraction * kFraction);
  StageSpec by_mass = plain_shake(), by_joints = by_mass;
  by_mass.get<ShakeStage>().record = by_joints.get<ShakeStage>().record = {stillness(1)};
  by_mass.get<ShakeStage>().mass_damping =
      by_joints.get<ShakeStage>().joint_damping = {kFraction, 1 / kPeriod};
  verify({"SH02", "damping by mass: logarithmic decrement", "-", wanted, 1e-2,
          "turns are read at steps"},
         decrement(by_mass));
  verify({"SH02", "dashpots at joints: logarithmic decrement", "-", wanted, 1e-2,
          "turns are read at steps"},
         decrement(by_joints));
}

TEST(Shaking, damping_by_mass_halves_where_the_frequency_doubles) {
  StageSpec by_mass = plain_shake();
  by_mass.get<ShakeStage>().record = {stillness(1)};
  by_mass.get<ShakeStage>().mass_damping = {0.05, 0.5 / kPeriod};
  EXPECT_NEAR(decrement(by_mass), 2 * M_PI * 0.025, 0.02 * 2 * M_PI * 0.025);
}

// The note on what a wall of this shake gets; nullptr where it gets what was asked.
const Message* obtained_of(const Model& model) {
  for (const Message& note : model.anatomy.notes)
    if (note.code == "shake.damping_obtained") return &note;
  return nullptr;
}

TEST(Shaking, a_fraction_that_the_wall_does_not_get_is_told_as_the_decrement_shows_it) {
  StageSpec shake = plain_shake();
  shake.get<ShakeStage>().record = {pulse(PulseShape::kCycle, 0.1, 0.1, Direction::kPlusY)};
  for (const auto member :
       {&ShakeStage::mass_damping, &ShakeStage::joint_damping, &ShakeStage::maxwell_damping}) {
    shake.get<ShakeStage>().*member = {0.02, 1 / kPeriod};
    ModelSpec spec = oscillator();
    spec.stage.push_back(shake);
    EXPECT_EQ(obtained_of(compile(spec)), nullptr);
    (shake.get<ShakeStage>().*member).frequency = 3 / kPeriod;
    spec.stage.back() = shake;
    const Model model = compile(spec);
    const Message* note = obtained_of(model);
    ASSERT_NE(note, nullptr);
    const double xi = 1e-2 * note->number("obtained_percent");
    const double shown =
        member == &ShakeStage::maxwell_damping ? 0.02 * 0.6 : decrement(shake) / (2 * M_PI);
    EXPECT_NEAR(xi, shown, 0.02 * xi);
    EXPECT_NEAR(note->number("frequency_hz"), 1 / kPeriod, 1e-3 / kPeriod);
    shake.get<ShakeStage>().*member = {};
  }
  shake.get<ShakeStage>().mass_damping = {0.02, 1 / kPeriod};
  shake.get<ShakeStage>().joint_damping = {0.02, 1 / kPeriod};
  ModelSpec both = oscillator();
  both.stage.push_back(shake);
  const Model model = compile(both);
  ASSERT_NE(obtained_of(model), nullptr) << "two kinds give twice what each of them says";
}

TEST(Shaking, a_wall_in_space_is_told_what_its_plane_picture_is) {
  StageSpec shake = plain_shake();
  shake.get<ShakeStage>().record = {pulse(PulseShape::kCycle, 0.1, 0.1)};
  shake.get<ShakeStage>().mass_damping = {0.02, 1};
  ModelSpec plane = scenes::plain_wall(4, 6, 1e-3, 0.02);
  plane.stage = {scenes::gravity_stage(), shake};
  const Message* in_plane = nullptr;
  const Message* in_space = nullptr;
  const Model flat = compile(plane), solid = compile(scenes::prisms(plane));
  ASSERT_NE(in_plane = obtained_of(flat), nullptr);
  ASSERT_NE(in_space = obtained_of(solid), nullptr);
  EXPECT_NEAR(in_space->number("frequency_hz"), in_plane->number("frequency_hz"),
              1e-3 * in_plane->number("frequency_hz"));
  EXPECT_NEAR(in_space->number("obtained_percent"), in_plane->number("obtained_percent"),
              1e-3 * in_plane->number("obtained_percent"));
}

// --- bouncing ---------------------------------------------------------------------------------------------

double rebound(double restitution) {
  ModelSpec spec =
      scenes::block_on_ground(0.4, 0.2, scenes::dry_joint(2e10, 8e9, degrees(40)), 0.2, 2000);
  StageSpec shake = plain_shake();
  shake.get<ShakeStage>().record = {stillness(1)};
  shake.get<ShakeStage>().restitution = restitution;
  spec.stage = {scenes::gravity_stage(), shake};
  Rig rig(compile(spec));
  const Stage& stage = rig.model.stages.back();
  const double xi = 0.5 * stage.dashpots.rate / rig.model.omega_max;
  rig.controls.dt = 0.1 * 2 / rig.model.omega_max * (std::sqrt(1 + xi * xi) - xi);
  rig.controls.damping = 0;
  if (!stage.dashpots.normal.empty()) rig.controls.dashpots = &stage.dashpots;
  rig.state.gravity_y = -kG;
  rig.state.uy[0] = 0.1;
  double before = 0.1;
  while (rig.state.uy[0] > 0) rig.step();
  do {
    before = rig.state.uy[0];
    rig.step();
  } while (rig.state.uy[0] > before || before < 0);
  const EnergyLedger energy = rig.energy();
  EXPECT_LT(std::fabs(energy.gap), 5e-3 * rig.model.weight * 0.1) << restitution;
  return before / 0.1;
}

TEST(Shaking, a_block_that_falls_flat_comes_back_with_its_restitution) {
  for (const double e : {1.0, 0.8, 0.5, 0.2})
    verify({"SH03", fmt::format("block dropped flat, restitution {:g}: height of the rebound", e),
            "of the fall", e * e, 1e-2,
            "steps of a tenth of the longest: where contact begins and ends within one; gravity",
            true},
           rebound(e));
}

// --- Housner's block ------------------------------------------------------------------------------------------

struct Rocking {
  double b, h;  // half of width and height
  [[nodiscard]] double alpha() const { return std::atan(b / h); }
  [[nodiscard]] double radius() const { return std::hypot(b, h); }
  [[nodiscard]] double p() const { return std::sqrt(0.75 * kG / radius()); }
  // 1 - 3/2 sin^2 alpha: of the rates of rotation, after over before
  [[nodiscard]] double housner() const { return 1 - 1.5 * std::pow(std::sin(alpha()), 2); }
};

ModelSpec rocking_spec(const Rocking& r, double stiffness, double restitution) {
  ModelSpec spec = scenes::block_on_ground(
      2 * r.b, 2 * r.h, scenes::dry_joint(stiffness, 0.4 * stiffness, degrees(80)), 1.0, 2000);
  spec.solve.point_rule = PointRule::kCorners;
  spec.solve.points_per_face = 2;
  StageSpec shake = plain_shake();
  shake.get<ShakeStage>().record = {stillness(1)};
  shake.get<ShakeStage>().restitution = restitution;
  spec.stage = {scenes::gravity_stage(), shake};
  return spec;
}

// Turned by theta (+ to the left, about the left toe) at rest.
void tilt(Rig& rig, const Rocking& r, double theta, double stiffness) {
  const double sink = rig.model.weight / (stiffness * 0.5 * rig.model.area[0]);
  const double c = std::cos(theta), s = std::sin(theta);
  const double rx = theta > 0 ? -r.b : r.b, ry = -r.h;
  rig.state.ux[0] = rx - (c * rx - s * ry);
  rig.state.uy[0] = ry - (s * rx + c * ry) - sink;
  rig.state.theta[0] = theta;
}

// Energy after the first impact over that before, from the tilt at which the block turns back.
double kept_at_impact(const Rocking& r, double stiffness, double start) {
  Rig rig(compile(rocking_spec(r, stiffness, 0)));
  const Stage& stage = rig.model.stages.back();
  const double xi = 0.5 * stage.dashpots.rate / rig.model.omega_max;
  rig.controls.dt = 0.95 * 2 / rig.model.omega_max * (std::sqrt(1 + xi * xi) - xi);
  rig.controls.damping = 0;
  rig.controls.dashpots = &stage.dashpots;
  rig.state.gravity_y = -kG;
  const double theta0 = start * r.alpha();
  tilt(rig, r, theta0, stiffness);
  double furthest = 0;
  while (rig.state.theta[0] > 0) rig.step();
  do {
    furthest = rig.state.theta[0];
    for (int k = 0; k < 20; ++k) rig.step();
  } while (rig.state.theta[0] < furthest);
  const auto height = [&](double theta) {
    return std::cos(r.alpha() - std::fabs(theta)) - std::cos(r.alpha());
  };
  return height(furthest) / height(theta0);
}

TEST(Shaking, an_impact_takes_the_energy_that_housner_says) {
  for (const double slenderness : {2.0, 4.0, 6.0, 8.0}) {
    const Rocking r{0.25, 0.25 * slenderness};
    const double e = r.housner();
    verify({"SH04",
            fmt::format("rocking block, h/b {:g}, restitution 0: energy kept by an impact",
                        slenderness),
            "-", e * e, 3e-2, "impacts on springs are not instantaneous"},
           kept_at_impact(r, 1e11, 0.5));
  }
}

// --- rocking under a pulse, beside the rocking equation ---------------------------------------------------------

// Housner's equation by Runge and Kutta, with his loss at each impact; the largest tilt over alpha, 9 where the
// block overturns. Anticlockwise is positive, about the left corner, which a base that goes to the right asks for.
double rocked(const Rocking& r, const GroundMotion& base, double seconds) {
  const double p2 = r.p() * r.p(), alpha = r.alpha(), e = r.housner(), h = 2e-4;
  double theta = 0, rate = 0, most = 0;
  const auto pull = [&](double t, double at, double side) {
    const double a = base.acceleration_at(t) / kG;
    return p2 * (a * std::cos(alpha * side - at) - std::sin(alpha * side - at));
  };
  double side = 0;  // at rest
  for (double t = 0; t < seconds; t += h) {
    if (side == 0) {
      const double a = base.acceleration_at(t + h) / kG;
      if (std::fabs(a) <= std::tan(alpha)) continue;
      side = a > 0 ? 1 : -1;
    }
    const double k1 = pull(t, theta, side), k2 = pull(t + h / 2, theta + h / 2 * rate, side);
    const double k3 = pull(t + h / 2, theta + h / 2 * rate + h * h / 4 * k1, side);
    const double k4 = pull(t + h, theta + h * rate + h * h / 2 * k2, side);
    theta += h * rate + h * h / 6 * (k1 + k2 + k3);
    rate += h / 6 * (k1 + 2 * k2 + 2 * k3 + k4);
    if (theta * side < 0) {
      theta = 0;
      rate *= e;
      side = -side;
      if (std::fabs(rate) < 1e-3 * r.p() * alpha) side = rate = 0;
    }
    most = std::fmax(most, std::fabs(theta) / alpha);
    if (std::fabs(theta) > M_PI / 2) return 9;
  }
  return most;
}

constexpr double kWatched = 4;  // after the pulse [s]

// The same by the engine.
double shaken_tilt(const Rocking& r, const RecordSpec& record, double stiffness) {
  ModelSpec spec = rocking_spec(r, stiffness, 0);
  spec.stage.back().get<ShakeStage>().record = {record};
  spec.stage.back().get<ShakeStage>().free_vibration = kWatched;
  HistorySpec corner;
  corner.name = "corner";
  corner.at.x = 0, corner.at.y = 2 * r.h;  // of the top
  spec.history = {corner};
  const Shaken s = shaken(spec);
  if (s.result.status == SolveStatus::kCollapsed) return 9;
  EXPECT_EQ(s.result.status, SolveStatus::kCompleted) << s.result.reason;
  EXPECT_LT(s.result.energy.gap_ratio, 1e-2);
  // of the tilts to either side; the corner moves by 2h sin(theta) and a little more
  double most = 0;
  for (const PointMotion& u : s.result.history.motion) most = std::fmax(most, std::fabs(u[0]));
  return std::asin(most / (2 * r.h)) / r.alpha();
}

TEST(Shaking, half_a_sine_overturns_a_block_where_the_rocking_equation_says) {
  const Rocking r{0.25, 1.0};
  constexpr double kPulse = 0.8, kMargin = 0.03;
  const auto falls = [&](double amplitude) {
    const RecordSpec record = pulse(PulseShape::kHalfCycle, amplitude, kPulse);
    ModelSpec spec = rocking_spec(r, 1e10, 0);
    spec.stage.back().get<ShakeStage>().record = {record};
    return rocked(r, compile(spec).stages.back().base.front(), kWatched) == 9;
  };
  double low = 0, high = 40;
  ASSERT_TRUE(falls(high));
  for (int k = 0; k < 30; ++k) (falls(0.5 * (low + high)) ? high : low) = 0.5 * (low + high);
  EXPECT_NE(shaken_tilt(r, pulse(PulseShape::kHalfCycle, (1 - kMargin) * low, kPulse), 1e10), 9);
  EXPECT_EQ(shaken_tilt(r, pulse(PulseShape::kHalfCycle, (1 + kMargin) * high, kPulse), 1e10), 9);
}

// A single history tells little: near overturning a thousandth of the amplitude decides. So over many pulses.
TEST(Shaking, rocking_under_many_pulses_is_that_of_the_rocking_equation) {
  const Rocking r{0.25, 1.0};
  int runs = 0, differ = 0;
  double sum = 0, squares = 0;
  for (const double period : {0.4, 0.6, 0.9})
    for (const double over : {1.3, 1.6, 2.0, 2.4, 2.8, 3.2}) {
      const RecordSpec record = pulse(PulseShape::kCycle, over * kG * 0.25, period);
      ModelSpec spec = rocking_spec(r, 1e10, 0);
      spec.stage.back().get<ShakeStage>().record = {record};
      const double wanted = rocked(r, compile(spec).stages.back().base.front(), period + kWatched);
      const double tilt = shaken_tilt(r, record, 1e10);
      ++runs;
      if ((wanted == 9) != (tilt == 9)) ++differ;
      if (wanted == 9 || tilt == 9) continue;
      const double ratio = std::log(tilt / wanted);
      sum += ratio, squares += ratio * ratio;
    }
  EXPECT_LE(differ, 1) << "of " << runs;
  verify({"SH06", "rocking block under 18 pulses: mean logarithm of peak tilt over the equation's",
          "-", 0, 3e-2, "springs under the corners; slip and hops of the block", true},
         sum / runs);
  verify({"SH06", "the same: root of the mean square", "-", 0, 6e-2,
          "springs under the corners; slip and hops of the block", true},
         std::sqrt(squares / runs));
}

// --- a wall held at its top that cracks at half height (held_wall.h) ------------------------------------------

TEST(Shaking, a_wall_held_at_its_top_bends_as_two_rocking_bodies) {
  const HeldWall w{0.12, 1.5};
  int runs = 0, differ = 0;
  double sum = 0, squares = 0;
  for (const double period : {0.2, 0.3, 0.4})
    for (const double over : {1.3, 1.6, 2.0, 2.5, 3.0}) {
      const RecordSpec record = pulse(PulseShape::kCycle, over * w.uplift(), period);
      ModelSpec spec = oscillator();
      StageSpec shake = plain_shake();
      shake.get<ShakeStage>().record = {record};
      spec.stage = {scenes::gravity_stage(), shake};
      const double wanted = bent(w, compile(spec).stages.back().base.front(), period + 2);
      const double found = shaken_bend(w, record, 4e10);
      ++runs;
      if ((wanted == 9) != (found == 9)) ++differ;
      if (wanted == 9 || found == 9) continue;
      const double ratio = std::log(found / wanted);
      sum += ratio, squares += ratio * ratio;
    }
  EXPECT_LE(differ, 1) << "of " << runs;
  verify(
      {"SH07", "wall held at its top under 15 pulses: mean logarithm of the peak over two bodies'",
       "-", 0, 3e-2, "springs in the hinges and at the top", true},
      sum / runs);
  verify({"SH07", "the same: root of the mean square", "-", 0, 8e-2,
          "springs in the hinges and at the top; restitution 0.05 where it says 0", true},
         std::sqrt(squares / runs));
}

// --- drifts of storeys ------------------------------------------------------------------------------------

// One flat stone a storey, each 0.1 m high; between them friction of tangent 0.2, below them none slides.
ModelSpec stones_of_storeys(int storeys) {
  ModelSpec spec;
  spec.wall.length = 2;
  spec.wall.thickness = 0.3;
  spec.wall.unit.length = 2;
  spec.wall.unit.height = 0.1;
  spec.wall.unit.density = 2000;
  spec.wall.unit.split = Split::kNone;
  spec.material["joint"] = scenes::dry_joint(1e10, 4e9, std::atan(0.2));
  spec.material["rough"] = scenes::dry_joint(1e10, 4e9, std::atan(2.0));
  for (int k = 0; k < storeys; ++k) {
    StoreySpec storey;
    storey.name = k == 0 ? "ground" : "first";
    storey.height = 0.1;
    storey.unit.split = Split::kNone;
    if (k == 0) storey.joints.joint = "rough";
    spec.storey.push_back(storey);
  }
  StageSpec shake = plain_shake();
  RecordSpec record;
  record.unit = RecordUnit::kMetres;
  record.times = {0, 1e-6, 0.2, 0.2 + 1e-6};
  record.accelerations = {0, 4, 4, 0};
  shake.get<ShakeStage>().record = {record};
  shake.get<ShakeStage>().free_vibration = 0.5;
  spec.stage = {scenes::gravity_stage(), shake};
  return spec;
}

// The drift of a stone that does not slide is elastic: m a / (k_s A), and twice that if the base starts at once.
TEST(Shaking, a_stiff_storey_on_a_shaken_base_has_no_drift) {
  const Shaken s = shaken(stones_of_storeys(1));
  ASSERT_EQ(s.result.status, SolveStatus::kCompleted) << s.result.reason;
  ASSERT_EQ(s.result.shaking.storey.size(), 1U);
  const double elastic = 2 * (2000 * 0.1) * 4 / 4e9 / 0.1;
  EXPECT_LT(s.result.shaking.storey[0].peak, 1.1 * elastic);
  EXPECT_LT(s.result.shaking.storey[0].residual, elastic);
}

// The upper stone slides as Newmark's block, a T^2/2 (a/(mu g) - 1), backwards; that is the drift of its storey, and the
// ground storey has none.
TEST(Shaking, the_storey_whose_stone_slides_has_the_drift) {
  const Shaken s = shaken(stones_of_storeys(2));
  ASSERT_EQ(s.result.status, SolveStatus::kCompleted) << s.result.reason;
  const ShakeReadings& r = s.result.shaking;
  ASSERT_EQ(r.storey.size(), 2U);
  EXPECT_EQ(r.storey[0].storey, "ground");
  EXPECT_EQ(r.storey[1].storey, "first");
  const double way = 0.5 * 4 * 0.04 * (4 / (0.2 * kG) - 1), drift = way / 0.1;
  EXPECT_NEAR(r.storey[1].peak, drift, 5e-3 * drift);
  EXPECT_NEAR(r.storey[1].residual, drift, 5e-3 * drift);
  EXPECT_LT(r.storey[0].peak, 1e-3 * drift);
  const ShakeHistory& h = s.result.history;
  EXPECT_NEAR(storey_drift(h, h.row.size() - 1, 1).first, -drift, 5e-3 * drift);
  // halfway through the pulse: (a - mu g) t^2 / 2
  for (std::size_t k = 0; k < h.row.size() && h.row[k].time < 0.2; ++k)
    EXPECT_NEAR(storey_drift(h, k, 1).first,
                -0.5 * (4 - 0.2 * kG) * h.row[k].time * h.row[k].time / 0.1, 5e-3 * drift);
  // it rests as soon as friction has brought it to the base's speed, after a T / (mu g)
  for (std::size_t k = 0; k < h.row.size(); ++k) {
    if (h.row[k].time < 4 * 0.2 / (0.2 * kG)) continue;
    EXPECT_NEAR(storey_drift(h, k, 1).first, -drift, 5e-3 * drift);
  }
}

}  // namespace
}  // namespace wythe::verification::shaking_test
