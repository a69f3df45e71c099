// Motion: sliding, free vibration, the stability limit and local damping (CF02, CF03, CF07, CF08).
#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "scenes/rig.h"
#include "scenes/scenes.h"
#include "verification/record.h"

namespace wythe::verification::motion_test {
namespace {

using scenes::degrees;
using scenes::Rig;

constexpr double kGravity = 9.81;

// 100 kg, 2 m long and 0.05 m high: friction at its base can't lift an end.
Model sledge(double friction) {
  ModelSpec spec = scenes::block_on_ground(
      2.0, 0.05, scenes::dry_joint(10e9, 4e9, std::atan(friction)), 0.1, 1e4);
  return compile(spec);
}

// At rest under gravity normal to the ground and `along` it (by a smooth start), then undamped.
void lay_down(Rig& rig, double normal, double along) {
  rig.state.gravity_y = -normal;
  rig.settle(1e-6);
  for (int k = 1; k <= 2000; ++k) {
    rig.state.gravity_x = along * k / 2000;
    rig.step();
  }
  rig.settle(1e-9);
  rig.controls.damping = 0;
}

struct Slide {
  double acceleration, displacement;
};

Slide slide_one_second() {
  Rig rig(sledge(0.6));
  const double slope = degrees(35);
  // held by friction up to 0.999 of its limit, so that the springs give no push at the start
  lay_down(rig, kGravity * std::cos(slope), 0.999 * 0.6 * kGravity * std::cos(slope));
  rig.state.gravity_x = kGravity * std::sin(slope);
  const double start = rig.state.ux[0];
  rig.controls.dt = 0.5 / std::ceil(0.5 / rig.controls.dt);  // whole steps in half a second
  rig.run(0.5);
  const double half = rig.state.vx[0];
  rig.run(0.5);
  return {(rig.state.vx[0] - half) / 0.5, rig.state.ux[0] - start};
}

TEST(ClosedForm, CF02a_sliding_acceleration) {
  verify({"CF02a", "block on a slope, sliding: acceleration", "m/s^2", 0.8052559, 1e-5,
          "undamped vibration on the springs; the value has 7 digits"},
         slide_one_second().acceleration);
}

TEST(ClosedForm, CF02b_sliding_displacement_after_one_second) {
  verify({"CF02b", "block on a slope: displacement after 1 s from rest", "m", 0.402628, 1e-3,
          "elastic transient at the start, below 1e-4 m/s, and half a step, dt a t/2 = 1e-4"},
         slide_one_second().displacement);
}

struct Stop {
  double distance, time;
};

Stop stop_on_table() {
  Rig rig(sledge(0.5));
  lay_down(rig, kGravity, 0);
  const double start = rig.state.ux[0], began = rig.state.time;
  rig.state.vx[0] = 2;
  while (rig.state.vx[0] > 0 && rig.state.time - began < 1) rig.step();
  return {rig.state.ux[0] - start, rig.state.time - began};
}

TEST(ClosedForm, CF03a_stopping_distance) {
  verify({"CF03a", "block with initial speed on a flat table: stopping distance", "m", 0.4077472,
          1e-3, "undamped vibration on the springs at the start and one step, v0 dt"},
         stop_on_table().distance);
}

TEST(ClosedForm, CF03b_stopping_time) {
  verify({"CF03b", "block with initial speed on a flat table: stopping time", "s", 0.4077472, 1e-3,
          "undamped vibration on the springs at the start and one step, dt"},
         stop_on_table().time);
}

// CF07: 20 kg on 0.03 m^2. A tall block, so that its rocking is slower than its axial mode.
constexpr double kOmega = 5477.2255750516614;  // sqrt(20e9 x 0.03 / 20) [1/s]

Model oscillator() {
  ModelSpec spec =
      scenes::block_on_ground(0.1, 0.3, scenes::elastic_joint(20e9, 1e8), 0.3, 20 / 0.009);
  return compile(spec);
}

// Frequency over `cycles` periods of the undamped block, from interpolated zero crossings [Hz].
double axial_frequency(double steps_per_radian, int cycles) {
  Rig rig(oscillator());
  rig.controls.damping = 0;
  rig.controls.dt = 1 / (kOmega * steps_per_radian);
  rig.state.uy[0] = 1e-6;
  double first = -1;
  int crossings = 0;
  while (true) {
    const double before = rig.state.uy[0], t = rig.state.time;
    rig.step();
    const double after = rig.state.uy[0];
    if (!(before > 0 && after <= 0)) continue;
    const double at = t + rig.controls.dt * before / (before - after);
    if (first < 0)
      first = at;
    else if (++crossings == cycles)
      return cycles / (at - first);
  }
}

TEST(ClosedForm, CF07a_axial_frequency) {
  const double exact = 871.7275;
  const double coarse = axial_frequency(10, 20), fine = axial_frequency(20, 20);
  // central differences: omega (1 + (omega dt)^2/24 + ...)
  EXPECT_NEAR(coarse / exact - 1, 0.01 / 24, 0.05 * 0.01 / 24);
  EXPECT_NEAR(std::log2((coarse - exact) / (fine - exact)), 2.0, 0.05);
  verify({"CF07a", "one block on one joint: axial frequency", "Hz", exact, 2e-6,
          "period error (omega dt)^2/24 = 1e-6 at 200 steps a radian"},
         axial_frequency(200, 20));
}

// Largest |u|/u0 over 20 000 steps at a share of the critical step 2/omega.
double growth_at(double share, double damping = 0) {
  Rig rig(oscillator());
  rig.controls.damping = damping;
  rig.controls.dt = share * 2 / kOmega;
  rig.state.uy[0] = 1e-9;
  double largest = 0;
  for (int k = 0; k < 20000 && largest < 1e6; ++k) {
    rig.step();
    largest = std::max(largest, std::fabs(rig.state.uy[0]) / 1e-9);
  }
  return largest;
}

double critical_step(double damping) {
  double stable = 0.5, unstable = 1.1;
  while (unstable - stable > 1e-4) {
    const double middle = 0.5 * (stable + unstable);
    (growth_at(middle, damping) < 1e3 ? stable : unstable) = middle;
  }
  return stable * 2 / kOmega;
}

TEST(ClosedForm, CF07b_critical_time_step) {
  // amplitude of the discrete oscillator just inside the limit: 1/sqrt(1 - share^2) = 7
  EXPECT_LT(growth_at(0.99), 8);
  EXPECT_GE(growth_at(1.01), 1e6);
  verify({"CF07b", "critical time step of central differences", "s", 0.0003651484, 1e-3,
          "bisection to 1e-4; growth is called unstable from 1000 on"},
         critical_step(0));
}

// Near the limit the velocity turns at every step, against a force that local damping makes
// 1 + lambda times as large: an oscillator of sqrt(1 + lambda) omega.
TEST(ClosedForm, critical_time_step_under_local_damping) {
  for (const double damping : {0.2, 0.8}) {
    verify(
        {"damped step", "critical time step, local damping " + std::to_string(damping).substr(0, 3),
         "s", 0.0003651484 / std::sqrt(1 + damping), 1e-3, "as CF07b"},
        critical_step(damping));
  }
}

TEST(ClosedForm, CF07b_model_bound_is_safe_and_close) {
  // one block: only its own stiffness counts and no neighbour's, the bound is its highest mode
  EXPECT_NEAR(oscillator().omega_max, kOmega, 1e-6 * kOmega);
}

TEST(ClosedForm, CF08_local_damping_amplitude_ratio) {
  Rig rig(oscillator());
  rig.controls.damping = 0.8;
  rig.controls.dt = 1 / (kOmega * 500);
  rig.state.uy[0] = 1e-6;
  std::vector<double> peaks{1e-6};
  double before = 0;
  while (peaks.size() < 6) {
    rig.step();
    const double now = rig.state.vy[0];
    if (before != 0 && now * before < 0) peaks.push_back(std::fabs(rig.state.uy[0]));
    before = now;
  }
  for (std::size_t k = 2; k < peaks.size(); ++k)
    EXPECT_NEAR(peaks[k] / peaks[k - 1], 1.0 / 3, 5e-3) << "half cycle " << k;
  verify(
      {"CF08", "local damping 0.8: amplitude ratio per half cycle", "-", 0.3333333, 5e-3,
       "turning points are met within a step: (omega dt)^2 and the first half step, O(omega dt)"},
      peaks[4] / peaks[3]);
}

}  // namespace
}  // namespace wythe::verification::motion_test
